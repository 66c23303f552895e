"""The members of any diagram: what may vary in it, how it runs, its summaries.

    plant.m, m              a parameter, as python-control's `params` call it, or of one block
    plant.A[0,1]            one of its elements, counted from 0
    plant_x[0], plant_x     an initial state by its label, or all of one name
    r                       an input: it is held at its value, in place of `inputs`

The summaries of an output are its final value, its root mean square over time (trapezoids between
the samples; in discrete time the samples' mean) and its largest magnitude.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from ..base.errors import DiagramError, ScenarioError
from ..engine.codegen.directional_derivatives import (
    Place,
    place_of,
    places_of,
    put,
    value_at,
)
from ..engine.diagram.interconnection import changed_parameters
from ..engine.diagram.wiring import read_anew, units_of, wiring_of
from ..engine.model.ports import ports_of
from ..engine.model.system import System
from ..engine.solver.runner import RunOptions
from ..engine.solver.schedule import Inputs, read_inputs
from ..engine.solver.solver_layout import Status
from ..engine.trace.arrays import Unread
from ..simulation.dataset_template import Axes, Series, port_variables
from ..simulation.diagram_runs import labels_of, signal_units
from ..simulation.initial_states import stacked_state
from ..simulation.integrate import request_of
from .drawn_values import Vary, what_may_vary
from .members import Ensemble, Member, Members, States, Values, hash_of
from .summaries import Arrays, ends_of

RESULT = "time", "member", "status", "end"  # names of a result, beside those of ports
SUMMARIES = {
    "final": "at the end",
    "rms": "root mean square",
    "max": "largest magnitude",
}


class VariedDiagram:
    """A diagram as it was read, how it is run, and what varies in it."""

    needs_signals = True  # for its summaries, member by member
    encoding: Mapping[str, Any] = {}  # of the dataset

    def __init__(
        self,
        diagram: Any,
        varies: Sequence[Vary],
        timepts: Any,
        inputs: Any = None,
        initial_state: Any = None,
        params: Mapping[str, Any] | None = None,
        trajectories: bool = False,
        **solver: Any,
    ):
        request = request_of(diagram, timepts, inputs, initial_state, **solver)
        diagram, self.state_times, self.skipped, inputs, x0, solver = request
        self.times, self.name = self.state_times[self.skipped :], diagram.name
        self.title, self.trajectories = f"Ensemble of {diagram.name}", trajectories
        read_anew(diagram)
        sizes = request.sizes()
        self.params = dict(params or {})
        self.wiring = wiring_of(diagram, self.params, sizes)
        self.outputs, taken, states = labels_of(diagram, self.wiring)
        labels = {name for own in (taken, states) for name in (*own, *ports_of(own))}
        for node in self.wiring.nodes:
            labels |= {
                f"{node.name}.{field}" for field in node.system.parameters._fields
            }
        if undeclared := self._undeclared(varies, labels):
            self.params |= undeclared
            self.wiring = wiring_of(diagram, self.params, sizes)
        self.given = changed_parameters(self.wiring.blocks, self.params)
        options = RunOptions.checked(self.wiring.dt, self.state_times, **solver)
        self.options = {
            "rtol": options.rtol,
            "atol": options.atol,
            "method": options.method,
        }
        self.inputs: Inputs = read_inputs(inputs, self.state_times, self.wiring.ninputs)
        self.start = stacked_state("initial_state", x0, len(states))
        self.names = places_of(self.wiring, self.given, states, taken)
        self.places: dict[str, Place] = {}
        self.values: Values = {}
        for one in varies:
            place = place_of(one.key, self.names, self.given)
            if place is not None:
                self.places[one.key], self.values[one.key] = place, self._value(place)
        self._check_apart()

    def _undeclared(
        self, varies: Sequence[Vary], known: Collection[str]
    ) -> dict[str, Any]:
        """Return parameters of python-control's systems that vary, but are no floats.

        One with a known name, of a state, an input or a block's own parameter, counts if a
        function is known to read it.
        """

        def asked(s: System, key: str) -> bool:
            return key not in s.params and (
                key in s.names if key in known else s.mentions(key)
            )

        params: dict[str, Any] = {}
        systems = [
            node.system for node in self.wiring.nodes if isinstance(node.system, System)
        ]
        for one in varies:
            key = one.key.partition("[")[0]
            own = (s.params.get(key) for s in systems if key not in s.number_names)
            lists = [
                np.asarray(v, float)
                for v in own
                if isinstance(v, list | tuple | np.ndarray)
            ]
            if not all(np.array_equal(lists[0], other) for other in lists):
                raise ScenarioError(
                    f"vary: {key} is a list in several systems, not the same; give arrays of "
                    "floats, and name one of a block"
                )
            if lists:
                params[key] = lists[0]
            elif key == one.key and any(asked(s, key) for s in systems):
                first = one.numbers[0] if one.kind == "levels" else 1.0
                params[key] = np.asarray(first, dtype=float)[()]
        return params

    def _value(self, place: Place) -> np.ndarray:
        if not place.inputs:
            return value_at(place, self.given, self.start)
        u = self.inputs.at(float(self.state_times[0]))[list(place.inputs)]
        return u if len(u) > 1 else u[0]

    # --- what may vary --------------------------------------------------------------------

    def why_not(self, key: str) -> str:
        """Return why a name cannot vary."""
        whole = key.partition("[")[0]
        if whole in self.names:
            return (
                f"vary: {key} is no element of {whole}, counted from 0; or {whole} is more than "
                "one of a parameter, an initial state and an input: name one of a block"
            )
        return what_may_vary(key, self.names)

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that is not finite."""
        if not np.isfinite(value).all():
            raise ScenarioError(f"{key} = {value}: must be finite")

    def units(self, key: str) -> dict[str, str]:
        """Return the unit of an input or a state as an attribute, where it is known."""
        place, of_inputs = self.places[key], units_of(self.wiring)[1]
        of_states: list[str] = []
        for block in (node.system for node in self.wiring.nodes):
            for port, size in block.state_ports.items():
                of_states += [block.units.get(port, "")] * size
        units = {of_states[k] for k in place.states} | {
            of_inputs[k] for k in place.inputs
        }
        return {"units": units.pop()} if len(units) == 1 and units != {""} else {}

    def _check_apart(self) -> None:
        """Refuse two names of one number."""
        names: dict[tuple, str] = {}
        for key, (fields, states, inputs, element) in self.places.items():
            numbers: list[tuple] = [("state", k) for k in states]
            numbers += [("input", k) for k in inputs]
            for k, name in fields:
                shape = np.shape(getattr(self.given[k], name))
                every = np.arange(np.prod(shape, dtype=int)).reshape(shape)
                numbers += [(k, name, one) for one in np.ravel(every[element]).tolist()]
            for number in numbers:
                if (other := names.setdefault(number, key)) != key:
                    raise ScenarioError(
                        f"vary: {key} and {other} are one number; name it once"
                    )

    def arguments(self, path: Any) -> dict[str, Any]:
        """Return what identifies it, for a store at a path."""
        return {"diagram": self.name if path is None else self.identity}

    @property
    def identity(self) -> str:
        """A hash of all that makes the numbers, but for what varies."""
        arrays = self.start, self.state_times, self.times, *self.inputs.samples
        try:
            found = hash_of(
                self.wiring, self.given, self.outputs, self.options, *arrays
            )
        except Unread as error:
            raise DiagramError(
                f"out: {error}, so a folder cannot tell the diagram from others; give no out= "
                "and save the result"
            ) from None
        return f"{self.name} {found}"

    # --- its members ----------------------------------------------------------------------

    def place(self, key: str) -> Place:
        """Return where the value of a key that varies lies."""
        return self.places[key]

    def one_by_one(self, key: str) -> bool:
        """Return whether members are made one by one of a key's values, as where jumps move."""
        place = self.places[key]
        varied = [self.wiring.nodes[k].system for k, _ in place.fields]
        return bool(place.inputs) or any(one.breakpoints_function for one in varied)

    def member(self, values: Values) -> Member:
        """Return one member with some values of its own."""
        given, start, inputs = list(self.given), self.start.copy(), self.inputs
        for key, value in values.items():
            place = self.places[key]
            put(place, value, given, start)
            if place.inputs:
                at, u = inputs.samples
                u = u.copy()
                u[list(place.inputs)] = np.reshape(value, (-1, 1))
                inputs = replace(inputs, samples=(at, u))
        return given, start, inputs

    @cached_property
    def variables(self) -> tuple[dict[str, Series], Axes]:
        """The variables of outputs, and their axes."""
        units, ports = signal_units(self.wiring), ports_of(self.outputs)
        return port_variables(
            ports, {}, (), {port: units[own[0]] for port, own in ports.items()}
        )

    def along(self, port: str) -> str:
        """Return the name of a port over time; one that is taken gets a _."""
        return f"{port}_" if port in (*RESULT, *self.values) else port

    def arrays(self, values: Values) -> Arrays:
        """Return all arrays of the store, for the values of all members."""
        ports, axes = self.variables
        sizes = {dim: len(numbers) for dim, (numbers, _) in axes.items()}
        sizes["time"] = len(self.times)
        arrays = Arrays(values, sizes)
        for port, one in ports.items():
            for what, words in SUMMARIES.items():
                arrays.add(
                    f"{port}_{what}", one.dims[1:], f"{port}, {words}", **one.attributes
                )
            if self.trajectories:
                arrays.add(self.along(port), one.dims, port, **one.attributes)
        arrays.add_members()
        for key, array in values.items():
            more = [f"{key} {k}" for k in range(array.ndim - 1)]
            arrays.add_fixed(
                key, ("member", *more), array, long_name=key, **self.units(key)
            )
        for dim, (numbers, attributes) in axes.items():
            arrays.add_fixed(dim, (dim,), numbers, **attributes)
        if self.trajectories:
            arrays.add_fixed("time", ("time",), self.times, long_name="time")
        return arrays

    def summarise(
        self, ensemble: Ensemble, members: Members, values: Values, run: States
    ) -> Values:
        """Return the summaries of members."""
        y = np.full((len(run.status), len(self.outputs), len(self.state_times)), np.nan)
        ports = self.variables[0]
        for m, rows in enumerate(y):
            signals = ensemble.signals(members, run, m).T
            reached, (_, inputs) = signals.shape[1], members.runners[m]
            u = inputs.along(self.state_times[:reached])
            rows[:, :reached] = 0.0
            for row, sources in zip(
                rows[:, :reached], self.wiring.outputs, strict=True
            ):
                for (
                    k,
                    gain,
                ) in sources.items():  # one after the other, however many there are
                    row += gain * (signals[k] if k >= 0 else u[~k])
        not_finite = (run.status == Status.FINISHED) & ~np.isfinite(y).all(axis=(1, 2))
        run = replace(run, status=np.where(not_finite, Status.NOT_FINITE, run.status))
        y = y[..., self.skipped :]
        # each row is summed by itself, so that no bit depends on the others
        rms = np.sqrt(np.sum(self._weights * y**2, axis=-1))
        figures = dict(
            zip(SUMMARIES, (y[..., -1], rms, np.abs(y).max(axis=-1)), strict=True)
        )
        summaries = {
            f"{port}_{what}": one.of(figure)
            for port, one in ports.items()
            for what, figure in figures.items()
        }
        for port, one in ports.items() if self.trajectories else ():
            along = one.of(y)
            along = np.moveaxis(along, 1, -1) if along.ndim > 2 else along
            summaries[self.along(port)] = along
        return summaries | ends_of(run, self.state_times)

    @property
    def _weights(self) -> np.ndarray:
        """The weight of each sample in a mean over time: equal, or of trapezoids."""
        count, spans = len(self.times), np.diff(self.times)
        if self.wiring.dt:
            return np.full(count, 1.0 / count)
        return np.convolve(spans, [0.5, 0.5]) / (self.times[-1] - self.times[0])
