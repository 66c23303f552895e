"""A scenario of the real field on Nantucket Shoals: its fit, its field, what is learned."""

import json

import numpy as np
import pytest
from test_currents import BOX, MARACOOS

import clpt_control as clpt
from clpt_control.blocks.field import gridded_flow
from clpt_control.currents.fit import fit_scenario, save_fit
from clpt_control.currents.grid_file import read_currents
from clpt_control.currents.plane import LocalPlane
from clpt_control.equations import evaluate
from clpt_control.errors import ClptError
from clpt_control.simulation.flows import explained_variance


@pytest.fixture(scope="module")
def nantucket(tmp_path_factory):
    fit = fit_scenario(MARACOOS, BOX)
    return fit, save_fit(fit, tmp_path_factory.mktemp("nantucket") / "s.toml")


def test_nantucket_fit(nantucket):
    fit, scenario = nantucket
    report = fit.report
    assert report["functions"] == scenario.basis.N == 27
    assert 0.75 <= report["explained_variance"] <= 0.85
    assert report["missing_fraction"] == pytest.approx(0.28, abs=0.005)
    assert report["origin"] == [41.225, -69.45]
    assert report["condition_number"] < 20
    assert report["residual_rms"] < report["residual_max"] < 3.0
    assert json.loads(json.dumps(report)) == report
    with pytest.raises(ClptError, match="left the field"):
        clpt.simulate(scenario.with_values({"reference.radius": 60.0}))


def test_nantucket_field_is_close_to_what_was_measured(nantucket):
    """The spline field at the measured cells: half a cell of resampling costs little."""
    currents = read_currents(MARACOOS, BOX)
    plane = LocalPlane(41.225, -69.45)
    lat, lon = currents.lat[:, None], currents.lon[None, :]
    x1, x2 = plane.to_plane(lat, lon)
    u, v = plane.rotate(lat, lon, currents.u, currents.v)
    g = nantucket[0].field
    inside = (x1 >= g.x1[0]) & (x1 <= g.x1[-1]) & (x2 >= g.x2[0]) & (x2 <= g.x2[-1])
    kept = currents.measured & inside
    t, y1, y2 = (np.broadcast_to(w, u.shape)[kept] for w in (currents.time[:, None, None], x1, x2))
    field = evaluate(gridded_flow(g), t, np.column_stack([y1, y2])) / 3.6
    error = np.hypot(field[:, 0] - u[kept], field[:, 1] - v[kept])
    assert np.sqrt(np.mean(error**2)) < 0.02  # m/s, of 0.51


def test_nantucket_learning_makes_clpe_small(nantucket):
    _, scenario = nantucket
    rms = {}
    for gain in (5.0, 1e-12):
        run = clpt.simulate(scenario.with_values({"learning.gain": gain}))
        late = run.clpe.sel(time=slice(18, 23))
        rms[gain] = float(np.sqrt((late**2).sum("axis").mean()))
        if gain == 5.0:
            shares = explained_variance(scenario, run, window=(18, 23))
    assert 1.0 < rms[1e-12] < 2.5  # km
    assert rms[5.0] <= 0.1 * rms[1e-12]
    assert shares["box"] < 0.5  # a small CLPE does not mean a right flow
