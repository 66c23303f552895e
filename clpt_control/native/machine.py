"""Machine code in memory, made by LLVM for this processor."""

from functools import cache
from typing import Any

import llvmlite.binding as llvm
from numba.core.compiler_lock import global_compiler_lock

from .printing import print_module
from .processor import processor
from .program import Item


class Machine:
    """Functions of arrays as machine code.

    `addresses` says where the code of each lies, for as long as this object lives.
    """

    @global_compiler_lock  # LLVM is not made for threads
    def __init__(
        self, functions: dict[str, tuple[Item, ...]], constants: tuple[float, ...], lanes: int
    ):
        module = print_module(functions, constants, lanes)
        machine = _target_machine()
        module.triple, module.data_layout = machine.triple, str(machine.target_data)
        parsed = llvm.parse_assembly(str(module))
        options = llvm.create_pipeline_tuning_options(speed_level=3)
        # vectors are printed as such
        options.loop_vectorization = options.slp_vectorization = False
        options.loop_unrolling = options.loop_interleaving = False
        passes = llvm.create_pass_builder(machine, options)
        passes.getModulePassManager().run(parsed, passes)
        self._engine: Any = llvm.create_mcjit_compiler(parsed, machine)
        self._engine.finalize_object()
        self.addresses = {name: self._engine.get_function_address(name) for name in functions}


@cache
def _prepare() -> None:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


def _target_machine() -> Any:
    _prepare()
    name, features = processor()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(cpu=name, features=features, opt=3, jit=True)
