"""What is shown of a law that learns at fixes, and what is refused of its runs."""

import numpy as np
import pytest
from responses import response

import clpt_control as clpt
from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.proving import fixes
from clpt_control.theory.proving.fixes import AtAFix, fix_steps
from clpt_control.theory.proving.theorem_loop import AT_FIXES

LAW = LAWS["fix-regression"]
AT = clpt.paper_scenario().with_values({"learning.law": LAW.name, **AT_FIXES})


def test_every_step_is_shown():
    steps = fix_steps(LAW, 50)
    assert [step.how for step in steps] == ["exact"] * 4 + ["sampled"]
    assert all(step.holds for step in steps)


@pytest.mark.slow
@pytest.mark.parametrize("late", [False, True])
def test_a_fix_is_shown_for_three_functions(late):
    assert AtAFix(LAW, 3, late).learns() == ""


def test_a_fix_that_is_not_exact_is_not_what_is_shown():
    case = AtAFix(LAW, 1, late=False)
    case.known[case.loop.inputs["fix"][0]] += 1
    said = case.learns()
    assert "V" in said


def test_a_law_that_forgets_the_integral_is_refuted(monkeypatch):
    monkeypatch.setattr(fixes, "MOVING", ("x", "z"))
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
