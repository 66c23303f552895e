"""Tides of a current as theta of Eq. (3), for the basis of a scenario.

UTide fits them (`utide.solve` of times, u, v and a latitude; D. L. Codiga, URI/GSO technical report
2011-01).  A tide is an ellipse with axes L and l, inclination h and phase g:

    u + iv = f (a exp(i (V + n)) + b exp(-i (V + n))),   a = (L + l)/2 exp(i (h - g))
                                                          b = (L - l)/2 exp(i (h + g))

The nodal factor f and angle n and the argument V are those of the epoch, t = 0 of the scenario:
choose it in the middle of what is to be run; M2 changes by 0.4 % in half a year.  A scenario's sine
is the phase -pi/2.
"""

from typing import Any, NamedTuple

import numpy as np

from ...base.arguments import public
from ...base.errors import DataError, import_optional
from ...base.units import speed_in_metres_per_second
from ..scenario.tidal_periods import SPEEDS

NAMES = {"NO1": "M1"}  # UTide's name and Schureman's, where they differ
DAYS_TO_1970 = 719163  # of the proleptic calendar whose first day is 0001-01-01


class TidalBasis(NamedTuple):
    """Functions of time and their theta, as `basis` of a scenario has them."""

    constituents: tuple[str, ...]  # steady, then each tide twice
    phases: tuple[float, ...]  # rad: 0 for cosines, -pi/2 for sines
    theta: np.ndarray  # east and north, in the unit that was asked for, shape (2, N)


@public
def tidal_basis(tides: Any, epoch: Any, unit: str = "m s-1") -> TidalBasis:
    """Return the tides that UTide has fitted as theta of a scenario.

    Parameters
    ----------
    tides : Bunch
        What ``utide.solve(time, u, v, lat=latitude)`` returns, u and v in m/s.
    epoch : str or datetime64
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
        If the epoch or the unit cannot be read, or a scenario knows no such constituent.

    Examples
    --------
    >>> import utide
    >>> time = np.datetime64("2019-01-01") + np.arange(720) * np.timedelta64(1, "h")
    >>> wave = np.cos(np.radians(28.9841042) * np.arange(720))
    >>> tides = utide.solve(time, wave, 0.5 * wave, lat=41.0, constit=["M2"], verbose=False)
    >>> tidal_basis(tides, time[0]).theta.round(2) + 0
    array([[ 0. ,  1. ,  0. ],
           [ 0. ,  0.5,  0. ]])
    """
    names = [NAMES.get(name, name) for name in map(str, tides.name)]
    foreign = [name for name in names if name not in SPEEDS]
    if foreign:
        raise DataError(
            f"{', '.join(foreign)}: a scenario has only {', '.join(SPEEDS)}"
        )
    try:
        days = np.datetime64(epoch, "ms").astype(float) / 86400e3 + DAYS_TO_1970
    except (ValueError, TypeError):
        raise DataError(f"epoch = {epoch}: must be such as 2019-01-01T06:00") from None
    utide = import_optional("utide")
    indices = np.array([utide.constit_index_dict[str(name)] for name in tides.name])
    exact = [False] * 4  # nodal corrections and arguments at the epoch, none linearized
    f, n, V = (
        row[0]
        for row in utide.harmonics.FUV(
            np.array([days]), days, indices, tides.aux.lat, exact
        )
    )
    h, g = np.radians(tides.theta), np.radians(tides.g)
    turn = 2j * np.pi * (V + n)
    a = f * (tides.Lsmaj + tides.Lsmin) / 2 * np.exp(1j * (h - g) + turn)
    b = f * (tides.Lsmaj - tides.Lsmin) / 2 * np.exp(1j * (h + g) - turn)
    columns = np.stack([a + b, 1j * (a - b)], axis=1).ravel()
    flow = np.append(tides.umean + 1j * tides.vmean, columns)
    flow = flow / speed_in_metres_per_second(unit, "theta")
    return TidalBasis(
        ("steady", *(name for name in names for _ in range(2))),
        (0.0, *([0.0, -np.pi / 2] * len(names))),
        np.array([flow.real, flow.imag]),
    )
