"""A block's equations for every number N of basis functions.

The record of a run for every N (`every_n_run`) is rolled into its loops, of which all
turns are the same and hand on nothing but sums.  One turn on symbols then gives

    y = base + sum_k term(k),    k = 1 ... N

for a single number, and an expression of k for the element k of a row of N.
"""

from collections.abc import Callable
from math import inf
from typing import Any

import numpy as np
import sympy

from ...blocks.tracers import Tape
from ...equations.block import Block
from ...equations.symbolic import OPERATIONS, exact
from ...errors import BlockError
from ...native.loops import roll
from ...native.program import Loop, Step, Store
from ...native.rolled import Constant, Place, Rolled
from .every_n_run import BIG, TURNS, ParameterArray, Vector, WholeNumber, run
from .every_n_signals import Key, Size, Summed, keys
from .undefined import undefined


def read_function(
    block: Block,
    role: str,
    sizes: dict[str, dict[str, Size]],
    leaf: Callable[..., Any],
    warn: Callable[[str], None],
) -> dict[Key, Any]:
    """Read a block's update or output (`role`) for every N; what is refused may be right.

    sizes: ``"x"``, ``"u"`` and ``"out"`` -> {port: Size}; ``leaf("t")``, ``leaf("u", key)`` and
    ``leaf("p", field, places)``, a place None being the index k, return an expression or
    Summed; `warn` is called with each sentence about what may have no value.
    """
    function = getattr(block, f"{role}_function")
    tape, written = Tape(), {}  # type: ignore[var-annotated]
    N = getattr(block.parameters, "N", 0)
    lengths = {
        name: WholeNumber(sum(s.more for s in ports.values()), sum(s.rows for s in ports.values()))
        for name, ports in sizes.items()
    }
    given = [Vector(tape, name, WholeNumber(0), lengths[name]) for name in "xu"]

    def parameter(field: str, value: Any) -> Any:
        if field == "N":
            return WholeNumber(0, 1)
        if isinstance(value, int):
            return value
        return (
            ParameterArray(tape, field, np.shape(value), N)
            if np.ndim(value)
            else tape.add("p", field, 0)
        )

    fields = zip(block.parameters._fields, block.parameters, strict=True)
    p = type(block.parameters)(*(parameter(field, value) for field, value in fields))
    out = Vector(tape, "out", WholeNumber(0), lengths["out"], written)
    try:
        record = run(function, tape, (tape.add("t"), *given, p, out), written)
        reader = _Reader(block, {name: keys(ports) for name, ports in sizes.items()}, leaf, warn)
        raw = reader.read(roll(record, least=inf))
        found = {key: raw[k] for k, key in enumerate(written)}
        values = {
            key: reader.row([found.pop((*at, turn)) for turn in range(TURNS)])
            if key[1] is not None
            else reader.single(found.pop((*at, None)))
            for at, key in keys(sizes["out"]).items()
        }
        if found:
            raise BlockError("it writes a single place among N")
        return values
    except Exception as error:  # whatever Python says of these equations
        raise BlockError(f"{block.name}.{role} is not read for every N: {error}") from None


def _moved(value: Any, k: int) -> Any:
    """Return what the turn k of a loop that fills `out` stores."""
    if not isinstance(value, Place) or not value.steps:
        return value
    return Place(value.array, value.base + k * value.steps[0][1])


class _Reader:
    """Evaluate a rolled record on symbols, one turn for all."""

    def __init__(self, block: Block, layout: dict, leaf: Callable, warn: Callable):
        self.block, self.layout, self.leaf, self.warn = block, layout, leaf, warn
        self.values: dict[int, Any] = {}
        self.memory: dict[int, sympy.Expr] = {}  # S

    def read(self, found: Rolled) -> dict[int, Any]:
        """Run the items; return what is stored for each output, not yet evaluated."""
        outputs: dict[int, Any] = {}
        for item in found.items:
            first = item.body[0] if isinstance(item, Loop) and item.body else item
            if isinstance(first, Store) and first.array == "out":
                value, count = first.value, item.count if isinstance(item, Loop) else 1
                for k in range(count):
                    outputs[first.base + k] = _moved(value, k)
            else:
                self.do(item, None)
        return outputs

    def do(self, item: Any, level: int | None) -> None:
        if isinstance(item, Step):
            self.values[item.value] = self.step(item, level)
        elif isinstance(item, Loop):
            self.loop(item, level)
        else:  # S, a number for each turn
            value = self.argument(item.value, level)
            if isinstance(value, Summed):
                raise BlockError("an element depends on a sum over k = 1 ... N")
            self.memory[item.base] = value

    def loop(self, item: Loop, level: int | None) -> None:
        if level is not None:
            raise BlockError("a loop inside a loop over all functions")
        firsts = [self.argument(s.first, None) for s in item.sums]
        self.values.update({s.within: sympy.Integer(0) for s in item.sums})
        for part in item.body:
            self.do(part, item.level)
        for s, first in zip(item.sums, firsts, strict=True):
            turned = self.values[s.turned]
            if isinstance(turned, Summed):
                raise BlockError("a sum over k = 1 ... N of sums over k = 1 ... N")
            start = first if isinstance(first, Summed) else Summed(first)
            self.values[s.result] = start.plus(Summed(sympy.Integer(0), turned))

    def single(self, raw: Any) -> Summed:
        """Return one number of the output."""
        value = self.argument(raw, None)
        return value if isinstance(value, Summed) else Summed(value)

    def row(self, turns: list[Any]) -> sympy.Expr:
        """Return the element k of a row, from what the turns left."""
        first, last = turns[0], turns[-1]
        if isinstance(first, Place) and isinstance(last, Place) and first != last:
            step, odd = divmod(last.base - first.base, TURNS - 1)
            if odd or turns != [Place(first.array, first.base + k * step) for k in range(TURNS)]:
                raise BlockError("the elements of a row differ")
            value = self.argument(Place(first.array, first.base, ((0, step),)), 0)
        elif any(turn != first for turn in turns):
            raise BlockError("the elements of a row differ")
        else:
            value = self.argument(first, None)
        if isinstance(value, Summed) and value.term == 0:
            return value.base
        if isinstance(value, Summed):
            raise BlockError("an element depends on a sum over k = 1 ... N")
        return value

    def step(self, item: Step, level: int | None) -> Any:
        arguments = [self.argument(a, level) for a in item.arguments]
        if not any(isinstance(a, Summed) and a.term != 0 for a in arguments):
            arguments = [a.base if isinstance(a, Summed) else a for a in arguments]
            sentence = undefined(item.name, tuple(arguments))
            if sentence is not None:
                self.warn(sentence)
            return OPERATIONS[item.name](*arguments)
        sums = [a if isinstance(a, Summed) else Summed(a) for a in arguments]
        minus = Summed(sympy.Integer(-1))
        if item.name == "neg":
            return sums[0].times(minus)
        if item.name in ("add", "sub"):
            return sums[0].plus(sums[1] if item.name == "add" else sums[1].times(minus))
        if item.name == "mul":
            return sums[0].times(sums[1])
        if item.name == "div" and sums[1].term == 0:
            sentence = undefined("div", (sums[0].base, sums[1].base))
            if sentence is not None:
                self.warn(sentence)
            return sums[0].times(Summed(1 / sums[1].base))
        raise BlockError(f"`{item.name}` of a sum over k = 1 ... N")

    def argument(self, a: Any, level: int | None) -> Any:
        if isinstance(a, Constant):
            return exact(a.value)
        if isinstance(a, int):
            return self.values[a]
        if not isinstance(a, Place):
            raise BlockError("a table that is looked up")
        if a.array == "t":
            return self.leaf("t")
        if a.array == "S":
            if level is not None and a.steps == ((level, 1),) and a.base in self.memory:
                return self.memory[a.base]
            raise BlockError("what a single turn computed is used behind its loop")
        if a.array not in ("x", "u") and a.array[0] != "p":
            raise BlockError("turns differ in a constant")
        steps = dict(a.steps)
        if set(steps) - {level}:
            raise BlockError("turns read places far apart")
        step = steps.get(level or 0, 0)
        if a.array in ("x", "u"):
            n, c = divmod(a.base, BIG)
            if step not in (0, 1):
                raise BlockError("turns read places far apart")
            key = self.layout[a.array].get((c, n))
            if step and key is not None and key[1] is not None:
                return self.leaf(a.array, key)
            if not step and key is not None and key[1] is None:
                return self.leaf(a.array, key)
            raise BlockError("a single place among N is read, or places side by side")
        field = a.array[1]
        return self.leaf("p", field, self.places(field, a.base, step))

    def places(self, field: str, code: int, step: int) -> tuple[int | None, ...]:
        """Return the places in a parameter array; None is the index k."""
        found: list[int | None] = []
        for _ in range(np.ndim(getattr(self.block.parameters, field))):
            code, place = divmod(code, BIG)
            step, here = divmod(step, BIG)
            if here not in (0, 1) or (here and place):
                raise BlockError(f"`p.{field}` is read at places far apart")
            found.insert(0, None if here else place)
        return tuple(found)
