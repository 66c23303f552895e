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
from .filtered_flow import mean_feedback, reach
from .law import Known, Setting


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
        scale = one or 0.3 * mean_feedback(known) * reach(known)
        return np.full(known.N, scale)
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


def noise(known: Known) -> float:
    """Return r of the regression, length per square root of time."""
    given = known.settings["noise"]
    return given or 0.1 * reach(known) * float(np.sqrt(mean_feedback(known)))


def covariance_starts(prior: np.ndarray) -> dict[str, Any]:
    """Return P(0) and rho(0)."""
    return {"P": np.diag(prior**2), "rho": np.ones(1)}


SETTINGS = {
    "prior": Setting(
        None,
        "positive",
        "standard deviation of each theta, length/time; 0.3 k R, mean KD times track's reach",
    ),
    "priors": Setting(None, "row", "in place of prior: one a function, 0 to hold it"),
    "noise": Setting(None, "positive", "r of the regression, length/time^0.5; 0.1 R k^0.5"),
    "filter": Setting(None, "positive", "pole l of the filter, 1/time; 2 k"),
}
