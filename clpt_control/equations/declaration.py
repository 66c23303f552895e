"""What a block declares: its names, ports, typed parameters and guard.

    inputs={"e": 2, "phi_x": "N"},  states={"alpha": (2, "N")}

A shape is a whole number, the name of a size, or a tuple of them; signals of a port are
labelled row by row, ``alpha[0]``, ``alpha[1]`` and so on.

Parameters are numbers and arrays by name.  Whole numbers (int) are structure, such as
the number of turns of a loop: every reading keeps them as they are.  All else is a
float or an array of floats: symbols to SymPy, and it may differ per run.

A block is made once, for one vehicle; in a namespace its name and the names of its ports
carry the vehicle's name, `west/vehicle` makes `west/x[2]`, and its equations are the same.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass
from math import prod
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from ..arguments import brief, public
from ..errors import BlockError
from ..html import facts, fragment, shortened
from .record import Shape, bound

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


def check_guard(name: str, guard: Guard | None) -> None:
    """Refuse a policy other than "raise" and "stop"."""
    if guard is not None and guard.policy not in ("raise", "stop"):
        raise BlockError(f'{name}: a guard\'s policy {guard.policy!r} must be "raise" or "stop"')


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


def multiples(period: float, t0: float, t1: float) -> np.ndarray:
    """Return the multiples k * period, k >= 1, in (t0, t1]: sorted, each rounded once."""
    count = abs(t1 - t0) / period if period > 0 else math.inf
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

    def __call__(self, p: Any, t0: float, t1: float) -> np.ndarray:
        """Return the breakpoints in (t0, t1]."""
        period = getattr(p, self.period) if isinstance(self.period, str) else self.period
        return multiples(self.part * period, t0, t1)


def labels(ports: Mapping[str, int] | None) -> list[str]:
    """Return the signal labels of ports: ``{"e": 2}`` is ``e[0], e[1]``."""
    return [f"{port}[{k}]" for port, size in (ports or {}).items() for k in range(size)]


def ports_of(labels: Iterable[str]) -> dict[str, list[int]]:
    """Return the ports that labels form, each with the places of its signals.

    ``e[0], e[1]`` are the port e; a name alone is a port of one signal; numbers that do not
    count from 0 form none, and stay a name.
    """
    ports: dict[str, list[int]] = {}
    for place, label in enumerate(labels):
        port, _, number = label.rpartition("[")  # y[2][0] is of the port y[2], as of sys[2, :]
        counted = number == f"{len(ports.get(port, ()))}]"
        ports.setdefault(port if counted else label, []).append(place)
    return ports


def whole_labels(labels: Iterable[str]) -> list[str]:
    """Return the labels as those of ports: ``e, v[0], v[1]`` are ``e[0], v[0], v[1]``."""
    ports = ports_of(labels)
    whole = {at: f"{port}[{k}]" for port, places in ports.items() for k, at in enumerate(places)}
    return [whole[place] for place in range(len(whole))]


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
        old = getattr(like, field) if like is not None else value
        try:
            shape = np.shape(old)
        except ValueError:
            raise BlockError(f"{name}.{field}: its rows differ in length; give an array") from None
        try:
            if isinstance(old, int | np.integer) and not isinstance(old, bool):
                values[field] = int(value) if int(value) == value else None
            elif not shape:
                values[field] = np.float64(value)
            else:
                values[field] = np.array(value, dtype=float)
                values[field].flags.writeable = False  # equations have no side effects
        except (TypeError, ValueError, OverflowError):
            values[field] = None
        if values[field] is None or np.shape(values[field]) != shape:
            kind = f"an array of shape {shape}" if shape else type(old).__name__
            raise BlockError(f"{name}.{field} = {value!r}: must be {kind}")
        if not isinstance(values[field], int) and np.any(np.isnan(values[field])):
            raise BlockError(f"{name}.{field} = {value!r}: NaN is not allowed")
    return Parameters(**values)


# --- ports -------------------------------------------------------------------------------------


Size = int | str  # a number, or the name of one
Declared = Mapping[str, Size | tuple[Size, ...]]  # port -> its shape


def shapes_of(ports: Declared | None) -> dict[str, Shape]:
    """Return the shape of each port as a tuple."""
    return {
        port: tuple(size) if isinstance(size, tuple | list) else (size,)
        for port, size in (ports or {}).items()
    }


def sized(name: str, shapes: Mapping[str, Shape], sizes: Mapping[str, int]) -> dict[str, Shape]:
    """Return shapes with their open sizes filled in."""
    found = {}
    for port, shape in shapes.items():
        for n in shape:
            if isinstance(n, str) and n not in sizes:
                raise BlockError(
                    f"{name}.{port}: the size '{n}' is not known; give sizes={{'{n}': 3}}, or an "
                    "array of the parameters that has it by `shapes`"
                )
        found[port] = tuple(map(int, bound(shape, sizes)))
    return found


def sizes_of(shapes: Mapping[str, Shape]) -> dict[str, int]:
    """Return the number of signals of each port."""
    return {port: prod(shape) for port, shape in shapes.items()}


def places(shapes: Mapping[str, Shape]) -> dict[str, tuple[slice, Shape]]:
    """Return where each port lies in the vector of all, and its shape."""
    where, at = {}, 0
    for port, shape in shapes.items():
        where[port] = (slice(at, at := at + prod(shape)), shape)
    return where


class Vector(np.ndarray):
    """python-control's vector, with its ports as views: ``x[3]``, ``x.alpha``."""

    places: dict[str, tuple[slice, Shape]]

    def __getattr__(self, port: str) -> Any:
        try:
            part, shape = self.__dict__["places"][port]
        except KeyError:
            known = ", ".join(self.__dict__.get("places", ())) or "none"
            raise AttributeError(f"no port {port!r}; there are {known}") from None
        return self.view(np.ndarray)[part].reshape(shape)


def vector(values: Any, where: dict[str, tuple[slice, Shape]]) -> Vector:
    """Return numbers as a vector with ports; one that has them is returned as it is."""
    if type(values) is Vector and values.__dict__.get("places") is where:
        return values
    x = np.asarray(values, dtype=float).view(Vector)
    x.places = where
    x.flags.writeable = False  # equations have no side effects
    return x


def reused_vector(values: np.ndarray, where: dict[str, tuple[slice, Shape]]) -> Vector:
    """Return an array that is filled again and again as a vector; its ports are cut once."""
    x = vector(values, where)
    for port, (part, shape) in where.items():
        x.__dict__[port] = x.view(np.ndarray)[part].reshape(shape)
    return x


def flattened(name: str, returned: Any, where: dict[str, tuple[slice, Shape]], size: int) -> Any:
    """Return what a function returned, a mapping by port or numbers in order, as one vector."""
    if isinstance(returned, Mapping):
        if returned.keys() != where.keys():
            raise BlockError(f"{name}: returns {list(returned)}; must return {list(where)}")
        out = np.empty(size)
        for port, (part, shape) in where.items():
            value = np.asarray(returned[port], dtype=float)
            if value.shape != shape:
                value = _shaped(name, port, value, shape)
            out[part] = value.ravel()
        return out
    if returned is None:
        raise BlockError(f"{name}: returns nothing; must return {list(where)}")
    try:
        out = np.asarray(returned, dtype=float).ravel()
    except ValueError:  # parts of several shapes
        out = np.concatenate([np.ravel(part) for part in returned]).astype(float)
    if len(out) != size:
        raise BlockError(f"{name}: returns {len(out)} numbers; must return {size}")
    return out


def _shaped(name: str, port: str, value: np.ndarray, shape: Shape) -> np.ndarray:
    if value.ndim == 0:
        return np.full(shape, value)
    if value.shape == (prod(shape),):
        return value.reshape(shape)
    raise BlockError(f"{name}: returns {port} of shape {value.shape}; must be {shape}")


# --- other names -------------------------------------------------------------------------------


BETWEEN = "/"


def named(space: str, own: str) -> str:
    """Return a name in a namespace."""
    return f"{space}{BETWEEN}{own}"


def split(name: str) -> tuple[str, str]:
    """Return the namespace of a name, empty where it has none, and the name in it."""
    space, _, own = name.rpartition(BETWEEN)
    return space, own


def within(block: Any, space: str) -> Any:
    """Return a block with its name and all its ports in a namespace."""
    ports = {*block.input_ports, *block.output_ports, *block.state_ports}
    moved = {port: named(space, port) for port in ports}
    return renamed(block, named(space, block.name), moved, moved, moved)


def renamed(
    block: Any,
    name: str,
    inputs: Mapping[str, str],
    outputs: Mapping[str, str],
    states: Mapping[str, str] | None = None,
) -> Any:
    """Return a block under another name, some of its ports under others: {old: new}."""
    copy = block.copy(name=name)
    by_states = block.states_are_outputs
    kinds = {"inputs": inputs, "outputs": outputs, "states": outputs if by_states else states or {}}
    copy._name_ports(kinds)
    return copy


# --- in a line, and in a notebook --------------------------------------------------------------


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


def block_html(block: Any) -> str:
    """Return a block as a table."""
    doc = next((f.__doc__ for f in (block.update_function, block.output_function) if f), None)
    rows = [
        ("equations", " ".join((doc or "").split("\n\n")[0].split())),
        ("inputs", ports_line(block.input_ports)),
        ("outputs", ports_line(block.output_ports)),
        ("states", ports_line(block.state_ports)),
    ]
    values = block.parameters._asdict().items()
    rows += [(f"{block.name}.{name}", _value(value)) for name, value in values]
    return fragment("Block", block.name, facts(rows))


def _value(value: Any) -> str:
    """Return a parameter: a number, or the first numbers of an array and its shape."""
    whole = np.asarray(value)
    if whole.ndim == 0:
        return f"{value:g}" if isinstance(value, float) else str(value)
    first = ", ".join(f"{number:g}" for number in whole.ravel()[:12])
    dots = ", ..." if whole.size > 12 else ""
    return shortened(f"[{first}{dots}], shape {whole.shape}")
