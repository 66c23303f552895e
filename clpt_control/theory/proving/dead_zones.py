"""V with a dead zone: V = |D|^2/2 + V_p, D_i = e_i - clip(e_i, -d, d), V_p of the parameters.

D^2/2 has the slope D in e, at the ends of the zone as well, so along the equations

    V' = D^T e' + sum over parameters of dV_p/ds s'

holds everywhere.  With e_i = D_i + clip(e_i, -d, d) in the rates this is a polynomial, and where it
is -D^T KD e the dead zone does what it should: D_i e_i = |D_i| (|D_i| + d) where D_i is not zero.
"""

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...diagrams.interconnection import Diagram
from .quadratic_forms import positive_definite, tidied
from .running_blocks import Reading
from .running_rate import compared
from .symbolic_loop import SymbolicLoop


class DeadZones:
    """V of a loop with a dead zone on each axis, at the numbers `at` of parameters."""

    def __init__(self, loop: SymbolicLoop, V: sympy.Expr, at: dict):
        self.loop, self.at = loop, at
        self.V = sympy.expand(V.xreplace(at))
        self.e = [sympy.expand(value) for value in loop.signals["e"]]
        self.D = [sympy.Symbol(f"D_{i}", real=True) for i in (1, 2)]
        words = [[w for w in self.V.atoms(AppliedUndef) if w.args[0] == e] for e in self.e]
        self.words = [own[0] for own in words if len(own) == 1 and str(own[0].func) == "clip"]

    @property
    def zone(self) -> sympy.Expr | None:
        """d, where V = |D|^2/2 + what holds no e and no word."""
        if len(self.words) != 2:
            return None
        zone = self.words[0].args[2]
        if not zone.is_positive or any(w.args[1:] != (-zone, zone) for w in self.words):
            return None
        held = {s for port in ("x", "z") for s in self.loop.states[port].flat}
        rest = self.of_parameters()
        return None if rest.atoms(AppliedUndef) or rest.free_symbols & held else zone

    def of_parameters(self) -> sympy.Expr:
        """Return V less |D|^2/2."""
        squares = ((e - w) ** 2 / 2 for e, w in zip(self.e, self.words, strict=True))
        return sympy.expand(self.V - sympy.Add(*squares))

    def definite(self, truth: dict) -> bool:
        """Return whether V is positive definite in the parameter errors, and |D|^2/2 the rest."""
        own = {s: value for s, value in truth.items() if s not in self.loop.states["x"]}
        return self.zone is not None and positive_definite(self.of_parameters(), list(own), own, {})

    def rate(self, loop: SymbolicLoop) -> sympy.Expr:
        """Return V' of a loop with these states, clip(e_i) as e_i - D_i."""
        V, total = self.of_parameters(), sympy.Integer(0)
        inner = {w: e - D for w, e, D in zip(self.words, self.e, self.D, strict=True)}
        for s, value in loop.motion.items():
            slope = sympy.diff(V, s)
            for e, D in zip(self.e, self.D, strict=True):
                slope += D * sympy.diff(e, s)
            total += slope * value.xreplace(self.at)
        return tidied(sympy.expand(total).xreplace(inner))

    def beyond(self, loop: SymbolicLoop, KD: list[sympy.Expr]) -> sympy.Expr:
        """Return what V' has beyond -D^T KD e."""
        terms = zip(KD, self.D, self.e, strict=True)
        return tidied(self.rate(loop) + sum(k * D * e for k, D, e in terms))

    def same(self, diagram: Diagram, count: int, seed: int, kept: tuple) -> tuple[bool, str]:
        """Return whether the running blocks have these rates and this V, at random points."""
        wanted = [part.xreplace(self.at) for part in (self.V, *self.loop.motion.values())]
        found = compared(diagram, self.loop, wanted, count, seed, kept=kept, gauge=_numbers)
        if found.where is not None:
            return False, f"differs by {found.worst:.1e} at x = {found.where.x.round(3).tolist()}"
        return True, f"{found.points} points, largest difference {found.worst:.0e}"


def _numbers(
    asked: Reading, t: np.ndarray, x: np.ndarray, u: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return V and all rates at points, (1 + nx, n), and the square of how far the points lie."""
    far = np.max(np.abs(np.column_stack([x, u])), axis=1)
    return np.vstack([asked.values(t, x, u), asked.rates(t, x, u).T]), np.maximum(far, 1.0) ** 2
