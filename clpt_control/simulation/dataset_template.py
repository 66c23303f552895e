"""Template of a Dataset: names, dimensions, units and attributes, without numbers.

The runs of one system share a template, which is filled with the signals of each run.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from platform import python_version
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..base.run_attributes import versions
from ..engine.model.ports import bare_labels, ports_of
from ..engine.solver.solver_layout import Status
from ..engine.solver.termination import Solution

if TYPE_CHECKING:
    import xarray


INDEX = "index"  # suffix of the dimension of a port
STATE = {"long_name": "state of the diagram"}
STATES = {"long_name": "states of the diagram, each in its own unit"}
HELD = "held between the samples of its block"
REPEAT = "The script that made this run repeats it"  # a file has no equations
COMPLETED = Status.FINISHED.sentence
PACKAGES = ("clpt-control", "control", "numpy", "scipy", "llvmlite")

Labels = tuple[str, ...]
Axes = dict[str, tuple[Any, Mapping[str, Any]]]  # dimension -> values, attributes


class Series(NamedTuple):
    """A variable of a Dataset: a function `of` all signals, of shape (nt, nsignals)."""

    dims: tuple[str, ...]
    of: Callable[[np.ndarray], np.ndarray]
    attributes: dict[str, str]


class Signals(NamedTuple):
    """Signals of a vehicle: their columns by label, and the parameters of the blocks by name."""

    column: dict[str, int]
    parameters: dict[str, Any]

    def of(self, port: str, *shape: int) -> Any:
        """Return a function that selects a port, in a shape, of all signals."""
        count = int(np.prod(shape))
        return columns([self.column[f"{port}[{k}]"] for k in range(count)], *shape)


@dataclass(eq=False)
class DatasetTemplate:
    """A Dataset without numbers.

    `axes` has values and attributes of each dimension except time, whose attributes are
    `time_attributes`.  `states` are labels; without labels the Dataset has no states.  `folder` is
    that of a scenario's files, and `note` is appended to the message of each run.
    """

    variables: Mapping[str, Series]
    axes: Mapping[str, tuple[Any, Any]]
    attributes: dict[str, Any]
    time_attributes: Mapping[str, str] | None = None
    states: Sequence[str] | None = None
    folder: str | None = None
    note: str = ""

    def __post_init__(self) -> None:
        self.axes = {name: index_of(name, *axis) for name, axis in self.axes.items()}
        if self.states is not None:
            labels = np.array(bare_labels(self.states), dtype=object)
            self.axes["state"] = index_of("state", labels, STATE)
        # the last times, and their index
        self._cached_time: tuple[bytes | None, Any] = (None, None)

    def filled(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a Dataset of a run's signals and states, with attributes of its own."""
        attributes = {
            **self.attributes,
            "software": software(),
            "status": solution.status,
            "message": solution.message,
            "engine": solution.engine,
            "method": solution.method,
        }
        for name, value in solution.statistics.items():
            attributes[f"solver_{name}"] = value
        if solution.message == COMPLETED:
            unit = (self.time_attributes or {}).get("units")
            end = f"{solution.t[-1]:g} {unit}" if unit else f"{solution.t[-1]:g}"
            attributes["message"] += f" (t = {end})"
        if self.note:
            attributes["message"] += f"; {self.note}"
        run = self.dataset(solution.t, signals, solution.x, attributes)
        if self.folder is not None:
            run.encoding["folder"] = self.folder
        return run

    def dataset(
        self,
        times: np.ndarray,
        signals: np.ndarray,
        states: Any = None,
        attributes: Any = None,
    ) -> "xarray.Dataset":
        """Return a Dataset of signals and states at times.

        xarray's constructor would search and align the indexes, which takes longer, and import
        Dask.
        """
        from xarray import Dataset, Variable

        variables = {
            name: variable_of(
                Variable, series.dims, series.of(signals), series.attributes
            )
            for name, series in self.variables.items()
        }
        if self.states is not None:
            dims = "time", "state"
            variables["states"] = variable_of(Variable, dims, states, STATES)
        axes = {"time": self._time_index(times), **self.axes}
        for name, (_, axis) in axes.items():
            parts = axis._dims, axis._data, axis._attrs or {}
            variables[name] = variable_of(type(axis), *parts)
        indexes = {name: index for name, (index, _) in axes.items()}
        sizes = {name: len(index.index) for name, index in indexes.items()}
        return Dataset._construct_direct(
            variables, set(axes), sizes, attributes, indexes, {}
        )

    def _time_index(self, times: np.ndarray) -> tuple[Any, Any]:
        cached_times, index = self._cached_time
        if times.tobytes() != cached_times:
            index = index_of("time", times.copy(), self.time_attributes)
            self._cached_time = times.tobytes(), index
        return index


@cache
def software() -> str:
    """Return the versions of Python and of the packages that compute a run."""
    return f"Python {python_version()}, {versions(*PACKAGES)}"


def variable_of(
    kind: Any, dims: tuple[str, ...], data: Any, attributes: Mapping[str, Any]
) -> Any:
    """Return a Variable of xarray by its four slots; the constructor takes five times as long."""
    variable = kind.__new__(kind)
    variable._dims = dims
    variable._data = data
    variable._attrs = dict(attributes)
    variable._encoding = None
    return variable


def index_of(name: str, values: Any, attributes: Any) -> tuple[Any, Any]:
    """Return an index of values and its variable, without xarray's slower constructor."""
    import xarray
    from pandas import Index

    index = xarray.indexes.PandasIndex(Index(values), name)
    variable = xarray.Variable((name,), np.asarray(values), attributes, fastpath=True)
    return index, index.create_variables({name: variable})[name]


def port_variables(
    ports: Mapping[str, list[int]],
    dims: Mapping[int, str],
    reserved: Any,
    units: Mapping[str, str],
) -> tuple[dict[str, Series], Axes]:
    """Return variables of ports, each with the columns of its signals, and their axes.

    `dims` names dimensions by size; other dimensions are named after their port and count from 0.
    A name that is reserved gets the suffix _.
    """
    variables: dict[str, Series] = {}
    axes: Axes = {}
    for port, port_columns in ports.items():
        size = len(port_columns)
        port_dims: tuple[str, ...] = ()
        if size > 1:
            dim = dims.get(size, f"{port}_{INDEX}")
            port_dims = (f"{dim}_" if dim in ports else dim,)
        if size > 1 and size not in dims:
            attributes = {"long_name": f"signal of {port}, counted from 0"}
            axes[port_dims[0]] = np.arange(size), attributes
        unit = {"units": units[port]} if units.get(port) else {}
        name = port
        while name in reserved or (name != port and name in ports):
            name += "_"
        series = columns(port_columns, *[size] * len(port_dims))
        variables[name] = Series(("time", *port_dims), series, unit)
    return variables, axes


@lru_cache(maxsize=64)
def diagram_template(
    name: str,
    labels: Labels,
    units: Labels,
    states: Labels,
    held: frozenset[int] = frozenset(),
) -> DatasetTemplate:
    """Return the template of any diagram's runs: a variable for each port, and the states.

    `labels` and `units` are those of the signals, of which some are `held` between samples.
    """
    ports = ports_of(labels)
    port_units = {port: units[indices[0]] for port, indices in ports.items()}
    reserved = "time", "state", "states"
    variables, axes = port_variables(ports, {}, reserved, port_units)
    for series, indices in zip(variables.values(), ports.values(), strict=True):
        if held.issuperset(indices):
            series.attributes["comment"] = HELD
    attributes = {"title": f"Response of {name}", "comment": REPEAT}
    return DatasetTemplate(variables, axes, attributes, states=states)


def columns(indices: Sequence[int], *shape: int) -> Callable[[np.ndarray], np.ndarray]:
    """Return a function that selects columns of the signals in a shape, or a single column."""
    if not shape:
        return lambda signals: signals[:, indices[0]]
    selected = np.array(indices)
    if len(shape) == 1:  # signals of members may have times behind
        return lambda signals: signals[:, selected]
    return lambda signals: signals[:, selected].reshape(len(signals), *shape)
