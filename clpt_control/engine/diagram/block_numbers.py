"""Numbers of the blocks of a diagram in a run, from all who give them.

    a block's own < params of the inner diagram < of the outer diagram < of the call

This is python-control's order of precedence.  A name counts from the diagram that gives it:
``lag.gain`` changes all blocks of this name inside, ``a.lag.gain`` one.  `blocks_of` makes
python-control's systems blocks, each with these numbers, so every verb that reads a block has them.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import lru_cache
from itertools import chain
from typing import Any, NamedTuple, TypeAlias

import control

from ...base.arguments import brief, has_nan, known
from ...base.errors import ArgumentError, BlockError
from ...base.labelled import unit_of
from ..model.block import Block
from ..model.declaration import Parameters, same_unit
from ..model.system import System, linear

Part: TypeAlias = control.NonlinearIOSystem  # a subsystem of a diagram
Params = Mapping[str, Any] | None  # call-time parameters, as python-control has them
# of states and inputs, for a system that leaves them open
Sizes = tuple[int | None, int | None]
# functions that return a sentence on an unknown parameter, by its name and the known names, or ""
PARAMETER_HINTS: list[Callable[[str, set[str]], str]] = []


class Given(NamedTuple):
    """Params of a call, or of a diagram, whose names begin inside it."""

    words: str  # its name in messages
    begin: int  # of the names of its systems, in their names in the whole diagram
    params: Mapping[str, Any]


def blocks_of(
    diagram: Part,
    params: Params = None,
    sizes: Sizes = (None, None),
    complete: bool = True,
) -> list[tuple[str, Block]]:
    """Return the blocks of a diagram with their names and their numbers in a run.

    The numbers are a block's own, changed by the params of the diagrams around it, inner ones
    first, and then by `params` of a call.  python-control has the same order.  Its systems become
    blocks, with `sizes`, of states and inputs, if they leave them open.  Rules of parts are checked
    if the numbers are `complete`: others of a sweep or a fit may follow.
    """
    blocks: list[tuple[str, Block]] = []
    checked: dict[tuple[int, int], tuple[Given, list[tuple[str, Block]]]] = {}
    for name, part, values, around in parts_of(diagram, params):
        if isinstance(part, Block):
            block = part.having(values, complete)
        else:
            block = System(part, {**part.params, **values}, sizes)
        blocks.append((name, block))
        for given in around:
            key = given.begin, id(given.params)
            owned = checked.setdefault(key, (given, []))[1]
            owned.append((name[given.begin :], block))
    for given, owned in checked.values():
        check_params(given, owned)
    return blocks


def parts_of(
    diagram: Part, params: Params = None
) -> Iterator[tuple[str, Part, dict[str, Any], tuple[Given, ...]]]:
    """Yield name and system of each leaf, the values it is given by its own names, and by whom."""
    around = (Given("params", 0, params or {}),)
    for name, leaf, givers in _leaves_with_params(diagram, around):
        part = linear(leaf) if isinstance(leaf, control.StateSpace) else leaf
        values: dict[str, Any] = {}
        for given in givers:
            values |= values_of(name[given.begin :], part, given.params)
        yield name, part, values, givers


def _leaves_with_params(
    system: Part, around: tuple[Given, ...], path: str = ""
) -> Iterator[tuple[str, Part, tuple[Given, ...]]]:
    """Yield name, system, and the params around each leaf, the innermost first."""
    if not isinstance(system, control.InterconnectedSystem):
        yield path + system.name, system, around
        return
    # python-control puts the parameters of its blocks among the params of a diagram
    params = {
        key: value
        for key, value in system.params.items()
        if not isinstance(value, Parameters)
    }
    around = (Given(f"{system.name}.params", len(path), params), *around)
    for subsystem in system.syslist:
        nested = isinstance(subsystem, control.InterconnectedSystem)
        inner = f"{path}{subsystem.name}." if nested else path
        yield from _leaves_with_params(subsystem, around, inner)


def check_params(given: Given, blocks: Iterable[tuple[str, Block]]) -> None:
    """Refuse params that none of the blocks has, NaN, and other units than a block's."""
    words, _, params = given
    if not params:
        return
    accepted: set[str] = set()
    names: set[str] = set()
    systems = []
    for name, block in blocks:
        fields = call_names(name, block)
        for key in fields.keys() & params:
            unit = block.units.get(fields[key], "")
            check_unit(f"{name}.{fields[key]}", unit_of(params[key]), [unit])
        inner = block.unsampled
        if isinstance(inner, System):
            systems.append((name, inner))
            names |= inner.names
        if not isinstance(block, System):
            accepted |= fields.keys()
            names |= {f"{name}.{field}" for field in block.parameters._fields}
    for key, value in params.items():
        if has_nan(value):
            raise BlockError(
                f"{words}: {key} = {brief(value)}: must be a number, without NaN"
            )
        is_read = key in accepted or any(
            system.mentions(str(key).removeprefix(prefix))
            for name, system in systems
            for prefix in chain(*prefixes_of(name))
        )
        if not is_read:
            hints = (hint_of(key, accepted) for hint_of in PARAMETER_HINTS)
            unknown = f"{words}: unknown parameter '{key}'. {known(key, sorted(names))}"
            raise BlockError(next(filter(None, hints), unknown))


def own_params(name: str, params: Mapping[str, Any]) -> dict[str, Any]:
    """Return the params of one system; the key may begin with its name or a diagram's name."""
    diagrams, systems = prefixes_of(name)
    named = {
        key.removeprefix(prefix): value
        for prefix in (*diagrams[1:], *systems)
        for key, value in params.items()
        if str(key).startswith(prefix)
    }
    return {**params, **named}


def values_of(name: str, part: Part, params: Mapping[str, Any]) -> dict[str, Any]:
    """Return the values that params give a part, by its own names."""
    if not isinstance(part, Block):
        return own_params(name, params)
    names = call_names(name, part).items()
    return {field: params[key] for key, field in names if key in params}


def call_names(name: str, block: Block) -> dict[str, str]:
    """Return the names that a call may give a block's parameters, ``a.plant.k``, and the fields.

    Parameters of python-control's systems, sampled or not, are called ``k`` and ``a.k`` too.
    """
    diagrams, systems = prefixes_of(name)
    inner = block.unsampled
    fields = inner.parameters._fields if isinstance(inner, System) else ()
    names = {prefix + field: field for prefix in diagrams for field in fields}
    fields = block.parameters._fields
    return names | {prefix + field: field for prefix in systems for field in fields}


@lru_cache(maxsize=1024)
def prefixes_of(name: str) -> tuple[list[str], list[str]]:
    """Return the prefixes of a param of ``a.plant``; the last has priority.

    First of the diagrams around it, "" and "a.", then of itself, "plant." and "a.plant.".
    """
    path = name.split(".")
    diagrams = [".".join([*path[:k], ""]) for k in range(len(path))]
    systems = [".".join([*path[k:], ""]) for k in reversed(range(len(path)))]
    return diagrams, systems


def check_unit(argument: str, given: str, units: Iterable[str]) -> None:
    """Refuse a unit given that signals with units do not have."""
    for unit in units:
        if unit and given and not same_unit(unit, given):
            raise ArgumentError(f"{argument}: is in '{given}'; must be in '{unit}'")
