"""Guaranteed runs: boxes that contain every run from sets of states, parameters and inputs."""

from collections.abc import Callable, Mapping
from contextlib import suppress
from itertools import product
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..base.arguments import Count, attribute_of, brief, has, numbers, public
from ..base.errors import ArgumentError, BlockError, SimulationError, Uncompiled
from ..base.figures import BLUE, GREY, legend_above_data, literal
from ..base.labelled import Labelled, unit_of, unlabelled
from ..base.units import printed_unit
from ..engine.codegen.diagram_record import DiagramRecord, Form
from ..engine.codegen.directional_derivatives import call_names, read_as_number
from ..engine.codegen.series import Node
from ..engine.diagram.wiring import state_units, wiring_of
from ..engine.enclosure.balls import Ball, between
from ..engine.enclosure.curvature import tangents
from ..engine.enclosure.noise import InputNoise
from ..engine.enclosure.pieces import enclosed
from ..engine.enclosure.set_program import DECIDED, SetProgram
from ..engine.enclosure.sets import MOST_STEPS, Enclosure
from ..engine.model.declaration import same_unit
from ..engine.model.ports import ports_of, whole_labels
from ..engine.record.unread import Unread
from ..engine.solver.engine_choice import difference
from ..engine.solver.inputs import Inputs
from ..engine.solver.native_diagram import NativeDiagram
from ..engine.solver.schedule import Schedule
from ..engine.solver.termination import Solution
from .comparison import named, panels_for
from .diagram_runs import DiagramRun, distinct_labels, fields_of, signal_units
from .requests import Request, as_diagram, joined, request_of, start_of

if TYPE_CHECKING:
    import xarray

    from ..paper.scenario.experiment import Scenario

MATRICES = {"A", "B", "C", "D", "interval"}  # of linear systems
MOST_PANELS = 6
MOST_NUMBERS = 1_000_000  # of a coefficient; there are 27, of centres and radii
ROUNDING = 2.0**-48
GUARANTEED = (
    "guaranteed: every run from these states, parameters and inputs, of the recorded equations "
    "with their numbers as doubles and exact arithmetic, exists and lies within the boxes of"
)
# attributes of values with names, times or a unit
LABELS = "coords", "iloc", "items", "output_labels", "signal_labels"


def is_pair(entry: Any) -> bool:
    """Return whether an entry of an argument is an interval."""
    return isinstance(entry, tuple) and len(entry) == 2


def holds_pair(value: Any) -> bool:
    """Return whether a list, a mapping or a table has an interval among its entries."""
    entries = value if isinstance(value, list | tuple) else ()
    if has(value, "items"):
        entries = [*dict(value).values()]
    return any(is_pair(entry) or holds_pair(entry) for entry in entries)


def is_labelled(end: Any) -> bool:
    """Return whether an end has names, times or a unit."""
    return any(has(end, name) for name in LABELS)


def check_units(where: str, *ends: Any) -> None:
    """Refuse ends in two units, also by name: x[0] is in the unit of x."""
    low, high = map(unit_of, ends)
    if low and high and not same_unit(low, high):
        raise ArgumentError(
            f"{where}: its lower end is in '{low}', its upper end in '{high}'; must be in one unit"
        )
    if all(isinstance(end, Mapping) for end in ends):
        for a, b in product(*ends):
            if f"{a}[".startswith(f"{b}[") or f"{b}[".startswith(f"{a}["):
                check_units(f"{where}[{a!r}]", ends[0][a], ends[1][b])


def end_of(name: str, value: Any, is_upper: bool) -> Any:
    """Return an argument with the lower or upper end in the place of each pair.

    Ends with labels stay as they are; whole numbers and lists are no places of a record.
    """
    if is_pair(value):
        if holds_pair(value):
            raise ArgumentError(
                f"{name} = {brief(value)}: may be two pairs or the ends of one. Give ends that are "
                "lists, of a port a list of pairs"
            )
        check_units(name, *value)
        if not any(map(is_labelled, value)):
            check_ordered(f"{name} = {brief(value)}", *value)
        end = value[is_upper]
        return end if is_labelled(end) else unlabelled(name, end)[()]
    if not holds_pair(value):
        return value
    if isinstance(value, list | tuple):
        return [end_of(f"{name}[{k}]", one, is_upper) for k, one in enumerate(value)]
    entries = dict(value).items()
    return {key: end_of(f"{name}[{key!r}]", one, is_upper) for key, one in entries}


@np.errstate(all="ignore")
def check_ordered(where: str, *ends: Any) -> None:
    """Refuse ends that are no interval."""
    lower, upper = (numbers(where, end) for end in ends)
    is_ordered = lower.shape == upper.shape and lower.size
    if not is_ordered or not np.all((lower <= upper) & np.isfinite(upper - lower)):
        raise ArgumentError(
            f"{where}: must be a pair (lower, upper) with lower <= upper, a finite width and one "
            "shape. Several numbers are a list"
        )


def check_pairs(inputs: Any, initial_state: Any, params: Mapping[str, Any]) -> None:
    """Refuse pairs that may be read in two ways."""
    for name, given in (("inputs", inputs), ("initial_state", initial_state)):
        if is_pair(given) and not any(
            isinstance(end, Mapping | control.TimeResponseData)
            or str in map(type, attribute_of(end, "keys", dict)())
            for end in given
        ):
            raise ArgumentError(
                f"{name} = {brief(given)}: may be one pair or two numbers. Give a list, or a "
                "mapping"
            )
    for name, entry in params.items():
        if not is_pair(entry) and holds_pair(entry):
            raise ArgumentError(
                f"params: {name} = {brief(entry)}: has pairs within an array. Give a pair of "
                "arrays, (lower, upper)"
            )


def check_ports(argument: str, given: Any, labels: list[str]) -> None:
    """Refuse two numbers for a port of several, which may be one pair of each."""
    ports = ports_of(labels)
    for key, entry in given.items() if has(given, "items") else ():
        if is_pair(entry) and not np.ndim(entry[0]) and len(ports.get(key, ())) == 2:
            raise ArgumentError(
                f"{argument}[{key!r}] = {brief(entry)}: may be one pair or two numbers. Give a "
                "list of pairs, or ends that are lists"
            )


@public
def enclose(
    system: "Scenario | control.InputOutputSystem",
    timepts: Any = None,
    inputs: Any = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
    pieces: Count = 1,
) -> "xarray.Dataset":
    """Return boxes that contain every run from a set.

    A tuple ``(lower, upper)`` in place of a number is an interval: of an initial state and of a
    parameter any constant, of an input any function of time in it. Systems may have discrete time,
    sampled parts and jumps at known times.

    Parameters
    ----------
    system, timepts, inputs, initial_state, params
        As of `simulate`; each number in a list or mapping may be a pair, of an array of parameters
        a pair of arrays. Each end is read alone, as `simulate` reads a value: by names, times and
        units, and 0 for what a mapping leaves out. Both ends have one unit. They may be mappings,
        pandas data with names or responses, and samples of an input at other times. Times, if none
        are given, are those of the lower end.
    pieces
        Into how many pieces a wide set is divided at most, one after the other where boxes end
        first or grow most. `pieces` take about 2 `pieces` times the CPU of one.

    Returns
    -------
    xarray.Dataset
        ``lower`` and ``upper`` of each state and output at each time, after its jumps;
        ``over_lower`` and ``over_upper`` from the time before to it, narrower the closer the times
        are. NaN is no statement; the message names outputs without a bound. Names are those of
        `simulate`: ``x[0]`` is the output if a state and another output have the name x, and
        ``x_state[0]`` is the state. The attribute ``message`` says what is guaranteed, to which
        time, and why not longer. ``clpt.plot()`` draws the boxes.

        A point takes 20 to 400 times the CPU of `simulate`; stiff systems and roots at 0 more.

    Raises
    ------
    SimulationError
        If the system has guards, jumps at a level, or operations without series.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> tank = clpt.Block("tank", update=lambda t, x, u, p: -p.k * x, states={"x": 1},
    ...     parameters={"k": 1.0})
    >>> tube = clpt.enclose(tank, [0, 1], initial_state=[(1, 2)], params={"tank.k": (0.99, 1.01)})
    >>> tube.lower.values.round(3)[-1].item(), tube.upper.values.round(3)[-1].item()
    (0.36, 0.743)
    """
    return boxes(system, timepts, inputs, initial_state, params, pieces)


def boxes(
    system: Any,
    timepts: Any,
    inputs: Any,
    initial_state: Any,
    params: Mapping[str, Any] | None,
    pieces: int = 1,
    margins: Mapping[str, Any] = MappingProxyType({}),
    undecided: Callable[[Enclosure], bool] | None = None,
    most_steps: int = MOST_STEPS,
) -> "xarray.Dataset":
    """Return the boxes of `enclose`, the last of them of `margins`, functions of signals.

    Pieces are halved where they are `undecided`.
    """
    # 1. programs of the record
    check_pairs(inputs, initial_state, params or {})
    given = {"inputs": inputs, "initial_state": initial_state, "params": params or {}}
    ends = [
        [end_of(name, value, is_upper) for name, value in given.items()]
        for is_upper in (False, True)
    ]
    try:
        requests, at, lower, upper = requests_of(system, timepts, ends)
        request = requests[0]
        with request.drawn_around():
            made = DiagramRun(request.diagram, ends[0][2], request.sizes, "python")
        check_ports("inputs", inputs, made.input_labels)
        check_ports("initial_state", initial_state, made.states)
        low, high = (one.start for one in requests)
        names = made.states + made.input_labels
        for name, *both in zip(names, [*low, *lower], [*high, *upper], strict=True):
            check_ordered(name, *both)
        natives = natives_of(made, [end[2] for end in ends], requests)
        layout = natives[0].layout
        record = DiagramRecord(made.wiring, layout, Form(exact=True))
        start, middle = between(low, high), between(lower, upper)
        schedule = natives[0].schedule(request.times, Inputs((at, middle.c)))
        with np.errstate(invalid="ignore"):  # limits may be infinite
            P = between(layout.P, layout.packed(natives[1].sweep.parameters))
        noise = noise_of(at, middle, len(layout.P) + 1)
        fixed = fixed_numbers(P, schedule, noise)
        leaps = record.rates if made.wiring.dt else record.leaps
        programs = [
            SetProgram(record, ports, len(start.c), fixed, noise.places)
            for ports in (record.rates, record.signals, leaps, record.rates)
        ]
        rates, signals, _, second = programs
        if len(rates.still) * (1 + len(start.c)) > MOST_NUMBERS:
            raise Uncompiled(f"has {len(rates.still)} values, too many for its states")
    except (Uncompiled, Unread) as error:
        raise SimulationError(
            f"enclose: does not take this system: {error}. Use simulate, or "
            "run_ensemble for samples of a set"
        ) from None
    if not made.wiring.dt:
        along = [("X", k) for k in range(len(start.c))]
        tangents(second, along + [("P", k) for k in np.flatnonzero(P.r).tolist()])
    signals.connect(record)
    values = _signals(made, signals)
    names = names_of(made, signals)
    for name, margin in margins.items():
        signals.results.append(_margin(name, margin, values, signals))
        names.append(name)
    # 2. boxes, with room for inputs in P
    room = np.zeros(layout.inputs(made.wiring.ninputs) - len(P.c))
    pairs = zip(start, P, strict=True)
    whole = Ball(*(np.concatenate([x, p, room]) for x, p in pairs))
    jumps = None if made.wiring.dt else [*layout.jumps.values()]
    times = request.times if request.steps is None else request.times[request.steps]
    runs = enclosed(
        whole,
        schedule,
        pieces,
        programs,
        noise,
        times,
        jumps,
        most_steps,
        undecided=undecided,
    )
    lost = {names[one.n + k]: why for one in runs for k, why in one.lost.items()}
    whose = "all states and outputs" + (f" but {', '.join(lost)}" if lost else "")
    tube = dataset_of(runs, names, f"{GUARANTEED} {whose}")
    units = dict(zip(made.output_labels, signal_units(made.wiring), strict=False))
    units |= zip(whole_labels(made.states), state_units(made.wiring), strict=True)
    tube["units"] = "name", [units.get(name, "") for name in names]
    tube = tube.set_coords("units")
    for name, why in lost.items():
        tube.attrs["message"] += f"; {name} has no box at some times, as {why}"
    # 3. whether runs are back where they began
    states = tube.isel(time=slice(1, None), name=slice(len(start.c)))
    back = ((states.lower >= low) & (states.upper <= high)).all("name").values
    is_timed = (
        rates.reads_time
        or signals.reads_time
        or layout.time_tables
        or any(node.system.breakpoints_function for node in made.wiring.nodes)
        or any(np.ptp(one.inputs.samples[1], axis=1).any() for one in requests)
    )
    if back.any() and not is_timed:
        tube.attrs["message"] += (
            f"; at t = {times[1:][back][0]:.9g} all states are within the bounds that they "
            f"began in, so the `over_` boxes of {whose} up to then hold for ever"
        )
    return tube


def _signals(made: DiagramRun, signals: SetProgram) -> tuple[Any, ...]:
    """Return the time, and names and values of outputs and states, as numbers of a program."""
    outputs = [Node(signals, slot) for slot in signals.results]  # type: ignore[arg-type]
    states = [Node(signals, slot) for slot in signals.x]  # type: ignore[arg-type]
    time = Node(signals, signals.time)  # type: ignore[arg-type]
    return time, (made.output_labels, outputs), (whole_labels(made.states), states)


def _margin(name: str, margin: Any, values: tuple, signals: SetProgram) -> int:
    """Return the value of a function of signals."""
    first = len(signals.steps)
    slots = []
    for _ in range(2):
        value = margin(*values)
        is_number = not isinstance(value, Node)
        slots.append(signals.number(float(value)) if is_number else value.argument)
    if slots[0] != slots[1]:
        raise ArgumentError(
            f"{name}: differs from call to call. Give a function of the signals alone"
        )
    kinds = {step.kind for step in signals.steps[first:]}
    if kinds & ({*DECIDED, "mod", "pick", "where"}):
        raise ArgumentError(
            f"{name}: jumps. Give a number that is above 0 where the specification holds, such as "
            "0.9 - s.level, in continuous functions"
        )
    return signals.interval_of(slots[0])


def varied_by(
    system: Any, part: float, params: Mapping[str, Any]
) -> tuple[dict[str, Any], list[str]]:
    """Return parameters with an interval around the number of each other one, and what has none."""
    if not 0.0 < numbers("within", part) < 1.0:
        raise ArgumentError(
            f"within = {brief(part)}: must be between 0 and 1, 0.1 for 10 %"
        )
    diagram = as_diagram(system)[0]
    varied, still = dict[str, Any](), list[str]()
    for node in wiring_of(diagram).nodes:
        block = node.system
        at_known_times = block.first_held is not None or not block.breakpoints_function
        names_of_fields: dict[str, list[str]] = {}
        for name, field in call_names(node.name, block).items():
            names_of_fields.setdefault(field, []).append(name)
        for field, names in names_of_fields.items():
            number = getattr(block.parameters, field)
            value = np.asarray(number, float)
            is_matrix = {*block.parameters._fields} <= MATRICES
            # a long name in the params of a diagram is that of a field of its own, too
            is_known = params.keys() & names or "." in field
            if field == "interval" or is_matrix or is_known or not np.any(value):
                continue
            name = known_name(diagram, names, number)
            is_fixed = not at_known_times or isinstance(number, int)
            if (
                is_fixed
                or read_as_number(block, field)
                or not np.all(np.isfinite(value))
            ):
                still.append(name)
                continue
            far = part * np.abs(value)
            varied[name] = ((value - far)[()], (value + far)[()])
    # a short name is of all blocks that know none of their own
    owned = {name.rpartition(".")[2] for name in varied if "." in name}
    varied = {name: ends for name, ends in varied.items() if name not in owned}
    still = [name for name in still if name not in owned]
    return {**varied, **params}, still


def known_name(diagram: Any, names: list[str], number: Any) -> str:
    """Return the name that a call has for a parameter, that of its block alone if there is one."""
    for name in sorted(names, key=len, reverse=True):
        with suppress(BlockError):
            wiring_of(diagram, {name: number})
            return name
    return names[0]


def noise_of(times: np.ndarray, middle: Ball, first: int) -> InputNoise:
    """Return how far inputs may be from their middles; `first` is the place of the first in P."""
    # lines between samples, and between the middles, are rounded
    sizes = np.max(middle.size, axis=1, keepdims=True, initial=0.0)
    rows = np.flatnonzero(middle.r.any(axis=1)).tolist()
    radii = (middle.r + ROUNDING * sizes)[rows]
    return InputNoise([first + k for k in rows], times, radii)


def fixed_numbers(P: Ball, schedule: Schedule, noise: InputNoise) -> dict[int, float]:
    """Return numbers of P that are points and never change, by their places."""
    columns = zip(schedule.indices.tolist(), schedule.values.T, strict=True)
    begin = len(P.c)  # of a segment of inputs
    changing, fixed = {begin, *noise.places}, dict[int, float]()
    for k, column in columns:
        if np.ptp(column):
            changing.add(k)
        else:
            fixed[k] = column[0]
    given = {k: P.c[k] for k in np.flatnonzero(P.r == 0.0).tolist()}
    return {k: float(v) for k, v in (given | fixed).items() if k not in changing}


def names_of(made: DiagramRun, signals: SetProgram) -> list[str]:
    """Return the names of states and of outputs, and leave out outputs that are states.

    A name that an output and another state have is that of the output, as in runs.
    """
    states, outputs = whole_labels(made.states), made.output_labels
    known = dict(zip(states, signals.x, strict=True))
    values = dict(zip(outputs, signals.results, strict=True))
    while other := [k for k in known.keys() & values if known[k] != values[k]]:
        states = distinct_labels(states, other, "_state")
        known = dict(zip(states, signals.x, strict=True))
    others = [name for name in outputs if name not in known]
    signals.results = [values[name] for name in others]
    names = states + others
    # a row x[0] stands for x alone
    ports = [name.rpartition("[")[0] for name in names]
    reserved = {*names, "time", "state", "states"}
    twice = {name for name in names if names.count(name) > 1}
    twice |= reserved.intersection(ports)
    twice |= {*ports[: len(states)]}.intersection(ports_of(made.input_labels))
    if twice:
        raise ArgumentError(
            f"enclose: {', '.join(sorted(twice))}: is the name of two signals, or of a coordinate. "
            "Give states, inputs and outputs names of their own"
        )
    return names


def requests_of(system: Any, timepts: Any, ends: list[Any]) -> tuple[Any, ...]:
    """Return requests with lower and upper inputs and states, read by one clock, and samples.

    The samples have the times of both, with lower and upper inputs, from the first to the last of
    the run.
    """
    (u, x, _), (u_high, x_high, _) = ends
    low = request_of(system, timepts, u, x, multiples=True)
    default = as_diagram(low.diagram)[1].get("initial_state")
    start = start_of(low.diagram, x_high, default, len(low.start))
    requests = [low, low.with_inputs(u_high)._replace(start=start)]
    edges = low.times[[0, -1]]
    rows = [
        Labelled(row, one.inputs.samples[0] if len(row) > 1 else None)
        for one in requests
        for row in one.inputs.samples[1]
    ]
    rows.append(Labelled(edges, edges))
    t, values = joined(rows, edges, edges).samples
    begin, end = t.searchsorted(edges, "right") - [1, 0]
    lower, upper = np.split(values[:-1, begin:end], 2)
    # numbers between samples are rounded
    size = np.max(np.abs(upper), axis=1, keepdims=True, initial=0.0)
    are_close = lower - upper <= ROUNDING * size
    upper = np.where(are_close, np.maximum(lower, upper), upper)
    return requests, t[begin:end], lower, upper


def natives_of(
    made: DiagramRun, ends: list[Any], requests: list[Request]
) -> list[NativeDiagram]:
    """Return the machine code of a diagram with lower and upper parameters, compared."""
    # 1. parameters with pairs have places of their own in P
    wiring, (lower, upper) = made.wiring, ends
    pairs = [name for name in lower if not np.array_equal(lower[name], upper[name])]
    fields = fields_of(wiring, pairs)
    if still := {*pairs}.difference(*fields.values()):
        raise Uncompiled(f"takes no interval of {', '.join(sorted(still))}")
    parameters = [wiring.parameters(end) for end in ends]
    for k, field in fields:
        check_ordered(field, *(getattr(one[k], field) for one in parameters))
    native = NativeDiagram(wiring, apart=fields)
    natives = [native.with_parameters(values) for values in parameters]
    for k, field in fields:
        block = wiring.nodes[k].system
        at_known_times = block.first_held is not None or not block.breakpoints_function
        if not at_known_times or read_as_number(block, field):
            raise Uncompiled(f"asks for the value of {field} of {block.name}")
    if natives[0].sweep.guarded:
        raise Uncompiled("has guards, or jumps at a level")
    low, high = (one.inputs.samples[1] for one in requests)
    for node in () if np.array_equal(low, high) else wiring.nodes:
        if attribute_of(node.system.breakpoints_function, "trigger"):
            raise Uncompiled(f"has jumps of {node.name} where an input may rise")
    if not len(requests[0].start):
        raise Uncompiled("has no states")
    # 2. what was read is compared with its functions along runs from both ends
    for native, one in zip(natives, requests, strict=True):
        along = Solution(one.times[:1], one.start[None])
        with suppress(SimulationError):
            along = native.solve(one.start, one.times, one.inputs, one.options)
        if why := difference(native, along, one.inputs):
            raise Uncompiled(f"is misread: {why}")
    return natives


def dataset_of(
    pieces: list[Enclosure], names: list[str], guaranteed: str
) -> "xarray.Dataset":
    """Return boxes around those of all pieces, with what is guaranteed."""
    import xarray

    first = pieces[0]
    message = f"{guaranteed} to t = {first.t:.9g}"
    if len(pieces) > 1:
        message += f", in {len(pieces)} pieces"
    if first.why:
        message += f"; the boxes end there, as {first.why}"
    if any(piece.rates.jumps for piece in pieces):
        message += "; where rates jump, runs are those of Filippov"
    variables = "lower", "over_lower", "upper", "over_upper"
    lower = np.min([piece.bounds[0] for piece in pieces], axis=0)
    upper = np.max([piece.bounds[1] for piece in pieces], axis=0)
    rows = zip(variables, [*lower, *upper], strict=True)
    return xarray.Dataset(
        {name: (("time", "name"), values) for name, values in rows},
        {"time": first.times, "name": names},
        {
            "message": message,
            "status": "stopped" if first.why else "finished",
            "steps": sum(piece.steps for piece in pieces),
            "steps_beside_switches": sum(piece.beside for piece in pieces),
        },
    )


@public
def tube_plot(tube: "xarray.Dataset", *, ax: Any = None) -> Any:
    """Draw boxes over time: shaded between samples, lines at them; at most the first six names.

    ``tube.sel(name=["x[0]"])`` has the names that are to be drawn.

    >>> import clpt_control as clpt
    >>> lag = clpt.parts.lag(2.0)
    >>> axes = tube_plot(clpt.enclose(lag, [0.0, 1.0, 2.0], [(0.9, 1.1)]))
    """
    names = tube.name.values[:MOST_PANELS].tolist()
    ports = ports_of(names)
    axes = panels_for(ax, len(names), "tube.sel(name=['x[0]'])")
    panels, time = np.ravel(axes), tube.time.values
    for panel, name in zip(panels, names, strict=True):
        box = tube.sel(name=name)
        style = {"step": "pre", "alpha": 0.25, "linewidth": 0, "color": BLUE}
        over = box.over_lower, box.over_upper
        panel.fill_between(time, *over, **style, label="over each interval")
        for bound, label in ((box.lower, "at the times"), (box.upper, "_")):
            panel.plot(time, bound, color=BLUE, linewidth=1.1, label=label)
        bounded = np.flatnonzero(np.isfinite(box.lower))
        if len(bounded) and bounded[-1] < len(time) - 1:
            end = {"color": GREY, "linestyle": ":", "label": "boxes end"}
            panel.axvline(time[bounded[-1]], **end)
        port = name.partition("[")[0]
        text = port if len(ports[port]) == 1 else name
        panel.set_ylabel(literal(named(text, printed_unit(str(box.units.item())))))
    legend_above_data(panels[0])
    panels[-1].set_xlabel("time")
    return axes
