"""Films: frames even in time, as many as asked, readable by Pillow; refusals before work."""

import numpy as np
import pytest
from made_fields import uniform_field
from matplotlib.colors import to_rgb
from matplotlib.quiver import Quiver
from PIL import Image

import clpt_control as clpt
from clpt_control import save_run
from clpt_control.figures import BLUE, GREEN, new_figure
from clpt_control.simulation.film import draw_samples


@pytest.fixture(scope="module")
def run(made):
    return made["run"]


def test_a_film_has_its_frames(run, tmp_path):
    file = tmp_path / "run.gif"
    clpt.animate(run, file, seconds=1.0, fps=10, width=300)
    with Image.open(file) as film:
        assert film.n_frames == 10
        assert film.width == 300
        for k in range(10):
            film.seek(k)
            assert film.info["duration"] == 100
            pixels = np.asarray(film.convert("RGB")).reshape(-1, 3)
            for colour in (BLUE, GREEN):  # vehicle and prediction are there
                near = np.abs(pixels / 255 - to_rgb(colour)).max(axis=1) < 0.03
                assert near.sum() > 10
    assert [one.name for one in tmp_path.iterdir()] == ["run.gif"]


def test_hundredths_of_a_second_are_whole_and_the_film_lasts_as_long(run):
    made = clpt.animate(run, seconds=0.25, fps=12, width=200)
    assert made.frames == 3  # of 0.08 s
    assert made.seconds == pytest.approx(0.24)


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
        np.testing.assert_array_equal(lines["vehicle"], run.position[[k]])
        np.testing.assert_array_equal(lines["prediction"], run.predicted_position[[k]])
        np.testing.assert_array_equal(lines["waypoint, now"], run.reference[[k]])
        grid = np.column_stack([arrows["true flow"].X, arrows["true flow"].Y])
        flow = np.column_stack([arrows["true flow"].U, arrows["true flow"].V])
        np.testing.assert_allclose(flow, velocity(scenario, grid, run.time[k]), atol=1e-12)
        if k:
            theta = run.flow_parameters_estimate.values[k]
            learned = velocity(scenario, grid, run.time[k], theta)
            along = np.column_stack([arrows["learned flow"].U, arrows["learned flow"].V])
            assert np.all(np.sum(along * learned, axis=1) >= 0)  # long ones are shortened
            turned = along[:, 0] * learned[:, 1] - along[:, 1] * learned[:, 0]
            np.testing.assert_allclose(turned, 0.0, atol=1e-12)


def test_arrows_stand_within_a_field(scenario, tmp_path):
    uniform_field(tmp_path / "field.nc", half=3.5)
    flow = {"field": str(tmp_path / "field.nc"), "outside": "clip"}
    run = clpt.simulate(scenario.with_values({"flow": flow}))
    (arrows, *_) = drawn(run, 10)[1].values()
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
        with pytest.raises(clpt.ClptError, match=said) as caught:
            clpt.animate(given, **options)
        assert "\n" not in str(caught.value)
    assert list(tmp_path.iterdir()) == []


def test_the_command(clpt, refused, run, tmp_path):
    save_run(run, tmp_path / "run.nc")
    out = tmp_path / "film.gif"
    done = clpt("animate", tmp_path / "run.nc", "-o", out, "--seconds", 0.3, "--width", 200)
    assert done.status == 0, done.err
    assert done.out == f"{out}: written\n"
    with Image.open(out) as film:
        assert film.n_frames == 4
    said = refused("animate", tmp_path / "run.nc", "-o", tmp_path / "film.doc")
    assert "must end in .gif" in said
