"""Rows of columns: unit, names in tables, name in results, limits, and reader of a cell.

A field of `dives.Dive` has its row beside its name. The rows make the columns of a CSV table
(`dive_table`), the keys of a dive in the JSON of a replay (`forecast.step`), and the variables of
its NetCDF file with their units (`forecast.netcdf_export`). A field without a row is in none.

Columns that only a log of a vehicle has are rows of `MOMENT` (`vehicle_log`). A further spelling
of a name or of a unit goes to the row.

A reader returns the value of a cell, or None if the text is no such value.
"""

import re
from collections.abc import Callable
from contextlib import suppress
from dataclasses import MISSING, dataclass, field, fields, replace
from functools import partial
from math import inf, isclose, isfinite, pi
from typing import Any, NamedTuple

from ...base.errors import DataError
from ...base.units import (
    KNOT,
    length_in_metres,
    number,
    seconds_since_1970,
    speed_in_metres_per_second,
)

NUMBERS = 2**31  # dive numbers are smaller, as files keep them in 32 bits
LONGEST_NAME = 40  # letters; a longer one is no name
# degrees; a heading of a whole turn may have a variation added, without starting again from 0
HEADINGS, VARIATIONS = (-180.0, 540.0), (-180.0, 180.0)
SIZES = (0.0, inf)
SAME = "name of the field"
NORTH, EAST = "degrees_north", "degrees_east"
EPOCH = "seconds since 1970-01-01 00:00:00 UTC"
# degrees, minutes and seconds, with a sign or a letter on one side; only the last has decimals
SEXAGESIMAL = re.compile(
    r"([NSEW+-])?\s*(\d{1,3}(?:\.\d*(?!\D*\d))?)(?:[°ºd:\s]+([0-5]?\d(?:\.\d*(?!\D*\d))?))?"
    r"(?:['′’m:\s]+([0-5]?\d(?:\.\d*)?))?[°ºd'′’m\"″”s\s]*(?(1)|([NSEW])?)"
)
# values that mean "none": words and numbers of all columns, and numbers of AIS and NMEA 2000 by
# the unit of a column, whose speed of 102.3 kn may have been converted or not
NO_VALUE = frozenset(["", "na", "n/a", "nan", "nat", "null", "none", "nil", "unknown"])
FILLS = (-999.0, -9999.0, -99999.0)
LEAST_FILL = 1e19  # of files of NetCDF: 9.96921e36, 1e20, 1e35
FILLS_OF = {
    "degrees": (511.0,),
    "m/s": (102.3, 102.3 * KNOT),
    NORTH: (91.0,),
    EAST: (181.0,),
}
GIVE = "time,latitude,longitude,course,speed"


def whole_number(value: float | str | None) -> int | None:
    """Return the number of a dive, below `NUMBERS` in size, or None where it is none.

    >>> whole_number("7"), whole_number(7.5), whole_number("1e10"), whole_number("x")
    (7, None, None, None)
    """
    value_of_text = number(value)
    return (
        int(value_of_text)
        if value_of_text.is_integer() and abs(value_of_text) < NUMBERS
        else None
    )


def name_of(*values: Any) -> str | None:
    """Return the first value that is a vehicle's name, None if none is.

    A name begins with a letter, a digit or an underscore, so that no file can pass an option, a
    path or a redirection to the command of an alert.

    >>> name_of("-oProxyCommand=x", "SG171")
    'SG171'
    """
    for value in values:
        name = value.strip() if isinstance(value, str) else ""
        begins_well = name[:1].isalnum() or name[:1] == "_"
        if begins_well and len(name) <= LONGEST_NAME and name.isprintable():
            return name
    return None


def _number(text: str, size: float = 1.0) -> float | None:
    """Return a number times the size of its unit."""
    with suppress(ValueError):
        return float(text) * size
    return None


def _seconds(text: str, size: float = 1.0) -> float | None:
    """Return a number times the size of its unit, or the seconds since 1970 of a date."""
    value = _number(text, size)
    with suppress(ValueError):
        dated = re.sub(r"(?i)\s*(UTC|GMT|Z)$", "Z", text)
        return seconds_since_1970(dated) if value is None else value
    return None


def _degrees(text: str, size: float = 1.0) -> float | None:
    r"""Return a number times the size of its unit, or the degrees of a text in degrees and minutes.

    >>> _degrees("36 42.5 N"), _degrees("122.1W"), _degrees("361234567", 1e-7), _degrees("36 61 N")
    (36.708333333333336, -122.1, 36.1234567, None)
    >>> _degrees("36°42'30\"S"), _degrees("36:42:30", -1.0), _degrees("-36 S"), _degrees("36.5 4 N")
    (-36.708333333333336, -36.708333333333336, None, None)
    """
    value = _number(text, size)
    matched = SEXAGESIMAL.fullmatch(text)
    if value is not None or matched is None:
        return value
    before, *components, behind = matched.groups("")
    degrees = sum(
        float(component or 0.0) / 60.0**k for k, component in enumerate(components)
    )
    signs = {"N": 1.0, "E": 1.0, "S": -1.0, "W": -1.0, "-": -size}
    return signs.get(before or behind, size) * degrees


class Reader(NamedTuple):
    """Reader of a cell, what a cell must be, and whether an empty cell is a gap."""

    read: Callable[..., Any]  # text, and the size of its unit if the header has a unit
    must_be: str
    gaps: bool = True


NUMBER = Reader(_number, "must be a number")
DEGREES = Reader(_degrees, "must be a number")
TIME = Reader(
    _seconds, "must be seconds since 1970 UTC, or a date such as 2016-01-31T22:04:50Z"
)
WHOLE = Reader(whole_number, f"must be a whole number below {NUMBERS}", gaps=False)
NAME = Reader(name_of, "must be a name that begins with a letter, a digit or _")
TEXT = Reader(str, "must be a text")


@dataclass(frozen=True)
class Column:
    """Row of a column of a table, and of a field of `Dive` that has the column.

    `header` is its name in a table, `result` the name of the field in results, where "" leaves it
    out. In a log the column may have another of `names`, and a unit, of which `size_of` returns
    the size; without a unit it is `default_size`. A column without a reader is written and never
    read. Values outside of `limits` are gaps.
    """

    unit: str
    reader: Reader | None = NUMBER
    header: str = SAME
    result: str = SAME
    limits: tuple[float, float] = (-inf, inf)
    names: str = ""
    size_of: Callable[[str, str], float] = length_in_metres
    default_size: float = 1.0
    name: str = ""
    default: Any = None
    is_required: bool = False

    def value(self, text: str, *size: float) -> tuple[Any, str]:
        """Return the value of a cell, None if it has none, and what is wrong with the text."""
        if self.reader is None or (self.reader.gaps and self.is_none(text, *size)):
            return None, ""
        value = self.reader.read(text, *size)
        if value is None:
            return None, f"{self.header} is {text[:30]!r}; {self.reader.must_be}"
        if isinstance(value, str):
            return value, ""
        low, high = self.limits
        if value < low or value > high:
            allowed = f"{low:g} or more," if high == inf else f"{low:g} to {high:g}"
            return None, f"{self.header} is {value:g}; must be {allowed} {self.unit}"
        return (value if isfinite(value) else None), ""

    def is_none(self, text: str, size: float = 1.0) -> bool:
        """Return whether a cell means that there is no value.

        >>> speed = MOMENT[5]
        >>> [speed.is_none(text, KNOT) for text in ("102.3", "N/A", "-999", "1e20", "1.02")]
        [True, True, True, True, False]
        """
        value = number(text)
        fills = (*FILLS, *(fill / size for fill in FILLS_OF.get(self.unit, ())))
        return (
            text.lower().strip("-#<>") in NO_VALUE
            or LEAST_FILL < abs(value) < inf
            or any(isclose(value, fill, rel_tol=1e-6) for fill in fills)
        )

    def cell(self, dive: Any) -> str:
        """Return the value of a dive as a cell, from which it is read bit for bit."""
        value = getattr(dive, self.name)
        if value is None:
            return ""
        if isinstance(value, str):
            return '"' + value.replace('"', '""') + '"'
        return str(value) if isinstance(value, int) else repr(float(value))


def size_of_unit(sizes: dict[str, float], unit: str, where: str) -> float:
    """Return the size of a unit by the first pattern that it matches without its spaces.

    >>> [size_of_unit(TURNS, unit, "HEADING") for unit in ("degrees (true)", "gon", "decidegrees")]
    [1.0, 0.9, 0.1]
    """
    for pattern, size in sizes.items():
        if re.fullmatch(pattern, unit.replace(" ", ""), re.IGNORECASE):
            return size
    raise DataError(
        f"{where} is in {unit!r}. Give times in s since 1970 or ISO 8601, angles in degrees or rad"
    )


TIMES = partial(
    size_of_unit,
    {
        "utc|gmt|s(ec(onds?)?)?(since1970.*)?|(y|iso).*": 1.0,
        "ms": 1e-3,
        "us": 1e-6,
        "ns|nanosec(onds?)?": 1e-9,
    },
)
RADIAN = 180.0 / pi  # degrees
TURNS = {  # units of angles in degrees; behind "deg" and "rad" words, but no factor or unit
    "dege7|1e-7deg": 1e-7,
    r"1?|(angular_?|decimal_?)?(deg|[°º])((?!10|[*/^]|e-?\d|per|min|sec).)*": 1.0,
    r"rad((?!10|[*/^]|e-?\d|per).)*": RADIAN,
    "m(illi)?rad(ian)?s?": RADIAN / 1e3,
    r"(deci|0?\.1\*?|tenthsof)(degrees?|deg|°)": 0.1,
    r"(centi|c|0?\.01\*?|hundredthsof)(degrees?|deg|°)": 0.01,
    "gon|gra(d|de|dian)s?": 0.9,
}
ANGLES = partial(size_of_unit, {"deg[ws]": -1.0} | TURNS)
MOMENT = (  # columns of a log, beside the displacement
    Column(
        EPOCH,
        TIME,
        "time",
        names="date datetime date_time timestamp utc stamp __time stamp.sec header.stamp.sec",
        size_of=TIMES,
    ),
    Column("ns", NUMBER, "nanosec", names="stamp.nanosec header.stamp.nanosec"),
    Column(NORTH, DEGREES, "latitude", names="lat", size_of=ANGLES),
    Column(EAST, DEGREES, "longitude", names="lon long lng", size_of=ANGLES),
    Column(
        "degrees",
        NUMBER,
        "course",
        names="heading true_heading",
        size_of=ANGLES,
        limits=HEADINGS,
        is_required=True,
    ),
    Column(
        "m/s",
        NUMBER,
        "speed",
        names="stw speed_through_water",
        size_of=speed_in_metres_per_second,
        limits=SIZES,
        is_required=True,
    ),
    Column(
        "degrees",
        NUMBER,
        "yaw",
        names="orientation.yaw",
        size_of=ANGLES,
        default_size=RADIAN,
        limits=HEADINGS,
    ),
    *(
        Column(
            "m/s",
            NUMBER,
            f"v_{axis}",
            names=f"{axis}_velocity velocity_{axis} v{axis[0]}",
            size_of=speed_in_metres_per_second,
        )
        for axis in ("east", "north")
    ),
)


def required(
    *row: Any, default: Any = MISSING, compare: bool = True, **others: Any
) -> Any:
    """Return a field with its row."""
    row_of = {"row": Column(*row, **others)}
    return field(default=default, compare=compare, metadata=row_of)


optional = partial(required, default=None)


def rows_of(kind: type) -> tuple[Column, ...]:
    """Return the rows of a class's fields, each with its names and its default."""
    return tuple(
        replace(
            row,
            name=each_field.name,
            header=each_field.name if row.header is SAME else row.header,
            result=each_field.name if row.result is SAME else row.result,
            default=None if each_field.default is MISSING else each_field.default,
            is_required=each_field.default is MISSING,
        )
        for each_field in fields(kind)
        if (row := each_field.metadata.get("row"))
    )
