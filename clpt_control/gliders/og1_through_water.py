"""Displacement through the water of an OG1 dive: of whatever the file has.

The displacement dr through the water is the first that the file allows of

1. displacements (m since the sample before): dr = sum_i d_i;
2. the flight model's horizontal speed s and the heading h from true north, or
   from magnetic north where the variation is in the file:
   d_i = s_i (t_i - t_{i-1}) (sin h_i, cos h_i);
3. the file's depth-averaged current c:
   dr = (displacement between the fixes) - c (t_E - t_2);
4. as 2 with a magnetic heading, turned by IGRF's variation in the middle of the dive
   (`magnetic`), or a heading of which the file does not say from which north, taken as true.

The dive's notes say which it was where it was not the first.
"""

from math import isfinite, nan
from typing import NamedTuple

import numpy as np

from ..estimation.dive import Track
from ..geodesy import displacement
from .dives import Fix
from .magnetic import LAST, variation
from .og1_columns import Columns
from .samples import hole_under_water, track_of


class ThroughWater(NamedTuple):
    """Displacement east and north (m), NaN where the file has none, its track, notes."""

    total: tuple[float, float]
    track: Track | None
    notes: list[str]
    turned: float | None = None  # by which a magnetic heading was turned, degrees east


def through_water(
    columns: Columns,
    rows: np.ndarray,
    start: Fix,
    end: Fix,
    current: tuple[float | None, float | None],
) -> ThroughWater:
    """Return the displacement through the water of one dive from its rows, by time."""
    of = columns.of
    duration = end[0] - start[0]
    found = _summed(of, rows, (of["east"], of["north"]), start[0], duration)
    if found is not None:
        if columns.steps.upper().endswith("_GSM"):
            found.notes.append(f"dead reckoning of the glide-slope model ({columns.steps})")
        return found
    sure = columns.north == "true" or bool(np.isfinite(of["magvar"][rows]).any())
    found = _along_heading(columns, rows, start, end) if sure else None
    u, v = current
    if found is None and u is not None and v is not None:
        east, north = displacement(*start[1:], *end[1:])
        total = east - u * duration, north - v * duration
        note = "dead reckoning computed from the file's depth-averaged current"
        return ThroughWater(total, None, [note])
    found = found or _along_heading(columns, rows, start, end)
    if found is None:
        lacking = (
            "no EAST_DISPLACEMENT, NORTH_DISPLACEMENT, no speed and heading, no depth-averaged "
            "current"
        )
        return ThroughWater((nan, nan), None, [lacking])
    return found


def _along_heading(columns: Columns, rows: np.ndarray, start: Fix, end: Fix) -> ThroughWater | None:
    """Return what speed and heading come to; None where a dive has neither."""
    of = columns.of
    turned, said = _turned(columns, rows, start, end)
    found = _summed(of, rows, _flown(of, rows, turned or 0.0), start[0], end[0] - start[0])
    if found is None or not isfinite(found.total[0]):
        return found
    found.notes.append(f"dead reckoning of the flight model's speed and the heading, {said}")
    return found._replace(turned=turned)


def _turned(columns: Columns, rows: np.ndarray, start: Fix, end: Fix) -> tuple[float | None, str]:
    """Return the variation that turns a dive's heading (degrees east), None if true; in words."""
    if columns.north == "true":
        return None, "true"
    own = columns.of["magvar"][rows]
    if np.isfinite(own).any():
        found = float(np.median(own[np.isfinite(own)]))
        north = columns.north or "of a north that the file does not name"
        return found, f"{north}, turned by the file's variation of {found:g} degrees"
    if not columns.north:
        return 0.0, ("of a north that the file does not name, taken as true (--variation turns it)")
    found = float(variation(0.5 * (start[0] + end[0]), *start[1:])[0])
    if not isfinite(found):
        return 0.0, f"magnetic, taken as true: IGRF ends in {LAST} (--variation turns it)"
    return found, (
        f"magnetic, turned by IGRF's variation of {found:.0f} degrees (--variation gives another)"
    )


def _flown(
    of: dict[str, np.ndarray], rows: np.ndarray, variation: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return steps of speed and heading, m; NaN where a row has none.

    A row with a heading and no speed is a stall of the flight model: no step.
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
) -> ThroughWater | None:
    """Sum the steps of a dive; None where it has none."""
    rows = rows[np.all([np.isfinite(a[rows]) for a in (of["time"], *steps)], axis=0)]
    if not rows.size:
        return None
    since, notes = of["time"][rows] - start, []
    again = np.diff(since, prepend=-1.0) == 0
    if again.any() and np.any([step[rows][again] != 0 for step in steps]):
        notes.append(f"{again.sum()} samples have the time of the one before, left out")
    rows, since = rows[~again], since[~again]
    east, north = (step[rows] for step in steps)
    total = float(np.sum(east)), float(np.sum(north))
    if np.any(np.diff(since) <= 0) or since[0] < 0:
        return ThroughWater(total, None, [*notes, "no track: the times are not in order"])
    hole = hole_under_water(since, of["depth"][rows], duration)
    if hole:
        return ThroughWater((nan, nan), None, [*notes, hole])
    return ThroughWater(total, track_of(since, east, north, duration), notes)
