"""A damaged state is refused in one sentence, whatever was done to it."""

import copy
import json
import math
from dataclasses import replace

import numpy as np
import pytest
from synthetic_vehicle import one_file_each

from clpt_control.errors import DataError
from clpt_control.gliders.dive_table import sample_dives
from clpt_control.gliders.dives import Skipped
from clpt_control.replay.follow import Follower
from clpt_control.replay.follow_record import dive_of, read_record, record_of


@pytest.fixture
def whole():
    """A record with a track, as JSON has it."""
    time = np.linspace(0.0, 9000.0, 4)
    dive = replace(sample_dives()[0], track=(time, time / 3, -time), notes=("odd",))
    return record_of("/in", [1, 2], [dive], [Skipped(None, "line 3"), Skipped(7, "short")])


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
    *((("stamp",), value) for value in ([1], 5, "ab", [1.5, 2], [None, 1], {"a": 1, "b": 2})),
    *((("dives",), value) for value in (None, 3, "", {}, [None], [3], ["x"], [[]], [{}])),
    *((("skipped",), value) for value in (None, {}, [None], [[]], [{"dive": 1}], ["ab"])),
    *((("skipped", 0), {"dive": d, "why": w}) for d, w in ((1.5, "x"), ("1", "x"), (1, None))),
    *((("dives", 0, "number"), value) for value in (None, 1.5, "304", True, 10**30, math.nan)),
    *((("dives", 0, "t_gps2"), value) for value in (None, "0", [], {}, False, 10**400)),
    *((("dives", 0, "dr_east"), value) for value in (None, "1", [1.0])),
    *((("dives", 0, "gps_east"), value) for value in (None, "x", 10**400)),
    *((("dives", 0, "dac_east"), value) for value in ("0.1", [], True, 10**400)),
    *((("dives", 0, "notes"), value) for value in (None, "odd", [1], [None], {})),
    *((("dives", 0, "track"), value) for value in (3, [], [[1.0]] * 2, "abc", [[], [], []])),
    (("dives", 0, "track"), [[0.0, 1.0], [0.0, 1.0], [0.0]]),
    (("dives", 0, "track"), [[0.0, 1.0], [0.0, None], [0.0, 1.0]]),
    (("dives", 0, "track"), [[0.0], [[0.0]], [0.0]]),
    (("dives", 0, "track"), [0.0, 1.0, 2.0]),
    (("dives", 0, "track"), [[0.0], [10**400], [0.0]]),
    (("dives", 0, "depth"), 100.0),
]


@pytest.mark.parametrize(("place", "value"), DAMAGE)
def test_damage_is_seen(tmp_path, whole, place, value):
    path = tmp_path / "dive1.csv.json"
    path.write_text(json.dumps(put(whole, place, value) if place else value))
    with pytest.raises(DataError, match="is no state of this version's clpt replay --follow"):
        read_record(path, "/in")


@pytest.mark.parametrize(
    "text", ["[" * 100_000, '{"a":' * 100_000, "\0", "", "9" * 5000, "\udcff", '{"format": 2}']
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


def test_what_readers_give_is_whole(tmp_path, whole):
    """Missing fixes, infinite numbers, no places: dives that `usable` refuses."""
    first = sample_dives()[0]
    strange = [
        replace(first, lat_gpse=math.nan, gps_east=math.nan, gps_north=math.nan),
        replace(first, dr_east=math.inf, depth_max=math.nan, number=-5),
        replace(first, lat_gpse=95.0, gps_east=math.nan),
    ]
    path = tmp_path / "a.json"
    for record in (whole, record_of("/in", None, strange, [])):
        path.write_text(json.dumps(record))
        again = read_record(path, "/in")
        assert json.dumps(again) == json.dumps(record)
    assert math.isnan(dive_of(again["dives"][0]).lat_gpse)
    assert dive_of(again["dives"][1]).dr_east == math.inf


def test_a_state_with_a_null_says_so_and_stays(tmp_path):
    one_file_each(tmp_path, sample_dives()[:1])
    state = tmp_path / "state"
    Follower(tmp_path, state).look()
    path = state / "dive304.csv.json"
    path.write_text(json.dumps(put(json.loads(path.read_text()), ("dives", 0, "t_gpse"), None)))
    text = path.read_text()
    with pytest.raises(DataError, match=r"move the folder .* away"):
        Follower(tmp_path, state)
    assert path.read_text() == text
