"""No wrong law is proved, no right law refuted: each row of the tables is a case."""

import signal
from contextlib import suppress
from functools import partial

import control
import numpy as np
import pytest
import sympy
import user_laws
from law_blocks import filled
from text_systems import TICKS, whole_times
from user_laws import (
    GAIN,
    LEARNED,
    OF_TRUE_FLOW,
    USUAL,
    WITH_R,
    Shown,
    V_of,
    beside,
    changed,
    driven,
    of_e,
)
from wrong_laws import WRONG

import clpt_control as clpt
from clpt_control import ClptError, DiagramError, prove

pytestmark = pytest.mark.long  # by `make test-long`

POINTS = 100  # of running blocks in each case; the default is 10,000
LONG = ("eps and its cube", "eps exp(-eps^2)")  # of seconds: by `make test-slow`
OFTEN = [*WRONG][::10]  # of wrong laws by `make test`; all by `make test-slow`


def slow(names, which):
    return [pytest.param(n, marks=pytest.mark.slow) if n in which else n for n in names]


EVERY = {("N", "every N")}
SHOWN = {
    n: Shown(make, {}, "goes to zero", USUAL) for n, make in user_laws.RIGHT.items()
}
SHOWN |= {
    n: Shown(make, {}, "goes to zero", OF_TRUE_FLOW if n == "composite" else USUAL)
    for n, make in user_laws.FOR_TWO.items()
}
SHOWN |= {
    name: Shown(make, {}, conclusion, USUAL)
    for name, (make, conclusion) in user_laws.BOUNDED.items()
}
SHOWN |= user_laws.TEXTBOOK
NOT_SHOWN = {
    "least squares": "R is not known to grow as phi phi^T alone",
    **dict.fromkeys(
        ("a gain each", "one list of gains for functions and for axes"),
        "a gain for each function is not taken for every N",
    ),
}
of = partial(prove, points=POINTS)


def fields_of(verdict):
    """The conditions of a verdict and of what they are, without N."""
    return {(c.name, c.of) for c in verdict.conditions if c.name != "N"}


def sizes_of(verdict):
    """Numbers of functions for which a verdict holds."""
    return [c.of for c in verdict.conditions if c.name == "N"]


def marked(names):
    """Cases with their marks: what is slow, and what is not shown yet."""
    for name in names:
        marks = [pytest.mark.slow] if name in LONG else []
        if name in NOT_SHOWN:
            marks.append(pytest.mark.xfail(strict=True, reason=NOT_SHOWN[name]))
        yield pytest.param(name, marks=marks)


@pytest.mark.parametrize("name", [*marked(SHOWN)])
def test_a_right_law_is_shown(name):
    case = SHOWN[name]
    verdict = of(case.make(), **case.more)
    assert (verdict.status, verdict.point) == ("proved", None)
    assert verdict.conclusion == case.conclusion
    assert fields_of(verdict) == {*case.conditions.items()}
    N = case.make().sizes["N"]
    assert sizes_of(verdict) == ["every N" if verdict.for_every_N else f"N = {N}"]
    if name in (*user_laws.RIGHT, *user_laws.FOR_TWO):
        assert verdict.for_every_N == (name in user_laws.RIGHT)


def number(level, **values):
    """A level at the numbers of the truth and of Delta, others 0."""
    return float(level.subs({s: values.get(s.name, 0.0) for s in level.free_symbols}))


def test_the_level_of_a_leak_is_that_of_the_textbook():
    """V' <= -m V + |Delta|^2/(2 KD) + c/2 |truth|^2, m the least of KD and gain c = 0.05."""
    level = of(user_laws.constant()).level
    truth = {
        "KD_1": 1.0,
        "KD_2": 0.7,
        "theta_1[2]": 2.0,
        "GammaD_2": 3.0,
        "Delta_2": 0.2,
    }
    push = 0.2**2 / (2 * 0.7) + 0.05 * (1.0 + 0.7**2 + 2.0**2 + 3.0**2)
    assert number(level, **truth) == pytest.approx(push / 0.05)


def test_the_mean_of_a_leak_of_alpha_is_that_of_the_textbook():
    """In the mean e^T KD e <= |Delta|^2/KD + c |theta|^2, c = 0.1: V itself may grow."""
    verdict = of(user_laws.BOUNDED["leak of alpha"][0]())
    assert verdict.level is None
    assert verdict.bound == "e^T KD e is at most 2 c"
    constant = verdict.claim.partition(", c = ")[2]
    values = {"Delta_2": 0.3, "theta_1[2]": 2.0, "KD_1": 1.0, "KD_2": 0.7}
    numbers = {
        name.replace("[", "_").replace("]", ""): sympy.Float(value)
        for name, value in values.items()
    }
    found = sympy.sympify(constant.replace("[", "_").replace("]", ""))
    at = {s: numbers.get(s.name, 0) for s in found.free_symbols}
    assert 2 * found.subs(at) == pytest.approx(0.3**2 / 0.7 + 0.1 * 2.0**2)


@pytest.mark.parametrize("name", user_laws.REFUTED)
def test_a_wrong_law_is_refuted_at_a_point_that_anyone_can_call(name):
    verdict = of(user_laws.REFUTED[name]())
    assert verdict.status == "refuted"
    t, x, u = verdict.point
    rates = verdict.diagram.dynamics(t, x, u)
    h = 1e-4 * np.abs(x).max() / np.abs(rates).max()
    ahead, behind = (verdict.diagram.output(t, x + s * rates, u)[-1] for s in (h, -h))
    assert (ahead - behind) / (2 * h) == pytest.approx(verdict.value, rel=1e-5)
    assert verdict.value > 0


@pytest.mark.parametrize("name", user_laws.NOT_PROVED)
def test_what_is_not_known_to_be_right_is_not_proved(name):
    verdict = of(user_laws.NOT_PROVED[name]())
    assert verdict.status in ("open", "refuted")
    assert not all(step.holds for step in verdict.steps)


@pytest.mark.parametrize("name", slow(WRONG, set(WRONG) - set(OFTEN)))
def test_a_wrong_law_is_not_proved(name):
    make, more = WRONG[name]
    with suppress(ClptError):  # refused
        assert of(make(), **more).status != "proved"


@pytest.mark.parametrize("name", user_laws.TOO_MUCH)
def test_what_cannot_be_judged_is_refused_in_a_sentence(name):
    make, said = user_laws.TOO_MUCH[name]
    with pytest.raises(ClptError, match=said):
        of(make())


# --- V --------------------------------------------------------------------------------------------


def test_a_V_that_fades_proves_nothing():
    verdict = of(user_laws.turned(), V_of("exp(-t)*(e @ e + off)"))
    assert verdict.status == "open"
    first = next(step for step in verdict.steps if not step.holds)
    assert first.claim.startswith("V is positive definite")
    assert repr(verdict).startswith("<Verdict open: V is positive definite")


@pytest.mark.parametrize("make", [user_laws.turned, user_laws.paper])
def test_an_indefinite_V_is_refuted_at_a_point(make):
    verdict = of(make(), V_of("e @ e/2 - off/(2*gain)"))
    assert verdict.status == "refuted"
    assert "below its value at the truth" in verdict.claim
    t, x, u = verdict.point
    assert verdict.diagram.output(t, x, u)[-1] < 0  # V is zero at the truth


def tuner(t, x, u, p):
    """A higher-order tuner: alpha follows a state nu of its own."""
    follow = -p.beta * (x.alpha - x.nu) * (1 + p.mu * u.phi_x @ u.phi_x)
    return filled(u, p.gain, u.e) | {
        "nu": -p.gain * np.outer(u.e, u.phi_x),
        "alpha": follow,
    }


def test_a_quadratic_V_with_a_state_of_the_law_is_shown():
    states = {**LEARNED, "nu": (2, "N")}
    gains = {"gain": 0.8, "beta": 1.0, "mu": 2.0}
    level = "e @ e/2 + (sum((nu + theta)**2) + sum((alpha - nu)**2) + "
    level += "sum((K - KD)**2) + sum((Gamma - GammaD)**2))/(2*0.8)"
    law = user_laws.law(tuner, gains, n=1, states=states)
    steps = of(law, V_of(level, states)).steps
    (definite,) = [
        step for step in steps if step.claim.startswith("V is positive definite")
    ]
    assert definite.holds


def of_gain(gain):
    return V_of(f"e @ e/2 + off/(2*{gain})")


def of_KD(truth):
    """V made of KD once, for every truth: of it nothing is shown; nor is it called wrong."""
    return of_gain(0.5)(truth._replace(KD=np.array([1.0, 0.7])))


OTHER_V = [
    # of Cauchy, and a pseudo-Huber; the third ends at a half
    (driven("e/(1 + e**2)"), of_e("log(1 + e**2)/2"), "proved"),
    (driven("e/sqrt(1 + e**2)"), of_e("sqrt(1 + e**2) - 1"), "proved"),
    (driven("e/(1 + e**2)**2"), of_e("0.5 - 0.5/(1 + e**2)"), "open"),
    # what does not fit refutes no law
    (user_laws.paper, of_gain(0.5), "proved"),
    (user_laws.paper, of_gain(0.7), "open"),
    (user_laws.paper, of_KD, "open"),
    *((make, None, "open") for make in user_laws.NOT_REFUTED.values()),
]


@pytest.mark.parametrize(("make", "V", "status"), OTHER_V)
def test_a_V_shows_what_it_can(make, V, status):
    found = of(make(), *[V] * (V is not None))
    assert found.status == status
    assert status == "proved" or "not shown" in found._repr_html_()
    assert "does not hold" not in found._repr_html_()


@pytest.mark.parametrize(
    ("own", "V"), [(3, None), (None, 3), (None, None), (None, control.ss(-1, 1, 1, 0))]
)
def test_what_is_no_block_or_makes_no_V_is_refused(own, V):
    mine = user_laws.paper()
    with pytest.raises(ClptError, match=r"must be a (Block|function)|V\[1\]$"):
        prove(own or mine, V or mine)


def test_a_V_that_falls_where_e_grows_proves_nothing():
    """Of V = 0.05 e^2 + 1 - cos(e) the fall -KD e dV/de is 2.1 at e = 4.49, all else true."""
    found = of(driven("0.1*e + sin(e)")(), of_e("0.05*e**2 + 1 - cos(e)"))
    assert found.status == "open"
    (step,) = [step for step in found.steps if step.claim.startswith("V' =")]
    assert (step.holds, step.detail) == (False, "V is not known to rise with |e|")


@pytest.mark.parametrize("share", ["2.0", "2.0*hypot(e[0], e[1])"])
def test_the_level_of_a_V_that_weighs_e_is_reached(share):
    """With phi = zc = z = 0 and Delta_1 = 100 e_1 comes to 100/KD_1, and 5 e^2 to 50000."""
    found = of(user_laws.leak(share)(), V_of("5*(e @ e + off/gain)"))
    assert found.status == "proved"
    assert number(found.level, KD_1=1.0, KD_2=1.0, Delta_1=100.0) >= 50_000


# --- what is said ---------------------------------------------------------------------------------


@pytest.fixture
def interrupts():
    """Set when they come and how often: Python drops one that comes while it closes a file."""

    def interrupt(_signal, _frame):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    yield partial(signal.setitimer, signal.ITIMER_REAL)
    signal.setitimer(signal.ITIMER_REAL, 0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize(
    "work",
    [
        lambda: prove(user_laws.paper(), points=200_000),
        lambda: clpt.theory.audit("3.2"),
    ],
)
def test_a_proof_can_be_interrupted(work, interrupts):
    """An interrupt is no step that fails."""
    try:
        interrupts(0.02, 0.5)
        work()
    except KeyboardInterrupt:
        interrupts(0)
    else:
        pytest.fail("the proof went on")


UNITY = "{0}(clip(e[0], -{1}, {1}))/{0}(clip(e[0], -{1}, {1}))*e"


NO_VALUE = [
    (user_laws.divided_by_itself, "own.update divides by z_1, which may be zero"),
    *((driven(UNITY.format(name, 5.0)), "") for name in ("exp", "cosh")),
    *((driven(UNITY.format(name, 1000.0)), "too large") for name in ("exp", "cosh")),
]


@pytest.mark.parametrize(("make", "said"), NO_VALUE)
def test_what_has_no_value_says_so(make, said):
    """e^(clip(e)) is a number for bounds of 5, not of 1000."""
    step = next(step for step in of(make()).steps if "value everywhere" in step.claim)
    assert step.holds == (said == "")
    assert said in step.detail


def test_the_residual_of_a_held_gain_is_the_term_that_misses():
    """And the law is left as it is."""
    own = changed("Gamma' = 0*zc")()
    at = 0.0, np.ones(own.nstates), np.ones(own.ninputs)
    before, verdict = own.dynamics(*at), of(own)
    assert verdict.status == "refuted"
    names = {str(symbol) for symbol in verdict.residual.free_symbols}
    assert {"Gamma_1", "GammaD_1", "x_1", "z_1"} <= names
    assert not {"theta_1[1]", "K_1"} & names
    np.testing.assert_array_equal(own.dynamics(*at), before)


@pytest.mark.parametrize(("b", "status"), [(0.5, "proved"), (2.0, "refuted")])
def test_what_holds_for_the_parameters_as_they_are_says_so(b, status):
    """-c (eps_1^2 + eps_2^2) - 2 b eps_1 eps_2 is never positive for b < c alone."""
    crossed = "alpha' = dalpha - outer(stack([c*eps[0] + b*eps[1], b*eps[0] + c*eps[1]]), phi_x)"
    found = of(changed(crossed, {"gain": 0.5, "c": 1.0, "b": b}, user_laws.FLOW, n=1)())
    (step,) = [step for step in found.steps if step.claim.startswith("V' <=")]
    assert found.status == status
    assert "and the parameters as they are" in step.claim


HIDDEN = [
    (user_laws.composite, "the true flow"),
    (beside("s' = V - s", {"s": 1}, more={"V": 1}), "V, which is made of the truth"),
    (user_laws.paper, ""),
]


@pytest.mark.parametrize(("make", "hidden"), HIDDEN)
def test_a_proof_says_what_no_vehicle_measures(make, hidden):
    verdict = of(make())
    read = [c.of for c in verdict.conditions if c.name == "reads the truth"]
    assert read == [hidden] * bool(hidden)
    assert ("which no vehicle measures" in verdict.sentence) == bool(hidden)
    assert f"the law reads {hidden}" in verdict.sentence or not hidden


# --- states of a law's own ------------------------------------------------------------------------

OTHER_STATES = {  # s' of a state that V does not hold, its size; whether it exists for all times
    "1 + s**2": ("N", False),  # it ends at pi/2
    "s**3 + e[0]": (1, False),
    "s*sum(s*phi_x)": ("N", False),
    "exp(clip(s, -9, 9))*s**2": (1, False),
    "stack([s[1]**2, s[0]])": (2, False),
    "s*s*tanh(K[0])": (1, False),
    "e @ e": (1, "may grow"),
    "-s + e[0]": ("N", True),
    "0 - s + e[0]": (1, True),
    "e[1]*tanh(s) - s/(1 + z @ z)": ("N", "may grow"),
    "clip(s**2, -1, 4) + where(s > 1, s, 2*s)": ("N", "may grow"),
    "s**(sum(phi_x*0 + 1) - 1)": ("N", "may grow, for N = 2"),
}


@pytest.mark.parametrize("rate", OTHER_STATES)
def test_a_proof_says_whether_other_states_exist(rate):
    size, exists = OTHER_STATES[rate]
    verdict = of(beside(f"s' = {rate}", {"s": size})())
    fails = ["s: not held by V, exist for all t"] * (not exists)
    assert [
        step.claim for step in verdict.failed if "every N" not in step.claim
    ] == fails
    assert verdict.status == "proved"
    assert verdict.conclusion == ("goes to zero" if exists else "square-integrable")
    others = {
        True: {("outside V, bounded", "x, s are")},
        False: {("outside V, bounded", "x is"), ("existence", "s")},
    }
    grows = {("outside V, bounded", "x is"), ("outside V", "s is")}
    inputs = ("bounded inputs", "phi_x, zc are")
    assert fields_of(verdict) - {inputs} == others.get(exists, grows)
    assert (inputs in fields_of(verdict)) or not exists
    assert verdict.for_every_N == (exists in (True, "may grow"))


def squared(t, x, u, p):
    return {port: getattr(x, port) for port in LEARNED} | {"s": x.s**2 + 2}


ENDING = [
    (beside("s' = 0*s", {"s": 1}, GAIN | TICKS["parameters"],
            breakpoints=whole_times, jump=squared), "s"),
    (changed(  # of s[3, N] two rows are alpha; the third leaves in finite time
        "s' = stack([*dalpha, s[2]**2 + 1])", states={"s": (3, "N"), "K": 2, "Gamma": 2},
        output=lambda t, x, u, p: {"alpha": x.s[:2], "K": x.K, "Gamma": x.Gamma},
        outputs=LEARNED), "s_3[1], s_3[2]"),
]  # fmt: skip


@pytest.mark.parametrize(("make", "ends"), ENDING)
def test_a_state_that_may_end_is_said(make, ends):
    verdict = of(make())
    assert (verdict.status, verdict.conclusion) == ("proved", "square-integrable")
    assert ("existence", ends) in fields_of(verdict)
    assert f"as long as runs of {ends} exist" in verdict.sentence


# --- invariants -----------------------------------------------------------------------------------


@pytest.mark.parametrize("measure", ["log(cosh(e))", "e**2/2"])
def test_no_law_is_told_the_truth_by_what_it_keeps(measure):
    """A law that learns nothing keeps alpha = -theta only if it begins so, which none does."""

    def kept(s, p, truth):
        return {"alpha": -truth.theta, "K": truth.KD, "Gamma": truth.GammaD}

    found = of(user_laws.scaled("0.0")(), of_e(measure), invariants=kept)
    assert found.status == "open"
    assert any("does not hold at the start" in step.detail for step in found.failed)


def test_a_V_with_what_states_keep_may_be_made_of_parameters_too():
    case = user_laws.TEXTBOOK["least squares"]
    own = case.more | {"V": lambda truth, p: case.more["V"](truth)}
    one, other = of(case.make(), **case.more), of(case.make(), seed=7, **own)
    assert (one.status, one.conclusion) == (other.status, other.conclusion)
    assert (one.status, one.claim) == ("proved", other.claim)


KEEPING = [
    ("r' = 1 + r**2", {"r": 1}, lambda s: {}),  # ends at pi/2
    ("r' = 0*r - 1.0; q' = q**2", {"r": 1, "q": 1}, lambda s: {"q": 1 / s["r"]}),
]


@pytest.mark.parametrize(("rates", "sizes", "kept"), KEEPING)
def test_a_law_that_keeps_relations_is_asked_for_states_that_end(rates, sizes, kept):
    more = {"invariants": lambda s, p, truth: kept(s), "losses": lambda s, p, truth: []}
    found = of(beside(rates, sizes)(), of_e("e**2/2"), **more)
    assert (found.status, found.conclusion) == ("proved", "square-integrable")
    assert ("existence", ", ".join(sizes)) in fields_of(found)


KEEPING_A_MATRIX = [
    (
        "P' = P*sum(alpha**2); R' = -R*sum(alpha**2)",
        lambda s: {"P": 1 / s["R"]},
        "what is kept does not repel",
    ),
    ("P' = 0*P; R' = -sqrt(abs(R))", lambda s: {}, "c^T M' c >= 0"),
]


@pytest.mark.parametrize(("rates", "kept", "said"), KEEPING_A_MATRIX)
def test_a_law_that_keeps_a_matrix_is_asked_for_its_end(rates, kept, said):
    """P = 1/R may end where V holds R eta^2 alone; R = -t^2/4 leaves 0 as well."""

    def lost(s, p, truth):
        eta = truth.theta + s["alpha"]
        return [
            (np.sum(eta**2), np.sum(s["alpha"] ** 2), s["R"][0, 0], 1 / (2 * p.gain))
        ]

    more = {
        "invariants": lambda s, p, truth: kept(s),
        "losses": lost,
        "semidefinite": ("R",),
    }
    own = beside(
        f"alpha' = -gain*outer(e, P @ phi_x); {rates}", {"P": (1, 1), "R": (1, 1)}, n=1
    )
    found = of(own(), V_of(WITH_R, LEARNED | {"R": (1, 1)}), **more)
    assert next(step.claim for step in found.steps if not step.holds).startswith(said)
    assert found.status == "open" or found.conclusion == "square-integrable"


# --- what is no law, or no loop of one ------------------------------------------------------------


def test_a_law_called_as_a_block_that_holds_the_truth_is_refused():
    known = GAIN | {"KD": np.array([1.0, 0.7])}
    own = changed("K' = dK - (K - KD)", known)()
    assert of(own).conclusion == "bounded in the mean"
    with pytest.raises(
        DiagramError, match=r"^error_system: its parameter KD would be taken for"
    ):
        of(own.copy("error_system"))


RISING = [
    (
        {"flow.disturbance": {"kind": "constant", "amplitude": [0.1, 0.1]}},
        "a disturbance",
    ),
    ({"localization": {"noise": 0.1, "noise_period": 1.0}}, "noise in its positions"),
    (
        {"vehicle.max_speed": 1.0, "learning.hedging": False},
        "a limit of its speed without hedging",
    ),
    ({"learning.adapt_gains": False}, "K and Gamma that are held"),
]


@pytest.mark.parametrize(("values", "said"), RISING)
def test_a_loop_whose_V_may_rise_is_not_judged_by_its_law(values, said):
    """From a true start V is 0, and rises: what is proved of the law is not so of the loop.

    Of K = KD that is held CLPE goes to zero; V' > 0 is where K is another.
    """
    scenario = clpt.paper_scenario().started_true().with_values(values)
    if scenario.learning.adapt_gains:
        assert clpt.simulate(scenario, [0.0, 60.0]).lyapunov.values[1] > 1e-6
    with pytest.raises(
        DiagramError, match=f"has {said}, so V' is not its law's alone; a law is"
    ):
        of(clpt.closed_loop(scenario))
