"""How a run varies with parameters and with its start: the derivatives of its outputs.

    S' = A S + B,  A = df/dx, B = df/dp along the run;   dy/dp = C S + D

S is integrated with the run itself (`codegen.directional_derivatives`), by the same engine, from
the exact derivative of the record.

Where the run crosses a jump of a function that moves with p, dy/dp has a term for the moment of
crossing, which S lacks.  Where functions may jump, the same run is taken a little to both sides:
differences confirm S, or it is refused.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from math import prod
from typing import TYPE_CHECKING, Any, NamedTuple

import control
import numpy as np

from ..base.arguments import nearest, public
from ..base.errors import SimulationError, Uncompiled
from ..engine.codegen.directional_derivatives import (
    Directions,
    Place,
    Varied,
    may_jump,
    place_of,
    places_of,
    put,
    read_as_number,
    value_at,
)
from ..engine.diagram.wiring import Wiring
from ..engine.solver.engine_choice import run_compared
from ..engine.solver.native_diagram import NativeDiagram
from ..engine.solver.schedule import read_inputs
from ..engine.solver.termination import Solution
from ..engine.trace.arrays import Unread
from ..paper.scenario.experiment import Scenario
from .dataset import diagram_frame
from .integrate import request_of, sizes_of_run
from .running import compiled, signal_units
from .starts import stacked_state

if TYPE_CHECKING:
    import xarray

START = "x0"  # all states of the start
STEPS = (1e-3, 1e-4, 1e-5)  # of the differences, of what is varied
CLOSE = 1e-3  # how far off they may be, of the largest
EXACT = {"rtol": 1e-10, "atol": 1e-13}  # of their runs


class RunWithDerivatives(NamedTuple):
    """Outputs and states of a run, and then how they vary: of shape (nt, count, 1 + ways)."""

    solution: Solution
    outputs: np.ndarray
    states: np.ndarray

    @property
    def every(self) -> np.ndarray:
        """Outputs, then states."""
        return np.concatenate([self.outputs, self.states], axis=1)


def varied_places(
    names: str | Iterable[str], wiring: Wiring, states: Sequence[str]
) -> dict[str, Place]:
    """Return what is varied by these names, number by number: parameters, states of the start."""
    parameters, places = (
        [node.system.parameters for node in wiring.nodes],
        dict[str, Place](),
    )
    known = places_of(wiring, parameters, states)
    starts = {
        f"{START}.{name}": own[-1] for name, own in known.items() if own[-1].states
    }
    starts[START] = Place(states=tuple(range(len(states))))
    for name in [names] if isinstance(names, str) else names:
        place = starts.get(name) or place_of(name, known, parameters)
        if place is None:  # unknown, or a parameter and a state: x0.NAME is the state
            several = sorted({*known, *starts})
            close = nearest(name, several)
            raise SimulationError(
                f"{name}: must be among {', '.join(several)}, or an element, counted from 0"
                + (f"; did you mean {close}?" if close else "")
            )
        places |= {f"{START}.{states[k]}": Place(states=(k,)) for k in place.states}
        if place.fields:
            value, whole = (
                value_at(place, parameters, np.zeros(0)),
                name.partition("[")[0],
            )
            every = (
                np.ndindex(np.shape(value)) if place.element is ... else [place.element]
            )
            for at in every:
                label = f"{whole}[{','.join(map(str, at))}]" if at else name
                places[label] = place._replace(element=at)
    for name, place in places.items():
        for k, field in place.fields:
            if role := read_as_number(wiring.nodes[k].system, field):
                raise SimulationError(
                    f"{name}: {wiring.nodes[k].name}.{role} asks for its value (a count, an "
                    "index, an `if`, or a library that is no NumPy), so its derivative is not known"
                )
    if not places:
        raise SimulationError(
            "to: nothing is varied; name a parameter, or a state of the start"
        )
    return places


class Sensitive:
    """A diagram with what it is varied by, ready to run at any values of that."""

    def __init__(
        self,
        system: Any,
        timepts: Any,
        to: str | Iterable[str],
        inputs: Any,
        initial_state: Any,
        params: Mapping[str, Any] | None,
        **solver: Any,
    ):
        system, times, self.skipped, inputs, start, self.solver = request_of(
            system, timepts, inputs, initial_state, **solver
        )
        self.name, self.times = system.name, times
        try:
            run = compiled(system, params, sizes_of_run(system, inputs, start, times))
            self.wiring, self.states = run.wiring, run.states
            self.given = run.runner.sweep.parameters
            self.places = varied_places(to, self.wiring, self.states)
            self.runner = self._compile(params)
        except (Uncompiled, Unread) as error:
            raise SimulationError(
                f"{self.name}: has no known derivative: {error}"
            ) from None
        outputs = len(self.wiring.outputs)
        self.labels, self.input_labels = (
            run.signal_labels[:outputs],
            run.signal_labels[outputs:],
        )
        self.units = signal_units(run.wiring)[:outputs]
        self.inputs = read_inputs(inputs, times, run.wiring.ninputs)
        state = 0.0 if start is None else start
        self.start = stacked_state("initial_state", state, run.runner.nstates)

    def _compile(self, params: Mapping[str, Any] | None) -> NativeDiagram:
        """Return the diagram with derivatives along each varied value, ready to run."""
        directions = tuple(self._parameters(place) for place in self.places.values())
        varied_blocks = {k for direction in directions for k, _, _ in direction}
        self.doubtful = [  # blocks in which something may jump
            node.name
            for k, node in enumerate(self.wiring.nodes)
            if may_jump(node.system)
            or (k in varied_blocks and node.system.breakpoints_function is not None)
        ]
        fields = {
            field: field for place in self.places.values() for field in place.fields
        }
        return NativeDiagram(self.wiring, params, Directions(directions), fields)

    def _parameters(self, place: Place) -> Varied:
        """Return the parameters of one varied value: (block, field, index)."""
        parameters = []
        for k, field in place.fields:
            shape = np.shape(getattr(self.given[k], field))
            indices = np.arange(prod(shape)).reshape(shape)[place.element]
            parameters += [(k, field, int(index)) for index in np.ravel(indices)]
        return tuple(parameters)

    @property
    def values(self) -> np.ndarray:
        """What is varied, as it was given."""
        return np.array(
            [value_at(place, self.given, self.start) for place in self.places.values()]
        )

    def with_values(self, values: np.ndarray) -> tuple[np.ndarray, list[Any]]:
        """Return the start, and parameters of blocks, with other values of what is varied."""
        start, given = self.start.copy(), list(self.given)
        for place, value in zip(self.places.values(), values, strict=True):
            put(place, value, given, start)
        return start, given

    def run(self, values: np.ndarray, **solver: Any) -> RunWithDerivatives:
        """Run with other values of what is varied."""
        start, given = self.with_values(values)
        x = np.zeros((1 + len(self.places), len(start)))
        x[0] = start
        for row, place in zip(x[1:], self.places.values(), strict=True):
            row[list(place.states)] = 1.0
        runner, solver = self.runner.with_parameters(given), {**self.solver, **solver}
        solution, why = run_compared(
            runner, x.ravel(), self.times, inputs=self.inputs, **solver
        )
        if why:
            raise SimulationError(f"{self.name}: its derivative is not known: {why}")
        every = runner.signals(solution, self.inputs)
        every = every.reshape(len(every), len(x), -1).transpose(0, 2, 1)
        u = np.zeros((len(every), self.wiring.ninputs, every.shape[2]))
        u[..., 0] = self.inputs.along(solution.t).T
        rows = np.concatenate([every, u], axis=1)[self.skipped :]
        outputs = np.array([self.wiring.output_map @ row for row in rows])
        states = solution.x.reshape(len(every), *x.shape).transpose(0, 2, 1)[
            self.skipped :
        ]
        done = replace(solution, t=solution.t[self.skipped :], x=states[..., 0])
        return RunWithDerivatives(done, outputs, states)

    def confirm(self, values: np.ndarray, found: RunWithDerivatives) -> None:
        """Refuse derivatives that differences of runs do not confirm, where a function may jump."""
        solver = {} if self.wiring.dt else EXACT
        for j, (name, value) in enumerate(zip(self.places, values, strict=True)):
            size = abs(value) or 1.0
            if not self.doubtful or np.isinf(size):  # which has nothing beside it
                continue
            along, way = (
                found.every[..., 1 + j] * size,
                size * (np.arange(len(values)) == j),
            )
            wrong, before = (
                np.ones(along.shape, dtype=bool),
                np.full(along.shape, np.inf),
            )
            for h in STEPS:
                more, less = (
                    self.run(values + s * way, **solver).every[..., 0] for s in (h, -h)
                )
                n = min(len(more), len(less), len(along))
                off = np.abs((more[:n] - less[:n]) / (2.0 * h) - along[:n])
                # what is left may be of rounding where it is less than that of the ones before
                rounding = 10 * EXACT["rtol"] / h * np.abs(more).max(axis=0)
                near = CLOSE * np.abs(along).max(axis=0) + rounding * (
                    off <= 0.2 * before[:n]
                )
                wrong, before = wrong[:n] & (off > near), off
                if not wrong.any():
                    break
            else:
                worst = [*self.labels, *self.states][int(np.argmax(wrong.any(axis=0)))]
                raise SimulationError(
                    f"{worst}: differences of runs do not confirm its derivative by {name}, for a "
                    "function jumps where the run crosses something that moves with it (look in "
                    f"{', '.join(self.doubtful)}); make the jump steep but smooth, such as np.tanh"
                )


@public
def sensitivity(
    system: Scenario | control.InputOutputSystem,
    timepts: Sequence[float] | np.ndarray,
    of: str | Sequence[str] | None = None,
    to: str | Sequence[str] = START,
    inputs: Any = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
    *,
    rtol: float | None = None,
    atol: float | None = None,
    method: str | None = None,
    progress: Callable[[float], None] | None = None,
) -> "xarray.Dataset":
    """Differentiate a run by parameters and by its start.

    Parameters
    ----------
    system : Scenario or control.InputOutputSystem
        A scenario, a diagram, a block or a system of python-control, of continuous or discrete
        time.
    timepts : array_like
        Times of the samples, increasing.
    of : str or sequence of str, optional
        Output ports, ``"e"``; ``"states"`` are all states. All without.
    to : str or sequence of str, optional
        Parameters by their call-time names, ``"adaptation.gain"``, of an array all elements or
        one, ``"plant.A[0,1]"``; states of the start by their labels, or ``"x0"`` for all.
    inputs, initial_state, params, rtol, atol, method, progress
        As `simulate` takes them; inputs are samples or numbers.

    Returns
    -------
    xarray.Dataset
        A variable for each port, with a last dimension ``parameter``: its derivative by each, in
        the port's unit over the parameter's.

    Raises
    ------
    SimulationError
        If a name is unknown, a derivative is not known, or the run cannot go on. Where a function
        may jump, two to six more runs by each parameter confirm the derivative, or it is refused.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> decay = control.nlsys(lambda t, x, u, p: [-p["k"] * x[0]], name="decay",
    ...                       inputs=0, states=["y"], outputs=["y"], params={"k": 2.0})
    >>> found = clpt.sensitivity(decay, [0.0, 0.5, 1.0], to=["k", "x0"], initial_state=[3.0])
    >>> found.y.sel(parameter="k").values[1:].round(6)  # -t x0 exp(-k t)
    array([-0.551819, -0.406006])
    """
    solver = {"rtol": rtol, "atol": atol, "method": method, "progress": progress}
    ready = Sensitive(system, timepts, to, inputs, initial_state, params, **solver)
    found = ready.run(ready.values)
    ready.confirm(ready.values, found)
    return dataset_of(ready, found, of)


def dataset_of(
    ready: Sensitive, found: RunWithDerivatives, of: str | Sequence[str] | None
) -> "xarray.Dataset":
    """Return the derivatives of ports, signals and states as a Dataset."""
    import xarray

    frame = diagram_frame(
        ready.name, *map(tuple, (ready.labels, ready.units, ready.states))
    )
    each = [
        frame.filled(
            replace(found.solution, x=found.states[..., j]), found.outputs[..., j]
        )
        for j in range(1, 1 + len(ready.places))
    ]
    if "parameter" in each[0].variables:
        raise SimulationError(
            "parameter: is a dimension of the result; rename it in the system"
        )
    names = xarray.Variable("parameter", [*ready.places])
    data = xarray.concat(each, names, combine_attrs="override").transpose(
        ..., "parameter"
    )
    data.attrs["title"] = f"Sensitivities of {ready.name}"
    for name, one in data.data_vars.items():
        one.attrs["long_name"] = f"derivative of {name} by each parameter"
        if unit := one.attrs.get("units"):
            one.attrs["units"] = f"{unit} per unit of the parameter"
    if of is None:
        return data
    wanted = [of] if isinstance(of, str) else [*of]
    if unknown := [name for name in wanted if name not in data.data_vars]:
        known = ", ".join(map(str, data.data_vars))
        raise SimulationError(f"of = {unknown[0]!r}: must be among {known}")
    return data[wanted]
