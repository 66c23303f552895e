"""Way through the water between two fixes of an OG1 file.

From the best that the file has, in this order:

1. displacements (m since the sample before): dr = sum_i d_i;
2. the flight model's horizontal speed V and the heading h from true north, or
   from magnetic north where the variation is in the file:
   d_i = V_i (t_i - t_{i-1}) (sin h_i, cos h_i);
3. the file's own depth-averaged current c:
   dr = (displacement between the fixes) - c (t_E - t_2);
4. as 2 with a magnetic heading and no variation, taken as true.

The dive's notes say which it was where it was not the first.
"""

from math import nan
from typing import NamedTuple

import numpy as np

from ..geodesy import displacement
from .dives import Fix
from .og1_columns import Columns
from .samples import hole_under_water, track_of


class Way(NamedTuple):
    """Total east and north (m), the track and what was assumed."""

    total: tuple[float, float]
    track: tuple[np.ndarray, np.ndarray, np.ndarray] | None
    notes: list[str]


def way_of(
    columns: Columns,
    rows: np.ndarray,
    start: Fix,
    end: Fix,
    current: tuple[float | None, float | None],
    whole: bool = True,
) -> Way:
    """Return the way through the water of one dive.

    Parameters
    ----------
    columns : Columns
        Of the file.
    rows : ndarray of int
        Rows of the dive, by time.
    start, end : tuple of float
        Time, latitude and longitude of its fixes.
    current : tuple of float or None
        The file's own, m/s.
    whole : bool
        Whether to refuse a sum with holes under water, and to take other ways
        than displacements.

    Returns
    -------
    Way
        NaN where the file has none.
    """
    of = columns.of
    duration = end[0] - start[0]
    way = _summed(of, rows, (of["east"], of["north"]), start[0], duration, whole)
    if way is not None:
        if columns.steps.upper().endswith("_GSM"):
            way.notes.append(f"dead reckoning of the glide-slope model ({columns.steps})")
        return way
    if not whole:
        return Way((nan, nan), None, [])
    turn = of["magvar"][rows][np.isfinite(of["magvar"][rows])]
    variation = None if columns.north == "true" else float(np.median(turn)) if turn.size else None
    flown = _flown(of, rows, variation or 0.0)
    sure = columns.north == "true" or variation is not None
    if sure:
        way = _summed(of, rows, flown, start[0], duration, whole)
    if way is None and None not in current:
        gps, (u, v) = displacement(*start[1:], *end[1:]), current
        total = gps[0] - u * duration, gps[1] - v * duration  # type: ignore[operator]
        return Way(
            total, None, ["dead reckoning computed from the file's own depth-averaged current"]
        )
    if way is None and not sure:
        way = _summed(of, rows, flown, start[0], duration, whole)
    if way is None:
        lacking = "no EAST_DISPLACEMENT, NORTH_DISPLACEMENT, no speed and heading, no own current"
        return Way((nan, nan), None, [lacking])
    said = columns.north or "of a north that the file does not name"
    if variation is not None:
        said += f", turned by the file's variation of {variation:g} degrees"
    elif not sure:
        said += " and the variation not in the file, taken as true"
    way.notes.append(f"dead reckoning of the flight model's speed and the heading, {said}")
    return way


def _flown(
    of: dict[str, np.ndarray], rows: np.ndarray, variation: float
) -> tuple[np.ndarray, np.ndarray]:
    """Steps of speed and heading, m; NaN where a row has none.

    A row with a heading and no speed is a stall of the flight model: no way.
    """
    steps = np.full(of["time"].shape, nan), np.full(of["time"].shape, nan)
    own = rows[np.isfinite(of["time"][rows]) & np.isfinite(of["heading"][rows])]
    since = np.diff(of["time"][own], prepend=of["time"][own[:1]])
    heading = np.radians(of["heading"][own] + variation)
    for step, part in zip(steps, (np.sin(heading), np.cos(heading)), strict=True):
        step[own] = of["speed"][own] * since * part
    return steps


def _summed(
    of: dict[str, np.ndarray],
    rows: np.ndarray,
    steps: tuple[np.ndarray, np.ndarray],
    start: float,
    duration: float,
    whole: bool,
) -> Way | None:
    """Sum the steps of a dive; None where it has none."""
    rows = rows[np.all([np.isfinite(a[rows]) for a in (of["time"], *steps)], axis=0)]
    if not rows.size:
        return None
    since, notes = of["time"][rows] - start, []
    if whole:
        again = np.diff(since, prepend=-1.0) == 0
        if again.any() and np.any([step[rows][again] != 0 for step in steps]):
            notes.append(f"{again.sum()} samples have the time of the one before, left out")
        rows, since = rows[~again], since[~again]
    east, north = (step[rows] for step in steps)
    total = float(np.sum(east)), float(np.sum(north))
    if np.any(np.diff(since) <= 0) or since[0] < 0:
        return Way(total, None, [*notes, "no track: the times are not in order"])
    hole = hole_under_water(since, of["depth"][rows], duration) if whole else ""
    if hole:
        return Way((nan, nan), None, [*notes, hole])
    return Way(total, track_of(since, east, north, duration), notes)
