"""Equations altered in one place: a sign flipped, or, where asked, a term or a call dropped.

The code object is exchanged in place, so that every table and helper sees the altered equation.
"""

import ast
import inspect
import textwrap
from contextlib import contextmanager
from itertools import count, takewhile


class Alter(ast.NodeTransformer):
    """Alter the place numbered `which`."""

    def __init__(self, which, terms):
        self.left, self.terms = which, terms

    def mine(self):
        self.left -= 1
        return self.left == -1

    def visit(self, node):
        node = self.generic_visit(node)
        added = isinstance(getattr(node, "op", None), ast.Add | ast.Sub)
        if added and self.mine():  # of two, or to what is there
            node.op = ast.Sub() if isinstance(node.op, ast.Add) else ast.Add()
        if (
            isinstance(node, ast.UnaryOp)
            and isinstance(node.op, ast.USub)
            and self.mine()
        ):
            return node.operand
        if not self.terms:
            return node
        if isinstance(node, ast.BinOp) and added and self.mine():
            return node.left
        call = isinstance(node, ast.Expr) and isinstance(node.value, ast.Call)
        if (call or isinstance(node, ast.AugAssign)) and self.mine():
            return ast.Pass()
        return node


def altered(function, which, terms=False):
    """The code with one alteration, or None where there are fewer."""
    (lines, first), change, space = (
        inspect.getsourcelines(function),
        Alter(which, terms),
        {},
    )
    tree = change.visit(ast.parse(textwrap.dedent("".join(lines))))
    tree = ast.increment_lineno(ast.fix_missing_locations(tree), first - 1)
    exec(
        compile(tree, function.__code__.co_filename, "exec"),
        dict(function.__globals__),
        space,
    )
    return space[function.__name__].__code__ if change.left < 0 else None


def alterations(function, terms=False):
    """The code with each alteration."""
    return takewhile(bool, (altered(function, which, terms) for which in count()))


@contextmanager
def exchanged(function, code):
    """Run with other code of a function."""
    own, function.__code__ = function.__code__, code
    try:
        yield
    finally:
        function.__code__ = own
