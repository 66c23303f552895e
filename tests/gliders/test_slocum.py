"""Segments of a Slocum and a SeaExplorer: real ones against plain arithmetic, made ones exact."""

import csv
import gzip
import shutil
from itertools import permutations

import numpy as np
import pytest
from slocum_bytes import CRC, SENSORS, VARIATION, cac, ddmm, magnetic, place_at, segment

from clpt_control.errors import DataError
from clpt_control.gliders import read_dives, usable
from clpt_control.gliders.dives import files_before
from clpt_control.gliders.slocum import dives_of
from clpt_control.replay.follow import Follower

T0, HOME = 1.7126e9, (51.6, -128.3)
SWIM, SEA, BEFORE = np.array([0.30, -0.12]), np.array([-0.05, 0.10]), np.array([0.08, 0.06])
LASTS = 6000.0  # s


def rows(names, added=0.0, every=60, used=None):
    """Return cycles of a dive at steps of 60 s in a sea, dead reckoning in `names` every so often.

    The vehicle swims for all of LASTS, adding so much of the current of the dive before.
    """
    out = []
    wx, wy = magnetic(BEFORE)
    first = {"m_water_vx": wx, "m_water_vy": wy, "m_gps_mag_var": -np.radians(VARIATION)}
    if used is not None:
        first["u_use_current_correction"] = used
    for since in np.arange(0.0, LASTS + 180.0, 60.0):
        row = {"m_present_time": T0 + since, "m_heading": np.arctan2(*magnetic(SWIM)) % (2 * np.pi)}
        surfaced = since == 0.0 or since >= LASTS
        row["m_depth"] = 0.0 if surfaced else 60.0
        reckoned = (SWIM + added * BEFORE) * min(since, LASTS)
        if not surfaced and since % every == 0:
            at = (
                (ddmm(a) for a in place_at(HOME, reckoned))
                if names[0] == "m_lat"
                else magnetic(reckoned)
            )
            row |= dict(zip(names, at, strict=True))
        if surfaced:
            lat, lon = place_at(HOME, (SWIM + SEA) * min(since, LASTS))
            row |= {"m_gps_lat": ddmm(lat), "m_gps_lon": ddmm(lon), "m_gps_status": 0.0}
        if since == 0.0:
            row |= first
            if names[0] == "m_x_lmc":
                row |= {"m_x_lmc": 0.0, "m_y_lmc": 0.0}
        if since == LASTS:
            row |= dict(zip(("m_water_vx", "m_water_vy"), magnetic(SEA), strict=True))
        out.append(row)
    return out


def made(folder, *parts, names=SENSORS):
    """Write rows as segments, with their list."""
    (folder / "cac").mkdir(exist_ok=True)
    (folder / "cac" / f"{CRC.upper()}.CAC").write_bytes(cac(names))
    for k, part in enumerate(parts):
        path = folder / f"unit-2024-100-7-{k}.sbd"
        path.write_bytes(segment(part, names, f"0007{k:04d}", path.stem))
    return folder


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


@pytest.mark.parametrize("every", [60, 600])
@pytest.mark.parametrize("names", [("m_lat", "m_lon"), ("m_x_lmc", "m_y_lmc")])
@pytest.mark.parametrize("added", [0.0, 1.0])
def test_a_made_dive_is_that_of_its_sea(tmp_path, names, added, every):
    (dive,) = dives_of(made(tmp_path, rows(names, added, every)) / "unit-2024-100-7-0.sbd")
    # under water the first and last minute are at the surface
    assert (dive.dr_east, dive.dr_north) == pytest.approx(SWIM * LASTS, abs=60.0)
    assert (dive.dac_east, dive.dac_north) == pytest.approx(SEA, abs=1e-9)
    assert dive.magvar == pytest.approx(17.0)
    assert dive.duration == LASTS
    assert any("that current is" in note for note in dive.notes) == bool(added)
    if not added:
        ends = [dive.track[k][-1] - (dive.dr_east, dive.dr_north)[k - 1] for k in (1, 2)]
        assert ends == [0, 0]


def test_without_an_own_current_the_glider_says_whether_it_added_it(tmp_path):
    for used in (0.0, 1.0):
        part = rows(("m_lat", "m_lon"), used, 60, used)
        for row in part[1:]:
            row.pop("m_water_vx", None)
        (dive,) = dives_of(made(tmp_path, part) / "unit-2024-100-7-0.sbd")
        assert (dive.dr_east, dive.dr_north) == pytest.approx(SWIM * LASTS, abs=60.0)
        assert dive.dac_east is None


def test_a_dive_over_several_files_is_one(tmp_path):
    whole = rows(("m_lat", "m_lon"))
    one = dives_of(made(tmp_path, whole) / "unit-2024-100-7-0.sbd")
    made(tmp_path, whole[:3], whole[3:50], whole[50:])
    assert [len(dives_of(tmp_path / f"unit-2024-100-7-{k}.sbd")) for k in range(3)] == [0, 0, 1]
    (dive,) = read_dives(tmp_path)[0]
    assert dive.dr_east == pytest.approx(one[0].dr_east, abs=1e-6)
    assert files_before(tmp_path / "unit-2024-100-7-2.sbd") == [
        tmp_path / f"unit-2024-100-7-{k}.sbd" for k in range(2)
    ]
    (tmp_path / "unit-2024-100-7-1.sbd").unlink()
    (dive,) = read_dives(tmp_path)[0]
    assert np.isnan(dive.dr_east)  # two thirds of it are missing
    assert any("no samples for" in note for note in dive.notes)


@pytest.fixture(scope="module")
def in_three_files(tmp_path_factory):
    """A dive in three files and a folder of lists, and what is read of them."""
    source, whole = tmp_path_factory.mktemp("source"), rows(("m_lat", "m_lon"))
    made(source, whole[:3], whole[3:50], whole[50:])
    return source, read_dives(source)


@pytest.mark.parametrize("order", list(permutations(range(4)))[::5])
def test_followed_files_come_in_any_order(in_three_files, tmp_path, order):
    (source, wanted), inbox = in_three_files, tmp_path / "inbox"
    inbox.mkdir()
    follower = Follower(inbox, tmp_path / "state")
    things = [*sorted(source.glob("*.sbd")), source / "cac"]
    for k in order:
        if things[k].is_dir():
            shutil.copytree(things[k], inbox / "cac")
        else:
            shutil.copy(things[k], inbox)
        follower.look()
    assert follower.dives() == wanted
    for path in inbox.glob("*-[01].sbd"):
        path.unlink()
        follower.look()
    assert follower.dives()[0] == wanted[0]
    again = Follower(inbox, tmp_path / "state")
    again.look()
    assert again.dives()[0] == wanted[0]


def test_the_folder_of_lists_can_be_named(facts, tmp_path, monkeypatch):
    shutil.copy(facts / "glider/slocum_rosie/sbd/rosie_713-2019-170-0-2.sbd", tmp_path)
    with pytest.raises(DataError, match=r"6b016a2e\.cac was not found .* CLPT_CAC"):
        read_dives(tmp_path)
    monkeypatch.setenv("CLPT_CAC", str(facts / "glider/slocum_rosie/cac"))
    assert len(read_dives(tmp_path)[0]) == 1


def test_a_file_that_holds_its_own_list_needs_none_beside_it(tmp_path):
    wanted = read_dives(made(tmp_path, rows(("m_lat", "m_lon"))))
    shutil.rmtree(tmp_path / "cac")
    (path,) = tmp_path.iterdir()
    raw = segment(rows(("m_lat", "m_lon")), SENSORS, "00070000", path.stem, factored=0)
    path.write_bytes(raw)
    assert read_dives(tmp_path) == wanted
    path.write_bytes(raw[: raw.index(b"m_depth")])
    with pytest.raises(DataError, match=r"is no list of \d+ sensors"):
        read_dives(tmp_path)


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


def test_a_file_without_a_fix_says_so(facts, tmp_path):
    text = (facts / "glider/sea035/SEA035.10.gli.sub.003").read_text()
    (tmp_path / "sea035.10.gli.sub.003").write_text(text.replace(";116;", ";117;"))
    with pytest.raises(DataError, match=r"no row with a fix \(NavState 116\)"):
        read_dives(tmp_path)


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
