"""A limited speed: hedging keeps V' of every law, and without it the theorem is lost."""

import numpy as np
import pytest
from responses import response

import clpt_control as clpt
from clpt_control.blocks import learner, vehicle
from clpt_control.diagrams.interconnection import connect
from clpt_control.errors import ScenarioError
from clpt_control.simulation.loops import paper_blocks
from clpt_control.theory.promises import truth_of
from clpt_control.theory.proving import all_proofs
from clpt_control.theory.proving.all_proofs import LIMITED_SPEED
from clpt_control.theory.proving.proof import proof_or_failure
from clpt_control.theory.proving.running_rate import Running

PAPER = clpt.paper_scenario()


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    monkeypatch.setattr(all_proofs, "POINTS", 200)


def rates_of_V(scenario):
    """V' along a run by the records of its blocks, and -e^T KD e, at its samples."""
    blocks, car = paper_blocks(scenario), scenario.vehicle
    V = scenario.learning.row.V(blocks[-1].parameters, truth_of(scenario))
    loop = connect([*blocks, V], name="with_V")
    times = np.arange(0.0, scenario.run.duration, scenario.run.output_step)
    states = response(loop, times, initial_state=clpt.initial_state(scenario)).states.T
    running, u = Running(loop), np.zeros((len(times), 0))
    rates, _ = running.by_records(times, states, u)
    largest, fastest = (np.max(np.abs(one), axis=1) for one in (states, rates))
    h = 0.1 * np.maximum(largest, 1e-3) / np.maximum(fastest, 1e-9)
    step = h[:, None] * rates
    ahead, behind = (running.by_records(times, x, u)[1] for x in (states + step, states - step))
    e = states[:, 0:2] - states[:, 2:4]
    return (ahead - behind) / (2 * h), -np.sum(np.array(car.feedback) * e**2, axis=1)


def test_V_falls_along_the_papers_run_as_without_a_limit():
    limited = PAPER.with_values({"vehicle.max_speed": 1.5, "run.duration": 200})
    rates, wanted = rates_of_V(limited)
    assert wanted.min() < -0.1
    np.testing.assert_allclose(rates, wanted, atol=1e-9)
    rates, wanted = rates_of_V(limited.with_values({"learning.hedging": False}))
    assert np.abs(rates - wanted).max() > 0.1
    assert rates.max() > 0.1


def test_clpe_of_the_papers_run_goes_to_zero_with_hedging_and_not_without():
    told, untold = (
        clpt.simulation.run_and_report(
            PAPER.with_values({"vehicle.max_speed": 1.5, "learning.hedging": hedging})
        ).summary["clpe_rms_per_cycle"][-1]
        for hedging in (True, False)
    )
    assert told < 1e-2
    assert untold > 10 * told


def test_a_certificate_holds_along_a_hedged_run_and_is_refused_without():
    scenario = PAPER.with_values({"vehicle.max_speed": 1.5, "run.duration": 100})
    found = clpt.theory.certificate(scenario, 80.0, 20.0)
    V = clpt.simulate(scenario, [0.0, 20.0, 100.0]).lyapunov.values
    assert V[2] / V[1] <= found.contraction < 1
    with pytest.raises(ScenarioError, match=r"no certificate: learning\.hedging = false"):
        clpt.theory.certificate(scenario.with_values({"learning.hedging": False}), 80.0, 20.0)


def added(t, x, u, p):
    """z' = F_M + v + d, not Eq. (2) hedged."""
    return u.flow_z + u.v_z + getattr(u, "unflown", 0.0)


def too_fast(t, x, u, p):
    """v = 2 v_c, no limit, for Eq. (1)."""
    return 2 * u.v_c


@pytest.mark.parametrize(
    ("module", "name", "wrong", "claim"),
    [
        (learner, "model", added, "V' = -e^T KD e"),
        (vehicle, "limited", too_fast, "up to |v_c| = v_max"),
        (vehicle, "difference", too_fast, "V' = -e^T KD e"),
    ],
)
def test_a_wrong_equation_is_not_proved(module, name, wrong, claim, monkeypatch):
    monkeypatch.setattr(module, name, wrong)
    proof = proof_or_failure("failed", LIMITED_SPEED["with hedging"])
    assert proof.status == "failed"
    assert any(claim in step.claim for step in proof.failed)


def test_a_law_that_reads_the_velocity_reads_the_flown_one():
    """Of the composite laws `blocks/test_composite_laws` asks it."""
    held = {"learning.adapt_gains": False, "learning.gain": None, "vehicle.max_speed": 1.0}
    held |= {"learning.feedback": [1.0, 1.0], "learning.feedforward": [1.0, 1.0]}
    values = {"learning.law": "kalman-flow", "learning.parameters": None, "run.duration": 200}
    run = clpt.simulate(PAPER.with_values({**values, **held, "run.rtol": 1e-10}))
    assert run.attrs["share_at_speed_limit"] > 0.2
    error = run.flow_parameters_estimate[-1].values - np.array(PAPER.flow.parameters)
    assert np.abs(error).max() < 5e-3
