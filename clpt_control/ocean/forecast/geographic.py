"""Places, directions and times, as rows have them and as they are written.

A place is written in decimal degrees, and in degrees and minutes of two decimals (18 m).  The
last decimals of minutes are counted as whole numbers, so that 59.999 carries to the next degree.
A direction is where something goes to, clockwise from true north, [0, 360).
"""

from datetime import UTC, datetime
from math import atan2, degrees, hypot

from ...base.geodesy import east_of

Place = tuple[float, float]  # degrees north and east


def utc(time: float) -> str:
    """Return a time, s since 1970 UTC, as ISO 8601 to the second.

    >>> utc(1454292746.4)
    '2016-02-01T02:12:26Z'
    """
    return datetime.fromtimestamp(round(time), UTC).strftime("%Y-%m-%dT%H:%M:%SZ")


def clock(time: str) -> str:
    """Return an ISO 8601 time to the minute, as a sentence has it.

    >>> clock("2016-02-01T02:12:26Z")
    '2016-02-01 02:12 UTC'
    """
    return f"{time[:10]} {time[11:16]} UTC"


def direction(east: float, north: float) -> float | None:
    """Return where a vector points, degrees clockwise from north; None where it has no length.

    >>> direction(-1.0, 0.0), direction(0.0, 0.0)
    (270.0, None)
    """
    if hypot(east, north) == 0.0:
        return None
    angle = degrees(atan2(east, north)) % 360.0
    return 0.0 if angle == 360.0 else angle  # of -1e-15


def compass(angle: float) -> str:
    """Return a direction in whole degrees, three digits.

    >>> compass(7.2), compass(359.6), compass(-90.0)
    ('007', '000', '270')
    """
    return f"{round(angle) % 360:03d}"


def velocity(east: float, north: float) -> str:
    """Return a current in m/s and where it goes to.

    >>> velocity(0.0, -0.21), velocity(0.0, 0.0)
    ('0.21 m/s to 180', '0.00 m/s')
    """
    angle = direction(east, north)
    return f"{hypot(east, north):.2f} m/s" + (
        "" if angle is None else f" to {compass(angle)}"
    )


def in_degrees(lat: float, lon: float) -> str:
    """Return a place in decimal degrees.

    >>> in_degrees(-42.93, 8.42), in_degrees(0.0, 190.0)
    ('42.9300 S 8.4200 E', '0.0000 N 170.0000 W')
    """
    pairs = ((round(lat, 4), "NS"), (round(east_of(lon), 4), "EW"))
    return " ".join(f"{abs(angle):.4f} {names[angle < 0]}" for angle, names in pairs)


def degrees_minutes(angle: float, decimals: int) -> tuple[int, str]:
    """Return an angle's size as whole degrees and minutes of two digits and some decimals.

    >>> degrees_minutes(-42.99999, 2), degrees_minutes(8.42, 0)
    ((43, '00.00'), (8, '25'))
    """
    size = 10**decimals
    degrees, remainder = divmod(round(60 * size * abs(angle)), 60 * size)
    return (
        degrees,
        f"{remainder // size:02d}"
        + f".{remainder % size:0{decimals}d}" * bool(decimals),
    )


def in_minutes(lat: float, lon: float) -> str:
    """Return a place in degrees and decimal minutes.

    >>> in_minutes(-42.93, 8.42), in_minutes(-0.00001, -179.99999)
    ('42 55.80 S 8 25.20 E', '0 00.00 N 180 00.00 W')
    """
    words = []
    for angle, names in ((lat, "NS"), (east_of(lon), "EW")):
        degrees, minutes = degrees_minutes(angle, 2)
        words.append(f"{degrees} {minutes} {names[round(6000 * angle) < 0]}")
    return " ".join(words)


def minutes(angle: float) -> str:
    """Return an angle as gliders take it: degrees and minutes in one number, ddmm.mmmm.

    >>> minutes(-42.8), minutes(8.4), minutes(-0.99999999)
    ('-4248.0000', '824.0000', '-100.0000')
    """
    return "-" * (angle < 0) + "".join(map(str, degrees_minutes(angle, 4)))


def place(lat: float, lon: float) -> str:
    """Return a place both ways.

    >>> place(-42.93, 8.42)
    '42 55.80 S 8 25.20 E (42.9300 S 8.4200 E)'
    """
    return f"{in_minutes(lat, lon)} ({in_degrees(lat, lon)})"


def placed(prefix: str, lat: float, lon: float) -> dict[str, float]:
    """Return a place as rows have it, by the name of the place.

    >>> placed("end_", -42.9, 8.4)
    {'end_latitude': -42.9, 'end_longitude': 8.4}
    """
    return {f"{prefix}latitude": lat, f"{prefix}longitude": lon}


def vector(prefix: str, east: float, north: float) -> dict[str, float]:
    """Return a vector as rows have it, by its name."""
    return {f"{prefix}east": float(east), f"{prefix}north": float(north)}


def date(time: str) -> str:
    """Return month, day, hour and minute of an ISO time."""
    return time[5:16].replace("T", " ")
