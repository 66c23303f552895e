"""What repeats a diagram's run: its equations as plain data, inputs, start and method, as JSON.

A run in memory keeps them in its `encoding`, which xarray hands on; a file in an attribute.  They
are asked for when a run is saved, and kept only if the machine code made of them is the same.
"""

import json
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..diagrams.interconnection import Diagram
from ..diagrams.recorded import diagram_of, plain_diagram
from ..equations.recorded import Unrecorded
from ..errors import ClptError, DataError
from ..files import open_netcdf
from ..native.native_diagram import NativeDiagram
from ..native.schedule import Inputs
from ..scenario.file import (
    CHANGED,
    EQUATIONS,
    NOT_REPEATED,
    OWN_LAW,
    OWN_PARTS,
    check_form,
    load_scenario,
)
from .loops import closed_loop

if TYPE_CHECKING:
    import xarray

CONDITIONS = (
    "timepts",
    "initial_state",
    "inputs",
    "rtol",
    "atol",
    "method",
    "max_step",
    "first_step",
)


class Ran:
    """How a diagram ran: `text` is JSON, or an `Unrecorded` says why there is none."""

    def __init__(self, made: Any, engine: str, inputs: Inputs, conditions: dict[str, Any]):
        self.made, self.engine = made, engine  # a `DiagramRun`, and what ran it
        self.conditions = conditions
        self.inputs = inputs.samples and tuple(map(np.array, inputs.samples))  # own ones

    def __deepcopy__(self, memo: Any) -> "Ran":
        return self

    def __reduce__(self) -> Any:
        try:
            return str, (self.text,)
        except Unrecorded:
            return str, ("",)

    @cached_property
    def text(self) -> str:
        """The equations, inputs, start and method."""
        own, times = self.made.runner, self.conditions["timepts"]
        if self.inputs is None:
            raise Unrecorded("its inputs come by a function of Python; give samples at timepts")
        if self.engine != "native" or not isinstance(own, NativeDiagram):
            raise Unrecorded("it ran in Python, by functions that no file holds")
        plain = {
            "run": {**self.conditions, "inputs": self.inputs},
            "diagram": plain_diagram(
                self.made.wiring, own.sweep.given, self.made.called, *map(float, times[[0, -1]])
            ),
        }
        text = json.dumps(plain, default=lambda value: value.tolist())
        made = NativeDiagram(diagram_from(text))
        same = made.code.program == own.code.program
        same &= all(np.array_equal(getattr(made.layout, a), getattr(own.layout, a)) for a in "PT")
        if not same:
            raise Unrecorded("its blocks have changed since it ran")
        return text


def text_of(run: "xarray.Dataset") -> tuple[str, str]:
    """Return what repeats a run, or "" and why nothing does."""
    found = run.encoding.get(EQUATIONS) or run.attrs.get(EQUATIONS, "")
    try:
        return (found.text if isinstance(found, Ran) else str(found)), ""
    except Unrecorded as error:
        return "", str(error)


def diagram_from(text: str) -> Diagram:
    """Return the diagram of what repeats a run, which knows how it ran; or say what is wrong."""
    try:
        plain = json.loads(text)
        diagram, own = diagram_of(plain["diagram"]), plain["run"]
        diagram.recorded = {name: own[name] for name in CONDITIONS}
        at, values = (np.array(one, dtype=float) for one in own["inputs"])
        diagram.recorded["inputs"] = Inputs((at, values.reshape(diagram.ninputs, len(at))))
        state = np.array(own["initial_state"], dtype=float).reshape(diagram.nstates or 0)
        rest = [own[name] or 0.0 for name in ("rtol", "atol", "max_step", "first_step")]
        if not np.isfinite(np.concatenate([at, values.ravel(), state, rest[:2]])).all():
            raise DataError("a number is not finite")
        if not (np.all(np.diff(at) > 0) and np.all(np.diff(own["timepts"]) > 0)):
            raise DataError("its times do not increase")
        if min(rest) < 0 or not isinstance(own["method"], str | None):
            raise DataError("its tolerances, steps or method are none")
    except ClptError as error:
        raise DataError(f"its equations are damaged: {error}") from None
    except Exception as error:  # whatever damaged data make of themselves
        what = f"{type(error).__name__}: {error}".replace("\n", " ")
        raise DataError(f"its equations are damaged: {what:.80}") from None
    return diagram


def repeats_by_equations(path: Path) -> bool:
    """Return whether a file holds equations, and no scenario that says all."""
    with open_netcdf(path) as data:
        given = {OWN_LAW, OWN_PARTS, CHANGED} & data.attrs.keys()
        return EQUATIONS in data.attrs and bool(given or "scenario" not in data.attrs)


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
        check_form(data.attrs, path)
        text, why = (str(data.attrs.get(name, "")) for name in (EQUATIONS, NOT_REPEATED))
    if not text and "scenario" in data.attrs:
        return closed_loop(load_scenario(path))
    if not text:
        raise DataError(f"{path}: holds no equations{f': {why}' if why else ''}")
    try:
        return diagram_from(text)
    except ClptError as error:
        raise DataError(f"{path}: {error}") from None
