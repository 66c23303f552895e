"""A Slocum and a SeaExplorer: real files against plain arithmetic, made ones exact."""

import csv
import gzip
import shutil

import numpy as np
import pytest

from clpt_control.errors import DataError
from clpt_control.gliders import read_dives, usable
from clpt_control.gliders.dives import files_before
from clpt_control.replay.follow import Follower


def test_rosie_agrees_with_its_own_current(facts):
    dives, skipped = read_dives(facts / "glider/slocum_rosie/sbd")
    assert skipped == []
    assert [d.number for d in dives] == [970157, 970159, 970161, 980000, 980002, 980003]
    off = [
        np.hypot(d.miss_east / d.duration - d.dac_east, d.miss_north / d.duration - d.dac_north)
        for d in dives
    ]
    assert np.median(off) < 6e-3
    assert sorted(off)[-2] < 1e-2
    (noted,) = [d for d in dives if d.notes]
    assert noted.number == 970161  # its last ten minutes are after its last logged place
    assert all(16.5 < d.magvar < 18.0 for d in dives)  # a SeaExplorer there says 17
    used, left_out = usable(dives)
    assert (len(used), left_out) == (6, [])
    assert not any("missing" in note for dive in used for note in dive.notes)


def test_the_folder_of_lists_can_be_named(facts, tmp_path, monkeypatch):
    shutil.copy(facts / "glider/slocum_rosie/sbd/rosie_713-2019-170-0-2.sbd", tmp_path)
    with pytest.raises(DataError, match=r"6b016a2e\.cac was not found .* CLPT_CAC"):
        read_dives(tmp_path)
    monkeypatch.setenv("CLPT_CAC", str(facts / "glider/slocum_rosie/cac"))
    assert len(read_dives(tmp_path)[0]) == 1


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


def test_a_place_that_is_repeated_behind_a_row_without_one_is_no_new_fix(tmp_path):
    """At 13:21 the vehicle is up with the place that it left; the first new fix is of 13:25."""
    rows = [(0, 116, 0, "4500.000"), (1, 116, 0, "4500.100"), (2, 110, 9, "4500.100")]
    rows += [(k, 110 if k < 40 else 117, 9, "4500.100") for k in range(3, 80)]
    rows += [(80, 116, 0, ""), (81, 116, 0, "4500.100"), (85, 116, 0, "4500.900")]
    text = HEADER + "".join(
        f"09/04/2024 {12 + k // 60}:{k % 60:02d}:00;{state};0;0;{-20 if k < 40 else 20};{depth};"
        f"{lat};-3000.000;\n"
        for k, state, depth, lat in rows
    )
    (tmp_path / "sea001.1.gli.sub.1").write_text(text)
    ((dive,), _) = read_dives(tmp_path)
    assert (dive.duration, dive.lat_gpse) == (84 * 60.0, pytest.approx(45 + 0.9 / 60))


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


@pytest.mark.parametrize(("steered", "course"), [(("301", "312.5"), 312.5), (("", ""), None)])
def test_a_seaexplorer_steers_its_last_desired_heading(tmp_path, facts, steered, course):
    for path in sorted((facts / "glider/sea035").iterdir()):
        head, *lines = path.read_text().splitlines()
        early, late = steered
        rows = [f"{line}{early if k < len(lines) / 2 else late};" for k, line in enumerate(lines)]
        (tmp_path / path.name).write_text("\n".join([f"{head}DesiredH;", *rows]) + "\n")
    ((dive,), _) = read_dives(tmp_path)
    assert dive.next_course == course
