"""One record of arrays, read by all, and what blocks of one equation share of it."""

import math

import numpy as np
import pytest
from recorded import as_it_runs, static

from clpt_control.conformance import readings


def test_a_matrix_times_a_vector_is_a_sum_whatever_its_size():
    for n in (3, 40, 400):
        block = static(
            lambda t, x, u, p: p.A @ u, n, n, parameters={"A": np.ones((n, n))}, shapes={}
        )
        kinds = [operation.kind for operation in block.array_record("output").operations]
        assert kinds.count("sum") == 1
        assert len(kinds) < 8


SPECIAL = {  # -> what Python says, worked out by hand
    "a - a of infinity": (lambda t, x, u, p: u[0] - u[0], [math.inf, 0.0, 0.0], math.nan),
    "0 times infinity": (lambda t, x, u, p: 0.0 * u[0], [math.inf, 0.0, 0.0], math.nan),
    "NaN by x == x": (lambda t, x, u, p: np.where(u[0] == u[0], 1.0, 2.0), [math.nan, 0, 0], 2.0),
    "NaN by x != x": (lambda t, x, u, p: 1.0 if u[0] != u[0] else 2.0, [math.nan, 0, 0], 1.0),
    "a zero's sign": (lambda t, x, u, p: np.arctan2(0.0 * u[0], -1.0), [-2.0, 0, 0], -math.pi),
    "a root of math": (lambda t, x, u, p: math.sqrt(u[0]) if u[1] else 1.0, [-1, 1.0, 0], math.nan),
    "-0.0 is not 0.0": (lambda t, x, u, p: 1.0 / (-0.0 * abs(u[0])), [1.0, 0, 0], -math.inf),
}  # fmt: skip


@pytest.mark.parametrize("case", SPECIAL)
def test_special_numbers_are_the_authors(case):
    function, u, wanted = SPECIAL[case]
    block = static(function)
    with np.errstate(all="ignore"):
        found = as_it_runs(block, "output", 0.0, [], u)
    np.testing.assert_array_equal(found, [wanted])


WITHOUT_AXES = {  # NumPy's arrays without axes, and its numbers
    "where": lambda u: np.where(u[0] > 0, u[0], 3.0),
    "where of numbers": lambda u: np.where(u[0] > 0, 1.0, 3.0),
    "array": lambda u: np.array(u[0]),
    "full": lambda u: np.full((), u[0]),
    "zeros like": lambda u: np.zeros_like(u[0]),
    "a copy": lambda u: np.copy(u[0]),
    "shaped": lambda u: u[:1].reshape(()) * np.ones(()),
    "squeezed": lambda u: np.squeeze(2.0 * u[:1]),
    "an ellipsis": lambda u: (2.0 * u)[0, ...],
    "converted": lambda u: np.where(u[0] > 0, u[0], 1.0).astype(float),
    "a sum": np.sum,
    "an element": lambda u: u[0],
    "a product": lambda u: np.dot(u, u),
    "clipped": lambda u: np.clip(u[0], 0.0, 1.0),
}


@pytest.mark.parametrize("kind", WITHOUT_AXES)
def test_an_array_without_axes_is_changed_by_each_name_it_has(kind):
    def written(t, x, u, p):
        a = WITHOUT_AXES[kind](u)
        b = a
        b += u[1]
        c = a
        c *= u[2]
        return [a * 1.0, b * 1.0, c * 1.0]

    block = static(written, 4, 3)
    given = np.array([1.0, 2.0, 3.0, 4.0])
    (found,) = block.array_record("output").values(lambda group, name: given, {})
    np.testing.assert_array_equal(found, written(0.0, [], given, None))


def test_an_argument_that_is_a_place_is_not_the_constant_of_that_number():
    def of(constant):
        return lambda t, x, u, p: np.where(u[0] > 0.0, constant, 3.0)

    records = [static(of(c)).array_record("output") for c in (0.0, -0.0, 1.0, 2.0)]
    records.append(
        static(lambda t, x, u, p: np.where(u[0] > 0.0, u[0], 3.0)).array_record("output")
    )
    assert len(set(records)) == 5
    assert static(of(1.0)).array_record("output") == records[2]


def test_a_number_that_equals_the_place_of_a_value_is_not_it():
    block = static(lambda t, x, u, p: 1.0 if u.b > 0 else u.a, {"a": (), "b": ()}, {"y": ()})
    for b in (-1.0, 1.0):
        asked = [ask(0.0, [], [5.0, b])[1] for ask in readings(block).values()]
        assert asked == [1.0 if b > 0 else 5.0] * 7
