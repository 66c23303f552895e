"""References in the code of a function: the names that it loads, and the attributes behind them.

    os.path.join(a, b)  ->  Reference("global", "os", ("path", "join"), line)

The byte code is read for names alone; what a function computes is found by tracing it.
"""

import dis
import functools
from collections.abc import Iterator
from types import CodeType
from typing import Any, NamedTuple

LOADS = {
    **dict.fromkeys(("LOAD_GLOBAL", "LOAD_NAME"), "global"),
    **dict.fromkeys(("LOAD_DEREF", "LOAD_CLASSDEREF", "LOAD_FROM_DICT_OR_DEREF"), "cell"),
    "LOAD_FROM_DICT_OR_GLOBALS": "global",
}
LOCALS = ("LOAD_FAST", "LOAD_FAST_BORROW", "LOAD_FAST_CHECK", "LOAD_DEREF")
ATTRIBUTES = ("LOAD_ATTR", "LOAD_METHOD")
CHANGES = ("STORE_ATTR", "DELETE_ATTR")


class Reference(NamedTuple):
    """A name that code loads, with the attributes that the code loads of its value at once."""

    space: str  # "global", "cell", or "import" of a module by the function itself
    name: str
    attributes: tuple[str, ...]
    line: int
    stored: bool = False  # the last attribute is set or deleted


@functools.lru_cache(maxsize=1024)
def references(code: CodeType) -> tuple[Reference, ...]:
    """Return what code references, with the functions in it; each once."""
    found: dict[tuple, Reference] = {}
    for one in all_code(code):
        for reference in _references_of(one):
            if reference.space != "cell" or reference.name in code.co_freevars:
                found.setdefault(reference[:3] + reference[4:], reference)
    return tuple(found.values())


def _references_of(code: CodeType) -> Iterator[Reference]:
    lines = list(dis.get_instructions(code))
    imported: dict[str, tuple[str, tuple[str, ...]]] = {}  # local variable -> module, name in it
    for k, line in enumerate(lines):
        number = (line.positions and line.positions.lineno) or 0
        following = lines[k + 1 :]
        if line.opname == "IMPORT_NAME":
            imported |= _imported(line.argval, lines[k - 2].argval, lines[k - 1].argval, following)
            yield Reference("import", "." * lines[k - 2].argval + line.argval, (), number)
        elif line.opname in LOCALS and line.argval in imported:
            module, names = imported[line.argval]
            one = _with_attributes("import", module, following, number)
            yield one._replace(attributes=names + one.attributes)
        elif line.opname in LOADS:
            yield _with_attributes(LOADS[line.opname], line.argval, following, number)


def _imported(
    module: str, level: int, names: Any, following: list[Any]
) -> dict[str, tuple[str, tuple[str, ...]]]:
    """Return the variables that an import statement sets: module, and name in the module."""
    found: dict[str, tuple[str, tuple[str, ...]]] = {}
    name = ""
    for line in following:
        if line.opname == "IMPORT_FROM":
            name = line.argval
        elif line.opname.startswith("STORE_"):
            if names:  # from module import name
                found[line.argval] = "." * level + module, (name,)
            else:  # import a.b binds a, import a.b as c binds a.b
                found[line.argval] = module if name else module.partition(".")[0], ()
        elif line.opname not in ("SWAP", "POP_TOP"):
            break
        if not names and line.opname.startswith("STORE_"):
            break
    return found


def _with_attributes(space: str, name: str, following: list[Any], number: int) -> Reference:
    attributes: list[str] = []
    for line in following:
        if line.opname not in (*ATTRIBUTES, *CHANGES):
            break
        attributes.append(line.argval)
        if line.opname in CHANGES:
            return Reference(space, name, tuple(attributes), number, stored=True)
    return Reference(space, name, tuple(attributes), number)


@functools.lru_cache(maxsize=1024)
def code_names(code: CodeType) -> tuple[str, ...]:
    """Return the names that code loads, with those of the functions in it."""
    return tuple(dict.fromkeys(name for one in all_code(code) for name in one.co_names))


@functools.lru_cache(maxsize=1024)
def code_texts(code: CodeType) -> frozenset[str]:
    """Return the texts among the constants of code, with those of the functions in it."""
    constants = [value for one in all_code(code) for value in one.co_consts]
    items = [one for value in constants for one in (value if type(value) is tuple else [value])]
    return frozenset(one for one in items if isinstance(one, str))


def all_code(code: CodeType) -> Iterator[CodeType]:
    """Yield code, and that of the functions in it."""
    yield code
    for one in code.co_consts:
        if isinstance(one, CodeType):
            yield from all_code(one)
