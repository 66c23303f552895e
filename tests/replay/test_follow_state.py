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


def refused(path, text):
    """Whether a state with this text is refused, and left as it is."""
    path.write_bytes(text.encode("utf-8", "surrogateescape"))
    said = "is no state of this version's clpt replay --follow.*move the folder .* away"
    with pytest.raises(DataError, match=said):
        Follower(path.parents[1] / "in", path.parent)
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
        refused(path, put(record, place, {"no": [True]}))
    for place in (*((key,) for key in record), ("dives", 0, "track"), ("dives", 0, "number")):
        refused(path, put(record, place, ...))


ODD = [
    *((("format",), value) for value in (1, None, "2")),
    *((("stamp",), value) for value in ([1, 2], [1.5, 2, 3], [None, 1, 2])),
    *((("dives",), value) for value in (None, [None], [[]], [{}])),
    (("skipped", 0), {"dive": "1", "why": "x"}),
    (("other",), 3),
    (("dives", 0, "depth"), 100.0),
    *((("dives", 0, "number"), value) for value in (None, 1.5, "304", True, math.nan)),
    *((("dives", 0, "t_gps2"), value) for value in (None, "0", False)),
    *((("dives", 0, "notes"), value) for value in (None, "odd", [1])),
    *((("dives", 0, "track"), value) for value in (3, [], [[1.0]] * 2, [[], [], []], [0.0] * 3)),
    (("dives", 0, "track"), [[0.0, 1.0], [0.0, 1.0], [0.0]]),
    (("dives", 0, "track"), [[0.0, 1.0], [0.0, None], [0.0, 1.0]]),
    (("dives", 0, "track"), [[0.0], [[0.0]], [0.0]]),
]


def test_odd_values_are_seen(whole):
    path, record = whole
    for place, value in ODD:
        refused(path, put(record, place, value))


def test_what_is_no_json_is_seen(whole):
    path, _ = whole
    for text in ("[" * 100_000, '{"a":' * 100_000, "\0", "", "9" * 5000, "\udcff", "[1]", "null"):
        refused(path, text)
    for make in (os.mkfifo, os.mkdir):  # a pipe is not waited for
        path.unlink()
        make(path)
        with pytest.raises(DataError, match=r"dive1.csv.json: is no state"):
            Follower(path.parents[1] / "in", path.parent)


def test_what_readers_give_is_whole(tmp_path):
    """Tracks to the bit; missing fixes, infinite numbers, no places."""
    first, rng = sample_dives()[0], np.random.default_rng(2)
    time = np.linspace(0, 9000, 40)
    strange = [
        replace(first, track=(time, *np.cumsum(rng.normal(size=(2, 40)), axis=1)), notes=("odd",)),
        replace(first, lat_gpse=math.nan, gps_east=math.nan, gps_north=math.nan),
        replace(first, dr_east=math.inf, depth_max=math.nan, number=-5),
        replace(first, lat_gpse=95.0, gps_east=math.nan, t_gps2=np.float64(0.1)),
    ]
    path = followed(tmp_path, strange, [])
    kept = json.loads(path.read_text())["dives"]
    (tmp_path / "in" / "dive1.csv").unlink()
    again, skipped = Follower(tmp_path / "in", tmp_path / "state").dives()
    assert skipped == []
    strange[3] = replace(strange[3], t_gps2=0.1)
    assert list(map(repr, again)) == list(map(repr, strange))
    assert all(map(np.array_equal, again[0].track, strange[0].track))
    again = json.loads(followed(tmp_path, again, []).read_text())["dives"]
    assert json.dumps(again) == json.dumps(kept)
