"""What moved a vehicle between two fixes: the regression all estimators share.

    x(t2) - x(t1) = f R(psi) int v dt + theta int phi(x, t) dt + noise

the integral of Eq. (1) with the flow of Eq. (3); int v dt is the dead-reckoned
displacement d, f a factor on speed through water, R(psi) a compass error.
Less d on both sides and to first order in f - 1 and psi it is linear, y = H p.
Gaussian places (`gaussian_places`) join the parameters when a track first comes near
them, so that n grows.

The columns of H, what one unit of a parameter does:

    steady current      T                             two parameters, m/s
    tide, speed w       T s(w) cos(w tm), T s(w) sin(w tm)    four, m/s
    inertial current    T s(c)                        two, m/s, at mid-dive
    flow model          its displacement (east, north)    one, a factor
    speed               (d_east, d_north)             f - 1
    compass             (d_north, -d_east)            psi, rad, clockwise

with T the duration, tm mid-dive, d the dead reckoning and s(w) = sin(w T/2)/(w T/2),
the mean of a tide over a dive.  Between dives the inertial current turns by
-c dt, c = 2 Omega sin(latitude) (A. E. Gill, "Atmosphere-Ocean Dynamics", 1982,
section 8.3).
"""

import math
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Any

import numpy as np

from ..arguments import public
from ..errors import ScenarioError
from ..scenario.tides import SPEEDS, period
from .dive import Dive, mid_time
from .gaussian_places import WIDTH, Places, near, places_columns
from .priors import Priors

FAR = 13.82  # chi-squared of two components, 99.9 %: what lies beyond is strange
ROTATION = 7.292115e-5  # rad/s, of the Earth
OTHERS = ("inertial", "gaussians", "model")  # parts that are no tide


def inertial_frequency(latitude: float) -> float:
    """Return the Coriolis frequency at a latitude (degrees), rad/s: positive turns clockwise."""
    return 2 * ROTATION * math.sin(math.radians(latitude))


def swing(dive: Dive, w: float) -> float:
    """Return T s(w), s: how far an oscillation of unit size at mid-dive carries; w in rad/s."""
    T = dive.duration
    return T * float(np.sinc(w * T / (2 * math.pi)))


@public
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
    priors : Priors
        What is believed before any dive.

    Examples
    --------
    >>> FixModel(("steady",)).names
    ('current_east', 'current_north', 'speed', 'compass')
    """

    flow: tuple[str, ...] = ("steady", "M2", "inertial")
    learn_speed: bool = True
    width: float = WIDTH
    places: Places | None = None
    priors: Priors = field(default_factory=Priors)

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
            raise ScenarioError(
                f"width of the gaussians (--width-km) = {self.width:g} m: must be positive"
            )

    @property
    def table(self) -> tuple[tuple[str, str, float], ...]:
        """Name, part and prior standard deviation of each parameter."""
        axes, p = ("east", "north"), self.priors
        rows = [(f"current_{axis}", "current", p.current) for axis in axes]
        for part in self.flow[1:]:
            if part == "model":
                rows.append((part, part, p.model))
            elif part == "inertial":
                rows += [(f"{part}_{axis}", part, p.inertial) for axis in axes]
            elif part != "gaussians":
                pairs = product(("cos", "sin"), axes)
                rows += [(f"{part}_{wave}_{axis}", "tides", p.tide) for wave, axis in pairs]
        if self.learn_speed:
            rows += [("speed", "speed", p.speed), ("compass", "compass", p.compass)]
        for i, j in self.places.cells if self.places else ():
            rows += [(f"gaussian[{i},{j}]_{axis}", "gaussians", p.gaussian) for axis in axes]
        return tuple(rows)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the n parameters, in their order."""
        return tuple(name for name, _, _ in self.table)

    @property
    def parts(self) -> tuple[str, ...]:
        """Part of each of the n parameters; all tides are one part."""
        return tuple(part for _, part, _ in self.table)

    @property
    def prior_sd(self) -> np.ndarray:
        """Standard deviations before any dive, (n,), m/s, 1 and rad."""
        return np.array([sd for _, _, sd in self.table])

    @property
    def moving(self) -> int:
        """Number of parameters before those of the gaussians."""
        return sum(part != "gaussians" for part in self.parts)

    @property
    def optional(self) -> tuple[str, ...]:
        """Parts that a sea may lack; all tides come or go together."""
        return tuple(dict.fromkeys(p if p in OTHERS else "tides" for p in self.flow[1:]))

    def choices(self) -> np.ndarray:
        """Return all choices of the k optional parts, (2^k, k)."""
        k = len(self.optional)
        return np.array(list(product((False, True), repeat=k)), bool).reshape(2**k, k)

    def reached(self, dive: Dive) -> "FixModel":
        """Return the model with the places that a dive comes near.

        Its end is not read.  New parameters come last, far places may be gone;
        where nothing is new it is the model itself.
        """
        if "gaussians" not in self.flow:
            return self
        places = near(self.places, dive, self.width)
        return self if places is self.places else replace(self, places=places)

    def matched(self, before: "FixModel") -> tuple[np.ndarray, np.ndarray]:
        """Return where parameters stood in a model before, and now."""
        here = {name: k for k, name in enumerate(self.names)}
        pairs = [(k, here[name]) for k, name in enumerate(before.names) if name in here]
        old, new = np.array(pairs, int).T
        return old, new

    def regressor(self, dive: Dive, ended: bool = False) -> np.ndarray:
        """Return H of y = H p for a dive, (2, n).

        Its columns are in s for currents, in m for the others. A dive's end is read
        only where it has `ended`: for gaussians along the bent track.
        """
        one = np.eye(2)
        columns = [dive.duration * one]
        for part in self.flow[1:]:
            if part == "inertial":
                columns.append(swing(dive, inertial_frequency(dive.lat_gps2)) * one)
            elif part == "model":  # zero where it does not cover the dive
                columns.append(np.array([[dive.model_east or 0.0], [dive.model_north or 0.0]]))
            elif part != "gaussians":
                w = 2 * math.pi / period(part, "s")
                turn = w * mid_time(dive)
                waves = [math.cos(turn) * one, math.sin(turn) * one]
                columns.append(swing(dive, w) * np.hstack(waves))
        if self.learn_speed:
            d = dive.dr_east, dive.dr_north
            columns.append(np.array([d, (d[1], -d[0])]))
        if self.places:
            columns.append(places_columns(self.places, dive, ended))
        return np.hstack(columns)

    def noise(self, dive: Dive, scatter: Any) -> Any:
        """Return FIX^2 + doubt^2 + (s T)^2, the variance of y, m^2."""
        return self.priors.fix**2 + dive.doubt**2 + (scatter * dive.duration) ** 2

    def turning(self, dt: float, latitude: float) -> np.ndarray:
        """Return the turn of the inertial current over `dt` s, (n, n)."""
        F = np.eye(len(self.names))
        if "inertial" in self.flow:
            k, angle = self.names.index("inertial_east"), inertial_frequency(latitude) * dt
            c, s = math.cos(angle), math.sin(angle)
            F[k : k + 2, k : k + 2] = [[c, s], [-s, c]]
        return F

    def faded(self, dt: float) -> np.ndarray:
        """Return what is left of each parameter after `dt` s, (n,)."""
        left = {
            "inertial": math.exp(-dt / self.priors.inertial_fading),
            "tides": math.exp(-dt / self.priors.tide_fading),
        }
        return np.array([left.get(part, 1.0) for part in self.parts])
