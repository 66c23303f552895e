"""Bounds under a disturbance and times, from the drop of V over a window.

    limsup |e| <= T Dmax (1 + 1/(1 - sqrt(1 - rho)))              Theorem 3.4, corrected
    |eta(t + n T)| <= sqrt(2 gamma V(t)) (1 - drop)^{n/2}         from V, Eq. (24)

The first holds because v = sqrt(2 V) obeys v' <= |Delta| beside the linear
part: from window to window v <= sqrt(1 - rho) v + T Dmax, and within a window v
grows by T Dmax at most.  It asks that w does not depend on Delta.
"""

import numpy as np

from ...arguments import public
from ...errors import ScenarioError


@public
def ultimate_bound(window: float, largest_disturbance: float, drop: float) -> float:
    """Bound ``|e|`` in the long run under a disturbance.

    Parameters
    ----------
    window : float
        Length T of the windows, time.
    largest_disturbance : float
        Dmax = sup ``|Delta|``, Euclidean norm, length per time.
    drop : float
        rho, or the exact drop, of every window, in [0, 1].

    Returns
    -------
    float
        The bound on limsup ``|e|``, length; inf where the drop is zero.

    Raises
    ------
    ScenarioError
        If the drop is not in [0, 1].

    Examples
    --------
    >>> import clpt_control as clpt
    >>> round(clpt.theory.ultimate_bound(2.0, 0.5, 0.75), 12)
    3.0
    """
    if not 0 <= drop <= 1:
        raise ScenarioError(f"drop = {drop:g}: must lie in [0, 1]")
    if drop == 0:
        return float("inf")
    # 1 - sqrt(1 - rho) = rho/(1 + sqrt(1 - rho)) keeps the digits of a small rho
    return float(window * largest_disturbance * (1 + (1 + np.sqrt(1 - drop)) / drop))


def time_to_error(window: float, drop: float, start: float, error: float) -> float:
    """Return the time until |eta| must be `error`: whole windows times T; inf for no drop.

    `drop` is the exact drop of V over each window of length T = `window`; `start` is
    sqrt(2 gamma V) at the start, |eta(0)| where e(0) = 0, in the unit of `error`.
    """
    if not (0 <= drop <= 1 and start > 0 and error > 0):
        raise ScenarioError(
            f"drop = {drop:g}, start = {start:g}, error = {error:g}: "
            "the drop must lie in [0, 1], the errors be positive"
        )
    if error >= start:
        return 0.0
    if drop == 0:
        return float("inf")
    if drop == 1:
        return float(window)
    windows = 2 * np.log(start / error) / -np.log1p(-drop)
    return float(window * np.ceil(windows * (1 - 1e-12)))
