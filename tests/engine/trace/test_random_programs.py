"""Random functions in ordinary Python: the record computes what the function does."""

import random
from collections import Counter

import numpy as np
import pytest
from random_diagrams import random_block
from recorded_blocks import recorded, run

from clpt_control.engine.trace.arrays import Unread

PROGRAMS, SLOW = 100, 3000


def compare(seed):
    """Compare every record of a block with its functions; return why one cannot be read."""
    block, numbers = (
        random_block(random.Random(seed), "mine"),
        np.random.default_rng(seed),
    )
    for role in block._roles:
        for size in (1.0, 0.1, 4.0):
            t = float(numbers.uniform(0.0, 5.0))
            x, u = (
                size * numbers.normal(size=n) for n in (block.nstates, block.ninputs)
            )
            try:
                found = recorded(block, role, t, x, u)
            except Unread as why:
                return str(why).partition(": ")[2]
            near = {
                "rtol": 1e-12,
                "atol": 1e-12 * np.abs(found[np.isfinite(found)]).max(initial=1.0),
            }
            said = f"{role} of random_block(Random({seed}))"
            np.testing.assert_allclose(
                found, run(block, role, t, x, u), err_msg=said, **near
            )
    return None


PARTS = [range(part * PROGRAMS // 4, (part + 1) * PROGRAMS // 4) for part in range(4)]
MANY = [
    range(first, first + SLOW // 30)
    for first in range(10_000, 10_000 + SLOW, SLOW // 30)
]


@pytest.mark.parametrize(
    "seeds", [*PARTS, *(pytest.param(seeds, marks=pytest.mark.slow) for seeds in MANY)]
)
def test_random_programs_are_read_as_they_run(seeds):
    """Hardly any are not read."""
    refused = Counter(why for why in map(compare, seeds) if why)
    assert refused.total() <= len(seeds) // 25, refused
