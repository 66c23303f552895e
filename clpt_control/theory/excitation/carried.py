"""Transition matrix of the errors, computed along a run, and by blocks beside a loop.

In coordinates in which V is |x|^2 / 2, x = [e; th] of each axis,

    x' = M x + g,    M = [[A, W], [-W^T, 0]],    A + A^T <= 0,    Phi' = M Phi,    Phi = I first
    |x(t)| <= |Phi(t)| |x(0)| + int |g| dt,      any W, start, disturbance and size of e

`errors_carried` of `theory/coq/Carried.v`.  W is that of the run itself: w = [phi(x), z_i, zc_i] of
Eq. (31) for the paper's loop, W of a verdict.  Phi therefore holds for this run.  Ahead |Phi| is
known by windows only: where |Phi| <= q in each window of length T, with |g| <= D,

    limsup |x| <= D T / (1 - q) at the ends of windows,  and D T more between
"""

from dataclasses import replace
from itertools import accumulate, pairwise
from typing import Any

import numpy as np

from ...base.errors import DataError
from ...engine.model.block import Block
from ...engine.model.declaration import Each
from ...parts.common import make_block
from .certificates import drop_of, refuse_uncertified, worsened
from .regressor import gains_of_w, regressors, scale_of, span_of

MOST_WINDOWS = 1000
LEAST = 1e-5  # bound of |Phi|, above what is lost by rounding Phi - I to float, and by steps


def regressor(t, x, u, p):
    """w_i = [phi(x), z_i, zc_i], Eq. (31)."""
    w_x1, w_x2 = regressors(u.phi_x, u.z, u.zc)
    return {"w_x1": w_x1, "w_x2": w_x2}


def bound_of_norm(Phi):
    """Return a bound of |Phi|: |Phi|^4 = |S|^2 = |S^2| <= |S^2|_F for S = Phi^T Phi."""
    size = np.maximum(np.max(np.abs(Phi)), LEAST)
    Phi = Phi / size
    S = Phi.T @ Phi
    # the sum is 1 at least from the largest entry of Phi
    return np.minimum(size * np.maximum(np.sum((S @ S) ** 2), 1.0) ** 0.125, 1.0)


def moves(t, x, u, p):
    """Phi' = M Phi in the window, of the errors of Eq. (27)-(28), e first; the state is Phi - I."""
    Phi = np.eye(len(x.moved)) + x.moved
    m = len(p.A)
    W = p.left @ u.w.reshape(m, -1) @ p.right
    rates = np.concatenate([p.A @ Phi[:m] + W @ Phi[m:], -W.T @ Phi[:m]])
    return {"moved": rates, "past": 0.0, "worst": 0.0}


def restarted(t, x, u, p):
    """End a window of the errors of Eq. (27)-(28): keep its Phi, and begin with Phi = I."""
    one = np.eye(len(x.moved))
    Phi = one + x.moved
    worst = np.maximum(x.worst, bound_of_norm(Phi))
    return {"moved": 0.0, "past": Phi @ (one + x.past) - one, "worst": worst}


def norms(t, x, u, p):
    """Return bounds of |Phi| of Eq. (27)-(28), from the start and in each window."""
    one = np.eye(len(x.moved))
    return {"factor": bound_of_norm((one + x.moved) @ (one + x.past)), "worst": x.worst}


def watch_of(excitation: Any) -> list[Block]:
    """Return blocks for `export(..., watch=)` or `connect`, which carry Phi beside the loop.

    Outputs are `factor_x1`, a bound of ``|Phi|`` from the start, and `worst_x1`, of the largest
    in windows that have ended at multiples of the excitation's, 0 before; of a verdict, `factor`
    and `worst`.  The input `w` of a verdict is W, row by row.  Numbers are those of the excitation.
    """
    refuse_uncertified(excitation)
    form, scenario = excitation.form, excitation.scenario
    if form:
        blocks, watched = [], {"": (form.scaled_A, form.left, form.right)}
    else:
        w, scale = scenario.basis.N + 2, scale_of(gains_of_w(scenario))
        blocks = [
            Block(
                "regressor",
                output=regressor,
                inputs={"phi_x": w - 2, "z": 2, "zc": 2},
                outputs={"w_x1": w, "w_x2": w},
            )
        ]
        by_axis = zip(excitation.names, scenario.vehicle.feedback, strict=True)
        watched = {f"_{axis}": ([[-k]], [[1.0]], scale) for axis, k in by_axis}
    errors = "errors", "errors"
    for axis, (A, left, right) in watched.items():
        m, (parameters, n) = len(A), np.shape(right)
        blocks += [
            make_block(
                f"watch{axis}",
                {port: port + axis for port in ("w", "factor", "worst")},
                {"A": A, "left": left, "right": right, "interval": -1.0},
                update=moves,
                output=norms,
                jump=restarted,
                breakpoints=Each(excitation.window),
                inputs={"w": m * parameters},
                outputs={"factor": 1, "worst": 1},
                sizes={"errors": m + n},
                states={"moved": errors, "past": errors, "worst": 1},
            )
        ]
    return blocks


def transition_of(excitation: Any) -> Any:
    """Norms of Phi along the run, a Dataset with `factor` and `window_factor` by time and axis.

    Times are ends of windows like this one, one after another, and of the run. `factor` is the norm
    from the start of the run: the norm of its errors, the root of V, is at most `factor` times the
    first, but for what a disturbance adds. `window_factor` is that of the window that ends.
    """
    import xarray

    refuse_uncertified(excitation)
    (begin, end), T = span_of(excitation.source), excitation.window
    count = (end - begin) / T
    if count > MOST_WINDOWS:
        raise DataError(
            f"transition: the run has more than {MOST_WINDOWS} windows. Give a longer window"
        )
    edges = np.append(begin + T * np.arange(np.ceil(count - 1e-9)), end)
    whole = excitation.over(excitation.source, end - begin, begin, edges).exact
    cuts = pairwise(np.searchsorted(whole.cuts, edges - 1e-9 * T))
    Phi = [
        drop_of(replace(whole, w=whole.w[:, a:b], weights=whole.weights[a:b]))[1]
        for a, b in cuts
    ]
    factor, of_window = (
        np.minimum(worsened(np.array([*matrices]), whole.change)[..., 0], 1.0)
        for matrices in (accumulate(Phi, lambda past, window: window @ past), Phi)
    )
    if len(edges) > count + 1.000001:  # the last is shorter
        of_window[-1] = np.nan
    dims = "time", "axis"
    variables = {"factor": (dims, factor), "window_factor": (dims, of_window)}
    return xarray.Dataset(variables, {"time": edges[1:], "axis": [*excitation.names]})
