"""Expressions and bounds as text in a line."""

import re
from collections.abc import Sequence
from typing import Any

import sympy

from ...base.units import at_least, at_most

LARGEST = 10**12  # larger numerators and denominators are rounded in texts


def short(expression: Any, most: int = 160) -> str:
    """Return an expression as text of a line; numbers of many digits are rounded."""

    def rounded(e: Any) -> Any:
        """Return an expression with long numbers rounded, functions of them as one number."""
        if not _is_long(e):
            return e
        if e.is_Pow and _is_long(e.exp):
            return sympy.Pow(rounded(e.base), e.exp.n(17))
        if not e.is_number:
            return e.func(*map(rounded, e.args))
        if e.is_Rational and 1e6 * abs(e - e.round()) < abs(e) < LARGEST:
            return e.round()
        return e.n(6)

    symbols = getattr(expression, "atoms", lambda kind: ())(sympy.Dummy)
    text = str(rounded(expression) if hasattr(expression, "atoms") else expression)
    for symbol in symbols:
        text = text.replace(f"_{symbol.name}", symbol.name)
    return cut(_plain(text), most)


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


def listed(items: Sequence[str]) -> str:
    """Return "a, b and c"."""
    return " and ".join(item for item in (", ".join(items[:-1]), items[-1]) if item)


def bound_text(bound: Any, up: bool = True, keeps_short: bool = False) -> str:
    """Return a bound as text: its numbers are rounded outward, equal factors written once.

    Numbers of few digits may be kept as they are, and exponents are.

    >>> import sympy
    >>> a, b, k = sympy.symbols("a b k", positive=True)
    >>> bound_text(a**2 / 3 + b**2 / 3 + a / (7 * k))
    '0.1429*a/k + 0.3334*(a**2 + b**2)'
    >>> bound_text(sympy.Rational(7701, 2))
    '3851'
    """

    def rounded(e: Any, up: bool) -> Any:
        """Return an expression of positive symbols with its numbers rounded."""
        if e.is_number:
            text = (at_most if up else at_least)(float(e), 4)
            is_exact = (e.is_Integer or keeps_short) and not _is_long(e)
            return e if is_exact else sympy.Float(text, 4)
        if e.is_Pow:
            return sympy.Pow(rounded(e.base, up != e.exp.is_negative), e.exp)
        number, factor = e.as_independent(*e.free_symbols, as_Add=False)
        if number != 1:
            up_rest, up = (up != bool(o.is_negative) for o in (number, factor))
            return rounded(number, up) * rounded(factor, up_rest)
        return e.func(*(rounded(argument, up) for argument in e.args)) if e.args else e

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
        sums = [
            sympy.Mul(c, sympy.Add(*g), evaluate=len(g) == 1) for c, g in groups.items()
        ]
        return sympy.Add(*sums, evaluate=False)

    bound = sympy.sympify(bound)
    return _plain(str(grouped(rounded(bound, up))))
