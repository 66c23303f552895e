"""Public modules with short names.

`clpt_control.gliders` has names of `ocean.gliders`; the stub `gliders.pyi` lists them.  Such a
module has no files of its own: `from clpt_control.gliders import Dive` and `clpt.gliders.Dive`
import the file that defines `Dive` when it is first used.
"""

import ast
import sys
from collections.abc import Iterable
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import lazy_loader

PACKAGE = __package__.partition(".")[0]
PUBLIC_MODULES = {
    "currents": "Gridded currents, tides, fits, and the flow of a run.",
    "gliders": "Vehicle files and their dives.",
    "replay": "Forecasts of surfacings, dive by dive.",
}


# name of python-control -> advice; all other names take linear systems
HINTS = dict.fromkeys(
    (
        "input_output_response",
        "forced_response",
        "step_response",
        "impulse_response",
        "initial_response",
        "lsim",
        "step",
        "impulse",
        "initial",
    ),
    "Call clpt.simulate(system, timepts, inputs)",
)
HINTS |= dict.fromkeys(
    ("ss", "tf", "zpk", "nlsys"), "Its systems are blocks of clpt.connect"
)
HINTS["interconnect"] = "Call clpt.connect(blocks)"
HINTS["find_operating_point"] = "Give it a diagram of clpt.connect"
ASKED = {"plot": "Call run.clpt.plot()", "design": "Call clpt.theory.design_track"}
LINEAR = "Give it a linear system, clpt.linearize(system, x, u)"


def missing(module: str, name: str, names: Iterable[str]) -> AttributeError:
    """Return the error of a missing name: one of python-control, or near one of `names`."""
    short = module.replace(PACKAGE, "clpt")
    if module == PACKAGE and not name.startswith("_"):
        import control
        import control.matlab

        for owner in (control, control.matlab):
            if callable(getattr(owner, name, None)):
                advice = HINTS.get(name, LINEAR)
                return AttributeError(
                    f"clpt.{name}: is {owner.__name__}.{name}. {advice}"
                )
    from .arguments import nearest

    similar = "" if name.startswith("_") else nearest(name, names)
    advice = f". Did you mean {short}.{similar}?" if similar else ""
    advice = f". {ASKED[name]}" if name in ASKED else advice
    return AttributeError(f"No {module} attribute {name}{advice}")


def attach(module: str, file: str) -> Any:
    """Return __getattr__, __dir__ and __all__ of a module whose names its stub lists."""
    lazy_getattr, directory, names = lazy_loader.attach_stub(module, file)

    def attribute(name: str) -> Any:
        if name in names:
            return lazy_getattr(name)
        raise missing(module, name, names)

    return attribute, directory, names


class PublicModule(ModuleType):
    """A module whose stub lists where its names are defined."""

    def __init__(self, name: str, doc: str):
        super().__init__(f"{PACKAGE}.{name}", doc)
        stub = Path(__file__).parents[1] / f"{name}.pyi"
        self._modules = {
            alias.name: f"{PACKAGE}.{node.module}"
            for node in ast.parse(stub.read_text("utf-8")).body
            if isinstance(node, ast.ImportFrom)
            for alias in node.names
        }
        self.__all__ = sorted(self._modules)

    # not lazy_loader: it would cache a name on the package, and hide a public module of this name
    def __getattr__(self, name: str) -> Any:
        module = vars(self).get("_modules", {}).get(name)
        if module is None:
            raise missing(self.__name__, name, self.__all__)
        value = getattr(import_module(module), name)
        setattr(self, name, value)
        return value

    def __call__(self, *given: Any, **named: Any) -> None:
        """Refuse a call, and name the functions."""
        short = self.__name__.replace(PACKAGE, "clpt")
        names = ", ".join(f"{short}.{name}" for name in self.__all__ if name.islower())
        from .errors import ArgumentError

        raise ArgumentError(f"{short}: is a module. Call one of {names}")

    def __dir__(self) -> list[str]:
        return [*self.__all__]


def register() -> None:
    """Make the public modules importable."""
    for name, doc in PUBLIC_MODULES.items():
        module = PublicModule(name, doc)
        sys.modules[module.__name__] = module
        setattr(sys.modules[PACKAGE], name, module)
