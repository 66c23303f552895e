"""Lattice of gaussians along the tracks of dives, Eq. (5).

    phi_c(x) = exp(-|x - c|^2 / (2 width^2)),  H_c = int phi_c(x(t)) dt

The centers c are those points of a square lattice of 1.5 widths about the first fix that a track
comes near: H_c > `NEAR` T, with T the duration of the dive and x(t) its dead reckoning from the
fix before it.
"""

import math
from collections.abc import Sequence
from itertools import product

import numpy as np
from scipy.integrate import trapezoid

from ...base.errors import ScenarioError
from ...base.geodesy import displacement
from .dive import Dive, reckoned

SPACING = 1.5  # widths
NEAR = 0.1  # share of a dive's time
MOST = 40  # centers
SAMPLES = 25  # of a track

Center = tuple[float, float]


def gaussian_centers(dives: Sequence[Dive], width: float) -> list[Center]:
    """Return the centers near the tracks, m east and north of the first fix."""
    pitch = SPACING * width
    reach = width * math.sqrt(-2 * math.log(NEAR))
    centers: dict[tuple[int, ...], Center] = {}
    for dive in dives:
        start = displacement(
            dives[0].lat_gps2, dives[0].lon_gps2, dive.lat_gps2, dive.lon_gps2
        )
        time, x = sampled_track(dive)
        x = start + x
        check_width(dive, x, width)
        low = np.rint((x.min(axis=0) - reach) / pitch).astype(int)
        high = np.rint((x.max(axis=0) + reach) / pitch).astype(int)
        columns, rows = map(range, low, high + 1)
        for cell in product(columns, rows):
            center = pitch * cell[0], pitch * cell[1]
            phi = np.exp(-np.sum((x - center) ** 2, axis=1) / (2 * width**2))
            if trapezoid(phi, time) > NEAR * dive.duration:
                centers.setdefault(cell, center)
    return list(centers.values())[:MOST]


def sampled_track(dive: Dive) -> tuple[np.ndarray, np.ndarray]:
    """Return times (k,), s, and dead reckoning (k, 2), m, since the fix before a dive."""
    time = np.linspace(0.0, dive.duration, SAMPLES)
    since, east, north = reckoned(dive)
    track = np.interp(time, since, east), np.interp(time, since, north)
    return time, np.stack(track, axis=1)


def check_width(dive: Dive, x: np.ndarray, width: float) -> None:
    """Refuse gaussians that are narrow compared with a dive."""
    length = np.ptp(x, axis=0).max()
    if length > 10 * SPACING * width:
        raise ScenarioError(
            f"width of the gaussians = {width:g} m: must be more, for dive {dive.number} is "
            f"{length:.0f} m long"
        )
