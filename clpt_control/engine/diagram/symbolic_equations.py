"""A diagram's equations on symbols, made from its record.

    y' = -a y + b u            eq.rates["y"], eq["a"], eq.derivative(eq["y"] ** 2)

`symbol_names` says what states, inputs and parameters are called.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain, combinations
from typing import Any

import control
import numpy as np
import sympy

from ...arguments import public
from ...errors import DiagramError
from ..model.declaration import Parameters
from ..model.ports import places, ports_of
from ..model.sampled import Sampled
from ..model.system import is_linear
from ..record.graph import Shape
from ..record.symbolic import LONG, Symbols, extent, rational
from ..trace.arrays import Tape, Unread, operand
from .merged_record import TapeRecord
from .symbol_names import TIME, Names, Numbers, element_name, fields_of, groups, typeset
from .wiring import Node, Part, Wiring, read_anew, read_unsampled, wiring_of

# takes block.role, an operation and its arguments on symbols; returns a remark on it, or None
Watch = Callable[[str, str, tuple], str | None]
MOST_EQUATIONS = 40  # in one picture


@dataclass
class Equations:
    """A diagram's equations on symbols, by port.

    ``eq["y"]`` is the port y: an expression, or an array of them; ``eq["plant.gain"]`` a
    parameter.  A notebook shows the equations typeset.

    Attributes
    ----------
    states : dict of ndarray
        Symbols, by port.
    rates : dict of ndarray
        Time derivatives of the states; in discrete time, the next states.
    signals : dict of ndarray
        Outputs of blocks, in states, inputs and parameters.
    inputs : dict of ndarray
        Functions of time.
    jumps : dict of dict
        Block -> state -> its value after a jump at a breakpoint.
    parameters : dict of Parameters
        Block -> its parameters.
    fields : dict of ndarray
        Parameters, each by the name of its symbols.
    values : dict
        Symbol of a parameter -> its number, an exact rational.
    undefined : list of str
        Where there may be no value, in sentences.
    pinned : list of tuple
        Parameters, (block, name), that are numbers, because functions depend on their value.
    discrete : bool
        Whether time is discrete.
    periods : dict
        Sampled block -> its period; its `jumps` are its updates and what it samples.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> lag = clpt.Block("lag", update=lambda t, x, u, p: {"y": -p.k * x.y}, states={"y": 1},
    ...                  parameters={"k": 2.0})
    >>> clpt.equations(lag).derivative("y")
    -k*y
    """

    name: str
    states: dict[str, np.ndarray]
    signals: dict[str, np.ndarray]
    rates: dict[str, np.ndarray]
    jumps: dict[str, dict]
    inputs: dict[str, np.ndarray]
    parameters: dict[str, Any]
    fields: dict[str, np.ndarray]
    values: dict[Any, Any] = field(default_factory=dict)
    undefined: list[str] = field(default_factory=list)
    pinned: list[tuple[str, str]] = field(default_factory=list)
    discrete: bool = False
    periods: dict[str, float] = field(default_factory=dict)

    def __getitem__(self, name: str) -> Any:
        found = self.named.get(name)
        if found is None:
            known = ", ".join(self.named)
            raise DiagramError(f"{self.name}: has no '{name}'; it has {known}")
        return found.flat[0] if found.shape in ((), (1,)) else found

    @cached_property
    def named(self) -> dict[str, np.ndarray]:
        """All signals, inputs, states and parameters, by name."""
        return {**self.fields, **self.signals, **self.inputs, **self.states}

    @cached_property
    def motion(self) -> dict[Any, sympy.Expr]:
        """State's symbol -> its rate, in the diagram's order."""
        return {
            s: rate
            for port, own in self.states.items()
            for s, rate in zip(own.flat, self.rates[port].flat, strict=True)
        }

    @public
    def derivative(self, expression: sympy.Expr | str | float) -> sympy.Expr:
        """Differentiate an expression along the equations.

        It is of the states, or the name of a port of one signal.  Opaque functions and inputs are
        differentiated in time as well.
        """
        if self.discrete:
            raise DiagramError(f"{self.name}: is of discrete time, in which nothing has a rate")
        found = sympy.sympify(self[expression] if isinstance(expression, str) else expression)
        if not isinstance(found, sympy.Expr):
            raise DiagramError(f"{self.name}: {expression} is of several signals; give one of them")
        moving = {TIME: sympy.Integer(1), **self.motion}
        return sympy.Add(*(sympy.diff(found, s) * rate for s, rate in moving.items()))

    def jumps_at_once(self) -> Iterator[dict[Any, Any]]:
        """Yield state -> value after a jump, for each set that may jump."""
        for count in range(1, len(self.jumps) + 1):
            for together in combinations(self.jumps.values(), count):
                yield {s: new for one in together for s, new in one.items()}

    # --- how they are shown -----------------------------------------------------------------

    def _lines(self, print_as: Callable[[Any], str], rate: str, jump: str) -> Iterator[str]:
        """Yield the equations one by one: rates, signals that are no states, jumps."""
        next_or_rate = jump if self.discrete else rate
        sampled = {s for block in self.periods for s in self.jumps[block]}
        rows = [(next_or_rate, s, v) for s, v in self.motion.items() if s not in sampled]
        plain = {*self.motion, *(s for port in self.inputs.values() for s in port.flat)}
        for port, values in self.signals.items():
            for index, value in np.ndenumerate(values):
                if value not in plain:
                    name = element_name(port, values.shape, index)
                    rows.append(("{}", sympy.Symbol(name), value))
        for block, changes in self.jumps.items():
            each = f" (each {self.periods[block]:g})" if block in self.periods else ""
            rows += [(jump + each, s, new) for s, new in changes.items() if new != s]
        for form, s, value in rows[:MOST_EQUATIONS]:
            parts = extent(sympy.sympify(value))[0]
            right = print_as(value if parts <= LONG else sympy.Symbol(f"({parts} parts)"))
            yield f"{form.format(print_as(s))} = {right}"
        if len(rows) > MOST_EQUATIONS:
            yield f"... {len(rows) - MOST_EQUATIONS} more"

    def __repr__(self) -> str:
        return "\n".join(self._lines(str, "{}'", "{}+"))

    def _repr_latex_(self) -> str:
        lines = [
            line.replace(" = ", " &= ", 1) if " = " in line else r"\dots &= "
            for line in self._lines(typeset, r"\dot{{{}}}", "{}^{{+}}")
        ]
        return "$\\displaystyle\\begin{aligned}" + r" \\ ".join(lines) + "\\end{aligned}$"


class _Read:
    """The leaves of a diagram's record, and its equations on symbols."""

    def __init__(self, diagram: Any, wiring: Wiring, names: Names, hidden: Iterable[str]):
        self.diagram, self.wiring, self.names, self.hidden = diagram, wiring, names, set(hidden)
        self.tape, self.table = Tape(), dict[Any, Any]()
        self.result = Equations(diagram.name, {}, {}, {}, {}, {}, {}, {}, discrete=bool(wiring.dt))
        self.arguments: dict[Any, list[Any]] = {}  # of undefined functions
        # of states, by block and port
        self.symbols = {node.name: self.states_of(node) for node in wiring.nodes}

    def states_of(self, node: Node) -> dict[str, np.ndarray]:
        """Make the symbols of a block's states; return them by its own ports."""
        flat = np.empty(node.system.nstates, dtype=object)
        for group, at, shape in groups(node.system, "state"):
            port = self.names.port(node, group, "state")
            declared = node.system.declared["states"].get(group, shape)
            flat[at] = [
                sympy.Symbol(self.names.element(port, shape, declared, index), real=True)
                for index in np.ndindex(shape)
            ]
            self.result.states[port] = flat[at].reshape(shape)
        where = places(node.system.state_shapes)
        return {port: flat[own].reshape(shape) for port, (own, shape) in where.items()}

    def leaf(self, group: str, node: Node, name: str, shape: Shape) -> Any:
        """Return a state or a parameter of a block as an array."""
        symbols = self.symbols[node.name][name] if group == "x" else self.parameter(node, name)
        return self.array((group, (node.name, name)), symbols)

    def array(self, at: tuple, symbols: np.ndarray) -> Any:
        """Return a leaf of the tape that has these symbols."""
        self.table[at] = symbols
        return self.tape.add("leaf", (), symbols.shape, at)

    def parameter(self, node: Node, name: str) -> np.ndarray:
        """Return the symbols of a parameter."""
        value = np.asarray(getattr(node.system.parameters, name), dtype=float)
        symbols = np.empty(value.shape, dtype=object)
        for index in np.ndindex(value.shape):
            symbols[index] = self.names.parameter(node, name, value, index)
            if isinstance(symbols[index], sympy.Symbol) and name != "interval":
                self.result.values[symbols[index]] = rational(float(value[index]))
        return symbols

    def input_of(self, port: str, shape: Shape, declared: Shape) -> Any:
        """Return an input of the diagram as an array."""
        self.result.inputs[port] = self.functions(port, shape, declared)
        return self.array(("u", port), self.result.inputs[port])

    def functions(self, port: str, shape: Shape, declared: Shape, *of: Any) -> np.ndarray:
        """Return undefined functions of time, and of more."""
        functions = np.empty(shape, dtype=object)
        for index in np.ndindex(shape):
            name = self.names.element(port, shape, declared, index)
            functions[index] = sympy.Function(name, real=True)(TIME, *of)
        return functions

    def stand_in(self, node: Node, u: dict[str, Any], shapes: dict[str, Shape]) -> Any:
        """Return the outputs of a block that stays undefined; None of another."""
        if not (node.system.opaque or node.system.name in self.hidden):
            return None
        outputs = {}
        for port, shape in shapes.items():
            at = "o", (node.name, port)
            self.arguments[at] = [node, port, shape, list(u.values())]
            outputs[port] = self.tape.add("leaf", (), shape, at)
        return outputs

    def element(self, at: tuple, shape: Shape, index: tuple) -> Any:
        """Return the symbol of an element of a leaf."""
        if at[0] == "t":
            return TIME
        if at not in self.table:
            node, port, shape, fed = self.arguments[at]
            declared = node.system.declared["outputs"][port]
            of = [e for own in fed for e in self.elements.all_of(operand(own))]
            name = self.names.port(node, port, "output")
            self.table[at] = self.functions(name, shape, declared, *of)
        return self.table[at][index]

    def equations(self, watch: Watch) -> Equations:
        """Return the equations of the diagram."""
        result, names, wiring = self.result, self.names, self.wiring
        record = TapeRecord(
            self.diagram, wiring, self.leaf, self.input_of, self.tape, self.stand_in, closed=True
        )

        def watched(place: int, kind: str, arguments: tuple) -> None:
            owner = record.owners.get(place)
            if owner is not None and (remark := watch(owner, kind, arguments)):
                result.undefined.append(f"{owner} {remark}")

        self.elements = Symbols(self.tape.operations, self.element, watched)

        def flat(values: Mapping[Any, Any], node: Node, ports: Iterable[str]) -> np.ndarray:
            arrays = (self.elements.all_of(operand(values[node.name, port])) for port in ports)
            return np.array([*chain.from_iterable(arrays), None], dtype=object)[:-1]

        for node in wiring.nodes:
            system, block = node.system, names.block(node)
            for kind, made, shown in (
                ("output", record.signals, result.signals),
                ("state", record.rates, result.rates),
            ):
                values = flat(made, node, system.declared[f"{kind}s"])
                for group, at, shape in groups(system, kind):
                    shown[names.port(node, group, kind)] = values[at].reshape(shape)
            if system.jump_function is not None:
                symbols = np.concatenate([s.ravel() for s in self.symbols[node.name].values()])
                after = flat(record.jumps, node, system.declared["states"])
                result.jumps[block] = dict(zip(symbols, after, strict=True))
            if isinstance(system, Sampled):
                result.periods[block] = system.period
            fields: dict[str, Any] = {}
            for name in fields_of(system):
                value = getattr(system.parameters, name)
                fields[name] = value if isinstance(value, int) else self.parameter(node, name)[()]
                if name != "interval" and not is_linear(system):
                    symbol = names.port(node, name, "parameter")
                    result.fields[symbol] = np.asarray(fields[name], dtype=object)
            result.parameters[block] = Parameters(**fields)
        result.pinned = sorted(record.pinned)
        own = chain.from_iterable(ports.values() for ports in self.symbols.values())
        twice = [s for s, n in Counter(s for port in own for s in port.flat).items() if n > 1]
        if twice:
            raise DiagramError(f"{result.name}: two states are called {twice[0]}; rename one")
        return result


def on_symbols(
    diagram: Part,
    names: type[Names] = Names,
    hidden: Iterable[str] = (),
    watch: Watch = lambda owner, kind, arguments: None,
    with_samples: bool = False,
) -> Equations:
    """Return a diagram's equations as it is now; blocks named in `hidden` stay undefined functions.

    Functions that cannot be traced are refused, and sampled blocks unless `with_samples`.
    """
    wiring = read_unsampled(diagram) if not with_samples else wiring_of(diagram)
    try:
        own = names(wiring, ports_of(diagram.input_labels))
        return _Read(diagram, wiring, own, hidden).equations(watch)
    except Unread as error:
        raise DiagramError(f"{error}") from None


@public
def equations(system: control.NonlinearIOSystem, numbers: bool = False) -> Equations:
    """Return a diagram's equations: `clpt.equations(system)`.

    Parameters
    ----------
    system : control.NonlinearIOSystem
        A diagram, a block or a system of python-control: ``control.nlsys``, ``control.ss``.
    numbers : bool, optional
        Whether parameters are their numbers, as exact rationals; else they are symbols that have
        the signs of their values. Matrices of linear systems are numbers.

    Returns
    -------
    Equations
        States, rates, signals, inputs and jumps; ``eq["y"]`` is a port, ``eq.derivative(V)`` the
        derivative of an expression along the equations.

    Raises
    ------
    DiagramError
        If a function cannot be traced.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> def rate(t, x, u, params):
    ...     return -params["a"] * x[0] + u[0]
    >>> plant = control.nlsys(rate, inputs="u", outputs="y", states="y", params={"a": 2.0})
    >>> eq = clpt.equations(plant)
    >>> eq
    y' = -a*y + u(t)
    >>> eq.derivative(eq["y"] ** 2)
    2*y*(-a*y + u(t))
    """
    read_anew(system)
    return on_symbols(system, Numbers if numbers else Names, with_samples=True)
