"""Tuning: the answer stays unseen, the fast or the robust law is taken where it is obvious."""

import numpy as np
import pytest
from error_sentences import says

import clpt_control
from clpt_control import ScenarioError, tune_law
from clpt_control.ensemble.candidates import (
    LawDesign,
    belief,
    candidate,
    factors_of,
    laws_to_try,
    unknown_of,
)
from clpt_control.ensemble.tune import Score, ranked
from clpt_control.paper.laws.table import LAWS


@pytest.fixture(scope="module")
def paper():
    return clpt_control.paper_scenario().with_values({"run.duration": 200})


@pytest.fixture(scope="module")
def short(paper):
    return paper.with_values({"run.duration": 40})


def scored(law, score, time=np.inf, failed=0, error=1.0):
    return Score(
        LawDesign(law, 1.0, False, None, {}), error, error, 1.0, time, score, failed
    )


def test_of_those_as_good_as_the_best_the_quickest_is_taken():
    near, best, far = (
        scored("a", 1.15, 3.0),
        scored("b", 1.0, 9.0),
        scored("c", 1.5, 1.0),
    )
    broken, endless = scored("d", 0.5, 0.5, failed=1), scored("e", np.inf)
    assert ranked([far, broken, best, endless, near]) == [near, best, far]
    assert ranked([broken, endless]) == []


def test_CLPE_of_members_does_not_hang_on_their_samples(paper):
    """With a strong feedback it peaks for an eighth of a second at each waypoint."""
    strong = paper.with_values(
        {"vehicle.feedback": [8, 8], "vehicle.feedforward": [8, 8]}
    )
    data = clpt_control.run_ensemble(strong, {"learning.gain": [0.8]})
    run = clpt_control.simulate(strong, np.linspace(0.0, 200.0, 20_001))
    square = np.sum(run.clpe.values**2, axis=1)
    rms = np.sqrt(np.trapezoid(square, run.time.values) / 200.0)
    assert data.clpe_rms.values[0, -1] == pytest.approx(rms, rel=1e-4)


@pytest.mark.long
def test_the_answer_is_not_seen_and_runs_are_by_the_scenarios_method(short):
    flow = {"flow.parameters": [[5, 6, 7], [8, 9, 10]]}
    usual, other, stiff = (
        tune_law(short.with_values(own), members=3, laws=["learned-flow"])
        for own in ({}, flow, {"run.method": "rodas5p"})
    )
    assert usual.report == other.report
    assert usual.scenario.learning == other.scenario.learning
    # it comes with the choice
    assert other.scenario.flow.parameters == ((5, 6, 7), (8, 9, 10))
    apart = abs(usual.report["chosen"]["error"] - stiff.report["chosen"]["error"])
    assert 0 < apart < 1e-6


def test_what_is_drawn_is_drawn_about_the_belief(paper):
    unknown = unknown_of(paper, None, None, 4)
    # k = 1/s, the circle reaches 3 m
    assert unknown.prior == pytest.approx(0.3 * 1.0 * 3.0)
    assert not np.any(unknown.scenario.flow.parameters)
    told = paper.with_values({"learning.parameters": [[-1, -2, -3], [0, 0, -4]]})
    modelled = paper.with_values({"model.parameters": [[1, 2, 3], [0, 0, 4]]})
    drawn_about = unknown_of(told, None, None, 4).scenario.flow.parameters
    for flow in (belief(told), drawn_about, belief(modelled)):
        np.testing.assert_array_equal(flow, [[1, 2, 3], [0, 0, 4]])
    noisy = paper.with_values({"localization": {"noise": 0.02, "noise_period": 1}})
    unknown = unknown_of(noisy, 0.5, 0.2, 4)
    assert [*unknown.varies] == [
        "flow.parameters",
        "flow.disturbance.seed",
        "localization.seed",
    ]
    assert (unknown.prior, unknown.noise) == (0.5, 0.02)
    assert unknown.unmodelled == pytest.approx(0.2)


@pytest.mark.parametrize("name", [law.name for law in laws_to_try(())[0]])
def test_every_law_that_learns_is_a_candidate(paper, name):
    law = LAWS[name]
    own = [candidate(paper, law, held) for held in (False, True)]
    tried = [(base.held, *by) for base in own for by in factors_of(base)]
    found = [*own, *(candidate(paper, law, *by) for by in tried)]
    assert len({one.text for one in found}) == len(found)
    for one in found:
        made = paper.with_values(one.values)
        assert made.learning.law == name
        assert made.learning.adapt_gains != one.held
        if one.held:
            assert made.learning.feedback == made.vehicle.feedback
        if one.filter is not None:
            parameters = law.block(made.known_to_law).parameters
            assert parameters.filter == pytest.approx(one.filter, rel=1e-12)


def test_laws_that_cannot_be_tuned_are_skipped_with_the_reason(paper):
    tried, skipped = laws_to_try(())
    assert "is given the flow" in skipped["known-flow"]
    assert set(skipped) == {
        law.name for law in LAWS.values() if law.given_estimate or law.at_fixes
    }
    assert [law.name for law in tried] == [name for name in LAWS if name not in skipped]
    own = {"learning": {"law": "fix-regression"}, "localization": {"interval": 5.0}}
    says(
        ScenarioError,
        "is the only law that learns at fixes",
        tune_law,
        paper.with_values(own),
    )


@pytest.mark.long
def test_the_fast_law_is_taken_where_nothing_disturbs(paper):
    tuned = tune_law(
        paper, members=4, laws=["learned-flow", "composite-memory"], seed=1
    )
    chosen, rest = tuned.report["chosen"], tuned.report["candidates"]
    assert chosen["law"] == "composite-memory"
    assert chosen["error"] < 1e-3 * min(
        a["error"] for a in rest if a["law"] == "learned-flow"
    )
    assert tuned.report["because"].startswith("composite-memory, gain")
    assert "no unmodelled flow and exact positions" in tuned.report["because"]
    # the scenario's own flow, which was not seen
    run = clpt_control.simulate(tuned.scenario)
    error = np.abs(run.flow_parameters_estimate[-1] - run.flow_parameters).max()
    assert float(error) < 1e-3


@pytest.mark.slow
def test_a_robust_law_is_taken_where_unmodelled_flow_is_ten_times_the_prior(paper):
    robust = ["learned-flow", "sigma", "e-modification"]
    longer = paper.with_values({"run.duration": 400})
    tuned = tune_law(longer, members=6, laws=robust, prior=0.05, unmodelled=0.5)
    assert tuned.report["chosen"]["law"] == "sigma"
    assert "unmodelled flow of 0.5 m/s" in tuned.report["because"]


@pytest.mark.long
def test_a_measured_current_is_taken_out(facts, tmp_path):
    from clpt_control.currents import fit_current

    field = facts.parents[1] / "clpt_control/data/maracoos_hfr_2019-01-01.nc"
    fit = fit_current(
        field, (40.9, 41.55, -69.9, -69.0), rows=1, columns=2, width_km=30.0
    )
    scenario = fit.save(tmp_path / "shoals.toml")
    tuned = tune_law(scenario, members=3, laws=["learned-flow"], unmodelled=0.5)
    assert tuned.scenario.field_path == scenario.field_path
    assert tuned.report["prior"] == pytest.approx(0.3 * 1.0 * 10.0)
    assert not np.any(tuned.report["belief"])


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"members": 2}, "members = 2: must be a whole number, 3 to"),
        ({"seed": -1}, "seed = -1"),
        ({"prior": 0.0}, "prior = 0: must be a positive speed"),
        ({"unmodelled": float("inf")}, "unmodelled = inf"),
        ({"laws": ["magic"]}, "laws: there is no magic"),
        ({"laws": ["known-flow"]}, "none of known-flow learns the flow"),
    ],
)
def test_what_cannot_be_tuned_is_refused(paper, arguments, said):
    says(clpt_control.ClptError, said, tune_law, paper, **arguments)


@pytest.mark.long
def test_the_command_writes_the_choice(clpt, printed, short, tmp_path):
    clpt_control.save_scenario(short, tmp_path / "mine.toml")
    file, laws = tmp_path / "mine.toml", ("--law", "sigma", "--law", "dead-zone")
    words = "tune", file, "--members", 3, *laws
    report = printed(*words, "--out", tmp_path / "tuned.toml")
    made, chosen = clpt_control.load_scenario(tmp_path / "tuned.toml"), report["chosen"]
    assert (made.learning.law, made.learning.gain) == (chosen["law"], chosen["gain"])
    assert made.flow == short.flow
    shown = clpt(*words)
    assert (shown.status, report["because"] in shown.out) == (0, True), shown.err
    assert clpt("tune", tmp_path / "mine.toml", "--law", "magic").status == 2
