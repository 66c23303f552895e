"""Counterexamples on the paper's own system to Eqs. (16) and (33).

    |e| <= |(theta - theta_hat) phi(x, t)| / mu,  mu < lambda_min(KD)      Eq. (16)
    |e| <= |Delta| / beta,                      beta < lambda_min(KD)      Eq. (33)

V' < 0 outside a ball in e is no bound on e, since V also holds parameter
errors: what the disturbance drives into them comes back through the regressor.
Each function here runs the case that shows it.  The scalar cases are in
`scalar_counterexamples`, that of Theorem 3.3 in `unlearned`; what does hold is
in `mean_square`.
"""

from collections.abc import Callable

import numpy as np

from ...scenario.experiment import Scenario
from ...scenario.file import paper_scenario
from ...simulation.integrate import sample_times, simulate
from ..excitation.gramian import started_true
from .printed_bounds import Counterexample, measured

RESONANT = 3.5  # rad/s: near sqrt(gamma |w|^2) of the paper's x1 axis at its far waypoints


def with_square_wave(scenario: Scenario, amplitude: float, frequency: float) -> Scenario:
    """Return the scenario, started true, with a square wave on axis 1.

    Parameters
    ----------
    scenario : Scenario
        With flow parameters theta and the learned-flow law.
    amplitude : float
        Delta_max, units.length per units.time.
    frequency : float
        Angular, rad per units.time.

    Returns
    -------
    Scenario
        Delta = (amplitude sign(sin(frequency t)), 0).

    Raises
    ------
    ScenarioError
        If a value is not allowed.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = with_square_wave(clpt.paper_scenario(), 0.05, 3.5)
    >>> round(found.flow.disturbance.period, 7)
    1.7951958
    """
    wave = {"kind": "square", "amplitude": [amplitude, 0.0], "period": 2 * np.pi / frequency}
    return started_true(scenario).with_values({"flow.disturbance": wave})


def disturbance_counterexample(
    amplitude: float = 0.05,
    frequency: float = RESONANT,
    start: float = 400.0,
    end: float = 800.0,
    samples: int = 50,
    progress: Callable[[float], None] | None = None,
) -> Counterexample:
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
    Counterexample
        Started at the true parameters, so that nothing but Delta makes e.

    Raises
    ------
    ScenarioError
        If a value is not allowed.

    Examples
    --------
    >>> found = disturbance_counterexample(start=0.0, end=40.0)
    >>> found.ratio > 1, round(found.claimed, 4)
    (True, 0.05)
    """
    scenario = with_square_wave(paper_scenario(), amplitude, frequency)
    scenario = scenario.with_values({"run.duration": end})
    run = simulate(scenario, sample_times(end, np.pi / frequency / samples), progress=progress)
    return measured(scenario, run, start)


def known_flow_counterexample(
    gain: float = 0.03,
    bias: float = 0.1,
    start: float = 400.0,
    end: float = 1200.0,
    step: float = 0.02,
    progress: Callable[[float], None] | None = None,
) -> Counterexample:
    """Violate Eq. (16): the paper's system, one theta_hat wrong.

    Slow adaptation stores the tidal residual of one waypoint in K and Gamma
    and gives it back at the next.  At the paper's gain 0.8 a short search over
    single wrong entries found no violation.

    Parameters
    ----------
    gain : float
        Adaptation gain gamma.
    bias : float
        theta - theta_hat of the first function on axis 2, m/s.
    start, end : float
        Measured from start to end of the run, s.
    step : float
        Between samples, s.
    progress : callable, optional
        Called with the time reached.

    Returns
    -------
    Counterexample
        Started with true gains; its drive is |(theta - theta_hat) phi(x, t)|.

    Raises
    ------
    ScenarioError
        If a value is not allowed.

    Examples
    --------
    >>> known_flow_counterexample(end=40.0, start=0.0).equation
    '(16)'
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
    return measured(scenario, simulate(scenario, sample_times(end, step), progress=progress), start)
