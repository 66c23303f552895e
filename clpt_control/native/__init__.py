"""The engine: one pass over a diagram, and integration to every breakpoint.

`compile(diagram)` makes machine code of a diagram; `simulate` does so by itself.
`docs/engine.md` leads from a diagram to machine code, step by step.
"""

from importlib import import_module
from typing import Any

import lazy_loader

_own, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> Any:
    """Return a name of the stub, or what had its name here."""
    return import_module("clpt_control.conformance").readings if name == "readings" else _own(name)
