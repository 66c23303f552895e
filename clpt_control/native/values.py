"""What the fuser knows of a value while it reads a block's equations.

Whole numbers and floats that are known stay Python numbers; everything else is
a piece of code.  A view is a run of numbers at known places, such as a port.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Number = int | float


@dataclass(frozen=True)
class Code:
    """A piece of code that gives a number when it runs.

    Attributes
    ----------
    text : str
        An expression; compound ones are in brackets.
    """

    text: str

    @property
    def simple(self) -> bool:
        """Whether it is a name, so that it may be written twice."""
        return self.text.isidentifier()


@dataclass(frozen=True)
class View:
    """A run of numbers at known places.

    Attributes
    ----------
    read : callable
        ``read(index)`` -> number or Code; the index counts in the whole.
    write : callable or None
        ``write(index, value)``.
    offset, size : int
        Where this view starts in the whole, and its length.
    shape : tuple of int
        Of a parameter array; (size,) else.
    table : tuple or None
        (array, offset), for `lookup`.
    """

    read: Callable[[Any], Any]
    write: Callable[[Any, Any], None] | None
    offset: int
    size: int
    shape: tuple[int, ...] = ()
    table: tuple[str, int] | None = None

    def sliced(self, start: int, stop: int) -> "View":
        """View a part."""
        return View(self.read, self.write, self.offset + start, stop - start)


def text(value: Any) -> str:
    """Give the code of a value; negative numbers in brackets."""
    if isinstance(value, Code):
        return value.text
    shown = repr(value)
    return f"({shown})" if shown.startswith("-") else shown


def combined(a: Any, operator: str, b: Any) -> Any:
    """Combine two values, folding what is known.

    Examples
    --------
    >>> combined(2, "*", 3), combined(0.0, "+", Code("v1")).text
    (6, 'v1')
    """
    if not isinstance(a, Code) and not isinstance(b, Code):
        return _FOLD[operator](a, b)
    if operator == "+" and not isinstance(a, Code) and a == 0:
        return b
    if operator in "+-" and not isinstance(b, Code) and b == 0:
        return a
    if operator == "*" and 1 in (a, b) and not (isinstance(a, Code) and isinstance(b, Code)):
        return b if a == 1 else a
    return Code(f"({text(a)} {operator} {text(b)})")


_FOLD: dict[str, Callable[[Any, Any], Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "%": lambda a, b: a % b,
    "//": lambda a, b: a // b,
    "**": lambda a, b: a**b,
}
