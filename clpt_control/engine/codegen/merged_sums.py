"""Merged sums of a diagram: terms of different blocks cancel where their signals are added.

    alpha_M phi(z) of Eq. (4), - alpha phi(z) of Eq. (6), - (alpha_M - alpha) phi(z) of Eq. (20)

These three cancel, so phi(z) is not computed.  The function of a single block is computed as its
author wrote it: terms cancel only if they come from different blocks, and a coefficient without
cancelled terms does not change.  Sums over one axis are merged where a costly factor is then
computed once.
"""

from .diagram_record import WIRE, Ref
from .fused_expressions import LONG, Components, Value

HEAVY = 10  # cost of a function, beside an addition
MOST = 64  # terms of one sum; a longer one is left as it is
# of the arguments of a sum: whether they are added
SIGNS = {"add": (True, True), "sub": (True, False), "neg": (False,)}
# a term: whether it is added, the block it comes from, its value
Signed = tuple[bool, int, Value]


class MergedSums:
    """Merges the sums in the rates of a diagram."""

    def __init__(self, components: Components):
        self.components = components

    def element(self, ref: Ref, index: tuple) -> Value:
        """Return an element of a value, with its sums merged where that costs less work."""
        plain = self.components.at(ref, index)
        if type(ref) is not int or any(type(i) is tuple for i in index):
            return plain
        unsummed: list[Signed] = []
        sums: dict[int, list[Signed]] = {}
        self.terms(True, ref, index, unsummed, sums)
        terms = []
        for count, summands in sums.items():
            symbol = count, 0
            owners = {owner for _, owner, _ in summands}
            if len(owners) > 1 and len(summands) < MOST:
                body = self.body(summands)
                if body is not None:
                    total = self.components.total(body, symbol)
                    terms.append((True, -1, total))
            else:
                for plus, owner, value in summands:
                    total = self.components.total(value, symbol)
                    terms.append((plus, owner, total))
        merged = self.added(unsummed + terms)  # sums are known last
        return merged if self.work(merged) < self.work(plain) else plain

    def terms(
        self,
        plus: bool,
        ref: Ref,
        index: tuple,
        unsummed: list,
        sums: dict[int, list[Signed]],
    ) -> None:
        """Sort the terms of a value: sums over a long axis, by its length, and the rest."""
        if type(ref) is float:
            if ref:
                unsummed.append((plus, -1, ref))
            return
        components = self.components
        trimmed = components.trimmed(ref, index)
        source = components.source(ref, trimmed)
        if source is not None:
            self.terms(plus, *source, unsummed, sums)
            return
        kind, arguments, _, at = components.operations[ref]
        owner = components.record.owners.get(ref, WIRE)
        if kind in SIGNS:
            for sign, argument in zip(SIGNS[kind], arguments, strict=True):
                self.terms(plus == sign, argument, trimmed, unsummed, sums)
        elif kind == "sum" and at[2]:
            axis, count, _ = at
            symbol = count, 0
            summed_index = (*trimmed[:axis], (symbol, 0, 1), *trimmed[axis:])
            body = components.at(arguments[0], summed_index)
            sums.setdefault(count, []).append((plus, owner, body))
        else:
            unsummed.append((plus, owner, components.at(ref, trimmed)))

    def body(self, sums: list[Signed]) -> Value | None:
        """Return the merged summand, in which each costly factor has one coefficient; None is 0."""
        groups: dict[Value, list[Signed]] = {}
        for plus, owner, value in sums:
            factors: list[Value] = []
            plus = self.split(plus, value, factors)
            heavy = max(factors, key=self.work)
            factors.remove(heavy)
            coefficient = self.components.product(factors) if factors else 1.0
            groups.setdefault(heavy, []).append((plus, owner, coefficient))
        terms = []
        for heavy, coefficients in groups.items():
            remaining = self.cancelled(coefficients)
            if remaining == [(True, coefficients[0][1], 1.0)]:
                terms.append((True, -1, heavy))
            elif remaining:
                coefficient = self.added(remaining)
                product = self.components.add("mul", coefficient, heavy)
                terms.append((True, -1, product))
        return self.added(terms) if terms else None

    def split(self, plus: bool, value: Value, factors: list[Value]) -> bool:
        """Collect the factors of a product; a costly product stays one factor.  Return its sign."""
        name, values = self.components.operation(value)
        if name == "neg" or (name == "mul" and min(map(self.work, values)) < 8 * HEAVY):
            for factor in values:
                plus = self.split(plus, factor, factors)
            return plus != (name == "neg")
        factors.append(value)
        return plus

    def cancelled(self, coefficients: list[Signed]) -> list[Signed]:
        """Return the coefficients that remain when terms of different blocks cancel."""
        term_lists = [self.signed_terms(*coefficient) for coefficient in coefficients]
        touched = set()
        for i, terms in enumerate(term_lists):
            for j, earlier_terms in enumerate(term_lists[:i]):
                for plus, owner, value in list(terms):
                    opposites = (
                        o for o in earlier_terms if o[2] == value and o[0] != plus
                    )
                    opposite = next(opposites, None)
                    if opposite is not None and opposite[1] != owner:
                        terms.remove((plus, owner, value))
                        earlier_terms.remove(opposite)
                        touched |= {i, j}
        remaining = []
        for k, coefficient in enumerate(coefficients):
            remaining += term_lists[k] if k in touched else [coefficient]
        return remaining

    def signed_terms(self, plus: bool, owner: int, value: Value) -> list[Signed]:
        """Return the terms of a coefficient."""
        name, values = self.components.operation(value)
        if name not in SIGNS:
            return [(plus, owner, value)]
        terms = []
        for sign, argument in zip(SIGNS[name], values, strict=True):
            terms += self.signed_terms(plus == sign, owner, argument)
        return terms

    def added(self, terms: list[Signed]) -> Value:
        """Return a sum of terms."""
        total = None
        for plus, _, value in terms:
            if total is None:
                total = value if plus else self.components.add("neg", value)
                continue
            operation = "add" if plus else "sub"
            total = self.components.add(operation, total, value)
        return 0.0 if total is None else total

    def work(self, value: Value) -> int:
        """Return the cost of a value: of all components that it depends on, each once."""
        counted = set()
        stack = [value[0]] if type(value) is tuple else []
        cost = 0
        while stack:
            c = stack.pop()
            if c in counted or self.components.steady[c]:
                continue
            counted.add(c)
            name, arguments, lengths = self.components.all[c]
            if name not in ("load", "table"):
                factor = HEAVY if name in LONG else 1
                iterations = 8 if lengths or name == "sum" else 1
                cost += factor * iterations
                stack += [a[0] for a in arguments if type(a) is tuple]
        return cost
