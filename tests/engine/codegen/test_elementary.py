"""Elementary functions as machine code: accuracy, special numbers, and choices, of any width."""

import ctypes
import math
from functools import cache
from pathlib import Path

import mpmath
import numpy as np
import pytest
from engine_runs import (
    ELEMENTWISE,
    FUNCTIONS,
    PRIMITIVES,
    Component,
    Machine,
    Nest,
    Program,
    Write,
    print_program,
)
from hypothesis import given, settings
from hypothesis import strategies as st

mpmath.mp.dps = 40
COLUMNS = 8
ITERATIONS = 15  # of a loop: eight at once, then seven with a mask
FORMS = ("scalar", "loop", "lanes")


def printed(name, count, form):
    """A module with an operation of `count` numbers, in one form."""
    lengths = (ITERATIONS,) if form == "loop" else ()
    axes, strides = tuple(range(len(lengths))), (1,) * len(lengths)
    step = ITERATIONS if lengths else 1
    components = [
        Component("load", ("X", k * step, strides, -1), lengths) for k in range(count)
    ]
    arguments = [(k, axes) for k in range(count)]
    if name == "where":
        components.append(Component("lt", tuple(arguments[:2]), lengths))
        arguments[0] = count, axes
    components.append(Component(name, tuple(arguments), lengths))
    write = Write("D", 0, strides, lengths, (len(components) - 1, axes))
    nests = {"f": (Nest(lengths, 0, (write,)),)}
    program = Program(tuple(components), nests, {}, (), 0, 0, 0, ())
    return print_program(program, ("f",), COLUMNS if form == "lanes" else 1)


@cache
def machine(name, count, form):
    """Machine code of an operation of `count` numbers, in one form."""
    made = Machine(
        ["f"], f"test {name} {count} {form}", lambda: printed(name, count, form)
    )
    return made, ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 6)(made.addresses["f"])


def calculated(name, form, *arrays):
    """Call an operation for every number of arrays."""
    _, call = machine(name, len(arrays), form)
    together, size = (
        {"scalar": 1, "loop": ITERATIONS, "lanes": COLUMNS}[form],
        arrays[0].size,
    )
    rows = -(-size // together)
    given = np.array([np.resize(a, (rows, together)) for a in arrays])
    out = np.zeros((rows, together))
    for row in range(rows):
        X = np.ascontiguousarray(given[:, row])
        call(0, X.ctypes.data, 0, 0, 0, out[row].ctypes.data)
    return out.ravel()[:size]


def everywhere(name, *arrays):
    """What an operation gives; the same numbers in every form."""
    arrays = [
        a.ravel() for a in np.broadcast_arrays(*(np.asarray(a, float) for a in arrays))
    ]
    found, *others = (calculated(name, form, *arrays) for form in FORMS)
    np.testing.assert_allclose(others, [found] * len(others), rtol=1e-15)
    return found


def relative_error(got, a, exact):
    worst = 0.0
    for value, arguments in zip(got, a, strict=True):
        true = exact(*map(mpmath.mpf, np.atleast_1d(arguments)))
        worst = max(
            worst,
            float(abs(mpmath.mpf(value) - true) / abs(true)) if true else abs(value),
        )
    return worst


# --- accuracy ---------------------------------------------------------------------------------

RNG, COUNT = np.random.default_rng(3), 400


def uniform(low, high):
    return RNG.uniform(low, high, COUNT)


def powers(low, high):
    return 10.0 ** uniform(low, high)


def both(a):
    return a * RNG.choice([-1.0, 1.0], COUNT)


# where sin or cos nearly vanishes
QUARTERS = np.round(uniform(0, 60000)) * (math.pi / 2)
ACCURACY = {
    "exp": (3e-16, [uniform(-700, 709), uniform(-1, 1), both(powers(-20, 0))]),
    "log": (3e-16, [powers(-307, 308), uniform(0.5, 2), 1 + both(powers(-12, -1))]),
    "sin": (
        2.3e-16,
        [uniform(-1e5, 1e5), uniform(-10, 10), both(powers(-300, 0)), QUARTERS],
    ),
    "cos": (
        2.3e-16,
        [uniform(-1e5, 1e5), uniform(-10, 10), both(powers(-300, 0)), QUARTERS],
    ),
    "tan": (4e-16, [uniform(-1e5, 1e5), uniform(-3, 3), QUARTERS]),
    "asin": (4e-16, [uniform(-1, 1), 1 - powers(-15, -1)]),
    "acos": (5e-16, [uniform(-1, 1), 1 - powers(-15, -1)]),
    "atan": (3e-16, [uniform(-3, 3), both(powers(-10, 10))]),
    "sinh": (5e-16, [uniform(-710, 710), uniform(-2, 2), both(powers(-10, 0))]),
    "cosh": (4e-16, [uniform(-710, 710), uniform(-2, 2)]),
    "tanh": (5e-16, [uniform(-25, 25), uniform(-1, 1), both(powers(-10, 0))]),
    "asinh": (5e-16, [uniform(-3, 3), both(powers(-10, 300))]),
    "acosh": (5e-16, [1 + powers(-10, 10), powers(1, 300)]),
    "atanh": (5e-16, [uniform(-1, 1), both(powers(-10, 0))]),
    "log1p": (4e-16, [uniform(-1, 3), powers(-20, 300)]),
    "expm1": (4e-16, [uniform(-50, 700), uniform(-1, 1), both(powers(-20, 0))]),
    "log2": (3e-16, [powers(-300, 300), uniform(0.5, 2)]),
    "log10": (3e-16, [powers(-300, 300), uniform(0.5, 2)]),
    "sqrt": (1.2e-16, [powers(-300, 300)]),
    "erf": (4e-16, [uniform(-3, 3)]),
    "erfc": (6e-16, [uniform(-3, 20)]),
    "fabs": (0.0, [uniform(-3, 3)]),
    "ceil": (0.0, [uniform(-30, 30)]),
}
EXACT = {
    "log2": lambda a: mpmath.log(a, 2),
    "log10": lambda a: mpmath.log(a, 10),
    "fabs": abs,
    "ceil": mpmath.ceil,
}


@pytest.mark.parametrize("name", ACCURACY)
def test_accuracy(name):
    tolerance, arguments = ACCURACY[name]
    exact = EXACT.get(name) or getattr(mpmath, name)
    for a in arguments:
        assert relative_error(everywhere(name, a), a, exact) <= tolerance


def test_every_operation_of_a_record_is_one_of_machine_code():
    assert set(ELEMENTWISE) <= {*FUNCTIONS, *PRIMITIVES}


def test_every_function_is_measured():
    text = Path(__file__).read_text("utf-8")
    names = FUNCTIONS.keys() - {"place"}  # `lookup` measures it
    assert [name for name in names if f'"{name}"' not in text] == []


@pytest.mark.parametrize("name", ["sin", "cos"])
def test_large_angles_stay_sane(name):
    a = both(powers(5, 15))
    exact = np.array([float(getattr(mpmath, name)(mpmath.mpf(v))) for v in a])
    assert np.max(np.abs(everywhere(name, a) - exact)) < 5e-15
    assert np.isnan(everywhere(name, [2.0**50, -(2.0**60), 1e300, -1.7e308])).all()
    at = np.arange(-2000, 2001) * np.pi / 2
    near = [at, np.nextafter(at, np.inf), np.nextafter(at, -np.inf)]
    assert np.max(np.abs(everywhere(name, np.concatenate(near)))) == 1.0


SPECIAL = np.array([0.0, -0.0, 5e-324, -5e-324, 1e-310, np.inf, -np.inf, np.nan, 1.0, -1.0,
                    709.78271, 709.79, -745.13, -746.0, -708.5, 710.4, 711.0, 0.5, 2.0, 1024.0,
                    1e14])  # fmt: skip


def as_numpy(got, wanted, **close):
    """Numbers, signs and what is none are NumPy's."""
    np.testing.assert_allclose(got, wanted, **close)
    real = ~np.isnan(wanted)
    np.testing.assert_array_equal(np.signbit(got[real]), np.signbit(wanted[real]))


NUMPY = {
    name: f"arc{name[1:]}"
    for name in ("asin", "acos", "atan", "asinh", "acosh", "atanh")
}


@pytest.mark.parametrize("name", [n for n in ACCURACY if hasattr(np, NUMPY.get(n, n))])
def test_special_arguments(name):
    with np.errstate(all="ignore"):
        wanted = getattr(np, NUMPY.get(name, name))(SPECIAL)
    as_numpy(everywhere(name, SPECIAL), wanted, rtol=6e-16, atol=5e-324)


@pytest.mark.parametrize("scale", [1.0, 1e-300, 1e300])
@pytest.mark.parametrize("name", ["atan2", "hypot"])
def test_accuracy_of_pairs(name, scale):
    pairs = scale * np.stack([both(powers(-2, 2)), both(powers(-2, 2))], 1)
    assert (
        relative_error(everywhere(name, *pairs.T), pairs, getattr(mpmath, name))
        <= 3e-16
    )


def test_accuracy_of_powers():
    a = powers(-8, 8)
    for n in (2.0, 3.0, 0.0, -2.0, 2.5, -0.125, 0.5):
        found = everywhere("pow", a, n)
        assert relative_error(found, a, lambda v, n=n: v ** mpmath.mpf(n)) <= 2e-15


@pytest.mark.parametrize("name", ["atan2", "hypot", "pow"])
def test_special_pairs(name):
    some = [0.0, -0.0, 0.5, -2.0, 3.0, 1.0, -1.0, np.inf, -np.inf, np.nan, 2.0, -0.5]
    b, a = (grid.ravel() for grid in np.meshgrid(some, some))
    with np.errstate(all="ignore"):
        wanted = {"atan2": np.arctan2, "hypot": np.hypot, "pow": np.power}[name](b, a)
    as_numpy(everywhere(name, b, a), wanted, rtol=3e-15)


# --- words and operators ------------------------------------------------------------------------


def some(**limits):
    """Eight numbers, any but for the limits."""
    return st.lists(st.floats(**limits), min_size=8, max_size=8).map(np.array)


FEW = settings(max_examples=40, deadline=None, derandomize=True)


@np.errstate(all="ignore")
def same(name, as_one, *arrays):
    """An operation gives bit for bit what a function of NumPy gives."""
    np.testing.assert_array_equal(
        everywhere(name, *arrays), as_one(*arrays), strict=True
    )


@pytest.mark.long
@FEW
@given(some(), some(), some())
def test_choices_are_numpys_bit_for_bit(a, b, c):
    for name in ("minimum", "maximum"):
        same(name, getattr(np, name), a, b)
    same("where", lambda a, b, c: np.where(a < b, b, c), a, b, c)
    same("sign", np.sign, a)


IEEE = {"add": np.add, "sub": np.subtract, "mul": np.multiply, "div": np.divide}
WHOLE = {"floor": np.floor, "trunc": np.trunc, "ceil": np.ceil, "neg": np.negative}


@FEW
@given(some(), some())
def test_operators_are_ieee(a, b):
    for name, operator in IEEE.items():
        same(name, operator, a, b)
    for name, operator in WHOLE.items():
        same(name, operator, a)


@FEW
@given(some(min_value=-1e12, max_value=1e12), some(min_value=1e-3, max_value=1e9))
def test_remainders_are_python_ones_bit_for_bit(a, b):
    for sign in (1.0, -1.0):
        same("mod", np.remainder, a, sign * b)
        same("floordiv", np.floor_divide, a, sign * b)


def test_remainders_of_special_numbers():
    a = np.array([-1.0, 1.0, np.inf, np.nan, 1.0, 1e300, 6.0, -6.0, 3.0, 7.0, -0.0])
    b = np.array([np.inf, -np.inf, 2.0, 2.0, 0.0, 7.0, 3.0, 3.0, np.nan, -2.0, 3.0])
    same("mod", np.remainder, a, b)
