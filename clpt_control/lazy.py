"""Names that arrive when first used, so that importing a package is light (PEP 562)."""

import importlib
import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any


def lazily(
    package: str, names: Mapping[str, str], packages: Sequence[str] = ()
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return the ``__getattr__`` and ``__dir__`` of a package.

    Parameters
    ----------
    package : str
        Its ``__name__``.
    names : mapping of str to str
        Public names and the modules, within the package, that have them.
    packages : sequence of str, optional
        Subpackages that arrive the same way.

    Returns
    -------
    getattr, dir : callable

    Examples
    --------
    >>> get, _ = lazily("clpt_control", {"ClptError": "errors"})
    >>> get("ClptError").__name__
    'ClptError'
    """

    def get(name: str) -> Any:
        if name in names:
            value = getattr(importlib.import_module(f".{names[name]}", package), name)
        elif name in packages:
            value = importlib.import_module(f".{name}", package)
        else:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        setattr(sys.modules[package], name, value)
        return value

    return get, lambda: sorted({*names, *packages})
