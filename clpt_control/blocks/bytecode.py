"""What a function's code does, where there is no text of it or not the right one.

The text gives better sentences; the code is what runs.  Names of the module and
effects are found here for every function, so that one made by `exec` or at a prompt is
read as safely as one in a file.
"""

import dis
from collections.abc import Iterator
from types import FunctionType

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
    "PUSH_EXC_INFO": ("`try` or `with`", "keep the arguments in range with where or clip"),
}


def names_read(function: FunctionType) -> Iterator[tuple[int, str]]:
    """Give the names of the module that code reads, with their lines.

    Parameters
    ----------
    function : function
        Equations or a helper of them.

    Yields
    ------
    tuple
        Line and name.

    Examples
    --------
    >>> from clpt_control.blocks import basis
    >>> sorted({name for _, name in names_read(basis.tide)})
    ['math']
    """
    for line, operation, name in _instructions(function):
        if operation == "LOAD_GLOBAL":
            yield line, name


def effects(function: FunctionType) -> Iterator[tuple[int, str, str]]:
    """Give what code does beside calculating, and what to write.

    Parameters
    ----------
    function : function
        Equations or a helper of them.

    Yields
    ------
    tuple
        Line, what it does, what to write instead.
    """
    for line, operation, _ in _instructions(function):
        if operation in EFFECTS:
            yield line, *EFFECTS[operation]


def _instructions(function: FunctionType) -> Iterator[tuple[int, str, str]]:
    for one in dis.get_instructions(function):
        line = one.positions.lineno if one.positions else None
        yield line or function.__code__.co_firstlineno, one.opname, str(one.argval)
