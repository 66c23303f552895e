"""`clpt replay --follow` as a process: signals, full disks, folders that go away."""

import json
import resource
import signal
import subprocess
import sys
import time

import pytest
from synthetic_vehicle import one_file_each

from clpt_control.ocean.gliders.dive_table import sample_dives

START = [sys.executable, "-m", "clpt_control", "replay"]
RESULTS = ("replay.nc", "map.png", "clpe.png", "current.png")


def started(folder, out, *words):
    """A follower that has learned what is there."""
    process = subprocess.Popen(
        [*START, "--follow", folder, "--out", out, "--every", "0.05", *words],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    said = process.stderr.readline()
    while " used" not in said:
        assert process.poll() is None
        said = process.stderr.readline()
    return process, said


def test_sigterm_ends_following_with_its_results(tmp_path):
    one_file_each(tmp_path, sample_dives()[:1])
    process, said = started(tmp_path, tmp_path / "out", "--json")
    assert said.startswith("1 new file, 1 dive used; dive 304")
    process.send_signal(signal.SIGTERM)
    printed, _ = process.communicate(timeout=60)
    assert process.returncode == 0
    assert json.loads(printed)["used"] == 1


@pytest.mark.parametrize("delay", [0.3, 0.7, 1.0, 1.3])
def test_an_early_interrupt_is_one_line(tmp_path, delay):
    one_file_each(tmp_path, sample_dives())
    process = subprocess.Popen(
        [*START, "--follow", tmp_path, "--out", tmp_path / "out", "--json"],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    time.sleep(delay)
    process.send_signal(signal.SIGINT)
    printed, said = process.communicate(timeout=60)
    if process.returncode == 0:
        assert json.loads(printed)["used"] == 14  # it was done by then
        return
    # Python itself may end by the signal, 130 in a shell, where it caught it in an import
    assert process.returncode in (130, -signal.SIGINT)
    assert printed == ""
    assert said == "clpt: interrupted; nothing half-written was left\n"


def test_a_folder_that_is_removed_ends_following(tmp_path):
    folder, out = tmp_path / "in", tmp_path / "out"
    folder.mkdir()
    one_file_each(folder, sample_dives()[:2])
    process, _ = started(folder, out)
    folder.rename(tmp_path / "away")
    _, said = process.communicate(timeout=60)
    assert process.returncode == 2
    assert said.startswith(f"clpt: {folder}: cannot be looked into; what was read is kept in")
    assert said.count("\n") == 1
    assert {path.name for path in (out / "state").glob("*.json")} == {
        "dive304.csv.json", "dive305.csv.json"
    }  # fmt: skip


@pytest.mark.parametrize("size", [4_000, 40_000, 90_000])
def test_a_full_disk_leaves_the_results_as_they_were(tmp_path, size):
    """A limit on files stands in for the disk; at first NetCDF, then figures meet it."""
    for name in RESULTS:
        (tmp_path / name).write_text("old")
    done = subprocess.run(
        [*START, "--sample", "--json", "--out", tmp_path],
        capture_output=True, text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)),
    )  # fmt: skip
    assert done.returncode == 2
    assert "cannot be written" in done.stderr
    assert done.stderr.count("\n") == 1
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == dict.fromkeys(
        RESULTS, "old"
    )


def test_mistakes_of_following(clpt, tmp_path):
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
        outcome = clpt("replay", "--follow", inbox, *words)
        assert (outcome.status, outcome.err.count("\n")) == (2, 1)
        assert says in outcome.err
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


def test_patience_is_time(clpt, tmp_path):
    begin = time.monotonic()
    assert clpt("replay", "--follow", tmp_path, "--every", "1000", "--patience", "0.3").status == 0
    assert 0.3 <= time.monotonic() - begin < 20
