"""A Dataset without numbers, to be filled again and again: what the runs of one system share."""

import platform
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.metadata import version
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..engine.solver.termination import Solution

if TYPE_CHECKING:
    import xarray


INDEX = "index"  # ends the name of a port's dimension
STATE = {"long_name": "state of the diagram"}
STATES = {"long_name": "states of the diagram, each in its own unit"}
Labels = tuple[str, ...]
Axes = dict[str, tuple[Any, Mapping[str, str]]]  # dimension -> values, attributes


class Series(NamedTuple):
    """A variable of a Dataset: a function `of` all signals, of shape (nt, nsignals)."""

    dims: tuple[str, ...]
    of: Callable[[np.ndarray], np.ndarray]
    attributes: dict[str, str]


@dataclass(eq=False)
class Frame:
    """A Dataset without numbers, to be filled again and again.

    `axes` has values and attributes of each dimension but time, whose attributes are `since`.
    `states` are labels; without them the Dataset has no states.  `folder` has a scenario's files; a
    `doubt` ends the message of each run.
    """

    variables: Mapping[str, Series]
    axes: Mapping[str, tuple[Any, Any]]
    attributes: dict[str, Any]
    since: Mapping[str, str] | None = None
    states: Sequence[str] | None = None
    folder: str | None = None
    doubt: str = ""

    def __post_init__(self) -> None:
        self.axes = {name: _index(name, *one) for name, one in self.axes.items()}
        if self.states is not None:
            self.axes["state"] = _index(
                "state", np.array(self.states, dtype=object), STATE
            )
        # times, and the axis made of them
        self._latest: tuple[bytes | None, Any] = (None, None)

    def filled(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a Dataset of a run's signals and states; each has attributes of its own."""
        from xarray import Dataset, Variable

        variables: dict[str, Any] = {
            name: Variable(one.dims, one.of(signals), one.attributes, fastpath=True)
            for name, one in self.variables.items()
        }
        if self.states is not None:
            variables["states"] = Variable(
                ("time", "state"), solution.x, STATES, fastpath=True
            )
        known, time = self._latest
        if (times := solution.t.tobytes()) != known:
            time = _index("time", solution.t.copy(), self.since)
            self._latest = times, time
        axes = {"time": time, **self.axes}
        variables |= {
            # a copy, but quicker
            name: type(one)(one.dims, one._data, one.attrs, fastpath=True)
            for name, (_, one) in axes.items()
        }
        attributes = {**self.attributes, **how_it_ran(solution)}
        if self.doubt:
            attributes["message"] += f"; {self.doubt}"
        indexes = {name: index for name, (index, _) in axes.items()}
        # the same as Dataset(...), which would search and align the indexes
        dims = {name: variable.size for name, (_, variable) in axes.items()}
        run = Dataset._construct_direct(
            variables, set(axes), dims, attributes, indexes, {}
        )
        if self.folder is not None:
            run.encoding["folder"] = self.folder
        return run


def _index(name: str, values: Any, attributes: Any) -> tuple[Any, Any]:
    """Return an index of values and its variable, faster than xarray makes them."""
    from pandas import Index
    from xarray import Variable
    from xarray.indexes import PandasIndex

    index = PandasIndex(Index(values), name)
    variable = Variable((name,), np.asarray(values), attributes, fastpath=True)
    return index, index.create_variables({name: variable})[name]


def port_variables(
    ports: dict[str, list[int]],
    dims: Mapping[int, str],
    taken: Any,
    units: Mapping[str, str],
) -> tuple[dict[str, Series], Axes]:
    """Return the variables of ports, each with the columns of its signals, and their axes.

    `dims` names dimensions by size; others are named after their port, and count from 0.  A name
    that is taken gets a _.
    """
    variables: dict[str, Series] = {}
    axes: Axes = {}
    for port, places in ports.items():
        size = len(places)
        more: tuple[str, ...] = ()
        if size > 1:
            dim = dims.get(size, f"{port}_{INDEX}")
            more = (dim if dim not in ports else f"{dim}_",)
        if size > 1 and size not in dims:
            axes[more[0]] = (
                np.arange(size),
                {"long_name": f"signal of {port}, counted from 0"},
            )
        unit = {"units": units[port]} if units.get(port) else {}
        name = port
        while name in taken or (name != port and name in ports):
            name += "_"
        variables[name] = Series(("time", *more), columns(places, *more), unit)
    return variables, axes


def columns(places: Sequence[int], *shape: Any) -> Callable[[np.ndarray], np.ndarray]:
    """Return a function that takes columns of the signals, in a shape; without one, one column."""
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
