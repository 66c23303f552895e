"""Records as expressions for every N at once: a sum over an open axis is an atom.

    y_i = f(x_i, ..., sum_k g(x_k, ...))

Along an axis whose length is a name, "N", the index is a symbol too: x[k] is the generic element,
one of 1 ... N.  A sum over such an axis is an atom, Sum(m, k, N), linear in its summand:

    sum_k (c a_k + b_k) = c Sum(a[k], k) + Sum(b[k], k)          c without k
    sum_j e_j sum_k P_jk e_k = Sum(P[j][k] e[j] e[k], j, k)       one atom, of two indices

Within a function, exp(Sum(...)) or 1/(1 + Sum(...)), an atom stays as it is.
"""

# Lemma.  An expression that is zero with an unknown N is zero for each N.  A record with an open
# size is traced with axes of unknown length; a function that reads a length, or an element by its
# number, is rejected.  So for each N NumPy computes what the record says: an element is this
# expression with the number x_k for each symbol x[k] and its sum for each atom.  Only sums are
# rewritten, by linearity and the order of finite sums, and summation indices are renamed.  The
# converse does not hold: atoms are not independent for a small N (the fourth elementary symmetric
# polynomial is zero for N = 1, 2, 3, and is not zero here).

from functools import lru_cache
from itertools import permutations
from typing import Any

import numpy as np
import sympy
from sympy import Add, Expr, Mul, S, Symbol, expand

from ...engine.record.graph import Ref
from ...engine.record.scalar_graph import Index
from ...engine.record.symbolic import Symbols
from ...engine.record.unread import Unread
from ...engine.trace.arrays import operand

MOST_INDICES = 4  # of one atom
GENERIC = "kjihg"  # indices along the open axes of an array


class SUM(sympy.Function):
    """An atom Sum(m, k, N, ...): the sum of m over one or more indices."""

    is_real = True

    def _eval_is_nonnegative(self) -> bool | None:
        return True if self.args[0].is_nonnegative else None

    def _sympystr(self, printer: Any) -> str:
        return f"Sum({printer._print(self.args[0])}, {', '.join(_indices(self))})"


def reindexed(expression: Expr, names: dict[str, str]) -> Expr:
    """Return an expression with other names of indices, ``a[k]`` as ``a[j]``."""
    renamed = {}
    for symbol in expression.free_symbols:
        name = str(symbol)
        if name in names and symbol == index_symbol(name):
            renamed[symbol] = index_symbol(names[name])
            continue
        base, *indices = name.split("[")
        if not indices or not all(index.endswith("]") for index in indices):
            continue
        indices = [index.removesuffix("]") for index in indices]
        new = base + "".join(f"[{names.get(index, index)}]" for index in indices)
        if new != name:
            renamed[symbol] = Symbol(new, **symbol.assumptions0)
    return expression.xreplace(renamed)


def index_symbol(name: str) -> Symbol:
    """Return the symbol of an index among the arguments of an atom."""
    return Symbol(name, integer=True)


def depends_on(expression: Expr, index: str) -> bool:
    """Return whether an expression contains the generic element of an index."""
    return any(f"[{index}]" in str(symbol) for symbol in expression.free_symbols)


@lru_cache(maxsize=10_000)  # many loops have equal sums
def summed(body: Expr, index: str, size: str) -> Expr:
    """Return sum_k body(k) as a polynomial in atoms."""
    total = S.Zero
    for term in Add.make_args(expand(body)):
        constant, summand, indices = S.One, S.One, [(index, size)]
        for factor in Mul.make_args(term):
            base, power = factor.as_base_exp()
            if not depends_on(factor, index):
                constant *= factor
            elif base.func == SUM and power.is_Integer and power > 0:
                for _ in range(int(power)):
                    inner, inner_indices = _with_new_indices(base, len(indices))
                    summand *= inner
                    indices += inner_indices
            else:
                summand *= factor
        total += constant * _atom(summand, indices)
    return total


def _with_new_indices(atom: Any, count: int) -> tuple[Expr, list]:
    """Return the summand of an atom with new indices, and the indices with their sizes."""
    names = [f"within{count + k}" for k in range(len(_indices(atom)))]
    renamed = dict(zip(_indices(atom), names, strict=True))
    sizes = [str(size) for size in atom.args[2::2]]
    return reindexed(atom.args[0], renamed), [*zip(names, sizes, strict=True)]


def _indices(atom: Any) -> list[str]:
    """Return the names of the indices that an atom is summed over."""
    return [str(index) for index in atom.args[1::2]]


def _atom(summand: Expr, indices: list[tuple[str, str]]) -> Expr:
    """Return an atom; of all orders of its indices, the alphabetically first."""
    if len(indices) > MOST_INDICES:
        raise Unread(f"a sum over more than {MOST_INDICES} indices at once")
    used = {name for atom in summand.atoms(SUM) for name in _indices(atom)}
    unused = [name for name in (f"k{j}" for j in range(1, 20)) if name not in used]
    names = unused[: len(indices)]
    atoms = []
    for order in permutations(indices):
        renamed = {}
        arguments = []
        for (old, size), new in zip(order, names, strict=True):
            renamed[old] = new
            arguments += [index_symbol(new), Symbol(size)]
        atoms.append(SUM(reindexed(summand, renamed), *arguments))
    return min(atoms, key=str) if len(atoms) > 1 else atoms[0]


def base_and_term(expression: Expr) -> tuple[Expr, Expr]:
    """Return base and term of base + sum_k term(k); other expressions are rejected."""
    base, term = S.Zero, S.Zero
    for summand in Add.make_args(expand(expression)):
        if not summand.has(SUM):
            base += summand
            continue
        atoms = [f for f in Mul.make_args(summand) if f.func == SUM]
        factor = summand / Mul(*atoms)
        if len(atoms) != 1 or len(atoms[0].args) != 3 or factor.has(SUM):
            raise Unread(f"{summand} is not a sum over one index")
        renamed = {_indices(atoms[0])[0]: "k"}
        term += factor * reindexed(atoms[0].args[0], renamed)
    return base, term


class EveryN(Symbols):
    """Elements as expressions, for every N: a sum over an open axis is an atom."""

    prefix = "s"  # of the indices that are summed over
    summed: Any = staticmethod(summed)

    def of(self, value: Any) -> Any:
        """Return the elements of an array, or of a scalar its expression.

        Along an open axis there is one, the generic element.
        """
        shape = getattr(value, "shape", ())
        if not shape:
            return self.at(operand(value), ())
        names = iter(GENERIC)
        generic = [None if isinstance(n, int) else next(names) for n in shape]
        counts = tuple(n if isinstance(n, int) else 1 for n in shape)
        elements = np.empty(counts, dtype=object)
        for position in np.ndindex(counts):
            pairs = zip(position, generic, strict=True)
            index = tuple(k if name is None else name for k, name in pairs)
            elements[position] = self.at(operand(value), index)
        return elements

    def sum_over(self, array: Ref, axis: int, index: Index, size: str) -> Any:
        """Return a sum over an axis of an array."""
        names = (f"{self.prefix}{k}" for k in range(1, 20))
        name = next(name for name in names if name not in index)
        summand = self.at(array, (*index[:axis], name, *index[axis:]))
        return self.summed(summand, name, size)
