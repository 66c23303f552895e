"""What many tests of proofs share."""

import pytest

import clpt_control
from clpt_control.theory.proofs import point_search, same_as_running


@pytest.fixture(scope="session")
def paper():
    return clpt_control.paper_scenario().with_values({"run.duration": 400})


@pytest.fixture(scope="session")
def true_paper(paper):
    return clpt_control.theory.started_true(paper)


@pytest.fixture
def few_calls(monkeypatch):
    """Most points are asked of the blocks' records; python-control takes longest for a point."""
    monkeypatch.setattr(same_as_running, "THROUGH_CONTROL", 5)


@pytest.fixture
def few_draws(monkeypatch):
    """A refuting point is looked for at few draws: refuted or open, both are not proved."""
    monkeypatch.setattr(point_search, "SEARCHES", 2)
