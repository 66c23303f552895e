"""Following a folder: new, renamed, unreadable files, kills, one at a time; a damaged state."""

import copy
import json
import math
import os
import random
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from glider_files import used_numbers
from refusals import refuses
from synthetic_vehicle import one_file_each, vehicle

from clpt_control.base.files import make_folder
from clpt_control.gliders import read_dives, sample_dives
from clpt_control.ocean.forecast.follow import Follower, StoredFile, following
from clpt_control.ocean.gliders.dives import Skipped
from clpt_control.replay import Replay

SLOW = [pytest.param(seed, marks=pytest.mark.slow) for seed in range(4, 20)]


@pytest.mark.parametrize("seed", [0, 1, 2, 3, *SLOW])
def test_any_history_of_a_folder(tmp_path, seed):
    """Files are written, cut short, copied, renamed and removed; followers end and begin.

    A dive is known where a file holds it, or did when it was last seen.
    """
    rng, inbox = random.Random(seed), tmp_path / "in"
    one_file_each(tmp_path, sample_dives()[:5])
    inbox.mkdir()
    whole = {
        int(path.stem[4:]): path.read_text() for path in tmp_path.glob("dive*.csv")
    }
    follower, seen = Follower(inbox, tmp_path / "state"), {}
    for _ in range(25):
        there = sorted(inbox.iterdir())
        name = rng.choice(list(whole))
        match rng.choice(
            ["write", "write", "cut", "copy", "rename", "remove", "restart"]
        ):
            case "write":
                (inbox / f"{name}.csv").write_text(whole[name])
            case "cut":
                (inbox / f"{name}.csv").write_text(
                    whole[name][: rng.choice([0, 5, 60])]
                )
            case "copy" if there:
                (inbox / f"{rng.randrange(3)}.csv").write_text(
                    rng.choice(there).read_text()
                )
            case "rename" if there:
                rng.choice(there).rename(inbox / f"{rng.randrange(3)}.csv")
            case "remove" if there:
                rng.choice(there).unlink()
            case "restart":
                follower = Follower(inbox, tmp_path / "state")
        if rng.random() < 0.7:
            follower.look()
            texts = {path.name: path.read_text() for path in inbox.iterdir()}
            seen |= {
                k: [n for n in whole if whole[n] == text] for k, text in texts.items()
            }
            known = used_numbers(follower.dives()[0])
            assert known == sorted({n for numbers in seen.values() for n in numbers})
            again = Follower(inbox, tmp_path / "state")
            assert (again.look(), repr(again.dives())) == ([], repr(follower.dives()))


@pytest.fixture
def inbox(tmp_path):
    """A folder with the first three sample dives."""
    (tmp_path / "in").mkdir()
    one_file_each(tmp_path / "in", sample_dives()[:3])
    return tmp_path / "in"


def numbers(follower):
    dives, skipped = follower.dives()
    return used_numbers(dives), [entry.why for entry in skipped]


@pytest.fixture
def follower(inbox, tmp_path):
    """Who follows it, and has looked."""
    follower = Follower(inbox, tmp_path / "state")
    follower.look()
    return follower


def refused(says, folder, out):
    refuses(says, following(folder, out).__enter__)


def test_results_never_lie_in_the_followed_folder(inbox, tmp_path):
    (tmp_path / "link").symlink_to(inbox)
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "state").symlink_to(inbox)
    for out in (inbox, tmp_path / "link", tmp_path / "out"):
        refused("would be in the watched folder", inbox, out)
    with following(inbox, inbox / "." / ".."):  # the folder above is another
        pass
    with following(inbox, inbox / "replay") as follower:
        assert len(follower.look()) == 3
    (tmp_path / "loop").symlink_to("loop")
    for missing in ("none", "in/dive304.csv", "loop"):
        refused("the folder", tmp_path / missing, tmp_path / "other")
        assert not (tmp_path / "other").exists()


def test_a_state_belongs_to_its_folder(follower, inbox, tmp_path, monkeypatch):
    state, other = tmp_path / "state", tmp_path / "other vehicle"
    other.mkdir()
    one_file_each(other, vehicle(3, 2))
    kept = {path.name: path.read_bytes() for path in state.iterdir()}
    refuses(
        "has the files read from .*/in, not from .*/other vehicle",
        Follower,
        other,
        state,
    )
    assert kept == {path.name: path.read_bytes() for path in state.iterdir()}
    monkeypatch.chdir(tmp_path)
    (tmp_path / "link").symlink_to(inbox)
    assert Follower("link", "state").look() == []  # another name of the same folder


def test_a_file_rewritten_with_its_old_size_and_date_is_read_again(follower, inbox):
    path = inbox / "dive305.csv"
    dated = path.stat()
    path.write_text(path.read_text().replace("305,", "999,", 1))
    os.utime(path, ns=(dated.st_atime_ns, dated.st_mtime_ns))
    assert (path.stat().st_size, follower.look()) == (dated.st_size, ["dive305.csv"])
    assert numbers(follower)[0] == [304, 999, 306]


def test_a_file_that_becomes_a_pipe_once_it_was_asked_is_not_waited_for(
    inbox, tmp_path, monkeypatch
):
    follower, other = Follower(inbox, tmp_path / "state"), inbox / "dive305.csv"
    plain = os.open

    def opened(name, *how, **where):
        if Path(name) == other:
            other.unlink()
            os.mkfifo(other)
        return plain(name, *how, **where)

    monkeypatch.setattr(os, "open", opened)
    assert follower.look() == ["dive304.csv", "dive305.csv", "dive306.csv"]
    found, why = numbers(follower)
    assert found == [304, 306]
    assert "dive305.csv: is not a regular file. Give a file" in why[0]


def test_what_cannot_be_opened_is_tried_again(inbox, tmp_path, monkeypatch):
    closed = inbox / "dive305.csv"
    plain, shut = os.open, True

    def opened(name, *how, **where):
        if shut and Path(name) == closed:
            raise PermissionError(13, "Permission denied")
        return plain(name, *how, **where)

    monkeypatch.setattr(os, "open", opened)
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
    assert (follower.look(), numbers(follower)[0]) == (["dive305.csv"], [304, 305, 306])
    shut = True
    closed.touch()
    assert follower.look() == ["dive305.csv"]
    assert numbers(follower)[0] == [304, 305, 306]  # its dives are known
    assert "dive305.csv: cannot be read" in numbers(follower)[1][0]


def test_a_folder_that_goes_away_is_a_sentence(follower, inbox, tmp_path):
    inbox.rename(tmp_path / "away")
    refuses("cannot be looked into; what was read is kept", follower.look)
    assert numbers(follower)[0] == [304, 305, 306]
    (tmp_path / "away").rename(inbox)
    assert Follower(inbox, tmp_path / "state").look() == []


def test_files_are_in_the_order_of_their_numbers(tmp_path):
    """Else what is noted of dives, and the whole replay with it, changes with later files."""
    (tmp_path / "in").mkdir()
    follower, growing = Follower(tmp_path / "in", tmp_path / "state"), Replay()
    dives = [replace(dive, number=k) for k, dive in enumerate(sample_dives()[:12], 1)]
    for dive in dives:
        one_file_each(tmp_path / "in", [dive])
        follower.look()
        used, _ = follower.dives()
        for found in (used, read_dives(tmp_path / "in")[0]):
            wanted = [(one.number, one.notes) for one in dives[: dive.number]]
            assert [(one.number, one.notes) for one in found] == wanted
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
        refused("another clpt follows here", inbox, tmp_path / "out")
        assert len(follower.look()) == 3


def stored(folder, dives, skipped):
    """Write a state with one file, which had these dives; return its path."""
    where = os.path.realpath(folder / "in")
    path = make_folder(folder / "state") / "dive1.csv.json"
    path.write_text(StoredFile(where, (3, 1, 2), dives, skipped).text())
    return path


@pytest.fixture
def whole(tmp_path):
    """The state of a file with a track, and its JSON."""
    time = np.linspace(0.0, 9000.0, 4)
    dive = replace(sample_dives()[0], track=(time, time / 3, -time), notes=("odd",))
    path = stored(tmp_path, [dive], [Skipped(None, "line 3"), Skipped(7, "short")])
    return path, json.loads(path.read_text())


def is_no_state(path, text):
    """Whether a state with this text is refused, and left as it is."""
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    said = "is not a state of this version's clpt watch.*move the folder .* away"
    refuses(said, Follower, path.parents[1] / "in", path.parent)
    assert path.read_bytes() == text.encode("utf-8", "surrogateescape")


def places_of(record, at=()):
    """All places in a JSON, the deeper ones first; of a track only its columns."""
    inner = record.items() if isinstance(record, dict) else enumerate(record)
    for key, value in [] if isinstance(record, str) else inner:
        if isinstance(value, dict | list) and "track" not in at:
            yield from places_of(value, (*at, key))
        yield (*at, key)


def put(record, place, value):
    """The JSON of a record with a value at a place; ... takes away what is there."""
    changed = inner = copy.deepcopy(record)
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    if value is ...:
        del inner[place[-1]]
    return json.dumps(changed)


def test_damage_is_seen_at_each_place(whole):
    """What stands there is another thing, or what must be there is missing."""
    path, record = whole
    places = list(places_of(record))
    assert len(places) > 40
    for place in places:
        is_no_state(path, put(record, place, {"no": [True]}))
    for place in (
        *((key,) for key in record),
        ("dives", 0, "track"),
        ("dives", 0, "number"),
    ):
        is_no_state(path, put(record, place, ...))


OF_A_DIVE = {
    "number": (None, 1.5, "304", True, math.nan),
    "t_gps2": (None, "0", False),
    "notes": (None, "odd", [1]),
    "depth": (100.0,),
    "track": (
        *(3, [], [[1.0]] * 2, [[], [], []], [0.0] * 3, [[0.0], [[0.0]], [0.0]]),
        *([[0.0, 1.0], [0.0, 1.0], [0.0]], [[0.0, 1.0], [0.0, None], [0.0, 1.0]]),
    ),
}
ODD = {
    ("format",): (1, None, "2"),
    ("stamp",): ([1, 2], [1.5, 2, 3], [None, 1, 2]),
    ("dives",): (None, [None], [[]], [{}]),
    ("skipped", 0): ({"dive": "1", "why": "x"},),
    ("other",): (3,),
    **{("dives", 0, name): values for name, values in OF_A_DIVE.items()},
}


def test_odd_values_are_seen(whole):
    path, record = whole
    for place, values in ODD.items():
        for value in values:
            is_no_state(path, put(record, place, value))


def test_what_is_no_json_is_seen(whole):
    path, _ = whole
    for text in (
        "[" * 100_000,
        '{"a":' * 100_000,
        "\0",
        "",
        "9" * 5000,
        "\udcff",
        "[1]",
        "null",
    ):
        is_no_state(path, text)
    for make in (os.mkfifo, os.mkdir):  # a pipe is not waited for
        path.unlink()
        make(path)
        refuses(
            "dive1.csv.json: is not a state",
            Follower,
            path.parents[1] / "in",
            path.parent,
        )


def test_what_readers_give_is_whole(tmp_path):
    """Tracks to the bit; missing fixes, infinite numbers, no places."""
    first, rng = sample_dives()[0], np.random.default_rng(2)
    time = np.linspace(0, 9000, 40)
    strange = [
        replace(
            first,
            track=(time, *np.cumsum(rng.normal(size=(2, 40)), axis=1)),
            notes=("odd",),
        ),
        replace(first, lat_gpse=math.nan, gps_east=math.nan, gps_north=math.nan),
        replace(first, dr_east=math.inf, depth_max=math.nan, number=-5),
        replace(first, lat_gpse=95.0, gps_east=math.nan, t_gps2=np.float64(0.1)),
    ]
    (tmp_path / "in").mkdir()
    path = stored(tmp_path, strange, [])
    kept = path.read_text()
    again, skipped = Follower(tmp_path / "in", tmp_path / "state").dives()
    assert skipped == []
    strange[3] = replace(strange[3], t_gps2=0.1)
    assert list(map(repr, again)) == list(map(repr, strange))
    assert all(map(np.array_equal, again[0].track, strange[0].track))
    again = stored(tmp_path, again, []).read_text()
    assert json.dumps(json.loads(again)["dives"]) == json.dumps(
        json.loads(kept)["dives"]
    )
