"""Run a block's equations once on tracers, and keep the record.

The function's own code runs, with `math`, the words, `range`, `int` and `float`
meaning what they mean on tracers.  Everything else, from a tuple assignment to
the call of a helper, is Python's own.
"""

import math
import traceback
from collections import OrderedDict
from collections.abc import Callable
from types import FunctionType
from typing import Any

import numpy as np

from ..equations.scalars import Scalars
from ..errors import BlockError
from .functions import fingerprint, substituted, with_helpers
from .tracers import Condition, Number, Refused, Table, Tape, TooLong, operand, tracer_array
from .words import MATH, WORDS

LARGEST_ARRAY = 4096  # numbers; a longer parameter array can be read, not calculated with
KEPT = 1024  # records
_records: OrderedDict[Any, Scalars] = OrderedDict()


def trace(function: FunctionType, role: str, sizes: tuple[int, int, int], p: Any) -> Scalars:
    """Run equations ``f(t, x, u, p, out)`` on tracers and return the record.

    `sizes` are those of x, u and out.  Of p, whole numbers stay, of the rest the shapes count.
    The same code, sizes and shapes give the same record; `role` stands in messages.
    """
    shapes = tuple(value if isinstance(value, int) else np.shape(value) for value in p)
    key = (fingerprint(function), sizes, type(p), shapes)
    if key not in _records:
        _records[key] = _run(function, role, sizes, p)
        if len(_records) > KEPT:
            _records.popitem(last=False)
    _records.move_to_end(key)
    return _records[key]


def _run(function: FunctionType, role: str, sizes: tuple[int, int, int], p: Any) -> Scalars:
    tape = Tape()

    def leaves(name: tuple, size: int) -> list[int]:
        return [tape.add(*name, k).ref for k in range(size)]

    def parameter(field: str, value: Any) -> Any:
        if isinstance(value, int):
            return value
        shape, size = np.shape(value), np.size(value)
        if size > LARGEST_ARRAY:
            return Table(tape, field, np.arange(size).reshape(shape))
        return (
            tracer_array(tape, leaves(("p", field), size), shape)
            if shape
            else tape.add("p", field, 0)
        )

    try:
        t = tape.add("t")
        x, u = (
            tracer_array(tape, leaves((name,), n), (n,))
            for name, n in zip("xu", sizes, strict=False)
        )
        fields = getattr(p, "_fields", ())
        traced_p = type(p)(*(parameter(f, v) for f, v in zip(fields, p, strict=True)))
        out = tracer_array(tape, [0.0] * sizes[2], (sizes[2],))
        arrays = [x, u, *(value for value in traced_p if isinstance(value, np.ndarray))]
        before, unset = [list(array.flat) for array in arrays], list(out)
        substitutes = {**SUBSTITUTES, "range": tape.turns}
        given = substituted(function, substitutes, stand_in_for_opaque)(t, x, u, traced_p, out)
        if given is not None:
            raise Refused("returning a value", "fill the last argument: out[0] = ...")
        for array, held in zip(arrays, before, strict=True):
            if any(a is not b for a, b in zip(array.flat, held, strict=True)):
                raise Refused("changing states, inputs or parameters", "write the last argument")
        for k, value in enumerate(out):
            if value is unset[k]:
                raise BlockError(
                    f"never sets entry {k} of its last argument; set each, out[{k}] = 0.0 if it "
                    "is zero"
                )
        refs = tuple(operand(value) for value in out)
    except TooLong as error:
        raise TooLong(f"{role}: {error}") from None
    except Exception as error:  # whatever Python identity of these equations
        raise BlockError(f"{_place(error, function, role)}: {_sentence(error)}") from None
    return Scalars(tuple(tape.operations), refs, tuple(tape.marks))  # type: ignore[arg-type]


def _sentence(error: Exception) -> str:
    if isinstance(error, IndexError) and "only integers" in str(error):
        return str(Refused("a signal or parameter as an index", "use lookup(table, index)"))
    if isinstance(error, Refused | BlockError):
        return str(error)
    return f"cannot be run: {type(error).__name__}: {error}"


def _place(error: Exception, function: FunctionType, role: str) -> str:
    """Return the line of the block's own code at which an error was raised."""
    codes = {one.__code__ for one in with_helpers(function)}
    frames = traceback.walk_tb(error.__traceback__)
    lines = [line for frame, line in frames if frame.f_code in codes]
    return f"{role}, line {lines[-1]}" if lines else role


# --- words on tracers ---------------------------------------------------------------------


def _word(name: str, word: Callable) -> Callable:
    def traced(*arguments: Any) -> Any:
        tracer = next((a for a in arguments if isinstance(a, Number | Condition)), None)
        if tracer is None:
            return word(*arguments)
        refs = [operand(a) for a in arguments]
        if None in refs:
            raise Refused(f"`{name}` of something that is not a number", "use `for i in range(n)`")
        if len(refs) != COUNTS.get(name, 1):
            raise Refused(f"`{name}` of {len(refs)} numbers", f"it takes {COUNTS.get(name, 1)}")
        return tracer.tape.add(name, *refs)

    return traced


def _where(condition: Any, a: Any, b: Any) -> Any:
    if isinstance(condition, Number):
        raise Refused("`where` of a number", "give it a comparison, such as a > 0")
    if not isinstance(condition, Condition):
        return a if condition else b  # Python itself knows
    refs = operand(a), operand(b)
    if None in refs:
        raise Refused("`where` of something that is not a number", "use `for i in range(n)`")
    return condition.tape.add("where", condition.ref, *refs)


def _lookup(table: Any, index: Any) -> Any:
    """Scalars a choice among evenly spaced numbers of one parameter, or among any others."""
    if not isinstance(index, Number):
        return table[int(index)]
    shape = getattr(table, "shape", None)
    if len(np.shape(table) if shape is None else shape) != 1:
        raise Refused(
            "`lookup` in something that is not a row of numbers", "give an array of one dimension"
        )
    if isinstance(table, Table):
        field, places = table.field, table.places.ravel()
    else:
        refs = [operand(value) for value in np.ravel(np.asarray(table, dtype=object))]
        if None in refs or not refs:
            raise Refused("`lookup` in something that is not an array of numbers", "give an array")
        known = [index.tape.operations[r] if type(r) is int else () for r in refs]
        field = known[0][1] if known[0][:1] == ("p",) else ""
        if any(operation[:2] != ("p", field) for operation in known):
            return index.tape.add("pick", index.ref, *refs)
        places = np.array([operation[2] for operation in known])
    stride = int(places[1] - places[0]) if len(places) > 1 else 1
    if np.any(np.diff(places) != stride):
        raise Refused("`lookup` in numbers that are not evenly spaced", "give a slice")
    return index.tape.add("table", index.ref, (field, int(places[0]), stride, len(places)))


def stand_in_for_opaque(copy: FunctionType, helper: FunctionType) -> Callable:
    """Return what records a call of an opaque helper as one operation."""
    if not getattr(helper, "opaque", False):
        return copy

    def stand_in(*arguments: Any, **named: Any) -> Any:
        if named:
            raise Refused(
                f"`{helper.__name__}({', '.join(named)}=...)`",
                "an opaque helper takes its arguments by position",
            )
        tape = next((a.tape for a in arguments if hasattr(a, "tape")), None)
        if tape is None:
            return copy(*arguments)
        identity: list[Any] = [f"{helper.__module__}.{helper.__qualname__}"]
        refs: list[Any] = []
        for argument in arguments:
            if isinstance(argument, Table):
                identity.append((argument.field, *argument.places.ravel()[[0, 1, -1]].tolist()))
            elif isinstance(argument, np.ndarray):
                refs += [operand(value) for value in argument.flat]
            elif (ref := operand(argument)) is not None:
                refs.append(ref)
            else:
                raise Refused(
                    f"`{helper.__name__}` of a {type(argument).__name__}",
                    "an opaque helper takes numbers and arrays",
                )

        def hidden(k: int, value: Any) -> Any:
            if operand(value) is None:
                raise Refused(
                    f"`{helper.__name__}` returning a {type(value).__name__}",
                    "an opaque helper returns numbers, or fills an array",
                )
            return tape.add("opaque", (*identity, k), operand(value), *refs)

        held = [list(a.flat) if isinstance(a, np.ndarray) else [] for a in arguments]
        result = copy(*arguments)
        written = 0
        for array, before in zip(arguments, held, strict=True):
            for place, value in enumerate(before):
                if array.flat[place] is not value:
                    written += 1
                    array.flat[place] = hidden(-written, array.flat[place])
        if isinstance(result, tuple):
            return tuple(hidden(k, value) for k, value in enumerate(result))
        return None if result is None else hidden(0, result)

    return stand_in


class _Math:
    """The module `math` for tracers."""

    def __init__(self) -> None:
        for name in MATH:
            value = getattr(math, name)
            setattr(self, name, _word(name, value) if callable(value) else value)
        self.degrees, self.radians = _times(180.0 / math.pi), _times(math.pi / 180.0)

    def __getattr__(self, name: str) -> Any:
        raise Refused(f"`math.{name}`", f"use one of {', '.join(sorted(MATH))}")


def _times(factor: float) -> Callable:
    return lambda a: a * factor


def _int(a: Any) -> Any:
    return a.tape.add("trunc", a.ref) if isinstance(a, Number) else int(a)


def _float(a: Any) -> Any:
    if isinstance(a, Condition):
        return a.number()
    return a if isinstance(a, Number) else float(a)


COUNTS = {"minimum": 2, "maximum": 2, "clip": 3, "atan2": 2, "hypot": 2, "pow": 2}
SUBSTITUTES: dict[str, Any] = {
    **{name: _word(name, word) for name, word in WORDS.items()},
    "where": _where,
    "lookup": _lookup,
    "math": _Math(),
    "int": _int,
    "float": _float,
}
