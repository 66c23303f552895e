"""Symbolic equations of a diagram, computed from its record.

    y' = -a y + b u            eq.rates["y"], eq["a"], eq.derivative(eq["y"] ** 2)

`symbol_names` has the rules for names of states, inputs and parameters.
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

from ...base.arguments import public
from ...base.errors import DiagramError
from ..model.declaration import Parameters
from ..model.ports import places, ports_of
from ..model.sampled import Sampled
from ..model.system import is_linear
from ..record.graph import Shape
from ..record.guards import branches_of, guarded
from ..record.symbolic import LONG, Symbols, extent, rational
from ..record.unread import Unread
from ..trace.arrays import Tape, operand
from .block_numbers import Params
from .merged_record import TapeRecord
from .symbol_names import TIME, Names, NamesWithNumbers, element_name, fields_of, groups
from .typesetting import in_lines, typeset, with_equations
from .wiring import Node, Part, Wiring, read_anew, wiring_of

# watch("block.role", operation, its arguments on symbols) returns a remark or None
Watch = Callable[[str, str, tuple], str | None]
MOST_EQUATIONS = 40  # shown


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
        Block -> state -> its value after a jump at a breakpoint or level.
    parameters : dict of Parameters
        Block -> its parameters.
    fields : dict of ndarray
        Parameters, each by the name of its symbols.
    values : dict
        Symbol of a parameter -> its number, an exact rational.
    undefined : list of str
        Sentences on operations that may have no value.
    pinned : list of tuple
        Parameters, (block, name), that are numbers, because functions depend on their value.
    discrete : bool
        True for discrete time.
    periods : dict
        Sampled block -> its period; its `jumps` are its updates and its samples.
    levels : dict
        Block -> distance of its guard; its states jump where the distance falls to 0.

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
    levels: dict[str, Any] = field(default_factory=dict)
    order: list[Any] = field(default_factory=list)  # symbols of states

    def __getitem__(self, name: str) -> Any:
        if name not in self.named:
            known_names = ", ".join(self.named)
            raise DiagramError(f"{self.name}: has no '{name}'; it has {known_names}")
        symbols = self.named[name]
        return symbols.flat[0] if symbols.shape in ((), (1,)) else symbols

    @cached_property
    def named(self) -> dict[str, np.ndarray]:
        """All signals, inputs, states and parameters, by name."""
        return self.fields | self.signals | self.inputs | self.states

    @cached_property
    def motion(self) -> dict[Any, sympy.Expr]:
        """State's symbol -> its rate, in the diagram's order."""
        motion: dict[Any, sympy.Expr] = {}
        for port, symbols in self.states.items():
            motion.update(zip(symbols.flat, self.rates[port].flat, strict=True))
        return {s: motion[s] for s in self.order or motion}

    @public
    def derivative(self, expression: sympy.Expr | str | float) -> sympy.Expr:
        """Differentiate an expression along the equations.

        The expression has the states as symbols, or is the name of a port of one signal.  Opaque
        functions and inputs are differentiated with respect to time as well.
        """
        if self.discrete:
            raise DiagramError(
                f"{self.name}: is of discrete time, so its states have no rates"
            )
        value = self[expression] if isinstance(expression, str) else expression
        value = sympy.sympify(value)
        if not isinstance(value, sympy.Expr):
            raise DiagramError(
                f"{self.name}: {expression} has several signals. Give one of them"
            )
        rates = {TIME: sympy.Integer(1), **self.motion}
        terms = [sympy.diff(value, s) * rate for s, rate in rates.items()]
        return sympy.Add(*terms)

    def jumps_at_once(self) -> Iterator[dict[Any, Any]]:
        """Yield state -> value after a jump, for each set of blocks."""
        for count in range(1, len(self.jumps) + 1):
            for blocks in combinations(self.jumps.values(), count):
                yield {s: value for jump in blocks for s, value in jump.items()}

    # --- text and LaTeX ---------------------------------------------------------------------

    def _rows(self) -> Iterator[tuple[str, str, Any, Any, Any]]:
        """Yield mark, period, symbol, value, level: of rates, signals that are no states, jumps."""
        sampled = {s for block in self.periods for s in self.jumps[block]}
        for s, value in self.motion.items():
            if s not in sampled:
                yield "+" if self.discrete else "'", "", s, value, None
        inputs = {s for symbols in self.inputs.values() for s in symbols.flat}
        for port, values in self.signals.items():
            for index, value in np.ndenumerate(values):
                if value not in self.motion and value not in inputs:
                    name = element_name(port, values.shape, index)
                    yield "", "", sympy.Symbol(name), value, None
        for block, changes in self.jumps.items():
            period = f" (each {self.periods[block]:g})" if block in self.periods else ""
            for s, value in changes.items():
                if value != s:
                    yield "+", period, s, value, self.levels.get(block)

    def _lines(
        self,
        print_as: Callable[[Any], str],
        left_side: Callable[[Any, str], str],
        at: str = "at",
    ) -> Iterator[str]:
        """Yield the equations as text."""
        rows = [*self._rows()]
        for mark, period, s, value, level in rows[:MOST_EQUATIONS]:
            size, _ = extent(sympy.sympify(value))
            if size > LONG:
                value = sympy.Symbol(f"({size} parts)")
            where = "" if level is None else f" {at} {print_as(level)} = 0"
            yield f"{left_side(s, mark)}{period} = {print_as(value)}{where}"
        if len(rows) > MOST_EQUATIONS:
            yield f"... {len(rows) - MOST_EQUATIONS} more"

    def __repr__(self) -> str:
        def as_text(expression: Any) -> str:
            return str(with_equations(sympy.sympify(expression)))

        return "\n".join(self._lines(as_text, lambda symbol, mark: f"{symbol}{mark}"))

    def latex(self) -> str:
        r"""Return the equations as LaTeX, an `aligned` environment.

        Examples
        --------
        >>> import control
        >>> import clpt_control as clpt
        >>> print(clpt.equations(control.ss(-1, 1, 1, 0, name="lag")).latex())
        \begin{aligned}\dot{x} &= u - x\end{aligned}
        """
        lines = []
        for line in self._lines(typeset, _left_side, r"\text{ at }"):
            left, equals, right = line.partition(" = ")
            lines.append(f"{left} &= {in_lines(right)}" if equals else r"\dots &= ")
        return "\\begin{aligned}" + r" \\ ".join(lines) + "\\end{aligned}"

    def _repr_latex_(self) -> str:
        return f"$\\displaystyle{self.latex()}$"


def _left_side(symbol: Any, mark: str) -> str:
    """Return a symbol as LaTeX with its mark: a dot of a rate, a plus of a next value."""
    if mark == "'":
        return typeset(symbol, r"\dot{{{}}}")
    text = typeset(symbol)
    if mark:
        return (f"{{{text}}}" if "^" in text else text) + "^{+}"
    return text


class _SymbolicRecord:
    """A diagram's record with symbols for its leaves, and its equations."""

    def __init__(
        self, diagram: Any, wiring: Wiring, names: Names, hidden: Iterable[str]
    ):
        self.wiring = wiring
        self.names = names
        self.hidden = set(hidden)
        self.tape = Tape()
        self.table: dict[Any, Any] = {}  # leaf -> symbols
        self.result = Equations(
            diagram.name, {}, {}, {}, {}, {}, {}, {}, discrete=bool(wiring.dt)
        )
        self.undefined_functions: dict[
            Any, tuple
        ] = {}  # leaf -> node, port, shape, inputs
        # states by block
        self.symbols = {node.name: self._states_of(node) for node in wiring.nodes}
        self.record = TapeRecord(
            diagram, wiring, self.tape, stand_in=self._stand_in, closed=True
        )
        for port, array in self.record.external.items():
            functions = self._functions(port, array.shape, self.record.declared[port])
            self.result.inputs[port] = self.table["u", port] = functions
        for key, (node, name, _) in self.record.leaves.items():
            if key[0] == "p":
                self.table[key] = self._parameter(node, name)
            else:
                signals, shape = places(node.system.state_shapes)[name]
                self.table[key] = self.symbols[node.name][signals].reshape(shape)

    # --- symbols of leaves ------------------------------------------------------------------

    def _states_of(self, node: Node) -> np.ndarray:
        """Return new symbols of a block's states."""
        block = node.system
        symbols = np.empty(block.nstates, dtype=object)
        for name, indices, shape in groups(block, "state"):
            port = self.names.port(node, name, "state")
            declared = block.declared["states"].get(name, shape)
            for k, index in zip(indices, np.ndindex(shape), strict=True):
                element = self.names.element(port, shape, declared, index)
                symbols[k] = self.names.state(element)
            self.result.states[port] = symbols[indices].reshape(shape)
        return symbols

    def _parameter(self, node: Node, name: str) -> np.ndarray:
        """Return the symbols of a parameter."""
        value = np.asarray(getattr(node.system.parameters, name), dtype=float)
        symbols = np.empty(value.shape, dtype=object)
        for index in np.ndindex(value.shape):
            symbol = self.names.parameter(node, name, value, index)
            symbols[index] = symbol
            if isinstance(symbol, sympy.Symbol) and name != "interval":
                self.result.values[symbol] = rational(float(value[index]))
        return symbols

    def _functions(
        self, port: str, shape: Shape, declared: Shape, *inputs: Any
    ) -> np.ndarray:
        """Return undefined functions of time and of inputs."""
        functions = np.empty(shape, dtype=object)
        for index in np.ndindex(shape):
            name = self.names.element(port, shape, declared, index)
            functions[index] = sympy.Function(name, real=True)(TIME, *inputs)
        return functions

    def _stand_in(self, node: Node, u: dict[str, Any], shapes: dict[str, Shape]) -> Any:
        """Return the outputs of a block that is an undefined function; None for other blocks."""
        if not (node.system.opaque or node.system.name in self.hidden):
            return None
        outputs = {}
        for port, shape in shapes.items():
            key = "o", (node.name, port)
            self.undefined_functions[key] = node, port, shape, [*u.values()]
            outputs[port] = self.tape.add("leaf", (), shape, key)
        return outputs

    def _element(self, key: tuple, shape: Shape, index: tuple) -> Any:
        """Return the symbol of an element of a leaf."""
        if key[0] == "t":
            return TIME
        if key not in self.table:
            node, port, shape, arrays = self.undefined_functions[key]
            declared = node.system.declared["outputs"][port]
            inputs = [
                e for array in arrays for e in self.elements.all_of(operand(array))
            ]
            name = self.names.port(node, port, "output")
            self.table[key] = self._functions(name, shape, declared, *inputs)
        return self.table[key][index]

    # --- equations ----------------------------------------------------------------------------

    def equations(self, watch: Watch) -> Equations:
        """Return the equations of the diagram."""
        result = self.result

        def watched(index: int, kind: str, arguments: tuple) -> None:
            owner = self.record.owners.get(index)
            if owner is None:
                return
            remark = watch(owner, kind, arguments)
            if remark and not self._has_value(index, arguments, owner, kind, watch):
                result.undefined.append(f"{owner} {remark}")

        self.elements = Symbols(self.tape.operations, self._element, watched)
        for node in self.wiring.nodes:
            self._add_signals(node)
            self._add_parameters(node)
        result.pinned = sorted(self.record.pinned)
        counts = Counter(chain(*self.symbols.values()))
        for symbol, count in counts.items():
            if count > 1:
                raise DiagramError(
                    f"{result.name}: two states are called {symbol}. Rename one"
                )
        result.order = [*counts]
        return result

    @cached_property
    def _ways(self) -> list[set]:
        """Branches on each way of an operation to the outputs."""
        values = self.record.signals, self.record.rates, self.record.jumps
        outputs = [operand(value) for of in values for value in of.values()]
        return branches_of(self.tape.operations, outputs)

    def _has_value(
        self, index: int, arguments: tuple, owner: str, kind: str, watch: Watch
    ) -> bool:
        """Return whether an operation has a value in each branch in which it is used."""
        operations = self.tape.operations
        ways = self._ways[index]
        for branches in ways:
            conditions = [
                (self.elements.at(condition, ()), truth)
                for condition, truth in branches
                if not operations[condition].shape
            ]
            if watch(owner, kind, guarded(arguments, conditions)):
                return False
        return bool(ways)

    def _add_signals(self, node: Node) -> None:
        """Add the signals, rates and jumps of a block."""
        system = node.system
        result = self.result
        for kind, values, expressions in (
            ("output", self.record.signals, result.signals),
            ("state", self.record.rates, result.rates),
        ):
            elements = self._elements_of(values, node)
            for name, indices, shape in groups(system, kind):
                port = self.names.port(node, name, kind)
                expressions[port] = elements[indices].reshape(shape)
        block = self.names.block(node)
        if system.jump_function is not None:
            elements = self._elements_of(self.record.jumps, node)
            states = self.symbols[node.name]
            result.jumps[block] = dict(zip(states, elements, strict=True))
        if system.jumps_at_level:
            (result.levels[block],) = self._elements_of(self.record.levels, node)
        if isinstance(system, Sampled):
            result.periods[block] = system.period

    def _elements_of(self, values: Mapping[Any, Any], node: Node) -> np.ndarray:
        """Return the elements of the ports of a block that have values."""
        elements = []
        for (name, _), value in values.items():
            if name == node.name:
                elements += self.elements.all_of(operand(value))
        flat = np.empty(len(elements), dtype=object)
        flat[:] = elements
        return flat

    def _add_parameters(self, node: Node) -> None:
        fields = {}
        for name in fields_of(node.system):
            value = getattr(node.system.parameters, name)
            if not isinstance(value, int):
                value = self._parameter(node, name)[()]
            fields[name] = value
            if name != "interval" and not is_linear(node.system):
                port = self.names.port(node, name, "parameter")
                self.result.fields[port] = np.asarray(fields[name], dtype=object)
        self.result.parameters[self.names.block(node)] = Parameters(**fields)


def on_symbols(
    diagram: Part,
    names: type[Names] = Names,
    hidden: Iterable[str] = (),
    watch: Watch = lambda owner, kind, arguments: None,
    with_samples: bool = False,
    params: Params = None,
) -> Equations:
    """Return a diagram's equations as it is now; blocks named in `hidden` are undefined functions.

    `params` are those of a call.  Functions that cannot be traced are refused, and sampled blocks
    unless `with_samples`.
    """
    read_anew(diagram)
    wiring = wiring_of(diagram, params)
    for node in wiring.nodes:
        if isinstance(node.system, Sampled) and not with_samples:
            raise DiagramError(
                f"{node.name}: samples its inputs. Give the design that it was sampled from"
            )
    try:
        diagram_names = names(wiring, ports_of(diagram.input_labels))
        return _SymbolicRecord(diagram, wiring, diagram_names, hidden).equations(watch)
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
        True for parameters as numbers, exact rationals. By default they are symbols that have the
        signs of their values. Matrices of linear systems are numbers.

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
    return on_symbols(system, NamesWithNumbers if numbers else Names, with_samples=True)
