"""Report of the excitation of a track, for `clpt excitation`.

The report has Definition 3.1 over one window, the exact contraction of V of Eq. (24) and its
guaranteed drop, for one trajectory.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from ...base.errors import ScenarioError
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.team import Team
from .certificates import certificate, time_to_tenth
from .gramian import NOT_LEARNABLE, Excitation, gramian
from .regressor import AnySource, joint_regressor, system_of

if TYPE_CHECKING:
    import xarray

MAX_CHANGE = 0.1  # of an eigenvalue, up to which it estimates the error
CERTIFIED = ("rho", "contraction", "drop", "disturbed")


def excitation_report(
    source: AnySource, window: float | None = None, start: float | None = None
) -> dict[str, Any]:
    """Return the excitation of a scenario's run, a team's or a recorded one over one window.

    Its entries are ``window``, ``start``, ``time_unit``, ``trajectory``, ``not_learnable``
    (sentences), and by axis ``eigenvalues`` (ascending), ``ceilings`` (of the smallest
    eigenvalue), ``least_excited`` and ``dimension`` (of the identifiable subspace).

    ``rho`` (guaranteed drop of V), ``contraction`` (exact V(t+T)/V(t) at worst), ``drop``
    (1 - contraction, with all its digits) and ``time_to_tenth`` (time in which sqrt(V) falls to
    a tenth in windows like this one, or None) exclude the effect of a disturbance if
    ``disturbed``.  All are None if the window cannot be certified; ``not_certified`` is the reason.

    A recorded run has an ``accuracy``: the largest relative change of an eigenvalue if every
    second sample is left out, which is above the error; None if that is more than `MAX_CHANGE`.
    A team has ``measured`` (description of the parameters), ``smallest`` (eigenvalues by name),
    and ``vehicles`` by name and ``team`` with ``eigenvalues``, ``dimension``, ``not_learnable``.
    """
    if isinstance(source, Team) or isinstance(system_of(source), Team):
        return _team_report(gramian(source, window, start))
    regressor = joint_regressor(source, window, start)
    excitation = gramian(regressor)
    report: dict[str, Any] = excitation.report
    report |= dict.fromkeys((*CERTIFIED, "time_to_tenth"))
    try:
        certified = certificate(regressor)
        report |= {name: getattr(certified, name) for name in CERTIFIED}
        time = time_to_tenth(excitation.window, min(certified.drop, 1.0))
        report["time_to_tenth"] = time if np.isfinite(time) else None
    except ScenarioError as error:
        report["not_certified"] = str(error)
    if not isinstance(source, Scenario):
        report["accuracy"] = _accuracy(source, excitation)
    return report


def _accuracy(run: "xarray.Dataset", excitation: Excitation) -> float | None:
    """Return the relative change of the eigenvalues without every second sample."""
    last = run.sizes["time"] - 1
    thin = run.isel(time=np.unique([*range(0, last, 2), last]))
    thin.encoding.update(run.encoding)
    coarse = gramian(thin, excitation.window, excitation.start).eigenvalues
    changes = [
        np.abs(coarse[axis] - values) / np.maximum(values, NOT_LEARNABLE * values[-1])
        for axis, values in excitation.eigenvalues.items()
    ]
    change = float(np.max(changes))
    known = thin.sizes["time"] <= last and change <= MAX_CHANGE
    return change if known else None


def _team_report(excitation: Excitation) -> dict[str, Any]:
    """Return the report of a team."""
    by_name = {**excitation.vehicles, "team": excitation}
    return {
        **excitation.report,
        "measured": "the flow parameters, which all share, and each one's gains where they adapt",
        "smallest": {name: single.smallest for name, single in by_name.items()},
        "vehicles": {n: single.report for n, single in excitation.vehicles.items()},
        "team": excitation.report,
    }
