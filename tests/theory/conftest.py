"""What many tests of proofs share."""

import pytest

from clpt_control.theory.proving import point_search, running_rate


@pytest.fixture
def few_calls(monkeypatch):
    """Most points are asked of the blocks' records; python-control takes longest for a point."""
    monkeypatch.setattr(running_rate, "THROUGH_CONTROL", 5)
    monkeypatch.setattr(running_rate, "CALLED", 1)


@pytest.fixture
def few_draws(monkeypatch):
    """A refuting point is looked for at few draws: refuted or open, both are not proved."""
    monkeypatch.setattr(point_search, "SEARCHES", 2)
