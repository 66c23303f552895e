"""Whether a record's times suffice for its tides, and how loud the rest is.

A record can be long enough (`rayleigh`) and still be blind: a tide sampled once
a period looks like a mean.  The functions 1, cos w t, sin w t at the record's
own times say so by their condition number, which bounds how much worse than
even sampling the times make the errors.
"""

from collections.abc import Sequence

import numpy as np

from ...errors import DataError

WORST = 30.0  # largest condition number
NEAR = np.array([*range(-10, 0), *range(1, 11)])  # neighbours of a tide, in 1 / record length


def check_increasing(times: np.ndarray, where: str) -> None:
    """Refuse times that do not increase.

    Parameters
    ----------
    times : ndarray of datetime64, shape (n,)
        UTC.
    where : str
        The record, for the message.

    Raises
    ------
    DataError
        At the first that does not.
    """
    late = np.flatnonzero(np.diff(times) <= np.timedelta64(0, "ms"))
    if len(late):
        raise DataError(
            f"{where}: the time {times[late[0] + 1]} comes after {times[late[0]]}; times must "
            "increase: sort the record and keep each time once"
        )


def check_sampling(hours: np.ndarray, cycles: np.ndarray, names: Sequence[str], where: str) -> None:
    """Refuse times at which tides look alike.

    Parameters
    ----------
    hours : ndarray, shape (n,)
        Times of the measurements, h.
    cycles : ndarray, shape (nc,)
        Frequencies, cycles per hour.
    names : sequence of str
        Of the nc tides.
    where : str
        The record, for the message.

    Raises
    ------
    DataError
        If there are too few times, or functions look alike; they are named.

    Examples
    --------
    >>> check_sampling(np.arange(48.0), np.array([1 / 12]), ["S2"], "record")
    >>> check_sampling(12.0 * np.arange(48), np.array([1 / 12]), ["S2"], "record")
    Traceback (most recent call last):
        ...
    clpt_control.errors.DataError: record: at the times of its 48 measurements the mean and S2 look
    alike; take them at other intervals, fill the gaps or leave one out
    """
    n, count = len(cycles), 2 * len(cycles) + 1
    if len(hours) < 2 * count:
        raise DataError(
            f"{where}: {len(hours)} measurements for {count} numbers to fit; at least {2 * count} "
            "are needed: take a longer record or fewer constituents"
        )
    turn = np.exp(2j * np.pi * np.outer(hours - hours.mean(), cycles))
    functions = np.hstack([np.full((len(hours), 1), 0.5**0.5), turn.real, turn.imag])
    _, size, modes = np.linalg.svd(functions, full_matrices=False)
    if size[0] <= WORST * size[-1]:
        return
    weakest = np.abs(modes[-1])
    share = np.array([weakest[0], *np.hypot(weakest[1 : n + 1], weakest[n + 1 :])])
    alike = [
        name
        for name, part in zip(["the mean", *names], share, strict=True)
        if part > 0.3 * share.max()
    ]
    said = f"{' and '.join(alike)} look alike" if len(alike) > 1 else f"{alike[0]} is not seen"
    raise DataError(
        f"{where}: at the times of its {len(hours)} measurements {said}; take them at other "
        "intervals, fill the gaps or leave one out"
    )


def loudness(residual: np.ndarray, hours: np.ndarray, cycles: np.ndarray, k: int) -> np.ndarray:
    """Return how much louder a residual is near a tide than on average.

    Parameters
    ----------
    residual : ndarray of complex, shape (n,)
        East + i north.
    hours : ndarray, shape (n,)
        From 0 to the record's length, h.
    cycles : ndarray, shape (nc,)
        Frequencies of all tides, cycles per hour.
    k : int
        Which tide.

    Returns
    -------
    ndarray, shape (3,)
        sqrt(power / mean power) over the 20 neighbouring frequencies, those of
        other tides left out: of both, of east, of north; 1 where it is less.

    Examples
    --------
    >>> noise = np.random.default_rng(1).normal(size=(2, 500))
    >>> bool(loudness(noise[0] + 1j * noise[1], np.arange(500.0), np.array([1 / 12]), 0)[0] < 1.3)
    True
    """
    step = 1.0 / hours[-1]
    near = cycles[k] + step * NEAR
    away = np.abs(near[:, None] - np.array([0.0, *cycles])).min(axis=1) >= 0.99 * step
    near = near[(near > 0) & away]
    if not len(near):
        return np.ones(3)
    wave = np.exp(-2j * np.pi * np.outer(near, hours))
    power = [np.mean(np.abs(wave @ r) ** 2) / len(hours) for r in (residual.real, residual.imag)]
    white = [np.mean(residual.real**2), np.mean(residual.imag**2)]
    with np.errstate(all="ignore"):  # no residual at all: 0 / 0
        ratio = np.array([sum(power) / sum(white), power[0] / white[0], power[1] / white[1]])
    return np.sqrt(np.fmax(ratio, 1.0))
