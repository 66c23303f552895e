"""Public modules with short names.

`clpt_control.equations` has names of `engine.model` and `engine.trace`; the stub `equations.pyi`
lists them.  Such a module has no files of its own: `from clpt_control.equations import Block` and
`clpt.equations.Block` import the file that defines `Block` when it is first used.
"""

import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import lazy_loader

PACKAGE = __package__.partition(".")[0]
PUBLIC_MODULES = {
    "conformance": "Tests of blocks and diagrams, and every backend by name.",
    "diagrams": "Wiring, linearization, equations and drawing of diagrams.",
    "equations": "Blocks of equations; called with a system, its equations in SymPy.",
    "native": "Diagrams as machine code.",
}


class PublicModule(ModuleType):
    """A module whose stub lists where its names are defined."""

    def __init__(self, name: str, doc: str) -> None:
        super().__init__(f"{PACKAGE}.{name}", doc)
        stub = Path(__file__).parents[1] / f"{name}.pyi"
        names = ("__getattr__", "__dir__", "__all__")
        vars(self).update(zip(names, lazy_loader.attach_stub(PACKAGE, str(stub)), strict=True))


class CallableEquations(PublicModule):
    """The module `equations`, which is a function too: ``clpt.equations(system)``."""

    def __call__(self, system: Any, numbers: bool = False) -> Any:
        """Return a diagram's equations as SymPy, as `clpt.diagrams.equations` does."""
        diagrams = sys.modules[f"{PACKAGE}.diagrams"]
        return diagrams.equations(system, numbers)


def register() -> None:
    """Make the public modules importable."""
    for name, doc in PUBLIC_MODULES.items():
        kind = CallableEquations if name == "equations" else PublicModule
        module = kind(name, doc)
        sys.modules[module.__name__] = module
        setattr(sys.modules[PACKAGE], name, module)
