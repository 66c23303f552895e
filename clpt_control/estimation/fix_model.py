"""What moved a vehicle between two fixes: the regression all estimators share, and its prior.

The regression is

    x(t2) - x(t1) = f R(psi) int v dt + theta int phi(x, t) dt + noise

the integral of Eq. (1) with the flow of Eq. (3); int v dt is the dead-reckoned
displacement d, f a factor on speed through water, R(psi) a compass error.
Less d on both sides it is linear, y = H p, in f cos psi and f sin psi.
Gaussian places join the parameters when a track first comes near
them, so that n grows.

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

Gaussian functions of place stand where a vehicle's track supports them, Eq. (5).

    phi_c(x) = exp(-|x - c|^2 / (2 width^2)),  H_c = int phi_c(x(t)) dt

The places c stand on a square lattice of 1.5 widths about the vehicle's first
fix.  One joins the parameters when a track first comes near enough that
H_c > `REACHED` T; before that it has its prior and nothing else, so that joining
late changes little.

On a long voyage only the `MOST` places nearest to its last track remain.

Along a dive x(t) is the dead-reckoned track from the fix before it; when the
dive has ended, the track bent evenly to the fix after it.

`Priors` has what is believed before any dive: every number of the estimators, with its source.
"Judgement" is engineering judgement: plausible for any glider, in no paper.
`python -m analysis.prior_sensitivity` halves and doubles the numbers one at a time.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from itertools import product
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import trapezoid

from ..arguments import public
from ..blocks.flow import flow_basis
from ..equations.at_many import evaluate
from ..errors import ScenarioError
from ..geodesy import displacement
from ..scenario.tidal_periods import SPEEDS, period
from .dive import Dive, mid_time, miss, reckoned

WIDTH = 20e3  # m, of a gaussian
SPACING = 1.5  # widths
REACHED = 0.1  # share of a dive's time
MOST = 40  # places that are parameters; the farthest are forgotten
SAMPLES = 25  # of a track


@dataclass(frozen=True)
class Places:
    """Gaussians on a lattice: its origin (degrees), their width (m), their cells.

    A cell is a column east and a row north of the origin; in the order they were reached.
    """

    latitude: float
    longitude: float
    width: float
    cells: tuple[tuple[int, int], ...] = ()


def near(places: Places | None, dive: Dive, width: float) -> Places:
    """Return the places with those that a dive comes near; the same object where nothing is new.

    `width` (m) and the dive's start are the first lattice's; a dive's end is not read.
    """
    old = places or Places(dive.lat_gps2, dive.lon_gps2, width)
    x = _along(old, dive, False)[1]
    pitch, reach = SPACING * old.width, old.width * math.sqrt(-2 * math.log(REACHED))
    if np.ptp(x, axis=0).max() > 10 * pitch:
        raise ScenarioError(
            f"width of the gaussians = {old.width:g} m: must be more, for dive {dive.number} is "
            f"{np.ptp(x, axis=0).max():.0f} m long"
        )
    low, high = (
        np.rint((end(x, axis=0) + side * reach) / pitch).astype(int)
        for end, side in ((np.min, -1), (np.max, 1))
    )
    columns, rows = (range(first, last + 1) for first, last in zip(low, high, strict=True))
    around = tuple(product(columns, rows))
    support = places_columns(replace(old, cells=around), dive)[0, ::2]
    reached = [cell for cell, s in zip(around, support, strict=True) if s > REACHED * dive.duration]
    fresh = [cell for cell in reached if cell not in old.cells]
    if places is not None and not fresh:
        return places
    cells = [*old.cells, *fresh]
    away = np.hypot(*(pitch * np.array(cells) - x.mean(axis=0)).T)
    nearest = set(np.argsort(away, kind="stable")[:MOST].tolist())
    return replace(old, cells=tuple(cell for k, cell in enumerate(cells) if k in nearest))


def _along(places: Places, dive: Dive, ended: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return a few samples of a dive's track: time (k,), s; from the lattice's origin (k, 2), m.

    Where the dive has `ended` its track is bent to the fix after it.
    """
    time = np.linspace(0.0, dive.duration, SAMPLES)
    since, *axes = reckoned(dive)
    x = np.stack([np.interp(time, since, axis) for axis in axes], axis=1)
    if ended:
        x = x + (time / dive.duration)[:, None] * miss(dive)
    start = displacement(places.latitude, places.longitude, dive.lat_gps2, dive.lon_gps2)
    return time, np.array(start) + x


def places_columns(places: Places, dive: Dive, ended: bool = False) -> np.ndarray:
    """Return phi integrated over a dive, (2, 2N), s: each place's east, then its north."""
    N = len(places.cells)
    steady = np.zeros(N)
    centers = SPACING * places.width * np.array(places.cells, float).reshape(N, 2)
    widths = np.full(N, places.width)
    basis = flow_basis("places", "x", "gaussian", centers, widths, steady, steady)
    time, x = _along(places, dive, ended)
    return np.kron(trapezoid(evaluate(basis, time, x), time, axis=0), np.eye(2))


DAY = 86400.0  # s


class Sea(NamedTuple):
    """How a sea changes, as a bank has it: numbers, or arrays (m,) for m filters."""

    size: Any  # S, m/s, of the slow current
    memory: Any  # tau, s
    smooth: Any = 1.0  # 1: it changes slowly, 0: it may change at once
    scatter: Any = 0.005  # s, m/s, what no parameter explains and no dive remembers


@public
class Priors(NamedTuple):
    """Standard deviations and times before any dive, m, s and rad.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> doubtful = clpt.estimation.FixModel(priors=clpt.estimation.Priors(speed=0.3))
    >>> doubtful.prior_sd[-2:]
    array([0.3 , 0.03])
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
    gaussian: float = 0.15  # m/s, of a place's coefficient
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
    # the real vehicles of `docs/gliders_method.md`, the fewest that forecast as well, and see a
    # lost speed as often, as forty filters with other covariances did
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
    degrees_of_freedom: float = 8.0  # of the density that weighs filters
    # judgement: a voyage comes to another sea in weeks
    weight_memory: float = 20 * DAY

    # the gradient's.  With 1 the parameters explain the last dive (Goodwin, Sin 1984, projection)
    gain: float = 1.0  # mu, between 0 and 2 for stability
    # judgement: the gradient's one sea; a current that it forgets walks 0.04 m/s in six hours
    gradient: Sea = Sea(0.0, 28.125 * DAY, scatter=0.04)
    miss: float = 0.1  # m/s, a miss over its time, before any dive
    miss_weight: float = 4.0  # dives that this guess weighs
    miss_memory: float = 20.0  # dives that are remembered of it


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
                similar = [k for k in known if k.casefold() == name.strip().casefold()]
                raise ScenarioError(
                    f"flow {','.join(self.flow) or 'empty'}: unknown constituent '{name}'"
                    f"{' (did you mean ' + similar[0] + '?)' if similar else ''}: must be one of "
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

    @cached_property
    def terms(self) -> tuple[Term, ...]:
        """The terms, in the order of the parameters."""
        p = self.priors
        terms = [Term("current", _axes("current"), p.current, math.inf, steady)]
        for name in self.flow[1:]:
            if name == "inertial":
                terms.append(Term(name, _axes(name), p.inertial, p.inertial_fading, inertial))
            elif name == "shear":
                terms.append(Term(name, _axes(name), p.shear, math.inf, shear))
            elif name == "model":
                terms.append(Term(name, (name,), p.model, math.inf, modelled))
            elif name != "gaussians":
                pair = _axes(f"{name}_cos") + _axes(f"{name}_sin")
                terms.append(Term("tides", pair, p.tide, p.tide_fading, partial(tide, name)))
        if self.learn_speed:
            terms.append(Term("speed", ("speed",), p.speed, p.speed_fading, speed_column))
            terms.append(Term("compass", ("compass",), p.compass, p.compass_fading, compass_column))
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
        return tuple(dict.fromkeys(p if p in OTHERS else "tides" for p in self.flow[1:]))

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
            k, angle = self.names.index("inertial_east"), inertial_frequency(latitude) * dt
            c, s = math.cos(angle), math.sin(angle)
            F[k : k + 2, k : k + 2] = F[k, k] * np.array([[c, s], [-s, c]])
        return F
