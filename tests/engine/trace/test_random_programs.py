"""Random functions in ordinary Python: the record computes what the function does."""

import random
from collections import Counter

import numpy as np
import pytest
from engine_runs import Confirmation, Unread
from random_diagrams import random_block
from recorded_blocks import recorded, run

PROGRAMS, SLOW, POINTS = 100, 2000, 160


def points_of(block, numbers):
    """Draw times, states and inputs of several sizes; some numbers are exactly 0 or 1."""
    t = numbers.uniform(0.0, 5.0, POINTS)
    sizes = np.resize([0.1, 1.0, 4.0], POINTS)
    vectors = [
        numbers.normal(size=(count, POINTS)) * sizes
        for count in (block.nstates, block.ninputs)
    ]
    for vector in vectors:
        exact = numbers.random(vector.shape) < 0.1
        vector[exact] = numbers.integers(-1, 2, exact.sum())
    return t, *vectors


def compare(seed):
    """Compare every record of a block with its functions; return why one cannot be read."""
    block, numbers = (
        random_block(random.Random(seed), "mine"),
        np.random.default_rng(seed),
    )
    for role in ("update", "output"):
        if getattr(block, f"{role}_function") is None:
            continue
        t, x, u = points_of(block, numbers)
        try:
            found = recorded(block, role, t, x, u)
        except Unread as why:
            return str(why).partition(": ")[2]
        wanted = [run(block, role, t[k], x[:, k], u[:, k]) for k in range(POINTS)]
        with np.errstate(all="ignore"):
            size = np.nan_to_num(np.abs(found), posinf=1.0).max(axis=0, initial=1.0)
            near = np.abs(found - np.transpose(wanted)) <= 1e-10 * size
        alike = near | (found == np.transpose(wanted)) | np.isnan(found)
        assert alike.all(), f"{role} of random_block(Random({seed}))"
    return None


PARTS = [range(part * PROGRAMS // 4, (part + 1) * PROGRAMS // 4) for part in range(4)]
MANY = [
    range(first, first + SLOW // 20)
    for first in range(10_000, 10_000 + SLOW, SLOW // 20)
]


@pytest.mark.parametrize(
    "seeds", [*PARTS, *(pytest.param(seeds, marks=pytest.mark.slow) for seeds in MANY)]
)
def test_random_programs_are_read_as_they_run(seeds, monkeypatch):
    """Few are refused; merged paths alone are right, without the comparison of records."""
    monkeypatch.setattr(Confirmation, "difference", lambda self: "")
    refused = Counter(why for why in map(compare, seeds) if why)
    assert refused.total() <= len(seeds) // 8, refused
