"""The dives of a file (`estimation.dive`), and lines and files that hold none.

The depth-averaged current c that a file reports should be

    c = miss / duration,

an independent check that fixes and dead reckoning were read as they were meant.
Seaglider basestations to version 2 compute it with 1852 m to a minute of latitude
and the time of flight, which differs from ours by up to 0.5 % of the displacement
between the fixes and by the minutes at the surface: some 2 mm/s, five at most in
sound dives that were tried.  More says that the samples in the file are not all
that its current was made of.

A dive lies between two fixes, far enough apart in time, with a time under water between them.

It may begin in one file and end in a later one.  Such a file is a segment of a Slocum's
mission, rosie_713-2019-166-0-156.sbd or 00970156.sbd, or of a SeaExplorer's navigation,
sea035.10.gli.sub.3 or .gz.  It gives the dives that end in it; the files before it, of the
same vehicle in the same folder, are merged with it.
"""

import re
from bisect import bisect_left
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import groupby, pairwise
from math import atan2, degrees, hypot, inf
from operator import itemgetter
from pathlib import Path
from typing import Any

import numpy as np
import pandas

from ...base.arguments import public
from ...base.errors import DataError
from ...base.geodesy import displacement, is_place
from ...base.units import finite_or_none
from ...paper.currents.flags import number
from ..estimation.dive import Dive as Dive
from ..estimation.dive import Fix as Fix
from ..estimation.dive import ThroughWater, dac_difference
from ..estimation.dive import make_dive as make_dive

MENTIONED = 0.01  # m/s
LEAST_DEPTH = 5.0  # m that a dive reaches
# of a dive: first of the stay before it, before, after it
Three = tuple[Fix | None, Fix, Fix]
NUMBERS = 2**31  # dive numbers are smaller, as files keep them in 32 bits
LEAST_GAP = 300.0  # s between two fixes with a dive between them
LONGEST_NAME = 40  # letters; a longer one is no name
BACK = 6  # files before one that are merged with it at most
SLOCUM_FILES = (
    ".sbd",
    ".mbd",
    ".dbd",
    ".scd",
    ".mcd",
    ".dcd",
    ".sba",
    ".mba",
    ".dba",
    ".asc",
)
SLOCUM = re.compile(
    r"(?P<who>.*?)-?(?P<order>\d+-\d+-\d+-\d+|\d{8})(?P<kind>\.\w+)", re.I
)
SEAEXPLORER = re.compile(
    r"(?P<who>.*)(?P<kind>\.gli\.(?:sub|raw))\.(?P<order>\d+)(?:\.gz)?", re.I
)


@public
@dataclass(frozen=True)
class Skipped:
    """A dive that is not used, or a file or line that holds none: its number, if known, and why."""

    dive: int | None
    why: str


class NotYet(DataError):
    """A file that can be read once something beside it is there; it is tried at each look."""


def whole_number(value: float | str | None) -> int | None:
    """Return the number of a dive, below `NUMBERS` in size, or None where it is none.

    >>> whole_number("7"), whole_number(7.5), whole_number("1e10"), whole_number("x")
    (7, None, None, None)
    """
    value_of_text = number(value)
    return (
        int(value_of_text)
        if value_of_text.is_integer() and abs(value_of_text) < NUMBERS
        else None
    )


def is_fix(lat: Any, lon: Any) -> Any:
    """Return whether degrees can be a fix; receivers without one give 0 N 0 E."""
    return is_place(lat, lon) & ((lat != 0.0) | (lon != 0.0))


def cut_dives(
    fixes: Sequence[Fix], wet: np.ndarray | None, least_gap: float
) -> list[Three]:
    """Return the fixes of each dive: more than a gap (s) apart, with a time under water between.

    Fixes and times under water, `wet`, are in order; with None for these any gap is a dive.
    After a dive, a fix with exactly the place of the one before it is that one repeated: it is
    left out, and the dive goes on to the first new place.

    >>> up = [(0.0, 43.0, 8.0), (60.0, 43.0, 8.0), (7200.0, 43.0, 8.1), (9000.0, 43.0, 8.1)]
    >>> cut_dives(up, np.array([600.0]), 300.0) == [tuple(up[:3])]
    True
    """

    def is_dive(start: Fix, end: Fix) -> bool:
        under = (
            1
            if wet is None
            else np.ptp(np.searchsorted(wet, (start[0], end[0]), "right"))
        )
        return end[0] - start[0] > least_gap and bool(under > 0)

    new = [*fixes[:1]]
    for fix in fixes[1:]:
        repeats = fix[1:] == new[-1][1:] and is_dive(new[-1], fix)
        if not repeats:
            new.append(fix)
    dives: list[Three] = []
    surfaced = 0  # first fix since the dive before
    for k, (start, end) in enumerate(pairwise(new)):
        if is_dive(start, end):
            dives.append((new[surfaced] if k > surfaced else None, start, end))
            surfaced = k + 1
    return dives


def planned_course(
    fix: Fix, target: Sequence[float], reached: float = 0.0
) -> float | None:
    """Return the course of the next dive towards a target, degrees.

    None where it is not known, or the fix after the dive is within `reached`, m, of the target.

    >>> fix = (0.0, -43.0, 8.0)
    >>> planned_course(fix, (-42.0, 8.0)), planned_course(fix, (-43.001, 8.0), 1000.0)
    (0.0, None)
    """
    if not (is_place(*target) and is_fix(*fix[1:])):
        return None
    east, north = displacement(*fix[1:], *target)
    return (
        None if hypot(east, north) <= reached else degrees(atan2(east, north)) % 360.0
    )


def fixes_in(time: np.ndarray, lat: np.ndarray, lon: np.ndarray) -> list[Fix]:
    """Return the fixes of columns, of rows that can be one."""
    good = is_fix(lat, lon)
    return list(
        zip(*(column[good].tolist() for column in (time, lat, lon)), strict=True)
    )


def dive_between(
    number: int, fixes: Three, through: ThroughWater, **optional: Any
) -> Dive:
    """Make a dive, NaN as None; note where miss / duration is 10 mm/s off the file's own current.

    >>> fixes = None, (1e9, -43.0, 8.0), (1e9 + 9000, -43.0, 8.0)
    >>> through = ThroughWater((0.0, 450.0))
    >>> dive_between(1, fixes, through, dac_east=0.0, dac_north=-0.05).notes
    ()
    >>> dive_between(1, fixes, through, dac_east=0.03, dac_north=-0.05).notes
    ("position error over duration differs by 30 mm/s from the file's depth-averaged current",)
    """
    gps1: dict[str, Any] = dict(
        zip(("t_gps1", "lat_gps1", "lon_gps1"), fixes[0] or (None,) * 3, strict=True)
    )
    fields = {"track": through.track, "turned": through.turned, **gps1}
    for key, value in optional.items():
        fields[key] = (
            finite_or_none(float(value)) if isinstance(value, float) else value
        )
    return with_dac_note(make_dive(number, fixes[1], fixes[2], through.total, **fields))


def with_dac_note(dive: Dive) -> Dive:
    """Return a dive with a note if miss / duration is 10 mm/s off the file's own current."""
    difference = dac_difference(dive)
    if not MENTIONED < difference < inf:
        return dive
    note = (
        f"position error over duration differs by {1e3 * difference:.0f} mm/s from the file's "
        "depth-averaged current"
    )
    return noted(dive, note)


def noted(dive: Dive, note: str) -> Dive:
    """Return a dive with a note, which stands there once."""
    return dive if note in dive.notes else replace(dive, notes=(*dive.notes, note))


def name_of(*values: Any) -> str | None:
    """Return the first value that is a vehicle's name, None if none is.

    A name begins with a letter, a digit or an underscore, so that no file can pass an option, a
    path or a redirection to the command of an alert.

    >>> name_of("-oProxyCommand=x", "SG171")
    'SG171'
    """
    for value in values:
        name = value.strip() if isinstance(value, str) else ""
        begins_well = name[:1].isalnum() or name[:1] == "_"
        if begins_well and len(name) <= LONGEST_NAME and name.isprintable():
            return name
    return None


def is_segment(path: Path) -> bool:
    """Return whether a name is that of a segment.

    >>> [is_segment(Path(name)) for name in ("00970156.SBD", "sea035.10.gli.sub.3.gz", "p1.nc")]
    [True, True, False]
    """
    return path.suffix.lower() in SLOCUM_FILES or bool(SEAEXPLORER.fullmatch(path.name))


def in_order(path: Path) -> tuple[list[str | int], str]:
    """Return the key that sorts files as a vehicle numbers them.

    >>> sorted(map(Path, ("sea035.1.gli.sub.10", "sea035.1.gli.sub.9")), key=in_order)[0].name
    'sea035.1.gli.sub.9'
    """
    pieces = re.split(r"(\d+)", path.name)
    return [int(piece) if k % 2 else piece for k, piece in enumerate(pieces)], path.name


def files_before(path: Path) -> list[Path]:
    """Return the files before one of the same vehicle in its folder, the nearest last."""
    try:
        inside = [file for file in path.parent.iterdir() if file.name[:1] != "."]
    except OSError:
        return []
    return before_each(dict.fromkeys([*inside, path]))[path]


def before_each(files: Iterable[Path]) -> dict[Path, list[Path]]:
    """Return for each file of a folder those before it of the same vehicle, the nearest last."""
    earlier = {}
    ordered = sorted((*_order(file), file) for file in files)
    for _, group in groupby(ordered, itemgetter(0)):
        numbered = list(group)
        for _, order, file in numbered:
            k = bisect_left(numbered, order, key=itemgetter(1))
            earlier[file] = [
                earlier_file for *_, earlier_file in numbered[max(k - BACK, 0) : k]
            ]
    return earlier


def dives_across_files(
    path: Path,
    last: pandas.DataFrame,
    read: Callable[[Path], pandas.DataFrame],
    fixes_and_wet: Callable[[pandas.DataFrame], tuple[list[Fix], np.ndarray]],
) -> tuple[pandas.DataFrame, list[Three]]:
    """Return a file's log, `last`, merged with those of files before it, and all dives' fixes.

    A log is a table by time, s since 1970.  It goes back until a fix stands before the first time
    under water; `fixes_and_wet` returns the fixes and the times under water.
    """
    logs = [last]
    for before in reversed(files_before(path)):
        fixes, wet = fixes_and_wet(_merged(logs))
        if fixes and (wet.size == 0 or fixes[0][0] <= wet[0]):
            break
        with suppress(DataError):  # named where it is read for itself
            logs.insert(0, read(before))
    merged = _merged(logs)
    return merged, cut_dives(*fixes_and_wet(merged), LEAST_GAP)


def _merged(logs: list[pandas.DataFrame]) -> pandas.DataFrame:
    """Return logs as one, by time; at each time the first number of each column, NaN if none."""
    merged = pandas.concat(logs)
    return merged.where(np.isfinite(merged)).groupby(level=0).first()


def logged(log: pandas.DataFrame, *names: str) -> np.ndarray:
    """Return the times at which some columns of a log all have a number, and these numbers."""
    return log[[*names]].dropna().reset_index().to_numpy().T


def _order(path: Path) -> tuple[str, list[int]]:
    """Return the vehicle and kind of a file, and its place among theirs."""
    matched = SLOCUM.fullmatch(path.name) or SEAEXPLORER.fullmatch(path.name)
    if not matched:
        return path.name, []
    vehicle = f"{matched['who']}{matched['kind']}".lower()
    return vehicle, [int(number) for number in re.findall(r"\d+", matched["order"])]
