"""A diagram on symbols, for its own N and for every N: as its numbers; misuse is refused."""

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from text_systems import written

import clpt_control as clpt
from clpt_control.engine.diagram.interconnection import connect
from clpt_control.engine.model.block import Block
from clpt_control.engine.record.derivative import Direction
from clpt_control.engine.trace.arrays import Tape, Unread
from clpt_control.paper.laws.table import LAWS
from clpt_control.theory.proofs.every_n import SUM, EveryN
from clpt_control.theory.proofs.exact import vanishes
from clpt_control.theory.proofs.point_search import PointSearch
from clpt_control.theory.proofs.same_as_running import compare
from clpt_control.theory.proofs.symbolic_loop import ArrayLoop, symbolic_loop
from clpt_control.theory.proofs.theorem_loop import (
    law_and_V,
    law_loop,
    theorem_loop,
    vanish,
)


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
    slopes = search.slopes.at(search.values(t, x.T, u.T), 20)[1:]
    ahead, behind = (
        search.blocks.by_control(t, x + way * h * along, u)[1] for way in (1, -1)
    )
    wanted, size = (
        np.sum(slopes * along.T, axis=0),
        np.sum(np.abs(slopes * along.T), axis=0),
    )
    assert np.all(np.abs((ahead - behind) / (2 * h) - wanted) < 1e-6 * size)


@pytest.mark.parametrize(("far", "told"), [(1e20, True), (1e90, False)])
def test_points_at_which_numbers_say_nothing_show_nothing(far, told):
    """x' = -x^3, beyond 1e100 as well as below."""
    block = written("x' = -(x**3)")[0]
    eq = clpt.equations(block)
    (own,) = eq.motion
    search = PointSearch(block, eq, own**2 / 2, "", {}, 0)
    at = np.zeros(10), np.full((1, 10), far), np.zeros((0, 10))
    assert compare(search, at, 10)[0] == told


def test_symbols_have_the_papers_names():
    """Two values of one name are two symbols."""
    law = LAWS["learned-flow"].of(2, gain=0.123)
    candidate = theorem_loop(2, "learned-flow").syslist[-1]
    loop = symbolic_loop(
        theorem_loop(2, "learned-flow", law_block=law, candidate=candidate)
    )
    of = loop.parameters
    for symbol, name in (
        (of["adaptation"].gain, "adaptation.gain"),
        (of["lyapunov"].gain_K[0], "lyapunov.gain_K[1]"),
        (of["true_flow"].theta[0, 1], "theta_1[2]"),
        (loop.states["alpha"][1, 0], "alpha_2[1]"),
        (loop.signals["e"][1], "x_2 - z_2"),
        (loop.inputs["phi_x"][1].func, "phi_x[2]"),
    ):
        assert str(symbol) == name


x, y, z = sympy.symbols("x y z", real=True)
f, d = sympy.Function("f")(x), 1 + x**2

HIDDEN = (x + y) ** 2 - x**2 - 2 * x * y - y**2
VANISHES = [
    HIDDEN,
    1 / (1 + 1 / d) - d / (d + 1),
    x / d**3 + 1 / d**2 - (x + d) / d**3,
    f * (y + 1 / f) - 1 - y * f,
    sympy.sqrt(d) ** 3 / sympy.sqrt(d) - d,
    0.5 * x - x / 2,
    (x**2 - y**2) / (x - y) - x - y,
]
DOES_NOT = [
    1 / (1 + 1 / d) - d / (d + 2),
    f - sympy.Function("g")(x),
    sympy.sqrt(d) - d,
    1 / x,
    z / HIDDEN,  # divided by what is zero
    z / (1 / x + 1 / y - (x + y) / (x * y)),
]


@pytest.mark.parametrize("expression", VANISHES + DOES_NOT, ids=str)
def test_what_is_zero_vanishes_and_nothing_else(expression):
    assert vanishes(expression) is (expression in VANISHES)


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
    leaves = {
        name: tape.add("leaf", (), shape, ("u", name)) for name, shape in shapes.items()
    }

    def named(at, shape, index):
        return sympy.Symbol(at[1] + "".join(f"[{k}]" for k in index), real=True)

    return EveryN(tape.operations, named), leaves, tape


def of_numbers(expression, values, N):
    """An expression's number, its sums written out."""

    def numbers(one, places):
        if one.func == SUM:
            body, *pairs = one.args
            names = [str(k) for k in pairs[::2]]
            each = (
                dict(zip(names, at, strict=True))
                for at in np.ndindex(*[N] * len(names))
            )
            return sum(numbers(body, places | at) for at in each)
        if one.is_Symbol:
            name, *index = str(one).replace("]", "").split("[")
            return values[name][
                tuple(places[k] if k in places else int(k) for k in index)
            ]
        if one.is_number:
            return float(one)
        return float(one.func(*(sympy.Float(numbers(a, places), 30) for a in one.args)))

    return numbers(sympy.sympify(expression), {})


FORMS = {
    "a sum": lambda a, b, P, c: np.sum(c * a + b),
    "a product of sums": lambda a, b, P, c: np.sum(np.outer(a, b)) * np.sum(a),
    "a form": lambda a, b, P, c: a @ P @ b - c * (b @ P.T @ b),
    "the same index twice": lambda a, b, P, c: np.trace(P) + np.sum((P @ a) ** 2),
    "a sum in a function": lambda a, b, P, c: (
        np.exp(-np.sum(a**2)) * a @ b / (1 + b @ b)
    ),
    "a function in a sum": lambda a, b, P, c: np.sum(
        np.tanh(a * c) * np.sqrt(b**2 + 1)
    ),
    "rows and columns": lambda a, b, P, c: (
        np.sum(P * a[:, None] - P.T * b) + np.sum(P @ P.T)
    ),
    "a matrix of sums": lambda a, b, P, c: np.sum(np.exp(P @ a) * b),
}
SHAPES = {"a": ("N",), "b": ("N",), "P": ("N", "N"), "c": ()}


def drawn(shapes, N, seed):
    """A number for each element of leaves."""
    random = np.random.default_rng(seed)
    return {
        name: 0.3 * random.standard_normal([N] * len(shape))
        for name, shape in shapes.items()
    }


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("N", [1, 2, 5])
def test_what_is_read_holds_for_each_N(form, N):
    elements, u, _ = reader(**SHAPES)
    values = drawn(SHAPES, N, seed=N)
    found = of_numbers(elements.of(FORMS[form](**u)), values, N)
    assert found == pytest.approx(float(FORMS[form](**values)), rel=1e-12)


@pytest.mark.parametrize("form", FORMS)
def test_the_derivative_is_that_of_each_N(form):
    shapes = SHAPES | {"d": ("N",)}
    elements, u, tape = reader(**shapes)
    slope = Direction(tape, {u["a"]._ref: u["d"]}).of(
        FORMS[form](*(u[k] for k in "abPc"))
    )
    values, h = drawn(shapes, 3, seed=1), 1e-6
    ahead, behind = (
        FORMS[form](values["a"] + s * values["d"], *(values[k] for k in "bPc"))
        for s in (h, -h)
    )
    found = of_numbers(elements.of(slope), values, 3)
    assert found == pytest.approx((ahead - behind) / (2 * h), rel=1e-7, abs=1e-9)


def own_block(function, N):
    """s' = function(e, phi)."""
    own = {"inputs": {"e": 2, "phi_x": "N"}, "states": {"s": 1}, "sizes": {"N": N}}
    return Block("own", update=lambda t, x, u, p: function(u.e, u.phi_x), **own)


def loop_of(function, claim):
    """s' = function(e, phi) as a diagram, and s' = claim as what is left of it."""
    loop = ArrayLoop(
        connect([own_block(function, 7)], external=["e", "phi_x"], name="own")
    )
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
    "all but the fifth": lambda e, phi: np.sum(
        np.where(np.arange(len(phi)) == 4, -phi, phi)
    ),
}


@pytest.mark.parametrize("function", NOT_ALIKE.values(), ids=NOT_ALIKE)
def test_what_is_not_alike_for_all_functions_is_refused(function):
    with pytest.raises(Unread, match=r"own\.update is not read for every N: .+"):
        loop_of(function, lambda e, phi: np.sum(phi))


def elementary(e, phi):
    """The fourth elementary symmetric polynomial, of power sums: zero for N = 1, 2, 3."""
    a, b, c, d = (np.sum(phi**k) for k in range(1, 5))
    return (a**4 - 6 * a**2 * b + 3 * b**2 + 8 * a * c - 6 * d) / 24


PAIRS, ONES, SHARE = (
    lambda e, phi: np.sum(np.outer(phi, phi)),
    lambda e, phi: np.sum(0 * phi + e[0]),
    lambda e, phi: phi @ phi / (1 + phi @ phi),
)


CLAIMS = [
    (PAIRS, lambda e, phi: np.sum(phi) ** 2, True),
    (PAIRS, lambda e, phi: np.sum(phi**2), False),
    (elementary, lambda e, phi: 0.0, False),
    (ONES, lambda e, phi: e[0], False),
    (ONES, lambda e, phi: e[0] * np.sum(0 * phi + 1), True),
    (
        SHARE,
        lambda e, phi: 1 - 1 / (1 + np.sum(phi**2)),
        True,
    ),  # of a sum, which is an atom
    (SHARE, lambda e, phi: 1 - 1 / (1 + np.sum(phi) ** 2), False),
]


@pytest.mark.parametrize(("function", "claim", "shown"), CLAIMS)
def test_only_what_holds_for_every_N_is_shown(function, claim, shown):
    assert vanish(*loop_of(function, claim))[0] == shown


def test_a_signal_that_is_not_fed_function_by_function_is_refused():
    block = own_block(lambda e, phi: phi @ phi, N=2)
    turn = {
        "output": lambda t, x, u, p: u.e[::-1],
        "outputs": {"phi_x": 2},
        "inputs": {"e": 2},
    }
    diagram = connect([block, Block("turned", **turn)], external=["e"], name="own")
    with pytest.raises(Unread, match=r"own\.phi_x is not fed function by function"):
        ArrayLoop(diagram)
    assert len(symbolic_loop(diagram).rates["s"]) == 1


def test_jumps_have_no_slope_where_V_shall_fall():
    elements, u, tape = reader(a=(2,))
    a = u["a"]
    smooth = Direction(tape, {a._ref: a}, smooth=True)
    for jumping in (np.floor(a), np.sign(a), np.where(a > 0, 1.0, a)):
        with pytest.raises(Unread, match="derivative"):
            smooth.of(np.sum(jumping))
    assert (
        str(elements.of(smooth.of(np.maximum(a, 0.0)))[0])
        == "where(ge(a[0], 0), a[0], 0)"
    )
