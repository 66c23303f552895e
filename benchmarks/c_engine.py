"""The C programs as engines: DOP853 in numbers and in SIMD lanes."""

import ctypes
from ctypes import POINTER, c_double, c_int64

import numpy as np

from .build import library
from .cases import Case, flat_parameters
from .cases import initial_state as start


class _Problem(ctypes.Structure):
    _fields_ = (
        *((name, c_int64) for name in ("waypoints", "recorded")),
        *((name, c_double) for name in ("dwell", "end", "rtol", "atol")),
        ("w1", POINTER(c_double)),
        ("w2", POINTER(c_double)),
    )


class _Counts(ctypes.Structure):
    _fields_ = tuple(
        (name, c_int64) for name in ("steps", "rejected", "evaluations", "status")
    )


def _pointer(array: np.ndarray):
    return array.ctypes.data_as(POINTER(c_double))


class Program:
    """A closed loop of N basis functions, compiled from ``"scalar"`` or ``"lanes"``."""

    def __init__(self, N: int, source: str = "scalar", *options: str):
        compiled = ctypes.CDLL(str(library(source, f"-DN={N}", *options)))
        self.function = getattr(compiled, f"{source}_members")
        self.function.restype = c_double
        arrays = [POINTER(c_double)] * 3
        self.function.argtypes = (POINTER(_Problem), c_int64, *arrays, POINTER(_Counts))
        self.counts = _Counts()

    def members(
        self, scenario, parameters: np.ndarray, states: np.ndarray, record: int = 0
    ) -> tuple[np.ndarray, float]:
        """Run members, a row each; return the final states and the program's seconds.

        Instead of the final states, those of member 0 at the first `record` waypoint ends.
        """
        w1, w2 = np.ascontiguousarray(scenario.waypoints.T)
        run, dwell = scenario.run, scenario.reference.dwell
        points = _pointer(w1), _pointer(w2)
        problem = _Problem(
            len(w1), record, dwell, run.duration, run.rtol, run.atol, *points
        )
        states = np.array(states, dtype=float, order="C")
        parameters = np.ascontiguousarray(parameters)
        kept = np.empty((max(record, 1), states.shape[1]))
        self.counts = _Counts()
        seconds = self.function(
            ctypes.byref(problem),
            len(states),
            _pointer(parameters),
            _pointer(states),
            _pointer(kept),
            ctypes.byref(self.counts),
        )
        if self.counts.status:
            raise RuntimeError("the C program's step became too small")
        return (kept if record else states), seconds

    def run(self, case: Case) -> tuple[np.ndarray, float]:
        """Run one case; return states at its times, and seconds."""
        x0, own = start(case.scenario), flat_parameters(case.scenario)
        states, seconds = self.members(
            case.scenario, own[None], x0[None], len(case.times) - 1
        )
        return np.vstack([x0, states]), seconds


def prepare(case: Case):
    """Prepare one run."""
    program = Program(case.N)
    return lambda: program.run(case)


def members(scenario):
    """Prepare an ensemble, one run after the other."""
    program = Program(scenario.basis.N)
    return lambda parameters, states: program.members(scenario, parameters, states)


def prepare_in_lanes(case: Case):
    """Prepare one run, eight basis functions at once."""
    program = Program(case.N, "scalar", "-DBASIS_LANES")
    return lambda: program.run(case)


def members_in_lanes(scenario):
    """Prepare an ensemble, a run in each lane."""
    program = Program(scenario.basis.N, "lanes")
    return lambda parameters, states: program.members(scenario, parameters, states)
