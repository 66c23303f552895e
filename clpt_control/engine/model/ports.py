"""Ports: shapes of signals, labels, slices of one vector, and names.

    alpha of shape (2, N)  ->  alpha[0], alpha[1], ... row by row  ->  x.alpha, a view of the vector

A shape is a whole number, the name of a size, or a tuple of both.  The same block may be used for
several vehicles.  A namespace is then the prefix of its name and of its ports: `west/vehicle` has
the port `west/x[2]`, and the equations are the same.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import prod
from types import MappingProxyType
from typing import Any

import numpy as np

from ...base.arguments import brief
from ...base.errors import BlockError
from ..record.graph import Shape, bound, is_known

Size = int | str  # a number, or its name
Declared = Mapping[str, Size | tuple[Size, ...]]  # port -> shape
Slices = dict[str, tuple[slice, Shape]]  # port -> its slice of a vector, and its shape
MOST_SIGNALS = 10**6  # of a port


def shapes_of(ports: Declared | None) -> dict[str, Shape]:
    """Return the shape of each port as a tuple."""
    return {
        port: tuple(size) if isinstance(size, tuple | list) else (size,)
        for port, size in (ports or {}).items()
    }


def sized(
    name: str, shapes: Mapping[str, Shape], sizes: Mapping[str, int]
) -> dict[str, Shape]:
    """Return shapes with numbers in place of named sizes."""
    numbers = {}
    for port, shape in shapes.items():
        for n in shape:
            if isinstance(n, str) and n not in sizes:
                raise BlockError(
                    f"{name}.{port}: the size '{n}' is not known. Give sizes={{'{n}': 3}}, or an "
                    "array of the parameters that has it by `shapes`"
                )
        numbers[port] = tuple(map(int, bound(shape, sizes)))
        check_count(f"{name}.{port} = {brief(shape)}", prod(numbers[port]))
    return numbers


def check_count(where: str, count: float, cure: str = "Give fewer signals") -> None:
    """Refuse more signals than a port may have."""
    if not count <= MOST_SIGNALS:
        raise BlockError(
            f"{where}: {count:.3g} signals; at most {MOST_SIGNALS:,} are allowed. {cure}"
        )


def sizes_of(shapes: Mapping[str, Shape]) -> dict[str, int]:
    """Return the number of signals of each port."""
    return {port: prod(shape) for port, shape in shapes.items()}


def places(shapes: Mapping[str, Shape]) -> Slices:
    """Return the slice of each port in the vector of all ports, and its shape."""
    slices = {}
    start = 0
    for port, shape in shapes.items():
        stop = start + prod(shape)
        slices[port] = slice(start, stop), shape
        start = stop
    return slices


class Vector(np.ndarray):
    """python-control's vector, with its ports as views: ``x[3]``, ``x.alpha``."""

    _ports: Mapping[str, tuple[slice, Shape]] = MappingProxyType({})

    def __getattr__(self, port: str) -> Any:
        if port not in self._ports:
            ports = ", ".join(self._ports) or "none"
            raise AttributeError(f"no port {port!r}; there are {ports}")
        signals, shape = self._ports[port]
        return self.view(np.ndarray)[signals].reshape(shape)


def vector(values: Any, ports: Slices) -> Vector:
    """Return numbers as a vector with ports; a vector that has these ports is returned."""
    if type(values) is Vector and values._ports is ports:
        return values
    x = np.asarray(values, dtype=float).view(Vector)
    x._ports = ports
    x.flags.writeable = False  # equations have no side effects
    return x


def reused_vector(values: np.ndarray, ports: Slices) -> Vector:
    """Return an array, to be filled many times, as a vector with stored views of its ports."""
    x = vector(values, ports)
    for port in ports:
        x.__dict__[port] = getattr(x, port)
    return x


def flattened(
    name: str, returned: Any, ports: Slices, size: int, spreads: bool = False
) -> np.ndarray:
    """Return a function's result, a mapping by port or numbers in order, as one vector.

    If it `spreads`, one number is the value of all signals, as in python-control.
    """
    if isinstance(returned, Mapping):
        check_ports(name, returned, ports)
        out = np.empty(size)
        for port, (signals, shape) in ports.items():
            value = np.asarray(returned[port], dtype=float)
            if value.shape != shape:
                value = shaped(name, port, value, shape, np.broadcast_to)
            out[signals] = value.ravel()
        return out
    if returned is None:
        raise BlockError(f"{name}: returns nothing; must return {list(ports)}")
    try:
        out = np.asarray(returned, dtype=float).ravel()
    except (TypeError, ValueError) as error:  # a list of arrays of several shapes
        if not isinstance(returned, list | tuple):
            raise BlockError(
                f"{name}: returns {brief(returned)}; must return numbers"
            ) from error
        out = np.concatenate([np.ravel(value) for value in returned]).astype(float)
    if spreads and len(out) == 1:
        out = np.full(size, out[0])
    if len(out) != size:
        raise BlockError(f"{name}: returns {len(out)} numbers; must return {size}")
    return out


def check_ports(
    name: str, returned: Mapping[str, Any], ports: Mapping[str, Any]
) -> None:
    """Refuse a mapping that has other names than the ports."""
    if returned.keys() != ports.keys():
        raise BlockError(f"{name}: returns {list(returned)}; must return {list(ports)}")


def shaped(name: str, port: str, value: Any, shape: Shape, filled: Callable) -> Any:
    """Return a value in the shape of its port: one number for all, or a row of numbers."""
    actual = getattr(value, "shape", ())
    if actual == shape:
        return value
    if not actual:
        return filled(value, shape)
    has_numbers = is_known(actual) and is_known(shape)
    if has_numbers and actual == (prod(shape),):
        return value.reshape(shape)
    raise BlockError(f"{name}: returns {port} of shape {actual}; must be {shape}")


# --- labels --------------------------------------------------------------------------------------


def labels(ports: Mapping[str, int] | None) -> list[str]:
    """Return the signal labels of ports: ``{"e": 2}`` is ``e[0], e[1]``."""
    return [f"{port}[{k}]" for port, size in (ports or {}).items() for k in range(size)]


def port_of(label: str) -> str:
    """Return the port of a signal's label."""
    return label.partition("[")[0]


def counts_of(labels: Iterable[str]) -> dict[str, int]:
    """Return the ports that labels form, each with its number of signals."""
    return {port: len(indices) for port, indices in ports_of(labels).items()}


def ports_of(labels: Iterable[str]) -> dict[str, list[int]]:
    """Return the ports that labels form, each with the indices of its signals by number.

    ``e[0], e[1]`` are the port e, in any order.  A name alone is a port of one signal, and so is a
    label whose port has not all numbers from 0.
    """
    signals: dict[str, dict[str, list[int]]] = {}
    for index, label in enumerate(labels):
        # y[2][0] is of the port y[2], as of sys[2, :]
        port, bracket, _ = label.rpartition("[")
        signals.setdefault(port if bracket else label, {}).setdefault(label, []).append(
            index
        )
    ports: dict[str, list[int]] = {}
    for port, indices in signals.items():
        numbered = [indices.get(f"{port}[{k}]", []) for k in range(len(indices))]
        if all(len(index) == 1 for index in numbered):
            indices = {port: [index[0] for index in numbered]}
        ports |= indices
    return dict(sorted(ports.items(), key=lambda item: min(item[1])))


def spans_of(labels: Sequence[str]) -> dict[str, slice]:
    """Return the slice of each port that labels form; signals apart have a slice for each label."""
    spans = {}
    for port, indices in ports_of(labels).items():
        start, stop = indices[0], indices[-1] + 1
        if indices == [*range(start, stop)]:
            spans[port] = slice(start, stop)
        else:
            spans |= {labels[k]: slice(k, k + 1) for k in indices}
    return dict(sorted(spans.items(), key=lambda item: item[1].start))


def indices_by_name(labels: Sequence[str]) -> dict[str, list[int]]:
    """Return the indices of signals by label, and by port where no label has its name."""
    by_label = {label: [k] for k, label in enumerate(labels)}
    return by_label | ports_of(labels) | by_label


def bare_labels(labels: Sequence[str]) -> list[str]:
    """Return labels, of a port of one signal its name: ``r[0]`` is ``r``."""
    bare = [*labels]
    for port, indices in ports_of(labels).items():
        if len(indices) == 1:
            bare[indices[0]] = port
    return bare if counts_of(bare) == counts_of(labels) else [*labels]


def whole_labels(labels: Iterable[str], names: Mapping[str, str] = {}) -> list[str]:
    """Return labels with a number for each signal: ``e, v[0]`` are ``e[0], v[0]``.

    `names` has new names of ports: {old: new}.
    """
    numbered = {
        index: f"{names.get(port, port)}[{k}]"
        for port, indices in ports_of(labels).items()
        for k, index in enumerate(indices)
    }
    return [numbered[index] for index in range(len(numbered))]


# --- other names -------------------------------------------------------------------------------


SEPARATOR = "/"


def named(space: str, name: str) -> str:
    """Return a name in a namespace."""
    return f"{space}{SEPARATOR}{name}"


def split(name: str) -> tuple[str, str]:
    """Return the namespace of a name, or "", and the name in it."""
    space, _, inner = name.rpartition(SEPARATOR)
    return space, inner


def within(block: Any, space: str) -> Any:
    """Return a block with its name and all its ports in a namespace."""
    ports = {*block.input_ports, *block.output_ports, *block.state_ports}
    names = {port: named(space, port) for port in ports}
    return renamed(block, named(space, block.name), names, names, names)


def renamed(
    block: Any,
    name: str,
    inputs: Mapping[str, str],
    outputs: Mapping[str, str],
    states: Mapping[str, str] | None = None,
) -> Any:
    """Return a copy of a block with another name, and new names of ports: {old: new}."""
    copy = block.copy(name=name)
    states = outputs if block.states_are_outputs else states or {}
    copy._name_ports({"inputs": inputs, "outputs": outputs, "states": states})
    return copy
