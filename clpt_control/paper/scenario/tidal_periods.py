"""Named tidal constituents and their periods.

Angular speeds in degrees per mean solar hour, as tabulated in P. Schureman,
"Manual of Harmonic Analysis and Prediction of Tides", US Coast and Geodetic
Survey Special Publication 98 (1958), table 2.
"""

import math

from ...base.arguments import public
from ...base.errors import ScenarioError
from ...base.units import SECONDS

SPEEDS = {
    "M2": 28.9841042,
    "S2": 30.0000000,
    "N2": 28.4397295,
    "K2": 30.0821373,
    "2N2": 27.8953548,
    "MU2": 27.9682084,
    "NU2": 28.5125831,
    "L2": 29.5284789,
    "T2": 29.9589333,
    "K1": 15.0410686,
    "O1": 13.9430356,
    "P1": 14.9589314,
    "Q1": 13.3986609,
    "J1": 15.5854433,
    "OO1": 16.1391017,
    "S1": 15.0000000,
    "M1": 14.4966939,
    "MF": 1.0980331,
    "MM": 0.5443747,
    "SSA": 0.0821373,
    "SA": 0.0410686,
    "M3": 43.4761563,
    "M4": 57.9682084,
    "MS4": 58.9841042,
    "MN4": 57.4238337,
    "M6": 86.9523127,
    "M8": 115.9364166,
    "S4": 60.0000000,
}


@public
def period(constituent: str, unit: str = "h") -> float:
    """Return the period of a named tidal constituent.

    >>> round(period("M2"), 2)
    12.42
    """
    angular_speed = speed(constituent)
    if unit not in SECONDS:
        raise ScenarioError(f"unit = '{unit}': must be one of {', '.join(SECONDS)}")
    return 360.0 / angular_speed * 3600.0 / SECONDS[unit] if angular_speed else math.inf


def speed(constituent: str) -> float:
    """Return the angular speed of a named constituent, degrees per hour; 0 for ``"steady"``."""
    if constituent == "steady":
        return 0.0
    if constituent not in SPEEDS:
        raise ScenarioError(
            f"unknown constituent '{constituent}': must be steady or one of {', '.join(SPEEDS)}"
        )
    return SPEEDS[constituent]
