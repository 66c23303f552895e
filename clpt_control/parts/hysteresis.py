"""Backlash and the relay, which remember where their input came from.

    backlash   y' = dz(u - y)/T,             dz(e) = e - min(max(e, -w/2), w/2)
               y_k = min(max(y_{k-1}, u_k - w/2), u_k + w/2)
    relay      T m' = sgn(m + v) - m,        y = high where m + v > 0, or low
               m_k = sgn(m_{k-1} + v_k),     v = -1 at off, 1 at on

Sampled (`dt`) both are exact.  In continuous time no state jumps where a signal passes a value, so
each is the published differential equation with a time T, and is exact as T goes to 0.  Teeth that
touch carry along with the lag T.  The relay switches at `on` and `off` but for exp(-s/T) of their
distance, s after the switch before: with T a hundredth of that, exactly.

Ports: u -> y, each of `signals` signals; those of backlash are of one unit.
Sources: Visintin 1994, Differential Models of Hysteresis, section III.2 (the play operator and its
regularization); Schmitt 1938, A thermionic trigger, Journal of Scientific Instruments 15.
"""

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import public
from ..engine.model.block import Block
from .part import each, positive, remembering, rising, signal_part, time_of


def gap_closed(t, x, u, p):
    """y' = dz(u - y)/T, of a gap w (Visintin 1994, section III.2, regularized play)."""
    off = u.u - x.y
    return (off - np.clip(off, -p.width / 2, p.width / 2)) / p.lag


def play(t, x, u, p):
    """y_k = min(max(y_{k-1}, u_k - w/2), u_k + w/2) (Visintin 1994, section III.2)."""
    return np.clip(x.last, u.u - p.width / 2, u.u + p.width / 2)


@public
def backlash(
    width: ArrayLike,
    *,
    lag: float | None = None,
    dt: float | None = None,
    signals: int = 1,
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
    positive(name, **each(name, signals, width=width))
    values = {"width": width, **time_of(name, lag, dt)}
    return remembering(name, ports, values, signals, gap_closed, play, dt)


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


@public
def relay(
    on: ArrayLike,
    off: ArrayLike,
    low: ArrayLike = -1.0,
    high: ArrayLike = 1.0,
    *,
    lag: float | None = None,
    dt: float | None = None,
    signals: int = 1,
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
        The two outputs.
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
    values = each(name, signals, off=off, on=on, low=low, high=high)
    rising(name, off=off, on=on)
    return signal_part(
        name,
        ports,
        {**values, **time_of(name, lag, dt)},
        signals,
        update=switched if lag is None else trigger,
        output=relayed,
        states={"closed": signals},
        dt=dt or 0,
    )
