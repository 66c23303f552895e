"""Runs before the solver is compiled: in Python where they are short, and what is said."""

import os
import subprocess
import sys
from typing import NamedTuple

import control
import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.diagrams.wiring import wiring_of
from clpt_control.native import engines, first_run, solver_cache
from clpt_control.native.first_run import FirstRun, effort

TIMES = np.linspace(0.0, 20.0, 41)


class Numbers(NamedTuple):
    rate: float = 0.5
    interval: float = -1.0


def relax(t, x, u, p):
    return p.rate * (u[0] - x[0])


def halve(t, x, u, p):
    return 0.5 * x[0]


def every_third(p, t0, t1):
    k = np.arange(np.floor(t0 / 3) + 1, np.floor(t1 / 3) + 1)
    return 3.0 * k


def lag(jumping=False):
    more = {"breakpoints": every_third, "jump": halve} if jumping else {}
    return clpt.Block(
        "lag", update=relax, inputs={"u": 1}, states={"x": 1}, parameters=Numbers(), **more
    )


@pytest.fixture
def nothing_compiled(monkeypatch):
    monkeypatch.delenv(engines.VARIABLE, raising=False)
    monkeypatch.setattr(engines, "ready", lambda: False)
    monkeypatch.setattr(FirstRun, "done", 0.0)


def ran(diagram, times=TIMES, inputs=1.0, **more):
    runner = engines.chosen(diagram, name="it")
    assert isinstance(runner, FirstRun)
    return runner, runner.run([0.0], times, inputs=inputs, **more)


@pytest.mark.usefixtures("nothing_compiled")
def test_a_step_response_runs_in_python_and_is_right():
    _, solution = ran(clpt.connect([lag()], external=["u"]))
    assert solution.engine == "python"
    np.testing.assert_allclose(solution.x[:, 0], 1.0 - np.exp(-0.5 * TIMES), atol=1e-8)
    response = clpt.simulate(clpt.connect([lag()], external=["u"]), TIMES, 1.0)
    np.testing.assert_array_equal(response.states[:, 0], solution.x[:, 0])


@pytest.mark.usefixtures("nothing_compiled")
def test_a_long_run_is_begun_anew_as_machine_code(monkeypatch):
    diagram = clpt.connect([lag(jumping=True)], external=["u"])
    u = np.sin(TIMES)
    native = clpt.native.compile(diagram)
    wanted = native.run([0.0], TIMES, inputs=[u])
    monkeypatch.setattr(first_run, "WORTH", 20_000.0)
    reached = []
    runner, found = ran(diagram, inputs=[u], progress=reached.append)
    assert found.engine == wanted.engine == "native"
    np.testing.assert_array_equal(found.x, wanted.x)
    np.testing.assert_array_equal(runner.signals(found, [u]), native.signals(wanted, [u]))
    assert reached[-1] == TIMES[-1]
    again = runner.run([0.0], TIMES, inputs=[u])
    np.testing.assert_array_equal(again.x, wanted.x)


@pytest.mark.usefixtures("nothing_compiled")
def test_both_engines_agree_over_jumps(monkeypatch):
    diagram = clpt.connect([lag(jumping=True)], external=["u"])
    found = {}
    for worth in (1e12, 1e3):
        monkeypatch.setattr(first_run, "WORTH", worth)
        _, solution = ran(diagram)
        found[solution.engine] = solution.x
    np.testing.assert_allclose(found["native"], found["python"], rtol=1e-7, atol=1e-9)


@pytest.mark.usefixtures("nothing_compiled")
def test_work_of_earlier_runs_counts(monkeypatch):
    monkeypatch.setattr(first_run, "WORTH", 300_000.0)
    diagram = clpt.connect([lag()], external=["u"])
    ran_by = [ran(diagram)[1].engine for _ in range(40)]
    first = ran_by.index("native")
    assert first > 0
    assert ran_by == ["python"] * first + ["native"] * (40 - first)
    FirstRun.done = 0.0
    assert [ran(diagram)[1].engine for _ in range(40)] == ran_by  # counted, not timed


@pytest.mark.usefixtures("nothing_compiled")
def test_many_samples_are_work_as_well():
    cost = effort(wiring_of(clpt.connect([lag()], external=["u"])))
    times = np.linspace(0.0, 1.0, int(first_run.WORTH / cost) + 2)
    runner = engines.chosen(clpt.connect([lag()], external=["u"]))
    runner._sampling = 0.0
    with pytest.raises(first_run._Pays):
        runner._compile_if(cost * len(times))


@pytest.mark.usefixtures("nothing_compiled")
def test_what_is_asked_for_is_obeyed(monkeypatch):
    scenario = clpt.paper_scenario().with_values({"run.duration": 2})
    assert clpt.simulate(scenario).attrs["engine"] == "python"
    assert clpt.simulate(scenario, engine="native").attrs["engine"] == "native"
    monkeypatch.setenv(engines.VARIABLE, "native")
    assert clpt.simulate(scenario).attrs["engine"] == "native"
    monkeypatch.setenv(engines.VARIABLE, "python")
    assert clpt.simulate(scenario).attrs["engine"] == "python"


@pytest.mark.usefixtures("nothing_compiled")
def test_what_cannot_be_compiled_goes_on_in_python(monkeypatch):
    def system(t, x, u, params):
        return -0.5 * x

    other = control.nlsys(system, states=["s"], outputs=["s"], inputs=0, name="other", dt=0)
    monkeypatch.setattr(first_run, "WORTH", 1e3)
    with pytest.warns(UserWarning, match="other runs in Python, not as machine code"):
        response = clpt.simulate(other, TIMES, initial_state=[1.0])
    np.testing.assert_allclose(response.states[:, 0], np.exp(-0.5 * TIMES), atol=1e-8)


def test_the_line_is_said_once_where_nothing_is_kept(monkeypatch, capsys):
    monkeypatch.setattr(solver_cache, "kept", lambda name: None)
    monkeypatch.setattr(solver_cache, "keep", lambda name, code: None)
    monkeypatch.setattr(solver_cache, "loaded", lambda code: None)
    monkeypatch.setattr(solver_cache, "_compiled", lambda name, arguments: b"")
    solver_cache._say.cache_clear()
    for name in ("advance", "signals_at"):
        entry = solver_cache.Entry(name)
        assert not entry.ready
        with pytest.raises(AttributeError):  # there is nothing to be loaded
            entry(1)
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("clpt: compiling once for every kind of diagram")
    assert said.err.count("\n") == 1


FRESH = """
import sys
import clpt_control as clpt
scenario = clpt.paper_scenario().with_values({"run.duration": 5})
print(clpt.simulate(scenario).attrs["engine"], "numba" in sys.modules)
"""


def test_a_new_user_waits_for_no_compiler(tmp_path):
    environment = {**os.environ, "CLPT_CONTROL_CACHE": str(tmp_path / "cache")}
    environment.pop(engines.VARIABLE, None)
    done = subprocess.run(
        [sys.executable, "-c", FRESH], capture_output=True, text=True, env=environment
    )
    assert (done.stdout, done.stderr) == ("python False\n", "")
    assert not list(tmp_path.rglob("*.o"))
