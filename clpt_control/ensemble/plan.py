"""An ensemble before it runs: all arguments checked, its store made or opened."""

from collections.abc import Iterable, Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ..diagrams.changes import UNCHANGED
from ..errors import DataError, ScenarioError
from ..files import check_name, check_writable
from ..scenario.experiment import Scenario
from ..scenario.file import scenario_to_text
from ..simulation.loops import LoopOf
from .drawn_values import draw_members
from .store import CODE, Store, check_store, create_store, open_store
from .summaries import dims_of, kept_variables, marks_of, samples_per_cycle
from .varied_keys import Vary, read_varies
from .worker import Recipe, Worker, checked, named, pickled

CHUNK = 1000  # members, where no trajectories are kept
CHUNK_BYTES = 64_000_000  # trajectories of a chunk


class Request(NamedTuple):
    """What `run_ensemble` is asked for."""

    loop: LoopOf
    vary: "str | Vary | Iterable[str | Vary]"
    members: int
    design: str = "lhs"
    seed: int = 0
    out: str | Path | None = None
    trajectories: bool = False
    chunk: int | None = None
    samples: int | None = None
    times: Sequence[float] | None = None
    cluster: bool = False


class Plan(NamedTuple):
    """Who runs members, and where they are kept."""

    worker: Worker
    store: Store


def make_plan(asked: Request) -> Plan:
    """Check what is asked for; make the store, or open one that holds a part."""
    scenario, chunk = asked.loop.scenario, asked.chunk
    changes = checked(asked.loop.changes, scenario)
    varies = read_varies(scenario, asked.vary)
    marks, per_cycle = marks_of(scenario, asked.times), samples_per_cycle(scenario, asked.samples)
    path = None if asked.out is None else Path(asked.out).absolute()
    if path is not None:
        check_name(path)
    if path is not None and not path.exists():
        check_writable(path)
    values = draw_members(scenario, varies, asked.members, asked.design, asked.seed)
    members, trajectories = int(asked.members), bool(asked.trajectories)
    shapes = tuple((key, array.shape[1:]) for key, array in values.items())
    folder = scenario._folder.absolute()
    recipe = Recipe(
        scenario_to_text(scenario),
        str(folder),
        shapes,
        per_cycle,
        marks,
        trajectories,
        b"" if changes == UNCHANGED else pickled(changes, asked.cluster),
    )
    worker = Worker(recipe)
    kept = kept_variables(worker.scenario, worker.times, members, trajectories)
    own = sum(8 * int(np.prod(v.shape[1:])) for v in kept.values() if "time" in v.dims)
    if chunk is None:
        chunk = max(1, min(CHUNK, CHUNK_BYTES // own)) if own else CHUNK
    if not isinstance(chunk, int) or isinstance(chunk, bool) or chunk < 1:
        raise ScenarioError(f"chunk = {chunk}: must be a whole number, at least 1")
    arguments = {
        "scenario": scenario_to_text(scenario, None if path is None else path.parent),
        "vary": [one.text for one in varies],
        "keys": [one.key for one in varies],
        "members": members,
        "design": asked.design,
        "seed": int(asked.seed),
        "chunk": min(chunk, members),
        "trajectories": trajectories,
        "samples": per_cycle,
        "times": list(marks),
        "law": named(changes),
    }
    fixed = _fixed(worker, values, members, kept)
    if path is not None and path.exists() and not (path.is_dir() and not any(path.iterdir())):
        store = open_store(path)
        check_same(store, arguments)
        check_store(store, arguments, kept, fixed)
        if store.group.attrs[CODE] != worker.code and store.missing():
            raise DataError(
                f"{path}: was begun by other versions of the code ({store.group.attrs['software']})"
                ", whose numbers may differ in the last bit; give another --out"
            )
        return Plan(worker, store)
    attrs = {**_attributes(scenario, arguments), CODE: worker.code}
    return Plan(worker, create_store(path, arguments, kept, fixed, attrs))


def _fixed(
    worker: Worker, values: dict[str, np.ndarray], members: int, kept: Any
) -> dict[str, Any]:
    """Return coordinates and the members' values."""
    times, time = worker.times, worker.scenario.units.time
    used = {dim for variable in kept.values() for dim in variable.dims}
    fixed: dict[str, Any] = {}
    for key, array in values.items():
        dims = ("member", *dims_of(key, array.ndim - 1))
        used |= set(dims)
        fixed[key] = (dims, array, {"long_name": f"{key}, which varies"})
    cycle = np.arange(1, len(times.starts))
    coordinates = {
        "member": (np.arange(members), {"long_name": "member of the ensemble"}),
        "cycle": (cycle, {"long_name": "round of the waypoints", "length": worker.scenario.cycle}),
        "mark": (times.all[times.marks], {"long_name": "time of an error", "units": time}),
        "time": (
            times.all[times.own],
            {"long_name": "time since the start of the run", "units": time},
        ),
        "axis": (np.array([1, 2]), {"long_name": "axis of the plane, x1 and x2"}),
        "basis": (np.arange(1, worker.scenario.basis.N + 1), {"long_name": "flow basis function"}),
        "waypoint": (np.arange(1, len(worker.scenario.waypoints) + 1), {"long_name": "waypoint"}),
    }
    for name, (numbers, attrs) in coordinates.items():
        if name in used and numbers.size:
            fixed[name] = ((name,), numbers, attrs)
    return fixed


def _attributes(scenario: Scenario, arguments: dict[str, Any]) -> dict[str, Any]:
    software = ("clpt-control", "llvmlite", "numpy", "scipy", "zarr")
    return {
        "Conventions": "CF-1.11",
        "title": scenario.title,
        "source": f"clpt-control {version('clpt-control')}",
        "software": ", ".join(f"{name} {version(name)}" for name in software),
        **{name: arguments[name] for name in ("scenario", "vary", "design", "seed", "samples")},
    }


def check_same(store: Store, arguments: Mapping[str, Any]) -> None:
    """Refuse a store of another ensemble."""
    for name, value in arguments.items():
        held = store.arguments.get(name)
        if held == value:
            continue
        what = "another scenario" if name == "scenario" else f"{name} = {_shown(held)}"
        wanted = "" if name == "scenario" else f", not {_shown(value)}"
        raise DataError(f"{store.path}: holds an ensemble of {what}{wanted}; give another --out")


def _shown(value: Any) -> str:
    text = ", ".join(map(str, value)) if isinstance(value, list) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."
