"""A diagram's equations on symbols: what python-control computes, under its own names."""

import random
import re

import control
import numpy as np
import pytest
import sympy
from error_sentences import says

import clpt_control as clpt

PENDULUM = clpt.Block(
    "pendulum",
    update=lambda t, x, u, p: [
        x.omega,
        -(p.w[0] ** 2) * np.sin(x.theta) - p.w[1] * x.omega,
    ],
    **{"states": {"theta": 1, "omega": 1}, "parameters": {"w": [2.0, 0.1]}},
)


def plant_of(rate, **params):
    """A system of one state, which is its output."""
    ports = {"inputs": "u", "outputs": "y", "states": "y", "name": "plant"}
    return control.nlsys(rate, params=params, **ports)


def test_a_function_of_python_control():
    plant = plant_of(lambda t, x, u, params: -params["am"] * x[0] + u[0], am=2.0)
    eq = clpt.equations(plant)
    assert str(eq) == "y' = -am*y + u(t)"
    assert str(eq.derivative(eq["y"] ** 2)) == "2*y*(-am*y + u(t))"
    assert eq.derivative("y") == eq.rates["y"][0]
    assert eq["am"].is_positive
    assert str(clpt.equations(plant, numbers=True)) == "y' = -2*y + u(t)"
    lines = r"\begin{aligned}\dot{y} &= - \mathrm{am}\,y + u\end{aligned}"
    assert eq._repr_latex_() == rf"$\displaystyle{lines}$"
    assert eq._repr_latex_() == f"$\\displaystyle{eq.latex()}$"
    indexed = clpt.equations(control.ss(-np.eye(2), [[1], [0]], [1, 0], 0, name="a"))
    assert r"{\dot{x}}_{1} &= - {x}_{1}" in indexed.latex()  # over the letter alone
    steps = [control.ss(0.5, 1, 1, 0, 0.1, states=["x"], name=name) for name in "ab"]
    links = [["a.u[0]", "b.y[0]"], ["b.u[0]", "a.y[0]"]]
    pair = control.interconnect(steps, links, inplist=["a.u[0]"], outlist=["a.y[0]"])
    assert r"{x^{\mathrm{a}}}^{+}" in clpt.equations(pair).latex()  # one superscript
    rate = lambda t, x, u, p: [-p["lam"] * x[0] - p["lamp"]]  # noqa: E731
    lit = control.nlsys(rate, states=["q"], inputs=0, params={"lam": 1.0, "lamp": 2.0})
    assert r"- \lambda\,q - \mathrm{lamp}" in clpt.equations(lit).latex()
    arrays = clpt.equations(PENDULUM)
    assert [str(s) for s in arrays["w"]] == ["w[0]", "w[1]"]
    assert r"\dot{\theta} &= \omega" in arrays._repr_latex_()


def test_one_name_of_two_has_its_block_before_it():
    rate = lambda t, x, u, params: -params["k"] * x[0] ** 3 + u[0]  # noqa: E731
    sizes = {"inputs": 1, "outputs": 1, "states": 1, "params": {"k": 2.0}}
    blocks = [control.nlsys(rate, name=name, **sizes) for name in "ab"]
    links = [["a.u[0]", "b.y[0]"], ["b.u[0]", "-a.y[0]"]]
    both = control.interconnect(blocks, links, inplist=["a.u[0]"], outlist=["b.y[0]"])
    eq = clpt.equations(both)
    assert [str(s) for s in eq.motion] == ["a.x", "b.x"]
    assert str(eq["k"]) == "k"  # python-control hands one value down to both
    assert r"x^{\mathrm{a}}" in eq._repr_latex_()
    with pytest.raises(clpt.DiagramError, match=r"has no 'x'; it has .*a\.x"):
        eq["x"]


def test_a_state_behind_an_output_of_its_name_has_its_block_before_it():
    """Two blocks of a state x and an output x, which is 2 x + 1."""

    def offset(name):
        functions = (lambda t, x, u, p: -x, lambda t, x, u, p: 2 * x + 1)
        return control.nlsys(*functions, inputs="u", states="x", outputs="x", name=name)

    named = lambda t, x, u, p: {"k": p.k - x.k}  # noqa: E731
    plant = clpt.Block("plant", update=named, states={"k": 1}, parameters={"k": 0.0})
    assert repr(clpt.equations(plant)) == "plant.k' = -plant.k + plant.parameter.k"
    one = clpt.equations(offset("plant"))
    assert repr(one) == "plant.x' = -plant.x\nx = 2*plant.x + 1"
    links, blocks = [["b.u", "a.x"]], [offset("a"), offset("b")]
    both = clpt.equations(
        control.interconnect(blocks, links, inplist=["a.u"], outlist=["b.x"])
    )
    assert both["b.x"] == 2 * both["b.state.x"] + 1


ERROR = control.summing_junction(["r", "-y"], "e", name="error")
PLANT = control.tf([1, 3], [1, 2, 0], inputs="e", outputs="y", name="plant")
SYSTEMS = {
    "the paper's loop with places given": clpt.closed_loop(
        clpt.paper_scenario(), external="zc"
    ),
    "transfer functions": clpt.connect([ERROR, PLANT], external="r"),
    "a pendulum": control.interconnect([PENDULUM], outlist=["pendulum"]),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_symbols_are_the_numbers_of_python_control(name):
    diagram, random = SYSTEMS[name], np.random.default_rng(0)
    eq = clpt.equations(diagram, numbers=True)
    x, u = (
        random.standard_normal(diagram.nstates),
        random.standard_normal(diagram.ninputs),
    )
    flat = [*eq.motion, *(s for own in eq.inputs.values() for s in own.flat)]
    known = dict(zip(flat, map(sympy.Float, [*x, *u]), strict=True))
    known[sympy.Symbol("t", real=True)] = sympy.Float(1.5)

    def at(values):
        return [float(sympy.sympify(e).xreplace(known).evalf(20)) for e in values]

    np.testing.assert_allclose(
        at(eq.motion.values()), diagram.dynamics(1.5, x, u), rtol=1e-12
    )
    made = [e for own in eq.signals.values() for e in own.flat]
    np.testing.assert_allclose(at(made), diagram.output(1.5, x, u), rtol=1e-12)


CONSTANTS = {
    0.1: "1/10",
    1 / 3: "1/3",
    0.1 + 0.2: "7500000000000001/25000000000000000",
    1 + 1e-9: "1000000001/1000000000",
}
CONSTANTS |= {
    2**0.5: "14142135623730951/10000000000000000",
    -100 / 7: "-100/7",
    np.inf: "oo",
}


@pytest.mark.parametrize("number", CONSTANTS)
def test_a_constant_is_the_fraction_whose_double_it_is(number):
    block = clpt.Block("b", output=lambda t, x, u, p: number, outputs={"y": 1})
    found = clpt.equations(block)["y"]
    assert str(found) == CONSTANTS[number]
    assert float(found) == number


def test_discrete_time_has_next_states_and_no_derivative():
    eq = clpt.equations(control.ss([[0.5]], [[1.0]], [[1.0]], 0, dt=0.1))
    assert str(eq).splitlines()[0] == "x[0]+ = x[0]/2 + u[0](t)".replace("[0]", "")
    says(clpt.DiagramError, "discrete time", eq.derivative, eq["x"])
    with pytest.raises(
        clpt.DiagramError, match=r"x has several signals. Give one of them"
    ):
        clpt.equations(control.ss(np.eye(2), np.eye(2), np.eye(2), 0)).derivative("x")


def test_jumps_are_shown():
    ports = {"states": {"m": 1}, "parameters": {"interval": -1.0}}
    ports["breakpoints"] = lambda p, t0, t1: np.arange(
        np.floor(t0) + 1, np.floor(t1) + 1
    )
    rate, jump = lambda t, x, u, p: -p.interval * x, lambda t, x, u, p: x / 2
    block = clpt.Block("memory", update=rate, jump=jump, **ports)
    for numbers in (False, True):  # the interval is none: it is counted
        shown = str(clpt.equations(block, numbers=numbers))
        assert shown == "m' = -interval*m\nm+ = m/2"


def test_what_samples_is_printed_by_its_updates():
    rate = lambda t, x, u, p: {"y": u.v - x.y}  # noqa: E731
    law = clpt.Block("held", update=rate, inputs={"v": 1}, states={"y": 1})
    loop = clpt.connect([clpt.Sampled(law, 0.5)], external="v")
    lines = "held.y+ (each 0.5) = held.y/2 + held_v/2\nheld_v+ (each 0.5) = v(t)"
    assert repr(clpt.equations(loop)) == lines


def test_what_cannot_be_traced_is_refused():
    dice = clpt.Block(
        "dice", update=lambda t, x, u, p: x * random.random(), states={"y": 1}
    )
    says(clpt.DiagramError, "dice", clpt.equations, dice)


def test_a_port_may_have_other_signals_inside():
    """s' = a_0 + 2 b + 3 a_1: a port a of two signals is not the first two inputs."""
    rate = lambda t, x, u, p: [u[0] + 2 * u[1] + 3 * u[2]]  # noqa: E731
    for inputs in (["a[0]", "b", "a[1]"], ["c[1]", "c[0]", "d"]):
        plant = control.nlsys(rate, inputs=inputs, states=["s"], outputs=["s"])
        first, second, third = inputs
        terms = f"{first}(t)", f"2*{second}(t)", f"3*{third}(t)"
        left, right = repr(clpt.equations(plant)).split(" = ")
        assert (left, {*right.split(" + ")}) == ("s'", {*terms})
        np.testing.assert_allclose(clpt.linearize(plant).B, [[1.0, 2.0, 3.0]])


def test_equations_too_long_to_read_are_made_and_counted():
    def rate(t, x, u, p):
        M = np.eye(5) + np.outer(np.cos(x), np.cos(x)) + np.outer(np.sin(x), x)
        return -np.linalg.solve(M, x + np.array([p["k"], 0, 0, 0, 0]))

    arm = control.nlsys(
        rate, None, inputs=0, states=5, outputs=5, params={"k": 1.0}, name="arm"
    )
    eq = clpt.equations(arm)
    assert len(repr(eq)) < 1000  # it was without end
    assert re.match(r"x\[0\]' = \(\d+ parts\)\n", repr(eq))
    assert r"\mathrm{(" in eq._repr_latex_()


def test_a_param_whose_value_an_if_asks_is_as_it_is():
    rate = lambda t, x, u, p: [(-1.0 if p["mode"] > 0 else 1.0) * p["k"] * x[0]]  # noqa: E731
    plant = control.nlsys(
        rate, inputs=0, states=["y"], outputs=["y"], params={"k": 2.0, "mode": 1.0}
    )
    equations = clpt.equations(plant)
    assert str(equations) == "y' = -k*y"
    assert equations.pinned == [(plant.name, "mode")]
    assert "with the parameters' values" in str(clpt.lyapunov(plant, lambda s: s.y**2))
