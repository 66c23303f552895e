"""python-control's own solver gives the same run; `cli/test_cli` asks the independent numbers.

`reference/paper.json` was made once by another program at a tolerance of 1e-12; its states are
ordered x, z, alpha row by row, K, Gamma.
"""

import json
from pathlib import Path

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.simulation.starts import initial_state

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


def agrees_with_python_control(end):
    scenario = clpt.paper_scenario()
    theirs = segment_by_segment(scenario, end)
    times = np.linspace(0.0, end, len(theirs))
    ours = clpt.simulate(scenario, times, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(states_of(ours), theirs, rtol=0, atol=1e-7)


def test_python_control_gives_the_same_run():
    agrees_with_python_control(40.0)


@pytest.mark.slow
def test_python_control_gives_the_same_long_run():
    agrees_with_python_control(2000.0)
