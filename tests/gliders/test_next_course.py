"""The plan of the next dive in the files of a Slocum and a SeaExplorer."""

import numpy as np
import pytest
from pyproj import Geod
from slocum_bytes import SENSORS, VARIATION, ddmm
from test_slocum_mission import Mission

from clpt_control.gliders import read_dives

WAYPOINT = (51.9, -127.7)


def planned(folder, **said):
    """Return the last dive of a mission whose glider says where it goes."""
    mission = Mission(folder, (*SENSORS, *said))
    mission.says(**said)
    mission.dive(0)
    return read_dives(folder)[0][-1]


def test_a_slocum_goes_to_its_waypoint(tmp_path):
    lat, lon = map(ddmm, WAYPOINT)
    dive = planned(tmp_path, c_wpt_lat=lat, c_wpt_lon=lon, c_heading=1.0)
    bearing = Geod(ellps="WGS84").inv(dive.lon_gpse, dive.lat_gpse, *WAYPOINT[::-1])[0]
    assert dive.next_course == pytest.approx(bearing % 360, abs=0.05)


def test_a_slocum_without_a_waypoint_goes_along_its_heading_from_magnetic_north(tmp_path):
    dive = planned(tmp_path, c_heading=1.0)
    assert dive.next_course == pytest.approx((np.degrees(1.0) + VARIATION) % 360)


def test_a_slocum_that_says_neither_has_no_plan(tmp_path):
    assert planned(tmp_path).next_course is None


@pytest.mark.parametrize(("steered", "course"), [(("301", "312.5"), 312.5), (("", ""), None)])
def test_a_seaexplorer_steers_its_last_desired_heading(tmp_path, facts, steered, course):
    for path in sorted((facts / "glider/sea035").iterdir()):
        head, *lines = path.read_text().splitlines()
        early, late = steered
        rows = [f"{line}{early if k < len(lines) / 2 else late};" for k, line in enumerate(lines)]
        (tmp_path / path.name).write_text("\n".join([f"{head}DesiredH;", *rows]) + "\n")
    ((dive,), _) = read_dives(tmp_path)
    assert dive.next_course == course
