"""The order in which the blocks of a diagram are computed, once each.

A block comes when all signals that reach its outputs at once are known.  Where blocks wait for each
other, they are ordered signal by signal, and a block that stands in the circle twice is computed in
parts.  A circle of signals is an algebraic loop, which is refused.
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np

from ...errors import DiagramError
from ..model.block import Block
from ..model.ports import places as inputs_of
from ..model.sampled import Sampled
from ..model.system import is_linear, with_constants
from ..record.scalar_graph import InputsOf
from ..trace.arrays import Unread

TRIED = 3  # points at which a function that cannot be read is tried


def order_of(nodes: list[Any]) -> tuple[int, ...]:
    """Return the order in which blocks are computed; a block that is computed in parts is twice.

    The linear blocks of a circle are replaced in `nodes`.
    """
    owner = [k for k, node in enumerate(nodes) for _ in range(node.system.noutputs)]
    waits = {k: {owner[source] for _, source, _ in node.fed()} for k, node in enumerate(nodes)}
    # an unread function is tried, which may change what it keeps: not one that waits for none
    waits = {
        k: own if own and reaches_outputs(nodes[k].system) else set() for k, own in waits.items()
    }
    order: list[int] = []
    done: set[int] = set()
    while waits:
        ready = next((k for k, feeding in waits.items() if feeding <= done), None)
        if ready is None:
            return _by_signals(nodes, order, waits)
        order.append(ready)
        done.add(ready)
        del waits[ready]
    return tuple(order)


def _by_signals(nodes: list[Any], order: list[int], waits: dict[int, set[int]]) -> tuple[int, ...]:
    """Return the order of blocks in a circle: each output comes after the inputs that reach it."""
    known = {s for k in order for s in range(nodes[k].outputs.start, nodes[k].outputs.stop)}
    needed: dict[int, dict[int, set[int]]] = {}  # block -> signal -> the signals that it waits for
    for k in waits:
        fed: dict[int, set[int]] = {}
        for to, source, _ in nodes[k].fed():
            fed.setdefault(to, set()).add(source)
        first = nodes[k].outputs.start
        needed[k] = {
            first + i: set().union(*(fed.get(j, set()) for j in inputs))
            for i, inputs in enumerate(_through(nodes[k].system))
        }
    while needed:
        computable = {k: {s for s, own in needed[k].items() if own <= known} for k in needed}
        ready = next((k for k in needed if len(computable[k]) == len(needed[k])), None)
        if ready is None:
            ready = next((k for k in needed if computable[k]), None)
        if ready is None:
            if _by_entries(nodes, waits):
                return order_of(nodes)
            raise DiagramError(
                f"algebraic loop: {_circle(waits, nodes)} feed each other at once; "
                "break the circle with a block that has states"
            )
        order.append(ready)
        known |= computable[ready]
        needed[ready] = {s: own for s, own in needed[ready].items() if s not in known}
        if not needed[ready]:
            del needed[ready], waits[ready]
    return tuple(order)


def _by_entries(nodes: list[Any], waits: Iterable[int]) -> bool:
    """Make matrices of linear blocks in a circle constants, of which zeros feed nothing at once."""
    within = [k for k in waits if is_linear(nodes[k].system)]
    for k in within:
        nodes[k] = replace(nodes[k], system=with_constants(nodes[k].system))
    return bool(within)


def _circle(waits: dict[int, set[int]], nodes: list[Any]) -> str:
    path = [next(iter(waits))]
    while path.count(path[-1]) < 2:
        path.append(next(k for k in waits[path[-1]] if k in waits))
    return " <- ".join(nodes[k].name for k in path[path.index(path[-1]) :])


def asked_at_once(block: Block) -> Block:
    """Return the block whose equations say what reaches the outputs as inputs are sampled."""
    return block.inner if isinstance(block, Sampled) else block


def reaches_outputs(block: Block) -> bool:
    """Return whether inputs reach outputs at once, or once sampled; an unread function is tried."""
    block = asked_at_once(block)
    try:
        return bool(block.array_record("output").leaves("u"))
    except Unread:
        return any(_tried(block))


def _through(block: Block) -> list[set[int]]:
    """Return for each output the inputs that reach it at once."""
    block = asked_at_once(block)
    try:
        record = block.array_record("output")
        ports = InputsOf(record.operations, block.sizes).outputs(record)
    except Unread:
        return _tried(block)
    places = {
        (port, k): own.start + k
        for port, (own, _) in inputs_of(block.input_shapes).items()
        for k in range(own.stop - own.start)
    }
    return [{places[one] for one in port} for port in ports]


def _tried(block: Block) -> list[set[int]]:
    """Return the inputs that change each output at some points."""
    random, p = np.random.default_rng(0), block.parameters_at(0.0)
    reaching: list[set[int]] = [set() for _ in range(block.noutputs)]
    for _ in range(TRIED):
        x, u = (random.standard_normal((n,)) for n in (block.nstates, block.ninputs))
        before = block.values("output", block.noutputs, 0.0, x, u, p)
        for j in range(block.ninputs):
            moved = u.copy()
            moved[j] = random.standard_normal()
            after = block.values("output", block.noutputs, 0.0, x, moved, p)
            for i in np.flatnonzero((after != before) & ~(np.isnan(after) & np.isnan(before))):
                reaching[i].add(j)
    return reaching
