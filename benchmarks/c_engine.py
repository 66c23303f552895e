"""The C programs as engines: DOP853 in numbers and in SIMD lanes."""

import ctypes
from ctypes import POINTER, c_double, c_int64

import numpy as np

from .build import library
from .cases import Case, flat_parameters
from .cases import initial_state as start


class _Problem(ctypes.Structure):
    _fields_ = (
        *((name, c_int64) for name in ("n", "waypoints", "recorded")),
        *((name, c_double) for name in ("dwell", "end", "rtol", "atol")),
        ("w1", POINTER(c_double)),
        ("w2", POINTER(c_double)),
    )


class _Counts(ctypes.Structure):
    _fields_ = tuple((name, c_int64) for name in ("steps", "rejected", "evaluations", "status"))


def _pointer(array: np.ndarray):
    return array.ctypes.data_as(POINTER(c_double))


class Program:
    """A compiled closed loop.

    Parameters
    ----------
    N : int
        Number of basis functions.
    source : str, optional
        ``"scalar"`` or ``"lanes"``.
    *options : str
        Flags of the variant: ``"-DCANCEL"``, ``"-DSHARE_TIDE"``.
    constant : bool, optional
        Whether N is known to the compiler.
    """

    def __init__(self, N: int, source: str = "scalar", *options: str, constant: bool = True):
        flags = (*options, f"-DN={N}") if constant else options
        self.function = getattr(ctypes.CDLL(str(library(source, *flags))), f"{source}_members")
        self.function.restype = c_double
        self.function.argtypes = (
            POINTER(_Problem),
            c_int64,
            *[POINTER(c_double)] * 3,
            POINTER(_Counts),
        )
        self.counts = _Counts()

    def members(
        self, scenario, parameters: np.ndarray, states: np.ndarray, record: int = 0
    ) -> tuple[np.ndarray, float]:
        """Run members; give the final states, or those of member 0 at the waypoint ends.

        Parameters
        ----------
        scenario : Scenario
            Waypoints, duration and tolerances.
        parameters, states : ndarray
            One row per member.
        record : int, optional
            Number of waypoint ends to record of member 0.

        Returns
        -------
        states : ndarray
            Final, shape (members, 2 N + 8), or recorded.
        seconds : float
            As the program measured them.
        """
        w1, w2 = np.ascontiguousarray(scenario.waypoints.T)
        run = scenario.run
        problem = _Problem(
            scenario.basis.N,
            len(w1),
            record,
            scenario.reference.dwell,
            run.duration,
            run.rtol,
            run.atol,
            _pointer(w1),
            _pointer(w2),
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
        """Run one case; states at its times, and seconds."""
        x0 = start(case.scenario)
        states, seconds = self.members(
            case.scenario, flat_parameters(case.scenario)[None], x0[None], len(case.times) - 1
        )
        return np.vstack([x0, states]), seconds
