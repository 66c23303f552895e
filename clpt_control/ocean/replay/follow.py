"""Dives as their files arrive, kept on disk.

The state is a folder with a JSON file for each file read: its size and time of
change, its dives and what was left out.  Each is written beside its place and
renamed there once its file is read, so that a process killed at any moment has
lost nothing but the file it was reading, which is read again.  Estimators are
not stored: fed the same dives they are the same, bit for bit, and JSON keeps
every digit.  A file that is still being copied reads as damaged and is read
again once it has changed; a file that is gone keeps its dives.
"""

import json
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import DataError
from ...files import make_folder, write_text
from ..gliders.dive_files import SUFFIXES, read_dive_file
from ..gliders.dives import Dive, Skipped

FORMAT = 1
KEPT = [f.name for f in fields(Dive) if f.name not in ("track", "notes")]


class Follower:
    """Reads what is new in a folder and remembers the rest.

    Attributes
    ----------
    files : dict
        By name: ``stamp`` (size, time of change), ``dives``, ``skipped``.

    Parameters
    ----------
    folder : str or Path
        Where files arrive.
    state : str or Path
        Folder of what was read; made if missing.

    Raises
    ------
    DataError
        If the folder is missing or the state is none of ours.
    """

    def __init__(self, folder: str | Path, state: str | Path) -> None:
        self.folder = Path(folder)
        if not self.folder.is_dir():
            raise DataError(f"{folder}: no such folder; give the folder where dives arrive")
        self.state = make_folder(state)
        for left in self.state.glob(".*"):
            left.unlink()  # of a process that was killed while it wrote
        self.files: dict[str, dict[str, Any]] = {}
        for path in sorted(self.state.iterdir()):
            self.files[path.name.removesuffix(".json")] = _record(path)

    def look(self) -> list[str]:
        """Read new and changed files, and write the state.

        Returns
        -------
        list of str
            Names of the files that were read.

        Raises
        ------
        DataError
            If the state cannot be written.
        """
        read = []
        for path in sorted(self.folder.iterdir()):
            if path.suffix.lower() not in SUFFIXES or path.name.startswith("."):
                continue
            try:
                status = path.stat()
            except FileNotFoundError:
                continue
            stamp = [status.st_size, status.st_mtime_ns]
            if self.files.get(path.name, {}).get("stamp") == stamp or not path.is_file():
                continue
            try:
                dives, skipped = read_dive_file(path)
            except DataError as error:
                dives, skipped = [], [Skipped(None, str(error))]
            record = {
                "format": FORMAT,
                "stamp": stamp,
                "dives": [_kept(dive) for dive in dives],
                "skipped": [asdict(s) for s in skipped],
            }
            write_text(self.state / f"{path.name}.json", json.dumps(record))
            self.files[path.name] = record
            read.append(path.name)
        return read

    def dives(self) -> tuple[list[Dive], list[Skipped]]:
        """Give all dives so far, by file name, and what was left out.

        Returns
        -------
        dives : list of Dive
            With their tracks; `usable` sorts and chooses.
        skipped : list of Skipped
        """
        dives: list[Dive] = []
        skipped: list[Skipped] = []
        for name in sorted(self.files):
            dives += map(_dive, self.files[name]["dives"])
            skipped += [Skipped(**entry) for entry in self.files[name]["skipped"]]
        return dives, skipped


def _record(path: Path) -> dict[str, Any]:
    """Read the record of one file and see that it is whole."""
    try:
        record = json.loads(path.read_text("utf-8"))
        if record["format"] != FORMAT or len(record["stamp"]) != 2:
            raise ValueError
        for kept in record["dives"]:
            _dive(kept)
        for entry in record["skipped"]:
            Skipped(**entry)
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        raise DataError(
            f"{path}: is no state of this version's clpt replay --follow; move the folder "
            f"{path.parent} away to read all files again"
        ) from None
    return record


def _kept(dive: Dive) -> dict[str, Any]:
    """Give a dive as JSON keeps it; a track is three lists."""
    track = None if dive.track is None else [np.asarray(a).tolist() for a in dive.track]
    kept = {name: getattr(dive, name) for name in KEPT}
    return {**kept, "notes": list(dive.notes), "track": track}


def _dive(kept: dict[str, Any]) -> Dive:
    """Give back the dive, to the bit."""
    track = kept["track"]
    if track is not None:
        time, east, north = (np.array(a, float) for a in track)
        track = (time, east, north)
    return Dive(**{**kept, "notes": tuple(kept["notes"]), "track": track})
