"""What a track can teach, as one dictionary: `clpt excitation --json`.

Definition 3.1 over one window, the exact contraction of V of Eq. (24) and the guaranteed drop
of it, for one trajectory.
"""

from typing import Any

import numpy as np

from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from .certificates import certificate, time_to_error
from .gramian import gramian
from .regressor import Source, joint_regressor, thinned


def excitation_report(
    source: Source, window: float | None = None, start: float | None = None
) -> dict[str, Any]:
    """Return what a scenario's run or a recorded run can teach over one window.

    ``window``, ``start``, ``time_unit``, ``trajectory``; by axis ``eigenvalues`` (ascending),
    ``ceilings`` (of the smallest eigenvalue), ``least_excited`` and ``dimension`` (of what can be
    learned); ``not_learnable`` (sentences);
    ``rho`` (V falls by at least this share), ``contraction`` (exact V(t+T)/V(t) at worst),
    ``drop`` (1 less that, with all its digits) and ``time_to_tenth`` (of windows like this one,
    until sqrt(V) is a tenth; None: never), which are None where the window cannot be certified
    and ``not_certified`` says why.  For a recorded run ``accuracy`` is the largest relative
    change of an eigenvalue when every second sample is left out, which is above the error.
    """
    along = joint_regressor(source, window, start)
    found = gramian(along)
    report: dict[str, Any] = {
        "window": found.window,
        "start": found.start,
        "time_unit": found.time_unit,
        "trajectory": found.trajectory,
        "eigenvalues": {axis: values.tolist() for axis, values in found.eigenvalues.items()},
        "ceilings": found.ceilings,
        "least_excited": found.least_excited,
        "dimension": found.dimension,
        "not_learnable": found.not_learnable,
    }
    try:
        certified = certificate(along)
    except ScenarioError as error:
        nothing = dict.fromkeys(("rho", "contraction", "drop", "time_to_tenth"))
        report |= {**nothing, "not_certified": str(error)}
    else:
        time = time_to_error(found.window, min(certified.drop, 1.0), 1.0, 0.1)
        report |= {
            "rho": certified.rho,
            "contraction": certified.contraction,
            "drop": certified.drop,
            "time_to_tenth": time if np.isfinite(time) else None,
        }
    if not isinstance(source, Scenario):
        rough = gramian(thinned(source), found.window, found.start)
        floor = {a: found.tolerance * values[-1] for a, values in found.eigenvalues.items()}
        report["accuracy"] = max(
            float(np.max(np.abs(rough.eigenvalues[a] - values) / np.maximum(values, floor[a])))
            for a, values in found.eigenvalues.items()
        )
    return report
