"""The steps behind the theorems: signals are bounded, errors are observable, a circle excites.

Theorem 3.2:

    x' = (theta - alpha_M) phi - KD x + GammaD zc              Eq. (9)
    z  = x - e
    e' = -KD e + W^T eta,    V'' = -2 e^T KD e'
    g = -V' >= 0,  int g dt <= V(0),  |g'| <= B                so g -> 0

V of Eq. (24) bounds e and eta; x is bounded by Eq. (9), stable and linear in x but for
the bounded phi; z = x - e then is bounded, and so are e' and V''.  The print bounds z by
calling Eq. (8) "linear with sinusoidal inputs", which is no argument: its gains adapt.
The last line is what Barbalat's lemma says: wherever g = eps, it stays above
eps - B s for the time eps/B, which takes eps^2/(2 B) out of int g dt <= V(0).

Theorem 3.3, X' = A(t) X of Eq. (28):

    A(t) = [[-KD, W^T], [-gamma W, 0]],  X = (e, eta),  Y = e
    P = diag(I, I/gamma)/2:   (X^T P X)' = -e^T KD e
    L = [0; gamma W]:         A + L C = [[-KD, W^T], [0, 0]]

Output injection by L keeps -KD in the first block.  Then e is W^T eta filtered by
(s I + KD)^{-1}, and (C, A) is uniformly completely observable where the JOINT regressor,
of Eq. (31), is persistently exciting (Ioannou and Sun, Robust Adaptive Control, 1996,
lemmas 4.8.1 to 4.8.4 and theorem 3.4.8, as the paper cites them).  Exponential stability
follows.

Waypoints on a circle, section IV:

    int zc zc^T dt = (n tau r^2 / 2) I            n >= 3 waypoints, one cycle

zc zc^T = (r^2/2) (I + what turns twice as fast), and of n >= 3 places the latter is a geometric sum
of q = exp(4 pi i/n), which is not 1 and whose n-th power is.
"""

from typing import Any

import numpy as np
import sympy

from ...engine.diagram.interconnection import Diagram
from ...engine.record.derivative import Direction
from ...engine.trace.arrays import operand
from ...errors import DiagramError
from ...simulation.loops import error_loop
from .proof import Step, checked, cited
from .signs import vanishes
from .symbolic_loop import ArrayLoop
from .theorem_loop import (
    WIRED,
    Hedging,
    Loop,
    decay,
    rate_of_V,
    theorem_loop,
    theorem_scenario,
    vanish,
    zero_step,
)

Errors = dict[str, Any]


def learned_loop(speed: Hedging = "no limit") -> Diagram:
    """Return the learned-flow law's loop."""
    return theorem_loop(WIRED, "learned-flow", speed=speed)


def known_positive(loop: ArrayLoop, name: str, value: Any) -> None:
    """Refuse what is not known to be positive."""
    if not all(one.is_positive for one in loop.read(value)):
        raise DiagramError(f"{name} is not known to be positive")


def errors(loop: Loop) -> Errors:
    """Return e and eta: theta + alpha, K - KD and GammaD - Gamma."""
    p, s, car = loop.parameters, loop.states, loop.parameters["vehicle_controller"]
    first = {
        "e": s["x"] - s["z"],
        "eta_3": s["K"] - car.KD,
        "eta_4": car.GammaD - s["Gamma"],
    }
    return (
        {**first, "eta": p["true_flow"].theta + s["alpha"]} if "alpha" in s else first
    )


def definite_step(law: str) -> Step:
    """Check that V is positive definite in e and the errors, every N."""
    equation = "(17)" if law == "known-flow" else "(24)"

    def rest(loop: ArrayLoop) -> list[Any]:
        p, each = loop.parameters["lyapunov"], errors(loop)
        gains = {"e": 1.0, "eta": p.gain, "eta_3": p.gain_K, "eta_4": p.gain_Gamma}
        for name in each:
            known_positive(loop, "a gain", gains[name])
        squares = (np.sum(error**2 / gains[name]) for name, error in each.items())
        return [loop.signals["V"][0] - sum(squares) / 2]

    return zero_step(
        f"V of Eq. {equation} is positive definite in e and the parameter errors, and radially "
        "unbounded: half the sum of their squares, each with a positive weight",
        lambda: theorem_loop(WIRED, law),
        rest,
    )


def dissipation_step() -> Step:
    """Check that -e^T KD e is not positive where KD > 0."""

    def rest(loop: ArrayLoop) -> list[Any]:
        known_positive(loop, "KD", loop.parameters["vehicle_controller"].KD)
        return [rate_of_V(loop) - decay(loop)]

    return zero_step(
        "V' <= 0: -e^T KD e is negative definite in e for KD > 0", learned_loop, rest
    )


def algebra_step(claim: str, *residuals: str) -> Step:
    """Check that expressions are zero, whatever numbers their letters are."""
    return checked(claim, lambda: all(map(vanishes, residuals)))


def young_step() -> Step:
    """Check e d <= k e^2/2 + d^2/(2k), for the mean square."""
    return algebra_step(
        "-k e^2 + e d <= -k e^2/2 + d^2/(2k): what is left is (k/2)(e - d/k)^2; its integral "
        "bounds the mean square",
        "k*e**2/2 + d**2/(2*k) - e*d - k*(e - d/k)**2/2",
    )


def error_rates(
    error: Errors, KD: Any, gamma: Any, phi: Any, z: Any, zc: Any
) -> Errors:
    """Return e' = -KD e + W^T eta, Eq. (27) with z eta_3, and eta' = -gamma W e, Eq. (28)."""
    e = error["e"]
    return {
        "e": -KD * e + error["eta"] @ phi + z * error["eta_3"] + zc * error["eta_4"],
        "eta": -gamma * np.outer(e, phi),
        "eta_3": -gamma * z * e,
        "eta_4": -gamma * zc * e,
    }


def wanted_rates(loop: Loop, before_eta_3: str = "z") -> Errors:
    """Return the rates of the closed loop's errors as the paper has them, z eta_3 in e'."""
    p, inputs = loop.parameters, loop.inputs
    signals = inputs["phi_x"], loop.states[before_eta_3], inputs["zc"]
    return error_rates(
        errors(loop), p["vehicle_controller"].KD, p["adaptation"].gain, *signals
    )


def convergence_steps() -> list[Step]:
    """Check the chain of Theorem 3.2 after V' = -e^T KD e."""

    def vehicle_stable(loop: ArrayLoop) -> list[Any]:
        car, theta = (
            loop.parameters["vehicle_controller"],
            loop.parameters["true_flow"].theta,
        )
        known_positive(loop, "KD", car.KD)
        driven = (theta - car.alpha_M) @ loop.inputs[
            "phi_x"
        ] + car.GammaD * loop.inputs["zc"]
        return [loop.rates["x"] - (driven - car.KD * loop.states["x"])]

    def second(loop: ArrayLoop) -> list[Any]:
        KD, e = loop.parameters["vehicle_controller"].KD, loop.signals["e"]
        slope = -2 * np.sum(KD * e * loop.derivative(e))
        return [loop.derivative(rate_of_V(loop)) - slope]

    residuals = {
        "Eq. (9): x' + KD x holds only phi and zc, so x is bounded": vehicle_stable,
        "z = x - e, so z is bounded where x and e are": lambda loop: [
            loop.signals["e"] - errors(loop)["e"]
        ],
        "e' = -KD e + W^T eta, products of bounded signals": lambda loop: [
            loop.derivative(loop.signals["e"]) - wanted_rates(loop)["e"]
        ],
        "V'' = -2 e^T KD e' holds no derivative of phi or zc, so it is bounded by some B": second,
    }
    return [
        *(zero_step(claim, learned_loop, rest) for claim, rest in residuals.items()),
        algebra_step(
            "where g = -V' reaches eps, V loses int_0^(eps/B) (eps - B s) ds = eps^2/(2B) > 0: "
            "that can happen finitely often only, so V' -> 0",
            "integrate(eps - B*s, (s, 0, eps/B)) - eps**2/(2*B)",
        ),
    ]


def error_diagram() -> Diagram:
    """Return the error and parameter systems, Eqs. (27)-(28)."""
    return error_loop(theorem_scenario(WIRED, "learned-flow"))


def same_dynamics() -> tuple[bool, str]:
    """Return whether Eqs. (27)-(28) are the closed loop's own, and the error system's, every N."""
    loop, parts = ArrayLoop(learned_loop()), ArrayLoop(error_diagram())
    p, signals = parts.parameters, (parts.inputs[port] for port in ("phi_x", "z", "zc"))
    constants = p["error_system"].KD, p["parameter_system"].gain
    wanted, printed = (
        wanted_rates(loop),
        error_rates(parts.states, *constants, *signals),
    )
    pairs = (
        loop.derivative(error) - wanted[name] for name, error in errors(loop).items()
    )
    holds, left = vanish(loop, pairs)
    if not holds or printed.keys() != parts.rates.keys():
        return False, left
    return vanish(parts, (parts.rates[name] - rate for name, rate in printed.items()))


def observability_steps() -> list[Step]:
    """Check the algebra of Theorem 3.3."""

    def decays(parts: ArrayLoop) -> list[Any]:
        KD, gamma = (
            parts.parameters["error_system"].KD,
            parts.parameters["parameter_system"].gain,
        )
        squares = {name: np.sum(state**2) for name, state in parts.states.items()}
        e = squares.pop("e")
        V = (e + sum(squares.values()) / gamma) / 2
        return [parts.derivative(V) + np.sum(KD * parts.states["e"] ** 2)]

    def injection(parts: ArrayLoop) -> list[Any]:
        """Return eta' + gamma W e along any d, W^T d read off e': e^T W^T d = (W e)^T d."""
        gamma, e = parts.parameters["parameter_system"].gain, parts.states["e"]
        along = {name: parts.direction(name) for name in parts.states if name != "e"}
        directions = {operand(parts.states[name]): d for name, d in along.items()}
        We = e @ Direction(parts.tape, directions).of(parts.rates["e"])
        return [
            sum(np.sum(parts.rates[name] * d) for name, d in along.items()) + gamma * We
        ]

    return [
        checked(
            "Eqs. (27)-(28) with z eta_3 are the closed loop's e' and eta'",
            same_dynamics,
        ),
        zero_step(
            "(X^T P X)' = -e^T KD e with P = diag(I, I/gamma)/2", error_diagram, decays
        ),
        zero_step(
            "L = [0; gamma W] gives A + L C = [[-KD, W^T], [0, 0]]",
            error_diagram,
            injection,
        ),
        algebra_step(
            "the injected output is [exp(-k(s-t)) I, filtered W^T] X: the observability "
            "Gramian is int R^T R with R that row",
            # Y = exp(-k (s - t)) e_0 + f eta has Y' = -k Y + w eta, where f' = -k f + w
            "diff(exp(-k*(s - t))*e_0, s) + (-k*f + w)*eta + k*(exp(-k*(s - t))*e_0 + f*eta)"
            " - w*eta",
        ),
        cited(
            "a filtered regressor is exciting where W is, output injection keeps observability, "
            "and a V that falls with an observable output falls exponentially",
            "Ioannou and Sun 1996, lemmas 4.8.1 to 4.8.4, theorem 3.4.8",
        ),
    ]


def circle_step() -> Step:
    """Prove the Gramian (n tau r^2/2) I of points on a circle."""

    def excites() -> tuple[bool, str]:
        n, m = (sympy.Symbol(name, integer=True, nonnegative=True) for name in "nm")
        a, q = sympy.Symbol("a", real=True), sympy.Symbol("q")
        zc = sympy.Matrix([sympy.cos(a), sympy.sin(a)])
        c, s = sympy.cos(2 * a), sympy.sin(2 * a)
        doubled = zc * zc.T - sympy.Matrix([[1 + c, s], [s, 1 - c]]) / 2
        geometric = (q**n - 1) / (q - 1)
        more = geometric.subs(n, n + 1) - geometric - q**n
        closed = sympy.exp(4 * sympy.pi * sympy.I / (m + 3)) ** (m + 3) - 1
        below_a_turn = sympy.factor(1 - 2 / (m + 3))  # so q is not 1
        zero = *sympy.simplify(doubled), sympy.simplify(more), closed
        return not any(zero) and bool(below_a_turn.is_positive), (
            "zc zc^T = (r^2/2) (I + [[cos 2a, sin 2a], [sin 2a, -cos 2a]]), and sum exp(2 i a) is "
            "(q^n - 1)/(q - 1) = 0 with q = exp(4 pi i/n)"
        )

    claim = "n >= 3 waypoints on a circle excite: int zc zc^T dt = (n tau r^2/2) I over a cycle"
    return checked(claim, excites)
