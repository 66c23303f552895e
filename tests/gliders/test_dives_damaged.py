"""Damaged files of a Seaglider among good ones: named, and the good dives still used."""

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

from clpt_control.errors import DataError
from clpt_control.gliders.dive_files import read_dives
from clpt_control.gliders.usable_dives import usable

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
    "GPSE at 0, 0": (gps(lat=(2, 0.0), lon=(2, 0.0)), "no fix after the dive"),
    "latitude NaN": (gps(lat=(2, nan)), "no fix after"),
    "longitude NaN": (gps(lon=(1, nan)), "no fix before"),
    "time NaN": (gps(time=(1, nan)), "no fix before"),
    "latitude 91": (gps(lat=(2, 91.0)), "no fix after"),
    "latitude a fill value": (gps(lat=(1, 9.97e36)), "no fix before"),
    "end fix of another sea": (gps(lat=(2, 43.0)), "m/s"),
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
