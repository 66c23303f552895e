"""Logs of any vehicle: a table with a row per moment, with a fix or with the motion.

    time,latitude,longitude,course,speed
    2024-05-01T00:00:00Z,36.70,-122.10,45,1.0
    2024-05-01T01:30:00Z,,,225,1.0
    2024-05-01T03:00:00Z,36.71,-122.08,,

`time` is in s since 1970 UTC or ISO 8601; `latitude` and `longitude` are degrees, empty where the
vehicle has no fix.  The motion through the water is `course` (degrees from true north) and `speed`
(m/s), which hold until the next row, or `dr_east_m` and `dr_north_m`, the displacement since the
row before.  A log of fixes only has legs of unknown displacement.

Other spellings: `NAMES`; units behind a name, as in `speed (kn)`, `time (ms)`, `lat (degE7)`;
degrees and minutes with a hemisphere, `36 42.5 N`; columns separated by semicolons or tabs, then
with decimal commas too.

A leg lies between two rows with a fix.  Its track is the sum of the stretches between rows
(`log_rows`).  Its displacement is unknown if that of a row is, or if a line cannot be read.  Such
lines and rows that are not in the order of time are left out, as live lines are; a table of which a
quarter is left out is refused.
"""

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from math import isfinite, isnan, nan
from pathlib import Path

import numpy as np
import pandas

from ...base.errors import DataError
from ...base.units import seconds_since_1970, speed_in_metres_per_second
from .dive_fields import name_of
from .dives import PLACE, STEERING, STRETCH, Dive, Fix, Skipped, make_dive
from .log_rows import LogRows, Pair, time_fault
from .text_table import HEADER, OTHER_MARKS, table_of

NAMES = {
    "time": ("time", "date", "datetime", "date_time"),
    "latitude": ("latitude", "lat"),
    "longitude": ("longitude", "lon", "long", "lng"),
    "course": ("course", "heading", "true_heading"),
    "speed": ("speed", "stw", "speed_through_water"),
    "dr_east_m": ("dr_east_m",),
    "dr_north_m": ("dr_north_m",),
}
PLACED = ("time", "latitude", "longitude")
TIMES = {"utc": 1.0, "gmt": 1.0, "s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
DEGREES = {"dege7": 1e-7, "1e-7deg": 1e-7, "degw": -1.0, "degs": -1.0}
MINUTES = re.compile(r"(\d{1,3})[°d:\s]\s*(\d{1,2}(?:\.\d*)?)\s*['′m]?\s*([NSEW])")
HEMISPHERE = re.compile(r"(\d{1,3}(?:\.\d*)?)\s*°?\s*([NSEW])")
AS_TIME = "must be seconds since 1970 UTC, or a date such as 2016-01-31T22:04:50Z"
NO_MOTION = (
    "the table has fixes without the motion through the water. Give columns course (degrees) and "
    "speed (m/s), or dr_east_m and dr_north_m, not course and speed over ground; a drifter has "
    "none: clpt estimate --drifter"
)
MOST_LEFT_OUT = 0.25  # of the rows, else a table is refused
GIVE = "time,latitude,longitude,course,speed"


@dataclass
class Way:
    """Way through the water since a fix: elapsed time (s), east and north (m) of each row."""

    start: Fix
    points: list[tuple[float, float, float]] = field(
        default_factory=lambda: [(0.0, 0.0, 0.0)]
    )
    unknown: str = ""

    def stretch(self, time: float, east: float, north: float) -> None:
        """Add a stretch that ends at a time."""
        _, x, y = self.points[-1]
        self.points.append((time - self.start[0], x + east, y + north))

    def leg(self, number: int, end: Fix) -> Dive:
        """Return the leg that ends at a fix."""
        if self.unknown:
            return make_dive(number, self.start, end, (nan, nan), notes=(self.unknown,))
        track = np.array(self.points).T
        leg = make_dive(number, self.start, end, (track[1, -1], track[2, -1]))
        return replace(leg, track=tuple(track))


def mark_of(text: str) -> str:
    """Return the mark that separates the columns of a log; empty if a text is no log."""
    header = next(
        (line for line in text.splitlines() if line.strip() and line.strip()[0] != "#"),
        "",
    )
    for mark in (",", *OTHER_MARKS):
        names = {_name_and_unit(cell)[0] for cell in header.split(mark)}
        if "dive" not in names and all(names & {*NAMES[name]} for name in PLACED):
            return mark
    return ""


def _name_and_unit(cell: str) -> tuple[str, str]:
    """Return name and unit of a cell of the header, in small letters."""
    matched = HEADER.fullmatch(cell.strip(' "'))
    name, unit = (matched[1], matched[2] or "") if matched else (cell, "")
    return "_".join(name.lower().split()), "".join(unit.lower().split())


def _columns(header: list[str], path: str | Path) -> dict[str, tuple[int, float]]:
    """Return the place of each column that is read, and the size of its unit."""
    columns: dict[str, tuple[int, float]] = {}
    for place, cell in enumerate(header):
        name, unit = _name_and_unit(cell)
        column = next((key for key, names in NAMES.items() if name in names), "")
        is_course = any(word in name for word in ("heading", "course"))
        if is_course and ("mag" in name or unit.startswith("mag")):
            raise DataError(
                f"{path}: {cell} is magnetic. Turn it by the variation and name it course"
            )
        if not column:
            continue
        if column in columns:
            raise DataError(f"{path}: has {column} twice, as {cell}. Leave one out")
        sizes = TIMES if column == "time" else DEGREES
        size = sizes.get(unit, 1.0)
        if column == "speed" and unit:
            size = speed_in_metres_per_second(unit, f"{path}: speed")
        elif not (unit in ("", *sizes) or unit.startswith(("deg", "°", "y", "iso"))):
            raise DataError(
                f"{path}: {column} is in {unit!r}. Give {GIVE} in degrees and m/s"
            )
        columns[column] = place, size
    return columns


def log_legs(text: str, path: str | Path, mark: str) -> list[Dive | Skipped]:
    """Return the legs of a log, with NaN for an unknown displacement, and what is left out."""
    cells = table_of(text, path, f"a log with {GIVE}", mark)
    columns = _columns(list(cells.columns), path)
    has_motion = {part: {*part} <= {*columns} for part in (STEERING, STRETCH)}
    if all(has_motion.values()):
        raise DataError(
            f"{path}: has both course, speed and dr_east_m, dr_north_m. Leave one pair out"
        )
    vehicles = {name_of(name) for name in cells.get("vehicle", [])} or {None}
    if len(vehicles) > 1:
        raise DataError(
            f"{path}: has rows of {len(vehicles)} vehicles. Give each vehicle a table of its own"
        )
    wrong = {
        line: f"{path}, line {line}: {why}. Leave gaps as empty"
        for line, (_, why) in cells.attrs["wrong_lines"].items()
    }
    values = _values(cells, columns, path, "." if mark == "," else ",", wrong)

    def pairs(names: tuple[str, str], is_there: bool) -> Iterable[Pair | None]:
        if not is_there:
            return [None] * len(cells)
        return zip(*(values[name] for name in names), strict=True)

    motion = [pairs(part, is_there) for part, is_there in has_motion.items()]
    parts = zip(values["time"], pairs(PLACE, True), *motion, strict=True)
    rows = dict(zip(cells.index, parts, strict=True))
    repeated = cells.index[(cells == cells.shift()).all(axis=1)]
    found = _legs_of(rows, wrong, set(repeated), path)
    if not any(has_motion.values()):
        found = [
            replace(row, notes=(NO_MOTION,)) if isinstance(row, Dive) else row
            for row in found
        ]
    (vehicle,) = vehicles
    return [
        replace(row, vehicle=vehicle) if isinstance(row, Dive) else row for row in found
    ]


def _legs_of(
    cells: dict[int, tuple[float, Pair, Pair | None, Pair | None]],
    wrong: dict[int, str],
    repeated: set[int],
    path: str | Path,
) -> list[Dive | Skipped]:
    """Return legs and what is left out of rows by line; `wrong` has lines that cannot be read."""
    found: list[Dive | Skipped] = []
    rows, way, number = LogRows(), None, 0
    left_out: list[str] = []
    for line in sorted({*cells, *wrong}):
        where = f"{path}, line {line}"
        before = rows.time
        try:
            if line in wrong:
                raise DataError(wrong[line])
            time, place, steering, stretch = cells[line]
            is_placed = not all(map(isnan, place))
            fix = place if is_placed else None
            reading = rows.read(time, fix, steering, stretch, where)
        except DataError as error:
            found.append(Skipped(number + 1, str(error)))
            left_out.append(str(error))
            rows.lost = f"line {line} is left out"  # which may be a turn
            continue
        if not reading.is_taken and line in repeated:
            continue
        if reading.skipped:
            found.append(Skipped(number + 1, f"{where}: {reading.skipped}"))
        if not reading.is_taken:
            if not time > before:
                cure = "" if time_fault(time) else ". Sort the rows by time"
                left_out.append(f"{where}: {reading.skipped}{cure}")
            continue
        if way is not None:
            if reading.unknown and not way.unknown:
                way.unknown = f"{where}: {reading.unknown} before it"
            way.stretch(time, *(reading.moved or (0.0, 0.0)))
        if reading.place is not None:
            dated = (time, *reading.place)
            if way is not None:
                number += 1
                found.append(way.leg(number, dated))
            way = Way(dated)
    if len(left_out) > MOST_LEFT_OUT * len({*cells, *wrong}):
        raise DataError(left_out[0])
    return found


def _values(
    cells: pandas.DataFrame,
    columns: dict[str, tuple[int, float]],
    path: str | Path,
    comma: str,
    wrong: dict[int, str],
) -> dict[str, list[float]]:
    """Return the numbers of each column, NaN where a cell is empty; add what cannot be read."""
    readers: dict[str, Callable[[str], float]] = {
        "time": seconds_since_1970,
        "latitude": _degrees,
        "longitude": _degrees,
    }
    values = {}
    for column, (place, size) in columns.items():
        texts = cells.iloc[:, place].tolist()
        if comma != ".":
            texts = [text.replace(comma, ".") for text in texts]
        must_be = AS_TIME if column == "time" else "must be a number"
        numbers = []
        for line, text in zip(cells.index, texts, strict=True):
            number = nan
            try:
                number = float(text) * size if text else nan
            except ValueError:
                try:
                    number = readers.get(column, float)(text)
                except (ValueError, TypeError):
                    wrong[line] = (
                        f"{path}, line {line}: {column} is {text[:30]!r}; {must_be}"
                    )
            if column == "time" and line not in wrong and not isfinite(number):
                wrong[line] = f"{path}, line {line}: time is missing; {AS_TIME}"
            numbers.append(number)
        values[column] = numbers
    return values


def _degrees(text: str) -> float:
    """Return the degrees of a text with a hemisphere.

    >>> _degrees("36 42.5 N"), _degrees("122.1W")
    (36.708333333333336, -122.1)
    """
    matched = MINUTES.fullmatch(text) or HEMISPHERE.fullmatch(text)
    if matched is None:
        raise ValueError
    *numbers, letter = matched.groups()
    value = float(numbers[0])
    if len(numbers) > 1:
        if not float(numbers[1]) < 60.0:
            raise ValueError
        value += float(numbers[1]) / 60.0
    return -value if letter in "SW" else value
