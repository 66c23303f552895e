"""Excitation, and the convergence of parameters under it: Theorem 3.3.

Waypoints on a circle excite, Assumption 3.1 and section IV, in closed form:

    int zc zc^T dt = (n tau r^2/2) I            n >= 3 waypoints, dwell tau, one cycle

zc zc^T is (r^2/2) (I + R), R turning twice as fast as zc; over n >= 3 places R is a geometric sum
of q = exp(4 pi i/n), which is not 1 and whose n-th power is.
"""

import numpy as np
import sympy

from ..laws.paper_loop import PaperLoop, algebra, line
from ..proofs.steps import Step, checked

FILTERED = "excites through the filter 1/(s + KD_i) in every window alike"


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


def filtered_steps(paper: PaperLoop) -> list[Step]:
    """Check the lines by which the parameters converge where the filtered regressor excites."""
    return [
        line(
            "e' = -KD e + w*^T eta + d, w* = [phi(x), x, zc] and d = -kappa e, from z = x - e",
            paper.zero(
                paper.rate(paper.e)
                - (paper.error_rate + paper.kappa * (paper.x - paper.z - paper.e))
            ),
        ),
        line(
            "w_f' = -KD w_f + w*: y = e - w_f^T eta obeys y' = -KD y + d - w_f^T eta', where d and "
            "eta' go to zero with e (Theorem 3.2) and w_f is bounded: so y and w_f^T eta go to 0",
            paper.positive(paper.KD),
            algebra("(w*n + d - k*e) - ((w - k*f)*n + f*m) - (d - f*m - k*(e - f*n))"),
        ),
        line(
            "eta' goes to 0, so eta stands still in a window, and int (w_f(s)^T eta(t))^2 ds over "
            "it goes to 0: (a + b)^2 <= 2 a^2 + 2 b^2",
            algebra("2*a**2 + 2*b**2 - (a + b)**2 - (a - b)**2"),
        ),
        line(
            f"w* {FILTERED}: the integral is at least c |eta(t)|^2, so eta goes to 0",
            algebra("c*n**2 - c*n*n"),
        ),
    ]


def vehicle_alone(paper: PaperLoop) -> list[Step]:
    """Check the seven steps by which V falls where the vehicle's own track excites.

    T is a window from t on, v a bound of |y|^2 = 2 V in it, k the smaller of KD, |.| the
    mean-square norm over the window, a = |e| and D = |Delta|.  Of axis i, y' = A* y loses at least
    the share delta_i of |y|^2 over the window.
    """
    rate, zero, square = paper.rate, paper.zero, np.sum
    x, e, phi, zc, KD, gamma = (
        paper.x,
        paper.e,
        paper.phi,
        paper.zc,
        paper.KD,
        paper.gamma,
    )
    eta, kappa, nu = paper.eta, paper.kappa, paper.nu
    delta = paper.loop.inputs.get("delta", 0.0)
    # rates of y' = A* y, in which x is in the place of z
    e_rate = -KD * e + eta @ phi + kappa * x + nu * zc
    eta_rate = -gamma * np.outer(e, phi)
    kappa_rate, nu_rate = -gamma * x * e, -gamma * zc * e
    work = square(eta * eta_rate) + square(kappa * kappa_rate) + square(nu * nu_rate)
    return [
        line(
            "1  units: V = |y|^2/2 of y = (e, Y), Y = (eta, kappa, nu)/gamma^(1/2)",
            zero(paper.V - paper.sum_of_squares()),
        ),
        line(
            "2  y' = A* y + d + (Delta, 0), A* of w* = [phi(x), x, zc] alone; d is -kappa e on e "
            "and gamma e^2 on kappa, from z = x - e",
            zero(
                rate(e) - (e_rate - kappa * e + delta),
                rate(eta) - eta_rate,
                rate(kappa) - (kappa_rate + gamma * e**2),
                rate(nu) - nu_rate,
            ),
        ),
        line(
            "3  along y' = A* y |y|^2 falls by 2 int e^T KD e over the window, which is "
            "delta |y|^2 at least",
            paper.positive(KD),
            zero(2 * square(e * e_rate) + 2 * work / gamma + 2 * square(KD * e**2)),
        ),
        line(
            "4  e = Phi_e y(t) + e_1 + e_2 + e_3, from rest by -kappa e, by gamma e^2 and by "
            "Delta: k b^2 <= b u gives |e_1| <= (gamma v)^(1/2) a/k and |e_3| <= D/k, and "
            "k |e_2|^2 <= int p p' = p^2/2 with p = gamma^(1/2) a^2",
            algebra("b*(k*b - u) - (k*b**2 - b*u)", "integrate(s, (s, 0, p)) - p**2/2"),
        ),
        line(
            "5  (c V(t))^(1/2) <= |Phi_e y(t)| <= B a + A a^2 + D/k, c the smaller delta_i/k_i, "
            "B = 1 + (gamma v)^(1/2)/k, A = (gamma/(2 k))^(1/2); the least a is the root",
            algebra(
                "A*((sqrt(B**2 + 4*A*s) - B)/(2*A))**2"
                " + B*(sqrt(B**2 + 4*A*s) - B)/(2*A) - s"
            ),
        ),
        line(
            "6  V(t+T) <= V(t) - k a^2 + a D, and V <= V(t) + D^2/(4 k) within the window",
            algebra("-k*a**2 + a*D - (D**2/(4*k) - k*(a - D/(2*k))**2)"),
        ),
        line(
            "7  D = 0 and c > 0 in every window alike: a > 0 while V > 0, so V falls to 0 from any "
            "start; as V -> 0, a^2 -> c V and V(t+T) <= (1 - k c) V(t)",
            algebra("limit(((sqrt(1 + 4*A*sqrt(c*V)) - 1)/(2*A))**2/V, V, 0) - c"),
        ),
    ]
