"""Points on both sides of each condition of a record.

    x[0] > 5000 and x[1] < 0.2    ->    draws until each comparison was true and was false,
                                        and points next to each threshold, by bisection

A point is a column of numbers.  Draws have several scales: 0.1 to 3, the magnitudes of the numbers
that the caller has, and those with which the record compares.  Some coordinates are exactly such a
number or 0, as thresholds are.
"""

from collections.abc import Callable, Iterable

import numpy as np

from .graph import Operation, Record, Ref, compact, reached
from .operations import COMPARISONS

CANDIDATES = 256  # draws of which some are taken
MOST_NUMBERS = 2**18  # in all candidates: fewer draws of many coordinates
LEAST, MOST = 8, 64  # draws that are taken
MOST_CONDITIONS = 128
SECTIONS = 32  # of one step of the bisection
NEXT = 1e-9  # distance of a point from a threshold, relative to that between two draws
TOLERANCE = 1e-9
SCALES = (0.1, 0.3, 1.0, 3.0)


def conditions_of(operations: list[Operation], refs: Iterable[Ref]) -> Record:
    """Return the record of the comparisons that values of a record depend on."""
    used = sorted(reached(operations, refs))
    comparisons = [k for k in used if operations[k].kind in COMPARISONS]
    return compact(operations, comparisons[:MOST_CONDITIONS])


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
