"""Bounds on V of Eq. (24), CLPE and flow-parameter errors for every start of the learner.

The regressor w contains z, which depends on the learner; x of Eq. (9) does not.  With z = x - e
the learner is a linear system of the vehicle alone plus a remainder, and from window to window

    V(t+T) <= V(t) - k a^2 + a D,    (V c)^(1/2) = B a + A a^2 + D/k

The seven steps of the proof are listed below.  No step restricts V(0): with D = 0 and c > 0 in
every window, V falls to 0 from any start, exponentially in the end.  Beyond the run the weakest
window of the run is assumed for all windows.
"""

# Proof
#
# Eq. (28), axis by axis: e' = -k e + w^T eta + Delta, eta_j' = -gamma_j w_j e, w = [phi(x), z, zc].
# w contains z, which depends on the learner; x of Eq. (9) does not.  With z = x - e and
# w* = [phi(x), x, zc] the learner is a linear system of the vehicle alone, plus a remainder:
#
# 1  Units: y = (e, Y) with Y_j = eta_j/gamma_j^(1/2).  V = |y|^2/2, both axes together.
# 2  y' = A* y + d + (Delta, 0), A* = [[-k, w~], [-w~^T, 0]], w~_j = gamma_j^(1/2) w*_j, and
#    d = gamma_K^(1/2) e (-Y_K, e): from z = x - e in w^T eta and in K' alone.
# 3  A* + A*^T = -2 diag(k, 0).  So |y|^2 of y' = A* y falls by 2 k int e^2, over a window T by
#    delta |y|^2 at least: delta is the smallest eigenvalue of 2 k int Phi_e^T Phi_e, where Phi_e is
#    the row of e in its transition (`certificates`, `drop`).
# 4  e = Phi_e y(t) + e_1 + e_2 + e_3: the responses to both terms of d and to Delta from rest.
#    |.| is the L2 norm over the window, a = |e| and k the smaller of KD:
#    e_1  pushed by u = -gamma_K^(1/2) e Y_K on e: 0 <= -k |e_1|^2 + int e_1 u, so |e_1| <= |u|/k,
#         and |u| <= (gamma_K v)^(1/2) a where |y|^2 <= v
#    e_2  pushed by gamma_K^(1/2) e^2 on Y_K, in all p = gamma_K^(1/2) a^2: |y_2| is at most what it
#         was pushed by so far, so k |e_2|^2 <= p^2/2
#    e_3  pushed by Delta on e: |e_3| <= D/k, D = |Delta|
# 5  (V(t) c)^(1/2) <= |Phi_e y(t)| <= B a + A a^2 + D/k, where c is the smaller delta_i/k_i,
#    B = 1 + (gamma_K v)^(1/2)/k, A = (gamma_K/(2 k))^(1/2).  Its root is the least a.
# 6  V(t+T) = V(t) - int e^T KD e + int e^T Delta <= V(t) - k a^2 + a D, which falls with a beyond
#    D/(2 k): a is the root of 5, or D/(2 k) where that is more.  Within the window V is at most
#    V(t) + D^2/(4 k), so v is twice that.
# 7  The root rises with V and so does the bound on V(t+T) (c k <= 1).  Therefore windows chain,
#    and V ends where a = D/k.  |e| <= (2 V)^(1/2), |eta_j| <= (2 gamma_j V)^(1/2).  If V(t) is
#    small and D = 0, V(t+T)/V(t) <= 1 - delta, which is attained.

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import brentq

from ...base.arguments import Positive, public
from ...base.errors import ScenarioError, refuse_unused
from ...base.units import at_least, at_most, finite_or_none
from ...paper.scenario.experiment import Scenario
from ...simulation.integrate import simulate
from ..laws.promises import largest_disturbance
from .certificates import refuse_turns, refuse_unproved, worst_drop
from .certify_fixes import FixBounds, certify_fixes
from .regressor import checked_window, gains_of_w, joint_regressors

MAX_WINDOWS = 1_000_000
LARGEST = 1e12  # radius and error


@dataclass(frozen=True)
class Bounds:
    """Bounds for every start with V(0) <= radius; arrays over the ends of the windows."""

    radius: float  # R, of V
    window: float  # T, units.time
    drops: np.ndarray  # delta of each window of the run, the smaller of both axes
    time: np.ndarray  # 0, T, 2 T, ... up to the end of the run
    V: np.ndarray  # at most, until the next time
    clpe: np.ndarray  # |e| at most from then on, length; if disturbed, within the run
    flow_error: np.ndarray  # |theta_k + alpha_k| at most from then on, length per time
    ultimate: float | None  # limsup |e| at most, length, in windows like the weakest
    disturbance: float  # largest |Delta| of the scenario, length per time
    error: float  # the CLPE to be reached, length
    time_to_error: float | None  # from then on CLPE is at most `error`; None: never
    units: dict[str, str]

    @property
    def within_run(self) -> bool:
        """True if the time to the error lies in the run."""
        reached = self.time_to_error
        return reached is not None and reached <= float(self.time[-1])

    def __repr__(self) -> str:
        return f"<Bounds: for V(0) <= {at_least(self.radius, 6)}, {self.said}>"

    @property
    def said(self) -> str:
        """Sentence on the time to the error."""
        length = self.units["length"]
        if self.time_to_error is None:
            return f"CLPE is not shown to come below {at_least(self.error)} {length}"
        time = f"{at_most(self.time_to_error, 6)} {self.units['time']}"
        condition = ", if later windows excite like the run's weakest"
        condition = self.known_until if self.within_run else condition
        return f"CLPE is at most {at_most(self.error)} {length} after {time}{condition}"

    @property
    def known_until(self) -> str:
        """Validity of a bound that holds in the run: for good without a disturbance."""
        return ", within the run" if self.disturbance > 0 else ""

    def report(self) -> dict[str, Any]:
        """Return the fields ready for JSON."""
        fields = finite_or_none(vars(self))
        return {**fields, "within_run": self.within_run, "said": self.said}


def least_error(V: float, c: float, k: float, gain: float, D: float) -> float:
    """Return a, a lower bound of |e| over a window that begins with V, step 5, or 0."""
    A, B = np.sqrt(gain / (2 * k)), 1 + np.sqrt(gain * (2 * V + D**2 / (2 * k))) / k
    C = max(np.sqrt(V * c) - D / k, 0.0)
    return float(2 * C / (B + np.sqrt(B**2 + 4 * A * C)))


def after_window(V: float, c: float, k: float, gain: float, D: float) -> float:
    """Return an upper bound of V after a window that begins with V, step 6."""
    a = max(least_error(V, c, k, gain, D), D / (2 * k))
    return V - k * a**2 + a * D


def settled(c: float, k: float, gain: float, D: float) -> float:
    """Return the ultimate bound of V in windows of one c, a = D/k, or inf."""
    if D == 0:
        return 0.0 if c > 0 else np.inf
    if k * least_error(LARGEST, c, k, gain, D) <= D:
        return np.inf
    return float(brentq(lambda V: k * least_error(V, c, k, gain, D) - D, 0.0, LARGEST))


@public
def certify(
    scenario: Scenario,
    radius: Positive | None = None,
    *,
    error: Positive | None = None,
    window: float | None = None,
    shear: Positive | None = None,
    unmodelled: float | None = None,
) -> Bounds | FixBounds:
    """Bound V, CLPE and the flow parameters' errors for every start.

    The law is the learned-flow law. The vehicle runs from its own start in the scenario's flow,
    with its disturbance. The learner may begin with any z, alpha, K and Gamma.

    Or the law is fix-regression, and the bound is on the learned flow, for several intervals of
    fixes and every flow within limits, along the track as planned.

    Parameters
    ----------
    scenario : Scenario
        With flow parameters theta, the learned-flow law and no noise.
    radius : float, optional
        R, the largest V(0) of Eq. (24); that of the scenario's own start.
    error : float, optional
        CLPE that is to be reached, length; a hundredth of what R allows at the start.
    window : float, optional
        T, units.time; one cycle of the waypoints.
    shear : float, optional
        With fixes: largest shear of the true flow, 1/s; what prior and widths allow.
    unmodelled : float, optional
        With fixes: largest flow that the functions do not express, m/s; 0.01, or the largest
        disturbance of the scenario if that is more.

    Returns
    -------
    Bounds or FixBounds
        For every start with V(0) <= R; with fixes, guaranteed errors (m/s) by interval.

    Raises
    ------
    ScenarioError
        If the law or the scenario is another, or the run holds no whole window.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> paper = clpt.paper_scenario().with_values({"run.duration": 400})
    >>> found = clpt.certify(paper, 0.01)
    >>> found.V.round(4).tolist(), found.drops.round(2).tolist()
    ([0.01, 0.007, 0.0053], [0.4, 0.32])
    """
    if scenario.learning.row.at_fixes:
        if scenario.left_out:
            lacking = ", ".join(scenario.left_out)
            raise ScenarioError(
                f"no certificate: the scenario lacks {lacking}. Give its plan"
            )
        reason = "is not of a scenario of fixes. Give shear and unmodelled"
        refuse_unused(reason, radius=radius, error=error, window=window)
        return certify_fixes(scenario, shear, unmodelled)
    reason = "is of a scenario of fixes. Give radius, error and window"
    refuse_unused(reason, shear=shear, unmodelled=unmodelled)
    _check(scenario)
    if max(radius or 0.0, error or 0.0) > LARGEST:
        raise ScenarioError(f"radius, error: must be at most {LARGEST:g}")
    window, _ = checked_window(scenario, window, 0.0)
    # Step 1: constants of the recursion
    drops = _drops(scenario, window)
    radius = radius or float(simulate(scenario, [0.0, window]).lyapunov[0])
    error = 0.01 * np.sqrt(2 * radius) if error is None else float(error)
    gains, feedback = scenario.learning.used_gains, scenario.vehicle.feedback
    disturbance = largest_disturbance(scenario)
    k, D = min(feedback), disturbance * np.sqrt(window)
    rise = D**2 / (4 * k)  # of V within a window
    shares = (drops / np.array(feedback)).min(axis=1)
    constants = k, gains.feedback, D
    weakest = shares.min()
    # Step 2: V at the ends of the windows, and in the end
    V = [radius]
    for share in shares:
        V.append(after_window(V[-1], share, *constants))
    ultimate = settled(weakest, *constants) + rise
    # Step 3: the window after which CLPE is at most the error
    target = error**2 / 2 - rise
    reached = [j for j in range(len(V)) if max(V[j:]) <= target]
    later, windows = V[-1], len(shares)
    while not reached and ultimate < error**2 / 2 and windows < MAX_WINDOWS:
        later = after_window(later, weakest, *constants)
        windows += 1
        reached = [windows] if later <= target else []
    largest = np.maximum.accumulate(V[::-1])[::-1] + rise
    return Bounds(
        radius=radius,
        window=window,
        drops=drops.min(axis=1),
        time=window * np.arange(len(V)),
        V=np.array(V),
        clpe=np.sqrt(2 * largest),
        flow_error=np.sqrt(2 * gains.parameters * largest),
        ultimate=float(np.sqrt(2 * ultimate)) if np.isfinite(ultimate) else None,
        disturbance=disturbance,
        error=error,
        time_to_error=window * reached[0] if reached else None,
        units=scenario.units.model_dump(),
    )


def _check(scenario: Scenario) -> None:
    """Raise an error for a scenario without a certificate."""
    learning = scenario.learning
    if learning.law != "learned-flow" or scenario.flow.parameters is None:
        raise ScenarioError(
            "no certificate: it is for the learned-flow law in a flow with parameters theta"
        )
    refuse_unproved(scenario)
    delta = scenario.flow.disturbance
    if delta is not None and not delta.row.bounded:
        raise ScenarioError(
            f'no certificate: flow.disturbance.kind = "{delta.kind}" has no bound on |Delta|. '
            'Use a bounded kind, such as "square"'
        )


def _drops(scenario: Scenario, window: float) -> np.ndarray:
    """Return delta of each whole window of the run, (windows, 2)."""
    k, largest_gain = np.array(scenario.vehicle.feedback), gains_of_w(scenario).max()
    largest = scenario.basis.N + 4 * np.max(scenario.waypoints**2)
    refuse_turns(window * np.sqrt(largest_gain * largest))
    count = int(np.floor(scenario.run.duration / window * (1 + 1e-12)))
    ends = window * np.arange(count + 1)
    span = float(ends[-1]), 0.0, ends[1:-1], "position"
    regressor = joint_regressors(scenario, *span)[""]
    parts = regressor.parts(ends[:-1], window)
    return np.array([worst_drop(w, k, regressor.gains, h)[0] for w, h in parts])
