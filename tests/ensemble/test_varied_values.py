"""What of a diagram may vary, and how: distributions, names, units, and each mistake."""

import time
from functools import partial
from itertools import count, pairwise

import control
import matplotlib.pyplot as plt
import numpy as np
import pandas
import pytest
import xarray
from adaptive_loop import mrac
from sampled_runs import TIMES, assert_identical, lag, springs, system, two_shapes
from scipy import stats

import clpt_control as clpt
from clpt_control import ClptError
from clpt_control.ensemble.ensemble_statistics import ensemble_summary

PAPER = clpt.paper_scenario().with_values({"run.duration": 4.0})


def test_distributions_are_those_of_scipy():
    frozen = stats.gamma(2.0, scale=0.5)
    data = clpt.run_ensemble(lag(), {"tau": frozen}, 400, timepts=TIMES[:2])
    assert stats.kstest(data.tau.values, frozen.cdf).pvalue > 0.9  # a Latin hypercube
    assert np.atleast_1d(data.attrs["vary"]).tolist() == ["tau~gamma(2.0, scale=0.5)"]


def test_a_dict_says_the_same_of_a_scenario():
    texts = ["learning.gain=0.2:2.0", "flow.parameters~normal:0.1"]
    asked = {"learning.gain": "0.2:2.0", "flow.parameters": "~normal:0.1"}
    one, other = (clpt.run_ensemble(PAPER, vary, 4, seed=1) for vary in (texts, asked))
    assert_identical(one, other)
    vary = {"learning.gain": [0.4, 0.8], "vehicle.max_speed": stats.uniform(2, 1)}
    limited = PAPER.with_values({"vehicle.max_speed": 3.0})
    drawn = clpt.run_ensemble(limited, vary, 4)
    assert drawn["vehicle.max_speed"].values.min() >= 2
    assert drawn.attrs["vary"][1] == "vehicle.max_speed=2.0:3.0"  # its bounds
    vary = {"learning.gain": np.array([0.4, 0.8]), "reference.dwell": [5.0, 10.0, 20.0]}
    grid = clpt.run_ensemble(PAPER, vary)
    assert dict(grid.unstack().clpe_rms_whole.sizes) == {
        "learning.gain": 2,
        "reference.dwell": 3,
    }


def called(name):
    """A system with a parameter of a name."""
    rate = lambda t, x, u, p: -p[name] * x  # noqa: E731
    return system(rate, outputs=["y[0]", "y[1]"], states=["x", "w"], params={name: 1.0})


MISTAKES = [  # a diagram, what varies, what else is given, the sentence
    (
        lag(),
        {"tua": [1]},
        {},
        "tua cannot vary; did you mean tau\\? May vary: tau, lag.tau, x",
    ),
    (lag(), {"lag.tua": [1]}, {}, r"lag\.tua cannot vary; did you mean lag\.tau\?"),
    (lag(), {"tau[0]": [1.0]}, {}, r"tau\[0\] is not an element of tau"),
    (
        lag(),
        {"tau": 2.0},
        {},
        "tau = 2.0: must be a list of values without labels, a range",
    ),
    (lag(), {"tau": []}, {}, "must be a list of values"),
    (lag(), {"tau": ["a", "b"]}, {}, "each value must be a number"),
    (lag(), {"tau": [[1.0, 2.0]]}, {}, "each value must be a number"),
    (lag(), {"tau": [np.nan]}, {}, r"tau = \[NaN\]: each value must be a number"),
    (lag(), {"tau": stats.uniform(0.5, 1)}, {}, "members: is required for ranges and"),
    (lag(), {"tau": stats.norm([0, 1], 1)}, {"members": 3}, "must be a list of values"),
    (lag(), {"tau": [1.0, 2.0]}, {"members": 3}, "this grid must have 2 members"),
    (
        lag(),
        {"tau": [1]},
        {"timepts": None},
        "timepts: is required to run a diagram many times",
    ),
    (
        lag(),
        {"tau": [1]},
        {"timepts": [0.0]},
        "timepts = .*: must be at least two increasing times",
    ),
    (lag(), {"tau": [1]}, {"timepts": ["0", "1"]}, r"timepts = .*: must be"),
    (
        lag(),
        {"tau": [1]},
        {"times": [1.0]},
        "times: is for a scenario; a diagram has timepts. Le",
    ),
    (
        lag(),
        {"tau": [1]},
        {"method": "euler"},
        "method = 'euler': must be one of auto, dop853",
    ),
    (lag(), {"tau": [1]}, {"rtol": -1.0}, "rtol = -1.0: must be a number, 0 or more"),
    (lag(), {"tau": [1]}, {"params": {"tua": 1.0}}, "unknown parameter 'tua'"),
    (
        lag(),
        {"tau": [1]},
        {"initial_state": [1.0, 2.0]},
        "initial_state = .*: must have 1 finite",
    ),
    (
        springs(),
        {"one.K": [[1, 2]], "one.K[0]": [1]},
        {},
        r"one\.K\[0\] and one\.K are the same num",
    ),
    (springs(), {"one.turns": [1.0]}, {}, r"one\.turns cannot vary; may vary: one\.K"),
    (springs(), {"one.K[2]": [1.0]}, {}, r"one\.K\[2\] is not an element of one\.K"),
    (springs(), {"one.K[-1]": [1.0]}, {}, r"one\.K\[-1\] is not an element of one\.K"),
    (mrac(), {"a": [1], "plant.a": [1]}, {}, r"plant\.a and a are the same number"),
    (
        PAPER,
        {"learning.gain": [1.0]},
        {},
        "timepts: is for a diagram. Leave it out, or",
    ),
    (
        two_shapes([1, 2]),
        {"K": [1, 2]},
        {},
        r"K = \[1.*\]: each value must be an array of shape",
    ),
    (
        called("x"),
        {"x": [1.0]},
        {},
        "x is more than one of a parameter, an initial state and",
    ),
    (
        called("member"),
        {"member": [1.0]},
        {},
        "member is used twice as a name in the result",
    ),
    (
        called("y_final"),
        {"y_final": [1.0]},
        {},
        "y_final is used twice as a name in the result.",
    ),
    (
        called("y_index"),
        {"y_index": [1.0]},
        {},
        "y_index is used twice as a name in the result",
    ),
]


@pytest.mark.parametrize(("made", "vary", "more", "sentence"), MISTAKES)
def test_mistakes_are_one_sentence(tmp_path, made, vary, more, sentence):
    with pytest.raises(ClptError, match=rf"\A.*{sentence}.*\Z"):
        clpt.run_ensemble(
            made, vary, **{"timepts": TIMES, "out": tmp_path / "e.zarr", **more}
        )
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("label", ["\\", "a\\b", "[0]"])
def test_a_name_that_zarr_does_not_have_is_told(label, tmp_path):
    block = system(lambda t, x, u, p: -x, states=[label], outputs=[label], inputs=["u"])
    call = partial(
        clpt.run_ensemble, block, {"u": [1.0, 2.0]}, timepts=TIMES, trajectories=True
    )
    with pytest.raises(clpt.DataError, match=r"Zarr has no name .* Rename it"):
        call(out=tmp_path / "e.zarr")
    assert not list(tmp_path.iterdir())
    assert call().status.values.tolist() == [1, 1]  # in memory any name is allowed


def test_an_output_named_as_a_summary_of_another_is_refused():
    ports = {
        "inputs": 0,
        "states": 1,
        "outputs": ["y", "y_final"],
        "params": {"k": 1.0},
    }
    functions = (lambda t, x, u, p: -p["k"] * x, lambda t, x, u, p: [x[0], 7.0])
    two, given = (
        control.nlsys(*functions, **ports),
        {"timepts": TIMES, "initial_state": 1.0},
    )
    with pytest.raises(
        ClptError, match=r"y_final is used twice as a name in the result."
    ):
        clpt.run_ensemble(two, {"k": [1.0]}, trajectories=True, **given)
    assert clpt.run_ensemble(two, {"k": [1.0]}, **given).y_final_final.values == 7.0


def test_states_and_inputs_bring_their_units():
    ports = {"inputs": {"v": 1}, "states": {"s": 1, "w": 2}}
    ports["units"] = {"v": "m/s", "s": "m", "w": "kg"}
    sail = clpt.Block(
        "sail", update=lambda t, x, u, p: {"s": u.v - x.s, "w": -x.w}, **ports
    )
    loop = clpt.connect([sail], external="v", name="sailing")
    vary = {"v": [1.0, 2.0], "sail_s[0]": [0.0, 1.0], "sail_w[0]": [0.0]}
    data = clpt.run_ensemble(loop, vary, timepts=TIMES)
    units = {"v": "m/s", "sail_s[0]": "m", "sail_w[0]": "kg", "s_rms": "m"}
    assert {name: data[name].attrs["units"] for name in units} == units
    axes = data.unstack().s_rms[..., 0].plot.contourf().axes
    assert axes.get_xlabel() == "sail_s[0] [m]"


def test_values_that_vary_have_the_units_of_their_keys():
    words = [
        "flow.parameters~normal:0.1",
        "vehicle.feedback=0.5:2",
        "reference.dwell=[19, 20]",
    ]
    words += ["learning.position~normal:1", "learning.gain=1:2"]
    data = clpt.run_ensemble(PAPER.with_values({"units.length": "km"}), words, 2)
    units = {
        "flow.parameters": "km s-1",
        "learning.position": "km",
        "reference.dwell": "s",
    }
    units |= {"vehicle.feedback": "s-1"}
    units["learning.gain"] = (
        None  # 1/s2 for alpha, less a length squared for K and Gamma
    )
    assert {
        key: data[key].attrs.get("units") for key in data.coords if "." in key
    } == units


def test_an_ensemble_says_what_it_is_and_is_written_as_netcdf(tmp_path):
    drawn = clpt.run_ensemble(lag(), {"tau": "1:2"}, 3, timepts=TIMES)
    grid = clpt.run_ensemble(lag(), {"tau": [1.0, 2.0]}, timepts=TIMES).reset_index(
        "member"
    )
    for data in (drawn, grid):
        data.to_netcdf(tmp_path / "many.nc")
        with xarray.open_dataset(tmp_path / "many.nc") as read:
            xarray.testing.assert_equal(read, data)
        assert data.clpt.kind == "ensemble"
        assert repr(data.clpt) == "<clpt of a dataset: ensemble Ensemble of lag>"
        assert (
            data.clpt.plot().lines[0].get_xdata().tolist() == data.tau.values.tolist()
        )
        made = clpt.report(data, tmp_path / "page.html")
        assert made["title"] == "Ensemble of lag"


def pushed():
    """y' = a + b + c + d from 0, of which the rms on [0, 1] is (a + b + c + d)/3^(1/2)."""
    values = {"a": 0.0, "b": 0.0, "c": 0.0, "d": 0.0}
    return control.nlsys(
        lambda t, x, u, p: [sum(p.get(name, 0.0) for name in "abcd")],
        lambda t, x, u, p: x,
        **{"inputs": 0, "states": ["y"], "outputs": ["y"], "params": values},
        name="pushed",
    )


FEW, MANY = [1.0, 2.0, 4.0], np.arange(1.0, 11.0)
SWEEPS = {
    "colours": (
        {"a": MANY, "b": FEW},
        "30 members",
        ["a"],
        ["b = 1", "b = 2", "b = 4"],
    ),
    "the longer along x": (
        {"a": FEW, "b": MANY},
        "30 members",
        ["b"],
        ["a = 1", "a = 2", "a = 4"],
    ),
    "panels": (
        {"a": FEW, "b": FEW, "c": [5.0, 7.0]},
        "18 members\nc = 5",
        ["a", "a"],
        ["b = 1", "b = 2", "b = 4"],
    ),
    "held": (
        {"a": FEW, "b": FEW, "c": [5.0, 7.0], "d": [0.5, 0.6]},
        "36 members, 18 of them with d = 0.5\nc = 5",
        ["a", "a"],
        ["b = 1", "b = 2", "b = 4"],
    ),
    "the longest of three": (
        {"a": FEW, "b": FEW, "c": MANY},
        "90 members\nb = 1",
        ["c", "c", "c"],
        ["a = 1", "a = 2", "a = 4"],
    ),
    "not drawn apart": (
        {key: [*FEW, 5.0, 6.0] for key in "abc"},
        "125 members; c varies, too",
        ["a"],
        ["b = 1", "b = 2", "b = 4", "b = 5", "b = 6"],
    ),
    "the shortest in panels": (
        {"a": [*FEW, 5.0, 6.0], "b": FEW, "c": [1.0, 2.0, 3.0, 4.0, 5.0]},
        "75 members\nb = 1",
        ["a", "a", "a"],
        ["c = 1", "c = 2", "c = 3", "c = 4", "c = 5"],
    ),
}


@pytest.mark.parametrize("name", SWEEPS)
def test_a_sweep_is_drawn_over_the_numbers_that_vary(name):
    vary, title, labels, legend = SWEEPS[name]
    data = clpt.run_ensemble(pushed(), vary, timepts=np.linspace(0, 1, 101))
    panels = np.ravel(data.clpt.plot())
    assert panels[0].get_title("left") == title
    assert [panel.get_xlabel() for panel in panels] == labels
    texts = [text.get_text() for text in panels[-1].get_legend().get_texts()]
    assert texts == legend
    of_panels = vary.get("c" if len(panels) == 2 else "b", FEW)
    for panel, value in zip(
        panels, of_panels if len(panels) > 1 else [0.0], strict=False
    ):
        for line, text in zip(panel.lines, legend, strict=True):
            x, rms = line.get_data()
            if name == "not drawn apart":
                continue
            others = float(text.split()[2]) + value + vary.get("d", [0.0])[0]
            np.testing.assert_allclose(rms, (x + others) / 3**0.5, rtol=1e-2)


def test_a_sweep_of_two_long_ranges_is_a_map():
    data = clpt.run_ensemble(
        pushed(), {"a": MANY, "b": MANY, "c": [5.0, 7.0]}, timepts=[0.0, 0.5, 1.0]
    )
    panels = data.clpt.plot()
    assert [panel.get_ylabel() for panel in panels] == ["b", ""]
    shown = panels[1].collections[0]
    a, b = MANY, MANY[:, None]
    by_trapezoids = 0.5 * (0.0 / 2 + 0.25 + 1.0 / 2)
    np.testing.assert_allclose(
        shown.get_array(), (a + b + 7.0) * by_trapezoids**0.5, rtol=1e-9
    )
    assert shown.norm.vmin == panels[0].collections[0].norm.vmin
    corners = shown.get_coordinates()  # cells fill the panel, each about its numbers
    np.testing.assert_allclose((corners[0, 1:, 0] + corners[0, :-1, 0]) / 2, MANY)
    np.testing.assert_allclose((corners[1:, 0, 1] + corners[:-1, 0, 1]) / 2, MANY)
    assert not [line for line in panels[1].get_xgridlines() if line.get_visible()]


def test_one_member_that_diverged_leaves_the_others_their_colours():
    """y' = r y from 1: the rms to t = 1 is ((e^(2 r) - 1)/(2 r))^(1/2), 2e8 for r = 20."""
    grows = control.nlsys(
        lambda t, x, u, p: [p["r"] * p["s"] * x[0]],
        **{"inputs": 0, "states": ["y"], "params": {"r": 1.0, "s": 1.0}},
        name="grows",
    )
    rates = np.append(np.linspace(-1.0, 1.0, 11), 20.0)
    data = clpt.run_ensemble(
        grows,
        {"r": rates, "s": np.linspace(0.9, 1.0, 9)},
        timepts=np.linspace(0, 1, 101),
        initial_state=[1.0],
    )
    [panel] = np.ravel(data.clpt.plot())
    shown = panel.collections[0]
    colours = shown.norm(shown.get_array()).filled()
    low, high = np.quantile(colours[:, :11], [0.05, 0.95])
    assert high - low > 0.05  # 1e-8 on linear colours from 0 to 2e8


def test_members_without_a_grid_are_squares_at_their_numbers():
    vary = {"a": "1:9", "b": "1:9"}
    data = clpt.run_ensemble(pushed(), vary, 20, timepts=[0.0, 0.5, 1.0])
    (panel,) = np.ravel(data.clpt.plot())[:1]
    shown = panel.collections[0]
    np.testing.assert_array_equal(shown.get_offsets(), np.c_[data.a, data.b])
    by_trapezoids = 0.5 * (0.0 / 2 + 0.25 + 1.0 / 2)
    a, b = data.a.values, data.b.values
    np.testing.assert_allclose(
        shown.get_array(), (a + b) * by_trapezoids**0.5, rtol=1e-9
    )


@pytest.mark.parametrize("width", [5.0, 7.0, 12.0])
@pytest.mark.parametrize("b", [MANY, FEW])
def test_numbers_below_small_axes_do_not_overlap(width, b):
    vary = {"a": np.linspace(0.5101, 0.5303, 12), "b": b, "c": [5.0, 6.0, 7.0]}
    data = clpt.run_ensemble(pushed(), vary, timepts=[0.0, 0.5, 1.0])
    figure, axes = plt.subplots(1, 3, figsize=(width, 3), layout="constrained")
    data.clpt.plot(ax=axes)
    figure.draw_without_rendering()
    for panel in axes:
        numbers = [text for text in panel.get_xticklabels() if text.get_text()]
        boxes = [text.get_window_extent() for text in numbers]
        low, high = panel.get_xlim()
        shown = [
            box
            for box, text in zip(boxes, numbers, strict=True)
            if low <= text.get_position()[0] <= high
        ]
        assert shown
        for left, right in pairwise(shown):
            assert left.x1 < right.x0


@pytest.mark.parametrize("duration", [20.0, 400.0])  # 0 and 2 cycles
def test_an_unstacked_ensemble_has_the_figures_of_its_members(duration):
    vary = {"basis.kernel": ["exponential", "gaussian"]}
    data = clpt.run_ensemble(PAPER.with_values({"run.duration": duration}), vary)
    mark = f"flow_parameter_error mark {duration:g} (m/s)"
    summaries = [ensemble_summary(one)["summaries"] for one in (data, data.unstack())]
    assert summaries[0] == summaries[1]
    assert len([name for name in summaries[0] if "cycle" in name]) == duration // 200
    errors = data.flow_parameter_error.sel(mark=duration)
    assert summaries[1][mark][::4] == np.percentile(errors, (5, 95)).tolist()
    table = data.clpt.table()
    assert table[mark.replace("m/s", "m s-1")].tolist() == errors.values.tolist()
    assert len(np.ravel(data.unstack().clpt.plot())) == 2


def test_a_state_whose_label_is_a_word_of_the_function_varies():
    def rate(t, x, u, p):
        own = dict(zip(("s", "i"), x, strict=True))
        return [-own["s"] * own["i"], own["s"] * own["i"] - p.get("k", 0.3) * own["i"]]

    spread = system(rate, states=["s", "i"], outputs=["s", "i"])
    given = {"timepts": TIMES, "initial_state": [0.5, 0.1], "trajectories": True}
    found = clpt.run_ensemble(spread, {"s": [0.8, 0.9]}, **given)
    assert found.s_.values[:, 0].tolist() == [0.8, 0.9]
    assert found.s_final.equals(found.s_[:, -1].drop_vars("time"))
    one = clpt.simulate(spread, TIMES, initial_state=[0.9, 0.1])
    np.testing.assert_allclose(found.i_final.values[-1], one.i.values[-1], rtol=1e-7)


def test_an_interrupt_waits_for_one_member_that_python_runs():
    begun = set()

    def rate(t, x, u, p):
        begun.add(p["k"])
        return [-p["k"] * float(str(x[0]))]

    def stop(done):
        if done:
            raise KeyboardInterrupt

    given = {"timepts": TIMES, "threads": 1, "progress": stop}
    with (
        pytest.warns(UserWarning, match="runs in Python"),
        pytest.raises(KeyboardInterrupt),
    ):
        clpt.run_ensemble(system(rate, params={"k": 2.0}), "k=1:2", 200, **given)
    assert len(begun) < 20  # those that are tried before, and one or two


def test_progress_is_a_bar_on_standard_error(monkeypatch, capsys):
    monkeypatch.setattr(time, "monotonic", count(step=20.0).__next__)
    lag = system(lambda t, x, u, p: [-p["k"] * x[0]], params={"k": 2.0})
    given = {"timepts": TIMES, "threads": 1}
    clpt.run_ensemble(lag, "k=1:2", 4, progress=True, **given)
    assert "of 4 members" in capsys.readouterr().err
    for quiet in (None, False):
        clpt.run_ensemble(lag, "k=1:2", 4, progress=quiet, **given)
    assert capsys.readouterr().err == ""


def test_units_and_times_of_labelled_levels():
    """Units of levels are those of the system; a series is not a list of constant inputs."""
    plant = control.nlsys(
        lambda t, x, u, p: p["g"] * u,
        inputs="u",
        outputs="p",
        states="p",
        params={"g": 1.0},
        name="plant",
    )
    plant.units = {"u": "m/s", "g": "km", "p": "m"}
    for key, right, wrong in (
        ("u", "m s-1", "km/h"),
        ("g", "km", "m"),
        ("p", "m", "cm"),
    ):
        levels = xarray.DataArray([2.0, 3.0], dims="i", attrs={"units": right})
        run = clpt.run_ensemble(plant, {key: levels}, timepts=[0, 1.0], inputs=0.0)
        assert run[key].values.tolist() == [2, 3]
        said = f"vary\\['{key}'\\]: is in '{wrong}'; must be in"
        levels.attrs["units"] = wrong
        with pytest.raises(ClptError, match=said):
            clpt.run_ensemble(plant, {key: levels}, timepts=[0, 1.0])
    gain = xarray.DataArray([0.4, 0.8], dims="i", attrs={"units": "furlong"})
    with pytest.raises(ClptError, match="is in 'furlong'; must be in"):
        clpt.run_ensemble(PAPER, {"reference.dwell": gain})
    times = np.array([0.0, 1.0, 3.0])
    dates = np.datetime64("2024-05-01", "ns") + (1e9 * times).astype("m8[ns]")
    for series in (
        pandas.Series([1.0, 2.0, 3.0], times),
        pandas.Series([1.0, 2.0, 3.0], dates),
        xarray.DataArray([1.0, 2.0, 3.0], {"time": times}, "time"),
        xarray.DataArray([1.0, 2.0, 3.0], {"when": ("k", dates)}, "k"),
    ):
        with pytest.raises(ClptError, match="a list of values without labels"):
            clpt.run_ensemble(plant, {"u": series}, timepts=[0, 1.0])
    run = clpt.run_ensemble(plant, {"u": pandas.Series([1.0, 2.0])}, timepts=[0, 1.0])
    assert run.p_final.values.ravel() == pytest.approx([1, 2])
