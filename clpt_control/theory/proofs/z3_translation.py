"""Translate expressions of SymPy into real terms of Z3, with facts about them.

Functions with pieces (clip, where, abs, ...) become if-then-else terms.  Any other function,
quotient or root is a new real number with facts.  Facts of y = sqrt(a), y >= 0 and y^2 = a, are
implied by a >= 0 only.  Points without a value are excluded only from the branch that has the
root: where(x > 0, sqrt(x), 1) is 1 at x = -1.
"""

from typing import Any

import sympy
from sympy.core.evalf import PrecisionExhausted

from ...engine.diagram.symbol_names import TIME
from .facts import COMPARISONS, LOGIC, is_input
from .z3_facts import FACTS, Values

HIGHEST = 12  # higher powers are not translated
DIGITS, ROUNDED = 30, sympy.Rational(1, 10**25)  # of constants such as pi


class NotTranslatedError(Exception):
    """An expression has a function, a power or a constant without a translation."""


class Translation:
    """Real terms of Z3 for SymPy expressions, and facts about them."""

    def __init__(self, z3: Any):
        self.z3, self.context, self.count = z3, z3.Context(), 0
        self.facts: list[Any] = []
        self.terms: dict[sympy.Expr, Any] = {}
        # values of each function by its name
        self.calls: dict[str, Values] = {}

    def new(self) -> Any:
        """Return a new real number."""
        self.count += 1
        return self.z3.Real(f"y{self.count}", self.context)

    def number(self, value: sympy.Rational | int) -> Any:
        """Return a rational number."""
        return self.z3.RealVal(str(value), self.context)

    def real(self, e: sympy.Expr) -> Any:
        """Return the term of an expression."""
        if e not in self.terms:
            self.terms[e] = self._real(e)
        return self.terms[e]

    def _real(self, e: sympy.Expr) -> Any:
        if e.is_Rational:
            return self.number(e)
        if e.is_Symbol:
            return self._symbol(e)
        if is_input(e) or isinstance(e, sympy.Derivative):
            return self.new()
        if e.is_Add or e.is_Mul:
            total, *others = map(self.real, e.args)
            for other in others:
                total = total + other if e.is_Add else total * other
            return total
        if e.is_Pow and e.exp.is_Rational:
            return self._power(e.base, e.exp)
        return self._constant(e) if e.is_number else self._function(e)

    def _symbol(self, s: sympy.Symbol) -> Any:
        if not s.is_extended_real:
            raise NotTranslatedError
        y = self.new()
        signs = (
            (s.is_positive, y > 0),
            (s.is_nonnegative or s == TIME, y >= 0),
            (s.is_negative, y < 0),
            (s.is_nonpositive, y <= 0),
        )
        self.facts += [fact for is_known, fact in signs if is_known]
        return y

    def _power(self, base: sympy.Expr, exponent: sympy.Rational) -> Any:
        """Return b^n, or y with y^q = b^n or y^q b^n = 1 for an exponent of n/q or -n/q."""
        b, n, q = self.real(base), abs(exponent.p), exponent.q
        if max(n, q) > HIGHEST:
            raise NotTranslatedError
        power = _multiplied(b, n)
        if q == 1 and exponent > 0:
            return power
        y = self.new()
        root = _multiplied(y, q)
        equal = root == power if exponent > 0 else root * power == 1
        sign = [y >= 0] if q > 1 else []
        has_value = _has_power(b, exponent)
        self.facts.append(self.z3.Implies(has_value, self.z3.And(equal, *sign)))
        return y

    def _constant(self, e: sympy.Expr) -> Any:
        try:
            decimal = e.evalf(DIGITS, strict=True)
        except PrecisionExhausted:
            raise NotTranslatedError from None
        if not decimal.is_Float:
            raise NotTranslatedError
        value, y = sympy.Rational(decimal), self.new()
        error = (1 + abs(value)) * ROUNDED
        self.facts += [y > self.number(value - error), y < self.number(value + error)]
        return y

    def _function(self, e: sympy.Expr) -> Any:
        name, args, if_ = e.func.__name__, e.args, self.z3.If
        if name in COMPARISONS or name in LOGIC or name == "inside":
            return if_(self.condition(e), self.number(1), self.number(0))
        if name == "where":
            return if_(self.condition(args[0]), *map(self.real, args[1:]))
        values = [self.real(a) for a in args]
        if name == "Abs":
            return if_(values[0] >= 0, values[0], -values[0])
        if name == "sign":
            negative = if_(values[0] < 0, self.number(-1), self.number(0))
            return if_(values[0] > 0, self.number(1), negative)
        if name in ("maximum", "minimum", "clip"):
            u, v = values[:2]
            larger = if_(u >= v, u, v)
            if name == "clip":
                return if_(larger <= values[2], larger, values[2])
            return larger if name == "maximum" else if_(u >= v, v, u)
        if name not in FACTS:
            raise NotTranslatedError
        y = self.new()
        self.facts += FACTS[name](self.z3, y, *values)
        self.calls.setdefault(name, {})[args[0]] = (values[0], y)
        return y

    def condition(self, e: sympy.Expr) -> Any:
        """Return the condition that an expression is not zero: that a truth value is true."""
        name, z3 = e.func.__name__, self.z3
        if name in COMPARISONS:
            return COMPARISONS[name](*map(self.real, e.args))
        if name == "inside":
            u, low, high = map(self.real, e.args)
            return z3.And(low < u, u < high)
        if name in LOGIC:
            logical = {"and_": z3.And, "or_": z3.Or, "not_": z3.Not}[name]
            return logical(*map(self.condition, e.args))
        return self.real(e) != 0

    def exclude(self, e: sympy.Expr, path: tuple) -> None:
        """Exclude points at which a term or factor in the branch `path` has no value."""
        if e.func.__name__ == "where":
            condition = self.condition(e.args[0])
            self.exclude(e.args[1], (*path, self.z3.Not(condition)))
            self.exclude(e.args[2], (*path, condition))
        elif e.is_Add or e.is_Mul:
            for a in e.args:
                self.exclude(a, path)
        elif e.is_Pow and not (e.exp.is_Integer and e.exp.is_positive):
            self.facts.append(self.z3.Or(*path, _has_power(self.real(e.base), e.exp)))


def _multiplied(y: Any, n: int) -> Any:
    product = y
    for _ in range(n - 1):
        product = product * y
    return product


def _has_power(b: Any, exponent: sympy.Rational) -> Any:
    """Return the condition that b to a rational power has a value."""
    if exponent.is_Integer:
        return b != 0
    return b >= 0 if exponent > 0 else b > 0
