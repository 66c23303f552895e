"""Dead reckoning that is swapped, reversed or in km is refused by name."""

from dataclasses import replace

import numpy as np
import pytest
from synthetic_vehicle import chained, vehicle

from clpt_control import DataError
from clpt_control.gliders import read_dives, sample_dives, write_dive_table
from clpt_control.replay import Replay, replay_dives

WRONG = {
    "swapped": lambda east, north: (north, east),
    "reversed in sign": lambda east, north: (-east, -north),
    "like km": lambda east, north: (east / 1000, north / 1000),
}


def wrong(dives, cause):
    """Dives with a mistake in their dead reckoning; the fixes remain."""
    ways = [WRONG[cause](dive.dr_east, dive.dr_north) for dive in dives]
    return [
        replace(dive, dr_east=east, dr_north=north)
        for dive, (east, north) in zip(dives, ways, strict=True)
    ]


def tidal(count=40, tide=0.3, period=44714.0):
    """A vehicle at 0.25 m/s in a steady current and a tide of 0.3 m/s."""
    rng, ways, time = np.random.default_rng(4), [], 0.0
    for _ in range(count):
        T = 10800 * rng.uniform(0.8, 1.2)
        angle, phase = rng.uniform(0, 2 * np.pi), 2 * np.pi * (time + T / 2) / period
        dr = 0.25 * T * np.array([np.sin(angle), np.cos(angle)])
        current = (0.1 + tide * np.cos(phase), 0.05 + 0.5 * tide * np.sin(phase))
        ways.append((dr, dr + T * np.array(current), T))
        time += T + 600.0
    return chained(ways, first=1)


@pytest.mark.parametrize("cause", WRONG)
@pytest.mark.parametrize("dives", [sample_dives(), tidal(), vehicle(1, walk=0.03)])
def test_wrong_columns_are_refused_by_name(dives, cause):
    with pytest.raises(
        DataError, match=f"dr_east_m and dr_north_m look {cause}. Correct"
    ):
        replay_dives(wrong(dives, cause))
    replay_dives(dives)


@pytest.mark.parametrize("cause", WRONG)
def test_a_table_of_a_seaexplorer_is_refused_by_name(facts, tmp_path, cause):
    dives = read_dives(facts / "glider" / "sea035m10_dives.csv")[0]
    write_dive_table(wrong(dives, cause), tmp_path / "mine.csv")
    with pytest.raises(DataError, match=f"look {cause}"):
        replay_dives(read_dives(tmp_path / "mine.csv")[0])


def test_dive_by_dive_is_refused_at_the_same_dive():
    replay = Replay()
    with pytest.raises(DataError) as one_by_one:
        [*map(replay.step, wrong(sample_dives(), "swapped"))]
    assert 4 <= len(replay.steps) < 13
    with pytest.raises(DataError) as at_once:
        replay_dives(wrong(sample_dives(), "swapped"))
    assert str(at_once.value) == str(one_by_one.value)


@pytest.mark.parametrize("factor", [0.6, 1.6])
@pytest.mark.parametrize("heading", ["any", "one"])
def test_a_wrong_speed_is_no_wrong_column(factor, heading):
    dives = vehicle(2, 30, factor=factor, heading=heading, walk=0.05)
    assert len(replay_dives(dives).steps) == 30
