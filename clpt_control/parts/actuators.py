"""Actuators: limits and gaps, what remembers where it came from, lags, delays and holds.

    saturation     y = min(max(u, low), high)
    dead zone      y = u - min(max(u, low), high)
    lookup table   y = Y_k + (u - X_k) (Y_{k+1} - Y_k)/(X_{k+1} - X_k),   X_k <= u <= X_{k+1}
    rate limit     y' = min(max((u - y)/T, -fall), rise)
                   y_k = y_{k-1} + min(max(u_k - y_{k-1}, -fall dt), rise dt)

Sampled (`dt`) the rate limit is exact.  In continuous time its rate would switch at u = y without
end; T is the lag of the actuator that is limited, and the limit itself as T goes to 0.

Ports: u -> y, each of `signals` signals, of one unit but of the table, the relay and the lag.
Sources: Astrom and Murray 2008, Feedback Systems, section 10.4; Rundqwist and Hillgren 1996, Phase
compensation of rate limiters in JAS 39 Gripen.

Backlash and the relay remember where their input came from:

    backlash   y' = dz(u - y)/T,             dz(e) = e - min(max(e, -w/2), w/2)
               y_k = min(max(y_{k-1}, u_k - w/2), u_k + w/2)
    relay      T m' = sgn(m + v) - m,        y = high where m + v > 0, or low
               m_k = sgn(m_{k-1} + v_k),     v = -1 at off, 1 at on

Sampled (`dt`) both are exact.  In continuous time no state jumps where a signal passes a value, so
each is the published differential equation with a time T, and is exact as T goes to 0.  Teeth that
touch carry along with the lag T.  The relay switches at `on` and `off` but for exp(-s/T) of their
distance, s after the switch before: with T a hundredth of that, exactly.

Sources: Visintin 1994, Differential Models of Hysteresis, section III.2 (the play operator and its
regularization); Schmitt 1938, A thermionic trigger, Journal of Scientific Instruments 15.

Lags and delays, and the sampler with its hold:

    lag             T y' = K u - y
    delay           y(t) = u(t - T):  T x_i' = (2 i + 1) (s_i u + sum_j a_ij x_j),  y = sum_i x_i,
                    s_i = (-1)^i,  a_ij = -1 (i < j) or (-1)^{i - j + 1};  i, j = 0 ... n - 1
    delay, sampled  y_k = u_{k - n},  n = T / dt
    hold            y = u(k dt) for k dt <= t < (k + 1) dt

The continuous delay is the Pade approximant of exp(-s T) whose numerator has one degree less than
its denominator, on Legendre polynomials of the last T of u: well scaled at any order, and without
the jump of -u or u at once that equal degrees make.  It is exp(-s T) up to about n radians of
omega T.  The sampled delay is exact.

Sources: Astrom and Murray 2008, Feedback Systems, section 5.3; Voelker, Kajic and Eliasmith 2019,
Legendre Memory Units, Eqs. (1) to (3), NeurIPS 32 (delay); Franklin, Powell and Workman 1998,
Digital Control of Dynamic Systems (hold).
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import numbers, public, shown
from ..equations.block import Block
from ..errors import BlockError
from .part import each, part, positive, remembering, rising, time_of


def limited(t, x, u, p):
    """y = min(max(u, low), high) (Astrom and Murray 2008, section 10.4)."""
    return np.clip(u.u, p.low, p.high)


@public
def saturation(
    low: ArrayLike,
    high: ArrayLike,
    signals: int = 1,
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
    limits = each(name, signals, low=low, high=high)
    rising(name, **limits)
    return _static(name, limited, signals, ports, **limits)


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
    return _static(name, beyond, signals, ports, **limits)


def _static(
    name: str, output: Any, signals: int, ports: dict[str, str], **parameters: Any
) -> Block:
    own = {"inputs": {"u": signals}, "outputs": {"y": signals}}
    return part(name, ports, parameters, output=output, **own)


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
    where = numbers(f"{name}: at", at)
    if where.ndim != 1 or len(where) < 2 or not np.all(np.diff(where) > 0):
        raise BlockError(f"{name}: at = {shown(at)}: must be two or more increasing numbers")
    if numbers(f"{name}: values", values).shape != where.shape:
        raise BlockError(f"{name}: values = {shown(values)}: must be {len(where)} numbers")
    return _static(name, looked_up, signals, ports, at=at, values=values)


def limited_rate(t, x, u, p):
    """y' = min(max((u - y)/T, -fall), rise) (Rundqwist 1996, section "rate limiters")."""
    return np.clip((u.u - x.y) / p.lag, -p.fall, p.rise)


def limited_step(t, x, u, p):
    """y_k = y_{k-1} + what is left, within the limits (Rundqwist 1996, section "rate limiters")."""
    return x.last + np.clip(u.u - x.last, -p.fall * p.dt, p.rise * p.dt)


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
    return remembering(name, limited_rate, limited_step, signals, ports, lag, dt, **rates)


# --- hysteresis --------------------------------------------------------------------------------


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
    return remembering(name, gap_closed, play, signals, ports, lag, dt, width=width)


def closed_by(x, u, p):
    """Return m + v, which closes the relay where it is positive; v is -1 at off, 1 at on."""
    return x.closed + (2 * u.u - p.on - p.off) / (p.on - p.off)


def trigger(t, x, u, p):
    """T m' = sgn(m + v) - m (Schmitt 1938, section "trigger": feedback about a comparator)."""
    return (np.where(closed_by(x, u, p) > 0, 1.0, -1.0) - x.closed) / p.lag


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
    given = each(name, signals, off=off, on=on, low=low, high=high)
    rising(name, off=off, on=on)
    return part(
        name,
        ports,
        {**given, **time_of(name, lag, dt)},
        update=switched if lag is None else trigger,
        output=relayed,
        inputs={"u": signals},
        outputs={"y": signals},
        states={"closed": signals},
        dt=dt or 0,
    )


# --- lags and delays ---------------------------------------------------------------------------


def lagging(t, x, u, p):
    """T y' = K u - y (Astrom and Murray 2008, section 5.3)."""
    return (p.gain * u.u - x.y) / p.lag


@public
def lag(
    lag: ArrayLike, gain: ArrayLike = 1.0, signals: int = 1, name: str = "lag", **ports: str
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
    given = each(name, signals, lag=lag, gain=gain)
    positive(name, lag=lag)
    return part(name, ports, given, update=lagging, inputs={"u": signals}, states={"y": signals})


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
    order: int = 4,
    *,
    dt: float | None = None,
    signals: int = 1,
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
    positive(name, delay=delay, order=order)
    own: dict[str, Any] = {"inputs": {"u": signals}, "outputs": {"y": signals}}
    if dt is not None:
        positive(name, dt=dt)
        count = round(delay / dt)
        if count < 1 or abs(count * dt - delay) > 1e-9 * delay:
            raise BlockError(f"{name}: delay = {delay}: must be a multiple of dt = {dt}")
        own |= {"states": {"line": (count, signals)}, "dt": dt}
        return part(name, ports, {}, update=shifted, output=last_of_line, **own)
    i = np.arange(order)
    weight, sign = 2.0 * i + 1, (-1.0) ** i
    A = weight[:, None] * np.where(i[:, None] < i, -1.0, -np.outer(sign, sign))
    given = {"delay": delay, "A": A, "B": weight * sign, "C": np.ones(order)}
    own["states"] = {"past": (order, signals)}
    return part(name, ports, given, update=legendre_rate, output=oldest, **own)


def as_sampled(t, x, u, p):
    """y = u, of a sample (Franklin, Powell and Workman 1998, section "hold")."""
    return u.u


@public
def hold(dt: float, signals: int = 1, name: str = "hold", **ports: str) -> Block:
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
    positive(name, dt=dt)
    own = {"inputs": {"u": signals}, "outputs": {"y": signals}, "dt": dt}
    return part(name, ports, {}, output=as_sampled, **own)
