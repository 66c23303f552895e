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
`theory/coq/rate.txt` has the proof for any number of parameters.
"""

# w is constant in each piece.  f is exact, and b monotone in a piece.  A step of R is
#
#     R -> H + A^T R (I + G R)^-1 A
#
# from the exponential of the Hamiltonian; squaring that of the window gives the periodic solution.
# Between its ends R > 0 as well, since (R^-1)' <= rho R^-1 + rho C R^-2 + kappa w w^T.

from dataclasses import dataclass
from fractions import Fraction
from itertools import accumulate, product
from string import Template
from typing import Any

import numpy as np
from scipy.linalg import expm

from ...base.errors import DataError
from ..proofs.in_coq import PRELUDE
from .certificates import halving_text

COARSE = 400, 4000  # pieces in the search, between them one for each radian of e and th
SQUARINGS = 12  # windows after which R is periodic: 2 to this power
CONVERGED = 1e-10
LARGEST = 10.0  # entry of a step of R, whose inverse has its digits
SMALLEST = 1e-6  # rho/a
MOST = 12  # parameters of a search of few seconds
SHARES = 0.6, 0.8, 1.05, 1.4, 2, 3, 6  # p/a
KAPPAS = 0.5, 1.5, 4, 10, 25, 70


def rational(x: float) -> Fraction:
    """Return a number of four digits."""
    return Fraction(f"{x:.4g}")


@dataclass(frozen=True)
class Riccati:
    """A certified rate of one e: V <= overshoot V(start) exp(-rho (t - start))."""

    constants: dict[str, Any]  # a, p, kappa, rho, b0, b1, C, D, overshoot: rationals
    # at the start, in coordinates U th with U^T U = G^-1, U upper triangular
    f: np.ndarray
    R: np.ndarray
    pieces: int

    def __repr__(self) -> str:
        return f"<Riccati: {self.sentence()}>"

    def sentence(self, unit: str = "") -> str:
        """Return the half-life of errors, and its two facts."""
        b0, b1 = self.report["b"]
        return (
            f"{halving_text(self, unit)} while R >= 0 and {b0:.4g} <= f'w <= {b1:.4g}: both hold "
            f"in the window repeated, with w constant in each of {self.pieces} pieces"
        )

    @property
    def report(self) -> dict[str, Any]:
        """The same as JSON values."""
        b = [float(self.constants[name]) for name in ("b0", "b1")]
        return {"half_life": self.half_life, "overshoot": self.overshoot, "b": b}

    @property
    def overshoot(self) -> float:
        """Root of V / (its first / 2^(t/half_life)), at most."""
        return float(self.constants["overshoot"]) ** 0.5

    @property
    def half_life(self) -> float:
        """Time in which the root of V halves, at most, but for that of the overshoot."""
        return float(2 * np.log(2) / self.constants["rho"])

    def in_unit(self, a: Any) -> "Riccati":
        """Return the same where time was in units of 1/a."""
        powers = {"a": 1, "p": 1, "rho": 1, "b0": 1, "b1": 1, "C": -1, "D": -1}
        constants = {k: x * a ** powers.get(k, 0) for k, x in self.constants.items()}
        return Riccati(constants, self.f, self.R / float(a), self.pieces)

    def coq(self) -> str:
        """Return the rate as a file that Coq checks alone."""
        given = {name: f"({value})" for name, value in self.constants.items()}
        file = Template(PRELUDE.with_name("rate.txt").read_text("utf-8"))
        text = file.substitute(given, n=len(self.f), certificate=self)
        return PRELUDE.read_text("utf-8") + text


def joined(first: Any, second: Any) -> Any:
    """Return A, G and H (..., n, n) of two steps of R."""
    (A, G, H), (B, K, L) = first, second
    W = np.linalg.inv(np.eye(A.shape[-1]) + K @ H)
    return A @ W @ B, G + A @ W @ K @ A.mT, L + B.mT @ H @ W @ B


def all_joined(steps: Any) -> Any:
    """Return A, G and H of all steps (pieces, n, n), joined by pairs."""
    while (count := len(steps[0])) > 1:
        last = count - count % 2
        pairs = joined(*([x[k:last:2] for x in steps] for k in (0, 1)))
        steps = [np.append(x, y[last:], 0) for x, y in zip(pairs, steps, strict=True)]
    return [x[0] for x in steps]


def tried(h: np.ndarray, w: np.ndarray, *weights: Fraction) -> Riccati | None:
    """Return the certificate with a, p, kappa and rho for w (pieces, n) of lengths h, or None."""
    a, p, kappa, rho = weights
    # Step 1: f, periodic, and bounds of b
    decay = np.exp(-float(p) * h)[:, None]
    steps = [*zip(decay, (1 - decay) / float(p) * w, strict=True)]

    def filtered(first: np.ndarray) -> np.ndarray:
        return np.array(
            [*accumulate(steps, lambda f, x: x[0] * f + x[1], initial=first)]
        )

    f = filtered(filtered(0 * w[0])[-1] / (1 - np.prod(decay)))
    b = np.sum([f[:-1] * w, f[1:] * w], axis=2)
    off = 1e-2 * np.abs(b).max()
    b0, b1 = rational(b.min() - off), rational(b.max() + off)
    # Step 2: D that makes X least, and C
    middle = p - a + (b0 + b1) / 2
    if not (0 < middle < 2 * p - rho and rho < 2 * a):
        return None
    D = 1 / middle
    lost = (D * (b1 - b0) / 2) ** 2 / ((2 * p - rho) * D - 1)
    C = (1 + 1 / kappa + lost) / (2 * a - rho)
    # Step 3: R, periodic
    n = w.shape[1]
    pull, push = (x[:, :, None] * x[:, None] for x in (w, (f[1:] + f[:-1]) / 2))
    half = 0 * pull + float(rho) / 2 * np.eye(n)
    push -= float(rho * C) * np.eye(n)
    rates = np.block([[half, float(kappa) * pull], [push, -half]]) * h[:, None, None]
    if np.abs(rates).max() > LARGEST:
        return None
    moves = expm(rates)
    A = np.linalg.inv(moves[:, :n, :n])
    maps = A, A @ moves[:, :n, n:], moves[:, n:, :n] @ A
    whole = all_joined(maps)
    for _ in range(SQUARINGS):
        whole = joined(whole, whole)
    if not (np.abs(whole[0]).max() < CONVERGED and np.linalg.eigvalsh(whole[2])[0] > 0):
        return None
    along = accumulate(zip(*maps, strict=True), joined, initial=whole)
    R = np.array([H for _, _, H in along])
    values = np.linalg.eigvalsh(R)
    # Step 4: |R^-1| stays below this within each piece
    most = 2 / values[:-1, 0] + 2 * float(kappa) * h * np.sum(w**2, axis=1)
    twice = 2 * h * float(rho) * (1 + float(C) * most)
    if values.min() <= 0 or twice.max() > 1:
        return None
    overshoot = rational(1 + 1.001 * (D * (1 + f[0] @ f[0]) + values[0, -1]) / C)
    constants = {
        "a": a, "p": p, "kappa": kappa, "rho": rho, "b0": b0, "b1": b1, "C": C, "D": D,
        "overshoot": overshoot,
    }  # fmt: skip
    return Riccati(constants, f[0], R[0], len(w))


def riccati_of(excitation: Any) -> dict[str, Any]:
    """Search the weights p and kappa for the largest rate of each axis; return those found."""
    # Step 1: w, constant in pieces about the nodes
    if excitation.certificate().half_life is None:
        raise DataError("no Riccati certificate: not all parameters are excited enough")
    excitation = excitation.exact
    w, h, found = excitation.w @ excitation.scale, excitation.weights.ravel(), {}
    for axis, k, at_nodes in zip(
        excitation.names, excitation.feedback, w, strict=False
    ):
        # time in 1/a: the weights are those of no unit
        a, one = Fraction(str(k)), Fraction(1)
        h_a, pieces = h * float(a), at_nodes.reshape(len(h), -1) / float(a)
        # Step 2: the largest rho in fewer, longer pieces
        turns = h_a @ np.linalg.norm(pieces, axis=1)
        thin = slice(None, None, 1 + len(h) // int(np.clip(turns, *COARSE)))
        fewer = h_a[thin] * thin.step, pieces[thin]
        rho, best = SMALLEST, (one, one, one)
        for factor, share, kappa in product((5, 1.5, 1.1, 1.02), SHARES, KAPPAS):
            at = one, rational(share), rational(kappa)
            while tried(*fewer, *at, rational(rho * factor)):
                rho, best = rho * factor, at
        # Step 3: in all pieces
        rates = (tried(h_a, pieces, *best, rational(rho * 0.95**k)) for k in range(12))
        if rate := next(filter(None, rates), None):
            found[axis] = rate.in_unit(a)
    if not found:
        raise DataError(
            "no Riccati certificate: e has several components, or no weights were found. Use "
            "the half-life of the contraction"
        )
    return found
