"""What a function's code does, where there is no text of it or not the right one.

The text gives better sentences; the code is what runs.  Names of the module and
effects are found here for every function, so that one made by `exec` or at a prompt is
read as safely as one in a file.
"""

import dis
from collections.abc import Iterator
from functools import lru_cache
from types import CodeType, FunctionType

EFFECTS = {
    "STORE_GLOBAL": ("`global`", "put the number into the block's parameters"),
    "DELETE_GLOBAL": ("`global`", "put the number into the block's parameters"),
    "IMPORT_NAME": ("`import`", "import at the top of the module"),
    "MAKE_FUNCTION": (
        "a function or a comprehension inside a function",
        "define it at the top of the module, or use `for i in range(n)`",
    ),
    "LOAD_BUILD_CLASS": ("a class inside a function", "a block computes numbers only"),
    "RAISE_VARARGS": ("`raise` or `assert`", "check parameters before the block is made"),
    "YIELD_VALUE": ("`yield`", "fill the output array"),
    **dict.fromkeys(
        ("STORE_ATTR", "DELETE_ATTR"), ("setting an attribute", "fill the output array")
    ),
    **dict.fromkeys(("IS_OP", "CONTAINS_OP"), ("`is` or `in`", "compare with <, <=, >, >=")),
    **dict.fromkeys(
        ("MATCH_CLASS", "MATCH_SEQUENCE", "MATCH_MAPPING"),
        ("`match`", "use where(condition, a, b)"),
    ),
    **dict.fromkeys(
        ("FORMAT_VALUE", "FORMAT_SIMPLE", "FORMAT_WITH_SPEC", "BUILD_STRING"),
        ("a string", "a block computes numbers only"),
    ),
    "RETURN_GENERATOR": ("`async` or `yield`", "fill the output array"),
    "PUSH_EXC_INFO": ("`try` or `with`", "keep the arguments in range with where or clip"),
}


def names_read(function: FunctionType) -> Iterator[tuple[int, str]]:
    """Return the names of the module that code reads, with their lines."""
    for one in _code(function.__code__):
        if one.opname == "LOAD_GLOBAL":
            yield _line(one, function), one.argval


def effects(function: FunctionType) -> Iterator[tuple[int, str, str]]:
    """Return what code does beside calculating, and what to write."""
    for one in _code(function.__code__):
        line = _line(one, function)
        if one.opname in EFFECTS:
            yield line, *EFFECTS[one.opname]
        elif one.opname == "LOAD_CONST" and isinstance(one.argval, str | bytes):
            yield line, *EFFECTS["BUILD_STRING"]


@lru_cache(maxsize=1024)
def _code(code: CodeType) -> tuple[dis.Instruction, ...]:
    return tuple(dis.get_instructions(code))


def _line(one: dis.Instruction, function: FunctionType) -> int:
    line = one.positions.lineno if one.positions else None
    return line or function.__code__.co_firstlineno
