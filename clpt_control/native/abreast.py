"""Functions of `math` that do not wait for each other are taken at once, in SIMD.

exp(a), exp(b), exp(c)   ->   exp of four numbers, of which one is nobody's
"""

from typing import NamedTuple

from .program import Item, Load, Loop, Step, Store

SLOW = frozenset(
    {
        "exp",
        "expm1",
        "log",
        "log1p",
        "log2",
        "log10",
        "pow",
        "sin",
        "cos",
        "tan",
        "asin",
        "acos",
        "atan",
        "atan2",
        "sinh",
        "cosh",
        "tanh",
        "asinh",
        "acosh",
        "atanh",
        "hypot",
        "sqrt",
        "div",
    }
)  # several at once cost little more than one


class Abreast(NamedTuple):
    """The same function of several numbers."""

    steps: tuple[Step, ...]


def abreast(items: tuple[Item, ...]) -> tuple[Item | Abreast, ...]:
    """Bring together functions that do not wait for each other.

    What a function waits for is a number of others before it; those with the same
    number are taken at once.  Loads come first and stores last, so items that loop, or
    read what they have stored, stay as they are.
    """
    if any(isinstance(i, Loop) or (isinstance(i, Load) and i.array in "WD") for i in items):
        return items
    depth: dict[int, int] = {}
    rounds: dict[tuple[int, bool, str], list[Item]] = {}
    for item in items:
        if isinstance(item, Load):
            depth[item.value] = 0
        deepest = 0
        if isinstance(item, Step | Store):
            given = item.arguments if isinstance(item, Step) else (item.value,)
            deepest = max((depth[a] for a in given if type(a) is int), default=0)
        name, heavy = "", False
        if isinstance(item, Step):
            heavy = item.name in SLOW
            name = item.name if heavy else ""
            depth[item.value] = deepest + heavy
        rounds.setdefault((deepest, heavy, name), []).append(item)
    stores = [item for item in items if isinstance(item, Store)]
    found: list[Item | Abreast] = []
    for (_, waits, _), group in sorted(rounds.items(), key=lambda pair: pair[0]):
        own = [item for item in group if not isinstance(item, Store)]
        alike = tuple(item for item in own if isinstance(item, Step))
        found += [Abreast(alike)] if waits and len(own) > 1 else own
    return (*found, *stores)
