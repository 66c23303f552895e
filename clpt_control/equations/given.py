"""What a function is called with while it is read: states, inputs and parameters without values."""

from collections.abc import Mapping
from math import prod
from typing import Any

from .arrays import Array, Tape
from .record import Shape


class Ports(Array):
    """States or inputs without values: a vector, with its ports as views."""

    __slots__ = ("_joined", "_ports")

    def __init__(self, tape: Tape, group: str, shapes: Mapping[str, Shape], fixed: bool = True):
        self._ports = {
            port: tape.add("leaf", (), shape, (group, port)) for port, shape in shapes.items()
        }
        known = all(isinstance(n, int) for shape in shapes.values() for n in shape)
        size: Any = sum(map(prod, shapes.values())) if known else f"len({group})"
        self._joined: int | None = None
        super().__init__(tape, -1, (size,))
        self._fixed = fixed
        for leaf in self._ports.values():
            leaf._fixed = True

    @property
    def _node(self) -> int:
        """Return the vector of all ports, one behind the other."""
        if self._joined is None:
            self._counted()
            rows = [row for leaf in self._ports.values() for row in _rows(leaf)]
            if not rows:
                self._joined = self._tape.add("constant", (), (0,), b"")._node
            elif len(rows) == 1:
                self._joined = rows[0]._node
            else:
                refs = [row._ref for row in rows]
                self._joined = self._tape.add("join", refs, self.shape)._node
        return self._joined

    @_node.setter
    def _node(self, value: int) -> None:
        pass

    def __getattr__(self, name: str) -> Any:
        if name in self._ports:
            return self._ports[name]
        return super().__getattr__(name)


def _rows(array: Any) -> list[Array]:
    """Return the rows of an array of any number of axes."""
    return [array] if array.ndim == 1 else [row for part in array for row in _rows(part)]


class Fields:
    """Parameters without values, as a function asks for them: p.gain, p["gain"], p.get."""

    def __init__(self, values: dict[str, Any]) -> None:
        self.__dict__.update(values)

    def __getitem__(self, name: Any) -> Any:
        return self.__dict__[name]

    def get(self, name: str, default: Any = None) -> Any:
        """Return a parameter, or the default where there is none."""
        return self.__dict__.get(name, default)

    def __contains__(self, name: str) -> bool:
        return name in self.__dict__

    def keys(self) -> Any:
        """Return the names."""
        return self.__dict__.keys()
