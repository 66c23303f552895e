"""What many tests of proofs share."""

import pytest

from clpt_control.theory.proving import point_search


@pytest.fixture
def few_draws(monkeypatch):
    """A refuting point is looked for at few draws: refuted or open, both are not proved."""
    monkeypatch.setattr(point_search, "SEARCHES", 2)
