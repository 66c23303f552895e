"""The 90 % ellipse of a forecast.

    (x - m)^T P^-1 (x - m) = 2 ln 10

holds a normal pair with probability 0.9; its half axes are sqrt(2 ln 10 l), l
the eigenvalues of P.
"""

import numpy as np

CHI_SQUARED = 4.605170185988092  # of two components, 90 %: 2 ln 10


def ellipse(covariance: np.ndarray) -> tuple[float, float, float]:
    """Return half axes (m) and bearing of the long axis (degrees).

    Parameters
    ----------
    covariance : ndarray, shape (2, 2)
        East and north, m^2.

    Returns
    -------
    long, short : float
        Half axes of the 90 % ellipse, m.
    bearing : float
        Of the long one, degrees clockwise from north, 0 to 180.
    """
    size, axes = np.linalg.eigh(covariance)
    short, long = np.sqrt(CHI_SQUARED * size)
    bearing = np.degrees(np.arctan2(axes[0, 1], axes[1, 1])) % 180.0
    return float(long), float(short), float(bearing)
