"""`clpt replay` in-process, and the fourteen dives of SG542, for tests of the room."""

import json
from typing import NamedTuple

import pytest
from typer.testing import CliRunner

from clpt_control.app.cli import application
from clpt_control.gliders import sample_dives
from clpt_control.replay import replay_dives


def run(*words):
    command = [] if words[:1] == ("watch",) else ["replay"]
    return CliRunner().invoke(application(), [*command, *map(str, words)])


@pytest.fixture
def command():
    """Run `clpt replay WORDS`, or `clpt watch WORDS`; `exception` is what a mistake raises."""
    return run


@pytest.fixture
def follow():
    """Run `clpt watch FOLDER WORDS` for one look."""
    return lambda folder, *words: run("watch", folder, "--patience", "0", *words)


class Sample(NamedTuple):
    """What `clpt replay --sample` says, as JSON and as text, and its folder of results."""

    found: dict
    text: str
    folder: object


@pytest.fixture(scope="session")
def sample(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sample")
    said = [run("--sample", *more) for more in (("--json", "--out", folder), ())]
    assert [one.exit_code for one in said] == [0, 0]
    return Sample(json.loads(said[0].stdout), said[1].stdout, folder)


@pytest.fixture(scope="session")
def sg542():
    """The replay of the fourteen dives."""
    return replay_dives(sample_dives())
