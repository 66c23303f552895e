"""Tidal constants of one place: what `fit_tides` gives, and its report.

Amplitudes in m/s, phases in degrees of Greenwich lag, as `analysis` says.
"""

from dataclasses import dataclass, field
from math import isfinite
from typing import Any

import numpy as np

from ..nodal import nodal_report

NUMBERS = {
    "east": ("amplitude of the eastward component", "m s-1"),
    "east_phase": ("Greenwich phase lag of the eastward component", "degree"),
    "north": ("amplitude of the northward component", "m s-1"),
    "north_phase": ("Greenwich phase lag of the northward component", "degree"),
    "major": ("semi-major axis of the ellipse", "m s-1"),
    "minor": ("semi-minor axis, negative where the current turns clockwise", "m s-1"),
    "inclination": ("major axis, counter-clockwise from east", "degree"),
    "phase": ("Greenwich phase lag of the greatest speed", "degree"),
}


@dataclass(frozen=True)
class Constituent:
    """One tide of a current: amplitudes, phases and ellipse.

    Attributes
    ----------
    name : str
        Such as "M2".
    east, north, major, minor : float
        Amplitudes, m/s; minor is negative where the current turns clockwise.
    east_phase, north_phase, phase : float
        Greenwich phase lags, degrees, of the two components and the ellipse.
    inclination : float
        Of the major axis, degrees counter-clockwise from east, 0 to 180.
    errors : dict of str to float
        Standard error of each number above; NaN where it has none.
    """

    name: str
    east: float
    east_phase: float
    north: float
    north_phase: float
    major: float
    minor: float
    inclination: float
    phase: float
    errors: dict[str, float]


@dataclass(frozen=True)
class TidalFit:
    """Tidal constants of a record and how well they explain it.

    Attributes
    ----------
    constituents : tuple of Constituent
        In the order that was asked for.
    mean : tuple of float
        East and north, m/s.
    explained_variance : float
        Share of the variance about the mean, both components together.
    residual_rms : float
        Root of the mean squared length of the residual, m/s.
    start, end : datetime64[ms]
        First and last measurement, UTC.
    samples : int
        Measurements that were used.
    latitude : float
        Degrees north, of the nodal corrections.
    coefficients : Bunch
        As utide.solve gives them.
    """

    constituents: tuple[Constituent, ...]
    mean: tuple[float, float]
    explained_variance: float
    residual_rms: float
    start: np.datetime64
    end: np.datetime64
    samples: int
    latitude: float
    coefficients: Any = field(repr=False, compare=False)

    @property
    def hours(self) -> float:
        """Time from the first measurement to the last, h."""
        return float((self.end - self.start) / np.timedelta64(1, "ms")) / 3.6e6

    @property
    def middle(self) -> np.datetime64:
        """The record's middle, UTC."""
        return self.start + (self.end - self.start) // 2


def tides_report(fit: TidalFit) -> dict[str, Any]:
    """Return a fit as one JSON object.

    Parameters
    ----------
    fit : TidalFit
        From `fit_tides`.

    Returns
    -------
    dict
        Numbers and standard errors by constituent, None where there is none;
        f, u and V at the record's middle under "nodal".
    """
    return {
        "start": str(fit.start),
        "end": str(fit.end),
        "hours": fit.hours,
        "samples": fit.samples,
        "latitude": fit.latitude,
        "constituents": {
            each.name: {
                **{key: _number(getattr(each, key)) for key in NUMBERS},
                "standard_errors": {key: _number(each.errors[key]) for key in NUMBERS},
            }
            for each in fit.constituents
        },
        "mean": list(fit.mean),
        "explained_variance": fit.explained_variance,
        "residual_rms": fit.residual_rms,
        "speed_units": "m s-1",
        "phase_units": "degree",
        "nodal_time": str(fit.middle),
        "nodal": nodal_report([each.name for each in fit.constituents], fit.middle, fit.latitude),
    }


def _number(value: float) -> float | None:
    return value if isfinite(value) else None
