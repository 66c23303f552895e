"""`clpt replay --follow` as a process: signals, full disks, folders that go away."""

import json
import signal
import sys
from signal import SIGTERM as TERM
from types import SimpleNamespace

import pytest
from processes import ran, without_progress
from synthetic_vehicle import one_file_each
from typer.testing import CliRunner

from clpt_control.cli import application, replay_report
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


@pytest.fixture(scope="module")
def sizes(tmp_path_factory):
    """How large the results are on this machine."""
    folder = tmp_path_factory.mktemp("whole")
    words = ["replay", "--sample", "--json", "--out", str(folder)]
    assert CliRunner().invoke(application(), words).exit_code == 0
    return {name: (folder / name).stat().st_size for name in RESULTS}


@pytest.mark.parametrize(
    "name",
    ["map.png", *(pytest.param(n, marks=pytest.mark.processes) for n in RESULTS if n != "map.png")],
)
def test_a_full_disk_leaves_the_results_as_they_were(tmp_path, sizes, name):
    """A limit on files stands in for the disk; a file is one half too large."""
    for other in RESULTS:
        (tmp_path / other).write_text("old")
    words = ("replay", "--sample", "--json", "--out", tmp_path)
    done = ran(sys.executable, "-c", LIMITED, sizes[name] // 2, *words, status=2)
    said = without_progress(done.stderr)
    assert "cannot be written" in said
    assert said.count("\n") == 1
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == dict.fromkeys(
        RESULTS, "old"
    )


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


def test_mistakes_of_following(clpt, refused, tmp_path):
    inbox = tmp_path / "in"
    inbox.mkdir()
    for words, says in (
        (("--every", "inf"), "--every inf s: must be above 0 s and at most 86400 s"),
        (("--every", "1e300"), "at most 86400 s"),
        (("--every", "nan"), "at most 86400 s"),
        (("--every", "0"), "above 0 s"),
        (("--patience", "nan"), "--patience nan s: must be 0 s or more"),
        (("--out", inbox), "would lie in the followed folder"),
        (("--out", ""), "'--out': is empty"),
    ):
        assert says in refused("replay", "--follow", inbox, *words)
    assert "'--follow': is empty" in clpt("replay", "--follow", "").err
    assert clpt("replay", "--follow", tmp_path / "none").status == 2
    assert not (tmp_path / "none").exists()
    assert list(inbox.iterdir()) == []


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
