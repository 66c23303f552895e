"""Logs as loggers write them, recorded and live: read, or named."""

import itertools
import json
import sys

import numpy as np
import pytest
from geodesics import displacement
from made_missions import BEGIN, CURRENT, HEAD, LEG, UNIFORM, lines_of, mission, table
from subprocesses import CLPT, ran
from test_live_fixes import EXAMPLE, checked

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


@pytest.fixture
def live(tmp_path):
    """Answer lines by `clpt estimate -`; return answers and standard error."""
    (tmp_path / "s.toml").write_text(UNIFORM)

    def run(lines, *words, status=0):
        command = [*CLPT, "estimate", "-", "--scenario", tmp_path / "s.toml", *words]
        done = ran(*command, input="\n".join(lines), status=status)
        return [json.loads(line) for line in done.stdout.splitlines()], done.stderr

    return run


def near(report, current=CURRENT):
    theta = np.array(report["theta_m_s"])[:, 0]
    return np.abs(theta - current).max() < 0.02


# --- one screen for recorded and live -------------------------------------------------------------


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


@pytest.mark.thirds
@pytest.mark.thirds
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
def test_recorded_and_live_have_the_same_numbers(tmp_path, estimate, live, damage):
    rows = mission(30, seed=1)
    damage(rows)
    report = estimate(table(tmp_path / "log.csv", rows))
    read = [(row[0], *map(float, (f"{cell:.9g}" for cell in row[1:]))) for row in rows]
    answers, _ = live(line.replace("NaN", "null") for line in lines_of(read))
    last = answers[-1]
    assert near(report)
    for key in ("theta_m_s", "standard_error_m_s"):
        np.testing.assert_allclose(last[key], report[key], rtol=1e-9)
    told = json.dumps([report["skipped"], report["notes"]])
    if damage in (without_a_fix, first_without_a_fix, dated_ahead):
        assert report["skipped"]
        assert any("skipped" in answer for answer in answers)
    assert damage is wild or "line" in told


@pytest.mark.thirds
@pytest.mark.parametrize("off", [-4 * 3600.0, -9e9, 3e8, 1.8e12])
@pytest.mark.parametrize("columns", ["course,speed", "dr_east_m,dr_north_m"])
def test_a_motion_left_out_invents_no_current(tmp_path, estimate, live, off, columns):
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
    keys = head.split(",")
    lines = [dict(zip(keys, row, strict=True)) for row in rows]
    lines[0] = dict([*lines[0].items()][: 3 if rows is moved else 5])
    answers, _ = live(map(json.dumps, lines))
    errors = [leg["error_m"] for leg in report["legs"][2:]]
    seen = [one["error_m"] for one in answers if one.get("error_m") is not None][2:]
    assert (len(errors), len(seen)) == (8, 8)
    assert max(errors + seen) < 60.0  # 5 mm/s
    assert near(report)


@pytest.mark.long
def test_a_clock_that_is_ahead_at_first_ends_nothing(live):
    rows = mission(12, seed=3)
    rows[0] = (rows[0][0] + 20 * 365 * 86400, *rows[0][1:])
    answers, _ = live(lines_of(rows))
    assert answers[-1]["legs"] >= 10


@pytest.mark.long
def test_a_late_course_is_told(live):
    lines = lines_of(mission(3, seed=3))
    late = json.dumps({"time": BEGIN + LEG / 2, "course": 90, "speed": 1.0})
    answers, told = live([*lines[:4], late, *lines[4:]])
    skipped = [answer for answer in answers if "skipped" in answer]
    assert skipped[0]["time"] == "2026-05-01T01:30:00Z"
    assert "line 5: skipped, not later than the row before" in told


@pytest.mark.long
def test_a_bad_plan_loses_the_plan_not_the_fix(live):
    """And the plan of the last fix can be asked again after a kill."""
    rows = mission(3, seed=3)
    lines = lines_of(rows)[:-1]
    early = [{"time": BEGIN, "course": 90, "speed": 1.0}]
    lines[-1] = json.dumps(json.loads(lines[-1]) | {"plan": early})
    good = [{"time": rows[-1][0] + LEG, "course": 90, "speed": 1.0}]
    again = json.dumps(json.loads(lines[-1]) | {"plan": good})
    answers, _ = live([*lines, again])
    assert [answer["legs"] for answer in answers[:-1]] == [0, 1, 2, 3]
    said = "plan: time 2026-05-01T00:00:00Z must be later than 2026-05-01T09:00:00Z"
    assert answers[-2]["plan_refused"] == said
    assert answers[-1]["next"]["time"] == "2026-05-01T12:00:00Z"
    assert answers[-1]["next"]["radius_m"] > 0


@pytest.mark.long
def test_lines_between_fixes_are_appended_and_read_again(tmp_path, live):
    """A torn last line, as a kill leaves it, is no line."""
    rows, state = mission(4, seed=3), tmp_path / "state.json"
    lines = lines_of(rows)
    turn = {"time": rows[2][0] + 600, "course": 30.0, "speed": 1.0}
    lines.insert(6, json.dumps(turn))
    whole, _ = live(lines)
    live(lines[:6], "--state", state)
    with state.open("a") as journal:
        journal.write('{"time": 17')
    live(lines[6:7], "--state", state)
    assert json.loads(state.read_text().splitlines()[-1]) == turn
    answers, _ = live(lines[7:], "--state", state)
    assert answers[-1] == whole[-1]


def test_two_writers_of_a_state_are_refused(tmp_path, clpt, monkeypatch):
    filelock = pytest.importorskip("filelock")
    (tmp_path / "s.toml").write_text(UNIFORM)
    state = tmp_path / "state.json"
    command = "estimate", "-", "--scenario", tmp_path / "s.toml", "--state", state
    with filelock.FileLock(f"{state}.lock", timeout=0):
        done = clpt(*command)
    assert done.status == 2
    assert "another clpt estimate writes it" in done.err


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
    """Two degrees of freedom: P(|y| > R) = (1 + R^2/(2 s^2))^-1 = 0.1, s^2 by prior and noise."""
    first = estimate(table(tmp_path / "log.csv", mission(3)))["legs"][0]
    variance = (0.5 * LEG) ** 2 + 2 * 10.0**2 + (0.02 * LEG) ** 2
    assert first["radius_m"] == pytest.approx(np.sqrt(2 * 9 * variance), rel=1e-3)


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


@pytest.mark.thirds
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


@pytest.mark.thirds
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
def test_one_wrong_row_is_left_out_recorded_and_live(tmp_path, estimate, live, damage):
    """A row in the middle of a log, and its line in the middle of a stream."""
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
    is_read = damage in (early_by_weeks, out_of_order)
    answers, told = live(map(json.dumps, objects), status=0 if is_read else 2)
    assert near(report)
    np.testing.assert_allclose(answers[-1]["theta_m_s"], report["theta_m_s"], rtol=1e-9)
    assert answers[-1]["legs"] == len(report["legs"])
    line = f"line {number + 2}"
    assert any(line in skip["why"] for skip in report["skipped"])
    assert f"line {number + 1}: " in told or any("skipped" in one for one in answers)


def test_a_log_that_is_not_in_order_is_refused(tmp_path, estimate):
    rows = mission(12, seed=1)
    path = table(tmp_path / "log.csv", rows[::-1])
    assert "Sort the rows by time" in estimate(path, status=2)


@pytest.mark.parametrize("skipped", [0, 1])
def test_the_origin_is_the_start_of_the_first_leg_that_is_learned(
    tmp_path, estimate, live, skipped
):
    """With a flow that differs by place and hour, recorded and live."""
    (tmp_path / "s.toml").write_text(
        UNIFORM.replace("origin", "# origin").replace("1e5", "30.0")
    )
    rows = mission(30, seed=1)
    rows[:skipped] = [(*row[:3], float("nan"), float("nan")) for row in rows[:skipped]]
    read = [(row[0], *map(float, (f"{cell:.9g}" for cell in row[1:]))) for row in rows]
    known = tmp_path / "a.toml", tmp_path / "b.toml"
    report = estimate(table(tmp_path / "log.csv", rows), "--out", known[0])
    lines = (line.replace("NaN", "null") for line in lines_of(read))
    answers, _ = live(lines, "--out", known[1])
    np.testing.assert_allclose(answers[-1]["theta_m_s"], report["theta_m_s"], rtol=1e-9)
    first, second = (clpt.load_scenario(path) for path in known)
    assert first.origin == pytest.approx(read[skipped][1:3], abs=1e-6)
    assert second.origin == pytest.approx(first.origin, abs=1e-6)
    assert first.title == second.title


# --- units and axes -------------------------------------------------------------------------------

WAYS = {
    "knots": (lambda c, v: (c, v / 0.514444), "speeds look like knots"),
    "km/h": (lambda c, v: (c, v * 3.6), "speeds look like km/h"),
    "radians": (lambda c, v: (np.radians(c), v), "courses look like radians"),
    "from": (lambda c, v: ((c + 180) % 360, v), "that the vehicle comes from"),
    "mathematical": (lambda c, v: ((90 - c) % 360, v), "counted from east"),
    "magnetic": (lambda c, v: ((c - 13) % 360, v), "look magnetic"),
}


@pytest.mark.thirds
@pytest.mark.parametrize("name", WAYS)
def test_wrong_units_and_axes_are_named(tmp_path, estimate, name):
    way, said = WAYS[name]
    rows = [(*row[:3], *way(*row[3:])) for row in mission(30, seed=1)]
    assert said in " ".join(estimate(table(tmp_path / "log.csv", rows))["notes"])


def over_ground(rows):
    """Return rows with course and speed of the ways between the fixes."""
    ground = []
    for row, after in itertools.pairwise(rows):
        east, north = displacement(*row[1:3], *after[1:3])
        course = np.degrees(np.arctan2(east, north)) % 360
        ground.append((*row[:3], course, np.hypot(east, north) / LEG))
    return ground


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


@pytest.mark.parametrize(
    ("body", "count"),
    [
        ("GPRMC,120000.00,A,3642.0000,N,12206.0000,W,0.1,0.0,010526,,,A", 1),
        ("GPRMC,120000.00,A,3642.0000,N,12206.0000,W,0.1,0.0,010526,,,E", 0),
        ("GPRMC,120000.00,A,3642.0000,N,12206.0000,W,0.1,0.0,010526,,,N", 0),
        ("GPRMC,120000.00,A,3642.0000,N,12206.0000,W,0.1,0.0,010526,,,S", 0),
        ("GPRMC,120000.00,A,,,,,0.1,0.0,010526,,,A", 0),
        ("GPRMC,120000,A,3642,N,12206,W,0,0,010526,,", 1),
        ("GPRMC,120000,A", 0),
        ("IIVHW,,T,80.0,M,2.0,N,3.7,K", 0),
    ],
)
def test_sentences_that_are_no_fix_end_nothing(body, count):
    good = checked("GPRMC,130000,A,3642.000,N,12206.000,W,0.0,0.0,010526,,")
    done = ran(sys.executable, EXAMPLE, input=f"{checked(body)}\n{good}\n")
    assert len(done.stdout.splitlines()) == count + 1


def test_a_magnetic_heading_alone_is_told():
    sentences = [
        checked("GPRMC,130000,A,3642.000,N,12206.000,W,0.0,0.0,010526,,"),
        checked("IIVHW,,T,80.0,M,2.0,N,3.7,K"),
    ]
    done = ran(sys.executable, EXAMPLE, input="\n".join(sentences))
    assert "magnetic heading alone" in done.stderr


def test_read_dives_takes_a_log_too(tmp_path):
    dives, skipped = clpt.gliders.read_dives(table(tmp_path / "log.csv", mission(12)))
    assert (len(dives), skipped) == (12, [])


def test_degrees_west_and_south_have_their_sign(tmp_path):
    rows = ["time,lat (deg S),lon (deg W),course,speed"]
    rows += [f"2026-05-01T0{k}:00:00Z,36.7,{122.1 - 0.03 * k},90,1.0" for k in (0, 2)]
    (tmp_path / "log.csv").write_text("\n".join(rows))
    (leg,), _ = clpt.gliders.read_dives(tmp_path / "log.csv", usable=False)
    assert leg.start == (-36.7, -122.1)
