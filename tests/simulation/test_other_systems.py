"""python-control gives the same run, and runs repeat; cli/test_cli asks the independent numbers."""

import json
from pathlib import Path

import control
import netCDF4
import numpy as np
import pytest
from calm_water import CALM, PAPER
from xarray.testing import assert_equal, assert_identical

import clpt_control as clpt
from clpt_control.errors import DataError
from clpt_control.simulation.starts import initial_state


def test_run_from_its_file_repeats_itself(tmp_path):
    scenario = PAPER.with_values(
        {
            "run.duration": 45.0,
            "run.output_step": 2.5,
            "flow.disturbance": {
                "kind": "noise",
                "amplitude": [0.1, 0.2],
                "period": 3.0,
                "seed": 4,
            },
        }
    )
    run = clpt.simulate(scenario)
    clpt.save_run(run, tmp_path / "run.nc")
    loaded = clpt.load_run(tmp_path / "run.nc")
    assert_identical(loaded.drop_attrs(deep=False), run.drop_attrs(deep=False))
    assert loaded.attrs["status"] == "finished"
    assert_equal(clpt.simulate(clpt.load_scenario(tmp_path / "run.nc")), run)


def test_what_is_no_run_is_an_error(tmp_path):
    (tmp_path / "text.nc").write_text("no netcdf")
    for path in ("text.nc", "none.nc"):
        with pytest.raises(DataError, match=path):
            clpt.load_run(tmp_path / path)


@pytest.mark.parametrize("form", [2, "two", 0])
def test_a_run_of_a_later_version_is_refused(form, tmp_path):
    clpt.save_run(clpt.simulate(CALM), tmp_path / "run.nc")
    with netCDF4.Dataset(tmp_path / "run.nc", "a") as file:
        assert file.run_format == 1
        file.run_format = form
        file.source = "clpt-control 9.0"
    for read in (clpt.load_run, clpt.load_scenario):
        with pytest.raises(DataError, match=f"{form}, written by clpt-control 9.0.*reads 1 to 1"):
            read(tmp_path / "run.nc")


FOLDER = Path(__file__).parents[1] / "reference"
REFERENCE = json.loads((FOLDER / "paper.json").read_text())
NAMES = sorted(REFERENCE)
ORDER = ("position", "predicted_position", "alpha", "feedback_gain", "feedforward_gain")


def states_of(run):
    """The reference's order; alpha is recorded under either law."""
    return np.hstack([run[name].values.reshape(run.sizes["time"], -1) for name in ORDER])


def test_every_scenario_has_its_reference():
    assert sorted(path.stem for path in FOLDER.glob("*.toml")) == NAMES


def test_the_paper_is_the_scenario_that_ships():
    ours, theirs = clpt.paper_scenario(), clpt.load_scenario(FOLDER / "paper.toml")
    for part in ("units", "basis", "flow", "vehicle", "reference", "run"):
        assert getattr(ours, part) == getattr(theirs, part)
    assert ours.learning.gain == theirs.learning.gain
    np.testing.assert_array_equal(initial_state(ours), initial_state(theirs))


def segment_by_segment(scenario, end):
    """python-control's own solver, started again at each waypoint."""
    loop, x, dwell = clpt.closed_loop(scenario), initial_state(scenario), scenario.reference.dwell
    states = [x]
    for k in range(round(end / dwell)):
        response = control.input_output_response(
            loop,
            [dwell * k, dwell * (k + 1)],
            0,
            x,
            params={"reference.interval": float(k)},
            solve_ivp_method="DOP853",
            solve_ivp_kwargs={"rtol": 1e-10, "atol": 1e-12},
        )
        x = response.states[:, -1]
        states.append(x)
    return np.array(states)


def agrees_with_python_control(scenario, end):
    theirs = segment_by_segment(scenario, end)
    times = np.linspace(0.0, end, len(theirs))
    ours = clpt.simulate(scenario, times, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(states_of(ours), theirs, rtol=0, atol=1e-7)


def test_python_control_gives_the_same_run():
    """Over two switches of the reference."""
    agrees_with_python_control(clpt.paper_scenario().with_values({"reference.dwell": 5}), 15.0)


@pytest.mark.slow
def test_python_control_gives_the_same_long_run():
    agrees_with_python_control(clpt.paper_scenario(), 2000.0)
