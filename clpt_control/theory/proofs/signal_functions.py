"""Functions of a diagram's signals as expressions: `lambda s: s.e @ s.e/2`, a V or a claim."""

import re
from collections import Counter
from collections.abc import Callable
from typing import Any

import control
import numpy as np
import sympy
from sympy import Expr
from sympy.core.function import AppliedUndef

from ...base.arguments import known
from ...base.errors import BlockError, DiagramError
from ...engine.diagram.interconnection import by_name
from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations, on_symbols
from ...engine.model.block import Block
from ...engine.model.ports import places
from ...engine.record.symbolic import Symbols
from ...engine.record.unread import check_call
from ..algebra.numeric_values import NO_VALUE
from .symbolic_loop import no_value

LARGE = ("exp", "expm1", "sinh", "cosh")  # have a value wherever it is a number


def undefined_in(owner: str, kind: str, arguments: tuple) -> str | None:
    """Return where an operation has no value; one whose value may be too large has one."""
    sentence = no_value(owner, kind, arguments)
    return None if kind in LARGE else sentence


class _Signals:
    """Signals of a diagram, which have names: s.x, s["x"], and no positions."""

    def __init__(self, owner: str, ports: Any, values: Any):
        self._owner, self._ports, self._values = owner, ports, values

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") and name not in self._ports:  # NumPy asks for these
            raise AttributeError(name)
        return self._value(name, f".{name}")

    def __getitem__(self, name: Any) -> Any:
        return self._value(name, f"[{name!r}]")

    def _value(self, name: Any, written: str) -> Any:
        if name in self._ports:
            return self._values[name]
        names = ", ".join(f"s.{name}" for name in self._ports)
        raise DiagramError(
            f"{self._owner}: a function of signals asks for s{written}. It has {names}"
        )


def signals_by_name(eq: Equations) -> dict[str, np.ndarray]:
    """Return the symbols that a function of signals may ask for, by name: s.plant_x, s.t."""
    names = {name: name.replace(".", "_") for name in eq.named}
    counts = Counter(names.values())
    for name, identifier in names.items():
        if name != identifier and counts[identifier] > 1:
            clash = f"{name} and {identifier} are both s.{identifier}"
            raise DiagramError(
                f"{eq.name}: {clash} in a function of signals. Rename one"
            )
    symbols = {names[name]: symbols for name, symbols in eq.named.items()}
    allowed = {name: symbols[name] for name in symbols if name.isidentifier()}
    return allowed | {"t": np.array(TIME)}


def function_of_signals(system: Any, V: Any) -> Any:
    """Return an expression in the symbols of `clpt.equations` as a function of signals."""
    if not isinstance(V, Expr):
        return V
    signals = signals_by_name(on_symbols(system, with_samples=True))
    indices = {
        symbol: (name, k)
        for name, symbols in signals.items()
        for k, symbol in enumerate(symbols.flat)
        if symbol.is_Symbol or isinstance(symbol, AppliedUndef)
    }
    if unknown := V.free_symbols - indices.keys():
        raise DiagramError(
            f"{system.name}: has no {unknown.pop()} as clpt.equations has symbols; it has "
            f"{', '.join(map(str, indices))}"
        )
    run = sympy.lambdify([*indices], V, "numpy")
    return lambda s: run(*(np.ravel(s[name])[k] for name, k in indices.values()))


def expression_of(
    eq: Equations, source: Any, argument: str = "V"
) -> tuple[Expr, list[str]]:
    """Return a name, a function of signals or an expression as an expression.

    With it the sentences on where it may have no value.
    """
    if callable(source):
        value, undefined = _traced(eq, source)
        if value.has(*NO_VALUE):
            raise DiagramError(
                f"{eq.name}: a function of signals is NaN or infinite. "
                "Return a number that is finite"
            )
        return value, undefined
    if isinstance(source, str) and source not in eq.named:
        names = "|".join(signals_by_name(eq))
        formula = re.sub(rf"\b({names})\b", r"s.\1", source)
        advice = f"Give a function in NumPy: lambda s: {formula}"
        advice = known(source, eq.named) if formula == source else advice
        raise DiagramError(
            f"{eq.name}: {argument} = '{source}': is no signal. {advice}"
        )
    value = sympy.sympify(eq[source] if isinstance(source, str) else source)
    if not isinstance(value, Expr):
        raise DiagramError(f"{eq.name}: {source} is not a single number")
    return value, []


def expressions_of(
    eq: Equations, source: Callable[[Any], Any]
) -> list[tuple[Expr, list[str]]]:
    """Return a function of signals that returns a list as expressions, as `expression_of`."""
    sizes = [1]

    def element(k: int) -> Callable[[Any], Any]:
        def value(s: Any) -> Any:
            of = source(s)
            parts = of if isinstance(of, list | tuple) else [of]
            if of is None or not parts:
                raise DiagramError(
                    f"{eq.name}: keeps returns {of}. Return functions of states"
                )
            values = np.concatenate([np.ravel(part) for part in parts])
            sizes.append(len(values))
            return values[k]

        return value

    first = expression_of(eq, element(0))
    return [first, *(expression_of(eq, element(k)) for k in range(1, sizes[-1]))]


def _traced(eq: Equations, source: Callable[[Any], Any]) -> tuple[Expr, list[str]]:
    """Return a function of signals as an expression, and where it may have no value."""
    signals, undefined = signals_by_name(eq), list[str]()
    ports = places({name: symbols.shape for name, symbols in signals.items()})
    elements = [s for symbols in signals.values() for s in symbols.flat]
    shapes = []  # of V

    def refuse_no_number(value: Any) -> None:
        if value is None or isinstance(value, control.InputOutputSystem):
            raise DiagramError(
                f"{eq.name}: V is a function of signals here, "
                "lambda s: s.e @ s.e/2, which returns a number and no block"
            )

    refuse_no_number(source)
    needs = "a function of signals takes one argument: lambda s: s.x**2"
    check_call(source, DiagramError, 1, f"{eq.name}: {needs}")

    def level(u: Any) -> Any:
        try:
            value = source(_Signals(eq.name, ports, by_name(u.s, ports)))
        except AttributeError as error:  # a V of prove asks the truth for its fields
            if "_asdict" not in f"{error}":
                raise
            value = None
        refuse_no_number(value)
        shapes.append(np.shape(value))
        return value

    try:
        block = Block(
            "V",
            output=lambda t, x, u, p: {"V": level(u)},
            inputs={"s": len(elements)},
            outputs={"V": 1},
        )
        record = block.array_record("output")
    except BlockError as error:
        if isinstance(error.__cause__, DiagramError):
            raise error.__cause__ from None
        if np.prod(shapes[-1:]) <= 1:
            raise
        sizes = [f"s.{name} {symbols.shape}" for name, symbols in signals.items()]
        raise DiagramError(
            f"V: has shape {shapes[-1]}; must be one number. "
            f"{eq.name} has {', '.join(sizes)}"
        ) from None

    def watch(index: int, kind: str, arguments: tuple) -> None:
        if sentence := undefined_in("V", kind, arguments):
            undefined.append(f"V {sentence}")

    def leaf(key: tuple, shape: tuple, index: tuple) -> Any:
        return elements[index[0]]

    (V,) = Symbols(record.operations, leaf, watch, block.sizes).outputs(record)
    return V, undefined
