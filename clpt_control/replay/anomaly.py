"""Speed anomalies: a factor on speed that left its credible range.

Had the factor jumped by d before dive j, the misses y_i - H_i p_i of a Kalman
filter that does not know of it would be d g_i on average,

    e_j = (0, .., 1, .., 0),  g_i = H_i e_i,  e_{i+1} = F (I - K_i H_i) e_i,

and the likelihood ratio of a jump against none is (A. S. Willsky, H. L. Jones,
"A generalized likelihood ratio approach to the detection and estimation of
jumps in linear systems", IEEE Trans. Automatic Control 21, 108-112, 1976)

    l = (sum g_i^T S_i^-1 nu_i)^2 / sum g_i^T S_i^-1 g_i.

One strange dive proves nothing: the two dives before the last are tried as j.
A dive is flagged where l is beyond `SURE`, the jump is large enough to matter
and what the speed leaves is no more than the flow's own scatter.  Where the speed
(one number) explains more than a jump of the current (two), the flag is certain.
On one heading a lost speed and a current from ahead look the same: then a loss of
a plausible size is flagged as one or the other.
"""

from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from ..errors import DataError
from ..estimation.dive import Dive
from ..estimation.fix_model import FixModel
from ..estimation.kalman import HIDDEN, KalmanBank

SURE = 10.0  # l of 3.2 standard deviations
NESTED = 2.0  # what a second number explains by chance (H. Akaike, 1974)
MATTERS, PLAUSIBLE = 0.08, 0.4  # smallest change of the factor that is said; largest doubtful loss
DIVES = 3  # the last dive, and the two that are tried as the first of a slower speed
SETTLED = 10  # dives before the watch speaks
SCATTER = 3.0  # most the rest may weigh, in expected values


@dataclass(frozen=True)
class Anomaly:
    """A dive at which the speed factor left its credible range.

    `change` of the factor on speed, with its standard error, holds from dive `since` on; the factor
    was `expected` before. `likelihood_ratio` is l of the speed, `of_current` that of a jump of the
    current instead, `rest` what the speed leaves of the misses over what is expected of them.
    `certain`: a current cannot explain it as well.
    """

    dive: int
    since: int
    change: float
    standard_error: float
    expected: float
    likelihood_ratio: float
    of_current: float
    rest: float
    certain: bool

    def __str__(self) -> str:
        return (
            f"dive {self.dive}: speed factor {self.expected:.2f} changed by {self.change:+.2f} +- "
            f"{self.standard_error:.2f} since dive {self.since}; evidence "
            f"{self.likelihood_ratio:.0f} (a change of the current instead: {self.of_current:.0f}; "
            f"{SURE:g} is needed)"
            + ("" if self.certain else "; on these headings a current from ahead looks the same")
        )

    def as_dict(self) -> dict[str, Any]:
        """Return the attributes by name, for JSON."""
        return asdict(self)


class SpeedWatch:
    """Watches the speed factor dive by dive, by a bank that learns the speed.

    The bank must see each dive before `step` does; by default it is one of its own.
    """

    def __init__(self, model: FixModel, bank: KalmanBank | None = None) -> None:
        self.own = bank is None
        self.bank = KalmanBank(replace(model, learn_speed=True)) if bank is None else bank
        self.windows: list[dict[str, Any]] = []
        self.count = 0

    def step(self, dive: Dive) -> Anomaly | None:
        """Judge the speed of a dive that has ended; None where nothing is found."""
        if self.own:
            self.bank.update(dive)
        seen = self.bank.seen
        if seen is None:
            raise DataError(f"dive {dive.number}: its bank must learn from it before it is judged")
        F, H = seen.F, seen.H
        m, n = F.shape[:2]
        speed = HIDDEN + self.bank.model.names.index("speed")
        start = np.zeros((n, 3))
        start[speed, 0] = start[HIDDEN, 1] = start[HIDDEN + 1, 2] = 1.0
        old, new = seen.matched
        for window in self.windows:  # places reached since then have no part in it
            e = np.zeros((m, n, 3))
            e[:, new] = window["e"][:, old]
            window["e"] = F @ e
        fresh = {
            "since": dive.number,
            "e": np.repeat(start[None], m, axis=0),
            "expected": float(1 + seen.weights @ seen.mean[:, speed]),
            "weights": seen.weights,
            "A": np.zeros((m, 3, 3)),
            "b": np.zeros((m, 3)),
            "chi": np.zeros(m),
            "dives": 0,
        }
        self.windows = [*self.windows[1 - DIVES :], fresh]
        for window in self.windows:
            g = H @ window["e"]
            weighed = g.transpose(0, 2, 1) @ seen.inverse
            window["A"] = window["A"] + weighed @ g
            window["b"] = window["b"] + np.einsum("mij,mj->mi", weighed, seen.innovation)
            window["chi"] = window["chi"] + np.einsum(
                "mi,mij,mj->m", seen.innovation, seen.inverse, seen.innovation
            )
            window["e"] = seen.rest @ window["e"]
            window["dives"] += 1
        self.count += 1
        if self.count <= SETTLED:
            return None
        found = [a for a in (self._judge(dive, w) for w in self.windows[:-1]) if a is not None]
        if not found:
            return None
        self.windows = []
        best = max(found, key=lambda a: a.likelihood_ratio)
        if self.own and best.certain:
            self.bank.forget_speed()
        return best

    def _judge(self, dive: Dive, window: dict[str, Any]) -> Anomaly | None:
        w, A, b = window["weights"], window["A"], window["b"]
        if not (A[:, 0, 0] > 0).all():  # no way through the water, no speed
            return None
        speed = b[:, 0] ** 2 / A[:, 0, 0]
        flow = np.einsum(
            "mi,mi->m", b[:, 1:], np.linalg.solve(A[:, 1:, 1:], b[:, 1:, None])[..., 0]
        )
        ratio, current = float(w @ speed), float(w @ flow)
        rest = float(w @ (window["chi"] - speed)) / (2 * window["dives"] - 1)
        change = float(w @ (b[:, 0] / A[:, 0, 0]))
        error = float(np.sqrt(1.0 / (w @ A[:, 0, 0])))
        certain = ratio - current > NESTED
        doubtful = current - ratio <= NESTED and -PLAUSIBLE < change < 0
        if not (ratio >= SURE and rest <= SCATTER and abs(change) >= MATTERS):
            return None
        if not (certain or doubtful):
            return None
        return Anomaly(
            dive.number,
            window["since"],
            change,
            error,
            window["expected"],
            ratio,
            current,
            rest,
            certain,
        )
