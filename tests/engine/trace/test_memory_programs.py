"""A function that remembers runs in Python, with a sentence on what it remembers."""

import random

import control
import numpy as np
import pytest
from engine_runs import Confirmation, Unread, blocks_of
from memory_programs import made, programs

EVERY = [*programs()]
random.Random(0).shuffle(EVERY)
IN_A_TEST = 25
PARTS = [
    pytest.param(k, marks=[] if k < 8 * IN_A_TEST else pytest.mark.slow)
    for k in range(0, len(EVERY), IN_A_TEST)
]
REMEDY = "Make it a state, set it in a jump, or use parts.relay or parts.backlash"


def values_along(function, states):
    """Return what Python gives at states, one after the other."""
    return np.array([function(0.0, np.array(x), np.zeros(0), {}) for x in states])


@pytest.mark.parametrize("start", PARTS)
def test_functions_that_remember_are_refused(start, monkeypatch):
    """The tracer alone sees them, without the comparison of records."""
    monkeypatch.setattr(Confirmation, "difference", lambda self: "")
    states = np.random.default_rng(0).normal(size=(40, 2))
    for name, text in EVERY[start : start + IN_A_TEST]:
        forward = values_along(made(text), states)
        backward = values_along(made(text), states[::-1])[::-1]
        assert not np.array_equal(forward, backward), f"{name}: does not remember"
        system = control.nlsys(made(text), None, inputs=0, outputs=2, states=2)
        ((_, block),) = blocks_of(system)
        with pytest.raises(Unread) as refused:
            block.array_record("update")
        sentence = str(refused.value)
        assert "where calls may store" in sentence or REMEDY in sentence, (
            f"{name}: {sentence}"
        )
