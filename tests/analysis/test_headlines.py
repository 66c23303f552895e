"""The judge of a replay's headline: what held is what lay in the printed ellipse."""

from dataclasses import replace

import numpy as np
import pytest
from pictures import inked

from analysis.headlines import headline, main, record
from clpt_control.geodesy import place_from
from clpt_control.gliders import sample_dives, usable
from clpt_control.replay import next_dive, replay_dives

DIVES = usable(sample_dives())[0]


def test_a_fix_on_the_ellipse_is_one_half_axis_away():
    replay = replay_dives(DIVES[:6])
    said = next_dive(replay).as_dict()
    turn = np.radians(said["ellipse_90_bearing"])
    along = np.array([np.sin(turn), np.cos(turn)])
    across = np.array([np.cos(turn), -np.sin(turn)])
    for way in (said["ellipse_90_long"] * along, -said["ellipse_90_short"] * across):
        lat, lon = place_from(said["latitude"], said["longitude"], *way)
        found = headline(replay, replace(DIVES[6], lat_gpse=lat, lon_gpse=lon))
        assert found.away == pytest.approx(1.0, rel=1e-3)
        assert found.miss == pytest.approx(np.hypot(*way), rel=1e-6)
    assert found.size**2 == pytest.approx(said["ellipse_90_long"] * said["ellipse_90_short"])


def test_a_pair_with_dives_missing_between_is_left_out():
    whole = record(DIVES[:6])
    holed = record(usable([*DIVES[:3], *DIVES[4:6]])[0])
    assert len(whole) == 5
    assert len(holed) == 3
    assert holed[:2] == pytest.approx(whole[:2], nan_ok=True)


def test_the_table_has_a_row_for_each_vehicle(tmp_path, capsys):
    main(out=tmp_path)
    lines = (tmp_path / "headlines.md").read_text().splitlines()
    assert capsys.readouterr().out.splitlines() == lines
    assert [line.split(" | ")[:2] for line in lines[2:]] == [["| SG542", "13"]]
    assert inked(tmp_path / "headlines.png") > 0.005
