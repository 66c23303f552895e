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

from ..algebra.decide import groups_never_positive
from ..algebra.exact import as_factors, nonzero_residual, vanishes
from ..algebra.texts import short
from ..proofs.symbolic_loop import equated
from .invariant_loop import InvariantLoop, arbitrary


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

    def is_room(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is 1 - tr P/k_0, which never gets negative."""
        if self.weighted_error is None:
            return False
        trace = sum(self.matrices["P"].diagonal())
        return vanishes(expression - 1 + trace / self.parameters.largest)
