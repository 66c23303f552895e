"""Files: opened with one clear sentence, written whole or not at all.

What is written goes beside its place first and is renamed there, so that an
interrupt leaves the old file or none.
"""

import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import ClptError, DataError

if TYPE_CHECKING:
    import xarray


def open_netcdf(path: str | Path) -> "xarray.Dataset":
    """Open a NetCDF file with xarray, or say in one sentence why not.

    Parameters
    ----------
    path : str or Path
        The file.

    Returns
    -------
    xarray.Dataset
        Times left as numbers.

    Raises
    ------
    DataError
        If the file is missing or not NetCDF.
    """
    import xarray

    if not Path(path).exists():
        raise DataError(f"{path}: no such file; must be a NetCDF file")
    if not Path(path).is_file():
        raise DataError(f"{path}: is not a file; must be a NetCDF file")
    try:
        return xarray.open_dataset(path, decode_times=False, engine="netcdf4")
    except (OSError, ValueError, RuntimeError) as error:
        reason = str(getattr(error, "strerror", None) or error).splitlines()[0][:120]
        raise DataError(f"{path}: cannot be read as NetCDF: {reason}") from None


def write_netcdf(data: "xarray.Dataset", path: str | Path) -> None:
    """Write a dataset beside its place, then rename it there.

    Parameters
    ----------
    data : xarray.Dataset
        What to write.
    path : str or Path
        The file; its folder must exist.

    Raises
    ------
    DataError
        If the file cannot be written.
    """
    path = Path(path)
    if not path.parent.is_dir():
        raise DataError(f"{path}: cannot be written: the folder {path.parent} does not exist")
    beside = None
    try:
        handle, beside = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
        os.close(handle)
        no_fill = {name: {"_FillValue": None} for name in data.variables}
        data.to_netcdf(beside, engine="netcdf4", encoding=no_fill)
        Path(beside).chmod(0o644)
        Path(beside).replace(path)
    except OSError as error:
        raise DataError(f"{path}: cannot be written: {error.strerror or error}") from None
    finally:
        if beside is not None:
            Path(beside).unlink(missing_ok=True)


def make_folder(path: str | Path) -> Path:
    """Make a folder for results, or say in one sentence why not.

    Raises
    ------
    ClptError
        If a file is in the way or the place cannot be written to.
    """
    path = Path(path)
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
    path = Path(path)
    try:
        handle, beside = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(text)
        Path(beside).chmod(0o644)
        Path(beside).replace(path)
    except OSError as error:
        raise DataError(f"{path}: cannot be written: {error.strerror}") from None
