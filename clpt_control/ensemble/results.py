"""Results of an ensemble: arrays that are written chunk by chunk, and their Dataset.

A chunk is a fixed range of members.  The arrays are in memory; those of a `Store` are in a Zarr
folder.  Its arrays of a chunk are written first, their checksum last, in `done`.  A chunk without a
checksum, or with a wrong one, is run again, so an ensemble may be killed at any time and continued.
The folder is created under a temporary name and renamed when it is complete.

Attributes, layouts and coordinates have digests.  A store that was changed, or has more files, is
refused before anything is written into it or displayed.
"""

import hashlib
import json
import shutil
import warnings
import zlib
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ..base.errors import DataError, ScenarioError, import_optional
from ..base.files import atomic_path
from ..base.files.reading import LARGEST, SLASH, renamed, zarr_store
from ..base.run_attributes import versions
from ..engine.solver.solver_layout import Status
from ..simulation.dataset_template import index_of, variable_of
from .members import KERNEL, SOFTWARE, Values, Varied, member_count

if TYPE_CHECKING:
    import xarray

ARGUMENTS, CODE = "ensemble", "code"
DIGESTS, DONE = "digests", "done"  # of a folder
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
    arrays = {}

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
        "source": versions(SOFTWARE[0]),
        "software": versions(*SOFTWARE),
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


# --- in a folder ---------------------------------------------------------------------------------


class Store(EnsembleResults):
    """Arrays of an ensemble in a folder."""

    def __init__(self, group: Any, path: Path):
        self.group, self.path = group, path
        with warnings.catch_warnings():
            # files that are not arrays are found by their digest
            warnings.simplefilter("ignore")
            self.names = {name for name, _ in group.members()}
            arrays = {name.replace(SLASH, "/"): array for name, array in group.arrays()}
        dims = {
            name: array.metadata.dimension_names or () for name, array in arrays.items()
        }
        super().__init__(group.attrs, arrays, dims)

    def write(self, index: int, summaries: Values) -> None:
        """Write the summaries of a chunk, then their checksum."""
        try:
            super().write(index, summaries)
            self.group[DONE][index] = self.checksum(summaries)
        except OSError as error:
            path, reason = error.filename2 or self.path, error.strerror or error
            raise DataError(f"{path}: cannot be written: {reason}") from None

    def checksum(self, arrays: Values) -> int:
        """Return a checksum of a chunk, above zero."""
        check = 0
        for name in self.per_member:
            check = zlib.crc32(np.ascontiguousarray(arrays[name]).data, check)
        return check + 1

    def digests(self) -> dict[str, str]:
        """Return a hash of the attributes, and of each array without the values of chunks."""
        attributes = {
            name: value for name, value in self.group.attrs.items() if name != DIGESTS
        }
        contents: dict[str, Any] = {"zarr.json": sorted(attributes.items())}
        for name in sorted(self.names):
            contents[name] = value = self.group[name]
            with suppress(Exception):  # a damaged file can raise anything
                filled = name.replace(SLASH, "/") in (*self.per_member, DONE)
                too_large = value.nbytes > LARGEST or value.nchunks > max(
                    1, self.members
                )
                numbers = None
                if not filled and not too_large:
                    read = value[:]
                    # strings of any length are no bytes of the array
                    read = read.astype("U99") if read.dtype.kind == "T" else read
                    numbers = zlib.crc32(read.tobytes())
                contents[name] = value.metadata.to_dict(), numbers
        return {
            k: hashlib.sha256(repr(value).encode()).hexdigest()[:16]
            for k, value in contents.items()
        }

    def is_complete(self, index: int) -> bool:
        """Return True if a chunk has been written and its checksum is right."""
        try:
            checksum = int(self.group[DONE][index])
            if not checksum:
                return False
            read = {
                name: self.arrays[name][self.rows(index)] for name in self.per_member
            }
        except Exception:  # a damaged file can raise anything
            return False
        return self.checksum(read) == checksum

    def finish(self) -> None:
        """Check that every chunk has been written; remove temporary files of killed writers."""
        lost = np.flatnonzero(self.group[DONE][:] == 0)
        if len(lost):
            raise DataError(
                f"{self.path}: chunk {lost[0]} is missing. Run the ensemble again"
            )
        for temporary in self.path.rglob("*.partial"):
            temporary.unlink(missing_ok=True)

    def dataset(self) -> "xarray.Dataset":
        """Return the ensemble, whose arrays are read when used."""
        import xarray

        stored = xarray.open_zarr(
            self.group.store,
            chunks=None,
            consolidated=False,
            decode_times=False,
            decode_timedelta=False,
        )
        variables: Any = renamed(stored.drop_vars(DONE), SLASH, "/").variables
        data = labelled(variables, self.arguments, stored.attrs)
        data.encoding["folder"] = str(self.path.absolute().parent)
        return data

    def remove_empty(self) -> None:
        """Remove the folder if it has no chunk."""
        if not np.any(self.group[DONE][:]):
            shutil.rmtree(self.path, ignore_errors=True)


def begun_or_made(
    path: Path | None,
    attributes: Mapping[str, Any],
    variables: "Mapping[str, xarray.Variable]",
) -> EnsembleResults:
    """Open the store of the same ensemble, begun by the same code, or make one, or use memory."""
    if path is None:
        return EnsembleResults.in_memory(attributes, variables)
    if not path.exists() or (path.is_dir() and not any(path.iterdir())):
        return create_store(path, attributes, variables)
    store = open_store(path)
    for name, value in json.loads(attributes[ARGUMENTS]).items():
        if store.arguments.get(name) != value:
            raise DataError(
                f"{path}: contains an ensemble of another {name}. Give another --out"
            )
    if store.attributes[CODE] != attributes[CODE] and store.missing():
        raise DataError(
            f"{path}: was started by other versions of the code ({store.attributes['software']})"
            ", whose results may differ in the last bit. Give another --out"
        )
    return store


def create_store(
    path: Path,
    attributes: Mapping[str, Any],
    variables: "Mapping[str, xarray.Variable]",
) -> Store:
    """Make a store without any chunk in a folder."""
    zarr = import_optional("zarr")
    from xarray import Variable
    from zarr.codecs import Crc32cCodec, ZstdCodec

    arguments = json.loads(attributes[ARGUMENTS])
    chunk = arguments["chunk"]
    count = -(-arguments["members"] // chunk)
    words = {"long_name": "checksum of a whole chunk"}
    checksums = Variable("chunk", np.zeros(count, "int64"), words)
    with atomic_path(path, folder=True) as folder:
        group = zarr.create_group(folder)
        group.attrs.update(attributes)
        for name, stored in {**variables, DONE: checksums}.items():
            if not name or "\\" in name:
                raise DataError(f"Zarr has no name {name!r}. Rename it, without a \\")
            size, *inner_sizes = stored.shape
            rows = {"member": chunk, "chunk": 1}.get(str(stored.dims[0]), size)
            array = group.create_array(
                name.replace("/", SLASH),
                shape=stored.shape,
                dtype=str if stored.dtype.kind == "U" else stored.dtype,
                chunks=tuple(max(1, n) for n in (min(rows, size), *inner_sizes)),
                attributes=stored.attrs,
                dimension_names=[str(dim).replace("/", SLASH) for dim in stored.dims],
                fill_value=np.nan if stored.dtype.kind == "f" else stored.dtype.type(),
                compressors=(ZstdCodec(level=1), Crc32cCodec()),
            )
            if stored.dims == (name,) or (name in arguments["keys"] and stored.size):
                array[:] = stored.values
        empty_store = Store(zarr.open_group(folder), folder)
        group.attrs[DIGESTS] = json.dumps(empty_store.digests())
    return Store(zarr.open_group(path, mode="r+"), path)


def open_store(path: Path, mode: Literal["r", "r+"] = "r+") -> Store:
    """Open a store to write the missing chunks, or with "r" to read it."""
    zarr = import_optional("zarr")
    if not path.exists():
        raise DataError(
            f"{path}: folder not found. Make an ensemble with: clpt ensemble"
        )
    if not path.is_dir():
        raise DataError(f"{path}: is a file; must be a folder such as ensemble.zarr")
    if not (path / "zarr.json").is_file():
        raise DataError(f"{path}: is a folder without an ensemble. Give another name")
    files = zarr_store(path, read_only=mode == "r")
    try:
        store = Store(zarr.open_group(files, mode=mode), path)
        recorded = json.loads(store.group.attrs[DIGESTS])
        now = store.digests()
        wrong = [
            name
            for name in sorted({*recorded, *now})
            if recorded.get(name) != now.get(name)
        ]
    except Exception:  # a damaged file can raise anything
        raise DataError(
            f"{path}: is not an ensemble or is damaged. Give another name or remove it"
        ) from None
    if wrong and wrong[0] not in recorded:
        raise DataError(
            f"{path}: contains {wrong[0]}, which is not part of an ensemble. Remove it"
        )
    if wrong:
        raise DataError(
            f"{path}: is damaged, or of another version: its {wrong[0]} is not as it was "
            "made. Move it away and run the ensemble again"
        )
    return store


def open_ensemble(path: Path) -> "xarray.Dataset":
    """Return the ensemble of a folder, complete or not; trajectories are read when used."""
    store = open_store(path, mode="r")
    data = store.dataset()
    try:
        for array in data.variables.values():
            if "time" not in array.dims:
                array.load()
        written = np.flatnonzero(store.group[DONE][:]).tolist()
    except Exception:  # a damaged file can raise anything
        raise DataError(
            f"{path}: is damaged: a part of it cannot be read. Run the ensemble again"
        ) from None
    if lost := [chunk for chunk in written if not store.is_complete(chunk)]:
        raise DataError(
            f"{path}: is damaged: chunk {lost[0]} is not as written. Run the ensemble again"
        )
    return data
