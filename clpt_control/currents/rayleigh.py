"""Which tides a record is long enough to tell apart: the Rayleigh criterion.

    |w_a - w_b| T >= 360 degrees

w in degrees per hour, T in hours from the first measurement to the last: over
T the two must drift apart by one turn or more (M. G. G. Foreman, "Manual for
tidal heights analysis and prediction", Pacific Marine Science Report 77-10,
1977).  Below that, least squares still gives numbers, but the two amplitudes
trade against each other.  "steady" is the speed 0: a tide beside a mean needs
one full period.
"""

import math
from collections.abc import Mapping, Sequence
from itertools import combinations

from ..arguments import check_holds, public
from ..errors import DataError
from ..scenario import tides

TURN = 360.0 * (1 - 1e-9)  # times in files are rounded


def inseparable(
    names: Sequence[str], hours: float, speeds: Mapping[str, float] | None = None
) -> list[tuple[str, str, float]]:
    """Return the pairs that a record of some hours cannot tell apart, and the hours they need.

    The longest comes first; `speeds` are degrees per hour, those of `tides` by default.

    >>> inseparable(["steady", "M2", "S2"], 24.0)
    [('M2', 'S2', 354.367...)]
    >>> inseparable(["steady", "M2"], 24.0)
    []
    """
    each = {name: tides.speed(name) if speeds is None else speeds[name] for name in names}
    apart = [(a, b, abs(each[a] - each[b])) for a, b in combinations(names, 2)]
    pairs = [
        (a, b, 360.0 / difference if difference else math.inf)
        for a, b, difference in apart
        if not difference * hours >= TURN
    ]
    return sorted(pairs, key=lambda pair: -pair[2])


@public
def check_separable(
    names: Sequence[str], hours: float, where: str, speeds: Mapping[str, float] | None = None
) -> None:
    """Refuse tides that a record is too short to tell apart.

    Parameters
    ----------
    names : sequence of str
        Names of `tides.SPEEDS`, and "steady", each once.
    hours : float
        From the first measurement to the last, h.
    where : str
        The record, for the message.
    speeds : mapping of str to float, optional
        Degrees per hour of each name; those of `tides` by default.

    Raises
    ------
    DataError
        If there are such pairs; all are named, with the hours they need.
    ScenarioError
        If a name is unknown.

    Examples
    --------
    >>> check_separable(["steady", "M2", "S2"], 360.0, "currents.nc")
    >>> check_separable(["M2", "S2"], 24.0, "currents.nc")
    Traceback (most recent call last):
        ...
    clpt_control.errors.DataError: currents.nc: in 24 h, M2 and S2 cannot be told apart: 354.4 h
    are needed; leave one of them out or take a longer record
    """
    if speeds is not None:
        check_holds("check_separable: speeds", speeds, names, "give degrees per hour of each name")
    pairs = inseparable(names, hours, speeds)
    if not pairs:
        return
    if len(pairs) == 1:
        a, b, needed = pairs[0]
        said = f"{a} and {b} cannot be told apart: {_shown(needed)} are needed"
        which = "them"
    else:
        listed = ", ".join(f"{a} and {b} ({_shown(needed)})" for a, b, needed in pairs)
        said = f"these pairs cannot be told apart (hours needed): {listed}"
        which = "each pair"
    raise DataError(
        f"{where}: in {hours:.6g} h, {said}; leave one of {which} out or take a longer record"
    )


def _shown(hours: float) -> str:
    """Return hours to four digits, rounded up, so that the number suffices."""
    if math.isinf(hours):
        return "endless h"
    unit = 10.0 ** max(math.floor(math.log10(hours)) - 3, -6)
    return f"{math.ceil(hours / unit - 1e-9) * unit:.10g} h"
