"""How a current wanders, and a filter of one kind against the whole regression."""

import numpy as np
import pytest
from scipy.linalg import expm
from synthetic_vehicle import vehicle

from clpt_control.estimation import kalman
from clpt_control.estimation.fix_model import FIX, FixModel, mid_time, miss
from clpt_control.estimation.held import LEARNED, hold
from clpt_control.estimation.mixture import mixed
from clpt_control.estimation.wandering import QUARTER_DAY, TREND_FADING, Kinds, kinds, wander


@pytest.mark.parametrize("dt", [0.0, 600.0, 14400.0, 6e4])
def test_a_step_is_the_stochastic_equation_integrated(dt):
    """F and Q by the matrix exponential of the continuous equation (C. F. Van Loan, 1978)."""
    grid = kinds()
    F, Q = wander(dt, grid)
    for k in range(len(grid.walk)):
        A, noise = np.zeros((3, 3)), np.zeros((3, 3))  # (a, v, u) of one axis
        A[0, 0], A[1, 1], A[2, 0] = -1 / TREND_FADING, -1 / grid.memory[k], 1
        noise[0, 0] = 2 * (grid.trend[k] / QUARTER_DAY) ** 2 / TREND_FADING
        noise[1, 1] = 2 * grid.eddy[k] ** 2 / grid.memory[k]
        noise[2, 2] = grid.walk[k] ** 2 / QUARTER_DAY
        whole = expm(dt * np.block([[-A, noise], [np.zeros((3, 3)), A.T]]))
        step = whole[3:, 3:].T
        for axis in (0, 1):
            one = np.ix_([k], [axis, axis + 2, axis + 4], [axis, axis + 2, axis + 4])
            assert F[one][0] == pytest.approx(step, rel=1e-9, abs=1e-12)
            scale = np.sqrt(np.outer(np.diag(Q[one][0]), np.diag(Q[one][0]))) + 1e-18
            assert (Q[one][0] - step @ whole[:3, 3:]) / scale == pytest.approx(0, abs=2e-4)


def test_covariances_are_covariances():
    for dt in (1.0, 3600.0, 1e5, 1e7):
        assert np.linalg.eigvalsh(wander(dt, kinds())[1]).min() > -1e-15


def one_kind(monkeypatch, walk, trend, eddy, memory, unexplained):
    """Leave a bank one filter only."""
    only = Kinds(*(np.array([a]) for a in (walk, trend, eddy, memory, 0.0)))
    monkeypatch.setattr(kalman, "kinds", lambda: only)
    monkeypatch.setattr(kalman, "UNEXPLAINED", (unexplained,))


@pytest.mark.parametrize("kind", ["walk", "trend", "eddy"])
def test_a_filter_is_the_regression_on_all_dives(monkeypatch, kind):
    """The same Gaussian problem, solved at once with its whole covariance."""
    q, A, S, tau, s = 0.02, 0.03 * (kind == "trend"), 0.1 * (kind == "eddy"), 3e4, 0.01
    one_kind(monkeypatch, q, A, S, tau, s)
    model = FixModel(("steady",))
    dives = vehicle(3, 8, walk=0.02)
    bank = kalman.KalmanBank(model)
    for dive in dives:
        bank.update(dive)
    # prior covariance of all states (a, v, u, speed, compass) at all dives, step by step
    n, K = 8, len(dives)
    P = np.diag(np.r_[[A / QUARTER_DAY] * 2, [S] * 2, model.prior_sd]) ** 2
    blocks = {(0, 0): P}
    for k in range(1, K):
        dt = mid_time(dives[k]) - mid_time(dives[k - 1])
        F, Q = np.eye(n), np.zeros((n, n))
        F[:6, :6], Q[:6, :6] = (a[0] for a in wander(dt, bank.kinds))
        Q[6, 6] = kalman.SPEED_WALK**2 * dt / QUARTER_DAY
        Q[7, 7] = kalman.COMPASS_WALK**2 * dt / QUARTER_DAY
        for j in range(k):
            blocks[k, j] = F @ blocks[k - 1, j]
            blocks[j, k] = blocks[k, j].T
        blocks[k, k] = F @ blocks[k - 1, k - 1] @ F.T + Q
    prior = np.block([[blocks[i, j] for j in range(K)] for i in range(K)])
    H = np.zeros((2 * K, n * K))
    for k, dive in enumerate(dives):
        H[2 * k : 2 * k + 2, n * k : n * k + n] = kalman.with_memory(model.regressor(dive))
    noise = np.repeat([FIX**2 + (s * d.duration) ** 2 for d in dives], 2)
    y = np.concatenate([miss(d) for d in dives])
    gain = prior @ H.T @ np.linalg.inv(H @ prior @ H.T + np.diag(noise))
    assert bank.mean[0] == pytest.approx((gain @ y)[-n:], rel=1e-6, abs=1e-9)
    after = (prior - gain @ H @ prior)[-n:, -n:]
    assert bank.covariance[0] == pytest.approx(after, rel=1e-5, abs=1e-10)


def test_covariances_stay_whole_over_a_thousand_dives():
    bank = kalman.KalmanBank(FixModel())
    for dive in vehicle(1, 1000, walk=0.03, noise=0.01):
        bank.update(dive)
    size = np.sqrt(np.diagonal(bank.covariance, axis1=1, axis2=2)) + 1e-12
    correlation = bank.covariance / size[:, :, None] / size[:, None, :]
    assert np.abs(correlation - correlation.transpose(0, 2, 1)).max() < 1e-8
    assert np.linalg.eigvalsh(correlation).min() > -1e-7
    assert np.isfinite(bank.mean).all()


def test_holding_is_conditioning():
    """Held at zero with the prior's variance: as if they had never been asked for."""
    rng = np.random.default_rng(1)
    H, sd = rng.normal(size=(40, 3)), np.array([1.0, 1.0, 1e-3])  # the third is not excited
    y = H @ np.array([0.5, -0.2, 0.0]) + 0.1 * rng.normal(size=40)
    P = np.linalg.inv(H.T @ H / 0.01 + np.diag(sd**-2.0))
    mean, covariance, learned = hold((P @ H.T @ y / 0.01)[None], P[None], sd[None])
    assert learned.tolist() == [[True, True, False]]
    two = np.linalg.inv(H[:, :2].T @ H[:, :2] / 0.01 + np.eye(2))
    assert mean[0, :2] == pytest.approx(two @ H[:, :2].T @ y / 0.01, rel=1e-9)
    assert mean[0, 2] == 0
    assert covariance[0, 2, 2] == pytest.approx(1e-6)
    assert np.all(np.diag(P)[:2] < LEARNED)


def test_what_is_held_hangs_together_with_what_is_learned():
    """Against samples: l drawn as the data leave it, h as it was before."""
    rng = np.random.default_rng(3)
    A = rng.normal(size=(3, 3))
    P = A @ A.T * np.array([[0.05, 0.2, 0.2], [0.2, 1, 1], [0.2, 1, 1]])
    sd = np.array([10.0, *np.sqrt(np.diag(P)[1:] / 0.8)])  # the first is learned
    mean = rng.normal(size=3)
    held, covariance, learned = hold(mean[None], P[None], sd[None])
    assert learned[0].tolist() == [True, False, False]
    h = sd[1:] * rng.normal(size=(400_000, 2))
    inner = np.linalg.inv(P[1:, 1:])
    error = np.sqrt(P[0, 0] - P[0, 1:] @ inner @ P[1:, 0])
    drawn = mean[0] + (h - mean[1:]) @ inner @ P[1:, 0] + error * rng.normal(size=400_000)
    both = np.column_stack([drawn, h])
    assert both.mean(axis=0) == pytest.approx(held[0], abs=0.02)
    assert np.cov(both.T) == pytest.approx(covariance[0], abs=0.02 * np.abs(covariance).max())


def test_a_mixture_has_the_moments_of_its_samples():
    rng = np.random.default_rng(4)
    means, weights = rng.normal(size=(3, 2)), np.array([0.2, 0.5, 0.3])
    covariances = np.array([np.diag(rng.uniform(0.1, 1, 2)) for _ in weights])
    which = rng.choice(3, 400_000, p=weights)
    drawn = means[which] + np.sqrt(covariances.diagonal(axis1=1, axis2=2))[which] * rng.normal(
        size=(400_000, 2)
    )
    mean, covariance = mixed(means, covariances, weights)
    assert mean == pytest.approx(drawn.mean(axis=0), abs=0.01)
    assert covariance == pytest.approx(np.cov(drawn.T), abs=0.01)
