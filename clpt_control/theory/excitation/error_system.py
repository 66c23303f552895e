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
from scipy.integrate import cumulative_trapezoid, trapezoid
from scipy.interpolate import CubicHermiteSpline, interp1d
from scipy.linalg import block_diag
from sympy import Matrix

from ...base.errors import DataError, DiagramError
from ...engine.diagram.symbol_names import TIME, element_name
from ...simulation.comparison import STATES
from ..algebra.exact import normal_form, vanishes
from ..algebra.numeric_values import NumericValues
from ..algebra.texts import short

ROUNDING = 1e-12  # of the largest entry of a row
SOLVED = 1e-4  # share of a state by which a run may miss the equations
SHOWN = 15  # times that, by which e and th must move to show it
BETWEEN = 0.382  # of a step: where W is computed too


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

    def along(
        self, run: Any, signals: dict[str, np.ndarray]
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return times, also between samples, and W (times, m, n); the run must follow the loop."""
        times, states = run.time.values, np.asarray(run.get(STATES, np.empty((1, 0))))
        if states.shape[1] != len(self.rates) or {*self.inputs} - {*signals}:
            raise DataError(
                "of: must be a verdict on the loop of this run, with its states"
            )
        inputs = np.array([signals[name] for name in self.inputs])
        inputs = inputs.reshape(-1, len(times))
        if not (np.isfinite([*states.T, *inputs]).all() and (np.diff(times) > 0).all()):
            raise DataError(
                "gramian: of: states and inputs of the run must be finite, and its times increase"
            )
        symbols = TIME, *self.rates, *self.inputs.values()

        def at(t: np.ndarray, x: np.ndarray, u: np.ndarray, *terms: Any) -> np.ndarray:
            points = dict(zip(symbols, (t, *x.T, *u), strict=True))
            return NumericValues(*terms).at(points, len(t)).T

        # Step 1: W where states are cubic lines between samples, and inputs straight ones
        rates = at(times, states, inputs, *self.rates.values())
        steps = np.diff(times)
        t = np.sort(np.append(times, times[:-1] + BETWEEN * steps))
        x, u = CubicHermiteSpline(times, states, rates)(t), interp1d(times, inputs)(t)
        W = at(t, x, u, *self.W).reshape(-1, *self.W.shape)
        # Step 2: the run follows the rates of all states, and of e and th
        allowed = self._missed(times, states, rates)[len(self.rates) :]
        # Step 3: it shows each term of A e, W th and G W^T P e
        if not W.any():
            return t, W
        m = W.shape[1]
        errors = self.errors_at(x)[:, None]
        A, P = np.array([self.A], dtype=float), self.left.T @ self.left
        gains = self.right @ self.right.T @ W.mT @ P
        of_e, of_th = slice(m), slice(m, None)
        for matrix, row, column in (
            (A, of_e, of_e),
            (W, of_e, of_th),
            (gains, of_th, of_e),
        ):
            shown = trapezoid(np.abs(matrix * errors[..., column]), t, axis=0)
            largest = np.abs(matrix).max(axis=0)
            appears = largest > ROUNDING * largest.max(axis=1, keepdims=True)
            for k, j in np.argwhere(appears & (shown <= SHOWN * allowed[row, None])):
                raise hidden(self.errors[row][k], self.errors[column][j])
        # Step 4: and each error would show in any equation, in the coordinates
        sizes = trapezoid(np.abs(errors[:, 0] @ self.scale.T), t, axis=0)
        rate = max(
            np.abs(self.scaled_A).max(), np.abs(self.left @ W @ self.right).max()
        )
        least = SHOWN * (np.abs(self.scale) @ allowed).max()
        for j in np.flatnonzero(rate * sizes <= least):
            raise hidden(self.errors[np.argmax(sizes)], self.errors[j])
        return t, W

    def _missed(
        self, times: np.ndarray, states: np.ndarray, rates: np.ndarray
    ) -> np.ndarray:
        """Return by how much a run may miss the equations, of states, and of e and th."""
        forms = np.array(self.errors.jacobian([*self.rates]), dtype=float)
        sums = np.hstack([np.eye(states.shape[1]), forms.T])

        def missed(every: int) -> np.ndarray:
            """Changes over two intervals, less the rates by the trapezoidal rule."""
            spent = cumulative_trapezoid(
                rates[::every], times[::every], axis=0, initial=0
            )
            return np.diff((states[::every] - spent)[:: 3 - every], axis=0) @ sums

        # the rule's error depends on the step, the error of other rates does not
        fine, coarse = missed(1), missed(2)
        size = np.abs(states).max(axis=0)
        off = SOLVED * (size + SOLVED * size.max())
        allowed = 2 * np.abs(coarse - fine).sum(axis=0) + off @ np.abs(sums)
        if np.any(np.abs(fine).sum(axis=0) > allowed):
            raise DataError(
                "of: the run does not follow the equations of the verdict, or its samples are too "
                "far apart. Give the run of the same loop with the same parameters, or more times"
            )
        return allowed


def hidden(state: Any, error: Any) -> DataError:
    """Return the error for a run that does not show what an error adds to a rate."""
    return DataError(
        f"of: the run does not show ({short(state)})' of the verdict: {short(error)} is 0, or adds "
        "too little to it for these samples. Start the run from another state, make it longer, or "
        "give more times"
    )


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
    e_rate, th_rate = (x.applyfunc(eq.derivative).xreplace(eq.values) for x in (e, th))
    W = e_rate.jacobian(parameters)
    rest = (e_rate - W * th).applyfunc(normal_form)
    A = rest.jacobian([states[k] for k in heads]).applyfunc(normal_form)
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
    # Step 5: coordinates in which V is half the sum of squares
    Q = -P * A - A.T * P
    if not (P.is_positive_definite and Q.is_positive_semidefinite):
        raise DiagramError(
            f"of: V = {short(V)}, V' = {short(fall)}: must be V > 0 that does not rise"
        )
    left, right = (np.linalg.cholesky(np.array(x, dtype=float)).T for x in (P, weights))
    inputs = {str(f.func): f for values in eq.inputs.values() for f in values.flat}
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


def _is_zero(x: Any) -> bool:
    """Return whether x is zero, as it is or with functions of other angles written alike."""
    return vanishes(x) or vanishes(normal_form(x))
