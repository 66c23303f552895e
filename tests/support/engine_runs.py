"""The engine's inner names that tests use, engines that are compared, and runs side by side.

Tests of `tests/engine` and `tests/simulation` import these names here: a file of the engine that is
merged or moved changes this file alone.
"""

from functools import partial

import numpy as np
from all_backends import BACKEND, compare_backends, readings

from clpt_control.engine.codegen import machine, vectors
from clpt_control.engine.codegen.c_library import compiler
from clpt_control.engine.codegen.diagram_record import Form
from clpt_control.engine.codegen.elementary import FUNCTIONS
from clpt_control.engine.codegen.fused_expressions import Component, Write
from clpt_control.engine.codegen.llvm_text import print_program
from clpt_control.engine.codegen.machine import (
    LANES,
    Machine,
    cache_code,
    cached_code,
    code_name,
)
from clpt_control.engine.codegen.plan import Nest, Program
from clpt_control.engine.codegen.vectors import PRIMITIVES
from clpt_control.engine.conformance.checks import (
    check_block,
    python_values,
    random_samples,
    roles,
)
from clpt_control.engine.conformance.confirmation import Confirmation, differ
from clpt_control.engine.diagram.block_numbers import blocks_of
from clpt_control.engine.diagram.interconnection import Diagram
from clpt_control.engine.diagram.wiring import wiring_of
from clpt_control.engine.methods import METHODS, ROWS, Method
from clpt_control.engine.model.declaration import Each
from clpt_control.engine.model.system import linear
from clpt_control.engine.record.operations import ELEMENTWISE, TABLE, UFUNCS, Row
from clpt_control.engine.record.unread import Unread
from clpt_control.engine.solver import solver_layout
from clpt_control.engine.solver.batch import Batch
from clpt_control.engine.solver.native_diagram import NativeDiagram, compile
from clpt_control.engine.solver.python_diagram import PythonDiagram
from clpt_control.engine.solver.runner import RunOptions
from clpt_control.engine.solver.solver_layout import Status
from clpt_control.engine.trace import heaps, tracing
from clpt_control.engine.trace.fingerprint import reachable
from clpt_control.engine.trace.numpy_functions import IMPLEMENTED
from clpt_control.engine.trace.ufuncs import COMPOSED

__all__ = [
    "BACKEND",
    "COMPOSED",
    "ELEMENTWISE",
    "ENGINES",
    "FUNCTIONS",
    "IMPLEMENTED",
    "LANES",
    "METHODS",
    "PRIMITIVES",
    "ROWS",
    "TABLE",
    "UFUNCS",
    "Batch",
    "Component",
    "Confirmation",
    "Diagram",
    "Each",
    "Form",
    "Machine",
    "Method",
    "NativeDiagram",
    "Nest",
    "Program",
    "PythonDiagram",
    "Row",
    "Status",
    "Unread",
    "Write",
    "blocks_of",
    "cache_code",
    "cached_code",
    "check_block",
    "code_name",
    "compare_backends",
    "compile",
    "compiler",
    "differ",
    "heaps",
    "linear",
    "machine",
    "print_program",
    "python_values",
    "random_samples",
    "reachable",
    "readings",
    "roles",
    "run_many",
    "side_by_side",
    "solver_layout",
    "tracing",
    "vectors",
    "wiring_of",
]

ENGINES = {
    "python": PythonDiagram,
    "unrolled": partial(NativeDiagram, form=Form("unrolled")),
    "looped": partial(NativeDiagram, form=Form("looped")),
}


def side_by_side(runner, lanes, starts, times, P=None, schedules=None, rtol=1e-8):
    """Return a batch of runs that has ended; of one start all have the runner's own parameters."""
    P = np.tile(runner.parameters(), (len(starts), 1)) if P is None else P
    group = np.arange(len(starts)) if schedules else None
    pieces = schedules or [runner.schedule((times[0], times[-1]))]
    batch = Batch(runner.callee(lanes), starts, P, times, pieces, group)
    batch.finish(RunOptions(rtol, 0.01 * rtol))
    return batch


def run_many(native, starts, times, rtol=1e-8):
    """Return the states (m, nt, n) of runs in lanes, whose blocks sample as the runs begin."""
    P, segments = native.parameters(), native.schedule(times)
    begun = starts
    if segments.begins:
        at = times[0] * np.ones(len(starts)), np.array(starts), segments, P
        begun = native.callee().evaluate(solver_layout.JUMP, *at)
    lanes = native.lanes(len(starts))
    return side_by_side(native, lanes, np.array(begun), times, rtol=rtol).out
