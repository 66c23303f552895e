"""Tidal constants of a current record, by least squares through UTide.

    (u, v)(t) = mean + sum_k f_k(t) A_k cos(V_k(t) + u_k(t) - g_k) + residual

for the component to the east and to the north; `constituents` says what f, u and
V are.  The same tide drawn as an ellipse has a semi-major and a semi-minor axis
(positive: it turns counter-clockwise), the major axis's inclination from east,
counter-clockwise, and the phase lag of the greatest speed.  Solved by
utide.solve (D. L. Codiga, URI/GSO technical report 2011-01).

Standard errors: UTide's linear ones for white residuals, times `noise_ratio`.  Its
own coloured errors are not used: over 60 seeds of white noise they were 0.7 of
the estimates' true spread, and 0.55 with 40 % of the samples missing.

As theta of Eq. (3), for the basis of a scenario, the constants are

    f A cos(V(t) + u - g) = c cos(w (t - t0)) + s sin(w (t - t0))
    c = f A cos(p),  s = -f A sin(p),  p = V(t0) + u(t0) - g

f and u are those of the epoch t0, which becomes t = 0 of the scenario: choose it
in the middle of what is to be run; M2 changes by 0.4 % in half a year.  A
scenario's sine is the phase -pi/2.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ...base.arguments import public
from ...base.errors import DataError, ScenarioError, import_optional
from ...base.units import finite_or_none, percent, speed_in_metres_per_second
from ..scenario.tidal_periods import SPEEDS
from . import constituents as tidal
from . import identifiability
from .least_squares import explained_share

LEAST_CHANGE = 1e-9  # m/s in a record; less is no measured tide, and its squares vanish
CI = 1.96  # UTide's half widths, in standard errors


@dataclass(frozen=True)
class Constituent:
    """One tide of a current: amplitudes (m/s), Greenwich phases and ellipse (degrees)."""

    name: str  # of each number: which fit of UTide's has it (both, east, north), and as what
    east: float = field(metadata={"of": (1, "A")})
    east_phase: float = field(metadata={"of": (1, "g")})
    north: float = field(metadata={"of": (2, "A")})
    north_phase: float = field(metadata={"of": (2, "g")})
    major: float = field(metadata={"of": (0, "Lsmaj")})
    # negative where it turns clockwise
    minor: float = field(metadata={"of": (0, "Lsmin")})
    inclination: float = field(metadata={"of": (0, "theta")})
    phase: float = field(metadata={"of": (0, "g")})
    errors: dict[str, float]  # standard error of each number; NaN where it has none


NUMBERS = {one.name: one.metadata["of"] for one in fields(Constituent) if one.metadata}


class TidalBasis(NamedTuple):
    """Functions of time and their theta, as `basis` of a scenario has them."""

    constituents: tuple[str, ...]  # steady, then each tide twice
    phases: tuple[float, ...]  # rad: 0 for cosines, -pi/2 for sines
    theta: np.ndarray  # east and north, in the unit that was asked for, shape (2, N)


class TidalFit:
    """Tidal constants of a record and how well they explain it."""

    def __init__(
        self,
        times: np.ndarray,
        flow: np.ndarray,
        names: Sequence[str],
        cycles: np.ndarray,
        fits: Sequence[Any],
        latitude: float,
    ) -> None:
        """Take the constants of tides, cycles per hour, from fits of both components, east, north.

        They are as utide.solve gives them, of u + iv, m/s, at times, datetime64 in UTC.
        """
        self.coefficients, self.latitude, self.samples = (
            fits[0],
            float(latitude),
            len(times),
        )
        self.start, self.end = times[0], times[-1]  # first measurement and last
        hours = (times - times[0]).astype(float) / 3.6e6
        mean, middle = fits[0].umean + 1j * fits[0].vmean, flow.mean()
        model = _predicted(fits[0], times)
        residual = flow - model
        self.constituents = tuple(  # in the order that was asked for
            _constituent(
                name, k, fits, identifiability.noise_ratio(residual, hours, cycles, k)
            )
            for k, name in enumerate(names)
        )
        self.mean = float(mean.real), float(mean.imag)  # east and north, m/s
        # share about the mean, both components together
        self.explained_variance = explained_share(flow - middle, model - middle)
        # root of the mean squared length of the residual, m/s
        self.residual_rms = float(np.sqrt(np.mean(np.abs(residual) ** 2)))

    def __repr__(self) -> str:
        axes = ", ".join(f"{one.name} {one.major:.3g}" for one in self.constituents[:4])
        return (
            f"<TidalFit of {self.samples} samples over {self.hours:.5g} h: {axes}"
            f"{', ...' if self.constituents[4:] else ''} m/s (major axes); explains "
            f"{percent(self.explained_variance)} of the variance>"
        )

    @property
    def hours(self) -> float:
        """Time from the first measurement to the last, h."""
        return float((self.end - self.start) / np.timedelta64(1, "ms")) / 3.6e6

    @property
    def middle(self) -> np.datetime64:
        """The record's middle, UTC."""
        return self.start + (self.end - self.start) // 2

    @public
    def predict(self, time: ArrayLike) -> np.ndarray:
        """Return the current at any times.

        Parameters
        ----------
        time : array_like of datetime64, shape (n,)
            UTC; nodal corrections are those of each time.

        Returns
        -------
        ndarray, shape (2, n)
            East and north, m/s: mean and tides.

        Raises
        ------
        DataError
            If a time is none, or not in the years that are allowed.

        Examples
        --------
        >>> time = np.datetime64("2019-01-01") + np.arange(72) * np.timedelta64(1, "h")
        >>> wave = np.cos(np.radians(28.9841042) * np.arange(72))
        >>> fit = fit_tides(time, wave, 0 * wave, 41.0, ["M2"])
        >>> bool(abs(fit.predict(time)[0] - wave).max() < 1e-3)
        True
        """
        times = tidal.checked_times(time)
        if times.ndim != 1:
            raise DataError(
                f"time: has {times.ndim} dimensions; must be a list of times"
            )
        flow = _predicted(self.coefficients, times)
        return np.array([flow.real, flow.imag])

    @public
    def basis(self, epoch: Any, unit: str = "m s-1") -> TidalBasis:
        """Return theta of a scenario that starts at an epoch.

        Parameters
        ----------
        epoch : str or datetime64
            t = 0 of the scenario, UTC.
        unit : str, optional
            Of theta: the scenario's length per time, such as "km h-1".

        Returns
        -------
        TidalBasis
            Constituents, phases and theta, shape (2, N).

        Raises
        ------
        DataError
            If the epoch or the unit cannot be read, or a scenario knows no such constituent.

        Examples
        --------
        >>> time = np.datetime64("2019-01-01") + np.arange(72) * np.timedelta64(1, "h")
        >>> wave = np.cos(np.radians(28.9841042) * np.arange(72))
        >>> basis = fit_tides(time, wave, 0.5 * wave, 41.0, ["M2"]).basis(time[0])
        >>> basis.constituents
        ('steady', 'M2', 'M2')
        >>> bool(abs(basis.theta - [[0, 1, 0], [0, 0.5, 0]]).max() < 1e-3)
        True
        """
        names = [constituent.name for constituent in self.constituents]
        foreign = [name for name in names if name not in SPEEDS]
        if foreign:
            raise DataError(
                f"{', '.join(foreign)}: a scenario has only {', '.join(SPEEDS)}"
            )
        size = 1.0 / speed_in_metres_per_second(unit, "theta")
        f, u, V = tidal.nodal_corrections(
            names, tidal.checked_times(epoch)[:1], self.latitude
        )
        columns = [np.array(self.mean)]
        for k, constituent in enumerate(self.constituents):
            p = np.radians(
                V[0, k]
                + u[0, k]
                - np.array([constituent.east_phase, constituent.north_phase])
            )
            A = f[0, k] * np.array([constituent.east, constituent.north])
            columns += [A * np.cos(p), -A * np.sin(p)]
        return TidalBasis(
            ("steady", *(name for name in names for _ in range(2))),
            (0.0, *([0.0, -np.pi / 2] * len(names))),
            size * np.column_stack(columns),
        )

    def as_dict(self) -> dict[str, Any]:
        """Return the fit as one JSON object, numbers that are not finite as None.

        Amplitudes are in m/s, phases in degrees of Greenwich lag, times in UTC; f, u and V at the
        record's middle stand under "nodal".
        """
        names = [constituent.name for constituent in self.constituents]
        corrections = tidal.nodal_corrections(names, [self.middle], self.latitude)
        return {
            "start": str(self.start),
            "end": str(self.end),
            "hours": self.hours,
            "samples": self.samples,
            "latitude": self.latitude,
            "constituents": {
                constituent.name: {
                    **{
                        key: finite_or_none(getattr(constituent, key))
                        for key in NUMBERS
                    },
                    "standard_errors": {
                        key: finite_or_none(constituent.errors[key]) for key in NUMBERS
                    },
                }
                for constituent in self.constituents
            },
            "mean": list(self.mean),
            "explained_variance": self.explained_variance,
            "residual_rms": self.residual_rms,
            "speed_units": "m s-1",
            "phase_units": "degree",
            "nodal_time": str(self.middle),
            "nodal": {
                name: {
                    key: float(correction[0, k])
                    for key, correction in zip("fuV", corrections, strict=True)
                }
                for k, name in enumerate(names)
            },
        }


@public
def fit_tides(
    time: ArrayLike,
    u: np.ndarray,
    v: np.ndarray,
    latitude: float,
    constituents: Sequence[str] | str,
    where: str = "the record",
) -> TidalFit:
    """Fit tidal constants to a current record at one place.

    Parameters
    ----------
    time : array_like of datetime64, shape (n,)
        UTC, increasing; any spacing.
    u, v : array_like, shape (n,)
        To the east and to the north, m/s; NaN where not measured.
    latitude : float
        Degrees north.
    constituents : sequence of str
        Names such as ``"M2"``, or UTide's own; the mean is always fitted.
        ``"auto"``: all that UTide thinks the record can separate, below its
        Nyquist frequency.
    where : str, optional
        The record, for messages.

    Returns
    -------
    TidalFit
        Constants, errors, mean and shares.

    Raises
    ------
    DataError
        If the record cannot be used, is too short or too sparse to separate
        the constituents (which are named), or UTide is not installed.
    ScenarioError
        If a constituent is unknown.

    Examples
    --------
    >>> time = np.datetime64("2019-01-01") + np.arange(721) * np.timedelta64(1, "h")
    >>> wave = np.cos(np.radians(30.0) * np.arange(721) - 1.0)  # S2, so g = 1 rad and 12 h V = 0
    >>> tide = fit_tides(time, 0.5 * wave + 0.1, 0.2 * wave, 41.0, ["M2", "S2"]).constituents[1]
    >>> tide.name, round(tide.east, 3), round(tide.north, 3), round(tide.inclination, 1)
    ('S2', 0.5, 0.2, 21.8)
    """
    utide = import_optional("utide")
    times, flow = _measured(time, u, v, where)
    hours = (times - times[0]).astype(float) / 3.6e6
    names = _names(constituents, hours, where)
    theirs = tidal.utide_names(names)
    cycles = np.array([utide.cycles_per_hour[name] for name in theirs])
    speeds = {"steady": 0.0} | dict(zip(names, 360.0 * cycles, strict=True))
    identifiability.check_speeds(speeds, hours[-1], where)
    identifiability.check_sampling(hours, cycles, names, where)
    identifiability.check_nyquist(hours, cycles, names, where)
    options = {
        "lat": tidal.checked_latitude(latitude),
        "constit": theirs,
        "white": True,
        "order_constit": theirs,
        "trend": False,
        "verbose": False,
    }
    with np.errstate(all="ignore"):  # 0/0 where a tide or the residual is nought
        complex_fit = utide.solve(times, flow.real, flow.imag, **options)
        east, north = (
            utide.solve(times, component, **options)
            for component in (flow.real, flow.imag)
        )
    return TidalFit(times, flow, names, cycles, (complex_fit, east, north), latitude)


def _predicted(coefficients: Any, times: np.ndarray) -> np.ndarray:
    out = import_optional("utide").reconstruct(
        times, coefficients, min_SNR=0, verbose=False
    )
    return out.u + 1j * out.v


def _measured(time: Any, u: Any, v: Any, where: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the times and u + iv where both were measured."""
    times = tidal.checked_times(time)
    u, v = np.asarray(u, float), np.asarray(v, float)
    if not u.shape == v.shape == times.shape or times.ndim != 1:
        raise DataError(
            f"{where}: time {times.shape}, u {u.shape}, v {v.shape} must be one row"
        )
    tidal.check_increasing(times, where)
    is_measured = np.isfinite(u) & np.isfinite(v)
    if is_measured.sum() < 2:
        raise DataError(
            f"{where}: {is_measured.sum()} of {len(u)} times have both components"
        )
    change = max(np.ptp(u[is_measured]), np.ptp(v[is_measured]))
    if change < LEAST_CHANGE:
        raise DataError(f"{where}: changes by {change:.2g} m/s only: check its units")
    return times[is_measured], u[is_measured] + 1j * v[is_measured]


def _names(
    constituents: Sequence[str] | str, hours: np.ndarray, where: str
) -> tuple[str, ...]:
    if constituents in ("auto", ["auto"], ("auto",)):
        const = import_optional(
            "utide"
        ).ut_constants.const  # df: cycles per hour to the next greater tide
        fastest = identifiability.nyquist(hours)
        names = tuple(
            str(name)
            for name, df, cycles in zip(const.name, const.df, const.freq, strict=True)
            if df * hours[-1] >= 1 and cycles < fastest
        )
        if not names:
            raise DataError(
                f"{where}: no tide can be distinguished from the mean in {hours[-1]:.4g} h"
            )
        return names
    # the mean, always there
    names = tuple(name for name in constituents if name != "steady")
    if not names or len(set(tidal.utide_names(names))) != len(names):
        raise ScenarioError(
            f"constituents = {','.join(constituents)}: must be tides, each once"
        )
    return names


def _constituent(
    name: str, k: int, fits: Sequence[Any], ratio: np.ndarray
) -> Constituent:
    """Return the tide of index k of the fits of both components, of the east and of the north."""
    values, errors = dict[str, float](), dict[str, float]()
    for key, (fit_index, symbol) in NUMBERS.items():
        values[key] = float(fits[fit_index][symbol][k])
        errors[key] = float(fits[fit_index][f"{symbol}_ci"][k] / CI * ratio[fit_index])
    return Constituent(name=name, errors=errors, **values)
