"""Which dives are used: each refusal has its reason, and none looks ahead."""

from dataclasses import replace
from math import inf, nan

import numpy as np
import pytest

from clpt_control.ocean.gliders.dives import make_dive, usable

BASE = make_dive(10, (1e6, -43.0, 8.0), (1.01e6, -43.0, 8.02), (1000.0, 50.0))


def later(number, **changes):
    shift = (number - 10) * 11000.0
    return replace(
        BASE, number=number, t_gps2=BASE.t_gps2 + shift, t_gpse=BASE.t_gpse + shift, **changes
    )


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"lat_gps2": nan}, "no fix before"),
        ({"t_gps2": nan}, "no fix before"),
        ({"lon_gpse": inf}, "no fix after"),
        ({"lat_gpse": 9.97e36}, "no fix after"),
        ({"t_gps2": BASE.t_gpse, "t_gpse": BASE.t_gps2}, "swapped"),
        ({"t_gpse": BASE.t_gps2}, "swapped"),
        ({"dr_east": nan}, "not finite"),
        ({"dr_north": -inf}, "not finite"),
        ({"t_gpse": BASE.t_gps2 + 4000}, "lasts 4000 s"),
        ({"gps_north": 1e6}, "m/s"),
        ({"dr_east": 1e6}, "m/s"),
    ],
)
def test_a_dive_is_refused_with_its_reason(changes, why):
    used, skipped = usable([later(9), replace(BASE, **changes), later(11)])
    assert [dive.number for dive in used] == [9, 11]
    assert [one.dive for one in skipped] == [10]
    assert why in skipped[0].why


def test_least_duration_is_an_option():
    short = replace(BASE, t_gpse=BASE.t_gps2 + 3000)
    assert usable([short])[0] == []
    assert usable([short], least_duration=2000)[0] == [short]


def test_duplicates_overlaps_order_and_gaps_are_said():
    used, skipped = usable([later(12), later(10), later(12), later(16)])
    assert [dive.number for dive in used] == [10, 12, 16]
    assert [(one.dive, one.why[:9]) for one in skipped] == [(12, "duplicate")]
    assert "sorted by time" in used[0].notes[0]
    assert "3 dive(s) missing after dive 12" in used[2].notes
    long = replace(later(11), t_gpse=later(14).t_gpse)
    used, skipped = usable([later(10), long, later(12), later(13)])
    assert [dive.number for dive in used] == [10, 12, 13]
    assert "overlaps dive 13" in skipped[0].why


def test_a_later_dive_never_changes_an_earlier_choice():
    rng = np.random.default_rng(1)
    starts = rng.uniform(0, 3e5, 40)
    pool = [
        replace(BASE, number=k, t_gps2=t, t_gpse=t + d)
        for k, (t, d) in enumerate(zip(starts, rng.uniform(5e3, 3e4, 40), strict=True))
    ]
    pool.sort(key=lambda dive: dive.t_gpse)
    whole = [dive.number for dive in usable(pool)[0]]
    for count in range(len(pool) + 1):
        part = [dive.number for dive in usable(pool[:count])[0]]
        assert part == whole[: len(part)]
