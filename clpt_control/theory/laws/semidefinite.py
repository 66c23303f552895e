"""Symmetric matrices M >= 0 among the states of a law's loop, and what V then bounds.

c^T M' c >= 0  where  M c = 0         M stays semidefinite (Nagumo)
F = F(M = 0) + sum tr(M S) >= 0       if F(M = 0) >= 0 and each S >= 0
"""

from collections.abc import Set
from functools import cached_property
from itertools import combinations_with_replacement
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...paper.laws.law import LEARNED
from ..algebra.decide import groups_never_positive
from ..algebra.exact import as_factors, nonzero_residual, vanishes
from ..algebra.sums_of_squares import contains_all, squares
from ..algebra.texts import short
from ..proofs.symbolic_loop import equated
from .invariant_loop import InvariantLoop, arbitrary
from .theorem_loop import ErrorCoordinates


class SemidefiniteLoop(InvariantLoop):
    """A law's closed loop with its semidefinite matrices."""

    def semidefinite_after_a_jump(self) -> bool:
        """Return whether c^T M c is not negative after a jump, for every M >= 0 and c."""
        for after in self.loop.jumps_at_once():
            for M in self.matrices.values():
                c = arbitrary(len(M))
                new = np.array(
                    [[after.get(m, m) for m in row] for row in M], dtype=object
                )
                form = self.masked(sympy.expand(c @ new @ c))
                if not self.not_negative(form, set(c)):
                    return False
        return True

    def estimate_grows(self) -> str:
        """Return what (d M^-1 d^T)' = error_growth <= 0 fails by, or nothing.

        d = theta_hat - theta.  With M = M^T and d = c M, whatever c is: 2 d' c^T - c M' c^T.
        """
        if self.loop.jumps:
            return "its states jump, and what its error does there is not judged"
        (port,) = self.matrices
        M, c = self.symmetric[port], self.c
        if np.any(M != M.T):
            return f"left over: {short(M[0, 1] - M[1, 0])}"
        theta = self.loop.parameters["true_flow"].theta
        substitutions = equated(self.states, {"theta_hat": theta + c @ M})
        rate = 2 * np.sum(self.rates["theta_hat"] * c)
        rate -= np.sum((c @ self.rates[port]) * c)
        if not self.error_growth.is_nonpositive:
            return "what it gains may be positive"
        excess = sympy.sympify(rate - self.error_growth).xreplace(substitutions)
        return nonzero_residual(self.reduced(excess))

    def stays_semidefinite(self, port: str) -> bool:
        """Return whether c^T M' c is not negative where M c = 0, for every c."""
        M = self.matrices[port]
        form = as_factors(self.rate_where(port, np.zeros(len(M), dtype=object)))
        return bool(form.is_nonnegative) and not self.forks(self.form_of_rate(port))

    def form_of_rate(self, port: str) -> sympy.Expr:
        """Return c^T M' c, whatever c is, with 1 for its last element.

        As c^T M' c has the sign of c^T M' c/c_n^2, c_n is 1; where it is 0, M and c are rotated a
        little.
        """
        c = arbitrary(len(self.matrices[port]))
        form = sympy.sympify(c @ self.rates[port] @ c)
        return form.xreplace({c[-1]: sympy.S.One})

    def rate_where(self, port: str, K: np.ndarray) -> sympy.Expr:
        """Return c^T M' c where M c = K c, K diagonal."""
        M = self.symmetric[port].copy()
        c = arbitrary(len(M))[:-1]
        M[:-1, -1] = M[-1, :-1] = K[:-1] * c - M[:-1, :-1] @ c
        M[-1, -1] = K[-1] - np.dot(M[-1, :-1], c)
        return self.form_of_rate(port).xreplace(equated(self.matrices, {port: M}))

    @cached_property
    def symmetric(self) -> dict[str, np.ndarray]:
        """Each semidefinite matrix with its relations, shape (n, n)."""
        expanded = np.vectorize(
            lambda s: sympy.expand(self.reduced(s)), otypes=[object]
        )
        return {port: expanded(symbols) for port, symbols in self.matrices.items()}

    def not_negative(
        self, expression: Any, of_any_value: Set[Any] = frozenset()
    ) -> bool:
        """Return whether F = F(M = 0) + sum tr(M S) is known not to be negative for M >= 0.

        `of_any_value` are symbols beside states and truths that may have any value.
        """
        expression = sympy.sympify(expression)
        if self.masked(expression).is_nonnegative or self.is_room(expression):
            return True
        expanded = sympy.expand(self.reduced(expression).xreplace(self.free))
        matrices = self.symmetric
        symbols = sorted({s for M in matrices.values() for s in M.flat}, key=str)
        if not expanded.is_polynomial(*symbols):
            return False
        of_M = sympy.Poly(expanded, *symbols, sympy.Dummy())  # there may be no matrices
        if of_M.total_degree() > 1:
            return False
        shares_of_M = [of_M.coeff_monomial(1)]
        for M in matrices.values():
            c = arbitrary(len(M), "d")
            # M_jk stands for M_kj too
            pairs = combinations_with_replacement(range(len(M)), 2)
            shares = (c[j] * c[k] * of_M.coeff_monomial(M[j, k]) for j, k in pairs)
            shares_of_M.append(sympy.expand(sympy.Add(*shares)))
        variables = self.apart | of_any_value
        return all(groups_never_positive(-share, variables) for share in shares_of_M)

    def held(self) -> tuple[set, set, list[str]]:
        """Return states that are bounded, others that exist, and matrices positive at the start.

        V holds e and what is learned, of M that never shrinks with a multiple of I in its place:
        it began above one.  M that keeps a ceiling is bounded, with an estimate whose error over M
        never rises, and what is made of bounded states.
        """
        loop, V, law = self.loop, self.V, self.law
        grown, bounded, exist = list[str](), set[Any](), set[Any]()
        for port, M in self.matrices.items():
            c = arbitrary(len(M))
            rate = c @ self.rates[port] @ c
            flows = not loop.jumps
            same = equated(self.matrices, {port: self.symmetric[port]})
            grown += [port] * (flows and self.not_negative(rate, set(c)))
            at_zero = rate.xreplace(dict.fromkeys(M.flat, sympy.S.Zero))
            excess = (rate - at_zero).xreplace(same)
            has_bound = port == "P" and law.weighted_error is not None
            made = {*M.flat}
            made |= {*self.states["theta_hat"].flat} if law.makes_estimate else set()
            if has_bound or self.keeps_a_ceiling(port):
                bounded |= made
            elif flows and as_factors(excess).is_nonpositive:
                if at_zero == 0:
                    bounded |= made
                elif not at_zero.free_symbols & {*loop.motion}:
                    exist |= made
            bound = sympy.eye(len(M)) if port in grown else sympy.zeros(len(M))
            V = V.xreplace(dict(zip(M.flat, bound, strict=True)))
        in_V = [port for port in LEARNED if port in loop.states]
        if (
            law.error_left
        ):  # its w falls, and each parameter's error is w times the first one
            bounded |= {*self.states[law.error_left].flat, *self.states["alpha"].flat}
        if law.error_left or law.weighted_error is not None:
            in_V.remove("alpha")
        coordinates = ErrorCoordinates(loop)
        e, V = coordinates.e, V.xreplace(coordinates.in_e)
        learned = [s for port in in_V for s in loop.states[port].flat]
        total = squares(V, V.free_symbols - {*e, *learned}, functions_are_free=False)
        if total and contains_all(total, [*e, *learned]):
            bounded |= {*coordinates.x, *coordinates.z, *learned}
            if law.weighted_error is not None:  # tr(eta P^-1 eta^T) bounds eta
                bounded |= {*self.states["alpha"].flat}
        for s, rate in loop.motion.items():
            share = sympy.cancel(rate / s) if s not in bounded else s
            if not share.has(s) and self.not_negative(-share):
                bounded.add(s)  # s' = -f s, f >= 0
        for _ in self.relations:
            for s, value in self.relations.items():
                states = value.free_symbols & loop.motion.keys()
                if states <= bounded and value.is_polynomial(*states):
                    bounded.add(s)
        return bounded, exist, grown

    def keeps_a_ceiling(self, port: str) -> bool:
        """Return whether c^T M' c = 0 where M c = K c, K > 0 diagonal: then M <= K is kept.

        M begins at 0; K is made of parameters.
        """
        for after in self.loop.jumps.values():
            if any(after.get(m, m) != m for m in self.matrices[port].flat):
                return False
        K = np.array([sympy.Dummy(positive=True) for _ in self.matrices[port]])
        rate = self.rate_where(port, K)
        for factor in sympy.Mul.make_args(as_factors(rate)):
            base, power = factor.as_base_exp()
            is_linear = base.has(*K) and sympy.Poly(base, *K).total_degree() == 1
            if not (power.is_positive and is_linear):
                continue
            moving = base.free_symbols - {*K, *self.loop.values}
            moving |= base.atoms(AppliedUndef)
            equations = sympy.Poly(base, *moving).coeffs() if moving else [base]
            solutions = [*sympy.linsolve(equations, *K)]
            if solutions and all(k.is_positive for k in solutions[0]):
                return not self.forks(rate)
        return False

    def is_room(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is 1 - tr P/k_0, which never gets negative."""
        if self.weighted_error is None:
            return False
        trace = sum(self.matrices["P"].diagonal())
        return vanishes(expression - 1 + trace / self.parameters.largest)
