"""Missions and segments as they come: each damage is named, and the good dives are used."""

import gzip
import os
import re
import shutil
from contextlib import suppress

import netCDF4
import numpy as np
import pytest
from slocum_bytes import CRC, cac, segment

from clpt_control.errors import DataError
from clpt_control.gliders import read_dives, usable
from clpt_control.replay import replay_dives

DAMAGED = "rosie_713-2019-170-0-2.sbd"
GOOD = [980000, 980003]
HEADER = 354  # bytes of the header of that file, more or less


def cut(share):
    return lambda raw: raw[: int(share * len(raw))]


def zeros(at, count):
    return lambda raw: raw[:at] + bytes(count) + raw[at + count :]


def swapped(old, new):
    return lambda raw: raw.replace(old, new, 1)


def flipped(seed):
    """Change 30 bytes behind the header."""

    def damage(raw):
        rng, out = np.random.default_rng(seed), bytearray(raw)
        for at in rng.integers(HEADER + 100, len(raw), 30):
            out[at] = rng.integers(256)
        return bytes(out)

    return damage


SLOCUM = {
    "empty": (cut(0.0), "is empty"),
    "two bytes": (lambda raw: raw[:2], "no column dive"),
    "magic only": (lambda raw: raw[:4], "damaged or cut short"),
    "half a header": (lambda raw: raw[: HEADER // 2], "damaged or cut short"),
    "header only": (lambda raw: raw[: raw.index(b"sa\x12\x34")], "no cycles behind its header"),
    "known bytes only": (lambda raw: raw[: raw.index(b"sa\x12\x34") + 16], None),
    "cut at 30 %": (cut(0.3), None),
    "cut at 99 %": (cut(0.99), "cut short or damaged at byte"),
    "half an end": (lambda raw: raw[:-2], "cut short or damaged at byte"),
    "no end mark, as newer gliders write it": (lambda raw: raw[:-1], None),
    "count of cycles' sensors": (
        swapped(b"sensors_per_cycle:    ", b"sensors_per_cycle:   -"),
        None,
    ),
    "zeros in the header": (zeros(100, 60), "damaged or cut short"),
    "zeros in the middle": (zeros(5000, 300), None),
    "all zeros": (lambda raw: bytes(len(raw)), "neither"),
    "a byte too many": (lambda raw: raw[:3000] + b"?" + raw[3000:], None),
    "30 bytes changed": (flipped(1), None),
    "30 other bytes changed": (flipped(2), None),
    "no such list": (swapped(b"6b016a2e", b"0000dead"), "0000dead.cac was not found"),
    "list is no name": (swapped(b"6b016a2e", b"../../et"), "names no list of sensors"),
    "count of sensors": (
        swapped(b"sensors:    27\n", b"sensors:    99\n"),
        "no list of 99 sensors",
    ),
    "count of state bytes": (swapped(b"per_cycle:    7", b"per_cycle:    9"), "state bytes"),
    "no numbers": (swapped(b"sensors:    27\n", b"sensors:    xx\n"), "total_num_sensors"),
    "encoding": (swapped(b"encoding_ver:    5", b"encoding_ver:    7"), "encoding '7'"),
    "is text": (lambda raw: b"dbd_label: no\n", "damaged or cut short"),
    "is an image": (lambda raw: b"\x89PNG\r\n\x1a\n" + raw, "neither"),
}


@pytest.fixture
def rosie(facts, tmp_path):
    """The second half of a Slocum's mission: five segments, three dives."""
    first_half = shutil.ignore_patterns("rosie_713-2019-166-*")
    source = facts / "glider/slocum_rosie"
    return shutil.copytree(source, tmp_path, dirs_exist_ok=True, ignore=first_half)


@pytest.mark.parametrize("name", SLOCUM)
def test_a_damaged_segment_among_good_ones(rosie, name):
    damage, said = SLOCUM[name]
    path = rosie / "sbd" / DAMAGED
    path.write_bytes(damage(path.read_bytes()))
    dives, skipped = read_dives(rosie / "sbd")
    used, left_out = usable(dives)
    assert set(GOOD) <= {dive.number for dive in used}
    if said:
        told = [one.why for one in skipped + left_out] + [n for d in used for n in d.notes]
        assert any(said in line for line in told), told
    assert all("\n" not in one.why for one in skipped)
    extra = [dive for dive in used if dive.number == 980002]
    assert all(abs(d.dr_east) + abs(d.dr_north) < 5000 for d in extra)


@pytest.mark.parametrize(
    "content", [b"", b"s: T 0 0 8 m_depth m\n", bytes(900), b"\xff\xfe" * 400, cac(["a"] * 27)]
)
def test_a_damaged_list_is_named(rosie, content):
    (rosie / "cac" / "6b016a2e.cac").write_bytes(content)
    with pytest.raises(DataError, match=r"6b016a2e\.cac|state bytes|5 files: no dive|damaged"):
        read_dives(rosie / "sbd")


def test_a_list_that_is_a_pipe_is_not_waited_for(rosie):
    (rosie / "cac" / "6b016a2e.cac").unlink()
    os.mkfifo(rosie / "cac" / "6b016a2e.cac")
    with pytest.raises(DataError, match=r"6b016a2e\.cac: is no regular file; give one"):
        read_dives(rosie / "sbd" / DAMAGED)


T0 = 1.7126e9
NAMES = ("m_present_time", "m_gps_lat", "m_gps_lon", "m_lat", "m_lon", "m_depth", "m_heading")


def cycles(**changed):
    """A short dive, 30 cycles of a minute; a column may be changed by a function of the cycle."""
    rows = []
    for k in range(30):
        row = {"m_present_time": T0 + 60 * k, "m_depth": 0.0 if k in (0, 29) else 40.0}
        row |= {"m_lat": 5136.0 + 0.01 * k, "m_lon": -12818.0, "m_heading": 0.0}
        if k in (0, 29):
            row |= {"m_gps_lat": 5136.0 + 0.011 * k, "m_gps_lon": -12818.0}
        for name, change in changed.items():
            if name in row:
                row[name] = change(k, row[name])
        rows.append({name: value for name, value in row.items() if value is not None})
    return rows


MADE = {
    "sound": ({}, 1),
    "fixes are NaN": ({"m_gps_lat": lambda k, v: np.nan}, 0),
    "fixes are fill values": ({"m_gps_lat": lambda k, v: 69696969.0}, 0),
    "fixes have 70 minutes": ({"m_gps_lat": lambda k, v: 5170.0}, 0),
    "fixes at 0, 0": ({"m_gps_lat": lambda k, v: 0.0, "m_gps_lon": lambda k, v: 0.0}, 0),
    "time goes back": ({"m_present_time": lambda k, v: v - 600 * (k == 15)}, 1),
    "time stands still": ({"m_present_time": lambda k, v: T0}, 0),
    "time of 1904": ({"m_present_time": lambda k, v: v - 4e9}, 0),
    "time is NaN in places": ({"m_present_time": lambda k, v: np.nan if k % 5 == 3 else v}, 1),
    "no heading": ({"m_heading": lambda k, v: None}, 1),
    "no dead reckoning": ({"m_lat": lambda k, v: None}, 0),
    "depth is NaN": ({"m_depth": lambda k, v: np.nan}, 0),
    "dead reckoning at 0, 0": ({"m_lat": lambda k, v: 0.0, "m_lon": lambda k, v: 0.0}, 0),
}


@pytest.mark.parametrize("name", MADE)
def test_odd_values_in_a_sound_file(tmp_path, name):
    changed, good = MADE[name]
    (tmp_path / f"{CRC}.cac").write_bytes(cac(NAMES))
    (tmp_path / "00070001.sbd").write_bytes(segment(cycles(**changed), NAMES))
    shutil.copy(tmp_path / "00070001.sbd", tmp_path / "00070002.sbd")
    used = []
    with suppress(DataError):
        used, _ = usable(read_dives(tmp_path)[0])
    assert len(used) == good


def lines(text):
    return text.splitlines(keepends=True)


SEAEXPLORER = {
    "sound": (lambda t: t, 1, ""),
    "gzip": (lambda t: gzip.compress(t.encode()), 1, ""),
    "gzip cut short": (lambda t: gzip.compress(t.encode())[:-300], 0, ""),
    "gzip of zeros": (lambda t: b"\x1f\x8b" + bytes(300), 0, "gzip is damaged"),
    "empty": (lambda t: "", 0, "is empty"),
    "header only": (lambda t: lines(t)[0], 0, "no line has a Timestamp"),
    "no Pitch": (lambda t: t.replace("Pitch", "Tilt"), 0, "no column Pitch"),
    "commas": (lambda t: t.replace(";", ","), 0, "no column dive, "),
    "last line cut": (lambda t: t[:-20], 1, ""),
    "no fix after": (lambda t: "".join(lines(t)[:10]), 0, ""),
    "fixes at 0, 0": (lambda t: re.sub(r"51\d\d[.]\d+;-128\d\d[.]\d+", "0.000;0.000", t), 0, ""),
    "fixes are words": (lambda t: t.replace("5140.9", "none"), 0, ""),
    "pitch is zero": (lambda t: t.replace(";30.", ";0."), 1, ""),
    "twice": (lambda t: t + t, 1, ""),
    "backwards": (lambda t: lines(t)[0] + "".join(lines(t)[:0:-1]), 1, ""),
    "American dates": (lambda t: t.replace("13/06/", "06/13/"), 0, "no line has a Timestamp"),
}


@pytest.mark.parametrize("name", SEAEXPLORER)
def test_a_damaged_navigation_file(facts, tmp_path, name):
    damage, good, said = SEAEXPLORER[name]
    shutil.copytree(facts / "glider/sea035", tmp_path, dirs_exist_ok=True)
    path = tmp_path / "SEA035.10.gli.sub.003"
    damaged = damage(path.read_text())
    path.write_bytes(damaged.encode() if isinstance(damaged, str) else damaged)
    (tmp_path / "other.csv").write_bytes((facts / "glider/sea035m10_dives.csv").read_bytes())
    dives, skipped = read_dives(tmp_path)
    assert sum(dive.number == 3 and dive.dac_east is None for dive in dives) == 1 + good
    assert not said or said in " ".join(one.why for one in skipped)


SG015, SPRAY = "sg015_20040929T140907_delayed.nc", "sp028_20230202T1637_R.nc"
WHOLE = {SG015: [3, 4, 6, 7], SPRAY: [32, 33, 34, 35]}


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
        "samples of the displacement are not finite or above 5 m/s",
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
    "no middles": (put("time_uv", at(slice(None), np.nan)), "no fix before the dive", []),
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


@pytest.mark.parametrize("name", WHOLE)
def test_a_whole_mission_is_used_whole(facts, name):
    dives, _ = read_dives(facts / "glider" / "og1" / name)
    assert [dive.number for dive in usable(dives)[0]] == WHOLE[name]


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
    with netCDF4.Dataset(path, "a") as data:
        for one in damage if isinstance(damage, list) else [damage]:
            one(data)
    if isinstance(sentence, DataError):
        with pytest.raises(DataError, match=str(sentence)) as refused:
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


def test_a_file_before_that_is_empty_is_left_out(facts, tmp_path):
    shutil.copytree(facts / "glider/sea035", tmp_path, dirs_exist_ok=True)
    (tmp_path / "SEA035.10.gli.sub.002").write_bytes(b"")
    with pytest.raises(DataError, match=r"002: is empty"):
        read_dives(tmp_path)
    with pytest.raises(DataError, match="no dives"):
        read_dives(tmp_path / "SEA035.10.gli.sub.003")
