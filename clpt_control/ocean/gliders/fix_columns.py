"""Columns of a log that mark which positions are fixes.

| column | a fix | no fix |
|---|---|---|
| `fix`, `gps_fix`, `is_fix`, `gps_valid` | 1, true, yes, A | 0, false, no, V, empty |
| `dead_reckoning`, `interpolated`, `estimated` | 0, false, no | 1, true, yes |
| `fix_type`, `gps_mode`, `position_source` | 2 or more, 3D, RTK, GPS | 0, 1, none, INS, DR |
| `fix_quality`, `gps_quality` (NMEA GGA) | 1 to 5, 9 | 0, 6 estimated, 7 manual, 8 simulator |
| `status`, `gps_status` (NMEA RMC) | A, D, P, R, F, OK, fix | V, E, M, N, S, dead reckoning |
| `status.status` (ROS) | 0 or more | -1 |
| `position_qc`, `lat_quality_control`, `qc_lon` | 0 to 2, 5 to 7, good | 3, 4, 8, 9, bad, suspect |
| `sats`, `num_satellites` | 3 or more | 0 to 2 |
| `hdop`, `pdop` | below 20 | 0, 20 or more |

Empty cells of other columns than the first row's say nothing.  A column with another value is not
read, and a note tells so.
"""

import re
from math import isfinite
from pathlib import Path
from typing import NamedTuple

from pandas import DataFrame, Series

from ...base.errors import DataError
from ...base.units import number
from ...paper.currents.flags import RIGHT, WRONG
from .dive_fields import NO_VALUE


class Marks(NamedTuple):
    """Row of the table: pattern of names, and of values with and without a fix."""

    names: str
    fix: str
    none: str


GPS = "(gps|gnss|nav|rmc|fix|position|pos|location)_?"
PLACE = "(lat(itude)?|lon(g|gitude)?|position|pos|location|gps|gnss|fix|time)"
# words of any of these columns
MEASURED = f"(probably.?)?({RIGHT})|fix|g(ps|nss).*"
COMPUTED = (
    "dr|dead.?reckon.*|estimated|interpolated|ins|imu|none|no.?(fix|gps)|void|"
    rf"(?!no|never).*({WRONG}).*"
)
QC = "(qc|quality_?control|quality(_?flag)?|flags?|qartod)"
MARKS = (
    Marks(
        f"(is_?|has_?|valid_?)?fix|({GPS})?(fix|valid|ok)|is_?(gps|measured)",
        f"1|true|t|yes|y|a|{MEASURED}",
        f"|0|false|f|no|n|v|{COMPUTED}",
    ),
    Marks(
        r"(is_?)?(dead_?reckon(ing|ed)|dr_?flag|dr|interpolated|estimated|reckoned)(_flag)?",
        "0|false|f|no|n",
        "1|true|t|yes|y",
    ),
    Marks(
        f"({GPS})?fix(_?(type|mode))?|{GPS}(type|mode|source)",
        f"[2-8]|2d|3d|dgps.*|rtk.*|ppp|static|{MEASURED}",
        f"[01]|{COMPUTED}",
    ),
    Marks(f"{GPS}(quality|qual|indicator)|gga_?quality", "[1-59]", "[0678]"),
    Marks(
        f"({GPS})?status|{GPS}mode|mode_indicator",
        f"[adprf]|active|{MEASURED}",
        f"[vemns]|{COMPUTED}",
    ),
    Marks(r"status\.status", "[0-2]", "-1"),
    Marks(
        f"{PLACE}_?{QC}|{QC}_{PLACE}|qartod_{PLACE}.*|{PLACE}_qartod.*",
        f"[012567]|{MEASURED}",
        f"[3489]|{COMPUTED}",
    ),
    Marks(
        f"({GPS})?(n|num|n(umber|o)_?of)?_?(sats?|satellites|sv)(_?(used|in_use|visible))?|numsv",
        r"[3-9]|\d\d+",
        "[0-2]",
    ),
    Marks(
        f"({GPS})?[hp]dop", r"(?!0$)1?\d(\.\d+)?", r"0|[2-9]\d(\.\d+)?|\d{3,}(\.\d+)?"
    ),
)


def _plain(text: str) -> str:
    """Return a number in one spelling, "" for no value, another text as it is."""
    value = number(text)
    return f"{value:g}" if isfinite(value) else text * (text not in NO_VALUE - {"none"})


def places_without_fix(
    cells: DataFrame, has_place: Series, path: Path
) -> tuple[Series, list[str]]:
    """Return the rows that a column marks as no fix, and notes on the columns."""
    marked = has_place & False
    notes = []
    for column, cell in enumerate(cells.columns):
        name = re.sub(r"[^a-z.]+", "_", cell.lower()).strip("_ ")
        rows = [row for row in MARKS if re.fullmatch(row.names, name)]
        values = cells.iloc[has_place.to_numpy(), column].str.lower().map(_plain)
        unknown = values.iloc[:0]
        for row in rows:
            unknown = values[
                (values != "") & ~values.str.fullmatch(f"{row.fix}|{row.none}")
            ]
            if unknown.empty:
                none = values[values.str.fullmatch(row.none)].index
                if len(none) == len(values):
                    raise DataError(
                        f"{path}: {cell} marks no position as a fix. Correct it, or leave it out"
                    )
                marked[none] = True
                if len(none):
                    listing = ", ".join(sorted({*values[none]})[:3])
                    notes.append(
                        f"positions of {len(none)} rows are no fixes by {cell} "
                        f"({listing or 'empty'}) and are left out"
                    )
                break
        else:
            if rows:
                notes.append(
                    f"column {cell} is not read: {unknown.iloc[0]!r} is not known. Give 1 for a "
                    "fix and 0 for none in a column named fix"
                )
    return marked, notes
