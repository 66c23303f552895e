"""Records of a current in files, also a profiler's, and `clpt tides`: constants, mistakes."""

import json
import os
import re
import sys

import numpy as np
import pytest
import xarray
from made_fields import gridded_current
from tidal_records import HEADER, KNOWN, LATITUDE, ROW, times, waves, write_netcdf, write_table

from clpt_control.currents.current_record import read_record
from clpt_control.currents.fit import fit_scenario
from clpt_control.currents.telling_apart import nyquist
from clpt_control.currents.tidal_fit import fit_tides
from clpt_control.errors import DataError


def test_the_command_prints_constants(clpt, tmp_path):
    time = times(30)
    path = write_table(tmp_path / "r.csv", time, 100 * waves(time), "cm/s")
    arguments = ("tides", path, "--constituents", "M2,S2,K1,O1")
    status, out, err = clpt(*arguments, "--json")
    report = json.loads(out)
    assert (status, err) == (0, "")
    assert list(report["constituents"]) == list(KNOWN)
    middle = np.datetime64(report["nodal_time"])
    k = np.flatnonzero(time == middle)[0]
    for axis, key in enumerate(("east", "north")):
        tide = 0.0  # f A cos(V + u - g), put together from what the file says
        for name, each in report["constituents"].items():
            f, u, V = (report["nodal"][name][symbol] for symbol in "fuV")
            tide += f * each[key] * np.cos(np.radians(V + u - each[f"{key}_phase"]))
        assert tide == pytest.approx(waves(time, mean=(0, 0))[axis, k], abs=3e-3)
    status, out, _ = clpt(*arguments)
    assert status == 0
    assert "explained: 99.9" in out  # not 100 %: the record is of finite length
    assert "O1" in out


def test_records_are_read_alike_from_every_file(tmp_path):
    time = times(2)
    flow = waves(time)
    flow[0, 3] = np.nan
    one = read_record(write_table(tmp_path / "r.csv", time, flow))
    loose = tmp_path / "s.csv"
    rows = "".join(f"{v},x,{t},{u}\n" for t, u, v in zip(time, *flow, strict=True))
    loose.write_text(f"# units: m s-1\n# latitude = 41.2\nv,note,time,u\n{rows}")
    net = write_netcdf(tmp_path / "r.nc", time, 100 * flow, units="cm/s")
    cells = (np.array([40.0, 41.2]), np.array([-70.0, -69.0, -68.0]))
    grid = np.stack([np.stack([flow * k for k in row], -1) for row in ((0, 0, 0), (0, 0, 1))], -2)
    grid = read_record(write_netcdf(tmp_path / "g.nc", time, grid, cells=cells), at=(41.0, 292.1))
    assert grid.latitude == 41.2
    for other in (read_record(loose), read_record(net), grid):
        np.testing.assert_array_equal(other.time, one.time)
        np.testing.assert_allclose([other.u, other.v], [one.u, one.v], atol=1e-12)
        assert other.latitude == one.latitude == LATITUDE
    assert np.isnan(one.v[3])
    assert read_record(net, latitude=-10.0).latitude == -10.0


@pytest.mark.parametrize(
    ("unit", "cells"),
    [
        ("", ("20190101", "20190102")),
        (" (UTC)", ("20190101T00", "2019-01-02T01:00+01:00")),
        (" [yyyy-mm-ddTHH:MM:SSZ]", ("2019-01-01T00:00:00Z", "2019-01-02T00:00:00Z")),
        (" (ISO 8601)", ("2019-01-01", "2019-01-02")),
    ],
)
def test_times_of_a_table_are_as_its_header_says(tmp_path, unit, cells):
    path = tmp_path / "r.csv"
    path.write_text(
        f"# latitude: -41.2\ntime{unit},u (m/s),v (m/s)\n"
        + "".join(f"{cell},0.1,0.2\n" for cell in cells)
    )
    record = read_record(path)
    days = np.array(["2019-01-01", "2019-01-02"], "M8[ms]")
    np.testing.assert_array_equal(record.time, days)
    assert record.latitude == -41.2


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "is empty"),
        (HEADER, "has a header and no rows"),
        ("the quick brown fox\n", "no column time"),
        ("time,u (m/s),v (m/s),u (m/s)\n", "more than one column u"),
        ("time,u,v\n" + ROW.format(1), "u has no units; write them behind the name"),
        ("time,u (kelvin),v (m/s)\n", "u: units = 'kelvin' is no speed"),
        (HEADER + "yesterday,1,2\n", "line 3: time is 'yesterday'"),
        (HEADER + "2201,1,2\n", "the year 1700 to 2200"),
        (HEADER + "\n# a gap\n2019-01-01,1,2\n2019-01-02,1,o2\n", "line 6: v is 'o2'"),
        (HEADER + ROW.format(2) + ROW.format(1), "01:00:00.000 follows .*02:00.*must increase"),
        (HEADER + "2019-01-01,,\n2019-01-02,nan,1\n", "no time has a finite value"),
        (HEADER + "2019-01-01,999,1\n", "reaches 999 m/s: check its units"),
        (HEADER.replace("m/s", "cm/s") + "2019,-999,-999\n", "9.99 m/s: check its units and fill"),
        (HEADER.split("\n", 1)[1] + ROW.format(1), "does not say its latitude"),
        (HEADER.replace("41", "141") + ROW.format(1), "latitude = 141.0"),
        (HEADER.replace("41", "north") + ROW.format(1), "latitude = nan: must be degrees north"),
        ("time (local),u (m/s),v (m/s)\n" + ROW.format(1), "time is in 'local'; must be in UTC"),
        (HEADER + ROW.format(1) + ROW.format(2), "changes by 0 m/s only"),
        (HEADER + "2019,1e-300,0\n2020,2e-300,0\n", "changes by 1e-300 m/s only: check its units"),
        (HEADER.replace(",", ";") + "0;1;2\n", "columns are separated by semicolons; use commas"),
        (HEADER + ROW.format(1), "1 of 1 times have both components"),
        ("time,speed (m/s),direction (rad)\n" + ROW.format(1), "direction is in 'rad'; must be in"),
    ],
)
def test_each_bad_table_is_one_sentence(refused, tmp_path, text, sentence):
    path = tmp_path / "r.csv"
    path.write_text(text)
    assert re.search(sentence, refused("tides", path, "--constituents", "M2"))


def test_each_bad_file_is_one_sentence(refused, tmp_path):
    time, flow = times(2), waves(times(2))
    (tmp_path / "text.nc").write_text("not NetCDF")
    (tmp_path / "bytes.csv").write_bytes(bytes(range(256)) * 9)
    os.mkfifo(tmp_path / "fifo.csv")
    net = tmp_path / "x.nc"
    for path, sentence in (
        (tmp_path / "none.nc", "no such file"),
        (tmp_path / "text.nc", "cannot be read as NetCDF"),
        (tmp_path / "bytes.csv", "is no text"),
        (tmp_path / "fifo.csv", "is no regular file; give one"),
        (write_netcdf(tmp_path / "a.nc", time, np.nan * flow), "no time has a finite value"),
        (write_netcdf(tmp_path / "b.nc", time, flow, latitude=None), "--latitude DEG"),
        (write_netcdf(tmp_path / "c.nc", time[::-1], flow), "times must increase"),
        (write_netcdf(tmp_path / "f.nc", time, flow, calendar="360_day"), "the calendar '360_day'"),
    ):
        assert sentence in refused("tides", path, "--constituents", "M2")
    write_netcdf(net, time, flow)
    for arguments, sentence in (
        (("--constituents", "M9"), "unknown constituent 'M9'"),
        (("--constituents", "M2,M2"), "each once"),
        (("--constituents", "steady"), "must be tides, each once"),
        (("--constituents", "M2", "--latitude", "nan"), "latitude = nan"),
    ):
        assert sentence in refused("tides", net, *arguments)


@pytest.mark.parametrize(
    ("time", "names", "sentence"),
    [
        (times(30, step=720), ["S2"], "the mean and S2 look alike; take other intervals"),
        (times(30, step=1440), ["M2", "S2"], "look alike"),
        (times(30, step=10000), ["M2", "S2"], "measurements for 5 numbers to fit; at least 10"),
        (times(1)[::-1], ["M2"], "times must increase"),
    ],
)
def test_records_that_are_blind_to_a_tide(time, names, sentence):
    hours = (time - time[0]) / np.timedelta64(1, "h")
    flow = np.cos(np.radians(hours))
    with pytest.raises(DataError, match=sentence):
        fit_tides(time, flow, flow, LATITUDE, names)
    with pytest.raises(DataError, match="must be one row"):
        fit_tides(time, flow[1:], flow[1:], LATITUDE, names)


def test_without_utide_one_sentence_says_what_to_install(refused, tmp_path, monkeypatch):
    path = write_table(tmp_path / "r.csv", times(2), waves(times(2)))
    monkeypatch.setitem(sys.modules, "utide", None)
    assert "pip install 'clpt-control[sea]'" in refused("tides", path, "--constituents", "M2")


MS = {"units": "m/s"}


def profiler(system="earth", **attrs):
    """A made file as of dolfyn: three ranges, the last mostly empty; 0.4 to the east, 0.2 north."""
    hours = np.arange(0.0, 360.0, 0.5)
    vel = np.zeros((4, 3, hours.size))
    vel[0] = [[0.3], [0.5], [9.0]]
    vel[1] = 0.2
    vel[:, 2, 10:] = np.nan
    wave = np.cos(np.radians(28.9841042) * hours)
    vel[0, :2] += 0.1 * wave
    return xarray.Dataset(
        {"vel": (("dir", "range", "time"), vel, MS)},
        {
            "dir": [*("ENU" if system == "earth" else "XYZ"), "err"],
            "range": [1.0, 2.0, 3.0],
            "time": ("time", 1.55e9 + 3600 * hours, {"units": "seconds since 1970-01-01"}),
        },
        {"coord_sys": system, "latitude": 41.0, **attrs},
    )


def test_a_profilers_file_is_a_record(tmp_path):
    profiler(declination=-14.0).to_netcdf(tmp_path / "adcp.nc")
    record = read_record(tmp_path / "adcp.nc")
    assert record.u.mean() == pytest.approx(0.4, abs=0.01)
    assert record.v == pytest.approx(0.2)
    assert record.latitude == 41.0
    profiler().to_netcdf(tmp_path / "magnetic.nc")
    with pytest.raises(DataError, match="set_declination"):
        read_record(tmp_path / "magnetic.nc")
    profiler("inst", declination=0.0).to_netcdf(tmp_path / "inst.nc")
    with pytest.raises(DataError, match=r"of 'inst'; dolfyn.rotate2 turns it to earth"):
        read_record(tmp_path / "inst.nc")


def test_speed_and_direction_are_read_as_east_and_north(tmp_path):
    path = tmp_path / "adcp.txt"
    rows = "".join(f"2019-01-01T0{k}:00:00Z,{100 + k},{90 * k}\n" for k in range(4))
    path.write_text("# latitude: 41.2\ntime,speed (cm/s),direction (deg)\n" + rows)
    record = read_record(path)
    assert record.u == pytest.approx([0.0, 1.01, 0.0, -1.03])
    assert record.v == pytest.approx([1.0, 0.0, -1.02, 0.0], abs=1e-12)
    path.write_text("# latitude: 41.2\ntime,speed,direction\n" + rows)
    with pytest.raises(DataError, match="speed has no units"):
        read_record(path)
    assert read_record(path, units="cm/s").u[1] == pytest.approx(1.01)
    path.write_text("# latitude: 41.2\ntime,speed (cm/s)\n2019-01-01,3\n")
    with pytest.raises(DataError, match="no column direction"):
        read_record(path)


@pytest.mark.parametrize(("step", "auto"), [(1.0, True), (3.0, True), (8.0, False)])
def test_no_tide_above_the_nyquist_frequency(step, auto):
    utide = pytest.importorskip("utide")
    hours = np.arange(0.0, 720.0, step)
    time = np.datetime64("2019-01-01") + (3600 * hours).astype("timedelta64[s]")
    wave = np.cos(np.radians(15.0410686) * hours)
    found = fit_tides(time, wave, 0.5 * wave, 41.0, "auto").constituents
    fastest = max(utide.cycles_per_hour[tide.name] for tide in found)
    assert fastest < 0.5 / step
    for name, refused in (("M2", 2 * step > 12.42), ("M4", 2 * step > 6.21)):
        if refused:
            with pytest.raises(DataError, match=f"see no tide of {2 * step:g} h or faster.*{name}"):
                fit_tides(time, wave, 0.5 * wave, 41.0, ["K1", name])
        else:
            fit_tides(time, wave, 0.5 * wave, 41.0, ["K1", name])
    rng = np.random.default_rng(1)
    assert nyquist(np.sort(rng.uniform(0, 100, 50))) == np.inf
    kept = np.sort(rng.choice(hours.size, hours.size * 3 // 4, replace=False))
    assert nyquist(hours[kept]) == pytest.approx(0.5 / step)


def test_a_fit_of_a_grid_refuses_a_tide_that_its_steps_miss(tmp_path):
    hours, place = np.arange(0.0, 240.0, 8.0), np.linspace(41.0, 41.3, 4)
    wave = 0.3 * np.cos(2 * np.pi * hours / 12.42)[:, None, None] * np.ones((4, 4))
    gridded_current(wave, wave, place, place, hours).to_netcdf(tmp_path / "slow.nc")
    with pytest.raises(DataError, match="steps of 8 h see no tide of 16 h or faster"):
        fit_scenario(tmp_path / "slow.nc", rows=1, columns=1, radius_km=1.0)
