"""Dives as their files arrive, kept on disk.

The state is a folder with a JSON file for each file read (`follow_record`).
Each is written beside its place and renamed there once its file is read, so
that a process killed at any moment has lost nothing but the file it was
reading, which is read again.  Estimators are not stored: fed the same dives
they are the same, bit for bit, and JSON keeps every digit.

A file that is still being copied reads as damaged and is read again once it has
changed; one that cannot be opened is tried at each look.  A file that is gone
keeps its dives, but for those that another file has with the same times and
fixes: it was renamed.
"""

import json
import os
import stat
from pathlib import Path
from typing import Any

from ..errors import DataError
from ..files import make_folder, write_text
from ..gliders.dive_files import SUFFIXES, read_dive_file
from ..gliders.dives import Dive, Skipped
from ..progress.interrupt import check
from .follow_record import dive_of, fixes_of, read_record, record_of


class Follower:
    """Reads what is new in a folder and remembers the rest.

    Attributes
    ----------
    files : dict
        By name, as `follow_record` has them.
    here : set of str
        Names of the files that the last look found.

    Parameters
    ----------
    folder : str or Path
        Where files arrive.
    state : str or Path
        Folder of what was read; made if missing. Names in it that begin with a
        dot are left alone.

    Raises
    ------
    DataError
        If the folder is missing or the state is none of ours.
    """

    def __init__(self, folder: str | Path, state: str | Path) -> None:
        self.folder = Path(folder)
        if not os.path.isdir(folder):  # noqa: PTH112 - never raises
            raise DataError(f"{folder}: no such folder; give the folder where dives arrive")
        self._where = os.path.realpath(folder)
        self.state = make_folder(state)
        self.files: dict[str, dict[str, Any]] = {}
        for path in _inside(self.state, "cannot be read"):
            if not path.name.startswith("."):
                self.files[path.name.removesuffix(".json")] = read_record(path, self._where)
        self.here = set(self.files)

    def look(self) -> list[str]:
        """Read new and changed files, and write the state.

        Returns
        -------
        list of str
            Names of the files that were read.

        Raises
        ------
        DataError
            If the folder cannot be looked into or the state not be written.
        """
        read, here = [], set()
        lost = f"cannot be looked into; what was read is kept in {self.state}"
        for path in _inside(self.folder, lost):
            check()
            if path.suffix.lower() not in SUFFIXES or path.name.startswith("."):
                continue
            record = self._record(path)
            if record is None:
                continue
            here.add(path.name)
            known = self.files.get(path.name)
            if record is not known and json.dumps(record) != json.dumps(known):  # NaN is NaN
                write_text(self.state / f"{path.name}.json", json.dumps(record))
                self.files[path.name] = record
                read.append(path.name)
        self.here = here
        return read

    def _record(self, path: Path) -> dict[str, Any] | None:
        """Return the record of a file as it is now; None if there is none."""
        known = self.files.get(path.name)
        stamp = None
        try:
            status = path.stat()
            if not stat.S_ISREG(status.st_mode):
                return None
            stamp = [status.st_size, status.st_mtime_ns]
            if known is not None and known["stamp"] == stamp:
                return known
            with path.open("rb") as file:
                file.read(1)
            dives, skipped = read_dive_file(path)
        except FileNotFoundError:
            return None
        except OSError as error:
            why = f"{path}: cannot be read: {error.strerror or error}; is tried at each look"
            return record_of(self._where, None, known["dives"] if known else [], _why(why))
        except DataError as error:
            return record_of(self._where, stamp, [], _why(str(error)))
        return record_of(self._where, stamp, dives, skipped)

    def dives(self) -> tuple[list[Dive], list[Skipped]]:
        """Return all dives so far, by file name, and what was left out.

        Returns
        -------
        dives : list of Dive
            With their tracks; `usable` sorts and chooses.
        skipped : list of Skipped
        """
        there = [self.files[name] for name in self.here]
        seen = {fixes_of(kept) for record in there for kept in record["dives"]}
        stamps = [record["stamp"] for record in there if record["stamp"]]
        dives: list[Dive] = []
        skipped: list[Skipped] = []
        for name, record in sorted(self.files.items()):
            kept = record["dives"]
            if name not in self.here:
                kept = [dive for dive in kept if fixes_of(dive) not in seen]
                seen.update(map(fixes_of, kept))
                if record["stamp"] in stamps or (record["dives"] and not kept):
                    continue  # renamed
            dives += map(dive_of, kept)
            skipped += [Skipped(**entry) for entry in record["skipped"]]
        return dives, skipped


def _why(reason: str) -> list[Skipped]:
    return [Skipped(None, reason)]


def _inside(folder: Path, fault: str) -> list[Path]:
    """Return what is in a folder, by name, or say that it cannot be seen."""
    try:
        return sorted(folder.iterdir())
    except OSError as error:
        raise DataError(f"{folder}: {fault}: {error.strerror or error}") from None
