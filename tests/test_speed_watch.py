"""The watch on the speed: losses are flagged, healthy vehicles are left alone."""

import pytest
from synthetic_vehicle import vehicle

from clpt_control.estimation.fix_model import FixModel
from clpt_control.ocean.replay.anomaly import SpeedWatch


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
