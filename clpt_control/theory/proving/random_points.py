"""Random points and parameters at which the running blocks are called.

Wide ranges, zeros and kinks; a parameter keeps its sign, and one that is zero stays zero.
"""

from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import sympy

from ...equations.block import Block
from ...equations.namespaces import BETWEEN, named, split
from .array_loop import TIME
from .paper_symbols import SCALARS, parameter_names
from .symbolic_loop import SymbolicLoop

LARGEST = 1e6  # of the kinks that are tried


class Point(NamedTuple):
    """Where the blocks are called: ``diagram.dynamics(*point)``."""

    t: float
    x: np.ndarray  # states of the diagram
    u: np.ndarray  # its inputs
    params: dict[str, Any]  # call-time parameters, ``{"block.field": value}``


class Draw:
    """A source of random parameters and points for the blocks of a diagram."""

    def __init__(self, blocks: Sequence[Block], seed: int):
        self.random, self.blocks = np.random.default_rng(seed), blocks
        self.names = parameter_names(blocks)
        lines = [o for b in blocks for r in b.records.values() for o in r.operations]
        numbers = {a for o in lines for a in o.arguments if type(a) is float and np.isfinite(a)}
        held = [np.ravel(v) for b in blocks for v in b.parameters if not isinstance(v, int)]
        known = np.concatenate([np.array(sorted(numbers)), np.zeros(1), *held])
        known = known[np.abs(known) <= LARGEST]
        self.kinks = np.concatenate([known, -known])

    def parameters(self, kept: Collection[str] = (), largest: float = 1.5) -> dict[str, np.ndarray]:
        """Return values by name, of the size 10^-1.5 to 10^largest."""
        values: dict[str, np.ndarray] = {}
        for block in self.blocks:
            for field, value in block.parameters._asdict().items():
                name = self.names[block.name, field]
                if isinstance(value, int) or name in values or field == "interval":
                    continue
                own = np.asarray(value, dtype=float)
                if name in SCALARS:
                    own = np.ravel(own)[0]
                if block.name in kept:
                    values[name] = own
                    continue
                drawn = 10.0 ** self.random.uniform(-1.5, largest, own.shape)
                if not np.any(own):
                    drawn = own
                elif np.all(own < 0):
                    drawn = -drawn
                elif not np.all(own > 0):
                    drawn *= self.random.choice([-1.0, 1.0], own.shape)
                values[name] = drawn
        return values

    def params(self, values: Mapping[str, np.ndarray]) -> dict[str, Any]:
        """Return values by name as call-time parameters."""
        found = {}
        for block in self.blocks:
            for field, own in block.parameters._asdict().items():
                name = self.names[block.name, field]
                if name not in values or isinstance(own, int):
                    continue
                value = values[name]
                if name in SCALARS:
                    value = np.full(np.shape(own), float(value))
                found[f"{block.name}.{field}"] = float(value) if np.ndim(own) == 0 else value
        return found

    def points(self, count: int, n: int) -> np.ndarray:
        """Return points of n numbers: wide ranges, zeros, kinks."""
        random = self.random
        found = random.standard_normal((count, n)) * 10.0 ** random.uniform(-2, 4, (count, 1))
        found *= random.random((count, n)) > 0.1 * (random.random((count, 1)) < 0.5)
        kinked = random.random((count, n)) < 0.15 * (random.random((count, 1)) < 0.3)
        found[kinked] = random.choice(self.kinks, int(kinked.sum()))
        return found


def symbol_values(
    loop: SymbolicLoop, draw: Draw, values: Mapping[str, np.ndarray], *point: Any
) -> dict[Any, Any]:
    """Return symbol -> number, of parameters and of points (t, x, u)."""
    found: dict[Any, Any] = {}
    for block in draw.blocks:
        own = loop.parameters[block.name]
        for field, symbols in own._asdict().items():
            name = draw.names[block.name, field]
            if name in values and not isinstance(symbols, int):
                numbers = np.broadcast_to(values[name], np.shape(symbols) or np.shape(values[name]))
                pairs = zip(np.ravel(np.asarray(symbols, object)), np.ravel(numbers), strict=False)
                found.update({s: v for s, v in pairs if isinstance(s, sympy.Symbol)})
    if point:
        t, x, u = point
        found[TIME] = t
        for ports, numbers in ((loop.states, x), (loop.inputs, u)):
            flat = [s for symbols in ports.values() for s in symbols.flat]
            found.update(dict(zip(flat, numbers.T, strict=True)))
    return found


def equate_x_and_z(loop: SymbolicLoop, x: np.ndarray, random: np.random.Generator) -> None:
    """Set x = z at some points: e = 0."""
    flat = {str(s): k for k, s in enumerate(loop.motion)}
    for name, a in flat.items():
        b = flat.get(named(split(name)[0], f"z_{name[-1]}").lstrip(BETWEEN))
        if split(name)[1] not in ("x_1", "x_2") or b is None:
            continue
        equal = random.random(len(x)) < 0.1
        x[equal, a] = x[equal, b]
