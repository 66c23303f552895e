"""Right adaptive laws of textbooks, each with the V that proves it in two lines, or the default.

A V is made of the truth: theta, KD and GammaD of whatever vehicle and flow there are.
"""

import numpy as np
from own_laws import GAIN, LEARNED, N, filled, law, leaked, two

from clpt_control.equations import Block

MATRIX = np.array([[2.0, 1.0], [1.0, 2.0]])
FLOW = {"flow_x": 2}


def candidate(measure, truth, more=None, **parameters):
    """Make V of a measure of e, and squares of all other errors over twice the gain."""

    def V(t, x, u, p):
        squares = np.sum((p.theta + u.alpha) ** 2) + np.sum((u.K - p.KD) ** 2)
        return {
            "V": measure(t, u, p) + (squares + np.sum((u.Gamma - p.GammaD) ** 2)) / (2 * p.gain)
        }

    return Block(
        "measure",
        output=V,
        inputs={"e": 2, **LEARNED, **(more or {})},
        outputs={"V": 1},
        parameters={**GAIN, **truth._asdict(), **parameters},
        shapes={"theta": (2, "N")},
    )


def of_e(measure, **parameters):
    """Make V of the truth, with a measure of e."""
    return lambda truth: candidate(lambda t, u, p: np.sum(measure(u.e, p)), truth, **parameters)


def matrix_gain(t, x, u, p):
    """A matrix of gains over the functions, section III."""
    return filled(u, p.gain, u.e) | {"alpha": -np.outer(u.e, p.M @ u.phi_x)}


def mixed_axes(t, x, u, p):
    """e mixed by a matrix where alpha learns, section III."""
    return filled(u, p.gain, u.e) | {"alpha": -np.outer(p.M @ u.e, u.phi_x)}


def crossed_gains(t, x, u, p):
    """K and Gamma adapted by each other's signals, section III."""
    rates = filled(u, p.gain, u.e)
    rates["K"] += p.c * u.zc * u.e
    rates["Gamma"] -= p.c * u.z * u.e
    return rates


def seen(function):
    """With a function of the flow's own prediction error, section III."""

    def update(t, x, u, p):
        rates = filled(u, p.gain, u.e)
        rates["alpha"] -= p.c * np.outer(function(u.flow_x + x.alpha @ u.phi_x), u.phi_x)
        return rates

    return update


def by(function):
    """A function of e in place of e, section III."""
    return lambda t, x, u, p: filled(u, p.gain, function(u.e))


def huber(e, p):
    c = np.clip(e, -1.0, 1.0)
    return e * c - c**2 / 2


def beyond(e, zone):
    return e - np.clip(e, -zone, zone)


def dead_zones(t, x, u, p):
    """A dead zone on each axis, section III."""
    return filled(u, p.gain, beyond(u.e, p.zone))


def in_a_box(t, x, u, p):
    """Each alpha stays within -c and c, section III."""
    rates = filled(u, p.gain, u.e)
    a, rate = x.alpha, rates["alpha"]
    leaves = ((a >= p.c) & (rate > 0)) | ((a <= -p.c) & (rate < 0))
    return rates | {"alpha": np.where(leaves, 0.0, rate)}


def within(states, p, truth):
    """theta lies in the box."""
    return [*np.ravel(p.c - truth.theta), *np.ravel(p.c + truth.theta)]


def cubic_leak(t, x, u, p):
    """A leak of alpha's cube, section III."""
    return filled(u, p.gain, u.e) | {
        "alpha": -p.gain * np.outer(u.e, u.phi_x) - p.gain * p.c * x.alpha**3
    }


def periodic_leak(t, x, u, p):
    """A leak that comes and goes, section III."""
    return leaked(x, filled(u, p.gain, u.e), p.gain * p.c * (1 + np.sin(t)), LEARNED)


def leak_by_e_squared(t, x, u, p):
    """e-modification with |e|^2, section III."""
    return leaked(x, filled(u, p.gain, u.e), p.gain * p.c * (u.e @ u.e))


def little(states, p, truth):
    """What is true is small enough for this leak."""
    return [k - p.c * np.sum(truth.theta**2) for k in truth.KD]


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

    def make(truth):
        def V(t, x, u, p):
            off = np.sum((u.K - p.KD) ** 2) + np.sum((u.Gamma - p.GammaD) ** 2)
            return {"V": u.e @ u.e / 2 + (np.sum(level(u.s, p)) + off / 2) / p.gain}

        return Block(
            "measure",
            output=V,
            inputs={"e": 2, "s": (2, "N"), "K": 2, "Gamma": 2},
            outputs={"V": 1},
            parameters={**GAIN, **truth._asdict()},
            shapes={"theta": (2, "N")},
        )

    return make


def rising(t):
    return 2.0 - np.exp(-t)


def rising_gain(t, x, u, p):
    """A gain that rises with time, section III."""
    return filled(u, p.gain * rising(t), u.e)


def over_time(truth):
    """V of a gain that rises."""

    def V(t, x, u, p):
        squares = np.sum((p.theta + u.alpha) ** 2) + np.sum((u.K - p.KD) ** 2)
        squares = squares + np.sum((u.Gamma - p.GammaD) ** 2)
        return {"V": u.e @ u.e / 2 + squares / (2 * p.gain * rising(t))}

    return Block(
        "measure",
        output=V,
        inputs={"e": 2, **LEARNED},
        outputs={"V": 1},
        parameters={**GAIN, **truth._asdict()},
        shapes={"theta": (2, "N")},
    )


def least_squares(t, x, u, p):
    """Least squares of the flow along the way, section III, as an engineer writes it."""
    Pphi = x.P @ u.phi_x
    eps = u.flow_x + x.alpha @ u.phi_x
    return filled(u, p.gain, u.e) | {
        "alpha": -np.outer(p.gain * u.e + eps, Pphi),
        "P": -np.outer(Pphi, Pphi),
        "R": np.outer(u.phi_x, u.phi_x),
    }


SQUARES = {
    "states": {**LEARNED, "P": (N, N), "R": (N, N)},
}


def over_P(truth):
    """V with the information R, the inverse of P."""

    def V(t, x, u, p):
        eta = p.theta + u.alpha
        off = np.sum((u.K - p.KD) ** 2) + np.sum((u.Gamma - p.GammaD) ** 2)
        return {"V": u.e @ u.e / 2 + (np.sum((eta @ u.R) * eta) + off) / (2 * p.gain)}

    return Block(
        "measure",
        output=V,
        inputs={"e": 2, **LEARNED, "R": (N, N)},
        outputs={"V": 1},
        parameters={**GAIN, **truth._asdict()},
        shapes={"theta": (2, "N")},
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


def proportional(x, u, p):
    return x.s - p.c * np.outer(u.e, u.phi_x)


PI = {"more": None}
EACH = {"gain": 0.5, "zone": np.array([0.1, 0.3])}
LAWS = {  # name -> (the law, what else prove is given, what it says)
    "a matrix of gains": (lambda: law(matrix_gain, {**GAIN, "M": MATRIX}), {}, "proved"),
    "axes mixed": (lambda: law(mixed_axes, {**GAIN, "M": MATRIX}), {}, "proved"),
    "gains crossed": (lambda: law(crossed_gains, two(0.1)), {}, "proved"),
    "tanh of eps": (lambda: law(seen(np.tanh), two(0.3), FLOW), {}, "proved"),
    "sign of eps": (lambda: law(seen(np.sign), two(0.3), FLOW), {}, "proved"),
    "clip of eps": (
        lambda: law(seen(lambda s: np.clip(s, -0.2, 0.2)), two(0.3), FLOW),
        {},
        "proved",
    ),
    "eps and its cube": (lambda: law(seen(lambda s: s + s**3), two(0.3), FLOW), {}, "proved"),
    "tanh of e": (
        lambda: law(by(np.tanh), GAIN),
        {"V": of_e(lambda e, p: np.log(np.cosh(e)))},
        "proved",
    ),
    "atan of e": (
        lambda: law(by(np.arctan), GAIN),
        {"V": of_e(lambda e, p: e * np.arctan(e) - np.log1p(e**2) / 2)},
        "proved",
    ),
    "clip of e": (
        lambda: law(by(lambda e: np.clip(e, -1.0, 1.0)), GAIN),
        {"V": of_e(huber)},
        "proved",
    ),
    "e and its cube": (
        lambda: law(by(lambda e: e + e**3), GAIN),
        {"V": of_e(lambda e, p: e**2 / 2 + e**4 / 4)},
        "proved",
    ),
    "the cube of e": (
        lambda: law(by(lambda e: e**3), GAIN),
        {"V": of_e(lambda e, p: e**4 / 4)},
        "proved",
    ),
    "a dead zone each": (
        lambda: law(dead_zones, EACH),
        {"V": of_e(lambda e, p: beyond(e, p.zone) ** 2 / 2, zone=EACH["zone"])},
        "bounded",
    ),
    "a box": (lambda: law(in_a_box, two(2.0)), {"given": within}, "proved"),
    "a cubic leak": (lambda: law(cubic_leak, two(0.1)), {}, "bounded"),
    "a periodic leak": (lambda: law(periodic_leak, two(0.1)), {}, "bounded"),
    "a leak by |e|^2": (lambda: law(leak_by_e_squared, two(0.1)), {"given": little}, "proved"),
    "alpha = 2 s": (lambda: law(behind, GAIN, **through(lambda x, u, p: 2 * x.s)), {}, "proved"),
    "alpha = s + s^3": (
        lambda: law(behind, GAIN, **through(lambda x, u, p: x.s + x.s**3)),
        {"V": of_state(lambda s, p: p.theta * s + s**2 / 2 + s**4 / 4)},
        "proved",
    ),
    "a part in proportion to e": (
        lambda: law(behind, two(0.2), **through(proportional)),
        {"V": of_state(lambda s, p: (p.theta + s) ** 2 / 2)},
        "proved",
    ),
    "a rising gain": (lambda: law(rising_gain, GAIN), {"V": over_time}, "proved"),
    "least squares": (
        lambda: law(least_squares, GAIN, FLOW, **SQUARES),
        {"V": over_P, "keeps": inverse, "cones": ("R",), "losses": squares_lost},
        "proved",
    ),
}
