"""A diagram on symbols: as its numbers, for every N as for each N; misuse is refused."""

from typing import NamedTuple

import numpy as np
import pytest
import sympy

import clpt_control as clpt
from clpt_control.blocks.laws.learned_flow import LearnedFlowParameters, learned_flow_law
from clpt_control.blocks.words import where
from clpt_control.errors import BlockError, DiagramError
from clpt_control.theory.proving.every_n_function import read_function
from clpt_control.theory.proving.every_n_loop import element_symbol, every_n_loop
from clpt_control.theory.proving.every_n_signals import Size, Summed, port_size
from clpt_control.theory.proving.lyapunov import every_n_terms
from clpt_control.theory.proving.symbolic_loop import TIME, symbolic_loop
from clpt_control.theory.proving.theorem_loop import theorem_loop, theorem_scenario


@pytest.mark.parametrize("N", [1, 2, 4])
@pytest.mark.parametrize("law", ["learned-flow", "known-flow"])
def test_symbols_agree_with_python_control(N, law):
    scenario = theorem_scenario(N, law).with_values({"run.duration": 50})
    diagram = clpt.closed_loop(scenario)
    loop = symbolic_loop(diagram)
    random = np.random.default_rng(N)
    state, t = random.standard_normal(diagram.nstates), 7.3
    places = dict(zip([s for v in loop.states.values() for s in v], state, strict=True))
    places[TIME] = t
    for block in diagram.syslist:
        symbols = loop.parameters[block.name]
        for symbol, value in zip(symbols, block.parameters, strict=True):
            if not isinstance(symbol, int):
                places.update(zip(np.ravel(symbol), np.ravel(value), strict=True))
    zc = diagram.output(t, state, [])[:2]
    places.update(zip(loop.signals["zc"], zc, strict=True))
    rates = [rate for port in loop.rates.values() for rate in port]
    found = [float(rate.subs(places).evalf(30)) for rate in rates]
    np.testing.assert_allclose(found, diagram.dynamics(t, state, []), rtol=1e-10, atol=1e-12)


@pytest.mark.parametrize("law", ["learned-flow", "known-flow"])
@pytest.mark.parametrize("N", [1, 3])
def test_every_N_agrees_with_each_N(law, N):
    every, one = every_n_loop(theorem_loop(3, law)), symbolic_loop(theorem_loop(N, law))

    def summed(value):
        """Sum over k, with the names of the loop for one N."""
        total = value.base
        for k in range(N):
            named = {
                s: sympy.Symbol(s.name.replace("[k]", f"[{k + 1}]"), **s.assumptions0)
                for s in value.term.free_symbols
            }
            total += value.term.subs(named)
        return total

    def plain(expression):
        """Name signals that are functions of time as symbols."""
        functions = expression.atoms(sympy.core.function.AppliedUndef)
        return expression.subs({f: sympy.Symbol(str(f.func), real=True) for f in functions})

    for port in ("x", "z", "K", "Gamma"):
        for i in range(2):
            rest = summed(every.rates[port, None, i]) - plain(one.rates[port][i])
            assert sympy.expand(rest) == 0
    assert sympy.expand(summed(every.signals["V", None, 0]) - one.signals["V"][0]) == 0


class LawParameters(NamedTuple):
    N: int
    gain: float


def square_of_a_sum(t, x, u, p, dx):
    """theta' = (sum e phi)^2, section III: u = e[2], phi_x[N]; state s[1]."""
    total = 0.0
    for k in range(p.N):
        total += u[0] * u[2 + k]
    dx[0] = total**2


def sum_of_squares(t, x, u, p, dx):
    """theta' = sum (e phi)^2, section III: u = e[2], phi_x[N]; state s[1]."""
    total = 0.0
    for k in range(p.N):
        total += (u[0] * u[2 + k]) ** 2
    dx[0] = total


def reading(function, states=None):
    states = states or {"s": 1}
    block = clpt.Block(
        "own",
        update=function,
        inputs={"e": 2, "phi_x": 7},
        states=states,
        parameters=LawParameters(7, 0.8),
    )
    out = {port: port_size(port, size, 7) for port, size in states.items()}
    sizes = {"x": out, "u": {"e": Size(0, 2), "phi_x": Size(1, 0)}, "out": out}

    def leaf(name, *where):
        if name == "u":
            symbol = element_symbol(*where[0])
            return symbol if where[0][1] is not None else Summed(symbol)
        return sympy.Symbol(str((name, *where)), real=True)

    return read_function(block, "update", sizes, leaf, warn=[].append)


def test_nonlinear_use_of_a_sum_is_refused():
    with pytest.raises(BlockError, match=r"a product of two sums over k = 1 \.\.\. N"):
        reading(square_of_a_sum)


def test_a_sum_of_nonlinear_terms_is_read():
    found = reading(sum_of_squares)["s", None, 0]
    phi, e = element_symbol("phi_x", 0), element_symbol("e", None, 0)
    assert found.base == 0
    assert sympy.expand(found.term - e**2 * phi**2) == 0


def the_last_one(t, x, u, p, dx):
    """s' = phi_N, section III."""
    last = 0.0
    for k in range(p.N):
        last = u[2 + k]
    dx[0] = last


def the_one_before(t, x, u, p, dx):
    """s' = sum phi_k phi_(k-1), section III."""
    before, total = 0.0, 0.0
    for k in range(p.N):
        total += before * u[2 + k]
        before = u[2 + k]
    dx[0] = total


def a_count(t, x, u, p, dx):
    """s' = sum of j phi_k, j counted, section III."""
    j, total = 0, 0.0
    for k in range(p.N):
        total += j * u[2 + k]
        j = j + 1
    dx[0] = total


def behind_the_loop(t, x, u, p, dx):
    """s' = sum phi_k + phi_N by the index that the loop leaves, section III."""
    total = 0.0
    for k in range(p.N):
        total += u[2 + k]
    dx[0] = total + u[2 + k]


def one_of_N(t, x, u, p, dx):
    """s' = phi_1, section III."""
    dx[0] = u[2]


def neighbours(t, x, u, p, dx):
    """s' = sum phi_k phi_(k+1), section III: reads outside for the last."""
    total = 0.0
    for k in range(p.N):
        total += u[1 + k] * u[2 + k]
    dx[0] = total


def pairs(t, x, u, p, dx):
    """s' = sum phi_k phi_l, section III."""
    total = 0.0
    for k in range(p.N):
        for j in range(p.N):
            total += u[2 + k] * u[2 + j]
    dx[0] = total


def product(t, x, u, p, dx):
    """s' = product of phi_k, section III."""
    total = 1.0
    for k in range(p.N):
        total *= u[2 + k]
    dx[0] = total


def weighed(t, x, u, p, dx):
    """s' = sum k phi_k, section III."""
    total = 0.0
    for k in range(p.N):
        total += k * u[2 + k]
    dx[0] = total


def by_number(t, x, u, p, dx):
    """s' = (sum phi_k)/N, section III."""
    total = 0.0
    for k in range(p.N):
        total += u[2 + k] / p.N
    dx[0] = total


def by_fives(t, x, u, p, dx):
    """s' = sum phi_k but for the fifth, section III."""
    total = 0.0
    for k in range(p.N):
        total += where(k == 4, -1.0, 1.0) * u[2 + k]
    dx[0] = total


def by_length(t, x, u, p, dx):
    """s' = sum phi_k, counted by the inputs' number, section III."""
    total = 0.0
    for k in range(len(u) - 2):
        total += u[2 + k]
    dx[0] = total


NOT_ALIKE = [
    the_last_one,
    the_one_before,
    a_count,
    behind_the_loop,
    one_of_N,
    neighbours,
    pairs,
    product,
    weighed,
    by_number,
    by_fives,
]


@pytest.mark.parametrize("function", NOT_ALIKE, ids=lambda f: f.__name__)
def test_what_is_not_a_sum_alike_for_all_functions_is_refused(function):
    with pytest.raises(BlockError, match=r"own\.update is not read for every N: "):
        reading(function)


def test_the_number_of_inputs_grows_with_N():
    found = reading(by_length)["s", None, 0]
    assert found == Summed(sympy.Integer(0), element_symbol("phi_x", 0))


def row_by_row(t, x, u, p, dx):
    """alpha' = -e phi with a slice, a helper's sum and a constant row, section III."""
    n = p.N
    phi = u[2 : 2 + n]
    for k in range(n):
        dx[k] = -p.gain * u[0] * phi[k]
    for k in range(n):
        dx[n + k] = 0.5


def test_rows_are_read():
    found = reading(row_by_row, {"alpha": 14})
    assert found["alpha", 1, None] == sympy.Rational(1, 2)
    phi, e = element_symbol("phi_x", 0), element_symbol("e", None, 0)
    assert sympy.simplify(found["alpha", 0, None] / (phi * e)).free_symbols == {
        sympy.Symbol("('p', 'gain', ())", real=True)
    }


def test_products_of_two_sums_are_refused():
    k = sympy.Symbol("a[k]")
    with pytest.raises(BlockError, match="product of two sums"):
        Summed(sympy.Integer(1), k).times(Summed(sympy.Integer(0), k))


@pytest.mark.parametrize(
    ("port", "size", "N", "wanted"),
    [
        ("alpha", 6, 3, Size(2, 0)),
        ("eta", 10, 3, Size(2, 4)),
        ("e", 2, 2, Size(0, 2)),
        ("mine", 15, 7, Size(0, 15)),
        ("phi_x", 2, 2, Size(1, 0)),
    ],
)
def test_sizes_of_ports(port, size, N, wanted):
    assert port_size(port, size, N) == wanted


def test_a_plain_system_cannot_be_read():
    import control

    plant = control.NonlinearIOSystem(
        lambda t, x, u, params: -(x**3), None, inputs=1, outputs=1, states=1, name="plant"
    )
    diagram = control.interconnect([plant], inplist=["plant.u[0]"], outlist=["plant.y[0]"])
    with pytest.raises(DiagramError, match="plant is no block"):
        symbolic_loop(diagram)


def test_a_port_that_does_not_go_with_N_is_refused():
    with pytest.raises(BlockError, match="alpha has 7 signals, which does not go with N = 3"):
        port_size("alpha", 7, 3)


def test_two_values_of_one_name_are_two_symbols():
    law = learned_flow_law(LearnedFlowParameters(2, 0.123))
    candidate = theorem_loop(2, "learned-flow").syslist[-1]
    loop = symbolic_loop(theorem_loop(2, "learned-flow", law_block=law, candidate=candidate))
    assert str(loop.parameters["adaptation"].gain) == "adaptation.gain"
    assert str(loop.parameters["lyapunov"].gain_K[0]) == "lyapunov.gain_K[1]"


def test_terms_speak_the_papers_symbols():
    terms = every_n_terms(every_n_loop(theorem_loop(2, "learned-flow")))
    assert str(terms.theta(0, None)) == "theta_1[k]"
    assert str(terms.e(1)) == "x_2 - z_2"
