"""Files of real vehicles in `tests/data` against plain netCDF4, WGS84 and IGRF; round trips."""

import csv
import re
from dataclasses import replace
from itertools import pairwise
from math import isfinite, nan

import netCDF4
import numpy as np
import pytest
from glider_files import error_of, used_numbers
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pyproj import Geod

from clpt_control.gliders import make_dive, read_dives, sample_dives, write_dive_table
from clpt_control.replay import replay_dives

WGS84 = Geod(ellps="WGS84")


@pytest.fixture(scope="module")
def dives(facts):
    found, skipped = read_dives(facts / "glider" / "basestation", usable=False)
    assert not skipped
    return found


@pytest.fixture(scope="module")
def rows(facts):
    with (facts / "glider" / "sg542_2016_dives.csv").open() as file:
        return {int(row["dive"]): row for row in csv.DictReader(file)}


TABLE = (  # columns, and to how much they agree
    ("lat_gps1 lon_gps1 lat_gps2 lon_gps2 lat_gpse lon_gpse", 1e-8),
    ("t_gps1 t_gps2 t_gpse magvar dac_qc", 0),
    ("gps_east_m gps_north_m dr_east_m dr_north_m", 1e-3),
    ("dac_east dac_north", 1e-9),
)


def test_the_files_give_the_table(dives, rows):
    assert [dive.number for dive in dives] == list(range(304, 310))
    assert set(rows) == set(range(304, 318))
    for dive in dives:
        for names, off in TABLE:
            for name in names.split():
                wanted = pytest.approx(float(rows[dive.number][name]), abs=off, rel=0)
                assert getattr(dive, name.removesuffix("_m")) == wanted, name


def test_miss_over_duration_is_the_current_of_the_file(dives, facts):
    for found in (
        dives,
        read_dives(facts / "glider" / "sg542_2016_dives.csv", usable=False)[0],
    ):
        off = [error_of(dive)[1] for dive in found]
        assert np.median(off) < 0.6e-3
        assert max(off) < 1e-3


@pytest.mark.slow
def test_the_shipped_table_is_that_of_the_whole_files(shared):
    # what whole files alone hold
    left = ("track", "notes", "vehicle", "kind", "next_course")
    ones, others = (
        [
            {key: value for key, value in vars(dive).items() if key not in left}
            for dive in found
        ]
        for found in (
            sample_dives(),
            read_dives(shared / "glider" / "basestation", usable=False)[0],
        )
    )
    assert repr(ones) == repr(others)


NONE = (-999.0, -9999.0, -99999.0)  # numbers that stand for "none" in such files
number = st.floats(-1e12, 1e12).filter(lambda one: one not in NONE)
longitude = st.floats(-360, 360).filter(lambda one: one != 181.0)  # AIS: not available
place = st.tuples(number, st.floats(-90, 90), longitude)
through = st.tuples(st.one_of(number, st.just(nan)), number)
OPTIONAL = (
    "t_gps1 lat_gps1 lon_gps1 dac_east dac_north dac_qc magvar depth_max next_course"
)
more = dict.fromkeys(OPTIONAL.split(), st.one_of(st.none(), number))
more |= dict.fromkeys(
    ("magvar", "next_course"), st.one_of(st.none(), st.floats(-180, 180))
)
made = st.builds(make_dive, st.integers(-10, 10**9), place, place, through, **more)


def with_right_current(dive):
    """Return a dive whose own current, if it has one, does not contradict its dead reckoning."""
    if not dive.duration > 1:
        return replace(dive, dac_east=None, dac_north=None)
    names, current = ("dac_east", "dac_north"), error_of(dive)[0] / dive.duration
    right = {
        name: float(one)
        for name, one in zip(names, current, strict=True)
        if getattr(dive, name) is not None and isfinite(one)
    }
    return replace(dive, **right)


@pytest.mark.long
@settings(
    max_examples=50,
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(st.lists(made.map(with_right_current), min_size=1, max_size=4))
def test_csv_round_trip(tmp_path, dives):
    write_dive_table(dives, tmp_path / "dives.csv", "a comment\nof two lines")
    back, skipped = read_dives(tmp_path / "dives.csv", usable=False)
    assert not skipped
    assert repr([*map(vars, back)]) == repr([*map(vars, dives)])  # bit for bit, NaN too


def between(lat1, lon1, lat2, lon2):
    """East and north of the geodesic at its start, m."""
    bearing, _, length = WGS84.inv(lon1, lat1, lon2, lat2)
    return length * np.sin(np.radians(bearing)), length * np.cos(np.radians(bearing))


def test_basestation3_files_say_what_they_hold(facts):
    dives, skipped = read_dives(facts / "glider" / "sg171", usable=False)
    assert (skipped, [dive.number for dive in dives]) == ([], [100, 101, 102])
    for dive in dives:
        with netCDF4.Dataset(
            facts / "glider" / "sg171" / f"p1710{dive.number}.nc"
        ) as data:
            file = {name: np.asarray(data[name][...]) for name in data.variables}
        lat, lon, time = (file[f"log_gps_{name}"] for name in ("lat", "lon", "time"))
        dr = [file[f"{axis}_displacement"].sum() for axis in ("east", "north")]
        own = [file[f"depth_avg_curr_{axis}"].item() for axis in ("east", "north")]
        way = between(lat[1], lon[1], lat[2], lon[2])
        assert (dive.gps_east, dive.gps_north) == pytest.approx(way, abs=1e-6)
        assert (dive.dr_east, dive.dr_north) == pytest.approx(dr, abs=1e-9)
        assert (dive.duration, dive.notes) == (time[2] - time[1], ())
        assert (dive.dac_east, dive.dac_north) == pytest.approx(own)
        deepest = np.nanmax(file["depth"])
        assert (dive.depth_max, dive.magvar) == pytest.approx(
            (deepest, file["magnetic_variation"].item())
        )
        # its maker divides by the time of flight, not by the time between the fixes
        current = (
            np.array([dive.miss_east, dive.miss_north]) / file["total_flight_time_s"]
        )
        assert current == pytest.approx(own, abs=2e-3)
    assert used_numbers(dives) == [100, 101, 102]


def test_the_adcp_of_the_vehicle_says_how_far_it_swam(facts):
    """An independent instrument: 1.56 times the dead reckoning (the data's description)."""
    with (facts / "glider" / "sg171_adcp.csv").open() as file:
        rows = {int(row["dive"]): row for row in csv.DictReader(file.readlines()[1:])}
    reckoned, swum = [], []
    for dive in read_dives(facts / "glider" / "sg171", usable=False)[0]:
        east, north = (float(rows[dive.number][name]) for name in ("u_east", "v_north"))
        reckoned += [dive.dr_east, dive.dr_north]
        swum += [
            dive.gps_east - east * dive.duration,
            dive.gps_north - north * dive.duration,
        ]
    assert np.dot(swum, reckoned) / np.dot(reckoned, reckoned) == pytest.approx(
        1.56, abs=0.03
    )


OG1 = "sg015_20040929T140907_delayed.nc"


def swum_in(data, dive, variation):
    """Speed times time along the heading, summed over the rows of a dive, east and north, m."""
    time, heading, speed = (
        data[name][:] for name in ("TIME", "HEADING", "HORZ_GLIDER_SPEED")
    )
    inside = (time > dive.t_gps2) & (time <= dive.t_gpse) & np.isfinite(heading)
    since = np.diff(time[inside], prepend=time[inside][0])
    cm, angle = speed[inside] * since, np.radians(heading[inside] + variation)
    return [float(np.nansum(cm * part(angle))) / 100 for part in (np.sin, np.cos)]


@pytest.mark.long
def test_an_early_og1_mission_is_read_as_it_was_meant(facts):
    """Fixes in nanoseconds without units, one in a row at 250 m, speed in cm/s, magnetic."""
    path = facts / "glider" / "og1" / OG1
    dives, unread = read_dives(path, usable=False)
    with netCDF4.Dataset(path) as data:
        is_fix = np.isfinite(np.ma.filled(data["LATITUDE_GPS"][:], np.nan))
        times = data["TIME_GPS"][:][is_fix] / 1e9
        assert data["DEPTH"][:][is_fix].max() == pytest.approx(251, abs=1)
        gaps = np.flatnonzero(np.diff(times) > 600)
        assert (unread, [dive.t_gps2 for dive in dives]) == (
            [],
            pytest.approx(times[gaps]),
        )
        assert [dive.duration for dive in dives] == pytest.approx(np.diff(times)[gaps])
        used, skipped = read_dives(path)
        # whose samples are missing
        (climb,) = (one.why for one in skipped if one.dive == 5)
        assert re.search(
            r"no samples for 3\d\d\d s of 5065 s, from 2\d\d m depth on", climb
        )
        assert 6 in [dive.number for dive in used]
        for dive in used:
            # of the Labrador Sea, 2004
            assert dive.turned == pytest.approx(-37.0, abs=0.2)
            assert (dive.dr_east, dive.dr_north) == pytest.approx(
                swum_in(data, dive, dive.turned)
            )
            said = "; ".join(dive.notes)
            assert "TIME_GPS has no units and is read as nanoseconds" in said
            assert "magnetic, variation -37 degrees (by IGRF" in said


@pytest.mark.long
def test_the_variation_of_the_command_line_turns_magnetic_headings(printed, facts):
    path = facts / "glider" / "og1" / OG1
    found = {}
    for degrees in (None, -37, 0):
        more = () if degrees is None else ("--variation", degrees)
        out = printed("replay", path, *more)
        found[degrees] = out["clpe_rms_all"]["no_flow"]
        said = [entry["note"] for entry in out["notes"]]
        assert (f"--variation: turned by {degrees} degrees instead" in said) == bool(
            more
        )
        with netCDF4.Dataset(path) as data:
            dives = {dive.number: dive for dive in read_dives(path)[0]}
            for row in out["each_dive"] if more else ():
                way = swum_in(data, dives[row["dive"]], degrees)
                assert (row["dr_east"], row["dr_north"]) == pytest.approx(way)
    assert found[-37] == pytest.approx(found[None], rel=0.01)
    assert found[0] != pytest.approx(found[None], rel=0.01)


@pytest.mark.slow
def test_a_whole_early_mission_has_32_good_long_dives(printed, shared):
    path = shared / "glider" / "og1" / OG1
    assert len(read_dives(path)[0]) == 35
    command = ("replay", path, "--least-duration", 4000)
    turned_by_field, as_true = printed(*command), printed(*command, "--variation", 0)
    assert turned_by_field["used"] == 32
    assert turned_by_field["clpe_rms"]["adaptive"] == pytest.approx(886, rel=0.02)
    assert (
        as_true["clpe_rms"]["adaptive"] > 1.8 * turned_by_field["clpe_rms"]["adaptive"]
    )


def test_a_spray_says_where_its_dives_ended(facts):
    """The sample of OG1 has ends, the segments' middles, and the current of each."""
    path = facts / "glider" / "og1" / "sp028_20230202T1637_R.nc"
    dives, skipped = read_dives(path, usable=False)
    with netCDF4.Dataset(path) as data:
        assert np.ma.count(data["latitude_gps"][:]) == 0
        # the last of each
        row = {int(n): k for k, n in enumerate(data["profile_index"][:])}
        deep = {
            n for n in row if data["depth"][:][data["profile_index"][:] == n].max() > 5
        }
        assert [dive.number for dive in dives] == sorted(deep)
        assert {one.dive for one in skipped} == set(row) - deep
        assert all("no measurement under water" in one.why for one in skipped)
        for dive in dives:
            names = (
                "time_gps_end",
                "latitude_gps_end",
                "longitude_gps_end",
                "wcur_x",
                "wcur_y",
            )
            end = [float(data[name][row[dive.number]]) for name in names]
            assert (dive.t_gpse, dive.lat_gpse, dive.lon_gpse) == tuple(end[:3])
            own = dive.miss_east / dive.duration, dive.miss_north / dive.duration
            assert own == pytest.approx(end[3:])
            middle = 0.5 * (dive.t_gps2 + dive.t_gpse)
            assert middle == pytest.approx(float(data["time_uv"][row[dive.number]]))
    for before, after in pairwise(dives):  # each starts where the one before ended
        drift = between(
            before.lat_gpse, before.lon_gpse, after.lat_gps2, after.lon_gps2
        )
        assert 0 < after.t_gps2 - before.t_gpse < 600
        assert np.hypot(*drift) < 100
    assert used_numbers(dives) == sorted(deep)
    assert len(deep) == 4


# D, degrees, of `igrf13syn` (British Geological Survey) at geodetic places: latitude,
# longitude, time (s since 1970), D; within 1.1 km of sea level, which is 0.01 degrees
PUBLISHED = [
    (59.9, -109.9, 1088640000.0, 17.29),  # 1 July 2004
    (59.9, 39.9, -2193220800.0, 5.55),  # 1 July 1900
    (-59.9, -39.9, 552182400.0, -1.45),  # 2 July 1987
]


@pytest.mark.parametrize(("lat", "lon", "time", "expected"), PUBLISHED)
def test_variation_is_that_of_the_makers_of_the_field(lat, lon, time, expected):
    """As a waypoint's course is turned, where no file has a variation."""
    replay = replay_dives([replace(sample_dives()[0], magvar=None)])
    for east in (lon, lon % 360):
        (leg,) = replay.aims([(lat, east)], start=(time, lat, east))
        assert leg.magnetic_variation == pytest.approx(expected, abs=0.02)
