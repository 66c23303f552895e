"""Parts against closed forms, python-control and SciPy."""

import pickle

import control
import numpy as np
import pytest
from package_blocks import BLOCKS
from scipy.integrate import solve_ivp
from scipy.linalg import expm

import clpt_control as clpt
from clpt_control import parts
from clpt_control.errors import ArgumentError, BlockError

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


def test_a_relay_switches_where_it_should():
    """The integral of y over a period of a sine is low and high times the time spent in each."""
    on, off = 0.8, -0.5
    switch = parts.relay(on, off, low=0.0, high=1.0, lag=1e-3, u="u", y="y")
    area = control.ss(0, 1, 1, 0, inputs="y", outputs="area", name="area")
    found = run(clpt.connect([wave_of(1.0), switch, area]), [0, 2 * np.pi, 4 * np.pi])
    closed = np.pi + np.arcsin(-off) - np.arcsin(on)
    assert float(found.area[2] - found.area[1]) == pytest.approx(closed, abs=1e-8)


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


@pytest.mark.parametrize("order", [1, 2, 3, 5, 8])
def test_a_continuous_delay_is_pades(order):
    T = 0.7
    block = parts.delay(T, order)
    linear = clpt.linearize(block, np.zeros(order), [0.0])
    num, den = control.pade(T, order, order - 1)
    s = 1j * np.logspace(-2, 2, 40)
    np.testing.assert_allclose(linear(s).squeeze(), control.tf(num, den)(s), atol=1e-10)
    low = s[np.abs(s) * T < order / 2]
    np.testing.assert_allclose(
        linear(low).squeeze(), np.exp(-low * T), atol=0.11 if order == 1 else 0.03
    )
    assert np.all(linear.poles().real < 0)


def test_a_delay_of_high_order_stays_itself():
    T, order = 1.0, 40
    linear = clpt.linearize(parts.delay(T, order), np.zeros(order), [0.0])
    s = 1j * np.linspace(0, 30, 50)
    np.testing.assert_allclose(linear(s).squeeze(), np.exp(-s * T), atol=1e-8)


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
    rng = np.random.default_rng(1)
    y = rng.standard_normal(len(times))
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
    block = parts.pid(2.0, 1.0, high=0.5, tracking=0.2)
    found = run(block, [0.0, 10.0], [3.0, 0.0])
    v = 2.0 * 3.0 + float(found.states[-1, 0])
    assert v == pytest.approx(0.5 + 0.2 * 1.0 * 3.0, abs=1e-9)
    assert float(found.u[-1]) == 0.5


# --- estimators ---------------------------------------------------------------------------------

A, B, C = np.array([[0.0, 1.0], [-1.0, 0.3]]), np.array([[0.0], [1.0]]), np.array([[1.0, 0.0]])
Q, R = np.array([[0.3, 0.1], [0.1, 0.5]]), np.array([[0.2]])


def test_the_error_of_an_observer_decays_by_its_poles():
    L = control.place(A.T, C.T, [-2.0, -3.0]).T
    plant = control.ss(A, B, C, 0, inputs="u", outputs="y", name="plant")
    loop = clpt.connect([plant, parts.observer(plant, L)], external="u")
    start = np.array([1.0, -0.5])
    found = run(loop, TIMES, [np.sin(TIMES)], [*start, 0, 0])
    error = found.states.values[:, :2] - found.states.values[:, 2:]
    exact = np.array([expm((A - L @ C) * t) @ start for t in TIMES])
    np.testing.assert_allclose(error, exact, atol=1e-8)


def test_a_kalman_bucy_filter_settles_at_care():
    filter = parts.kalman_filter(control.ss(A, B, C, 0), Q, R, P0=2 * np.eye(2))
    found = run(filter, [0.0, 1.0, 60.0], [0.0, 0.0])
    _, P, _ = control.lqe(A, np.eye(2), C, Q, R)
    np.testing.assert_allclose(found.P[-1].values.reshape(2, 2), P, atol=1e-8)
    np.testing.assert_array_equal(found.P[0].values.reshape(2, 2), 2 * np.eye(2))

    def riccati(t, P):
        P = P.reshape(2, 2)
        return (A @ P + P @ A.T + Q - P @ C.T @ np.linalg.inv(R) @ C @ P).ravel()

    exact = solve_ivp(riccati, (0, 1), 2 * np.eye(2).ravel(), rtol=1e-11, atol=1e-12).y[:, -1]
    np.testing.assert_allclose(found.P[1].values.ravel(), exact, atol=1e-8)


def test_a_sampled_kalman_filter_settles_at_dare():
    F = expm(0.1 * A)
    plant = control.ss(F, B, C, 0, 0.1)
    found = clpt.simulate(parts.kalman_filter(plant, Q, R), 0.1 * np.arange(200), [0.0, 1.0])
    L, P, _ = control.dlqe(F, np.eye(2), C, Q, R)
    K = P @ C.T / (C @ P @ C.T + R)
    np.testing.assert_allclose(found.P[-1].values.reshape(2, 2), P - K @ C @ P, atol=1e-10)
    x = found.x_hat[-1].values  # steady: x = F x_hat, x_hat = x + K (1 - C x)
    steady = np.linalg.solve(np.eye(2) - (np.eye(2) - K @ C) @ F, K[:, 0])
    if np.max(np.abs(np.linalg.eigvals((np.eye(2) - K @ C) @ F))) < 0.95:
        np.testing.assert_allclose(x, steady, atol=1e-3)
    np.testing.assert_allclose(F @ K, L, atol=1e-10)


def test_a_filter_is_as_uncertain_as_it_says():
    """Of a random walk seen with noise the mean square error is P."""
    dt, q, r = 1.0, 0.04, 1.0
    times = dt * np.arange(20_000)
    walk = np.cumsum(np.sqrt(q) * np.random.default_rng(2).standard_normal(len(times)))
    noise = clpt.simulate(parts.noise(np.sqrt(r), dt, seed=7), times).n.values
    plant = control.ss(1, 1, 1, 0, dt)
    filter = parts.kalman_filter(plant, [[q]], [[r]])
    found = clpt.simulate(filter, times, np.stack([0 * times, walk + noise]))
    squared = np.mean((found.x_hat.values.squeeze() - walk)[100:] ** 2)
    assert squared == pytest.approx(float(found.P.values.squeeze()[-1]), rel=0.05)


def test_noise_is_the_same_everywhere_and_a_signals_own():
    """Of the hash `blocks/test_blocks_closed_forms` asks whether it is white and normal."""
    source = parts.noise([2.0, 0.5], period=0.1, signals=2, seed=3)
    middles = 0.1 * np.arange(20_000) + 0.05
    found = run(source, middles).n.values
    others = run(source, middles[:500], engine="python").n.values
    np.testing.assert_allclose(found[:500], others, rtol=1e-13)
    np.testing.assert_allclose(found.std(0), [2.0, 0.5], rtol=0.02)
    np.testing.assert_allclose(found.mean(0), 0, atol=0.04)
    other = run(parts.noise(2.0, period=0.1, seed=4), middles).n.values.squeeze()
    for one in (other, found[:, 1]):
        assert abs(np.corrcoef(one, found[:, 0])[0, 1]) < 0.03


# --- vehicles -----------------------------------------------------------------------------------


@every_engine
def test_a_point_vehicle_reaches_its_speed(engine):
    m, d, F, c = 60.0, 30.0, 15.0, 0.2
    found = run(parts.point_vehicle(m, d, axes=1), TIMES, [F, c], engine=engine)
    v = F / d * (1 - np.exp(-d / m * TIMES))
    np.testing.assert_allclose(found.v, v, atol=1e-10)
    np.testing.assert_allclose(found.x, (c + F / d) * TIMES - m / d * v, atol=1e-9)


def test_quadratic_drag_is_a_hyperbolic_tangent():
    m, q, F = 60.0, 20.0, 15.0
    found = run(parts.point_vehicle(m, 0.0, q, axes=1), TIMES, [F, 0.0])
    exact = np.sqrt(F / q) * np.tanh(np.sqrt(F * q) / m * TIMES)
    np.testing.assert_allclose(found.v, exact, atol=1e-9)


M = np.array([[60.0, 0, 0], [0, 90, 5], [0, 5, 20]])
D, QUADRATIC = np.diag([30.0, 60, 20]), np.diag([10.0, 20, 5])


@every_engine
def test_forces_do_the_work_of_a_planar_vehicle(engine):
    """nu^T M nu / 2 grows by nu^T (tau - D nu - Q |nu| nu): C takes and gives nothing."""
    tau, start = np.array([15.0, -4.0, 3.0]), np.array([0.0, 0, 0.3, 0.5, -0.4, 0.6])
    block = parts.planar_vehicle(M, D, QUADRATIC)
    times = np.linspace(0, 10, 4001)
    found = run(block, times, [*tau, 0, 0], start, engine=engine)
    nu = found.nu.values
    energy = 0.5 * np.einsum("ti,ij,tj->t", nu, M, nu)
    power = nu @ tau - np.einsum("ti,ij,tj->t", nu, D, nu)
    power -= np.einsum("ti,ij,tj->t", nu, QUADRATIC, np.abs(nu) * nu)
    h = times[1]
    work = h / 3 * (power[0] + power[-1] + 4 * power[1:-1:2].sum() + 2 * power[2:-1:2].sum())
    assert energy[-1] - energy[0] == pytest.approx(work, abs=1e-8)


def test_a_vehicle_without_forces_keeps_its_momentum():
    """M of a rigid body far from water: momentum over ground stays, and the current adds to it."""
    m, start = 50.0, np.array([1.0, -2.0, 0.4, 0.8, -0.3, 0.7])
    rigid = parts.planar_vehicle(np.diag([m, m, 8.0]), np.zeros((3, 3)))
    found = run(rigid, TIMES, [0, 0, 0, 0.3, -0.1], start)
    c, s = np.cos(0.4), np.sin(0.4)
    speed = np.array([c * 0.8 + s * 0.3 + 0.3, s * 0.8 - c * 0.3 - 0.1])
    exact = start[:2] + TIMES[:, None] * speed
    np.testing.assert_allclose(found.eta.values[:, :2], exact, atol=1e-8)
    np.testing.assert_allclose(found.eta.values[:, 2], 0.4 + 0.7 * TIMES, atol=1e-9)


def test_coriolis_is_fossens_matrix():
    rng = np.random.default_rng(3)
    for _ in range(20):
        nu, tau = rng.standard_normal((2, 3))
        a, b = M[1, 1] * nu[1] + M[1, 2] * nu[2], M[0, 0] * nu[0]
        coriolis = np.array([[0, 0, -a], [0, 0, b], [a, -b, 0]])
        rate = np.linalg.solve(M, tau - coriolis @ nu - D @ nu)
        x, u = [0, 0, rng.normal(), *nu], [*tau, 0, 0]
        block = parts.planar_vehicle(M, D)
        np.testing.assert_allclose(block.dynamics(0, x, u)[3:], rate, atol=1e-12)


def test_the_formulas_of_a_vehicle_are_short():
    nothing = np.zeros((3, 3))
    made = clpt.diagrams.equations(
        clpt.connect([parts.planar_vehicle(M, nothing)], ["tau", "flow"])
    )
    (rate,) = (line for line in str(made).splitlines() if line.startswith("nu[1]'"))
    assert len(rate) < 700
    assert "where" not in str(made)


def test_thrusters_push_and_turn():
    places, angles = [(-0.8, -0.2), (-0.8, 0.2), (1.0, 0.0)], [0.0, 0.0, np.pi / 2]
    block = parts.thrusters(places, angles, -10, 20, lag=0.5)
    found = run(block, TIMES, [50.0, 10.0, -4.0])
    force = np.outer(1 - np.exp(-TIMES / 0.5), [20.0, 10.0, -4.0])
    exact = [
        force[:, 0] + force[:, 1],
        force[:, 2],
        0.2 * (force[:, 0] - force[:, 1]) + force[:, 2],
    ]
    np.testing.assert_allclose(found.tau, np.transpose(exact), atol=1e-8)


@pytest.mark.parametrize("name", [n for n in BLOCKS if n.startswith("parts.") and "noise" not in n])
def test_exact_derivatives_are_those_of_differences(name):
    block = BLOCKS[name]
    rng = np.random.default_rng(4)
    x, u = 0.05 + 0.1 * rng.random(block.nstates or 0), 0.01 + 0.1 * rng.random(block.ninputs or 0)
    exact, rough = clpt.linearize(block, x, u, t=0.3), block.linearize(x, u, t=0.3)
    for matrix in "ABCD":
        off = np.abs(np.asarray(getattr(exact, matrix)) - np.asarray(getattr(rough, matrix)))
        assert off.max(initial=0.0) < 1e-4


def test_a_source_has_nothing_to_linearize_along():
    with pytest.raises(clpt.DiagramError, match="noise: has no states and no inputs"):
        clpt.linearize(parts.noise(1.0, 0.1), [], [], t=0.0)


# --- mistakes, names ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: parts.saturation(1, -1), "saturation: low = 1: must be below high = -1"),
        (lambda: parts.rate_limit(1.0), "give lag, for continuous time, or dt"),
        (lambda: parts.backlash(1.0, lag=1.0, dt=1.0), "give lag, for continuous time, or dt"),
        (lambda: parts.relay(1, 2, lag=0.1), "off = 2: must be below on = 1"),
        (lambda: parts.delay(1.0, dt=0.3), "delay = 1.0: must be a multiple of dt = 0.3"),
        (lambda: parts.lag(0.0), "lag = 0.0: must be positive"),
        (lambda: parts.saturation([0, 1], 3, signals=3), "must be one number, or 3"),
        (lambda: parts.saturation(-1, 1, v="x"), "has no port 'v'; it has u, y"),
        (lambda: parts.pid(1, 0.1, hgih=1), "has no port 'hgih'; .* did you mean high"),
        (lambda: parts.lookup_table([0, 0], [1, 2]), "two or more increasing numbers"),
        (lambda: parts.planar_vehicle(np.ones((3, 3)), np.eye(3)), "m12 = m13 = 0"),
        (lambda: parts.kalman_filter(control.ss(-1, 1, 1, 0), [[1]], [[0]]), "positive definite"),
        (
            lambda: parts.kalman_filter(control.ss(-1, 1, 1, 0), [[-1]], [[1]]),
            "Q: must be positive",
        ),
        (lambda: parts.kalman_filter(control.ss(-1, 1, 1, 0), [[1]], [[1]], [[-1]]), "P0: must be"),
    ],
)
def test_mistakes_are_told(make, said):
    with pytest.raises((BlockError, ArgumentError), match=said):
        make()


@pytest.mark.parametrize(
    "made",
    [
        parts.pid(2, 0.7, 0.1, dt=0.1),
        parts.rate_limit(1, dt=0.1),
        parts.backlash(1, dt=0.1),
        parts.relay(1, -1, dt=0.1),
    ],
    ids=lambda one: one.name,
)
def test_the_time_of_sampling_is_no_parameter(made):
    """It changed the equations, while the part sampled as before."""
    changed = {f"{made.name}.dt": 0.2}
    with pytest.raises(clpt.ClptError, match=f"unknown parameter '{made.name}.dt'"):
        clpt.simulate(made, [0.0, 0.1, 0.2], [1.0] * made.ninputs, params=changed)
    pickled = pickle.loads(pickle.dumps(made))
    runs = [clpt.simulate(one, [0.0, 0.1, 0.2], [1.0] * made.ninputs) for one in (made, pickled)]
    assert runs[0].equals(runs[1])


def test_parts_are_wired_by_python_control_as_they_stand():
    limit = parts.saturation(-0.5, 0.5, u="v", y="u")
    plant = control.ss(-1, 1, 1, 0, inputs="u[0]", outputs="y[0]", name="plant")
    wired = control.interconnect([limit, plant], inputs="v[0]", outputs="y[0]")
    theirs = control.input_output_response(
        wired, TIMES, np.ones(len(TIMES)), solve_ivp_kwargs={"rtol": 1e-9, "atol": 1e-10}
    )
    np.testing.assert_allclose(theirs.outputs, 0.5 * (1 - np.exp(-TIMES)), atol=1e-7)


def test_a_block_of_discrete_time_iterates_and_samples():
    def double(t, x, u, p):
        return 2 * x.x + u.u

    twice = clpt.Block("twice", update=double, inputs={"u": 1}, states={"x": 1}, dt=0.5)
    alone = clpt.simulate(twice, [0, 0.5, 1.0], 1.0)
    assert alone.x.values.tolist() == [0, 1, 3]
    theirs = control.input_output_response(twice, np.array([0, 0.5, 1.0]), np.ones(3))
    assert theirs.outputs.tolist() == [0, 1, 3]
    loop = clpt.connect([twice, parts.lag(1.0, u="x", y="y")], external="u")
    held = clpt.simulate(loop, [0, 0.25, 0.5, 0.75, 1.0], 1.0)
    assert held.x.values.tolist() == [0, 0, 1, 1, 3]
    assert twice.copy(name="other").dt == 0.5
    with pytest.raises(BlockError, match="dt = -1"):
        clpt.Block("twice", update=double, inputs={"u": 1}, states={"x": 1}, dt=-1)
    with pytest.raises(BlockError, match="no breakpoints"):
        clpt.Block(
            "twice",
            update=double,
            inputs={"u": 1},
            states={"x": 1},
            dt=1.0,
            parameters={"interval": -1.0},
            breakpoints=lambda p, a, b: np.zeros(0),
        )
