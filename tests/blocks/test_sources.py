"""Sources of the paper's diagram are what the theorems take them for."""

import pytest
from source_checks import CHECKS


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.__name__)
def test_sources(check):
    check()
