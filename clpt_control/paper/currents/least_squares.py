"""theta of Eq. (3) from measured flow, by linear least squares.

    minimise sum_s |F_s - theta phi(x_s, t_s)|^2   over theta, shape (2, N)

phi is Eq. (5), evaluated by the basis block's own output function.  The
problem is solved by the singular value decomposition (G. H. Golub, C. F. Van
Loan, "Matrix Computations", 4th ed., 2013, section 5.5); its conditioning is
the ratio of the largest to the smallest singular value of phi.  The largest
residual |F_s - theta phi| is the bound on Delta in Eq. (32) over the samples.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import lstsq, svd

from ...base.errors import DataError

# of its rms: a flow whose changes are less hardly has a variance to explain
STEADY = 0.01
WORST = 1e6  # largest condition number; beyond, measurement errors of 1 % decide theta alone


@dataclass(frozen=True)
class LeastSquares:
    """theta (2, N) and residuals F_s - theta phi_s (n, 2), in the unit of the flow.

    `explained_variance` is that of `explained_share`, `condition_number` the largest over the
    smallest singular value of phi.
    """

    theta: np.ndarray
    residuals: np.ndarray
    explained_variance: float
    condition_number: float

    @property
    def residual_rms(self) -> float:
        """Root of the mean squared length of the residuals."""
        return float(np.sqrt(np.mean(np.sum(self.residuals**2, axis=1))))

    @property
    def residual_max(self) -> float:
        """Largest length of a residual, the bound of Eq. (32)."""
        return float(np.hypot(*self.residuals.T).max())


def explained_share(values: np.ndarray, model: np.ndarray) -> float:
    """Return the share of a flow's variance that a model explains; both (n, 2), or (n,) u + iv.

    1 - sum |values - model|^2 / sum |values - mean|^2, both components together, each about its
    mean: the mean alone has the share 0, and what is further off a negative one.  NaN of a steady
    flow, whose changes are less than `STEADY` of it: one of the same number of m/s to the east
    everywhere changes by as much on a plane map, where the east turns.

    >>> explained_share(np.array([1.0, 3.0]), np.array([1.5, 2.5]))
    0.75
    """
    differences = values - values.mean(axis=0), values - model, values
    off, residual, size = (float(np.sum(np.abs(d) ** 2)) for d in differences)
    return 1.0 - residual / off if off > STEADY**2 * size else np.nan


def least_squares(
    phi: np.ndarray, flow: np.ndarray, names: Sequence[str]
) -> LeastSquares:
    """Fit theta of Eq. (3) to measured flow (n, 2), with phi (n, N) of `blocks.evaluate`, n >= N.

    `names` are those of the N functions in messages.
    """
    theta, _, _, singular = lstsq(phi, flow)
    condition = float(singular[0] / singular[-1]) if singular[-1] > 0 else np.inf
    if not condition <= WORST:
        weakest = np.abs(svd(phi, full_matrices=False)[2][-1])
        involved = np.flatnonzero(weakest > 0.3 * weakest.max())
        listed = ", ".join(names[k] for k in involved[:6]) + (
            ", ..." if len(involved) > 6 else ""
        )
        raise DataError(
            f"the samples cannot separate the basis functions {listed}: condition number "
            f"{condition:.3g}, at most {WORST:g} is allowed. Use a longer record, fewer "
            "constituents or centers, a smaller box or another width"
        )
    residuals = flow - phi @ theta
    return LeastSquares(
        theta.T, residuals, explained_share(flow, flow - residuals), condition
    )
