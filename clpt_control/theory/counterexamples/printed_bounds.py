"""The printed bounds on |e|, Eqs. (16) and (33), beside a run.

    |e| <= |(theta - theta_hat) phi(x, t)| / mu,  mu < lambda_min(KD)      Eq. (16)
    |e| <= |Delta| / beta,                      beta < lambda_min(KD)      Eq. (33)

Each is taken at its kindest: the largest drive of the measured stretch, and the limit that any
mu or beta below lambda_min(KD) allows.  A ratio above 1 then refutes it.

Scalar counterexamples to Eqs. (16) and (33), run exactly.

    d/dt [e, eta] = A(w) [e, eta] + [Delta, 0]            Eqs. (28) and (32)

One axis, one basis function w = phi, z = zc = 0.  A is read off the blocks.  While w and
Delta stand still, the matrix exponential of [[A, Delta], [0, 0]] carries the state on without
error of integration.  Delta may as well be the residual (theta - theta_hat) phi of Eq. (16).

- A square wave at the resonance sqrt(gamma): limsup|e| -> 4/pi as gamma grows, the first
  harmonic of the wave passed on in full.
- Drift, then burst: a faint regressor eps lets the parameter error drift to -Delta/eps; a
  regressor of 1 then turns it into an error of about 0.55/eps.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ...arguments import check_holds, public
from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from ...simulation.flows import flow_velocity
from ..excitation.transition import error_matrices

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class PrintedBound:
    """A printed bound on |e| beside what the equations do."""

    equation: str
    claim: str  # what the equation says
    k: float  # lambda_min(KD), per time
    times: np.ndarray  # (nt,)
    size: np.ndarray  # |e|, length, (nt,)
    drive: np.ndarray  # the size of what drives e, length per time, (nt,)
    start: float  # measured from here on
    length: str = "m"
    time: str = "s"

    @property
    def late(self) -> np.ndarray:
        """Mask of the samples measured, shape (nt,)."""
        return self.times >= self.start

    @property
    def peak(self) -> float:
        """The largest |e| from `start` on, length."""
        return float(self.size[self.late].max())

    @property
    def claimed(self) -> float:
        """The largest drive over k: the printed bound's limit, length."""
        return float(self.drive[self.late].max()) / self.k

    @property
    def ratio(self) -> float:
        """peak / claimed: above 1 the printed bound is violated."""
        return self.peak / self.claimed

    @property
    def fails_above(self) -> float:
        """The printed bound fails for beta (mu) between this and k."""
        return self.k / self.ratio

    @property
    def rms(self) -> float:
        """Root mean square of e, over that of the drive divided by k."""
        e, drive = (_rms(self.times[self.late], v[self.late]) for v in (self.size, self.drive))
        return e / (drive / self.k)


def _rms(times: np.ndarray, values: np.ndarray) -> float:
    from scipy.integrate import trapezoid

    return float(np.sqrt(trapezoid(values**2, times) / (times[-1] - times[0])))


def residual(scenario: Scenario, run: "xarray.Dataset") -> np.ndarray:
    """Return what drives e along a run, length per time, shape (nt, 2).

    Delta of Eq. (32); with the known-flow law Delta + (theta - theta_hat) phi(x, t), Eq. (16).
    """
    if scenario.flow.parameters is None:
        raise ScenarioError("flow.field: a gridded field has no parameters theta to compare with")
    known = scenario.learning.row.given_estimate
    estimate = scenario.learning.theta_estimate if known else scenario.flow.parameters
    modelled = flow_velocity(scenario, run.position.values, run.time.values, np.array(estimate))
    return run.true_flow.values - modelled


@public
def printed_bound(scenario: Scenario, run: "xarray.Dataset", start: float) -> PrintedBound:
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
    printed = {
        "known-flow": ("(16)", "|e| <= max|(theta - theta_hat) phi|/mu for any mu < k"),
        "learned-flow": ("(33)", "|e| <= max|Delta|/beta for any beta < k"),
    }
    law = scenario.learning.law
    if law not in printed:
        raise ScenarioError(
            f'learning.law = "{law}": has no printed bound; must be {" or ".join(printed)}'
        )
    equation, claim = printed[law]
    check_holds("printed_bound: run", run, ["time", "clpe"], "clpt.simulate(scenario) makes a run")
    return PrintedBound(
        equation,
        claim,
        min(scenario.vehicle.feedback),
        run.time.values,
        np.hypot(*run.clpe.values.T),
        np.hypot(*residual(scenario, run).T),
        start,
        scenario.units.length,
        scenario.units.time,
    )


CLAIM = "|e| <= max|Delta|/beta for any beta < k"


class Piece(NamedTuple):
    """A stretch of time in which only the state moves."""

    duration: float
    A: np.ndarray  # (..., n, n); leading axes are members of an ensemble
    drive: np.ndarray  # (..., n), added to the derivative
    samples: int  # states recorded, evenly spaced, the last at its end


def scalar_matrix(w: float, k: float = 1.0, gain: float = 1.0) -> np.ndarray:
    """Return A of the scalar system, [[-k, w], [-gain w, 0]], on (e, eta)."""
    nothing = np.zeros(2)
    return error_matrices(np.array([w]), nothing, nothing, np.array([k, k]), gain)[0, :2, :2]


def exact_run(pieces: Iterable[Piece], start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return times (nt,), 0 and those sampled, and states (nt, ..., n) from a start (..., n)."""
    from scipy.linalg import expm

    state = np.asarray(start, dtype=float)
    times, states = [np.zeros(1)], [state[None]]
    n = state.shape[-1]
    for piece in pieces:
        extended = np.zeros((*state.shape[:-1], n + 1, n + 1))
        extended[..., :n, :n] = piece.A
        extended[..., :n, n] = piece.drive
        step = expm(extended * (piece.duration / piece.samples))
        reached = np.empty((piece.samples, *state.shape))
        for j in range(piece.samples):
            state = np.einsum("...ij,...j->...i", step[..., :n, :n], state) + step[..., :n, n]
            reached[j] = state
        share = np.arange(1, piece.samples + 1) / piece.samples
        times.append(times[-1][-1] + piece.duration * share)
        states.append(reached)
    return np.concatenate(times), np.concatenate(states)


def square_wave_counterexample(
    k: float = 1.0, gain: float = 100.0, periods: int = 60, samples: int = 200
) -> PrintedBound:
    """Run Delta = +1, -1 in turn at sqrt(gamma), phi = 1, from e = eta = 0.

    There are `samples` per half period; the last quarter of the run is measured.
    """
    A, half = scalar_matrix(1.0, k, gain), np.pi / np.sqrt(gain)
    pieces = [
        Piece(half, A, np.array([sign, 0.0]), samples)
        for _ in range(periods)
        for sign in (1.0, -1.0)
    ]
    return _beside_the_bound(pieces, k, 1.5 * periods * half)


def burst_counterexample(
    faint: float = 0.2,
    quiet: float = 250.0,
    burst: float = 20.0,
    cycles: int = 4,
    k: float = 1.0,
    gain: float = 1.0,
) -> PrintedBound:
    """Run Delta = 1 with a regressor that is faint, then 1, from e = eta = 0.

    The regressor is periodic and so persistently exciting.  `quiet` and `burst` are the
    lengths of both stretches, quiet well above 1/(gamma faint^2).  Peaks come back in every
    cycle, near 0.55 (1/faint - 1); the second half of the cycles is measured.
    """
    drive = np.array([1.0, 0.0])
    cycle = [
        Piece(quiet, scalar_matrix(faint, k, gain), drive, 400),
        Piece(burst, scalar_matrix(1.0, k, gain), drive, 1000),
    ]
    return _beside_the_bound(cycle * cycles, k, cycles // 2 * (quiet + burst))


def _beside_the_bound(pieces: list[Piece], k: float, start: float) -> PrintedBound:
    times, states = exact_run(pieces, np.zeros(2))
    return PrintedBound("(33)", CLAIM, k, times, np.abs(states[:, 0]), np.ones_like(times), start)
