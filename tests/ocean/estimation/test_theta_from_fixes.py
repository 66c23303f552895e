"""Estimates of theta from fixes of a run, against the parameters that made it.

A run's fixes are legs (Remark 3.2): the filter and motion tomography take them as those of a
vehicle.
"""

import numpy as np
import pytest
from refusals import refuses

import clpt_control as clpt

estimate = clpt.currents.flow_estimate
PAPER = clpt.paper_scenario()
THETA = np.array(PAPER.flow.parameters)
FINE = {"run.duration": 200, "run.output_step": 0.1}


def theta_of(found):
    """The parameters after the last leg, m/s."""
    return found.flow_parameters_estimate.values[-1]


def errors_of(found):
    """Largest error, and the largest over its standard error."""
    off = np.abs(theta_of(found) - THETA)
    return off.max(), np.max(off / found.standard_error.values[-1])


@pytest.fixture(scope="module")
def lap():
    """One cycle of the paper's scenario, recorded each 0.2."""
    return clpt.simulate(
        PAPER.with_values({"run.duration": 200, "run.output_step": 0.2})
    )


@pytest.mark.long
@pytest.mark.parametrize(
    ("method", "every", "most"),
    [("kalman", 2.0, 2e-4), ("tomography", 2.0, 2e-4), ("tomography", 20.0, 5e-2)],
)
def test_the_parameters_of_a_run_are_found(lap, method, every, most):
    """Tomography also where the vehicle crosses all functions between fixes."""
    found = estimate(lap, method=method, every=every)
    off, ratio = errors_of(found)
    assert off < most
    assert ratio < 4
    assert found.sizes["leg"] == 200 / every


@pytest.mark.long
def test_the_filter_is_causal(lap):
    early = estimate(lap.isel(time=slice(0, 501)))  # to t = 100
    whole = estimate(lap).flow_parameters_estimate.values
    steps = early.flow_parameters_estimate.values
    np.testing.assert_allclose(whole[: len(steps)], steps, atol=1e-6)


@pytest.mark.long
def test_the_true_parameters_are_not_read(lap):
    text, other = lap.attrs["scenario"], lap.copy()
    true = "[[1.0, 0.4, 0.8], [0.9, 0.4, 0.8]]"
    assert true in text
    other.attrs["scenario"] = text.replace(true, "[[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]")
    np.testing.assert_array_equal(
        theta_of(estimate(other, every=5.0)), theta_of(estimate(lap, every=5.0))
    )


@pytest.mark.long
def test_a_limited_speed_and_a_modelled_flow_are_known():
    values = {"vehicle.max_speed": 1.5, "model.parameters": 0.5 * THETA}
    run = clpt.simulate(PAPER.with_values(FINE | values))
    np.testing.assert_allclose(theta_of(estimate(run, every=5.0)), THETA, rtol=2e-3)


@pytest.mark.long
def test_an_estimate_feeds_the_known_flow_law(lap):
    found = theta_of(estimate(lap))
    known = clpt.currents.known_flow_scenario
    for law in ("learned-flow", "composite-memory", "kalman-flow"):
        base = PAPER.with_values({"learning.law": law, "learning.parameters": None})
        fed = known(base, found)
        assert (fed.learning.law, fed.learning.gain) == ("known-flow", 0.8)
    each = {"parameters": 1.0, "feedback": 0.3, "feedforward": 0.5}
    base = PAPER.with_values({"learning.gain": None, "learning.gains": each})
    assert known(base, THETA).learning.gains.feedback == 0.3
    constant = {"adapt_gains": False, "feedback": [1, 1], "feedforward": [1, 1]}
    base = PAPER.with_values(
        {f"learning.{key}": value for key, value in constant.items()}
    )
    assert known(base, THETA).learning.gain is None
    run = clpt.simulate(fed.with_values({"run.duration": 1000}))
    last = run.clpe.sel(time=slice(800, 1000)).values
    assert np.sqrt(np.mean(np.sum(last**2, axis=1))) < 1e-4


def test_what_is_not_allowed_is_said(lap):
    for change, said in (
        ({"method": "guess"}, "'guess': must be one of kalman, tomography"),
        (
            {"every": -1.0},
            r"every = -1: must be positive, at most the run's length, 200 s",
        ),
        ({"every": 300.0}, "every = 300: must be positive, at most"),
        ({"prior": 0.0}, "prior = 0: must be a positive number"),
        ({"noise": float("inf")}, "noise = inf: must be a positive number"),
        ({"scenario": PAPER}, "scenario: is that of the run"),
    ):
        refuses(said, estimate, lap, error=clpt.ScenarioError, **change)


@pytest.mark.long
def test_runs_that_tell_too_little_are_refused(lap):
    def run(values, **more):
        return clpt.simulate(PAPER.with_values({"run.duration": 200} | values), **more)

    fixes = {"learning": {"law": "fix-regression"}, "localization": {"interval": 5.0}}
    parameters = {"vehicle_controller.alpha_M": THETA}
    for source, said in (
        (lap.drop_attrs(), "contains no scenario"),
        (run({"run.duration": 20}, params=parameters), "parameters given at call time"),
        (lap.sel(time=slice(19.7, 60)), "into 5 samples at least"),
        (run({"run.output_step": 4}), r"to 0\.\d+ m only. Run it with a smaller"),
        (run({"run.output_step": 0.7}), "a step that divides that"),
        (run({**fixes, "run.duration": 40}), "steers on its prediction between fixes"),
    ):
        refuses(said, estimate, source, error=(clpt.DataError, clpt.ScenarioError))


# --- positions that are read with noise


def read_with_noise(number, noise=0.02, period=1.0):
    seen = {"noise": noise, "noise_period": period, "seed": number}
    return clpt.simulate(PAPER.with_values({**FINE, "localization": seen}))


@pytest.mark.long
def test_a_run_that_is_read_with_noise_says_how_well_it_tells():
    """Nine of ten parameters within 1.645 of their standard errors, or more: neighbours share."""
    exact = estimate(read_with_noise(1, noise=0.0), every=5.0)
    np.testing.assert_allclose(theta_of(exact), THETA, rtol=2e-3)
    ratios = []
    for number in range(8):
        found = estimate(read_with_noise(number), every=5.0)
        ratios.append((theta_of(found) - THETA) / found.standard_error.values[-1])
    assert np.mean(np.abs(ratios) < 1.645) > 0.8
    beside = read_with_noise(0, period=0.25)
    said = r"the noise each 0\.25 s. Run it with a step"
    refuses(said, estimate, beside, error=clpt.ScenarioError)
    noisy = read_with_noise(0)
    bare = noisy.drop_vars("measured_position")
    refuses("the run has no measured_position over time, axis", estimate, bare)
    refuses(
        "noise_period: .* Use method kalman",
        *(estimate, noisy),
        error=clpt.ScenarioError,
        method="tomography",
    )


@pytest.mark.long
@pytest.mark.parametrize("every", [2.0, 10.0])
@pytest.mark.sampled
def test_the_motion_of_a_run_is_never_called_wrong(lap, every):
    notes = estimate(lap, every=every).attrs["notes"]
    assert not [note for note in notes if "look" in note or "contradict" in note]
