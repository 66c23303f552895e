"""A diagram on symbols, for its own N and for every N: as its numbers; misuse is refused."""

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from written_systems import written

import clpt_control as clpt
from clpt_control.blocks.laws.table import LAWS
from clpt_control.diagrams.interconnection import connect
from clpt_control.equations.arrays import Tape, Unread
from clpt_control.equations.block import Block
from clpt_control.equations.derivative import Direction
from clpt_control.equations.symbolic import SUM, EveryN
from clpt_control.theory.proving.running_rate import PointSearch
from clpt_control.theory.proving.signs import vanishes
from clpt_control.theory.proving.symbolic_loop import ArrayLoop, symbolic_loop
from clpt_control.theory.proving.theorem_loop import law_and_V, law_loop, theorem_loop, vanish


@pytest.mark.parametrize(
    "law", [law for law in LAWS.values() if not law.at_fixes], ids=lambda law: law.name
)
def test_slopes_of_V_are_those_of_the_running_blocks(law):
    """Each by a difference of V of the blocks' functions."""
    diagram = law_loop(law, *law_and_V(law, 2))
    loop = symbolic_loop(diagram, jumps=True)
    search = PointSearch(diagram, loop, loop.signals["V"][0], "V[0]", {}, 0)
    x, along = search.random.standard_normal((2, 20, diagram.nstates))
    t, u, h = np.zeros(20), search.random.standard_normal((20, diagram.ninputs)), 1e-5
    slopes = search.slopes.at(search.known(t, x.T, u.T), 20)[1:]
    ahead, behind = (search.blocks.by_control(t, x + way * h * along, u)[1] for way in (1, -1))
    wanted, size = np.sum(slopes * along.T, axis=0), np.sum(np.abs(slopes * along.T), axis=0)
    assert np.all(np.abs((ahead - behind) / (2 * h) - wanted) < 1e-6 * size)


@pytest.mark.parametrize(("far", "told"), [(1e20, True), (1e90, False)])
def test_points_at_which_numbers_say_nothing_show_nothing(far, told):
    """x' = -x^3, beyond 1e100 as well as below."""
    block, at = written("x' = -(x**3)")[0], np.full((10, 1), far)
    eq = clpt.equations(block)
    (x,) = eq.motion
    search = PointSearch(block, eq, x**2 / 2, "", {}, 0)
    assert search.compare((np.zeros(10), at.T, np.zeros((0, 10))), 10)[0] == told


def test_two_values_of_one_name_are_two_symbols():
    law = LAWS["learned-flow"].of(2, gain=0.123)
    candidate = theorem_loop(2, "learned-flow").syslist[-1]
    loop = symbolic_loop(theorem_loop(2, "learned-flow", law_block=law, candidate=candidate))
    assert str(loop.parameters["adaptation"].gain) == "adaptation.gain"
    assert str(loop.parameters["lyapunov"].gain_K[0]) == "lyapunov.gain_K[1]"


def test_symbols_have_the_papers_names():
    loop = symbolic_loop(theorem_loop(2, "learned-flow"))
    assert str(loop.parameters["true_flow"].theta[0, 1]) == "theta_1[2]"
    assert str(loop.states["alpha"][1, 0]) == "alpha_2[1]"
    assert str(loop.signals["e"][1]) == "x_2 - z_2"
    assert str(loop.inputs["phi_x"][1].func) == "phi_x[2]"


x, y, z = sympy.symbols("x y z", real=True)
f = sympy.Function("f")(x)
d = 1 + x**2

HIDDEN = (x + y) ** 2 - x**2 - 2 * x * y - y**2
VANISHES = {
    sympy.Integer(0): True,
    HIDDEN: True,
    1 / (1 + 1 / d) - d / (d + 1): True,
    x / d**3 + 1 / d**2 - (x + d) / d**3: True,
    f * (y + 1 / f) - 1 - y * f: True,
    sympy.sqrt(d) ** 3 / sympy.sqrt(d) - d: True,
    0.5 * x - x / 2: True,
    (x**2 - y**2) / (x - y) - x - y: True,
    sympy.Integer(1): False,
    (x + y) ** 2 - x**2 - y**2: False,
    1 / (1 + 1 / d) - d / (d + 2): False,
    f - sympy.Function("g")(x): False,
    sympy.sqrt(d) - d: False,
    1 / x: False,
    z / HIDDEN: False,  # divided by what is zero
    z / (1 / x + 1 / y - (x + y) / (x * y)): False,
}


@pytest.mark.parametrize("expression", VANISHES, ids=str)
def test_what_is_zero_vanishes_and_nothing_else(expression):
    assert vanishes(expression) is VANISHES[expression]


SIMPLE = st.sampled_from([x, y, z, sympy.Integer(2), sympy.Rational(-1, 3)])
EXPRESSIONS = st.recursive(
    SIMPLE,
    lambda own: st.one_of(
        st.builds(sympy.Add, own, own),
        st.builds(sympy.Mul, own, own),
        st.builds(lambda a: 1 / (a**2 + 1), own),
    ),
    max_leaves=6,
)


@settings(max_examples=60, derandomize=True, deadline=None)
@given(EXPRESSIONS, EXPRESSIONS)
def test_it_says_what_cancelling_says(one, other):
    assert vanishes(one - sympy.expand(one))
    assert vanishes(one - other) == (sympy.cancel(sympy.together(one - other)) == 0)


def reader(**shapes):
    """Leaves of these shapes on one tape, and their elements."""
    tape = Tape()
    leaves = {name: tape.add("leaf", (), shape, ("u", name)) for name, shape in shapes.items()}

    def named(at, shape, index):
        return sympy.Symbol(at[1] + "".join(f"[{k}]" for k in index), real=True)

    elements = EveryN(tape.operations, named)
    elements.tape = tape
    return elements, leaves


def of_numbers(expression, values, N):
    """An expression's number, its sums written out."""

    def numbers(one, places):
        if one.func == SUM:
            body, *pairs = one.args
            names = [str(k) for k in pairs[::2]]
            each = np.ndindex(*[N] * len(names))
            return sum(
                numbers(body, {**places, **dict(zip(names, at, strict=True))}) for at in each
            )
        if one.is_Symbol:
            name, *index = str(one).replace("]", "").split("[")
            return values[name][tuple(places[k] if k in places else int(k) for k in index)]
        if one.is_number:
            return float(one)
        return float(one.func(*(sympy.Float(numbers(a, places), 30) for a in one.args)))

    return numbers(sympy.sympify(expression), {})


FORMS = {
    "a sum": lambda a, b, P, c: np.sum(c * a + b),
    "a product of sums": lambda a, b, P, c: np.sum(np.outer(a, b)) * np.sum(a),
    "a form": lambda a, b, P, c: a @ P @ b - c * (b @ P.T @ b),
    "the same index twice": lambda a, b, P, c: np.trace(P) + np.sum((P @ a) ** 2),
    "a sum in a function": lambda a, b, P, c: np.exp(-np.sum(a**2)) * a @ b / (1 + b @ b),
    "a function in a sum": lambda a, b, P, c: np.sum(np.tanh(a * c) * np.sqrt(b**2 + 1)),
    "rows and columns": lambda a, b, P, c: np.sum(P * a[:, None] - P.T * b) + np.sum(P @ P.T),
    "a matrix of sums": lambda a, b, P, c: np.sum(np.exp(P @ a) * b),
}


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("N", [1, 2, 5])
def test_what_is_read_holds_for_each_N(form, N):
    elements, u = reader(a=("N",), b=("N",), P=("N", "N"), c=())
    random = np.random.default_rng(N)
    values = {k: 0.3 * random.standard_normal([N] * len(v.shape)) for k, v in u.items()}
    found = of_numbers(elements.of(FORMS[form](**u)), values, N)
    assert found == pytest.approx(float(FORMS[form](**values)), rel=1e-12)


@pytest.mark.parametrize("form", FORMS)
def test_the_derivative_is_that_of_each_N(form):
    elements, u = reader(a=("N",), b=("N",), P=("N", "N"), c=(), d=("N",))
    direction = Direction(elements.tape, {u["a"]._ref: u["d"]})
    slope = direction.of(FORMS[form](*(u[k] for k in "abPc")))
    random, h = np.random.default_rng(1), 1e-6
    values = {k: 0.3 * random.standard_normal([3] * len(v.shape)) for k, v in u.items()}
    ahead, behind = (
        FORMS[form](values["a"] + s * values["d"], *(values[k] for k in "bPc")) for s in (h, -h)
    )
    found = of_numbers(elements.of(slope), values, 3)
    assert found == pytest.approx((ahead - behind) / (2 * h), rel=1e-7, abs=1e-9)


def own_block(function, N):
    """s' = function(e, phi)."""
    return Block(
        "own",
        update=lambda t, x, u, p: {"s": function(u.e, u.phi_x)},
        inputs={"e": 2, "phi_x": "N"},
        states={"s": 1},
        sizes={"N": N},
    )


def loop_of(function, claim):
    """s' = function(e, phi) as a diagram, and s' = claim as what is left of it."""
    loop = ArrayLoop(connect([own_block(function, 7)], external=["e", "phi_x"], name="own"))
    return loop, [loop.rates["s"][0] - claim(loop.inputs["e"], loop.inputs["phi_x"])]


def behind_the_loop(e, phi):
    """sum phi_k + phi_N by the index that the loop leaves."""
    total = 0.0
    for k in range(len(phi)):
        total += phi[k]
    return total + phi[k]


NOT_ALIKE = {
    "phi_N": lambda e, phi: phi[-1],
    "phi_1": lambda e, phi: phi[0],
    "sum phi_k phi_(k-1)": lambda e, phi: np.sum(phi[1:] * phi[:-1]),
    "sum phi_k phi_(k+1), around the end": lambda e, phi: np.sum(phi * np.roll(phi, 1)),
    "sum j phi_j, j counted": lambda e, phi: sum(j * one for j, one in enumerate(phi)),
    "sum k phi_k": lambda e, phi: np.arange(len(phi)) @ phi,
    "behind the loop": behind_the_loop,
    "product of phi_k": lambda e, phi: np.prod(phi),
    "(sum phi_k)/N": lambda e, phi: np.mean(phi),
    "all but the fifth": lambda e, phi: np.sum(np.where(np.arange(len(phi)) == 4, -phi, phi)),
}


@pytest.mark.parametrize("function", NOT_ALIKE.values(), ids=NOT_ALIKE)
def test_what_is_not_alike_for_all_functions_is_refused(function):
    with pytest.raises(Unread, match=r"own\.update is not read for every N: .+"):
        loop_of(function, lambda e, phi: np.sum(phi))


def elementary(e, phi):
    """The fourth elementary symmetric polynomial, of power sums: zero for N = 1, 2, 3."""
    p = [np.sum(phi**k) for k in range(1, 5)]
    first, second, third, fourth = p
    whole = first**4 - 6 * first**2 * second + 3 * second**2 + 8 * first * third - 6 * fourth
    return whole / 24


def pairs(e, phi):
    return np.sum(np.outer(phi, phi))


def ones(e, phi):
    return np.sum(0 * phi + e[0])


def share(e, phi):
    return phi @ phi / (1 + phi @ phi)


@pytest.mark.parametrize(
    ("function", "claim", "shown"),
    [
        (pairs, lambda e, phi: np.sum(phi) ** 2, True),
        (pairs, lambda e, phi: np.sum(phi**2), False),
        (elementary, lambda e, phi: 0.0, False),
        (ones, lambda e, phi: e[0], False),
        (ones, lambda e, phi: e[0] * np.sum(0 * phi + 1), True),
        (share, lambda e, phi: 1 - 1 / (1 + np.sum(phi**2)), True),  # of a sum, which is an atom
        (share, lambda e, phi: 1 - 1 / (1 + np.sum(phi) ** 2), False),
    ],
)
def test_only_what_holds_for_every_N_is_shown(function, claim, shown):
    assert vanish(*loop_of(function, claim))[0] == shown


def test_a_signal_that_is_not_fed_function_by_function_is_refused():
    block = own_block(lambda e, phi: phi @ phi, N=2)
    turn = {"output": lambda t, x, u, p: {"phi_x": u.e[::-1]}, "outputs": {"phi_x": 2}}
    turned = Block("turned", inputs={"e": 2}, **turn)
    diagram = connect([block, turned], external=["e"], name="own")
    with pytest.raises(Unread, match=r"own\.phi_x is not fed function by function"):
        ArrayLoop(diagram)
    assert len(symbolic_loop(diagram).rates["s"]) == 1


def test_jumps_have_no_slope_where_V_shall_fall():
    elements, u = reader(a=(2,))
    smooth = Direction(elements.tape, {u["a"]._ref: u["a"]}, smooth=True)
    for jumping in (np.floor(u["a"]), np.sign(u["a"]), np.where(u["a"] > 0, 1.0, u["a"])):
        with pytest.raises(Unread, match="derivative"):
            smooth.of(np.sum(jumping))
    kinked = smooth.of(np.maximum(u["a"], 0.0))
    assert str(elements.of(kinked)[0]) == "where(ge(a[0], 0), a[0], 0)"
