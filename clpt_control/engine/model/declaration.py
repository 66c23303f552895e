"""Declarations of a block: names, units, typed parameters, breakpoints and guard.

    parameters={"gain": 0.8, "turns": 3},  breakpoints=Each("period"),  units={"e": "m"}

Parameters are numbers and arrays by name.  Whole numbers (int) are structure, such as the number of
iterations of a loop, and fixed in every backend.  All others are floats or arrays of floats:
symbols in SymPy, and they may differ between runs.
"""

import math
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, fields, is_dataclass
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from ...base.arguments import attribute_of, brief, has, public
from ...base.errors import ArgumentError, BlockError
from ...base.labelled import unlabelled

UNIT = re.compile(r"([A-Za-z_]+)(?:\^|\*\*)?(-?\d+)?")  # and its power
MOST_JUMPS = 2 * 10**7  # breakpoints in a list
Equations = Callable[[float, Any, Any, Any], Any]


POLICIES = ("raise", "stop", "jump")


@public
class Guard(NamedTuple):
    """Domain of a block, and the action where a run leaves it.

    Attributes
    ----------
    distance : callable
        ``distance(t, x, u, p)``, an equation like a block's own: a number,
        positive inside, negative outside; 0 is inside.
    policy : str
        ``"raise"`` fails the run, ``"stop"`` ends it without an error,
        ``"jump"`` sets the states to those of the block's `jump`.
    sentence : callable, optional
        ``sentence(t, u, p)``: position, time and bounds, for the message of
        a run that ends.
    advice : str
        Remedy for a failed run, for the message.

    Examples
    --------
    >>> def above_ground(t, x, u, p):
    ...     return u[0]
    >>> guard = Guard(above_ground, "stop", lambda t, u, p: f"it landed at time {t:g}")
    >>> guard.sentence(3.0, [-0.1], None)
    'it landed at time 3'
    """

    distance: Equations
    policy: str
    sentence: Callable[[float, np.ndarray, Any], str] | None = None
    advice: str = ""

    @public
    def message(self, t: float, u: np.ndarray, p: Any) -> str:
        """Return the sentence, with the advice if the run fails."""
        has_advice = self.policy == "raise" and self.advice
        sentence = f"a guard was left at t = {t:.9g}"
        if self.sentence is not None:
            sentence = self.sentence(t, u, p)
        return sentence + (f"; {self.advice}" if has_advice else "")


def check_names(name: str, *ports: Mapping[str, Any]) -> None:
    """Refuse names and sizes that python-control cannot wire."""
    shapes = [(port, shape) for group in ports for port, shape in group.items()]
    # python-control itself calls a system sys[0]
    words = [(name, ".\n"), *((port, ".[]\n") for port, _ in shapes)]
    for word, excluded in words:
        if not word or word[0] in "-+" or set(word) & set(excluded):
            raise BlockError(
                f"the name {word!r} of a block or port must not be empty, begin with a sign or "
                "hold . [ ] or a line end. Use letters, digits and _"
            )
    for port, shape in shapes:
        for size in shape:
            if size == "" if isinstance(size, str) else size < 0:
                raise BlockError(
                    f"{name}.{port}: size {brief(size)} must be a whole number, 0 or more, or a "
                    "name"
                )


def check_units(name: str, units: Mapping[str, str], *ports: Mapping[str, Any]) -> None:
    """Refuse units of names that are no ports or parameters, and units that are no text."""
    names = dict.fromkeys(port for group in ports for port in group)
    for port, unit in units.items():
        if port not in names:
            raise BlockError(
                f"{name}: units names {port!r}, which is no port and no parameter; it has "
                f"{', '.join(names)}"
            )
        if not unit.strip() or not unit.isprintable():
            raise BlockError(
                f"{name}: units = {{{port!r}: {brief(unit)}}}: must be a text, such as 'm/s'"
            )


def powers(unit: str) -> dict[str, int]:
    """Return the power of each symbol of a unit; rad and 1 have no power.

    >>> powers("m/s"), powers("1/s^2"), powers("m s-1"), powers("1")
    ({'m': 1, 's': -1}, {'s': -2}, {'m': 1, 's': -1}, {})
    """
    symbols: dict[str, int] = {}
    for k, factors in enumerate(unit.replace("**", "^").split("/")):
        for word in re.split(r"[\s.*()]+", factors.strip(" ()")):
            if word in ("", "1"):
                continue
            match = UNIT.fullmatch(word)
            if match is None:
                raise BlockError(
                    f"units: {unit!r} is not a unit. Write such as 'm', 'm/s' or '1/s^2'"
                )
            symbol, power = match.groups()
            if symbol not in ("rad", "radians"):
                power = int(power or 1)
                symbols[symbol] = symbols.get(symbol, 0) + (-power if k else power)
    return {symbol: power for symbol, power in symbols.items() if power}


def same_unit(a: str, b: str) -> bool:
    """Return whether two texts are the same unit; a text that is no unit equals itself only.

    >>> same_unit("m/s", "m s-1"), same_unit("m", "km"), same_unit("%", "%")
    (True, False, True)
    """
    with suppress(BlockError):
        return a == b or powers(a) == powers(b)
    return False


def multiples(period: float, t0: float, t1: float) -> np.ndarray:
    """Return the multiples k * period, k >= 1, in (t0, t1]: sorted, each rounded once."""
    if not period > 0:
        raise BlockError(f"a period of {period:g}: must be above 0")
    count = abs(t1 - t0) / period
    if not count <= MOST_JUMPS:
        raise BlockError(
            f"a period of {period:g} has {count:.3g} multiples from {t0:g} to {t1:g}; at most "
            f"{MOST_JUMPS:.0e} are allowed"
        )
    begin = max(1, math.floor(t0 / period) - 1)
    end = math.floor(t1 / period) + 2
    times = period * np.arange(begin, end)
    return times[(times > t0) & (times <= t1)]


@dataclass(frozen=True)
class Each:
    """Breakpoints at multiples of a fraction of a period, which is a number or a parameter."""

    period: str | float
    part: float = 1.0  # the fraction; saved runs have this name

    def interval(self, p: Any) -> float:
        """Return the time between two breakpoints."""
        period = (
            getattr(p, self.period) if isinstance(self.period, str) else self.period
        )
        return self.part * period

    def __call__(self, p: Any, t0: float, t1: float) -> np.ndarray:
        """Return the breakpoints in (t0, t1]."""
        interval = self.interval(p)
        if t0 < 0:
            raise BlockError(
                f"samples and jumps each {interval:g} are counted from time 0. Begin the run at "
                f"0 or later, not at {t0:g}"
            )
        return multiples(interval, t0, t1)

    def count(self, p: Any, t: float) -> int:
        """Return the number of breakpoints in (0, t]."""
        interval = self.interval(p)
        if not (interval > 0 and t < 2.0**52 * interval):
            return len(multiples(interval, 0.0, t))  # raises an error for so many
        k = math.floor(t / interval)
        return max(k + (interval * (k + 1) <= t) - (interval * k > t), 0)


METHODS = frozenset({"get", "keys", "_fields", "_replace", "_asdict"})  # of Parameters


class Parameters(SimpleNamespace):
    """A block's parameters: ``p.gain``, ``p["gain"]``, ``p.get("gain", 1.0)``."""

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(
            f"no parameter {name!r}; there are {', '.join(vars(self)) or 'none'}"
        )

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"parameters stay as they are. Set no {name!r}")

    def __getitem__(self, name):
        return getattr(self, name) if isinstance(name, str) else tuple(self)[name]

    def __contains__(self, name: Any) -> bool:
        return name in vars(self)

    def __iter__(self) -> Iterator[Any]:
        return iter(vars(self).values())

    def get(self, name: str, default: Any = None) -> Any:
        """Return a parameter, or the default."""
        return vars(self).get(name, default)

    def keys(self) -> tuple[str, ...]:
        """Return the names."""
        return tuple(vars(self))

    _fields = property(keys)

    def _replace(self, **changes: Any) -> "Parameters":
        return Parameters(**{**vars(self), **changes})

    def _asdict(self) -> dict[str, Any]:
        return dict(vars(self))


# --- params of python-control ------------------------------------------------------------------

EVERY = object()  # stands for all names
FOR_ONE = ("__getitem__", "__contains__", "get", "pop", "setdefault")
FOR_ALL = (
    "__iter__",
    "__reversed__",
    "__eq__",
    "__or__",
    "__ror__",
    "keys",
    "values",
    "items",
    "copy",
    "popitem",
)


def _noted(method: str) -> Callable:
    """Return a method of dict that adds the name it reads, or EVERY, to the names."""
    real = getattr(dict, method)

    def noting(self: "Params", *arguments: Any) -> Any:
        self.names.add(arguments[0] if method in FOR_ONE else EVERY)
        return real(self, *arguments)

    return noting


class Params(dict):
    """The params of python-control; they record the names that a function reads."""

    def __init__(self, params: Mapping[str, Any], names: set[Any]) -> None:
        super().__init__(params)
        self.names = names

    vars().update({method: _noted(method) for method in (*FOR_ONE, *FOR_ALL)})


# --- values of parameters ----------------------------------------------------------------------


def named_values(name: str, parameters: Any) -> dict[str, Any]:
    """Return parameters, a dict, a NamedTuple or a dataclass, by name."""
    if parameters is None:
        return {}
    if isinstance(parameters, Mapping):
        return dict(parameters)
    if has(parameters, "_asdict"):
        return parameters._asdict()
    if is_dataclass(parameters) and not isinstance(parameters, type):
        return {
            field.name: getattr(parameters, field.name) for field in fields(parameters)
        }
    raise BlockError(
        f"{name}: parameters must be a dict, a NamedTuple or a dataclass, not "
        f"{type(parameters).__name__}"
    )


def checked_parameters(name: str, parameters: Any, like: Any = None) -> Parameters:
    """Return parameters as whole numbers, floats and new arrays, of the shapes of `like`."""
    values: dict[str, Any] = {}
    for field, value in named_values(name, parameters).items():
        if not isinstance(field, str) or not field.isidentifier() or field in METHODS:
            raise BlockError(
                f"{name}: the parameter name {field!r} must be a Python name"
            )
        model = value if like is None else getattr(like, field)
        is_whole = isinstance(model, int | np.integer)
        shape: tuple[int, ...] = ()
        try:
            shape = np.shape(model)
            number: Any = unlabelled(field, value)
            number = number.copy() if shape else number[()]
            if is_whole and not isinstance(model, bool):
                number = int(value) if int(value) == value else np.nan
        except (ArgumentError, TypeError, ValueError, OverflowError):
            number = np.nan
        if np.shape(number) != shape or np.any(np.not_equal(number, number)):
            kind = "a whole number" if is_whole else "a number"
            kind = f"an array of shape {shape}" if shape else kind
            advice = ""
            if not shape and isinstance(value, list | tuple | str):
                advice = ". A range of enclose or verify is a pair, such as (0.8, 1.2)"
            raise BlockError(
                f"{name}.{field} = {brief(value)}: must be {kind}, without NaN or labels{advice}"
            )
        if shape:
            number.flags.writeable = False  # equations have no side effects
        values[field] = number
    return Parameters(**values)


def check_rules(block: Any, parameters: Any) -> None:
    """Refuse parameters that the rules of a block do not allow."""
    for rule in block.rules:
        rule(block.name, parameters._asdict())


# --- text of one line ---------------------------------------------------------------------------


MOST_PORTS = 8  # of a line


def ports_line(ports: Mapping[str, int]) -> str:
    """Return ports with their sizes.

    >>> ports_line({"e": 2, "w": 1})
    'e[2], w'
    """
    texts = [name if size == 1 else f"{name}[{size}]" for name, size in ports.items()]
    if len(texts) > MOST_PORTS:
        texts[MOST_PORTS:] = [f"... {len(texts)} in all"]
    return ", ".join(texts) or "nothing"


def block_line(block: Any) -> str:
    """Return a block's name, ports and number of states."""
    states = f", {block.nstates} states" if block.nstates else ""
    flows = f"{ports_line(block.input_ports)} -> {ports_line(block.output_ports)}"
    return f"<Block {block.name}: {flows}{states}>"


def docs_of(block: Any) -> list[str]:
    """Return the docstrings of a block's functions; of a sampled block, of the inner block."""
    block = getattr(block, "inner", block)
    functions = [
        getattr(block, f"{role}_function", None)
        for role in ("update", "output", "jump")
    ]
    docs = (attribute_of(f, "func", f).__doc__ for f in functions if f)
    return [doc for doc in docs if doc]
