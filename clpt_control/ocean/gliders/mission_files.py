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
from .dives import LEAST_GAP, Fix, Skipped, Three, cut_dives

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
    lost = [*_missing(files, logs), *_set_back(logs, wet)]
    dives = [
        (
            three,
            next(
                (why for a, b, why in lost if three[1][0] < b and three[2][0] > a), ""
            ),
        )
        for three in cut_dives(fixes, wet)
        if three[2][0] in last.index
    ]
    unknown = []
    if fixes and np.any(wet < fixes[0][0]) and fixes[0][0] in last.index:
        why = f"{path}: no fix before the dive that ends {iso(fixes[0][0])}. Give the files before"
        unknown.append(Skipped(None, why))
    return merged, dives, unknown


def _missing(
    files: list[Path], logs: list[pandas.DataFrame]
) -> Iterator[tuple[float, float, str]]:
    """Yield from when until when files are missing between some, by their numbers, and which."""
    for (file, log), (after, log_after) in pairwise(zip(files, logs, strict=True)):
        (_, order), (_, order_after) = _order(file), _order(after)
        times = log.index.max(), log_after.index.min()
        is_next = order[:-1] == order_after[:-1] and order_after[-1] == order[-1] + 1
        if not is_next and order and times[1] - times[0] > LEAST_GAP:
            why = f"no samples for {times[1] - times[0]:.0f} s: no file between {file.name} and "
            yield *times, f"{why}{after.name}"


def _set_back(
    logs: list[pandas.DataFrame], wet: np.ndarray
) -> Iterator[tuple[float, float, str]]:
    """Yield from when until when rows go back in time under water, and by how much."""
    rows = pandas.concat(logs).reset_index()
    time = rows[~rows.duplicated()].iloc[:, 0].to_numpy()
    steps = np.diff(time)
    # not those beside a single row of another time
    largest = np.maximum(np.append(0.0, steps[:-1]), np.append(steps[1:], 0.0))
    falls = np.flatnonzero((steps < -LEAST_FALL) & (largest < -steps))
    for fall in falls if falls.size <= MOST_FALLS else ():
        earlier, later = time[fall + 1], time[fall]
        if np.any((wet >= earlier) & (wet <= later)):
            why = f"rows go back in time by {later - earlier:.0f} s at {iso(later)}"
            yield (
                earlier,
                later,
                f"{why}: a clock was set back, or rows are out of order",
            )


def _merged(logs: list[pandas.DataFrame]) -> pandas.DataFrame:
    """Return logs as one, by time; at each time the first number of each column, NaN if none."""
    merged = pandas.concat(logs)
    return merged.where(np.isfinite(merged)).groupby(level=0).first()


def logged(log: pandas.DataFrame, *names: str) -> np.ndarray:
    """Return the times at which some columns of a log all have a number, and these numbers."""
    return log[[*names]].dropna().reset_index().to_numpy().T


def own_name(path: Path) -> str:
    """Return the name of a file by which it is ordered: that in a Slocum's header, else its own."""
    if path.suffix.lower() not in SLOCUM_FILES:
        return path.name
    try:
        state = path.stat()
        words = _words_in_header(path, state.st_size, state.st_mtime_ns)
    except OSError:
        return path.name
    return ".".join(words) if len(words) == 2 else path.name


@lru_cache(maxsize=4096)
def _words_in_header(path: Path, _size: int, _changed: int) -> list[str]:
    """Return `filename` and `filename_extension` in the header of a Slocum's file as it is now."""
    with path.open("rb") as file:
        return [word.decode() for word in HEADER.findall(file.read(HEADER_BYTES))]


def _order(path: Path) -> tuple[str, list[int]]:
    """Return the vehicle and kind of a file, and its place among theirs."""
    name = own_name(path)
    matched = SLOCUM.fullmatch(name) or SEAEXPLORER.fullmatch(name)
    if not matched:
        return name, []
    vehicle = f"{matched['who']}{matched['kind']}".lower()
    return vehicle, [int(number) for number in re.findall(r"\d+", matched["order"])]
