"""SeaExplorer: dives from the glider's navigation files, NAME.gli.sub.N, plain or .gz.

A text of columns between `;`: Timestamp (day/month/year), NavState, Heading and Declination
(degrees, their sum from true north), Pitch (degrees, nose up), Depth (m), Lat and Lon
in ddmm.mmm.  A fix is a place that is new where NavState is 116, at the surface.  A Declination
of 0 in a whole dive, or none, is not known: IGRF's is taken.

A dive lies between two fixes with a depth of more than 5 m between them.  It often ends in the
file after that in which it began (`mission_files`).  The vehicle flies along its nose,

    u = -(dz/dt)/tan(pitch),    dr = sum_i u_i (t_i - t_{i-1}) (sin h_i, cos h_i),

with dz/dt of second order in time.  Where the nose is within 10 degrees of the horizon, or u is
below 0 or above 1.5 m/s, as at a turn, u is 0.  The glider knows no angle of attack: its true
speed is another one, which the replay's speed factor learns.

The plan of the next dive is the last DesiredH (degrees), taken from true north.
"""

import zlib
from math import isfinite
from pathlib import Path

import numpy as np
import pandas

from ...base.errors import DataError
from ...base.files.reading import LARGEST, read_bytes, text_of
from .dive_fields import HEADINGS, VARIATIONS
from .dives import (
    LEAST_DEPTH,
    Dive,
    DivesOrSkipped,
    Fix,
    Three,
    ThroughWater,
    dive_between,
    fixes_in,
)
from .mission_files import dives_across_files, logged
from .samples import DEEPEST, PITCHES, deepest, degrees, summed, variation, within
from .text_table import table_of

GZIP = b"\x1f\x8b"
FIRST = "Timestamp;"
NEEDED = ("NavState", "Heading", "Declination", "Pitch", "Depth", "Lat", "Lon")
OPTIONAL = (
    "DeadReckoning",  # 1 where Lat, Lon are no fix
    "DesiredH",  # heading that is steered, degrees
)
ANGLES = {
    "Heading": HEADINGS,
    "Declination": VARIATIONS,
    "Pitch": PITCHES,
    "DesiredH": HEADINGS,
}
OUTSIDE = "outside"  # angles of a row that are not within their limits
AT_SURFACE = 116
UNDER_WATER = (100, 117, 118)  # down, up, from one to the other
LEAST_PITCH = 10.0  # degrees
ANOTHER = 5.0  # degrees from IGRF: not that of the place
FASTEST = 1.5  # m/s


def is_known(text: str) -> bool:
    """Return whether a text is a navigation file."""
    line = text.partition("\n")[0]
    return line.startswith(FIRST) and "NavState" in line


def text_in(raw: bytes, path: Path, no_text: str = "no text") -> str:
    """Return the text of a file, of a .gz as far as it is whole."""
    if not raw.startswith(GZIP):
        return text_of(raw, path, no_text)
    plain = b""
    while raw.strip(b"\0") and len(plain) < LARGEST:  # members (RFC 1952)
        member = zlib.decompressobj(31)
        try:
            plain += member.decompress(raw, LARGEST - len(plain))
        except zlib.error:
            raise DataError(f"{path}: its gzip is damaged") from None
        raw = member.unused_data
    return text_of(
        plain, path, "is a gzip of no text; must be a SeaExplorer's .gli file"
    )


def dives_of(text: str, path: Path) -> DivesOrSkipped:
    """Return the dives that end in a file."""

    def read(before: Path) -> pandas.DataFrame:
        return _log(text_in(read_bytes(before), before), before)

    last = _log(text, path)
    log, found, unknown = dives_across_files(path, last, read, _fixes_and_wet)
    if not _fixes_and_wet(log)[0]:
        raise DataError(f"{path}: no row with a fix (NavState {AT_SURFACE})")
    digits = [field for field in path.name.split(".") if field.isdecimal()]
    number = int(digits[-1]) if digits else 0
    dives = [
        _dive(log.loc[fixes[1][0] : fixes[2][0]], fixes, number, lost)
        for fixes, lost in found
    ]
    return [*unknown, *dives]


def _log(text: str, path: Path) -> pandas.DataFrame:
    """Return the rows of a file that have a time, by it, NaN where a number is missing."""
    if not text.endswith("\n"):  # cut short, so its last number may be another
        text = text.rpartition("\n")[0] or text
    cells = table_of(text, path, "a SeaExplorer's .gli file")
    cells = cells.loc[:, ~cells.columns.duplicated()]
    missing = [name for name in NEEDED if name not in cells]
    if missing:
        raise DataError(
            f"{path}: no column {', '.join(missing)} in the SeaExplorer file"
        )
    form = {"format": "%d/%m/%Y %H:%M:%S", "errors": "coerce", "utc": True}
    when = pandas.to_datetime(cells.iloc[:, 0], **form) - pandas.Timestamp(0, tz="UTC")
    log = cells.reindex(columns=[*NEEDED, *OPTIONAL]).apply(
        pandas.to_numeric, errors="coerce"
    )
    log[OUTSIDE] = 0.0
    for name, limits in ANGLES.items():
        log[name], outside = within(log[name].to_numpy(float), limits)
        log[OUTSIDE] += outside
    log["Depth"], _ = within(log["Depth"].to_numpy(float), (-LEAST_DEPTH, DEEPEST))
    log = log.set_axis(when.dt.total_seconds())[when.notna().to_numpy()]
    if log.empty:
        raise DataError(
            f"{path}: no line has a Timestamp such as 13/06/2019 18:21:39 in the SeaExplorer file"
        )
    return log


def _fixes_and_wet(log: pandas.DataFrame) -> tuple[list[Fix], np.ndarray]:
    """Return the fixes, places that are new at the surface, and times under water."""
    afloat = (log.NavState == AT_SURFACE) & ~(log.DeadReckoning > 0)
    new = (log[["Lat", "Lon"]].ffill().diff() != 0).any(axis=1) & (
        log.index > log.index[0]
    )
    time, *coordinates = logged(log[afloat & new], "Lat", "Lon")
    wet = (log.Depth > LEAST_DEPTH) | (
        log.Depth.isna() & log.NavState.isin(UNDER_WATER)
    )
    return fixes_in(time, *map(degrees, coordinates)), log.index[wet].to_numpy()


def _variation(log: pandas.DataFrame, start: Fix, end: Fix) -> tuple[float, list[str]]:
    """Return the variation of a dive, degrees east, NaN if not known, and a note if not IGRF's."""
    stated = log.Declination[log.Declination != 0].median()
    igrf = variation(0.5 * (start[0] + end[0]), *start[1:])
    is_stated = isfinite(stated)
    if is_stated and not abs(stated - igrf) > ANOTHER:
        return stated, []
    said = f"{stated:.3g}, though it is" if is_stated else "0 or empty:"
    return stated if is_stated else igrf, [
        f"Declination is {said} {igrf:.0f} degrees by IGRF (--variation gives another)"
    ]


def _dive(log: pandas.DataFrame, fixes: Three, number: int, lost: str) -> Dive:
    """Make a dive of its rows; rows that are `lost` leave its displacement unknown."""
    _, start, end = fixes
    steered = log.DesiredH.dropna()
    east_of_north, doubt = _variation(log, start, end)
    time, heading, pitch, depth = logged(log, "Heading", "Pitch", "Depth")
    reckoned = ThroughWater(notes=[lost or "no samples"])
    if time.size > 2 and not lost:
        nose = np.radians(pitch)
        true = np.radians(heading + east_of_north)
        with np.errstate(divide="ignore", invalid="ignore"):
            speed = -np.gradient(depth, time) / np.tan(nose)
        flies = (np.abs(pitch) > LEAST_PITCH) & (speed > 0) & (speed < FASTEST)
        step = np.where(flies, speed, 0.0) * np.diff(time, prepend=time[0])
        steps = step * np.array([np.sin(true), np.cos(true)])
        notes = []
        if wrong_angles := int(log[OUTSIDE].sum()):
            notes.append(
                f"{wrong_angles} numbers of {', '.join(ANGLES)} are no angles: taken as gaps"
            )
        notes += doubt
        afloat = log.Depth.mask(log.NavState == AT_SURFACE, 0.0).dropna()
        depths = afloat.index - start[0], afloat.to_numpy()
        span = end[0] - start[0], log.attrs["surfacing"]
        reckoned = summed(time - start[0], steps, depths, *span, notes)
        reckoned = reckoned._replace(turned=east_of_north)
    return dive_between(
        number,
        fixes,
        reckoned,
        magvar=east_of_north,
        depth_max=deepest(depth),
        next_course=steered.iloc[-1].item() % 360.0 if steered.size else None,
        notes=tuple(reckoned.notes),
    )
