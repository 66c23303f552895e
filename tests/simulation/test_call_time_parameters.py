"""Parameters given at call time: what is recorded is what ran, and it runs again or says no."""

import numpy as np
import pytest
from responses import response
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
    run = clpt.simulate(PAPER, params={name: value})
    assert_equal(run, clpt.simulate(PAPER.with_values({key: value})))
    assert np.all(np.diff(run.lyapunov.values) <= 1e-9)  # V of the parameters that ran falls
    of_the_loop = clpt.simulate(clpt.closed_loop(PAPER), params={name: value})
    np.testing.assert_allclose(of_the_loop.lyapunov, run.lyapunov, rtol=1e-6)
    clpt.save_run(run, tmp_path / "run.nc")
    again = clpt.load_scenario(tmp_path / "run.nc")
    assert again == PAPER.with_values({key: value})
    assert_equal(clpt.simulate(again), run)


def test_an_initial_state_tolerances_and_noise_are_the_files(tmp_path):
    noise = {"kind": "noise", "amplitude": [0.1, 0.2], "period": 3.0, "seed": 4}
    noisy = PAPER.with_values({"flow.disturbance": noise, "run.output_step": 2.5})
    state = clpt.initial_state(PAPER) + 0.25
    run = clpt.simulate(noisy, initial_state=state, rtol=1e-11, atol=1e-12)
    clpt.save_run(run, tmp_path / "run.nc")
    assert_equal(clpt.load_run(tmp_path / "run.nc"), run)
    again = clpt.load_scenario(tmp_path / "run.nc")
    assert (again.run.rtol, again.run.atol) == (1e-11, 1e-12)
    assert_equal(clpt.simulate(again), run)


@pytest.mark.parametrize(
    "params", [{"basis_x.widths": [4.0, 5.0, 6.0]}, {"injection.alpha_M": np.ones((2, 3))}]
)
def test_what_no_key_holds_is_refused_when_run_again(params, tmp_path):
    run = clpt.simulate(PAPER, params=params)
    assert not np.array_equal(run.alpha, clpt.simulate(PAPER).alpha)
    clpt.save_run(run, tmp_path / "run.nc")
    (name,) = params
    with pytest.raises(DataError, match=rf"{name}.*does not repeat it"):
        clpt.load_scenario(tmp_path / "run.nc")
    assert_equal(clpt.load_run(tmp_path / "run.nc"), run)


@pytest.mark.parametrize(
    ("name", "value", "sentence"),
    [
        ("adaptation.gain", -1, r"learning\.gain = -1: must be greater than or equal to 0"),
        ("adaptation.gain", np.nan, r"learning\.gain = nan: must be a finite number"),
        ("adaptation.gain", None, r"adaptation\.gain = None: must be a number"),
        ("vehicle_controller.KD", [-1.0, 1.0], r"vehicle\.feedback\[0\] = -1\.0: must be greater"),
        ("basis_x.widths", [-4.0, 5.0, 6.0], r"basis\.widths\[0\] = -4\.0: must be greater"),
        ("reference.dwell", 0.0, r"reference\.dwell = 0\.0: must be greater than 0"),
    ],
)
def test_what_no_scenario_may_have_is_refused(name, value, sentence):
    with pytest.raises(BlockError, match=rf"params: .*{sentence}"):
        clpt.simulate(PAPER, params={name: value})


def test_a_gain_of_zero_at_call_time_is_the_scenarios():
    run = clpt.simulate(PAPER, params={"adaptation.gain": 0.0})
    own = clpt.simulate(PAPER.with_values({"learning.gain": 0}))
    np.testing.assert_array_equal(run.alpha, own.alpha)
    np.testing.assert_allclose(run.lyapunov, own.lyapunov, rtol=1e-14)


def test_a_gain_each_is_asked_of_the_one_key_unless_it_holds():
    memory = PAPER.with_values({"learning.law": "composite-memory"})
    with pytest.raises(BlockError, match=r"adaptation\.gain_K, .*learning\.gain = -1"):
        clpt.simulate(memory, params={"adaptation.gain_K": -1.0})
    run = clpt.simulate(memory, params={"adaptation.gain_K": 0.0})
    assert np.all(run.feedback_gain == 0.0)


def test_a_diagram_runs_with_any_number():
    loop, state = clpt.closed_loop(PAPER), clpt.initial_state(PAPER)
    found = response(loop, [0.0, 5.0], initial_state=state, params={"adaptation.gain": 0.0})
    np.testing.assert_array_equal(found.states[4:, -1], state[4:])  # nothing adapts
