"""Files of other vehicles, old, new and damaged, against the displacement that is known."""

import re
import shutil
from dataclasses import replace

import glider_files as made
import netCDF4
import numpy as np
import pytest
from glider_files import (
    basestation,
    basestation3,
    dives_in,
    og1,
    og1_rows,
    used_numbers,
)
from refusals import refuses

from clpt_control.gliders import read_dives, write_dive_table
from clpt_control.replay import replay_dives

DATE_LINE = 180.0 - made.DRIFT / 2
STEPS = ("EAST_DISPLACEMENT", "NORTH_DISPLACEMENT")
NO_STEPS = (*STEPS, "DAVG_CURR_EAST", "DAVG_CURR_NORTH")
# rows: GPS1, GPS2, GPSE of each dive
FIX = np.flatnonzero(np.isfinite(og1_rows()["LATITUDE_GPS"]))
TURNED = {"MAGNETIC_VARIATION": ((), made.VARIATION, {})}


def mission(folder, columns=None, **how):
    """Return the dives of an OG1 mission."""
    return dives_in(og1(folder / "og1.nc", columns=columns, **how))


def way(dive):
    return dive.dr_east, dive.dr_north


def swam(dive):
    """Check a dive against the vehicle's displacement, its fixes, its current and its depth."""
    assert way(dive) == pytest.approx(made.SWUM, rel=1e-9)
    assert (dive.gps_east, dive.gps_north) == pytest.approx(
        (made.GPS_EAST, 0.0), abs=1e-5
    )
    assert dive.duration == made.DURATION
    mean = dive.miss_east / made.DURATION, dive.miss_north / made.DURATION
    assert mean == pytest.approx(made.current(), abs=1e-9)
    assert dive.depth_max == pytest.approx(made.DEPTH, rel=0.01)
    return True


def half_way(dive):
    """Check the track where half of the dive has passed."""
    time, east, north = dive.track
    assert (time[0], time[-1]) == (0.0, made.DURATION)
    here = (
        np.interp(made.DURATION / 2, time, east),
        np.interp(made.DURATION / 2, time, north),
    )
    assert here == pytest.approx(made.VELOCITY * (made.DURATION / 2 - 60.0), abs=1.0)


@pytest.mark.parametrize("make", [basestation, basestation3])
@pytest.mark.parametrize("lon", [8.0, DATE_LINE])
def test_basestation_files_of_both_kinds(make, lon, tmp_path):
    dive = dives_in(make(tmp_path / "p1230007.nc", lon=lon))[0]
    assert swam(dive)
    half_way(dive)
    assert (dive.number, dive.kind, dive.magvar, dive.notes) == (
        7,
        "Seaglider",
        made.VARIATION,
        (),
    )
    assert (dive.dac_east, dive.dac_north) == pytest.approx(made.current())
    assert used_numbers([dive]) == [7]


def test_the_track_has_the_times_of_its_displacement(tmp_path):
    for drop, first in (((), 60.5), (("ctd_time",), 60.0)):
        # ctd_time is half a second later
        dive = dives_in(basestation(tmp_path / "a.nc", drop=drop))[0]
        assert dive.track[0][1] == pytest.approx(first, abs=1e-6)


def test_a_part_of_the_dive_that_is_missing_is_no_time_at_the_surface(tmp_path):
    since = np.linspace(60.0, made.DURATION - 1200.0, 1800)  # up 1200 s before the fix
    risen = {"ctd_time": (made.CTD, made.T0 + 60000.0 + since, made.EPOCH)}
    dive = dives_in(basestation3(tmp_path / "risen.nc", **risen))[0]
    assert dive.dr_east == pytest.approx(made.SWUM[0])
    # still deep then
    down = {"ctd_depth": (made.CTD, np.linspace(0.0, 300.0, 1800), made.M)}
    dive = dives_in(basestation3(tmp_path / "cut.nc", **risen, **down))[0]
    assert used_numbers([dive]) == []
    assert "no samples for 1200 s of 9000 s, from 300 m depth on" in dive.notes


def in_nanoseconds(columns):
    """Times since the first, made.T0 - 300 s."""
    whole = np.round(columns["TIME"] - made.T0 + 300, 3)
    columns["TIME"] = (whole * 1e9).astype(np.int64)
    return {"units": {"TIME": {"units": "nanoseconds since 2017-07-14 02:35:00"}}}


def on_their_own(columns):
    """Fixes on a dimension of their own."""
    own = {"TIME_GPS": (("N_GPS",), columns["TIME"][FIX], made.EPOCH)}
    for name in ("LATITUDE_GPS", "LONGITUDE_GPS"):
        own[name] = ("N_GPS",), columns.pop(name)[FIX], {}
    columns |= {name: np.delete(column, FIX) for name, column in columns.items()}
    return own


@pytest.mark.parametrize("lon", [8.0, DATE_LINE])
@pytest.mark.parametrize("change", [lambda columns: {}, in_nanoseconds, on_their_own])
def test_og1_fixes_and_times_as_files_have_them(change, lon, tmp_path):
    columns = og1_rows(lon=lon)
    dives = mission(tmp_path, columns, **change(columns))
    assert [dive.number for dive in dives] == [1, 2, 3]
    assert [dive.t_gps2 for dive in dives] == [
        made.T0,
        made.T0 + 10000,
        made.T0 + 20000,
    ]
    for dive in dives:
        assert swam(dive)
        half_way(dive)
        assert dive.t_gps1 == dive.t_gps2 - (300 if dive.number == 1 else 1000)
        assert (dive.kind, dive.notes) == (None, ())  # any vehicle's


@pytest.mark.parametrize("count", [1, 2, 3])
def test_og1_dives_without_numbers_depth_or_phase(count, tmp_path):
    drop = ("divenum", "DEPTH", "PHASE")[:count]
    # two more fixes at the surface, behind GPSE of the first dive
    columns = {
        name: np.insert(a, [FIX[2] + 1] * 2, a[FIX[2]])
        for name, a in og1_rows().items()
    }
    columns["TIME"][FIX[2] + 1 : FIX[2] + 3] += [310.0, 690.0]
    dives = mission(tmp_path, columns, drop=drop)
    assert [dive.number for dive in dives] == [1, 2, 3]
    for dive in dives:
        assert (way(dive), dive.depth_max is None) == (
            pytest.approx(made.SWUM),
            "DEPTH" in drop,
        )


def igrf_at(dive):
    """The variation in the middle of a dive by IGRF, as a waypoint's course is turned."""
    replay = replay_dives([replace(dive, magvar=None)])
    place = dive.lat_gps2, dive.lon_gps2
    start = 0.5 * (dive.t_gps2 + dive.t_gpse), *place
    return replay.aims([place], start=start)[0].magnetic_variation


@pytest.mark.long
def test_og1_dead_reckoning_of_speed_and_heading(tmp_path, printed, refused):
    variation = "replay", tmp_path / "og1.nc", "--variation"
    for dive in mission(tmp_path, drop=NO_STEPS, **TURNED):
        assert swam(dive)
        assert "magnetic, variation -15 degrees (of the file" in dive.notes[0]
    for dive in mission(tmp_path, drop=STEPS):  # the file's current before a guess
        assert swam(dive)
        assert dive.notes == (
            "dead reckoning computed from the file's depth-averaged current",
        )
    for dive in mission(tmp_path, drop=NO_STEPS):
        igrf = igrf_at(dive)
        bearing = np.radians(made.BEARING - made.VARIATION + igrf)
        there = (
            made.SPEED
            * (made.DURATION - 200.0)
            * np.array([np.sin(bearing), np.cos(bearing)])
        )
        assert (way(dive), dive.turned, dive.magvar) == (
            pytest.approx(there),
            igrf,
            igrf,
        )
        assert f"magnetic, variation {igrf:.0f} degrees (by IGRF" in dive.notes[0]
        assert np.hypot(*(end[-1] for end in dive.track[1:])) == pytest.approx(
            np.hypot(*there)
        )
    for row in printed(*variation, made.VARIATION)["each_dive"]:
        way_of_row = row["dr_east"], row["dr_north"]
        assert way_of_row == pytest.approx(made.SWUM, rel=1e-9)
        assert "--variation: turned by -15 degrees instead" in row["notes"]
    true = {"HEADING": {"units": "degrees", "comment": "relative to true north"}}
    columns = og1_rows()
    columns["HEADING"] = columns["HEADING"] + made.VARIATION
    for dive in mission(tmp_path, columns, drop=NO_STEPS, units=true):
        assert swam(dive)
    said = "--variation 90: no dive has dead reckoning from a magnetic heading"
    assert said in refused(*variation, 90)
    for dive in mission(
        tmp_path, drop=NO_STEPS, units={"HEADING": {"units": "degrees"}}
    ):
        said = "a north that the file does not name, variation 0 degrees (not known; --"
        assert said in dive.notes[0]
    for row in printed(*variation, made.VARIATION)["each_dive"]:
        way_of_row = row["dr_east"], row["dr_north"]
        assert way_of_row == pytest.approx(made.SWUM, rel=1e-9)


FILLS = [
    -999.0,
    -9999.0,
    -99999.0,
    -32768.0,
    32767.0,
    65535.0,
    999.0,
    9999.0,
    2**31 - 1.0,
]
FILLS += [9.96921e36, 1e20, -1e34, 1e35, np.inf, -np.inf]


@pytest.mark.parametrize("fill", FILLS)
def test_headings_that_are_no_angles_are_gaps(fill, tmp_path):
    columns = og1_rows()
    columns["HEADING"][::5] = fill
    for dive in mission(tmp_path, columns, drop=NO_STEPS, **TURNED):
        assert way(dive) == pytest.approx(made.SWUM, rel=0.01)
        assert "HEADING are not within -180 to 540 degrees" in dive.notes[-1]
    columns["HEADING"][:] = fill
    used, skipped = read_dives(
        og1(tmp_path / "og1.nc", columns=columns, drop=NO_STEPS, **TURNED)
    )
    assert used == []
    assert "no speed and heading" in skipped[0].why
    plan = {"log_HEADING": ((), 9.97e36, {}), "magnetic_variation": ((), -999.0, {})}
    (dive,) = dives_in(basestation(tmp_path / "a.nc", **plan))
    assert (dive.next_course, dive.magvar) == (None, None)


def test_headings_in_radians_are_read_or_asked_about(tmp_path):
    def in_radians(units):
        columns = og1_rows()
        columns["HEADING"] = np.radians(columns["HEADING"])
        return columns, {"units": {"HEADING": units}}

    magnetic = {"comment": "magnetic"}
    for units in ("rad", "radian", "radians"):
        columns, how = in_radians(magnetic | {"units": units})
        for dive in mission(tmp_path, columns, drop=NO_STEPS, **TURNED, **how):
            assert swam(dive)
    for units in (magnetic, magnetic | {"units": "1"}):
        columns, how = in_radians(units)
        said = "HEADING has the units '1?' and only numbers within 2 pi.*'radian', or"
        refuses(said, mission, tmp_path, columns, drop=NO_STEPS, **TURNED, **how)
    columns, how = in_radians(magnetic | {"units": "degrees"})
    for dive in mission(tmp_path, columns, drop=NO_STEPS, **TURNED, **how):
        assert "if they are radians, set its units" in dive.notes[-1]


def test_places_that_are_no_dead_reckoning_are_the_fixes(tmp_path):
    """OG1's DEAD_RECKONING is 0 where the receiver gave the place, 1 where it was computed."""
    expected, columns = mission(tmp_path), og1_rows()
    rows = np.arange(len(columns["TIME"]))
    for name in ("LATITUDE", "LONGITUDE"):
        columns[name] = np.interp(rows, FIX, columns.pop(f"{name}_GPS")[FIX])
    columns["DEAD_RECKONING"] = 1.0 - np.isin(rows, FIX)
    for more in ({}, {"LATITUDE_GPS": np.full(rows.size, np.nan)}):
        found = mission(tmp_path, columns | more)
        assert found == expected
        assert all(map(swam, found))


def test_a_stall_of_the_flight_model_is_no_way(tmp_path):
    columns = og1_rows()
    for name in ("GLIDER_HORZ_VELO_MODEL", *STEPS):
        columns[name][100:111] = 0.0 if name in STEPS else np.nan
    one, other = (
        mission(tmp_path, columns, drop=drop, **TURNED)[0] for drop in ((), NO_STEPS)
    )
    assert way(one) == pytest.approx(way(other))


def test_missions_over_the_date_line_go_round(tmp_path):
    dives = mission(tmp_path, og1_rows(lon=DATE_LINE - made.DRIFT))
    assert {np.sign(dive.lon_gps2) for dive in dives} == {1.0, -1.0}
    write_dive_table(dives, tmp_path / "back.csv")
    back = dives_in(tmp_path / "back.csv")
    assert [swam(replace(dive, track=None)) for dive in back] == [True] * 3
    east = [
        replace(dive, lon_gpse=dive.lon_gpse % 360.0, gps_east=0.0) for dive in dives
    ]
    write_dive_table(east, tmp_path / "east.csv")  # longitudes to 360 east
    rows = read_dives([tmp_path / "east.csv"], usable=False)[0]
    assert [dive.gps_east for dive in rows] == pytest.approx([made.GPS_EAST] * 3)


def without(rows):
    """The columns of a mission that has no fix in rows."""
    columns = og1_rows()
    columns["LATITUDE_GPS"][rows] = columns["LONGITUDE_GPS"][rows] = np.nan
    return columns


def test_dives_with_no_fix_between_them_are_one(tmp_path):
    (dive,) = mission(tmp_path, without(FIX[2:-1]))
    assert dive.notes == ("no fix between dives 1 and 3: taken as one",)
    assert (dive.t_gps2, dive.t_gpse) == (made.T0, made.T0 + 20000 + made.DURATION)
    assert dive.gps_east == pytest.approx(3 * made.GPS_EAST)
    assert (way(dive), dive.dac_east) == (pytest.approx(3 * made.SWUM), None)
    assert used_numbers([dive]) == [dive.number]


def test_a_mission_that_cannot_be_read_is_one_sentence(tmp_path):
    def of(name, unit):
        return {"units": {name: {"units": unit}}}

    for how, said in (
        ({"columns": without(FIX)}, "no two fixes more than 300 s apart"),
        ({"columns": without(FIX[1:])}, "no two fixes more than 300 s apart"),
        (
            {"drop": ("LONGITUDE_GPS",)},
            "no variable LONGITUDE_GPS; OG1 has the fixes there",
        ),
        ({"drop": ("TIME",)}, "no variable TIME_GPS; OG1"),
        (of("TIME", "seconds since the start"), "TIME.*unit such as"),
        (of("DEPTH", "dbar"), "DEPTH.*'dbar'.*unit such as"),
    ):
        refuses(said, mission, tmp_path, **how)


def test_fixes_that_are_none_are_left_out_and_said(tmp_path):
    columns = og1_rows()
    columns["LATITUDE_GPS"][FIX[2]] = 91.0  # GPSE of the first dive
    columns["LONGITUDE_GPS"][FIX[5]] = 0.0  # GPSE of the second: 0 N 0 E
    dives = mission(tmp_path, columns)
    # GPS1 of the next
    assert [dive.t_gpse - made.T0 for dive in dives] == [9700, 19700, 29000]
    assert [way(dive) == pytest.approx(made.SWUM) for dive in dives] == [True] * 3
    assert [bool(dive.notes) for dive in dives] == [True, True, False]
    assert (
        dives[0].notes[0]
        == "1 fix(es) that are no place, 0 N 0 E or under water left out"
    )


def test_fixes_that_were_repeated_or_interpolated(tmp_path):
    columns = og1_rows()
    last = FIX[np.searchsorted(FIX, np.arange(len(columns["TIME"])), "right") - 1]
    fixed = {name: columns[name] for name in ("LATITUDE_GPS", "LONGITUDE_GPS")}
    dives = mission(
        tmp_path, columns | {name: column[last] for name, column in fixed.items()}
    )
    assert [dive.number for dive in dives] == [1, 2, 3]
    assert [dive.gps_east for dive in dives] == pytest.approx([made.GPS_EAST] * 3)
    assert [way(dive) == pytest.approx(made.SWUM) for dive in dives] == [True] * 3
    time, deep = columns["TIME"], np.flatnonzero(columns["DEPTH"] > 20.0)
    columns |= {
        name: np.interp(time, time[FIX], column[FIX]) for name, column in fixed.items()
    }
    said = f"have {deep.size} new fixes under water, the first in row {deep[0]} .* set both to NaN"
    refuses(said, mission, tmp_path, columns)


SORTED = "the measurements were not in order of time, sorted"
TWICE = "400 samples have the time of the one before, left out"


def test_an_end_fix_that_repeats_the_start_fix_is_none(tmp_path):
    columns = og1_rows()
    for name in ("LATITUDE_GPS", "LONGITUDE_GPS"):
        columns[name][FIX[5]] = columns[name][FIX[4]]
    first, long, last = mission(tmp_path, columns)
    assert swam(first)
    assert swam(last)
    assert way(long) == pytest.approx(made.SWUM, rel=1e-9)
    assert long.gps_east == pytest.approx(made.GPS_EAST, abs=1e-5)
    assert long.duration == made.DURATION + 700.0  # to GPS1 of the next dive
    _, _, lons = made.fixes(7, 8.0)
    repeated = {"log_gps_lon": (made.INFO, [lons[0], lons[1], lons[1]], {})}
    used, skipped = read_dives(basestation(tmp_path / "a.nc", **repeated))
    assert used == []
    assert skipped[0].why.startswith("no fix after the dive: its place is exactly")


NAMES = ("DAVG_CURR_EAST", "DAVG_CURR_NORTH")
START, MIDDLE, END, SURFACE = 0.0, 0.5, 1.0, 1.05  # of a dive's duration


def of_surfacings(count, when=None):
    """Return currents, one per surfacing, dated at a part of their dive or not at all."""
    own = ("N_SURFACING",)
    found = {
        name: (own, np.full(count, one) + 0.01 * np.arange(count), made.MS)
        for name, one in zip(NAMES, made.current(), strict=True)
    }
    if when is not None:
        times = made.T0 + 10000.0 * np.arange(count) + when * made.DURATION
        found["TIME_DAVG"] = own, times, made.EPOCH
    return found


@pytest.mark.parametrize("when", [None, START, MIDDLE, END, SURFACE])
def test_a_current_of_each_surfacing_is_that_of_its_dive(when, tmp_path):
    columns = {k: a for k, a in og1_rows().items() if k not in NAMES}
    how = {"drop": (*STEPS, "HEADING")} | of_surfacings(3, when)
    for k, dive in enumerate(mission(tmp_path, columns, **how)):
        current = made.current() + 0.01 * k
        assert (dive.dac_east, dive.dac_north) == pytest.approx(tuple(current))
        assert "the file's depth-averaged current" in dive.notes[0]
        mean = np.array([dive.miss_east, dive.miss_north]) / dive.duration
        assert mean == pytest.approx(current, abs=1e-9)
    fewer = {"drop": (*STEPS, "HEADING")} | of_surfacings(2)
    used, skipped = read_dives(og1(tmp_path / "og1.nc", columns=columns, **fewer))
    assert used == []
    assert "no depth-averaged current of the file has a time of this" in skipped[0].why


def set_back(columns, first, last=None):
    """Set the clock of the samples back by an hour from a row to another; fixes keep theirs."""
    columns["TIME_GPS"] = np.where(
        np.isfinite(columns["LATITUDE_GPS"]), columns["TIME"], np.nan
    )
    columns["TIME"][first:last] -= 3600.0
    return columns, {"units": {"TIME_GPS": made.EPOCH}}


@pytest.mark.parametrize("last", [None, FIX[8], FIX[5] + 1])
@pytest.mark.parametrize("drop", [(), NO_STEPS])
def test_a_clock_that_is_set_back_under_water_costs_the_track_alone(
    tmp_path, last, drop
):
    columns, how = set_back(og1_rows(), FIX[4] + 150, last)
    dives = mission(tmp_path, columns, drop=drop, **TURNED, **how)
    assert [dive.number for dive in dives] == [1, 2, 3]
    for dive in dives:
        assert way(dive) == pytest.approx(made.SWUM, rel=1e-3)
        assert dive.duration == made.DURATION
        said = any("set back by 3600 s under water" in note for note in dive.notes)
        assert said == (dive.track is None)
    assert [dive.track is None for dive in dives[:2]] == [False, True]
    assert (dives[2].track is None) == (last != FIX[5] + 1)
    assert used_numbers(dives) == [1, 2, 3]


def test_a_clock_that_is_set_back_with_its_fixes_is_refused(tmp_path):
    columns = og1_rows()
    columns["TIME"][FIX[4] + 150 :] -= 3600.0
    refuses("TIME falls by 36.. s in row .*. Correct it", mission, tmp_path, columns)


def test_rows_in_any_order_and_twice(tmp_path):
    for change, note in (np.flip, SORTED), (lambda column: np.repeat(column, 2), TWICE):
        for dive in mission(
            tmp_path, {name: change(a) for name, a in og1_rows().items()}
        ):
            assert (way(dive), dive.notes) == (pytest.approx(made.SWUM), (note,))
            assert np.all(np.diff(dive.track[0]) > 0)


def test_without_a_whole_displacement_through_the_water(tmp_path):
    dives = mission(tmp_path, drop=(*STEPS, "GLIDER_HORZ_VELO_MODEL", "DAVG_CURR_EAST"))
    assert used_numbers(dives) == []
    assert "no EAST_DISPLACEMENT, NORTH_DISPLACEMENT, no speed" in dives[0].notes[0]


@pytest.mark.parametrize(("name", "fill"), [(STEPS[0], 9999.0), (STEPS[1], np.nan)])
def test_steps_that_no_vehicle_makes(name, fill, tmp_path):
    def filled(rows):
        columns = og1_rows()
        columns[name][rows] = fill
        return mission(tmp_path, columns)

    first, second, _ = filled([50, 51, 300])
    note = "samples of the displacement are not finite or above 5 m/s, filled from their neighbours"
    assert [dive.notes != () for dive in (first, second)] == [True, False]
    assert first.notes[0].startswith(f"3 of 400 {note}")
    assert way(first) == pytest.approx(made.SWUM)
    dives = filled(slice(60, 93))
    assert used_numbers(dives) == [2, 3]
    assert (
        dives[0]
        .notes[0]
        .startswith("33 of 400 samples of the displacement are not finite")
    )


def test_rows_of_other_instruments_have_no_step(tmp_path):
    """A step after them covers their time too: the sum is whole, and nothing is filled."""
    columns, rows = og1_rows(), np.arange(20, 180, 4)
    for step in STEPS:
        columns[step][rows + 1] += columns[step][rows]
        columns[step][rows] = np.nan
    for dive in mission(tmp_path, columns):
        assert (way(dive), dive.notes) == (pytest.approx(made.SWUM), ())


def put(name, rows, value):
    """Set what stands at rows of a variable of a measured file."""

    def damage(data):
        values = np.ma.filled(data[name][:].astype(float), nan)
        values[rows] = value
        data[name][:] = values

    return damage


def no_end(data):
    """No time of the fix after the seventh dive."""
    fixes = np.flatnonzero(np.isfinite(np.ma.filled(data["LATITUDE_GPS"][:], nan)))
    put("TIME_GPS", fixes[13], nan)(data)


def in_milliseconds(data):
    data["TIME_GPS"][:] = data["TIME_GPS"][:] / 1e6


def at_0_0(data):
    for name in ("latitude_gps_end", "longitude_gps_end"):
        put(name, slice(-5, None), 0.0)(data)


SG015, SPRAY = "sg015_20040929T140907_delayed.nc", "sp028_20230202T1637_R.nc"
ALL, FAST, nan = slice(None), "not finite or above 5 m/s", np.nan
DAMAGED = [  # each: the damage, what is said, which dives are used; None: the file is refused
    (SG015, lambda data: None, "", [3, 4, 6, 7]),
    (SG015, no_end, "", [3, 4, 6]),
    (SG015, in_milliseconds, "read as milliseconds", [3, 4, 6, 7]),
    (SG015, put("TIME_GPS", ALL, 7.0), "no two fixes more than 300 s apart", None),
    (
        SG015,
        lambda data: data["HORZ_GLIDER_SPEED"].setncattr("units", "km/s"),
        FAST,
        [],
    ),
    (
        SG015,
        put("TIME", slice(300, 320), nan),
        r"no samples for \d+ s of 7380 s",
        [3, 4, 7],
    ),
    (SG015, put("dive_num", ALL, nan), "", [3, 4, 6, 7]),
    (SPRAY, lambda data: None, "", [32, 33, 34, 35]),
    (SPRAY, at_0_0, "", [32, 33, 34, 35]),
    (SPRAY, put("time_uv", ALL, nan), "no fix before the dive", []),
    (SPRAY, put("wcur_x", slice(-17, None), nan), "no depth-averaged c", [32, 33, 34]),
    (SPRAY, put("time_gps_end", ALL, nan), "LONGITUDE_GPS_END have no fix", None),
]


@pytest.mark.parametrize(("name", "damage", "said", "expected"), DAMAGED)
def test_a_damaged_mission_is_named_and_its_good_dives_are_used(
    facts, tmp_path, name, damage, said, expected
):
    path = tmp_path / name
    shutil.copyfile(facts / "glider" / "og1" / name, path)
    with netCDF4.Dataset(path, "a") as data:
        damage(data)
    if expected is None:
        refuses(f"{path}.*{said}", read_dives, path)
        return
    used, skipped = read_dives(path)
    told = [one.why for one in skipped]
    told += [note for dive in used for note in dive.notes]
    assert any(re.search(said, why) for why in told) or not said
    assert [dive.number for dive in used] == expected
    assert all(np.isfinite(step.clpe["adaptive"]) for step in replay_dives(used).steps)


# --- quantities that mean something else than their name says ------------------------------------

TRUE = {"units": "degrees", "comment": "true north"}


def steered(folder, heading=lambda true: true, attrs=TRUE, change=lambda columns: {}):
    """Return the dives of a mission with speed and a heading, made of the true one, alone."""
    columns = og1_rows()
    columns["HEADING"] = heading((columns["HEADING"] + made.VARIATION) % 360.0)
    how = {"units": {"HEADING": attrs}} | change(columns)
    return mission(folder, columns, drop=NO_STEPS, **how)


UNITS = {  # in a degree
    "decidegrees": 10.0,
    "0.1 degree": 10.0,
    "tenths of degrees": 10.0,
    "centidegrees": 100.0,
    "mrad": 1e3 * np.pi / 180,
    "rad (true)": np.pi / 180,
    "gradian": 10 / 9,
    "gon": 10 / 9,
    "degrees (0-360)": 1.0,
    "degree_true": 1.0,
    "°": 1.0,
}


@pytest.mark.parametrize(("units", "count"), UNITS.items())
def test_units_of_headings_are_read(units, count, tmp_path):
    attrs = TRUE | {"units": units}
    dives = steered(tmp_path, lambda true: true * count, attrs)
    assert [way(dive) == pytest.approx(made.SWUM) for dive in dives] == [True] * 3


@pytest.mark.parametrize(
    "units",
    ["mils", "brad", "turns", "arcminutes", "degrees*10", "deg/10", "deg s-1 10"],
)
def test_other_units_of_headings_are_refused(units, tmp_path):
    refuses(
        f"HEADING is in {re.escape(repr(units))}",
        steered,
        tmp_path,
        attrs=TRUE | {"units": units},
    )


def test_headings_beyond_a_turn_are_in_another_unit(tmp_path):
    """Numbers that are no single fill value are not left out as gaps."""

    def swaying(true):
        return 10.0 * (true + np.arange(true.size) % 7)

    said = "HEADING are not within -180 to 540 degrees, such as .* Correct its units, 'degrees'"
    refuses(said, steered, tmp_path, swaying)


@pytest.mark.parametrize(
    ("units", "none"), [("degrees", 511.0), ("decidegrees", 5110.0)]
)
def test_a_heading_of_511_degrees_means_none(units, none, tmp_path):
    def heading(true):
        return np.where(np.arange(true.size) % 6 == 2, none, true * none / 511.0)

    for dive in steered(tmp_path, heading, TRUE | {"units": units}):
        assert way(dive) == pytest.approx(made.SWUM, rel=0.01)


def test_places_in_degrees_west_are_turned(tmp_path):
    columns = og1_rows()
    columns["LONGITUDE_GPS"] = -columns["LONGITUDE_GPS"]
    units = {"LONGITUDE_GPS": {"units": "degrees_west"}}
    found, wanted = (
        [(dive.start, way(dive)) for dive in mission(tmp_path, *how, units=given)]
        for how, given in (((columns,), units), ((), {}))
    )
    assert found == wanted


ALREADY_TRUE = [
    {"long_name": "true heading", "comment": "magnetic declination applied"},
    {"comment": "corrected for magnetic variation"},
    {"comment": "Converted from magnetic to true north"},
    {"description": "magnetic heading plus declination"},
    {"comment": "True heading. Not quality controlled.", "north": "true"},
    {"long_name": "Heading, true north", "ancillary_variables": "MAGNETIC_VARIATION"},
    {"magnetic_declination_applied": "yes", "comment": "not filtered"},
    {"comment": "true, not magnetic"},
]
STILL_MAGNETIC = [
    {"comment": "magnetic, uncorrected"},
    {"comment": "not corrected for magnetic declination"},
    {"comment": "Magnetic. No declination correction has been applied."},
    {"comment": "apply MAGNETIC_VARIATION to get true heading"},
    {"long_name": "magnetic heading", "comment": "corrected for deviation"},
    {"magnetic_declination_applied": "no"},
    {"comment": "heading before magnetic variation is added"},
    {"comment": "magnetic, not true"},
    {"comment": "no magnetic declination has been applied"},
    {"comment": "magnetic; variation correction pending"},
]
UNCLEAR = [
    {"comment": "true heading of the magnetic compass"},
    {"comment": "counter-clockwise from east"},
    {"long_name": "true", "comment": "variation not applied"},
]


@pytest.mark.parametrize("words", ALREADY_TRUE)
def test_a_heading_that_is_true_is_not_turned(words, tmp_path):
    for dive in steered(tmp_path, attrs=words, change=lambda columns: TURNED):
        assert (way(dive), dive.turned) == (pytest.approx(made.SWUM), None)


@pytest.mark.parametrize("words", STILL_MAGNETIC)
def test_a_heading_that_is_not_corrected_is_turned(words, tmp_path):
    def magnetic(true):
        return (true - made.VARIATION) % 360.0

    dives = steered(tmp_path, magnetic, words, lambda columns: TURNED)
    for dive in dives:
        assert (way(dive), dive.turned) == (pytest.approx(made.SWUM), made.VARIATION)


@pytest.mark.parametrize("words", UNCLEAR)
def test_words_on_north_that_contradict_are_refused(words, tmp_path):
    refuses(
        "the north of the heading is not clear: .*'true' or",
        steered,
        tmp_path,
        attrs=words,
    )


RATES = {
    "half": lambda rows: rows % 2 == 0,
    "two of three": lambda rows: rows % 3 > 0,
    "tenth": lambda rows: rows % 10 == 0,
    "random half": lambda rows: np.random.default_rng(0).random(rows.size) < 0.5,
    "all but a 25th": lambda rows: rows % 25 > 0,
}


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize("apart", [False, True])
def test_speeds_on_fewer_rows_than_headings_are_no_stalls(rate, apart, tmp_path):
    """Also if the rows with a speed have no heading, as of two instruments."""

    def change(columns):
        has_speed = RATES[rate](np.arange(columns["TIME"].size))
        columns["GLIDER_HORZ_VELO_MODEL"][~has_speed] = np.nan
        if apart and rate == "half":
            columns["HEADING"][has_speed] = np.nan
        return {}

    for dive in steered(tmp_path, change=change):
        assert way(dive) == pytest.approx(made.SWUM, rel=0.01)


def test_a_hole_between_speeds_of_another_rate_is_no_stall_and_no_way(tmp_path):
    def change(columns):
        columns["GLIDER_HORZ_VELO_MODEL"][::2] = np.nan
        columns["GLIDER_HORZ_VELO_MODEL"][100:160] = np.nan
        return {}

    first, *others = steered(tmp_path, change=change)
    said = r"\d+ of 400 samples in a row have a heading and no speed, in a stall or between"
    assert re.search(said, first.notes[0])
    assert [way(dive) == pytest.approx(made.SWUM, rel=0.01) for dive in others] == [
        True
    ] * 2
    assert np.isnan(first.dr_east)


@pytest.mark.parametrize("lost", [np.nan, 0.0, -9999.0, -(2.0**63), 9.97e36])
def test_a_displacement_without_a_time_counts(lost, tmp_path):
    columns = og1_rows()
    rows = np.setdiff1d(np.arange(columns["TIME"].size)[3::7], FIX)
    columns["TIME"][rows] = lost
    for dive in mission(tmp_path, columns):
        assert way(dive) == pytest.approx(made.SWUM)


def test_a_displacement_of_an_unknown_dive_is_refused(tmp_path):
    columns = og1_rows()
    how = on_their_own(columns)
    columns["TIME"][395:405] = np.nan
    said = "9 displacements have no time, the first in row 395 .*not in order of time"
    refuses(said, mission, tmp_path, columns, **how)


SINCE = {  # unit, its length in s, and seconds from 1970 to its date
    "seconds since 1970-01-01": (1.0, 0.0),
    "days since 1970-01-01": (86400.0, 0.0),
    "minutes since 2000-01-01": (60.0, 946684800.0),
}


@pytest.mark.parametrize("units", SINCE)
@pytest.mark.parametrize("drop", [(), NO_STEPS])
def test_times_in_single_precision_are_refused_where_they_are_coarse(
    units, drop, tmp_path
):
    columns, (size, date) = og1_rows(), SINCE[units]
    columns["TIME"] = ((columns["TIME"] - date) / size).astype(np.float32)
    how = {"units": {"TIME": {"units": units}}, "drop": drop}
    refuses("TIME is in single precision", mission, tmp_path, columns, **TURNED, **how)
    columns["TIME"] = (og1_rows()["TIME"] - made.T0).astype(np.float32)
    near = {
        "units": {"TIME": {"units": "seconds since 2017-07-14 02:40:00"}},
        "drop": drop,
    }
    for dive in mission(tmp_path, columns, **TURNED, **near):
        assert way(dive) == pytest.approx(made.SWUM, rel=1e-4)


def test_different_samples_at_one_time_are_not_left_out(tmp_path):
    columns = og1_rows()
    columns["TIME"] = np.where(
        np.isin(np.arange(columns["TIME"].size), FIX),
        columns["TIME"],
        columns["TIME"] // 60 * 60,
    )
    used, skipped = read_dives(og1(tmp_path / "og1.nc", columns=columns))
    assert used == []
    assert "samples have the time of the one before" in skipped[0].why


def with_dimensions(tmp_path, dims, shape, columns=None):
    """Return the dives of a file whose columns have other dimensions."""
    columns = og1_rows() if columns is None else columns
    rows = {
        name: (dims, column.reshape(shape), made.UNITS.get(name, {}))
        for name, column in columns.items()
    }
    return dives_in(made.write(tmp_path / "og1.nc", rows))


def test_dimensions_of_length_one_are_none(tmp_path):
    for dims, shape in (
        (("trajectory", "obs"), (1, -1)),
        (("row", "profile"), (-1, 1)),
    ):
        assert all(map(swam, with_dimensions(tmp_path, dims, shape)))
    two = ("trajectory", "obs"), (3, -1)
    refuses(
        "TIME, LATITUDE_GPS, LONGITUDE_GPS have the dim.*Give a file for each",
        with_dimensions,
        tmp_path,
        *two,
    )


@pytest.mark.parametrize("size", [1209, 700])
def test_a_heading_of_another_clock_is_not_read_row_by_row(size, tmp_path):
    heading = ("N_ENG",), np.linspace(0.0, 359.0, size), TRUE
    dives = mission(tmp_path, drop=NO_STEPS, **{"HEADING": heading})
    assert used_numbers(dives) == []
    assert (
        "HEADING is not read: it does not have the dimensions of TIME" in dives[0].notes
    )
