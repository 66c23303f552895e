"""Damaged files of gliders among good ones: named, and the good dives still used."""

import gzip
import os
import re
import shutil
from contextlib import suppress

import netCDF4
import numpy as np
import pytest
from glider_files import (
    CTD,
    EPOCH,
    INFO,
    SWUM,
    M,
    basestation,
    basestation3,
    fixes,
    swim,
)
from refusals import refuses
from slocum_writer import CRC, cac, segment

from clpt_control import DataError
from clpt_control.gliders import read_dives

nan = np.nan
EAST, NORTH = "east_displacement", "north_displacement"
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
    columns |= {name: at(columns[name], *change) for name, change in changed.items()}
    return {
        f"log_gps_{k}": (INFO, a, EPOCH if k == "time" else {})
        for k, a in columns.items()
    }


def stepped(place, value):
    """Return the displacement to the east, some steps of it changed."""
    return {EAST: (CTD, at(steps[:, 0], place, value), M)}


def timed(numbers, units=EPOCH):
    return {"ctd_time": (CTD, numbers, units)}


TWO_FIXES = {f"log_gps_{k}": (("two",), [0.0, 1.0], {}) for k in ("time", "lat", "lon")}
NO_CLIMB = timed(times[1] + since / 2) | {
    "ctd_depth": (CTD, np.linspace(0, 400, 1800), M)
}
NOT_USED = [  # a share of the file, its bytes, a missing variable, or those that are changed
    *((share, "cannot be read") for share in (0.1, 0.6, 0.999)),
    (b"C", "no column dive, "),
    (b"CDF\x01" + bytes(96), "no variables"),
    (b"", "empty"),
    (b"the modem dropped the line\nhere\n", "no column dive, "),
    (b"\n\n  \n", "empty"),
    (bytes(range(128, 256)) * 40, "neither NetCDF"),
    (b"\x89HDF\r\n\x1a\n" + bytes(500), "cannot be read as NetCDF"),
    (gps(lat=(1, 0.0), lon=(1, 0.0)), "no fix before the dive"),
    (gps(lat=(2, nan)), "no fix after"),
    (gps(time=(1, nan)), "no fix before"),
    (gps(time=(2, times[2] - 6e5)), "swapped times"),
    ({"log_gps_hdop": (INFO, [1, 1, 99.0], {})}, "GPSE has a hdop of 99"),
    ({"log_gps_qc": (INFO, [1.0, 1.0, 4.0], {})}, "flags GPSE 4, bad: left out"),
    ({"GPSE_qc": ((), "8", {})}, "the file flags GPSE 8, bad: left out"),
    (TWO_FIXES, "2 fixes in log_gps_time"),
    ("log_gps_lon", "no variable log_gps_lon"),
    (timed(since, {"units": "fortnights since 1970-01-01"}), "'fortnights since"),
    (
        {EAST: (CTD, steps[:, 0], {"units": "furlong"})},
        "'furlong'; use a unit such as 'm'",
    ),
    ({NORTH: (("two",), [1.0, 2.0], M)}, "differ in length"),
    (NORTH, "no variables east_displacement"),
    (stepped(slice(5, 305), np.inf), "300 of 1800 samples"),
    (stepped(slice(0, 900), nan), "900 of 1800 samples"),
    (NO_CLIMB, "from 400 m depth on"),
]


@pytest.mark.parametrize(("damage", "why"), NOT_USED)
def test_a_damaged_file_is_named_and_the_good_dives_are_used(damage, why, tmp_path):
    basestation(tmp_path / "p1230006.nc", number=6)
    basestation3(tmp_path / "p1230008.nc", number=8)
    path = tmp_path / "p1230007.nc"
    changed = damage if isinstance(damage, dict) else {}
    basestation3(path, drop=[damage], **changed)
    if isinstance(damage, float | bytes):
        raw = path.read_bytes()
        path.write_bytes(
            raw[: int(damage * len(raw))] if isinstance(damage, float) else damage
        )
    _, unread = read_dives(tmp_path, usable=False)
    used, skipped = read_dives(tmp_path)
    unused = skipped[len(unread) :]
    assert [dive.number for dive in used] == [6, 8]
    (skipped,) = unread + unused
    assert skipped.dive == 7
    assert why in skipped.why
    assert "\n" not in skipped.why
    if unread:
        assert str(path) in skipped.why
        refuses("p1230007", read_dives, path)


GLIDE_SLOPE = {
    f"{name}_gsm": (CTD, steps[:, k], M) for k, name in enumerate((EAST, NORTH))
}
NO_TIMES = "no track: no times in order with the dimension of east_displacement"
OLD = "older than GPS1, which is taken as the fix before"
REPAIRED = [  # what is changed, what is missing, what is said, and whether GPS1 stays
    ({}, ["ctd_time"], NO_TIMES, True),
    (timed(times[1] + since[::-1]), (), NO_TIMES, True),
    (timed(at(times[1] + since, 9, nan)), (), NO_TIMES, True),
    ({"log_gps_qc": (INFO, [1.0, 1.0, 5.0], {})}, (), "the file flags GPSE 5", True),
    ({"GPSE_qc": ((), "5", {})}, (), "the file flags GPSE 5", True),
    ({"GPS1_qc": ((), "4", {})}, (), "the file flags GPS1 4, bad: left out", False),
    (gps(time=(1, times[1] - 9000)), (), OLD, False),
    (gps(time=(0, times[1] + 700)), (), "which is left out", False),
    (gps(lat=(0, 0.0), lon=(0, 0.0)), (), "", False),
    ({"log_gps_hdop": (INFO, [99.0, 1, 1], {})}, (), "GPS1 has a hdop of 99", False),
    ({}, ["ctd_depth", "eng_depth"], "", True),
    (stepped(700, nan), (), "1 of 1800 samples", True),
    (GLIDE_SLOPE, [EAST, NORTH], "dead reckoning of the glide-slope model", True),
]


@pytest.mark.parametrize(("changed", "drop", "said", "first"), REPAIRED)
def test_what_can_be_repaired_is_and_says_so(changed, drop, said, first, tmp_path):
    path = basestation3(tmp_path / "p1230007.nc", drop=drop, **changed)
    ((dive,), _) = read_dives(path)
    assert dive.number == 7
    assert said in "; ".join(dive.notes)
    assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(SWUM), rel=1e-6)
    assert (dive.track is None) == (said == NO_TIMES)
    assert first or dive.t_gps1 is None
    if said == OLD:
        assert (dive.t_gps2, dive.duration) == (times[0], times[2] - times[0])


def test_what_was_named_must_exist(tmp_path):
    refuses("no dive files in this folder", read_dives, tmp_path)
    for name in ("a.nc", "b.nc"):
        (tmp_path / name).write_bytes(b"")
    refuses("2 files: no dive", read_dives, tmp_path)
    with netCDF4.Dataset(tmp_path / "grid.nc", "w") as data:
        data.createVariable("u", float)
    refuses("neither a Seaglider file", read_dives, tmp_path / "grid.nc")


def flipped(raw):
    """Change 30 bytes behind the header, which has some 354."""
    rng, out = np.random.default_rng(1), bytearray(raw)
    for place in rng.integers(454, len(raw), 30):
        out[place] = rng.integers(256)
    return bytes(out)


CUT, NO_HEADER, KNOWN = (
    "cut short or damaged at byte",
    "damaged or cut short",
    b"sa\x12\x34",
)
SLOCUM = [
    (lambda raw: b"", "is empty"),
    (lambda raw: raw[:2], "no column dive"),
    (lambda raw: raw[:177], NO_HEADER),
    (lambda raw: raw[: raw.index(KNOWN)], "no cycles after its header"),
    (lambda raw: raw[: raw.index(KNOWN) + 16], ""),
    (lambda raw: raw[: int(0.3 * len(raw))], ""),
    (lambda raw: raw[: int(0.99 * len(raw))], CUT),
    (lambda raw: raw[:-2], CUT),
    (lambda raw: raw[:-1], ""),  # no end mark, as newer gliders write it
    (lambda raw: raw.replace(b"_cycle:    ", b"_cycle:   -", 1), ""),
    (lambda raw: raw[:100] + bytes(60) + raw[160:], NO_HEADER),
    (lambda raw: raw[:5000] + bytes(300) + raw[5300:], ""),
    (lambda raw: bytes(len(raw)), "neither"),
    (lambda raw: raw[:3000] + b"?" + raw[3000:], ""),
    (flipped, ""),
    (
        lambda raw: raw.replace(b"6b016a2e", b"0000dead", 1),
        "0000dead.cac was not found",
    ),
    (lambda raw: raw.replace(b"6b016a2e", b"../../et", 1), "names no list of sensors"),
    (
        lambda raw: raw.replace(b"sors:    27\n", b"sors:    99\n", 1),
        "not a list of 99 sensors",
    ),
    (lambda raw: raw.replace(b"per_cycle:    7", b"per_cycle:    9", 1), "state bytes"),
    (
        lambda raw: raw.replace(b"sensors:    27\n", b"sensors:    xx\n", 1),
        "total_num_sensors",
    ),
    (
        lambda raw: raw.replace(b"encoding_ver:    5", b"encoding_ver:    7", 1),
        "encoding '7'",
    ),
    (lambda raw: b"dbd_label: no\n", NO_HEADER),
]


@pytest.fixture
def rosie(facts, tmp_path):
    """The second half of a Slocum's mission: five segments, three dives."""
    first_half = shutil.ignore_patterns("rosie_713-2019-166-*")
    source = facts / "glider/slocum_rosie"
    return shutil.copytree(source, tmp_path, dirs_exist_ok=True, ignore=first_half)


@pytest.mark.parametrize(("damage", "said"), SLOCUM)
def test_a_damaged_segment_among_good_ones(rosie, damage, said):
    path = rosie / "sbd" / "rosie_713-2019-170-0-2.sbd"
    path.write_bytes(damage(path.read_bytes()))
    _, skipped = read_dives(rosie / "sbd", usable=False)
    used, all_skipped = read_dives(rosie / "sbd")
    left_out = all_skipped[len(skipped) :]
    assert {dive.number for dive in used} >= {980000, 980003}
    told = [one.why for one in skipped + left_out] + [n for d in used for n in d.notes]
    assert not said or any(said in line for line in told), told
    assert all("\n" not in one.why for one in skipped)
    assert all(
        abs(d.dr_east) + abs(d.dr_north) < 5000 for d in used if d.number == 980002
    )


@pytest.mark.parametrize(
    "content",
    [b"", b"s: T 0 0 8 m_depth m\n", b"\xff\xfe" * 400, cac(["a"] * 27), "a pipe"],
)
def test_a_damaged_list_is_named(rosie, content):
    path = rosie / "cac" / "6b016a2e.cac"
    path.unlink()
    if content == "a pipe":  # is not waited for
        os.mkfifo(path)
    else:
        path.write_bytes(content)
    refuses(
        r"6b016a2e\.cac|state bytes|5 files: no dive|damaged", read_dives, rosie / "sbd"
    )


T0 = 1.7126e9
NAMES = (
    "m_present_time",
    "m_gps_lat",
    "m_gps_lon",
    "m_lat",
    "m_lon",
    "m_depth",
    "m_heading",
)


def cycles(changed):
    """A short dive, 30 cycles of a minute; a column may be changed by a function of the cycle."""
    for k in range(30):
        up = k in (0, 29)
        row = {"m_present_time": T0 + 60 * k, "m_depth": 0.0 if up else 40.0}
        row |= {"m_lat": 5136.0 + 0.01 * k, "m_lon": -12818.0, "m_heading": 0.0}
        row |= {"m_gps_lat": 5136.0 + 0.011 * k, "m_gps_lon": -12818.0} if up else {}
        row |= {
            name: change(k, row[name])
            for name, change in changed.items()
            if name in row
        }
        yield {name: value for name, value in row.items() if value is not None}


MADE = [  # what is changed, how many dives are used
    ({}, 1),
    ({"m_gps_lat": lambda k, v: np.nan}, 0),
    ({"m_gps_lat": lambda k, v: 69696969.0}, 0),  # a fill value
    ({"m_gps_lat": lambda k, v: 5170.0}, 0),  # 70 minutes
    ({"m_gps_lat": lambda k, v: 0.0, "m_gps_lon": lambda k, v: 0.0}, 0),
    ({"m_present_time": lambda k, v: v - 600 * (k == 15)}, 1),
    ({"m_present_time": lambda k, v: T0}, 0),
    ({"m_present_time": lambda k, v: v - 4e9}, 0),  # 1904
    ({"m_present_time": lambda k, v: np.nan if k % 5 == 3 else v}, 1),
    ({"m_heading": lambda k, v: None}, 1),
    ({"m_lat": lambda k, v: None}, 0),
    ({"m_depth": lambda k, v: np.nan}, 0),
    ({"m_lat": lambda k, v: 0.0, "m_lon": lambda k, v: 0.0}, 0),
]


@pytest.mark.parametrize(("changed", "good"), MADE)
def test_odd_values_in_a_sound_file(tmp_path, changed, good):
    (tmp_path / f"{CRC}.cac").write_bytes(cac(NAMES))
    for k in (1, 2):
        (tmp_path / f"0007000{k}.sbd").write_bytes(segment(cycles(changed), NAMES))
    used = []
    with suppress(DataError):
        used, _ = read_dives(tmp_path)
    assert len(used) == good


def lines(text):
    return text.splitlines(keepends=True)


NO_FIX = "no row with a fix (NavState 116)"
SEAEXPLORER = [  # what is changed, how many dives of it are used, what is said
    (lambda t: t, 1, ""),
    (lambda t: gzip.compress(t.encode()), 1, ""),
    (lambda t: gzip.compress(t.encode())[:-300], 0, ""),
    (lambda t: b"\x1f\x8b" + bytes(300), 0, "gzip is damaged"),
    (lambda t: "", 0, "is empty"),
    (lambda t: lines(t)[0], 0, "no line has a Timestamp"),
    (lambda t: t.replace("Pitch", "Tilt"), 0, "no column Pitch"),
    (lambda t: t.replace(";", ","), 0, "line 2: time is '13/06/2019 18:29:39'; must"),
    (lambda t: t[:-20], 1, ""),
    (lambda t: "".join(lines(t)[:10]), 0, ""),
    (lambda t: t.replace(";116;", ";117;"), 0, NO_FIX),
    (lambda t: re.sub(r"51\d\d[.]\d+;-128\d\d[.]\d+", "0.000;0.000", t), 0, ""),
    (lambda t: t.replace("5140.9", "none"), 0, ""),
    (lambda t: t.replace(";30.", ";0."), 1, ""),  # no pitch
    (lambda t: t + t, 1, ""),
    (lambda t: lines(t)[0] + "".join(lines(t)[:0:-1]), 1, ""),
    (lambda t: t.replace("13/06/", "06/13/"), 0, "no line has a Timestamp"),
]


@pytest.mark.parametrize(("damage", "good", "said"), SEAEXPLORER)
def test_a_damaged_navigation_file(facts, tmp_path, damage, good, said):
    shutil.copytree(facts / "glider/sea035", tmp_path, dirs_exist_ok=True)
    if said == NO_FIX:
        (tmp_path / "SEA035.10.gli.sub.002").unlink()
    path = tmp_path / "SEA035.10.gli.sub.003"
    damaged = damage(path.read_text())
    path.write_bytes(damaged.encode() if isinstance(damaged, str) else damaged)
    shutil.copy(facts / "glider/sea035m10_dives.csv", tmp_path)
    dives, skipped = read_dives(tmp_path, usable=False)
    assert sum(dive.number == 3 and dive.dac_east is None for dive in dives) == 1 + good
    assert said in " ".join(one.why for one in skipped)


def test_a_file_before_that_is_empty_is_left_out(facts, tmp_path):
    shutil.copytree(facts / "glider/sea035", tmp_path, dirs_exist_ok=True)
    (tmp_path / "SEA035.10.gli.sub.002").write_bytes(b"")
    refuses(r"002: is empty", read_dives, tmp_path)
    refuses("no fix before the dive", read_dives, tmp_path / "SEA035.10.gli.sub.003")
