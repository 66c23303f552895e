"""Files of a mission: their order, and dives that begin in one file and end in a later one.

A segment of a Slocum's mission, rosie_713-2019-166-0-156.sbd or 00970156.sbd, or of a SeaExplorer's
navigation, sea035.10.gli.sub.3 or .gz, gives the dives that end in it; the files before it, of the
same vehicle in the same folder, are merged with it.
"""

import re
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import lru_cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pandas

from ...base.errors import DataError
from ...base.units import iso
from .dives import LEAST_GAP, Fix, Skipped, Three, cut_dives, usual_surfacing

Hole = tuple[float, float, str]  # from when until when, and why
BACK = 6  # files before one that are merged with it at most
LEAST_FALL = 60.0  # s: a clock is set back by more, rows of two instruments by less
MOST_FALLS = 5  # ; rows with more of them are not in order of time
HEADER_BYTES = 2048
HEADER = re.compile(rb"^filename(?:_extension)?:[ \t]*([\w-]+)", re.M)
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


def in_order(path: Path) -> tuple[list[str | int], str]:
    """Return the key that sorts files as a vehicle numbers them.

    >>> sorted(map(Path, ("sea035.1.gli.sub.10", "sea035.1.gli.sub.9")), key=in_order)[0].name
    'sea035.1.gli.sub.9'
    """
    segments = re.split(r"(\d+)", path.name)
    return [
        int(segment) if k % 2 else segment for k, segment in enumerate(segments)
    ], path.name


def files_before(path: Path) -> list[Path]:
    """Return the files before one of the same vehicle in its folder, the nearest last."""
    try:
        inside = [file for file in path.parent.iterdir() if file.name[:1] != "."]
    except OSError:
        return []
    vehicle, order = _order(path)
    orders = {file: _order(file) for file in inside}
    before = [
        file
        for file, (vehicle_of_file, k) in orders.items()
        if vehicle_of_file == vehicle and k < order
    ]
    return sorted(before, key=lambda file: (orders[file][1], file))[-BACK:]


def dives_across_files(
    path: Path,
    last: pandas.DataFrame,
    read: Callable[[Path], pandas.DataFrame],
    fixes_and_wet: Callable[[pandas.DataFrame], tuple[list[Fix], np.ndarray]],
) -> tuple[pandas.DataFrame, list[tuple[Three, str]], list[Skipped]]:
    """Return the dives that end in a file, whose log is `last`.

    A log is a table by time, s since 1970.  Those of files before it are merged with it until one
    has a fix; `fixes_and_wet` returns the fixes and the times under water.

    Returns the merged log, the fixes of each dive with the reason why rows of it are lost, and a
    dive without a fix before it.
    """
    files, logs = [path], [last]
    for before in reversed(files_before(path)):
        fixes, _ = fixes_and_wet(_merged(logs))
        if fixes and fixes[0][0] < last.index.min():
            break
        with suppress(DataError):  # named where it is read for itself
            logs.insert(0, read(before))
            files.insert(0, before)
    merged = _merged(logs)
    fixes, wet = fixes_and_wet(merged)
    threes = cut_dives(fixes, wet)
    merged.attrs["surfacing"] = usual_surfacing(threes)
    holes = [*_between(files, logs), *_set_back(logs, wet)]
    dives = [
        (
            three,
            "; ".join(
                why for a, b, why in holes if three[1][0] < b and three[2][0] > a
            ),
        )
        for three in threes
        if three[2][0] in last.index
    ]
    skipped = []
    if fixes and np.any(wet < fixes[0][0]) and fixes[0][0] in last.index:
        why = f"{path}: no fix before the dive that ends {iso(fixes[0][0])}. Give the files before"
        skipped.append(Skipped(None, why))
    return merged, dives, skipped


def _between(files: list[Path], logs: list[pandas.DataFrame]) -> Iterator[Hole]:
    """Yield the times between files of which another is missing, by their numbers."""
    for (file, log), (after, log_after) in pairwise(zip(files, logs, strict=True)):
        start, end = log.index.max(), log_after.index.min()
        *others, last = _order(file)[1]
        if end - start > LEAST_GAP and _order(after)[1] != [*others, last + 1]:
            names = f"no file between {file.name} and {after.name}"
            yield start, end, f"no samples for {end - start:.0f} s: {names}"


def _set_back(logs: list[pandas.DataFrame], wet: np.ndarray) -> Iterator[Hole]:
    """Yield the times under water that rows have twice, because they go back."""
    rows = pandas.concat(logs).reset_index()
    time = rows[~rows.duplicated()].iloc[:, 0].to_numpy()
    steps = np.diff(time, prepend=time[:1], append=time[-1:])
    # not beside a single row of another time
    falls = steps < -np.maximum(
        LEAST_FALL, np.maximum(np.roll(steps, 1), np.roll(steps, -1))
    )
    for k in np.flatnonzero(falls) if falls.sum() <= MOST_FALLS else ():
        if np.any((wet >= time[k]) & (wet <= time[k - 1])):
            when = f"{-steps[k]:.0f} s at {iso(time[k - 1])}"
            why = f"rows go back in time by {when}: a clock was set back, or rows are mixed"
            yield time[k], time[k - 1], why


def _merged(logs: list[pandas.DataFrame]) -> pandas.DataFrame:
    """Return logs as one, by time; at each time the first number of each column, NaN if none."""
    merged = pandas.concat(logs)
    return merged.where(np.isfinite(merged)).groupby(level=0).first()


def logged(log: pandas.DataFrame, *names: str) -> np.ndarray:
    """Return the times at which some columns of a log all have a number, and these numbers."""
    return log[[*names]].dropna().reset_index().to_numpy().T


def own_name(path: Path) -> str:
    """Return the name of a file by which it is ordered: that in a Slocum's header, else its own."""
    if path.suffix.lower() in SLOCUM_FILES:
        with suppress(OSError):
            return _name_in_header(path, path.stat().st_mtime_ns)
    return path.name


@lru_cache(maxsize=4096)
def _name_in_header(path: Path, _changed: int) -> str:
    """Return the name in the header of a Slocum's file, as it is now; else its own."""
    with path.open("rb") as file:
        words = HEADER.findall(file.read(HEADER_BYTES))
    return b".".join(words).decode() if len(words) == 2 else path.name


def _order(path: Path) -> tuple[str, list[int]]:
    """Return the vehicle and kind of a file, and its place among theirs."""
    name = own_name(path)
    matched = SLOCUM.fullmatch(name) or SEAEXPLORER.fullmatch(name)
    if not matched:
        return name, []
    vehicle = f"{matched['who']}{matched['kind']}".lower()
    return vehicle, [int(number) for number in re.findall(r"\d+", matched["order"])]
