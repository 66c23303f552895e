"""What is not known of a scenario, to draw from: the answer is taken out first.

    theta ~ normal(belief, prior),    belief = theta_estimate or -alpha(0) where given, else alpha_M
    prior = 0.3 k R                   k mean KD, R how far the track reaches

The scenario's own theta or field never enters: neither centre nor prior is made of it.  Noise,
of the position and of the disturbance, gets a seed for each draw.
"""

from typing import Any, NamedTuple

import numpy as np

from ...blocks.laws.known import PRIOR
from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from ..varied_keys import Vary


class Unknown(NamedTuple):
    """A scenario without its answer, and what is drawn."""

    scenario: Scenario  # flow.parameters are the belief
    prior: float  # standard deviation of each theta, length per time
    varies: tuple[Vary, ...]
    unmodelled: float  # rms of the disturbance, both axes, length per time
    noise: float  # standard deviation of the position, length


def unknown_of(
    scenario: Scenario, prior: float | None, unmodelled: float | None, members: int
) -> Unknown:
    """Take the answer out of a scenario; `unmodelled` puts a noisy disturbance in its place."""
    for name, value in (("prior", prior), ("unmodelled", unmodelled)):
        if value is not None and not 0 < value < np.inf:
            raise ScenarioError(f"{name} = {value:g}: must be a positive speed")
    values: dict[str, Any] = {
        "flow.parameters": belief(scenario),
        "flow.field": None,
        "flow.outside": None,
    }
    if unmodelled is not None:
        values["flow.disturbance"] = {
            "kind": "noise",
            "amplitude": [float(unmodelled) / np.sqrt(2)] * 2,
            "period": scenario.reference.dwell,
        }
    drawn = scenario.with_values(values)
    known = drawn.known_to_law
    size = PRIOR.usual(known) if prior is None else float(prior)
    varies = [Vary("flow.parameters", "normal", (size,))]
    seeds = tuple(float(k) for k in range(members))
    delta, seen = drawn.flow.disturbance, drawn.localization
    if delta is not None and delta.kind == "noise":
        varies.append(Vary("flow.disturbance.seed", "levels", seeds))
    if seen is not None and (seen.noise > 0 or seen.dropouts > 0):
        varies.append(Vary("localization.seed", "levels", seeds))
    return Unknown(
        drawn, size, tuple(varies), _rms(drawn), 0.0 if seen is None else float(seen.noise)
    )


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
