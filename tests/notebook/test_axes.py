"""Every plot draws on given axes, returns them, and leaves pyplot as it was."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.axes import Axes

import clpt_control as clpt
from clpt_control.figures import figure_of, inline_svg

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
track_plot = clpt.simulation.track_plot


def test_all_plots_are_asked():
    rooms = ("simulation", "ensemble", "theory", "replay", "currents")
    public = {f"{room}.{name}" for room in rooms for name in getattr(clpt, room).__all__}
    assert {name for name in public if name.endswith("_plot")} == set(PLOTS)


@pytest.mark.parametrize("name", PLOTS)
def test_on_given_axes(name, made):
    """Something is drawn on each, nothing elsewhere, they come back; wrong ones are a sentence."""
    (kind, count), (room, function) = PLOTS[name], name.split(".")
    plot = getattr(getattr(clpt, room), function)
    figure, axes = plt.subplots(1, count + 1)
    drawn = plot(made[kind], ax=axes[0] if count == 1 else list(axes[:count]))
    assert list(np.ravel(np.asarray(drawn, object))) == list(axes[:count])
    assert isinstance(drawn, Axes) == (count == 1)
    assert all(one.has_data() or one.texts for one in axes[:count])
    assert not axes[count].has_data()
    figure.draw_without_rendering()
    many = rf"has {count + 1} Axes; this plot draws on {count}" if count > 1 else "must be an Axes"
    for wrong, said in ((axes, many), (figure, r"must be (an|matplotlib) Axes")):
        with pytest.raises(clpt.ClptError, match=said) as caught:
            plot(made[kind], ax=wrong)
        assert "\n" not in str(caught.value)
    assert plt.get_fignums() == [figure.number]


def test_without_axes_a_plot_is_the_figure_of_pyplot_or_of_a_file(made, monkeypatch):
    ax = track_plot(made["run"])
    assert plt.gcf() is ax.figure
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
        with pytest.raises(clpt.ClptError, match=said):
            track_plot(given)
    for plot in (clpt.ensemble.ensemble_plot, clpt.simulation.team_plot, clpt.replay.map_plot):
        with pytest.raises(clpt.ClptError):
            plot(made["run"])
    with pytest.raises(clpt.DataError, match="the run has no alpha over vehicle 2, time"):
        clpt.simulation.team_plot(made["team"].drop_vars("alpha"))


def test_texts_of_figures_are_no_latex_whatever_the_users_style(made, tmp_path):
    with plt.rc_context({"text.usetex": True}):
        text = inline_svg(figure_of(clpt.simulation.clpe_plot, made["run"]), "clpe", "CLPE")
        clpt.animate(made["run"], tmp_path / "run.gif", seconds=0.2, fps=5, width=200)
    assert ">CLPE (m)<" in text
