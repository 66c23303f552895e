"""The proof of a law whose states have invariants, such as P beside the information.

A law's row says which `invariants` its states have (state = expression of the others), which
matrices are `semidefinite`, what V' `losses` are beyond e^T KD e, products of factors that are not
negative, and which `driving_estimate` it has.  `Invariants` shows each for one N:

    s' = (expression)'                    where the relations hold: what starts there stays
    c^T M' c >= 0  where  M c = 0         M stays semidefinite (Nagumo)
    F = F(M = 0) + sum tr(M S) >= 0       if F(M = 0) >= 0 and each S >= 0
    V' = -e^T KD e - losses + e^T eta phi    where the relations hold, V and losses not negative

A law without the last term is proved; with it the mean square of e is bounded by that of eta phi,
eta being the error of the estimate that drives CLPE.  All is exact for N = 1, 2, 3, and the running
blocks give the same V'.  Where its states jump, at times that may be any, x and inputs being those
right before:

    the relations before give the relations after,  M >= 0 gives M+ >= 0,  V+ <= V

so that between and across jumps V falls.  Of a law that makes an estimate theta_hat = theta + d
with its covariance M it is shown as well that

    (d M^-1 d^T)' = error_growth <= 0                     so d never grows in this norm

A law of which no parameter's error ever rises, eta = w eta(0), w' = -f w, f >= 0, takes no part of
e into alpha', so that V' is perturbed by e^T eta phi; its readout is theta where its condition
holds.  `states_of_laws` adds what is known of the P of least squares.
"""

import math
from collections import Counter
from collections.abc import Callable, Mapping, Set
from functools import cache, cached_property
from itertools import chain, combinations_with_replacement, filterfalse
from types import MappingProxyType
from typing import Any

import numpy as np
import sympy
from sympy import Dummy, Expr, Symbol, expand, sympify
from sympy.core.function import AppliedUndef

from ...base.arguments import check_known
from ...engine.model.block import Block
from ...engine.record.symbolic import extent
from ...paper.laws.law import Law, Truth
from ..algebra.decide import groups_never_positive, never_positive
from ..algebra.exact import as_factors, nonzero_residual, vanishes
from ..algebra.facts import MAXIMUM, WHERE, is_positive_maximum
from ..algebra.texts import short
from ..proofs.answers import Definite, Fall
from ..proofs.conclusions import Condition
from ..proofs.rate_as_sum import Ways
from ..proofs.relations import Relations, forks
from ..proofs.statements import CLPE_GOES, said
from ..proofs.steps import Step, exact, exact_step
from ..proofs.symbolic_loop import TIME, SymbolicLoop, equated, symbolic_loop
from .law_candidate import LoopCandidate
from .paper_loop import mean_square
from .promises import truth_of
from .states_of_laws import (
    arbitrary,
    bounded_states,
    covariance_claims,
    off_at_the_start,
    off_at_zero,
)
from .theorem_loop import (
    Hedging,
    decay,
    law_and_V,
    law_loop,
    rate_of_V,
    symbols_of_V,
    theorem_scenario,
    truth_in,
)

Claims = dict[str, tuple[str, Callable[[Any], bool | str]]]
NOTHING = MappingProxyType[str, Any]({})
IN_THE_MEAN = said("`|e| <= |eta phi|` over the least of `KD`")


class Invariants(LoopCandidate):
    """A law whose states keep relations: of its row, or of a user's, V' is what is stated."""

    def __init__(
        self,
        law: Law,
        N: int,
        points: int = 1,
        seed: int = 0,
        blocks: tuple | None = None,
        start: Mapping[str, Any] = NOTHING,
        speed: Hedging = "no limit",
    ):
        """Read the loop of a law's row, or of `blocks`: a law and what makes its V of the truth."""
        self.law, self.is_row, self.start = law, blocks is None, start
        true = truth_of(theorem_scenario(N, "learned-flow"))
        block, V = (
            law_and_V(law, N, speed) if blocks is None else (blocks[0], blocks[1](true))
        )
        loop = symbolic_loop(law_loop(law, block, V, speed), jumps=True)
        super().__init__(loop, N, points, seed)
        self.motion, self.undefined = loop.motion, loop.undefined
        self.words: dict[Any, Symbol] = {}
        self.states, self.rates = (
            {port.rpartition(":")[2]: values for port, values in ports.items()}
            for ports in (loop.states, loop.rates)
        )
        self.V, self.rate = loop.signals["V"][0], rate_of_V(loop)
        self._read_row(block, V, true, None if blocks is None else blocks[1])

    def _read_row(
        self, block: Block, V: Block, true: Truth, own_V: Callable | None
    ) -> None:
        """Read what the law's row states of its states, and what the numbers of V are."""
        law, loop = self.law, self.loop
        p, truth = loop.parameters[block.name], truth_in(loop)
        assert law.invariants is not None
        self.parameters, self.c = p, arbitrary(2 * self.N).reshape(2, self.N)
        for argument in ("semidefinite", "start", "invariants"):
            stated = getattr(self if argument == "start" else law, argument)
            if callable(stated):
                stated = stated(self.states, p, truth)
            check_known(f"{block.name}: {argument}", stated, self.states)
        self.stated = equated(self.states, stated)
        self.relations = Relations(loop, self.motion, self.masked)
        self.reduced = self.relations.of
        for s, value in self.stated.items():
            self.relations.add(s - value, [s])
        self.matrices = {port: self.states[port] for port in law.semidefinite}
        if own_V is None:
            tied = symbols_of_V(loop, V, law.V, (block.parameters, p), (true, truth))
        else:
            tied = loop.numbers_of(block.name, V.name)
            tied |= symbols_of_V(loop, V, own_V, (true, truth))
        self.V, self.rate = self.V.xreplace(tied), self.rate.xreplace(tied)
        # of signals, rates, and d P^-1, d = theta_hat - theta
        rates = {f"{port}'": rate for port, rate in self.rates.items()}
        signals = {**loop.inputs, **self.states, **rates, "d P^-1": self.c}
        self.losses = [
            tuple(sympify(factor).xreplace(tied) for factor in product)
            for product in law.losses(signals, p, truth)
        ]
        self.error_growth = sympify(law.error_growth(signals, p, truth))
        pushed = sympify(drive(law, signals, truth)).xreplace(tied)
        # what V' has beyond -e^T KD e
        self.residual = pushed - sum(map(math.prod, self.losses))
        self.weighted_error, self.free = None, dict[Any, Any]()
        if law.weighted_error:
            self.weighted_error = law.weighted_error(self.states, p, truth)
            self.free = _free_symbols_for(self.weighted_error)
        fresh = (value.free_symbols for value in self.free.values())
        truths = {*np.ravel(truth.theta), *truth.KD, *truth.GammaD}
        self.apart = {*loop.motion, *truths}.union(*fresh)

    def masked(self, expression: Expr) -> Expr:
        """Return an expression with a symbol of its own for each word of the states."""
        words = [f for f in expression.atoms(AppliedUndef) if f.args != (TIME,)]
        for word in sorted(words, key=_outer_first):
            if expression.has(word):
                sign = (
                    {"positive": True} if is_positive_maximum(word) else {"real": True}
                )
                symbol = self.words.setdefault(word, Dummy(str(word.func), **sign))
                expression = expression.xreplace({word: symbol})
        return expression

    def left_over(self, claim: Callable[[SymbolicLoop], Expr]) -> str:
        """Return what V' has beyond a claim and what is beside, or has no value, or nothing."""
        claimed = claim(self.loop) + self.residual
        remainder = self.reduced(self.rate - claimed)
        return nonzero_residual(remainder) or "".join(self.loop.undefined[:1])

    def forks(self, rate: Expr) -> bool:
        """Return whether motions may part where a rate is zero."""
        return forks(self.masked(rate), self.fixed)

    # --- semidefinite matrices --------------------------------------------------------------

    def semidefinite_after_a_jump(self) -> bool:
        """Return whether c^T M c is not negative after a jump, for every M >= 0 and c."""
        for after in self.loop.jumps_at_once():
            for M in self.matrices.values():
                c = arbitrary(len(M))
                new = np.array(
                    [[after.get(m, m) for m in row] for row in M], dtype=object
                )
                form = self.masked(expand(c @ new @ c))
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
        excess = sympify(rate - self.error_growth).xreplace(substitutions)
        return nonzero_residual(self.reduced(excess))

    def stays_semidefinite(self, port: str) -> bool:
        """Return whether c^T M' c is not negative where M c = 0, for every c."""
        M = self.matrices[port]
        form = as_factors(self.rate_where(port, np.zeros(len(M), dtype=object)))
        return bool(form.is_nonnegative) and not self.forks(self.form_of_rate(port))

    def form_of_rate(self, port: str) -> Expr:
        """Return c^T M' c, whatever c is, with 1 for its last element.

        As c^T M' c has the sign of c^T M' c/c_n^2, c_n is 1; where it is 0, M and c are rotated a
        little.
        """
        c = arbitrary(len(self.matrices[port]))
        form = sympify(c @ self.rates[port] @ c)
        return form.xreplace({c[-1]: sympy.S.One})

    def rate_where(self, port: str, K: np.ndarray) -> Expr:
        """Return c^T M' c where M c = K c, K diagonal."""
        M = self.symmetric[port].copy()
        c = arbitrary(len(M))[:-1]
        M[:-1, -1] = M[-1, :-1] = K[:-1] * c - M[:-1, :-1] @ c
        M[-1, -1] = K[-1] - np.dot(M[-1, :-1], c)
        return self.form_of_rate(port).xreplace(equated(self.matrices, {port: M}))

    @cached_property
    def symmetric(self) -> dict[str, np.ndarray]:
        """Each semidefinite matrix with its relations, shape (n, n)."""
        expanded = np.vectorize(lambda s: expand(self.reduced(s)), otypes=[object])
        return {port: expanded(symbols) for port, symbols in self.matrices.items()}

    def not_negative(
        self, expression: Any, of_any_value: Set[Expr] = frozenset()
    ) -> bool:
        """Return whether F = F(M = 0) + sum tr(M S) is known not to be negative for M >= 0.

        `of_any_value` are symbols beside states and truths that may have any value.
        """
        expression = sympify(expression)
        if self.masked(expression).is_nonnegative or self.is_room(expression):
            return True
        expanded = expand(self.reduced(expression).xreplace(self.free))
        matrices = self.symmetric
        symbols = sorted({s for M in matrices.values() for s in M.flat}, key=str)
        if not expanded.is_polynomial(*symbols):
            return False
        of_M = sympy.Poly(expanded, *symbols, Dummy())  # there may be no matrices
        if of_M.total_degree() > 1:
            return False
        shares_of_M = [of_M.coeff_monomial(1)]
        for M in matrices.values():
            c = arbitrary(len(M), "d")
            # M_jk stands for M_kj too
            pairs = combinations_with_replacement(range(len(M)), 2)
            shares = (c[j] * c[k] * of_M.coeff_monomial(M[j, k]) for j, k in pairs)
            shares_of_M.append(expand(sympy.Add(*shares)))
        variables = self.apart | of_any_value
        return all(groups_never_positive(-share, variables) for share in shares_of_M)

    def is_room(self, expression: Expr) -> bool:
        """Return whether an expression is 1 - tr P/k_0, which never gets negative."""
        if self.weighted_error is None:
            return False
        trace = sum(self.matrices["P"].diagonal())
        return vanishes(expression - 1 + trace / self.parameters.largest)

    # --- the questions ----------------------------------------------------------------------

    @cached_property
    def known_states(self) -> tuple[set, set, list[str]]:
        """States that are bounded, others that exist, and matrices positive at the start."""
        return bounded_states(self)

    def definite(self) -> Definite:
        """Return the states that V bounds, where V and what V' loses are not negative."""
        bounded, exist, _ = self.known_states
        names = ", ".join(self.law.semidefinite)
        premise = f"with `{names} >= 0`, " * bool(names)
        terms = {self.V, *chain.from_iterable(self.losses)}
        holds = all(map(self.not_negative, terms))
        claim = said(f"{premise}V and what V' loses are not negative")
        step = exact(claim, holds, "", "definite")
        return Definite(step, [*bounded], exist=exist)

    def falls(self, definite: Definite) -> Fall:
        """Return what is shown of the relations, and of V' where they hold."""
        steps = [
            exact_step([self], claim, check, shows)
            for claim, (shows, check) in claims_of(self).items()
        ]
        claim = said(f"V' = `{self.law.V_rate}`")
        fall = Fall(steps, claim, residual=self.residual)
        if self.law.driving_estimate:
            fall.steps.append(mean_square())
            fall.bound = IN_THE_MEAN
        else:
            e = self.loop.states["x"] - self.loop.states["z"]
            fall.losses, fall.bound, fall.of = [*e], said("`e^T KD e`"), CLPE_GOES
        grown = self.known_states[2]
        positive = said(" and ".join(f"`{M} > 0`" for M in grown))
        condition = "the relations hold" * (not self.is_row)
        fall.conditions = [
            Condition("start", text) for text in (condition, positive) if text
        ]
        return fall

    def exact_steps(self) -> list[Step]:
        """Return the steps on V, V' and jumps."""
        definite, jumps = self.definite(), [self.jumps().step] * bool(self.eq.jumps)
        falls = self.falls(definite).steps
        return [self.has_values(), definite.step, *falls, *jumps]

    def ways(self, definite: Definite, fall: Fall) -> Ways:
        """Return the ways to write V' as a sum, for a file of Coq."""
        return []

    def never_positive(self, expression: Expr) -> bool:
        """Return whether an expression is known never to be positive where M >= 0."""
        return vanishes(expression) or self.not_negative(-expression)


def drive(law: Law, s: Mapping[str, np.ndarray], truth: Truth) -> Any:
    """Return e^T eta phi, eta being the error of the estimate that drives CLPE."""
    errors = {
        "": lambda: np.zeros((2, len(s["phi_x"]))),
        "alpha": lambda: truth.theta + s["alpha"],
        "theta_hat": lambda: truth.theta - s["theta_hat"],
    }
    return (s["x"] - s["z"]) @ (errors[law.driving_estimate]() @ s["phi_x"])


@cache
def _outer_first(word: AppliedUndef) -> tuple[int, str]:
    return -extent(word)[0], str(word)


def _free_symbols_for(values: np.ndarray) -> dict[Any, Any]:
    """Return symbol -> expression such that each value, linear in it, becomes a symbol."""
    replacements = {}
    counts = Counter(s for value in values.flat for s in value.free_symbols)
    for k, value in enumerate(values.flat):
        symbol = min((s for s in value.free_symbols if counts[s] == 1), key=str)
        fresh = Symbol(f"over_{k + 1}", real=True)
        replacements[symbol] = (fresh - value.subs(symbol, 0)) / sympy.diff(
            value, symbol
        )
    return replacements


def claims_of(case: Invariants) -> Claims:
    """Return what is to be shown of a law, one's own or of the table: claim -> shows, check."""
    law, names = case.law, case.law.semidefinite
    sentence, sizes = "what the law's states keep is kept", f"N = {case.N}"
    start = off_at_the_start
    if not case.is_row:
        sentence += " where it begins so"
        sizes += " and the parameters as they are"
        start = off_at_zero
    claims = {sentence: ("", lambda case: case.relations.broken() or start(case))}
    if not case.is_row:
        claims["what is kept does not repel"] = "", _repels
    if case.loop.jumps:
        claim = f"`{', '.join(names)} >= 0` is not left where they jump"
        claims[claim] = "", Invariants.semidefinite_after_a_jump
    if names:
        claims[
            f"`c^T M' c >= 0` where `M c = 0`, so `M >= 0` is not left: `{', '.join(names)}`"
        ] = ("", lambda case: ", ".join(filterfalse(case.stays_semidefinite, names)))
    shows = "mean" if law.driving_estimate else "falls loses"
    claims[f"V' as claimed, {sizes}: `{law.V_rate}`"] = (
        shows,
        lambda case: case.left_over(decay),
    )
    if law.weighted_error:
        claims |= covariance_claims(law)
    if law.makes_estimate:
        claims[
            "the error of the estimate never grows: `(d P^-1 d^T)'` is as claimed"
        ] = ("", Invariants.estimate_grows)
    if law.readout:
        claims[
            f"{law.readout} is `theta` where its condition holds, and `-alpha` elsewhere"
        ] = "", _reads
    return claims


def _repels(case: Invariants) -> str:
    """Return a sentence where a distance is known to grow, or moves by itself and may grow."""
    moving = {*case.motion, *case.words.values()}

    def may_shrink(growth: Expr) -> bool:
        is_driven = bool(growth.free_symbols & moving) or growth.has(AppliedUndef)
        is_kept = is_driven and not never_positive(-growth, case.fixed)
        return is_kept or never_positive(growth, case.fixed)

    return case.relations.repels(may_shrink, alone=True)


def _reads(case: Invariants) -> bool:
    """Return whether a readout where(1 - w >= m, a, -alpha) is theta in its first branch."""
    (w,) = case.states[case.law.error_left]
    read, truth = (
        case.loop.signals[case.law.readout],
        case.loop.parameters["true_flow"].theta,
    )
    for element, alpha, theta in zip(
        read.flat, case.states["alpha"].flat, truth.flat, strict=True
    ):
        if not isinstance(element, WHERE) or str(element.args[0].func) != "ge":
            return False
        condition, then, before = element.args
        gone_share, margin = condition.args
        substitutions = {
            MAXIMUM(*pair): 1 - w for pair in ((margin, 1 - w), (1 - w, margin))
        }
        is_truth = vanishes(case.reduced(then.subs(substitutions)) - theta)
        if not (
            is_truth
            and gone_share == 1 - w
            and margin.is_positive
            and vanishes(before + alpha)
        ):
            return False
    return True
