"""East and north turn with the position: long legs, functions that are the same everywhere."""

from math import cos, radians, sin

import numpy as np
import pytest
from geodesics import place_from
from small_scenarios import uniform_flow

import clpt_control as clpt

FLOW = (-0.12, 0.2)  # m/s to the east and to the north, everywhere


def carried(latitude, longitude, course, seconds):
    """The position of a vehicle of 1 m/s that holds a true course in the flow."""
    for _ in range(round(seconds / 60)):
        way = sin(radians(course)) + FLOW[0], cos(radians(course)) + FLOW[1]
        latitude, longitude = place_from(latitude, longitude, *(60 * w for w in way))
    return latitude, longitude


@pytest.mark.parametrize(
    ("latitude", "courses", "hours"), [(68.0, [250.0], 18), (-74.0, [90.0, 60.0], 24)]
)
def test_a_course_on_a_long_leg_keeps_the_guarantee(latitude, courses, hours):
    learner = clpt.currents.FlowEstimator(uniform_flow())
    noise = np.random.default_rng(2).normal(0, 5, (10, 2))
    position, time = (latitude, 30.0), 1.7e9
    for leg, error in enumerate(noise):
        learned = learner.fix(time, *place_from(*position, *error))
        off = np.hypot(*(learner.flow_parameters[:, 0] - FLOW))
        assert off < learned.guaranteed
        course = courses[leg % len(courses)]
        east, north = 3600 * sin(radians(course)), 3600 * cos(radians(course))
        for _ in range(hours):
            position, time = carried(*position, course, 3600), time + 3600
            learner.move(time, east, north)
    assert off < 0.004


@pytest.mark.parametrize("method", ["kalman", "tomography"])
@pytest.mark.parametrize(("latitude", "course"), [(-71.0, 135.0), (79.0, 80.0)])
def test_functions_that_are_the_same_everywhere_have_local_axes(
    tmp_path, method, latitude, course
):
    position, time, rows = (latitude, 179.5), 1777593600.0, []
    east, north = 7200 * sin(radians(course)), 7200 * cos(radians(course))
    for leg in range(30):
        after = carried(*position, course, 7200)
        rows.append((leg, time, *position, time + 7200, *after, east, north))
        position, time = after, time + 7200
    head = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,dr_north_m"
    lines = [",".join(map(str, row)) for row in rows]
    (tmp_path / "legs.csv").write_text("\n".join([head, *lines]))
    legs, _ = clpt.gliders.read_dives(tmp_path / "legs.csv")
    learned = clpt.currents.flow_estimate(legs, uniform_flow(), method=method)
    theta = learned.flow_parameters_estimate.values[-1][:, 0]
    np.testing.assert_allclose(theta, FLOW, atol=0.003)
    error = learned.standard_error.values[-1][0]
    far = latitude + np.array([-3.0, 3.0]), np.array([170.0, 190.0])
    near = learned.latitude.values[-1:], learned.longitude.values[-1:]
    for grid, largest in ((near, 0.02), (far, 0.51), ((), 0.51)):  # far: the prior
        flow = clpt.flow_map(learned, *grid)
        np.testing.assert_allclose(flow.u, FLOW[0], atol=0.003)
        np.testing.assert_allclose(flow.v, FLOW[1], atol=0.003)
        assert np.all((error < flow.standard_error) & (flow.standard_error < largest))


@pytest.mark.parametrize("law", ["fix-regression", "kalman-flow"])
@pytest.mark.long
def test_fixes_at_the_surface_widen_no_region_and_narrow_none(law):
    """Eight fixes in 4 minutes, whose error lasts 10 minutes: one surfacing, not eight."""
    inside = []
    for seed in range(3):
        random = np.random.default_rng(seed)
        learner = clpt.currents.FlowEstimator(uniform_flow(law))
        position, time = (50.0, -20.0), 1.7e9
        for dive in range(14):
            error = random.normal(0, 10, 2)
            for number in range(8):
                learned = learner.fix(time, *place_from(*position, *error))
                if number == 0 and dive > 2:
                    inside.append(learned.inside)
                error = 0.95 * error + random.normal(0, 10 * (1 - 0.95**2) ** 0.5, 2)
                time += 30
                drift = 30 * FLOW[0], 30 * FLOW[1]
                position = place_from(*position, *drift)
                learner.move(time, 0.0, 0.0)
            course = 100.0 * dive
            position = carried(*position, course, 10800)
            position = place_from(*position, *random.normal(0, 0.02 * 10800, 2))
            way = 10800 * sin(radians(course)), 10800 * cos(radians(course))
            time += 10800
            learner.move(time, *way)
    assert len(inside) == 33
    assert 0.75 < np.mean(inside) <= 1
