"""Records of a block evaluated in NumPy, at many points at once.

on_arrays(block, "update", t, x, u)    with x of shape (n, points)    ->    (n, points)
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..record.graph import Record, evaluated
from .ports import places


def leaf_values(
    block: Any, t: Any, x: Any, u: Any, p: Any
) -> Callable[[str, str], np.ndarray]:
    """Return the function (group, name) -> array of a leaf; its last axis has the points."""
    vectors = {
        "x": (x, places(block.state_shapes)),
        "u": (u, places(block.input_shapes)),
    }

    def leaf(group: str, name: str) -> np.ndarray:
        if group == "t":
            return np.asarray(t, dtype=float)
        if group == "p":
            value = np.asarray(getattr(p, name), dtype=float)
            varies = name == "interval" and value.ndim
            return value if varies else value[..., None]
        vector, ports = vectors[group]
        positions, shape = ports[name]
        values = vector[positions]
        return values.reshape((*shape, *values.shape[1:]))

    return leaf


def on_arrays(
    block: Any, role: str, t: Any, x: Any, u: Any, p: Any = None
) -> np.ndarray:
    """Return what a function gives at each time, state x[k] and input u[k]: (size, ...).

    Its parameters are the block's, or those given; their `interval` may be one for each time.
    """
    return record_on_arrays(block, block.array_record(role), t, x, u, p)


def record_on_arrays(
    block: Any, record: Record, t: Any, x: Any, u: Any, p: Any
) -> np.ndarray:
    """Return the outputs of a record with a block's leaves, as `on_arrays` does."""
    shape = np.broadcast_shapes(np.shape(t), np.shape(x)[1:], np.shape(u)[1:])
    count = int(np.prod(shape))

    def flat(vector: Any) -> np.ndarray:
        size = len(vector)
        return np.broadcast_to(vector, (size, *shape)).reshape(size, count)

    times = np.broadcast_to(t, shape).reshape(count)
    parameters = block.parameters if p is None else p
    leaf = leaf_values(block, times, flat(x), flat(u), parameters)
    outputs = evaluated(record, leaf, block.sizes, count)
    rows = [output.reshape(-1, count) for output in outputs]
    matrix = np.concatenate([np.zeros((0, count)), *rows])
    return matrix.reshape((-1, *shape))
