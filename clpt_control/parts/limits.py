"""Limits of a signal and of its rate, gaps, tables.

    saturation     y = min(max(u, low), high)
    dead zone      y = u - min(max(u, low), high)
    lookup table   y = Y_k + (u - X_k) (Y_{k+1} - Y_k)/(X_{k+1} - X_k),   X_k <= u <= X_{k+1}
    rate limit     y' = min(max((u - y)/T, -fall), rise)
                   y_k = y_{k-1} + min(max(u_k - y_{k-1}, -fall dt), rise dt)

Sampled (`dt`) the rate limit is exact.  In continuous time its rate would switch at u = y without
end; T is the lag of the actuator that is limited, and the limit itself as T goes to 0.

Ports: u -> y, each of `signals` signals, of one unit (but of the table).
Sources: Astrom and Murray 2008, Feedback Systems, section 10.4; Rundqwist and Hillgren 1996, Phase
compensation of rate limiters in JAS 39 Gripen.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import brief, numbers, public
from ..engine.model.block import Block
from ..errors import BlockError
from .part import each, positive, remembering, rising, sampled, signal_part, time_of


def limited(t, x, u, p):
    """y = min(max(u, low), high) (Astrom and Murray 2008, section 10.4)."""
    return np.clip(u.u, p.low, p.high)


@public
def saturation(
    low: ArrayLike, high: ArrayLike, signals: int = 1, name: str = "saturation", **ports: str
) -> Block:
    """Limit a signal: y = min(max(u, low), high).

    Parameters
    ----------
    low, high : float or array_like
        Limits, in the unit of u; one for all signals, or one for each.
    signals : int, optional
        Number of signals.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name, ``u="v_c"``.

    Returns
    -------
    Block
        With ports u and y.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.parts.saturation(-1, 2, signals=3).output(0, [], [-5, 0.5, 7])
    array([-1. ,  0.5,  2. ])
    """
    limits = each(name, signals, low=low, high=high)
    rising(name, **limits)
    return signal_part(name, ports, limits, signals, output=limited)


def beyond(t, x, u, p):
    """y = u - min(max(u, low), high) (Astrom and Murray 2008, section 10.4)."""
    return u.u - np.clip(u.u, p.low, p.high)


@public
def dead_zone(
    low: ArrayLike, high: ArrayLike, signals: int = 1, name: str = "dead_zone", **ports: str
) -> Block:
    """Pass on what is beyond a gap: y = u - min(max(u, low), high).

    Parameters
    ----------
    low, high : float or array_like
        Ends of the gap, in the unit of u.
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
    >>> clpt.parts.dead_zone(-1, 1, signals=3).output(0, [], [-5, 0.5, 1.5])
    array([-4. ,  0. ,  0.5])
    """
    limits = each(name, signals, low=low, high=high)
    rising(name, **limits)
    return signal_part(name, ports, limits, signals, output=beyond)


def looked_up(t, x, u, p):
    """y = Y_k + (u - X_k) (Y_{k+1} - Y_k)/(X_{k+1} - X_k), section "linear interpolation"."""
    return np.interp(u.u, p.at, p.values)


@public
def lookup_table(
    at: ArrayLike, values: ArrayLike, signals: int = 1, name: str = "lookup_table", **ports: str
) -> Block:
    """Read a table, linear in between.

    Below and above it y is its first and last value.

    Parameters
    ----------
    at : array_like, shape (n,)
        Where the table is given, increasing, in the unit of u.
    values : array_like, shape (n,)
        The value y at each.
    signals : int, optional
        Number of signals, each read from the same table.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name.

    Returns
    -------
    Block
        With ports u and y.

    Raises
    ------
    BlockError
        If `at` does not increase, or has another length than `values`.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> pump = clpt.parts.lookup_table([0, 1, 3], [0, 10, 20], signals=3)
    >>> pump.output(0, [], [0.5, 2, 9])
    array([ 5., 15., 20.])
    """
    places = numbers(f"{name}: at", at)
    if places.ndim != 1 or len(places) < 2 or not np.all(np.diff(places) > 0):
        raise BlockError(f"{name}: at = {brief(at)}: must be two or more increasing numbers")
    if numbers(f"{name}: values", values).shape != places.shape:
        raise BlockError(f"{name}: values = {brief(values)}: must be {len(places)} numbers")
    table = {"at": at, "values": values}
    return signal_part(name, ports, table, signals, output=looked_up)


def limited_rate(t, x, u, p):
    """y' = min(max((u - y)/T, -fall), rise) (Rundqwist 1996, section "rate limiters")."""
    return np.clip((u.u - x.y) / p.lag, -p.fall, p.rise)


def limited_step(t, x, u, p, dt):
    """y_k = y_{k-1} + what is left, within the limits (Rundqwist 1996, section "rate limiters")."""
    return x.last + np.clip(u.u - x.last, -p.fall * dt, p.rise * dt)


@public
def rate_limit(
    rise: ArrayLike,
    fall: Any = None,
    *,
    lag: float | None = None,
    dt: float | None = None,
    signals: int = 1,
    name: str = "rate_limit",
    **ports: str,
) -> Block:
    """Follow a signal no faster than a rate.

    Parameters
    ----------
    rise, fall : float or array_like
        Largest rates up and down, positive, in the unit of u per time; `fall` is `rise` by default.
    lag : float, optional
        In continuous time: y' = (u - y)/lag within the limits.
    dt : float, optional
        Sampled, exactly.
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

    Raises
    ------
    BlockError
        If a rate or time is not positive, or not one of `lag` and `dt` is given.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> run = clpt.simulate(clpt.parts.rate_limit(0.5, lag=0.01), [0, 1, 2, 9], 2.0)
    >>> run.y.values.round(4).tolist()
    [0.0, 0.5, 1.0, 2.0]
    """
    rates = each(name, signals, rise=rise, fall=rise if fall is None else fall)
    positive(name, **rates)
    step = limited_step if dt is None else sampled(limited_step, dt)
    values = {**rates, **time_of(name, lag, dt)}
    return remembering(name, ports, values, signals, limited_rate, step, dt)
