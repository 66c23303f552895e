"""Columns of a vehicle's log, in tables and in lines of JSON.

`latitude`, `longitude` (degrees) are a fix; `course` (degrees from true north) and `speed` (m/s)
are the motion through the water until the next row, `dr_east_m` and `dr_north_m` its displacement
since the row before (m).
"""

from math import cos, isfinite, radians, sin

from ...base.errors import DataError

PLACE = ("latitude", "longitude")
STEERING = ("course", "speed")
STRETCH = ("dr_east_m", "dr_north_m")
COURSES = -180.0, 540.0  # degrees


def velocity_of(course: float, speed: float, where: str) -> tuple[float, float]:
    """Return the velocity to the east and to the north, m/s; NaN if it is not known.

    >>> velocity_of(90.0, 1.0, "line 2")[0]
    1.0
    """
    low, high = COURSES
    if isfinite(course) and not low <= course <= high:
        raise DataError(
            f"{where}: course is {course:g}; must be {low:g} to {high:g} degrees"
        )
    if speed < 0:
        raise DataError(f"{where}: speed is {speed:g}; must be 0 or more, m/s")
    if speed == 0:
        return 0.0, 0.0
    return speed * sin(radians(course)), speed * cos(radians(course))
