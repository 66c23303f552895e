"""Decisions: where equations are not smooth, and how they are locked for the length of a step.

    where(a < b, c, d),  minimum(a, b),  |a|,  sign(a),  floor(a),  a row read at a place

A step of the solver over a kink is worth little.  So while it is taken the rates keep every
decision as it was where the step began: they are smooth, also a little beyond the kink.  Where a
step has gone beyond one, at its end or at one of seven places before it, `solver` finds the
crossing, where states feel it, and begins anew there, decided again.

    H    what was decided: 1 or -1, the whole number of a floor, the place in a row; kept in P
    D    what is decided now, of all decisions, and then for each whether the step has passed it:
         the difference of what is compared has the other sign than H, by more than rounding

The gridded current, which is smooth, stays as it is.  Discontinuity locking: Cellier and
Kofman, Continuous System Simulation, 2006, chapter 9.
"""

from math import prod
from typing import Any, NamedTuple

from ..equations.record import reached

COMPARED = {"lt": -1.0, "le": -1.0, "gt": 1.0, "ge": 1.0}  # the sign of a - b where they hold
WHOLE = ("floor", "ceil", "trunc", "floordiv")
# what other operations decide: comparisons, the second number 0 where there is one, whole numbers
QUESTIONS = {
    **{"minimum": ("lt",), "maximum": ("gt",), "sign": ("gt", "lt"), "fabs": ("ge",)},
    **{"mod": ("floordiv",), "pick": ("trunc",)},
}
LOCKED = frozenset({*COMPARED, *WHOLE, *QUESTIONS})
ROUNDING = 1e-12  # of what is compared
Ref = Any


class Port(NamedTuple):
    """A value that is stored: its first place, lengths of its axes, and which of them loop."""

    first: int
    shape: tuple[int, ...]
    long: tuple[bool, ...]
    ref: Ref


def _given(name: str, own: tuple[Ref, ...]) -> tuple[Ref, ...]:
    """Return what a question is asked of."""
    if name in COMPARED:
        return own[0], own[1] if len(own) > 1 else 0.0
    return own if name == "floordiv" else own[-1:]


class Decisions:
    """The decisions of a diagram's rates, as they are and as they were when a step began."""

    def __init__(self, record: Any, grain: int):
        self.record, self.grain = record, grain  # place in P of the least difference that counts
        self.now: list[Port] = []
        self.passed: list[Port] = []
        self.of: list[tuple] = []  # first place of each, and whose it is
        self.count = 0  # numbers that are decided

    def lock(self, rates: list[Port]) -> list[Port]:
        """Write rates down again, locked; return them."""
        record, locked = self.record, dict[int, Ref]()
        moving: set[Ref] = set()  # what changes along a run

        def stands(ref: Ref) -> Ref:
            return locked.get(ref, ref) if type(ref) is int else ref

        for k in sorted(reached(record.entries, [port.ref for port in rates])):
            kind, exact, shape, at = record.entries[k]
            places = [a for a in exact if type(a) is int]
            if moving.intersection(places) or (kind == "load" and at[0] in "Xt"):
                moving.add(k)
            own = tuple(map(stands, exact))
            if k in record.decided_by and moving.intersection(places):
                locked[k] = self._locked(k, own)
            elif not locked.keys().isdisjoint(places):
                locked[k] = record.add(kind, own, shape, at, record.owners[k])
        return [p._replace(ref=stands(p.ref)) for p in rates]

    def _locked(self, k: int, own: tuple[Ref, ...]) -> Ref:
        """Note what an operation decides; return its locked value, of what is locked itself."""
        (kind, exact, shape, _), owner = self.record.entries[k], self.record.owners[k]
        (long, of), held = self.record.decided_by[k], list[Ref]()

        def add(kind: str, *given: Ref) -> Ref:
            return self.record.add(kind, given, shape, None, owner)

        for name in QUESTIONS.get(kind, (kind,)):
            found = add(name, *_given(name, exact))
            if name in COMPARED:
                found = add("where", found, 1.0, -1.0)
            H = self.record.load("P", self.grain + 1 + self.count, shape)
            beyond = self._passed(name, _given(name, own), H, shape)
            self.now.append(Port(self.count, shape, long, found))
            self.passed.append(Port(self.count, shape, long, beyond))
            self.of.append((self.count, of))
            self.count += prod(shape)
            held.append(add("gt", H, 0.0) if name in COMPARED else H)
        if kind in COMPARED or kind in WHOLE:
            return held[0]
        if kind == "sign":
            return add("where", held[0], 1.0, add("where", held[1], -1.0, 0.0))
        if kind == "fabs":
            return add("where", held[0], own[0], add("neg", own[0]))
        if kind == "mod":
            beyond = add("sub", own[0], add("mul", own[1], held[0]))
            same = add("eq", add("floordiv", *own), held[0])
            return add("where", same, add("mod", *own), beyond)
        return add("pick", own[0], held[0]) if kind == "pick" else add("where", held[0], *own)

    def _passed(self, name: str, given: tuple, H: Ref, shape: tuple) -> Ref:
        """Return whether a step has passed a decision, as 1 or 0."""

        def add(kind: str, *arguments: Ref) -> Ref:
            return self.record.add(kind, arguments, shape)

        size = add("fabs", given[0])
        if name in COMPARED and given[1] != 0.0:
            size = add("add", size, add("fabs", given[1]))
        least = add("add", add("mul", size, ROUNDING), self.record.load("P", self.grain, ()))
        if name in COMPARED:
            apart = add("sub", *given)
            beyond = add("neg", apart) if COMPARED[name] < 0 else apart
            found = add("lt", add("mul", beyond, H), add("neg", least))
        else:
            sides = (add(side, given[0], least) for side in ("add", "sub"))
            found = add("and", *(add("ne", add(name, one, *given[1:]), H) for one in sides))
        return add("where", found, 1.0, 0.0)
