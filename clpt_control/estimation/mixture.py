"""Mean and covariance of a weighed mixture.

m = sum w_i m_i,  P = sum w_i (P_i + (m_i - m)(m_i - m)^T)
"""

import numpy as np


def mixed(
    means: np.ndarray, covariances: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return mean and covariance of a weighed mixture.

    Parameters
    ----------
    means : ndarray, shape (m, n)
        Of the parts.
    covariances : ndarray, shape (m, n, n)
        Of the parts.
    weights : ndarray, shape (m,)
        Probabilities.

    Returns
    -------
    mean : ndarray, shape (n,)
    covariance : ndarray, shape (n, n)
        Within the parts and between them.

    Examples
    --------
    >>> mixed(np.array([[0.0], [2.0]]), np.ones((2, 1, 1)), np.array([0.5, 0.5]))
    (array([1.]), array([[2.]]))
    """
    mean = weights @ means
    away = means - mean
    between = np.einsum("m,mi,mj->ij", weights, away, away)
    return mean, np.einsum("m,mij->ij", weights, covariances) + between
