"""Parameters given at call time: what is recorded is what ran, and it runs again or says no."""

import numpy as np
import pytest
from xarray.testing import assert_equal

import clpt_control as clpt
from clpt_control.errors import BlockError, DataError

PAPER = clpt.paper_scenario().with_values({"run.duration": 40})


@pytest.mark.parametrize(
    ("name", "key", "value"),
    [
        ("adaptation.gain", "learning.gain", 2.0),
        ("true_flow.theta", "flow.parameters", [[0.5, 0.1, 0.2], [0.3, 0.4, 0.1]]),
        ("vehicle_controller.KD", "vehicle.feedback", [2.0, 1.5]),
        ("vehicle_controller.GammaD", "vehicle.feedforward", [0.5, 2.0]),
        ("reference.dwell", "reference.dwell", 7.0),
    ],
)
def test_a_run_is_that_of_the_scenario_that_says_so(name, key, value, tmp_path):
    run, said = (clpt.simulate(PAPER, params={name: value}), PAPER.with_values({key: value}))
    for variable, own in clpt.simulate(said).data_vars.items():
        np.testing.assert_allclose(run[variable], own, rtol=1e-6, atol=1e-9)
    assert np.all(np.diff(run.lyapunov.values) <= 1e-9)  # V of the parameters that ran falls
    clpt.save_run(run, tmp_path / "run.nc")
    with pytest.raises(DataError, match=rf"parameters given at call time.*{name}"):
        clpt.load_scenario(tmp_path / "run.nc")
    again = clpt.simulate(clpt.load_diagram(tmp_path / "run.nc"))
    for variable, own in run.data_vars.items():
        np.testing.assert_array_equal(again[variable], own)


def test_an_initial_state_tolerances_and_noise_are_the_files(tmp_path):
    noise = {"kind": "noise", "amplitude": [0.1, 0.2], "period": 3.0, "seed": 4}
    noisy = PAPER.with_values({"flow.disturbance": noise, "run.output_step": 2.5})
    state = clpt.initial_state(PAPER) + 0.25
    run = clpt.simulate(noisy, initial_state=state, rtol=1e-11, atol=1e-12)
    np.testing.assert_array_equal(run.states[0], state)
    clpt.save_run(run, tmp_path / "run.nc")
    assert_equal(clpt.load_run(tmp_path / "run.nc"), run)
    again = clpt.simulate(clpt.load_diagram(tmp_path / "run.nc"))
    np.testing.assert_array_equal(again.states, run.states)


@pytest.mark.parametrize(
    ("name", "value", "sentence"),
    [
        ("adaptation.gain", None, r"adaptation\.gain = None: must be a number"),
        ("adaptation.gain", [1.0, 2.0], r"adaptation\.gain = .*: must be a number, without NaN"),
        ("adaptation.gain", np.nan, r"adaptation\.gain = nan: must be a number, without NaN"),
        ("learning.gain", 1.0, r"its name at call time is adaptation\.gain"),
    ],
)
def test_what_is_no_parameter_is_refused(name, value, sentence):
    with pytest.raises(BlockError, match=sentence):
        clpt.simulate(PAPER, params={name: value})


def test_a_gain_of_zero_at_call_time_is_the_scenarios():
    run = clpt.simulate(PAPER, params={"adaptation.gain": 0.0})
    own = clpt.simulate(PAPER.with_values({"learning.gain": 0}))
    np.testing.assert_array_equal(run.alpha, own.alpha)
    np.testing.assert_allclose(run.lyapunov, own.lyapunov, rtol=1e-14)
