"""The error of a function that cannot be traced, its line, and the tape of a thread that traces."""

import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from inspect import signature
from threading import local
from traceback import extract_tb, walk_tb
from types import CodeType, FrameType
from typing import Any

import numpy as np

from ...base.arguments import attribute_of


class Unread(Exception):
    """A function cannot be traced: the sentence says why, and what to write instead."""

    def __init__(self, sentence: str, stops: bool = True):
        super().__init__(sentence)
        if stops and (tape := active()) is not None:
            tape.stopped = self  # a function may catch it


_ACTIVE = local()


def active() -> Any:
    """Return the tape on which this thread traces a function now, or None."""
    return getattr(_ACTIVE, "tape", None)


@contextmanager
def reading_on(tape: Any) -> Iterator[None]:
    """Make this thread trace on a tape."""
    before = active()
    _ACTIVE.tape = tape
    try:
        yield
    finally:
        _ACTIVE.tape = before


# --- functions and lines of the user's code, for sentences --------------------------------------


def check_call(
    function: Callable, error: type[Exception], count: int, sentence: str
) -> None:
    """Raise an error with a sentence if a function does not take `count` arguments."""
    try:
        signature(function).bind(*[None] * count)
    except (TypeError, ValueError):  # a built-in function tells no arguments
        raise error(sentence) from None


LIBRARIES = ("numpy", "scipy", "matplotlib", "pandas", "xarray")  # run as they are
ADVICE = {  # pattern of an error -> what to do
    r"takes \d positional arguments? but 4": "Its arguments are t, x, u, p",
    r"missing \d+ required positional arguments?: '(t|x|u|p|params)'": (
        "Its arguments are t, x, u, p"
    ),
    r"'(dict|Params)' object has no attribute": 'Here a parameter is p["k"]',
    r"invalid index to scalar variable": "Its arguments are t, x, u, p",
    r"destination is read-only": "Return the rates; x, u and p stay as they are",
    r"'_Signals'": "Signals have names: lambda s: s.x**2",
    r"operand.*'(list|tuple)'": "Give a parameter of several numbers as np.array",
    r"operand.*'(decimal\.Decimal|Fraction)'": "Give numbers as float",
}
STATEMENT = "__statement__"  # name of a function that is a statement of the user's
ENGINE = __package__.rpartition(".")[0]


def caller() -> str:
    """Return the caller that needs a number: a library's function, or Python."""
    frame = sys._getframe(2)
    word = "Python"
    while (module := _not_users(frame)) and frame.f_back is not None:
        if not module.startswith(ENGINE):
            word = f"{module.partition('.')[0]}'s {frame.f_code.co_qualname}"
        frame = frame.f_back
    return word


def _not_users(frame: FrameType) -> str:
    """Return the module of a frame of this package or of a library; "" of a user's."""
    module = frame.f_globals.get("__name__") or ""
    return module if module.startswith((*LIBRARIES, ENGINE)) else ""


def located(function: Any, *errors: BaseException) -> str:
    """Return function and line at which tracing stopped, for a sentence.

    The first error with a line of the user's code counts, as a library may swallow one.
    """
    for error in errors:
        lines = [
            f"{_name_in_source(frame.f_code)}, line {line}: "
            for frame, line in walk_tb(error.__traceback__)
            if not _not_users(frame)
        ]
        if lines:
            return lines[-1]
    return f"{attribute_of(function, '__name__', 'it')}: "


def line_of(function: Any, error: BaseException) -> str:
    """Return the function, its line and its error, for a sentence."""
    message = " ".join(str(error).splitlines())  # an assertion may have none
    text = ": ".join(filter(None, [type(error).__name__, message]))
    advice = _advice_on_math(error)
    for pattern, cure in ADVICE.items():
        if re.search(pattern, text):
            advice = f". {cure}"
    return located(function, error) + text + advice


def _advice_on_math(error: BaseException) -> str:
    """Return advice on a function of `math` that was given several numbers, or ""."""
    line = extract_tb(error.__traceback__)[-1].line or ""
    name = isinstance(error, TypeError) and re.search(r"\bmath\.(\w+)", line)
    if not name:
        return ""
    of_arrays = f"np.{name[1]}, or " * hasattr(np, name[1])
    return f". {name[0]} takes one number. Use {of_arrays}an element of the port"


def _name_in_source(code: CodeType) -> str:
    """Return the name of a function, not of a statement in it that became one."""
    qualname = code.co_qualname.replace(f".<locals>.{STATEMENT}", "")
    return qualname.rpartition(".")[2]
