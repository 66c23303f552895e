"""Machine code of functions of arrays, made by LLVM for this processor or found in the cache."""

from collections.abc import Callable, Iterable
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import llvmlite.binding as llvm

from .object_code import keep, kept, loaded, name_of, one_at_a_time, target_machine

PRINTED_BY = ("printing", "nests", "kernels", "elementary", "vectors", "exponentials", "circular")


class Machine:
    """Functions of arrays as machine code.

    `addresses` says where the code of each lies, for as long as this object lives; `made_of` is
    all that the printed text depends on.
    """

    @one_at_a_time
    def __init__(self, names: Iterable[str], made_of: str, printed: Callable[[], Any]):
        name = name_of(made_of, *_printed_by())
        code = kept(name)
        if code is None:
            code = _optimised(str(printed()))
            keep(name, code)
        self._engine: Any = loaded(code)
        self.addresses = {name: self._engine.get_function_address(name) for name in names}


@cache
def _printed_by() -> list[str]:
    """Return what LLVM's text of a program depends on beside the program."""
    files = (*PRINTED_BY, "method", "rosenbrock", "machine")
    texts = [Path(__file__).with_name(f"{name}.py").read_text("utf-8") for name in files]
    return [*texts, version("numpy")]


def _optimised(text: str) -> bytes:
    """Return the object code of LLVM's text."""
    machine = target_machine()
    parsed = llvm.parse_assembly(text)
    parsed.triple, parsed.data_layout = machine.triple, str(machine.target_data)
    options = llvm.create_pipeline_tuning_options(speed_level=3)
    # vectors are printed as such
    options.loop_vectorization = options.slp_vectorization = False
    options.loop_unrolling = options.loop_interleaving = False
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(parsed, passes)
    return bytes(machine.emit_object(parsed))
