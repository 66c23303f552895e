"""What cancels: a term and its negative in one sum leave nothing to compute.

    alpha_M phi(z) - alpha phi(z) - (alpha_M - alpha) phi(z) = 0

The injection (20) takes phi(z) out of z' exactly, so the derivative needs no basis
at z.  Only terms that the record shows to be equal are dropped, within one sum and
one product with a sum; signals that are recorded keep all of theirs.
"""

from collections.abc import Callable
from typing import Any

from .program import Ref

Term = tuple[int, Ref]  # sign, value
MOST_TERMS = 1000  # of a sum in which is looked for what cancels


def simplified(flat: Any, roots: list[Ref]) -> list[Ref]:
    """Return values equal to these, with what cancels left out.

    Parameters
    ----------
    flat : Flat
        Operations; new ones are added.
    roots : list of int or float
        Values.

    Returns
    -------
    list of int or float
        The same ones where nothing is gained.
    """
    found = [_without_pairs(flat, root) for root in roots]
    gained = len(flat.reached(found)) < len(flat.reached(roots))
    return found if gained else list(roots)


def _terms(flat: Any, sign: int, ref: Ref) -> list[Term]:
    """Open sums, differences and signs; a sum of very many terms is one term."""
    found: list[Term] = []
    stack = [(sign, ref)]
    while stack:
        s, one = stack.pop()
        name, *arguments = flat.operations[one] if type(one) is int else ("",)
        if name in ("add", "sub"):
            stack += [(s if name == "add" else -s, arguments[1]), (s, arguments[0])]
        elif name == "neg":
            stack.append((-s, arguments[0]))
        else:
            found.append((s, one))
        if len(found) > MOST_TERMS:
            return [(sign, ref)]
    return found


def _product(flat: Any, ref: Ref) -> tuple:
    """Return what a product is made of; another value is its own product."""
    if type(ref) is int and flat.operations[ref][0] == "mul":
        return tuple(sorted(flat.operations[ref][1:], key=str))
    return (ref,)


def _pieces(flat: Any, sign: int, ref: Ref) -> list[tuple[int, tuple]] | None:
    """Multiply out a product with a sum."""
    factors = _product(flat, ref)
    for k, factor in enumerate(factors):
        inner = _terms(flat, sign, factor)
        if len(factors) == 2 and len(inner) > 1:
            other = factors[1 - k]
            return [(s, tuple(sorted((f, other), key=str))) for s, f in inner]
    return None


def _without_pairs(flat: Any, root: Ref) -> Ref:
    terms = [term for term in _terms(flat, 1, root) if term[1] != 0.0 or type(term[1]) is int]
    left = list(range(len(terms)))

    def opposite(sign: int, product: tuple, among: list[int]) -> int | None:
        if len(product) < 2 or not all(type(factor) is int for factor in product):
            return None  # a large number is added and taken away to round
        for k in among:
            if terms[k][0] == -sign and _product(flat, terms[k][1]) == product:
                return k
        return None

    for k in list(left):
        if k not in left:
            continue
        wholes = [(terms[k][0], _product(flat, terms[k][1]))]
        for pieces in (wholes, _pieces(flat, *terms[k])):
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
    return _sum(flat.add, [terms[k] for k in left])


def _sum(add: Callable[..., Ref], terms: list[Term]) -> Ref:
    total: Ref | None = None
    for sign, ref in terms:
        if total is None:
            total = ref if sign > 0 else add("neg", ref)
        else:
            total = add("add" if sign > 0 else "sub", total, ref)
    return 0.0 if total is None else total
