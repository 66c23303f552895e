"""Engine: models as equations, traced, compiled and integrated; it knows nothing of the paper.

Read in this order:

1. `model.block` and `model.system`: a model is functions of ``(t, x, u, p)`` on named ports.
2. `trace.tracing`: runs a function on tracer arrays, on each of its execution paths.
3. `record.graph`: the result, a typed SSA graph of array operations; beside it its derivative and
   SymPy's expressions.
4. `diagram.wiring` and `diagram.merged_record`: blocks wired, their records as one.
5. `codegen.fused_expressions`, `codegen.plan`, `codegen.llvm_text`: machine code of the record.
6. `solver.runner` and `solver.time_stepper`: integration from event to event, with events of time
   and of state.
7. `conformance.checks`: every backend compared with Python.
"""
