"""Counterexamples on the paper's own system: Eqs. (16) and (33), Theorems 3.2 and 3.3.

V' < 0 outside a ball in e is no bound on e, since V also holds parameter errors: what the
disturbance drives into them comes back through the regressor.

A vehicle of limited speed does not fly what Eq. (7) commands: Theorem 3.2 is lost where the learner
is not told (`blocks.vehicle`).

Theorem 3.3 asks that the desired position zc is exciting, Assumption 3.1.  The joint regressor
w = [phi, z, zc] of Eq. (31) must be: a basis function of Eq. (5) that vanishes on the track
leaves its parameter where it started, by Eq. (21), alpha' = -gamma e phi^T.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...arguments import public
from ...equations.at_many import evaluate
from ...scenario.experiment import Scenario
from ...scenario.file import paper_scenario
from ...simulation.integrate import sample_times, simulate
from ..excitation.gramian import started_true
from .printed_bounds import PrintedBound, printed_bound

RESONANT = 3.5  # rad/s: near sqrt(gamma |w|^2) of the paper's x1 axis at its far waypoints


def with_square_wave(scenario: Scenario, amplitude: float, frequency: float) -> Scenario:
    """Return it started true, with Delta = (amplitude sign(sin(frequency t)), 0)."""
    wave = {"kind": "square", "amplitude": [amplitude, 0.0], "period": 2 * np.pi / frequency}
    return started_true(scenario).with_values({"flow.disturbance": wave})


@public
def disturbance_counterexample(
    amplitude: float = 0.05,
    frequency: float = RESONANT,
    start: float = 400.0,
    end: float = 800.0,
    samples: int = 50,
    progress: Callable[[float], None] | None = None,
) -> PrintedBound:
    """Violate Eq. (33): the paper's system and a square wave.

    Parameters
    ----------
    amplitude : float
        Delta_max, m/s, on axis 1.
    frequency : float
        Angular frequency of the square wave, rad/s.
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
    scenario = with_square_wave(paper_scenario(), amplitude, frequency)
    scenario = scenario.with_values({"run.duration": end})
    run = simulate(scenario, sample_times(end, np.pi / frequency / samples), progress=progress)
    return printed_bound(scenario, run, start)


def known_flow_counterexample(
    gain: float = 0.03,
    bias: float = 0.1,
    start: float = 400.0,
    end: float = 1200.0,
    step: float = 0.02,
) -> PrintedBound:
    """Violate Eq. (16): true gains, one entry of theta_hat wrong by `bias`, m/s.

    Slow adaptation stores the tidal residual of one waypoint in K and Gamma and gives it back
    at the next.  At the paper's gain 0.8 a short search over single wrong entries found no
    violation.  Measured from start to end, s, at samples each `step`.
    """
    true = started_true(paper_scenario())
    estimate = np.array(true.flow.parameters)
    estimate[1, 0] -= bias
    scenario = true.with_values(
        {
            "learning.law": "known-flow",
            "learning.parameters": None,
            "learning.theta_estimate": estimate,
            "learning.gain": gain,
            "run.duration": end,
        }
    )
    return printed_bound(scenario, simulate(scenario, sample_times(end, step)), start)


def limited_speed_counterexample(end: float = 400.0, max_speed: float = 1.5) -> tuple[float, float]:
    """Refute Theorem 3.2 of a vehicle whose speed is limited, where the learner is not told.

    Started at the true parameters, so that nothing but what is not flown makes e.  Return the
    largest |e| with hedging and without, length, on runs to `end`, s.
    """
    scenario = started_true(paper_scenario()).with_values(
        {"vehicle.max_speed": max_speed, "run.duration": end, "run.output_step": 0.1}
    )
    told, untold = (
        simulate(scenario.with_values({"learning.hedging": hedging})).clpe.values
        for hedging in (True, False)
    )
    return float(np.hypot(*told.T).max()), float(np.hypot(*untold.T).max())


@dataclass(frozen=True)
class Unlearned:
    """A parameter that stands still while zc is exciting."""

    kappa: float  # smallest eigenvalue of int zc zc^T over a cycle, length^2 time
    function: int  # number of the basis function, from 1
    largest: float  # its largest size along the track
    estimates: np.ndarray  # of its parameter, both axes, length per time, (nt, 2)
    true: np.ndarray  # what they should become, (2,)

    @property
    def moved(self) -> float:
        """How far the estimate went from its start at most."""
        return float(np.abs(self.estimates - self.estimates[0]).max())

    @property
    def error(self) -> float:
        """Smallest error of the estimate at the end."""
        return float(np.abs(self.estimates[-1] - self.true).min())


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
    phi = evaluate(scenario.basis_block(), run.time.values, run.position.values)
    return Unlearned(
        float(np.linalg.eigvalsh(scenario.reference.dwell * zc.T @ zc)[0]),
        function,
        float(np.abs(phi[:, k]).max()),
        run.flow_parameters_estimate.values[:, :, k],
        np.array(scenario.flow.parameters)[:, k],
    )
