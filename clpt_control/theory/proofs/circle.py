"""Excitation by waypoints on a circle, Assumption 3.1 and section IV, in closed form.

    int zc zc^T dt = (n tau r^2/2) I            n >= 3 waypoints, dwell tau, one cycle

zc zc^T is (r^2/2) (I + R), R turning twice as fast as zc; over n >= 3 places R is a geometric sum
of q = exp(4 pi i/n), which is not 1 and whose n-th power is.
"""

import sympy

from .steps import Step, checked


def circle_step() -> Step:
    """Prove the Gramian (n tau r^2/2) I of points on a circle."""

    def excites() -> tuple[bool, str]:
        n, m = (sympy.Symbol(name, integer=True, nonnegative=True) for name in "nm")
        a, q = sympy.Symbol("a", real=True), sympy.Symbol("q")
        zc = sympy.Matrix([sympy.cos(a), sympy.sin(a)])
        c, s = sympy.cos(2 * a), sympy.sin(2 * a)
        doubled = zc * zc.T - sympy.Matrix([[1 + c, s], [s, 1 - c]]) / 2
        geometric = (q**n - 1) / (q - 1)
        more = geometric.subs(n, n + 1) - geometric - q**n
        closed = sympy.exp(4 * sympy.pi * sympy.I / (m + 3)) ** (m + 3) - 1
        below_a_turn = sympy.factor(1 - 2 / (m + 3))  # so q is not 1
        zero = *sympy.simplify(doubled), sympy.simplify(more), closed
        return not any(zero) and bool(below_a_turn.is_positive), (
            "zc zc^T = (r^2/2) (I + [[cos 2a, sin 2a], [sin 2a, -cos 2a]]), and sum exp(2 i a) is "
            "(q^n - 1)/(q - 1) = 0 with q = exp(4 pi i/n)"
        )

    claim = "n >= 3 waypoints on a circle excite: int zc zc^T dt = (n tau r^2/2) I over a cycle"
    return checked(claim, excites)
