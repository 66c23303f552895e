"""Damaged OG1 missions, made and measured: each has its reason, and good dives stay in use."""

import re
import shutil

import netCDF4
import numpy as np
import pytest
from glider_dialects import DURATION, GPS_EAST, SWUM, T0, dives_in, og1, og1_rows

from clpt_control.errors import DataError
from clpt_control.gliders.dive_files import read_dives
from clpt_control.gliders.usable_dives import usable
from clpt_control.replay import replay_dives

STEPS = ("EAST_DISPLACEMENT", "NORTH_DISPLACEMENT")
OTHER = ("GLIDER_HORZ_VELO_MODEL", "DAVG_CURR_EAST")
FIX = np.flatnonzero(np.isfinite(og1_rows()["LATITUDE_GPS"]))  # rows: GPS1, GPS2, GPSE of each dive


def mission(folder, change=lambda columns: None, **how):
    """Return the dives of a mission whose columns are changed."""
    columns = og1_rows()
    change(columns)
    return dives_in(og1(folder / "og1.nc", columns=columns, **how))


def without(rows):
    """A change that takes fixes from rows."""

    def change(columns):
        for name in ("LATITUDE_GPS", "LONGITUDE_GPS"):
            columns[name][rows] = np.nan

    return change


def swam(dive, times=1):
    assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(times * SWUM))
    return True


def test_dives_with_no_fix_between_them_are_one(tmp_path):
    (dive,) = mission(tmp_path, without(FIX[2:-1]))
    assert dive.notes == ("no fix between dives 1 and 3: taken as one",)
    assert (dive.t_gps2, dive.t_gpse) == (T0, T0 + 20000 + DURATION)
    assert dive.gps_east == pytest.approx(3 * GPS_EAST)
    assert swam(dive, 3)
    assert dive.dac_east is None
    assert usable([dive])[0] == [dive]


@pytest.mark.parametrize(
    ("how", "said"),
    [
        ({"change": without(FIX)}, "no two fixes more than 600 s apart"),
        ({"change": without(FIX[1:])}, "no two fixes more than 600 s apart"),
        ({"drop": ("LONGITUDE_GPS",)}, "no variable LONGITUDE_GPS; OG1 has the fixes there"),
        ({"drop": ("TIME",)}, "no variable TIME_GPS; OG1"),
        ({"units": {"TIME": {"units": "seconds since the start"}}}, "TIME.*must be such as"),
        ({"units": {"DEPTH": {"units": "dbar"}}}, "DEPTH.*'dbar'.*must be such as"),
    ],
)
def test_a_mission_that_cannot_be_read_is_one_sentence(how, said, tmp_path):
    with pytest.raises(DataError, match=said):
        mission(tmp_path, **how)


def test_fixes_that_are_none_are_left_out_and_said(tmp_path):
    def change(columns):
        columns["LATITUDE_GPS"][FIX[2]] = 91.0  # GPSE of the first dive
        columns["LONGITUDE_GPS"][FIX[5]] = 0.0  # GPSE of the second: 0 N 0 E

    dives = mission(tmp_path, change)
    assert [dive.t_gpse - T0 for dive in dives] == [9700, 19700, 29000]  # GPS1 of the dive after
    assert all(map(swam, dives))
    assert [bool(dive.notes) for dive in dives] == [True, True, False]
    assert dives[0].notes[0] == "1 fix(es) that are no place, 0 N 0 E or under water left out"


def test_fixes_that_were_repeated_or_interpolated(tmp_path):
    columns = og1_rows()
    rows = np.arange(len(columns["TIME"]))
    last = FIX[np.searchsorted(FIX, rows, "right") - 1]
    places = {name: columns[name][last] for name in ("LATITUDE_GPS", "LONGITUDE_GPS")}
    dives = mission(tmp_path, lambda columns: columns.update(places))
    assert [dive.number for dive in dives] == [1, 2, 3]
    assert [dive.gps_east for dive in dives] == pytest.approx([GPS_EAST] * 3)
    assert all(map(swam, dives))
    for name in places:
        places[name] = np.interp(columns["TIME"], columns["TIME"][FIX], columns[name][FIX])
    deep = np.flatnonzero(columns["DEPTH"] > 20.0)
    said = f"have {deep.size} new fixes under water, the first in row {deep[0]} .* set both to NaN"
    with pytest.raises(DataError, match=said):
        mission(tmp_path, lambda columns: columns.update(places))


@pytest.mark.parametrize(
    ("rows", "note"),
    [
        (np.s_[::-1], "the measurements were not in order of time, sorted"),
        (
            np.repeat(np.arange(len(og1_rows()["TIME"])), 2),
            "400 samples have the time of the one before, left out",
        ),
    ],
)
def test_rows_in_any_order_and_twice(rows, note, tmp_path):
    columns = {name: a[rows] for name, a in og1_rows().items()}
    for dive in dives_in(og1(tmp_path / "a.nc", columns=columns)):
        assert swam(dive)
        assert dive.notes == (note,)
        assert np.all(np.diff(dive.track[0]) > 0)


def test_without_a_whole_displacement_through_the_water(tmp_path):
    dives = mission(tmp_path, drop=(*STEPS, *OTHER))
    assert usable(dives)[0] == []
    assert "no EAST_DISPLACEMENT, NORTH_DISPLACEMENT, no speed" in dives[0].notes[0]


@pytest.mark.parametrize(("name", "fill"), [(STEPS[0], 9999.0), (STEPS[1], np.nan)])
def test_steps_that_no_vehicle_makes(name, fill, tmp_path):
    def change(rows):
        return lambda columns: columns[name].__setitem__(rows, fill)

    first, second, _ = mission(tmp_path, change([50, 51, 300]))
    note = "samples of the displacement are not finite or above 5 m/s, filled from their neighbours"
    assert [dive.notes != () for dive in (first, second)] == [True, False]
    assert first.notes[0].startswith(f"3 of 400 {note}")
    assert swam(first)
    dives = mission(tmp_path, change(slice(60, 93)))
    assert [one.number for one in usable(dives)[0]] == [2, 3]
    assert dives[0].notes[0].startswith("33 of 400 samples of the displacement are not finite")


def test_rows_of_other_instruments_have_no_step(tmp_path):
    """A step after them covers their time too: the sum is whole, and nothing is filled."""

    def change(columns):
        rows = np.arange(20, 180, 4)
        for step in STEPS:
            columns[step][rows + 1] += columns[step][rows]
            columns[step][rows] = np.nan

    for dive in mission(tmp_path, change):
        assert swam(dive)
        assert dive.notes == ()


SG015, SPRAY = "sg015_20040929T140907_delayed.nc", "sp028_20230202T1637_R.nc"


def put(name, change):
    """Change the numbers of a variable: `change(values, rows of fixes)`."""

    def damage(data):
        values = np.ma.filled(data[name][:].astype(float), np.nan)
        fixes = "LATITUDE_GPS" if "LATITUDE_GPS" in data.variables else "latitude_gps_end"
        rows = np.flatnonzero(np.isfinite(np.ma.filled(data[fixes][:], np.nan)))
        change(values, rows)
        data[name][:] = values

    return damage


def at(where, value):
    """A change of what stands at a fix (by its place), or at a slice of rows."""

    def change(values, rows):
        values[where if isinstance(where, slice) else rows[where]] = value

    return change


def in_km(data):
    data["HORZ_GLIDER_SPEED"].units = "km/s"


def scaled(values, _):
    values /= 1e6


def at_0_0(data):
    for name in ("latitude_gps_end", "longitude_gps_end"):
        put(name, at(slice(-5, None), 0.0))(data)


def whole(data):
    """Nothing is changed."""


ALL = slice(None)
# of fixes: 2 k before dive k + 1 and 2 k + 1 after it; each: the damage, what is said, what is used
DAMAGED = [
    (SG015, whole, "", [3, 4, 6, 7]),
    (SG015, put("TIME_GPS", at(13, np.nan)), "", [3, 4, 6]),
    (SG015, put("TIME_GPS", scaled), "read as milliseconds", [3, 4, 6, 7]),
    (SG015, put("TIME_GPS", at(ALL, 7.0)), DataError("no two fixes more than 600 s apart"), []),
    (SG015, in_km, "samples of the displacement are not finite or above 5 m/s", []),
    (SG015, put("TIME", at(slice(300, 320), np.nan)), r"no samples for \d+ s of 7380 s", [3, 4, 7]),
    (SG015, put("dive_num", at(ALL, np.nan)), "", [3, 4, 6, 7]),
    (SPRAY, whole, "", [32, 33, 34, 35]),
    (SPRAY, at_0_0, "", [32, 33, 34, 35]),
    (SPRAY, put("time_uv", at(ALL, np.nan)), "no fix before the dive", []),
    (SPRAY, put("wcur_x", at(slice(-17, None), np.nan)), "no depth-averaged c", [32, 33, 34]),
    (SPRAY, put("time_gps_end", at(ALL, np.nan)), DataError("LONGITUDE_GPS_END have no fix"), []),
]


@pytest.mark.parametrize(("name", "damage", "sentence", "expected"), DAMAGED)
def test_a_damaged_mission_is_named_and_its_good_dives_are_used(
    facts, tmp_path, name, damage, sentence, expected
):
    path = tmp_path / name
    shutil.copyfile(facts / "glider" / "og1" / name, path)
    with netCDF4.Dataset(path, "a") as data:
        damage(data)
    if isinstance(sentence, DataError):
        with pytest.raises(DataError, match=f"{path}.*{sentence}") as refused:
            read_dives(path)
        assert "\n" not in str(refused.value)
        return
    dives, unread = read_dives(path)
    used, unused = usable(dives)
    told = [one.why for one in (*unread, *unused)]
    told += [note for dive in used for note in dive.notes]
    assert any(re.search(sentence, why) for why in told) or not sentence
    assert [dive.number for dive in used] == expected
    assert all(np.isfinite(step.clpe["adaptive"]) for step in replay_dives(used).steps)
