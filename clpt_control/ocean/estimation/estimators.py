"""Estimators between fixes, chosen by name: a bank of Kalman filters, and the paper's gradient law.

`gradient` is the paper's law, Eq. (22), in integral form; `kalman` a bank of Kalman filters,
weighed by how well each has forecast.  Whatever one says of a dive before `update` is a forecast:
it reads the dive's times, start and dead reckoning, never its end.

Of one kind of sea the flow is a Gaussian process, each part with its own covariance: over a time t

    steady current                 sd^2
    tides, speed, compass          sd^2 exp(-t/fading)
    inertial current               the same, rotated by -c t
    slow current, rough            S^2 exp(-t/tau)
    slow current, smooth           S^2 (1 + g t) exp(-g t),  g = sqrt(3)/tau

The last two are Matern's of order 1/2 and 3/2 (C. E. Rasmussen, C. K. I. Williams, "Gaussian
Processes for Machine Learning", 2006, section 4.2.1).  All but the steady current are forgotten.
A Kalman filter solves it dive by dive (R. E. Kalman, "A new approach to linear filtering and
prediction problems", 1960),

    y_k = H_k p_k + n,  n ~ (FIX^2 + (s T)^2) I,
    p <- F p,  P <- P_0 + F (P - P_0) F^T

with H of `fix_model` and P_0 the prior, to which a covariance returns.  The state p of one filter
is (v_east, v_north, s_east, s_north), the slow current v and, where it is smooth, its slope
s = dv/dt, continued by the parameters of `fix_model`:

    v <- exp(-g t) ((1 + g t) v + t s),  s <- exp(-g t) ((1 - g t) s - g^2 t v)

How a sea changes, and which parts of the flow there are, differ from sea to sea.  A bank holds a
filter for each combination (D. T. Magill, "Optimal adaptive estimation of sampled
stochastic processes", 1965), weighed by the density of the fixes that it has
forecast, with r the innovation and S its covariance before the fix is used:

    w <- w |S|^(-1/2) (1 + r^T S^-1 r / (nu - 2))^(-(nu + 2)/2)

Student's t of nu degrees of freedom and covariance S, which forgives a strange fix
(K. L. Lange, R. J. A. Little, J. M. G. Taylor, "Robust statistical modeling using
the t distribution", J. Am. Stat. Assoc. 84, 881-896, 1989).  What was likely weeks ago is
forgotten.  A fix beyond a filter's 99.9 % ellipse is taken for a front: that
filter's steady current is uncertain by as much as puts the fix about there.

A part is present with the weight of the filters that have it: a trend is a smooth current that
changes by more than 5 cm/s in a day, eddies are what is forgotten in four.  Speed and compass
are in all: they are absent, f = 1 or psi = 0, with the ratio of the density there
after and before the dives (J. M. Dickey, "The weighted likelihood ratio, linear
hypotheses on normal location parameters", Annals of Statistics 42, 204-223, 1971).

The gradient of the error at a surfacing is the paper's law between fixes:

    p <- p + K (y - H p),  K = mu P0 H^T (H P0 H^T + r)^-1

Eq. (22) moves theta along e phi at every instant; a vehicle under water has no
e.  Integrated from fix to fix phi becomes H and e the miss y - H p at the
surfacing.  P0 gives each parameter its unit, and the division keeps a long dive
from overshooting (G. C. Goodwin, K. S. Sin, "Adaptive Filtering Prediction and
Control", 1984, section 3.3).  The law itself needs no covariance; that of its
error follows from any gain K, for a current that walks,

    P <- (I - K H) (P + Q) (I - K H)^T + K r K^T,

and says how far to trust it.  A fix beyond the 99.9 % ellipse moves the law less, by
how far beyond it lies, and a fix that is doubted by the share of its variance that is not doubt.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from itertools import product
from typing import NamedTuple

import numpy as np

from ...base.arguments import public
from ...base.errors import ScenarioError
from .dive import Dive, mid_time, miss
from .fix_model import FAR, FixModel
from .priors import DAY, Sea

HIDDEN = 4  # states before the parameters: the slow current and its slope


class LastUpdate(NamedTuple):
    """The update of a bank by its last dive, which a watch reads.

    `F` (m, n, n) moved the state, `H` (2, n) is the regressor, `innovation` (m, 2) the
    miss less what was expected, `inverse` (m, 2, 2) of its covariance, `rest`
    (m, n, n) is I - K H, `weights` and `mean` were before the dive.
    """

    F: np.ndarray
    H: np.ndarray
    innovation: np.ndarray
    inverse: np.ndarray
    rest: np.ndarray
    weights: np.ndarray
    mean: np.ndarray


class Estimator(ABC):
    """What m filters know: each a kind of sea, with its choice of the optional parts.

    `mean` (m, n) and `covariance` (m, n, n) are those at the middle of the last dive.
    """

    def __init__(
        self, model: FixModel, kinds: tuple[Sea, ...], present: np.ndarray
    ) -> None:
        self.model, self.priors = model, model.priors
        self.kinds, self.present = Sea(*np.array(kinds).T), present
        sd = self.prior_sd(model)
        self.mean, self.covariance = (
            np.zeros(sd.shape),
            sd[:, :, None] ** 2 * np.eye(sd.shape[1]),
        )
        self.log_prior = self.log_weight = np.zeros(len(sd))
        self.time: float | None = None

    @property
    def weights(self) -> np.ndarray:
        """Probabilities of the m filters."""
        w = np.exp(self.log_weight - self.log_weight.max())
        return w / w.sum()

    @property
    def rates(self) -> tuple[np.ndarray, np.ndarray]:
        """How fast the slow current is forgotten, and g: 0 where it is rough, (m,), 1/s."""
        _, memory, smooth, _ = self.kinds
        g = smooth * np.sqrt(3) / memory
        return g + (1 - smooth) / memory, g

    def has(self, model: FixModel) -> np.ndarray:
        """Return which filters have which parameters, (m, n less `HIDDEN`)."""
        always = np.ones(len(self.present), bool)
        columns = dict(zip(model.optional, self.present.T, strict=True))
        return np.stack([columns.get(part, always) for part in model.parts], axis=1)

    def prior_sd(self, model: FixModel) -> np.ndarray:
        """Return the standard deviations before any dive, (m, n); what is absent has zero."""
        slow = np.stack([self.kinds.size, self.rates[1] * self.kinds.size], axis=1)
        return np.hstack([np.repeat(slow, 2, axis=1), model.prior_sd * self.has(model)])

    def transition(self, model: FixModel, dt: float, latitude: float) -> np.ndarray:
        """Return F over `dt` s, (m, n, n)."""
        inner = model.transition(dt, latitude)
        n = HIDDEN + len(inner)
        F = np.zeros((len(self.present), n, n))
        F[:, HIDDEN:, HIDDEN:] = inner
        rate, g = self.rates
        left = np.exp(-rate * dt)
        for v, s in ((0, 2), (1, 3)):
            F[:, v, v], F[:, v, s] = left * (1 + g * dt), left * dt
            F[:, s, v], F[:, s, s] = -left * g**2 * dt, left * (1 - g * dt)
        return F

    def ahead(self, dive: Dive) -> tuple[FixModel, np.ndarray, np.ndarray, np.ndarray]:
        """Return model, F, mean and covariance before its end; what is new comes last."""
        model = self.model.reached(dive)
        F = self.transition(model, self.since(dive), dive.lat_gps2)
        n = HIDDEN + len(self.model.names)
        new = 0, HIDDEN + len(model.names) - n
        prior = self.prior_sd(model)[:, :, None] ** 2 * np.eye(n + new[1])
        mean = np.einsum("mij,mj->mi", F, np.pad(self.mean, ((0, 0), new)))
        gained = np.pad(self.covariance - prior[:, :n, :n], ((0, 0), new, new))
        return model, F, mean, prior + F @ gained @ F.transpose(0, 2, 1)

    def since(self, dive: Dive) -> float:
        """Return the time from the middle of the last dive to that of this one, s."""
        return 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)

    def noise(self, dive: Dive) -> np.ndarray:
        """Return the m covariances of n for a dive, m^2."""
        return self.model.noise(dive, self.kinds.scatter)[:, None, None] * np.eye(2)

    def predict(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast fix less dead reckoning of a dive: mean (2,), covariance (2, 2), m."""
        model, _, mean, P = self.ahead(dive)
        H = with_hidden(model.regressor(dive))
        return mixed(mean @ H.T, H @ P @ H.T + self.noise(dive), self.weights)

    @abstractmethod
    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""

    def parts(self) -> dict[str, float]:
        """Return the probability that each part of the flow is present; empty if not known."""
        return {}

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return mean (n,), covariance (n, n) and how much of the prior's error is left (n,).

        What is left is judged by the filters that have the parameter.
        """
        add = with_hidden(np.eye(len(self.model.names)))  # current: steady and slow
        means, P = self.mean @ add.T, add @ self.covariance @ add.T
        within = self.weights[:, None] * self.has(self.model)
        within /= np.maximum(within.sum(axis=0), 1e-300)
        variance = (
            np.diagonal(P, axis1=1, axis2=2)
            + (means - (within * means).sum(axis=0)) ** 2
        )
        left = np.sqrt((within * variance).sum(axis=0)) / self.model.prior_sd
        mean, covariance = mixed(means, P, self.weights)
        return mean, covariance, left

    def forget_speed(self) -> None:
        """Make the speed factor uncertain by half its prior variance."""
        k = HIDDEN + self.model.names.index("speed")
        self.covariance[:, k, k] += 0.5 * self.priors.speed**2


class KalmanBank(Estimator):
    """A Kalman filter for each kind of sea with each choice of parts, and their probabilities."""

    def __init__(self, model: FixModel) -> None:
        p = model.priors
        chances = [p.shelf if part == "tides" else p.present for part in model.optional]
        choices = list(product((False, True), repeat=len(chances)))
        present = np.array(choices * len(model.priors.kinds), bool)
        kinds = [kind for kind in model.priors.kinds for _ in choices]
        super().__init__(model, tuple(kinds), present)
        chance = np.where(present, chances, 1 - np.array(chances))
        self.log_prior = self.log_weight = np.log(chance).sum(axis=1)
        self.last_update: LastUpdate | None = None

    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""
        weights, before, dt = self.weights, self.mean, self.since(dive)
        self.model, F, mean, P = self.ahead(dive)
        H, R = with_hidden(self.model.regressor(dive, ended=True)), self.noise(dive)
        innovation = miss(dive) - mean @ H.T
        S = H @ P @ H.T + R
        far = np.einsum("mi,mij,mj->m", innovation, np.linalg.inv(S), innovation)
        nu = self.priors.degrees_of_freedom
        density = -0.5 * (
            np.log(np.linalg.det(S)) + (nu + 2) * np.log1p(far / (nu - 2))
        )
        remembered = np.exp(-dt / self.priors.weight_memory) * (
            self.log_weight - self.log_prior
        )
        self.log_weight = self.log_prior + remembered + density
        self.log_weight -= self.log_weight.max()
        jump = np.maximum(far / FAR - 1.0, 0.0) * np.trace(S, axis1=1, axis2=2) / 2
        steady = np.arange(HIDDEN, HIDDEN + 2)
        P[:, steady, steady] += (jump / dive.duration**2)[:, None]
        inverse = np.linalg.inv(H @ P @ H.T + R)
        gain = P @ H.T @ inverse
        self.mean = mean + np.einsum("mni,mi->mn", gain, innovation)
        P, rest = corrected(P, H, R, gain)
        self.covariance = 0.5 * (P + P.transpose(0, 2, 1))
        self.time = mid_time(dive)
        self.last_update = LastUpdate(F, H, innovation, inverse, rest, weights, before)

    def parts(self) -> dict[str, float]:
        """Return the probability that each part is present."""
        w, kinds = self.weights, self.kinds
        has = dict(zip(self.model.optional, self.present.T, strict=True))
        has["trend"] = kinds.smooth * kinds.size / kinds.memory > 0.05 / DAY
        has["eddies"] = kinds.memory <= 4 * DAY
        present = {name: min(float(w @ on), 1.0) for name, on in has.items()}
        for name in ("speed", "compass") if self.model.learn_speed else ():
            k = self.model.names.index(name)
            variance = self.covariance[:, HIDDEN + k, HIDDEN + k]
            after = np.exp(-0.5 * self.mean[:, HIDDEN + k] ** 2 / variance) / np.sqrt(
                variance
            )
            present[name] = float(1 / (1 + w @ after * self.model.prior_sd[k]))
        return present


def mixed(
    means: np.ndarray, covariances: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return mean (n,) and covariance (n, n) of a mixture of m parts: within and between them.

    m = sum w_i m_i,  P = sum w_i (P_i + (m_i - m)(m_i - m)^T)
    """
    mean = weights @ means
    away = means - mean
    between = np.einsum("m,mi,mj->ij", weights, away, away)
    return mean, np.einsum("m,mij->ij", weights, covariances) + between


def corrected(
    P: np.ndarray, H: np.ndarray, R: np.ndarray, gain: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the covariances (m, n, n) after an update of any gain K, and I - K H."""
    rest = np.eye(P.shape[1]) - gain @ H
    return rest @ P @ rest.transpose(0, 2, 1) + gain @ R @ gain.transpose(0, 2, 1), rest


def with_hidden(H: np.ndarray) -> np.ndarray:
    """Return the regressor of the state: the slow current acts as the steady one."""
    return np.hstack([H[:, :2], np.zeros((len(H), 2)), H])


class Gradient(Estimator):
    """The paper's gradient law in integral form, in one sea that has all parts."""

    def __init__(self, model: FixModel) -> None:
        super().__init__(
            model, (model.priors.gradient,), np.ones((1, len(model.optional)), bool)
        )

    def transition(self, model: FixModel, dt: float, latitude: float) -> np.ndarray:
        """Return F over `dt` s, (1, n, n): the steady current is forgotten, too."""
        F = super().transition(model, dt, latitude)
        F[:, HIDDEN : HIDDEN + 2] *= np.exp(-dt / self.priors.gradient.memory)
        return F

    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""
        mean, S = self.predict(dive)
        variance = np.trace(S) / 2
        far = float(np.sum((miss(dive) - mean) ** 2)) / variance
        trust = 1.0 - dive.doubt**2 / variance
        self.model, _, p, P = self.ahead(dive)
        H, R = with_hidden(self.model.regressor(dive, ended=True)), self.noise(dive)
        weight = self.prior_sd(self.model)[0][:, None] ** 2 * H.T
        mu = trust * self.priors.gain * FAR / max(far, FAR)
        gain = mu * weight @ np.linalg.inv(H @ weight + R)
        self.mean = p + (miss(dive) - p @ H.T) @ gain.transpose(0, 2, 1)[0]
        self.covariance, _ = corrected(P, H, R, gain)
        self.time = mid_time(dive)


ESTIMATORS: dict[str, Callable[[FixModel], Estimator]] = {
    "kalman": KalmanBank,
    "gradient": Gradient,
}


@public
def make_estimator(name: str, model: FixModel) -> Estimator:
    """Make an estimator by its name.

    Parameters
    ----------
    name : str
        ``"kalman"`` or ``"gradient"``.
    model : FixModel
        The parameters.

    Returns
    -------
    Estimator
        That has seen no dive.

    Raises
    ------
    ScenarioError
        If the name is unknown.

    Examples
    --------
    >>> make_estimator("gradient", FixModel()).estimate()[0].any()
    np.False_
    """
    if name not in ESTIMATORS:
        raise ScenarioError(
            f"estimator '{name}': must be one of {', '.join(ESTIMATORS)}"
        )
    return ESTIMATORS[name](model)
