"""Estimators between fixes: what they learn of made vehicles, and how sure they are."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import trapezoid
from synthetic_vehicle import STEADY, vehicle

from clpt_control.estimation.fix_model import FixModel, inertial_frequency, mid_time
from clpt_control.ocean.replay.session import replay_dives
from clpt_control.tides import period


def ratio(dives, estimator="kalman", model=None):
    rms = replay_dives(dives, estimator, model).rms(3)
    return rms["adaptive"] / rms["previous_dive"]


def test_estimates_lie_within_three_standard_errors():
    """Current and speed factor, 200 vehicles: within three errors in 95 %."""
    inside = 0
    for seed in range(200):
        factor = 1 + 0.1 * np.random.default_rng(1000 + seed).normal()
        step = replay_dives(vehicle(seed, 16, factor=factor), model=FixModel(("steady",))).steps[-1]
        inside += bool(
            abs(step.speed - factor) < 3 * step.speed_error
            and np.all(np.abs(step.current - STEADY) < 3 * step.current_error)
        )
    assert inside >= 190


def test_learns_what_there_is():
    for flow in ("M2", "inertial"):
        assert ratio(vehicle(1, flow=flow)) < 0.3
    step = replay_dives(vehicle(2, 40, factor=0.9)).steps[-1]
    assert step.speed == pytest.approx(0.9, abs=0.01)
    assert "speed" in step.learned


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
def test_against_the_previous_dives_current(case, most):
    ratios = [ratio(vehicle(seed, **case)) for seed in range(6)]
    assert np.sqrt(np.mean(np.square(ratios))) < most


@pytest.mark.parametrize("case", [{"walk": 0.03}, {"noise": 0.05}, {"flow": "M2"}])
def test_ellipses_hold_what_they_promise(case):
    inside = [replay_dives(vehicle(seed, **case)).summary()["inside_90"] for seed in range(6)]
    assert 0.83 < np.mean(inside) <= 1


def test_what_is_not_excited_is_held():
    dives = [replace(d, dr_east=600.0, dr_north=300.0) for d in vehicle(1, 6, fix=400.0)]
    last = replay_dives(dives).steps[-1]
    assert {"speed", "compass"} <= set(last.held)
    assert last.speed == pytest.approx(1, abs=0.02)
    assert "current_east" in last.learned


def test_the_coriolis_turn_is_right():
    model, dive = FixModel(("steady", "inertial"), False), vehicle(1, 1)[0]
    dt, w = 7200.0, inertial_frequency(dive.lat_gps2)
    east, north = model.turning(dt, dive.lat_gps2)[2:, 2:] @ [1.0, 0.0]
    assert (east, north) == pytest.approx((math.cos(w * dt), -math.sin(w * dt)))  # clockwise
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
