"""What moved a vehicle between two fixes: the regression all estimators share.

    x(t2) - x(t1) = f R(psi) int v dt + theta int phi(x, t) dt + noise

the integral of Eq. (1) with the flow of Eq. (3); int v dt is the dead-reckoned
displacement d, f a factor on speed through water, R(psi) a compass error.
Less d on both sides and to first order in f - 1 and psi it is linear, y = H p.
The columns of H stand in `fix_regressor`; parameters that a dive cannot tell
are held (`held`).  Gaussian places (`gaussian_places`) join the parameters when
a track first comes near them, so that n grows.
"""

import math
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np

from ..errors import ScenarioError
from ..scenario.tides import SPEEDS, period
from .fix_regressor import (
    inertial,
    inertial_frequency,
    mid_time,
    miss,
    model_way,
    ones,
    tide,
    water,
)
from .gaussian_places import Places, near, way_over_places

__all__ = ["FixModel", "mid_time", "miss"]

CURRENT, TIDE, INERTIAL = 0.3, 0.1, 0.05  # m/s, standard deviation before any dive
GAUSSIAN = 0.15  # m/s, the same of a place's coefficient
MODEL = 0.7  # the same of the factor on a flow model
SPEED, COMPASS = 0.15, 0.03  # the same of f - 1 and of psi (2 degrees)
FIX = 30.0  # m, one component of the difference of two fixes
FAR = 13.82  # chi-squared of two components, 99.9 %: what lies beyond is strange
WIDTH = 20e3  # m, of a gaussian
OTHERS = {"inertial": 2, "gaussians": 0, "model": 1}  # parts that are no tide; their parameters


def fix_variance(dive: Any, unexplained: Any) -> Any:
    """Return the variance of one component of y, m^2.

    Parameters
    ----------
    dive : Dive
        Its duration T is used.
    unexplained : float or ndarray
        s, of a current that no parameter explains, m/s.

    Returns
    -------
    float or ndarray
        FIX^2 + (s T)^2.
    """
    return FIX**2 + (unexplained * dive.duration) ** 2


@dataclass(frozen=True)
class FixModel:
    """Parameters of the motion between fixes.

    Attributes
    ----------
    flow : tuple of str
        ``"steady"``, then any of ``"inertial"``, ``"gaussians"``, ``"model"`` (a
        factor on the dives' flow model) and constituents such as ``"M2"``.
    learn_speed : bool
        Whether a factor on speed and a compass error are parameters too.
    width : float
        Of the gaussians, m.
    places : Places or None
        Where gaussians stand so far; None before the first dive.

    Examples
    --------
    >>> FixModel(("steady",)).names
    ('current_east', 'current_north', 'speed', 'compass')
    """

    flow: tuple[str, ...] = ("steady", "M2", "inertial")
    learn_speed: bool = True
    width: float = WIDTH
    places: Places | None = None

    def __post_init__(self) -> None:
        """Refuse flows that cannot be."""
        known = ("steady", *OTHERS, *SPEEDS)
        for name in self.flow:
            if name not in known:
                meant = [k for k in known if k.casefold() == name.strip().casefold()]
                raise ScenarioError(
                    f"flow {','.join(self.flow) or 'empty'}: unknown constituent '{name}'"
                    f"{' (did you mean ' + meant[0] + '?)' if meant else ''}: must be one of "
                    f"{', '.join(known)}"
                )
        if not self.flow or self.flow[0] != "steady" or len(set(self.flow)) < len(self.flow):
            raise ScenarioError(
                f"flow {','.join(self.flow) or 'empty'}: must begin with steady and name each "
                "part once, such as steady,M2,inertial"
            )
        if not (math.isfinite(self.width) and self.width > 0):
            raise ScenarioError(f"width of the gaussians = {self.width} m: must be positive")

    @property
    def sizes(self) -> list[int]:
        """Numbers of parameters of the parts after the steady one."""
        return [OTHERS.get(part, 4) for part in self.flow[1:]]

    @property
    def moving(self) -> int:
        """Number of parameters before those of the gaussians."""
        return 2 + sum(self.sizes) + 2 * self.learn_speed

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the n parameters, in their order."""
        names = ["current_east", "current_north"]
        for part in self.flow[1:]:
            if part == "model":
                names.append(part)
            elif part != "gaussians":
                middle = [""] if part == "inertial" else ["_cos", "_sin"]
                names += [f"{part}{m}_{axis}" for m in middle for axis in ("east", "north")]
        if self.learn_speed:
            names += ["speed", "compass"]
        cells = self.places.cells if self.places else ()
        return (*names, *(f"gaussian[{i},{j}]_{a}" for i, j in cells for a in ("east", "north")))

    @property
    def prior_sd(self) -> np.ndarray:
        """Standard deviations before any dive, (n,), m/s, 1 and rad."""
        sd = [CURRENT] * 2
        for part in self.flow[1:]:
            usual = {"inertial": INERTIAL, "model": MODEL}.get(part, TIDE)
            sd += [usual] * OTHERS.get(part, 4)
        sd += [SPEED, COMPASS] if self.learn_speed else []
        return np.array(sd + [GAUSSIAN] * (2 * len(self.places.cells) if self.places else 0))

    def choices(self) -> np.ndarray:
        """Return the models a bank compares: flow parts on or off.

        All tides together are one part: a sea is a shelf's or it is not.

        Returns
        -------
        ndarray of bool, shape (2^k, moving + 1)
            Which parameters are present, the last for all gaussians; steady
            current and speed always are.

        Examples
        --------
        >>> FixModel(("steady", "inertial"), False).choices().astype(int)
        array([[1, 1, 0, 0, 0],
               [1, 1, 1, 1, 0]])
        """
        kinds = [part if part in OTHERS else "tides" for part in self.flow[1:]]
        rows = []
        for pattern in product((False, True), repeat=len(set(kinds))):
            on = dict(zip(dict.fromkeys(kinds), pattern, strict=True))
            flow = sum(([on[p]] * k for p, k in zip(kinds, self.sizes, strict=True)), [True, True])
            rows.append([*flow, *[True] * (2 * self.learn_speed), on.get("gaussians", False)])
        return np.array(rows)

    def reached(self, dive: Any) -> "FixModel":
        """Return the model with the places that a dive comes near.

        Parameters
        ----------
        dive : Dive
            Its start and dead reckoning are used, never its end.

        Returns
        -------
        FixModel
            Itself where nothing is new; new parameters come last, and places
            that are far by now may be gone.
        """
        if "gaussians" not in self.flow:
            return self
        places = near(self.places, dive, self.width)
        return self if places is self.places else replace(self, places=places)

    def kept(self, before: "FixModel") -> tuple[np.ndarray, np.ndarray]:
        """Return where the parameters of a model before stand in this one.

        Parameters
        ----------
        before : FixModel
            Whose `reached` gave this one.

        Returns
        -------
        old, new : ndarray of int
            Places in its parameters and in these.
        """
        here = {name: k for k, name in enumerate(self.names)}
        pairs = [(k, here[name]) for k, name in enumerate(before.names) if name in here]
        old, new = np.array(pairs, int).T
        return old, new

    def regressor(self, dive: Any, ended: bool = False) -> np.ndarray:
        """Return H of y = H p for a dive.

        Parameters
        ----------
        dive : Dive
            Its times, latitude and dead reckoning are used, its end only
        ended : bool, optional
            where this is True: gaussians are taken along the track as bent to
            the fix after the dive.

        Returns
        -------
        ndarray, shape (2, n)
            In s for currents, m for speed, compass and model.
        """
        columns = [ones(dive)]
        for part in self.flow[1:]:
            if part == "inertial":
                columns.append(inertial(dive))
            elif part == "model":
                columns.append(model_way(dive))
            elif part != "gaussians":
                columns.append(tide(dive, 2 * math.pi / period(part, "s")))
        if self.learn_speed:
            columns.append(water(dive))
        if self.places:
            columns.append(way_over_places(self.places, dive, ended))
        return np.hstack(columns)

    def turning(self, dt: float, latitude: float) -> np.ndarray:
        """Return the rotation of the moving parameters over a time.

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
