"""Systems of which a V is judged, and the functions V."""

import control
import numpy as np

import clpt_control as clpt


def system(rates, inputs=(), params=None, **named):
    """A system of python-control: what `rates` takes are its states, t, inputs and parameters."""
    params, inputs = params or {}, list(inputs)
    taken = rates.__code__.co_varnames[: rates.__code__.co_argcount]
    states = [name for name in taken if name not in ("t", *inputs, *params)]

    def update(t, x, u, p):
        known = {"t": t, **dict(zip(states, x, strict=True)), **dict(zip(inputs, u, strict=True))}
        return np.array(rates(*(known[name] if name in known else p[name] for name in taken)))

    given = {"inputs": inputs or 0, "states": states, "params": params, "name": "plant"}
    return control.nlsys(update, **given | named)


# --- model reference adaptive control of a first-order plant, in four blocks ---------------------

PLANT = system(lambda y, u, a, b: [a * y + b * u], "u", {"a": 1.0, "b": 3.0}, outputs="y")
MODEL = system(
    lambda ym, r, am, bm: [-am * ym + bm * r],
    "r",
    {"am": 4.0, "bm": 4.0},
    outputs="ym",
    name="model",
)
SIGNALS = {"inputs": ["r", "y", "kr", "ky"], "outputs": "u"}
CONTROLLER = control.nlsys(
    None, lambda t, x, u, p: u[2] * u[0] - u[3] * u[1], name="controller", **SIGNALS
)


def mrac(sign=1.0):
    def rates(kr, ky, r, y, ym, gamma):
        e = sign * gamma * (y - ym)
        return [-e * r, e * y]

    gains = ["kr", "ky"]
    law = system(rates, ["r", "y", "ym"], {"gamma": 2.0}, outputs=gains, name="law")
    return clpt.connect([PLANT, MODEL, CONTROLLER, law], external="r")


def textbook(s):
    apart = (s.kr - s.bm / s.b) ** 2 + (s.ky - (s.am + s.a) / s.b) ** 2
    return (s.y - s.ym) ** 2 / 2 + s.b * apart / (2 * s.gamma)


# --- adaptive backstepping: x1' = x2 + theta x1^2, x2' = u ----------------------------------------


def backstepping(missing=False, c=2.0):
    def rates(x1, x2, h, c, theta, gamma):
        phi = x1**2
        z2 = x2 + c * x1 + h * phi
        slope = c + 2 * h * x1  # of -alpha in x1
        tuned = gamma * (x1 * phi + z2 * slope * phi)
        push = -(0.0 if missing else x1) - c * z2 - slope * (x2 + h * phi) - tuned * phi
        return [x2 + theta * phi, push, tuned]

    return system(rates, params={"c": c, "theta": 1.5, "gamma": 3.0})


def stepped(s):
    z2 = s.x2 + s.c * s.x1 + s.h * s.x1**2
    return s.x1**2 / 2 + z2**2 / 2 + (s.theta - s.h) ** 2 / (2 * s.gamma)


# --- a Luenberger observer ------------------------------------------------------------------------

A, C, L = np.array([[0.0, 1.0], [-2.0, -1.0]]), np.array([[1.0, 0.0]]), np.array([[3.0], [1.0]])
P = control.lyap((A - L @ C).T, np.eye(2))


def observer():
    plant = control.ss(A, [[0], [1]], np.eye(2), 0, inputs="u", outputs=["x1", "x2"], name="plant")
    both = np.hstack([[[0.0], [1.0]], L, [[0], [0]]])
    signals = {"inputs": ["u", "x1", "x2"], "outputs": ["z1", "z2"]}
    watch = control.ss(A - L @ C, both, np.eye(2), 0, name="watch", **signals)
    return clpt.connect([plant, watch], external="u")


def of_the_error(s):
    e = np.array([s.x1 - s.z1, s.x2 - s.z2])
    return P[0, 0] * e[0] ** 2 + 2 * P[0, 1] * e[0] * e[1] + P[1, 1] * e[1] ** 2


# --- mechanics -----------------------------------------------------------------------------------


def pendulum():
    return system(
        lambda theta, omega, g: [omega, -g * np.sin(theta) - 0.1 * omega], params={"g": 9.8}
    )


def energy(s):
    return s.omega**2 / 2 + s.g * (1 - np.cos(s.theta))


def whole_times(p, t0, t1):
    """Breakpoints at whole times."""
    return np.arange(np.floor(t0) + 1, np.floor(t1) + 1)


TICKS = {"parameters": {"interval": -1.0}, "breakpoints": whole_times}


def memory(factor, beside=1.0):
    return clpt.Block(
        "memory",
        update=lambda t, x, u, p: {"m": -x.m, "n": -x.n},
        jump=lambda t, x, u, p: {"m": factor * x.m, "n": beside * x.n},
        states={"m": 1, "n": 1},
        **TICKS,
    )


def jumping(jump):
    """A memory that fades, and jumps to what is made of it."""
    return clpt.Block(
        "memory",
        update=lambda t, x, u, p: {"m": -x.m},
        jump=lambda t, x, u, p: {"m": jump(t, x, p)},
        states={"m": 1},
        **TICKS,
    )


def counting(rate):
    """A gain that depends on which interval between breakpoints it is."""
    return clpt.Block(
        "counting",
        update=lambda t, x, u, p: {"x": rate(p.interval) * x.x},
        states={"x": 1},
        **TICKS,
    )


def half(s):
    return s.x**2 / 2


def halves(s):
    return (s.x**2 + s.y**2) / 2


def turned(s):
    return s.w**2 / 2 + 1 - np.cos(s.th)


def sourced(source, rates=lambda x, u: {"x": -x.x, "y": -x.y + u.w}):
    """A plant that a source of time drives."""
    made = clpt.Block(
        "source", output=lambda t, x, u, p: {"w": source(t)}, outputs={"w": 1}, opaque=True
    )
    plant = clpt.Block(
        "plant", update=lambda t, x, u, p: rates(x, u), states={"x": 1, "y": 1}, inputs={"w": 1}
    )
    return clpt.connect([made, plant])


def spinning(x, y, z):
    """Euler's equations of a body that turns, x, y, z about its axes, J = 1, 2, 3."""
    return [-y * z - 0.2 * x, (2 * z * x - 0.2 * y) / 2, (-x * y - 0.2 * z) / 3]


def rubbed(x, y, sign, least=1.0):
    """Return rates along the slopes of exp(x) - x - 1 + 1.3 log(cosh(y)), and across them."""
    a, b = np.exp(x) - 1, 1.3 * np.tanh(y)
    return [
        -(least + np.cos(y)) * a + 0.7 * np.sin(y) * b,
        -abs(x) * b - 0.7 * sign * np.sin(y) * a,
    ]


def shaft(a, b, v, w, back):
    """Return the rates of two pendulums on a shaft that springs back by the sine of its twist."""
    twist = 0.5 * np.sin(a - b)
    return [v, w, -np.sin(a) - twist - 0.2 * v, -np.sin(b) + back * twist - 0.2 * w]


def of_the_shaft(s):
    """Return the energy of both pendulums and of the twist."""
    return (s.v**2 + s.w**2) / 2 + 2.5 - np.cos(s.a) - np.cos(s.b) - 0.5 * np.cos(s.a - s.b)


def chain(link, v, w, q):
    """Return the rates of three capacitors, or masses, in a row, of which the last leaks."""
    return [-link(v - w), link(v - w) - link(w - q), link(w - q) - q]


def arm(q1, q2, v1, v2):
    """Two links of mass and length 1, springs and friction in the joints, without gravity."""
    c, s = np.cos(q2), np.sin(q2)
    first = -2 * q1 - v1 + s * (2 * v1 * v2 + v2**2)
    second = -2 * q2 - v2 - s * v1**2
    M11, M12 = 3 + 2 * c, 1 + c
    det = M11 - M12**2
    return [v1, v2, (first - M12 * second) / det, (M11 * second - M12 * first) / det]


def of_the_arm(s):
    c = np.cos(s.q2)
    moving = (3 + 2 * c) * s.v1**2 + 2 * (1 + c) * s.v1 * s.v2 + s.v2**2
    return moving / 2 + s.q1**2 + s.q2**2
