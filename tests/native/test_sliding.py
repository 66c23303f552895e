"""Switches on which a run slides or comes to rest."""

import control
import numpy as np
import pytest
import scipy.integrate
from test_kinks import T, run, system

import clpt_control as clpt
from clpt_control.equations.declaration import Guard
from clpt_control.errors import SimulationError


def sliding(t, x, u, p):
    return [-np.sign(x[0]) + 0.3 * np.sin(t)]


def rest_of(f, x0, times=T, **more):
    """Return a run that slides: it is machine code, and says from when on."""
    found = clpt.simulate(system(f, len(x0)), times, None, x0, **more)
    assert found.attrs["engine"] == "native"
    assert "sliding on a switch from t = " in found.attrs["method"]
    return found.states.values


@pytest.mark.parametrize("rtol", [1e-1, 3e-3, 1e-6, 1e-8, 1e-12])
def test_a_run_stays_on_a_switch_to_which_both_sides_lead(rtol):
    """x' = -sign x + 0.3 sin t: x = 0.5 - t + 0.3 (1 - cos t) until it is 0, and then 0."""
    found = clpt.simulate(system(sliding, 1), T, None, [0.5], rtol=rtol, atol=1e-2 * rtol)
    right = np.maximum(0.5 - T + 0.3 * (1.0 - np.cos(T)), 0.0)
    np.testing.assert_allclose(found.states.values[:, 0], right, atol=max(rtol, 1e-8))


QUESTIONS = {  # the same switch at x = 1, asked in other ways: rates 1 below, -2 above
    "sign": lambda x: -0.5 - 1.5 * np.sign(x - 1.0),
    "if": lambda x: 1.0 if x < 1.0 else -2.0,
    "where": lambda x: np.where(x > 1.0, -2.0, 1.0),
    "floor": lambda x: 1.0 - 3.0 * np.floor(x),
    "ceil": lambda x: 4.0 - 3.0 * np.ceil(x),
    "int": lambda x: 1.0 - 3.0 * int(x),
    "div": lambda x: 1.0 - 3.0 * (x // 1.0),
    "row": lambda x: [1.0, -2.0, -2.0][int(x)],
    "row of a truth": lambda x: [1.0, -2.0][int(x > 1.0)],
    "floor within": lambda x: 1.0 - 3.0 * np.clip(np.floor(x), 0.0, 1.0),
    "heaviside": lambda x: 1.0 - 3.0 * np.heaviside(x - 1.0, 0.5),
    "copysign": lambda x: -0.5 - 1.5 * np.copysign(1.0, x - 1.0),
    "signbit": lambda x: -2.0 + 3.0 * np.signbit(x - 1.0),
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_every_kind_of_switch_may_be_slid_on(question):
    """Half way x' is also t - 1.5 along the switch: y' = x - 1 + w (-2 - 1), w = 1/3."""
    f = QUESTIONS[question]
    x = rest_of(lambda t, x, u, p: [f(x[0]), f(x[0])], [0.5, 0.0])
    np.testing.assert_allclose(x[:, 0], np.minimum(0.5 + T, 1.0), atol=1e-8)
    np.testing.assert_allclose(x[:, 1], np.minimum(T, 0.5), atol=1e-8)  # the mean rate is 0


def test_sliding_control_moves_as_the_switch_says():
    """On s = v + x the plant is x' = -x, whatever pushes it by less than the gain."""
    x = rest_of(lambda t, x, u, p: [x[1], -2.0 * np.sign(x[0] + x[1]) + np.sin(3 * t)], [1.0, 0.0])
    on = T >= 1.0
    np.testing.assert_allclose(x[on, 1], -x[on, 0], atol=1e-8)
    np.testing.assert_allclose(x[on, 0], x[on, 0][0] * np.exp(1.0 - T[on]), atol=1e-9)


def test_dry_friction_sticks_and_slips():
    """v' = sin t - 0.5 sign v, from v = 0.1: it sticks until sin t = 0.5, t = pi/6."""
    times = np.linspace(0.0, 2.0, 201)
    v = rest_of(lambda t, x, u, p: [np.sin(t) - 0.5 * np.sign(x[0])], [0.1], times)[:, 0]
    braked = np.maximum(1.1 - np.cos(times) - 0.5 * times, 0.0)
    since = np.maximum(times, np.pi / 6)
    right = braked * (times < 0.4) + np.cos(np.pi / 6) - np.cos(since) - 0.5 * (since - np.pi / 6)
    np.testing.assert_allclose(v, right, atol=1e-8)


def test_a_switch_that_is_bent_is_slid_along():
    """On r = 1 the angle moves by theta' = 1 - 0.3 sin theta."""

    def ring(t, x, u, p):
        inward = np.sign(x[0] ** 2 + x[1] ** 2 - 1.0)
        return [-x[1] - x[0] * inward + 0.3, x[0] - x[1] * inward]

    times = np.linspace(0.0, 8.0, 81)
    loose = clpt.simulate(system(ring, 2), times, None, [0.2, 0.1], rtol=1e-3, atol=1e-6)
    assert loose.attrs["solver_steps"] < 20_000  # is told from a switch that is crossed
    x = rest_of(ring, [0.6, 0.8], times)
    np.testing.assert_allclose(x[:, 0] ** 2 + x[:, 1] ** 2, 1.0, atol=1e-8)
    theta = scipy.integrate.solve_ivp(
        lambda t, a: 1.0 - 0.3 * np.sin(a), (0.0, 8.0), [np.arctan2(0.8, 0.6)],
        t_eval=times, rtol=1e-10, atol=1e-12,
    ).y[0]  # fmt: skip
    np.testing.assert_allclose(x, np.transpose([np.cos(theta), np.sin(theta)]), atol=1e-7)


def test_several_switches_are_slid_on_at_once():
    """Each axis by itself, and one that pushes the other by less than its gain."""

    def axes(t, x, u, p):
        push = np.array([np.sin(t), np.cos(2 * t), 0.3])
        return (
            -np.array([1.5, 2.5, 3.0]) * np.sign(x)
            + push
            + np.array([0.0, 0.4, 0.0]) * np.sign(x[0])
        )

    x = rest_of(axes, [0.3, -0.2, 0.4])
    np.testing.assert_allclose(x[T >= 1.0], 0.0, atol=1e-8)


def test_a_question_about_other_questions_follows_them():
    """What is asked of two switches slides on one of them, until the other has turned, t = 2."""

    def voted(t, x, u, p):
        votes = np.sign(x[0]) + 2.0 * (x[1] < 0.0)
        return [-1.0 if votes > 0.0 else 1.0, -0.5]

    x = rest_of(voted, [0.5, 1.0])[:, 0]
    right = np.where(T < 2.0, np.maximum(0.5 - T, 0.0), 2.0 - T)
    np.testing.assert_allclose(x, right, atol=1e-8)


def test_a_run_that_winds_into_a_corner_is_told():
    """Rates turn about x = y = 0 and lead inward; on one switch alone no run stays."""

    def winding(t, x, u, p):
        a, b = np.sign(x)
        return [2.0 * b - a, -2.0 * a - b]

    with pytest.raises(SimulationError, match="switches to and fro without going on; give"):
        run(winding, [0.3, 0.1])


def test_what_switches_do_together_is_slid_on_one_after_the_other():
    def together(t, x, u, p):
        a, b = np.sign(x)
        return [-a + 0.4 * np.cos(t) + 0.2 * a * b, -2.0 * b + np.sin(t)]

    x = rest_of(together, [0.5, -0.7])
    np.testing.assert_allclose(x[T >= 1.5], 0.0, atol=1e-8)


def test_inputs_that_jump_and_bend_end_what_slides():
    """x' = -3 sign(x - r): x follows r where |r'| < 3, and goes to it by 3 where r jumps."""
    follower = control.nlsys(
        lambda t, x, u, p: [-3.0 * np.sign(x[0] - u[0])], inputs=1, outputs=1, states=1, name="s"
    )
    times = np.array([0.0, 1.0, 2.0, 2.0 + 1e-9, 3.0, 4.0])
    r = np.array([0.0, 2.0, 0.0, 1.5, 1.5, 1.5])
    found = clpt.simulate(follower, times, r, [0.0]).states.values[:, 0]
    np.testing.assert_allclose(found, [0.0, 2.0, 0.0, 0.0, 1.5, 1.5], atol=1e-7)


def test_states_that_jump_leave_the_switch():
    """x' = -sign x; at t = 2 and 4 x jumps up by 0.5, and is back at 0 half a unit later."""
    block = clpt.Block(
        "b",
        update=lambda t, x, u, p: {"x": -np.sign(x.x)},
        states={"x": 1},
        parameters={"interval": -1.0},
        breakpoints=lambda p, t0, t1: np.array([t for t in (2.0, 4.0) if t0 < t <= t1]),
        jump=lambda t, x, u, p: {"x": x.x + 0.5},
    )
    times = np.linspace(0.0, 6.0, 61)
    found = clpt.simulate(block, times, None, [0.25]).x.values.ravel()
    since = np.where(times < 2.0, times + 0.25, (times - 2.0) % 2.0)
    np.testing.assert_allclose(
        found, np.where(times < 6.0, np.maximum(0.5 - since, 0.0), 0.0), atol=1e-8
    )


def test_members_slide_as_runs_do():
    falling = control.nlsys(
        lambda t, x, u, p: [-p["k"] * np.sign(x[0])],
        inputs=0, outputs=1, states=["x"], params={"k": 1.0}, name="falling",
    )  # fmt: skip
    k = np.array([0.1, 0.5, 1.0, 2.0, 3.0])
    many = clpt.run_ensemble(falling, {"k": k}, timepts=[0.0, 1.0, 2.0], initial_state=[1.0])
    assert np.all(many.status == 1)
    np.testing.assert_allclose(many.y_final.values.ravel(), np.maximum(1 - 2 * k, 0), atol=1e-8)
    by = clpt.sensitivity(falling, [0.0, 0.5, 0.9], "states", ["k", "x0"], None, [1.0]).states
    np.testing.assert_allclose(by.values[:, 0], [[0.0, 1.0], [-0.5, 1.0], [-0.9, 1.0]], atol=1e-6)
    with pytest.raises(clpt.SimulationError, match="do not confirm its derivative by k"):
        clpt.sensitivity(falling, [0.0, 0.5, 2.0], "states", ["k", "x0"], None, [1.0])


def test_a_guard_ends_what_slides():
    """y' = 1 on the switch x = 0, until y = 0.75."""

    def update(t, x, u, p):
        return {"x": -np.sign(x.x), "y": 1.0}

    above = Guard(lambda t, x, u, p: 0.75 - x.y, "stop", lambda t, u, p: f"at {t:.6f}")
    block = clpt.Block("b", update=update, states={"x": 1, "y": 1}, guard=above)
    found = clpt.simulate(block, T, None, [0.25, 0.0])
    assert found.attrs["message"] == "stopped: at 0.750000"
    np.testing.assert_allclose(found.y.values.ravel()[-1], 0.75, atol=1e-8)


EMPTYING = {  # Torricelli: beyond the switch the rate has no value, or no slope
    "if": lambda t, x, u, p: [-p["k"] * np.sqrt(x[0])] if x[0] >= 0 else [0.0],
    "max": lambda t, x, u, p: [-p["k"] * np.sqrt(max(x[0], 0.0))],
    "sign": lambda t, x, u, p: [-p["k"] * np.sqrt(abs(x[0])) * np.sign(x[0])],
}


@pytest.mark.parametrize("name", EMPTYING)
def test_a_tank_that_runs_empty_stays_so(name):
    """x = (1 - k t/2)^2 until it is empty, one by one and in lanes."""
    tank = control.nlsys(
        EMPTYING[name], states=["x"], inputs=0, outputs=["x"], params={"k": 1.0}, name="tank"
    )
    times = np.linspace(0.0, 3.0, 31)
    right = np.maximum(1.0 - times / 2, 0.0) ** 2
    run = clpt.simulate(tank, times, initial_state=[1.0])
    assert run.attrs["engine"] == "native"
    np.testing.assert_allclose(run.x.values.ravel(), right, atol=1e-8)
    k = np.array([0.5, 1.0, 2.0, 3.0])
    many = clpt.run_ensemble(tank, {"k": k}, timepts=times, initial_state=[1.0])
    assert np.all(many.status == 1)
    np.testing.assert_allclose(many.x_final, np.maximum(1.0 - 1.5 * k, 0.0) ** 2, atol=1e-8)


def test_what_has_no_value_on_either_side_is_still_told():
    f = control.nlsys(
        lambda t, x, u, p: [np.log(x[0]) if x[0] > -1 else 0.0],
        states=["x"], inputs=0, outputs=0, name="falling",
    )  # fmt: skip
    with pytest.raises(SimulationError, match="derivative of x of block falling is not finite"):
        clpt.simulate(f, [0.0, 3.0], initial_state=[0.5])


def test_a_root_of_a_magnitude_that_begins_at_zero_goes_on():
    """Bouc and Wen's hysteresis at rest: |z|^0.5 has no value where the sign of z is held."""

    def rate(t, x, u, p):
        q, v, z = x
        slip = 0.6 * np.abs(v) * np.abs(z) ** 0.5 * z + 0.3 * v * np.abs(z) ** 1.5
        return [v, np.sin(t) - 0.2 * v - q - 0.5 * z, v - slip]

    system = control.nlsys(rate, None, inputs=0, outputs=3, states=["q", "v", "z"], name="bouc")
    times = np.linspace(0.0, 5.0, 51)
    run = clpt.simulate(system, times, None, [0.01, 0.0, 0.0])
    assert "switches not located" in run.attrs["method"]
    close = {"rtol": 1e-10, "atol": 1e-12}
    theirs = control.input_output_response(
        system, times, 0, [0.01, 0.0, 0.0], solve_ivp_kwargs=close
    )
    np.testing.assert_allclose(run.states.values, theirs.states.T, atol=1e-6)
    many = clpt.run_ensemble(system, {"q": [0.01]}, timepts=times, initial_state=[0.0, 0.0, 0.0])
    np.testing.assert_allclose(many.y_final.values[0], run.states.values[-1], atol=1e-7)
