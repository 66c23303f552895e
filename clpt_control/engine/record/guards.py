"""Conditions under which the value of an operation of a record is used.

Both branches of `where(c, a, b)` are evaluated, and one is used: a quotient in a branch that its
condition keeps from a divisor of zero has a value wherever it is used.
"""

from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from typing import Any

from .graph import Operation, Ref, values_among
from .symbolic import SYMPY

COMPARED = ("gt", "ge", "lt", "le")
LARGER = ("gt", "ge")
MOST_WAYS = 200
Literals = frozenset[tuple[Any, bool]]  # comparisons and their truth
Branches = frozenset[tuple[int, bool]]  # conditions of `where` and their truth


def branches_of(
    operations: Sequence[Operation], outputs: Iterable[Ref]
) -> list[set[Branches]]:
    """Return for each value the branches of `where` on each way to the outputs.

    There are none for a value with too many.
    """
    ways = [set[Branches]() for _ in operations]
    too_many = set[int]()
    for output in values_among(outputs):
        ways[output].add(Branches())
    for user in reversed(range(len(operations))):
        if user in too_many:
            ways[user].clear()
        kind, arguments, *_ = operations[user]
        for position, used in enumerate(arguments):
            if type(used) is int:
                chooses = kind == "where" and position and arguments.count(used) == 1
                branch = {(arguments[0], position == 1)} if chooses else set()
                ways[used] |= {branches | branch for branches in ways[user]}
                if user in too_many or len(ways[used]) > MOST_WAYS:
                    too_many.add(used)
    return ways


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
