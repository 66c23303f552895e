"""What the theorems assume of Delta and of a gridded F_R, on the blocks that run.

Delta of Eq. (32) is bounded and starts as it says; a gridded flow is the cubic
spline that goes through linear flows exactly and is held at its edges.
"""

import math
from fractions import Fraction
from functools import partial
from types import FunctionType

import numpy as np
import sympy

from ..blocks import Guard, disturbance, field
from ..blocks.readers import rebind, traced
from .proof import Step, checked


def disturbance_steps() -> list[Step]:
    """Check that Delta of Eq. (32) is bounded and starts right.

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

    def exact() -> bool:
        """Interval arithmetic over all seeds, intervals, axes and streams."""
        M, arguments = int(disturbance.MODULUS), []

        def remainder(a):
            arguments.append(a)
            return sympy.AccumBounds(0, M - 1)

        space = {**disturbance.scramble.__globals__, "remainder": remainder}
        hashed = FunctionType(disturbance.scramble.__code__, space)
        for axis in range(2):
            for stream in range(2):
                any_whole = sympy.AccumBounds(0, M - 1)
                fraction = hashed(any_whole, any_whole, axis, stream)
                if not (fraction.min > 0 and fraction.max < 1):
                    return False
        small = [disturbance.remainder(a) for a in (0.0, 5.0, M, 2.0 * M + 7.0, 3.0 * M - 1.0)]
        ends = [(a.min, a.max) if isinstance(a, sympy.AccumBounds) else (a, a) for a in arguments]
        return small == [0, 5, 0, 7, M - 1] and all(low >= 0 and high < 2**53 for low, high in ends)

    return [
        checked("Eq. (32), noise: the hash works on whole numbers in [0, 2^53), exactly, and "
                "gives fractions in (0, 1)", "symbolic", exact),
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
    other = [Fraction(7 - 2 * int(a) + int(b) + 5 * int(c)) for a, b, c in zip(*axes, strict=True)]
    linear = [Fraction(int(a) + 10 * int(b) - 3 * int(c)) for a, b, c in zip(*axes, strict=True)]

    def exact(function=field.gridded, extra=(), added=(0, 0)):
        return all(
            flow(t, x2, x1, other, linear, function, extra)
            == [7 - 2 * t + x2 + 5 * x1 + added[0], t + 10 * x2 - 3 * x1 + added[1]]
            for t, x2, x1 in places
        )

    def held() -> bool:
        inside = flow(5, 1, 15, other, linear)
        outside = flow(9, 7, 99, other, linear)
        below, start_of_all = flow(-9, -7, -99, other, linear), flow(1, -2, 3, other, linear)
        return inside == outside and np.allclose(
            np.array(below, float), np.array(start_of_all, float), rtol=0, atol=1e-12
        )

    def told() -> bool:
        sides = [np.array(a, dtype=float) for a in (shape, start, step)]
        p = field.FieldParameters(sides[0], sides[1], sides[2], np.zeros(0), np.zeros(0))
        guard = Guard(field.inside, "raise", lambda t, u, p: "")
        places = ((2.0, 6.0, 0.0), (2.0, 0.0, 0.0), (6.0, 6.0, 0.0))
        near = [guard.margin(t, np.array([x1, x2]), p) for t, x1, x2 in places]
        return np.allclose(near, [0.5, -1.0, -0.5], atol=1e-14) and math.isfinite(near[0])

    disturbed = partial(exact, field.gridded_disturbed, (5, 7), (5, 7))
    return [
        checked("gridded F_R: linear flows are reproduced exactly", "symbolic",
                exact),
        checked("gridded F_R with Delta: Eq. (32), the two are added", "symbolic", disturbed),
        checked("gridded F_R: held at the edges, so bounded", "symbolic", held),
        checked("gridded F_R: the guard is positive inside, negative outside", "symbolic", told),
    ]  # fmt: skip
