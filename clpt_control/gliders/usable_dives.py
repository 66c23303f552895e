"""Dives that can be used, and why the others cannot (`dive_faults`, `dive_order`)."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from .dive_faults import fault_of
from .dive_order import ANOTHER, NEAR, by_time, overlap, too_far
from .dives import Dive, Skipped

LEAST_DURATION = 4000.0  # s


def usable(
    dives: Iterable[Dive], least_duration: float = LEAST_DURATION
) -> tuple[list[Dive], list[Skipped]]:
    """Sort dives by time and leave out those that cannot be used.

    A dive is used when it has both fixes in their order and in the years 1970
    to 2200, finite dead reckoning, lasts longer than `least_duration`, needs no
    speed above 5 m/s, does not overlap one that ended before it, and starts where
    a vehicle can have got to from the end of the used dive before.  Where the
    latter is not so for two dives running that follow one another, the fix of the
    used one is taken as wrong: the first of the two stays left out, and dives
    are used from the second on.  Whether a dive is used depends on earlier ends
    only, so a later dive never changes it.

    Parameters
    ----------
    dives : iterable of Dive
        In any order.
    least_duration : float
        Longest duration that is too short, s.

    Returns
    -------
    used : list of Dive
        By time; gaps in the numbers and a changed order stand in `notes`.
    skipped : list of Skipped
        The others, each with its reason.

    Examples
    --------
    >>> from clpt_control.gliders.dives import make_dive
    >>> fixes = (0.0, -43.0, 8.0), (9000.0, -43.0, 8.01)
    >>> dives = [make_dive(7, *fixes, (500.0, 0.0)), make_dive(8, *fixes, (float("nan"), 0.0))]
    >>> used, skipped = usable(dives)
    >>> [dive.number for dive in used], skipped[0].dive, skipped[0].why
    ([7], 8, 'the displacement through the water is not finite')
    """
    fit, skipped, latest = [], [], -np.inf
    for dive in dives:
        why = fault_of(dive, least_duration)
        if why:
            skipped.append(Skipped(dive.number, "; ".join((why, *dive.notes))))
            continue
        if dive.t_gpse < latest:
            dive = _noted(dive, "came after a later dive, sorted by time")
        latest = max(latest, dive.t_gpse)
        fit.append(dive)
    used: list[Dive] = []
    stray: Dive | None = None  # the last one, if it starts too far from the used one
    for dive in sorted(fit, key=by_time):
        before = used[-1] if used else None
        if before is None:
            used.append(dive)
            continue
        why = overlap(dive, before)
        if why:
            skipped.append(Skipped(dive.number, why))
            continue
        why = too_far(dive, before)
        if why and (stray is None or overlap(dive, stray) or too_far(dive, stray)):
            skipped.append(Skipped(dive.number, f"{why}; {ANOTHER}"))
            stray = dive
            continue
        if why and stray is not None:
            dive = _noted(dive, f"{why}, but follows dive {stray.number}, which was left out: used")
        elif odd := too_far(dive, before, NEAR):
            dive = _noted(dive, odd)
        stray = None
        missing = dive.number - before.number - 1
        if missing > 0:
            dive = _noted(dive, f"{missing} dive(s) missing after dive {before.number}")
        used.append(dive)
    return used, skipped


def _noted(dive: Dive, note: str) -> Dive:
    return dive if note in dive.notes else replace(dive, notes=(*dive.notes, note))
