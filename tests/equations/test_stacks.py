"""Loops over many elements are read as the operations on arrays that they stand for."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from recorded import as_it_runs

from clpt_control.equations import Block

N, M = 40, 6
X = np.random.default_rng(0).uniform(-2.0, 2.0, N)


def moving(function):
    """Return a block of N states with these rates."""
    return Block("b", update=lambda t, x, u, p: function(x), states={"x": N})


def looped(x):
    rates = np.zeros(N)
    for i in range(1, N - 1):
        rates[i] = 3.0 * (x[i + 1] - 2.0 * x[i] + x[i - 1]) - np.sin(x[i])
    return rates


def on_arrays(x):
    inner = 3.0 * (x[2:] - 2.0 * x[1:-1] + x[:-2]) - np.sin(x[1:-1])
    return np.concatenate([[0.0], inner, [0.0]])


def coupled(x):
    rates = []
    for i in range(N):
        total = 0.0
        for j in range(N):
            if j != i:
                total += np.sin(x[j] - x[i])
        rates.append(0.1 * i + total / N)
    return rates


def following(x):
    return [min(1.0, max(-1.0, x[i - 1] - x[i])) if i else 1.0 for i in range(N)]


def masses(x):
    rates = np.zeros(N)
    for i in range(0, N, 2):
        force = -0.1 * x[i + 1]
        if i > 0:
            force += 10 * (x[i - 2] - x[i])
        if i < N - 2:
            force += 10 * (x[i + 2] - x[i])
        rates[i], rates[i + 1] = x[i + 1], force
    return rates


def grid(x):
    z, rates = x[:36].reshape(M, M), np.zeros((M, M))
    rates[1:-1, 1:-1] = z[2:, 1:-1] + z[:-2, 1:-1] + z[1:-1, 2:] + z[1:-1, :-2]
    return np.r_[(rates - 4 * z + np.roll(z, 1, axis=1)).ravel(), x[36:]]


NODES = np.linspace(-2.0, 2.0, 9)
A = np.random.default_rng(1).normal(size=(N, N))
LOOPS = {
    "a second difference": (looped, 20),
    "as the arrays that it stands for": (on_arrays, 20),
    "all with all": (coupled, 8 * N),
    "one after the other, between limits": (following, 20),
    "rows of a matrix": (lambda x: [A[i] @ x - np.tanh(x[i]) for i in range(N)], 12),
    "rolled": (lambda x: np.roll(x, 1) - 2 * x + np.roll(x, -1), 12),
    "a table": (lambda x: [np.interp(x[i], NODES, NODES**2) for i in range(N)], 30),
    "padded": (lambda x: np.diff(np.pad(x, 1, mode="edge"), n=2), 12),
    "convolved": (lambda x: np.convolve(x, [1.0, -2.0, 1.0], "same"), 26),
    "written in places": (lambda x: np.r_[x[1:] * x[0], x[:1]], 12),
    "of two kinds in turn": (lambda x: [x[i] if i % 2 else -x[i] for i in range(N)], 12),
    "masses, x and v in turn": (masses, 40),
    "a grid": (grid, 90),
    "points of a plane": (lambda x: (x.reshape(-1, 2) @ [[0.0, 1.0], [-1.0, 0.0]]).ravel(), 16),
}


@pytest.mark.parametrize("name", LOOPS)
def test_a_loop_is_as_python_runs_it_and_short(name):
    function, most = LOOPS[name]
    as_it_runs(moving(function), "update", 0.0, X, [])
    assert len(moving(function).array_record("update").operations) <= most


TERMS = {
    "next": lambda x, i: x[(i + 1) % N],
    "far": lambda x, i: x[(7 * i) % N],
    "back": lambda x, i: x[N - 1 - i],
    "first": lambda x, i: x[0],
    "number": lambda x, i: 0.1 * i,
    "sum": lambda x, i: x[i] + 2.0 * x[i - 1],
    "turn": lambda x, i: np.cos(x[i] * x[(i + 3) % N]),
    "limit": lambda x, i: np.minimum(x[i], 0.25),
    "choice": lambda x, i: np.where(x[i] > x[i - 1], x[0], x[i]),
    "truth": lambda x, i: x[i] > 0.0,
    "row": lambda x, i: np.array([x[i], 1.0, x[i - 1]]) @ x[:3],
}
RUNS = st.lists(st.tuples(st.sampled_from([*TERMS]), st.integers(1, 2 * N)), min_size=1, max_size=6)


@settings(deadline=None, max_examples=40)
@given(RUNS, st.booleans())
def test_any_mixture_is_as_python_runs_it(runs, rows):
    """Numbers, each made in its way, one behind the other, or rows of two of them."""

    def mixed(x):
        made = [TERMS[way](x, i % N) for way, count in runs for i in range(count)]
        whole = np.array([*pairwise(made)] if rows else made)
        return np.sum(whole * np.cos(np.arange(whole.size).reshape(whole.shape))) * x

    as_it_runs(moving(mixed), "update", 0.0, X, [], 1e-11)  # 800 numbers that cancel
