"""Rewritten functions: `if` statements and conditional expressions become functions of their own.

    if a > 1:                       def __statement__():
        y = 2.0               ->        nonlocal y
    else:                               if a > 1: ...
        y = a                       __merge_paths__(__statement__)

`execution_paths` runs such a function on each of its paths and merges them, so a loop over six
limits takes 12 paths and not 2^6.  ``row[k]`` of a list and a signal k becomes one `pick`.  The
source is used only if it compiles to the very code of the function; else the function stays as it
is, and all its paths are run.

Python calls no method of a value for `is`: ``a is b`` and ``case True`` become calls of `is_same`.
A signal is no constant, such as None, and is True or False only if it is a truth value of Python's
own.  Whether two numbers are one object is not recorded, so such a comparison is refused.
"""

import ast
import copy
import dis
import functools
import linecache
from collections.abc import Iterator
from types import CodeType
from typing import Any

from ..record.unread import STATEMENT, Unread, active
from .arrays import Array
from .elementwise import definite
from .execution_paths import index_of, item_of, merge_calls, merge_paths
from .references import all_code, code_names

# --- identity of traced values -----------------------------------------------------------------

# constants that merged paths replace
COPIED = (int, float, complex, str, bytes, tuple, frozenset)


def is_same(a: Any, b: Any) -> bool:
    """Return `a is b`."""
    tape = active()
    if tape is None:
        return a is b
    for value, counterpart in ((a, b), (b, a)):
        if isinstance(value, Array):
            if isinstance(counterpart, bool):
                is_truth = value._is_condition and not value.shape
                return (
                    is_truth
                    and definite(value._of_python)
                    and bool(value) is counterpart
                )
            if isinstance(counterpart, Array | float | int):
                raise Unread("compares signals by `is`. Write ==")
            return False
    if tape.merging and type(a) in COPIED and type(b) in COPIED:
        raise Unread("compares constants by `is`. Write ==")
    return a is b


class Truth:
    """True or False as a pattern of `match`, which is equal to the object itself alone."""

    __array_ufunc__ = None  # NumPy's values leave the comparison to this class

    def __init__(self, truth: bool):
        self.truth = truth
        self.value = self

    def __eq__(self, other: object) -> bool:
        return is_same(other, self.truth)


TRUTHS = {truth: Truth(truth) for truth in (True, False)}


# --- rewriting ---------------------------------------------------------------------------------

NAMES = {
    "__merge_paths__": merge_paths,
    "__merge_calls__": merge_calls,
    "__item_of__": item_of,
    "__index_of__": index_of,
    "__is_same__": is_same,
    "__true__": TRUTHS[True],
    "__false__": TRUTHS[False],
}
LEAVING = (
    ast.Return,
    ast.Yield,
    ast.YieldFrom,
    ast.Await,
    ast.Global,
    ast.Nonlocal,
    ast.Delete,
)
# names by which code reads its own frame, or catches what only a function's own frame raises
FRAMES = {"super", "locals", "vars", "dir", "eval", "exec", "__class__"} | {
    "UnboundLocalError"
}
SCOPES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)
NAMING = (*SCOPES[:2], ast.ClassDef, ast.ExceptHandler, ast.MatchAs, ast.MatchStar)
SELF_MATCHING = (
    "float",
    "int",
    "bool",
)  # classes of which `case float(q)` names the number
FUTURE = 0x1FF0000  # flags of `from __future__ import ...`


@functools.lru_cache(maxsize=4096)
def rewritten(code: CodeType) -> CodeType:
    """Return the rewritten code of a function, or its own code if nothing changes."""
    if not _may_branch(code):
        return code
    for k, statement in enumerate(_statements_of(code.co_filename)):
        nodes = [statement, *getattr(statement, "decorator_list", [])]
        first_line = min(node.lineno for node in nodes)
        if first_line <= code.co_firstlineno <= (statement.end_lineno or 0):
            return _replacement(code, k)
    return code


def _replacement(code: CodeType, number: int) -> CodeType:
    """Return the rewritten code of a function in a statement, or its own code."""
    originals, rewritten_codes = _compiled(
        code.co_filename, number, code.co_flags & FUTURE
    )
    if code not in originals:
        return code
    new = rewritten_codes.get(_position(code), code)
    has_variables = new.co_freevars == code.co_freevars
    return new if has_variables and new.co_argcount == code.co_argcount else code


def _may_branch(code: CodeType) -> bool:
    """Return whether code has conditions, or indices that are not constants."""
    for inner in all_code(code):
        constant = False
        for line in dis.get_instructions(inner):
            index = line.opname == "BINARY_SUBSCR" or line.argrepr == "[]"
            jumps = "JUMP" in line.opname and "IF" in line.opname
            rewrites = line.opname in ("PUSH_EXC_INFO", "IS_OP")
            if jumps or rewrites or (index and not constant):
                return True
            constant = line.opname in ("LOAD_CONST", "LOAD_SMALL_INT")
    return "index" in code_names(code)


@functools.lru_cache(maxsize=256)
def _statements_of(file: str) -> list[ast.stmt]:
    """Return the statements of a file; none if there is no source."""
    try:
        return ast.parse("".join(linecache.getlines(file))).body
    except (SyntaxError, ValueError, RecursionError):
        return []


@functools.lru_cache(maxsize=256)
def _compiled(file: str, number: int, flags: int) -> tuple[frozenset[CodeType], dict]:
    """Return the code of the functions in a statement of a file, and rewritten by position."""
    statements = _statements_of(file)
    # Python compiles `np.sin(x)` otherwise if the file imports np
    nodes = (node for item in statements for node in _within(item))
    imports = [item for item in nodes if isinstance(item, ast.Import | ast.ImportFrom)]

    def compiled(statement: Any) -> CodeType:
        module = ast.fix_missing_locations(ast.Module([*imports, statement], []))
        return compile(module, file, "exec", flags, dont_inherit=True)

    original = compiled(statements[number])
    new = compiled(_Rewriter().visit(copy.deepcopy(statements[number])))
    by_position: dict[Any, CodeType] = {}
    for code in all_code(new):
        by_position.setdefault(_position(code), code)  # the outer one comes first
    return frozenset(all_code(original)), by_position


def _position(code: CodeType) -> Any:
    """Return the name and line of a function, and the column of a lambda."""
    starts = ((line, column) for line, _, column, _ in code.co_positions())
    positions = [(line, column) for line, column in starts if line and column]
    is_lambda = code.co_name.startswith("<")
    column = min(positions, default=None) if is_lambda else None
    return code.co_name, code.co_firstlineno, column


class _Rewriter(ast.NodeTransformer):
    """Rewrites functions."""

    function: Any = None  # the names of the function that is rewritten; None outside

    def _within(self, function: Any, node: ast.AST) -> Any:
        """Return a function, lambda or class, rewritten inside."""
        outer = self.function
        self.function = function
        self.generic_visit(node)
        self.function = outer
        return node

    def visit_FunctionDef(self, node: ast.FunctionDef) -> Any:
        """Rewrite a function; the paths of one within another are merged when it ends."""
        if self.function is not None:
            decorator = ast.Name("__merge_calls__", ast.Load())
            node.decorator_list.append(ast.copy_location(decorator, node))
        return self._within(_Function(node), node)

    def visit_Lambda(self, node: ast.Lambda) -> Any:
        """Rewrite the expression of a lambda."""
        return self._within(_Function(node), node)

    def visit_ClassDef(self, node: ast.ClassDef) -> Any:
        """Rewrite the methods of a class, and leave its own statements."""
        return self._within(None, node)

    # --- statements -------------------------------------------------------------------------

    def visit_If(self, node: ast.If | ast.Try | ast.Match) -> Any:
        """Make a statement a function whose paths are merged."""
        stored = _stored(node)
        if self.function is None or not self._is_separable(node, stored):
            return self.generic_visit(node)
        self.generic_visit(node)
        binding = f"if 0: {' = '.join(stored)} = 0" if stored else "pass"  # never runs
        declaration = f"nonlocal {', '.join(stored)}" if stored else "pass"
        source = f"""\
{binding}
def {STATEMENT}():
    {declaration}
__merge_paths__({STATEMENT})
"""
        new: Any = ast.parse(source).body
        for statement in new:
            _place_at(statement, node)
        new[1].body.append(node)
        return new

    visit_Try = visit_If
    visit_Match = visit_If

    def _is_separable(self, statement: ast.stmt, stored: list[str]) -> bool:
        """Return whether a statement may be a function of its own."""
        if self.function.has_frames or not self.function.locals.issuperset(stored):
            return False
        for inner in _within(statement):
            if isinstance(inner, LEAVING) or (
                isinstance(inner, ast.Name) and inner.id in FRAMES
            ):
                return False
            if isinstance(inner, ast.Raise) and not isinstance(statement, ast.Try):
                return False
        return not _leaves_loop(statement)

    # --- expressions ------------------------------------------------------------------------

    def visit_IfExp(self, node: ast.IfExp | ast.BoolOp) -> ast.expr:
        """Make a conditional expression, `and` or `or` a function whose paths are merged."""
        self.generic_visit(node)
        walked = {type(inner) for inner in ast.walk(node)}
        if self.function is None or walked & {
            ast.NamedExpr,
            ast.Await,
            ast.Yield,
            ast.YieldFrom,
        }:
            return node
        function = _place_at(ast.parse("lambda: 0", mode="eval").body, node)
        function.body = node
        return self._call("__merge_paths__", node, [function])

    visit_BoolOp = visit_IfExp

    def visit_Subscript(self, node: ast.Subscript) -> Any:
        """Read items by a function, which takes signals as indices of lists."""
        self.generic_visit(node)
        if self.function is None or not isinstance(node.ctx, ast.Load):
            return node
        row = node.value
        if isinstance(row, ast.Call) and getattr(row.func, "id", "") == "__item_of__":
            row.args.append(
                _place_at(ast.Constant(True), node)
            )  # nothing writes into it
        if isinstance(node.slice, ast.Constant | ast.Slice | ast.Tuple | ast.UnaryOp):
            return node
        return self._call("__item_of__", node, [node.value, node.slice])

    def visit_Compare(self, node: ast.Compare) -> Any:
        """Compare identities by a function, which knows signals."""
        self.generic_visit(node)
        operator, *further = node.ops
        is_identity = isinstance(operator, ast.Is | ast.IsNot) and not further
        if self.function is None or not is_identity:
            return node
        (comparator,) = node.comparators
        if isinstance(comparator, ast.Constant) and comparator.value is None:
            return node
        identity = self._call("__is_same__", node, [node.left, comparator])
        if isinstance(operator, ast.Is):
            return identity
        return ast.copy_location(ast.UnaryOp(ast.Not(), identity), node)

    # --- patterns ---------------------------------------------------------------------------

    def visit_MatchSingleton(self, node: ast.MatchSingleton) -> Any:
        """Compare with True and False by objects that know signals."""
        if node.value is None:
            return node
        name = f"__{str(node.value).lower()}__"
        value = ast.parse(f"{name}.value", mode="eval").body
        return _place_at(ast.MatchValue(value), node)

    def visit_MatchClass(self, node: ast.MatchClass) -> Any:
        """Write `case float(q)` as `case float() as q`, which a tracer type has too."""
        self.generic_visit(node)
        if getattr(node.cls, "id", "") in SELF_MATCHING and len(node.patterns) == 1:
            (pattern,) = node.patterns
            if isinstance(pattern, ast.MatchAs) and pattern.pattern is None:
                node.patterns = []
                return ast.copy_location(ast.MatchAs(node, pattern.name), node)
        return node

    def visit_Call(self, node: ast.Call) -> Any:
        """Find values in lists by a function, which takes signals."""
        self.generic_visit(node)
        plain = isinstance(node.func, ast.Attribute) and node.func.attr == "index"
        if self.function is None or not plain or len(node.args) != 1 or node.keywords:
            return node
        return self._call("__index_of__", node, [node.func.value, *node.args])  # type: ignore

    def _call(self, name: str, node: ast.expr, arguments: list[ast.expr]) -> ast.expr:
        call = _place_at(ast.parse(f"{name}()", mode="eval").body, node)
        call.args = arguments
        return call


class _Function:
    """The local variables of a function, and whether its frame may be left and entered again."""

    def __init__(self, node):
        children = ast.iter_child_nodes(node.args)
        arguments = {item.arg for item in children if isinstance(item, ast.arg)}
        body = node.body if isinstance(node.body, list) else [node.body]
        inner = [item for statement in body for item in _within(statement)]
        self.locals = arguments.union(*map(_stored, body))
        declared = [
            item for item in inner if isinstance(item, ast.Global | ast.Nonlocal)
        ]
        self.locals -= {name for item in declared for name in item.names}
        self.has_frames = any(
            isinstance(item, ast.Yield | ast.YieldFrom | ast.Await) for item in inner
        )


def _within(statement: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes of a statement, but not of functions in it or variables of comprehensions."""
    yield statement
    if not isinstance(statement, SCOPES):
        for child in ast.iter_child_nodes(statement):
            if not (
                isinstance(statement, ast.comprehension) and child is statement.target
            ):
                yield from _within(child)


def _stored(statement: ast.AST) -> list[str]:
    """Return the variables that a statement sets."""
    names: dict[Any, None] = {}
    for node in _within(statement):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            names[node.id] = None
        elif isinstance(node, NAMING):
            names[node.name] = None
        elif isinstance(node, ast.MatchMapping):
            names[node.rest] = None
        elif isinstance(node, ast.alias):
            names[(node.asname or node.name).partition(".")[0]] = None
    names.pop(None, None)
    return [*names]


def _leaves_loop(statement: ast.AST) -> bool:
    """Return whether a statement has a `break` or `continue` of a loop around it."""
    if isinstance(statement, ast.Break | ast.Continue):
        return True
    if isinstance(statement, (ast.For, ast.While, *SCOPES)):
        return False
    return any(map(_leaves_loop, ast.iter_child_nodes(statement)))


def _place_at(new: Any, old: ast.AST) -> Any:
    """Return new nodes at the position of an old node in the source."""
    for node in ast.walk(new):
        ast.copy_location(node, old)
    return new
