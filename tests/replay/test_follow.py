"""Following a folder: new, renamed and unreadable files, kills, one process at a time."""

import os
import random
import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from synthetic_vehicle import one_file_each, vehicle

from clpt_control.errors import DataError
from clpt_control.gliders.dive_files import read_dives, sample_dives
from clpt_control.gliders.usable_dives import usable
from clpt_control.replay import follow
from clpt_control.replay.follow import Follower, following
from clpt_control.replay.replay import Replay


@pytest.mark.parametrize(
    "seed", [0, 1, 2, 3, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(4, 20))]
)
def test_any_history_of_a_folder(tmp_path, seed):
    """Files are written, cut short, copied, renamed and removed; followers end and begin.

    A dive is known where a file holds it, or did when it was last seen.
    """
    rng = random.Random(seed)
    inbox = tmp_path / "in"
    one_file_each(tmp_path, sample_dives()[:5])
    inbox.mkdir()
    whole = {int(path.stem[4:]): path.read_text() for path in tmp_path.glob("dive*.csv")}
    follower, seen = Follower(inbox, tmp_path / "state"), {}
    for _ in range(25):
        there = sorted(inbox.iterdir())
        name = rng.choice(list(whole))
        match rng.choice(["write", "write", "cut", "copy", "rename", "remove", "restart"]):
            case "write":
                (inbox / f"{name}.csv").write_text(whole[name])
            case "cut":
                (inbox / f"{name}.csv").write_text(whole[name][: rng.choice([0, 5, 60])])
            case "copy" if there:
                (inbox / f"{rng.randrange(3)}.csv").write_text(rng.choice(there).read_text())
            case "rename" if there:
                rng.choice(there).rename(inbox / f"{rng.randrange(3)}.csv")
            case "remove" if there:
                rng.choice(there).unlink()
            case "restart":
                follower = Follower(inbox, tmp_path / "state")
        if rng.random() < 0.7:
            follower.look()
            texts = {path.name: path.read_text() for path in inbox.iterdir()}
            seen |= {k: [n for n in whole if whole[n] == text] for k, text in texts.items()}
            known = [dive.number for dive in usable(follower.dives()[0])[0]]
            assert known == sorted({n for numbers in seen.values() for n in numbers})
            again = Follower(inbox, tmp_path / "state")
            assert again.look() == []
            assert repr(again.dives()) == repr(follower.dives())


@pytest.fixture
def inbox(tmp_path):
    """A folder with the first three sample dives."""
    (tmp_path / "in").mkdir()
    one_file_each(tmp_path / "in", sample_dives()[:3])
    return tmp_path / "in"


def numbers(follower):
    dives, skipped = follower.dives()
    used, unused = usable(dives)
    return [dive.number for dive in used], [entry.why for entry in (*skipped, *unused)]


def refused(folder, out, says):
    with pytest.raises(DataError, match=says), following(folder, out):
        pass


def test_results_never_lie_in_the_followed_folder(inbox, tmp_path):
    (tmp_path / "link").symlink_to(inbox)
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "state").symlink_to(inbox)
    for out in (inbox, inbox / "." / "..", tmp_path / "link", tmp_path / "out"):
        if out.name == "..":
            with following(inbox, out):  # the folder above is another
                continue
        refused(inbox, out, "would lie in the followed folder")
    with following(inbox, inbox / "replay") as follower:
        assert len(follower.look()) == 3
    for missing in ("none", "in/dive304.csv", "loop"):
        if missing == "loop":
            (tmp_path / "loop").symlink_to("loop")
        refused(tmp_path / missing, tmp_path / "other", "no such folder")
        assert not (tmp_path / "other").exists()


def test_a_state_belongs_to_its_folder(inbox, tmp_path, monkeypatch):
    state = tmp_path / "state"
    Follower(inbox, state).look()
    other = tmp_path / "other vehicle"
    other.mkdir()
    one_file_each(other, vehicle(3, 2))
    kept = {path.name: path.read_bytes() for path in state.iterdir()}
    with pytest.raises(DataError, match=r"keeps what was read in .*/in, not in .*/other vehicle"):
        Follower(other, state)
    assert kept == {path.name: path.read_bytes() for path in state.iterdir()}
    monkeypatch.chdir(tmp_path)
    (tmp_path / "link").symlink_to(inbox)
    assert Follower("link", "state").look() == []  # another name of the same folder


def test_a_skipped_file_has_its_new_name_and_a_copy_is_a_duplicate(inbox, tmp_path):
    (inbox / "half.nc").write_bytes(b"CDF\x01" + bytes(5))
    follower = Follower(inbox, tmp_path / "state")
    follower.look()
    (inbox / "half.nc").rename(inbox / "part.nc")
    shutil.copy(inbox / "dive306.csv", inbox / "twice.csv")
    follower.look()
    found, why = numbers(follower)
    assert found == [304, 305, 306]
    assert "part.nc" in why[0]
    assert "duplicate" in why[-1]


def test_a_file_rewritten_with_its_old_size_and_date_is_read_again(inbox, tmp_path):
    path = inbox / "dive305.csv"
    follower = Follower(inbox, tmp_path / "state")
    follower.look()
    dated = path.stat()
    text = path.read_text()
    path.write_text(text.replace("305,", "999,", 1))
    os.utime(path, ns=(dated.st_atime_ns, dated.st_mtime_ns))
    assert path.stat().st_size == dated.st_size
    assert follower.look() == ["dive305.csv"]
    assert numbers(follower)[0] == [304, 999, 306]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with a name on this system")
def test_a_file_that_becomes_a_pipe_once_it_was_asked_is_not_waited_for(
    inbox, tmp_path, monkeypatch
):
    follower, other = Follower(inbox, tmp_path / "state"), inbox / "dive305.csv"

    def asked(path):
        if path == other:
            path.unlink()
            os.mkfifo(path)
        return False

    monkeypatch.setattr(follow, "is_segment", asked)
    assert follower.look() == ["dive304.csv", "dive305.csv", "dive306.csv"]
    found, why = numbers(follower)
    assert found == [304, 306]
    assert "dive305.csv: is no regular file; give one" in why[0]


def test_what_cannot_be_opened_is_tried_again(inbox, tmp_path, monkeypatch):
    closed = inbox / "dive305.csv"
    plain, shut = follow.at_once, True

    def opened(name, flags):
        if shut and Path(name) == closed:
            raise PermissionError(13, "Permission denied")
        return plain(name, flags)

    monkeypatch.setattr(follow, "at_once", opened)
    (inbox / "loop.csv").symlink_to("loop.csv")
    follower = Follower(inbox, tmp_path / "state")
    assert follower.look() == ["dive304.csv", "dive305.csv", "dive306.csv", "loop.csv"]
    found, why = numbers(follower)
    assert found == [304, 306]
    assert "Permission denied; is tried at each look" in why[0]
    assert "loop.csv: cannot be read" in why[1]
    assert follower.look() == []  # the same as before is nothing new
    assert Follower(inbox, tmp_path / "state").look() == []
    shut = False
    assert follower.look() == ["dive305.csv"]
    assert numbers(follower)[0] == [304, 305, 306]

    shut = True
    closed.touch()
    assert follower.look() == ["dive305.csv"]
    assert numbers(follower)[0] == [304, 305, 306]  # its dives are known
    assert "dive305.csv: cannot be read" in numbers(follower)[1][0]


def test_a_folder_that_goes_away_is_a_sentence(inbox, tmp_path):
    follower = Follower(inbox, tmp_path / "state")
    follower.look()
    inbox.rename(tmp_path / "away")
    with pytest.raises(DataError, match="cannot be looked into; what was read is kept"):
        follower.look()
    assert numbers(follower)[0] == [304, 305, 306]
    (tmp_path / "away").rename(inbox)
    assert Follower(inbox, tmp_path / "state").look() == []


def test_files_are_in_the_order_of_their_numbers(tmp_path):
    """Else what is noted of dives, and the whole replay with it, changes with later files."""
    (tmp_path / "in").mkdir()
    follower = Follower(tmp_path / "in", tmp_path / "state")
    growing = Replay()
    dives = [replace(dive, number=k) for k, dive in enumerate(sample_dives()[:12], 1)]
    for dive in dives:
        one_file_each(tmp_path / "in", [dive])
        follower.look()
        used, _ = usable(follower.dives()[0])
        assert [one.number for one in used] == [*range(1, dive.number + 1)]
        assert [one.notes for one in used] == [one.notes for one in dives[: dive.number]]
        assert [one.notes for one in read_dives(tmp_path / "in")[0]] == [one.notes for one in used]
        first = growing.steps
        assert growing.feed(used).steps is first


@pytest.mark.parametrize("name", ["x" * 240 + ".csv", "\udcff.csv"])
def test_a_name_under_which_nothing_can_be_kept_is_left_out(inbox, tmp_path, name):
    (inbox / name).write_text("any")
    follower = Follower(inbox, tmp_path / "state")
    assert len(follower.look()) == 3
    dives, (left,) = follower.dives()
    assert (len(dives), "name" in left.why) == (3, True)


def test_one_follows_at_a_time(inbox, tmp_path):
    with following(inbox, tmp_path / "out") as follower:
        refused(inbox, tmp_path / "out", "another clpt follows here")
        assert len(follower.look()) == 3
