"""One loop of turns that do the same.

Turns are the same if they do the same operations in the same order, read places that are
affine in the turn, and hand on nothing but a sum.  Constants that differ from turn to turn
become a table.
"""

from collections.abc import Iterable
from typing import Any, NamedTuple

from .program import Loop, Step, Store, Sum
from .rolled import Constant, Place, Table


class Different(Exception):
    """Turns that do not do the same."""


class _Carried(NamedTuple):
    """What the turn before computed, and what the first turn reads in its place."""

    value: int
    first: Any


class Shared:
    """What the loops of a record share: constants, room, and where values lie."""

    def __init__(self, fresh: int, last_use: list[int]):
        self.fresh, self.last_use = fresh, last_use
        self.constants: list[float] = []
        self.tables: dict[tuple, int] = {}
        self.room = 0
        self.alias: dict[int, Place] = {}

    def copy(self) -> "Shared":
        """Return a copy, to go back to where turns differ."""
        other = Shared(self.fresh, self.last_use)
        other.constants, other.tables = list(self.constants), dict(self.tables)
        other.room, other.alias = self.room, dict(self.alias)
        return other

    def table(self, column: list[Constant]) -> int:
        """Return the place in K of constants, kept once."""
        key = tuple(column)
        if key not in self.tables:
            self.tables[key] = len(self.constants)
            self.constants += [constant.value for constant in column]
        return self.tables[key]


class Merge:
    """Make one loop of turns that do the same."""

    def __init__(self, shared: Shared, turns: list[list], end: int):
        self.shared, self.turns, self.end = shared, turns, end
        self.level = 1 + max((i.level for i in turns[0] if isinstance(i, Loop)), default=-1)
        # value of a turn -> the same one of the first turn
        self.same: list[dict[int, int]] = [{} for _ in turns]

    def loop(self) -> Loop:
        """Return the loop; raise `Different` where turns differ."""
        self.pair(self.turns)
        body, sums = self.summed(self.merged(self.turns))
        body += self.kept(body, {s.turned for s in sums} | self.links)
        return Loop(self.level, len(self.turns), tuple(body), tuple(sums))

    def pair(self, parallel: list[list]) -> None:
        """Note which values of the turns are the same one; refuse what does not pair."""
        if len({len(items) for items in parallel}) > 1:
            raise Different
        for column in zip(*parallel, strict=True):
            shapes = {
                (type(o), o.name, len(o.arguments))
                if isinstance(o, Step)
                else (type(o), o.level, o.count, len(o.sums))
                if isinstance(o, Loop)
                else type(o)
                for o in column
            }
            if len(shapes) > 1:
                raise Different
            if isinstance(column[0], Step):
                self.note(one.value for one in column)
            elif isinstance(column[0], Loop):
                for s in range(len(column[0].sums)):
                    self.note(one.sums[s].within for one in column)
                    self.note(one.sums[s].result for one in column)
                self.pair([list(one.body) for one in column])

    def merged(self, parallel: list[list]) -> list:
        """Return the items of the turns as those of one turn."""
        return [self.item(list(column)) for column in zip(*parallel, strict=True)]

    def item(self, column: list) -> Any:
        """Return one item for the same one of every turn."""
        first = column[0]
        if isinstance(first, Step):
            arguments = zip(*(one.arguments for one in column), strict=True)
            return first._replace(arguments=tuple(map(self.argument, arguments)))
        if isinstance(first, Store):
            at = self.argument([Place(o.array, o.base, o.steps) for o in column])
            return Store(at.array, at.base, at.steps, self.argument([o.value for o in column]))
        starts = (self.argument([o.sums[s].first for o in column]) for s in range(len(first.sums)))
        sums = tuple(own._replace(first=new) for own, new in zip(first.sums, starts, strict=True))
        return first._replace(body=tuple(self.merged([list(o.body) for o in column])), sums=sums)

    def note(self, values: Iterable[int]) -> None:
        """Note that these values, one of each turn, are the same one."""
        values = list(values)
        for same, value in zip(self.same, values, strict=True):
            same[value] = values[0]

    def argument(self, column: Iterable) -> Any:
        """Return one argument for the same one of every turn."""
        column = list(column)
        first, rest = column[0], column[1:]
        kinds = {type(a) for a in column}
        if kinds == {Constant}:
            if len(set(column)) == 1:
                return first
            return Place("K", self.shared.table(column), ((self.level, 1),))
        if kinds == {Place}:
            step = column[1].base - first.base
            for k, place in enumerate(column):
                if place != (first.array, first.base + k * step, first.steps):
                    raise Different
            own = ((self.level, step),) if step else ()
            return Place(first.array, first.base, first.steps + own)
        if kinds == {Table}:
            if any(a[1:] != first[1:] for a in rest):
                raise Different
            return first._replace(place=self.argument([a.place for a in column]))
        if any(type(a) is not int for a in rest):
            raise Different
        here = [same.get(a) for same, a in zip(self.same[1:], rest, strict=True)]
        if type(first) is int and set(here) == {self.same[0].get(first)} != {None}:
            return first
        if len(set(column)) == 1 and set(here) == {None}:
            return first
        before = {same.get(a) for same, a in zip(self.same, rest, strict=False)}
        if len(before) == 1 and None not in before and self.same[0].get(first) is None:
            return _Carried(before.pop(), first)  # type: ignore[arg-type]
        raise Different

    # --- sums -----------------------------------------------------------------------------

    def summed(self, body: list) -> tuple[list, list[Sum]]:
        """Turn what is carried into sums; refuse what is carried otherwise."""
        carried = {a for item in body for a in _arguments(item) if isinstance(a, _Carried)}
        self.links: set[int] = set()
        sums = []
        for one in sorted(carried):
            self.follow(body, one)
            self.shared.fresh += 1
            last = {same: own for own, same in self.same[-1].items()}
            sums.append(Sum(one.first, self.shared.fresh, one.value, last[one.value]))
        names = {one: s.within for one, s in zip(sorted(carried), sums, strict=True)}
        return [_renamed(item, names) for item in body], sums

    def follow(self, body: list, carried: _Carried) -> None:
        """Follow a sum from its start to its end within a turn."""
        uses: dict[Any, list] = {}
        for item in body:
            for a in _arguments(item):
                uses.setdefault(a, []).append(item)
        at: Any = carried
        while True:
            users = uses.get(at, [])
            if len(users) != 1:
                raise Different
            at = _added(users[0], at)
            if at is None:
                raise Different
            last = at == carried.value
            turns = self.same[:-1] if last else self.same
            for same in turns:
                own = [value for value, first in same.items() if first == at]
                if any(self.read_outside(value) for value in own):
                    raise Different
            if last:
                if at in uses:
                    raise Different
                return
            self.links.add(at)

    def read_outside(self, value: int) -> bool:
        """Whether a value is read behind the loop."""
        uses = self.shared.last_use
        return value < len(uses) and uses[value] >= self.end

    def kept(self, body: list, sums: set[int]) -> list[Store]:
        """Keep what is read outside of the loop, a number a turn."""
        stores = []
        for item in body:
            values = [item.value] if isinstance(item, Step) else []
            values += [s.result for s in item.sums] if isinstance(item, Loop) else []
            for value in values:
                own = [next(v for v, first in same.items() if first == value) for same in self.same]
                if value in sums or not any(map(self.read_outside, own)):
                    continue
                base = self.shared.room
                self.shared.room += len(own)
                stores.append(Store("S", base, ((self.level, 1),), value))
                self.shared.alias.update({v: Place("S", base + k) for k, v in enumerate(own)})
        return stores


def _arguments(item: Any) -> list:
    """Return what an item reads; of a loop all that its turns read, too."""
    if isinstance(item, Step):
        return list(item.arguments)
    if isinstance(item, Store):
        return [item.value]
    inner = [a for part in item.body for a in _arguments(part)]
    return [s.first for s in item.sums] + inner


def _added(item: Any, value: Any) -> int | None:
    """Return the sum to which an item adds, or None."""
    if isinstance(item, Loop):
        own = [s.result for s in item.sums if s.first == value]
        inner = any(a == value for part in item.body for a in _arguments(part))
        return own[0] if len(own) == 1 and not inner else None
    if not isinstance(item, Step) or sum(a == value for a in item.arguments) != 1:
        return None
    if item.name == "add" or (item.name == "sub" and item.arguments[0] == value):
        return item.value
    return None


def _renamed(item: Any, names: dict) -> Any:
    def new(a: Any) -> Any:
        return names[a] if isinstance(a, _Carried) else a

    if isinstance(item, Step):
        return item._replace(arguments=tuple(map(new, item.arguments)))
    if isinstance(item, Store):
        return item._replace(value=new(item.value))
    body = tuple(_renamed(part, names) for part in item.body)
    return item._replace(body=body, sums=tuple(s._replace(first=new(s.first)) for s in item.sums))
