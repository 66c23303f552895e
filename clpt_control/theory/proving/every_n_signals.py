"""Signals for every number N of basis functions: their sizes, and base + sum_k term(k).

A port has rows of N signals and single ones.  A row is known by its element k, an expression of
k = 1 ... N; a single signal is a `Summed`.
"""

from typing import NamedTuple

import sympy

from ...equations.namespaces import split
from ...errors import BlockError


class Summed(NamedTuple):
    """base + sum over k of term(k), k = 1 ... N."""

    base: sympy.Expr  # free of the index k
    term: sympy.Expr = sympy.Integer(0)

    def plus(self, other: "Summed") -> "Summed":
        """Add two sums term by term."""
        return Summed(self.base + other.base, self.term + other.term)

    def times(self, other: "Summed") -> "Summed":
        """Multiply; a product of two sums is refused."""
        if other.term == 0:
            return Summed(self.base * other.base, self.term * other.base)
        if self.term == 0:
            return Summed(self.base * other.base, self.base * other.term)
        raise BlockError("a product of two sums over k = 1 ... N cannot be read term by term")

    def expanded(self) -> "Summed":
        """Multiply out, so that cancelling terms vanish."""
        return Summed(sympy.expand(self.base), sympy.expand(self.term))


class Size(NamedTuple):
    """A number of signals, rows N + more: 2 and 4 for eta[2N + 4], 0 and 2 for e[2]."""

    rows: int
    more: int


KNOWN_SIZES = {
    "phi_x": Size(1, 0),
    "phi_z": Size(1, 0),
    "alpha": Size(2, 0),
    "pull": Size(2, 0),
    "eta": Size(2, 4),
}
Key = tuple[str, int | None, int | None]  # (port, row, None) or (port, None, number)


def port_size(port: str, size: int, functions: int) -> Size:
    """Return how a port grows with N, by its name: phi, alpha, pull and eta do."""
    known = KNOWN_SIZES.get(split(port)[1])
    if known is None:
        return Size(0, size)
    if size != known.rows * functions + known.more:
        raise BlockError(f"{port} has {size} signals, which does not go with N = {functions}")
    return known


def keys(ports: dict[str, Size]) -> dict[tuple[int, int], Key]:
    """Return what stands at the place c + n N of ports, by (c, n)."""
    found: dict[tuple[int, int], Key] = {}
    c = n = 0
    for port, size in ports.items():
        for row in range(size.rows):
            found[c, n] = (port, row, None)
            n += 1
        for number in range(size.more):
            found[c, n] = (port, None, number)
            c += 1
    return found
