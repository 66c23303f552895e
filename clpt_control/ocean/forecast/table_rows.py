"""The table of a replay: a row for each dive, on terminals and pages.

Cells are made of what `clpt replay --json` prints.  A column of a lower rank stands before others
where there is no room for all; those of rank 0 always stand.
"""

from collections.abc import Callable
from typing import Any

from ..estimation.learned_fix import PERCENT
from .geographic import compass, date

Row = dict[str, Any]
# title: rank, and cell of a row
Columns = dict[str, tuple[int, Callable[[Row], str | None]]]


def metres(size: float | None) -> str:
    """Return a length as a cell of the table, m."""
    return "-" if size is None else f"{size:.0f}"


def _miss(row: Row, model: str) -> str | None:
    """Return the miss of a flow model, None where there is none."""
    return metres(row["clpe"][model]) if model in row["clpe"] else None


def _toward(motion: Row, prefix: str = "") -> str:
    """Return a speed, m/s, and where to, degrees."""
    speed, direction = motion[f"{prefix}speed"], motion[f"{prefix}direction"]
    speed_text = "-" if speed is None else f"{speed:.2f}"
    return speed_text if direction is None else f"{speed_text} {compass(direction)}"


def _current(row: Row) -> str:
    """Return the current east and north, and the standard error of its last digits."""
    components = (
        (row[f"current_{axis}"], row[f"current_{axis}_error"])
        for axis in ("east", "north")
    )
    return " ".join(f"{value:+z.3f}({1000 * error:.0f})" for value, error in components)


def _speed(row: Row) -> str | None:
    """Return the factor on speed, None where none is learned."""
    value = row["speed_factor"]
    return (
        None
        if value is None
        else f"{value:.3f}({1000 * row['speed_factor_error']:.0f})"
    )


def _drift(drift: Row | None) -> str:
    return "-" if drift is None else f"{drift['distance']:.0f}, {_toward(drift)}"


def half_axes(row: Row) -> str:
    """Return the half axes of an ellipse, m."""
    return f"{row['ellipse_long']:.0f} x {row['ellipse_short']:.0f}"


def ellipse_words(row: Row) -> str:
    """Return the size of an ellipse.

    >>> ellipse_words({"ellipse_long": 3163.2, "ellipse_short": 2955.0})
    '90 % ellipse with half axes 3163 x 2955 m'
    """
    return f"{PERCENT} ellipse with half axes {half_axes(row)} m"


def _ellipse(row: Row | None) -> str:
    return "-" if row is None else f"{half_axes(row)}, {row['ellipse_bearing']:.0f}"


def _inside(forecast: Row | None) -> str:
    return "-" if forecast is None else "in" if forecast["inside"] else "OUT"


TITLE = "Position error (CLPE, m) one dive ahead; currents in m/s"
MODELS = ("no flow", "previous", "adaptive", "model")  # columns of the flow models
ELLIPSE = f"{PERCENT} half axes (m), deg"
COLUMNS: Columns = {
    "dive": (0, lambda row: str(row["dive"])),
    "ended (UTC)": (1, lambda row: date(row["end"])),
    "no flow": (4, lambda row: _miss(row, "no_flow")),
    "previous": (0, lambda row: _miss(row, "previous_dive")),
    "adaptive": (0, lambda row: _miss(row, "adaptive")),
    "model": (1, lambda row: _miss(row, "flow_model")),
    "current to": (2, lambda row: _toward(row, "current_")),
    "current E N (m/s)": (6, _current),
    "speed": (3, _speed),
    "over ground": (7, lambda row: _toward(row["over_ground"])),
    "drift (m) to": (8, lambda row: _drift(row["drift"])),
    "E N of DR (m)": (
        9,
        lambda row: (
            f"{row['hindsight']['east']:+z.0f} {row['hindsight']['north']:+z.0f}"
        ),
    ),
    ELLIPSE: (5, lambda row: _ellipse(row["forecast"])),
    PERCENT: (0, lambda row: _inside(row["forecast"])),
}


def cells(row: Row, columns: Columns = COLUMNS) -> dict[str, str]:
    """Return the cells of a row by the titles of its columns, in their order."""
    pairs = ((title, cell(row)) for title, (_, cell) in columns.items())
    return {title: text for title, text in pairs if text is not None}


def cells_ahead(ahead: Row) -> dict[str, str]:
    """Return what is known of the next dive: when and how near it ends."""
    known_cells = {
        "dive": "next",
        "ended (UTC)": date(ahead["time"]),
        ELLIPSE: _ellipse(ahead),
    }
    return {**dict.fromkeys(COLUMNS, ""), **known_cells}
