"""Localization: position measurements with noise, at all times or at fixes.

    x_m = x + s n(j, axis),    j T <= t < (j + 1) T

s is the standard deviation of each axis (length), n standard normal, constant for T (time).  The
noise is a hash of (seed, j, axis), like the noise of the disturbance but with different axis
numbers, so that both may use one seed.

`measurement`, at all times: the port x is then x_m for every block but the true flow, which
reads the true position, the port `x_true`.

`fixes`, each T: fix j is x_m at t = j T, j = 1, 2, ...; a fix is missing with a probability, by
the same hash.  Between fixes no block reads these ports.

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
FIRST_AXIS = 2  # axis number in the hash; the disturbance has 0 and 1


def position_noise(p):
    """Return the noise of each axis in interval j, length."""
    return p.noise * normal(p.seed, p.interval, FIRST_AXIS + AXES)


def measured(t, x, u, p):
    """x_m = x + s n(j, axis), read as x by Eqs. (7), (10)."""
    return u.x_true + position_noise(p)


def fix(t, x, u, p):
    """x_m = x + s n(j, axis) with x of Eq. (1), and taken: 1, or 0 if fix j is missing.

    A fix is missing if its hash is below the probability of dropouts.
    """
    missing = hash_fraction(p.seed, p.interval, MISSING, 0) < p.dropouts
    return {"fix": u.x + position_noise(p), "taken": np.where(missing, 0.0, 1.0)}


def fixes(
    noise: float, interval: float, dropouts: float = 0.0, seed: float = 0.0
) -> Block:
    """Make the block of fixes from s, the time between two fixes and the share of dropouts."""
    parameters = {
        "noise": noise,
        "between": interval,
        "dropouts": dropouts,
        "seed": seed,
    }
    return paper_block(
        "fixes",
        "x -> fix taken",
        parameters,
        output=fix,
        opaque=True,
        breakpoints=Each("between"),
    )


def measurement(noise: float, period: float, seed: float) -> Block:
    """Make the block of the measured position from s and T."""
    return paper_block(
        "measurement",
        f"{TRUE} -> x",
        {"noise": noise, "period": period, "seed": seed},
        output=measured,
        opaque=True,
        breakpoints=Each("period"),
    )
