"""Check of the dead reckoning against the way over ground: swapped, reversed or in km.

With g the displacement over ground, d the dead reckoning and T the duration of a dive,

    g / T = f A d / T + c + residual,

with a mean current c and a factor f on the speed. A is the identity for correct columns, and
another matrix for columns that are swapped, reversed or in km. For n dives the log-likelihood ratio
of A and the identity is (n - 1) log(R / R_A), with R the sums of squared residuals.

Real vehicles and made seas reach 5 (128 and 1900 dives, all windows of 4 to 40 dives). A table with
a wrong column is refused at dive 4 to 40, as soon as its headings and currents tell.
"""

from collections.abc import Sequence
from math import log

import numpy as np

from ...base.errors import DataError
from ..gliders.dives import Dive

FEWEST, MOST = 4, 40  # dives that are compared, the last ones
SURE = log(1e5)  # log-likelihood ratio
SLOWEST, FASTEST = 1 / 3, 3.0  # factor on the speed
CAUSES = {  # appearance of dr_east_m and dr_north_m, and A
    "swapped": np.array([[0.0, 1.0], [1.0, 0.0]]),
    "reversed in sign": -np.eye(2),
    "like km": 1000.0 * np.eye(2),
}


def check_dead_reckoning(dives: Sequence[Dive]) -> None:
    """Refuse dives whose way over ground shows that their dead reckoning is wrong."""
    dives = dives[-MOST:]
    if len(dives) < FEWEST:
        return
    over_ground = _variation([(*d.over_ground, d.duration) for d in dives])
    reckoned = _variation([(*d.through_water, d.duration) for d in dives])
    limit = _residual(over_ground, reckoned, 0.0) * np.exp(-SURE / (len(dives) - 1))
    residuals = {
        cause: _residual(over_ground, reckoned @ matrix, SLOWEST)
        for cause, matrix in CAUSES.items()
    }
    cause = min(residuals, key=residuals.__getitem__)
    if residuals[cause] < limit:
        raise DataError(
            f"dives {dives[0].number} to {dives[-1].number}: the ways over ground contradict the "
            f"dead reckoning: dr_east_m and dr_north_m look {cause}. Correct them in the files"
        )


def _variation(ways: Sequence[tuple[float, float, float]]) -> np.ndarray:
    """Return velocities less their mean, (n, 2), m/s, of displacements (m) and durations (s)."""
    rows = np.array(ways)
    velocity = rows[:, :2] / rows[:, 2:]
    return velocity - velocity.mean(axis=0)


def _residual(over_ground: np.ndarray, reckoned: np.ndarray, slowest: float) -> float:
    """Return the sum of squared residuals with the best factor on the speed."""
    size = float(np.sum(reckoned**2))
    factor = float(np.sum(reckoned * over_ground)) / size if size > 0 else 0.0
    factor = min(max(factor, slowest), FASTEST)
    return float(np.sum((over_ground - factor * reckoned) ** 2))
