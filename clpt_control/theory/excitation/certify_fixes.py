"""Bounds on the learned flow before a vehicle sails that learns at fixes (law fix-regression).

The planned track is that of the scenario's vehicle in the flow that the law assumes at first, by
the running blocks.  `paper.laws.fix_bound` has the bound of its legs.  It holds for every flow and
every noise within the limits, if the prediction follows the plan; a fix that arrives late is not
covered.  Beside it stand made missions: runs with noise, disturbance and flows within the limits.

Speeds of options and results are in m/s, shear in 1/s.
"""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import cumulative_simpson

from ...base.errors import ScenarioError
from ...base.figures import BLUE, RED, axes_for
from ...base.html import Result
from ...base.units import METRES, SECONDS, at_least, at_most, finite_or_none
from ...engine.model.block import evaluate
from ...paper.blocks.flow import largest_shear
from ...paper.laws.fix_bound import (
    SIGMAS,
    UNMODELLED,
    ErrorBound,
    LegRegressor,
    Limits,
    largest_gain,
)
from ...paper.scenario.experiment import Scenario
from ...simulation.integrate import simulate
from ..laws.promises import largest_disturbance

if TYPE_CHECKING:
    from matplotlib.axes import Axes

INTERVALS = (1.0, 0.5, 2.0, 3.0, 4.0)  # times that of the scenario, which is the first
NODES = 16  # of a leg
MOST_LEGS = 5000
MISSIONS = 6
LAST = 0.25  # least share of the plan on which the learned flow is judged; a cycle is, if longer


@dataclass(frozen=True)
class FixBounds:
    """Guaranteed errors of the learned flow by interval of fixes, m/s; inf: no guarantee."""

    interval: np.ndarray  # units.time
    flow: np.ndarray  # largest on the last cycle, or quarter, of the planned track
    parameter: np.ndarray  # of the worst flow parameter
    missions: np.ndarray  # largest error of the flow there in six made missions
    shear: float  # L, 1/s
    unmodelled: float  # d, m/s
    noise: float  # n, units.length
    prior: float  # largest |theta - theta_hat(0)|, m/s
    said: str  # the bound at the scenario's interval, or at one with a guarantee
    limit: str  # the longest interval
    units: dict[str, str]

    def __repr__(self) -> str:
        return f"<FixBounds: {self.said}>"

    @property
    def result(self) -> Result:
        """Table of the intervals."""
        columns = [
            f"interval ({self.units['time']})",
            "flow on the track at most (m/s)",
            "worst parameter at most (m/s)",
            f"largest of {MISSIONS} made missions (m/s)",
        ]
        numbers = zip(
            self.interval, self.flow, self.parameter, self.missions, strict=True
        )
        rows = [
            [at_most(x, 3) if np.isfinite(x) else "none" for x in row]
            for row in numbers
        ]
        sentences = [self.said, self.limit]
        return Result("Guaranteed before it sails", columns, rows, sentences)

    def report(self) -> dict[str, Any]:
        """Return the fields ready for JSON."""
        return finite_or_none(vars(self))

    def plot(self, ax: "Axes | None" = None) -> "Axes":
        """Draw guaranteed and made errors against the interval."""
        axes = axes_for(ax, 6.0, 4.0)
        label = f"largest of {MISSIONS} made missions"
        style = {"linestyle": "-", "marker": "o"}
        axes.semilogy(self.interval, self.flow, color=BLUE, label="guaranteed", **style)
        axes.semilogy(self.interval, self.missions, color=RED, label=label, **style)
        axes.set_xlabel(f"interval between fixes ({self.units['time']})")
        axes.set_ylabel("error of the flow on the track (m/s)")
        axes.legend(frameon=False)
        return axes


def certify_fixes(
    scenario: Scenario, shear: float | None, unmodelled: float | None
) -> FixBounds:
    """Return the bounds of a scenario of fixes at several intervals."""
    interval = _checked_interval(scenario, shear, unmodelled)
    units, basis = scenario.units.model_dump(), scenario.basis
    length, time = units["length"], units["time"]
    speed = METRES[length] / SECONDS[time]
    # Step 1: limits of the sea and the fixes
    context = scenario.known_to_law
    noise = scenario.learning.row.parameters_of(context).noise
    estimate, prior = -np.array(scenario.learning_parameters), context.prior
    theta = estimate if scenario.flow.parameters is None else scenario.flow.parameters
    radius = max(1.0, float(np.linalg.norm(theta - estimate)) / prior)
    spread = radius * prior
    if shear is None:
        usual = largest_shear(basis.kernel, basis.widths, estimate, spread)
        shear = usual / SECONDS[time]
    if unmodelled is None:
        unmodelled = max(UNMODELLED, largest_disturbance(scenario) * speed)
    largest = SIGMAS * scenario.localization.noise  # type: ignore[union-attr]
    limits = Limits(shear * SECONDS[time], unmodelled / speed, largest)
    # Step 2: each interval, and the places of the last cycle or quarter
    duration = scenario.run.duration
    judged = min(duration, max(LAST * duration, scenario.cycle))
    rows = []
    most = scenario.run.duration / interval
    for factor in sorted(x for x in INTERVALS if x <= most):
        T, r = factor * interval, max(1.0, factor) * noise
        times, phi = _planned(scenario, T, r, estimate)
        bound = ErrorBound(np.full(basis.N, prior), radius, limits)
        judged_phi = phi[-max(1, math.ceil(judged / T - 1e-9)) :]
        with np.errstate(over="ignore", invalid="ignore"):
            for m in cumulative_simpson(phi, x=times, axis=1, initial=0.0):
                bound.learn(LegRegressor(times, m), r)
            errors = [
                _guaranteed(bound, a, spread) for a in (judged_phi, np.eye(basis.N))
            ]
        missions = MISSIONS * np.isfinite(errors[0])
        errors_of_missions = [
            _made(scenario, T, r, estimate, spread, limits, k) for k in range(missions)
        ]
        off = [
            np.linalg.norm(judged_phi @ eta.T, axis=-1).max()
            for eta in errors_of_missions
        ]
        rows.append([T, *(speed * x for x in (*errors, max(off, default=np.nan)))])
    # Step 3: sentences
    gain, s = largest_gain(basis.N), "s" * (basis.N > 1)
    limit = (
        f"no guarantee of {basis.N} function{s} lasts beyond shear x interval = "
        f"{at_least(gain, 3)}, an interval of {at_least(gain / limits.shear, 3)} {time}"
    )
    by_interval = {T: flow for T, flow, *_ in rows if np.isfinite(flow)}
    if not by_interval:
        raise ScenarioError(
            f"no certificate: shear x interval is {limits.shear * interval:.2g}, and after the run "
            f"nothing is guaranteed that the prior does not say; {limit}. Take fixes more often, "
            "or give the shear of the flow if it is smaller"
        )
    T = interval if interval in by_interval else max(by_interval)
    no_bound = f"with a fix each {interval:g} {time} nothing is guaranteed; "
    said = (
        f"with a fix each {T:g} {time} the flow on the last {judged:g} {time} of the planned track "
        "is known to "
        f"{at_most(by_interval[T], 3)} m/s after {scenario.run.duration:g} {time}, if shear is at "
        f"most {at_least(shear, 3)}/s, the unmodelled flow at most {at_least(unmodelled, 3)} m/s, "
        f"each fix within {at_least(largest, 3)} {length} ({SIGMAS:g} standard deviations), "
        f"|theta - theta_hat(0)| at most {at_least(speed * spread, 3)} m/s, and the vehicle's "
        "prediction follows the plan"
    )
    columns = ("interval", "flow", "parameter", "missions")
    return FixBounds(
        **dict(zip(columns, np.array(rows).T, strict=True)),
        shear=shear,
        unmodelled=unmodelled,
        noise=largest,
        prior=speed * spread,
        said=said if interval == T else no_bound + said,
        limit=limit,
        units=units,
    )


def _guaranteed(bound: ErrorBound, legs: np.ndarray, spread: float) -> float:
    """Return the largest error for rows of legs, or inf if it is not below that before any fix."""
    largest = max(float(bound.at(np.atleast_2d(rows)).max()) for rows in legs)
    before = spread * float(np.linalg.norm(legs, axis=-1).max())
    return largest if largest < before else np.inf


def _checked_interval(
    scenario: Scenario, shear: float | None, unmodelled: float | None
) -> float:
    """Return the interval of fixes; reject scenarios without a certificate."""
    fixes, delta = scenario.localization, scenario.flow.disturbance
    assert fixes is not None
    measured = scenario.flow.field is not None
    unbounded = delta is not None and not delta.row.bounded
    if unmodelled is not None and not 0 <= unmodelled < np.inf:
        raise ScenarioError(f"unmodelled = {unmodelled:g}: must be 0 or more, m/s")
    if shear is None and measured:
        raise ScenarioError(
            "shear: cannot be derived, as flow.field is no flow of the functions. Give --shear, "
            "the largest shear of the flow in 1/s"
        )
    if unmodelled is None and (measured or unbounded):
        raise ScenarioError(
            "unmodelled: the flow that the functions do not express has no known bound. Give "
            "--unmodelled in m/s"
        )
    if fixes.latency > 0 or fixes.dropouts > 0:
        raise ScenarioError(
            "no certificate: in the plan each fix arrives, and at once. Set localization.latency "
            "and localization.dropouts to 0"
        )
    least = min(INTERVALS) * fixes.interval
    if scenario.run.duration > MOST_LEGS * least:
        raise ScenarioError(
            f"run.duration = {scenario.run.duration:g}: has more than {MOST_LEGS} intervals of "
            f"{least:g}. Shorten the run, or take fixes less often"
        )
    return fixes.interval


def _flown(
    scenario: Scenario, T: float, r: float, flow: dict[str, Any], **run: Any
) -> Any:
    """Return a run with a fix each T."""
    duration = T * int(scenario.run.duration / T * (1 + 1e-12))
    values = {
        "flow": flow,
        "learning.fix_regression.noise": r,
        "localization.interval": T,
        "run.duration": duration,
    }
    return simulate(scenario.with_values(values | run))


def _planned(
    scenario: Scenario, T: float, r: float, estimate: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return times since a fix (n,), and phi (legs, n, N) along the plan."""
    exact = {"localization.noise": 0.0, "run.output_step": T / NODES}
    run = _flown(scenario, T, r, {"parameters": estimate.tolist()}, **exact)
    times, z = run.time.values, run.predicted_position.values
    phi = evaluate(scenario.basis_block("z"), times, z)
    starts = np.arange(0, len(times) - NODES, NODES)
    return times[: NODES + 1], phi[starts[:, None] + np.arange(NODES + 1)]


def _made(
    scenario: Scenario,
    T: float,
    r: float,
    estimate: np.ndarray,
    spread: float,
    limits: Limits,
    seed: int,
) -> np.ndarray:
    """Return the error of theta, (2, N), after a made mission."""
    rng = np.random.default_rng(seed)
    eta, along = rng.standard_normal(estimate.shape), rng.standard_normal(2)
    eta *= spread / np.linalg.norm(eta)
    basis = scenario.basis
    steepest = largest_shear(basis.kernel, basis.widths, estimate + eta, 0.0)
    theta = estimate + eta * min(1.0, limits.shear / steepest)
    amplitude = limits.unmodelled * along / np.linalg.norm(along)
    delta = {"kind": "square", "amplitude": amplitude.tolist(), "period": 10 * T}
    flow = {"parameters": theta.tolist(), "disturbance": delta}
    settings = {"localization.seed": seed, "run.output_step": T}
    run = _flown(scenario, T, r, flow, **settings)
    return theta - run.flow_parameters_estimate.values[-1]
