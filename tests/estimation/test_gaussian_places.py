"""Gaussians of place in the regression between fixes, and a given flow model."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import erf
from synthetic_vehicle import vehicle

from clpt_control.estimation.dive import Dive
from clpt_control.estimation.estimators import ESTIMATORS
from clpt_control.estimation.fix_model import FixModel
from clpt_control.estimation.gaussian_places import SPACING, Places, near, places_columns
from clpt_control.geodesy import place_from
from clpt_control.replay.facts import replay_dataset
from clpt_control.replay.outcome import clpe_rms
from clpt_control.replay.replay import Replay, replay_dives

WIDTH = 20e3


def straight(number, start, way, dr, T=14400.0):
    """A dive from `start` (m from 40 N 8 E) that went `way` and reckoned `dr`."""
    lat, lon = place_from(40.0, 8.0, *start)
    end = place_from(40.0, 8.0, *(np.array(start) + way))
    t = 1.6e9 + number * (T + 600)
    return Dive(number, t, lat, lon, t + T, *end, *way, *dr)


def test_the_integral_is_that_of_the_error_function():
    dive = straight(0, (-9e3, 4e3), (0.0, 0.0), (18e3, -12e3))
    cells = ((0, 0), (1, 0), (-1, 1))
    found = places_columns(Places(40.0, 8.0, WIDTH, cells), dive)
    a, d = np.array([-9e3, 4e3]), np.array([18e3, -12e3])
    for k, cell in enumerate(cells):
        r = a - SPACING * WIDTH * np.array(cell)
        length = np.hypot(*d)
        near_, across = r @ d / length, (r[0] * d[1] - r[1] * d[0]) / length
        s = np.sqrt(2) * WIDTH
        whole = np.exp(-((across / s) ** 2)) * (np.sqrt(np.pi) / 2) * s / length * dive.duration
        whole *= erf((near_ + length) / s) - erf(near_ / s)
        assert found[:, 2 * k : 2 * k + 2] == pytest.approx(whole * np.eye(2), rel=1e-3)


def test_places_join_as_the_track_comes_near():
    first = near(None, straight(0, (0.0, 0.0), (0.0, 0.0), (3e3, 0.0)), WIDTH)
    assert (0, 0) in first.cells
    assert all(abs(i) <= 2 and abs(j) <= 2 for i, j in first.cells)
    assert near(first, straight(1, (1e3, 0.0), (0.0, 0.0), (3e3, 0.0)), WIDTH) is first
    far = near(first, straight(2, (95e3, 0.0), (0.0, 0.0), (3e3, 0.0)), WIDTH)
    assert far.cells[: len(first.cells)] == first.cells
    assert (3, 0) in far.cells


def test_a_dives_end_is_used_only_after_it():
    dive = straight(0, (0.0, 0.0), (9e3, 5e3), (3e3, 0.0))
    places = near(None, dive, WIDTH)
    blind = replace(dive, gps_east=np.nan, gps_north=np.nan, lat_gpse=np.nan)
    assert np.array_equal(places_columns(places, dive), places_columns(places, blind))
    assert not np.array_equal(places_columns(places, dive), places_columns(places, dive, True))


def survey(seed, count=48, speed=0.3, T=14400.0):
    """To and fro across a flow that stays: six eddies, 20 km wide."""
    rng = np.random.default_rng(seed)
    centers, sizes = rng.uniform(-30e3, 30e3, (6, 2)), 0.15 * rng.normal(size=(6, 2))
    x, dives = np.array([-20e3, 0.0]), []
    for k in range(count):
        goal = np.array([-20e3 if (k // 6) % 2 else 20e3, 15e3 * np.sin(0.2 * k)]) - x
        dr, start = speed * T * goal / np.hypot(*goal), x
        for _ in range(60):
            phi = np.exp(-np.sum((x - centers) ** 2, axis=1) / (2 * 20e3**2))
            x = x + (phi @ sizes) * T / 60 + dr / 60
        way = x - start + (20 + 0.005 * T) * rng.normal(size=2)
        dives.append(straight(k, start, way, dr))
    return dives


@pytest.mark.parametrize(
    ("estimator", "count"),
    [
        ("kalman", 1),
        *(pytest.param(name, 4, marks=pytest.mark.slow) for name in ("kalman", "gradient")),
    ],
)
def test_a_map_learned_helps_where_the_flow_stays(estimator, count):
    gains = []
    for seed in range(count):
        dives = survey(seed)
        plain, mapped = (
            clpe_rms(replay_dives(dives, estimator, FixModel(flow)), 10)["adaptive"]
            for flow in (("steady",), ("steady", "gaussians"))
        )
        gains.append(mapped / plain)
    assert np.exp(np.mean(np.log(gains))) < {"kalman": 0.8}.get(estimator, 1.02)


def test_places_are_fed_one_by_one_or_at_once():
    dives, model = survey(1, 14), FixModel(("steady", "gaussians"))
    single = Replay("kalman", model)
    for dive in dives:
        single.step(dive)
        single.forecast(dives[-1])  # a far one: it must leave no trace
    assert replay_dataset(single).identical(replay_dataset(replay_dives(dives, "kalman", model)))
    assert max(abs(v) for k, v in single.known().items() if k.startswith("gaussian[")) > 0.02


def with_model(dives, factor, seed=0):
    """Return dives a flow model that is `factor` times what carried them, and wrong by 50 m."""
    rng = np.random.default_rng(seed)
    return [
        replace(
            d,
            model_east=d.miss_east * factor + 50 * rng.normal(),
            model_north=d.miss_north * factor + 50 * rng.normal(),
        )
        for d in dives
    ]


@pytest.mark.parametrize("estimator", ESTIMATORS)
def test_a_flow_model_that_tells_is_used(estimator):
    model = FixModel(("steady", "M2", "inertial", "model"))
    replay = replay_dives(with_model(vehicle(2, walk=0.1), 0.8), estimator, model)
    plain = replay_dives(vehicle(2, walk=0.1), estimator)
    assert (
        clpe_rms(replay, 5)["adaptive"]
        < (0.9 if estimator == "gradient" else 0.6) * clpe_rms(plain, 5)["adaptive"]
    )
    assert "model" not in replay.steps[-1].not_learned


def test_a_flow_model_that_tells_nothing_does_little_harm():
    model, rng = FixModel(("steady", "M2", "inertial", "model")), np.random.default_rng(1)
    ratios = []
    for seed in range(3):
        dives = vehicle(seed, noise=0.03)
        wrong = [
            replace(d, model_east=e, model_north=n)
            for d, (e, n) in zip(dives, 1500 * rng.normal(size=(len(dives), 2)), strict=True)
        ]
        plain, given = replay_dives(dives), replay_dives(wrong, model=model)
        ratios.append(clpe_rms(given, 3)["adaptive"] / clpe_rms(plain, 3)["adaptive"])
    assert np.mean(ratios) < 1.05


def test_a_dive_that_no_model_covers_teaches_nothing_of_it():
    model = FixModel(("steady", "model"))
    dives = vehicle(3, 6)
    last = replay_dives(dives, model=model).steps[-1]
    assert "model" in last.not_learned
