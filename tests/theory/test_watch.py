"""Transition matrix of the errors, carried beside a loop: |x(t)| <= |Phi(t)| |x(0)| + int |g|.

x has the errors in coordinates in which V is |x|^2 / 2.  Norms are by SciPy, bounds by runs.
"""

import numpy as np
import pytest

import clpt_control as clpt

PAPER = clpt.paper_scenario()


def errors_of(run, scenario):
    """|x| of each axis, (times, 2), by hand: e, then eta over the root of gamma."""
    theta, vehicle = np.array(scenario.flow.parameters), scenario.vehicle
    squares = (
        np.sum((run.alpha.values.reshape(-1, 2, 3) + theta) ** 2, axis=2)
        + (run.K.values - vehicle.feedback) ** 2
        + (run.Gamma.values - vehicle.feedforward) ** 2
    )
    return np.sqrt(run.e.values**2 + squares / scenario.learning.gain)


@pytest.mark.sampled
@pytest.mark.parametrize("seed", range(20))
def test_errors_of_each_run_are_below_the_carried_matrix(seed):
    """Twenty starts and disturbances, the blocks of one gramian."""
    rng = np.random.default_rng(seed)
    watch = clpt.gramian(PAPER, 50.0, 0.0).watch
    push = rng.uniform(0, 0.3, 2)
    sine = {"kind": "sine", "amplitude": push.tolist(), "period": rng.uniform(1, 60)}
    scenario = PAPER.with_values({"flow.disturbance": sine})
    wired = clpt.connect([*clpt.closed_loop(scenario).syslist, *watch])
    start = [
        rng.uniform(-2, 2) * label.startswith("adaptation")
        for label in wired.state_labels
    ]
    run = clpt.simulate(wired, np.linspace(0, 200, 401), initial_state=start, rtol=1e-8)
    errors = errors_of(run, scenario)
    for k, axis in enumerate(("x1", "x2")):
        factor = run[f"factor_{axis}"].values.ravel()
        assert factor[0] == pytest.approx(1.0)
        assert 0.3 < factor[-1] < 0.97
        bound = factor * errors[0, k] + push[k] * run.time.values
        assert np.all(errors[:, k] <= bound * (1 + 1e-6))
        assert np.any(errors[:, k] > push[k] * run.time.values)
