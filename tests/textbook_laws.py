"""Right adaptive laws of textbooks, each with the V that proves it in two lines, or the default.

A V is made of the truth: theta, KD and GammaD of whatever vehicle and flow there are.
"""

import numpy as np
from own_laws import (
    FLOW,
    GAIN,
    LEARNED,
    N,
    V_of,
    changed,
    driven,
    filled,
    formula,
    law,
    leak,
    scaled,
    seen,
    two,
)

MATRIX = {**GAIN, "M": np.array([[2.0, 1.0], [1.0, 2.0]])}


def of_e(measure, **parameters):
    """Make V of the truth, with a measure of e."""
    return V_of(f"sum({measure}) + off/(2*gain)", **parameters)


MAPPED = {"s": (2, "N"), "K": 2, "Gamma": 2}


def through(alpha, parameters=GAIN):
    """Make a law whose alpha is made of a state s."""
    own = formula(alpha, MAPPED, parameters)

    def output(t, x, u, p):
        """alpha of s, section III."""
        return {"alpha": own(t, x, u, p), "K": x.K, "Gamma": x.Gamma, "s": x.s}

    outputs = {**LEARNED, "s": (2, "N")}
    return changed("s' = dalpha", parameters, states=MAPPED, outputs=outputs, output=output)


def of_state(level):
    """V with a level of s for alpha's errors."""
    off = "sum((K - KD)**2) + sum((Gamma - GammaD)**2)"
    return V_of(f"e @ e/2 + (sum({level}) + ({off})/2)/gain", MAPPED)


def least_squares(t, x, u, p):
    """Least squares of the flow along the way, section III, as an engineer writes it."""
    Pphi = x.P @ u.phi_x
    eps = u.flow_x + x.alpha @ u.phi_x
    return filled(u, p.gain, u.e) | {
        "alpha": -np.outer(p.gain * u.e + eps, Pphi),
        "P": -np.outer(Pphi, Pphi),
        "R": np.outer(u.phi_x, u.phi_x),
    }


SQUARES = {"states": {**LEARNED, "P": (N, N), "R": (N, N)}}
WITH_R = (  # V with the information R, the inverse of P
    "e @ e/2 + (sum(((theta + alpha) @ R)*(theta + alpha))"
    " + sum((K - KD)**2) + sum((Gamma - GammaD)**2))/(2*gain)"
)


def inverse(s, p, truth):
    """P is the inverse of R."""
    (a, b), (_, d) = s["R"]
    det = a * d - b**2
    return {"R": (s["R"] + s["R"].T) / 2, "P": np.array([[d, -b], [-b, a]]) / det}


def squares_lost(s, p, truth):
    """What V' loses."""
    eps = (truth.theta + s["alpha"]) @ s["phi_x"]
    return [(np.sum(eps**2), 1 / (2 * p.gain))]


def shown(make, status="proved", **more):
    """A law, what else `prove` is given, and what it says."""
    return make, more, status


ZONE = {"zone": np.array([0.1, 0.3])}
EACH = {"gain": 0.5, **ZONE}
CLIP, PARTLY = "clip(e, -1.0, 1.0)", "s - c*outer(e, phi_x)"
BEYOND, RISING = "(e - clip(e, -zone, zone))", "(2.0 - exp(-t))"
CROSSED = "K' = dK + c*zc*e; Gamma' = dGamma - c*z*e"

LAWS = {
    "a matrix of gains": shown(changed("alpha' = -outer(e, M @ phi_x)", MATRIX)),
    "axes mixed": shown(changed("alpha' = -outer(M @ e, phi_x)", MATRIX)),
    "gains crossed": shown(changed(CROSSED, two(0.1), n=1)),
    "tanh of eps": shown(seen("tanh(eps)")),
    "sign of eps": shown(seen("sign(eps)")),
    "clip of eps": shown(seen("clip(eps, -0.2, 0.2)")),
    "a dead zone of eps": shown(seen("(eps - clip(eps, -0.3, 0.3))")),
    "eps exp(-eps^2)": shown(seen("eps*exp(-eps**2)")),
    "eps and its cube": shown(seen("eps + eps**3")),
    "tanh of e": shown(driven("tanh(e)"), V=of_e("log(cosh(e))")),
    "atan of e": shown(driven("arctan(e)"), V=of_e("e*arctan(e) - log1p(e**2)/2")),
    "clip of e": shown(driven(CLIP), V=of_e(f"e*{CLIP} - {CLIP}**2/2")),  # Huber's
    "e and its cube": shown(driven("e + e**3"), V=of_e("e**2/2 + e**4/4")),
    "the cube of e": shown(driven("e**3"), V=of_e("e**4/4")),
    "e |e|": shown(driven("e*abs(e)"), V=of_e("abs(e)**3/3")),
    "a dead zone each": shown(driven(BEYOND, EACH), "bounded", V=of_e(f"{BEYOND}**2/2", **ZONE)),
    "a cubic leak": shown(leak("gain*c*alpha**2", ("alpha",), two(0.1)), "bounded"),
    "a periodic leak": shown(leak("gain*c*(1 + sin(t))", LEARNED, two(0.1)), "bounded"),
    "alpha = 2 s": shown(through("2*s")),
    "alpha = s + s^3": shown(through("s + s**3"), V=of_state("theta*s + s**2/2 + s**4/4")),
    "a part in proportion to e": shown(through(PARTLY, two(0.2)), V=of_state("(theta + s)**2/2")),
    "a rising gain": shown(scaled(RISING), V=V_of(f"e @ e/2 + off/(2*gain*{RISING})")),
    "least squares": shown(
        lambda: law(least_squares, GAIN, FLOW, **SQUARES),
        V=V_of(WITH_R, {**LEARNED, "R": (N, N)}),
        **{"invariants": inverse, "semidefinite": ("R",), "losses": squares_lost},
    ),
}
