"""The members of any diagram: what may vary in it, how it runs, what is kept.

    plant.m, m              a parameter, as python-control's `params` call it, or of one block
    plant.A[0,1]            one of its elements, counted from 0
    plant_x[0], plant_x     an initial state by its label, or all of one name
    r                       an input: it is held at its value, in place of what `inputs` gives

Of each output are kept its final value, its root mean square over time (trapezoids between the
samples; of discrete time the samples' mean) and its largest magnitude.
"""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any

import numpy as np

from ..arguments import nearest
from ..diagrams.interconnection import changed_parameters
from ..diagrams.varied import Place, place_of, places_of, put, value_at
from ..diagrams.wiring import read_anew, units_of, wiring_of
from ..equations.arrays import Unread
from ..equations.at_many import decided_by_time
from ..equations.declaration import ports_of
from ..equations.system import System
from ..errors import DiagramError, ScenarioError, SimulationError
from ..native import solver
from ..native.ending import check_spacing, checked_method
from ..native.python_diagram import checked_steps
from ..native.schedule import checked_times, read_inputs, sizes_of_run, stacked_state
from ..native.sweep import Sweep
from ..simulation.dataset import Part, ports_shown
from ..simulation.integrate import as_diagram
from ..simulation.running import labels_of, units_shown
from .drawn_values import Vary, unknown
from .members import Ensemble, Made, Members, States, Values
from .summaries import Arrays, ends_of

KEPT = {"final": "at the end", "rms": "root mean square", "max": "largest magnitude"}


class VariedDiagram:
    """A diagram as it was read, what it is run with, and what varies in it."""

    asks = True
    encoding: Mapping[str, Any] = {}

    def __init__(
        self,
        diagram: Any,
        varies: Sequence[Vary],
        timepts: Any,
        inputs: Any = None,
        initial_state: Any = None,
        params: Mapping[str, Any] | None = None,
        rtol: float | None = None,
        atol: float | None = None,
        method: str | None = None,
        trajectories: bool = False,
    ):
        diagram, known = as_diagram(diagram)
        self.times, self.name = checked_times("timepts", timepts), diagram.name
        self.title, self.trajectories = f"Ensemble of {diagram.name}", trajectories
        x0 = known.get("initial_state") if initial_state is None else initial_state
        inputs = known.get("inputs") if inputs is None else inputs
        read_anew(diagram)
        sizes = sizes_of_run(diagram, inputs, x0, self.times)
        self.params = dict(params or {})
        self.wiring = wiring_of(diagram, self.params, sizes)
        if asked := self._undeclared(varies):
            self.params |= asked
            self.wiring = wiring_of(diagram, self.params, sizes)
        self.given = changed_parameters(self.wiring, self.params)
        rtol_, atol_, *_ = checked_steps(None, rtol=rtol, atol=atol)
        self.how = {"rtol": rtol_, "atol": atol_, "method": checked_method(method)}
        self.every = Sweep(self.wiring, self.given).at_jumps(self.times)
        if self.wiring.dt:
            check_spacing(self.times, self.wiring.dt)
            if not rtol is atol is method is None:
                raise SimulationError(
                    "method, rtol and atol: a diagram of discrete time has none; leave them out"
                )
        self.outputs, taken, states = labels_of(diagram, self.wiring)
        self.inputs = read_inputs(inputs, self.times, self.wiring.ninputs)
        self.start = stacked_state("initial_state", 0.0 if x0 is None else x0, len(states))
        self.names = places_of(self.wiring, self.given, states, taken)
        self.places: dict[str, Place] = {}
        self.values: dict[str, np.ndarray] = {}
        for one in varies:
            place = place_of(one.key, self.names, self.given)
            if place is not None:
                self.places[one.key], self.values[one.key] = place, self._value(place)
        if self.inputs.samples is None and any(place.inputs for place in self.places.values()):
            raise ScenarioError("vary: an input cannot vary where inputs are a function")
        self._check_apart()

    def _undeclared(self, varies: Sequence[Vary]) -> dict[str, Any]:
        """Return params to run with, of python-control's systems, that vary and are no floats."""
        found: dict[str, Any] = {}
        systems = [node.system for node in self.wiring.nodes if isinstance(node.system, System)]
        for one in varies:
            key = one.key.partition("[")[0]
            given = [system.params.get(key) for system in systems if key not in system.number_names]
            lists = [
                np.asarray(v, float) for v in given if isinstance(v, list | tuple | np.ndarray)
            ]
            if not all(np.array_equal(lists[0], other) for other in lists):
                raise ScenarioError(
                    f"vary: {key} is a list in several systems, not the same; give arrays of "
                    "floats, and name one of a block"
                )
            if lists:
                found[key] = lists[0]
            elif key == one.key and any(key not in s.params and s.mentions(key) for s in systems):
                first = one.numbers[0] if one.kind == "levels" else 1.0
                found[key] = np.asarray(first, dtype=float)[()]
        return found

    def _value(self, place: Place) -> np.ndarray:
        if not place.inputs:
            return value_at(place, self.given, self.start)
        u = self.inputs.at(float(self.times[0]))[list(place.inputs)]
        return u if len(u) > 1 else u[0]

    # --- as what may vary -----------------------------------------------------------------

    def why_not(self, key: str) -> str:
        """Return why a name cannot vary."""
        block, _, name = key.rpartition(".")
        if len(self.names.get(key, ())) > 1:
            return (
                f"vary: {key} is more than one of a parameter, an initial state and an input, or "
                "parameters of several shapes; rename one, or name one of a block"
            )
        whole = key.partition("[")[0]
        if whole in self.names:
            shape = np.shape(self._value(self.names[whole][0]))
            return f"vary: {key} is no element: {whole} has shape {shape}, counted from 0"
        for node, given in zip(self.wiring.nodes, self.given, strict=True):
            if node.name == block and isinstance(getattr(given, name, None), int):
                return (
                    f"vary: {key} = {getattr(given, name)} cannot vary: a whole number is fixed "
                    "when its block is made; declare it as a float, or make a diagram of each"
                )
        return unknown(f"name {key}", nearest(key, self.names), self.names)

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that is not finite."""
        if not np.isfinite(value).all():
            raise ScenarioError(f"{key} = {value}: must be finite")

    def units(self, key: str) -> dict[str, str]:
        """Return the unit of an input or a state, as an attribute, where it is known."""
        place, of_inputs = self.places[key], units_of(self.wiring)[1]
        of_states = [
            block.units.get(port, "")
            for block in (node.system for node in self.wiring.nodes)
            for port, size in block.state_ports.items()
            for _ in range(size)
        ]
        found = {of_states[k] for k in place.states} | {of_inputs[k] for k in place.inputs}
        return {"units": found.pop()} if len(found) == 1 and found != {""} else {}

    def _check_apart(self) -> None:
        """Refuse names that say one number twice."""
        said: dict[tuple, str] = {}
        for key, (fields, states, inputs, element) in self.places.items():
            numbers: list[tuple] = [("state", k) for k in states]
            numbers += [("input", k) for k in inputs]
            for k, name in fields:
                every = np.arange(np.size(getattr(self.given[k], name)))
                every = every.reshape(np.shape(getattr(self.given[k], name)))
                numbers += [(k, name, one) for one in np.ravel(every[element]).tolist()]
            for number in numbers:
                if (other := said.setdefault(number, key)) != key:
                    raise ScenarioError(f"vary: {key} and {other} are one number; name it once")

    def asked(self, path: Any) -> dict[str, Any]:
        """Return what it is, for a store that lies there."""
        return {"diagram": self.name if path is None else self.identity}

    @property
    def identity(self) -> str:
        """A short name of all that makes the numbers, but for what varies."""
        try:
            made: list[Any] = [node.system.records for node in self.wiring.nodes]
        except Unread as error:
            raise DiagramError(
                f"out: {error}, so a folder cannot tell the diagram from others; leave out= away "
                "and save the result"
            ) from None
        if self.inputs.samples is None:
            raise DiagramError("out: inputs by a function cannot be told from others; give samples")
        made += [(node.name, node.wires) for node in self.wiring.nodes]
        made += [self.wiring.outputs, self.wiring.dt, self.outputs, self.how]
        arrays = [self.start, self.times, *self.inputs.samples]
        arrays += [number for given in self.given for number in given]
        made += [np.asarray(one, dtype=float).tolist() for one in arrays]
        return f"{self.name} {hashlib.sha256(repr(made).encode()).hexdigest()[:16]}"

    # --- as what is run -------------------------------------------------------------------

    def place(self, key: str) -> Place:
        """Return where the value of a key that varies lies."""
        return self.places[key]

    def computed(self, key: str) -> bool:
        """Return whether members are made one by one of a key's values, as of what moves jumps."""
        place = self.places[key]
        timed = [self.wiring.nodes[k].system for k, _ in place.fields]
        moves = any(one.breakpoints_function or decided_by_time(one) for one in timed)
        return bool(place.inputs) or moves

    def made(self, own: Values) -> Made:
        """Return one member with some values of its own."""
        given, start, inputs = list(self.given), self.start.copy(), self.inputs
        for key, value in own.items():
            place = self.places[key]
            put(place, value, given, start)
            if place.inputs and inputs.samples is not None:
                at, u = inputs.samples
                u = u.copy()
                u[list(place.inputs)] = np.reshape(value, (-1, 1))
                inputs = replace(inputs, samples=(at, u))
        return given, start, inputs

    @cached_property
    def shown(self) -> tuple[dict[str, Part], dict[str, tuple[Any, Mapping[str, str]]]]:
        """The variables of outputs, and their axes."""
        taken = ("time", "member", "status", "end", *self.values)
        units, ports = units_shown(self.wiring), ports_of(self.outputs)
        return ports_shown(ports, {}, taken, {port: units[own[0]] for port, own in ports.items()})

    def arrays(self, values: Values) -> Arrays:
        """Return all arrays of the store, for the values of all members."""
        ports, axes = self.shown
        sizes = {dim: len(numbers) for dim, (numbers, _) in axes.items()}
        found = Arrays(len(next(iter(values.values()))), {"time": len(self.every), **sizes})
        for port, part in ports.items():
            for what, said in KEPT.items():
                found.keep(f"{port}_{what}", part.dims[1:], f"{port}, {said}", **part.attributes)
            if self.trajectories:
                found.keep(port, part.dims, port, **part.attributes)
        found.keep_ends()
        for key, array in values.items():
            more = [f"{key} {k}" for k in range(array.ndim - 1)]
            found.fix(key, ("member", *more), array, long_name=key, **self.units(key))
        found.fix_members()
        for dim, (numbers, attributes) in axes.items():
            found.fix(dim, (dim,), numbers, **attributes)
        if self.trajectories:
            found.fix("time", ("time",), self.every, long_name="time")
        return found

    def kept(
        self, ensemble: Ensemble, members: Members, values: Values, run: States
    ) -> dict[str, np.ndarray]:
        """Return what is kept of members."""
        y = np.full((len(run.status), len(self.outputs), len(self.every)), np.nan)
        ports = self.shown[0]
        for m, own in enumerate(y):
            signals = ensemble.signals(members, run, m, self.every).T
            reached, (_, inputs) = signals.shape[1], ensemble.alone(members, m)
            u = inputs.along(self.every[:reached])
            own[:, :reached] = 0.0
            for row, sources in zip(own[:, :reached], self.wiring.outputs, strict=True):
                for k, gain in sources.items():  # one after the other, however many there are
                    row += gain * (signals[k] if k >= 0 else u[~k])
        unknown = (run.status == solver.FINISHED) & ~np.isfinite(y).all(axis=(1, 2))
        run = replace(run, status=np.where(unknown, solver.NOT_FINITE, run.status))
        # each row is summed by itself: others beside it change no bit
        rms = np.sqrt(np.sum(self._weights * y**2, axis=-1))
        figures = dict(zip(KEPT, (y[..., -1], rms, np.abs(y).max(axis=-1)), strict=True))
        found = {
            f"{port}_{what}": part.of(figure)
            for port, part in ports.items()
            for what, figure in figures.items()
        }
        for port, part in ports.items() if self.trajectories else ():
            along = part.of(y)
            found[port] = np.moveaxis(along, 1, -1) if along.ndim > 2 else along
        return found | ends_of(run, self.every)

    @property
    def _weights(self) -> np.ndarray:
        """What each sample counts in a mean over time: all alike, or by trapezoids."""
        times = self.every
        if self.wiring.dt:
            return np.full(len(times), 1.0 / len(times))
        spans = np.diff(times)
        return (np.append(spans, 0.0) + np.append(0.0, spans)) / (2.0 * (times[-1] - times[0]))
