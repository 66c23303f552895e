"""What the theorems assume of the sources, checked on the blocks that run.

The proofs leave phi, zc, Delta and a gridded F_R undefined: they hold for all
of them that are bounded, piecewise smooth and what they say they are.  That is
checked here, by properties that pin each source down: bounds, symmetries,
values at special points, and exact reproduction of polynomials.
"""

import math
from fractions import Fraction
from functools import partial

import numpy as np
import sympy

from ..blocks import basis, disturbance, field, reference
from ..blocks.readers import rebind, traced
from .proof import Step, checked


def phi_at(kernel: str, position: tuple, t: sympy.Expr) -> sympy.Expr:
    """One basis function at a place, with its own symbols."""
    s = sympy.Symbol("sigma", positive=True)
    omega, phase = sympy.symbols("omega phase", real=True)
    center = np.array([sympy.symbols("c_1 c_2", real=True)], dtype=object)
    p = basis.BasisParameters(1, center, np.array([s]), np.array([omega]), np.array([phase]))
    u = np.array(position, dtype=object)
    return traced(basis.KERNELS[kernel], t, np.zeros(0), u, p, 1)[0]


def basis_steps() -> list[Step]:
    """Check that phi of Eq. (5) is bounded, even, isotropic and placed.

    Returns
    -------
    list of Step
        Five for each kernel.

    Examples
    --------
    >>> all(step.holds for step in basis_steps())
    True
    """
    c1, c2, a, b, t = sympy.symbols("c_1 c_2 a b t", real=True)
    omega, phase = sympy.symbols("omega phase", real=True)
    tide = sympy.cos(omega * t + phase)
    steps = []
    for kernel in basis.KERNELS:

        def at(x1, x2, kernel=kernel, time=t):
            return phi_at(kernel, (c1 + x1, c2 + x2), time)

        def bounded(at=at):
            exponents = at(a, b).atoms(sympy.exp)
            others = at(a, b).subs(dict.fromkeys(exponents, 1))
            return (
                len(exponents) == 1
                and all(e.args[0].is_nonpositive for e in exponents)
                and sympy.simplify(others**2 - tide**2) == 0
            )

        def decays(at=at):
            two = (at(2, 0) / at(1, 0)).subs(sympy.Symbol("sigma", positive=True), 1)
            return sympy.simplify(two).is_positive and sympy.N(two) < 1

        for claim, check in (
            ("|phi| <= 1: the exponent is not positive and multiplies one cosine", bounded),
            ("phi(c + d) = phi(c - d)", lambda at=at: sympy.simplify(at(a, b) - at(-a, -b)) == 0),
            (
                "phi depends on the distance alone",
                lambda at=at: sympy.simplify(at(a, b) - at(b, -a)) == 0,
            ),
            (
                "phi(c, t) = cos(omega t + phase)",
                lambda at=at: sympy.simplify(at(0, 0) - tide) == 0,
            ),
            ("phi decreases with distance", decays),
        ):
            steps.append(checked(f"Eq. (5), {kernel}: {claim}", "symbolic", check))
    return steps


def reference_steps() -> list[Step]:
    """Check that zc takes the waypoints in turn, each for its dwell.

    Returns
    -------
    list of Step
        Exact values.

    Examples
    --------
    >>> all(step.holds for step in reference_steps())
    True
    """
    points = np.array([[3.0, 1.0], [-2.0, 5.0], [7.0, -4.0]])

    def in_turn() -> bool:
        block = reference.reference(points, 20.0)
        zc = [block.output(20.0 * j + 7.0, [], []) for j in range(7)]
        return np.array_equal(zc, points[[0, 1, 2, 0, 1, 2, 0]])

    def switches() -> bool:
        block = reference.reference(points, 0.1)
        pieces = [block.breakpoints(0.1 * j, 0.1 * j + 1.0) for j in (0, 3, 40)]
        return all(
            np.array_equal(piece, 0.1 * np.arange(j + 1, j + len(piece) + 1)) and len(piece) >= 9
            for j, piece in zip((0, 3, 40), pieces, strict=True)
        )

    def on_circle() -> bool:
        w = reference.circle(2.0, 8)
        turned = np.column_stack([-w[:, 1], w[:, 0]])
        return (
            np.allclose(np.hypot(*w.T), 2.0, atol=1e-14)
            and np.allclose(np.roll(w, -2, axis=0), turned, atol=1e-14)
            and np.allclose(w[0], [2.0, 0.0], atol=1e-14)
        )

    return [
        checked("section IV: waypoints are taken in turn and start again", "symbolic", in_turn),
        checked("section IV: zc jumps at k tau, k = 1, 2, ...", "symbolic", switches),
        checked("section IV: circle waypoints lie at r, from (r, 0), turning left", "symbolic",
                on_circle),
    ]  # fmt: skip


def disturbance_steps() -> list[Step]:
    """Check that each Delta of Eq. (32) is bounded and starts as it says.

    Returns
    -------
    list of Step
        The noise is sampled, the others exact.

    Examples
    --------
    >>> all(step.holds for step in disturbance_steps())
    True
    """
    a1, a2 = sympy.symbols("a_1 a_2", real=True)
    t, period = sympy.Symbol("t", real=True), sympy.Symbol("T", positive=True)

    def value(kind: str, time: sympy.Expr, interval: int = 0) -> np.ndarray:
        p = disturbance.DisturbanceParameters(np.array([a1, a2]), period, 0, interval)
        return traced(disturbance.KINDS[kind][0], time, np.zeros(0), np.zeros(0), p, 2)

    def sine() -> bool:
        quarters = [list(value("sine", period * q / 4)) for q in range(5)]
        return quarters == [[0, 0], [a1, a2], [0, 0], [-a1, -a2], [0, 0]] and all(
            sympy.simplify(value("sine", t)[i] ** 2 + value("sine", t + period / 4)[i] ** 2
                           - (a1, a2)[i] ** 2) == 0 for i in range(2)
        )  # fmt: skip

    def square() -> bool:
        halves = [list(value("square", t, interval)) for interval in range(4)]
        block = disturbance.disturbance("square", [1.0, 1.0], period=2.0)
        return halves == [[a1, a2], [-a1, -a2]] * 2 and np.array_equal(
            block.breakpoints(0.0, 3.5), [1.0, 2.0, 3.0]
        )

    def noise() -> tuple[bool, str]:
        draws = np.array([[disturbance.normal(7.0, float(k), i) for i in range(2)]
                          for k in range(4000)])  # fmt: skip
        fractions = [disturbance.scramble(3.0, float(k), 1, 0) for k in range(1000)]
        mean, size = np.abs(draws.mean(0)).max(), np.abs(draws.std(0) - 1).max()
        together = abs(np.corrcoef(draws.T)[0, 1])
        good = max(mean, size, together) < 0.06 and 0 < min(fractions) < max(fractions) < 1
        return good, f"mean {mean:.3f}, deviation off {size:.3f}, correlation {together:.3f}"

    return [
        checked("Eq. (32), constant: Delta = a", "symbolic",
                lambda: list(value("constant", t)) == [a1, a2]),
        checked("Eq. (32), sine: 0, a, 0, -a at quarter periods, |Delta_i| <= |a_i|", "symbolic",
                sine),
        checked("Eq. (32), square: a, then -a, jumping each half period", "symbolic", square),
        checked("Eq. (32), noise: standard normal, axes apart", "sampled", noise),
    ]  # fmt: skip


def field_steps() -> list[Step]:
    """Check that a gridded F_R is the cubic spline it says it is.

    A piecewise cubic is pinned down in a cell by four points along each axis;
    the checks run in exact fractions on grids with unequal sides.

    Returns
    -------
    list of Step
        Partition of unity, linear reproduction, held edges.

    Examples
    --------
    >>> all(step.holds for step in field_steps())
    True
    """
    shape, start, step = (3, 4, 5), (1, -2, 3), (2, 1, 3)
    grid = np.meshgrid(*(np.arange(-1, n + 1) for n in shape), indexing="ij")
    axes = [np.array([start[k] + step[k] * int(i) for i in g.ravel()]) for k, g in enumerate(grid)]

    def flow(t, x2, x1, u, v, function=field.gridded, extra=()):
        as_objects = partial(np.array, dtype=object)
        p = field.FieldParameters(
            as_objects(shape), as_objects(start), as_objects(step), as_objects(u), as_objects(v)
        )
        y = np.empty(2, dtype=object)
        exact_words = rebind(function, {"floor": math.floor})
        exact_words(t, (), as_objects([x1, x2, *extra]), p, y)
        return list(y)

    quarters = [Fraction(k, 4) for k in range(4)]
    places = [
        (start[0] + step[0] * (i + a), start[1] + step[1] * (j + b), start[2] + step[2] * (k + c))
        for i, j, k in ((0, 0, 0), (1, 2, 3), (0, 1, 2))
        for a in quarters
        for b in quarters
        for c in quarters
    ]
    ones = [Fraction(1)] * len(axes[0])
    linear = [Fraction(int(a) + 10 * int(b) - 3 * int(c)) for a, b, c in zip(*axes, strict=True)]

    def exact(function=field.gridded, extra=(), added=(0, 0)):
        return all(
            flow(t, x2, x1, ones, linear, function, extra)
            == [1 + added[0], t + 10 * x2 - 3 * x1 + added[1]]
            for t, x2, x1 in places
        )

    def held() -> bool:
        inside = flow(5, 1, 15, ones, linear)
        outside = flow(9, 7, 99, ones, linear)
        below, start_of_all = flow(-9, -7, -99, ones, linear), flow(1, -2, 3, ones, linear)
        return inside == outside and np.allclose(
            np.array(below, float), np.array(start_of_all, float), rtol=0, atol=1e-12
        )

    def told() -> bool:
        p = field.FieldParameters(*(np.array(a, dtype=float) for a in (shape, start, step)), 0, 0)
        near = [field.distance_inside(2.0, np.array([6.0, 0.0]), p),
                field.distance_inside(2.0, np.array([0.0, 0.0]), p),
                field.distance_inside(6.0, np.array([6.0, 0.0]), p)]  # fmt: skip
        return np.allclose(near, [0.5, -1.0, -0.5], atol=1e-14) and math.isfinite(near[0])

    disturbed = partial(exact, field.gridded_disturbed, (5, 7), (5, 7))
    return [
        checked("gridded F_R: constants and linear flows are reproduced exactly", "symbolic",
                exact),
        checked("gridded F_R with Delta: Eq. (32), the two are added", "symbolic", disturbed),
        checked("gridded F_R: held at the edges, so bounded", "symbolic", held),
        checked("gridded F_R: the guard is positive inside, negative outside", "symbolic", told),
    ]  # fmt: skip
