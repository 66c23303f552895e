"""Confirmation: a new record is compared with its function before it is used.

Points are drawn around the times, states and inputs of the caller (`drawn_around`), on both sides
of each condition and next to its threshold (`record.both_sides`), with the block's parameters and
with others.  If Python gives another number at one of them, the record is not used, and a sentence
says which number, at which point, and both values.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from threading import local
from typing import Any

import numpy as np

from ..record.both_sides import (
    MOST_CONDITIONS,
    compared_numbers,
    draws,
    points_on_both_sides,
)
from ..record.graph import Record
from .arrays import Tape, reading_on
from .isolation import isolated
from .on_arrays import record_on_arrays

CLOSE = 1e-7  # relative: rounding of terms that cancel, not another execution path
FACTORS = (
    0.8,
    1.25,
)  # least and largest of other parameters, relative to the block's own
TIMES = 0.0, 10.0  # without a caller
MOVED = 1e-13  # relative: more than rounding, less than the distance from a threshold
SHOWN = 6  # numbers of a point in a sentence
_caller = local()


@contextmanager
def drawn_around(times: Any, states: Any, inputs: Any) -> Iterator[None]:
    """Confirm the records that this thread makes around these numbers."""
    before = getattr(_caller, "numbers", None)
    _caller.numbers = [*map(_flat, (times, states, inputs))]
    try:
        yield
    finally:
        _caller.numbers = before


def _flat(values: Any) -> np.ndarray:
    """Return numbers, which may be arrays in a list, as a vector; none if they are no numbers."""
    values = values if isinstance(values, list | tuple) else [values]
    try:
        arrays = [np.ravel(np.asarray(v, float)) for v in values if v is not None]
    except (TypeError, ValueError):  # of which the run itself says more
        arrays = []
    numbers = np.concatenate([np.zeros(0), *arrays])
    return numbers[np.isfinite(numbers)]


def difference(
    block: Any, role: str, record: Record, conditions: Record, pinned: frozenset[str]
) -> str:
    """Return a sentence on a number that Python gives otherwise than a record; "" for none.

    Parameters that are `pinned`, or whole, stay as they are: the record holds for these alone.
    """
    random = np.random.default_rng(0)
    values = block.parameters._asdict()
    as_given = {**values, **getattr(block, "_params", {})}
    changed = {
        name: value * random.uniform(*FACTORS)
        for name, value in values.items()
        if name not in (*pinned, "interval")
        and not isinstance(as_given[name], int | np.integer)
    }
    choices = [block.parameters]
    if changed:
        choices.append(block.parameters._replace(**changed))
    with isolated(), reading_on(Tape()), np.errstate(all="ignore"):
        for parameters in choices:
            points = _points(block, conditions, parameters, random)
            sentence = _difference_at(block, role, record, points, parameters)
            if sentence:
                return sentence
    return ""


def _points(
    block: Any, conditions: Record, parameters: Any, random: np.random.Generator
) -> np.ndarray:
    """Return points to compare, a column each: time, states, inputs."""
    times, *vectors = getattr(_caller, "numbers", None) or [np.zeros(0)] * 3
    centre = [np.zeros(1)]
    numbers = [compared_numbers(conditions), *map(np.ravel, parameters)]
    for vector, size in zip(vectors, _sizes(block), strict=True):
        centre.append(vector if len(vector) == size else np.zeros(size))
        numbers.append([vector.min(), vector.max()] if len(vector) else [])
    points = draws(np.concatenate(centre), np.concatenate(numbers), random)
    span = (times.min(), times.max()) if len(times) else TIMES
    points[0] = random.uniform(*span, points.shape[1])

    def truths_at(columns: np.ndarray) -> np.ndarray:
        """Return the conditions, elements of arrays one by one, at points."""
        values = _evaluated(block, conditions, columns, parameters)
        return values[:MOST_CONDITIONS] != 0.0

    return points_on_both_sides(points, truths_at)


def _sizes(block: Any) -> tuple[int, int]:
    return block.nstates or 0, block.ninputs or 0


def _evaluated(
    block: Any, record: Record, points: np.ndarray, parameters: Any
) -> np.ndarray:
    """Return the outputs of a record at points."""
    n, _ = _sizes(block)
    t, x, u = points[0], points[1 : 1 + n], points[1 + n :]
    if block.breakpoints_function is not None:
        intervals = [block.parameters_at(time, parameters).interval for time in t]
        parameters = parameters._replace(interval=np.array(intervals))
    return record_on_arrays(block, record, t, x, u, parameters)


def _difference_at(
    block: Any, role: str, record: Record, points: np.ndarray, parameters: Any
) -> str:
    """Return a sentence on the first point at which a record differs from its function."""
    traced = _evaluated(block, record, points, parameters)
    for point, values in zip(points.T, traced.T, strict=True):
        expected = _in_python(block, role, len(values), point, parameters)
        if (
            expected is None
        ):  # the error of an operation, of which the record has a number
            continue
        finite = np.isfinite(expected)
        size = np.abs(expected)
        largest = size[finite].max(initial=0.0)
        agrees = np.abs(expected - values) <= CLOSE * (size + 1e-3 * largest)
        agrees |= ~finite & ~np.isfinite(values)
        if agrees.all() or (np.isnan(expected).all() and not np.isfinite(values).all()):
            continue
        noise = _noise(block, role, expected, point, parameters)
        for k in np.flatnonzero(~agrees & ~(np.abs(expected - values) <= noise))[:1]:
            labels = block.output_labels if role == "output" else block.state_labels
            name = "distance" if role == "guard" else labels[k]
            n, _ = _sizes(block)
            return (
                f"{name} is {values[k]:.9g} as traced and {expected[k]:.9g} in Python, at "
                f"t = {point[0]:.9g}, x = {_row(point[1 : 1 + n])}, u = {_row(point[1 + n :])}"
            )
    return ""


def _in_python(
    block: Any, role: str, size: int, point: np.ndarray, parameters: Any
) -> np.ndarray | None:
    """Return what a function gives at a point: NaN where it raises; None for errors of numbers."""
    n, _ = _sizes(block)
    t, x, u = point[0], point[1 : 1 + n].copy(), point[1 + n :].copy()
    try:
        return block._evaluate(role, size, t, x, u, block.parameters_at(t, parameters))
    except (ArithmeticError, ValueError):
        return None
    except (Exception, SystemExit):
        return np.full(size, np.nan)


def _noise(
    block: Any, role: str, expected: np.ndarray, point: np.ndarray, parameters: Any
) -> np.ndarray:
    """Return the rounding errors that differences of terms have at a point, and more."""
    random = np.random.default_rng(1)
    typical = np.abs(point[1:]).max(initial=0.0) or 1.0
    noise = np.zeros(len(expected))
    for _ in range(3):
        moved = point + MOVED * (np.abs(point) + typical) * random.standard_normal(
            len(point)
        )
        values = _in_python(block, role, len(expected), moved, parameters)
        if values is not None:
            noise = np.fmax(noise, np.abs(values - expected))
    return 100.0 * noise


def _row(values: np.ndarray) -> str:
    """Return numbers for a sentence."""
    texts = [f"{value:.9g}" for value in values[:SHOWN]]
    return f"[{', '.join(texts)}{', ...' if len(values) > SHOWN else ''}]"
