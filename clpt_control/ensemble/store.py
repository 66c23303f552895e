"""The store of an ensemble: a Zarr folder, written chunk by chunk.

A chunk is a fixed range of members.  Its arrays are written first, its flag in `done` last.  A
chunk without its flag, or with a file that is missing or fails the checksum of Zarr, is run again,
so an ensemble may be killed at any time and continued.  The folder is created under a temporary
name and renamed when it is complete.

Attributes and layouts have digests.  A store that was changed, or has more arrays, is refused
before anything is written into it or displayed.
"""

import hashlib
import json
import shutil
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ..base.errors import DataError, import_optional
from ..base.files import atomic_path
from ..base.files.reading import SLASH, renamed, zarr_store
from .members import Values
from .results import ARGUMENTS, CODE, Results

if TYPE_CHECKING:
    import xarray

DIGESTS, DONE = "digests", "done"


class Store(Results):
    """An ensemble's arrays in a folder."""

    def __init__(self, group: Any, path: Path):
        import zarr

        self.group, self.path = group, path
        with (
            warnings.catch_warnings(),
            # a file that is missing is then no chunk of NaN
            zarr.config.set({"array.write_empty_chunks": True}),
        ):
            warnings.simplefilter("ignore")  # of files that are not arrays
            self.stored = dict(sorted(group.members()))
        arrays = {name.replace(SLASH, "/"): node for name, node in self.stored.items()}
        super().__init__(group.attrs, arrays)

    def dims_of(self, array: Any) -> tuple[str, ...]:
        """Return the dimensions of an array, none of a group."""
        return getattr(array.metadata, "dimension_names", None) or ()

    def write(self, index: int, arrays: Values) -> None:
        """Write a chunk, then its flag."""
        try:
            super().write(index, arrays)
            self.arrays[DONE][index] = 1
        except OSError as error:
            path, reason = error.filename2 or self.path, error.strerror or error
            raise DataError(f"{path}: cannot be written: {reason}") from None

    def digests(self) -> dict[str, str]:
        """Return a hash of the attributes, and of the layout of each array."""
        attributes = [item for item in self.attributes.items() if item[0] != DIGESTS]
        facts: dict[str, Any] = {"zarr.json": sorted(attributes)}
        facts |= {name: node.metadata.to_dict() for name, node in self.stored.items()}
        return {
            name: hashlib.sha256(repr(fact).encode()).hexdigest()[:16]
            for name, fact in facts.items()
        }

    def changed(self) -> list[str]:
        """List the arrays whose layout, or numbers outside of chunks, are not as they were made."""
        made, now = json.loads(self.attributes[DIGESTS]), self.digests()
        wrong = {name for name in {*made, *now} if made.get(name) != now.get(name)}
        for name in self.arrays.keys() - {*wrong, *self.per_member, DONE}:
            count = self.arrays[name].cdata_shape[0]
            if not wrong and not all(self.is_whole(name, k) for k in range(count)):
                wrong.add(name)
        return sorted(wrong)

    def is_whole(self, name: str, index: int) -> bool:
        """Return whether a chunk of an array is there; raise an error if its checksum is wrong."""
        array = self.arrays[name]
        if not array.size:
            return True
        array.blocks[index]  # read, with the checksum
        key = array.metadata.encode_chunk_key((index, *[0] * (array.ndim - 1)))
        return Path(self.path, array.path, key).is_file()

    def is_complete(self, index: int) -> bool:
        """Return True if a chunk has been written and can be read."""
        try:
            return bool(self.arrays[DONE][index]) and all(
                self.is_whole(name, index) for name in self.per_member
            )
        except Exception:  # a damaged file can raise anything
            return False

    def finish(self) -> None:
        """Check that every chunk has been written; remove temporary files of killed writers."""
        lost = np.flatnonzero(self.arrays[DONE][:] == 0)
        if len(lost):
            raise DataError(
                f"{self.path}: chunk {lost[0]} is missing. Run the ensemble again"
            )
        for temporary in self.path.rglob("*.partial"):
            temporary.unlink(missing_ok=True)

    def dataset(self) -> "xarray.Dataset":
        """Return the ensemble, whose arrays are read when used."""
        import xarray

        data = xarray.open_zarr(
            self.group.store,
            chunks=None,
            consolidated=False,
            decode_times=False,
            decode_timedelta=False,
        )
        data = self.labelled(renamed(data.drop_vars(DONE), SLASH, "/"))
        data.encoding["folder"] = str(self.path.absolute().parent)
        return data

    def remove_empty(self) -> None:
        """Remove the folder if it has no chunk."""
        if not np.any(self.arrays[DONE][:]):
            shutil.rmtree(self.path, ignore_errors=True)


def begun_or_made(
    path: Path | None,
    attributes: Mapping[str, Any],
    arrays: "Mapping[str, xarray.Variable]",
) -> Results:
    """Open the store of the same ensemble, begun by the same code, or make arrays or a store."""
    if path is None:
        copies = {name: one.copy(deep=True) for name, one in arrays.items()}
        return Results(attributes, copies)
    if not path.exists() or (path.is_dir() and not any(path.iterdir())):
        return create_store(path, attributes, arrays)
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
    flags = np.zeros(-(-arguments["members"] // chunk), "int8")
    done = Variable("chunk", flags, {"long_name": "1 if the chunk is written"})
    with atomic_path(path, folder=True) as folder:
        group = zarr.create_group(folder)
        group.attrs.update(attributes)
        for name, variable in {**variables, DONE: done}.items():
            if not name or "\\" in name:
                raise DataError(f"Zarr has no name {name!r}. Rename it, without a \\")
            size, *inner_sizes = variable.shape
            rows = {"member": chunk, "chunk": 1}.get(str(variable.dims[0]), size)
            array = group.create_array(
                name.replace("/", SLASH),
                shape=variable.shape,
                dtype=str if variable.dtype.kind == "U" else variable.dtype,
                chunks=tuple(max(1, n) for n in (min(rows, size), *inner_sizes)),
                attributes=variable.attrs,
                dimension_names=[str(dim).replace("/", SLASH) for dim in variable.dims],
                fill_value=np.nan
                if variable.dtype.kind == "f"
                else variable.dtype.type(),
                compressors=(ZstdCodec(level=1), Crc32cCodec()),
                config={"write_empty_chunks": True},
            )
            is_coordinate = variable.dims == (name,) or name in arguments["keys"]
            if is_coordinate and variable.size:
                array[:] = variable.values
        made = Store(zarr.open_group(folder), folder)
        group.attrs[DIGESTS] = json.dumps(made.digests())
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
        changed = store.changed()
    except Exception:  # a damaged file can raise anything
        raise DataError(
            f"{path}: is not an ensemble or is damaged. Give another name or remove it"
        ) from None
    if changed:
        raise DataError(
            f"{path}: is damaged, or of another version: its {changed[0]} is not as it was "
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
        written = np.flatnonzero(store.arrays[DONE][:]).tolist()
    except Exception:  # a damaged file can raise anything
        raise DataError(
            f"{path}: is damaged: a part of it cannot be read. Run the ensemble again"
        ) from None
    if lost := [chunk for chunk in written if not store.is_complete(chunk)]:
        raise DataError(
            f"{path}: is damaged: chunk {lost[0]} is not as written. Run the ensemble again"
        )
    return data
