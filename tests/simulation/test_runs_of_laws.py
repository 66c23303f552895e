"""Every law of the table runs, at all times or at samples, and so does a law of no table."""

import law_blocks
import numpy as np
import pytest
from error_sentences import says
from law_blocks import EACH, HELD
from scipy.integrate import simpson

import clpt_control as clpt
from clpt_control import ClptError, DiagramError, ScenarioError

PAPER = clpt.paper_scenario().with_values({"run.duration": 40})
LAWS = clpt.laws()
AT_FIXES = {
    "localization": {"interval": 5.0},
    **dict.fromkeys(("learning.gain", "learning.feedback", "learning.feedforward")),
}


def with_law(name, **more):
    """The paper's scenario with a law of the table."""
    given = LAWS[name].given_estimate
    theta = [[0.9, 0.5, 0.7], [0.8, 0.5, 0.9]] if given else None
    alpha = None if LAWS[name].alpha_is_constant else [[0.0] * 3] * 2
    values = {"learning.law": name, "learning.theta_estimate": theta}
    values |= AT_FIXES if LAWS[name].at_fixes else {}
    return PAPER.with_values({**values, "learning.parameters": alpha, **more})


@pytest.mark.parametrize("name", LAWS)
def test_every_law_runs_and_keeps_its_V(name, tmp_path):
    scenario = with_law(name)
    run = clpt.simulate(scenario)
    assert run.attrs["status"] == "finished"
    assert run.lyapunov.shape == run.time.shape
    assert np.all(run.lyapunov.values >= 0)
    clpt.save_run(run, tmp_path / "run.nc")
    again = clpt.load_scenario(tmp_path / "run.nc")
    assert again == scenario
    np.testing.assert_array_equal(clpt.simulate(again).alpha, run.alpha)


@pytest.mark.parametrize("name", ["known-flow", "composite-memory"])
def test_gains_that_are_held_stay(name):
    """That no law's rates move them is asked of blocks."""
    held = {
        "learning.adapt_gains": False,
        "run.duration": 20,
        "learning.feedback": [0.7, 1.1],
    }
    run = clpt.simulate(with_law(name, **held, **{"learning.feedforward": [0.9, 1.2]}))
    np.testing.assert_array_equal(run.feedback_gain, np.tile([0.7, 1.1], (21, 1)))
    np.testing.assert_array_equal(run.feedforward_gain, np.tile([0.9, 1.2], (21, 1)))


@pytest.mark.parametrize(
    "values",
    [{}, {"learning.gain": None, "learning.gains": EACH}, HELD],
    ids=["one gain", "a gain each", "gains held true"],
)
def test_V_of_the_papers_law_falls_by_what_e_takes(values):
    """V(end) - V(0) is -int e^T KD e, by Simpson's rule, of which a waypoint ends a parabola."""
    scenario = PAPER.with_values(values)
    times = np.linspace(0.0, scenario.run.duration, 8001)
    run = clpt.simulate(scenario, times, rtol=1e-11, atol=1e-13)
    taken = run.clpe.values**2 @ np.array(scenario.vehicle.feedback)
    V = run.lyapunov.values
    assert V[0] - V[-1] == pytest.approx(simpson(taken, x=times), rel=1e-8)


def test_what_a_block_remembers_starts_at_zero_and_is_wired():
    law = law_blocks.remembering_law()
    loop, alone = (clpt.closed_loop(PAPER, external=e, law=law) for e in ((), "x"))
    run = clpt.simulate(loop)
    assert run.states.shape[1] == len(clpt.initial_state(loop)) == 15
    np.testing.assert_allclose(run.states[:, -1], 0.5 * run.time, rtol=1e-12)
    assert np.all(run.feedback_gain.values == 0)
    assert run.alpha.values[-1].any()
    assert alone.nstates == len(clpt.initial_state(alone)) == 13


def test_a_blocks_own_gain_is_its_own():
    faster = clpt.simulate(PAPER.with_values({"learning.gain": 2.0}))
    for own, params in (({"gain": 2.0}, None), ({}, {"adaptation.gain": 2.0})):
        loop = clpt.closed_loop(
            PAPER, law=law_blocks.papers_law(name="adaptation", **own)
        )
        run = clpt.simulate(loop, params=params)
        np.testing.assert_array_equal(run.alpha, faster.alpha)
        assert "learning" in run.attrs["scenario"]
        assert params is None or "adaptation.gain" in run.attrs["parameters_changed"]


@pytest.mark.sampled
@pytest.mark.parametrize("name", ["learned-flow", "known-flow"])
def test_a_gain_of_zero_is_without_learning(name):
    scenario = with_law(name, **{"learning.gain": 0})
    run = clpt.simulate(scenario)
    for made in ("alpha", "feedback_gain", "feedforward_gain"):
        assert np.ptp(run[made].values, axis=0).max() == 0
    np.testing.assert_array_equal(run.lyapunov, (run.clpe.values**2).sum(-1) / 2)
    nearly = clpt.simulate(with_law(name, **{"learning.gain": 1e-12}))
    np.testing.assert_allclose(run.clpe, nearly.clpe, atol=1e-6)
    varied = clpt.run_ensemble(scenario, "learning.gain=[0, 0.8]", 2)
    own = varied.clpe_rms_whole.values[varied["learning.gain"].values == 0]
    rms = float(np.sqrt((nearly.clpe**2).sum("axis").mean()))
    np.testing.assert_allclose(own, rms, rtol=0.05)


def test_a_gain_of_zero_is_refused_where_nothing_is_without_it():
    for name in (name for name, law in LAWS.items() if law.settings):
        says(ScenarioError, r"learning\.gain: ", with_law, name, **{"learning.gain": 0})
    with pytest.raises(ScenarioError, match=r"learning\.gain = 0"):
        clpt.certify(with_law("learned-flow", **{"learning.gain": 0}))
    each = PAPER.with_values({"learning.gain": None, "learning.gains": EACH})
    with pytest.raises(DiagramError, match=r"Eqs. \(27\)-\(28\) are of law"):
        clpt.closed_loop(each, errors=True)


FINE = {"run.output_step": 5, "run.rtol": 1e-9, "learning.sample": 0.05}
SLOW = clpt.paper_scenario().with_values(
    {"learning.gain": 0.05, "run.duration": 20, "run.output_step": 5, "run.rtol": 1e-11}
)


def own_law(scenario):
    (law,) = (
        block for block in clpt.paper_blocks(scenario) if block.name == "adaptation"
    )
    return law


@pytest.mark.parametrize("period", [0.1, 1.0, 5.0])
def test_a_law_that_is_sampled_is_the_sampled_block(period):
    """Which is Euler's rule between samples: tests/engine/solver/test_sampled_parts."""
    run = clpt.simulate(SLOW.with_values({"learning.sample": period}))
    block = clpt.Sampled(own_law(SLOW), period)
    own = clpt.simulate(clpt.closed_loop(SLOW, law=block))
    for name in (
        "position",
        "predicted_position",
        "alpha",
        "feedback_gain",
        "feedforward_gain",
    ):
        np.testing.assert_allclose(run[name], own[name], rtol=1e-9, atol=1e-12)
    assert run.attrs["engine"] == "native"


@pytest.mark.parametrize(
    "law", ["known-flow", "kalman-flow", "composite-memory", "drem"]
)
def test_every_engine_samples_a_law(law):
    """A law's own states begin where they do without samples."""
    scenario = with_law(law).with_values(
        {"learning.gain": 0.05, "run.duration": 1} | FINE
    )
    native, python = (
        clpt.simulate(scenario, engine=engine) for engine in ("native", "python")
    )
    np.testing.assert_allclose(native.states, python.states, rtol=1e-6, atol=1e-9)


def test_the_scenarios_method_runs():
    stiff = SLOW.with_values({"run.method": "rodas5p", "run.rtol": 1e-6})
    for system in (stiff, clpt.closed_loop(stiff)):
        assert clpt.simulate(system).attrs["method"] == "Rodas5P"
    found = clpt.simulate(SLOW.with_values({"run.rtol": 1e-6}), method="rodas5p")
    assert 'method = "rodas5p"' in found.attrs["scenario"]
    with pytest.raises(ScenarioError, match=r"run\.method = 'euler': must be"):
        SLOW.with_values({"run.method": "euler"})
    explicit, members = (
        stiff.with_values({"run.method": "dop853"}),
        {"learning.gain": [0.1, 0.2]},
    )
    alpha, other = (
        clpt.run_ensemble(one, members, trajectories=True).alpha.values
        for one in (stiff, explicit)
    )
    for m, gain in enumerate((0.1, 0.2)):
        alone = clpt.simulate(stiff.with_values({"learning.gain": gain}))
        np.testing.assert_allclose(alpha[m], alone.alpha, rtol=0, atol=1e-6)
    assert not np.array_equal(alpha, other)


def test_what_is_not_sampled_says_so():
    sampled, end = SLOW.with_values({"learning.sample": 1.0}), SLOW.run.duration
    fixes = {
        "learning": {"law": "fix-regression", "sample": 1.0},
        "localization.interval": 5.0,
    }
    SLOW.with_values({"learning.sample": end})
    both = {"a": sampled, "b": sampled.with_values({"vehicle.position": [1.0, 0.0]})}
    for said, ask in {
        "sample yours by": lambda: clpt.closed_loop(sampled, law=own_law(SLOW)),
        "proofs are for continuous time. Prove": lambda: clpt.prove(
            clpt.closed_loop(sampled)
        ),
        r"learning\.sample cannot vary; ": lambda: clpt.run_ensemble(
            sampled, "learning.sample=1:2", 2
        ),
        r"learning.sample: .* has no use for it": lambda: SLOW.with_values(fixes),
        r"nothing is learned before t = .*; must be at most": (
            lambda: SLOW.with_values({"learning.sample": 1.01 * end})
        ),
        "a team learns at all times": lambda: clpt.Team(
            members=both, edges=[("a", "b")], coupling=0.5
        ),
    }.items():
        says(ClptError, said, ask)
