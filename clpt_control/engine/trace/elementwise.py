"""Elementwise operations of tracer arrays, conversion to tracer arrays, and writing into arrays.

Truth values, whole numbers and Python's own numbers differ from other numbers, as in NumPy.
"""

import dis
import sys
from collections.abc import Iterable, Sequence
from functools import lru_cache, reduce
from types import CodeType
from typing import Any

import numpy as np

from ..record.graph import Shape, is_known
from ..record.operations import CONDITIONS, LOGICAL, NO_ROW, TABLE
from ..record.unread import Unread
from .arrays import (
    HOOKS,
    LASTING,
    REMEMBERS,
    Array,
    Tape,
    moves,
    objects,
    operand,
    whole,
)

TRUTH = np.dtype(bool)
TRUTHS_ALLOWED = CONDITIONS | {"where"}  # operations on truth values alone


def broadcast(*shapes: Shape) -> Shape:
    """Return the shape to which shapes are broadcast."""
    lengths = []
    for d in range(-max(map(len, shapes)), 0):
        longer = {shape[d] for shape in shapes if -d <= len(shape)} - {1}
        if len(longer) > 1:
            raise ValueError(
                f"operands could not be broadcast together with shapes {shapes}"
            )
        lengths.append(longer.pop() if longer else 1)
    return tuple(lengths)


def put(array: Array, index: Any, value: Any) -> None:
    """Write into an array, element by element."""
    root = array._root
    if root._fixed == LASTING:
        raise Unread(REMEMBERS.format(LASTING))
    if root._fixed or root._is_condition:
        target = (
            "truth values" if root._is_condition else "its states, inputs or parameters"
        )
        raise Unread(f"writes into {target}. Write into a copy")
    root._keep()
    store = array._written()
    assert store is not None
    value = lifted(array._tape, value)
    if definite(is_whole(root)):
        value = np.trunc(value) + 0.0
    if isinstance(index, Array) and index._is_condition:
        if moves(index):
            value = where(index, value, array)
            index = ...
        else:
            index = np.asarray(index)
    index = whole(index)
    new = objects(value)
    store[index] = new if isinstance(store[index], np.ndarray) else new.item()


def lifted(tape: Tape, value: Any) -> Any:
    """Return a number as a float, and an array or nested list as a tracer array."""
    if isinstance(value, Array):
        if value._tape is not tape:
            raise Unread("stores values between calls. Make them states")
        return value
    if isinstance(value, bool | int | float | np.bool_ | np.integer | np.floating):
        return float(value)
    if isinstance(value, np.ndarray):
        if type(value) not in (np.ndarray, np.memmap):
            raise Unread(
                f"calculating with a {type(value).__name__}. Write np.asarray of it"
            )
        if value.dtype != object:
            return constant(tape, value)
        if not value.ndim:
            return lifted(tape, value.item())
    try:
        if isinstance(value, str):  # each of its letters is a text again
            raise TypeError
        items = [lifted(tape, item) for item in value]
    except TypeError:
        raise Unread(f"calculating with a {type(value).__name__}") from None
    if not items:
        return constant(tape, np.asarray(value, dtype=float))
    new = stacked(tape, items)
    pairs = zip(items, value, strict=True)
    new._whole = all_of(
        is_whole(a if isinstance(a, Array) else number) for a, number in pairs
    )
    return new


def constant(tape: Tape, value: np.ndarray) -> Any:
    """Return an array of numbers; a single one is a float."""
    # ascontiguousarray would make an axis of a number
    value = np.asarray(value, order="C")
    if value.dtype.kind not in "fiub":
        raise Unread(f"calculating with an array of {value.dtype}")
    value = value.astype(float)
    return (
        tape.add("constant", (), value.shape, value.tobytes())
        if value.shape
        else float(value)
    )


def filled(tape: Tape, value: Any, shape: Shape) -> Any:
    """Return an array of a shape that holds one number everywhere."""
    if type(value) is float and is_known(shape):
        return constant(tape, np.full(shape, value))
    return tape.add("fill", (operand(value),), shape)


def spread(tape: Tape, value: Any, shape: Shape) -> Any:
    """Return a value broadcast to a shape."""
    old_shape = getattr(value, "shape", ())
    if old_shape == shape:
        return value
    filled_value = tape.add("fill", (0.0 if old_shape else operand(value),), shape)
    return elementwise("add", filled_value, value) if old_shape else filled_value


def stacked(tape: Tape, items: Sequence[Any]) -> Any:
    """Return arrays of one shape along a new first axis."""
    shapes = {getattr(item, "shape", ()) for item in items}
    if len(shapes) > 1:
        raise ValueError(
            f"all input arrays must have the same shape, not {sorted(map(str, shapes))}"
        )
    if not all(map(is_truth, items)):
        items = [as_number(item) for item in items]
    refs = [operand(item) for item in items]
    if all(type(ref) is float for ref in refs):
        return constant(tape, np.array(refs))
    return HOOKS["stack_of"](tape, refs, shapes.pop())


def elementwise(name: str, *arguments: Any) -> Any:
    """Return an elementwise operation of arrays and numbers."""
    tape = next(a._tape for a in arguments if isinstance(a, Array))
    row = TABLE.get(name, NO_ROW)
    # kinds of numbers
    if name not in TRUTHS_ALLOWED and all(map(is_truth, arguments)):
        if not row.on_truths:
            raise Unread(
                "calculates with truth values alone, of which NumPy and Python make different "
                "things. Write float(...), or np.logical_or"
            )
        name = row.on_truths
        row = TABLE[name]
    of_python = row.operator and all_of(map(is_of_python, arguments))
    if row.raises and of_python is not False:
        raise_in_a_try(name, *arguments)
    # operands
    refs = []
    shapes = set()
    for k, argument in enumerate(arguments):
        convert = (
            as_condition
            if name in LOGICAL or (name == "where" and not k)
            else as_number
        )
        argument = (
            argument if type(argument) is float else convert(lifted(tape, argument))
        )
        if isinstance(argument, Array):
            shapes.add(argument.shape)
        refs.append(operand(argument))
    shape = shapes.pop() if len(shapes) == 1 else broadcast(*shapes)
    new = tape.add(name, refs, shape)
    new._of_python = of_python
    is_inverse = (  # a power with a constant negative exponent
        name == "pow"
        and not isinstance(arguments[1], Array)
        and np.any(arguments[1] < 0)
    )
    if row.whole and not is_inverse:
        new._whole = all_of(
            map(is_whole, arguments[1:] if name == "where" else arguments)
        )
    return new


def all_of(kinds: Iterable[bool | None]) -> bool | None:
    """Return whether all are true; None if that depends on a branch."""
    answers = {*kinds}
    if False in answers:
        return False
    return None if None in answers else True


def definite(kind: bool | None) -> bool:
    """Return a kind of number that Python or NumPy depends on; refuse an unknown one."""
    if kind is None:
        raise Unread("the type of a number depends on a branch. Write float(...)")
    return kind


def is_of_python(value: Any) -> bool | None:
    """Return whether a number is Python's own; None if that depends on a branch."""
    if isinstance(value, Array):
        return value._of_python
    return type(value) in (int, float, bool)


def is_whole(value: Any) -> bool | None:
    """Return whether NumPy's type is int or bool; None if that depends on a branch."""
    if isinstance(value, Array):
        return value._is_condition or value._whole
    kind = getattr(getattr(value, "dtype", None), "kind", "f")
    return isinstance(value, int) or kind in "iub"


def as_numpy_number(number):
    """Return an element of an array as a number of NumPy."""
    if not isinstance(number, Array):
        return np.float64(number) if is_of_python(number) else number
    if number._of_python is False:
        return number
    new = Array(number._tape, number._ref, ())
    new._whole = number._whole
    return new


def of_python(number, is_int=False):
    """Return a number as one of Python's: a float, or a whole one, which is never -0.

    A truth value stays one.
    """
    if not isinstance(number, Array) or number.shape:
        return number
    is_int = is_int and not number._is_condition
    new = Array(number._tape, (number + 0.0 if is_int else number)._ref, ())
    new._of_python = True
    new._whole = is_int
    return new


def chosen(condition, a, b):
    """Return the number of a branch, a or b, with its kind of number."""
    new = where(condition, a, b)
    if (
        isinstance(condition, Array)
        and isinstance(new, Array)
        and not new._is_condition
    ):
        new._whole = common(map(is_whole, (a, b)))
        new._of_python = common(map(is_of_python, (a, b)))
    return new


def common(kinds: Iterable[bool | None]) -> bool | None:
    """Return the common kind of numbers; None if their kinds differ."""
    distinct = {*kinds}
    return distinct.pop() if len(distinct) == 1 else None


# errors of Python's floats and `math`: the error, and its condition on the arguments
ERRORS: dict[str, tuple[type[Exception], Any]] = {
    **dict.fromkeys(
        ("div", "floordiv", "mod"), (ZeroDivisionError, lambda a, b: b == 0.0)
    ),
    **dict.fromkeys(("log", "log2", "log10"), (ValueError, lambda a, *b: a <= 0.0)),
    **dict.fromkeys(("asin", "acos"), (ValueError, lambda a: np.fabs(a) > 1.0)),
    "sqrt": (ValueError, lambda a: a < 0.0),
    "atanh": (ValueError, lambda a: np.fabs(a) >= 1.0),
    "exp": (OverflowError, lambda a: (np.exp(a) == np.inf) & (a < np.inf)),
}


def raise_in_a_try(name: str, *arguments: Any) -> None:
    """Raise on the execution paths on which Python's own numbers raise.

    This is needed only if the function may catch the error.  Otherwise the path gives NaN.
    """
    if not in_a_try() or not any(
        moves(argument) or not np.all(argument) for argument in arguments
    ):
        return
    raises = TABLE.get(name, NO_ROW).raises  # else a function of `math`
    kinds = all_of(map(is_of_python, arguments)) if raises else True
    if kinds is None or name not in ERRORS:
        refuse_in_a_try()
    error, condition = ERRORS[name]
    if condition(*arguments):
        raise error(f"{name} out of range")


def refuse_in_a_try() -> None:
    """Refuse an operation that may raise an error in a `try`."""
    raise Unread("may raise in a `try`. Test with `if` before")


TRACING = f"{__package__}.tracing"  # module that calls the traced function
# errors that they catch they raise again
OWN = (__package__.rpartition(".")[0], "numpy")


def in_a_try() -> bool:
    """Return whether the traced function may catch an error that is raised now."""
    frame = sys._getframe(1)
    while frame is not None and (module := frame.f_globals.get("__name__")) != TRACING:
        if not (module or "").startswith(OWN) and _catches(frame.f_code):
            return True
        frame = frame.f_back  # type: ignore[assignment]
    return False


@lru_cache(maxsize=1024)
def _catches(code: CodeType) -> bool:
    """Return whether code has a `try` or a `with`.

    Generators and comprehensions have handlers of Python's own, which only pass on what is raised.
    """
    return any(line.opname == "PUSH_EXC_INFO" for line in dis.get_instructions(code))


def as_number(value):
    """Return truth values as 1 and 0; any other value as it is."""
    if isinstance(value, Array) and value._is_condition:
        return value._tape.add("where", (value._ref, 1.0, 0.0), value.shape)
    return value


def as_condition(value):
    """Return numbers as conditions: number != 0."""
    if isinstance(value, Array) and not value._is_condition:
        return elementwise("ne", value, 0.0)
    return value


def is_truth(value: Any) -> bool:
    """Return whether a value is a truth value, or an array of them."""
    if isinstance(value, Array):
        return value._is_condition
    return isinstance(value, bool | np.bool_) or getattr(value, "dtype", None) == TRUTH


def boxed(tape: Tape, value: Any) -> Any:
    """Return a number as an array without axes: ``+=`` changes it by each name that it has."""
    if type(value) is float:
        value = tape.add("fill", (value,), ())
    if (
        not isinstance(value, Array)
        or value.shape
        or value._boxed
        or value._is_condition
    ):
        return value
    new = Array(tape, value._node, ())
    new._boxed = True
    new._whole = value._whole
    return new


def where(condition, a, b):
    """Return a where a condition holds, else b."""
    if not isinstance(condition, Array) and not np.ndim(condition):
        return a if condition else b
    if is_truth(a) and is_truth(b):
        condition = as_condition(condition)
        terms: Any = [_and(condition, a), _and(np.logical_not(condition), b)]
        terms_left = [term for term in terms if term is not None]
        return reduce(np.logical_or, terms_left) if terms_left else False
    return elementwise("where", condition, a, b)


def _and(condition: Any, truth: Any) -> Array | None:
    """Return whether both hold; None for never."""
    if isinstance(truth, Array) or np.ndim(truth):
        return np.logical_and(condition, truth)
    return condition if truth else None


def total(array: Array, axis: int) -> Any:
    """Return the sum over one axis."""
    counted = is_whole(array)
    array = as_number(array)
    axis %= array.ndim
    shape = array.shape[:axis] + array.shape[axis + 1 :]
    new = array._tape.add("sum", (array._ref,), shape, axis)
    new._whole = counted
    return new


HOOKS.update(elementwise=elementwise, lifted=lifted, put=put)
