"""Excitation in closed form: waypoints on a circle, tides over whole periods.

    int zc zc^T dt = (n tau r^2 / 2) I            n >= 3 waypoints, one cycle, section IV
    int cos^2(omega t + p) dt = T/2               T a whole number of periods, Eq. (5)
    int cos(omega t + p) cos(omega' t + p') dt = 0    whole periods of both, omega != omega'

The sums go through roots of unity: cos^2 a = (1 + cos 2a)/2, and the sum of
exp(4 pi i j / n) over j vanishes exactly where its ratio is not 1, n >= 3.
The tidal terms are the temporal factor of Eq. (5) at one place: along a track the
spatial kernel varies too, and the Gramian must be measured.
"""

import numpy as np
import sympy

from ..blocks.reference import circle
from .proof import Step


def _zero(expression: sympy.Expr) -> bool:
    """Tell whether trigonometric terms cancel, as sums of exponentials."""
    return sympy.simplify(sympy.expand(sympy.expand(expression).rewrite(sympy.exp))) == 0


def geometric_sum() -> list[Step]:
    """Prove that sum_j exp(4 pi i j / n) = 0 for every n >= 3.

    Returns
    -------
    list of Step
        The ratio is a root of unity, is not 1, and the sum telescopes.

    Examples
    --------
    >>> all(step.holds for step in geometric_sum())
    True
    """
    n = sympy.Symbol("n", integer=True, positive=True)
    m = sympy.Symbol("m", integer=True, nonnegative=True)
    q = sympy.Symbol("q")
    ratio = sympy.exp(4 * sympy.pi * sympy.I / n)

    def partial(count: sympy.Expr) -> sympy.Expr:
        return (1 - q**count) / (1 - q)

    angle = 2 * sympy.pi / (m + 3)
    below_pi = sympy.factor(sympy.together(sympy.pi - angle))
    distance = sympy.expand((1 - sympy.cos(2 * angle)) ** 2 + sympy.sin(2 * angle) ** 2)
    return [
        Step(
            "sum_{j<n} q^j = (1 - q^n)/(1 - q) for q != 1",
            _zero(partial(sympy.Integer(1)) - 1)
            and sympy.simplify(partial(n + 1) - partial(n) - q**n) == 0,
            "symbolic",
            "by induction: true for n = 1, and the step from n to n + 1 adds q^n",
        ),
        Step(
            "q^n = 1 for q = exp(4 pi i/n)",
            sympy.powsimp(ratio**n, force=True).equals(1) is True,
            "symbolic",
            "exp(4 pi i) = 1",
        ),
        Step(
            "q != 1 for n >= 3",
            bool(angle.is_positive and below_pi.is_positive)
            and _zero(distance - 4 * sympy.sin(angle) ** 2),
            "symbolic",
            "|1 - q|^2 = 4 sin^2(2 pi/n), and 0 < 2 pi/n < pi for n = m + 3, m >= 0",
        ),
        Step(
            "q = 1 for n = 2: two waypoints are not enough",
            ratio.subs(n, 2) == 1,
            "symbolic",
        ),
    ]


def circle_gramian(counts: range = range(3, 25)) -> list[Step]:
    """Prove the Gramian (n tau r^2/2) I of waypoints on a circle.

    Parameters
    ----------
    counts : range, optional
        Numbers of waypoints for which the block's own points are tried.

    Returns
    -------
    list of Step
        For every n >= 3, then the points that run.

    Examples
    --------
    >>> [step.holds for step in circle_gramian(range(3, 6))]
    [True, True, True, True, True, True, True]
    """
    a = sympy.Symbol("a", real=True)
    power = sympy.exp(2 * sympy.I * a)  # q^j with a = 2 pi j/n
    re, im = sympy.re(power), sympy.im(power)
    cosine, sine = sympy.cos(a), sympy.sin(a)
    entries = _zero(cosine**2 - (1 + re) / 2) and _zero(sine**2 - (1 - re) / 2)
    worst = 0.0
    for n in counts:
        points = circle(3.0, n)
        found = 20.0 * points.T @ points
        worst = max(worst, float(np.abs(found / (n * 20.0 * 9.0 / 2) - np.eye(2)).max()))
    alone = 20.0 * circle(3.0, 2).T @ circle(3.0, 2)
    return [
        *geometric_sum(),
        Step(
            "cos^2 a = (1 + Re q^j)/2, sin^2 a = (1 - Re q^j)/2, cos a sin a = Im q^j/2",
            entries and _zero(cosine * sine - im / 2),
            "symbolic",
            "a = 2 pi j/n; summed over j with sum q^j = 0: n/2, n/2 and 0, times tau r^2",
        ),
        Step(
            "the reference block's own waypoints have the Gramian (n tau r^2/2) I",
            worst < 1e-12,
            "sampled",
            f"n = {counts.start} ... {counts.stop - 1}, largest relative deviation {worst:.1e}",
        ),
        Step(
            "two waypoints excite one direction only",
            float(np.linalg.eigvalsh(alone)[0]) < 1e-12,
            "counterexample",
            "n = 2: zc is never off the x1 axis",
        ),
    ]


def tidal_gramian() -> list[Step]:
    """Prove the integrals of tides over whole periods.

    Returns
    -------
    list of Step
        Squares give T/2, products of different tides and of a tide with a
        steady function give zero.

    Examples
    --------
    >>> [step.holds for step in tidal_gramian()]
    [True, True, True]
    """
    t, p, p2 = sympy.symbols("t p p'", real=True)
    T = sympy.Symbol("T", positive=True)
    one, more = sympy.symbols("m d", integer=True, positive=True)
    slow, fast = 2 * sympy.pi * one / T, 2 * sympy.pi * (one + more) / T

    def tide(omega: sympy.Expr, phase: sympy.Expr) -> sympy.Expr:
        return sympy.cos(omega * t + phase)

    def integral(antiderivative: sympy.Expr, integrand: sympy.Expr) -> sympy.Expr | None:
        """Give F(T) - F(0), if F' is the integrand."""
        if not _zero(sympy.diff(antiderivative, t) - integrand):
            return None
        whole = antiderivative.subs(t, T) - antiderivative.subs(t, 0)
        return sympy.simplify(sympy.expand_trig(sympy.expand(whole)))

    def wave(omega: sympy.Expr, phase: sympy.Expr) -> sympy.Expr:
        return sympy.sin(omega * t + phase) / omega

    square = integral(t / 2 + wave(2 * slow, 2 * p) / 2, tide(slow, p) ** 2)
    cross = integral(
        (wave(fast - slow, p2 - p) + wave(fast + slow, p2 + p)) / 2, tide(slow, p) * tide(fast, p2)
    )
    steady = integral(wave(slow, p) * sympy.cos(p2), tide(slow, p) * sympy.cos(p2))
    return [
        Step(
            "int_0^T cos^2(2 pi m t/T + p) dt = T/2 for whole m >= 1",
            square is not None and sympy.simplify(square - T / 2) == 0,
            "symbolic",
            "antiderivative checked by differentiating, taken between 0 and T",
        ),
        Step(
            "int_0^T cos(2 pi m t/T + p) cos(2 pi m' t/T + p') dt = 0 for m' > m >= 1",
            cross == 0,
            "symbolic",
            "m' = m + d with d >= 1; any phases",
        ),
        Step(
            "int_0^T cos(2 pi m t/T + p) cos(p') dt = 0: a tide and a steady function",
            steady == 0,
            "symbolic",
        ),
    ]
