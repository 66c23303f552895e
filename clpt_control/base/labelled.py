"""Labelled values: numbers with names and times, of dicts, pandas, xarray and responses.

`labelled` reads any of them.  Labels decide, never positions:

    dict, xarray.Dataset, response     a value for each name, with times of its own
    dimension or column time, or t     times of the samples
    decimal numbers                    times of the samples, but of a single time in order
    whole numbers of a table's index   times if they are those of the run, or called time
    other numbers                      the order of signals
    texts                              names of signals
"""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import control
import numpy as np

from .arguments import attribute_of, numbers
from .errors import ArgumentError, SimulationError

TIME = "time", "t"


class Labelled(NamedTuple):
    """Numbers, samples last, with their times, the names of their rows and their unit."""

    values: np.ndarray
    times: np.ndarray | None = None
    names: list[str] | None = None
    units: str = ""

    def ordered(self, argument: str, labels: Sequence[str]) -> np.ndarray:
        """Return the values in the order of labels; refuse other names."""
        if self.names is None:
            return self.values
        if sorted(self.names) != sorted(labels):
            raise ArgumentError(
                f"{argument}: has the names {', '.join(self.names)}; must be {', '.join(labels)}"
            )
        return self.values[[self.names.index(label) for label in labels]]


def labelled(argument: str, value: Any, at: Any = None) -> Any:
    """Return values with names as a dict, with times alone as `Labelled`, others as they are.

    Samples may be `at` the times of a run, or have their own; values are of one time without.
    """
    if isinstance(value, Labelled):
        return value
    if isinstance(value, control.TimeResponseData):
        value = _signals_of(argument, value)
    elif isinstance(value, Mapping):
        value = {
            name: _read(f"{argument}['{name}']", inner, at)
            for name, inner in value.items()
        }
    elif isinstance(value, list | tuple):
        arrays = [row for row in value if not np.isscalar(row)]
        if not any(isinstance(row, Labelled) or _axes(row) for row in arrays):
            return value
        value = [_read(argument, row, at) for row in value]
        if any(row.names for row in value):
            raise ArgumentError(
                f"{argument}: is a list of values with names. Give a dict by name"
            )
        return value if at is not None else [row.values for row in value]
    elif _axes(value) is not None:
        read = _read(argument, value, at)
        if read.names is None:
            return read.values if read.times is None else read
        rows = zip(read.names, read.values, strict=True)
        return {name: read._replace(values=row, names=None) for name, row in rows}
    return value


def sampled_at(argument: str, value: Any, at: np.ndarray) -> Any:
    """Return a value of which samples without times are at these times."""
    if isinstance(value, control.TimeResponseData):
        return value
    value = labelled(argument, value, at)
    if isinstance(value, dict):
        return {name: sampled_at(argument, row, at) for name, row in value.items()}
    if not isinstance(value, Labelled):
        if isinstance(value, list | tuple) and any(map(np.ndim, value)):
            return [sampled_at(argument, row, at) for row in value]
        if value is None or callable(value):
            return value
        value = Labelled(numbers(argument, value))
    if value.times is None and value.values.shape[-1:] == at.shape:
        return value._replace(times=at)
    return value if value.times is not None or value.values.ndim > 1 else value.values


def _axes(value: Any) -> list[tuple[Any, Any]] | None:
    """Return name and labels of each dimension of an array of xarray or pandas."""
    coordinates = attribute_of(value, "coords")
    if coordinates is not None:
        axes = []
        for dim in value.dims:
            for name in (*TIME, dim):
                if name in coordinates and coordinates[name].dims == (dim,):
                    axes.append((name, coordinates[name].values))
                    break
            else:
                axes.append((dim, None))
        return axes
    if attribute_of(value, "iloc") is None:
        return None
    axes = []
    for index in value.axes:
        labels, name = index.to_numpy(), index.name
        if type(index).__name__ == "RangeIndex" and name not in TIME:
            labels = None if index.start == 0 and index.step == 1 else labels
        axes.append((name, labels))
    return axes


def _read(argument: str, value: Any, at: Any) -> Labelled:
    """Return a value with its labels, signals first and samples last."""
    if isinstance(value, Labelled):
        return value
    is_table = attribute_of(value, "iloc") is not None
    if is_table and TIME[0] in getattr(value, "columns", ()):
        value = value.set_index(TIME[0])
    axes = _axes(value)
    array = numbers(argument, value if axes is None else value.to_numpy())
    times = names = time_axis = name_axis = None
    for k, (dim, labels) in enumerate(axes or ()):
        kind = "" if labels is None else labels.dtype.kind
        if at is not None and kind and kind in "fmM":
            dim = TIME[0]
        if is_table and at is not None and kind and kind in "iu" and dim not in TIME:
            if not np.array_equal(labels, at):
                raise ArgumentError(
                    f"{argument}: its index has whole numbers. Name it time if they are times, or "
                    "give .to_numpy()"
                )
            dim = TIME[0]
        if dim in TIME:
            if time_axis is not None or at is None:
                raise SimulationError(
                    f"{argument}: has values at several times. Give those of one"
                )
            time_axis = k
            if labels is not None:
                times = _checked(argument, labels)
                array = array if np.array_equal(times, labels) else np.flip(array, k)
        elif labels is not None and all(isinstance(label, str) for label in labels):
            names, name_axis = [*map(str, labels)], k
        elif kind and kind in "iuf":
            array = np.take(array, np.argsort(labels, kind="stable"), k)
        elif kind:
            raise ArgumentError(
                f"{argument}: labels of a dimension must be names, or numbers, of one level"
            )
        if labels is not None and dim not in TIME and len({*labels}) < len(labels):
            raise ArgumentError(f"{argument}: a label is given twice")
    order = sorted(range(array.ndim), key=lambda k: (k == time_axis) - (k == name_axis))
    units = attribute_of(value, "attrs", {}).get("units", "")
    return Labelled(array.transpose(order), times, names, units)


def _checked(argument: str, labels: np.ndarray) -> np.ndarray:
    """Return times as increasing numbers."""
    if labels.dtype.kind not in "iuf":
        raise ArgumentError(
            f"{argument}: its times are dates or texts. Give numbers, in the unit of the run's time"
        )
    times = labels.astype(float)
    times = times[::-1] if times[:1] > times[-1:] else times
    if not (np.isfinite(times).all() and (np.diff(times) >= 0).all()):
        raise SimulationError(f"{argument}: its times must be finite and in order")
    return times


def _signals_of(argument: str, response: Any) -> dict[str, Labelled]:
    """Return the signals of a response with one trace, by name."""
    times = np.asarray(response.time, dtype=float)
    signals: dict[str, Labelled] = {}
    for labels, values in (
        (response.input_labels, response.u),
        (response.output_labels, response.y),
    ):
        if values is None or labels is None:
            continue
        values = np.asarray(values, dtype=float)
        if values.ndim == 3 and values.shape[1] != 1:
            raise SimulationError(
                f"{argument}: the response has {values.shape[1]} traces. Give one: "
                "control.TimeResponseData(r.time, r.outputs[:, 0], inputs=r.inputs[:, 0])"
            )
        rows = values.reshape(len(values), -1)
        signals |= {
            label: Labelled(row, times) for label, row in zip(labels, rows, strict=True)
        }
    return signals
