"""Varied scenarios: keys that may vary in a scenario, their locations in its loop, and members."""

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
from .members import Member, Values, hash_of
from .sampled_parameters import cannot_vary
from .summaries import arrays_of, marks_of, sample_times_of, summarise


class VariedScenario:
    """The loop of a scenario, with `changes` by the user's blocks, and its sampled parameters."""

    params: Mapping[str, Any] = {}
    inputs = None

    def __init__(
        self,
        scenario: Scenario,
        changes: Changes = UNCHANGED,
        times: Sequence[float] | None = None,
        trajectories: bool = False,
    ):
        self.scenario = scenario
        self.changes = checked_changes(changes, scenario)
        self.marks = marks_of(scenario, times)
        self.times = sample_times_of(scenario, self.marks, trajectories)
        self.trajectories = trajectories
        self.state_times = self.times.union
        self.options = scenario.run.solver
        self.title = scenario.title
        is_measured = scenario.flow.field is not None
        self.replaced = set(self.changes.replace)
        self.has_flow_error = is_measured and "true_flow" not in self.replaced
        self.needs_signals = scenario.vehicle.max_speed is not None or is_measured
        self.name = ", ".join(changes.names) or "the closed loop"
        self.encoding = {"folder": str(scenario._folder.absolute())}  # of its field
        of_law = ("learning.gain", f"learning.{scenario.learning.row.table}.")
        self.values = {
            key: value
            for key, value in variable_values(scenario).items()
            if self.changes.law is None or not key.startswith(of_law)
        }

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the arguments, with the absolute folder of the field."""
        scenario = self.scenario.model_copy()
        scenario._folder = scenario._folder.absolute()
        return type(self), (scenario, self.changes, self.marks, self.trajectories)

    @property
    def knows_flow(self) -> bool:
        """True if the true flow has the scenario's parameters."""
        has_parameters = self.scenario.flow.parameters is not None
        return has_parameters and "true_flow" not in self.replaced

    @property
    def knows_gains(self) -> bool:
        """True if the vehicle has the scenario's gains and the law adapts gains."""
        at_fixes = self.scenario.learning.row.at_fixes
        return not at_fixes and "vehicle_controller" not in self.replaced

    # --- checks ---------------------------------------------------------------------------

    def why_not(self, key: str) -> str:
        """Return the reason for which a key cannot vary."""
        is_replaced = key.split(".")[0] in self.changes.names
        if not is_replaced and (hint := key_hint(key)):
            return f"vary: {hint}"
        advice = (
            "; the parameters of a part given in Python vary where there are timepts"
        )
        return cannot_vary(key, self.values) + advice * bool(self.changes.names)

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that the scenario does not allow."""
        self.scenario.with_values({key: value})

    def arguments(self, path: Path | None) -> dict[str, Any]:
        """Return the arguments that identify the scenario in a store at a path."""
        folder = None if path is None else path.parent
        return {
            "scenario": scenario_to_text(self.scenario, folder),
            "times": list(self.marks),
            "law": self.changed_loop,
        }

    @property
    def changed_loop(self) -> str | None:
        """The names of the user's blocks and a hash of the changed loop; None if unchanged."""
        if self.changes == UNCHANGED:
            return None
        parameters = [block.parameters for block in self.blocks]
        return f"{', '.join(self.changes.names)} {hash_of(self.wiring, parameters)}"

    # --- loop -----------------------------------------------------------------------------

    @cached_property
    def blocks(self) -> list[Block]:
        """The blocks of the loop."""
        return changed_blocks(self.scenario, self.changes)

    @cached_property
    def wiring(self) -> Wiring:
        """The wired loop."""
        return wiring_of_blocks(self.blocks)

    @cached_property
    def columns(self) -> dict[str, slice]:
        """Columns of each state."""
        return state_columns(self.blocks)

    @cached_property
    def start(self) -> np.ndarray:
        """The initial state."""
        return state_of(self.scenario, self.blocks, self.changes.law)

    def location(self, key: str) -> Place:
        """Return the location of a key's value; empty if the loop has no such value."""
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
        """Return True if members with values of a key are made one by one, as if a law uses it."""
        of_law = keys_of_law(self.scenario) if self.changes.law is None else ()
        if key in of_law or key not in QUANTITIES or QUANTITIES[key].jumps:
            return True
        return self.location(key) == Place()

    def member(self, values: Values) -> Member:
        """Return the member with these values."""
        scenario = self.scenario.with_values(dict(values))
        blocks = changed_blocks(scenario, self.changes)
        start = state_of(scenario, blocks, self.changes.law)
        return [block.parameters for block in blocks], start, None

    # --- summaries ------------------------------------------------------------------------

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
        is_seed = key.endswith(".seed")
        add(key, float(value or 0) if is_seed else defaults.get(key, value))
    for name, value in learning.settings.items():  # the law's defaults may vary too
        add(f"learning.{learning.row.table}.{name}", value)
    if learning.gain is None and learning.gains is None:
        add("learning.gain", learning.row.gain)
    fixed = {"learning.sample"}
    if delta is not None and not delta.row.random:
        fixed.add("flow.disturbance.seed")
    if delta is not None and not delta.row.keys.get("period"):
        fixed.add("flow.disturbance.period")
    return {
        key: value
        for key, value in values.items()
        if key not in fixed and not key.startswith("run.")
    }


def checked_changes(changes: Changes, scenario: Scenario) -> Changes:
    """Return changes as blocks; refuse blocks without the states that summaries need."""
    changes, row = changes.of_blocks("an ensemble"), scenario.learning.row
    if changes.law is not None:
        functions_of(changes.law)
    if changes == UNCHANGED:
        return changes
    columns = state_columns(changed_blocks(scenario, changes))
    estimate = [] if row.given_estimate else ["alpha"]
    if row.makes_estimate:
        estimate = ["theta_hat"]
    for name, states in ((LAW, [*estimate, "K", "Gamma"]), ("vehicle", ["x"])):
        for port in states if name in changes.replace else ():
            if port not in columns:
                raise DiagramError(
                    f"{changes.replace[name].name}: {port} is not a state of it; members are "
                    f"summarised from the states {', '.join(states)}"
                )
    return changes
