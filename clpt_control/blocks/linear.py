"""A linear system as a block, so that `control.ss` and `tf` are parts like any other.

x' = A x + B u,    y = C x + D u
"""

from typing import NamedTuple

import control
import numpy as np

from .block import Block


class LinearParameters(NamedTuple):
    """Matrices of a linear system."""

    n: int  # number of states
    inputs: int
    outputs: int
    A: np.ndarray  # shape (n, n)
    B: np.ndarray  # shape (n, inputs)
    C: np.ndarray  # shape (outputs, n)
    D: np.ndarray  # shape (outputs, inputs)


def rate(t, x, u, p, dx):
    """x' = A x + B u, section "linear systems" of any textbook: u[inputs], x[n]."""
    for i in range(p.n):
        total = 0.0
        for k in range(p.n):
            total += p.A[i, k] * x[k]
        for k in range(p.inputs):
            total += p.B[i, k] * u[k]
        dx[i] = total


def output(t, x, u, p, y):
    """y = C x + D u, section "linear systems": u[inputs], x[n], y[outputs]."""
    for i in range(p.outputs):
        total = 0.0
        for k in range(p.n):
            total += p.C[i, k] * x[k]
        for k in range(p.inputs):
            total += p.D[i, k] * u[k]
        y[i] = total


def output_of_states(t, x, u, p, y):
    """y = C x, section "linear systems", D = 0: x[n], y[outputs]."""
    for i in range(p.outputs):
        total = 0.0
        for k in range(p.n):
            total += p.C[i, k] * x[k]
        y[i] = total


def linear(system: control.StateSpace) -> Block:
    """Make a block of a linear system of continuous time, with its name and labels."""
    n, inputs, outputs = system.nstates, system.ninputs, system.noutputs
    direct = bool(np.any(system.D))
    block = Block(
        system.name,
        update=rate if n else None,
        output=output if direct or not n else output_of_states,
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
