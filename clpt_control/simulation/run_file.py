"""A run as a file: NetCDF with CF attributes and its own scenario."""

from pathlib import Path
from typing import TYPE_CHECKING

from ..arguments import public
from ..errors import ClptError, DataError
from ..files import open_netcdf, write_netcdf
from ..scenario.experiment import MOST_BYTES
from ..scenario.file import FORM, LATEST, TEAM, check_form, scenario_to_text
from ..scenario.recorded_run import check_run
from ..scenario.team import Team, system_of_run, team_to_text

if TYPE_CHECKING:
    import xarray


@public
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
        If the file cannot be written, or the run is that of a diagram without CLPE.

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
    if "clpe" not in run.variables:
        raise DataError(
            f"{path}: {run.attrs.get('title', 'the dataset')} has no variable clpe, without which "
            "load_run reads nothing; write it by run.to_netcdf, read it by xarray.load_dataset"
        )
    write_netcdf(as_written(run, Path(path)), path)


def as_written(run: "xarray.Dataset", path: Path) -> "xarray.Dataset":
    """Return a run as its file holds it: with its scenario, whose paths begin at the file's."""
    if {"scenario", TEAM} & run.attrs.keys():
        system = system_of_run(run)
        if isinstance(system, Team):
            run = run.assign_attrs({TEAM: team_to_text(system, path.parent)})
        else:
            run = run.assign_attrs(scenario=scenario_to_text(system, path.parent))
    return run.assign_attrs({FORM: LATEST})


@public
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
        If the file is missing, is not NetCDF, is no run, one with gaps, or of a later form.

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
    with open_netcdf(Path(path), MOST_BYTES) as data:
        check_form(data.attrs, path)
        if "clpe" not in data.variables:
            raise DataError(f"{path}: is no run: it has no variable 'clpe'; `clpt run` writes one")
        run = data.load()
    try:
        system = system_of_run(run, files=False)
        check_run(run, system, "time", "position", "predicted_position", "clpe")
    except ClptError as error:
        raise DataError(f"{path}: {error}") from None
    run.attrs.pop(FORM, None)  # of the file, not of the run
    run.encoding["folder"] = str(Path(path).parent)
    return run
