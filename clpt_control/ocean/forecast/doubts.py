"""What may be wrong: fixes that disagree, and a speed that left its credible range.

At the surface a vehicle drifts, so the next dive starts at most

    5 m/s * (time between the fixes) + 300 m

from where the last one ended; more says that one of the two fixes is wrong.  It is the
one that lies further, by the covariance P of its forecast m,

    (y - m)^T P^-1 (y - m),

from where the last dive was forecast to end.  If that is the end, the start of the next
dive, within an hour the place of the same surfacing, stands for it, and what a
current of the prior moves the vehicle in that time is its doubt; later than that it
counts by how far off it is.  If it is the start, as when a boat has moved the vehicle,
the next dive counts by how far off it is.  The variance of a miss is then

    FIX^2 + doubt^2 + (s T)^2.

The start of a dive is known before it is forecast, so nothing later is read.

Of speed: let L L^T be the covariance of the misses y of the last dives, given the dives before
them, and nu = L^-1 (y - forecast). A jump of the factor by d before the first of these dives
shifts nu by d g on average, with g = L^-1 h and h their dead reckoning. The likelihood ratio of a
jump against none is (A. S. Willsky, H. L. Jones, "A generalized likelihood ratio approach to the
detection and estimation of jumps in linear systems", IEEE Trans. Automatic Control 21, 108-112,
1976)

    l = (g^T nu)^2 / (g^T g).

One strange dive proves nothing: the two dives before the last are tried as j.
A dive is flagged where l is beyond `SURE`, the jump is large enough to matter
and what the speed leaves is no more than the flow's own scatter.  Where the speed
(one number) explains more than a jump of the current (two), the flag is certain.
On one heading a lost speed and a current from ahead look the same: then a loss of
a plausible size is flagged as one or the other.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import hypot
from typing import NamedTuple

import numpy as np

from ...base.geodesy import displacement, distance
from ..estimation.dive import Dive, miss
from ..estimation.fix_model import FixModel
from ..estimation.process_mixture import ProcessMixture
from ..gliders.usable_dives import FASTEST

MARGIN = 300.0  # m: two fixes, a poor one among them, and how long a stay is rounded
SAME_STAY = 3600.0  # s: longer, other dives may lie between
SURE = 10.0  # l of 3.2 standard deviations
NESTED = 2.0  # what a second number explains by chance (H. Akaike, 1974)
# least change of the factor that is flagged; largest doubtful loss
MATTERS, PLAUSIBLE = (0.08, 0.4)
DIVES = 3  # the last dive, and the two that are tried as the first of a slower speed
SETTLED = 10  # dives before the watch speaks
SCATTER = 3.0  # most the rest may weigh, in expected values


def doubt_one_fix(
    before: Dive, dive: Dive, forecast: tuple[np.ndarray, np.ndarray], model: FixModel
) -> tuple[Dive, Dive]:
    """Return both dives, of two fixes that disagree the wrong one doubted; else the same ones.

    The forecast is that of the end of the one before: mean (2,), m, and covariance (2, 2), m^2.
    """
    apart = distance(before.lat_gpse, before.lon_gpse, dive.lat_gps2, dive.lon_gps2)
    since = max(dive.t_gps2 - before.t_gpse, 0.0)
    if not apart > FASTEST * since + MARGIN:  # as far as a vehicle may drift
        return before, dive
    there = displacement(before.lat_gps2, before.lon_gps2, dive.lat_gps2, dive.lon_gps2)
    start = np.array(there) - (before.dr_east, before.dr_north)
    mean, covariance = forecast
    end_off, start_off = (
        float(off @ np.linalg.solve(covariance, off))
        for off in (miss(before) - mean, start - mean)
    )
    jump = f"{apart / 1000:.1f} km in {since / 60:.0f} min"
    if start_off >= end_off:
        note = f"starts {jump} from where dive {before.number} ended: counts little"
        return before, _doubted(dive, apart, note)
    note = f"the fix at its end is {jump} from where dive {dive.number} starts"
    if since > SAME_STAY:
        return _doubted(before, apart, f"{note}: counts little"), dive
    drift = model.priors.current * since
    settled = _doubted(
        before, drift, f"{note}, and off its forecast: that start is taken instead"
    )
    lat, lon = dive.lat_gps2, dive.lon_gps2
    east, north = there
    return replace(
        settled, lat_gpse=lat, lon_gpse=lon, gps_east=east, gps_north=north
    ), dive


def _doubted(dive: Dive, doubt: float, note: str) -> Dive:
    return replace(dive, doubt=hypot(dive.doubt, doubt), notes=(*dive.notes, note))


class Anomaly(NamedTuple):
    """A dive at which the speed factor left its credible range.

    `change` of the factor on speed, with its standard error, holds from dive `since` on; the factor
    was `expected` before. `likelihood_ratio` is l of the speed, `of_current` that of a jump of the
    current instead, `rest` what the speed leaves of the misses over what is expected of them.
    `certain`: a current cannot explain it as well.
    """

    dive: int
    since: int
    change: float
    standard_error: float
    expected: float
    likelihood_ratio: float
    of_current: float
    rest: float
    certain: bool

    def __str__(self) -> str:
        return (
            f"dive {self.dive}: speed factor {self.expected:.2f} changed by {self.change:+z.2f} +- "
            f"{self.standard_error:.2f} since dive {self.since}; evidence "
            f"{self.likelihood_ratio:.0f} (a change of the current instead: {self.of_current:.0f}; "
            f"{SURE:g} is needed)"
            + (
                ""
                if self.certain
                else "; on these headings a current from ahead looks the same"
            )
        )


class DiveBefore(NamedTuple):
    """A dive's number; weights (m,) and mean speed factor of the mixture before the dive."""

    number: int
    weights: np.ndarray
    expected: float


class SpeedFactorWatch:
    """Watch on the speed factor of a mixture that learns the speed, dive by dive."""

    def __init__(self, mixture: ProcessMixture) -> None:
        self.count = 0
        self.recent: tuple[DiveBefore, ...] = ()
        self._remember(mixture)

    def _remember(self, mixture: ProcessMixture) -> None:
        """Store weights and speed factor for the next dive."""
        speed = mixture.model.names.index("speed")
        self.weights = mixture.weights
        self.expected = 1 + float(self.weights @ mixture.mean[:, speed])

    def step(self, mixture: ProcessMixture, dive: Dive) -> Anomaly | None:
        """Return the anomaly of the speed at the dive that the mixture has just learned."""
        before = DiveBefore(dive.number, self.weights, self.expected)
        self.recent = (*self.recent[1 - DIVES :], before)
        self._remember(mixture)
        self.count += 1
        if self.count <= SETTLED:
            return None
        starts = range(len(self.recent) - 1)
        jumps = (speed_jump(mixture, self.recent[start:]) for start in starts)
        anomalies = [jump for jump in jumps if jump is not None]
        if not anomalies:
            return None
        self.recent = ()
        return max(anomalies, key=lambda anomaly: anomaly.likelihood_ratio)


def speed_jump(mixture: ProcessMixture, dives: Sequence[DiveBefore]) -> Anomaly | None:
    """Return the anomaly that began with the first of the last dives, if one did."""
    since, weights, expected = dives[0]
    rows, regression = 2 * len(dives), mixture.regression
    speed = mixture.model.names.index("speed")
    columns = regression.columns[-len(dives) :, :, [speed, 0, 1]]
    g = regression.inverse_factor[:, -rows:, -rows:] @ columns.reshape(rows, 3)
    nu = regression.whitened[:, -rows:]
    information = g.transpose(0, 2, 1) @ g
    b = (g.transpose(0, 2, 1) @ nu[..., None])[..., 0]
    of_speed = information[:, 0, 0]
    if not (of_speed > 0).all():  # the vehicle does not move through the water
        return None
    speed_ratio = b[:, 0] ** 2 / of_speed
    current = np.linalg.solve(information[:, 1:, 1:], b[:, 1:, None])[..., 0]
    current_ratio = float(weights @ (b[:, 1:] * current).sum(axis=1))
    ratio = float(weights @ speed_ratio)
    rest = float(weights @ ((nu**2).sum(axis=1) - speed_ratio)) / (rows - 1)
    change = float(weights @ (b[:, 0] / of_speed))
    error = float(np.sqrt(1.0 / (weights @ of_speed)))
    certain = ratio - current_ratio > NESTED
    doubtful = current_ratio - ratio <= NESTED and -PLAUSIBLE < change < 0
    clear = ratio >= SURE and rest <= SCATTER and abs(change) >= MATTERS
    if not (clear and (certain or doubtful)):
        return None
    return Anomaly(
        dives[-1].number,
        since,
        change,
        error,
        expected,
        ratio,
        current_ratio,
        rest,
        certain,
    )
