"""Theorem 3.3: X' = A(t) X of Eq. (28), read off the blocks that run.

    A(t) = [[-KD, W^T], [-gamma W, 0]],  X = (e, eta),  Y = e
    P = diag(I, I/gamma)/2:   (X^T P X)' = -e^T KD e
    L = [0; gamma W]:         A + L C = [[-KD, W^T], [0, 0]]

Output injection by L keeps -KD in the first block.  Then e is W^T eta filtered by
(s I + KD)^{-1}, and (C, A) is uniformly completely observable where the JOINT regressor,
of Eq. (31), is persistently exciting (Ioannou and Sun, Robust Adaptive Control, 1996,
lemmas 4.8.1 to 4.8.4 and theorem 3.4.8, as the paper cites them).  Exponential stability
follows.
"""

from typing import Any

import numpy as np
import sympy

from ...diagrams.interconnection import Diagram
from ...equations.arrays import operand
from ...equations.derivative import derivative
from ...simulation.loops import error_loop
from .array_loop import ArrayLoop, array_loop
from .boundedness import Errors, error_rates, errors, learned, wanted_rates
from .lyapunov import WIRED, vanish, zero_step
from .proof import Step, checked, cited
from .theorem_loop import theorem_scenario


def error_diagram() -> Diagram:
    """Return the error and parameter systems, Eqs. (27)-(28)."""
    return error_loop(theorem_scenario(WIRED, "learned-flow"))


def own_rates(parts: ArrayLoop) -> Errors:
    """Return what Eqs. (27)-(28) say of the states of the error system."""
    p, inputs = parts.parameters, parts.inputs
    given = inputs["phi_x"], inputs["z"], inputs["zc"]
    return error_rates(parts.states, p["error_system"].KD, p["parameter_system"].gain, *given)


def same_dynamics() -> tuple[bool, str]:
    """Return whether Eqs. (27)-(28) are the closed loop's own, and the error system's, every N."""
    loop, parts = array_loop(learned()), array_loop(error_diagram())
    wanted, own = wanted_rates(loop), own_rates(parts)
    pairs = (loop.derivative(error) - wanted[name] for name, error in errors(loop).items())
    holds, said = vanish(loop, pairs)
    if not holds or own.keys() != parts.rates.keys():
        return False, said
    return vanish(parts, (parts.rates[name] - rate for name, rate in own.items()))


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
        seen = {operand(parts.states[name]): d for name, d in along.items()}
        We = e @ derivative(parts.tape, parts.rates["e"], seen)
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
        checked(
            "Eqs. (27)-(28) with z eta_3 are the closed loop's e' and eta'", "exact", same_dynamics
        ),
        zero_step("(X^T P X)' = -e^T KD e with P = diag(I, I/gamma)/2", error_diagram, decays),
        zero_step(
            "L = [0; gamma W] gives A + L C = [[-KD, W^T], [0, 0]]", error_diagram, injection
        ),
        checked(
            "the injected output is [exp(-k(s-t)) I, filtered W^T] X: the observability "
            "Gramian is int R^T R with R that row",
            "exact",
            filtered,
        ),
        cited(
            "a filtered regressor is exciting where W is, output injection keeps observability, "
            "and a V that falls with an observable output falls exponentially",
            "Ioannou and Sun 1996, lemmas 4.8.1 to 4.8.4, theorem 3.4.8",
        ),
    ]
