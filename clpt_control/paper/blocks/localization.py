"""Localization: a position read with noise, at all times or at fixes.

    x_m = x + s n(j, axis),    j T <= t < (j + 1) T

s is the standard deviation of each axis (length), n standard normal, held for T (time).  The
noise is a hash of (seed, j, axis), as that of the disturbance but with numbers of its own: one
seed may serve both.

`measurement`, at all times: whatever reads x in the diagram then reads x_m, by the same name; the
true position is the port `x_true`, which the true flow alone reads.

`fixes`, each T: fix j is x_m at t = j T, j = 1, 2, ...; it is missing with a probability, by the
same hash.  Between fixes nobody reads these ports.

Ports: x_true[2] (length) -> x[2] (length), x_m; x[2] -> fix[2] (length), taken[1] (1 or 0).
"""

import numpy as np

from ...base.random_numbers import hash_fraction, normal
from ...engine.model.block import Block
from ...engine.model.declaration import Each
from .disturbance import AXES
from .ports import paper_block

TRUE = "x_true"  # the port of the true position
MISSING = 4  # the number of dropouts in the hash
FIRST_AXIS = 2  # of the hash; the disturbance has 0 and 1


def position_noise(p):
    """Return the noise of each axis in interval j, length."""
    return p.noise * normal(p.seed, p.interval, FIRST_AXIS + AXES)


def measured(t, x, u, p):
    """x_m = x + s n(j, axis), read as x by Eqs. (7), (10)."""
    return u.x_true + position_noise(p)


def fix(t, x, u, p):
    """x_m = x + s n(j, axis), and whether fix j is taken.

    It is of Eq. (1) at the times of fixes, and missing where the hash is below the probability.
    """
    missing = hash_fraction(p.seed, p.interval, MISSING, 0) < p.dropouts
    return {"fix": u.x + position_noise(p), "taken": np.where(missing, 0.0, 1.0)}


def fixes(
    noise: float, between: float, dropouts: float = 0.0, seed: float = 0.0
) -> Block:
    """Make the block of the fixes: s, the time between two, the share that is missing."""
    given = {"noise": noise, "between": between, "dropouts": dropouts, "seed": seed}
    return paper_block(
        "fixes",
        "x -> fix taken",
        given,
        output=fix,
        opaque=True,
        breakpoints=Each("between"),
    )


def measurement(noise: float, period: float, seed: float = 0.0) -> Block:
    """Make the block of the measured position: s, and how long the noise is held."""
    given = {"noise": noise, "period": period, "seed": seed}
    jumps, ports = Each("period"), f"{TRUE} -> x"
    return paper_block(
        "measurement", ports, given, output=measured, opaque=True, breakpoints=jumps
    )
