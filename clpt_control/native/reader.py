"""Read a block's equations into flat code, as the fourth of its readers.

The function's syntax tree is walked with the block's whole numbers known, so
loops over axes unroll, slices of ports become places in one array of signals,
and helpers are put in where they are called.  What comes out are lines of
arithmetic over named numbers: no calls, no views, no copies.
"""

import ast
import builtins
import inspect
import math
import re
import textwrap
from functools import lru_cache
from types import FunctionType
from typing import Any

from ..blocks.words import MATH, WORDS
from ..errors import BlockError
from .values import Code, View, combined, text

OPERATORS: dict[type, str] = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/",
                              ast.Mod: "%", ast.FloorDiv: "//", ast.Pow: "**"}  # fmt: skip
COMPARISONS: dict[type, str] = {ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=",
                                ast.Eq: "==", ast.NotEq: "!="}  # fmt: skip
ALWAYS_UNROLLED = 4


class Unreadable(BlockError):
    """Equations the fuser cannot flatten; another engine runs them."""


def _loaded(target: ast.expr) -> ast.expr:
    """Give the target of `a += b` as an expression that is read."""
    return ast.parse(ast.unparse(target), mode="eval").body


@lru_cache(maxsize=1024)
def syntax_tree(function: FunctionType, code: Any) -> ast.FunctionDef:
    """Parse a function's source text, once for each code it has had."""
    try:
        source = textwrap.dedent(inspect.getsource(function))
    except (OSError, TypeError):
        raise Unreadable(f"{function.__name__}: its source text is not at hand") from None
    tree = ast.parse(source).body[0]
    assert isinstance(tree, ast.FunctionDef)
    return tree


class Prepared:
    """What depends on parameters alone, computed once a piece.

    Attributes
    ----------
    first : int
        First place in P.
    places : dict
        Expression -> its place, in order.
    """

    KNOWN = frozenset({"P", "T", "math", *WORDS, *MATH})

    def __init__(self, first: int):
        self.first = first
        self.places: dict[str, int] = {}

    def place(self, expression: str) -> int | None:
        """Give a place to an expression of P and T alone; None to others."""
        if not set(re.findall(r"[A-Za-z_]\w*", expression)) <= self.KNOWN:
            return None
        return self.places.setdefault(expression, self.first + len(self.places))

    def function(self) -> str:
        """Give the text of ``prepare(P, T)``."""
        lines = [f"    P[{place}] = {expression}" for expression, place in self.places.items()]
        return "\n".join(["def prepare(P, T):", *(lines or ["    pass"])])


class Lines:
    """Lines of code as they grow, with fresh names.

    Parameters
    ----------
    ready : Prepared
        Where expressions of parameters alone go.
    """

    def __init__(self, ready: Prepared) -> None:
        self.ready = ready
        self.lines: list[str] = []
        self.depth = 1
        self.count = 0
        self.loop_at = 0
        self.hoisted: dict[str, str] = {}

    def add(self, line: str) -> None:
        """Add a line at the current depth."""
        self.lines.append("    " * self.depth + line)

    def prepared(self, expression: str) -> Code:
        """Give a call's code, or where its steady value lies."""
        place = self.ready.place(expression)
        return Code(expression) if place is None else Code(self.steady(f"P[{place}]"))

    def open_loop(self, line: str) -> None:
        """Begin a loop; what does not change in it is read before it."""
        if self.depth == 1:
            self.loop_at, self.hoisted = len(self.lines), {}
        self.add(line)
        self.depth += 1

    def steady(self, expression: str) -> str:
        """Give a number that no loop changes, read before the loop."""
        if self.depth == 1:
            return expression
        if expression not in self.hoisted:
            name = self.fresh()
            self.lines.insert(self.loop_at, f"    {name} = {expression}")
            self.loop_at += 1
            self.hoisted[expression] = name
        return self.hoisted[expression]

    def fresh(self) -> str:
        """Give a name that is not used yet."""
        self.count += 1
        return f"v{self.count}"


class FunctionReader:
    """Walk one function with some of its values known.

    Parameters
    ----------
    lines : Lines
        Where code goes.
    unroll : int
        Loops of up to so many turns are unrolled.
    """

    def __init__(self, lines: Lines, unroll: int):
        self.lines, self.unroll = lines, unroll

    def run(self, function: FunctionType, arguments: list[Any]) -> Any:
        """Read a function with its arguments known; give what it returns."""
        tree = syntax_tree(function, function.__code__)
        names = [argument.arg for argument in tree.args.args]
        if len(names) != len(arguments):
            raise Unreadable(f"{function.__name__}: takes {len(names)} arguments")
        frame = _Frame(self, function, dict(zip(names, arguments, strict=True)))
        for statement in tree.body:
            if frame.statement(statement):
                return frame.result
        return None


class _Frame:
    """The names of one call while its body is read."""

    def __init__(self, reader: FunctionReader, function: FunctionType, names: dict[str, Any]):
        self.reader, self.function, self.names = reader, function, names
        self.kept: dict[str, str] = {}  # names that live through a running loop
        self.result: Any = None

    # --- statements ---------------------------------------------------------------------

    def statement(self, node: ast.stmt) -> bool:
        """Read a statement; True where it returns."""
        if isinstance(node, ast.Return):
            self.result = None if node.value is None else self.value(node.value)
            return True
        if isinstance(node, ast.Assign):
            value = self.value(node.value)
            for target in node.targets:
                self.assign(target, value)
        elif isinstance(node, ast.AugAssign):
            value = self.value(node.value)
            old = self.value(_loaded(node.target))
            self.assign(node.target, combined(old, self.operator(node.op), value))
        elif isinstance(node, ast.For):
            self.loop(node)
        elif isinstance(node, ast.Expr):
            if isinstance(node.value, ast.Call):
                self.value(node.value)
        elif not isinstance(node, ast.Pass):
            raise Unreadable(f"{self.function.__name__}: {type(node).__name__}")
        return False

    def assign(self, target: ast.expr, value: Any) -> None:
        if isinstance(target, ast.Tuple):
            for part, one in zip(target.elts, value, strict=True):
                self.assign(part, one)
        elif isinstance(target, ast.Name):
            self.names[target.id] = self.named(target.id, value)
        elif isinstance(target, ast.Subscript):
            view = self.value(target.value)
            view.write(combined(view.offset, "+", self.value(target.slice)), value)
        else:
            raise Unreadable(f"{self.function.__name__}: assignment to {type(target).__name__}")

    def named(self, name: str, value: Any) -> Any:
        """Give a computed value a name of its own, or its kept one."""
        lines = self.reader.lines
        if name in self.kept:
            lines.add(f"{self.kept[name]} = {text(value)}")
            return Code(self.kept[name])
        if isinstance(value, Code) and not value.simple:
            fresh = lines.fresh()
            lines.add(f"{fresh} = {value.text}")
            return Code(fresh)
        return value

    def loop(self, node: ast.For) -> None:
        assert isinstance(node.iter, ast.Call)
        assert isinstance(node.target, ast.Name)
        bounds = [self.value(argument) for argument in node.iter.args]
        if not all(isinstance(bound, int) for bound in bounds):
            raise Unreadable(f"{self.function.__name__}: a loop whose length is not known")
        turns = range(*bounds)
        if len(turns) <= max(self.reader.unroll, ALWAYS_UNROLLED):
            for turn in turns:
                self.names[node.target.id] = turn
                for statement in node.body:
                    self.statement(statement)
            return
        lines = self.reader.lines
        stored = {n.id for n in ast.walk(node) if isinstance(n, ast.Name)
                  and isinstance(n.ctx, ast.Store) and n.id in self.names}  # fmt: skip
        opened = {}
        for name in sorted(stored - set(self.kept) - {node.target.id}):
            if isinstance(self.names[name], View):
                continue
            fresh = lines.fresh()
            lines.add(f"{fresh} = {text(self.names[name])}")
            opened[name] = fresh
            self.names[name] = Code(fresh)
        self.kept.update(opened)
        counter = lines.fresh()
        self.names[node.target.id] = Code(counter)
        lines.open_loop(f"for {counter} in range({', '.join(map(str, bounds))}):")
        for statement in node.body:
            self.statement(statement)
        lines.depth -= 1
        for name in opened:
            del self.kept[name]

    # --- expressions --------------------------------------------------------------------

    def operator(self, node: ast.operator) -> str:
        return OPERATORS[type(node)]

    def value(self, node: ast.expr) -> Any:
        """Give the value of an expression."""
        name = f"on_{type(node).__name__}"
        if not hasattr(self, name):
            raise Unreadable(f"{self.function.__name__}: {type(node).__name__}")
        return getattr(self, name)(node)

    def on_Constant(self, node: ast.Constant) -> Any:
        return node.value

    def on_Name(self, node: ast.Name) -> Any:
        if node.id in self.names:
            return self.names[node.id]
        space = self.function.__globals__
        return space[node.id] if node.id in space else getattr(builtins, node.id)

    def on_Tuple(self, node: ast.Tuple) -> Any:
        return tuple(self.value(part) for part in node.elts)

    def on_UnaryOp(self, node: ast.UnaryOp) -> Any:
        value = self.value(node.operand)
        if isinstance(node.op, ast.UAdd):
            return value
        return Code(f"(-{text(value)})") if isinstance(value, Code) else -value

    def on_BinOp(self, node: ast.BinOp) -> Any:
        a, b, operator = self.value(node.left), self.value(node.right), self.operator(node.op)
        if operator == "**" and isinstance(b, int) and isinstance(a, Code) and 1 <= b <= 4:
            a = self.named("", a)
            power = a
            for _ in range(b - 1):
                power = combined(power, "*", a)
            return power
        return combined(a, operator, b)

    def on_Compare(self, node: ast.Compare) -> Any:
        a, b = self.value(node.left), self.value(node.comparators[0])
        return Code(f"({text(a)} {COMPARISONS[type(node.ops[0])]} {text(b)})")

    def on_Attribute(self, node: ast.Attribute) -> Any:
        owner = self.value(node.value)
        return getattr(owner, node.attr)

    def on_Subscript(self, node: ast.Subscript) -> Any:
        view = self.value(node.value)
        if not isinstance(view, View):
            raise Unreadable(f"{self.function.__name__}: only arrays are indexed")
        if isinstance(node.slice, ast.Slice):
            start = 0 if node.slice.lower is None else self.value(node.slice.lower)
            stop = view.size if node.slice.upper is None else self.value(node.slice.upper)
            if not (isinstance(start, int) and isinstance(stop, int)):
                raise Unreadable(f"{self.function.__name__}: a slice whose ends are not known")
            start, stop, _ = slice(start, stop).indices(view.size)
            return view.sliced(start, stop)
        index = self.value(node.slice)
        if isinstance(index, tuple):
            flat: Any = 0
            for size, one in zip(view.shape, index, strict=True):
                flat = combined(combined(flat, "*", size), "+", one)
            index = flat
        if isinstance(index, int) and not -view.size <= index < view.size:
            raise Unreadable(f"{self.function.__name__}: index {index} of {view.size}")
        if isinstance(index, int) and index < 0:
            index += view.size
        return view.read(combined(view.offset, "+", index))

    def on_Call(self, node: ast.Call) -> Any:
        function: Any = self.value(node.func)
        if function is len:
            return self.value(node.args[0]).size
        arguments = [self.value(argument) for argument in node.args]
        name = getattr(function, "__name__", "")
        if WORDS.get(name) is function:
            if name == "lookup":
                array, offset = arguments[0].table
                index = text(combined(offset, "+", arguments[1]))
                return self.reader.lines.prepared(f"lookup({array}, {index})")
            if not any(isinstance(argument, Code) for argument in arguments):
                return WORDS[name](*arguments)
            return self.reader.lines.prepared(f"{name}({', '.join(map(text, arguments))})")
        if getattr(function, "__module__", None) == "math" or getattr(math, name, None) is function:
            if not any(isinstance(argument, Code) for argument in arguments):
                return getattr(math, name)(*arguments)
            called = f"math.{name}({', '.join(map(text, arguments))})"
            return self.reader.lines.prepared(called)
        if function in (float, int) and isinstance(arguments[0], Code):
            return Code(f"{name}({arguments[0].text})")
        if isinstance(function, FunctionType):
            return self.reader.run(function, [self.named("", a) if isinstance(a, Code) else a
                                              for a in arguments])  # fmt: skip
        raise Unreadable(f"{self.function.__name__}: a call of {name or function}")
