"""The closed loop that the theorems speak of, with its V as a block, and V' along it for every N.

The basis, the waypoints, the disturbance and the limit of the speed are inputs of the diagram:
what is proved holds for every phi_x, phi_z, zc, Delta and flown velocity v_x, and the running
blocks are called with any.

    V' = sum_i dV/ds_i * s_i'        over all states s of the closed loop

s' comes from the update functions.  What a theorem claims V' to be is stated once, on the loop's
arrays, and compared with what the blocks give: for every N, and, at random points, with the blocks
that run.
"""

from collections.abc import Callable, Iterable
from functools import cache
from typing import Any, Literal

import numpy as np

from ...engine.diagram.interconnection import Diagram, connect
from ...engine.model.block import Block
from ...paper.blocks.lyapunov import PORTS, lyapunov_candidate, weighted
from ...paper.blocks.ports import paper_block
from ...paper.laws.law import Law, Truth
from ...paper.laws.table import LAWS
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.file import paper_scenario
from ...simulation.loops import paper_blocks
from ..promises import truth_of
from .exact import left_over
from .steps import Step, checked
from .symbolic_loop import ArrayLoop, SymbolicLoop

SOURCES = {
    "basis_x": "phi_x",
    "basis_z": "phi_z",
    "reference": "zc",
    "disturbance": "delta",
    "speed_limit": "v_x",
}
AT_FIXES = {  # of a law that learns at fixes: the interval, and gains that it does not take
    "localization": {"interval": 5.0},
    "learning.gain": None,
    "learning.feedback": None,
    "learning.feedforward": None,
}
Hedging = Literal["no limit", "hedged", "not hedged"]


@cache
def theorem_scenario(
    N: int, law: str, disturbed: bool = False, speed: Hedging = "no limit"
) -> Scenario:
    """Return a scenario with N functions, whose numbers become symbols with their signs.

    KD and gamma are positive; theta, theta_hat, alpha_M, alpha(0) and GammaD have either sign.
    """
    signs = np.array([[1.0], [-1.0]]) * np.arange(1, N + 1)
    known = law == "known-flow"
    push = {"kind": "constant", "amplitude": [0.1, 0.1]}
    return paper_scenario().with_values(
        {
            "basis.centers": [[float(k), float(-k)] for k in range(N)],
            "basis.widths": [1.0 + k for k in range(N)],
            "basis.periods": [2.0 + k for k in range(N)],
            "basis.phases": [0.0] * N,
            "flow.parameters": (0.1 * signs).tolist(),
            "flow.disturbance": push if disturbed else None,
            "model.parameters": (-0.3 * signs).tolist(),
            "vehicle.feedback": [1.0, 0.7],
            "vehicle.feedforward": [1.2, -0.5],
            "vehicle.max_speed": None if speed == "no limit" else 1.5,
            "learning.hedging": None if speed == "no limit" else speed == "hedged",
            "learning.law": law,
            "learning.parameters": None
            if LAWS[law].alpha_is_constant
            else (0.2 * signs).tolist(),
            "learning.theta_estimate": (0.4 * signs).tolist() if known else None,
            **(AT_FIXES if LAWS[law].at_fixes else {}),
        }
    )


def law_and_V(law: Law, N: int, speed: Hedging = "no limit") -> tuple[Block, Block]:
    """Return a law's block and V in the theorems' scenario, at its defaults.

    A default of 0 is 0.1 instead: what is 0 would be no symbol.
    """
    scenario = theorem_scenario(N, law.name, speed=speed)
    known = scenario.known_to_law
    settings = {
        key: 0.1 if value == 0 else value for key, value in known.settings.items()
    }
    block = law.block(known._replace(settings=settings))
    return block, law.V(block.parameters, truth_of(scenario))


def theorem_loop(
    N: int,
    law: str,
    disturbed: bool = False,
    law_block: Block | None = None,
    candidate: Block | None = None,
    speed: Hedging = "no limit",
) -> Diagram:
    """Wire the closed loop of a theorem, with its V as a block.

    V is that of Eq. (17) for the known-flow law, of Eq. (24) for the learned-flow law;
    `law_block` and `candidate` (with the output V[1]) take the place of the paper's.
    """
    scenario = theorem_scenario(N, law, disturbed, speed)
    blocks = {block.name: block for block in paper_blocks(scenario)}
    if law_block is not None:
        blocks["adaptation"] = law_block
    external = [
        port for name, port in SOURCES.items() if blocks.pop(name, None) is not None
    ]
    candidate = theorem_candidate(scenario) if candidate is None else candidate
    return connect([*blocks.values(), candidate], external, name="theorem")


def law_loop(law: Law, block: Block, V: Block, speed: Hedging = "no limit") -> Diagram:
    """Wire a law of the table with its V."""
    known = law.name if law.alpha_is_constant else "learned-flow"
    return theorem_loop(
        block.sizes["N"], known, law_block=block, candidate=V, speed=speed
    )


def theorem_candidate(scenario: Scenario) -> Block:
    """Return V of Eq. (17) or (24) with the scenario's truth."""
    p = weighted([scenario.learning.used_gains.parameters] * 3, *truth_of(scenario))
    return lyapunov_candidate(scenario.learning.law, p)


def mixed_level(t, x, u, p):
    """V of Eq. (24) with the inverse of a matrix of gains between all learned parameters."""
    eta = np.concatenate([np.ravel(p.theta + u.alpha), u.K - p.KD, u.Gamma - p.GammaD])
    return {"V": (u.e @ u.e + eta @ (p.inverse @ eta)) / 2}


def mixed_candidate(inverse: np.ndarray, truth: Truth) -> Block:
    """Return V of the errors of alpha row by row, K and Gamma, weighed by a matrix."""
    given = {"inverse": inverse, **truth._asdict()}
    return paper_block("lyapunov", PORTS, given, output=mixed_level)


def tied(
    loop: SymbolicLoop, V: Block, make: Callable[..., Block], *sources: tuple
) -> dict:
    """Return V's symbols -> the symbols of its sources that they stand for.

    A source is a tuple of numbers with names, as parameters and the truth are, and their symbols.
    V is made anew of numbers that stand nowhere else: a number of V tells the symbol it stands for,
    or its square.
    """
    random, marks, altered = np.random.default_rng(0), dict[float, Any](), []
    for numbers, symbols in sources:
        changed = {}
        for field, value in numbers._asdict().items():
            if not isinstance(value, int) and field != "interval":
                mark = np.asarray(value, dtype=float)
                changed[field] = mark = mark * random.uniform(1.01, 1.1, mark.shape)
                theirs = np.broadcast_to(
                    np.asarray(getattr(symbols, field), object), mark.shape
                )
                for n in (1, 2):
                    marks |= zip(
                        np.ravel(mark**n).tolist(), np.ravel(theirs**n), strict=True
                    )
        altered.append(numbers._replace(**changed))
    values, mine = make(*altered).parameters, loop.parameters[V.name]
    tied_to: dict[Any, Any] = {}
    for field in values._fields:
        own = np.asarray(getattr(mine, field), dtype=object)
        theirs = np.broadcast_to(
            np.asarray(getattr(values, field), dtype=float), own.shape
        )
        pairs = zip(own.ravel(), theirs.ravel().tolist(), strict=True)
        tied_to |= {
            s: marks[a]
            for s, a in pairs
            if a in marks and getattr(s, "is_Symbol", False)
        }
    return tied_to


def truth_in(loop: SymbolicLoop) -> Truth:
    """Return the symbols of theta, KD and GammaD."""
    car = loop.parameters["vehicle_controller"]
    return Truth(loop.parameters["true_flow"].theta, car.KD, car.GammaD)


Loop = ArrayLoop | SymbolicLoop
Claim = Callable[[Any], Any]  # what V' should be, of a loop
WIRED = 3  # functions that a loop has which is read for every N


def decay(loop: Loop) -> Any:
    """V' = -e^T KD e, Eq. (26)."""
    return -np.sum(loop.parameters["vehicle_controller"].KD * loop.signals["e"] ** 2)


KNOWN_ERROR = "V' = -e^T KD e + e^T (theta - theta_hat) phi"


def decay_and_known_error(loop: Loop) -> Any:
    """V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1; theta_hat a state or given."""
    p, state = loop.parameters, loop.states.get("theta_hat")
    error = p["true_flow"].theta - (
        p["injection"].theta_hat if state is None else state
    )
    return decay(loop) + loop.signals["e"] @ (error @ loop.inputs["phi_x"])


def rate_of_V(loop: Loop) -> Any:
    """Return V' along the equations."""
    return loop.derivative(loop.signals["V"][0])


def vanish(loop: ArrayLoop, residuals: Iterable[Any]) -> tuple[bool, str]:
    """Return whether each residual of a loop is zero for every N, and the first that is not."""
    for residual in residuals:
        for one in loop.read(residual):
            if rest := left_over(one):
                return False, rest
    return (False, loop.undefined[0]) if loop.undefined else (True, "")


def zero_step(
    claim: str,
    diagram: Callable[[], Diagram],
    residuals: Callable[[ArrayLoop], Iterable[Any]],
) -> Step:
    """Check that residuals of a diagram's loop are zero for every N."""

    def holds() -> tuple[bool, str]:
        loop = ArrayLoop(diagram())
        return vanish(loop, residuals(loop))

    return checked(claim, holds)
