"""Formulas of a method as machine code, for a number of states and of lanes."""

from types import SimpleNamespace
from typing import Any

import numpy as np

from ..codegen.fused_expressions import Components
from ..codegen.machine import Machine, once
from ..codegen.plan import Planner, Program
from ..codegen.switching_conditions import Port
from ..methods.formulas import Formula, StepTape
from ..methods.method import Method
from ..trace.arrays import operand
from .callee import Callee


def program_of_formulas(formulas: dict[str, Formula], n: int) -> Program:
    """Return the program of formulas for n states."""
    step = StepTape(n)
    components = Components(SimpleNamespace(entries=step.tape.operations), 0)
    writes = {}
    for name, formula in formulas.items():
        rows, numbers = formula(step)
        in_rows = [
            Port(row * n, (n,), (True,), operand(value)) for row, value in rows.items()
        ]
        in_lane = [Port(row, (), (), operand(value)) for row, value in numbers.items()]
        writes[name] = components.writes(in_rows, "X")
        writes[name] += components.writes(in_lane, "t")
    planner = Planner(components)
    # loops come first: they read numbers of the lane, which are written behind them
    functions = {
        name: tuple(sorted(planner.nests(written), key=lambda nest: not nest.lengths))
        for name, written in writes.items()
    }
    return Program(tuple(components.all), functions, {}, (), 0, 0, 0, ())


@once(16)
def kernels(n: int, lanes: int, method: Method) -> Machine:
    """Return the formulas of a method for n states as machine code."""
    named = method.formulas()

    def module() -> Any:
        from ..codegen.llvm_text import print_program  # unless it is cached

        return print_program(program_of_formulas(named, n), tuple(named), lanes)

    return Machine(named, f"formulas {n} {lanes} {method.name}", module, plain=True)


def with_formulas(callee: Callee) -> Callee:
    """Return a callee with the formulas of its method behind the diagram's functions."""
    addresses: list[int] = [*callee.functions]
    machine = None
    if callee.nstates:
        machine = kernels(callee.nstates, callee.lanes, callee.method)
        addresses += machine.addresses.values()
    functions = np.array(addresses, dtype=np.int64)
    return callee._replace(functions=functions, code=(*callee.code, machine))
