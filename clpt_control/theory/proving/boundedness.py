"""The chain behind Theorem 3.2: the signals are bounded, so e goes to zero.

    x' = (theta - alpha_M) phi - KD x + GammaD zc              Eq. (9)
    z  = x - e
    e' = -KD e + W^T eta,    V'' = -2 e^T KD e'
    g = -V' >= 0,  int g dt <= V(0),  |g'| <= B                so g -> 0

V of Eq. (24) bounds e and eta; x is bounded by Eq. (9), stable and linear in x but for
the bounded phi; z = x - e then is bounded, and so are e' and V''.  The print bounds z by
calling Eq. (8) "linear with sinusoidal inputs", which is no argument: its gains adapt.
The last line is what Barbalat's lemma says: wherever g = eps, it stays above
eps - B s for the time eps/B, which takes eps^2/(2 B) out of int g dt <= V(0).
"""

from typing import Any

import numpy as np
import sympy

from ...diagrams.interconnection import Diagram
from .array_loop import ArrayLoop
from .lyapunov import WIRED, decay, known_positive, rate_of_V, zero_step
from .proof import Step, checked
from .theorem_loop import theorem_loop

Errors = dict[str, Any]


def learned() -> Diagram:
    """Return the learned-flow law's loop."""
    return theorem_loop(WIRED, "learned-flow")


def errors(loop: ArrayLoop) -> Errors:
    """Return e and eta: theta + alpha, K - KD and GammaD - Gamma."""
    p, s, car = loop.parameters, loop.states, loop.parameters["vehicle_controller"]
    found = {"e": s["x"] - s["z"], "eta_3": s["K"] - car.KD, "eta_4": car.GammaD - s["Gamma"]}
    return {**found, "eta": p["true_flow"].theta + s["alpha"]} if "alpha" in s else found


def definite_step(law: str) -> Step:
    """Check that V is positive definite in e and the errors, every N."""
    equation = "(17)" if law == "known-flow" else "(24)"

    def rest(loop: ArrayLoop) -> list[Any]:
        p, own = loop.parameters["lyapunov"], errors(loop)
        gains = {"e": 1.0, "eta": p.gain, "eta_3": p.gain_K, "eta_4": p.gain_Gamma}
        for name in own:
            known_positive(loop, "a gain", gains[name])
        squares = (np.sum(error**2 / gains[name]) for name, error in own.items())
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

    return zero_step("V' <= 0: -e^T KD e is negative definite in e for KD > 0", learned, rest)


def young_step() -> Step:
    """Check e d <= k e^2/2 + d^2/(2k), for the mean square."""
    k = sympy.Symbol("k", positive=True)
    e, d = sympy.symbols("e d", real=True)
    rest = k * e**2 / 2 + d**2 / (2 * k) - e * d
    return checked(
        "-k e^2 + e d <= -k e^2/2 + d^2/(2k): what is left is (k/2)(e - d/k)^2; its integral "
        "bounds the mean square",
        "exact",
        lambda: sympy.expand(rest - k * (e - d / k) ** 2 / 2) == 0,
    )


def error_rates(own: Errors, KD: Any, gamma: Any, phi: Any, z: Any, zc: Any) -> Errors:
    """Return e' = -KD e + W^T eta, Eq. (27) with z eta_3, and eta' = -gamma W e, Eq. (28)."""
    e = own["e"]
    return {
        "e": -KD * e + own["eta"] @ phi + z * own["eta_3"] + zc * own["eta_4"],
        "eta": -gamma * np.outer(e, phi),
        "eta_3": -gamma * z * e,
        "eta_4": -gamma * zc * e,
    }


def wanted_rates(loop: ArrayLoop) -> Errors:
    """Return the rates of the closed loop's errors as the paper has them."""
    p, inputs = loop.parameters, loop.inputs
    given = inputs["phi_x"], loop.states["z"], inputs["zc"]
    return error_rates(errors(loop), p["vehicle_controller"].KD, p["adaptation"].gain, *given)


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

    return [
        zero_step(
            "Eq. (9): x' + KD x holds only phi and zc, so x is bounded", learned, vehicle_stable
        ),
        zero_step(
            "z = x - e, so z is bounded where x and e are",
            learned,
            lambda loop: [loop.signals["e"] - errors(loop)["e"]],
        ),
        zero_step(
            "e' = -KD e + W^T eta, products of bounded signals",
            learned,
            lambda loop: [loop.derivative(loop.signals["e"]) - wanted_rates(loop)["e"]],
        ),
        zero_step(
            "V'' = -2 e^T KD e' holds no derivative of phi or zc, so it is bounded by some B",
            learned,
            second,
        ),
        checked(
            "where g = -V' reaches eps, V loses int_0^(eps/B) (eps - B s) ds = eps^2/(2B) > 0: "
            "that can happen finitely often only, so V' -> 0",
            "exact",
            squeezed,
        ),
    ]
