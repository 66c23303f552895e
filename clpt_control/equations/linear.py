"""A linear system as a block, so that `control.ss` and `tf` are parts like any other.

x' = A x + B u,    y = C x + D u

Where D = 0 an input does not reach the outputs at once, and the block has no D to change.
"""

from typing import NamedTuple

import control
import numpy as np
from scipy.linalg import block_diag

from ..errors import DiagramError
from .block import Block
from .declaration import ports_of


class Linear(NamedTuple):
    """Matrices of a linear system with feedthrough."""

    n: int  # number of states
    inputs: int
    outputs: int
    A: np.ndarray  # shape (n, n)
    B: np.ndarray  # shape (n, inputs)
    C: np.ndarray  # shape (outputs, n)
    D: np.ndarray  # shape (outputs, inputs)


class StrictlyProper(NamedTuple):
    """Matrices of a linear system whose D is 0."""

    n: int  # number of states
    inputs: int
    outputs: int
    A: np.ndarray  # shape (n, n)
    B: np.ndarray  # shape (n, inputs)
    C: np.ndarray  # shape (outputs, n)


class Gain(NamedTuple):
    """The matrix of a system without states."""

    inputs: int
    outputs: int
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


def output_of_inputs(t, x, u, p, y):
    """y = D u, section "linear systems", no states: u[inputs], y[outputs]."""
    for i in range(p.outputs):
        total = 0.0
        for k in range(p.inputs):
            total += p.D[i, k] * u[k]
        y[i] = total


def linear(system: control.StateSpace | control.TransferFunction) -> Block:
    """Make a block of a linear system of continuous time, with its name and labels."""
    A, B, C, D = _matrices(system)
    n, (outputs, inputs) = len(A), D.shape
    parameters: Linear | StrictlyProper | Gain = Gain(inputs, outputs, D)
    function = output_of_inputs
    if n:
        function, parameters = output, Linear(n, inputs, outputs, A, B, C, D)
    if n and not np.any(D):
        function, parameters = output_of_states, StrictlyProper(n, inputs, outputs, A, B, C)
    block = Block(
        system.name,
        update=rate if n else None,
        output=function,
        inputs={"u": inputs},
        outputs={"y": outputs},
        states={"x": n} if n else None,
        parameters=parameters,
        feedthrough=function is not output_of_states,
    )
    block.set_inputs(system.input_labels)
    block.set_outputs(system.output_labels)
    block.input_ports, block.output_ports = (
        {port: len(places) for port, places in ports_of(labels).items()}
        for labels in (system.input_labels, system.output_labels)
    )
    if isinstance(system, control.StateSpace):
        block.set_states(system.state_labels)
    return block


def is_linear(part: control.NonlinearIOSystem) -> bool:
    """Return whether a part is a block that `linear` made."""
    return isinstance(getattr(part, "parameters", None), Linear | StrictlyProper | Gain)


def _matrices(system: control.StateSpace | control.TransferFunction) -> tuple[np.ndarray, ...]:
    """Return A, B, C, D; of a matrix of transfer functions each entry has states of its own."""
    if isinstance(system, control.StateSpace):
        return system.A, system.B, system.C, system.D
    places = [(i, j) for i in range(system.noutputs) for j in range(system.ninputs)]
    try:
        parts = [control.tf2ss(system.num[i][j], system.den[i][j]) for i, j in places]
    except ValueError:
        raise DiagramError(
            f"{system.name}: a numerator of higher degree than its denominator differentiates, "
            "which no block can; add a fast pole, such as tf([1, 0], [0.01, 1])"
        ) from None
    rows, columns = np.eye(system.noutputs), np.eye(system.ninputs)
    at = list(zip(places, parts, strict=True))
    return (
        block_diag(*(part.A for part in parts)),
        np.vstack([part.B * columns[j] for (_, j), part in at]),
        np.hstack([rows[:, [i]] * part.C for (i, _), part in at]),
        sum(part.D * np.outer(rows[i], columns[j]) for (i, j), part in at),
    )


def on_each_axis(block: Block, count: int) -> Block:
    """Return a linear block of one signal for so many signals, each with states of its own."""
    p = block.parameters
    own = [getattr(p, "A", np.zeros((0, 0))), getattr(p, "B", np.zeros((0, 1)))]
    own += [getattr(p, "C", np.zeros((1, 0))), getattr(p, "D", np.zeros((1, 1)))]
    A, B, C, D = (np.kron(np.eye(count), matrix) for matrix in own)
    return linear(control.ss(A, B, C, D, name=block.name))
