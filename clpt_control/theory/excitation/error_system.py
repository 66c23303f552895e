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
from scipy.linalg import block_diag
from sympy import Matrix, diff

from ...base.errors import DataError, DiagramError
from ...base.run_attributes import DIAGRAM, RunDiagram
from ...engine.diagram.symbol_names import TIME, element_name
from ...engine.diagram.symbolic_equations import Equations, on_symbols
from ...simulation.comparison import STATES, ports_along
from ..algebra.exact import as_factors, normal_form, vanishes
from ..algebra.facts import functions_in, is_continuous
from ..algebra.numeric_values import NumericValues
from ..algebra.texts import short
from .state_curves import Along, states_along
from .transitions import OfTime


@dataclass(frozen=True)
class ErrorSystem:
    """The loop in errors, exact, and coordinates in which V = |.|^2 / 2."""

    names: list[str]  # of th
    W: Matrix  # (m, n), in symbols
    A: Matrix
    left: np.ndarray  # of e in them; W is left W right
    right: np.ndarray
    rates: dict[Any, Any]  # of all states in the loop's order
    inputs: list[Any]  # their symbols
    errors: Matrix  # e and th, in states

    def errors_at(self, states: np.ndarray) -> np.ndarray:
        """Return e and th, shape (times, m + n)."""
        points = dict(zip(self.rates, states.T, strict=True))
        return NumericValues(*self.errors).at(points, len(states)).T

    @property
    def scaled_A(self) -> np.ndarray:
        """A in the coordinates."""
        return self.left @ np.array(self.A, dtype=float) @ np.linalg.inv(self.left)

    @property
    def scale(self) -> np.ndarray:
        """The matrix of the coordinates of e and th."""
        return block_diag(self.left, np.linalg.inv(self.right))

    def V_along(self, run: Any) -> np.ndarray:
        """Return V of a run at its times."""
        scaled = self.errors_at(run[STATES].values) @ self.scale.T
        return np.sum(scaled**2, axis=1) / 2

    def along(self, run: Any, start: float, end: float) -> tuple[OfTime, float]:
        """Return W of time in the coordinates in a window of a run, and its integrated error."""
        W, signal = self._values_of(*self.W), run.encoding[DIAGRAM].request.inputs.along

        def scaled_W(*point: np.ndarray) -> np.ndarray:
            return self.left @ W(*point).reshape(-1, *self.W.shape) @ self.right

        rates, last = self._values_of(*self.rates.values()), run.time.values[-1]
        curves, off = states_along(run, rates, scaled_W, start, end)

        def W_at(t: np.ndarray) -> np.ndarray:
            t = np.minimum(t, last)
            return scaled_W(t, curves(t), signal(t))

        return W_at, off

    def _values_of(self, *expressions: Any) -> Along:
        """Return expressions as a function of times, states and inputs."""
        symbols = TIME, *self.rates, *self.inputs
        values = NumericValues(*expressions)
        if unknown := {*values.symbols} - {*symbols}:
            raise DiagramError(f"of: {unknown.pop()} has no value along the run")
        return lambda t, x, u: (
            values.at(dict(zip(symbols, (t, *x.T, *u), strict=True)), len(t)).T
        )


def _loop_of(verdict: Any, run: Any) -> tuple[Equations, Any]:
    """Return the equations of the diagram that ran, with its parameters, and V of a verdict."""
    noted = run.encoding.get(DIAGRAM, RunDiagram())
    if noted.request is None:
        raise DataError(
            "of: the run does not contain its diagram (files and tables have none), so its loop "
            "is not known. Give the diagram in place of the run, with timepts, inputs, "
            "initial_state and params"
        )
    V = getattr(verdict, "V", None)
    eq = on_symbols(noted.diagram, params=noted.params)
    if V is None or eq.discrete or eq.jumps:
        raise DiagramError(
            "of: must be a verdict of clpt.lyapunov on a loop of continuous time without jumps"
        )
    known = {
        element_name(port, values.shape, index): value
        for port, values in eq.named.items()
        for index, value in np.ndenumerate(values)
    }
    V = V.xreplace({s: known.get(str(s), s) for s in V.free_symbols})
    unknown = V.free_symbols - {*eq.motion, *eq.values, TIME}
    if unknown or np.shape(run.get(STATES))[1:] != (len(eq.motion),):
        raise DataError(
            "of: must be a verdict on the loop of this run, with its states"
        )
    is_finite = (np.isfinite(run[name]).all() for name in (STATES, *ports_along(run)))
    if not (all(is_finite) and np.all(np.diff(run.time) > 0)):
        raise DataError(
            "gramian: of: states and inputs of the run must be finite, and its times increase"
        )
    return eq, V.xreplace(eq.values)


def error_system_of(verdict: Any, names: Sequence[str], run: Any) -> ErrorSystem:
    """Read the error system of the diagram that ran, by V of a verdict.

    `names` are the states th, by default read from V'.
    """
    # Step 1: V and rates in states and inputs, with the parameters of the run
    eq, V = _loop_of(verdict, run)
    inputs = [f for values in eq.inputs.values() for f in values.flat]
    _, given = run.encoding[DIAGRAM].request.inputs.samples
    still = {f: 0 for f, values in zip(inputs, given, strict=True) if not values.any()}
    numbers = eq.values | still
    rates = {s: sympy.sympify(x).xreplace(numbers) for s, x in eq.motion.items()}
    # Step 2: V is quadratic; its states are those of e and of th
    states = [*rates]
    gradient = Matrix([diff(V, s) for s in states])
    H = gradient.jacobian(states).applyfunc(normal_form)
    if not all(entry.is_number for entry in H):
        raise DiagramError(
            f"of: V = {short(V)}: is not quadratic with constant weights"
        )
    least = gradient.subs(dict.fromkeys(states, 0))
    own = [k for k in range(len(states)) if any(H.row(k))]
    fall = gradient.dot([*rates.values()])
    if unknown := {*names} - {str(states[k]) for k in own}:
        raise DiagramError(
            f"signals = {[*unknown]}: must be states in V, of {[*map(str, states)]}"
        )

    def falls_with(state: Any) -> bool:
        return fall.has(state) and not _is_zero(diff(fall, state))

    in_th = [k for k in own if str(states[k]) in names] or [
        k for k in own if not any(H[k, j] and falls_with(states[j]) for j in own)
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
    e_rate, th_rate = (x.applyfunc(eq.derivative).xreplace(numbers) for x in (e, th))
    W = e_rate.jacobian(parameters)
    rest = (e_rate - W * th).applyfunc(normal_form)
    A = rest.jacobian([states[k] for k in heads]).applyfunc(_constant)
    for k, x in enumerate(rest - A * e):
        if not (_is_zero(x) and all(entry.is_number for entry in A.row(k))):
            raise DiagramError(
                f"of: ({short(e[k])})' = {short(e_rate[k])}: is not A e + W th with a constant A"
            )
    missed = weights * th_rate + W.T * P * e
    for y, x in zip(parameters, missed, strict=True):
        if not _is_zero(x):
            raise DiagramError(
                f"of: {y}' = {short(rates[y])}: is not -G W^T P e with the G of V"
            )
    steps = {f for f in functions_in(sympy.Tuple(*W)) if f.has(*states)}
    if not is_continuous(sympy.Tuple(*steps)):
        raise DiagramError(
            f"of: W has {min(map(short, steps))}, which may jump where a state passes a number. "
            "Give a loop whose W is continuous in its states"
        )
    # Step 5: coordinates in which V is half the sum of squares
    Q = -P * A - A.T * P
    if not (P.is_positive_definite and Q.is_positive_semidefinite):
        raise DiagramError(
            f"of: V = {short(V)}, V' = {short(fall)}: must be V > 0 that does not rise"
        )
    left, right = (np.linalg.cholesky(np.array(x, dtype=float)).T for x in (P, weights))
    return ErrorSystem(
        [*map(str, parameters)],
        W,
        A,
        left,
        np.linalg.inv(right),
        rates,
        inputs,
        Matrix([*e, *th]),
    )


def _constant(x: Any) -> Any:
    """Return the number that an expression is, or the expression."""
    x = normal_form(x)
    return x if x.is_number else as_factors(x)


def _is_zero(x: Any) -> bool:
    """Return whether x is zero, as it is or with functions of other angles written alike."""
    return vanishes(x) or vanishes(normal_form(x))
