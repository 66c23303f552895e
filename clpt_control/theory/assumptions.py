"""What the theorems assume of the sources, checked on the blocks that run.

The proofs leave phi and zc undefined: they hold for all of them that are
bounded, piecewise smooth and what they say they are.  That is checked here, by
properties that pin each source down: bounds, symmetries, values at special
points.  Delta and a gridded F_R are in `flow_assumptions`.
"""

import numpy as np
import sympy

from ..blocks import basis, reference
from ..blocks.readers import traced
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
    """Check that phi of Eq. (5) is bounded, even and isotropic.

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
