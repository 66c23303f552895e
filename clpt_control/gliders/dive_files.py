"""Files of dives, told apart by what is in them.

Each path is a file or a folder of files; a file is of one of the dialects
below, found by its content.  A damaged file among good ones is left out with its
reason and the good dives are used; what was named and does not exist is an error.

A dialect is a module with two functions: `is_known(content)`, and
`dives_of(content, path)`, which returns its dives and what was skipped.  The content is
an open xarray.Dataset or a text.  A further format is a module and its row here.
"""

from collections.abc import Iterable
from pathlib import Path
from stat import S_ISDIR

from ..arguments import public
from ..errors import DataError
from ..files import open_netcdf
from ..files.reading import NETCDF, read_bytes, text_of
from ..progress.interrupt import check
from . import dive_table, og1, seaexplorer, seaglider, slocum
from .dives import SLOCUM_FILES, Dive, Skipped, is_segment, name_in, name_of_file, named

MOST_BYTES = 4 * 10**9  # of memory that the dives of a file may take
OF_NETCDF = (seaglider, og1)
OF_TEXT = (seaexplorer, dive_table)  # which takes any text, so it is the last
VEHICLES = {seaglider: "Seaglider", slocum: "Slocum", seaexplorer: "SeaExplorer"}  # known by these
KINDS = (
    "Seaglider or OG1 NetCDF files, .sbd, .mbd or .dbd of a Slocum, .gli of a SeaExplorer, "
    "a CSV table of dives"
)
SUFFIXES = (".nc", ".csv", *SLOCUM_FILES)
FROM_GLIDER = "from-glider"  # where a dockserver keeps what a glider sent


def may_hold_dives(path: Path) -> bool:
    """Whether a name in a folder is that of a file of dives; hidden ones are not."""
    named = path.suffix.lower() in SUFFIXES or is_segment(path)
    return named and not path.name.startswith(".")


def dive_paths(paths: Iterable[str | Path]) -> list[Path]:
    """Return the files that paths name; those of a folder by name, hidden ones left out.

    Of a glider's folder on a dockserver they are those in ``from-glider``.
    """
    files: list[Path] = []
    for path in map(Path, paths):
        try:
            inside = list(path.iterdir()) if S_ISDIR(path.stat().st_mode) else None
        except (FileNotFoundError, NotADirectoryError):
            raise DataError(f"{path}: no such file; give {KINDS}, or a folder of them") from None
        except OSError as error:
            raise DataError(f"{path}: cannot be read: {error.strerror}") from None
        if inside is None:
            files.append(path)
            continue
        dives = [file for file in inside if may_hold_dives(file)]
        if not dives and (sent := [file for file in inside if file.name.lower() == FROM_GLIDER]):
            dives = dive_paths(sent)
        if not dives:
            raise DataError(f"{path}: the folder has no {', '.join(SUFFIXES)} or .gli file")
        files += sorted(dives)
    return files


def read_dive_file(path: str | Path) -> tuple[list[Dive], list[Skipped]]:
    """Read a file of any dialect: its dives, and lines of a text that hold none.

    A text may be a pipe that is open.
    """
    path = Path(path)
    raw = read_bytes(path, (*NETCDF, slocum.MAGIC))
    if not raw:
        raise DataError(f"{path}: is empty; must be one of {KINDS}")
    if raw == slocum.MAGIC or slocum.MAGIC in raw[3:9]:  # the first letters of a compressed block
        dives, skipped = slocum.dives_of(path)
        return named(dives, name_of_file(path.name), VEHICLES[slocum]), skipped
    if raw not in NETCDF:
        if raw.startswith(seaexplorer.GZIP):
            text, known = seaexplorer.unzipped(raw, path), seaexplorer
        else:
            text = text_of(raw, path, f"is neither NetCDF nor text; must be one of {KINDS}")
            known = next(one for one in OF_TEXT if one.is_known(text))
        dives, skipped = known.dives_of(text, path)
        return named(dives, name_of_file(path.name), VEHICLES.get(known)), skipped
    with open_netcdf(path, MOST_BYTES) as data:
        for dialect in OF_NETCDF:
            if dialect.is_known(data):
                dives, skipped = dialect.dives_of(data, path)
                return named(dives, name_in(data), VEHICLES.get(dialect)), skipped
        names = ", ".join(map(str, list(data.variables)[:8])) or "no variables"
    raise DataError(
        f"{path}: neither a Seaglider file (with log_gps_time) nor OG1 (with LATITUDE_GPS): it has "
        f"{names}, not the fixes and the displacement through the water that a dive needs; a CSV "
        "table of dives can give both"
    )


def alike(faults: Iterable[tuple[Path, Skipped]]) -> list[Skipped]:
    """Return what was skipped of files; reasons that are the same but for the file once.

    >>> faults = [(Path(name), Skipped(None, f"{name}: is empty")) for name in "ab"]
    >>> alike(faults)
    [Skipped(dive=None, why='a: is empty (one of 2 files)')]
    """
    same: dict[tuple[int | None, str], list[str]] = {}
    for file, one in faults:
        same.setdefault((one.dive, one.why.removeprefix(str(file))), []).append(one.why)
    return [
        Skipped(dive, whys[0] + (f" (one of {len(whys)} files)" if len(whys) > 1 else ""))
        for (dive, _), whys in same.items()
    ]


@public
def read_dives(paths: str | Path | Iterable[str | Path]) -> tuple[list[Dive], list[Skipped]]:
    """Read all dives of files and folders.

    Parameters
    ----------
    paths : str, Path or iterable of them
        Files and folders, of any kinds together.

    Returns
    -------
    dives : list of Dive
        As the files have them; `usable` sorts and chooses.
    skipped : list of Skipped
        Damaged files and lines, each with its reason.

    Raises
    ------
    DataError
        If a path does not exist, or no file holds a dive.

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
    files = dive_paths([paths] if isinstance(paths, str | Path) else paths)
    dives: list[Dive] = []
    skipped: list[Skipped] = []
    faults: list[tuple[Path, Skipped]] = []
    for file in files:
        check()
        try:
            found, bad = read_dive_file(file)
        except DataError as error:
            faults.append((file, Skipped(seaglider.number_in_name(file), str(error))))
            continue
        dives += found
        skipped += bad
    skipped += alike(faults)
    if dives:
        return dives, skipped
    if len(skipped) == 1 and not skipped[0].why.endswith(" files)"):
        raise DataError(skipped[0].why)
    if skipped and len(files) == 1:
        raise DataError(f"{files[0]}: no line holds a dive; the first: {skipped[0].why}")
    if skipped:
        raise DataError(f"none of {len(files)} files holds a dive; the first: {skipped[0].why}")
    raise DataError(f"{', '.join(map(str, files)) or 'no file'}: no dives")
