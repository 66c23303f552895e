"""Tidal constants: closed-form records, nodal corrections, Rayleigh, files."""

import json
import re
import sys
from pathlib import Path

import netCDF4
import numpy as np
import pytest

from clpt_control.errors import DataError, ScenarioError
from clpt_control.ocean.fit import fit_scenario
from clpt_control.ocean.tidal.analysis import fit_tides, predict
from clpt_control.ocean.tidal.basis import tidal_basis
from clpt_control.ocean.tidal.nodal import OTHER_NAMES, nodal_corrections
from clpt_control.ocean.tidal.rayleigh import check_separable, inseparable
from clpt_control.ocean.tidal.record import read_record
from clpt_control.tides import SPEEDS, period, speed

MARACOOS = Path(__file__).parents[2] / "shared/data/field/maracoos_hfr_2019-01-01.nc"
LATITUDE = 41.2
# name: east amplitude (m/s) and phase (degrees), north amplitude and phase
KNOWN = {
    "M2": (0.50, 40.0, 0.30, 110.0),
    "S2": (0.15, 350.0, 0.10, 20.0),
    "K1": (0.08, 200.0, 0.06, 300.0),
    "O1": (0.05, 10.0, 0.07, 95.0),
}


def moon(time):
    """Mean longitudes of moon, sun and node in degrees (J. Meeus, Astronomical Algorithms)."""
    days = (time - np.datetime64("2000-01-01T12")) / np.timedelta64(1, "D")
    T = days / 36525
    return 218.3164477 + 481267.88123 * T, 280.46646 + 36000.76983 * T, 125.04452 - 1934.136261 * T


def classical(time):
    """f and u of the classical series in the node (D. Pugh, Tides, Surges and Mean Sea-Level)."""
    N = np.radians(moon(time)[2])
    c, s = (lambda k: np.cos(k * N)), (lambda k: np.sin(k * N))
    return {
        "M2": (1.0004 - 0.0373 * c(1) + 0.0002 * c(2), -2.14 * s(1)),
        "K1": (1.0060 + 0.1150 * c(1) - 0.0088 * c(2) + 0.0006 * c(3),
               -8.86 * s(1) + 0.68 * s(2) - 0.07 * s(3)),
        "S2": (np.ones(len(N)), np.zeros(len(N))),
    }  # fmt: skip


def times(days, start="2019-01-01", step=60):
    return np.datetime64(start, "ms") + np.arange(0, days * 1440 + 1, step) * np.timedelta64(1, "m")


def waves(time, known=KNOWN, mean=(0.1, -0.05)):
    """East and north, from the cosines of each tide about the first time."""
    hours = (time - time[0]) / np.timedelta64(1, "h")
    angles = {name: np.radians(SPEEDS[name] * hours) for name in known}
    parts = [
        [row[2 * i] * np.cos(angles[n] - np.radians(row[2 * i + 1])) for n, row in known.items()]
        for i in (0, 1)
    ]
    return np.array([mean[i] + np.sum(parts[i], axis=0) for i in (0, 1)])


def local(fit, at):
    """Amplitude and phase about a time, from Greenwich constants."""
    f, u, V = nodal_corrections([each.name for each in fit.constituents], [at], LATITUDE)
    return {
        each.name: (f[0, k] * each.east, (each.east_phase - V[0, k] - u[0, k]) % 360,
                    f[0, k] * each.north, (each.north_phase - V[0, k] - u[0, k]) % 360)
        for k, each in enumerate(fit.constituents)
    }  # fmt: skip


def write_table(path, time, flow, units="m/s", latitude=LATITUDE):
    comment = "" if latitude is None else f"# latitude: {latitude}\n"
    cells = [["" if np.isnan(value) else str(value) for value in part] for part in flow]
    rows = "".join(f"{t}Z,{u},{v}\n" for t, u, v in zip(time, *cells, strict=True))
    path.write_text(f"{comment}time,u ({units}),v [{units}]\n{rows}")
    return path


def write_netcdf(path, time, flow, *, cells=None, latitude=LATITUDE, units="m/s", calendar=None):
    with netCDF4.Dataset(path, "w") as file:
        file.createDimension("time", len(time))
        file.createVariable("time", "f8", ("time",))[:] = (time - time[0]) / np.timedelta64(1, "h")
        file["time"].units = f"hours since {str(time[0])[:19].replace('T', ' ')}"
        if calendar:
            file["time"].calendar = calendar
        dims = ("time",)
        if cells is not None:
            for name, values in zip(("lat", "lon"), cells, strict=True):
                file.createDimension(name, len(values))
                file.createVariable(name, "f8", (name,))[:] = values
            dims = ("time", "lat", "lon")
        elif latitude is not None:
            file.createVariable("latitude", "f8", ())[...] = latitude
        for name, values in zip("uv", flow, strict=True):
            file.createVariable(name, "f8", dims)[:] = values
            file[name].units = units
    return path


# ------------------------------------------------------------------ speeds and nodal corrections
def test_speeds_are_those_of_utide():
    utide = pytest.importorskip("utide")
    own = {name: 360 * utide.cycles_per_hour[OTHER_NAMES.get(name, name)] for name in SPEEDS}
    # UTide's SA and S1 follow the sun's perigee, Schureman's the mean year
    for name in SPEEDS:
        assert own[name] == pytest.approx(
            SPEEDS[name], abs=2.1e-6 if name in ("SA", "S1") else 4e-7
        )
    assert speed("steady") == 0
    assert period("steady") == np.inf
    with pytest.raises(ScenarioError, match="unknown constituent 'M9'"):
        speed("M9")


def test_nodal_corrections_against_the_classical_series():
    """The series leave out the moon's perigee and latitude: 0.002 of M2, 0.0024 of S2."""
    time = np.array([f"{year}-07-01" for year in range(1995, 2031)], "datetime64[ms]")
    found = nodal_corrections(["M2", "K1", "S2"], time, LATITUDE)
    for k, (f, u) in enumerate(classical(time).values()):
        tolerance = (2e-3, 1e-3, 2.5e-3)[k]
        np.testing.assert_allclose(found.f[:, k], f, atol=tolerance)
        np.testing.assert_allclose(found.u[:, k], u, atol=0.2)
        assert abs(np.mean(found.f[:, k] - f)) < 1e-3
    assert np.ptp(found.f[:, 0]) > 0.07
    s, h, _ = moon(time)
    error = (found.V[:, 0] - 2 * (h - s) + 180) % 360 - 180
    assert np.abs(error).max() < 1e-3
    noon = nodal_corrections(["S2"], ["2019-01-01T00:00", "2019-01-01T03:00"], LATITUDE).V[:, 0]
    np.testing.assert_allclose((noon + 1) % 360 - 1, [0, 90], atol=1e-6)


@pytest.mark.parametrize("latitude", [0.0, -3.0, 89.0])
def test_nodal_corrections_at_every_latitude(latitude):
    found = nodal_corrections(list(SPEEDS), ["2020-02-29"], latitude)
    assert all(np.all(np.isfinite(values)) for values in found)


def test_a_fit_of_one_month_holds_in_another_year():
    """Both months made from the classical f, u and Meeus's V, ten years apart."""

    def m2(time):
        s, h, _ = moon(time)
        f, u = classical(time)["M2"]
        day = (time - time.astype("datetime64[D]")) / np.timedelta64(1, "h")
        angle = np.radians(30 * day + 2 * (h - s) + u)
        return np.array([0.5 * f * np.cos(angle - 1), 0.3 * f * np.cos(angle - 2)])

    here, there = times(30, "2016-03-01"), times(30, "2026-03-01")
    fit = fit_tides(here, *m2(here), LATITUDE, ["M2"])
    tide = fit.constituents[0]
    assert tide.east == pytest.approx(0.5, rel=2e-3)
    assert tide.north_phase == pytest.approx(np.degrees(2), abs=0.2)
    assert np.abs(predict(fit, there) - m2(there)).max() < 0.006
    f = nodal_corrections(["M2"], [here[0], there[0]], LATITUDE).f
    assert abs(f[1, 0] / f[0, 0] - 1) > 0.03  # what would be lost without them


# ----------------------------------------------------------------------------------------- fits
@pytest.mark.parametrize("gaps", [False, True])
def test_known_amplitudes_and_phases_are_recovered(gaps):
    time = times(60)
    flow = waves(time)
    if gaps:
        rng = np.random.default_rng(5)
        flow[0, rng.random(len(time)) < 0.2] = np.nan
        flow[1, 200:500] = np.nan
    fit = fit_tides(time, *flow, LATITUDE, list(KNOWN))
    found = local(fit, time[0])
    for name, row in KNOWN.items():  # nodal corrections turn a little in 60 days
        np.testing.assert_allclose(found[name][::2], row[::2], atol=2e-3)
        off = (np.array(found[name])[1::2] - row[1::2] + 180) % 360 - 180
        assert np.abs(off).max() < 1.5
    assert fit.mean == pytest.approx((0.1, -0.05), abs=1e-3)
    assert fit.explained_variance == pytest.approx(1, abs=1e-4)
    kept = np.isfinite(flow).all(axis=0)
    assert fit.samples == kept.sum()
    np.testing.assert_allclose(predict(fit, time)[:, kept], flow[:, kept], atol=5e-3)


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
    assert np.degrees(np.arctan2(v[k], u[k])) % 180 == pytest.approx(tide.inclination, abs=0.01)
    assert (np.degrees(turn[k]) - tide.phase + 90) % 180 == pytest.approx(90, abs=0.01)


@pytest.mark.parametrize("red", [0.0, 0.8])
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
        found = fit_tides(time, *(clean + noise), LATITUDE, ["M2", "K1"]).constituents[0]
        misses.append([(getattr(found, k) - getattr(truth, k)) / found.errors[k] for k in keys])
    size = np.abs(misses)
    assert (size < 3).mean(axis=0).min() >= 0.95
    spread = np.sqrt(np.mean(size**2))
    assert (0.5 if red else 0.85) < spread < 1.15  # red noise is not thought quieter than white


def test_theta_of_a_scenario_is_the_fit():
    time = times(30)
    flow = waves(time)
    fit = fit_tides(time, *flow, LATITUDE, list(KNOWN))
    epoch = time[len(time) // 2]
    basis = tidal_basis(fit, epoch, "km h-1")
    assert basis.constituents == ("steady", *(n for n in KNOWN for _ in range(2)))
    hours = (time - epoch) / np.timedelta64(1, "h")
    phi = [
        np.cos(2 * np.pi * hours / period(n) + p) if n != "steady" else np.ones(len(hours))
        for n, p in zip(basis.constituents, basis.phases, strict=True)
    ]
    np.testing.assert_allclose(basis.theta @ phi, 3.6 * flow, atol=3.6 * 4e-3)


def test_utide_chooses_by_itself():
    time = times(30)
    fit = fit_tides(time, *waves(time), LATITUDE, "auto")
    names = [each.name for each in fit.constituents]
    assert set(KNOWN) < set(names)
    assert "K2" not in names
    with pytest.raises(DataError, match="no tide can be told from the mean in 2 h"):
        fit_tides(time[:3], *waves(time)[:, :3], LATITUDE, "auto")


# ------------------------------------------------------------------------------------- Rayleigh
def test_rayleigh_says_which_and_how_long():
    assert inseparable(["M2", "S2"], 24.0) == [("M2", "S2", pytest.approx(360 / 1.0158958))]
    assert inseparable(["M2", "S2"], 15 * 24.0) == []
    assert inseparable(["steady", "S2", "M2"], 12.0) == [
        ("S2", "M2", pytest.approx(354.367, abs=1e-3)),
        ("steady", "M2", pytest.approx(12.4206, abs=1e-4)),
    ]
    assert inseparable(["steady", "S2"], 12.0) == []
    check_separable(["M2"], 1.0, "x")
    with pytest.raises(DataError) as caught:
        check_separable(["M2", "S2", "K2", "steady"], 11.0, "x.nc")
    assert str(caught.value) == (
        "x.nc: in 11 h, these pairs cannot be told apart (hours needed): S2 and K2 (4383 h), "
        "M2 and S2 (354.4 h), M2 and K2 (327.9 h), M2 and steady (12.43 h), S2 and steady (12 h), "
        "K2 and steady (11.97 h); leave one of each pair out or take a longer record"
    )
    with pytest.raises(ScenarioError):
        check_separable(["M2", "M9"], 24.0, "x")


SENTENCE = "in 24 h, M2 and S2 cannot be told apart: 354.4 h are needed"


def test_rayleigh_refuses_m2_beside_s2_in_a_day(clpt, tmp_path):
    time = times(1)
    flow = waves(time)
    with pytest.raises(DataError, match=SENTENCE):
        fit_tides(time, *flow, LATITUDE, ["M2", "S2"])
    for path in (
        write_table(tmp_path / "r.csv", time, flow),
        write_netcdf(tmp_path / "r.nc", time, flow),
    ):
        status, out, err = clpt("tides", path, "--constituents", "M2,S2", "--out", tmp_path / "o")
        assert (status, out) == (2, "")
        assert SENTENCE in err
        assert err.count("\n") == 1
        assert not (tmp_path / "o").exists()
    time = times(15)
    tides = fit_tides(time, *waves(time), LATITUDE, ["M2", "S2"]).constituents
    assert [each.name for each in tides] == ["M2", "S2"]


def test_rayleigh_on_a_measured_day(clpt, tmp_path):
    if not MARACOOS.exists():
        pytest.skip("the MARACOOS file is not beside the repository")
    sentence = "in 23 h, M2 and S2 cannot be told apart: 354.4 h are needed"  # 24 steps
    with pytest.raises(DataError, match=sentence):
        fit_scenario(MARACOOS, (40.9, 41.55, -69.9, -69.0), constituents=("steady", "M2", "S2"))
    arguments = ("--constituents", "steady,M2,S2", "--out", tmp_path / "s.toml")
    status, out, err = clpt("fit", MARACOOS, *arguments)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert sentence in err
    assert list(tmp_path.iterdir()) == []
    at = ("--at", 41.2, -69.5, "--constituents")
    assert sentence in clpt("tides", MARACOOS, *at, "M2,S2").err
    status, out, _ = clpt("tides", MARACOOS, *at, "M2", "--json")
    tide = json.loads(out)["constituents"]["M2"]
    assert status == 0
    assert 0.5 < tide["major"] < 1.1  # strong and clockwise on the shoals
    assert tide["minor"] < 0
    for mistake, what in (((50, -69.5), "latitude 50 lies outside"), ((41.2, 10), "longitude 10")):
        assert what in clpt("tides", MARACOOS, "--at", *mistake, "--constituents", "M2").err
    assert "--at LAT LON" in clpt("tides", MARACOOS, "--constituents", "M2").err


def test_a_grid_of_a_month_gives_every_constituent(tmp_path):
    """Amplitudes and phases at the gaussian's place, to rounding."""
    from pyproj import Proj

    lat, lon, time = np.linspace(41, 41.4, 5), np.linspace(-69.6, -69.0, 5), times(30, step=180)
    x1, x2 = (w / 1000 for w in Proj(proj="aeqd", ellps="WGS84", lat_0=41.2, lon_0=-69.3)(
        *np.meshgrid(lon, lat)[::1]))  # fmt: skip
    kernel = np.exp(-(x1**2 + x2**2) / (2 * 30.0**2))
    flow = np.array([part[:, None, None] * kernel for part in waves(time)])
    path = write_netcdf(tmp_path / "grid.nc", time, flow, cells=(lat, lon))
    names = ("steady", *KNOWN)
    report = fit_scenario(path, None, (1, 1), 30.0, names, radius_km=5.0).report
    theta = np.array(report["theta"]) / 3.6
    np.testing.assert_allclose(theta[:, 0], [0.1, -0.05], atol=1e-3)
    for k, row in enumerate(KNOWN.values()):
        cos, sin = theta[:, 1 + 2 * k], theta[:, 2 + 2 * k]
        # the plane's east leans from the parallel by up to 0.2 degrees
        np.testing.assert_allclose(np.hypot(cos, sin), row[::2], rtol=5e-3)
        off = (np.degrees(np.arctan2(sin, cos)) - row[1::2] + 180) % 360 - 180
        assert np.abs(off).max() < 0.5
    assert report["explained_variance"] > 0.9999
    assert list(report["nodal"]) == list(KNOWN)
    f = classical(np.array(["2019-01-16"], "datetime64[ms]"))["M2"][0][0]
    assert report["nodal"]["M2"]["f"] == pytest.approx(f, abs=2e-3)


# ---------------------------------------------------------------------------- command and files
def test_the_command_writes_constants_and_a_picture(clpt, tmp_path):
    time = times(30)
    path = write_table(tmp_path / "r.csv", time, 100 * waves(time), "cm/s")
    arguments = ("tides", path, "--constituents", "M2,S2,K1,O1", "--out", tmp_path / "o")
    status, out, err = clpt(*arguments, "--json")
    report = json.loads(out)
    assert (status, err) == (0, "")
    assert sorted(p.name for p in (tmp_path / "o").iterdir()) == ["tides.nc", "tides.png"]
    with netCDF4.Dataset(tmp_path / "o" / "tides.nc") as file:
        assert list(file["constituent"][:]) == list(KNOWN)
        for name in ("amplitude", "amplitude_standard_error", "ellipse_major", "mean"):
            assert file[name].units == "m s-1"
        f, u, V, A, g = (file[n][:].data for n in ("f", "u", "V", "amplitude", "phase"))
        middle = np.datetime64(file.nodal_time)
    # what the file says, put together as its comment says
    tide = np.sum(f[:, None] * A * np.cos(np.radians((V + u)[:, None] - g)), axis=0)
    k = np.flatnonzero(time == middle)[0]
    np.testing.assert_allclose(tide, waves(time, mean=(0, 0))[:, k], atol=3e-3)
    assert report["constituents"]["M2"]["east"] == pytest.approx(A[0, 0])
    assert report["nodal"]["M2"]["f"] == pytest.approx(f[0])
    status, out, _ = clpt(*arguments)
    assert status == 0
    assert "explained: 100.0% of the variance" in out
    assert "O1" in out


def test_records_are_read_alike_from_every_file(tmp_path):
    time = times(2)
    flow = waves(time)
    flow[0, 3] = np.nan
    one = read_record(write_table(tmp_path / "r.csv", time, flow))
    seconds = tmp_path / "s.csv"
    rows = "".join(
        f"{v},x,{int(t.astype(int)) // 1000},{u}\n" for t, u, v in zip(time, *flow, strict=True)
    )
    seconds.write_text(f"# units: m s-1\n# latitude = 41.2 N\nv,note,time,u\n{rows}")
    net = write_netcdf(tmp_path / "r.nc", time, 100 * flow, units="cm/s")
    cells = (np.array([40.0, 41.2]), np.array([-70.0, -69.0, -68.0]))
    grid = np.stack([np.stack([flow * k for k in row], -1) for row in ((0, 0, 0), (0, 0, 1))], -2)
    grid = read_record(write_netcdf(tmp_path / "g.nc", time, grid, cells=cells), at=(41.0, 292.1))
    assert (grid.latitude, grid.longitude) == (41.2, -68.0)
    for other in (read_record(seconds), read_record(net), grid):
        np.testing.assert_array_equal(other.time, one.time)
        np.testing.assert_allclose([other.u, other.v], [one.u, one.v], atol=1e-12)
        assert other.latitude == one.latitude == LATITUDE
    assert np.isnan(one.v[3])
    assert read_record(net, latitude=-10.0).latitude == -10.0


HEADER = "# latitude: 41\ntime,u (m/s),v (m/s)\n"
ROW = "2019-01-01T0{}:00,0.1,0.2\n"


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "is empty"),
        ("# only a comment\n", "is empty"),
        (HEADER, "has a header and no rows"),
        ("the quick brown fox\n", "no column time"),
        ("time,u (m/s)\n" + ROW.format(1), "no column v"),
        ("time,u (m/s),v (m/s),u (m/s)\n", "more than one column u"),
        ("time,u,v\n" + ROW.format(1), "u has no units; write them behind the name"),
        ("time,u (kelvin),v (m/s)\n", "u: units = 'kelvin' is no speed"),
        (HEADER + "yesterday,1,2\n", "line 3: time is 'yesterday'"),
        (HEADER + ",1,2\n", "line 3: time is ''"),
        (HEADER + "1e300,1,2\n", "must be seconds since 1970"),
        (HEADER + "9e9,1,2\n", "the year 1700 to 2200"),
        (HEADER + "2019-01-01,fast,2\n", "line 3: 'fast' is no number"),
        (HEADER + ROW.format(2) + ROW.format(1), "01:00:00.000 comes after .*02:00.*must increase"),
        (HEADER + ROW.format(1) * 2, "keep each time once"),
        (HEADER + "2019-01-01,,\n2019-01-02,nan,1\n", "no time has a finite value"),
        (HEADER + "2019-01-01,999,1\n", "reaches 999 m/s; at most 15"),
        (HEADER.split("\n", 1)[1] + ROW.format(1), "does not say its latitude"),
        (HEADER.replace("41", "141") + ROW.format(1), "latitude = 141.0"),
        (HEADER.replace("41", "north") + ROW.format(1), "'north' is no number"),
        (HEADER + ROW.format(1) + ROW.format(2), "which never change"),
        (HEADER + ROW.format(1), "1 of 1 times have both components"),
    ],
)  # fmt: skip
def test_each_bad_table_is_one_sentence(clpt, tmp_path, text, sentence):
    path = tmp_path / "r.csv"
    path.write_text(text)
    status, out, err = clpt("tides", path, "--constituents", "M2")
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert re.search(sentence, err)


def test_each_bad_file_is_one_sentence(clpt, tmp_path):
    time, flow = times(2), waves(times(2))
    (tmp_path / "text.nc").write_text("not NetCDF")
    (tmp_path / "bytes.csv").write_bytes(bytes(range(256)) * 9)
    net = tmp_path / "x.nc"
    for path, sentence in (
        (tmp_path / "none.nc", "no such file"),
        (tmp_path / "none.csv", "cannot be read"),
        (tmp_path, "is not a file"),
        (tmp_path / "text.nc", "cannot be read as NetCDF"),
        (tmp_path / "bytes.csv", "is no text"),
        (write_netcdf(tmp_path / "a.nc", time, np.nan * flow), "no time has a finite value"),
        (write_netcdf(tmp_path / "b.nc", time, flow, latitude=None), "--latitude DEG"),
        (write_netcdf(tmp_path / "c.nc", time[::-1], flow), "times must increase"),
        (write_netcdf(tmp_path / "d.nc", time, flow, units="kelvin"), "is no speed"),
        (write_netcdf(tmp_path / "e.nc", time[:1], flow[:, :1]), "at least 2 are needed"),
        (write_netcdf(tmp_path / "f.nc", time, flow, calendar="360_day"), "the calendar 360_day"),
    ):  # fmt: skip
        status, out, err = clpt("tides", path, "--constituents", "M2")
        assert (status, out, err.count("\n")) == (2, "", 1), path
        assert sentence in err
    write_netcdf(net, time, flow)
    for arguments, sentence in (
        (("--constituents", "M9"), "unknown constituent 'M9'"),
        (("--constituents", "M2,M2"), "each once"),
        (("--constituents", "steady"), "at least one tide"),
        (("--constituents", "M2", "--latitude", "nan"), "latitude = nan"),
        (("--constituents", "M2", "--out", tmp_path / "text.nc"), "is a file; give a folder"),
    ):
        status, out, err = clpt("tides", net, *arguments)
        assert (status, out, err.count("\n")) == (2, "", 1)
        assert sentence in err


@pytest.mark.parametrize(
    ("time", "names", "sentence"),
    [
        (times(30, step=720), ["S2"], "the mean and S2 look alike"),
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
    with pytest.raises(DataError, match="must be one row, as long"):
        fit_tides(time, flow[1:], flow[1:], LATITUDE, names)


def test_without_utide_one_sentence_and_fits_of_grids_go_on(clpt, tmp_path, monkeypatch):
    from clpt_control.ocean.tidal.nodal import nodal_report

    path = write_table(tmp_path / "r.csv", times(2), waves(times(2)))
    monkeypatch.setitem(sys.modules, "utide", None)
    status, _, err = clpt("tides", path, "--constituents", "M2")
    assert status == 2
    assert "pip install 'clpt-control[ocean]'" in err
    assert nodal_report(["M2"], "2019-01-01", 41.0) is None


def test_the_documented_lines_run(monkeypatch):
    if not MARACOOS.exists():
        pytest.skip("the MARACOOS file is not beside the repository")
    page = Path(__file__).parents[1] / "docs/measured_current.md"
    lines = page.read_text().split("```python\n")[1].split("```")[0]
    monkeypatch.chdir(MARACOOS.parent)
    space = {}
    exec(compile(lines, page.name, "exec"), space)
    flow = space["basis"].theta @ [1, 1, 0]  # at the epoch: mean and cosines
    np.testing.assert_allclose(flow, [3.6 * space["east"][0], 3.6 * space["north"][0]], rtol=1e-9)
    assert np.hypot(*flow) < 4
