"""A program: what machine code is printed from.

A list of items in single assignment: numbers are read from arrays (`Load`),
calculated (`Step`), kept (`Store`); a `Loop` repeats its items.  Arrays: t, X
(states), P (parameters), T (tables that runs share), K (constants), W (signals and
room), D (what is computed).  Places within a loop are affine in its turns:

    base + sum over levels of step * turn,    level 0 the innermost loop
"""

from typing import Any, NamedTuple

CONDITIONS = ("lt", "le", "gt", "ge", "and", "or", "not")  # whose values are yes or no
LANES = 8  # runs side by side
Ref = int | float  # a value by its number, or a constant
Steps = tuple[tuple[int, int], ...]  # (level of a loop, step)


class Load(NamedTuple):
    """value = array[place]."""

    value: int
    array: str
    base: int
    steps: Steps = ()


class Step(NamedTuple):
    """value = name(arguments): values, constants, tuples."""

    value: int
    name: str
    arguments: tuple


class Store(NamedTuple):
    """array[place] = value."""

    array: str
    base: int
    steps: Steps
    value: Ref


class Sum(NamedTuple):
    """A number that turns add to: before, within, turned and after."""

    first: Ref
    within: int
    turned: int
    result: int


class Loop(NamedTuple):
    """Items for every turn; turns hand on nothing but sums."""

    level: int
    count: int  # type: ignore[assignment]
    body: "tuple[Item, ...]"
    sums: tuple[Sum, ...]


Item = Load | Step | Store | Loop


def lines(items: tuple[Item, ...], indent: str = "  ") -> list[str]:
    """Return items as text, a line each; the turn of a loop of level 0 is i0."""

    def at(array: str, base: int, steps: Steps) -> str:
        turns = [f"i{level}" if step == 1 else f"{step} i{level}" for level, step in steps]
        return f"{array}[{' + '.join([str(base)] * (base != 0 or not turns) + turns)}]"

    def argument(a: Any) -> str:
        if type(a) is tuple:  # a table: array, base, steps, stride, count
            return f"{at(*a[:3])} and on, {a[4]} by {a[3]}"
        return f"v{a}" if type(a) is int else repr(a)

    found = []
    for item in items:
        if isinstance(item, Load):
            found.append(f"{indent}v{item.value} = {at(*item[1:])}")
        elif isinstance(item, Step):
            arguments = ", ".join(map(argument, item.arguments))
            found.append(f"{indent}v{item.value} = {item.name}({arguments})")
        elif isinstance(item, Store):
            found.append(f"{indent}{at(*item[:3])} = {argument(item.value)}")
        else:
            found += [f"{indent}v{s.within} = {argument(s.first)}" for s in item.sums]
            found.append(f"{indent}for i{item.level} in range({item.count}):")
            found += lines(item.body, indent + "  ")
            found += [f"{indent}  v{s.within} = v{s.turned}" for s in item.sums]
            found += [f"{indent}v{s.result} = v{s.within}" for s in item.sums]
    return found


class Program(NamedTuple):
    """The functions of a diagram, as lists of items.

    What depends on parameters alone is computed by `prepare` and kept at the end of P.
    """

    derivative: tuple[Item, ...]  # D = dx/dt
    signals: tuple[Item, ...]  # W = all block outputs
    margin: tuple[Item, ...]  # D[0] = least distance to a guard's edge
    prepare: tuple[Item, ...]
    constants: tuple[float, ...]  # K
    parameters: int  # length of P
    room: int  # length of W
    jump: tuple[Item, ...] = ()  # D = states after the jumps that P asks for; empty without any
