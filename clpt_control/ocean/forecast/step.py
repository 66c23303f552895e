"""The record of one dive: its forecast, its misses, and what is known after it.

The forecast of a dive is made before the dive. The hindsight has the dead reckoning and the
duration of the dive too. The ellipse of either,

    (x - m)^T P^-1 (x - m) = c,  c = -2 ln(1 - LEVEL)

holds a normal pair of mean m and covariance P with probability `LEVEL`; its half axes are
sqrt(c l), l the eigenvalues of P.
"""

from dataclasses import dataclass
from functools import cached_property
from math import hypot
from typing import Any

import numpy as np

from ...base.geodesy import distance, place_from
from ...base.units import finite_or_none
from ..gliders.dives import FIELDS, Dive
from .surfacing import ELLIPSE, NextDive, Way, ellipse
from .table_rows import Row, direction, place_in, placed, utc, vector

MODELS = ("no_flow", "previous_dive", "adaptive")
FLOW_MODEL = "flow_model"  # a forecast or a fit that was given
SPEED = ("speed_factor", "speed_factor_error", "compass", "compass_error")


@dataclass
class Step:
    """A dive, its forecast, and what is known after it.

    `clpe` has |x - z| (m) of each flow model, None where it does not cover the dive. `forecast`
    (2,) and `covariance` (2, 2) are the hindsight, of the fix less dead reckoning, m;
    `inside_hindsight` is true if the vehicle surfaced in its ellipse. `current` (2,) is the learned
    flow over the dive, m/s, `speed` the factor, `compass` the error in degrees clockwise, each with
    its standard error, and `parameters` has the numbers behind them by name. `parts` has the
    probability that each part of the flow is present; the parameters `not_learned` are hardly
    better known than before any dive. `headline` is the
    forecast before the dive, `headline_held` whether its place and its time held: None for the
    first dive, and where dives between may be missing. `drift` is that before the dive.
    """

    dive: Dive
    clpe: dict[str, float | None]
    forecast: np.ndarray
    covariance: np.ndarray
    inside_hindsight: bool
    drift: Way | None
    headline: NextDive | None
    headline_held: tuple[bool, bool] | None
    current: np.ndarray
    current_error: np.ndarray
    parameters: dict[str, float]
    parts: dict[str, float]
    not_learned: tuple[str, ...]
    speed: float = 1.0
    speed_error: float = 0.0
    compass: float = 0.0
    compass_error: float = 0.0

    @property
    def response(self) -> np.ndarray:
        """I + M, the way through the water of a unit of dead reckoning, (2, 2)."""
        psi = np.radians(self.compass)
        a = self.speed * np.cos(psi)
        b = self.speed * np.sin(psi)
        return np.array([[a, b], [-b, a]])

    @cached_property
    def row(self) -> Row:
        """All of this by name, for JSON.

        Lengths are in m, times ISO 8601 UTC, currents in m/s, angles in degrees clockwise from
        north; what is not known is None.
        """
        dive = self.dive
        reckoned = place_from(*dive.start, *dive.through_water)
        east, north = map(float, self.current)
        speed: Any = self.speed, self.speed_error, self.compass, self.compass_error
        if not self.speed_error:  # none is learned
            speed = (None,) * len(SPEED)
        row = {
            **{
                field.result: getattr(dive, field.name)
                for field in FIELDS
                if field.result
            },
            "start": utc(dive.t_gps2),
            "end": utc(dive.t_gpse),
            "duration": dive.duration,
            **placed("reckoned_", *reckoned),
            "forecast": self._forecast_row(),
            "hindsight": self._hindsight_row(),
            "clpe": self.clpe,
            **vector("current_", east, north),
            "current_east_error": float(self.current_error[0]),
            "current_north_error": float(self.current_error[1]),
            "current_speed": hypot(east, north),
            "current_direction": direction(east, north),
            **dict(zip(SPEED, speed, strict=True)),
            "drift": None if self.drift is None else self.drift.as_dict(),
            "over_ground": Way(*dive.over_ground, dive.duration).as_dict(),
            "probability": self.parts,
            "notes": list(dive.notes),
        }
        return {key: finite_or_none(value) for key, value in row.items()}

    def _forecast_row(self) -> Row | None:
        """Return the forecast before the dive; None where it cannot be compared with the dive."""
        if self.headline is None or self.headline_held is None:
            return None
        fields = self.headline.as_dict()
        keys = "time", "time_half_width", "latitude", "longitude", *ELLIPSE, "basis"
        inside, on_time = self.headline_held
        return {key: fields[key] for key in keys} | {
            "error": distance(*place_in(fields, ""), *self.dive.end),
            "inside": inside,
            "on_time": on_time,
        }

    def _hindsight_row(self) -> Row:
        """Return the forecast with the dead reckoning and the duration of the dive."""
        dive = self.dive
        east, north = self.forecast
        start = dive.start
        end = place_from(*start, dive.dr_east + east, dive.dr_north + north)
        return {
            **placed("", *end),
            **vector("", east, north),
            **vector("variance_", *np.diag(self.covariance)),
            "covariance": float(self.covariance[0, 1]),
            **ellipse(self.covariance),
            "inside": self.inside_hindsight,
        }
