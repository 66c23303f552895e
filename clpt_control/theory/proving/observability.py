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

import sympy

from ...simulation.loops import error_loop
from .every_n_loop import EveryNLoop, element_symbol, every_n_loop
from .every_n_signals import Key, Summed
from .lyapunov import every_n_terms
from .proof import Step, checked, cited
from .theorem_loop import theorem_loop, theorem_scenario


def same_dynamics() -> bool:
    """Return whether Eqs. (27)-(28) are the closed loop's own, every N."""
    every_loop = every_n_loop(theorem_loop(3, "learned-flow"))
    parts = every_n_loop(error_loop(theorem_scenario(3, "learned-flow")))
    terms = every_n_terms(every_loop)
    places: dict[sympy.Expr, sympy.Expr] = {}
    wanted: dict[Key, Summed] = {}
    for i in range(2):
        error = terms.theta(i, None) + element_symbol("alpha", i)
        places[element_symbol("eta", i)] = error
        places[element_symbol("e", None, i)] = terms.e(i)
        tails = (
            element_symbol("K", None, i) - terms.KD(i),
            every_loop.parameter("GammaD", i) - element_symbol("Gamma", None, i),
        )
        wanted["e", None, i] = every_loop.derivative(every_loop.signals["e", None, i])
        wanted["eta", i, None] = Summed(every_loop.rates["alpha", i, None])
        for row, tail in enumerate(tails):
            places[element_symbol("eta", None, 2 * row + i)] = tail
            wanted["eta", None, 2 * row + i] = every_loop.derivative(Summed(tail))
    for key, rate in wanted.items():
        own = parts.rates[key] if key[1] is None else Summed(parts.rates[key])
        for a, b in zip(own, rate, strict=True):
            if sympy.expand(a.subs(places, simultaneous=True) - b) != 0:
                return False
    return set(wanted) == set(parts.rates)


def observability_steps() -> list[Step]:
    """Check the algebra of Theorem 3.3."""

    def loop() -> tuple[EveryNLoop, sympy.Expr, list]:
        parts = every_n_loop(error_loop(theorem_scenario(3, "learned-flow")))
        KD = [parts.parameter("KD", i) for i in range(2)]
        return parts, parts.parameter("gamma"), KD

    def decays() -> bool:
        parts, gamma, KD = loop()
        e = [element_symbol("e", None, i) for i in range(2)]
        tail = [element_symbol("eta", None, j) for j in range(4)]
        rows = [element_symbol("eta", i) for i in range(2)]
        V = Summed(
            sum(s**2 for s in e) / 2 + sum(s**2 for s in tail) / (2 * gamma),
            sum(s**2 for s in rows) / (2 * gamma),
        )
        rate = parts.derivative(V)
        claim = -sum(KD[i] * e[i] ** 2 for i in range(2))
        return sympy.expand(rate.base - claim) == 0 and rate.term == 0

    def injection() -> bool:
        """Return whether the lower rows of A + L C are zero: eta' = -gamma W e, W read off e'."""
        parts, gamma, _ = loop()
        for i in range(2):
            e, rate = element_symbol("e", None, i), parts.rates["e", None, i]
            row = sympy.diff(rate.term, element_symbol("eta", i))
            if sympy.expand(parts.rates["eta", i, None] + gamma * row * e) != 0:
                return False
            for j in (i, 2 + i):
                weight = sympy.diff(rate.base, element_symbol("eta", None, j))
                own = parts.rates["eta", None, j]
                if own.term != 0 or sympy.expand(own.base + gamma * weight * e) != 0:
                    return False
        return True

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
        checked("(X^T P X)' = -e^T KD e with P = diag(I, I/gamma)/2", "exact", decays),
        checked("L = [0; gamma W] gives A + L C = [[-KD, W^T], [0, 0]]", "exact", injection),
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
