"""The proof desk: what is printed, what holds, what fails, and by which counterexample."""

import os

import numpy as np
import pytest

import clpt_control as package
from analysis.theorems import page
from clpt_control.paper.blocks import learner, vehicle
from clpt_control.paper.laws import consensus as blocks
from clpt_control.paper.laws.table import LAWS
from clpt_control.simulation.summary import run_and_report
from clpt_control.theory import audit, counterexamples, misprints
from clpt_control.theory.excitation.certificates import certificate
from clpt_control.theory.proofs import all_proofs
from clpt_control.theory.proofs.all_proofs import LIMITED_SPEED, statements
from clpt_control.theory.proofs.cached_verdicts import CachedOutcomes, prove_all
from clpt_control.theory.proofs.steps import (
    Step,
    checked,
    cited,
    proof_or_failure,
    theorem,
)
from clpt_control.theory.proofs.team_proof import GRAPHS, team_steps


@pytest.fixture(scope="module")
def proofs():
    """The theorems' proofs, kept as `clpt prove` keeps them."""
    wanted, kept = (
        [one for one in statements() if one.room == "theorems"],
        CachedOutcomes(),
    )
    kept.store(prove_all([one for one in wanted if one not in kept.outcomes]))
    return {one.name: kept.outcomes[one] for one in wanted}


FOUND = {  # number -> status, whether a part is cited, points at which the blocks are called
    "3.1": ("corrected", False, [1000]),
    "3.2": ("proved", False, [10_000]),
    "3.3": ("corrected", False, []),
    "3.4": ("corrected", False, [1000]),
}


@pytest.mark.parametrize("number", FOUND)
def test_what_is_found_of_a_theorem(proofs, number):
    (status, cites, points), proof = FOUND[number], proofs[number]
    hows = [step.how for step in proof.steps]
    assert (proof.status, proof.for_every_N) == (status, True)
    assert all(
        step.holds and (step.every_N or step.how != "exact") for step in proof.steps
    )
    assert bool(proof.cited) == ("cited" in hows) == cites
    assert (
        bool(proof.corrected) == ("counterexample" in hows) == (status == "corrected")
    )
    called = [step.detail for step in proof.steps if step.how == "sampled"]
    assert [text.split(" points")[0] for text in called] == [
        f"N = 3, {n}" for n in points
    ]
    assert all((proof.assumptions, proof.not_proved, proof.as_expected))
    one = Step("for N = 2 alone", True, "exact", every_N=False)
    assert not theorem("", (), (*proof.steps, one), "").for_every_N


@pytest.mark.parametrize("number", range(len(misprints())))
def test_a_misprint_fails_as_printed_and_passes_corrected(number):
    misprint = misprints()[number]
    assert (misprint.holds(True), misprint.holds(False), misprint.confirmed) == (
        False,
        True,
        True,
    )


@pytest.mark.usefixtures("few_calls")
def test_prove_prints_json(printed, monkeypatch):
    """By this process alone; `test_cached_proofs` asks two."""
    monkeypatch.setattr(os, "cpu_count", lambda: 1)
    found = printed("prove")
    theorems, limited, team, laws = (
        found[room] for room in ("theorems", "limited_speed", "team", "laws")
    )
    statuses = {name: one["status"] for name, one in theorems.items()}
    assert statuses == {name: status for name, (status, *_) in FOUND.items()}
    hows = {step["how"] for one in theorems.values() for step in one["steps"]}
    assert hows == {"exact", "counterexample", "sampled"}
    assert {"equation", "printed", "corrected", "check"} <= set(found["misprints"][0])
    assert {
        name: (one["status"], one["for_every_N"]) for name, one in limited.items()
    } == {
        "with hedging": ("proved", True),
        "every law with hedging": ("proved", False),
        "without hedging": ("corrected", True),
    }
    (of_laws,) = limited["every law with hedging"]["steps"]
    assert of_laws["detail"].split(", ") == [
        law.name for law in LAWS.values() if not law.at_fixes
    ]
    assert limited["without hedging"]["corrected"].startswith("int |e|^2")
    assert (team["status"], team["for_every_N"]) == ("proved", True)
    assert [step["how"] for step in team["steps"]] == [
        *["exact"] * len(GRAPHS),
        "sampled",
    ]
    assert list(laws) == list(LAWS)
    for one in laws.values():
        bounded, holds = (
            one["status"] == "bounded",
            [step["holds"] for step in one["steps"]],
        )
        assert one["claim"]
        assert bounded or (one["status"], all(holds)) == ("proved", True)
        assert any(step["how"] == "sampled" and step["holds"] for step in one["steps"])
    for name, status in (("learned-flow", "proved"), ("known-flow", "bounded")):
        assert (laws[name]["status"], laws[name]["for_every_N"]) == (status, True)


def test_prove_one_theorem_and_refuse_another(clpt, refused):
    outcome = clpt("prove", "--theorem", "3.2")
    assert outcome.status == 0
    assert "Theorem 3.2: proved" in outcome.out
    assert "Misprints" not in outcome.out
    assert "3.1, 3.2, 3.3, 3.4" in refused("prove", "--theorem", "4.1")


TURNS = [
    (lambda p: np.where(p.gain == 0.8, -1.0, 1.0), "left over"),
    (
        lambda p: -1.0 if p.gain == 0.8 else 1.0,
        "asks for the value of its parameter gain",
    ),
]


@pytest.mark.parametrize(("turn", "said"), TURNS, ids=["where", "if"])
def test_a_law_that_turns_at_the_papers_gain_is_not_proved(monkeypatch, turn, said):
    right = LAWS["learned-flow"]

    def rates(t, x, u, p):
        """Eqs. (21)-(23), turned where the gain is the paper's own."""
        return {port: turn(p) * rate for port, rate in right.rates(t, x, u, p).items()}

    monkeypatch.setitem(LAWS, "learned-flow", right._replace(rates=rates))
    proof = audit("3.2")["3.2"]
    assert proof.status == "failed"
    assert said in proof.failed[0].detail


def test_a_step_that_cannot_be_checked_fails():
    def fails(error):
        raise error

    step = checked(
        "V falls", lambda: fails(package.DiagramError("alpha' has no value"))
    )
    assert (step.holds, step.detail) == (
        False,
        "cannot be checked: alpha' has no value",
    )
    for asked in (checked, proof_or_failure):
        # an error of the package says nothing of a claim
        with pytest.raises(ZeroDivisionError):
            asked("one over zero", lambda: 1 / 0)


def test_sampled_steps_alone_prove_nothing():
    sampled, exact = Step("seen often", True, "sampled"), Step("shown", True, "exact")
    assert theorem("", (), (sampled,), "").status == "sampled"
    assert theorem("", (), (exact, cited("known", "a book")), "").status == "cited"
    assert theorem("", (), (exact,), "", corrected="better").status == "failed"


def test_the_page(proofs):
    text = page(proofs, misprints())
    assert text.count("## Theorem") == 4
    assert "**no**" not in text


PAPER = package.paper_scenario()


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    monkeypatch.setattr(all_proofs, "POINTS", 200)


def test_clpe_of_the_papers_run_goes_to_zero_with_hedging_and_not_without():
    told, untold = (
        run_and_report(
            PAPER.with_values({"vehicle.max_speed": 1.5, "learning.hedging": hedging})
        ).summary["clpe_rms_per_cycle"][-1]
        for hedging in (True, False)
    )
    assert told < min(1e-2, untold / 10)


def test_a_certificate_holds_along_a_hedged_run_and_is_refused_without():
    scenario = PAPER.with_values({"vehicle.max_speed": 1.5, "run.duration": 100})
    found = certificate(scenario, 80.0, 20.0)
    V = package.simulate(scenario, [0.0, 20.0, 100.0]).lyapunov.values
    assert V[2] / V[1] <= found.contraction < 1
    with pytest.raises(
        package.ScenarioError, match=r"no certificate: learning\.hedging = false"
    ):
        certificate(scenario.with_values({"learning.hedging": False}), 80.0, 20.0)


def added(t, x, u, p):
    """z' = F_M + v + d, not Eq. (2) hedged."""
    return u.flow_z + u.v_z + getattr(u, "unflown", 0.0)


def too_fast(t, x, u, p):
    """v = 2 v_c, no limit, for Eq. (1)."""
    return 2 * u.v_c


WRONG = [
    (learner, "model", added, "V' = -e^T KD e"),
    (vehicle, "limited", too_fast, "up to |v_c| = v_max"),
    (vehicle, "difference", too_fast, "V' = -e^T KD e"),
]


@pytest.mark.parametrize(("module", "name", "wrong", "claim"), WRONG)
def test_a_wrong_equation_is_not_proved(module, name, wrong, claim, monkeypatch):
    monkeypatch.setattr(module, name, wrong)
    proof = proof_or_failure("failed", LIMITED_SPEED["with hedging"])
    assert proof.status == "failed"
    assert any(claim in step.claim for step in proof.failed)


def test_a_law_that_reads_the_velocity_reads_the_flown_one():
    """Of the composite laws `blocks/test_composite_laws` asks it."""
    held = {
        "learning.adapt_gains": False,
        "learning.gain": None,
        "vehicle.max_speed": 1.0,
    }
    held |= {"learning.feedback": [1.0, 1.0], "learning.feedforward": [1.0, 1.0]}
    values = {
        "learning.law": "kalman-flow",
        "learning.parameters": None,
        "run.duration": 200,
    }
    run = package.simulate(PAPER.with_values({**values, **held, "run.rtol": 1e-10}))
    assert run.attrs["share_at_speed_limit"] > 0.2
    error = run.flow_parameters_estimate[-1].values - np.array(PAPER.flow.parameters)
    assert np.abs(error).max() < 5e-3


def together(t, x, u, p):
    """pull = -kappa sum_j (alpha + alpha_j), section III with a wrong sign."""
    own = (u.alpha + getattr(u, f"alpha_{j}") for j in range(p.neighbours))
    return {"pull": -p.coupling * sum(own)}


def one_sided(self, name):
    """One hears the other, who does not hear back: V' is not that of the edge."""
    return ["b"] if name == "a" else []


@pytest.mark.parametrize(
    ("of", "name", "wrong"),
    [(blocks, "consensus", together), (package.Team, "neighbours", one_sided)],
)
def test_a_wrong_team_is_not_proved(of, name, wrong, monkeypatch):
    monkeypatch.setattr(of, name, wrong)
    step = next(team_steps())
    assert not step.holds
    assert "left over" in step.detail


def test_33_is_violated_on_the_papers_system():
    """Against an independent simulation's figures."""
    found = counterexamples.disturbance_counterexample()
    assert found.claimed == pytest.approx(0.05)
    assert (found.ratio, found.rms) == pytest.approx((1.435, 0.586), rel=0.01)
    assert (found.k, found.peak) == (1, pytest.approx(0.05 * found.ratio))


def test_16_is_violated_on_the_papers_system():
    """At a slow gain, with one of the six flow parameters off by 0.1 m/s."""
    found = counterexamples.known_flow_counterexample()
    assert (found.equation, found.ratio) == ("(16)", pytest.approx(1.367, rel=0.01))
    assert found.rms < 1
    cycles = [
        found.size[(found.times >= t) & (found.times < t + 200)].max()
        for t in (600, 800)
    ]
    assert min(cycles) > 1.2 * found.claimed


@pytest.mark.parametrize("gain", [25.0, 100.0, 400.0])
def test_the_square_wave_at_resonance_gives_four_over_pi(gain):
    found = counterexamples.square_wave_counterexample(gain=gain, periods=80)
    assert found.ratio == pytest.approx(4 / np.pi, rel=0.01)
    assert found.rms < 1


@pytest.mark.parametrize(
    ("faint", "quiet", "peak"),
    [(0.2, 250, 2.19), (0.1, 1000, 4.92), (0.05, 4000, 10.38)],
)
def test_drift_then_burst(faint, quiet, peak):
    found = counterexamples.burst_counterexample(faint, quiet)
    assert found.peak == pytest.approx(peak, rel=0.02)  # near 0.52/faint
    assert found.rms < 1


def test_no_faint_stretch_no_burst():
    """The measure can say no: with a steady regressor a steady Delta is learned away."""
    assert counterexamples.burst_counterexample(faint=1.0).ratio < 1e-3


def test_zc_exciting_is_not_enough():
    found, n, dwell, radius = counterexamples.unlearned_counterexample(), 10, 20, 3
    assert found.kappa == pytest.approx(n * dwell * radius**2 / 2)
    assert found.moved < 1e-9
    assert found.error == pytest.approx(0.4, abs=1e-9)


def test_a_field_has_no_bound_to_compare_with():
    flow = PAPER.flow.model_copy(update={"parameters": None, "field": "current.nc"})
    with pytest.raises(package.ScenarioError, match="gridded field"):
        counterexamples.drive_along(PAPER.model_copy(update={"flow": flow}), None)
