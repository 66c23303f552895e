"""Laws that forget: sigma, switching sigma and e-modification.

    alpha' = -gamma e phi^T - gamma s_1 alpha
    K'     = -gamma z e     - gamma s_2 K
    Gamma' =  gamma zc e    - gamma s_3 Gamma

are Eqs. (21)-(23) with a leak, theta_hat = -alpha.  It pulls all that is learned to zero, the
initial values of the paper, and stops the drift that a disturbance drives.

| law | s_1, and s_2, s_3 with K, Gamma and their limits |
|---|---|
| sigma | leak |
| switching-sigma | leak clip(norm(alpha)/M - 1, 0, 1) |
| e-modification | leak norm(e) |

With V of Eq. (24), a each of alpha, K and Gamma, its true value a* and d = a - a*,

    V' = -e^T KD e + e^T Delta - sum of s d^T a,    d^T a >= (|d|^2 - |a*|^2)/2

sigma: V comes down to a level in |a*|^2 and Delta^2; e need not go to zero without Delta.
switching-sigma: the same, and where |a*| <= M the leak never raises V, so e goes to zero without
Delta.  e-modification: V' <= 0 above a level.

Sources: Ioannou and Kokotovic 1984; Ioannou and Sun 1996, section 8.4; Narendra and Annaswamy 1987.

Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per time), K[2],
Gamma[2] (per time), the states.
"""

import math
from typing import NamedTuple

from ...equations.block import Block
from ..words import clip
from .law import Known, Law, Setting
from .learned_flow import V, learned_flow


class LeakParameters(NamedTuple):
    """Parameters of sigma and of e-modification."""

    N: int  # number of basis functions
    gain: float  # gamma > 0 of alpha, as in Eqs. (21)-(23)
    gain_K: float  # of K, 0 to hold it
    gain_Gamma: float  # of Gamma, 0 to hold it
    leak: float  # of sigma: gain times leak is per time; of e-modification: that times length


class SwitchingParameters(NamedTuple):
    """Parameters of switching sigma; limits above the true norms let e go to zero."""

    N: int  # number of basis functions
    gain: float  # gamma > 0 of alpha, as in Eqs. (21)-(23)
    gain_K: float  # of K, 0 to hold it
    gain_Gamma: float  # of Gamma, 0 to hold it
    leak: float  # gain times leak is per time
    largest_flow: float  # M, of alpha over both axes, length per time
    largest_feedback: float  # M of K, per time
    largest_feedforward: float  # M of Gamma, per time


def forget(x, p, flow, feedback, feedforward, dx):
    """Take gamma times a leak times what is learned from its rates."""
    n = 2 * p.N
    for j in range(n):
        dx[j] -= p.gain * flow * x[j]
    for i in range(2):
        dx[n + i] -= p.gain_K * feedback * x[n + i]
        dx[n + 2 + i] -= p.gain_Gamma * feedforward * x[n + 2 + i]


def switched(x, first, last, largest):
    """Return clip(norm/M - 1, 0, 1) of the states from first to last."""
    squares = 0.0
    for j in range(first, last):
        squares += x[j] ** 2
    return clip(math.sqrt(squares) / largest - 1.0, 0.0, 1.0)


def sigma_update(t, x, u, p, dx):
    """Eqs. (21)-(23), each less gamma leak times what is learned.

    u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2].
    """
    learned_flow(t, x, u, p, dx)
    forget(x, p, p.leak, p.leak, p.leak, dx)


def switching_update(t, x, u, p, dx):
    """Eqs. (21)-(23), with a leak from zero at a norm M to `leak` at 2 M.

    u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2].
    """
    n = 2 * p.N
    flow = p.leak * switched(x, 0, n, p.largest_flow)
    feedback = p.leak * switched(x, n, n + 2, p.largest_feedback)
    feedforward = p.leak * switched(x, n + 2, n + 4, p.largest_feedforward)
    learned_flow(t, x, u, p, dx)
    forget(x, p, flow, feedback, feedforward, dx)


def e_update(t, x, u, p, dx):
    """Eqs. (21)-(23), each less gamma leak |e| times what is learned.

    u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2].
    """
    leak = p.leak * math.hypot(u[0], u[1])
    learned_flow(t, x, u, p, dx)
    forget(x, p, leak, leak, leak, dx)


def law_block(update, parameters) -> Block:
    """Make a law with the ports of the paper's."""
    N = parameters.N
    return Block(
        "adaptation",
        update=update,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2},
        states={"alpha": 2 * N, "K": 2, "Gamma": 2},
        parameters=parameters,
    )


def sigma(known: Known) -> Block:
    """Make the law `sigma`."""
    leak = known.setting("leak", forgetting(known))
    return law_block(sigma_update, LeakParameters(known.N, *known.gains[:3], leak))


def switching_sigma(known: Known) -> Block:
    """Make the law `switching-sigma`."""
    leak = known.setting("leak", forgetting(known))
    p = SwitchingParameters(known.N, *known.gains[:3], leak, *limits(known))
    return law_block(switching_update, p)


def e_modification(known: Known) -> Block:
    """Make the law `e-modification`."""
    leak = known.setting("leak", forgetting(known) / known.reach)
    return law_block(e_update, LeakParameters(known.N, *known.gains[:3], leak))


def forgetting(known: Known) -> float:
    """Return the leak that forgets alpha within a cycle of the waypoints."""
    return 1.0 / (known.gains.parameters * known.cycle)


def limits(known: Known) -> tuple[float, float, float]:
    """Return M of alpha, K and Gamma: each flow parameter up to the speed to the farthest waypoint.

    That speed is KD times its distance; the gains are up to twice KD.
    """
    speed, KD = float(known.KD.max()) * known.reach, math.hypot(*known.KD)
    return (
        known.setting("largest_flow", math.sqrt(2 * known.N) * speed),
        known.setting("largest_feedback", 2.0 * KD),
        known.setting("largest_feedforward", 2.0 * KD),
    )


LIMITS = {
    "largest_flow": Setting(
        None,
        "positive",
        "largest norm of the flow parameters, length per time; sqrt(2 N) times "
        "the speed that KD asks for at the farthest waypoint",
    ),
    "largest_feedback": Setting(None, "positive", "largest norm of K, per time; twice that of KD"),
    "largest_feedforward": Setting(
        None, "positive", "largest norm of Gamma, per time; twice that of KD"
    ),
}
GAIN = ("learning.gain", "learning.gains.parameters")
LEAK = Setting(
    None,
    "positive",
    "its gain times leak is what is forgotten per time, of alpha all within a cycle",
)
SIGMA = Law(
    "sigma",
    promise="CLPE and all that is learned stay bounded under any bounded disturbance",
    needs="nothing but a gain; what is learned is pulled to zero",
    block=sigma,
    V=V,
    settings={"leak": LEAK},
    made_of=GAIN,
)
SWITCHING_SIGMA = Law(
    "switching-sigma",
    promise="as sigma, and CLPE goes to zero without disturbance where the limits hold",
    needs="limits of the flow parameters and gains",
    block=switching_sigma,
    V=V,
    settings={"leak": LEAK, **LIMITS},
    made_of=(*GAIN, "vehicle.feedback"),
)
E_MODIFICATION = Law(
    "e-modification",
    promise="V never rises above a level under a bounded disturbance; less is forgotten where "
    "CLPE is small",
    needs="nothing but a gain",
    block=e_modification,
    V=V,
    settings={
        "leak": Setting(
            None,
            "positive",
            "its gain times leak times CLPE is what is forgotten per time, of alpha all within "
            "a cycle at a CLPE as large as the farthest waypoint's distance",
        )
    },
    made_of=GAIN,
)
