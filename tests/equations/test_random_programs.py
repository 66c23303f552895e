"""Random functions in ordinary Python: the record computes what the function does."""

import random
from collections import Counter

import numpy as np
import pytest
from random_programs import executed, program
from recorded import recorded, run

from clpt_control.equations import Block
from clpt_control.equations.arrays import Unread

SHAPES = ((1,), (2,), (3,), (5,), (2, 3), (3, 3))
NUMBERS = {"v": (3,), "w": (2, 3), "h": (5,)}
PROGRAMS, SLOW = 100, 3000


def drawn(seed):
    """Draw a block of one function, and its text."""
    draw, numbers = random.Random(seed), np.random.default_rng(seed)
    ports = {group: {f"{group}{k}": draw.choice(SHAPES) for k in range(2)} for group in "xuy"}
    takes = {"x": ports["x"], "u": ports["u"]}
    text = program(draw, "update", takes, ports["x"], NUMBERS)
    text += program(draw, "output", takes, ports["y"], NUMBERS)
    space = executed(text)
    block = Block(
        "mine",
        update=space["update"],
        output=space["output"],
        inputs=ports["u"],
        states=ports["x"],
        outputs=ports["y"],
        parameters={"a": 0.7, "b": -1.3, **{k: numbers.normal(size=s) for k, s in NUMBERS.items()}},
    )
    return block, text


def compare(block, text, seed):
    """Compare every record of a block with its functions; return why one cannot be read."""
    numbers = np.random.default_rng(seed)
    for role in ("update", "output"):
        for size in (1.0, 0.1, 4.0):
            t = float(numbers.uniform(0.0, 5.0))
            x, u = (size * numbers.normal(size=n) for n in (block.nstates, block.ninputs))
            try:
                found = recorded(block, role, t, x, u)
            except Unread as why:
                return str(why)
            scale = np.abs(found[np.isfinite(found)]).max(initial=1.0)
            np.testing.assert_allclose(
                found,
                run(block, role, t, x, u),
                rtol=1e-12,
                atol=1e-12 * scale,
                err_msg=f"{seed}\n{text}",
            )
    return None


def compare_all(seeds):
    """Compare many; return how many are not read, and why."""
    refused = Counter()
    for seed in seeds:
        why = compare(*drawn(seed), seed)
        if why:
            refused[why.partition(": ")[2]] += 1
    assert refused.total() <= len(seeds) // 50, refused
    return refused


@pytest.mark.parametrize("part", range(4))
def test_random_programs_are_read_as_they_run(part):
    compare_all(range(part * PROGRAMS // 4, (part + 1) * PROGRAMS // 4))


@pytest.mark.slow
@pytest.mark.parametrize("part", range(30))
def test_many_random_programs_are_read_as_they_run(part):
    compare_all(range(10_000 + part * SLOW // 30, 10_000 + (part + 1) * SLOW // 30))
