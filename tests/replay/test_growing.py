"""A record that grows: what was learned is not learned again, and nothing else changes."""

import json
from dataclasses import replace

import numpy as np
import pytest
from synthetic_vehicle import vehicle

from clpt_control.gliders import sample_dives, usable
from clpt_control.replay import replay_dives, summary
from clpt_control.replay.replay import Replay

DIVES = usable(sample_dives())[0]


def said(replay):
    """All that is said of a replay, as text."""
    ahead = {**replay.surfacing().as_dict(), "now": None}
    return json.dumps([summary(replay), ahead])


def tracked(dive):
    """A dive with a straight track, made anew."""
    line = np.linspace(0.0, 1.0, 5)
    track = line * dive.duration, line * dive.dr_east, line * dive.dr_north
    return replace(dive, track=track, dac_east=float("nan"))


@pytest.fixture
def steps(monkeypatch):
    """The numbers of the dives that are learned."""
    numbers, step = [], Replay.step

    def counted(self, dive):
        numbers.append(dive.number)
        return step(self, dive)

    monkeypatch.setattr(Replay, "step", counted)
    return numbers


def test_dive_by_dive_is_all_at_once(steps):
    growing = Replay()
    for count in (1, 2, 5, 5, 9, 14):
        assert said(growing.feed(DIVES[:count])) == said(replay_dives(DIVES[:count]))
    for more, once in (({"dac_east": 0.1}, True), ({}, False)):  # NaN is never taken as the same
        steps.clear()
        growing = Replay()
        for count in range(1, 15):
            growing.feed([replace(tracked(dive), **more) for dive in DIVES[:count]])
        assert (steps == [dive.number for dive in DIVES]) == once


def test_what_changed_is_learned_anew(steps):
    eight = vehicle(2, 8)
    for changed in (
        [*eight[:3], replace(eight[3], notes=("read again",)), *eight[4:]],
        [*eight[:3], tracked(eight[3]), *eight[4:]],
        [*eight[:3], replace(eight[3], lat_gpse=eight[3].lat_gpse + 1e-9), *eight[4:]],
        [*eight[:3], *eight[4:]],
        eight[:4],
    ):
        growing = Replay().feed(eight)
        steps.clear()
        growing.feed(changed)
        assert len(steps) == len(changed)
        assert said(growing) == said(replay_dives(changed))


def test_an_interrupt_leaves_what_was_learned(steps):
    growing = Replay()

    def cut(done):
        if done == 6:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        growing.feed(DIVES, cut)
    assert said(growing.feed(DIVES)) == said(replay_dives(DIVES))
    assert steps[:14] == [dive.number for dive in DIVES]
