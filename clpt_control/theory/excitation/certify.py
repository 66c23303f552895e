"""Numbers for every start: how V of Eq. (24) falls, whatever the learner begins with.

Eq. (28), axis by axis: e' = -k e + w^T eta + Delta, eta_j' = -gamma_j w_j e, w = [phi(x), z, zc].
w holds z, which depends on the learner; x of Eq. (9) does not.  With z = x - e and
w* = [phi(x), x, zc] the learner is a linear system that the vehicle alone makes, and a rest:

1  Units: y = (e, Y) with Y_j = eta_j/gamma_j^(1/2).  V = |y|^2/2, both axes together.
2  y' = A* y + d + (Delta, 0), A* = [[-k, w~], [-w~^T, 0]], w~_j = gamma_j^(1/2) w*_j, and
   d = gamma_K^(1/2) e (-Y_K, e): from z = x - e in w^T eta and in K' alone.
3  A* + A*^T = -2 diag(k, 0).  So |y|^2 of y' = A* y falls by 2 k int e^2, over a window T from t by
   delta |y|^2 at least: delta is the smallest eigenvalue of 2 k int Phi_e^T Phi_e, where Phi_e is
   the row of e in its transition (`certificates`, `drop`).
4  e = Phi_e y(t) + e_1 + e_2 + e_3: what the two parts of d and Delta do, begun at rest.  |.| over
   the window, in the mean square, a = |e| and k the smaller of KD:
   e_1  pushed by u = -gamma_K^(1/2) e Y_K on e: 0 <= -k |e_1|^2 + int e_1 u, so |e_1| <= |u|/k,
        and |u| <= (gamma_K v)^(1/2) a where |y|^2 <= v
   e_2  pushed by gamma_K^(1/2) e^2 on Y_K, in all p = gamma_K^(1/2) a^2: |y_2| is at most what it
        was pushed by so far, so k |e_2|^2 <= p^2/2
   e_3  pushed by Delta on e: |e_3| <= D/k, D = |Delta|
5  (V(t) c)^(1/2) <= |Phi_e y(t)| <= B a + A a^2 + D/k, where c is the smaller delta_i/k_i,
   B = 1 + (gamma_K v)^(1/2)/k, A = (gamma_K/(2 k))^(1/2).  Its root is the least a.
6  V(t+T) = V(t) - int e^T KD e + int e^T Delta <= V(t) - k a^2 + a D, which falls with a beyond
   D/(2 k): a is the root of 5, or D/(2 k) where that is more.  Within the window V is at most
   V(t) + D^2/(4 k), so v is twice that.
7  The root rises with V and the bound on V(t+T) too (c k <= 1), so windows chain, and V ends where
   a = D/k.  |e| <= (2 V)^(1/2), |eta_j| <= (2 gamma_j V)^(1/2).  Where V(t) is small and D = 0,
   V(t+T)/V(t) <= 1 - delta, which is attained.

No step asks how V began: with D = 0 and c > 0 in every window alike, V falls to 0 from any start,
and exponentially in the end: Theorem 3.3 with the regressor of the vehicle alone, no lemma cited.
Beyond the run the weakest window of the run is taken for all: that is an assumption, and said.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.optimize import brentq

from ...arguments import Positive, public
from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from ...simulation.integrate import simulate
from ...units import at_most
from ..promises import bounded, largest_disturbance
from .certificates import gains_of_w, refuse_turns, refuse_unproved, worst_drop
from .regressor import checked_window, joint_regressor

MOST_WINDOWS = 1_000_000
LARGEST = 1e12  # V that is looked for, and error


@dataclass(frozen=True)
class Bounds:
    """What holds for every start with V(0) <= radius; arrays over the ends of the windows."""

    radius: float  # R, of V
    window: float  # T, units.time
    drops: np.ndarray  # delta of each window of the run, the smaller of both axes
    time: np.ndarray  # 0, T, 2 T, ... as far as the run
    V: np.ndarray  # at most, then and until the next
    # |e| at most from then on, length; with a disturbance, within the run
    clpe: np.ndarray
    flow_error: np.ndarray  # |theta_k + alpha_k| likewise, length per time
    # limsup |e| at most, length, in windows like the weakest; None: nothing
    ultimate: float | None
    disturbance: float  # largest |Delta| of the scenario, length per time
    error: float  # the CLPE that is to be reached, length
    # from then on CLPE is likewise at most `error`; None: never
    time_to_error: float | None
    units: dict[str, str]

    @property
    def within_run(self) -> bool:
        """Whether the time to the error lies in the run, where every window was looked at."""
        return self.time_to_error is not None and self.time_to_error <= float(
            self.time[-1]
        )

    def __repr__(self) -> str:
        return f"<Bounds: for V(0) <= {self.radius:g}, {self.said}>"

    @property
    def said(self) -> str:
        """When CLPE is small, in a sentence."""
        if self.time_to_error is None:
            return f"CLPE is not shown to come below {self.error:.4g} {self.units['length']}"
        when = f"{at_most(self.time_to_error, 6)} {self.units['time']}"
        beyond = ", if later windows excite like the run's weakest"
        beyond = self.known_until if self.within_run else beyond
        return f"CLPE is at most {at_most(self.error)} {self.units['length']} after {when}{beyond}"

    @property
    def known_until(self) -> str:
        """Until when what holds in the run holds: for good where nothing disturbs, so V falls."""
        return ", within the run" if self.disturbance > 0 else ""

    def report(self) -> dict[str, Any]:
        """Return it ready for JSON."""
        fields = {
            k: v.tolist() if isinstance(v, np.ndarray) else v
            for k, v in vars(self).items()
        }
        return {**fields, "within_run": self.within_run, "said": self.said}


def least_error(V: float, c: float, k: float, gain: float, D: float) -> float:
    """Return a, a lower bound of |e| over a window that begins with V, step 5; 0: none is known."""
    A, B = np.sqrt(gain / (2 * k)), 1 + np.sqrt(gain * (2 * V + D**2 / (2 * k))) / k
    C = max(np.sqrt(V * c) - D / k, 0.0)
    return float(2 * C / (B + np.sqrt(B**2 + 4 * A * C)))


def after_window(V: float, c: float, k: float, gain: float, D: float) -> float:
    """Return an upper bound of V after a window that begins with V, step 6."""
    a = max(least_error(V, c, k, gain, D), D / (2 * k))
    return V - k * a**2 + a * D


def settled(c: float, k: float, gain: float, D: float) -> float:
    """Return an upper bound of V in the end, in windows of one c: a = D/k; inf: none is known."""
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
) -> Bounds:
    """Bound V, CLPE and the flow parameters' errors for every start.

    Of the learned-flow law, along the track that the vehicle takes in the scenario's flow, with its
    disturbance, from its own start. The learner may begin with any z, alpha, K and Gamma.

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

    Returns
    -------
    Bounds
        For every start with V(0) <= R.

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
    if scenario.learning.law != "learned-flow" or scenario.flow.parameters is None:
        raise ScenarioError(
            "no certificate: it is of the learned-flow law in a flow with parameters theta"
        )
    refuse_unproved(scenario)
    if not bounded(scenario):
        raise ScenarioError(
            'no certificate: flow.disturbance.kind = "noise" is normal, so |Delta| has no bound'
        )
    if max(radius or 0.0, error or 0.0) > LARGEST:
        raise ScenarioError(f"radius, error: must be at most {LARGEST:g}")
    window, _ = checked_window(scenario, window, 0.0)
    gains, car = scenario.learning.used_gains, scenario.vehicle
    for name in ("feedback", "feedforward"):
        if getattr(gains, name) == 0 and getattr(scenario.learning, name) != getattr(
            car, name
        ):
            raise ScenarioError(
                f"no certificate: learning.{name} is held and is not vehicle.{name}, so CLPE does "
                "not end; hold the vehicle's own"
            )
    drops = _drops(scenario, window)
    R = radius or float(simulate(scenario, [0.0, window]).lyapunov[0])
    error = 0.01 * np.sqrt(2 * R) if error is None else float(error)
    d = largest_disturbance(scenario)
    k, D = min(car.feedback), d * np.sqrt(window)
    more = D**2 / (4 * k)  # of V within a window
    c = (drops / np.array(car.feedback)).min(axis=1)

    V = [R]
    for share in c:
        V.append(after_window(V[-1], share, k, gains.feedback, D))
    end = settled(c.min(), k, gains.feedback, D) + more
    below, later, windows = error**2 / 2 - more, V[-1], len(c)
    reached = [j for j in range(len(V)) if max(V[j:]) <= below]
    while not reached and end < error**2 / 2 and windows < MOST_WINDOWS:
        later, windows = after_window(later, c.min(), k, gains.feedback, D), windows + 1
        reached = [windows] if later <= below else []
    at_most = np.maximum.accumulate(np.array(V)[::-1])[::-1] + more
    return Bounds(
        R,
        window,
        drops.min(axis=1),
        window * np.arange(len(V)),
        np.array(V),
        np.sqrt(2 * at_most),
        np.sqrt(2 * gains.parameters * at_most),
        float(np.sqrt(2 * end)) if np.isfinite(end) else None,
        d,
        error,
        window * reached[0] if reached else None,
        scenario.units.model_dump(),
    )


def _drops(scenario: Scenario, window: float) -> np.ndarray:
    """Return delta of each whole window of the run, (windows, 2)."""
    k, gains = np.array(scenario.vehicle.feedback), gains_of_w(scenario)
    largest = scenario.basis.N + 4 * np.max(scenario.waypoints**2)
    refuse_turns(window * np.sqrt(gains.max() * largest))
    count = int(np.floor(scenario.run.duration / window * (1 + 1e-12)))
    ends = window * np.arange(count + 1)
    along = joint_regressor(
        scenario, float(ends[-1]), 0.0, ends[1:-1], predicted="position"
    )
    cuts = np.searchsorted(along.cuts, ends - 1e-9 * window)
    return np.array(
        [
            worst_drop(along.w[:, a:b], k, gains, along.weights[a:b])
            for a, b in pairwise(cuts.tolist())
        ]
    )
