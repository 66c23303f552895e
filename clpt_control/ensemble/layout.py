"""How an ensemble's arrays lie in a store, and whether a store has them so."""

import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..errors import DataError
from .summary import Variable

MARK = "done"
Fixed = tuple[tuple[str, ...], np.ndarray, dict[str, Any]]


def layout_of(
    arguments: Mapping[str, Any], kept: Mapping[str, Variable], fixed: Mapping[str, Fixed]
) -> dict[str, dict[str, Any]]:
    """Return how each array is laid out.

    Parameters
    ----------
    arguments : mapping
        What the ensemble is: its ``members`` and their ``chunk``.
    kept : mapping
        The arrays that chunks fill.
    fixed : mapping
        Coordinates and the members' values: name -> (dims, values, attributes).

    Returns
    -------
    dict
        Name -> what `zarr.Group.create_array` takes.
    """
    chunk, members = arguments["chunk"], arguments["members"]
    layout = {}

    def lay(name, dims, shape, dtype, own, first_chunk):
        chunks = tuple(max(1, n) for n in (min(first_chunk, shape[0]), *shape[1:]))
        layout[name] = {
            "shape": tuple(shape),
            "dtype": dtype,
            "chunks": chunks,
            "attributes": own,
            "dimension_names": dims,
        }

    for name, variable in kept.items():
        own = {**variable.attrs, "kept": "per member"}
        lay(name, variable.dims, variable.shape, variable.dtype, own, chunk)
    for name, (dims, values, own) in fixed.items():
        size = chunk if dims[0] == "member" else len(values)
        lay(name, dims, values.shape, values.dtype, own, size)
    count = -(-members // chunk)
    lay(MARK, ("chunk",), (count,), "int64", {"long_name": "checksum of a whole chunk"}, 1)
    return layout


def check_store(
    store: Any,
    arguments: Mapping[str, Any],
    kept: Mapping[str, Variable],
    fixed: Mapping[str, Fixed],
) -> None:
    """Refuse a store that is not as `create_store` makes it.

    Parameters
    ----------
    store : Store
        As `open_store` gives it.
    arguments, kept, fixed : mapping
        As `create_store` takes them.

    Raises
    ------
    DataError
        Naming the first array that is missing, of another kind or unreadable.
    """
    for name, made in layout_of(arguments, kept, fixed).items():
        wrong = ""
        try:
            array = store.group[name]
            found = {
                "shape": array.shape,
                "dtype": array.dtype,
                "chunks": array.chunks,
                "attributes": dict(array.attrs),
                "dimension_names": array.metadata.dimension_names,
            }
            wanted = {**made, "attributes": json.loads(json.dumps(made["attributes"]))}
            wrong = next((what for what in made if found[what] != wanted[what]), "")
            if not wrong and name in fixed and not np.array_equal(array[:], fixed[name][1]):
                wrong = "values"
        except Exception:  # whatever a damaged file makes of itself
            wrong = "files"
        if wrong:
            raise DataError(
                f"{store.path}: is damaged: {name} has lost its {wrong.replace('_', ' ')}; move it "
                "away and run the ensemble again"
            )
