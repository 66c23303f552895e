"""Each row of the table of operations: its C99, and its SymPy, give NumPy's numbers."""

import itertools
import math

import numpy as np
import pytest
from engine_runs import (
    COMPOSED,
    TABLE,
    UFUNCS,
    Row,
    compare_backends,
    compiler,
    readings,
)
from recorded_blocks import static
from scipy.special import gamma

import clpt_control as clpt
from clpt_control import lookup

NUMBERS = (-4.0, -2.5, -1.0, -0.3, 0.0, 0.4, 1.0, 3.0, 20.0)
BY_HAND = {  # rows that no ufunc is traced as
    "where": lambda u: np.where(u[0] > u[1], u[0], 2.0 * u[1]),
    "erf": lambda u: math.erf(u[0]),
    "erfc": lambda u: math.erfc(u[0]),
    "tgamma": lambda u: gamma(u[0]),
    "pick": lambda u: lookup([3.0, 5.0, 7.0], np.clip(u[0], -3.0, 2.0)),
    "search": lambda u: np.searchsorted([-1.0, 0.4, 2.0], u[0]),
    "argmin": lambda u: np.argmin(np.stack([u[0], u[1], 0.3])),
}


def functions_of(name):
    """Return the functions of u that are traced as an operation."""
    if name in BY_HAND:
        return [BY_HAND[name]]
    ufuncs = [ufunc for ufunc, kind in UFUNCS.items() if kind == name]
    if name in ("and", "or", "not"):  # of truth values
        return [lambda u, f=f: f(*(u > 0.0)[: f.nin]) for f in ufuncs]
    return [lambda u, f=f: f(*(u[k] for k in range(f.nin))) for f in ufuncs]


def finite(value):
    """Return a number, or one of its own for each infinity and NaN; a sum of all would be NaN."""
    outside = np.where(value > 0.0, 7e9, np.where(value < 0.0, -7e9, 5e9))
    return np.where(np.abs(value) < 1e300, value, outside)


needs_cc = pytest.mark.skipif(not compiler(), reason="no C compiler on this machine")


@needs_cc
def test_each_row_in_c_gives_the_numbers_of_numpy():
    functions = [(name, one) for name in TABLE for one in functions_of(name)]
    assert {name for name, _ in functions} == {*TABLE}

    def outputs(t, x, u, p):
        return [finite(1.0 * one(u)) for _, one in functions]

    in_c = readings(static(outputs, 2, len(functions)))["c"]
    for point in itertools.product(NUMBERS, NUMBERS):
        found = in_c(0.0, [], np.array(point))[1]
        with np.errstate(all="ignore"):
            for (name, one), value in zip(functions, found, strict=True):
                try:
                    wanted = float(one(np.array(point)))
                except ValueError:  # of Python's own function
                    wanted = math.nan
                near = pytest.approx(float(finite(wanted)), rel=1e-13, abs=1e-15)
                assert value == near, (name, point)


def test_each_row_has_slopes_or_is_constant_between_jumps():
    without = {
        name
        for name, row in TABLE.items()
        if not (row.slopes or row.chosen is not None)
    }
    assert {name for name in without if TABLE[name].smoothness < 4} == {"where", "pick"}


@pytest.mark.parametrize("name", [n for n, row in TABLE.items() if not row.exact])
def test_sympy_of_a_row_that_loses_digits_is_its_function(name):
    """`readings` compares NumPy's function in its place."""
    (function,) = functions_of(name)
    block = static(lambda t, x, u, p: [function(u)], 2, 1)
    eq = clpt.equations(block)
    for point in [(0.4, 1.5), (2.0, -0.7), (-0.3, 3.0)]:
        value = eq["y"].xreplace(dict(zip(eq.inputs["u"], point, strict=True)))
        assert float(value) == pytest.approx(
            float(function(np.array(point))), rel=1e-12
        )


def test_a_function_is_an_operation_or_made_of_others():
    assert not {ufunc.__name__ for ufunc in UFUNCS} & COMPOSED.keys()


def test_a_row_without_its_c_is_refused():
    with pytest.raises(TypeError, match="'c'"):
        Row(np.logaddexp, llvm="function")


@needs_cc
def test_a_function_that_c_does_not_have_is_told(monkeypatch):
    row = TABLE["cosh"]
    changed = Row(row.numpy, row.slopes, c="no_such_function", llvm=row.llvm)
    monkeypatch.setitem(TABLE, "cosh", changed)
    block = static(lambda t, x, u, p: np.cosh(u[0]), 1)
    with pytest.raises(clpt.BlockError, match=r"(?s)'c' refuses: .*no_such_function"):
        compare_backends(block)
