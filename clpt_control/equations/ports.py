"""Ports: named parts of python-control's vectors, each with a shape.

    inputs={"e": 2, "phi_x": "N"},  states={"alpha": (2, "N")}

A shape is a whole number, the name of a size, or a tuple of them; signals of a port are
labelled row by row, ``alpha[0]``, ``alpha[1]`` and so on.
"""

from collections.abc import Mapping
from math import prod
from typing import Any

import numpy as np

from ..errors import BlockError
from .record import Shape

Size = int | str  # a number, or the name of one
Declared = Mapping[str, Size | tuple[Size, ...]]  # port -> its shape


def shapes_of(ports: Declared | None) -> dict[str, Shape]:
    """Return the shape of each port as a tuple."""
    found = {}
    for port, size in (ports or {}).items():
        found[port] = tuple(size) if isinstance(size, tuple | list) else (size,)
    return found


def bound(name: str, shapes: Mapping[str, Shape], sizes: Mapping[str, int]) -> dict[str, Shape]:
    """Return shapes with their open sizes filled in."""
    found = {}
    for port, shape in shapes.items():
        for n in shape:
            if isinstance(n, str) and n not in sizes:
                raise BlockError(
                    f"{name}.{port}: the size '{n}' is not known; give sizes={{'{n}': 3}}, or an "
                    "array of the parameters that has it by `shapes`"
                )
        found[port] = tuple(sizes[n] if isinstance(n, str) else int(n) for n in shape)
    return found


def sizes_of(shapes: Mapping[str, Shape]) -> dict[str, int]:
    """Return the number of signals of each port."""
    return {port: prod(shape) for port, shape in shapes.items()}


def places(shapes: Mapping[str, Shape]) -> dict[str, tuple[slice, Shape]]:
    """Return where each port lies in the vector of all, and its shape."""
    found, at = {}, 0
    for port, shape in shapes.items():
        found[port] = (slice(at, at := at + prod(shape)), shape)
    return found


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
    made = np.asarray(values, dtype=float).view(Vector)
    made.places = where
    made.flags.writeable = False  # equations have no side effects
    return made


def kept_vector(values: np.ndarray, where: dict[str, tuple[slice, Shape]]) -> Vector:
    """Return an array that is filled again and again as a vector, its ports made once."""
    made = vector(values, where)
    for port, (part, shape) in where.items():
        made.__dict__[port] = made.view(np.ndarray)[part].reshape(shape)
    return made


def flattened(name: str, given: Any, where: dict[str, tuple[slice, Shape]], size: int) -> Any:
    """Return what a function returned, a mapping by port or numbers in order, as one vector."""
    if isinstance(given, Mapping):
        if given.keys() != where.keys():
            raise BlockError(f"{name}: returns {list(given)}; must return {list(where)}")
        out = np.empty(size)
        for port, (part, shape) in where.items():
            value = np.asarray(given[port], dtype=float)
            if value.shape != shape:
                value = _shaped(name, port, value, shape)
            out[part] = value.ravel()
        return out
    if given is None:
        raise BlockError(f"{name}: returns nothing; must return {list(where)}")
    if isinstance(given, list | tuple):
        parts = [np.ravel(one) for one in given]
        out = np.concatenate([np.zeros(0), *parts]).astype(float)
    else:
        out = np.asarray(given, dtype=float).ravel()
    if len(out) != size:
        raise BlockError(f"{name}: returns {len(out)} numbers; must return {size}")
    return out


def _shaped(name: str, port: str, value: np.ndarray, shape: Shape) -> np.ndarray:
    if value.size == prod(shape) and value.shape in ((), shape, (1,), (prod(shape),)):
        return value.reshape(shape)
    if value.ndim == 0:
        return np.full(shape, value)
    raise BlockError(f"{name}: returns {port} of shape {value.shape}; must be {shape}")
