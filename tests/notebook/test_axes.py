"""Every plot draws on given axes, returns them, and leaves pyplot as it was."""

import control
import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.axes import Axes

import clpt_control as clpt
from clpt_control.figures import figure_of, inline_svg

SCENARIO = clpt.paper_scenario().with_values({"run.duration": 40.0})


@pytest.fixture(scope="module")
def made():
    """One of each thing that is drawn."""
    dives, _ = clpt.gliders.usable(clpt.gliders.sample_dives())
    return {
        "run": clpt.simulate(SCENARIO),
        "diagram": clpt.simulate(control.ss(-1, 1, [[1], [2]], 0, name="lag"), [0, 1, 2], 1.0),
        "team": clpt.simulate(clpt.Team(members={"a": SCENARIO, "b": SCENARIO}, coupling=0.5)),
        "ensemble": clpt.ensemble.run_ensemble(SCENARIO, "learning.gain=0.2:2.0", 3),
        "replay": clpt.replay.replay_dives(dives[:5]),
        "design": clpt.theory.design_track(
            SCENARIO.with_values({"reference.count": 2}), goal="kappa", window=20
        ),
    }


PLOTS = {  # name -> what it draws, how many axes
    "simulation.track_plot": ("run", 1),
    "simulation.clpe_plot": ("run", 2),
    "simulation.learning_plot": ("run", 2),
    "simulation.run_plot": ("run", 7),
    "simulation.team_plot": ("team", 3),
    "simulation.response_plot": ("diagram", 2),
    "ensemble.ensemble_plot": ("ensemble", 2),
    "theory.excitation_plot": ("run", 4),
    "theory.design_plot": ("design", 3),
    "replay.map_plot": ("replay", 1),
    "replay.dive_clpe_plot": ("replay", 1),
    "replay.current_plot": ("replay", 3),
    "replay.replay_plot": ("replay", 5),
}


def public_plots():
    for room in ("simulation", "ensemble", "theory", "replay", "currents"):
        yield from (f"{room}.{n}" for n in getattr(clpt, room).__all__ if n.endswith("_plot"))


def test_all_plots_are_asked():
    assert set(public_plots()) == set(PLOTS)


def asked(name, made):
    room, function = name.split(".")
    kind, count = PLOTS[name]
    given = made[kind] if isinstance(made[kind], tuple) else (made[kind],)
    return getattr(getattr(clpt, room), function), given, count


@pytest.mark.parametrize("name", PLOTS)
def test_on_given_axes(name, made):
    """Something is drawn on each, nothing elsewhere, and they come back."""
    plot, given, count = asked(name, made)
    figure, axes = plt.subplots(1, count + 1, squeeze=False)
    axes = axes.ravel()
    drawn = plot(*given, ax=axes[0] if count == 1 else list(axes[:count]))
    assert list(np.ravel(np.asarray(drawn, object))) == list(axes[:count])
    assert isinstance(drawn, Axes) == (count == 1)
    assert all(one.has_data() or one.texts for one in axes[:count])
    assert not axes[count].has_data()
    figure.draw_without_rendering()
    assert plt.get_fignums() == [figure.number]


@pytest.mark.parametrize("name", PLOTS)
def test_wrong_axes_are_one_sentence(name, made):
    plot, given, count = asked(name, made)
    figure, axes = plt.subplots(1, count + 1)
    before = plt.get_fignums()
    many = rf"has {count + 1} Axes; this plot draws on {count}" if count > 1 else "must be an Axes"
    for wrong, said in ((axes, many), (figure, r"must be (an|matplotlib) Axes")):
        with pytest.raises(clpt.ClptError, match=said) as caught:
            plot(*given, ax=wrong)
        assert "\n" not in str(caught.value)
    assert plt.get_fignums() == before


def test_without_axes_a_plot_is_the_figure_of_pyplot(made):
    ax = clpt.simulation.track_plot(made["run"])
    assert plt.gcf() is ax.figure


def test_a_figure_for_a_file_is_unknown_to_pyplot(made):
    figure = figure_of(clpt.simulation.track_plot, made["run"])
    assert figure.axes
    assert plt.get_fignums() == []


def test_no_screen_is_no_hindrance(made, monkeypatch):
    """A window cannot be opened: the figure is made all the same, and can be saved."""

    def closed(**_):
        raise ImportError("headless")

    monkeypatch.setattr(plt, "figure", closed)
    assert clpt.simulation.track_plot(made["run"]).has_data()


def test_what_is_no_run_is_one_sentence(made):
    for given, said in (
        (made["replay"], "must be an xarray.Dataset"),
        (made["team"], "team's; clpt.simulation.team_plot"),
        (made["run"].drop_attrs(), "carries no scenario"),
        (made["run"].drop_vars("position"), "has no position over time, axis"),
        (made["run"].isel(time=-1), "has no time over time, as its scenario has"),
    ):
        with pytest.raises(clpt.ClptError, match=said):
            clpt.simulation.track_plot(given)
    for plot in (clpt.ensemble.ensemble_plot, clpt.simulation.team_plot, clpt.replay.map_plot):
        with pytest.raises(clpt.ClptError):
            plot(made["run"])
    for name in ("alpha", "flow_parameters_estimate", "clpe"):
        with pytest.raises(clpt.DataError, match=f"the run has no {name} over vehicle 2, time"):
            clpt.simulation.team_plot(made["team"].drop_vars(name))


def test_texts_of_figures_are_no_latex_whatever_the_users_style(tmp_path):
    run = clpt.simulate(SCENARIO)
    with plt.rc_context({"text.usetex": True}):
        text = inline_svg(figure_of(clpt.simulation.clpe_plot, run), "clpe", "CLPE")
        clpt.animate(run, tmp_path / "run.gif", seconds=0.2, fps=5, width=200)
    assert ">CLPE (m)<" in text
