"""A block's equations in SIMD lanes: accuracy, words, every block, independence of lanes."""

import functools
import math
import os
import subprocess
import sys

import mpmath
import numba
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_conformance import BLOCKS

from clpt_control.blocks import basis, clpe, flow, words
from clpt_control.blocks.conformance.samples import equations
from clpt_control.blocks.readers import compiled
from clpt_control.native import lanes
from clpt_control.native.lanes import lane_compiled, lane_matrix, lane_vector

mpmath.mp.dps = 40
njit = numba.njit(error_model="numpy")


@functools.cache
def laned(function, count=1):
    """Call a function of `count` lanes on arrays of any length."""
    read = njit(function)

    @njit
    def one(a, out):
        va, vout = lane_vector(a), lane_vector(out)
        for i in range(len(va)):
            vout[i] = read(va[i])

    @njit
    def two(a, b, out):
        va, vb, vout = lane_vector(a), lane_vector(b), lane_vector(out)
        for i in range(len(va)):
            vout[i] = read(va[i], vb[i])

    @njit
    def three(a, b, c, out):
        va, vb, vc, vout = lane_vector(a), lane_vector(b), lane_vector(c), lane_vector(out)
        for i in range(len(va)):
            vout[i] = read(va[i], vb[i], vc[i])

    loop = (one, two, three)[count - 1]

    def call(*arrays):
        arrays = [np.asarray(a, dtype=float) for a in np.broadcast_arrays(*arrays)]
        size = arrays[0].size
        rows = -(-size // 8)
        padded = [np.resize(a, (rows, 8)) for a in arrays]
        out = np.zeros((rows, 8))
        loop(*padded, out)
        return out.ravel()[:size]

    return call


@functools.cache
def unary(name):
    function = getattr(math, name)
    return laned(lambda a: function(a))


def relative_error(got, a, exact):
    worst = 0.0
    for value, arguments in zip(got, a, strict=True):
        true = exact(*map(mpmath.mpf, np.atleast_1d(arguments)))
        worst = max(worst, float(abs(mpmath.mpf(value) - true) / abs(true)) if true else abs(value))
    return worst


# --- accuracy ---------------------------------------------------------------------------------

RNG = np.random.default_rng(3)
COUNT = 400


def uniform(low, high):
    return RNG.uniform(low, high, COUNT)


def powers(low, high):
    return 10.0 ** uniform(low, high)


def both(a):
    return a * RNG.choice([-1.0, 1.0], COUNT)


QUARTERS = np.round(uniform(0, 60000)) * (math.pi / 2)  # where sin or cos nearly vanishes
ACCURACY = {
    "exp": (3e-16, [uniform(-700, 700), uniform(-1, 1), both(powers(-20, 0))]),
    "log": (3e-16, [powers(-307, 308), uniform(0.5, 2), 1 + both(powers(-12, -1))]),
    "sin": (2e-16, [uniform(-1e5, 1e5), uniform(-10, 10), both(powers(-300, 0)), QUARTERS]),
    "cos": (2e-16, [uniform(-1e5, 1e5), uniform(-10, 10), both(powers(-300, 0)), QUARTERS]),
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
    "degrees": (3e-16, [uniform(-30, 30)]),
    "radians": (3e-16, [uniform(-30, 30)]),
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
        assert relative_error(unary(name)(a), a, exact) <= tolerance


def test_every_name_of_math_is_read():
    constants = {"pi", "e", "tau"}
    assert set(ACCURACY) | constants | {"atan2", "hypot", "pow"} == words.MATH


@pytest.mark.parametrize("name", ["sin", "cos"])
def test_large_angles_stay_sane(name):
    a = both(powers(5, 15))
    exact = np.array([float(getattr(mpmath, name)(mpmath.mpf(v))) for v in a])
    assert np.max(np.abs(unary(name)(a) - exact)) < 5e-15
    huge = unary(name)([2.0**50, -(2.0**60), 1e300, -1.7e308])
    assert np.array_equal(huge, np.full(4, 0.0 if name == "sin" else 1.0))


SPECIAL = np.array(
    [
        *(0.0, -0.0, 5e-324, -5e-324, 1e-310, np.inf, -np.inf, np.nan, 1.0, -1.0, 709.78271),
        *(709.79, -745.13, -746.0, -708.5, 710.4, 711.0, 0.5, 2.0, 1024.0, 1e14),
    ]
)
NUMPY = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "asinh": "arcsinh",
         "acosh": "arccosh", "atanh": "arctanh"}  # fmt: skip


@pytest.mark.parametrize("name", [n for n in ACCURACY if hasattr(np, NUMPY.get(n, n))])
def test_special_arguments(name):
    with np.errstate(all="ignore"):
        wanted = getattr(np, NUMPY.get(name, name))(SPECIAL)
    got = unary(name)(SPECIAL)
    assert np.array_equal(np.isnan(got), np.isnan(wanted))
    real = ~np.isnan(wanted)
    assert np.array_equal(np.signbit(got[real]), np.signbit(wanted[real]))
    np.testing.assert_allclose(got, wanted, rtol=6e-16, atol=5e-324)


def test_atan2():
    read = laned(lambda b, a: math.atan2(b, a), 2)
    a, b = both(powers(-5, 5)), both(powers(-5, 5))
    assert relative_error(read(b, a), np.stack([b, a], 1), mpmath.atan2) <= 3e-16
    some = np.array([0.0, -0.0, 1.0, -1.0, np.inf, -np.inf, np.nan])
    b, a = (grid.ravel() for grid in np.meshgrid(some, some))
    wanted, got = np.arctan2(b, a), read(b, a)
    np.testing.assert_allclose(got, wanted, rtol=3e-16)
    real = ~np.isnan(wanted)
    assert np.array_equal(np.signbit(got[real]), np.signbit(wanted[real]))


def test_hypot():
    read = laned(lambda a, b: math.hypot(a, b), 2)
    a, b = both(powers(-2, 2)), both(powers(-2, 2))
    for scale in (1.0, 1e-300, 1e300):
        pairs = np.stack([a * scale, b * scale], 1)
        assert relative_error(read(*pairs.T), pairs, mpmath.hypot) <= 3e-16
    some = [0.0, -1.0, np.inf, -np.inf, np.nan]
    b, a = (grid.ravel() for grid in np.meshgrid(some, some))
    np.testing.assert_allclose(read(a, b), np.hypot(a, b), rtol=3e-16)


def test_powers():
    a = powers(-8, 8)
    for n, read in (
        (2, laned(lambda a: a**2)),
        (3, laned(lambda a: a**3)),
        (0, laned(lambda a: a**0)),
        (-2, laned(lambda a: a**-2)),
        (2.5, laned(lambda a: a**2.5)),
        (-0.125, laned(lambda a: a ** (-1 / 8))),
        (0.5, laned(lambda a: math.pow(a, 0.5))),
    ):
        assert relative_error(read(a), a, lambda v, n=n: v ** mpmath.mpf(n)) <= 2e-15
    some = [0.0, -0.0, 0.5, -2.0, 3.0, 1.0, -1.0, np.inf, -np.inf, np.nan]
    some += [2.0, -0.5]
    b, a = (grid.ravel() for grid in np.meshgrid(some, some))
    with np.errstate(all="ignore"):
        wanted = np.power(a, b)
    np.testing.assert_allclose(laned(lambda a, b: a**b, 2)(a, b), wanted, rtol=3e-15)
    np.testing.assert_allclose(laned(lambda b: 2**b)(some), 2.0 ** np.array(some), rtol=1e-15)


# --- words and operators ------------------------------------------------------------------------

ANY = st.floats(allow_nan=True, allow_infinity=True)
EIGHT = st.lists(ANY, min_size=8, max_size=8).map(np.array)
FEW = settings(max_examples=60, deadline=None)


def same(a, b):
    return np.array_equal(a, b, equal_nan=True)


@FEW
@given(EIGHT, EIGHT, EIGHT)
def test_choosing_words_are_the_scalar_ones_bit_for_bit(a, b, c):
    for name in ("minimum", "maximum"):
        word = getattr(lanes, name)
        wanted = [getattr(words, name)(*pair) for pair in zip(a, b, strict=True)]
        assert same(laned(CALLS[name](word), 2)(a, b), wanted)
    wanted = [words.clip(*three) for three in zip(a, b, c, strict=True)]
    assert same(laned(CALLS["clip"](lanes.clip), 3)(a, b, c), wanted)
    wanted = [words.where(v < w, w, z) for v, w, z in zip(a, b, c, strict=True)]
    assert same(laned(CALLS["where"](lanes.where), 3)(a, b, c), wanted)
    wanted = [words.sign(v) for v in a]
    assert same(laned(CALLS["sign"](lanes.sign))(a), wanted)


CALLS = {
    "minimum": functools.cache(lambda word: lambda a, b: word(a, b)),
    "maximum": functools.cache(lambda word: lambda a, b: word(a, b)),
    "clip": functools.cache(lambda word: lambda a, b, c: word(a, b, c)),
    "where": functools.cache(lambda word: lambda a, b, c: word(a < b, b, c)),
    "sign": functools.cache(lambda word: lambda a: word(a)),
}


def compare(a, b):
    return (
        (a < b) * 1
        + (a <= b) * 2
        + (a > b) * 4
        + (a >= b) * 8
        + lanes.select(a == b, 16, 0)
        + lanes.select(a != b, 32, 0.0)
        + lanes.select(~(a < b) & (b > 0.0) | (a > 1), 64, 0.0)
    )


def combine(a, b):
    c = 0.0
    for i in range(3):
        c += i * a - 2 * b
    c /= 1.5
    return -c + abs(b) - (+a) * True


def whole(a):
    return int(a) + float(a > 1) + lanes.floor(a)


@FEW
@given(EIGHT, EIGHT)
def test_operators(a, b):
    with np.errstate(all="ignore"):
        wanted = (a < b) * 1 + (a <= b) * 2 + (a > b) * 4 + (a >= b) * 8
        wanted = wanted + (a == b) * 16 + (a != b) * 32 + (~(a < b) & (b > 0) | (a > 1)) * 64
        assert same(laned(compare, 2)(a, b), wanted)
        c = ((0 * a - 2 * b) + (1 * a - 2 * b)) + (2 * a - 2 * b)
        assert same(laned(combine, 2)(a, b), -(c / 1.5) + np.abs(b) - a)
        assert same(laned(whole)(a), np.trunc(a) + (a > 1) + np.floor(a))


def modulo(a, b):
    return a % b


def floor_divide(a, b):
    return a // b


@FEW
@given(
    st.lists(st.floats(-1e12, 1e12), min_size=8, max_size=8).map(np.array),
    st.lists(st.floats(1e-3, 1e9), min_size=8, max_size=8).map(np.array),
)
def test_remainders_are_python_ones_bit_for_bit(a, b):
    for sign in (1.0, -1.0):
        with np.errstate(under="ignore"):
            assert same(laned(modulo, 2)(a, sign * b), np.remainder(a, sign * b))
            assert same(laned(floor_divide, 2)(a, sign * b), np.floor_divide(a, sign * b))


def test_remainders_of_special_numbers():
    a = np.array([-1.0, 1.0, np.inf, np.nan, 1.0, 1e300, 6.0, -6.0, 3.0, 7.0, -0.0])
    b = np.array([np.inf, -np.inf, 2.0, 2.0, 0.0, 7.0, 3.0, 3.0, np.nan, -2.0, 3.0])
    with np.errstate(all="ignore"):
        wanted = np.remainder(a, b)
    assert same(laned(modulo, 2)(a, b), wanted)
    assert np.array_equal(laned(lambda a: a % 3)(a[6:8]), [0.0, 0.0])


def test_lookup_in_shared_and_own_tables():
    index = np.array([0.0, 4.0, 2.0, -1.0, 5.0, np.nan, np.inf, -6.0])
    shared, own = np.arange(10.0)[::2], np.arange(40.0).reshape(5, 8)

    @njit
    def read(index, shared, own, out):
        i, mine, vout = lane_vector(index)[0], lane_vector(own), lane_vector(out)
        vout[0] = lanes.lookup(shared, i)
        vout[1] = lanes.lookup(mine, i)
        vout[2] = lanes.lookup(mine, 3.0)
        vout[3] = lanes.lookup(shared, 3.0)
        vout[4] = lanes.lookup(shared[0:0], i)

    out = np.zeros((5, 8))
    read(index.reshape(1, 8), shared, own, out)
    gone = [np.nan] * 4
    assert same(out[0], [0.0, 8.0, 4.0, 8.0, *gone])
    assert same(out[1], [0.0, 33.0, 18.0, 35.0, *gone])
    assert same(out[2], own[3])
    assert same(out[3], np.full(8, 6.0))
    assert same(out[4], np.full(8, np.nan))


def test_views():
    @njit
    def read(v, m, out):
        view, matrix, vout = lane_vector(v), lane_matrix(m), lane_vector(out)
        part, tail = view[1:4], view[2:]
        vout[0] = part[0] + tail[-1] + view[:2][1] + view[-3:-1][0]
        vout[1] = matrix[1, 2] + matrix[-1, 0] + matrix[0][1]
        vout[2] = float(len(part)) + len(tail) + len(view[9:]) + len(matrix)
        vout[-1] = 7
        matrix[0, 0] = view[0]

    rng = np.random.default_rng(0)
    v, m, out = rng.standard_normal((5, 8)), rng.standard_normal((2, 3, 8)), np.zeros((4, 8))
    first = m[0, 0].copy()
    read(v, m, out)
    np.testing.assert_allclose(out[0], v[1] + v[4] + v[1] + v[2], rtol=1e-14)
    np.testing.assert_allclose(out[1], m[1, 2] + m[1, 0] + m[0, 1], rtol=1e-14)
    assert np.array_equal(out[2:], np.stack([np.full(8, 8.0), np.full(8, 7.0)]))
    assert np.array_equal(m[0, 0], v[0])
    assert not np.array_equal(first, v[0])


def test_helpers_of_an_integrator():
    @njit
    def ask(a, out):
        v, vout = lane_vector(a), lane_vector(out)
        mask = v[0] > 0.0
        changed = lanes.lane_set(v[0], 3, -9.0)
        vout[0] = changed
        vout[1] = lanes.select(lanes.lane_set(mask, 0, True), lanes.splat(1), 0.0)
        vout[2] = lanes.lane_numbers()
        vout[3] = lanes.copysign(lanes.square_root(lanes.absolute(v[0])), v[0])
        vout[4] = lanes.fma(v[0], v[0], -1.0)
        vout[5] = lanes.power(lanes.absolute(v[0]), -0.125)
        return (
            lanes.any_lane(mask),
            lanes.all_lanes(mask),
            lanes.mask_bits(mask),
            lanes.lane_get(v[0], 2),
            lanes.lane_get(mask, 2),
        )

    a, out = np.array([[-1.0, 2, -3, 4, -5, 6, -7, 8]]), np.zeros((6, 8))
    assert ask(a, out) == (True, False, 0b10101010, -3.0, False)
    assert np.array_equal(out[0], [-1, 2, -3, -9, -5, 6, -7, 8])
    assert np.array_equal(out[1], [1, 1, 0, 1, 0, 1, 0, 1])
    assert np.array_equal(out[2], np.arange(8.0))
    np.testing.assert_allclose(out[3], np.sign(a[0]) * np.sqrt(np.abs(a[0])), rtol=2e-16)
    np.testing.assert_allclose(out[4], a[0] ** 2 - 1, rtol=2e-16)
    np.testing.assert_allclose(out[5], np.abs(a[0]) ** -0.125, rtol=1e-15)
    assert ask(np.abs(a), out)[:3] == (True, True, 255)
    assert ask(-np.abs(a), out)[:3] == (False, False, 0)


def test_only_whole_float64_arrays_are_viewed():
    @njit
    def read(a):
        return len(lane_vector(a))

    assert read(np.zeros((3, 8))) == 3
    with pytest.raises(numba.TypingError, match="C-contiguous float64 array of 2 axes"):
        read(np.zeros((8, 3)).T)


# --- blocks ---------------------------------------------------------------------------------------

CASES = [case for case in BLOCKS if not case.endswith("-2") and "field-raise" not in case]
CASES = [case for case in CASES if not (case.startswith("basis_z") or case == "field-stop")]


def arrays_of(p):
    return [name for name, value in zip(p._fields, p, strict=True) if not isinstance(value, int)]


def whole_call(function, p, shared=()):
    """Make the function that puts lane parameters together and calls the equations."""
    fields = []
    for name, value in zip(p._fields, p, strict=True):
        if isinstance(value, int):
            fields.append(repr(value))
        elif name in shared:
            fields.append(f"p_{name}")
        elif np.ndim(value) == 0:
            fields.append(f"lane_vector(p_{name})[0]")
        else:
            fields.append(f"lane_{'vector' if np.ndim(value) == 1 else 'matrix'}(p_{name})")
    arguments = ", ".join(["t", "x", "u", "out", *(f"p_{name}" for name in arrays_of(p))])
    code = f"""def call({arguments}):
    p = P({", ".join(fields)})
    f(lane_vector(t)[0], lane_vector(x), lane_vector(u), p, lane_vector(out))
"""
    space = {"P": type(p), "f": lane_compiled(function)}
    space |= {"lane_vector": lane_vector, "lane_matrix": lane_matrix}
    exec(code, space)
    return njit(space["call"])


def different_runs(block, case, rng):
    """Eight times, states, inputs and parameters."""
    runs = []
    for k in range(8):
        p = block.parameters_at(50.0, block.parameters)
        changed = {}
        for name in arrays_of(p):
            value = getattr(p, name)
            if name in ("interval", "seed"):
                changed[name] = value + k
            elif name in SHARED and case.startswith("field"):
                changed[name] = value
            else:
                changed[name] = value * (1 + 0.2 * rng.uniform(-1, 1, np.shape(value)))
        t = rng.uniform(0, 100)
        x, u = (2 * rng.standard_normal(n or 0) for n in (block.nstates, block.ninputs))
        runs.append((t, x, u, p._replace(**changed)))
    return runs


SHARED = ("shape", "start", "step")


def in_lanes(call, runs, size, shared=()):
    out = np.full((size, 8), np.nan)
    stacked = [
        np.ascontiguousarray(np.stack([np.atleast_1d(run[k]) for run in runs], -1))
        for k in range(3)
    ]
    first = runs[0][3]
    parameters = [
        getattr(first, name)
        if name in shared
        else np.ascontiguousarray(np.stack([np.atleast_1d(getattr(r[3], name)) for r in runs], -1))
        for name in arrays_of(first)
    ]
    call(*stacked, out, *parameters)
    return out


@pytest.mark.parametrize("case", CASES)
def test_block_in_lanes(case):
    block = BLOCKS[case]
    rng = np.random.default_rng(len(case))
    shared = SHARED if case.startswith("field") else ()
    for role, function, size in equations(block):
        if function.__name__ == "states_as_outputs" and case != "vehicle":
            continue
        runs = different_runs(block, case, rng)
        call = whole_call(function, block.parameters, shared)
        out = in_lanes(call, runs, size, shared)
        for k, (t, x, u, p) in enumerate(runs):
            wanted = np.zeros(size)
            compiled(function)(t, x, u, p, wanted)
            scale = np.max(np.abs(wanted), initial=1e-300)
            assert np.max(np.abs(out[:, k] - wanted)) <= 1e-14 * scale, role
        # which lane a run is in does not matter, bit for bit
        order = rng.permutation(8)
        moved = in_lanes(call, [runs[k] for k in order], size, shared)
        assert np.array_equal(moved, out[:, order]), role
        # nor do its neighbours
        t, x, u, p = runs[3]
        wild = (np.nan, x * np.inf, u - 1e300, p)
        other = in_lanes(call, [*runs[:3], wild, *runs[4:]], size, shared)
        kept = [0, 1, 2, 4, 5, 6, 7]
        assert np.array_equal(other[:, kept], out[:, kept]), role


def test_shared_parameters_are_the_same_as_repeated_ones():
    block = BLOCKS["true_flow-True-3"]
    rng = np.random.default_rng(1)
    runs = [(*run[:3], block.parameters) for run in different_runs(block, "", rng)]
    own = in_lanes(whole_call(block.output_function, block.parameters), runs, 2)
    shared = ("theta",)
    one = in_lanes(whole_call(block.output_function, block.parameters, shared), runs, 2, shared)
    assert np.array_equal(own, one)


def test_blocks_in_one_function_share_buffers():
    phi, true, error = (
        lane_compiled(f) for f in (basis.exponential, flow.true, clpe.prediction_error)
    )
    Basis, Flow = basis.BasisParameters, flow.TrueFlowParameters

    @njit
    def fused(t, x, centers, widths, frequencies, phases, theta, out):
        p_basis = Basis(3, centers, lane_vector(widths), frequencies, phases)
        p_flow = Flow(3, lane_matrix(theta))
        vx, vt, vout = lane_vector(x), lane_vector(t), lane_vector(out)
        u = lanes.lane_buffer(5)  # x[2], phi_x[3]
        u[0], u[1] = vx[0], vx[1]
        phi(vt[0], vx, vx, p_basis, u[2:5])
        true(vt[0], vx, u, p_flow, vout)
        both_ = lanes.lane_buffer(4)
        for i in range(2):
            both_[i], both_[2 + i] = vout[i], vx[i]
        error(vt[0], vx, both_, (), vout)

    p = BLOCKS["basis_x-exponential-3"].parameters
    rng = np.random.default_rng(5)
    widths, theta = rng.uniform(1, 4, (3, 8)), rng.uniform(-1, 1, (2, 3, 8))
    t, x, out = rng.uniform(0, 9, (1, 8)), rng.standard_normal((2, 8)), np.zeros((2, 8))
    fused(t, x, p.centers, widths, p.frequencies, p.phases, theta, out)
    for k in range(8):
        values, wanted = np.zeros(3), np.zeros(2)
        basis.exponential(t[0, k], None, x[:, k], p._replace(widths=widths[:, k]), values)
        flow.true(0, None, np.r_[x[:, k], values], Flow(3, theta[:, :, k]), wanted)
        np.testing.assert_allclose(out[:, k], wanted - x[:, k], rtol=1e-14, atol=1e-15)


def test_a_basis_function_calls_no_library():
    block = BLOCKS["basis_x-exponential-3"]
    call = whole_call(block.output_function, block.parameters)
    in_lanes(call, different_runs(block, "", np.random.default_rng(0)), 3)
    (llvm,) = call.inspect_llvm().values()
    bodies = [part.split("\n}")[0] for part in llvm.split("\ndefine ")[1:]]
    (body,) = (part for part in bodies if "<8 x double>" in part and "cpython" not in part)
    called = {line.split("@", 1)[1].split("(")[0] for line in body.splitlines() if " call " in line}
    assert "llvm.fma.v8f64" in called
    assert {name for name in called if not name.startswith("llvm.")} == set()


FINGERPRINT = """
import math, sys
import numba, numpy as np
from clpt_control.native import lanes

@numba.njit(error_model="numpy")
def run(a, out):
    v, vout = lanes.lane_vector(a), lanes.lane_vector(out)
    for i in range(len(v)):
        wave = math.exp(-math.sqrt(abs(v[i]))) * math.cos(3 * v[i]) + math.tanh(v[i])
        vout[i] = wave + math.log(abs(v[i])) + lanes.power(abs(v[i]), -0.125) + v[i] % 0.7

a = np.linspace(-9, 9, 160).reshape(20, 8)
out = np.zeros_like(a)
run(a, out)
sys.stdout.write(out.tobytes().hex())
"""


def test_bits_do_not_depend_on_the_processor():
    found = set()
    for settings_ in ({}, {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}):
        run = subprocess.run(
            [sys.executable, "-c", FINGERPRINT],
            env={**os.environ, **settings_},
            capture_output=True,
            text=True,
            check=True,
        )
        found.add(run.stdout)
    assert len(found) == 1
    assert len(found.pop()) == 160 * 16
