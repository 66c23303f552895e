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
from ..lyapunov import level
from .known import NOISE, PRIOR, Known, Setting, Truth, prior
from .law import Law, Part, State
from .regressions import unexplained_square


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


def level_over_P(u, p, over, w):
    """Return V of Eq. (24) with r^2 tr(eta P^-1 eta^T)/w for |eta|^2; eta P^-1 is over."""
    return {"V": level(u.e, u, p) + p.noise**2 / (2 * w) * np.sum((p.theta + u.alpha) * over)}


def priors(known: Known) -> np.ndarray:
    """Return the prior standard deviation of each parameter, shape (N,), length per time."""
    each = known.settings["priors"]
    return np.full(known.N, prior(known)) if each is None else np.asarray(each, dtype=float)


def refuses(law: Law, known: Known) -> None:
    """Refuse priors that do not fit the functions."""
    one, each = known.settings["prior"], known.settings["priors"]
    if each is None:
        return
    count = f"has {len(each)} numbers; must be one for each of the {known.N} functions"
    for wrong, said in (
        (one is not None, "give either prior or priors, one of the two"),
        (len(each) != known.N, f"{count}, 0 to hold its parameter"),
        (not any(each), "are all 0, which holds all parameters; give at least one"),
    ):
        if wrong:
            raise ScenarioError(f"learning.{law.table}.priors: {said}")


def information(known: Known) -> np.ndarray:
    """Return P(0)^-1, 0 for what is held, (time per length) squared."""
    return np.array([1 / one**2 if one > 0 else 0.0 for one in priors(known)])


def covariance(over: Callable[..., Any], weight: str) -> Part:
    """Make the part of a law with this P, of its eta P^-1 and the parameter that is w."""

    def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
        """Return alpha of eta P^-1."""
        return {"alpha": over(s, p, truth) @ s["P"] - truth.theta}

    def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
        """Return |eta phi_f|^2/(2 w) and r^2 lambda tr(eta P^-1 eta^T)/(2 w)."""
        w, eta_over = getattr(p, weight), over(s, p, truth)
        forgotten = (p.forgetting, 1 - np.trace(s["P"]) / p.largest)
        return [
            (unexplained_square(s, p, truth), 1 / (2 * w)),
            (*forgotten, np.sum((eta_over @ s["P"]) * eta_over), p.noise**2 / (2 * w)),
        ]

    return {
        "keys": {
            "prior": PRIOR,
            "priors": Setting("in place of prior: one a function, 0 to hold it", None, "row"),
        },
        "parameters": {
            "noise": NOISE,
            "largest": lambda known: float(np.sum(priors(known) ** 2)),  # k_0 = tr P(0)
            "information": information,
        },
        "states": {
            "P": State(("N", "N"), lambda known, p: np.diag(priors(known) ** 2)),
            "rho": State(1, 1.0),
        },
        "refuses": refuses,
        "keeps": keeps,
        "losses": losses,
        "over": over,
        "cones": ("P",),
    }
