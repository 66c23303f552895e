"""Labelled values: numbers with names and times, of dicts, pandas, xarray and responses.

`labelled` reads any of them.  Labels decide, never positions:

    dict, xarray.Dataset, response     a value for each name, with times of its own
    dimension or column time, or t     times of the samples
    dates, timedelta                   times of the samples, in the unit of the run's time
    decimal numbers of a table         times of the samples, if its index has no other name
    whole numbers of a table           times of the samples if they are those of the run
    no labels, dimension time          times of the run, if there are as many samples
    other numbers                      the order of signals, counted from 0; of the paper's axis
                                       and basis from 1
    texts                              names of signals
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from datetime import date
from typing import Any, NamedTuple

import control
import numpy as np

from .arguments import attribute_of, check_known, finite, has, numbers
from .errors import ArgumentError, SimulationError
from .units import SECONDS, short_unit

TIME = "time", "t"
COUNTED_FROM_1 = "axis", "basis"  # dimensions of the paper
SECOND = np.timedelta64(1, "s")


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
        check_known(argument, self.names, labels)
        check_complete(argument, labels, self.names, self.names)
        return self.values[[self.names.index(label) for label in labels]]


class Clock:
    """Reader of labels that are times; a run's times are numbers in a unit.

    `at` has the times given, in this unit; samples without labels are at these.  Dates count from
    the first time given if that is a date, otherwise from the first date of the samples, at which
    all of them must begin.
    """

    def __init__(self, timepts: Any, unit: str | None):
        timepts = attribute_of(timepts, "t", timepts)  # of a response
        kinds = {*map(type, timepts)} if isinstance(timepts, list | tuple) else ()
        if kinds and all(issubclass(kind, date | np.datetime64) for kind in kinds):
            timepts = np.array(timepts, "M8")
        timepts_unit = short_unit(unit_of(timepts))
        self.unit = unit or (timepts_unit if timepts_unit in SECONDS else "s")
        self.check_unit("timepts", timepts_unit)
        self.zero: Any = None  # the date of t = 0; 0 if times are numbers
        labels = np.atleast_1d(timepts if has(timepts, "dtype") else 0)
        self.has_zero = labels.dtype.kind == "M"
        if labels.size and labels.dtype.kind in "mM":
            timepts = self.numbers("timepts", labels)
        self.at = np.atleast_1d(finite("timepts", timepts))

    def numbers(self, argument: str, labels: np.ndarray) -> np.ndarray:
        """Return times as numbers."""
        begin = labels[0] if labels.dtype.kind == "M" else 0
        if self.zero is None:
            self.zero = begin
        if isinstance(begin, int) is not isinstance(self.zero, int):
            raise SimulationError(
                f"{argument}: dates and numbers are given as times. Give one kind"
            )
        if begin != self.zero and not self.has_zero:
            raise SimulationError(
                f"{argument}: begins at {begin}, other data at {self.zero}. "
                "Give timepts as dates, of which the first is t = 0"
            )
        if labels.dtype.kind == "M":
            labels = labels - self.zero
        if labels.dtype.kind == "m":
            labels = labels / SECOND / SECONDS[self.unit]
        return labels.astype(float)

    def check_unit(self, argument: str, unit: str) -> None:
        """Refuse times in another unit than the run's."""
        if unit and short_unit(unit) != self.unit:
            raise ArgumentError(
                f"{argument}: its times are in '{unit}', those of the run in '{self.unit}'. "
                "Convert one of them"
            )

    def read(
        self, argument: str, labels: np.ndarray, unit: str = ""
    ) -> tuple[np.ndarray, slice]:
        """Return the times of samples as increasing numbers, and the order of their samples."""
        self.check_unit(argument, unit)
        if not len(labels) or labels.dtype.kind not in "iufmM":
            raise ArgumentError(
                f"{argument}: its times must be numbers, or dates without a time zone: "
                "datetime64, not texts. Convert them by pandas.to_datetime"
            )
        order = slice(None, None, -1 if labels[0] > labels[-1] else 1)
        labels = labels[order]
        if not (np.isfinite(labels).all() and (labels[1:] >= labels[:-1]).all()):
            raise SimulationError(f"{argument}: its times must be finite and in order")
        return self.numbers(argument, labels), order


def check_complete(
    argument: str, labels: Iterable[str], present: Collection, names: Iterable
) -> None:
    """Refuse data of some names in which a label is not present."""
    for label in labels:
        if label not in present:
            raise SimulationError(
                f"{argument}: has no signal '{label}', but {', '.join(map(str, names)) or 'none'}. "
                f"Give a dict by name, {{'{label}': values}}"
            )


def unlabelled(argument: str, value: Any) -> np.ndarray:
    """Return an array of numbers; refuse labels, which it would lose."""
    if axes_of(value):
        raise ArgumentError(
            f"{argument}: must be an array without labels. Give .to_numpy()"
        )
    if isinstance(value, list | tuple):
        value = [unlabelled(argument, item) for item in value]
    return numbers(argument, value)


def labelled(argument: str, value: Any, clock: Clock | None = None) -> Any:
    """Return values with names as a dict, other rows as a list of `Labelled`, arrays as they are.

    Samples are read by a clock; values are of one time without, and rows are then one vector.
    """
    if isinstance(value, control.TimeResponseData):
        return _signals_of(argument, value, clock)
    if has(value, "columns") and len(value):
        for name, cell in zip(value.columns, value.iloc[0], strict=True):
            if isinstance(cell, str):
                raise ArgumentError(
                    f"{argument}: column {name!r} has texts. Give numbers"
                )
    kind = getattr(attribute_of(value, "dtype"), "kind", "")
    if kind == "O" and has(value, "iloc") and any(map(np.ndim, value)):
        value = value.to_dict()  # a Series of rows by name
    if isinstance(value, Mapping):
        return {
            name: _read(f"{argument}['{name}']", inner, clock)
            for name, inner in value.items()
        }
    if isinstance(value, list | tuple):
        if all(map(np.isscalar, value)):
            return numbers(argument, value)
        rows = [_read(argument, row, clock) for row in value]
        if any(row.names for row in rows):
            raise ArgumentError(
                f"{argument}: is a list of values with names. Give a dict by name"
            )
        if clock is None:
            return np.concatenate([row.values.ravel() for row in rows])
        return rows
    if axes_of(value) is None:
        return value
    read = _read(argument, value, clock)
    if read.names is None:
        return read.values if clock is None else [read]
    named = zip(read.names, read.values, strict=True)
    return {name: read._replace(values=row, names=None) for name, row in named}


def own_times(signals: Mapping[Any, Labelled]) -> np.ndarray:
    """Return all times of labelled values, in order."""
    times = [row.times for row in signals.values() if row.times is not None]
    return np.unique(np.concatenate([[], *times]))


def rounding(times: np.ndarray) -> float:
    """Return a few units in the last place of times, which are equal if they differ by less."""
    return 4 * np.spacing(np.abs(times).max())


def is_within(times: np.ndarray, own: np.ndarray) -> bool:
    """Return whether times are inside of others, to rounding and 1e-9 of their span."""
    margin = rounding(own) + 1e-9 * (times[-1] - times[0])
    return bool(own[0] - margin <= times[0] and times[-1] <= own[-1] + margin)


def unit_of(value: Any) -> str:
    """Return the unit of a labelled value, "" for none."""
    return str(attribute_of(value, "attrs", {}).get("units", ""))


def axes_of(value: Any) -> list[tuple[Any, Any, str]] | None:
    """Return name, labels and unit of each dimension of an array of xarray or pandas.

    A dimension of dates is called time.
    """
    coordinates = attribute_of(value, "coords")
    if coordinates is not None:
        return [_axis_of(coordinates, dim) for dim in value.dims]
    if attribute_of(value, "iloc") is None:
        return None
    axes = []
    for index in value.axes:
        labels, name = index.to_numpy(), index.name
        kind = labels.dtype.kind
        if kind in "mM" or (name is None and kind == "f"):
            name = TIME[0]
        elif repr(index) == f"RangeIndex(start=0, stop={len(index)}, step=1)":
            labels = None  # of a table that was given no index
        axes.append((name, labels, ""))
    return axes


def _axis_of(coordinates: Any, dim: Any) -> tuple[Any, Any, str]:
    """Return name, labels and unit of a dimension of xarray: of times or texts before numbers."""

    def rank(name: Any) -> tuple[bool, bool, bool]:
        kind = coordinates[name].dtype.kind
        return name not in TIME, kind not in "mMOU", name != dim

    for name in sorted(coordinates, key=rank):  # those that are given
        labels = coordinates[name]
        if labels.dims == (dim,):
            name = TIME[0] if labels.dtype.kind in "mM" else name
            return name, labels.values, unit_of(labels)
    return dim, None, ""


def _read(argument: str, value: Any, clock: Clock | None) -> Labelled:
    """Return a value with its labels: names first, then signals by number, samples last."""
    is_table = attribute_of(value, "iloc") is not None
    if is_table and TIME[0] in getattr(value, "columns", ()):
        value = value.set_index(TIME[0])
    axes = axes_of(value)
    if axes is None:
        return Labelled(unlabelled(argument, value))
    array = numbers(argument, value.to_numpy())
    times = names = labels = None
    ranks = []  # of the dimensions
    for k, (dim, labels, unit) in enumerate(axes):
        kind = "" if labels is None else labels.dtype.kind
        is_index = is_table and clock is not None and kind in ("i", "u")
        if clock and is_index and np.array_equal(labels, clock.at):
            dim = TIME[0]
        texts = kind and all(isinstance(label, str) for label in labels)
        are_dates = texts and "".join(labels)[:4].isdigit()
        if dim in TIME or are_dates:
            ranks.append(2)
            if clock is None:
                raise SimulationError(
                    f"{argument}: has values over time. Give those of one time"
                )
            if labels is not None:
                times, order = clock.read(argument, labels, unit)
                array = array[(*[slice(None)] * k, order)]
            elif array.shape[k] != len(clock.at):
                raise SimulationError(
                    f"{argument}: has {array.shape[k]} samples along {dim} without times; timepts "
                    f"has {len(clock.at)}. Give {dim} a coordinate"
                )
        elif texts:
            ranks.append(0)
            names = labels.tolist()
            if len({*names}) < len(names):
                raise ArgumentError(f"{argument}: a label is given twice")
        else:
            ranks.append(1)
            if labels is not None:
                signals = None if is_index or dim == "member" else _order(dim, labels)
                if signals is None:
                    raise ArgumentError(
                        f"{argument}: labels of {dim or 'its index'} are no names and need not "
                        "count signals from 0. If "
                        "they are times, call them time, without a time zone; else give .to_numpy()"
                    )
                array = np.take(array, signals, k)
    if len({*ranks}) < len(ranks):
        raise ArgumentError(
            f"{argument}: has several dimensions of signals or of times. Give one of each"
        )
    array = array.transpose(sorted(range(array.ndim), key=ranks.__getitem__))
    if clock is not None and ranks == [1] and labels is not None:
        array = array[:, None]  # one time
    return Labelled(array, times, names, unit_of(value))


def _order(dim: Any, labels: np.ndarray) -> np.ndarray | None:
    """Return the order of labels that count signals, None of others."""
    if labels.dtype.kind not in "iuf":
        return None
    order = np.argsort(labels)
    counted = labels[order] - int(dim in COUNTED_FROM_1)
    return order if np.array_equal(counted, range(len(labels))) else None


def _signals_of(
    argument: str, response: Any, clock: Clock | None
) -> dict[str, Labelled]:
    """Return the signals of a response with one trace, by name."""
    if clock is None:
        raise SimulationError(f"{argument}: is a response. Give values of one time")
    times, order = clock.read(argument, np.asarray(response.time))
    signals = {}
    for labels, values in (
        (response.input_labels, response.u),
        (response.output_labels, response.y),
    ):
        if labels is None or values is None:
            continue
        if values.ndim == 3 and values.shape[1] != 1:
            raise SimulationError(
                f"{argument}: the response has {values.shape[1]} traces. Give one: "
                "control.TimeResponseData(r.time, r.y[:, 0], output_labels=r.output_labels, "
                "issiso=False)"
            )
        for label, row in zip(labels, values, strict=True):
            signals[label] = Labelled(numbers(argument, row.ravel()[order]), times)
    return signals
