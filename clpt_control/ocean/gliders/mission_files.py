"""Files of a mission: their order, and dives that begin in one file and end in a later one.

A segment of a Slocum's mission, rosie_713-2019-166-0-156.sbd or 00970156.sbd, or of a SeaExplorer's
navigation, sea035.10.gli.sub.3 or .gz, gives the dives that end in it; the files before it, of the
same vehicle in the same folder, are merged with it.
"""

import re
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import numpy as np
import pandas

from ...base.errors import DataError
from .dives import Fix, Three, cut_dives

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
    return merged, cut_dives(*fixes_and_wet(merged))


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
