"""Order of evaluation of a diagram's blocks.

A block is evaluated when all signals with direct feedthrough to its outputs are known.  Blocks that
wait for each other are ordered signal by signal; a block may then occur twice.  A loop of signals
is an algebraic loop, which is refused.
"""

from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np

from ...base.errors import DiagramError
from ..model.block import Block
from ..model.ports import places
from ..model.sampled import Sampled
from ..model.system import is_linear, with_constants
from ..record.scalar_graph import InputsOf
from ..record.unread import Unread

TEST_POINTS = 3  # for the feedthrough of a function that cannot be traced


def order_of(nodes: list[Any]) -> tuple[int, ...]:
    """Return the order of evaluation; a block that is evaluated in two steps occurs twice.

    Linear blocks of a loop are replaced in `nodes`.
    """
    producers = [k for k, node in enumerate(nodes) for _ in range(node.system.noutputs)]
    waits: dict[int, set[int]] = {}  # block -> the blocks that it waits for
    for k, node in enumerate(nodes):
        sources = {producers[source] for _, source, _ in node.fed()}
        # an untraced function is called, which may change its hidden state: only if it has sources
        waits[k] = sources if sources and reaches_outputs(node.system) else set()
    order: list[int] = []
    while waits:
        ready = next(
            (k for k, sources in waits.items() if sources.isdisjoint(waits)), None
        )
        if ready is None:
            return _by_signals(nodes, order, waits)
        order.append(ready)
        del waits[ready]
    return tuple(order)


def _by_signals(
    nodes: list[Any], order: list[int], waits: dict[int, set[int]]
) -> tuple[int, ...]:
    """Return the order of blocks that wait for each other, signal by signal."""
    computed: set[int] = set()
    for k in order:
        outputs = nodes[k].outputs
        computed.update(range(outputs.start, outputs.stop))
    needed = {k: _needed_signals(nodes[k]) for k in waits}
    while needed:
        computable = {
            k: {s for s, sources in signals.items() if sources <= computed}
            for k, signals in needed.items()
        }
        # first a block with all its outputs, then one with some of them
        complete = (k for k in needed if len(computable[k]) == len(needed[k]))
        incomplete = (k for k in needed if computable[k])
        ready = next(chain(complete, incomplete), None)
        if ready is None:
            return _without_zero_entries(nodes, waits)
        order.append(ready)
        computed |= computable[ready]
        for signal in computable[ready]:
            needed[ready].pop(signal)
        if not needed[ready]:
            del needed[ready], waits[ready]
    return tuple(order)


def _needed_signals(node: Any) -> dict[int, set[int]]:
    """Return for each output of a block the signals that it depends on directly."""
    sources: dict[int, set[int]] = {}
    for to, source, _ in node.fed():
        sources.setdefault(to, set()).add(source)
    return {
        signal: set().union(*(sources.get(k, set()) for k in inputs))
        for signal, inputs in enumerate(_feedthrough(node.system), node.outputs.start)
    }


def _without_zero_entries(
    nodes: list[Any], waits: dict[int, set[int]]
) -> tuple[int, ...]:
    """Return the order after zeros in matrices of linear blocks are constants; refuse a loop."""
    linear_blocks = [k for k in waits if is_linear(nodes[k].system)]
    if linear_blocks:
        for k in linear_blocks:
            system = with_constants(nodes[k].system)
            nodes[k] = replace(nodes[k], system=system)
        return order_of(nodes)
    path = [next(iter(waits))]
    while path.count(path[-1]) < 2:
        waiting = path[-1]
        path.append(next(k for k in waits[waiting] if k in waits))
    begin = path.index(path[-1])
    loop = " <- ".join(nodes[k].name for k in path[begin:])
    raise DiagramError(
        f"algebraic loop: {loop} depend on each other without a state. "
        "Insert a block whose outputs depend on its states alone, such as clpt.parts.lag"
    )


def unsampled(block: Block) -> Block:
    """Return a block, or the inner block of one that samples."""
    return block.inner if isinstance(block, Sampled) else block


def reaches_outputs(block: Block) -> bool:
    """Return whether inputs, once sampled, have direct feedthrough to outputs."""
    block = unsampled(block)
    try:
        return bool(block.array_record("output").leaves("u"))
    except Unread:
        return any(_tested_feedthrough(block))


def _feedthrough(block: Block) -> list[set[int]]:
    """Return for each output the inputs with direct feedthrough to it."""
    block = unsampled(block)
    try:
        record = block.array_record("output")
        outputs = InputsOf(record.operations, block.sizes).outputs(record)
    except Unread:
        return _tested_feedthrough(block)
    ports = places(block.input_shapes)
    starts = {port: signals.start for port, (signals, _) in ports.items()}
    return [{starts[port] + k for port, k in inputs} for inputs in outputs]


@np.errstate(all="ignore")
def _tested_feedthrough(block: Block) -> list[set[int]]:
    """Return for each output the inputs that change it at a few points."""
    random = np.random.default_rng(0)
    p = block.parameters_at(0.0)
    feedthrough: list[set[int]] = [set() for _ in range(block.noutputs)]
    for _ in range(TEST_POINTS):
        x = random.standard_normal(block.nstates)
        u: Any = random.standard_normal(block.ninputs)
        before = block.values("output", block.noutputs, 0.0, x, u, p)
        for k in range(block.ninputs):
            changed = u.copy()
            changed[k] = random.standard_normal()
            after = block.values("output", block.noutputs, 0.0, x, changed, p)
            both_nan = np.isnan(after) & np.isnan(before)
            differs = (after != before) & ~both_nan
            for output in np.flatnonzero(differs):
                feedthrough[output].add(k)
    return feedthrough
