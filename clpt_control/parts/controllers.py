"""The PID controller, limited, with anti-windup: continuous and sampled.

    v = Kp (r - y) + I + D,                     u = min(max(v, low), high)
    I' = Ki (r - y) + |Ki/Ki0| (u - v)/Tt       D = -Kd (y - yf)/Tf,   Tf yf' = y - yf
    sampled, h = dt                    D_k = (Tf D_{k-1} - Kd (y_k - y_{k-1}))/(Tf + h)
    I_{k+1} = I_k + h (Ki (r_k - y_k) + |Ki/Ki0| (u_k - v_k)/Tt)

The derivative is of y alone, filtered with the time Tf; where u is limited the integral follows
with the time Tt (back-calculation), and does not wind up.  Ki0 is the gain that the block is made
with: a call-time Ki of 0 leaves I at rest.  Without Ki0 there is no I, without Kd no D.

Ports: r, y (of one unit) -> u, each of `signals` signals; Kp is u by y, Ki that per time, Kd that
times time.
Source: Astrom and Murray 2008, Feedback Systems, sections 10.4 and 10.5.
"""

from functools import partial

import numpy as np

from ..base.arguments import Count, brief, public
from ..base.errors import BlockError
from ..engine.diagram.block_numbers import PARAMETER_HINTS
from ..engine.model.block import Block
from .common import (
    check_finite,
    check_positive,
    make_block,
    ordered,
    positive,
    with_constants,
)


def derivative(x, u, p, dt):
    """Return D = -Kd (y - yf)/Tf; sampled, D_k = (Tf D_{k-1} - Kd (y_k - y_{k-1}))/(Tf + h)."""
    if hasattr(x, "last"):
        return (p.filter * x.derivative - p.kd * (u.y - x.last)) / (p.filter + dt)
    return -p.kd * (u.y - x.filtered) / p.filter if hasattr(x, "filtered") else 0.0


def unlimited(x, u, p, dt):
    """Return v = Kp (r - y) + I + D."""
    integral = getattr(x, "integral", 0.0)
    return p.kp * (u.r - u.y) + integral + derivative(x, u, p, dt)


def integral_rate(x, u, p, dt, ki):
    """Return I' = Ki (r - y) + |Ki/Ki0| (u - v)/Tt."""
    v = unlimited(x, u, p, dt)
    limited = np.clip(v, p.low, p.high)
    return p.ki * (u.r - u.y) + np.abs(p.ki / ki) * (limited - v) / p.tracking


def rates(t, x, u, p, dt, ki):
    """I' = Ki (r - y) + |Ki/Ki0| (u - v)/Tt, Tf yf' = y - yf (Astrom and Murray 2008, 10.4)."""
    moved = {"integral": integral_rate(x, u, p, dt, ki)} if ki else {}
    if hasattr(x, "filtered"):
        moved["filtered"] = (u.y - x.filtered) / p.filter
    return moved


def next_states(t, x, u, p, dt, ki):
    """I_{k+1} = I_k + h I', D_k, y_k (Astrom and Murray 2008, section 10.5)."""
    moved = {"integral": x.integral + dt * integral_rate(x, u, p, dt, ki)} if ki else {}
    if hasattr(x, "last"):
        moved |= {"derivative": derivative(x, u, p, dt), "last": u.y}
    return moved


def command(t, x, u, p, dt):
    """u = min(max(v, low), high) (Astrom and Murray 2008, sections 10.4 and 10.5)."""
    return np.clip(unlimited(x, u, p, dt), p.low, p.high)


def gain_hint(key: str, parameters: set[str]) -> str:
    """Return a hint on a gain of 0, which is no parameter of its controller, or ""."""
    gain = key[-2:]
    if gain not in ("ki", "kd") or f"{key[:-2]}kp" not in parameters:
        return ""
    return (
        f"{key}: a gain of 0 is no parameter. Give {gain} in parts.pid(..., {gain}=...)"
    )


PARAMETER_HINTS.append(gain_hint)


def check_tracking(dt, name, values):
    """Refuse a time in which the integral of a sampled controller would not settle."""
    tracking = values.get("tracking", np.inf)
    if not np.all(np.greater(tracking, dt / 2)):
        raise BlockError(
            f"{name}: tracking = {brief(tracking)}: must be above half of dt = {dt:g}"
        )


@public
def pid(
    kp: float,
    ki: float = 0.0,
    kd: float = 0.0,
    *,
    low: float = -np.inf,
    high: float = np.inf,
    filter: float | None = None,
    tracking: float | None = None,
    dt: float | None = None,
    signals: Count = 1,
    name: str = "pid",
    **ports: str,
) -> Block:
    """Make a PID controller with limits and anti-windup.

    Continuous: v = Kp (r - y) + I + D, u = min(max(v, low), high), I' = Ki (r - y) + (u - v)/Tt,
    D = -Kd (y - yf)/Tf, Tf yf' = y - yf. Sampled, h = dt: D_k = (Tf D_{k-1} - Kd (y_k - y_{k-1}))
    / (Tf + h), I_{k+1} = I_k + h (Ki (r_k - y_k) + (u_k - v_k)/Tt).

    A gain of 0 has no state and no parameter: to vary it, make the block with another value. At
    a call-time ki, (u - v)/Tt is multiplied by its share of the first ki.

    States start at 0. Where y starts elsewhere and kd is given, its value belongs in
    `initial_state`, as the state ``filtered``, yf, or ``last``, y_{k-1}, of a sampled one.

    Parameters
    ----------
    kp, ki, kd : float
        Gains of the error, its integral and its derivative.
    low, high : float, optional
        Limits of u.
    filter : float, optional
        The time Tf of the derivative's filter; ``|kd / (10 kp)|`` by default, and 1 without
        kd.
    tracking : float, optional
        The time Tt in which the integral follows a limited u; ``sqrt(|kd / ki|)`` by default,
        ``|kp / ki|`` without kd, and no less than `dt`.
    dt : float, optional
        Sampled at each multiple of dt; without, of continuous time.
    signals : int, optional
        Number of signals.
    name : str, optional
        Name of the block.
    **ports : str
        A port under another name, ``r="wanted", y="level", u="valve"``.

    Returns
    -------
    Block
        With ports r and y, and u.

    Raises
    ------
    BlockError
        If the limits or times are none.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> tank = clpt.parts.lag(10.0, gain=4.0)
    >>> loop = clpt.connect([clpt.parts.pid(1, 0.1, low=0, high=0.5), tank], external="r")
    >>> clpt.simulate(loop, [0, 5, 100], 1.0).y.values.round(3).tolist()
    [0.0, 0.772, 1.0]
    """
    if filter is None:
        filter = abs(kd / (10 * kp)) if kp and kd else 1.0
    if tracking is None:
        follows = (
            np.inf if not ki else np.sqrt(abs(kd / ki)) if kd else abs(kp / ki) or 1.0
        )
        tracking = max(follows, dt or 0.0)
    check_finite(name, {"kp": kp, "ki": ki, "kd": kd})
    check_positive(name, filter=filter, tracking=tracking, dt=1.0 if dt is None else dt)
    rules = (
        ordered("low", "high"),
        positive("filter", "tracking"),
        partial(check_tracking, dt or 0.0),
    )
    check_tracking(dt or 0.0, name, {"tracking": tracking})
    values, states = {"kp": kp, "low": low, "high": high}, []
    if ki:
        values |= {"ki": ki, "tracking": tracking}
        states += ["integral"]
    if kd:
        values |= {"kd": kd, "filter": filter}
        states += ["filtered"] if dt is None else ["derivative", "last"]
    update = with_constants(rates if dt is None else next_states, dt=dt, ki=ki)
    return make_block(
        name,
        ports,
        values,
        rules,
        update=update if states else None,
        output=with_constants(command, dt=dt),
        inputs={"r": signals, "y": signals},
        outputs={"u": signals},
        states=dict.fromkeys(states, signals),
        dt=dt or 0,
    )
