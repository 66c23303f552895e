"""The covariance P of least squares, forgetting with bounded gain.

    P'   = lambda P - P phi_f phi_f^T P / r^2,    lambda = lambda_0 (1 - tr P/k_0),  k_0 = tr P(0)
    rho' = -lambda rho,                           rho(0) = 1: the share of the prior still held

P is N x N, symmetric, one for both axes.  P(0) holds the prior variances; a function whose prior
is 0 keeps its parameter.  tr P, a norm of matrices P >= 0, never passes k_0, so forgetting ends
where P would wind up, and lambda >= 0; with lambda_0 = 0 nothing is forgotten.  Then

    (P(0)^-1 + int phi_f phi_f^T/r^2)^-1 <= P <= P(0)/rho  and  P <= k_0 I

Source: Slotine and Li 1991, Applied Nonlinear Control, section 8.7.6 (bounded-gain forgetting).

States: P[N*N] (length per time, squared), rho[1].
"""

from typing import Any

import numpy as np

from ...errors import ScenarioError
from .commanded_gains import gains_losses, symmetric
from .filtered_flow import shared_kept, unexplained_square
from .law import Known, Setting, Truth
from .scales import FILTER, NOISE, PRIOR, mean_feedback, noise, prior

Row = np.ndarray
Shared = tuple[int, float, float, Row, float, float, float, float, float, Row]


def weigh(dx, x, P, w, at, n):
    """Fill n places of dx from `at` on with P w; P stands in x."""
    for j in range(n):
        total = 0.0
        for k in range(n):
            total += x[P + j * n + k] * w[k]
        dx[at + j] = total


def forgetting(x, p, P):
    """Return lambda, per time."""
    trace = 0.0
    for j in range(p.N):
        trace += x[P + j * p.N + j]
    return p.forgetting * (1 - trace / p.largest)


def covariance_rates(dx, x, p, P, at):
    """Fill P' and rho', which stands behind P; P phi_f stands in dx from `at` on."""
    n, forgotten, precision = p.N, forgetting(x, p, P), 1 / p.noise**2
    for j in range(n):
        for k in range(n):
            seen = dx[at + j] * dx[at + k] * precision
            dx[P + j * n + k] = forgotten * x[P + j * n + k] - seen
    dx[P + n * n] = -forgotten * x[P + n * n]


def priors(known: Known, table: str) -> np.ndarray:
    """Return the prior standard deviation of each parameter, shape (N,), length per time."""
    one, each = known.settings["prior"], known.settings["priors"]
    if each is None:
        return np.full(known.N, prior(known))
    if one is not None:
        raise ScenarioError(f"learning.{table}.priors: give either prior or priors, one of the two")
    if len(each) != known.N:
        raise ScenarioError(
            f"learning.{table}.priors: has {len(each)} numbers; must be one for each of the "
            f"{known.N} functions, 0 to hold its parameter"
        )
    if not any(each):
        raise ScenarioError(
            f"learning.{table}.priors: are all 0, which holds every parameter; give at least one"
        )
    return np.asarray(each, dtype=float)


def information(prior: np.ndarray) -> np.ndarray:
    """Return P(0)^-1, 0 for what is held, (time per length) squared."""
    return np.divide(1.0, prior**2, out=np.zeros(len(prior)), where=prior > 0)


def covariance_starts(prior: np.ndarray) -> dict[str, Any]:
    """Return P(0) and rho(0)."""
    return {"P": np.diag(prior**2), "rho": np.ones(1)}


def shared_parameters(known: Known, prior: np.ndarray, forgotten: float) -> Shared:
    """Return the parameters from N to P(0)^-1 that each law with this P has."""
    k = mean_feedback(known)
    return (
        known.N,
        known.gains.feedback,
        known.gains.feedforward,
        known.alpha_M,
        k,
        known.settings["filter"] or 2 * k,
        noise(known),
        forgotten,
        float(np.sum(prior**2)),
        information(prior),
    )


def covariance_kept(s: Any, p: Any, truth: Truth, over: Any) -> dict[str, Any]:
    """Return P = P^T, alpha of eta P^-1 = `over`, F_f = theta phi_f and those of K and Gamma."""
    P = symmetric(s["P"], p.N)
    return {"P": P, "alpha": over @ P - truth.theta, **shared_kept(s, p, truth)}


def covariance_losses(s: Any, p: Any, truth: Truth, over: Any, weight: float) -> list[tuple]:
    """Return |eta phi_f|^2/(2 w), r^2 lambda tr(eta P^-1 eta^T)/(2 w), what K and Gamma lose."""
    P = s["P"].reshape(p.N, p.N)
    forgotten = (p.forgetting, 1 - np.trace(P) / p.largest, np.sum((over @ P) * over))
    return [
        (unexplained_square(s, p, truth), 1 / (2 * weight)),
        (*forgotten, p.noise**2 / (2 * weight)),
        *gains_losses(s, p, truth),
    ]


SETTINGS = {
    "prior": PRIOR,
    "priors": Setting(None, "row", "in place of prior: one a function, 0 to hold it"),
    "noise": NOISE,
    "filter": FILTER,
}
