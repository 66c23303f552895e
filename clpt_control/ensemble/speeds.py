"""How much of each member's run its vehicle was at its speed limit, or in a faster flow.

As in a run (`simulation.speeds`), at the samples of the members.
"""

from collections.abc import Mapping

import numpy as np

from ..simulation.speeds import SpeedWatch
from .members import Ensemble, Members, States

SPEEDS = {  # name -> (long name, whether it is a time)
    "share_at_speed_limit": ("share of time at the speed limit", False),
    "share_in_faster_flow": ("share of time in a flow faster than the vehicle", False),
    "longest_in_faster_flow": ("longest stretch in a flow faster than the vehicle", True),
}


def speeds_of_members(
    ensemble: Ensemble,
    members: Members,
    run: States,
    times: np.ndarray,
    values: Mapping[str, np.ndarray],
) -> dict[str, np.ndarray]:
    """Return `SPEEDS` of members, up to the last sample that each reached; NaN before the first."""
    found = np.full((len(run.states), len(SPEEDS)), np.nan)
    limits = values.get("vehicle.max_speed")
    for m, row in enumerate(found):
        reached = int(run.reached[m])
        if reached < 2:
            continue
        own = ensemble.scenario.vehicle.max_speed if limits is None else limits[m]
        watch = SpeedWatch(float(own))  # type: ignore[arg-type]
        commanded, flow = ensemble.signals(members, run, m, times, ("v_c", "flow_x"))
        watch.add(times[:reached], commanded, flow)
        figures = watch.figures()
        faster = figures["faster_flow"] or {"share": 0.0, "longest": 0.0}
        row[:] = figures["share_at_limit"], faster["share"], faster["longest"]
    return dict(zip(SPEEDS, found.T.copy(), strict=True))
