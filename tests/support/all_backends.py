"""Backends of a diagram by name, each a function of time, states and inputs.

    python      the blocks in Python, one pass in the order of evaluation
    control     python-control's own evaluation of the diagram
    native      machine code, as a run uses it
    scalar      machine code with all axes unrolled
    looped      machine code with all axes in loops
    lanes       machine code of eight runs at once, of which one is compared
    c           C99 as `clpt.export` writes it, where this machine has a C compiler
    symbolic    SymPy expressions of each block; opaque blocks run in Python

All backends are made from the same functions.  They agree, or a backend refuses with one sentence.
Each also computes the jumps of states, except python-control, which has no jumps.
"""

import ctypes
import platform
import tempfile
from collections.abc import Callable, Mapping
from functools import cache
from math import copysign, isfinite, prod
from pathlib import Path
from typing import Any, NamedTuple

import control
import numpy as np
import sympy

import clpt_control as clpt
from clpt_control.base.errors import BlockError, DiagramError
from clpt_control.engine.codegen.c_library import ENDINGS, compiled, compiler
from clpt_control.engine.codegen.c_text import CProgram, CRecord
from clpt_control.engine.codegen.diagram_record import Form, lay_out
from clpt_control.engine.codegen.machine import LANES
from clpt_control.engine.conformance.checks import (
    Sample,
    python_values,
    random_samples,
    roles,
)
from clpt_control.engine.conformance.confirmation import Tolerance, differ
from clpt_control.engine.diagram.block_numbers import blocks_of
from clpt_control.engine.diagram.wiring import wiring_of
from clpt_control.engine.model.block import Block
from clpt_control.engine.record.graph import Shape, bound
from clpt_control.engine.record.operations import ELEMENTWISE, named
from clpt_control.engine.record.scalar_graph import Index
from clpt_control.engine.record.symbolic import ON_NUMBERS, Symbols
from clpt_control.engine.record.unread import Unread
from clpt_control.engine.solver.evaluation_pass import Sweep
from clpt_control.engine.solver.native_diagram import NativeDiagram
from clpt_control.engine.solver.python_diagram import PythonDiagram
from clpt_control.engine.solver.schedule import JUMPS

BACKEND = Tolerance(of_largest=1e-12, least=1e-12)
Values = tuple[np.ndarray, np.ndarray]  # state derivative and outputs


def loaded(library: bytes) -> ctypes.CDLL:
    """Return a shared library, loaded; its file is gone where the system lets it go."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        path = Path(folder) / f"model{ENDINGS[platform.system()]}"
        path.write_bytes(library)
        return ctypes.CDLL(str(path))


class Backend(NamedTuple):
    """A backend of a diagram."""

    evaluate: Callable[[float, Any, Any], Values]  # of (t, x, u)
    jump: Callable[[float, Any, Any], np.ndarray]  # states after every block has jumped

    def __call__(self, t: float, x: Any, u: Any) -> Values:
        """Return state derivative and outputs."""
        return self.evaluate(t, x, u)


def readings(
    diagram: control.NonlinearIOSystem, params: Mapping[str, Any] | None = None
) -> dict[str, Backend]:
    """Return every backend of a diagram, a function of (t, x, u).

    >>> import clpt_control as clpt
    >>> from clpt_control.paper.blocks.clpe import clpe
    >>> for name, backend in readings(clpe()).items():
    ...     assert backend(0.0, [], [3.0, 2.0, 1.0, 1.0])[1].tolist() == [2.0, 1.0]
    """
    wiring = wiring_of(diagram, params)
    sweep = PythonDiagram(wiring).sweep

    def by_control(t: float, x: Any, u: Any) -> Values:
        states = np.asarray(x, dtype=float)
        inputs = np.asarray(u, dtype=float)
        rates = diagram.dynamics(t, states, inputs, params)
        outputs = diagram.output(t, states, inputs, params)
        return np.asarray(rates), np.asarray(outputs)

    def no_jump(t: float, x: Any, u: Any) -> np.ndarray:
        raise DiagramError(
            "python-control has no jumps of states. Run the diagram with clpt.simulate"
        )

    def native(form: str | None = None, lanes: int = 1) -> Backend:
        return _compiled_backend(
            lambda: _MachineCode(NativeDiagram(wiring, Form(form)), lanes)
        )

    backends = {
        "python": _sweep_backend(sweep),
        "control": Backend(by_control, no_jump),
        "native": native(),
        "scalar": native("unrolled"),
        "looped": native("looped"),
        "lanes": native(lanes=LANES),
        "symbolic": _sweep_backend(_SymbolicSweep(sweep.wiring, sweep.parameters)),
    }
    if compiler():
        backends["c"] = _compiled_backend(lambda: _CFunctions(sweep))
    return backends


def _sweep_backend(sweep: Sweep) -> Backend:
    def evaluate(t: float, x: Any, u: Any) -> Values:
        sweep.enter(t)
        return sweep.derivative(t, x, u), sweep.outputs()

    def jump(t: float, x: Any, u: Any) -> np.ndarray:
        sweep.enter(t)
        return sweep.jump(t, x, u, sweep.jumping)

    return Backend(evaluate, jump)


def _compiled_backend(compile: Callable[[], Any]) -> Backend:
    """Return the backend of functions that are compiled when first called."""
    functions = cache(compile)

    def jump(t: float, x: Any, u: Any) -> np.ndarray:
        if not functions().layout.jumps:
            return np.array(x, dtype=float)
        return functions().jumped(t, x, u)

    return Backend(lambda *at: functions().values(*at), jump)


def compare_backends(block: Block, samples: int = 20, seed: int = 0) -> None:
    """Check a block, and compare each backend with Python at random points."""
    clpt.check(block, seed=seed, samples=samples)
    [(_, block)] = blocks_of(block)
    drawn = [
        sample
        for sample in random_samples(block, seed, samples)
        if all(np.isfinite(python_values(block, r, sample)).all() for r in roles(block))
    ]
    for name, backend in readings(block).items():
        for sample in drawn:
            _compare(block, name, backend, sample)


def _compare(block: Block, name: str, backend: Backend, sample: Sample) -> None:
    """Raise an error if a backend refuses or differs from Python at a sample."""
    point = sample.t, sample.x, sample.u
    try:
        found = dict(zip(("update", "output"), backend(*point), strict=True))
        if "jump" in roles(block) and name != "control":
            found["jump"] = backend.jump(*point)
    except clpt.ClptError as error:
        raise BlockError(
            f"{block.name}: the backend '{name}' refuses: {error}"
        ) from None
    for role, value in found.items():
        wanted = np.zeros(0)
        if role in roles(block):
            wanted = python_values(block, role, sample)
        if differ(value, wanted, BACKEND).any():
            raise BlockError(
                f"{block.name}.{role}: Python gives {wanted}, the backend '{name}' {value} at "
                f"{sample}"
            )


class _CFunctions:
    """The C functions of a diagram, compiled, and the arrays that they read."""

    def __init__(self, sweep: Sweep):
        self.sweep = sweep
        self.layout = layout = lay_out(sweep.wiring, sweep.parameters)
        try:
            record = CRecord(sweep.wiring, layout)
        except Unread as error:
            raise BlockError(str(error)) from None
        self.program = CProgram(record, len(sweep.signals))
        functions = map(self.program.function, self.program.functions)
        text = "".join([*self.program.shared(layout.T), *functions])
        # without optimization, to be quick; every function can be called
        flags = ("-O0", "-Dstatic=")
        self.library = loaded(compiled(f"#include <math.h>\n{text}", *flags))
        self.p = np.append(np.delete(layout.P, record.set_by_integrator), 0.0)

    def values(self, t: float, x: Any, u: Any) -> Values:
        """Return rates and outputs."""
        signals = self._call("signals", t, x, u)[: len(self.sweep.signals)]
        outputs = self.sweep.wiring.outputs_of(signals, u)
        return self._call("rates", t, x, u)[: len(x)], outputs

    def jumped(self, t: float, x: Any, u: Any) -> np.ndarray:
        """Return states after all jumps."""
        return self._call("jump", t, x, u)[: len(x)]

    def _call(self, name: str, t: float, x: Any, u: Any) -> np.ndarray:
        """Return what a function writes: signals, rates or states, and room behind them."""
        nodes = self.sweep.wiring.nodes
        intervals = [
            nodes[k].system.parameters_at(t, self.sweep.parameters[k]).interval
            for k in self.layout.intervals
        ]
        kept = [*intervals, *(JUMPS for _ in self.layout.jumps)]
        out = np.zeros(max(self.program.components.room, len(x)) + 1)
        arrays = [np.append(one, 0.0).astype(float) for one in (x, u, self.p, kept)]
        pointers = [ctypes.c_void_p(one.ctypes.data) for one in (*arrays, out)]
        self.library[f"{name}_"](ctypes.c_double(t), *pointers)
        return out


class _MachineCode:
    """The functions of a compiled diagram and the arrays on which they run.

    The last lane has the states of a call; the others have different states.
    """

    def __init__(self, native: NativeDiagram, lanes: int):
        self.native = native
        self.layout = native.layout
        self.lanes = lanes
        program = native.code.program
        n = native.nstates

        def rows(count: int) -> np.ndarray:
            return np.zeros((max(count, 1), lanes))

        self.X = rows(n)
        self.P = rows(program.parameters)
        self.W = rows(program.room)
        self.D = rows(max(n, 3 * (program.decided + program.guarded)))
        self.time = np.zeros(lanes)
        self.T = np.append(native.layout.T, 0.0)
        self.factors = 1.0 + 0.1 * np.arange(lanes)[::-1]  # of the states of each lane

    def values(self, t: float, x: Any, u: Any) -> Values:
        """Return rates and outputs."""
        return self._call(t, x, u, "derivative", "signals")

    def jumped(self, t: float, x: Any, u: Any) -> np.ndarray:
        """Return states after all jumps."""
        return self._call(t, x, u, "jump")[0]

    def _call(self, t: float, x: Any, u: Any, *functions: str) -> Values:
        """Call functions; return the states' part of D, and the outputs."""
        native = self.native
        decided = native.code.program.decided
        x = np.asarray(x, dtype=float)
        u = np.asarray(u, dtype=float)
        P = self._parameters(t, u)
        self.time[:] = t
        self.X[: len(x)] = np.outer(x, self.factors)
        self.P[: len(P)] = P[:, None]
        decide = ("prepare", "decide") if decided else ()
        names = (*decide, "prepare", *functions)
        arrays = self.time, self.X, self.P, self.T, self.W, self.D
        pointers = [array.ctypes.data for array in arrays]
        signature = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * len(pointers))
        addresses = native.code.addresses(names, self.lanes)
        for name, address in zip(names, addresses, strict=True):
            function = signature(int(address))
            function(*pointers)
            if name == "decide":
                begin = native.decided_at
                self.P[begin : begin + decided] = self.D[:decided]
        signals = self.W[: native.nsignals, -1]
        outputs = native.wiring.outputs_of(signals, u)
        states = self.D[: native.nstates, -1].copy()
        return states, outputs

    def _parameters(self, t: float, u: np.ndarray) -> np.ndarray:
        """Return P with inputs, intervals and jumps at a time."""
        native = self.native
        P = native.parameters()
        layout = native.layout
        inputs = [t, *u, *np.zeros(len(u))]  # begin, values, slopes
        begin = len(layout.P)
        P[begin : begin + len(inputs)] = inputs
        for k, index in layout.intervals.items():
            block = native.wiring.nodes[k].system
            parameters = block.parameters_at(t, native.sweep.parameters[k])
            P[index] = parameters.interval
        requests = [*layout.jumps.values()]
        P[requests] = JUMPS
        return P


class _SymbolicSweep(Sweep):
    """An evaluation pass by SymPy expressions."""

    def __init__(self, *arguments):
        super().__init__(*arguments)
        self._functions: dict[tuple[int, str], SymbolicFunction] = {}

    def _call(
        self, role: str, k: int, t: float, x: np.ndarray, u: np.ndarray, out: Any
    ) -> None:
        block = self.nodes[k].system
        if block.opaque:
            super()._call(role, k, t, x, u, out)
            return
        key = k, role
        if key not in self._functions:
            self._functions[key] = SymbolicFunction(block, role)
        function = self._functions[key]
        out[:] = function(block._leaf_values(t, x, u, self._current[k]))


# --- SymPy's expressions on numbers ------------------------------------------------------------


LONG = 20  # operations; a longer expression gets a symbol of its own
MOST = 20_000  # scalar operations; SymPy takes a millisecond for each
# functions that would lose digits, or range, if written out: log1p(a) as log(1 + a)
PRECISE = {
    name: sympy.Function(f"{name}_", real=True)
    for name in named(lambda row: not row.exact)
}
NAMES: dict[str, Callable[..., Any]] = {
    **ON_NUMBERS,
    **{f"{name}_": ELEMENTWISE[name] for name in PRECISE},
    **{
        name: ELEMENTWISE[name] for name in ("sin", "cos", "tan")
    },  # NaN beyond MOST_ANGLE
}


class SymbolicFunction(Symbols):
    """A block's equations as SymPy expressions; long expressions get symbols of their own."""

    def __init__(self, block: Block, role: str):
        try:
            record = block.array_record(role)
        except Unread as error:
            raise BlockError(str(error)) from None
        super().__init__(record.operations, self._leaf, sizes=block.sizes)
        count = 0
        for operation in record.operations:
            if operation.kind not in ("leaf", "constant", "view"):
                count += prod(bound(operation.shape, self.sizes))
        if count > MOST:
            raise BlockError(
                f"{block.name}.{role} takes more than {MOST} operations on single numbers, for "
                "which SymPy needs minutes. Use a smaller size"
            )
        self.leaves: dict[tuple, sympy.Symbol] = {}
        self.steps: list[tuple[sympy.Symbol, sympy.Expr]] = []
        values = self.outputs(record)
        step_values = [value for _, value in self.steps]
        for value in (*values, *step_values):
            if value.has(sympy.zoo, sympy.nan, sympy.I):
                raise BlockError(
                    f"SymPy finds that the equations divide by zero: {value}"
                )
        self._compiled = sympy.lambdify(
            list(self.leaves.values()),
            values,
            [NAMES, "scipy", "numpy"],
            cse=lambda expressions: (self.steps, expressions),
        )

    def _symbol(self, *key: Any) -> sympy.Symbol:
        symbol = sympy.Symbol(f"leaf{len(self.leaves)}", real=True)
        return self.leaves.setdefault(key, symbol)

    def _leaf(self, key: tuple[str, str], shape: Shape, index: Index) -> Any:
        return self._symbol(*key, index)

    def number(self, value: float) -> Any:
        """Return a number; numbers that SymPy would simplify, as 0 * x, are symbols."""
        if value and isfinite(value):
            return sympy.Float(value)
        return self._symbol("", value, copysign(1.0, value))

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Return an operation's expression, or a symbol for a long one."""
        if kind in PRECISE:
            return self._step(PRECISE[kind](*arguments))
        if kind == "pow" and arguments[1] in (2.0, 3.0, 4.0):
            base, exponent = arguments
            arguments = base, sympy.Integer(exponent)
        expression = super().apply(ref, kind, arguments)
        return self._step(expression)

    def _step(self, value):
        if not isinstance(value, sympy.Expr) or value.count_ops() < LONG:
            return value
        symbol = sympy.Symbol(f"step{len(self.steps)}", real=True)
        self.steps.append((symbol, value))
        return symbol

    def __call__(self, leaf: Callable[[str, str], np.ndarray]) -> np.ndarray:
        """Return the value of each output; ``leaf("x", "alpha")`` is an array."""
        values = [
            np.float64(np.asarray(leaf(group, name))[index].item() if group else name)
            for group, name, index in self.leaves
        ]
        with np.errstate(all="ignore"):
            outputs = self._compiled(*values)
        return np.array(outputs, dtype=float)
