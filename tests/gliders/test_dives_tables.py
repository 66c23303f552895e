"""Tables of dives as others write them, and what is no file at all."""

import os
import re
from pathlib import Path

import netCDF4
import pytest
from glider_dialects import basestation, dives_in, og1, og1_rows

from clpt_control.errors import DataError
from clpt_control.files import reading
from clpt_control.gliders.dive_files import dive_paths, read_dive_file, read_dives, sample_dives
from clpt_control.gliders.dive_table import write_dive_table
from clpt_control.gliders.usable_dives import usable

HEAD = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,dr_north_m\n"
ROW = "{},{},-43,8,{},-43,8.1,8000,0\n"


@pytest.fixture
def table(tmp_path):
    write_dive_table(sample_dives(), tmp_path / "dives.csv")
    return tmp_path / "dives.csv"


@pytest.mark.parametrize(
    ("change", "encoding", "sentence"),
    [
        (lambda text: text.replace(",", ";"), "utf-8", "columns are separated by semicolons; use"),
        (lambda text: text.replace(",", "\t"), "utf-8", "columns are separated by tabs; use"),
        (lambda text: text.replace("dac_qc,", "dive,"), "utf-8", "the column dive stands there tw"),
        (str.upper, "utf-8", "no column dive, .* begins with dive,"),
        (
            lambda text: text.replace("dr_east_m", "DR_east_m"),
            "utf-8",
            "no column dr_east_m; has dive, .*DR_east_m",
        ),
        (str, "utf-16", "is neither NetCDF nor text"),
    ],
)
def test_tables_of_other_kinds_are_told_what_to_change(table, change, encoding, sentence):
    table.write_text(change(table.read_text()), encoding=encoding)
    with pytest.raises(DataError, match=rf"dives.csv: {sentence}"):
        read_dives(table)


@pytest.mark.parametrize(
    ("cells", "sentence"),
    [
        (("7.5", 0, 9000), "dive is '7.5'; must be a whole number below 2147483648"),
        (("-inf", 0, 9000), "dive is '-inf'"),
        (("2147483648", 0, 9000), "dive is '2147483648'"),
        ((1, "2020-13-01T00:00:00Z", 9000), "t_gps2 is .* or a date such as 2016-01-31T22:04:50Z"),
        ((1, "noon", 9000), "t_gps2 is 'noon'; must be seconds since 1970 UTC, or a date"),
    ],
)
def test_odd_numbers_and_times_are_skipped_one_by_one(tmp_path, cells, sentence):
    path = tmp_path / "dives.csv"
    path.write_text(HEAD + ROW.format(*cells) + ROW.format(2147483647, 10000, 19000))
    (dive,), (skipped,) = read_dives(path)
    assert (dive.number, usable([dive])[0]) == (2147483647, [dive])
    assert re.search(sentence, skipped.why)
    path.write_text(HEAD + 2 * ROW.format(*cells))
    with pytest.raises(DataError, match=r"dives.csv: no dive; the first reason: .*line 2"):
        read_dives(path)


def test_times_are_seconds_or_dates(tmp_path):
    times = ("2020-09-13T12:26:40Z", "2020-09-13 16:56:40+02:00")
    (tmp_path / "0.csv").write_text(HEAD + ROW.format(1, *times))
    ((dive,), _) = read_dives(tmp_path)
    assert (dive.t_gps2, dive.duration) == (1.6e9, 9000.0)


def test_lines_of_a_table_are_skipped_one_by_one(table):
    lines = table.read_text().splitlines()[:6]
    lines[2] = "x" + lines[2]
    lines[3] = lines[3].replace("-43", "south", 1)
    lines[4] = lines[4][:30]
    table.write_bytes("\n".join(lines).encode().replace(b"south", b"\xb0"))
    found, skipped = read_dive_file(table)
    used, unused = usable(found)
    assert [dive.number for dive in used] == [304, 308]
    assert [one.dive for one in skipped + unused] == [None, 306, 307]
    assert "line 3: dive is 'x305'" in skipped[0].why
    assert "lat_gps2 is '\ufffd" in skipped[1].why
    assert "no fix before" in unused[0].why


def test_a_current_stands_in_place_of_dead_reckoning(table, tmp_path):
    """What miss over duration of the dives themselves is gives back their dead reckoning."""
    dives = sample_dives()
    head = HEAD.replace("dr_east_m,dr_north_m", "dac_east,dac_north")
    rows = [
        f"{d.number},{d.t_gps2!r},{d.lat_gps2!r},{d.lon_gps2!r},{d.t_gpse!r},{d.lat_gpse!r},"
        f"{d.lon_gpse!r},{d.miss_east / d.duration!r},{d.miss_north / d.duration!r}\n"
        for d in dives
    ]
    rows.append(rows[0].replace(f"{dives[0].number},", "400,", 1).rsplit(",", 1)[0] + ",\n")
    (tmp_path / "own.csv").write_text(head + "".join(rows))
    found, skipped = read_dives(tmp_path / "own.csv")
    assert skipped == []
    for dive, same in zip(found[:-1], dives, strict=True):
        assert (dive.dr_east, dive.dr_north) == pytest.approx((same.dr_east, same.dr_north))
        assert dive.notes == ("dead reckoning computed from dac_east, dac_north",)
    assert "dac_east or dac_north is no number" in usable(found)[1][-1].why
    (tmp_path / "none.csv").write_text(HEAD.replace(",dr_east_m,dr_north_m", ""))
    with pytest.raises(DataError, match=r"no column dr_east_m, dr_north_m; .* may stand instead"):
        read_dives(tmp_path / "none.csv")


def test_quotes_join_cells_and_never_lines(tmp_path):
    head = HEAD.replace("\n", ",note\n")
    cells = (ROW.format(n, 9000 * n, 9000 * n + 8000).replace("\n", ",") for n in (1, 2, 3, 4))
    notes = ('"rain, wind"', 'a 5" pipe', '"never closed', '"it ""rolled"""')
    rows = "".join(f"{row}{note}\n" for row, note in zip(cells, notes, strict=True))
    (tmp_path / "d.csv").write_text(head + rows)
    dives, skipped = read_dives(tmp_path / "d.csv")
    assert [dive.number for dive in dives] == [1, 2, 4]
    (why,) = skipped
    assert "line 4: dive is" in why.why


def test_dive_numbers_of_netcdf_files(tmp_path):
    path = basestation(tmp_path / "p1230007.nc")
    for number in (7.5, 1e10, "seven"):
        with netCDF4.Dataset(path, "a") as data:
            data.dive_number = number
        assert dives_in(path)[0].number == 7
    path = path.rename(tmp_path / "other.nc")
    with pytest.raises(DataError, match=r"other.nc: neither dive_number nor log_DIVE is a"):
        dives_in(path)[0]
    columns = og1_rows()
    columns["divenum"] = columns["divenum"] + 1e12
    used, skipped = usable(read_dive_file(og1(tmp_path / "og1.nc", columns=columns))[0])
    assert not used
    assert "its number is 1e+12; must be a whole number" in skipped[0].why


def test_what_is_no_file_is_refused_at_once(tmp_path, monkeypatch):
    os.mkfifo(tmp_path / "fifo.csv")
    (tmp_path / "dives.csv").touch()
    for path, sentence in (
        (tmp_path / "fifo.csv", "is no regular file; give one"),
        ("/dev/zero", "is no regular file; give one"),
        (tmp_path / "dives.csv" / "x.csv", "no such file"),
        (tmp_path / ("x" * 300), "cannot be read: File name too long"),
    ):
        with pytest.raises(DataError, match=sentence):
            read_dives(path)
    write_dive_table(sample_dives(), tmp_path / "dives.csv")
    (tmp_path / "folder.nc").mkdir()
    found, skipped = read_dives(tmp_path)
    assert len(found) == 14
    why = ["is no regular file; give one", "is a folder; give a file"]
    assert [one.why.split(": ")[1] for one in skipped] == why

    def closed(path, *_, **__):
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "stat", closed)
    monkeypatch.setattr(reading.os, "open", closed)
    for read in (lambda path: dive_paths([path]), read_dive_file):
        with pytest.raises(DataError, match=r"a.csv: cannot be read: Permission denied"):
            read(tmp_path / "closed" / "a.csv")
