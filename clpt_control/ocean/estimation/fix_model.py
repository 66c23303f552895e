"""What moved a vehicle between two fixes: the regression all estimators share.

The regression is

    x(t2) - x(t1) = f R(psi) int v dt + theta int phi(x, t) dt + noise

the integral of Eq. (1) with the flow of Eq. (3); int v dt is the dead-reckoned
displacement d, f a factor on speed through water, R(psi) a compass error.
Less d on both sides it is linear, y = H p, in f cos psi and f sin psi.
Gaussian places (`gaussian_places`) join the parameters when a track first comes near
them, so that n grows; what is believed of all before any dive are `Priors`.

The columns of H, what one unit of a parameter does:

    steady current      T                             two parameters, m/s
    tide, speed w       T s(w) cos(w tm), T s(w) sin(w tm)    four, m/s
    inertial current    T s(c)                        two, m/s, at mid-dive
    shear               T log(depth / 100 m)          two, m/s, each e times as deep
    flow model          its displacement (east, north)    one, a factor
    speed               (d_east, d_north)             f cos psi - 1
    compass             (d_north, -d_east)            f sin psi, psi clockwise

with T the duration, tm mid-dive, d the dead reckoning and s(w) = sin(w T/2)/(w T/2),
the mean of a tide over a dive.  Between dives the inertial current rotates by
-c dt, c = 2 Omega sin(latitude) (A. E. Gill, "Atmosphere-Ocean Dynamics", 1982,
section 8.3).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from ...base.arguments import public
from ...base.errors import ScenarioError
from ...paper.scenario.tidal_periods import SPEEDS, period
from .dive import Dive, mid_time
from .gaussian_places import WIDTH, Places, near, places_columns
from .priors import Priors

FAR = 13.82  # chi-squared of two components, 99.9 %: what lies beyond is strange
SHALLOW = 100.0  # m, where shear is zero
ROTATION = 7.292115e-5  # rad/s, of the Earth
OTHERS = ("inertial", "shear", "gaussians", "model")  # parts that are no tide


def inertial_frequency(latitude: float) -> float:
    """Return the Coriolis frequency at a latitude (degrees), rad/s: positive turns clockwise."""
    return 2 * ROTATION * math.sin(math.radians(latitude))


def swing(dive: Dive, w: float) -> float:
    """Return T s(w), s: how far an oscillation of unit size at mid-dive carries; w in rad/s."""
    T = dive.duration
    return T * float(np.sinc(w * T / (2 * math.pi)))


class Term(NamedTuple):
    """What moves a vehicle: its parameters, their size before any dive, and how long they last.

    `columns` of H, (2, k), are of a dive, and whether its end may be read.
    """

    name: str
    parameters: tuple[str, ...]
    sd: float
    fading: float  # s
    columns: Callable[[Dive, bool], np.ndarray]


def _axes(name: str) -> tuple[str, str]:
    return f"{name}_east", f"{name}_north"


def steady(dive: Dive, ended: bool) -> np.ndarray:
    """Return the columns of a current that stays."""
    return dive.duration * np.eye(2)


def inertial(dive: Dive, ended: bool) -> np.ndarray:
    """Return the columns of the inertial current at mid-dive."""
    return swing(dive, inertial_frequency(dive.lat_gps2)) * np.eye(2)


def shear(dive: Dive, ended: bool) -> np.ndarray:
    """Return the columns of the current's change with depth; zero where that is not known."""
    deep = dive.depth_max or 0.0
    folds = math.log(max(deep / SHALLOW, 0.1)) if deep > 0 else 0.0
    return dive.duration * folds * np.eye(2)


def modelled(dive: Dive, ended: bool) -> np.ndarray:
    """Return the column of a flow model; zero where it does not cover the dive."""
    return np.array([[dive.model_east or 0.0], [dive.model_north or 0.0]])


def tide(name: str, dive: Dive, ended: bool) -> np.ndarray:
    """Return the columns of a tide by its name."""
    w = 2 * math.pi / period(name, "s")
    phase = w * mid_time(dive)
    c, s = math.cos(phase), math.sin(phase)
    return swing(dive, w) * np.array([[c, 0.0, s, 0.0], [0.0, c, 0.0, s]])


def speed_column(dive: Dive, ended: bool) -> np.ndarray:
    """Return the column of the speed."""
    return np.array([[dive.dr_east], [dive.dr_north]])


def compass_column(dive: Dive, ended: bool) -> np.ndarray:
    """Return the column of the compass."""
    return np.array([[dive.dr_north], [-dive.dr_east]])


@public
@dataclass(frozen=True)
class FixModel:
    """Parameters of the motion between fixes.

    Attributes
    ----------
    flow : tuple of str
        ``"steady"``, then any of ``"inertial"``, ``"shear"``, ``"gaussians"``, ``"model"`` (a
        factor on the dives' flow model) and constituents such as ``"M2"``.
    learn_speed : bool
        Whether a factor on speed and a compass error are parameters too.
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
    places: Places | None = None
    priors: Priors = field(default_factory=Priors)

    def __post_init__(self) -> None:
        """Refuse flows that cannot be."""
        parts = (*OTHERS, *SPEEDS)
        rest = self.flow[1:]
        if (
            self.flow[:1] != ("steady",)
            or {*rest} - {*parts}
            or len({*rest}) < len(rest)
        ):
            raise ScenarioError(
                f"flow {','.join(self.flow) or 'empty'}: must begin with steady, then name some of "
                f"{', '.join(parts)}, each once"
            )

    @cached_property
    def terms(self) -> tuple[Term, ...]:
        """The terms, in the order of the parameters."""
        p = self.priors
        terms = [Term("current", _axes("current"), p.current, math.inf, steady)]
        for name in self.flow[1:]:
            if name == "inertial":
                terms.append(
                    Term(name, _axes(name), p.inertial, p.inertial_fading, inertial)
                )
            elif name == "shear":
                terms.append(Term(name, _axes(name), p.shear, math.inf, shear))
            elif name == "model":
                terms.append(Term(name, (name,), p.model, math.inf, modelled))
            elif name != "gaussians":
                pair = _axes(f"{name}_cos") + _axes(f"{name}_sin")
                terms.append(
                    Term("tides", pair, p.tide, p.tide_fading, partial(tide, name))
                )
        if self.learn_speed:
            terms.append(
                Term("speed", ("speed",), p.speed, p.speed_fading, speed_column)
            )
            terms.append(
                Term(
                    "compass", ("compass",), p.compass, p.compass_fading, compass_column
                )
            )
        if self.places:
            cells = [f"gaussian[{i},{j}]" for i, j in self.places.cells]
            names = tuple(name for cell in cells for name in _axes(cell))
            columns = partial(places_columns, self.places)
            terms.append(Term("gaussians", names, p.gaussian, math.inf, columns))
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
        """Parts that a sea may lack; all tides come or go together."""
        return tuple(
            dict.fromkeys(p if p in OTHERS else "tides" for p in self.flow[1:])
        )

    def reached(self, dive: Dive) -> "FixModel":
        """Return the model with the places that a dive comes near.

        Its end is not read.  New parameters come last; where nothing is new it is the model itself.
        """
        if "gaussians" not in self.flow:
            return self
        places = near(self.places, dive, WIDTH)
        return self if places is self.places else replace(self, places=places)

    def regressor(self, dive: Dive, ended: bool = False) -> np.ndarray:
        """Return H of y = H p for a dive, (2, n).

        Its columns are in s for currents, in m for the others. A dive's end is read
        only where it has `ended`: for gaussians along the bent track.
        """
        return np.hstack([term.columns(dive, ended) for term in self.terms])

    def noise(self, dive: Dive, scatter: Any) -> Any:
        """Return FIX^2 + doubt^2 + (s T)^2, the variance of y, m^2."""
        return self.priors.fix**2 + dive.doubt**2 + (scatter * dive.duration) ** 2

    def transition(self, dt: float, latitude: float) -> np.ndarray:
        """Return F, what is left of the parameters after a time.

        (n, n), `dt` in s; inertial currents rotate.
        """
        fading = [term.fading for term in self.terms for _ in term.parameters]
        F = np.diag(np.exp(-dt / np.array(fading)))
        if "inertial" in self.flow:
            k, angle = (
                self.names.index("inertial_east"),
                inertial_frequency(latitude) * dt,
            )
            c, s = math.cos(angle), math.sin(angle)
            F[k : k + 2, k : k + 2] = F[k, k] * np.array([[c, s], [-s, c]])
        return F
