"""Dives as their files arrive, kept on disk.

The state is one JSON file: of each file read its size, time of change, dives and
what was left out.  It is written beside its place and renamed there after every
look at the folder, so that a process killed at any moment leaves the old state
or the new.  Estimators are not stored: fed the same dives they are the same, bit
for bit, and JSON keeps every digit.  A file that is still being copied reads as
damaged and is read again once it has changed; a file that is gone keeps its dives.
"""

import json
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import DataError
from ...files import write_text
from ..gliders.dive_files import SUFFIXES, read_dive_file
from ..gliders.dives import Dive, Skipped

FORMAT = 2  # 1 had no tracks
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
        JSON file of what was read; made if missing.

    Raises
    ------
    DataError
        If the folder is missing or the state is none of ours.
    """

    def __init__(self, folder: str | Path, state: str | Path) -> None:
        self.folder, self.state = Path(folder), Path(state)
        if not self.folder.is_dir():
            raise DataError(f"{folder}: no such folder; give the folder where dives arrive")
        self.files: dict[str, dict[str, Any]] = {}
        if self.state.exists():
            try:
                content = json.loads(self.state.read_text("utf-8"))
                self.files = content["files"]
                form = content["format"]
                if form == FORMAT:
                    self.dives()
            except (OSError, ValueError, KeyError, TypeError, AttributeError):
                raise DataError(
                    f"{state}: is no state of clpt replay --follow; move it away to read all "
                    "files again"
                ) from None
            if form != FORMAT:
                raise DataError(
                    f"{state}: has the format {form} of another version, this one writes "
                    f"{FORMAT}; move it away to read all files again"
                )

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
            self.files[path.name] = {
                "stamp": stamp,
                "dives": [_kept(dive) for dive in dives],
                "skipped": [asdict(s) for s in skipped],
            }
            read.append(path.name)
        if read:
            write_text(self.state, json.dumps({"format": FORMAT, "files": self.files}))
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
