"""Robust laws: leakage (sigma, switching sigma, e-modification), dead zone, and projection."""

from typing import Any

import numpy as np

from ..blocks import lyapunov
from .law import GAINS, Law, LawContext, Setting, Truth, promised
from .paper import driven_by, learned_flow

# --- leaks -----------------------------------------------------------------------------------


def leaking(t, x, u, p, s_1, s_2, s_3):
    """Laws with leakage: sigma, switching sigma and e-modification.

        alpha' = -gamma e phi^T - gamma s_1 alpha
        K'     = -gamma z e     - gamma s_2 K
        Gamma' =  gamma zc e    - gamma s_3 Gamma

    are Eqs. (21)-(23) with a leak, theta_hat = -alpha.  The leak pulls alpha, K and Gamma to zero,
    the initial values of the paper, and stops the drift that a disturbance drives.

    | law | s_1, and s_2, s_3 with K, Gamma and their limits |
    |---|---|
    | sigma | leak |
    | switching-sigma | leak clip(norm(alpha)/M - 1, 0, 1) |
    | e-modification | leak norm(e) |

    With V of Eq. (24), a each of alpha, K and Gamma, its true value a* and d = a - a*,

        V' = -e^T KD e + e^T Delta - sum of s d^T a,    d^T a >= (|d|^2 - |a*|^2)/2

    sigma: V is ultimately bounded by a level in |a*|^2 and Delta^2; e need not go to zero without
    Delta.  switching-sigma: the same bound; if |a*| <= M, the leak never increases V, so e goes to
    zero without Delta.  e-modification: V' <= 0 above a level.

    Sources: Ioannou and Kokotovic 1984; Ioannou and Sun 1996, section 8.4; Narendra and Annaswamy
    1987.

    Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per time), K[2],
    Gamma[2] (per time), the states.
    """
    rates = learned_flow(t, x, u, p)
    return {
        "alpha": rates["alpha"] - p.gain * s_1 * x.alpha,
        "K": rates["K"] - p.gain_K * s_2 * x.K,
        "Gamma": rates["Gamma"] - p.gain_Gamma * s_3 * x.Gamma,
    }


def sigma(t, x, u, p):
    """Eqs. (21)-(23), each rate minus gamma leak times alpha, K or Gamma."""
    return leaking(t, x, u, p, p.leak, p.leak, p.leak)


def switching_sigma(t, x, u, p):
    """Eqs. (21)-(23), with a leak from zero at a norm M to `leak` at 2 M."""
    limits = p.largest_flow, p.largest_feedback, p.largest_feedforward
    norms = map(np.linalg.norm, (x.alpha, x.K, x.Gamma))
    leaks = (
        p.leak * np.clip(a / M - 1, 0, 1) for a, M in zip(norms, limits, strict=True)
    )
    return leaking(t, x, u, p, *leaks)


def e_modification(t, x, u, p):
    """Eqs. (21)-(23), each rate minus gamma leak |e| times alpha, K or Gamma."""
    leak = p.leak * np.linalg.norm(u.e)
    return leaking(t, x, u, p, leak, leak, leak)


def cycle_leak(context: LawContext) -> float:
    """Return the leak that forgets alpha within a cycle of the waypoints."""
    return 1.0 / (context.gains.parameters * context.cycle)


def twice_gains(context: LawContext) -> float:
    """Return M of K and of Gamma: up to twice the vehicle's own gains."""
    return 2.0 * float(max(np.hypot(*context.KD), np.hypot(*context.GammaD)))


TWICE = "twice the larger of those of KD and GammaD"
NORM_LIMITS = {
    "largest_flow": Setting(
        "largest norm of alpha, length per time; (2 N)^0.5 max KD at the farthest waypoint",
        lambda context: (
            float(np.sqrt(2 * context.N) * context.KD.max()) * context.reach
        ),
    ),
    "largest_feedback": Setting(f"largest norm of K, per time; {TWICE}", twice_gains),
    "largest_feedforward": Setting(
        f"largest norm of Gamma, per time; {TWICE}", twice_gains
    ),
}


def beyond_limits(p: Any, truth: Truth) -> str:
    """Return a sentence if the truth is outside the limits of an adapted parameter, or ""."""
    adapts = p.gain, p.gain_K, p.gain_Gamma
    outside = [
        f"{key} = {getattr(p, key):.3g} is below the truth's {np.linalg.norm(true):.3g}"
        for key, true, gain in zip(NORM_LIMITS, truth, adapts, strict=True)
        if gain > 0 and np.linalg.norm(true) > getattr(p, key)
    ]
    return f"{', '.join(outside)}: CLPE need not go to zero" if outside else ""


LEAK = Setting(
    "its gain times leak is forgotten per time, all of alpha in a cycle", cycle_leak
)
SIGMA = Law(
    "sigma",
    needs="nothing but a gain; what is learned is pulled to zero",
    rates=sigma,
    family=leaking,
    promises=promised("true bounded exact", "level"),
    parameters={**GAINS, "leak": LEAK},
)
SWITCHING_SIGMA = Law(
    "switching-sigma",
    needs="limits of the flow parameters and gains",
    rates=switching_sigma,
    family=leaking,
    promises=(
        *promised("true bounded exact", "level"),
        *promised("true within spanned exact", "falls", "settles"),
    ),
    parameters={**GAINS, "leak": LEAK, **NORM_LIMITS},
    doubt=beyond_limits,
)
E_MODIFICATION = Law(
    "e-modification",
    needs="nothing but a gain",
    rates=e_modification,
    family=leaking,
    promises=promised("true bounded exact", "level"),
    parameters={
        **GAINS,
        "leak": Setting(
            "as of sigma, by CLPE; as much at a CLPE as far as the farthest waypoint",
            lambda context: cycle_leak(context) / context.reach,
        ),
    },
)


# --- a zone ----------------------------------------------------------------------------------


def outside_zone(e, zone):
    """Return D(e) = e - clip(e, -d, d)."""
    return e - np.clip(e, -zone, zone)


def dead_zone_law(t, x, u, p):
    """The dead-zone law: CLPE that a disturbance may have caused is not learned from.

        D_i(e) = e_i - clip(e_i, -d, d)
        alpha' = -gamma D phi^T,    K' = -gamma z D,    Gamma' = gamma zc D

    are Eqs. (21)-(23) with D in place of e, continuous at d = `zone`.  V of Eq. (24) has D in
    place of e.  Since D D' = D e' everywhere, and D_i e_i = |D_i| (|D_i| + d) where D_i is not
    zero,

        V' = -D^T KD e + D^T Delta <= -D^T KD D    if |Delta_i| <= KD_i d

    so V is non-increasing, alpha, K and Gamma stay bounded, and |e_i| converges to at most d.

    Source: Ioannou and Sun 1996, section 8.4.3.

    Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per time), K[2],
    Gamma[2] (per time), the states; of V: e[2], alpha[2N], K[2], Gamma[2] -> V[1].
    """
    return driven_by(outside_zone(u.e, p.zone), u, p)


def candidate(t, x, u, p):
    """V of Eq. (24) with D(e) in place of e."""
    return {
        "V": lyapunov.level(outside_zone(u.e, p.zone), u, p) + lyapunov.flow_level(u, p)
    }


DEAD_ZONE = Law(
    "dead-zone",
    needs="a zone as large as the disturbance over KD",
    rates=dead_zone_law,
    parameters={
        **GAINS,
        "zone": Setting(
            "CLPE of which nothing is learned, length; a fiftieth of the farthest waypoint",
            lambda context: context.reach / 50,
        ),
    },
    candidate=candidate,
    promises=promised("true small exact", "falls", "zone"),
)


# --- balls -----------------------------------------------------------------------------------


def projected_rate(a, rate, largest, layer):
    """Return the rate of a without its outward component."""
    squares, inner = np.sum(a * a), largest**2
    share = np.clip((squares - inner) / (inner * layer * (2 + layer)), 0, 1)
    return (
        rate - share * np.maximum(np.sum(rate * a), 0) / np.maximum(squares, inner) * a
    )


def projection(t, x, u, p):
    """The projection law: alpha, K and Gamma stay within balls.

        a' = r - c a max(r^T a, 0)/max(|a|^2, M^2),    c = clip((|a|^2 - M^2)/(R^2 - M^2), 0, 1)

    r is the rate of Eqs. (21)-(23), a each of alpha, K and Gamma, with its own limit M;
    R = (1 + layer) M.  The outward component of r is removed: a growing share of it between the
    norms M and R, so that a' stays continuous, and all of it beyond R:

        (|a|^2/2)' = r^T a - max(r^T a, 0) <= 0    if |a| >= R, for any e

    so |a| never exceeds the larger of R and |a(0)|.  With V of Eq. (24), the true value a* and
    |a*| <= M, the removed component never increases V: a^T (a - a*) >= |a| (|a| - |a*|) >= 0 if
    c > 0.

    Source: Ioannou and Sun 1996, section 8.5; the continuous form of Pomet and Praly 1992.

    Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per time), K[2],
    Gamma[2] (per time), the states.
    """
    r = learned_flow(t, x, u, p)
    return {
        "alpha": projected_rate(x.alpha, r["alpha"], p.largest_flow, p.layer),
        "K": projected_rate(x.K, r["K"], p.largest_feedback, p.layer),
        "Gamma": projected_rate(x.Gamma, r["Gamma"], p.largest_feedforward, p.layer),
    }


PROJECTION = Law(
    "projection",
    needs="limits of the flow parameters and gains, and a start within them",
    rates=projection,
    promises=(
        *promised("", "balls"),
        *promised("true within spanned exact", "falls", "settles"),
        *promised("true within exact", "mean square"),
    ),
    parameters={
        **GAINS,
        **NORM_LIMITS,
        "layer": Setting("how far beyond a limit, as a share of it", 0.1),
    },
    doubt=beyond_limits,
)

LAWS = (SIGMA, SWITCHING_SIGMA, E_MODIFICATION, DEAD_ZONE, PROJECTION)
