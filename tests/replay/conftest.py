"""`clpt replay` in-process, for tests of the room."""

import pytest
from typer.testing import CliRunner

from clpt_control.cli import application


@pytest.fixture
def command():
    """Run `clpt replay WORDS`; what a user's mistake raises is kept as `exception`."""
    app = application()
    return lambda *words: CliRunner().invoke(app, ["replay", *map(str, words)])


@pytest.fixture
def follow(command):
    """Run `clpt replay --follow FOLDER WORDS` for one look."""
    return lambda folder, *words: command("--follow", folder, "--patience", "0", *words)
