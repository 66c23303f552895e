"""What many tests of proofs share."""

import pytest

import clpt_control


@pytest.fixture(scope="session")
def paper():
    return clpt_control.paper_scenario().with_values({"run.duration": 400})


@pytest.fixture(scope="session")
def true_paper(paper):
    return paper.started_true()
