"""What a law promises where a track shows less later, or the truth is large."""

import numpy as np
import pytest
from law_blocks import HELD

import clpt_control as clpt

CIRCLE = [[3 * np.cos(a), 3 * np.sin(a)] for a in 2 * np.pi * np.arange(10) / 10]


def once_round(law, duration, **more):
    """A round through a steady flow, and rest at one place for the other time."""
    rest = [[1.5, 1.0]] * int(duration / 20)
    return clpt.paper_scenario().with_values(
        {
            "basis.periods": [np.inf] * 3,
            "reference": {"kind": "waypoints", "points": CIRCLE + rest, "dwell": 20},
            "learning.law": law,
            "run.duration": duration,
            "run.output_step": 50,
            **more,
        }
    )


def least_eigenvalue(run, name):
    at = [label.startswith(f"adaptation_{name}[") for label in run.state.values]
    return np.linalg.eigvalsh(run.states.values[:, at].reshape(-1, 3, 3))[:, 0]


@pytest.mark.parametrize("held", [{}, HELD], ids=["adapted", "held"])
@pytest.mark.parametrize(
    ("law", "memory"), [("concurrent", "S"), ("composite-memory", "Q")], ids=lambda one: one
)
def test_a_law_with_a_memory_learns_exponentially_after_one_round(law, memory, held):
    run = clpt.simulate(once_round(law, 2400.0, **held))
    off = np.abs(run.flow_parameters_estimate - run.flow_parameters).max(["axis", "basis"])
    at = {t: float(off.sel(time=t, method="nearest")) for t in (400, 800, 1600)}
    assert at[400] > 1e-6
    assert at[800] < 0.5 * at[400]
    fallen = np.log(at[400] / at[800])
    assert np.log(at[800] / max(at[1600], 1e-11)) >= min(2 * fallen, np.log(at[800] / 1e-11)) * 0.9
    assert np.all(np.diff(least_eigenvalue(run, memory)) >= -1e-7)


@pytest.mark.parametrize("law", ["projection", "switching-sigma"])
def test_usual_limits_leave_room_for_a_large_feedforward(law):
    def late(law):
        values = {"learning.law": law, "vehicle.feedforward": [3, 3], "run.duration": 400}
        run = clpt.simulate(clpt.paper_scenario().with_values(values))
        return run.clpe.values, run.attrs["message"]

    np.testing.assert_allclose(late(law)[0], late("learned-flow")[0], atol=1e-5)
    assert "truth" not in late(law)[1]


@pytest.mark.parametrize("law", ["projection", "switching-sigma"])
def test_a_truth_outside_the_limits_is_said(law):
    table = law.replace("-", "_")
    values = {"learning.law": law, "run.duration": 2, f"learning.{table}.largest_feedforward": 1.0}
    outside = clpt.paper_scenario().with_values(values)
    said = clpt.simulate(outside).attrs["message"]
    assert "largest_feedforward = 1 is below the truth's 1.41: CLPE need not go to zero" in said
    assert "truth" not in clpt.simulate(outside.with_values(HELD)).attrs["message"]


@pytest.mark.parametrize(
    ("more", "beside"),
    [
        ({}, None),
        ({"flow.disturbance": {"kind": "constant", "amplitude": [0.1, 0]}}, "flow.disturbance"),
        ({"localization": {"noise": 0.02, "noise_period": 1.0}}, "localization.noise"),
    ],
    ids=["all of the basis", "disturbance", "noise"],
)
def test_a_readout_that_is_not_theta_is_marked(more, beside):
    values = {"learning.law": "drem", "run.duration": 100, **more}
    run = clpt.simulate(clpt.paper_scenario().with_values(values))
    off = np.abs(run.flow_parameters_readout - run.flow_parameters).isel(time=-1).max()
    assert (off > 1e-3) == (beside is not None)
    said = run.flow_parameters_readout.attrs.get("comment", "")
    assert said == (f"not theta exactly: {beside} is taken for flow of the basis" * bool(beside))
