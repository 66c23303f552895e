"""Adaptive laws as users write them: right ones, wrong ones, and odd ones.

u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2], section III.
"""

import numpy as np

from clpt_control.blocks.clpe import clpe
from clpt_control.equations import Block, lookup

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


def changed(change, parameters=GAIN, more=None, n=N, **ports):
    """Make the paper's law with its rates changed by `change(t, x, u, p, rates)`."""

    def update(t, x, u, p):
        return change(t, x, u, p, filled(u, getattr(p, "gain", 1.0), u.e))

    return lambda: law(update, parameters, more, n, **ports)


def beside(rates, sizes, parameters=GAIN, **ports):
    """Make the paper's law with states of its own beside what is learned."""
    states = LEARNED | sizes
    return changed(lambda t, x, u, p, r: r | rates(x, u), parameters, states=states, **ports)


def driven(error, parameters=GAIN, **ports):
    """Make the paper's law with another error than e."""
    return changed(
        lambda t, x, u, p, r: filled(u, getattr(p, "gain", 1.0), error(t, x, u, p)),
        parameters,
        **ports,
    )


def leak(share, ports=LEARNED, parameters=GAIN):
    """Make the paper's law with a leak of what is learned."""
    return changed(lambda t, x, u, p, r: leaked(x, r, share(t, x, u, p), ports), parameters)


def pushed(push, port="alpha", parameters=GAIN, **ports):
    """Make the paper's law with something beside the rate of a port, or of one element of it."""

    def change(t, x, u, p, r):
        r[port] = r[port] + push(x, u, p)
        return r

    return changed(change, parameters, **ports)


def first(value):
    """An array of the shape of alpha with a value at its first place."""
    return np.array([[1.0, 0.0], [0.0, 0.0]]) * value


def off(u, p):
    """The squares of all errors of what is learned."""
    flow = np.sum((p.theta + u.alpha) ** 2)
    return flow + np.sum((u.K - p.KD) ** 2) + np.sum((u.Gamma - p.GammaD) ** 2)


def V_of(level, inputs=LEARNED, **parameters):
    """Make V of the truth, whatever vehicle and flow there are, from `level(t, u, p)`."""
    return lambda truth: Block(
        "level",
        output=lambda t, x, u, p: {"V": level(t, u, p)},
        inputs={"e": 2, **inputs},
        outputs={"V": 1},
        parameters={**GAIN, **truth._asdict(), **parameters},
        shapes={"theta": (2, "N")},
    )


def leaked(x, rates, share, ports=("alpha",)):
    """Take a share of what is learned from the rates."""
    return rates | {port: rates[port] - share * getattr(x, port) for port in ports}


def projection(t, x, u, p):
    """alpha kept within a ball of radius c on each axis, section III."""
    rates = filled(u, p.gain, u.e)
    size = np.sum(x.alpha**2, axis=1)
    outward = np.maximum(np.sum(rates["alpha"] * x.alpha, axis=1), 0.0)
    off = np.where(size > p.c**2, outward / np.maximum(size, 1e-9), 0.0)
    return leaked(x, rates, off[:, None])


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


def memory(t, x, u, p):
    """With a remembered prediction error, never negative, section III."""
    rates, phi = filled(u, p.gain, u.e), u.phi_x[0]
    rates["alpha"][:, 0] -= p.c * (x.M[0] * x.alpha[:, 0] + x.M[1])
    return rates | {"M": [phi**2 - x.M[0], phi * u.flow_x - x.M[1]]}


def without_end(t, x, u, p):
    """A choice of choices of choices, section III."""
    s = u.e[0]
    for j in range(40):
        s = np.where(s > j, s * u.phi_x[0], s + x.alpha[0, 0])
    return filled(u, p.gain, u.e + s)


def of_other_ports(t, x, u, p):
    """A law of one z and three zc."""
    alpha = -p.gain * np.outer(u.e, u.phi_x)
    return {"alpha": alpha, "K": -p.gain * u.z[0] * u.e, "Gamma": p.gain * u.zc[:2] * u.e}


FLOW = {"flow_x": 2}
ARRAYS = {"gain": 0.5, "K": np.array([1.0, 2.0]), "z": np.array([0.1, 0.2])}
EACH = {"shapes": {"gains": "N"}}
PRIVATE = {"states": {"x": 2, **LEARNED}, "outputs": LEARNED}
MORE = {**LEARNED, "s": 1}


def each(t, x, u, p, r):
    """A gain for each function, K held apart."""
    alpha = -p.gains * np.outer(u.e, u.phi_x)
    return {"alpha": alpha, "K": -np.array([1.0, 2.0]) * u.z * u.e, "Gamma": 0.3 * u.zc * u.e}


def each_axis(t, x, u, p, r):
    """A gain for each function, and one for K and Gamma of each axis."""
    alpha = -p.gains * np.outer(u.e, u.phi_x)
    return {"alpha": alpha, "K": -p.axes * u.z * u.e, "Gamma": p.axes * u.zc * u.e}


def fifth(t, x, u, p, r):
    """The fifth function is learned backwards."""
    return r | {"alpha": r["alpha"] * np.where(np.arange(len(u.phi_x)) == 4, -1.0, 1.0)}


def like_signals(t, x, u, p, r):
    """Leaks towards parameters K and z, not signals."""
    return r | {"K": r["K"] - p.gain * (x.K - p.K), "Gamma": r["Gamma"] + 0.3 * (u.z - p.z)}


def two_tables(x, u, p):
    j = np.clip(np.floor(u.e[0]), 0.0, 1.0)
    return lookup(p.K, j) - lookup(p.z, j)


paper = driven(lambda t, x, u, p: u.e)
turned = driven(lambda t, x, u, p: -u.e)
constant = leak(lambda t, x, u, p: p.gain * p.c, parameters=two(0.1))
composite = pushed(
    lambda x, u, p: -p.c * np.outer(u.flow_x + x.alpha @ u.phi_x, u.phi_x),
    parameters=two(0.1),
    more=FLOW,
)
divided_by_itself = changed(lambda t, x, u, p, r: r | {"K": -p.gain * (u.z * u.z / u.z) * u.e})
rounded_away = driven(lambda t, x, u, p: (u.e + p.c) - p.c, two(1e16))


def with_numbers(make, **parameters):
    """Make the same law with other numbers."""
    return lambda: changed_numbers(make(), parameters)


def changed_numbers(block, parameters):
    block.parameters = block.parameters._replace(**parameters)
    return block


RIGHT = {  # name -> (law, whether for every N too)
    "the paper's": (paper, True),
    "its gain called gamma": (driven(lambda t, x, u, p: p.gamma * u.e, {"gamma": 0.5}), True),
    "times sin^2 + cos^2": (
        driven(lambda t, x, u, p: (np.sin(u.e[0]) ** 2 + np.cos(u.e[0]) ** 2) * u.e),
        True,
    ),
    "clip(e) + (e - clip(e))": (
        driven(lambda t, x, u, p: np.clip(u.e, -1, 1) + (u.e - np.clip(u.e, -1, 1))),
        True,
    ),
    "a gain each": (changed(each, {"gains": [0.5, 2.0]}, **EACH), True),
    "one list of gains for functions and for axes": (
        changed(each_axis, {"gains": [1.0, 2.0], "axes": [1.0, 2.0]}, **EACH),
        True,
    ),
    "x - z and exp(c)": (
        driven(lambda t, x, u, p: np.exp(p.c) * (u.x - u.z), {"c": 0.3}, more={"x": 2}),
        True,
    ),
    "composite": (with_numbers(composite, c=0.5), False),
    "a leak of 0": (with_numbers(constant, c=0.0), True),
    "as many gains as functions": (
        changed(
            lambda t, x, u, p, r: leaked(x, filled(u, p.gains[0], u.e), len(p.gains) - 2.0),
            {"gains": [0.5, 0.5]},
            **EACH,
        ),
        False,
    ),
    "wrong from N = 5 on": (changed(fifth), False),
    "a small gain": (with_numbers(paper, gain=1e-8), True),
}
BOUNDED = {
    "leak": constant,
    "leak of alpha": leak(lambda t, x, u, p: p.gain * p.c, ("alpha",), two(0.1)),
}
REFUTED = {
    "gain -0.5": with_numbers(paper, gain=-0.5),
    "every sign flipped": turned,
    "a leak of -0.1": with_numbers(constant, c=-0.1),
    "composite, c = -0.5": with_numbers(composite, c=-0.5),
    "wrong from N = 5 on, N = 6": changed(fifth, n=6),
}
NOT_PROVED = {  # wrong, or right but not known to be
    "parameters called K and z": changed(like_signals, ARRAYS),
    "two tables": pushed(two_tables, "K", ARRAYS),
    "a private state called x": changed(
        lambda t, x, u, p, r: r | {"x": -x.x, "alpha": r["alpha"] - 0.1 * (x.x - u.z)[:, None]},
        output=lambda t, x, u, p: {port: getattr(x, port) for port in LEARNED},
        **PRIVATE,
    ),
    "tanh(e)": driven(lambda t, x, u, p: np.tanh(u.e)),
    "z z/z": divided_by_itself,
    "pulled to a private state": changed(
        lambda t, x, u, p, r: (
            r | {"alpha": r["alpha"] - first(p.gain * (x.alpha[0, 0] - x.s[0])), "s": x.s}
        ),
        states=MORE,
    ),
    "pulled to the time": changed(
        lambda t, x, u, p, r: r | {"alpha": r["alpha"] - first(p.gain * (x.alpha[0, 0] - t))}
    ),
    "log(exp(e))": driven(lambda t, x, u, p: np.log(np.exp(u.e))),
    "|e| pulls alpha alone": leak(
        lambda t, x, u, p: p.gain * p.c * np.hypot(u.e[0], u.e[1]), ("alpha",), two(0.1)
    ),
    "a leak that fades": leak(
        lambda t, x, u, p: p.gain * p.c * np.clip(2.0 - np.linalg.norm(x.alpha), 0.0, 1.0),
        ("alpha",),
        two(0.1),
    ),
    "a leak of any sign": leak(
        lambda t, x, u, p: p.gain * p.c * np.clip(np.linalg.norm(x.alpha) - 1.0, -1.0, 1.0),
        ("alpha",),
        two(0.1),
    ),
    "half a projection": lambda: law(half_a_projection, two(2.0)),
    "(e + 1e16) - 1e16": rounded_away,
    "(e + 1e16) - 1e16, a tiny gain": with_numbers(rounded_away, gain=1e-15),
    "p.gain == 0.5": driven(lambda t, x, u, p: np.where(p.gain == 0.5, -1.0, 1.0) * u.e),
    "sign(e) == 1": driven(lambda t, x, u, p: np.where(np.sign(u.e) == 1.0, 0.0, 1.0) * u.e),
}
NOT_REFUTED = {  # right, or right with another V
    "projection": lambda: law(projection, two(2.0)),
    "tanh(e)": NOT_PROVED["tanh(e)"],
    "e + e^3": driven(lambda t, x, u, p: u.e + u.e**3),
    "a leak that grows": leak(lambda t, x, u, p: 0.1 * np.clip(np.linalg.norm(x.alpha) - 1, 0, 1)),
    "a memory": lambda: law(memory, two(0.3), FLOW, states={**LEARNED, "M": (2, 2)}),
}
TOO_MUCH = {  # -> what is said
    "a gain divided by zero": (
        driven(lambda t, x, u, p: u.e / p.c, two(0.0)),
        "have no value .own.update divides by 0",
    ),
    "a power of 40": (
        pushed(lambda x, u, p: first((x[0] + x[1] + u[0] + u[1] + u[2]) ** 40)),
        "V' has more than 20000 terms",
    ),
    "choices of choices": (lambda: law(without_end, GAIN), "own.update has more than 5000"),
    "a throw": (
        driven(lambda t, x, u, p: u.e * np.random.default_rng().random()),
        "^own.update: .* draws by chance",
    ),
    "no law": (clpe, r"makes alpha\[2N\], K\[2\] and Gamma\[2\]"),
    "one z": (lambda: law(of_other_ports, GAIN, {"zc": 3, "z": 1}), "'zc?' has 2 signals"),
    "no name": (lambda: Block("", update=memory, states=MORE), "must not be empty"),
    "a port with a dot": (driven(lambda t, x, u, p: u.e, more={"a.b": 1}), "'a.b' of a block"),
}
