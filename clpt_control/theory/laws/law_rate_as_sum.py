"""V' of laws on the paper's loop as sums, in x and e = x - z.

A law whose states keep relations, such as P beside the information, has V' where they hold.
"""

from collections.abc import Callable, Iterable, Set
from dataclasses import replace
from itertools import chain
from typing import Any

import numpy as np
import sympy
from sympy import Add, Expr, Mul, S

from ..algebra.exact import vanishes
from ..algebra.slopes import along
from ..proofs.rate_as_sum import Case, NotASum, Term, Ways, still, terms_of
from .theorem_loop import ErrorCoordinates, truth_in


class LawLoop:
    """A law's loop in x and e = x - z; `read` puts in what is known of its symbols."""

    def __init__(
        self,
        loop: Any,
        read: Callable[[Expr], Expr] = lambda e: e,
        fixed: Set = frozenset(),
    ):
        self.coordinates = ErrorCoordinates(loop)
        in_e = self.coordinates.in_e
        self.read = lambda e: read(sympy.sympify(e)).xreplace(in_e)
        self.fixed, self.truth = {*loop.values} | fixed, truth_in(loop)
        self.pairs = [*zip(self.coordinates.e, self.truth.KD, strict=True)]
        self.V = self.read(loop.signals["V"][0])
        motion = self.coordinates.motion(self.read)
        self.case = Case(motion, self.fixed, [], [])
        self.case.functions |= still(loop.jumps, self.V)

    def falls(self, others: Expr = S.Zero) -> Case:
        """Return V' as losses of e and `others`, which the case has, and a push if more is left."""
        case, push, losses = self.case, S.Zero, list[Term]()
        decay = Add(*(k * e**2 for e, k in self.pairs))
        remainder = along(self.V, case.motion) + others + decay
        is_pushed = not vanishes(remainder)
        for e, k in self.pairs:
            drive = sympy.diff(remainder, e)
            losses += [Term(k / 2, [e]), Term(k / 2, [e - drive / k])] * is_pushed
            push += drive**2 / (2 * k) if is_pushed else 0
        losses = losses or [Term(k, [e]) for e, k in self.pairs]
        V = case.V or terms_of(self.V, self.fixed)
        return replace(case, V=V, losses=[*case.losses, *losses], push=push)


def of_invariants(inv: Any) -> Ways:
    """Return the way to write V' of a law with `Invariants`."""
    return [lambda: WithRelations(inv).case_of()]


class WithRelations(LawLoop):
    """A law's loop where its relations hold."""

    def __init__(self, inv: Any):
        law = self.law = inv
        super().__init__(
            inv.loop, lambda e: law.reduced(e.xreplace(law.tied)), inv.fixed
        )
        weights = {s for M in law.symmetric.values() for s in M.flat}
        bounded, exist, _ = inv.known_states
        for s in (weights | exist) - self.V.free_symbols:
            self.case.functions[s] = "inputs" if s in bounded else "signals"
        self.case.semidefinite = law.symmetric
        for s in law.relations:
            self.case.motion.pop(s)
        truth, states = self.truth, law.states
        read = np.vectorize(self.read, otypes=[object])
        gains = read(np.stack([states["K"] - truth.KD, states["Gamma"] - truth.GammaD]))
        self.errors = [[row] for row in gains.T]  # rows that matrices weigh
        if law.weighted_error is not None:
            self.errors.append([*read(law.weighted_error)])
        if "alpha" in states:
            self.errors.append([*read(truth.theta + states["alpha"])])

    def case_of(self) -> Case:
        """Return V' of the law with its losses."""
        case, law = self.case, self.law
        weights = [s for M in law.symmetric.values() for s in M.flat]
        least = self.V.xreplace(dict.fromkeys(weights, S.Zero))
        case.V = terms_of(least, self.fixed) + self.weighed(
            sympy.expand(self.V - least)
        )
        case.losses = [
            term for factors in law.losses for term in self.product_of(factors)
        ]
        return self.falls(self.read(Add(*(Mul(*factors) for factors in law.losses))))

    def weighed(self, expression: Expr) -> list[Term]:
        """Return a multiple of the sum of b^T M b over rows b of errors as terms."""
        for name, M in self.law.symmetric.items():
            for rows in self.errors if expression.has(*M.flat) else []:
                if len(rows[0]) == len(M):
                    share = sympy.cancel(expression / sum(b @ M @ b for b in rows))
                    if share.free_symbols <= self.fixed:
                        if len(M) == 1:
                            return [Term(share, [*b], factor=M[0, 0]) for b in rows]
                        return [Term(share, [*b], name) for b in rows]
        return []

    def product_of(self, factors: Iterable[Expr]) -> list[Term]:
        """Return a product of factors that are not negative as terms."""
        terms = [Term(S.One, [S.One])]
        for factor in map(self.read, chain.from_iterable(map(Mul.make_args, factors))):
            multiplied = self.weighed(factor) or self.squared(factor)
            terms = [
                term.times(second_term) for term in terms for second_term in multiplied
            ]
        return terms

    def squared(self, factor: Expr) -> list[Term]:
        """Return a factor as a sum of squares, or as one that is assumed not to be negative."""
        try:
            return terms_of(factor, self.fixed)
        except NotASum:
            return [Term(S.One, [S.One], factor=factor)]
