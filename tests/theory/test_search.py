"""A V that is searched for, and regions from which every run comes to rest."""

import control
import numpy as np
import pytest
import sympy
from error_sentences import says
from small_scenarios import paper_of
from text_systems import NUMPY, written

import clpt_control as clpt
from clpt_control import lyapunov

pytestmark = pytest.mark.long  # by `make test-long`

TURNED = "a pendulum that hangs at pi"
# rates, a state to start from, and what is concluded; the strongest that is true is
# "asymptotically stable" but for pendulums and the gain, which have many rests
SYSTEMS = {
    "pendulum": ("q' = w; w' = -9.8*sin(q) - 0.1*w", [2.0, 1.0], "comes to rest"),
    "Lorenz's equations, r = 1/2": (
        "a' = 10*(b - a); b' = 0.5*a - b - a*c; c' = a*b - 8/3*c", [3.0, -2.0, 5.0],
        "asymptotically stable",
    ),
    "two neurons": (  # |a tanh(b) - b tanh(a)| <= a^2 + b^2
        "a' = -a + 0.5*tanh(b); b' = -b - 0.5*tanh(a)", [3.0, -2.0],
        "asymptotically stable",
    ),
    "a gain that adapts": ("x' = x - k*x; k' = x**2; at k = 2", [1.0, 0.0], "comes to rest"),
    "a pendulum that hangs at pi": (
        "q' = w; w' = 9.8*sin(q) - 0.1*w; at q = pi", [2.0, 1.0], "comes to rest"
    ),
    "three masses, all springs hard": (
        "a' = u; b' = v; c' = w; u' = b - 2*a - a**3 - 0.1*u; "
        "v' = a + c - 2*b - b**3 - 0.1*v; w' = b - 2*c - c**3 - 0.1*w",
        [1.0, -1.0, 0.5, 0.0, 2.0, 0.0],
        "asymptotically stable",
    ),
}  # fmt: skip


LEFT_OUT = pytest.mark.xfail(strict=True, reason="V holds q, and is said not to")


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=LEFT_OUT) if n == TURNED else n for n in SYSTEMS]
)
def test_what_is_found_is_proved_and_falls_along_a_run_of_python_control(name):
    text, start, conclusion = SYSTEMS[name]
    own, _, *rest = written(text)
    found = lyapunov(own, **dict(*rest))
    assert (found.status, found.conclusion) == ("proved", conclusion), found
    assert not found.conditions
    V = sympy.lambdify(list(clpt.equations(own).motion), found.V)
    close, t = {"rtol": 1e-10, "atol": 1e-12}, np.linspace(0, 10, 401)
    values = V(
        *control.input_output_response(own, t, 0, start, solve_ivp_kwargs=close).states
    )
    assert np.all(np.diff(values) <= 1e-8 * values[0])
    assert values.min() > -1e-12


@pytest.mark.parametrize("filtered", [False, True])
def test_of_a_model_reference_loop_it_is_the_textbooks(filtered):
    """A filter of the reference, which input alone moves, is not in V."""
    rates = "y' = y + 3*(kr*{0} - ky*y); ym' = -4*ym + 4*{0}; kr' = -2*{0}*(y - ym)"
    more = "; f' = r - f" if filtered else ""
    text = f"{rates}; ky' = 2*y*(y - ym){more}; input r".format(
        "f" if filtered else "r"
    )
    loop, _ = written(text)
    found = lyapunov(loop, at={"kr": 4 / 3, "ky": 5 / 3})
    y, ym, kr, ky, *_ = clpt.equations(loop).motion
    apart = (kr - sympy.Rational(4, 3)) ** 2 + (ky - sympy.Rational(5, 3)) ** 2
    assert (found.status, found.conclusion) == ("proved", "goes to zero")
    assert {(c.name, c.of) for c in found.conditions} == {
        ("outside V, bounded", "ym, f are" if filtered else "ym is"),
        ("bounded inputs", "r is"),
    }
    assert sympy.expand(found.V - (y - ym) ** 2 / 2 - sympy.Rational(3, 4) * apart) == 0
    assert sympy.expand(found.rate + 4 * (y - ym) ** 2) == 0


@pytest.mark.parametrize(
    "scenario",
    [paper_of(1), pytest.param(clpt.paper_scenario(), marks=pytest.mark.slow)],
    ids=["N = 1", "N = 3"],
)
def test_of_the_papers_loop_it_is_its_eq_24(scenario):
    loop = clpt.closed_loop(scenario, external="zc")
    theta, gamma = (
        np.array(scenario.flow.parameters),
        sympy.Rational(str(scenario.learning.gain)),
    )
    truth = {f"alpha[{i},{j}]": -value for (i, j), value in np.ndenumerate(theta)}
    for port in ("feedback", "feedforward"):
        name = {"feedback": "K", "feedforward": "Gamma"}[port]
        truth |= {
            f"{name}[{i}]": g for i, g in enumerate(getattr(scenario.vehicle, port))
        }
    found = lyapunov(loop, at=truth)
    states = {str(s): s for s in clpt.equations(loop).motion}
    errors = [states[f"x[{i}]"] - states[f"z[{i}]"] for i in range(2)]
    apart = [states[name] - sympy.Rational(str(value)) for name, value in truth.items()]
    printed = sum(e**2 for e in errors) / 2 + sum(one**2 for one in apart) / (2 * gamma)
    assert sympy.expand(found.V - printed) == 0
    assert found.status == "open"  # |phi| <= 1, so x is bounded: not shown
    assert found.claim == "V found, but it does not contain x"


@pytest.mark.parametrize(
    "seed",
    [0, 1, 2, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(3, 20))],
)
def test_a_stable_linear_system_always_has_one_and_no_other_does(seed):
    random = np.random.default_rng(seed)
    n = int(random.integers(2, 6))
    A = np.round(random.standard_normal((n, n)), 2)
    A -= np.round(np.linalg.eigvals(A).real.max() + 0.3, 2) * np.eye(n)
    none = np.zeros((n, 0)), np.eye(n), np.zeros((n, 0))
    stable = lyapunov(control.ss(A, *none))
    assert stable.implies("asymptotically stable")
    assert lyapunov(control.ss(A + 0.6 * np.eye(n), *none)).status == "open"


# --- discrete time ------------------------------------------------------------------------------


def in_steps(A):
    """The linear system x+ = A x."""
    n = len(A)
    return control.ss(A, np.zeros((n, 0)), np.eye(n), np.zeros((n, 0)), dt=0.1)


@pytest.mark.parametrize(
    "seed",
    [0, 1, 2, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(3, 12))],
)
def test_a_linear_system_of_discrete_time_has_one_within_the_unit_circle(seed):
    random = np.random.default_rng(seed)
    n = int(random.integers(2, 5))
    A = random.standard_normal((n, n))
    A = np.round(A * 0.9 / np.abs(np.linalg.eigvals(A)).max(), 2)
    found = lyapunov(in_steps(A))
    assert found.implies("asymptotically stable")
    states = sorted(found.V.free_symbols, key=str)
    P = np.array(sympy.hessian(found.V, states), dtype=float)
    assert np.linalg.eigvalsh(P).min() > 0
    assert np.linalg.eigvalsh(A.T @ P @ A - P).max() < 0
    assert lyapunov(in_steps(A * 1.2)).status == "open"


STEPS = {  # of one step: the matrix, the conclusion
    "a shear within": ([[0.5, 1.0], [0.0, 0.5]], "asymptotically stable"),
    "a turn": ([[0.0, 1.0], [-1.0, 0.0]], "stable"),
    "growth on the circle": ([[1.0, 1.0], [0.0, 1.0]], ""),
    "a mode of -1.01": ([[-1.01, 0.0], [0.0, 0.5]], ""),
    "stable as rates alone": ([[-2.0, 0.0], [0.0, -0.5]], ""),
}


@pytest.mark.parametrize("name", STEPS)
def test_a_step_is_no_rate(name):
    A, conclusion = STEPS[name]
    found = lyapunov(in_steps(A))
    assert (found.status == "proved", found.conclusion) == (
        bool(conclusion),
        conclusion,
    )


def step_of(update, **more):
    """A nonlinear system of discrete time of one state."""
    names = {"states": ["x"], "outputs": ["x"], "dt": 0.1, "name": "steps"}
    return control.nlsys(lambda t, x, u, p: [update(x[0], u)], **names, **more)


def test_a_V_of_discrete_time_is_searched_for_about_the_rest():
    """x+ = x/2 + 1 rests at 2: V falls by 3/4 of itself."""
    plant = step_of(lambda x, u: x / 2 + 1, inputs=0)
    found = lyapunov(plant, at={"x": 2.0})
    assert found.implies("asymptotically stable")
    assert sympy.expand(found.rate + 3 * found.V / 4) == 0
    with pytest.raises(clpt.DiagramError, match=r"x\+ = 1 at the rest"):
        lyapunov(plant)


@pytest.mark.parametrize(("gain", "status"), [(0.5, "proved"), (2.5, "open")])
def test_a_normalised_step_of_a_gain_has_a_V_for_each_regressor(gain, status):
    """|1 - g r^2/(1 + r^2)| <= 1 for every r where g <= 2."""
    normalised = lambda x, u: x - gain * u[0] ** 2 / (1 + u[0] ** 2) * x  # noqa: E731
    found = lyapunov(step_of(normalised, inputs=["r"]))
    zeroed = any(condition.name == "zero inputs" for condition in found.conditions)
    assert (status, zeroed) == (found.status, False) or (status == "open" and zeroed)


FOUND = {
    "x' = -(1 + t)*x": "asymptotically stable",
    "x' = -x*exp(-t)": "stable",  # x comes to x(0)/e
    "x' = -x*abs(x)": "asymptotically stable",
    "x' = -x/(1 + x**2)": "asymptotically stable",
}
LEAVING = [  # of what leaves its rest no V is found
    "x' = -(1 - t)*x",
    "x' = x*exp(-t)",
    "x' = -x*sin(t)",
    "x' = x**3",
    "x' = -x; y' = y",
    "x' = -y; y' = x - (1 - x**2)*y",
    "x' = x - k*x; k' = -(x**2)",
    "q' = w; w' = 9.8*sin(q) - 0.1*w",
    "x' = y; y' = -x + 0.1*y**3",
    "x' = -x + 2*x*exp(-1e8*(x - 1)**2)",  # no power 1e8 of exp(x) is made
]


# by a linear part with the eigenvalue 1, 1 and (3.13^2 + 0.05^2)^0.5 - 0.05
GROWING = [
    "x' = -x; y' = y",
    "x' = x - k*x; k' = -(x**2)",
    "q' = w; w' = 9.8*sin(q) - 0.1*w",
]


@pytest.mark.parametrize("text", [*FOUND, *LEAVING])
def test_of_what_leaves_its_rest_nothing_is_proved(text):
    found = lyapunov(written(text)[0])
    assert found.status == ("proved" if text in FOUND else "open")
    assert found.conclusion == FOUND.get(text, "")
    assert ("has the eigenvalue" in found.claim) == (text in GROWING)


MANY = control.ss(-np.eye(17), np.zeros((17, 0)), np.eye(17), np.zeros((17, 0)))


NO_SEARCH = [
    ("x' = 1 - x", {}, r"x' = 1 at the rest"),
    ("x' = -1/x", {}, r"x' has no value at the rest"),
    ("x' = -x", {"claim": lambda s: -s.x}, "leave `claim` out, or give a V and no box"),
    (MANY, {}, "has 17 states; a V is searched for of at most 16"),
]


@pytest.mark.parametrize(("plant", "more", "said"), NO_SEARCH)
def test_what_cannot_be_searched_for_is_refused(plant, more, said):
    with pytest.raises(clpt.DiagramError, match=said):
        lyapunov(written(plant)[0] if isinstance(plant, str) else plant, **more)


OSCILLATOR = "a' = -b; b' = a + (a**2 - 1)*b"  # Khalil's example 8.9
IN_REGION = "asymptotically stable in a region"
INSIDE = "(abs(a - 0.5) < 1e-3) & (abs(b - 0.25) < 1e-3)"
CASES = {  # rates, V, box
    "Khalil's oscillator": (OSCILLATOR, "1.5*a**2 - a*b + b**2", 3.0),
    "a pendulum at the top, with a limited torque": (
        "a' = b; b' = sin(a) - clip(8*a + 4*b, -2, 2)", "(9*a**2 + a*b + b**2)/7", 2.0
    ),
    "a drag, whose slope has a kink at rest": (
        "a' = -2*a + abs(b)*b; b' = -b - 0.1*abs(b)*b", "a**2 + b**2", 9.0
    ),
    "a pocket that is hard to see": (f"a' = where({INSIDE}, 9.0, -a); b' = -b", "a**2 + b**2", 1.0),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_the_level_is_where_samples_of_the_rate_first_fail(name):
    text, V_text, half = CASES[name]
    box = dict.fromkeys("ab", (-half, half))
    plant, level = written(f"{text}; V = {V_text}")
    found = lyapunov(plant, level, within=box)
    assert (found.status, found.conclusion) == ("proved", IN_REGION)
    V = eval(f"lambda a, b: {V_text}", NUMPY)
    a, b = np.meshgrid(*[np.linspace(-half, half, 2001)] * 2)
    rates = [eval(part[5:], NUMPY, {"a": a, "b": b}) for part in text.split("; ")]
    h = 1e-6
    slopes = (
        (V(a + h, b) - V(a - h, b)) / (2 * h),
        (V(a, b + h) - V(a, b - h)) / (2 * h),
    )
    rate = sum(slope * own for slope, own in zip(slopes, rates, strict=True))
    away = np.hypot(a, b) > 1e-3
    edge = (np.abs(a) == half) | (np.abs(b) == half)
    fails = V(a, b)[edge | (away & (rate >= 0))].min()
    assert 0.98 * fails < found.level <= fails


def test_khalils_oscillator_is_found_without_a_v_and_its_region_ends_within_the_cycle():
    oscillator, _ = written(OSCILLATOR)
    found = lyapunov(oscillator, within={"a": (-3, 3), "b": (-3, 3)})
    assert str(found.V) == "3*a**2/2 - a*b + b**2"  # P of A'P + PA = -I, by hand
    assert 2.25 < found.level < 2.31  # Khalil reads 2.25 off a contour
    for around in np.linspace(0, 2 * np.pi, 9)[:-1]:
        a, b = np.cos(around), np.sin(around)
        size = np.sqrt(0.999 * found.level / (1.5 * a**2 - a * b + b**2))
        last = clpt.simulate(oscillator, [0, 40.0], 0, [size * a, size * b]).states[-1]
        assert np.abs(last).max() < 1e-4


def judged(text, *box):
    plant, V, *more = written(text)
    return lyapunov(plant, V, within={"x": box}, **dict(*more))


def test_a_level_is_exact_where_it_is_known_by_hand():
    cubic = "x' = -x + x**3; V = x**2"  # V' < 0 for 0 < x^2 < 1
    assert 0.999 <= judged(cubic, -3, 2).level <= 1.0
    assert 0.249 <= judged(cubic, -0.5, 2).level <= 0.25  # V on the nearer edge
    found = judged("x' = sin(x); V = 1 + cos(x); at x = pi", 1, 5)  # V' = -sin(x)^2
    assert 0.999 * (1 + np.cos(5)) <= found.level <= 1 + np.cos(5)


def test_inputs_and_parameters_as_they_are_are_said():
    box = {"x": (-1, 1)}
    damped = control.nlsys(
        lambda t, x, u, p: -x + x**3, states=["x"], inputs=0, params={"k": 1.0}
    )
    assert not lyapunov(damped, lambda s: s.x**2, within=box).conditions
    said = judged("x' = -k*x; k = 2; V = x**2", -1, 1).sentence
    assert said.endswith("comes to rest; with the parameters' values k = 2")
    found = judged("x' = -x + x**3 + d; input d; V = x**2", -2, 2)
    assert (found.conclusion, found.inputs) == (IN_REGION, ("d",))
    assert found.sentence.endswith("comes to rest; where d = 0")


@pytest.mark.parametrize(
    "rate",
    ["x", "1 - x", "-x + x/(x - 1)", "-x + 2*x**2/(x**2 + 1e-6)"],
    ids=["unstable", "no rest", "no value beside it", "unstable nearby"],
)
def test_what_is_not_shown_is_open(rate):
    found = judged(f"x' = {rate}; V = x**2", -2, 2)
    assert (found.status, found.level) == ("open", None)


NO_REGION = [
    ("x' = -x", {"q": (-1, 1)}, "within: there is no q. It has x"),
    (
        "x' = -x",
        {"x": (1, 2)},
        "x from 1 to 2; must be finite, with the rest, 0, between",
    ),
    ("x' = -x", {"x": (-1, np.inf)}, "must be finite"),
    ("x' = -x", {"x": (-1, 0, 1)}, "must be an array of numbers"),
    (
        "x' = -x*(2 + sin(t))",
        {"x": (-1, 1)},
        "no region that lasts, because it moves with t",
    ),
]


@pytest.mark.parametrize(("text", "within", "sentence"), NO_REGION)
def test_a_box_or_a_system_that_has_no_region_is_refused(text, within, sentence):
    says(clpt.ClptError, sentence, lyapunov, *written(text), within=within)


def test_a_linear_loop_of_long_numbers_is_decided_by_a_V_of_doubles():
    """A quarter car with the gains of an LQR: its exact P has entries of 300 digits."""
    m_s, m_u, k, c, k_t = 300.0, 40.0, 16000.0, 1000.0, 190000.0
    A = np.array(
        [
            [0, 1, 0, -1],
            [-k / m_s, -c / m_s, 0, c / m_s],
            [0, 0, 0, 1],
            [k / m_u, c / m_u, -k_t / m_u, -c / m_u],
        ]
    )
    B = np.array([[0], [1 / m_s], [0], [-1 / m_u]])
    K, _, _ = control.lqr(A, B, np.diag([1e4, 1e4, 1e3, 1]), [[1e-4]])
    closed = control.ss(A - B @ K, np.zeros((4, 0)), np.eye(4), np.zeros((4, 0)))
    verdict = clpt.lyapunov(closed)
    assert verdict.implies("asymptotically stable")
    assert max(n.q for n in verdict.V.atoms(sympy.Rational)) < 1e30
