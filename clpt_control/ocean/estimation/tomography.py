"""Motion tomography: the flow from all recorded legs at once, tracks between fixes unknown.

Remark 3.2 of the paper names it as a source of theta.  The unknowns are theta and the place x_k at
each fix and node (`leg_chain`); the estimate minimises

    sum |x_{k+1} - z(x_k, theta)|^2/q_k^2     the tracks
    sum w_k |f_k - x_k|^2/s^2                 the fixes f_k, with w_k the probability of a right fix
    sum |theta - theta_0|^2/prior^2

in two stages.

1. Single shooting: each leg from its fix, with a robust cost (`scipy.optimize.least_squares`), from
   theta_0 and from the solution without it.  The lower cost is taken.
2. A smoother from there, by Gauss and Newton's method with Levenberg's damping.  Places are
   eliminated by a banded Cholesky factorisation, so the time is linear in the number of legs.  w_k
   follows from the distance of a fix to its forecast by all other fixes.

Noise that neighbouring legs share, that of their common fix, is thus taken as it is.  theta is
steady.

Sources: D. Chang, W. Wu, C. R. Edwards, F. Zhang, "Motion tomography: mapping flow fields using
autonomous underwater vehicles", Int. J. Robotics Research 36, 320-336, 2017; B. P. Russo, R.
Kamalapurkar, D. Chang, J. A. Rosenfeld, "Motion tomography via occupation kernels", 2021.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.linalg import solveh_banded
from scipy.optimize import least_squares

from .fix_settings import FixSettings
from .leg_chain import FlownLeg, LegChain, Shot, chain_of
from .leg_guesses import WILD, WRONG_SHARE
from .leg_track import LegTrack

ROBUST = (
    1.5  # position errors over their standard deviation, from which the cost is linear
)
MOST = 60  # evaluations of single shooting, and steps of the smoother
FAR = 14.0  # of |position error|^2 over its variance: the fixes of both its legs are suspected
SETTLED = 1e-5  # last step of theta, over the prior
LARGEST = 1.5  # factor c on the noise in the weights
FREEDOM = 8.0  # degrees of freedom of the density of a right fix
NEVER = 1e-9  # least weight of a fix
SAME = 1e-3  # relative difference of two costs
MUCH = 2.0  # factor c on the noise that is told


class Tomography(NamedTuple):
    """theta and its standard errors (2, N), factor c on the noise, weights of fixes, remarks,
    and the turn of the flow along each leg, rad.
    """

    theta: np.ndarray
    standard_error: np.ndarray
    scale: float
    weights: np.ndarray
    notes: list[str]
    turns: Sequence[float] = ()


def tomography(
    legs: Sequence[FlownLeg], settings: FixSettings, track: LegTrack
) -> Tomography:
    """Estimate theta from legs; the settings have prior, noise and first guess."""
    straight = chain_of(legs, settings, track, nodes=False)
    plain, _ = _single_shooting(straight, settings, settings.theta, "linear")
    tries = [
        _single_shooting(straight, settings, theta, "soft_l1")
        for theta in (settings.theta, plain)
    ]
    theta, cost = min(tries, key=lambda found: found[1])
    suspects, c = _suspects(straight, theta)
    chain = chain_of(legs, settings, track, nodes=True)
    smoother = Smoother(chain, settings, theta, suspects, c)
    smoother.settle()
    notes = []
    if max(cost for _, cost in tries) - cost > SAME * (1 + cost):
        notes.append(
            "tomography: two starts end at different costs, the lower one is taken. Record more "
            "legs, or legs that are shorter"
        )
    return smoother.result(notes)


def _single_shooting(
    chain: LegChain, settings: FixSettings, start: np.ndarray, loss: str
) -> tuple[np.ndarray, float]:
    """Return theta and the cost of nonlinear least squares of the legs from their fixes."""
    begin, ends = chain.places[chain.links], chain.fixes[chain.links + 1]
    r, sd = chain.deviation[:, None], np.tile(_least(settings.prior), 2)
    first = settings.theta.ravel()

    def residuals(p: np.ndarray) -> np.ndarray:
        z = chain.shoot(begin, p.reshape(2, -1), slopes=False).z
        return np.concatenate([((z - ends) / r).ravel(), (p - first) / sd])

    def jacobian(p: np.ndarray) -> np.ndarray:
        by_theta = chain.shoot(begin, p.reshape(2, -1)).by_theta / r[:, :, None]
        return np.vstack([by_theta.reshape(-1, len(p)), np.diag(1 / sd)])

    found = least_squares(
        *(residuals, start.ravel(), jacobian),
        x_scale=sd,
        loss=loss,
        f_scale=ROBUST,
        max_nfev=MOST,
    )
    return found.x.reshape(2, -1), float(found.cost)


def _least(prior: np.ndarray) -> np.ndarray:
    """Return standard deviations of the prior, of which 0 fixes a parameter."""
    return np.maximum(prior, 1e-9 * prior.max())


def _suspects(chain: LegChain, theta: np.ndarray) -> tuple[np.ndarray, float]:
    """Return numbers of fixes with wrong legs on both sides, and a first factor on the noise."""
    z = chain.shoot(chain.places[chain.links], theta, slopes=False).z
    off = np.sum((chain.fixes[chain.links + 1] - z) ** 2, axis=1) / chain.deviation**2
    square = max(float(np.median(off)) / np.log(4), 0.04)
    is_far = off > FAR * square
    as_end, as_start = np.ones((2, len(chain.places)), bool)
    as_end[chain.links + 1], as_start[chain.links] = is_far, is_far
    return np.flatnonzero(as_end & as_start), square**0.5


class Normal(NamedTuple):
    """Normal equations: blocks of theta, of places, between neighbours and of both; gradients."""

    of_theta: np.ndarray
    of_places: np.ndarray
    neighbours: np.ndarray
    of_both: np.ndarray
    theta_slope: np.ndarray
    place_slope: np.ndarray


@dataclass
class Smoother:
    """Least squares of theta and the places of a chain."""

    chain: LegChain
    settings: FixSettings
    theta: np.ndarray
    suspects: np.ndarray  # numbers of fixes
    scale: float

    def __post_init__(self) -> None:
        """Place the nodes on the predicted tracks."""
        is_fix = self.chain.is_fix
        doubted = np.zeros(len(is_fix), bool)
        doubted[np.flatnonzero(is_fix)[self.suspects]] = True
        self.scale = min(self.scale, LARGEST)
        self.weights = np.where(doubted, NEVER, is_fix.astype(float))
        self.places = self.chain.places
        if doubted.any():
            self.places = self.chain.predicted(self.theta, doubted)
        self.sd = _least(self.settings.prior)
        self.wild = (WILD / self.settings.metres) ** 2

    def settle(self) -> None:
        """Step until theta, weights and scale stay."""
        damping = 1e-3
        for _ in range(MOST):
            normal, cost = self._normal(self.scale)
            for _ in range(12):
                d_theta, d_places = self._solved(normal, damping)[:2]
                theta, places = self.theta + d_theta, self.places + d_places
                new = self._cost(theta, places)
                if np.isfinite(new) and new <= cost * (1 + 1e-12):
                    damping = max(damping / 5, 1e-12)
                    break
                damping = max(damping, 1e-9) * 6
            else:
                return
            self.theta, self.places = theta, places
            weights, scale = self.weights, self.scale
            self._weigh(normal)
            step = np.max(np.abs(d_theta) / self.sd)
            is_same = abs(self.scale / scale - 1) < 1e-2
            if (
                step < SETTLED
                and is_same
                and np.abs(self.weights - weights).max() < 1e-2
            ):
                return

    def result(self, notes: list[str]) -> Tomography:
        """Return the estimate, its errors with the scale of all residuals."""
        free = int(np.sum(self.settings.prior > 0))
        squares = self._cost(self.theta, self.places, 1.0)
        fixes = self.weights[self.chain.is_fix]
        count = 2 * max(float(fixes.sum()) - 1 - free, 0.0)
        c = ((squares + 4) / (count + 4)) ** 0.5
        *_, A, _ = self._solved(self._normal(c)[0], 0.0)
        variance = np.diag(np.linalg.inv(A)).reshape(self.theta.shape)
        if c > MUCH:
            notes.append(
                f"tomography: the legs fit only with {c:.1f} times the noise that is set"
            )
        return Tomography(self.theta, variance**0.5, c, fixes, notes)

    def _residuals(
        self, theta: np.ndarray, places: np.ndarray, c: float, slopes: bool = False
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, Shot]:
        """Return the residuals of tracks, fixes and prior, and the tracks."""
        chain, settings = self.chain, self.settings
        shot = chain.shoot(places[chain.links], theta, slopes=slopes)
        of_tracks = (places[chain.links + 1] - shot.z) / (c * chain.noise)[:, None]
        fixes = np.where(chain.is_fix[:, None], chain.fixes, 0.0)
        of_fixes = (places - fixes) * self.weights[:, None] ** 0.5 / settings.fix
        return of_tracks, of_fixes, (theta - settings.theta) / self.sd, shot

    def _cost(
        self, theta: np.ndarray, places: np.ndarray, c: float | None = None
    ) -> float:
        """Return the sum of squares."""
        parts = self._residuals(theta, places, self.scale if c is None else c)[:3]
        return float(sum(np.sum(part**2) for part in parts))

    def _normal(self, c: float) -> tuple[Normal, float]:
        """Return the normal equations, and the sum of squares."""
        chain, n = self.chain, len(self.places)
        a, b, p, shot = self._residuals(self.theta, self.places, c, slopes=True)
        inverse = 1 / (c * chain.noise)
        by_theta = -shot.by_theta * inverse[:, None, None]
        by_place = -shot.by_place * inverse[:, None, None]
        begin, end = chain.links, chain.links + 1
        precision = self.weights / self.settings.fix**2
        of_places = precision[:, None, None] * np.eye(2)
        neighbours = np.zeros((n, 2, 2))
        of_both = np.zeros((n, 2, 2 * self.theta.shape[1]))
        place_slope = b * self.weights[:, None] ** 0.5 / self.settings.fix
        np.add.at(of_places, begin, np.einsum("kai,kaj->kij", by_place, by_place))
        np.add.at(of_places, end, inverse[:, None, None] ** 2 * np.eye(2))
        neighbours[begin] = np.swapaxes(by_place, 1, 2) * inverse[:, None, None]
        np.add.at(of_both, begin, np.einsum("kai,kaj->kij", by_place, by_theta))
        np.add.at(of_both, end, by_theta * inverse[:, None, None])
        np.add.at(place_slope, begin, np.einsum("kai,ka->ki", by_place, a))
        np.add.at(place_slope, end, a * inverse[:, None])
        of_theta = np.einsum("kai,kaj->ij", by_theta, by_theta)
        of_theta += np.diag(np.tile(1 / self.sd**2, 2))
        theta_slope = np.einsum("kai,ka->i", by_theta, a) + (p / self.sd).ravel()
        cost = float(np.sum(a**2) + np.sum(b**2) + np.sum(p**2))
        normal = Normal(
            *(of_theta, of_places, neighbours, of_both, theta_slope, place_slope)
        )
        return normal, cost

    def _solved(
        self, normal: Normal, damping: float
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Return the steps of theta and places, the precision of theta, and dx/dtheta."""
        n, size = len(self.places), normal.of_theta.shape[0]
        D, E = normal.of_places, normal.neighbours
        band = np.zeros((4, 2 * n))  # lower
        band[0] = (np.einsum("kii->ki", D) * (1 + damping)).ravel()
        band[1, 0::2] = D[:, 1, 0]
        band[1, 1:-1:2] = E[:-1, 1, 0]
        band[2, 0:-2:2] = E[:-1, 0, 0]
        band[2, 1:-2:2] = E[:-1, 1, 1]
        band[3, 0:-3:2] = E[:-1, 0, 1]
        coupling = normal.of_both.reshape(2 * n, -1)
        columns = np.column_stack([coupling, normal.place_slope.ravel()])
        found = solveh_banded(band, columns, lower=True)
        response, own = found[:, :-1], found[:, -1]
        damped = normal.of_theta + damping * np.diag(np.diag(normal.of_theta))
        precision = damped - coupling.T @ response
        step = -np.linalg.solve(precision, normal.theta_slope - coupling.T @ own)
        places = -(own + response @ step)
        return (
            step.reshape(2, size // 2),
            places.reshape(n, 2),
            precision,
            response.reshape(n, 2, size),
        )

    def _weigh(self, normal: Normal) -> None:
        """Weigh each fix by its forecast from all others; scale the noise by the median leg."""
        fixes, variance = np.flatnonzero(self.chain.is_fix), self.settings.fix**2
        *_, precision, response = self._solved(normal, 0.0)
        C = _diagonal_of_inverse(normal.of_places, normal.neighbours)[fixes]
        response = response[fixes]
        C += response @ np.linalg.inv(precision) @ np.swapaxes(response, 1, 2)
        # without the fix itself
        information = np.linalg.inv(C)
        own = self.weights[fixes] / variance
        size = np.trace(information, axis1=1, axis2=2)
        others = information - (own - NEVER * size)[:, None, None] * np.eye(2)
        forecast_covariance = np.linalg.inv(others)
        pulled = np.einsum("kab,kb->ka", information, self.places[fixes])
        pulled -= own[:, None] * self.chain.fixes[fixes]
        forecast = np.einsum("kab,kb->ka", forecast_covariance, pulled)
        off = self.chain.fixes[fixes] - forecast
        right = forecast_covariance + variance * np.eye(2)
        wrong = right + self.wild * np.eye(2)
        log_right = -(FREEDOM + 2) / 2 * np.log1p(_square(off, right) / FREEDOM)
        log_right -= np.log(np.linalg.det(right)) / 2
        log_wrong = np.log(WRONG_SHARE) - np.log(np.linalg.det(wrong)) / 2
        log_wrong = log_wrong - _square(off, wrong) / 2
        odds = np.exp(np.clip(log_wrong - log_right, -50, 50))
        self.weights[fixes] = np.maximum(1 / (1 + odds), NEVER)
        # the median is not moved by wrong legs
        of_tracks = self._residuals(self.theta, self.places, 1.0)[0]
        left = np.bincount(self.chain.leg_of, np.sum(of_tracks**2, axis=1))
        n, free = len(left), int(np.sum(self.settings.prior > 0))
        middle = float(np.median(left)) / np.log(4) * n / max(n - free, n / 2)
        square = (2 * n * middle + 4) / (2 * n + 4)
        self.scale = float(np.clip(square**0.5, 0.2, LARGEST))


def _square(off: np.ndarray, covariance: np.ndarray) -> np.ndarray:
    """Return off^T covariance^-1 off, (n,)."""
    return np.einsum("ka,kab,kb->k", off, np.linalg.inv(covariance), off)


def _diagonal_of_inverse(D: np.ndarray, E: np.ndarray) -> np.ndarray:
    """Return the blocks on the diagonal of the inverse of a block tridiagonal matrix, (n, 2, 2)."""
    n = len(D)
    forward, backward = D.copy(), D.copy()
    for k in range(1, n):
        forward[k] -= E[k - 1].T @ np.linalg.inv(forward[k - 1]) @ E[k - 1]
    for k in range(n - 2, -1, -1):
        backward[k] -= E[k] @ np.linalg.inv(backward[k + 1]) @ E[k].T
    return np.linalg.inv(forward + backward - D)
