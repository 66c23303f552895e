"""Log of a vehicle, CSV: a row per moment, with a fix or with the motion through the water.

    time,latitude,longitude,course,speed
    2024-05-01T00:00:00Z,36.70,-122.10,45,1.0
    2024-05-01T01:30:00Z,,,225,1.0
    2024-05-01T03:00:00Z,36.71,-122.08,,

`time` is in s since 1970 UTC or ISO 8601; `latitude` and `longitude` are degrees, empty where the
vehicle has no fix.  The motion through the water is `course` (degrees from true north) and `speed`
(m/s), which hold until the next row, or `dr_east_m` and `dr_north_m`, the displacement since the
row before.  A log of fixes only has legs of unknown displacement.

A leg lies between two rows with a fix.  Its track is the sum of the stretches between rows; it is
left out if the motion of a row in between is not known.
"""

from contextlib import suppress
from dataclasses import dataclass, field, replace
from math import isfinite, nan
from pathlib import Path

import numpy as np
import pandas

from ...base.errors import DataError
from ...base.units import seconds_since_1970
from .dives import STEERING, STRETCH, Dive, Fix, make_dive, name_of, velocity_of

NAMES = {
    "time": ("time", "date", "datetime"),
    "latitude": ("latitude", "lat"),
    "longitude": ("longitude", "lon"),
}
AS_TIME = "must be seconds since 1970 UTC, or a date such as 2016-01-31T22:04:50Z"
NO_MOTION = (
    "the table has fixes without the motion through the water. Give columns course (degrees) and "
    "speed (m/s), or dr_east_m and dr_north_m; a drifter has none: clpt estimate --drifter"
)


@dataclass
class Way:
    """Way through the water since a fix: elapsed time (s), east and north (m) of each row."""

    start: Fix
    points: list[tuple[float, float, float]] = field(
        default_factory=lambda: [(0.0, 0.0, 0.0)]
    )

    def stretch(self, time: float, east: float, north: float) -> None:
        """Add a stretch that ends at a time, NaN if its displacement is not known."""
        _, x, y = self.points[-1]
        self.points.append((time - self.start[0], x + east, y + north))

    def leg(self, number: int, end: Fix) -> Dive:
        """Return the leg that ends at a fix."""
        track = np.array(self.points).T
        east, north = float(track[1, -1]), float(track[2, -1])
        known = isfinite(east) and isfinite(north)
        leg = make_dive(number, self.start, end, (east, north))
        return replace(leg, track=tuple(track)) if known else leg


def is_log(header: list[str]) -> bool:
    """Return whether a table's header is that of a log."""
    return all(_column(header, name) for name in NAMES)


def _column(header: list[str], name: str) -> str:
    return next((column for column in header if column.lower() in NAMES[name]), "")


def log_legs(cells: pandas.DataFrame, path: str | Path) -> list[Dive]:
    """Return the legs of a log, with NaN for an unknown displacement."""
    header = list(cells.columns)
    has_steering, has_stretches = (
        set(names) <= set(header) for names in (STEERING, STRETCH)
    )
    if has_steering and has_stretches:
        raise DataError(
            f"{path}: has both course, speed and dr_east_m, dr_north_m. Leave one pair out"
        )
    columns = {name: _column(header, name) for name in NAMES}
    vehicles = {name_of(name) for name in cells.get("vehicle", [])} or {None}
    if len(vehicles) > 1:
        raise DataError(
            f"{path}: has rows of {len(vehicles)} vehicles. Give each vehicle a table of its own"
        )
    rows: list[Dive] = []
    way: Way | None = None
    time, velocity = nan, (nan, nan)
    for line, *row in cells.itertuples():
        texts = dict(zip(header, row, strict=True))
        where = f"{path}, line {line}"

        def value(column: str, is_time: bool = False) -> float:
            text = texts[column]  # noqa: B023 - called in this turn
            number = row_number(text, is_time)
            if text and number is None:
                must_be = AS_TIME if is_time else "must be a number"
                raise DataError(f"{where}: {column} is {text[:30]!r}; {must_be}")  # noqa: B023
            return nan if number is None else number

        now = value(columns["time"], is_time=True)
        if not isfinite(now) or (isfinite(time) and now <= time):
            raise DataError(
                f"{where}: time is {texts[columns['time']][:30]!r}; must be later than in the row "
                "before"
            )
        # 1. the stretch that ends here
        if way is not None:
            if has_stretches:
                way.stretch(now, *(value(column) for column in STRETCH))
            else:
                way.stretch(now, *(speed * (now - time) for speed in velocity))
        # 2. a fix ends the leg and begins the next one
        place = value(columns["latitude"]), value(columns["longitude"])
        if isfinite(place[0]) != isfinite(place[1]):
            raise DataError(f"{where}: has one of latitude and longitude. Give both")
        if isfinite(place[0]):
            if way is not None:
                leg = way.leg(len(rows) + 1, (now, *place))
                rows.append(leg if has_steering or has_stretches else _unknown(leg))
            way = Way((now, *place))
        # 3. the velocity until the next row
        if has_steering:
            velocity = velocity_of(value("course"), value("speed"), where)
        time = now
    return [replace(leg, vehicle=vehicles.copy().pop()) for leg in rows]


def _unknown(leg: Dive) -> Dive:
    return replace(leg, notes=(NO_MOTION,))


def row_number(text: str, is_time: bool) -> float | None:
    """Return the number or the date, s since 1970, that a text is, or None."""
    for read in (float, seconds_since_1970) if is_time else (float,):
        with suppress(ValueError):
            return read(text)
    return None
