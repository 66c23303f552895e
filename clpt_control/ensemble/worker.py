"""Members run and summarised, in the same way by a thread and by a far machine.

A recipe is plain text and numbers, and parts of the user's own, pickled; it is all that
travels.  A worker makes the compiled ensemble of it once and then summarises any members
it is given.
"""

import hashlib
import json
import pickle
import threading
from collections.abc import Mapping, Sequence
from functools import cached_property, lru_cache
from importlib.metadata import version
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ..diagrams.changes import LAW, UNCHANGED, Changes
from ..diagrams.parts import functions_of
from ..equations.block import Block
from ..errors import DiagramError
from ..scenario.experiment import Scenario
from ..scenario.file import scenario_from_text, scenario_to_text
from ..simulation.loops import changed_blocks, loop_of
from ..simulation.starts import state_columns
from .members import Ensemble, Members, ScenarioEnsemble, States
from .summaries import (
    Array,
    arrays_of,
    marks_of,
    sample_times_of,
    samples_per_cycle,
    summarise_members,
)
from .varied_keys import VariedScenario

BATCH_BYTES = 64_000_000  # states in flight, a thread
MOST_MEMBERS = 512  # a batch


class Recipe(NamedTuple):
    """All that a worker of a scenario needs to know."""

    text: str  # the scenario as TOML
    folder: str  # where a relative flow.field starts from
    keys: tuple[str, ...]  # what varies
    samples: int  # a cycle, for mean squares
    marks: tuple[float, ...]  # when errors are kept
    trajectories: bool  # whether states are kept too
    changes: bytes = b""  # parts of the user's own, pickled

    def worker(self) -> "Worker":
        """Return the worker that members are run by."""
        return ScenarioWorker(self)


def pickled(made: Any, name: str, cluster: bool) -> bytes:
    """Return parts of the user's own as workers take them; a cluster's get their equations too."""
    try:
        if cluster:  # equations of a script or a notebook go along
            from distributed.protocol.pickle import dumps

            return bytes(dumps(made))
        return pickle.dumps(made)
    except (pickle.PicklingError, AttributeError, TypeError):
        raise DiagramError(
            f"{name}: cannot be sent to workers; define equations and parameters at the top of a "
            "module"
        ) from None


def named(changes: Changes) -> str | None:
    """Return a name for blocks of the user's own, their numbers and their equations."""
    places = [name if name != LAW else "" for name in changes.replace]
    places += [str(where) for where in changes.insert]
    blocks = (*changes.replace.values(), *changes.insert.values())
    return "; ".join(map(_of_block, places, blocks)) or None


def _of_block(place: str, block: Block) -> str:
    fields = block.parameters._asdict().items()
    numbers = json.dumps({field: np.asarray(value).tolist() for field, value in fields})
    equations = hashlib.sha256(repr(block.records).encode()).hexdigest()
    return f"{place} {block.name} {equations[:8]} {numbers}".lstrip()


def checked(changes: Changes, scenario: Scenario) -> Changes:
    """Return blocks; refuse those whose states do not hold what summaries are made of."""
    changes, row = changes.of_blocks("an ensemble"), scenario.learning.row
    if changes.law is not None:
        functions_of(changes.law)
    columns = state_columns(changed_blocks(scenario, changes)) if changes != UNCHANGED else {}
    learned = ["theta_hat"] if row.makes_estimate else [] if row.given_estimate else ["alpha"]
    for name, states in ((LAW, [*learned, "K", "Gamma"]), ("vehicle", ["x"])):
        for port in states if name in changes.replace else ():
            if port not in columns:
                own = changes.replace[name].name
                raise DiagramError(
                    f"{own}: {port} is no state of it; members are summarised from the states "
                    f"{', '.join(states)}"
                )
    return changes


class LoopToRun(VariedScenario):
    """A scenario's loop that is run many times."""

    def __init__(
        self,
        system: Any,
        samples: int | None = None,
        times: Sequence[float] | None = None,
    ):
        loop = loop_of(system)
        super().__init__(loop.scenario)
        self.changes = checked(loop.changes, loop.scenario)
        self.marks = marks_of(self.scenario, times)
        self.samples = samples_per_cycle(self.scenario, samples)

    def asked(self, path: Path | None) -> dict[str, Any]:
        """Return what it is, for a store that lies there."""
        return {
            "scenario": scenario_to_text(self.scenario, None if path is None else path.parent),
            "samples": self.samples,
            "times": list(self.marks),
            "law": named(self.changes),
        }

    def worker(
        self, values: Mapping[str, np.ndarray], trajectories: bool, cluster: bool
    ) -> "ScenarioWorker":
        """Return the worker of members with such values."""
        recipe = Recipe(
            scenario_to_text(self.scenario),
            str(self.scenario._folder.absolute()),
            tuple(values),
            self.samples,
            self.marks,
            trajectories,
            b""
            if self.changes == UNCHANGED
            else pickled(self.changes, ", ".join(self.changes.names), cluster),
        )
        return ScenarioWorker(recipe)


class Worker:
    """Members of one recipe, run and summarised."""

    recipe: Any  # what another process makes the same worker of
    title: str
    encoding: Mapping[str, Any] = {}  # of the dataset
    every: np.ndarray  # the times of members' states
    ensemble: Ensemble  # what is ready to run
    how: Mapping[str, Any]  # tolerances and method
    alone: bool  # whether members are asked for signals too, one by one

    def __init__(self) -> None:
        self._lock = threading.Lock()

    def arrays(self, values: Mapping[str, np.ndarray]) -> dict[str, Array]:
        """Return all arrays of the store, for the values of all members."""
        raise NotImplementedError

    def kept(
        self, members: Members, values: Mapping[str, np.ndarray], states: States
    ) -> dict[str, np.ndarray]:
        """Return what is kept of members."""
        raise NotImplementedError

    @cached_property
    def code(self) -> str:
        """A short name of the code and the versions that make the numbers."""
        from ..native.machine import processor

        program = getattr(self.ensemble.native, "code", None)
        made_of = [version(name) for name in ("clpt-control", "llvmlite", "numpy")]
        made_of += [repr(program and program.program), repr(processor())]
        return hashlib.sha256("\n".join(made_of).encode()).hexdigest()[:16]

    @property
    def batch(self) -> int:
        """How many members' states fit into the memory of a thread."""
        states = max(self.ensemble.native.nstates, 1)
        fit = BATCH_BYTES // (8 * states * len(self.every))
        return max(8, min(MOST_MEMBERS, fit // 8 * 8))

    def summaries(self, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Run members together, at most a batch, and return what is kept of them."""
        ensemble = self.ensemble
        with self._lock:  # one evaluator makes all members; compile once
            members = ensemble.members(values, float(self.every[-1]))
            for lanes in {ensemble.lanes, 1 if self.alone else ensemble.lanes}:
                ensemble.native.callee(lanes)
        states = ensemble.run(members, self.every, **self.how)
        with np.errstate(all="ignore"):  # a member that failed may hold anything
            return self.kept(members, values, states)

    def chunk(self, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Run any number of members, batch by batch, and return what is kept of them."""
        count = len(next(iter(values.values())))
        parts = [
            self.summaries(rows(values, first, min(first + self.batch, count)))
            for first in range(0, count, self.batch)
        ]
        return joined(parts)


def rows(values: Mapping[str, np.ndarray], first: int, last: int) -> dict[str, np.ndarray]:
    """Return the rows of some members."""
    return {name: array[first:last] for name, array in values.items()}


def joined(parts: list[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    """Join the summaries of batches that follow each other."""
    if len(parts) == 1:
        return parts[0]
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


@lru_cache(maxsize=4)
def worker_of(recipe: Any) -> Worker:
    """Return the worker of a recipe, made once in a process."""
    return recipe.worker()


class ScenarioWorker(Worker):
    """Members of a scenario."""

    def __init__(self, recipe: Recipe):
        super().__init__()
        self.recipe = recipe
        self.scenario = scenario_from_text(recipe.text, "scenario", Path(recipe.folder))
        self.title, run = self.scenario.title, self.scenario.run
        self.encoding = {"folder": recipe.folder}  # of its field
        self.alone = self.scenario.vehicle.max_speed is not None
        self.times = sample_times_of(
            self.scenario, recipe.samples, recipe.marks, recipe.trajectories
        )
        self.every, self.how = self.times.all, {"rtol": run.rtol, "atol": run.atol}

    @cached_property
    def ensemble(self) -> ScenarioEnsemble:  # type: ignore[override]
        """The compiled diagram."""
        changes = pickle.loads(self.recipe.changes) if self.recipe.changes else UNCHANGED
        return ScenarioEnsemble(self.scenario, self.recipe.keys, changes=changes)

    def arrays(self, values: Mapping[str, np.ndarray]) -> dict[str, Array]:
        """Return all arrays of the store, for the values of all members."""
        return arrays_of(self.scenario, self.times, values, self.recipe.trajectories)

    def kept(
        self, members: Members, values: Mapping[str, np.ndarray], states: States
    ) -> dict[str, np.ndarray]:
        """Return what is kept of members."""
        trajectories = self.recipe.trajectories
        return summarise_members(self.ensemble, members, self.times, values, states, trajectories)
