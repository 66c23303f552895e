"""The hook of examples, run as basestation3 runs `.post_dive`: by a shell."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from processes import CODE, GUARD

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


@pytest.fixture
def run(tmp_path):
    """Run a command line as `Utils.run_cmd_shell` does; `clpt` is on the path."""
    (tmp_path / "bin").mkdir()
    clpt = tmp_path / "bin" / "clpt"
    clpt.write_text(f'#!/bin/sh\nexec {sys.executable} -c "{CODE}" "$@"\n')
    clpt.chmod(0o755)
    path = f"{clpt.parent}:{os.environ['PATH']}"

    def as_basestation(line):
        out = subprocess.STDOUT
        done = subprocess.run(
            line,
            shell=True,
            stdout=subprocess.PIPE,
            stderr=out,
            text=True,
            timeout=GUARD,
            cwd="/",
            env={**os.environ, "PATH": path},
        )
        assert done.returncode == 0, done.stdout
        return done.stdout

    return as_basestation


def test_the_page_is_written_after_each_dive(mission, run, tmp_path):
    said = run(f"{mission}/.post_dive ")  # as older versions do
    assert "7 new files, 6 dives used; dive 309: miss " in said
    assert said.count("\n") == 1  # a line of the log
    assert "dive 309" in (mission / "clpt" / "replay.html").read_text("utf-8")
    (tmp_path / "bin" / "clpt").write_text('#!/bin/sh\necho "$@" >&2\n')
    told = run(f"{mission}/.post_dive {tmp_path}/basestation {mission} ")  # as newer ones do
    assert told == f"replay --follow {mission} --patience 0 --out {mission}/clpt\n"
    assert run(f"{mission}/.post_dive ") == told
