"""A V of one's own on a diagram's symbols: V, V' and what is known of their signs.

    V' = dV/dt + sum_i (dV/dx_i) f_i(t, x, u)

What is read is what runs; parameters are symbols of the signs that they have, and their own values
where that shows more.
"""

from collections import Counter
from collections.abc import Mapping
from functools import cached_property
from math import pi
from typing import Any

import control
import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ..arguments import check_holds
from ..engine.diagram.symbol_names import TIME, Names, Numbers, element_name
from ..engine.diagram.symbolic_equations import Equations, on_symbols
from ..engine.model.block import Block
from ..engine.record.symbolic import Symbols, rational
from ..errors import DiagramError
from .proving.facts import along, is_continuous, meets_smoothly
from .proving.proof import Step, exact
from .proving.signs import factored, tidied, vanishes
from .proving.symbolic_loop import NO_VALUE, no_value, refuse_names
from .squares import never_positive, squares

MOST_TURNS = 360  # pi/360 is a share of pi
LARGE = ("exp", "expm1", "sinh", "cosh")  # have a value wherever it is a number


def _watched(owner: str, kind: str, arguments: tuple) -> str | None:
    """Return where an operation has no value; one whose value may be too large has one."""
    sentence = no_value(owner, kind, arguments)
    return None if kind in LARGE else sentence


def by_name(eq: Equations) -> dict[str, np.ndarray]:
    """Return the symbols that a function of signals may ask for, by name."""
    identifiers = Counter(name.replace(".", "_") for name in eq.named)
    for name in eq.named:
        if "." in name and identifiers[name.replace(".", "_")] > 1:
            clash = f"{name} and {name.replace('.', '_')} are both s.{name.replace('.', '_')}"
            raise DiagramError(
                f"{eq.name}: {clash} in a function of signals; rename one"
            )
    found = {name.replace(".", "_"): symbols for name, symbols in eq.named.items()}
    found = {name: symbols for name, symbols in found.items() if name.isidentifier()}
    found = {
        name: symbols
        for name, symbols in found.items()
        if not hasattr(np.ndarray, name)
    }
    return found | {"t": np.array(TIME)}


def of_signals(system: Any, V: Any) -> Any:
    """Return an expression in the symbols of `clpt.equations` as a function of signals."""
    if not isinstance(V, sympy.Expr):
        return V
    named = by_name(on_symbols(system))
    places = {
        s: (name, k) for name, own in named.items() for k, s in enumerate(own.flat)
    }
    places = {
        s: at for s, at in places.items() if s.is_Symbol or isinstance(s, AppliedUndef)
    }
    if unknown := V.free_symbols - places.keys():
        raise DiagramError(
            f"{system.name}: has no {unknown.pop()} as clpt.equations has symbols; it has "
            f"{', '.join(map(str, places))}"
        )
    run = sympy.lambdify([*places], V, "numpy")
    return lambda s: run(
        *(np.ravel(getattr(s, name))[k] for name, k in places.values())
    )


class SystemWithV:
    """A diagram with a V of one's own, on symbols, or with parameters as their numbers."""

    def __init__(self, system: Any, V: Any, claim: Any, at: Any, numbers: bool = False):
        self.system, self.undefined = system, list[str]()  # where there may be no value
        names = Numbers if numbers else Names
        self.eq: Equations = on_symbols(system, names, watch=_watched)
        if self.eq.discrete:
            raise DiagramError(
                f"{system.name}: is of discrete time, in which nothing has a rate"
            )
        if not self.eq.motion:
            raise DiagramError(f"{system.name}: has no states, so V' says nothing")
        named = {
            **self.eq.signals,
            **self.eq.states,
            **self.eq.inputs,
            **self.eq.fields,
        }
        refuse_names(system.name, named)
        for s, rate in self.eq.motion.items():
            if rate.xreplace(self.eq.values).has(*NO_VALUE):
                raise DiagramError(
                    f"{system.name}: with the parameters as they are {s}' has no value"
                )
        self.states, self.fixed = [*self.eq.motion], set(self.eq.values)
        parameters = self.eq.parameters.values()
        self.intervals = {p.interval for p in parameters if "interval" in p._fields}
        self.inputs = [s for port in self.eq.inputs.values() for s in port.flat]
        labels = {V, f"{V}[0]"} if isinstance(V, str) else set()
        self.name = next((one for one in system.output_labels if one in labels), "")
        self.claim = None if claim is None else self.expression(claim)
        self.undefined = [*self.eq.undefined]
        self.V = self.expression(V)
        fixed = self.eq.pinned or (numbers and self.eq.fields)
        self.as_they_are = ", with the parameters as they are" if fixed else ""
        self.rate = along(self.V, {TIME: sympy.Integer(1), **self.eq.motion})
        self.rest = None if at is None else self.place(at)

    def expression(self, source: Any) -> sympy.Expr:
        """Return a name, a function of signals or what was found as an expression.

        Where it may have no value is put down.
        """
        if not callable(source):
            found = sympy.sympify(
                self.eq[source] if isinstance(source, str) else source
            )
            if not isinstance(found, sympy.Expr):
                raise DiagramError(f"{self.system.name}: {source} is no single number")
            return found
        named = by_name(self.eq)

        def level(u: Any) -> Any:
            try:
                value = source(u)
            except AttributeError as error:
                value = error if "_asdict" in f"{error}" else None
                if value is None:
                    raise
            if isinstance(value, control.InputOutputSystem | AttributeError):
                raise DiagramError(
                    f"{self.system.name}: V is a function of signals here, "
                    "lambda s: s.e @ s.e/2, which returns a number and no block"
                )
            return value

        ports = {name: symbols.shape for name, symbols in named.items()}
        block = Block(
            "V",
            output=lambda t, x, u, p: {"V": level(u)},
            inputs=ports,
            outputs={"V": 1},
        )
        record = block.array_record("output")

        def watch(place: int, kind: str, arguments: tuple) -> None:
            if sentence := _watched("V", kind, arguments):
                self.undefined.append(f"V {sentence}")

        leaf = lambda at, shape, place: named[at[1]][place]  # noqa: E731
        (found,) = Symbols(record.operations, leaf, watch, block.sizes).outputs(record)
        return found

    def place(self, at: Mapping[str, float]) -> dict[Any, sympy.Expr]:
        """Return each state's value at a rest, a share of pi where a number is that."""
        found = dict.fromkeys(self.states, sympy.Integer(0))
        names = {str(s): s for s in self.states}
        check_holds("at", names, at, f"states are {', '.join(names)}")
        for name, value in at.items():
            turns = rational(float(value) / pi)
            found[names[name]] = (
                rational(float(value)) if turns.q > MOST_TURNS else turns * sympy.pi
            )
        return found

    # --- signs ----------------------------------------------------------------------------

    def definite(self) -> tuple[Step, list[sympy.Expr]]:
        """Return the step that V is positive definite, and the forms that it holds."""
        parts = self.V, *self.eq.motion.values()
        bends = not meets_smoothly(self.V) and not all(map(is_continuous, parts))
        if bends or self.V.free_symbols & self.intervals:
            return exact("V is positive definite", False, "V may jump or bend"), []
        moved = {s: s + v for s, v in (self.rest or {}).items()}
        back = {s: s - v for s, v in (self.rest or {}).items()}
        zero = dict.fromkeys(self.states, 0)
        V = self.V.xreplace(moved)
        found = squares(V, self.fixed)
        if found and self.rest is not None:
            found = found if all(vanishes(f.subs(zero)) for f in found.forms) else None
        if found and found.forms:
            forms = [f.xreplace(back) for f in found.forms]
            names = ", ".join(dict.fromkeys(map(str, map(self.in_signals, forms))))
            return exact(f"V is positive definite in {names}", True), forms
        return exact("V is positive definite", False, "not shown"), []

    def never_positive(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is known never to be positive, for t >= 0."""
        return never_positive(tidied(expression), self.fixed)

    def is_claim_proved(self) -> bool:
        """Return whether V' is as claimed, and the claim as written is never positive."""
        claim = self.claim
        if claim is None or not vanishes(tidied(self.rate - claim)):
            return False
        terms = sympy.Add.make_args(claim)
        is_sum_of_squares = all(bool(term.is_nonpositive) for term in terms)
        return is_sum_of_squares or never_positive(claim, self.fixed)

    def falls(self) -> bool:
        """Return whether V' is known never to be positive, as it stands, reduced, or by states."""
        if self.never_positive(self.rate):
            return True
        self.rate = reduced(self.rate)
        return self.never_positive(self.rate) or self._falls_by_state()

    def _falls_by_state(self) -> bool:
        """Return whether V' falls without the terms of rates that go down V, as friction does.

        They are -dV/dx_i times what is not negative.  The others may cancel, as forces that do no
        work do.
        """

        def goes_down(f: sympy.Expr, slope: sympy.Expr) -> bool:
            return self.never_positive(sympy.cancel(f / slope))

        others = list[sympy.Expr]()
        for s, f in {TIME: sympy.S.One, **self.eq.motion}.items():
            slope = tidied(along(self.V, {s: sympy.S.One}))
            if slope != 0 and not goes_down(f, slope):
                terms = sympy.Add.make_args(f)
                others += [
                    slope * g for g in terms if g == f or not goes_down(g, slope)
                ]
        return self.never_positive(sympy.Add(*others))

    # --- in the user's words -------------------------------------------------------------------

    @cached_property
    def sums(self) -> dict[sympy.Expr, sympy.Expr]:
        """Each signal that is a sum: the sum -> its symbol."""
        names: dict[sympy.Expr, sympy.Expr] = {}
        for port, symbols in self.eq.signals.items():
            for index, value in np.ndenumerate(symbols):
                value = sympy.expand(value)
                if value.is_Add:
                    symbol = sympy.Symbol(
                        element_name(port, symbols.shape, index), real=True
                    )
                    names |= {value: symbol, sympy.expand(-value): -symbol}

        return names

    def in_signals(self, e: sympy.Expr) -> sympy.Expr:
        """Return an expression in the diagram's own signals, each signal in place of its sum."""
        return e.replace(
            lambda one: one.is_Add, lambda one: self.sums.get(sympy.expand(one), one)
        )

    def readable_rate(self) -> sympy.Expr:
        """Return V' factored, or as a sum of squares, whichever is shorter, in signals."""
        rate = tidied(self.rate)
        total = squares(-rate, self.fixed)
        ways = [rate, factored(rate)]
        if total and not total.constant.free_symbols - self.fixed:
            terms = (-sympy.factor_terms(term) for term in total.terms)
            ways.append(sympy.Add(*terms) - total.constant)
        return min(map(self.in_signals, ways), key=sympy.count_ops)

    def depends_on(self) -> list[str]:
        """Return the inputs that V' depends on."""
        rate = tidied(self.rate)
        return [str(f.func) for f in self.inputs if rate.has(f)]


def reduced(rate: sympy.Expr) -> sympy.Expr:
    """Return an expression whose divisors hold angles as one fraction, without common factors."""
    below = sympy.Mul(*(p.base for p in rate.atoms(sympy.Pow) if p.exp.is_negative))
    if not below.has(sympy.sin, sympy.cos):
        return rate
    p, q = map(tidied, sympy.fraction(sympy.together(tidied(rate))))
    return sympy.cancel(p / q)
