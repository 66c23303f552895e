"""Scalar counterexamples to Eqs. (16) and (33), run exactly.

One axis, one basis function, z = zc = 0, of Eqs. (27)-(28) with Delta of Eq.
(32): the matrix comes from the blocks, the run from the matrix exponential.
Delta may as well be the residual (theta - theta_hat) phi of Eq. (16).

- A square wave at the resonance sqrt(gamma): limsup|e| -> 4/pi as gamma grows,
  the first harmonic of the wave passed on in full.
- Drift, then burst: a faint regressor eps lets the parameter error drift to
  -Delta/eps; a regressor of 1 then turns it into an error of about 0.55/eps.
"""

import numpy as np

from ..excitation.linear_runs import Piece, exact_run, scalar_matrix
from .printed_bounds import Counterexample

CLAIM = "|e| <= max|Delta|/beta for any beta < k"


def square_wave_counterexample(
    k: float = 1.0, gain: float = 100.0, periods: int = 60, samples: int = 200
) -> Counterexample:
    """Violate Eq. (33): phi = 1, square wave at sqrt(gamma).

    Parameters
    ----------
    k : float
        Feedback gain, per time.
    gain : float
        Adaptation gain gamma.
    periods : int
        Length of the run; its last quarter is measured.
    samples : int
        Per half period.

    Returns
    -------
    Counterexample
        Delta = +1, -1 in turn, from e = eta = 0.

    Examples
    --------
    >>> round(square_wave_counterexample().peak, 3)
    1.273
    """
    A, half = scalar_matrix(1.0, k, gain), np.pi / np.sqrt(gain)
    pieces = [
        Piece(half, A, np.array([sign, 0.0]), samples)
        for _ in range(periods)
        for sign in (1.0, -1.0)
    ]
    times, states = exact_run(pieces, np.zeros(2))
    size = np.abs(states[:, 0])
    return Counterexample("(33)", CLAIM, k, times, size, np.ones_like(times), 1.5 * periods * half)


def burst_counterexample(
    faint: float = 0.2,
    quiet: float = 250.0,
    burst: float = 20.0,
    cycles: int = 4,
    k: float = 1.0,
    gain: float = 1.0,
) -> Counterexample:
    """Violate Eq. (33) without limit: drift, then burst.

    The regressor is periodic and so persistently exciting; Delta = 1 stands
    still.  Peaks come back in every cycle, near 0.55 (1/eps - 1).

    Parameters
    ----------
    faint : float
        Regressor eps of the quiet stretch; it is 1 in the burst.
    quiet, burst : float
        Length of both stretches, time; quiet well above 1/(gamma eps^2).
    cycles : int
        How often; the second half is measured.
    k : float
        Feedback gain, per time.
    gain : float
        Adaptation gain gamma.

    Returns
    -------
    Counterexample
        From e = eta = 0.

    Examples
    --------
    >>> round(burst_counterexample().peak, 2)
    2.19
    """
    drive = np.array([1.0, 0.0])
    cycle = [
        Piece(quiet, scalar_matrix(faint, k, gain), drive, 400),
        Piece(burst, scalar_matrix(1.0, k, gain), drive, 1000),
    ]
    times, states = exact_run(cycle * cycles, np.zeros(2))
    size = np.abs(states[:, 0])
    start = cycles // 2 * (quiet + burst)
    return Counterexample("(33)", CLAIM, k, times, size, np.ones_like(times), start)
