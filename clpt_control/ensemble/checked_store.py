"""A store that is what its arguments say: asked before it is gone on with, and before it is shown.

Scenario, keys, members, samples and times make the arrays of an ensemble.  A store that holds
others, or more, is refused before anything in it is written.
"""

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import ClptError, DataError
from ..scenario.experiment import Scenario
from ..scenario.file import tables_of
from .store import DONE, REPEATED, Store, layout_of, open_store, software
from .summaries import STATUS, Array, arrays_of, marks_of, sample_times_of, samples_per_cycle
from .varied_keys import VariedScenario, check_varies, parsed

if TYPE_CHECKING:
    import xarray


def check_store(store: Store, arrays: Mapping[str, Array]) -> bool:
    """Refuse a store that is not as `create_store` makes it of these arrays.

    Returns whether an older version made it, which knew fewer ways in which a member can end.
    """
    layout, older = layout_of(store.arguments, arrays), False
    if foreign := store.names - layout.keys():
        raise DataError(f"{store.path}: holds {min(foreign)}, which is no part of it; take it out")
    for name, made in layout.items():
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
            if name == "status" and _fewer(found["attributes"], wanted["attributes"]):
                older, wanted["attributes"] = True, found["attributes"]
            wrong = next((what for what in made if found[what] != wanted[what]), "")
            values = arrays[name].values if name in arrays else None
            if not wrong and values is not None and not np.array_equal(array[:], values):
                wrong = "values"
        except Exception:  # a damaged file can raise anything
            wrong = "files"
        if wrong and (made_by := store.group.attrs.get("software")) != software():
            raise DataError(
                f"{store.path}: {name} has other {wrong.replace('_', ' ')} than this version "
                f"writes; it was written by {made_by!s:.200}: read it with that, or run it again"
            )
        if wrong:
            raise DataError(
                f"{store.path}: is damaged: {name} has lost its {wrong.replace('_', ' ')}; move it "
                "away and run the ensemble again"
            )
    return older


def _fewer(found: Mapping[str, Any], wanted: Mapping[str, Any]) -> bool:
    """Whether attributes are those of `wanted`, with the first of its flags alone."""
    meanings = str(found.get("flag_meanings")).split()
    known = {"flag_meanings": " ".join(meanings), "flag_values": list(range(len(meanings)))}
    first = str(wanted["flag_meanings"]).split()[: len(meanings)]
    return meanings == first and found != wanted and found == {**wanted, **known}


@contextmanager
def _damaged(path: Path, what: str) -> Iterator[None]:
    try:
        yield
    except Exception:  # a damaged file can raise anything
        raise DataError(f"{path}: is damaged: {what}; run the ensemble again") from None


def open_ensemble(path: Path) -> "xarray.Dataset":
    """Return the ensemble of a folder, whole or begun, checked; trajectories are read when used."""
    store = open_store(path, mode="r")
    if "diagram" in store.arguments:
        raise DataError(f"{path}: is an ensemble of a diagram, not of a scenario, and has no page")
    with _damaged(path, "what was asked of it does not fit what it holds"):
        arrays = _arrays_asked(store)
    check_store(store, arrays)
    with _damaged(path, "a part of it cannot be read"):
        data = store.dataset()
        for array in data.variables.values():
            if "time" not in array.dims:
                array.load()
        done = store.group[DONE][:]
    for chunk in np.flatnonzero(done).tolist():
        kept = {name: data[name].values for name in store.kept if "time" not in data[name].dims}
        first, last = store.range(chunk)
        if store.checksum({name: one[first:last] for name, one in kept.items()}) != done[chunk]:
            raise DataError(f"{path}: is damaged: chunk {chunk} is not as it was written")
    if not np.isin(data["status"], range(len(STATUS))).all():
        raise DataError(f"{path}: is damaged: status holds numbers that no end of a run has")
    return data


def _arrays_asked(store: Store) -> dict[str, Array]:
    """Return the arrays that a store's arguments make; raises anything where they do not fit."""
    asked, held = store.arguments, store.group
    scenario = Scenario.model_validate(tables_of(asked["scenario"], ""), context={"name": ""})
    keys, varied, varies = asked["keys"], VariedScenario(scenario), parsed(asked["vary"])
    check_varies(varied, varies)
    values = {key: held[key] for key in keys}
    fits = [one.key for one in varies] == keys
    fits &= all(held.attrs[name] == asked[name] for name in REPEATED)
    fits &= all(
        one.shape == (store.members, *varied.values[key].shape) for key, one in values.items()
    )
    fits &= held[DONE].shape == (-(-store.members // store.chunk),)
    if not fits:
        raise ClptError
    values = {key: one[:] for key, one in values.items()}
    if not all(np.isfinite(one).all() for one in values.values()):
        raise ClptError
    trajectories, marks = asked["trajectories"], marks_of(scenario, asked["times"])
    per_cycle = samples_per_cycle(scenario, asked["samples"])
    times = sample_times_of(scenario, per_cycle, marks, trajectories)
    return arrays_of(scenario, times, values, trajectories)
