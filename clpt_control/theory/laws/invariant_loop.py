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

from ...engine.record.symbolic import extent, rational
from ...paper.laws.law import LEARNED, Law
from ...simulation.initial_states import state_columns, state_of
from ...simulation.loop_blocks import paper_blocks
from ..algebra.decide import never_positive
from ..algebra.exact import nonzero_residual, vanishes
from ..algebra.facts import is_positive_maximum
from ..algebra.numeric_values import NO_VALUE
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
REPELS = 1e-9  # of the largest eigenvalue: a positive real part that is no rounding
START = (0.4, -0.7)  # of vehicle and learner


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

    def off_at_the_start(self) -> str:
        """Name the states whose relation does not hold where a run begins, whatever alpha is."""
        alpha, theta = np.random.default_rng(0).normal(size=(2, 2, self.N)).tolist()
        drawn = {
            "flow.parameters": theta,
            "vehicle.position": START,
            "learning.position": START,
        }
        drawn |= {} if self.law.alpha_is_constant else {"learning.parameters": alpha}
        scenario = theorem_scenario(self.N, self.law.name).with_values(drawn)
        blocks = paper_blocks(scenario)
        start, columns = state_of(scenario, blocks), state_columns(blocks)
        states = {
            port: start[columns[port]].reshape(s.shape)
            for port, s in self.states.items()
        }
        assert self.law.invariants is not None
        p = self.law.parameters_of(scenario.known_to_law)
        values = self.law.invariants(states, p, truth_of(scenario))
        off = [
            s
            for s, value in values.items()
            if not np.allclose(np.ravel(value), np.ravel(states[s]))
        ]
        return ", ".join(f"{name} at the start" for name in off)

    def off_at_zero(self) -> str:
        """Return a state that is not what the truth makes it where all of a law's own are 0, or "".

        No start of alpha, K and Gamma, nor of the vehicle, is known to be true.
        """
        own = self.states.keys() - {"x", "z", *LEARNED}
        start: dict[Any, sympy.Expr] = {}
        for name in own | self.start.keys():
            value = np.asarray(self.start.get(name, 0.0), float)
            values = np.broadcast_to(value, self.states[name].shape)
            start |= equated(self.states, {name: np.vectorize(rational)(values)})
        for symbol, value in self.stated.items():
            residual = (symbol - value).xreplace(start)
            if residual.has(*NO_VALUE):  # P = R^-1 from R = 0: another start is meant
                continue
            if not vanishes(residual):
                begins = start.get(symbol, "anything")
                relation = f"{symbol} = {short(sympy.nsimplify(value), 40)}"
                return f"{relation} does not hold at the start, where it is {begins}"
        return ""

    def repels(self) -> str:
        """Return which relation pushes away states that leave it by rounding, or "".

        With r = s - value beside each relation, r' = J r where r is small.  J is judged where it
        is constant; elsewhere by the sign of its trace, the rate at which volumes of r grow.
        """
        if not self.relations:
            return ""
        offsets = {s: sympy.Dummy(f"r_{s}", real=True) for s in self.relations}
        moved = {s: self.relations[s] + r for s, r in offsets.items()}
        rates = [
            self.masked(self.loop.derivative(s - value)).xreplace(moved)
            for s, value in self.relations.items()
        ]
        zero = dict.fromkeys(offsets.values(), sympy.S.Zero)
        J = sympy.Matrix(rates).jacobian([*offsets.values()]).xreplace(zero)
        J = J.xreplace(self.loop.values).applyfunc(sympy.expand)
        if J.is_zero_matrix:
            return ""
        if not J.free_symbols and not J.atoms(AppliedUndef):
            eigenvalues = np.linalg.eigvals(np.array(J, dtype=float))
            grows = eigenvalues.real.max() > REPELS * np.abs(eigenvalues).max()
        else:
            trace = sympy.expand(J.trace())
            grows = trace != 0 and never_positive(-trace, set())
        if not grows:
            return ""
        names = ", ".join(f"{s} = {short(v, 40)}" for s, v in self.relations.items())
        return f"{names}: a distance from it that rounding leaves grows"

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
