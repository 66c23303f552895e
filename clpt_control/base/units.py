"""Units of length, time and speed, numbers as text, and dates, for scenarios and files."""

import re
from datetime import UTC, datetime
from decimal import ROUND_CEILING, ROUND_FLOOR, Context
from math import isfinite, nan
from typing import Any

from .errors import DataError

DAY = 86400.0  # s
METRES = {"m": 1.0, "km": 1000.0, "cm": 0.01, "mm": 0.001}
SECONDS = {
    "s": 1.0,
    "min": 60.0,
    "h": 3600.0,
    "d": DAY,
    "ms": 1e-3,
    "us": 1e-6,
    "ns": 1e-9,
}
DEGREES = {"latitude": "degrees_north", "longitude": "degrees_east"}  # of CF
CF_DEGREES = {"degrees_north": "°N", "degrees_east": "°E"}
KNOT = 1852.0 / 3600.0  # m/s
SPEED = re.compile(  # m/s, m per s, m s-1, m.s-1, m s^-1, m s**-1
    r"\s*(\w+)(?:\s*/\s*|\s+per\s+)(\w+)\s*|\s*(\w+)[\s.]+([a-z]+)\s*(?:\^|\*\*)?-1\s*",
    re.IGNORECASE,
)
FACTOR = re.compile(r"([^\W\d_]+)(?:\^|\*\*)?(-?\d+)?")  # of a unit, and its power
RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
UNITS = ("meter", "metre", "second")
PREFIXES = {"": "", "kilo": "k", "centi": "c", "milli": "m", "micro": "u", "nano": "n"}
WORDS = {  # also in the plural
    **{
        long + unit: short + unit[0]
        for long, short in PREFIXES.items()
        for unit in UNITS
    },
    "sec": "s",
    "minute": "min",
    "hr": "h",
    "hour": "h",
    "day": "d",
    "kt": "knot",
    "kn": "knot",
}


def number(cell: Any) -> float:
    """Return the number that a cell or an attribute is, NaN where it is none."""
    try:
        return float(cell)
    except (TypeError, ValueError, OverflowError):
        return nan


def finite_or_none(value: Any) -> Any:
    """Return a value, or those of a dict, as JSON has it: arrays as lists, NaN and inf as None."""
    if isinstance(value, dict):
        return {key: finite_or_none(item) for key, item in value.items()}
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, list):
        return [*map(finite_or_none, value)]
    return None if isinstance(value, float) and not isfinite(value) else value


def percent(share: float) -> str:
    """Return a share in percent with three digits; near 100 the remainder has one digit.

    >>> [percent(share) for share in (0.1234, 0.99996, 1.0, 4e-5, -0.5)]
    ['12.3 %', '99.996 %', '100 %', '0.004 %', '-50 %']
    """
    remainder = float(f"{100 * (1 - share):.1g}")
    return (
        f"{100 - remainder:.12g} %" if 0 < remainder < 0.1 else f"{100 * share:z.3g} %"
    )


def at_most(bound: float, digits: int = 4, rounding: str = ROUND_CEILING) -> str:
    """Return an upper bound in a few digits, rounded up.

    >>> at_most(0.08923, 3), at_most(0.01), at_most(1234567.0, 6)
    ('0.0893', '0.01', '1.23457e+06')
    """
    rounded = Context(digits, rounding).create_decimal(repr(float(bound)))
    return f"{float(rounded):.{digits}g}"


def at_least(bound: float, digits: int = 4) -> str:
    """Return a lower bound in a few digits, rounded down.

    >>> at_least(0.08927, 3), at_least(0.01), at_least(-0.3333, 2)
    ('0.0892', '0.01', '-0.34')
    """
    return at_most(bound, digits, ROUND_FLOOR)


def printed_unit(unit: str) -> str:
    """Return a unit as figures and tables print it: raised powers, CF's products as quotients.

    >>> [printed_unit(unit) for unit in ("m s-1", "1/s2", "m s-2", "s-1", "kg m**2/s", "%")]
    ['m/s', '1/s²', 'm/s²', '1/s', 'kg m²/s', '%']
    """
    for name, symbol in CF_DEGREES.items():
        unit = unit.replace(name, symbol)
    factors = [FACTOR.fullmatch(word) for word in unit.split()]
    if None in factors:  # no product
        return FACTOR.sub(lambda one: _raised(one[1], one[2]), unit)
    above = [_raised(*one.groups()) for one in factors if one and "-" not in one[0]]
    below = [_raised(*one.groups()) for one in factors if one and "-" in one[0]]
    divisor = " ".join(below) if len(below) < 2 else f"({' '.join(below)})"
    return "/".join([" ".join(above) or "1" * bool(below), *[divisor][: len(below)]])


def _raised(symbol: str, power: str | None) -> str:
    size = (power or "1").lstrip("-")
    return symbol + ("" if size == "1" else size.translate(RAISED))


def short_unit(word: str) -> str:
    """Return the symbol of a unit by its name or symbol."""
    word = word.strip().lower()
    single = word.removesuffix("s") if len(word) > 2 else word
    return WORDS.get(word) or WORDS.get(single, single)


def length_in_metres(unit: str, where: str) -> float:
    """Return the size of a unit of length in m; `where` is file and variable, for the message.

    >>> length_in_metres("km", "x"), length_in_metres("Meters", "depth")
    (1000.0, 1.0)
    """
    size = METRES.get(short_unit(unit))
    if size is None:
        raise DataError(
            f"{where} has units '{unit}'; use a unit such as 'm', 'km' or 'cm'"
        )
    return size


def time_in_seconds(unit: str, where: str) -> float:
    """Return the size of a unit of time in s, without its reference date.

    >>> time_in_seconds("hours since 2019-01-01", "time")
    3600.0
    """
    size = SECONDS.get(short_unit(unit.split(" since ")[0]))
    if size is None:
        raise DataError(
            f"{where} has units '{unit}'; use a unit such as 's', 'min', 'h' or 'd'"
        )
    return size


def speed_in_metres_per_second(unit: str, where: str) -> float:
    """Return the size of a unit of speed in m/s.

    >>> speed_in_metres_per_second("cm s-1", "u")
    0.01
    """
    if short_unit(unit) == "knot":
        return KNOT
    match = SPEED.fullmatch(unit)
    length, time = (
        (short_unit(word) for word in match.groups() if word) if match else ("", "")
    )
    if length in METRES and time in SECONDS:
        return METRES[length] / SECONDS[time]
    raise DataError(
        f"{where}: units = '{unit}' is not a speed. Use a unit such as 'm/s' or 'cm s-1'"
    )


def seconds_since_1970(date: str) -> float:
    """Return a date of ISO 8601, UTC by default, in s; raise a ValueError for other texts.

    >>> seconds_since_1970("1970-01-01T02:00:00+01:00")
    3600.0
    """
    moment = datetime.fromisoformat(date)
    return (moment if moment.tzinfo else moment.replace(tzinfo=UTC)).timestamp()


def iso(time: float) -> str:
    """Return a time, s since 1970, as a date of ISO 8601, to a millisecond."""
    moment = datetime.fromtimestamp(round(time, 3), UTC)
    timespec = "milliseconds" if moment.microsecond else "seconds"
    return moment.isoformat(timespec=timespec).replace("+00:00", "Z")
