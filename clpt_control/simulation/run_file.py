"""A run as a file: NetCDF with CF attributes, and its scenario or its equations, which repeat it.

The equations of a diagram's run are JSON, with inputs, start and method.  A run in memory has them
in its `encoding`, which xarray hands on, a file in an attribute.  They are written when a run is
saved, and only if the machine code of what is written is that of the run.
"""

import json
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..base.arguments import public
from ..base.errors import ClptError, DataError
from ..base.files import write_file
from ..base.files.reading import open_netcdf
from ..engine.diagram.interconnection import Diagram
from ..engine.solver.native_diagram import NativeDiagram
from ..engine.solver.schedule import Inputs
from ..engine.trace.arrays import Unread
from ..paper.scenario import file
from ..paper.scenario.experiment import MOST_BYTES, Scenario
from ..paper.scenario.recorded_run import check_response, check_run, is_response
from ..paper.scenario.team import Team, system_of_run, team_to_text
from .loops import closed_loop
from .plain_data import diagram_of, plain_diagram

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
    if not set(run.data_vars) - {"states"}:
        raise DataError(f"{path}: the run has no signal; give its system outputs")
    write_file(path, as_written(run, Path(path)))


def as_written(run: "xarray.Dataset", path: Path) -> "xarray.Dataset":
    """Return a run as its file holds it: with its scenario or its equations, which repeat it.

    The scenario's paths are relative to the file.
    """
    if {"scenario", file.TEAM} & run.attrs.keys():
        system = system_of_run(run)
        if isinstance(system, Team):
            run = run.assign_attrs({file.TEAM: team_to_text(system, path.parent)})
        else:
            run = run.assign_attrs(scenario=file.scenario_to_text(system, path.parent))
    text, why = equations_text(run)
    if text:
        run = run.assign_attrs({file.EQUATIONS: text})
    elif is_response(run):
        run = run.assign_attrs(
            {file.NOT_REPEATED: why or run.attrs.get(file.NOT_REPEATED, LOST)}
        )
    return run.assign_attrs({file.FORM: file.LATEST})


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
            raise DataError(f"{path}: {NO_RUN}; `clpt run` writes one")
        run = data.load()
    try:
        if is_response(run):
            check_response(run)
        else:
            system = system_of_run(run, files=False)
            check_run(run, system, "time", "position", "predicted_position", "clpe")
        if text := str(run.attrs.pop(file.EQUATIONS, "")):
            diagram_of_text(text)
            run.encoding[file.EQUATIONS] = text
    except ClptError as error:
        raise DataError(f"{path}: {error}") from None
    run.attrs.pop(file.FORM, None)  # of the file, not of the run
    run.encoding["folder"] = str(Path(path).parent)
    return run


# --- what repeats a diagram's run ---------------------------------------------------------------

CONDITIONS = (
    *("timepts", "initial_state", "inputs"),
    *("rtol", "atol", "method", "max_step", "first_step"),
)
# attributes for what a scenario does not hold
BEYOND = (file.OWN_LAW, file.OWN_PARTS, file.CHANGED)


class RecordedScenario(NamedTuple):
    """The scenario of a closed loop in a file, and the attributes for what it does not hold."""

    scenario: Scenario
    beyond_scenario: dict[str, str]


class RunRecord:
    """How a diagram ran: `text` is JSON, or raises an `Unread` that says why there is none."""

    def __init__(
        self, run: Any, engine: str, inputs: Inputs, conditions: dict[str, Any]
    ):
        self.run, self.engine = run, engine  # a `DiagramRun`, and what ran it
        self.conditions = conditions
        self.inputs = tuple(map(np.array, inputs.samples))  # copies

    def __deepcopy__(self, memo: Any) -> "RunRecord":
        return self

    def __reduce__(self) -> Any:
        try:
            return str, (self.text,)
        except Unread:
            return str, ("",)

    @cached_property
    def text(self) -> str:
        """The equations, inputs, start and method."""
        runner, times = self.run.runner, self.conditions["timepts"]
        if self.engine != "native" or not isinstance(runner, NativeDiagram):
            raise Unread("it ran in Python, by functions that no file holds")
        given, ends = runner.sweep.parameters, map(float, times[[0, -1]])
        plain = {
            "run": {**self.conditions, "inputs": self.inputs},
            "diagram": plain_diagram(self.run.wiring, given, self.run.names, *ends),
        }
        text = json.dumps(plain, default=lambda value: value.tolist())
        try:
            again = NativeDiagram(diagram_of_text(text))
        except DataError as error:  # a name that no block of a file has
            raise Unread(str(error)) from None
        arrays = [(getattr(again.layout, a), getattr(runner.layout, a)) for a in "PT"]
        # NaN differs from itself
        same = repr(again.code.program) == repr(runner.code.program)
        if not (same and all(np.array_equal(*pair) for pair in arrays)):
            raise Unread("its blocks have changed since it ran")
        return text


def equations_text(run: "xarray.Dataset") -> tuple[str, str]:
    """Return the equations that repeat a run, or "" and why there are none."""
    record = run.encoding.get(file.EQUATIONS) or run.attrs.get(file.EQUATIONS, "")
    try:
        return (record.text if isinstance(record, RunRecord) else str(record)), ""
    except Unread as error:
        return "", str(error)


def diagram_of_text(text: str) -> Diagram:
    """Return the diagram of the equations that repeat a run; it knows how it ran."""
    try:
        plain = json.loads(text)
        diagram, run = diagram_of(plain["diagram"]), plain["run"]
        diagram.recorded = {name: run[name] for name in CONDITIONS}
        at, values = (np.array(one, dtype=float) for one in run["inputs"])
        diagram.recorded["inputs"] = Inputs(
            (at, values.reshape(diagram.ninputs, len(at)))
        )
        state = np.array(run["initial_state"], dtype=float).reshape(
            diagram.nstates or 0
        )
        rest = [run[name] or 0.0 for name in ("rtol", "atol", "max_step", "first_step")]
        if not np.isfinite(np.concatenate([at, values.ravel(), state, rest[:2]])).all():
            raise DataError("a number is not finite")
        if not (np.all(np.diff(at) > 0) and np.all(np.diff(run["timepts"]) > 0)):
            raise DataError("its times do not increase")
        if min(rest) < 0 or not isinstance(run["method"], str | None):
            raise DataError("its tolerances, steps or method are none")
    except ClptError as error:
        raise DataError(f"its equations are damaged: {error}") from None
    except Exception as error:  # damaged data can raise anything
        what = f"{type(error).__name__}: {error}".replace("\n", " ")
        raise DataError(f"its equations are damaged: {what:.80}") from None
    return diagram


def repeats_by_equations(path: Path) -> bool:
    """Return whether a run's file holds equations, and no scenario that repeats it alone."""
    if path.suffix != ".nc":
        return False
    with open_netcdf(path) as data:
        beyond = data.attrs.keys() & {*BEYOND}
        return file.EQUATIONS in data.attrs and bool(
            beyond or "scenario" not in data.attrs
        )


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
        If the file is missing or damaged, or its run holds no equations; the sentence says why.

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
    text, why = (
        attributes.get(name, "") for name in (file.EQUATIONS, file.NOT_REPEATED)
    )
    if not text and "scenario" in attributes:
        return closed_loop(file.load_scenario(path))
    if not text:
        raise DataError(f"{path}: holds no equations{f': {why}' if why else ''}")
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
