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
    """One tide of a current: amplitudes (m/s), Greenwich phases and ellipse (degrees)."""

    name: str
    east: float
    east_phase: float
    north: float
    north_phase: float
    major: float
    minor: float  # negative where the current turns clockwise
    inclination: float
    phase: float
    errors: dict[str, float]  # standard error of each number; NaN where it has none


@dataclass(frozen=True)
class TidalFit:
    """Tidal constants of a record and how well they explain it."""

    constituents: tuple[Constituent, ...]  # in the order that was asked for
    mean: tuple[float, float]  # east and north, m/s
    explained_variance: float  # share about the mean, both components together
    residual_rms: float  # root of the mean squared length of the residual, m/s
    start: np.datetime64  # first measurement, UTC
    end: np.datetime64
    samples: int  # measurements that were used
    latitude: float  # of the nodal corrections, degrees north
    coefficients: Any = field(repr=False, compare=False)  # as utide.solve gives them

    @property
    def hours(self) -> float:
        """Time from the first measurement to the last, h."""
        return float((self.end - self.start) / np.timedelta64(1, "ms")) / 3.6e6

    @property
    def middle(self) -> np.datetime64:
        """The record's middle, UTC."""
        return self.start + (self.end - self.start) // 2


def tides_report(fit: TidalFit) -> dict[str, Any]:
    """Return a fit as one JSON object, numbers that are not finite as None.

    f, u and V at the record's middle stand under "nodal".
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
