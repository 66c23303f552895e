"""Checks of the arguments of public functions against their annotations.

`@public` on a function or class reads its annotations.  An argument of another kind raises an
`ArgumentError` with one sentence: the function, the argument, its value, the allowed kinds and a
remedy.  Some values are converted: an array without dimensions becomes its number, an iterator a
list, and a list an array or a tuple if the annotation has one.
"""

import difflib
import os
import re
import reprlib
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cache, update_wrapper
from inspect import Signature, signature
from itertools import zip_longest
from numbers import Integral, Real
from types import FunctionType, NoneType, UnionType
from typing import Annotated, Any, ForwardRef, TypeVar, Union, get_args, get_origin

import numpy as np
from numpy.typing import ArrayLike

from .errors import ArgumentError

Public = TypeVar("Public", bound=Callable)
Kinds = tuple[Any, ...]  # alternatives for one argument
OrNaN = Annotated[float, "NaN where it is not known"]
Seed = Annotated[int, "0 or more"]
Count = Annotated[int, "1 or more"]
Positive = Annotated[float, "positive and finite"]
LISTS = (Sequence, Iterable, list)
MOST_MEMBERS = 100  # longer lists are not searched for masked arrays
MOST_SHOWN = 9  # numbers of an array in a message
PLAIN = (str, bytes, bool, int, float, complex, list, tuple, set, dict)
NUMBERS = {float, int}
SIMPLE = {float, int, str, bool, NoneType}
EMPTY = np.dtype("V")
SHORT = reprlib.Repr()
SHORT.maxstring = SHORT.maxother = 60
NOUNS = {
    "float": "a number",
    "int": "a whole number",
    "str": "a text",
    "bool": "True or False",
    "NoneType": "None",
    "ndarray": "an array of numbers",
    "Dataset": "an xarray.Dataset",
    "NonlinearIOSystem": "a diagram",
    "InputOutputSystem": "a diagram",
    "Callable": "a function",
    "Path": "a path",
    "PathLike": "a path",
}
COLLECTIONS = {  # of members
    "Mapping": "a dict of {} by name",
    "Sequence": "a list of {}",
    "Iterable": "a list of {}",
    "list": "a list of {}",
    "tuple": "a tuple of {}",
}
NAME = re.compile(r"\w+?(?=s?\b)")  # also in the plural
EXAMPLES = {  # argument -> example for its message
    "blocks": "[plant, controller]",
    "at": "{'angle': 0.5}",
    "within": "{'angle': (-1.0, 1.0)}",
    "parameters": "{'k': (start, low, high)}",
    "box": "(41, 41.5, -69.9, -69.1): south, north, west, east",
    "by": "(3.0, 'rate < 1')",
    "inputs": "{'e': 2}",
    "outputs": "{'y': 1}",
    "states": "{'x': 1}",
    "where": "{'torque': (-1.0, 1.0)}",
    "params": "{'k': 2.0} for a parameter k",
    "vary": "'learning.gain=0.2:2.0'",
    "replace": "{'vehicle': block}",
    "watch": "clpt.gramian(scenario, 40).watch",
    "law": "clpt.Block('adaptation', ...); "
    "scenario.with_values({'learning.law': 'sigma'}) takes a law by name",
    "insert": "{('v_x', 'vehicle'): lag}",
    "values": "{'learning.gain': 2.0}",
    "time": "1777593600.0, s since 1970 UTC",
    "V": "lambda s: s.x**2 + s.y**2",
}
# not in lists of arguments
HIDDEN = {"self", "cls", "_cls", "ports", "options", "optional"}
# words in names that other libraries have for the limits low and high
OF_LIMITS = ("limit", "min", "max", "bound", "sat", "range")
TIMES = "timepts", "Give the times as timepts"
START = "initial_state", "Give the initial state as initial_state"
NO_RESPONSE = "timepts", "Leave it out: a run is an xarray.Dataset, with run.states"
OTHER_NAMES = {  # argument of python-control or SciPy -> ours, and the remedy
    **dict.fromkeys(("T", "t_eval", "t_span", "evaluation_times"), TIMES),
    **dict.fromkeys(("X0", "y0", "x0"), START),
    **dict.fromkeys(("squeeze", "return_x", "transpose"), NO_RESPONSE),
    **dict.fromkeys(("file", "filename"), ("path", "Give the file as path")),
    "U": ("inputs", "Give the inputs as inputs"),
    "solve_ivp_method": ("method", "Give the method as method"),
    "solve_ivp_kwargs": ("rtol", "Give rtol, atol and max_step themselves"),
    "bounds": ("parameters", "Give parameters={'k': (start, low, high)}"),
    "ignore_errors": ("rtol", "Leave it out: a run that fails raises an error"),
}
MAKERS = {  # word of the allowed kinds -> remedy; the first counts
    "Dive": "clpt.gliders.read_dives('dives.csv')[0] is a list of dives",
    "Scenario": "clpt.load_scenario('mine.toml') reads a scenario's file",
    "Team": "clpt.load_scenario('team.toml') reads a team's file",
    "diagram": "clpt.closed_loop, clpt.connect or control.ss makes one",
    "Dataset": "clpt.simulate(scenario) makes a run, clpt.load_run('run.nc') reads one",
    "StateSpace": "control.ss(system) or clpt.linearize(system, x, u) makes one",
    "Block": "clpt.Block('gain', output=..., inputs={'u': 1}, outputs={'y': 1}) makes one",
}


def public(target: Public) -> Public:
    """Return a function or class that refuses arguments which its annotations do not allow."""
    if not isinstance(target, type):
        for argument, kind in target.__annotations__.items():
            if kind == ArrayLike:  # help() would print its ten lines
                target.__annotations__[argument] = "ArrayLike"
        call = _checking(target, target.__qualname__)
        # with the globals of the target's module, in which doctest looks for it
        function = FunctionType(
            call.__code__, target.__globals__, closure=call.__closure__
        )
        wrapped: Any = update_wrapper(function, target)
        return wrapped
    maker = "__init__" if "__init__" in vars(target) else "__new__"  # of a NamedTuple
    call = _checking(getattr(target, maker), target.__name__)
    setattr(target, maker, call if maker == "__init__" else staticmethod(call))
    return target


def _checking(function: Any, name: str) -> Any:
    """Return a function that checks its arguments before it calls another."""
    code = function.__code__
    positional = code.co_varnames[: code.co_argcount]
    of_call = signature(function)
    parameters = of_call.parameters
    has_ports = "ports" in parameters
    explain = _explain  # `call` has the globals of the target
    kinds_by: dict[str, Kinds] = {}

    def checked(argument: str, value: Any) -> Any:
        if has_ports and argument not in parameters and not isinstance(value, str):
            _refuse_call(name, parameters, [argument])  # the name of a port is a text
        value = without_mask(value)
        if not kinds_by:  # at the first call, when all names are known
            for name_of_argument, kind in function.__annotations__.items():
                kinds_by[name_of_argument] = kinds_of(kind, function.__globals__)
        kinds = kinds_by.get(argument, (Any,))
        if Any in kinds or _fits_at_once(value, kinds):
            return value
        value = as_python_type(value, kinds)
        if not fits(value, kinds):
            allowed = words(kinds)
            raise ArgumentError(
                f"{name}: {argument} = {brief(value)}: must be {allowed}"
                f"{', without NaN' * (has_nan(value) and not np.isscalar(value))}"
                f"{hint(argument, value, allowed)}"
            )
        return value

    def call(*values: Any, **named: Any) -> Any:
        try:
            return function(
                *map(checked, positional, values),
                *values[len(positional) :],  # too many
                **{argument: checked(argument, v) for argument, v in named.items()},
            )
        except TypeError as error:
            explain(name, of_call, values, named, error)
            raise

    return update_wrapper(call, function)


def _explain(name: str, call: Signature, values: Any, named: Any, error: Any) -> None:
    """Refuse a call whose arguments are unknown, missing, repeated or too many."""
    parameters, unknown = call.parameters, getattr(error, "unknown", "")
    if "options" in parameters and unknown in named:  # by the function that takes them
        _refuse_call(name, [*parameters, *error.names], [unknown], "unexpected")
    try:
        call.bind(*values, **named)
    except TypeError as mismatch:
        _refuse_call(name, parameters, named, str(mismatch))


def _refuse_call(
    name: str, parameters: Iterable[str], named: Iterable[str], reason: str = ""
) -> None:
    """Refuse a name that is none of the parameters; one that has no advice may be a port."""
    names = [own for own in parameters if own not in HIDDEN]
    for unknown in sorted({*named}.difference(names)):
        name_here, advice = OTHER_NAMES.get(unknown, ("", ""))
        if name_here not in names:
            advice = known(unknown, names)
        if "low" in names and any(word in unknown for word in OF_LIMITS):
            advice = "Give the limits as low=, high="
        if "unexpected" in reason or not advice.startswith("It has"):
            refused = ArgumentError(f"{name}: {unknown}= is not an argument. {advice}")
            refused.unknown, refused.names = unknown, names
            raise refused
    if reason:
        raise ArgumentError(f"{name}: {reason}. Its arguments are {', '.join(names)}")


def without_mask(value: Any) -> Any:
    """Return a masked array, or a list or dict of them, with gaps as NaN, or as no time.

    >>> without_mask(np.ma.masked_less([3, -999], 0))
    array([ 3., nan])
    """
    kind = type(value)
    if kind.__name__ == "MaskedArray":
        number = value.dtype.kind
        if number == "M":
            return value.filled(np.datetime64("NaT"))
        return value.astype(float).filled(np.nan) if number in "iuf" else value
    if kind in (list, tuple) and len(value) < MOST_MEMBERS:
        if _are_numbers(value):
            return value
        return kind(map(without_mask, value))
    if kind is dict and len(value) < MOST_MEMBERS:
        return {name: without_mask(member) for name, member in value.items()}
    return value


def _are_numbers(values: Iterable) -> bool:
    return NUMBERS.issuperset(map(type, values))


def kinds_of(kind: Any, names: Mapping[str, Any]) -> Kinds:
    """Return the kinds of an annotation; a name that only type checkers import stays a name."""
    if isinstance(kind, ForwardRef):
        kind = kind.__forward_arg__
    if isinstance(kind, str):
        try:
            kind = eval(kind, dict(names))
        except (NameError, AttributeError):
            alternatives = kind.split(" | ")
            return (
                sum((kinds_of(alternative, names) for alternative in alternatives), ())
                if alternatives[1:]
                else (kind,)
            )
    if kind == ArrayLike:  # the function checks its array
        return (Any,)
    if kind == OrNaN:
        return (float, OrNaN)
    if get_origin(kind) in (Union, UnionType):
        return tuple(
            inner for member in get_args(kind) for inner in kinds_of(member, names)
        )
    return (NoneType if kind is None else kind,)


def as_python_type(value: Any, kinds: Kinds) -> Any:
    """Return a value as one of the kinds: a number of Python, a list, a tuple or an array."""
    if type(value) is dict:
        return value
    if type(value) is list and np.ndarray in kinds and _are_numbers(value):
        return np.asarray(value)
    if (
        attribute_of(value, "ndim") == 0
        and attribute_of(value, "dtype", EMPTY).kind in "iufb"
    ):
        numeric = {float, int, bool}.intersection(
            _origin_and_arguments(kind)[0] for kind in kinds
        )
        return value.item() if numeric else value
    if isinstance(value, Iterator) and any(
        get_origin(kind) is Iterable for kind in kinds
    ):
        return list(value)
    if isinstance(value, list) and any(get_origin(kind) is tuple for kind in kinds):
        return tuple(value)
    listed = isinstance(value, list | tuple) or has(value, "__array__")
    if listed and np.ndarray in kinds and not isinstance(value, np.ndarray):
        with suppress(TypeError, ValueError):  # rows of several lengths
            return np.asarray(value)
    return value


def _fits_at_once(value: Any, kinds: Kinds) -> bool:
    """Return True if the type of a value is one of the kinds: a dive has 25 numbers."""
    kind = type(value)
    if kind in SIMPLE:
        return kind in kinds and value == value
    if kind is np.ndarray:
        return kind in kinds and value.ndim > 0 and value.dtype.kind in "iuf"
    return isinstance(value, _classes(kinds))


@cache
def _classes(kinds: Kinds) -> tuple[type, ...]:
    """Return the kinds that are classes of this package or of python-control."""
    prefixes = "clpt_control.", "control."
    classes = [kind for kind in kinds if isinstance(kind, type)]
    return tuple(kind for kind in classes if kind.__module__.startswith(prefixes))


def fits(value: Any, kinds: Kinds) -> bool:
    """Return True if a value has one of the kinds; NaN has only the kinds Any and `OrNaN`."""
    if Any in kinds or _fits_at_once(value, kinds):
        return True
    if isinstance(value, Real) and value != value:
        return OrNaN in kinds
    return any(_has_kind(value, kind) for kind in kinds)


def _has_kind(value: Any, kind: Any) -> bool:
    origin, inner = _origin_and_arguments(kind)
    if origin is Any:
        return True
    if kind in (Seed, Count):
        least = 0 if kind == Seed else 1
        return _has_kind(value, int) and int(value) >= least
    if kind == Positive:
        return _has_kind(value, float) and 0 < value < np.inf
    if origin in (float, int):
        return isinstance(
            value, Real if origin is float else Integral
        ) and not isinstance(value, bool)
    if origin is np.ndarray:  # of numbers
        return (
            isinstance(value, origin) and value.ndim > 0 and value.dtype.kind in "iuf"
        )
    if isinstance(origin, str):
        # such as "xarray.Dataset", of a module that may not be imported
        *module, name = origin.split(".")
        modules = [
            parent.__module__.split(".")
            for parent in type(value).__mro__
            if parent.__name__ == name
        ]
        return any(path[: len(module)] == module for path in modules)
    if origin in LISTS or (origin is tuple and inner[-1] is Ellipsis):
        return _is_list_of(value, origin, inner)
    if origin is tuple:
        listed = isinstance(value, tuple | list) or attribute_of(value, "ndim", 0) == 1
        return listed and len(value) == len(inner) and all(map(_inner, value, inner))
    if origin in (Mapping, dict) and inner and isinstance(value, origin):
        return all(
            _inner(item, k)
            for pair in value.items()
            for item, k in zip(pair, inner, strict=True)
        )
    return isinstance(value, origin)


@cache
def _origin_and_arguments(kind: Any) -> tuple[Any, tuple[Any, ...]]:
    """Return Sequence and (str,) for Sequence[str]."""
    if get_origin(kind) is Annotated:
        kind = get_args(kind)[0]
    return get_origin(kind) or kind, get_args(kind)


def _inner(value: Any, kind: Any) -> bool:
    return fits(value, _inner_kinds(kind))


@cache
def _inner_kinds(kind: Any) -> Kinds:
    return kinds_of(kind, {})


def _is_list_of(value: Any, origin: Any, inner: Kinds) -> bool:
    """Return True if a value is a list or another sequence whose members have the inner kind."""
    if (
        isinstance(value, str | bytes | os.PathLike | Mapping)
        or attribute_of(value, "ndim", 1) == 0
    ):
        return False
    if not all(has(value, name) for name in ("__iter__", "__len__")):
        return False
    if origin is not Iterable and not has(value, "__getitem__"):
        return False
    if inner[:1] == (float,):  # thousands of times are asked at once
        try:
            numbers = np.asarray(value)
        except (TypeError, ValueError):
            return False
        return numbers.ndim == 1 and (numbers.dtype.kind in "iuf" or not len(numbers))
    return all(_inner(member, inner[0]) for member in value)


def words(kinds: Kinds) -> str:
    """Return kinds as words: "a number or None"."""
    *many, last = dict.fromkeys(map(_noun, kinds))
    return f"{', '.join(many)} or {last}" if many else last


def _noun(kind: Any) -> str:
    if kind in (Seed, Count, Positive):
        return f"{NOUNS[get_args(kind)[0].__name__]}, {get_args(kind)[1]}"
    origin, inner = _origin_and_arguments(kind)
    name = (
        origin if isinstance(origin, str) else getattr(origin, "__name__", str(origin))
    )
    if inner and name in COLLECTIONS:
        members = [one for one in inner if one is not Ellipsis][name == "Mapping" :]
        nouns = [_noun(one) for each in members for one in kinds_of(each, {})]
        nouns = [*dict.fromkeys(map(_several, nouns))]
        count = f"{len(inner)} " if name == "tuple" and Ellipsis not in inner else ""
        return COLLECTIONS[name].format(count + " or ".join(nouns))
    return NOUNS.get(name) or f"{'an' if name[0] in 'AEIOUaeioux' else 'a'} {name}"


def _several(noun: str) -> str:
    """Return the plural of a noun with its article.

    >>> [_several(noun) for noun in ("a whole number", "a list of texts", "None", "an Any")]
    ['whole numbers', 'lists of texts', 'None', 'values']
    """
    article, _, rest = noun.partition(" ")
    if article not in ("a", "an"):
        return noun
    head, of, members = rest.partition(" of ")
    return "values" if head == "Any" else f"{head}s{of}{members}"


def has_nan(value: Any) -> bool:
    """Return whether a number is NaN, or one of a list, a dict or an array."""
    if type(value) in SIMPLE:
        return value != value
    if isinstance(value, Mapping):
        value = [*value.values()]
    with suppress(Exception):  # no numbers
        return bool(np.isnan(np.asarray(value, float)).any())
    return False


def brief(value: Any) -> str:
    """Return a value in a few words."""
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, np.ndarray | np.generic) and value.size <= MOST_SHOWN:
        value = value.tolist()
    if value is None or isinstance(value, PLAIN):
        return " ".join(SHORT.repr(value).split())
    kind = type(value).__name__.removeprefix("nd")
    named = f"{'an' if kind[0] in 'AEIOUaeiou' else 'a'} {kind}"
    shape = attribute_of(value, "shape")
    return f"{named} of shape {shape}" if isinstance(shape, tuple) else named


def hint(argument: str, value: Any, allowed: str) -> str:
    """Return a remedy for the message, or ""."""
    example = EXAMPLES.get(argument, "")
    if example and ("dict" in allowed or not example.startswith("{")):
        return f", such as {example}"
    if isinstance(value, str) and "a list of texts" in allowed:
        return f". Give a list: [{value!r}]"
    words = {word.removesuffix("s") for word in re.findall(NAME, allowed)}
    return next((f"; {maker}" for word, maker in MAKERS.items() if word in words), "")


def is_plain(value: Any) -> bool:
    """Return whether a value is None, or numbers without labels, unit or time."""
    kind = type(value)
    if kind is np.ndarray:
        return value.dtype.kind in "iufb"
    are_numbers = kind in (list, tuple) and _are_numbers(value)
    return are_numbers or value is None or kind in NUMBERS


def numbers(argument: str, value: Any, *last: int | None) -> np.ndarray:
    """Return an array of numbers; its last dimensions have the sizes given, None is any."""
    if type(value) is np.ndarray and value.dtype == float and not last:
        return value
    value = without_mask(value)
    with suppress(Exception):  # of a user's object
        array = np.asarray([] if value is None else value)
        if array.dtype.kind == "O":
            array = np.asarray(array.tolist())
        if array.dtype.kind in "cmMUS":
            raise TypeError  # NumPy would drop what is imaginary, and the unit of a time
        array = array.astype(float, copy=False)
        sizes = array.shape[max(array.ndim - len(last), 0) :]
        if not last or all(
            required in (None, size)
            for required, size in zip_longest(last, sizes, fillvalue=-1)
        ):
            return array
    shape = f" of shape (..., {', '.join('n' if n is None else str(n) for n in last)})"
    raise ArgumentError(
        f"{argument} = {brief(value)}: must be an array of numbers{shape if last else ''}"
    )


def vector_of(argument: str, value: Any, size: int) -> np.ndarray:
    """Return a new vector of finite numbers; a single number is the value of all."""
    array = numbers(argument, value)
    if not array.ndim:
        array = np.full(size, array)
    if array.shape != (size,):
        raise ArgumentError(
            f"{argument} = {brief(array.tolist())}: must have {size} finite number"
            f"{'s' * (size != 1)}; it has shape {array.shape}"
        )
    return finite(argument, array).copy()


def finite(argument: str, value: Any) -> np.ndarray:
    """Return an array of finite numbers."""
    array = numbers(argument, value)
    are_finite = np.isfinite(array)
    if not are_finite.all():
        k = int(np.argmin(are_finite))
        where = f"; number {k} is {array[k]}" if array.ndim == 1 else ""
        raise ArgumentError(f"{argument} = {brief(array)}: must be finite{where}")
    return array


def attribute_of(value: Any, name: str, default: Any = None) -> Any:
    """Return an attribute of any object, and never what its class's `__getattr__` makes up."""
    try:
        kind: Any = type(value)
        return kind.__getattribute__(value, name)
    except Exception:  # the code of a user's class can raise anything
        return default


def has(value: Any, name: str) -> bool:
    """Return whether an object has an attribute, without its class's `__getattr__`."""
    return attribute_of(value, name, EMPTY) is not EMPTY


def check_holds(argument: str, data: Any, names: Iterable[str], cure: str) -> None:
    """Refuse a Dataset or dict without one of some names."""
    for name in names:
        if name not in data:
            raise ArgumentError(f"{argument} = {brief(data)}: has no '{name}'; {cure}")


def check_known(argument: str, given: Iterable[str], names: Collection[str]) -> None:
    """Refuse a name that is none of those allowed."""
    for name in given:
        if name not in names:
            raise ArgumentError(f"{argument}: there is no {name}. {known(name, names)}")


def nearest(name: str, names: Iterable[str]) -> str:
    """Return the most similar name, also without the block before it, or ""."""
    name = str(name)  # a key may be a number
    candidates, last = [*names], name.rpartition(".")[2]
    if last in candidates:
        return last
    lower = name.lower()
    close = [
        *(one for one in candidates if one.rpartition(".")[2] == name),
        *difflib.get_close_matches(name, candidates, n=1),
        *difflib.get_close_matches(lower, candidates, n=1),
        *(one for one in candidates if one.startswith(lower) and len(lower) > 2),
    ]
    return close[0] if close else ""


def known(name: str, names: Iterable[str], otherwise: str = "") -> str:
    """Return a sentence with the most similar name, or another one, by default with all names.

    >>> known("angel", ["angle", "rate"]), known("y", ["angle", "rate"])
    ("Did you mean 'angle'?", 'It has angle, rate')
    """
    close = nearest(name, names)
    if close:
        return f"Did you mean '{close}'?"
    return otherwise or f"It has {', '.join(names) or 'none'}"
