"""LawDesign designs of a tuning, and the sampled flows on which they are tested.

A candidate is a law of the table that learns, with a gain and a filter.  First each law is tested
with its defaults, with K and Gamma adapted or fixed at the vehicle's gains.  Then the best laws are
tested on a small grid: `GAINS` times learning.gain and `FILTERS` times the pole of the law's
filter, if any.  Laws that cannot learn or run in this scenario are skipped with the reason.

The true flow is removed from the scenario first, and sampled:

    theta ~ normal(belief, prior),    belief = theta_estimate or -alpha(0) if given, else alpha_M
    prior = 0.3 k R                   k mean KD, R largest distance of the track from its mean

Neither belief nor prior depends on the scenario's theta or field.  Noise of the position and of
the disturbance has a seed for each sample.
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


class LawDesign(NamedTuple):
    """A law with its gain and filter, as values of a scenario."""

    law: str
    gain: float | None  # None: the law does not use it
    held: bool  # True if K and Gamma are fixed
    filter: float | None  # None: the law has no filter
    values: dict[str, Any]  # dotted key -> value, for `with_values`

    @property
    def text(self) -> str:
        """Name of the law with gain, filter, and the choice for K and Gamma."""
        settings = [] if self.gain is None else [f"gain {self.gain:.3g}"]
        settings += [] if self.filter is None else [f"filter {self.filter:.3g}"]
        settings.append(f"K and Gamma {'held' if self.held else 'adapted'}")
        return ", ".join([self.law, *settings])


def laws_to_try(names: tuple[str, ...]) -> tuple[list[Law], dict[str, str]]:
    """Return the laws that learn, and the reason for each law that is left out."""
    rows = [law for law in LAWS.values() if not names or law.name in names]
    reason = (
        "is given the flow, or learns at fixes and not from the position at all times"
    )
    idle = {law.name: reason for law in rows if law.given_estimate or law.at_fixes}
    return [law for law in rows if law.name not in idle], idle


def factors_of(candidate: LawDesign) -> list[tuple[float, float]]:
    """Return the pairs of factors on gain and filter, without (1, 1)."""
    gains = GAINS if candidate.gain is not None else (1.0,)
    filters = FILTERS if candidate.filter is not None else (1.0,)
    return [pair for pair in product(gains, filters) if pair != (1.0, 1.0)]


def candidate(
    scenario: Scenario,
    law: Law,
    gains_fixed: bool,
    gain: float = 1.0,
    pole: float = 1.0,
) -> LawDesign:
    """Return a candidate: a law, with factors on its gain and on the pole of its filter."""
    vehicle = scenario.vehicle
    unused = ["gains", "parameters" if law.alpha_is_constant else "theta_estimate"]
    unused += [
        row.table for row in LAWS.values() if row.settings and row.name != law.name
    ]
    values: dict[str, Any] = {f"learning.{key}": None for key in unused}
    values |= {"learning.law": law.name, "learning.adapt_gains": not gains_fixed}
    if gains_fixed:
        values |= {
            "learning.feedback": vehicle.feedback,
            "learning.feedforward": vehicle.feedforward,
        }
    used_gain = None
    if law.alpha_by_gain or not gains_fixed:
        used_gain = gain * _gain(scenario, law)
    values["learning.gain"] = used_gain
    context = scenario.with_values(values).known_to_law
    filter_pole = None
    if "filter" in law.settings:
        filter_pole = pole * float(law.block(context).parameters.filter)
        if pole != 1.0:
            values[f"learning.{law.table}.filter"] = filter_pole
    return LawDesign(law.name, used_gain, gains_fixed, filter_pole, values)


def _gain(scenario: Scenario, law: Law) -> float:
    """Return the scenario's gain for its law; for other laws the default, or that gain."""
    learning = scenario.learning
    numbers = learning.gain, *dict(learning.gains or ()).values()
    scenario_gain = next((number for number in numbers if number is not None), None)
    if law.name == learning.law and scenario_gain is not None:
        return float(scenario_gain)
    k = float(np.mean(scenario.vehicle.feedback))
    return float(law.gain or scenario_gain or k**2)


# --- sampled flows --------------------------------------------------------------------------------


class Unknown(NamedTuple):
    """A scenario without its true flow, and the sampled parameters."""

    scenario: Scenario  # flow.parameters are the belief
    prior: float  # standard deviation of each theta, length per time
    varies: dict[str, Any]  # `vary` of `run_ensemble`
    unmodelled: float  # rms of the disturbance, both axes, length per time
    noise: float  # standard deviation of the position, length


def unknown_of(
    scenario: Scenario, prior: float | None, unmodelled: float | None, members: int
) -> Unknown:
    """Return a scenario without its true flow; `unmodelled` is the rms of a noise disturbance."""
    for name, value in (("prior", prior), ("unmodelled", unmodelled)):
        if value is not None and not 0 < value < np.inf:
            raise ScenarioError(f"{name} = {value:g}: must be a positive speed")
    values = dict.fromkeys(("flow.field", "flow.outside", "flow.basis"))
    values["flow.parameters"] = belief(scenario)
    if unmodelled is not None:
        values["flow.disturbance"] = {
            "kind": "noise",
            "amplitude": [float(unmodelled) / np.sqrt(2)] * 2,
            "period": scenario.reference.dwell,
        }
    drawn = scenario.with_values(values)
    context = drawn.known_to_law
    deviation = PRIOR.usual(context) if prior is None else float(prior)
    varies: dict[str, Any] = {"flow.parameters": f"~normal:{deviation!r}"}
    delta, localization = drawn.flow.disturbance, drawn.localization
    if delta is not None and delta.row.random:
        varies["flow.disturbance.seed"] = range(members)
    if localization is not None and (
        localization.noise > 0 or localization.dropouts > 0
    ):
        varies["localization.seed"] = range(members)
    noise = 0.0 if localization is None else float(localization.noise)
    rms = 0.0 if delta is None else float(np.hypot(*delta.amplitude)) * delta.row.rms
    return Unknown(drawn, deviation, varies, rms, noise)


def belief(scenario: Scenario) -> np.ndarray:
    """Return the learner's initial estimate of theta, (2, N)."""
    if scenario.learning.theta_estimate is not None:
        return np.array(scenario.learning.theta_estimate)
    alpha = scenario.learning.parameters
    if alpha is not None and np.any(alpha):
        return -np.array(alpha)
    return np.array(scenario.model_parameters)
