"""Adaptive laws as users write them: right ones, wrong ones, and odd ones.

u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2], section III.
"""

import numpy as np

from clpt_control.equations import Block, lookup, opaque
from clpt_control.theory.proving.theorem_loop import theorem_scenario

N = 2
LEARNED = {"alpha": (2, "N"), "K": 2, "Gamma": 2}
GAIN = {"gain": 0.5}


def law(update, parameters, more=None, n=N, **ports):
    """Make a law of a function, with further inputs, or other states and outputs."""
    return Block(
        "own",
        update=update,
        inputs={"e": 2, "phi_x": "N", "z": 2, "zc": 2, **(more or {})},
        parameters=parameters,
        sizes={"N": n},
        **({"states": LEARNED} | ports),
    )


def two(c, gain=0.5):
    return {"gain": gain, "c": c}


def filled(u, gain, e):
    """Eqs. (21)-(23) with this gain and this error."""
    return {"alpha": -gain * np.outer(e, u.phi_x), "K": -gain * u.z * e, "Gamma": gain * u.zc * e}


def shipped(t, x, u, p):
    """The paper's law, section III."""
    return filled(u, p.gain, u.e)


def flipped(t, x, u, p):
    """Every sign flipped, section III."""
    return filled(u, -p.gain, u.e)


def called_rate(t, x, u, p):
    """The gain's field is called rate, section III."""
    return filled(u, p.rate, u.e)


def called_gamma(t, x, u, p):
    """The gain's field is called gamma, section III."""
    return filled(u, p.gamma, u.e)


def times_one(t, x, u, p):
    """Times sin^2 + cos^2, section III."""
    return filled(u, p.gain * (np.sin(u.e[0]) ** 2 + np.cos(u.e[0]) ** 2), u.e)


def clipped_and_back(t, x, u, p):
    """e as clip(e) + (e - clip(e)), section III."""
    inner = np.clip(u.e, -1.0, 1.0)
    return filled(u, p.gain, inner + (u.e - inner))


def three_gains(t, x, u, p):
    """A gain each for alpha, K and Gamma, section III."""
    alpha = -p.gains[0] * np.outer(u.e, u.phi_x)
    return {"alpha": alpha, "K": -p.gains[1] * u.z * u.e, "Gamma": p.gains[2] * u.zc * u.e}


def a_gain_each(t, x, u, p):
    """A gain for each function, and K held apart, section III."""
    alpha = -p.gains * np.outer(u.e, u.phi_x)
    return {"alpha": alpha, "K": -np.array([1.0, 2.0]) * u.z * u.e, "Gamma": 0.3 * u.zc * u.e}


def tanh_of_e(t, x, u, p):
    """tanh(e) in place of e: falls with another V, ln cosh(e), section III."""
    return filled(u, p.gain, np.tanh(u.e))


def composite(t, x, u, p):
    """With the flow's own prediction error, section III."""
    rates = filled(u, p.gain, u.e)
    rates["alpha"] -= p.c * np.outer(u.flow_x + x.alpha @ u.phi_x, u.phi_x)
    return rates


def leaked(x, rates, share, ports=("alpha",)):
    """Take a share of what is learned from the rates."""
    return rates | {port: rates[port] - share * getattr(x, port) for port in ports}


def leak(t, x, u, p):
    """With a leak c of all that is learned, section III."""
    return leaked(x, filled(u, p.gain, u.e), p.gain * p.c, LEARNED)


def leak_of_alpha(t, x, u, p):
    """With a leak c of alpha alone, section III."""
    return leaked(x, filled(u, p.gain, u.e), p.gain * p.c)


def projection(t, x, u, p):
    """alpha kept within a ball of radius c on each axis, section III."""
    rates = filled(u, p.gain, u.e)
    size = np.sum(x.alpha**2, axis=1)
    outward = np.maximum(np.sum(rates["alpha"] * x.alpha, axis=1), 0.0)
    off = np.where(size > p.c**2, outward / np.maximum(size, 1e-9), 0.0)
    return leaked(x, rates, off[:, None])


def e_leak_of_alpha(t, x, u, p):
    """A leak of alpha alone, in proportion to |e|, section III."""
    return leaked(x, filled(u, p.gain, u.e), p.gain * p.c * np.hypot(u.e[0], u.e[1]))


def leak_that_fades(t, x, u, p):
    """A leak that is zero where |alpha| > 2, section III."""
    share = np.clip(2.0 - np.linalg.norm(x.alpha), 0.0, 1.0)
    return leaked(x, filled(u, p.gain, u.e), p.gain * p.c * share)


def leak_of_any_sign(t, x, u, p):
    """A leak between -c and c that rises with |alpha|, section III."""
    share = np.clip(np.linalg.norm(x.alpha) - 1.0, -1.0, 1.0)
    return leaked(x, filled(u, p.gain, u.e), p.gain * p.c * share)


def half_a_projection(t, x, u, p):
    """Half of the outward part taken away, section III."""
    rates = filled(u, p.gain, u.e)
    for ball in (("alpha",), ("K", "Gamma")):
        size = sum(np.sum(getattr(x, port) ** 2) for port in ball)
        outward = sum(np.sum(rates[port] * getattr(x, port)) for port in ball)
        share = 0.5 * np.clip(size / p.c**2 - 1.0, 0.0, 1.0)
        off = share * np.maximum(outward, 0.0) / np.maximum(size, p.c**2)
        rates = leaked(x, rates, off, ball)
    return rates


def equal_gain(t, x, u, p):
    """The sign turns at one gain, section III."""
    return filled(u, p.gain * np.where(p.gain == 0.5, -1.0, 1.0), u.e)


def equal_sign(t, x, u, p):
    """Nothing is learned where e > 0, section III."""
    return filled(u, p.gain, np.where(np.sign(u.e) == 1.0, 0.0, 1.0) * u.e)


def named_like_signals(t, x, u, p):
    """Leaks towards parameters K and z, not signals, section III."""
    rates = filled(u, p.gain, u.e)
    rates["K"] -= p.gain * (x.K - p.K)
    rates["Gamma"] += 0.3 * (u.z - p.z)
    return rates


def by_shape(t, x, u, p):
    """A leak of alpha where there are other than two gains, section III."""
    return leaked(x, filled(u, p.gains[0], u.e), len(p.gains) - 2.0)


def wrong_fifth(t, x, u, p):
    """The fifth function is learned backwards, section III."""
    rates = filled(u, p.gain, u.e)
    rates["alpha"] *= np.where(np.arange(len(u.phi_x)) == 4, -1.0, 1.0)
    return rates


def two_tables(t, x, u, p):
    """Two tables at one index, subtracted, section III."""
    rates = filled(u, p.gain, u.e)
    j = np.clip(np.floor(u.e[0]), 0.0, 1.0)
    rates["K"] += lookup(p.K, j) - lookup(p.z, j)
    return rates


@opaque
def hidden(table, s):
    return table[0] * s


def two_hidden(t, x, u, p):
    """Two arrays through one opaque helper, subtracted, section III."""
    rates = filled(u, p.gain, u.e)
    rates["K"] += hidden(p.K, u.z[0]) - hidden(p.z, u.z[0])
    return rates


def own_x(t, x, u, p):
    """A private state called x pushes alpha, section III."""
    rates = filled(u, p.gain, u.e)
    rates["alpha"] -= 0.1 * (x.x - u.z)[:, None]
    return {"x": -x.x, **rates}


def behind_x(t, x, u, p):
    """All states but the private one, section III."""
    return {"alpha": x.alpha, "K": x.K, "Gamma": x.Gamma}


def without_value(t, x, u, p):
    """z z/z in place of z, section III."""
    return filled(u, p.gain, u.e) | {"K": -p.gain * (u.z * u.z / u.z) * u.e}


def x_less_z(t, x, u, p):
    """x - z in place of e, a gain exp(c), section III."""
    return filled(u, np.exp(p.c), u.x - u.z)


def e_and_its_cube(t, x, u, p):
    """e + e^3 in place of e: falls with (e + e^3) in V, section III."""
    return filled(u, p.gain, u.e + u.e**3)


def memory(t, x, u, p):
    """With a remembered prediction error, never negative, section III."""
    rates, phi = filled(u, p.gain, u.e), u.phi_x[0]
    rates["alpha"][:, 0] -= p.c * (x.M[0] * x.alpha[:, 0] + x.M[1])
    return rates | {"M": [phi**2 - x.M[0], phi * u.flow_x - x.M[1]]}


def pulled_to_a_runaway(t, x, u, p):
    """alpha is pulled to a private state that grows, section III."""
    rates = filled(u, p.gain, u.e)
    rates["alpha"][0, 0] -= p.gain * (x.alpha[0, 0] - x.s[0])
    return rates | {"s": x.s}


def pulled_to_time(t, x, u, p):
    """alpha is pulled to the time, section III."""
    rates = filled(u, p.gain, u.e)
    rates["alpha"][0, 0] -= p.gain * (x.alpha[0, 0] - t)
    return rates


def too_large(t, x, u, p):
    """e as log(exp(e)), infinite beyond 709, section III."""
    return filled(u, p.gain, np.log(np.exp(u.e)))


def rounded_away(t, x, u, p):
    """e as (e + c) - c, zero for a large c, section III."""
    return filled(u, p.gain, (u.e + p.c) - p.c)


def divided(t, x, u, p):
    """The gain divided by c, section III."""
    return filled(u, p.gain / p.c, u.e)


def to_the_fortieth(t, x, u, p):
    """A sum to the power 40, section III."""
    rates = filled(u, p.gain, u.e)
    rates["alpha"][0, 0] += (x[0] + x[1] + u[0] + u[1] + u[2]) ** 40
    return rates


def without_end(t, x, u, p):
    """A choice of choices of choices, section III."""
    s = u.e[0]
    for j in range(40):
        s = np.where(s > j, s * u.phi_x[0], s + x.alpha[0, 0])
    return filled(u, p.gain, u.e + s)


def of_other_ports(t, x, u, p):
    """A law of one z and three zc, section III."""
    alpha = -p.gain * np.outer(u.e, u.phi_x)
    return {"alpha": alpha, "K": -p.gain * u.z[0] * u.e, "Gamma": p.gain * u.zc[:2] * u.e}


def indefinite(t, x, u, p):
    """V of Eq. (24) with the parameter errors' sign turned."""
    off = np.sum((p.theta + u.alpha) ** 2) + np.sum((u.K - p.KD) ** 2)
    return u.e @ u.e / 2 - (off + np.sum((p.GammaD - u.Gamma) ** 2)) / (2 * p.gain)


def turned_V():
    scenario = theorem_scenario(N, "learned-flow")
    car = scenario.vehicle
    truth = {"theta": scenario.flow.parameters, "KD": car.feedback, "GammaD": car.feedforward}
    return Block(
        "lyapunov",
        output=indefinite,
        inputs={"e": 2, **LEARNED},
        outputs={"V": 1},
        parameters=GAIN | truth,
        shapes={"theta": (2, "N")},
    )


FLOW = {"flow_x": 2}
ARRAYS = {"gain": 0.5, "K": np.array([1.0, 2.0]), "z": np.array([0.1, 0.2])}
EACH = {"shapes": {"gains": "N"}}
PRIVATE = {"states": {"x": 2, **LEARNED}, "output": behind_x, "outputs": LEARNED}
MORE = {**LEARNED, "s": 1}
RIGHT = {  # name -> (law, whether for every N too)
    "the paper's": (lambda: law(shipped, GAIN), True),
    "its gain called rate": (lambda: law(called_rate, {"rate": 0.5}), True),
    "its gain called gamma": (lambda: law(called_gamma, {"gamma": 0.5}), True),
    "times sin^2 + cos^2": (lambda: law(times_one, GAIN), True),
    "clip(e) + (e - clip(e))": (lambda: law(clipped_and_back, GAIN), True),
    "three gains": (lambda: law(three_gains, {"gains": [0.5, 0.2, 0.7]}), True),
    "a gain each": (lambda: law(a_gain_each, {"gains": [0.5, 2.0]}, **EACH), True),
    "x - z and exp(c)": (lambda: law(x_less_z, two(0.3), {"x": 2}), True),
    "composite": (lambda: law(composite, two(0.5), FLOW), False),
    "a leak of 0": (lambda: law(leak, two(0.0)), True),
    "as many gains as functions": (lambda: law(by_shape, {"gains": [0.5, 0.5]}, **EACH), False),
    "wrong from N = 5 on": (lambda: law(wrong_fifth, GAIN), False),
    "a small gain": (lambda: law(shipped, {"gain": 1e-8}), True),
}
BOUNDED = {
    "leak": lambda: law(leak, two(0.1)),
    "leak of alpha": lambda: law(leak_of_alpha, two(0.1)),
}
REFUTED = {
    "gain -0.5": lambda: law(shipped, {"gain": -0.5}),
    "every sign flipped": lambda: law(flipped, GAIN),
    "a leak of -0.1": lambda: law(leak, two(-0.1)),
    "composite, c = -0.5": lambda: law(composite, two(-0.5), FLOW),
    "wrong from N = 5 on, N = 6": lambda: law(wrong_fifth, GAIN, n=6),
}
NOT_PROVED = {  # wrong, or right but not known to be
    "parameters called K and z": lambda: law(named_like_signals, ARRAYS),
    "two tables": lambda: law(two_tables, ARRAYS),
    "one opaque helper": lambda: law(two_hidden, ARRAYS),
    "a private state called x": lambda: law(own_x, GAIN, **PRIVATE),
    "tanh(e)": lambda: law(tanh_of_e, GAIN),
    "z z/z": lambda: law(without_value, GAIN),
    "pulled to a private state": lambda: law(pulled_to_a_runaway, GAIN, states=MORE),
    "pulled to the time": lambda: law(pulled_to_time, GAIN),
    "log(exp(e))": lambda: law(too_large, GAIN),
    "|e| pulls alpha alone": lambda: law(e_leak_of_alpha, two(0.1)),
    "a leak that fades": lambda: law(leak_that_fades, two(0.1)),
    "a leak of any sign": lambda: law(leak_of_any_sign, two(0.1)),
    "half a projection": lambda: law(half_a_projection, two(2.0)),
    "(e + 1e16) - 1e16": lambda: law(rounded_away, two(1e16)),
    "(e + 1e16) - 1e16, a small gain": lambda: law(rounded_away, two(1e16, 1e-9)),
    "(e + 1e16) - 1e16, a tiny gain": lambda: law(rounded_away, two(1e16, 1e-15)),
    "p.gain == 0.5": lambda: law(equal_gain, GAIN),
    "sign(e) == 1": lambda: law(equal_sign, GAIN),
}
NOT_REFUTED = {  # right, or right with another V
    "projection": lambda: law(projection, two(2.0)),
    "tanh(e)": lambda: law(tanh_of_e, GAIN),
    "e + e^3": lambda: law(e_and_its_cube, GAIN),
    "a memory": lambda: law(memory, two(0.3), FLOW, states={**LEARNED, "M": (2, 2)}),
}
TOO_MUCH = {  # -> what is said
    "a gain divided by zero": (
        lambda: law(divided, two(0.0)),
        "have no value .own.update divides by 0",
    ),
    "a power of 40": (lambda: law(to_the_fortieth, GAIN), "V' has more than 20000 terms"),
    "choices of choices": (lambda: law(without_end, GAIN), "own.update has more than 5000"),
    "one z": (lambda: law(of_other_ports, GAIN, {"zc": 3, "z": 1}), "'z' has 2 signals"),
    "no name": (lambda: Block("", update=shipped, states=MORE), "must not be empty"),
    "a port with a dot": (lambda: law(shipped, GAIN, {"a.b": 1}), "'a.b' of a block"),
}
