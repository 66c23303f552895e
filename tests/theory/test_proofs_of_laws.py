"""Laws judged with their own V: each relation is needed, and kept by jumps and by runs."""

import numpy as np
import pytest
import sympy
from responses import response

import clpt_control as clpt
from clpt_control.blocks.laws import regressions
from clpt_control.blocks.laws.remembering import CONCURRENT as LAW
from clpt_control.blocks.laws.remembering import next_window
from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.promises import truth_of
from clpt_control.theory.proving import all_proofs, invariant_loop
from clpt_control.theory.proving.all_proofs import proof_of_law
from clpt_control.theory.proving.own_law import prove

pytestmark = pytest.mark.usefixtures("few_calls")
POINTS = 100


def gains(parameters, feedback, feedforward):
    return LAWS["learned-flow"].of(2, gain=parameters, gain_K=feedback, gain_Gamma=feedforward)


def test_a_gain_each_is_proved_for_every_N_and_every_gain():
    verdict = prove(gains(0.5, 0.2, 0.7), points=POINTS)
    assert (verdict.status, verdict.for_every_N, verdict.residual) == ("proved", True, 0)


def test_gains_held_true_fall_alike_and_others_push():
    verdict = prove(gains(0.5, 0.0, 0.0), points=POINTS)
    assert verdict.status != "proved"  # K and Gamma may be anything
    names = {str(s): s for s in verdict.residual.free_symbols}
    true = {names[f"{g}_{i}"]: names[f"{g}D_{i}"] for g in ("K", "Gamma") for i in (1, 2)}
    assert sympy.expand(verdict.residual.subs(true)) == 0


def backwards(t, x, u, p):
    return {port: -rate for port, rate in LAWS["learned-flow"].rates(t, x, u, p).items()}


def unread(t, x, u, p):
    raise ValueError("no such equation")


@pytest.mark.parametrize(("rates", "said"), [(backwards, "V' "), (unread, "no such equation")])
def test_a_wrong_law_would_not_stand_in_the_table(rates, said):
    found = proof_of_law(LAWS["learned-flow"]._replace(rates=rates))
    assert (found.status, found.holds) == ("open", False)
    assert said in found.claim


KEEPING = [law for law in LAWS.values() if law.invariants is not None]
NEEDED = {
    "normalised-gradient": ("b_v", "q"),
    "least-squares": ("alpha", "P"),
    "composite-least-squares": ("Q_1", "q", "alpha"),
    "composite-memory": ("b", "q"),
    "concurrent": ("B", "origin"),
    "drem": ("alpha", "q"),
    "kalman-flow": ("P", "q"),
}
START = [[0.3, -0.2, 0.1], [0.0, 0.4, 0.2]]
DROPPED = [  # the first of each law by `make test`, all by `make test-slow`
    pytest.param(law, port, marks=() if port == NEEDED[law.name][0] else pytest.mark.slow)
    for law in KEEPING
    for port in NEEDED[law.name]
]


def name_of(one):
    return getattr(one, "name", one)


def dearest_slow(laws):
    """Leave to `make test-slow` what takes most of the time and is proved in the same way."""
    dear = ("composite-least-squares", "concurrent")
    return [pytest.param(law, marks=pytest.mark.slow) if law.name in dear else law for law in laws]


@pytest.fixture(autouse=True)
def few_points(monkeypatch):
    monkeypatch.setattr(all_proofs, "POINTS", 100)
    monkeypatch.setattr(invariant_loop, "SIZES", (1, 2))


@pytest.mark.parametrize(("law", "port"), DROPPED, ids=name_of)
def test_without_a_relation_nothing_is_proved(law, port):
    def fewer(s, p, truth):
        return {key: value for key, value in law.invariants(s, p, truth).items() if key != port}

    assert all_proofs.proof_of_law(law._replace(invariants=fewer)).status == "open"


def test_a_law_is_bounded_only_where_every_error_shrinks():
    law = LAWS["drem"]

    def fewer(s, p, truth):
        kept = law.invariants(s, p, truth)
        return {**kept, "alpha": [np.ravel(kept["alpha"])[0], *np.ravel(s["alpha"])[1:]]}

    assert all_proofs.proof_of_law(law).status == "bounded"
    assert all_proofs.proof_of_law(law._replace(invariants=fewer)).status == "open"
    assert all_proofs.proof_of_law(law._replace(readout="b")).status == "open"


@pytest.mark.parametrize("law", dearest_slow(KEEPING), ids=name_of)
def test_a_wrong_rate_of_V_is_not_proved(law):
    def twice(s, p, truth):
        first, *others = law.losses(s, p, truth)
        return [(2, *first), *others]

    def twice_gained(s, p, truth):
        return 2 * law.error_growth(s, p, truth)

    wrong = {"error_growth": twice_gained} if law.makes_estimate else {"losses": twice}
    found = all_proofs.proof_of_law(law._replace(**wrong))
    assert found.status == "open"
    assert "left over" in found.claim


@pytest.mark.parametrize("law", KEEPING, ids=name_of)
def test_a_run_starts_and_stays_where_the_relations_hold(law):
    more = {
        "vehicle.position": [0.7, -1.1],
        "learning.parameters": None,
        f"learning.{'theta_estimate' if law.alpha_is_constant else 'parameters'}": START,
    }
    scenario = clpt.paper_scenario().with_values({"learning.law": law.name, **more})
    truth, block = truth_of(scenario), law.block(scenario.known_to_law)
    p, shapes = block.parameters, {**block.state_shapes, **block.output_shapes}
    loop, times = clpt.closed_loop(scenario), np.array([0.0, 5.0, 30.0])
    run = response(loop, times, None, clpt.initial_state(scenario), rtol=1e-11, atol=1e-13)
    ports = [label.split("[")[0] for label in loop.output_labels]
    for k in range(len(times)):
        flat = {port: run.outputs[[one == port for one in ports], k] for port in set(ports)}
        s = {port: value.reshape(shapes.get(port, -1)) for port, value in flat.items()}
        for port, value in law.invariants(s, p, truth).items():
            np.testing.assert_allclose(s[port], value, atol=1e-9)
        assert all(np.linalg.eigvalsh(s[port]).min() > -1e-10 for port in law.semidefinite)
        s |= {"w'": -s.get("w", np.ones(1))}
        assert all(np.prod(product) > -1e-10 for product in law.losses(s, p, truth))


WITH_P = [law for law in KEEPING if law.weighted_error is not None]


@pytest.mark.parametrize("law", dearest_slow(WITH_P), ids=name_of)
def test_the_bounds_of_the_covariance_are_steps_of_the_proof(law):
    said = [step.claim for step in all_proofs.proof_of_law(law).steps if step.holds]
    for bound in (
        "tr P <= k_0 is kept",
        "P^-1 >= rho P(0)^-1",
        "P^-1 <= P(0)^-1",
        "eta is bounded",
    ):
        assert any(bound in claim for claim in said)


@pytest.mark.parametrize("law", dearest_slow(WITH_P), ids=name_of)
def test_a_covariance_that_may_pass_its_bound_is_not_proved(law, monkeypatch):
    def unbounded(x, p):
        return p.forgetting

    monkeypatch.setattr(regressions.forgetting, "__code__", unbounded.__code__)
    found = all_proofs.proof_of_law(law)
    assert found.status == "open"
    assert any("tr P <= k_0" in step.claim and not step.holds for step in found.steps)


def forgets_where_it_was(t, x, u, p):
    """As Eqs. (21)-(23) have it, but the window begins where the last one began."""
    return next_window(t, x, u, p) | {"origin": x.origin}


def takes_away(t, x, u, p):
    """S and B of Eqs. (21)-(23) with the other sign: B = theta S still holds."""
    return next_window(t, x, u, p) | {"S": -x.S, "B": -x.B}


def starts_again(t, x, u, p):
    """alpha of Eq. (21) set back to 0, which may be farther from the truth."""
    return next_window(t, x, u, p) | {"alpha": 0.0}


@pytest.mark.parametrize(
    ("jump", "said"),
    [
        (forgets_where_it_was, "and is kept where they jump"),
        (takes_away, "Q_1, Q_2, S >= 0 is not left where they jump"),
        (starts_again, "V does not rise where they jump"),
    ],
)
def test_a_jump_that_breaks_the_proof_leaves_the_law_open(jump, said):
    found = all_proofs.proof_of_law(LAW._replace(jump=jump))
    assert found.status == "open"
    assert found.claim.startswith(said)
