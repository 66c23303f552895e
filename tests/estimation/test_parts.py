"""Weights of the filters, and the probability that a part is present."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import multivariate_normal, multivariate_t
from synthetic_vehicle import vehicle

from clpt_control.estimation.dive import miss
from clpt_control.estimation.fix_model import FixModel
from clpt_control.estimation.kalman import KalmanBank, with_hidden
from clpt_control.estimation.priors import Kind, Priors
from clpt_control.replay.replay import replay_dives


def test_weights_are_those_of_the_density_before_the_fix():
    """A fix 60 km away: the density is that of the forecast, not of the ellipse it widens."""
    bank, dives = KalmanBank(FixModel()), vehicle(2, 12, noise=0.01)
    for dive in dives[:11]:
        bank.update(dive)
    last = replace(dives[11], gps_east=dives[11].gps_east + 60e3)
    nu, before = bank.priors.degrees_of_freedom, bank.weights
    model, _, mean, P = bank.ahead(last)
    H = with_hidden(model.regressor(last))
    S = H @ P @ H.T + bank.noise(last)
    density = [
        multivariate_t.pdf(miss(last), H @ m, (nu - 2) / nu * s, nu)
        for m, s in zip(mean, S, strict=True)
    ]
    bank.priors = bank.priors._replace(weight_memory=1e15)
    bank.update(last)
    expected = before * density / (before @ density)
    assert bank.weights == pytest.approx(expected, rel=1e-6, abs=1e-12)


@pytest.mark.parametrize("factor", [1.0, 1.06])
def test_the_probability_of_a_speed_factor_is_that_of_its_evidence(factor):
    """All dives at once, with a factor and without: the ratio of two normal densities."""
    priors = Priors(kinds=(Kind(walk=0.0, scatter=0.01),), speed_walk=0.0, compass_walk=0.0)
    model = FixModel(("steady",), priors=priors)
    dives = vehicle(4, 10, factor=factor, noise=0.01, fix=30.0)
    bank = KalmanBank(model)
    for dive in dives:
        bank.update(dive)
    H = np.vstack([model.regressor(dive) for dive in dives])
    noise = np.diag(np.repeat([model.noise(dive, 0.01) for dive in dives], 2))
    y = np.concatenate([miss(dive) for dive in dives])
    with_it, without = (
        multivariate_normal.logpdf(y, cov=H @ np.diag(sd**2) @ H.T + noise)
        for sd in (model.prior_sd, model.prior_sd * (np.array(model.parts) != "speed"))
    )
    expected = 1 / (1 + np.exp(without - with_it))
    assert bank.parts()["speed"] == pytest.approx(expected, rel=1e-6)
    assert (bank.parts()["speed"] > 0.5) == (factor != 1.0)


@pytest.mark.parametrize(
    ("flow", "there", "absent"), [("M2", "tides", "inertial"), ("inertial", "inertial", "tides")]
)
def test_parts_that_are_there_are_found(flow, there, absent):
    wrong = []
    for seed in range(6):
        parts = replay_dives(vehicle(seed, 40, flow=flow, noise=0.01)).steps[-1].parts
        assert set(parts) == {"tides", "inertial", "trend", "eddies", "speed", "compass"}
        assert all(0 <= p <= 1 for p in parts.values())
        assert parts[there] > 0.9
        wrong.append(parts[absent])
    assert np.mean(wrong) < 0.3


def test_what_is_left_of_the_priors_error_is_said():
    step = replay_dives(vehicle(1, 20, noise=0.01)).steps[-1]
    assert step.left["speed"] < 0.3
    assert "speed" in step.learned
    still = [replace(d, dr_east=0.0, dr_north=0.0) for d in vehicle(1, 20, noise=0.01)]
    step = replay_dives(still).steps[-1]
    assert step.left["speed"] == pytest.approx(1, abs=0.05)
    assert {"speed", "compass"} == set(step.held)
    none = replay_dives(still, model=FixModel(learn_speed=False)).steps[-1]
    assert "speed" not in none.parts
