"""Confirmation: a new record is compared with its function before it is used.

Points are drawn around the times, states and inputs of the caller (`drawn_around`), on both sides
of each condition and next to its threshold (`record.both_sides`), with the block's parameters and
with others.  If Python gives another number at one of them, the record is not used, and a sentence
says which number, at which point, and both values.

A record may also be a function in another form: machine code, C or SymPy's expressions.  Both give
a row of numbers at each point; callers choose the points, and the words for a difference.  Two
numbers differ if

    |record - function| > relative |function| + of_largest max |function| of the row

and the error is above `least`.  An infinite number equals itself alone, and NaN equals NaN.
"""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from threading import local
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray

from ..record.both_sides import (
    MOST_CONDITIONS,
    compared_numbers,
    draws,
    points_on_both_sides,
)
from ..record.graph import Record
from ..record.unread import reading_on
from ..trace.arrays import Tape
from ..trace.isolation import isolated

# least and largest of other parameters, relative to the block's own
FACTORS = (0.8, 1.25)
TIMES = 0.0, 10.0  # without a caller
MOVED = 1e-13  # relative: more than rounding, less than the distance from a threshold
SHOWN = 6  # numbers of a point in a sentence
NONE = np.zeros(0)
_caller = local()


# --- differences of numbers ---------------------------------------------------------------------


class Tolerance(NamedTuple):
    """Largest error of a number that is no difference."""

    relative: float = 0.0
    of_largest: float = 0.0  # relative to the largest finite number of the row
    least: float = 0.0


# rounding of terms that cancel, not another execution path
RECORD = Tolerance(relative=1e-7, of_largest=1e-10)
EXACT = Tolerance()


def differences(
    record: Iterable[ndarray],
    function: Iterable[ndarray | None],
    tolerance: Tolerance = RECORD,
) -> Iterator[tuple[int, ndarray, ndarray]]:
    """Yield points by number, which numbers differ there, and those of the function.

    A row of the function is None to skip a point.
    """
    for point, (row, expected) in enumerate(zip(record, function, strict=True)):
        if expected is not None:
            is_different = differ(row, expected, tolerance)
            if is_different.any():
                yield point, is_different, expected


@np.errstate(invalid="ignore")  # of differences of infinite numbers
def differ(record: Any, function: Any, tolerance: Tolerance = RECORD) -> ndarray:
    """Return which numbers differ; all if shapes differ."""
    relative, of_largest, least = tolerance
    if np.shape(record) != np.shape(function):
        return np.ones(1, dtype=bool)
    error = np.abs(record - function)
    size = np.abs(function)
    is_close = error <= relative * size
    if is_close.all():
        return ~is_close
    largest = size.max(initial=0.0, where=size < np.inf)
    is_close |= error <= np.maximum(relative * size + of_largest * largest, least)
    both_nan = np.isnan(record) & np.isnan(function)
    return ~(is_close | (record == function) | both_nan)


# --- a new record -------------------------------------------------------------------------------


@contextmanager
def drawn_around(times: Any, states: Any, inputs: Any) -> Iterator[None]:
    """Confirm the records that this thread makes around these numbers."""
    before = getattr(_caller, "numbers", None)
    _caller.numbers = times, states, inputs
    try:
        yield
    finally:
        _caller.numbers = before


def _flat(values: Any) -> np.ndarray:
    """Return numbers, which may be arrays in a list, as a vector; none if they are no numbers."""
    values = values if isinstance(values, list | tuple) else [values]
    try:
        arrays = [np.ravel(value) for value in values if value is not None]
        vector = np.concatenate([NONE, *arrays])
    except Exception:  # of a user's object; the run itself says more
        vector = NONE
    return vector[np.isfinite(vector)] if vector.dtype == float else NONE


@dataclass(frozen=True)
class Confirmation:
    """A new record of a block's function.

    `conditions` is the record of its comparisons; `free` are the parameters for any value of which
    the record holds.
    """

    block: Any
    role: str
    record: Record
    conditions: Record
    free: tuple[str, ...]

    def difference(self) -> str:
        """Return a sentence on a number that Python gives otherwise than the record, or ""."""
        random = np.random.default_rng(0)
        own = self.block.parameters
        choices = [own]
        if self.free:
            factors = random.uniform(*FACTORS, len(self.free))
            choices.append(self._changed(own, factors))
        with isolated(), reading_on(Tape()), np.errstate(all="ignore"):
            for parameters in choices:
                points = self._points(parameters, random)
                if sentence := self._difference_at(points, parameters):
                    return sentence
        return ""

    def _changed(self, parameters: Any, factors: np.ndarray) -> Any:
        """Return the parameters, the free ones times these factors."""
        values = {
            name: getattr(parameters, name) * factor
            for name, factor in zip(self.free, factors, strict=True)
        }
        return parameters._replace(**values)

    def _points(self, parameters: Any, random: np.random.Generator) -> np.ndarray:
        """Return points to compare, a column each: time, states, inputs."""
        of_caller = getattr(_caller, "numbers", None) or [None] * 3
        times, *vectors = map(_flat, of_caller)
        sizes = self.block.nstates or 0, self.block.ninputs or 0
        centre = [np.zeros(1)]
        numbers: list[Any] = [compared_numbers(self.conditions)]
        numbers += map(np.ravel, parameters)
        for vector, size in zip(vectors, sizes, strict=True):
            centre.append(vector if len(vector) == size else np.zeros(size))
            numbers.append([vector.min(), vector.max()] if len(vector) else [])
        points = draws(np.concatenate(centre), np.concatenate(numbers), random)
        spans = np.array([(times.min(), times.max()) if len(times) else TIMES, TIMES])
        count = points.shape[1]
        begin, end = np.resize(spans, (count, 2)).T
        is_scaled = np.arange(count) % 4 == 3  # as states are, to pass thresholds
        points[0] = np.where(is_scaled, np.abs(points[0]), random.uniform(begin, end))

        def truths_at(columns: np.ndarray) -> np.ndarray:
            """Return the conditions, elements of arrays one by one, at points."""
            values = self._evaluated(self.conditions, columns, parameters)
            return values[:MOST_CONDITIONS] != 0.0

        return points_on_both_sides(points, truths_at)

    def _split(self, points: Any) -> tuple[Any, Any, Any]:
        """Return time, states and inputs of points."""
        n = self.block.nstates or 0
        return points[0], points[1 : 1 + n], points[1 + n :]

    def _evaluated(
        self, record: Record, points: np.ndarray, parameters: Any
    ) -> np.ndarray:
        """Return the outputs of a record at points."""
        return self.block.on_arrays(record, *self._split(points), parameters)

    def _difference_at(self, points: np.ndarray, parameters: Any) -> str:
        """Return a sentence on the first point at which the record differs from Python, or ""."""
        traced = self._evaluated(self.record, points, parameters)
        in_python = (self._in_python(p, parameters, len(traced)) for p in points.T)
        for k, is_different, expected in differences(traced.T, in_python):
            values = traced[:, k]
            is_finite = np.isfinite(values)
            if np.isnan(expected).all() and not is_finite.all():  # the function raises
                continue
            noise = self._noise(expected, points[:, k], parameters)
            is_different &= is_finite | np.isfinite(expected)
            is_different &= ~(np.abs(expected - values) <= noise)
            for row in np.flatnonzero(is_different)[:1]:
                return self._sentence(row, values[row], expected[row], points[:, k])
        return ""

    @np.errstate(all="ignore")
    def _in_python(
        self, point: np.ndarray, parameters: Any, size: int
    ) -> np.ndarray | None:
        """Return what the function gives at a point, NaN where it raises.

        Return None for errors of operations, such as 1 / 0, of which the record has a value.
        """
        t, x, u = self._split(point)
        t = float(t)  # as a run calls it: 1 / 0.0 raises
        p = self.block.parameters_at(t, parameters)
        try:
            return self.block._evaluate(self.role, size, t, x.copy(), u.copy(), p)
        except (ArithmeticError, ValueError):
            return None
        except (Exception, SystemExit):
            return np.full(size, np.nan)

    def _noise(
        self, expected: np.ndarray, point: np.ndarray, parameters: Any
    ) -> np.ndarray:
        """Return rounding errors where terms cancel: changes next to a point, a hundredfold."""
        random = np.random.default_rng(1)
        typical = np.abs(point[1:]).max(initial=0.0) or 1.0
        noise = np.zeros(len(expected))
        for _ in range(3):
            steps = MOVED * random.standard_normal(len(point) + len(self.free))
            moved = point + (np.abs(point) + typical) * steps[: len(point)]
            changed = self._changed(parameters, 1.0 + steps[len(point) :])
            values = self._in_python(moved, changed, len(expected))
            if values is not None:
                noise = np.fmax(noise, np.abs(values - expected))
        return 100.0 * noise

    def _sentence(self, k: int, traced: float, expected: float, point: Any) -> str:
        """Return the sentence on a number that differs."""
        is_output = self.role == "output"
        labels = self.block.output_labels if is_output else self.block.state_labels
        name = "distance" if self.role == "guard" else labels[k]
        t, x, u = self._split(point)
        return (
            f"{name} is {traced:.9g} as traced and {expected:.9g} in Python, at "
            f"t = {t:.9g}, x = {_row(x)}, u = {_row(u)}"
        )


def _row(values: np.ndarray) -> str:
    """Return numbers for a sentence."""
    texts = [f"{value:.9g}" for value in values[:SHOWN]]
    return f"[{', '.join(texts)}{', ...' if len(values) > SHOWN else ''}]"
