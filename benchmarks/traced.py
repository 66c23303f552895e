"""A diagram's equations in another library's algebra, from the functions that run.

heyoka and diffrax get their right-hand sides from each block's own record, run on
their expressions through the diagram's wiring: no equation is written a second
time.
"""

import operator
from collections.abc import Callable, Mapping
from functools import reduce
from typing import Any

import numpy as np

from clpt_control.engine.diagram.wiring import wiring_of
from clpt_control.engine.record.scalar_graph import Elements

ARITHMETIC = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "div": operator.truediv,
    "neg": operator.neg,
}


def boxed(values: Any) -> np.ndarray:
    """Put expressions into an array one by one; NumPy shall not look inside them."""
    array = np.empty(len(values), dtype=object)
    for i in range(len(values)):
        array[i] = values[i]
    return array


def held(value: Any) -> Any:
    """Return a value as what is asked for its elements; another library's number has but one."""
    known = isinstance(value, (float, int, list, tuple, np.ndarray, np.generic))
    return np.asarray(value, dtype=object) if known else {(): value}


class Traced(Elements):
    """The elements of a record in another algebra."""

    functions: Mapping[str, Callable]
    given: Callable[[str, str], np.ndarray]

    def leaf(self, at, shape, index):
        """Return what was given."""
        return self.given(*at)[index]

    def apply(self, ref, kind, arguments):
        """Return what the other library makes of an operation."""
        if kind == "sum":
            return reduce(operator.add, arguments)
        if kind == "pow" and arguments[1] == 2.0:
            return arguments[0] * arguments[0]
        return self.functions[kind](*arguments)


def rates(
    diagram: Any,
    t: Any,
    x: list,
    functions: Mapping[str, Callable],
    given: Mapping[str, list],
    parameters: Mapping[tuple[str, str], Any] | None = None,
) -> list:
    """Return the state derivatives of a diagram in another algebra, at t and the states x.

    `functions` says what the functions of ``math`` are there, `given` the outputs of blocks
    that are not traced (``{"reference": [zc1, zc2]}``), `parameters` which expressions stand
    in place of numbers (``{("adaptation", "gain"): gamma}``).
    """
    wiring = wiring_of(diagram)
    states = boxed(x)
    signals = np.full(wiring.nodes[-1].outputs.stop, 0.0, dtype=object)
    derivative = np.full(len(x), 0.0, dtype=object)

    def inputs(node) -> np.ndarray:
        u = np.full(node.system.ninputs, None, dtype=object)
        for wire in node.wires:
            for i in range(wire.size):
                one = signals[wire.source + i]
                one = one if wire.gain == 1 else wire.gain * one
                at = wire.to + i
                u[at] = one if u[at] is None else u[at] + one
        u[[value is None for value in u]] = 0.0
        return u

    changed: dict[str, dict] = {}
    for (block, field), value in (parameters or {}).items():
        changed.setdefault(block, {})[field] = value

    def run(node, role) -> list:
        u, own = (
            inputs(node),
            {**node.system.parameters._asdict(), **changed.get(node.name, {})},
        )
        leaf = node.system._leaf_values(0.0, states[node.states], u, None)
        record = node.system.array_record(role)
        traced = Traced(record.operations, node.system.sizes)
        traced.functions = {**ARITHMETIC, **functions}
        traced.given = lambda group, name: (
            leaf(group, name)
            if group in "xu"
            else held(t if group == "t" else own[name])
        )
        return traced.outputs(record)

    nodes = [wiring.nodes[k] for k in wiring.order]
    for node in nodes:
        if node.name in given:
            signals[node.outputs] = boxed(given[node.name])
        else:
            signals[node.outputs] = boxed(run(node, "output"))
    for node in nodes:
        if node.system.nstates:
            derivative[node.states] = boxed(run(node, "update"))
    return list(derivative)
