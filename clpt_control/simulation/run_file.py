"""Run files: NetCDF with CF attributes, from which a run can be repeated.

The file of a scenario's run has the scenario as TOML.  The file of a diagram's run has the
equations, inputs, initial state and solver options as JSON (`serialization.run_record`), or the
reason why they are missing.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from ..base.arguments import public
from ..base.errors import ClptError, DataError
from ..base.files import write_file
from ..base.files.reading import open_netcdf
from ..engine.diagram.interconnection import Diagram
from ..paper.scenario import file
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import check_response, check_run, is_response
from ..paper.scenario.run_constants import (
    ARGUMENTS,
    BEYOND,
    EQUATIONS,
    FORM,
    MOST_BYTES,
    NOT_REPEATED,
    TEAM,
)
from ..paper.scenario.team import Team, system_of_run, team_to_text
from .loops import closed_loop
from .serialization.run_record import (
    arguments_of_text,
    arguments_text,
    diagram_of_text,
    equations_text,
)

if TYPE_CHECKING:
    import xarray

NO_RUN = "is not a run: it has no variable 'clpe', nor the signals of a diagram"
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
        raise DataError(f"{path}: {NO_RUN}; Make a run with clpt.simulate")
    if not set(run.data_vars) - {"states"}:
        raise DataError(f"{path}: the run has no signal. Give its system outputs")
    write_file(path, as_written(run, Path(path)))


def as_written(run: "xarray.Dataset", path: Path) -> "xarray.Dataset":
    """Return a run with the attributes of its file; paths of the scenario are relative to it."""
    attributes: dict[str, str] = {}
    if {"scenario", TEAM} & run.attrs.keys():
        system = system_of_run(run)
        if isinstance(system, Team):
            attributes[TEAM] = team_to_text(system, path.parent)
        else:
            attributes["scenario"] = file.scenario_to_text(system, path.parent)
    if arguments := arguments_text(run):
        attributes[ARGUMENTS] = arguments
    equations, reason = equations_text(run)
    if equations:
        attributes[EQUATIONS] = equations
    elif is_response(run):
        reason = reason or run.attrs.get(NOT_REPEATED, LOST)
        attributes[NOT_REPEATED] = reason
    return run.assign_attrs({**attributes, FORM: file.LATEST})


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
        file.check_form(data.attrs, path)
        if "clpe" not in data.variables and not is_response(data):
            raise DataError(f"{path}: {NO_RUN}; Make a run with: clpt run")
        run = data.load()
    try:
        if is_response(run):
            check_response(run)
        else:
            system = system_of_run(run, files=False)
            check_run(run, system, "time", "position", "predicted_position", "clpe")
        if text := str(run.attrs.pop(EQUATIONS, "")):
            diagram_of_text(text)
            run.encoding[EQUATIONS] = text
        if text := str(run.attrs.pop(ARGUMENTS, "")):
            run.encoding[ARGUMENTS] = arguments_of_text(text)
    except ClptError as error:
        raise DataError(f"{path}: {error}") from None
    run.attrs.pop(FORM, None)  # of the file, not of the run
    run.encoding["folder"] = str(Path(path).parent)
    return run


class RecordedScenario(NamedTuple):
    """The scenario of a closed loop in a file, and attributes for changes of the loop."""

    scenario: Scenario
    beyond_scenario: dict[str, str]


def repeats_by_equations(path: Path) -> bool:
    """Return whether a file has equations, and no scenario that repeats its run alone."""
    if path.suffix != ".nc":
        return False
    with open_netcdf(path) as data:
        attributes = data.attrs.keys()
        if EQUATIONS not in attributes:
            return False
        return "scenario" not in attributes or not attributes.isdisjoint(BEYOND)


def recorded_arguments(path: Path) -> dict[str, Any]:
    """Return the arguments of `simulate` that repeat a scenario's run, beside its scenario."""
    if path.suffix != ".nc":
        return {}
    with open_netcdf(path) as data:
        text = str(data.attrs.get(ARGUMENTS, ""))
    try:
        return arguments_of_text(text)
    except ClptError as error:
        raise DataError(f"{path}: {error}") from None


@public
def load_diagram(path: str | Path) -> Diagram:
    """Read the diagram of a run that `save_run` wrote, no code.

    Parameters
    ----------
    path : str or Path
        A NetCDF file of a diagram's run, or of a scenario's, whose closed loop it is.

    Returns
    -------
    Diagram
        Of blocks that are records; nothing of the file is run as code. ``clpt.simulate(diagram)``
        repeats the run; what is given to `simulate` takes the place of what was recorded.

    Raises
    ------
    DataError
        If the file is missing or damaged, or its run contains no equations; the sentence says why.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> import control, tempfile, pathlib
    >>> lag = control.ss(-1, 1, 1, 0, inputs="u", outputs="y", name="lag")
    >>> run = clpt.simulate(lag, [0.0, 1.0, 2.0], 1.0)
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "lag.nc"
    >>> clpt.save_run(run, file)
    >>> again = clpt.simulate(clpt.load_diagram(file))
    >>> bool((again.y == run.y).all())
    True
    """
    with open_netcdf(Path(path)) as data:
        file.check_form(data.attrs, path)
        attributes = {name: str(value) for name, value in data.attrs.items()}
    text = attributes.get(EQUATIONS)
    if not text and "scenario" in attributes:
        loop = closed_loop(file.load_vehicle_scenario(path))
        loop.recorded = recorded_arguments(Path(path))
        return loop
    if not text:
        reason = attributes.get(NOT_REPEATED)
        raise DataError(
            f"{path}: contains no equations{f': {reason}' if reason else ''}"
        )
    try:
        diagram = diagram_of_text(text)
        if "scenario" in attributes:
            scenario = file.scenario_from_text(
                attributes["scenario"], "the run", Path(path).parent
            )
            beyond = {name: attributes[name] for name in BEYOND if name in attributes}
            diagram.recorded["experiment"] = RecordedScenario(scenario, beyond)
    except ClptError as error:
        raise DataError(f"{path}: {error}") from None
    return diagram
