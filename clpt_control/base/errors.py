"""Errors that a user can cause, each with one sentence, and imports of optional packages.

Every error that a user can cause is a `ClptError`.  Its text names the file or argument, its value,
what is allowed and what to try.  The command line prints that sentence and ends with status 2, or
with status 1 if a run failed.
"""

import types
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from importlib import import_module
from importlib.util import find_spec
from typing import Any

EXTRAS = (  # packages that are installed together
    ("dask", "distributed", "zarr"),
    ("netCDF4", "pandas", "ppigrf", "pyproj", "utide"),
)


class ClptError(Exception):
    """Base of every error that this package raises on purpose."""


class ArgumentError(ClptError, TypeError, ValueError):
    """An argument of a function has a kind that is not allowed."""

    unknown = ""  # name of an argument that the function does not have
    names: Iterable[str] = ()  # of those that it has


class BlockError(ClptError, ValueError):
    """A block is declared or called in a way that cannot work."""


class DiagramError(ClptError, ValueError):
    """A diagram's blocks do not fit together."""


class Uncompiled(DiagramError):
    """A diagram that cannot be compiled; Python runs it."""


class ScenarioError(ClptError, ValueError):
    """A scenario has a key or a value that is not allowed."""


class DataError(ClptError, ValueError):
    """A data file is missing, damaged or has other content."""


class SimulationError(ClptError, RuntimeError):
    """A run failed before its end."""

    status = 0  # the solver's number of the reason; 0 if it has none
    points: Any = ()  # times and states where the run stopped, and ahead
    states: Any = ()  # at the samples that the run reached


# users catch them as clpt_control.DataError
for _error in (ClptError, *ClptError.__subclasses__()):
    _error.__module__ = "clpt_control"
del _error


@contextmanager
def naming(file: object) -> Iterator[None]:
    """Add the name of a file to the messages of errors."""
    try:
        yield
    except ClptError as error:
        raise DataError(f"{file}: {error}") from None


def refuse_unused(reason: str, before: str = "", **unused: Any) -> None:
    """Refuse arguments that have no effect; `before` stands before the names of options."""
    for name, value in unused.items():
        if value is not None:
            raise ScenarioError(f"{before}{name}: {reason}")


def import_optional(module: str) -> types.ModuleType:
    """Import a module of an optional package, or raise an error with the command to install it."""
    try:
        return import_module(module)
    except ImportError:
        package = module.partition(".")[0]
        [extra] = [packages for packages in EXTRAS if package in packages]
        missing = " ".join(name for name in extra if find_spec(name) is None)
        raise DataError(
            f"{package} is not installed. Install it with: pip install {missing}"
        ) from None
