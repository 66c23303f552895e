"""Error system of adaptive control, read from V of a verdict and the equations, exactly.

    e' = A e + W th,  th' = -G W^T P e,  P A + A^T P = -Q
    V = (e^T P e + th^T G^-1 th) / 2,      V' = -e^T Q e / 2

e has independent forms of the states in V', th the other states of V, each less the value at which
V is least.  W may depend on all signals: along a run it is a function of time.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy
from scipy.integrate import trapezoid
from scipy.interpolate import CubicHermiteSpline, interp1d
from scipy.linalg import block_diag
from sympy import Matrix, diff

from ...base.errors import DataError, DiagramError
from ...base.run_attributes import DIAGRAM, RunDiagram
from ...engine.diagram.symbol_names import TIME, element_name
from ...engine.record.symbolic import rational
from ...simulation.comparison import STATES
from ..algebra.exact import as_factors, normal_form, vanishes
from ..algebra.numeric_values import NumericValues
from ..algebra.texts import short
from ..proofs.same_as_running import LOST, TOLERANCE, size_of
from ..proofs.same_as_running import ROUNDING as SHARE_LOST

ROUNDING = 1e-12  # of the largest entry of a row
SOLVED = 1e-4  # share of a state by which a run may miss the equations in a window
SHOWN = 15  # times that, by which e and th must move to show it
TINY = 1e-8  # of a state: absolute tolerance of the steps of a run
MOST_STEPS = 200_000  # between the samples of a window
POINTS = 8  # at which the equations are compared with the diagram that ran


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
        self, run: Any, signals: dict[str, np.ndarray], start: float, end: float
    ) -> Callable[[np.ndarray], np.ndarray]:
        """Return W of time, (times, m, n), in a window in which a run follows the loop."""
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
        # Step 1: the loop that ran has these equations
        first = max(0, np.searchsorted(times, start, "right") - 1)
        inside = slice(first, np.searchsorted(times, end) + 1)
        samples = times[inside], states[inside], inputs[:, inside]
        noted = run.encoding.get(DIAGRAM, RunDiagram())
        if noted.diagram is not None:
            self._check_equations(noted, *samples)
        # Step 2: states between samples; those of another run show each term
        t, x, u, allowed = self._between(*samples)
        if noted.diagram is None:
            self._check_terms(t, x, u, allowed)
        # Step 3: W, with cubic lines through the states
        lines = CubicHermiteSpline(t, x, self._at(t, x, u, *self.rates.values()))
        signal = interp1d(t, u)
        W = NumericValues(*self.W)

        def W_at(t: np.ndarray) -> np.ndarray:
            t = np.minimum(t, times[-1])
            return self._at(t, lines(t), signal(t), W).reshape(-1, *self.W.shape)

        return W_at

    def _at(self, t: np.ndarray, x: np.ndarray, u: np.ndarray, *terms: Any) -> Any:
        """Return terms at times (n,), states (n, nx) and inputs (nu, n): (n, terms)."""
        symbols = TIME, *self.rates, *self.inputs.values()
        points = dict(zip(symbols, (t, *x.T, *u), strict=True))
        is_read = isinstance(terms[0], NumericValues)
        values = terms[0] if is_read else NumericValues(*terms)
        return values.at(points, len(t)).T

    def _between(
        self, times: np.ndarray, states: np.ndarray, inputs: np.ndarray
    ) -> Any:
        """Return times, states and inputs between samples, and by how much states may miss.

        The equations run from each sample to the next, which they must reach, by the classical
        Runge-Kutta method in steps that are halved until the ends settle.
        """
        rates, steps = NumericValues(*self.rates.values()), np.diff(times)[:, None]
        size = np.abs(states).max(axis=0)
        off, ends, count = (
            SOLVED * size + TINY,
            np.full((2, *states[1:].shape), np.inf),
            1,
        )
        while True:
            h, x, along = steps / count, states[:-1], []

            def rate(share: float, x: np.ndarray) -> np.ndarray:
                t = times[:-1] + share * steps[:, 0]
                u = inputs[:, :-1] + share * np.diff(inputs)
                return self._at(t, x, u, rates)

            for j in range(count):
                along.append(x)
                before, middle, after = ((j + c) / count for c in (0, 0.5, 1))
                one = rate(before, x)
                two = rate(middle, x + h / 2 * one)
                three = rate(middle, x + h / 2 * two)
                four = rate(after, x + h * three)
                x = x + h / 6 * (one + 2 * two + 2 * three + four)
            ends = np.array([x, ends[0]])
            with np.errstate(invalid="ignore"):
                change = np.abs(ends[0] - ends[1]).sum(axis=0)
            if np.all(change < off / 10) or 2 * count * len(steps) > MOST_STEPS:
                break
            count *= 2
        allowed = 2 * change + off
        missed = np.abs(x - states[1:]).sum(axis=0)
        if not np.all(missed <= allowed):
            raise not_followed("")
        shares = np.arange(count) / count
        t = np.append(times[:-1, None] + shares * steps, times[-1])
        x = np.append(
            np.stack(along, axis=1).reshape(-1, len(size)), states[-1:], axis=0
        )
        return t, x, interp1d(times, inputs)(t), allowed

    def _check_equations(
        self,
        noted: RunDiagram,
        times: np.ndarray,
        states: np.ndarray,
        inputs: np.ndarray,
    ) -> None:
        """Compare the rates with those of the diagram that ran, about samples of the window."""
        chosen = np.unique(np.linspace(0, len(times) - 1, POINTS).astype(int))
        t, x, u = times[chosen], states[chosen], inputs[:, chosen]
        size = np.abs(states).max(axis=0)
        x = x + np.random.default_rng(0).normal(size=x.shape) * np.where(size, size, 1)
        params = noted.params or None
        with np.errstate(all="ignore"):
            ran = [
                noted.diagram.dynamics(*at, params=params)
                for at in zip(t, x, u.T, strict=True)
            ]
        terms = [*self.rates.values()]
        lost = {LOST: SHARE_LOST * (1 + np.abs(x).max())}
        sizes = [size_of(rate).xreplace(lost) for rate in terms]
        own, largest = np.split(self._at(t, x, u, *terms, *sizes), 2, axis=1)
        differ = ~(np.abs(own - ran) <= TOLERANCE * largest)
        for k in np.flatnonzero(differ.any(axis=0))[:1]:
            raise not_followed(f", in ({short([*self.rates][k])})'")

    def _check_terms(
        self, t: np.ndarray, x: np.ndarray, u: np.ndarray, missed: np.ndarray
    ) -> None:
        """Raise an error for a term of A e, W th and G W^T P e that samples do not show."""
        W = self._at(t, x, u, *self.W).reshape(-1, *self.W.shape)
        if not W.any():
            return
        forms = np.array(self.errors.jacobian([*self.rates]), dtype=float)
        allowed = np.abs(forms) @ missed
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
        # and each error would show in any equation, in the coordinates
        sizes = trapezoid(np.abs(errors[:, 0] @ self.scale.T), t, axis=0)
        rate = max(
            np.abs(self.scaled_A).max(), np.abs(self.left @ W @ self.right).max()
        )
        least = SHOWN * (np.abs(self.scale) @ allowed).max()
        for j in np.flatnonzero(rate * sizes <= least):
            raise hidden(self.errors[np.argmax(sizes)], self.errors[j])


def not_followed(where: str) -> DataError:
    """Return the error for a run of other equations, or with samples too far apart."""
    return DataError(
        f"of: the run does not follow the equations of the verdict{where}, or its samples are too "
        "far apart. Give the run of the same loop with the same parameters, or more times"
    )


def hidden(state: Any, error: Any) -> DataError:
    """Return the error for a run that does not show what an error adds to a rate."""
    return DataError(
        f"of: the run does not show ({short(state)})' of the verdict: {short(error)} is 0, or adds "
        "too little to it for these samples. Start the run from another state, make it longer, or "
        "give more times"
    )


def error_system_of(
    verdict: Any, names: Sequence[str], params: Mapping[str, Any] | None = None
) -> ErrorSystem:
    """Read the error system of a verdict; `names` are the states th, by default read from V'.

    `params` are call-time parameters of the run, in place of the numbers of the verdict.
    """
    eq = getattr(verdict, "equations", None)
    if eq is None or verdict.V is None or eq.discrete or eq.jumps:
        raise DiagramError(
            "of: must be a verdict of clpt.lyapunov on a loop of continuous time without jumps"
        )
    # Step 1: V and rates in states and inputs, with the numbers of the parameters
    numbers = {**eq.values, **_numbers_of(eq, params or {})}
    rates = {s: sympy.sympify(x).xreplace(numbers) for s, x in eq.motion.items()}
    known = {
        element_name(port, values.shape, index): value
        for port, values in eq.named.items()
        for index, value in np.ndenumerate(values)
    }
    V = verdict.V.xreplace({s: known.get(str(s), s) for s in verdict.V.free_symbols})
    V = V.xreplace(numbers)
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


def _numbers_of(eq: Any, params: Mapping[str, Any]) -> dict[Any, Any]:
    """Return the symbols of parameters of a verdict -> the numbers of a run."""
    numbers = {}
    for name, value in params.items():
        alike = [
            symbols
            for field, symbols in eq.fields.items()
            if f".{name}".endswith(f".{field}") or f".{field}".endswith(f".{name}")
        ]
        if len(alike) != 1 or np.shape(alike[0]) != np.shape(value):
            raise DataError(
                f"of: the run has {name} = {value}, which the verdict has as a number, or not at "
                "all. Give the verdict on the loop with this value"
            )
        pairs = zip(np.ravel(alike[0]), np.ravel(value), strict=True)
        numbers |= {s: rational(float(number)) for s, number in pairs}
    return numbers


def _constant(x: Any) -> Any:
    """Return the number that an expression is, or the expression."""
    x = normal_form(x)
    return x if x.is_number else as_factors(x)


def _is_zero(x: Any) -> bool:
    """Return whether x is zero, as it is or with functions of other angles written alike."""
    return vanishes(x) or vanishes(normal_form(x))
