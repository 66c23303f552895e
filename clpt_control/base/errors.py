"""Errors that a user can cause, each with one sentence.

Every error that a user can cause is a `ClptError`: its text names what was
given, where, what is allowed and what to try.  The command line prints that
sentence and ends with status 2, or with 1 where a run was under way.
"""

import types
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module

# all others: sea
EXTRA = {"dask": "ensemble", "distributed": "ensemble", "zarr": "ensemble"}


class ClptError(Exception):
    """Base of every error this package raises on purpose."""


class ArgumentError(ClptError, TypeError, ValueError):
    """A function is given an argument of another kind than it takes."""


class BlockError(ClptError, ValueError):
    """A block is declared or called in a way that cannot work."""


class DiagramError(ClptError, ValueError):
    """A diagram's blocks do not fit together."""


class Uncompiled(DiagramError):
    """A diagram of which no machine code is made; Python runs it."""


class ScenarioError(ClptError, ValueError):
    """A scenario holds a key or a value that is not allowed."""


class DataError(ClptError, ValueError):
    """A data file is missing, damaged or holds something else."""


class SimulationError(ClptError, RuntimeError):
    """A run that was under way could not go on."""


# users catch them as clpt_control.errors.DataError
for _error in (ClptError, *ClptError.__subclasses__(), Uncompiled):
    _error.__module__ = "clpt_control.errors"


@contextmanager
def naming(file: object) -> Iterator[None]:
    """Begin the sentence of what is wrong with the name of the file that it is about."""
    try:
        yield
    except ClptError as error:
        raise DataError(f"{file}: {error}") from None


def needed(module: str) -> types.ModuleType:
    """Import a module of a package that is not always there, or say what installs it."""
    try:
        return import_module(module)
    except ImportError:
        package = module.partition(".")[0]
        extra = EXTRA.get(package, "sea")
        raise DataError(
            f"{package}: is not installed; pip install 'clpt-control[{extra}]' installs it"
        ) from None
