"""Conditions under which the value of an operation of a record is used.

Both branches of `where(c, a, b)` are evaluated, and one is used: a quotient in a branch that its
condition keeps from a divisor of zero has a value wherever it is used.
"""

from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from typing import Any

from .graph import Operation
from .symbolic import SYMPY

COMPARED = ("gt", "ge", "lt", "le")
LARGER = ("gt", "ge")
MOST_WAYS = 1000  # and parts of them
Literals = frozenset[tuple[Any, bool]]  # comparisons and their truth
Branches = frozenset[tuple[int, bool]]  # conditions of `where` and their truth


def branches_of(
    operations: Sequence[Operation], index: int, outputs: set[int]
) -> set[Branches]:
    """Return the branches of `where` on each way of a value to the outputs; none if too many."""
    complete, visited = set[Branches](), {(index, Branches())}
    waiting = [*visited]
    while waiting and len(visited) < MOST_WAYS:
        used, branches = waiting.pop()
        if used in outputs:
            complete.add(branches)
        for user in range(used + 1, len(operations)):
            arguments = operations[user].arguments
            if used not in arguments:
                continue
            deeper = branches
            if operations[user].kind == "where" and arguments.count(used) == 1:
                position = arguments.index(used)
                deeper = (
                    branches | {(arguments[0], position == 1)} if position else branches
                )
            if (user, deeper) not in visited:
                visited.add((user, deeper))
                waiting.append((user, deeper))
    return set() if waiting else complete


def alternatives(condition: Any, truth: bool) -> list[Literals]:
    """Return sets of comparisons with their truth, one of which holds; without contradictions."""
    name, arguments = condition.func.__name__, condition.args
    if name == "not_":
        return alternatives(arguments[0], not truth)
    if name not in ("and_", "or_"):
        return [Literals({(condition, truth)})]
    groups = [alternatives(argument, truth) for argument in arguments]
    if (name == "and_") != truth:
        return [literals for group in groups for literals in group]
    joined = (Literals().union(*literals) for literals in product(*groups))
    return [of for of in joined if not any((a, not truth) in of for a, truth in of)]


def known(condition: Any, truth: bool) -> Iterator[tuple[Any, Any]]:
    """Yield pairs a >= b that hold where a condition has a truth value."""
    cases = alternatives(condition, truth)
    for comparison, holds in frozenset.intersection(*cases) if cases else ():
        name = comparison.func.__name__
        if name not in COMPARED:
            continue
        a, b = comparison.args if (name in LARGER) == holds else comparison.args[::-1]
        yield a, b
        if a.is_Pow and 2 * a.exp == 1 and b.is_nonnegative:  # |s| >= r
            yield a.base, b**2


def guarded(arguments: tuple, conditions: Iterable[tuple[Any, bool]]) -> tuple:
    """Return arguments of an operation with maximum(a, b) for a, where a >= b is known."""
    pairs = (pair for condition in conditions for pair in known(*condition))
    larger = {a: SYMPY["maximum"](a, b) for a, b in pairs if not a.is_number}
    return tuple(argument.xreplace(larger) for argument in arguments)
