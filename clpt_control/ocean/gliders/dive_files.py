"""Files of dives, told apart by what is in them.

Each path is a file or a folder of files; a file is of one of the dialects
below, found by its content.  A damaged file among good ones is left out with its
reason and the good dives are used; what was named and does not exist is an error.

A dialect is a module with two functions: `is_known(content)`, and `dives_of(content)`, which
returns its dives and what holds none, with the path where a dialect
asks its name.  The content is an open xarray.Dataset or a text.  A further format is a module and
its place in `read_dive_file`.  A text that is of no dialect is a plain table of dives
(`dive_table`).
"""

import re
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from importlib import resources
from itertools import pairwise
from math import isfinite
from pathlib import Path
from stat import S_ISDIR
from typing import Any

from ...base.arguments import public
from ...base.errors import DataError, naming
from ...base.files.reading import NETCDF, AnyPath, open_netcdf, read_bytes, read_text
from ...base.progress import note
from ...base.progress.interrupt import check
from . import og1, samples, seaexplorer, seaglider, slocum, usable_dives
from .dive_fields import name_of
from .dive_table import table_dives
from .dives import Dive, DivesAndSkipped, Skipped
from .log_rows import STAYS
from .mission_files import SEAEXPLORER, SLOCUM, SLOCUM_FILES, in_order, own_name
from .text_table import SUFFIXES
from .usable_dives import LEAST_DURATION
from .vehicle_log import NO_MOTION, is_log

MOST_BYTES = 4 * 10**9  # of memory that the dives of a file may take
KINDS = (
    "Seaglider or OG1 NetCDF files, .sbd, .mbd or .dbd of a Slocum, .gli of a SeaExplorer, "
    "a CSV table of dives or of fixes"
)
DATED = re.compile(r"(.+?)_\d{8}")  # SG015_20040929T140907_delayed
RESULTS = "replay.nc"  # of a replay, beside dives where --out says so
SAMPLE = resources.files("clpt_control.data") / "sg542_dives.csv"
FROM_GLIDER = "from-glider"  # where a dockserver keeps what a glider sent


def sample_dives() -> list[Dive]:
    """Return the fourteen dives of Seaglider SG542 in the package.

    Returns
    -------
    list of Dive
        Southern Ocean, 31 January to 3 February 2016; without tracks.

    Examples
    --------
    >>> dives = sample_dives()
    >>> len(dives), dives[0].number, round(dives[0].miss_east)
    (14, 304, 1371)
    """
    return read_all_dives(str(SAMPLE))[0]


def may_hold_dives(path: Path) -> bool:
    """Return whether a name in a folder is that of a file of dives, not hidden and no result.

    >>> names = "00970156.SBD", "sea035.10.gli.sub.3.gz", "p1.nc", "p1.txt"
    >>> [may_hold_dives(Path(name)) for name in names]
    [True, True, True, False]
    """
    endings = ".nc", ".csv", *SLOCUM_FILES
    named = path.suffix.lower() in endings or SEAEXPLORER.fullmatch(path.name)
    return bool(named) and not path.name.startswith(".") and path.name != RESULTS


def dive_paths(paths: Iterable[AnyPath]) -> list[Path]:
    """Return the files that paths name; those of a folder by name, hidden ones left out.

    Of a glider's folder on a dockserver they are those in ``from-glider``.
    """
    files = []
    for path in map(Path, paths):
        try:
            inside = list(path.iterdir()) if S_ISDIR(path.stat().st_mode) else None
        except (FileNotFoundError, NotADirectoryError):
            raise DataError(
                f"{path}: no such file. Give {KINDS}, or a folder of them"
            ) from None
        except OSError as error:
            raise DataError(f"{path}: cannot be read: {error.strerror}") from None
        if inside is None:
            files.append(path)
            continue
        dives = [file for file in inside if may_hold_dives(file)]
        if not dives and (
            sent := [file for file in inside if file.name.lower() == FROM_GLIDER]
        ):
            dives = dive_paths(sent)
        if not dives:
            raise DataError(f"{path}: no dive files in this folder. Give {KINDS}")
        files += sorted(dives, key=in_order)
    return files


def read_dive_file(path: AnyPath, every_row: bool = False) -> DivesAndSkipped:
    """Read a file of any dialect: its dives, and lines of a text that hold none.

    With `every_row` each position of a log is a fix.
    """
    path = Path(path)
    raw = read_bytes(path, (*NETCDF, slocum.MAGIC))
    if not raw:
        raise DataError(f"{path}: is empty. Give one of {KINDS}")
    if raw in NETCDF:
        return _dives_and_skipped(*_of_netcdf(path))
    if raw == slocum.MAGIC or slocum.MAGIC in raw[3:9]:
        # the first letters of a compressed block
        name = name_of_file(own_name(path))
        return _dives_and_skipped(slocum.dives_of(path), name, "Slocum")
    name = name_of_file(path.name)
    no_text = f"is neither NetCDF nor text; must be one of {KINDS}"
    text = seaexplorer.text_in(raw, path, no_text)
    if raw.startswith(seaexplorer.GZIP) or seaexplorer.is_known(text):
        return _dives_and_skipped(seaexplorer.dives_of(text, path), name, "SeaExplorer")
    return _dives_and_skipped(table_dives(text, path, every_row), name, None)


def _dives_and_skipped(
    rows: Sequence[Dive | Skipped],
    name: str | None,
    kind: str | None,
    notes: Sequence[str] = (),
) -> DivesAndSkipped:
    """Return dives with the name of their vehicle, unless they have one, and its kind; the rest.

    Each dive gets the notes.
    """
    dives = [row for row in rows if isinstance(row, Dive)]
    named = [
        replace(
            dive,
            vehicle=dive.vehicle or name,
            kind=dive.kind or kind,
            notes=(*dive.notes, *notes),
        )
        for dive in dives
    ]
    return named, [row for row in rows if isinstance(row, Skipped)]


def _of_netcdf(
    path: Path,
) -> tuple[Sequence[Dive | Skipped], str | None, str | None, list[str]]:
    """Return what a file holds, the vehicle's name and its kind, and notes on each dive."""
    with open_netcdf(path, MOST_BYTES) as data, naming(path):
        for dialect, kind in ((seaglider, "Seaglider"), (og1, None)):
            if dialect.is_known(data):
                # of dimensions of length one, such as `trajectory`
                unflagged, notes = samples.unflagged(data.squeeze())
                return dialect.dives_of(unflagged, path), name_in(data), kind, notes
        names = ", ".join(map(str, list(data.variables)[:8])) or "no variables"
    raise DataError(
        f"{path}: neither a Seaglider file (with log_gps_time) nor OG1 (with LATITUDE_GPS): it has "
        f"{names}, not the fixes and the displacement through the water that a dive "
        "requires. Convert it to a CSV "
        "table of dives with both"
    )


def name_in(data: Any) -> str | None:
    """Return the vehicle's name in an open xarray.Dataset, of its identifiers.

    >>> import xarray
    >>> name_in(xarray.Dataset(attrs={"id": "SG015_20040929T140907_delayed"}))
    'SG015'
    >>> name_in(xarray.Dataset(attrs={"id": "x", "platform_id": " SG171 "}))
    'SG171'
    """
    dated = DATED.match(str(data.attrs.get("id", "")))
    return name_of(data.attrs.get("platform_id"), dated and dated[1])


def name_of_file(file: str) -> str | None:
    """Return the vehicle's name in that of a file of a Slocum or a SeaExplorer.

    >>> name_of_file("rosie_713-2019-166-0-156.sbd"), name_of_file("sea035.10.gli.sub.12.gz")
    ('rosie_713', 'sea035')
    >>> name_of_file("dives.csv") is None
    True
    """
    matched = SLOCUM.fullmatch(file) or SEAEXPLORER.fullmatch(file)
    return name_of(matched and matched["who"].partition(".")[0])


def named_by_file(files: Iterable[tuple[Path, Sequence[Dive]]]) -> list[Dive]:
    """Return the dives of files; dives without a vehicle get the name of their file.

    They stay without one if no dive of a file takes place during another dive of another file, as
    where the files are parts of one record, or copies.
    """
    dives = [(dive, path) for path, file_dives in files for dive in file_dives]
    unnamed = [(dive, path) for dive, path in dives if not dive.vehicle]
    unnamed.sort(key=lambda dive_and_path: dive_and_path[0].t_gps2)
    is_fleet = any(
        path != other_path and usable_dives.is_other_at_once(dive, next_dive)
        for (dive, path), (next_dive, other_path) in pairwise(unnamed)
    )
    return [
        replace(dive, vehicle=name_of(path.stem))
        if is_fleet and not dive.vehicle
        else dive
        for dive, path in dives
    ]


def grouped(faults: Iterable[tuple[Any, Skipped]], name: str) -> list[Skipped]:
    """Return the first of what was skipped for each reason, with the number of all.

    >>> faults = [("is empty", Skipped(None, f"{file}: is empty")) for file in "ab"]
    >>> grouped(faults, "files")
    [Skipped(dive=None, why='a: is empty (one of 2 files)')]
    """
    groups: dict[Any, list[Skipped]] = {}
    for reason, skip in faults:
        groups.setdefault(reason, []).append(skip)
    return [
        replace(first, why=f"{first.why} (one of {1 + len(others)} {name})")
        if others
        else first
        for first, *others in groups.values()
    ]


@public
def read_dives(
    paths: AnyPath | Iterable[AnyPath],
    *,
    usable: bool = True,
    least_duration: float = LEAST_DURATION,
    every_row: bool = False,
) -> DivesAndSkipped:
    """Read the usable dives of one vehicle from files and folders.

    A dive is usable if it has both fixes in their order, finite dead reckoning and a duration
    above `least_duration`, needs no speed above 5 m/s, does not overlap an earlier dive, and
    starts within reach of a fix of the dive before.  A dive more than a day later, or beyond reach
    of any current, begins a new record; the last record is used.

    Parameters
    ----------
    paths : str, Path or iterable of them
        Files and folders, of any kinds together.
    usable : bool, optional
        False returns all dives as the files have them, of any number of vehicles.
    least_duration : float, optional
        Longest duration that is too short, s.
    every_row : bool, optional
        Take each position of a log as a fix, also those that look computed from other rows.

    Returns
    -------
    dives : list of Dive
        In the order of their ends; gaps in the numbers and a changed order are in `notes`.
    skipped : list of Skipped
        Damaged files and lines and unusable dives, each with its reason.

    Raises
    ------
    DataError
        If a path does not exist, no file holds a dive, the dives are of several vehicles, or the
        dates of some are 1024 weeks early.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> from clpt_control.gliders import sample_dives, write_dive_table
    >>> with TemporaryDirectory() as folder:
    ...     write_dive_table(sample_dives(), f"{folder}/sg542.csv")
    ...     dives, skipped = read_dives(folder)
    >>> len(dives), skipped
    (14, [])
    """
    dives, skipped = read_all_dives(paths, every_row)
    if not usable:
        return dives, skipped
    used, unused = usable_dives.usable(dives, least_duration)
    return used, skipped + unused


def read_all_dives(
    paths: AnyPath | Iterable[AnyPath], every_row: bool = False
) -> DivesAndSkipped:
    """Read all dives as the files have them, of any number of vehicles."""
    files = dive_paths([paths] if isinstance(paths, AnyPath) else paths)
    read = []
    skipped = []
    faults = []
    for file in files:
        check()
        try:
            file_dives, file_skipped = read_dive_file(file, every_row)
        except DataError as error:
            fault = Skipped(seaglider.number_in_name(file), str(error))
            faults.append(((fault.dive, fault.why.removeprefix(str(file))), fault))
            continue
        read.append((file, file_dives))
        skipped += file_skipped
    skipped = [*grouped(faults, "files"), *skipped]
    if dives := named_by_file(read):
        return dives, skipped
    if len(skipped) == len(files) == 1:
        raise DataError(skipped[0].why)
    reason = skipped[0].why if skipped else "no dives between two fixes"
    where = files[0] if len(files) == 1 else f"{len(files)} files"
    raise DataError(f"{where}: no dive. First reason: {reason}")


def read_legs(
    path: AnyPath, drifting: bool, every_row: bool = False
) -> DivesAndSkipped:
    """Return the usable legs of a table or of vehicle files, and what was skipped.

    With `drifting` an unknown displacement through the water is 0, with `every_row` each position
    a fix.
    """
    legs, skipped = read_all_dives(path, every_row)
    moves = [isfinite(leg.dr_east) and isfinite(leg.dr_north) for leg in legs]
    if drifting and all(moves):
        note("--drifter: has no effect, each leg has its motion through the water")
    elif drifting:
        legs = [
            leg if is_known else replace(leg, dr_east=0.0, dr_north=0.0, notes=())
            for leg, is_known in zip(legs, moves, strict=True)
        ]
    elif not any(moves) and all(NO_MOTION in leg.notes for leg in legs):
        raise DataError(f"{path}: {NO_MOTION}")
    used, unused = (
        known_legs(legs) if is_log_file(path) else usable_dives.usable(legs, 0.0)
    )
    if not used:
        raise DataError(f"{path}: no usable leg. First reason: {unused[0].why}")
    return used, skipped + unused


def is_log_file(path: AnyPath) -> bool:
    """Return whether a file is the log of a vehicle (`vehicle_log`)."""
    if Path(path).suffix.lower() not in SUFFIXES:
        return False
    with suppress(DataError):
        return is_log(read_text(path, "is no text"))
    return False


def known_legs(legs: Sequence[Dive]) -> DivesAndSkipped:
    """Return legs of a known displacement, and the others with their reasons."""
    used = []
    skipped: list[tuple[Any, Skipped]] = []
    for leg in legs:
        if isfinite(leg.dr_east) and isfinite(leg.dr_north):
            used.append(leg)
        else:
            why = "; ".join(("the way through the water is not known", *leg.notes))
            reason = STAYS if why.endswith(STAYS) else len(skipped)
            skipped.append((reason, Skipped(leg.number, why)))
    return used, grouped(skipped, "legs")
