"""Bounds on the learned flow before a vehicle sails that learns at fixes (law fix-regression).

The planned track is that of the scenario's vehicle in the flow that the law assumes at first, by
the running blocks.  `paper.laws.fix_bound` has the bound of its legs.  It holds for every flow and
every noise within the limits, if the prediction follows the plan; a missing fix is a longer leg,
and a fix that arrives late is not covered.

Speeds of options and results are in m/s, shear in 1/s.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import cumulative_simpson

from ...base.errors import ScenarioError
from ...base.figures import BLUE, RED, axes_for
from ...base.html import Result
from ...base.units import METRES, SECONDS, at_least, at_most, finite_or_none
from ...engine.model.block import evaluate
from ...paper.blocks.flow import STEEPEST, largest_shear
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

INTERVALS = (0.5, 1.0, 2.0, 3.0, 4.0)  # times that of the scenario
NODES = 16  # of a leg
MOST_LEGS = 5000
MISSIONS = 6
LAST = 0.25  # share of the plan on which the learned flow is judged


@dataclass(frozen=True)
class FixBounds:
    """Guaranteed errors of the learned flow by interval of fixes, m/s; inf: no guarantee."""

    interval: np.ndarray  # units.time
    flow: np.ndarray  # largest on the last quarter of the planned track
    parameter: np.ndarray  # of the worst flow parameter
    missions: np.ndarray  # largest error of the flow there in six made missions
    functions: int  # N
    duration: float  # units.time
    shear: float  # L, 1/s
    unmodelled: float  # d, m/s
    noise: float  # n, units.length
    prior: float  # largest |theta - theta_hat(0)|, m/s
    units: dict[str, str]

    def __repr__(self) -> str:
        return f"<FixBounds: {self.said}>"

    @property
    def said(self) -> str:
        """Sentence on the scenario's own interval, or on the longest with a guarantee."""
        known, own = np.flatnonzero(np.isfinite(self.flow)), INTERVALS.index(1.0)
        k = own if own in known else known[-1]
        length, time = self.units["length"], self.units["time"]
        none = f"with a fix each {self.interval[own]:g} {time} nothing is guaranteed; "
        return ("" if k == own else none) + (
            f"with a fix each {self.interval[k]:g} {time} the flow on the planned track is known "
            f"to {at_most(self.flow[k], 3)} m/s after {self.duration:g} {time}, if shear is at "
            f"most {at_least(self.shear, 3)}/s, the unmodelled flow at most "
            f"{at_least(self.unmodelled, 3)} m/s, each fix within {at_least(self.noise, 3)} "
            f"{length} ({SIGMAS:g} standard deviations), |theta - theta_hat(0)| at most "
            f"{at_least(self.prior, 3)} m/s, and the vehicle's prediction follows the plan"
        )

    @property
    def limit(self) -> str:
        """Sentence on the longest interval."""
        return limit_of(self.functions, self.shear, self.units["time"])

    @property
    def result(self) -> Result:
        """Table of the intervals."""
        time = self.units["time"]
        columns = [f"interval ({time})", "flow on the track at most (m/s)"]
        columns += ["worst parameter at most (m/s)"]
        columns += [f"largest of {MISSIONS} made missions (m/s)"]
        bounds = zip(self.flow, self.parameter, self.missions, strict=True)
        rows = [
            [
                f"{interval:g}",
                *("none" if not x < np.inf else at_most(x, 3) for x in row),
            ]
            for interval, row in zip(self.interval, bounds, strict=True)
        ]
        return Result(
            "Guaranteed before it sails", columns, rows, [self.said, self.limit]
        )

    def report(self) -> dict[str, Any]:
        """Return the fields ready for JSON."""
        fields: dict[str, Any] = dict(vars(self))
        for name in ("interval", "flow", "parameter", "missions"):
            fields[name] = [finite_or_none(x) for x in fields[name].tolist()]
        return {**fields, "said": self.said, "limit": self.limit}

    def plot(self, ax: "Axes | None" = None) -> "Axes":
        """Draw guaranteed and made errors against the interval."""
        axes = axes_for(ax, 6.0, 4.0)
        axes.semilogy(self.interval, self.flow, "o-", color=BLUE, label="guaranteed")
        label = f"largest of {MISSIONS} made missions"
        axes.semilogy(self.interval, self.missions, "s--", color=RED, label=label)
        axes.set_xlabel(f"interval between fixes ({self.units['time']})")
        axes.set_ylabel("error of the flow on the track (m/s)")
        axes.legend(frameon=False)
        return axes


def limit_of(N: int, shear: float, time: str) -> str:
    """Return a sentence on the longest interval with N functions; `shear` in 1/s."""
    gain = largest_gain(N)
    longest = gain / (shear * SECONDS[time])
    return (
        f"no guarantee of {N} function{'s' * (N > 1)} lasts beyond shear x interval = "
        f"{at_least(gain, 3)}, an interval of {at_least(longest, 3)} {time}"
    )


def certify_fixes(
    scenario: Scenario, shear: float | None, unmodelled: float | None
) -> FixBounds:
    """Return the bounds of a scenario of fixes at several intervals."""
    _check(scenario, shear, unmodelled)
    units = scenario.units.model_dump()
    metres, seconds = METRES[units["length"]], SECONDS[units["time"]]
    speed = metres / seconds
    # Step 1: limits of the sea and the fixes
    law = scenario.learning.row.parameters_of(scenario.known_to_law)
    prior, first = scenario.known_to_law.prior, -np.array(scenario.learning_parameters)
    theta = scenario.flow.parameters
    off = 0.0 if theta is None else float(np.linalg.norm(np.array(theta) - first))
    radius = max(1.0, off / prior)
    kernel, widths = scenario.basis.kernel, np.array(scenario.basis.widths)
    slopes = STEEPEST[kernel](widths)
    if shear is None:
        shear = largest_shear(kernel, widths, first, radius * prior) / seconds
    if unmodelled is None:
        unmodelled = max(UNMODELLED, largest_disturbance(scenario) * speed)
    fixes = scenario.localization
    assert fixes is not None
    limits = Limits(shear * seconds, unmodelled / speed, SIGMAS * fixes.noise)
    # Step 2: each interval
    plan = _Plan(scenario, fixes.interval, first, law.noise)
    theta_of = _flows(first, radius * prior, limits.shear, slopes)
    flow, parameter, made = [], [], []
    for factor in INTERVALS:
        bound, places = plan.bounded(factor, prior, radius, limits)
        before = radius * prior * np.linalg.norm(places, axis=-1).max()
        flow.append(_guaranteed(bound, places, before))
        parameter.append(_guaranteed(bound, np.eye(len(slopes))[None], radius * prior))
        errors = [
            plan.error(factor, places, theta_of(k), limits.unmodelled, k)
            for k in range(MISSIONS * np.isfinite(flow[-1]))
        ]
        made.append(max(errors, default=np.nan))
    N = scenario.basis.N
    if not np.any(np.isfinite(flow)):
        raise ScenarioError(
            f"no certificate: shear x interval is {limits.shear * fixes.interval:.2g}, and after "
            "the run nothing is guaranteed that the prior does not say; "
            f"{limit_of(N, shear, units['time'])}. Take fixes more often, or give the shear of "
            "the flow if it is smaller"
        )
    return FixBounds(
        interval=fixes.interval * np.array(INTERVALS),
        flow=speed * np.array(flow),
        parameter=speed * np.array(parameter),
        missions=speed * np.array(made),
        functions=N,
        duration=scenario.run.duration,
        shear=shear,
        unmodelled=unmodelled,
        noise=limits.noise,
        prior=radius * prior * speed,
        units=units,
    )


def _guaranteed(bound: ErrorBound, legs: np.ndarray, before: float) -> float:
    """Return the largest error for rows of legs, or inf if it is not below that before any fix."""
    with np.errstate(over="ignore", invalid="ignore"):
        largest = max(float(bound.at(rows).max()) for rows in legs)
    return largest if largest < before else np.inf


def _check(scenario: Scenario, shear: float | None, unmodelled: float | None) -> None:
    """Raise an error for a scenario of fixes without a certificate."""
    fixes = scenario.localization
    assert fixes is not None
    measured = scenario.flow.field is not None
    disturbance = scenario.flow.disturbance
    unbounded = disturbance is not None and not disturbance.row.bounded
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
    for key in ("latency", "dropouts"):
        if getattr(fixes, key) > 0:
            raise ScenarioError(
                f"no certificate: the plan has no localization.{key}. Set it to 0"
            )
    least = min(INTERVALS) * fixes.interval
    if scenario.run.duration > MOST_LEGS * least:
        raise ScenarioError(
            f"run.duration = {scenario.run.duration:g}: has more than {MOST_LEGS} intervals of "
            f"{least:g}. Shorten the run, or take fixes less often"
        )


def _flows(
    first: np.ndarray, size: float, shear: float, slopes: np.ndarray
) -> Callable[[int], np.ndarray]:
    """Return a function of a seed that draws theta within the limits."""

    def draw(seed: int) -> np.ndarray:
        eta = np.random.default_rng(seed).standard_normal(first.shape)
        eta *= size / np.linalg.norm(eta)
        theta = first + eta
        steepest = float(np.linalg.norm(theta, axis=0) @ slopes)
        return first + eta * min(1.0, shear / steepest)

    return draw


@dataclass(frozen=True)
class _Plan:
    """The scenario's vehicle, the interval of fixes, the law's first estimate, and r."""

    scenario: Scenario
    interval: float
    first: np.ndarray
    noise: float

    def bounded(
        self, factor: float, prior: float, radius: float, limits: Limits
    ) -> tuple[ErrorBound, np.ndarray]:
        """Return the bound after the plan, and phi on its last quarter."""
        times, phi, r = self._legs(factor)
        bound = ErrorBound(np.full(phi.shape[-1], prior), radius, limits)
        with np.errstate(over="ignore", invalid="ignore"):
            for m in cumulative_simpson(phi, x=times, axis=1, initial=0.0):
                bound.learn(LegRegressor(times, m), r)
        last = phi[-max(1, round(LAST * len(phi))) :]
        return bound, last

    def _legs(self, factor: float) -> tuple[np.ndarray, np.ndarray, float]:
        """Return times since a fix (n,), phi (legs, n, N) along the plan, and r."""
        run, r = self._run(factor, self.first, {"noise": 0.0}, None, NODES)
        times, z = run.time.values, run.predicted_position.values
        basis = self.scenario.basis_block("z")
        phi = evaluate(basis, times, z)
        count = (len(times) - 1) // NODES
        rows = NODES * np.arange(count)[:, None] + np.arange(NODES + 1)
        return times[: NODES + 1], phi[rows], r

    def error(
        self,
        factor: float,
        places: np.ndarray,
        theta: np.ndarray,
        unmodelled: float,
        seed: int,
    ) -> float:
        """Return the largest error of the flow on the plan after a made mission."""
        angle = np.random.default_rng(seed).uniform(0, 2 * np.pi)
        amplitude = unmodelled * np.array([np.cos(angle), np.sin(angle)])
        period = 10 * factor * self.interval
        disturbance = {
            "kind": "square",
            "amplitude": amplitude.tolist(),
            "period": period,
        }
        run, _ = self._run(factor, theta, {"seed": seed}, disturbance)
        off = theta - run.flow_parameters_estimate.values[-1]
        return float(np.linalg.norm(places @ off.T, axis=-1).max())

    def _run(
        self,
        factor: float,
        theta: np.ndarray,
        fixes: dict[str, Any],
        disturbance: Any,
        nodes: int = 1,
    ) -> tuple[Any, float]:
        """Return a run with a fix each `factor` intervals, and r; `nodes` samples of a leg."""
        interval = factor * self.interval
        legs = int(self.scenario.run.duration / interval * (1 + 1e-12))
        r = self.noise * max(1.0, factor)
        values = {
            "flow": {"parameters": theta.tolist(), "disturbance": disturbance},
            "learning.fix_regression.noise": r,
            "localization.interval": interval,
            **{f"localization.{key}": value for key, value in fixes.items()},
            "run.duration": legs * interval,
            "run.output_step": interval / nodes,
        }
        return simulate(self.scenario.with_values(values)), r
