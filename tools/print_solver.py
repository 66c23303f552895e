"""Print the solver as LLVM's text, which the package carries: `make solver`.

Numba reads the solver and prints it for no processor in particular, not optimised: each machine
makes its own code of it once, without Numba.  The hashes of the sources and of the text, and what
printed it, stand in the first line.  `make solver-check` prints it anew and compares: values are
named in their order, so that the text is the same on every machine.
"""

import hashlib
import os
import re
import sys
from importlib import import_module
from pathlib import Path
from runpy import run_path
from sys import version_info
from types import FunctionType, ModuleType
from typing import Any

os.environ |= {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": "", "NUMBA_OPT": "0"}

import llvmlite.binding as llvm
import numba
import numpy as np
from llvmlite import ir
from numba import njit, typeof
from numba.core import types
from numba.extending import intrinsic

ROOT = Path(__file__).parents[1]
SOLVER = ROOT / "clpt_control" / "engine" / "solver"
PAGES = (
    *("solver_layout", "event_checks", "event_location", "implicit", "segments"),
    "time_stepper",
)
SOURCES = (*(SOLVER / f"{name}.py" for name in PAGES), Path(__file__))
TEXT = SOLVER / "solver.ll"
# coefficients of series on balls, with a text of their own
BALLS = ROOT / "clpt_control" / "engine" / "enclosure" / "ball_series.py"
TEXTS = {TEXT: SOURCES, BALLS.with_suffix(".ll"): (BALLS, Path(__file__))}
OPTIONS: dict[str, Any] = {
    "nogil": True,
    "error_model": "numpy",
    "_nrt": False,
    "no_cpython_wrapper": True,
    "no_cfunc_wrapper": True,
}
# functions that stay functions; the others are inlined
NOT_INLINED = (
    *("advance", "evaluate", "take_run", "find_crossing", "may_hide", "locate_events"),
    "check_events",
    "evaluate_points",
    "pass_events",
    "rates_change",
    *("narrow", "factor", "differentiate", "solve_stage"),
    *("write_samples", "jump_states"),
)
# words that an older LLVM does not know
NEWER = r" (?:#\d+|nuw|nneg|samesign|disjoint|immarg|writeonly|nocreateundeforpoison)\b"
NEWER += r"| captures\(none\)"
VALUE = r'%(?:[-\w$.]+|"[^"]+")'
LABEL = r'^([-\w$.]+|"[^"]+"):'


def digest(text: Path) -> str:
    """Return the hash of what a text is made of."""
    sources = b"".join(one.read_bytes() for one in TEXTS[text])
    return hashlib.sha256(sources).hexdigest()


@intrinsic
def call_address(typingctx, address, t, X, first, P, T, W, D, to):
    """Call the function at an address with pointers into arrays."""
    signature = types.void(types.int64, t, X, types.int64, P, T, W, D, types.int64)

    def build(context, builder, signature, arguments):
        def pointer(k):
            return context.make_array(signature.args[k])(
                context, builder, arguments[k]
            ).data

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


def for_numba() -> ModuleType:
    """Return the solver's page with its functions for Numba to compile, and those of the others."""
    # the room without its `__init__`, which asks for more
    package = ModuleType("pages")
    package.__path__ = [str(SOLVER)]
    sys.modules["pages"] = package
    pages = [import_module(f"pages.{name}") for name in PAGES]
    compiled: dict[FunctionType, Any] = {pages[0].call: call_address}
    for page in pages:  # each imports only from those before it
        for name, function in list(vars(page).items()):
            if isinstance(function, FunctionType):
                if function not in compiled:
                    inline = name not in NOT_INLINED
                    compiled[function] = njit(function, forceinline=inline, **OPTIONS)
                setattr(page, name, compiled[function])
    return pages[-1]


def arguments() -> dict[str, tuple]:
    """Return arguments of the kinds with which each function is called."""

    def real(axes: int) -> np.ndarray:
        return np.zeros((1,) * axes)

    def whole(axes: int) -> np.ndarray:
        return np.zeros((1,) * axes, np.int64)

    layout = sys.modules["pages.solver_layout"]
    solver = layout.Solver(
        code=whole(1),
        shape=layout.Shape(*(1,) * len(layout.Shape._fields)),
        tolerances=real(1),
        runs=layout.Runs(real(2), real(2), whole(1)),
        segments=layout.Segments(whole(1), whole(1), real(1), real(2), whole(1)),
        times=real(1),
        results=layout.Results(real(3), whole(1), whole(1), whole(2)),
        lane=real(2),
        integers=whole(2),
        queue=whole(1),
        memory=layout.Memory(*(real(1),) * 5),
        states=real(3),
        points=real(3),
        levels=real(1),
        linear=layout.Linear(
            real(1), real(1), *(whole(1),) * 3, (1, 1), *(whole(1),) * 6
        ),
    )
    points = (real(1), whole(1), real(1), real(1)), (whole(1), real(2)), (real(1),) * 4
    return {
        "advance": (solver, 1, 1),
        "evaluate": (whole(1), 1, 1, 1, 1, *points, real(2)),
    }


def printed(function: Any, given: tuple, name: str) -> Any:
    """Return a function as LLVM's module; it takes the numbers of its arguments one by one."""
    kinds = tuple(map(typeof, given))
    function.compile(kinds)
    parsed = llvm.parse_assembly(function.inspect_llvm(kinds))
    for one in (*parsed.functions, *parsed.global_variables):
        if not one.is_declaration:
            one.linkage = "internal"
    entry = parsed.get_function(function.overloads[kinds].fndesc.mangled_name)
    entry.linkage, entry.name = "external", f"{name}_of_many"
    machine = llvm.Target.from_default_triple().create_target_machine()
    # to drop what is not called
    options = llvm.create_pipeline_tuning_options(speed_level=1)
    options.loop_vectorization = options.slp_vectorization = (
        False  # each machine has its own
    )
    passes = llvm.create_pass_builder(machine, options)
    passes.getModulePassManager().run(parsed, passes)
    asked = [one.name for one in parsed.functions if one.is_declaration]
    assert all(one.startswith(("llvm.", "mem")) for one in asked), asked
    return parsed


def of_one_array(name: str, text: str) -> str:
    """Return the text of a function that takes these numbers as one array: it is quicker to call.

    It returns the result, behind whose address and the error's the arguments begin.
    """
    own = re.search(rf"i32 @{name}_of_many\((.*?)\)", text)
    assert own is not None
    kinds = [one.split()[0] for one in own[1].split(", ")[2:]]
    lines = ["%result = alloca i64", "%error = alloca ptr"]
    for k, kind in enumerate(kinds):
        lines.append(f"%at.{k} = getelementptr i64, ptr %numbers, i64 {k}")
        lines.append(f"%number.{k} = load {kind}, ptr %at.{k}")
    numbers = "".join(f", {kind} %number.{k}" for k, kind in enumerate(kinds))
    lines.append(
        f"%status = call i32 @{name}_of_many(ptr %result, ptr %error{numbers})"
    )
    lines += ["%value = load i64, ptr %result", "ret i64 %value"]
    return (
        f"define i64 @{name}(ptr %numbers) {{\n"
        + "".join(f"  {one}\n" for one in lines)
        + "}\n"
    )


def renamed(text: str) -> str:
    """Return text whose values are named by their order in each function."""
    return re.sub(r"^define.*?^}", _renamed_function, text, flags=re.M | re.S)


def _renamed_function(function: re.Match) -> str:
    names: dict[str, str] = {}
    text = re.sub(r" *; preds = .*", "", function[0])
    text = re.sub(LABEL, r"%\1:", text, flags=re.M)
    text = re.sub(
        VALUE, lambda found: names.setdefault(found[0], f"%v{len(names)}"), text
    )
    return re.sub(r"^%(\w+):", r"\1:", text, flags=re.M)


def solver_functions() -> dict[str, tuple]:
    """Return the solver's functions for Numba, with arguments."""
    module = for_numba()
    return {name: (getattr(module, name), own) for name, own in arguments().items()}


def series_functions() -> dict[str, tuple]:
    """Return the function of coefficients on balls for Numba, with arguments."""
    page = run_path(str(BALLS))
    array, wholes = np.zeros((1, 1, 1)), np.zeros((1, 1), np.int64)
    given = array, array, wholes, array[0], wholes, wholes[0], *(1,) * 6
    return {"coefficients": (njit(page["coefficients"], **OPTIONS), given)}


def text_of(path: Path) -> str:
    """Return the text of all functions, with its hashes."""
    functions = solver_functions() if path == TEXT else series_functions()
    first, *others = (
        printed(function, own, name) for name, (function, own) in functions.items()
    )
    for one in others:
        first.link_in(one)
    own = r"^(target|source_filename|; ModuleID|attributes).*\n"
    text = re.sub(NEWER, "", re.sub(own, "", str(first), flags=re.M))
    text += "\n" + "\n".join(of_one_array(name, text) for name in functions)
    text = renamed(text)
    printer = (
        f"Python {version_info.major}.{version_info.minor}, numba {numba.__version__}"
    )
    hashes = f"{digest(path)} {hashlib.sha256(text.encode()).hexdigest()}"
    return f"; sha256 {hashes}, {printer}\n{text}"


def main(arguments: list[str]) -> None:
    """Write the texts, or with `--check` compare them with those that are there."""
    for path in TEXTS:
        text = text_of(path)
        name = path.relative_to(ROOT)
        if "--check" not in arguments:
            path.write_text(text, encoding="utf-8")
        elif text.encode() != path.read_bytes():
            sys.exit(f"{name}: is not what `make solver` prints. Run `make solver`")
        print(f"{name}: {len(text):,} bytes")


if __name__ == "__main__":
    main(sys.argv[1:])
