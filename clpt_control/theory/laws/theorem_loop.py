"""Closed loops of the theorems, each with its V as a block, and V' for every N.

    V' = sum_i dV/ds_i * s_i'        over all states s of the closed loop

The basis, the waypoints, the disturbance and the speed limit are inputs of the diagram: proofs hold
for every phi_x, phi_z, zc, Delta and flown velocity v_x, and the running blocks are called with
random ones.  s' comes from the update functions.  The V' that a theorem claims is stated once, on
the loop's arrays, and compared with V' of the blocks: for every N, and at random points with the
running blocks.
"""

from collections.abc import Callable
from functools import cache
from typing import Any, Literal

import numpy as np
import sympy

from ...engine.diagram.interconnection import Diagram, connect
from ...engine.model.block import Block
from ...paper.blocks.lyapunov import PORTS, lyapunov_candidate, weighted
from ...paper.blocks.ports import paper_block
from ...paper.laws.law import Law, Truth
from ...paper.laws.table import LAWS
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.file import paper_scenario
from ...simulation.loop_blocks import paper_blocks
from ...simulation.user_components import functions_of
from ..proofs.symbolic_loop import ArrayLoop, SymbolicLoop
from .promises import truth_of

SOURCES = {
    "basis_x": "phi_x",
    "basis_z": "phi_z",
    "reference": "zc",
    "disturbance": "delta",
    "speed_limit": "v_x",
}
# settings of a law that learns at fixes: the interval, and gains that it does not have
AT_FIXES = {
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
    is_limited = speed != "no limit"
    settings = {
        "basis.centers": [[float(k), float(-k)] for k in range(N)],
        "basis.widths": [1.0 + k for k in range(N)],
        "basis.periods": [2.0 + k for k in range(N)],
        "basis.phases": [0.0] * N,
        "flow.parameters": (0.1 * signs).tolist(),
        "flow.disturbance": None,
        "model.parameters": (-0.3 * signs).tolist(),
        "vehicle.feedback": [1.0, 0.7],
        "vehicle.feedforward": [1.2, -0.5],
        "vehicle.max_speed": 1.5 if is_limited else None,
        "learning.hedging": speed == "hedged" if is_limited else None,
        "learning.law": law,
        "learning.parameters": (0.2 * signs).tolist(),
        "learning.theta_estimate": None,
    }
    if disturbed:
        amplitude = [0.1, 0.1]
        settings["flow.disturbance"] = {"kind": "constant", "amplitude": amplitude}
    if LAWS[law].alpha_is_constant:
        settings["learning.parameters"] = None
    if law == "known-flow":
        settings["learning.theta_estimate"] = (0.4 * signs).tolist()
    if LAWS[law].at_fixes:
        settings |= AT_FIXES
    return paper_scenario().with_values(settings)


def law_and_V(law: Law, N: int, speed: Hedging = "no limit") -> tuple[Block, Block]:
    """Return a law's block and V in the theorems' scenario, at its defaults.

    A default of 0 is replaced by 0.1: zero is not a symbol.
    """
    scenario = theorem_scenario(N, law.name, speed=speed)
    inputs = scenario.known_to_law
    settings = {
        key: 0.1 if value == 0 else value for key, value in inputs.settings.items()
    }
    block = law.block(inputs._replace(settings=settings))
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
    `law_block` and `candidate` (with the output V[1]) replace those of the paper.
    """
    scenario = theorem_scenario(N, law, disturbed, speed)
    blocks = {block.name: block for block in paper_blocks(scenario)}
    if law_block is not None:
        blocks["adaptation"] = law_block
    if candidate is None:
        candidate = theorem_candidate(scenario)
    external = [port for name, port in SOURCES.items() if name in blocks]
    wired = [block for name, block in blocks.items() if name not in SOURCES]
    return connect([*wired, candidate], external, name="theorem")


def law_loop(law: Law, block: Block, V: Block, speed: Hedging = "no limit") -> Diagram:
    """Wire a law of the table with its V."""
    name = law.name if law.alpha_is_constant else "learned-flow"
    return theorem_loop(functions_of(block), name, False, block, V, speed)


def theorem_candidate(scenario: Scenario) -> Block:
    """Return V of Eq. (17) or (24) with the scenario's truth."""
    gain = scenario.learning.used_gains.parameters
    parameters = weighted([gain] * 3, *truth_of(scenario))
    return lyapunov_candidate(scenario.learning.law, parameters)


def mixed_level(t, x, u, p):
    """V of Eq. (24) with the inverse of a matrix of gains between all learned parameters."""
    alpha_error = np.ravel(p.theta + u.alpha)
    eta = np.concatenate([alpha_error, u.K - p.KD, u.Gamma - p.GammaD])
    return {"V": (u.e @ u.e + eta @ (p.inverse @ eta)) / 2}


def mixed_candidate(inverse: np.ndarray, truth: Truth) -> Block:
    """Return V of the errors of alpha row by row, K and Gamma, weighted by a matrix."""
    parameters = {"inverse": inverse, **truth._asdict()}
    return paper_block("lyapunov", PORTS, parameters, output=mixed_level)


def symbols_of_V(
    loop: SymbolicLoop, V: Block, make: Callable[..., Block], *sources: tuple
) -> dict:
    """Return the symbols of V -> the symbols of the parameters that they are equal to.

    A source is a named tuple of numbers, as parameters and the truth are, and one of their symbols.
    V is made again with random numbers; a parameter of V that equals one of the numbers, or its
    square, has the symbol of that number.
    """
    random = np.random.default_rng(0)
    symbol_of: dict[float, Any] = {}
    varied = []
    for numbers, symbols in sources:
        changed = {}
        for field, value in numbers._asdict().items():
            if isinstance(value, int) or field == "interval":
                continue
            scaled = np.asarray(value, dtype=float)
            scaled = scaled * random.uniform(1.01, 1.1, scaled.shape)
            changed[field] = scaled
            for power in (1, 2):
                array = np.asarray(getattr(symbols, field), dtype=object)
                pairs = _elements(scaled**power, array**power)
                symbol_of.update(pairs)
        varied.append(numbers._replace(**changed))
    varied_V = make(*varied).parameters
    return {
        symbol: symbol_of[number]
        for field, value in varied_V._asdict().items()
        for number, symbol in _elements(value, getattr(loop.parameters[V.name], field))
        if number in symbol_of and getattr(symbol, "is_Symbol", False)
    }


def _elements(numbers: np.ndarray, symbols: np.ndarray) -> list[tuple[float, Any]]:
    """Return pairs of a number and its symbol from two arrays."""
    numbers = np.asarray(numbers, dtype=float)
    symbols = np.asarray(symbols, dtype=object)
    numbers, symbols = np.broadcast_arrays(numbers, symbols)
    return [*zip(numbers.ravel().tolist(), symbols.ravel(), strict=True)]


def truth_in(loop: SymbolicLoop) -> Truth:
    """Return the symbols of theta, KD and GammaD."""
    vehicle = loop.parameters["vehicle_controller"]
    theta = loop.parameters["true_flow"].theta
    return Truth(theta, vehicle.KD, vehicle.GammaD)


class ErrorCoordinates:
    """e as symbols of their own, in place of z = x - e, in a loop on symbols."""

    def __init__(self, loop: SymbolicLoop):
        self.loop = loop
        self.x, self.z = loop.states["x"], loop.states["z"]
        # a state of the law may be called e_1 as well
        self.e = sympy.symbols("e_1:3", real=True, cls=sympy.Dummy)
        triples = [*zip(self.x, self.z, self.e, strict=True)]
        self.in_e = {z: x - e for x, z, e in triples}
        self.in_x = {e: x - z for x, z, e in triples}

    def motion(self, read: Callable[[sympy.Expr], sympy.Expr]) -> dict[Any, Any]:
        """Return the rates of all states but z, and of e, each as it is read."""
        rates = self.loop.motion
        motion = {s: read(rate) for s, rate in rates.items() if s not in self.z}
        for e, x, z in zip(self.e, self.x, self.z, strict=True):
            motion[e] = read(rates[x] - rates[z])
        return motion


Loop = ArrayLoop | SymbolicLoop
WIRED = 3  # functions of a loop whose equations are computed for every N


def decay(loop: Loop) -> Any:
    """V' = -e^T KD e, Eq. (26)."""
    KD = loop.parameters["vehicle_controller"].KD
    return -np.sum(KD * loop.signals["e"] ** 2)


def decay_and_known_error(loop: Loop) -> Any:
    """V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1."""
    theta_hat = loop.parameters["injection"].theta_hat
    error = loop.parameters["true_flow"].theta - theta_hat
    return decay(loop) + loop.signals["e"] @ (error @ loop.inputs["phi_x"])


def rate_of_V(loop: Loop) -> Any:
    """Return V' along the equations."""
    return loop.derivative(loop.signals["V"][0])
