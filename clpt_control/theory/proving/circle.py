"""Excitation in closed form: waypoints on a circle.

    int zc zc^T dt = (n tau r^2 / 2) I            n >= 3 waypoints, one cycle, section IV

The sums go through roots of unity: cos^2 a = (1 + cos 2a)/2, and the sum of
exp(4 pi i j / n) over j vanishes exactly where its ratio is not 1, n >= 3.
"""

import sympy

from .proof import Step, checked


def _zero(expression: sympy.Expr) -> bool:
    """Return whether trigonometric terms cancel, as sums of exponentials."""
    return sympy.simplify(sympy.expand(sympy.expand(expression).rewrite(sympy.exp))) == 0


def telescopes() -> bool:
    """Return whether sum_{j<n} q^j = (1 - q^n)/(1 - q), by induction."""
    n, q = sympy.Symbol("n", integer=True, positive=True), sympy.Symbol("q")

    def partial(count: sympy.Expr) -> sympy.Expr:
        return (1 - q**count) / (1 - q)

    step = partial(n + 1) - partial(n) - q**n
    return _zero(partial(sympy.Integer(1)) - 1) and sympy.simplify(step) == 0


def root_of_unity() -> bool:
    """Return whether q = exp(4 pi i/n) is a root of 1, not 1, n > 2."""
    n = sympy.Symbol("n", integer=True, positive=True)
    m = sympy.Symbol("m", integer=True, nonnegative=True)
    q = sympy.exp(4 * sympy.pi * sympy.I / n)
    angle = 2 * sympy.pi / (m + 3)  # n = m + 3: between 0 and pi, where the sine is not zero
    below_pi = sympy.factor(sympy.together(sympy.pi - angle))
    distance = sympy.expand((1 - sympy.cos(2 * angle)) ** 2 + sympy.sin(2 * angle) ** 2)
    return (
        sympy.powsimp(q**n, force=True).equals(1) is True
        and bool(angle.is_positive and below_pi.is_positive)
        and _zero(distance - 4 * sympy.sin(angle) ** 2)
        and q.subs(n, 2) == 1
    )


def entries() -> bool:
    """Return whether cos^2, sin^2, cos sin are parts of exp(2 i a)."""
    a = sympy.Symbol("a", real=True)
    re, im = sympy.re(sympy.exp(2 * sympy.I * a)), sympy.im(sympy.exp(2 * sympy.I * a))
    cosine, sine = sympy.cos(a), sympy.sin(a)
    return (
        _zero(cosine**2 - (1 + re) / 2)
        and _zero(sine**2 - (1 - re) / 2)
        and _zero(cosine * sine - im / 2)
    )


def circle_step() -> Step:
    """Prove the Gramian (n tau r^2/2) I of points on a circle."""
    return checked(
        "n >= 3 waypoints on a circle excite: int zc zc^T dt = (n tau r^2/2) I over a cycle",
        "exact",
        lambda: (
            telescopes() and root_of_unity() and entries(),
            "cos^2 a = (1 + Re q^j)/2 and so on, a = 2 pi j/n; q^n = 1 and q != 1, so sum q^j = 0",
        ),
    )
