"""Columns of a log that mark fixes, and headings that mean none."""

import numpy as np
import pytest
from geodesics import place_from
from made_missions import CURRENT, HEAD, LEG, mission
from refusals import refuses

import clpt_control as clpt

FIXES = mission(8, fix=3.0, seed=3)


def rows(mark, other):
    """Rows each 900 s, reckoned with a wrong current between the fixes, and a mark of each."""
    for fix in FIXES[:-1]:
        for k in range(12):
            along = np.radians(fix[3])
            way = 900.0 * k * np.array([np.sin(along) + 0.1, np.cos(along) - 0.2])
            place = place_from(*fix[1:3], *way) if k else fix[1:3]
            yield fix[0] + 900.0 * k, *place, *fix[3:], other if k else mark
    yield *FIXES[-1], mark


def read(tmp_path, column, mark, other):
    lines = [",".join(map(str, row)) for row in rows(mark, other)]
    path = tmp_path / "log.csv"
    path.write_text("\n".join([f"{HEAD},{column}", *lines]) + "\n")
    legs, skipped = clpt.gliders.read_dives(path, usable=False)
    return legs, [skip.why.split(": ", 1)[1] for skip in skipped]


MARKS = [
    ("fix", 1, 0),
    ("fix", "true", ""),
    ("fix", 3, 1),
    ("gps_valid", "yes", "no"),
    ("dead_reckoning", 0, 1),
    ("Dead Reckoning", "False", "True"),
    ("fix_type", 3, 0),
    ("fix_type", "3D", "no fix"),
    ("fix_quality", 1, 6),
    ("gps_quality", "2.0", "0.0"),
    ("status", "A", "V"),
    ("status.status", 0, -1),
    ("latitude_qc", 1, 8),
    ("POSITION_QC", 2, 4),
    ("lon_quality_control", 1, 9),
    ("qartod_location_test_flag", 1, 4),
    ("sats", 7, 0),
    ("num_satellites", 11, 2),
    ("hdop", 0.9, 99.9),
    ("position_source", "GPS", "INS"),
    ("GPS_STATUS", "OK", "DR"),
    ("status", "fix", "dead reckoning"),
    ("Position QC", "good", "interpolated"),
    ("position_qc", "good", "bad"),
    ("position_qc", "OK", "interpolated"),
    ("position_qc", "probably good", "suspect"),
    ("fix_status", "valid", "questionable"),
    ("gps_status", "usable", "Rejected"),
    ("position_source", "fix", "Dead-Reckoning"),
    ("position_source", "GNSS", "INS"),
    ("status", "GPS", "INS"),
    ("status", "GPS fix", "no fix"),
    ("fix_status", "good", "bad"),
]


@pytest.mark.parametrize(("column", "mark", "other"), MARKS)
def test_a_column_marks_the_fixes(tmp_path, column, mark, other):
    legs, (why,) = read(tmp_path, column, mark, other)
    assert [leg.t_gps2 for leg in legs] == [fix[0] for fix in FIXES[:-1]]
    assert why.startswith(f"positions of 88 rows are no fixes by {column} (")
    drift = np.mean([np.array(leg.miss) / LEG for leg in legs], axis=0)
    assert np.abs(drift - CURRENT).max() < 0.02


def test_a_column_that_is_not_understood_is_told(tmp_path):
    _, whys = read(tmp_path, "status", "diving", "surfaced")
    assert whys[-1] == (
        "column status is not read: 'diving' is not known. Give 1 for a fix and 0 for none in a "
        "column named fix"
    )


def test_columns_of_other_quantities_say_nothing_of_fixes(tmp_path):
    assert "temperature" not in str(read(tmp_path, "temperature_qc", 1, 4))


def test_a_column_without_a_fix_is_refused(tmp_path):
    refuses("hdop marks no position as a fix", read, tmp_path, "hdop", 120, 150)


@pytest.mark.parametrize("none", ["375.4879", "409.5", "400", "540", "-1"])
def test_a_heading_that_means_none_is_a_gap(tmp_path, none):
    path = tmp_path / "log.csv"
    lines = [
        f"{time},{north},{east},{none if k in (3, 6) else course},{speed}"
        for k, (time, north, east, course, speed) in enumerate(FIXES)
    ]
    path.write_text("\n".join([HEAD, *lines]) + "\n")
    legs, skipped = clpt.gliders.read_dives(path, usable=False)
    unknown = [k for k, leg in enumerate(legs) if np.isnan(leg.dr_east)]
    assert unknown == [3, 6]
    assert skipped[0].why.endswith(
        f"2 values of course, {none} degrees, are read as none"
    )


def test_headings_beyond_a_turn_stay(tmp_path):
    """A variation was added: headings of 361 and 365 degrees, each several times."""
    path = tmp_path / "log.csv"
    beyond = (361, 365, 363, 365, 361, 363, 350, 352, 0)
    lines = [
        f"{time},{north},{east},{course},{speed}"
        for (time, north, east, _, speed), course in zip(FIXES, beyond, strict=True)
    ]
    path.write_text("\n".join([HEAD, *lines]) + "\n")
    legs, _ = clpt.gliders.read_dives(path, usable=False)
    assert np.isfinite([leg.dr_east for leg in legs]).all()
