"""A damaged state is refused in one sentence, whatever was done to it."""

import copy
import json
import math
import os
from dataclasses import replace

import numpy as np
import pytest

from clpt_control.errors import DataError
from clpt_control.gliders.dive_files import sample_dives
from clpt_control.gliders.dives import Skipped
from clpt_control.replay import follow
from clpt_control.replay.follow import Follower


def followed(folder, dives, skipped):
    """Follow a file that reads as these dives, and return its file in the state."""
    (folder / "in").mkdir(exist_ok=True)
    (folder / "in" / "dive1.csv").write_text("any")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(follow, "read_dive_file", lambda path: (dives, skipped))
        Follower(folder / "in", folder / "state").look()
    return folder / "state" / "dive1.csv.json"


@pytest.fixture
def whole(tmp_path):
    """The state of a file with a track, and its JSON."""
    time = np.linspace(0.0, 9000.0, 4)
    dive = replace(sample_dives()[0], track=(time, time / 3, -time), notes=("odd",))
    path = followed(tmp_path, [dive], [Skipped(None, "line 3"), Skipped(7, "short")])
    return path, json.loads(path.read_text())


def put(record, place, value):
    changed = copy.deepcopy(record)
    inner = changed
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    return changed


DAMAGE = [
    *(((), value) for value in (None, [], "text", 3, True)),
    *((("format",), value) for value in (1, None, "2", [])),
    *((("folder",), value) for value in (None, 3, ["/in"])),
    *((("stamp",), value) for value in ([1, 2], 5, "abc", [1.5, 2, 3], [None, 1, 2])),
    (("other",), 3),
    *((("dives",), value) for value in (None, 3, [None], [3], ["x"], [[]], [{}])),
    *((("skipped",), value) for value in (None, [None], [[]], [{"dive": 1}], ["ab"])),
    *((("skipped", 0), {"dive": d, "why": w}) for d, w in ((1.5, "x"), ("1", "x"), (1, None))),
    *((("dives", 0, "number"), value) for value in (None, 1.5, "304", True, math.nan)),
    *((("dives", 0, "t_gps2"), value) for value in (None, "0", [], {}, False)),
    *((("dives", 0, "dr_east"), value) for value in (None, "1", [1.0])),
    *((("dives", 0, "gps_east"), value) for value in (None, "x")),
    *((("dives", 0, "dac_east"), value) for value in ("0.1", [], True)),
    *((("dives", 0, "notes"), value) for value in (None, "odd", [1], [None], {})),
    *((("dives", 0, "track"), value) for value in (3, [], [[1.0]] * 2, "abc", [[], [], []])),
    (("dives", 0, "track"), [[0.0, 1.0], [0.0, 1.0], [0.0]]),
    (("dives", 0, "track"), [[0.0, 1.0], [0.0, None], [0.0, 1.0]]),
    (("dives", 0, "track"), [[0.0], [[0.0]], [0.0]]),
    (("dives", 0, "track"), [0.0, 1.0, 2.0]),
    (("dives", 0, "depth"), 100.0),
]


@pytest.mark.parametrize(("place", "value"), DAMAGE)
def test_damage_is_seen(tmp_path, whole, place, value):
    path, record = whole
    text = json.dumps(put(record, place, value) if place else value)
    path.write_text(text)
    said = "is no state of this version's clpt replay --follow.*move the folder .* away"
    with pytest.raises(DataError, match=said):
        Follower(tmp_path / "in", tmp_path / "state")
    assert path.read_text() == text


def test_a_pipe_in_the_state_is_not_waited_for(tmp_path, whole):
    os.mkfifo(tmp_path / "state" / "dive2.csv.json")
    with pytest.raises(DataError, match=r"dive2.csv.json: is no state"):
        Follower(tmp_path / "in", tmp_path / "state")


@pytest.mark.parametrize("key", ["format", "folder", "stamp", "dives", "skipped"])
def test_what_is_missing_is_seen(tmp_path, whole, key):
    path, record = whole
    without_track = put(record, ("dives", 0, "track"), None)
    for inner in (record, without_track["dives"][0]):
        del inner["track" if "track" in inner else key]
    for damaged in (record, without_track):
        path.write_text(json.dumps(damaged))
        with pytest.raises(DataError, match="is no state"):
            Follower(tmp_path / "in", tmp_path / "state")


@pytest.mark.parametrize(
    "text", ["[" * 100_000, '{"a":' * 100_000, "\0", "", "9" * 5000, "\udcff", '{"form', "[1]"]
)
def test_what_is_no_json_is_seen(tmp_path, text):
    (tmp_path / "in").mkdir()
    (tmp_path / "state").mkdir()
    path = tmp_path / "state" / "dive1.csv.json"
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    with pytest.raises(DataError, match="is no state"):
        Follower(tmp_path / "in", tmp_path / "state")
    path.unlink()
    path.mkdir()
    with pytest.raises(DataError, match="is no state"):
        Follower(tmp_path / "in", tmp_path / "state")


def test_what_readers_give_is_whole(tmp_path):
    """Missing fixes, infinite numbers, no places: dives that `usable` refuses."""
    first = sample_dives()[0]
    strange = [
        replace(first, lat_gpse=math.nan, gps_east=math.nan, gps_north=math.nan),
        replace(first, dr_east=math.inf, depth_max=math.nan, number=-5),
        replace(first, lat_gpse=95.0, gps_east=math.nan, t_gps2=np.float64(0.1)),
    ]
    path = followed(tmp_path, strange, [])
    kept = json.loads(path.read_text())["dives"]
    (tmp_path / "in" / "dive1.csv").unlink()
    again, skipped = Follower(tmp_path / "in", tmp_path / "state").dives()
    assert skipped == []
    strange[2] = replace(strange[2], t_gps2=0.1)
    assert list(map(repr, again)) == list(map(repr, strange))
    assert math.isnan(again[0].lat_gpse)
    assert again[1].dr_east == math.inf
    again = json.loads(followed(tmp_path, again, []).read_text())["dives"]
    assert json.dumps(again) == json.dumps(kept)
