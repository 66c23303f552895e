"""Plots and pages of a diagram's ensemble: percentiles against those of closed forms."""

import re

import control
import matplotlib.pyplot as plt
import numpy as np
import pytest
from error_sentences import says

import clpt_control as clpt

TIMES = np.linspace(0, 5, 51)


def lag():
    """tau y' = u - y: y = 1 - exp(-t / tau), and its rate."""
    return clpt.Block(
        "lag",
        update=lambda t, x, u, p: (u.u - x.y) / p.tau,
        output=lambda t, x, u, p: {"y": x.y, "r": [(u.u[0] - x.y[0]) / p.tau, x.y[0]]},
        inputs={"u": 1},
        states={"y": 1},
        outputs={"y": 1, "r": 2},
        parameters={"tau": 1.0},
        units={"y": "m", "r": "m/s"},
    )


def ensemble(**options):
    return clpt.run_ensemble(
        lag(), {"lag.tau": "0.5:2"}, 20, timepts=TIMES, inputs=1.0, **options
    )


def test_percentiles_over_time_of_each_output():
    data = ensemble(trajectories=True)
    axes = data.clpt.plot()
    tau = data["lag.tau"].values[:, None]
    y = 1 - np.exp(-TIMES / tau)
    for ax, exact in zip(axes, ((1 - y) / tau, y, y), strict=True):
        median, low, high = (line.get_ydata() for line in ax.lines)
        expected = np.percentile(exact, [50, 5, 95], axis=0)
        np.testing.assert_allclose([median, low, high], expected, atol=1e-7)
    labels = [ax.get_ylabel() for ax in axes]
    assert labels == ["r[0] (m/s)", "r[1] (m/s)", "y (m)"]
    plt.close("all")


def test_without_trajectories_the_rms_is_drawn_over_what_varied():
    grid = clpt.run_ensemble(
        lag(), {"lag.tau": [0.5, 1, 2], "u": [1.0, 2.0]}, timepts=TIMES
    )
    for data in (grid, grid.unstack()):
        axes = data.clpt.plot()
        for k, line in enumerate(axes[-1].lines):  # of each input
            tau, rms = line.get_data()
            np.testing.assert_array_equal(tau, [0.5, 1, 2])
            np.testing.assert_array_equal(rms, grid.y_rms.values[k::2])
    plt.close("all")


@pytest.mark.long
@pytest.mark.parametrize("stored", [True, False])
def test_an_ensemble_of_a_diagram_has_a_page(tmp_path, stored):
    data = ensemble(trajectories=stored, out=tmp_path / "many.zarr")
    pages = []
    for source in (data, tmp_path / "many.zarr"):
        made = clpt.report(source, tmp_path / "many.html", figures=tmp_path)
        assert (made["kind"], len(made["figures"])) == ("Ensemble", 6 if stored else 2)
        assert made["sentences"] == ["20 runs of a diagram with values that vary."]
        pages.append((tmp_path / "many.html").read_text())
    assert pages[0] == pages[1]
    (row,) = re.findall(r"<tr><t[hd][^>]*>y_final \(m\)</t[hd]>(.*?)</tr>", pages[0])
    cells = [float(cell) for cell in re.findall(r">([\d.]+)<", row)]
    y = 1 - np.exp(-5 / data["lag.tau"].values)
    expected = np.percentile(y, [5, 25, 50, 75, 95])
    np.testing.assert_allclose(cells, expected, rtol=1e-3)


def test_an_ensemble_whose_members_all_fail_has_its_page(tmp_path):
    blown = clpt.Block(
        "b",
        update=lambda t, x, u, p: p.k / (x.x - 1),
        states={"x": 1},
        parameters={"k": 1.0},
    )
    with pytest.warns(UserWarning, match="2 of 2"):
        data = clpt.run_ensemble(
            blown,
            {"b.k": [1.0, 2.0]},
            timepts=TIMES,
            initial_state=1.0,
            trajectories=True,
        )
    clpt.report(data, tmp_path / "many.html")
    assert "2 of 2 runs ended early" in (tmp_path / "many.html").read_text()


def test_more_signals_than_a_figure_shows():
    wide = control.ss(-np.eye(17), np.ones((17, 1)), np.eye(17), 0, name="wide")
    data = clpt.run_ensemble(wide, {"u": [1.0, 2.0]}, timepts=[0, 1], trajectories=True)
    says(
        clpt.DataError,
        "17 signals along time: one figure shows 1 to 16",
        data.clpt.plot,
    )
