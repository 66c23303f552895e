"""A program: what machine code is printed from.

A list of items in single assignment: numbers are read from arrays (`Load`),
calculated (`Step`), kept (`Store`); a `Loop` repeats its items.  Arrays: t, X
(states), P (parameters), T (tables that runs share), K (constants), W (signals and
room), D (what is computed).  Places within a loop are affine in its turns:

    base + sum over levels of step * turn,    level 0 the innermost loop
"""

from typing import NamedTuple

CONDITIONS = ("lt", "le", "gt", "ge", "and", "or", "not")  # whose values are yes or no
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
