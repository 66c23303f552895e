"""Estimators between fixes: what they learn of made vehicles, and how sure they are."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import trapezoid
from synthetic_vehicle import STEADY, vehicle

from clpt_control.estimation.dive import mid_time
from clpt_control.estimation.estimators import ESTIMATORS
from clpt_control.estimation.fix_model import FixModel, inertial_frequency
from clpt_control.estimation.priors import Priors
from clpt_control.replay.outcome import clpe_rms, summary
from clpt_control.replay.replay import replay_dives
from clpt_control.scenario.tidal_periods import period


def ratio(dives, estimator="kalman", model=None):
    rms = clpe_rms(replay_dives(dives, estimator, model), 3)
    return rms["adaptive"] / rms["previous_dive"]


@pytest.mark.parametrize("count", [20, pytest.param(200, marks=pytest.mark.slow)])
@pytest.mark.parametrize("estimator", ESTIMATORS)
def test_errors_are_no_larger_than_is_said(estimator, count):
    """Of so many vehicles: the mean square of what is off, in standard errors, is at most 1."""
    off = []
    for seed in range(count):
        factor = 1 + 0.1 * np.random.default_rng(1000 + seed).normal()
        dives = vehicle(seed, 16, factor=factor, noise=0.01)
        step = replay_dives(dives, estimator, FixModel(("steady",))).steps[-1]
        current = (step.current - STEADY) / step.current_error
        off.append([(step.speed - factor) / step.speed_error, *current])
        assert np.all(step.current_error < 0.1)  # it says something: the prior has 0.3
    assert np.all(np.mean(np.square(off), axis=0) < 1)


def test_learns_what_there_is():
    for flow in ("M2", "inertial"):
        assert ratio(vehicle(1, flow=flow)) < 0.3
    step = replay_dives(vehicle(2, 40, factor=0.9)).steps[-1]
    assert step.speed == pytest.approx(0.9, abs=0.01)
    assert "speed" not in step.not_learned


@pytest.mark.parametrize("count", [3, pytest.param(6, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    ("case", "most"),
    [
        ({"walk": 0.03}, 1.06),  # the previous dive's current is the best forecast there
        ({"walk": 0.1}, 1.06),
        ({"walk": 0.03, "heading": "one"}, 1.06),
        ({"noise": 0.05}, 0.85),
        ({"walk": 0.03, "noise": 0.05}, 0.95),
        ({"walk": 0.03, "factor": 0.85}, 0.9),
    ],
)
def test_against_the_previous_dives_current(case, most, count):
    ratios = [ratio(vehicle(seed, **case)) for seed in range(count)]
    assert np.sqrt(np.mean(np.square(ratios))) < most


@pytest.mark.parametrize("case", [{"walk": 0.03}, {"noise": 0.05}, {"flow": "M2"}])
def test_ellipses_hold_what_they_promise(case):
    inside = [summary(replay_dives(vehicle(seed, **case)))["inside_90"] for seed in range(4)]
    assert 0.83 < np.mean(inside) <= 1


def test_what_is_not_excited_is_held():
    dives = [replace(d, dr_east=600.0, dr_north=300.0) for d in vehicle(1, 6, fix=400.0)]
    last = replay_dives(dives).steps[-1]
    assert {"speed", "compass"} <= set(last.not_learned)
    assert last.speed == pytest.approx(1, abs=0.02)
    assert "current_east" not in last.not_learned


def test_the_coriolis_turn_is_right():
    stays = Priors(inertial_fading=math.inf)
    model, dive = FixModel(("steady", "inertial"), False, priors=stays), vehicle(1, 1)[0]
    dt, w = 7200.0, inertial_frequency(dive.lat_gps2)
    east, north = model.transition(dt, dive.lat_gps2)[2:, 2:] @ [1.0, 0.0]
    assert (east, north) == pytest.approx((math.cos(w * dt), -math.sin(w * dt)))  # clockwise
    assert 2 * math.pi / inertial_frequency(30.0) / 3600 == pytest.approx(23.93, abs=0.005)
    t = np.linspace(-dive.duration / 2, dive.duration / 2, 10001)
    whole = trapezoid(np.cos(w * t), t)
    assert model.regressor(dive)[0, 2] == pytest.approx(whole, rel=1e-6)


def test_the_tides_integral_is_right():
    model, dive = FixModel(("steady", "M2"), False), vehicle(1, 1)[0]
    w = 2 * math.pi / period("M2", "s")
    t = np.linspace(dive.t_gps2, dive.t_gpse, 10001)
    H = model.regressor(dive)
    assert H[0, 2] == pytest.approx(trapezoid(np.cos(w * t), t), rel=1e-5)
    assert H[1, 5] == pytest.approx(trapezoid(np.sin(w * t), t), rel=1e-5)
    assert mid_time(dive) == pytest.approx(t.mean())


def turned(dives, degrees, factor=1.0):
    """Dives that go clockwise of what they reckon, and so many times as fast."""
    angle = math.radians(degrees)
    c, s = factor * math.cos(angle), factor * math.sin(angle)
    return [
        replace(
            d,
            gps_east=d.gps_east - d.dr_east + c * d.dr_east + s * d.dr_north,
            gps_north=d.gps_north - d.dr_north + c * d.dr_north - s * d.dr_east,
        )
        for d in dives
    ]


@pytest.mark.parametrize(("factor", "degrees"), [(0.8, 12.0), (1.15, -8.0)])
def test_speed_and_compass_are_told_apart_however_large(factor, degrees):
    dives = turned(vehicle(2, 40), degrees, factor)
    c, s = factor * math.cos(math.radians(degrees)), factor * math.sin(math.radians(degrees))
    step = replay_dives(dives, model=FixModel(("steady",))).steps[-1]
    assert step.speed == pytest.approx(factor, abs=3 * step.speed_error)
    assert step.compass == pytest.approx(degrees, abs=3 * step.compass_error)
    np.testing.assert_allclose(step.response, [[c, s], [-s, c]], atol=0.02)


@pytest.mark.parametrize("latitude", [40.0, -40.0])
def test_inertial_currents_turn_with_the_hemisphere(latitude):
    dives = vehicle(1, flow="inertial", latitude=latitude)
    # from the file of the other hemisphere they would turn the wrong way
    wrong = [replace(d, lat_gps2=-latitude) for d in dives]
    assert ratio(dives) < 0.3 < ratio(wrong)


def in_shear(seed, size):
    """Dives to 100 to 1000 m in a current that is `size` more, m/s, where e times as deep."""
    rng = np.random.default_rng(seed)
    deep = np.exp(rng.uniform(math.log(100), math.log(1000), 30))
    return [
        replace(d, depth_max=D, gps_east=d.gps_east + size * math.log(D / 100) * d.duration)
        for d, D in zip(vehicle(seed, noise=0.01), deep, strict=True)
    ]


def test_shear_is_learned_where_dives_change_their_depth():
    model, gains = FixModel(("steady", "shear")), []
    for seed in range(2):
        dives = in_shear(seed, -0.08)
        replay = replay_dives(dives, model=model)
        assert replay.known()["shear_east"] == pytest.approx(-0.08, abs=0.02)
        assert replay.steps[-1].parts["shear"] > 0.9
        gains.append(ratio(dives, model=model) / ratio(dives, model=FixModel(("steady",))))
        still = replay_dives(in_shear(seed, 0.0), model=model).steps[-1]
        assert still.parts["shear"] < 0.5
    assert np.max(gains) < 0.6


@pytest.mark.parametrize("depth", [None, math.nan])
def test_shear_says_nothing_where_depth_is_unknown(depth):
    dives = [replace(d, depth_max=depth) for d in vehicle(3, 8, noise=0.01)]
    with_it, without = (
        replay_dives(dives, model=FixModel(flow)).steps[-1]
        for flow in (("steady", "shear"), ("steady",))
    )
    assert with_it.forecast == pytest.approx(without.forecast, rel=1e-9)
    assert with_it.parts["shear"] == pytest.approx(0.5)


def test_a_front_is_followed_at_once():
    dives = vehicle(5, 30, noise=0.003)
    beyond = [replace(d, gps_north=d.gps_north + 0.5 * d.duration) for d in dives[20:]]
    steps = replay_dives([*dives[:20], *beyond]).steps
    assert steps[20].clpe["adaptive"] > 5000
    assert steps[21].clpe["adaptive"] < 1500


@pytest.mark.parametrize("estimator", ESTIMATORS)
def test_one_wild_fix_does_little_harm(estimator):
    dives = vehicle(5, 40, noise=0.01)
    wild = [replace(d, gps_east=d.gps_east + 50e3) if d.number == 20 else d for d in dives]
    calm, after = (
        np.array([s.clpe["adaptive"] for s in replay_dives(d, estimator).steps])
        for d in (dives, wild)
    )
    assert after[23:].mean() < 3 * calm[23:].mean() + 300


def test_ellipses_hold_after_a_turn():
    """Eight dives on one heading cannot tell speed from current; then the vehicle turns."""
    inside = []
    for seed in range(20):
        factor = 1 + 0.15 * np.random.default_rng(seed).normal()
        dives = vehicle(seed, 9, factor=factor, heading="one")
        back = dives[-1]
        dives[-1] = replace(
            back,
            dr_east=-back.dr_east,
            dr_north=-back.dr_north,
            gps_east=back.gps_east - 2 * factor * back.dr_east,
            gps_north=back.gps_north - 2 * factor * back.dr_north,
        )
        inside.append([s.inside for s in replay_dives(dives).steps[-2:]])
    assert np.all(np.mean(inside, axis=0) > 0.8)
