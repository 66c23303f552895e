"""A diagram with a V of the user on symbols, and its V' in the user's own signals.

    V' = dV/dt + sum_i (dV/dx_i) f_i(t, x, u)

The equations are those that run; parameters are symbols of the signs that they have, or their
numbers where that shows more.  In discrete time V' stands for V(x+) - V(x).
"""

from collections.abc import Callable, Mapping
from functools import cached_property
from math import pi
from typing import Any

import numpy as np
import sympy

from ...base.arguments import check_holds
from ...base.errors import DiagramError
from ...engine.diagram.symbol_names import TIME, Names, Numbers, element_name
from ...engine.diagram.symbolic_equations import on_symbols
from ...engine.record.symbolic import rational
from ..algebra.decide import in_one_piece
from ..algebra.decided import decided
from ..algebra.exact import factored, normal_form
from ..algebra.facts import is_continuous
from ..algebra.numeric_values import NO_VALUE
from ..algebra.slopes import along, meets_smoothly
from ..algebra.sums_of_squares import squares
from ..algebra.texts import short
from .judge import Candidate
from .point_search import PointSearch
from .same_as_running import compare
from .signal_functions import expression_of, undefined_in
from .steps import Step, checked
from .symbolic_loop import refuse_levels, refuse_names

MOST_TURNS = 360  # pi/360 is a share of pi


class SystemEquations(Candidate):
    """Equations of a diagram, and V as an expression of them."""

    def __init__(
        self,
        system: Any,
        V: Any,
        claim: Any,
        rest: Mapping[str, float] | None,
        points: int = 1,
        seed: int = 0,
        numbers: bool = False,
    ):
        self.system, self.points, self.seed = system, points, seed
        names = Numbers if numbers else Names
        self.eq = on_symbols(system, names, watch=undefined_in, with_samples=True)
        self._refuse_what_has_no_rates()
        self.motion = {s: decided(rate) for s, rate in self.eq.motion.items()}
        self.fixed = {*self.eq.values}
        self.states = [*self.motion]
        self.inputs = [s for port in self.eq.inputs.values() for s in port.flat]
        labels = {V, f"{V}[0]"} if isinstance(V, str) else set()
        outputs = system.output_labels
        self.output = next((name for name in outputs if name in labels), "")
        self.claim = None if claim is None else expression_of(self.eq, claim)[0]
        V_of_states, undefined = expression_of(self.eq, V)
        self.V, self.undefined = decided(V_of_states), [*self.eq.undefined, *undefined]
        self.are_numbers = bool(self.eq.pinned or (numbers and self.eq.fields))
        self.rate = self._rate_of_V()
        self.readable: dict[Any, sympy.Expr] = {}  # V' -> V' in the user's signals
        self.rest = None if rest is None else self._rest_state(rest)

    def _refuse_what_has_no_rates(self) -> None:
        name, eq = self.system.name, self.eq
        refuse_levels(eq)
        if not eq.motion:
            raise DiagramError(f"{name}: has no states, so V' is not defined")
        refuse_names(name, {**eq.signals, **eq.states, **eq.inputs, **eq.fields})
        for s, rate in eq.motion.items():
            if rate.xreplace(eq.values).has(*NO_VALUE):
                raise DiagramError(
                    f"{name}: with the parameters as they are {s}' has no value"
                )

    def _rate_of_V(self) -> sympy.Expr:
        """Return V', or in discrete time by how much V changes from one time to the next."""
        if self.eq.discrete:
            if self.V.has(TIME, *self.inputs):
                raise DiagramError(
                    f"{self.system.name}: is of discrete time; give a V of its states alone"
                )
            return self.V.xreplace(dict(self.motion)) - self.V
        rate = along(self.V, {TIME: sympy.Integer(1), **self.motion})
        is_smooth = meets_smoothly(self.V) and all(
            map(is_continuous, self.motion.values())
        )
        return (is_smooth and in_one_piece(rate)) or rate

    def _rest_state(self, values: Mapping[str, float]) -> dict[Any, sympy.Expr]:
        """Return each state's value at a rest, a share of pi where a number is that."""
        rest_state = dict.fromkeys(self.states, sympy.Integer(0))
        names = {str(s): s for s in self.states}
        check_holds("at", names, values, f"states are {', '.join(names)}")
        for name, value in values.items():
            turns = rational(float(value) / pi)
            is_turn = turns.q <= MOST_TURNS
            rest_state[names[name]] = (
                turns * sympy.pi if is_turn else rational(float(value))
            )
        return rest_state

    def depends_on(self, rate: sympy.Expr) -> list[str]:
        """Return the inputs that V' depends on."""
        rate = normal_form(rate)
        return [str(f.func) for f in self.inputs if rate.has(f)]

    @cached_property
    def search(self) -> PointSearch:
        """Random points about the rest."""
        rest_state = self.rest or {}
        return PointSearch(
            self.system, self.eq, self.V, self.output, rest_state, self.seed
        )

    def same_as_running(self) -> Step:
        """Return the step that the running blocks have the same V and rates."""
        return self.compared(lambda points: points)

    def compared(self, restrict: Callable[[tuple], tuple]) -> Step:
        """Compare with the running blocks at random points, `within` a region if need be."""
        claim = "the running blocks give the same V'"

        def agrees() -> tuple[bool, str]:
            return compare(
                self.search, restrict(self.search.wide(self.points)), self.points
            )

        return checked(claim, agrees, "sampled", False, "running")

    # --- in the user's signals ------------------------------------------------------------------

    @cached_property
    def sums(self) -> dict[sympy.Expr, sympy.Expr]:
        """Each signal that is a sum: the sum -> its symbol."""
        names: dict[sympy.Expr, sympy.Expr] = {}
        for port, symbols in self.eq.signals.items():
            for index, value in np.ndenumerate(symbols):
                total = sympy.expand(value)
                if total.is_Add:
                    name = element_name(port, symbols.shape, index)
                    symbol = sympy.Symbol(name, real=True)
                    names |= {total: symbol, sympy.expand(-total): -symbol}
        return names

    def in_signals(self, e: sympy.Expr) -> sympy.Expr:
        """Return an expression in the diagram's own signals, each signal in place of its sum."""
        return e.replace(
            lambda term: term.is_Add,
            lambda term: self.sums.get(sympy.expand(term), term),
        )

    def text(self, expression: sympy.Expr) -> str:
        """Return an expression in the diagram's own signals, in a line."""
        return short(self.in_signals(expression))

    @property
    def shown_rate(self) -> str:
        """V' in a line."""
        return short(self.readable_rate())

    def readable_rate(self) -> sympy.Expr:
        """Return V' factored, or as a sum of squares, whichever is shorter, in signals."""
        if self.rate not in self.readable:
            self.readable[self.rate] = self._readable(decided(normal_form(self.rate)))
        return self.readable[self.rate]

    def _readable(self, rate: sympy.Expr) -> sympy.Expr:
        total = squares(-rate, self.fixed)
        forms = [rate, factored(rate)]
        if total and not total.constant.free_symbols - self.fixed:
            terms = (-sympy.factor_terms(term) for term in total.terms)
            forms.append(sympy.Add(*terms) - total.constant)
        return min(map(self.in_signals, forms), key=sympy.count_ops)
