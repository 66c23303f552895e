"""The printed bounds on |e|, Eqs. (16) and (33), beside a run.

    |e| <= |(theta - theta_hat) phi(x, t)| / mu,  mu < lambda_min(KD)      Eq. (16)
    |e| <= |Delta| / beta,                      beta < lambda_min(KD)      Eq. (33)

Each is taken at its kindest: the largest drive of the measured stretch, and the limit that any
mu or beta below lambda_min(KD) allows.  A ratio above 1 then refutes it.

Scalar counterexamples to Eqs. (16) and (33), run exactly.

    d/dt [e, eta] = A(w) [e, eta] + [Delta, 0]            Eqs. (28) and (32)

One axis, one basis function w = phi, z = zc = 0.  While w and
Delta stand still, the matrix exponential of [[A, Delta], [0, 0]] carries the state on without
error of integration.  Delta may as well be the residual (theta - theta_hat) phi of Eq. (16).

- A square wave at the resonance sqrt(gamma): limsup|e| -> 4/pi as gamma grows, the first
  harmonic of the wave passed on in full.
- Drift, then burst: a faint regressor eps lets the parameter error drift to -Delta/eps; a
  regressor of 1 then turns it into an error of about 0.55/eps.

Counterexamples on the paper's own system: Eqs. (16) and (33), Theorems 3.2 and 3.3.

V' < 0 outside a ball in e is no bound on e, since V also holds parameter errors: what the
disturbance drives into them comes back through the regressor.

A vehicle of limited speed does not fly what Eq. (7) commands: Theorem 3.2 is lost without hedging,
where nothing tells the learner (`blocks.vehicle`).

Theorem 3.3 asks that the desired position zc is exciting, Assumption 3.1.  The joint regressor
w = [phi, z, zc] of Eq. (31) must be: a basis function of Eq. (5) that vanishes on the track
leaves its parameter where it started, by Eq. (21), alpha' = -gamma e phi^T.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..arguments import check_holds, public
from ..errors import ScenarioError
from ..scenario.experiment import Scenario
from ..scenario.file import paper_scenario
from ..simulation.flows import flow_velocity
from ..simulation.integrate import sample_times, simulate
from .excitation.gramian import started_true
from .excitation.regressor import error_matrices

if TYPE_CHECKING:
    import xarray

# law -> the equation of its bound
PRINTED = {"known-flow": "(16)", "learned-flow": "(33)"}


@dataclass(frozen=True)
class PrintedBound:
    """A printed bound on |e| beside what the equations do, where it was measured."""

    equation: str
    k: float  # lambda_min(KD), per time
    times: np.ndarray  # (nt,)
    size: np.ndarray  # |e|, length, (nt,)
    drive: np.ndarray  # the size of what drives e, length per time, (nt,)

    def __repr__(self) -> str:
        return f"<PrintedBound {self.equation}: largest |e| is {self.ratio:.4g} of what is printed>"

    @property
    def peak(self) -> float:
        """The largest |e|, length."""
        return float(self.size.max())

    @property
    def claimed(self) -> float:
        """The largest drive over k: the printed bound's limit, length."""
        return float(self.drive.max()) / self.k

    @property
    def ratio(self) -> float:
        """peak / claimed: above 1 the printed bound is violated."""
        return self.peak / self.claimed

    @property
    def rms(self) -> float:
        """Root mean square of e, over that of the drive divided by k."""
        e, drive = (
            np.trapezoid(values**2, self.times) for values in (self.size, self.drive)
        )
        return float(self.k * np.sqrt(e / drive))


def drive_along(scenario: Scenario, run: "xarray.Dataset") -> np.ndarray:
    """Return what drives e along a run, length per time, shape (nt, 2).

    Delta of Eq. (32); with the known-flow law Delta + (theta - theta_hat) phi(x, t), Eq. (16).
    """
    if scenario.flow.parameters is None:
        raise ScenarioError(
            "flow.field: a gridded field has no parameters theta to compare with"
        )
    known = scenario.learning.row.given_estimate
    estimate = scenario.learning.theta_estimate if known else scenario.flow.parameters
    modelled = flow_velocity(
        scenario, run.position.values, run.time.values, np.array(estimate)
    )
    return run.true_flow.values - modelled


@public
def printed_bound(
    scenario: Scenario, run: "xarray.Dataset", start: float
) -> PrintedBound:
    """Set a run beside the bound printed for its law.

    Parameters
    ----------
    scenario : Scenario
        With flow parameters theta; its law chooses Eq. (16) or Eq. (33).
    run : xarray.Dataset
        Its run, finely sampled.
    start : float
        Measure from here on, units.time.

    Returns
    -------
    PrintedBound
        `peak` and `claimed` in units.length, their `ratio`, which is above 1 where the bound is
        violated, and `rms`, that of e over that of what drives it divided by lambda_min(KD).

    Raises
    ------
    ScenarioError
        If the true flow is a gridded field, which has no theta, or the law is not one of
        the paper's.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> wave = {"kind": "square", "amplitude": [0.05, 0.0], "period": 1.8}
    >>> scenario = clpt.theory.started_true(clpt.paper_scenario()).with_values(
    ...     {"flow.disturbance": wave, "run.duration": 40, "run.output_step": 0.05}
    ... )
    >>> clpt.theory.printed_bound(scenario, clpt.simulate(scenario), 0.0).ratio > 1
    True
    """
    law = scenario.learning.law
    if law not in PRINTED:
        raise ScenarioError(
            f'learning.law = "{law}": has no printed bound; must be {" or ".join(PRINTED)}'
        )
    check_holds(
        "printed_bound: run",
        run,
        ["time", "clpe"],
        "clpt.simulate(scenario) makes a run",
    )
    late = run.time.values >= start
    return PrintedBound(
        PRINTED[law],
        min(scenario.vehicle.feedback),
        run.time.values[late],
        np.hypot(*run.clpe.values[late].T),
        np.hypot(*drive_along(scenario, run)[late].T),
    )


# A stretch of time: how long, A (n, n), what is added to the derivative (n,), and how many samples
Piece = tuple[float, np.ndarray, np.ndarray, int]
PUSHED = np.array([1.0, 0.0])  # Delta = 1, on (e, eta)


def scalar_matrix(w: float, gain: float = 1.0) -> np.ndarray:
    """Return A of the scalar system, [[-1, w], [-gain w, 0]], on (e, eta)."""
    nothing = np.zeros(2)
    return error_matrices(np.array([w]), nothing, nothing, np.ones(2), gain)[0, :2, :2]


def exact_run(
    pieces: Iterable[Piece], start: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return times (nt,), 0 and those sampled, and states (nt, n) from a start (n,)."""
    from scipy.linalg import expm

    times, states = [0.0], [np.append(start, 1.0)]
    for duration, A, drive, samples in pieces:
        rates = np.vstack([np.column_stack([A, drive]), np.zeros(len(A) + 1)])
        step = expm(rates * (duration / samples))
        times += (times[-1] + duration * np.arange(1, samples + 1) / samples).tolist()
        for _ in range(samples):
            states.append(step @ states[-1])
    return np.array(times), np.array(states)[:, :-1]


def _scalar_bound(pieces: list[Piece], start: float) -> PrintedBound:
    times, states = exact_run(pieces, np.zeros(2))
    late = times >= start
    e, drive = np.abs(states[late, 0]), np.ones(late.sum())
    return PrintedBound(PRINTED["learned-flow"], 1.0, times[late], e, drive)


def square_wave_counterexample(gain: float = 100.0, periods: int = 60) -> PrintedBound:
    """Run Delta = +1, -1 in turn at sqrt(gamma), phi = k = 1, from e = eta = 0.

    There are 200 samples per half period; the last quarter of the run is measured.
    """
    A, half = scalar_matrix(1.0, gain), np.pi / np.sqrt(gain)
    pieces = [
        (half, A, sign * PUSHED, 200) for _ in range(periods) for sign in (1.0, -1.0)
    ]
    return _scalar_bound(pieces, 1.5 * periods * half)


def burst_counterexample(
    faint: float = 0.2, quiet: float = 250.0, cycles: int = 4
) -> PrintedBound:
    """Run Delta = 1 with a regressor that is faint, then 1, from e = eta = 0.

    The regressor is periodic and so persistently exciting.  `quiet` is the length of its faint
    stretch, well above 1/(gamma faint^2), k = gamma = 1.  Peaks come back in every cycle, near
    0.55 (1/faint - 1); the second half of the cycles is measured.
    """
    drift = quiet, scalar_matrix(faint), PUSHED, 400
    burst = 20.0, scalar_matrix(1.0), PUSHED, 1000
    return _scalar_bound([drift, burst] * cycles, cycles // 2 * (quiet + burst[0]))


AMPLITUDE = 0.05  # m/s
# rad/s: near sqrt(gamma |w|^2) of the paper's x1 axis at its far waypoints
RESONANT = 3.5


def with_square_wave(
    scenario: Scenario, amplitude: float, frequency: float
) -> Scenario:
    """Return the scenario started true, with Delta = (amplitude sign(sin(frequency t)), 0)."""
    wave = {
        "kind": "square",
        "amplitude": [amplitude, 0.0],
        "period": 2 * np.pi / frequency,
    }
    return started_true(scenario).with_values({"flow.disturbance": wave})


@public
def disturbance_counterexample(
    start: float = 400.0,
    end: float = 800.0,
    samples: int = 50,
    progress: Callable[[float], None] | None = None,
) -> PrintedBound:
    """Violate Eq. (33) on the paper's system by a square wave.

    It has 0.05 m/s and 3.5 rad/s, on axis 1.

    Parameters
    ----------
    start, end : float
        Measured from start to end of the run, s.
    samples : int
        Per half period of the square wave.
    progress : callable, optional
        Called with the time reached.

    Returns
    -------
    PrintedBound
        Started at the true parameters, so that nothing but Delta makes e.

    Raises
    ------
    ScenarioError
        If a value is not allowed.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = clpt.theory.disturbance_counterexample(start=0.0, end=40.0)
    >>> found.ratio > 1, round(found.claimed, 4)
    (True, 0.05)
    """
    scenario = with_square_wave(paper_scenario(), AMPLITUDE, RESONANT)
    scenario = scenario.with_values({"run.duration": end})
    run = simulate(
        scenario, sample_times(end, np.pi / RESONANT / samples), progress=progress
    )
    return printed_bound(scenario, run, start)


def known_flow_counterexample(
    start: float = 400.0, end: float = 1200.0, step: float = 0.02
) -> PrintedBound:
    """Violate Eq. (16): true gains, gamma = 0.03, one entry of theta_hat wrong by 0.1 m/s.

    Slow adaptation stores the tidal residual of one waypoint in K and Gamma and gives it back
    at the next.  At the paper's gain 0.8 a short search over single wrong entries found no
    violation.  Measured from start to end, s, at samples each `step`.
    """
    true = started_true(paper_scenario())
    estimate = np.array(true.flow.parameters)
    estimate[1, 0] -= 0.1
    scenario = true.with_values(
        {
            "learning.law": "known-flow",
            "learning.parameters": None,
            "learning.theta_estimate": estimate,
            "learning.gain": 0.03,
            "run.duration": end,
        }
    )
    return printed_bound(scenario, simulate(scenario, sample_times(end, step)), start)


def limited_speed_counterexample(
    end: float = 400.0, max_speed: float = 1.5
) -> tuple[float, float]:
    """Refute Theorem 3.2 of a vehicle whose speed is limited, where nothing tells the learner.

    Started at the true parameters, so that nothing but what is not flown makes e.  Return the
    largest |e| with hedging and without, length, on runs to `end`, s.
    """
    scenario = started_true(paper_scenario()).with_values(
        {"vehicle.max_speed": max_speed, "run.duration": end, "run.output_step": 0.1}
    )
    hedged, unhedged = (
        simulate(scenario.with_values({"learning.hedging": hedging})).clpe.values
        for hedging in (True, False)
    )
    return float(np.hypot(*hedged.T).max()), float(np.hypot(*unhedged.T).max())


class Unlearned(NamedTuple):
    """A parameter that stands still while zc is exciting."""

    kappa: float  # smallest eigenvalue of int zc zc^T over a cycle, length^2 time
    function: int  # number of the basis function, from 1
    moved: float  # how far the estimate went from its start at most, length per time
    error: float  # smallest error of the estimate at the end, length per time


def unlearned_counterexample(end: float = 400.0, function: int = 2) -> Unlearned:
    """Refute "zc exciting is enough" of Theorem 3.3, on a run to `end`, s.

    With the kernel exp(-d^2/s) of Eq. (5) the second function, exp(-d^2/5) around (10, 10),
    vanishes on the circle.
    """
    scenario = paper_scenario().with_values(
        {"basis.kernel": "gaussian-sigma", "run.duration": end, "run.output_step": 0.5}
    )
    run = simulate(scenario)
    zc, k = scenario.waypoints, function - 1
    estimates = run.flow_parameters_estimate.values[:, :, k]
    return Unlearned(
        float(np.linalg.eigvalsh(scenario.reference.dwell * zc.T @ zc)[0]),
        function,
        float(np.abs(estimates - estimates[0]).max()),
        float(np.abs(estimates[-1] - np.array(scenario.flow.parameters)[:, k]).min()),
    )
