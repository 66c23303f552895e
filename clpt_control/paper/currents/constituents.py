"""Constituents of a tide at a time and a place.

With nodal factor f, nodal angle u and astronomical argument V, through UTide,

    tide(t) = f(t) A cos(V(t) + u(t) - g)

A is the amplitude and g the Greenwich phase, both constants of the place; f
and u change slowly with the moon's nodes (18.6 years) and V with the clock.  The
formula is that of D. L. Codiga, "Unified tidal analysis and prediction using
the UTide Matlab functions", URI/GSO technical report 2011-01, section II; the
numbers come from UTide's tables.  So a fit of one month holds in another year:
A and g stay, f, u and V are taken anew.  Angles are in degrees.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...base.arguments import brief
from ...base.errors import DataError, ScenarioError, import_optional

OTHER_NAMES = {"M1": "NO1"}  # Schureman's name and UTide's, where they differ
DAYS_TO_1970 = 719163  # of the proleptic calendar whose first day is 0001-01-01
# the series of the moon's and the sun's longitudes hold well there
YEARS = (1700, 2200)


def utide_names(constituents: Sequence[str]) -> list[str]:
    """Return UTide's names of constituents, which may be those of `tidal_periods.SPEEDS`."""
    names_of_utide = import_optional("utide").constit_index_dict
    names = [OTHER_NAMES.get(name, name) for name in constituents]
    for name in names:
        if name not in names_of_utide or name == "Z0":
            raise ScenarioError(
                f"unknown constituent '{name}': must be one of UTide's, such as M2"
            )
    return names


def nodal_corrections(
    constituents: Sequence[str], time: Any, latitude: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return f, u and V of constituents at times in UTC: a row for each time, in degrees.

    The latitude is in degrees north; within 5 degrees of the equator, 5 is used.

    >>> f, u, V = nodal_corrections(["M2"], ["2024-06-01"], 41.0)
    >>> f.round(3), u.round(1)
    (array([[0.965]]), array([[-0.6]]))
    """
    names = utide_names(constituents)
    utide = import_optional("utide")
    indices = np.array([utide.constit_index_dict[name] for name in names])
    days = checked_times(time).astype(float) / 86400e3 + DAYS_TO_1970
    exact = [False] * 4  # nodal corrections and arguments at each time, none linearized
    f, u, V = utide.harmonics.FUV(
        days, days[0], indices, checked_latitude(latitude), exact
    )
    return f, (360.0 * u + 180.0) % 360.0 - 180.0, 360.0 * V % 360.0


def checked_times(time: Any) -> np.ndarray:
    """Return times as datetime64[ms], of the years that are allowed."""
    try:
        times = np.atleast_1d(np.asarray(time, dtype="datetime64[ms]"))
    except (ValueError, TypeError, OverflowError):
        raise DataError(
            f"time = {brief(time)}: must be such as 2019-01-01T06:00"
        ) from None
    low, high = (np.datetime64(f"{year}-01-01") for year in YEARS)
    wrong = ~((times >= low) & (times < high))
    if times.size == 0 or wrong.any():
        example = times[wrong][0] if times.size else "none"
        raise DataError(
            f"time = {example}: must be from the year {YEARS[0]} to {YEARS[1]}"
        )
    return times


def checked_latitude(latitude: float) -> float:
    """Return a latitude in degrees north as UTide takes it: not 0, by which it would divide."""
    if not (np.isfinite(latitude) and -90 <= latitude <= 90):
        raise DataError(f"latitude = {latitude}: must be degrees north, from -90 to 90")
    return float(latitude) or 1e-9


def check_increasing(times: np.ndarray, where: str) -> None:
    """Refuse times, datetime64, at the first that does not increase."""
    late = np.flatnonzero(np.diff(times) <= np.timedelta64(0, "ms"))
    if len(late):
        before, after = times[late[0] :][:2]
        raise DataError(
            f"{where}: {after} follows {before}; times must increase, each once"
        )
