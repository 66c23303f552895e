"""Linearization of a diagram about a point, exact: its record differentiated in every direction.

    dx' = A dx + B du,    dy = C dx + D du         about x and u at time t

A diagram with sampled blocks becomes the discrete system of the loop (`sampled_linearization`).

At a kink of a signal or a rate, such as |e| at e = 0 or a node of a table, the slope is that of one
side, and a warning names the signal.  At a jump there is no slope, and the diagram is refused.
Kinks and jumps are found by comparing values near the point with the linear prediction, so a kink
without effect, as in the drag w |w| at w = 0, is neither.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from math import prod
from typing import Any

import control
import numpy as np
from scipy.linalg import orth

from ...base.arguments import attribute_of, public, vector_of
from ...base.errors import DiagramError
from ...base.progress import warn
from ..conformance.confirmation import drawn_around
from ..model.block import Block
from ..model.ports import bare_labels, places, spans_of
from ..model.sampled import Sampled
from ..record.graph import Shape, compact, evaluated, reached
from ..record.operations import FOLDS, named
from ..record.unread import Unread
from ..trace.arrays import Tape, operand
from ..trace.derivative import OF_OVERFLOW, Direction
from ..trace.elementwise import lifted
from .interconnection import Diagram
from .merged_record import TapeRecord
from .sampled_linearization import common_period, discrete_system, states_of
from .wiring import Node, Wiring, read_anew, vector_by_name, wiring_of

BEND = named(lambda row: row.smoothness >= FOLDS)
# relative: the remainder shrinks by 1e-4, at a kink by 1e-2
STEPS = (1e-6, -1e-6, 1e-8, -1e-8)
# remainder at the small step, relative to the remainder at the large step
SMOOTH = 5e-3
JUMP = 0.3
DRAWN = 3  # times so many directions as states and inputs
ROUNDING = 1e-14  # relative, of a value and of what its slopes bring
LEVEL_ROUNDING = 1e-12  # relative, of what the distance of a guard is made of
REACHED = 1e-9  # of the largest: a smaller component is not reached


class _About:
    """A diagram's record about a point, with its derivative along each state and input."""

    def __init__(self, diagram: Any, wiring: Wiring, t: float, x: Any, u: Any):
        self.tape = Tape()
        self.point = np.concatenate([x, u])
        self.count = len(self.point)  # number of states and inputs
        self.unit_vectors = np.eye(self.count)
        # of leaves: time, parameters, and directions of states and inputs
        self.values: dict[Any, Any] = {("t", "t"): np.array([t])}
        self.positions: dict[Any, slice] = {}  # of states and inputs, in the point
        self.direction = Direction(self.tape, self.slope_of, undefined=OF_OVERFLOW)
        self.parameters = {
            name: block.parameters_at(t, block.parameters)
            for name, block in wiring.blocks
        }
        self.states = {}
        for node in wiring.nodes:
            states = range(node.states.start, node.states.stop)
            for port, (own, _) in places(node.system.state_shapes).items():
                signals = states[own]
                self.states[node.name, port] = slice(signals.start, signals.stop)
        self.record = TapeRecord(diagram, wiring, self.tape, closed=True)
        n = len(x)
        for port, span in spans_of(diagram.input_labels).items():
            position = slice(n + span.start, n + span.stop)
            self._vary(("u", port), self.record.external[port], position)
        for key, (node, name, leaf) in self.record.leaves.items():
            group, path = key
            if group == "x":
                self._vary(key, leaf, self.states[path])
            else:
                value = np.asarray(getattr(self.parameters[node.name], name), float)
                self.values[key] = value[..., None]

    def _vary(self, key: tuple, leaf: Any, position: slice) -> None:
        """Set the position and the directions of a leaf that varies."""
        vectors = self.unit_vectors[position]
        self.values["d", key] = vectors.reshape(*leaf.shape, self.count)
        self.positions[key] = position

    def slope_of(self, ref: int) -> Any:
        """Return the directions of a state or input; parameters and time do not vary."""
        _, _, shape, key = self.tape.operations[ref]
        return (
            self.tape.add("leaf", (), shape, ("d", key))
            if key in self.positions
            else None
        )

    def numbers(
        self, arrays: Iterable[Any], shapes: list[Shape], points: Any, columns: int
    ) -> np.ndarray:
        """Return arrays of the tape at points, one a column: a row for each element."""
        points = points.reshape(self.count, -1)
        leaves = dict(self.values)
        for key, position in self.positions.items():
            shape = self.values["d", key].shape[:-1]
            leaves[key] = points[position].reshape(*shape, points.shape[1])
        refs = [operand(lifted(self.tape, array)) for array in arrays]
        record = compact(self.tape.operations, refs, shapes)
        return evaluated(record, lambda *key: leaves[key], points=columns)

    @np.errstate(all="ignore")  # of a slope that is not finite
    def slopes(self, values: Collection[Any], point: Any = None) -> np.ndarray:
        """Return the derivatives of values, a row for each element, at the point or another."""
        slopes = map(self.direction.of, values)
        point = self.point if point is None else point
        return self.numbers(slopes, shapes_of(values), point, self.count)

    def is_at_level(self, distance: Any) -> bool:
        """Return whether a distance at the point is 0, but for the rounding of its leaves."""

        def rounding_of(leaf: int) -> Any:
            return LEVEL_ROUNDING * np.fabs(self.tape.value(leaf))

        rounding = Direction(self.tape, rounding_of, bound=True).of(distance)
        pair = [np.fabs(distance), rounding]
        size, rounding = self.numbers(pair, [(), ()], self.point, 1).ravel()
        return size <= rounding

    def near(self, values: list[Any], moves: np.ndarray) -> np.ndarray:
        """Return values near the point, a row for each element and a column for each move."""
        points = self.point[:, None] + moves
        return self.numbers(values, shapes_of(values), points, moves.shape[1])

    def sampled_values(self, blocks: Sequence[Node]) -> Iterator[tuple[slice, Any]]:
        """Yield position and value of each port of a sampled block's states at the next sample."""
        names = {block.name for block in blocks}
        for (name, port), position in self.states.items():
            if name in names:
                yield position, self.record.jumps[name, port]

    def sample(self, blocks: Sequence[Node]) -> None:
        """Have sampled blocks hold what they sample at this point."""
        point = self.point.copy()
        no_moves = np.zeros((self.count, 1))
        held_states = states_of(blocks, are_held=True)
        for position, values in self.sampled_values(blocks):
            if position.start in held_states:
                point[position] = self.near([values], no_moves)[:, 0]
        self.point = point

    @np.errstate(all="ignore")  # of paths that are not taken at the point
    def check(self, values: Mapping[str, Any]) -> None:
        """Warn where a value has a kink at the point; refuse where one jumps.

        The remainder of the linear prediction shrinks as the square of the step at a smooth point,
        as the step at a kink, and not at all at a jump.  A slope of neither side is refused too.
        """
        size = 1.0 + np.abs(self.point)[:, None]
        checked = [*values.values()]
        lines = self.tape.operations
        refs = reached(lines, map(operand, checked))
        if BEND.isdisjoint(lines[k].kind for k in refs):
            return
        slopes = self.slopes(checked)
        n = self.count
        at_point = self.near(checked, np.zeros((n, 1)))
        # others are refused where they matter
        is_finite = np.all(np.isfinite(slopes), axis=1)
        slopes = np.where(is_finite[:, None], slopes, 0.0)
        drawn = np.random.default_rng(0).standard_normal((n, DRAWN * n))
        # along each state and input, and along all at once
        directions = size * np.hstack([self.unit_vectors, drawn])
        moves = np.hstack([step * directions for step in STEPS])
        changes = self.near(checked, moves) - at_point
        remainder = np.abs(changes - slopes @ moves)
        far_ahead, far_behind, near_ahead, near_behind = np.split(
            remainder, len(STEPS), axis=1
        )
        # compare the remainders of the small step with those of the large step
        rounding = ROUNDING * (np.abs(at_point) + np.abs(slopes) @ size)
        wide = np.maximum(far_ahead, far_behind)
        wide = np.nan_to_num(wide, nan=np.inf)
        small = np.maximum(near_ahead, near_behind)
        kink = SMOOTH * wide + rounding
        jump = JUMP * wide + rounding
        bent = np.any(small > kink, axis=1)
        torn = np.any(~(small <= jump), axis=1)
        one_sided = np.minimum(near_ahead, near_behind)[:, :n]
        torn |= np.any(one_sided > kink[:, :n], axis=1)
        counts = [prod(shape) for shape in shapes_of(checked)]
        names = np.repeat([*values], counts)
        for name in names[torn & is_finite][:1]:
            raise DiagramError(
                f"{name} jumps at this point, or has another slope on each side, so it has no "
                "linearization there. Linearize on one side of it"
            )
        for name in names[bent & is_finite][:1]:
            warn(f"{name} has a kink at this point; the slope is that of one side")


def shapes_of(values: Iterable[Any]) -> list[Shape]:
    """Return the shapes of arrays and numbers."""
    return [getattr(value, "shape", ()) for value in values]


@public
def linearize(
    system: control.NonlinearIOSystem,
    x: Any = None,
    u: Any = None,
    t: float = 0.0,
    params: Mapping[str, Any] | None = None,
    minimal: bool = False,
) -> control.StateSpace:
    """Linearize a diagram about a point, exactly.

    Parameters
    ----------
    system : control.NonlinearIOSystem
        A diagram, a block or a system of python-control.
    x, u : array_like or mapping, optional
        States and inputs of the point; by default 0. A mapping, ``{"angle": 0.5}``, has labels
        or ports, others being 0. An operating point of
        ``control.find_operating_point`` has both. The inputs that sampled blocks hold are those
        of this point, whatever x says.
    t : float, optional
        Time of the point.
    params : mapping, optional
        Call-time parameters, ``{"adaptation.gain": 2.0}``.
    minimal : bool, optional
        Whether states that no input reaches, or that reach no output, are left out.

    Returns
    -------
    control.StateSpace
        With the diagram's labels of states, inputs and outputs, ``linear["e[1]", "r"]``: a port of
        one signal has its name alone. Where `minimal` mixes states they are called x[k]. With
        sampled blocks it is of discrete time, from one sample of all of them to the next, with
        the diagram's inputs held between; held inputs of blocks are no states.

    Raises
    ------
    DiagramError
        If a state, a signal or a rate jumps at the point or has no finite slope there, a function
        cannot be traced, or sampled blocks have no small common period.

    Warns
    -----
    UserWarning
        If a signal or a rate has a kink at the point; the first is named.

    Notes
    -----
    ``control.margin`` forms polynomials of a state-space system. Leading numbers of a numerator
    that are zero may come out as 1e-14 there, and an infinite gain margin as 1e15.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> def rate(t, x, u, params):
    ...     return [x[1], -params["g"] * np.sin(x[0]) + u[0]]
    >>> pendulum = control.nlsys(rate, inputs="u", states=["theta", "omega"], params={"g": 9.81})
    >>> clpt.linearize(pendulum, [np.pi, 0.0]).A
    array([[0.  , 1.  ],
           [9.81, 0.  ]])
    """
    u = attribute_of(x, "inputs", u)
    x = attribute_of(x, "states", x)
    x = vector_by_name("x", system, "state", x)
    u = vector_by_name("u", system, "input", u)
    with drawn_around(t, x, u):
        return _linearized(system, x, u, t, params, minimal)


def _linearized(
    system: control.NonlinearIOSystem,
    x: Any,
    u: Any,
    t: float,
    params: Mapping[str, Any] | None,
    minimal: bool,
) -> control.StateSpace:
    """Return the linear system at a point."""
    read_anew(system)
    wiring = wiring_of(system, params)
    n = wiring.nodes[-1].states.stop
    m = wiring.ninputs
    if not n + m:
        raise DiagramError(
            f"{system.name}: has no states and no inputs to linearize along"
        )
    x = vector_of("x", x, n)
    u = vector_of("u", u, m)
    try:
        blocks = [node for node in wiring.nodes if isinstance(node.system, Sampled)]
        about = _About(system, wiring, t, x, u)
        for _ in blocks:
            # some blocks sample what others make of their samples
            about.sample(blocks)
        signals = {
            f"{node.name}.{port}": about.record.signals[node.name, port]
            for node in wiring.nodes
            for port in node.system.declared["outputs"]
        }
        rates = {
            f"the rate of {'.'.join(path)}": about.record.rates[path]
            for path in about.states
        }
        AB = about.slopes(rates.values())
        Y = about.slopes(signals.values())
        jumps = np.zeros_like(AB)
        for position, values in about.sampled_values(blocks):
            jumps[position] = about.slopes([values])
        checked = signals | rates
        about.check(checked)
        for (name, _), level in about.record.levels.items():
            if about.is_at_level(level):
                raise DiagramError(
                    f"{system.name}: the states of {name} jump at this point. Linearize at a point "
                    "inside its guard"
                )
    except Unread as error:
        raise DiagramError(f"{error}") from None
    CD = wiring.outputs_of(Y.T, about.unit_vectors[n:].T).T
    states = system.state_labels
    labels = [*states, *system.input_labels]
    for rows, names in ((AB + jumps, states), (CD, system.output_labels)):
        for i, j in np.argwhere(~np.isfinite(rows))[:1]:
            raise DiagramError(
                f"{system.name}: what {names[i]} does along {labels[j]} has no finite slope at "
                f"this point{_advice(about, checked.values(), labels)}"
            )
    A, B = np.split(AB, [n], axis=1)
    C, D = np.split(CD, [n], axis=1)
    dt = wiring.dt
    if blocks:
        dt = common_period(blocks)
        A, B, C, D, remaining = discrete_system(AB, CD, jumps, blocks, dt)
        states = [states[k] for k in remaining]
    inputs, outputs = system.input_labels, system.output_labels
    if isinstance(
        system, Block | Diagram
    ):  # python-control's systems keep their labels
        inputs, outputs = bare_labels(inputs), bare_labels(outputs)
    linear = state_space(
        A,
        B,
        C,
        D,
        dt,
        states=states or None,
        inputs=inputs,
        outputs=outputs,
        name=f"{system.name}$linearized",
    )
    return minimal_of(linear) if minimal else linear


def _advice(about: _About, values: Collection[Any], labels: list[str]) -> str:
    """Return the kernel's centre where values have no slope, and a point beside it that has."""
    beside = [float(f"{x + 0.01 * (1 + abs(x)):g}") for x in about.point]
    moved = np.ones(about.count, bool)

    def has_slopes() -> bool:
        point = np.where(moved, beside, about.point)
        return bool(np.isfinite(about.slopes(values, point)).all())

    for position in about.positions.values():
        moved[position] = False
        moved[position] = not has_slopes()
    if has_slopes():
        shown = [f"{labels[k]} = {beside[k]:g}" for k in np.flatnonzero(moved)]
        for center in _centers(about, moved):
            return f"{center}. Linearize beside it, with {', '.join(shown)}"
    return "; under a root or a norm that is 0, add a small number"


def _centers(about: _About, moved: np.ndarray) -> Iterator[str]:
    """Yield the rows of parameters, such as centres of kernels, at which moved ports are."""
    for node in about.record.wiring.nodes:
        function = getattr(node.system, "output_function", None)
        name = getattr(function, "__name__", "its function")
        for field, rows in about.parameters[node.name]._asdict().items():
            for position in about.positions.values():
                here = about.point[position]
                if moved[position].all() and np.shape(rows)[1:] == here.shape:
                    for k in np.flatnonzero((rows == here).all(axis=1)):
                        at = f"{field}[{k}] = {here.tolist()}"
                        yield f": {name} of {node.name} is at {at}"


def state_space(
    A: Any, B: Any, C: Any, D: Any, dt: Any, **labels: Any
) -> control.StateSpace:
    """Return `control.StateSpace`, also of no inputs, which it refuses beside one state or output.

    Its matrices of shape (1, 0) become (0, 0).
    """
    if labels["inputs"]:
        return control.StateSpace(A, B, C, D, dt, **labels)
    one_input = {**labels, "inputs": 1}
    zero_B = np.zeros((len(A), 1))
    zero_D = np.zeros((len(C), 1))
    system = control.StateSpace(A, zero_B, C, zero_D, dt, **one_input)
    system.B = B
    system.D = D
    system.set_inputs(0)
    return system


def _reached(A: np.ndarray, B: np.ndarray) -> np.ndarray:
    """Return a basis of the states that inputs reach: single states where that is possible."""

    def columns(M: np.ndarray) -> np.ndarray:
        # which SciPy 1.13 refuses
        return orth(M, rcond=REACHED) if M.size else M[:, :0]

    basis = columns(B)
    size = np.linalg.norm(A) or 1.0
    while (
        larger := columns(np.hstack([basis, A @ basis / size]))
    ).shape != basis.shape:
        basis = larger
    reaches = np.any(np.abs(basis) > REACHED, axis=1)
    reached_states = np.flatnonzero(reaches)
    if len(reached_states) == basis.shape[1]:
        return np.eye(len(A))[:, reached_states]
    return basis


def minimal_of(system: control.StateSpace) -> control.StateSpace:
    """Return a system of the states that inputs and outputs reach; mixed states are x[k]."""
    A = system.A
    B = system.B
    C = system.C
    names = system.state_labels
    for transposed in (False, True):
        V = _reached(A.T, C.T) if transposed else _reached(A, B)
        A = V.T @ A @ V
        B = V.T @ B
        C = C @ V
        plain = np.all((V == 0.0) | (V == 1.0))
        names = [names[np.argmax(v)] if plain else f"x[{k}]" for k, v in enumerate(V.T)]
    labels = {
        "states": names or None,
        "inputs": system.input_labels,
        "name": system.name,
    }
    return state_space(
        A, B, C, system.D, system.dt, outputs=system.output_labels, **labels
    )
