"""A stiff run in Python by SciPy's LSODA, if nothing happens in it: no guard, jump or bend.

An evaluation costs most in Python, and Rodas5P takes 1.5 to 6 times as many.  LSODA integrates with
`SHARE` of the tolerances: its error is then as small.  Where it fails, or meets a rate that is not
finite, the run is left to Rodas5P.
"""

import threading
import warnings
from typing import Any

import numpy as np
from numpy import ndarray
from scipy.integrate import solve_ivp

from ...base.progress.interrupt import check
from ..methods import RODAS5P
from .batch import LATE_LOOK, OUT_OF_REACH, Batch, End
from .solver_layout import EVALUATIONS, MAX_STEP, TIME, Status

LSODA = RODAS5P._replace(name="LSODA")
SHARE = 1 / 30  # of the tolerances
TIMES = 5  # of a step of DOP853 at which it evaluates rates, for one of LSODA
LEAST_RTOL = 2.3e-14  # SciPy allows no smaller one
_lock = threading.RLock()  # not every SciPy runs two of them at once


class LsodaBatch(Batch):
    """A batch of one run in Python that LSODA integrates."""

    is_running = False  # in the thread with the lock: a model may simulate another one

    def finish(self, options: Any, most: int = 0, implicit: Any = None) -> None:
        """Run to the end, or leave the run to another method."""
        self.is_small = False  # not kept for runs by other methods
        times, counts = self.times, self.counts[0]
        code, P = self.callee.code, self.memory.P

        def rates(t: float, x: ndarray) -> ndarray:
            check()
            counts[EVALUATIONS] += 1
            found = code.derivative(code.at(t, x, P), P)
            count, advance = counts[EVALUATIONS], t - times[0]
            is_slow = count * (times[-1] - t) > OUT_OF_REACH * advance
            if (count > LATE_LOOK and is_slow) or not np.isfinite(found).all():
                raise ArithmeticError
            return found

        with _lock, warnings.catch_warnings():
            warnings.filterwarnings("ignore", "lsoda")
            was_running, LsodaBatch.is_running = LsodaBatch.is_running, True
            try:
                if was_running:
                    raise ArithmeticError
                found = solve_ivp(
                    rates,
                    (times[0], times[-1]),
                    self.out[0, 0],
                    "LSODA",
                    times,
                    rtol=max(SHARE * options.rtol, LEAST_RTOL),
                    atol=SHARE * options.atol,
                    max_step=self.lane[MAX_STEP, 0] / TIMES,
                )
                self.out[0] = found.y.T
            except (ArithmeticError, ValueError):  # it stopped before the end
                self.status[0], self.reached[0] = Status.STIFF, 1
                self.ends[0] = End(times[0], self.out[0, 0].copy())
                return
            finally:
                LsodaBatch.is_running = was_running
        self.status[0], self.reached[0] = Status.FINISHED, len(times)
        self.lane[TIME] = times[-1]
        if options.progress is not None:
            options.progress(self.now)
