"""Hold what the dives do not excite at its prior value.

    m_l <- m_l - B m_h,  m_h <- 0,  B = P_lh P_hh^-1
    P_hh <- P0,  P_lh <- B P0,  P_ll <- P_ll - B P_hl + B P0 B^T

A parameter is learned, l, when its variance is below `LEARNED` of the prior's:
with G the Gramian of the dives, P = (G + P0^-1)^-1, that is when the dives tell
at least a third of what was known before.  The others, h, return to zero with
their prior variance P0; the learned are what they would be had h been zero, and
go on hanging together with h as the dives left them, l = m_l + B (h - m_h).
"""

import numpy as np

LEARNED = 0.75


def hold(
    mean: np.ndarray, P: np.ndarray, prior_sd: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Hold what the dives do not excite at its prior value.

    Parameters
    ----------
    mean : ndarray, shape (m, n)
        Estimates of m filters.
    P : ndarray, shape (m, n, n)
        Their covariances.
    prior_sd : ndarray, shape (m, n)
        Standard deviations before any dive; infinite is always learned.

    Returns
    -------
    mean, P : ndarray
        With the held parameters at zero.
    learned : ndarray of bool, shape (m, n)
        Which are learned.

    Examples
    --------
    >>> hold(np.array([[1.0, 2.0]]), np.diag([0.1, 0.9])[None], np.ones((1, 2)))[0]
    array([[1., 0.]])
    """
    variance = np.diagonal(P, axis1=1, axis2=2)
    learned = variance < LEARNED * prior_sd**2  # (m, n)
    mean, P = mean.copy(), P.copy()
    for pattern in np.unique(learned, axis=0):
        which = np.flatnonzero((learned == pattern).all(axis=1))
        h = np.flatnonzero(~pattern)
        if not len(h):
            continue
        keep = np.flatnonzero(pattern)
        back = P[np.ix_(which, keep, h)] @ np.linalg.inv(P[np.ix_(which, h, h)])
        mean[np.ix_(which, keep)] -= np.einsum("mlh,mh->ml", back, mean[np.ix_(which, h)])
        prior = prior_sd[np.ix_(which, h)][:, :, None] ** 2 * np.eye(len(h))
        inner = P[np.ix_(which, keep, keep)] - back @ P[np.ix_(which, h, keep)]
        P[np.ix_(which, keep, keep)] = inner + back @ prior @ back.transpose(0, 2, 1)
        P[np.ix_(which, keep, h)] = back @ prior
        P[np.ix_(which, h, keep)] = (back @ prior).transpose(0, 2, 1)
        mean[np.ix_(which, h)] = 0.0
        P[np.ix_(which, h, h)] = prior
    return mean, P, learned
