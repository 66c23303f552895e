"""What a track can teach, as one dictionary: `clpt excitation --json`.

Definition 3.1 over one window, the exact contraction of V of Eq. (24) and the
guaranteed rate, for one trajectory.
"""

from typing import Any

import numpy as np

from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from .bounds import time_to_error
from .certificates import certificate
from .gramian import excitation
from .recorded import Source, thinned
from .regressor import joint_regressor


def excitation_report(
    source: Source, window: float | None = None, start: float | None = None
) -> dict[str, Any]:
    """Report on the excitation of a scenario or a run.

    Parameters
    ----------
    source : Scenario or xarray.Dataset
        A scenario is run from its own initial values; a run is read.
    window : float, optional
        Length of the window, units.time; one cycle of the waypoints.
    start : float, optional
        Start of the window; the second cycle, or as late as fits.

    Returns
    -------
    dict
        ``window``, ``start``, ``time_unit``, ``trajectory``; ``eigenvalues``
        (ascending), ``least_excited`` and ``dimension`` (of the identifiable
        subspace) by axis; ``not_learnable`` (sentences); ``rho`` (V falls by at
        least this share), ``contraction`` (exact V(t+T)/V(t) at worst) and
        ``drop`` (1 less that, with all its digits); ``time_to_tenth`` (windows
        like this one, until sqrt(V) is a tenth; None: never); for a recorded
        run ``accuracy``, the largest relative change of an eigenvalue when every
        second sample is left out, which is above the error. Where
        the window cannot be certified rho, contraction and drop are None and
        ``not_certified`` says why.

    Raises
    ------
    ScenarioError
        If the window is not positive or does not fit into the run.
    DataError
        If the dataset is no run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> report = excitation_report(clpt.paper_scenario(), 20.0, 0.0)
    >>> report["not_learnable"]
    ['Gamma_2 is not learnable on this track']
    >>> report["rho"] <= report["drop"]
    True
    """
    along = joint_regressor(source, window, start)
    found = excitation(along)
    report: dict[str, Any] = {
        "window": found.window,
        "start": found.start,
        "time_unit": found.time_unit,
        "trajectory": found.trajectory,
        "eigenvalues": {axis: values.tolist() for axis, values in found.eigenvalues.items()},
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
        rough = excitation(thinned(source), found.window, found.start)
        floor = {a: found.tolerance * values[-1] for a, values in found.eigenvalues.items()}
        report["accuracy"] = max(
            float(np.max(np.abs(rough.eigenvalues[a] - values) / np.maximum(values, floor[a])))
            for a, values in found.eigenvalues.items()
        )
    return report
