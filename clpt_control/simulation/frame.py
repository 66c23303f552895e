"""What the Datasets of one run share, which is made once: names, units, coordinates, attributes."""

import platform
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from importlib.metadata import version
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..native.ending import Solution

if TYPE_CHECKING:
    import xarray

STATE = {"long_name": "state of the diagram"}
STATES = {"long_name": "states of the diagram, each in its own unit"}


class Part(NamedTuple):
    """A variable of a Dataset: what it is of all signals, shape (nt, nsignals)."""

    dims: tuple[str, ...]
    of: Callable[[np.ndarray], np.ndarray]
    attributes: Mapping[str, str] = {}


class Frame:
    """A Dataset without numbers, to be filled again and again.

    `axes` are its other dimensions, values and attributes; `since` are the attributes of time;
    `states` labels the states, if they are shown; relative files of a scenario lie in `folder`.
    """

    def __init__(
        self,
        parts: Mapping[str, Part],
        axes: Mapping[str, tuple[Any, Mapping[str, str]]],
        attributes: dict[str, Any],
        since: Mapping[str, str] | None = None,
        states: Sequence[str] | None = None,
        folder: str | None = None,
    ):
        self.parts, self.attributes, self.since = parts, attributes, since
        self.folder, self.states = folder, states
        self.axes = {name: _index(name, *one) for name, one in axes.items()}
        if states is not None:
            self.axes["state"] = _index("state", np.array(states, dtype=object), STATE)
        self._last: tuple[np.ndarray, Any] | None = None  # times, and their index

    def filled(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a Dataset of a run's signals and states; each has attributes of its own."""
        from xarray import Dataset, Variable

        variables: dict[str, Any] = {
            name: Variable(part.dims, part.of(signals), part.attributes, fastpath=True)
            for name, part in self.parts.items()
        }
        if self.states is not None:
            variables["states"] = Variable(("time", "state"), solution.x, STATES, fastpath=True)
        axes = {"time": self._times(solution.t), **self.axes}
        variables |= {name: variable.copy(deep=False) for name, (_, variable) in axes.items()}
        attributes = {**self.attributes, **how_it_ran(solution)}
        indexes = {name: index for name, (index, _) in axes.items()}
        # what Dataset(...) comes to, which would look for indexes and join them
        run = Dataset._construct_direct(
            variables, set(axes), attrs=attributes, indexes=indexes, encoding={}
        )
        if self.folder is not None:
            run.encoding["folder"] = self.folder
        return run

    def _times(self, times: np.ndarray) -> tuple[Any, Any]:
        """Return the index of times, the same for a run at the times of the one before."""
        last = self._last  # threads may share it
        if last is None or not np.array_equal(last[0], times):
            own = times.copy()
            own.flags.writeable = False  # several Datasets share them
            last = self._last = own, _index("time", own, self.since)
        return last[1]


def _index(name: str, values: Any, attributes: Any) -> tuple[Any, Any]:
    """Return an index of values and its variable, which xarray else makes in some passes."""
    from pandas import Index
    from xarray import Variable
    from xarray.indexes import PandasIndex

    index = PandasIndex(Index(values), name)
    variable = Variable((name,), values, attributes)
    return index, index.create_variables({name: variable})[name]


def ports_shown(
    ports: Mapping[str, Sequence[int]], dims: Mapping[int, str], taken: Any
) -> dict[str, Part]:
    """Return the variables of ports, each with the places of its signals.

    `dims` names dimensions by size; a name that is taken gets a _.
    """
    parts: dict[str, Part] = {}
    for port, places in ports.items():
        size = len(places)
        more = () if size == 1 else (dims.get(size, f"index_{size}"),)
        parts[f"{port}_" if port in taken else port] = Part(("time", *more), columns(places, *more))
    return parts


def columns(places: Sequence[int], *shape: Any) -> Callable[[np.ndarray], np.ndarray]:
    """Return what takes columns of the signals, each row in a shape; one of none is a number."""
    if not shape:
        return lambda signals: signals[:, places[0]]
    at = np.array(places)
    if len(shape) == 1:
        return lambda signals: signals[:, at]
    return lambda signals: signals[:, at].reshape(len(signals), *shape)


def how_it_ran(solution: Solution) -> dict[str, Any]:
    """Return attributes: versions, status and the solver's statistics."""
    return {
        "software": _software(),
        "status": solution.status,
        "message": solution.message,
        "engine": solution.engine,
        "method": solution.method,
        **{f"solver_{name}": value for name, value in solution.statistics.items()},
    }


@cache
def _software() -> str:
    packages = ("clpt-control", "control", "numpy", "scipy", "llvmlite")
    here = f"Python {platform.python_version()}"
    return ", ".join([here, *(f"{name} {version(name)}" for name in packages)])
