"""A basis for a glider's dives: currents everywhere, and gaussians on a lattice about the track.

    steady: phi = 1;  a tide: cos(w t) and sin(w t);  a place: exp(-|x - c|^2/(2 width^2))

The places are those of `gaussian_places`: only starts and dead reckoning of the dives are read.
"""

import math
from collections.abc import Sequence

import numpy as np

from ..arguments import public
from ..blocks.basis import flow_basis
from ..equations.block import Block
from ..errors import DataError, ScenarioError
from ..scenario.tides import period
from .dive import Dive
from .fix_model import WIDTH
from .gaussian_places import SPACING, near
from .priors import QUARTER_DAY, Priors

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
    return np.hypot(priors.fix, priors.gradient_scatter * time)


def dive_walk(prior: np.ndarray) -> np.ndarray:
    """Return the walk of each parameter, m/s per square root of s: that of a current, scaled."""
    priors = Priors()
    return prior * priors.gradient_walk / (priors.current * np.sqrt(QUARTER_DAY))
