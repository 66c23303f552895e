"""Varied scenarios: keys that may vary in a scenario, their locations in its loop, and members.

The summaries of members are in `loop_summaries`.
"""

from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from ..base.errors import DiagramError
from ..engine.codegen.directional_derivatives import Place
from ..engine.diagram.interconnection import wiring_of_blocks
from ..engine.solver.inputs import NO_INPUTS
from ..paper.blocks.ports import POWERS
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.file import scenario_to_text
from ..paper.scenario.quantities import QUANTITIES, STARTS, keys_of, keys_of_law
from ..paper.scenario.tables import Quantity
from ..simulation.dataset import unit_of
from ..simulation.initial_states import state_columns, state_of
from ..simulation.loop_blocks import changed_blocks
from ..simulation.user_components import LAW, UNCHANGED, Changes, functions_of
from .loop_summaries import (
    TRAJECTORIES,
    LoopBatch,
    axes_of,
    marks_of,
    sample_times_of,
    summaries_of,
)
from .members import KERNEL, Member, Values, hash_of
from .sampled_parameters import cannot_vary


class VariedScenario:
    """The loop of a scenario, with `changes` by the user's blocks, and its sampled parameters."""

    params: Mapping[str, Any] = {}
    inputs = NO_INPUTS

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
        self.needs_signals = not {"flow_error", "share_in_faster_flow"} <= self.absent
        self.name = ", ".join(changes.names) or "the closed loop"
        self.encoding = {"folder": str(scenario._folder.absolute())}  # of its field
        of_law = "learning.gain", f"learning.{scenario.learning.row.table}."
        self.values = {
            key: value
            for key, value in variable_values(scenario).items()
            if self.changes.law is None or not key.startswith(of_law)
        }
        self.axes = axes_of(scenario, self.times)
        self.blocks = changed_blocks(scenario, self.changes)
        self.wiring = wiring_of_blocks(self.blocks)
        self.columns = state_columns(self.blocks)
        self.start = state_of(scenario, self.blocks, self.changes.law)
        self.summaries = summaries_of(self)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the arguments, with the absolute folder of the field."""
        scenario = self.scenario.model_copy()
        scenario._folder = scenario._folder.absolute()
        return type(self), (scenario, self.changes, self.marks, self.trajectories)

    @cached_property
    def absent(self) -> set[str]:
        """The names of the summaries that this scenario does not have."""
        flow = self.scenario.flow
        row = self.scenario.learning.row
        replaced = self.changes.replace
        own_flow = "true_flow" in replaced
        are_absent = {
            "flow_parameter_error": own_flow or flow.parameters is None,
            "gain_error": row.at_fixes or "vehicle_controller" in replaced,
            "flow_error": own_flow or flow.parameters is not None,
            "share_in_faster_flow": self.scenario.vehicle.max_speed is None,
            "alpha": row.alpha_is_constant,
            "feedback_gain": row.at_fixes,
            "feedforward_gain": row.at_fixes,
        }
        absent = {name for name, is_absent in are_absent.items() if is_absent}
        return absent if self.trajectories else absent.union(TRAJECTORIES)

    # --- checks ---------------------------------------------------------------------------

    def why_not(self, key: str) -> str:
        """Return the reason for which a key cannot vary."""
        is_replaced = key.split(".")[0] in self.changes.names
        if not is_replaced and (hint := Scenario.key_hint(key)):
            return f"vary: {hint}"
        keys = self.scenario.every_key()
        if any(name == key and isinstance(value, str) for name, value, _ in keys):
            return (
                f"vary: {key} cannot vary. Call clpt.simulate for each, of "
                f"scenario.with_values({{'{key}': text}}), and clpt.compare"
            )
        advice = (
            "; the parameters of a part given in Python vary where there are timepts"
        )
        return cannot_vary(key, self.values) + advice * bool(self.changes.names)

    def check(self, key: str, value: np.ndarray) -> None:
        """Refuse a value that the scenario does not allow."""
        self.scenario.with_values({key: value})

    def check_blocks(self, values: Values) -> None:
        """Do nothing: a scenario's keys have their own limits."""

    def arguments(self, path: Path | None) -> dict[str, Any]:
        """Return the arguments that identify the scenario in a store at a path.

        Those of a changed loop have the names of the user's blocks, and a hash of the loop.
        """
        folder, law = None if path is None else path.parent, None
        if self.changes != UNCHANGED:
            parameters = [block.parameters for block in self.blocks]
            names = ", ".join(self.changes.names)
            law = f"{names} {hash_of(self.wiring, parameters)}"
        return {
            "scenario": scenario_to_text(self.scenario, folder),
            "times": list(self.marks),
            "law": law,
        }

    # --- loop -----------------------------------------------------------------------------

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

    def remade(self, keys: Sequence[str]) -> list[str]:
        """Return the keys of values with which the loop is made anew."""
        return [KERNEL] if KERNEL in keys else []

    def made_with(self, values: Values) -> "VariedScenario":
        """Return the loop with another kernel, which is another record."""
        scenario = self.scenario.with_values(dict(values))
        return VariedScenario(scenario, self.changes, self.marks, self.trajectories)

    def member(self, values: Values) -> Member:
        """Return the member with these values."""
        scenario = self.scenario.with_values(dict(values))
        blocks = changed_blocks(scenario, self.changes)
        start = state_of(scenario, blocks, self.changes.law)
        return [block.parameters for block in blocks], start, self.inputs

    # --- summaries ------------------------------------------------------------------------

    batch = LoopBatch

    def key_layout(self, key: str, ndim: int) -> tuple[list[str], dict[str, str]]:
        """Return dimensions and attributes of the values of a key."""
        quantity, units = QUANTITIES.get(key, Quantity()), self.scenario.units
        attributes = {"long_name": f"{key}, which varies"}
        port = quantity.unit or quantity.state
        if port == "time":
            attributes["units"] = units.time
        elif port:
            attributes["units"] = unit_of(units, *POWERS[port])
        return quantity.axes.split() or ["axis", "basis"][:ndim], attributes


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
        if (number.dtype.kind == "f" and number.size) or key == KERNEL:
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
    changes, row = changes.of_blocks(), scenario.learning.row
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
