"""Results of an ensemble: arrays that are written chunk by chunk, and their Dataset.

A chunk is a fixed range of members.  The arrays are in memory; those of a `Store` are in a folder.
"""

import json
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.errors import ScenarioError
from ..engine.solver.solver_layout import Status
from ..simulation.dataset_template import index_of, variable_of
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
        arrays[name] = variable_of(Variable, tuple(dims), numbers, attributes)

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


class EnsembleResults:
    """Arrays of an ensemble by name, in memory; chunks of members are written into them."""

    path: Any = None
    variables: "Mapping[str, xarray.Variable]"

    def __init__(
        self,
        attributes: Mapping[str, Any],
        arrays: Mapping[str, Any],
        dims: Mapping[str, tuple[str, ...]],
    ):
        self.attributes, self.arrays, self.dims = attributes, arrays, dims
        self.arguments: dict[str, Any] = json.loads(attributes[ARGUMENTS])
        self.members, self.chunk = self.arguments["members"], self.arguments["chunk"]
        summaries = dims.keys() - {"member", *self.arguments["keys"]}
        self.per_member = sorted(name for name in summaries if "member" in dims[name])

    @classmethod
    def in_memory(
        cls, attributes: Mapping[str, Any], variables: "Mapping[str, xarray.Variable]"
    ) -> "EnsembleResults":
        """Return arrays without the numbers of any chunk."""
        copies = {name: variable.copy() for name, variable in variables.items()}
        arrays = {name: variable.values for name, variable in copies.items()}
        dims = {name: tuple(map(str, copy.dims)) for name, copy in copies.items()}
        results = cls(attributes, arrays, dims)
        results.variables = copies
        return results

    def rows(self, index: int) -> slice:
        """Return the members of a chunk."""
        return slice(index * self.chunk, min((index + 1) * self.chunk, self.members))

    def count(self, indices: Iterable[int]) -> int:
        """Return the number of members of some chunks."""
        return sum(rows.stop - rows.start for rows in map(self.rows, indices))

    def values(self, index: int) -> Values:
        """Return the sampled parameters of the members of a chunk."""
        return {
            key: self.arrays[key][self.rows(index)] for key in self.arguments["keys"]
        }

    def write(self, index: int, summaries: Values) -> None:
        """Write the summaries of a chunk."""
        for name in self.per_member:
            if summaries[name].size:
                self.arrays[name][self.rows(index)] = summaries[name]

    def missing(self) -> list[int]:
        """List the chunks that are to be run."""
        return [
            k for k in range(-(-self.members // self.chunk)) if not self.is_complete(k)
        ]

    def is_complete(self, index: int) -> bool:
        """Return True if a chunk has been written before."""
        return False

    def finish(self) -> None:
        """Check that every chunk has been written."""

    def remove_empty(self) -> None:
        """Remove a folder without any chunk, for example after a lack of memory."""

    def dataset(self) -> "xarray.Dataset":
        """Return the ensemble."""
        return labelled(self.variables, self.arguments, self.attributes)


def labelled(
    variables: "Mapping[str, xarray.Variable]",
    arguments: Mapping[str, Any],
    attributes: Mapping[str, Any],
) -> "xarray.Dataset":
    """Return a Dataset: sampled parameters are coordinates, those of a grid its index.

    xarray's constructor would search and align the indexes, which takes longer.
    """
    from xarray import Dataset
    from xarray.indexes import PandasMultiIndex

    keys = arguments["keys"]
    by_name = {name: variables[name] for name in sorted(variables)}
    if KERNEL in keys:
        by_name[KERNEL] = by_name[KERNEL].astype(object)
    # 1. an index of each dimension
    indexes: dict[Any, Any] = {}
    axes = [name for name, variable in by_name.items() if variable.dims == (name,)]
    if arguments["design"] == "grid" and all(by_name[key].ndim == 1 for key in keys):
        axes.remove("member")
        levels = {key: by_name[key] for key in keys}
        index = PandasMultiIndex.from_variables(levels, options={})
        by_name |= index.create_variables(levels)
        indexes |= dict.fromkeys(["member", *keys], index)
    for name in axes:
        axis = by_name[name]
        indexes[name], by_name[name] = index_of(name, axis.values, axis.attrs)
    # 2. the Dataset
    sizes = {
        dim: size
        for variable in by_name.values()
        for dim, size in zip(variable.dims, variable.shape, strict=True)
    }
    coordinates = {*indexes, *keys}
    return Dataset._construct_direct(
        by_name, coordinates, sizes, dict(attributes), indexes, {}
    )
