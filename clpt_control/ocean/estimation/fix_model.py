"""Regression of the displacement between two fixes.

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

An estimator forecasts y of a dive with the noise

    n ~ N(0, (FIX^2 + doubt^2 + (s T)^2) I).

Its state is a mixture of m normal distributions of the n parameters p. A forecast reads a dive's
times, start and dead reckoning, never its end.

`Priors` has each number with its source. "Judgement" is engineering judgement: plausible for any
glider, in no paper. `python -m analysis.prior_sensitivity` halves and doubles the numbers one at a
time.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from ...base.errors import ScenarioError
from ...base.units import DAY
from ...paper.scenario.tidal_periods import SPEEDS, period
from ..gliders.dives import Dive

LEVEL = 0.9  # probability of the region of a forecast
PERCENT = f"{100 * LEVEL:g} %"
CHI_SQUARED = -2.0 * math.log(1.0 - LEVEL)  # of two components
FAR = 13.82  # the same of 99.9 %
# share of a prior's standard error; a parameter with more is not learned
LEARNED = 0.87
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


class Sea(NamedTuple):
    """Slow current and noise of a kind of sea: numbers, or arrays (m,) of m processes."""

    size: Any  # S, m/s, of the slow current
    memory: Any  # tau, s
    smooth: Any = 1.0  # 1: a smooth current, 0: a rough one (`estimators`)
    scatter: Any = 0.005  # s, m/s, white noise from dive to dive
    mapped: Any = 0.0  # m/s, of a steady current that depends on position


class Priors(NamedTuple):
    """Standard deviations and times before any dive, m, s and rad.

    `FixModel(priors=Priors(speed=0.3))` has other ones.
    """

    # GPS has 4 m (Rudnick, Sherman, Wu, J. Atmos. Oceanic Technol. 35, 1665, 2018); two fixes, and
    # the drift at the surface between a fix and the water beneath: judgement
    fix: float = 30.0  # m, one component of the difference of two fixes
    # judgement: most of the ocean has less, jets have more
    current: float = 0.3  # m/s
    # judgement: 0.02 in the deep sea, 0.1 to 0.5 on shelves
    tide: float = 0.1  # m/s, of each constituent's four numbers
    # strong events have 0.2 at the surface (Poulain, "Near-inertial and diurnal motions in the
    # trajectories of mixed layer drifters", J. Marine Research 48, 1990), a dive's mean has less;
    # with 0.05 the 90 % ellipses after a made storm held 83 % of the surfacings
    inertial: float = 0.1  # m/s
    # judgement: eddies of 0.3 m/s have half of it at 200 m, or at 1000
    shear: float = 0.1  # m/s, of a dive e times as deep
    # judgement: half a current
    gaussian: float = (
        0.15  # m/s, of a steady current that depends on position, and of a gaussian
    )
    # judgement: a forecast may be nothing, right, or half as strong again
    model: float = 0.7  # of the factor on a flow model
    # judgement, settled with the sample's vehicle in view: flight models that are not trimmed yet
    speed: float = 0.15  # of the factor on speed, less one
    # judgement: makers of compasses promise 1 degree, hulls and batteries add as much
    compass: float = 0.03  # rad

    # shelves are 9 % of the ocean (Harris et al., "Geomorphology of the oceans", 2014)
    shelf: float = 0.1  # probability that tides are strong
    present: float = 0.5  # of any other part: nothing is known

    # ten inertial periods at mid-latitudes are a week (Poulain 1990); gliders leave the place: half
    inertial_fading: float = 4 * DAY
    # neaps come after 7 days, other places after weeks: judgement
    tide_fading: float = 60 * DAY
    # judgement: what grows on a hull changes the speed by 4 % in 100 days
    speed_fading: float = 2800 * DAY
    # judgement: a degree in 100 days
    compass_fading: float = 450 * DAY

    # from currents that hardly change to a jet's edge: chosen on the made seas of `analysis` and
    # the real vehicles of `docs/gliders_method.md`, the fewest that forecast as well, and find a
    # lost speed as often, as forty covariances
    kinds: tuple[Sea, ...] = (
        Sea(0.05, 8 * DAY),
        Sea(0.05, 8 * DAY, scatter=0.01),
        Sea(0.1, DAY / 2),
        Sea(0.35, 2 * DAY),
        Sea(0.35, 4 * DAY, scatter=0.02),
        Sea(0.1, 8 * DAY, scatter=0.05),
        Sea(0.08, 8 * DAY, smooth=0.0),
        Sea(0.16, 8 * DAY, smooth=0.0),
        Sea(0.35, 8 * DAY, smooth=0.0),
    )

    # judgement: a missed front counts little (Lange, Little, Taylor, J. Am. Stat. Assoc. 84, 1989)
    degrees_of_freedom: float = 8.0  # of the density that weights processes
    # judgement: a voyage comes to another sea in weeks
    weight_memory: float = 20 * DAY


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
        fading = p.inertial_fading
        choice = {
            "steady": [Term("current", _axes("current"), p.current, math.inf, steady)],
            "inertial": [
                Term("inertial", _axes("inertial"), p.inertial, fading, inertial)
            ],
            "shear": [Term("shear", _axes("shear"), p.shear, math.inf, shear)],
            "model": [Term("model", ("model",), p.model, math.inf, modelled)],
            "gaussians": [],
        }
        terms = []
        for name in self.flow:
            if name in choice:
                terms += choice[name]
            else:  # a constituent
                names = _axes(f"{name}_cos") + _axes(f"{name}_sin")
                columns = partial(tide, name)
                terms.append(Term("tides", names, p.tide, p.tide_fading, columns))
        if self.learn_speed:
            fading = p.compass_fading
            terms += [
                Term("speed", ("speed",), p.speed, p.speed_fading, speed_column),
                Term("compass", ("compass",), p.compass, fading, compass_column),
            ]
        return tuple(terms)

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
        of_fixes = self.priors.fix**2 + dive.doubt**2
        return of_fixes + (scatter * dive.duration) ** 2

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
