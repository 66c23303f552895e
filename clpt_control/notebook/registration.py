"""`dataset.clpt` is there once clpt_control and xarray are imported, whichever came first.

clpt_control does not import xarray: where that is not there yet, it is registered right after
xarray's own import.
"""

import sys
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from types import ModuleType
from typing import Any

NAME, XARRAY = "clpt", "xarray"


def register() -> None:
    """Add to every Dataset its `clpt`, now or when xarray is imported."""
    if XARRAY in sys.modules:
        _register()
    elif not any(isinstance(finder, _AfterXarray) for finder in sys.meta_path):
        sys.meta_path.insert(0, _AfterXarray())


def _register() -> None:
    import xarray

    from .accessor import ClptAccessor

    if not hasattr(xarray.Dataset, NAME):
        xarray.register_dataset_accessor(NAME)(ClptAccessor)


class _AfterXarray(MetaPathFinder):
    """Finds xarray as the others do, and registers when it was imported."""

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> ModuleSpec | None:
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
                _register()

            loader.exec_module = exec_module
        return spec
