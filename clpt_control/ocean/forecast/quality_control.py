"""Quality control of dives: wrong fixes, and dead reckoning that the ways over ground contradict.

A fix that contradicts other fixes is marked as doubtful. At the surface a vehicle drifts, so the
next dive starts at most

    (|y| / T + 0.5 m/s) * (time between the fixes) + 5 FIX

from where the last one ended, with y the miss of that dive and T its duration. More, outside the
99 % ellipse of the vehicle's usual drift, says that one of the two fixes is wrong. If other dives
may lie between them, the limit is 5 m/s * time + 5 FIX.
The wrong fix is the one that lies further, by the covariance P of its forecast m,

    (y - m)^T P^-1 (y - m),

from where the last dive was forecast to end. If that is the end, the start of the next dive, within
an hour the place of the same surfacing, stands for it, and its doubt is the way that a current of
the prior moves the vehicle in that time. Later than that, and for a wrong start, the doubt is the
distance between the fixes.

A dive that ends outside the 99 % ellipse of its forecast is an outlier: its fix is wrong, or the
current has changed. Its doubt is its distance from the forecast. It counts in full if the next dive
starts nearer to that end than to the forecast, or is then more probable (`replay`). The variance of
a miss is

    FIX^2 + doubt^2 + (s T)^2.

Dead reckoning may be swapped, reversed or in km. With g the displacement over ground, d the dead
reckoning and T the duration of a dive,

    g / T = f A d / T + c + residual,

with a mean current c and a factor f on the speed. A is the identity for correct columns, and
another matrix for columns that are swapped, reversed or in km (`estimation.wrong_units`).

Real vehicles and made seas reach 5 (128 and 1900 dives, all windows of 4 to 40 dives). A table with
a wrong column is refused at dive 4 to 40, as soon as its headings and currents tell.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import hypot

import numpy as np

from ...base.errors import DataError
from ...base.geodesy import displacement
from ...paper.currents.identifiability import check_separable
from ..estimation.fix_model import OTHERS, Priors
from ..estimation.wrong_units import CLEAR, COMPARED, FEWEST, residual
from ..gliders.dives import FASTEST, Dive

WIND = 0.5  # m/s at the surface, in addition to the current
FIXES = 5.0  # standard deviations of two fixes, a poor one among them
SAME_STAY = 3600.0  # s: longer, other dives may lie between
OUTLYING = 9.21  # chi-squared of two components, 99 %
FACTORS = 1 / 3, 3.0  # on the speed
CAUSES = {  # appearance of dr_east_m and dr_north_m, and A
    "swapped": np.array([[0.0, 1.0], [1.0, 0.0]]),
    "reversed in sign": -np.eye(2),
    "like km": 1000.0 * np.eye(2),
}

Forecast = tuple[
    np.ndarray, np.ndarray
]  # mean (2,), m, and covariance (2, 2), m^2, of a miss


def doubt_one_fix(
    before: Dive,
    dive: Dive,
    is_next: bool,
    forecast: Forecast,
    priors: Priors,
    usual_drift: Forecast,
) -> tuple[Dive, Dive]:
    """Return both dives, of two fixes that disagree the wrong one doubted; else the same ones.

    The forecast is that of the end of the one before; `is_next` is false if other dives may lie
    between them; `usual_drift` is that of `DiveStatistics`.
    """
    gap = np.array(displacement(*before.end, *dive.start))
    separation = hypot(*gap)
    since = max(dive.t_gps2 - before.t_gpse, 0.0)
    current = float(np.hypot(*before.miss)) / before.duration
    fastest = min(current + WIND, FASTEST) if is_next else FASTEST
    is_usual = is_next and squared_distance(gap, *usual_drift) <= OUTLYING
    if is_usual or not separation > fastest * since + FIXES * priors.fix:
        return before, dive
    start_displacement = displacement(*before.start, *dive.start)
    start = np.array(start_displacement) - before.through_water
    end_off = squared_distance(before.miss, *forecast)
    jump = f"{separation / 1000:.1f} km in {since / 60:.0f} min"
    if squared_distance(start, *forecast) >= end_off:
        note = f"starts {jump} from where dive {before.number} ended: counts little"
        return before, _doubted(dive, separation, note)
    note = f"the fix at its end is {jump} from where dive {dive.number} starts"
    if since > SAME_STAY:
        return _doubted(before, separation, f"{note}: counts little"), dive
    east, north = start_displacement
    settled = replace(
        before,
        lat_gpse=dive.lat_gps2,
        lon_gpse=dive.lon_gps2,
        gps_east=east,
        gps_north=north,
    )
    note = f"{note}, and off its forecast: that start is taken instead"
    return _doubted(settled, priors.current * since, note), dive


def is_confirmed(
    before: Dive, dive: Dive, mean: np.ndarray, current: np.ndarray
) -> bool:
    """Return whether the next dive starts nearer to an end than to the forecast of that end.

    The end has drifted with the learned current (2,), m/s, until the next start.
    """
    gap = displacement(*before.end, *dive.start)
    from_end = np.array(gap) - current * (dive.t_gps2 - before.t_gpse)
    from_forecast = from_end + before.miss - mean
    return float(np.hypot(*from_end)) < float(np.hypot(*from_forecast))


def doubt_outlier(dive: Dive, mean: np.ndarray, covariance: np.ndarray) -> Dive:
    """Return a dive that ends outside the 99 % ellipse of its forecast doubted, else the same."""
    if squared_distance(dive.miss, mean, covariance) <= OUTLYING:
        return dive
    off = float(np.hypot(*(dive.miss - mean)))
    note = f"ends {off / 1000:.1f} km from its forecast, outside the 99 % ellipse"
    return _doubted(dive, off, f"{note}: counts little unless the next dive agrees")


def squared_distance(y: np.ndarray, mean: np.ndarray, covariance: np.ndarray) -> float:
    """Return (y - m)^T P^-1 (y - m), of chi-squared with two degrees of freedom."""
    off = y - mean
    return float(off @ np.linalg.solve(covariance, off))


def log_density(y: np.ndarray, mean: np.ndarray, covariance: np.ndarray) -> float:
    """Return the logarithm of a normal density, less a constant."""
    determinant = float(np.linalg.det(covariance))
    return -0.5 * (squared_distance(y, mean, covariance) + np.log(determinant))


def _doubted(dive: Dive, doubt: float, note: str) -> Dive:
    return replace(dive, doubt=hypot(dive.doubt, doubt), notes=(*dive.notes, note))


def check_next(dive: Dive, last: Dive | None) -> None:
    """Refuse a dive that is not finite or ends before the last one."""
    numbers = [dive.miss_east, dive.miss_north, *dive.start]
    numbers += [dive.model_east or 0, dive.model_north or 0]
    numbers += [np.sum(column) for column in dive.track or ()]
    if not (np.all(np.isfinite(numbers)) and dive.duration > 0):
        raise DataError(
            f"dive {dive.number}: fixes, dead reckoning and flow model must be finite, its "
            "duration above 0"
        )
    if last is not None and dive.t_gpse <= last.t_gpse:
        raise DataError(
            f"dive {dive.number} ends before dive {last.number}, which was learned. Feed dives "
            "in the order of their ends"
        )


def check_dead_reckoning(dives: Sequence[Dive]) -> None:
    """Refuse dives whose way over ground shows that their dead reckoning is wrong."""
    dives = dives[-COMPARED:]
    if len(dives) < FEWEST:
        return
    displacements = np.array([(*d.over_ground, *d.through_water) for d in dives])
    displacements /= np.array([d.duration for d in dives])[:, None]
    displacements -= displacements.mean(axis=0)
    over_ground = displacements[:, :2]
    reckoned = displacements[:, 2:]
    limit = residual(over_ground, reckoned, (0.0, FACTORS[1]))
    limit *= np.exp(-CLEAR / (len(dives) - 1))
    residuals = {
        cause: residual(over_ground, reckoned @ matrix, FACTORS)
        for cause, matrix in CAUSES.items()
    }
    cause = min(residuals, key=residuals.__getitem__)
    if residuals[cause] < limit:
        raise DataError(
            f"dives {dives[0].number} to {dives[-1].number}: the ways over ground contradict the "
            f"dead reckoning: dr_east_m and dr_north_m look {cause}. Correct them in the files"
        )


def check_tides(flow: Sequence[str], dives: Sequence[Dive]) -> None:
    """Refuse two tides of a flow that dives, by time, are too few to tell apart.

    A single tide is allowed on any record: its prior holds it.
    """
    tides = [name for name in flow[1:] if name not in OTHERS]
    if len(tides) > 1 and dives:
        hours = round((dives[-1].t_gpse - dives[0].t_gps2) / 3600, 1)
        check_separable(tides, hours, f"flow {','.join(flow)}")
