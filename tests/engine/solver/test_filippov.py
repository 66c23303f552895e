"""Switches on which a run slides or comes to rest."""

import control
import numpy as np
import pytest
import scipy.integrate
import scipy.linalg
from test_event_location import T, system
from text_systems import ticking

import clpt_control as clpt
from clpt_control import Guard


def rest_of(rates, x0, times=T, **more):
    """Return a run that slides: it is machine code, and says from when on."""
    found = clpt.simulate(system(rates, len(x0)), times, None, x0, **more)
    assert found.attrs["engine"] == "native"
    assert "sliding on a switch from t = " in found.attrs["method"]
    return found.states.values


@pytest.mark.parametrize("rtol", [1e-1, 3e-3, 1e-6, 1e-8, 1e-12])
def test_a_run_stays_on_a_switch_to_which_both_sides_lead(rtol):
    """x = 0.5 - t + 0.3 (1 - cos t) until it is 0, and then 0."""
    sliding = system("x' = -sign(x) + 0.3*sin(t)")
    found = clpt.simulate(sliding, T, None, [0.5], rtol=rtol, atol=1e-2 * rtol)
    right = np.maximum(0.5 - T + 0.3 * (1.0 - np.cos(T)), 0.0)
    np.testing.assert_allclose(found.states.values[:, 0], right, atol=max(rtol, 1e-8))


QUESTIONS = [  # the same switch at x = 1, asked in other ways: rates 1 below, -2 above
    "-0.5 - 1.5*sign(x - 1)",
    "1.0 if x < 1 else -2.0",
    "where(x > 1, -2.0, 1.0)",
    "1 - 3*floor(x)",
    "4 - 3*ceil(x)",
    "1 - 3*int(x)",
    "1 - 3*(x // 1)",
    "[1.0, -2.0, -2.0][int(x)]",
    "[1.0, -2.0][int(x > 1)]",
    "1 - 3*clip(floor(x), 0, 1)",
    "1 - 3*heaviside(x - 1, 0.5)",
    "-0.5 - 1.5*copysign(1, x - 1)",
    "-2 + 3*signbit(x - 1)",
]


@pytest.mark.parametrize("question", QUESTIONS)
def test_every_kind_of_switch_may_be_slid_on(question):
    """Half way x' is also t - 1.5 along the switch: y' = x - 1 + w (-2 - 1), w = 1/3."""
    x = rest_of(f"x' = {question}; y' = {question}", [0.5, 0.0])
    wanted = np.minimum([0.5 + T, T], [[1.0], [0.5]])  # the mean rate is 0
    np.testing.assert_allclose(x.T, wanted, atol=1e-8)


def test_sliding_control_moves_as_the_switch_says():
    """On s = v + x the plant is x' = -x, whatever pushes it by less than the gain."""
    x = rest_of("x' = v; v' = -2*sign(x + v) + sin(3*t)", [1.0, 0.0])[T >= 1.0]
    np.testing.assert_allclose(x[:, 1], -x[:, 0], atol=1e-8)
    np.testing.assert_allclose(x[:, 0], x[0, 0] * np.exp(1.0 - T[T >= 1.0]), atol=1e-9)


def test_dry_friction_sticks_and_slips():
    """From v = 0.1 it sticks until sin t = 0.5, t = pi/6."""
    times = np.linspace(0.0, 2.0, 201)
    v = rest_of("v' = sin(t) - 0.5*sign(v)", [0.1], times)[:, 0]
    braked = np.maximum(1.1 - np.cos(times) - 0.5 * times, 0.0)
    since = np.maximum(times, np.pi / 6)
    right = (
        braked * (times < 0.4)
        + np.cos(np.pi / 6)
        - np.cos(since)
        - 0.5 * (since - np.pi / 6)
    )
    np.testing.assert_allclose(v, right, atol=1e-8)


def test_a_switch_that_is_bent_is_slid_along():
    """On r = 1 the angle moves by theta' = 1 - 0.3 sin theta."""
    inward = "sign(x**2 + y**2 - 1)"
    ring, times = (
        f"x' = -y - x*{inward} + 0.3; y' = x - y*{inward}",
        np.linspace(0.0, 8.0, 81),
    )
    loose = clpt.simulate(system(ring), times, None, [0.2, 0.1], rtol=1e-3, atol=1e-6)
    assert loose.attrs["solver_steps"] < 20_000  # is told from a switch that is crossed
    x = rest_of(ring, [0.6, 0.8], times)
    np.testing.assert_allclose(x[:, 0] ** 2 + x[:, 1] ** 2, 1.0, atol=1e-8)
    angle, start = (lambda a, t: 1.0 - 0.3 * np.sin(a)), np.arctan2(0.8, 0.6)
    theta = scipy.integrate.odeint(angle, start, times, rtol=1e-10, atol=1e-12)[:, 0]
    np.testing.assert_allclose(
        x, np.transpose([np.cos(theta), np.sin(theta)]), atol=1e-7
    )


def test_a_question_about_other_questions_follows_them():
    """What is asked of two switches slides on one of them, until the other has turned, t = 2."""
    x = rest_of("x' = -1.0 if sign(x) + 2*(y < 0) > 0 else 1.0; y' = -0.5", [0.5, 1.0])[
        :, 0
    ]
    right = np.where(T < 2.0, np.maximum(0.5 - T, 0.0), 2.0 - T)
    np.testing.assert_allclose(x, right, atol=1e-8)


@pytest.mark.parametrize("start", [0.1, 0.13, 0.25, 0.3])
def test_a_question_whose_numbers_differ_on_both_sides_is_asked_on_each(start):
    """On x = 0 the mean of z' is 0.2, then 0.6 where 2 z > 1 on one side, then 1 on both."""
    faster = "where(where(x > 0, z, 2*z) > 1, 1.0, 0.2)"
    x = rest_of(f"x' = -sign(x); z' = {faster}", [start, 0.4])
    times = [0.0, 0.5, 0.5 + 0.5 / 0.6, 10.0]
    right = np.interp(T, times, [0.4, 0.5, 1.0, 1.0 + 10.0 - times[2]])
    np.testing.assert_allclose(x[:, 1], right, atol=1e-7)


def test_inputs_that_jump_and_bend_end_what_slides():
    """x follows r where |r'| < 3, and goes to it by 3 where r jumps."""
    times = np.array([0.0, 1.0, 2.0, 2.0 + 1e-9, 3.0, 4.0])
    r = np.array([0.0, 2.0, 0.0, 1.5, 1.5, 1.5])
    found = clpt.simulate(
        system("x' = -3*sign(x - r); input r"), times, r, [0.0]
    ).x.values
    np.testing.assert_allclose(found, [0.0, 2.0, 0.0, 0.0, 1.5, 1.5], atol=1e-7)


def test_states_that_jump_leave_the_switch():
    """At whole times s jumps up by 0.5, and is back at 0 half a unit later."""
    block = ticking(lambda t, x, u, p: -np.sign(x), lambda t, x, u, p: x + 0.5)
    found = clpt.simulate(block, T[:-1], None, [0.25]).s.values.ravel()
    since = np.where(T < 1.0, T + 0.25, (T + 1e-9) % 1.0)[:-1]
    np.testing.assert_allclose(found, np.maximum(0.5 - since, 0.0), atol=1e-8)


def test_members_slide_as_runs_do():
    falling, k = system("x' = -k*sign(x); k = 1"), np.array([0.1, 0.5, 1.0, 2.0, 3.0])
    many = clpt.run_ensemble(
        falling, {"k": k}, timepts=[0.0, 1.0, 2.0], initial_state=[1.0]
    )
    assert np.all(many.status == 1)
    np.testing.assert_allclose(
        many.x_final.values.ravel(), np.maximum(1 - 2 * k, 0), atol=1e-8
    )
    by = clpt.sensitivity(
        falling, [0.0, 0.5, 0.9], "states", ["k", "x0"], None, [1.0]
    ).states
    np.testing.assert_allclose(
        by.values[:, 0], [[0.0, 1.0], [-0.5, 1.0], [-0.9, 1.0]], atol=1e-6
    )
    with pytest.raises(
        clpt.SimulationError, match="do not confirm its derivative by k"
    ):
        clpt.sensitivity(falling, [0.0, 0.5, 2.0], "states", ["k", "x0"], None, [1.0])


def test_a_guard_ends_what_slides():
    """y' = 1 on the switch x = 0, until y = 0.75."""
    above = Guard(lambda t, x, u, p: 0.75 - x.y, "stop", lambda t, u, p: f"at {t:.6f}")
    own = {"update": lambda t, x, u, p: {"x": -np.sign(x.x), "y": 1.0}, "guard": above}
    found = clpt.simulate(
        clpt.Block("b", states={"x": 1, "y": 1}, **own), T, None, [0.25, 0.0]
    )
    assert found.attrs["message"] == "stopped: at 0.750000"
    np.testing.assert_allclose(found.y.values.ravel()[-1], 0.75, atol=1e-8)


EMPTYING = [  # Torricelli: beyond the switch the rate has no value, or no slope
    "-k*sqrt(x) if x >= 0 else 0",
    "-k*sqrt(max(x, 0))",
    "-k*sqrt(abs(x))*sign(x)",
]


@pytest.mark.parametrize("rate", EMPTYING)
def test_a_tank_that_runs_empty_stays_so(rate):
    """x = (1 - k t/2)^2 until it is empty, one by one and in lanes."""
    tank, times = system(f"x' = {rate}; k = 1"), np.linspace(0.0, 3.0, 31)
    right = np.maximum(1.0 - times / 2, 0.0) ** 2
    run = clpt.simulate(tank, times, initial_state=[1.0])
    assert run.attrs["engine"] == "native"
    np.testing.assert_allclose(run.x.values, right, atol=1e-8)
    k = np.array([0.5, 1.0, 2.0, 3.0])
    many = clpt.run_ensemble(tank, {"k": k}, timepts=times, initial_state=[1.0])
    assert np.all(many.status == 1)
    np.testing.assert_allclose(
        many.x_final, np.maximum(1.0 - 1.5 * k, 0.0) ** 2, atol=1e-8
    )


def test_what_has_no_value_on_either_side_is_still_told():
    falling = system("x' = log(x) if x > -1 else 0")
    with pytest.raises(
        clpt.SimulationError, match="derivative of x of block plant is not finite"
    ):
        clpt.simulate(falling, [0.0, 3.0], initial_state=[0.5])


def test_a_root_of_a_magnitude_that_begins_at_zero_goes_on():
    """Bouc and Wen's hysteresis at rest: |z|^0.5 has no value where the sign of z is held."""
    slip = "0.6*abs(v)*abs(z)**0.5*z + 0.3*v*abs(z)**1.5"
    rates = system(f"q' = v; v' = sin(t) - 0.2*v - q - 0.5*z; z' = v - ({slip})").updfcn
    bouc = control.nlsys(
        rates, None, inputs=0, outputs=3, states=["q", "v", "z"], name="bouc"
    )
    times, start = np.linspace(0.0, 5.0, 51), [0.01, 0.0, 0.0]
    run = clpt.simulate(bouc, times, None, start)
    assert "switches not located" in run.attrs["method"]
    close = {"solve_ivp_kwargs": {"rtol": 1e-10, "atol": 1e-12}}
    theirs = control.input_output_response(bouc, times, 0, start, **close)
    np.testing.assert_allclose(run.states.values, theirs.states.T, atol=1e-6)
    many = clpt.run_ensemble(
        bouc, {"q": [0.01]}, timepts=times, initial_state=[0.0, 0.0, 0.0]
    )
    np.testing.assert_allclose(many.y_final.values[0], run.states.values[-1], atol=1e-7)


MEETING = [(5, 2, 0.0), (5, 3, 0.3), (4, 3, 0.5), (9, 6, 0.2)]
