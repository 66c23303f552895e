"""Record of a diagram's run as JSON: its equations, inputs, initial state and solver options.

A run in memory has the record in its `encoding`, which xarray passes on; a file has the text in an
attribute.  The text is made when the run is saved, and only if the machine code of the text is that
of the run.
"""

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from ...base.errors import ClptError, DataError
from ...engine.diagram.interconnection import Diagram
from ...engine.record.unread import Unread
from ...engine.solver.native_diagram import NativeDiagram
from ...engine.solver.schedule import Inputs
from ...paper.scenario.run_constants import ARGUMENTS, EQUATIONS, TEAM
from .diagrams import diagram_of, plain_diagram
from .records import plain_data

if TYPE_CHECKING:
    import xarray

STEP_OPTIONS = ("max_step", "first_step")
SOLVER_OPTIONS = ("rtol", "atol", "method", *STEP_OPTIONS)
CONDITIONS = ("timepts", "initial_state", "inputs", *SOLVER_OPTIONS)


class RunRecord:
    """Record of a run; `text` is JSON, or raises `Unread` with the reason why there is none.

    `run` is a `DiagramRun`, and `engine` the engine that ran.
    """

    def __init__(
        self, run: Any, engine: str, inputs: Inputs, conditions: dict[str, Any]
    ):
        self.run = run
        self.engine = engine
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
        """The equations, inputs, initial state and solver options as JSON."""
        runner = self.run.runner
        if self.engine != "native" or not isinstance(runner, NativeDiagram):
            raise Unread("it ran in Python, by functions that no file holds")
        begin, end = map(float, self.conditions["timepts"][[0, -1]])
        sweep = runner.sweep
        times, values = self.inputs
        sweep.trigger(Inputs((times, values)))
        record = {
            "run": {**self.conditions, "inputs": self.inputs},
            "diagram": plain_diagram(
                *(self.run.wiring, sweep.parameters, self.run.names),
                *(begin, end, sweep.triggered),
            ),
        }
        text = json.dumps(record, default=plain_data)
        try:
            recorded = NativeDiagram(diagram_of_text(text))
        except DataError as error:  # a name that no block of a file has
            raise Unread(str(error)) from None
        if not _same_code(recorded, runner):
            raise Unread("its blocks have changed since it ran")
        return text


def _same_code(recorded: NativeDiagram, runner: NativeDiagram) -> bool:
    """Return whether two diagrams have the same program, parameters and tables, without NaN."""
    if repr(recorded.code.program) != repr(runner.code.program):
        return False
    layout = runner.layout
    return np.array_equal(recorded.layout.P, layout.P) and np.array_equal(
        recorded.layout.T, layout.T
    )


def equations_text(run: "xarray.Dataset") -> tuple[str, str]:
    """Return the record of a run as JSON, or "" and the reason why there is none."""
    record = run.encoding.get(EQUATIONS) or run.attrs.get(EQUATIONS, "")
    if not isinstance(record, RunRecord):
        return str(record), ""
    try:
        return record.text, ""
    except Unread as error:
        return "", str(error)


def note_arguments(
    run: "xarray.Dataset", arguments: dict[str, Any], skipped: int
) -> None:
    """Note in a run what was given to `simulate` beside the system, and the samples left out."""
    record = run.encoding.get(EQUATIONS)
    if skipped and isinstance(record, RunRecord):
        record.conditions["skipped"] = skipped
    given = {key: value for key, value in arguments.items() if value is not None}
    if given and {"scenario", TEAM} & run.attrs.keys():
        run.encoding[ARGUMENTS] = given


def arguments_text(run: "xarray.Dataset") -> str:
    """Return the arguments of a scenario's run that are not in the scenario, as JSON, or ""."""
    given = run.encoding.get(ARGUMENTS)
    return json.dumps(given, default=lambda x: np.asarray(x).tolist()) if given else ""


def arguments_of_text(text: str) -> dict[str, Any]:
    """Return the arguments of a scenario's run from JSON, for `simulate`."""
    try:
        given = json.loads(text or "{}")
        unknown = given.keys() - {"timepts", "first_step", "engine", "max_step"}
    except (ValueError, AttributeError):
        unknown = {"text"}
    if unknown:
        raise DataError(f"its arguments are damaged: {min(unknown)}")
    return given


def signal_names(run: "xarray.Dataset") -> dict[str, Any]:
    """Return the name of a run's diagram, and the labels of its inputs and outputs, if recorded."""
    record = run.encoding.get(EQUATIONS) or run.attrs.get(EQUATIONS, "")
    if isinstance(record, RunRecord):
        return record.run.names
    unknown = {"name": "", "inputs": [], "outputs": []}
    return json.loads(record)["diagram"] if record else unknown


def diagram_of_text(text: str) -> Diagram:
    """Return the diagram of a record as JSON; its attribute `recorded` has the conditions."""
    try:
        plain = json.loads(text)
        diagram = diagram_of(plain["diagram"])
        diagram.recorded = _recorded_conditions(plain["run"], diagram)
    except ClptError as error:
        raise DataError(f"its equations are damaged: {error}") from None
    except Exception as error:  # damaged data can raise anything
        reason = f"{type(error).__name__}: {error}".replace("\n", " ")
        raise DataError(f"its equations are damaged: {reason:.80}") from None
    return diagram


def _recorded_conditions(plain: dict[str, Any], diagram: Diagram) -> dict[str, Any]:
    """Return the conditions of a run, checked."""
    times, values = (np.array(samples, dtype=float) for samples in plain["inputs"])
    values = values.reshape(diagram.ninputs, len(times))
    state = np.array(plain["initial_state"], dtype=float)
    state = state.reshape(diagram.nstates or 0)
    tolerances = [plain[name] or 0.0 for name in ("rtol", "atol")]
    steps = [plain[name] or 0.0 for name in STEP_OPTIONS]
    if not np.isfinite(
        np.concatenate([times, values.ravel(), state, tolerances])
    ).all():
        raise DataError("a number is not finite")
    if not (np.all(np.diff(times) >= 0) and np.all(np.diff(plain["timepts"]) > 0)):
        raise DataError("its times do not increase")
    if min(tolerances + steps) < 0 or not isinstance(plain["method"], str | None):
        raise DataError("its tolerances, steps or method are not valid")
    conditions = {name: plain[name] for name in CONDITIONS}
    conditions["skipped"] = int(plain.get("skipped", 0))
    return {**conditions, "inputs": Inputs((times, values))}
