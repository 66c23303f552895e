"""python-control gives the same run, and runs repeat; cli/test_cli asks the independent numbers."""

from pathlib import Path

import control
import netCDF4
import numpy as np
import pytest
from calm_water import CALM
from responses import states_of

import clpt_control as clpt
from clpt_control.errors import DataError
from clpt_control.simulation.starts import initial_state


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


def test_every_scenario_has_its_reference(reference):
    assert {path.stem for path in FOLDER.glob("*.toml")} == set(reference)


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
