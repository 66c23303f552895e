"""Adaptive laws as users write them: right ones, wrong ones, and odd ones.

u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2], section III.  A law is written as
what it changes: "K' = dK + 0.01", dK the rate of Eq. (22); the functions are NumPy's, the names
those of states, parameters and inputs, where two have one x.x, u.x or p.x.
"""

import builtins
import re
from typing import Any, NamedTuple

import numpy as np
from law_blocks import LEARNED, filled

from clpt_control import Block, lookup

N = 2
GAIN = {"gain": 0.5}
FLOW = {"flow_x": 2}
TRUTH = ("theta", "KD", "GammaD")
EPS = "(flow_x + alpha @ phi_x)"  # the flow's own prediction error
OFF = "(sum((theta + alpha)**2) + sum((K - KD)**2) + sum((Gamma - GammaD)**2))"


def first(value):
    """An array of the shape of alpha with a value at its first place."""
    return np.array([[1.0, 0.0], [0.0, 0.0]]) * value


NUMPY = vars(builtins) | vars(np) | {"lookup": lookup, "first": first}
WORD = re.compile(r"(?<![\w.])[A-Za-z_]\w*")


def formula(text, states=(), parameters=()):
    """Return a function (t, x, u, p, rates) of what is written; `dK` is the rate of K."""

    def place(found):
        name = found[0]
        if name in ("t", "x", "u", "p") or (name in NUMPY and name != "e"):
            return name
        if name[0] == "d" and name[1:] in LEARNED:
            return f"rates['{name[1:]}']"
        kind = "x" if name in states else "p" if name in parameters else "u"
        return f"{kind}.{name}"

    whole = text.replace("eps", EPS).replace("off", OFF)
    return eval(f"lambda t, x, u, p, rates=None: {WORD.sub(place, whole)}", NUMPY)


def law(update, parameters=GAIN, more=None, n=N, **ports):
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


def changed(text, parameters=GAIN, more=None, n=N, states=LEARNED, **ports):
    """Make the paper's law with rates of its own."""
    written = dict(part.split("' = ") for part in text.split("; "))
    own = {port: formula(one, states, parameters) for port, one in written.items()}

    def update(t, x, u, p):
        papers = filled(u, getattr(p, "gain", 1.0), u.e)
        rates = papers | {port: rate(t, x, u, p, papers) for port, rate in own.items()}
        return {port: rate for port, rate in rates.items() if port in states}

    return lambda: law(update, parameters, more, n, states=states, **ports)


def scaled(factor, ports=LEARNED, parameters=GAIN):
    """Make the paper's law with rates times a factor."""
    return changed(
        "; ".join(f"{port}' = ({factor})*d{port}" for port in ports), parameters
    )


def beside(rates, sizes, parameters=GAIN, **ports):
    """Make the paper's law with states of its own beside what is learned."""
    return changed(rates, parameters, states=LEARNED | sizes, **ports)


def driven(error, parameters=GAIN, **ports):
    """Make the paper's law with another error than e."""
    own = formula(error, LEARNED, parameters)

    def update(t, x, u, p):
        return filled(u, getattr(p, "gain", 1.0), own(t, x, u, p))

    return lambda: law(update, parameters, **ports)


def leak(share, ports=LEARNED, parameters=GAIN):
    """Make the paper's law with a leak of what is learned."""
    return changed(
        "; ".join(f"{port}' = d{port} - ({share})*{port}" for port in ports), parameters
    )


def seen(text, c=0.3):
    """Make the paper's law with a function of the flow's own prediction error, eps, beside."""
    return changed(f"alpha' = dalpha - c*outer({text}, phi_x)", two(c), FLOW)


def V_of(level, inputs=LEARNED, **parameters):
    """Make V of the truth, whatever vehicle and flow there are; `off` are all squared errors."""
    V = formula(level, (), {**GAIN, **dict.fromkeys(TRUTH), **parameters})
    return lambda truth: Block(
        "level",
        output=lambda t, x, u, p: {"V": V(t, x, u, p)},
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
    return {
        "alpha": alpha,
        "K": -p.gain * u.z[0] * u.e,
        "Gamma": p.gain * u.zc[:2] * u.e,
    }


def with_numbers(make, **parameters):
    """Make the same law with other numbers."""

    def changed_numbers():
        block = make()
        block.parameters = block.parameters._replace(**parameters)
        return block

    return changed_numbers


ARRAYS = {"gain": 0.5, "K": np.array([1.0, 2.0]), "z": np.array([0.1, 0.2])}
EACH, EACH_ITS_OWN = {"shapes": {"gains": "N"}}, "alpha' = -gains*outer(e, phi_x)"
MORE = {**LEARNED, "s": 1}
PLACE = "clip(floor(e[0]), 0.0, 1.0)"
FIFTH = "alpha' = dalpha*where(arange(len(phi_x)) == 4, -1.0, 1.0)"
PRIVATE = {
    "states": {"x": 2, **LEARNED},
    "outputs": LEARNED,
    "output": lambda t, x, u, p: {port: getattr(x, port) for port in LEARNED},
}

paper, turned = driven("e"), driven("-e")
constant = leak("gain*c", parameters=two(0.1))
composite = seen("eps", 0.1)
divided_by_itself = changed("K' = -gain*(z*z/z)*e")
rounded_away = driven("(e + c) - c", two(1e16))


RIGHT = {  # for every N
    "the paper's": paper,
    "its gain called rate": driven("rate*e", {"rate": 0.5}),
    "its gain called gamma": driven("gamma*e", {"gamma": 0.5}),
    "times sin^2 + cos^2": driven("(sin(e[0])**2 + cos(e[0])**2)*e"),
    "clip(e) + (e - clip(e))": driven("clip(e, -1, 1) + (e - clip(e, -1, 1))"),
    "three gains": changed(
        "alpha' = gains[0]*dalpha; K' = gains[1]*dK; Gamma' = gains[2]*dGamma",
        {"gains": [0.5, 0.2, 0.7]},
    ),
    "a gain each": changed(
        f"{EACH_ITS_OWN}; K' = -array([1.0, 2.0])*z*e; Gamma' = 0.3*zc*e",
        {"gains": [0.5, 2.0]},
        **EACH,
    ),
    "one list of gains for functions and for axes": changed(
        f"{EACH_ITS_OWN}; K' = -axes*z*e; Gamma' = axes*zc*e",
        {"gains": [1.0, 2.0], "axes": [1.0, 2.0]},
        **EACH,
    ),
    "x - z and exp(c)": driven("exp(c)*(u.x - u.z)", {"c": 0.3}, more={"x": 2}),
    "a leak of 0": with_numbers(constant, c=0.0),
    "a small gain": with_numbers(paper, gain=1e-8),
}
FOR_TWO = {  # right for N = 2, and not for every N
    "composite": with_numbers(composite, c=0.5),
    "as many gains as functions": changed(
        "alpha' = gains[0]*dalpha - (len(gains) - 2.0)*alpha; K' = gains[0]*dK; "
        "Gamma' = gains[0]*dGamma",
        {"gains": [0.5, 0.5]},
        **EACH,
    ),
    "wrong from N = 5 on": changed(FIFTH),
}
BOUNDED = {  # V' <= -e^T KD e/2 - c/2 |eta|^2 + push, eta the errors of what leaks
    "leak": (constant, "ultimately bounded"),
    "leak of alpha": (leak("gain*c", ("alpha",), two(0.1)), "bounded in the mean"),
}
REFUTED = {
    "gain -0.5": with_numbers(paper, gain=-0.5),
    "every sign flipped": turned,
    "a leak of -0.1": with_numbers(constant, c=-0.1),
    "a leak without a least value": leak("gain*c*(1 - zc[0]**2)", ("alpha",), two(0.1)),
    "composite, c = -0.5": with_numbers(composite, c=-0.5),
    "wrong from N = 5 on, N = 6": changed(FIFTH, n=6),
}
NOT_PROVED = {  # wrong, or right but not known to be
    "parameters called K and z": changed(
        "K' = dK - gain*(x.K - p.K); Gamma' = dGamma + 0.3*(u.z - p.z)", ARRAYS
    ),
    "two tables": changed(
        f"K' = dK + (lookup(p.K, {PLACE}) - lookup(p.z, {PLACE}))", ARRAYS
    ),
    "a private state called x": changed(
        "x' = -x.x; alpha' = dalpha - 0.1*(x.x - u.z)[:, None]", **PRIVATE
    ),
    "tanh(e)": driven("tanh(e)"),
    "z z/z": divided_by_itself,
    "pulled to a private state": changed(
        "alpha' = dalpha - first(gain*(alpha[0, 0] - s[0])); s' = s", states=MORE
    ),
    "pulled to the time": changed("alpha' = dalpha - first(gain*(alpha[0, 0] - t))"),
    "log(exp(e))": driven("log(exp(e))"),
    "|e| pulls alpha alone": leak("gain*c*hypot(e[0], e[1])", ("alpha",), two(0.1)),
    "a leak that fades": leak(
        "gain*c*clip(2.0 - linalg.norm(alpha), 0.0, 1.0)", ("alpha",), two(0.1)
    ),
    "a leak of any sign": leak(
        "gain*c*clip(linalg.norm(alpha) - 1.0, -1.0, 1.0)", ("alpha",), two(0.1)
    ),
    "(e + 1e16) - 1e16": rounded_away,
    "(e + 1e16) - 1e16, a small gain": with_numbers(rounded_away, gain=1e-9),
    "(e + 1e16) - 1e16, a tiny gain": with_numbers(rounded_away, gain=1e-15),
    "p.gain == 0.5": driven("where(gain == 0.5, -1.0, 1.0)*e"),
    "sign(e) == 1": driven("where(sign(e) == 1.0, 0.0, 1.0)*e"),
}
NOT_REFUTED = {  # right, or right with another V
    "projection": lambda: law(projection, two(2.0)),
    "tanh(e)": NOT_PROVED["tanh(e)"],
    "e + e^3": driven("e + e**3"),
    "a leak that grows": leak("0.1*clip(linalg.norm(alpha) - 1, 0, 1)"),
    "a memory": lambda: law(memory, two(0.3), FLOW, states={**LEARNED, "M": (2, 2)}),
}
TOO_MUCH = {  # -> what is said
    "a gain divided by zero": (
        driven("e/c", two(0.0)),
        "have no value .own.update divides by 0",
    ),
    "a power of 40": (
        changed("alpha' = dalpha + first((x[0] + x[1] + u[0] + u[1] + u[2])**40)"),
        "V' has more than 20000 terms",
    ),
    "choices of choices": (lambda: law(without_end), "own.update has more than 5000"),
    "a throw": (
        driven("e*random.default_rng().random()"),
        "^own.update: .* draws random numbers",
    ),
    "no law": (
        lambda: Block(
            "clpe",
            output=lambda t, x, u, p: {"e": u.x - u.z},
            inputs={"x": 2, "z": 2},
            outputs={"e": 2},
        ),
        r"makes alpha\[2N\], K\[2\] and Gamma\[2\]",
    ),
    "one z": (
        lambda: law(of_other_ports, GAIN, {"zc": 3, "z": 1}),
        "'zc?' has 2 signals",
    ),
    "two states of one symbol": (  # K[2] is K_1 and K_2, and so is a state K_1
        beside("K_1' = K_1", {"K_1": ()}),
        "two states are called K_1. Rename one",
    ),
    "no name": (lambda: Block("", update=memory, states=MORE), "must not be empty"),
    "a port with a dot": (driven("e", more={"a.b": 1}), "'a.b' of a block"),
}


# --- right laws of textbooks ----------------------------------------------------------------------

MATRIX = {**GAIN, "M": np.array([[2.0, 1.0], [1.0, 2.0]])}


def of_e(measure, **parameters):
    """Make V of the truth, with a measure of e."""
    return V_of(f"sum({measure}) + off/(2*gain)", **parameters)


MAPPED = {"s": (2, "N"), "K": 2, "Gamma": 2}


def through(alpha, parameters=GAIN):
    """Make a law whose alpha is made of a state s."""
    own = formula(alpha, MAPPED, parameters)

    def output(t, x, u, p):
        """alpha of s, section III."""
        return {"alpha": own(t, x, u, p), "K": x.K, "Gamma": x.Gamma, "s": x.s}

    outputs = {**LEARNED, "s": (2, "N")}
    return changed(
        "s' = dalpha", parameters, states=MAPPED, outputs=outputs, output=output
    )


def of_state(level):
    """V with a level of s for alpha's errors."""
    off = "sum((K - KD)**2) + sum((Gamma - GammaD)**2)"
    return V_of(f"e @ e/2 + (sum({level}) + ({off})/2)/gain", MAPPED)


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
WITH_R = (  # V with the information R, the inverse of P
    "e @ e/2 + (sum(((theta + alpha) @ R)*(theta + alpha))"
    " + sum((K - KD)**2) + sum((Gamma - GammaD)**2))/(2*gain)"
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


class Shown(NamedTuple):
    """A law, what else `prove` is given, and what is right to say."""

    make: Any
    more: dict
    conclusion: str
    conditions: dict  # name -> of what; N is asked apart


USUAL = {"outside V, bounded": "x is", "bounded inputs": "phi_x, zc are"}
OF_TRUE_FLOW = USUAL | {"reads the truth": "the true flow"}


def shown(make, conclusion="goes to zero", conditions=USUAL, **more):
    """A law, and the conclusion under its conditions."""
    return Shown(make, more, conclusion, conditions)


ZONES = {"gain": 0.5, "zone": np.array([0.1, 0.3])}
BEYOND, RISING = "(e - clip(e, -zone, zone))", "(2.0 - exp(-t))"
CROSSED = "K' = dK + c*zc*e; Gamma' = dGamma - c*z*e"

TEXTBOOK = {  # each with the V that proves it in two lines, or the default
    "a matrix of gains": shown(changed("alpha' = -outer(e, M @ phi_x)", MATRIX)),
    "axes mixed": shown(changed("alpha' = -outer(M @ e, phi_x)", MATRIX)),
    "gains crossed": shown(changed(CROSSED, two(0.1), n=1)),
    "tanh of eps": shown(seen("tanh(eps)"), conditions=OF_TRUE_FLOW),
    "sign of eps": shown(seen("sign(eps)"), conditions=OF_TRUE_FLOW),
    "clip of eps": shown(seen("clip(eps, -0.2, 0.2)"), conditions=OF_TRUE_FLOW),
    "a dead zone of eps": shown(
        seen("(eps - clip(eps, -0.3, 0.3))"), conditions=OF_TRUE_FLOW
    ),
    "eps exp(-eps^2)": shown(seen("eps*exp(-eps**2)"), conditions=OF_TRUE_FLOW),
    "eps and its cube": shown(seen("eps + eps**3"), conditions=OF_TRUE_FLOW),
    "tanh of e": shown(driven("tanh(e)"), V=of_e("log(cosh(e))")),
    "atan of e": shown(driven("arctan(e)"), V=of_e("e*arctan(e) - log1p(e**2)/2")),
    "clip of e": shown(
        driven("clip(e, -1.0, 1.0)"),
        V=of_e("e*clip(e, -1.0, 1.0) - clip(e, -1.0, 1.0)**2/2"),  # Huber's
    ),
    "e and its cube": shown(driven("e + e**3"), V=of_e("e**2/2 + e**4/4")),
    "the cube of e": shown(driven("e**3"), V=of_e("e**4/4")),
    "e |e|": shown(driven("e*abs(e)"), V=of_e("abs(e)**3/3")),
    "a dead zone each": shown(
        driven(BEYOND, ZONES),
        "comes to a zone",  # |Delta| <= KD zone leaves V' <= 0
        USUAL | {"truth": "|Delta_1| <= 0.1 KD_1 and |Delta_2| <= 0.3 KD_2"},
        V=of_e(f"{BEYOND}**2/2", zone=ZONES["zone"]),
    ),
    "a cubic leak": shown(
        leak("gain*c*alpha**2", ("alpha",), two(0.1)), "bounded in the mean", USUAL
    ),
    "a periodic leak": shown(
        leak("gain*c*(1 + sin(t))", LEARNED, two(0.1)),
        "bounded in the mean",
        USUAL | {"t >= 0": ""},
    ),
    "alpha = 2 s": shown(through("2*s")),
    "alpha = s + s^3": shown(
        through("s + s**3"), V=of_state("theta*s + s**2/2 + s**4/4")
    ),
    "a part in proportion to e": shown(
        through("s - c*outer(e, phi_x)", two(0.2)), V=of_state("(theta + s)**2/2")
    ),
    "a rising gain": shown(
        scaled(RISING),
        conditions=USUAL | {"t >= 0": ""},
        V=V_of(f"e @ e/2 + off/(2*gain*{RISING})"),
    ),
    "least squares": shown(
        lambda: law(least_squares, GAIN, FLOW, **SQUARES),
        # P falls and R grows as the integral of phi phi^T does, so both exist for all times
        conditions=OF_TRUE_FLOW | {"start": "R > 0"},
        V=V_of(WITH_R, {**LEARNED, "R": (N, N)}),
        invariants=inverse,
        semidefinite=("R",),
        losses=squares_lost,
    ),
}
