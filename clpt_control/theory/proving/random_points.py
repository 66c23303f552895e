"""Random points and parameters at which the running blocks are called.

Wide ranges, zeros and kinks; a parameter keeps its sign, and one that is zero stays zero.
"""

from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from ...equations.namespaces import BETWEEN, named, split
from .array_loop import TIME
from .symbolic_loop import SymbolicLoop

LARGEST = 1e6  # of the kinks that are tried


class Point(NamedTuple):
    """Where the blocks are called: ``diagram.dynamics(*point)``."""

    t: float
    x: np.ndarray  # states of the diagram
    u: np.ndarray  # its inputs
    params: dict[str, Any]  # call-time parameters, ``{"block.field": value}``


def own_numbers(loop: SymbolicLoop, block: Block) -> dict[Any, float]:
    """Return symbol -> its number, of a block's parameters."""
    found: dict[Any, float] = {}
    for own, value in block.parameters._asdict().items():
        symbols = getattr(loop.parameters[block.name], own)
        if not isinstance(value, int) and own != "interval":
            numbers = np.broadcast_to(np.asarray(value, dtype=float), np.shape(symbols))
            found.update(zip(np.ravel(symbols), numbers.ravel().tolist(), strict=True))
    return {symbol: number for symbol, number in found.items() if symbol.is_Symbol}


class Draw:
    """A source of random parameters and points for the blocks of a diagram."""

    def __init__(self, blocks: Sequence[Block], loop: SymbolicLoop, seed: int):
        self.random, self.blocks, self.loop = np.random.default_rng(seed), blocks, loop
        lines = [o for b in blocks for r in b.records.values() for o in r.operations]
        numbers = {a for o in lines for a in o.arguments if type(a) is float and np.isfinite(a)}
        held = [np.ravel(v) for b in blocks for v in b.parameters if not isinstance(v, int)]
        known = np.concatenate([np.array(sorted(numbers)), np.zeros(1), *held])
        known = known[np.abs(known) <= LARGEST]
        self.kinks = np.concatenate([known, -known])

    def parameters(self, kept: Collection[str] = (), largest: float = 1.5) -> dict[Any, float]:
        """Return symbol -> a number of its sign, of the size 10^-1.5 to 10^largest.

        The blocks in `kept` keep their own.
        """
        values: dict[Any, float] = {}
        for block in self.blocks:
            own = own_numbers(self.loop, block)
            if block.name not in kept:
                sizes = 10.0 ** self.random.uniform(-1.5, largest, len(own))
                signs = self.random.choice([-1.0, 1.0], len(own))
                for s, size, sign in zip(own, sizes.tolist(), signs.tolist(), strict=True):
                    own[s] = size if s.is_positive else -size if s.is_negative else sign * size
            values = own | values
        return values

    def params(self, values: Mapping[Any, float]) -> dict[str, Any]:
        """Return the numbers of symbols as call-time parameters."""
        found: dict[str, Any] = {}
        for block in self.blocks:
            for own, value in block.parameters._asdict().items():
                if not isinstance(value, int) and own != "interval":
                    numbers = numbers_at(values, getattr(self.loop.parameters[block.name], own))
                    found[f"{block.name}.{own}"] = numbers if np.ndim(value) else float(numbers)
        return found

    def points(self, count: int, n: int) -> np.ndarray:
        """Return points of n numbers: wide ranges, zeros, kinks."""
        random = self.random
        found = random.standard_normal((count, n)) * 10.0 ** random.uniform(-2, 4, (count, 1))
        found *= random.random((count, n)) > 0.1 * (random.random((count, 1)) < 0.5)
        kinked = random.random((count, n)) < 0.15 * (random.random((count, 1)) < 0.3)
        found[kinked] = random.choice(self.kinks, int(kinked.sum()))
        return found

    def at(self, values: Mapping[Any, float], t: Any, x: np.ndarray, u: np.ndarray) -> dict:
        """Return symbol -> number, of parameters and of points."""
        found: dict[Any, Any] = {**values, TIME: t}
        for ports, numbers in ((self.loop.states, x), (self.loop.inputs, u)):
            flat = [s for symbols in ports.values() for s in symbols.flat]
            found.update(zip(flat, numbers.T, strict=True))
        return found


def numbers_at(values: Mapping[Any, float], symbols: Any) -> np.ndarray:
    """Return the numbers of symbols, in their shape; what is zero is no symbol."""
    flat = [float(values.get(s, s)) for s in np.ravel(symbols)]
    return np.reshape(flat, np.shape(symbols))


def equate_x_and_z(loop: SymbolicLoop, x: np.ndarray, random: np.random.Generator) -> None:
    """Set x = z at some points: e = 0."""
    flat = {str(s): k for k, s in enumerate(loop.motion)}
    for name, a in flat.items():
        b = flat.get(named(split(name)[0], f"z_{name[-1]}").lstrip(BETWEEN))
        if split(name)[1] not in ("x_1", "x_2") or b is None:
            continue
        equal = random.random(len(x)) < 0.1
        x[equal, a] = x[equal, b]
