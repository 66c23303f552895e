"""Stiff equations: exact to the tolerance, found by themselves, and nothing else taken for them."""

import itertools
import random
import re
import sys
import time

import control
import numpy as np
import pytest
from engine_runs import (
    Batch,
    Form,
    NativeDiagram,
    PythonDiagram,
    Status,
    solver_layout,
    wiring_of,
)
from paths import ROOT
from random_diagrams import random_diagram
from text_systems import ticking, written

import clpt_control as clpt
from clpt_control import Block, Guard

# benchmarks/ is no installed package
sys.path.insert(0, str(ROOT))

from benchmarks.stiff_problems import PROBLEMS


def wired(text):
    """What is written, to be run."""
    return wiring_of(written(text)[0])


def run_of(problem, rtol, engine=NativeDiagram, **more):
    """Run a problem to its end; return the run, and its error there in tolerances."""
    runner = engine(
        Block("stiff", update=problem.rates, states={"s": len(problem.start)})
    )
    atol = rtol * problem.absolute
    found = runner.run(problem.start, [0.0, problem.end], rtol=rtol, atol=atol, **more)
    off = np.abs(found.x[-1] - problem.exact) / (atol + rtol * np.abs(problem.exact))
    return found, off.max()


@pytest.mark.parametrize("method", ["rodas5p", "auto"])
@pytest.mark.parametrize("name", PROBLEMS)
def test_solutions_are_within_ten_tolerances(name, method):
    for rtol in (1e-4, 1e-6, 1e-8, 1e-10):
        found, off = run_of(PROBLEMS[name], rtol, method=method)
        assert off < 10.0
        assert found.statistics["steps"] < 10_000
        assert "Rodas5P" in found.method


@pytest.mark.parametrize("name", ["van der Pol", "Robertson", "late"])
def test_python_runs_them_as_machine_code_does(name):
    assert run_of(PROBLEMS[name], 1e-6, PythonDiagram, method="rodas5p")[1] < 10.0


def test_runs_show_order_five():
    """A pendulum that is pushed."""
    runner = NativeDiagram(wired("x' = v; v' = -sin(x) + cos(2*t)*v"))
    start, ends, errors = [1.0, 0.3], [0.0, 4.0], []
    exact = runner.run(start, ends, rtol=1e-13, atol=1e-14, method="dop853").x
    for count in (16, 32, 64):
        steps = {"max_step": 4.0 / count, "first_step": 4.0 / count}
        found = runner.run(start, ends, rtol=1e6, atol=0.0, method="rodas5p", **steps)
        assert found.statistics["steps"] == count
        errors.append(np.abs(found.x[-1] - exact[-1]).max())
    assert np.all(np.log2(np.divide(errors[:-1], errors[1:])) > 4.7)


def test_a_run_goes_on_from_where_it_is_stiff():
    """Samples before, between and at the end are those of one method; the attributes say when."""
    block = Block("late", update=PROBLEMS["late"].rates, states={"s": 1})
    times = np.append(np.linspace(0.0, 1e-4, 41), np.linspace(0.1, 10.0, 100))
    run, lag = (
        clpt.simulate(block, times, initial_state=[0.0], rtol=1e-9, atol=1e-9),
        1e7,
    )
    exact = lag * (lag * np.cos(times) + np.sin(times)) / (lag**2 + 1.0)
    exact -= exact[0] * np.exp(-lag * times)
    np.testing.assert_allclose(run["s"].values.ravel(), exact, atol=1e-8)
    when = re.fullmatch(r"DOP853, from t = (\S+).* Rodas5P", run.attrs["method"])[1]
    assert 0.0 < float(when) < 1e-3
    assert run.attrs["solver_steps"] < 1_000


def test_a_loose_run_in_python_goes_on_from_where_it_is_stiff():
    runner = PythonDiagram(wired("x' = -1e5*(x - cos(t))"))
    found = runner.run([0.0], [0.0, 1.0], rtol=1e-4, atol=1e-6)
    assert found.method.endswith("LSODA")
    assert found.statistics["evaluations"] < 20_000
    assert found.x[-1, 0] == pytest.approx(np.cos(1.0), abs=1e-3)


@pytest.mark.long
def test_when_python_looks_in_changes_no_number(monkeypatch):
    """How long a call of the solver is depends on the time it takes."""

    def rates(t, x, u, p):
        return np.where(t < 3.0, 1.0, 1e6) * (np.cos(40.0 * t) - x)

    block = Block("many", update=rates, states={"s": 1000})
    given = {"initial_state": np.linspace(0.0, 1.0, 1000), "rtol": 1e-6, "atol": 1e-8}
    found = []
    for step in (1e3, 1e-9):  # seconds of a call: the calls get shorter or longer
        clock, calls = itertools.count(step=step), []
        monkeypatch.setattr(time, "perf_counter", clock.__next__)
        run = clpt.simulate(block, [0.0, 4.0], progress=calls.append, **given)
        kept = [run.attrs[name] for name in ("method", "solver_steps")]
        found.append((kept, run["s"].values.tolist(), len(calls)))
    (*short, many), (*long, few) = found
    assert "Rodas5P" in run.attrs["method"]
    assert many > 10 * few
    assert short == long


# --- df/dx as the solver uses it ----------------------------------------------------------------


def coupled(t, x, u, p):
    """What has no derivative everywhere: tables, choices, roots, whole numbers."""
    return {
        "a": [
            np.where(x.a[0] > 0.0, np.sqrt(np.fabs(x.a[1])), x.a[2] ** 3),
            np.interp(x.a[0], [-1.0, 0.0, 2.0], [0.0, 3.0, 1.0])
            * np.floor(3.0 * x.b[1]),
            np.maximum(x.a[1], x.b @ x.b) + np.exp(-x.a[2]) * t**2,
        ],
        "b": np.outer(x.b, x.b) @ x.b
        + np.cumsum(x.b) * np.arctan2(x.a[0], 2.0)
        + np.sin(t),
    }


def chained(t, x, u, p):
    """A chain whose links lie apart, as two quantities in each place do."""
    left = np.concatenate([[0.0], x.a[:-1]])
    return {"a": 2.0 * left - x.a + x.b, "b": x.a * x.b - np.sin(x.b)}


COUPLED = Block("coupled", update=coupled, states={"a": 3, "b": 5})
CHAINED = Block("chained", update=chained, states={"a": 50, "b": 50})
SLOPES = {
    **{f"coupled, {form}": (COUPLED, form) for form in (None, "unrolled", "looped")},
    "a chain": (CHAINED, None),
    **{
        f"random {seed}": (random_diagram(random.Random(seed)), None)
        for seed in range(6)
    },
}


@pytest.mark.long
@pytest.mark.parametrize("case", SLOPES)
def test_slopes_are_those_of_small_differences(case):
    diagram, form = SLOPES[case]
    runner, t = NativeDiagram(diagram, form=Form(form)), 0.7
    n, times, P = runner.nstates, np.array([t, t + 1.0]), runner.parameters()[None]
    pieces = [runner.schedule(tuple(times))]
    runner.sweep.enter(t)
    for x in np.random.default_rng(1).normal(size=(3 if n else 0, n)):
        step = Batch(runner.implicit(), x[None], P, times, pieces)
        step.advance(1e-3, 1e-3, 1)
        places, found = step.callee.linear.order, np.zeros((n, n + 1))
        found[:, :n] = step.linear[0][: n * n].reshape(n, n).T[np.ix_(places, places)]
        found[:, n] = step.Z[
            solver_layout.TIME_SLOPE * n : (solver_layout.TIME_SLOPE + 1) * n
        ]
        wanted = np.empty_like(found)
        for j, moved in enumerate(1e-6 * np.eye(n + 1)):
            ends = (
                runner.sweep.derivative(t + s * moved[n], x + s * moved[:n])
                for s in (1, -1)
            )
            wanted[:, j] = np.subtract(*(own.copy() for own in ends)) / 2e-6
        known = np.isfinite(wanted) & (np.abs(wanted) < 1e3)  # the rest is a jump
        np.testing.assert_allclose(found[known], wanted[known], rtol=1e-5, atol=1e-5)


def test_a_chain_takes_few_derivatives_and_a_narrow_band():
    linear = NativeDiagram(CHAINED).implicit().linear
    assert len(linear.begins) - 1 <= 4
    assert max(linear.band) <= 4


def test_a_slope_that_is_infinite_ends_no_run():
    """The slope of the root is infinite where the run begins."""
    runner = NativeDiagram(wired("x' = -1e5*(x - sqrt(y)); y' = 1 + 0*x"))
    found = runner.run([0.0, 0.0], [0.0, 4.0], rtol=1e-8, atol=1e-8, method="rodas5p")
    np.testing.assert_allclose(found.x[-1], [2.0 - 2.5e-6, 4.0], atol=1e-7)


# --- what is not stiff --------------------------------------------------------------------------


def test_stiffness_beside_a_kink_is_found():
    """A stiff spring that gives way."""
    runner = NativeDiagram(wired("x' = v; v' = -clip(1e9*x, -50, 50) - 1e5*v + sin(t)"))
    found = runner.run([1e-9, 0.0], [0.0, 3.0], rtol=1e-6, atol=1e-12)
    assert "Rodas5P" in found.method
    assert found.x[-1, 0] == pytest.approx(
        (np.sin(3.0) - 1e-4 * np.cos(3.0)) / 1e9, rel=1e-4
    )


def test_runs_that_are_not_stiff_stay_with_the_explicit_method():
    runner, start = loop_of({"run.duration": 200})
    times = np.linspace(0.0, 200.0, 11)
    by_itself, asked = (runner.run(start, times, method=m) for m in (None, "dop853"))
    assert by_itself.method == "DOP853"
    np.testing.assert_array_equal(by_itself.x, asked.x)


def loop_of(values):
    """The paper's loop with values, to be run, and its start."""
    scenario = clpt.paper_scenario().with_values(values)
    return NativeDiagram(clpt.closed_loop(scenario)), clpt.initial_state(scenario)


# --- absent species ------------------------------------------------------------------------------


def food_web(seed):
    """Prey by the logistic law, a quick sensor of it, and two to five absent stages of predators.

    The stages turn into each other, eat prey and each other, and are seen by the sensor.
    """
    random = np.random.default_rng(seed)
    count = 2 + seed % 4
    turns = 10.0 ** random.uniform(-1.0, 3.0, (count, count))
    births = 10.0 ** random.uniform(0.0, 2.0, (count, count))
    seen = 10.0 ** random.uniform(2.0, 5.0, count)

    def rates(t, x, u, p):
        prey, sensor, stages = x[0], x[1], x[2:]
        eaten = births @ (stages / (0.1 + prey + stages)) * prey
        moved = turns @ stages - turns.sum(axis=0) * stages
        return [
            p["growth"] * prey * (1.0 - prey) - np.sum(stages) * prey,
            3e4 * (prey - sensor) + seen @ stages,
            *(moved + eaten - 0.3 * stages),
        ]

    n = count + 2
    return control.nlsys(
        rates, inputs=0, states=n, outputs=n, name="web", params={"growth": 0.7}
    )


@pytest.mark.parametrize("method", ["auto", "rodas5p"])
@pytest.mark.parametrize("seed", range(6))
def test_absent_groups_of_species_stay_absent(seed, method):
    web, times = food_web(seed), np.linspace(0.0, 40.0, 5)
    start = [0.01, 0.9, *[0.0] * (web.nstates - 2)]
    run = clpt.simulate(web, times, None, start, method=method)
    assert "Rodas5P" in run.attrs["method"]
    x = run.states.values
    assert np.all(x[:, 2:] == 0.0)
    np.testing.assert_allclose(
        x[:, 0], 1.0 / (1.0 + 99.0 * np.exp(-0.7 * times)), rtol=1e-6
    )


def test_absent_species_arrive_with_an_input():
    """x' = a (y - x) + u, y' = a (x - y): the mean of both is u t / 2 from where u begins."""

    def rates(t, x, u, p):
        return [1e4 * (x[1] - x[0]) + u[0], 1e4 * (x[0] - x[1]), -1e5 * (x[2] - 1.0)]

    pair = control.nlsys(rates, inputs=1, states=3, outputs=3, name="pair")
    times = np.linspace(0.0, 20.0, 21)
    arrival = np.where(times < 10.0, 0.0, 0.5 * (times - 10.0))
    run = clpt.simulate(pair, times, arrival, [0.0, 0.0, 0.2], method="rodas5p")
    x = run.states.values
    assert np.all(x[:11, :2] == 0.0)
    assert np.sum(x[-1, :2]) == pytest.approx(0.25 * 10.0**2, rel=1e-7)


def test_absent_species_of_members_stay_absent():
    web = food_web(1)
    growth = [0.2, 0.5, 1.0]
    data = clpt.run_ensemble(
        web, {"growth": growth}, timepts=[0.0, 5.0], trajectories=True,
        initial_state=[0.01, 0.9, 0.0, 0.0, 0.0], method="rodas5p",
    )  # fmt: skip
    x = data.y.values[:, -1]
    assert np.all(x[:, 2:] == 0.0)
    right = 1.0 / (1.0 + 99.0 * np.exp(-5.0 * np.array(growth)))
    np.testing.assert_allclose(x[:, 0], right, rtol=1e-6)


# --- in a diagram with pieces, jumps and guards -------------------------------------------------


@pytest.mark.long
def test_a_stiff_law_runs_through_its_waypoints():
    gain = {"learning.composite_memory.memory_gain": 1e4, "run.duration": 100}
    runner, start = loop_of({"learning.law": "composite-memory", **gain})
    times = np.linspace(0.0, 100.0, 101)
    exact = runner.run(start, times, rtol=1e-11, atol=1e-13, method="rodas5p").x
    for rtol in (1e-4, 1e-7):
        found = runner.run(start, times, rtol=rtol, atol=1e-2 * rtol)
        assert "Rodas5P" in found.method
        assert np.max(np.abs(found.x - exact) / (1.0 + np.abs(exact))) < 10.0 * rtol


WAYS = [
    (NativeDiagram, "auto"),
    (NativeDiagram, "rodas5p"),
    (PythonDiagram, "rodas5p"),
    (PythonDiagram, "auto"),
]


@pytest.mark.parametrize(("engine", "method"), WAYS)
def test_jumps_of_stiff_states(engine, method):
    """s falls to cos t at once, and is doubled each second."""
    rate = lambda t, x, u, p: -1e6 * (x - np.cos(t)) - np.sin(t)  # noqa: E731
    block = ticking(rate, lambda t, x, u, p: 2.0 * x)
    times = np.array([0.0, 0.5, 1.0, 1.5, 2.0, 2.5])
    found = engine(block).run([1.0], times, rtol=1e-8, atol=1e-8, method=method)
    assert "Rodas5P" in found.method
    at_jumps = np.array([1.0, 1.0, 2.0, 1.0, 2.0, 1.0])
    np.testing.assert_allclose(found.x[:, 0], at_jumps * np.cos(times), atol=1e-6)


def test_a_guard_ends_a_stiff_run_where_it_is_left():
    rate = lambda t, x, u, p: -1e6 * (x - np.sin(t)) + np.cos(t)  # noqa: E731
    guard = Guard(lambda t, x, u, p: 0.5 - x[0], "stop", lambda t, u, p: "too high")
    warned = NativeDiagram(Block("warned", update=rate, states={"s": 1}, guard=guard))
    found = warned.run([0.0], np.linspace(0.0, 2.0, 21), rtol=1e-9, atol=1e-9)
    assert (found.status, found.t[-1]) == (
        "stopped",
        pytest.approx(np.arcsin(0.5), abs=1e-8),
    )
    np.testing.assert_allclose(found.x[:, 0], np.sin(found.t), atol=1e-7)


# --- longest and first steps --------------------------------------------------------------------


@pytest.mark.parametrize("method", ["auto", "rodas5p"])
def test_no_step_is_longer_than_asked(method):
    """A pulse of 0.05 s at t = 500."""
    pulse, _ = written("s' = exp(-(((t - 500)/0.02)**2)) + 0*s")
    run = clpt.simulate(pulse, [0.0, 1000.0], max_step=0.1, method=method)
    assert float(run.s[-1]) == pytest.approx(0.02 * np.sqrt(np.pi), abs=1e-8)
    assert run.attrs["solver_steps"] >= 10_000


def test_the_first_step_is_the_one_asked_for():
    runner = NativeDiagram(wired("s' = 0*s"))
    assert runner.run([1.0], [0.0, 1.0], first_step=1.0).statistics["steps"] == 1
    assert runner.run([1.0], [0.0, 1.0], first_step=1e-3).statistics["steps"] > 3


# --- ensembles ----------------------------------------------------------------------------------


@pytest.mark.long
def test_stiff_members_are_run_one_by_one_and_change_no_other():
    values = {"run.duration": 20, "run.rtol": 1e-6, "run.atol": 1e-8}
    scenario = clpt.paper_scenario().with_values(values)

    def ended(*gains):
        vary = {"learning.gain": gains}
        data = clpt.run_ensemble(scenario, vary, trajectories=True)
        assert np.all(data.status == Status.FINISHED)
        return np.stack([data.position.values, data.predicted_position.values], 1)

    found = ended(0.01, 1e7, 0.02, 3e5)
    np.testing.assert_array_equal(found[[0, 2]], ended(0.01, 0.02))
    # others, each stiff in its time
    beside = ended(3e5, *np.geomspace(1e4, 1e7, 9), 1e7)
    np.testing.assert_array_equal(beside[[-1, 0]], found[[1, 3]])
    # of one member, and of as many as run side by side
    np.testing.assert_array_equal(ended(1e7)[0], found[1])
    np.testing.assert_array_equal(ended(*[1e7] * 8), np.tile(found[1], (8, 1, 1, 1)))
