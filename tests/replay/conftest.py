"""Files of gliders that ship with the tests."""

from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def glider_records():
    return Path(__file__).parents[1] / "data" / "glider"
