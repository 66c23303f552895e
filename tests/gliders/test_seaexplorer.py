"""SeaExplorer navigation files, against the dives that another program drew from them."""

import csv
import gzip
import shutil

import numpy as np
import pytest

from clpt_control.gliders import read_dives
from clpt_control.gliders.dives import files_before
from clpt_control.replay.follow import Follower

HEADER = "Timestamp;NavState;Heading;Declination;Pitch;Depth;Lat;Lon;\n"


def test_the_first_dive_is_that_of_the_table(facts):
    ((dive,), skipped) = read_dives(facts / "glider/sea035")
    assert skipped == []
    with (facts / "glider/sea035m10_dives.csv").open() as file:
        row = next(csv.DictReader(line for line in file if not line.startswith("#")))
    for name in ("t_gps2", "lat_gps2", "lon_gps2", "t_gpse", "lat_gpse", "lon_gpse"):
        assert getattr(dive, name) == pytest.approx(float(row[name]), abs=1e-6), name
    reckoned = float(row["dr_east_m"]), float(row["dr_north_m"])
    assert (dive.dr_east, dive.dr_north) == pytest.approx(reckoned, abs=0.5)
    assert dive.depth_max == pytest.approx(float(row["depth_max"]), abs=0.5)
    assert dive.magvar == 17.0


@pytest.mark.parametrize(("heading", "declination"), [(0.0, 0.0), (73.0, 17.0), (350.0, -20.0)])
def test_a_v_of_constant_slope_is_depth_over_tangent(tmp_path, heading, declination):
    """Down to 100 m and up at 20 degrees: 2 * 100 m/tan(20 deg) along heading + declination."""
    text = HEADER + "09/04/2024 11:59:00;116;0;0;0;0;4500.000;-3000.100;\n"
    for k in range(203):
        depth, down = (k - 1, True) if k <= 101 else (201 - k, False)
        surface = k == 0 or k == 202
        text += (
            f"09/04/2024 12:{k * 10 // 60:02d}:{k * 10 % 60:02d};{116 if surface else 100};"
            f"{heading};{declination};{-20 if down else 20};{0 if surface else depth};"
            f"4500.{'200' if k == 202 else '000'};-3000.000;\n"
        )
    (tmp_path / "sea001.1.gli.sub.1").write_text(text)
    ((dive,), _) = read_dives(tmp_path)
    length = 2 * 100 / np.tan(np.radians(20.0))
    true = np.radians(heading + declination)
    there = length * np.sin(true), length * np.cos(true)
    assert (dive.dr_east, dive.dr_north) == pytest.approx(there, abs=0.02 * length)
    assert dive.duration == 2020.0


def test_a_dive_of_two_files_comes_with_the_second(facts, tmp_path):
    names = ["SEA035.10.gli.sub.002", "SEA035.10.gli.sub.003"]
    source = facts / "glider/sea035"
    for order in (names, names[::-1]):
        inbox = tmp_path / order[0]
        inbox.mkdir()
        follower = Follower(inbox, tmp_path / f"{order[0]}.state")
        for name in order:
            (inbox / f"{name}.gz").write_bytes(gzip.compress((source / name).read_bytes()))
            follower.look()
        assert follower.dives() == read_dives(source)
    other = tmp_path / "other"
    other.mkdir()
    (other / "sea036.10.gli.sub.002").write_text("")
    shutil.copy(source / names[1], other)
    assert files_before(other / names[1]) == []
