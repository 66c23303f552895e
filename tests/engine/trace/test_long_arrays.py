"""Long arrays stay arrays where they are joined, shifted or written in place."""

from itertools import pairwise

import numpy as np
import pytest
from engine_runs import compile
from hypothesis import given, settings
from hypothesis import strategies as st
from recorded_blocks import as_it_runs

from clpt_control import Block

N, M = 40, 6
X = np.random.default_rng(0).uniform(-2.0, 2.0, N)


def block_of(function, n=N):
    """Return a block of n states with these rates."""
    return Block("b", update=lambda t, x, u, p: function(x), states={"x": n})


def by_slices(x):
    inner = 3.0 * (x[2:] - 2.0 * x[1:-1] + x[:-2]) - np.sin(x[1:-1])
    return np.concatenate([[0.0], inner, [0.0]])


def in_place(x):
    rates = np.zeros(len(x))
    rates[1:-1] = 3.0 * (x[2:] - 2.0 * x[1:-1] + x[:-2]) - np.sin(x[1:-1])
    return rates


def grid(x):
    z, rates = x[:36].reshape(M, M), np.zeros((M, M))
    rates[1:-1, 1:-1] = z[2:, 1:-1] + z[:-2, 1:-1] + z[1:-1, 2:] + z[1:-1, :-2]
    return np.r_[(rates - 4 * z + np.roll(z, 1, axis=1)).ravel(), x[36:]]


ARRAYS = {
    "slices": (by_slices, 20),
    "slices written in place": (in_place, 20),
    "np.roll": (lambda x: np.roll(x, 1) - 2 * x + np.roll(x, -1), 12),
    "np.diff of np.pad": (lambda x: np.diff(np.pad(x, 1, mode="edge"), n=2), 14),
    "a shift": (lambda x: np.r_[x[1:] * x[0], x[:1]], 12),
    "a grid": (grid, 130),
    "points of a plane": (
        lambda x: (x.reshape(-1, 2) @ [[0.0, 1.0], [-1.0, 0.0]]).ravel(),
        16,
    ),
}


@pytest.mark.parametrize("name", ARRAYS)
def test_the_record_is_short(name):
    function, most = ARRAYS[name]
    as_it_runs(block_of(function), "update", 0.0, X, [])
    assert len(block_of(function).array_record("update").operations) <= most


def looped(x):
    rates = np.zeros(len(x))
    for i in range(1, len(x) - 1):
        rates[i] = 3.0 * (x[i + 1] - 2.0 * x[i] + x[i - 1]) - np.sin(x[i])
    return rates


def coupled(x):
    return [
        0.1 * i + sum(np.sin(x[j] - x[i]) for j in range(N) if j != i) / N
        for i in range(N)
    ]


A = np.random.default_rng(1).normal(size=(N, N))
NODES = np.linspace(-2.0, 2.0, 9)
LOOPS = [
    looped,
    coupled,
    lambda x: [min(1.0, max(-1.0, x[i - 1] - x[i])) if i else 1.0 for i in range(N)],
    lambda x: [A[i] @ x - np.tanh(x[i]) for i in range(N)],
    lambda x: [np.interp(x[i], NODES, NODES**2) for i in range(N)],
    lambda x: [x[i] if i % 2 else -x[i] for i in range(N)],
    lambda x: np.convolve(x, [1.0, -2.0, 1.0], "same"),
]


@pytest.mark.parametrize("function", LOOPS)
def test_a_loop_is_as_python_runs_it(function):
    as_it_runs(block_of(function), "update", 0.0, X, [])


TERMS = {
    "next": lambda x, i: x[(i + 1) % N],
    "far": lambda x, i: x[(7 * i) % N],
    "back": lambda x, i: x[N - 1 - i],
    "first": lambda x, i: x[0],
    "number": lambda x, i: 0.1 * i,
    "sum": lambda x, i: x[i] + 2.0 * x[i - 1],
    "truth": lambda x, i: x[i] > 0.0,
    "row": lambda x, i: np.array([x[i], 1.0, x[i - 1]]) @ x[:3],
}
RUNS = st.lists(
    st.tuples(st.sampled_from([*TERMS]), st.integers(1, 2 * N)), min_size=1, max_size=6
)


@settings(deadline=None, max_examples=40)
@given(RUNS, st.booleans())
def test_any_mixture_is_as_python_runs_it(runs, rows):
    """Numbers and neighbouring elements, one behind the other, or rows of two of them."""

    def mixed(x):
        made = [TERMS[way](x, i % N) for way, count in runs for i in range(count)]
        whole = np.array([*pairwise(made)] if rows else made)
        return np.sum(whole * np.cos(np.arange(whole.size).reshape(whole.shape))) * x

    as_it_runs(block_of(mixed), "update", 0.0, X, [], 1e-11)  # 800 numbers that cancel


@pytest.mark.long
def test_a_large_scalar_program_gives_the_numbers_of_slices():
    n = 500
    start, times = np.sin(np.arange(n)), [0.0, 0.5, 1.0]
    compiled = [compile(block_of(function, n)) for function in (looped, by_slices)]
    components = [len(native.code.program.components) for native in compiled]
    assert components[0] > 2000 > 100 * components[1]  # not optimized; optimized
    scalar, array = (native.run(start, times).x for native in compiled)
    np.testing.assert_allclose(scalar, array, rtol=1e-9, atol=1e-12)
