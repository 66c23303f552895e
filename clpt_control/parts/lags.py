"""Lags and delays, and the sampler with its hold.

    lag             T y' = K u - y
    delay           y(t) = u(t - T):  T x_i' = (2 i + 1) (s_i u + sum_j a_ij x_j),  y = sum_i x_i,
                    s_i = (-1)^i,  a_ij = -1 (i < j) or (-1)^{i - j + 1};  i, j = 0 ... n - 1
    delay, sampled  y_k = u_{k - n},  n = T / dt
    hold            y = u(k dt) for k dt <= t < (k + 1) dt

The continuous delay is the Pade approximant of exp(-s T) whose numerator has one degree less than
its denominator, on Legendre polynomials of the last T of u: well scaled at any order, and without
the jump of -u or u at once that equal degrees make.  It is exp(-s T) up to about n radians of
omega T.  The sampled delay is exact.

Ports: u -> y, each of `signals` signals.
Sources: Astrom and Murray 2008, Feedback Systems, section 5.3; Voelker, Kajic and Eliasmith 2019,
Legendre Memory Units, Eqs. (1) to (3), NeurIPS 32 (delay); Franklin, Powell and Workman 1998,
Digital Control of Dynamic Systems (hold).
"""

import numpy as np
from numpy.typing import ArrayLike

from ..base.arguments import Count, public
from ..base.errors import BlockError
from ..engine.model.block import Block
from ..engine.model.ports import check_count
from .common import (
    check_positive,
    checked_sizes,
    following_block,
    positive,
    signal_block,
)

MOST_ORDER = 500  # of a Pade approximant: its matrix is full


def lagging(t, x, u, p):
    """T y' = K u - y (Astrom and Murray 2008, section 5.3)."""
    return (p.gain * u.u - x.y) / p.lag


@public
def lag(
    lag: ArrayLike,
    gain: ArrayLike = 1.0,
    signals: Count = 1,
    name: str = "lag",
    **ports: str,
) -> Block:
    """Follow a signal with a first-order lag: T y' = K u - y.

    Parameters
    ----------
    lag : float or array_like
        The time T.
    gain : float or array_like, optional
        The gain K, in the unit of y by that of u.
    signals : int, optional
        Number of signals.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name.

    Returns
    -------
    Block
        With ports u and y.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> run = clpt.simulate(clpt.parts.lag(2.0, u="v_c", y="v"), [0, 2, 20], 1.0)
    >>> run.v.values.round(4).tolist()
    [0.0, 0.6321, 1.0]
    """
    values = checked_sizes(name, signals, lag=lag, gain=gain)
    rules = [positive("lag")]
    return following_block(name, ports, values, signals, rules, lagging)


def legendre_rate(t, x, u, p):
    """T x_i' = (2 i + 1) (s_i u + sum_j a_ij x_j) (Voelker et al. 2019, Eq. (2))."""
    return (p.A @ x.past + np.outer(p.B, u.u)) / p.delay


def oldest(t, x, u, p):
    """y = sum_i x_i, the far end of the past (Voelker et al. 2019, Eq. (3))."""
    return p.C @ x.past


def shifted(t, x, u, p):
    """The line of the last n inputs, one further, section "hold"."""
    return np.concatenate([[u.u], x.line[:-1]])


def last_of_line(t, x, u, p):
    """y_k = u_{k - n}, the end of the line, section "hold"."""
    return x.line[-1]


@public
def delay(
    delay: float,
    order: Count = 4,
    *,
    dt: float | None = None,
    signals: Count = 1,
    name: str = "delay",
    **ports: str,
) -> Block:
    """Delay a signal: y(t) = u(t - T).

    Parameters
    ----------
    delay : float
        The delay T.
    order : int, optional
        In continuous time: the order of the Pade approximant, good up to some `order` radians of
        omega T.
    dt : float, optional
        Sampled, exactly; T is then a multiple of it.
    signals : int, optional
        Number of signals.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name.

    Returns
    -------
    Block
        With ports u and y; y is 0 before the first input arrives.

    Raises
    ------
    BlockError
        If the delay is not positive, or no multiple of `dt`.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.simulate(clpt.parts.delay(2.0, dt=1.0), range(5), [[1, 2, 3, 4, 5]]).y.values.tolist()
    [0.0, 0.0, 1.0, 2.0, 3.0]
    """
    check_positive(name, delay=delay)
    if dt is not None:
        check_positive(name, dt=dt)
        given = f"{name}: delay = {delay}, dt = {dt}, signals = {signals}"
        check_count(given, delay / dt * signals, "Give a longer dt")
        count = round(delay / dt)
        if count < 1 or abs(count * dt - delay) > 1e-9 * delay:
            raise BlockError(
                f"{name}: delay = {delay}: must be a multiple of dt = {dt}"
            )
        line = {"line": (count, signals)}
        return signal_block(
            name,
            ports,
            {},
            signals,
            update=shifted,
            output=last_of_line,
            states=line,
            dt=dt,
        )
    if order > MOST_ORDER:
        raise BlockError(
            f"{name}: order = {order}: must be at most {MOST_ORDER}. Give dt for a longer delay"
        )
    i = np.arange(order)
    weight, sign = 2.0 * i + 1, (-1.0) ** i
    A = weight[:, None] * np.where(i[:, None] < i, -1.0, -np.outer(sign, sign))
    values = {"delay": delay, "A": A, "B": weight * sign, "C": np.ones(order)}
    past = {"past": (order, signals)}
    block = signal_block(
        name,
        ports,
        values,
        signals,
        rules=[positive("delay")],
        update=legendre_rate,
        output=oldest,
        states=past,
    )
    block.approximation = f"the Padé approximation of order {order} of {name}"
    return block


def as_sampled(t, x, u, p):
    """y = u, of a sample (Franklin, Powell and Workman 1998, section "hold")."""
    return u.u


@public
def hold(dt: float, signals: Count = 1, name: str = "hold", **ports: str) -> Block:
    """Sample a signal at each multiple of dt, and hold it.

    Parameters
    ----------
    dt : float
        From one sample to the next; time 0 is one.
    signals : int, optional
        Number of signals.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name.

    Returns
    -------
    Block
        With ports u and y, of discrete time: beside continuous parts it samples.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> lag = clpt.parts.lag(1e-3, u="y", y="v")  # of continuous time
    >>> loop = clpt.connect([clpt.parts.hold(1.0), lag], external="u")
    >>> clpt.simulate(loop, [0, 0.5, 1, 1.5], [[0, 1, 2, 3]]).y.values.tolist()
    [0.0, 0.0, 2.0, 2.0]
    """
    check_positive(name, dt=dt)
    return signal_block(name, ports, {}, signals, output=as_sampled, dt=dt)
