"""Films: frames even in time, as many as asked, readable by Pillow; refusals before work."""

import numpy as np
import pytest
from made_fields import uniform_field
from matplotlib.colors import to_rgb
from PIL import Image

import clpt_control as clpt
from clpt_control.figures import BLUE, GREEN
from clpt_control.simulation.film import draw_frames, film_of

SCENARIO = clpt.paper_scenario().with_values({"run.duration": 40.0})


@pytest.fixture(scope="module")
def run():
    return clpt.simulate(SCENARIO)


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


def test_what_is_shown_is_the_runs_own(run):
    times = np.array([0.0, 7.0, 20.0, 40.0])
    film = film_of(run, times)
    at = run.sel(time=times)
    np.testing.assert_allclose(film.x, at.position)
    np.testing.assert_allclose(film.z, at.predicted_position)
    np.testing.assert_array_equal(film.zc, at.reference)  # right limits
    velocity = clpt.simulation.flow_velocity
    for k, t in enumerate(times):
        np.testing.assert_allclose(film.true[k], velocity(SCENARIO, film.grid, t), atol=1e-12)
        learned = velocity(SCENARIO, film.grid, t, at.flow_parameters_estimate.values[k])
        np.testing.assert_allclose(film.learned[k], learned, atol=1e-12)


def test_a_film_between_two_samples_shows_both_its_ends(run):
    coarse = run.sel(time=[0.0, 10.0, 20.0])
    figure, _ = draw_frames(film_of(coarse, np.linspace(12.0, 17.0, 3)), 200)
    t, size = figure.axes[1].lines[0].get_data()
    np.testing.assert_array_equal(t, [12.0, 17.0])
    e = coarse.clpe.values
    np.testing.assert_allclose(size, [np.hypot(*(e[1] + s * (e[2] - e[1]))) for s in (0.2, 0.7)])


def test_arrows_stand_within_a_field(tmp_path):
    uniform_field(tmp_path / "field.nc", half=3.5)
    flow = {"field": str(tmp_path / "field.nc"), "outside": "clip"}
    run = clpt.simulate(SCENARIO.with_values({"flow": flow}))
    film = film_of(run, np.array([0.0, 10.0]))
    assert np.abs(film.grid).max() <= 3.5
    np.testing.assert_allclose(film.true, 0.1)


def test_refusals(run, tmp_path):
    team = clpt.Team(members={"a": SCENARIO, "b": SCENARIO}, coupling=0.5)
    for given, options, said in (
        (run, {"path": tmp_path / "run.avi"}, r"must end in .gif"),
        (run, {"path": tmp_path / "no" / "run.gif"}, "does not exist"),
        (run, {"seconds": float("nan")}, "seconds = nan: must be a number"),
        (run, {"fps": "many"}, "fps = 'many': must be a number"),
        (run, {"width": 10}, "width = 10: must be a number from 200"),
        (run, {"seconds": 100, "fps": 20, "width": 1000}, "would take 2.0 GB of memory"),
        (run.drop_vars("reference"), {}, "the run has no reference over time, axis"),
        (clpt.simulate(team), {}, "the run is a team's"),
        (SCENARIO, {}, "must be an xarray.Dataset"),
    ):
        with pytest.raises(clpt.ClptError, match=said) as caught:
            clpt.animate(given, **options)
        assert "\n" not in str(caught.value)
    assert list(tmp_path.iterdir()) == []


def test_the_command(clpt, refused, run, tmp_path):
    import clpt_control

    clpt_control.save_run(run, tmp_path / "run.nc")
    out = tmp_path / "film.gif"
    done = clpt("animate", tmp_path / "run.nc", "-o", out, "--seconds", 0.3, "--width", 200)
    assert done.status == 0, done.err
    assert done.out == f"{out}: written\n"
    with Image.open(out) as film:
        assert film.n_frames == 4
    said = refused("animate", tmp_path / "run.nc", "-o", tmp_path / "film.doc")
    assert "must end in .gif" in said
