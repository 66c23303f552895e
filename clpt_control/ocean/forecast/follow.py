"""Dives as their files arrive in a folder, and dives whose files are gone.

At each look the files are read whose size or times have changed.  What was read
of FILE is stored in a folder, the state, as FILE.json, so that it is known after a
restart, and where FILE is gone or cannot be opened.  JSON keeps every digit, NaN
and Infinity.

A file that is still being copied reads as damaged, and is read again when it has
changed; one that cannot be opened is tried at each look.  Dives of a file that is
gone remain, unless another file has dives with the same times and fixes: then
the file was renamed.
"""

import json
import os
import stat
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...base.arguments import public
from ...base.errors import DataError, import_optional
from ...base.files import check_name, make_folder, write_file
from ...base.files.reading import at_once, read_bytes
from ...base.progress.interrupt import check
from ..gliders.dive_files import (
    grouped_faults,
    may_hold_dives,
    named_by_file,
    read_dive_file,
)
from ..gliders.dive_table import END, START
from ..gliders.dives import Dive, NotYet, Skipped
from ..gliders.mission_files import before_each, in_order, is_segment

LOCK = ".clpt-lock"
FORMAT = 5  # of the state


@public
@dataclass(frozen=True)
class StoredFile:
    """Record of one file that was read: its folder, dives, and lines without a dive.

    Its stamp is its size and times of change, ns; None where it could not be opened.
    """

    folder: str
    stamp: tuple[int, int, int] | None
    dives: list[Dive]
    skipped: list[Skipped]

    def text(self) -> str:
        """Return the record as JSON."""
        return json.dumps({"format": FORMAT, **vars(self)}, default=_plain)


def _plain(value: Any) -> Any:
    """Return a column of a track as a list, a dive or what was skipped as a dict."""
    return value.tolist() if isinstance(value, np.ndarray) else vars(value)


def stored_file(text: bytes) -> StoredFile:
    """Return the record of a JSON text; what is none raises any error."""
    fields = {**json.loads(text)}
    dives, skipped = fields.pop("dives"), fields.pop("skipped")
    if fields.pop("format") != FORMAT:
        raise ValueError("another version's")
    return StoredFile(
        dives=[*map(_dive, dives)], skipped=[Skipped(**s) for s in skipped], **fields
    )


def _dive(fields: dict[str, Any]) -> Dive:
    track = fields["track"] and tuple(np.array(fields["track"]))  # equally long columns
    if track and not track[0].size:
        raise ValueError("a track without times")
    return Dive(**{**fields, "track": track})


class Follower:
    """Reads what is new in a folder; `files` are records, `present` the names at the last look."""

    def __init__(self, folder: str | Path, state: str | Path) -> None:
        self.folder, self.state = Path(folder), make_folder(state)
        self._where = os.path.realpath(folder)
        self.files: dict[str, StoredFile] = {}
        for path in _inside(self.state, "cannot be read"):
            if path.suffix == ".json" and not path.name.startswith("."):
                self.files[path.name.removesuffix(".json")] = self._stored(path)
        self.present = set(self.files)
        self.unnamed: list[
            tuple[Path, Skipped]
        ] = []  # under whose names nothing can be kept

    def _stored(self, path: Path) -> StoredFile:
        """Return a record of the state, or refuse the state."""
        away = f"move the folder {self.state} away to read all files again"
        try:
            record = stored_file(read_bytes(path))
        except (DataError, LookupError, TypeError, ValueError, RecursionError):
            raise DataError(
                f"{path}: is not a state of this version's clpt watch; {away}"
            ) from None
        if record.folder != self._where:
            raise DataError(
                f"{self.state}: has the files read from {record.folder}, not from {self._where}. "
                f"Give another --out, or {away}"
            )
        return record

    def look(self) -> list[str]:
        """Read new and changed files; return the names of those with new contents."""
        new, present, inside = [], set(), []
        self.unnamed.clear()
        lost = f"cannot be looked into; what was read is kept in {self.state}"
        for path in filter(may_hold_dives, _inside(self.folder, lost)):
            try:
                check_name(self._record_path(path.name))
                inside.append(path)
            except DataError as error:
                self.unnamed.append((path, Skipped(None, str(error))))
        before = before_each(inside)
        for path in sorted(before):
            check()
            name = path.name
            stored, record = self.files.get(name), self._read(path, before[path])
            if record is None:
                continue
            present.add(name)
            if record is stored:
                continue
            text = record.text()
            if stored is None or text != stored.text():  # as text, NaN is NaN
                write_file(self._record_path(name), text)
                self.files[name] = record
                new.append(name)
        self.present = present
        return new

    def _record_path(self, name: str) -> Path:
        """Return where what was read of a file is kept."""
        return self.state / f"{name}.json"

    def _read(self, path: Path, before: list[Path]) -> StoredFile | None:
        """Return the record of a file, behind those before it, as it is now; None if it is none."""
        stored = self.files.get(path.name)
        try:
            status = path.stat()
            if not stat.S_ISREG(status.st_mode):
                return None
            stamp = _stamp(status, before if is_segment(path) else [])
            if (
                stored is not None
                and stored.stamp is not None
                and _is_as(stored.stamp, stamp)
            ):
                return stored
            with open(path, "rb", opener=at_once) as file:
                file.read(1)
            dives, skipped = read_dive_file(path)
        except FileNotFoundError:
            return None
        except (OSError, NotYet) as error:
            why = str(error)
            if isinstance(error, OSError):
                why = f"{path}: cannot be read: {error.strerror or error}"
            later = Skipped(None, f"{why}; is tried at each look")
            return StoredFile(
                self._where, None, stored.dives if stored else [], [later]
            )
        except DataError as error:
            dives, skipped = [], [Skipped(None, str(error))]
        return StoredFile(self._where, stamp, dives, skipped)

    def dives(self) -> tuple[list[Dive], list[Skipped]]:
        """Return all dives so far, by the name of their file, and what was left out."""
        present_fixes = {
            _fixes(dive) for name in self.present for dive in self.files[name].dives
        }
        read: list[tuple[Path, list[Dive]]] = []
        skipped = [*self.unnamed]
        for name in sorted(self.files, key=lambda name: in_order(Path(name))):
            record = self.files[name]
            file_dives = record.dives
            if name not in self.present:
                file_dives = [
                    dive for dive in file_dives if _fixes(dive) not in present_fixes
                ]
                present_fixes.update(map(_fixes, file_dives))
                if not file_dives:
                    continue  # nothing is lost with it
            read.append((Path(name), file_dives))
            skipped += [(self.folder / name, skip) for skip in record.skipped]
        return named_by_file(read), grouped_faults(skipped)

    def faults(self, names: list[str]) -> str:
        """Return a sentence on each fault of some files, each with its file's name."""
        skipped = (skip for name in names for skip in self.files[name].skipped)
        return "".join(f"; skipped {skip.why}" for skip in skipped)


def _is_as(stored: tuple[int, int, int], stamp: tuple[int, int, int]) -> bool:
    """Return whether a file is unchanged; one that is older now was merged with fewer files."""
    return stored == stamp or (
        stored[0] == stamp[0] and max(stamp[1:]) < max(stored[1:])
    )


def _stamp(status: os.stat_result, before: list[Path]) -> tuple[int, int, int]:
    """Return a file's size and times, as new as the newest of those that may be merged with it."""
    every = [status]
    for file in before:
        with suppress(OSError):
            every.append(file.stat())
    changed, moved = (
        max(getattr(status_of, f"st_{t}time_ns") for status_of in every) for t in "mc"
    )
    return status.st_size, changed, moved


def _fixes(dive: Dive) -> str:
    """Return times and fixes of a dive, to compare; as text, NaN is NaN."""
    return repr([float(getattr(dive, name)) for name in (*START, *END)])


def _inside(folder: Path, fault: str) -> list[Path]:
    """Return what is in a folder, by name, or raise an error that says the fault."""
    try:
        return sorted(folder.iterdir())
    except OSError as error:
        raise DataError(f"{folder}: {fault}: {error.strerror or error}") from None


@contextmanager
def following(folder: Path, out: Path) -> Iterator[Follower]:
    """Open a follower whose state is out/state; refuse a second process and a wrong folder."""
    if not os.path.isdir(folder):  # noqa: PTH112 - never raises
        raise DataError(
            f"{folder}: folder not found. Give the folder where dives arrive"
        )
    for results_folder in (out, out / "state"):
        if os.path.exists(results_folder) and os.path.samefile(results_folder, folder):  # noqa: PTH110, PTH121
            raise DataError(
                f"--out {out}: results would be in the watched folder {folder} and count as new "
                "files there. Give another folder, or leave --out out"
            )
    filelock = import_optional("filelock")
    state = make_folder(out / "state")
    with ExitStack() as locked:
        try:  # the lock of a killed process is free
            locked.enter_context(filelock.FileLock(state / LOCK, timeout=0))
        except filelock.Timeout:
            refusal = (
                f"{state}: another clpt follows here; end it, or give another --out"
            )
            raise DataError(refusal) from None
        except OSError as error:
            raise DataError(
                f"{state}: cannot be written to: {error.strerror or error}"
            ) from None
        yield Follower(folder, state)
