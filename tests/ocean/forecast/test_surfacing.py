"""The next surfacing as it is said: its spread, the plan in files, its own record."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest
from geodesics import WGS84, displacement, place_from
from glider_files import basestation3
from synthetic_vehicle import along, chained

from clpt_control.gliders import make_dive, read_dives, sample_dives, write_dive_table
from clpt_control.replay import replay_dives

DIVES = sample_dives()
STILL = {"flow": ("steady",)}  # the fastest


def flown(courses, planned=False):
    """Dives of 3 km on courses (degrees), with a drift at the surface, in still water."""
    ways = [
        (along(course, 3000.0), along(course, 3000.0), 14400.0) for course in courses
    ]
    dives = chained(ways, stay=900.0, drift=(150.0, 0.0))
    if planned:
        dives[:-1] = map(
            lambda dive, course: replace(dive, next_course=course), dives, courses[1:]
        )
    return dives


def half(replay):
    """The geometric mean of the half axes, m."""
    ahead = replay.next_dive().as_dict()
    return math.sqrt(ahead["ellipse_long"] * ahead["ellipse_short"])


def test_who_dives_alike_is_foretold_well_and_the_drift_is_in_it():
    *dives, last = flown([90.0] * 31)
    replay, early = replay_dives(dives), replay_dives(dives[:2])
    said, end = replay.surfacing(), (last.lat_gpse, last.lon_gpse)
    assert np.hypot(*displacement(said.latitude, said.longitude, *end)) < 60
    assert abs(said.plan.t_gpse - last.t_gpse) < 60
    start = displacement(dives[-1].lat_gpse, dives[-1].lon_gpse, *replay.start()[1:])
    assert start == pytest.approx((150.0, 0.0), abs=25)
    assert half(replay) < 0.5 * half(early)
    assert said.time_half_width < 0.5 * early.surfacing().time_half_width


def test_a_plan_tells_the_course():
    rng = np.random.default_rng(3)
    courses = [*rng.uniform(0, 360, 24), 77.0]
    with_plan = replay_dives(flown(courses, planned=True)[:24])
    without = replay_dives(flown(courses)[:24])
    said = with_plan.surfacing()
    assert (said.basis, without.surfacing().basis) == ("planned", "repeated")
    course = math.degrees(math.atan2(said.plan.dr_east, said.plan.dr_north))
    assert course == pytest.approx(77, abs=5)
    assert half(with_plan) < 0.4 * half(without)


LONG, SPEED = 18000.0, 0.25  # s, m/s


def one_course(lengths, speeds=SPEED):
    """Dives to the south-west, of lengths (s) and speeds (m/s), in a steady current."""
    ways = [
        (
            along(200.0, speed * T),
            along(200.0, speed * T) + T * np.array((0.1, -0.05)),
            T,
        )
        for T, speed in np.broadcast(lengths, speeds)
    ]
    return replay_dives(chained(ways, stay=600.0), **STILL).next_dive().as_dict()


def way_of(ahead):
    return math.hypot(ahead["dr_east"], ahead["dr_north"])


@pytest.mark.parametrize(
    ("lengths", "speeds"),
    [
        ([1200.0] * 4 + [LONG] * 4, SPEED),  # as each mission begins
        ([1200.0] * 4 + [LONG] * 12, SPEED),
        ([90000.0] * 3 + [LONG] * 5, SPEED),
        ([LONG] * 6 + [900.0], SPEED),  # broken off
        ([LONG] * 6 + [900.0] + [LONG] * 2, SPEED),
        ([LONG] * 8, [SPEED] * 6 + [0.005, SPEED]),  # a spiral, then as before
        ([LONG] * 9, [SPEED] * 6 + [0.0] + [SPEED] * 2),
        ([LONG] * 12, [SPEED] * 11 + [0.01]),  # the last one failed
        ([LONG] * 11 + [1200.0], [SPEED] * 11 + [0.0]),
    ],
)
def test_the_usual_speed_for_the_usual_time_after_odd_dives(lengths, speeds):
    ahead = one_course(lengths, speeds)
    assert ahead["duration"] == pytest.approx(LONG, rel=0.2)
    assert way_of(ahead) == pytest.approx(SPEED * LONG, rel=0.2)
    assert ahead["ellipse_long"] < 2 * SPEED * LONG


@pytest.mark.parametrize("speeds", [[0.1, 0.2, 0.3], [0.05] * 5 + [0.4], [0.0, 0.3]])
def test_no_forecast_is_faster_than_the_fastest_dive(speeds):
    ahead = one_course([LONG] * len(speeds), speeds)
    assert way_of(ahead) <= max(speeds) * ahead["duration"] * (1 + 1e-9)


@pytest.mark.long
@pytest.mark.parametrize("wild", [False, True])
def test_in_the_long_run_forecasts_hold_at_their_level(wild):
    """Whatever a vehicle does and whatever the level is, the width follows its record."""
    rng = np.random.default_rng(5)
    turns = rng.normal(0, 60, 300) if wild else rng.standard_t(2, 300) * 10
    ways = [along(course, 3000.0) for course in np.cumsum(turns)]
    dives = [(way, way, 14400.0 * rng.uniform(0.6, 1.4)) for way in ways]
    replay = replay_dives(chained(dives, stay=900.0), **STILL)
    held = np.mean([step.headline_held for step in replay.steps[1:]], axis=0)
    assert held == pytest.approx(replay.summary()["level"], abs=0.04)


def test_the_record_is_of_what_was_said_before_each_dive(sg542, tmp_path):
    assert (sg542.steps[0].headline, sg542.steps[0].headline_held) == (None, None)
    for k in (3, 9):
        said = replay_dives(DIVES[:k]).surfacing()
        own = sg542.steps[k].headline
        assert own.latitude == said.latitude
        assert np.array_equal(own.covariance, said.covariance)
        assert sg542.steps[k].headline_held == said.holds(DIVES[k])
    found = sg542.summary()
    assert found["forecast"]["judged"] == 13
    rows = [row["forecast"] for row in found["each_dive"][1:]]
    for name in ("inside", "on_time"):
        assert found["forecast"][name] == sum(row[name] for row in rows)
    write_dive_table([*DIVES[:5], *DIVES[6:]], tmp_path / "holed.csv")
    holed = read_dives(tmp_path / "holed.csv")[0]
    unjudged = [step.headline_held is None for step in replay_dives(holed).steps[4:7]]
    assert unjudged == [False, True, False]


def test_a_wrong_fix_is_judged_again_when_it_is_known():
    dives = flown([90.0] * 12)
    lat, lon = place_from(dives[8].lat_gpse, dives[8].lon_gpse, 0.0, 8000.0)
    north = dives[8].gps_north + 8000.0
    dives[8] = replace(dives[8], lat_gpse=lat, lon_gpse=lon, gps_north=north)
    assert replay_dives(dives[:9]).steps[8].headline_held == (False, True)
    assert replay_dives(dives[:10]).steps[8].headline_held == (True, True)


def test_terminal_page_and_files_say_the_same(sample):
    ahead = sample.found["next_dive"]
    within = f"+- {ahead['time_half_width'] / 60:.0f} min"
    half = f"{ahead['ellipse_long']:.0f} x {ahead['ellipse_short']:.0f} m"
    percent, counts = f"{100 * sample.found['level']:g} %", sample.found["forecast"]
    record = f"{counts['inside']} of 13 inside their {percent} ellipse, "
    record += f"{counts['on_time']} within their {percent} time"
    page, kml = (
        (sample.folder / name).read_text() for name in ("replay.html", "track.kml")
    )
    for text in (sample.text.replace("\n", " "), page, kml):
        assert within in text
        assert half in text
        assert record in text or text is kml
    places = json.loads((sample.folder / "next.geojson").read_text())
    said = [one["properties"] for one in places["features"]]
    spot = next(one for one in said if one["name"] == "next surfacing")
    for key in ("time_half_width", "ellipse_long"):
        assert spot[key] == ahead[key]


def test_a_way_of_nothing():
    ends = [((9e3 * k, 0.0, 8.0), (9e3 * k + 7200, 0.0, 8.0)) for k in range(9)]
    still = [make_dive(k, *fixes, (0.0, 0.0)) for k, fixes in enumerate(ends)]
    said = replay_dives(still).surfacing()
    assert np.linalg.eigvalsh(said.covariance).min() > 0
    assert math.isfinite(said.time_half_width)


def seaglider(path, target=b"-4200.000,900.000", heading=-1.0, radius=1000.0):
    """The dive of a file with a plan."""
    letters = np.frombuffer(target.ljust(20, b"\0"), "S1")
    of_one = {"log_HEADING": ((), heading, {}), "log_TGT_RADIUS": ((), radius, {})}
    basestation3(path, log_TGT_LATLONG=(("letters",), letters, {}), **of_one)
    return read_dives(path)[0][0]


@pytest.mark.long
def test_a_hopeless_plan_is_not_followed():
    """Always wrong by far, whatever the length of the record."""
    dives = [
        replace(dive, next_course=(137.0 * k) % 360)
        for k, dive in enumerate(flown([90.0] * 300))
    ]
    ahead = replay_dives(dives, **STILL).next_dive().as_dict()
    assert (ahead["plan_in_files"], ahead["basis"]) == (True, "repeated")
    way = ahead["dr_east"], ahead["dr_north"]
    assert way == pytest.approx((3000.0, 0.0), abs=1.0)


def test_the_plan_of_a_seaglider(tmp_path):
    path = tmp_path / "p5420007.nc"
    dive = seaglider(path)
    bearing = WGS84.inv(dive.lon_gpse, dive.lat_gpse, 9.0, -42.0)[0] % 360
    assert dive.next_course == pytest.approx(bearing, abs=1e-6)
    assert seaglider(path, heading=270.0).next_course == 270.0
    assert seaglider(path, radius=1e7).next_course is None
    for odd in (b"nonsense", b"", b"1e400,8", b"-4260.0,900.0", b"1,2,3"):
        assert seaglider(path, odd).next_course is None


def test_the_error_of_a_forecast_is_from_its_place_to_the_fix():
    for row in replay_dives(DIVES).summary()["each_dive"][2:]:
        ahead = row["forecast"]
        *_, error = WGS84.inv(
            ahead["longitude"],
            ahead["latitude"],
            row["end_longitude"],
            row["end_latitude"],
        )
        assert ahead["error"] == pytest.approx(error, abs=0.1)
        assert ahead["inside"] or error > ahead["ellipse_short"]
