"""Error system of adaptive control, read from V of a verdict and the equations, exactly.

    e' = A e + W th,  th' = -G W^T P e,  P A + A^T P = -Q
    V = (e^T P e + th^T G^-1 th) / 2,      V' = -e^T Q e / 2

e has independent forms of the states in V', th the other states of V, each less the value at which
V is least.  W may depend on all signals: along a run it is a function of time.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy
from scipy.integrate import cumulative_trapezoid
from sympy import Matrix

from ...base.errors import DataError, DiagramError
from ...engine.diagram.symbol_names import TIME, element_name
from ...simulation.comparison import STATES
from ..algebra.exact import normal_form, vanishes
from ..algebra.texts import short

SOLVED = 1e-4  # share of a state by which a run may miss the equations


@dataclass(frozen=True)
class ErrorSystem:
    """The loop in errors, exact, and coordinates in which V = |.|^2 / 2."""

    names: list[str]  # of th
    W: Matrix  # (m, n), in symbols
    A: Matrix
    left: np.ndarray  # of e in them; W is left W right
    right: np.ndarray
    rates: dict[Any, Any]  # of all states in the loop's order
    inputs: dict[str, Any]  # name -> symbol

    def along(self, run: Any, signals: dict[str, np.ndarray]) -> np.ndarray:
        """Return W (times, m, n) along a run, which must follow the equations."""
        times, states = run.time.values, np.asarray(run.get(STATES, np.empty((1, 0))))
        if states.shape[1] != len(self.rates) or {*self.inputs} - {*signals}:
            raise DataError(
                "of: must be a verdict on the loop of this run, with its states"
            )
        symbols = TIME, *self.rates, *self.inputs.values()
        values_of = sympy.lambdify(symbols, [*self.rates.values(), *self.W])
        found = values_of(times, *states.T, *(signals[name] for name in self.inputs))
        columns = np.transpose([np.broadcast_to(x, times.shape) for x in found])
        rates, W = np.split(columns, [len(self.rates)], axis=1)

        def missed(every: int) -> np.ndarray:
            """Changes over two intervals, less the rates by the trapezoidal rule."""
            spent = cumulative_trapezoid(
                rates[::every], times[::every], axis=0, initial=0
            )
            return np.diff((states[::every] - spent)[:: 3 - every], axis=0)

        # the rule's error depends on the step, the error of other rates does not
        fine, coarse = missed(1), missed(2)
        size = np.abs(states).max(axis=0)
        allowed = 2 * np.abs(coarse - fine).sum(axis=0)
        allowed += SOLVED * (size + SOLVED * size.max())
        if np.any(np.abs(fine).sum(axis=0) > allowed):
            raise DataError(
                "of: the run does not follow the equations of the verdict. Give the run of the "
                "same loop with the same parameters"
            )
        return W.reshape(-1, *self.W.shape)


def error_system_of(verdict: Any, names: Sequence[str]) -> ErrorSystem:
    """Read the error system of a verdict; `names` are the states th, by default read from V'."""
    eq = getattr(verdict, "equations", None)
    if eq is None or verdict.V is None or eq.discrete or eq.jumps:
        raise DiagramError(
            "of: must be a verdict of clpt.lyapunov on a loop of continuous time without jumps"
        )
    # Step 1: V and rates in states and inputs, with the numbers of the parameters
    rates = {s: sympy.sympify(x).xreplace(eq.values) for s, x in eq.motion.items()}
    known = {
        element_name(port, values.shape, index): value
        for port, values in eq.named.items()
        for index, value in np.ndenumerate(values)
    }
    V = verdict.V.xreplace({s: known.get(str(s), s) for s in verdict.V.free_symbols})
    V = V.xreplace(eq.values)
    # Step 2: V is quadratic; its states are those of e and of th
    states = [*rates]
    gradient = Matrix([sympy.diff(V, s) for s in states])
    H = gradient.jacobian(states).applyfunc(normal_form)
    if not all(entry.is_number for entry in H):
        raise DiagramError(
            f"of: V = {short(V)}: is not quadratic with constant weights"
        )
    least = gradient.subs(dict.fromkeys(states, 0))
    own = [k for k in range(len(states)) if any(H.row(k))]
    fall = normal_form(gradient.dot([*rates.values()]))
    if unknown := {*names} - {str(states[k]) for k in own}:
        raise DiagramError(
            f"signals = {[*unknown]}: must be states in V, of {[*map(str, states)]}"
        )
    in_th = [k for k in own if str(states[k]) in names] or [
        k for k in own if not any(H[k, j] and fall.has(states[j]) for j in own)
    ]
    in_e = [k for k in own if k not in in_th]
    weights, shared = H.extract(in_th, in_th), H.extract(in_e, in_th)
    if not (in_e and in_th and weights.is_positive_definite) or any(shared):
        raise DiagramError(
            f"of: V = {short(V)}, V' = {short(fall)}: is not a form of errors, which V' has, and "
            "a positive one of parameters. Name the parameters in signals"
        )
    # Step 3: independent forms e, and th
    T, pivots = H.extract(in_e, in_e).rref()
    heads = [in_e[p] for p in pivots]
    P = H.extract(heads, heads)
    e = T[: len(heads), :] * Matrix([states[k] for k in in_e])
    e += P.inv() * least.extract(heads, [0])
    parameters = Matrix([states[k] for k in in_th])
    th = parameters + weights.inv() * least.extract(in_th, [0])
    # Step 4: the rates are those of the form
    e_rate = e.applyfunc(eq.derivative).xreplace(eq.values)
    W = e_rate.jacobian(parameters).applyfunc(normal_form)
    rest = e_rate - W * th
    A = rest.jacobian([states[k] for k in heads]).applyfunc(normal_form)
    for k, x in enumerate(rest - A * e):
        if not (vanishes(x) and all(entry.is_number for entry in A.row(k))):
            raise DiagramError(
                f"of: ({short(e[k])})' = {short(e_rate[k])}: is not A e + W th with a constant A"
            )
    missed = weights * th.applyfunc(eq.derivative).xreplace(eq.values) + W.T * P * e
    for y, x in zip(parameters, missed, strict=True):
        if not vanishes(x):
            raise DiagramError(
                f"of: {y}' = {short(rates[y])}: is not -G W^T P e with the G of V"
            )
    # Step 5: coordinates in which V is half the sum of squares
    Q = -P * A - A.T * P
    if not (P.is_positive_definite and Q.is_positive_semidefinite):
        raise DiagramError(
            f"of: V = {short(V)}, V' = {short(fall)}: must be V > 0 that does not rise"
        )
    left, right = (np.linalg.cholesky(np.array(x, dtype=float)).T for x in (P, weights))
    inputs = {str(f.func): f for values in eq.inputs.values() for f in values.flat}
    return ErrorSystem(
        [*map(str, parameters)], W, A, left, np.linalg.inv(right), rates, inputs
    )
