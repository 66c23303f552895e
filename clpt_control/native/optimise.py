"""What is left out of a program, computed early, or calculated at once.

`simplified`: a term and its negative in one sum leave nothing to compute.

    alpha_M phi(z) - alpha phi(z) - (alpha_M - alpha) phi(z) = 0

The injection (20) takes phi(z) out of z' exactly, so the derivative needs no basis at z.
Only terms that the record shows to be equal are dropped, within one sum and one product
with a sum; signals that are recorded keep all of theirs.

`prepared`: what depends on parameters alone is computed once a piece of time.

`abreast`: functions that do not wait for each other are calculated at once, in SIMD.

    exp(a), exp(b), exp(c)   ->   exp of four numbers, of which the last is not used
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from .program import CONDITIONS, Item, Load, Loop, Ref, Step, Store

Signed = tuple[int, Ref]  # sign, value
MOST_TERMS = 1000  # in a longer sum nothing is searched that cancels


def simplified(ops: Any, roots: list[Ref]) -> list[Ref]:
    """Return values equal to these, with what cancels left out; operations are added."""
    found = [_without_pairs(ops, root) for root in roots]
    gained = len(ops.reached(found)) < len(ops.reached(roots))
    return found if gained else list(roots)


def _terms(ops: Any, sign: int, ref: Ref) -> list[Signed]:
    """Open sums, differences and signs; a sum of very many terms is one term."""
    found: list[Signed] = []
    stack = [(sign, ref)]
    while stack:
        s, one = stack.pop()
        name, *arguments = ops.operations[one] if type(one) is int else ("",)
        if name in ("add", "sub"):
            stack += [(s if name == "add" else -s, arguments[1]), (s, arguments[0])]
        elif name == "neg":
            stack.append((-s, arguments[0]))
        else:
            found.append((s, one))
        if len(found) > MOST_TERMS:
            return [(sign, ref)]
    return found


def _product(ops: Any, ref: Ref) -> tuple:
    """Return what a product is ops of; another value is its own product."""
    if type(ref) is int and ops.operations[ref][0] == "mul":
        return tuple(sorted(ops.operations[ref][1:], key=str))
    return (ref,)


def _pieces(ops: Any, sign: int, ref: Ref) -> list[tuple[int, tuple]] | None:
    """Multiply out a product with a sum."""
    factors = _product(ops, ref)
    for k, factor in enumerate(factors):
        inner = _terms(ops, sign, factor)
        if len(factors) == 2 and len(inner) > 1:
            other = factors[1 - k]
            return [(s, tuple(sorted((f, other), key=str))) for s, f in inner]
    return None


def _without_pairs(ops: Any, root: Ref) -> Ref:
    terms = [term for term in _terms(ops, 1, root) if term[1] != 0.0 or type(term[1]) is int]
    left = list(range(len(terms)))

    def opposite(sign: int, product: tuple, among: list[int]) -> int | None:
        if len(product) < 2 or not all(type(factor) is int for factor in product):
            return None  # a large number is added and taken away to round
        for k in among:
            if terms[k][0] == -sign and _product(ops, terms[k][1]) == product:
                return k
        return None

    for k in list(left):
        if k not in left:
            continue
        wholes = [(terms[k][0], _product(ops, terms[k][1]))]
        for pieces in (wholes, _pieces(ops, *terms[k])):
            others = [j for j in left if j != k]
            gone: list[int] = []
            for sign, product in pieces or ():
                at = opposite(sign, product, others)
                if at is None:
                    break
                gone.append(at)
                others.remove(at)
            else:
                if pieces:
                    left = others
                    break
    if len(left) == len(terms):
        return root
    return _sum(ops.add, [terms[k] for k in left])


def _sum(add: Callable[..., Ref], terms: list[Signed]) -> Ref:
    total: Ref | None = None
    for sign, ref in terms:
        if total is None:
            total = ref if sign > 0 else add("neg", ref)
        else:
            total = add("add" if sign > 0 else "sub", total, ref)
    return 0.0 if total is None else total


def prepared(items: list[Item], first: int) -> tuple[tuple[Item, ...], list[Item], int]:
    """Move what depends on parameters alone to places in P, from `first`.

    Return what remains, what is computed before, and how many places are taken.
    """
    steady: set[int] = set()
    left: list[Item] = []
    early: list[Item] = []
    places: dict[int, int] = {}
    for item in items:
        if isinstance(item, Load) and item.array in "PK" and not item.steps:
            steady.add(item.value)
            early.append(item)
            left.append(item)
        elif (
            isinstance(item, Step)
            and item.name not in CONDITIONS
            and all(
                type(a) is float or a in steady or (type(a) is tuple and a[0] in "PT")
                for a in item.arguments
            )
        ):
            steady.add(item.value)
            early.append(item)
            places[item.value] = first + len(places)
            left.append(Load(item.value, "P", places[item.value]))
        else:
            left.append(item)
    early += [Store("P", place, (), value) for value, place in places.items()]
    return tuple(left), early, len(places)


LONG = frozenset(  # functions that take long; several at once cost little more than one
    {"exp", "expm1", "log", "log1p", "log2", "log10", "pow", "sin", "cos", "tan", "hypot"}
    | {"asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh"}
)
SLOW = LONG | {"sqrt", "div"}


class Abreast(NamedTuple):
    """The same function of several numbers."""

    steps: tuple[Step, ...]


def abreast(items: tuple[Item, ...]) -> tuple[Item | Abreast, ...]:
    """Bring together functions that do not wait for each other.

    A function waits for as many others as are before it; those that wait for the same
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
