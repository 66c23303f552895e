"""Tables of any vehicle, CSV: one row per dive under a header, or a log of fixes and motion.

Required columns: `dive`, `t_gps2`, `lat_gps2`, `lon_gps2`, `t_gpse`, `lat_gpse`, `lon_gpse` (s
since 1970 UTC or ISO 8601, degrees) and `dr_east_m`, `dr_north_m` (dead reckoning through the
water, m), or `course`, `speed` (degrees, m/s) of a straight leg, or `dac_east`, `dac_north` (the
vehicle's own depth-averaged current c, m/s), of which dead reckoning is computed,

    dr = (displacement between the fixes) - c (t_gpse - t_gps2).

A table with both is refused if most of its dives contradict this equation by more than 30 mm/s, as
a Slocum file's dead reckoning is; one dive off by more than 10 mm/s has a note, as in a Seaglider
file.

Optional columns are the other rows of `dives.FIELDS` (`dive_fields`), such as `depth_max` (m) or
`vehicle`.  Lines that begin with `#` are comments, other columns are left alone, and the
displacement between the fixes is computed, never read.

A log has a row per moment (`vehicle_log`).
"""

from collections.abc import Iterable
from math import isfinite, nan
from pathlib import Path
from typing import Any

import numpy as np

from ...base.arguments import public
from ...base.errors import DataError
from ...base.files import write_file
from ...paper.currents.flags import BAD, BAD_CODES
from .dive_fields import GIVE, whole_number
from .dives import (
    COLUMNS,
    CONTRADICTS,
    FIELDS,
    STEERING,
    STRETCH,
    Dive,
    Skipped,
    make_dive,
    velocity_of,
    with_dac_note,
    without_current,
)
from .text_table import table_of
from .vehicle_log import PLACED, is_log, log_columns, log_legs

START = ("t_gps2", "lat_gps2", "lon_gps2")
END = ("t_gpse", "lat_gpse", "lon_gpse")
CURRENT = ("dac_east", "dac_north")
REQUIRED = [row.header for row in FIELDS if row.is_required and row.reader]
OPTIONAL = [row for row in FIELDS if not row.is_required]
OTHERWISE = (
    "; course (degrees), speed (m/s), or dac_east, dac_north (m/s), the vehicle's own current, may "
    "stand instead of dr_east_m, dr_north_m"
)


def table_dives(text: str, path: Path, every_row: bool = False) -> list[Dive | Skipped]:
    r"""Return the dives of a table, NaN where a number is missing, and lines that hold none.

    >>> header = "dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,dr_north_m"
    >>> (dive,) = table_dives(header + "\n1,0,-43,8,9000,-43,8.1,8000,0", "mine.csv")
    >>> round(dive.miss_east), dive.magvar
    (154, None)
    """
    if is_log(text):
        return log_legs(text, path, every_row)
    cells = table_of(text, path, f"NetCDF or a table with {', '.join(REQUIRED)}")
    header = list(cells.columns)
    _check_header(header, path)
    rows = [
        _dive(dict(zip(header, row, strict=True)), f"{path}, line {line}")
        for line, row in zip(cells.index, cells.to_numpy(), strict=True)
    ]
    for line, (row, why) in cells.attrs["wrong_lines"].items():
        number = whole_number(row[0]) if header[0] == "dive" else None
        rows.append(
            Skipped(number, f"{path}, line {line}: {why}. Leave gaps as empty cells")
        )
    _check_current([row for row in rows if isinstance(row, Dive)], path)
    return rows


def _check_current(dives: list[Dive], path: Path) -> None:
    """Refuse dives whose own current contradicts their dead reckoning in most of them."""
    dives_with_current = [dive for dive in dives if isfinite(dive.dac_difference)]
    if not dives_with_current:
        return
    currents = np.array(
        [(dive.dac_east, dive.dac_north) for dive in dives_with_current]
    )
    expected = np.array([dive.miss / dive.duration for dive in dives_with_current])

    def median_off(currents: np.ndarray) -> float:
        return float(np.median(np.hypot(*(currents - expected).T)))

    off = median_off(currents)
    if off <= CONTRADICTS:
        return
    causes = {
        "dac_east and dac_north look swapped": currents[:, ::-1],
        "dac_east and dac_north look like cm/s": currents / 100.0,
        "dac_east and dac_north look like mm/s": currents / 1000.0,
        "dac_east and dac_north look reversed in sign": -currents,
    }
    likely = [cause for cause, fixed in causes.items() if median_off(fixed) < 0.5 * off]
    best = min(likely, key=lambda cause: median_off(causes[cause]), default="")
    raise DataError(
        f"{path}: dr_east_m, dr_north_m contradict dac_east, dac_north by {1e3 * off:.0f} mm/s in "
        f"most dives{best and f': {best}'}. Correct one pair, or leave the wrong columns out"
    )


def _check_header(header: list[str], name: Path) -> None:
    """Refuse a header without a required column, or with a column twice."""
    line = ",".join(header)
    in_brackets = {
        cell: cell.partition("(")[0].strip() for cell in header if "(" in cell
    }
    of_dives = {cell for cell, plain in in_brackets.items() if plain in COLUMNS}
    if set(START) <= set(header) and of_dives:
        raise DataError(
            f"{name}: {', '.join(sorted(of_dives))}: a table of dives has s, degrees, m and m/s. "
            "Give these, and names without a unit"
        )
    missing = [column for column in REQUIRED if column not in header]
    otherwise = set(CURRENT) <= set(header) or set(STEERING) <= set(header)
    if otherwise and not set(header) & set(STRETCH):
        missing = [column for column in missing if column not in STRETCH]
    of_log = log_columns(header)
    of_dives = {row.header for row in FIELDS} & {cell.lower() for cell in header}
    if missing and len(of_log) > len(of_dives):
        absent = ", ".join(name for name in PLACED if name not in of_log)
        raise DataError(
            f"{name}: no column {absent}; has {line[:300]}; a log begins with {GIVE}"
        )
    if missing:
        raise DataError(
            f"{name}: no column {', '.join(missing)}; has {', '.join(header)[:300]}; a table of "
            f"dives begins with {','.join(REQUIRED)}{OTHERWISE}; a log begins with {GIVE}"
        )
    double = [
        row.header for row in FIELDS if row.reader and header.count(row.header) > 1
    ]
    if double:
        raise DataError(
            f"{name}: the column {', '.join(double)} appears twice. Remove one"
        )


def _dive(texts: dict[str, str], where: str) -> Dive | Skipped:
    cells: dict[str, Any] = {}
    notes: list[str] = []
    has_stretch = not {*STRETCH}.isdisjoint(texts)
    is_steered = not has_stretch and {*STEERING} <= {*texts}
    steering = [COLUMNS[name] for name in STEERING] if is_steered else []
    for row in (*FIELDS, *steering):
        value, fault = row.value(texts.get(row.header, ""))
        if fault and row.is_required:
            return Skipped(cells.get("dive"), f"{where}: {fault}")
        if fault:
            notes.append(f"{where}: {fault}")
        default = nan if row.is_required else row.default
        cells[row.header] = default if value is None else value
    number = cells["dive"]
    start, end, through_water = (
        tuple(cells[column] for column in columns) for columns in (START, END, STRETCH)
    )
    if is_steered:
        velocity = velocity_of(*(cells[column] for column in STEERING))
        duration = end[0] - start[0]
        through_water = velocity[0] * duration, velocity[1] * duration
    elif not has_stretch:
        current = cells["dac_east"], cells["dac_north"]
        is_flagged = cells["dac_qc"] in BAD_CODES or BAD.search(
            texts.get("dac_qc", "").lower()
        )
        if is_flagged or None in current:
            through_water = nan, nan
            why = (
                "dac_qc is bad"
                if is_flagged
                else "dac_east or dac_north is not a number"
            )
            notes.append(f"{why}, and there is no dead reckoning")
        else:
            through_water = without_current(start, end, current)
            notes.append("dead reckoning computed from dac_east, dac_north")
    dive = make_dive(
        number,
        start,
        end,
        through_water,
        **{row.name: cells[row.header] for row in OPTIONAL},
        notes=tuple(notes),
    )
    return with_dac_note(dive)


@public
def write_dive_table(
    dives: Iterable[Dive], path: str | Path, comment: str = ""
) -> None:
    """Write dives as a CSV table that reads back bit for bit.

    Tracks and notes are not in a table.

    Parameters
    ----------
    dives : iterable of Dive
        In the order to write.
    path : str or Path
        The file.
    comment : str
        Lines for its head, written behind ``#``.

    Raises
    ------
    DataError
        If the file cannot be written.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> from clpt_control.gliders import read_dives, sample_dives
    >>> with TemporaryDirectory() as folder:
    ...     write_dive_table(sample_dives(), f"{folder}/dives.csv", "fourteen dives of SG542")
    ...     read_dives(folder)[0] == sample_dives()
    True
    """
    lines = [f"# {line}".rstrip() for line in comment.splitlines()]
    lines.append(",".join(row.header for row in FIELDS))
    lines += [",".join(row.cell(dive) for row in FIELDS) for dive in dives]
    write_file(path, "\n".join(lines) + "\n")
