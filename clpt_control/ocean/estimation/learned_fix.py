"""Results of learning from fixes: a forecast of a fix, and what a fix taught."""

from dataclasses import dataclass
from math import hypot
from typing import NamedTuple

import numpy as np

LEVEL = 0.9  # probability of the region of a forecast
PERCENT = f"{100 * LEVEL:g} %"


class Ahead(NamedTuple):
    """A forecast of a fix.

    Attributes
    ----------
    time, latitude, longitude : float
        s since 1970 UTC, degrees.
    radius : float
        Radius of the region that contains the fix with probability `LEVEL`, m.
    """

    time: float
    latitude: float
    longitude: float
    radius: float


@dataclass(frozen=True)
class Learned:
    """Results of one fix.

    Attributes
    ----------
    time, latitude, longitude : float
        Of the fix: s since 1970 UTC, degrees.
    flow_parameters : ndarray, shape (2, N)
        Estimate of theta after the fix, m/s.
    standard_error : ndarray, shape (N,)
        Of each parameter on both axes, m/s.
    flow : tuple of float
        Learned flow at the fix, m/s to the east and to the north.
    forecast : Ahead or None
        Forecast of this fix before it was learned; None for a fix that begins a leg.
    error_east, error_north : float
        Fix less forecast, m; NaN for a fix that begins a leg.
    note : str
        A remark in plain words, or empty.
    """

    time: float
    latitude: float
    longitude: float
    flow_parameters: np.ndarray
    standard_error: np.ndarray
    flow: tuple[float, float]
    forecast: Ahead | None = None
    error_east: float = np.nan
    error_north: float = np.nan
    note: str = ""

    @property
    def error(self) -> float:
        """Length of the position error, m; NaN for a fix that begins a leg."""
        return hypot(self.error_east, self.error_north)

    @property
    def inside(self) -> bool:
        """True if the fix lies in the region of its forecast."""
        return self.forecast is not None and self.error <= self.forecast.radius
