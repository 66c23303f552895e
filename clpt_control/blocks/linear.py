"""A linear system as a block, so that `control.ss` and `tf` are parts like any other.

x' = A x + B u,    y = C x + D u         Eqs. (1), (2) of linear systems
"""

from typing import NamedTuple

import control
import numpy as np

from .block import Block


class LinearParameters(NamedTuple):
    """Matrices of a linear system.

    Attributes
    ----------
    n, inputs, outputs : int
        Numbers of states, inputs and outputs.
    A, B, C, D : ndarray
        Shapes (n, n), (n, inputs), (outputs, n), (outputs, inputs).
    """

    n: int
    inputs: int
    outputs: int
    A: np.ndarray
    B: np.ndarray
    C: np.ndarray
    D: np.ndarray


def rate(t, x, u, p, dx):
    """Eq. (1) of linear systems, x' = A x + B u: u[inputs], x[n]."""
    for i in range(p.n):
        total = 0.0
        for k in range(p.n):
            total += p.A[i, k] * x[k]
        for k in range(p.inputs):
            total += p.B[i, k] * u[k]
        dx[i] = total


def output(t, x, u, p, y):
    """Eq. (2) of linear systems, y = C x + D u: u[inputs], x[n], y[outputs]."""
    for i in range(p.outputs):
        total = 0.0
        for k in range(p.n):
            total += p.C[i, k] * x[k]
        for k in range(p.inputs):
            total += p.D[i, k] * u[k]
        y[i] = total


def output_later(t, x, u, p, y):
    """Eq. (2) of linear systems with D = 0, y = C x: x[n], y[outputs]."""
    for i in range(p.outputs):
        total = 0.0
        for k in range(p.n):
            total += p.C[i, k] * x[k]
        y[i] = total


def linear(system: control.StateSpace) -> Block:
    """Make a block of a linear system.

    Parameters
    ----------
    system : control.StateSpace
        Continuous in time.

    Returns
    -------
    Block
        With the system's name and labels.

    Examples
    --------
    >>> block = linear(control.ss(-1.0, 2.0, 3.0, 0.0))
    >>> block.dynamics(0, [1.0], [1.0]), block.output(0, [1.0], [1.0])
    (array([1.]), array([3.]))
    """
    n, inputs, outputs = system.nstates, system.ninputs, system.noutputs
    direct = bool(np.any(system.D))
    block = Block(
        system.name,
        update=rate if n else None,
        output=output if direct or not n else output_later,
        inputs={"u": inputs},
        outputs={"y": outputs},
        states={"x": n} if n else None,
        parameters=LinearParameters(n, inputs, outputs, system.A, system.B, system.C, system.D),
        feedthrough=direct or not n,
    )
    block.set_inputs(system.input_labels)
    block.set_outputs(system.output_labels)
    block.set_states(system.state_labels)
    return block
