"""Logs of any vehicle: a table with a row per moment, with a fix or with the motion.

    time,latitude,longitude,course,speed
    2024-05-01T00:00:00Z,36.70,-122.10,45,1.0
    2024-05-01T01:30:00Z,,,225,1.0
    2024-05-01T03:00:00Z,36.71,-122.08,,

`time` is in s since 1970 UTC or ISO 8601; `latitude` and `longitude` are degrees, empty where the
vehicle has no fix.  The motion through the water is `course` (degrees from true north) and `speed`
(m/s), which hold until the next row, or `dr_east_m` and `dr_north_m`, the displacement since the
row before.  A log of fixes only has legs of unknown displacement.

Other spellings are in the rows of the columns (`dive_fields`): other names, units behind a name, as
in `speed (kn)`, `time (ms)`, `lat (degE7)`, and degrees, minutes and seconds, as in `36 42.5 N`.
Columns `date` and `time` (of day) are joined.  Cells that mean "none" are gaps (`Column.is_none`).

A leg lies between two rows with a fix.  Its track is the sum of the stretches between rows
(`log_rows`).  Its displacement is unknown if that of a row is, or if a line cannot be read.  Such
lines and rows that are not in the order of time are left out; a table of which a quarter is left
out is refused.  Positions that a column marks (`fix_columns`), or that carry no measurement
(`unmeasured`), are no fixes.
"""

import re
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import replace
from itertools import chain
from math import atan2, degrees, hypot, isnan, nan, pi
from pathlib import Path
from typing import Any

import numpy as np
from pandas import DataFrame, Series, to_numeric

from ...base.errors import DataError
from .dive_fields import GIVE, HEADINGS, RADIAN, TIME, name_of
from .dives import (
    COLUMNS,
    FASTEST,
    PLACE,
    STEERING,
    STRETCH,
    VELOCITY,
    YAW,
    Dive,
    DivesOrSkipped,
    Fix,
    Pair,
    Skipped,
    make_dive,
    reckoned,
)
from .fix_columns import places_without_fix
from .log_rows import LogRows, Reading, time_fault
from .text_table import header_of, table_of
from .unmeasured import counted, unmeasured

# a name, and a unit; without spaces, which would be tried
HEADER = re.compile(r"([^([]*)(?:[(\[]([^)\]]*)[)\]])?")
PLACED = ("time", *PLACE)
NAMES_OF_TIME = (*COLUMNS["time"].names.split(), "time")
# time, fix, course and speed, displacement: None for a part that the row has not
Moment = tuple[float, Pair | None, Pair | None, Pair | None]
UNKNOWN: Moment = (nan, None, None, None)
MOTIONS = STEERING, STRETCH, YAW, VELOCITY
NAMES = (*PLACED, "nanosec", *chain(*MOTIONS))
LOG_COLUMNS = {
    name: COLUMNS[header]
    for header in NAMES
    for name in (header, *COLUMNS[header].names.split())
}
# a log of AIS, whose course of 360 degrees means "none", has a column or another such number of it
AIS = re.compile(r"\b(mmsi|cog|sog)\b", re.IGNORECASE)
OF_OTHER_ROWS = (
    "the motion of each row looks like that of the row before. Move it up by one row",
    "the motion of each row looks like that of the row behind. Move it down by one row",
    "displacements look like those since the last fix. Give those since the row before",
)
ROUNDED_TURN = 360.01  # degrees: 2 pi to four digits is more than a turn
MANY = 10  # courses
FEWEST_LEGS, CLEAR = 8, 0.2  # of the variance: a log-likelihood ratio above 1e5
NO_MOTION = (
    "the table has fixes without the motion through the water. Give columns course (degrees) and "
    "speed (m/s), or dr_east_m and dr_north_m, not course and speed over ground; a drifter has "
    "none: clpt estimate --drifter"
)
LEAST_NANOSECONDS = 1e17  # since 1970, as robots count; in seconds no time is as large
NOISE = 100.0  # m, of two fixes
MOST_LEFT_OUT = 0.25  # of the rows, else a table is refused


def is_log(text: str) -> bool:
    """Return whether a text is a log."""
    header, _ = header_of(text)
    return "dive" not in header and log_columns(header) >= {*PLACED}


def log_columns(header: list[str]) -> set[str]:
    """Return the columns of a log that a header has."""
    names = {_name_and_unit(cell)[0] for cell in header}
    return {row.header for name, row in LOG_COLUMNS.items() if name in names}


def _name_and_unit(cell: str) -> tuple[str, str]:
    """Return name and unit of a cell of the header, in small letters."""
    matched = HEADER.fullmatch(cell.strip(' "'))
    name, unit = (matched[1], matched[2] or "") if matched else (cell, "")
    return "_".join(name.lower().split()), unit.strip().lower()


def _columns(header: list[str], path: Path) -> dict[str, tuple[int, float]]:
    """Return the number of each column that is read, and the size of its unit."""
    columns = {}
    for column, cell in enumerate(header):
        name, unit = _name_and_unit(cell)
        is_course = any(word in name for word in ("heading", "course"))
        if is_course and ("mag" in name or unit.startswith("mag")):
            raise DataError(
                f"{path}: {cell} is magnetic. Turn it by the variation and name it course"
            )
        row = LOG_COLUMNS.get(name)
        if row is None:
            continue
        if row.header in columns:
            raise DataError(f"{path}: has {row.header} twice, as {cell}. Leave one out")
        size = row.default_size
        if unit:
            size = row.size_of(unit, f"{path}: {row.header}")
        columns[row.header] = column, size
    return columns


def _dated(cells: DataFrame) -> DataFrame:
    """Return cells with the columns of date and of the time of day joined."""
    names = {_name_and_unit(cell)[0]: cell for cell in cells.columns}
    times = [names[name] for name in NAMES_OF_TIME if name in names]
    if "date" not in names or len(times) != 2 or cells.columns.has_duplicates:
        return cells
    date, time = times
    is_dated = cells[time].str.contains(r"\d-\d\d-\d")
    joined = cells[date].str.replace("/", "-") + "T" + cells[time]
    return cells.assign(**{time: cells[time].where(is_dated, joined)}).drop(
        columns=date
    )


def log_legs(text: str, path: Path, every_row: bool = False) -> DivesOrSkipped:
    """Return the legs of a log, with NaN for an unknown displacement, and what is left out.

    With `every_row` each position is a fix that no column marks as none.
    """
    cells = _dated(table_of(text, path, f"a log with {GIVE}"))
    cells = cells[~(cells == cells.shift()).all(axis=1)]
    columns = _columns(list(cells.columns), path)
    motions = [motion for motion in MOTIONS if {*motion} <= {*columns}]
    if {STEERING, STRETCH} <= {*motions}:
        raise DataError(
            f"{path}: has both course, speed and dr_east_m, dr_north_m. Leave one pair out"
        )
    vehicles = {name_of(name) for name in cells.get("vehicle", [])} or {None}
    if len(vehicles) > 1:
        raise DataError(
            f"{path}: has rows of {len(vehicles)} vehicles. Give each vehicle a table of its own"
        )
    # courses of 360 degrees
    course, _ = columns.get("course", (0, 1.0))
    is_360 = cells.iloc[:, course].str.fullmatch(r"360(\.0*)?")
    speed, _ = columns.get("speed", (0, 1.0))
    marks = ((course, "511"), (speed, "102.3"))
    marked = any((cells.iloc[:, column] == mark).any() for column, mark in marks)
    meaning = "none" if AIS.search(text) or marked else "north"
    if meaning == "none":
        cells.isetitem(course, cells.iloc[:, course].mask(is_360, ""))
    # headings and positions that are none
    notes = []
    for name in {"course", "yaw"} & {*columns}:
        column, size = columns[name]
        angles = to_numeric(cells.iloc[:, column], errors="coerce") * size
        has_unit = _name_and_unit(cells.columns[column])[1]
        if name == "course" and not has_unit and _look_like_radians(angles):
            raise DataError(
                f"{path}: {cells.columns[column]} has only numbers within 2 pi, which look like "
                "radians. Name the column course (rad), or course (deg) if they are degrees"
            )
        is_none = _repeats_outside(angles)
        if is_none.any():
            which = ", ".join(f"{angle:.7g}" for angle in angles[is_none].unique())
            notes.append(
                f"{is_none.sum()} values of {name}, {which} degrees, are read as none"
            )
        cells.isetitem(column, cells.iloc[:, column].mask(is_none, ""))
    headings = "; ".join(notes)
    places = [columns[name][0] for name in PLACE]
    has_place = (cells.iloc[:, places] != "").any(axis=1)
    no_fix, of_columns = places_without_fix(cells, has_place, path)
    notes += of_columns
    for place in places:
        cells.isetitem(place, cells.iloc[:, place].mask(no_fix, ""))
    # rows
    names = {*PLACED, "nanosec", *chain(*motions[:1])}
    sizes = {name: column for name, column in columns.items() if name in names}
    for name, (number, size) in sizes.items():
        if all(COLUMNS[name].is_none(cell, size) for cell in cells.iloc[:, number]):
            raise DataError(
                f"{path}: each value of {name} is empty or means none, such as N/A, -999 or "
                "heading 511. Give values, or leave the column out"
            )
    moments = {
        line: _moment(texts, sizes)
        for line, texts in zip(cells.index, cells.to_numpy(), strict=True)
    }
    for line, (_, why) in cells.attrs["wrong_lines"].items():
        moments[line] = UNKNOWN, f"{why}. Leave gaps as empty"
    # legs
    legs = _legs_of(moments, path, every_row)
    dives = [leg for leg in legs if isinstance(leg, Dive)]
    unknown = sum(isnan(leg.dr_east) for leg in dives)
    if headings and unknown > MOST_LEFT_OUT * len(dives):
        raise DataError(
            f"{path}: {headings}: the motion of {unknown} of {len(dives)} legs is not known. "
            "Leave these rows out if the course before them holds, or give their courses"
        )
    legs += [Skipped(None, f"{path}: {note}") for note in notes]
    _check_legs(dives, bool(motions), path)
    if is_360.any():
        courses = f"{is_360.sum()} courses of 360 degrees are read as {meaning}"
        legs.append(Skipped(None, f"{path}: {courses}"))
    changes: dict[str, Any] = {"vehicle": vehicles.pop()}
    if not motions:
        changes["notes"] = (NO_MOTION,)
    return [replace(row, **changes) if isinstance(row, Dive) else row for row in legs]


def _look_like_radians(angles: Series) -> bool:
    """Return whether many courses are all within a turn of radians, and spread over half of it."""
    is_small = angles.abs().max() <= ROUNDED_TURN / RADIAN
    return bool(is_small and np.ptp(angles.dropna()) > pi and angles.nunique() >= MANY)


def _repeats_outside(angles: Series) -> Series:
    """Return the angles (degrees) that mean none: one number or two beyond the turn of the others.

    >>> _repeats_outside(Series([375.4879, 10.0, 375.4879, 350.0])).tolist()
    [True, False, True, False]
    """
    turns = angles.between(0.0, ROUNDED_TURN), angles.between(-180.0, 180.0)
    outside = angles.between(*HEADINGS) & ~max(turns, key=Series.sum)
    counts = angles[outside].value_counts()
    return outside & (len(counts) <= 2) & (counts.min() > 1)


def _moment(
    texts: list[str], columns: dict[str, tuple[int, float]]
) -> tuple[Moment, str]:
    """Return the parts of a row, and what is wrong with a cell."""
    numbers = {}
    fault = ""
    for name, (column, size) in columns.items():
        number, wrong = COLUMNS[name].value(texts[column], size)
        numbers[name] = nan if number is None else number
        fault = wrong or fault
    if isnan(numbers["time"]) and not fault:
        fault = f"time is missing; {TIME.must_be}"
    if numbers["time"] > LEAST_NANOSECONDS:
        numbers["time"] *= 1e-9
    numbers["time"] += 1e-9 * numbers.get("nanosec", 0.0)
    if "yaw" in numbers:
        numbers["course"] = 90.0 - numbers["yaw"]
    if VELOCITY[0] in numbers:
        east, north = (numbers[name] for name in VELOCITY)
        numbers["course"] = degrees(atan2(east, north))
        numbers["speed"] = hypot(east, north)
    fix, steering, stretch = (
        (numbers[pair[0]], numbers[pair[1]]) if pair[0] in numbers else None
        for pair in (PLACE, STEERING, STRETCH)
    )
    if fix and all(map(isnan, fix)):
        fix = None
    return (numbers["time"], fix, steering, stretch), fault


def _check_legs(legs: list[Dive], has_motion: bool, path: Path) -> None:
    """Refuse legs whose flow is impossible, or is much the same with the motion of other rows."""
    if not legs:
        return
    drifts = np.nan_to_num(
        [leg.miss if has_motion else leg.over_ground for leg in legs]
    )
    lengths = np.hypot(*drifts.T) - NOISE
    flow = float(np.median(lengths / [leg.duration for leg in legs]))
    if flow > FASTEST:
        raise DataError(
            f"{path}: the fixes show a flow of {flow:.3g} m/s: times look like minutes, hours or "
            f"days, or places like ddmm.mmm. A time {TIME.must_be}"
        )
    legs = [leg for leg in legs if leg.track is not None]
    if len(legs) < FEWEST_LEGS:
        return
    # displacements of the rows, as they are and as each cause would have them
    tracks = [np.diff(reckoned(leg)) for leg in legs]
    begins = np.cumsum([0, *(track[0].size for track in tracks[:-1])])
    moved = np.hstack(tracks)[1:]
    before = np.roll(moved, 1, axis=1)
    behind = np.roll(moved, -1, axis=1)
    since_row = moved - before
    since_row[:, begins] = moved[:, begins]
    # variance of the flow of legs but the first and the last, m2/s2
    sums = np.add.reduceat([moved, behind, before, since_row], begins, axis=2)
    drift = np.transpose([leg.over_ground for leg in legs]) - sums
    durations = [leg.duration for leg in legs]
    scatter = (drift / durations)[..., 1:-1].var(axis=2).sum(axis=1)
    likely = np.array(OF_OTHER_ROWS)[scatter[1:] < CLEAR * scatter[0]]
    if likely.size:
        raise DataError(f"{path}: {'; or '.join(likely)}")


def _in_order(times: dict[int, float]) -> set[int]:
    """Return the lines of the longest part of a log that is in the order of time."""
    ends: list[float] = []  # -time at the begin of the best part of each length
    best_lines: list[tuple] = [
        ()
    ]  # the best of each length: its first line, and the others
    for number, time in reversed(times.items()):
        length = bisect_right(ends, -time)
        ends[length : length + 1] = [-time]
        best_lines[length + 1 : length + 2] = [(number, best_lines[length])]
    ordered = set()
    remaining = best_lines[-1]
    while remaining:
        line, remaining = remaining
        ordered.add(line)
    return ordered


def _readings(
    moments: dict[int, tuple[Moment, str]], rows: LogRows
) -> Iterator[tuple[int, float, Reading]]:
    """Yield line and time of each row, and the parts of it that count."""
    in_order = _in_order(
        {
            line: moment[0]
            for line, (moment, fault) in sorted(moments.items())
            if not (fault or time_fault(moment[0]))
        }
    )
    for line, (moment, fault) in sorted(moments.items()):
        if fault:
            rows.lost = f"line {line} is left out"  # which may be a turn
            yield line, moment[0], Reading(skipped=fault, is_taken=False)
        else:
            yield line, moment[0], rows.read(*moment, line in in_order)


def _kinds_of(readings: list[tuple[int, float, Reading]]) -> list[str]:
    """Return the kind of each position, empty for a fix."""
    step = 0j
    rows = []
    for _, time, reading in readings:
        step += complex(*(reading.moved or (nan if reading.unknown else 0.0, 0.0)))
        if reading.fix is not None:
            rows.append((time, *reading.fix, step))
            step = 0j
    times, *position, steps = np.array(rows).reshape(-1, 4).T
    return unmeasured(times.real, np.real(position).T, steps[1:]).tolist()


def _leg(
    number: int,
    start: Fix,
    end: Fix,
    points: list[tuple[float, float, float]],
    unknown: str,
) -> Dive:
    """Return a leg by time (s) and displacement (m) of each row, or why they are unknown."""
    if unknown:
        return make_dive(number, start, end, (nan, nan), notes=(unknown,))
    time, *steps = np.transpose(points)
    east, north = np.cumsum(steps, axis=1)
    track = time - start[0], east, north
    return make_dive(number, start, end, (east[-1], north[-1]), track=track)


def _legs_of(
    moments: dict[int, tuple[Moment, str]], path: Path, every_row: bool
) -> DivesOrSkipped:
    """Return legs and what is left out of rows by line, each with its fault."""
    legs: DivesOrSkipped = []
    rows = LogRows()
    start: Fix = (nan, nan, nan)
    points: list[tuple[float, float, float]] = []
    unknown = ""
    number = 0
    left_out: list[str] = []
    readings = [*_readings(moments, rows)]
    kinds = [""] * len(readings) if every_row else _kinds_of(readings)
    remaining = iter(kinds)
    for line, time, reading in readings:
        where = f"{path}, line {line}"
        if reading.skipped:
            legs.append(Skipped(number + 1, f"{where}: {reading.skipped}"))
        if not reading.is_taken:
            left_out.append(f"{where}: {reading.skipped}{reading.cure}")
            continue
        if points:
            if reading.unknown and not unknown:
                unknown = f"{where}: {reading.unknown} before it"
            points.append((time, *(reading.moved or (0.0, 0.0))))
        if reading.fix is not None and not next(remaining):
            end = (time, *reading.fix)
            if points:
                number += 1
                legs.append(_leg(number, start, end, points, unknown))
            start = end
            points = [(time, 0.0, 0.0)]
            unknown = ""
    dropped = f"{path}: {rows.dropped} fixes at the time of another are left out"
    left_out += [f"{dropped}. Give the time of day"] * rows.dropped
    if why := counted(kinds):
        legs.append(Skipped(None, f"{path}: {why}"))
    if rows.dropped:
        legs.append(Skipped(None, dropped))
    if len(left_out) > MOST_LEFT_OUT * len(moments):
        raise DataError(left_out[0])
    return legs
