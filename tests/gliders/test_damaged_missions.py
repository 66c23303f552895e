"""Missions as they come: each damage has its reason, and good dives are used.

The damage is made here, of the facts of SG015 (OG1) and sp028 (Spray).
"""

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


def said(name, **attributes):
    return lambda data: data[name].setncatts(attributes)


def scaled(values, _):
    values /= 1e6


# of fixes: 2 k before dive k + 1 and 2 k + 1 after it; each: the damage, what is said, what is used
OF_SG015 = {
    "a fix without time": (put("TIME_GPS", at(13, np.nan)), "", [3, 4, 6]),
    "times of fixes in ms": (put("TIME_GPS", scaled), "read as milliseconds", [3, 4, 6, 7]),
    "times without any sense": (
        put("TIME_GPS", at(slice(None), 7.0)),
        DataError("no two fixes more than 600 s apart"),
        [],
    ),
    "speed ten thousand times too large": (
        said("HORZ_GLIDER_SPEED", units="km/s"),
        "the displacement through the water is .* at most 5 m/s can be",
        [],
    ),
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
