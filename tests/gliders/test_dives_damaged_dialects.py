"""Damaged files of other dialects: each has its reason, and good dives stay in use."""

import numpy as np
import pytest
from glider_dialects import (
    DURATION,
    EPOCH,
    GPS_EAST,
    SWUM,
    T0,
    M,
    basestation,
    basestation3,
    dives_in,
    fixes,
    og1,
    og1_rows,
    swim,
)

from clpt_control.errors import DataError
from clpt_control.gliders.dive_files import read_dives
from clpt_control.gliders.usable_dives import usable

CTD, LEGATO, GPS = ("ctd_data_point",), ("legato_data_point",), ("gps_info",)
STEPS = ("EAST_DISPLACEMENT", "NORTH_DISPLACEMENT")
OTHER = ("GLIDER_HORZ_VELO_MODEL", "DAVG_CURR_EAST")
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


FORTNIGHTS = {"units": "fortnights since 1970-01-01"}
NOT_USED = {
    "cut at 10 %": (0.1, "cannot be read"),
    "cut at 60 %": (0.6, "cannot be read"),
    "last bytes gone": (0.999, "cannot be read"),
    "GPS2 at 0, 0": (gps(lat=(1, 0.0), lon=(1, 0.0)), "no fix before the dive"),
    "GPSE at 0, 0": (gps(lat=(2, 0.0), lon=(2, 0.0)), "no fix after the dive"),
    "GPSE is NaN": (gps(lat=(2, np.nan)), "no fix after"),
    "GPSE of last week": (gps(time=(2, times[2] - 6e5)), "swapped times"),
    "GPSE timed out": ({"log_gps_hdop": (GPS, [1, 1, 99.0], {})}, "GPSE has a hdop of 99"),
    "two fixes": (
        {f"log_gps_{k}": (("two",), [0.0, 1.0], {}) for k in ("time", "lat", "lon")},
        "2 fixes in log_gps_time",
    ),
    "no longitudes": ("log_gps_lon", "no variable log_gps_lon"),
    "times in fortnights": ({"ctd_time": (CTD, since, FORTNIGHTS)}, "'fortnights since"),
    "displacement in furlongs": (
        {"east_displacement": (CTD, steps[:, 0], {"units": "furlong"})},
        "'furlong'; must be such as 'm'",
    ),
    "displacement of another instrument": (
        {"north_displacement": (("two",), [1.0, 2.0], M)},
        "differ in length",
    ),
    "no north": ("north_displacement", "no variables east_displacement"),
    "half of the displacement": (
        {"east_displacement": (CTD, at(steps[:, 0], slice(0, 900), np.nan), M)},
        "900 of 1800 samples",
    ),
    "climb not sent": (
        {
            "ctd_time": (CTD, times[1] + since / 2, EPOCH),
            "ctd_depth": (CTD, np.linspace(0, 400, 1800), M),
        },
        "from 400 m depth on",
    ),
}


@pytest.mark.parametrize("name", NOT_USED)
def test_a_damaged_file_of_basestation3(name, tmp_path):
    damage, why = NOT_USED[name]
    basestation(tmp_path / "p1230006.nc", number=6)
    basestation3(tmp_path / "p1230008.nc", number=8)
    path = tmp_path / "p1230007.nc"
    if isinstance(damage, float):
        raw = basestation3(path).read_bytes()
        path.write_bytes(raw[: int(damage * len(raw))])
    elif isinstance(damage, str):
        basestation3(path, drop=(damage,))
    else:
        basestation3(path, sizes={"two": 2}, **damage)
    found, unread = read_dives(tmp_path)
    used, unused = usable(found)
    assert [dive.number for dive in used] == [6, 8]
    (skipped,) = unread + unused
    assert skipped.dive == 7
    assert why in skipped.why
    assert "\n" not in skipped.why


REPAIRED = {
    "no times": ({}, ("ctd_time",), "no track: no times in order with the dimension of"),
    "times descend": ({"ctd_time": (CTD, times[1] + since[::-1], EPOCH)}, (), "no times in order"),
    "time NaN": (
        {"ctd_time": (CTD, at(times[1] + since, 9, np.nan), EPOCH)},
        (),
        "no times in order",
    ),
    "flagged": ({"log_gps_qc": (GPS, [1.0, 1.0, 4.0], {})}, (), "the file flags GPSE 4"),
    "GPS2 is old": (
        gps(time=(1, times[1] - 9000)),
        (),
        "older than GPS1, which is taken as the fix before",
    ),
    "GPS1 is late": (gps(time=(0, times[1] + 700)), (), "which is left out"),
    "GPS1 at 0, 0": (gps(lat=(0, 0.0), lon=(0, 0.0)), (), ""),
    "GPS1 timed out": ({"log_gps_hdop": (GPS, [99.0, 1, 1], {})}, (), "GPS1 has a hdop of 99"),
    "no depths": ({}, ("ctd_depth", "eng_depth"), ""),
    "one step NaN": (
        {"east_displacement": (CTD, at(steps[:, 0], 700, np.nan), M)},
        (),
        "1 of 1800 samples",
    ),
}


@pytest.mark.parametrize("name", REPAIRED)
def test_what_can_be_repaired_in_basestation3(name, tmp_path):
    changed, drop, said = REPAIRED[name]
    dive = dives_in(basestation3(tmp_path / "p1230007.nc", drop=drop, **changed))[0]
    assert [one.number for one in usable([dive])[0]] == [7]
    assert said in "; ".join(dive.notes)
    assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(SWUM), rel=1e-6)
    assert (dive.track is None) == name.startswith("time") or name == "no times"
    if "GPS1" in name or "GPS2" in name:
        assert dive.t_gps1 is None
    if name == "GPS2 is old":
        assert (dive.t_gps2, dive.duration) == (times[0], DURATION + 300)


def without(columns, rows):
    """Take fixes from rows of an OG1 mission."""
    for name in ("LATITUDE_GPS", "LONGITUDE_GPS"):
        columns[name][rows] = np.nan
    return columns


def test_og1_with_fixes_at_its_ends_only(tmp_path):
    columns = og1_rows()
    rows = np.flatnonzero(np.isfinite(columns["LATITUDE_GPS"]))
    (dive,) = dives_in(og1(tmp_path / "og1.nc", columns=without(columns, rows[2:-1])))
    assert dive.notes == ("no fix between dives 1 and 3: taken as one",)
    assert (dive.t_gps2, dive.t_gpse) == (T0, T0 + 20000 + DURATION)
    assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(3 * SWUM))
    assert dive.gps_east == pytest.approx(3 * GPS_EAST)
    assert dive.dac_east is None
    assert usable([dive])[0] == [dive]


def test_og1_with_no_fix_at_all_or_one(tmp_path):
    columns = og1_rows()
    rows = np.flatnonzero(np.isfinite(columns["LATITUDE_GPS"]))
    for kept in ([], rows[:1]):
        path = og1(tmp_path / "og1.nc", columns=without(og1_rows(), np.setdiff1d(rows, kept)))
        with pytest.raises(DataError, match="no two fixes more than 600 s apart"):
            dives_in(path)
    with pytest.raises(DataError, match="no variable LONGITUDE_GPS; OG1 has the fixes there"):
        dives_in(og1(tmp_path / "og1.nc", drop=("LONGITUDE_GPS",)))
    with pytest.raises(DataError, match="no variable TIME_GPS; OG1"):
        dives_in(og1(tmp_path / "og1.nc", drop=("TIME",)))


def test_og1_fixes_that_are_none_are_left_out_and_said(tmp_path):
    columns = og1_rows()
    rows = np.flatnonzero(np.isfinite(columns["LATITUDE_GPS"]))
    columns["LATITUDE_GPS"][rows[2]] = 91.0  # GPSE of the first dive
    columns["LONGITUDE_GPS"][rows[5]] = 0.0  # GPSE of the second: 0 N 0 E
    dives = dives_in(og1(tmp_path / "og1.nc", columns=columns))
    for dive, later in zip(dives, (T0 + 9700, T0 + 19700, T0 + 29000), strict=True):
        assert dive.t_gpse == later  # the next fix: GPS1 of the dive after
        assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(SWUM))
        assert bool(dive.notes) == (dive.number < 3)
    assert dives[0].notes[0] == "1 fix(es) that are no place, 0 N 0 E or under water left out"


def test_og1_fixes_that_were_repeated_or_interpolated(tmp_path):
    columns = og1_rows()
    fix = np.isfinite(columns["LATITUDE_GPS"])
    last = np.maximum.accumulate(np.where(fix, np.arange(fix.size), 0))
    places = {name: columns[name][last] for name in ("LATITUDE_GPS", "LONGITUDE_GPS")}
    dives = dives_in(og1(tmp_path / "a.nc", columns=columns | places))
    assert [dive.number for dive in dives] == [1, 2, 3]
    for dive in dives:
        assert dive.gps_east == pytest.approx(GPS_EAST)
        assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(SWUM))
    for name in places:
        places[name] = np.interp(columns["TIME"], columns["TIME"][fix], columns[name][fix])
    deep = np.flatnonzero(columns["DEPTH"] > 20.0)
    said = f"have {deep.size} new fixes under water, the first in row {deep[0]} .* set both to NaN"
    with pytest.raises(DataError, match=said):
        dives_in(og1(tmp_path / "b.nc", columns=columns | places))


def test_og1_rows_in_any_order_and_twice(tmp_path):
    columns = {name: a[::-1] for name, a in og1_rows().items()}
    for dive in dives_in(og1(tmp_path / "a.nc", columns=columns)):
        assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(SWUM))
        assert dive.notes == ("the measurements were not in order of time, sorted",)
        assert np.all(np.diff(dive.track[0]) > 0)
    columns = {name: np.repeat(a, 2) for name, a in og1_rows().items()}
    for dive in dives_in(og1(tmp_path / "b.nc", columns=columns)):
        assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(SWUM))
        assert dive.notes == ("400 samples have the time of the one before, left out",)


def test_og1_without_a_whole_displacement_through_the_water(tmp_path):
    dives = dives_in(og1(tmp_path / "none.nc", drop=(*STEPS, *OTHER)))
    assert usable(dives)[0] == []
    assert "no EAST_DISPLACEMENT, NORTH_DISPLACEMENT, no speed" in dives[0].notes[0]
    columns = og1_rows()
    columns["EAST_DISPLACEMENT"][100:300] = np.nan
    first, *others = dives_in(og1(tmp_path / "hole.nc", columns=columns))
    assert [one.number for one in usable([first, *others])[0]] == [2, 3]
    assert first.notes[0].startswith("200 of 400 samples of the displacement are not finite")


@pytest.mark.parametrize("fill", [9999.0, -999.0, 9.97e36, np.nan])
@pytest.mark.parametrize("name", STEPS)
def test_og1_steps_that_no_vehicle_makes(name, fill, tmp_path):
    columns = og1_rows()
    columns[name][[50, 51, 300]] = fill
    first, second, _ = dives_in(og1(tmp_path / "og1.nc", columns=columns))
    note = "samples of the displacement are not finite or above 5 m/s, filled from their neighbours"
    assert [dive.notes != () for dive in (first, second)] == [True, False]
    assert first.notes[0].startswith(f"3 of 400 {note}")
    assert (first.dr_east, first.dr_north) == pytest.approx(tuple(SWUM))
    columns[name][60:90] = fill
    first = dives_in(og1(tmp_path / "more.nc", columns=columns))[0]
    assert not usable([first])[0]
    assert first.notes[0].startswith("33 of 400 ")


def test_og1_rows_of_other_instruments_have_no_step(tmp_path):
    """A step after them covers their time too: the sum is whole, and nothing is filled."""
    columns = og1_rows()
    for step in STEPS:
        rows = np.arange(20, 180, 4)
        columns[step][rows + 1] += columns[step][rows]
        columns[step][rows] = np.nan
    for dive in dives_in(og1(tmp_path / "og1.nc", columns=columns)):
        assert (dive.dr_east, dive.dr_north) == pytest.approx(tuple(SWUM))
        assert dive.notes == ()


@pytest.mark.parametrize(
    ("name", "units"),
    [
        ("TIME", "fortnights since 1970-01-01"),
        ("TIME", "seconds since the start"),
        ("GLIDER_HORZ_VELO_MODEL", "furlong"),
        ("DEPTH", "dbar"),
    ],
)
def test_og1_units_that_are_none(name, units, tmp_path):
    with pytest.raises(DataError, match=f"{name}.*'{units}'.*must be such as"):
        dives_in(og1(tmp_path / "og1.nc", units={name: {"units": units}}))
