"""The search for points at which the running blocks have V' > 0.

A law that is right but for a bounded term has V' > 0 near the truth; one that is wrong
has it however far off.  So a point counts where V' > 0 also ten and a hundred times as far
from the truth, and V' grows with V.
"""

import control
import numpy as np
import sympy

from ...errors import DiagramError
from ...progress.interrupt import check
from .random_points import Draw, Point, numbers_at
from .running_blocks import Functions, RunningBlocks
from .running_rate import degree_of, numeric, rate_along
from .symbolic_loop import SymbolicLoop

DRAWS, PER_DRAW, TRIED = 100, 200, 3
FARTHER = (1.0, 10.0, 100.0)


def refuting_point(
    diagram: control.NonlinearIOSystem,
    loop: SymbolicLoop,
    rate: sympy.Expr,
    kept: tuple[str, ...],
    seed: int = 0,
) -> tuple[Point | None, float | None]:
    """Return a point with V' > 0 and V' of the running blocks there, or None, None.

    `rate` is V' on symbols, by which points are chosen where it has numbers; the blocks in
    `kept` keep their own parameters.
    """
    running, degree = RunningBlocks(diagram), degree_of(loop)
    draw = Draw(running.blocks, loop, seed)
    try:
        function, symbols = numeric(rate)
    except DiagramError:
        function, symbols = None, []
    try:
        for _ in range(DRAWS if function is not None else 4):
            check()
            values = draw.parameters(kept, largest=0.0)
            params = draw.params(values)
            x, far, u = _around_the_truth(draw, values)
            order = list(range(PER_DRAW))
            if function is not None:
                known = draw.at(values, np.zeros(PER_DRAW), x, u)
                with np.errstate(all="ignore"):
                    rates = np.broadcast_to(function(*(known[s] for s in symbols)), PER_DRAW)
                steepest = np.argsort(-rates / np.sum(far**2, axis=1))
                order = [int(k) for k in steepest if rates[k] > 0][:TRIED]
            if len(order):
                running.set(params)
            for k in order:
                found = _persists(running.functions, x[k] - far[k], far[k], u[k], degree)
                if found is not None:
                    return Point(0.0, x[k], u[k], params), found
    finally:
        diagram._update_params({})
    return None, None


def _persists(
    functions: Functions, truth: np.ndarray, far: np.ndarray, u: np.ndarray, degree: float
) -> float | None:
    """Return V' where it is positive at all distances and grows with V."""
    x = np.array([truth + times * far for times in FARTHER])
    point = np.zeros(len(x)), x, np.tile(u, (len(x), 1))
    rate, scale = rate_along(functions, *point, degree)
    V = functions.values(*point)
    if not np.all((rate > 1e-6 * scale) & (V > 0)):
        return None
    return float(rate[0]) if rate[-1] / V[-1] >= 0.5 * rate[0] / V[0] else None


def _around_the_truth(draw: Draw, values: dict) -> tuple:
    """Return states, what of them is error, and inputs."""
    random, loop = draw.random, draw.loop
    flow, car = loop.parameters["true_flow"], loop.parameters["vehicle_controller"]
    theta, KD, GammaD = (numbers_at(values, own) for own in (flow.theta, car.KD, car.GammaD))
    ports = [port for port, symbols in loop.states.items() for _ in symbols.flat]
    n, inputs = len(ports), sum(np.size(own) for own in loop.inputs.values())
    u = random.standard_normal((PER_DRAW, inputs)) * 10.0 ** random.uniform(-1, 0.5, (PER_DRAW, 1))
    x = random.standard_normal((PER_DRAW, n)) * 10.0 ** random.uniform(-1, 0.5, (PER_DRAW, 1))
    far = random.standard_normal((PER_DRAW, n)) * 10.0 ** random.uniform(-1, 1, (PER_DRAW, n))
    at = {port: [k for k, own in enumerate(ports) if own == port] for port in set(ports)}
    true = {"alpha": -theta.ravel(), "K": KD, "Gamma": GammaD}
    for port, where in at.items():
        if port == "x":
            x[:, where] = x[:, at["z"]]
        elif port in true:
            x[:, where] = true[port]
        else:
            far[:, where] = 0.0
    return x + far, far, u
