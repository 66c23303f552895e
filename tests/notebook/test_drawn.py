"""Plots on given axes, films, what a notebook shows, and `dataset.clpt`."""

import csv
import re
import sys
from dataclasses import replace

import control
import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray
from html_reader import Reader
from made_fields import uniform_field
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.quiver import Quiver
from PIL import Image, ImageSequence
from processes import ran
from scipy.io import loadmat
from sentences import says

import clpt_control as clpt
from clpt_control import save_run
from clpt_control.blocks.laws.paper import LEARNED_FLOW as LAW
from clpt_control.figures import BLUE, GREEN, figure_of, inline_svg, new_figure
from clpt_control.simulation.film import draw_samples

PLOTS = {  # what it draws -> name of a plot, how many axes
    "run": "track 1, clpe 2, learning 2, run 7, excitation 4",
    **{"team": "team 3", "diagram": "response 2", "ensemble": "ensemble 2", "design": "design 3"},
    "replay": "map 1, dive_clpe 1, current 3, replay 5",
}
PLOTS = [(kind, *one.split()) for kind, own in PLOTS.items() for one in own.split(", ")]
ROOMS = (getattr(clpt, room) for room in ("simulation", "ensemble", "theory", "replay", "currents"))
PUBLIC = {name: getattr(room, name) for room in ROOMS for name in room.__all__}
track_plot = clpt.simulation.track_plot


def test_all_plots_are_asked():
    asked = {f"{name}_plot" for _, name, _ in PLOTS}
    assert {name for name in PUBLIC if name.endswith("_plot")} == asked


@pytest.mark.parametrize(("kind", "name", "count"), PLOTS)
def test_on_given_axes(kind, name, count, made):
    """Something is drawn on each, nothing elsewhere, they come back; wrong ones are a sentence."""
    plot, count = PUBLIC[f"{name}_plot"], int(count)
    figure, axes = plt.subplots(1, count + 1)
    drawn = plot(made[kind], ax=axes[0] if count == 1 else list(axes[:count]))
    assert list(np.ravel(np.asarray(drawn, object))) == list(axes[:count])
    assert isinstance(drawn, Axes) == (count == 1)
    assert all(one.has_data() or one.texts for one in axes[:count])
    assert not axes[count].has_data()
    figure.draw_without_rendering()
    many = rf"has {count + 1} Axes; this plot draws on {count}" if count > 1 else "must be an Axes"
    for wrong, said in ((axes, many), (figure, r"must be (an|matplotlib) Axes")):
        says(clpt.ClptError, said, plot, made[kind], ax=wrong)
    assert plt.get_fignums() == [figure.number]


def test_without_axes_a_plot_is_the_figure_of_pyplot_or_of_a_file(made, monkeypatch):
    assert track_plot(made["run"]).figure is plt.gcf()
    plt.close("all")
    assert figure_of(track_plot, made["run"]).axes
    assert plt.get_fignums() == []

    def closed(**_):
        raise ImportError("headless")  # a window cannot be opened

    monkeypatch.setattr(plt, "figure", closed)
    assert track_plot(made["run"]).has_data()


def test_what_is_no_run_is_one_sentence(made):
    for given, said in (
        (made["replay"], "must be an xarray.Dataset"),
        (made["team"], "team's; clpt.simulation.team_plot"),
        (made["run"].drop_attrs(), "carries no scenario"),
        (made["run"].isel(time=-1), "has no time over time, as its scenario has"),
    ):
        says(clpt.ClptError, said, track_plot, given)
    for plot in (clpt.ensemble.ensemble_plot, clpt.simulation.team_plot, clpt.replay.map_plot):
        says(clpt.ClptError, "", plot, made["run"])
    lacking, said = made["team"].drop_vars("alpha"), "the run has no alpha over vehicle 2, time"
    says(clpt.DataError, said, clpt.simulation.team_plot, lacking)


def test_texts_of_figures_are_no_latex_whatever_the_users_style(made, tmp_path):
    with plt.rc_context({"text.usetex": True}):
        text = inline_svg(figure_of(clpt.simulation.clpe_plot, made["run"]), "clpe", "CLPE")
        clpt.animate(made["run"], tmp_path / "run.gif", seconds=0.2, fps=5, width=200)
    assert ">CLPE (m)<" in text


# --- films ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def run(made):
    return made["run"]


def test_a_film_has_its_frames(run, clpt, refused_for, tmp_path):
    file, words = tmp_path / "run.gif", ("animate", tmp_path / "run.nc", "-o")
    save_run(run, tmp_path / "run.nc")
    done = clpt(*words, file, "--seconds", 1, "--fps", 10, "--width", 300)
    assert done.out == f"{file}: written\n"
    refused_for(["must end in .gif"], *words, tmp_path / "film.doc")
    with Image.open(file) as film:
        assert (film.n_frames, film.width) == (10, 300)
        for frame in ImageSequence.Iterator(film):
            assert frame.info["duration"] == 100
            pixels = np.asarray(frame.convert("RGB")).reshape(-1, 1, 3) / 255
            near = np.abs(pixels - [to_rgb(BLUE), to_rgb(GREEN)]).max(axis=2) < 0.03
            assert near.sum(axis=0).min() > 10  # vehicle and prediction are there
    assert {one.name for one in tmp_path.iterdir()} == {"run.nc", "run.gif"}


def test_hundredths_of_a_second_are_whole_and_the_film_lasts_as_long(run):
    made = clpt.animate(run, seconds=0.25, fps=12, width=200)
    assert (made.frames, made.seconds) == (3, pytest.approx(0.24))  # of 0.08 s


def drawn(run, at):
    """Return the lines by name, and the arrows, that are drawn of a sample."""
    _, ax = new_figure()
    next(draw_samples(ax, run, np.array([at])))
    arrows = {one.get_label(): one for one in ax.collections if isinstance(one, Quiver)}
    return {one.get_label(): one.get_xydata() for one in ax.lines}, arrows


def test_what_is_shown_is_the_runs_own(run, scenario):
    velocity = clpt.simulation.flow_velocity
    for k in (0, 7, 20, 40):
        lines, arrows = drawn(run, k)
        own = [run.position[[k]], run.predicted_position[[k]], run.reference[[k]]]
        found = [lines[label] for label in ("vehicle", "prediction", "waypoint, now")]
        np.testing.assert_array_equal(found, own)
        true = arrows["true flow"]
        grid, flow = np.column_stack([true.X, true.Y]), np.column_stack([true.U, true.V])
        np.testing.assert_allclose(flow, velocity(scenario, grid, run.time[k]), atol=1e-12)
        if k:
            u, v = velocity(scenario, grid, run.time[k], run.flow_parameters_estimate.values[k]).T
            along = arrows["learned flow"]
            assert np.all(along.U * u + along.V * v >= 0)  # long ones are shortened
            np.testing.assert_allclose(along.U * v - along.V * u, 0.0, atol=1e-12)


def test_arrows_stand_within_a_field(scenario, tmp_path):
    uniform_field(tmp_path / "field.nc", half=3.5)
    flow = {"field": str(tmp_path / "field.nc"), "outside": "clip"}
    (arrows, *_) = drawn(clpt.simulate(scenario.with_values({"flow": flow})), 10)[1].values()
    assert np.abs([arrows.X, arrows.Y]).max() <= 3.5
    np.testing.assert_allclose([arrows.U, arrows.V], 0.1)


def test_refusals(run, made, scenario, tmp_path):
    for given, options, said in (
        (run, {"path": tmp_path / "run.avi"}, r"must end in .gif"),
        (run, {"path": tmp_path / "no" / "run.gif"}, "does not exist"),
        (run, {"fps": "many"}, "fps = 'many': must be a number"),
        (run, {"width": 10}, "width = 10: must be a number from 200"),
        (run, {"seconds": 100, "fps": 20, "width": 1000}, "would take 2.0 GB of memory"),
        (made["team"], {}, "the run is a team's"),
        (scenario, {}, "must be an xarray.Dataset"),
    ):
        says(clpt.ClptError, said, clpt.animate, given, **options)
    assert list(tmp_path.iterdir()) == []


# --- what a notebook shows -----------------------------------------------------------------------

EVIL = '<b onload="x">&'


def follower(name, takes, makes):
    return clpt.Block(name, output=lambda t, x, u, p: u[0], inputs={takes: 1}, outputs={makes: 1})


@pytest.fixture(scope="module")
def things():
    scenario = clpt.paper_scenario().with_values({"run.duration": 60, "title": EVIL})
    dives, _ = clpt.gliders.usable(clpt.gliders.sample_dives())
    replay = clpt.replay.replay_dives([replace(dives[0], vehicle=EVIL)])
    block = follower("b<i>", "a<i>", "c&d")
    team = clpt.Team(members={"a": scenario, "b": scenario}, coupling=0.5)
    loop = clpt.closed_loop(scenario)
    return {
        "Scenario": scenario,
        "Team": team,
        "Block": block,
        "Diagram": clpt.connect([block], external=["a<i>"], name="d<i>"),
        "Drawing": clpt.draw(loop),
        "Replay": replay,
        "Verdict": clpt.theory.prove(LAW.of(1, gain=-0.5), points=200),
        "Excitation": clpt.theory.gramian(team, 20.0),
        "Movie": clpt.animate(clpt.simulate(scenario), seconds=0.2, width=200),
    }


NAMES = "Scenario Team Diagram Drawing Replay Verdict Excitation Movie"


@pytest.mark.parametrize("name", NAMES.split())
def test_a_thing_shows_itself(things, name):
    """One short line as text; as HTML whole, small and harmless."""
    assert re.fullmatch(f"<{name}.{{0,190}}>", repr(things[name]))
    html = things[name]._repr_html_()
    tags = Reader(html).tags
    assert not {"b", "i", "script", "iframe", "link"} & {tag for tag, _ in tags}
    named = [pair for _, names in tags for pair in names.items()]
    far = [v or "" for k, v in named if k in ("src", "href") or "http" in (v or "")]
    assert all(one.startswith("data:image/gif;base64,") for one in far)
    assert name == "Movie" or len(html) < 40_000
    own = r"(fill|stroke|color)[:=]\W?(black|white|000|fff)"
    assert not re.search(rf"{own}|url\([^#]", html)  # takes the page's colour


def test_what_has_no_table_says_itself_in_one_line(things):
    run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 20}))
    for said, thing in {
        "FlowEstimate: theta ": clpt.estimation.flow_estimate(run, "kalman"),
        "Search of learned-flow: not refuted in ": clpt.refute("learned-flow", budget=0.5),
        "NativeDiagram: 1 blocks, 1 states": clpt.native.compile(clpt.parts.lag(1.0)),
        "NextDive: up 2016-02-01 ": clpt.replay.next_dive(things["Replay"]),
        "Aim: aim at 42 48.00 S 8 24.00 E": clpt.replay.aims(things["Replay"], [(-42.8, 8.4)])[0],
    }.items():
        assert repr(thing).startswith(f"<{said}"), repr(thing)
        assert len(repr(thing)) < 300


def test_names_are_shown_as_they_are_and_keys_that_were_given(things):
    evil = "&lt;b onload=&quot;x&quot;&gt;&amp;"
    for name, *said in (
        *(("Replay", evil), ("Diagram", "d&lt;i&gt;")),
        ("Scenario", evil, "learning.gain</th><td>0.8<", "run.duration</th><td>60"),
    ):
        html = things[name]._repr_html_()
        assert [one for one in said if one not in html] == []
    assert str(things["Scenario"]) == repr(things["Scenario"])


def test_python_controls_markdown_is_not_the_same_again(things):
    """It would put the drawing into a notebook twice."""
    assert things["Block"]._repr_markdown_() is things["Diagram"]._repr_markdown_() is None


def test_a_large_diagram_is_said_in_words():
    row = [follower(f"b{k}", f"s{k}", f"s{k + 1}") for k in range(70)]
    diagram = clpt.connect(row, external=["s0"], name="chain")
    assert re.search("(?s)^(?!.*<svg).*more than 60 blocks", diagram._repr_html_())
    assert "70 blocks" in repr(diagram)


def test_what_cannot_be_wired_says_why():
    circle = clpt.connect([follower("a", "s", "r"), follower("b", "r", "s")], name="circle")
    assert re.search("(?s)^(?!.*<svg).*<p>", circle._repr_html_())
    assert repr(circle).startswith("<Diagram circle: 2 blocks")


# --- dataset.clpt, and a run as a table ----------------------------------------------------------

ORDERS = "clpt_control, xarray", "xarray, clpt_control", "clpt_control.scenario, xarray.core"


@pytest.mark.processes  # test_release asks one of them
@pytest.mark.parametrize("order", ORDERS)
def test_it_is_there_whichever_was_imported_first(order):
    code = f"import {order}; import xarray; xarray.Dataset().clpt"
    ran(sys.executable, "-W", "error", "-c", code)


def test_a_run_and_its_file_as_xarray_opens_it(made, scenario, tmp_path):
    run = made["run"]
    clpt.save_run(run, tmp_path / "run.nc")
    with xarray.open_dataset(tmp_path / "run.nc") as opened:
        for one in (opened, run.isel(time=slice(3, 20))):
            assert (one.clpt.kind, one.clpt.scenario) == ("run", scenario)
            assert len(one.clpt.plot()) == 7
        report = clpt.report(opened.isel(time=[-1]), tmp_path / "page.html")
    assert report["kind"] == "Run of a scenario"


def test_a_field_is_found_from_the_file_alone(scenario, tmp_path):
    """The scenario's field is relative to its file, also for xarray's own opening."""
    uniform_field(tmp_path / "field.nc")
    flow = {"flow": {"field": str(tmp_path / "field.nc")}}
    clpt.save_scenario(scenario.with_values(flow), tmp_path / "s.toml")
    loaded, vary = clpt.load_scenario(tmp_path / "s.toml"), "learning.gain=0.2:2.0"
    clpt.save_run(clpt.simulate(loaded), tmp_path / "run.nc")
    with xarray.open_dataset(tmp_path / "run.nc") as opened:
        assert clpt.simulation.track_plot(opened).has_data()
    for out in (None, tmp_path / "e.zarr"):
        data = clpt.ensemble.run_ensemble(loaded, vary, 2, out=out)
        assert data.clpt.scenario.field_path.is_file()
    assert xarray.open_zarr(out, consolidated=False).clpt.scenario.field_path.is_file()


def test_teams_ensembles_and_replays(made, scenario, tmp_path):
    replay, data = made["replay"], clpt.replay.replay_dataset(made["replay"])
    for kind, one, count in (
        *(("team", made["team"], 3), ("ensemble", made["ensemble"], 2), ("replay", data, 5)),
    ):
        assert (one.clpt.kind, len(one.clpt.plot())) == (kind, count)
        assert f"clpt of a dataset: {kind}" in repr(one.clpt)
    assert [*made["team"].clpt.scenario.members.values()] == [scenario, scenario]
    assert made["ensemble"].clpt.scenario == scenario
    data.to_netcdf(tmp_path / "replay.nc")
    with xarray.open_dataset(tmp_path / "replay.nc") as opened:  # times decoded
        for plot in (clpt.replay.current_plot, clpt.replay.map_plot, clpt.replay.dive_clpe_plot):
            for of_data, own in zip(np.ravel(plot(opened)), np.ravel(plot(replay)), strict=True):
                assert of_data.get_title(loc="left") == own.get_title(loc="left")
                for a, b in zip(of_data.lines, own.lines, strict=True):
                    np.testing.assert_allclose(a.get_ydata(), b.get_ydata(), atol=1e-3)


def test_what_is_not_ours_is_one_sentence(made):
    foreign = xarray.Dataset({"a": 1})
    assert repr(foreign.clpt) == "<clpt of a dataset: none of clpt's>"
    says(clpt.ClptError, "", lambda: foreign.clpt.scenario)
    says(clpt.ClptError, "", foreign.clpt.plot)
    says(clpt.ClptError, "", clpt.report, foreign, "page.html")
    says(clpt.ClptError, "", clpt.replay.map_plot, made["run"])
    for draw in (clpt.simulation.track_plot, clpt.replay.map_plot, clpt.animate):
        says(clpt.ClptError, "", draw, foreign)


def test_a_run_is_linearized_at_one_of_its_times(scenario):
    scenario = clpt.theory.started_true(scenario)
    run = clpt.simulate(scenario)
    made = run.clpt.linearize(10.0, input="zc", output="x", minimal=True)
    steered = clpt.closed_loop(scenario, external="zc")
    state, desired = clpt.state_at(run, 10.0), run.reference.sel(time=10.0).values
    whole = clpt.linearize(steered, state, desired, 10.0)
    x = whole.output_labels.index("x[0]")
    assert (made.nstates, made.input_labels) == (2, ["zc[0]", "zc[1]"])
    np.testing.assert_allclose(made(1j), whole(1j)[x : x + 2], atol=1e-12)
    assert run.clpt.linearize(10.0).ninputs == 0
    cut = run.clpt.linearize(10.0, input="x", output="alpha")
    assert cut.state_labels[0] == "learning_model_z[0]"
    says(clpt.ArgumentError, "has no 'nothing'", run.clpt.linearize, 10.0, output="nothing")
    changed = clpt.simulate(scenario, params={"basis_x.widths": [1.0, 2.0, 3.0]})
    says(clpt.DataError, "does not hold its diagram", changed.clpt.linearize, 10.0)


# --- a run as a table, read back by csv and by scipy.io.loadmat ----------------------------------

TIMES = np.linspace(0.0, 2.0, 11)


def run_of_a_diagram(**units):
    ports = {"inputs": {"q": 1}, "states": {"h": 2}, "units": units}
    block = clpt.Block("tank", update=lambda t, x, u, p: [u[0] - x[0], x[0] - x[1]], **ports)
    return clpt.simulate(block, TIMES, np.sin(TIMES))


def test_a_csv_file_is_the_run_to_the_last_digit(tmp_path):
    run = run_of_a_diagram(h="m", q="m3/s")
    table = run.clpt.table(tmp_path / "run.csv")
    with (tmp_path / "run.csv").open(newline="") as file:
        head, *rows = csv.reader(file)
    assert head == [*table.columns] == ["time", "h[0] (m)", "h[1] (m)", "q (m3/s)"]
    read = np.array(rows, dtype=float)
    np.testing.assert_array_equal(read, table)
    np.testing.assert_array_equal(read.T, [run.time, *run.h.values.T, run.q])


def test_a_mat_file_has_a_matrix_for_each_port(tmp_path):
    run = run_of_a_diagram(h="m")
    run.clpt.table(tmp_path / "run.mat")
    read = loadmat(tmp_path / "run.mat", simplify_cells=True)
    own = {name for name in read if name[0] != "_"}
    assert own == {"time", "h", "q", "units", "signals", "title"}
    shapes = loadmat(tmp_path / "run.mat")
    for name, columns in (("time", 1), ("h", 2), ("q", 1)):
        np.testing.assert_array_equal(read[name], run[name])
        assert shapes[name].shape == (11, columns)
    assert (read["title"], read["units"]["h"]) == ("Response of tank", "m")
    assert not len(read["units"]["q"])
    assert read["signals"]["h"].tolist() == ["h[0]", "h[1]"]


def test_a_run_of_a_scenario_and_of_a_team(made, tmp_path):
    run, both = made["run"], made["team"]
    table = run.clpt.table(tmp_path / "run.mat")
    read = loadmat(tmp_path / "run.mat", simplify_cells=True)
    np.testing.assert_array_equal(read["alpha"], run.alpha.values.reshape(len(run.time), -1))
    assert read["signals"]["alpha"][4] == "alpha axis 2 basis 2"
    assert [*table.columns[:3]] == ["time (s)", "position axis 1 (m)", "position axis 2 (m)"]
    assert "flow_parameters" not in read  # which are no signals
    own = both.position.sel(vehicle="b", axis=1)
    np.testing.assert_array_equal(both.clpt.table()["position vehicle b axis 1 (m)"], own)


ALLOWED = [("_e", "q", "x__e q"), ("x" * 80, "q", "x" * 60 + " q")]
ALLOWED += [("\u00fc", "q", "x__ q"), ("a b", "a_b", "a_b a_b_")]


@pytest.mark.parametrize(("h", "q", "names"), ALLOWED)
def test_names_are_those_that_matlab_allows(tmp_path, h, q, names):
    run_of_a_diagram().rename(h=h, q=q).clpt.table(tmp_path / "run.mat")
    read = {name for name in loadmat(tmp_path / "run.mat") if name[:2] != "__"}
    assert read - {"time", "units", "signals", "title"} == set(names.split())


def test_it_refuses_in_a_sentence(tmp_path):
    run = run_of_a_diagram()
    for name in ("run.xls", "nowhere/run.csv", "nowhere/run.mat"):
        says(clpt.DataError, "", run.clpt.table, tmp_path / name)
    for none in (run.isel(time=3), run.rename(h="time", time="t")):
        says(clpt.DataError, "no signal along time", none.clpt.table)
    assert list(tmp_path.iterdir()) == []


def test_columns_of_members_name_what_varied():
    lag = control.ss(-1, 1, 1, 0, inputs="u", outputs="y", name="lag")
    times = np.linspace(0.0, 1.0, 3)
    table = clpt.run_ensemble(lag, {"u": [1, 2]}, timepts=times, trajectories=True).clpt.table()
    assert [*table.columns] == ["time", "y u 1.0", "y u 2.0"]
    np.testing.assert_allclose(table.values[:, 2], 2.0 * (1.0 - np.exp(-times)), atol=1e-6)
