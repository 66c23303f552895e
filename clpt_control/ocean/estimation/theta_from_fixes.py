"""theta of Eq. (3) from fixes, of a run or of dives, for the known-flow law (Remark 3.2).

The methods are those of `fix_to_fix`.  A basis for a glider's dives has currents everywhere, and
gaussians at the places:

    steady: phi = 1;  a tide: cos(w t) and sin(w t);  a place: exp(-|x - c|^2/(2 width^2))

Only starts and dead reckoning of the dives are read for it.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import xarray

from ...base.arguments import public
from ...base.errors import DataError, ScenarioError
from ...engine.model.block import Block
from ...paper.blocks.flow import flow_basis
from ...paper.laws.law import PRIOR
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.tidal_periods import period
from .dive import Dive
from .fix_to_fix import METHODS, whitened
from .gaussian_lattice import gaussian_centers
from .priors import Priors
from .segments import dive_segments, run_scenario, run_segments

WIDE = 1e12  # m, of a gaussian that is 1 everywhere on Earth


@dataclass(frozen=True)
class FlowEstimate:
    """An estimate of theta with how well it is known.

    Attributes
    ----------
    theta : ndarray, shape (2, N)
        In the unit of speed of the run; m/s for dives.
    covariance : ndarray, shape (N, N)
        Of each row of theta; an upper bound where one noise of the position lasts over fixes.
    misses : ndarray, shape (n, 2)
        What theta leaves of the segments' misses, length.
    condition_number : float
        The largest over the smallest singular value of the integrals h, each over its noise.
    steps : ndarray, shape (k, 2, N)
        theta after each segment of the filter or each iteration of the tomography.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> dive = clpt.gliders.make_dive(1, (0.0, 0.0, 8.0), (9000.0, 0.0, 8.02), (500.0, 0.0))
    >>> basis, prior = clpt.estimation.dive_basis([dive], width=None)
    >>> found = clpt.estimation.flow_estimate([dive], basis=basis, prior=prior)
    >>> found.theta.round(2).tolist(), found.miss(dive).round()
    ([[0.19], [0.0]], array([1696.,    0.]))
    """

    theta: np.ndarray
    covariance: np.ndarray
    misses: np.ndarray
    condition_number: float
    steps: np.ndarray
    basis: Block = field(repr=False)
    origin: tuple[float, float] | None = None

    def __repr__(self) -> str:
        axes = (", ".join(f"{one:.4g}" for one in row) for row in self.theta)
        apart = ", ".join(f"{one:.2g}" for one in self.standard_deviation)
        return f"<FlowEstimate: theta {'; '.join(axes)}; standard deviation {apart} on both axes>"

    @property
    def standard_deviation(self) -> np.ndarray:
        """Of each theta, shape (N,): the same for both axes."""
        return np.sqrt(np.diag(self.covariance))

    @public
    def miss(self, dive: Dive) -> np.ndarray:
        """Forecast a dive's miss, (2,), m; its end is not read."""
        if self.origin is None:
            raise DataError("the estimate is of a run; one of dives forecasts dives")
        segments = dive_segments([dive], self.origin)
        track = segments.predicted(self.basis, self.theta)[0]
        return track[-1] - segments.start[0] - segments.water[0, -1]


@public
def flow_estimate(
    data: "xarray.Dataset | Sequence[Dive]",
    method: str = "least-squares",
    *,
    basis: Block | None = None,
    every: float | None = None,
    prior: float | np.ndarray | None = None,
    noise: float | np.ndarray | None = None,
) -> FlowEstimate:
    """Estimate the flow parameters theta from fix to fix.

    Parameters
    ----------
    data : xarray.Dataset or sequence of Dive
        A run, whose vehicle has a fix each `every`, or dives in their order.
    method : str
        ``"least-squares"``, ``"kalman"`` or ``"tomography"``, which of a run reads the fixes and
        the velocity through the water, and no position between.
    basis : Block, optional
        phi of Eq. (5) at x; of a run that of its scenario. `dive_basis` makes one for dives.
    every : float, optional
        Time between fixes of a run; by default a tenth of ``reference.dwell``.
    prior : float or array_like, shape (N,), optional
        Standard deviation of each theta before any fix; by default the law's of a run, 0.3 k R
        with the mean k of KD and the track's reach R, and 0.3 m/s of dives.
    noise : float or array_like, shape (n,), optional
        Standard deviation of a miss, length: by default of dives 30 m and 0.04 m/s over their time
        (`Priors`), of a run 1e-4 R, or what its samples leave open where that is more, and
        2^(1/2) ``localization.noise``. What a run's miss has beyond 1e-4 R is of its two fixes,
        half of the variance each; its neighbours share them.

    Returns
    -------
    FlowEstimate
        `theta`, its `covariance`, what is left of the `misses`, and the `steps` to it.

    Raises
    ------
    DataError
        If there is no segment, a number is not finite, the run's samples are too coarse, or the
        tomography does not settle.
    ScenarioError
        If an argument is not allowed, or the scenario's vehicle steers on fixes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> values = {"run.duration": 60, "run.output_step": 0.1}
    >>> run = clpt.simulate(clpt.paper_scenario().with_values(values))
    >>> found = clpt.estimation.flow_estimate(run, "tomography")
    >>> found.theta.round(2).tolist()
    [[1.0, 0.4, 0.8], [0.9, 0.4, 0.8]]
    """
    if method not in METHODS:
        raise ScenarioError(f"method {method!r}: must be one of {', '.join(METHODS)}")
    origin, usual_prior, start = None, Priors().current, None
    walk = 0.0  # of the prior, by the root of time: of dives 0.13 in six hours
    if isinstance(data, Sequence):
        if not data:
            raise DataError("no dives are given; give one at least")
        if basis is None or every is not None:
            raise ScenarioError(
                "dives need a basis, such as that of dive_basis, and no every"
            )
        origin = (data[0].lat_gps2, data[0].lon_gps2)
        segments, sea = dive_segments(data, origin), Priors().gradient
        time = np.array([dive.duration for dive in data])
        usual_noise = np.hypot(Priors().fix, sea.scatter * time)
        walk = np.sqrt(2 / sea.memory)  # that of a current, scaled
    else:
        scenario = run_scenario(data)
        segments, known = run_segments(data, scenario, every), scenario.known_to_law
        usual_prior = PRIOR.usual(known)
        fix = 0.0 if scenario.localization is None else scenario.localization.noise
        usual_noise = np.full(
            len(segments.start), np.hypot(segments.alone, np.sqrt(2) * fix)
        )
        if basis is None:
            basis, start = scenario.basis_block(), known.alpha_M
    n, sizes = len(segments.start), list(basis.output_ports.values())
    if basis.state_ports or list(basis.input_ports.values()) != [2] or len(sizes) != 1:
        raise ScenarioError(
            f"{basis.name}: is no basis, a block x[2] -> phi_x[N] without states"
        )
    N = sizes[0]
    sd = _numbers("prior", usual_prior if prior is None else prior, (N,))
    r = _numbers("noise", usual_noise if noise is None else noise, (n,))
    theta = np.zeros((2, N)) if start is None else np.asarray(start)
    finite = all(np.all(np.isfinite(part)) for part in segments[:4])
    if not (finite and np.all(segments.duration > 0)):
        raise DataError(
            "a segment is not finite, or has no time; clpt.gliders.usable leaves it out"
        )
    with np.errstate(all="ignore"):  # what is not finite is refused
        steps, P, h = METHODS[method](segments, basis, theta, sd, r, walk * sd)
        theta = steps[-1]
        scaled, left = whitened(segments, h, r), segments.miss - h @ theta.T
    if not all(np.all(np.isfinite(part)) for part in (theta, P, scaled)):
        raise DataError(
            "the estimate is not finite; give a smaller prior or more noise"
        )
    s = np.linalg.svd(scaled, compute_uv=False)
    condition = float(s[0] / s[-1]) if len(s) == len(P) and s[-1] > 0 else np.inf
    return FlowEstimate(theta, P, left, condition, steps, basis, origin)


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
    >>> clpt.estimation.known_flow_scenario(paper, paper.flow.parameters).learning.law
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
    if not learning.adapt_gains:
        values |= {"learning.gain": None, "learning.gains": None}
    elif learning.gains is not None:
        values["learning.gains.parameters"] = None
    else:
        values["learning.gain"] = gains.feedback
    return scenario.with_values(values)


@public
def dive_basis(
    dives: Sequence[Dive],
    width: float | None = 20e3,
    constituents: Sequence[str] = ("steady",),
) -> tuple[Block, np.ndarray]:
    """Make a flow basis for dives, and what is believed of it before.

    Parameters
    ----------
    dives : sequence of Dive
        In their order; their ends are not read.
    width : float or None
        Of the gaussians, m, which stand 1.5 widths apart where the track comes near; None for
        no gaussians.
    constituents : sequence of str
        Currents that are the same everywhere: ``"steady"``, ``"M2"``, ...

    Returns
    -------
    basis : Block
        phi of Eq. (5), x in m east and north of the first dive's start, time in s since 1970.
    prior : ndarray, shape (N,)
        Standard deviation of each parameter, m/s (`Priors`).

    Raises
    ------
    DataError
        If there is no dive.
    ScenarioError
        If a constituent is unknown, or there is no function.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> basis, prior = clpt.estimation.dive_basis(clpt.gliders.sample_dives(), width=20e3)
    >>> basis.output_ports, prior[:2].tolist()
    ({'phi_x': 9}, [0.3, 0.15])
    """
    if not dives:
        raise DataError("no dive is given; a basis of dives needs one at least")
    priors, sine = Priors(), -math.pi / 2
    rows = []  # center, width, frequency, phase, prior
    for name in constituents:
        w = 2 * math.pi / period(name, "s")
        sd = priors.tide if w else priors.current
        rows += [
            ((0.0, 0.0), WIDE, w, phase, sd) for phase in ((0.0, sine) if w else (0.0,))
        ]
    if width is not None:
        if not (math.isfinite(width) and width > 0):
            raise ScenarioError(
                f"width = {width:g} m: must be positive, or None for no gaussians"
            )
        for center in gaussian_centers(dives, width):
            rows.append((center, width, 0.0, 0.0, priors.gaussian))
    if not rows:
        raise ScenarioError("no function: give a constituent or a width")
    *functions, prior = (np.array(column) for column in zip(*rows, strict=True))
    return flow_basis("basis_x", "x", "gaussian", *functions), prior
