"""The watch on the speed: losses are flagged, healthy vehicles are left alone."""

from dataclasses import replace

import numpy as np
import pytest
from synthetic_vehicle import vehicle

from clpt_control.estimation.fix_model import FixModel
from clpt_control.replay.doubts import SpeedWatch


@pytest.mark.parametrize("case", [{}, {"noise": 0.01}, {"walk": 0.01}, {"flow": "M2"}])
def test_lost_speed_is_flagged(case):
    for seed in range(5):
        watch = SpeedWatch(FixModel())
        found = [a for a in map(watch.step, vehicle(seed, 24, fault=20, **case)) if a]
        late = [a for a in found if a.dive >= 20]
        assert late[0].dive in (20, 21, 22)
        assert late[0].change == pytest.approx(-0.15, abs=0.08)
        assert "evidence" in str(late[0])


@pytest.mark.parametrize("case", [{}, {"noise": 0.02}, {"walk": 0.03}, {"flow": "inertial"}])
def test_healthy_vehicles_are_left_alone(case):
    flags = 0
    for seed in range(4):
        watch = SpeedWatch(FixModel())
        flags += sum(watch.step(dive) is not None for dive in vehicle(50 + seed, 100, **case))
    assert flags <= 4  # in 400 dives


def test_a_vehicle_that_does_not_swim_says_nothing_of_speed():
    drifting = [replace(d, dr_east=0.0, dr_north=0.0) for d in vehicle(1, 30, noise=0.02)]
    moved = [*vehicle(1, 14, noise=0.02), *drifting[14:]]
    for dives in (drifting, moved):
        watch = SpeedWatch(FixModel())
        found = [a for a in map(watch.step, dives) if a]
        assert all(
            np.isfinite([a.change, a.standard_error, a.likelihood_ratio]).all() for a in found
        )
        assert len(found) <= 1


def test_on_one_heading_the_flag_says_that_it_may_be_a_current():
    dives = vehicle(3, 26, heading="one", noise=0.005)
    against = [
        replace(
            d, gps_east=d.gps_east - 0.15 * d.dr_east, gps_north=d.gps_north - 0.15 * d.dr_north
        )
        for d in dives[20:]
    ]
    watch = SpeedWatch(FixModel())
    found = [a for a in map(watch.step, [*dives[:20], *against]) if a]
    assert found
    assert not found[0].certain
    assert "a current from ahead looks the same" in str(found[0])
    certain = SpeedWatch(FixModel())
    flags = [a for a in map(certain.step, vehicle(1, 24, fault=20)) if a]
    assert flags[0].certain


def test_a_front_across_the_track_is_no_lost_speed():
    for seed in range(6):
        dives = vehicle(seed, 28, noise=0.005)
        beyond = [
            replace(
                d,
                gps_east=d.gps_east
                - 0.2 * d.duration * d.dr_north / np.hypot(d.dr_east, d.dr_north),
                gps_north=d.gps_north
                + 0.2 * d.duration * d.dr_east / np.hypot(d.dr_east, d.dr_north),
            )
            for d in dives[20:22]
        ]
        watch = SpeedWatch(FixModel())
        assert not [a for a in map(watch.step, [*dives[:20], *beyond]) if a and a.dive >= 20]
