"""Tides and records of a current: known tides, identifiability, files, `clpt fit --tides`."""

import json
import os
import re

import numpy as np
import pytest
import utide
import xarray
from gridded_currents import gridded_current
from refusals import refuses
from tidal_records import (
    KNOWN,
    LATITUDE,
    MARACOOS,
    times,
    waves,
    write_netcdf,
    write_table,
)

from clpt_control import ScenarioError
from clpt_control.currents import fit_current, fit_tides, read_record
from clpt_control.paper.currents.constituents import OTHER_NAMES, nodal_corrections
from clpt_control.paper.currents.identifiability import check_separable, nyquist
from clpt_control.paper.scenario.tidal_periods import SPEEDS, period, speed


def test_speeds_are_those_of_utide():
    own = {
        name: 360 * utide.cycles_per_hour[OTHER_NAMES.get(name, name)]
        for name in SPEEDS
    }
    # UTide's SA and S1 follow the sun's perigee, Schureman's the mean year
    for name in SPEEDS:
        off = 2.1e-6 if name in ("SA", "S1") else 4e-7
        assert own[name] == pytest.approx(SPEEDS[name], abs=off)
    assert (speed("steady"), period("steady")) == (0, np.inf)
    refuses("unknown constituent 'M9'", speed, "M9", error=ScenarioError)


def m2(time):
    """East and north by the classical series in the node and the mean longitudes of moon and sun.

    J. Meeus, Astronomical Algorithms; D. Pugh, Tides, Surges and Mean Sea-Level.
    """
    T = (time - np.datetime64("2000-01-01T12")) / np.timedelta64(1, "D") / 36525
    s, h = 218.3164477 + 481267.88123 * T, 280.46646 + 36000.76983 * T
    N = np.radians(125.04452 - 1934.136261 * T)
    f, u = 1.0004 - 0.0373 * np.cos(N) + 0.0002 * np.cos(2 * N), -2.14 * np.sin(N)
    day = (time - time.astype("datetime64[D]")) / np.timedelta64(1, "h")
    angle = np.radians(30 * day + 2 * (h - s) + u)
    return np.array([0.5 * f * np.cos(angle - 1), 0.3 * f * np.cos(angle - 2)])


def test_a_fit_of_one_month_holds_in_another_year():
    """Both months made from the classical f, u and Meeus's V, ten years apart."""
    here, there = times(30, "2016-03-01"), times(30, "2026-03-01")
    fit = fit_tides(here, *m2(here), LATITUDE, ["M2"])
    tide = fit.constituents[0]
    assert tide.east == pytest.approx(0.5, rel=2e-3)
    assert tide.north_phase == pytest.approx(np.degrees(2), abs=0.2)
    assert np.abs(fit.predict(there) - m2(there)).max() < 0.006
    f = nodal_corrections(["M2"], [here[0], there[0]], LATITUDE)[0]
    assert abs(f[1, 0] / f[0, 0] - 1) > 0.03  # what would be lost without them


@pytest.mark.parametrize("gaps", [False, True])
def test_known_amplitudes_and_phases_are_recovered(gaps):
    time = times(60)
    flow = waves(time)
    if gaps:
        flow[0, np.random.default_rng(5).random(len(time)) < 0.2] = np.nan
        flow[1, 200:500] = np.nan
    fit = fit_tides(time, *flow, LATITUDE, list(KNOWN))
    # about the first time, from Greenwich constants; corrections turn a little in 60 days
    f, u, V = (a[0] for a in nodal_corrections(list(KNOWN), time[:1], LATITUDE))
    assert [tide.name for tide in fit.constituents] == list(KNOWN)
    for k, (tide, row) in enumerate(zip(fit.constituents, KNOWN.values(), strict=True)):
        np.testing.assert_allclose(
            [f[k] * tide.east, f[k] * tide.north], row[::2], atol=2e-3
        )
        off = np.array([tide.east_phase, tide.north_phase]) - V[k] - u[k] - row[1::2]
        assert np.abs((off + 180) % 360 - 180).max() < 1.5
    assert fit.mean == pytest.approx((0.1, -0.05), abs=1e-3)
    assert fit.explained_variance == pytest.approx(1, abs=1e-4)
    kept = np.isfinite(flow).all(axis=0)
    assert fit.samples == kept.sum()
    np.testing.assert_allclose(fit.predict(time)[:, kept], flow[:, kept], atol=5e-3)


def test_the_ellipse_is_that_of_the_components():
    time = times(30)
    fit = fit_tides(time, *waves(time), LATITUDE, ["M2"])
    tide = fit.constituents[0]
    turn = np.linspace(0, 2 * np.pi, 200001)
    u = tide.east * np.cos(turn - np.radians(tide.east_phase))
    v = tide.north * np.cos(turn - np.radians(tide.north_phase))
    size = np.hypot(u, v)
    assert size.max() == pytest.approx(tide.major, rel=1e-8)
    assert size.min() == pytest.approx(abs(tide.minor), rel=1e-4)
    assert tide.minor > 0  # north lags east by 70 degrees: counter-clockwise
    k = size.argmax()
    assert np.degrees(np.arctan2(v[k], u[k])) % 180 == pytest.approx(
        tide.inclination, abs=0.01
    )
    assert (np.degrees(turn[k]) - tide.phase + 90) % 180 == pytest.approx(90, abs=0.01)


@pytest.mark.long
@pytest.mark.parametrize("red", [0.8, pytest.param(0.0, marks=pytest.mark.slow)])
def test_estimates_lie_within_their_standard_errors(red):
    """Of 60 records with noise, white and red, at least 95 % within three."""
    time = times(15, step=120)
    clean = waves(time, {"M2": KNOWN["M2"]})
    keys = ("east", "north", "major", "minor", "inclination", "phase")
    truth = fit_tides(time, *clean, LATITUDE, ["M2", "K1"]).constituents[0]
    misses = []
    for seed in range(60):
        noise = np.random.default_rng(seed).normal(scale=0.1, size=clean.shape)
        for k in range(1, len(time)):
            noise[:, k] += red * noise[:, k - 1]
        found = fit_tides(time, *(clean + noise), LATITUDE, ["M2", "K1"]).constituents[
            0
        ]
        misses.append(
            [(getattr(found, k) - getattr(truth, k)) / found.errors[k] for k in keys]
        )
    size = np.abs(misses)
    assert (size < 3).mean(axis=0).min() >= 0.95
    spread = np.sqrt(np.mean(size**2))
    # red noise is not thought quieter than white
    assert (0.5 if red else 0.85) < spread < 1.15


def test_theta_of_a_scenario_is_the_fit():
    time, flow = times(30), waves(times(30))
    epoch = time[len(time) // 2]
    basis = fit_tides(time, *flow, LATITUDE, list(KNOWN)).basis(epoch, "km h-1")
    assert basis.constituents == ("steady", *(n for n in KNOWN for _ in range(2)))
    hours = (time - epoch) / np.timedelta64(1, "h")
    # steady: 0
    angles = [2 * np.pi * hours / period(name) for name in basis.constituents]
    phi = np.cos(np.array(angles) + np.array(basis.phases)[:, None])
    np.testing.assert_allclose(basis.theta @ phi, 3.6 * flow, atol=3.6 * 4e-3)


def test_utide_chooses_by_itself():
    time, flow = times(30), waves(times(30))
    names = {
        each.name for each in fit_tides(time, *flow, LATITUDE, "auto").constituents
    }
    assert {*KNOWN} < names
    assert "K2" not in names
    said = "no tide can be distinguished from the mean in 2 h"
    refuses(said, fit_tides, time[:3], *flow[:, :3], LATITUDE, "auto")


def test_rayleigh_says_which_and_how_long():
    check_separable(["M2", "S2"], 15 * 24.0, "x")
    day, together = times(1), r"in 24 h, these .* M2 and S2 \(354.4 h"
    refuses(together, fit_tides, day, *waves(day), LATITUDE, ["M2", "S2"])
    check_separable(["steady", "S2"], 12.0, "x")
    check_separable(["M2"], 1.0, "x")
    assert refuses(
        "x.nc: ", check_separable, ["M2", "S2", "K2", "steady"], 11.0, "x.nc"
    ) == (
        "x.nc: in 11 h, these cannot be distinguished: S2 and K2 (4383 h are needed), M2 and S2 "
        "(354.4 h are needed), M2 and K2 (327.9 h are needed), M2 and steady (12.43 h are needed), "
        "S2 and steady (12 h are needed), K2 and steady (11.97 h are needed)"
    )
    refuses("M9", check_separable, ["M2", "M9"], 24.0, "x", error=ScenarioError)


def test_rayleigh_on_a_measured_day(printed, refused, tmp_path):
    sentence = "in 23 h, these cannot be distinguished: M2 and S2 (354.4 h are needed)"  # 24 steps
    out = tmp_path / "s.toml"
    assert sentence in refused(
        "fit", MARACOOS, "--constituents", "steady,M2,S2", "--out", out
    )
    assert list(tmp_path.iterdir()) == []
    at = ("--at", 41.2, -69.5, "--constituents")
    assert sentence in refused("fit", MARACOOS, "--tides", *at, "M2,S2")
    tide = printed("fit", MARACOOS, "--tides", *at, "M2")["constituents"]["M2"]
    assert 0.5 < tide["major"] < 1.1  # strong and clockwise on the shoals
    assert tide["minor"] < 0
    for mistake, what in (
        ((50, -69.5), "latitude 50 is outside"),
        ((41.2, 10), "longitude 10"),
    ):
        assert what in refused(
            "fit", MARACOOS, "--tides", "--at", *mistake, "--constituents", "M2"
        )


def test_the_command_prints_constants(clpt, tmp_path):
    time = times(30)
    path = write_table(tmp_path / "r.csv", time, 100 * waves(time), "cm/s")
    arguments = ("fit", path, "--tides", "--constituents", "M2,S2,K1,O1")
    status, out, err = clpt(*arguments, "--json")
    report = json.loads(out)
    assert (status, err, list(report["constituents"])) == (0, "", list(KNOWN))
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
    grid = np.stack(
        [np.stack([flow * k for k in row], -1) for row in ((0, 0, 0), (0, 0, 1))], -2
    )
    grid = read_record(
        write_netcdf(tmp_path / "g.nc", time, grid, cells=cells), at=(41.0, 292.1)
    )
    assert grid.latitude == 41.2
    for other in (read_record(loose), read_record(net), grid):
        np.testing.assert_array_equal(other.time, one.time)
        np.testing.assert_allclose([other.u, other.v], [one.u, one.v], atol=1e-12)
        assert other.latitude == one.latitude == LATITUDE
    assert np.isnan(one.v[3])
    assert read_record(net, latitude=-10.0).latitude == -10.0


TIMES = [
    ("", ("20190101", "20190102")),
    (" (UTC)", ("20190101T00", "2019-01-02T01:00+01:00")),
    (" [yyyy-mm-ddTHH:MM:SSZ]", ("2019-01-01T00:00:00Z", "2019-01-02T00:00:00Z")),
    (" (ISO 8601)", ("2019-01-01", "2019-01-02")),
]


@pytest.mark.parametrize(("unit", "cells"), TIMES)
def test_times_of_a_table_are_as_its_header_says(tmp_path, unit, cells):
    rows = "".join(f"{cell},0.1,0.2\n" for cell in cells)
    (tmp_path / "r.csv").write_text(
        f"# latitude: -41.2\ntime{unit},u (m/s),v (m/s)\n{rows}"
    )
    record = read_record(tmp_path / "r.csv")
    np.testing.assert_array_equal(
        record.time, np.array(["2019-01-01", "2019-01-02"], "M8[ms]")
    )
    assert record.latitude == -41.2


HEADER = "# latitude: 41\ntime,u (m/s),v (m/s)\n"
ROW = "2019-01-01T0{}:00,0.1,0.2\n"


BAD_TABLES = [
    ("", "is empty"),
    (HEADER, "has a header and no rows"),
    ("the quick brown fox\n", "no column time"),
    ("time,u (m/s),v (m/s),u (m/s)\n", "more than one column u"),
    ("time,u,v\n" + ROW.format(1), "u has no units. Write them behind the name"),
    ("time,u (kelvin),v (m/s)\n", "u: units = 'kelvin' is not a speed"),
    (HEADER + "yesterday,1,2\n", "line 3: time is 'yesterday'"),
    (HEADER + "2201,1,2\n", "the year 1700 to 2200"),
    (HEADER + "\n# a gap\n2019-01-01,1,2\n2019-01-02,1,o2\n", "line 6: v is 'o2'"),
    (
        HEADER + ROW.format(2) + ROW.format(1),
        "01:00:00.000 follows .*02:00.*must increase",
    ),
    (HEADER + "2019-01-01,,\n2019-01-02,nan,1\n", "no time has a finite value"),
    (HEADER + "2019-01-01,999,1\n", "reaches 999 m/s: check its units"),
    (
        HEADER.replace("m/s", "cm/s") + "2019,-999,-999\n",
        "9.99 m/s: check its units and fill",
    ),
    (HEADER.split("\n", 1)[1] + ROW.format(1), "has no latitude"),
    (HEADER.replace("41", "141") + ROW.format(1), "latitude = 141.0"),
    (
        HEADER.replace("41", "north") + ROW.format(1),
        "latitude = nan: must be degrees north",
    ),
    (
        "time (local),u (m/s),v (m/s)\n" + ROW.format(1),
        "time is in 'local'; must be in UTC",
    ),
    (HEADER + ROW.format(1) + ROW.format(2), "changes by 0 m/s only"),
    (
        HEADER + "2019,1e-300,0\n2020,2e-300,0\n",
        "changes by 1e-300 m/s only: check its units",
    ),
    (
        HEADER.replace(",", ";") + "0;1;2\n",
        "columns are separated by semicolons. Use commas",
    ),
    (HEADER + ROW.format(1), "1 of 1 times have both components"),
    (
        "time,speed (m/s),direction (rad)\n" + ROW.format(1),
        "direction is in 'rad'; must be in",
    ),
]


@pytest.mark.parametrize(("text", "sentence"), BAD_TABLES)
def test_each_bad_table_is_one_sentence(refused, tmp_path, text, sentence):
    path = tmp_path / "r.csv"
    path.write_text(text)
    assert re.search(sentence, refused("fit", path, "--tides", "--constituents", "M2"))


def test_each_bad_file_is_one_sentence(refused, tmp_path):
    time, flow = times(2), waves(times(2))
    (tmp_path / "text.nc").write_text("not NetCDF")
    (tmp_path / "bytes.csv").write_bytes(bytes(range(256)) * 9)
    os.mkfifo(tmp_path / "fifo.csv")
    m2, net = ("--constituents", "M2"), write_netcdf(tmp_path / "x.nc", time, flow)
    for path, arguments, sentence in (
        (tmp_path / "none.nc", m2, "no such file"),
        (tmp_path / "text.nc", m2, "cannot be read as NetCDF"),
        (tmp_path / "bytes.csv", m2, "is not text"),
        (tmp_path / "fifo.csv", m2, "is not a regular file. Give a file"),
        (
            write_netcdf(tmp_path / "a.nc", time, np.nan * flow),
            m2,
            "no time has a finite value",
        ),
        (
            write_netcdf(tmp_path / "b.nc", time, flow, latitude=None),
            m2,
            "--latitude DEG",
        ),
        (write_netcdf(tmp_path / "c.nc", time[::-1], flow), m2, "times must increase"),
        (
            write_netcdf(tmp_path / "f.nc", time, flow, calendar="360_day"),
            m2,
            "calendar '360_day'",
        ),
        (net, ("--constituents", "M9"), "unknown constituent 'M9'"),
        (net, ("--constituents", "M2,M2"), "each once"),
        (net, ("--constituents", "steady"), "must be tides, each once"),
        (net, (*m2, "--latitude", "nan"), "latitude = nan"),
    ):
        assert sentence in refused("fit", path, "--tides", *arguments)


def test_records_that_are_blind_to_a_tide():
    for time, names, sentence in (
        (
            times(30, step=720),
            ["S2"],
            "the mean and S2 look alike. Take other intervals",
        ),
        (times(30, step=1440), ["M2", "S2"], "look alike"),
        (
            times(30, step=10000),
            ["M2", "S2"],
            "measurements for 5 numbers to fit; at least 10",
        ),
        (times(1)[::-1], ["M2"], "times must increase"),
    ):
        flow = np.cos(np.radians((time - time[0]) / np.timedelta64(1, "h")))
        refuses(sentence, fit_tides, time, flow, flow, LATITUDE, names)
        refuses("must be one row", fit_tides, time, flow[1:], flow[1:], LATITUDE, names)


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
        {"vel": (("dir", "range", "time"), vel, {"units": "m/s"})},
        {
            "dir": [*("ENU" if system == "earth" else "XYZ"), "err"],
            "range": [1.0, 2.0, 3.0],
            "time": (
                "time",
                1.55e9 + 3600 * hours,
                {"units": "seconds since 1970-01-01"},
            ),
        },
        {"coord_sys": system, "latitude": 41.0, **attrs},
    )


def test_a_profilers_file_is_a_record(tmp_path):
    profiler(declination=-14.0).to_netcdf(tmp_path / "adcp.nc")
    record = read_record(tmp_path / "adcp.nc")
    assert (record.u.mean(), record.v) == (
        pytest.approx(0.4, abs=0.01),
        pytest.approx(0.2),
    )
    assert record.latitude == 41.0
    profiler().to_netcdf(tmp_path / "magnetic.nc")
    refuses("set_declination", read_record, tmp_path / "magnetic.nc")
    profiler("inst", declination=0.0).to_netcdf(tmp_path / "inst.nc")
    refuses(
        "of 'inst'; Rotate it with dolfyn.rotate2 to earth",
        read_record,
        tmp_path / "inst.nc",
    )


def test_speed_and_direction_are_read_as_east_and_north(tmp_path):
    path = tmp_path / "adcp.txt"
    rows = "".join(f"2019-01-01T0{k}:00:00Z,{100 + k},{90 * k}\n" for k in range(4))
    for header, units in (
        ("speed (cm/s),direction (deg)", None),
        ("speed,direction", "cm/s"),
    ):
        path.write_text(f"# latitude: 41.2\ntime,{header}\n{rows}")
        record = read_record(path, units=units)
        assert record.u == pytest.approx([0.0, 1.01, 0.0, -1.03])
        assert record.v == pytest.approx([1.0, 0.0, -1.02, 0.0], abs=1e-12)
    refuses("speed has no units", read_record, path)
    path.write_text("# latitude: 41.2\ntime,speed (cm/s)\n2019-01-01,3\n")
    refuses("no column direction", read_record, path)


@pytest.mark.parametrize("step", [1.0, 3.0, 8.0])
def test_no_tide_above_the_nyquist_frequency(step):
    time = times(30, step=int(60 * step))
    hours = (time - time[0]) / np.timedelta64(1, "h")
    wave = np.cos(np.radians(15.0410686) * hours)
    given, of_utide = (time, wave, 0.5 * wave, 41.0), utide.cycles_per_hour
    found = fit_tides(*given, "auto").constituents
    assert max(of_utide[tide.name] for tide in found) < 0.5 / step
    for name, hour in (("M2", 12.42), ("M4", 6.21)):
        if 2 * step > hour:
            said = f"see no tide of {2 * step:g} h or faster.*{name}"
            refuses(said, fit_tides, *given, ["K1", name])
        else:
            fit_tides(*given, ["K1", name])
    rng = np.random.default_rng(1)
    assert nyquist(np.sort(rng.uniform(0, 100, 50))) == np.inf
    kept = np.sort(rng.choice(hours.size, hours.size * 3 // 4, replace=False))
    assert nyquist(hours[kept]) == pytest.approx(0.5 / step)


def test_a_fit_of_a_grid_refuses_a_tide_that_its_steps_miss(tmp_path):
    hours, place = np.arange(0.0, 240.0, 8.0), np.linspace(41.0, 41.3, 4)
    wave = 0.3 * np.cos(2 * np.pi * hours / 12.42)[:, None, None] * np.ones((4, 4))
    gridded_current(wave, wave, place, place, hours).to_netcdf(tmp_path / "slow.nc")
    said, slow = "steps of 8 h see no tide of 16 h or faster", tmp_path / "slow.nc"
    refuses(said, fit_current, slow, rows=1, columns=1, radius_km=1.0)
