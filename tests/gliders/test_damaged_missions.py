"""Missions and tables as they come: each damage has its reason, and good dives are used.

The damage is made here, of the facts of SG015 (OG1), sp028 (Spray) and SEA035 (CSV).
"""

import csv
import re
import shutil

import netCDF4
import numpy as np
import pytest

from clpt_control.errors import ClptError, DataError
from clpt_control.gliders import read_dives, usable
from clpt_control.replay import replay_dives

SG015, SPRAY = "sg015_20040929T140907_delayed.nc", "sp028_20230202T1637_R.nc"
GOOD = {SG015: [3, 4, 6, 7], SPRAY: [32, 33, 34, 35]}


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


def renamed(old, new):
    return lambda data: data.renameVariable(old, new)


def said(name, **attributes):
    return lambda data: data[name].setncatts(attributes)


def scaled(values, _):
    values /= 1e6


def everywhere(values, rows):
    values[:] = np.interp(np.arange(values.size), rows, values[rows])


def sunk(values, rows):
    values[rows] = 400.0


def reversed_rows(data):
    for name in data.variables:
        if data[name].dimensions:
            data[name][:] = data[name][:][::-1]


# of fixes: 2 k before dive k + 1 and 2 k + 1 after it; each: the damage, what is said, what is used
OF_SG015 = {
    "the first fix at 0 N 0 E": (
        [put("LATITUDE_GPS", at(0, 0.0)), put("LONGITUDE_GPS", at(0, 0.0))],
        "",
        [3, 4, 6, 7],
    ),
    "half a fix": (put("LONGITUDE_GPS", at(4, np.nan)), r"1 fix\(es\) .* left out", [3, 4, 6, 7]),
    "a fix off the Earth": (
        put("LATITUDE_GPS", at(5, 91.0)),
        r"1 fix\(es\) that are no place, .* left out",
        [3, 4, 6, 7],
    ),
    "a fix without time": (put("TIME_GPS", at(13, np.nan)), "", [3, 4, 6]),
    "times of fixes in ms": (put("TIME_GPS", scaled), "read as milliseconds", [3, 4, 6, 7]),
    "times of fixes in fortnights": (
        said("TIME_GPS", units="fortnights since 1970-01-01"),
        DataError("TIME_GPS is in 'fortnights since 1970-01-01'; must be such as"),
        [],
    ),
    "times without any sense": (
        put("TIME_GPS", at(slice(None), 7.0)),
        DataError("no two fixes more than 600 s apart"),
        [],
    ),
    "all fixes under water": (
        put("DEPTH", sunk),
        DataError(
            r"have a new fix 400 m under water in row 0 and \d+ more rows .* set both to NaN"
        ),
        [],
    ),
    "no fixes": (
        put("LATITUDE_GPS", at(slice(None), np.nan)),
        DataError("no two fixes more than 600 s apart"),
        [],
    ),
    "no variable of fixes": (
        renamed("LATITUDE_GPS", "LATITUDE_OF_GPS"),
        DataError("no variable LATITUDE_GPS; OG1 has the fixes there"),
        [],
    ),
    "no heading": (
        renamed("HEADING", "HEADED"),
        "no EAST_DISPLACEMENT, NORTH_DISPLACEMENT, no speed and heading",
        [],
    ),
    "speed in fortnights": (
        said("HORZ_GLIDER_SPEED", units="furlong/fortnight"),
        DataError("HORZ_GLIDER_SPEED: units = 'furlong/fortnight' is no speed"),
        [],
    ),
    "speed ten thousand times too large": (
        said("HORZ_GLIDER_SPEED", units="km/s"),
        "the displacement through the water is .* at most 5 m/s can be",
        [],
    ),
    "rows from last to first": (reversed_rows, "not in order of time, sorted", [3, 4, 6, 7]),
    "times of samples gone": (
        put("TIME", at(slice(300, 320), np.nan)),
        r"no samples for \d+ s of 7380 s",
        [3, 4, 7],
    ),
    "dive numbers gone": (put("dive_num", at(slice(None), np.nan)), "", [3, 4, 6, 7]),
}
OF_SPRAY = {
    "an end at 0 N 0 E": (
        [
            put("latitude_gps_end", at(slice(-5, None), 0.0)),
            put("longitude_gps_end", at(slice(-5, None), 0.0)),
        ],
        "",
        [32, 33, 34, 35],
    ),
    "no middles": (
        put("time_uv", at(slice(None), np.nan)),
        "no fix before the dive",
        [],
    ),
    "no current": (
        put("wcur_x", at(slice(-17, None), np.nan)),
        "no EAST_DISPLACEMENT, .* no depth-averaged current",
        [32, 33, 34],
    ),
    "no ends": (
        put("time_gps_end", at(slice(None), np.nan)),
        DataError("TIME_GPS_END, LATITUDE_GPS_END, LONGITUDE_GPS_END have no fix"),
        [],
    ),
}


@pytest.mark.parametrize(
    ("name", "damage", "sentence", "used"),
    [
        pytest.param(name, *case, id=f"{name[:5]}: {what}")
        for name, cases in ((SG015, OF_SG015), (SPRAY, OF_SPRAY))
        for what, case in cases.items()
    ],
)
def test_a_damaged_mission_is_named_and_its_good_dives_are_used(
    facts, tmp_path, name, damage, sentence, used
):
    path = tmp_path / name
    shutil.copyfile(facts / "glider" / "og1" / name, path)
    assert [dive.number for dive in usable(read_dives(path)[0])[0]] == GOOD[name]
    with netCDF4.Dataset(path, "a") as data:
        for one in damage if isinstance(damage, list) else [damage]:
            one(data)
    judge(path, sentence, used)


def judge(path, sentence, used):
    """Read a damaged file: refused in a sentence, or good dives used and others told."""
    if isinstance(sentence, DataError):
        with pytest.raises(ClptError, match=str(sentence)) as refused:
            read_dives(path)
        assert "\n" not in str(refused.value)
        assert str(path) in str(refused.value)
        return
    dives, unread = read_dives(path)
    found, unused = usable(dives)
    told = [one.why for one in (*unread, *unused)]
    told += [note for dive in found for note in dive.notes]
    assert any(re.search(sentence, why) for why in told) or not sentence
    assert [dive.number for dive in found] == used
    assert all(np.isfinite(step.clpe["adaptive"]) for step in replay_dives(found).steps)


def cell(column, line, text):
    """Change a cell, by its column's name and the row's place."""

    def damage(rows):
        rows[line][rows[0].index(column)] = text(rows[line]) if callable(text) else text

    return damage


def column(name, text):
    def damage(rows):
        place = rows[0].index(name)
        for row in rows[1:]:
            row[place] = text(row[place])

    return damage


def ddmm(text):
    degrees = abs(float(text))
    sign = "-" if float(text) < 0 else ""
    return f"{sign}{int(degrees)}{60 * (degrees % 1):07.4f}"


def in_minutes(rows):
    for name in ("lat_gps2", "lon_gps2", "lat_gpse", "lon_gpse"):
        column(name, ddmm)(rows)


OF_SEA035 = {
    "degrees and minutes": (
        in_minutes,
        r"looks like ddmm.mmm, degrees and minutes; give decimal degrees, 51\.68\d+ -128\.30",
        "none",
    ),
    "a latitude with a comma": (cell("lat_gpse", 5, "51,65"), r"no number|must be", 5),
    "an empty fix": (cell("lon_gpse", 5, ""), "lon_gpse is empty", 5),
    "a date that is none": (cell("t_gps2", 5, "2019-06-31T00:00:00Z"), "or a date such as", 5),
    "times in ms": (
        lambda rows: [column(t, lambda x: f"{1e3 * float(x):.0f}")(rows) for t in TIMES],
        "it looks like milliseconds, give seconds",
        "none",
    ),
    "a dive twice": (
        lambda rows: rows.append(rows[5]),
        "duplicate: has the times of dive 5",
        "all",
    ),
    "two dives of one time": (
        lambda rows: rows.insert(6, ["77", *rows[5][1:7], "9.0", "9.0", *rows[5][9:]]),
        "duplicate of dive 5, which is used, with another displacement",
        "all",
    ),
    "swapped fixes": (cell("t_gpse", 5, "1560457000"), "swapped times", 5),
    "dead reckoning in km": (
        cell("dr_east_m", 5, "nan"),
        "the displacement through the water is not finite",
        5,
    ),
    "half a row": (lambda rows: rows[5].__delitem__(slice(3, None)), "", 5),
}
TIMES = ("t_gps2", "t_gpse")


@pytest.mark.parametrize(("damage", "sentence", "lost"), OF_SEA035.values(), ids=OF_SEA035)
def test_a_damaged_table_is_named_and_its_good_dives_are_used(
    facts, tmp_path, damage, sentence, lost
):
    with (facts / "glider" / "sea035m10_dives.csv").open() as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))[:13]
    good = [int(row[0]) for row in rows[1:] if row[0] != "1"]  # the first is too short
    damage(rows)
    path = tmp_path / "dives.csv"
    with path.open("w", newline="") as file:
        csv.writer(file).writerows(rows)
    used = {"all": good, "none": []}.get(lost, [number for number in good if number != lost])
    judge(path, sentence, used)
