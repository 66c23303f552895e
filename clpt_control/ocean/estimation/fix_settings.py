"""Settings with which a scenario's law learns from recorded or live fixes.

A key of the law's own table that is set has its value.  Otherwise

    prior        0.5 m/s, the standard deviation of each flow parameter
    noise        r^2 = 2 s^2 + (0.02 m/s T)^2 of a leg of duration T, s = localization.noise or 10 m
    walk         0.02 m/s in a day, of kalman-flow
    forgetting   1/(30 d), of least-squares

as the laws' defaults in a simulation follow from the vehicle and its waypoints, which a recorded
mission does not have.  Numbers are in the scenario's units.
"""

from types import SimpleNamespace

import numpy as np

from ...base.errors import ScenarioError
from ...base.units import METRES, SECONDS
from ...paper.laws.table import LAWS
from ...paper.scenario.experiment import Scenario
from .fix_model import leg_variance

PRIOR = 0.5  # m/s
SCATTER = 0.02  # m/s, flow that the functions do not express, in the mean over a leg
FIX = 10.0  # m, standard deviation of a fix on each axis
WALK = 0.02  # m/s in a day
MEMORY = 30.0  # d
DAY = 86400.0  # s


class FixSettings:
    """Prior, noise and initial estimate of a scenario's law for fixes."""

    def __init__(self, scenario: Scenario) -> None:
        learning, row = scenario.learning, scenario.learning.row
        if row.between_fixes is None:
            laws = ", ".join(name for name, law in LAWS.items() if law.between_fixes)
            raise ScenarioError(
                f"learning.law = {row.name!r}: does not learn from recorded fixes. Set one of "
                f"{laws}"
            )
        metres, seconds = METRES[scenario.units.length], SECONDS[scenario.units.time]
        self.speed = metres / seconds  # m/s
        own = {key: x for key, x in learning.settings.items() if x is not None}
        self.noise: float | None = own.get("noise")
        self.noise_per_leg = row.at_fixes  # else per square root of time
        self.scatter = SCATTER / self.speed
        table = scenario.localization
        has_noise = table is not None and table.noise > 0
        self.fix = table.noise if table is not None and has_noise else FIX / metres
        self.prior = self._prior(own, scenario)
        # of `Law.between_fixes`
        self.p = SimpleNamespace(
            walk=own.get("walk", WALK / self.speed * (seconds / DAY) ** 0.5),
            forgetting=own.get("forgetting", seconds / (MEMORY * DAY)),
            largest=float(np.sum(self.prior**2)),
        )
        self.theta = np.array(learning.theta_estimate or scenario.model_parameters)
        if not row.alpha_is_constant:
            self.theta = -np.array(scenario.learning_parameters)

    def _prior(self, own: dict, scenario: Scenario) -> np.ndarray:
        """Return the standard deviation of each parameter, (N,); 0 fixes one."""
        N = scenario.basis.N
        priors = np.array(own.get("priors", N * [own.get("prior", PRIOR / self.speed)]))
        if priors.shape != (N,) or not np.any(priors):
            raise ScenarioError(
                f"learning.{scenario.learning.row.table}.priors: must be {N} numbers, one for each "
                "function, not all 0"
            )
        return priors

    def noise_of(self, duration: float) -> float:
        """Return r of a leg, length."""
        if self.noise is None:
            return float(leg_variance(2 * self.fix**2, self.scatter, duration) ** 0.5)
        return self.noise if self.noise_per_leg else self.noise * duration**0.5
