"""One small ensemble, asked by many tests."""

import pytest
from sampled_runs import VARY

import clpt_control as clpt


@pytest.fixture(scope="module")
def scenario():
    """Two and a half rounds of the paper's waypoints, four times faster."""
    return clpt.paper_scenario().with_values(
        {"run.duration": 125, "reference.dwell": 5}
    )


@pytest.fixture(scope="module")
def quick(scenario):
    return scenario.with_values({"run.duration": 10})


@pytest.fixture(scope="module")
def whole(scenario):
    """One thread, one chunk, trajectories: what all other ways must give."""
    return clpt.run_ensemble(scenario, VARY, 40, seed=3, threads=1, trajectories=True)
