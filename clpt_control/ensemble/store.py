"""The store of an ensemble: a Zarr folder, written chunk by chunk.

A chunk is a fixed range of members.  Its arrays are written first, their checksum last, in `done`.
A chunk without a checksum, or with a wrong one, is run again, so an ensemble may be killed at any
time and continued.  The folder is created under a temporary name and renamed when it is complete.

Attributes, layouts and coordinates have digests.  A store that was changed, or has more files, is
refused before anything is written into it or displayed.
"""

import hashlib
import json
import shutil
import warnings
import zlib
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from ..base.errors import DataError, import_optional
from ..base.files import atomic_path
from ..base.files.reading import LARGEST, SLASH, renamed, zarr_store
from .members import Values
from .results import ARGUMENTS, CODE, EnsembleResults, labelled

if TYPE_CHECKING:
    import xarray

DIGESTS, DONE = "digests", "done"


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
        recorded: dict[str, str] = json.loads(store.group.attrs[DIGESTS])
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
