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
    law,
    leak,
    off,
    pushed,
    two,
)

MATRIX = np.array([[2.0, 1.0], [1.0, 2.0]])


def of_e(measure, **parameters):
    """Make V of the truth, with a measure of e."""
    return V_of(lambda t, u, p: np.sum(measure(u.e, p)) + off(u, p) / (2 * p.gain), **parameters)


def seen(function):
    """With a function of the flow's own prediction error."""
    return pushed(
        lambda x, u, p: -p.c * np.outer(function(u.flow_x + x.alpha @ u.phi_x), u.phi_x),
        parameters=two(0.3),
        more=FLOW,
    )


def by(function):
    """A function of e in place of e."""
    return driven(lambda t, x, u, p: function(u.e))


def huber(e, p):
    c = np.clip(e, -1.0, 1.0)
    return e * c - c**2 / 2


def beyond(e, zone):
    return e - np.clip(e, -zone, zone)


def in_a_box(t, x, u, p):
    """Each alpha stays within -c and c, section III."""
    rates = filled(u, p.gain, u.e)
    a, rate = x.alpha, rates["alpha"]
    leaves = ((a >= p.c) & (rate > 0)) | ((a <= -p.c) & (rate < 0))
    return rates | {"alpha": np.where(leaves, 0.0, rate)}


MAPPED = {"states": {"s": (2, "N"), "K": 2, "Gamma": 2}}


def through(function, **more):
    """alpha is made of a state, section III."""

    def output(t, x, u, p):
        return {"alpha": function(x, u, p), "K": x.K, "Gamma": x.Gamma, "s": x.s}

    return MAPPED | {"outputs": {**LEARNED, "s": (2, "N")}, "output": output, **more}


def behind(t, x, u, p):
    """What is learned is behind a map, section III."""
    rates = filled(u, p.gain, u.e)
    return {"s": rates["alpha"], "K": rates["K"], "Gamma": rates["Gamma"]}


def of_state(level):
    """V with a level of s for alpha's errors."""

    def V(t, u, p):
        off = np.sum((u.K - p.KD) ** 2) + np.sum((u.Gamma - p.GammaD) ** 2)
        return u.e @ u.e / 2 + (np.sum(level(u.s, p)) + off / 2) / p.gain

    return V_of(V, {"s": (2, "N"), "K": 2, "Gamma": 2})


def rising(t):
    return 2.0 - np.exp(-t)


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


def with_R(t, u, p):
    """V with the information R, the inverse of P."""
    eta = p.theta + u.alpha
    off = np.sum((u.K - p.KD) ** 2) + np.sum((u.Gamma - p.GammaD) ** 2)
    return u.e @ u.e / 2 + (np.sum((eta @ u.R) * eta) + off) / (2 * p.gain)


over_P = V_of(with_R, {**LEARNED, "R": (N, N)})


def inverse(s, p, truth):
    """P is the inverse of R."""
    (a, b), (_, d) = s["R"]
    det = a * d - b**2
    return {"R": (s["R"] + s["R"].T) / 2, "P": np.array([[d, -b], [-b, a]]) / det}


def squares_lost(s, p, truth):
    """What V' loses."""
    eps = (truth.theta + s["alpha"]) @ s["phi_x"]
    return [(np.sum(eps**2), 1 / (2 * p.gain))]


def proportional(x, u, p):
    return x.s - p.c * np.outer(u.e, u.phi_x)


EACH = {"gain": 0.5, "zone": np.array([0.1, 0.3])}
matrix_gain = changed(
    lambda t, x, u, p, r: r | {"alpha": -np.outer(u.e, p.M @ u.phi_x)}, {**GAIN, "M": MATRIX}
)


def shown(make, status="proved", **more):
    """A law, what else `prove` is given, and what it says."""
    return make, more, status


LAWS = {
    "a matrix of gains": shown(matrix_gain),
    "axes mixed": shown(
        changed(
            lambda t, x, u, p, r: r | {"alpha": -np.outer(p.M @ u.e, u.phi_x)},
            {**GAIN, "M": MATRIX},
        )
    ),
    "gains crossed": shown(
        changed(
            lambda t, x, u, p, r: (
                r | {"K": r["K"] + p.c * u.zc * u.e, "Gamma": r["Gamma"] - p.c * u.z * u.e}
            ),
            two(0.1),
            n=1,
        )
    ),
    "tanh of eps": shown(seen(np.tanh)),
    "sign of eps": shown(seen(np.sign)),
    "clip of eps": shown(seen(lambda s: np.clip(s, -0.2, 0.2))),
    "a dead zone of eps": shown(seen(lambda s: beyond(s, 0.3))),
    "eps exp(-eps^2)": shown(seen(lambda s: s * np.exp(-(s**2)))),
    "eps and its cube": shown(seen(lambda s: s + s**3)),
    "tanh of e": shown(by(np.tanh), V=of_e(lambda e, p: np.log(np.cosh(e)))),
    "atan of e": shown(by(np.arctan), V=of_e(lambda e, p: e * np.arctan(e) - np.log1p(e**2) / 2)),
    "clip of e": shown(by(lambda e: np.clip(e, -1.0, 1.0)), V=of_e(huber)),
    "e and its cube": shown(by(lambda e: e + e**3), V=of_e(lambda e, p: e**2 / 2 + e**4 / 4)),
    "the cube of e": shown(by(lambda e: e**3), V=of_e(lambda e, p: e**4 / 4)),
    "a dead zone each": shown(
        driven(lambda t, x, u, p: beyond(u.e, p.zone), EACH),
        "bounded",
        V=of_e(lambda e, p: beyond(e, p.zone) ** 2 / 2, zone=EACH["zone"]),
    ),
    "a cubic leak": shown(
        leak(lambda t, x, u, p: p.gain * p.c * x.alpha**2, ("alpha",), two(0.1)), "bounded"
    ),
    "a periodic leak": shown(
        leak(lambda t, x, u, p: p.gain * p.c * (1 + np.sin(t)), LEARNED, two(0.1)), "bounded"
    ),
    "alpha = 2 s": shown(lambda: law(behind, GAIN, **through(lambda x, u, p: 2 * x.s))),
    "alpha = s + s^3": shown(
        lambda: law(behind, GAIN, **through(lambda x, u, p: x.s + x.s**3)),
        V=of_state(lambda s, p: p.theta * s + s**2 / 2 + s**4 / 4),
    ),
    "a part in proportion to e": shown(
        lambda: law(behind, two(0.2), **through(proportional)),
        V=of_state(lambda s, p: (p.theta + s) ** 2 / 2),
    ),
    "a rising gain": shown(
        changed(lambda t, x, u, p, r: {port: rising(t) * own for port, own in r.items()}),
        V=V_of(lambda t, u, p: u.e @ u.e / 2 + off(u, p) / (2 * p.gain * rising(t))),
    ),
    "least squares": shown(
        lambda: law(least_squares, GAIN, FLOW, **SQUARES),
        V=over_P,
        invariants=inverse,
        semidefinite=("R",),
        losses=squares_lost,
    ),
}
