"""A V that is searched for: what is found falls along runs, and nothing is found of what leaves."""

import control
import numpy as np
import pytest
import sympy
from written_systems import written

import clpt_control as clpt
from clpt_control.theory import lyapunov
from clpt_control.theory.proving.theorem_loop import theorem_scenario

SYSTEMS = {  # rates in states, and a state to start from
    "pendulum": ("q' = w; w' = -9.8*sin(q) - 0.1*w", [2.0, 1.0]),
    "Lorenz's equations, r = 1/2": (
        "a' = 10*(b - a); b' = 0.5*a - b - a*c; c' = a*b - 8/3*c",
        [3.0, -2.0, 5.0],
    ),
    "two neurons": ("a' = -a + 0.5*tanh(b); b' = -b - 0.5*tanh(a)", [3.0, -2.0]),
    "a gain that adapts": ("x' = x - k*x; k' = x**2; at k = 2", [1.0, 0.0]),
    "a pendulum that hangs at pi": ("q' = w; w' = 9.8*sin(q) - 0.1*w; at q = pi", [2.0, 1.0]),
    "three masses, all springs hard": (
        "a' = u; b' = v; c' = w; u' = b - 2*a - a**3 - 0.1*u; "
        "v' = a + c - 2*b - b**3 - 0.1*v; w' = b - 2*c - c**3 - 0.1*w",
        [1.0, -1.0, 0.5, 0.0, 2.0, 0.0],
    ),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_what_is_found_is_proved_and_falls_along_a_run_of_python_control(name):
    text, start = SYSTEMS[name]
    own, _, *rest = written(text)
    found = lyapunov(own, **dict(*rest))
    turned = name == "a pendulum that hangs at pi"  # an angle is held up to whole turns
    assert found.status == ("proved but for q" if turned else "proved"), found
    symbols = list(clpt.equations(own).motion)
    V = sympy.lambdify(symbols, found.V)
    t = np.linspace(0, 10, 401)
    run = control.input_output_response(
        own, t, 0, start, solve_ivp_kwargs={"rtol": 1e-10, "atol": 1e-12}
    )
    values = V(*run.states)
    assert np.all(np.diff(values) <= 1e-8 * values[0])
    assert values.min() > -1e-12


@pytest.mark.parametrize("filtered", [False, True])
def test_of_a_model_reference_loop_it_is_the_textbooks(filtered):
    """A filter of the reference, which input alone moves, is not in V."""
    rates = "y' = y + 3*(kr*{0} - ky*y); ym' = -4*ym + 4*{0}; kr' = -2*{0}*(y - ym)"
    more = "; f' = r - f" if filtered else ""
    text = f"{rates}; ky' = 2*y*(y - ym){more}; input r".format("f" if filtered else "r")
    loop, _ = written(text)
    found = lyapunov(loop, at={"kr": 4 / 3, "ky": 5 / 3})
    y, ym, kr, ky, *_ = clpt.equations(loop).motion
    apart = (kr - sympy.Rational(4, 3)) ** 2 + (ky - sympy.Rational(5, 3)) ** 2
    assert found.status == "proved"
    assert sympy.expand(found.V - (y - ym) ** 2 / 2 - sympy.Rational(3, 4) * apart) == 0
    assert sympy.expand(found.rate + 4 * (y - ym) ** 2) == 0


@pytest.mark.parametrize(
    "scenario",
    [
        theorem_scenario(1, "learned-flow"),
        pytest.param(clpt.paper_scenario(), marks=pytest.mark.slow),
    ],
    ids=lambda scenario: f"N = {scenario.basis.N}",
)
def test_of_the_papers_loop_it_is_its_eq_24(scenario):
    loop = clpt.closed_loop(scenario, external="zc")
    theta, gamma = np.array(scenario.flow.parameters), sympy.Rational(str(scenario.learning.gain))
    truth = {f"alpha[{i},{j}]": -theta[i, j] for i in range(2) for j in range(scenario.basis.N)}
    truth |= {f"K[{i}]": gain for i, gain in enumerate(scenario.vehicle.feedback)}
    truth |= {f"Gamma[{i}]": gain for i, gain in enumerate(scenario.vehicle.feedforward)}
    found = lyapunov(loop, at=truth)
    states = {str(s): s for s in clpt.equations(loop).motion}
    errors = [states[f"x[{i}]"] - states[f"z[{i}]"] for i in range(2)]
    apart = [states[name] - sympy.Rational(str(value)) for name, value in truth.items()]
    printed = sum(e**2 for e in errors) / 2 + sum(one**2 for one in apart) / (2 * gamma)
    assert sympy.expand(found.V - printed) == 0
    assert found.status == "proved but for x"


@pytest.mark.parametrize(
    "seed", [0, 1, 2, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(3, 20))]
)
def test_a_stable_linear_system_always_has_one_and_no_other_does(seed):
    random = np.random.default_rng(seed)
    n = int(random.integers(2, 6))
    A = np.round(random.standard_normal((n, n)), 2)
    A -= np.round(np.linalg.eigvals(A).real.max() + 0.3, 2) * np.eye(n)
    none = np.zeros((n, 0)), np.eye(n), np.zeros((n, 0))
    assert lyapunov(control.ss(A, *none)).status == "proved"
    assert lyapunov(control.ss(A + 0.6 * np.eye(n), *none)).status == "open"


FOUND = {  # whether a V is found; of what leaves its rest none is
    "x' = -(1 + t)*x": True,
    "x' = -x*exp(-t)": True,
    "x' = -x*abs(x)": True,
    "x' = -x/(1 + x**2)": True,
    "x' = -(1 - t)*x": False,
    "x' = x*exp(-t)": False,
    "x' = -x*sin(t)": False,
    "x' = x**3": False,
    "x' = -x; y' = y": False,
    "x' = -y; y' = x - (1 - x**2)*y": False,
    "x' = x - k*x; k' = -(x**2)": False,
    "q' = w; w' = 9.8*sin(q) - 0.1*w": False,
    "x' = y; y' = -x + 0.1*y**3": False,
    "x' = -x + 2*x*exp(-1e8*(x - 1)**2)": False,  # no power 1e8 of exp(x) is made
}


@pytest.mark.parametrize("text", FOUND)
def test_of_what_leaves_its_rest_nothing_is_proved(text):
    found = lyapunov(written(text)[0])
    assert (found.status == "proved") is FOUND[text]
    assert found.status in ("open", "proved") or found.status.startswith("proved but for")


MANY = control.ss(-np.eye(17), np.zeros((17, 0)), np.eye(17), np.zeros((17, 0)))


@pytest.mark.parametrize(
    ("plant", "more", "said"),
    [
        ("x' = 1 - x", {}, r"x' = 1 at the rest"),
        ("x' = -1/x", {}, r"x' has no value at the rest"),
        ("x' = -x", {"claim": lambda s: -s.x}, "leave the claim out: it is of a V that is given"),
        (MANY, {}, "has 17 states; a V is searched for of at most 16"),
    ],
)
def test_what_cannot_be_searched_for_is_refused(plant, more, said):
    with pytest.raises(clpt.DiagramError, match=said):
        lyapunov(written(plant)[0] if isinstance(plant, str) else plant, **more)
