"""Backlash and the relay, which remember where their input came from.

    backlash   y' = dz(u - y)/T,         dz(e) = e - min(max(e, -w/2), w/2)
    relay      T m' = sgn(m + v) - m,    y = high where m + v > 0, or low,
                                         v = -1 at off, 1 at on

No state jumps where a signal passes a value, so each is the published differential equation with a
time T, and is exact as T goes to 0.  Teeth that touch carry along with the lag T.  The relay
switches at `on` and `off` but for exp(-s/T) of their distance, s after the switch before: with T a
hundredth of that, exactly.

Ports: u -> y, each of `signals` signals; those of backlash are of one unit.
Sources: Visintin 1994, Differential Models of Hysteresis, section III.2 (the play operator and its
regularization); Schmitt 1938, A thermionic trigger, Journal of Scientific Instruments 15.
"""

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import public
from ..equations.block import Block
from .part import each, part, positive, rising, signal_part


def gap_closed(t, x, u, p):
    """y' = dz(u - y)/T, of a gap w (Visintin 1994, section III.2, regularized play)."""
    off = u.u - x.y
    return (off - np.clip(off, -p.width / 2, p.width / 2)) / p.lag


@public
def backlash(
    width: ArrayLike, *, lag: float, signals: int = 1, name: str = "backlash", **ports: str
) -> Block:
    """Follow a signal across a gap, as worn gears do.

    Parameters
    ----------
    width : float or array_like
        The whole gap, in the unit of u.
    lag : float
        How soon teeth that touch carry along; 0 would be the play itself.
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
        If a width or the lag is not positive.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> gears = clpt.parts.backlash(1.0, lag=0.01)
    >>> clpt.simulate(gears, range(4), [[0, 2, 1, 0]]).y.values.round(1).tolist()
    [0.0, 1.5, 1.5, 0.5]
    """
    values = each(name, signals, width=width) | {"lag": lag}
    positive(name, **values)
    return part(
        name, ports, values, update=gap_closed, inputs={"u": signals}, states={"y": signals}
    )


def closed_by(x, u, p):
    """Return m + v, which closes the relay where it is positive; v is -1 at off, 1 at on."""
    return x.closed + (2 * u.u - p.on - p.off) / (p.on - p.off)


def trigger(t, x, u, p):
    """T m' = sgn(m + v) - m (Schmitt 1938, section "trigger": feedback about a comparator)."""
    return (np.where(closed_by(x, u, p) > 0, 1.0, -1.0) - x.closed) / p.lag


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
    lag: float,
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
    lag : float
        How soon the comparator settles. It must be much shorter than the time between two switches.
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
        If `off` is not below `on`, or the lag is not positive.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> switch = clpt.parts.relay(on=1, off=-1, low=0, high=5, lag=0.01)
    >>> clpt.simulate(switch, range(6), [[-2, 0.5, 2, 0.5, -0.5, -2]]).y.values.tolist()
    [0.0, 0.0, 5.0, 5.0, 5.0, 0.0]
    """
    values = each(name, signals, off=off, on=on, low=low, high=high)
    rising(name, off=off, on=on)
    positive(name, lag=lag)
    values, states = {**values, "lag": lag}, {"closed": signals}
    return signal_part(name, ports, values, signals, update=trigger, output=relayed, states=states)
