"""The processor that machine code is made for: this one, or what a variable names."""

import os
from functools import cache

import llvmlite.binding as llvm

VARIABLE = "CLPT_CONTROL_PROCESSOR"
LANES = 8  # runs side by side, or turns of a loop at once


@cache
def _host() -> tuple[str, str]:
    return llvm.get_host_cpu_name(), llvm.get_host_cpu_features().flatten()


def processor() -> tuple[str, str]:
    """Return its name and features; CLPT_CONTROL_PROCESSOR names another, such as ``generic``."""
    name = os.environ.get(VARIABLE)
    return (name, "") if name else _host()


def fuses() -> bool:
    """Whether a product and a sum are one instruction."""
    return "+fma" in processor()[1] or "+neon" in processor()[1]
