"""Every law of the table runs, and so does a block that no table knows."""

import law_blocks
import numpy as np
import pytest
from law_blocks import EACH, TRUE_GAINS
from responses import response
from scipy.integrate import simpson

import clpt_control as clpt
from clpt_control.blocks.laws.table import LAWS
from clpt_control.errors import DiagramError, ScenarioError
from clpt_control.scenario.file import OWN_PARTS
from clpt_control.theory.proving.theorem_loop import AT_FIXES

PAPER = clpt.paper_scenario().with_values({"run.duration": 40})


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
    values = {"learning.adapt_gains": False, "run.duration": 20}
    start = {"learning.feedback": [0.7, 1.1], "learning.feedforward": [0.9, 1.2]}
    run = clpt.simulate(with_law(name, **values, **start))
    np.testing.assert_array_equal(run.feedback_gain, np.tile([0.7, 1.1], (21, 1)))
    np.testing.assert_array_equal(run.feedforward_gain, np.tile([0.9, 1.2], (21, 1)))


def balance(scenario):
    """V(end) - V(0) and -int e^T KD e, by Simpson's rule, of which a waypoint ends a parabola."""
    times = np.linspace(0.0, scenario.run.duration, 8001)
    run = clpt.simulate(scenario, times, rtol=1e-11, atol=1e-13)
    decay = np.sum(np.array(scenario.vehicle.feedback) * run.clpe.values**2, axis=1)
    return run.lyapunov.values[-1] - run.lyapunov.values[0], -simpson(decay, x=times)


@pytest.mark.parametrize(
    "values",
    [
        {},
        {"learning.gain": None, "learning.gains": EACH},
        {"learning.adapt_gains": False, **TRUE_GAINS},
    ],
    ids=["one gain", "a gain each", "gains held true"],
)
def test_V_of_the_papers_law_falls_by_what_e_takes(values):
    fallen, taken = balance(PAPER.with_values(values))
    assert fallen == pytest.approx(taken, rel=1e-8)


def test_equal_gains_each_are_one_gain():
    each = dict.fromkeys(EACH, 0.8)
    one = clpt.simulate(PAPER)
    three = clpt.simulate(PAPER.with_values({"learning.gain": None, "learning.gains": each}))
    np.testing.assert_allclose(three.alpha, one.alpha, rtol=0, atol=1e-9)
    np.testing.assert_allclose(three.lyapunov, one.lyapunov, rtol=0, atol=1e-9)


def test_what_a_block_remembers_starts_at_zero_and_is_wired():
    law = law_blocks.remembering_law()
    loop = clpt.closed_loop(PAPER, law=law)
    state = clpt.initial_state(loop)
    assert loop.nstates == len(state) == 15
    ran = response(loop, [0.0, 4.0], initial_state=state)
    assert ran.states[-1, -1] == pytest.approx(0.5 * 4.0, rel=1e-12)
    run = clpt.simulate(loop)
    assert np.all(run.feedback_gain.values == 0)
    assert run.alpha.values[-1].any()
    alone = clpt.closed_loop(PAPER, external="x", law=law)
    assert alone.nstates == len(clpt.initial_state(alone)) == 13


def test_a_blocks_own_gain_is_its_own():
    run = clpt.simulate(
        clpt.closed_loop(PAPER, law=law_blocks.papers_law(name="adaptation", gain=2.0))
    )
    faster = clpt.simulate(PAPER.with_values({"learning.gain": 2.0}))
    np.testing.assert_array_equal(run.alpha, faster.alpha)
    law = law_blocks.papers_law(name="adaptation")
    called = clpt.simulate(clpt.closed_loop(PAPER, law=law), params={"adaptation.gain": 2.0})
    np.testing.assert_array_equal(called.alpha, faster.alpha)
    assert "learning" in called.attrs["scenario"]
    assert "adaptation.gain" in called.attrs["parameters_changed"]


def test_an_initial_state_is_that_of_a_diagram():
    remembering = PAPER.with_values({"learning.law": "least-squares"})
    state = clpt.initial_state(remembering)
    state[-1] += 1.0
    run = clpt.simulate(remembering, initial_state=state)
    np.testing.assert_array_equal(clpt.state_at(run, 0), state)
    assert run.attrs[OWN_PARTS] == "closed_loop: run as a diagram"


@pytest.mark.parametrize(
    ("law", "said"),
    [
        ("sigma", "law = 'sigma': must be a Block"),
        (law_blocks.papers_law(N=2), r"alpha of N = 2 functions; the scenario has 3"),
        (clpt.paper_blocks(PAPER)[0], r"a law makes alpha\[2N\], K\[2\] and Gamma\[2\]"),
    ],
)
def test_what_is_no_law_for_the_scenario_is_refused(law, said):
    with pytest.raises(clpt.ClptError, match=said):
        clpt.closed_loop(PAPER, law=law)


def test_the_error_loop_is_of_the_papers_law():
    scenario = PAPER.with_values({"learning.gain": None, "learning.gains": EACH})
    with pytest.raises(DiagramError, match=r"Eqs. \(27\)-\(28\) are of law"):
        clpt.error_loop(scenario)


def test_no_certificate_for_a_law_that_it_is_not_of():
    run = clpt.simulate(
        clpt.closed_loop(PAPER, law=law_blocks.papers_law()), np.linspace(0, 40, 801)
    )
    with pytest.raises(ScenarioError, match=r"no certificate: .* the run has the law mine"):
        clpt.theory.certificate(run, 20.0, 0.0)
    assert clpt.theory.gramian(run, 20.0, 0.0).eigenvalues["x1"][0] > 0


@pytest.mark.parametrize("name", ["learned-flow", "known-flow"])
def test_a_gain_of_zero_is_without_learning(name, tmp_path):
    scenario = with_law(name, **{"learning.gain": 0})
    run = clpt.simulate(scenario)
    for made in ("alpha", "feedback_gain", "feedforward_gain"):
        assert np.ptp(run[made].values, axis=0).max() == 0
    np.testing.assert_array_equal(run.lyapunov, (run.clpe.values**2).sum(-1) / 2)
    nearly = clpt.simulate(with_law(name, **{"learning.gain": 1e-12}))
    np.testing.assert_allclose(run.clpe, nearly.clpe, atol=1e-6)
    clpt.save_run(run, tmp_path / "run.nc")
    assert clpt.load_scenario(tmp_path / "run.nc") == scenario
    varied = clpt.run_ensemble(scenario, "learning.gain=[0, 0.8]", 2)
    own = varied.clpe_rms_whole.values[varied["learning.gain"].values == 0]
    rms = float(np.sqrt((nearly.clpe**2).sum("axis").mean()))
    np.testing.assert_allclose(own, rms, rtol=0.05)
    if name == "learned-flow":
        with pytest.raises(ScenarioError, match=r"learning\.gain = 0"):
            clpt.certify(scenario)


@pytest.mark.parametrize("name", [name for name, law in LAWS.items() if law.settings])
def test_a_law_that_learns_by_its_own_table_refuses_a_gain_of_zero(name):
    with pytest.raises(ScenarioError, match=r"learning\.gain: "):
        with_law(name, **{"learning.gain": 0})
