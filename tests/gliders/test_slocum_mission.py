"""Made missions of a Slocum: currents that are added, plans, dives over several files."""

import shutil
from itertools import permutations

import numpy as np
import pytest
from pyproj import Geod
from slocum_bytes import SENSORS, VARIATION, Mission, ddmm, segment

from clpt_control.errors import DataError
from clpt_control.gliders import read_dives, usable
from clpt_control.gliders.dives import files_before
from clpt_control.replay.follow import Follower

DIVES = 5  # in 1, 2, 3, 4 files and in 1
PLACES, OWN, FLAG = ("m_lat", "m_lon"), ("m_water_vx", "m_water_vy"), ("u_use_current_correction",)


def flown(folder, without=(), **how):
    """Return the true currents and dives of a mission of segments of 1 to 4 files."""
    options = {key: how.pop(key) for key in ("end", "added", "every") if key in how}
    mission = Mission(folder, tuple(n for n in SENSORS if n not in without), **options)
    for k in range(DIVES):
        mission.dive(k, 1 + k % 4, **how)
    dives, skipped = read_dives(folder)
    assert skipped == []
    return mission.truth, sorted(dives, key=lambda dive: dive.t_gpse)


def errors(truth, dives):
    """Return how far each dive's miss over its duration is from the truth, mm/s."""
    return [
        1e3 * np.hypot(d.miss_east / d.duration - sea[0], d.miss_north / d.duration - sea[1])
        for sea, d in zip(truth, dives, strict=True)
    ]


MISSIONS = {
    "all is logged": {},
    "no final X": {"end": b""},
    "places on magnetic axes": {"without": PLACES},
    "places each ten minutes": {"every": 15},
    "the flag is not logged": {"without": FLAG},
    "the own current comes in the next file": {"late": True},
    "no correction": {"added": 0.0},
    "no correction, no flag": {"added": 0.0, "without": FLAG},
    "no correction, the own current comes in the next file": {"added": 0.0, "late": True},
}


@pytest.mark.parametrize("name", MISSIONS)
def test_each_dive_of_a_mission_has_the_current_of_its_sea(tmp_path, name):
    truth, dives = flown(tmp_path / "sbd", **MISSIONS[name])
    assert [d.number for d in dives] == [70000, 70002, 70005, 70009, 70010]
    # what is added goes on along the heading from the last place on
    assert max(errors(truth, dives)) < (12 if "every" in MISSIONS[name] else 5)
    notes = [" ".join(dive.notes) for dive in dives]
    assert ["taken off" in note or "that current is" in note for note in notes] == [
        MISSIONS[name].get("added", 1.0) == 1.0
    ] * DIVES
    assert not any("cut short" in note for d in dives for note in d.notes)
    own = truth if "late" not in MISSIONS[name] else [(None, None)] * DIVES
    for dive, current in zip(dives, own, strict=True):
        assert (dive.dac_east, dive.dac_north) == pytest.approx(tuple(current))
    assert [dive.magvar for dive in dives] == pytest.approx([VARIATION] * DIVES)


def test_dead_reckoning_that_contradicts_the_own_current_is_not_used(tmp_path):
    truth, dives = flown(tmp_path / "sbd", wrong=np.array([0.1, -0.3]))
    assert max(errors(truth, dives)) < 5
    assert all(d.track is None and "not used, that current is" in d.notes[-1] for d in dives)
    assert len(usable(dives)[0]) == DIVES


@pytest.mark.parametrize("without", [OWN, FLAG])
def test_a_dive_that_may_hold_a_current_is_not_used(tmp_path, without):
    _, dives = flown(tmp_path / "sbd", without=without, late=True)
    used, skipped = usable(dives)
    assert (used, len(skipped)) == ([], DIVES)
    assert all("holds a current" in s.why for s in skipped)


def test_what_nothing_says_is_said(tmp_path):
    _, dives = flown(tmp_path / "sbd", without=(*OWN, *FLAG))
    assert all("no file says whether" in d.notes[0] for d in dives)


@pytest.fixture(scope="module")
def in_three_files(tmp_path_factory):
    """A folder of a dive in three files and their list, and what is read of it."""
    folder = tmp_path_factory.mktemp("source") / "sbd"
    Mission(folder).dive(0, 3)
    return folder, read_dives(folder)


def test_a_dive_over_several_files_is_one(in_three_files, tmp_path):
    source, ((dive,), _) = in_three_files
    Mission(tmp_path / "whole").dive(0)
    (whole,) = read_dives(tmp_path / "whole")[0]
    assert (dive.dr_east, dive.dr_north) == pytest.approx((whole.dr_east, whole.dr_north), abs=1e-6)
    paths = [source / f"unit-2024-100-7-{k}.sbd" for k in range(3)]
    assert files_before(paths[2]) == paths[:2]
    part = shutil.copytree(source, tmp_path / "part")
    (part / paths[1].name).unlink()
    (dive,) = read_dives(part)[0]
    assert np.isnan(dive.dr_east)  # a third of it is missing
    assert any("no samples for" in note for note in dive.notes)


@pytest.mark.parametrize("order", list(permutations(range(4)))[::5])
def test_followed_files_come_in_any_order(in_three_files, tmp_path, order):
    (source, wanted), inbox = in_three_files, tmp_path / "inbox"
    inbox.mkdir()
    follower = Follower(inbox, tmp_path / "state")
    things = [*sorted(source.glob("*.sbd")), source / "cac"]
    for k in order:
        (shutil.copytree if things[k].is_dir() else shutil.copy)(things[k], inbox / things[k].name)
        follower.look()
    assert follower.dives() == wanted
    for path in inbox.glob("*-[01].sbd"):
        path.unlink()
        follower.look()
    again = Follower(inbox, tmp_path / "state")
    again.look()
    assert follower.dives()[0] == again.dives()[0] == wanted[0]


def test_a_file_that_holds_its_own_list_needs_none_beside_it(tmp_path):
    mission, written = Mission(tmp_path / "sbd"), []
    mission.write = lambda cycles, first: written.append((cycles, {n: first[n] for n in SENSORS}))
    mission.dive(0)
    ((cycles, first),) = written
    shutil.rmtree(tmp_path / "sbd" / "cac")
    path = tmp_path / "sbd" / "unit-2024-100-7-0.sbd"
    raw = segment(cycles, SENSORS, "00070000", path.stem, 0, first)
    path.write_bytes(raw)
    Mission(tmp_path / "beside").dive(0)
    assert read_dives(path) == read_dives(tmp_path / "beside")
    path.write_bytes(raw[: raw.index(b"m_depth")])
    with pytest.raises(DataError, match=r"is no list of \d+ sensors"):
        read_dives(path)


WAYPOINT = (51.9, -127.7)


@pytest.mark.parametrize("said", ["a waypoint", "a heading", "nothing"])
def test_the_plan_of_the_next_dive(tmp_path, said):
    """To the waypoint, else along the heading from magnetic north."""
    plan = {"c_heading": 1.0} if said != "nothing" else {}
    if said == "a waypoint":
        plan |= dict(zip(("c_wpt_lat", "c_wpt_lon"), map(ddmm, WAYPOINT), strict=True))
    mission = Mission(tmp_path / "sbd", (*SENSORS, *plan))
    mission.says(**plan)
    mission.dive(0)
    dive = read_dives(tmp_path / "sbd")[0][-1]
    bearing = Geod(ellps="WGS84").inv(dive.lon_gpse, dive.lat_gpse, *WAYPOINT[::-1])[0]
    wanted = {"a waypoint": bearing % 360, "a heading": np.degrees(1.0) + VARIATION}.get(said)
    assert dive.next_course == (wanted and pytest.approx(wanted, abs=0.05))
