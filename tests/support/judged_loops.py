"""Sixty right and sixty wrong loops: equations, V, and every conclusion that is true of them.

A row is what `text_systems.written` reads, or a system with its V, then the strongest true
conclusion, and if need be conditions without which it is false (`needs`), and what does not go to
zero (`never`).  A wrong row has no true conclusion, or weaker ones than it seems to have.
"""

from typing import Any, NamedTuple

import control
import numpy as np
from text_systems import TICKS, signals, written

import clpt_control as clpt

FALLS = "V does not increase"
TRUE = {  # a conclusion -> what is true with it
    "asymptotically stable": "comes to rest|all rates go to zero|goes to zero|"
    "square-integrable|stable",
    "comes to rest": "all rates go to zero|goes to zero|square-integrable|stable",
    "all rates go to zero": "goes to zero|square-integrable|stable",
    "goes to zero, stable": "goes to zero|square-integrable|stable",
    "square-integrable": "stable",
    "stable": "",
    "partly": "square-integrable|goes to zero",  # other states than those of V may go anywhere
    "ultimately bounded": "bounded|bounded in the mean",
    "asymptotically stable in a region": "",
    FALLS: "",
    "V' is at most the claim": "",
    "": "",
}


class Loop(NamedTuple):
    """A system, its V, what else `lyapunov` is given, and what is true."""

    plant: Any
    V: Any
    more: dict
    true: frozenset
    needs: tuple = ()
    never: tuple = ()


def loop(case, strongest="", needs=(), never=(), **more):
    """Make a loop of a row."""
    plant, V, *rest = written(case) if isinstance(case, str) else case
    extra = {FALLS} if strongest and "region" not in strongest else set()
    extra -= {FALLS} if strongest == "ultimately bounded" else set()
    true = frozenset({strongest, *TRUE[strongest].split("|"), *extra} - {"", "partly"})
    return Loop(plant, V, dict(*rest) | more, true, needs, never)


def block(rates, states, V=None, **more):
    """A block of these rates, one number a state, and V of its squares if none is given."""
    made = clpt.Block("plant", update=rates, states=dict.fromkeys(states, 1), **more)
    return made, V or signals(None, [*states])


def ticking(rates, jump, states, V=None):
    """A block whose states jump at whole times."""
    return block(rates, states, V, jump=jump, **TICKS)


def sampled(update, states, V=None, inputs=0, **params):
    """A system of discrete time."""
    made = control.nlsys(
        lambda t, x, u, p: update(x, u, p),
        states=[*states],
        inputs=inputs,
        params=params,
        dt=0.1,
        name="plant",
    )
    return made, V or signals(None, [*states])


def squared(s):
    return s.x**2


def delayed(lag):
    """x' = -x(t - lag), of which V is searched for."""
    late = clpt.parts.delay(lag, 1)
    names = {"inputs": late.output_labels[0], "outputs": late.input_labels[0]}
    return clpt.connect([control.ss(0, -1, 1, 0, name="plant", **names), late]), None


def closed(A):
    """A linear system without inputs."""
    n = len(A)
    return control.ss(A, np.zeros((n, 0)), np.eye(n), np.zeros((n, 0)), name="linear")


AS, REST, UB = "asymptotically stable", "comes to rest", "ultimately bounded"
ZERO = "goes to zero, stable"  # V holds all states
REGION = "asymptotically stable in a region"
E, BEYOND = "V = e**2/2 + th**2/2; input r", "(e - clip(e, -0.1, 0.1))"
PENDULUM = "V = w**2/2 + 1 - cos(th)"
STOPPED = "where((th > 3) & (-e*r > 0), 0.0, -e*r)"
BOXED = "where(th >= 3, minimum(-e*r, 0), where(th <= -3, maximum(-e*r, 0), -e*r))"
DUFFING = "V = v**2/2 + x**2/2 + x**4/4"

RIGHT = {
    "two states that turn and fall": loop("x' = -2*x + y; y' = -x - 3*y", AS),
    "a mass, a spring and a damper": loop("x' = v; v' = -x - 0.5*v", AS),
    "a pendulum with friction": loop(f"th' = w; w' = -sin(th) - 0.3*w; {PENDULUM}", REST),
    "a pendulum with friction of air": loop(
        f"th' = w; w' = -sin(th) - w*abs(w); {PENDULUM}", REST
    ),
    "a cube": loop("x' = -x**3", AS),
    "a cascade": loop("x' = -x - x**3; y' = -y + x", AS),
    "P of A'P + PA = -I": loop(
        "x' = y; y' = -2*x - 3*y; V = 1.25*x**2 + x*y/2 + y**2/4", AS
    ),
    "damping between 1 and 3": loop("x' = v; v' = -x - (2 + sin(t))*v", AS),
    "damping that grows": loop(  # x stands still in the end, off its rest
        "x' = v; v' = -x - (2 + exp(t))*v", ZERO, never=("x",)
    ),
    "an adaptive gain": loop(
        "e' = -2*e + k*r; k' = -3*e*r; V = e**2/2 + k**2/6; input r", ZERO,
        needs=("bounded inputs",), never=("k",),
    ),
    "an adaptive gain of its own weight": loop(
        "e' = -e + th*r; th' = -g*e*r; g = 0.3; V = e**2/2 + th**2/(2*g); input r", ZERO,
        needs=("bounded inputs",), never=("th",),
    ),
    "a gain that rises to 2": loop(
        "e' = -e + th*r; th' = -(2 - exp(-t))*e*r; V = e**2/2 + th**2/(2*(2 - exp(-t))); input r",
        ZERO, needs=("bounded inputs", "t >= 0"), never=("th",),
    ),
    "a projection that stops": loop(
        f"e' = -e + th*r; th' = {STOPPED}; {E}", ZERO, never=("th",)
    ),
    "a projection onto a box": loop(
        f"e' = -e + th*r; th' = {BOXED}; {E}", ZERO, never=("th",)
    ),
    "a projection that turns back": loop(
        f"e' = -e + th*r; th' = -e*r - 2*(th - clip(th, -3, 3)); {E}", ZERO, never=("th",)
    ),
    "a dead zone in the law": loop(
        f"e' = -e + th*r; th' = -{BEYOND}*r; V = {BEYOND}**2/2 + th**2/2; input r", ZERO,
        needs=("bounded inputs",), never=("th",),
    ),
    "a leak to the truth": loop(f"e' = -e + th*r; th' = -e*r - 0.1*th; {E}", AS),
    "a leak to a guess": loop(f"e' = -e + th*r; th' = -e*r - 0.2*(th + 1); {E}", UB),
    "a leak that grows with e": loop(
        f"e' = -e + th*r; th' = -e*r - 0.1*abs(e)*(th + 1); {E}", UB
    ),
    "a leak that switches on": loop(
        f"e' = -e + th*r; th' = -e*r - where(abs(th) > 2, 0.5, 0.0)*th; {E}", ZERO, never=("th",)
    ),
    "a normalised law": loop(
        f"e' = -e + th*r/(1 + r**2); th' = -e*r/(1 + r**2); {E}", ZERO, never=("th",)
    ),
    "a gradient estimator of a sine": loop("th' = -sin(t)**2*th", AS),
    "Lorenz's equations": loop(
        "a' = 10*(b - a); b' = 0.5*a - b - a*c; c' = a*b - 8/3*c; V = a**2/10 + b**2 + c**2", AS
    ),
    "a body that spins freely": loop(
        "x' = -y*z; y' = z*x; z' = -x*y/3; V = x**2/2 + y**2 + 1.5*z**2", "stable"
    ),
    "an oscillator": loop("x' = y; y' = -x", "stable"),
    "a hard spring": loop(f"x' = v; v' = -x - x**3 - 0.2*v; {DUFFING}", AS),
    "two wells": loop("x' = v; v' = x - x**3 - v; V = v**2/2 + (x**2 - 1)**2/4", REST),
    "a force that is limited": loop(
        "x' = v; v' = -clip(x, -1, 1) - v; "
        "V = v**2/2 + where(abs(x) <= 1, x**2/2, abs(x) - 0.5)", AS
    ),
    "neurons": loop("x' = -x + 0.5*tanh(y); y' = -y - 0.5*tanh(x)", AS),
    "an angle that falls down its cosine": loop("x' = -sin(x); V = 1 - cos(x)", REST),
    "three that agree": loop(
        "a' = b - a; b' = a + c - 2*b; c' = b - c", REST, never=("a", "b", "c")
    ),
    "two that agree, V of the difference": loop(
        "a' = b - a; b' = a - b; V = (a - b)**2", "partly", needs=("outside V",)
    ),
    "a PI controller": loop("x' = -x + z; z' = -x", AS),
    "a lag with an input": loop("x' = -x + u; input u", AS, needs=("zero inputs",)),
    "friction of two strengths": loop("x' = -where(x > 0, 2.0, 1.0)*x", AS),
    "dry friction": loop("v' = -v - sign(v)", AS),
    "a barrier": loop("x' = -x/(1 + x**2) - x**3; V = x**2", AS),
    "a delay of a second": loop(delayed(1.0), AS, needs=("approximation",)),
    "a memory that halves": loop(
        ticking(lambda t, x, u, p: {"x": -x.x}, lambda t, x, u, p: {"x": x.x / 2}, "x"), AS
    ),
    "a state that is reset": loop(
        ticking(
            lambda t, x, u, p: {"x": -x.x, "s": 0 * x.s},
            lambda t, x, u, p: {"x": x.x, "s": x.s / 2}, "xs",
        ),
        AS,
    ),
    "a state that turns at jumps": loop(
        ticking(
            lambda t, x, u, p: {"x": x.y - x.x, "y": -x.x - x.y},
            lambda t, x, u, p: {"x": x.y, "y": -x.x}, "xy",
        ),
        AS,
    ),
    "a rate that dies like 1/t": loop("x' = -x/(1 + t)", AS, needs=("t >= 0",)),
    "a rate that dies in time": loop("x' = -x*exp(-t)", "stable", needs=("t >= 0",)),
    "V of time": loop("x' = -x - exp(-t)*y; y' = x - y; V = x**2 + (1 + exp(-t))*y**2", AS,
                      needs=("t >= 0",)),
    "discrete: half": loop(sampled(lambda x, u, p: [x[0] / 2], "x"), AS),
    "discrete: a turn": loop(sampled(lambda x, u, p: [x[1], -x[0]], "xy"), "stable"),
    "discrete: a turn that loses half": loop(
        sampled(lambda x, u, p: [x[1], -x[0] / 2], "xy"), AS
    ),
    "discrete: a tanh": loop(sampled(lambda x, u, p: [0.5 * np.tanh(x[0])], "x"), AS),
    "discrete: a normalised step": loop(
        sampled(
            lambda x, u, p: [x[0] - p["g"] * u[0] ** 2 / (1 + u[0] ** 2) * x[0]], "x",
            inputs=["r"], g=1.0,
        ),
        "partly",  # what is lost goes to zero
    ),
    "discrete: two that agree": loop(
        sampled(lambda x, u, p: [(x[0] + x[1]) / 2, (x[0] + x[1]) / 2], "xy",
                lambda s: (s.x - s.y) ** 2), "partly", needs=("outside V",)
    ),
    "discrete: a state beside": loop(
        sampled(lambda x, u, p: [x[0] / 2, 3 * x[1]], "xy", squared), "partly", needs=("outside V",)
    ),
    "discrete: a rest of 2": loop(
        sampled(lambda x, u, p: [x[0] / 2 + 1], "x", lambda s: (s.x - 2) ** 2), AS, at={"x": 2}
    ),
    "a region that a cube ends": loop("x' = -x + x**3", REGION, within={"x": (-2, 2)}),
    "a region of a pendulum": loop(
        f"th' = w; w' = -sin(th) - w; {PENDULUM}", REGION, within={"th": (-2, 2), "w": (-2, 2)}
    ),
    "a region of two states": loop(
        "x' = -x + x*y; y' = -y", REGION, within={"x": (-1, 1), "y": (-1, 1)}
    ),
    "a claim that is weaker": loop("x' = -2*x", AS, claim=lambda s: -(s.x**2)),
    "a rest elsewhere": loop("x' = 3 - x; V = (x - 3)**2; at x = 3", AS),
    "an arm of two sines": loop(
        "a' = v; b' = w; v' = -sin(a) - v; w' = -2*sin(b) - w; "
        "V = (v**2 + w**2)/2 + 3 - cos(a) - 2*cos(b)", REST
    ),
    "a cross term that is small": loop("x' = -x + 0.3*sin(y); y' = -y + 0.3*sin(x)", AS),
    "a higher power": loop("x' = -x**5; y' = -y**5; V = x**6 + y**6 - x**3*y**3", AS),
}  # fmt: skip

WRONG = {
    "a lag that grows": loop("x' = x"),
    "a cube that grows": loop("x' = x**3"),
    "a saddle": loop("x' = -x; y' = y"),
    "van der Pol": loop("x' = y; y' = -x + (1 - x**2)*y", "ultimately bounded"),
    "Rayleigh's friction": loop("x' = y; y' = -x + y - y**3", "ultimately bounded"),
    "an adaptive gain of the wrong sign": loop(f"e' = -e + th*r; th' = e*r; {E}"),
    "a wrong weight": loop("e' = -e + 3*th*r; th' = -2*e*r; V = e**2/2 + th**2/2; input r"),
    "a leak that feeds": loop(f"e' = -e + th*r; th' = -e*r + 0.1*th; {E}"),
    "a projection that stops what comes back": loop(
        f"e' = -e + th*r; th' = where((th > 3) & (-e*r < 0), 0.0, -e*r); {E}"
    ),
    "a projection that keeps from the truth": loop(
        f"e' = -e + th*r; th' = where((th > -2) & (-e*r > 0), 0.0, -e*r); {E}",
        ZERO, needs=("zero inputs",),  # else a push that V' outgrows
    ),
    "a projection outward": loop(
        f"e' = -e + th*r; th' = -e*r + 2*(th - clip(th, -3, 3)); {E}"
    ),
    "a dead zone that V does not have": loop(
        f"e' = -e + th*r; th' = -{BEYOND}*r; {E}", "comes to rest", needs=("zero inputs",)
    ),
    "a dead zone that is missed in the law": loop(
        f"e' = -e + th*r; th' = -e*r; V = {BEYOND}**2/2 + th**2/2; input r",
        ZERO, needs=("zero inputs",),
    ),
    "a leak to a guess, said to be at rest": loop(
        f"e' = -e + th*r; th' = -e*r - 0.2*(th + 1); {E}", UB
    ),
    "a product that is lost": loop(  # on y = 0 a and b turn at the speed x
        "x' = -x*y**2; y' = -y*x**2; a' = b*x; b' = -a*x", ZERO, never=("x", "y", "a", "b")
    ),
    "an estimator of a regressor that may be pulses": loop(  # ever narrower ones of height 1
        "th' = -r**2*th; input r", "square-integrable"
    ),
    "an estimator of two regressors": loop(
        "a' = -r*(r*a + s*b); b' = -s*(r*a + s*b); input r; input s", "square-integrable"
    ),
    "a gain that turns with time": loop("x' = -(0.5 + sin(t))*x"),
    "a gain that turns at t = 50": loop("x' = -(1 - t/50)*x"),
    "a falling gain in V": loop(
        "e' = -e + th*r; th' = -(1 + exp(-t))*e*r; "
        "V = e**2/2 + th**2/(2*(1 + exp(-t))); input r"
    ),
    "a V that grows too fast": loop("x' = -0.25*x/(1 + t); V = x**2*(1 + t)"),
    "V that fades": loop("x' = x/4; V = exp(-t)*x**2"),
    "V without a sign": loop("x' = -x; y' = y; V = x**2 - y**2"),
    "V turned": loop("x' = x; V = -x**2"),
    "V that is bounded": loop("x' = y; y' = x - y; V = x**2/(1 + x**2) + y**2"),
    "V of one state alone": loop("x' = -x; y' = y; V = x**2", "partly", needs=("outside V",)),
    "V of one state, the other ends": loop(
        "x' = -x; y' = 1 + y**2; V = x**2", "square-integrable", needs=("existence",)
    ),
    "V of a sum": loop("x' = x - y; y' = -3*x + y; V = (x + y)**2"),
    "V of an angle that turns without end": loop(
        "th' = 1 + 0*th; x' = -x; V = x**2", "partly", needs=("outside V",)
    ),
    "one of two masses is damped": loop(
        "x' = v; v' = -x - v; p' = q; q' = -p", ZERO, never=("p", "q")
    ),
    "two equal masses, damped by their difference": loop(  # their mean swings on
        "x' = v; p' = q; v' = -x - (v - q); q' = -p - (q - v)", ZERO,
        never=("x", "p"),
    ),
    "two pendulums, one damped": loop(
        "a' = v; b' = w; v' = -sin(a) - v; w' = -sin(b); "
        "V = (v**2 + w**2)/2 + 2 - cos(a) - cos(b)", ZERO, never=("w",)
    ),
    "damping that dies": loop("x' = v; v' = -x - v*exp(-t)", "stable", needs=("t >= 0",)),
    "damping that dies like 1/t^2": loop("x' = v; v' = -x - v/(1 + t)**2", "stable"),
    "dry friction that sticks": loop(  # anywhere from -0.2 to 0.2
        "x' = v; v' = -x - v - 0.2*sign(v)", ZERO, never=("x",)
    ),
    "a valve that opens on one side": loop(
        "x' = -maximum(x, 0)", "comes to rest", never=("x",)
    ),
    "a dead band": loop("x' = -(x - clip(x, -1, 1))", "comes to rest", never=("x",)),
    "a switch that is off near the rest": loop(
        "x' = -where(abs(x) > 1, x, 0.0)", "comes to rest", never=("x",)
    ),
    "a counter": loop("x' = -floor(x)", "comes to rest", never=("x",)),
    "a gain of zero": loop("x' = -k*x; k = 0", "stable"),
    "a gain below zero": loop("x' = -k*x; k = -1"),
    "an even power": loop("x' = -x**n; n = 2"),
    "a sine far off": loop("x' = -sin(x)"),
    "a cosine": loop("x' = -x*cos(x)"),
    "a sine too strong": loop("x' = -x + 2*sin(x)", "ultimately bounded"),
    "a tanh too weak": loop("x' = -tanh(x) + x/2"),
    "a size": loop("x' = -abs(x)"),
    "a square": loop("x' = -x**2"),
    "a loop gain above 1": loop("x' = -x + y; y' = 2*x - y"),
    "a drift": loop("x' = 1 + 0*x"),
    "a rest that V does not have": loop("x' = 3 - x", UB),
    "a jump that doubles": loop(
        ticking(lambda t, x, u, p: {"x": -0.1 * x.x}, lambda t, x, u, p: {"x": 2 * x.x}, "x")
    ),
    "a jump that adds": loop(
        ticking(lambda t, x, u, p: {"x": -x.x}, lambda t, x, u, p: {"x": x.x + 1}, "x")
    ),
    "a state that grows and is cut": loop(  # by 4 in each second: V rises in between
        ticking(lambda t, x, u, p: {"x": x.x}, lambda t, x, u, p: {"x": x.x / 4}, "x")
    ),
    "a jump of what V misses": loop(
        ticking(
            lambda t, x, u, p: {"x": -x.x, "y": -x.y},
            lambda t, x, u, p: {"x": x.x, "y": 9 * x.y}, "xy", squared,
        ),
        "partly", needs=("outside V",),
    ),
    "a delay of two seconds": loop(delayed(1.9), AS, needs=("approximation",)),
    "discrete: 1.1": loop(sampled(lambda x, u, p: [1.1 * x[0]], "x")),
    "discrete: -1.01": loop(sampled(lambda x, u, p: [-1.01 * x[0]], "x")),
    "discrete: a turn that gains": loop(sampled(lambda x, u, p: [x[1], -1.2 * x[0]], "xy")),
    "discrete: a step too long": loop(
        sampled(
            lambda x, u, p: [x[0] - p["g"] * u[0] ** 2 / (1 + u[0] ** 2) * x[0]], "x",
            inputs=["r"], g=2.5,
        ),
        "stable", needs=("zero inputs",),
    ),
    "discrete: 2 tanh": loop(sampled(lambda x, u, p: [2 * np.tanh(x[0])], "x"), UB),
    "discrete: a cube": loop(sampled(lambda x, u, p: [x[0] + x[0] ** 3], "x")),
    "discrete: one state turns on": loop(
        sampled(lambda x, u, p: [x[0] / 2, x[2], -x[1]], "xyz"), ZERO,
        never=("y", "z"),
    ),
    "a region of what grows": loop("x' = x", within={"x": (-1, 1)}),
    "a region without a rest": loop("x' = 1 - x", within={"x": (-2, 2)}),
    "a region with a drift": loop("x' = -x; y' = 0.1*y", within={"x": (-1, 1), "y": (-1, 1)}),
    "a region in which one state stands": loop(
        "x' = -x; y' = 0*y", within={"x": (-1, 1), "y": (-1, 1)}
    ),
    "a claim beyond V'": loop("x' = -x/2", claim=lambda s: -(s.x**2)),
    "a claim of zero": loop("x' = x", claim=0),
    "the upper pendulum": loop(f"th' = w; w' = sin(th) - w; {PENDULUM}"),
}  # fmt: skip
