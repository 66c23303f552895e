"""Aiming: the triangle of currents, what cannot be made, geodesics, tides."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from refusals import refuses
from synthetic_vehicle import along, chained, vehicle

from clpt_control import ScenarioError
from clpt_control.base.geodesy import displacement, place_from
from clpt_control.ocean.forecast.aim import triangle
from clpt_control.replay import replay_dives

REACHED, UNDER_WAY, AGAINST = "reached", "under way", "cannot be made"

ways = st.floats(-5000, 5000)


@settings(derandomize=True, max_examples=300)
@given(ways, ways, ways, ways, st.floats(10, 5000))
def test_the_triangle_of_currents(x, y, east, north, s):
    g, c = 20 * np.array([x, y]), np.array([east, north])
    length, current = np.hypot(*g), np.hypot(*c)
    assume(length > 1 and abs(s - current) > 1e-3 * s)
    w, state, tau = triangle(g, c, s)
    assert np.isfinite(w).all()
    assert np.hypot(*w) <= s * (1 + 1e-9)
    line = g / length
    across = np.array([line[1], -line[0]])
    if state == REACHED:
        assert w + c == pytest.approx(g, abs=1e-6)
    elif state == UNDER_WAY:
        # sin(crab) = current across the line / speed; the way made good is on the line
        assert np.hypot(*w) == pytest.approx(s)
        assert w @ across == pytest.approx(-c @ across, abs=1e-6 * s)
        root = math.sqrt(s**2 - (c @ across) ** 2)
        made, other = c @ line + root, c @ line - root
        assert (
            length / tau == pytest.approx(made, rel=1e-6, abs=1e-6 * s) or current > s
        )
        assert min(abs(length / tau - made), abs(length / tau - other)) < 1e-6 * (
            s + current
        )
    else:
        assert (state, tau) == (AGAINST, None)
        assert current > s  # in a slower current every place can be made
        a = np.linspace(0, 2 * math.pi, 721)
        best = np.hypot(
            *((g - c)[:, None] - s * np.array([np.sin(a), np.cos(a)]))
        ).min()
        assert np.hypot(*(g - c - w)) <= best * (1 + 1e-12)


def still(current=(0.0, 0.0), count=12, place=(40.0, 8.0)):
    """Dives of a steady current (m/s) on all headings, 0.25 m/s of 4 h, from fix to fix."""
    reckoned = [along(math.degrees(2.4 * k), 3600.0) for k in range(count)]
    return chained(
        [(dr, dr + 14400 * np.array(current), 14400.0) for dr in reckoned], place
    )


def known(*current):
    """A replay of a steady current that is known."""
    return replay_dives(still(current), flow=("steady",), learn_speed=False)


def away(replay, east, north):
    """A place so far, m, from where the vehicle came up last."""
    last = replay.steps[-1].dive
    return place_from(last.lat_gpse, last.lon_gpse, east, north)


def test_a_current_across_the_line_is_held_off():
    replay = known(0.1, 0.0)
    here = away(replay, 0.0, 0.0)
    leg = replay.aims([(45.0, here[1])])[0]
    assert leg.heading == pytest.approx(
        360 - math.degrees(math.asin(0.1 / 0.25)), abs=0.5
    )
    assert leg.made_good == pytest.approx(14400 * math.sqrt(0.25**2 - 0.1**2), rel=0.01)
    assert leg.ahead.longitude == pytest.approx(here[1], abs=1e-4)
    stay = replay.aims([here])[0]  # where it is
    assert stay.bearing is stay.crab is None
    assert stay.heading == pytest.approx(270, abs=1)
    assert stay.through_water == pytest.approx(1440, rel=0.02)


def test_speed_and_compass_are_corrected():
    """A vehicle that goes 4 degrees to the right at 0.8 of its speed is steered to the left."""
    dives = []
    for dive in still():
        # east + i north, counter-clockwise
        way = complex(dive.dr_east, dive.dr_north) / 0.8 * np.exp(1j * np.radians(4.0))
        dives.append(replace(dive, dr_east=way.real, dr_north=way.imag))
    replay = replay_dives(dives, flow=("steady",))
    for way in ((0.0, 300e3), (300e3, 0.0)):
        leg = replay.aims([away(replay, *way)])[0]
        assert leg.crab == pytest.approx(-4.0, abs=0.6)
        assert leg.speed_expected == pytest.approx(0.25, rel=0.02)
        # none of it is the current's
        assert leg.current == pytest.approx((0.0, 0.0), abs=4e-3)
        assert leg.made_good == pytest.approx(3600, rel=0.02)


def test_what_cannot_be_made_is_said():
    replay = known(0.4, 0.0)
    legs = replay.aims([away(replay, -30e3, 0.0), (40.0, 9.0)])
    assert [leg.state for leg in legs] == [AGAINST]  # and none after it
    assert (legs[0].heading, legs[0].dives) == (pytest.approx(270, abs=0.5), None)
    assert legs[0].made_good < 0
    assert replay.aims([away(replay, 60e3, 0.0)])[0].state == UNDER_WAY
    near = replay.aims([away(replay, 1000.0, 0.0)])[0]
    assert near.state == REACHED  # by a shorter dive, else it is carried past
    assert near.ahead.plan.duration < 14400
    assert near.left < 5
    fast = known(0.25 - 1e-7, 0.0)  # m/s; as fast as the vehicle, all but
    legs = fast.aims([away(fast, -500e3, 0.0), (40.0, 0.0)], speed=0.2502)
    # what takes years has none after it
    assert [leg.state for leg in legs] == [UNDER_WAY]
    assert json.dumps(legs[0].as_dict(), allow_nan=False)


@pytest.mark.long
@settings(derandomize=True, max_examples=25, deadline=None)
@given(
    st.floats(-75, 75), st.floats(-180, 180), st.floats(0, 360), st.floats(200, 2500)
)
def test_a_waypoint_within_reach_is_met_on_the_ellipsoid(lat, lon, angle, far):
    replay = replay_dives(still((0.05, 0.02), 4, (lat, lon)))
    way = along(angle, far)
    leg = replay.aims([away(replay, *way)], duration=21600.0)[0]
    assert leg.state == REACHED
    assert leg.left < 2
    assert leg.through_water <= leg.through_water_full * (1 + 1e-9)
    assert json.dumps(leg.as_dict(), allow_nan=False)


def test_legs_follow_one_another():
    replay = replay_dives(still((0.05, 0.0)))
    first, second = (40.2, 8.1), (40.2, 8.4)
    one, two = replay.aims([first, second])
    assert (two.ahead.plan.lat_gps2, two.ahead.plan.lon_gps2) == first
    assert two.distance == pytest.approx(math.hypot(*displacement(*first, *second)))
    # at the surface between the dives
    took = one.dives * 14400 + 600 * math.floor(one.dives)
    assert one.dives > 5
    assert one.as_dict()["hours"] == pytest.approx(took / 3600)
    later = one.ahead.plan.t_gps2 + took + 600
    assert two.ahead.plan.t_gps2 == pytest.approx(later, abs=1)
    assert replay.aims([first])[0].as_dict() == one.as_dict()


def test_tides_are_those_of_the_dive_to_come():
    dives = vehicle(3, 40, flow="M2", fix=5.0)
    replay = replay_dives(dives, flow=("steady", "M2"), learn_speed=False)
    last = dives[-1]
    seen = set()
    for hours in (1.0, 4.0, 7.0):  # a third of the tide's period apart
        start = last.t_gpse + 3600 * hours, last.lat_gpse, last.lon_gpse
        leg = replay.aims([(41.0, 8.0)], 0.25, 7200.0, start=start)[0]
        plan = replace(leg.ahead.plan, dr_east=0.0, dr_north=0.0)
        assert leg.current == pytest.approx(replay.forecast(plan)[0] / 7200.0, abs=1e-4)
        seen.add(round(leg.heading))
    assert len(seen) == 3


def test_magnetic_headings(sg542):
    bare = [replace(step.dive, magvar=None) for step in sg542.steps[:3]]
    for replay, more, east, tolerance in (
        (sg542, {}, -25.0, 1e-9),  # of the files
        (sg542, {"variation": 10.0}, 10.0, 1e-9),
        (replay_dives(bare), {}, -25.0, 3.0),  # IGRF
    ):
        leg = replay.aims([(-42.5, 8.0)], **more)[0]
        assert leg.magnetic_variation == pytest.approx(east, abs=tolerance)
        magnetic = (leg.heading - leg.magnetic_variation) % 360
        assert leg.heading_magnetic == pytest.approx(magnetic)


def test_a_speed_that_no_vehicle_has_is_refused():
    for more, says in (
        ({"speed": 25.0}, "at most 5 m/s"),
        ({"duration": math.inf}, "inf hours"),
    ):
        refuses(says, known(0.0, 0.0).aims, [(40.0, 8.0)], error=ScenarioError, **more)
