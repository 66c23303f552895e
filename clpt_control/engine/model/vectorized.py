"""Vectorized evaluation: a block's equations at many times, states and inputs at once.

`on_arrays` evaluates the record of a block's function in NumPy, with a last axis for the points.
`evaluate` is its public form for static blocks, such as a flow basis.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...arguments import numbers, public
from ...errors import ArgumentError
from ..record.graph import evaluated
from .block import Block
from .ports import places


def leaf_values(
    block: Block, t: Any, x: Any, u: Any, p: Any
) -> Callable[[str, str], np.ndarray]:
    """Return the function (group, name) -> array of a leaf; more axes, such as times, are last."""
    states = places(block.state_shapes)
    inputs = places(block.input_shapes)

    def leaf(group: str, name: str) -> np.ndarray:
        if group == "t":
            return np.asarray(t, dtype=float)
        if group == "p":
            return np.asarray(getattr(p, name), dtype=float)
        ports = states if group == "x" else inputs
        vector = x if group == "x" else u
        positions, shape = ports[name]
        values = vector[positions]
        return values.reshape((*shape, *values.shape[1:]))

    return leaf


def on_arrays(
    block: Block, role: str, t: Any, x: Any, u: Any, p: Any = None
) -> np.ndarray:
    """Return what a function gives at each time, state x[k] and input u[k]: (size, ...).

    Its parameters are the block's, or those given; their `interval` may be one for each time.
    """
    shape = np.broadcast_shapes(np.shape(t), np.shape(x)[1:], np.shape(u)[1:])
    count = int(np.prod(shape))

    def flat(vector: Any) -> np.ndarray:
        size = len(vector)
        return np.broadcast_to(vector, (size, *shape)).reshape(size, count)

    times = np.broadcast_to(t, shape).reshape(count)
    parameters = block.parameters if p is None else p
    leaf = leaf_values(block, times, flat(x), flat(u), parameters)

    def at_each_time(group: str, name: str) -> np.ndarray:
        value = leaf(group, name)
        varies = name == "interval" and value.ndim
        is_constant = group == "p" and not varies
        return value[..., None] if is_constant else value

    record = block.array_record(role)
    outputs = evaluated(record, at_each_time, block.sizes, count)
    rows = [output.reshape(-1, count) for output in outputs]
    matrix = np.concatenate([np.zeros((0, count)), *rows])
    return matrix.reshape((-1, *shape))


@public
def evaluate(block: Block, timepts: ArrayLike, inputs: ArrayLike) -> np.ndarray:
    """Compute a static block's outputs at many times and inputs.

    Parameters
    ----------
    block : Block
        Without states, such as ``basis_x``, Eq. (5), or ``true_flow`` of a gridded field.
    timepts : array_like, shape (n,) or a number
        In the block's unit.
    inputs : array_like, shape (n, ninputs)
        Such as places, in the block's unit.

    Returns
    -------
    ndarray, shape (n, noutputs)
        One row per sample.

    Examples
    --------
    >>> from clpt_control.blocks.flow import flow_basis
    >>> p = np.zeros((1, 2)), np.ones(1), np.zeros(1), np.zeros(1)
    >>> evaluate(flow_basis("basis_x", "x", "gaussian", *p), [0, 5], [[0, 0], [1, 1]]).round(3)
    array([[1.   ],
           [0.368]])
    """
    u = np.atleast_2d(numbers("inputs", inputs, block.ninputs))
    t = numbers("timepts", timepts)
    allowed_shapes = (), (1,), u.shape[:1]
    if u.ndim > 2 or t.shape not in allowed_shapes:
        raise ArgumentError(
            f"evaluate: timepts has shape {t.shape}, inputs {u.shape}; must be a time, or n "
            f"of them, and (n, {block.ninputs})"
        )
    times = np.broadcast_to(t, len(u))
    no_states = np.zeros((0, len(u)))
    outputs = on_arrays(block, "output", times, no_states, u.T)
    return outputs.T
