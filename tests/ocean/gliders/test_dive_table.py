"""Tables of dives as others write them, what is no file, and which dives are used."""

import os
import random
import re
import tempfile
from dataclasses import MISSING, fields, replace
from math import inf
from pathlib import Path

import netCDF4
import numpy as np
import pytest
from glider_files import basestation, dives_in, error_of, og1, og1_rows
from paths import ROOT
from refusals import refuses

from clpt_control.gliders import (
    Dive,
    make_dive,
    read_dives,
    sample_dives,
    write_dive_table,
)
from clpt_control.replay import replay_dives

HEAD = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,dr_north_m\n"
ROW = "{},{},-43,8,{},-43,8.1,8000,0\n"


def usable(dives):
    """Return which of these dives are used once they are read from a table, and the others."""
    with tempfile.TemporaryDirectory() as folder:
        write_dive_table(dives, path := Path(folder) / "dives.csv")
        return read_dives(path)


def test_most_dives_too_fast_are_a_wrong_unit(tmp_path):
    """Of 40 dives with currents of 10 to 30 cm/s, written without the unit."""
    head = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dac_east,dac_north\n"
    row = "{},{},-43,8,{},-43,8.02,{},5\n"
    rows = [
        row.format(k, 1e9 + 10000 * k, 1e9 + 9000 + 10000 * k, 10 + k % 20)
        for k in range(40)
    ]
    (tmp_path / "dives.csv").write_text(head + "".join(rows))
    said = "40 of 40 legs move more than 5 m/s .* dac_east, dac_north, m/s, not cm/s"
    refuses(said, read_dives, tmp_path / "dives.csv")


@pytest.fixture
def table(tmp_path):
    write_dive_table(sample_dives(), tmp_path / "dives.csv")
    return tmp_path / "dives.csv"


def test_tables_of_other_kinds_are_told_what_to_change(table):
    text = table.read_text()
    for content, sentence in (
        (text.replace("dac_qc,", "dive,"), "the column dive appears twice"),
        (text.replace("gps_", "vehicle,"), "the column vehicle appears"),
        (text.upper(), "no column dive, .* begins with dive,"),
        (
            text.replace("dac_east", "dac_east (cm/s)"),
            r"dac_east \(cm/s\): a table of dives has s, degrees, m and m/s",
        ),
        (
            text.replace("dr_east_m", "DR_east_m"),
            "no column dr_east_m; has dive, .*DR_east_m",
        ),
    ):
        table.write_text(content)
        refuses(f"dives.csv: {sentence}", read_dives, table)
    table.write_text(text, encoding="utf-16-le")  # without a byte order mark
    refuses("dives.csv: is neither NetCDF nor text", read_dives, table)


def test_other_marks_and_utf_16_are_read(table):
    text = table.read_text()
    for content, encoding in (
        (text.replace(",", "\t"), "utf-8"),
        ("sep=;\n" + text.replace(",", ";").replace(".", ","), "utf-8"),
        (text, "utf-16"),
    ):
        table.write_text(content, encoding=encoding)
        assert read_dives(table)[0] == sample_dives()


ODD = [
    (("7.5", 0, 9000), "dive is '7.5'; must be a whole number below 2147483648"),
    (("-inf", 0, 9000), "dive is '-inf'"),
    (("2147483648", 0, 9000), "dive is '2147483648'"),
    (
        (1, "2020-13-01T00:00:00Z", 9000),
        "t_gps2 is .* or a date such as 2016-01-31T22:04:50Z",
    ),
    ((1, "noon", 9000), "t_gps2 is 'noon'; must be seconds since 1970 UTC, or a date"),
]


@pytest.mark.parametrize(("cells", "sentence"), ODD)
def test_odd_numbers_and_times_are_skipped_one_by_one(tmp_path, cells, sentence):
    path = tmp_path / "dives.csv"
    path.write_text(HEAD + ROW.format(*cells) + ROW.format(2147483647, 10000, 19000))
    (dive,), (skipped,) = read_dives(path)
    assert dive.number == 2147483647
    assert re.search(sentence, skipped.why)
    path.write_text(HEAD + 2 * ROW.format(*cells))
    refuses(r"no dive. First reason:.*line 2", read_dives, path)


def test_times_are_seconds_or_dates_and_required_columns_suffice(tmp_path):
    head = "dr_north_m,dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,extra\n"
    row = "5,1,2020-09-13T12:26:40Z,-43,8,2020-09-13 16:56:40+02:00,-43,8.1,8000,word\n"
    (tmp_path / "mine.csv").write_text(head + row)
    ((dive,), _) = read_dives(tmp_path, usable=False)
    assert (dive.t_gps2, dive.duration, dive.magvar, dive.track) == (
        1.6e9,
        9000.0,
        None,
        None,
    )
    assert (dive.dr_east, dive.dr_north, dive.gps_east) == (
        8000,
        5,
        pytest.approx(8154, abs=1),
    )


def test_lines_of_a_table_are_skipped_one_by_one(table):
    lines = table.read_bytes().splitlines()[:6]
    columns = lines[0].count(b",") + 1
    lines[2] = b"x" + lines[2]
    lines[3] = lines[3].replace(b"-43", b"\xb1", 1)
    lines[4] = lines[4][:30]
    table.write_bytes(b"\n".join(lines))
    used, skipped = read_dives(table)
    assert [dive.number for dive in used] == [304, 308]
    assert [one.dive for one in skipped] == [None, 306, 307]
    assert "line 3: dive is 'x305'" in skipped[0].why
    assert "lat_gps2 is '\ufffd" in skipped[1].why
    assert f"line 5: has 3 cells, the header {columns}" in skipped[2].why


def test_a_current_stands_in_place_of_dead_reckoning(tmp_path):
    """What miss over duration of the dives themselves is gives back their dead reckoning."""
    dives, names = (
        sample_dives(),
        "number t_gps2 lat_gps2 lon_gps2 t_gpse lat_gpse lon_gpse",
    )
    rows = [[getattr(dive, name) for name in names.split()] for dive in dives]
    for row, dive in zip(rows, dives, strict=True):
        row += [dive.miss_east / dive.duration, dive.miss_north / dive.duration]
    rows.append([400, *rows[0][1:-1], ""])
    head = HEAD.replace("dr_east_m,dr_north_m", "dac_east,dac_north")
    lines = [",".join(map(str, row)) + "\n" for row in rows]
    (tmp_path / "own.csv").write_text(head + "".join(lines))
    found, skipped = read_dives(tmp_path / "own.csv", usable=False)
    assert skipped == []
    for dive, same in zip(found[:-1], dives, strict=True):
        assert (dive.dr_east, dive.dr_north) == pytest.approx(
            (same.dr_east, same.dr_north)
        )
        assert dive.notes == ("dead reckoning computed from dac_east, dac_north",)
    assert (
        "dac_east or dac_north is not a number"
        in read_dives(tmp_path / "own.csv")[1][-1].why
    )
    for flag in ("4", "bad", "QC_BAD"):
        flagged = [f"{line.rstrip()},{flag}\n" for line in lines[:-1]]
        head = HEAD.replace("dr_east_m,dr_north_m", "dac_east,dac_north,dac_qc")
        (tmp_path / "own.csv").write_text(head + "".join(flagged))
        used, left_out = read_dives(tmp_path / "own.csv")
        assert not used
        assert all("dac_qc is bad" in skipped.why for skipped in left_out)
    (tmp_path / "none.csv").write_text(HEAD.replace(",dr_east_m,dr_north_m", ""))
    said = "no column dr_east_m, dr_north_m; .* may stand instead"
    refuses(said, read_dives, tmp_path / "none.csv")


CURRENTS = [
    ("swapped", lambda current: current[::-1]),
    ("cm/s", lambda current: 100 * current),
    ("mm/s", lambda current: 1000 * current),
    ("reversed in sign", lambda current: -current),
    ("", lambda current: current + np.array([0.1, -0.3])),
]


@pytest.mark.parametrize(("cause", "change"), CURRENTS)
def test_a_current_that_contradicts_dead_reckoning_is_refused(tmp_path, cause, change):
    path = tmp_path / "dives.csv"

    def with_current(dive, change):
        east, north = change(error_of(dive)[0] / dive.duration)
        return replace(dive, dac_east=float(east), dac_north=float(north))

    dives = [with_current(dive, lambda current: current) for dive in sample_dives()]
    write_dive_table([with_current(dives[0], change), *dives[1:]], path)
    found, skipped = read_dives(path, usable=False)  # one may have a wild fix
    noted = [any("depth-averaged" in note for note in dive.notes) for dive in found]
    assert (noted, skipped) == ([True] + [False] * 13, [])
    write_dive_table([with_current(dive, change) for dive in dives], path)
    said = refuses("contradict dac_east, dac_north by .* mm/s in", read_dives, path)
    assert f"{cause}. Correct one pair, or leave the wrong columns out" in said


def test_angles_that_are_none_are_left_out_and_said(tmp_path):
    path = tmp_path / "dives.csv"
    row = ROW.format(1, 0, 9000)[:-1]
    path.write_text(f"{HEAD[:-1]},magvar,next_course\n{row},-999,9.97e36\n")
    (dive,) = dives_in(path)
    assert (dive.magvar, dive.next_course) == (None, None)
    assert dive.notes == ()
    path.write_text(f"{HEAD[:-1]},magvar,next_course\n{row},-998,1e9\n")
    (dive,) = dives_in(path)
    assert (dive.magvar, dive.next_course) == (None, None)
    assert "magvar is -998; must be -180 to 180 degrees" in dive.notes[0]
    assert "next_course is 1e+09; must be -180 to 540" in dive.notes[1]


@pytest.mark.parametrize(
    ("course", "said"),
    [
        ("720", "course is 720; must be -180 to 540 degrees"),
        ("inf", "course is inf; must be -180 to 540 degrees"),
        ("north", "course is 'north'; must be a number"),
    ],
)
def test_a_wrong_course_costs_its_line(tmp_path, course, said):
    """In a table of dives, and in a log; courses of the other lines are east at 1 m/s."""
    head = HEAD.replace("dr_east_m,dr_north_m", "course,speed")
    rows = [f"{k},{9000 * k},-43,8,{9000 * k + 8000},-43,8.1," for k in (1, 2, 3)]
    courses = ("90", course, "90")
    lines = [f"{row}{own},1" for row, own in zip(rows, courses, strict=True)]
    (tmp_path / "dives.csv").write_text(head + "\n".join(lines))
    dives, (skipped,) = read_dives(tmp_path / "dives.csv", usable=False)
    assert [dive.number for dive in dives] == [1, 3]
    assert [dive.dr_east for dive in dives] == pytest.approx([8000.0, 8000.0])
    assert f"line 3: {said}" in skipped.why
    rows = [f"{9000 * k},-43,{8 + 0.1 * k},90,1" for k in range(9)]
    rows[4] = rows[4].replace("90,1", f"{course},1")
    head = "time,latitude,longitude,course,speed\n"
    (tmp_path / "log.csv").write_text(head + "\n".join(rows))
    legs, (skipped,) = read_dives(tmp_path / "log.csv", usable=False)
    assert f"line 6: {said}" in skipped.why
    known = [leg.dr_east for leg in legs if not np.isnan(leg.dr_east)]
    assert known == pytest.approx(6 * [9000.0])


def test_displacements_of_a_log_have_units(tmp_path):
    rows = [f"{9000 * k},-43,{8 + 0.1 * k},8,-0.5" for k in range(3)]
    head = "time,latitude,longitude,dr_east_m (km),dr_north_m (km)\n"
    (tmp_path / "log.csv").write_text(head + "\n".join(rows))
    legs = dives_in(tmp_path / "log.csv")
    assert [leg.through_water for leg in legs] == 2 * [(8000.0, -500.0)]
    (tmp_path / "log.csv").write_text(head.replace("km", "s") + rows[0])
    said = "dr_east_m has units 's'; use a unit such as 'm', 'km'"
    refuses(said, read_dives, tmp_path / "log.csv")


def test_quotes_join_cells_and_never_lines(tmp_path):
    head = HEAD.replace("\n", ",note\n")
    cells = (
        ROW.format(n, 9000 * n, 9000 * n + 8000).replace("\n", ",")
        for n in (1, 2, 3, 4)
    )
    notes = ('"rain, wind"', 'a 5" pipe', '"never closed', '"it ""rolled"""')
    rows = "".join(f"{row}{note}\n" for row, note in zip(cells, notes, strict=True))
    (tmp_path / "d.csv").write_text(head + rows)
    dives, skipped = read_dives(tmp_path / "d.csv", usable=False)
    assert [dive.number for dive in dives] == [1, 2, 4]
    assert ["line 4: has 1 cell, the header" in one.why for one in skipped] == [True]


def test_dive_numbers_of_netcdf_files(tmp_path):
    path = basestation(tmp_path / "p1230007.nc")
    for number in (7.5, 1e10, "seven"):
        with netCDF4.Dataset(path, "a") as data:
            data.dive_number = number
        assert dives_in(path)[0].number == 7
    path = path.rename(tmp_path / "other.nc")
    refuses("other.nc: neither dive_number nor log_DIVE is a", read_dives, path)
    _, (skipped,) = read_dives(og1(tmp_path / "og1.nc", columns=og1_rows([1e12])))
    assert "its number is 1e+12; must be a whole number" in skipped.why


def test_what_is_no_file_is_refused_at_once(tmp_path, monkeypatch):
    os.mkfifo(tmp_path / "fifo.csv")
    (tmp_path / "dives.csv").touch()
    for path, sentence in (
        (tmp_path / "fifo.csv", "is not a regular file. Give a file"),
        ("/dev/zero", "is not a regular file. Give a file"),
        (tmp_path / "dives.csv" / "x.csv", "no such file"),
        (tmp_path / ("x" * 300), "cannot be read: File name too long"),
    ):
        refuses(sentence, read_dives, path)
    write_dive_table(sample_dives(), tmp_path / "dives.csv")
    (tmp_path / "folder.nc").mkdir()
    found, skipped = read_dives(tmp_path, usable=False)
    assert len(found) == 14
    why = ["is not a regular file. Give a file", "is a folder. Give a file"]
    assert [one.why.split(": ")[1] for one in skipped] == why

    def closed(path, *_, **__):
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "stat", closed)
    monkeypatch.setattr(os, "open", closed)
    closed_file = tmp_path / "closed" / "a.csv"
    refuses("a.csv: cannot be read: Permission denied", read_dives, closed_file)


BASE = make_dive(10, (1e6, -43.0, 8.0), (1.01e6, -43.0, 8.02), (1000.0, 50.0))


def later(number, **changes):
    """A dive like it, 11000 s later for each number."""
    ends = {
        name: getattr(BASE, name) + (number - 10) * 11000.0
        for name in ("t_gps2", "t_gpse")
    }
    return replace(BASE, number=number, **ends | changes)


WEEKS = 1024 * 7 * 86400.0  # s


DEGREES = "degrees and minutes. Give decimal degrees, 51.684133 -128.300300"


NOT_USED = [
    ({"lon_gpse": inf}, "no fix after"),
    ({"lat_gps2": 9.97e36}, "no fix before"),
    ({"lat_gpse": 0.0, "lon_gpse": 0.0}, "no fix after"),
    (
        {"lat_gpse": 92.0},
        "latitude 92, longitude 8.02: latitude must be from -90 to 90. Are latitude and lon",
    ),
    (
        {"lon_gpse": 408.0, "t_gpse": 1462105201.0},
        "no fix after the dive (time 2016-05-01T12:20:01Z, latitude",
    ),
    ({"t_gpse": BASE.t_gps2}, "swapped"),
    ({"dr_north": -inf}, "not finite"),
    ({"t_gpse": BASE.t_gps2 + 1000}, "lasts 1000 s; must last longer than 1000 s"),
    ({"lat_gps2": 5141.048, "lon_gps2": -12818.018}, DEGREES),
    ({"lat_gpse": -4304.5, "lon_gpse": 829.4}, "decimal degrees, -43.075000 8.490000"),
    (
        {"t_gps2": -1.0},
        "before the dive is at -1 s since 1970; must be from 1970 to 2200",
    ),
    ({"t_gps2": -1e18, "t_gpse": 1e18}, "from 1970 to 2200"),
    ({"t_gpse": 1e18}, "after the dive is at 1e+18 s since 1970; must"),
    ({"t_gps2": 18518.5, "t_gpse": 18518.65}, "look like days since 1970; must be"),
    ({"t_gps2": 444444.5, "t_gpse": 444448.0}, "look like hours since 1970; must be"),
    ({"t_gps2": 9.5e8, "t_gpse": 9.5e8 + 9.0}, "lasts 9 s; must last longer"),
    ({"t_gps2": BASE.t_gps2 + WEEKS}, "is 1024 weeks before its start: add 1024 weeks"),
    ({"dr_east": -9999.0, "dr_north": -9999.0}, "is not finite"),
    ({"dr_east": 9999.0, "dr_north": 9999.0}, "is 9999 m twice, a fill value"),
    (
        {"number": 2**31},
        "dive is '2147483648'; must be a whole number below 2147483648",
    ),
    ({"number": -(10**300)}, "must be a whole number below 2147483648"),
    ({"lat_gpse": -34.0}, "between the fixes is 999.1 km, 99.9 m/s; at most 5 m/s"),
    ({"dr_east": 1e6}, "m/s"),
]


@pytest.mark.parametrize("early", [range(10, 14), range(14, 20), range(12, 14)])
def test_dates_1024_weeks_early_are_refused_with_the_remedy(early):
    dives = []
    for number in range(10, 20):
        dive = later(number)
        late = 0.0 if number in early else WEEKS
        dives.append(
            replace(dive, t_gps2=dive.t_gps2 + late, t_gpse=dive.t_gpse + late)
        )
    refuses("about 1024 weeks apart.* add 1024 weeks, 619315200 s", usable, dives)
    far = [
        replace(dive, lat_gps2=40.0, lat_gpse=40.0) if dive.number in early else dive
        for dive in dives
    ]
    assert len(usable(far)[0]) > 0  # another sea, another mission


def test_a_fix_that_is_repeated_over_two_dives_starts_neither():
    stale = replace(BASE, lon_gpse=BASE.lon_gps2)
    used, skipped = usable(
        [later(9), stale, later(11), later(12, lon_gps2=8.02, lon_gpse=8.04)]
    )
    assert [dive.number for dive in used] == [9, 12]
    assert [one.why[:15] for one in skipped] == ["no fix after th", "no fix before t"]


@pytest.mark.parametrize(("changes", "why"), NOT_USED)
def test_a_dive_is_refused_with_its_reason(changes, why):
    used, skipped = usable([later(9), replace(BASE, **changes), later(11)])
    assert [dive.number for dive in used] == [9, 11]
    assert [one.dive for one in skipped] == [None if "number" in changes else 10]
    assert why in skipped[0].why


def test_duplicates_overlaps_order_and_gaps_are_said():
    used, skipped = usable([later(12), later(10), later(12), later(16)])
    assert [dive.number for dive in used] == [10, 12, 16]
    assert [(one.dive, one.why[:9]) for one in skipped] == [(12, "duplicate")]
    assert "sorted by time" in used[0].notes[0]
    assert "3 dive(s) missing after dive 12" in used[2].notes
    long = later(11, t_gpse=later(14).t_gpse)
    used, skipped = usable([later(10), long, later(12), later(13)])
    assert [dive.number for dive in used] == [10, 12, 13]
    assert "overlaps dive 13" in skipped[0].why


def at(number, lat, hours=0.0, **more):
    """A dive 1000 s after the one before it, or more; the meridian to 40 N is 4429.5 km."""
    dive, late = (
        later(number, **{"lat_gps2": lat, "lat_gpse": lat} | more),
        3600.0 * hours,
    )
    return replace(dive, t_gps2=dive.t_gps2 + late, t_gpse=dive.t_gpse + late)


def numbers(dives):
    used, skipped = usable(dives)
    return [dive.number for dive in used], [one.dive for one in skipped]


def test_two_vehicles_are_refused_with_both_names():
    names = ("SG1", "sg-1", None, "rosie", "rosie")
    dives = [later(10 + k, vehicle=name) for k, name in enumerate(names)]
    assert len(usable(dives[:3])[0]) == 3
    for given in (dives, dives[::-1]):
        refuses(
            "are 2 vehicles in one replay. Give .*clpt watch FOLDER --fleet",
            usable,
            given,
        )
    refuses("^rosie, sg-1: ", usable, dives)


def test_a_folder_of_two_vehicles_is_refused_and_a_fleet_is_not(tmp_path, refused):
    for name in ("unit_1", "unit_2"):
        rows = [HEAD.strip() + ",vehicle"]
        rows += [
            ROW.format(k, 1e4 * k, 1e4 * k + 9e3)[:-1] + f",{name}" for k in (1, 2)
        ]
        (tmp_path / f"{name}.csv").write_text("\n".join(rows) + "\n")
    error = refused("replay", str(tmp_path))
    assert "unit_1, unit_2: are 2 vehicles in one replay" in error


def test_two_vehicles_in_one_input_are_not_mixed():
    ours, theirs = (
        [at(k, 40.0) for k in (10, 12, 14)],
        [at(k, -40.0) for k in (11, 13, 15)],
    )
    assert numbers([*ours, *theirs]) == ([10, 12, 14], [11, 13, 15])
    _, skipped = usable([*ours, *theirs])
    why = "starts 8859 km from where dive 10 ended 0.3 h before; another vehicle? replay each on "
    assert skipped[0].why == f"{why}its own"


NEXT = [
    (at(11, 40.04), [10, 11]),  # 4.4 km in 1000 s
    (at(11, 40.5), [10]),  # 56 km
    (at(11, 41.0, hours=6.0), [11]),  # 111 km at 4.9 m/s: another record
    (at(11, 41.0, hours=5.0), [10]),
    (at(11, -40.0, hours=720.0), [11]),  # shipped: another record
    (at(11, 40.0, lon_gps2=-179.99, lon_gpse=-179.98), [10, 11]),
]


@pytest.mark.parametrize(("second", "used"), NEXT)
def test_what_can_be_reached_is_not_refused(second, used):
    more = {"lon_gps2": 179.99, "lon_gpse": 180.01} if second.lon_gps2 < 0 else {}
    first = at(10, 40.0, **more)
    assert numbers([first, second])[0] == used


def test_one_wrong_fix_costs_one_dive_at_most():
    astray = at(11, 40.0, lat_gpse=40.45)  # 50 km in 10000 s: possible
    far = [
        replace(dive, t_gps2=dive.t_gps2 - 900.0)
        for dive in (at(12, 39.95), at(13, 39.95))
    ]
    assert numbers([at(10, 40.0), astray, *far]) == ([10, 11, 12, 13], [])
    start = at(11, 40.0, lat_gps2=40.47, lat_gpse=40.02)  # a wrong start
    assert numbers([at(10, 40.0), start, at(12, 40.0)]) == ([10, 12], [11])
    again = [at(10, 40.0), at(11, -40.0), at(11, -40.0)]
    assert numbers(again) == ([10], [11, 11])


def overlapping():
    rng = np.random.default_rng(1)
    times = zip(rng.uniform(0, 3e5, 40), rng.uniform(5e3, 3e4, 40), strict=True)
    pool = [
        replace(BASE, number=k, t_gps2=t, t_gpse=t + d)
        for k, (t, d) in enumerate(times)
    ]
    return sorted(pool, key=lambda dive: dive.t_gpse)


def apart():
    rng = random.Random(2)
    return [at(10 + k, rng.choice([40.0, 40.0, 41.0, -40.0])) for k in range(60)]


@pytest.mark.sampled
@pytest.mark.parametrize("pool", [overlapping(), apart()], ids=["in time", "in place"])
def test_no_choice_looks_ahead(pool):
    whole = numbers(pool)[0]
    assert 0 < len(whole) < len(pool)
    last = []
    for count in range(1, len(pool) + 1):
        last += numbers(pool[:count])[0][-1:]
    arrived = list(dict.fromkeys(last))
    assert whole == arrived[-len(whole) :]  # the last record, as its dives arrived


def test_the_order_of_files_does_not_choose_between_copies():
    dives = [later(k) for k in range(10, 16)]
    slower = [
        replace(dive, dr_east=dive.dr_east - 300, dr_north=450.0) for dive in dives
    ]
    moved = [replace(dive, lat_gpse=-43.01) for dive in dives]
    renamed = [replace(dive, number=99) for dive in dives]
    pool = [*dives, *slower, *moved, *renamed, *dives]
    whys = set()
    for seed in range(20):
        random.Random(seed).shuffle(pool)
        used, skipped = usable(pool)
        assert used == slower  # the least of number, then displacement
        assert len(skipped) == 24
        whys |= {one.why for one in skipped if "of dive 12" in one.why}
    assert whys == {"duplicate of dive 12, which is used"}


def test_a_written_table_keeps_the_vehicle_and_its_kind(tmp_path):
    """Also a name with a comma and quotation marks."""
    named = [
        replace(dive, vehicle='SG 5,4"2"', kind="Seaglider") for dive in sample_dives()
    ]
    write_dive_table(named, tmp_path / "dives.csv")
    dives, _ = read_dives(tmp_path / "dives.csv")
    assert {dive.kind for dive in dives} == {"Seaglider"}
    assert {dive.vehicle for dive in dives} == {named[0].vehicle}


NOT_IN_A_TABLE = {"track", "notes"}  # as the docstring of `write_dive_table` says
OPTIONAL = [
    field.name
    for field in fields(Dive)
    if field.name not in NOT_IN_A_TABLE and field.default is not MISSING
]


def changed(dive, name):
    """Return a dive with another value of an optional field."""
    value = getattr(dive, name)
    if name in ("vehicle", "kind", "uncovered"):
        return replace(dive, **{name: 'a "word", or two'})
    own = dict(zip(("dac_east", "dac_north"), error_of(dive)[0], strict=True))
    if name in own:  # that does not contradict the dead reckoning
        return replace(dive, **{name: own[name] / dive.duration})
    return replace(dive, **{name: 12.5 if value is None else value + 0.25})


def test_each_field_of_a_dive_is_in_a_table_and_documented(tmp_path):
    """A changed field is read as it was written; pages and docstring name the field."""
    page = (ROOT / "docs" / "gliders.md").read_text("utf-8")
    for name in OPTIONAL:
        dive = changed(sample_dives()[0], name)
        write_dive_table([dive], tmp_path / "dives.csv")
        (found,), _ = read_dives(tmp_path / "dives.csv")
        assert getattr(found, name) == getattr(dive, name), name
        assert re.search(rf"[`,]{name}[`,]", page), f"docs/gliders.md: no {name}"
        assert re.search(rf"\b{name}\b.* :", Dive.__doc__), f"Dive: no {name}"


def test_a_field_of_a_dive_is_in_results_with_its_unit():
    """The magnetic variation of the file is in JSON and NetCDF; the vehicle is said once."""
    dives = [
        replace(dive, turned=-25.0, doubt=30.0, vehicle="SG542")
        for dive in sample_dives()[:3]
    ]
    replay = replay_dives(dives)
    row = replay.summary()["each_dive"][1]
    assert (row["turned"], row["doubt"], row["magvar"]) == (-25.0, 30.0, -25.0)
    assert "vehicle" not in row
    data = replay.dataset()
    assert data.turned.values.tolist() == [-25.0] * 3
    assert (data.turned.units, data.doubt.units) == ("degrees", "m")
    assert data.first_fix_time.units == "seconds since 1970-01-01 00:00:00 UTC"


def test_numbers_outside_of_the_limits_of_a_field_are_gaps(tmp_path):
    path = tmp_path / "dives.csv"
    row = ROW.format(1, 0, 9000)[:-1]
    path.write_text(f"{HEAD[:-1]},turned,doubt,vehicle\n{row},200,-3,-oX\n")
    (dive,) = dives_in(path)
    assert (dive.turned, dive.doubt, dive.vehicle) == (None, 0.0, None)
    for part in ("turned is 200; must be", "doubt is -3; must be", "vehicle is '-oX'"):
        assert any(part in note for note in dive.notes), part
