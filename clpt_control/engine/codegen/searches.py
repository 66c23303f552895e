"""Places in a row of numbers as LLVM's functions: bisection, and the least number.

search(row, stride, count, value, right)    how many numbers of a sorted row are below a value,
                                            or equal to it if `right`; 0 for NaN
argmin(row, stride, count)                  the first place of the least; that of the first NaN
"""

from collections.abc import Callable
from typing import Any

from llvmlite import ir

from .vectors import DOUBLE, WORD

ROW = (DOUBLE.as_pointer(), WORD, WORD)


def _function(module: ir.Module, name: str, arguments: tuple[ir.Type, ...]) -> tuple[Any, bool]:
    """Return a function of the module, and whether it is still to be written."""
    if name in module.globals:
        return module.globals[name], False
    function = ir.Function(module, ir.FunctionType(DOUBLE, arguments), name)
    function.linkage = "internal"
    return function, True


def _number_at(builder: ir.IRBuilder, row: Any, stride: Any, position: Any) -> Any:
    return builder.load(builder.gep(row, [builder.mul(position, stride)]))


def search(module: ir.Module) -> Any:
    """Return the function that bisects a sorted row."""
    function, is_new = _function(module, "search", (*ROW, DOUBLE, DOUBLE))
    if not is_new:
        return function
    row, stride, count, value, counts_equal = function.args
    entry, loop, body, end = (function.append_basic_block() for _ in range(4))
    builder = ir.IRBuilder(entry)
    also_equal = builder.fcmp_ordered(">", counts_equal, ir.Constant(DOUBLE, 0.5))
    builder.branch(loop)
    builder.position_at_end(loop)
    # the place is from low to high
    low = builder.phi(WORD)
    high = builder.phi(WORD)
    low.add_incoming(ir.Constant(WORD, 0), entry)
    high.add_incoming(count, entry)
    builder.cbranch(builder.icmp_signed("<", low, high), body, end)
    builder.position_at_end(body)
    middle = builder.lshr(builder.add(low, high), ir.Constant(WORD, 1))
    number = _number_at(builder, row, stride, middle)
    equal = builder.and_(also_equal, builder.fcmp_ordered("==", number, value))
    below = builder.or_(builder.fcmp_ordered("<", number, value), equal)
    after = builder.add(middle, ir.Constant(WORD, 1))
    low.add_incoming(builder.select(below, after, low), body)
    high.add_incoming(builder.select(below, high, middle), body)
    builder.branch(loop)
    builder.position_at_end(end)
    builder.ret(builder.sitofp(low, DOUBLE))
    return function


def argmin(module: ir.Module) -> Any:
    """Return the function that finds the least number of a row."""
    function, is_new = _function(module, "argmin", ROW)
    if not is_new:
        return function
    row, stride, count = function.args
    entry, body, end = (function.append_basic_block() for _ in range(3))
    builder = ir.IRBuilder(entry)
    first = builder.load(row)
    builder.branch(body)
    builder.position_at_end(body)
    position = builder.phi(WORD)
    best = builder.phi(WORD)
    least = builder.phi(DOUBLE)
    for value, start in ((position, 0), (best, 0)):
        value.add_incoming(ir.Constant(WORD, start), entry)
    least.add_incoming(first, entry)
    number = _number_at(builder, row, stride, position)
    is_number = builder.fcmp_ordered("ord", least, least)  # a NaN stays the least
    better = builder.and_(is_number, builder.fcmp_unordered("<", number, least))
    new_best, new_least = (
        builder.select(better, *pair) for pair in ((position, best), (number, least))
    )
    following = builder.add(position, ir.Constant(WORD, 1))
    position.add_incoming(following, body)
    best.add_incoming(new_best, body)
    least.add_incoming(new_least, body)
    builder.cbranch(builder.icmp_signed("<", following, count), body, end)
    builder.position_at_end(end)
    builder.ret(builder.sitofp(new_best, DOUBLE))
    return function


SEARCHES: dict[str, Callable[[ir.Module], Any]] = {"search": search, "argmin": argmin}
