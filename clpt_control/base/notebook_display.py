"""Notebook displays that the package's `__init__` sets: HTML of diagrams, `dataset.clpt`.

The functions that draw diagrams and load the accessor import packages above; they are called when a
notebook first needs them.
"""

import sys
from collections.abc import Callable
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from types import ModuleType
from typing import Any

NAME, XARRAY = "clpt", "xarray"
diagram_renderer: Callable[[Any], str] | None = None


def diagram_html(diagram: Any) -> str | None:
    """Return a diagram as HTML; without a renderer None, and notebooks show its text."""
    return None if diagram_renderer is None else diagram_renderer(diagram)


def register_accessor(load: Callable[[], type]) -> None:
    """Add `clpt` to every Dataset, now or right after xarray is imported; `load` returns its class.

    `clpt_control` does not import xarray.
    """
    if XARRAY in sys.modules:
        _register(load)
    elif not any(isinstance(finder, _AfterXarray) for finder in sys.meta_path):
        sys.meta_path.insert(0, _AfterXarray(load))


def _register(load: Callable[[], type]) -> None:
    import xarray

    if not hasattr(xarray.Dataset, NAME):
        # the accessor's class reads scenarios, which other runs do not need
        xarray.register_dataset_accessor(NAME)(lambda data: load()(data))


class _AfterXarray(MetaPathFinder):
    """Finds xarray as the other finders do; registers the accessor after its import."""

    def __init__(self, load: Callable[[], type]):
        self.load = load

    def find_spec(
        self, fullname: str, path: Any, target: Any = None
    ) -> ModuleSpec | None:
        """Find xarray once, and nothing else."""
        if fullname != XARRAY or self not in sys.meta_path:
            return None
        sys.meta_path.remove(self)
        spec = find_spec(fullname)
        if spec is not None and spec.loader is not None:
            loader: Any = spec.loader
            run = loader.exec_module

            def exec_module(module: ModuleType) -> None:
                run(module)
                _register(self.load)

            loader.exec_module = exec_module
        return spec
