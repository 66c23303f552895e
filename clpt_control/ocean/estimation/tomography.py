"""Motion tomography: the flow from all recorded legs at once, tracks between fixes unknown.

Remark 3.2 of the paper names it as a source of theta.  Two stages:

1. Single shooting: each leg from its fix, with a robust cost (`scipy.optimize.least_squares`), from
   theta_0 and from the solution without it.  The lower cost is taken.  A fix with legs on both
   sides that are far off is wild: it is left out, and the two legs are one.
2. A smoother from there, by Gauss and Newton's method with Levenberg's damping.  The unknowns are
   theta and the place x_k at each fix and node (`leg_chain`), the cost is

    sum |x_{k+1} - z(x_k, theta)|^2/q_k^2     the tracks
    sum |f_k - x_k|^2/s^2                     the fixes f_k
    sum |theta - theta_0|^2/prior^2

   The normal equations are sparse: the time is linear in the number of legs.

Noise that neighbouring legs share, that of their common fix, is thus taken as it is.  theta is
steady.

Sources: D. Chang, W. Wu, C. R. Edwards, F. Zhang, "Motion tomography: mapping flow fields using
autonomous underwater vehicles", Int. J. Robotics Research 36, 320-336, 2017; B. P. Russo, R.
Kamalapurkar, D. Chang, J. A. Rosenfeld, "Motion tomography via occupation kernels", 2021.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import least_squares
from scipy.sparse import block_array, bsr_array, diags_array, eye_array
from scipy.sparse.linalg import splu

from .fix_settings import FixSettings
from .leg_chain import FlownLeg, LegChain, chain_of
from .leg_track import LegTrack

ROBUST = (
    1.5  # position errors over their standard deviation, from which the cost is linear
)
MOST = 60  # evaluations of single shooting, and steps of the smoother
FAR = 14.0  # |position error|^2 over its variance of both legs of a wild fix
SETTLED = 1e-5  # last step of theta, over the prior
LEAST_SCALE, LARGEST_SCALE = 0.2, 1.5  # factor c on the noise of the tracks
SAME = 1e-3  # relative difference of two costs
MUCH = 2.0  # factor c on the noise that is told


class Tomography(NamedTuple):
    """theta (2, N), P of its rows (2, N, N), factor c on the noise, wild fixes, notes, legs."""

    theta: np.ndarray
    covariance: np.ndarray
    scale: float
    wild: int
    notes: list[str]
    legs: list[FlownLeg]


def tomography(
    legs: Sequence[FlownLeg], settings: FixSettings, track: LegTrack
) -> Tomography:
    """Estimate theta from legs; the settings have prior, noise and first guess."""
    notes = []
    # 1. robust single shooting, without fixes that turn out to be wild
    used = list(legs)
    while True:
        chain = chain_of(used, settings, track, nodes=False)
        plain, *_ = _single_shooting(chain, settings, settings.theta, "linear")
        tries = [
            _single_shooting(chain, settings, theta, "soft_l1")
            for theta in (settings.theta, plain)
        ]
        theta, cost, off = min(tries, key=lambda solution: solution[1])
        square = float(np.median(off)) / np.log(4)
        right = _without_wild(used, off > FAR * max(square, LEAST_SCALE**2))
        if len(right) in (0, len(used)):
            break
        used = right
    if max(cost for _, cost, _ in tries) - cost > SAME * (1 + cost):
        notes.append(
            "tomography: two starts end at different costs, the lower one is taken. Record more "
            "legs, or shorter ones"
        )
    # 2. the smoother
    chain = chain_of(used, settings, track, nodes=True)
    scale = float(np.clip(square**0.5, LEAST_SCALE, LARGEST_SCALE))
    theta, covariance, c = _smoothed(chain, settings, theta, scale)
    if c > MUCH:
        notes.append(
            f"tomography: the legs fit only with {c:.1f} times the noise that is set"
        )
    return Tomography(theta, covariance, c, len(legs) - len(used), notes, used)


def _single_shooting(
    chain: LegChain, settings: FixSettings, start: np.ndarray, loss: str
) -> tuple[np.ndarray, float, np.ndarray]:
    """Return theta and the cost of nonlinear least squares of the legs from their fixes.

    And |position error|^2 over its variance of each leg.
    """
    begin, ends = chain.places[chain.links], chain.places[chain.links + 1]
    r, sd = chain.deviation[:, None], np.tile(_least(settings.prior), 2)
    first = settings.theta.ravel()

    def residuals(p: np.ndarray) -> np.ndarray:
        z = chain.shoot(begin, p.reshape(2, -1), slopes=False).z
        return np.concatenate([((z - ends) / r).ravel(), (p - first) / sd])

    def jacobian(p: np.ndarray) -> np.ndarray:
        by_theta = chain.shoot(begin, p.reshape(2, -1)).by_theta / r[:, :, None]
        return np.vstack([by_theta.reshape(-1, len(p)), np.diag(1 / sd)])

    solution = least_squares(
        residuals,
        start.ravel(),
        jacobian,
        x_scale=sd,
        loss=loss,
        f_scale=ROBUST,
        max_nfev=MOST,
    )
    errors = solution.fun[: 2 * len(r)].reshape(-1, 2)
    return solution.x.reshape(2, -1), float(solution.cost), np.sum(errors**2, axis=1)


def _least(prior: np.ndarray) -> np.ndarray:
    """Return standard deviations of the prior, of which 0 fixes a parameter."""
    return np.maximum(prior, 1e-9 * prior.max())


def _without_wild(legs: list[FlownLeg], is_far: np.ndarray) -> list[FlownLeg]:
    """Return legs without fixes between two far legs, or at the far end of a record."""
    right: list[FlownLeg] = []
    was_far = True  # before the record
    for leg, far in zip(legs, is_far, strict=True):
        before = right[-1] if right else None
        is_joined = before is not None and np.array_equal(before.end, leg.leg.place)
        if not (far and was_far and (is_joined or before is None)):
            right.append(leg)
        elif before is not None:
            path, rest = before.leg, leg.leg
            joined = replace(
                path, time=rest.time, stretches=path.way + rest.way, waiting=None
            )
            bend = float(np.hypot(before.bend, leg.bend))
            right[-1] = FlownLeg(joined, leg.end, bend)
            # the joined leg is judged in the next pass
            far = False
        was_far = bool(far)
    if len(right) == len(legs) and was_far:
        right.pop()
    return right


def _smoothed(
    chain: LegChain, settings: FixSettings, theta: np.ndarray, scale: float
) -> tuple[np.ndarray, np.ndarray, float]:
    """Return theta, covariances of its rows, and the factor on the noise that residuals show."""
    n, N = len(chain.places), theta.shape[1]
    rows, sd = np.arange(len(chain.links) + 1), _least(settings.prior)
    at_fix = np.isfinite(chain.fixes).ravel()
    of_fixes = eye_array(2 * n, format="csr")[at_fix] / settings.fix
    of_prior = diags_array(np.tile(1 / sd, 2))
    unknown = np.concatenate([theta.ravel(), chain.places.ravel()])

    def residuals(
        unknown: np.ndarray, slopes: bool, scale: float = scale
    ) -> tuple[np.ndarray, Any]:
        weight = 1 / (scale * chain.noise[:, None, None])
        theta, places = unknown[: 2 * N].reshape(2, N), unknown[2 * N :].reshape(n, 2)
        shot = chain.shoot(places[chain.links], theta, slopes)
        tracks = (places[chain.links + 1] - shot.z) * weight[:, 0]
        fixes = ((places - chain.fixes).ravel()[at_fix]) / settings.fix
        prior = ((theta - settings.theta) / sd).ravel()
        values = np.concatenate([tracks.ravel(), fixes, prior])
        if not slopes:
            return values, None
        size = 2 * len(chain.links), 2 * n
        by_begin = bsr_array((-weight * shot.by_place, chain.links, rows), shape=size)
        ones = np.broadcast_to(weight * np.eye(2), shot.by_place.shape)
        by_end = bsr_array((ones.copy(), chain.links + 1, rows), shape=size)
        by_theta = bsr_array((-weight * shot.by_theta).reshape(-1, 2 * N))
        jacobian = block_array(
            [[by_theta, by_begin + by_end], [None, of_fixes], [of_prior, None]]
        )
        return values, jacobian.tocsc()

    damping = 1e-3
    for _ in range(MOST):
        values, jacobian = residuals(unknown, slopes=True)
        normal, cost = (jacobian.T @ jacobian).tocsc(), values @ values
        step = np.zeros_like(unknown)
        for _ in range(12):
            damped = normal + damping * diags_array(normal.diagonal())
            step = -splu(damped.tocsc()).solve(jacobian.T @ values)
            after, _ = residuals(unknown + step, slopes=False)
            if after @ after <= cost * (1 + 1e-12):
                break
            damping = max(damping, 1e-9) * 6
        else:
            break
        damping = max(damping / 5, 1e-12)
        unknown = unknown + step
        if np.max(np.abs(step[: 2 * N]) / np.tile(sd, 2)) < SETTLED:
            break
    values, _ = residuals(unknown, slopes=False, scale=1.0)
    count = max(len(values) - len(unknown), 0)
    c = float(((values @ values + 4) / (count + 4)) ** 0.5)
    _, jacobian = residuals(unknown, slopes=True, scale=c)
    normal = (jacobian.T @ jacobian).tocsc()
    covariance = splu(normal).solve(np.eye(len(unknown), 2 * N))[: 2 * N]
    of_rows = covariance.reshape(2, N, 2, N)[[0, 1], :, [0, 1]]
    return unknown[: 2 * N].reshape(2, N), of_rows, c
