"""Ports: the shapes of signals, their labels, their places in one vector, and their names.

    alpha of shape (2, N)  ->  alpha[0], alpha[1], ... row by row  ->  x.alpha, a view of the vector

A shape is a whole number, the name of a size, or a tuple of them.  A block is made once, for one
vehicle; in a namespace its name and the names of its ports carry the vehicle's name, `west/vehicle`
makes `west/x[2]`, and its equations are the same.
"""

from collections.abc import Callable, Iterable, Mapping
from math import prod
from types import MappingProxyType
from typing import Any

import numpy as np

from ...arguments import brief
from ...errors import BlockError
from ..record.graph import Shape, bound

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

    _ports: Mapping[str, tuple[slice, Shape]] = MappingProxyType({})

    def __getattr__(self, port: str) -> Any:
        try:
            part, shape = self._ports[port]
        except KeyError:
            known = ", ".join(self._ports) or "none"
            raise AttributeError(f"no port {port!r}; there are {known}") from None
        return self.view(np.ndarray)[part].reshape(shape)


def vector(values: Any, where: dict[str, tuple[slice, Shape]]) -> Vector:
    """Return numbers as a vector with ports; one that has them is returned as it is."""
    if type(values) is Vector and values._ports is where:
        return values
    x = np.asarray(values, dtype=float).view(Vector)
    x._ports = where
    x.flags.writeable = False  # equations have no side effects
    return x


def reused_vector(values: np.ndarray, where: dict[str, tuple[slice, Shape]]) -> Vector:
    """Return an array that is filled again and again as a vector; its ports are cut once."""
    x = vector(values, where)
    for port, (part, shape) in where.items():
        x.__dict__[port] = x.view(np.ndarray)[part].reshape(shape)
    return x


def flattened(
    name: str,
    returned: Any,
    where: dict[str, tuple[slice, Shape]],
    size: int,
    spreads: bool = False,
) -> Any:
    """Return what a function returned, a mapping by port or numbers in order, as one vector.

    If it `spreads`, one number is the value of all, as python-control takes it.
    """
    if isinstance(returned, Mapping):
        check_ports(name, returned, where)
        out = np.empty(size)
        for port, (part, shape) in where.items():
            value = np.asarray(returned[port], dtype=float)
            if value.shape != shape:
                value = shaped(name, port, value, shape, np.broadcast_to)
            out[part] = value.ravel()
        return out
    if returned is None:
        raise BlockError(f"{name}: returns nothing; must return {list(where)}")
    try:
        out = np.asarray(returned, dtype=float).ravel()
    except (TypeError, ValueError) as error:  # of parts of several shapes
        if not isinstance(returned, list | tuple):
            raise BlockError(f"{name}: returns {brief(returned)}; must return numbers") from error
        out = np.concatenate([np.ravel(part) for part in returned]).astype(float)
    if spreads and len(out) == 1:
        out = np.full(size, out[0])
    if len(out) != size:
        raise BlockError(f"{name}: returns {len(out)} numbers; must return {size}")
    return out


def check_ports(name: str, returned: Mapping[str, Any], ports: Mapping[str, Any]) -> None:
    """Refuse a mapping that has other names than the ports."""
    if returned.keys() != ports.keys():
        raise BlockError(f"{name}: returns {list(returned)}; must return {list(ports)}")


def shaped(name: str, port: str, value: Any, shape: Shape, filled: Callable) -> Any:
    """Return a value in the shape of its port: a number everywhere, a row of numbers in order."""
    own = getattr(value, "shape", ())
    if own == shape:
        return value
    if not own:
        return filled(value, shape)
    known = all(isinstance(n, int) for n in (*own, *shape))
    if known and own == (prod(shape),):
        return value.reshape(shape)
    raise BlockError(f"{name}: returns {port} of shape {own}; must be {shape}")


# --- labels --------------------------------------------------------------------------------------


def labels(ports: Mapping[str, int] | None) -> list[str]:
    """Return the signal labels of ports: ``{"e": 2}`` is ``e[0], e[1]``."""
    return [f"{port}[{k}]" for port, size in (ports or {}).items() for k in range(size)]


def port_of(label: str) -> str:
    """Return the port of a signal's label."""
    return label.partition("[")[0]


def counts_of(labels: Iterable[str]) -> dict[str, int]:
    """Return the ports that labels form, each with its number of signals."""
    return {port: len(places) for port, places in ports_of(labels).items()}


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
