"""Files of which many make one record: a dive may begin in one and end in a later one.

Such a file is a segment of a Slocum's mission, rosie_713-2019-166-0-156.sbd or 00970156.sbd, or
of a SeaExplorer's navigation, sea035.10.gli.sub.3 or .gz.  It gives the dives that end
in it; the files before it, of the same vehicle in the same folder, are joined to it.
"""

import re
from pathlib import Path

BACK = 6  # files before one that are joined to it at most
SLOCUM = re.compile(r"(?P<who>.*?)-?(?P<order>\d+-\d+-\d+-\d+|\d{8})(?P<kind>\.[smd]bd)", re.I)
SEAEXPLORER = re.compile(r"(?P<who>.*)(?P<kind>\.gli\.(?:sub|raw))\.(?P<order>\d+)(?:\.gz)?", re.I)


def is_segment(path: Path) -> bool:
    """Whether a name is that of a segment.

    >>> [is_segment(Path(name)) for name in ("00970156.SBD", "sea035.10.gli.sub.3.gz", "p1.nc")]
    [True, True, False]
    """
    return path.suffix.lower() in (".sbd", ".mbd", ".dbd") or bool(SEAEXPLORER.fullmatch(path.name))


def files_before(path: Path) -> list[Path]:
    """Return the files before one of the same vehicle in its folder, the nearest last."""
    vehicle, place = _order(path)
    try:
        inside = [(file, _order(file)) for file in path.parent.iterdir() if file.name[:1] != "."]
    except OSError:
        return []
    known = sorted((order[1], file) for file, order in inside if order[0] == vehicle)
    return [file for order, file in known if order < place][-BACK:]


def _order(path: Path) -> tuple[str, list[int]]:
    """Return the vehicle and kind of a file, and its place among theirs."""
    found = SLOCUM.fullmatch(path.name) or SEAEXPLORER.fullmatch(path.name)
    if not found:
        return path.name, []
    whose = f"{found['who']}{found['kind']}".lower()
    return whose, [int(number) for number in re.findall(r"\d+", found["order"])]
