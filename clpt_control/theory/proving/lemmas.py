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

A rotation R by 2 pi/n takes each waypoint to the next, so M = sum zc zc^T is R M R^T.  M R = R M
with sin(2 pi/n) > 0, n >= 3, leaves M = m I, and 2 m = tr M = n r^2.
"""

from typing import Any

import numpy as np
import sympy

from ...diagrams.interconnection import Diagram
from ...equations.arrays import operand
from ...equations.derivative import Direction
from ...simulation.loops import error_loop
from .array_loop import ArrayLoop
from .proof import Step, checked, cited
from .theorem_loop import (
    WIRED,
    Hedging,
    Loop,
    decay,
    known_positive,
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


def errors(loop: Loop) -> Errors:
    """Return e and eta: theta + alpha, K - KD and GammaD - Gamma."""
    p, s, car = loop.parameters, loop.states, loop.parameters["vehicle_controller"]
    first = {"e": s["x"] - s["z"], "eta_3": s["K"] - car.KD, "eta_4": car.GammaD - s["Gamma"]}
    return {**first, "eta": p["true_flow"].theta + s["alpha"]} if "alpha" in s else first


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

    return zero_step("V' <= 0: -e^T KD e is negative definite in e for KD > 0", learned_loop, rest)


def young_step() -> Step:
    """Check e d <= k e^2/2 + d^2/(2k), for the mean square."""
    k = sympy.Symbol("k", positive=True)
    e, d = sympy.symbols("e d", real=True)
    rest = k * e**2 / 2 + d**2 / (2 * k) - e * d
    return checked(
        "-k e^2 + e d <= -k e^2/2 + d^2/(2k): what is left is (k/2)(e - d/k)^2; its integral "
        "bounds the mean square",
        lambda: sympy.expand(rest - k * (e - d / k) ** 2 / 2) == 0,
    )


def error_rates(error: Errors, KD: Any, gamma: Any, phi: Any, z: Any, zc: Any) -> Errors:
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
    return error_rates(errors(loop), p["vehicle_controller"].KD, p["adaptation"].gain, *signals)


def convergence_steps() -> list[Step]:
    """Check the chain of Theorem 3.2 after V' = -e^T KD e."""

    def vehicle_stable(loop: ArrayLoop) -> list[Any]:
        car, theta = loop.parameters["vehicle_controller"], loop.parameters["true_flow"].theta
        known_positive(loop, "KD", car.KD)
        driven = (theta - car.alpha_M) @ loop.inputs["phi_x"] + car.GammaD * loop.inputs["zc"]
        return [loop.rates["x"] - (driven - car.KD * loop.states["x"])]

    def second(loop: ArrayLoop) -> list[Any]:
        KD, e = loop.parameters["vehicle_controller"].KD, loop.signals["e"]
        slope = -2 * np.sum(KD * e * loop.derivative(e))
        return [loop.derivative(rate_of_V(loop)) - slope]

    def squeezed() -> bool:
        eps, B, s = sympy.symbols("epsilon B s", positive=True)
        taken = sympy.integrate(eps - B * s, (s, 0, eps / B))
        return sympy.simplify(taken - eps**2 / (2 * B)) == 0 and bool(taken.is_positive)

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
        checked(
            "where g = -V' reaches eps, V loses int_0^(eps/B) (eps - B s) ds = eps^2/(2B) > 0: "
            "that can happen finitely often only, so V' -> 0",
            squeezed,
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
    wanted, printed = wanted_rates(loop), error_rates(parts.states, *constants, *signals)
    pairs = (loop.derivative(error) - wanted[name] for name, error in errors(loop).items())
    holds, left = vanish(loop, pairs)
    if not holds or printed.keys() != parts.rates.keys():
        return False, left
    return vanish(parts, (parts.rates[name] - rate for name, rate in printed.items()))


def observability_steps() -> list[Step]:
    """Check the algebra of Theorem 3.3."""

    def decays(parts: ArrayLoop) -> list[Any]:
        KD, gamma = parts.parameters["error_system"].KD, parts.parameters["parameter_system"].gain
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
        return [sum(np.sum(parts.rates[name] * d) for name, d in along.items()) + gamma * We]

    def filtered() -> bool:
        """Return whether variation of constants solves one axis of the injected system."""
        k, s, t, c = sympy.symbols("k s t c", positive=True)
        w, eta, e0 = sympy.Function("w"), sympy.Symbol("eta"), sympy.Symbol("e_0")
        response = sympy.Integral(sympy.exp(-k * (s - c)) * w(c), (c, t, s))
        Y = sympy.exp(-k * (s - t)) * e0 + response * eta
        rate = sympy.diff(Y, s)
        return (
            sympy.simplify((rate + k * Y - w(s) * eta).expand()) == 0 and Y.subs(s, t).doit() == e0
        )

    return [
        checked("Eqs. (27)-(28) with z eta_3 are the closed loop's e' and eta'", same_dynamics),
        zero_step("(X^T P X)' = -e^T KD e with P = diag(I, I/gamma)/2", error_diagram, decays),
        zero_step(
            "L = [0; gamma W] gives A + L C = [[-KD, W^T], [0, 0]]", error_diagram, injection
        ),
        checked(
            "the injected output is [exp(-k(s-t)) I, filtered W^T] X: the observability "
            "Gramian is int R^T R with R that row",
            filtered,
        ),
        cited(
            "a filtered regressor is exciting where W is, output injection keeps observability, "
            "and a V that falls with an observable output falls exponentially",
            "Ioannou and Sun 1996, lemmas 4.8.1 to 4.8.4, theorem 3.4.8",
        ),
    ]


def rotation_takes_each_point_to_the_next() -> bool:
    """Return whether rotating by 2 pi/n takes each point to the next, the last to the first."""
    n, rotation = sympy.Symbol("n", positive=True), sympy.rot_ccw_axis3
    a, b = sympy.symbols("a b", real=True)
    both = rotation(a + b).applyfunc(sympy.expand_trig)
    return rotation(a) * rotation(b) == both and rotation(n * (2 * sympy.pi / n)) == sympy.eye(3)


def only_multiples_of_one_commute() -> bool:
    """Return whether M = [[a, b], [b, d]] with M R = R M is a multiple of I, n > 2."""
    a, b, d, angle = sympy.symbols("a b d angle", real=True)
    M, R = sympy.Matrix([[a, b], [b, d]]), sympy.rot_ccw_axis3(angle)[:2, :2]
    moved = sympy.sin(angle) * sympy.Matrix([[-2 * b, a - d], [a - d, 2 * b]])
    m = sympy.Symbol("m", integer=True, nonnegative=True)
    step = 2 * sympy.pi / (m + 3)  # n = m + 3: between 0 and pi, where the sine is not zero
    below_pi = sympy.factor(sympy.together(sympy.pi - step))
    return sympy.expand(R * M - M * R - moved) == sympy.zeros(2) and bool(
        step.is_positive and below_pi.is_positive
    )


def circle_step() -> Step:
    """Prove the Gramian (n tau r^2/2) I of points on a circle."""
    return checked(
        "n >= 3 waypoints on a circle excite: int zc zc^T dt = (n tau r^2/2) I over a cycle",
        lambda: (
            rotation_takes_each_point_to_the_next() and only_multiples_of_one_commute(),
            "M = sum zc zc^T is the same turned by 2 pi/n, whose sine is not 0: M = m I; tr M = "
            "n r^2",
        ),
    )
