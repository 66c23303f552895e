"""Names that a walk over functions has read, for a comparison by identity at the next call.

A fingerprint walks over all that functions reference.  If the walk met immutable values alone, and
each name still has the same value, another walk would give the same fingerprint.
"""

from dataclasses import dataclass, field
from operator import is_not
from types import CellType, FunctionType
from typing import Any

from .contents import UNBOUND


@dataclass
class Reads:
    """Functions, variables of closures and names of modules, each with its value.

    `complete` is false as soon as a walk has read anything else, such as an attribute or a list.
    """

    functions: list[tuple[FunctionType, tuple]] = field(default_factory=list)
    cells: list[tuple[CellType, Any]] = field(default_factory=list)
    names: list[tuple[dict[str, Any], str, Any]] = field(default_factory=list)
    complete: bool = True

    def function(self, function: FunctionType) -> None:
        """Note a function; one with attributes of its own is not compared."""
        self.functions.append((function, _parts_of(function)))
        self.complete = self.complete and not vars(function)

    def name(self, space: dict[str, Any], name: str, value: Any) -> None:
        """Note the value of a name; one that its module computes at each access is not compared."""
        self.names.append((space, name, value))
        self.complete = self.complete and space.get(name, UNBOUND) is value

    def cell(self, cell: CellType, value: Any) -> None:
        """Note the value of a variable of a closure; one without a value is not compared."""
        self.cells.append((cell, value))
        self.complete = self.complete and value is not UNBOUND

    def unchanged(self) -> bool:
        """Return whether each name has the value that was read, the same object."""
        if not self.complete:
            return False
        for function, pieces_read in self.functions:
            if any(map(is_not, _parts_of(function), pieces_read)) or vars(function):
                return False
        for space, name, value in self.names:
            if space.get(name, UNBOUND) is not value:
                return False
        try:
            return all(cell.cell_contents is value for cell, value in self.cells)
        except ValueError:  # the variable was deleted
            return False


def _parts_of(function: FunctionType) -> tuple:
    return (
        function.__code__,
        function.__defaults__,
        function.__kwdefaults__,
        function.__closure__,
    )
