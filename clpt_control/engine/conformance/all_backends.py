"""Every reading of a diagram by name, a function of a point.

    python      the blocks in Python, one pass in the order of the wiring
    control     python-control's own evaluation of the diagram
    native      machine code, as it runs
    scalar      machine code, all axes unrolled
    looped      machine code, all axes in loops
    lanes       machine code, one of eight runs side by side
    symbolic    SymPy's expressions, block by block; opaque blocks stand for themselves

All of them are made from the same functions; they agree, or one refuses with a
sentence.  Each also reads the jumps of states, but python-control, which knows none.

SymPy's expressions are called with numbers; what is long is a symbol of its own.
"""

import ctypes
from collections.abc import Callable, Mapping
from functools import cache
from math import copysign, isfinite, prod
from typing import Any, NamedTuple

import control
import numpy as np
import sympy

from ...arguments import public
from ...errors import BlockError, DiagramError
from ..codegen.machine import LANES
from ..model.block import Block
from ..model.vectorized import leaf_values
from ..record import graph as numbers
from ..record.graph import Shape
from ..record.scalar_graph import Index
from ..record.symbolic import ON_NUMBERS, Symbols
from ..solver.evaluation_pass import Sweep
from ..solver.native_diagram import NativeDiagram
from ..solver.runner import PythonDiagram
from ..solver.schedule import JUMPS
from ..trace.arrays import Unread

Values = tuple[np.ndarray, np.ndarray]  # state derivative and outputs


class Reading(NamedTuple):
    """One reading of a diagram."""

    evaluate: Callable[[float, Any, Any], Values]  # at (t, x, u)
    jump: Callable[[float, Any, Any], np.ndarray]  # states where every block that can has jumped

    def __call__(self, t: float, x: Any, u: Any) -> Values:
        """Return state derivative and outputs."""
        return self.evaluate(t, x, u)


@public
def readings(
    diagram: control.NonlinearIOSystem, params: Mapping[str, Any] | None = None
) -> dict[str, Reading]:
    """Return every reading of a diagram, as a function of a point.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        A block, or blocks and other systems, wired.
    params : mapping, optional
        Call-time parameters by qualified name.

    Returns
    -------
    dict
        Name -> ``function(t, x, u)``, which returns the state derivative and
        the diagram's outputs; ``function.jump(t, x, u)`` the states right
        after all blocks that can jump do.  What cannot be read raises a ClptError.

    Raises
    ------
    DiagramError
        If the diagram itself cannot be read.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.clpe import clpe
    >>> for name, ask in clpt.conformance.readings(clpe()).items():
    ...     print(name, ask(0.0, [], [3.0, 2.0, 1.0, 1.0])[1])
    python [2. 1.]
    control [2. 1.]
    native [2. 1.]
    scalar [2. 1.]
    looped [2. 1.]
    lanes [2. 1.]
    symbolic [2. 1.]
    """
    sweep = PythonDiagram(diagram, params).sweep

    def by_control(t: float, x: Any, u: Any) -> Values:
        arguments = (t, np.asarray(x, dtype=float), np.asarray(u, dtype=float), params)
        return np.asarray(diagram.dynamics(*arguments)), np.asarray(diagram.output(*arguments))

    def no_jump(t: float, x: Any, u: Any) -> np.ndarray:
        raise DiagramError("python-control knows no jumps of states; clpt.simulate runs them")

    return {
        "python": _in_sweep(sweep),
        "control": Reading(by_control, no_jump),
        "native": _by_machine(diagram, params, None, 1),
        "scalar": _by_machine(diagram, params, "unrolled", 1),
        "looped": _by_machine(diagram, params, "looped", 1),
        "lanes": _by_machine(diagram, params, None, LANES),
        "symbolic": _in_sweep(_SymbolicSweep(sweep.wiring, sweep.parameters)),
    }


def _in_sweep(sweep: Sweep) -> Reading:
    def evaluate(t: float, x: Any, u: Any) -> Values:
        sweep.enter(t)
        return sweep.derivative(t, x, u), sweep.outputs()

    def jump(t: float, x: Any, u: Any) -> np.ndarray:
        sweep.enter(t)
        return sweep.jump(t, x, u, sweep.jumping)

    return Reading(evaluate, jump)


def _by_machine(diagram: Any, params: Any, form: str | None, lanes: int) -> Reading:
    """Return a reading of machine code; of several lanes the last, the others are elsewhere."""

    @cache
    def compiled() -> tuple[NativeDiagram, tuple[np.ndarray, ...]]:
        native = NativeDiagram(diagram, params, form)
        program, n = native.code.program, native.nstates
        sizes = n, program.parameters, program.room, max(n, 3 * program.decided)
        X, P, W, D = (np.zeros((max(size, 1), lanes)) for size in sizes)
        return native, (np.zeros(lanes), X, P, np.append(native.layout.T, 0.0), W, D)

    def run(t: float, x: Any, u: Any, *functions: str) -> Values:
        native, arrays = compiled()
        decided_at, decided = native.decided_at, native.code.program.decided
        first = ("prepare", "decide") if decided else ()
        x, u = np.asarray(x, dtype=float), np.asarray(u, dtype=float)
        time, X, P, _, W, D = arrays
        lane, n, m = lanes - 1, native.nstates, native.wiring.ninputs
        p = native.parameters()
        p[native.ramp : native.ramp + 1 + 2 * m] = [t, *u, *np.zeros(m)]
        for k, place in native.layout.intervals.items():
            block, parameters = native.wiring.nodes[k].system, native.sweep.parameters[k]
            p[place] = block.parameters_at(t, parameters).interval
        p[list(native.layout.jumps.values())] = JUMPS
        for k in range(lanes):
            elsewhere = 1.0 + 0.1 * (lane - k)
            time[k], X[:n, k], P[: len(p), k] = t, x * elsewhere, p
        names = (*first, "prepare", *functions)
        for name, address in zip(names, native.code.addresses(names, lanes), strict=True):
            function = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 6)(int(address))
            function(*(array.ctypes.data for array in arrays))
            if name == "decide":
                P[decided_at : decided_at + decided] = D[:decided]
        signals = W[: native.nsignals, lane]
        return D[:n, lane].copy(), native.wiring.output_map @ np.concatenate([signals, u])

    def jump(t: float, x: Any, u: Any) -> np.ndarray:
        if not compiled()[0].layout.jumps:
            return np.array(x, dtype=float)
        return run(t, x, u, "jump")[0]

    return Reading(lambda t, x, u: run(t, x, u, "derivative", "signals"), jump)


class _SymbolicSweep(Sweep):
    """A pass over the diagram by SymPy's expressions."""

    def __init__(self, *arguments: Any):
        super().__init__(*arguments)
        self._functions: dict[tuple[int, str], SymbolicFunction] = {}

    def _call(self, role: str, k: int, t: float, x: np.ndarray, u: np.ndarray, out: Any) -> None:
        block = self.nodes[k].system
        if block.opaque:
            super()._call(role, k, t, x, u, out)
            return
        if (k, role) not in self._functions:
            self._functions[k, role] = SymbolicFunction(block, role)
        out[:] = self._functions[k, role](leaf_values(block, t, x, u, self._current[k]))


# --- SymPy's expressions on numbers ------------------------------------------------------------


LONG = 20  # operations; a longer expression is a symbol of its own
MOST = 20_000  # operations on single numbers; SymPy takes a thousandth of a second for each
# what loses its digits, or its range, written out: log1p(a) as log(1 + a)
PRECISE = {name: sympy.Function(f"{name}_", real=True) for name in ("hypot", "log1p", "expm1")}
NAMES: dict[str, Callable[..., Any]] = {
    **ON_NUMBERS,
    **{f"{name}_": numbers.OPERATIONS[name] for name in PRECISE},
    **{name: numbers.OPERATIONS[name] for name in ("sin", "cos", "tan")},  # NaN beyond MOST_ANGLE
}


class SymbolicFunction(Symbols):
    """A block's equations as SymPy's expressions; what is long is a symbol of its own."""

    def __init__(self, block: Block, role: str):
        try:
            record = block.array_record(role)
        except Unread as error:
            raise BlockError(str(error)) from None
        super().__init__(record.operations, self._leaf, sizes=block.sizes)
        made = [o for o in record.operations if o.kind not in ("leaf", "constant", "view")]
        if sum(prod(numbers.bound(o.shape, self.sizes)) for o in made) > MOST:
            raise BlockError(
                f"{block.name}.{role} takes more than {MOST} operations on single numbers, for "
                "which SymPy needs minutes; ask it at a smaller size"
            )
        self.leaves: dict[tuple, sympy.Symbol] = {}
        self.steps: list[tuple[sympy.Symbol, sympy.Expr]] = []
        values = self.outputs(record)
        for value in (*values, *(value for _, value in self.steps)):
            if value.has(sympy.zoo, sympy.nan, sympy.I):
                raise BlockError(f"SymPy finds that the equations divide by zero: {value}")
        self._compiled = sympy.lambdify(
            list(self.leaves.values()),
            values,
            [NAMES, "scipy", "numpy"],
            cse=lambda expressions: (self.steps, expressions),
        )

    def _symbol(self, *key: Any) -> sympy.Symbol:
        return self.leaves.setdefault(key, sympy.Symbol(f"leaf{len(self.leaves)}", real=True))

    def _leaf(self, at: tuple[str, str], shape: Shape, index: Index) -> Any:
        return self._symbol(*at, index)

    def number(self, value: float) -> Any:
        """Return a number; what SymPy would make more of is a symbol, as 0 * x."""
        known = value and isfinite(value)
        return sympy.Float(value) if known else self._symbol("", value, copysign(1.0, value))

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Return what SymPy makes of an operation, as a symbol where it is long."""
        if kind in PRECISE:
            return self._step(PRECISE[kind](*arguments))
        if kind == "pow" and arguments[1] in (2.0, 3.0, 4.0):
            arguments = arguments[0], sympy.Integer(arguments[1])
        return self._step(super().apply(ref, kind, arguments))

    def _step(self, value: Any) -> Any:
        if not isinstance(value, sympy.Expr) or value.count_ops() < LONG:
            return value
        symbol = sympy.Symbol(f"step{len(self.steps)}", real=True)
        self.steps.append((symbol, value))
        return symbol

    def __call__(self, leaf: Callable[[str, str], np.ndarray]) -> np.ndarray:
        """Return the value of each output; ``leaf("x", "alpha")`` is an array."""
        values = [
            name if group == "" else np.asarray(leaf(group, name))[more[0]]
            for group, name, *more in self.leaves
        ]
        with np.errstate(all="ignore"):
            return np.array(
                self._compiled(*(np.asarray(v, dtype=float)[()] for v in values)), dtype=float
            )
