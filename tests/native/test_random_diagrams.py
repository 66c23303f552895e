"""Random diagrams: every reading gives what Python does, or all refuse alike."""

import random
from collections import Counter

import numpy as np
import pytest
from random_diagrams import random_diagram

from clpt_control.errors import ClptError
from clpt_control.native import readings

IN_A_TEST, TESTS, SLOW_TESTS = 10, 20, 200
POINTS = 3
BY_EXPRESSIONS = "is no block, so it has no expressions"


def after(name, ask, t, x, u):
    """Return the states after all jumps, of which python-control knows none."""
    if name != "control":
        return [ask.jump(t, x, u)]
    with pytest.raises(ClptError, match=r"clpt\.simulate"):
        ask.jump(t, x, u)
    return []


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
        u = numbers.normal(size=diagram.ninputs or 0)
        found = {}
        for name, ask in asks.items():
            try:
                found[name] = np.concatenate([*ask(t, x, u), *after(name, ask, t, x, u)])
            except ClptError as error:
                refused[name] = str(error)
        if not found:
            break
        assert not refused, f"seed {seed}: {refused} refuse what others read"
        for name, values in found.items():
            python = found["python"][: len(values)]
            finite = np.isfinite(python)
            scale = max(1.0, np.abs(python[finite]).max(initial=0.0))
            said = f"seed {seed}, {name} at point {point}"
            np.testing.assert_array_equal(np.isfinite(values), finite, err_msg=said)
            np.testing.assert_allclose(
                values[finite], python[finite], rtol=1e-12, atol=1e-12 * scale, err_msg=said
            )
    if refused:
        assert set(refused) == set(asks), f"seed {seed}: {refused}"
        assert all(sentence and "\n" not in sentence for sentence in refused.values())
        return refused["python"]
    return None


def ask_all(seeds):
    refused = Counter(sentence for sentence in map(asked, seeds) if sentence)
    assert refused.total() <= len(seeds) // 2, refused


@pytest.mark.parametrize("part", range(TESTS))
def test_random_diagrams_are_read_alike(part):
    ask_all(range(part * IN_A_TEST, (part + 1) * IN_A_TEST))


@pytest.mark.slow
@pytest.mark.parametrize("part", range(SLOW_TESTS))
def test_many_random_diagrams_are_read_alike(part):
    ask_all(range(10_000 + part * IN_A_TEST, 10_000 + (part + 1) * IN_A_TEST))
