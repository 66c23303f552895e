"""Adaptive learning for controlled Lagrangian particle tracking.

The paper of Cho, Zhang and Edwards (2016) as python-control block diagrams:
`closed_loop` wires a scenario's blocks, `simulate` runs them, and the same
equations are compiled and proved.  The names stand in `__init__.pyi`; each is
imported when first used, so that importing the package is light.
"""

from types import ModuleType
from typing import Any

import lazy_loader

from . import equations
from .notebook.registration import register

__version__ = "0.1.0"
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
register()  # Dataset.clpt


class _Equations(ModuleType):
    """The room `equations`, which is called too: ``clpt.equations(system)``."""

    def __call__(self, system: Any, numbers: bool = False) -> Any:
        """Return a diagram's equations as SymPy, as `clpt.diagrams.equations` does."""
        from .diagrams.on_symbols import equations

        return equations(system, numbers)


equations.__class__ = _Equations
