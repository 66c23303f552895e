"""Right laws of textbooks are proved or bounded, and not their wrong twins."""

from contextlib import suppress

import numpy as np
import own_laws
import pytest
import sympy
from own_laws import GAIN, law
from textbook_laws import LAWS, of_e
from wrong_laws import WRONG

from clpt_control.blocks.lyapunov import lyapunov_candidate, weighted
from clpt_control.errors import ClptError
from clpt_control.theory.proving import invariants
from clpt_control.theory.proving.own_law import prove
from clpt_control.theory.proving.proof import exact
from clpt_control.theory.proving.signs import MOST_TERMS, terms_of

pytestmark = pytest.mark.usefixtures("few_calls")
POINTS = 100


LONG = (
    *("axes mixed", "a matrix of gains", "a periodic leak", "eps and its cube"),
    "eps exp(-eps^2)",
)


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow) if n in LONG else n for n in LAWS]
)
def test_a_law_of_a_textbook_is_shown(name):
    make, more, status = LAWS[name]
    assert prove(make(), points=POINTS, **more).status == status


def test_a_V_of_other_numbers_is_not_the_truths():
    """Of V made of KD once, for every truth, nothing is shown; nor is it called wrong."""

    def made(truth):
        own = truth._replace(KD=np.array([1.0, 0.7]))
        return lyapunov_candidate("learned-flow", weighted([0.5] * 3, *own))

    found = prove(own_laws.paper(), made, points=POINTS)
    assert found.status == "open"
    assert "not shown" in found._repr_html_()
    assert "does not hold" not in found._repr_html_()


def test_a_state_beside_those_that_make_alpha_is_asked_for():
    """Of s[3, N] two rows are alpha; the third leaves in finite time."""

    def update(t, x, u, p):
        """Eqs. (21)-(23) in two rows of a state, section III."""
        rates = own_laws.filled(u, p.gain, u.e)
        s = np.stack([*rates.pop("alpha"), x.s[2] ** 2 + 1])
        return rates | {"s": s}

    def output(t, x, u, p):
        return {"alpha": x.s[:2], "K": x.K, "Gamma": x.Gamma}

    states = {"s": (3, "N"), "K": 2, "Gamma": 2}
    own = law(update, GAIN, states=states, output=output, outputs=own_laws.LEARNED)
    assert prove(own, points=POINTS).status == "proved as long as own:s_3[1], own:s_3[2] exist"


def test_no_law_is_told_the_truth_by_what_it_keeps():
    """A law that learns nothing keeps alpha = -theta only if it begins so, which none does."""

    def still(t, x, u, p):
        """Nothing of Eqs. (21)-(23), section III."""
        return {"alpha": 0.0, "K": 0.0, "Gamma": 0.0}

    def invariants(s, p, truth):
        return {"alpha": -truth.theta, "K": truth.KD, "Gamma": truth.GammaD}

    V = LAWS["tanh of e"][1]["V"]
    found = prove(law(still, GAIN), V, points=POINTS, invariants=invariants)
    assert found.status == "open"
    squares = of_e(lambda e, p: e**2 / 2)
    found = prove(law(still, GAIN), squares, points=POINTS, invariants=invariants)
    assert found.status == "open"
    assert "alpha_1[1] at the start" in found.steps[0].detail


def test_a_V_with_what_states_keep_may_be_made_of_parameters_too():
    make, more, status = LAWS["least squares"]
    own = more | {"V": lambda truth, p: more["V"](truth)}
    assert prove(make(), points=POINTS, **own).status == status


def test_the_seed_is_that_of_the_points_where_states_keep_relations(monkeypatch):
    make, more, _ = LAWS["least squares"]
    seeds, shown = [], exact("the running blocks give the same V'", True)
    monkeypatch.setattr(
        invariants, "running_step", lambda read, points, seed: seeds.append(seed) or shown
    )
    prove(make(), points=POINTS, seed=7, **more)
    assert seeds == [7]


@pytest.mark.slow
def test_a_V_that_saturates_is_judged_soon(monkeypatch):
    saturated = own_laws.V_of(lambda t, u, p: np.tanh(u.e @ u.e / 2 + own_laws.off(u, p)))
    terms, expand = [], sympy.expand
    monkeypatch.setattr(
        sympy, "expand", lambda e, **how: terms.append(terms_of(e)) or expand(e, **how)
    )
    assert prove(own_laws.paper(), saturated, points=POINTS).status == "open"
    assert 0 < max(terms) < MOST_TERMS  # what is multiplied out is short


@pytest.mark.parametrize("function", [np.exp, np.cosh])
def test_exp_of_a_large_bound_has_no_value(function):
    """e^(clip(e)) is a number for bounds of 5, not of 1000."""

    def unity(bound):
        def update(t, x, u, p):
            """Eqs. (21)-(23) times one, section III."""
            s = function(np.clip(u.e[0], -bound, bound))
            return {port: (s / s) * own for port, own in own_laws.filled(u, p.gain, u.e).items()}

        return update

    for bound, large in ((5.0, False), (1000.0, True)):
        found = prove(law(unity(bound), GAIN), points=POINTS)
        said = next(step for step in found.steps if "value everywhere" in step.claim)
        assert ("too large" in said.detail) == large


OFTEN = [*WRONG][::10]  # by `make test`; all by `make test-slow`


@pytest.mark.usefixtures("few_draws")
@pytest.mark.parametrize(
    "name", [n if n in OFTEN else pytest.param(n, marks=pytest.mark.slow) for n in WRONG]
)
def test_a_wrong_law_is_not_proved(name):
    make, more = WRONG[name]
    with suppress(ClptError):  # refused
        assert prove(make(), points=POINTS, **more).status not in ("proved", "bounded")


def test_a_V_that_fades_with_time_holds_nothing():
    make, more = WRONG["turned, V fades"]
    first, *_ = prove(make(), points=POINTS, **more).steps
    assert first.claim.startswith("V is positive definite")
    assert not first.holds
