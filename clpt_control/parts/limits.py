"""Limits of a signal and of its rate, gaps, tables, backlash and relay.

    saturation     y = min(max(u, low), high)
    dead zone      y = u - min(max(u, low), high)
    lookup table   y = Y_k + (u - X_k) (Y_{k+1} - Y_k)/(X_{k+1} - X_k),   X_k <= u <= X_{k+1}
    rate limit     y' = min(max((u - y)/T, -fall), rise)
                   y_k = y_{k-1} + min(max(u_k - y_{k-1}, -fall dt), rise dt)
    backlash       y' = dz(u - y)/T,             dz(e) = e - min(max(e, -w/2), w/2)
                   y_k = min(max(y_{k-1}, u_k - w/2), u_k + w/2)
    relay          T m' = sgn(m + v) - m,        y = high if m + v > 0, else low
                   m_k = sgn(m_{k-1} + v_k),     v = -1 at off, 1 at on

Sampled (`dt`) the rate limit, the backlash and the relay are exact.  In continuous time each is the
published differential equation with a time T, which becomes exact as T goes to 0:

- The rate limit would switch at u = y without end; T is the lag of the limited actuator.
- Teeth in contact move with the lag T.
- The relay switches at `on` and `off`, except for exp(-s/T) of their distance at a time s after the
  switch before.

Ports: u -> y, each of `signals` signals, of one unit (except the table and the relay).
Sources: Astrom and Murray 2008, Feedback Systems, section 10.4; Rundqwist and Hillgren 1996, Phase
compensation of rate limiters in JAS 39 Gripen; Visintin 1994, Differential Models of Hysteresis,
section III.2 (the play operator and its regularization); Schmitt 1938, A thermionic trigger,
Journal of Scientific Instruments 15.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..base.arguments import Count, brief, finite, numbers, public
from ..base.errors import BlockError
from ..engine.model.block import Block
from .common import (
    checked_sizes,
    following_block,
    lag_parameter,
    ordered,
    positive,
    signal_block,
    with_constants,
)


def limited(t, x, u, p):
    """y = min(max(u, low), high) (Astrom and Murray 2008, section 10.4)."""
    return np.clip(u.u, p.low, p.high)


@public
def saturation(
    low: ArrayLike,
    high: ArrayLike,
    signals: Count = 1,
    name: str = "saturation",
    **ports: str,
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
    limits = checked_sizes(name, signals, low=low, high=high)
    rules = [ordered("low", "high")]
    return signal_block(name, ports, limits, signals, rules=rules, output=limited)


def beyond(t, x, u, p):
    """y = u - min(max(u, low), high) (Astrom and Murray 2008, section 10.4)."""
    return u.u - np.clip(u.u, p.low, p.high)


@public
def dead_zone(
    low: ArrayLike,
    high: ArrayLike,
    signals: Count = 1,
    name: str = "dead_zone",
    **ports: str,
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
    limits = checked_sizes(name, signals, low=low, high=high)
    rules = [ordered("low", "high", np.less_equal)]
    return signal_block(name, ports, limits, signals, rules=rules, output=beyond)


def looked_up(t, x, u, p):
    """y = Y_k + (u - X_k) (Y_{k+1} - Y_k)/(X_{k+1} - X_k), section "linear interpolation"."""
    return np.interp(u.u, p.at, p.values)


def check_table(name, table):
    """Refuse points that do not increase, or other numbers of points and values."""
    at, values = table["at"], table["values"]
    points = numbers(f"{name}: at", at)
    if points.ndim != 1 or len(points) < 2 or not np.all(np.diff(points) > 0):
        raise BlockError(
            f"{name}: at = {brief(at)}: must be two or more increasing numbers"
        )
    if numbers(f"{name}: values", values).shape != points.shape:
        raise BlockError(
            f"{name}: values = {brief(values)}: must be {len(points)} numbers"
        )


@public
def lookup_table(
    at: ArrayLike,
    values: ArrayLike,
    signals: Count = 1,
    name: str = "lookup_table",
    **ports: str,
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
    table = {"at": at, "values": values}
    return signal_block(
        name, ports, table, signals, rules=[check_table], output=looked_up
    )


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
    signals: Count = 1,
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
    rates = checked_sizes(name, signals, rise=rise, fall=rise if fall is None else fall)
    step = limited_step if dt is None else with_constants(limited_step, dt=dt)
    values = rates | lag_parameter(name, lag, dt)
    rules = [positive("rise", "fall", "lag")]
    return following_block(name, ports, values, signals, rules, limited_rate, step, dt)


# --- hysteresis ----------------------------------------------------------------------------------


def gap_closed(t, x, u, p):
    """y' = dz(u - y)/T, of a gap w (Visintin 1994, section III.2, regularized play)."""
    offset = u.u - x.y
    return (offset - np.clip(offset, -p.width / 2, p.width / 2)) / p.lag


def play(t, x, u, p):
    """y_k = min(max(y_{k-1}, u_k - w/2), u_k + w/2) (Visintin 1994, section III.2)."""
    return np.clip(x.last, u.u - p.width / 2, u.u + p.width / 2)


@public
def backlash(
    width: ArrayLike,
    *,
    lag: float | None = None,
    dt: float | None = None,
    signals: Count = 1,
    name: str = "backlash",
    **ports: str,
) -> Block:
    """Follow a signal across a gap, as worn gears do.

    Parameters
    ----------
    width : float or array_like
        The whole gap, in the unit of u.
    lag : float, optional
        In continuous time: how soon teeth that touch carry along; 0 would be the play itself.
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
        If a width or time is not positive, or not one of `lag` and `dt` is given.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> gears = clpt.parts.backlash(1.0, dt=1.0)
    >>> clpt.simulate(gears, range(6), [[0, 1, 2, 1.5, 1, 0]]).y.values.tolist()
    [0.0, 0.5, 1.5, 1.5, 1.5, 0.5]
    """
    width_of_gap = checked_sizes(name, signals, width=width)
    values = width_of_gap | lag_parameter(name, lag, dt)
    rules = [positive("width", "lag")]
    return following_block(name, ports, values, signals, rules, gap_closed, play, dt)


def closed_by(x, u, p):
    """Return m + v, which closes the relay where it is positive; v is -1 at off, 1 at on."""
    return x.closed + (2 * u.u - p.on - p.off) / (p.on - p.off)


def trigger(t, x, u, p):
    """T m' = sgn(m + v) - m (Schmitt 1938, section "trigger": feedback about a comparator)."""
    return (switched(t, x, u, p) - x.closed) / p.lag


def switched(t, x, u, p):
    """m_k = sgn(m_{k-1} + v_k) (Schmitt 1938, section "trigger")."""
    return np.where(closed_by(x, u, p) > 0, 1.0, -1.0)


def relayed(t, x, u, p):
    """y = high where m + v > 0, or low (Schmitt 1938, section "trigger")."""
    return np.where(closed_by(x, u, p) > 0, p.high, p.low)


def check_outputs(name, values):
    """Refuse outputs that are not finite, which are no limits here."""
    for key in ("low", "high"):
        finite(f"{name}: {key}", values[key])


@public
def relay(
    on: ArrayLike,
    off: ArrayLike,
    low: ArrayLike = -1.0,
    high: ArrayLike = 1.0,
    *,
    lag: float | None = None,
    dt: float | None = None,
    signals: Count = 1,
    name: str = "relay",
    **ports: str,
) -> Block:
    """Switch between two values, with hysteresis.

    To `high` where u passes `on`, to `low` where it falls below `off`.

    Parameters
    ----------
    on, off : float or array_like
        Where it switches, `off` below `on`, in the unit of u. At first, in between, it is high
        above the middle.
    low, high : float or array_like
        The two outputs; `low` above `high` inverts.
    lag : float, optional
        In continuous time: how soon the comparator settles. It must be much shorter than the time
        between two switches.
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
        If `off` is not below `on`, or not one of `lag` and `dt` is given.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> switch = clpt.parts.relay(on=1, off=-1, low=0, high=5, dt=1.0)
    >>> clpt.simulate(switch, range(6), [[-2, 0.5, 2, 0.5, -0.5, -2]]).y.values.tolist()
    [0.0, 0.0, 5.0, 5.0, 5.0, 0.0]
    """
    values = checked_sizes(name, signals, off=off, on=on, low=low, high=high)
    return signal_block(
        name,
        ports,
        values | lag_parameter(name, lag, dt),
        signals,
        rules=[check_outputs, ordered("off", "on"), positive("lag")],
        update=switched if lag is None else trigger,
        output=relayed,
        states={"closed": signals},
        dt=dt or 0,
    )
