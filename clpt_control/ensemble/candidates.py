"""Candidates of a tuning, and the sampled flows that they are tried on.

Candidates: every law of the table that learns, with gains and filters about its defaults.

First each law as it comes, K and Gamma adapted or held at the vehicle's own; then the few best
with a small grid: `GAINS` times learning.gain and `FILTERS` times the pole of the law's filter,
where it has one.  A law that cannot learn here, or not run, is skipped with the reason.

The answer is taken out of the scenario first:

    theta ~ normal(belief, prior),    belief = theta_estimate or -alpha(0) where given, else alpha_M
    prior = 0.3 k R                   k mean KD, R how far the track reaches

The scenario's own theta or field never enters: neither centre nor prior is made of it.  Noise,
of the position and of the disturbance, gets a seed for each draw.
"""

from itertools import product
from typing import Any, NamedTuple

import numpy as np

from ..base.errors import ScenarioError
from ..paper.laws.law import PRIOR, Law
from ..paper.laws.table import LAWS
from ..paper.scenario.experiment import Scenario

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
        return ", ".join(
            [self.law, *parts, f"K and Gamma {'held' if self.held else 'adapted'}"]
        )


def laws_to_try(names: tuple[str, ...]) -> tuple[list[Law], dict[str, str]]:
    """Return the rows of the table that learn, and why others are left out."""
    asked = [law for law in LAWS.values() if not names or law.name in names]
    why = "is given the flow, or learns at fixes and not from the position at all times"
    idle = {law.name: why for law in asked if law.given_estimate or law.at_fixes}
    return [law for law in asked if law.name not in idle], idle


def factors_of(one: Candidate) -> list[tuple[float, float]]:
    """Return the factors on gain and filter that are tried beside a candidate's own."""
    gains = GAINS if one.gain is not None else (1.0,)
    filters = FILTERS if one.filter is not None else (1.0,)
    return [pair for pair in product(gains, filters) if pair != (1.0, 1.0)]


def candidate(
    scenario: Scenario, law: Law, held: bool, gain: float = 1.0, pole: float = 1.0
) -> Candidate:
    """Return a law with its gain and filter times a factor each."""
    car = scenario.vehicle
    unused = ["gains", "parameters" if law.alpha_is_constant else "theta_estimate"]
    unused += [
        one.table for one in LAWS.values() if one.settings and one.name != law.name
    ]
    values: dict[str, Any] = {f"learning.{key}": None for key in unused}
    values |= {"learning.law": law.name, "learning.adapt_gains": not held}
    if held:
        values |= {
            "learning.feedback": car.feedback,
            "learning.feedforward": car.feedforward,
        }
    used = gain * _gain(scenario, law) if law.alpha_by_gain or not held else None
    values["learning.gain"] = used
    base, own_filter = scenario.with_values(values), None
    if "filter" in law.settings:
        own_filter = pole * float(law.block(base.known_to_law).parameters.filter)
        if pole != 1.0:
            values[f"learning.{law.table}.filter"] = own_filter
    return Candidate(law.name, used, held, own_filter, values)


def _gain(scenario: Scenario, law: Law) -> float:
    """Return the scenario's gain for its own law, else the law's default, else the scenario's."""
    own = scenario.learning
    numbers = own.gain, *dict(own.gains or ()).values()
    given = next((number for number in numbers if number is not None), None)
    if law.name == own.law and given is not None:
        return float(given)
    k = float(np.mean(scenario.vehicle.feedback))
    return float(law.gain or given or k**2)


# --- what is not known, to draw from --------------------------------------------------------------


class Unknown(NamedTuple):
    """A scenario without its answer, and what is drawn."""

    scenario: Scenario  # flow.parameters are the belief
    prior: float  # standard deviation of each theta, length per time
    varies: dict[str, Any]
    unmodelled: float  # rms of the disturbance, both axes, length per time
    noise: float  # standard deviation of the position, length


def unknown_of(
    scenario: Scenario, prior: float | None, unmodelled: float | None, members: int
) -> Unknown:
    """Take the answer out of a scenario; `unmodelled` puts a noisy disturbance in its place."""
    for name, value in (("prior", prior), ("unmodelled", unmodelled)):
        if value is not None and not 0 < value < np.inf:
            raise ScenarioError(f"{name} = {value:g}: must be a positive speed")
    values = dict.fromkeys(("flow.field", "flow.outside"))
    values["flow.parameters"] = belief(scenario)
    if unmodelled is not None:
        values["flow.disturbance"] = {
            "kind": "noise",
            "amplitude": [float(unmodelled) / np.sqrt(2)] * 2,
            "period": scenario.reference.dwell,
        }
    drawn = scenario.with_values(values)
    known = drawn.known_to_law
    size = PRIOR.usual(known) if prior is None else float(prior)
    varies: dict[str, Any] = {"flow.parameters": f"~normal:{size!r}"}
    delta, seen = drawn.flow.disturbance, drawn.localization
    if delta is not None and delta.kind == "noise":
        varies["flow.disturbance.seed"] = range(members)
    if seen is not None and (seen.noise > 0 or seen.dropouts > 0):
        varies["localization.seed"] = range(members)
    noise = 0.0 if seen is None else float(seen.noise)
    return Unknown(drawn, size, varies, _rms(drawn), noise)


def belief(scenario: Scenario) -> np.ndarray:
    """Return the theta that the learner starts from, (2, N)."""
    if scenario.learning.theta_estimate is not None:
        return np.array(scenario.learning.theta_estimate)
    given = scenario.learning.parameters
    if given is not None and np.any(given):
        return -np.array(given)
    return np.array(scenario.model_parameters)


def _rms(scenario: Scenario) -> float:
    """Return the rms of the disturbance: a sine's is its amplitude over sqrt(2)."""
    delta = scenario.flow.disturbance
    if delta is None:
        return 0.0
    size = float(np.hypot(*delta.amplitude))
    return size / np.sqrt(2) if delta.kind == "sine" else size
