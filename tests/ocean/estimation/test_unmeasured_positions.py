"""Positions that are no fixes: held by a receiver, reckoned by the vehicle, interpolated by a file.

The current is that of the made missions; their fixes alone are the right table.
"""

import tomllib
from dataclasses import replace
from itertools import pairwise
from math import atan2, cos, degrees, radians, sin

import numpy as np
import pytest
from geodesics import displacement, place_from
from made_missions import CURRENT, HEAD, LEG, UNIFORM, mission
from refusals import refuses
from scipy.interpolate import CubicSpline

import clpt_control as clpt

SCENARIO = clpt.Scenario(**tomllib.loads(UNIFORM))
BEGIN_OF_SOUTH = (1777593600.0, -58.3, 179.9)


def velocity(row):
    return row[4] * np.array([sin(radians(row[3])), cos(radians(row[3]))])


def between(fixes, every, kind, jitter=0.3, seed=5):
    """Rows each `every` s, of which only those at the times of the fixes are fixes."""
    random = np.random.default_rng(seed)
    for number, (fix, after) in enumerate(zip(fixes, [*fixes[1:], None], strict=True)):
        yield fix
        kind_of_leg = kind[number % len(kind)]
        for k in range(1, round(LEG / every) if after else 1):
            line = np.array([fix[1:3], (after or fix)[1:3]])
            place = {
                "held": place_from(*fix[1:3], *random.normal(0, jitter, 2)),
                "digit": line[0] + 1e-5 * random.integers(-1, 2, 2),
                "reckoned": place_from(*fix[1:3], *(velocity(fix) * every * k)),
                "interpolated": line[0] + every * k / LEG * (line[1] - line[0]),
            }[kind_of_leg]
            yield (fix[0] + every * k, *place, *fix[3:])


def with_jitter(rows, jitter, turn=0.0, seed=6):
    """Rows with jitter of the positions between fixes, and a turn in the middle of each leg."""
    random = np.random.default_rng(seed)
    for time, north, east, course, speed in rows:
        elapsed = (time - rows[0][0]) % LEG
        off = random.normal(0, jitter, 2) * (elapsed > 0)
        course += turn * (elapsed >= LEG / 2)
        yield time, *place_from(north, east, *off), course, speed


def rounded(rows, digits):
    return [
        (row[0], round(row[1], digits), round(row[2], digits), *row[3:]) for row in rows
    ]


def recorded(path, rows, head=HEAD):
    """Legs of a log, and the sentences on what is left out."""
    columns = head.count(",") + 1
    lines = [",".join(repr(float(cell)) for cell in row[:columns]) for row in rows]
    path.write_text("\n".join([head, *lines]) + "\n")
    legs, skipped = clpt.gliders.read_dives(path, usable=False)
    return legs, [one.why.split(": ", 1)[1] for one in skipped]


def fed(rows, estimator=None):
    """A live estimator that was fed with rows, and its notes."""
    estimator, notes, last = (
        estimator or clpt.currents.FlowEstimator(SCENARIO),
        [],
        None,
    )
    for row in rows:
        if last:
            estimator.move(row[0], *(velocity(last) * (row[0] - last[0])))
        notes.append(estimator.fix(*row[:3]).note)
        last = row
    return estimator, notes


def flow_of(legs):
    estimate = clpt.currents.flow_estimate(legs, SCENARIO)
    return estimate.flow_parameters_estimate.values[-1]


def is_a_question(legs):
    refuses(
        "[0-9]+ of [0-9]+ positions follow from the rows around them", flow_of, legs
    )


# digits, seconds between rows, kinds of the legs, how the mission differs
LOGS = [
    (6, 600.0, ["held"], {}),
    (5, 900.0, ["held"], {"begin": BEGIN_OF_SOUTH}),
    (8, 600.0, ["reckoned"], {"begin": BEGIN_OF_SOUTH}),
    (7, 900.0, ["held", "reckoned"], {}),
    (8, 5400.0, ["interpolated"], {}),
    (5, 600.0, ["interpolated"], {}),
    (8, 600.0, ["reckoned", "interpolated"], {"begin": BEGIN_OF_SOUTH}),
]
# with jitter, or digits and steps that hide what is exact
ASKED = [
    (8, 600.0, ["held"], {}),
    (6, 900.0, ["held"], {"begin": BEGIN_OF_SOUTH}),
    (5, 600.0, ["digit"], {}),
    (4, 900.0, ["held"], {}),
    (6, 5400.0, ["reckoned"], {}),
    (4, 900.0, ["reckoned"], {}),
    (8, 900.0, ["held", "reckoned"], {}),
]


@pytest.mark.parametrize(("digits", "every", "kinds", "changes"), LOGS)
def test_positions_without_a_measurement_are_left_out(
    tmp_path, digits, every, kinds, changes
):
    fixes = rounded(mission(12, scatter=0.02, fix=3.0, seed=3, **changes), digits)
    rows = rounded(between(fixes, every, kinds, 0.0), digits)
    legs, whys = recorded(tmp_path / "log.csv", rows)
    right, none = recorded(tmp_path / "fixes.csv", fixes)
    assert none == []
    # a leg or two may end one row early or late, where digits hide a jump
    assert abs(len(legs) - 12) <= (digits < 6)
    assert np.abs(flow_of(legs) - flow_of(right)).max() < 0.003
    (why,) = whys
    assert f"{len(rows) - len(legs) - 1} rows are no fixes" in why
    assert kinds[0] in why


@pytest.mark.parametrize(("digits", "every", "kinds", "changes"), ASKED)
def test_positions_that_are_nearly_held_or_reckoned_are_a_question(
    tmp_path, digits, every, kinds, changes
):
    fixes = rounded(mission(12, scatter=0.02, fix=3.0, seed=3, **changes), digits)
    rows = rounded(between(fixes, every, kinds), digits)
    legs, whys = recorded(tmp_path / "log.csv", rows)
    assert whys == []
    is_a_question(legs)


@pytest.mark.parametrize("fix", [0, 60])
@pytest.mark.parametrize(("digits", "every"), [(8, 60.0), (5, 60.0), (7, 600.0)])
def test_a_log_that_is_reckoned_throughout_is_a_question(tmp_path, digits, every, fix):
    """The drift is 0 everywhere, but at the one fix."""
    place, rows = (36.7, -122.1), []
    for k in range(150):
        if fix and k == fix:
            place = place_from(*place, 400.0, -300.0)
        rows.append((1.7e9 + every * k, *place, 30.0 * (k // 18), 1.0))
        place = place_from(*place, *(every * velocity(rows[-1])))
    legs, whys = recorded(tmp_path / "log.csv", rounded(rows, digits))
    assert whys == []
    is_a_question(legs)


@pytest.mark.parametrize(
    ("kind", "jitter", "digits"),
    [
        ("held", 1.0, 8),
        ("held", 3.0, 5),
        ("reckoned", 0.5, 8),
        ("reckoned", 2.0, 6),
        ("interpolated", 0.1, 8),
        ("interpolated", 0.5, 5),
    ],
)
def test_positions_with_jitter_are_left_out_or_a_question(
    tmp_path, kind, jitter, digits
):
    """The interpolated ones follow no turn of the vehicle."""
    fixes = mission(12, scatter=0.02, fix=3.0, seed=3)
    rows = [*between(fixes, 600.0, [kind], 0.0)]
    turn = 110.0 if kind == "interpolated" else 0.0
    rows = rounded(with_jitter(rows, jitter, turn), digits)
    legs, whys = recorded(tmp_path / "log.csv", rows)
    if not whys:
        return is_a_question(legs)
    assert whys[0].endswith(f"{len(rows) - 13} {kind}")
    assert [leg.t_gps2 for leg in legs] == [fix[0] for fix in fixes[:-1]]


def test_a_leg_that_is_refused_has_no_row(tmp_path):
    """Legs that were not compared as rows of a log, whose receiver held a fix."""
    legs, _ = recorded(tmp_path / "log.csv", mission(12, fix=3.0, seed=3))
    north, east = legs[4].start
    held = {"lat_gps2": north, "lon_gps2": east, "lat_gpse": north, "lon_gpse": east}
    legs[4:7] = [replace(leg, **held) for leg in legs[4:7]]
    estimate = clpt.currents.flow_estimate(legs, SCENARIO)
    refused = [note for note in estimate.attrs["notes"] if "no fix" in note]
    assert len(refused) + estimate.leg.size == 12
    assert len(refused) >= 2
    assert np.isfinite(estimate.position_error).all()


@pytest.mark.parametrize(
    ("digits", "every", "drop"), [(8, 600.0, 0.0), (6, 300.0, 0.3)]
)
def test_reckoned_positions_without_motion_are_told(tmp_path, digits, every, drop):
    """A jump is the fix, and the position before it is none."""
    fixes = mission(12, fix=3.0, seed=1)
    random = np.random.default_rng(1)
    rows = [
        row
        for row in between(fixes, every, ["reckoned"])
        if (row[0] - fixes[0][0]) % LEG == 0 or random.random() >= drop
    ]
    legs, whys = recorded(
        tmp_path / "log.csv", rounded(rows, digits), "time,latitude,longitude"
    )
    assert len(legs) == 12
    assert (
        f"{len(rows) - 13} rows are no fixes and are left out: {len(rows) - 13} reckoned"
        in (whys[0])
    )
    # reckoned positions with dropped rows, with the motion
    legs, _ = recorded(tmp_path / "log.csv", rounded(rows, digits))
    assert len(legs) == 12


@pytest.mark.long
def test_a_live_note_goes_on_after_a_restart(tmp_path):
    """Positions that were reckoned are learned; one note tells so, and nothing is taken back."""
    fixes = mission(5, fix=3.0, seed=2)
    rows = [*between(fixes, 600.0, ["reckoned"])]
    estimator, notes = fed(rows[:50])
    told = "20 of 20 positions follow from the rows around them"
    assert sum(told in note for note in notes) == 1
    assert any(told in warning for warning in estimator.warnings)
    estimator.save(tmp_path / "s")
    loaded = clpt.currents.FlowEstimator.load(tmp_path / "s")
    step = velocity(rows[49]) * 600.0
    for one in (estimator, loaded):
        one.move(rows[50][0], *step)
        _, notes = fed(rows[50:], one)
        assert not any("follow from" in note for note in notes)
    assert (estimator.legs, loaded.legs) == (90, 90)
    np.testing.assert_array_equal(estimator.flow_parameters, loaded.flow_parameters)


def test_exact_repeats_are_no_fixes_live():
    fixes = mission(6, fix=3.0, seed=2)
    rows = rounded(between(fixes, 600.0, ["held"], jitter=0.0), 6)
    estimator, notes = fed(rows)
    held = "held: the position carries no measurement and is no fix"
    assert notes.count(held) == len(rows) - 7
    assert np.abs(estimator.flow_parameters[:, 0] - CURRENT).max() < 0.03


# motion through the water and over ground of each row (m/s), of the current c
VEHICLES = {
    "drifter": lambda c, k: (0.0 * c, c),
    "moored": lambda c, k: (0.0 * c, 0.0 * c),
    "moored with a log": lambda c, k: (-c, 0.0 * c),
    "at its station, then away": lambda c, k: (-c, 0.0 * c) if k % 25 else (-2 * c, -c),
    "slow": lambda c, k: (0.02 * heading(k), 0.02 * heading(k) + c),
    "lawn-mower": lambda c, k: (
        heading(1.57 * (k // 12)),
        heading(1.57 * (k // 12)) + c,
    ),
    "still water": lambda c, k: (heading(k), heading(k)),
}


def heading(angle):
    return np.array([sin(angle), cos(angle)])


@pytest.mark.parametrize("name", VEHICLES)
@pytest.mark.parametrize(
    ("noise", "digits", "every"), [(2.0, 5, 3600.0), (2.0, 4, 300.0), (20.0, 6, 1.0)]
)
def test_true_fixes_stay(tmp_path, name, noise, digits, every):
    random = np.random.default_rng([7, digits, *name.encode()])
    current, place, rows = random.normal(0, 0.2, 2), (47.1, -20.3), []
    for k in range(60):
        water, ground = VEHICLES[name](current, k)
        read = place_from(*place, *random.normal(0, noise, 2))
        course = degrees(atan2(*water))
        rows.append((1.7e9 + every * k, *read, course, float(np.hypot(*water))))
        place = place_from(*place, *(ground * every))
    rows = rounded(rows, digits)
    legs, whys = recorded(tmp_path / "log.csv", rows)
    assert (len(legs), whys) == (59, [])
    estimator, _ = fed(rows)
    assert estimator.legs == 59


def test_a_moored_vehicle_has_no_wrong_unit():
    random, rows = np.random.default_rng(8), []
    for k in range(72):
        water = random.normal([-0.15, 0.1], 0.005)
        motion = degrees(atan2(*water)), float(np.hypot(*water))
        place = place_from(47.1, -20.3, *random.normal(0, 10, 2))
        rows.append((1.7e9 + 7200.0 * k, *place, *motion))
    estimator, _ = fed(rows)
    assert estimator.legs == 71
    assert "contradict" not in " ".join(estimator.warnings)


@pytest.mark.long
def test_a_moored_vehicle_without_noise_is_in_no_flow(tmp_path):
    """Positions of one decimal, which repeat more often than a power of a chance can say."""
    rows = [(1.7e9 + 600.0 * k, 36.7, -122.1, 0.0, 0.0) for k in range(100)]
    legs, whys = recorded(tmp_path / "log.csv", rows)
    assert (len(legs), whys) == (99, [])
    np.testing.assert_array_equal(flow_of(legs), 0.0)
    estimator, notes = fed(rows)
    assert (estimator.legs, {*notes}) == (99, {""})
    np.testing.assert_array_equal(estimator.flow_parameters, 0.0)


@pytest.mark.parametrize(
    ("jitter", "digits", "each", "every"),
    [(0.0, 6, 12, 600.0), (0.0, 4, 12, 600.0), (1.0, 6, 12, 50.0), (3.0, 5, 4, 3600.0)],
)
def test_positions_held_between_the_fixes_of_a_drifter(
    tmp_path, jitter, digits, each, every
):
    """The jumps are the fixes: the flow is that of the line from the first to the last."""
    random, rows, fix = np.random.default_rng(4), [], None
    current = np.array([0.23, -0.11])
    for k in range(12 * each + 1):
        read = place_from(36.7, -122.1, *(current * every * k))
        off = random.normal(0, 1, 2)
        if k % each == 0:
            fix = read = place_from(*read, *(3.0 * off))
        else:
            read = place_from(*fix, *(jitter * off))
        rows.append((1.7e9 + every * k, *read, 0.0, 0.0))
    rows = rounded(rows, digits)
    legs, whys = recorded(tmp_path / "log.csv", rows)
    if jitter or digits == 4:
        return is_a_question(legs)
    assert whys[0].endswith(f"{len(rows) - 13} held")
    assert len(legs) == 12
    assert np.abs(flow_of(legs)[:, 0] - current).max() < 0.01


@pytest.mark.long
def test_a_buoy_that_swings_or_drags_keeps_its_fixes(tmp_path):
    """It swings by 200 m with each tide, or drags its anchor twice."""
    random = np.random.default_rng(9)
    tilt = np.array([1.0, 0.3])
    swings = [100.0 * (-1) ** (k // 37) for k in range(193)]
    drags = [150.0 * ((k > 70) + (k > 131)) for k in range(193)]
    for number, east in enumerate((swings, drags)):
        places = [
            place_from(47.1, -20.3, *(x * tilt + random.normal(0, 3, 2))) for x in east
        ]
        rows = [(1.7e9 + 600.0 * k, *at, 0.0, 0.0) for k, at in enumerate(places)]
        legs, whys = recorded(tmp_path / f"{number}.csv", rounded(rows, 6))
        assert (len(legs), whys) == (192, [])
        assert fed(rounded(rows, 6))[0].legs == 192


def test_true_fixes_without_noise_stay_live():
    """A simulation in a slow flow: own motion plus 6 m in each step."""
    place, rows = (36.7, -122.1), []
    current = np.array([0.01, 0.01])
    for k in range(80):
        course = 57.0 * (k // 7) ** 2
        rows.append((1.7e9 + 600.0 * k, *place, course, 1.0))
        place = place_from(*place, *(600.0 * (velocity(rows[-1]) + current)))
    estimator, notes = fed(rounded(rows, 7))
    assert (estimator.legs, {*notes}) == (79, {""})
    assert np.abs(estimator.flow_parameters[:, 0] - current).max() < 0.001


# --- positions that are a question ----------------------------------------------------------------


def spline(fixes, times):
    time, *places = np.transpose([fix[:3] for fix in fixes])
    return np.array(CubicSpline(time, np.transpose(places))(times))


def computed(kind, fixes, every=600.0):
    """Rows between fixes: reckoned with a current, moved to the next fix, filtered, of a spline."""
    random, rows = np.random.default_rng(4), []
    pending = np.zeros(2)  # m that a filter has yet to come
    at = fixes[0][1:3]
    for fix, after in pairwise(fixes):
        own = [np.array(fix[1:3])]
        courses = fix[3] + random.normal(0, 3.0, round(LEG / every))
        steps = [every * velocity((0, 0, 0, course, fix[4])) for course in courses]
        for step in steps:
            own.append(np.array(place_from(*own[-1], *step)))
        for k, course in enumerate(courses):
            time, share = fix[0] + every * k, k / len(courses)
            place = {
                "moved": own[k] + share * (np.array(after[1:3]) - own[-1]),
                "current": place_from(*own[k], 0.1 * every * k, -0.05 * every * k),
                "filter": at,
                "spline": spline(fixes, time),
            }[kind]
            rows.append((time, *place, course, fix[4]))
            at = place_from(*at, *(steps[k] + 0.3 * pending))
            pending = 0.7 * pending
        pending = np.array(displacement(*at, *after[1:3]))
    return [*rows, fixes[-1]]


@pytest.mark.long
@pytest.mark.parametrize("digits", [7, 5])
@pytest.mark.parametrize("kind", ["moved", "current", "filter", "spline"])
def test_computed_positions_are_a_question(tmp_path, kind, digits):
    fixes = mission(16, scatter=0.02, fix=3.0, seed=3)
    rows = rounded(computed(kind, fixes), digits)
    legs, whys = recorded(tmp_path / "log.csv", rows)
    assert (len(legs), whys) == (len(rows) - 1, [])
    refuses(
        "2[0-9][0-9] of 289 positions follow from the rows around them .* Give a column that "
        "marks fixes .*every_row=True",
        flow_of,
        legs,
    )
    estimate = clpt.currents.flow_estimate(legs, SCENARIO, every_row=True)
    assert estimate.leg.size == len(legs)


@pytest.mark.long
def test_every_row_keeps_positions_that_repeat(tmp_path):
    rows = rounded(between(mission(6, fix=3.0), 600.0, ["held"], 0.0), 6)
    recorded(tmp_path / "log.csv", rows)
    legs, skipped = clpt.gliders.read_dives(
        tmp_path / "log.csv", usable=False, every_row=True
    )
    assert (len(legs), skipped) == (len(rows) - 1, [])
    estimate = clpt.currents.flow_estimate(legs, SCENARIO, every_row=True)
    assert estimate.leg.size == len(legs)


def test_a_run_has_no_rows():
    run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 10}))
    refuses(
        "every_row: is of legs",
        clpt.currents.flow_estimate,
        run,
        every_row=True,
        error=clpt.ScenarioError,
    )
