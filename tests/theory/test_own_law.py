"""No wrong law is proved, no right law refuted: each row of the table is a case."""

import control
import numpy as np
import own_laws
import pytest
import sympy
from own_laws import BOUNDED, GAIN, NOT_PROVED, NOT_REFUTED, REFUTED, RIGHT, TOO_MUCH, N, law
from textbook_laws import by, of_e, with_R

import clpt_control as clpt
from clpt_control.blocks.lyapunov import lyapunov_candidate, weighted
from clpt_control.equations import Block
from clpt_control.errors import ClptError, DiagramError
from clpt_control.progress import interrupt
from clpt_control.theory.excitation.gramian import started_true
from clpt_control.theory.proving.own_law import prove
from clpt_control.theory.proving.theorem_loop import theorem_scenario
from clpt_control.theory.proving.theorems import audit

pytestmark = pytest.mark.usefixtures("few_calls")
POINTS = 100  # of running blocks in each case; the default is 10,000


@pytest.mark.parametrize("name", RIGHT)
def test_a_right_law_is_proved(name):
    make, every = RIGHT[name]
    verdict = prove(make(), points=POINTS)
    assert verdict.status == "proved"
    assert verdict.for_every_N == every
    assert verdict.point is None


@pytest.mark.parametrize("name", BOUNDED)
def test_a_robust_law_is_bounded(name):
    verdict = prove(BOUNDED[name](), points=POINTS)
    assert verdict.status == "bounded"
    assert "theta_1[1]**2" in verdict.claim


@pytest.mark.parametrize("name", REFUTED)
def test_a_wrong_law_is_refuted_at_a_point_that_anyone_can_call(name):
    verdict = prove(REFUTED[name](), points=POINTS)
    assert verdict.status == "refuted"
    t, x, u, params = verdict.point
    rates = verdict.diagram.dynamics(t, x, u, params)
    h = 1e-4 * np.abs(x).max() / np.abs(rates).max()
    ahead, behind = (verdict.diagram.output(t, x + s * rates, u, params)[-1] for s in (h, -h))
    assert (ahead - behind) / (2 * h) == pytest.approx(verdict.value, rel=1e-5)
    assert verdict.value > 0


LONG = ("half a projection",)  # of several seconds: by `make test-slow`


@pytest.mark.usefixtures("few_draws")
@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow) if n in LONG else n for n in NOT_PROVED]
)
def test_what_is_not_known_to_be_right_is_not_proved(name):
    verdict = prove(NOT_PROVED[name](), points=POINTS)
    assert verdict.status in ("open", "refuted")
    assert not all(step.holds for step in verdict.steps)


def test_an_indefinite_V_proves_nothing():
    turned_V = own_laws.V_of(lambda t, u, p: u.e @ u.e / 2 - own_laws.off(u, p) / (2 * p.gain))
    verdict = prove(own_laws.turned(), turned_V, points=POINTS)
    assert verdict.residual == 0
    assert verdict.status == "open"
    assert "positive definite" in next(s.claim for s in verdict.steps if not s.holds)
    assert repr(verdict).startswith("<Verdict open: V is positive definite")


@pytest.mark.parametrize(
    ("slope", "level", "status"),
    [
        (lambda e: e / (1 + e**2), lambda e: np.log(1 + e**2) / 2, "proved"),
        (lambda e: e / np.sqrt(1 + e**2), lambda e: np.sqrt(1 + e**2) - 1, "proved"),
        (lambda e: e / (1 + e**2) ** 2, lambda e: 0.5 - 0.5 / (1 + e**2), "open"),
    ],
    ids=["Cauchy", "pseudo-Huber", "ends at a half"],
)
def test_a_V_of_a_robust_loss_has_no_end(slope, level, status):
    V = own_laws.V_of(lambda t, u, p: level(u.e).sum() + own_laws.off(u, p) / (2 * p.gain))
    made = own_laws.driven(lambda t, x, u, p: slope(u.e))()
    assert prove(made, V, points=POINTS).status == status


def test_a_V_that_does_not_fit_refutes_no_law():
    def of(gain):
        return lambda truth: lyapunov_candidate("learned-flow", weighted([gain] * 3, *truth))

    for gain, status in ((0.5, "proved"), (0.7, "open")):
        assert prove(own_laws.paper(), of(gain), points=POINTS).status == status


@pytest.mark.parametrize(
    ("own", "V"), [(3, None), (None, 3), (None, None), (None, control.ss(-1, 1, 1, 0))]
)
def test_what_is_no_block_or_makes_no_V_is_refused(own, V):
    mine = own_laws.paper()
    with pytest.raises(ClptError, match=r"must be a (Block|function)|V\[1\]$"):
        prove(own or mine, V or mine)


def test_a_proof_can_be_interrupted(monkeypatch):
    monkeypatch.setattr(interrupt, "_pending", True)
    for work in (lambda: prove(own_laws.paper()), lambda: audit("3.2")):
        with pytest.raises(KeyboardInterrupt):
            work()


@pytest.mark.parametrize("name", NOT_REFUTED)
def test_laws_that_fall_with_another_V_are_not_refuted(name):
    assert prove(NOT_REFUTED[name](), points=POINTS).status == "open"


@pytest.mark.parametrize("name", TOO_MUCH)
def test_what_cannot_be_judged_is_refused_in_a_sentence(name):
    make, said = TOO_MUCH[name]
    with pytest.raises(ClptError, match=said):
        prove(make(), points=POINTS)


def test_a_law_may_have_any_name():
    own = own_laws.paper()
    own = Block(
        "theta_x",
        update=own.update_function,
        inputs=own.input_shapes,
        states=own.state_shapes,
        parameters=own.parameters,
    )
    assert prove(own, points=POINTS).status == "proved"


def test_what_has_no_value_says_so():
    verdict = prove(own_laws.divided_by_itself(), points=POINTS)
    said = next(s for s in verdict.steps if "value everywhere" in s.claim)
    assert not said.holds
    assert said.detail == "own.update divides by z_1, which may be zero"


def test_the_residual_of_a_held_gain_is_the_term_that_misses():
    without_feedforward = own_laws.changed(lambda t, x, u, p, r: r | {"Gamma": 0.0})
    verdict = prove(without_feedforward(), points=POINTS)
    assert verdict.status == "refuted"
    names = {str(symbol) for symbol in verdict.residual.free_symbols}
    assert {"Gamma_1", "GammaD_1", "x_1", "z_1"} <= names
    assert not {"theta_1[1]", "K_1"} & names
    assert isinstance(verdict.residual, sympy.Expr)


def test_a_block_that_is_no_law_is_refused():
    from clpt_control.blocks.clpe import clpe as block

    with pytest.raises(DiagramError, match=r"makes alpha\[2N\], K\[2\] and Gamma\[2\]"):
        prove(block())


def test_the_callers_law_is_left_as_it_is():
    own = own_laws.paper()
    x, u = np.ones(own.nstates), np.ones(own.ninputs)
    before = own.dynamics(0.0, x, u)
    prove(own, points=POINTS)
    np.testing.assert_array_equal(own.dynamics(0.0, x, u), before)


OTHER_STATES = {  # s' of a state that V does not hold, its size; whether it exists for all times
    "ends at pi/2": (lambda x, u: 1 + x.s**2, "N", False),
    "a cube": (lambda x, u: x.s**3 + u.e[0], "N", False),
    "a cube of one": (lambda x, u: x.s**3 + u.e[0], 1, False),
    "a product of all": (lambda x, u: x.s * np.sum(x.s * u.phi_x), "N", False),
    "s' = s^2 + e": (lambda x, u: x.s**2 + u.e[0], 1, False),
    "s' = s |s|": (lambda x, u: x.s * np.abs(x.s), 1, False),
    "s' = s^2 exp(s)": (lambda x, u: np.exp(np.clip(x.s, -9, 9)) * x.s**2, 1, False),
    "s' = s_2^2, s_2' = s_1": (lambda x, u: np.array([x.s[1] ** 2, x.s[0]]), 2, False),
    "s' = s_1 s_2": (lambda x, u: x.s[0] * x.s[1] * np.ones(2), 2, False),
    "s' = s^2 tanh(K)": (lambda x, u: x.s * x.s * np.tanh(x.K[0]), 1, False),
    "grows": (lambda x, u: x.s + 1, "N", True),
    "filters": (lambda x, u: -x.s + u.e[0], "N", True),
    "filters to one": (lambda x, u: -x.s + u.e[0], 1, True),
    "a share": (lambda x, u: u.e[1] * np.tanh(x.s) - x.s / (1 + u.z @ u.z), "N", True),
    "clipped": (lambda x, u: np.clip(x.s**2, -1, 4) + np.where(x.s > 1, x.s, 2 * x.s), "N", True),
    "linear for N = 2 alone": (lambda x, u: x.s ** (np.sum(u.phi_x * 0 + 1) - 1), "N", N),
}


@pytest.mark.parametrize("name", OTHER_STATES)
def test_a_proof_says_whether_other_states_exist(name):
    rate, size, exists = OTHER_STATES[name]
    own = own_laws.beside(lambda x, u: {"s": rate(x, u)}, {"s": size})
    verdict = prove(own(), points=POINTS)
    asked = next(step for step in verdict.steps if step.claim.startswith("s: "))
    assert asked.holds == bool(exists)
    assert verdict.status == ("proved" if exists else "proved as long as s exist")
    assert verdict.for_every_N == (exists is True)


def test_a_jump_that_squares_is_no_proof():
    def square(t, x, u, p):
        return {port: getattr(x, port) for port in own_laws.LEARNED} | {"s": x.s**2 + 2}

    ticks = {"breakpoints": lambda p, t0, t1: np.arange(np.ceil(t0), t1), "jump": square}
    own = own_laws.beside(lambda x, u: {"s": 0.0}, {"s": 1}, GAIN | {"interval": -1.0}, **ticks)
    assert prove(own(), points=POINTS).status == "proved as long as s exist"


def test_a_law_called_as_a_block_that_holds_the_truth_is_refused():
    def leak_to_KD(t, x, u, p):
        rates = own_laws.filled(u, 0.5, u.e)
        return rates | {"K": rates["K"] - (x.K - p.KD)}

    known = {"KD": np.array(theorem_scenario(N, "learned-flow").vehicle.feedback)}
    assert prove(law(leak_to_KD, known), points=POINTS).status == "bounded"
    own = law(leak_to_KD, known)
    named = Block(
        "error_system",
        update=leak_to_KD,
        inputs=own.input_shapes,
        states=own.state_shapes,
        parameters=known,
        sizes={"N": N},
    )
    with pytest.raises(DiagramError, match=r"^error_system: its parameter KD would be taken for"):
        prove(named, points=POINTS)


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"flow.disturbance": {"kind": "constant", "amplitude": [0.1, 0.1]}}, "a disturbance"),
        ({"localization": {"noise": 0.1, "noise_period": 1.0}}, "noise in its positions"),
        (
            {"vehicle.max_speed": 1.0, "learning.hedging": False},
            "a limit of its speed without hedging",
        ),
    ],
)
def test_a_loop_whose_V_may_rise_is_not_judged_by_its_law(values, said):
    """From a true start V is 0, and rises: what is proved of the law is not so of the loop."""
    scenario = started_true(clpt.paper_scenario()).with_values(values)
    assert clpt.simulate(scenario, [0.0, 60.0]).lyapunov.values[1] > 1e-6
    with pytest.raises(DiagramError, match=f"has {said}, so V' is not its law's alone; a law is"):
        prove(clpt.closed_loop(scenario), points=POINTS)


def test_a_loop_that_holds_the_right_gains_is_not_refuted_where_they_are_wrong():
    """Of K = KD, which stays, CLPE goes to zero; V' > 0 is where K is another."""
    scenario = started_true(clpt.paper_scenario()).with_values({"learning.adapt_gains": False})
    with pytest.raises(DiagramError, match="has K and Gamma that are held, so V' is not its"):
        prove(clpt.closed_loop(scenario), points=POINTS)


def test_two_states_of_one_symbol_are_refused():
    """K[2] is K_1 and K_2, and so is a state K_1."""
    own = own_laws.beside(lambda x, u: {"K_1": x.K_1}, {"K_1": ()})
    with pytest.raises(DiagramError, match="two states are called K_1; rename one"):
        prove(own(), points=POINTS)


def test_a_V_that_falls_where_e_grows_proves_nothing():
    """Of V = 0.05 e^2 + 1 - cos(e) the fall -KD e dV/de is 2.1 at e = 4.49, all else true."""
    measure = of_e(lambda e, p: 0.05 * e**2 + 1 - np.cos(e))
    found = prove(by(lambda e: 0.1 * e + np.sin(e))(), measure, points=POINTS)
    assert found.status == "open"
    (step,) = [step for step in found.steps if step.claim.startswith("V' =")]
    assert (step.holds, step.detail) == (False, "V is not known to rise with |e|")


def test_what_holds_for_the_parameters_as_they_are_says_so():
    """-c (eps_1^2 + eps_2^2) - 2 b eps_1 eps_2 is never positive for b < c alone."""

    def composite(t, x, u, p):
        """Eqs. (21)-(23) and the flow's own prediction errors, of both axes, section III."""
        eps = u.flow_x + x.alpha @ u.phi_x
        both = np.stack([p.c * eps[0] + p.b * eps[1], p.b * eps[0] + p.c * eps[1]])
        rates = own_laws.filled(u, p.gain, u.e)
        return rates | {"alpha": rates["alpha"] - np.outer(both, u.phi_x)}

    for b, status, said in ((0.5, "proved", True), (2.0, "refuted", False)):
        parameters = {"gain": 0.5, "c": 1.0, "b": b}
        found = prove(law(composite, parameters, own_laws.FLOW, n=1), points=POINTS)
        (step,) = [step for step in found.steps if step.claim.startswith("V' <=")]
        assert found.status == status
        assert ("and the parameters as they are" in step.claim) == said


def test_the_level_of_a_V_that_weighs_e_is_reached():
    """With phi = zc = z = 0 and Delta_1 = 100 e_1 comes to 100/KD_1, and 5 e^2 to 50000."""
    make = own_laws.leak(lambda t, x, u, p: 2.0)
    weighed = own_laws.V_of(lambda t, u, p: 5 * (u.e @ u.e + own_laws.off(u, p) / p.gain))
    found = prove(make(), weighed, points=POINTS)
    assert found.status == "bounded"
    known = {"KD_1": 1.0, "KD_2": 1.0, "Delta_1": 100.0}
    at = {s: known.get(s.name, 0.0) for s in found.level.free_symbols}
    assert found.level.subs(at) >= 50_000


@pytest.mark.parametrize(
    ("rates", "sizes", "kept"),
    [
        (lambda x, u: {"r": 1 + x.r**2}, {"r": 1}, lambda s: {}),  # ends at pi/2
        (lambda x, u: {"r": -1.0, "q": x.q**2}, {"r": 1, "q": 1}, lambda s: {"q": 1 / s["r"]}),
    ],
)
def test_a_law_that_keeps_relations_is_asked_for_states_that_end(rates, sizes, kept):
    squares = of_e(lambda e, p: e**2 / 2)
    more = {"invariants": lambda s, p, truth: kept(s), "losses": lambda s, p, truth: []}
    found = prove(own_laws.beside(rates, sizes)(), squares, points=POINTS, **more)
    assert found.status == f"proved as long as {', '.join(sizes)} exist"


@pytest.mark.parametrize(
    ("rates", "kept", "said"),
    [
        (lambda x, a: {"P": x.P * a, "R": -x.R * a}, lambda s: {"P": 1 / s["R"]}, "x, z, alpha"),
        (lambda x, a: {"P": 0.0, "R": -np.sqrt(np.abs(x.R))}, lambda s: {}, "c^T M' c >= 0"),
    ],
)
def test_a_law_that_keeps_a_matrix_is_asked_for_its_end(rates, kept, said):
    """P = 1/R may end where V holds R eta^2 alone; R = -t^2/4 leaves 0 as well."""

    def change(t, x, u, p, r):
        alpha = -p.gain * np.outer(u.e, x.P @ u.phi_x)
        return r | {"alpha": alpha} | rates(x, np.sum(x.alpha**2))

    def lost(s, p, truth):
        eta = truth.theta + s["alpha"]
        return [(np.sum(eta**2), np.sum(s["alpha"] ** 2), s["R"][0, 0], 1 / (2 * p.gain))]

    more = {"invariants": lambda s, p, truth: kept(s), "losses": lost, "semidefinite": ("R",)}
    own = own_laws.changed(change, n=1, states=own_laws.LEARNED | {"P": (1, 1), "R": (1, 1)})
    V = own_laws.V_of(with_R, own_laws.LEARNED | {"R": (1, 1)})
    found = prove(own(), V, points=POINTS, **more)
    first = next(step.claim for step in found.steps if not step.holds)
    assert first.startswith(said)
    assert found.status == "open" or found.status.startswith(f"proved as long as {said}")


def test_a_proof_says_what_no_vehicle_measures():
    own = own_laws.composite()
    said = [step.claim for step in prove(own, points=POINTS).steps]
    assert any("flow_x, the true flow, which no vehicle measures" in one for one in said)
    of_V = own_laws.beside(lambda x, u: {"s": u.V - x.s}, {"s": 1}, more={"V": 1})
    said = [step.claim for step in prove(of_V(), points=POINTS).steps]
    assert any("V, made of the truth, which no vehicle measures" in one for one in said)
    said = [step.claim for step in prove(own_laws.paper(), points=POINTS).steps]
    assert not any("measures" in one for one in said)


def test_an_input_that_is_misspelt_is_told_with_what_comes_from_outside():
    def rates(t, x, u, p):
        return {"alpha": -np.outer(u.e, u.phix), "K": -u.e, "Gamma": u.e}

    shapes = {"alpha": (2, "N"), "K": 2, "Gamma": 2}
    mine = Block("adaptation", update=rates, inputs={"e": 2, "phix": "N"}, states=shapes,
                      sizes={"N": 3})  # fmt: skip
    with pytest.raises(DiagramError, match=r"mean phi_x\?.*from outside come phi_x, phi_z, zc$"):
        prove(mine)
