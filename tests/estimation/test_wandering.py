"""How a current wanders, and a filter of one kind against the whole regression."""

import numpy as np
import pytest
from scipy.linalg import expm
from synthetic_vehicle import vehicle

from clpt_control.estimation import kalman
from clpt_control.estimation.dive import mid_time, miss
from clpt_control.estimation.fix_model import FixModel
from clpt_control.estimation.kalman import mixed, wander
from clpt_control.estimation.priors import QUARTER_DAY, Kind, Priors

PRIORS = Priors()
KINDS = Kind(*np.array(PRIORS.kinds).T)


@pytest.mark.parametrize("dt", [0.0, 600.0, 14400.0, 6e4])
def test_a_step_is_the_stochastic_equation_integrated(dt):
    """F and Q by the matrix exponential of the continuous equation (C. F. Van Loan, 1978)."""
    grid = KINDS
    F, Q = wander(dt, grid, PRIORS)
    for k in range(len(grid.walk)):
        A, noise = np.zeros((3, 3)), np.zeros((3, 3))  # (a, v, u) of one axis
        A[0, 0], A[1, 1], A[2, 0] = -1 / PRIORS.trend_fading, -1 / PRIORS.eddy_memory, 1
        noise[0, 0] = 2 * (grid.trend[k] / QUARTER_DAY) ** 2 / PRIORS.trend_fading
        noise[1, 1] = 2 * grid.eddy[k] ** 2 / PRIORS.eddy_memory
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
        assert np.linalg.eigvalsh(wander(dt, KINDS, PRIORS)[1]).min() > -1e-15


@pytest.mark.parametrize("kind", ["walk", "trend", "eddy"])
def test_a_filter_is_the_regression_on_all_dives(kind):
    """The same Gaussian problem, solved at once with its whole covariance."""
    q, A, S, s = 0.02, 0.03 * (kind == "trend"), 0.1 * (kind == "eddy"), 0.01
    priors = Priors(kinds=(Kind(q, A, S, s),), eddy_memory=3e4)
    model = FixModel(("steady",), priors=priors)
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
        F[:6, :6], Q[:6, :6] = (a[0] for a in wander(dt, bank.kinds, priors))
        Q[6, 6] = priors.speed_walk**2 * dt / QUARTER_DAY
        Q[7, 7] = priors.compass_walk**2 * dt / QUARTER_DAY
        for j in range(k):
            blocks[k, j] = F @ blocks[k - 1, j]
            blocks[j, k] = blocks[k, j].T
        blocks[k, k] = F @ blocks[k - 1, k - 1] @ F.T + Q
    prior = np.block([[blocks[i, j] for j in range(K)] for i in range(K)])
    H = np.zeros((2 * K, n * K))
    for k, dive in enumerate(dives):
        H[2 * k : 2 * k + 2, n * k : n * k + n] = kalman.with_hidden(model.regressor(dive))
    noise = np.repeat([priors.fix**2 + (s * d.duration) ** 2 for d in dives], 2)
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
