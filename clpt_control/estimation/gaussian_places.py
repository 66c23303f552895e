"""Gaussian functions of place where a vehicle's track supports them, Eq. (5).

    phi_c(x) = exp(-|x - c|^2 / (2 width^2)),  H_c = int phi_c(x(t)) dt

The places c stand on a square lattice of 1.5 widths about the vehicle's first
fix.  One joins the parameters when a track first comes near enough that
H_c > `REACHED` T; before that it has its prior and nothing else, so that joining
late changes little.

A long voyage keeps the `MOST` places nearest to its last track.

Along a dive x(t) is the dead-reckoned track from the fix before it; when the
dive has ended, the track bent evenly to the fix after it.

A basis for a glider's dives has currents everywhere, and gaussians at the places:

    steady: phi = 1;  a tide: cos(w t) and sin(w t);  a place: exp(-|x - c|^2/(2 width^2))

Only starts and dead reckoning of the dives are read for it.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.integrate import trapezoid

from ..arguments import public
from ..blocks.flow import flow_basis
from ..equations.at_many import evaluate
from ..equations.block import Block
from ..errors import DataError, ScenarioError
from ..geodesy import displacement
from ..scenario.tides import period
from .dive import Dive, miss, reckoned
from .priors import Priors

WIDTH = 20e3  # m, of a gaussian
SPACING = 1.5  # widths
REACHED = 0.1  # share of a dive's time
MOST = 40  # places that are kept; the farthest are forgotten
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
    x = _along(old, dive, False)[1]
    pitch, reach = SPACING * old.width, old.width * math.sqrt(-2 * math.log(REACHED))
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
    support = places_columns(tried, dive)[0, ::2]
    fresh = [cell for cell, s in zip(around, support, strict=True) if s > REACHED * dive.duration]
    if places is not None and not fresh:
        return places
    cells = [*old.cells, *fresh]
    away = np.hypot(*(pitch * np.array(cells) - x.mean(axis=0)).T)
    nearest = set(np.argsort(away, kind="stable")[:MOST].tolist())
    cells = [cell for k, cell in enumerate(cells) if k in nearest]
    return Places(old.latitude, old.longitude, old.width, tuple(cells))


def _along(places: Places, dive: Dive, ended: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return a few samples of a dive's track: time (k,), s; from the lattice's origin (k, 2), m.

    Where the dive has `ended` its track is bent to the fix after it.
    """
    time = np.linspace(0.0, dive.duration, SAMPLES)
    since, *axes = reckoned(dive)
    x = np.stack([np.interp(time, since, axis) for axis in axes], axis=1)
    if ended:
        x = x + (time / dive.duration)[:, None] * miss(dive)
    start = displacement(places.latitude, places.longitude, dive.lat_gps2, dive.lon_gps2)
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


WIDE = 1e12  # m, of a gaussian that is 1 everywhere on Earth


@public
def dive_basis(
    dives: Sequence[Dive],
    width: float | None = WIDTH,
    constituents: Sequence[str] = ("steady",),
) -> tuple[Block, np.ndarray]:
    """Make a flow basis for dives, and what is believed of it before.

    Parameters
    ----------
    dives : sequence of Dive
        In their order; their ends are not read.
    width : float or None
        Of the gaussians, m, which stand 1.5 widths apart where the track comes near; None for
        no gaussians.
    constituents : sequence of str
        Currents that are the same everywhere: ``"steady"``, ``"M2"``, ...

    Returns
    -------
    basis : Block
        phi of Eq. (5), x in m east and north of the first dive's start, time in s since 1970.
    prior : ndarray, shape (N,)
        Standard deviation of each parameter, m/s (`Priors`).

    Raises
    ------
    DataError
        If there is no dive.
    ScenarioError
        If a constituent is unknown, or there is no function.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> basis, prior = clpt.estimation.dive_basis(clpt.gliders.sample_dives(), width=20e3)
    >>> basis.output_ports, prior[:2].tolist()
    ({'phi_x': 9}, [0.3, 0.15])
    """
    if not dives:
        raise DataError("no dive is given; a basis of dives needs one at least")
    priors, turn = Priors(), -math.pi / 2
    rows = []  # center, width, frequency, phase, prior
    for name in constituents:
        w = 2 * math.pi / period(name, "s")
        sd = priors.tide if w else priors.current
        rows += [((0.0, 0.0), WIDE, w, phase, sd) for phase in ((0.0, turn) if w else (0.0,))]
    if width is not None:
        if not (math.isfinite(width) and width > 0):
            raise ScenarioError(f"width = {width:g} m: must be positive, or None for no gaussians")
        places = None
        for dive in dives:
            places = near(places, dive, width)
        for i, j in places.cells if places else ():
            center = (SPACING * width * i, SPACING * width * j)
            rows.append((center, width, 0.0, 0.0, priors.gaussian))
    if not rows:
        raise ScenarioError("no function: give a constituent or a width")
    *functions, prior = (np.array(column) for column in zip(*rows, strict=True))
    return flow_basis("basis_x", "x", "gaussian", *functions), prior


def dive_noise(dives: Sequence[Dive]) -> np.ndarray:
    """Return the standard deviation of each dive's miss, (n,), m: fixes, and what is unknown."""
    priors = Priors()
    time = np.array([dive.duration for dive in dives])
    return np.hypot(priors.fix, priors.gradient.scatter * time)


def dive_walk(prior: np.ndarray) -> np.ndarray:
    """Return the walk of each parameter, m/s per square root of s: that of a current, scaled."""
    priors = Priors()
    return prior * np.sqrt(2 / priors.gradient.memory)
