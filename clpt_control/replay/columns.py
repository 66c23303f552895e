"""The columns of a replay's table, for terminals and pages: a row for each dive.

A column of a lower rank stands before others where there is no room for all; those of rank 0
always stand.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from .wording import compass


class Column(NamedTuple):
    """Title, rank and cell of a column; the cell is made of a row of `--json`."""

    title: str
    rank: int
    cell: Callable[[dict[str, Any]], str]


def columns(row: dict[str, Any]) -> list[Column]:
    """Return all columns for rows such as this, in their order."""
    found = [
        Column("dive", 0, lambda row: str(row["dive"])),
        Column("ended (UTC)", 1, lambda row: _date(row["end"])),
        Column("no flow", 4, lambda row: metres(row["clpe"]["no_flow"])),
        Column("previous", 0, lambda row: metres(row["clpe"]["previous_dive"])),
        Column("adaptive", 0, lambda row: metres(row["clpe"]["adaptive"])),
        Column("current to", 2, lambda row: _toward(row, "current")),
        Column("current E N (m/s)", 6, _east_north),
        Column("speed", 3, _factor),
        Column("over ground", 7, lambda row: _way(row["over_ground"])),
        Column("drift (m) to", 8, lambda row: _drift(row["drift"])),
        Column(
            "E N of DR (m)",
            9,
            lambda row: f"{row['forecast_east']:+.0f} {row['forecast_north']:+.0f}",
        ),
        Column("90 % ellipse (m, deg)", 5, _ellipse),
        Column("90 %", 0, lambda row: "in" if row["inside_90"] else "OUT"),
        Column("mark", 0, _mark),
    ]
    if "flow_model" in row["clpe"]:
        found.insert(5, Column("model", 1, lambda row: metres(row["clpe"]["flow_model"])))
    return found if row["speed_factor"] is not None else [c for c in found if c.title != "speed"]


def ahead_cell(title: str, ahead: dict[str, Any]) -> str:
    """Return what is known of the next dive in a column: when and how near it ends."""
    known = {"dive": "next", "ended (UTC)": _date(ahead["time"])}
    return {**known, "90 % ellipse (m, deg)": _ellipse(ahead)}.get(title, "")


def metres(size: float | None) -> str:
    """Return a length as the table shows it, m."""
    return "-" if size is None else f"{size:.0f}"


def _toward(row: dict[str, Any], name: str) -> str:
    return _speed_to(row[f"{name}_speed"], row[f"{name}_direction"])


def _speed_to(speed: float | None, direction: float | None) -> str:
    """Return a speed, m/s, and where to, degrees."""
    known = "-" if speed is None else f"{speed:.2f}"
    return known if direction is None else f"{known} {compass(direction)}"


def _way(way: dict[str, Any]) -> str:
    return _speed_to(way["speed"], way["direction"])


def _drift(way: dict[str, Any] | None) -> str:
    if way is None:
        return "-"
    return f"{way['distance']:.0f}, {_way(way)}"


def _east_north(row: dict[str, Any]) -> str:
    return " ".join(
        f"{row[f'current_{axis}']:+.3f}({1000 * row[f'current_{axis}_error']:.0f})"
        for axis in ("east", "north")
    )


def _factor(row: dict[str, Any]) -> str:
    return f"{row['speed_factor']:.3f}({1000 * row['speed_factor_error']:.0f})"


def _ellipse(row: dict[str, Any]) -> str:
    half = f"{row['ellipse_90_long']:.0f} x {row['ellipse_90_short']:.0f}"
    return f"{half}, {row['ellipse_90_bearing']:.0f}"


def _date(time: str) -> str:
    """Return month, day, hour and minute of an ISO time."""
    return time[5:16].replace("T", " ")


def _mark(row: dict[str, Any]) -> str:
    anomaly = row["anomaly"]
    return "" if anomaly is None else "SPEED" if anomaly["certain"] else "SPEED?"
