"""The table of a replay: a row for each dive, on terminals and pages.

Cells are made of what `clpt replay --json` prints.  A column of a lower rank stands before others
where there is no room for all; those of rank 0 always stand.
"""

from typing import Any

from .places import compass, date

MODELS = {  # name of a flow model: its column
    "no_flow": "no flow",
    "previous_dive": "previous",
    "adaptive": "adaptive",
    "flow_model": "model",
}
RANKS = {  # title of a column: its rank
    "dive": 0,
    "ended (UTC)": 1,
    "no flow": 4,
    "previous": 0,
    "adaptive": 0,
    "model": 1,
    "current to": 2,
    "current E N (m/s)": 6,
    "speed": 3,
    "over ground": 7,
    "drift (m) to": 8,
    "E N of DR (m)": 9,
    "90 % ellipse (m, deg)": 5,
    "90 %": 0,
    "mark": 0,
}


def cells(row: dict[str, Any]) -> dict[str, str]:
    """Return the cells of a row of `--json` by the titles of their columns, in their order."""
    clpe, drift = row["clpe"], row["drift"]
    current = [
        f"{row[f'current_{axis}']:+z.3f}({1000 * row[f'current_{axis}_error']:.0f})"
        for axis in ("east", "north")
    ]
    speed = {}
    if row["speed_factor"] is not None:
        speed["speed"] = f"{row['speed_factor']:.3f}({1000 * row['speed_factor_error']:.0f})"
    return {
        "dive": str(row["dive"]),
        "ended (UTC)": date(row["end"]),
        **{MODELS[name]: metres(size) for name, size in clpe.items()},
        "current to": _toward(row, "current_"),
        "current E N (m/s)": " ".join(current),
        **speed,
        "over ground": _toward(row["over_ground"]),
        "drift (m) to": "-" if drift is None else f"{drift['distance']:.0f}, {_toward(drift)}",
        "E N of DR (m)": f"{row['forecast_east']:+z.0f} {row['forecast_north']:+z.0f}",
        "90 % ellipse (m, deg)": _ellipse(row),
        "90 %": "in" if row["inside_90"] else "OUT",
        "mark": speed_mark(row["anomaly"]),
    }


def cells_ahead(ahead: dict[str, Any]) -> dict[str, str]:
    """Return what is known of the next dive: when and how near it ends."""
    known = {"dive": "next", "ended (UTC)": date(ahead["time"])}
    return {**dict.fromkeys(RANKS, ""), **known, "90 % ellipse (m, deg)": _ellipse(ahead)}


def metres(size: float | None) -> str:
    """Return a length as a cell of the table, m."""
    return "-" if size is None else f"{size:.0f}"


def _toward(way: dict[str, Any], prefix: str = "") -> str:
    """Return a speed, m/s, and where to, degrees."""
    speed, direction = way[f"{prefix}speed"], way[f"{prefix}direction"]
    known = "-" if speed is None else f"{speed:.2f}"
    return known if direction is None else f"{known} {compass(direction)}"


def half_axes(row: dict[str, Any]) -> str:
    """Return the half axes of a 90 % ellipse, m."""
    return f"{row['ellipse_90_long']:.0f} x {row['ellipse_90_short']:.0f}"


def _ellipse(row: dict[str, Any]) -> str:
    return f"{half_axes(row)}, {row['ellipse_90_bearing']:.0f}"


def speed_mark(anomaly: dict[str, Any] | None) -> str:
    """Return the mark of a dive whose speed left its range, empty where none did."""
    return "" if anomaly is None else "SPEED" if anomaly["certain"] else "SPEED?"
