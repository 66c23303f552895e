"""What is kept of a followed file: JSON, to the bit.

A record is a dict: `folder`, where its file arrived; `stamp`, the file's size
and time of change, None where it could not be opened; `dives` and `skipped`.
NaN and Infinity stand in the JSON as Python writes them.
"""

import json
from collections.abc import Sequence
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import DataError
from ..gliders.dives import Dive, Skipped

FORMAT = 2
REQUIRED = (
    "t_gps2",
    "lat_gps2",
    "lon_gps2",
    "t_gpse",
    "lat_gpse",
    "lon_gpse",
    "gps_east",
    "gps_north",
    "dr_east",
    "dr_north",
)
OPTIONAL = tuple(
    f.name for f in fields(Dive) if f.name not in ("number", "track", "notes", *REQUIRED)
)


def record_of(
    folder: str, stamp: list[int] | None, dives: Sequence[Any], skipped: Sequence[Skipped]
) -> dict[str, Any]:
    """Return the record of a file.

    Parameters
    ----------
    folder : str
        Where it arrived.
    stamp : list of int or None
        Its size and time of change, ns; None if it is to be read again.
    dives : sequence of Dive
        Or as a record has them.
    skipped : sequence of Skipped
        What its reader left out.

    Returns
    -------
    dict
        Of what JSON knows alone.
    """
    record = {
        "format": FORMAT,
        "folder": folder,
        "stamp": stamp,
        "dives": [_kept(dive) if isinstance(dive, Dive) else dive for dive in dives],
        "skipped": [asdict(entry) for entry in skipped],
    }
    return json.loads(json.dumps(record))


def read_record(path: Path, folder: str) -> dict[str, Any]:
    """Read the record of one file and see that it is whole.

    Parameters
    ----------
    path : Path
        Its JSON file.
    folder : str
        Where files arrive.

    Returns
    -------
    dict

    Raises
    ------
    DataError
        If it is no record, or that of a file of another folder.
    """
    try:
        record = json.loads(path.read_text("utf-8"))
        if record["format"] != FORMAT or not isinstance(record["folder"], str):
            raise ValueError
        if record["stamp"] is not None:
            size, changed = record["stamp"]
            _whole(size), _whole(changed)
        for kept in _list(record["dives"]):
            _check(kept)
        for entry in _list(record["skipped"]):
            skipped = Skipped(**entry)
            _text(skipped.why)
            if skipped.dive is not None:
                _whole(skipped.dive)
    except (OSError, ValueError, LookupError, TypeError, ArithmeticError, RecursionError):
        raise DataError(
            f"{path}: is no state of this version's clpt replay --follow; move the folder "
            f"{path.parent} away to read all files again"
        ) from None
    if record["folder"] != folder:
        raise DataError(
            f"{path.parent}: keeps what was read in {record['folder']}, not in {folder}; give "
            f"another --out, or move {path.parent} away"
        )
    return record


def dive_of(kept: dict[str, Any]) -> Dive:
    """Return back a dive that a record keeps, to the bit."""
    track = kept["track"]
    if track is not None:
        time, east, north = (np.array(a, float) for a in track)
        track = (time, east, north)
    return Dive(**{**kept, "notes": tuple(kept["notes"]), "track": track})


def fixes_of(kept: dict[str, Any]) -> tuple[str, ...]:
    """Return times and fixes of a kept dive, to compare; NaN is NaN."""
    return tuple(repr(float(kept[name])) for name in REQUIRED[:6])


def _kept(dive: Dive) -> dict[str, Any]:
    """Return a dive as JSON keeps it; a track is three lists."""
    track = None if dive.track is None else [np.asarray(a).tolist() for a in dive.track]
    kept = {name: getattr(dive, name) for name in ("number", *REQUIRED, *OPTIONAL)}
    return {**kept, "notes": list(dive.notes), "track": track}


def _check(kept: Any) -> None:
    """Raise if this is no dive as `_kept` gives it."""
    if set(kept) != {"number", *REQUIRED, *OPTIONAL, "notes", "track"}:
        raise ValueError
    if abs(_whole(kept["number"])) >= 2**63:
        raise ValueError
    for name in (*REQUIRED, *OPTIONAL):
        if name in REQUIRED or kept[name] is not None:
            _number(kept[name])
    for note in _list(kept["notes"]):
        _text(note)
    if kept["track"] is not None:
        time, east, north = _list(kept["track"])
        if not len(_list(time)) == len(_list(east)) == len(_list(north)) > 0:
            raise ValueError
        for value in (*time, *east, *north):
            _number(value)


def _number(value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise TypeError
    return float(value)


def _whole(value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, int):
        raise TypeError
    return value


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError
    return value


def _list(value: Any) -> list[Any]:
    if not isinstance(value, list):
        raise TypeError
    return value
