"""The runs over kinks once more, by SciPy's DOP853 on the compiled rates and switching conditions.

SciPy chooses the steps, finds the events and interpolates.  Only the diagram's functions are those
of the package, so an error of the solver would show as a difference.
"""

import ctypes

import numpy as np
import pytest
from engine_runs import compile
from scipy.integrate import solve_ivp
from test_event_location import ATOL, FORMS, RTOL, T, case_of, run, system

LONGEST = 0.02  # step: SciPy looks for events at the ends of steps only
NUDGE = 1e-11  # time by which a run goes on behind an event, to decide anew there
SIGNATURE = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 6)
FUNCTIONS = ("prepare", "decide", "derivative")


class CompiledRates:
    """The rates of a compiled system, with decisions that are held."""

    def __init__(self, diagram):
        self.native = native = compile(diagram)
        program = native.code.program
        self.count = program.decided
        self.held = slice(native.decided_at, native.decided_at + self.count)
        self.time = np.zeros(1)
        self.x = np.zeros(native.nstates)
        self.P = np.zeros(program.parameters + 1)
        parameters = native.parameters()
        self.P[: len(parameters)] = parameters
        self.D = np.zeros(max(native.nstates, 3 * self.count))
        tables = np.concatenate([native.layout.T, program.tables, [0.0]])
        signals = np.zeros(program.room + 1)
        self.arrays = self.time, self.x, self.P, tables, signals, self.D
        addresses = native.code.addresses(FUNCTIONS, 1)
        self.functions = {
            name: SIGNATURE(int(address))
            for name, address in zip(FUNCTIONS, addresses, strict=True)
        }

    def call(self, name, t, x):
        """Return the results of a function."""
        self.time[0] = t
        self.x[:] = x
        self.functions[name](*(array.ctypes.data for array in self.arrays))
        return self.D

    def hold(self, t, x):
        """Hold the decisions of a time and state; return whether they changed."""
        before = self.P[self.held].copy()
        self.call("prepare", t, x)
        self.P[self.held] = self.call("decide", t, x)[: self.count]
        self.call("prepare", t, x)
        return not np.array_equal(before, self.P[self.held])

    def rates(self, t, x):
        """Return dx/dt with the decisions that are held."""
        return self.call("derivative", t, x)[: len(x)].copy()

    def distance(self, t, x):
        """Return the least distance of a decision from its change."""
        return self.call("decide", t, x)[self.count : 2 * self.count].min()


def by_scipy(diagram, x, times):
    """Return the states at the times, and the number of events."""
    compiled = CompiledRates(diagram)
    assert compiled.count > 0

    def event(t, x):
        return compiled.distance(t, x)

    event.terminal = True
    event.direction = -1.0
    states = np.full((len(times), len(x)), np.nan)
    t, end, events = times[0], times[-1], 0
    done = -np.inf
    compiled.hold(t, x)
    while t < end:
        found = solve_ivp(
            compiled.rates,
            (t, end),
            x,
            method="DOP853",
            rtol=RTOL,
            atol=ATOL,
            max_step=LONGEST,
            events=event,
            dense_output=True,
        )
        assert found.success
        t, x = found.t[-1], found.y[:, -1]
        within = (done < times) & (times <= t)
        if within.any():
            states[within] = found.sol(times[within]).T
        done = t
        if found.status == 1:
            events += 1
            t, x = behind_event(compiled, t, x)
    return states, events


def behind_event(compiled, t, x):
    """Return a time right behind an event and the state there, and hold its decisions."""
    step = NUDGE
    while True:
        behind = x + step * compiled.rates(t, x)
        if compiled.hold(t + step, behind):
            return t + step, behind
        step *= 2.0
        assert step < 1e-8


@pytest.mark.parametrize("case", FORMS)
def test_scipy_finds_the_closed_form_and_the_run(case):
    rates, x0, wanted = case_of(case)
    states, events = by_scipy(system(rates, len(x0)), np.array(x0), T)
    np.testing.assert_allclose(states[:, -1], wanted(T), rtol=1e-9, atol=1e-9)
    found = run(rates, x0)
    np.testing.assert_allclose(found.states, states, rtol=1e-9, atol=2e-9)
    # events without effect on the rates are passed
    assert found.attrs["solver_restarts"] - 1 <= events + 1
