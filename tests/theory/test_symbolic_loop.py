"""A diagram on symbols: as its numbers, for its own N; misuse is refused."""

import control
import numpy as np
import pytest
import sympy

import clpt_control as clpt
from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.proving.array_loop import TIME
from clpt_control.theory.proving.symbolic_loop import symbolic_loop
from clpt_control.theory.proving.theorem_loop import theorem_loop, theorem_scenario


@pytest.mark.parametrize("N", [1, 2, 4])
@pytest.mark.parametrize("law", ["learned-flow", "known-flow"])
def test_symbols_agree_with_python_control(N, law):
    scenario = theorem_scenario(N, law).with_values({"run.duration": 50})
    diagram = clpt.closed_loop(scenario)
    loop = symbolic_loop(diagram)
    random = np.random.default_rng(N)
    state, t = random.standard_normal(diagram.nstates), 7.3
    places = dict(zip(loop.motion, state, strict=True))
    places[TIME] = t
    for block in diagram.syslist:
        symbols = loop.parameters[block.name]
        for symbol, value in zip(symbols, block.parameters, strict=True):
            if not isinstance(symbol, int):
                places.update(zip(np.ravel(symbol), np.ravel(value), strict=True))
    zc = diagram.output(t, state, [])[:2]
    places.update(zip(loop.signals["zc"], zc, strict=True))
    known = {symbol: sympy.Float(float(value), 30) for symbol, value in places.items()}
    found = [float(rate.xreplace(known).evalf(30)) for rate in loop.motion.values()]
    np.testing.assert_allclose(found, diagram.dynamics(t, state, []), rtol=1e-10, atol=1e-12)


def test_a_linear_part_is_wired_by_its_own_labels():
    plant = control.tf(1, [1, 0], inputs="e", outputs="v", name="plant")
    twice = clpt.Block(
        "twice", output=lambda t, x, u, p: 2 * u.v, inputs={"v": 1}, outputs={"w": 1}
    )
    loop = symbolic_loop(clpt.connect([plant, twice], external="e"))
    ((x, rate),) = loop.motion.items()
    p = loop.parameters["plant"]
    assert loop.signals["w"] == [2 * p.C[0, 0] * x]
    assert rate == p.B[0, 0] * loop.inputs["e"][0]


def test_python_controls_own_systems_are_read():
    plant = control.nlsys(lambda t, x, u, params: -(x**3), inputs=1, states=1, name="plant")
    loop = symbolic_loop(control.interconnect([plant], inplist=["plant.u[0]"], outlist=["plant"]))
    ((x, rate),) = loop.motion.items()
    assert rate == -(x**3)


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
