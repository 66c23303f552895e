"""What a record cannot tell apart is refused, by name and hours."""

import json

import numpy as np
import pytest
from tidal_records import (
    KNOWN,
    LATITUDE,
    MARACOOS,
    classical,
    times,
    waves,
    write_netcdf,
    write_table,
)

from clpt_control.currents.fit import fit_scenario
from clpt_control.currents.rayleigh import check_separable, inseparable
from clpt_control.currents.tides import fit_tides
from clpt_control.errors import DataError, ScenarioError


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
    x1, x2 = (
        w / 1000
        for w in Proj(proj="aeqd", ellps="WGS84", lat_0=41.2, lon_0=-69.3)(
            *np.meshgrid(lon, lat)[::1]
        )
    )
    kernel = np.exp(-(x1**2 + x2**2) / (2 * 30.0**2))
    flow = np.array([part[:, None, None] * kernel for part in waves(time)])
    path = write_netcdf(tmp_path / "grid.nc", time, flow, cells=(lat, lon))
    names = ("steady", *KNOWN)
    report = fit_scenario(
        path, rows=1, columns=1, width_km=30.0, constituents=names, radius_km=5.0
    ).report
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
