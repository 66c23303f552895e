"""Logs as loggers write them: read, or named."""

import itertools
import json

import numpy as np
import pytest
from geodesics import displacement
from made_missions import BEGIN, CURRENT, HEAD, LEG, UNIFORM, mission, table

import clpt_control as clpt

WEEKS = 1024 * 7 * 86400


@pytest.fixture
def estimate(tmp_path, clpt, monkeypatch):
    """Run `clpt estimate` on a log and return its report."""
    (tmp_path / "s.toml").write_text(UNIFORM)

    def run(path, *words, status=0):
        command = "estimate", path, "--scenario", tmp_path / "s.toml", "--json", *words
        done = clpt(*command)
        assert done.status == status, done.err
        return done.err if status else json.loads(done.out)

    return run


def near(report, current=CURRENT):
    theta = np.array(report["theta_m_s"])[:, 0]
    return np.abs(theta - current).max() < 0.02


# --- what is left out -----------------------------------------------------------------------------


def wild(rows):
    rows[7] = (rows[7][0], rows[7][1] + 0.9, *rows[7][2:])  # 9 m/s


def without_a_fix(rows):
    rows[5] = (rows[5][0], 0.0, 0.0, *rows[5][3:])


def first_without_a_fix(rows):
    rows[0] = (rows[0][0], 0.0, 0.0, *rows[0][3:])


def dated_ahead(rows):
    rows[9] = (rows[9][0] + 10 * 365 * 86400, *rows[9][1:])


def clock_of_1970(rows):
    rows[:4] = [(row[0] - BEGIN + 60.0, *row[1:]) for row in rows[:4]]


def unknown_speed(rows):
    rows[6] = (*rows[6][:3], float("nan"), float("nan"))


@pytest.mark.parametrize(
    "damage",
    [
        wild,
        without_a_fix,
        first_without_a_fix,
        dated_ahead,
        clock_of_1970,
        unknown_speed,
    ],
)
def test_a_wrong_row_costs_its_legs_alone(tmp_path, estimate, damage):
    rows = mission(30, seed=1)
    damage(rows)
    report = estimate(table(tmp_path / "log.csv", rows))
    assert near(report)
    told = json.dumps([report["skipped"], report["notes"]])
    if damage in (without_a_fix, first_without_a_fix, dated_ahead):
        assert report["skipped"]
    assert damage is wild or "line" in told


@pytest.mark.parametrize("off", [-4 * 3600.0, -9e9, 3e8, 1.8e12])
@pytest.mark.parametrize("columns", ["course,speed", "dr_east_m,dr_north_m"])
def test_a_motion_left_out_invents_no_current(tmp_path, estimate, off, columns):
    """Exact fixes in a known current: each forecast after the first legs is exact."""
    rows, moved = mission(12, scatter=0.0, fix=0.0), []
    for before, row in zip([rows[0], *rows], rows, strict=False):
        angle = np.radians(before[3])
        way = before[4] * LEG * np.array([np.sin(angle), np.cos(angle)])
        moved.append((*row[:3], *way))
    rows = rows if columns.startswith("course") else moved
    rows[6] = (rows[6][0] + off, *rows[6][1:])
    head = f"time,latitude,longitude,{columns}"
    report = estimate(table(tmp_path / "log.csv", rows, head))
    errors = [leg["error_m"] for leg in report["legs"][2:]]
    assert len(errors) == 8
    assert max(errors) < 60.0  # 5 mm/s
    assert near(report)


@pytest.mark.long
def test_results_carry_the_skipped_legs(tmp_path, estimate, clpt):
    rows = mission(12, seed=1)
    unknown_speed(rows)
    words = "--results", tmp_path / "l.nc", "--figure", tmp_path / "f.png"
    report = estimate(table(tmp_path / "log.csv", rows), *words)
    (skipped,) = report["skipped"]
    assert skipped["leg"] == 7
    assert "log.csv, line 9: no course and speed before it" in skipped["why"]
    assert clpt("report", tmp_path / "l.nc", "-o", tmp_path / "l.html").status == 0
    assert "skipped: leg 7" in (tmp_path / "l.html").read_text()


def test_stays_are_one_line_and_faults_are_named(tmp_path, estimate):
    rows, read = mission(9, scatter=0.0, fix=0.0), []
    for row in rows:  # an hour at the surface after each leg
        read += [(row[0] - 3600.0, *row[1:3], np.nan, np.nan), row]
    read[9] = (*read[9][:3], np.nan, 1.0)
    skipped = estimate(table(tmp_path / "log.csv", read))["skipped"]
    assert ["(one of 10 legs)" in skip["why"] for skip in skipped] == [True, False]
    assert [skip["leg"] for skip in skipped] == [1, 10]
    assert "one of course and speed is missing" in skipped[1]["why"]


def test_the_first_region_is_that_of_students_t(tmp_path, estimate):
    """Two degrees of freedom: P(|y| > R) = (1 + R^2/(2 s^2))^-1 = 0.1, s^2 by prior and noise.

    The scatter is one of nine kinds, each size as likely as another.
    """
    first = estimate(table(tmp_path / "log.csv", mission(3)))["legs"][0]
    sizes = np.outer([0.3, 1.2, 5.0], [1.0, 0.8, 1.6])
    variance = (0.5 * LEG) ** 2 + 2 * 10.0**2 + (0.02 * sizes * LEG) ** 2
    outside = 1 / (1 + first["radius_m"] ** 2 / (2 * variance))
    assert np.sum(sizes * outside) / np.sum(sizes) == pytest.approx(0.1, rel=1e-6)


def test_a_leg_that_cannot_show_the_scatter_leaves_one_degree_of_freedom(
    tmp_path, estimate
):
    """Of the second region: nu = 1 + P/P(0), R = s (nu (10^(2/nu) - 1))^(1/2), r as it is set."""
    told = f"{UNIFORM}[learning.fix_regression]\nnoise = 0.2\n"
    (tmp_path / "s.toml").write_text(told)
    second = estimate(table(tmp_path / "log.csv", mission(3)))["legs"][1]
    r2 = 200.0**2
    of_theta = 1 / (1 / (0.5 * LEG) ** 2 + 1 / r2)
    nu = 1 + of_theta / (0.5 * LEG) ** 2
    radius = np.sqrt((r2 + of_theta) * nu * (10 ** (2 / nu) - 1))
    assert second["radius_m"] == pytest.approx(radius, rel=6e-2)


def test_swapped_latitude_and_longitude_are_named(tmp_path, estimate):
    rows = [(row[0], row[2], row[1], *row[3:]) for row in mission(4)]
    said = estimate(table(tmp_path / "log.csv", rows), status=2)
    assert "must be from -90 to 90. Are latitude and longitude swapped?" in said


# --- tables ---------------------------------------------------------------------------------------


def written(rows, cell, head=HEAD, mark=","):
    """A log whose cells are printed by functions of their column."""
    lines = [
        mark.join(print_(value) for print_, value in zip(cell, row, strict=True))
        for row in rows
    ]
    return "\n".join([head, *lines]) + "\n"


def minutes(letters):
    def text(value):
        whole = int(abs(value))
        return f"{whole} {60 * (abs(value) - whole):.5f} {letters[value < 0]}"

    return text


P = [lambda t: f"{t:.3f}", *4 * [lambda x: f"{x:.9g}"]]
WRITERS = {
    "semicolons": (P, HEAD.replace(",", ";"), ";"),
    "decimal commas": (
        [lambda x, print_=print_: print_(x).replace(".", ",") for print_ in P],
        HEAD.replace(",", ";"),
        ";",
    ),
    "a spreadsheet's names": (P, "Date (UTC),Lat,Lon,Heading,Speed", ","),
    "knots": (
        [*P[:4], lambda v: f"{v * 3600 / 1852:.9g}"],
        "time,latitude,longitude,course,speed (kn)",
        ",",
    ),
    "cm/s": (
        [*P[:4], lambda v: f"{100 * v:.9g}"],
        "time,latitude,longitude,course (deg),speed (cm/s)",
        ",",
    ),
    "milliseconds": (
        [lambda t: f"{1e3 * t:.0f}", *P[1:]],
        "time (ms),latitude,longitude,course,speed",
        ",",
    ),
    "degE7": (
        [P[0], *2 * [lambda x: f"{1e7 * x:.0f}"], *P[3:]],
        "time,latitude (degE7),longitude (degE7),course,speed",
        ",",
    ),
    "degrees and minutes": ([P[0], minutes("NS"), minutes("EW"), *P[3:]], HEAD, ","),
}


@pytest.mark.parametrize("name", WRITERS)
def test_other_spellings_are_read(tmp_path, estimate, name):
    (tmp_path / "log.csv").write_text(written(mission(30, seed=1), *WRITERS[name]))
    assert near(estimate(tmp_path / "log.csv"))


@pytest.mark.parametrize(
    ("cell", "said"),
    [
        ([lambda t: f"{1e3 * t:.0f}", *P[1:]], "looks like milliseconds since 1970"),
        ([P[0], *2 * [lambda x: f"{1e7 * x:.0f}"], *P[3:]], "looks like 1e-7 degrees"),
        (
            [
                P[0],
                lambda x: f"{60 * x + 40 * int(x):.5f}",
                lambda x: f"{60 * x + 40 * int(x):.5f}",
                *P[3:],
            ],
            "looks like ddmm.mmm",
        ),
    ],
)
def test_unnamed_units_are_named(tmp_path, estimate, cell, said):
    (tmp_path / "log.csv").write_text(written(mission(30, seed=1), cell))
    assert said in estimate(tmp_path / "log.csv", status=2)


def test_a_magnetic_heading_is_refused(tmp_path, estimate):
    head = "time,latitude,longitude,heading (mag),speed"
    path = table(tmp_path / "log.csv", mission(5), head)
    assert "is magnetic" in estimate(path, status=2)


def test_a_lost_turn_makes_its_leg_unknown(tmp_path, estimate):
    """A line with a cell too many may have been a turn."""
    rows = mission(12, seed=1)
    path = table(tmp_path / "log.csv", rows)
    lines = path.read_text().splitlines()
    lines.insert(6, f"{rows[4][0] + 600:.3f},,,200,1.0,9")
    path.write_text("\n".join(lines))
    report = estimate(path)
    assert [leg["leg"] for leg in report["legs"]] == [1, 2, 3, 4, *range(6, 13)]
    whys = [skip["why"] for skip in report["skipped"]]
    assert any("line 7: has 6 cells, the header 5" in why for why in whys)
    assert any("line 7 is left out" in why for why in whys)
    assert near(report)


def test_equal_rows_twice_are_one_row(tmp_path, estimate):
    path = table(tmp_path / "log.csv", mission(12, seed=1))
    whole = estimate(path)
    lines = path.read_text().splitlines()
    lines.insert(5, lines[5])
    path.write_text("\n".join(lines))
    assert estimate(path)["theta_m_s"] == whole["theta_m_s"]


def unreadable_time(rows):
    return 8, {"time": "soon"}


def missing_time(rows):
    return 8, {"time": None}


def unreadable_speed(rows):
    return 8, {"speed": "fast"}


def impossible_course(rows):
    return 8, {"course": 720.0}


def early_by_weeks(rows):
    return 8, {"time": rows[8][0] - WEEKS}


def out_of_order(rows):
    return 8, {"time": rows[7][0] - 60.0}


@pytest.mark.parametrize(
    "damage",
    [
        unreadable_time,
        missing_time,
        unreadable_speed,
        impossible_course,
        early_by_weeks,
        out_of_order,
    ],
)
def test_one_wrong_row_in_the_middle_is_left_out(tmp_path, estimate, damage):
    rows = [(*row, 1.0)[:5] for row in mission(30, seed=1)]
    number, wrong = damage(rows)
    objects = [dict(zip(HEAD.split(","), row, strict=True)) for row in rows]
    objects[number] |= wrong
    path = tmp_path / "log.csv"
    texts = [
        ",".join("" if cell is None else str(cell) for cell in row.values())
        for row in objects
    ]
    path.write_text("\n".join([HEAD, *texts]))
    report = estimate(path)
    assert near(report)
    assert any(f"line {number + 2}" in skip["why"] for skip in report["skipped"])


def test_a_log_that_is_not_in_order_is_refused(tmp_path, estimate):
    rows = mission(12, seed=1)
    path = table(tmp_path / "log.csv", rows[::-1])
    assert "Sort the rows by time" in estimate(path, status=2)


@pytest.mark.sampled
@pytest.mark.parametrize("skipped", [0, 1])
def test_the_origin_is_the_start_of_the_first_leg_that_is_learned(
    tmp_path, estimate, skipped
):
    """With a flow that differs by place and hour; a learner of live fixes has it too."""
    (tmp_path / "s.toml").write_text(
        UNIFORM.replace("origin", "# origin").replace("1e5", "30.0")
    )
    rows = mission(30, seed=1)
    rows[:skipped] = [(*row[:3], float("nan"), float("nan")) for row in rows[:skipped]]
    read = [(row[0], *map(float, (f"{cell:.9g}" for cell in row[1:]))) for row in rows]
    known = tmp_path / "known.toml"
    report = estimate(table(tmp_path / "log.csv", rows), "--out", known)
    learner = clpt.currents.FlowEstimator(clpt.load_scenario(tmp_path / "s.toml"))
    for row, after in itertools.pairwise(read):
        learner.fix(*row[:3])
        angle, way = np.radians(row[3]), row[4] * LEG
        if np.isfinite(way):
            learner.move(after[0], way * np.sin(angle), way * np.cos(angle))
    learner.fix(*read[-1][:3])
    theta = learner.flow_parameters
    np.testing.assert_allclose(theta, report["theta_m_s"], rtol=1e-9)
    assert clpt.load_scenario(known).origin == pytest.approx(
        read[skipped][1:3], abs=1e-6
    )


# --- units and axes -------------------------------------------------------------------------------

WAYS = {
    "knots": (lambda c, v: (c, v / 0.514444), "speeds look like knots"),
    "km/h": (lambda c, v: (c, v * 3.6), "speeds look like km/h"),
    "from": (lambda c, v: ((c + 180) % 360, v), "that the vehicle comes from"),
    "mathematical": (lambda c, v: ((90 - c) % 360, v), "counted from east"),
    "magnetic": (lambda c, v: ((c - 13) % 360, v), "degrees clockwise from"),
    "compass": (lambda c, v: ((c + 13) % 360, v), "degrees anticlockwise from"),
}


@pytest.mark.parametrize("name", WAYS)
def test_wrong_units_and_axes_are_named(tmp_path, estimate, name):
    way, said = WAYS[name]
    rows = [(*row[:3], *way(*row[3:])) for row in mission(30, seed=1)]
    results = tmp_path / "log.nc"
    report = estimate(table(tmp_path / "log.csv", rows), "--results", results)
    assert said in " ".join(report["notes"])
    if name == "compass":  # its page has the note once, and the name of the file
        page = tmp_path / "page.html"
        clpt.report(results, page)
        text = page.read_text("utf-8")
        assert "<h1>log.csv</h1>" in text
        assert text.count(said) == 1


MIRRORED = {
    "longitudes look positive to the west": (1, -1),
    "latitudes look positive to the south": (-1, 1),
    "latitudes and longitudes have the wrong signs": (-1, -1),
}


@pytest.mark.parametrize("said", MIRRORED)
def test_mirrored_places_are_named(tmp_path, estimate, said):
    north, east = MIRRORED[said]
    rows = [(t, a * north, b * east, *way) for t, a, b, *way in mission(30, seed=1)]
    assert said in " ".join(estimate(table(tmp_path / "log.csv", rows))["notes"])


def test_a_table_of_fixes_is_in_the_message_for_a_missing_file(tmp_path, estimate):
    said = estimate(tmp_path / "nothere.csv", status=2)
    assert "a CSV table of dives or of fixes" in said


def over_ground(rows):
    """Return rows with course and speed of the ways between the fixes."""
    ground = []
    for row, after in itertools.pairwise(rows):
        east, north = displacement(*row[1:3], *after[1:3])
        course = np.degrees(np.arctan2(east, north)) % 360
        ground.append((*row[:3], course, np.hypot(east, north) / LEG))
    return ground


@pytest.mark.sampled
@pytest.mark.parametrize("part", ["courses", "speeds"])
def test_one_part_over_ground_is_named(tmp_path, estimate, part):
    """A true heading with speed over ground, and a course over ground with speed."""
    rows = mission(14, seed=1, scatter=0.005)
    ground = over_ground(rows)
    noise = np.random.default_rng(3).normal(0, 1, len(ground))
    mixed = [
        (*row[:3], course + 0.2 * off, row[4])
        if part == "courses"
        else (*row[:4], speed + 0.005 * off)
        for row, (*_, course, speed), off in zip(rows, ground, noise, strict=False)
    ]
    notes = " ".join(estimate(table(tmp_path / "log.csv", mixed))["notes"])
    assert f"{part} look like those over ground, not through the water" in notes
    assert estimate(table(tmp_path / "log.csv", rows))["notes"] == []


@pytest.mark.long
def test_course_and_speed_over_ground_are_named(tmp_path, estimate):
    """Errors that are smaller than the noise of the fixes are impossible."""
    rows = mission(30, seed=1)
    ground = over_ground(rows)
    notes = " ".join(estimate(table(tmp_path / "log.csv", ground))["notes"])
    assert "look like those over ground" in notes
    # a receiver has noise of its own in each fix, and none in its speed
    noise = np.random.default_rng(2).normal(0, 10 / 111e3, (len(ground), 2))
    noisy = [
        (t, lat + a, lon + b, *way)
        for (t, lat, lon, *way), (a, b) in zip(ground, noise, strict=True)
    ]
    notes = " ".join(estimate(table(tmp_path / "log.csv", noisy))["notes"])
    assert "look like those over ground" in notes
    clean = estimate(table(tmp_path / "log.csv", rows))
    assert clean["notes"] == []


def test_read_dives_takes_a_log_too(tmp_path):
    dives, skipped = clpt.gliders.read_dives(table(tmp_path / "log.csv", mission(12)))
    assert (len(dives), skipped) == (12, [])


def test_degrees_west_and_south_have_their_sign(tmp_path):
    rows = ["time,lat (deg S),lon (deg W),course,speed"]
    rows += [f"2026-05-01T0{k}:00:00Z,36.7,{122.1 - 0.03 * k},90,1.0" for k in (0, 2)]
    (tmp_path / "log.csv").write_text("\n".join(rows))
    (leg,), _ = clpt.gliders.read_dives(tmp_path / "log.csv", usable=False)
    assert leg.start == (-36.7, -122.1)
