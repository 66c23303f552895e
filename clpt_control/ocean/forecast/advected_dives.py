"""The displacement of a glider by a modelled flow during a dive.

Dead reckoning carried by a flow model F is

    dz/dt = v_dr(t) + F(z, t),    z(GPS2) = the fix,

Eq. (10)'s z between two fixes; what F adds to the dead reckoning,

    q(T) = int_0^T F(z(t), t) dt,    dq/dt = F(z_dr(t) + q, t),  q(0) = 0,

is the model's forecast of the miss, m east and north.  z_dr is the dive's
track, or a straight line at constant speed where it has none.  Places are in the
plane about GPS2 (`LocalPlane`), times in s since GPS2.  Integration: Dormand
and Prince, order 5(4) (`scipy.integrate.solve_ivp`), to 1e-8 or 1 mm per step,
steps of a quarter of an hour at most.

Of the dive, the fix GPS2, the times and the dead reckoning are used and never
the fix after it: the forecast is one.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import replace
from math import isfinite

import numpy as np
from scipy.integrate import solve_ivp

from ...base.arguments import public
from ...base.errors import ClptError
from ..gliders.dives import Dive, reckoned

Flow = Callable[[float, float, float], tuple[float, float]]
LONGEST_STEP = 900.0  # s; a glider crosses no cell of a forecast in less
RELATIVE, ABSOLUTE = 1e-8, 1e-3  # error of a step: share of q, and m


class Uncovered(ClptError):
    """A flow model says nothing here or now; the message is why."""


class FlowModel(ABC):
    """A flow that was modelled elsewhere, to carry dead reckoning."""

    source: str  # the name of its file
    about: str  # what it is, in a few words

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.source}: {self.about}>"

    @abstractmethod
    def along(self, dive: Dive) -> Flow:
        """Return the flow for one dive, whose end fix is not read.

        (s since GPS2, m east, m north of it) -> flow east and north, m/s; `Uncovered` is
        raised where the model says nothing.
        """


def flow_displacement(dive: Dive, flow: Flow) -> tuple[float, float]:
    """Integrate a flow along a dive's dead reckoning: q(T), m east and north.

    `Uncovered` is raised where the flow says nothing on the track.
    """
    T = dive.duration
    time, east, north = reckoned(dive)
    if not (
        isfinite(T) and T > 0 and all(np.isfinite(a).all() for a in (time, east, north))
    ):
        raise Uncovered(
            "the dive's times and dead reckoning are not finite and in their order"
        )

    def rate(t: float, q: np.ndarray) -> tuple[float, float]:
        u, v = flow(
            t, np.interp(t, time, east) + q[0], np.interp(t, time, north) + q[1]
        )
        if not (isfinite(u) and isfinite(v)):
            raise Uncovered(f"its flow is not finite {t / 3600:.2g} h into the dive")
        return u, v

    solution = solve_ivp(
        rate, (0.0, T), np.zeros(2), rtol=RELATIVE, atol=ABSOLUTE, max_step=LONGEST_STEP
    )
    if not solution.success:  # pragma: no cover - only a flow that jumps endlessly
        raise Uncovered(f"the dive cannot be integrated: {solution.message}")
    return float(solution.y[0, -1]), float(solution.y[1, -1])


@public
def carried(dive: Dive, flow_model: FlowModel) -> Dive:
    """Return a dive with its displacement by a flow model.

    >>> import clpt_control as clpt
    >>> from clpt_control.ocean.forecast.flow_models import FlowModel
    >>> class Stream(FlowModel):
    ...     source, about = "none", "0.1 m/s to the east"
    ...
    ...     def along(self, dive):
    ...         return lambda t, east, north: (0.1, 0.0)
    >>> fixes = (0.0, 40.0, 8.0), (9000.0, 40.0, 8.02)
    >>> dive = clpt.gliders.make_dive(1, *fixes, (500.0, 0.0))
    >>> round(carried(dive, Stream()).model_east, 6)
    900.0
    """
    try:
        east, north = flow_displacement(dive, flow_model.along(dive))
    except Uncovered as why:
        return replace(dive, model_east=None, model_north=None, uncovered=str(why))
    return replace(dive, model_east=east, model_north=north, uncovered=None)
