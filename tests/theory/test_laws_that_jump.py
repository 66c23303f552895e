"""What is shown of a law whose states jump, of one that learns at fixes, and what is refused."""

import math

import numpy as np
import pytest
from own_laws import LEARNED, N, beside, formula
from responses import response

import clpt_control as clpt
from clpt_control.blocks.laws.table import LAWS
from clpt_control.equations import Block
from clpt_control.errors import DiagramError
from clpt_control.theory.proving import invariants
from clpt_control.theory.proving.invariants import ARRIVE, AtFixes, fix_steps
from clpt_control.theory.proving.own_law import prove
from clpt_control.theory.proving.symbolic_loop import ArrayLoop, symbolic_loop
from clpt_control.theory.proving.theorem_loop import AT_FIXES, theorem_loop

pytestmark = pytest.mark.usefixtures("few_calls")


def ticks(p, t0, t1):
    times = np.arange(1.0, math.floor(t1) + 1)
    return times[(times > t0) & (times <= t1)]


def jumping(text, gain=0.5):
    """The paper's law with a memory m, whose states jump at whole times as is written."""
    states = {**LEARNED, "m": 1}
    written = dict(part.split(" = ") for part in text.split("; "))
    after = {port: formula(one, states) for port, one in written.items()}

    def jump(t, x, u, p):
        """What is learned, changed, section III."""
        same = {port: getattr(x, port) for port in states}
        return same | {port: one(t, x, u, p) for port, one in after.items()}

    ticking = {"gain": gain, "interval": -1.0}
    return beside("m' = 0*m", {"m": 1}, ticking, breakpoints=ticks, jump=jump)()


CASES = {
    "m = e @ e": ("proved", ""),
    "alpha = 0.5*alpha": ("proved between jumps", "V changes by"),
    "alpha = 0.0*alpha": ("proved between jumps", "V changes by"),
}


@pytest.mark.parametrize("change", CASES)
def test_what_is_known_of_jumps_is_said(change):
    status, detail = CASES[change]
    verdict = prove(jumping(change), points=200)
    across = verdict.steps[-1]
    assert (verdict.status, across.holds) == (status, status == "proved")
    assert across.claim == "V does not rise where states of own jump"
    assert across.detail.startswith(detail)
    assert not verdict.for_every_N


@pytest.mark.parametrize(("change", "holds"), [("m = 0.5*m", True), ("m = e @ e", False)])
def test_V_may_fall_where_states_jump(change, holds):
    level = lambda t, x, u, p: {"V": (u.e @ u.e + u.m @ u.m) / 2}  # noqa: E731
    V = Block("lyapunov", output=level, inputs={"e": 2, "m": 1}, outputs={"V": 1})
    assert prove(jumping(change), lambda truth: V, points=200).steps[-1].holds == holds


def test_a_wrong_law_is_refuted_all_the_same():
    assert prove(jumping("m = e @ e", gain=-0.5), points=200).status == "refuted"


@pytest.mark.parametrize("read", [symbolic_loop, ArrayLoop])
def test_other_proofs_refuse_jumps(read):
    diagram = theorem_loop(N, "learned-flow", law_block=jumping("m = e @ e"))
    with pytest.raises(DiagramError, match=r"^own: its states jump, and this proof speaks of no"):
        read(diagram)


WRONG = [
    "alpha = -alpha",
    "alpha = -alpha; K = -K; Gamma = -Gamma",
    "alpha = where(abs(K[0]) > 1.0, alpha, -3.0*alpha)",
    "K = where(K > 3, -K, K)",
    "alpha = alpha[::-1]",
    "K = K + 0.1",
    "Gamma = Gamma + e",
]


@pytest.mark.parametrize("change", WRONG)
def test_a_jump_at_which_V_rises_refutes(change):
    verdict = prove(jumping(change), points=200)
    assert verdict.status == "refuted at a jump"
    before, after = (verdict.diagram.output(*one)[-1] for one in (verdict.point, verdict.after))
    assert verdict.point.t == verdict.after.t == math.floor(verdict.point.t) > 0
    assert after > before
    assert not verdict.for_every_N


LAW = LAWS["fix-regression"]
AT = clpt.paper_scenario().with_values({"learning.law": LAW.name, **AT_FIXES})


def test_every_step_is_shown():
    steps = fix_steps(LAW, 50)
    assert [step.how for step in steps] == ["exact"] * 2 + ["sampled"]
    assert all(step.holds for step in steps)


@pytest.mark.slow
@pytest.mark.parametrize("late", [False, True])
def test_a_fix_is_shown_for_three_functions(late):
    assert AtFixes(LAW, 3, late).learns() == ""


def test_a_fix_that_is_not_exact_is_not_what_is_shown():
    assert "V" in AtFixes(LAW, 1, late=False).after(ARRIVE, 1, off=1)


def test_a_law_that_forgets_the_integral_is_refuted(monkeypatch):
    monkeypatch.setattr(invariants, "MOVING", ("x", "z"))
    assert not fix_steps(LAW, 10)[0].holds


def test_V_never_rises_in_a_uniform_current_whatever_is_missing_or_late():
    values = {
        "basis.kernel": "gaussian",
        "basis.centers": [[0.0, 0.0], [1.0, 0.0]],
        "basis.widths": [1e9, 1e9],
        "basis.periods": [float("inf"), 12.0],
        "basis.phases": None,
        "flow.parameters": [[0.3, 0.1], [-0.2, 0.2]],
        "model.parameters": None,
        "learning.parameters": None,
        "localization.dropouts": 0.3,
        "localization.latency": 2.0,
        "run.duration": 200.0,
    }
    run = clpt.simulate(AT.with_values(values))
    V = run.lyapunov.values
    assert np.all(np.diff(V) <= 1e-12 * V[0])
    assert V[-1] < 1e-3 * V[0]
    eta = run.flow_parameters_estimate.values - run.flow_parameters.values
    variance = np.diag(np.linalg.inv(information_at_end(values)))
    assert np.all(eta[-1] ** 2 <= 2 * V[0] * variance / R**2 * (1 + 1e-9))


R = 0.3  # the law's default, a tenth of the track's reach


def information_at_end(values):
    """P^-1 by the response of the diagram, which has it as a port."""
    scenario = AT.with_values(values)
    loop, state = clpt.closed_loop(scenario), clpt.initial_state(scenario)
    ran = response(loop, [0.0, 200.0], initial_state=state)
    names = [f"information[{k}]" for k in range(4)]
    return np.array([ran.outputs[ran.output_labels.index(n), -1] for n in names]).reshape(2, 2)


def test_what_is_not_known_of_runs_with_fixes_or_noise_is_refused():
    scenario = AT.with_values({"run.duration": 40.0})
    with pytest.raises(clpt.ClptError, match="give the scenario in place of the run"):
        clpt.theory.gramian(clpt.simulate(scenario), 20.0, 0.0)
    assert clpt.theory.gramian(scenario, 20.0, 0.0).eigenvalues["x1"][0] > 0
    with pytest.raises(clpt.ClptError, match="only law that learns at fixes"):
        clpt.ensemble.tune_law(scenario, members=3)
    noisy = {"localization": {"noise": 0.1, "noise_period": 1.0}, "run.duration": 40.0}
    with pytest.raises(clpt.ClptError, match=r"no certificate: localization\.noise"):
        clpt.theory.certificate(clpt.paper_scenario().with_values(noisy), 20.0, 0.0)
