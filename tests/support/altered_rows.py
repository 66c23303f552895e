"""Altered rows of the table of laws, and statements of `clpt prove` that no function proves.

Tests import these inner names here: a file of the proofs that is merged or moved changes this
file alone.
"""

from contextlib import contextmanager

from small_scenarios import paper_of

import clpt_control as clpt
from clpt_control.paper.laws.table import LAWS
from clpt_control.theory.theorems.all_proofs import PROOFS

__all__ = ["PROOFS", "judged", "replaced"]

FORGETTING = {"learning.composite_least_squares.forgetting": 0.1}  # its row needs one


@contextmanager
def replaced(name, **changes):
    """Replace fields of a row of the table."""
    own = LAWS[name]
    LAWS[name] = own._replace(**changes)
    try:
        yield LAWS[name]
    finally:
        LAWS[name] = own


def judged(name, points=50, **changes):
    """Return the verdict on a law whose row has other fields."""
    scenario = paper_of(2, name)
    if name == "composite-least-squares":
        scenario = scenario.with_values(FORGETTING)
    with replaced(name, **changes):
        return clpt.prove(clpt.closed_loop(scenario), points=points)
