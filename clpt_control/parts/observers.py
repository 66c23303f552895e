"""Observer, Kalman filter, and the noise that they are for.

    observer            X' = A X + B u + L (y - C X - D u)
    Kalman-Bucy filter  the same with L = P C^T R^-1,  P' = A P + P A^T + Q - L R L^T
    Kalman filter       x_hat = X + K (y - C X - D u),  K = P C^T (C P C^T + R)^-1
                        X_{k+1} = A x_hat + B u,  P_{k+1} = A (I - K C) P A^T + Q
    noise               n = s n_j,  j T <= t < (j + 1) T,  n_j standard normal

X is an estimate of the states of x' = A x + B u + w, y = C x + D u + n; Q and R are the intensities
of w and n, in discrete time their covariances; P is the covariance of the error.  The noise is a
hash of (seed, j, signal): the same in every reading and at every call, without a state.  Held for
T it is white up to some 1/(2 T), with the intensity s^2 T.

Ports: the inputs u and outputs y of the plant, with its labels -> x_hat, P; none -> n.
Sources: Luenberger 1971, An introduction to observers; Kalman and Bucy 1961, New results in linear
filtering and prediction theory; Kalman 1960, A new approach to linear filtering and prediction.
"""

from typing import Any

import control
import numpy as np
from numpy.typing import ArrayLike

from ..base.arguments import Count, Seed, brief, numbers, public
from ..base.errors import BlockError
from ..base.random_numbers import normal
from ..engine.model.block import Block
from ..engine.model.declaration import Each
from ..engine.model.ports import labels
from ..engine.model.system import SHAPES
from .common import Ports, checked_sizes, make_block, positive

SQUARE = ("n", "n")
MATRIX_SHAPES = {**SHAPES, "L": ("n", "q"), "Q": SQUARE, "R": ("q", "q"), "P0": SQUARE}


def innovation(X, u, p):
    """Return y - C X - D u; a block without feedthrough has no parameter D."""
    if "D" in p._fields:
        return u.y - p.C @ X - p.D @ u.u
    return u.y - p.C @ X


def observed(t, x, u, p):
    """X' = A X + B u + L (y - C X - D u) (Luenberger 1971, section II)."""
    return p.A @ x.x_hat + p.B @ u.u + p.L @ innovation(x.x_hat, u, p)


@public
def observer(
    system: control.StateSpace, L: ArrayLike, name: str = "observer", **ports: str
) -> Block:
    """Make a Luenberger observer of a linear system.

    Parameters
    ----------
    system : control.StateSpace
        A, B, C, D and dt of the plant; of discrete time it is sampled. Ports have its labels:
        ``control.ss(plant, inputs=["f1", "f2"], outputs=["q1", "q2"])`` gives it others.
    L : array_like, shape (n, outputs)
        The gain, such as ``control.place(A.T, C.T, poles).T``.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name, ``u="force", x_hat="estimate"``.

    Returns
    -------
    Block
        With the inputs and outputs of the plant as inputs u and y, and x_hat.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> plant = control.ss([[0, 1], [0, 0]], [[0], [1]], [[1, 0]], 0)
    >>> L = control.place(plant.A.T, plant.C.T, [-2, -3]).T
    >>> clpt.parts.observer(plant, L).linearize([0, 0], [0, 0]).poles().real.round(6).tolist()
    [-3.0, -2.0]
    """
    gain = numbers(f"{name}: L", L)
    if gain.shape == (system.nstates,):  # a row of numbers of one output
        gain = gain[:, None]
    matrices = {**_matrices(name, system), "L": np.atleast_2d(gain)}
    return _of_plant(
        system, name, ports, matrices, update=observed, states={"x_hat": "n"}
    )


def bucy(t, x, u, p):
    """X' = A X + B u + L (y - C X - D u), P' of Riccati (Kalman and Bucy 1961, section 7)."""
    P = covariance(x, p)
    L = np.linalg.solve(p.R, p.C @ P).T
    rate = p.A @ x.x_hat + p.B @ u.u + L @ innovation(x.x_hat, u, p)
    return {"x_hat": rate, "moved": p.A @ P + P @ p.A.T + p.Q - L @ p.R @ L.T}


def bucy_estimate(t, x, u, p):
    """x_hat = X, and P (Kalman and Bucy 1961, section 7)."""
    return {"x_hat": x.x_hat, "P": covariance(x, p)}


def covariance(x, p):
    """Return P without its skew part, which is rounding that an unstable plant would amplify."""
    P = p.P0 + x.moved
    return (P + P.T) / 2


def corrected(x, u, p):
    """Return x_hat and P after the measurement."""
    P = covariance(x, p)
    K = np.linalg.solve(p.C @ P @ p.C.T + p.R, p.C @ P).T
    return x.predicted + K @ innovation(x.predicted, u, p), P - K @ p.C @ P


def kalman_step(t, x, u, p):
    """X = A x_hat + B u, P = A P A^T + Q of what was corrected (Kalman 1960, section "optimal")."""
    x_hat, P = corrected(x, u, p)
    return {"predicted": p.A @ x_hat + p.B @ u.u, "moved": p.A @ P @ p.A.T + p.Q - p.P0}


def kalman_estimate(t, x, u, p):
    """x_hat = X + K (y - C X - D u), P = (I - K C) P (Kalman 1960, section "optimal")."""
    x_hat, P = corrected(x, u, p)
    return {"x_hat": x_hat, "P": P}


def check_covariances(name, matrices):
    """Refuse matrices that are no covariances of a plant's states and outputs."""
    n, q = len(matrices["A"]), len(matrices["C"])
    for key, size in (("Q", n), ("R", q), ("P0", n)):
        M = np.asarray(matrices[key])
        is_symmetric = M.shape == (size, size) and np.allclose(M, M.T, atol=0)
        least = np.linalg.eigvalsh(M)[0] if is_symmetric else -np.inf
        if not least >= -1e-12 * np.max(np.abs(M), initial=0) or (
            key == "R" and least <= 0
        ):
            # but for rounding
            raise BlockError(
                f"{name}: {key} = {brief(M)}: must be symmetric, of shape {(size, size)}, "
                f"and positive {'definite' if key == 'R' else 'semidefinite'}"
            )


@public
def kalman_filter(
    system: control.StateSpace,
    Q: ArrayLike,
    R: ArrayLike,
    P0: Any = None,
    name: str = "kalman_filter",
    **ports: str,
) -> Block:
    """Make a Kalman filter of a linear system.

    Parameters
    ----------
    system : control.StateSpace
        A, B, C, D and dt of the plant; of discrete time the filter is sampled. Ports have its
        labels: ``control.ss(plant, inputs=["f1", "f2"], outputs=["q1", "q2"])`` gives it others.
    Q : array_like, shape (n, n)
        Intensity of the noise of the states; in discrete time its covariance.
    R : array_like, shape (outputs, outputs)
        The same of the measurement, positive definite.
    P0 : array_like, shape (n, n), optional
        Covariance of the estimate at the start; 0 by default.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name, ``u="force", x_hat="estimate"``.

    Returns
    -------
    Block
        With the inputs and outputs of the plant as inputs u and y, and x_hat and P, the covariance
        of its error; x_hat starts at 0. In discrete time both are those after the measurement.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> plant = control.ss(-1, 1, 1, 0)
    >>> run = clpt.simulate(clpt.parts.kalman_filter(plant, [[3]], [[1]]), [0, 9], [[0, 0], [0, 0]])
    >>> run.P.values.round(6).tolist()  # 2 P = 3 - P^2
    [0.0, 1.0]
    """
    matrices = _matrices(name, system)
    P0 = np.zeros_like(matrices["A"]) if P0 is None else P0
    for key, value in (("Q", Q), ("R", R), ("P0", P0)):
        matrices[key] = np.atleast_2d(numbers(f"{name}: {key}", value))
    check_covariances(name, matrices)
    sampled = bool(system.dt)
    return _of_plant(
        system,
        name,
        ports,
        matrices,
        rules=[check_covariances],
        update=kalman_step if sampled else bucy,
        output=kalman_estimate if sampled else bucy_estimate,
        outputs={"x_hat": "n", "P": SQUARE},
        states={"predicted" if sampled else "x_hat": "n", "moved": SQUARE},
    )


def _of_plant(
    system: control.StateSpace,
    name: str,
    ports: Ports,
    matrices: dict[str, Any],
    **declared: Any,
) -> Block:
    """Make a block that reads u and y of a plant, by the plant's labels or the names of ports."""
    shapes = {key: MATRIX_SHAPES[key] for key in matrices}
    inputs = {"u": "m", "y": "q"}
    dt = system.dt or 0
    block = make_block(
        name, ports, matrices, inputs=inputs, shapes=shapes, dt=dt, **declared
    )
    read: list[str] = []
    for port, own in (("u", system.input_labels), ("y", system.output_labels)):
        read += labels({ports[port]: len(own)}) if port in ports else own
    if len({*read}) < len(read):
        raise BlockError(
            f"{name}: its inputs would be {', '.join(read)}; each needs its own name. Give the "
            "plant other labels, or a port's name, such as u='force'"
        )
    block.set_inputs(read)
    return block


def _matrices(name: str, system: control.StateSpace) -> dict[str, Any]:
    if not system.ninputs or not system.noutputs or not system.nstates:
        raise BlockError(f"{name}: the system must have inputs, outputs and states")
    matrices = {"A": system.A, "B": system.B, "C": system.C}
    return {**matrices, "D": system.D} if np.any(system.D) else matrices


def check_seed(name, values):
    """Refuse a seed that is no whole number."""
    if not 0 <= values["seed"] < 2**53 or values["seed"] % 1:
        raise BlockError(
            f"{name}: seed = {values['seed']}: must be a whole number, 0 or more"
        )


def held_noise(t, x, u, p):
    """n = s n_j, section "noise", the hash of Eq. (32)'s disturbance."""
    return p.std * normal(p.seed, p.interval, p.signal)


@public
def noise(
    std: ArrayLike,
    period: float,
    seed: Seed = 0,
    signals: Count = 1,
    name: str = "noise",
    **ports: str,
) -> Block:
    """Make band-limited normal noise: white, held for a period.

    Parameters
    ----------
    std : float or array_like
        Standard deviation; of white noise of an intensity q it is ``sqrt(q / period)``.
    period : float
        How long each number is held.
    seed : int, optional
        A whole number; the same seed is the same noise in every engine.
    signals : int, optional
        Number of signals, independent of each other.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name, ``n="gust"``.

    Returns
    -------
    Block
        With the port n.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> gusts = clpt.parts.noise(2.0, period=0.1, seed=3)
    >>> round(float(clpt.simulate(gusts, range(1000)).n.std()), 1)
    1.9
    """
    values = {**checked_sizes(name, signals, std=std), "period": period, "seed": seed}
    return make_block(
        name,
        ports,
        {**values, "signal": np.arange(float(signals)), "interval": -1.0},
        [check_seed, positive("period"), positive("std", or_zero=True)],
        output=held_noise,
        outputs={"n": signals},
        opaque=True,
        breakpoints=Each("period"),
    )
