"""Laws judged with their own V: each relation is needed, and kept by jumps, fixes and runs."""

import math
from collections import namedtuple

import numpy as np
import pytest
import sympy
from altered_rows import judged
from mutated_equations import altered, exchanged
from responses import response
from small_scenarios import FIXES as OF_FIXES
from text_systems import whole_times
from user_laws import LEARNED, V_of, beside, formula

import clpt_control as clpt
from clpt_control import prove

pytestmark = pytest.mark.long  # by `make test-long`

LAWS = clpt.laws()
LAW = LAWS["concurrent"]
POINTS = 100


def test_gains_each_of_its_own_and_gains_held_true():
    """Of gains that are held K and Gamma may be anything; where they are true nothing is left."""
    each, held = (
        prove(
            LAWS["learned-flow"].of(2, gain=0.5, gain_K=k, gain_Gamma=g), points=POINTS
        )
        for k, g in ((0.2, 0.7), (0.0, 0.0))
    )
    assert (each.status, each.for_every_N, each.residual) == ("proved", True, 0)
    assert held.status != "proved"
    names = {str(s): s for s in held.residual.free_symbols}
    true = {
        names[f"{g}_{i}"]: names[f"{g}D_{i}"] for g in ("K", "Gamma") for i in (1, 2)
    }
    assert sympy.expand(held.residual.subs(true)) == 0


def test_a_wrong_law_does_not_stand_in_the_table(clpt):
    """One sign of Eqs. (21)-(23) is turned in the table's own equations."""
    rates = LAWS["learned-flow"].rates.__globals__["driven_by"]
    assert clpt("prove", "learned-flow").status == 0
    with exchanged(rates, altered(rates, 0)):
        outcome = clpt("prove", "learned-flow")
    assert outcome.status == 1
    assert "the proof fails: Law learned-flow at step 'V' " in outcome.err


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
Truth = namedtuple("Truth", "theta KD GammaD")
START = [[0.3, -0.2, 0.1], [0.0, 0.4, 0.2]]
DROPPED = [  # the first of each law by `make test`, all by `make test-slow`
    pytest.param(
        law, port, marks=() if port == NEEDED[law.name][0] else pytest.mark.slow
    )
    for law in KEEPING
    for port in NEEDED[law.name]
]


def name_of(one):
    return getattr(one, "name", one)


def dearest_slow(laws):
    """Leave to `make test-slow` what takes most of the time and is proved in the same way."""
    dear = (
        "composite-least-squares",
        "concurrent",
        "least-squares",
        "composite-memory",
    )
    return [
        pytest.param(law, marks=pytest.mark.slow) if law.name in dear else law
        for law in laws
    ]


@pytest.mark.parametrize(("law", "port"), DROPPED, ids=name_of)
def test_without_a_relation_nothing_is_proved(law, port):
    def fewer(s, p, truth):
        return {
            key: value
            for key, value in law.invariants(s, p, truth).items()
            if key != port
        }

    assert judged(law.name, invariants=fewer).status == "open"


def test_a_law_is_bounded_only_where_every_error_shrinks():

    def fewer(s, p, truth):
        kept = LAWS["drem"].invariants(s, p, truth)
        return {
            **kept,
            "alpha": [np.ravel(kept["alpha"])[0], *np.ravel(s["alpha"])[1:]],
        }

    found = judged("drem")
    assert (found.status, found.conclusion) == ("proved", "bounded in the mean")
    for change in ({"invariants": fewer}, {"readout": "b"}):
        assert judged("drem", **change).status == "open"


@pytest.mark.parametrize("law", dearest_slow(KEEPING), ids=name_of)
def test_a_wrong_rate_of_V_is_not_proved(law):
    def twice(s, p, truth):
        first, *others = law.losses(s, p, truth)
        return [(2, *first), *others]

    growth = {"error_growth": lambda s, p, truth: 2 * law.error_growth(s, p, truth)}
    found = judged(law.name, **(growth if law.makes_estimate else {"losses": twice}))
    assert found.status == "open"
    assert "left over" in found.claim


def test_a_law_that_fails_for_three_functions_alone_is_open():
    """The product of phi_1, phi_2, phi_3 is no loss; there is none of fewer functions."""
    law = LAWS["composite-memory"]

    def one_more(s, p, truth):
        phi = s["phi_x"]
        more = [(math.prod(phi[:3]) ** 2,)] if len(phi) > 2 else []
        return [*law.losses(s, p, truth), *more]

    assert judged(law.name).sentence.endswith("for N = 1, 2, 3")
    found = judged(law.name, losses=one_more)
    assert found.status == "open"
    assert "N = 3" in found.claim


def test_a_law_at_fixes_says_for_which_numbers_of_functions_it_is_proved():
    assert judged("fix-regression").sentence.endswith("for N = 1, 2")


@pytest.mark.parametrize("law", KEEPING, ids=name_of)
def test_a_run_starts_and_stays_where_the_relations_hold(law):
    start = "theta_estimate" if law.alpha_is_constant else "parameters"
    own = {
        "vehicle.position": [0.7, -1.1],
        "learning.parameters": None,
        f"learning.{start}": START,
    }
    scenario = clpt.paper_scenario().with_values({"learning.law": law.name, **own})
    vehicle, block = scenario.vehicle, law.block(scenario.known_to_law)
    theta = np.array(scenario.flow.parameters)
    truth = Truth(theta, np.array(vehicle.feedback), np.array(vehicle.feedforward))
    p, shapes = block.parameters, {**block.state_shapes, **block.output_shapes}
    loop, times = clpt.closed_loop(scenario), np.array([0.0, 5.0, 30.0])
    run = response(
        loop, times, None, clpt.initial_state(scenario), rtol=1e-11, atol=1e-13
    )
    ports = [label.split("[")[0] for label in loop.output_labels]
    for column in run.outputs.T:
        flat = {port: column[[one == port for one in ports]] for port in set(ports)}
        s = {port: value.reshape(shapes.get(port, -1)) for port, value in flat.items()}
        for port, value in law.invariants(s, p, truth).items():
            np.testing.assert_allclose(s[port], value, atol=1e-9)
        assert all(
            np.linalg.eigvalsh(s[port]).min() > -1e-10 for port in law.semidefinite
        )
        s |= {"w'": -s.get("w", np.ones(1))}
        assert all(np.prod(product) > -1e-10 for product in law.losses(s, p, truth))


WITH_P = [law for law in KEEPING if law.weighted_error is not None]


BOUNDS = (
    "tr P <= k_0 is kept",
    "P^-1 >= rho P(0)^-1",
    "P^-1 <= P(0)^-1",
    "eta is bounded",
)


@pytest.mark.parametrize("law", dearest_slow(WITH_P), ids=name_of)
def test_the_bounds_of_the_covariance_are_steps_of_the_proof(law):
    said = " ".join(step.claim for step in judged(law.name).steps if step.holds)
    assert all(bound in said for bound in BOUNDS)


@pytest.mark.parametrize("law", dearest_slow(WITH_P), ids=name_of)
def test_a_covariance_that_may_pass_its_bound_is_not_proved(law):
    def unbounded(x, p):
        return p.forgetting

    forgetting = law.rates.__globals__["forgetting"]
    with exchanged(forgetting, unbounded.__code__):
        found = judged(law.name)
    assert found.status == "open"
    assert any("tr P <= k_0" in step.claim and not step.holds for step in found.steps)


BREAKING = [
    # where the last one began
    (lambda x: {"origin": x.origin}, "what the law's states keep is kept"),
    (lambda x: {"S": -x.S, "B": -x.B}, "Q_1, Q_2, S >= 0 is not left where they jump"),
]


@pytest.mark.parametrize(("change", "said"), BREAKING)
def test_a_jump_that_breaks_the_proof_leaves_the_law_open(change, said):
    def jump(t, x, u, p):
        """As Eqs. (21)-(23) have it, but for what is changed."""
        return LAW.jump(t, x, u, p) | change(x)

    found = judged("concurrent", jump=jump)
    assert found.status == "open"
    assert said in found.claim


def test_a_jump_at_which_V_rises_leaves_the_law_open():
    """Where alpha jumps to 0 its error is theta, which may be farther from the truth."""

    def jump(t, x, u, p):
        """As Eqs. (21)-(23) have it, alpha forgotten."""
        return LAW.jump(t, x, u, p) | {"alpha": 0.0}

    found = judged("concurrent", jump=jump)
    assert (found.status, found.conclusion) == ("open", "")
    assert found.claim.startswith("V does not rise where states of adaptation jump (V")
    assert [step.claim for step in found.failed] == [
        "V does not rise where states of adaptation jump"
    ]


def jumping(text, gain=0.5):
    """The paper's law with a memory m, whose states jump at whole times as is written."""
    states = {**LEARNED, "m": 1}
    written = dict(part.split(" = ") for part in text.split("; "))
    after = {port: formula(one, states) for port, one in written.items()}

    def jump(t, x, u, p):
        """What is learned, changed, section III."""
        same = {port: getattr(x, port) for port in states}
        return same | {port: one(t, x, u, p) for port, one in after.items()}

    ticking = {"breakpoints": whole_times, "jump": jump}
    return beside("m' = 0*m", {"m": 1}, {"gain": gain, "interval": -1.0}, **ticking)()


@pytest.mark.parametrize(
    ("change", "status", "detail"),
    [("m = e @ e", "proved", ""), ("alpha = 0.5*alpha", "open", "V changes by")],
)
def test_what_is_known_of_jumps_is_said(change, status, detail):
    verdict = prove(jumping(change), points=200)
    across = verdict.steps[-1]
    assert verdict.status == status
    assert verdict.conclusion == "goes to zero" * (status == "proved")
    assert ("m is not held by V" in verdict.sentence) == (status == "proved")
    assert across.holds == (not detail)
    assert across.claim == "V does not rise where states of own jump"
    assert across.detail.startswith(detail)
    assert not verdict.for_every_N
    # an open verdict has no proof
    listed = [step for step in verdict.steps if step.holds and status == "proved"]
    assert verdict.latex().count(r"\item") == len(listed)


@pytest.mark.parametrize(
    ("change", "holds"), [("m = 0.5*m", True), ("m = e @ e", False)]
)
def test_V_may_fall_where_states_jump(change, holds):
    V = V_of("e @ e/2 + off/(2*gain) + sum(m**2)/2", {**LEARNED, "m": 1})
    assert prove(jumping(change), V, points=200).steps[-1].holds == holds


TURNED = [
    "alpha = -alpha",
    "alpha = -alpha; K = -K; Gamma = -Gamma",
    "alpha = where(abs(K[0]) > 1.0, alpha, -3.0*alpha)",
    "K = where(K > 3, -K, K)",
    "alpha = alpha[::-1]",
    "K = K + 0.1",
    "Gamma = Gamma + e",
]


@pytest.mark.parametrize("change", TURNED)
def test_a_jump_at_which_V_rises_refutes(change):
    verdict = prove(jumping(change), points=200)
    assert verdict.status == "refuted"
    before, after = (
        verdict.diagram.output(*one)[-1] for one in (verdict.point, verdict.after)
    )
    assert verdict.point.t == verdict.after.t == math.floor(verdict.point.t) > 0
    assert after > before
    assert not verdict.for_every_N


def test_a_wrong_law_is_refuted_all_the_same():
    assert prove(jumping("m = e @ e", gain=-0.5), points=200).status == "refuted"


FIXES = LAWS["fix-regression"]
AT = clpt.paper_scenario().with_values({"learning.law": FIXES.name, **OF_FIXES})


def test_every_step_is_shown():
    verdict = prove(clpt.closed_loop(AT), points=50)
    assert (verdict.status, verdict.conclusion) == ("proved", "bounded by its fixes")
    hows = ["exact", "exact", "cited", "sampled"]
    assert [step.how for step in verdict.steps] == hows
    assert all(step.holds for step in verdict.steps)
    names = {condition.name for condition in verdict.conditions}
    assert names == {"limits", "N"}


@pytest.mark.parametrize("which", [0, 1])
def test_a_law_at_fixes_with_a_sign_turned_is_not_proved(which):
    for function in (FIXES.rates, FIXES.jump):
        code = altered(function, which)
        if code is not None:
            with exchanged(function, code):
                assert judged(FIXES.name).status == "open"


def test_V_never_rises_in_a_uniform_current_whatever_is_missing_or_late():
    uniform = {"kernel": "gaussian", "centers": [[0, 0], [1, 0]], "widths": [1e9] * 2}
    values = {
        **{f"basis.{key}": value for key, value in uniform.items()},
        "basis.periods": [float("inf"), 12.0],
        "flow.parameters": [[0.3, 0.1], [-0.2, 0.2]],
        **dict.fromkeys(["basis.phases", "model.parameters", "learning.parameters"]),
        **{
            "localization.dropouts": 0.3,
            "localization.latency": 2.0,
            "run.duration": 200,
        },
    }
    V = clpt.simulate(AT.with_values(values)).lyapunov.values
    assert np.all(np.diff(V) <= 1e-12 * V[0])
    assert V[-1] < 1e-3 * V[0]


def test_what_is_not_known_of_runs_with_fixes_or_noise_is_refused():
    scenario = AT.with_values({"run.duration": 40.0})
    with pytest.raises(clpt.ClptError, match="Give the scenario in place of the run"):
        clpt.gramian(clpt.simulate(scenario), 20.0, 0.0)
    assert clpt.gramian(scenario, 20.0, 0.0).eigenvalues["x1"][0] > 0
    with pytest.raises(clpt.ClptError, match="only law that learns at fixes"):
        clpt.tune_law(scenario, members=3)
    noisy = {"localization": {"noise": 0.1, "noise_period": 1.0}, "run.duration": 40.0}
    with pytest.raises(clpt.ClptError, match=r"no certificate: localization\.noise"):
        clpt.gramian(clpt.paper_scenario().with_values(noisy), 20.0, 0.0).certificate()


@pytest.mark.parametrize("estimate", ["", "alpha"])
def test_a_gain_that_learns_backwards_is_not_proved_by_what_drives_it(estimate):
    """K' of the other sign adds 2 (K - KD)^T z e to V', which no estimate bounds."""
    rates = LAWS["learned-flow"].rates

    def backwards(t, x, u, p):
        """Learn as Eqs. (21) and (23), and K backwards."""
        learned = rates(t, x, u, p)
        return {**learned, "K": -learned["K"]}

    verdict = judged(
        "learned-flow",
        rates=backwards,
        invariants=lambda s, p, truth: {},
        driving_estimate=estimate,
        V_rate="-e^T KD e + 2 (K - KD)^T z e",
    )
    assert verdict.status != "proved"
