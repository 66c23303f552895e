"""Gaussian processes of dives against quadrature, direct regression and made vehicles."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.stats import multivariate_normal, multivariate_t
from synthetic_vehicle import further, vehicle

from clpt_control.base.units import DAY
from clpt_control.ocean.estimation.fix_model import (
    FixModel,
    Priors,
    Sea,
    inertial_frequency,
)
from clpt_control.ocean.estimation.process_mixture import (
    DROPPED,
    LENGTH,
    MOST,
    ProcessMixture,
    integral_covariance,
    position_covariance,
)
from clpt_control.replay import replay_dives


def taught(model, dives):
    """A mixture that has learned dives."""
    mixture = ProcessMixture(model)
    for dive in dives:
        mixture.update(dive)
    return mixture


def matern(lag, tau, smooth):
    """Covariance of a unit current over a lag."""
    v = np.sqrt(3) * abs(lag) / tau
    return (1 + v) * np.exp(-v) if smooth else np.exp(-abs(lag) / tau)


def by_quadrature(interval, other, tau, smooth):
    """Double integral of the covariance over two intervals: of each lag, times its frequency."""
    (a, b), (c, d) = interval, other

    def weighted(lag):  # lag = t - s with t in [a, b] and s in [c, d]
        return max(min(b, d + lag) - max(a, c + lag), 0.0) * matern(lag, tau, smooth)

    corners = sorted({a - d, a - c, b - d, b - c, 0.0})
    limits = [lag for lag in corners if a - d <= lag <= b - c]
    pairs = pairwise(limits)
    return sum(quad(weighted, *pair, epsabs=0, epsrel=1e-11)[0] for pair in pairs)


HOURS = 3600.0
INTERVALS = [(0, 4), (5, 8), (300, 303), (2, 6), (1, 3), (-2, 9)]  # h


@pytest.mark.parametrize("smooth", [0.0, 1.0])
@pytest.mark.parametrize("tau", [6 * HOURS, 2 * DAY, 8 * DAY])
def test_covariances_of_dive_means_are_those_of_quadrature(tau, smooth):
    intervals = HOURS * np.array(INTERVALS, float)
    found = integral_covariance(
        intervals[0], intervals, np.array([tau]), np.array([smooth])
    )
    expected = [by_quadrature(intervals[0], one, tau, smooth) for one in intervals]
    scale = 1e-12 * (4 * HOURS) ** 2
    assert found[0] == pytest.approx(expected, rel=1e-8, abs=scale)


def test_covariances_of_positions_are_those_of_quadrature():
    lines = 1e3 * np.array([[[0, 0], [6, 2]], [[20, 5], [12, -3]], [[90, 0], [95, 9]]])
    share = np.linspace(0.0, 1.0, 2001)[:, None]
    along = [(1 - share) * line[0] + share * line[1] for line in lines]
    for line, points in zip(lines, along, strict=True):
        apart = along[0][::10, None] - points[None, ::10]
        whole = np.exp(-np.sum(apart**2, axis=-1) / (2 * LENGTH**2)).mean()
        assert position_covariance(lines[0], line[None]) == pytest.approx(whole, 1e-3)


def direct(model, sea, dives):
    """Forecast of the last miss by one regression: mean (2,) and covariance (2, 2)."""
    H, times = [model.regressor(d) for d in dives], [d.mid_time for d in dives]
    spans = [np.array([d.t_gps2, d.t_gpse]) for d in dives]
    memory = model.priors.inertial_fading
    w = inertial_frequency(dives[0].lat_gps2)

    def covariance(j, k):
        lag = times[j] - times[k]
        kept = np.diag(model.prior_sd**2 * np.exp(-abs(lag) / model.memory))
        if "inertial" in model.flow:
            i = model.names.index("inertial_east")
            c, s = math.cos(w * lag), math.sin(w * lag)
            size = model.priors.inertial**2 * math.exp(-abs(lag) / memory)
            kept[i : i + 2, i : i + 2] = size * np.array([[c, s], [-s, c]])
        slow = by_quadrature(spans[j], spans[k], sea.memory, sea.smooth)
        return H[j] @ kept @ H[k].T + sea.size**2 * slow * np.eye(2)

    count = len(dives)
    K = np.block([[covariance(j, k) for k in range(count)] for j in range(count)])
    K += np.diag(np.repeat([model.noise(dive, sea.scatter) for dive in dives], 2))
    y = np.concatenate([dive.miss for dive in dives])
    gain = np.linalg.solve(K[:-2, :-2], K[:-2, -2:]).T
    return gain @ y[:-2], K[-2:, -2:] - gain @ K[:-2, -2:]


@pytest.mark.parametrize("flow", ["M2", "inertial"])
@pytest.mark.parametrize("sea", Priors().kinds)
def test_each_process_is_the_direct_regression_of_all_dives(sea, flow):
    priors = Priors(kinds=(sea,), speed_fading=3e6)
    model = FixModel(("steady", flow), priors=priors)
    dives = vehicle(3, 8, walk=0.02)
    mean, covariance = direct(model, sea, dives)
    mixture = taught(model, dives[:-1])
    has_flow = np.flatnonzero(mixture.has_part[:, 0])[0]
    means, covariances = mixture.forecast(dives[-1])
    assert means[has_flow] == pytest.approx(mean, rel=1e-6, abs=1e-6)
    assert covariances[has_flow] == pytest.approx(covariance, rel=1e-6, abs=1e-3)


def test_the_oldest_dives_are_dropped_exactly():
    """The regression of the last dives is the one that never had the first ones."""
    priors = Priors(kinds=(Sea(0.1, DAY),))
    model = FixModel(("steady", "inertial"), priors=priors)
    dives = vehicle(5, MOST + 1)
    mixture, short = taught(model, dives), taught(model, dives[DROPPED:])
    assert len(mixture.regression.paths) == MOST + 1 - DROPPED
    following = replace(dives[-1], t_gps2=dives[-1].t_gpse + 600.0)
    following = replace(following, t_gpse=following.t_gps2 + 4 * HOURS)
    for found, expected in zip(
        mixture.forecast(following), short.forecast(following), strict=True
    ):
        assert found == pytest.approx(expected, rel=1e-6, abs=1e-3)


@pytest.mark.long
@pytest.mark.parametrize("count", [200, pytest.param(1000, marks=pytest.mark.slow)])
@pytest.mark.sampled
def test_covariances_stay_positive_over_many_dives(count):
    mixture = taught(FixModel(), vehicle(1, count, walk=0.03, noise=0.01))
    size = np.sqrt(np.diagonal(mixture.covariance, axis1=1, axis2=2)) + 1e-12
    correlation = mixture.covariance / size[:, :, None] / size[:, None, :]
    assert np.abs(correlation - correlation.transpose(0, 2, 1)).max() < 1e-8
    assert np.linalg.eigvalsh(correlation).min() > -1e-7
    assert np.isfinite(mixture.mean).all()


def test_weights_are_those_of_the_density_before_the_fix():
    """A fix 60 km away: the density is that of the forecast, not of the wider ellipse after."""
    dives = vehicle(2, 12, noise=0.01)
    mixture = taught(FixModel(), dives[:11])
    last = further(dives[11], 60e3)
    nu, before = mixture.priors.degrees_of_freedom, mixture.weights
    density = [
        multivariate_t.pdf(last.miss, mean, (nu - 2) / nu * S, nu)
        for mean, S in zip(*mixture.forecast(last), strict=True)
    ]
    mixture.priors = mixture.priors._replace(weight_memory=1e15)
    mixture.update(last)
    expected = before * density / (before @ density)
    assert mixture.weights == pytest.approx(expected, rel=1e-6, abs=1e-12)


@pytest.mark.parametrize("factor", [1.0, 1.06])
def test_the_probability_of_a_speed_factor_is_that_of_its_evidence(factor):
    """All dives at once, with a factor and without: the ratio of two normal densities."""
    still = Sea(0.0, DAY, scatter=0.01)
    priors = Priors(kinds=(still,), speed_fading=np.inf, compass_fading=np.inf)
    model = FixModel(("steady",), priors=priors)
    dives = vehicle(4, 10, factor=factor, noise=0.01, fix=30.0)
    mixture = taught(model, dives)
    H = np.vstack([model.regressor(dive) for dive in dives])
    noise = np.diag(np.repeat([model.noise(dive, 0.01) for dive in dives], 2))
    y = np.concatenate([dive.miss for dive in dives])
    with_factor, without = (
        multivariate_normal.logpdf(y, cov=H @ np.diag(sd**2) @ H.T + noise)
        for sd in (model.prior_sd, model.prior_sd * (np.array(model.parts) != "speed"))
    )
    expected = 1 / (1 + np.exp(without - with_factor))
    assert mixture.parts()["speed"] == pytest.approx(expected, rel=1e-6)
    assert (mixture.parts()["speed"] > 0.5) == (factor != 1.0)


def trial_dives(seed, size, depths):
    """Dives of these depths in a current that changes by `size`, m/s, with each e-fold."""
    dives = vehicle(seed, len(depths), noise=0.005)
    return [
        replace(further(d, size * math.log(D / 100) * d.duration), depth_max=D)
        for d, D in zip(dives, depths, strict=True)
    ]


@pytest.mark.sampled
@pytest.mark.parametrize("size", [0.05, 0.1])
def test_ellipses_hold_while_a_vehicle_dives_deeper(size):
    depths = [100.0] * 6 + [200.0, 400.0, 800.0, 1000.0]
    inside, unknown = [], []
    for seed in range(4):
        dives = trial_dives(seed, size, depths)
        inside += [step.inside_hindsight for step in replay_dives(dives).steps[6:]]
        dives = [replace(dive, depth_max=None) for dive in dives]
        unknown += [step.inside_hindsight for step in replay_dives(dives).steps[6:]]
    assert np.mean(inside) > 0.85
    assert np.mean(unknown) < 0.6


def test_depth_counts_only_while_it_grows():
    dives = trial_dives(1, 0.0, [900.0, 500.0, 200.0, 800.0, 900.0, 100.0])
    without = [replace(dive, depth_max=None) for dive in dives]
    for step, other in zip(
        replay_dives(dives).steps, replay_dives(without).steps, strict=True
    ):
        assert np.array_equal(step.forecast, other.forecast)
        assert np.array_equal(step.covariance, other.covariance)


@pytest.mark.long
@pytest.mark.parametrize(
    ("flow", "there", "absent"),
    [("M2", "tides", "inertial"), ("inertial", "inertial", "tides")],
)
def test_parts_that_are_there_are_found(flow, there, absent):
    wrong = []
    for seed in range(3):
        parts = replay_dives(vehicle(seed, 40, flow=flow, noise=0.01)).steps[-1].parts
        assert set(parts) == {
            "tides",
            "inertial",
            "trend",
            "eddies",
            "speed",
            "compass",
        }
        assert all(0 <= p <= 1 for p in parts.values())
        assert parts[there] > 0.9
        wrong.append(parts[absent])
    assert np.mean(wrong) < 0.3
