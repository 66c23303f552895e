"""Values that a walk over functions has read, for a comparison by identity at the next call.

A fingerprint walks over all that functions reference.  If the walk met immutable values alone, and
each of them is still the same object, another walk would give the same fingerprint.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from types import CellType, FunctionType
from typing import Any

from .contents import UNBOUND

PARTS = ("__code__", "__defaults__", "__kwdefaults__", "__closure__")  # of a function


def variable(cell: CellType) -> Any:
    """Return the value of a variable of a closure, or UNBOUND."""
    return UNBOUND if cell == CellType() else cell.cell_contents


@dataclass
class Reads:
    """Values of names, variables of closures and parts of functions, each with its reader.

    `complete` is false as soon as a walk has read anything else, such as an attribute or a list.
    """

    values: list[tuple[Callable[[], Any], Any]] = field(default_factory=list)
    complete: bool = True

    def value(self, value: Any, read: Callable[..., Any], *arguments: Any) -> None:
        """Note a value; one that is made anew at each access is not compared."""
        self.values.append((partial(read, *arguments), value))
        self.complete = self.complete and read(*arguments) is value

    def function(self, function: FunctionType) -> None:
        """Note a function; one with attributes of its own is not compared."""
        for name in PARTS:
            self.value(getattr(function, name), getattr, function, name)
        self.value(0, lambda: len(vars(function)))

    def unchanged(self) -> bool:
        """Return whether each value is the same object."""
        return self.complete and all(read() is value for read, value in self.values)
