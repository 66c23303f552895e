"""A block's equations for a generic number of basis functions.

The function is called with N a symbol.  Its vectors answer to indices such as
2 + N or i N + k, and `range(N)` runs its body with one symbolic index k.  A
term that holds k then stands for its sum over k = 1 ... N:

    f(N) = base + sum_k term(k)

The reading is sound where sums are used linearly.  That is checked by running
the body for no index, for k, and for k and l: with linear use the three
results superpose, f(k, l) - f(k) - f(l) + f() = 0; otherwise it is refused.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import sympy

from ..blocks import Block
from ..blocks.readers import rebind, undefined
from ..blocks.words import symbolic_substitutes
from ..errors import BlockError

N = sympy.Symbol("N", integer=True, positive=True)
K, L = sympy.symbols("k l", integer=True, positive=True)


class Summed(NamedTuple):
    """base + sum over k of term(k), k = 1 ... N.

    Attributes
    ----------
    base : sympy.Expr
        Free of the index k.
    term : sympy.Expr
        The summand; zero where there is no sum.
    """

    base: sympy.Expr
    term: sympy.Expr = sympy.Integer(0)

    def __add__(self, other: Any) -> "Summed":
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
    """A number of signals, rows N + more.

    Attributes
    ----------
    rows, more : int
        2 and 0 for alpha[2N], 2 and 4 for eta[2N + 4], 0 and 2 for e[2].
    """

    rows: int
    more: int


KNOWN_SIZES = {"phi_x": Size(1, 0), "phi_z": Size(1, 0), "alpha": Size(2, 0), "eta": Size(2, 4)}


def generic_size(port: str, size: int, functions: int) -> Size:
    """Tell how a port grows with N.

    Examples
    --------
    >>> generic_size("alpha", 6, 3)
    Size(rows=2, more=0)
    """
    if port in KNOWN_SIZES and size == KNOWN_SIZES[port].rows * functions + KNOWN_SIZES[port].more:
        return KNOWN_SIZES[port]
    if port in KNOWN_SIZES or (functions > 4 and size >= functions):
        return Size(*divmod(size, functions))
    return Size(0, size)


@dataclass
class Vector:
    """A vector of ports whose sizes may hold N.

    Attributes
    ----------
    ports : dict
        Port -> Size, in order.
    element : callable
        ``element(port, row, index)``: what stands there; row is None past the
        rows of N.
    start : sympy.Expr
        Where this view starts in the whole.
    stored : dict
        What was written, by (port, row, index).
    """

    ports: Mapping[str, Size]
    element: Callable[[str, Any, Any], Any]
    start: Any = 0
    stored: dict | None = None

    def _place(self, index: Any) -> tuple[str, Any, Any]:
        position = sympy.expand(sympy.sympify(index) + self.start)
        for port, size in self.ports.items():
            rows = position.coeff(N)
            rest = sympy.expand(position - rows * N)
            if rows.is_Integer and 0 <= rows < size.rows:
                if rest in (K, L):
                    return port, int(rows), rest
                if rest.is_Integer and rest >= 0:
                    return port, int(rows), int(rest)
            if rows == size.rows and rest.is_Integer and 0 <= rest < size.more:
                return port, None, int(rest)
            position = sympy.expand(position - size.rows * N - size.more)
        raise BlockError(f"index {index} lies in no port of {', '.join(self.ports)}")

    def __getitem__(self, index: Any) -> Any:
        """Read an element, or view a slice from its start."""
        if isinstance(index, slice):
            start = 0 if index.start is None else index.start
            return Vector(self.ports, self.element, self.start + start, self.stored)
        place = self._place(index)
        if self.stored is not None:
            if place not in self.stored:
                raise BlockError(f"{place[0]} is read before it is written")
            return self.stored[place]
        return self.element(*place)

    def __setitem__(self, index: Any, value: Any) -> None:
        """Write an element of an output."""
        if self.stored is None:
            raise BlockError("a block writes only its last argument")
        self.stored[self._place(index)] = sympy.sympify(value)


def element_symbol(name: str, row: Any, index: Any) -> sympy.Expr:
    """Give the symbol of one signal: alpha_1[k], K_2, phi_x[k].

    Examples
    --------
    >>> element_symbol("alpha", 0, K)
    alpha_1[k]
    """
    if row is None:
        return sympy.Symbol(f"{name}_{index + 1}", real=True)
    label = name if name.startswith("phi") else f"{name}_{row + 1}"
    return sympy.IndexedBase(label, real=True)[index if index in (K, L) else index + 1]


class ParameterArray:
    """A parameter array on symbols, such as theta[i, k] or KD[i]."""

    def __init__(self, name: str, positive: bool):
        self.name, self.positive = name, positive

    def __getitem__(self, index: Any) -> sympy.Expr:
        """Give the symbol: theta_1[k] for two indices, KD_1 for one."""
        if isinstance(index, tuple):
            row, place = index
            return sympy.IndexedBase(f"{self.name}_{row + 1}", real=True)[place]
        sort = {"positive": True} if self.positive else {"real": True}
        return sympy.Symbol(f"{self.name}_{index + 1}", **sort)


def _range_over(indices: tuple) -> Callable:
    def symbolic_range(count: Any) -> Iterator:
        if isinstance(count, int):
            return iter(range(count))
        if count == N:
            return iter(indices)
        raise BlockError(f"range({count}): with a generic N only range(p.N) can be read")

    return symbolic_range


class GenericBlock(NamedTuple):
    """A block's outputs and rates for a generic N.

    Attributes
    ----------
    outputs, rates : dict
        (port, row) -> the element k of that row, an expression; (port, j) with
        an ordinary number past the rows -> `Summed`.
    """

    outputs: dict
    rates: dict


def read_function(function: Any, block: Block, p: Any, sizes: Mapping, out: Mapping) -> dict:
    """Read one of a block's functions with N a symbol.

    Parameters
    ----------
    function : function
        The block's update or output.
    block : Block
        The block.
    p : NamedTuple
        Its parameters on symbols.
    sizes : mapping
        ``"states"`` and ``"inputs"`` -> {port: Size}.
    out : mapping
        The ports written, {port: Size}.

    Returns
    -------
    dict
        (port, row, None) -> element k of a row, (port, None, j) -> Summed.

    Raises
    ------
    BlockError
        If a sum over k is used in a way that does not superpose, or an
        element of the output is left unwritten.
    """
    from .trace import TIME

    results = []
    for indices in ((), (K,), (K, L)):
        substitutes = {**symbolic_substitutes(), "range": _range_over(indices)}
        stored: dict = {}
        x, u = (Vector(sizes[part], element_symbol) for part in ("states", "inputs"))
        y = Vector(out, element_symbol, 0, stored)
        rebind(function, substitutes, opaque=undefined)(TIME, x, u, p, y)
        results.append({key: sympy.nsimplify(value, rational=True)
                        for key, value in stored.items()})  # fmt: skip
    none, one, two = results
    read: dict = {}
    for port, size in out.items():
        for row in range(size.rows):
            if (port, row, K) not in one:
                raise BlockError(f"{block.name}: {port}_{row + 1}[k] is not written")
            value = one[(port, row, K)]
            if two[(port, row, K)] != value or two[(port, row, L)] != value.subs(K, L):
                raise BlockError(f"{block.name}: {port}_{row + 1}[k] depends on other k")
            read[(port, row, None)] = value
        for j in range(size.more):
            place = (port, None, j)
            if place not in one or place not in none:
                raise BlockError(f"{block.name}: {port}_{j + 1} is not written for every N")
            alone = one[place]
            rest = two[place] - alone - alone.subs(K, L) + none[place]
            if sympy.expand(rest) != 0:
                raise BlockError(
                    f"{block.name}: {port}_{j + 1} uses a sum over k = 1 ... N in a way that is "
                    "not linear; keep sums apart until they are complete"
                )
            read[place] = Summed(none[place], sympy.expand(alone - none[place]))
    return read
