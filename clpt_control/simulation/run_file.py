"""A run as a file: NetCDF with CF attributes and what repeats it: its scenario, its equations."""

from pathlib import Path
from typing import TYPE_CHECKING

from ..arguments import public
from ..errors import ClptError, DataError
from ..files import open_netcdf, write_netcdf
from ..scenario.experiment import MOST_BYTES
from ..scenario.file import (
    EQUATIONS,
    FORM,
    LATEST,
    NOT_REPEATED,
    TEAM,
    check_form,
    scenario_to_text,
)
from ..scenario.recorded_run import check_response, check_run, is_response
from ..scenario.team import Team, system_of_run, team_to_text
from .repeating import diagram_from, text_of

if TYPE_CHECKING:
    import xarray

NO_RUN = "is no run: it has no variable 'clpe', nor the signals of a diagram"
LOST = "it was saved without them, by another way than clpt.save_run"


@public
def save_run(run: "xarray.Dataset", path: str | Path) -> None:
    """Write a run to NetCDF, with what repeats it.

    That is the scenario; of a diagram's run the records of its equations, its inputs, its start
    and its method, as plain data: `load_diagram` reads them. What cannot be recorded, such as a
    function that only Python can run, is left out, and the attribute ``not_repeated`` says why.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it.
    path : str or Path
        The file.

    Raises
    ------
    DataError
        If the file cannot be written, or the dataset is no run.

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
    if "clpe" not in run.variables and not is_response(run):
        raise DataError(f"{path}: {NO_RUN}; clpt.simulate gives runs")
    write_netcdf(as_written(run, Path(path)), path)


def as_written(run: "xarray.Dataset", path: Path) -> "xarray.Dataset":
    """Return a run as its file holds it: with what repeats it, where there is such.

    That is its scenario, whose paths begin at the file's, or the equations of its diagram.
    """
    if {"scenario", TEAM} & run.attrs.keys():
        system = system_of_run(run)
        if isinstance(system, Team):
            run = run.assign_attrs({TEAM: team_to_text(system, path.parent)})
        else:
            run = run.assign_attrs(scenario=scenario_to_text(system, path.parent))
    text, why = text_of(run)
    if text:
        run = run.assign_attrs({EQUATIONS: text})
    elif is_response(run):
        run = run.assign_attrs({NOT_REPEATED: why or run.attrs.get(NOT_REPEATED, LOST)})
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
        if "clpe" not in data.variables and not is_response(data):
            raise DataError(f"{path}: {NO_RUN}; `clpt run` writes one")
        run = data.load()
    try:
        if is_response(run):
            check_response(run)
        else:
            system = system_of_run(run, files=False)
            check_run(run, system, "time", "position", "predicted_position", "clpe")
        if text := str(run.attrs.pop(EQUATIONS, "")):
            diagram_from(text)
            run.encoding[EQUATIONS] = text
    except ClptError as error:
        raise DataError(f"{path}: {error}") from None
    run.attrs.pop(FORM, None)  # of the file, not of the run
    run.encoding["folder"] = str(Path(path).parent)
    return run
