"""A row of numbers at a computed place, and helpers that SymPy does not look into."""

import math

import numpy as np
import pytest
import sympy
from recorded import as_it_runs, recorded, static

from clpt_control.equations import evaluate, lookup, opaque
from clpt_control.equations.symbolic import expressions


def looked_up(t, x, u, p):
    return lookup(p.values, u[0])


def in_reverse(t, x, u, p):
    return lookup(p.values[::-2], u[0])


def in_signals(t, x, u, p):
    return lookup(u[1:], u[0])


def many_places(t, x, u, p):
    return lookup(p.values, np.floor(u))


@pytest.mark.parametrize("size", [1, 4, 9])
def test_lookup_reads_whole_places_and_is_nan_outside(size):
    table = np.random.default_rng(size).normal(size=size)
    block = static(looked_up, 1, parameters={"values": table})
    for index in range(-size, size):
        for away in (0.0, 0.5 if index >= 0 else -0.5):  # towards zero
            found = as_it_runs(block, "output", 0.0, [], [index + away])
            assert found == [table[index]]
    for index in (size, -size - 1, math.inf, -math.inf, math.nan, 1e300):
        assert math.isnan(recorded(block, "output", 0.0, [], [index])[0])


def test_lookup_in_any_row():
    table = np.array([3.0, 5.0, 7.0])
    assert lookup(table, 1.9) == 5.0
    np.testing.assert_array_equal(lookup(table, [0.0, 2.0, -1.0]), [3.0, 7.0, 7.0])
    as_it_runs(static(in_reverse, 1, parameters={"values": table}), "output", 0.0, [], [1.0])
    as_it_runs(static(in_signals, 4), "output", 0.0, [], [1.0, 5.0, 6.0, 7.0])
    as_it_runs(
        static(many_places, 3, 3, parameters={"values": table}), "output", 0, [], [0, 1.5, 2]
    )


def test_a_table_is_one_operation_whatever_its_length():
    block = static(looked_up, 1, parameters={"values": np.arange(200_000.0)})
    assert len(block.array_record("output").operations) < 6
    assert recorded(block, "output", 0.0, [], [150.5]) == [150.0]


def test_a_tables_index_is_any_number_to_sympy():
    block = static(looked_up, 1, parameters={"values": np.zeros(3)})
    s, row = sympy.Symbol("s"), sympy.symbols("row:3")
    (found,) = expressions(
        block, "output", lambda at, shape, index: s if at[0] == "u" else row[index[0]]
    )
    assert found.func.__name__ == "pick"
    assert found.args == (s, *row)


@opaque
def gust(t, height):
    return np.sin(t) * height


@opaque
def both(a):
    return a + 1.0, 2.0 * a


def windy(t, x, u, p):
    return 2.0 * gust(t, u[0])


def two_at_once(t, x, u, p):
    first, second = both(u[0])
    return [first, second]


def test_an_opaque_helper_is_an_undefined_function_to_sympy():
    t, h = sympy.symbols("t h", real=True)
    block = static(windy, 1)
    (found,) = expressions(block, "output", lambda at, shape, index: t if at[0] == "t" else h)
    (gusts,) = found.atoms(sympy.core.function.AppliedUndef)
    assert "gust" in gusts.func.__name__
    assert gusts.args == (t, h)
    assert found == 2 * gusts
    assert found.diff(h) != 0


def test_an_opaque_helper_is_run_in_every_other_reading():
    assert gust(math.pi / 2, 3.0) == 3.0
    np.testing.assert_allclose(as_it_runs(static(windy, 1), "output", math.pi / 2, [], [3.0]), 6.0)
    found = as_it_runs(static(two_at_once, 1, 2), "output", 0.0, [], [3.0])
    np.testing.assert_array_equal(found, [4.0, 6.0])


def test_a_static_block_at_many_times_and_inputs():
    found = evaluate(static(windy, 1), [0.5, 1.0, 2.0], [[1.0], [2.0], [-3.0]])
    wanted = 2.0 * np.sin([0.5, 1.0, 2.0]) * [1.0, 2.0, -3.0]
    np.testing.assert_allclose(found[:, 0], wanted, rtol=1e-15)
    table = static(looked_up, 1, parameters={"values": [4.0, 5.0]})
    np.testing.assert_array_equal(evaluate(table, 0.0, [[0.0], [1.0], [0.0]]), [[4], [5], [4]])
