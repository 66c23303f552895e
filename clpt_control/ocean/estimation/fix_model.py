"""Regression of the displacement between two fixes that all estimators share.

The displacement of a vehicle between two fixes is

    x(t2) - x(t1) = f R(psi) int v dt + theta int phi(x, t) dt + noise

the integral of Eq. (1) with the flow of Eq. (3). int v dt is the dead-reckoned displacement d, f a
factor on the speed through the water, R(psi) a compass error. With d subtracted on both sides the
equation is linear, y = H p, in f cos psi and f sin psi.

The columns of H, the displacement by one unit of a parameter, are

    steady current      T                             two parameters, m/s
    tide, speed w       T s(w) cos(w tm), T s(w) sin(w tm)    four, m/s
    inertial current    T s(c)                        two, m/s, at mid-dive
    shear               T log(depth / 100 m)          two, m/s, each e times as deep
    flow model          its displacement (east, north)    one, a factor
    speed               (d_east, d_north)             f cos psi - 1
    compass             (d_north, -d_east)            f sin psi, psi clockwise

with T the duration, tm mid-dive, and s(w) = sin(w T/2)/(w T/2), the mean of a tide over a dive.
Between dives the inertial current rotates by -c dt, c = 2 Omega sin(latitude) (A. E. Gill,
"Atmosphere-Ocean Dynamics", 1982, section 8.3).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from ...base.errors import ScenarioError
from ...paper.scenario.tidal_periods import SPEEDS, period
from .dive import Dive
from .priors import Priors

FAR = 13.82  # chi-squared of two components, 99.9 %
SHALLOW = 100.0  # m, where shear is zero
ROTATION = 7.292115e-5  # rad/s, of the Earth
OTHERS = ("inertial", "shear", "gaussians", "model")  # parts that are no tide
FLOW = ("steady", "M2", "inertial")  # default parts


def inertial_frequency(latitude: float) -> float:
    """Return the Coriolis frequency at a latitude (degrees), rad/s: positive turns clockwise."""
    return 2 * ROTATION * math.sin(math.radians(latitude))


def swing(dive: Dive, w: float) -> float:
    """Return T s(w), s, the displacement by an oscillation of 1 m/s; w in rad/s."""
    T = dive.duration
    return T * float(np.sinc(w * T / (2 * math.pi)))


def leg_variance(of_fixes: float, scatter: Any, duration: float) -> Any:
    """Return the variance of y: that of both fixes, and (s T)^2 of a flow that is not modelled."""
    return of_fixes + (scatter * duration) ** 2


class Term(NamedTuple):
    """Parameters of one part of the motion, their prior and memory.

    `columns` returns those of H, (2, k), for a dive.
    """

    name: str
    parameters: tuple[str, ...]
    sd: float
    memory: float  # s
    columns: Callable[[Dive], np.ndarray]


def _axes(name: str) -> tuple[str, str]:
    return f"{name}_east", f"{name}_north"


def steady(dive: Dive) -> np.ndarray:
    """Return the columns of a current that stays."""
    return dive.duration * np.eye(2)


def inertial(dive: Dive) -> np.ndarray:
    """Return the columns of the inertial current at mid-dive."""
    return swing(dive, inertial_frequency(dive.lat_gps2)) * np.eye(2)


def shear(dive: Dive) -> np.ndarray:
    """Return the columns of the current's change with depth; zero where that is not known."""
    deep = dive.depth_max or 0.0
    folds = math.log(max(deep / SHALLOW, 0.1)) if deep > 0 else 0.0
    return dive.duration * folds * np.eye(2)


def modelled(dive: Dive) -> np.ndarray:
    """Return the column of a flow model; zero where it does not cover the dive."""
    return np.array([[dive.model_east or 0.0], [dive.model_north or 0.0]])


def tide(name: str, dive: Dive) -> np.ndarray:
    """Return the columns of a tide by its name."""
    w = 2 * math.pi / period(name, "s")
    phase = w * dive.mid_time
    c, s = math.cos(phase), math.sin(phase)
    return swing(dive, w) * np.array([[c, 0.0, s, 0.0], [0.0, c, 0.0, s]])


def speed_column(dive: Dive) -> np.ndarray:
    """Return the column of the speed."""
    return np.array([[dive.dr_east], [dive.dr_north]])


def compass_column(dive: Dive) -> np.ndarray:
    """Return the column of the compass."""
    return np.array([[dive.dr_north], [-dive.dr_east]])


@dataclass(frozen=True)
class FixModel:
    """Parameters of the motion between fixes.

    Attributes
    ----------
    flow : tuple of str
        ``"steady"``, then any of ``"inertial"``, ``"shear"``, ``"gaussians"`` (a steady current
        that depends on position), ``"model"`` (a factor on the dives' flow model) and
        constituents such as ``"M2"``.
    learn_speed : bool
        Whether a factor on speed and a compass error are parameters too.
    priors : Priors
        Standard deviations and memories before any dive.

    >>> FixModel(("steady",)).names
    ('current_east', 'current_north', 'speed', 'compass')
    """

    flow: tuple[str, ...] = FLOW
    learn_speed: bool = True
    priors: Priors = field(default_factory=Priors)

    def __post_init__(self) -> None:
        """Reject invalid flows."""
        known_parts = (*OTHERS, *SPEEDS)
        optional_parts = self.flow[1:]
        if (
            self.flow[:1] != ("steady",)
            or {*optional_parts} - {*known_parts}
            or len({*optional_parts}) < len(optional_parts)
        ):
            raise ScenarioError(
                f"flow {','.join(self.flow) or 'empty'}: must begin with steady, then name some of "
                f"{', '.join(known_parts)}, each once"
            )

    @cached_property
    def terms(self) -> tuple[Term, ...]:
        """The terms, in the order of the parameters."""
        p = self.priors
        current = Term("current", _axes("current"), p.current, math.inf, steady)
        fading = p.inertial_fading
        choice = {
            "steady": [current],
            "inertial": [
                Term("inertial", _axes("inertial"), p.inertial, fading, inertial)
            ],
            "shear": [Term("shear", _axes("shear"), p.shear, math.inf, shear)],
            "model": [Term("model", ("model",), p.model, math.inf, modelled)],
            "gaussians": [],
        }
        terms = []
        for name in self.flow:
            terms += choice[name] if name in choice else [self._tide(name)]
        if self.learn_speed:
            fading, compass_fading = p.speed_fading, p.compass_fading
            terms += [
                Term("speed", ("speed",), p.speed, fading, speed_column),
                Term(
                    "compass", ("compass",), p.compass, compass_fading, compass_column
                ),
            ]
        return tuple(terms)

    def _tide(self, name: str) -> Term:
        """Return the term of a tide."""
        names = _axes(f"{name}_cos") + _axes(f"{name}_sin")
        columns = partial(tide, name)
        return Term("tides", names, self.priors.tide, self.priors.tide_fading, columns)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the n parameters, in their order."""
        return tuple(name for term in self.terms for name in term.parameters)

    @cached_property
    def parts(self) -> tuple[str, ...]:
        """Part of each of the n parameters; all tides are one part."""
        return tuple(term.name for term in self.terms for _ in term.parameters)

    @cached_property
    def prior_sd(self) -> np.ndarray:
        """Standard deviations before any dive, (n,), m/s, 1 and rad."""
        return np.array([term.sd for term in self.terms for _ in term.parameters])

    @cached_property
    def optional(self) -> tuple[str, ...]:
        """Parts that a sea may not have; all tides are one part."""
        return tuple(
            dict.fromkeys(p if p in OTHERS else "tides" for p in self.flow[1:])
        )

    def regressor(self, dive: Dive) -> np.ndarray:
        """Return H of y = H p for a dive, (2, n).

        Its columns are in s for currents, in m for the others.
        """
        return np.hstack([term.columns(dive) for term in self.terms])

    def noise(self, dive: Dive, scatter: Any) -> Any:
        """Return FIX^2 + doubt^2 + (s T)^2, the variance of y, m^2."""
        return leg_variance(self.priors.fix**2 + dive.doubt**2, scatter, dive.duration)

    @cached_property
    def memory(self) -> np.ndarray:
        """Times in which the n parameters are forgotten, (n,), s."""
        return np.array([term.memory for term in self.terms for _ in term.parameters])

    def rotation(self, dt: float, latitude: float) -> np.ndarray:
        """Return the rotation of inertial currents over a time.

        (n, n); `dt` in s.
        """
        rotation = np.eye(len(self.names))
        if "inertial" in self.flow:
            k = self.names.index("inertial_east")
            angle = inertial_frequency(latitude) * dt
            c, s = math.cos(angle), math.sin(angle)
            rotation[k : k + 2, k : k + 2] = [[c, s], [-s, c]]
        return rotation
