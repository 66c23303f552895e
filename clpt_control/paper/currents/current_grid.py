"""A current on a grid: cells in a box, steps, the mean over a depth, and one of several files.

Steps are missing in an interval that is longer than 2.5 times the median of the two before it and
the two after it, so that steps may become coarser further ahead, as forecasts have them.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy.integrate import trapezoid

from ...base.errors import DataError
from ...base.files.reading import shown_name
from .valid_values import mark_gaps

# times the median step: no longer step is missing in a grid around the Earth
AROUND = 1.5
SAME = 1e-6  # degrees: no cells are so near; 0.1 m
GAP = 2.5  # times the intervals around one: beyond, steps are missing
COUNT = re.compile(r"(\d+) of (\d+)")  # at the beginning of a note
Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Currents:
    """A measured or modelled current on latitudes and longitudes."""

    lat: np.ndarray  # degrees north, increasing, shape (ny,)
    lon: np.ndarray  # degrees east, increasing, may pass 180, shape (nx,)
    # levels, m, increasing from the surface; 0 where the file has none, NaN of
    depth: np.ndarray
    # one whose depth it does not say
    dates: np.ndarray  # datetime64[ms], UTC, increasing, shape (nt,)
    # to the east, m/s, NaN in gaps, shape (nt, ny, nx), or (nt, nz, ny, nx)
    u: np.ndarray
    v: np.ndarray  # to the north
    box: Box  # lat0, lat1, lon0, lon1 asked for, degrees
    source: str  # name of the file or folder
    land: int = 0  # cells, of all levels, whose zeros were taken as land
    notes: tuple[str, ...] = ()  # on levels, flags and times

    @property
    def measured(self) -> np.ndarray:
        """Mask of measured values, boolean, with the shape of u."""
        return np.isfinite(self.u)

    @property
    def time(self) -> np.ndarray:
        """Hours since the first step."""
        return (self.dates - self.dates[0]) / np.timedelta64(1, "h")

    @property
    def start(self) -> str:
        """The first step, ISO 8601."""
        return self.dates[0].item().isoformat()


def checked_box(box: Any) -> Box:
    """Return lat0, lat1, lon0, lon1 with lon1 > lon0, also across 180 degrees."""
    lat0, lat1, lon0, lon1 = map(float, box)
    width = (lon1 - lon0) % 360.0
    if not -90 <= lat0 < lat1 <= 90 or not 0 < width <= 180:
        raise DataError(
            f"box = {edges_of(box)}: must be SOUTH NORTH WEST EAST, up to 180 wide"
        )
    return lat0, lat1, lon0, lon0 + width


def unwrapped(lon: np.ndarray, box: Box | None) -> np.ndarray:
    """Return longitudes without a jump: cut opposite a box, or at the circle's largest gap.

    A grid around the Earth has none and is cut where the file begins.
    """
    if box is not None:
        west = box[2] + 0.5 * (box[3] - box[2]) - 180.0
    else:
        order = np.argsort(lon % 360.0)
        gaps = np.diff(lon[order] % 360.0, append=lon[order[0]] % 360.0 + 360.0)
        east_of_gap = order[(int(np.argmax(gaps)) + 1) % len(lon)]
        west = lon[east_of_gap] if np.max(gaps) > AROUND * np.median(gaps) else lon[0]
    return lon - 360.0 * np.floor((lon - west) / 360.0)


def cells_inside(axis: np.ndarray, span: tuple, where: str) -> np.ndarray:
    """Return the indices of the axis inside the span, in increasing order."""
    slack = 1e-9
    order = np.argsort(axis)
    inside = order[(axis[order] >= span[0] - slack) & (axis[order] <= span[1] + slack)]
    if len(inside) < 2:
        shortage = f"{len(inside)} of the 2 cells that are needed"
        raise DataError(
            f"{where} has {shortage}; it goes from {axis.min():.6g} to {axis.max():.6g}. Give a "
            "box as south, north, west, east within it"
        )
    if not np.all(np.diff(axis[inside]) > SAME):
        raise DataError(
            f"{where} has a value twice (0 and 360 degrees are the same). Remove one"
        )
    return inside


def edges_of(box: Any) -> str:
    """Return the edges of a box as a sentence has them."""
    return " ".join(f"{value:g}" for value in box)


def mean_over_depth(currents: Currents, depth: float) -> Currents:
    """Return the mean of a current from the surface to a depth, m.

    The current is linear between levels, and constant above the first and below the last one.
    Levels that are gaps, as below the sea floor, are left out of the mean.
    """
    z = currents.depth
    if not z.size > 1:
        raise DataError(f"{currents.source}: has one level. Leave depth (--depth) out")
    limits = np.unique([0.0, *z[z < depth], min(depth, z[-1])])
    hats = [np.interp(limits, z, row) for row in np.eye(z.size)]
    weights = trapezoid(hats, limits)[:, None, None] * currents.measured
    with np.errstate(invalid="ignore"):  # 0/0 where all levels are gaps
        u, v = (
            (weights * np.nan_to_num(w)).sum(axis=1) / weights.sum(axis=1)
            for w in (currents.u, currents.v)
        )
    note = f"u and v are means from the surface to {limits[-1]:g} m, of {z.size} levels"
    return replace(currents, depth=np.zeros(1), u=u, v=v, notes=(*currents.notes, note))


def missing_steps(time: np.ndarray) -> np.ndarray:
    """Return how many steps are missing in each interval between increasing steps.

    >>> missing_steps(np.array([0.0, 6.0, 12.0, 78.0, 84.0])).tolist()
    [0, 0, 10, 0]
    >>> missing_steps(np.array([0.0, 1.0, 2.0, 5.0, 8.0, 11.0])).tolist()
    [0, 0, 0, 0, 0]
    """
    steps = np.diff(time)
    missing = np.zeros(len(steps), int)
    for k, step in enumerate(steps):
        neighbours = np.concatenate([steps[max(k - 2, 0) : k], steps[k + 1 : k + 3]])
        if neighbours.size > 0 and step > GAP * np.median(neighbours):
            missing[k] = round(step / np.median(neighbours)) - 1
    return missing


def with_all_steps(currents: Currents) -> Currents:
    """Return a current on one level with the steps that are missing, as gaps."""
    missing = missing_steps(currents.time)
    if missing.sum() > len(currents.time):
        where = currents.time[np.argmax(missing)]
        raise DataError(
            f"{missing.sum()} steps are missing, most behind {where:.6g} h. Cut there"
        )
    rows = np.concatenate([[0], np.cumsum(1 + missing)])
    dates = np.interp(np.arange(rows[-1] + 1), rows, currents.dates.astype(float))
    u, v = (
        np.full((len(dates), *w.shape[1:]), np.nan) for w in (currents.u, currents.v)
    )
    u[rows], v[rows] = currents.u, currents.v
    return replace(currents, dates=dates.astype(currents.dates.dtype), u=u, v=v)


def concatenated(path: str, files: list[Currents]) -> Currents:
    """Return one current of several on one grid, each with steps of its own."""
    template, nothing = files[0], f"{path}: u and v have no step in common"
    for file in files:
        for name in ("lat", "lon", "depth"):
            if not np.array_equal(
                getattr(file, name), getattr(template, name), equal_nan=True
            ):
                raise DataError(
                    f"{path}: {file.source} has another {name} than {template.source}"
                )
    steps = np.unique(np.concatenate([file.dates for file in files]))
    if len(steps) < 2:
        raise DataError(f"{path}: has 1 of the 2 required steps")
    u, v = (_component(path, files, key, steps) for key in "uv")
    has_u, has_v = (np.isfinite(w).any(axis=tuple(range(1, w.ndim))) for w in (u, v))
    lone_steps = int((has_u != has_v).sum())
    mark_gaps(u, v, ("u", "v"), nothing)
    notes = [note for file in files for note in file.notes]
    if lone_steps:
        notes.append(f"{lone_steps} steps have values of u or v alone: left out")
    return replace(
        template,
        dates=steps,
        u=u,
        v=v,
        source=shown_name(Path(path)),
        notes=_counted(notes),
    )


def _component(
    path: str, files: list[Currents], key: str, steps: np.ndarray
) -> np.ndarray:
    """Return u or v of files at steps; of a step that two files have, the later file counts."""
    values = np.full((len(steps), *files[0].u.shape[1:]), np.nan)
    file_of_step = np.full(len(steps), -1)
    having = [
        k for k, file in enumerate(files) if np.isfinite(getattr(file, key)).any()
    ]
    if not having:
        raise DataError(
            f"{path}: no file has the velocity {key}. Give --u and --v, or names="
        )
    for k in having:
        rows = np.searchsorted(steps, files[k].dates)
        values[rows] = getattr(files[k], key)
        file_of_step[rows] = k
    for k in set(having) - set(file_of_step.tolist()):
        raise DataError(
            f"{path}: each step of {files[k].source} is in a later file too. Correct its times "
            f"(it begins at {files[k].start}), or remove the file"
        )
    return values


def _counted(notes: Iterable[str]) -> tuple[str, ...]:
    """Return notes of files, each once, with the sums of counts such as `9 of 70`.

    >>> _counted(["9 of 70 values", "a level", "1 of 30 values", "a level"])
    ('10 of 100 values', 'a level')
    """
    counts: dict[str, np.ndarray] = {}
    for note in notes:
        match, kind = COUNT.match(note), COUNT.sub("", note)
        count = np.array(match.groups() if match else (0, 0), int)
        counts[kind] = counts.get(kind, 0) + count
    return tuple(
        f"{part} of {total}{kind}" if total else kind
        for kind, (part, total) in counts.items()
    )
