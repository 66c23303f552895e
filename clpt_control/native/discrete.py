"""Diagrams of discrete time step by step, and what sampled parts hold where a run begins.

    x[k+1] = derivative(t_k, x[k], u_k),    signals of sample k from x[k]

The times are those that python-control takes: `dt` apart, or evenly spaced where dt is True.
"""

from collections.abc import Callable
from ctypes import CFUNCTYPE, c_void_p
from typing import Any

import numpy as np

from ..errors import SimulationError
from ..progress.interrupt import check
from . import solver
from .batch import Callee
from .ending import Solution
from .inputs import Inputs
from .schedule import Schedule

TOGETHER = 4096  # steps of a call


def check_spacing(times: np.ndarray, dt: Any) -> None:
    """Refuse times that are not one step of a diagram of discrete time apart."""
    apart = np.diff(times)
    if not np.allclose(apart, apart[0] if dt is True else dt):
        every = "evenly spaced" if dt is True else f"{dt:.9g} apart"
        raise SimulationError(
            f"timepts: a diagram of discrete time (dt = {dt}) takes times that are {every}; these "
            f"are {apart.min():.9g} to {apart.max():.9g} apart"
        )


def iterated(
    runner: Any,
    start: np.ndarray,
    times: np.ndarray,
    inputs: Inputs | None,
    progress: Callable[[float], None] | None,
) -> Solution:
    """Return the states of a diagram of discrete time, ready to run, at its times."""
    check_spacing(times, runner.wiring.dt)
    pieces = runner.schedule(float(times[0]), float(times[-1]), inputs)
    callee, P = runner.callee(1, inputs), runner.parameters()
    x = np.concatenate([start[None], np.zeros((len(times) - 1, len(start)))])
    for first in range(0, len(times) - 1, TOGETHER):
        check()
        last = min(first + TOGETHER, len(times) - 1)
        x[first : last + 1] = asked(
            callee, solver.DERIVATIVE, times[first:last], x[first], pieces, P
        )
        bad = np.flatnonzero(~np.all(np.isfinite(x[first + 1 : last + 1]), axis=1))
        if len(bad):
            k = first + int(bad[0])
            t, u = float(times[k]), None if inputs is None else inputs.at(float(times[k]))
            found = runner.sweep.first_trouble(t, x[k], u) or "a state"
            raise SimulationError(
                f"the run stopped at t = {t:.9g}: {found} is not finite; check the parameters of "
                "that block"
            )
        if progress is not None:
            progress(float(times[last]))
    statistics = {"steps": len(times) - 1, "evaluations": len(times) - 1, "restarts": 0}
    made = Solution(times, x, statistics=statistics, engine=runner.engine)
    made.pieces = runner, inputs, pieces
    return made


def begun(callee: Callee, start: np.ndarray, t: float, pieces: Schedule, P: Any) -> np.ndarray:
    """Return the state with which a run begins: blocks that sample there hold what feeds them."""
    if not pieces.begins:
        return start
    return asked(callee, solver.JUMP, np.array([t]), start, pieces, P)[1]


def asked(
    callee: Callee, role: int, times: np.ndarray, x: np.ndarray, pieces: Schedule, own: np.ndarray
) -> np.ndarray:
    """Return states (nt + 1, nstates): the first, and what a function makes of each in turn."""
    n, room = len(x), np.zeros(max(callee.room, 1))
    states = np.append(x, np.zeros(len(times) * n + 1))
    t, P, T = np.zeros(1), np.append(own, 0.0), np.append(callee.tables, 0.0)
    prepare = _function(callee.functions[solver.PREPARE], t, states, P, T, room, room)
    move = _function(callee.functions[role], t, states, P, T, room, states)
    number, piece = np.searchsorted(pieces.edges, times, side="right"), -1
    with np.errstate(all="ignore"):
        for k in range(len(times)):
            t[0] = times[k]
            if number[k] != piece:
                piece = number[k]
                P[pieces.places] = pieces.values[piece]
                prepare(k * n, 0)
            move(k * n, (k + 1) * n)
    return states[:-1].reshape(len(times) + 1, n)


def _function(function: Any, *arrays: np.ndarray) -> Callable[[int, int], None]:
    """Return a function, or the one at an address, of the places of states and of what it gives."""
    t, X, P, T, W, D = arrays
    if callable(function):
        return lambda first, to: function(t, X, first, P, T, W, D, to)
    call = CFUNCTYPE(None, *[c_void_p] * 6)(int(function))
    at_t, at_X, at_P, at_T, at_W, at_D = (array.ctypes.data for array in arrays)
    size = X.itemsize
    return lambda first, to: call(at_t, at_X + size * first, at_P, at_T, at_W, at_D + size * to)
