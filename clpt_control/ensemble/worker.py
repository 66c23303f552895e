"""Members run and summarised, in the same way by a thread and by a far machine.

A recipe is plain text and numbers, and parts of the user's own, pickled; it is all that
travels.  A worker makes the compiled ensemble of it once and then summarises any members
it is given.
"""

import hashlib
import json
import pickle
import threading
from collections.abc import Mapping
from functools import cached_property, lru_cache
from importlib.metadata import version
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..diagrams.changes import LAW, UNCHANGED, Changes
from ..diagrams.parts import functions_of
from ..equations.block import Block
from ..errors import DiagramError
from ..scenario.experiment import Scenario
from ..scenario.file import scenario_from_text
from ..simulation.loops import changed_blocks
from ..simulation.starts import state_columns
from .members import Ensemble
from .summaries import sample_times_of, summarise_members

BATCH_BYTES = 64_000_000  # states in flight, a thread
MOST_MEMBERS = 512  # a batch


class Recipe(NamedTuple):
    """All that a worker needs to know."""

    text: str  # the scenario as TOML
    folder: str  # where a relative flow.field starts from
    keys: tuple[str, ...]  # what varies
    samples: int  # a cycle, for mean squares
    marks: tuple[float, ...]  # when errors are kept
    trajectories: bool  # whether states are kept too
    changes: bytes = b""  # parts of the user's own, pickled


def pickled(changes: Changes, cluster: bool) -> bytes:
    """Return parts of the user's own as workers take them; a cluster's get their equations too."""
    try:
        if cluster:  # equations of a script or a notebook go along
            from distributed.protocol.pickle import dumps

            return bytes(dumps(changes))
        return pickle.dumps(changes)
    except (pickle.PicklingError, AttributeError, TypeError):
        raise DiagramError(
            f"{', '.join(changes.names)}: cannot be sent to workers; define equations and "
            "parameters at the top of a module"
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


class Worker:
    """Members of one recipe, run and summarised."""

    def __init__(self, recipe: Recipe):
        self.recipe = recipe
        self.scenario = scenario_from_text(recipe.text, "scenario", Path(recipe.folder))
        self.times = sample_times_of(
            self.scenario, recipe.samples, recipe.marks, recipe.trajectories
        )
        self._lock = threading.Lock()

    @cached_property
    def ensemble(self) -> Ensemble:
        """The compiled diagram."""
        changes = pickle.loads(self.recipe.changes) if self.recipe.changes else UNCHANGED
        return Ensemble(self.scenario, self.recipe.keys, changes=changes)

    @cached_property
    def code(self) -> str:
        """A short name of the code and the versions that make the numbers."""
        from ..native.machine import processor

        native = self.ensemble.native
        made_of = [version(name) for name in ("clpt-control", "llvmlite", "numpy")]
        made_of += [repr(native.code.program), repr(processor())]
        return hashlib.sha256("\n".join(made_of).encode()).hexdigest()[:16]

    @property
    def batch(self) -> int:
        """How many members' states fit into the memory of a thread."""
        states = self.ensemble.native.nstates
        fit = BATCH_BYTES // (8 * states * len(self.times.all))
        return max(8, min(MOST_MEMBERS, fit // 8 * 8))

    def summaries(self, values: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Run members together, at most a batch, and return what is kept of them."""
        ensemble, run, times = self.ensemble, self.scenario.run, self.times
        with self._lock:  # one evaluator makes all members; compile once
            members = ensemble.members(values, float(times.all[-1]))
            ensemble.native.callee(ensemble.lanes)
            if self.scenario.vehicle.max_speed is not None:
                ensemble.native.callee(1)
        states = ensemble.run(members, times.all, run.rtol, run.atol)
        trajectories = self.recipe.trajectories
        with np.errstate(all="ignore"):  # a member that failed may hold anything
            return summarise_members(ensemble, members, times, values, states, trajectories)

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
def worker_of(recipe: Recipe) -> Worker:
    """Return the worker of a recipe, made once in a process."""
    return Worker(recipe)
