"""SeaExplorer: dives from the glider's navigation files, NAME.gli.sub.N, plain or .gz.

A text of columns between `;`: Timestamp (day/month/year), NavState, Heading and Declination
(degrees, their sum from true north), Pitch (degrees, nose up), Depth (m), Lat and Lon
in ddmm.mmm.  A fix is a place that is new where NavState is 116, at the surface.

A dive lies between two fixes with a depth of more than 5 m between them.  It often ends in the
file after that in which it began (`dives`).  The vehicle flies along its nose,

    u = -(dz/dt)/tan(pitch),    dr = sum_i u_i (t_i - t_{i-1}) (sin h_i, cos h_i),

with dz/dt of second order in time.  Where the nose is within 10 degrees of the horizon, or u is
below 0 or above 1.5 m/s, as at a turn, u is 0.  The glider knows no angle of attack: its true
speed is another one, which the replay's speed factor learns.

The plan of the next dive is the last DesiredH (degrees), taken from true north.
"""

import zlib
from datetime import UTC, datetime
from math import nan
from pathlib import Path

import numpy as np

from ..errors import DataError
from ..files.reading import LARGEST, read_bytes, text_of
from .dives import (
    LEAST_DEPTH,
    Dive,
    Fix,
    Skipped,
    Three,
    dive_between,
    dives_across_files,
    fixes_at,
    is_fix,
)
from .samples import deepest, degrees, hole_under_water, number, track_of

GZIP = b"\x1f\x8b"
FIRST = "Timestamp;"
NEEDED = ("NavState", "Heading", "Declination", "Pitch", "Depth", "Lat", "Lon")
OPTIONAL = (
    "DeadReckoning",  # 1 where Lat, Lon are no fix
    "DesiredH",  # heading that is steered, degrees
)
AT_SURFACE = 116
LEAST_PITCH = 10.0  # degrees
FASTEST = 1.5  # m/s
Rows = np.ndarray  # a row each: time, NEEDED, OPTIONAL


def is_known(text: str) -> bool:
    """Whether a text is a navigation file."""
    line = text.partition("\n")[0]
    return line.startswith(FIRST) and "NavState" in line


def unzipped(raw: bytes, path: Path) -> str:
    """Return the text of a .gz, as far as it is whole."""
    try:
        plain = zlib.decompressobj(31).decompress(raw, LARGEST)
    except zlib.error:
        raise DataError(f"{path}: its gzip is damaged") from None
    return text_of(plain, path, "is a gzip of no text; must be a SeaExplorer's .gli file")


def dives_of(text: str, path: Path) -> tuple[list[Dive], list[Skipped]]:
    """Return the dives that end in a file."""
    last = _rows(text, path)

    def read(before: Path) -> Rows:
        raw = read_bytes(before)
        plain = unzipped(raw, before) if raw[:2] == GZIP else text_of(raw, before, "no text")
        return _rows(plain, before)

    rows, found = dives_across_files(path, last, read, _merged, _fixes_and_wet)
    if not _fixes_and_wet(rows)[0]:
        raise DataError(f"{path}: no row with a fix (NavState {AT_SURFACE})")
    digits = [part for part in path.name.split(".") if part.isdecimal()]
    which = int(digits[-1]) if digits else 0
    return [
        _dive(rows[(rows[:, 0] >= three[1][0]) & (rows[:, 0] <= three[2][0])], three, which)
        for three in found
        if three[2][0] >= last[:, 0].min()
    ], []


def _rows(text: str, path: Path) -> Rows:
    """Return the rows of a file that have a time, NaN where a number is missing."""
    lines = text.splitlines() or [""]
    if not text.endswith("\n") and len(lines) > 1:
        lines.pop()  # cut short, so its last number may be another
    header = [name.strip() for name in lines[0].split(";")]
    missing = [name for name in NEEDED if name not in header]
    if missing:
        raise DataError(f"{path}: no column {', '.join(missing)} in the SeaExplorer file")
    places = [header.index(name) if name in header else -1 for name in (*NEEDED, *OPTIONAL)]
    rows = []
    for line in lines[1:]:
        cells = line.split(";")
        try:
            when = datetime.strptime(cells[0].strip(), "%d/%m/%Y %H:%M:%S").replace(tzinfo=UTC)
        except ValueError:
            continue
        rows.append(
            [when.timestamp(), *(number(cells[k]) if 0 <= k < len(cells) else nan for k in places)]
        )
    if not rows:
        raise DataError(
            f"{path}: no line has a Timestamp such as 13/06/2019 18:21:39 in the SeaExplorer file"
        )
    return np.array(rows)


def _merged(parts: list[Rows]) -> Rows:
    """Return rows by time."""
    rows = np.concatenate(parts)
    return rows[np.unique(rows[:, 0], return_index=True)[1]]


def _fixes_and_wet(rows: Rows) -> tuple[list[Fix], np.ndarray]:
    """Return the fixes, places that are new at the surface, and times under water."""
    lat, lon = degrees(rows[:, 6]), degrees(rows[:, 7])
    afloat = (rows[:, 1] == AT_SURFACE) & ~(rows[:, 8] > 0)
    new = np.any(rows[1:, 6:8] != rows[:-1, 6:8], axis=1)
    good = np.append(False, new) & afloat & is_fix(lat, lon)
    return fixes_at(good, rows[:, 0], lat, lon), rows[rows[:, 5] > LEAST_DEPTH, 0]


def _dive(rows: Rows, fixes: Three, which: int) -> Dive:
    _, start, end = fixes
    duration, notes = end[0] - start[0], []
    steered = rows[np.isfinite(rows[:, 9]), 9]
    good = np.isfinite(rows[:, [2, 3, 4, 5]]).all(axis=1)
    rows = rows[good]
    time, heading, declination, pitch, depth = rows[:, [0, 2, 3, 4, 5]].T
    hole = "no samples" if time.size < 3 else hole_under_water(time - start[0], depth, duration)
    total, track = (nan, nan), None
    if hole:
        notes.append(hole)
    else:
        nose, true = np.radians(pitch), np.radians(heading + declination)
        with np.errstate(divide="ignore", invalid="ignore"):
            speed = -np.gradient(depth, time) / np.tan(nose)
        flies = (np.abs(pitch) > LEAST_PITCH) & (speed > 0) & (speed < FASTEST)
        step = np.where(flies, speed, 0.0) * np.diff(time, prepend=time[0])
        east, north = step * np.sin(true), step * np.cos(true)
        total = float(east.sum()), float(north.sum())
        track = track_of(time - start[0], east, north, duration)
    return dive_between(
        which,
        fixes,
        total,
        magvar=float(np.median(declination)) if declination.size else None,
        depth_max=deepest(depth),
        track=track,
        next_course=steered[-1].item() % 360.0 if steered.size else None,
        notes=tuple(notes),
    )
