"""Counterexamples to Eqs. (16) and (33), and to Theorems 3.2 and 3.3.

    |e| <= |(theta - theta_hat) phi(x, t)| / mu,  mu < lambda_min(KD)      Eq. (16)
    |e| <= |Delta| / beta,                      beta < lambda_min(KD)      Eq. (33)

`printed_bound` compares a run with the printed bound, for the largest drive of the measured
stretch and the limit of mu and beta; a ratio above 1 refutes the bound.  V' < 0 outside a ball in e
does not bound e, since V also contains parameter errors, which return through the regressor.
The scalar examples, d/dt [e, eta] = A(w) [e, eta] + [Delta, 0] of Eqs. (28) and (32) with
z = zc = 0, are computed by matrix exponentials.  Theorem 3.3 requires an exciting joint
regressor w = [phi, z, zc], not only an exciting zc.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ...base.arguments import check_holds
from ...base.errors import ScenarioError
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.file import paper_scenario
from ...simulation.flows import flow_velocity
from ...simulation.integrate import simulate
from ...simulation.requests import sample_times

if TYPE_CHECKING:
    import xarray

# law -> the equation of its bound
PRINTED = {"known-flow": "(16)", "learned-flow": "(33)"}


@dataclass(frozen=True)
class PrintedBound:
    """A printed bound on |e| compared with |e| along a run."""

    equation: str
    k: float  # lambda_min(KD), per time
    times: np.ndarray  # (nt,)
    size: np.ndarray  # |e|, length, (nt,)
    drive: np.ndarray  # the size of what drives e, length per time, (nt,)

    def __repr__(self) -> str:
        ratio = f"{self.ratio:.4g}"
        return (
            f"<PrintedBound {self.equation}: largest |e| is {ratio} of what is printed>"
        )

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
        e = np.trapezoid(self.size**2, self.times)
        drive = np.trapezoid(self.drive**2, self.times)
        return float(self.k * np.sqrt(e / drive))


def drive_along(scenario: Scenario, run: "xarray.Dataset") -> np.ndarray:
    """Return the drive of e along a run, length per time, shape (nt, 2).

    The drive is Delta of Eq. (32), for the known-flow law with (theta - theta_hat) phi, Eq. (16).
    """
    if scenario.flow.parameters is None:
        raise ScenarioError(
            "flow.field: a gridded field has no parameters theta to compare with"
        )
    learning, theta = scenario.learning, scenario.flow.parameters
    estimate = np.array(
        learning.theta_estimate if learning.row.given_estimate else theta
    )
    positions, times = run.position.values, run.time.values
    return run.true_flow.values - flow_velocity(scenario, positions, times, estimate)


def printed_bound(
    scenario: Scenario, run: "xarray.Dataset", start: float
) -> PrintedBound:
    """Compare a run with the bound printed for its law.

    >>> import clpt_control as clpt
    >>> wave = {"kind": "square", "amplitude": [0.05, 0.0], "period": 1.8}
    >>> scenario = clpt.paper_scenario().started_true().with_values(
    ...     {"flow.disturbance": wave, "run.duration": 40, "run.output_step": 0.05}
    ... )
    >>> printed_bound(scenario, clpt.simulate(scenario), 0.0).ratio > 1
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


# duration, A (n, n), constant drive (n,) and number of samples
Stretch = tuple[float, np.ndarray, np.ndarray, int]
DELTA = np.array([1.0, 0.0])  # drive of (e, eta) by Delta = 1


def scalar_matrix(w: float, gain: float = 1.0) -> np.ndarray:
    """Return A of the scalar system, [[-1, w], [-gain w, 0]], on (e, eta)."""
    return np.array([[-1.0, w], [-gain * w, 0.0]])


def exact_run(
    stretches: Iterable[Stretch], start: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return times (nt,) from 0 and states (nt, n) from a start (n,)."""
    from scipy.linalg import expm

    times, states = [0.0], [np.append(start, 1.0)]
    for duration, A, drive, samples in stretches:
        rates = np.vstack([np.column_stack([A, drive]), np.zeros(len(A) + 1)])
        step = expm(rates * (duration / samples))
        times += (times[-1] + duration * np.arange(1, samples + 1) / samples).tolist()
        for _ in range(samples):
            states.append(step @ states[-1])
    return np.array(times), np.array(states)[:, :-1]


def _scalar_bound(stretches: list[Stretch], start: float) -> PrintedBound:
    """Return the comparison of a scalar run from rest with Eq. (33)."""
    times, states = exact_run(stretches, np.zeros(2))
    late = times >= start
    e = np.abs(states[late, 0])
    equation = PRINTED["learned-flow"]
    return PrintedBound(equation, 1.0, times[late], e, np.ones_like(e))


def square_wave_counterexample() -> PrintedBound:
    """Run Delta = +1, -1 in turn at sqrt(gamma) = 10, the resonance, phi = k = 1, from e = eta = 0.

    limsup |e| -> 4/pi as gamma grows: the first harmonic of the wave.  There are 200 samples per
    half period; the last quarter of 60 periods is measured.
    """
    A, duration = scalar_matrix(1.0, 100.0), np.pi / 10.0
    period = [(duration, A, sign * DELTA, 200) for sign in (1.0, -1.0)]
    return _scalar_bound(period * 60, 90 * duration)


def burst_counterexample() -> PrintedBound:
    """Run Delta = 1 with a regressor w that is 0.2, then 1, from e = eta = 0.

    The faint regressor lets eta drift to -Delta/w; the regressor of 1 turns eta into an error
    near 0.55 (1/w - 1) in every cycle.  The faint stretch has a length well above 1/(gamma w^2),
    k = gamma = 1.  The second half of four cycles is measured.
    """
    drift = 250.0, scalar_matrix(0.2), DELTA, 400
    burst = 20.0, scalar_matrix(1.0), DELTA, 1000
    return _scalar_bound([drift, burst] * 4, 2 * (drift[0] + burst[0]))


AMPLITUDE = 0.05  # m/s
# rad/s: near sqrt(gamma |w|^2) of the paper's x1 axis at its far waypoints
RESONANT = 3.5


def with_square_wave(
    scenario: Scenario, amplitude: float, frequency: float
) -> Scenario:
    """Return the scenario started true, with Delta = (amplitude sign(sin(frequency t)), 0)."""
    period = 2 * np.pi / frequency
    wave = {"kind": "square", "amplitude": [amplitude, 0.0], "period": period}
    return scenario.started_true().with_values({"flow.disturbance": wave})


def disturbance_counterexample(
    start: float = 400.0,
    end: float = 800.0,
    samples: int = 50,
    progress: Callable[[float], None] | None = None,
) -> PrintedBound:
    """Violate Eq. (33) on the paper's system by a square wave.

    The wave has 0.05 m/s and 3.5 rad/s, on axis 1.

    >>> import clpt_control as clpt
    >>> found = disturbance_counterexample(start=0.0, end=40.0)
    >>> found.ratio > 1, round(found.claimed, 4)
    (True, 0.05)
    """
    scenario = with_square_wave(paper_scenario(), AMPLITUDE, RESONANT)
    scenario = scenario.with_values({"run.duration": end})
    times = sample_times(end, np.pi / RESONANT / samples)
    run = simulate(scenario, times, progress=progress)
    return printed_bound(scenario, run, start)


def known_flow_counterexample() -> PrintedBound:
    """Violate Eq. (16): true gains, gamma = 0.03, one entry of theta_hat wrong by 0.1 m/s.

    Slow adaptation stores the tidal residual of one waypoint in K and Gamma and returns it
    at the next.  The run is measured from 400 to 800 s, at samples each 0.05 s.
    """
    true = paper_scenario().started_true()
    estimate = np.array(true.flow.parameters)
    estimate[1, 0] -= 0.1
    scenario = true.with_values(
        {
            "learning.law": "known-flow",
            "learning.parameters": None,
            "learning.theta_estimate": estimate,
            "learning.gain": 0.03,
            "run.duration": 800.0,
        }
    )
    return printed_bound(scenario, simulate(scenario, sample_times(800.0, 0.05)), 400.0)


def limited_speed_counterexample() -> tuple[float, float]:
    """Return the largest |e| of a vehicle of limited speed with hedging and without, length.

    Theorem 3.2 does not hold without hedging.  The runs start at the true parameters and end at
    200 s, so that the limited command alone drives e.
    """
    scenario = (
        paper_scenario()
        .started_true()
        .with_values(
            {"vehicle.max_speed": 1.5, "run.duration": 200.0, "run.output_step": 0.1}
        )
    )
    hedged, unhedged = (
        simulate(scenario.with_values({"learning.hedging": is_hedged})).clpe.values
        for is_hedged in (True, False)
    )
    return float(np.hypot(*hedged.T).max()), float(np.hypot(*unhedged.T).max())


class Unlearned(NamedTuple):
    """A parameter that does not move although zc is exciting."""

    kappa: float  # smallest eigenvalue of int zc zc^T over a cycle, length^2 time
    moved: float  # largest change of the estimate, length per time
    error: float  # smallest error of the estimate at the end, length per time


def unlearned_counterexample() -> Unlearned:
    """Run the paper's track with a parameter that is not excited, to 220 s.

    With the kernel exp(-d^2/s) of Eq. (5) the second function, exp(-d^2/5) around (10, 10),
    vanishes on the circle.
    """
    values = {"basis.kernel": "gaussian-sigma", "run.duration": 220.0}
    scenario = paper_scenario().with_values({**values, "run.output_step": 0.5})
    run = simulate(scenario)
    estimates = run.flow_parameters_estimate.values[..., 1]
    theta = np.array(scenario.flow.parameters)[:, 1]
    zc = scenario.waypoints
    kappa = np.linalg.eigvalsh(scenario.reference.dwell * zc.T @ zc)[0]
    moved = np.abs(estimates - estimates[0]).max()
    error = np.abs(estimates[-1] - theta).min()
    return Unlearned(float(kappa), float(moved), float(error))
