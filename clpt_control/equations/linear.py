"""A linear system as a block, so that `control.ss` and `tf` are parts like any other.

x' = A x + B u,    y = C x + D u

or, in discrete time, the next x = A x + B u.  Where D = 0 an input does not reach the outputs at
once, and the block has no D to change.
"""

from typing import Any

import control
import numpy as np
from scipy.linalg import block_diag

from ..errors import DiagramError
from .block import Block
from .sampled import Sampled


def rate(t, x, u, p):
    """x' = A x + B u, section "linear systems" of any textbook."""
    return p.A @ x.x + p.B @ u.u


def output(t, x, u, p):
    """y = C x + D u, section "linear systems"."""
    return p.C @ x.x + p.D @ u.u


def output_of_states(t, x, u, p):
    """y = C x, section "linear systems", D = 0."""
    return p.C @ x.x


def output_of_inputs(t, x, u, p):
    """y = D u, section "linear systems", no states."""
    return p.D @ u.u


RECORDS: dict[Any, dict[str, Any]] = {}  # of each output function, and of the rates beside it
SHAPES = {"A": ("n", "n"), "B": ("n", "m"), "C": ("q", "n"), "D": ("q", "m")}


def linear(system: control.StateSpace | control.TransferFunction) -> Block:
    """Make a block of a linear system, with its name, labels and time."""
    parameters = dict(zip("ABCD", _matrices(system), strict=True))
    n, (outputs, inputs) = len(parameters["A"]), parameters["D"].shape
    function = output if n else output_of_inputs
    if n and not np.any(parameters["D"]):
        function = output_of_states
        del parameters["D"]
    for name in "ABC" if not n else "":
        del parameters[name]
    block = Block(
        system.name,
        update=rate if n else None,
        output=function,
        inputs={"u": "m"},
        outputs={"y": "q"},
        states={"x": "n"} if n else None,
        parameters=parameters,
        shapes={name: SHAPES[name] for name in parameters},
        sizes={"m": inputs, "q": outputs},
    )
    block.__dict__["_read_records"] = RECORDS.setdefault(function, {})  # the same for all sizes
    block.set_inputs(system.input_labels)
    block.set_outputs(system.output_labels)
    if isinstance(system, control.StateSpace):
        block.set_states(system.state_labels)
    block.dt = system.dt
    return block


def is_linear(part: control.NonlinearIOSystem) -> bool:
    """Return whether a part is a block that `linear` made."""
    own = getattr(part, "inner", part)  # of one that is sampled
    return getattr(own, "output_function", None) in (output, output_of_states, output_of_inputs)


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
    made = linear(control.ss(A, B, C, D, name=block.name))
    return Sampled(made, block.period) if isinstance(block, Sampled) else made
