"""`learning.sample`: a scenario's law at samples."""

import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.errors import ClptError, DiagramError, ScenarioError

SLOW = clpt.paper_scenario().with_values(
    {"learning.gain": 0.05, "run.duration": 20, "run.output_step": 5, "run.rtol": 1e-11}
)


def own_law(scenario):
    (law,) = (block for block in clpt.paper_blocks(scenario) if block.name == "adaptation")
    return law


@pytest.mark.parametrize("period", [0.1, 1.0, 5.0])
def test_a_law_that_is_sampled_is_the_sampled_block(period):
    """Which is Euler's rule between samples: tests/native/test_sampled_parts."""
    run = clpt.simulate(SLOW.with_values({"learning.sample": period}))
    block = clpt.equations.Sampled(own_law(SLOW), period)
    own = clpt.simulate(clpt.closed_loop(SLOW, law=block))
    for name in ("position", "predicted_position", "alpha", "feedback_gain", "feedforward_gain"):
        np.testing.assert_allclose(run[name], own[name], rtol=1e-9, atol=1e-12)
    assert run.attrs["engine"] == "native"


@pytest.mark.parametrize("law", ["known-flow", "kalman-flow", "composite-memory", "drem"])
def test_every_engine_samples_a_law(law):
    """A law's own states begin where they do without samples."""
    own = {"learning.law": law, "learning.parameters": None, "run.duration": 1}
    own |= {"learning.theta_estimate": np.ones((2, 3)).tolist()} if law == "known-flow" else {}
    scenario = SLOW.with_values({**own, "learning.sample": 0.05, "run.rtol": 1e-9})
    native, python = (clpt.simulate(scenario, engine=engine) for engine in ("native", "python"))
    np.testing.assert_allclose(native.states, python.states, rtol=1e-6, atol=1e-9)


def test_the_scenarios_method_runs():
    stiff = SLOW.with_values({"run.method": "rodas5p", "run.rtol": 1e-6})
    for system in (stiff, clpt.closed_loop(stiff)):
        assert clpt.simulate(system).attrs["method"] == "Rodas5P"
    found = clpt.simulate(SLOW.with_values({"run.rtol": 1e-6}), method="rodas5p")
    assert 'method = "rodas5p"' in found.attrs["scenario"]
    with pytest.raises(ScenarioError, match=r"run\.method = 'euler': must be"):
        SLOW.with_values({"run.method": "euler"})
    explicit, members = stiff.with_values({"run.method": "dop853"}), {"learning.gain": [0.1, 0.2]}
    alpha, other = (
        clpt.run_ensemble(one, members, trajectories=True).alpha.values for one in (stiff, explicit)
    )
    for m, gain in enumerate((0.1, 0.2)):
        alone = clpt.simulate(stiff.with_values({"learning.gain": gain}))
        np.testing.assert_allclose(alpha[m], alone.alpha, rtol=0, atol=1e-6)
    assert not np.array_equal(alpha, other)


def test_what_is_not_sampled_says_so():
    sampled = SLOW.with_values({"learning.sample": 1.0})
    with pytest.raises(DiagramError, match="sample yours by"):
        clpt.closed_loop(sampled, law=own_law(SLOW))
    with pytest.raises(DiagramError, match="proofs speak of continuous time alone"):
        clpt.theory.prove(clpt.closed_loop(sampled))
    with pytest.raises(ScenarioError, match=r"learning\.sample cannot vary; "):
        clpt.ensemble.run_ensemble(sampled, vary="learning.sample=0.5:2.0", members=2)
    with pytest.raises(ScenarioError, match=r"learning.sample: .* has no use for it"):
        SLOW.with_values(
            {"learning": {"law": "fix-regression", "sample": 1.0}, "localization.interval": 5.0}
        )
    end = SLOW.run.duration
    SLOW.with_values({"learning.sample": end})
    with pytest.raises(ScenarioError, match=r"nothing is learned before t = .*; must be at most"):
        SLOW.with_values({"learning.sample": 1.01 * end})
    both = {"a": sampled, "b": sampled.with_values({"vehicle.position": [1.0, 0.0]})}
    with pytest.raises(ClptError, match="a team learns at all times"):
        clpt.Team(members=both, edges=[("a", "b")], coupling=0.5)
