"""Laws proved where their states keep relations: each is needed, and holds at t = 0 and later."""

import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.proving import judged_laws, kept_relations, shrinking_errors

KEEPING = [law for law in LAWS.values() if law.keeps is not None]
OWN = {
    "composite-least-squares": "alpha",
    "composite-memory": "b",
    "concurrent": "B",
    "drem": "alpha",
    "kalman-flow": "P",
}
DROPPED = [(law, OWN[law.name]) for law in KEEPING if law.name in OWN]
START = [[0.3, -0.2, 0.1], [0.0, 0.4, 0.2]]
DROPPED += [(law, "origin" if law.name == "concurrent" else "q") for law in KEEPING]
FALLING = [law for law in KEEPING if not law.shrinking]
SHRINKING = [law for law in KEEPING if law.shrinking]


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    monkeypatch.setattr(judged_laws, "POINTS", 100)


@pytest.mark.parametrize(("law", "port"), DROPPED, ids=lambda one: getattr(one, "name", one))
def test_without_a_relation_nothing_is_proved(law, port):
    def fewer(s, p, theta):
        return {key: value for key, value in law.keeps(s, p, theta).items() if key != port}

    assert judged_laws.judged(law._replace(keeps=fewer)).status == "open"


@pytest.mark.parametrize("law", SHRINKING, ids=lambda law: law.name)
def test_a_law_is_bounded_only_where_every_error_shrinks(law, monkeypatch):
    for page in (kept_relations, shrinking_errors):
        monkeypatch.setattr(page, "SIZES", (1, 2))

    def fewer(s, p, theta):
        kept = law.keeps(s, p, theta)
        first = np.ravel(kept["alpha"])
        return {**kept, "alpha": [first[0], *s["alpha"][1:]]}

    assert judged_laws.judged(law).status == "bounded"
    assert judged_laws.judged(law._replace(keeps=fewer)).status == "open"
    assert judged_laws.judged(law._replace(shrinking="q")).status == "open"
    assert judged_laws.judged(law._replace(readout="b")).status == "open"


@pytest.mark.parametrize("law", FALLING, ids=lambda law: law.name)
def test_a_wrong_rate_of_V_is_not_proved(law):
    def twice(s, p, theta):
        return 2 * law.gains(s, p, theta)

    found = judged_laws.judged(law._replace(gains=twice))
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
    theta, p = np.array(scenario.flow.parameters), law.block(scenario.known_to_law).parameters
    loop, times = clpt.closed_loop(scenario), np.array([0.0, 5.0, 30.0])
    run = clpt.simulate(loop, times, None, clpt.initial_state(scenario), rtol=1e-11, atol=1e-13)
    ports = [label.split("[")[0] for label in loop.output_labels]
    for k in range(len(times)):
        s = {port: run.outputs[[one == port for one in ports], k] for port in set(ports)}
        for port, value in law.keeps(s, p, theta).items():
            np.testing.assert_allclose(s[port], np.ravel(value), atol=1e-9)
        assert np.linalg.eigvalsh(s[law.cone].reshape(3, 3)).min() > -1e-12
