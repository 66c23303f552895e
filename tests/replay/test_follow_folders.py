"""Following: which folder, renamed and unreadable files, one process at a time."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest
from processes import CLPT, await_line, started
from synthetic_vehicle import one_file_each, vehicle

from clpt_control.errors import DataError
from clpt_control.files import remove_left
from clpt_control.gliders.dive_table import sample_dives
from clpt_control.gliders.usable_dives import usable
from clpt_control.replay.follow import Follower, following


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


def test_results_never_lie_in_the_followed_folder(inbox, tmp_path):
    (tmp_path / "link").symlink_to(inbox)
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "state").symlink_to(inbox)
    for out in (inbox, inbox / "." / "..", tmp_path / "link", tmp_path / "out"):
        if out.name == "..":
            with following(inbox, out):  # the folder above is another
                continue
        with (
            pytest.raises(DataError, match="would lie in the followed folder"),
            following(inbox, out),
        ):
            pass
    with following(inbox, inbox / "replay") as follower:
        assert len(follower.look()) == 3
    for missing in ("none", "in/dive304.csv", "loop"):
        if missing == "loop":
            (tmp_path / "loop").symlink_to("loop")
        with (
            pytest.raises(DataError, match="no such folder"),
            following(tmp_path / missing, tmp_path / "other"),
        ):
            pass
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


def test_a_renamed_file_has_its_dives_once(inbox, tmp_path):
    state = tmp_path / "state"
    (inbox / "half.nc").write_bytes(b"CDF\x01" + bytes(5))
    Follower(inbox, state).look()
    (inbox / "dive305.csv").rename(inbox / "a.csv")
    (inbox / "half.nc").rename(inbox / "part.nc")
    (inbox / "dive306.csv").unlink()
    for _ in range(2):  # and after a restart
        follower = Follower(inbox, state)
        follower.look()
        found, why = numbers(follower)
        assert found == [304, 305, 306]
        assert len(why) == 1
        assert "part.nc" in why[0]
    (inbox / "a.csv").rename(inbox / "b.csv")
    (inbox / "b.csv").rename(inbox / "c.csv")
    follower.look()
    shutil.copy(inbox / "c.csv", inbox / "d.csv")
    (inbox / "c.csv").unlink()
    follower.look()
    (inbox / "d.csv").unlink()
    assert follower.look() == []
    assert numbers(follower)[0] == [304, 305, 306]  # no name of it is left: kept, once
    assert len(numbers(follower)[1]) == 1
    one_file_each(inbox, sample_dives()[2:3])
    shutil.copy(inbox / "dive306.csv", inbox / "twice.csv")
    follower.look()
    assert "duplicate" in numbers(follower)[1][-1]  # two files that are both there


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


def test_what_cannot_be_opened_is_tried_again(inbox, tmp_path, monkeypatch):
    closed = inbox / "dive305.csv"
    plain, looked = Path.open, Path.stat
    shut = True

    def opened(self, *args, **kwargs):
        if shut and self == closed:
            raise PermissionError(13, "Permission denied")
        return plain(self, *args, **kwargs)

    monkeypatch.setattr(Path, "open", opened)
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

    def closed_stat(self, **kwargs):
        if self == closed:
            raise PermissionError(13, "Permission denied")
        return looked(self, **kwargs)

    monkeypatch.setattr(Path, "stat", closed_stat)
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


def test_strange_names_in_the_state_are_left_alone(inbox, tmp_path):
    state = tmp_path / "state"
    (state / ".git").mkdir(parents=True)
    mine = (".notes", ".dive1.csv.json.original", ".dive1.csv.json.bak", ".x.json.abcdefgh.part2")
    for name in mine:
        (state / name).write_text("mine")
    left = state / ".dive1.csv.json.ab_d3fgh.part"
    left.write_text("{")
    other = state / ".replay.nc.ab_d3fgh.part"
    other.write_text("")
    follower = Follower(inbox, state)
    follower.look()
    remove_left(state, "*.json")
    assert not left.exists()
    assert other.exists()
    assert {".git", *mine} <= {path.name for path in state.iterdir()}
    assert sorted(Follower(inbox, state).files) == ["dive304.csv", "dive305.csv", "dive306.csv"]


def test_one_follows_at_a_time(inbox, tmp_path):
    with (
        following(inbox, tmp_path / "out") as follower,
        pytest.raises(DataError, match="another clpt follows here"),
        following(inbox, tmp_path / "out"),
    ):
        pass
    assert len(follower.look()) == 3


@pytest.mark.processes
def test_one_process_follows_at_a_time(inbox, tmp_path):
    out = tmp_path / "out"
    start = [*CLPT, "replay", "--follow", inbox, "--out", out]
    with started([*start, "--json"], stdout=subprocess.DEVNULL) as first:
        await_line(first, first.stderr, "dives used")
        left = out / ".replay.nc.abcdefgh.part"
        left.write_text("half")
        second = subprocess.run([*start, "--patience", "0"], capture_output=True, text=True)
        assert second.returncode == 2
        assert "another clpt follows here; end it, or give another --out" in second.stderr
        assert second.stderr.count("\n") == 1
        assert left.exists()
    third = subprocess.run(
        [*start, "--patience", "0", "--json"], capture_output=True, text=True, check=True
    )
    assert json.loads(third.stdout)["used"] == 3
    assert not left.exists()
