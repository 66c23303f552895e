"""An estimator's forecast and the previous dive's, combined; the gradient's own errors."""

import itertools
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from synthetic_vehicle import STEADY, vehicle

from clpt_control.estimation import combination
from clpt_control.estimation.between_fixes import ESTIMATORS, make_estimator
from clpt_control.estimation.combination import SHARE, WEIGHT, Combination
from clpt_control.estimation.fix_model import FixModel, miss
from clpt_control.gliders.dives import make_dive
from clpt_control.replay.flow_model_file import read_flow_model
from clpt_control.replay.flow_models import way_of_flow
from clpt_control.replay.session import replay_dives

FIELD = Path(__file__).parents[1] / "data/field/maracoos_hfr_2019-01-01.nc"


@pytest.mark.parametrize("estimator", ESTIMATORS)
def test_the_forecast_lies_between_the_two(estimator):
    both = make_estimator(estimator, FixModel())
    rng = np.random.default_rng(1)
    for k, dive in enumerate(vehicle(1, 20, walk=0.1 * rng.uniform())):
        own, covariance = both.estimator.predict(dive)
        mean, wide = both.predict(dive)
        if k:
            previous = dive.duration * both.rate
            assert mean == pytest.approx((1 - both.share) * own + both.share * previous)
            assert np.linalg.eigvalsh(wide - covariance).min() > -1e-6
        assert 0 <= both.share <= 1
        both.update(dive)


class Silent:
    """An estimator that forecasts nothing, 2000 m wide."""

    model = FixModel()

    def predict(self, dive):
        return np.zeros(2), 4e6 * np.eye(2)

    def update(self, dive):
        """Learn nothing."""


def test_the_share_is_the_one_that_would_have_forecast_best(monkeypatch):
    """By searching all shares: squared misses, and the first share as so many dives."""
    monkeypatch.setattr(combination, "MEMORY", np.inf)
    dives = vehicle(4, 40, walk=0.02)
    both = Combination(Silent())
    for dive in dives:
        both.update(dive)
    shares = np.linspace(0, 1, 100_001)
    cost = WEIGHT * (shares - SHARE) ** 2
    for before, dive in itertools.pairwise(dives):
        forecast = np.outer(shares, miss(before) / before.duration * dive.duration)
        cost += np.sum((miss(dive) - forecast) ** 2, axis=1) / 2000.0**2
    assert 0.1 < both.share < 0.99
    assert both.share == pytest.approx(shares[np.argmin(cost)], abs=2e-5)


def test_the_share_is_forgotten_in_time():
    both = Combination(Silent())
    *dives, last = vehicle(4, 41, walk=0.05)
    for dive in dives:
        both.update(dive)
    learned = both.gain, both.weight
    both.update(replace(last, t_gps2=last.t_gps2 + 2e7, t_gpse=last.t_gpse + 2e7))
    # what is left is the first share and the last dive's word, of 13.82 at most
    assert learned[1] > 8 + 20
    assert both.weight < 8 + 14


def test_who_knows_best_gets_the_share():
    def share(**case):
        last = [replay_dives(vehicle(s, 40, **case)).steps[-1].previous_share for s in range(6)]
        return np.mean(last)

    assert share(noise=0.05) < 0.15  # the mean of all dives is best
    assert share(walk=0.25, fix=1.0) > 0.3  # the last one is


def test_the_gradients_errors_are_as_large_as_it_says():
    """Current and speed of 100 vehicles: within three standard errors in 95 %."""
    inside = 0
    for seed in range(100):
        factor = 1 + 0.1 * np.random.default_rng(seed).normal()
        dives = vehicle(seed, 16, factor=factor, noise=0.01)
        step = replay_dives(dives, "gradient", FixModel(("steady",))).steps[-1]
        inside += bool(
            abs(step.speed - factor) < 3 * step.speed_error
            and np.all(np.abs(step.current - STEADY) < 3 * step.current_error)
        )
        assert np.all(step.current_error < 0.1)  # it says something: the prior has 0.3
    assert inside >= 95


def flight(model, seed, hours=2.0, speed=0.3):
    """Dives of a glider in a measured current, to and fro; fewer where it leaves the data."""
    rng = np.random.default_rng(seed)
    time = model.column.time[0] + 60
    lat, lon = 41.2 + 0.2 * rng.normal(), -69.5 + 0.3 * rng.normal()
    heading, dives = rng.uniform(0, 2 * np.pi), []
    for k in range(10):
        T = 3600 * hours * rng.uniform(0.9, 1.1)
        angle = heading + np.pi * ((k // 3) % 2) + 0.1 * rng.normal()
        dr = speed * T * np.array([np.cos(angle), np.sin(angle)])
        flying = make_dive(k, (time, lat, lon), (time + T, lat, lon), tuple(dr))
        way = dr + way_of_flow(flying, model.along(flying)) + 20 * rng.normal(size=2)
        lat += way[1] / 111.2e3
        lon += way[0] / (111.2e3 * np.cos(np.radians(lat)))
        dives.append(
            make_dive(k, (time, flying.lat_gps2, flying.lon_gps2), (time + T, lat, lon), tuple(dr))
        )
        time += T + 900
    return dives


def test_gliders_in_a_measured_current_lose_nothing():
    """HF radar off Nantucket, a day; the defaults were not fitted to it."""
    from clpt_control.replay.flow_models import Uncovered

    model, ratios = read_flow_model(FIELD), []
    for seed in range(60):
        try:
            rms = replay_dives(flight(model, seed)).rms(3)
        except Uncovered:  # the radar has a gap there
            continue
        ratios.append(rms["adaptive"] / rms["previous_dive"])
    assert len(ratios) >= 12
    assert np.exp(np.mean(np.log(ratios))) < 0.97
    assert np.max(ratios) < 1.25
