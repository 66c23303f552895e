"""Plots on given axes, and films."""

from functools import partial
from itertools import pairwise

import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray
from error_sentences import says
from film_frames import frame_of
from gridded_currents import uniform_field
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.quiver import Quiver
from PIL import Image, ImageSequence

import clpt_control as clpt
from clpt_control import save_run

COUNTS = {  # kind of dataset -> name of a plot -> number of its Axes
    "run": {"": 7, "track": 1, "map": 1, "clpe": 2, "learning": 2, "signals": 10},
    "fixes": {"": 2, "map": 1},
    "team": {"": 3},
    "diagram": {"": 2},
    "ensemble": {"": 2},
    "replay": {"": 5, "map": 1, "clpe": 1, "current": 3},
}
METHODS = [("design", "", 3), ("excitation", "", 4)]  # objects with a plot of their own
PLOTS = [
    (kind, name, count)
    for kind, plots in COUNTS.items()
    for name, count in plots.items()
]


@pytest.mark.parametrize("kind", COUNTS)
def test_all_plots_are_listed(made, kind):
    names = ", ".join(filter(None, COUNTS[kind]))
    one = f"there is one plot of this {kind}. Leave the name out"
    said = f"plot 'none': must be {names}, for a {kind}" if names else one
    if kind in ("run", "diagram"):
        said = "plot 'none': the run has no such signal or state. It has "
    says(clpt.ClptError, said, plot_of(made, kind, "none"))


def plot_of(made, kind, name):
    """Return the method that draws a plot."""
    if kind == "design":
        return made["design"].plot
    if kind == "excitation":
        return clpt.gramian(made["run"]).plot
    data = made[kind]
    if kind == "replay":
        data = data.dataset()
    return partial(data.clpt.plot, name)


@pytest.mark.parametrize(("kind", "name", "count"), [*PLOTS, *METHODS])
def test_on_given_axes(kind, name, count, made):
    """Something is drawn on each, nothing elsewhere, they come back; wrong ones are a sentence."""
    plot = plot_of(made, kind, name)
    figure, axes = plt.subplots(1, count + 1)
    drawn = plot(ax=axes[0] if count == 1 else list(axes[:count]))
    assert list(np.ravel(np.asarray(drawn, object))) == list(axes[:count])
    assert isinstance(drawn, Axes) == (count == 1)
    assert all(one.has_data() or one.texts for one in axes[:count])
    assert not axes[count].has_data()
    figure.draw_without_rendering()
    many = (
        rf"has {count + 1} Axes; this plot needs {count}"
        if count > 1
        else "must be an Axes"
    )
    for wrong, said in ((axes, many), (figure, r"must be (an|matplotlib) Axes")):
        says(clpt.ClptError, said, plot, ax=wrong)
    assert plt.get_fignums() == [figure.number]


@pytest.mark.long
def test_without_axes_a_plot_is_the_figure_of_pyplot_or_of_a_file(
    made, monkeypatch, tmp_path
):
    assert made["run"].clpt.plot("track").figure is plt.gcf()
    plt.close("all")
    clpt.report(made["run"], tmp_path / "run.html")
    assert plt.get_fignums() == []

    def closed(**_):
        raise ImportError("headless")  # a window cannot be opened

    monkeypatch.setattr(plt, "figure", closed)
    assert made["run"].clpt.plot("track").has_data()


def test_degrees_of_a_small_map_are_written_out_and_apart(made):
    places = {"run.duration": 40, "origin": [41.2, -69.5]}
    run = clpt.simulate(clpt.paper_scenario().with_values(places))
    ax = run.clpt.plot("map")
    ax.figure.draw_without_rendering()
    for axis in (ax.xaxis, ax.yaxis):
        assert axis.get_offset_text().get_text() == ""
        low, high = sorted(axis.get_view_interval())
        texts = [one.get_text() for one in axis.get_ticklabels()]
        numbers = [float(text.replace("\N{MINUS SIGN}", "-")) for text in texts]
        assert sum(low <= one <= high for one in numbers) >= 2
    boxes = [one.get_window_extent() for one in ax.get_xticklabels()]
    assert all(a.x1 < b.x0 for a, b in pairwise(boxes))


@pytest.mark.parametrize("size", [1e-3, 1.0, 300.0])
def test_degrees_of_a_track_are_even_distinct_and_apart(size):
    """Circles of a metre to 300 km about (48, -6): labels have few digits, and differ."""
    places = {
        "run.duration": 40,
        "units.length": "km",
        "origin": [48.0, -6.0],
        "reference.radius": size,
    }
    run = clpt.simulate(clpt.paper_scenario().with_values(places))
    ax = run.clpt.plot("track")
    ax.figure.draw_without_rendering()
    for axis in (ax.xaxis, ax.yaxis):
        low, high = axis.get_view_interval()
        ticks = zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=True)
        shown = [label for at, label in ticks if low <= at <= high]
        texts = [label.get_text() for label in shown]
        assert len({*texts}) == len(texts) >= 2
        spans = sorted(tuple(label.get_window_extent().intervalx) for label in shown)
        is_across = axis is ax.xaxis
        assert not is_across or all(a[1] < b[0] for a, b in pairwise(spans))
        if size > 100.0:
            assert all(len(text) <= len("48.5\N{DEGREE SIGN} W") for text in texts)


def test_an_estimate_is_opened_by_xarray(made, tmp_path):
    made["fixes"].to_netcdf(tmp_path / "fixes.nc")
    said = "is an estimate from fixes. Open it with xarray.open_dataset"
    says(clpt.DataError, said, clpt.load_run, tmp_path / "fixes.nc")
    with xarray.open_dataset(tmp_path / "fixes.nc") as opened:
        assert opened.clpt.plot("map").has_data()


def test_what_is_no_run_is_one_sentence(made):
    moment, said = made["run"].isel(time=-1), "has no time over time, as its scenario"
    says(clpt.ClptError, said, moment.clpt.plot, "track")
    lacking, said = (
        made["team"].drop_vars("alpha"),
        "the run has no alpha over vehicle 2, time",
    )
    says(clpt.DataError, said, lacking.clpt.plot)


@pytest.mark.long
def test_texts_of_figures_are_no_latex_whatever_the_users_style(made, tmp_path):
    with plt.rc_context({"text.usetex": True}):
        clpt.report(made["run"], tmp_path / "run.html")
        clpt.animate(made["run"], tmp_path / "run.gif", seconds=0.2, fps=5, width=200)
    assert ">CLPE (m)<" in (tmp_path / "run.html").read_text("utf-8")


def test_numbers_of_waypoints_are_off_the_track(made):
    ax = made["run"].clpt.plot("track")
    track = made["run"].position.values
    numbers = {text.get_text(): text.get_position() for text in ax.texts}
    assert list(numbers) == [str(k) for k in range(1, 11)]
    nearest = [np.hypot(*(track - place).T).min() for place in numbers.values()]
    assert min(nearest) > 0.02 * np.ptp(ax.get_xlim())
    plt.close("all")


@pytest.mark.long
def test_a_legend_is_off_the_curves(made):
    for name in ("clpe", "learning"):
        for ax in made["run"].clpt.plot(name):
            ax.figure.draw_without_rendering()
            box = (
                ax.get_legend().get_window_extent().transformed(ax.transAxes.inverted())
            )
            for line in ax.lines:
                if len(line.get_xydata()) > 2:
                    drawn = (line.get_transform() - ax.transAxes).transform(
                        line.get_xydata()
                    )
                    inside = (drawn[:, 0] > box.x0) & (drawn[:, 0] < box.x1)
                    assert drawn[inside, 1].max(initial=0.0) < box.y0
    plt.close("all")


def test_more_functions_than_a_legend_has_are_numbered_at_their_ends(scenario):
    values = {
        "basis.centers": [[k, 0] for k in range(9)],
        "basis.widths": [3.0] * 9,
        "basis.periods": [20.0] * 9,
        "basis.phases": [0.0] * 9,
        "flow.parameters": [[0.1] * 9] * 2,
        "model.parameters": [[0.0] * 9] * 2,
        "learning.parameters": [[0.0] * 9] * 2,
    }
    run = clpt.simulate(scenario.with_values(values))
    estimates, _ = run.clpt.plot("learning")
    assert sorted(text.get_text() for text in estimates.texts) == list("123456789")
    assert estimates.get_legend() is None
    places = [text.get_position()[1] for text in estimates.texts]
    assert np.diff(places).min() > 0.02
    plt.close("all")


# --- films ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def run(made):
    return made["run"]


@pytest.mark.long
def test_a_film_has_its_frames(run, clpt, refused_for, tmp_path):
    file, words = tmp_path / "run.gif", ("report", tmp_path / "run.nc", "--film", "-o")
    save_run(run, tmp_path / "run.nc")
    lines = {one.get_label(): one for one in frame_of(run, 0).lines}
    colours = [to_rgb(lines[name].get_color()) for name in ("vehicle", "prediction")]
    done = clpt(*words, file, "--seconds", 1, "--fps", 10, "--width", 300)
    assert done.out == f"Wrote {file}\n"
    refused_for(["must end in .gif"], *words, tmp_path / "film.doc")
    with Image.open(file) as film:
        assert (film.n_frames, film.width) == (10, 300)
        for frame in ImageSequence.Iterator(film):
            assert frame.info["duration"] == 100
            pixels = np.asarray(frame.convert("RGB")).reshape(-1, 1, 3) / 255
            near = np.abs(pixels - colours).max(axis=2) < 0.03
            assert near.sum(axis=0).min() > 10  # vehicle and prediction are there
    assert {one.name for one in tmp_path.iterdir()} == {"run.nc", "run.gif"}


def test_hundredths_of_a_second_are_whole_and_the_film_lasts_as_long(run):
    made = clpt.animate(run, seconds=0.25, fps=12, width=200)
    assert (made.frames, made.seconds) == (3, pytest.approx(0.24))  # of 0.08 s


def drawn(run, at):
    """Return the lines by name, and the arrows, that are drawn of a sample."""
    ax = frame_of(run, at)
    arrows = {one.get_label(): one for one in ax.collections if isinstance(one, Quiver)}
    return {one.get_label(): one.get_xydata() for one in ax.lines}, arrows


def test_what_is_shown_is_the_runs_own(run, scenario):
    velocity = clpt.currents.flow_velocity
    for k in (0, 7, 20, 40):
        lines, arrows = drawn(run, k)
        own = [run.position[[k]], run.predicted_position[[k]], run.reference[[k]]]
        found = [lines[label] for label in ("vehicle", "prediction", "waypoint, now")]
        np.testing.assert_array_equal(found, own)
        true = arrows["true flow"]
        grid, flow = (
            np.column_stack([true.X, true.Y]),
            np.column_stack([true.U, true.V]),
        )
        np.testing.assert_allclose(
            flow, velocity(scenario, grid, run.time[k]), atol=1e-12
        )
        if k:
            u, v = velocity(
                scenario, grid, run.time[k], run.flow_parameters_estimate.values[k]
            ).T
            along = arrows["learned flow"]
            assert np.all(along.U * u + along.V * v >= 0)  # long ones are shortened
            np.testing.assert_allclose(along.U * v - along.V * u, 0.0, atol=1e-12)


def test_no_arrow_is_cut_at_the_border(run):
    for k in (0, 7, 20, 40):
        ax = frame_of(run, k)
        low, high = np.transpose([ax.get_xlim(), ax.get_ylim()])
        for arrows in (one for one in ax.collections if isinstance(one, Quiver)):
            middle = np.column_stack([arrows.X, arrows.Y])
            half = np.column_stack([arrows.U, arrows.V]) / arrows.scale / 2
            for end in (middle - half, middle + half):
                assert np.all((low < end) & (end < high))


def test_arrows_stand_within_a_field(scenario, tmp_path):
    uniform_field(tmp_path / "field.nc", half=3.5)
    flow = {"field": str(tmp_path / "field.nc"), "outside": "clip"}
    (arrows, *_) = drawn(clpt.simulate(scenario.with_values({"flow": flow})), 10)[
        1
    ].values()
    assert np.abs([arrows.X, arrows.Y]).max() <= 3.5
    np.testing.assert_allclose([arrows.U, arrows.V], 0.1)


def test_refusals(run, made, scenario, tmp_path):
    for given, options, said in (
        (run, {"path": tmp_path / "run.avi"}, r"must end in .gif"),
        (run, {"path": tmp_path / "no" / "run.gif"}, "does not exist"),
        (run, {"fps": "many"}, "fps = 'many': must be a number"),
        (run, {"width": 10}, "width = 10: must be a number from 200"),
        (
            run,
            {"seconds": 100, "fps": 20, "width": 1000},
            "would take 2.0 GB of memory",
        ),
        (made["team"], {}, "the run is a team's"),
        (run.drop_attrs(), {}, "contains no scenario"),
        (scenario, {}, "must be an xarray.Dataset"),
        (made["replay"], {}, "must be an xarray.Dataset"),
    ):
        says(clpt.ClptError, said, clpt.animate, given, **options)
    assert list(tmp_path.iterdir()) == []
