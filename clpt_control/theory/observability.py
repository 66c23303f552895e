"""Theorem 3.3: X' = A(t) X of Eq. (28), read off the blocks that run.

    A(t) = [[-KD, W^T], [-gamma W, 0]],  X = (e, eta),  Y = e
    P = diag(I, I/gamma)/2:   A^T P + P A = -diag(KD, 0)
    L = [0; gamma W]:         A + L C = [[-KD, W^T], [0, 0]]

Output injection by L keeps -KD in the first block.  Then e is W^T eta filtered
by (s I + KD)^{-1}, and (C, A) is uniformly completely observable where the
JOINT regressor, of Eq. (31), is persistently exciting (Ioannou and Sun, Robust
Adaptive Control, 1996, lemmas 4.8.1 to 4.8.4 and theorem 3.4.8, as the paper
cites them).  Exponential stability follows.
"""

from typing import NamedTuple

import sympy

from ..diagram import error_loop
from .generic import K, Summed, element_symbol
from .generic_trace import generic_trace
from .lyapunov import PHI, theorem_loop, theorem_scenario
from .proof import Step, checked
from .trace import SymbolicLoop, trace


class ErrorDynamics(NamedTuple):
    """Eq. (28) on symbols, from the traced error blocks.

    Attributes
    ----------
    A : sympy.Matrix
        Shape (2N + 6, 2N + 6), in the order e, eta.
    C : sympy.Matrix
        [I, 0], shape (2, 2N + 6).
    W : sympy.Matrix
        The joint regressor, shape (2N + 4, 2).
    KD : sympy.Matrix
        Diagonal, shape (2, 2).
    gamma : sympy.Symbol
        Adaptation gain.
    """

    A: sympy.Matrix
    C: sympy.Matrix
    W: sympy.Matrix
    KD: sympy.Matrix
    gamma: sympy.Symbol


def error_dynamics(N: int) -> ErrorDynamics:
    """Read A(t) of Eq. (28) off the error and parameter blocks.

    Parameters
    ----------
    N : int
        Number of basis functions.

    Returns
    -------
    ErrorDynamics
        A, C and their parts.

    Examples
    --------
    >>> error_dynamics(1).A.shape
    (8, 8)
    """
    loop = trace(error_loop(theorem_scenario(N, "learned-flow")))
    X = sympy.Matrix([*loop.states["e"], *loop.states["eta"]])
    rates = sympy.Matrix([*loop.rates["e"], *loop.rates["eta"]])
    A = rates.jacobian(X)
    if sympy.expand(rates - A * X) != sympy.zeros(*X.shape):
        raise ValueError("Eq. (28) is not linear in (e, eta)")
    C = sympy.eye(2).row_join(sympy.zeros(2, 2 * N + 4))
    KD = sympy.diag(*loop.parameters["error_system"].KD)
    return ErrorDynamics(A, C, A[:2, 2:].T, KD, loop.parameters["parameter_system"].gain)


def eta_of(loop: SymbolicLoop) -> list[sympy.Expr]:
    """Give eta = [theta + alpha, K - KD, GammaD - Gamma].

    Parameters
    ----------
    loop : SymbolicLoop
        Traced with the learned-flow law.

    Returns
    -------
    list of sympy.Expr
        Length 2N + 4.
    """
    p = loop.parameters
    KD, GammaD = p["vehicle_controller"].KD, p["vehicle_controller"].GammaD
    return [
        *(p["true_flow"].theta.ravel() + loop.states["alpha"]),
        *(loop.states["K"] - KD),
        *(GammaD - loop.states["Gamma"]),
    ]


def same_dynamics(N: int) -> bool:
    """Tell whether Eqs. (27)-(28) are the closed loop's own.

    Parameters
    ----------
    N : int
        Number of basis functions.

    Returns
    -------
    bool
        True where the traced loop and the traced error blocks agree.

    Examples
    --------
    >>> same_dynamics(1)
    True
    """
    whole = trace(theorem_loop(N, "learned-flow"), PHI)
    parts = trace(error_loop(theorem_scenario(N, "learned-flow")))
    eta = eta_of(whole)
    places = dict(zip(parts.states["eta"], eta, strict=True))
    places |= dict(zip(parts.states["e"], whole.signals["e"], strict=True))
    for port in ("phi_x", "z", "zc"):
        places |= dict(zip(parts.inputs[port], whole.signals[port], strict=True))
    wanted = [*whole.signals["e"], *eta]
    given = [*parts.rates["e"], *parts.rates["eta"]]
    return all(
        sympy.expand(whole.derivative(own) - rate.subs(places, simultaneous=True)) == 0
        for own, rate in zip(wanted, given, strict=True)
    )


def generic_decay() -> bool:
    """Tell whether X^T P X decays by e^T KD e, every N."""
    loop = generic_trace(error_loop(theorem_scenario(3, "learned-flow")))
    gamma = sympy.Symbol("gamma", positive=True)
    e = [element_symbol("e", None, i) for i in range(2)]
    tail = [element_symbol("eta", None, j) for j in range(4)]
    rows = [element_symbol("eta", i, K) for i in range(2)]
    V = Summed(
        sum(s**2 for s in e) / 2 + sum(s**2 for s in tail) / (2 * gamma),
        sum(s**2 for s in rows) / (2 * gamma),
    )
    rate = loop.derivative(V)
    KD = [sympy.Symbol(f"KD_{i}", positive=True) for i in (1, 2)]
    claim = -sum(KD[i] * e[i] ** 2 for i in range(2))
    return sympy.expand(rate.base - claim) == 0 and rate.term == 0


def observability_steps() -> list[Step]:
    """Check the algebra of Theorem 3.3.

    Returns
    -------
    list of Step
        All symbolic.

    Examples
    --------
    >>> all(step.holds for step in observability_steps())
    True
    """

    def lyapunov_equation() -> bool:
        for N in (1, 2, 3):
            A, C, _, KD, gamma = error_dynamics(N)
            P = sympy.diag(sympy.eye(2) / 2, sympy.eye(2 * N + 4) / (2 * gamma))
            if sympy.expand(A.T * P + P * A + C.T * KD * C) != sympy.zeros(*A.shape):
                return False
        return True

    def injection() -> bool:
        for N in (1, 2, 3):
            A, C, W, KD, gamma = error_dynamics(N)
            L = sympy.zeros(2, 2).col_join(gamma * W)
            kept = (-KD).row_join(W.T).col_join(sympy.zeros(2 * N + 4, 2 * N + 6))
            if sympy.expand(A + L * C - kept) != sympy.zeros(*A.shape):
                return False
        return True

    def filtered() -> bool:
        """Variation of constants for one axis of the injected system."""
        k, s, t, c = sympy.symbols("k s t c", positive=True)
        w, eta, e0 = sympy.Function("w"), sympy.Symbol("eta"), sympy.Symbol("e_0")
        response = sympy.Integral(sympy.exp(-k * (s - c)) * w(c), (c, t, s))
        Y = sympy.exp(-k * (s - t)) * e0 + response * eta
        rate = sympy.diff(Y, s)
        return (
            sympy.simplify((rate + k * Y - w(s) * eta).expand()) == 0 and Y.subs(s, t).doit() == e0
        )

    return [
        checked("Eqs. (27)-(28) with z eta_3 are the closed loop's e' and eta', N = 1, 2, 3, 5",
                "symbolic", lambda: all(same_dynamics(N) for N in (1, 2, 3, 5))),
        checked("A^T P + P A = -diag(KD, 0) with P = diag(I, I/gamma)/2, N = 1, 2, 3",
                "symbolic", lyapunov_equation),
        checked("(X^T P X)' = -e^T KD e, every N", "symbolic", generic_decay),
        checked("L = [0; gamma W] gives A + L C = [[-KD, W^T], [0, 0]], N = 1, 2, 3",
                "symbolic", injection),
        checked("the injected output is [exp(-k(s-t)) I, filtered W^T] X: the observability "
                "Gramian is int R^T R with R that row", "symbolic", filtered),
    ]  # fmt: skip
