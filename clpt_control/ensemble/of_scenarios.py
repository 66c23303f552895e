"""The members of a scenario: its keys that may vary, and where its loop holds their values."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from ..base.errors import DiagramError
from ..engine.codegen.directional_derivatives import Place
from ..engine.diagram.interconnection import wiring_of_blocks
from ..engine.diagram.wiring import Wiring
from ..engine.model.block import Block
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.file import scenario_to_text
from ..paper.scenario.quantities import (
    QUANTITIES,
    STARTS,
    key_hint,
    keys_of,
    keys_of_law,
)
from ..simulation.initial_states import state_columns, state_of
from ..simulation.loop_blocks import changed_blocks
from ..simulation.user_components import LAW, UNCHANGED, Changes, functions_of
from .drawn_values import what_may_vary
from .members import Member, Values, hash_of
from .summaries import arrays_of, marks_of, sample_times_of, summarise


class VariedScenario:
    """A scenario's loop that is run many times; `changes` are the user's own parts."""

    params: Mapping[str, Any] = {}
    inputs = None

    def __init__(
        self,
        scenario: Scenario,
        changes: Changes = UNCHANGED,
        times: Sequence[float] | None = None,
        trajectories: bool = False,
    ):
        self.scenario, self.changes = scenario, checked_changes(changes, scenario)
        self.marks = marks_of(scenario, times)
        self.times = sample_times_of(scenario, self.marks, trajectories)
        self.trajectories = trajectories
        self.state_times, self.options = self.times.all, scenario.run.solver
        self.title, self.needs_signals = (
            scenario.title,
            scenario.vehicle.max_speed is not None,
        )
        self.own = set(self.changes.replace)
        self.name = ", ".join(changes.names) or "the closed loop"
        self.encoding = {"folder": str(scenario._folder.absolute())}  # of its field
        of_law = ("learning.gain", f"learning.{scenario.learning.row.table}.")
        self.values = {
            key: value
            for key, value in variable_values(scenario).items()
            if self.changes.law is None or not key.startswith(of_law)
        }

    def __reduce__(self) -> tuple[Any, ...]:
        """Travel as its arguments, with the absolute folder of the field."""
        scenario = self.scenario.model_copy()
        scenario._folder = scenario._folder.absolute()
        return type(self), (scenario, self.changes, self.marks, self.trajectories)

    @property
    def knows_flow(self) -> bool:
        """True if the true flow parameters are the scenario's."""
        return self.scenario.flow.parameters is not None and "true_flow" not in self.own

    @property
    def knows_gains(self) -> bool:
        """True if there are true gains, the scenario's."""
        return (
            not self.scenario.learning.row.at_fixes
            and "vehicle_controller" not in self.own
        )

    # --- what may vary --------------------------------------------------------------------

    def why_not(self, key: str) -> str:
        """Return why a key cannot vary."""
        of_own = key.split(".")[0] in self.changes.names
        if not of_own and (other := key_hint(key)):
            return f"vary: {other}"
        own = "; the parameters of a part given in Python vary where there are timepts"
        return what_may_vary(key, self.values) + own * bool(self.changes.names)

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that the scenario does not allow."""
        self.scenario.with_values({key: value})

    def arguments(self, path: Path | None) -> dict[str, Any]:
        """Return what identifies it, for a store at a path."""
        return {
            "scenario": scenario_to_text(
                self.scenario, None if path is None else path.parent
            ),
            "times": list(self.marks),
            "law": self.own_parts,
        }

    @property
    def own_parts(self) -> str | None:
        """The names of the user's own parts, and a hash of the loop that they are in."""
        if self.changes == UNCHANGED:
            return None
        given = [block.parameters for block in self.blocks]
        return f"{', '.join(self.changes.names)} {hash_of(self.wiring, given)}"

    # --- its loop -------------------------------------------------------------------------

    @cached_property
    def blocks(self) -> list[Block]:
        """The blocks of its loop."""
        return changed_blocks(self.scenario, self.changes)

    @cached_property
    def wiring(self) -> Wiring:
        """Its loop."""
        return wiring_of_blocks(self.blocks)

    @cached_property
    def columns(self) -> dict[str, slice]:
        """Columns of each state."""
        return state_columns(self.blocks)

    @cached_property
    def start(self) -> np.ndarray:
        """The initial state."""
        return state_of(self.scenario, self.blocks, self.changes.law)

    def place(self, key: str) -> Place:
        """Return where the value of a key lies as it is."""
        fields = tuple(
            (k, field)
            for k, block in enumerate(self.blocks)
            for field in block.parameters._fields
            if block.name not in self.changes.names
            and key in keys_of(self.scenario, f"{block.name}.{field}")
        )
        column = self.columns.get(STARTS.get(key, ""), slice(0, 0))
        return Place(fields, tuple(range(column.start, column.stop)))

    def one_by_one(self, key: str) -> bool:
        """Return whether members are made one by one of a key's values, as where a law uses it."""
        of_law = keys_of_law(self.scenario) if self.changes.law is None else ()
        in_place = (
            key in QUANTITIES
            and not QUANTITIES[key].jumps
            and self.place(key) != Place()
        )
        return key in of_law or not in_place

    def member(self, values: Values) -> Member:
        """Return one member with some values of its own."""
        scenario = self.scenario.with_values(dict(values))
        blocks = changed_blocks(scenario, self.changes)
        start = state_of(scenario, blocks, self.changes.law)
        return [block.parameters for block in blocks], start, None

    # --- its summaries --------------------------------------------------------------------

    arrays = arrays_of
    summarise = summarise


def variable_values(scenario: Scenario) -> Values:
    """Return the values of all keys that may vary: the scenario's, or the defaults."""
    defaults = {
        "basis.phases": scenario.phases,
        "model.parameters": scenario.model_parameters,
    }
    learning, delta = scenario.learning, scenario.flow.disturbance
    if not learning.row.alpha_is_constant:
        defaults["learning.parameters"] = scenario.learning_parameters
    values: Values = {}

    def add(key: str, value: Any) -> None:
        number = np.asarray(value)
        if number.dtype.kind == "f" and number.size:
            values.setdefault(key, number)

    for key, value, _ in scenario.every_key():
        add(
            key,
            float(value or 0) if key.endswith(".seed") else defaults.get(key, value),
        )
    for name, value in learning.settings.items():  # the law's defaults may vary too
        add(f"learning.{learning.row.table}.{name}", value)
    if learning.gain is None and learning.gains is None:
        add("learning.gain", learning.row.gain)
    kind = None if delta is None else delta.kind
    none = {"learning.sample"} | (
        {"flow.disturbance.seed"} if kind != "noise" else set()
    )
    none |= {"flow.disturbance.period"} if kind == "constant" else set()
    return {
        k: v for k, v in values.items() if k not in none and not k.startswith("run.")
    }


def checked_changes(changes: Changes, scenario: Scenario) -> Changes:
    """Return changes as blocks; refuse those that lack a state which summaries need."""
    changes, row = changes.of_blocks("an ensemble"), scenario.learning.row
    if changes.law is not None:
        functions_of(changes.law)
    columns = (
        state_columns(changed_blocks(scenario, changes)) if changes != UNCHANGED else {}
    )
    estimate = (
        ["theta_hat"] if row.makes_estimate else [] if row.given_estimate else ["alpha"]
    )
    for name, states in ((LAW, [*estimate, "K", "Gamma"]), ("vehicle", ["x"])):
        for port in states if name in changes.replace else ():
            if port not in columns:
                raise DiagramError(
                    f"{changes.replace[name].name}: {port} is no state of it; members are "
                    f"summarised from the states {', '.join(states)}"
                )
    return changes
