"""Adaptive laws as users write them: right ones, wrong ones, and odd ones.

u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2], section III.
"""

import math
from typing import NamedTuple

import numpy as np

from clpt_control.blocks import Block, opaque
from clpt_control.blocks.words import clip, floor, lookup, maximum, sign, where
from clpt_control.theory.proving.theorem_loop import theorem_scenario

N = 2


class Gain(NamedTuple):
    N: int
    gain: float


class Rate(NamedTuple):
    N: int
    rate: float


class Gamma(NamedTuple):
    N: int
    gamma: float


class Two(NamedTuple):
    N: int
    gain: float
    c: float


class Three(NamedTuple):
    N: int
    gains: np.ndarray


class Each(NamedTuple):
    N: int
    gains: np.ndarray


class Arrays(NamedTuple):
    N: int
    gain: float
    K: np.ndarray
    z: np.ndarray


class Truth(NamedTuple):
    N: int
    gain: float
    theta: np.ndarray
    KD: np.ndarray
    GammaD: np.ndarray


def law(update, parameters, more=None, **ports):
    n = parameters.N
    return Block(
        "own",
        update=update,
        inputs={"e": 2, "phi_x": n, "z": 2, "zc": 2, **(more or {})},
        parameters=parameters,
        **(ports or {"states": {"alpha": 2 * n, "K": 2, "Gamma": 2}}),
    )


def filled(x, u, p, dx, gain, e, i):
    """Eqs. (21)-(23) for axis i, with this gain and this error."""
    n = p.N
    for k in range(n):
        dx[i * n + k] = -gain * e * u[2 + k]
    dx[2 * n + i] = -gain * u[2 + n + i] * e
    dx[2 * n + 2 + i] = gain * u[4 + n + i] * e


def shipped(t, x, u, p, dx):
    """The paper's law, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)


def flipped(t, x, u, p, dx):
    """Every sign flipped, section III."""
    for i in range(2):
        filled(x, u, p, dx, -p.gain, u[i], i)


def called_rate(t, x, u, p, dx):
    """The gain's field is called rate, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.rate, u[i], i)


def called_gamma(t, x, u, p, dx):
    """The gain's field is called gamma, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gamma, u[i], i)


def times_one(t, x, u, p, dx):
    """Times sin^2 + cos^2, section III."""
    one = math.sin(u[0]) ** 2 + math.cos(u[0]) ** 2
    for i in range(2):
        filled(x, u, p, dx, p.gain * one, u[i], i)


def clipped_and_back(t, x, u, p, dx):
    """e as clip(e) + (e - clip(e)), section III."""
    for i in range(2):
        inner = clip(u[i], -1.0, 1.0)
        filled(x, u, p, dx, p.gain, inner + (u[i] - inner), i)


def three_gains(t, x, u, p, dx):
    """A gain each for alpha, K and Gamma, section III."""
    n = p.N
    for i in range(2):
        for k in range(n):
            dx[i * n + k] = -p.gains[0] * u[i] * u[2 + k]
        dx[2 * n + i] = -p.gains[1] * u[2 + n + i] * u[i]
        dx[2 * n + 2 + i] = p.gains[2] * u[4 + n + i] * u[i]


def a_gain_each(t, x, u, p, dx):
    """A gain for each function, and K held apart, section III."""
    n = p.N
    for i in range(2):
        for k in range(n):
            dx[i * n + k] = -p.gains[k] * u[i] * u[2 + k]
        dx[2 * n + i] = -(1.0 + i) * u[2 + n + i] * u[i]
        dx[2 * n + 2 + i] = 0.3 * u[4 + n + i] * u[i]


def tanh_of_e(t, x, u, p, dx):
    """tanh(e) in place of e: falls with another V, ln cosh(e), section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, math.tanh(u[i]), i)


def composite(t, x, u, p, dx):
    """With the flow's own prediction error, section III: u ends with flow_x[2]."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
        off = u[6 + n + i]
        for k in range(n):
            off += x[i * n + k] * u[2 + k]
        for k in range(n):
            dx[i * n + k] -= p.c * off * u[2 + k]


def leak(t, x, u, p, dx):
    """With a leak c of all that is learned, section III."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    for j in range(2 * n + 4):
        dx[j] -= p.gain * p.c * x[j]


def leak_of_alpha(t, x, u, p, dx):
    """With a leak c of alpha alone, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    for j in range(2 * p.N):
        dx[j] -= p.gain * p.c * x[j]


def projection(t, x, u, p, dx):
    """alpha kept within a ball of radius c on each axis, section III."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
        size, outward = 0.0, 0.0
        for k in range(n):
            size += x[i * n + k] ** 2
            outward += dx[i * n + k] * x[i * n + k]
        off = where(size > p.c**2, maximum(outward, 0.0) / maximum(size, 1e-9), 0.0)
        for k in range(n):
            dx[i * n + k] -= off * x[i * n + k]


def leak_by(x, p, dx, factor, last):
    """Take gain c factor times the states up to `last` from their rates."""
    for j in range(last):
        dx[j] -= p.gain * p.c * factor * x[j]


def e_leak_of_alpha(t, x, u, p, dx):
    """A leak of alpha alone, in proportion to |e|, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    leak_by(x, p, dx, math.hypot(u[0], u[1]), 2 * p.N)


def leak_that_fades(t, x, u, p, dx):
    """A leak that is zero where |alpha| > 2, section III."""
    squares = 0.0
    for j in range(2 * p.N):
        squares += x[j] ** 2
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    leak_by(x, p, dx, clip(2.0 - math.sqrt(squares), 0.0, 1.0), 2 * p.N)


def leak_of_any_sign(t, x, u, p, dx):
    """A leak between -c and c that rises with |alpha|, section III."""
    squares = 0.0
    for j in range(2 * p.N):
        squares += x[j] ** 2
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    leak_by(x, p, dx, clip(math.sqrt(squares) - 1.0, -1.0, 1.0), 2 * p.N)


def half_a_projection(t, x, u, p, dx):
    """Half of the outward part taken away, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    for ball in range(2):
        first, last = ball * 2 * p.N, 2 * p.N + 4 * ball
        size, outward = 0.0, 0.0
        for j in range(first, last):
            size += x[j] ** 2
            outward += dx[j] * x[j]
        share = 0.5 * clip(size / p.c**2 - 1.0, 0.0, 1.0)
        off = share * maximum(outward, 0.0) / maximum(size, p.c**2)
        for j in range(first, last):
            dx[j] -= off * x[j]


def equal_gain(t, x, u, p, dx):
    """The sign turns at one gain, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain * where(p.gain == 0.5, -1.0, 1.0), u[i], i)


def equal_sign(t, x, u, p, dx):
    """Nothing is learned where e > 0, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain * where(sign(u[i]) == 1.0, 0.0, 1.0), u[i], i)


def named_like_signals(t, x, u, p, dx):
    """Leaks towards parameters K and z, not signals, section III."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
        dx[2 * n + i] -= p.gain * (x[2 * n + i] - p.K[i])
        dx[2 * n + 2 + i] += 0.3 * (u[2 + n + i] - p.z[i])


def by_shape(t, x, u, p, dx):
    """A leak of alpha where there are other than two gains, section III."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, p.gains[0], u[i], i)
        for k in range(n):
            dx[i * n + k] -= (p.gains.shape[0] - 2.0) * x[i * n + k]


def wrong_fifth(t, x, u, p, dx):
    """The fifth function is learned backwards, section III."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
        for k in range(n):
            dx[i * n + k] = -p.gain * u[i] * u[2 + k] * where(k == 4, -1.0, 1.0)


def two_tables(t, x, u, p, dx):
    """Two tables at one index, subtracted, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
        j = clip(floor(u[0]), 0.0, 1.0)
        dx[i] += lookup(p.K, j) - lookup(p.z, j)


@opaque
def hidden(table, s):
    return table[0] * s


def two_hidden(t, x, u, p, dx):
    """Two arrays through one opaque helper, subtracted, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
        dx[i] += hidden(p.K, u[4]) - hidden(p.z, u[4])


def own_x(t, x, u, p, dx):
    """A private state called x pushes alpha, section III."""
    n = p.N
    for i in range(2):
        for k in range(n):
            dx[2 + i * n + k] = -p.gain * u[i] * u[2 + k] - 0.1 * (x[i] - u[2 + n + i])
        dx[2 + 2 * n + i] = -p.gain * u[2 + n + i] * u[i]
        dx[4 + 2 * n + i] = p.gain * u[4 + n + i] * u[i]
        dx[i] = -x[i]


def behind_x(t, x, u, p, y):
    """All states but the private one, section III."""
    for j in range(2 * p.N + 4):
        y[j] = x[2 + j]


def without_value(t, x, u, p, dx):
    """z z/z in place of z, section III."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
        z = u[2 + n + i]
        dx[2 * n + i] = -p.gain * (z * z / z) * u[i]


def x_less_z(t, x, u, p, dx):
    """x - z in place of e, a gain exp(c), section III: u ends with x[2]."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, math.exp(p.c), u[6 + n + i] - u[2 + n + i], i)


def e_and_its_cube(t, x, u, p, dx):
    """e + e^3 in place of e: falls with (e + e^3) in V, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i] + u[i] ** 3, i)


def a_matrix_of_gains(t, x, u, p, dx):
    """K and Gamma adapted by each other's signals, section III."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
        dx[2 * n + i] += p.c * u[4 + n + i] * u[i]
        dx[2 * n + 2 + i] -= p.c * u[2 + n + i] * u[i]


def memory(t, x, u, p, dx):
    """With a remembered prediction error, never negative, section III: u ends with flow_x[2]."""
    n, own = p.N, 2 * p.N + 4
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
        dx[own + i] = u[2] ** 2 - x[own + i]
        dx[own + 2 + i] = u[2] * u[6 + n + i] - x[own + 2 + i]
        dx[i * n] -= p.c * (x[own + i] * x[i * n] + x[own + 2 + i])


def pulled_to_a_runaway(t, x, u, p, dx):
    """alpha is pulled to a private state that grows, section III."""
    n = p.N
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    dx[2 * n + 4] = x[2 * n + 4]
    dx[0] -= p.gain * (x[0] - x[2 * n + 4])


def pulled_to_time(t, x, u, p, dx):
    """alpha is pulled to the time, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    dx[0] -= p.gain * (x[0] - t)


def too_large(t, x, u, p, dx):
    """e as log(exp(e)), infinite beyond 709, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, math.log(math.exp(u[i])), i)


def rounded_away(t, x, u, p, dx):
    """e as (e + c) - c, zero for a large c, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, (u[i] + p.c) - p.c, i)


def divided(t, x, u, p, dx):
    """The gain divided by c, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain / p.c, u[i], i)


def to_the_fortieth(t, x, u, p, dx):
    """A sum to the power 40, section III."""
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i], i)
    dx[0] += (x[0] + x[1] + u[0] + u[1] + u[2]) ** 40


def without_end(t, x, u, p, dx):
    """A choice of choices of choices, section III."""
    s = u[0]
    for j in range(40):
        s = where(s > j, s * u[2], s + x[0])
    for i in range(2):
        filled(x, u, p, dx, p.gain, u[i] + s, i)


def indefinite(t, x, u, p, y):
    """V of Eq. (24) with the parameter errors' sign turned."""
    n, V = p.N, 0.0
    for i in range(2):
        V += u[i] ** 2 / 2
        for k in range(n):
            V -= (p.theta[i, k] + u[2 + i * n + k]) ** 2 / (2 * p.gain)
        V -= (u[2 + 2 * n + i] - p.KD[i]) ** 2 / (2 * p.gain)
        V -= (p.GammaD[i] - u[4 + 2 * n + i]) ** 2 / (2 * p.gain)
    y[0] = V


def turned_V():
    scenario = theorem_scenario(N, "learned-flow")
    car = scenario.vehicle
    truth = map(np.array, (scenario.flow.parameters, car.feedback, car.feedforward))
    return Block(
        "lyapunov",
        output=indefinite,
        inputs={"e": 2, "alpha": 2 * N, "K": 2, "Gamma": 2},
        outputs={"V": 1},
        parameters=Truth(N, 0.5, *truth),
    )


FLOW = {"flow_x": 2}
ARRAYS = Arrays(N, 0.5, np.array([1.0, 2.0]), np.array([0.1, 0.2]))
PRIVATE = {
    "states": {"x": 2, "alpha": 2 * N, "K": 2, "Gamma": 2},
    "output": behind_x,
    "outputs": {"alpha": 2 * N, "K": 2, "Gamma": 2},
    "feedthrough": False,
}
MORE = {"alpha": 2 * N, "K": 2, "Gamma": 2, "s": 1}
RIGHT = {  # name -> (law, whether for every N too)
    "the paper's": (lambda: law(shipped, Gain(N, 0.5)), True),
    "its gain called rate": (lambda: law(called_rate, Rate(N, 0.5)), True),
    "its gain called gamma": (lambda: law(called_gamma, Gamma(N, 0.5)), True),
    "times sin^2 + cos^2": (lambda: law(times_one, Gain(N, 0.5)), True),
    "clip(e) + (e - clip(e))": (lambda: law(clipped_and_back, Gain(N, 0.5)), True),
    "three gains": (lambda: law(three_gains, Three(N, np.array([0.5, 0.2, 0.7]))), True),
    "a gain each": (lambda: law(a_gain_each, Each(N, np.array([0.5, 2.0]))), True),
    "x - z and exp(c)": (lambda: law(x_less_z, Two(N, 0.5, 0.3), {"x": 2}), True),
    "composite": (lambda: law(composite, Two(N, 0.5, 0.5), FLOW), False),
    "a leak of 0": (lambda: law(leak, Two(N, 0.5, 0.0)), False),
    "as many gains as functions": (lambda: law(by_shape, Each(N, np.array([0.5, 0.5]))), False),
    "wrong from N = 5 on": (lambda: law(wrong_fifth, Gain(N, 0.5)), False),
    "a small gain": (lambda: law(shipped, Gain(N, 1e-8)), True),
}
BOUNDED = {
    "leak": lambda: law(leak, Two(N, 0.5, 0.1)),
    "leak of alpha": lambda: law(leak_of_alpha, Two(N, 0.5, 0.1)),
}
REFUTED = {
    "gain -0.5": lambda: law(shipped, Gain(N, -0.5)),
    "every sign flipped": lambda: law(flipped, Gain(N, 0.5)),
    "a leak of -0.1": lambda: law(leak, Two(N, 0.5, -0.1)),
    "composite, c = -0.5": lambda: law(composite, Two(N, 0.5, -0.5), FLOW),
    "wrong from N = 5 on, N = 6": lambda: law(wrong_fifth, Gain(6, 0.5)),
}
NOT_PROVED = {  # wrong, or right but not known to be
    "parameters called K and z": lambda: law(named_like_signals, ARRAYS),
    "two tables": lambda: law(two_tables, ARRAYS),
    "one opaque helper": lambda: law(two_hidden, ARRAYS),
    "a private state called x": lambda: law(own_x, Gain(N, 0.5), **PRIVATE),
    "tanh(e)": lambda: law(tanh_of_e, Gain(N, 0.5)),
    "z z/z": lambda: law(without_value, Gain(N, 0.5)),
    "pulled to a private state": lambda: law(pulled_to_a_runaway, Gain(N, 0.5), states=MORE),
    "pulled to the time": lambda: law(pulled_to_time, Gain(N, 0.5)),
    "log(exp(e))": lambda: law(too_large, Gain(N, 0.5)),
    "|e| pulls alpha alone": lambda: law(e_leak_of_alpha, Two(N, 0.5, 0.1)),
    "a leak that fades": lambda: law(leak_that_fades, Two(N, 0.5, 0.1)),
    "a leak of any sign": lambda: law(leak_of_any_sign, Two(N, 0.5, 0.1)),
    "half a projection": lambda: law(half_a_projection, Two(N, 0.5, 2.0)),
    "(e + 1e16) - 1e16": lambda: law(rounded_away, Two(N, 0.5, 1e16)),
    "(e + 1e16) - 1e16, a small gain": lambda: law(rounded_away, Two(N, 1e-9, 1e16)),
    "(e + 1e16) - 1e16, a tiny gain": lambda: law(rounded_away, Two(N, 1e-15, 1e16)),
}
NOT_REFUTED = {  # right, or right with another V
    "projection": lambda: law(projection, Two(N, 0.5, 2.0)),
    "tanh(e)": lambda: law(tanh_of_e, Gain(N, 0.5)),
    "e + e^3": lambda: law(e_and_its_cube, Gain(N, 0.5)),
    "a matrix of gains": lambda: law(a_matrix_of_gains, Two(N, 0.5, 0.1)),
    "a memory": lambda: law(
        memory, Two(N, 0.5, 0.3), FLOW, states={"alpha": 2 * N, "K": 2, "Gamma": 2, "M": 4}
    ),
}
TOO_MUCH = {  # -> what is said
    "a gain divided by zero": (
        lambda: law(divided, Two(N, 0.5, 0.0)),
        "have no value .own.update divides by 0",
    ),
    "a power of 40": (lambda: law(to_the_fortieth, Gain(N, 0.5)), "V' has more than 20000 terms"),
    "choices of choices": (lambda: law(without_end, Gain(N, 0.5)), "own.update has more than 5000"),
    "one z": (
        lambda: Block(
            "own",
            update=shipped,
            inputs={"e": 2, "phi_x": 2, "zc": 3, "z": 1},
            parameters=Gain(N, 0.5),
            states={"alpha": 4, "K": 2, "Gamma": 2},
        ),
        "'zc' has 2 signals",
    ),
    "no name": (lambda: Block("", update=shipped, inputs={}, states=MORE), "must not be empty"),
    "a port with a dot": (lambda: law(shipped, Gain(N, 0.5), {"a.b": 1}), "'a.b' of a block"),
}
REFUSED = {"p.gain == 0.5": equal_gain, "sign(e) == 1": equal_sign}
