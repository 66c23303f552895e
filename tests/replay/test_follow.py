"""Following a folder: new files, kills, strange states."""

import math
import random
import sys
import time
from dataclasses import replace

import numpy as np
import pytest
from processes import started
from synthetic_vehicle import one_file_each

from clpt_control.gliders.dive_table import sample_dives
from clpt_control.gliders.usable_dives import usable
from clpt_control.replay import follow
from clpt_control.replay.dataset import replay_dataset
from clpt_control.replay.follow import Follower
from clpt_control.replay.replay import replay_dives


def test_following_a_folder_equals_reading_it(tmp_path):
    dives = sample_dives()
    for k, dive in enumerate(dives):
        one_file_each(tmp_path, [dive])
        (tmp_path / "half.nc").write_bytes(b"CDF\x01" + bytes(k))
        follower = Follower(tmp_path, tmp_path / "state")  # begins anew, each time
        assert set(follower.look()) == {f"dive{dive.number}.csv", "half.nc"}
        assert follower.look() == []
        used = usable(follower.dives()[0])[0]
        assert [d.number for d in used] == [d.number for d in dives[: k + 1]]
    (tmp_path / "dive304.csv").unlink()
    again = Follower(tmp_path, tmp_path / "state")
    assert again.look() == []
    known, skipped = again.dives()
    assert len(skipped) == 1
    assert "half.nc" in skipped[0].why
    assert replay_dataset(replay_dives(usable(known)[0])).identical(
        replay_dataset(replay_dives(usable(dives)[0]))
    )


@pytest.mark.processes
def test_a_killed_follower_loses_nothing(tmp_path):
    """Kill -9 at random moments; what a last run gives is what reading gives."""
    inbox, state = tmp_path / "inbox", tmp_path / "state"
    inbox.mkdir()
    code = (
        "import sys, time\nfrom clpt_control.replay.follow import Follower\n"
        "f = Follower(sys.argv[1], sys.argv[2])\nprint('up', flush=True)\n"
        "while True:\n    f.look()\n"
    )
    rng = np.random.default_rng(0)
    dives = sample_dives()
    for part in (dives[:3], dives[3:6], dives[6:10], dives[10:]):
        with started([sys.executable, "-c", code, inbox, state]) as process:
            process.stdout.readline()
            one_file_each(inbox, part)
            time.sleep(0.03 * rng.uniform())  # any moment will do
    follower = Follower(inbox, state)
    follower.look()
    assert [d.number for d in usable(follower.dives()[0])[0]] == [d.number for d in dives]
    assert follower.dives()[1] == []


def test_tracks_come_back_to_the_bit(tmp_path, monkeypatch):
    rng = np.random.default_rng(2)
    time_ = np.linspace(0, 9000, 40)
    kept = [
        replace(dive, track=(time_, *np.cumsum(rng.normal(size=(2, 40)), axis=1)))
        for dive in sample_dives()[:3]
    ]
    kept[1] = replace(kept[1], track=None, notes=("no track",), depth_max=math.nan)
    one_file_each(tmp_path, sample_dives()[:3])
    read = {f"dive{dive.number}.csv": ([dive], []) for dive in kept}
    monkeypatch.setattr(follow, "read_dive_file", lambda path: read[path.name])
    Follower(tmp_path, tmp_path / "state").look()
    again, _ = Follower(tmp_path, tmp_path / "state").dives()
    assert again[1].track is None
    assert again[1].notes == ("no track",)
    for before, after in ((kept[0], again[0]), (kept[2], again[2])):
        assert before == after
        assert all(map(np.array_equal, before.track, after.track))


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
