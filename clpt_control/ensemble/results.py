"""The results of an ensemble: arrays in memory, filled chunk by chunk, and their Dataset.

A chunk is a fixed range of members.  `store` has the same arrays in a folder.
"""

import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.errors import ScenarioError
from ..engine.solver.solver_layout import Status
from .members import KERNEL, Values, Varied, member_count, software

if TYPE_CHECKING:
    import xarray

ARGUMENTS, CODE = "ensemble", "code"
REPEATED = ("scenario", "vary", "design", "seed")  # arguments that are also attributes
STATUS = tuple(status.label for status in Status)
COMPLETED = Status.FINISHED, Status.STOPPED  # ends that are no failures
FLAGS = {"flag_values": list(range(len(STATUS))), "flag_meanings": " ".join(STATUS)}


def arrays_of(varied: Varied, values: Values) -> "dict[str, xarray.Variable]":
    """Return all arrays of an ensemble: summaries, the members' values, and coordinates.

    Chunks fill the summaries, whose numbers here are empty.
    """
    from xarray import Variable

    numbers = np.arange(member_count(values))
    axes = {"member": (numbers, {"long_name": "member of the ensemble"}), **varied.axes}
    arrays: dict[str, Variable] = {}

    def add(name: str, dims: Iterable[str], numbers: Any, attributes: Any) -> None:
        if name in arrays:
            raise ScenarioError(
                f"{name} is used twice as a name in the result. Rename one"
            )
        arrays[name] = Variable(dims, numbers, attributes)

    def add_summary(name: str, dims: tuple[str, ...], empty: Any, **attrs: Any) -> None:
        dims = ("member", *dims)
        shape = [len(axes[dim][0]) for dim in dims]
        add(name, dims, np.broadcast_to(empty, shape), attrs)

    for name, series in varied.summaries:
        add_summary(name, series.dims, np.nan, **series.attributes)
    units = {key: unit for key, unit in axes["time"][1].items() if key == "units"}
    add_summary("status", (), np.int8(0), long_name="how the run ended", **FLAGS)
    add_summary("end", (), np.nan, long_name="last sample, or time of a stop", **units)
    for key, numbers in values.items():
        dims, attributes = varied.key_layout(key, numbers.ndim - 1)
        add(key, ("member", *dims), numbers, attributes)
    used = {dim for array in arrays.values() for dim in array.dims}
    for dim, (numbers, attributes) in axes.items():
        if dim in used and numbers.size:
            add(dim, (dim,), numbers, attributes)
    return arrays


def attributes_of(
    title: str, code: str, arguments: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the attributes of an ensemble, computed by `code`; `arguments` identify it."""
    return {
        "Conventions": "CF-1.11",
        "title": title,
        "source": software().partition(",")[0],
        "software": software(),
        **{name: arguments[name] for name in REPEATED if name in arguments},
        CODE: code,
        ARGUMENTS: json.dumps(arguments),
    }


class Results:
    """An ensemble's arrays by name, in memory."""

    path: Path | None = None

    def __init__(self, attributes: Mapping[str, Any], arrays: Mapping[str, Any]):
        self.attributes, self.arrays = attributes, arrays
        self.arguments: dict[str, Any] = json.loads(attributes[ARGUMENTS])
        self.members, self.chunk = self.arguments["members"], self.arguments["chunk"]
        others = {"member", *self.arguments["keys"]}
        self.per_member = sorted(
            name
            for name in arrays.keys() - others
            if "member" in self.dims_of(arrays[name])
        )

    def dims_of(self, array: Any) -> tuple[str, ...]:
        """Return the dimensions of an array."""
        return tuple(array.dims)

    def rows(self, index: int) -> slice:
        """Return the members of a chunk."""
        return slice(index * self.chunk, min((index + 1) * self.chunk, self.members))

    def count(self, indices: Iterable[int]) -> int:
        """Return the number of members of some chunks."""
        return sum(rows.stop - rows.start for rows in map(self.rows, indices))

    def values(self, index: int) -> Values:
        """Return the sampled parameters of the members of a chunk."""
        rows, keys = self.rows(index), self.arguments["keys"]
        return {key: np.asarray(self.arrays[key][rows]) for key in keys}

    def write(self, index: int, arrays: Values) -> None:
        """Write a chunk."""
        for name in self.per_member:
            if arrays[name].size:
                self.arrays[name][self.rows(index)] = arrays[name]

    def is_complete(self, index: int) -> bool:
        """Return whether a chunk need not be run."""
        return False

    def finish(self) -> None:
        """Check that every chunk has been written."""

    def remove_empty(self) -> None:
        """Remove a store without any chunk, for example after a lack of memory."""

    def dataset(self) -> "xarray.Dataset":
        """Return the ensemble."""
        from xarray import Dataset

        return self.labelled(Dataset(self.arrays, attrs=self.attributes))

    def missing(self) -> list[int]:
        """List the chunks that are to be run."""
        return [
            k for k in range(-(-self.members // self.chunk)) if not self.is_complete(k)
        ]

    def labelled(self, data: "xarray.Dataset") -> "xarray.Dataset":
        """Return a Dataset with sampled parameters as coordinates, those of a grid as its index."""
        from xarray.indexes import PandasMultiIndex

        keys = self.arguments["keys"]
        data = data.set_coords(keys)[sorted(map(str, data.variables))]
        if KERNEL in keys:
            data[KERNEL] = data[KERNEL].astype(object)
        scalars = all(data[key].ndim == 1 for key in keys)
        if self.arguments["design"] == "grid" and scalars:
            data = data.drop_vars("member").set_xindex(keys, PandasMultiIndex)
        return data
