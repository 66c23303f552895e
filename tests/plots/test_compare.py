"""Several runs in one figure, units of ports, and dimensions named after them."""

from functools import partial

import control
import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray
from compared_loops import gauge, lemniscate, loop, tank
from error_sentences import says

import clpt_control as clpt

TIMES = np.linspace(0.0, 4.0, 41)
SCENARIO = clpt.paper_scenario().with_values(
    {"run.duration": 60.0, "run.output_step": 0.5}
)
with plt.style.context("clpt_control.data.house"):
    COLOURS = plt.rcParams["axes.prop_cycle"].by_key()["color"]


def legends(axes):
    return [
        one.get_text() for ax in np.ravel(axes) for one in ax.get_legend().get_texts()
    ]


@pytest.fixture(scope="module")
def of_tanks():
    """Two runs of one diagram."""
    return {
        a: clpt.simulate(loop(), TIMES, 1.0, params={"tank.a": float(a)})
        for a in ("0.5", "1")
    }


@pytest.fixture(scope="module")
def of_scenarios():
    """Two runs of the paper's loop, the second longer."""
    other = SCENARIO.with_values({"learning.gain": 2.0, "run.duration": 80.0})
    return {"0.8": clpt.simulate(SCENARIO), "2": clpt.simulate(other)}


def test_the_legend_of_what_is_learned_stands_above_the_data():
    """Four functions make a legend of two rows."""
    four = {"centers": [[0, 0], [10, 10], [5, 5], [-4, 2]], "widths": [5.0] * 4}
    four |= {"kernel": "exponential", "periods": [12.42, 10.42, 24.42, 30.0]}
    theta = [[1.0, 0.4, 0.8, 0.2], [0.9, 0.4, 0.8, -0.3]]
    without = {"model.parameters": None, "learning.parameters": None}
    scenario = SCENARIO.with_values(
        {"basis": four, "flow.parameters": theta, **without}
    )
    for ax in clpt.simulate(scenario).clpt.plot("learning"):
        ax.figure.canvas.draw()
        box = ax.get_legend().get_window_extent()
        lines = [line for line in ax.lines if line.get_label()[0] != "_"]
        tops = [ax.transData.transform(line.get_xydata())[:, 1].max() for line in lines]
        assert max(tops) < box.y0


def test_dimensions_are_named_after_ports_and_count_from_0():
    run = clpt.simulate(loop(), TIMES, 1.0)
    assert run.h.dims == ("time", "h_index")
    assert run.v.dims == ("time", "v_index")
    assert run["mean"].dims == run.q.dims == ("time",)
    assert run.h_index.values.tolist() == [0, 1]
    assert run.h_index.attrs["long_name"] == "signal of h, counted from 0"
    np.testing.assert_array_equal(
        run.h.sel(h_index=1), run.states.sel(state="tank_h[1]")
    )


def test_signals_that_python_control_picks_keep_their_names():
    """``system[[0, 2], 1]`` has the outputs y[0] and y[2], and the input u[1]."""
    picked = control.ss(-np.diag([1.0, 2.0, 3.0]), np.ones((3, 2)), np.eye(3), 0)[
        [0, 2], 1
    ]
    run = clpt.simulate(picked, TIMES, 1.0)
    assert list(run.data_vars) == ["y[0]", "y[2]", "u[1]", "states"]
    wanted = (1.0 - np.exp(-3.0 * TIMES)) / 3.0
    np.testing.assert_allclose(run["y[2]"], wanted, atol=1e-8)
    found = clpt.fit_parameters(picked, {"y[2]": wanted}, {"x0.x[2]": 1.0}, TIMES, 1.0)
    assert found.values == pytest.approx({"x0.x[2]": 0.0}, abs=1e-7)
    slopes = clpt.sensitivity(picked, TIMES, "y[2]", "x0.x[2]", 1.0)
    np.testing.assert_allclose(slopes["y[2]"][:, 0], np.exp(-3.0 * TIMES), atol=1e-8)


def test_names_that_would_be_one_are_two():
    """Of an output called time, of y beside a port y[0], of a dimension, of what varies."""
    rates = lambda t, x, u, p: [-x[0], -2.0 * x[1]]  # noqa: E731
    for names in (["time", "time_"], ["y", "y[0]"]):
        pair = control.nlsys(
            rates, inputs=0, outputs=names, states=["y", "y_"], name="pair"
        )
        run = clpt.simulate(pair, [0.0, 1.0], 0.0, 1.0)
        last = [
            float(one[-1]) for name, one in run.data_vars.items() if name != "states"
        ]
        assert last == pytest.approx(np.exp([-1.0, -2.0]))
    data = {"y": np.exp(-TIMES), "y[0]": 3.0 * np.exp(-2.0 * TIMES)}
    found = clpt.fit_parameters(pair, data, {"x0": 0.5}, TIMES)
    assert [*found.values.values()] == pytest.approx([1.0, 3.0])
    two = control.ss(
        -np.eye(2), np.ones((2, 1)), np.eye(2), 0, outputs=["x[0]", "x[1]"]
    )
    both = {"x": np.zeros((len(TIMES), 2)), "x[0]": 0 * TIMES}
    with pytest.raises(clpt.ClptError, match=r"data: x\[0\] is given twice"):
        clpt.fit_parameters(two, both, {"x0": 0.5}, TIMES)
    sizes, wide = {"h": 2, "h_index": 1}, lambda t, x, u, p: {"h": [t, t], "h_index": t}
    run = clpt.simulate(clpt.Block("a", output=wide, outputs=sizes), [0.0, 1.0])
    assert (run.h.dims, run.h_index.dims) == (("time", "h_index_"), ("time",))
    axes = run.clpt.plot()
    assert [line.get_label() for line in axes[0].lines] == ["h[0]", "h[1]"]


def test_units_of_ports_are_those_of_the_run():
    """A signal whose maker says no unit has that of who takes it; a sum has none."""
    valve = clpt.parts.saturation(0, 1, u="w", y="q")
    made = clpt.connect([valve, tank(), gauge()], external="w")
    run, units = clpt.simulate(made, TIMES, TIMES), {"h": "m", "v": "V", "q": "m3/s"}
    units |= {"mean": None, "w": None}
    assert {name: run[name].attrs.get("units") for name in units} == units
    axes = run.clpt.plot()
    assert {ax.get_ylabel() for ax in axes} == {
        "h (m)",
        "v (V)",
        "mean",
        "q (m³/s)",
        "w",
    }
    drawn = clpt.draw(made).svg
    assert [name in drawn for name in ("h (m)", "q (m3/s)", "mean (")] == [
        True,
        True,
        False,
    ]
    a, b = tank().copy(name="a"), tank().copy(name="b")
    ports = {
        "inplist": ["a.q[0]"],
        "outlist": [["a.h[0]", "b.h[0]"], "a.h[1]", "b.h[1]"],
    }
    ports |= {"outputs": ["sum", "one", "rest"], "connections": [["b.q[0]", "a.h[0]"]]}
    run = clpt.simulate(control.interconnect([a, b], **ports), TIMES, 1.0)
    assert [run[name].attrs.get("units") for name in ("sum", "one")] == [None, "m"]


def test_units_go_along_with_samples_a_file_and_a_new_name(tmp_path):
    moved = clpt.Sampled(gauge(), 0.5)
    run = clpt.simulate(clpt.connect([tank(), moved], external="q"), TIMES, 1.0)
    assert run.v.attrs["units"] == "V"
    assert dict(tank({}).copy().units) == {}
    ports = {
        "inputs": {"s": 2},
        "states": {"w": 2},
        "units": {"s": "km/h", "w": "km/h"},
    }
    slow = clpt.Block("slow", update=lambda t, x, u, p: {"w": u.s - x.w}, **ports)
    made = clpt.closed_loop(SCENARIO, insert={("v_x", "vehicle"): slow})
    (part,) = (one for one in made.syslist if one.name == "slow")
    assert part.units_of("input") == part.units_of("output") == ["km/h"] * 2
    run = clpt.simulate(made, [0.0, 0.1])
    units = {"w": "km/h", "v_z": "m s-1", "psi": "m s-1", "flow_z": "m s-1"}
    assert {name: run[name].attrs["units"] for name in units} == units
    clpt.save_run(run, tmp_path / "run.nc")
    again = clpt.load_run(tmp_path / "run.nc")
    np.testing.assert_array_equal(again.position, run.position)
    assert again.w.attrs["units"] == "km/h"


@pytest.mark.parametrize("units", [{"g": "m"}, {"h": ""}, {"h": 3}, {"h": "m\n"}])
def test_units_that_are_none_are_refused(units):
    says(clpt.ClptError, r"\A.*units.*\Z", tank, units)


def test_runs_of_a_diagram_are_told_apart(of_tanks):
    (ax, *_) = clpt.compare(of_tanks)
    assert legends(ax) == ["0.5: h[0]", "0.5: h[1]", "1: h[0]", "1: h[1]"]
    assert [line.get_color() for line in ax.lines] == np.repeat(COLOURS[:2], 2).tolist()
    assert ax.lines[0].get_linestyle() != ax.lines[1].get_linestyle()
    drawn = [line.get_ydata() for line in ax.lines]
    np.testing.assert_array_equal(
        drawn, np.vstack([one.h.T for one in of_tanks.values()])
    )


CART = clpt.Block(
    "cart",
    update=lambda t, x, u, p: {"pos": x.vel, "vel": u.force - p.drag * x.vel},
    inputs={"force": 1},
    states={"pos": 1, "vel": 1},
    output=lambda t, x, u, p: {"pos": x.pos},
    outputs={"pos": 1},
    parameters={"drag": 0.5},
    units={"pos": "m", "vel": "m/s"},
)


@pytest.fixture(scope="module")
def of_carts():
    """Three runs of a cart under a constant force."""
    drags = (0.5, 1.0, 2.0)
    return [
        clpt.simulate(CART, TIMES, 1.0, params={"cart.drag": drag}) for drag in drags
    ]


def test_signals_and_states_are_drawn_by_name(of_carts):
    run = of_carts[0]
    ax = run.clpt.plot("pos")
    np.testing.assert_array_equal(ax.lines[0].get_xydata().T, [run.time, run.pos])
    assert (ax.get_ylabel(), ax.get_legend()) == ("pos (m)", None)
    _, mine = plt.subplots()
    assert run.clpt.plot(["pos", "vel"], ax=mine) is mine
    vel = run.states.sel(state="vel")
    np.testing.assert_array_equal(mine.lines[1].get_ydata(), vel)
    assert legends(mine) == ["pos (m)", "vel"]
    assert mine.lines[0].get_color() != mine.lines[1].get_color()
    _, two = plt.subplots(2)
    run.clpt.plot(["pos", "force"], ax=two)
    np.testing.assert_array_equal(two[1].lines[0].get_ydata(), run.force)
    assert len(np.ravel(run.clpt.plot())) == 2  # a constant reference too
    still = clpt.simulate(CART, TIMES, initial_state=[0.0, 1.0])
    assert len(np.ravel(still.clpt.plot())) == 1  # not an input of 0
    by_unit = run.clpt.plot(["force", "pos", "vel"])
    assert [len(ax.lines) for ax in by_unit] == [2, 1]
    assert [ax.get_ylabel() for ax in by_unit] == ["", "pos (m)"]
    assert run[["force"]].clpt.plot().has_data()
    says(clpt.ArgumentError, "Did you mean 'pos'", run.clpt.plot, "poss")


def test_a_signal_of_several_runs_has_one_legend_with_formulas(of_carts):
    labels = ["$k_d$ = 0.5", "$k_d$ = 1", "2 $"]
    _, mine = plt.subplots(figsize=(3.5, 2.2), layout="constrained")
    assert clpt.compare(of_carts, "pos", labels=labels, ax=mine) is mine
    assert legends(mine) == ["$k_d$ = 0.5", "$k_d$ = 1", r"2 \$"]
    colours = [line.get_color() for line in mine.lines]
    assert colours == COLOURS[:3]
    mine.figure.canvas.draw()
    legend, frame = mine.get_legend().get_window_extent(), mine.get_window_extent()
    assert frame.x0 < legend.x0 < legend.x1 < frame.x1 + 1
    moving = [
        clpt.simulate(CART, TIMES, TIMES, params={"cart.drag": d}) for d in (1.0, 2.0)
    ]
    top, bottom = clpt.compare({"1": moving[0], "2": moving[1]})
    assert (legends(top), bottom.get_legend()) == (["1", "2"], None)
    for given in (labels[:2], []):
        says(clpt.ArgumentError, "labels: has", clpt.compare, of_carts, labels=given)


def test_a_true_value_of_several_runs_is_drawn_once(of_scenarios):
    theta = np.array(SCENARIO.flow.parameters)
    theta[1, 1] = 0.1
    values = {"flow.parameters": theta.tolist()}
    other = clpt.simulate(SCENARIO.with_values(values))
    ax, _ = clpt.compare([of_scenarios["0.8"], other], "learning", axis=2)
    truths = {}
    for line in ax.lines:
        if line.get_gid() == "true value":
            truths.setdefault(line.get_ydata()[0], []).append(line.get_color())
    grey = "#666666"
    assert truths == {0.9: [grey], 0.4: [COLOURS[0]], 0.8: [grey], 0.1: [COLOURS[1]]}


@pytest.mark.parametrize(
    ("plot", "count"), [(None, 7), ("track", 1), ("clpe", 2), ("learning", 2)]
)
def test_runs_of_scenarios_are_told_apart(plot, count, of_scenarios):
    axes = clpt.compare(of_scenarios, plot)
    assert np.size(axes) == count
    for ax in np.ravel(axes):
        assert {*COLOURS[:2]} <= {line.get_color() for line in ax.lines}
        # marked, in black and white
        named = [one for one in ax.lines if one.get_label()[0] != "_"]
        named = [one for one in named if one.get_linestyle() != "None"]
        marks = {line.get_color(): line.get_marker() for line in named}
        assert marks[COLOURS[0]] != marks[COLOURS[1]]
        assert {text.partition(":")[0] for text in legends(ax)} == {"0.8", "2"}
    if plot == "learning":
        assert axes[0].get_xlim()[1] == 80.0
    if plot == "track":
        runs, pairs = of_scenarios.values(), [axes.lines[:2], axes.lines[3:5]]
        for (track, line), run in zip(pairs, runs, strict=True):
            np.testing.assert_array_equal(track.get_xydata(), run.position)
            np.testing.assert_array_equal(line.get_xydata(), run.predicted_position)
            assert line.get_linestyle() == "--"
        assert axes.get_xlim()[1] > max(abs(one.position).max() for one in runs)


@pytest.mark.long
@pytest.mark.parametrize("plot", ["clpe", "learning", "run"])
def test_legends_of_several_runs_lie_beside_and_leave_the_axes_their_width(
    plot, of_scenarios
):
    def drawn(axes):
        np.ravel(axes)[0].figure.canvas.draw()
        return np.ravel(axes), [one.get_window_extent() for one in np.ravel(axes)]

    run = of_scenarios["0.8"]
    axes, frames = drawn(clpt.compare(dict.fromkeys("abcd", run), plot))
    legends = [one.get_legend().get_window_extent() for one in axes]
    for k, legend in enumerate(legends):
        assert not any(legend.overlaps(other) for other in frames + legends[:k])
    if plot == "run":
        alone, beside = (
            drawn(one)[1] for one in (run.clpt.plot(), clpt.compare(of_scenarios))
        )
        assert (
            min(b.width / a.width for a, b in zip(alone[1:], beside[1:], strict=True))
            > 0.8
        )


def test_runs_that_are_cut_or_joined(of_tanks, of_scenarios):
    a, b = of_tanks.values()
    cut = a.isel(time=slice(3, 20))
    assert len(cut.clpt.plot()[0].lines[0].get_xdata()) == 17
    one = a.isel(h_index=0)[["h"]].clpt.plot()
    np.testing.assert_array_equal(one.lines[0].get_ydata(), a.h[:, 0])
    both = xarray.concat([a, b], "run", data_vars="all").clpt.plot()
    assert legends(both[0])[:2] == ["h[0] run 0", "h[0] run 1"]
    np.testing.assert_array_equal(both[0].lines[1].get_ydata(), b.h[:, 0])
    paper = of_scenarios["0.8"]
    for plot, run in {
        "": a.isel(time=3),
        "track": paper.isel(time=3),
        "clpe": xarray.concat([paper, paper], "run", data_vars="all"),
        "learning": xarray.concat([paper, paper], "time", data_vars="minimal"),
    }.items():
        says(clpt.DataError, r"\A.*\Z", run.clpt.plot, plot)
    ax = paper.clpt.plot("track", label="mine", color="black")
    assert (ax.lines[0].get_color(), legends(ax)[0]) == ("black", "mine: track")


def test_what_cannot_be_compared_is_one_sentence(of_tanks):
    a = of_tanks["0.5"]
    other, unknown = a.copy(deep=True), a.copy(deep=True)
    other.h.attrs["units"] = "km"
    del unknown.h.attrs["units"]
    clpt.compare({"a": a, "b": unknown})
    for runs, plot, said in (
        ({str(k): a for k in range(7)}, None, ""),
        ({"a": a}, "map", ""),
        ({"a": a}, "track", ""),
        ({"a": a, "b": a[["h"]]}, None, r"the same signals; give plot=\['h'\]"),
        ({"a": a[["v"]], "b": a[["h"]]}, None, r"draw each, run\.clpt\.plot\(\)"),
        ({"a": a, "b": other}, None, "not all runs have h in one unit: m, km"),
    ):
        says(clpt.ClptError, rf"\A.*{said}.*\Z", clpt.compare, runs, plot)
    assert len(clpt.compare({"a": a, "b": a[["h"]]}, ["h"]).lines) == 4


@pytest.mark.long
def test_names_of_a_refused_plot_are_plots_when_followed(of_tanks, of_scenarios):
    tanks, scenarios = of_tanks["0.5"], of_scenarios["0.8"]
    for draw, names in (
        (tanks.clpt.plot, [*tanks.data_vars]),
        (partial(clpt.compare, of_tanks), ["response", *tanks.data_vars]),
        (scenarios.clpt.plot, ["track", "map", "clpe", "learning", "signals"]),
        (partial(clpt.compare, of_scenarios), ["run", "track", "clpe", "learning"]),
    ):
        with pytest.raises(clpt.ArgumentError) as caught:
            draw("qqqqqqqq")
        listed = str(caught.value).partition("It has ")[2].split(", ")
        assert len({*listed}) == len(listed)
        assert {*names} - {"states"} <= {*listed}
        for name in listed[:6]:
            draw(name)
        plt.close("all")
    for name in ("map", "run"):
        says(clpt.ArgumentError, f"{name}': the run has no such", tanks.clpt.plot, name)


@pytest.mark.long
def test_no_waypoint_is_told_of_a_reference_of_ones_own(tmp_path):
    made = clpt.closed_loop(SCENARIO, replace={"reference": lemniscate()})
    outside, times = (
        clpt.closed_loop(SCENARIO, external="zc"),
        np.linspace(0.0, 60.0, 121),
    )
    zc = np.array([2 * np.cos(times / 20), np.sin(times / 10)])
    for run in (clpt.simulate(made, times), clpt.simulate(outside, times, zc)):
        ax = run.clpt.plot("track")
        words = legends(ax)
        assert words == ["track", "prediction", "desired position", "start"]
        np.testing.assert_allclose(ax.lines[2].get_xydata(), zc.T, atol=1e-12)
        for one in (ax, *run.clpt.plot("clpe")):
            words += [*legends(one), one.get_title(loc="left"), one.get_xlabel()]
        assert not [word for word in words if "waypoint" in word or "interval" in word]
    clpt.report(run, tmp_path / "page.html")
    text = (tmp_path / "page.html").read_text().partition('<h2 id="scenario"')[0]
    assert "waypoint" not in text.partition('id="excitation"')[0].lower()
    assert "waypoints" in legends(clpt.simulate(SCENARIO).clpt.plot("track"))


def test_what_is_held_between_samples_is_drawn_in_steps():
    """A delay of one sample before a lag: y is 0 until t = 1, then 1."""
    delay, lag = clpt.parts.delay(1.0, dt=1.0), clpt.parts.lag(0.5, u="y", y="z")
    loop = clpt.connect([delay, lag], external="u")
    run = clpt.simulate(loop, [0.0, 1.0, 2.0, 3.0], 1.0)
    for axes in (run.clpt.plot(), [run.clpt.plot("y"), run.clpt.plot("z")]):
        held, smooth, *_ = (ax.lines[0].get_drawstyle() for ax in np.ravel(axes))
        assert (held, smooth) == ("steps-post", "default")
