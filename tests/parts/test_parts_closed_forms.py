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
    limit, gap = parts.saturation(low, high, signals=61), parts.dead_zone(low, high, signals=61)
    np.testing.assert_array_equal(limit.output(0, [], u), np.clip(u, low, high))
    np.testing.assert_array_equal(gap.output(0, [], u) + np.clip(u, low, high), u)
    slope = np.where(u < low, u - low, np.where(u > high, u - high, 0.0))
    np.testing.assert_allclose(gap.output(0, [], u), slope, atol=1e-15)


@every_engine
def test_a_table_is_linear_between_its_points(engine):
    at, values = [-1.0, 0.0, 0.5, 3.0], [2.0, 0.0, 1.0, -4.0]
    ramp = np.linspace(-2, 4, len(TIMES))
    found = run(parts.lookup_table(at, values), TIMES, [ramp], engine=engine)
    np.testing.assert_allclose(found.y, np.interp(ramp, at, values), atol=1e-12)


@every_engine
def test_a_rate_limit_is_a_ramp_and_then_a_lag(engine):
    rise, T, wanted = 0.5, 0.2, 2.0
    end = (wanted - rise * T) / rise  # from there on the rate is less than the limit
    exact = np.where(end > TIMES, rise * TIMES, wanted - rise * T * np.exp(-(TIMES - end) / T))
    found = run(parts.rate_limit(rise, lag=T), TIMES, wanted, engine=engine)
    np.testing.assert_allclose(found.y, exact, atol=1e-9)


def test_a_sampled_rate_limit_falls_at_its_own_rate():
    times = 0.5 * np.arange(9)
    u = [[0, 3, 3, 3, 3, -1, -1, -1, 0.4]]
    found = clpt.simulate(parts.rate_limit(2.0, 1.0, dt=0.5), times, u)
    np.testing.assert_allclose(found.y, [0, 1, 2, 3, 3, 2.5, 2, 1.5, 1.0], atol=1e-15)


# --- what remembers -----------------------------------------------------------------------------


@every_engine
def test_a_gap_is_crossed_and_then_teeth_carry_along(engine):
    """On a ramp s t: from t0 = w/(2 s) on y = s (t - t0) - s T (1 - exp(-(t - t0)/T))."""
    width, T, slope = 1.0, 0.05, 0.4
    since = np.maximum(TIMES - width / 2 / slope, 0.0)
    exact = slope * since - slope * T * (1 - np.exp(-since / T))
    found = run(parts.backlash(width, lag=T), TIMES, [slope * TIMES], engine=engine)
    np.testing.assert_allclose(found.y, exact, atol=1e-9)


def wave_of(size):
    return clpt.Block("wave", output=lambda t, x, u, p: size * np.sin(t), outputs={"u": 1})


def test_sampled_backlash_is_the_play_and_continuous_tends_to_it():
    """After a crest y rests until the input has fallen by the whole width."""
    width, size, dt = 0.6, 2.0, 0.01
    times = np.arange(0, 13, dt)
    u = size * np.sin(times)
    y = clpt.simulate(parts.backlash(width, dt=dt), times, [u]).y.values
    assert y[times < 3].max() == pytest.approx(size - width / 2, abs=1e-4)
    resting = (times > np.pi / 2) & (times < np.pi - np.arcsin(1 - width / size) - dt)
    assert np.ptp(y[resting]) == 0.0
    late = times > 2 * np.pi
    falling = late & (np.cos(times) < 0) & (u < size - width)
    np.testing.assert_allclose(y[falling], u[falling] + width / 2, atol=1e-4)
    off, wave = [], wave_of(size)
    for lag in (0.02, 0.005):
        close = run(clpt.connect([wave, parts.backlash(width, lag=lag)]), times)
        off.append(np.abs(close.y.values - y).max())
    assert off[0] < 1.1 * size * 0.02  # T times the largest rate
    assert off[1] < 0.35 * off[0]


@every_engine
def test_a_relay_in_a_loop_has_the_period_of_the_textbook(engine):
    """x' = -x + u, u = -sgn with hysteresis h: each half period lasts log((1 + h)/(1 - h))."""
    h = 0.3
    switch = parts.relay(on=h, off=-h, low=1.0, high=-1.0, lag=1e-3, u="x", y="u")
    plant = parts.lag(1.0, u="u", y="x")
    half = np.log((1 + h) / (1 - h))
    first = np.log(1 / (1 - h))  # from 0 up to h
    turns = first + half * np.arange(8)
    times = np.array([0.0, *np.sort([*turns, *(turns + 0.1)])])
    found = run(clpt.connect([switch, plant]), times, engine=engine)
    turning = found.x.values[1::2]
    np.testing.assert_allclose(turning, h * (-1.0) ** np.arange(8), atol=1e-8)
    after = h + (-1 - h) * (1 - np.exp(-0.1))
    np.testing.assert_allclose(found.x.values[2::2], after * (-1.0) ** np.arange(8), atol=1e-8)


def test_a_sampled_relay_keeps_in_between():
    times = np.arange(0, 20, 0.05)
    u = np.sin(times) + 0.3 * np.sin(3.1 * times)
    found = clpt.simulate(parts.relay(0.6, -0.4, 2.0, 5.0, dt=0.05), times, [u]).y.values
    closed, wanted = False, []
    for value in u:
        closed = value > 0.6 or (closed and value >= -0.4)
        wanted.append(5.0 if closed else 2.0)
    np.testing.assert_array_equal(found, wanted)


# --- lags and delays ----------------------------------------------------------------------------


@every_engine
def test_a_lag_is_an_exponential(engine):
    found = run(parts.lag(2.0, gain=3.0), TIMES, 1.0, engine=engine)
    np.testing.assert_allclose(found.y, 3 * (1 - np.exp(-TIMES / 2)), atol=1e-10)


@pytest.mark.parametrize("order", [1, 2, 3, 5, 8, 40])
def test_a_continuous_delay_is_pades(order):
    """One of high order, which python-control's cannot be, is the delay itself."""
    T, s = 0.7, 1j * np.logspace(-2, 2 if order < 9 else 1.5, 40)
    linear = clpt.linearize(parts.delay(T, order), np.zeros(order), [0.0])
    num, den = control.pade(T, min(order, 8), min(order, 8) - 1)
    exact = control.tf(num, den)(s) if order < 9 else np.exp(-s * T)
    np.testing.assert_allclose(linear(s).squeeze(), exact, atol=1e-10 if order < 9 else 1e-8)
    low = s[np.abs(s) * T < order / 2]
    off = np.abs(linear(low).squeeze() - np.exp(-low * T)).max()
    assert off < (0.11 if order == 1 else 0.03)
    assert np.all(linear.poles().real < 0)


def test_a_sampled_delay_in_a_continuous_loop_is_exact():
    """A sampled gain, late by two samples, around an integrator."""
    dt = 0.5
    times = dt * np.arange(40)
    gain = control.tf([0.3], [1], dt, inputs="e", outputs="u", name="gain")
    error = control.summing_junction(["r", "-y"], "e", name="error")
    plant = control.ss(0, 1, 1, 0, inputs="v", outputs="y", name="plant")
    loop = clpt.connect([error, gain, parts.delay(1.0, dt=dt, u="u", y="v"), plant], external="r")
    found = run(loop, times, 1.0)
    y, line = [0.0], [0.0, 0.0]
    for _ in times[1:]:
        line = [0.3 * (1 - y[-1]), *line]
        y.append(y[-1] + dt * line.pop())
    np.testing.assert_allclose(found.y, y, atol=1e-9)


def test_a_hold_in_front_of_a_lag_is_c2d():
    dt, T = 0.4, 0.9
    fine = np.arange(0, 8, 0.05)
    loop = clpt.connect([parts.hold(dt, y="held"), parts.lag(T, u="held", y="y")], external="u")
    found = run(loop, fine, [np.sin(fine)])
    y, k = [0.0], np.floor(fine / dt + 1e-9)
    for at in range(1, len(fine)):
        held = np.sin(dt * k[at - 1])
        y.append(held + (y[-1] - held) * np.exp(-0.05 / T))
    np.testing.assert_allclose(found.held, np.interp(dt * k, fine, np.sin(fine)), atol=1e-12)
    np.testing.assert_allclose(found.y, y, atol=1e-9)


# --- PID ----------------------------------------------------------------------------------------


@every_engine
@pytest.mark.parametrize("kd", [0.0, 0.6])
def test_an_unlimited_pid_is_the_transfer_function(engine, kd):
    kp, ki, tf = 2.0, 0.8, 0.1
    plant = control.ss([[0, 1], [-1, -0.4]], [[0], [1]], [[1, 0]], 0, name="plant")
    plant.set_inputs(["u"])
    plant.set_outputs(["y"])
    ours = clpt.connect([parts.pid(kp, ki, kd, filter=tf), plant], external="r")
    s = control.tf("s")
    forward = plant * (kp + ki / s)
    closed = forward / (1 + plant * (kp + ki / s + kd * s / (1 + tf * s)))
    expected = control.forced_response(control.ss(closed), TIMES, np.ones(len(TIMES)))
    np.testing.assert_allclose(run(ours, TIMES, 1.0, engine=engine).y, expected.y[0], atol=1e-7)


def test_an_unlimited_sampled_pid_is_the_transfer_function_in_z():
    kp, ki, kd, tf, dt = 1.2, 0.3, 0.4, 0.2, 0.5
    times = dt * np.arange(30)
    z = control.tf("z")
    z.dt = dt
    feedback = kp + ki * dt / (z - 1) + kd * (z - 1) / ((tf + dt) * z - tf)
    made = control.tf(feedback.num, feedback.den, dt)
    y = np.random.default_rng(1).standard_normal(len(times))
    block = parts.pid(kp, ki, kd, filter=tf, dt=dt)
    found = clpt.simulate(block, times, np.stack([np.zeros(len(times)), y]))
    expected = control.forced_response(made, times, -y)
    np.testing.assert_allclose(found.u, expected.y.squeeze(), atol=1e-10)


def tank(limit, tracking, dt=None):
    pid = parts.pid(2.0, 1.0, low=-limit, high=limit, tracking=tracking, dt=dt)
    return clpt.connect([pid, control.ss(0, 1, 1, 0, inputs="u", outputs="y", name="tank")], "r")


@pytest.mark.parametrize("dt", [None, 0.02])
def test_the_integral_follows_a_limited_command(dt):
    """Without anti-windup the response to a large step overshoots by far; with it, hardly."""
    times = np.linspace(0, 60, 3001)
    with_it, without = (run(tank(0.5, t, dt), times, 10.0, rtol=1e-8) for t in (1.0, np.inf))
    assert np.all(np.abs(with_it.u) <= 0.5)
    assert without.y.max() > 15
    assert with_it.y.max() < 10.5
    assert abs(with_it.y[-1] - 10) < 1e-3


def test_back_calculation_settles_where_it_should():
    """While u is limited, I' = Ki e + (high - v)/Tt: v settles at high + Tt Ki e."""
    found = run(parts.pid(2.0, 1.0, high=0.5, tracking=0.2), [0.0, 10.0], [3.0, 0.0])
    v = 2.0 * 3.0 + float(found.states[-1, 0])
    assert v == pytest.approx(0.5 + 0.2 * 1.0 * 3.0, abs=1e-9)
    assert float(found.u[-1]) == 0.5


def test_a_sampled_integral_that_is_limited_does_not_run_away():
    """Tt is h at least: I_{k+1} = I_k + h Ki e + (high - I_k) is high + h Ki e while v is above."""
    pid = parts.pid(0.0, 0.01, low=-1, high=1, dt=60.0)
    found = clpt.simulate(pid, 60.0 * np.arange(12), [5.0, 0.0])
    assert found.states[:, 0].values.tolist() == [0.0, 3.0, *[4.0] * 10]
    assert found.u.values.tolist() == [0.0, *[1.0] * 11]


def test_gains_of_two_signs_have_times_of_their_magnitudes():
    made = parts.pid(1.0, -0.1, 0.5).parameters
    assert (made.filter, made.tracking) == pytest.approx((0.05, np.sqrt(5.0)))
