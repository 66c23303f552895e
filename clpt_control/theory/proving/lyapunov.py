"""V' along the equations that run, for every N.

    V' = sum_i dV/ds_i * s_i'        over all states s of the closed loop

V is a block of the diagram (`blocks.lyapunov`), s' comes from the update functions.  What a theorem
claims V' to be is stated once, on the loop's arrays, and compared with what the blocks give: for
every N, and, at random points, with the blocks that run.
"""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from ...diagrams.interconnection import Diagram
from ...errors import DiagramError
from .array_loop import ArrayLoop, array_loop
from .proof import Step, checked
from .running_rate import compared
from .symbolic_loop import SymbolicLoop, symbolic_loop
from .theorem_loop import Hedging, theorem_loop
from .vanishing import left_over

Loop = ArrayLoop | SymbolicLoop
Claim = Callable[[Any], Any]  # what V' should be: loop -> a number of its kind
WIRED = 3  # functions that a loop has which is read for every N


def decay(loop: Loop) -> Any:
    """V' = -e^T KD e, Eq. (26)."""
    return -np.sum(loop.parameters["vehicle_controller"].KD * loop.signals["e"] ** 2)


def flow_error(loop: Loop) -> Any:
    """Return theta - theta_hat of the estimate that is given or made, shape (2, N)."""
    p, made = loop.parameters, loop.states.get("theta_hat")
    return p["true_flow"].theta - (p["injection"].theta_hat if made is None else made)


def decay_and_known_error(loop: Loop) -> Any:
    """V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1."""
    return decay(loop) + loop.signals["e"] @ (flow_error(loop) @ loop.inputs["phi_x"])


def decay_and_disturbance(loop: Loop) -> Any:
    """V' = -e^T KD e + e^T Delta, Eq. (35)."""
    return decay(loop) + loop.signals["e"] @ loop.inputs["delta"]


def rate_of_V(loop: ArrayLoop) -> Any:
    """Return V' along the equations."""
    if "V" not in loop.signals:
        raise DiagramError("no block makes V; wire a candidate such as blocks.lyapunov")
    return loop.derivative(loop.signals["V"][0])


def known_positive(loop: ArrayLoop, name: str, value: Any) -> None:
    """Refuse what is not known to be positive."""
    if not all(one.is_positive for one in loop.read(value)):
        raise DiagramError(f"{name} is not known to be positive")


def vanish(loop: ArrayLoop, left: Iterable[Any]) -> tuple[bool, str]:
    """Return whether what is left of a loop is zero for every N, and what is not."""
    for rest in left:
        for one in loop.read(rest):
            if said := left_over(one):
                return False, said
    return (False, loop.undefined[0]) if loop.undefined else (True, "")


def zero_step(
    claim: str, diagram: Callable[[], Diagram], left: Callable[[ArrayLoop], Iterable[Any]]
) -> Step:
    """Check that what is left of a diagram's loop is zero for every N."""

    def holds() -> tuple[bool, str]:
        loop = array_loop(diagram())
        return vanish(loop, left(loop))

    return checked(claim, "exact", holds)


def identity_steps(
    text: str,
    law: str,
    claim: Claim,
    points: int,
    disturbed: bool = False,
    speed: Hedging = "no limit",
) -> list[Step]:
    """Check V' exactly for every N, and at points of the running blocks.

    `text` is the claim in words; the exact step says what does not cancel, the other one where.
    """

    def diagram() -> Diagram:
        return theorem_loop(WIRED, law, disturbed, speed=speed)

    def running() -> tuple[bool, str]:
        loop = symbolic_loop(made := diagram())
        found = compared(made, loop, claim(loop), points)
        if found.where is not None:
            return False, f"differs by {found.worst:.1e} at x = {found.where.x.round(3).tolist()}"
        return True, f"{found.points} points, N = 3, largest difference {found.worst:.0e} of V"

    return [
        zero_step(f"{text}, for every N", diagram, lambda loop: [rate_of_V(loop) - claim(loop)]),
        checked(f"the running blocks give the same V' ({text})", "sampled", running, False),
    ]
