"""Gaussian functions of place where a vehicle's track supports them, Eq. (5).

    phi_c(x) = exp(-|x - c|^2 / (2 width^2)),  H_c = int phi_c(x(t)) dt

The places c stand on a square lattice of 1.5 widths about the vehicle's first
fix.  One joins the parameters when a track first comes near enough that
H_c > `NEAR` T; before that it has its prior and nothing else, so that joining
late changes little.  Whether the dives excite it is then read from their
Gramian, as for every parameter (`held`).

A long voyage keeps the `MOST` places nearest to its last track.

Along a dive x(t) is the dead-reckoned track from the fix before it; when the
dive has ended, the track bent evenly to the fix after it.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import trapezoid

from ..blocks import evaluate
from ..blocks.basis import BasisParameters, flow_basis
from ..errors import ScenarioError
from ..geodesy import displacement
from .fix_regressor import miss, reckoned

SPACING = 1.5  # widths
NEAR = 0.1  # share of a dive's time
MOST = 40  # places that are kept; the farthest are forgotten
SAMPLES = 25  # of a track


@dataclass(frozen=True)
class Places:
    """Places of gaussians on a lattice.

    Attributes
    ----------
    latitude, longitude : float
        The vehicle's first fix, degrees.
    width : float
        Of every gaussian, m.
    cells : tuple of tuple of int
        Columns east and rows north of it, in the order they were reached.
    """

    latitude: float
    longitude: float
    width: float
    cells: tuple[tuple[int, int], ...] = ()


def track(dive: Any, ended: bool = False) -> tuple[np.ndarray, np.ndarray]:
    """Return a dive's track from its start, a few samples.

    Parameters
    ----------
    dive : Dive
        Its track, or a straight way.
    ended : bool, optional
        Whether to bend it to the fix after the dive.

    Returns
    -------
    time : ndarray, shape (k,)
        Since the fix before the dive, s.
    way : ndarray, shape (k, 2)
        East and north, m.
    """
    time = np.linspace(0.0, dive.duration, SAMPLES)
    since, *ways = reckoned(dive)
    way = np.stack([np.interp(time, since, w) for w in ways], axis=1)
    return time, (way + (time / dive.duration)[:, None] * miss(dive) if ended else way)


def near(places: Places | None, dive: Any, width: float) -> Places:
    """Return the places with those that a dive comes near.

    Parameters
    ----------
    places : Places or None
        None before the first dive, whose start becomes the lattice's origin.
    dive : Dive
        Its end is not used.
    width : float
        Of the gaussians, m; used for the first dive.

    Returns
    -------
    Places
        The same object where nothing is new.

    Raises
    ------
    ScenarioError
        If the dive is more than fifteen widths long.

    Examples
    --------
    >>> from clpt_control.gliders.dives import make_dive
    >>> dive = make_dive(1, (0.0, 40.0, 8.0), (9000.0, 40.0, 8.02), (500.0, 0.0))
    >>> near(None, dive, 20e3).cells
    ((-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 0), (0, 1), (1, -1), (1, 0), (1, 1))
    """
    old = places or Places(dive.lat_gps2, dive.lon_gps2, width)
    x = _along(old, dive, False)[1]
    pitch, reach = SPACING * old.width, old.width * math.sqrt(-2 * math.log(NEAR))
    if np.ptp(x, axis=0).max() > 10 * pitch:
        raise ScenarioError(
            f"width of the gaussians = {old.width:g} m: must be more, for dive {dive.number} is "
            f"{np.ptp(x, axis=0).max():.0f} m long"
        )
    low, high = (
        np.rint((end(x, axis=0) + side * reach) / pitch).astype(int)
        for end, side in ((np.min, -1), (np.max, 1))
    )
    around = [
        (i, j)
        for i in range(low[0], high[0] + 1)
        for j in range(low[1], high[1] + 1)
        if (i, j) not in old.cells
    ]
    if not around:
        return old
    tried = Places(old.latitude, old.longitude, old.width, tuple(around))
    support = way_over_places(tried, dive)[0, ::2]
    fresh = [cell for cell, s in zip(around, support, strict=True) if s > NEAR * dive.duration]
    if places is not None and not fresh:
        return places
    cells = [*old.cells, *fresh]
    away = np.hypot(*(pitch * np.array(cells) - x.mean(axis=0)).T)
    nearest = set(np.argsort(away, kind="stable")[:MOST].tolist())
    cells = [cell for k, cell in enumerate(cells) if k in nearest]
    return Places(old.latitude, old.longitude, old.width, tuple(cells))


def _along(places: Places, dive: Any, ended: bool) -> tuple[np.ndarray, np.ndarray]:
    time, way = track(dive, ended)
    start = displacement(places.latitude, places.longitude, dive.lat_gps2, dive.lon_gps2)
    return time, np.array(start) + way


def way_over_places(places: Places, dive: Any, ended: bool = False) -> np.ndarray:
    """Return the columns of gaussians: phi integrated over a dive.

    Parameters
    ----------
    places : Places
        N of them.
    dive : Dive
        Its end is used only
    ended : bool, optional
        where this is True.

    Returns
    -------
    ndarray, shape (2, 2N)
        s; each place's east, then its north.
    """
    N = len(places.cells)
    steady = np.zeros(N)
    centers = SPACING * places.width * np.array(places.cells, float).reshape(N, 2)
    basis = flow_basis(
        "places",
        "x",
        "gaussian",
        BasisParameters(N, centers, np.full(N, places.width), steady, steady),
    )
    time, x = _along(places, dive, ended)
    return np.kron(trapezoid(evaluate(basis, time, x), time, axis=0), np.eye(2))
