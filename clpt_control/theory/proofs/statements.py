"""Sentences that hold their expressions.

    said("{} goes to zero, as rates of {} do", x, v)        said("`e^T KD e` goes to zero")

A statement has three printers: its text is one line, in which long expressions and lists are cut;
`whole` is the same without cuts, for the comments of Coq; `in_latex` sets it for a paper.
Mathematics that is written by hand stands between backticks, which no text shows.
"""

from collections.abc import Iterable, Sequence
from string import Formatter
from typing import Any

from sympy import Basic, Symbol

from ..algebra.texts import short

MOST_NAMES = 3  # in a line


class Formula(str):
    """Mathematics that is written by hand: e^T KD e."""


class Statement(str):
    """A sentence of words and mathematics.

    Attributes
    ----------
    parts : tuple
        Words, formulas, expressions, and lists of expressions as tuples.
    """

    parts: tuple[Any, ...]

    def __new__(cls, *parts: Any) -> "Statement":
        """Return the statement of parts."""
        statement = super().__new__(cls, "".join(map(_in_line, parts)))
        statement.parts = parts
        return statement

    @property
    def whole(self) -> str:
        """The sentence with all its expressions and lists, as text."""
        return "".join(map(_in_whole, self.parts))


def said(template: str, *values: Any, **named: Any) -> Statement:
    """Return a sentence with values in its braces: expressions, statements and words.

    >>> import sympy
    >>> falls = said("V' = {} <= 0", -sympy.Symbol("x") ** 2)
    >>> said("{}, so {of} to zero", falls, of=go(sympy.symbols("a b c d")))
    "V' = -x**2 <= 0, so a, b, c, ... go to zero"
    >>> _.whole
    "V' = -x**2 <= 0, so a, b, c, d go to zero"
    """
    if isinstance(template, Statement):
        return template
    parts, unnamed, kinds = list[Any](), iter(values), [str, Formula]
    for words, name, *_ in Formatter().parse(template):
        for k, text in enumerate(words.split("`")):
            kinds = kinds[::-1] if k else kinds
            parts += [kinds[0](text)] * bool(text)
        if name is not None:
            value = named[name] if name else next(unnamed)
            parts += getattr(value, "parts", (value,))
    return Statement(*parts)


def joined(separator: str, statements: Iterable[Any]) -> Statement:
    """Return statements or expressions as one, with a separator between them."""
    values = [*statements]
    return said(separator.join(["{}"] * len(values)), *values)


def listed(items: Sequence[Any]) -> Statement:
    """Return "a, b and c"."""
    return joined(" and ", filter(None, (joined(", ", items[:-1]), items[-1])))


def whole(text: str) -> str:
    """Return a statement without cuts; words as they are."""
    return getattr(text, "whole", text)


def go(names: Iterable[Any]) -> Statement:
    """Return "x goes" or "x, y go", in a line at most three."""
    symbols = _symbols(names)
    return Statement(symbols, " go" if symbols[1:] else " goes")


def are(names: Iterable[Any]) -> Statement:
    """Return "x is" or "x, y are", in a line at most three."""
    symbols = _symbols(names)
    return Statement(symbols, " are" if symbols[1:] else " is")


def _symbols(names: Iterable[Any]) -> tuple:
    """Return expressions once each, names as symbols."""
    known = {f"{n}": getattr(n, "parts", (n,)) for n in names}
    return tuple(s if isinstance(s, Basic) else Symbol(s) for (s,) in known.values())


def _in_line(part: Any) -> str:
    if isinstance(part, tuple):
        return ", ".join(
            [*map(short, part[:MOST_NAMES]), *["..."] * (len(part) > MOST_NAMES)]
        )
    return part if isinstance(part, str) else short(part)


def _in_whole(part: Any) -> str:
    if isinstance(part, tuple):
        return ", ".join(map(_in_whole, part))
    return part if isinstance(part, str) else short(part, most=None)


CLPE_GOES = Statement("CLPE", " goes")
