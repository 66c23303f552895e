"""Commands run in a folder of their own."""

from pathlib import Path

import pytest


@pytest.fixture(autouse=True)
def here(tmp_path, monkeypatch):
    """Each test of a command begins in an empty folder."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def refused_for(refused):
    """Run a command, a user's mistake, whose line holds words, and which writes nothing."""

    def run(words, *arguments):
        before = sorted(Path().rglob("*"))
        said = refused(*arguments)
        assert all(word in said for word in words), said
        assert sorted(Path().rglob("*")) == before
        return said

    return run
