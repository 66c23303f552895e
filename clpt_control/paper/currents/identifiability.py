"""Identifiability of tides: constituents that a record can separate, and its noise.

A record must be long enough, by the Rayleigh criterion

    |w_a - w_b| T >= 360 degrees

w in degrees per hour, T in hours from the first measurement to the last: over
T the two must drift apart by one turn or more (M. G. G. Foreman, "Manual for
tidal heights analysis and prediction", Pacific Marine Science Report 77-10,
1977).  Below that, least squares still gives numbers, but the two amplitudes
trade against each other.  "steady" is the speed 0: a tide beside a mean needs
one full period.

A record can be long enough and still be blind: a tide sampled once
a period looks like a mean.  The functions 1, cos w t, sin w t at the record's
own times say so by their condition number, which bounds how much worse than
even sampling the times make the errors.
"""

from collections.abc import Mapping, Sequence
from itertools import combinations
from math import inf

import numpy as np

from ...base.arguments import public
from ...base.errors import DataError
from ...base.units import at_most
from ..scenario import tidal_periods

TURN = 360.0 * (1 - 1e-9)  # degrees; times in files are rounded
UNEVEN = 0.1  # of a step, by which a clock may be off
WORST = 30.0  # largest condition number
# neighbours of a tide, in 1 / record length
NEAR = np.array([*range(-10, 0), *range(1, 11)])


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
    check_speeds({name: tidal_periods.speed(name) for name in names}, hours, where)


def check_speeds(speeds: Mapping[str, float], hours: float, where: str) -> None:
    """Refuse tides, degrees per hour by name, that a record is too short to tell apart."""
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


def check_sampling(
    hours: np.ndarray, cycles: np.ndarray, names: Sequence[str], where: str
) -> None:
    """Refuse times, in hours, that are too few or at which tides look alike.

    `cycles` are frequencies in cycles per hour.

    >>> check_sampling(np.arange(48.0), np.array([1 / 12]), ["S2"], "record")
    >>> check_sampling(12.0 * np.arange(48), np.array([1 / 12]), ["S2"], "record")
    Traceback (most recent call last):
        ...
    clpt_control.DataError: record: at its times the mean and S2 look alike. Take other
    intervals or leave one out
    """
    count = 2 * len(cycles) + 1
    if len(hours) < 2 * count:
        requirement = f"at least {2 * count} are needed"
        raise DataError(
            f"{where}: {len(hours)} measurements for {count} numbers to fit; {requirement}"
        )
    wave = np.exp(2j * np.pi * np.outer(hours - hours.mean(), cycles))
    functions = np.hstack([np.full((len(hours), 1), 0.5**0.5), wave.real, wave.imag])
    if np.linalg.cond(functions) > WORST:
        functions_text = f"the mean and {', '.join(names)} look alike"
        raise DataError(
            f"{where}: at its times {functions_text}. Take other intervals or leave one out"
        )


def noise_ratio(
    residual: np.ndarray, hours: np.ndarray, cycles: np.ndarray, k: int
) -> np.ndarray:
    """Return sqrt(power / mean power) of a residual near a tide: of both, of east, of north.

    The power is that of the 20 neighbouring frequencies, those of other tides left out; a ratio
    below 1 counts as 1.  The residual is east + i north, hours begin at 0, `cycles` are
    frequencies of all tides in cycles per hour, of which the tide has the index k.

    >>> noise = np.random.default_rng(1).normal(size=(2, 500))
    >>> found = noise_ratio(noise[0] + 1j * noise[1], np.arange(500.0), np.array([1 / 12]), 0)
    >>> bool(found[0] < 1.3)
    True
    """
    step = 1.0 / hours[-1]
    band = cycles[k] + step * NEAR
    away = np.abs(band[:, None] - np.array([0.0, *cycles])).min(axis=1) >= 0.99 * step
    band = band[(band > 0) & away]
    if not len(band):
        return np.ones(3)
    wave = np.exp(-2j * np.pi * np.outer(band, hours))
    power = [
        np.mean(np.abs(wave @ r) ** 2) / len(hours)
        for r in (residual.real, residual.imag)
    ]
    white = [np.mean(residual.real**2), np.mean(residual.imag**2)]
    with np.errstate(all="ignore"):  # no residual at all: 0 / 0
        ratio = np.array(
            [sum(power) / sum(white), power[0] / white[0], power[1] / white[1]]
        )
    return np.sqrt(np.fmax(ratio, 1.0))
