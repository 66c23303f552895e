"""Rows of the fields of a dive: unit, column of a table, name in results, and reader of a cell.

A field of `dives.Dive` has its row beside its name. The rows make the columns of a CSV table
(`dive_table`), the keys of a dive in the JSON of a replay (`forecast.step`), and the variables of
its NetCDF file with their units (`forecast.netcdf_export`). A field without a row is in none.

A reader returns the value of a cell, or None if the text is no such value.
"""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import MISSING, dataclass, field, fields, replace
from math import inf, isfinite
from typing import Any, NamedTuple

from ...base.units import number, seconds_since_1970

NUMBERS = 2**31  # dive numbers are smaller, as files keep them in 32 bits
LONGEST_NAME = 40  # letters; a longer one is no name
# degrees; a heading of a whole turn may have a variation added, without starting again from 0
HEADINGS, VARIATIONS = (-180.0, 540.0), (-180.0, 180.0)
SIZES = (0.0, inf)
SAME = "name of the field"
NORTH, EAST = "degrees_north", "degrees_east"
EPOCH = "seconds since 1970-01-01 00:00:00 UTC"


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


def _number(text: str) -> float | None:
    with suppress(ValueError):
        return float(text)
    return None


def _seconds(text: str) -> float | None:
    """Return a number, or the seconds since 1970 of a date."""
    value = _number(text)
    with suppress(ValueError):
        return seconds_since_1970(text) if value is None else value
    return None


class Reader(NamedTuple):
    """Reader of a cell, what a cell must be, and whether an empty cell is a gap."""

    read: Callable[[str], Any]
    must_be: str
    gaps: bool = True


NUMBER = Reader(_number, "must be a number")
TIME = Reader(
    _seconds, "must be seconds since 1970 UTC, or a date such as 2016-01-31T22:04:50Z"
)
WHOLE = Reader(whole_number, f"must be a whole number below {NUMBERS}", gaps=False)
NAME = Reader(name_of, "must be a name that begins with a letter, a digit or _")
TEXT = Reader(str, "must be a text")


@dataclass(frozen=True)
class DiveField:
    """Row of a field of `Dive`.

    `column` is its name in a table, `result` that in results, where "" leaves the field out. A
    column without a reader is written and never read. Values outside of `limits` are gaps.
    """

    unit: str
    reader: Reader | None = NUMBER
    column: str = SAME
    result: str = SAME
    limits: tuple[float, float] = (-inf, inf)
    name: str = ""
    default: Any = None
    is_required: bool = False

    def value(self, text: str) -> tuple[Any, str]:
        """Return the value of a cell, None if it has none, and what is wrong with the text."""
        if self.reader is None or (self.reader.gaps and not text):
            return None, ""
        value = self.reader.read(text)
        if value is None:
            return None, f"{self.column} is {text[:30]!r}; {self.reader.must_be}"
        if isinstance(value, str):
            return value, ""
        low, high = self.limits
        if value < low or value > high:
            allowed = f"must be {low:g} to {high:g} {self.unit}"
            return None, f"{self.column} is {value:g}; {allowed}"
        return (value if isfinite(value) else None), ""

    def cell(self, dive: Any) -> str:
        """Return the value of a dive as a cell, from which it is read bit for bit."""
        value = getattr(dive, self.name)
        if value is None:
            return ""
        if isinstance(value, str):
            return '"' + value.replace('"', '""') + '"'
        return str(value) if isinstance(value, int) else repr(float(value))


def in_files(*row: Any, **others: Any) -> dict[str, DiveField]:
    """Return the metadata of a field with its row."""
    return {"row": DiveField(*row, **others)}


def optional(
    *row: Any, default: Any = None, compare: bool = True, **others: Any
) -> Any:
    """Return a field with a default and its row."""
    return field(default=default, compare=compare, metadata=in_files(*row, **others))


def rows_of(kind: type) -> tuple[DiveField, ...]:
    """Return the rows of a class's fields, each with its names and its default."""
    return tuple(
        replace(
            row,
            name=one.name,
            column=one.name if row.column is SAME else row.column,
            result=one.name if row.result is SAME else row.result,
            default=None if one.default is MISSING else one.default,
            is_required=one.default is MISSING,
        )
        for one in fields(kind)
        if (row := one.metadata.get("row"))
    )
