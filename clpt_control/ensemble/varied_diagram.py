"""Varied diagrams: parameters that may vary in any diagram, its members, and their summaries.

    plant.m, m              a parameter, by its name in python-control's `params`, or of one block
    plant.A[0,1]            an element of a parameter, counted from 0
    plant_x[0], plant_x     an initial state by its label, or all states of one name
    r                       an input: constant at its value, in place of `inputs`

The summaries of an output are its final value, its root mean square over time (trapezoidal rule;
in discrete time the mean over samples) and its largest absolute value.  Functions of the user give
further ones.  If a guard stops a member, they are those until then.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from copy import copy
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any

import numpy as np

from ..base.arguments import brief, finite
from ..base.errors import ClptError, DiagramError, ScenarioError, SimulationError
from ..engine.codegen.directional_derivatives import (
    Place,
    is_remade,
    place_of,
    places_of,
    put,
    value_at,
    with_values,
)
from ..engine.diagram.block_numbers import PARAMETER_HINTS, Params
from ..engine.diagram.wiring import read_anew, state_units, units_of, wiring_of
from ..engine.model.ports import ports_of
from ..engine.model.system import System
from ..engine.record.unread import Unread, check_call, line_of
from ..engine.solver.solver_layout import Status
from ..simulation.dataset_template import Axes, DatasetTemplate, Series, port_variables
from ..simulation.diagram_runs import labels_of, signal_units
from ..simulation.requests import request_of
from .members import Member, MemberBatch, Values, hash_of
from .results import COMPLETED
from .sampled_parameters import Vary, cannot_vary

RESULT = "time", "member", "status", "end"  # names in a result that are not ports
STATISTICS = {
    "final": "at the end",
    "rms": "root mean square",
    "max": "largest absolute value",
}


@dataclass
class OutputBatch(MemberBatch):
    """Outputs `y` of members that ran, shape (m, outputs, times), and their summaries."""

    def __post_init__(self) -> None:
        varied, status = self.varied, self.run.status
        times, wires = varied.state_times, varied.wiring.outputs
        y = np.full((len(status), len(wires), len(times)), np.nan)
        for rows, signals in self.ensemble.signals(self.members, self.run):
            u = self.members.inputs_along(times, rows)
            y[rows] = np.moveaxis(varied.wiring.outputs_of(signals, u), 1, 2)
        not_finite = (status == Status.FINISHED) & ~np.isfinite(y).all(axis=(1, 2))
        status = np.where(not_finite, Status.NOT_FINITE, status)
        self.y = y[..., varied.skipped :]
        for m in np.flatnonzero(status == Status.GUARD_LEFT).tolist():
            if stop := self._stop(m):
                self.stops[m], status[m] = stop, Status.STOPPED
                # a sample that differs from the stop by rounding is the stop
                times, y = stop
                is_sample = np.isin(times, varied.times)
                self.y[m] = np.nan
                self.y[m][:, np.isin(varied.times, times)] = y[:, is_sample]
        self.run = self.run._replace(status=status)

    def _stop(self, m: int) -> tuple[np.ndarray, np.ndarray] | None:
        """Return times and outputs of a member to its stop, None if its guard is an error."""
        runner, arguments = self.ensemble.single(self.values, m)
        inputs = arguments[2]
        try:
            solution = runner.solve(*arguments)
            signals = runner.signals(solution, inputs)
        except SimulationError:
            return None
        first = min(self.varied.skipped, len(signals) - 1)
        y = self.varied.wiring.outputs_of(signals, inputs.along(solution.t).T)
        return solution.t[first:], y[first:].T

    @cached_property
    def statistics(self) -> Values:
        """Each statistic of all outputs, (m, outputs)."""
        found = self._statistics(self.varied.times, self.y)
        for m, stop in self.stops.items():
            for name, values in self._statistics(*stop).items():
                found[name][m] = values
        return found

    def _statistics(self, times: np.ndarray, y: np.ndarray) -> Values:
        """Return each statistic of outputs, times last."""
        if self.varied.wiring.dt or len(times) == 1:
            weights = np.full(len(times), 1.0 / len(times))
        else:  # of the trapezoidal rule
            weights = np.convolve(np.diff(times), [0.5, 0.5]) / (times[-1] - times[0])
        # each row is summed by itself, so that no bit depends on the others
        rms = np.sqrt(np.sum(weights * y**2, axis=-1))
        largest = np.abs(y).max(axis=-1)
        return {"final": y[..., -1].copy(), "rms": rms, "max": largest}

    def statistic(self, name: str, of: Callable) -> np.ndarray:
        """Return a statistic of a port."""
        return of(self.statistics[name])

    def trajectory(self, of: Callable) -> np.ndarray:
        """Return a port over time, time second."""
        trajectory = of(self.y)
        return trajectory if trajectory.ndim == 2 else np.moveaxis(trajectory, 1, -1)

    def user_summary(self, name: str, user: Callable) -> np.ndarray:
        """Return the user's number of each member; NaN if the member failed."""
        variables, axes = self.varied.ports
        template = DatasetTemplate(variables, axes, {})
        numbers = np.full(len(self.y), np.nan)
        for m in np.flatnonzero(np.isin(self.run.status, COMPLETED)).tolist():
            times, y = self.stops.get(m, (self.varied.times, self.y[m]))
            try:
                value = user(template.dataset(times, y.T))
            except Exception as error:
                raise ScenarioError(
                    f"summary: {name}: {line_of(user, error)}"
                ) from error
            try:
                numbers[m] = float(value)
            except (TypeError, ValueError):
                raise ScenarioError(
                    f"summary: {name} returned {brief(value)}. Return one number"
                ) from None
        return numbers


class VariedDiagram:
    """A wired diagram, the options of its runs, and the locations of its sampled parameters."""

    needs_signals = True  # summaries need the signals of each member
    encoding: Mapping[str, Any] = {}  # of the dataset

    def __init__(
        self,
        diagram: Any,
        varies: Sequence[Vary],
        timepts: Any,
        inputs: Any = None,
        initial_state: Any = None,
        params: Params = None,
        trajectories: bool = False,
        summary: Mapping[str, Callable] | None = None,
        **solver: Any,
    ):
        request = request_of(diagram, timepts, inputs, initial_state, **solver)
        diagram = request.diagram
        self.state_times, self.skipped = request.times, request.skipped
        self.inputs, self.start = request.inputs, request.start
        self.times = self.state_times[self.skipped :]
        self.name = diagram.name
        self.title = f"Ensemble of {diagram.name}"
        self.trajectories = trajectories
        self.summary = dict(summary or {})
        for name, user in self.summary.items():
            needs = "must be a function of one run, as lambda run: run.y.max()"
            check_call(user, ScenarioError, 1, f"summary: {name}: {needs}")
        # 1. the diagram, with parameters that its systems do not declare
        read_anew(diagram)
        sizes = request.sizes
        self.params = dict(params or {})
        with request.drawn_around():
            self.wiring = wiring_of(diagram, self.params, sizes, complete=False)
        self.outputs, input_labels, states = labels_of(diagram, self.wiring)
        if undeclared := self._undeclared(varies, [input_labels, states]):
            self.params |= undeclared
            self.wiring = wiring_of(diagram, self.params, sizes, complete=False)
        self.parameters = self.wiring.parameters()
        # 2. the run
        self.options = {
            name: getattr(request.options, name) for name in ("rtol", "atol", "method")
        }
        # 3. locations and values of the sampled parameters
        self.names = places_of(self.wiring, self.parameters, states, input_labels)
        self.locations: dict[str, Place] = {}
        self.values: Values = {}
        for item in varies:
            location = place_of(item.key, self.names, self.parameters)
            if location is not None:
                self.locations[item.key] = location
                self.values[item.key] = self._value(location)
        self._check_distinct()

    def _undeclared(
        self, varies: Sequence[Vary], label_lists: Iterable[Sequence[str]]
    ) -> dict[str, Any]:
        """Return parameters of python-control's systems that vary but are not floats.

        A parameter with the name of a state, an input or a block's parameter is returned only if a
        function reads it.
        """
        labels = {name for names in label_lists for name in (*names, *ports_of(names))}
        for node in self.wiring.nodes:
            labels |= {
                f"{node.name}.{field}" for field in node.system.parameters._fields
            }

        def is_read(s: System, key: str) -> bool:
            return key not in s.params and (
                key in s.names if key in labels else s.mentions(key)
            )

        params = {}
        systems = [
            node.system for node in self.wiring.nodes if isinstance(node.system, System)
        ]
        for item in varies:
            key = item.key.partition("[")[0]
            candidates = (s.params.get(key) for s in systems if key not in s.parameters)
            lists = [
                np.asarray(v, float)
                for v in candidates
                if isinstance(v, list | tuple | np.ndarray)
            ]
            if not all(np.array_equal(lists[0], array) for array in lists):
                raise ScenarioError(
                    f"vary: {key} is a list in several systems, not the same. Give arrays of "
                    "floats, and name one of a block"
                )
            if lists:
                params[key] = lists[0]
            elif key == item.key and any(is_read(s, key) for s in systems):
                value = item.numbers[0] if item.kind == "levels" else 1.0
                params[key] = np.asarray(value, dtype=float)[()]
        return params

    def _value(self, location: Place) -> np.ndarray:
        if not location.inputs:
            return value_at(location, self.parameters, self.start)
        u = self.inputs.at(float(self.state_times[0]))[list(location.inputs)]
        return u if len(u) > 1 else u[0]

    # --- checks ---------------------------------------------------------------------------

    def why_not(self, key: str) -> str:
        """Return the reason for which a name cannot vary."""
        name = key.partition("[")[0]
        if name in self.names:
            return (
                f"vary: {key} is not an element of {name}, counted from 0; or {name} is more than "
                "one of a parameter, an initial state and an input: name one of a block"
            )
        hints = (hint_of(key, {*self.names}) for hint_of in PARAMETER_HINTS)
        for hint in filter(None, hints):
            return f"vary: {hint}"
        return cannot_vary(key, self.names)

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that is not finite; a parameter may be an infinite limit."""
        if not self.locations[key].fields:
            finite(key, value)

    def check_blocks(self, values: Values) -> None:
        """Refuse members with parameters that the rules of their blocks do not allow."""
        varied = {k for key in values for k, _ in self.locations[key].fields}
        ruled = [k for k in varied if self.wiring.nodes[k].system.rules]
        for m in range(len(next(iter(values.values()))) if ruled else 1):
            try:
                self.member({key: column[m] for key, column in values.items()})
            except ClptError as error:
                raise ScenarioError(f"vary: member {m}: {error}") from None

    def units(self, key: str) -> dict[str, str]:
        """Return the unit of an input, a state or a parameter as an attribute, if known."""
        location = self.locations[key]
        nodes = self.wiring.nodes
        units = {state_units(self.wiring)[k] for k in location.states}
        units |= {units_of(self.wiring)[1][k] for k in location.inputs}
        units |= {nodes[k].system.units.get(name, "") for k, name in location.fields}
        return {"units": units.pop()} if len(units) == 1 and units != {""} else {}

    def _check_distinct(self) -> None:
        """Refuse two names of one number."""
        names: dict[tuple, str] = {}
        for key, location in self.locations.items():
            numbers: list[tuple] = [("state", k) for k in location.states]
            numbers += [("input", k) for k in location.inputs]
            numbers += location.elements(self.parameters)
            for number in numbers:
                if (owner := names.setdefault(number, key)) != key:
                    raise ScenarioError(
                        f"vary: {key} and {owner} are the same number. Name it once"
                    )

    def arguments(self, path: Any) -> dict[str, Any]:
        """Return the arguments that identify the diagram in a store at a path.

        They have a hash of all that determines the numbers, but the sampled parameters.
        """
        if path is None:
            return {"diagram": self.name}
        arrays = self.start, self.state_times, self.times, *self.inputs.samples
        try:
            digest = hash_of(
                self.wiring, self.parameters, self.outputs, self.options, *arrays
            )
        except Unread as error:
            raise DiagramError(
                f"out: {error}, so a folder cannot identify the diagram. Leave out out= "
                "and save the result"
            ) from None
        return {"diagram": f"{self.name} {digest}"}

    # --- members --------------------------------------------------------------------------

    def location(self, key: str) -> Place:
        """Return the location of the value of a key."""
        return self.locations[key]

    def one_by_one(self, key: str) -> bool:
        """Return True if members with values of a key are made one by one: jumps may move."""
        location = self.locations[key]
        systems = (self.wiring.nodes[k].system for k, _ in location.fields)
        return bool(location.inputs) or any(s.breakpoints_function for s in systems)

    def remade(self, keys: Sequence[str]) -> list[str]:
        """Return the keys of values that functions read as numbers, such as modes and counts."""
        with suppress(Unread):
            return [
                key
                for key in keys
                if is_remade(self.wiring, self.locations[key].fields)
            ]
        return []

    def made_with(self, values: Values) -> "VariedDiagram":
        """Return the diagram whose blocks are made anew with values that functions read."""
        made = copy(self)
        made.parameters = list(self.parameters)
        nodes = list(self.wiring.nodes)
        for key, value in values.items():
            put(self.locations[key], value, made.parameters, self.start)
            for k, name in self.locations[key].fields:
                number = {name: getattr(made.parameters[k], name)}
                system = nodes[k].system.having(number, complete=False)
                nodes[k] = replace(nodes[k], system=system)
        made.wiring = replace(self.wiring, nodes=tuple(nodes))
        return made

    def member(self, values: Values) -> Member:
        """Return the member with these values."""
        at = [(self.locations[key], value) for key, value in values.items()]
        parameters, start = with_values(self.wiring, self.parameters, self.start, at)
        inputs = self.inputs
        for location, value in at:
            if location.inputs:
                times, u = inputs.samples
                u = u.copy()
                u[list(location.inputs)] = np.reshape(value, (-1, 1))
                inputs = replace(inputs, samples=(times, u))
        return parameters, start, inputs

    # --- summaries ------------------------------------------------------------------------

    batch = OutputBatch

    @cached_property
    def ports(self) -> tuple[dict[str, Series], Axes]:
        """The variables of outputs, and their axes."""
        units, ports = signal_units(self.wiring), ports_of(self.outputs)
        units_by_port = {port: units[columns[0]] for port, columns in ports.items()}
        return port_variables(ports, {}, (), units_by_port)

    @property
    def axes(self) -> Axes:
        """Values and attributes of the dimensions of summaries."""
        return {**self.ports[1], "time": (self.times, {"long_name": "time"})}

    @cached_property
    def summaries(self) -> list[tuple[str, Series]]:
        """The names and series of summaries, functions of an `OutputBatch`."""
        summaries = []
        for port, (dims, of, units) in self.ports[0].items():
            for statistic, words in STATISTICS.items():
                attributes = {"long_name": f"{port}, {words}", **units}
                function = partial(OutputBatch.statistic, name=statistic, of=of)
                series = Series(dims[1:], function, attributes)
                summaries.append((f"{port}_{statistic}", series))
            if self.trajectories:
                # a name that is in use gets the suffix _
                name = f"{port}_" if port in (*RESULT, *self.values) else port
                function = partial(OutputBatch.trajectory, of=of)
                series = Series(dims, function, {"long_name": port, **units})
                summaries.append((name, series))
        for name, user in self.summary.items():
            attributes = {"long_name": f"{name}, summary of the user"}
            function = partial(OutputBatch.user_summary, name=name, user=user)
            summaries.append((name, Series((), function, attributes)))
        return summaries

    def key_layout(self, key: str, ndim: int) -> tuple[list[str], dict[str, str]]:
        """Return dimensions and attributes of the values of a key."""
        dims = [f"{key} {k}" for k in range(ndim)]
        return dims, {"long_name": key, **self.units(key)}
