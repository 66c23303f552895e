"""A diagram on symbols: as its numbers, for its own N; what vanishes does, misuse is refused."""

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from written import written

import clpt_control as clpt
from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.proving.running_rate import PointSearch
from clpt_control.theory.proving.signs import vanishes
from clpt_control.theory.proving.symbolic_loop import symbolic_loop
from clpt_control.theory.proving.theorem_loop import law_and_V, law_loop, theorem_loop


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
