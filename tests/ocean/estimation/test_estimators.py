"""The estimator between fixes: what it learns of made vehicles, and how sure it is."""

import math
from dataclasses import replace

import numpy as np
import pytest
from geodesics import place_from
from synthetic_vehicle import STEADY, clpe_rms, further, turned, vehicle

from clpt_control.gliders import Dive
from clpt_control.replay import replay_dives

STEADY_ONLY = {"flow": ("steady",)}


def ratio(dives, **model):
    replay = replay_dives(dives, **model)
    return clpe_rms(replay) / clpe_rms(replay, model="previous_dive")


@pytest.mark.long
@pytest.mark.parametrize("count", [20, pytest.param(200, marks=pytest.mark.slow)])
def test_errors_are_no_larger_than_is_said(count):
    """Of so many vehicles: the mean square of what is off, in standard errors, is at most 1."""
    off = []
    for seed in range(count):
        factor = 1 + 0.1 * np.random.default_rng(1000 + seed).normal()
        dives = vehicle(seed, 16, factor=factor, noise=0.01)
        step = replay_dives(dives, **STEADY_ONLY).steps[-1]
        current = (step.current - STEADY) / step.current_error
        off.append([(step.speed - factor) / step.speed_error, *current])
        assert np.all(step.current_error < 0.1)  # it says something: the prior has 0.3
    assert np.all(np.mean(np.square(off), axis=0) < 1)


def test_a_tide_is_learned():
    assert ratio(vehicle(1, flow="M2")) < 0.3


SEAS = [
    ({"walk": 0.03}, 1.06),  # the previous dive's current is the best forecast there
    ({"walk": 0.1}, 1.06),
    ({"walk": 0.03, "heading": "one"}, 1.06),
    ({"noise": 0.05}, 0.85),
    ({"walk": 0.03, "noise": 0.05}, 1.03),
    ({"walk": 0.03, "factor": 0.85}, 0.9),
]


@pytest.mark.parametrize("count", [3, pytest.param(6, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("case", "most"), SEAS)
def test_against_the_previous_dives_current(case, most, count):
    ratios = [ratio(vehicle(seed, **case)) for seed in range(count)]
    assert np.sqrt(np.mean(np.square(ratios))) < most


@pytest.mark.long
@pytest.mark.parametrize("case", [{"walk": 0.03}, {"noise": 0.05}, {"flow": "M2"}])
def test_ellipses_hold_what_they_promise(case):
    replays = [replay_dives(vehicle(seed, **case)) for seed in range(4)]
    inside = [step.inside_hindsight for replay in replays for step in replay.steps]
    level = replays[0].summary()["level"]
    assert level - 0.07 < np.mean(inside) <= 1


def test_what_is_not_excited_is_held():
    dives = [
        replace(d, dr_east=600.0, dr_north=300.0) for d in vehicle(1, 6, fix=400.0)
    ]
    last = replay_dives(dives).steps[-1]
    assert {"speed", "compass"} <= set(last.not_learned)
    assert last.speed == pytest.approx(1, abs=0.02)
    assert "current_east" not in last.not_learned


TURNING = [("M2", 40.0, 20.0), ("inertial", 40.0, 120.0), ("inertial", -40.0, 120.0)]


@pytest.mark.long
@pytest.mark.parametrize(("flow", "latitude", "most"), TURNING)
def test_a_flow_that_turns_is_forecast(flow, latitude, most):
    """Of 1300 m in 4 h: the period and the mean over a dive; clockwise in the north."""
    dives = vehicle(1, 40, flow=flow, latitude=latitude, fix=0.01)
    replay = replay_dives(dives, flow=("steady", flow), learn_speed=False)
    assert clpe_rms(replay, 20) < most
    assert clpe_rms(replay, 20, "previous_dive") > 2000
    south = [replace(d, lat_gps2=-d.lat_gps2, lat_gpse=-d.lat_gpse) for d in dives]
    if flow == "inertial":  # the wrong hemisphere
        other = replay_dives(south, flow=("steady", flow), learn_speed=False)
        assert clpe_rms(other, 20) > 2000


@pytest.mark.sampled
@pytest.mark.parametrize(("factor", "degrees"), [(0.8, 12.0), (1.15, -8.0)])
def test_speed_and_compass_are_told_apart_however_large(factor, degrees):
    response = factor * np.exp(-1j * math.radians(degrees))  # clockwise
    dives = [turned(dive, response) for dive in vehicle(2, 40)]
    step = replay_dives(dives, **STEADY_ONLY).steps[-1]
    assert "speed" not in step.not_learned
    assert step.speed == pytest.approx(factor, abs=3 * step.speed_error)
    assert step.compass == pytest.approx(degrees, abs=3 * step.compass_error)
    c, s = response.real, -response.imag
    np.testing.assert_allclose(step.response, [[c, s], [-s, c]], atol=0.02)


def in_shear(seed, size):
    """Dives to 100 to 1000 m in a current that is `size` more, m/s, where e times as deep."""
    rng = np.random.default_rng(seed)
    deep = np.exp(rng.uniform(math.log(100), math.log(1000), 30))
    return [
        replace(further(d, size * math.log(D / 100) * d.duration), depth_max=D)
        for d, D in zip(vehicle(seed, noise=0.01), deep, strict=True)
    ]


@pytest.mark.long
def test_shear_is_learned_where_dives_change_their_depth():
    model, gains = {"flow": ("steady", "shear")}, []
    for seed in range(2):
        dives = in_shear(seed, -0.08)
        replay = replay_dives(dives, **model)
        assert replay.known()["shear_east"] == pytest.approx(-0.08, abs=0.02)
        assert replay.steps[-1].parts["shear"] > 0.9
        gains.append(ratio(dives, **model) / ratio(dives, **STEADY_ONLY))
        still = replay_dives(in_shear(seed, 0.0), **model).steps[-1]
        assert still.parts["shear"] < 0.5
    assert np.max(gains) < 0.6


@pytest.mark.parametrize("depth", [None, math.nan])
def test_shear_says_nothing_where_depth_is_unknown(depth):
    dives = [replace(d, depth_max=depth) for d in vehicle(3, 8, noise=0.01)]
    with_it = replay_dives(dives, flow=("steady", "shear")).steps[-1]
    without = replay_dives(dives, **STEADY_ONLY).steps[-1]
    assert with_it.forecast == pytest.approx(without.forecast, rel=1e-9)
    assert with_it.parts["shear"] == pytest.approx(0.5)


def test_a_front_is_followed_at_once():
    dives = vehicle(5, 30, noise=0.003)
    beyond = [further(d, 0.0, 0.5 * d.duration) for d in dives[20:]]
    steps = replay_dives([*dives[:20], *beyond]).steps
    assert steps[20].clpe["adaptive"] > 5000
    assert steps[21].clpe["adaptive"] < 1500


@pytest.mark.long
def test_one_wild_fix_does_little_harm():
    dives = vehicle(5, 40, noise=0.01)
    wild = [further(d, 50e3) if d.number == 20 else d for d in dives]
    calm, after = (
        np.array([s.clpe["adaptive"] for s in replay_dives(d).steps])
        for d in (dives, wild)
    )
    assert after[23:].mean() < 3 * calm[23:].mean() + 300


def test_ellipses_hold_after_a_turn():
    """Eight dives on one heading cannot tell speed from current; then the vehicle turns."""
    inside = []
    for seed in range(20):
        factor = 1 + 0.15 * np.random.default_rng(seed).normal()
        *dives, last = vehicle(seed, 9, factor=factor, heading="one")
        east, north = last.dr_east, last.dr_north
        back = further(last, -2 * factor * east, -2 * factor * north)
        back = replace(back, dr_east=-east, dr_north=-north)
        inside.append(
            [step.inside_hindsight for step in replay_dives([*dives, back]).steps[-2:]]
        )
    assert np.all(np.mean(inside, axis=0) > 0.8)


MAPPED = {"flow": ("steady", "gaussians")}


def straight(number, start, way, dr, T=14400.0):
    """A dive from `start` (m from 40 N 8 E) that went `way` and reckoned `dr`."""
    lat, lon = place_from(40.0, 8.0, *start)
    end = place_from(40.0, 8.0, *(np.array(start) + way))
    t = 1.6e9 + number * (T + 600)
    return Dive(number, t, lat, lon, t + T, *end, *way, *dr)


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


@pytest.mark.long
@pytest.mark.parametrize("count", [1, pytest.param(4, marks=pytest.mark.slow)])
def test_a_map_learned_helps_where_the_flow_stays(count):
    gains = []
    for seed in range(count):
        dives = survey(seed)
        plain, mapped = (
            clpe_rms(replay_dives(dives, **model), 10)
            for model in (STEADY_ONLY, MAPPED)
        )
        gains.append(mapped / plain)
    assert np.exp(np.mean(np.log(gains))) < 0.8


def test_a_map_is_fed_dive_by_dive_or_at_once():
    dives = survey(1, 14)
    single = replay_dives([], **MAPPED)
    for dive in dives:
        single.step(dive)
        single.forecast(dives[-1])  # of a distant dive: the state does not change
    at_once = replay_dives(dives, **MAPPED).dataset()
    assert single.dataset().identical(at_once)
    assert single.steps[-1].parts["gaussians"] != 0.5


WITH_MODEL = {"flow": ("steady", "M2", "inertial", "model")}


def modelled(dives, ways):
    """Dives that a flow model carries such ways, m."""
    pairs = zip(dives, ways, strict=True)
    return [replace(dive, model_east=way[0], model_north=way[1]) for dive, way in pairs]


@pytest.mark.long
def test_a_flow_model_that_tells_is_used():
    """It is 0.8 times what carries the vehicle, and wrong by 50 m."""
    dives, rng = vehicle(2, walk=0.1), np.random.default_rng(0)
    ways = [
        [0.8 * d.miss_east, 0.8 * d.miss_north] + 50 * rng.normal(size=2) for d in dives
    ]
    replay = replay_dives(modelled(dives, ways), **WITH_MODEL)
    plain = clpe_rms(replay_dives(dives), 5)
    assert clpe_rms(replay, 5) < 0.6 * plain
    assert "model" not in replay.steps[-1].not_learned
    uncovered = replay_dives(dives, **WITH_MODEL)
    assert "model" in uncovered.steps[-1].not_learned


@pytest.mark.long
def test_a_flow_model_that_tells_nothing_does_little_harm():
    rng, ratios = np.random.default_rng(1), []
    for seed in range(3):
        dives = vehicle(seed, noise=0.03)
        wrong = modelled(dives, 1500 * rng.normal(size=(len(dives), 2)))
        plain, given = replay_dives(dives), replay_dives(wrong, **WITH_MODEL)
        ratios.append(clpe_rms(given) / clpe_rms(plain))
    assert np.mean(ratios) < 1.05
