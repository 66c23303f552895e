"""Commands run in a folder of their own."""

import pytest


@pytest.fixture(autouse=True)
def here(tmp_path, monkeypatch):
    """Each test of a command begins in an empty folder."""
    monkeypatch.chdir(tmp_path)
