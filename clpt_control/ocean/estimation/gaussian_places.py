"""Gaussian functions of place stand where a vehicle's track supports them, Eq. (5).

    phi_c(x) = exp(-|x - c|^2 / (2 width^2)),  H_c = int phi_c(x(t)) dt

The places c stand on a square lattice of 1.5 widths about the vehicle's first
fix.  One joins the parameters when a track first comes near enough that
H_c > `REACHED` T; before that it has its prior and nothing else, so that joining
late changes little.

There are at most `MOST`: beyond them a voyage goes on with the currents that are everywhere.

Along a dive x(t) is the dead-reckoned track from the fix before it; when the
dive has ended, the track bent evenly to the fix after it.
"""

import math
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from scipy.integrate import trapezoid

from ...base.errors import ScenarioError
from ...base.geodesy import displacement
from ...engine.model.block import evaluate
from ...paper.blocks.flow import flow_basis
from .dive import Dive, miss, reckoned

WIDTH = 20e3  # m, of a gaussian
SPACING = 1.5  # widths
REACHED = 0.1  # share of a dive's time
MOST = 40  # places that are parameters
SAMPLES = 25  # of a track


@dataclass(frozen=True)
class Places:
    """Gaussians on a lattice: its origin (degrees), their width (m), their cells.

    A cell is a column east and a row north of the origin; in the order they were reached.
    """

    latitude: float
    longitude: float
    width: float
    cells: tuple[tuple[int, int], ...] = ()


def near(places: Places | None, dive: Dive, width: float) -> Places:
    """Return the places with those that a dive comes near; the same object where nothing is new.

    `width` (m) and the dive's start are the first lattice's; a dive's end is not read.
    """
    old = places or Places(dive.lat_gps2, dive.lon_gps2, width)
    if len(old.cells) == MOST:
        return old
    x = _along(old, dive, False)[1]
    pitch, reach = SPACING * old.width, old.width * math.sqrt(-2 * math.log(REACHED))
    long = np.ptp(x, axis=0).max()
    if long > 10 * pitch:
        raise ScenarioError(
            f"width of the gaussians = {old.width:g} m: must be more, for dive {dive.number} is "
            f"{long:.0f} m long"
        )
    low, high = (
        np.rint((end(x, axis=0) + side * reach) / pitch).astype(int)
        for end, side in ((np.min, -1), (np.max, 1))
    )
    columns, rows = (
        range(first, last + 1) for first, last in zip(low, high, strict=True)
    )
    around = tuple(product(columns, rows))
    support = places_columns(replace(old, cells=around), dive)[0, ::2]
    reached = [
        cell
        for cell, s in zip(around, support, strict=True)
        if s > REACHED * dive.duration
    ]
    fresh = [cell for cell in reached if cell not in old.cells]
    if places is not None and not fresh:
        return places
    return replace(old, cells=(*old.cells, *fresh)[:MOST])


def _along(places: Places, dive: Dive, ended: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return a few samples of a dive's track: time (k,), s; from the lattice's origin (k, 2), m.

    Where the dive has `ended` its track is bent to the fix after it.
    """
    time = np.linspace(0.0, dive.duration, SAMPLES)
    since, *axes = reckoned(dive)
    x = np.stack([np.interp(time, since, axis) for axis in axes], axis=1)
    if ended:
        x = x + (time / dive.duration)[:, None] * miss(dive)
    start = displacement(
        places.latitude, places.longitude, dive.lat_gps2, dive.lon_gps2
    )
    return time, np.array(start) + x


def places_columns(places: Places, dive: Dive, ended: bool = False) -> np.ndarray:
    """Return phi integrated over a dive, (2, 2N), s: each place's east, then its north."""
    N = len(places.cells)
    steady = np.zeros(N)
    centers = SPACING * places.width * np.array(places.cells, float).reshape(N, 2)
    widths = np.full(N, places.width)
    basis = flow_basis("places", "x", "gaussian", centers, widths, steady, steady)
    time, x = _along(places, dive, ended)
    return np.kron(trapezoid(evaluate(basis, time, x), time, axis=0), np.eye(2))
