"""Systems with a V each: right ones, and wrong ones of many kinds."""

import control
import numpy as np
import sympy

import clpt_control as clpt

t, x = sympy.symbols("t x", real=True)


def system(rates, states, params=None, inputs=()):
    """A system of python-control from ``rates(t, x, u, p)``, x and u by name."""

    def update(t, x, u, params):
        return rates(
            t, dict(zip(states, x, strict=True)), dict(zip(inputs, u, strict=True)), params
        )

    return control.nlsys(
        update, inputs=list(inputs) or 0, states=list(states), params=params or {}, name="plant"
    )


def of(*rates, params=None, inputs=()):
    """A system whose states are x, y, z: rates of (x, y, z), in time t, with d as input."""

    def update(t, x, u, params):
        own = dict(zip("xyz", x, strict=False)) | {"t": t} | dict(zip(inputs, u, strict=True))
        return [rate(own) for rate in rates]

    return control.nlsys(
        update, inputs=list(inputs) or 0, states=list("xyz"[: len(rates)]), name="plant"
    )


# --- model reference adaptive control of a first-order plant, in four blocks ---------------------

PLANT = control.nlsys(
    lambda t, x, u, p: p["a"] * x[0] + p["b"] * u[0],
    inputs="u",
    outputs="y",
    states="y",
    params={"a": 1.0, "b": 3.0},
    name="plant",
)
MODEL = control.nlsys(
    lambda t, x, u, p: -p["am"] * x[0] + p["bm"] * u[0],
    inputs="r",
    outputs="ym",
    states="ym",
    params={"am": 4.0, "bm": 4.0},
    name="model",
)
CONTROLLER = control.nlsys(
    None,
    lambda t, x, u, p: u[2] * u[0] - u[3] * u[1],
    inputs=["r", "y", "kr", "ky"],
    outputs="u",
    name="controller",
)


def mrac(reference=-1.0, feedback=1.0, leak=0.0):
    law = control.nlsys(
        lambda t, x, u, p: [
            reference * p["gamma"] * u[0] * (u[1] - u[2]) - leak * x[0],
            feedback * p["gamma"] * u[1] * (u[1] - u[2]) - leak * x[1],
        ],
        inputs=["r", "y", "ym"],
        states=["kr", "ky"],
        outputs=["kr", "ky"],
        params={"gamma": 2.0},
        name="law",
    )
    return clpt.connect([PLANT, MODEL, CONTROLLER, law], external="r")


def textbook(s):
    apart = (s.kr - s.bm / s.b) ** 2 + (s.ky - (s.am + s.a) / s.b) ** 2
    return (s.y - s.ym) ** 2 / 2 + s.b * apart / (2 * s.gamma)


# --- adaptive backstepping: x1' = x2 + theta x1^2, x2' = u ----------------------------------------


def backstepping(sign=1.0, missing=False, c=2.0):
    def rates(t, x, u, p):
        x1, x2, h, c, theta = x["x1"], x["x2"], x["h"], p["c"], p["theta"]
        phi = x1**2
        z2 = x2 + c * x1 + h * phi
        slope = c + 2 * h * x1  # of -alpha in x1
        tuned = p["gamma"] * (x1 * phi + z2 * slope * phi) * sign
        push = -(0.0 if missing else x1) - c * z2 - slope * (x2 + h * phi) - tuned * phi
        return [x2 + theta * phi, push, tuned]

    params = {"c": c, "theta": 1.5, "gamma": 3.0}
    return system(rates, ["x1", "x2", "h"], params)


def stepped(s):
    z2 = s.x2 + s.c * s.x1 + s.h * s.x1**2
    return s.x1**2 / 2 + z2**2 / 2 + (s.theta - s.h) ** 2 / (2 * s.gamma)


# --- a Luenberger observer ------------------------------------------------------------------------

A, C, L = np.array([[0.0, 1.0], [-2.0, -1.0]]), np.array([[1.0, 0.0]]), np.array([[3.0], [1.0]])
P = control.lyap((A - L @ C).T, np.eye(2))


def observer(gain=L):
    plant = control.ss(A, [[0], [1]], np.eye(2), 0, inputs="u", outputs=["x1", "x2"], name="plant")
    both = np.hstack([[[0.0], [1.0]], gain, [[0], [0]]])
    watch = control.ss(
        A - gain @ C,
        both,
        np.eye(2),
        0,
        inputs=["u", "x1", "x2"],
        outputs=["z1", "z2"],
        name="watch",
    )
    return clpt.connect([plant, watch], external="u")


def of_the_error(s):
    e = np.array([s.x1 - s.z1, s.x2 - s.z2])
    return P[0, 0] * e[0] ** 2 + 2 * P[0, 1] * e[0] * e[1] + P[1, 1] * e[1] ** 2


# --- mechanics -----------------------------------------------------------------------------------


def pendulum(damping=0.1):
    return system(
        lambda t, x, u, p: [x["omega"], -p["g"] * np.sin(x["theta"]) - damping * x["omega"]],
        ["theta", "omega"],
        {"g": 9.8},
    )


def energy(s):
    return s.omega**2 / 2 + s.g * (1 - np.cos(s.theta))


def spring(damping=0.5, hard=1.0):
    return system(
        lambda t, x, u, p: [x["v"], -p["k"] * x["q"] - hard * x["q"] ** 3 - damping * x["v"]],
        ["q", "v"],
        {"k": 2.0},
    )


def stored(s):
    return s.v**2 / 2 + s.k * s.q**2 / 2 + s.q**4 / 4


def van_der_pol(damped=1.0):
    return system(
        lambda t, x, u, p: [-x["y"], x["x"] - damped * p["eps"] * (1 - x["x"] ** 2) * x["y"]],
        ["x", "y"],
        {"eps": 1.0},
    )


def memory(factor, beside=1.0):
    return clpt.Block(
        "memory",
        update=lambda t, x, u, p: {"m": -x.m, "n": -x.n},
        jump=lambda t, x, u, p: {"m": factor * x.m, "n": beside * x.n},
        states={"m": 1, "n": 1},
        parameters={"interval": -1.0},
        breakpoints=lambda p, t0, t1: np.arange(np.floor(t0) + 1, np.floor(t1) + 1),
    )


def counting(rate):
    """A gain that depends on which interval between breakpoints it is."""
    return clpt.Block(
        "counting",
        update=lambda t, x, u, p: {"x": rate(p.interval) * x.x},
        states={"x": 1},
        parameters={"interval": -1.0},
        breakpoints=lambda p, t0, t1: np.arange(np.floor(t0) + 1, np.floor(t1) + 1),
    )


def half(s):
    return s.x**2 / 2


def halves(s):
    return (s.x**2 + s.y**2) / 2


def turning(*rates):
    """A pendulum that turns by these rates of (th, w), and a state y beside it."""

    def update(t, x, u, p):
        return [rate(*x) for rate in rates]

    return control.nlsys(update, inputs=0, states=["th", "w", "y"][: len(rates)], name="plant")


def turned(s):
    return s.w**2 / 2 + 1 - np.cos(s.th)


def sourced(source):
    """A state that a source of time drives."""
    made = clpt.Block(
        "source", output=lambda t, x, u, p: {"w": source(t)}, outputs={"w": 1}, opaque=True
    )
    plant = clpt.Block(
        "plant",
        update=lambda t, x, u, p: {"x": -x.x, "y": -x.y + u.w},
        states={"x": 1, "y": 1},
        inputs={"w": 1},
    )
    return clpt.connect([made, plant])


def spinning(damping=0.2):
    """Euler's equations of a body that turns, x, y, z about its axes, J = 1, 2, 3."""
    return of(
        lambda o: (2 - 3) * o["y"] * o["z"] - damping * o["x"],
        lambda o: ((3 - 1) * o["z"] * o["x"] - damping * o["y"]) / 2,
        lambda o: ((1 - 2) * o["x"] * o["y"] - damping * o["z"]) / 3,
    )


def high_gain(growth=2.0):
    return system(
        lambda t, x, u, p: [p["a"] * x["x"] - x["k"] * x["x"], x["x"] ** 2],
        ["x", "k"],
        {"a": growth},
    )


RIGHT = {  # name -> system, V, more
    "MRAC": (mrac(), textbook, {}),
    "MRAC, V' claimed": (mrac(), textbook, {"claim": lambda s: -s.am * (s.y - s.ym) ** 2}),
    "MRAC, numbers in V": (
        mrac(),
        lambda s: (s.y - s.ym) ** 2 / 2 + 0.75 * ((s.kr - 4 / 3) ** 2 + (s.ky - 5 / 3) ** 2),
        {},
    ),
    "backstepping": (backstepping(), stepped, {}),
    "backstepping, a term left to the gain": (backstepping(missing=True), stepped, {}),
    "observer": (observer(), of_the_error, {}),
    "pendulum": (pendulum(), energy, {}),
    "pendulum without friction": (pendulum(0.0), energy, {}),
    "hardening spring": (spring(), stored, {}),
    "a fourth power": (of(lambda o: -(o["x"] ** 3)), lambda s: s.x**4 / 4, {}),
    "tanh": (of(lambda o: -np.tanh(o["x"])), half, {}),
    "log cosh": (of(lambda o: -np.tanh(o["x"])), lambda s: np.log(np.cosh(s.x)), {}),
    "cosh": (of(lambda o: -np.sinh(o["x"])), lambda s: np.cosh(s.x) - 1, {}),
    "sliding": (of(lambda o: -np.sign(o["x"])), half, {}),
    "a turn and a pull": (
        of(lambda o: o["y"] - o["x"], lambda o: -o["x"] - o["y"] ** 3),
        halves,
        {},
    ),
    "gain of time": (of(lambda o: -(2 + np.sin(o["t"])) * o["x"]), half, {}),
    "gain that grows": (of(lambda o: -o["t"] * o["x"]), half, {}),
    "a bounded pull": (of(lambda o: -o["x"] / (1 + o["x"] ** 2)), half, {}),
    "a spinning body": (
        spinning(),
        lambda s: (s.x**2 + 2 * s.y**2 + 3 * s.z**2) / 2,
        {},
    ),
    "a gain that finds itself": (
        high_gain(),
        lambda s: s.x**2 / 2 + (s.k - 3.0) ** 2 / 2,
        {},
    ),
    "a cross term": (
        of(lambda o: o["y"], lambda o: -o["x"] - o["y"]),
        lambda s: 1.5 * s.x**2 + s.x * s.y + s.y**2,
        {},
    ),
    "a rest elsewhere": (of(lambda o: 3.0 - o["x"]), lambda s: (s.x - 3) ** 2, {"at": {"x": 3.0}}),
    "a jump that halves": (memory(0.5), lambda s: s.m**2 + s.n**2, {}),
    "a jump that turns": (memory(-1.0), lambda s: s.m**2 + s.n**2, {}),
    "two wells": (
        of(lambda o: o["y"], lambda o: o["x"] - o["x"] ** 3 - o["y"]),
        lambda s: s.y**2 / 2 + (s.x**2 - 1) ** 2 / 4,
        {},
    ),
    "a pull that is limited": (of(lambda o: -np.clip(o["x"], -1, 1)), half, {}),
    "a pull of two strengths": (
        of(lambda o: np.where(o["x"] > 0, -o["x"], -2 * o["x"])),
        half,
        {},
    ),
    "no force": (of(lambda o: o["y"], lambda o: -o["x"]), halves, {}),
    "a pull with a dent": (
        of(lambda o: -o["x"] + o["x"] * np.exp(-((o["x"] - 2) ** 2))),
        half,
        {},
    ),
    "a circle": (
        of(
            lambda o: o["x"] * (1 - o["x"] ** 2 - o["y"] ** 2) - o["y"],
            lambda o: o["y"] * (1 - o["x"] ** 2 - o["y"] ** 2) + o["x"],
        ),
        lambda s: (s.x**2 + s.y**2 - 1) ** 2,
        {},
    ),
    "a pendulum a turn further": (
        turning(lambda th, w: w, lambda th, w: -np.sin(th) - w),
        turned,
        {"at": {"th": 2 * np.pi}},
    ),
    "V with what fades": (of(lambda o: -o["x"]), (1 + sympy.exp(-t)) * x**2, {}),
    "V of what follows a wave": (
        of(lambda o: np.cos(o["t"]) + np.sin(o["t"]) - o["x"]),
        (x - sympy.sin(t)) ** 2,
        {},
    ),
}
WRONG = {
    "MRAC, sign of both": (mrac(1.0, -1.0), textbook, {}),
    "MRAC, sign of one": (mrac(-1.0, -1.0), textbook, {}),
    "MRAC, gains swapped": (
        mrac(),
        lambda s: (
            (s.y - s.ym) ** 2 / 2
            + s.b * ((s.kr - (s.am + s.a) / s.b) ** 2 + (s.ky - s.bm / s.b) ** 2) / (2 * s.gamma)
        ),
        {},
    ),
    "MRAC, V forgets b": (
        mrac(),
        lambda s: (
            (s.y - s.ym) ** 2 / 2
            + ((s.kr - s.bm / s.b) ** 2 + (s.ky - (s.am + s.a) / s.b) ** 2) / (2 * s.gamma)
        ),
        {},
    ),
    "MRAC, a leak to zero": (mrac(leak=0.1), textbook, {}),
    "MRAC, claimed too much": (
        mrac(),
        textbook,
        {"claim": lambda s: -2 * s.am * (s.y - s.ym) ** 2},
    ),
    "backstepping, sign": (backstepping(-1.0), stepped, {}),
    "backstepping, a term forgotten": (backstepping(missing=True, c=0.3), stepped, {}),
    "observer, gain of another": (observer(-L), of_the_error, {}),
    "observer, x beside z": (
        observer(),
        lambda s: (s.x1 + s.z1) ** 2 + (s.x2 - s.z2) ** 2,
        {},
    ),
    "pendulum that is pushed": (pendulum(-0.1), energy, {}),
    "pendulum upright": (pendulum(), energy, {"at": {"theta": np.pi}}),
    "pendulum, sign of the potential": (
        pendulum(),
        lambda s: s.omega**2 / 2 - s.g * (1 - np.cos(s.theta)),
        {},
    ),
    "softening spring": (spring(hard=-1.0), stored, {}),
    "spring, V without the cubic": (spring(), lambda s: s.v**2 / 2 + s.k * s.q**2 / 2, {}),
    "van der Pol": (van_der_pol(-1.0), halves, {}),
    "van der Pol reversed, everywhere": (van_der_pol(), halves, {}),
    "V that is a saddle": (
        of(lambda o: -o["x"], lambda o: o["y"]),
        lambda s: s.x**2 - s.y**2,
        {},
    ),
    "V that falls without end": (of(lambda o: 1.0 + 0 * o["x"]), lambda s: -s.x, {}),
    "V of a third power": (of(lambda o: -(o["x"] ** 2)), lambda s: s.x**3, {}),
    "V of nothing": (of(lambda o: o["x"]), lambda s: 0 * s.x, {}),
    "V that jumps": (
        of(lambda o: -o["x"]),
        lambda s: np.where(s.x > 1, s.x, 2 * s.x) ** 2,
        {},
    ),
    "V of an angle": (
        of(lambda o: o["y"], lambda o: -o["x"]),
        lambda s: (np.arctan2(s.y, s.x) + 4) ** 2 + s.x**2 + s.y**2,
        {},
    ),
    "V that fades": (of(lambda o: o["x"] / 2), sympy.exp(-2 * t) * x**2, {}),
    "V that sinks with time": (of(lambda o: 0 * o["x"]), x**2 - t, {}),
    "V of what runs with time": (of(lambda o: 1 + 0 * o["x"]), (x - t) ** 2, {}),
    "V that is bounded": (of(lambda o: -o["x"]), lambda s: np.tanh(s.x**2), {}),
    "V that lets go far off": (
        of(
            lambda o: -6 * o["x"] / (1 + o["x"] ** 2) ** 2 + 2 * o["y"],
            lambda o: -2 * (o["x"] + o["y"]) / (1 + o["x"] ** 2) ** 2,
        ),
        lambda s: s.x**2 / (1 + s.x**2) + s.y**2,
        {},
    ),
    "V of the larger": (
        of(lambda o: o["y"] - 0.1 * o["x"], lambda o: -o["x"] - 0.1 * o["y"]),
        lambda s: np.maximum(np.abs(s.x), np.abs(s.y)),
        {},
    ),
    "V whose least is far away": (
        of(lambda o: 5e3 - o["x"]),
        lambda s: 1e3 * np.log(np.cosh(s.x / 1e3 - 5)) - 5e3,
        {},
    ),
    "an angle that ends": (
        turning(lambda th, w: w * (1 + th**2), lambda th, w: -np.sin(th) * (1 + th**2)),
        turned,
        {},
    ),
    "an angle that drives": (
        turning(lambda th, w, y: w, lambda th, w, y: -np.sin(th), lambda th, w, y: th - y),
        turned,
        {},
    ),
    "a source that drives": (sourced(lambda t: np.array([t**2])), half, {}),
    "a jump of what V misses": (memory(0.5, 3.0), lambda s: s.m**2, {}),
    "a jump by a little": (memory(1 + 1e-9), lambda s: s.m**2 + s.n**2, {}),
    "a jump that rises at no breakpoint": (
        clpt.Block(
            "memory",
            update=lambda t, x, u, p: {"m": -x.m},
            jump=lambda t, x, u, p: {"m": (1 + np.sin(np.pi * t) ** 2) * x.m},
            states={"m": 1},
            parameters={"interval": -1.0},
            breakpoints=lambda p, t0, t1: np.arange(np.floor(t0) + 1, np.floor(t1) + 1),
        ),
        lambda s: s.m**2,
        {},
    ),
    "two gains 1e-12 apart": (
        of(lambda o: 3.0 * o["y"], lambda o: -(3.0 + 1e-12) * o["x"]),
        halves,
        {},
    ),
    "a needle": (
        of(lambda o: -o["x"] + 2 * o["x"] * np.exp(-1e8 * (o["x"] - 1) ** 2)),
        half,
        {},
    ),
    "a force below all numbers": (
        of(lambda o: o["x"] * np.exp(-1000 - o["x"] ** 2)),
        half,
        {},
    ),
    "V that misses a state": (of(lambda o: -o["x"], lambda o: o["y"]), half, {}),
    "V that misses a state that ends": (
        of(lambda o: -o["x"], lambda o: 1 + o["y"] ** 2),
        half,
        {},
    ),
    "V of the sum alone": (
        of(lambda o: -o["x"] + o["y"] ** 3, lambda o: -o["y"] - o["y"] ** 3),
        lambda s: (s.x + s.y) ** 2,
        {},
    ),
    "a gain that turns": (of(lambda o: -np.cos(o["t"]) * o["x"]), half, {}),
    "a gain that turns a little": (of(lambda o: -(1 + 1.01 * np.sin(o["t"])) * o["x"]), half, {}),
    "a gain that turns at 5": (of(lambda o: -(5 - o["t"]) * o["x"]), half, {}),
    "a gain that turns at 900": (of(lambda o: -(900 - o["t"]) * o["x"]), half, {}),
    "a gain that turns at the fifth breakpoint": (counting(lambda k: k - 5), half, {}),
    "wrong in a small region": (
        of(lambda o: -o["x"] * ((o["x"] - 1) ** 2 - 1e-3)),
        half,
        {},
    ),
    "wrong in a smaller region": (
        of(lambda o: -o["x"] * ((o["x"] - 7) ** 2 - 1e-9)),
        half,
        {},
    ),
    "wrong in a strip": (
        of(lambda o: -o["x"] * ((o["y"] - 2) ** 2 - 0.01), lambda o: -o["y"]),
        halves,
        {},
    ),
    "a small bump": (
        of(lambda o: -o["x"] + 3 * np.exp(-50 * (o["x"] - 1) ** 2)),
        half,
        {},
    ),
    "no value at a point": (of(lambda o: -o["x"] / np.abs(o["x"] - 2)), half, {}),
    "no value at the rest": (of(lambda o: -1 / o["x"]), half, {}),
    "V without a value": (of(lambda o: -(o["x"] ** 3)), lambda s: s.x**2 + 1 / (s.x - 1) ** 2, {}),
    "V of a logarithm": (of(lambda o: -o["x"]), lambda s: np.log(s.x) ** 2, {}),
    "unstable": (of(lambda o: o["x"]), half, {}),
    "unstable, V' claimed as it is": (of(lambda o: o["x"]), half, {"claim": lambda s: s.x**2}),
    "almost stable": (of(lambda o: 1e-6 * o["x"]), half, {}),
    "an input that drives": (of(lambda o: o["x"] + o["d"], inputs=["d"]), half, {}),
    "a jump that doubles": (memory(2.0), lambda s: s.m**2, {}),
    "a spinning body, axes swapped": (
        spinning(),
        lambda s: (3 * s.x**2 + 2 * s.y**2 + s.z**2) / 2,
        {},
    ),
    "a gain too small": (high_gain(), lambda s: s.x**2 / 2 + (s.k - 1.0) ** 2 / 2, {}),
    "another rest": (of(lambda o: 3.0 - o["x"]), half, {"at": {"x": 3.0}}),
    "a weight too small": (
        of(lambda o: o["y"], lambda o: -o["x"] - o["y"]),
        lambda s: s.x**2 + s.x * s.y + 0.2 * s.y**2,
        {},
    ),
}
