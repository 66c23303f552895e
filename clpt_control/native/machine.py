"""Machine code in memory, made by LLVM for this processor, and calls of it."""

from functools import cache
from typing import Any

import llvmlite.binding as llvm
from llvmlite import ir
from numba import config
from numba.core import types
from numba.core.compiler_lock import global_compiler_lock
from numba.extending import intrinsic

from .printing import print_module
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


def processor() -> tuple[str, str]:
    """Return name and features of the processor that is compiled for."""
    set_by_user: Any = config  # Numba makes its names when it is imported
    name = set_by_user.CPU_NAME or llvm.get_host_cpu_name()
    features = set_by_user.CPU_FEATURES
    if features is None:
        features = "" if set_by_user.CPU_NAME else llvm.get_host_cpu_features().flatten()
    return name, features


def fuses() -> bool:
    """Whether a product and a sum are one instruction."""
    return "+fma" in processor()[1] or "+neon" in processor()[1]


@cache
def _prepare() -> None:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


def _target_machine() -> Any:
    _prepare()
    name, features = processor()
    target = llvm.Target.from_default_triple()
    return target.create_target_machine(cpu=name, features=features, opt=3, jit=True)


@intrinsic
def call_address(typingctx, address, t, X, first, P, T, W, D, to):
    """Call the function at an address with pointers into arrays, in compiled code."""
    signature = types.void(types.int64, t, X, types.int64, P, T, W, D, types.int64)

    def build(context, builder, signature, arguments):
        def pointer(k):
            return context.make_array(signature.args[k])(context, builder, arguments[k]).data

        double = ir.DoubleType().as_pointer()
        kind = ir.FunctionType(ir.VoidType(), [double] * 6).as_pointer()
        given = [
            pointer(1),
            builder.gep(pointer(2), [arguments[3]]),
            *(pointer(k) for k in (4, 5, 6)),
            builder.gep(pointer(7), [arguments[8]]),
        ]
        builder.call(builder.inttoptr(arguments[0], kind), given)
        return context.get_dummy_value()

    return signature, build
