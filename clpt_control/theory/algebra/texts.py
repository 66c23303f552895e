"""Expressions and bounds as text in a line."""

import re
from math import floor, log10
from typing import Any

import sympy
from sympy import Add, Pow

from ...base.units import at_least, at_most

LARGEST = 10**12  # larger numerators and denominators are rounded in texts
DIGITS = 17  # that tell doubles apart
FEW = 6  # digits of a text that would be cut


def rounded(e: Any, digits: int = DIGITS) -> Any:
    """Return an expression with long numbers rounded, functions of them as one number.

    A number that is not whole keeps digits that say so.
    """
    if not _is_long(e):
        return e
    if e.is_Pow and _is_long(e.exp):
        return Pow(rounded(e.base, digits), e.exp.n(digits))
    if not e.is_number:
        return e.func(*(rounded(a, digits) for a in e.args))
    whole = e.round() if abs(e) < LARGEST else e
    if whole not in (0, e):
        digits -= floor(log10(abs(e - whole) / abs(e)))
    return e.n(digits)


def double(number: Any) -> str:
    """Return a double as text with the digits that tell it from others: 0.1, 2."""
    return f"{float(number)!r}".removesuffix(".0")


def short(expression: Any, most: int | None = 160) -> str:
    """Return an expression as text of a line, with all digits of numbers if they fit.

    >>> import sympy
    >>> x, gains = sympy.symbols("x"), [sympy.Rational(f"{1 + k / 7}") for k in range(12)]
    >>> short(gains[2] * x)
    '1.2857142857142856*x'
    >>> short(sympy.Poly(gains, x).as_expr(), 80)
    'x**11 + 1.142857*x**10 + 1.285714*x**9 + 1.428571*x**8 + ... (6 digits)'
    """
    text = _text(expression, DIGITS)
    if most is None or len(text) <= most:
        return text
    fewer = _text(expression, FEW)
    note = f" ({FEW} digits)" * (fewer != text)
    return cut(fewer, most - len(note)) + note


def _text(expression: Any, digits: int) -> str:
    """Return an expression as text, with so many digits of long numbers."""
    if not isinstance(expression, sympy.Basic):
        return _plain(f"{expression}")
    text = str(rounded(expression, digits))
    for symbol in expression.atoms(sympy.Dummy):
        text = text.replace(f"_{symbol.name}", symbol.name)
    return _plain(text)


def _is_long(e: Any) -> bool:
    """Return whether an expression has a number of many digits."""
    return any(max(abs(n.p), n.q) > LARGEST for n in e.atoms(sympy.Rational))


def _plain(text: str) -> str:
    """Return a text with numbers such as 0.3750, 2.0, 3851. and 1.000e+50 without their ends."""
    text = re.sub(r"(\.\d*?[1-9])0+(?=\b|e)|(?<=\d)\.0*(?=e|(?!\w))", r"\1", text)
    return re.sub(r"(?<=\d)e\+", "e", text)


def cut(text: str, most: int) -> str:
    """Return a text, or its first words and "..."."""
    return text if len(text) <= most else text[: most - 4].rpartition(" ")[0] + " ..."


def bound_text(bound: Any) -> str:
    """Return an upper bound as text.

    >>> bound_text(sympy.Rational(7701, 2))
    '3851'
    """
    return _plain(str(outward(bound)))


def outward(bound: Any, up: bool = True, keeps_short: bool = False) -> sympy.Expr:
    """Return a bound with its numbers rounded outward, and equal factors written once.

    Numbers of few digits may be kept as they are, and exponents are.

    >>> import sympy
    >>> a, b, k = sympy.symbols("a b k", positive=True)
    >>> outward(a**2 / 3 + b**2 / 3 + a / (7 * k))
    0.1429*a/k + 0.3334*(a**2 + b**2)
    """

    def in_digits(e: Any, up: bool) -> Any:
        """Return an expression of positive symbols with its numbers rounded."""
        if e.is_number:
            text = (at_most if up else at_least)(float(e), 4)
            is_exact = (e.is_Integer or keeps_short) and not _is_long(e)
            return e if is_exact else sympy.Float(text, 4)
        if e.is_Pow:
            return Pow(in_digits(e.base, up != e.exp.is_negative), e.exp)
        number, factor = e.as_independent(*e.free_symbols, as_Add=False)
        if number != 1:
            up_rest, up = (up != bool(o.is_negative) for o in (number, factor))
            return in_digits(number, up) * in_digits(factor, up_rest)
        return (
            e.func(*(in_digits(argument, up) for argument in e.args)) if e.args else e
        )

    def grouped(e: Any) -> Any:
        """Return a sum with terms of one factor in brackets."""
        if not e.args:
            return e
        if not e.is_Add:
            return e.func(*map(grouped, e.args))
        groups: dict[Any, list] = {}
        for term in e.args:
            coefficient, factor = term.as_coeff_Mul()
            groups.setdefault(coefficient, []).append(factor)
        sums = [sympy.Mul(c, Add(*g), evaluate=len(g) == 1) for c, g in groups.items()]
        return Add(*sums, evaluate=False)

    return grouped(in_digits(sympy.sympify(bound), up))
