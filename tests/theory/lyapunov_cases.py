"""Systems with a V each: right ones, and wrong ones of many kinds."""

from types import FunctionType

import control
import numpy as np
from lyapunov_systems import (
    TICKS,
    backstepping,
    chain,
    counting,
    energy,
    half,
    halves,
    jumping,
    memory,
    mrac,
    observer,
    of_the_error,
    of_the_shaft,
    pendulum,
    rubbed,
    shaft,
    sourced,
    spinning,
    stepped,
    system,
    textbook,
    turned,
)

import clpt_control as clpt
from clpt_control.equations import lookup


def table(rows):
    """name -> system, V, what else is given: of rates a system, else half the squares of states."""
    return {
        name: filled(*(row if isinstance(row, tuple) else (row,))) for name, row in rows.items()
    }


def filled(plant, V=None, *more):
    plant = system(plant) if isinstance(plant, FunctionType) else plant
    names = [label.partition("[")[0] for label in plant.state_labels]
    return plant, V or (lambda s: sum(getattr(s, name) ** 2 for name in names) / 2), *more


RIGHT = {
    "MRAC": (mrac(), textbook),
    "MRAC, numbers in V": (
        mrac(),
        lambda s: (s.y - s.ym) ** 2 / 2 + 0.75 * ((s.kr - 4 / 3) ** 2 + (s.ky - 5 / 3) ** 2),
    ),
    "backstepping": (backstepping(), stepped),
    "observer": (observer(), of_the_error),
    "pendulum": (pendulum(), energy),
    "tanh": lambda x: [-np.tanh(x)],
    "two pendulums on one shaft": (lambda a, b, v, w: shaft(a, b, v, w, 1), of_the_shaft),
    "a chain of diodes": lambda v, w, q: chain(lambda z: np.exp(40 * z) - 1, v, w, q),
    "a rate of which rounding is left": lambda x: [x * (-1.65 * np.maximum(x, -0.7) - 1.65 * 0.7)],
    "gain of a higher wave": lambda t, x: [-(2 + np.sin(3 * t)) * x],
    "V of time": (  # Khalil, Nonlinear Systems, 3rd ed., Example 4.20
        lambda t, x, y: [-x - np.exp(-2 * t) * y, x - y],
        lambda s: s.x**2 + (1 + np.exp(-2 * s.t)) * s.y**2,
    ),
    "gain that grows": lambda t, x: [-t * x],
    "a divisor of masses": (
        system(
            lambda q, v, m, M, c: [v, -(q + v) / (M * m - c**2)],
            params={"m": 1.0, "M": 2.0, "c": 0.5},
        ),
        lambda s: s.q**2 + (s.M * s.m - s.c**2) * s.v**2,
    ),
    "a power that a parameter gives": system(lambda x, n: [-(x**n)], params={"n": 3.0}),
    "a spinning body": (spinning, lambda s: (s.x**2 + 2 * s.y**2 + 3 * s.z**2) / 2),
    "a cross term": (lambda x, y: [y, -x - y], lambda s: 1.5 * s.x**2 + s.x * s.y + s.y**2),
    "a rest elsewhere": (lambda x: [3.0 - x], lambda s: (s.x - 3) ** 2, {"at": {"x": 3.0}}),
    "a jump that turns": memory(-1.0),
    "two wells": (lambda x, y: [y, x - x**3 - y], lambda s: s.y**2 / 2 + (s.x**2 - 1) ** 2 / 4),
    "a pull that is limited": lambda x: [-np.clip(x, -1, 1)],
    "a pull of two strengths": lambda x: [np.where(x > 0, -x, -2 * x)],
    "a square of squares": (lambda x, y: [y - x**3, -x], lambda s: (s.x**2 + s.y**2) ** 2),
    "a diode": lambda x: [1 - np.exp(x)],
    "a pendulum a turn further": (
        lambda th, w: [w, -np.sin(th) - w],
        turned,
        {"at": {"th": 2 * np.pi}},
    ),
    "a gain of its own in each interval": counting(lambda k: -2 - np.sin(k)),
    "a sine beside squares": lambda x, y: [-x + 0.5 * np.sin(y), -y],
    "a jump to its tanh": jumping(lambda t, x, p: np.tanh(x.m)),
    "V of what follows a wave": (
        lambda t, x: [np.cos(t) + np.sin(t) - x],
        lambda s: (s.x - np.sin(s.t)) ** 2,
    ),
}
RIGHT |= {
    "friction of each state, and forces that do no work": (
        lambda x, y: rubbed(x, y, 1.0),
        lambda s: np.exp(s.x) - s.x - 1 + 1.3 * np.log(np.cosh(s.y)),
    ),
    "a gradient's flow": (
        lambda x, y: [-(x**3 + x - y), -(y - x + y**3)],
        lambda s: s.x**4 / 4 + (s.x - s.y) ** 2 / 2 + s.y**4 / 4,
    ),
}
REFUTED = {
    "a chain with a link that pushes": lambda v, w, q: chain(np.sin, v, w, q),
    "two pendulums whose shaft pushes both": (
        lambda a, b, v, w: shaft(a, b, v, w, -1),
        of_the_shaft,
    ),
    "V of a difference that falls faster": (
        lambda a, b: [-a, -b],
        lambda s: np.cos(s.a - s.b) - 1 + (s.a**2 + s.b**2) / 2,
    ),
    "forces that do work": (
        lambda x, y: rubbed(x, y, -1.0),
        lambda s: np.exp(s.x) - s.x - 1 + 1.3 * np.log(np.cosh(s.y)),
    ),
    "friction that pushes where cos(y) is near -1": (
        lambda x, y: rubbed(x, y, 1.0, 0.99),
        lambda s: np.exp(s.x) - s.x - 1 + 1.3 * np.log(np.cosh(s.y)),
    ),
    "MRAC, V forgets b": (
        mrac(),
        lambda s: (
            (s.y - s.ym) ** 2 / 2
            + ((s.kr - s.bm / s.b) ** 2 + (s.ky - (s.am + s.a) / s.b) ** 2) / (2 * s.gamma)
        ),
    ),
    "backstepping, a term forgotten": (backstepping(missing=True, c=0.3), stepped),
    "observer, x beside z": (observer(), lambda s: (s.x1 + s.z1) ** 2 + (s.x2 - s.z2) ** 2),
    "pendulum upright": (pendulum(), energy, {"at": {"theta": np.pi}}),
    "pendulum, sign of the potential": (
        pendulum(),
        lambda s: s.omega**2 / 2 - s.g * (1 - np.cos(s.theta)),
    ),
    "V that is a saddle": (lambda x, y: [-x, y], lambda s: s.x**2 - s.y**2),
    "V that falls without end": (lambda x: [1.0 + 0 * x], lambda s: -s.x),
    "a source that pushes": (sourced(np.cos), halves),
    "a jump by a little": memory(1 + 1e-9),
    "a gain that turns a little": lambda t, x: [-(1 + 1.01 * np.sin(t)) * x],
    "a gain of a fast wave": lambda t, x: [-(1 + 1.01 * np.sin(1e6 * t)) * x],
    "a gain that turns at 900": lambda t, x: [-(900 - t) * x],
    "a gain that turns at the fifth breakpoint": counting(lambda k: k - 5),
    "V of an output that is called as its state": (
        control.nlsys(
            lambda t, x, u, p: -x, lambda t, x, u, p: x - 1, inputs=0, states=["x"], outputs=["x"]
        ),
        lambda s: s.x**2,
    ),
    "V of a table": (
        lambda x: [0.1 * x],
        lambda s: np.interp(np.abs(s.x), [0.0, 1.0, 2.0], [0.0, 1.0, 3.0]),
    ),
    "V of a floor": (lambda x: [0 * x + 1], lambda s: s.x * np.floor(s.x)),
    "wrong in a small region": lambda x: [-x * ((x - 1) ** 2 - 1e-3)],
    "a small bump": lambda x: [-x + 3 * np.exp(-50 * (x - 1) ** 2)],
    "V without a value": (lambda x: [-(x**3)], lambda s: s.x**2 + 1 / (s.x - 1) ** 2),
    "a sine too large beside squares": lambda x, y: [-x + 2.1 * np.sin(y), -y],
    "a jump to more than its tanh": jumping(lambda t, x, p: 1.01 * np.tanh(x.m)),
    "a state named q_0": lambda y, q_0: [-1e6 * np.tanh(y) + q_0, 0 * q_0],  # where y is small
    "a state called as its parameter": (  # k' = k, and the parameter is 0
        clpt.Block(
            "plant",
            update=lambda t, x, u, p: {"k": x.k + p.k},
            states={"k": 1},
            parameters={"k": 0.0},
        ),
        lambda s: s.plant_k**2,
    ),
    "V of a logarithm": (lambda x: [-x], lambda s: np.log(s.x) ** 2),
    "an input that drives": system(lambda x, d: [x + d], "d"),
    "another rest": (lambda x: [3.0 - x], None, {"at": {"x": 3.0}}),
}
OPEN = {  # no point shows it, or none is looked for
    "V of nothing": (lambda x: [x], lambda s: 0 * s.x),
    "V that jumps": (lambda x: [-x], lambda s: np.where(s.x > 1, s.x, 2 * s.x) ** 2),
    "V of an angle": (
        lambda x, y: [y, -x],
        lambda s: (np.arctan2(s.y, s.x) + 4) ** 2 + s.x**2 + s.y**2,
    ),
    "a chain of hinges": lambda v, w, q: chain(lambda z: 2 * z + np.sin(z), v, w, q),
    "a chain of soft dampers": lambda v, w, q: chain(lambda z: z / np.sqrt(1 + z**2), v, w, q),
    "V that is linear far off": (lambda x: [-x], lambda s: s.x**2 / (1 + np.abs(s.x))),
    "V that is bounded": (lambda x: [-x], lambda s: np.tanh(s.x**2)),
    "V that lets go far off": (
        lambda x, y: [-6 * x / (1 + x**2) ** 2 + 2 * y, -2 * (x + y) / (1 + x**2) ** 2],
        lambda s: s.x**2 / (1 + s.x**2) + s.y**2,
    ),
    "V that fades": (lambda x: [x / 2], lambda s: np.exp(-2 * s.t) * s.x**2),
    "V that sinks with time": (lambda x: [0 * x], lambda s: s.x**2 - s.t),
    "V whose least is far away": (
        lambda x: [5e3 - x],
        lambda s: 1e3 * np.log(np.cosh(s.x / 1e3 - 5)) - 5e3,
    ),
    "two gains 1e-12 apart": lambda x, y: [3.0 * y, -(3.0 + 1e-12) * x],
    "a needle": lambda x: [-x + 2 * x * np.exp(-1e8 * (x - 1) ** 2)],
    "a force below all numbers": lambda x: [x * np.exp(-1000 - x**2)],
    "V that is zero on one side": (lambda x: [-x], lambda s: np.abs(s.x) * s.x + s.x**2),
    "a spring stronger in each interval": (  # v rises with its strength
        clpt.Block(
            "spring",
            update=lambda t, x, u, p: {"q": x.v, "v": -((1 + p.interval) ** 2) * x.q},
            output=lambda t, x, u, p: {"V": x.v**2 + (1 + p.interval) ** 2 * x.q**2},
            states={"q": 1, "v": 1},
            outputs={"V": 1},
            **TICKS,
        ),
        "V",
    ),
    "no value in the third interval": counting(lambda k: -(k - 3) / (k - 3)),
    "no value for its parameters": system(lambda x, n: [-(x**n) * np.abs(x)], params={"n": 0.5}),
    "V of a floor of time": (
        control.nlsys(
            lambda t, x, u, p: 0 * x,
            lambda t, x, u, p: x**2 * (1 + np.floor(t) ** 2),
            inputs=0,
            states=["x"],
            outputs=["V"],
        ),
        "V",
    ),
    "wrong in a smaller region": lambda x: [-x * ((x - 7) ** 2 - 1e-9)],
    "no value at a point": lambda x: [-x / np.abs(x - 2)],
    "no value at the rest": lambda x: [-1 / x],
    "V of sizes, a slide": (  # along x = 0, where y runs off
        lambda x, y: [-2 * np.sign(x), np.sign(x) ** 2],
        lambda s: np.abs(s.x) + np.abs(s.y),
    ),
    "V of a size, a slide": (
        lambda x, y: [-2 * np.sign(x) * (1 + y**2), np.sign(x) ** 2 * y],
        lambda s: np.sqrt(s.x**2) + s.y**2 / 2,
    ),
    "V that rises where a sign turns": (
        lambda x: [1 - x],
        lambda s: (s.x - 1) ** 2 + (2 + np.sign(s.x)) ** 2,
    ),
    "a pull of inf/inf": lambda x: [-x * np.cosh(x) / np.cosh(x)],
    "a pull of powers without a number": lambda x: [-x * x**80 / (1 + x**80)],
    "a place outside of a table": lambda x: [
        -x * (1 + lookup([1.0, 2.0], np.where(x > 1e6, 5, 0)) ** 2)
    ],
    "V of an area cosine": (lambda x: [0 * x], lambda s: np.arccosh(s.x) ** 2 + s.x**2),
}
BESIDE = {  # V' <= 0 is right, and more is to be said
    "V of what runs with time": (
        "proved but for x",
        lambda x: [1 + 0 * x],
        lambda s: (s.x - s.t) ** 2,
    ),
    "oscillators that agree": (
        "proved but for a",
        lambda a, b: [np.sin(b - a), np.sin(a - b)],
        lambda s: 1 - np.cos(s.a - s.b),
    ),
    "an angle that ends": (
        "proved as long as th exist",
        lambda th, w: [w * (1 + th**2), -np.sin(th) * (1 + th**2)],
        turned,
    ),
    "an angle that drives": (
        "proved but for th, y",
        lambda th, w, y: [w, -np.sin(th), th - y],
        turned,
    ),
    "a source that drives": ("proved but for y", sourced(lambda t: np.array([t**2])), half),
    "a jump of what V misses": ("proved but for n", memory(0.5, 3.0), lambda s: s.m**2),
    "a jump that rises at no breakpoint": (
        "proved between jumps",
        jumping(lambda t, x, p: (1 + np.sin(np.pi * t) ** 2) * x.m),
    ),
    "a jump that would rise before the first breakpoint": (
        "proved between jumps",
        jumping(lambda t, x, p: np.where(p.interval < 0.5, 2.0, 0.5) * x.m),
    ),
    "V that misses a state": ("proved but for y", lambda x, y: [-x, y], half),
    "V that misses two integrators": (
        "proved but for y, z",  # whose eigenvalues are -1e-10 in floating point
        lambda x, y, z: [-x, (3 * y + x) / 10 - 9 * z / 100, y - 3 * z / 10],
        half,
    ),
    "V that misses a state that ends": (
        "proved as long as y exist",
        lambda x, y: [-x, 1 + y**2],
        half,
    ),
    "V of the sum alone": (
        "proved as long as x exist",
        lambda x, y: [-x + y**3, -y - y**3],
        lambda s: (s.x + s.y) ** 2,
    ),
    "V that a parameter of zero lets go": (
        "proved but for x",
        system(lambda x, y, k: [x, -y + 0.0 * k], params={"k": 0.0}),
        lambda s: (s.y + s.k * s.x) ** 2 + s.y**2,
    ),
}
RIGHT, REFUTED, OPEN = map(table, (RIGHT, REFUTED, OPEN))
BESIDE = {name: (status, *filled(*row)) for name, (status, *row) in BESIDE.items()}
