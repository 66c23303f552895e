"""theta of Eq. (3) from recorded fixes: of a run, or legs of a vehicle.

The vehicle of a run has a fix each so often; `between_fixes` makes segments of them and has the
methods.  The estimate is for the known-flow law (Remark 3.2).

Each leg (`dives.Dive`: two fixes and the way through the water between them) goes through
`FlowEstimator`, so that feeding legs at once is feeding their fixes one by one.  The learned flow
along the track is that of the parameters after the last leg, at each fix.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from importlib.metadata import version
from itertools import pairwise
from math import hypot
from operator import attrgetter
from typing import Any

import numpy as np
import xarray

from ...base.arguments import public
from ...base.errors import DataError, ScenarioError
from ...base.progress.interrupt import check
from ...base.units import METRES, SECONDS
from ...engine.model.block import Block
from ...paper.laws.law import PRIOR
from ...paper.scenario.experiment import Scenario
from ..gliders.dives import Dive, reckoned
from .between_fixes import METHODS, run_scenario, run_segments, whitened
from .fix_model import PERCENT
from .flow_estimator import FlowEstimator, Learned

BENT = 0.9  # share of its way at most from which on a leg is straight
HARDLY = 0.7  # share of the prior's standard deviation that is left
MPS = "m s-1"


@dataclass(frozen=True)
class FlowEstimate:
    """An estimate of theta and its covariance.

    Attributes
    ----------
    theta : ndarray, shape (2, N)
        In the unit of speed of the run.
    covariance : ndarray, shape (N, N)
        Of each row of theta; an upper bound where one noise of the position lasts over fixes.
    misses : ndarray, shape (n, 2)
        Residuals of the segments' position errors, length.
    condition_number : float
        The largest over the smallest singular value of the integrals h, each over its noise.
    steps : ndarray, shape (k, 2, N)
        theta after each segment of the filter; of least squares the estimate alone.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> values = {"run.duration": 60, "run.output_step": 0.1}
    >>> run = clpt.simulate(clpt.paper_scenario().with_values(values))
    >>> clpt.currents.flow_estimate(run, every=5.0).misses.shape
    (12, 2)
    """

    theta: np.ndarray
    covariance: np.ndarray
    misses: np.ndarray
    condition_number: float
    steps: np.ndarray
    basis: Block = field(repr=False)

    def __repr__(self) -> str:
        rows = "; ".join(", ".join(f"{x:.4g}" for x in row) for row in self.theta)
        sd = ", ".join(f"{x:.2g}" for x in self.standard_deviation)
        return f"<FlowEstimate: theta {rows}; standard deviation {sd} on both axes>"

    @property
    def standard_deviation(self) -> np.ndarray:
        """Standard deviation of each theta on both axes, shape (N,)."""
        return np.sqrt(np.diag(self.covariance))


@public
def flow_estimate(
    source: "xarray.Dataset | list[Dive]",
    scenario: Scenario | None = None,
    *,
    method: str = "least-squares",
    basis: Block | None = None,
    every: float | None = None,
    prior: float | np.ndarray | None = None,
    noise: float | np.ndarray | None = None,
) -> "FlowEstimate | xarray.Dataset":
    """Estimate the flow parameters theta from fixes.

    Parameters
    ----------
    source : list of Dive, or xarray.Dataset
        Recorded legs of `read_dives`, or a run of `simulate`, whose vehicle has a fix each `every`.
    scenario : Scenario, optional
        With legs: basis functions and law for fixes, as `FlowEstimator` takes them.  The other
        arguments are of runs.
    method : str
        ``"least-squares"`` or ``"kalman"``.
    basis : Block, optional
        phi of Eq. (5) at x; that of the run's scenario by default.
    every : float, optional
        Time between fixes; by default a tenth of ``reference.dwell``.
    prior : float or array_like, shape (N,), optional
        Standard deviation of each theta before any fix; by default the law's, 0.3 k R with the
        mean k of KD and the track's reach R.
    noise : float or array_like, shape (n,), optional
        Standard deviation of a position error, length: by default 1e-4 R, or the error of the
        run's samples if that is larger, and 2^(1/2) ``localization.noise``. What it has beyond
        1e-4 R is of its two fixes, half of the variance each; its neighbours share them.

    Returns
    -------
    FlowEstimate, or xarray.Dataset
        Of a run `theta`, its `covariance`, the residuals `misses`, and the `steps`.  Of legs the
        error of each forecast, the learned flow and the parameters after each leg, in m and m/s.

    Raises
    ------
    DataError
        If a number is not finite, or the run's samples are too coarse.
    ScenarioError
        If an argument is not allowed, or the scenario's vehicle steers on fixes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> values = {"run.duration": 60, "run.output_step": 0.1}
    >>> run = clpt.simulate(clpt.paper_scenario().with_values(values))
    >>> estimate = clpt.currents.flow_estimate(run, method="kalman")
    >>> estimate.theta.round(2).tolist()
    [[1.0, 0.4, 0.8], [0.9, 0.4, 0.8]]
    """
    if not isinstance(source, xarray.Dataset):
        if scenario is None:
            raise ScenarioError(
                "scenario: is required with legs. Give the scenario whose law learns"
            )
        return flow_of_legs(list(source), scenario)[0]
    if scenario is not None:
        raise ScenarioError("scenario: is that of the run. Leave it out")
    run = source
    if method not in METHODS:
        raise ScenarioError(f"method {method!r}: must be one of {', '.join(METHODS)}")
    scenario = run_scenario(run)
    segments, known = run_segments(run, scenario, every), scenario.known_to_law
    fix = 0.0 if scenario.localization is None else scenario.localization.noise
    usual_noise = np.hypot(segments.alone, np.sqrt(2) * fix)
    start = None
    if basis is None:
        basis, start = scenario.basis_block(), known.alpha_M
    n, sizes = len(segments.error), list(basis.output_ports.values())
    if basis.state_ports or list(basis.input_ports.values()) != [2] or len(sizes) != 1:
        raise ScenarioError(
            f"{basis.name}: is not a basis, a block x[2] -> phi_x[N] without states"
        )
    N = sizes[0]
    sd = _numbers("prior", PRIOR.usual(known) if prior is None else prior, (N,))
    r = _numbers("noise", usual_noise if noise is None else noise, (n,))
    theta = np.zeros((2, N)) if start is None else np.asarray(start)
    with np.errstate(all="ignore"):  # numbers that are not finite are refused below
        steps, P, h = METHODS[method](segments, basis, theta, sd, r)
        theta = steps[-1]
        scaled = np.array([*whitened(segments, h, r)])
        residuals = segments.error - h @ theta.T
    if not all(np.all(np.isfinite(values)) for values in (theta, P, scaled)):
        raise DataError(
            "the estimate is not finite. Give a smaller prior or more noise"
        )
    s = np.linalg.svd(scaled, compute_uv=False)
    condition = float(s[0] / s[-1]) if len(s) == len(P) and s[-1] > 0 else np.inf
    return FlowEstimate(theta, P, residuals, condition, steps, basis)


def _numbers(name: str, value: Any, shape: tuple[int]) -> np.ndarray:
    """Return positive numbers, one or one each."""
    try:
        values = np.broadcast_to(np.asarray(value, dtype=float), shape)
    except ValueError:
        values = np.array([np.nan])
    if not (np.all(np.isfinite(values)) and np.all(values > 0)):
        raise ScenarioError(f"{name}: must be a positive number, or {shape[0]} of them")
    return values


@public
def known_flow_scenario(scenario: Scenario, theta: np.ndarray) -> Scenario:
    """Feed the known-flow law of a scenario with an estimate.

    Parameters
    ----------
    scenario : Scenario
        With any law; what that law alone needs is left out.
    theta : array_like, shape (2, N)
        Such as `FlowEstimate.theta`.

    Returns
    -------
    Scenario
        With ``learning.law = "known-flow"`` and ``learning.theta_estimate``.

    Raises
    ------
    ScenarioError
        If theta is not two rows of N numbers.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> paper = clpt.paper_scenario()
    >>> clpt.currents.known_flow_scenario(paper, paper.flow.parameters).learning.law
    'known-flow'
    """
    learning = scenario.learning
    values: dict[str, Any] = {
        "learning.law": "known-flow",
        "learning.theta_estimate": np.asarray(theta, dtype=float),
        "learning.parameters": None,
    }
    if learning.row.settings:
        values[f"learning.{learning.row.table}"] = None
    gains = learning.used_gains
    if scenario.left_out or learning.row.at_fixes:
        values |= _simulated_truth(scenario, theta)
    elif not learning.adapt_gains:
        values |= {"learning.gain": None, "learning.gains": None}
    elif learning.gains is not None:
        values["learning.gains.parameters"] = None
    else:
        values["learning.gain"] = gains.feedback
    return scenario.with_values(values)


def _simulated_truth(scenario: Scenario, theta: np.ndarray) -> dict[str, Any]:
    """Return tables for a run in the learned flow, of those that the scenario leaves out.

    The vehicle visits the centers of the functions and stays for as long as it takes to cross a
    width at 1 m/s; the gain is that time's and that width's.
    """
    width = min(scenario.basis.widths)
    units = scenario.units
    dwell = width * METRES[units.length] / SECONDS[units.time]
    points = list(dict.fromkeys(scenario.basis.centers))
    truth = {
        "flow": {"parameters": np.asarray(theta, dtype=float).tolist()},
        "vehicle": {"feedback": [2 / dwell] * 2, "feedforward": [2 / dwell] * 2},
        "reference": {"kind": "waypoints", "points": points, "dwell": dwell},
        "run": {
            "duration": 2 * dwell * max(len(points), 2),
            "output_step": dwell / 100,
        },
    }
    added = {name: table for name, table in truth.items() if name in scenario.left_out}
    return {**added, "localization": None, "learning.gain": 1 / (width * dwell) ** 2}


# --- legs of a vehicle ----------------------------------------------------------------------------


def learn_leg(estimator: FlowEstimator, leg: Dive) -> Learned:
    """Learn from one leg."""
    # dives may overlap by rounded times
    start = max(leg.t_gps2, estimator.time)
    estimator.fix(start, *leg.start)
    elapsed, east, north = reckoned(leg)
    keep = np.diff(elapsed, prepend=-1.0) > 0
    points = np.array([elapsed, east, north]).T[keep]
    is_later = leg.t_gps2 + points[:, 0] > start
    points = points[(points[:, 0] == 0) | (is_later & (points[:, 0] < leg.duration))]
    points = np.vstack([points, [leg.duration, *leg.through_water]])
    for (_, *before), (time, *after) in pairwise(points):
        stretch = np.subtract(after, before)
        estimator.move(leg.t_gps2 + float(time), float(stretch[0]), float(stretch[1]))
    return estimator.fix(leg.t_gpse, *leg.end)


def flow_of_legs(
    legs: list[Dive], scenario: Scenario
) -> tuple[xarray.Dataset, FlowEstimator]:
    """Return the Dataset of `flow_estimate`, and the estimator after the last leg."""
    if not legs:
        raise DataError("no leg: a leg lies between two fixes. Give two fixes or more")
    estimator = FlowEstimator(scenario)
    learned = []
    for leg in legs:
        check()
        learned.append(learn_leg(estimator, leg))
    frame, _ = estimator.under_way
    flow = [estimator.flow(r.time, r.latitude, r.longitude) for r in learned]
    forecasts = [result.forecast for result in learned]
    start, end = (
        _dates(getattr(leg, key) for leg in legs) for key in ("t_gps2", "t_gpse")
    )
    north, east = "degrees_north", "degrees_east"
    error, region = "fix less forecast, before it was learned", f"{PERCENT} region"

    def column(values: Iterable[Any], name: str, units: str = "", *dims: str) -> tuple:
        attributes = {"long_name": name} | ({"units": units} if units else {})
        return ("leg", *dims), np.array([*values]), attributes

    def of(source: Iterable[Any], keys: str, *described: str) -> tuple:
        return column(map(attrgetter(*keys.split()), source), *described)

    data = xarray.Dataset(
        {
            "start_time": column(start, "last fix before the leg"),
            "end_time": column(end, "first fix after the leg"),
            "latitude": of(learned, "latitude", "latitude of the fix", north),
            "longitude": of(learned, "longitude", "longitude of the fix", east),
            "predicted_latitude": of(forecasts, "latitude", "forecast latitude", north),
            "predicted_longitude": of(
                forecasts, "longitude", "forecast longitude", east
            ),
            "position_error": of(learned, "error_east error_north", error, "m", "axis"),
            "forecast_radius": of(
                forecasts, "radius", f"radius of the forecast's {region}", "m"
            ),
            "inside": of(learned, "inside", f"fix in the {region} of its forecast"),
            "flow": column(flow, "learned flow at the fix", MPS, "axis"),
            "flow_parameters_estimate": of(
                *(learned, "flow_parameters", "estimate of theta after the leg"),
                *(MPS, "axis", "basis"),
            ),
            "standard_error": of(
                *(learned, "standard_error", "standard error of each row of theta"),
                *(MPS, "basis"),
            ),
        },
        {"leg": [leg.number for leg in legs], "axis": ["east", "north"]},
        {
            "fix_law": scenario.learning.law,
            "source": f"clpt-control {version('clpt-control')}",
            "origin": list(frame.place),
            "time_origin": str(np.datetime64(round(frame.time * 1e3), "ms")),
            "noise_scale": estimator.scale,
            "notes": [
                f"leg {leg.number}: its end fix {r.note}"
                for leg, r in zip(legs, learned, strict=True)
                if r.note
            ]
            + not_learned(estimator)
            + bent_legs(legs),
        },
    )
    return data, estimator


def not_learned(estimator: FlowEstimator) -> list[str]:
    """Return a note on functions that the track hardly teaches."""
    settings = estimator.settings
    share = (
        estimator.standard_error / np.maximum(settings.prior, 1e-300) / settings.speed
    )
    numbers = np.flatnonzero((share > HARDLY) & (settings.prior > 0)) + 1
    if not len(numbers):
        return []
    listed = ", ".join(map(str, numbers[:8])) + (", ..." if len(numbers) > 8 else "")
    which = "all functions" if len(numbers) == len(share) else f"functions {listed}"
    return [
        f"{which} hardly learned: their standard errors are still above {HARDLY:.0%} of the prior. "
        "Check origin, centers and widths against the fixes, or record more legs"
    ]


def bent_legs(legs: list[Dive]) -> list[str]:
    """Return a note on legs of a table whose way was not straight."""
    speeds = np.array(
        [hypot(*leg.through_water) / leg.duration for leg in legs if leg.track is None]
    )
    bent = int(np.sum(speeds < BENT * speeds.max())) if len(speeds) else 0
    if len(speeds) < 2 or 2 * bent < len(speeds):
        return []
    return [
        f"{bent} of {len(legs)} legs are shorter than {speeds.max():.2f} m/s x duration, as if the "
        "vehicle had turned or slowed. They are taken as straight: give the way between fixes "
        "(rows of time, course, speed) for a better estimate"
    ]


def _dates(times: Iterable[float]) -> np.ndarray:
    """Return s since 1970 UTC as dates."""
    return np.array([round(1e3 * t) for t in times], dtype="datetime64[ms]").astype(
        "datetime64[ns]"
    )
