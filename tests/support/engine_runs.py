"""The engines that are compared, and runs side by side."""

from functools import partial

import numpy as np

from clpt_control.engine.methods.table import EXPLICIT, RK4
from clpt_control.engine.solver.batch import Batch
from clpt_control.engine.solver.native_diagram import NativeDiagram
from clpt_control.engine.solver.runner import PythonDiagram

ENGINES = {
    "python": PythonDiagram,
    "unrolled": partial(NativeDiagram, form="unrolled"),
    "looped": partial(NativeDiagram, form="looped"),
}


def side_by_side(
    runner, lanes, starts, times, step=None, P=None, schedules=None, rtol=1e-8
):
    """Return a batch of runs that has ended; of one start all have the runner's own parameters."""
    P = np.tile(runner.parameters(), (len(starts), 1)) if P is None else P
    callee = runner.callee(lanes, None, EXPLICIT if step is None else RK4)
    group = np.arange(len(starts)) if schedules else None
    pieces = schedules or [runner.schedule((times[0], times[-1]))]
    batch = Batch(
        callee, starts, P, times, pieces, group, np.inf if step is None else step
    )
    batch.adaptive(rtol, 0.01 * rtol)
    return batch
