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

from collections.abc import Callable
from typing import Any

import numpy as np

from ...errors import ScenarioError
from .commanded_gains import gains_losses, symmetric
from .filtered_flow import SHARED, TAKES, shared_kept, unexplained_square
from .known import Known, Truth
from .law import HELD, Law, Setting, State
from .scales import FILTER, NOISE, PRIOR, mean_feedback, prior


def forgetting(x, p):
    """Return lambda, per time."""
    return p.forgetting * (1 - np.trace(x.P) / p.largest)


def covariance_rates(x, p, seen):
    """Return P' and rho'; P phi_f is seen."""
    forgotten = forgetting(x, p)
    return {
        "P": forgotten * x.P - np.outer(seen, seen) / p.noise**2,
        "rho": -forgotten * x.rho,
    }


def priors(known: Known) -> np.ndarray:
    """Return the prior standard deviation of each parameter, shape (N,), length per time."""
    each = known.settings["priors"]
    return np.full(known.N, prior(known)) if each is None else np.asarray(each, dtype=float)


def refuses(law: Law, known: Known) -> None:
    """Refuse priors that do not fit the functions."""
    one, each = known.settings["prior"], known.settings["priors"]
    if each is None:
        return
    if one is not None:
        raise ScenarioError(
            f"learning.{law.table}.priors: give either prior or priors, one of the two"
        )
    if len(each) != known.N:
        raise ScenarioError(
            f"learning.{law.table}.priors: has {len(each)} numbers; must be one for each of the "
            f"{known.N} functions, 0 to hold its parameter"
        )
    if not any(each):
        raise ScenarioError(
            f"learning.{law.table}.priors: are all 0, which holds all parameters; give at least one"
        )


def information(known: Known) -> np.ndarray:
    """Return P(0)^-1, 0 for what is held, (time per length) squared."""
    prior = priors(known)
    return np.divide(1.0, prior**2, out=np.zeros(len(prior)), where=prior > 0)


def with_covariance(over: Callable[..., Any], weight: str) -> dict[str, Any]:
    """Return what rows of laws with this P share, of eta P^-1 and the parameter that is w."""

    def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
        """Return P = P^T, alpha of eta P^-1, F_f = theta phi_f and those of K and Gamma."""
        P = symmetric(s["P"])
        return {"P": P, "alpha": over(s, p, truth) @ P - truth.theta, **shared_kept(s, p, truth)}

    def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
        """Return |eta phi_f|^2/(2 w), r^2 lambda tr(eta P^-1 eta^T)/(2 w), those of the gains."""
        w, eta_over = getattr(p, weight), over(s, p, truth)
        forgotten = (p.forgetting, 1 - np.trace(s["P"]) / p.largest)
        return [
            (unexplained_square(s, p, truth), 1 / (2 * w)),
            (*forgotten, np.sum((eta_over @ s["P"]) * eta_over), p.noise**2 / (2 * w)),
            *gains_losses(s, p, truth),
        ]

    return {
        "needs": "the commanded velocity",
        "keys": KEYS,
        "takes": TAKES,
        "refuses": refuses,
        "gain": 1.0,
        "keeps": keeps,
        "losses": losses,
        "over": over,
        "cones": ("P", "Q_1", "Q_2"),
    }


KEYS = {
    "prior": PRIOR,
    "priors": Setting(None, "row", "in place of prior: one a function, 0 to hold it"),
}
PARAMETERS = {
    **HELD,
    "alpha_M": "alpha_M",
    "rate": mean_feedback,
    "noise": NOISE,
    "filter": FILTER,
    "largest": lambda known: float(np.sum(priors(known) ** 2)),  # k_0 = tr P(0)
    "information": information,
}
STATES = {
    **SHARED,
    "P": State(("N", "N"), lambda known, p: np.diag(priors(known) ** 2)),
    "rho": State(1, 1.0),
}
