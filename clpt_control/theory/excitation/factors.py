"""Triangular factors of Gramians, Definition 3.1.

    int w w^T dt = R^T R,    R from the QR factors of sqrt(weight) w^T

Factors of pieces stack and factor again to that of the whole, so a sliding
window adds pieces and never subtracts, and an eigenvalue of 1e-21 keeps its
digits beside one of 1e3.
"""

import numpy as np

from .regressor import Regressor


def piece_factors(regressor: Regressor) -> np.ndarray:
    """Return the triangular factor of each piece's Gramian.

    Parameters
    ----------
    regressor : Regressor
        Over a window.

    Returns
    -------
    ndarray, shape (2, pieces, rows, N + 2)
        Stacked over pieces they factor the Gramian of the whole.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.theory.excitation.regressor import joint_regressor
    >>> piece_factors(joint_regressor(clpt.paper_scenario(), 20.0, 0.0)).shape
    (2, 4, 5, 5)
    """
    return _triangle(np.sqrt(regressor.weights)[..., None] * regressor.w)


def joined(pieces: np.ndarray) -> np.ndarray:
    """Join the factors of pieces into the factor of the whole.

    Parameters
    ----------
    pieces : ndarray, shape (pieces, rows, n)
        One axis of `piece_factors`.

    Returns
    -------
    ndarray, shape (n, n)
        R with R^T R = int w w^T dt.

    Examples
    --------
    >>> joined(np.array([[[3.0]], [[4.0]]])).round(12)
    array([[-5.]])
    """
    n = pieces.shape[-1]
    return _triangle(np.concatenate([np.zeros((n, n)), *pieces]))


def _triangle(rows: np.ndarray) -> np.ndarray:
    return np.asarray(np.linalg.qr(rows, mode="r"))
