"""Tracing: symbols agree with numbers, every N agrees with each N, misuse is refused."""

from typing import NamedTuple

import numpy as np
import pytest
import sympy

import clpt_control as clpt
from clpt_control.blocks.adaptation import LearnedFlowParameters, adaptation
from clpt_control.errors import BlockError, DiagramError
from clpt_control.theory.generic import K, Size, Summed, generic_size, read_function
from clpt_control.theory.generic_trace import generic_parameters, generic_trace
from clpt_control.theory.lyapunov import PHI, generic_terms, theorem_loop, theorem_scenario
from clpt_control.theory.trace import TIME, trace


@pytest.mark.parametrize("N", [1, 2, 4])
@pytest.mark.parametrize("law", ["learned-flow", "known-flow"])
def test_symbols_agree_with_python_control(N, law):
    scenario = theorem_scenario(N, law).with_values({"run.duration": 50})
    diagram = clpt.closed_loop(scenario)
    loop = trace(diagram)
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
    traced = [rate for rates in loop.rates.values() for rate in rates]
    found = [float(rate.subs(places).evalf(30)) for rate in traced]
    np.testing.assert_allclose(found, diagram.dynamics(t, state, []), rtol=1e-10, atol=1e-12)


@pytest.mark.parametrize("law", ["learned-flow", "known-flow"])
@pytest.mark.parametrize("N", [1, 3])
def test_every_N_agrees_with_each_N(law, N):
    whole = generic_trace(theorem_loop(3, law), PHI)
    one = trace(theorem_loop(N, law), PHI)
    plain = {f: sympy.Symbol(str(f.func), real=True) for v in one.signals.values() for e in v
             for f in e.atoms(sympy.Function)}  # fmt: skip

    def spelled(expression):
        """Sum over k, with the names of the concrete trace."""
        for atom in expression.atoms(sympy.Indexed):
            expression = expression.subs(atom, sympy.Symbol(str(atom), real=True))
        return expression

    def summed(value):
        terms = [value.term.subs(K, k + 1) for k in range(N)]
        return spelled(value.base) + sum(spelled(term) for term in terms)

    def same(given, wanted):
        by_name = {s: sympy.Symbol(s.name, real=True) for s in (given - wanted).free_symbols}
        assert sympy.expand((given - wanted).subs(by_name)) == 0

    for port in ("x", "z", "K", "Gamma"):
        for i in range(2):
            same(summed(whole.rates[(port, None, i)]), one.rates[port][i].subs(plain))
    same(summed(whole.signals[("V", None, 0)]), one.signals["V"][0])


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


def reading(function):
    block = clpt.Block("own", update=function, inputs={"e": 2, "phi_x": 7}, states={"s": 1},
                       parameters=LawParameters(7, 0.8))  # fmt: skip
    sizes = {"states": {"s": Size(0, 1)}, "inputs": {"e": Size(0, 2), "phi_x": Size(1, 0)}}
    return read_function(function, block, generic_parameters(block), sizes, sizes["states"])


def test_nonlinear_use_of_a_sum_is_refused():
    with pytest.raises(BlockError, match="not linear"):
        reading(square_of_a_sum)


def test_a_sum_of_nonlinear_terms_is_read():
    found = reading(sum_of_squares)[("s", None, 0)]
    assert found.base == 0
    phi, e = sympy.IndexedBase("phi_x", real=True)[K], sympy.Symbol("e_1", real=True)
    assert sympy.expand(found.term - e**2 * phi**2) == 0


def test_products_of_two_sums_are_refused():
    k = sympy.IndexedBase("a")[K]
    with pytest.raises(BlockError, match="product of two sums"):
        Summed(sympy.Integer(1), k).times(Summed(sympy.Integer(0), k))


@pytest.mark.parametrize(
    ("port", "size", "N", "wanted"),
    [("alpha", 6, 3, Size(2, 0)), ("eta", 10, 3, Size(2, 4)), ("e", 2, 2, Size(0, 2)),
     ("mine", 15, 7, Size(2, 1)), ("phi_x", 2, 2, Size(1, 0))],
)  # fmt: skip
def test_sizes_of_ports(port, size, N, wanted):
    assert generic_size(port, size, N) == wanted


def test_a_plain_system_cannot_be_traced():
    import control

    diagram = control.interconnect(
        [control.ss(-1, 1, 1, 0, name="plant")], inplist=["plant.u[0]"], outlist=["plant.y[0]"]
    )
    with pytest.raises(DiagramError, match="plant is no block"):
        trace(diagram)


def test_one_symbol_for_two_values_is_refused():
    law = adaptation(LearnedFlowParameters(2, 0.123))
    candidate = theorem_loop(2, "learned-flow").syslist[-1]
    with pytest.raises(DiagramError, match="gain"):
        trace(theorem_loop(2, "learned-flow", law_block=law, candidate=candidate))


def test_terms_speak_the_papers_symbols():
    terms = generic_terms(generic_trace(theorem_loop(2, "learned-flow"), PHI))
    assert str(terms.theta(0, K)) == "theta_1[k]"
    assert str(terms.e(1)) == "x_2 - z_2"
