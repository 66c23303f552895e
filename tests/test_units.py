"""Units as files spell them, by their definitions."""

import pytest

from clpt_control.errors import DataError
from clpt_control.units import (
    length_in_metres,
    seconds_since_1970,
    speed_in_metres_per_second,
    time_in_seconds,
)


@pytest.mark.parametrize(
    ("unit", "size"),
    [
        *((text, 1.0) for text in ("m/s", "m s-1", "m.s-1", "m s^-1", "m s**-1", "metres per sec")),
        *((text, 0.01) for text in ("cm/s", "cm s-1", "cm/sec", " cm / second ")),
        *((text, 1 / 3.6) for text in ("km/h", "km h-1", "km/hr", "kilometers per hour")),
        *((text, 1852 / 3600) for text in ("knot", "Knots", "kt", "kts")),
        ("m/day", 1 / 86400),
    ],
)
def test_speeds(unit, size):
    assert speed_in_metres_per_second(unit, "u") == pytest.approx(size, rel=1e-15)


@pytest.mark.parametrize(
    ("unit", "size"),
    [
        *((text, 1.0) for text in ("s", "sec", "secs", "second", "Seconds")),
        *((text, 60.0) for text in ("min", "mins", "minute", "minutes")),
        *((text, 3600.0) for text in ("h", "hr", "hrs", "hour", "hours since 2019-01-01")),
        *((text, 86400.0) for text in ("d", "day", "days")),
        ("milliseconds", 1e-3),
        ("nanoseconds since 2010-07-29 13:31:04", 1e-9),
    ],
)
def test_times(unit, size):
    assert time_in_seconds(unit, "time") == size


def test_lengths_and_dates():
    assert [length_in_metres(unit, "x") for unit in ("km", "m", "Metres", "cm")] == [
        1e3,
        1,
        1,
        0.01,
    ]
    day = 86400.0
    assert seconds_since_1970("1970-01-02") == day
    assert seconds_since_1970("1970-01-02T00:00:00+02:00") == day - 7200
    with pytest.raises(ValueError, match="in the calendar"):
        seconds_since_1970("1970-01-02T00:00:00 in the calendar 360_day")


@pytest.mark.parametrize(
    "unit", ["", "kelvin", "m", "s", "m s", "m-1 s", "s-1 m", "ms-1", "m/fortnight", "m/s/s", "1"]
)
def test_what_is_no_unit_is_refused(unit):
    with pytest.raises(DataError, match=r"u: units = .* is no speed; must be such as 'm/s'"):
        speed_in_metres_per_second(unit, "u")
    if unit != "m":
        with pytest.raises(DataError, match=r"x has units .*; must be such as 'm', 'km' or"):
            length_in_metres(unit, "x")
    if unit != "s":
        with pytest.raises(DataError, match=r"t has units .*; must be such as 's', 'min', 'h'"):
            time_in_seconds(unit, "t")
