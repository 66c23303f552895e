"""Watching a folder: new, changed, renamed, unreadable files; a folder that goes away."""

import os
import random
from dataclasses import replace
from pathlib import Path

import pytest
from synthetic_vehicle import one_file_each
from watched_folder import watched

from clpt_control.gliders import read_dives, sample_dives
from clpt_control.replay import Replay

LONG = [pytest.param(seed, marks=pytest.mark.long) for seed in range(1, 4)]
SLOW = [pytest.param(seed, marks=pytest.mark.slow) for seed in range(4, 20)]


@pytest.fixture
def inbox(tmp_path):
    """A folder with the first three sample dives."""
    (tmp_path / "in").mkdir()
    one_file_each(tmp_path / "in", sample_dives()[:3])
    return tmp_path / "in"


@pytest.fixture
def watch(clpt, monkeypatch, undrawn):
    """Watch a folder with a change before each further look; return what is found and told."""
    return lambda folder, *changes: watched(clpt, monkeypatch, folder, changes)


def numbers(found):
    return [row["dive"] for row in found["each_dive"]]


def looks(told):
    """Return how many new files each replay had."""
    return [int(line.split()[0]) for line in told.splitlines() if "dives used" in line]


@pytest.mark.long
@pytest.mark.parametrize("seed", [0, *LONG, *SLOW])
def test_any_history_of_a_folder(tmp_path, seed, watch):
    """Files are written, cut short, copied, renamed and removed: the numbers of the last files."""
    rng, inbox = random.Random(seed), tmp_path / "in"
    one_file_each(tmp_path, sample_dives()[:5])
    inbox.mkdir()
    whole = [path.read_text() for path in tmp_path.glob("dive*.csv")]

    def change():
        there = sorted(inbox.glob("*.csv"))
        file = inbox / f"{rng.randrange(5)}.csv"
        match rng.choice(["write", "write", "cut", "copy", "rename", "remove"]):
            case "write":
                file.write_text(rng.choice(whole))
            case "cut":
                file.write_text(rng.choice(whole)[: rng.choice([0, 5, 60])])
            case "copy" if there:
                file.write_text(rng.choice(there).read_text())
            case "rename" if there:
                rng.choice(there).rename(file)
            case "remove" if there:
                rng.choice(there).unlink()

    found, _ = watch(inbox, *[change] * 8)
    anew, _ = watch(inbox)
    assert found == anew


def test_results_in_the_folder_are_no_new_files(inbox, watch):
    found, told = watch(inbox)
    assert (numbers(found), looks(told)) == ([304, 305, 306], [3])
    assert (inbox / "replay" / "replay.html").exists()


@pytest.mark.long
def test_new_and_changed_files_are_counted(inbox, watch):
    def arrive():
        one_file_each(inbox, sample_dives()[3:5])

    def change():
        path = inbox / "dive305.csv"
        path.write_text(path.read_text().replace("305,", "999,", 1))

    found, told = watch(inbox, arrive, lambda: None, change)
    assert looks(told) == [3, 2, 1]
    assert numbers(found) == [304, 999, 306, 307, 308]


def test_results_never_lie_in_the_followed_folder(inbox, tmp_path, clpt):
    (tmp_path / "link").symlink_to(inbox)
    for out in (inbox, tmp_path / "link"):
        done = clpt("watch", inbox, "--patience", 0, "--out", out)
        assert (done.status, len(list(inbox.iterdir()))) == (2, 3)
        assert "would be in the watched folder" in done.err
    (tmp_path / "loop").symlink_to("loop")
    for missing in ("none", "in/dive304.csv", "loop"):
        words = tmp_path / missing, "--patience", 0, "--out", tmp_path / "other"
        done = clpt("watch", *words)
        assert (done.status, "folder not found" in done.err) == (2, True)
        assert not (tmp_path / "other").exists()


@pytest.mark.long
def test_a_file_rewritten_with_its_old_size_and_date_is_read_again(inbox, watch):
    def rewrite():
        path = inbox / "dive305.csv"
        dated = path.stat()
        path.write_text(path.read_text().replace("305,", "999,", 1))
        os.utime(path, ns=(dated.st_atime_ns, dated.st_mtime_ns))
        assert path.stat().st_size == dated.st_size

    found, _ = watch(inbox, rewrite)
    assert numbers(found) == [304, 999, 306]


@pytest.mark.long
def test_a_file_that_becomes_a_pipe_once_it_was_asked_is_not_waited_for(
    inbox, watch, monkeypatch
):
    other, plain = inbox / "dive305.csv", os.open

    def opened(name, *how, **where):
        if Path(name) == other and other.is_file():
            other.unlink()
            os.mkfifo(other)
        return plain(name, *how, **where)

    monkeypatch.setattr(os, "open", opened)
    found, told = watch(inbox)
    assert numbers(found) == [304, 306]
    assert "dive305.csv: is not a regular file. Give a file" in told


@pytest.mark.long
def test_a_file_that_cannot_be_opened_is_told_once_and_tried_when_it_changes(
    inbox, watch, monkeypatch
):
    closed = inbox / "dive305.csv"
    plain, shut = os.open, [True]

    def opened(name, *how, **where):
        if shut[0] and Path(name) == closed:
            raise PermissionError(13, "Permission denied")
        return plain(name, *how, **where)

    def allow():
        shut[0] = False
        closed.chmod(0o600)

    monkeypatch.setattr(os, "open", opened)
    (inbox / "loop.csv").symlink_to("loop.csv")
    one = sample_dives()[3:4]
    found, told = watch(inbox, lambda: one_file_each(inbox, one), allow)
    assert (numbers(found), looks(told)) == ([304, 305, 306, 307], [3, 1, 1])
    assert told.count("dive305.csv: cannot be read: Permission denied") == 1
    assert told.count("loop.csv: cannot be read") == 1


@pytest.mark.long
def test_a_folder_that_goes_away_for_a_while_loses_nothing(inbox, tmp_path, watch):
    away = tmp_path / "away"
    new = sample_dives()[3:4]
    changes = [
        lambda: inbox.rename(away),
        lambda: None,
        lambda: away.rename(inbox),
        lambda: one_file_each(inbox, new),
    ]
    found, told = watch(inbox, *changes[:2])
    assert (numbers(found), looks(told)) == ([304, 305, 306], [3])
    away.rename(inbox)
    found, told = watch(inbox, *changes)
    assert (numbers(found), looks(told)) == ([304, 305, 306, 307], [3, 1])


def test_files_are_in_the_order_of_their_numbers(tmp_path):
    """Else what is noted of dives, and the whole replay with it, changes with later files."""
    growing = Replay()
    dives = [replace(dive, number=k) for k, dive in enumerate(sample_dives()[:12], 1)]
    for dive in dives:
        one_file_each(tmp_path, [dive])
        used, _ = read_dives(tmp_path)
        wanted = [(one.number, one.notes) for one in dives[: dive.number]]
        assert [(one.number, one.notes) for one in used] == wanted
        first = growing.steps
        assert growing.feed(used).steps is first


@pytest.mark.sampled
@pytest.mark.parametrize("name", ["x" * 240 + ".csv", "\udcff.csv"])
def test_a_file_with_an_odd_name_hides_no_other(inbox, watch, name):
    (inbox / name).write_text("any")
    found, _ = watch(inbox)
    assert numbers(found) == [304, 305, 306]
    assert "no column dive" in found["skipped"][0]["why"]
