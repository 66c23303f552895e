"""theta of Eq. (3) from recorded fixes of a vehicle, or of a simulated run.

Each leg (`dives.Dive`: two fixes and the way through the water between them) goes through
`FlowEstimator`, so that feeding legs at once is feeding their fixes one by one.  The learned flow
along the track is that of the parameters after the last leg, at each fix.  With tomography these
parameters are those of all legs at once; each forecast is still made before its fix is seen.
"""

from collections.abc import Iterable
from math import hypot
from operator import attrgetter
from typing import Any

import numpy as np
import xarray

from ...base.arguments import public
from ...base.errors import DataError, ScenarioError, refuse_unused
from ...base.geodesy import displacement
from ...base.progress.interrupt import check
from ...base.run_attributes import versions
from ...base.units import DEGREES, METRES
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.file import scenario_to_text
from ...paper.scenario.run_track import run_scenario
from ..gliders.dives import Dive, reckoned
from ..gliders.unmeasured import question
from .fix_model import PERCENT
from .fix_settings import LocalFrame, rotated
from .flow_estimator import FlowEstimator, Learned, flow_by, move_through
from .leg_chain import FlownLeg
from .leg_guesses import WALKS
from .leg_track import LONG, Leg
from .run_legs import legs_of_run
from .tomography import Tomography, tomography

METHODS = ("kalman", "tomography")
BENT = 0.9  # share of its way at most from which on a leg is straight
HARDLY = 0.7  # share of the prior's standard deviation that is left
MOST_WIDTHS = 200  # of a function, that a leg crosses
LEAST, LARGEST = 1e-9, 1e3  # prior and noise of runs
MPS = "m s-1"


@public
def flow_estimate(
    source: "xarray.Dataset | list[Dive]",
    scenario: Scenario | None = None,
    *,
    method: str = "kalman",
    every: float | None = None,
    prior: float | None = None,
    noise: float | None = None,
    every_row: bool = False,
) -> xarray.Dataset:
    """Estimate the flow parameters theta from fixes.

    Parameters
    ----------
    source : list of Dive, or xarray.Dataset
        Recorded legs of `read_dives`, or a run of `simulate`, whose vehicle has a fix each `every`.
    scenario : Scenario, optional
        With legs: basis functions and law for fixes, as `FlowEstimator` takes them.  A run has its
        own.
    method : str
        ``"kalman"``, leg by leg by the scenario's law (`fix-regression` for a run), or
        ``"tomography"``, all legs at once, which also finds eddies that turn far between fixes.
    every : float, optional
        Of a run: time between fixes; by default a tenth of ``reference.dwell``.
    prior : float, optional
        Of a run: standard deviation of each theta before any fix; by default the law's, 0.3 k R
        with the mean k of KD and the track's reach R.
    noise : float, optional
        Of a run: standard deviation of a position error, length: by default 1e-4 R, or the error of
        the run's samples if that is larger, and 2^(1/2) ``localization.noise``.
    every_row : bool, optional
        With legs: each position was measured, also where other rows predict it.

    Returns
    -------
    xarray.Dataset
        The error of each forecast, the learned flow and the parameters after each leg, in m and
        m/s.

    Raises
    ------
    DataError
        If a number is not finite, the run's samples are too coarse, or positions look computed
        from other rows (`every_row`).
    ScenarioError
        If an argument is not allowed, or the scenario's vehicle steers on fixes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> values = {"run.duration": 60, "run.output_step": 0.1}
    >>> run = clpt.simulate(clpt.paper_scenario().with_values(values))
    >>> estimate = clpt.currents.flow_estimate(run, every=5.0)
    >>> estimate.flow_parameters_estimate.values[-1].round(2).tolist()
    [[1.0, 0.4, 0.8], [0.9, 0.4, 0.8]]
    """
    check_method(method)
    if isinstance(source, xarray.Dataset):
        refuse_unused("is that of the run. Leave it out", scenario=scenario)
        refuse_unused("is of legs. Leave it out", every_row=every_row or None)
        return flow_of_run(source, method, every, prior, noise)[0]
    if scenario is None:
        raise ScenarioError(
            "scenario: is required with legs. Give the scenario whose law learns"
        )
    reason = "is of runs. Set the law's keys in the scenario"
    refuse_unused(reason, every=every, prior=prior, noise=noise)
    return flow_of_legs(list(source), scenario, method, every_row=every_row)[0]


def check_method(method: str) -> None:
    """Reject an unknown method."""
    if method not in METHODS:
        raise ScenarioError(f"method {method!r}: must be one of {', '.join(METHODS)}")


# --- legs -----------------------------------------------------------------------------------------


def flow_of_run(
    run: xarray.Dataset,
    method: str,
    every: float | None,
    prior: float | None,
    noise: float | None,
) -> tuple[xarray.Dataset, np.ndarray]:
    """Return the Dataset of `flow_estimate`, and theta in the scenario's units."""
    for name, value in (("prior", prior), ("noise", noise)):
        if value is not None and not LEAST <= value <= LARGEST:
            raise ScenarioError(
                f"{name} = {value:g}: must be a positive number, {LEAST:g} to {LARGEST:g}"
            )
    legs, scenario, frame = legs_of_run(run, every, prior, noise)
    if method == "tomography" and "measured_position" in run:
        raise ScenarioError(
            "localization.noise_period: a noise that is held is no noise of a fix, which "
            "tomography takes. Use method kalman"
        )
    flow = run_scenario(run).flow
    is_spanned = flow.parameters is not None and flow.disturbance is None
    return flow_of_legs(legs, scenario, method, frame, is_spanned)


def stretches_of(leg: Dive, start: float) -> np.ndarray:
    """Return the way of a leg from a start on: time (s since 1970), east and north (m), (n, 3)."""
    elapsed, east, north = reckoned(leg)
    keep = np.diff(elapsed, prepend=-1.0) > 0
    points = np.array([elapsed, east, north]).T[keep]
    is_later = leg.t_gps2 + points[:, 0] > start
    points = points[(points[:, 0] == 0) | (is_later & (points[:, 0] < leg.duration))]
    points = np.vstack([points, [leg.duration, *leg.through_water]])
    return np.column_stack([leg.t_gps2 + points[1:, 0], np.diff(points[:, 1:], axis=0)])


def learn_leg(estimator: FlowEstimator, leg: Dive) -> Learned:
    """Learn from one leg."""
    # dives may overlap by rounded times
    start = max(leg.t_gps2, estimator.time)
    estimator.fix(start, *leg.start)
    move_through(estimator, stretches_of(leg, start))
    return estimator.fix(leg.t_gpse, *leg.end)


def tomography_of(estimator: FlowEstimator, legs: list[Dive]) -> Tomography:
    """Return the estimate of all legs at once; the estimator has learned them one by one."""
    track, settings = estimator.track, estimator.settings
    flown, last, last_fix = [], -np.inf, legs[0].start
    position = np.zeros(2)  # of the last fix, by displacements from fix to fix
    for leg in legs:
        start = max(leg.t_gps2, last)
        frame = estimator._frame_at(*leg.start)
        place, end = frame.point(*leg.start), frame.point(*leg.end)
        t = frame.own_time(start)
        flow = leg.miss_east / frame.metres / (frame.own_time(leg.t_gpse) - t)
        under_way = Leg(t, place.tolist(), t, flow=flow)
        under_way.move(frame, stretches_of(leg, start), track.size)
        if estimator.is_everywhere:
            # by local east and north in the middle of each leg, one behind the other
            _, growth = frame.axes(place)
            under_way.turn(-growth * under_way.east / 2)
            drifted = np.array(displacement(*last_fix, *leg.start)) / frame.metres
            begin = position + drifted
            under_way.place = begin.tolist()
            end = position = begin + rotated(end, -growth * under_way.east / 2)
        bend = track.bend(under_way, estimator.fastest)
        flown.append(FlownLeg(under_way, end, bend))
        last, last_fix = leg.t_gpse, leg.end
    found = tomography(flown, settings, track)
    turns = [
        track.turn(track.end(one.leg, found.theta), found.theta, 0.0).learned
        for one in found.legs
    ]
    if max(turns) > LONG and found.wild:
        found.notes.append(
            f"tomography: {found.wild} fixes are wild and the flow turns by more than {LONG:g} "
            "radians between fixes: the estimate may be wrong by 1 m/s. Remove the wild fixes"
        )
    elif found.wild:
        found.notes.append(
            f"tomography: fixes left out, as no flow explains them: {found.wild}"
        )
    return found


def flow_of_legs(
    legs: list[Dive],
    scenario: Scenario,
    method: str,
    frame: LocalFrame | None = None,
    is_spanned: bool = False,
    every_row: bool = False,
    **limits: float,
) -> tuple[xarray.Dataset, np.ndarray]:
    """Return the Dataset of `flow_estimate`, and theta in the scenario's units.

    The frame is that of a simulated run, whose ways are exact, and whose flow the functions may
    span; `limits` are those of the estimator. Positions that look computed are refused, unless
    `every_row` was measured.
    """
    if not legs:
        raise DataError("no leg: a leg lies between two fixes. Give two fixes or more")
    estimator = FlowEstimator(scenario, **limits)
    is_run = frame is not None
    width = scenario.basis.lengths.min() * METRES[scenario.units.length]
    way = float(np.median([hypot(*leg.over_ground) for leg in legs]))
    if not is_run and way > MOST_WIDTHS * width:
        raise DataError(
            f"legs are {way / 1000:.3g} km long, and the narrowest function {width:.3g} m wide: "
            "check units.length and basis.widths"
        )
    if not (is_run or every_row) and (looks := question(*_rows_of(legs))):
        raise DataError(
            f"{looks}. Give a column that marks fixes (fix, dead_reckoning, position_qc), or, if "
            "each was measured, --every-row (every_row=True)"
        )
    has_origin = not is_run or scenario.origin is not None
    if frame is not None:
        estimator.frame, estimator.settings.bent = frame, 0.0
    estimator.is_live = False
    estimator.is_screened = not (is_run or every_row)
    estimator.settings.beside *= not is_spanned
    unspanned = float(estimator.settings.prior.max()) * (not is_spanned)
    learned, used, refused, shown = [], [], [], []
    covariances: list[Any] = []
    for leg in legs:
        check()
        try:
            result = learn_leg(estimator, leg)
        except DataError as beyond:
            refused.append(f"leg {leg.number}: not learned: {beyond}")
            continue
        if result.forecast is None:
            refused.append(f"leg {leg.number}: not learned: {result.note}")
        else:
            learned.append(result)
            used.append(leg)
            shown.append(estimator.under_way[1].shown)
            covariances.append([estimator.covariance] * 2)
    if not used:
        raise DataError(refused[0])
    legs = used
    settings, speed = estimator.settings, estimator.settings.speed
    theta = estimator.flow_parameters
    scale, notes = estimator.scale, []
    turns = [result.turn for result in learned]
    guaranteed = [result.guaranteed for result in learned]
    guarantee = estimator.guarantee
    if method == "tomography":
        guaranteed = [np.inf] * len(learned)
        guarantee = "no error is guaranteed: tomography has no bound"
        found = tomography_of(estimator, legs)
        theta, covariances[-1] = found.theta * speed, found.covariance
        scale, notes = found.scale, found.notes
    variances = np.diagonal(covariances[-1], axis1=1, axis2=2).max(axis=0)
    errors = np.sqrt(np.maximum(variances, 0.0)) * speed
    estimator.turn = 0.0 if method == "tomography" else max(turns)
    if is_run:
        estimator.ways = []  # whose motion is its own
    notes = estimator.warnings + notes + refused
    frame, _ = estimator.under_way
    flow = [
        flow_by(estimator, theta / speed, r.time, r.latitude, r.longitude)
        for r in learned
    ]
    forecasts = [result.forecast for result in learned]
    start, end = (
        _dates(getattr(leg, key) for leg in legs) for key in ("t_gps2", "t_gpse")
    )
    north, east = DEGREES.values()
    error, region = "fix less forecast, before it was learned", f"{PERCENT} region"

    def column(values: Iterable[Any], name: str, units: str = "", *dims: str) -> tuple:
        attributes = {"long_name": name} | ({"units": units} if units else {})
        for standard, degrees in DEGREES.items():
            if units == degrees:
                attributes["standard_name"] = standard
        return ("leg", *dims), np.array([*values]), attributes

    def of(source: Iterable[Any], keys: str, *described: str) -> tuple:
        return column(map(attrgetter(*keys.split()), source), *described)

    data = xarray.Dataset(
        {
            "start_time": column(start, "last fix before the leg"),
            "end_time": column(end, "first fix after the leg"),
            "start_latitude": of(legs, "lat_gps2", "latitude of the fix before", north),
            "start_longitude": of(
                legs, "lon_gps2", "longitude of the fix before", east
            ),
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
            "flow_parameters_estimate": column(
                [*(r.flow_parameters for r in learned[:-1]), theta],
                "estimate of theta after the leg",
                MPS,
                "axis",
                "basis",
            ),
            "standard_error": column(
                [*(r.standard_error for r in learned[:-1]), errors],
                "standard error of each row of theta",
                MPS,
                "basis",
            ),
            "covariance": column(
                np.array(covariances) * speed**2,
                "covariance of each row of theta",
                "m2 s-2",
                "axis",
                "basis",
                "other_basis",
            ),
            "leg_flow": column(
                np.array(shown) * speed, "mean flow along the leg", MPS, "axis"
            ),
            "turn": column(turns, "turn of the flow along the leg", "rad"),
            "guaranteed": column(
                guaranteed, "guaranteed error of the flow at the fix", MPS
            ),
        },
        {
            "leg": column([leg.number for leg in legs], "number of the leg"),
            "axis": ["east", "north"],
        },
        {
            "Conventions": "CF-1.11",
            "fix_law": scenario.learning.law,
            "scenario": scenario_to_text(scenario),
            "fix_method": method,
            "source": versions("clpt-control"),
            "origin": list(frame.place),
            "has_origin": int(has_origin),  # else a made one, of a run in a plane
            "time_origin": str(np.datetime64(round(frame.time * 1e3), "ms")),
            "noise_scale": scale,
            # standard deviations far from functions or from the track, and beside functions that
            # are the same everywhere, m/s
            "unspanned_flow": unspanned * speed,
            "scatter": estimator.scale * settings.scatter * (not is_spanned) * speed,
            # standard deviation of the walk of each parameter after 1 s, m/s
            "walk": (scenario.learning.law == WALKS)
            * estimator.settings.p.walk
            * speed
            / frame.seconds**0.5,
            "guarantee": guarantee,
            "notes": notes
            + [
                f"leg {leg.number}: {r.note}"
                for leg, r in zip(legs, learned, strict=True)
                if r.note
            ]
            + not_learned(estimator, errors)
            + bent_legs(legs),
        },
    )
    return data, theta / speed


def _rows_of(legs: list[Dive]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return times, places and steps through the water of the fixes of legs, each once."""
    rows = list[tuple[complex, ...]]()
    for leg in legs:
        rows.append((leg.t_gps2, *leg.start, np.nan))
        rows.append((leg.t_gpse, *leg.end, complex(*leg.through_water)))
    times, north, east, steps = np.array(rows).T
    is_new = np.append(True, np.diff(times.real) > 0.0)
    places = np.column_stack([north.real, east.real])
    return times.real[is_new], places[is_new], steps[is_new][1:]


def not_learned(estimator: FlowEstimator, errors: np.ndarray) -> list[str]:
    """Return a note on functions that the track hardly teaches."""
    settings = estimator.settings
    share = errors / np.maximum(settings.prior, 1e-300) / settings.speed
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
