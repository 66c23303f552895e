"""Random functions in ordinary Python: the record computes what the function does."""

import random
from collections import Counter

import numpy as np
import pytest
from random_diagrams import random_block
from recorded import recorded, run

from clpt_control.equations.arrays import Unread

PROGRAMS, SLOW = 100, 3000


def compare(seed):
    """Compare every record of a block with its functions; return why one cannot be read."""
    block, numbers = random_block(random.Random(seed), "mine"), np.random.default_rng(seed)
    for role in block._roles:
        for size in (1.0, 0.1, 4.0):
            t = float(numbers.uniform(0.0, 5.0))
            x, u = (size * numbers.normal(size=n) for n in (block.nstates, block.ninputs))
            try:
                found = recorded(block, role, t, x, u)
            except Unread as why:
                return str(why).partition(": ")[2]
            scale = np.abs(found[np.isfinite(found)]).max(initial=1.0)
            np.testing.assert_allclose(
                found,
                run(block, role, t, x, u),
                rtol=1e-12,
                atol=1e-12 * scale,
                err_msg=f"{role} of random_block(Random({seed}))",
            )
    return None


def compare_all(seeds):
    """Compare many; hardly any are not read."""
    refused = Counter(why for why in map(compare, seeds) if why)
    assert refused.total() <= len(seeds) // 25, refused


@pytest.mark.parametrize("part", range(4))
def test_random_programs_are_read_as_they_run(part):
    compare_all(range(part * PROGRAMS // 4, (part + 1) * PROGRAMS // 4))


@pytest.mark.slow
@pytest.mark.parametrize("part", range(30))
def test_many_random_programs_are_read_as_they_run(part):
    compare_all(range(10_000 + part * SLOW // 30, 10_000 + (part + 1) * SLOW // 30))
