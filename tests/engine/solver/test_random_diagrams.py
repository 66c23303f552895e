"""Random diagrams: every reading gives what Python does, or all refuse alike."""

import math
import random
from collections import Counter

import numpy as np
import pytest
from engine_runs import readings
from random_diagrams import random_diagram
from rounding_bounds import rounding_of
from sympy import Rational, sin

from clpt_control import Block, ClptError

IN_A_TEST, TESTS, SLOW_TESTS = 6, 3, 340
POINTS = 3


def after(name, ask, t, x, u):
    """Return the states after all jumps, of which python-control knows none."""
    if name != "control":
        return [ask.jump(t, x, u)]
    with pytest.raises(ClptError, match=r"clpt\.simulate"):
        ask.jump(t, x, u)
    return []


ASKS = "asks whether a signal is a number of Python or of NumPy, whole or not"


def asked(seed):
    """Ask every reading of a diagram; return the sentence of one that all refuse."""
    draw, numbers = random.Random(seed), np.random.default_rng(seed)
    try:
        diagram = random_diagram(draw)
        asks = readings(diagram)
    except ClptError as error:
        return str(error)
    refused = {}
    for point in range(POINTS):
        t = float(numbers.uniform(0.0, 5.0))
        x = numbers.normal(size=diagram.nstates or 0) * (1.0, 0.1, 4.0)[point % 3]
        u, found = numbers.normal(size=diagram.ninputs or 0), {}
        for name, ask in asks.items():
            try:
                found[name] = np.concatenate(
                    [*ask(t, x, u), *after(name, ask, t, x, u)]
                )
            except ClptError as error:
                refused[name] = str(error)
        if not found:
            break
        if found.keys() <= {"python", "control"}:  # where a number may be whole or not
            assert all(ASKS in sentence for sentence in refused.values()), refused
            return refused["native"]
        assert not refused, f"seed {seed}: {refused} refuse what others read"
        for name, values in found.items():
            python = found["python"][: len(values)]
            finite = np.isfinite(python)
            scale = max(1.0, np.abs(python[finite]).max(initial=0.0))
            said = f"seed {seed}, {name} at point {point}"
            np.testing.assert_array_equal(np.isfinite(values), finite, err_msg=said)
            off = np.abs(values - python)
            beyond = np.flatnonzero(finite & (off > 1e-12 * (np.abs(python) + scale)))
            if len(beyond):  # two readings are off by their rounding each
                allowed = 2 * rounding_of(diagram, t, x, u)[: len(values)]
                assert np.all(off[beyond] <= allowed[beyond]), said
    if refused:
        assert set(refused) == set(asks), f"seed {seed}: {refused}"
        assert all(sentence and "\n" not in sentence for sentence in refused.values())
        return refused["python"]
    return None


def ask_all(seeds):
    refused = Counter(sentence for sentence in map(asked, seeds) if sentence)
    assert refused.total() <= len(seeds) // 2, refused


def long_sum(t, x, u, p):
    s = 0.0
    for _ in range(320):
        s += u[0]
    return math.sin(s) * u[1]


def test_a_bound_on_rounding_holds_and_is_near():
    block = Block("mine", output=long_sum, inputs={"u": 2}, outputs={"y": 1})
    a, b = 1.03, 322.7
    wanted = b * float(sin(320 * Rational(a), evaluate=False).evalf(40))
    bound = rounding_of(block, 0.0, [], [a, b])[0]
    off = abs(readings(block)["python"](0.0, [], [a, b])[1][0] - wanted)
    assert off < bound < 1e-7
    assert off > 1e-12 * b  # each of 320 sums rounds the same way


@pytest.mark.long
@pytest.mark.parametrize("part", range(TESTS))
def test_random_diagrams_are_read_alike(part):
    ask_all(range(part * IN_A_TEST, (part + 1) * IN_A_TEST))


@pytest.mark.slow
@pytest.mark.parametrize("part", [*range(TESTS, 20), *range(1000, 1000 + SLOW_TESTS)])
def test_many_random_diagrams_are_read_alike(part):
    ask_all(range(part * IN_A_TEST, (part + 1) * IN_A_TEST))
