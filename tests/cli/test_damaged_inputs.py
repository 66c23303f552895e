"""Whatever an input is, each command answers rightly or in one sentence, in bounded time.

The cases are made in `damaged_inputs`, which says what an answer is.
"""

import json
import os
import sys
from pathlib import Path

import pytest
from processes import ran

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="cases are forked")
CASES = Path(__file__).parents[1] / "damaged_inputs.py"


def wrong_answers(*words):
    """Return how many cases were answered, and those that were answered wrongly."""
    ended = ran(sys.executable, CASES, *words, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    answers = [json.loads(line) for line in ended.stdout.splitlines()]
    keys = ("case", "wrong", "words", "how", "err")
    return len(answers), [{key: one[key] for key in keys} for one in answers if one["wrong"]]


def test_damaged_inputs_are_answered():
    """A share of them; `make test-slow` asks 3,000."""
    assert wrong_answers(0, 40, 0) == (40, [])


@pytest.mark.slow
def test_many_damaged_inputs_are_answered():
    assert wrong_answers(1000, 3000) == (3000, [])
