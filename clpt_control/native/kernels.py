"""Print the formulas of the method as LLVM's code, for all states: numbers are its t, Z its X."""

from collections.abc import Mapping
from typing import Any

from llvmlite import ir

from .formula import Formula
from .printing import Function, joined
from .vectors import Kind, Number, select


def print_formulas(formulas: Mapping[str, Formula], n: int, lanes: int) -> ir.Module:
    """Return a module of LLVM with formulas for n states, of 1 run or `LANES` side by side."""
    module = ir.Module()
    for name, formula in formulas.items():
        function = Function(module, name, lanes)
        sums = _each(function, formula, n) if formula.each is not None else []
        if formula.after is not None:
            found = formula.after(_rows(function, "t", function.one), sums)
            for r, value in found.items():
                function.store(function.one.number(value), "t", r)
        function.builder.ret_void()
    return module


def _rows(function: Function, array: str, kind: Kind) -> Any:
    """Return what reads a number of an array, each once."""
    found: dict[int, Number] = {}

    def row(r: int) -> Number:
        if r not in found:
            found[r] = kind.spread(function.load(array, r))
        return found[r]

    return row


def _each(function: Function, formula: Formula, n: int) -> list[Number]:
    """Print what is computed for each state; return what is summed over them."""
    wide = function.lanes == 1 and n > 2
    function.widen(n)
    kind = function.wide if wide else function.one

    def turn(place: Any, sums: list[Number]) -> list[Number]:
        found: dict[int, Number] = {}

        def z(r: int) -> Number:
            if r not in found:
                moves = [(place, 1)]
                found[r] = (
                    function.load_turns("X", r * n, moves, 1)
                    if wide
                    else function.load("X", r * n, moves)
                )
            return found[r]

        assert formula.each is not None
        own = _rows(function, "t", kind), _rows(function, "T", kind)
        rows, summed = formula.each(z, *own)
        for r, value in rows.items():
            if wide:
                function.store_turns(value, "X", r * n, [(place, 1)], 1)
            else:
                function.store(value, "X", r * n, [(place, 1)])
        if wide and function.turns < kind.width:
            summed = [select(function.valid(), value, 0.0) for value in summed]
        return [a + b for a, b in zip(sums, summed, strict=True)]

    zeros = [kind.number(0.0) for _ in range(formula.sums)]
    if not wide:
        return function.loop(range(n), 2, turn, zeros)
    return [joined(value, n) for value in function.rounds(n, 1, turn, zeros)]
