"""Damaged files of gliders among good ones: named, and the good dives still used."""

import gzip
import os
import re
import shutil
from contextlib import suppress

import netCDF4
import numpy as np
import pytest
from glider_dialects import (
    CTD,
    DURATION,
    EPOCH,
    SWUM,
    M,
    basestation,
    basestation3,
    dives_in,
    fixes,
    swim,
)
from slocum_bytes import CRC, cac, segment

from clpt_control.errors import DataError
from clpt_control.gliders import read_dives, usable

nan = np.nan
GPS = ("gps_info",)
STEPS = ("east_displacement", "north_displacement")
FORTNIGHTS = {"units": "fortnights since 1970-01-01"}
times, lats, lons = fixes(7, 8.0)
since, depth, steps = swim(1800)


def at(numbers, place, value):
    """Change one number of a copy."""
    numbers = np.array(numbers, dtype=float)
    numbers[place] = value
    return numbers


def gps(**changed):
    """Return the fixes of dive 7, one of them changed: lat=(1, 0.0)."""
    columns = {"time": times, "lat": lats, "lon": lons}
    for name, (place, value) in changed.items():
        columns[name] = at(columns[name], place, value)
    units = {"time": EPOCH}
    return {f"log_gps_{name}": (GPS, a, units.get(name, {})) for name, a in columns.items()}


def stepped(place, value):
    """Return the displacement to the east, some steps of it changed."""
    return {STEPS[0]: (CTD, at(steps[:, 0], place, value), M)}


# a share of the file, its bytes, variables that are missing, or those that are changed
NOT_USED = {
    "cut at 10 %": (0.1, "cannot be read"),
    "cut at 60 %": (0.6, "cannot be read"),
    "last bytes gone": (0.999, "cannot be read"),
    "one byte": (b"C", "no column dive, "),
    "100 bytes": (b"CDF\x01" + bytes(96), "no variables"),
    "empty": (b"", "empty"),
    "text": (b"the modem dropped the line\nhere\n", "no column dive, "),
    "blank lines": (b"\n\n  \n", "empty"),
    "noise": (bytes(range(128, 256)) * 40, "neither NetCDF"),
    "HDF5 of noise": (b"\x89HDF\r\n\x1a\n" + bytes(500), "cannot be read as NetCDF"),
    "GPS2 at 0, 0": (gps(lat=(1, 0.0), lon=(1, 0.0)), "no fix before the dive"),
    "latitude NaN": (gps(lat=(2, nan)), "no fix after"),
    "time NaN": (gps(time=(1, nan)), "no fix before"),
    "GPSE of last week": (gps(time=(2, times[2] - 6e5)), "swapped times"),
    "GPSE timed out": ({"log_gps_hdop": (GPS, [1, 1, 99.0], {})}, "GPSE has a hdop of 99"),
    "two fixes": (
        {f"log_gps_{k}": (("two",), [0.0, 1.0], {}) for k in ("time", "lat", "lon")},
        "2 fixes in log_gps_time",
    ),
    "no longitudes": (("log_gps_lon",), "no variable log_gps_lon"),
    "times in fortnights": ({"ctd_time": (CTD, since, FORTNIGHTS)}, "'fortnights since"),
    "displacement in furlongs": (
        {STEPS[0]: (CTD, steps[:, 0], {"units": "furlong"})},
        "'furlong'; must be such as 'm'",
    ),
    "displacement of another instrument": (
        {STEPS[1]: (("two",), [1.0, 2.0], M)},
        "differ in length",
    ),
    "no north": ((STEPS[1],), "no variables east_displacement"),
    "displacement infinite": (stepped(slice(5, 305), np.inf), "300 of 1800 samples"),
    "half of the displacement": (stepped(slice(0, 900), nan), "900 of 1800 samples"),
    "climb not sent": (
        {
            "ctd_time": (CTD, times[1] + since / 2, EPOCH),
            "ctd_depth": (CTD, np.linspace(0, 400, 1800), M),
        },
        "from 400 m depth on",
    ),
}


@pytest.mark.parametrize("name", NOT_USED)
def test_a_damaged_file_is_named_and_the_good_dives_are_used(name, tmp_path):
    damage, why = NOT_USED[name]
    basestation(tmp_path / "p1230006.nc", number=6)
    basestation3(tmp_path / "p1230008.nc", number=8)
    path = tmp_path / "p1230007.nc"
    if isinstance(damage, dict):
        basestation3(path, sizes={"two": 2}, **damage)
    else:
        raw = basestation3(path, drop=damage if isinstance(damage, tuple) else ()).read_bytes()
        cut = raw[: int(damage * len(raw))] if isinstance(damage, float) else raw
        path.write_bytes(damage if isinstance(damage, bytes) else cut)
    found, unread = read_dives(tmp_path)
    used, unused = usable(found)
    assert [dive.number for dive in used] == [6, 8]
    (skipped,) = unread + unused
    assert skipped.dive == 7
    assert why in skipped.why
    assert "\n" not in skipped.why
    if unread:
        assert str(path) in skipped.why
        with pytest.raises(DataError, match="p1230007"):
            read_dives(path)


GLIDE_SLOPE = {f"{name}_gsm": (CTD, steps[:, k], M) for k, name in enumerate(STEPS)}
NO_TIMES = "no track: no times in order with the dimension of east_displacement"
REPAIRED = {
    "no times": ({}, ("ctd_time",), NO_TIMES),
    "times descend": ({"ctd_time": (CTD, times[1] + since[::-1], EPOCH)}, (), NO_TIMES),
    "time NaN": ({"ctd_time": (CTD, at(times[1] + since, 9, nan), EPOCH)}, (), NO_TIMES),
    "flagged": ({"log_gps_qc": (GPS, [1.0, 1.0, 4.0], {})}, (), "the file flags GPSE 4"),
    "flagged by its letter": ({"GPSE_qc": ((), "4", {})}, (), "the file flags GPSE 4"),
    "GPS2 is old": (
        gps(time=(1, times[1] - 9000)),
        (),
        "older than GPS1, which is taken as the fix before",
    ),
    "GPS1 is late": (gps(time=(0, times[1] + 700)), (), "which is left out"),
    "GPS1 at 0, 0": (gps(lat=(0, 0.0), lon=(0, 0.0)), (), ""),
    "GPS1 timed out": ({"log_gps_hdop": (GPS, [99.0, 1, 1], {})}, (), "GPS1 has a hdop of 99"),
    "no depths": ({}, ("ctd_depth", "eng_depth"), ""),
    "one step NaN": (stepped(700, nan), (), "1 of 1800 samples"),
    "no flight model": (GLIDE_SLOPE, STEPS, "dead reckoning of the glide-slope model"),
}


@pytest.mark.parametrize("name", REPAIRED)
def test_what_can_be_repaired_is_and_says_so(name, tmp_path):
    changed, drop, said = REPAIRED[name]
    dive = dives_in(basestation3(tmp_path / "p1230007.nc", drop=drop, **changed))[0]
    assert [one.number for one in usable([dive])[0]] == [7]
    assert said in "; ".join(dive.notes)
    assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(SWUM), rel=1e-6)
    assert (dive.track is None) == (said == NO_TIMES)
    if "GPS1" in name or "GPS2" in name:
        assert dive.t_gps1 is None
    if name == "GPS2 is old":
        assert (dive.t_gps2, dive.duration) == (times[0], DURATION + 300)


def test_what_was_named_must_exist(tmp_path):
    with pytest.raises(DataError, match="no such file"):
        read_dives([tmp_path / "nothing.nc"])
    with pytest.raises(DataError, match="the folder has no"):
        read_dives(tmp_path)
    for name in ("a.nc", "b.nc"):
        (tmp_path / name).write_bytes(b"")
    with pytest.raises(DataError, match="2 files: no dive"):
        read_dives(tmp_path)
    with netCDF4.Dataset(tmp_path / "grid.nc", "w") as data:
        data.createVariable("u", float)
    with pytest.raises(DataError, match="neither a Seaglider file"):
        read_dives(tmp_path / "grid.nc")


DAMAGED = "rosie_713-2019-170-0-2.sbd"
GOOD = {980000, 980003}
HEADER = 354  # bytes of the header of that file, more or less


def cut(share):
    return lambda raw: raw[: int(share * len(raw))]


def zeros(at, count):
    return lambda raw: raw[:at] + bytes(count) + raw[at + count :]


def swapped(old, new):
    return lambda raw: raw.replace(old, new, 1)


def header(more):
    return lambda raw: raw[: raw.index(b"sa\x12\x34") + more]


def flipped(raw):
    """Change 30 bytes behind the header."""
    rng, out = np.random.default_rng(1), bytearray(raw)
    for at in rng.integers(HEADER + 100, len(raw), 30):
        out[at] = rng.integers(256)
    return bytes(out)


CUT, NO_HEADER = "cut short or damaged at byte", "damaged or cut short"
SLOCUM = {
    "empty": (cut(0.0), "is empty"),
    "two bytes": (lambda raw: raw[:2], "no column dive"),
    "half a header": (lambda raw: raw[: HEADER // 2], NO_HEADER),
    "header only": (header(0), "no cycles behind its header"),
    "known bytes only": (header(16), ""),
    "cut at 30 %": (cut(0.3), ""),
    "cut at 99 %": (cut(0.99), CUT),
    "half an end": (lambda raw: raw[:-2], CUT),
    "no end mark, as newer gliders write it": (lambda raw: raw[:-1], ""),
    "count of cycles' sensors": (swapped(b"_cycle:    ", b"_cycle:   -"), ""),
    "zeros in the header": (zeros(100, 60), NO_HEADER),
    "zeros in the middle": (zeros(5000, 300), ""),
    "all zeros": (lambda raw: bytes(len(raw)), "neither"),
    "a byte too many": (lambda raw: raw[:3000] + b"?" + raw[3000:], ""),
    "30 bytes changed": (flipped, ""),
    "no such list": (swapped(b"6b016a2e", b"0000dead"), "0000dead.cac was not found"),
    "list is no name": (swapped(b"6b016a2e", b"../../et"), "names no list of sensors"),
    "count of sensors": (swapped(b"sors:    27\n", b"sors:    99\n"), "no list of 99 sensors"),
    "count of state bytes": (swapped(b"per_cycle:    7", b"per_cycle:    9"), "state bytes"),
    "no numbers": (swapped(b"sensors:    27\n", b"sensors:    xx\n"), "total_num_sensors"),
    "encoding": (swapped(b"encoding_ver:    5", b"encoding_ver:    7"), "encoding '7'"),
    "is text": (lambda raw: b"dbd_label: no\n", NO_HEADER),
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
    assert {dive.number for dive in used} >= GOOD
    told = [one.why for one in skipped + left_out] + [n for d in used for n in d.notes]
    assert not said or any(said in line for line in told), told
    assert all("\n" not in one.why for one in skipped)
    extra = [dive for dive in used if dive.number == 980002]
    assert all(abs(d.dr_east) + abs(d.dr_north) < 5000 for d in extra)


@pytest.mark.parametrize(
    "content", [b"", b"s: T 0 0 8 m_depth m\n", b"\xff\xfe" * 400, cac(["a"] * 27), "a pipe"]
)
def test_a_damaged_list_is_named(rosie, content):
    path = rosie / "cac" / "6b016a2e.cac"
    path.unlink()
    if content == "a pipe":  # is not waited for
        os.mkfifo(path)
    else:
        path.write_bytes(content)
    with pytest.raises(DataError, match=r"6b016a2e\.cac|state bytes|5 files: no dive|damaged"):
        read_dives(rosie / "sbd")


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
        row |= {name: change(k, row[name]) for name, change in changed.items() if name in row}
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
    for k in (1, 2):
        (tmp_path / f"0007000{k}.sbd").write_bytes(segment(cycles(**changed), NAMES))
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
    "no fix": (lambda t: t.replace(";116;", ";117;"), 0, "no row with a fix (NavState 116)"),
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
    if name == "no fix":
        (tmp_path / "SEA035.10.gli.sub.002").unlink()
    path = tmp_path / "SEA035.10.gli.sub.003"
    damaged = damage(path.read_text())
    path.write_bytes(damaged.encode() if isinstance(damaged, str) else damaged)
    (tmp_path / "other.csv").write_bytes((facts / "glider/sea035m10_dives.csv").read_bytes())
    dives, skipped = read_dives(tmp_path)
    assert sum(dive.number == 3 and dive.dac_east is None for dive in dives) == 1 + good
    assert not said or said in " ".join(one.why for one in skipped)


def test_a_file_before_that_is_empty_is_left_out(facts, tmp_path):
    shutil.copytree(facts / "glider/sea035", tmp_path, dirs_exist_ok=True)
    (tmp_path / "SEA035.10.gli.sub.002").write_bytes(b"")
    with pytest.raises(DataError, match=r"002: is empty"):
        read_dives(tmp_path)
    with pytest.raises(DataError, match="no dives"):
        read_dives(tmp_path / "SEA035.10.gli.sub.003")
