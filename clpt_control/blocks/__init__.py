"""The paper's diagram, a page for each block, and its laws."""

from importlib import import_module
from typing import Any

__all__: list[str] = []
MOVED = ("ConformanceReport", "check_block", "conformance")  # to a room of their own


def __getattr__(name: str) -> Any:
    """Return what had its name here, which a user's script may still ask."""
    if name in MOVED:
        return getattr(import_module("clpt_control.conformance"), name)
    raise AttributeError(f"clpt_control.blocks has no {name!r}")
