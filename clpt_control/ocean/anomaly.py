"""Speed anomalies: a factor on speed that left its credible range.

Had the factor jumped by d before dive j, the misses y_i - H_i p_i of a Kalman
filter that does not know of it would be d g_i on average,

    e_j = (0, .., 1, .., 0),  g_i = H_i e_i,  e_{i+1} = F (I - K_i H_i) e_i,

and the likelihood ratio of a jump against none is (A. S. Willsky, H. L. Jones,
"A generalized likelihood ratio approach to the detection and estimation of
jumps in linear systems", IEEE Trans. Automatic Control 21, 108-112, 1976)

    l = (sum g_i^T S_i^-1 nu_i)^2 / sum g_i^T S_i^-1 g_i.

One strange dive proves nothing: the two dives before the last are tried as j.
A dive is flagged where l is beyond
`SURE`, the jump is large enough to matter, a jump of the current (two numbers)
explains no more than the speed (one), and what the speed leaves is no more than
the flow's own scatter.
"""

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from ..estimation.fix_model import FixModel
from ..estimation.kalman import KalmanBank

SURE = 10.0  # l of 3.2 standard deviations
MATTERS = 0.05  # smallest change of the factor that is said
DIVES = 3  # dives that a jump may lie back
SETTLED = 10  # dives before the watch speaks
SCATTER = 3.0  # most the rest may weigh, in expected values


@dataclass(frozen=True)
class Anomaly:
    """A dive at which the speed factor left its credible range.

    Attributes
    ----------
    dive, since : int
        The dive that raised it, and that from which on it holds.
    change, standard_error : float
        Of the factor on speed through water.
    expected : float
        The factor before.
    likelihood_ratio, of_current, rest : float
        l of the speed, of a jump of the current instead, and what the speed
        leaves of the misses over what is expected of them.
    """

    dive: int
    since: int
    change: float
    standard_error: float
    expected: float
    likelihood_ratio: float
    of_current: float
    rest: float

    def __str__(self) -> str:
        return (
            f"dive {self.dive}: speed factor {self.expected:.2f} changed by {self.change:+.2f} +- "
            f"{self.standard_error:.2f} since dive {self.since}; evidence "
            f"{self.likelihood_ratio:.0f} (a change of the current instead: {self.of_current:.0f}; "
            f"{SURE:g} is needed)"
        )

    def as_dict(self) -> dict[str, Any]:
        """Give the attributes by name, for JSON."""
        return asdict(self)


class SpeedWatch:
    """Watches the speed factor dive by dive.

    Parameters
    ----------
    model : FixModel
        The flow; speed is always learned here.

    Examples
    --------
    >>> SpeedWatch(FixModel()).count
    0
    """

    def __init__(self, model: FixModel) -> None:
        self.bank = KalmanBank(FixModel(model.flow, True))
        self.windows: list[dict[str, Any]] = []
        self.count = 0

    def step(self, dive: Any) -> Anomaly | None:
        """Learn from a dive that has ended and judge its speed.

        Parameters
        ----------
        dive : Dive
            With its end fix.

        Returns
        -------
        Anomaly or None
            What was found, if anything.
        """
        bank = self.bank
        H, (F, _) = bank.model.regressor(dive), bank.transition(dive)
        m, n = bank.mean.shape
        start = np.zeros((n, 3))
        start[n - 2, 0] = start[0, 1] = start[1, 2] = 1.0
        weights = bank.weights
        before = float(1 + weights @ bank.mean[:, n - 2])
        for window in self.windows:
            window["e"] = F @ window["e"]
        fresh = {"since": dive.number, "e": np.repeat(start[None], m, axis=0), "expected": before,
                 "weights": weights, "A": np.zeros((m, 3, 3)), "b": np.zeros((m, 3)),
                 "chi": np.zeros(m), "dives": 0}  # fmt: skip
        self.windows = [*self.windows[1 - DIVES :], fresh]
        bank.update(dive)
        for window in self.windows:
            g = H @ window["e"]
            weighed = g.transpose(0, 2, 1) @ bank.spread
            window["A"] = window["A"] + weighed @ g
            window["b"] = window["b"] + np.einsum("mij,mj->mi", weighed, bank.innovation)
            window["chi"] = window["chi"] + np.einsum(
                "mi,mij,mj->m", bank.innovation, bank.spread, bank.innovation
            )
            window["e"] = bank.rest @ window["e"]
            window["dives"] += 1
        self.count += 1
        if self.count <= SETTLED:
            return None
        found = [a for a in (self._judge(dive, w) for w in self.windows[:-1]) if a is not None]
        if not found:
            return None
        self.windows = []
        bank.forget_speed()
        return max(found, key=lambda a: a.likelihood_ratio)

    def _judge(self, dive: Any, window: dict[str, Any]) -> Anomaly | None:
        w, A, b = window["weights"], window["A"], window["b"]
        speed = b[:, 0] ** 2 / A[:, 0, 0]
        flow = np.einsum(
            "mi,mi->m", b[:, 1:], np.linalg.solve(A[:, 1:, 1:], b[:, 1:, None])[..., 0]
        )
        ratio, current = float(w @ speed), float(w @ flow)
        rest = float(w @ (window["chi"] - speed)) / (2 * window["dives"] - 1)
        change = float(w @ (b[:, 0] / A[:, 0, 0]))
        error = float(np.sqrt(1.0 / (w @ A[:, 0, 0])))
        if ratio < SURE or current > ratio or rest > SCATTER or abs(change) < MATTERS:
            return None
        return Anomaly(dive.number, window["since"], change, error, window["expected"], ratio,
                       current, rest)  # fmt: skip
