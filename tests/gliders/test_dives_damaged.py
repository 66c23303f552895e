"""Thirty damaged files among good ones: named, and the good dives still used."""

from math import inf, nan
from pathlib import Path

import netCDF4
import numpy as np
import pytest
from glider_dialects import dives_in

from clpt_control.errors import DataError
from clpt_control.gliders.dive_files import read_dive_file, read_dives, sample_dives
from clpt_control.gliders.dive_table import write_dive_table
from clpt_control.gliders.usable_dives import usable


@pytest.fixture(scope="module")
def folder(facts):
    return facts / "glider" / "basestation"


GOOD = (304, 305, 307)


def small(source, target, change=lambda data: None, drop=()):
    """Write the few variables of a dive that are read, changed."""
    names = [
        "log_gps_time",
        "log_gps_lat",
        "log_gps_lon",
        "time",
        "east_displacement",
        "north_displacement",
        "east_displacement_gsm",
        "north_displacement_gsm",
        "depth_avg_curr_east",
        "depth_avg_curr_north",
        "GPSE_qc",
    ]
    with (
        netCDF4.Dataset(source) as old,
        netCDF4.Dataset(target, "w", format="NETCDF3_CLASSIC") as new,
    ):
        new.dive_number = old.dive_number
        for name, dim in old.dimensions.items():
            new.createDimension(name, len(dim))
        for name in names:
            if name not in drop:
                made = new.createVariable(name, old[name].dtype, old[name].dimensions)
                made[...] = old[name][...]
        change(new)


def put(name, where, value):
    def change(data):
        data[name][where] = value

    return change


def cut(share):
    """Keep a share of what the header of a file speaks of: its first half."""

    def damage(source, target):
        raw = source.read_bytes()
        target.write_bytes(raw[: int(share * len(raw) / 2)])

    return damage


def changed(change=lambda data: None, drop=()):
    return lambda source, target: small(source, target, change, drop)


def written(content):
    return lambda source, target: target.write_bytes(content)


def swap_times(data):
    data["log_gps_time"][:] = data["log_gps_time"][::-1]


def as_it_is(source, target):
    target.write_bytes(source.read_bytes())


def one_of_305(source, target):
    as_it_is(source.with_name("p5420305.nc"), target)


def flip(source, target):
    raw = bytearray(source.read_bytes())
    raw[4:60] = bytes(range(200, 256))
    target.write_bytes(raw)


STEPS = ("east_displacement", "north_displacement")
GSM = ("east_displacement_gsm", "north_displacement_gsm")
DAMAGES = {
    "one byte": (cut(0.0001), "no column dive, "),
    "100 bytes": (written(b"CDF\x01" + bytes(96)), "no variables|damaged"),
    "header cut": (cut(0.02), "damaged|cut short"),
    "cut at 10 %": (cut(0.1), "damaged|cut short"),
    "cut at 30 %": (cut(0.3), "cut short"),
    "cut at 50 %": (cut(0.5), "cut short"),
    "cut at 90 %": (cut(0.9), "cut short"),
    "last byte gone": (cut(0.999995), "cut short"),
    "header overwritten": (flip, "damaged|cannot be read"),
    "empty": (written(b""), "empty"),
    "text": (written(b"the modem dropped the line\nhere\n"), "no column dive, "),
    "blank lines": (written(b"\n\n  \n"), "empty"),
    "web page": (written(b"<html><body>404</body></html>"), "no column dive, "),
    "noise": (written(bytes(range(128, 256)) * 40), "neither NetCDF"),
    "HDF5 of noise": (written(b"\x89HDF\r\n\x1a\n" + bytes(500)), "cannot be read as NetCDF"),
    "latitude NaN": (changed(put("log_gps_lat", 2, nan)), "no fix after"),
    "longitude NaN": (changed(put("log_gps_lon", 1, nan)), "no fix before"),
    "time NaN": (changed(put("log_gps_time", 1, nan)), "no fix before"),
    "latitude 91": (changed(put("log_gps_lat", 2, 91.0)), "no fix after"),
    "latitude a fill value": (changed(put("log_gps_lat", 1, 9.97e36)), "no fix before"),
    "all fixes NaN": (changed(put("log_gps_lat", slice(None), nan)), "no fix"),
    "times swapped": (changed(swap_times), "swapped"),
    "end fix of another sea": (changed(put("log_gps_lat", 2, 43.0)), "m/s"),
    "no fix times": (changed(drop=("log_gps_time",)), "no variable log_gps_time"),
    "no latitudes": (changed(drop=("log_gps_lat",)), "no variable log_gps_lat"),
    "no displacement": (changed(drop=(*STEPS, *GSM)), "no variables east_displacement"),
    "displacement NaN": (changed(put(STEPS[0], slice(None), nan)), "samples of the displacement"),
    "a tenth NaN": (changed(put(STEPS[1], slice(0, 11), nan)), "samples of the displacement"),
    "displacement infinite": (changed(put(STEPS[0], slice(5, 39), inf)), "samples of the"),
    "duplicate of 305": (one_of_305, "duplicate"),
}


@pytest.fixture
def among_good(folder, tmp_path):
    """Make a folder of three good dives, and a damaged file instead of 306."""
    for good in GOOD:
        as_it_is(folder / f"p5420{good}.nc", tmp_path / f"p5420{good}.nc")

    def make(damage):
        damage(folder / "p5420306.nc", tmp_path / "p5420306.nc")
        return tmp_path

    return make


@pytest.mark.parametrize("name", DAMAGES)
def test_a_damaged_file_is_named_and_the_good_dives_are_used(among_good, name):
    damage, expected = DAMAGES[name]
    found, unread = read_dives(among_good(damage))
    used, unused = usable(found)
    assert [dive.number for dive in used] == list(GOOD)
    (skipped,) = unread + unused
    assert skipped.dive in (305, 306)
    assert any(part in skipped.why for part in expected.split("|")), skipped.why
    assert "\n" not in skipped.why
    if unread:
        path = among_good(damage) / "p5420306.nc"
        assert str(path) in skipped.why
        with pytest.raises(DataError, match="p5420306"):
            read_dives(path)


def test_what_can_be_repaired_is_and_says_so(folder, tmp_path):
    source = folder / "p5420306.nc"
    whole = dives_in(source)[0]

    def some_nan(data):
        data[STEPS[0]][6:110:27] = nan

    cases = {
        "filled from their neighbours": changed(some_nan),
        "glide-slope model": changed(drop=STEPS),
        "no track": changed(put("time", 7, nan)),
        "flags GPSE 4": changed(put("GPSE_qc", 0, b"4")),
    }
    for said, damage in cases.items():
        damage(source, tmp_path / "p5420306.nc")
        dive = dives_in(tmp_path / "p5420306.nc")[0]
        assert any(said in note for note in dive.notes), (said, dive.notes)
        assert [one.number for one in usable([dive])[0]] == [306]
        if "glide" not in said:
            assert dive.dr_east == pytest.approx(whole.dr_east, rel=0.01)
    changed(drop=("depth_avg_curr_east",))(source, tmp_path / "p5420306.nc")
    assert dives_in(tmp_path / "p5420306.nc")[0].dac_east is None


def test_a_cut_mission_of_no_fixed_length_is_refused(tmp_path):
    """The NetCDF library reads zeros where a part with an unlimited dimension is missing."""
    with netCDF4.Dataset(tmp_path / "og1.nc", "w", format="NETCDF3_CLASSIC") as data:
        data.createDimension("N_MEASUREMENTS", None)
        for name in ("TIME_GPS", "LATITUDE_GPS", "LONGITUDE_GPS"):
            data.createVariable(name, float, ("N_MEASUREMENTS",))[:] = np.linspace(1, 2e4, 40)
    whole = (tmp_path / "og1.nc").read_bytes()
    for percent in (1, 30, 50, 70, 99, 99.99):
        (tmp_path / "og1.nc").write_bytes(whole[: int(percent * len(whole) / 100)])
        with pytest.raises(DataError, match=r"og1.nc: (damaged or cut short|neither NetCDF)"):
            read_dives(tmp_path / "og1.nc")


def test_what_was_named_must_exist(tmp_path):
    with pytest.raises(DataError, match="no such file"):
        read_dives([tmp_path / "nothing.nc"])
    with pytest.raises(DataError, match="the folder has no"):
        read_dives(tmp_path)
    (tmp_path / "a.nc").write_bytes(b"")
    (tmp_path / "b.nc").write_bytes(b"")
    with pytest.raises(DataError, match="2 files: no dive"):
        read_dives(tmp_path)


def test_lines_of_a_table_are_skipped_one_by_one(tmp_path):
    write_dive_table(sample_dives()[:5], tmp_path / "dives.csv")
    lines = (tmp_path / "dives.csv").read_text().splitlines()
    lines[2] = "x" + lines[2]
    lines[3] = lines[3].replace("-43", "south", 1)
    lines[4] = lines[4][:30]
    (tmp_path / "dives.csv").write_bytes("\n".join(lines).encode().replace(b"south", b"\xb0"))
    found, skipped = read_dive_file(tmp_path / "dives.csv")
    used, unused = usable(found)
    assert [dive.number for dive in used] == [304, 308]
    assert [one.dive for one in skipped + unused] == [None, 306, 307]
    assert "line 3: dive is 'x305'" in skipped[0].why
    assert "lat_gps2 is '\ufffd" in skipped[1].why
    assert "no fix before" in unused[0].why


def test_a_column_that_stands_twice_is_refused(tmp_path):
    write_dive_table(sample_dives(), tmp_path / "dives.csv")
    text = (tmp_path / "dives.csv").read_text().replace("dac_qc,", "dive,")
    (tmp_path / "dives.csv").write_text(text)
    with pytest.raises(DataError, match="the column dive stands there twice"):
        read_dives(tmp_path)


def test_a_netcdf_file_of_another_kind_is_refused(tmp_path):
    with netCDF4.Dataset(tmp_path / "grid.nc", "w") as data:
        data.createVariable("u", float)
    with pytest.raises(DataError, match="neither a Seaglider file"):
        read_dives(tmp_path / "grid.nc")
    with netCDF4.Dataset(tmp_path / "og1.nc", "w") as data:
        data.createDimension("N_MEASUREMENTS", 3)
        for name in ("TIME_GPS", "LATITUDE_GPS", "LONGITUDE_GPS"):
            data.createVariable(name, float, ("N_MEASUREMENTS",))[:] = [1.0, nan, nan]
    with pytest.raises(DataError, match="no two fixes"):
        read_dives(tmp_path / "og1.nc")
    assert Path(tmp_path / "og1.nc").exists()
