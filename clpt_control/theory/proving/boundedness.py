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

import sympy

from .every_n_loop import EveryNLoop, element_symbol, every_n_loop
from .every_n_signals import Summed
from .lyapunov import every_n_terms
from .proof import Step, checked
from .theorem_loop import theorem_loop


def definite_step(law: str) -> Step:
    """Check that V is positive definite in e and the errors, every N."""
    equation = "(17)" if law == "known-flow" else "(24)"

    def check() -> bool:
        loop = every_n_loop(theorem_loop(3, law))
        V = loop.signals["V", None, 0]
        terms = every_n_terms(loop)
        truth: dict[sympy.Expr, sympy.Expr] = {}
        singles = []
        for i in range(2):
            KD, GammaD = terms.KD(i), loop.parameter("GammaD", i)
            own = [element_symbol(port, None, i) for port in ("x", "K", "Gamma")]
            truth |= dict(zip(own, (element_symbol("z", None, i), KD, GammaD), strict=True))
            singles += own
        rows = [element_symbol("alpha", i) for i in range(2)] if law == "learned-flow" else []
        truth |= {row: -terms.theta(i, None) for i, row in enumerate(rows)}
        learned = _form(V.term, rows, truth) if rows else V.term == 0
        return learned and _form(V.base, singles, truth)

    return checked(
        f"V of Eq. {equation} is positive definite in e and the parameter errors, and radially "
        "unbounded: a constant positive diagonal Hessian, zero at the truth",
        "exact",
        check,
    )


def _form(V: sympy.Expr, states: list, truth: dict) -> bool:
    """Return whether V is a sum of squares of the errors, each with a positive weight."""
    H = sympy.hessian(V, states)
    at_truth = [V, *(sympy.diff(V, s) for s in states)]
    return (
        H.is_diagonal()
        and all(
            H[i, i].is_positive and not H[i, i].free_symbols & set(truth)
            for i in range(len(states))
        )
        and all(sympy.expand(v.subs(truth, simultaneous=True)) == 0 for v in at_truth)
    )


def dissipation_step() -> Step:
    """Check that -e^T KD e is not positive where KD > 0."""

    def check() -> bool:
        loop = every_n_loop(theorem_loop(3, "learned-flow"))
        rate = loop.derivative(loop.signals["V", None, 0])
        H = sympy.hessian(rate.base, [element_symbol("x", None, i) for i in range(2)])
        return not rate.term and H.is_diagonal() and all(H[i, i].is_negative for i in range(2))

    return checked("V' <= 0: -e^T KD e is negative definite in e for KD > 0", "exact", check)


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


def error_rate(loop: EveryNLoop) -> tuple[Summed, Summed]:
    """Return e' = -KD e + W^T eta as the paper has it, for each axis."""
    terms, rates = every_n_terms(loop), []
    for i in range(2):
        K, Gamma = element_symbol("K", None, i), element_symbol("Gamma", None, i)
        joint = loop.signals["z", None, i].base * (K - terms.KD(i))
        joint += loop.signals["zc", None, i].base * (loop.parameter("GammaD", i) - Gamma)
        learned = terms.phi(None) * (terms.theta(i, None) + element_symbol("alpha", i))
        rates.append(Summed(joint - terms.KD(i) * terms.e(i), learned))
    return rates[0], rates[1]


def convergence_steps() -> list[Step]:
    """Check the chain of Theorem 3.2 after V' = -e^T KD e."""

    def loop() -> EveryNLoop:
        return every_n_loop(theorem_loop(3, "learned-flow"))

    def vehicle_stable() -> bool:
        own = loop()
        for i in range(2):
            KD, rate = every_n_terms(own).KD(i), own.rates["x", None, i]
            rest = sympy.expand(rate.base + KD * element_symbol("x", None, i))
            given = {s for s in own.given if str(s) in ("phi_x[k]", f"zc_{i + 1}")}
            fixed = {s for s in (rest + rate.term).free_symbols if _is_state(own, s)}
            moving = (rest + rate.term).free_symbols & own.given
            if fixed or not moving <= given or not KD.is_positive:
                return False
            if sympy.diff(rate.term, own.signals["phi_x", 0, None], 2) != 0:
                return False
        return True

    def prediction() -> bool:
        own = loop()
        x, z = ([element_symbol(port, None, i) for i in range(2)] for port in "xz")
        return all(own.signals["e", None, i] == Summed(x[i] - z[i]) for i in range(2))

    def rate() -> bool:
        own = loop()
        for i, wanted in enumerate(error_rate(own)):
            found = own.derivative(own.signals["e", None, i])
            if sympy.expand(found.base - wanted.base) or sympy.expand(found.term - wanted.term):
                return False
        return True

    def second() -> bool:
        own = loop()
        terms = every_n_terms(own)
        twice = own.derivative(own.derivative(own.signals["V", None, 0]))
        wanted = Summed(sympy.Integer(0))
        for i in range(2):
            slope = Summed(-2 * terms.KD(i) * terms.e(i))
            wanted = wanted.plus(slope.times(own.derivative(own.signals["e", None, i])))
        return twice == wanted.expanded()

    def squeezed() -> bool:
        eps, B, s = sympy.symbols("epsilon B s", positive=True)
        taken = sympy.integrate(eps - B * s, (s, 0, eps / B))
        return sympy.simplify(taken - eps**2 / (2 * B)) == 0 and bool(taken.is_positive)

    return [
        checked(
            "Eq. (9): x' + KD x holds only phi and zc, so x is bounded", "exact", vehicle_stable
        ),
        checked("z = x - e, so z is bounded where x and e are", "exact", prediction),
        checked("e' = -KD e + W^T eta, products of bounded signals", "exact", rate),
        checked(
            "V'' = -2 e^T KD e' holds no derivative of phi or zc, so it is bounded by some B",
            "exact",
            second,
        ),
        checked(
            "where g = -V' reaches eps, V loses int_0^(eps/B) (eps - B s) ds = eps^2/(2B) > 0: "
            "that can happen finitely often only, so V' -> 0",
            "exact",
            squeezed,
        ),
    ]


def _is_state(loop: EveryNLoop, symbol: sympy.Symbol) -> bool:
    own = [
        element_symbol(port, row, None)
        for port, size in loop.states.items()
        for row in range(size.rows)
    ]
    own += [
        element_symbol(port, None, j)
        for port, size in loop.states.items()
        for j in range(size.more)
    ]
    return symbol in own
