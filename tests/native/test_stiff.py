"""Stiff equations: exact to the tolerance, found by themselves, and nothing else taken for them."""

import random
import sys
from pathlib import Path

import numpy as np
import pytest
from random_diagrams import random_diagram

import clpt_control as clpt
from clpt_control.ensemble.members import Ensemble
from clpt_control.ensemble.of_scenarios import VariedScenario
from clpt_control.equations import Block, Guard
from clpt_control.errors import SimulationError
from clpt_control.native import batch, numbering
from clpt_control.native.batch import Batch
from clpt_control.native.native_diagram import NativeDiagram
from clpt_control.native.python_diagram import PythonDiagram

sys.path.insert(0, str(Path(__file__).parents[2]))  # benchmarks/ is no installed package

from benchmarks.stiff_problems import PROBLEMS

TOLERANCES = [1e-4, 1e-6, 1e-8, 1e-10]


def runner_of(problem, engine=NativeDiagram):
    return engine(Block("stiff", update=problem.rates, states={"s": len(problem.start)}))


def off(problem, found, rtol):
    """The error at the end, in tolerances."""
    atol = rtol * problem.absolute
    return np.max(np.abs(found.x[-1] - problem.exact) / (atol + rtol * np.abs(problem.exact)))


@pytest.mark.parametrize("method", ["rodas5p", "auto"])
@pytest.mark.parametrize("name", PROBLEMS)
def test_solutions_are_within_ten_tolerances(name, method):
    problem = PROBLEMS[name]
    runner = runner_of(problem)
    for rtol in TOLERANCES:
        found = runner.run(
            problem.start,
            [0.0, problem.end],
            rtol=rtol,
            atol=rtol * problem.absolute,
            method=method,
        )
        assert off(problem, found, rtol) < 10.0
        assert found.statistics["steps"] < 10_000
        assert ("Rodas5P" in found.method) or name == "heat"


@pytest.mark.parametrize("name", ["van der Pol", "Robertson", "late"])
def test_python_runs_them_as_machine_code_does(name):
    problem = PROBLEMS[name]
    options = {"rtol": 1e-6, "atol": 1e-6 * problem.absolute, "method": "rodas5p"}
    found = runner_of(problem, PythonDiagram).run(problem.start, [0.0, problem.end], **options)
    assert off(problem, found, 1e-6) < 10.0


def test_a_run_goes_on_from_where_it_is_stiff():
    """Samples before, between and at the end are those of one method; the attributes say when."""
    block = Block("late", update=PROBLEMS["late"].rates, states={"s": 1})
    times = np.append(np.linspace(0.0, 1e-4, 41), np.linspace(0.1, 10.0, 100))
    run = clpt.simulate(block, times, initial_state=[0.0], rtol=1e-9, atol=1e-9)
    lag = 1e7
    exact = lag * (lag * np.cos(times) + np.sin(times)) / (lag**2 + 1.0)
    exact -= exact[0] * np.exp(-lag * times)
    np.testing.assert_allclose(run["s"].values.ravel(), exact, atol=1e-8)
    first, _, when = run.attrs["method"].partition(", from t = ")
    assert first == "DOP853"
    assert when.endswith(" Rodas5P")
    assert 0.0 < float(when.split()[0]) < 1e-3
    assert run.attrs["solver_steps"] < 1_000


def test_when_python_looks_in_changes_no_number(monkeypatch):
    """How long a call of the solver is depends on the time it takes."""
    problem = PROBLEMS["OREGO"]

    def run():
        found = runner_of(problem).run(problem.start, [0.0, problem.end], rtol=1e-4, atol=1e-4)
        return found.method, found.x[-1].tolist(), found.statistics

    before = run()
    assert "Rodas5P" in before[0]
    monkeypatch.setattr(batch, "BEGIN", 1)
    monkeypatch.setattr(batch, "PAUSE", 0.0)
    assert run() == before


def coupled(t, x, u, p):
    """What has no derivative everywhere: tables, choices, roots, whole numbers."""
    return {
        "a": [
            np.where(x.a[0] > 0.0, np.sqrt(np.fabs(x.a[1])), x.a[2] ** 3),
            np.interp(x.a[0], [-1.0, 0.0, 2.0], [0.0, 3.0, 1.0]) * np.floor(3.0 * x.b[1]),
            np.maximum(x.a[1], x.b @ x.b) + np.exp(-x.a[2]) * t**2,
        ],
        "b": np.outer(x.b, x.b) @ x.b + np.cumsum(x.b) * np.arctan2(x.a[0], 2.0) + np.sin(t),
    }


def slopes_by_differences(runner, t, x):
    n, found = len(x), []
    for j in range(n + 1):
        h, moved = 1e-6, np.zeros(n + 1)
        moved[j] = h
        ahead, behind = (
            runner.sweep.derivative(t + s * moved[n], x + s * moved[:n]) for s in (1.0, -1.0)
        )
        found.append((ahead - behind) / (2.0 * h))
    return np.array(found).T


@pytest.mark.parametrize("form", [None, "unrolled", "looped"])
def test_slopes_are_exact(form):
    """df/dx as the solver uses it, of what it would not be right to differentiate by hand."""
    diagram = Block("coupled", update=coupled, states={"a": 3, "b": 5})
    runner = NativeDiagram(diagram, form=form)
    draw = np.random.default_rng(1)
    for _ in range(5):
        x, t = draw.normal(size=8), 0.7
        callee = runner.implicit()
        assert callee.linear.band[2] == 1  # by the derivative reading
        found, over_time = slopes_of(runner, t, x)
        wanted = slopes_by_differences(runner, t, x)
        np.testing.assert_allclose(found, wanted[:, :8], rtol=1e-6, atol=1e-6)
        np.testing.assert_allclose(over_time, wanted[:, 8], rtol=1e-6, atol=1e-6)


def slopes_of(runner, t, x):
    """df/dx and df/dt as the solver has them at the first step of a run."""
    callee = runner.implicit()
    n, end = len(x), t + 1e-9
    pieces = [runner.schedule((t, end))]
    P = runner.parameters()
    batch = Batch(callee, x[None], P[None], np.array([t, end]), pieces)
    batch.advance(1e-3, 1e-3, 1)
    places = batch.callee.linear.places
    slopes = batch.linear[0][: n * n].reshape(n, n).T[np.ix_(places, places)]
    return slopes, batch.Z[numbering.TIME_SLOPE * n : (numbering.TIME_SLOPE + 1) * n].copy()


@pytest.mark.parametrize("seed", range(6))
def test_slopes_of_random_diagrams_are_exact(seed):
    runner = NativeDiagram(random_diagram(random.Random(seed)))
    x = np.random.default_rng(seed).normal(size=runner.nstates)
    if not runner.nstates or not np.all(np.isfinite(runner.sweep.derivative(0.3, x))):
        pytest.skip("no rates there")
    runner.sweep.enter(0.3)
    wanted = slopes_by_differences(runner, 0.3, x)
    found = np.column_stack(slopes_of(runner, 0.3, x))
    known = np.isfinite(wanted) & (np.abs(wanted) < 1e3)  # the rest is a jump
    np.testing.assert_allclose(found[known], wanted[known], rtol=1e-5, atol=1e-5)


def chained(t, x, u, p):
    """A chain whose links lie apart, as two quantities in each place do."""
    left = np.concatenate([[0.0], x.a[:-1]])
    return {"a": 2.0 * left - x.a + x.b, "b": x.a * x.b - np.sin(x.b)}


def test_a_chain_takes_few_derivatives_and_a_narrow_band():
    runner = NativeDiagram(Block("chained", update=chained, states={"a": 50, "b": 50}))
    linear = runner.implicit().linear
    assert len(linear.begins) - 1 <= 4
    assert max(linear.band[:2]) <= 4
    draw = np.random.default_rng(2)
    x = draw.normal(size=100)
    np.testing.assert_allclose(
        slopes_of(runner, 0.0, x)[0], slopes_by_differences(runner, 0.0, x)[:, :100], atol=1e-7
    )


def rooted(t, x, u, p):
    """The slope of the root is infinite where the run begins."""
    return [-1e5 * (x[0] - np.sqrt(x[1])), 1.0 + 0.0 * x[0]]


def test_a_slope_that_is_infinite_ends_no_run():
    runner = NativeDiagram(Block("rooted", update=rooted, states={"s": 2}))
    found = runner.run([0.0, 0.0], [0.0, 4.0], rtol=1e-8, atol=1e-8, method="rodas5p")
    assert found.x[-1, 1] == pytest.approx(4.0)
    assert found.x[-1, 0] == pytest.approx(2.0 - 2.5e-6, abs=1e-7)


# --- what is not stiff --------------------------------------------------------------------------


def clipped(t, x, u, p):
    """A stiff spring that gives way."""
    return [x[1], -np.clip(1e9 * x[0], -50.0, 50.0) - 1e5 * x[1] + np.sin(t)]


def test_stiffness_beside_a_kink_is_found():
    runner = NativeDiagram(Block("clipped", update=clipped, states={"s": 2}))
    found = runner.run([1e-9, 0.0], [0.0, 3.0], rtol=1e-6, atol=1e-12)
    assert "Rodas5P" in found.method
    assert found.x[-1, 0] == pytest.approx((np.sin(3.0) - 1e-4 * np.cos(3.0)) / 1e9, rel=1e-4)


def test_runs_that_are_not_stiff_stay_with_the_explicit_method():
    scenario = clpt.paper_scenario().with_values({"run.duration": 200})
    runner = NativeDiagram(clpt.closed_loop(scenario))
    start, times = clpt.initial_state(scenario), np.linspace(0.0, 200.0, 11)
    by_itself, asked = (runner.run(start, times, method=m) for m in (None, "dop853"))
    assert by_itself.method == "DOP853"
    np.testing.assert_array_equal(by_itself.x, asked.x)


# --- in a diagram with pieces, jumps and guards -------------------------------------------------


def test_a_stiff_law_runs_through_its_waypoints():
    values = {"learning.law": "composite-memory", "run.duration": 100}
    gain = {"learning.composite_memory.memory_gain": 1e4}
    scenario = clpt.paper_scenario().with_values({**values, **gain})
    runner = NativeDiagram(clpt.closed_loop(scenario))
    start, times = clpt.initial_state(scenario), np.linspace(0.0, 100.0, 101)
    exact = runner.run(start, times, rtol=1e-11, atol=1e-13, method="rodas5p").x
    for rtol in (1e-4, 1e-7):
        found = runner.run(start, times, rtol=rtol, atol=1e-2 * rtol)
        assert "Rodas5P" in found.method
        assert np.max(np.abs(found.x - exact) / (1.0 + np.abs(exact))) < 10.0 * rtol


def times_of(p, t0, t1):
    every = np.arange(1.0, 20.0)
    return every[(every > t0) & (every <= t1)]


@pytest.mark.parametrize(
    ("engine", "method"),
    [
        (NativeDiagram, "auto"),
        (NativeDiagram, "rodas5p"),
        (PythonDiagram, "rodas5p"),
        pytest.param(PythonDiagram, "auto", marks=pytest.mark.slow),
    ],
)
def test_jumps_of_stiff_states(engine, method):
    """s falls to cos t at once, and is doubled each second."""
    block = Block(
        "kicked",
        update=lambda t, x, u, p: [-1e6 * (x[0] - np.cos(t)) - np.sin(t)],
        states={"s": 1},
        parameters={"interval": -1.0},
        breakpoints=times_of,
        jump=lambda t, x, u, p: [2.0 * x[0]],
    )
    times = np.array([0.0, 0.5, 1.0, 1.5, 2.0, 2.5])
    found = engine(block).run([1.0], times, rtol=1e-8, atol=1e-8, method=method)
    assert "Rodas5P" in found.method
    at_jumps = np.array([1.0, 1.0, 2.0, 1.0, 2.0, 1.0])
    np.testing.assert_allclose(found.x[:, 0], at_jumps * np.cos(times), atol=1e-6)


def test_a_guard_ends_a_stiff_run_where_it_is_left():
    block = Block(
        "warned",
        update=lambda t, x, u, p: [-1e6 * (x[0] - np.sin(t)) + np.cos(t)],
        states={"s": 1},
        guard=Guard(lambda t, x, u, p: 0.5 - x[0], "stop", lambda t, u, p: "too high"),
    )
    found = NativeDiagram(block).run([0.0], np.linspace(0.0, 2.0, 21), rtol=1e-9, atol=1e-9)
    assert found.status == "stopped"
    assert found.t[-1] == pytest.approx(np.arcsin(0.5), abs=1e-8)
    np.testing.assert_allclose(found.x[:, 0], np.sin(found.t), atol=1e-7)


# --- longest and first steps --------------------------------------------------------------------


def pulse(t, x, u, p):
    """A pulse of 0.05 s at t = 500."""
    return [np.exp(-(((t - 500.0) / 0.02) ** 2)) + 0.0 * x[0]]


@pytest.mark.parametrize("method", ["auto", "rodas5p"])
def test_no_step_is_longer_than_asked(method):
    block = Block("pulse", update=pulse, states={"s": 1})
    run = clpt.simulate(block, [0.0, 1000.0], max_step=0.1, method=method)
    assert float(run["s"][-1]) == pytest.approx(0.02 * np.sqrt(np.pi), abs=1e-8)
    assert run.attrs["solver_steps"] >= 10_000


def test_the_first_step_is_the_one_asked_for():
    block = Block("still", update=lambda t, x, u, p: [0.0 * x[0]], states={"s": 1})
    runner = NativeDiagram(block)
    assert runner.run([1.0], [0.0, 1.0], first_step=1.0).statistics["steps"] == 1
    assert runner.run([1.0], [0.0, 1.0], first_step=1e-3).statistics["steps"] > 3


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"method": "radau"}, "method = 'radau': must be one of auto, dop853, dopri5, rodas5p"),
        ({"method": "dop853", "step": 0.1}, "method: a fixed step has none"),
        ({"max_step": 0.1, "step": 0.1}, "max_step: a fixed step has none"),
        ({"max_step": 0.0}, "max_step = 0.0: must be a number, above 0"),
        ({"first_step": -1.0}, "first_step = -1.0: must be a number, above 0"),
        ({"first_step": float("nan")}, "first_step = nan: must be a number, above 0"),
    ],
)
def test_what_no_method_takes_is_refused(given, sentence):
    runner = runner_of(PROBLEMS["late"])
    with pytest.raises(SimulationError, match=sentence):
        runner.run([0.0], [0.0, 1.0], **given)


# --- ensembles ----------------------------------------------------------------------------------


@pytest.mark.parametrize("lanes", [False, True])
def test_stiff_members_are_run_one_by_one_and_change_no_other(lanes):
    run = {"run.duration": 20, "run.rtol": 1e-6, "run.atol": 1e-8}
    scenario = clpt.paper_scenario().with_values(run)
    ensemble = Ensemble(VariedScenario(scenario), ["learning.gain"])
    ensemble.lanes = ensemble.lanes if lanes else 1
    gains = np.array([0.01, 1e6, 0.02, 3e5])
    members = ensemble.members({"learning.gain": gains})
    found = ensemble.run(members, np.array([0.0, 10.0, 20.0]))
    assert list(found.status) == [numbering.FINISHED] * 4
    own = ensemble.members({"learning.gain": gains[[0, 2]]})
    alone = ensemble.run(own, np.array([0.0, 10.0, 20.0]))
    np.testing.assert_array_equal(found.states[[0, 2]], alone.states)
    beside = np.array([3e5, *np.geomspace(1e4, 1e7, 9), 1e6])  # others, each stiff in its time
    again = ensemble.run(ensemble.members({"learning.gain": beside}), np.array([0.0, 10.0, 20.0]))
    np.testing.assert_array_equal(again.states[[-1, 0]], found.states[[1, 3]])
    same = ensemble.members({"learning.gain": np.full(8, 1e6)})  # stiff all at once
    again = ensemble.run(same, np.array([0.0, 10.0, 20.0]))
    np.testing.assert_array_equal(again.states, np.tile(found.states[1], (8, 1, 1)))
    one = scenario.with_values({"learning.gain": 1e6})
    runner = NativeDiagram(clpt.closed_loop(one))
    whole = runner.run(clpt.initial_state(one), [0.0, 10.0, 20.0], rtol=1e-6, atol=1e-8)
    assert "Rodas5P" in whole.method
    apart = 1e-5 if lanes else 1e-12  # lanes sum in another order, so that errors are others
    np.testing.assert_allclose(found.states[1], whole.x, rtol=0, atol=apart)
