"""Which dives are used: each refusal has its reason, and none looks ahead."""

import random
from dataclasses import replace
from math import inf

import numpy as np
import pytest

from clpt_control.gliders.dives import make_dive
from clpt_control.gliders.usable_dives import usable

BASE = make_dive(10, (1e6, -43.0, 8.0), (1.01e6, -43.0, 8.02), (1000.0, 50.0))


def later(number, **changes):
    shift = (number - 10) * 11000.0
    return replace(
        BASE, number=number, t_gps2=BASE.t_gps2 + shift, t_gpse=BASE.t_gpse + shift, **changes
    )


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"lon_gpse": inf}, "no fix after"),
        ({"lat_gpse": 91.0}, "no fix after the dive (time 1.01e+06, latitude 91, longitude 8.02)"),
        ({"lon_gps2": 408.0}, "no fix before"),
        ({"t_gpse": BASE.t_gps2}, "swapped"),
        ({"dr_north": -inf}, "not finite"),
        ({"t_gpse": BASE.t_gps2 + 1000}, "lasts 1000 s; must last longer than 1000 s"),
        (
            {"lat_gps2": 5141.048, "lon_gps2": -12818.018},
            "degrees and minutes; give decimal degrees, 51.684133 -128.300300",
        ),
        ({"lat_gpse": -4304.5, "lon_gpse": 829.4}, "decimal degrees, -43.075000 8.490000"),
        ({"t_gps2": -1.0}, "before the dive is at -1 s since 1970; must be from 1970 to 2200"),
        ({"t_gps2": -1e300, "t_gpse": 1e300}, "from 1970 to 2200"),
        ({"t_gpse": 1e18}, "after the dive is at 1e+18 s since 1970; must"),
        ({"t_gps2": 18518.5, "t_gpse": 18518.65}, "lasts 0.15 s; must last longer"),  # days
        ({"dr_east": -9999.0, "dr_north": -9999.0}, "is -9999 m twice, a fill value"),
        ({"number": 2**31}, "its number is 2.14748e+09; must be a whole number below 2147483648"),
        ({"number": -(10**300)}, "its number is -1e+300"),
        ({"gps_north": 1e6}, "m/s"),
        ({"dr_east": 1e6}, "m/s"),
    ],
)
def test_a_dive_is_refused_with_its_reason(changes, why):
    used, skipped = usable([later(9), replace(BASE, **changes), later(11)])
    assert [dive.number for dive in used] == [9, 11]
    assert [one.dive for one in skipped] == [changes.get("number", 10)]
    assert why in skipped[0].why


def test_least_duration_is_an_option():
    used, (skipped,) = usable([BASE], least_duration=14000)
    assert used == []
    assert skipped.why == "lasts 1e+04 s; must last longer than 14000 s (--least-duration)"


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


def at(number, lat, hours=0.0):
    """A dive 1000 s after the one before it, or more; the meridian to 40 N is 4429.5 km."""
    shift = 3600.0 * hours
    dive = later(number, lat_gps2=lat, lat_gpse=lat)
    return replace(dive, t_gps2=dive.t_gps2 + shift, t_gpse=dive.t_gpse + shift)


def numbers(dives):
    used, skipped = usable(dives)
    return [dive.number for dive in used], [one.dive for one in skipped]


def test_vehicles_years_apart_are_noted():
    names = ("SG1", "sg1", None, "rosie", "rosie")
    dives = [later(10 + k, vehicle=name) for k, name in enumerate(names)]
    found = [[note for note in dive.notes if "on its own" in note] for dive in usable(dives)[0]]
    assert found == [[], [], [], ["is of rosie, those before of sg1: replay each on its own"], []]


def test_two_vehicles_in_one_input_are_not_mixed():
    ours, theirs = [at(k, 40.0) for k in (10, 12, 14)], [at(k, -40.0) for k in (11, 13, 15)]
    used, skipped = usable([*ours, *theirs])
    assert used == ours
    assert [one.dive for one in skipped] == [11, 13, 15]
    why = "starts 8859 km from where dive 10 ended 0.3 h before; another vehicle? "
    assert skipped[0].why == f"{why}replay each on its own"


@pytest.mark.parametrize(
    ("second", "used"),
    [
        (at(11, 40.04), [10, 11]),  # 4.4 km in 1000 s
        (at(11, 40.5), [10]),  # 56 km
        (at(11, 41.0, hours=6.0), [10, 11]),  # 111 km at 4.9 m/s
        (at(11, 41.0, hours=5.0), [10]),
        (at(11, -40.0, hours=720.0), [10, 11]),  # shipped
        (replace(at(11, 40.0), lon_gps2=-179.99, lon_gpse=-179.98), [10, 11]),
    ],
)
def test_what_can_be_reached_is_not_refused(second, used):
    first = at(10, 40.0)
    if second.lon_gps2 < 0:
        first = replace(first, lon_gps2=179.99, lon_gpse=180.01)
    assert numbers([first, second])[0] == used


def test_one_wrong_fix_costs_one_dive_at_most():
    astray = replace(at(11, 40.0), lat_gpse=40.45)  # 50 km in 10000 s: possible
    far = [replace(dive, t_gps2=dive.t_gps2 - 900.0) for dive in (at(12, 39.95), at(13, 39.95))]
    assert numbers([at(10, 40.0), astray, *far]) == ([10, 11, 12, 13], [])
    start = replace(at(11, 40.0), lat_gps2=40.47, lat_gpse=40.02)  # a wrong start
    assert numbers([at(10, 40.0), start, at(12, 40.0)]) == ([10, 12], [11])
    again = [at(10, 40.0), at(11, -40.0), at(11, -40.0)]
    assert numbers(again) == ([10], [11, 11])


def overlapping():
    rng = np.random.default_rng(1)
    times = zip(rng.uniform(0, 3e5, 40), rng.uniform(5e3, 3e4, 40), strict=True)
    pool = [replace(BASE, number=k, t_gps2=t, t_gpse=t + d) for k, (t, d) in enumerate(times)]
    return sorted(pool, key=lambda dive: dive.t_gpse)


def apart():
    rng = random.Random(2)
    return [at(10 + k, rng.choice([40.0, 40.0, 41.0, -40.0])) for k in range(60)]


@pytest.mark.parametrize("pool", [overlapping(), apart()], ids=["in time", "in place"])
def test_no_choice_looks_ahead(pool):
    whole = numbers(pool)[0]
    assert 0 < len(whole) < len(pool)
    for count in range(len(pool) + 1):
        part = numbers(pool[:count])[0]
        assert part == whole[: len(part)]


def test_the_order_of_files_does_not_choose_between_copies():
    dives = [later(k) for k in range(10, 16)]
    slower = [replace(dive, dr_east=dive.dr_east - 300, dr_north=450.0) for dive in dives]
    moved = [replace(dive, lat_gpse=-43.01) for dive in dives]
    renamed = [replace(dive, number=99) for dive in dives]
    pool = [*dives, *slower, *moved, *renamed, *dives]
    whys = set()
    for seed in range(20):
        random.Random(seed).shuffle(pool)
        used, skipped = usable(pool)
        assert used == slower  # the least of number, then displacement
        assert len(skipped) == 24
        whys |= {one.why for one in skipped if "of dive 12" in one.why}
    assert whys == {"duplicate of dive 12, which is used"}
