"""The paper's gradient law from fix to fix.

    p <- p + K (y - H p),  K = mu P0 H^T (H P0 H^T + r)^-1

Eq. (22) moves theta along e phi at every instant; a vehicle under water has no e. Integrated from
fix to fix, phi becomes H and e becomes the miss y - H p at the surfacing. P0 gives each parameter
its unit, and the division keeps a long dive from overshooting (G. C. Goodwin, K. S. Sin,
"Adaptive Filtering Prediction and Control", 1984, section 3.3). The law itself needs no
covariance. That of its error follows from any gain K, for a current that walks,

    P <- (I - K H) (P + Q) (I - K H)^T + K r K^T.

A fix outside the 99.9 % ellipse moves the law less, by its distance beyond the ellipse. A doubtful
fix moves it by the share of its variance that is not doubt.
"""

import numpy as np

from ...base.errors import ScenarioError
from .dive import Dive
from .estimator import Estimator
from .fix_model import FAR, FixModel


class Gradient(Estimator):
    """The paper's gradient law in integral form, in one sea that has all parts."""

    def __init__(self, model: FixModel) -> None:
        if "gaussians" in model.flow:
            raise ScenarioError(
                "flow gaussians: not in the gradient law. Use the estimator gaussian-process"
            )
        scatter = np.array([model.priors.gradient.scatter])
        super().__init__(model, scatter, np.ones((1, len(model.optional)), bool))
        self.memory = model.memory.copy()
        self.memory[:2] = model.priors.gradient.memory

    def forecast(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Return mean (1, 2) and covariance (1, 2, 2) of a dive's miss."""
        mean, P = self._before(dive)
        H = self.model.regressor(dive)
        return mean @ H.T, H @ P @ H.T + self.noise(dive)

    def _before(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Return mean and covariance of the parameters before a dive is learned."""
        elapsed = self.elapsed(dive)
        decay = np.exp(-elapsed / self.memory)
        F = self.model.rotation(elapsed, dive.lat_gps2) * decay[:, None]
        prior = np.diag(self.variance[0])
        return self.mean @ F.T, prior + F @ (self.covariance - prior) @ F.T

    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""
        forecast, S = self.predict(dive)
        variance = np.trace(S) / 2
        distance = float(np.sum((dive.miss - forecast) ** 2)) / variance
        trust = 1.0 - dive.doubt**2 / variance
        mu = trust * self.priors.gain * FAR / max(distance, FAR)
        mean, P = self._before(dive)
        H, R = self.model.regressor(dive), self.noise(dive)[0]
        weight = self.variance[0][:, None] * H.T
        K = mu * weight @ np.linalg.inv(H @ weight + R)
        self.mean = mean + (dive.miss - mean @ H.T) @ K.T
        remainder = np.eye(len(K)) - K @ H
        self.covariance = remainder @ P @ remainder.T + K @ R @ K.T
        self.time = dive.mid_time
