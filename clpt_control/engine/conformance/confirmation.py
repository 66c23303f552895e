"""Confirmation: a new record is compared with its function before it is used.

Points are drawn around the times, states and inputs of the caller (`drawn_around`), with the
block's parameters and with others, until each comparison of the record was true and was false.
Points next to each threshold are found by bisection.  If Python gives another number at one of
them, the record is not used, and a sentence says which number, at which point, and both values.

A point is a column of numbers.  Draws have several scales: 0.1 to 3, the magnitudes of the numbers
that the caller has, and those with which the record compares.  Some coordinates are exactly such a
number or 0, as thresholds are.

A record may also be a function in another form: machine code, C or SymPy's expressions.  Both give
a row of numbers at each point; callers choose the points, and the words for a difference.  Two
numbers differ if

    |record - function| > relative |function| + of_largest max |function| of the row

and the error is above `least`.  An infinite number equals itself alone, and NaN equals NaN.
"""

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from threading import local
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray

from ..record.graph import MOST_CONDITIONS, Record
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


# --- points on both sides of each condition ------------------------------------------------------

CANDIDATES = 256  # draws of which some are taken
MOST_NUMBERS = 2**18  # in all candidates: fewer draws of many coordinates
LEAST, MOST = 8, 64  # draws that are taken
SECTIONS = 32  # of one step of the bisection
NEXT = 1e-9  # distance of a point from a threshold, relative to that between two draws
TOLERANCE = 1e-9
SCALES = (0.1, 0.3, 1.0, 3.0)


def compared_numbers(conditions: Record) -> list[float]:
    """Return the numbers that the conditions contain, without tolerances."""
    return [
        argument
        for operation in conditions.operations
        for argument in operation.arguments
        if type(argument) is float and abs(argument) > TOLERANCE
    ]


def draws(
    centre: np.ndarray, numbers: Iterable[float], random: np.random.Generator
) -> np.ndarray:
    """Return random points, the first of them the centre, around it and around 0."""
    count = int(np.clip(MOST_NUMBERS // len(centre), LEAST, CANDIDATES))
    magnitudes = np.unique(np.abs(np.array([*numbers, *centre], dtype=float)))
    magnitudes = magnitudes[(magnitudes > 0.0) & (magnitudes < np.inf)]
    scales = np.resize(SCALES, count)
    is_of_magnitude = (
        np.arange(count) % 2 * (np.arange(count) >= LEAST) * len(magnitudes) > 0
    )
    if is_of_magnitude.any():
        scales[is_of_magnitude] = random.choice(magnitudes, is_of_magnitude.sum())
    points = random.standard_normal((len(centre), count)) * scales
    points[:, 1::3] += centre[:, None]
    exact = random.choice([0.0, *magnitudes, *-magnitudes], points.shape)
    is_exact = random.random(points.shape) < 0.5
    is_exact[:, np.arange(count) % 4 < 3] = False
    points = np.where(is_exact, exact, points)
    points[:, 0] = centre
    return points


def points_on_both_sides(
    points: np.ndarray, truths_at: Callable[[np.ndarray], np.ndarray]
) -> np.ndarray:
    """Return some of the points, each condition on both sides, and points next to thresholds.

    `truths_at` returns the conditions at points: a row for each condition, a column for each point.
    """
    truths = truths_at(points)
    # 1. draws until each condition was seen on both sides
    chosen = [*range(min(LEAST, points.shape[1]))]
    for truth in (truths, ~truths):
        for row in truth[truth.any(axis=1)]:
            if not row[chosen].any() and len(chosen) < MOST:
                chosen.append(int(np.argmax(row)))
    # 2. points next to a threshold, between two draws on both sides of it
    conditions = np.flatnonzero(truths.any(axis=1) & ~truths.all(axis=1))
    if not len(conditions):
        return points[:, chosen]
    start = points[:, np.argmax(truths[conditions], axis=1)]
    direction = points[:, np.argmin(truths[conditions], axis=1)] - start
    columns = np.arange(len(conditions))
    low = np.zeros(len(columns))  # where the condition holds, as at the start
    high = np.ones(len(columns))
    while np.max(high - low) > NEXT:
        fractions = np.linspace(low, high, SECTIONS + 1)
        candidates = start[:, None] + fractions * direction[:, None]
        shape = len(truths), *fractions.shape
        holds = truths_at(candidates.reshape(len(points), -1)).reshape(shape)
        holds_of_condition = holds[conditions, :, columns].T
        section = np.argmin(
            holds_of_condition[1:], axis=0
        )  # section in which the condition ends to hold
        low, high = fractions[section, columns], fractions[section + 1, columns]
    return np.hstack(
        [points[:, chosen], start + low * direction, start + high * direction]
    )


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
