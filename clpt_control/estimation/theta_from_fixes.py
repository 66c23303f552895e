"""theta of Eq. (3) from fixes, of a run or of dives, for the known-flow law (Remark 3.2).

What a segment between two fixes shows (`segments`), and three ways to one number:

    y_s = theta h_s + n_s,    n_s ~ r_s^2 I,    each row of theta ~ prior^2    (`segments`)

least-squares   theta = theta_0 + (sum y~ h^T/r^2) P,  P^-1 = P_0^-1 + sum h h^T/r^2,
                y~ = y - theta_0 h, with h along the track that is known
kalman          the same one by one, P <- P + w^2 dt I before each: k = P h/(r^2 + h^T P h),
                theta <- theta + (y - theta h) k^T, P <- P - k h^T P
tomography      the track is not known: h along the track that theta predicts, least squares for
                theta, and again until it settles.  Then y is what the predicted track misses by

P is N x N and serves both axes.  Without a walk w the filter ends at least squares.

Neighbouring misses of a run share a fix: n_s = r_s (a_s + m_s - m_{s-1}), a_s of this miss alone
and m_s of the fix at the end of s; their variances are `Segments.shares`.  The n_s are a moving
average of order 1; where a_s = 0 their covariance is r^2, and -r^2/2 beside the diagonal.  A
filter whose only state is the last fix's noise makes white innovations of them, of y and of h
(`whitened`): generalised least squares; the filter of theta has that noise as one more state.
Where the track itself is read with noise, theta h is as wrong as that noise makes phi
(`Segments.blur`).

A basis for a glider's dives has currents everywhere, and gaussians at the places:

    steady: phi = 1;  a tide: cos(w t) and sin(w t);  a place: exp(-|x - c|^2/(2 width^2))

Only starts and dead reckoning of the dives are read for it.

Sources: R. E. Kalman, "A new approach to linear filtering and prediction problems", 1960; P. J.
Brockwell, R. A. Davis, "Time Series: Theory and Methods", 1991, section 5.3 (innovations); D.
Chang, W. Wu, C. R. Edwards, F. Zhang, "Motion tomography: mapping flow fields using autonomous
underwater vehicles", International Journal of Robotics Research 36, 320-336, 2017.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import xarray

from ..arguments import public
from ..blocks.flow import flow_basis
from ..blocks.laws.law import PRIOR
from ..equations.block import Block
from ..errors import DataError, ScenarioError
from ..progress.interrupt import check
from ..scenario.experiment import Scenario
from ..scenario.tidal_periods import period
from .dive import Dive
from .fix_model import SPACING, WIDTH, Priors, near
from .segments import dive_segments, run_scenario, run_segments

MOST = 100  # iterations of the tomography
SETTLED = 1e-9  # of the prior
WIDE = 1e12  # m, of a gaussian that is 1 everywhere on Earth


def regularised(h, y, theta, sd) -> tuple[np.ndarray, np.ndarray]:
    """Return theta and P of regularised least squares: h (n, N), y (n, 2), of unit noise."""
    scaled = h * sd  # in units of the prior
    if not np.all(np.isfinite(scaled)):
        raise DataError("the prior is too large for the noise; give a smaller prior or more noise")
    U, s, Vt = np.linalg.svd(scaled, full_matrices=len(h) < len(sd))
    moved = Vt[: len(s)].T @ ((s / (1 + s**2))[:, None] * (U.T @ (y - h @ theta.T)))
    share = np.ones(len(sd))  # of the prior that is left along each row of Vt
    share[: len(s)] = 1 / (1 + s**2)
    return theta + (sd[:, None] * moved).T, sd[:, None] * ((Vt.T * share) @ Vt) * sd


def whitened(segments, columns, r, blur=0.0):
    """Return columns (n, c) as innovations over their standard deviation: white, of size 1."""
    alone, fix = segments.shares(r)
    alone = alone + fix * blur
    white, last, p = columns / r[:, None], np.zeros(columns.shape[1]), fix[0]
    for k, new in enumerate(segments.renewed):
        S = new * (p + fix[k]) + alone[k]
        innovation = white[k] + new * last  # one noise read twice leaves no trace
        white[k] = innovation / np.sqrt(S)
        if new:
            last, p = fix[k] / S * innovation, fix[k] - fix[k] ** 2 / S
    return white


def expected_blur(theta, P, B):
    """Return what is expected of theta B theta^T, of the axis where it is larger."""
    known = np.einsum("...kl,ak,al->...a", B, theta, theta).max(axis=-1)
    return known + np.einsum("...kl,kl->...", B, P)


def generalised(segments, h, theta, sd, r, blur=0.0) -> tuple[np.ndarray, np.ndarray]:
    """Return theta and P of generalised least squares along a track."""
    if not np.all(np.isfinite(h)):
        raise DataError(
            "phi along the tracks is not finite; where they are predicted, give fixes more often "
            "or a smaller prior"
        )
    white = whitened(segments, np.hstack([h, segments.miss]), r, blur)
    return regularised(white[:, :-2], white[:, -2:], theta, sd)


def batch_least_squares(segments, basis, theta, sd, r, w):
    """Return theta, P, the steps and h of batch least squares."""
    h, B = segments.integrals(basis, segments.known_track), segments.blur(basis)
    first, P = theta, np.diag(sd**2)
    for _ in range(3 if segments.noise_period else 1):
        theta, P = generalised(segments, h, first, sd, r, expected_blur(theta, P, B))
    return theta, P, theta[None], h


def kalman(segments, basis, theta, sd, r, w):
    """Return theta, P, the steps and h of the filter, causal: each segment after its end."""
    h, B, N = segments.integrals(basis, segments.known_track), segments.blur(basis), len(sd)
    alone, fix = segments.shares(r)
    x, P = np.pad(theta, ((0, 0), (0, 2))), np.diag([*sd**2, fix[0], 0.0])
    steps, before = [], segments.time[0, -1]
    for k, new in enumerate(segments.renewed):
        P[:N, :N] += np.diag(w**2 * max(segments.time[k, -1] - before, 0.0))
        before = segments.time[k, -1]
        variance = alone[k] + fix[k] * expected_blur(x[:, :N], P[:N, :N], B[k])
        P[N + 1, N + 1] = fix[k]  # the states: theta, and of r the fixes' noise at start and end
        row = np.append(h[k] / r[k], [-1.0, 1.0] if new else [0.0, 0.0])
        gain = P @ row / (variance + row @ P @ row)
        x = x + np.outer(segments.miss[k] / r[k] - x @ row, gain)
        rest = np.eye(N + 2) - np.outer(gain, row)
        P = rest @ P @ rest.T + variance * np.outer(gain, gain)
        steps.append(x[:, :N])
        last = [*range(N), N + 1 if new else N]  # the end is the next one's start
        x, P = np.pad(x[:, last], ((0, 0), (0, 1))), np.pad(P[np.ix_(last, last)], (0, 1))
    return steps[-1], P[:N, :N], np.array(steps), h


def tomography(segments, basis, theta, sd, r, w):
    """Return theta, P, the steps and h where tracks are predicted, until theta settles."""
    first, steps = theta, []
    for _ in range(MOST):
        check()
        h = segments.integrals(basis, segments.predicted(basis, theta))
        before, (theta, P) = theta, generalised(segments, h, first, sd, r)
        steps.append(theta)
        if np.max(np.abs(theta - before) / sd) < SETTLED:
            return theta, P, np.array(steps), h
    raise DataError(
        f"the tomography does not settle in {MOST} iterations: its last moved theta by "
        f"{np.abs(theta - before).max():.2g}; give fixes more often, a smaller prior or fewer "
        "functions"
    )


METHODS: dict[str, Callable[..., Any]] = {
    "least-squares": batch_least_squares,
    "kalman": kalman,
    "tomography": tomography,
}


@dataclass(frozen=True)
class FlowEstimate:
    """An estimate of theta with how well it is known.

    Attributes
    ----------
    theta : ndarray, shape (2, N)
        In the unit of speed of the run; m/s for dives.
    covariance : ndarray, shape (N, N)
        Of each row of theta.
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
    walk: float | np.ndarray | None = None,
    start: np.ndarray | None = None,
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
    walk : float or array_like, shape (N,), optional
        Of each theta, for the filter alone: speed per square root of time; by default 0 of a run,
        and of dives 0.13 of the prior in six hours (`Priors`).
    start : array_like, shape (2, N), optional
        theta before any fix; by default alpha_M of a run, 0 of dives.

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
    origin, usual_prior, usual_start = None, Priors().current, None
    usual_walk = 0.0  # of the prior
    if isinstance(data, Sequence):
        if not data:
            raise DataError("no dives are given; give one at least")
        if basis is None or every is not None:
            raise ScenarioError("dives need a basis, such as that of dive_basis, and no every")
        origin = (data[0].lat_gps2, data[0].lon_gps2)
        segments, sea = dive_segments(data, origin), Priors().gradient
        time = np.array([dive.duration for dive in data])
        usual_noise = np.hypot(Priors().fix, sea.scatter * time)
        usual_walk = np.sqrt(2 / sea.memory)  # that of a current, scaled
    else:
        scenario = run_scenario(data)
        segments, of_run = run_segments(data, scenario, every)
        basis, known = of_run if basis is None else basis, scenario.known_to_law
        usual_prior = PRIOR.usual(known)
        fix = 0.0 if scenario.localization is None else scenario.localization.noise
        usual_noise = np.full(len(segments.start), np.hypot(segments.alone, np.sqrt(2) * fix))
        usual_start = known.alpha_M if basis is of_run else None
    n, sizes = len(segments.start), list(basis.output_ports.values())
    if basis.state_ports or list(basis.input_ports.values()) != [2] or len(sizes) != 1:
        raise ScenarioError(f"{basis.name}: is no basis, a block x[2] -> phi_x[N] without states")
    N = sizes[0]
    sd = _numbers("prior", usual_prior if prior is None else prior, (N,))
    r = _numbers("noise", usual_noise if noise is None else noise, (n,))
    if walk is not None and method != "kalman":
        raise ScenarioError(f'walk: is for the method "kalman", not for "{method}"')
    w = _numbers("walk", usual_walk * sd if walk is None else walk, (N,), zero=True)
    usual = np.zeros((2, N)) if usual_start is None else usual_start
    theta = usual if start is None else np.asarray(start, dtype=float)
    if theta.shape != (2, N) or not np.all(np.isfinite(theta)):
        raise ScenarioError(f"start: must be 2 rows of {N} finite numbers")
    if not all(np.all(np.isfinite(part)) for part in segments[:4]):
        raise DataError("a fix or the way through the water is not finite; leave it out")
    if not np.all(segments.duration > 0):
        raise DataError("a segment does not end after it begins; clpt.gliders.usable leaves it out")
    with np.errstate(all="ignore"):  # what is not finite is refused
        theta, P, steps, h = METHODS[method](segments, basis, theta, sd, r, w)
        scaled, left = whitened(segments, h, r), segments.miss - h @ theta.T
    if not all(np.all(np.isfinite(part)) for part in (theta, P, scaled)):
        raise DataError("the estimate is not finite; give a smaller prior or more noise")
    s = np.linalg.svd(scaled, compute_uv=False)
    condition = float(s[0] / s[-1]) if len(s) == len(P) and s[-1] > 0 else np.inf
    return FlowEstimate(theta, P, left, condition, steps, basis, origin)


def _numbers(name: str, value: Any, shape: tuple[int], zero: bool = False) -> np.ndarray:
    """Return positive numbers, one or one each."""
    try:
        values = np.broadcast_to(np.asarray(value, dtype=float), shape)
    except ValueError:
        values = np.array([np.nan])
    if not (np.all(np.isfinite(values)) and np.all(values >= 0 if zero else values > 0)):
        allowed = "zero or positive" if zero else "positive"
        raise ScenarioError(f"{name}: must be a {allowed} number, or {shape[0]} of them")
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
    dives: Sequence[Dive], width: float | None = WIDTH, constituents: Sequence[str] = ("steady",)
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
        rows += [((0.0, 0.0), WIDE, w, phase, sd) for phase in ((0.0, sine) if w else (0.0,))]
    if width is not None:
        if not (math.isfinite(width) and width > 0):
            raise ScenarioError(f"width = {width:g} m: must be positive, or None for no gaussians")
        places = None
        for dive in dives:
            places = near(places, dive, width)
        for i, j in places.cells if places else ():
            center = (SPACING * width * i, SPACING * width * j)
            rows.append((center, width, 0.0, 0.0, priors.gaussian))
    if not rows:
        raise ScenarioError("no function: give a constituent or a width")
    *functions, prior = (np.array(column) for column in zip(*rows, strict=True))
    return flow_basis("basis_x", "x", "gaussian", *functions), prior
