"""The members of any diagram: what may vary in it, how it runs, what is kept.

    plant.m, m              a parameter, as python-control's `params` call it, or of one block
    plant.A[0,1]            one of its elements, counted from 0
    plant_x[0], plant_x     an initial state by its label, or all of one name
    r                       an input: it is held at its value, in place of what `inputs` gives

Of each output are kept its final value, its root mean square over time (trapezoids between the
samples; of discrete time the samples' mean) and its largest magnitude.
"""

import hashlib
import pickle
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from typing import Any, NamedTuple

import control
import numpy as np

from ..arguments import nearest
from ..diagrams.interconnection import changed_parameters
from ..diagrams.varied import fields_by_name, read_as_number
from ..diagrams.wiring import read_anew, units_of, wiring_of
from ..equations.arrays import Unread
from ..equations.at_many import decided_by_time
from ..equations.declaration import ports_of
from ..equations.linear import linear
from ..equations.system import System
from ..errors import DiagramError, ScenarioError, SimulationError
from ..native import solver
from ..native.engines import chosen, compared, in_python
from ..native.python_diagram import checked_steps
from ..native.schedule import Inputs, checked_times, open_sizes, read_inputs, stacked_state
from ..native.ways import check_spacing, checked_method
from ..simulation.dataset import ports_shown
from ..simulation.diagram_run import labels_of, units_shown
from ..simulation.starts import initial_state
from .members import Ensemble, Made, Members, States
from .summaries import Array, Arrays, ends_of
from .varied_keys import Vary
from .worker import Worker, pickled

TRIED = 5  # members whose records are compared with Python, before any runs
KEPT = {"final": "at the end", "rms": "root mean square", "max": "largest magnitude"}


class Place(NamedTuple):
    """Where a value lies: in fields of blocks, in the initial state, in the inputs."""

    fields: tuple[tuple[int, str], ...] = ()  # (block, field)
    states: tuple[int, ...] = ()
    inputs: tuple[int, ...] = ()
    element: Any = ...  # of a field


class VariedDiagram:
    """A diagram as it was read, what it is run with, and what may vary in it."""

    def __init__(
        self,
        diagram: Any,
        varies: Sequence[Vary],
        timepts: Any,
        inputs: Any = None,
        x0: Any = None,
        params: Mapping[str, Any] | None = None,
        rtol: float | None = None,
        atol: float | None = None,
        method: str | None = None,
    ):
        if isinstance(diagram, control.TransferFunction):
            diagram = linear(diagram)
        self.times, self.name = checked_times("timepts", timepts), diagram.name
        if x0 is None and getattr(diagram, "made_of", None) is not None:
            x0 = initial_state(diagram)
        read_anew(diagram)
        sizes = open_sizes(diagram, inputs, x0, self.times)
        self.params = dict(params or {})
        self.wiring = wiring_of(diagram, self.params, sizes)
        if asked := self._undeclared(varies):
            self.params |= asked
            self.wiring = wiring_of(diagram, self.params, sizes)
        self.given = changed_parameters(self.wiring, self.params)
        rtol_, atol_, *_ = checked_steps(None, rtol=rtol, atol=atol)
        self.how = {"rtol": rtol_, "atol": atol_, "method": checked_method(method)}
        if self.wiring.dt:
            check_spacing(self.times, self.wiring.dt)
            if not rtol is atol is method is None:
                raise SimulationError(
                    "method, rtol and atol: a diagram of discrete time has none; leave them out"
                )
        self.outputs, taken, states = labels_of(diagram, self.wiring)
        self.inputs = read_inputs(inputs, self.times, self.wiring.ninputs)
        self.start = stacked_state("initial_state", 0.0 if x0 is None else x0, len(states))
        self.names = self._names(taken, states)
        self.places: dict[str, Place] = {}
        self.values: dict[str, np.ndarray] = {}
        for one in varies:
            place = self._place(one.key)
            if place is not None:
                self.places[one.key], self.values[one.key] = place, self._value(place)
        if self.inputs.samples is None and any(place.inputs for place in self.places.values()):
            raise ScenarioError("vary: an input cannot vary where inputs are a function")

    def _undeclared(self, varies: Sequence[Vary]) -> dict[str, Any]:
        """Return params to run with, of python-control's systems, that vary and are no floats."""
        found: dict[str, Any] = {}
        systems = [node.system for node in self.wiring.nodes if isinstance(node.system, System)]
        for one in varies:
            key = one.key.partition("[")[0]
            for system in systems:
                if key in system.given:
                    value = system.given[key]
                    listed = isinstance(value, list | tuple | np.ndarray)
                    if listed and key not in system.number_names:
                        number = np.asarray(value, dtype=float)
                        if not np.array_equal(found.setdefault(key, number), number):
                            raise ScenarioError(
                                f"vary: {key} is a list in several systems, not the same; give "
                                "arrays of floats, and name one of a block"
                            )
                elif key == one.key and system.reads(key):
                    first = one.numbers[0] if one.kind == "levels" else 1.0
                    found[key] = np.asarray(first, dtype=float) if np.ndim(first) else float(first)
        return found

    def _names(self, inputs: Sequence[str], states: Sequence[str]) -> dict[str, list[Place]]:
        """Return every name that may vary, with its place; what has two places is ambiguous."""
        found: dict[str, list[Place]] = {}
        for name, fields in fields_by_name(self.wiring).items():
            shapes = [np.shape(getattr(self.given[k], field)) for k, field in fields]
            alike = fields if len(set(shapes)) == 1 else []
            found[name] = [Place(tuple(alike))] if alike else [Place((one,)) for one in fields]
        for kind, labels in (("states", states), ("inputs", inputs)):
            named = {label: [k] for k, label in enumerate(labels)} | ports_of(labels)
            for name, places in named.items():
                place: Any = {kind: tuple(places)}
                found.setdefault(name, []).append(Place(**place))
        return found

    def _place(self, key: str) -> Place | None:
        """Return where a name lies, or an element of an array."""
        whole, _, inside = key.removesuffix("]").rpartition("[")
        if len(self.names.get(key, ())) == 1:
            return self.names[key][0]
        if key in self.names or len(self.names.get(whole, ())) != 1:
            return None
        place = self.names[whole][0]
        element = tuple(int(one) for one in re.findall(r"\d+", inside))
        shape = self._value(place).shape
        fits = len(element) == len(shape) and all(
            k < n for k, n in zip(element, shape, strict=True)
        )
        return place._replace(element=element) if fits and place.fields else None

    def _value(self, place: Place) -> np.ndarray:
        if place.fields:
            k, name = place.fields[0]
            return np.array(getattr(self.given[k], name), dtype=float)[place.element]
        u = self.inputs.at(float(self.times[0]))
        found = self.start[list(place.states)] if place.states else u[list(place.inputs)]
        return found if len(found) > 1 else found[0]

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
        close = nearest(key, self.names)
        hint = f"did you mean {close}? May vary: " if close else "may vary: "
        return f"vary: unknown name {key}; {hint}{', '.join(self.names)}"

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that is not finite."""
        if not np.isfinite(value).all():
            raise ScenarioError(f"{key} = {value}: must be finite")

    def units(self, key: str) -> dict[str, str]:
        """Return the unit of an input or a state, as an attribute, where it is known."""
        _, states, inputs, _ = self.places[key]
        given = units_of(self.wiring)[1]
        found = {given[k] for k in inputs}
        for node in self.wiring.nodes:
            block, first = node.system, node.states.start
            for port, size in block.state_ports.items():
                own = set(range(first, first := first + size)) & set(states)
                found |= {block.units.get(port, "")} if own else set()
        unit = found.pop() if len(found) == 1 else ""
        return {"units": unit} if unit else {}

    def check_apart(self) -> None:
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

    def worker(
        self, values: Mapping[str, np.ndarray], trajectories: bool, cluster: bool
    ) -> "DiagramWorker":
        """Return the worker of members with such values, which are checked."""
        self.check_apart()
        found = DiagramWorker(self, trajectories)
        found.compare(values)
        if cluster:
            found.recipe  # noqa: B018 - it may be refused
        return found

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


class DiagramEnsemble(Ensemble):
    """The members of any diagram."""

    inputs: Inputs

    def __init__(self, varied: VariedDiagram, engine: str | None = None):
        self.varied, self.inputs, self.begin = varied, varied.inputs, float(varied.times[0])
        places = varied.places.items()
        apart = {field: key for key, place in places for field in place.fields}
        by_function = varied.inputs.samples is None
        wiring = varied.wiring
        runner = chosen(wiring, varied.params, by_function, engine, varied.name, apart)
        if runner.engine == "native":
            for (k, name), key in apart.items():
                if role := read_as_number(wiring.nodes[k].system, name):
                    why = f"{wiring.nodes[k].name}.{role} is read for one value of {key}"
                    in_python(varied.name, why)
                    runner = chosen(wiring, varied.params, by_function, "python")
                    break
        super().__init__(runner, varied.places, varied.start)

    def places(self, key: str) -> tuple[list[int], list[int]] | None:
        """Return where in P and in the initial state a value begins; None if it is computed."""
        fields, states, inputs, element = self.varied.places[key]
        nodes = self.varied.wiring.nodes
        timed = [nodes[k].system for k, _ in fields]
        if inputs or any(one.breakpoints_function or decided_by_time(one) for one in timed):
            return None
        if list(states) != [*range(min(states, default=0), max(states, default=-1) + 1)]:
            return None
        in_P = []
        for k, name in fields:
            first = self.native.layout.slots[k, name].offset
            if element is not ...:
                shape = np.shape(getattr(self.varied.given[k], name))
                first += int(np.ravel_multi_index(element, shape))
            in_P.append(first)
        return in_P, list(states[:1])

    def made(self, own: Mapping[str, np.ndarray]) -> Made:
        """Return one member with some values of its own."""
        given, start, inputs = list(self.varied.given), self.varied.start.copy(), self.inputs
        for key, value in own.items():
            fields, states, rows, element = self.varied.places[key]
            for k, name in fields:
                number = np.array(getattr(given[k], name), dtype=float)
                number[element] = value
                given[k] = given[k]._replace(**{name: number[()]})
            if states:
                start[list(states)] = value
            if rows and inputs.samples is not None:
                at, u = inputs.samples
                u = u.copy()
                u[list(rows)] = np.reshape(value, (-1, 1))
                inputs = replace(inputs, samples=(at, u))
        return given, start, inputs


def weights_of(times: np.ndarray, discrete: bool) -> np.ndarray:
    """Return what each sample counts in a mean over time: all alike, or by trapezoids."""
    if discrete:
        return np.full(len(times), 1.0 / len(times))
    spans = np.diff(times)
    return (np.append(spans, 0.0) + np.append(0.0, spans)) / (2.0 * (times[-1] - times[0]))


class DiagramRecipe(NamedTuple):
    """All that a worker of a diagram needs to know."""

    made: bytes  # what varies, pickled
    trajectories: bool
    engine: str

    def worker(self) -> "DiagramWorker":
        """Return the worker that members are run by."""
        return DiagramWorker(pickle.loads(self.made), self.trajectories, self.engine)


class DiagramWorker(Worker):
    """Members of a diagram."""

    alone = True

    def __init__(self, varied: VariedDiagram, trajectories: bool, engine: str | None = None):
        super().__init__()
        self.varied, self.trajectories = varied, trajectories
        self.title, self.how = f"Ensemble of {varied.name}", varied.how
        self.by = {} if varied.wiring.dt else varied.how  # of a run by itself
        self.ensemble = DiagramEnsemble(varied, engine)
        self.every = self.ensemble.native.sweep.at_jumps(varied.times)
        signals = varied.wiring.nodes[-1].outputs.stop
        self.rows = [
            (own, [(k if k >= 0 else signals + ~k, gain) for k, gain in row.items()])
            for own, row in enumerate(varied.wiring.outputs)
        ]
        self.weights = weights_of(self.every, bool(varied.wiring.dt))
        taken, ports = ("time", "member", "status", "end", *varied.values), ports_of(varied.outputs)
        units = units_shown(varied.wiring)
        said = {port: units[places[0]] for port, places in ports.items()}
        self.ports, self.axes = ports_shown(ports, {}, taken, said)
        signals = zip(self.ports.values(), ports.values(), strict=True)
        self.sizes = {dim: len(own) for part, own in signals for dim in part.dims[1:]}

    @cached_property
    def recipe(self) -> DiagramRecipe:
        """What another process makes the same worker of."""
        made = pickled(self.varied, self.varied.name, True)
        return DiagramRecipe(made, self.trajectories, self.ensemble.native.engine)

    def compare(self, values: Mapping[str, np.ndarray]) -> None:
        """Compare what was read with Python along some members; else all run in Python."""
        native, count = self.ensemble.native, len(next(iter(values.values())))
        for m in sorted({k * (count - 1) // (TRIED - 1) for k in range(TRIED)}):
            if native.engine != "native":
                return
            given, start, inputs = self.ensemble.made({key: own[m] for key, own in values.items()})
            one = native.with_parameters(given)
            try:
                found = compared(one, start, self.every, inputs=inputs, **self.by)[2]
            except SimulationError:  # the member fails, which its status tells
                continue
            if found:
                in_python(self.varied.name, found)
                self.ensemble = DiagramEnsemble(self.varied, "python")
                return

    def why(self, own: Mapping[str, np.ndarray]) -> str:
        """Return the sentence with which a member by itself stops; "" where it does not."""
        given, start, inputs = self.ensemble.made(own)
        one = self.ensemble.native.with_parameters(given)
        try:
            one.signals(one.run(start, self.every, inputs=inputs, **self.by), inputs)
        except SimulationError as error:
            return str(error)
        return ""

    def arrays(self, values: Mapping[str, np.ndarray]) -> dict[str, Array]:
        """Return all arrays of the store, for the values of all members."""
        count = len(next(iter(values.values())))
        found = Arrays(count, {"time": len(self.every), **self.sizes})
        for port, part in self.ports.items():
            for what, said in KEPT.items():
                found.keep(f"{port}_{what}", part.dims[1:], f"{port}, {said}", **part.attributes)
            if self.trajectories:
                found.keep(port, part.dims, port, **part.attributes)
        found.keep_ends()
        for key, array in values.items():
            more = [f"{key} {k}" for k in range(array.ndim - 1)]
            units = self.varied.units(key)
            found.fix(key, ("member", *more), array, long_name=key, **units)
        found.fix_members()
        for dim, (numbers, attributes) in self.axes.items():
            found.fix(dim, (dim,), numbers, **attributes)
        if self.trajectories:
            found.fix("time", ("time",), self.every, long_name="time")
        return found

    def kept(
        self, members: Members, values: Mapping[str, np.ndarray], states: States
    ) -> dict[str, np.ndarray]:
        """Return what is kept of members."""
        y = np.full((len(states.status), len(self.varied.outputs), len(self.every)), np.nan)
        for m, own in enumerate(y):
            self._fill(own, members, states, m)
        unknown = (states.status == solver.FINISHED) & ~np.isfinite(y).all(axis=(1, 2))
        states = replace(states, status=np.where(unknown, solver.NOT_FINITE, states.status))
        # each row is summed by itself: others beside it change no bit
        figures = y[..., -1], np.sqrt(np.sum(self.weights * y**2, axis=-1)), np.abs(y).max(axis=-1)
        found = {
            f"{port}_{what}": part.of(figure)
            for port, part in self.ports.items()
            for what, figure in zip(KEPT, figures, strict=True)
        }
        for port, part in self.ports.items() if self.trajectories else ():
            along = part.of(y)
            found[port] = np.moveaxis(along, 1, -1) if along.ndim > 2 else along
        return found | ends_of(states, self.every)

    def _fill(self, y: np.ndarray, members: Members, states: States, m: int) -> None:
        """Set the outputs of one member, a row for each, up to where it came."""
        signals = self.ensemble.signals(members, states, m, self.every)
        reached, (_, inputs) = len(signals), self.ensemble.alone(members, m)
        every = [*signals.T, *inputs.along(self.every[:reached])]
        for own, sources in self.rows:
            y[own, :reached] = 0.0
            for source, gain in sources:  # one after the other: any number of them rounds so
                y[own, :reached] += gain * every[source]
