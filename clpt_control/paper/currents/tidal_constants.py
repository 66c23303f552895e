"""Tidal constants of one place: what `fit_tides` returns, as JSON and as theta.

As theta of Eq. (3), for the basis of a scenario, they are

    f A cos(V(t) + u - g) = c cos(w (t - t0)) + s sin(w (t - t0))
    c = f A cos(p),  s = -f A sin(p),  p = V(t0) + u(t0) - g

f and u are those of the epoch t0, which becomes t = 0 of the scenario: choose it
in the middle of what is to be run; M2 changes by 0.4 % in half a year.  A
scenario's sine is the phase -pi/2.
"""

from typing import Any, NamedTuple

import numpy as np

from ...base.arguments import public
from ...base.errors import DataError
from ...base.units import finite_or_none, speed_in_metres_per_second
from ..scenario.tidal_periods import SPEEDS
from .constituents import checked_times, nodal_corrections
from .tidal_fit import NUMBERS, TidalFit


def tides_report(fit: TidalFit) -> dict[str, Any]:
    """Return a fit as one JSON object, numbers that are not finite as None.

    Amplitudes are in m/s, phases in degrees of Greenwich lag, times in UTC; f, u and V at the
    record's middle stand under "nodal".
    """
    names = [constituent.name for constituent in fit.constituents]
    corrections = nodal_corrections(names, [fit.middle], fit.latitude)
    return {
        "start": str(fit.start),
        "end": str(fit.end),
        "hours": fit.hours,
        "samples": fit.samples,
        "latitude": fit.latitude,
        "constituents": {
            constituent.name: {
                **{key: finite_or_none(getattr(constituent, key)) for key in NUMBERS},
                "standard_errors": {
                    key: finite_or_none(constituent.errors[key]) for key in NUMBERS
                },
            }
            for constituent in fit.constituents
        },
        "mean": list(fit.mean),
        "explained_variance": fit.explained_variance,
        "residual_rms": fit.residual_rms,
        "speed_units": "m s-1",
        "phase_units": "degree",
        "nodal_time": str(fit.middle),
        "nodal": {
            name: {
                key: float(correction[0, k])
                for key, correction in zip("fuV", corrections, strict=True)
            }
            for k, name in enumerate(names)
        },
    }


class TidalBasis(NamedTuple):
    """Functions of time and their theta, as `basis` of a scenario has them."""

    constituents: tuple[str, ...]  # steady, then each tide twice
    phases: tuple[float, ...]  # rad: 0 for cosines, -pi/2 for sines
    theta: np.ndarray  # east and north, in the unit that was asked for, shape (2, N)


@public
def tidal_basis(fit: TidalFit, epoch: Any, unit: str = "m s-1") -> TidalBasis:
    """Return a fit as theta of a scenario that starts at an epoch.

    Parameters
    ----------
    fit : TidalFit
        From `fit_tides`.
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
    >>> from clpt_control.paper.currents.tidal_fit import fit_tides
    >>> time = np.datetime64("2019-01-01") + np.arange(72) * np.timedelta64(1, "h")
    >>> wave = np.cos(np.radians(28.9841042) * np.arange(72))
    >>> basis = tidal_basis(fit_tides(time, wave, 0.5 * wave, 41.0, ["M2"]), time[0])
    >>> basis.constituents
    ('steady', 'M2', 'M2')
    >>> bool(abs(basis.theta - [[0, 1, 0], [0, 0.5, 0]]).max() < 1e-3)
    True
    """
    names = [constituent.name for constituent in fit.constituents]
    foreign = [name for name in names if name not in SPEEDS]
    if foreign:
        raise DataError(
            f"{', '.join(foreign)}: a scenario has only {', '.join(SPEEDS)}"
        )
    size = 1.0 / speed_in_metres_per_second(unit, "theta")
    f, u, V = nodal_corrections(names, checked_times(epoch)[:1], fit.latitude)
    columns = [np.array(fit.mean)]
    for k, constituent in enumerate(fit.constituents):
        p = np.radians(
            V[0, k]
            + u[0, k]
            - np.array([constituent.east_phase, constituent.north_phase])
        )
        A = f[0, k] * np.array([constituent.east, constituent.north])
        columns += [A * np.cos(p), -A * np.sin(p)]
    return TidalBasis(
        ("steady", *(name for name in names for _ in range(2))),
        (0.0, *([0.0, -np.pi / 2] * len(names))),
        size * np.column_stack(columns),
    )
