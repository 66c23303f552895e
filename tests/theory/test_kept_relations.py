"""Laws proved where their states keep relations: each is needed, and holds at t = 0 and later."""

import numpy as np
import pytest
from responses import response

import clpt_control as clpt
from clpt_control.blocks.laws import covariance
from clpt_control.blocks.laws.known import Truth
from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.proving import judgement, kept_loop

KEEPING = [law for law in LAWS.values() if law.keeps is not None]
NEEDED = {
    "normalised-gradient": ("q", "b_v"),
    "least-squares": ("alpha", "P"),
    "composite-least-squares": ("alpha", "q", "Q_1"),
    "composite-memory": ("b", "q"),
    "concurrent": ("B", "origin"),
    "drem": ("alpha", "q"),
    "kalman-flow": ("P", "q"),
}
START = [[0.3, -0.2, 0.1], [0.0, 0.4, 0.2]]
FALLING = [law for law in KEEPING if not law.shrinking]
SHRINKING = [law for law in KEEPING if law.shrinking]
DROPPED = [(law, port) for law in KEEPING for port in NEEDED[law.name]]


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    monkeypatch.setattr(judgement, "POINTS", 100)
    monkeypatch.setattr(kept_loop, "SIZES", (1, 2))  # all three in test_judged_laws


@pytest.mark.parametrize(("law", "port"), DROPPED, ids=lambda one: getattr(one, "name", one))
def test_without_a_relation_nothing_is_proved(law, port):
    def fewer(s, p, truth):
        return {key: value for key, value in law.keeps(s, p, truth).items() if key != port}

    assert judgement.judged_law(law._replace(keeps=fewer)).status == "open"


@pytest.mark.parametrize("law", SHRINKING, ids=lambda law: law.name)
def test_a_law_is_bounded_only_where_every_error_shrinks(law):
    def fewer(s, p, truth):
        kept = law.keeps(s, p, truth)
        first = np.ravel(kept["alpha"])
        return {**kept, "alpha": [first[0], *s["alpha"][1:]]}

    assert judgement.judged_law(law).status == "bounded"
    assert judgement.judged_law(law._replace(keeps=fewer)).status == "open"
    assert judgement.judged_law(law._replace(shrinking="q")).status == "open"
    assert judgement.judged_law(law._replace(readout="b")).status == "open"


@pytest.mark.parametrize("law", FALLING, ids=lambda law: law.name)
def test_a_wrong_rate_of_V_is_not_proved(law):
    def twice(s, p, truth):
        first, *others = law.losses(s, p, truth)
        return [(2, *first), *others]

    def twice_gained(s, p, truth):
        return 2 * law.gains(s, p, truth)

    wrong = {"gains": twice_gained} if law.makes_estimate else {"losses": twice}
    found = judgement.judged_law(law._replace(**wrong))
    assert found.status == "open"
    assert "left over" in found.claim


@pytest.mark.parametrize("law", KEEPING, ids=lambda law: law.name)
def test_a_run_starts_and_stays_where_the_relations_hold(law):
    more = {
        "vehicle.position": [0.7, -1.1],
        "learning.parameters": None,
        f"learning.{'theta_estimate' if law.keeps_alpha else 'parameters'}": START,
    }
    scenario = clpt.paper_scenario().with_values({"learning.law": law.name, **more})
    truth = Truth(*map(np.array, (scenario.flow.parameters, *vehicle_gains(scenario))))
    block = law.block(scenario.known_to_law)
    p, shapes = block.parameters, {**block.state_shapes, **block.output_shapes}
    loop, times = clpt.closed_loop(scenario), np.array([0.0, 5.0, 30.0])
    run = response(loop, times, None, clpt.initial_state(scenario), rtol=1e-11, atol=1e-13)
    ports = [label.split("[")[0] for label in loop.output_labels]
    for k in range(len(times)):
        flat = {port: run.outputs[[one == port for one in ports], k] for port in set(ports)}
        s = {port: value.reshape(shapes.get(port, -1)) for port, value in flat.items()}
        for port, value in law.keeps(s, p, truth).items():
            np.testing.assert_allclose(s[port], value, atol=1e-9)
        assert all(np.linalg.eigvalsh(s[port]).min() > -1e-10 for port in law.cones)
        assert all(np.prod(product) > -1e-10 for product in law.losses(s, p, truth))


def vehicle_gains(scenario):
    return scenario.vehicle.feedback, scenario.vehicle.feedforward


WITH_P = [law for law in KEEPING if law.over is not None]


@pytest.mark.parametrize("law", WITH_P, ids=lambda law: law.name)
def test_the_bounds_of_the_covariance_are_steps_of_the_proof(law):
    said = [step.claim for step in judgement.judged_law(law).steps if step.holds]
    for bound in (
        "tr P <= k_0 is kept",
        "P^-1 >= rho P(0)^-1",
        "P^-1 <= P(0)^-1",
        "eta is bounded",
    ):
        assert any(bound in claim for claim in said)


@pytest.mark.parametrize("law", WITH_P, ids=lambda law: law.name)
def test_a_covariance_that_may_pass_its_bound_is_not_proved(law, monkeypatch):
    def unbounded(x, p):
        return p.forgetting

    monkeypatch.setattr(covariance.forgetting, "__code__", unbounded.__code__)
    found = judgement.judged_law(law)
    assert found.status == "open"
    assert any("tr P <= k_0" in step.claim and not step.holds for step in found.steps)
