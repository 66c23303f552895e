"""What moved a vehicle between two fixes: the regression all estimators share.

    x(t2) - x(t1) = f R(psi) int v dt + theta int phi(t) dt + noise

the integral of Eq. (1) with the flow of Eq. (3); int v dt is the dead-reckoned
displacement d, f a factor on speed through water, R(psi) a compass error.
Less d on both sides and to first order in f - 1 and psi it is linear, y = H p:

    steady current      T                             two parameters, m/s
    tide, speed w       T s(w) cos(w tm), T s(w) sin(w tm)    four, m/s
    inertial current    T s(c)                        two, m/s, at mid-dive
    speed               (d_east, d_north)             f - 1
    compass             (d_north, -d_east)            psi, rad, clockwise

with T the duration, tm mid-dive, s(w) = sin(w T/2)/(w T/2).  Between dives the
inertial current turns by -c dt, c = 2 Omega sin(latitude) (A. E. Gill,
"Atmosphere-Ocean Dynamics", 1982, section 8.3) and fades in some days.
"""

import math
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

from ..errors import ScenarioError
from ..tides import period

ROTATION = 7.292115e-5  # rad/s, of the Earth
QUARTER_DAY = 21600.0  # s
FADING = 4 * 86400.0  # s, of an inertial oscillation
CURRENT, TIDE, INERTIAL = 0.3, 0.1, 0.05  # m/s, standard deviation before any dive
SPEED, COMPASS = 0.15, 0.03  # the same of f - 1 and of psi (2 degrees)
SPEED_WALK = 0.002  # per sqrt(6 h): a factor changes by 0.04 in 100 days
FIX = 30.0  # m, one component of the difference of two fixes
LEARNED = 0.5  # a parameter is learned when dives have halved its variance


@dataclass(frozen=True)
class FixModel:
    """Parameters of the motion between fixes.

    Attributes
    ----------
    flow : tuple of str
        ``"steady"``, ``"inertial"`` and constituents such as ``"M2"``.
    learn_speed : bool
        Whether a factor on speed and a compass error are parameters too.

    Examples
    --------
    >>> FixModel(("steady",)).names
    ('current_east', 'current_north', 'speed', 'compass')
    """

    flow: tuple[str, ...] = ("steady", "M2", "inertial")
    learn_speed: bool = True

    def __post_init__(self) -> None:
        """Refuse flows that cannot be."""
        for name in self.flow:
            if name != "inertial":
                period(name)
        if not self.flow or self.flow[0] != "steady" or len(set(self.flow)) < len(self.flow):
            raise ScenarioError(
                f"flow {','.join(self.flow) or 'empty'}: must begin with steady and name each "
                "part once, such as steady,M2,inertial"
            )

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the n parameters, in their order."""
        names = ["current_east", "current_north"]
        for part in self.flow[1:]:
            middle = [""] if part == "inertial" else ["_cos", "_sin"]
            names += [f"{part}{m}_{axis}" for m in middle for axis in ("east", "north")]
        return (*names, "speed", "compass") if self.learn_speed else tuple(names)

    @property
    def prior_sd(self) -> np.ndarray:
        """Standard deviations before any dive, shape (n,), m/s, 1 and rad."""
        sd = [CURRENT] * 2
        for part in self.flow[1:]:
            sd += [INERTIAL] * 2 if part == "inertial" else [TIDE] * 4
        return np.array(sd + ([SPEED, COMPASS] if self.learn_speed else []))

    def choices(self) -> np.ndarray:
        """Give the models a bank compares: flow parts on or off.

        Returns
        -------
        ndarray of bool, shape (2^k, n)
            Which parameters are present; steady current and speed always are.

        Examples
        --------
        >>> FixModel(("steady", "inertial"), False).choices().astype(int)
        array([[1, 1, 0, 0],
               [1, 1, 1, 1]])
        """
        parts = [2 if part == "inertial" else 4 for part in self.flow[1:]]
        speed = [True, True] if self.learn_speed else []  # no vehicle knows its speed exactly
        rows = [
            sum(([on] * size for on, size in zip(pattern, parts, strict=True)), [True, True])
            + speed
            for pattern in product((False, True), repeat=len(parts))
        ]
        return np.array(rows)

    def regressor(self, dive: Any) -> np.ndarray:
        """Give H of y = H p for a dive.

        Parameters
        ----------
        dive : Dive
            Its times, latitude and dead reckoning are used, never its end.

        Returns
        -------
        ndarray, shape (2, n)
            In s for currents, m for speed and compass.
        """
        T, eye = dive.duration, np.eye(2)
        columns = [T * eye]
        for part in self.flow[1:]:
            inertial = part == "inertial"
            w = inertial_frequency(dive.lat_gps2) if inertial else 2 * math.pi / period(part, "s")
            mean = T * float(np.sinc(w * T / (2 * math.pi)))
            turn = w * mid_time(dive)
            columns += [mean * eye] if inertial else [
                mean * math.cos(turn) * eye, mean * math.sin(turn) * eye
            ]  # fmt: skip
        if self.learn_speed:
            columns.append(
                np.array([[dive.dr_east, dive.dr_north], [dive.dr_north, -dive.dr_east]])
            )
        return np.hstack(columns)

    def turning(self, dt: float, latitude: float) -> np.ndarray:
        """Give the rotation of the parameters over a time.

        Parameters
        ----------
        dt : float
            Time from mid-dive to mid-dive, s.
        latitude : float
            Degrees.

        Returns
        -------
        ndarray, shape (n, n)
            Orthogonal; the identity but for the inertial current.
        """
        F = np.eye(len(self.names))
        if "inertial" in self.flow:
            k, angle = self.names.index("inertial_east"), inertial_frequency(latitude) * dt
            c, s = math.cos(angle), math.sin(angle)
            F[k : k + 2, k : k + 2] = [[c, s], [-s, c]]
        return F


def mid_time(dive: Any) -> float:
    """Give the middle of a dive, UTC, s."""
    return 0.5 * (dive.t_gps2 + dive.t_gpse)


def miss(dive: Any) -> np.ndarray:
    """Give y, fix less dead reckoning at a dive's end, m, shape (2,)."""
    return np.array([dive.miss_east, dive.miss_north])


def inertial_frequency(latitude: float) -> float:
    """Give the Coriolis frequency, rad/s.

    Parameters
    ----------
    latitude : float
        Degrees, positive north.

    Returns
    -------
    float
        2 Omega sin(latitude): positive turns clockwise.

    Examples
    --------
    >>> round(2 * math.pi / inertial_frequency(30.0) / 3600, 2)
    23.93
    """
    return 2 * ROTATION * math.sin(math.radians(latitude))


def hold(
    mean: np.ndarray, P: np.ndarray, prior_sd: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Hold what the dives do not excite at its prior value.

    A parameter is learned when its variance is below `LEARNED` of the prior's,
    that is when the Gramian of the dives (as P holds it) tells more about it
    than was known before.  The others, h, return to zero with their prior
    variance, and the learned, l, are what they would be had h been zero:
    m_l - P_lh P_hh^-1 m_h.

    Parameters
    ----------
    mean : ndarray, shape (m, n)
        Estimates of m filters.
    P : ndarray, shape (m, n, n)
        Their covariances.
    prior_sd : ndarray, shape (m, n)
        Standard deviations before any dive.

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
        P[np.ix_(which, keep, h)] = -back @ prior
        P[np.ix_(which, h, keep)] = -(back @ prior).transpose(0, 2, 1)
        mean[np.ix_(which, h)] = 0.0
        P[np.ix_(which, h, h)] = prior
    return mean, P, learned
