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
(`log_rows`).  Its displacement is unknown if that of a row is, or if a line cannot be read.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import isfinite, nan
from pathlib import Path
from typing import Any

import numpy as np
import pandas

from ...base.errors import DataError
from ...base.units import seconds_since_1970, speed_in_metres_per_second
from ...paper.currents.text_table import HEADER, OTHER_MARKS, table_of
from .dive_fields import name_of
from .dives import STEERING, STRETCH, Dive, Fix, Skipped, make_dive
from .log_rows import LogRows, time_fault

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
    steers, moves = ({*names} <= {*columns} for names in (STEERING, STRETCH))
    if steers and moves:
        raise DataError(
            f"{path}: has both course, speed and dr_east_m, dr_north_m. Leave one pair out"
        )
    vehicles = {name_of(name) for name in cells.get("vehicle", [])} or {None}
    if len(vehicles) > 1:
        raise DataError(
            f"{path}: has rows of {len(vehicles)} vehicles. Give each vehicle a table of its own"
        )
    values = _values(cells, columns, path, "." if mark == "," else ",")
    unknown = [nan] * len(cells)
    places = zip(values["latitude"], values["longitude"], strict=True)
    pairs = [
        zip(*(values.get(name, unknown) for name in names), strict=True)
        for names in (STEERING, STRETCH)
    ]
    found: list[Dive | Skipped] = []
    rows, way, number = LogRows(), None, 0
    wrong = cells.attrs["wrong_lines"]
    lost = sorted(wrong, reverse=True)
    # a line that cannot be read may be a turn
    for line, time, place, steering, stretch in zip(
        cells.index, values["time"], places, *pairs, strict=True
    ):
        where = f"{path}, line {line}"
        lost_line = ""
        while lost and lost[-1] < line:
            lost_line = f"line {lost[-1]} {wrong[lost.pop()][1]}"
        is_placed = place[0] == place[0] or place[1] == place[1]
        before = rows.time
        reading = rows.read(
            time,
            place if is_placed else None,
            steering if steers else None,
            stretch if moves else None,
            where,
        )
        if not reading.is_taken and not time > before:
            if _is_repeated(cells, line):
                continue
            if fault := time_fault(time):
                raise DataError(f"{where}: {fault}")
            raise DataError(
                f"{where}: time is {cells.at[line, cells.columns[columns['time'][0]]]!r}; must be "
                "later than in the row before. Sort the rows by time"
            )
        if reading.skipped:
            found.append(Skipped(number + 1, f"{where}: {reading.skipped}"))
        if not reading.is_taken:
            continue
        if way is not None:
            why = lost_line or (reading.unknown and f"{reading.unknown} before it")
            if why and not way.unknown:
                way.unknown = f"{where}: {why}"
            east, north = reading.moved or (0.0, 0.0)
            way.stretch(time, east, north)
        if reading.place is not None:
            fix = (time, *reading.place)
            if way is not None:
                number += 1
                leg = way.leg(number, fix)
                is_still = not (steers or moves)
                found.append(replace(leg, notes=(NO_MOTION,)) if is_still else leg)
            way = Way(fix)
    for line, (_, why) in wrong.items():
        found.append(Skipped(None, f"{path}, line {line}: {why}. Leave gaps as empty"))
    (vehicle,) = vehicles
    return [
        replace(row, vehicle=vehicle) if isinstance(row, Dive) else row for row in found
    ]


def _is_repeated(cells: pandas.DataFrame, line: int) -> bool:
    """Return whether a row is the row before it once more."""
    at = cells.index.get_loc(line)
    return at > 0 and bool((cells.iloc[at] == cells.iloc[at - 1]).all())


def _values(
    cells: pandas.DataFrame,
    columns: dict[str, tuple[int, float]],
    path: str | Path,
    comma: str,
) -> dict[str, list[float]]:
    """Return the numbers of each column, NaN where a cell is empty."""
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
        numbers = []
        for line, text in zip(cells.index, texts, strict=True):
            try:
                numbers.append(float(text) * size if text else nan)
            except ValueError:
                numbers.append(_read(text, readers.get(column), column, path, line))
        values[column] = numbers
    if not all(map(isfinite, values["time"])):
        line = cells.index[[*map(isfinite, values["time"])].index(False)]
        raise DataError(f"{path}, line {line}: time is missing; {AS_TIME}")
    return values


def _read(text: str, reader: Any, column: str, path: str | Path, line: int) -> float:
    """Return the number of a cell that is no plain number."""
    try:
        return reader(text)
    except (ValueError, TypeError):
        must_be = AS_TIME if column == "time" else "must be a number"
        raise DataError(
            f"{path}, line {line}: {column} is {text[:30]!r}; {must_be}"
        ) from None


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
