"""What a block's equations may contain, checked when the block is made.

What cannot be recorded, or has an effect other than filling the last argument, is
refused with the function, the line and the word to use instead.  The source text
is read here only to give a good sentence, where there is a text; what equations
mean is never taken from it but from running them (`trace`).
"""

import ast
import builtins
import inspect
import math
import textwrap
from collections.abc import Callable
from types import FunctionType

from ..arguments import public, shown
from ..errors import BlockError
from .functions import effects, helpers_of, names_read
from .words import MATH

ALLOWED_BUILTINS = {"range", "len", "float", "int"}

_REPLACEMENTS: dict[type, tuple[str, str]] = {
    ast.If: ("`if`", "use where(condition, a, b)"),
    ast.IfExp: ("`a if c else b`", "use where(c, a, b)"),
    ast.BoolOp: ("`and`/`or`", "nest where(...) for each condition"),
    ast.While: ("`while`", "use `for i in range(n)` with n fixed by the parameters"),
    ast.Lambda: ("`lambda`", "define a function at the top of the module"),
    ast.FunctionDef: ("a function inside a function", "define it at the top of the module"),
    ast.ListComp: ("a comprehension", "use `for i in range(n)` and fill the output array"),
    ast.GeneratorExp: ("a generator", "use `for i in range(n)` and add the terms"),
    ast.DictComp: ("a comprehension", "use `for i in range(n)`"),
    ast.SetComp: ("a comprehension", "use `for i in range(n)`"),
    ast.Try: ("`try`", "keep the arguments in range with where, clip or maximum"),
    ast.With: ("`with`", "a block has no side effects; remove it"),
    ast.Raise: ("`raise`", "check parameters before the block is made"),
    ast.Assert: ("`assert`", "check parameters before the block is made"),
    ast.Global: ("`global`", "put the number into the block's parameters"),
    ast.Nonlocal: ("`nonlocal`", "put the number into the block's parameters"),
    ast.Import: ("`import`", "import at the top of the module"),
    ast.ImportFrom: ("`import`", "import at the top of the module"),
    ast.JoinedStr: ("a string", "a block computes numbers only"),
    ast.Dict: ("a dict", "put numbers into the block's parameters"),
    ast.Match: ("`match`", "use where(condition, a, b)"),
    ast.Yield: ("`yield`", "fill the output array"),
    ast.YieldFrom: ("`yield`", "fill the output array"),
    ast.Await: ("`await`", "a block has no side effects; remove it"),
    ast.Delete: ("`del`", "a block has no side effects; remove it"),
    ast.Not: ("`not`", "swap the two values of where"),
    ast.In: ("`in`", "compare numbers with <, <=, >, >=, =="),
    ast.NotIn: ("`not in`", "compare numbers with <, <=, >, >=, =="),
    ast.Is: ("`is`", "compare numbers with <, <=, >, >=, =="),
    ast.IsNot: ("`is not`", "compare numbers with <, <=, >, >=, =="),
    ast.List: ("a list", "put numbers into the block's parameters"),
    ast.Set: ("a set", "put numbers into the block's parameters"),
    ast.Break: ("`break`", "let the loop run and use where"),
    ast.Continue: ("`continue`", "let the loop run and use where"),
}

_CALLS = {
    "max": "maximum(a, b)",
    "min": "minimum(a, b)",
    "abs": "math.fabs(a)",
    "sum": "a `for i in range(n)` loop that adds",
    "round": "floor(a + 0.5)",
    "print": "an output port",
    "zip": "`for i in range(n)` and indices",
    "enumerate": "`for i in range(n)` and indices",
}


_passed: set = set()  # functions, with their code, that have been checked


@public
def opaque(function: Callable) -> Callable:
    """Mark a helper that SymPy reads as an undefined function.

    It is an undefined function of its arguments: theorems then hold for any
    function in its place.

    Parameters
    ----------
    function : callable
        A helper called by a block's equations.

    Returns
    -------
    callable
        The same function, marked.

    Examples
    --------
    >>> @opaque
    ... def gust(t):
    ...     return 0.1
    >>> gust.opaque
    True
    """
    function.opaque = True  # type: ignore[attr-defined]
    return function


def check_equations(function: Callable, role: str) -> None:
    """Refuse equations that cannot be recorded: `role`, line and replacement are named."""
    key = (function, getattr(function, "__code__", None))
    if key not in _passed:
        _check(function, role, set())
        _passed.add(key)


def _check(function: Callable, role: str, seen: set[Callable]) -> None:
    if function in seen:
        return
    seen.add(function)
    if not isinstance(function, FunctionType):
        raise BlockError(
            f"{role}: {shown(function)} is not a plain function; write `def f(t, x, u, p, out): "
            "...` at the top of a module"
        )
    if function.__code__.co_freevars:
        names = ", ".join(function.__code__.co_freevars)
        raise BlockError(
            f"{role}: {function.__name__} closes over {names}, which cannot be compiled, traced "
            "or pickled; put the values into the block's parameters"
        )
    for value in (*(function.__defaults__ or ()), *(function.__kwdefaults__ or {}).values()):
        if not isinstance(value, int | float):
            raise BlockError(
                f"{role}: {function.__name__} has a default argument that is a "
                f"{type(value).__name__}; only numbers can be, put it into the block's parameters"
            )
    tree, first_line = _syntax_tree(function)
    if tree is not None:
        _SourceCheck(function, role, first_line).visit(tree.body[0])
    for line, name in names_read(function):
        refused = _refused_name(function, name)
        if refused is not None:
            _refuse(role, line, *refused)
    for line, what, instead in effects(function):
        _refuse(role, line, what, instead)
    for name, helper in helpers_of(function).items():
        _check(helper, f"{role} -> {name}", seen)


def _syntax_tree(function: FunctionType) -> tuple[ast.Module | None, int]:
    """Return the parsed source and its first line; None where there is no source of its own."""
    try:
        lines, first = inspect.getsourcelines(function)
        tree = ast.parse(textwrap.dedent("".join(lines)))
    except (OSError, TypeError, SyntaxError):
        return None, 0
    own = tree.body[:1]
    known = own and isinstance(own[0], ast.FunctionDef) and own[0].name == function.__name__
    return (tree, first) if known else (None, 0)


class _SourceCheck(ast.NodeVisitor):
    """Walk a function's body and stop at the first thing not allowed."""

    def __init__(self, function: FunctionType, role: str, first_line: int):
        self.function, self.role, self.first_line = function, role, first_line
        self.local_names = set(function.__code__.co_varnames)

    def refuse(self, node: ast.AST, what: str, instead: str) -> None:
        _refuse(self.role, self.first_line + getattr(node, "lineno", 1) - 1, what, instead)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        if node.name != self.function.__name__ or node.lineno > 1 + len(node.decorator_list):
            self.refuse(node, *_REPLACEMENTS[ast.FunctionDef])
        first, *_ = node.body
        documented = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
        for statement in node.body[documented:]:
            self.visit(statement)

    def generic_visit(self, node: ast.AST) -> None:
        for part in (node, *getattr(node, "ops", ()), getattr(node, "op", None)):
            if type(part) in _REPLACEMENTS:
                self.refuse(node, *_REPLACEMENTS[type(part)])
        super().generic_visit(node)

    def visit_For(self, node: ast.For) -> None:
        call = node.iter
        if not (
            isinstance(call, ast.Call)
            and isinstance(call.func, ast.Name)
            and call.func.id == "range"
        ):
            self.refuse(node, "a loop over anything but range(...)", "use `for i in range(n)`")
        self.generic_visit(node)

    def visit_Compare(self, node: ast.Compare) -> None:
        if len(node.ops) > 1:
            self.refuse(node, "`a < b < c`", "nest where(...) for each condition")
        self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        if not isinstance(node.value, int | float):
            self.refuse(node, f"{node.value!r}", "a block computes numbers only")

    def visit_Attribute(self, node: ast.Attribute) -> None:
        module = isinstance(node.value, ast.Name) and self.function.__globals__.get(node.value.id)
        if module is math and node.attr not in MATH:
            instead = "use the word floor(a)" if node.attr == "floor" else "use arithmetic"
            self.refuse(
                node, f"`math.{node.attr}`", f"{instead} or one of {', '.join(sorted(MATH))}"
            )
        self.generic_visit(node)

    def visit_Call(self, node: ast.Call) -> None:
        if isinstance(node.func, ast.Attribute) and not (
            isinstance(node.func.value, ast.Name)
            and self.function.__globals__.get(node.func.value.id) is not None
        ):
            self.refuse(node, f"the method `{node.func.attr}`", "use a `for i in range(n)` loop")
        self.generic_visit(node)

    def visit_Name(self, node: ast.Name) -> None:
        if node.id in self.local_names or isinstance(node.ctx, ast.Store):
            return
        refused = _refused_name(self.function, node.id)
        if refused is not None:
            self.refuse(node, *refused)


def _refuse(role: str, line: int, what: str, instead: str) -> None:
    raise BlockError(f"{role}, line {line}: {what} is not allowed here; {instead}")


def _refused_name(function: FunctionType, name: str) -> tuple[str, str] | None:
    """Return why a name of the module is refused and what to use; None where it may be used."""
    space = function.__globals__
    if name not in space:
        if name in ALLOWED_BUILTINS:
            return None
        if name in _CALLS:
            return f"`{name}`", f"use {_CALLS[name]}"
        if not hasattr(builtins, name):
            return f"the unknown name `{name}`", "define it in the module"
        return f"`{name}`", "use arithmetic, math and the words of blocks.words"
    value = space[name]
    known = value is math or isinstance(value, int | float | FunctionType)
    if known or getattr(value, "__module__", None) == "math":
        return None
    return (
        f"`{name}` ({getattr(value, '__name__', type(value).__name__)})",
        "use arithmetic, math.*, and where, minimum, maximum, clip, sign, floor, lookup",
    )
