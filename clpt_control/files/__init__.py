"""Files: opened with one clear sentence, written whole or not at all.

What is written goes beside its place first and is renamed there, so that an
interrupt leaves the old file or none.
"""

import os
import re
import shutil
import tempfile
import warnings
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from fnmatch import fnmatch
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import ClptError, DataError
from ..progress.interrupt import check, unfinished

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

LONGEST_NAME, LONGEST_PATH = 200, 3000  # bytes, with room for what is written beside
PART = re.compile(r"\.(.+)\.[a-z0-9_]{8}\.part")  # what `beside` writes to


@contextmanager
def open_netcdf(path: str | Path) -> "Iterator[xarray.Dataset]":
    """Open a NetCDF file with xarray, or say in one sentence why not.

    Parameters
    ----------
    path : str or Path
        The file.

    Yields
    ------
    xarray.Dataset
        Times left as numbers; values are read when used.

    Raises
    ------
    DataError
        If the file is missing, not NetCDF, damaged or cut short, also where
        that is seen first when a variable is read.
    """
    import xarray

    try:
        if not Path(path).exists():
            raise DataError(f"{path}: no such file; must be a NetCDF file")
        if not Path(path).is_file():
            raise DataError(f"{path}: is not a file; must be a NetCDF file")
        _check_classic(Path(path))
        data = xarray.open_dataset(path, decode_times=False, engine="netcdf4")
    except DataError:
        raise
    except (OSError, ValueError, TypeError, RuntimeError) as error:
        raise DataError(f"{path}: cannot be read as NetCDF: {_reason(error)}") from None
    with data:
        try:
            yield data
        except ClptError:
            raise
        except (OSError, RuntimeError) as error:
            reason = _reason(error)
            raise DataError(f"{path}: damaged: a variable cannot be read: {reason}") from None


def _reason(error: Exception) -> str:
    words = str(getattr(error, "strerror", None) or error) or type(error).__name__
    return words.splitlines()[0][:120]


def _check_classic(path: Path) -> None:
    """Refuse a classic file that was cut, which the NetCDF library fills with zeros."""
    with path.open("rb") as file:
        start = file.read(4)
        if start == b"CDF\x05":
            raise DataError(
                f"{path}: is classic NetCDF of 64-bit data, of which a part could be missing "
                "unseen; `nccopy -k nc4 FILE NEW` writes it as NetCDF-4"
            )
        if start[:3] != b"CDF":
            return
        from scipy.io import netcdf_file

        file.seek(0)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # of memory that is still mapped
                netcdf_file(file, mmap=True).close()
        except Exception:  # whatever a damaged header makes of itself
            raise DataError(
                f"{path}: damaged or cut short: it holds less than its NetCDF header says; "
                "fetch it again"
            ) from None


@contextmanager
def beside(path: str | Path) -> Iterator[Path]:
    """Return an empty file beside a place, then rename it there.

    Parameters
    ----------
    path : str or Path
        The place; its folder must exist.

    Yields
    ------
    Path
        Hidden, ``.NAME.`` with letters and ``.part``; gone if the work fails.

    Raises
    ------
    DataError
        If the place cannot be written to.
    """
    path = Path(path)
    check_name(path)
    if not path.parent.is_dir():
        raise DataError(f"{path}: cannot be written: the folder {path.parent} does not exist")
    made = None
    try:
        handle, made = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".part")
        os.close(handle)
        unfinished.add(Path(made))
        yield Path(made)
        check()  # an interrupt that was dropped may have changed what was written
        Path(made).chmod(0o644)
        Path(made).replace(path)
    except OSError as error:
        raise DataError(f"{path}: cannot be written: {error.strerror or error}") from None
    finally:
        if made is not None:
            Path(made).unlink(missing_ok=True)
            unfinished.discard(Path(made))


def remove_left(folder: str | Path, *names: str) -> None:
    """Remove what `beside` left where it was killed.

    Parameters
    ----------
    folder : str or Path
        Where nobody else writes these files now.
    *names : str
        Of the files that were to be written, such as ``"*.json"``.
    """
    for path in Path(folder).glob(".*.part"):
        found = PART.fullmatch(path.name)
        if found and path.is_file() and any(fnmatch(found[1], name) for name in names):
            path.unlink(missing_ok=True)


def write_together(results: "Mapping[Path, xarray.Dataset | Figure]") -> None:
    """Write files beside their places, then rename them all.

    The first is renamed last: where it is new, all are.  If one cannot be
    written, none is renamed.

    Parameters
    ----------
    results : dict
        By file: a dataset, whose variables with NaN get them as _FillValue, or
        a figure.

    Raises
    ------
    DataError
        If a file cannot be written.
    """
    with ExitStack() as renamed:
        for path, result in results.items():
            _put(result, renamed.enter_context(beside(path)), Path(path))


def _put(result: Any, made: Path, path: Path) -> None:
    if hasattr(result, "savefig"):
        result.savefig(made, format=path.suffix[1:])
        return
    fill = {
        name: {"_FillValue": float("nan") if _has_nan(values) else None}
        for name, values in result.variables.items()
    }
    try:
        result.to_netcdf(made, engine="netcdf4", encoding=fill)
    except (
        RuntimeError,
        PermissionError,
        UnicodeError,
    ) as error:  # HDF5's words for a full disk, too
        full = shutil.disk_usage(made.parent).free < 2**20
        reason = getattr(error, "strerror", None) or str(error)
        reason = "no space left" if full else f"{reason}; is there a limit on the size of files?"
        raise DataError(f"{path}: cannot be written: {reason}") from None


def _has_nan(values: "xarray.Variable") -> bool:
    return values.dtype.kind == "f" and bool(values.isnull().any())


def write_netcdf(data: "xarray.Dataset", path: str | Path) -> None:
    """Write a dataset beside its place, then rename it there.

    Raises
    ------
    DataError
        If the folder does not exist or cannot be written to.
    """
    write_together({Path(path): data})


def write_figure(figure: "Figure", path: str | Path) -> None:
    """Write a figure, such as ``map.png``, beside its place.

    Raises
    ------
    DataError
        If the folder does not exist or cannot be written to.
    """
    write_together({Path(path): figure})


def check_name(path: str | Path) -> None:
    """Refuse a name under which nothing can be written.

    Raises
    ------
    DataError
        If it is too long or no text.
    """
    try:
        longest = max((len(part.encode()) for part in Path(path).parts), default=0)
    except UnicodeEncodeError:
        raise DataError(
            f"{path}: its name holds bytes that are no text; give another name"
        ) from None
    if longest > LONGEST_NAME or len(str(path)) > LONGEST_PATH:
        raise DataError(
            f"{str(path)[:40]}...: the name is too long; at most {LONGEST_NAME} letters are "
            f"allowed, and {LONGEST_PATH} with all folders"
        )


def make_folder(path: str | Path) -> Path:
    """Make a folder for results, or say in one sentence why not.

    Raises
    ------
    ClptError
        If a file is in the way or the place cannot be written to.
    """
    path = Path(path)
    check_name(path)
    try:
        path.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise ClptError(f"{path}: is a file; give a folder") from None
    except OSError as error:
        raise ClptError(f"{path}: cannot be made: {error.strerror}") from None
    return path


def check_writable(path: str | Path) -> None:
    """Refuse, before work begins, a file that could not be written.

    Raises
    ------
    DataError
        If the folder is missing or closed, or a folder bears the name.
    """
    path = Path(path)
    check_name(path)
    if path.is_dir():
        raise DataError(f"{path}: is a folder; give a file name such as {path / 'run.nc'}")
    if not path.parent.is_dir():
        raise DataError(f"{path}: cannot be written: the folder {path.parent} does not exist")
    if not os.access(path.parent, os.W_OK):
        raise DataError(f"{path}: cannot be written: the folder {path.parent} is read-only")


def write_text(path: str | Path, text: str) -> None:
    """Write a text file whole or not at all.

    Raises
    ------
    DataError
        If the folder does not exist or cannot be written to.
    """
    with beside(path) as made:
        made.write_text(text, encoding="utf-8")
