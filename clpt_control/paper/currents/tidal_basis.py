"""Tides of a current as theta of Eq. (3), for the basis of a scenario.

UTide fits the tides (`utide.solve` of times, u, v and a latitude; D. L. Codiga, URI/GSO technical
report 2011-01).  A tide is an ellipse with axes L and l, inclination h and phase g:

    u + iv = a E + b conj(E),   E = f exp(i (V + n)),
    a = (L + l)/2 exp(i (h - g)),   b = (L - l)/2 exp(i (h + g))

The nodal factor f, the nodal angle n and the argument V are those of the epoch, t = 0 of the
scenario.  Choose an epoch in the middle of the run; M2 changes by 0.4 % in half a year.
A cosine has the phase 0 and a sine the phase -pi/2.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from ...base.arguments import brief, public
from ...base.errors import DataError, import_optional
from ...base.units import DAY, seconds_since_1970, speed_in_metres_per_second
from ..scenario.tidal_periods import SPEEDS

NAMES = {"NO1": "M1"}  # UTide's name and Schureman's, where they differ
DAYS_TO_1970 = 719163  # of the proleptic calendar whose first day is 0001-01-01
NODAL = ("nodsatlint", "nodsatnone", "gwchlint", "gwchnone")  # options of the fit


class TidalBasis(NamedTuple):
    """Functions of time and their theta, as `basis` of a scenario has them."""

    constituents: tuple[str, ...]  # steady, then each tide twice
    phases: tuple[float, ...]  # rad: 0 for cosines, -pi/2 for sines
    theta: np.ndarray  # east and north, in the unit that was asked for, shape (2, N)


@public
def tidal_basis(
    tides: Mapping[str, Any], epoch: Any, unit: str = "m s-1"
) -> TidalBasis:
    """Return tides that UTide fitted as theta of a scenario.

    Parameters
    ----------
    tides : mapping
        Result of ``utide.solve(time, u, v, lat=latitude, trend=False)``, u (east) and v (north)
        in m/s, times in UTC.
    epoch : str, datetime or datetime64
        t = 0 of the scenario, UTC.
    unit : str, optional
        Of theta: the scenario's length per time, such as "km h-1".

    Returns
    -------
    TidalBasis
        Constituents, phases and theta, shape (2, N).

    Raises
    ------
    DataError
        If the tides are of one component or have a trend, the epoch or the unit cannot be read,
        or a scenario has no such constituent.

    Examples
    --------
    >>> import utide
    >>> hours = np.arange(720)
    >>> time = np.datetime64("2019-01-01") + hours * np.timedelta64(1, "h")
    >>> wave = np.cos(np.radians(28.9841042) * hours)
    >>> fit = {"lat": 41.0, "constit": ["M2"], "trend": False, "verbose": False}
    >>> basis = tidal_basis(utide.solve(time, wave, 0.5 * wave, **fit), time[0])
    >>> basis.constituents, basis.theta.round(2) + 0.0
    (('steady', 'M2', 'M2'), array([[0. , 1. , 0. ],
           [0. , 0.5, 0. ]]))
    """
    try:
        axes = [np.asarray(tides[key]) for key in ("Lsmaj", "Lsmin", "theta", "g")]
    except KeyError:
        raise DataError(
            "tides: must be of two components, utide.solve(time, u, v, lat=latitude, trend=False)"
        ) from None
    if not tides["aux"]["opt"]["notrend"]:
        raise DataError(
            "tides: have a trend, and a scenario has none. Use utide.solve(..., trend=False)"
        )
    names = [NAMES.get(name, name) for name in map(str, tides["name"])]
    foreign = [name for name in names if name not in SPEEDS]
    if foreign:
        raise DataError(
            f"tides: have {', '.join(foreign)}; must be of {', '.join(SPEEDS)}"
        )
    major, minor, inclination, phase = axes
    h, g = np.radians(inclination), np.radians(phase)
    E = _waves(tides, epoch)
    a = (major + minor) / 2 * np.exp(1j * (h - g)) * E
    b = (major - minor) / 2 * np.exp(1j * (h + g)) * E.conj()
    columns = np.stack([a + b, 1j * (a - b)], axis=1).ravel()
    flow = np.append(tides["umean"] + 1j * tides["vmean"], columns)
    flow = flow / speed_in_metres_per_second(unit, "theta")
    return TidalBasis(
        ("steady", *(name for name in names for _ in range(2))),
        (0.0, *([0.0, -np.pi / 2] * len(names))),
        np.array([flow.real, flow.imag]),
    )


def _waves(tides: Mapping[str, Any], epoch: Any) -> np.ndarray:
    """Return E of each constituent at the epoch, by the options of the fit."""
    try:
        days = seconds_since_1970(str(epoch)) / DAY + DAYS_TO_1970
    except ValueError:
        raise DataError(
            f"epoch = {brief(epoch)}: must be such as 2019-01-01T06:00"
        ) from None
    aux = tides["aux"]
    options = [aux["opt"][name] for name in NODAL]
    wave = import_optional("utide.harmonics").ut_E
    times = np.array([days])
    given = [aux[name] for name in ("reftime", "frq", "lind", "lat")]
    return wave(times, *given, options, None)[0]
