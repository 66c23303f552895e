"""A run as a file: NetCDF with CF attributes, written whole or not at all."""

import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from .errors import ClptError, DataError

if TYPE_CHECKING:
    import xarray


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


def save_run(run: "xarray.Dataset", path: str | Path) -> None:
    """Write a run to NetCDF; its scenario goes along.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it.
    path : str or Path
        The file.

    Raises
    ------
    DataError
        If the file cannot be written.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> import tempfile, pathlib
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 5})
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "run.nc"
    >>> clpt.save_run(clpt.simulate(scenario), file)
    >>> clpt.load_scenario(file) == scenario
    True
    """
    from .scenario_file import scenario_from_text, scenario_to_text

    path, text = Path(path), run.attrs.get("scenario")
    if text is not None:
        scenario = scenario_from_text(text, "scenario", Path(run.encoding.get("folder", ".")))
        run = run.assign_attrs(scenario=scenario_to_text(scenario, path.parent))
    write_netcdf(run, path)


def load_run(path: str | Path) -> "xarray.Dataset":
    """Read a run that `save_run` or `clpt run` wrote.

    Parameters
    ----------
    path : str or Path
        A NetCDF file.

    Returns
    -------
    xarray.Dataset
        In memory, as `simulate` gave it.

    Raises
    ------
    DataError
        If the file is missing, is not NetCDF, or is no run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> import tempfile, pathlib
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 5})
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "run.nc"
    >>> clpt.save_run(clpt.simulate(scenario), file)
    >>> clpt.load_run(file).sizes["time"]
    6
    """
    from .ocean.gridded import open_netcdf

    with open_netcdf(Path(path)) as data:
        if "clpe" not in data.variables:
            raise DataError(f"{path}: is no run: it has no variable 'clpe'; `clpt run` writes one")
        run = data.load()
    run.encoding["folder"] = str(Path(path).parent)
    return run


def scenario_text(path: str | Path) -> str:
    """Give the scenario that a run's file carries, as TOML text.

    Raises
    ------
    DataError
        If the file is missing, is not NetCDF, or carries no scenario.
    """
    from .ocean.gridded import open_netcdf

    with open_netcdf(Path(path)) as data:
        if "scenario" not in data.attrs:
            raise DataError(f"{path}: carries no scenario; `clpt run` writes runs that do")
        return str(data.attrs["scenario"])


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
