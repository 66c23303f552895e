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

import os
import stat
from collections.abc import Iterable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal, get_type_hints

import numpy as np
import pydantic

from ..errors import DataError, needed
from ..files import check_name, make_folder, write_file
from ..files.reading import at_once, read_bytes
from ..gliders.dive_files import alike, may_hold_dives, read_dive_file
from ..gliders.dives import Dive, NotYet, Skipped, before_each, in_order, is_segment
from ..progress.interrupt import check

LOCK = ".clpt-lock"
STRICT = pydantic.ConfigDict(strict=True, extra="forbid", ser_json_inf_nan="constants")
FIXES = ("t_gps2", "lat_gps2", "lon_gps2", "t_gpse", "lat_gpse", "lon_gpse")
Column = Annotated[list[float], pydantic.Field(min_length=1)]
Track = Annotated[
    tuple[Column, Column, Column],
    pydantic.AfterValidator(lambda columns: tuple(np.array(columns))),  # equally long, or none
    pydantic.PlainSerializer(lambda track: [column.tolist() for column in track]),
]
TYPES: dict[str, Any] = get_type_hints(Dive) | {
    "number": Annotated[int, pydantic.Field(gt=-(2**63), lt=2**63)],  # as NetCDF can hold it
    "track": Track | None,
}
REQUIRED: dict[str, Any] = {name: (kind, ...) for name, kind in TYPES.items()}
StoredDive: Any = pydantic.create_model("StoredDive", __config__=STRICT, **REQUIRED)


class StoredFile(pydantic.BaseModel):
    """What was read of one file: its folder, dives, and lines without a dive.

    Its stamp is its size and times of change, ns; None where it could not be opened.
    """

    model_config = STRICT
    format: Literal[5]
    folder: str
    stamp: tuple[int, int, int] | None
    dives: list[StoredDive]
    skipped: list[Skipped]

    @cached_property
    def as_dives(self) -> list[Dive]:
        """The dives, made once."""
        return [Dive(**dict(dive)) for dive in self.dives]


class Follower:
    """Reads what is new in a folder; `files` are records, `here` names at the last look."""

    def __init__(self, folder: str | Path, state: str | Path) -> None:
        self.folder, self.state = Path(folder), make_folder(state)
        self._where = os.path.realpath(folder)
        self.files: dict[str, StoredFile] = {}
        for path in _inside(self.state, "cannot be read"):
            if path.suffix == ".json" and not path.name.startswith("."):
                self.files[path.name.removesuffix(".json")] = self._stored(path)
        self.here = set(self.files)
        self.unnamed: list[tuple[Path, Skipped]] = []  # under whose names nothing can be kept

    def _stored(self, path: Path) -> StoredFile:
        """Return a record of the state, or refuse the state."""
        away = f"move the folder {self.state} away to read all files again"
        try:
            record = StoredFile.model_validate_json(read_bytes(path))
        except (DataError, pydantic.ValidationError):
            raise DataError(
                f"{path}: is no state of this version's clpt replay --follow; {away}"
            ) from None
        if record.folder != self._where:
            raise DataError(
                f"{self.state}: keeps what was read in {record.folder}, not in {self._where}; "
                f"give another --out, or {away}"
            )
        return record

    def look(self) -> list[str]:
        """Read new and changed files; return the names of those with new contents."""
        new, here, inside = [], set(), []
        self.unnamed.clear()
        lost = f"cannot be looked into; what was read is kept in {self.state}"
        for path in filter(may_hold_dives, _inside(self.folder, lost)):
            try:
                check_name(self._kept(path.name))
                inside.append(path)
            except DataError as error:
                self.unnamed.append((path, Skipped(None, str(error))))
        before = before_each(inside)
        for path in sorted(before):
            check()
            name = path.name
            known, record = self.files.get(name), self._read(path, before[path])
            if record is None:
                continue
            here.add(name)
            if record is known:
                continue
            text = record.model_dump_json()
            if known is None or text != known.model_dump_json():  # as text, NaN is NaN
                write_file(self._kept(name), text)
                self.files[name] = record
                new.append(name)
        self.here = here
        return new

    def _kept(self, name: str) -> Path:
        """Return where what was read of a file is kept."""
        return self.state / f"{name}.json"

    def _read(self, path: Path, before: list[Path]) -> StoredFile | None:
        """Return the record of a file, behind those before it, as it is now; None if it is none."""
        known = self.files.get(path.name)
        try:
            status = path.stat()
            if not stat.S_ISREG(status.st_mode):
                return None
            stamp = _stamp(status, before if is_segment(path) else [])
            if known is not None and known.stamp is not None and _is_as(known.stamp, stamp):
                return known
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
            return self._record(None, known.dives if known else [], [later])
        except DataError as error:
            dives, skipped = [], [Skipped(None, str(error))]
        return self._record(stamp, map(_stored_dive, dives), skipped)

    def _record(self, stamp: Any, dives: Iterable[Dive], skipped: list[Skipped]) -> StoredFile:
        where = self._where
        return StoredFile(format=5, folder=where, stamp=stamp, dives=list(dives), skipped=skipped)

    def dives(self) -> tuple[list[Dive], list[Skipped]]:
        """Return all dives so far, by the name of their file, and what was left out."""
        seen = {_fixes(dive) for name in self.here for dive in self.files[name].as_dives}
        dives: list[Dive] = []
        skipped = [*self.unnamed]
        for name in sorted(self.files, key=lambda name: in_order(Path(name))):
            record = self.files[name]
            its = record.as_dives
            if name not in self.here:
                its = [dive for dive in its if _fixes(dive) not in seen]
                seen.update(map(_fixes, its))
                if not its:
                    continue  # nothing is lost with it
            dives += its
            skipped += [(self.folder / name, one) for one in record.skipped]
        return dives, alike(skipped)


def _is_as(known: tuple[int, int, int], stamp: tuple[int, int, int]) -> bool:
    """Whether a file is as it was; one that is older now has lost one that was merged with it."""
    return known == stamp or (known[0] == stamp[0] and max(stamp[1:]) < max(known[1:]))


def _stamp(status: os.stat_result, before: list[Path]) -> tuple[int, int, int]:
    """Return a file's size and times, as new as the newest of those that may be merged with it."""
    every = [status]
    for file in before:
        with suppress(OSError):
            every.append(file.stat())
    changed, moved = (max(getattr(one, f"st_{t}time_ns") for one in every) for t in "mc")
    return status.st_size, changed, moved


def _stored_dive(dive: Dive) -> Any:
    """Return a dive as its record stores it."""
    track = dive.track and tuple(np.asarray(column, float).tolist() for column in dive.track)
    return StoredDive(**{**vars(dive), "track": track})


def _fixes(dive: Dive) -> str:
    """Return times and fixes of a dive, to compare; as text, NaN is NaN."""
    return repr([float(getattr(dive, name)) for name in FIXES])


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
        raise DataError(f"{folder}: no such folder; give the folder where dives arrive")
    for place in (out, out / "state"):
        if os.path.exists(place) and os.path.samefile(place, folder):  # noqa: PTH110, PTH121
            raise DataError(
                f"--out {out}: results would lie in the followed folder {folder} and count as new "
                "files there; give another folder, or leave --out out"
            )
    filelock = needed("filelock")
    state = make_folder(out / "state")
    with ExitStack() as locked:
        try:  # the lock of a killed process is free
            locked.enter_context(filelock.FileLock(state / LOCK, timeout=0))
        except filelock.Timeout:
            other = f"{state}: another clpt follows here; end it, or give another --out"
            raise DataError(other) from None
        except OSError as error:
            raise DataError(f"{state}: cannot be written to: {error.strerror or error}") from None
        yield Follower(folder, state)
