"""Parts against closed forms, python-control and SciPy."""

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control import parts

TIGHT = {"rtol": 1e-11, "atol": 1e-12}
every_engine = pytest.mark.parametrize("engine", ["native", "python"])
TIMES = np.linspace(0.0, 10.0, 501)


def run(system, times, *given, **options):
    return clpt.simulate(system, times, *given, **{**TIGHT, **options})


# --- limits -------------------------------------------------------------------------------------


def test_limits_and_gaps_are_numpys():
    u = np.linspace(-3, 3, 61)
    low, high = -1.0, 0.5
    limit, gap = (
        parts.saturation(low, high, signals=61),
        parts.dead_zone(low, high, signals=61),
    )
    np.testing.assert_array_equal(limit.output(0, [], u), np.clip(u, low, high))
    np.testing.assert_array_equal(gap.output(0, [], u) + np.clip(u, low, high), u)
    slope = np.where(u < low, u - low, np.where(u > high, u - high, 0.0))
    np.testing.assert_allclose(gap.output(0, [], u), slope, atol=1e-15)


def table():
    """It is linear between its points."""
    at, values, u = (
        [-1.0, 0.0, 0.5, 3.0],
        [2.0, 0.0, 1.0, -4.0],
        np.linspace(-2, 4, len(TIMES)),
    )
    return parts.lookup_table(at, values), [u], {"y": (np.interp(u, at, values), 1e-12)}


def rate_limit(rise=0.5, T=0.2, wanted=2.0):
    """A ramp and then a lag, once the rate is less than the limit."""
    end = (wanted - rise * T) / rise
    exact = np.where(
        end > TIMES, rise * TIMES, wanted - rise * T * np.exp(-(TIMES - end) / T)
    )
    return parts.rate_limit(rise, lag=T), wanted, {"y": (exact, 1e-9)}


def backlash(width=1.0, T=0.05, slope=0.4):
    """On a ramp s t: from t0 = w/(2 s) on y = s (t - t0) - s T (1 - exp(-(t - t0)/T))."""
    since = np.maximum(TIMES - width / 2 / slope, 0.0)
    exact = slope * since - slope * T * (1 - np.exp(-since / T))
    return parts.backlash(width, lag=T), [slope * TIMES], {"y": (exact, 1e-9)}


def lag():
    return parts.lag(2.0, gain=3.0), 1.0, {"y": (3 * (1 - np.exp(-TIMES / 2)), 1e-10)}


def point_vehicle(m=60.0, d=30.0, F=15.0, c=0.2):
    v = F / d * (1 - np.exp(-d / m * TIMES))
    exact = {"v": (v, 1e-10), "x": ((c + F / d) * TIMES - m / d * v, 1e-9)}
    return parts.point_vehicle(m, d, axes=1), [F, c], exact


def quadratic_drag(m=60.0, q=20.0, F=15.0):
    exact = np.sqrt(F / q) * np.tanh(np.sqrt(F * q) / m * TIMES)
    return parts.point_vehicle(m, 0.0, q, axes=1), [F, 0.0], {"v": (exact, 1e-9)}


def thrusters():
    """They push and turn."""
    places, angles = [(-0.8, -0.2), (-0.8, 0.2), (1.0, 0.0)], [0.0, 0.0, np.pi / 2]
    block = parts.thrusters(places, angles, -10, 20, lag=0.5)
    a, b, c = np.outer([20.0, 10.0, -4.0], 1 - np.exp(-TIMES / 0.5))
    exact = np.transpose([a + b, c, 0.2 * (a - b) + c])
    return block, [50.0, 10.0, -4.0], {"tau": (exact, 1e-8)}


FORMS = (table, rate_limit, backlash, lag, point_vehicle, quadratic_drag, thrusters)


@every_engine
@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.__name__)
def test_a_part_is_its_closed_form(form, engine):
    part, inputs, exact = form()
    found = run(part, TIMES, inputs, engine=engine)
    for port, (values, tolerance) in exact.items():
        np.testing.assert_allclose(found[port], values, atol=tolerance)


def test_a_sampled_rate_limit_falls_at_its_own_rate():
    times, u = 0.5 * np.arange(9), [[0, 3, 3, 3, 3, -1, -1, -1, 0.4]]
    found = clpt.simulate(parts.rate_limit(2.0, 1.0, dt=0.5), times, u)
    np.testing.assert_allclose(found.y, [0, 1, 2, 3, 3, 2.5, 2, 1.5, 1.0], atol=1e-15)


# --- what remembers -----------------------------------------------------------------------------


def test_sampled_backlash_is_the_play_and_continuous_tends_to_it():
    """After a crest y rests until the input has fallen by the whole width."""
    width, size, dt, times = 0.6, 2.0, 0.01, np.arange(0, 13, 0.01)
    u = size * np.sin(times)
    y = clpt.simulate(parts.backlash(width, dt=dt), times, [u]).y.values
    assert y[times < 3].max() == pytest.approx(size - width / 2, abs=1e-4)
    resting = (times > np.pi / 2) & (times < np.pi - np.arcsin(1 - width / size) - dt)
    assert np.ptp(y[resting]) == 0.0
    falling = (times > 2 * np.pi) & (np.cos(times) < 0) & (u < size - width)
    np.testing.assert_allclose(y[falling], u[falling] + width / 2, atol=1e-4)
    wave = clpt.Block(
        "wave", output=lambda t, x, u, p: 2.0 * np.sin(t), outputs={"u": 1}
    )
    loops = [
        clpt.connect([wave, parts.backlash(width, lag=lag)]) for lag in (0.02, 0.005)
    ]
    far, near = (np.abs(run(loop, times).y.values - y).max() for loop in loops)
    assert near / 0.35 < far < 1.1 * size * 0.02  # T times the largest rate


@every_engine
def test_a_relay_in_a_loop_has_the_period_of_the_textbook(engine):
    """x' = -x + u, u = -sgn with hysteresis h: each half period lasts log((1 + h)/(1 - h))."""
    h, k = 0.3, np.arange(8)
    switch = parts.relay(on=h, off=-h, low=1.0, high=-1.0, lag=1e-3, u="x", y="u")
    loop = clpt.connect([switch, parts.lag(1.0, u="u", y="x")])
    # the first from 0 up to h
    turns = np.log(1 / (1 - h)) + k * np.log((1 + h) / (1 - h))
    times = np.array([0.0, *np.sort([*turns, *(turns + 0.1)])])
    turning, after = (
        run(loop, times, engine=engine).x.values[1:].reshape(8, 2).T * (-1.0) ** k
    )
    np.testing.assert_allclose(turning, h, atol=1e-8)
    np.testing.assert_allclose(after, h + (-1 - h) * (1 - np.exp(-0.1)), atol=1e-8)


def test_a_sampled_relay_keeps_in_between():
    times = np.arange(0, 20, 0.05)
    u = np.sin(times) + 0.3 * np.sin(3.1 * times)
    found = clpt.simulate(
        parts.relay(0.6, -0.4, 2.0, 5.0, dt=0.05), times, [u]
    ).y.values
    closed, wanted = False, []
    for value in u:
        closed = value > 0.6 or (closed and value >= -0.4)
        wanted.append(5.0 if closed else 2.0)
    np.testing.assert_array_equal(found, wanted)


# --- delays -------------------------------------------------------------------------------------


@pytest.mark.parametrize("order", [1, 2, 3, 5, 8, 40])
def test_a_continuous_delay_is_pades(order):
    """One of high order, which python-control's cannot be, is the delay itself."""
    T, s = 0.7, 1j * np.logspace(-2, 2 if order < 9 else 1.5, 40)
    linear, n = (
        clpt.linearize(parts.delay(T, order), np.zeros(order), [0.0]),
        min(order, 8),
    )
    exact = control.tf(*control.pade(T, n, n - 1))(s) if order < 9 else np.exp(-s * T)
    np.testing.assert_allclose(
        linear(s).squeeze(), exact, atol=1e-10 if order < 9 else 1e-8
    )
    low = s[np.abs(s) * T < order / 2]
    assert np.abs(linear(low).squeeze() - np.exp(-low * T)).max() < (
        0.11 if order == 1 else 0.03
    )
    assert np.all(linear.poles().real < 0)


def test_a_sampled_delay_in_a_continuous_loop_is_exact():
    """A sampled gain, late by two samples, around an integrator."""
    dt, times = 0.5, 0.5 * np.arange(40)
    gain = control.tf([0.3], [1], dt, inputs="e", outputs="u", name="gain")
    error = control.summing_junction(["r", "-y"], "e", name="error")
    plant = control.ss(0, 1, 1, 0, inputs="v", outputs="y", name="plant")
    loop = clpt.connect(
        [error, gain, parts.delay(1.0, dt=dt, u="u", y="v"), plant], external="r"
    )
    y, line = [0.0], [0.0, 0.0]
    for _ in times[1:]:
        line = [0.3 * (1 - y[-1]), *line]
        y.append(y[-1] + dt * line.pop())
    np.testing.assert_allclose(run(loop, times, 1.0).y, y, atol=1e-9)


def test_a_hold_in_front_of_a_lag_is_c2d():
    dt, T, fine = 0.4, 0.9, np.arange(0, 8, 0.05)
    loop = clpt.connect(
        [parts.hold(dt, y="held"), parts.lag(T, u="held", y="y")], external="u"
    )
    found = run(loop, fine, [np.sin(fine)])
    y, k = [0.0], np.floor(fine / dt + 1e-9)
    for at in range(1, len(fine)):
        held = np.sin(dt * k[at - 1])
        y.append(held + (y[-1] - held) * np.exp(-0.05 / T))
    np.testing.assert_allclose(
        found.held, np.interp(dt * k, fine, np.sin(fine)), atol=1e-12
    )
    np.testing.assert_allclose(found.y, y, atol=1e-9)


# --- PID ----------------------------------------------------------------------------------------


@every_engine
@pytest.mark.parametrize("kd", [0.0, 0.6])
def test_an_unlimited_pid_is_the_transfer_function(engine, kd):
    kp, ki, tf = 2.0, 0.8, 0.1
    names, s = {"inputs": "u", "outputs": "y", "name": "plant"}, control.tf("s")
    plant = control.ss([[0, 1], [-1, -0.4]], [[0], [1]], [[1, 0]], 0, **names)
    ours = clpt.connect([parts.pid(kp, ki, kd, filter=tf), plant], external="r")
    forward = plant * (kp + ki / s)
    closed = forward / (1 + plant * (kp + ki / s + kd * s / (1 + tf * s)))
    expected = control.forced_response(control.ss(closed), TIMES, np.ones(len(TIMES)))
    np.testing.assert_allclose(
        run(ours, TIMES, 1.0, engine=engine).y, expected.y[0], atol=1e-7
    )


def test_an_unlimited_sampled_pid_is_the_transfer_function_in_z():
    kp, ki, kd, tf, dt = 1.2, 0.3, 0.4, 0.2, 0.5
    times, z = dt * np.arange(30), control.tf([1, 0], [1], dt)
    feedback = kp + ki * dt / (z - 1) + kd * (z - 1) / ((tf + dt) * z - tf)
    y = np.random.default_rng(1).standard_normal(len(times))
    found = clpt.simulate(
        parts.pid(kp, ki, kd, filter=tf, dt=dt), times, np.stack([0 * y, y])
    )
    expected = control.forced_response(feedback, times, -y)
    np.testing.assert_allclose(found.u, expected.y.squeeze(), atol=1e-10)


@pytest.mark.parametrize("dt", [None, 0.02])
def test_the_integral_follows_a_limited_command(dt):
    """Without anti-windup the response to a large step overshoots by far; with it, hardly."""
    pids = [
        parts.pid(2, 1, low=-0.5, high=0.5, tracking=t, dt=dt) for t in (1.0, np.inf)
    ]
    tank = control.ss(0, 1, 1, 0, inputs="u", outputs="y", name="tank")
    loops, times = (
        [clpt.connect([one, tank], "r") for one in pids],
        np.linspace(0, 60, 3001),
    )
    with_it, without = (run(loop, times, 10.0, rtol=1e-8) for loop in loops)
    assert np.all(np.abs(with_it.u) <= 0.5)
    assert with_it.y.max() < 10.5 < 15 < without.y.max()
    assert abs(with_it.y[-1] - 10) < 1e-3


def test_back_calculation_settles_where_it_should():
    """While u is limited, I' = Ki e + (high - v)/Tt: v settles at high + Tt Ki e."""
    found = run(parts.pid(2.0, 1.0, high=0.5, tracking=0.2), [0.0, 10.0], [3.0, 0.0])[
        {"time": -1}
    ]
    assert 2.0 * 3.0 + found.states.values[0] == pytest.approx(
        0.5 + 0.2 * 1.0 * 3.0, abs=1e-9
    )
    assert found.u == 0.5


def test_a_sampled_integral_that_is_limited_does_not_run_away():
    """Tt is h at least: I_{k+1} = I_k + h Ki e + (high - I_k) is high + h Ki e while v is above."""
    pid = parts.pid(0.0, 0.01, low=-1, high=1, dt=60.0)
    found = clpt.simulate(pid, 60.0 * np.arange(12), [5.0, 0.0])
    assert found.states[:, 0].values.tolist() == [0.0, 3.0, *[4.0] * 10]
    assert found.u.values.tolist() == [0.0, *[1.0] * 11]


def test_gains_of_two_signs_have_times_of_their_magnitudes():
    made = parts.pid(1.0, -0.1, 0.5).parameters
    assert (made.filter, made.tracking) == pytest.approx((0.05, np.sqrt(5.0)))


@every_engine
@pytest.mark.parametrize("dt", [None, 0.5])
def test_a_gain_of_zero_has_no_state(dt, engine):
    """10 y' = u - y with u = 2 (r - y): y comes to 2/3."""
    loop = clpt.connect([parts.pid(2.0, dt=dt), parts.lag(10.0)], external="r")
    assert run(loop, [0.0, 200.0], 1.0, engine=engine).y[-1] == pytest.approx(2 / 3)
    assert clpt.linearize(loop)["y", "r"].dcgain() == pytest.approx(2 / 3)
    if dt is None:
        assert clpt.lyapunov(loop).implies("asymptotically stable")
    assert [*parts.pid(2.0, dt=dt).state_shapes] == []
    of_a_derivative = ["filtered"] if dt is None else ["derivative", "last"]
    assert [*parts.pid(2.0, 0.0, 1.0, dt=dt).state_shapes] == of_a_derivative


def test_a_gain_of_zero_is_given_to_the_maker():
    loop = clpt.connect([parts.pid(2.0), parts.lag(10.0)], external="r")
    said = r"pid.ki: a gain of 0 is no parameter. Give ki in parts.pid\(..., ki=...\)"
    with pytest.raises(clpt.BlockError, match=said):
        clpt.simulate(loop, [0.0, 1.0], 1.0, params={"pid.ki": 0.1})
    with pytest.raises(clpt.ScenarioError, match=f"vary: {said}"):
        clpt.run_ensemble(loop, {"pid.ki": [0.1]}, timepts=[0.0, 1.0], inputs=1.0)


@pytest.mark.parametrize("dt", [None, 0.5])
def test_a_member_without_integral_charges_none(dt):
    """10 y' = min(1.5 (r - y), 0.8) - y: y comes to 1.5/2.5; with an integral to 0.8."""
    pid = parts.pid(1.5, 0.1, high=0.8, dt=dt)
    loop = clpt.connect([pid, parts.lag(10.0)], external="r")
    times = np.linspace(0.0, 400.0, 801)
    found = clpt.run_ensemble(loop, {"pid.ki": [0.0, 0.1]}, timepts=times, inputs=1.0)
    np.testing.assert_allclose(found.y_final, [0.6, 0.8], atol=1e-7)


# --- values that functions read as numbers --------------------------------------------------------


def branch(t, x, u, p):
    return {"z": -x.z + (2 * u.u if p.k > 1 else 3 * u.u)}


OF_A_BRANCH = clpt.Block(
    "branch",
    update=branch,
    **{"states": {"z": 1}, "inputs": {"u": 1}, "parameters": {"k": 2.0}},
)
TABLE = clpt.parts.lookup_table([0, 1, 2], [0, 1, 4])
BEHIND = clpt.connect([TABLE, clpt.parts.lag(1.0, u="y", y="z")], external="u")
MOVED = {"lookup_table.at": [0, 0.5, 1.5]}
SLOW = 1 - np.exp(-1.0)


def test_a_table_without_a_wire_reads_0():
    table = parts.lookup_table([-1, 0, 1], [-2, 0.5, 2], u="command", y="force")
    lag = control.ss(-1, 1, 1, 0, inputs="force", outputs="z", name="lag")
    wires = [["lag.force", "lookup_table.force[0]"]]
    loop = control.interconnect(
        [lag, table], wires, outputs=["z"], inputs=[], check_unused=False
    )
    run = clpt.simulate(loop, [0, 1])
    np.testing.assert_allclose(run.z, [0.0, 0.5 * SLOW], atol=1e-6)


def test_a_call_may_move_the_points_of_a_table():
    """At u = 0.75 the table has 1 + 3/4; its slope there is 3."""
    at, u = {"params": MOVED}, 0.75
    run = clpt.simulate(TABLE, [0, 1], u, **at)
    assert run.y.values == pytest.approx([1.75, 1.75])
    z = clpt.simulate(BEHIND, [0, 1], u, **at).z.values
    assert z[-1] == pytest.approx(1.75 * SLOW, rel=1e-6)
    of_call = clpt.prepare(BEHIND, [0, 1], u, params={"lookup_table.at": [0, 1, 2]})
    assert of_call(params=MOVED).states[-1, 0] == pytest.approx(1.75 * SLOW, rel=1e-6)
    members = clpt.run_ensemble(
        BEHIND, {"lag.lag": [1.0]}, timepts=[0, 1], inputs=u, **at
    )
    assert members.z_final.values == pytest.approx(1.75 * SLOW, rel=1e-6)
    assert clpt.linearize(TABLE, [], [u], **at).D.item() == pytest.approx(3.0)
    tube = clpt.enclose(BEHIND, [0, 1], [u], [0], **at)
    assert tube.lower[-1, 0] <= 1.75 * SLOW <= tube.upper[-1, 0] < 1.2


def test_a_call_may_choose_another_branch():
    params = {"branch.k": 0.5}
    assert clpt.linearize(OF_A_BRANCH, [0], [0.25], params=params).B.item() == 3.0
    assert clpt.linearize(OF_A_BRANCH, [0], [0.25]).B.item() == 2.0
    z = clpt.simulate(OF_A_BRANCH, [0, 1], 1.0, params=params).z.values
    assert z[-1] == pytest.approx(3 * SLOW, rel=1e-6)
    sampled = clpt.Sampled(OF_A_BRANCH, 0.5)
    z = clpt.simulate(sampled, [0, 0.5], 1.0, params=params).z.values
    assert z[-1] == pytest.approx(1.5)
