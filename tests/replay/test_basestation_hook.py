"""The hook of examples, run as basestation3 runs `.post_dive`: by a shell."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

HOOK = Path(__file__).parents[2] / "examples" / "basestation3_post_dive.sh"


@pytest.fixture
def mission(tmp_path, facts):
    """A mission directory with dives and what else lies there; `NewMission` links the hook."""
    home = tmp_path / "sg542"
    shutil.copytree(facts / "glider" / "basestation", home / "mission")
    shutil.copy(HOOK, home / ".post_dive")
    (home / "mission" / ".post_dive").symlink_to(home / ".post_dive")
    (home / "mission" / "comm.log").write_text("no dive\n")
    (home / "mission" / "sg542_profile.nc").write_bytes(b"no NetCDF")
    return home / "mission"


def logged(line, folder):
    """Run a line as `Utils.run_cmd_shell` does, where `clpt` tells its words; return the log."""
    clpt = folder / "clpt"
    clpt.write_text('#!/bin/sh\necho a table; echo "$@" >&2\n')
    clpt.chmod(0o755)
    path = f"{folder}:{os.environ['PATH']}"
    options = {"shell": True, "text": True, "check": True, "env": {**os.environ, "PATH": path}}
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    return subprocess.run(line, cwd="/", **options, **pipes).stdout


@pytest.mark.usefixtures("undrawn")
def test_the_page_is_written_after_each_dive(mission, clpt, tmp_path):
    words = logged(f"{mission}/.post_dive ", tmp_path)  # as older versions do
    assert logged(f"{mission}/.post_dive {tmp_path}/basestation {mission} ", tmp_path) == words
    asked = f"replay --follow {mission} --patience 0 --out {mission}/clpt\n"
    assert words == asked  # and nothing of standard output
    outcome = clpt(*words.split())
    assert outcome.status == 0
    assert "7 new files, 6 dives used; dive 309: miss " in outcome.err
    assert outcome.err.count("\n") == 1  # a line of the log
    assert "dive 309" in (mission / "clpt" / "replay.html").read_text("utf-8")
