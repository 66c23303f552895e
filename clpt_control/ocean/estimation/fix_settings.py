"""Settings with which a scenario's law learns from fixes, and its local frame.

A key of the law's own table that is set has its value.  Otherwise

    prior        0.5 m/s, the standard deviation of each flow parameter
    noise        r^2 = 2 s^2 + (0.02 m/s T)^2 of a leg of duration T, s = localization.noise or 10 m
                 (the scatter may be another, and last: `lasting_scatter`)
    walk         0.02 m/s in a day, of kalman-flow
    forgetting   1/(30 d), of least-squares

as the laws' defaults in a simulation follow from the vehicle and its waypoints, which a recorded
mission does not have.  Numbers are in the scenario's units.

Outside of the frame: m, m/s to the east and to the north, s since 1970 UTC, degrees.  Inside: the
plane around the origin, x1 and x2 (`base.geodesy`), with t = 0 at a given time.
"""

from dataclasses import dataclass
from math import hypot, radians, tan
from types import SimpleNamespace
from typing import Any

import numpy as np

from ...base.errors import ScenarioError
from ...base.geodesy import RADIUS, check_near, convergence, displacement, place_from
from ...base.units import DAY, METRES, SECONDS
from ...paper.blocks.flow import largest_shear
from ...paper.laws.fix_bound import SIGMAS, UNMODELLED, Limits
from ...paper.laws.regressions import check_priors, priors
from ...paper.laws.table import LAWS
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.tables import Units

PRIOR = 0.5  # m/s
SCATTER = 0.02  # m/s, flow that the functions do not express, in the mean over a leg
FIX = 10.0  # m, standard deviation of a fix on each axis
WALK = 0.02  # m/s in a day
BENT = 0.25  # m/s, flow that a bent way changes by, a width away
MEMORY = 30.0  # d
# kinds of seas: hours for which their scatter lasts, and multiples of that one; scatters that grow
# alike in a short time differ as the roots of their times
HOURS, SIZES = np.array([1e-9, 8.0, 32.0]), np.outer([0.3, 1.2, 5.0], [1.0, 0.8, 1.6])
Pair = tuple[float, float]


class FixSettings:
    """Prior, noise and initial estimate of a scenario's law for fixes."""

    def __init__(
        self,
        scenario: Scenario,
        shear: float | None = None,
        unmodelled: float = UNMODELLED,
    ) -> None:
        learning, row = scenario.learning, scenario.learning.row
        if row.between_fixes is None:
            laws = ", ".join(name for name, law in LAWS.items() if law.between_fixes)
            raise ScenarioError(
                f"learning.law = {row.name!r}: does not learn from recorded fixes. Set one of "
                f"{laws}"
            )
        metres, seconds = METRES[scenario.units.length], SECONDS[scenario.units.time]
        self.metres = metres
        self.speed = metres / seconds  # m/s
        own = {key: x for key, x in learning.settings.items() if x is not None}
        self.bent = BENT / self.speed
        self.noise: float | None = own.get("noise")
        self.noise_per_leg = row.at_fixes  # else per square root of time
        self.scatter = SCATTER / self.speed
        table = scenario.localization
        self.fix = (table and table.noise) or FIX / metres
        sizes = SIZES if self.noise is None else np.ones((1, 1))
        # kinds of seas: squares of fixes and scatter, (2, K, L), and times of the scatter, (L,)
        self.seas = np.array([0 * sizes + 1, sizes**2])
        self.lasting = HOURS[: sizes.shape[1]] * 3600 / seconds
        facts: Any = SimpleNamespace(  # as of a `LawContext`
            N=scenario.basis.N,
            settings={"priors": None, **learning.settings},
            prior=own.get("prior", PRIOR / self.speed),
        )
        check_priors(row, facts)
        self.prior = priors(facts)
        # standard deviation of the flow that functions which die out do not span
        self.beside = float(self.prior.max())
        # of `Law.between_fixes`
        self.p = SimpleNamespace(
            walk=own.get("walk", WALK / self.speed * (seconds / DAY) ** 0.5),
            forgetting=own.get("forgetting", seconds / (MEMORY * DAY)),
            largest=float(np.sum(self.prior**2)),
        )
        self.theta = np.array(learning.theta_estimate or scenario.model_parameters)
        if not row.alpha_is_constant:
            self.theta = -np.array(scenario.learning_parameters)
        basis = scenario.basis
        usual = largest_shear(basis.kernel, basis.widths, self.theta, self.prior)
        self.limits = Limits(
            usual if shear is None else shear * seconds,
            unmodelled / self.speed,
            SIGMAS * self.fix,
        )

    def noise_of(self, duration: float) -> np.ndarray:
        """Return the variances of a leg, (2,): that of its fixes, if known, and the rest of r^2."""
        if self.noise is None:
            return np.array([2 * self.fix**2, (self.scatter * duration) ** 2])
        return np.array(
            [0.0, self.noise**2 * (1.0 if self.noise_per_leg else duration)]
        )


@dataclass(frozen=True)
class LocalFrame:
    """Frame with its origin at a time (s since 1970 UTC) and a place (degrees)."""

    time: float
    place: Pair
    units: Units

    @property
    def metres(self) -> float:
        """Size of the unit of length, m."""
        return METRES[self.units.length]

    @property
    def seconds(self) -> float:
        """Size of the unit of time, s."""
        return SECONDS[self.units.time]

    def own_time(self, time: Any) -> Any:
        """Return a time since t = 0."""
        return (time - self.time) / self.seconds

    def date(self, t: float) -> float:
        """Return a time of the frame in s since 1970 UTC."""
        return self.time + t * self.seconds

    def point(self, latitude: float, longitude: float) -> np.ndarray:
        """Return a place as a point, (2,)."""
        east_north = displacement(*self.place, latitude, longitude)
        check_near(hypot(*east_north) / 1e3)
        return np.array(east_north) / self.metres

    def position(self, point: np.ndarray) -> Pair:
        """Return latitude and longitude of a point."""
        return place_from(*self.place, *(point * self.metres).tolist())

    def axes(self, point: np.ndarray) -> Pair:
        """Return the angle of east in the plane at a point, rad, and its growth to the east."""
        latitude, _ = self.position(point)
        growth = tan(radians(latitude)) / RADIUS * self.metres
        angle = convergence(*self.place, *(point * self.metres).tolist())
        return angle, growth

    def velocity(self, point: np.ndarray, velocity: np.ndarray) -> Pair:
        """Return a velocity in the plane as m/s to the east and to the north."""
        angle, _ = self.axes(point)
        east, north = rotated(velocity, -angle) * self.metres / self.seconds
        return float(east), float(north)


def rotated(vectors: np.ndarray, angle: np.ndarray | float) -> np.ndarray:
    """Return vectors (..., 2) turned anticlockwise by angles, rad."""
    c, s, x, y = np.cos(angle), np.sin(angle), vectors[..., 0], vectors[..., 1]
    return np.stack([c * x - s * y, s * x + c * y], axis=-1)
