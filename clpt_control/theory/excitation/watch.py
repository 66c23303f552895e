"""Blocks that watch the two facts of a Riccati certificate beside a loop, in simulation and in C.

    f' = -p f + w,    R' = -rho R - rho C I + f f^T - kappa R w w^T R        (`riccati`)
    holds = 1 while R > 0, by its pivots, and b0 < f^T w < b1

The states are f and R less their start.  They need w alone, no truth: w = [phi(x), z_i, zc_i] of
Eq. (31) for the paper's loop, the row of W of a verdict; `scale` puts it into the coordinates.
"""

from typing import Any

import numpy as np

from ...engine.model.block import Block
from ...parts.common import make_block
from .regressor import gains_of_w, regressors, scale_of

USED = {"p", "kappa", "rho", "C", "b0", "b1"}  # constants


def regressor(t, x, u, p):
    """w_i = [phi(x), z_i, zc_i], Eq. (31)."""
    w_x1, w_x2 = regressors(u.phi_x, u.z, u.zc)
    return {"w_x1": w_x1, "w_x2": w_x2}


def least_pivot(R):
    """Return the least pivot of R up to the first that is not positive."""
    least = R[0, 0]
    for k in range(len(R)):
        least = np.minimum(least, R[k, k])
        R = R - np.outer(R[:, k], R[k]) / np.where(least > 0, R[k, k], 1.0)
    return least


def watched(t, x, u, p):
    """Return f' and R', of V of Eq. (24); 0 from where R is not positive, which ends the facts."""
    f, R, w = x.f + p.f0, x.R + p.R0, p.scale @ u.w
    pull = R @ w
    loss = p.rho * (R + p.C * np.eye(len(f)))
    goes_on = np.where(least_pivot(R) > 0, 1.0, 0.0)
    return {
        "f": goes_on * (w - p.p * f),
        "R": goes_on * (np.outer(f, f) - loss - p.kappa * np.outer(pull, pull)),
    }


def held(t, x, u, p):
    """Return whether the facts hold under which V of Eq. (24) falls."""
    R, b = x.R + p.R0, (x.f + p.f0) @ p.scale @ u.w
    least = np.minimum(np.minimum(b - p.b0, p.b1 - b), least_pivot(R))
    return {"holds": np.where(least > 0, 1.0, 0.0)}


def watch_of(excitation: Any) -> list[Block]:
    """Return blocks for `export(..., watch=)` or `connect`: w, and the flag `holds` by axis."""
    rates, form, scenario = excitation.riccati, excitation.form, excitation.scenario
    blocks, scale = [], excitation.scale
    if not form:
        scale, N = scale_of(gains_of_w(scenario)), scenario.basis.N
        inputs, w = {"phi_x": N, "z": 2, "zc": 2}, {"w_x1": N + 2, "w_x2": N + 2}
        blocks += [Block("regressor", output=regressor, inputs=inputs, outputs=w)]
    for axis, rate in rates.items():
        names = {} if form else {"w": f"w_{axis}", "holds": f"holds_{axis}"}
        numbers = {name: float(x) for name, x in rate.constants.items() if name in USED}
        numbers |= {"f0": rate.f, "R0": (rate.R + rate.R.T) / 2, "scale": scale.T}
        watch = make_block(
            f"watch_{axis}",
            names,
            numbers,
            update=watched,
            output=held,
            inputs={"w": len(scale)},
            outputs={"holds": 1},
            states={"f": rate.f.size, "R": rate.R.shape},
        )
        blocks.append(watch)
    return blocks
