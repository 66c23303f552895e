"""The flow: basis functions, Eq. (5), the true flow, Eq. (3), and the modelled flow, Eq. (4).

    phi_i(x, t) = spatial kernel(|x - c_i|, sigma_i) * cos(omega_i t + phase_i)    Eq. (5)
    F_R(x, t) = theta phi(x, t)                                                    Eq. (3)
    F_R(x, t) = theta phi(x, t) + Delta                                            Eq. (32)
    F_M(z, t) = alpha_M phi(z, t)                                                  Eq. (4)

The exponent of Eq. (5) is printed ambiguously; each version is a kernel, a row of `KERNELS`, with
d = |x - c_i| and s = sigma_i.  The example of `clpt init` and the page of scenarios read the rows.

A steady function has omega_i = 0; a sine has phase_i = -pi/2.  Velocities are lengths per time,
phi has no unit.  In `blocks.field` the true flow is a gridded current.

Ports: x[2] -> phi_x[N], or z[2] -> phi_z[N] (positions: length);
phi_x[N], delta[2] if disturbed -> flow_x[2]; phi_z[N] -> flow_z[2].
"""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from ...engine.model.block import Block, evaluate
from ...engine.model.ports import renamed
from .ports import paper_block, shapes_of


def squared_distance(u, p):
    """Return |x - c_i|^2, length squared; the position is the only input."""
    return np.sum((u[:2] - p.centers) ** 2, axis=1)


def tide(t, p):
    """Return cos(omega_i t + phase_i), the temporal factor of Eq. (5)."""
    return np.cos(p.frequencies * t + p.phases)


def exponential(t, x, u, p):
    """phi_i = exp(-d/(2 s)) tide, Eq. (5)."""
    return np.exp(-np.sqrt(squared_distance(u, p)) / (2 * p.widths)) * tide(t, p)


def gaussian(t, x, u, p):
    """phi_i = exp(-d^2/(2 s^2)) tide, Eq. (5)."""
    return np.exp(-squared_distance(u, p) / (2 * p.widths**2)) * tide(t, p)


def gaussian_sigma(t, x, u, p):
    """phi_i = exp(-d^2/s) tide, Eq. (5)."""
    return np.exp(-squared_distance(u, p) / p.widths) * tide(t, p)


class Kernel(NamedTuple):
    """phi_i, its formula, the length of a function of width s, and its largest slope times that."""

    phi: Callable
    formula: str
    length: Callable
    steepest: float


KERNELS = {
    "exponential": Kernel(exponential, "exp(-d/(2 s))", lambda s: s, 0.5),
    "gaussian": Kernel(gaussian, "exp(-d^2/(2 s^2))", lambda s: s, np.exp(-0.5)),
    "gaussian-sigma": Kernel(
        gaussian_sigma, "exp(-d^2/s)", lambda s: np.sqrt(s / 2), np.exp(-0.5)
    ),
}


SHOWN = 1e-3  # share of the flow at a fix that its leg does not show


def largest_shear(kernel: str, widths: Any, theta: Any, spread: Any) -> float:
    """Return an upper bound of |d(theta phi)/dx|, 1/time, for any flow near theta.

    The flow is (theta + eta) phi, and the sum of |eta_k/spread_k|^2 over its functions at most 1.
    """
    slopes = KERNELS[kernel].steepest / KERNELS[kernel].length(np.array(widths))
    own = np.linalg.norm(theta, axis=0) @ slopes
    return float(own + np.linalg.norm(np.asarray(spread) * slopes))


def unspanned(
    basis: Any, prior: float, x: np.ndarray, fixes: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return v at n places, v where functions die out, k(x, fix)^2 of the nearest fix; 0 if s = 0.

    The flow is a field of the prior's variance s^2.  The functions show it at their centres, legs
    at their fixes, but for a share (E. Snelson, Z. Ghahramani, "Sparse Gaussian processes using
    pseudo-inputs", NIPS 2005).  With the narrowest kernel k of the basis and all these places c,
    the variance of the flow that is not shown is

        v = s^2 (1 - k(x, c) (k(c, c) + share)^-1 k(c, x))

    Functions die out where less than 1 is left of sum_i k(x, c_i)^2/n_i over their centres, of
    which n_i = sum_j k(c_i, c_j)^4 are like the i-th; v is at most s^2 times the rest.
    """
    places = np.vstack([np.array(basis.centers), fixes])
    count = len(places)
    zeros, widths = np.zeros(count), np.full(count, np.min(basis.widths))
    still = flow_basis("still", "x", basis.kernel, places, widths, zeros, zeros)
    like, of_places = (evaluate(still, 0.0, at) for at in (places, x))
    solved = np.linalg.solve(like + SHOWN * np.eye(count), of_places.T)
    v = prior**2 * np.maximum(1 - np.sum(of_places.T * solved, axis=0), 0)
    counts = np.sum(like[: basis.N, : basis.N] ** 4, axis=0)
    squares = of_places**2
    left = prior**2 * np.maximum(1 - squares[:, : basis.N] @ (1 / counts), 0)
    nearest = squares[:, basis.N :].max(axis=1, initial=0.0)
    return v, np.minimum(v, left), nearest * (prior > 0)


def flow_basis(
    name: str,
    position: str,
    kernel: str,
    centers: Any,
    widths: Any,
    frequencies: Any,
    phases: Any,
) -> Block:
    """Make the block phi of Eq. (5) at ``"x"``, the vehicle, ``"z"``, its prediction, or any port.

    Centres of shape (N, 2) are lengths, frequencies rad per time, phases rad.
    """
    parameters = {
        "centers": centers,
        "widths": widths,
        "frequencies": frequencies,
        "phases": phases,
    }
    return Block(
        name,
        output=KERNELS[kernel].phi,
        inputs={position: 2},
        outputs={f"phi_{position}": "N"},
        parameters=parameters,
        shapes=shapes_of(parameters),
    )


def phi_and_slopes(
    basis: Block, times: np.ndarray, points: np.ndarray, step: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return phi and its slopes d phi/dx at n points by central differences.

    Shapes (n, N) and (n, N, 2); `step` is a length.
    """
    offsets = step * np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]])
    near = (points[None] + offsets[:, None]).reshape(-1, 2)
    values = evaluate(basis, np.tile(times, 5), near)
    phi, right, left, above, below = values.reshape(5, len(points), -1)
    return phi, np.stack([right - left, above - below], axis=-1) / (2 * step)


def turning_rate(
    slopes: np.ndarray, theta: np.ndarray, P: np.ndarray | float = 0.0
) -> np.ndarray:
    """Return |d(theta phi)/dx| at n points, 1/time; with P the covariance of each row of theta.

    |A|^2 is half the sum of squares: the rate of a rotation, and of a shear along one axis.
    """
    of_theta = theta @ slopes
    square = np.sum(of_theta**2, axis=(1, 2)) / 2
    if np.any(P):
        square = square + np.einsum("nkb,kl,nlb->n", slopes, P, slopes)
    return np.sqrt(square)


def disturbed_flow(flow, u):
    """Return a flow, plus Delta of Eq. (32) if it is an input."""
    delta = getattr(u, "delta", None)
    return flow if delta is None else flow + delta


def true(t, x, u, p):
    """F_R = theta phi(x), Eq. (3), plus Delta of Eq. (32) if disturbed."""
    return disturbed_flow(p.theta @ u.phi_x, u)


def modeled(t, x, u, p):
    """F_M = alpha_M phi(z), Eq. (4)."""
    return p.alpha_M @ u.phi_z


def true_flow(theta: Any, disturbed: bool = False, position: str = "x") -> Block:
    """Make the true flow at a position, Eq. (3), or with the input delta, Eq. (32)."""
    ports = f"x phi_x{' delta' * disturbed} -> flow_x"
    return at_position(
        paper_block("true_flow", ports, {"theta": theta}, output=true), position
    )


def true_of_own_functions(kernel, t, x, u, p):
    """F_R = theta phi(x, t), Eq. (3), of other functions than phi_x, plus Delta if disturbed."""
    return disturbed_flow(p.theta @ KERNELS[kernel].phi(t, x, u, p), u)


def own_true_flow(
    theta: Any,
    kernel: str,
    functions: Mapping[str, Any],
    disturbed: bool = False,
    position: str = "x",
) -> Block:
    """Make a true flow of functions of its own, parameters as those of `flow_basis`."""
    ports = f"{position}{' delta' * disturbed} -> flow_x"
    output = partial(true_of_own_functions, kernel)
    return paper_block("true_flow", ports, {**functions, "theta": theta}, output=output)


def at_position(block: Block, position: str) -> Block:
    """Return a block whose ports x and phi_x are renamed to another position's."""
    ports = {"x": position, "phi_x": f"phi_{position}"}
    return block if position == "x" else renamed(block, block.name, ports, ports)


def modeled_flow(alpha_M: Any) -> Block:
    """Make the modelled flow, Eq. (4)."""
    return paper_block(
        "modeled_flow", "phi_z -> flow_z", {"alpha_M": alpha_M}, output=modeled
    )
