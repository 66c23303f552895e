"""A diagram linearized: closed forms, python-control's differences, kinks and jumps."""

import math
import re
import warnings

import control
import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import clpt_control as clpt


def block(rate):
    ports = {"inputs": {"v": 1}, "states": {"y": 1}}
    return clpt.Block("b", update=lambda t, x, u, p: {"y": rate(x.y, u.v)}, **ports)


NAMES = {"inputs": "torque", "outputs": 2, "states": ["theta", "omega"], "name": "rod"}
PENDULUM = control.nlsys(
    lambda t, x, u, p: [x[1], -p["g"] * np.sin(x[0]) - 0.1 * x[1] + u[0]],
    params={"g": 9.81},
    **NAMES,
)


@pytest.mark.parametrize("angle", [0.0, 0.3, np.pi, 2.5])
def test_a_pendulum_has_its_closed_form(angle):
    made = clpt.linearize(PENDULUM, [angle, 0.7], [0.2])
    np.testing.assert_allclose(
        made.A, [[0, 1], [-9.81 * np.cos(angle), -0.1]], rtol=1e-15
    )
    np.testing.assert_array_equal(made.B, [[0], [1]])
    assert (made.state_labels, made.input_labels) == (["theta", "omega"], ["torque"])
    on_the_moon = clpt.linearize(PENDULUM, [angle, 0.7], [0.2], params={"g": 1.62})
    assert on_the_moon.A[1, 0] == pytest.approx(-1.62 * np.cos(angle), rel=1e-15)


SCENARIO = clpt.paper_scenario()


@pytest.mark.parametrize(
    "law", ["learned-flow", "least-squares", "projection", "composite-memory"]
)
def test_as_python_control_by_differences(law):
    scenario = SCENARIO.with_values({"learning.law": law})
    loop = clpt.closed_loop(scenario, external="zc")
    random = np.random.default_rng(1)
    x, u = 0.3 * random.standard_normal(loop.nstates), random.standard_normal(2)
    own, theirs = clpt.linearize(loop, x, u, 7.0), control.linearize(loop, x, u, t=7.0)
    for name in "ABCD":
        # theirs
        np.testing.assert_allclose(getattr(own, name), getattr(theirs, name), atol=2e-5)
    assert own.input_labels == loop.input_labels
    labels = (own.output_labels, loop.output_labels)
    assert len({" ".join(names).replace("[0]", "") for names in labels}) == 1


def test_a_port_of_one_signal_has_its_name_alone():
    parts = [clpt.parts.lag(1.0, u="wanted", y="y")]
    parts += [clpt.parts.lag(1.0, signals=2, name="two", u="force", y="e")]
    both = clpt.linearize(clpt.connect(parts, external=["wanted", "force"]))
    assert both.input_labels == ["wanted", "force[0]", "force[1]"]
    assert both.output_labels == ["y", "e[0]", "e[1]"]
    assert both["y", "wanted"].dcgain() == 1
    assert clpt.linearize(parts[0])["y", "wanted"].dcgain() == 1
    theirs = control.ss(-1, 1, 1, 0)
    assert clpt.linearize(theirs).input_labels == theirs.input_labels


def test_a_linear_system_is_itself_whatever_its_time():
    for dt in (0, 0.1, True):
        given = control.rss(4, 2, 3)
        given.dt = dt
        made = clpt.linearize(given, np.ones(4), np.ones(3))
        assert made.dt == dt
        for name in "ABCD":
            np.testing.assert_allclose(
                getattr(made, name), getattr(given, name), atol=1e-15
            )


TABLE = np.linspace(0.0, 4.0, 5), np.array([0.0, 1.0, 4.0, 9.0, 16.0])
SPLINE = CubicSpline(*TABLE)
RATES = {  # whether the rate has a kink, a jump or neither at a place, and what rate
    "fabs": ("bent", lambda y, v: v - abs(y), 0.0),
    "clip": ("bent", lambda y, v: v + np.clip(-y, -1, 1), 1.0),
    "one way": ("bent", lambda y, v: v + np.where(y > 0, y, 0.0), 0.0),
    "branch": ("bent", lambda y, v: v + (y if y > 0 else 3 * y), 0.0),
    "small": ("bent", lambda y, v: v - y * abs(y) - 1e-5 * abs(y), 0.0),
    "twice": ("bent", lambda y, v: v - np.cos(y) * abs(abs(y)), 0.0),
    "both": (
        "bent",
        lambda y, v: v + np.where((y > 0) & (v > 0), np.minimum(y, v), 0.0),
        0.0,
    ),
    "sign": ("torn", lambda y, v: v - np.sign(y), 0.0),
    "beside a steep slope": ("torn", lambda y, v: v - 1e6 * y - 1e-3 * np.sign(y), 0.0),
    "the slope of neither side": ("torn", lambda y, v: v - y * np.sign(y), 0.0),
    "likewise": ("torn", lambda y, v: v - y * np.sign(y) ** 2, 0.0),
    "floor": ("torn", lambda y, v: v - np.floor(y), 2.0),
    "steps beside a steep slope": (
        "torn",
        lambda y, v: v - 1e3 * y - 0.01 * np.floor(y),
        2.0,
    ),
    "no value beside": (
        "torn",
        lambda y, v: v + np.where(y < 2.0, np.log(y - 2.0), y % 2.0),
        2.0,
    ),
    "mod": ("torn", lambda y, v: v - y % 1.0, 3.0),
    "atan2": ("torn", lambda y, v: v - np.arctan2(y, -1.0), 0.0),
    "where": ("torn", lambda y, v: v - np.where(y > 0, 1.0, -1.0), 0.0),
    "comparison": ("torn", lambda y, v: v - (y > 0) * 1.0, 0.0),
    "two conditions": (
        "torn",
        lambda y, v: v - np.where((y > 0) & (v > 0), 1.0, 0.0),
        0.0,
    ),
    "trunc": ("torn", lambda y, v: v - np.trunc(y), 1.0),
    "a node of a table": ("bent", lambda y, v: v + np.interp(y, *TABLE), 2.0),
    "a saw": ("bent", lambda y, v: v + np.abs(y % 2.0 - 1.0), 2.0),
    "a node of a spline": ("smooth", lambda y, v: v + SPLINE(y), 2.0),
    "wholes and parts": (
        "smooth",
        lambda y, v: v + np.floor(y) + (y - np.floor(y)),
        2.0,
    ),
    "beside a kink": ("smooth", lambda y, v: v - abs(y), 1e-6),
    "an angle ahead": ("smooth", lambda y, v: v - np.arctan2(y, 1.0), 0.0),
    "beside a jump": ("smooth", lambda y, v: v - np.sign(y), -1e-6),
    "a drag at rest": ("smooth", lambda y, v: v - y * abs(y), 0.0),
    "a drag at rest, by its sign": ("smooth", lambda y, v: v - np.sign(y) * y**2, 0.0),
    "a drag of one side": ("smooth", lambda y, v: v - y * np.maximum(y, 0.0), 0.0),
    "two ways of one slope": (
        "smooth",
        lambda y, v: v + np.where(y > 0, y * y, -y * y),
        0.0,
    ),
    "a whole number cut at zero": ("smooth", lambda y, v: v - y - np.trunc(y), 0.0),
    "infinity": ("smooth", lambda y, v: v - y if np.isfinite(y) else 0 * y, 0.5),
    "no number": ("smooth", lambda y, v: v - y if not np.isnan(y * v) else 0 * y, 0.5),
    "what is not moved": ("smooth", lambda y, v: v - y * np.sign(0.0 * v), 0.5),
}


@pytest.mark.parametrize("name", RATES)
def test_a_kink_is_said_a_jump_is_refused_and_nothing_is_said_where_it_is_smooth(
    name, recwarn
):
    kind, rate, at = RATES[name]
    warnings.simplefilter("always")
    if kind == "torn":
        with pytest.raises(
            clpt.DiagramError, match=r"the rate of b\.y jumps at this point"
        ):
            clpt.linearize(block(rate), [at])
        return
    A = clpt.linearize(block(rate), [at]).A
    said = [
        (str(one.message).count("the rate of b.y has a kink"), one.filename)
        for one in recwarn
    ]
    assert said == [(1, __file__)] * (kind == "bent")
    sides = [(rate(at + h, 0.0) - rate(at, 0.0)) / h for h in (1e-8, -1e-8)]
    assert min(abs(A[0, 0] - slope) for slope in sides) < 1e-5


def test_a_slope_without_end_is_refused_by_the_name_of_what_has_none():
    with pytest.raises(
        clpt.DiagramError, match=r"along y\[0\] has no finite slope .* add a small"
    ):
        clpt.linearize(block(lambda y, v: np.sqrt(y) + v), [0.0])
    names = {"inputs": 0, "outputs": ["a", "b", "c"], "states": ["p", "q", "r"]}
    size = lambda t, x, u, p: [x[0], np.linalg.norm(x[1:]), x[2]]  # noqa: E731
    with pytest.raises(
        clpt.DiagramError, match=r"what b does along . has no finite slope"
    ):
        clpt.linearize(
            control.nlsys(lambda t, x, u, p: -x, size, **names), [1.0, 0.0, 0.0]
        )


def test_a_kernel_at_its_centre_is_named_with_a_point_that_works():
    """The paper's vehicle starts at c_1 = 0: phi_1 = exp(-|x|/10) has no slope there."""
    loop = clpt.closed_loop(SCENARIO)
    said = r"exponential of basis_x is at centers\[0\] = \[0.0, 0.0\]. Linearize beside it, with "
    with pytest.raises(clpt.DiagramError, match=said) as refused:
        clpt.linearize(loop)
    point = {
        label: float(value)
        for label, value in re.findall(
            r"(\w+\[\d\]) = ([-\d.]+)", f"{refused.value}".split("with ")[1]
        )
    }
    assert point.keys() == {
        f"{name}[{k}]" for name in ("vehicle_x", "learning_model_z") for k in (0, 1)
    }
    linear = clpt.linearize(loop, point)
    row = linear.output_labels.index("phi_x[0]")
    # d phi_1/dx_1 = -x_1/(10 |x|) exp(-|x|/10) at t = 0
    away = np.hypot(point["vehicle_x[0]"], point["vehicle_x[1]"])
    slope = -point["vehicle_x[0]"] / (10 * away) * np.exp(-away / 10)
    assert linear.C[row, 0] == pytest.approx(slope, rel=1e-12)


@pytest.mark.parametrize("at", [-2.0, 0.9, 1.0, 1.1, 4.0])
def test_a_steep_logistic_function_has_its_slope_where_exp_overflows(at):
    def rate(t, x, u, p):
        return [1.0 / (1.0 + np.exp(-1000.0 * (x[0] - 1.0)))]

    made = clpt.linearize(control.nlsys(rate, states=1, inputs=0), [at])
    wanted = 250.0 / math.cosh(500.0 * (at - 1.0)) ** 2 if abs(at - 1.0) < 1 else 0.0
    assert made.A[0, 0] == pytest.approx(wanted, rel=1e-9, abs=1e-30)


def test_a_distance_has_a_slope_where_one_coordinate_is_equal():
    rates = lambda t, x, u, p: [-math.dist(x, [0.0, 3.0]), -math.hypot(x[0], x[1])]  # noqa: E731
    made = clpt.linearize(control.nlsys(rates, states=2, inputs=0), [0.0, 1.0])
    assert made.A.tolist() == [[0.0, 1.0], [0.0, -1.0]]


def test_minimal_leaves_out_what_is_not_reached_or_not_seen():
    apart = control.ss(np.diag([-1.0, -2.0, -3.0]), [[1], [0], [1]], [[1, 1, 0]], 0)
    made = clpt.linearize(apart, minimal=True)
    assert made.state_labels == ["x[0]"]
    assert made.A.tolist() == [[-1.0]]
    twice = control.ss(-np.eye(2), [[1], [1]], [[1, 1]], 0)
    one = clpt.linearize(twice, minimal=True)
    assert one.nstates == 1
    assert one(2j) == pytest.approx(twice(2j))
    assert clpt.linearize(control.ss(-1, 0, 1, 2), minimal=True).nstates == 0


def test_what_is_given_is_as_in_python_control():
    theirs = control.linearize(PENDULUM, 0.3, 0)  # a single number is that of all
    np.testing.assert_allclose(clpt.linearize(PENDULUM, 0.3, 0).A, theirs.A, atol=1e-5)
    still = control.nlsys(lambda t, x, u, p: -(x**3), inputs=0, states=2, name="still")
    assert clpt.linearize(still, 2, 0).A.tolist() == [[-12.0, 0.0], [0.0, -12.0]]
    point = control.find_operating_point(PENDULUM, [0.1, 0], [1.0])
    assert clpt.linearize(PENDULUM, point).A[1, 0] == -9.81 * np.cos(point.states[0])
    with pytest.raises(
        clpt.ArgumentError,
        match=r"x = .*must have 2 finite numbers; it has shape \(3,\)",
    ):
        clpt.linearize(PENDULUM, [0, 0, 0])
    with pytest.raises(clpt.ArgumentError, match=r"^x = \[0.0, nan\]: must be finite"):
        clpt.linearize(PENDULUM, [0, np.nan], [0])
    with pytest.raises(clpt.ArgumentError, match=r"^u = \[inf\]: must be finite"):
        clpt.linearize(PENDULUM, [0, 0], np.inf)


def test_the_interval_is_that_of_the_time():
    ports = {"states": {"y": 1}, "parameters": {"interval": -1.0}}
    ports["breakpoints"] = lambda p, t0, t1: np.arange(
        np.floor(t0) + 1, np.floor(t1) + 1
    )
    steps = clpt.Block(
        "steps", update=lambda t, x, u, p: {"y": -p.interval * x.y}, **ports
    )
    assert clpt.linearize(steps, [1.0], t=3.5).A == -3.0


def test_rounding_is_no_jump():
    """A weight of 1e7 N beside a buoyancy of 1e7 N: the rate is exact to 1e-9 N alone."""
    rates = lambda t, x, u, p: [x[1], (1e7 + 50.0 * x[1] - 1e7 + u[0]) / 1e6]  # noqa: E731
    floating = control.nlsys(rates, inputs=1, outputs=2, states=2, name="floating")
    found = clpt.linearize(floating, [0.0, 0.0], [0.0])
    np.testing.assert_allclose(found.A, [[0.0, 1.0], [0.0, 5e-5]])
