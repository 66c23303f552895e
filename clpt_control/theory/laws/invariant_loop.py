"""A law's closed loop on symbols, its states where the invariants of its row hold.

A row of the table says which `invariants` the states have (state = expression of the others), which
matrices are `semidefinite`, what V' `losses` are and what is a `perturbation`.  `InvariantLoop`
checks each for one N; `invariants` makes the proof of the checks.
"""

import math
from collections import Counter
from collections.abc import Callable, Mapping
from functools import cache
from types import MappingProxyType
from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...engine.record.symbolic import extent
from ...paper.laws.law import Law
from ..algebra.exact import nonzero_residual, vanishes
from ..algebra.facts import is_positive_maximum
from ..algebra.texts import short
from ..proofs.symbolic_loop import TIME, SymbolicLoop, equated, symbolic_loop
from .promises import truth_of
from .theorem_loop import (
    Hedging,
    law_and_V,
    law_loop,
    rate_of_V,
    symbols_of_V,
    theorem_scenario,
    truth_in,
)

SIZES = (1, 2, 3)  # numbers of functions
NOTHING = MappingProxyType[str, Any]({})


class InvariantLoop:
    """A law's closed loop on symbols for one N, with the relations that its row states."""

    def __init__(
        self,
        law: Law,
        N: int,
        speed: Hedging = "no limit",
        blocks: tuple | None = None,
        start: Mapping[str, Any] = NOTHING,
    ):
        """Read the loop of a law's row, or of `blocks`: a law and what makes its V of the truth."""
        self.law, self.N, self.is_row, self.start = law, N, blocks is None, start
        true = truth_of(theorem_scenario(N, "learned-flow"))
        block, V = (
            law_and_V(law, N, speed) if blocks is None else (blocks[0], blocks[1](true))
        )
        self.loop = symbolic_loop(law_loop(law, block, V, speed), jumps=True)
        self.words: dict[Any, sympy.Symbol] = {}
        self.states, self.rates = (
            {port.rpartition(":")[2]: values for port, values in ports.items()}
            for ports in (self.loop.states, self.loop.rates)
        )
        p, truth = self.loop.parameters[block.name], truth_in(self.loop)
        assert law.invariants is not None
        self.stated = equated(self.states, law.invariants(self.states, p, truth))
        self.relations = _solved(self.stated)
        rates = {f"{port}'": rate for port, rate in self.rates.items()}
        every = {**self.loop.inputs, **self.states, **rates}
        self.parameters = p
        if blocks is None:
            sources = (block.parameters, p), (true, truth)
            self.tied = symbols_of_V(self.loop, V, law.V, *sources)
        else:
            self.tied = self.loop.numbers_of(block.name, V.name)
            self.tied |= symbols_of_V(self.loop, V, blocks[1], (true, truth))
        self.losses = [
            tuple(sympy.sympify(factor).xreplace(self.tied) for factor in product)
            for product in law.losses(every, p, truth)
        ]
        self.c = arbitrary(2 * N).reshape(2, N)  # d P^-1, d = theta_hat - theta
        every["d P^-1"] = self.c
        self.error_growth = sympy.sympify(law.error_growth(every, p, truth))
        perturbation = law.perturbation(every, p, truth) if law.perturbation else 0
        pushed = sympy.sympify(perturbation).xreplace(self.tied)
        # what V' has beyond -e^T KD e
        self.beside = pushed - sum(map(math.prod, self.losses))
        self.matrices = {port: self.states[port] for port in law.semidefinite}
        self.V = self.loop.signals["V"][0].xreplace(self.tied)
        self.truths = {*np.ravel(truth.theta), *truth.KD, *truth.GammaD}
        self.weighted_error, self.free = None, dict[Any, Any]()
        if law.weighted_error:
            self.weighted_error = law.weighted_error(self.states, p, truth)
            self.free = _free_symbols_for(self.weighted_error)
        fresh = (value.free_symbols for value in self.free.values())
        self.apart = {*self.loop.motion, *self.truths}.union(*fresh)

    def reduced(self, expression: Any) -> sympy.Expr:
        """Return an expression where the relations hold, words with kinks any numbers."""
        return self.masked(sympy.sympify(expression)).xreplace(self.relations)

    def masked(self, expression: sympy.Expr) -> sympy.Expr:
        """Return an expression with a symbol of its own for each word of the states."""
        words = [f for f in expression.atoms(AppliedUndef) if f.args != (TIME,)]
        for word in sorted(words, key=_outer_first):
            if expression.has(word):
                sign = (
                    {"positive": True} if is_positive_maximum(word) else {"real": True}
                )
                symbol = self.words.setdefault(
                    word, sympy.Dummy(str(word.func), **sign)
                )
                expression = expression.xreplace({word: symbol})
        return expression

    def left_over(self, claim: Callable[[SymbolicLoop], Any]) -> str:
        """Return what V' has beyond a claim and what is beside, or has no value, or nothing."""
        claimed = claim(self.loop) + self.beside
        remainder = self.reduced(rate_of_V(self.loop).xreplace(self.tied) - claimed)
        return nonzero_residual(remainder) or "".join(self.loop.undefined[:1])

    def broken(self, jump: Mapping[Any, Any] | None = None) -> str:
        """Return which relation the states leave, by their rates or at a jump, or nothing."""
        for symbol, value in self.relations.items():
            off = symbol - value
            moved = self.loop.derivative(off) if jump is None else off.xreplace(jump)
            remainder = self.reduced(moved)
            if not vanishes(remainder):
                return f"{symbol} leaves it by {short(sympy.expand(remainder))}"
            if jump is None and self.forks(moved):
                return f"{symbol} may leave it, as s' = |s|^(1/2) may leave 0"
        return ""

    def broken_at_a_jump(self) -> str:
        """Return which relation the states leave where they jump, or nothing."""
        return next(filter(None, map(self.broken, self.loop.jumps_at_once())), "")

    def forks(self, rate: sympy.Expr) -> bool:
        """Return whether motions may part where a rate is zero, as those of s' = |s|^(1/2) at 0."""
        roots = (p.base for p in rate.atoms(sympy.Pow) if not p.exp.is_Integer)
        may_be_zero = sympy.Tuple(*(base for base in roots if not base.is_positive))
        return bool(may_be_zero.free_symbols & {*self.loop.motion})


@cache
def arbitrary(n: int, name: str = "c") -> np.ndarray:
    """Return n symbols that may be any numbers, the same ones each time: what is found of them."""
    return np.array(
        sympy.symbols(f"{name}_1:{n + 1}", real=True, cls=sympy.Dummy), dtype=object
    )


@cache
def _outer_first(word: AppliedUndef) -> tuple[int, str]:
    return -extent(word)[0], str(word)


def _solved(relations: dict[Any, sympy.Expr]) -> dict[Any, sympy.Expr]:
    """Return symbols -> what they are, where M = (M + M^T)/2 is M_jk = M_kj."""
    solved: dict[Any, sympy.Expr] = {}
    for symbol, value in relations.items():
        value = sympy.expand(value.xreplace(solved))
        share = value.coeff(symbol)
        if share.is_Rational and 0 < share < 1:
            value = sympy.expand((value - share * symbol) / (1 - share))
        if value != symbol:
            solved[symbol] = value
    return solved


def _free_symbols_for(values: np.ndarray) -> dict[Any, Any]:
    """Return symbol -> expression such that each value, linear in it, becomes a symbol."""
    replacements = {}
    counts = Counter(s for value in values.flat for s in value.free_symbols)
    for k, value in enumerate(values.flat):
        symbol = min((s for s in value.free_symbols if counts[s] == 1), key=str)
        fresh = sympy.Symbol(f"over_{k + 1}", real=True)
        replacements[symbol] = (fresh - value.subs(symbol, 0)) / sympy.diff(
            value, symbol
        )
    return replacements
