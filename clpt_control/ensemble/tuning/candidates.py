"""Candidates: every law of the table that learns, with gains and filters about its defaults.

First each law as it comes, K and Gamma adapted or held at the vehicle's own; then the few best
with a small grid: `GAINS` times learning.gain and `FILTERS` times the pole of the law's filter,
where it has one.  A law that cannot learn here, or not run, is skipped with the reason.
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from ...blocks.laws.law import Law
from ...blocks.laws.table import LAWS
from ...scenario.experiment import Scenario
from ...scenario.learning import LearningGains

GAINS = (0.25, 1.0, 4.0)
FILTERS = (0.5, 1.0, 2.0)


class Candidate(NamedTuple):
    """A law with its numbers, as values of a scenario."""

    law: str
    gain: float | None  # None: the law has no use for it
    held: bool  # whether K and Gamma are held
    filter: float | None  # None: the law has none
    values: dict[str, Any]  # dotted key -> value, for `with_values`

    @property
    def text(self) -> str:
        """Its name with what was chosen."""
        parts = [] if self.gain is None else [f"gain {self.gain:.3g}"]
        parts += [] if self.filter is None else [f"filter {self.filter:.3g}"]
        return ", ".join([self.law, *parts, f"K and Gamma {'held' if self.held else 'adapted'}"])


def laws_to_try(names: tuple[str, ...]) -> tuple[list[Law], dict[str, str]]:
    """Return the rows of the table that learn, and why others are left out."""
    tried, skipped = [], {}
    for law in LAWS.values():
        if names and law.name not in names:
            continue
        if law.given_estimate:
            skipped[law.name] = "is given the flow and does not learn it"
        elif law.at_fixes:
            skipped[law.name] = "learns at fixes, not from the position at all times"
        else:
            tried.append(law)
    return tried, skipped


def as_they_come(scenario: Scenario, law: Law) -> Iterator[Candidate]:
    """Return a law with its defaults, adapted and held."""
    for held in (False, True):
        yield candidate(scenario, law, held, 1.0, 1.0)


def about(scenario: Scenario, law: Law, held: bool) -> Iterator[Candidate]:
    """Return the grid about a law's defaults, without them."""
    one = candidate(scenario, law, held, 1.0, 1.0)
    for gain in GAINS if one.gain is not None else (1.0,):
        for pole in FILTERS if one.filter is not None else (1.0,):
            if (gain, pole) != (1.0, 1.0):
                yield candidate(scenario, law, held, gain, pole)


def candidate(scenario: Scenario, law: Law, held: bool, gain: float, pole: float) -> Candidate:
    """Return a law with its gain and filter times a factor each."""
    car = scenario.vehicle
    values: dict[str, Any] = {"learning.law": law.name, "learning.gains": None}
    for other in LAWS.values():
        if other.settings and other.name != law.name:
            values[f"learning.{other.table}"] = None
    if law.keeps_alpha:
        values["learning.parameters"] = None
    else:
        values["learning.theta_estimate"] = None
    values["learning.adapt_gains"] = not held
    if held:
        values |= {"learning.feedback": car.feedback, "learning.feedforward": car.feedforward}
    used = None
    if law.alpha_by_gain or not held:
        used = gain * _gain(scenario, law)
    values["learning.gain"] = used
    base = scenario.with_values(values)
    found = None
    if "filter" in law.settings:
        made = law.block(base.known_to_law)
        found = pole * float(made.parameters.filter)
        if pole != 1.0:
            values[f"learning.{law.table}.filter"] = found
    return Candidate(law.name, used, held, found, values)


def _gain(scenario: Scenario, law: Law) -> float:
    """Return the scenario's gain for its own law, else the law's default, else the scenario's."""
    own = scenario.learning
    given = own.gain
    if given is None and own.gains is not None:
        numbers = [getattr(own.gains, key) for key in LearningGains.model_fields]
        given = next((number for number in numbers if number is not None), None)
    if law.name == own.law and given is not None:
        return float(given)
    k = float(np.mean(scenario.vehicle.feedback))
    return float(law.gain or given or k**2)
