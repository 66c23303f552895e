"""A rate at which errors fall, certified by a Lyapunov function along a Riccati equation.

In coordinates in which V is |e|^2 + |th|^2, for one e: e' = -a e + w^T th, th' = -w e.  With p,
kappa, rho, C, D > 0, z = e - f^T th and b = f^T w

    f' = -p f + w
    R' = -rho R - rho C I + f f^T - kappa R w w^T R
    U  = C V + D z^2 + th^T R th
    U' + rho U = -E e^2 + 2 X(b) e z - Z z^2 - (e + kappa w^T R th)^2 / kappa
    E = (2 a - rho) C - 1 - 1/kappa,  X(b) = D (p - a + b) - 1,  Z = (2 p - rho) D - 1

so V <= U(0)/C exp(-rho t) if Z > 0, X(b0)^2 <= E Z, X(b1)^2 <= E Z, exact in rationals, and along
the run R >= 0 and b0 <= b <= b1: two facts.  f and R need w alone, no truth.  R starts at the
periodic solution of its equation, the largest, so the facts hold for good where the window repeats.
`theory/coq/Rate.v` has the proof for any number of parameters.
"""

# w is constant in each piece, its mean.  f is exact, and b monotone in a piece.  A step of R is
#
#     R -> H + A^T R (I + G R)^-1 A
#
# from the exponential of the Hamiltonian; squaring that of the window gives the periodic solution.

from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from itertools import accumulate, product
from typing import Any

import numpy as np
from scipy.linalg import expm

from ...base.errors import DataError
from ...base.units import at_most
from ..proofs.in_coq import PRELUDE
from .certificates import finely

NAMES = "a", "p", "kappa", "rho", "b0", "b1", "C", "D", "overshoot"
FINE = 30  # pieces of the paper's regressor in one of the contraction's
COARSE = 300  # pieces in the search
SQUARINGS = 12  # windows after which R is periodic: 2 to this power
CONVERGED = 1e-10
FIRST = 1e-3  # share of the contraction's rate at which the search begins


def rational(x: float) -> Fraction:
    """Return a number of four digits."""
    return Fraction(f"{x:.4g}")


@dataclass(frozen=True)
class Riccati:
    """A certified rate of one e: V <= overshoot V(start) exp(-rho (t - start))."""

    constants: dict[str, Any]  # by NAMES: rationals
    f: np.ndarray  # at the start
    R: np.ndarray
    pieces: int

    def __repr__(self) -> str:
        return f"<Riccati: {self.sentence}>"

    @property
    def half_life(self) -> float:
        """Time in which the root of V halves, at most, but for that of the overshoot."""
        return float(2 * np.log(2) / self.constants["rho"])

    @property
    def sentence(self) -> str:
        """The certificate and its two facts."""
        b0, b1, c = (float(self.constants[name]) for name in ("b0", "b1", "overshoot"))
        return (
            f"errors halve at least every {at_most(self.half_life)}, but for a factor "
            f"{at_most(c**0.5)}, while R >= 0 and {b0:.4g} <= f'w <= {b1:.4g}: at the ends of "
            f"{self.pieces} pieces of the window, repeated, w their mean"
        )

    def coq(self) -> str:
        """Return the rate as a file that Coq checks alone."""
        names = "Runs.v", "Rate.v", "rate_file.txt"
        runs, lemma, file = (
            PRELUDE.with_name(name).read_text("utf-8") for name in names
        )
        given = {name: f"({value})" for name, value in self.constants.items()}
        file = file.format(n=len(self.f), sentence=self.sentence, **given)
        return runs + lemma.replace("From Clpt Require Import Runs.", "") + file


def joined(first: Any, second: Any) -> Any:
    """Return A, G and H of two steps of R."""
    (A, G, H), (B, K, L) = first, second
    W = np.linalg.inv(np.eye(len(A)) + K @ H)
    return A @ W @ B, G + A @ W @ K @ A.T, L + B.T @ H @ W @ B


def tried(
    h: np.ndarray,
    w: np.ndarray,
    a: Fraction,
    p: Fraction,
    kappa: Fraction,
    rho: Fraction,
) -> Riccati | None:
    """Return the certificate with these weights for w (pieces, n), which last h, if there is one."""
    # Step 1: f, periodic, and bounds of b
    decay = np.exp(-float(p) * h)[:, None]
    steps = [*zip(decay, (1 - decay) / float(p) * w, strict=True)]

    def filtered(first: np.ndarray) -> np.ndarray:
        return np.array(
            [*accumulate(steps, lambda f, x: x[0] * f + x[1], initial=first)]
        )

    f = filtered(filtered(0 * w[0])[-1] / (1 - np.prod(decay)))
    b = np.sum([f[:-1] * w, f[1:] * w], axis=2)
    off = 1e-3 * np.abs(b).max()
    b0, b1 = rational(b.min() - off), rational(b.max() + off)
    # Step 2: D that makes X least, and C
    middle = p - a + (b0 + b1) / 2
    if not (0 < middle < 2 * p - rho and rho < 2 * a):
        return None
    D = 1 / middle
    lost = (D * (b1 - b0) / 2) ** 2 / ((2 * p - rho) * D - 1)
    C = (1 + 1 / kappa + lost) / (2 * a - rho)
    # Step 3: R, periodic
    identity = np.eye(w.shape[1])
    n = len(identity)
    pull, push = (x[:, :, None] * x[:, None] for x in (w, (f[1:] + f[:-1]) / 2))
    half = 0 * pull + float(rho) / 2 * identity
    hamiltonian = np.block(
        [[half, float(kappa) * pull], [push - float(rho * C) * identity, -half]]
    )
    moves = expm(hamiltonian * h[:, None, None])
    A = np.linalg.inv(moves[:, :n, :n])
    maps = [*zip(A, A @ moves[:, :n, n:], moves[:, n:, :n] @ A, strict=True)]
    whole = reduce(joined, maps)
    for _ in range(SQUARINGS):
        whole = joined(whole, whole)
    R = np.array([H for _, _, H in accumulate(maps, joined, initial=whole)])
    values = np.linalg.eigvalsh(R)
    if not (np.abs(whole[0]).max() < CONVERGED and values.min() > 0):
        return None
    overshoot = rational(1 + 1.001 * (D * (1 + f[0] @ f[0]) + values[0, -1]) / C)
    constants = a, p, kappa, rho, b0, b1, C, D, overshoot
    return Riccati(dict(zip(NAMES, constants, strict=True)), f[0], R[0], len(w))


def largest(h: np.ndarray, w: np.ndarray, a: Fraction, first: float) -> Riccati | None:
    """Search the weights p and kappa for the largest rho."""
    cuts = np.unique(np.linspace(0, len(h), COARSE, endpoint=False).astype(int))
    spans = np.add.reduceat(h, cuts)
    coarse = spans, np.add.reduceat(h[:, None] * w, cuts) / spans[:, None], a
    rho, best = FIRST * first, None
    grid = product(float(a) * np.geomspace(0.3, 10, 9), np.geomspace(0.5, 70, 9))
    for weights in grid:
        at = [rational(x) for x in weights]
        high, tip, before = 2 * float(a), 1.02 * rho, rho
        while tip < 0.98 * high:
            if tried(*coarse, *at, rational(tip)):
                rho, best = tip, at
            elif rho == before:
                break
            else:
                high = tip
            tip = np.sqrt(rho * high)
    while best and rho > FIRST / 2 * first:
        if found := tried(h, w, a, *best, rational(rho)):
            return found
        rho *= 0.98
    return None


def riccati_of(excitation: Any) -> dict[str, Riccati]:
    """Return the certified rate of each axis of an excitation."""
    form, w, weights = excitation.form, excitation.w, excitation.weights
    drops = excitation.certificate().drops
    if form:
        A, w = [-form.A[0]], form.left[0, 0] * w @ form.right
    else:
        gains = excitation.gains
        A = excitation.scenario.vehicle.feedback
        w, weights = finely(FINE * np.sqrt(gains) * w[..., gains > 0], weights)
        w = w / FINE
    h, found = weights.sum(axis=1), {}
    for (axis, drop), a, at_nodes in zip(drops.items(), A, w, strict=True):
        mean = np.sum(weights[..., None] * at_nodes, axis=1) / h[:, None]
        rate = largest(h, mean, Fraction(str(a)), -np.log1p(-drop) / excitation.window)
        if rate is None or len(A) > len(w):
            raise DataError(
                f"no rate: {axis}: no weights of the Riccati certificate were found. certificate() "
                "has a half-life if all parameters are excited"
            )
        found[axis] = rate
    return found
