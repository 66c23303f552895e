"""Systems with a V each: right ones, and wrong ones of many kinds, most as they are written.

A right one stands under the strongest conclusion that is true of it; `LESS` has those of which a
weaker conclusion is shown, which is true as well.
"""

from typing import Any, NamedTuple

import control
import numpy as np
from adaptive_loop import mrac
from text_systems import TICKS, signals, system, written

import clpt_control as clpt


def filled(plant, *more):
    """What is written, or a system, its V, and what else is given."""
    if isinstance(plant, str):
        return written(plant)
    names = [label.partition("[")[0] for label in plant.state_labels]
    return plant, *(more or [signals(None, dict.fromkeys(names))])


# --- model reference adaptive control of a first-order plant, in two blocks ----------------------


def textbook(s, weight=None):
    apart = (s.kr - 4 / s.b) ** 2 + (s.kx + (4 + s.a) / s.b) ** 2
    return (s.y - s.ym) ** 2 / 2 + (weight or s.b) * apart / (2 * s.gain)


# --- adaptive backstepping: x1' = x2 + theta x1^2, x2' = u ----------------------------------------


def backstepping(first="x1", c=2.0):
    z2, slope = "(x2 + c*x1 + h*x1**2)", "(c + 2*h*x1)"  # of -alpha in x1
    tuned = f"(gamma*(x1**3 + {z2}*{slope}*x1**2))"
    push = f"-{first} - c*{z2} - {slope}*(x2 + h*x1**2) - {tuned}*x1**2"
    rates = f"x1' = x2 + theta*x1**2; x2' = {push}; h' = {tuned}; c = {c}; theta = 1.5; gamma = 3"
    return f"{rates}; V = x1**2/2 + {z2}**2/2 + (theta - h)**2/(2*gamma)"


# --- a Luenberger observer ------------------------------------------------------------------------

A, L = np.array([[0.0, 1.0], [-2.0, -1.0]]), np.array([[3.0], [1.0]])
SOLVED = control.lyap((A - L @ [[1.0, 0.0]]).T, np.eye(2))
P = np.array([[2.0, -1.0], [-1.0, 2.0]]) / 6  # the same by hand


def observer():
    names = {"states": ["x1", "x2"], "inputs": "u", "outputs": "y", "name": "plant"}
    plant = control.ss(A, [[0], [1]], [[1, 0]], 0, **names)
    return clpt.connect([plant, clpt.parts.observer(plant, L)], external="u")


def of_the_error(s, sign=1, weights=P):
    e = np.append(s.x1, s.x2) - sign * s.x_hat
    return e @ weights @ e


# --- jumps, and sources of time ------------------------------------------------------------------


def block(update, states, **more):
    """A block with breakpoints, of the rates of its states."""
    more = {"states": dict.fromkeys(states, 1)} | TICKS | more
    return clpt.Block("plant", update=lambda t, x, u, p: update(x, p), **more)


def lag(rate, output, name):
    """A state of this rate, of which an output is made."""
    ports = {"states": ["x"], "inputs": 0, "outputs": [name]}
    return control.nlsys(
        lambda t, x, u, p: rate * x, lambda t, x, u, p: output(t, x), **ports
    )


def memory(factor, beside=1.0):
    jump = lambda t, x, u, p: {"m": factor * x.m, "n": beside * x.n}  # noqa: E731
    return block(lambda x, p: {"m": -x.m, "n": -x.n}, "mn", jump=jump)


def jumping(jump):
    """A memory that fades, and jumps to what is made of it."""
    return block(
        lambda x, p: {"m": -x.m}, "m", jump=lambda t, x, u, p: {"m": jump(t, x, p)}
    )


def counting(rate):
    """A gain that depends on which interval between breakpoints it is."""
    return block(lambda x, p: {"x": rate(p.interval) * x.x}, "x")


def sourced(source):
    """A plant that a source of time drives."""
    made = clpt.Block(
        "source",
        output=lambda t, x, u, p: {"w": source(t)},
        outputs={"w": 1},
        opaque=True,
    )
    rates = lambda t, x, u, p: {"x": -x.x, "y": -x.y + u.w}  # noqa: E731
    plant = clpt.Block("plant", update=rates, states={"x": 1, "y": 1}, inputs={"w": 1})
    return clpt.connect([made, plant])


def half(s):
    return s.x**2 / 2


# --- families of equations -----------------------------------------------------------------------

PENDULUM = "theta' = omega; omega' = -g*sin(theta) - 0.1*omega; g = 9.8"
ENERGY, TURNED = "V = omega**2/2 + g*(1 - cos(theta))", "V = w**2/2 + 1 - cos(th)"
NEURONS = "V = exp(x) - x - 1 + 1.3*log(cosh(y))"


def rubbed(sign, least=1.0):
    """Rates along the slopes of exp(x) - x - 1 + 1.3 log(cosh(y)), and across them."""
    a, b = "(exp(x) - 1)", "1.3*tanh(y)"
    x = f"x' = -({least} + cos(y))*{a} + 0.7*sin(y)*{b}"
    return f"{x}; y' = -abs(x)*{b} - 0.7*{sign}*sin(y)*{a}; {NEURONS}"


def shaft(back):
    """Two pendulums on a shaft that springs back by the sine of its twist; V their energy."""
    rates = "a' = v; b' = w; v' = -sin(a) - 0.5*sin(a - b) - 0.2*v"
    V = "(v**2 + w**2)/2 + 2.5 - cos(a) - cos(b) - 0.5*cos(a - b)"
    return f"{rates}; w' = -sin(b) + {back}*0.5*sin(a - b) - 0.2*w; V = {V}"


def chain(link):
    """Three capacitors, or masses, in a row, of which the last leaks."""
    a, b = link.format("(v - w)"), link.format("(w - q)")
    return f"v' = -({a}); w' = {a} - ({b}); q' = {b} - q"


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


def tuner(b, mu):
    """A law with a state n beside its estimate h; right where b mu/0.8 >= 1."""
    rates = "e' = -e + (h + th)*f; n' = -0.8*e*f; h' = -b*(h - n)*(1 + mu*f**2)"
    V = "V = e**2/2 + ((n + th)**2 + (h - n)**2)/1.6"
    return f"{rates}; {V}; b = {b}; mu = {mu}; th = 0.5; input f"


RIGHT = {
    "asymptotically stable": {
        "tanh": "x' = -tanh(x)",
        "a chain of diodes": chain("(exp(40*{0}) - 1)"),
        "a chain of soft dampers": chain("({0}/sqrt(1 + {0}**2))"),
        "a barrier": "x' = minimum(-x, 1 - x)",
        "a limit that is never reached": "x' = x**3 - maximum(x**2 + 0.5, 0.0)*x",
        "gain of a higher wave": "x' = -(2 + sin(3*t))*x",
        "gain of a wave's high power": "x' = -(1.001 - sin(t/1000)**2000)*x",
        "V of time":  # Khalil, Nonlinear Systems, 3rd ed., Example 4.20
        "x' = -x - exp(-2*t)*y; y' = x - y; V = x**2 + (1 + exp(-2*t))*y**2",
        "gain that grows": "x' = -t*x",
        "a divisor of masses": "q' = v; v' = -(q + v)/(M*m - c**2); V = q**2 + (M*m - c**2)*v**2; "
        "m = 1; M = 2; c = 0.5",
        "a power that a parameter gives": "x' = -x**n; n = 3",
        "a spinning body":  # Euler's equations, J = 1, 2, 3
        "x' = -y*z - 0.2*x; y' = (2*z*x - 0.2*y)/2; z' = (-x*y - 0.2*z)/3; "
        "V = x**2/2 + y**2 + 1.5*z**2",
        "a cross term": "x' = y; y' = -x - y; V = 1.5*x**2 + x*y + y**2",
        "a rest elsewhere": "x' = 3 - x; V = (x - 3)**2; at x = 3",
        "a jump that turns": (memory(-1.0),),
        "a pull that ends at rest": "x' = -sign(x)*sqrt(abs(x))",
        "a pull that is limited": "x' = -clip(x, -1, 1)",
        "a pull of two strengths": "x' = where(x > 0, -x, -2*x)",
        "a square of squares": "x' = y - x**3; y' = -x; V = (x**2 + y**2)**2",
        "a diode": "x' = 1 - exp(x)",
        "a gain of its own in each interval": (counting(lambda k: -2 - np.sin(k)),),
        "a sine beside squares": "x' = -x + 0.5*sin(y); y' = -y",
        "a jump to its tanh": (jumping(lambda t, x, p: np.tanh(x.m)),),
        "a polynomial that just stays below zero": "x' = -x**5 + 1.9999*x**3 - x",
        "V of a root that goes on rising": "x' = -x; V = x**2/sqrt(1 + x**2)",
        "a gradient's flow": "x' = -(x**3 + x - y); y' = -(y - x + y**3); "
        "V = x**4/4 + (x - y)**2/2 + y**4/4",
    },
    "comes to rest": {
        "backstepping": backstepping(),
        "pendulum": f"{PENDULUM}; {ENERGY}",
        "two pendulums on one shaft": shaft(1),
        "a rate that is zero on one side": "x' = -1.65*x*(maximum(x, -0.7) + 0.7)",
        "two wells": "x' = y; y' = x - x**3 - y; V = y**2/2 + (x**2 - 1)**2/4",
        "a pendulum a turn further": f"th' = w; w' = -sin(th) - w; {TURNED}; at th = 2*pi",
        "friction of each state, and forces that do no work": rubbed(1.0),
    },
    "goes to zero": {
        "MRAC": (mrac(), textbook),
        "MRAC, numbers in V": (
            mrac(),
            lambda s: (
                (s.y - s.ym) ** 2 / 2
                + 0.75 * ((s.kr - 4 / 3) ** 2 + (s.kx + 5 / 3) ** 2)
            ),
        ),
        "observer": (observer(), of_the_error),
        "observer, P as it is solved for": (
            observer(),
            lambda s: of_the_error(s, weights=SOLVED),
        ),
        "a projection": "e' = -e + (1 - h)*f; h' = where((h > 2) & (e*f > 0), 0.0, e*f); "
        "V = e**2/2 + (h - 1)**2/2; input f",
        "a higher-order tuner": tuner(1.0, 2.0),
        "V of what follows a wave": "x' = cos(t) + sin(t) - x; V = (x - sin(t))**2",
    },
}
REFUTED = {
    "a chain with a link that pushes": chain("sin{0}"),
    "two pendulums whose shaft pushes both": shaft(-1),
    "V of a difference that falls faster": "a' = -a; b' = -b; V = cos(a - b) - 1 + (a**2 + b**2)/2",
    "forces that do work": rubbed(-1.0),
    "friction that pushes where cos(y) is near -1": rubbed(1.0, 0.99),
    "MRAC, V forgets b": (mrac(), lambda s: textbook(s, 1)),
    "backstepping, a term forgotten": backstepping("0.0", c=0.3),
    "observer, x beside -z": (observer(), lambda s: of_the_error(s, -1)),
    "pendulum upright": f"{PENDULUM}; {ENERGY}; at theta = pi",
    "pendulum, sign of the potential": f"{PENDULUM}; V = omega**2/2 - g*(1 - cos(theta))",
    "van der Pol": "x' = -y; y' = x - eps*(1 - x**2)*y; eps = 1",
    "V that is a saddle": "x' = -x; y' = y; V = x**2 - y**2",
    "V that falls without end": "x' = 1 + 0*x; V = -x",
    "a source that pushes": (sourced(np.cos), signals(None, "xy")),
    "a jump by a little": (memory(1 + 1e-9),),
    "a gain that turns a little": "x' = -(1 + 1.01*sin(t))*x",
    "a gain of a fast wave": "x' = -(1 + 1.01*sin(1e6*t))*x",
    "a gain that turns at 900": "x' = -(900 - t)*x",
    "a gain that turns at the fifth breakpoint": (counting(lambda k: k - 5),),
    "V of a table": "x' = 0.1*x; V = interp(abs(x), [0.0, 1.0, 2.0], [0.0, 1.0, 3.0])",
    "V of a floor": "x' = 0*x + 1; V = x*floor(x)",
    "a cube that pushes": "x' = x + x**3",
    "a square, of odd degree in V'": "x' = 1 - x**2",
    "a polynomial that just passes zero": "x' = (-x**5 + 2.0001*x**3 - x)/(1 + x**4)",
    "wrong in a small region": "x' = -x*((x - 1)**2 - 1e-3)/(1 + x**2)",
    "a small bump": "x' = -x + 3*exp(-50*(x - 1)**2)",
    "V without a value": "x' = -(x**3); V = x**2 + 1/(x - 1)**2",
    "a sine too large beside squares": "x' = -x + 2.1*sin(y); y' = -y",
    "a jump to more than its tanh": (jumping(lambda t, x, p: 1.01 * np.tanh(x.m)),),
    "a state named q_0": "y' = -1e6*tanh(y) + q_0; q_0' = 0*q_0",  # where y is small
    "a state called as its parameter": (  # k' = k, and the parameter is 0
        block(
            lambda x, p: {"k": x.k + p.k}, "k", parameters={"k": 0.0}, breakpoints=None
        ),
        lambda s: s.plant_k**2,
    ),
    "V of a logarithm": "x' = -x; V = log(x)**2",
    "an input that drives": "x' = x + d; input d",
    "a higher-order tuner that follows too slowly": tuner(0.1, 0.1),
    "another rest": "x' = 3 - x; at x = 3",
}
OPEN = {  # no point shows it, or none is looked for
    # 1.65*0.7 is 1.1549999999999998, so V' = 2e-16 x**2 where x < -0.7
    "two products of which one is rounded": "x' = x*(-1.65*maximum(x, -0.7) - 1.65*0.7)",
    "V of nothing": "x' = x; V = 0*x",
    "V that jumps": "x' = -x; V = where(x > 1, x, 2*x)**2",
    "V of an angle": "x' = y; y' = -x; V = (arctan2(y, x) + 4)**2 + x**2 + y**2",
    "V of an arm, no sum of squares": (system(arm), of_the_arm),
    "a chain of hinges": chain("(2*{0} + sin{0})"),
    "V that is linear far off": "x' = -x; V = x**2/(1 + abs(x))",
    "V that is bounded": "x' = -x; V = tanh(x**2)",
    "V that lets go far off": "x' = -6*x/(1 + x**2)**2 + 2*y; y' = -2*(x + y)/(1 + x**2)**2; "
    "V = x**2/(1 + x**2) + y**2",
    "V of a root that lets go far off": "x' = 2*y; "
    "y' = 2*x**5/(1 + x**4)**1.5 - 2*x/sqrt(1 + x**4); V = x**2/sqrt(1 + x**4) + y**2",
    "V that fades": "x' = x/2; V = exp(-2*t)*x**2",
    "V that sinks with time": "x' = 0*x; V = x**2 - t",
    "V whose least is far away": "x' = 5e3 - x; V = 1e3*log(cosh(x/1e3 - 5)) - 5e3",
    "two gains 1e-12 apart": "x' = 3*y; y' = -(3 + 1e-12)*x",
    "a needle": "x' = -x + 2*x*exp(-1e8*(x - 1)**2)",
    "a force below all numbers": "x' = x*exp(-1000 - x**2)",
    "V that is zero on one side": "x' = -x; V = abs(x)*x + x**2",
    "a spring stronger in each interval": (  # v rises with its strength
        block(
            lambda x, p: {"q": x.v, "v": -((1 + p.interval) ** 2) * x.q},
            "qv",
            output=lambda t, x, u, p: {"V": x.v**2 + (1 + p.interval) ** 2 * x.q**2},
            outputs={"V": 1},
        ),
        "V",
    ),
    "no value in the third interval": (counting(lambda k: -(k - 3) / (k - 3)),),
    "no value for its parameters": "x' = -(x**n)*abs(x); n = 0.5",
    "V of a floor of time": (
        lag(0, lambda t, x: x**2 * (1 + np.floor(t) ** 2), "V"),
        "V",
    ),
    "wrong in a smaller region": "x' = -x*((x - 7)**2 - 1e-9)/(1 + x**2)",
    "no value at a point": "x' = -x/abs(x - 2)",
    "no value at the rest": "x' = -1/x",
    "V of sizes, a slide":  # along x = 0, where y runs off
    "x' = -2*sign(x); y' = sign(x)**2; V = abs(x) + abs(y)",
    "V of a root, a slide": "x' = -2*sign(x)*(1 + y**2); y' = sign(x)**2*y; V = sqrt(x**2)+y**2/2",
    "V that rises where a sign turns": "x' = 1 - x; V = (x - 1)**2 + (2 + sign(x))**2",
    "a pull of inf/inf": "x' = -x*cosh(x)/cosh(x)",
    "a pull of powers without a number": "x' = -x*x**80/(1 + x**80)",
    "a place outside of a table": "x' = -x*(1 + lookup([1.0, 2.0], where(x > 1e6, 5, 0))**2)",
    "V of an area cosine": "x' = 0*x; V = arccosh(x)**2 + x**2",
    "a jump that rises at no breakpoint": (
        jumping(lambda t, x, p: (1 + np.sin(np.pi * t) ** 2) * x.m),
    ),
    "a jump that would rise before the first breakpoint": (
        jumping(lambda t, x, p: np.where(p.interval < 0.5, 2.0, 0.5) * x.m),
    ),
}
BESIDE = {  # more is to be said: the conclusion, its conditions, and the system with its V
    "V of what runs with time": (
        "V does not increase",
        {"outside V": "x is", "t >= 0": ""},
        "x' = 1 + 0*x; V = (x - t)**2",
    ),
    "V that a parameter of zero lets go": (
        "goes to zero",
        {"outside V": "x is", "values": ""},
        "x' = x; y' = 0*k - y; V = (y + k*x)**2 + y**2; k = 0",
    ),
    "oscillators that agree": (
        "goes to zero",
        {"outside V": "a is"},
        "a' = sin(b - a); b' = sin(a - b); V = 1 - cos(a - b)",
    ),
    "an angle that drives": (
        "V does not increase",
        {"outside V": "th, y are"},
        f"th' = w; w' = -sin(th); y' = th - y; {TURNED}",
    ),
    "an angle whose square turns": (  # w' is bounded, however large the angle is
        "goes to zero",
        {"outside V": "th is"},
        f"th' = w; w' = -sin(th) - w*(2 + sin(th**2)); {TURNED}",
    ),
    "what runs with an angle": (
        "V does not increase",
        {"outside V": "th, q are"},
        f"th' = w; w' = -sin(th); z' = w; q' = z - q; {TURNED} + (z - th)**2",
    ),
    "V that misses a state": (
        "goes to zero",
        {"outside V": "y is"},
        "x' = -x; y' = y; V = x**2/2",
    ),
    "a jump of what V misses": (
        "goes to zero",
        {"outside V": "n is"},
        (memory(0.5, 3.0), lambda s: s.m**2),
    ),
    "V that misses two integrators": (  # eigenvalues are -1e-10 in floating point
        "goes to zero",
        {"outside V": "y, z are"},
        "x' = -x; y' = (3*y + x)/10 - 9*z/100; z' = y - 3*z/10; V = x**2/2",
    ),
    "an angle that ends": (
        "V does not increase",
        {"existence": "th"},
        f"th' = w*(1 + th**2); w' = -sin(th)*(1 + th**2); {TURNED}",
    ),
    "V of the sum alone": (
        "goes to zero",
        {"outside V, bounded": "x is"},
        "x' = -x + y**3; y' = -y - y**3; V = (x + y)**2",
    ),
    "V that misses a state that ends": (
        "square-integrable",
        {"existence": "y"},
        "x' = -x; y' = 1 + y**2; V = x**2/2",
    ),
    "V of an output that is called as its state": (  # V' = -y (y + 1) <= 1/2 - V
        "ultimately bounded",
        {},
        (lag(-1, lambda t, x: x - 1, "x"), half),
    ),
    **{
        name: ("ultimately bounded", values, text)
        for name, text, values in (
            ("a double well", "x' = 2*x - x**3", {}),  # V' = 2 x^2 - x^4 <= 4 - 2 x^2
            ("a cube that is pushed", "x' = 8 - x**3", {}),
            ("a cube beside a turn", "a' = a + b - a**3; b' = -a - b", {}),
            ("a well of parameters", "x' = a*x - b*x**3; a = 1; b = 2", {"values": ""}),
            ("a polynomial that passes zero", "x' = -x**5 + 2.0001*x**3 - x", {}),
            (
                "a polynomial that rises in a small region",
                "x' = -x*((x - 7)**2 - 1e-9)",
                {},
            ),
        )
    },
    "V of no certain sign": (  # y falls to zero where it is positive, x goes to 3
        "V does not increase",
        {"outside V, bounded": "x, y are"},
        "x' = 3 - x; y' = -y; V = (y + abs(y))**2",
    ),
}
LESS = {  # a weaker conclusion is shown
    **dict.fromkeys(
        (
            "a chain of diodes",
            "a chain of soft dampers",
            "a diode",
            "a polynomial that just stays below zero",
            "a pull of two strengths",
            "a rate that is zero on one side",
            "a sine beside squares",
            "friction of each state, and forces that do no work",
            "gain of a wave's high power",
            "gain that grows",
        ),
        "stable",
    ),
    "a higher-order tuner": "goes to zero",
    "a square of squares": "comes to rest",
    "backstepping": "all rates go to zero",
}
OF_TIME = (
    "gain of a higher wave",
    "gain of a wave's high power",
    "gain that grows",
    "V of time",
    "V of what follows a wave",
)
NEEDED = {  # conditions of right ones
    "MRAC": {"outside V, bounded": "ym is", "bounded inputs": "r is"},
    "MRAC, numbers in V": {
        "outside V, bounded": "ym is",
        "bounded inputs": "r is",
        "values": "",  # b = 3
    },
    "observer": {
        "outside V, bounded": "x1, x2 are",
        "bounded inputs": "u is",  # else x1 and x2 are not bounded
        "values": "",  # of P
    },
    "observer, P as it is solved for": {
        "outside V, bounded": "x1, x2 are",
        "bounded inputs": "u is",
        "values": "",
        "rounding": "",
    },
    "a projection": {"bounded inputs": "f is"},
    "a higher-order tuner": {"values": "", "bounded inputs": "f is"},  # b mu >= 0.8
    "a divisor of masses": {"values": ""},  # M m > c^2
    "a power that a parameter gives": {"values": ""},  # n is odd
    **{name: {"t >= 0": ""} for name in OF_TIME},
}
MISSED: dict[str, str] = {}  # what is not said as it should be
ORDER = (  # each conclusion is true where one before it is
    "asymptotically stable",
    "comes to rest",
    "all rates go to zero",
    "goes to zero",
    "square-integrable",
    "stable",
    "V does not increase",
)


class Case(NamedTuple):
    """A system, its V, and what is right to say."""

    status: str
    plant: Any
    V: Any
    more: dict  # what else `lyapunov` is given
    conclusions: tuple = ()  # true ones that are strong enough
    conditions: Any = None


def case(status, row, conclusions=(), conditions=None):
    """Make a case of what is written."""
    plant, V, *more = filled(*((row,) if isinstance(row, str) else row))
    given = dict(*more)
    return Case(status, plant, V, given, conclusions, conditions or {})


def true_of(name, strongest):
    """Conclusions from the strongest true one to the one that is shown at least."""
    least = LESS.get(name, strongest)
    return ORDER[ORDER.index(strongest) : ORDER.index(least) + 1]


CASES = {
    name: case("proved", row, true_of(name, strongest), NEEDED.get(name))
    for strongest, rows in RIGHT.items()
    for name, row in rows.items()
}
CASES |= {name: case("refuted", row) for name, row in REFUTED.items()}
CASES |= {name: case("open", row) for name, row in OPEN.items()}
CASES |= {
    name: case("proved", row, (conclusion,), conditions)
    for name, (conclusion, conditions, row) in BESIDE.items()
}
