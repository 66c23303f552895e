"""What the plots of a replay draw: a row for each dive, of a Replay or of its dataset."""

from collections.abc import Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any, NamedTuple, Union

import numpy as np

from ..errors import DataError
from .replay import Replay
from .rows import rows
from .step import FLOW_MODEL, MODELS, ellipse
from .wording import utc

if TYPE_CHECKING:
    import xarray

Source = Union[Replay, "xarray.Dataset"]
SECOND, EPOCH = np.timedelta64(1, "s"), np.datetime64("1970-01-01")


class Plotted(NamedTuple):
    """A replay with one dive at least, as plots need it."""

    vehicle: str
    models: tuple[str, ...]
    learns_speed: bool
    rows: list[dict[str, Any]]


def plotted(source: Source) -> Plotted:
    """Return what plots draw; refuse what is no replay, or has no dive."""
    if isinstance(source, Replay):
        if not source.steps:
            raise DataError("the replay has no dive yet; feed one, as Replay.step does")
        found = rows(source)
        for row, step in zip(found, source.steps, strict=True):
            row |= {"file_current_east": step.dive.dac_east}
            row |= {"file_current_north": step.dive.dac_north}
        vehicle = source.steps[-1].dive.vehicle or "glider"
        return Plotted(vehicle, source.models, source.model.learn_speed, found)
    if "dive" not in getattr(source, "dims", ()) or "clpe_adaptive" not in source:
        raise DataError(
            f"{type(source).__name__}: is no replay; clpt.replay.replay_dives(dives) gives one, "
            "`clpt replay` writes its dataset, replay.nc"
        )
    models = tuple(name for name in (*MODELS, FLOW_MODEL) if f"clpe_{name}" in source)
    learns = "speed_factor" in source
    return Plotted(str(source["trajectory"].values), models, learns, _of_dataset(source, models))


def _of_dataset(data: "xarray.Dataset", models: Sequence[str]) -> list[dict[str, Any]]:
    columns = {
        str(name): _listed(values.values)
        for name, values in data.data_vars.items()
        if "dive" in values.dims
    }
    ends = data["time"].values
    if ends.dtype.kind == "M":  # decoded
        ends = (ends - EPOCH) / SECOND
    found = []
    for k, number in enumerate(data["dive"].values.tolist()):
        row = {name: column[k] for name, column in columns.items()}
        east, north, both = (
            row[f"forecast_{name}"] for name in ("variance_east", "variance_north", "covariance")
        )
        long, short, bearing = ellipse(np.array([[east, both], [both, north]]))
        row |= {"ellipse_90_long": long, "ellipse_90_short": short, "ellipse_90_bearing": bearing}
        row |= {"dive": number, "end": utc(float(ends[k])), "anomaly": row["speed_anomaly"] or None}
        row |= {"end_latitude": float(data["latitude"].values[k])}
        row |= {"end_longitude": float(data["longitude"].values[k])}
        row["clpe"] = {name: row[f"clpe_{name}"] for name in models}
        row["speed_factor_error"] = row.get("speed_factor_standard_error")
        found.append(row)
    return found


def _listed(values: np.ndarray) -> list[Any]:
    """Return a column with None for what is not known."""
    if values.dtype.kind != "f":
        return list(values.tolist())
    return [value if isfinite(value) else None for value in values.tolist()]
