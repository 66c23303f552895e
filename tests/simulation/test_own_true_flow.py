"""A true flow of more or other functions than the learner's, `flow.basis`."""

import numpy as np
import pytest
from error_sentences import says
from small_scenarios import kernels

import clpt_control as clpt

PAPER = clpt.paper_scenario()
OTHER = {
    "kernel": "exponential",
    "centers": [[0.0, 0.0], [10.0, 10.0], [5.0, 5.0], [-4.0, 2.0]],
    "widths": [5.0, 5.0, 5.0, 3.0],
    "periods": [12.42, 10.42, 24.42, 30.0],
    "parameters": [[1.0, 0.4, 0.8, 0.3], [0.9, 0.4, 0.8, -0.3]],
}


def test_a_true_flow_may_have_other_functions_than_the_learner():
    values = {"flow.parameters": None, "flow.basis": OTHER, "run.duration": 40.0}
    scenario = PAPER.with_values(values)
    run = clpt.simulate(scenario)
    x = run.position.values
    phi = [kernels(scenario.flow, t, x[[k]])[0] for k, t in enumerate(run.time.values)]
    true = np.array(phi) @ np.transpose(OTHER["parameters"])
    np.testing.assert_allclose(run.true_flow, true, atol=1e-12)
    assert "flow_parameters" not in run  # there are none of the learner's functions
    assert "lyapunov" not in run
    flow = clpt.flow_map(run)
    assert 0.01 < flow.error.mean() < 1
    theta = run.flow_parameters_estimate.values
    late = run.time.values >= 30.0
    learned = np.einsum(
        "tak,tk->ta",
        theta,
        [kernels(PAPER, t, x[[k]])[0] for k, t in enumerate(run.time.values)],
    )
    off = ((true - learned)[late] ** 2).sum()
    about_mean = ((true - true[late].mean(0))[late] ** 2).sum()
    share = clpt.currents.explained_variance(scenario, run)["track"]
    assert share == pytest.approx(1 - off / about_mean, abs=1e-9)
    with pytest.raises(clpt.ScenarioError, match="learned-flow law in a flow with"):
        clpt.certify(scenario)
    for wrong, said in (
        ({"flow.parameters": PAPER.flow.parameters}, "one of parameters, field and"),
        ({"flow.basis": {**OTHER, "widths": [1.0]}}, r"flow\.basis\.widths has 1 ent"),
        ({"flow.basis": {**OTHER, "parameters": [[1.0], [1.0]]}}, "two rows of 4"),
    ):
        says(clpt.ScenarioError, rf"\A.*{said}.*\Z", scenario.with_values, wrong)


def test_the_same_functions_as_a_basis_of_the_flow_run_alike():
    basis = {**OTHER, "parameters": np.array(OTHER["parameters"])[:, :3].tolist()}
    basis |= {key: OTHER[key][:3] for key in ("centers", "widths", "periods")}
    values = {"flow.parameters": None, "flow.basis": basis, "run.duration": 40.0}
    own = clpt.simulate(PAPER.with_values(values))
    usual = clpt.simulate(PAPER.with_values({"run.duration": 40.0}))
    np.testing.assert_allclose(own.alpha, usual.alpha, atol=1e-12)
