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
from ..conformance.confirmation import EXACT, differ
from ..model.block import Block
from ..model.ports import places
from ..model.system import is_linear, with_constants
from ..record.scalar_graph import InputsOf
from ..record.unread import Unread

TEST_POINTS = 3  # for the feedthrough of a function that cannot be traced


def order_of(nodes: list[Any]) -> tuple[int, ...]:
    """Return the order of evaluation; a block that is evaluated in two steps occurs twice.

    Linear blocks of a loop are replaced in `nodes`.
    """
    # block -> groups of its outputs, each with the signals that it depends on directly
    needed = {
        k: {(*range(node.outputs.start, node.outputs.stop),): _sources(node)}
        for k, node in enumerate(nodes)
    }
    order = []
    computed: set[int] = set()
    by_signal = False

    def remaining(k: int) -> dict[tuple[int, ...], set[int]]:
        """Return the groups of a block's outputs that cannot be computed yet."""
        return {
            group: signals
            for group, signals in needed[k].items()
            if not signals <= computed
        }

    while needed:
        # first a block with all its outputs, then one with some of them
        complete = (k for k in needed if not remaining(k))
        incomplete = (k for k in needed if len(remaining(k)) < len(needed[k]))
        ready = next(chain(complete, incomplete), None)
        if ready is None and by_signal:
            return _without_zero_entries(nodes, needed, computed)
        if ready is None:  # each output is a group of its own
            by_signal = True
            needed = {k: _needed_signals(nodes[k]) for k in needed}
            continue
        order.append(ready)
        groups = remaining(ready)
        computed.update(*(needed[ready].keys() - groups.keys()))
        needed[ready] = groups
        if not groups:
            del needed[ready]
    return tuple(order)


def _sources(node: Any) -> set[int]:
    """Return the signals that the outputs of a block depend on directly."""
    sources = {source for _, source, _ in node.fed()}
    # an untraced function is called, which may change its hidden state: only if it has sources
    return sources if sources and reaches_outputs(node.system) else set()


def _needed_signals(node: Any) -> dict[tuple[int, ...], set[int]]:
    """Return for each output of a block the signals that it depends on directly."""
    sources: dict[int, set[int]] = {}
    for to, source, _ in node.fed():
        sources.setdefault(to, set()).add(source)
    return {
        (signal,): set().union(*(sources.get(k, set()) for k in inputs))
        for signal, inputs in enumerate(_feedthrough(node.system), node.outputs.start)
    }


def _without_zero_entries(
    nodes: list[Any], needed: dict[int, dict], computed: set[int]
) -> tuple[int, ...]:
    """Return the order after zeros in matrices of linear blocks are constants; refuse a loop."""
    linear_blocks = [k for k in needed if is_linear(nodes[k].system)]
    if linear_blocks:
        for k in linear_blocks:
            system = with_constants(nodes[k].system)
            nodes[k] = replace(nodes[k], system=system)
        return order_of(nodes)
    producers = [k for k, node in enumerate(nodes) for _ in range(node.system.noutputs)]
    path = [next(iter(needed))]
    while path.count(path[-1]) < 2:
        sources = set().union(*needed[path[-1]].values())
        path.append(producers[min(sources - computed)])
    begin = path.index(path[-1])
    loop = " <- ".join(nodes[k].name for k in path[begin:])
    raise DiagramError(
        f"algebraic loop: {loop} depend on each other without a state. "
        "Insert a block whose outputs depend on its states alone, such as clpt.parts.lag"
    )


def reaches_outputs(block: Block) -> bool:
    """Return whether inputs, once sampled, have direct feedthrough to outputs."""
    block = block.unsampled
    try:
        return bool(block.array_record("output").leaves("u"))
    except Unread:
        return any(_tested_feedthrough(block))


def _feedthrough(block: Block) -> list[set[int]]:
    """Return for each output the inputs with direct feedthrough to it."""
    block = block.unsampled
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
            for output in np.flatnonzero(differ(after, before, EXACT)):
                feedthrough[output].add(k)
    return feedthrough
