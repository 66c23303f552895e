"""The processor that machine code is made for: this one, or what Numba's variables name."""

import os
from functools import cache

import llvmlite.binding as llvm

LANES = 8  # runs side by side, or turns of a loop at once


@cache
def _host() -> tuple[str, str]:
    return llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def processor() -> tuple[str, str]:
    """Return its name and features; NUMBA_CPU_NAME and NUMBA_CPU_FEATURES name others."""
    name, features = os.environ.get("NUMBA_CPU_NAME"), os.environ.get("NUMBA_CPU_FEATURES")
    if features is None:
        features = "" if name else _host()[1]
    return name or _host()[0], features


def fuses() -> bool:
    """Whether a product and a sum are one instruction."""
    return "+fma" in processor()[1] or "+neon" in processor()[1]
