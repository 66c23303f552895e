"""Records as expressions for every N at once: a sum over an open axis is an atom.

    y_i = f(x_i, ..., sum_k g(x_k, ...))

An element of an array is an expression of symbols.  Along an axis whose length is a name, "N", its
place is a symbol too: the generic element k, of which nothing is known but that it is one of
1 ... N.  A sum over such an axis is an atom, Sum(m, k, N), linear in its summand:

    sum_k (c a_k + b_k) = c Sum(a[k], k) + Sum(b[k], k)          c without k
    sum_j sum_k a_j b_k = Sum(a[k], k) Sum(b[k], k)
    sum_j e_j sum_k P_jk e_k = Sum(P[j][k] e[j] e[k], j, k)       one atom, of two indices

**Lemma.**  What is read with an unknown N holds for each N.  A record with an open size was made by
running the function once with axes of which no length was known; where it asks for a length, or for
an element by its number, it is not read.  So for each N NumPy does what the record says, and an
element of what it computes is this expression, each symbol x[k] the number x_k and each atom its
sum: only sums are rewritten, by linearity and the order of finite sums, and names of indices that
are summed over.  An expression that is zero for all values of its symbols and atoms is so for those
that they have, whatever N is.  The converse does not hold: atoms are not independent for a small N
(the fourth elementary symmetric polynomial is zero for N = 1, 2, 3, and is not zero here).

Within a function, exp(Sum(...)) or 1/(1 + Sum(...)), an atom stays as it is.
"""

from functools import lru_cache
from itertools import permutations
from typing import Any

import numpy as np
import sympy

from ...engine.record.graph import Ref, Shape
from ...engine.record.scalar_graph import Index
from ...engine.record.symbolic import Symbols
from ...engine.trace.arrays import Unread, operand

MOST_INDICES = 4  # that one atom is summed over
FREE = "kjihg"  # names of generic places of an array's open axes


class SUM(sympy.Function):
    """An atom Sum(m, k, N, ...): the sum of m over one or more indices."""

    is_real = True

    def _eval_is_nonnegative(self) -> bool | None:
        return True if self.args[0].is_nonnegative else None

    def _sympystr(self, printer: Any) -> str:
        return f"Sum({printer._print(self.args[0])}, {', '.join(_bound(self))})"


def reindexed(expression: sympy.Expr, names: dict[str, str]) -> sympy.Expr:
    """Return an expression with other names of indices, ``a[k]`` as ``a[j]``."""
    changed = {}
    for symbol in expression.free_symbols:
        parts = str(symbol).split("[")
        own = [
            f"{names.get(one[:-1], one[:-1])}]"
            for one in parts[1:]
            if one.endswith("]")
        ]
        if own and len(own) == len(parts) - 1 and own != parts[1:]:
            changed[symbol] = sympy.Symbol(
                "[".join([parts[0], *own]), **symbol.assumptions0
            )
        elif str(symbol) in names and symbol == index_symbol(str(symbol)):
            changed[symbol] = index_symbol(names[str(symbol)])
    return expression.xreplace(changed)


def index_symbol(name: str) -> sympy.Symbol:
    """Return what stands for an index among an atom's arguments."""
    return sympy.Symbol(name, integer=True)


def depends_on(expression: sympy.Expr, index: str) -> bool:
    """Return whether an expression holds the generic element of an index."""
    return any(f"[{index}]" in str(symbol) for symbol in expression.free_symbols)


@lru_cache(maxsize=10_000)  # many loops hold the same sums
def summed(body: sympy.Expr, index: str, size: str) -> sympy.Expr:
    """Return sum_k body(k) as a polynomial in atoms."""
    total = sympy.Integer(0)
    for term in sympy.Add.make_args(sympy.expand(body)):
        outside, inside, indices = sympy.Integer(1), sympy.Integer(1), [(index, size)]
        for factor in sympy.Mul.make_args(term):
            base, power = factor.as_base_exp()
            if not depends_on(factor, index):
                outside *= factor
            elif base.func == SUM and power.is_Integer and power > 0:
                for _ in range(int(power)):
                    inner = [
                        (f"within{len(indices) + k}", s)
                        for k, s in enumerate(_sizes(base))
                    ]
                    fresh = {
                        old: new
                        for old, (new, _) in zip(_bound(base), inner, strict=True)
                    }
                    inside *= reindexed(base.args[0], fresh)
                    indices += inner
            else:
                inside *= factor
        total += outside * _atom(inside, indices)
    return total


def _bound(atom: Any) -> list[str]:
    """Return the names of the indices that an atom is summed over."""
    return [str(one) for one in atom.args[1::2]]


def _sizes(atom: Any) -> list[str]:
    return [str(one) for one in atom.args[2::2]]


def _atom(inside: sympy.Expr, indices: list[tuple[str, str]]) -> sympy.Expr:
    """Return one atom, its indices named in the order in which it comes first."""
    if len(indices) > MOST_INDICES:
        raise Unread(f"a sum over more than {MOST_INDICES} indices at once")
    taken = {name for atom in inside.atoms(SUM) for name in _bound(atom)}
    names = [n for n in (f"k{j}" for j in range(1, 20)) if n not in taken][
        : len(indices)
    ]
    found = []
    for order in permutations(indices):
        moved = {old: new for (old, _), new in zip(order, names, strict=True)}
        pairs = [
            (index_symbol(new), sympy.Symbol(size))
            for (_, size), new in zip(order, names, strict=False)
        ]
        found.append(
            SUM(reindexed(inside, moved), *(one for pair in pairs for one in pair))
        )
    return min(found, key=str) if len(found) > 1 else found[0]


def base_and_term(
    expression: sympy.Expr, index: str = "k"
) -> tuple[sympy.Expr, sympy.Expr]:
    """Return base and term of base + sum_k term(k); what is no such sum is refused."""
    base, term = sympy.Integer(0), sympy.Integer(0)
    for part in sympy.Add.make_args(sympy.expand(expression)):
        atoms = [f for f in sympy.Mul.make_args(part) if f.func == SUM]
        if not part.has(SUM):
            base += part
            continue
        factor = part / sympy.Mul(*atoms)
        if len(atoms) != 1 or len(atoms[0].args) != 3 or factor.has(SUM):
            raise Unread(f"{part} is no sum over one index")
        term += factor * reindexed(atoms[0].args[0], {_bound(atoms[0])[0]: index})
    return base, term


class EveryN(Symbols):
    """Elements as expressions, for every N: a sum over an open axis is an atom."""

    def of(self, value: Any) -> Any:
        """Return the elements of a value: an array over its axes of known length, or one.

        Along an open axis there is one, the generic element.
        """
        shape: Shape = getattr(value, "shape", ())
        if not shape:
            return self.at(operand(value), ())
        counted = tuple(n if isinstance(n, int) else 1 for n in shape)
        elements = np.empty(counted, dtype=object)
        names = iter(FREE)
        free = [None if isinstance(n, int) else next(names) for n in shape]
        for place in np.ndindex(counted):
            index = tuple(
                k if name is None else name for k, name in zip(place, free, strict=True)
            )
            elements[place] = self.at(operand(value), index)
        return elements

    def sum_over(self, array: Ref, axis: int, index: Index, size: str) -> Any:
        """Return the atom of a sum."""
        name = next(n for n in (f"s{k}" for k in range(20)) if n not in index)
        return summed(self.at(array, (*index[:axis], name, *index[axis:])), name, size)
