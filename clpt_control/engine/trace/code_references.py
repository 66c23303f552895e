"""References in the code of a function: the names that it loads, and the attributes behind them.

    os.path.join(a, b)  ->  Reference("global", "os", ("path", "join"), line)
    import os           ->  Reference("import", "os", (), line)

The byte code is read for names alone; what a function computes is found by tracing it.
"""

import dis
import functools
from collections.abc import Iterator
from itertools import takewhile
from types import CodeType
from typing import NamedTuple

LOADS = {
    **dict.fromkeys(("LOAD_GLOBAL", "LOAD_NAME"), "global"),
    **dict.fromkeys(
        ("LOAD_DEREF", "LOAD_CLASSDEREF", "LOAD_FROM_DICT_OR_DEREF"), "cell"
    ),
    "LOAD_FROM_DICT_OR_GLOBALS": "global",
}
ATTRIBUTES = ("LOAD_ATTR", "LOAD_METHOD", "STORE_ATTR", "DELETE_ATTR")


class Reference(NamedTuple):
    """A name that code loads, with the attributes that the code loads of its value at once."""

    space: str  # "global", "cell", or "import" of a module by the function itself
    name: str
    attributes: tuple[str, ...]
    line: int


@functools.lru_cache(maxsize=1024)
def references(code: CodeType) -> tuple[Reference, ...]:
    """Return what code references, with the functions in it; each once."""
    by_name: dict[tuple, Reference] = {}
    for inner in all_code(code):
        for reference in _references_of(inner):
            if reference.space != "cell" or reference.name in code.co_freevars:
                by_name.setdefault(reference[:3], reference)
    return tuple(by_name.values())


def _references_of(code: CodeType) -> Iterator[Reference]:
    lines = list(dis.get_instructions(code))
    for k, line in enumerate(lines):
        number = (line.positions and line.positions.lineno) or 0
        if line.opname == "IMPORT_NAME":
            yield Reference(
                "import", "." * lines[k - 2].argval + line.argval, (), number
            )
        elif line.opname in LOADS:
            following = takewhile(
                lambda instruction: instruction.opname in ATTRIBUTES, lines[k + 1 :]
            )
            attributes = tuple(instruction.argval for instruction in following)
            yield Reference(LOADS[line.opname], line.argval, attributes, number)


@functools.lru_cache(maxsize=1024)
def code_names(code: CodeType) -> tuple[str, ...]:
    """Return the names that code loads, with those of the functions in it."""
    return tuple(
        dict.fromkeys(name for inner in all_code(code) for name in inner.co_names)
    )


@functools.lru_cache(maxsize=1024)
def code_texts(code: CodeType) -> frozenset[str]:
    """Return the texts among the constants of code, with those of the functions in it."""
    constants = [value for item in all_code(code) for value in item.co_consts]
    items = [
        item
        for value in constants
        for item in (value if type(value) is tuple else [value])
    ]
    return frozenset(item for item in items if isinstance(item, str))


def all_code(code: CodeType) -> Iterator[CodeType]:
    """Yield code, and that of the functions in it."""
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from all_code(constant)
