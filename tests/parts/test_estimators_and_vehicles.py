"""Observers, filters, noise and vehicles against closed forms and SciPy."""

import control
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from test_parts_closed_forms import TIMES, every_engine, run

import clpt_control as clpt
from clpt_control import parts

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
    filter = parts.kalman_filter(control.ss(1, 1, 1, 0, dt), [[q]], [[r]])
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
    nu = run(block, times, [*tau, 0, 0], start, engine=engine).nu.values
    energy = 0.5 * np.einsum("ti,ij,tj->t", nu, M, nu)
    power = nu @ tau - np.einsum("ti,ij,tj->t", nu, D, nu)
    power -= np.einsum("ti,ij,tj->t", nu, QUADRATIC, np.abs(nu) * nu)
    h = times[1]
    work = h / 3 * (power[0] + power[-1] + 4 * power[1:-1:2].sum() + 2 * power[2:-1:2].sum())
    assert energy[-1] - energy[0] == pytest.approx(work, abs=1e-8)


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


def test_thrusters_push_and_turn():
    places, angles = [(-0.8, -0.2), (-0.8, 0.2), (1.0, 0.0)], [0.0, 0.0, np.pi / 2]
    found = run(parts.thrusters(places, angles, -10, 20, lag=0.5), TIMES, [50.0, 10.0, -4.0])
    force = np.outer(1 - np.exp(-TIMES / 0.5), [20.0, 10.0, -4.0])
    exact = [
        force[:, 0] + force[:, 1],
        force[:, 2],
        0.2 * (force[:, 0] - force[:, 1]) + force[:, 2],
    ]
    np.testing.assert_allclose(found.tau, np.transpose(exact), atol=1e-8)
