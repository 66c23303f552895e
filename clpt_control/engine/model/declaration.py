"""What a block declares beside its equations and ports: names, typed parameters and guard.

    parameters={"gain": 0.8, "turns": 3},  breakpoints=Each("period"),  units={"e": "m"}

Parameters are numbers and arrays by name.  Whole numbers (int) are structure, such as
the number of turns of a loop: every reading keeps them as they are.  All else is a
float or an array of floats: symbols to SymPy, and it may differ per run.
"""

import math
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, fields, is_dataclass
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from ...arguments import brief, public
from ...errors import BlockError

UNIT = re.compile(r"([A-Za-z_]+)(?:\^|\*\*)?(-?\d+)?")  # and its power
MOST_JUMPS = 2 * 10**7  # times of jumps that are listed
Equations = Callable[[float, Any, Any, Any], Any]


@public
class Guard(NamedTuple):
    """Where a block may be used, and what happens outside.

    Attributes
    ----------
    distance : callable
        ``distance(t, x, u, p)``, an equation like a block's own: a number,
        positive inside, negative outside.
    policy : str
        ``"raise"`` fails the run, ``"stop"`` ends it there and keeps it.
    sentence : callable
        ``sentence(t, u, p)``: position, time and bounds, for the message.
    advice : str
        What to try where it fails a run; nothing by default.

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
    sentence: Callable[[float, np.ndarray, Any], str]
    advice: str = ""

    @public
    def message(self, t: float, u: np.ndarray, p: Any) -> str:
        """Return the sentence, with the advice where a run fails."""
        advised = self.policy == "raise" and self.advice
        return self.sentence(t, u, p) + (f"; {self.advice}" if advised else "")


def check_names(name: str, *ports: Mapping[str, Any]) -> None:
    """Refuse names and sizes that python-control cannot wire."""
    words = [(name, ".\n"), *((port, ".[]\n") for one in ports for port in one)]
    for word, not_in in words:  # python-control itself calls a system sys[0]
        if not word or word[0] in "-+" or set(word) & set(not_in):
            raise BlockError(
                f"the name {word!r} of a block or port must not be empty, begin with a sign or "
                "hold . [ ] or a line end; use letters, digits and _"
            )
    for port, shape in (item for one in ports for item in one.items()):
        for size in shape:
            if size == "" if isinstance(size, str) else size < 0:
                raise BlockError(
                    f"{name}.{port}: size {brief(size)} must be a whole number, 0 or more, or a "
                    "name"
                )


def check_units(name: str, units: Mapping[str, str], *ports: Mapping[str, Any]) -> None:
    """Refuse units of what is no port, and units that are no text of one line."""
    for port, unit in units.items():
        if not any(port in one for one in ports):
            known = ", ".join(dict.fromkeys(port for one in ports for port in one))
            raise BlockError(f"{name}: units names {port!r}, which is no port; it has {known}")
        if not unit.strip() or not unit.isprintable():
            raise BlockError(
                f"{name}: units = {{{port!r}: {brief(unit)}}}: must be a text, such as 'm/s'"
            )


def powers(unit: str) -> dict[str, int]:
    """Return the powers of a unit, in which rad and 1 are none.

    >>> powers("m/s"), powers("1/s^2"), powers("m s-1"), powers("1")
    ({'m': 1, 's': -1}, {'s': -2}, {'m': 1, 's': -1}, {})
    """
    found: dict[str, int] = {}
    for k, part in enumerate(unit.replace("**", "^").split("/")):
        for word in re.split(r"[\s.*()]+", part.strip(" ()")):
            read = UNIT.fullmatch(word)
            if read is None and word not in ("", "1"):
                raise BlockError(f"units: {unit!r} is no unit; write such as 'm', 'm/s' or '1/s^2'")
            if read is not None and read[1] not in ("rad", "radians"):
                power = int(read[2] or 1) * (-1 if k else 1)
                found[read[1]] = found.get(read[1], 0) + power
    return {symbol: power for symbol, power in found.items() if power}


def same_unit(a: str, b: str) -> bool:
    """Return whether two texts are one unit; one that is no product of powers is as it is written.

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
    first = max(1, math.floor(t0 / period) - 1)
    last = math.floor(t1 / period) + 1
    times = period * np.arange(first, last + 1)
    return times[(times > t0) & (times <= t1)]


@dataclass(frozen=True)
class Each:
    """Breakpoints at the multiples of a period, a number or a parameter by name, or of a part."""

    period: str | float
    part: float = 1.0

    def apart(self, p: Any) -> float:
        """Return the time from one to the next."""
        period = getattr(p, self.period) if isinstance(self.period, str) else self.period
        return self.part * period

    def __call__(self, p: Any, t0: float, t1: float) -> np.ndarray:
        """Return the breakpoints in (t0, t1]."""
        apart = self.apart(p)
        if t0 < 0:
            raise BlockError(
                f"what samples or jumps each {apart:g} does so from time 0 on; begin the run at 0 "
                f"or later, not at {t0:g}"
            )
        return multiples(apart, t0, t1)

    def count(self, p: Any, t: float) -> int:
        """Return how many breakpoints there are in (0, t]."""
        apart = self.apart(p)
        if not (apart > 0 and t < 2.0**52 * apart):
            return len(multiples(apart, 0.0, t))  # which refuses so many
        k = math.floor(t / apart)
        return max(k + (apart * (k + 1) <= t) - (apart * k > t), 0)


TAKEN = frozenset({"get", "keys", "_fields", "_replace", "_asdict"})  # by what all parameters do


class Parameters(SimpleNamespace):
    """A block's parameters: ``p.gain``, ``p["gain"]``, ``p.get("gain", 1.0)``."""

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"parameters stay as they are; set no {name!r}")

    def __getitem__(self, name: Any) -> Any:
        return getattr(self, name) if isinstance(name, str) else tuple(self)[name]

    def __contains__(self, name: Any) -> bool:
        return name in vars(self)

    def __iter__(self) -> Iterator[Any]:
        return iter(vars(self).values())

    def get(self, name: str, default: Any = None) -> Any:
        """Return a parameter, or the default where there is none."""
        return vars(self).get(name, default)

    def keys(self) -> tuple[str, ...]:
        """Return the names."""
        return tuple(vars(self))

    _fields = property(keys)

    def _replace(self, **changes: Any) -> "Parameters":
        return Parameters(**{**vars(self), **changes})

    def _asdict(self) -> dict[str, Any]:
        return dict(vars(self))


def named_values(name: str, parameters: Any) -> dict[str, Any]:
    """Return parameters, a dict, a NamedTuple or a dataclass, by name."""
    if parameters is None:
        return {}
    if isinstance(parameters, Mapping):
        return dict(parameters)
    if hasattr(parameters, "_asdict"):
        return parameters._asdict()
    if is_dataclass(parameters) and not isinstance(parameters, type):
        return {field.name: getattr(parameters, field.name) for field in fields(parameters)}
    raise BlockError(
        f"{name}: parameters must be a dict, a NamedTuple or a dataclass, not "
        f"{type(parameters).__name__}"
    )


def checked_parameters(name: str, parameters: Any, like: Any = None) -> Parameters:
    """Return parameters as whole numbers, floats and new arrays, of the shapes of `like`."""
    values: dict[str, Any] = {}
    for field, value in named_values(name, parameters).items():
        if not isinstance(field, str) or not field.isidentifier() or field in TAKEN:
            raise BlockError(f"{name}: the parameter name {field!r} must be a Python name")
        old = value if like is None else getattr(like, field)
        whole = isinstance(old, int | np.integer)
        try:
            shape = np.shape(old)
            new: Any = np.array(value, dtype=float) if shape else np.float64(value)
            if whole and not isinstance(old, bool):
                new = int(value) if int(value) == value else np.nan
        except (TypeError, ValueError, OverflowError):
            shape, new = (), np.nan
        if np.shape(new) != shape or np.any(np.not_equal(new, new)):
            kind = "a whole number" if whole else "a number"
            kind = f"an array of shape {shape}" if shape else kind
            raise BlockError(f"{name}.{field} = {value!r}: must be {kind}, without NaN")
        if shape:
            new.flags.writeable = False  # equations have no side effects
        values[field] = new
    return Parameters(**values)


# --- in a line ---------------------------------------------------------------------------------


MOST = 8  # ports of a line


def ports_line(ports: Mapping[str, int]) -> str:
    """Return ports with their sizes.

    >>> ports_line({"e": 2, "w": 1})
    'e[2], w'
    """
    named = [name if size == 1 else f"{name}[{size}]" for name, size in ports.items()]
    more = [f"... {len(named)} in all"] if len(named) > MOST else []
    return ", ".join(named[: MOST if more else None] + more) or "nothing"


def block_line(block: Any) -> str:
    """Return what a block is, in a line."""
    states = f", {block.nstates} states" if block.nstates else ""
    flows = f"{ports_line(block.input_ports)} -> {ports_line(block.output_ports)}"
    return f"<Block {block.name}: {flows}{states}>"


def docs_of(block: Any) -> list[str]:
    """Return what the functions of a block, or of the one that it samples, say of themselves."""
    block = getattr(block, "inner", block)
    own = (getattr(block, f"{role}_function", None) for role in ("update", "output", "jump"))
    return [f.__doc__ for f in (getattr(f, "func", f) for f in own) if f and f.__doc__]
