"""Cells of logs that mean "none", times, encodings, and columns that mean something else."""

import itertools
from datetime import UTC, datetime

import numpy as np
import pytest
from geodesics import place_from
from made_missions import BEGIN, CURRENT
from refusals import refuses

from clpt_control.gliders import read_dives

STEP, ROWS_OF_LEG = 3600.0, 3
STEERED = "time,latitude,longitude,course,speed"
RECKONED = "time,latitude,longitude,dr_east_m,dr_north_m"


def rows_of(legs=12, place=(36.7, -122.1)):
    """Time, fix or none, course, speed and displacement since the row before, of exact fixes."""
    rows, moved, course = [], (0.0, 0.0), 17.0
    for k in range(legs * ROWS_OF_LEG + 1):
        fix = place if k % ROWS_OF_LEG == 0 else ("", "")
        course += 75.0 * (k % ROWS_OF_LEG == 0)
        rows.append((BEGIN + STEP * k, *fix, course % 360, 1.0, *moved))
        angle = np.radians(course)
        moved = tuple(STEP * np.array([np.sin(angle), np.cos(angle)]))
        place = place_from(*place, *(moved + STEP * np.array(CURRENT)))
    return rows


ROWS = rows_of()


def text_of(head, cells, mark=","):
    return "\n".join([head, *(mark.join(map(str, cells(row))) for row in ROWS)])


def currents_of(tmp_path, text, encoding="utf-8"):
    """The current of each leg of a known way, m/s, and what is said."""
    (tmp_path / "log.csv").write_text(text, encoding=encoding)
    legs, skipped = read_dives(tmp_path / "log.csv", usable=False)
    currents = [leg.miss / leg.duration for leg in legs if np.isfinite(leg.dr_east)]
    return np.array(currents), [skip.why for skip in skipped]


def check(tmp_path, text, legs=12, encoding="utf-8"):
    currents, said = currents_of(tmp_path, text, encoding)
    assert len(currents) == legs
    np.testing.assert_allclose(currents, np.tile(CURRENT, (legs, 1)), atol=1e-3)
    return said


# --- none -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("column", "none"),
    [
        *itertools.product([3, 5], ["NA", "null", "N/A", "--", "None", "-999"]),
        *itertools.product([4, 6], ["-9999.0", "9.96921e36", "1e20"]),
        (3, "511"),
        (4, "102.3"),
    ],
)
def test_a_cell_that_means_none_costs_its_leg(tmp_path, column, none):
    def cells(row):
        cells = [*row]
        if row is ROWS[4]:
            cells[column] = none
        return cells[:5] if column < 5 else (*cells[:3], *cells[5:])

    check(tmp_path, text_of(STEERED if column < 5 else RECKONED, cells), legs=11)


def test_numbers_that_mean_none_have_the_unit_of_their_column(tmp_path):
    """102.3 kn is none, 102.3 cm/s is a speed; places of 91 and 181 degrees are none."""

    def cells(size, odd=None):
        return lambda row: (
            row[0],
            *(
                part if row[1] else none
                for part, none in zip(row[1:3], (91, 181), strict=True)
            ),
            row[3],
            odd if odd and row is ROWS[4] else row[4] * size,
        )

    knots = STEERED + " (kn)"
    check(tmp_path, text_of(knots, cells(3600 / 1852, "102.3")), legs=11)
    text = text_of(STEERED + " (cm/s)", cells(102.3))
    expected, _ = currents_of(tmp_path, text_of(STEERED, cells(1.023)))
    np.testing.assert_allclose(currents_of(tmp_path, text)[0], expected, atol=1e-9)


@pytest.mark.parametrize("name", ["course", "speed", "latitude"])
def test_a_column_without_any_value_is_named(tmp_path, name):
    def cells(row):
        named = dict(zip(STEERED.split(","), row, strict=False))
        return (named | {name: "511" if name == "course" else "N/A"}).values()

    (tmp_path / "log.csv").write_text(text_of(STEERED, cells))
    refuses(f"each value of {name} is empty or means none", read_dives, tmp_path)


def test_a_course_of_360_is_none_in_ais_alone(tmp_path):
    """In the log of a ship that has AIS; elsewhere north, which is said."""

    def cells(row):
        return (*row[:3], "360.0" if row is ROWS[4] else row[3], row[4])

    text = text_of(STEERED, cells)
    currents, said = currents_of(tmp_path, text)
    assert np.isfinite(currents).all()
    assert len(currents) == 12
    assert said == [
        f"{tmp_path / 'log.csv'}: 1 courses of 360 degrees are read as north"
    ]
    ais = text.replace("\n", "\n7,").replace("time", "MMSI,time", 1)
    (said,) = check(tmp_path, ais, legs=11)
    assert "read as none" in said


# --- times and texts ------------------------------------------------------------------------------


def dated(date, time, name="time"):
    def cells(row):
        moment = datetime.fromtimestamp(row[0], UTC)
        return moment.strftime(date), moment.strftime(time), *row[1:5]

    return text_of(STEERED.replace("time", f"Date,{name}"), cells)


@pytest.mark.parametrize(
    ("date", "time"),
    [
        ("%Y-%m-%d", "%H:%M:%S"),
        ("%Y%m%d", "%H%M%S"),
        ("%Y/%m/%d", "%H:%M"),
        ("%Y-%m-%d", "%H:%M:%S UTC"),
        ("%Y-%m-%d", "%Y-%m-%dT%H:%M:%SZ"),
        ("%d/%m/%Y", "%Y-%m-%d %H:%M:%S"),
    ],
)
def test_date_and_time_are_joined(tmp_path, date, time):
    assert check(tmp_path, dated(date, time)) == []


@pytest.mark.parametrize("date", ["%d/%m/%Y", "%m/%d/%Y", "%d.%m.%Y", "%d%m%y"])
def test_a_date_without_a_known_order_is_refused(tmp_path, date):
    (tmp_path / "log.csv").write_text(dated(date, "%H:%M:%S"))
    refuses("must be seconds since 1970 UTC, or a date", read_dives, tmp_path)


def test_a_date_alone_is_refused(tmp_path):
    def cells(row):
        return f"{datetime.fromtimestamp(row[0], UTC):%Y-%m-%d}", *row[1:5]

    lines = text_of(STEERED.replace("time", "date"), cells).splitlines()
    fixes = [line for line in lines if ",," not in line]
    (tmp_path / "log.csv").write_text("\n".join(fixes))
    refuses("fixes at the time of another are left out", read_dives, tmp_path)


def test_times_with_utc_behind(tmp_path):
    def cells(row):
        return f"{datetime.fromtimestamp(row[0], UTC):%Y-%m-%d %H:%M:%S UTC}", *row[1:5]

    check(tmp_path, text_of(STEERED, cells))


def seconds(letters, marks):
    """Degrees, minutes and seconds to 0.1 mm."""

    def text(angle):
        if angle == "":
            return ""
        whole, rest = divmod(abs(angle) * 60, 1)
        degree, minute = divmod(int(whole), 60)
        part = f"{degree}{marks[0]}{minute:02d}{marks[1]}{60 * rest:.6f}{marks[2:]}"
        return letters[angle < 0].format(part)

    return text


@pytest.mark.parametrize("encoding", ["utf-8", "latin-1", "utf-16"])
@pytest.mark.parametrize(
    ("north", "east", "marks"),
    [
        (("{}N", "{}S"), ("{}E", "{}W"), "°'\""),
        (("N{}", "S{}"), ("E{}", "W{}"), "d' "),
        (("{}", "-{}"), ("{}", "-{}"), "::"),
    ],
)
def test_degrees_minutes_and_seconds(tmp_path, north, east, marks, encoding):
    def cells(row):
        angles = seconds(north, marks)(row[1]), seconds(east, marks)(row[2])
        return (row[0], *angles, *row[3:5])

    check(tmp_path, text_of(STEERED, cells), encoding=encoding)


def test_the_first_line_of_a_spreadsheet(tmp_path):
    text = text_of(STEERED.replace(",", ";"), lambda row: row[:5], ";")
    check(tmp_path, f"sep=;\n{text}")
    check(tmp_path, "sep=;\n" + text.replace(".", ","))


# --- columns that mean something else -------------------------------------------------------------


def since_fix(row):
    """Displacement since the last fix in place of the row before."""
    k = ROWS.index(row)
    begin = (k - 1) // ROWS_OF_LEG * ROWS_OF_LEG + 1
    return (*row[:3], *np.sum([r[5:] for r in ROWS[max(begin, 0) : k + 1]], axis=0))


def of_row(by, columns):
    def cells(row):
        other = ROWS[min(max(ROWS.index(row) + by, 0), len(ROWS) - 1)]
        return (*row[:3], *other[columns])

    return cells


@pytest.mark.parametrize(
    ("head", "cells", "said"),
    [
        (STEERED, of_row(-1, slice(3, 5)), "row before. Move it up by one row"),
        (STEERED, of_row(1, slice(3, 5)), "row behind. Move it down by one row"),
        (RECKONED, of_row(-1, slice(5, 7)), "row before. Move it up by one row"),
        (RECKONED, since_fix, "displacements look like those since the last fix"),
    ],
)
def test_motion_of_other_rows_is_named(tmp_path, head, cells, said):
    (tmp_path / "log.csv").write_text(text_of(head, cells))
    refuses(said, read_dives, tmp_path)


def test_motion_of_the_own_row_is_read(tmp_path):
    check(tmp_path, text_of(STEERED, lambda row: row[:5]))
    check(tmp_path, text_of(RECKONED, lambda row: (*row[:3], *row[5:])))


# --- radians --------------------------------------------------------------------------------------


def in_radians(row):
    return (*row[:3], f"{np.radians(row[3]):.4f}", row[4])


def test_courses_in_radians_say_so_in_their_column(tmp_path):
    text = text_of(STEERED, in_radians)
    (tmp_path / "log.csv").write_text(text)
    said = r"course has only numbers within 2 pi.* Name the column course \(rad\)"
    refuses(said, read_dives, tmp_path / "log.csv")
    check(tmp_path, text.replace("course", "course (rad)"))


def test_a_turn_rounded_up_in_radians_is_north(tmp_path):
    texts = [
        text_of(head, lambda row, north=north: (*row[:3], north, row[4]))
        for head, north in (
            (STEERED.replace("course", "course (rad)"), 6.2832),
            (STEERED, 0),
        )
    ]
    rounded, exact = (currents_of(tmp_path, text) for text in texts)
    assert len(rounded[0]) == 12
    np.testing.assert_allclose(rounded[0], exact[0], atol=1e-4)
    assert not any("read as none" in why for why in rounded[1])


def test_a_course_of_102_degrees_does_not_make_360_none(tmp_path):
    """102.3 is a speed that means none in AIS; as a course it is one."""

    def cells(row):
        course = {ROWS[1]: "102.3", ROWS[4]: "360"}.get(row, row[3])
        return (*row[:3], course, row[4])

    _, said = currents_of(tmp_path, text_of(STEERED, cells))
    assert any("1 courses of 360 degrees are read as north" in why for why in said)
