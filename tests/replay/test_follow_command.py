"""`clpt replay --follow`, and the hook of basestation3 that runs it: what is said and written."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from signal import SIGTERM as TERM
from types import SimpleNamespace

import pytest
from processes import ran, without_progress
from synthetic_vehicle import one_file_each

from clpt_control.cli import replay_report
from clpt_control.gliders.dive_files import sample_dives

RESULTS = (
    "replay.nc",
    "replay.html",
    "next.geojson",
    "track.kml",
    "map.png",
    "clpe.png",
    "current.png",
)


@pytest.mark.usefixtures("undrawn")
def test_the_command_follows(follow, sample, tmp_path):
    (tmp_path / "in").mkdir()
    words = (tmp_path / "in", "--out", tmp_path / "out", "--json")
    empty = json.loads(follow(*words).stdout)
    assert empty["used"] == 0
    assert empty["clpe_rms"]["adaptive"] is None
    for part in (sample_dives()[:5], sample_dives()[5:]):
        one_file_each(tmp_path / "in", part)
        followed = json.loads(follow(*words).stdout)
    # the table of dives names none
    assert followed == sample.found | {"vehicle": "glider", "kind": None}
    assert (tmp_path / "out" / "replay.nc").exists()


@pytest.mark.usefixtures("undrawn")
def test_what_the_dives_so_far_do_not_allow_is_told_and_work_goes_on(command, follow, tmp_path):
    """Two tides on one dive, and aiming by a vehicle that does not swim."""
    one_file_each(
        tmp_path, [replace(dive, dr_east=0.0, dr_north=0.0) for dive in sample_dives()[:1]]
    )
    words = ("--flow", "steady,M2,S2", "--estimator", "gradient", "--aim", "-42.5", "8.0", "--json")
    for _ in range(2):  # its own results, which lie in the folder by default, are no dives
        done = follow(tmp_path, *words)
        found = json.loads(done.stdout)
        assert (found["used"], found["aim"]) == (1, [])
    assert (tmp_path / "replay" / "replay.nc").exists()
    assert "so far, flow steady,M2,S2" in done.stderr
    assert "so far, --aim: 0 m/s, given or of the last dives, leads nowhere" in done.stderr
    assert set(found["clpe_rms"].values()) == {None}
    assert found["clpe_rms_all"]["no_flow"] > 0
    two = command("--sample", "--flow", "steady,M2,K1", "--estimator", "gradient")
    assert two.exit_code == 0


@pytest.mark.usefixtures("undrawn", "few_draws")
def test_the_line_of_following(follow, tmp_path):
    dives = sample_dives()[:3]
    one_file_each(tmp_path, dives)
    near = dives[2].lat_gpse + 0.001, dives[2].lon_gpse  # come close to: the next one is aimed at
    way = tmp_path / "way.txt"
    way.write_text(f"{near[0]} {near[1]}\n-42.5 8.0\n")
    done = follow(tmp_path, "--route", way, "--json")
    line = next(line for line in done.stderr.splitlines() if "dives used" in line)
    said = r"3 new files, 3 dives used; dive 306: miss \d+ m; next surfacing 2016-02-01"
    assert re.search(said, line)
    assert "h from the end of the last dive, near 43 " in line
    assert "; aim at 42 30.00 S 8 00.00 E" in line
    assert len(json.loads(done.stdout)["aim"]) == 1


@pytest.mark.usefixtures("undrawn")
def test_sigterm_ends_following_with_its_results(clpt, tmp_path, monkeypatch):
    one_file_each(tmp_path, sample_dives()[:1])
    before = signal.getsignal(TERM)
    monkeypatch.setattr(replay_report.interrupt, "wait", lambda _: signal.raise_signal(TERM))
    outcome = clpt("replay", "--follow", tmp_path, "--out", tmp_path / "out", "--json")
    assert outcome.err.startswith("1 new file, 1 dive used; dive 304")
    assert outcome.status == 0
    assert json.loads(outcome.out)["used"] == 1
    assert signal.getsignal(TERM) is before


LIMITED = """
import resource, sys
from pathlib import Path
size = int(sys.argv.pop(1))
import matplotlib.font_manager  # what it keeps for itself is written before
resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
from clpt_control.cli import main
main()
"""


@pytest.mark.parametrize(
    "name",
    ["map.png", *(pytest.param(n, marks=pytest.mark.processes) for n in RESULTS if n != "map.png")],
)
def test_a_full_disk_leaves_the_results_as_they_were(tmp_path, sample, name):
    """A limit on files stands in for the disk; a file is one half too large."""
    for other in RESULTS:
        (tmp_path / other).write_text("old")
    size = (sample.folder / name).stat().st_size // 2
    words = ("replay", "--sample", "--json", "--out", tmp_path)
    said = without_progress(ran(sys.executable, "-c", LIMITED, size, *words, status=2).stderr)
    assert "cannot be written" in said
    assert said.count("\n") == 1
    left = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert left == dict.fromkeys(RESULTS, "old")


@pytest.mark.usefixtures("undrawn")
def test_a_folder_in_the_place_of_a_result_leaves_all_others_as_they_were(refused, tmp_path):
    inbox, out = tmp_path / "in", tmp_path / "out"
    inbox.mkdir()
    one_file_each(inbox, sample_dives()[:2])
    (out / "replay.html").mkdir(parents=True)
    others = [name for name in RESULTS if name != "replay.html"]
    for name in others:
        (out / name).write_text("old")
    for words in (("--follow", inbox, "--patience", "0"), (inbox,)):
        assert "replay.html: is a folder" in refused("replay", *words, "--out", out)
        assert [(out / name).read_text() for name in others] == ["old"] * len(others)
        assert not list(out.glob(".*.part"))


def test_following_without_dives_says_so(clpt, tmp_path):
    (tmp_path / "half.nc").write_bytes(b"CDF\x01")
    outcome = clpt("replay", "--follow", tmp_path, "--patience", "0")
    assert outcome.status == 0
    assert outcome.err == "1 new file, 0 dives used\n"
    assert outcome.out.startswith("no dives yet\nskipped a file: ")
    assert outcome.out.count("\n") == 2


def test_patience_is_time(clpt, tmp_path, monkeypatch):
    """Waits are asked of a clock that moves by them alone."""
    now, waits = [0.0], []

    def wait(seconds):
        waits.append(seconds)
        now[0] += seconds

    monkeypatch.setattr(replay_report, "time", SimpleNamespace(monotonic=lambda: now[0]))
    monkeypatch.setattr(replay_report.interrupt, "wait", wait)
    for every, expected in (("1000", [25.0]), ("10", [10.0, 10.0, 5.0])):
        waits.clear()
        words = ("--every", every, "--patience", "25")
        assert clpt("replay", "--follow", tmp_path, *words).status == 0
        assert waits == expected


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
