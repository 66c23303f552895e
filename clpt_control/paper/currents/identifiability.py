"""Identifiability of tides: constituents that a record can separate.

A record must be long enough, by the Rayleigh criterion

    |w_a - w_b| T >= 360 degrees

w in degrees per hour, T in hours from the first measurement to the last: over
T the two must drift apart by one turn or more (M. G. G. Foreman, "Manual for
tidal heights analysis and prediction", Pacific Marine Science Report 77-10,
1977).  Below that, least squares still gives numbers, but the two amplitudes
trade against each other.  "steady" is the speed 0: a tide beside a mean needs
one full period.
"""

from collections.abc import Sequence
from itertools import combinations
from math import inf

import numpy as np

from ...base.arguments import public
from ...base.errors import DataError
from ...base.units import at_most
from ..scenario import tidal_periods

TURN = 360.0 * (1 - 1e-9)  # degrees; times in files are rounded
UNEVEN = 0.1  # of a step, by which a clock may be off


@public
def check_separable(names: Sequence[str], hours: float, where: str) -> None:
    """Refuse tides that a record is too short to tell apart.

    >>> check_separable(["steady", "M2", "S2"], 360.0, "currents.nc")
    >>> check_separable(["M2", "S2"], 24.0, "currents.nc")
    Traceback (most recent call last):
        ...
    clpt_control.DataError: currents.nc: in 24 h, these cannot be distinguished: M2 and S2
    (354.4 h are needed)
    """
    speeds = {name: tidal_periods.speed(name) for name in names}
    differences = sorted(
        (abs(speeds[a] - speeds[b]), a, b) for a, b in combinations(speeds, 2)
    )
    too_close = [
        (360.0 / difference if difference else inf, a, b)
        for difference, a, b in differences
        if difference * hours < TURN
    ]
    if too_close:
        pairs = ", ".join(
            f"{a} and {b} ({at_most(difference)} h are needed)"
            for difference, a, b in too_close
        )
        raise DataError(
            f"{where}: in {hours:.6g} h, these cannot be distinguished: {pairs}"
        )


def nyquist(hours: np.ndarray) -> float:
    """Return the frequency, cycles per hour, from which on a record of even steps is blind.

    A step may be left out; where steps are no multiples of one, endless: `check_sampling` judges.

    >>> [round(nyquist(np.array([0.0, 1.0, 2.0, last])), 6) for last in (5.0, 2.4)]
    [0.5, inf]
    """
    steps = np.diff(hours)
    counts = steps / np.median(steps)
    even = np.all(np.abs(counts - np.round(counts)) <= UNEVEN) and np.all(counts > 0.5)
    return 0.5 / float(np.median(steps)) * (1 - 1e-9) if even else np.inf


def check_nyquist(
    hours: np.ndarray, cycles: np.ndarray, names: Sequence[str], where: str
) -> None:
    """Refuse tides that steps are too long for: they would be seen as slower ones.

    >>> check_nyquist(6.0 * np.arange(9), np.array([1 / 12]), ["S2"], "record")
    Traceback (most recent call last):
        ...
    clpt_control.DataError: record: steps of 6 h see no tide of 12 h or faster: leave out S2
    """
    fast = [
        name
        for name, frequency in zip(names, cycles, strict=True)
        if frequency >= nyquist(hours)
    ]
    if fast:
        step = float(np.median(np.diff(hours)))
        limit = f"steps of {step:.4g} h see no tide of {2 * step:.4g} h or faster"
        raise DataError(f"{where}: {limit}: leave out {', '.join(fast)}")
