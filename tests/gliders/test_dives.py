"""Readers of dives: measured files, the fourteen dives of SG542, and round trips."""

import csv
from dataclasses import fields
from math import hypot, nan

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from clpt_control.gliders.dive_files import read_dive_file, read_dives, sample_dives
from clpt_control.gliders.dive_table import OPTIONAL, write_dive_table
from clpt_control.gliders.dives import make_dive

TABLE = [field.name for field in fields(make_dive(1, (0, 0, 0), (1, 0, 0), (0, 0)))]
TABLE = [name for name in TABLE if name not in ("track", "notes", "vehicle", "kind")]
SETTINGS = settings(
    max_examples=50, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


@pytest.fixture(scope="module")
def folder(facts):
    return facts / "glider" / "basestation"


@pytest.fixture(scope="module")
def dives(folder):
    found, skipped = read_dives(folder)
    assert not skipped
    return found


@pytest.fixture(scope="module")
def rows(facts):
    with (facts / "glider" / "sg542_2016_dives.csv").open() as file:
        return {int(row["dive"]): row for row in csv.DictReader(file)}


PLANNED = {"next_course"}  # whole files alone hold the plan of the next dive


def same_table(ones, others, tolerance=1e-6):
    assert [dive.number for dive in ones] == [dive.number for dive in others]
    for one, other in zip(ones, others, strict=True):
        for name in sorted(set(TABLE) - PLANNED):
            a, b = getattr(one, name), getattr(other, name)
            assert (a is None) == (b is None), name
            assert a is None or a == pytest.approx(b, abs=tolerance, rel=0, nan_ok=True), name


def test_the_files_give_the_table(dives, rows):
    assert [dive.number for dive in dives] == list(range(304, 310))
    assert set(rows) == set(range(304, 318))
    for dive in dives:
        row = rows[dive.number]
        for name in ("lat_gps1", "lon_gps1", "lat_gps2", "lon_gps2", "lat_gpse", "lon_gpse"):
            assert getattr(dive, name) == pytest.approx(float(row[name]), abs=1e-8)
        for name in ("t_gps1", "t_gps2", "t_gpse", "magvar", "dac_qc"):
            assert getattr(dive, name) == float(row[name])
        for name in ("gps_east", "gps_north", "dr_east", "dr_north"):
            assert getattr(dive, name) == pytest.approx(float(row[f"{name}_m"]), abs=1e-3)
        for name in ("dac_east", "dac_north"):
            assert getattr(dive, name) == pytest.approx(float(row[name]), abs=1e-9)


def error_of(dives):
    """Return how far miss over duration is from each file's depth-averaged current, m/s."""
    return [
        hypot(
            dive.miss_east / dive.duration - dive.dac_east,
            dive.miss_north / dive.duration - dive.dac_north,
        )
        for dive in dives
    ]


def test_miss_over_duration_is_the_current_of_the_file(dives, facts):
    assert max(error_of(dives)) < 1e-3
    rows = read_dives(facts / "glider" / "sg542_2016_dives.csv")[0]
    assert len(rows) == 14
    assert np.median(error_of(rows)) < 0.5e-3
    assert max(error_of(rows)) < 1e-3


def test_tracks_run_from_fix_to_fix(dives):
    for dive in dives:
        time, east, north = dive.track
        assert (time[0], time[-1]) == (0, dive.duration)
        assert np.all(np.diff(time) > 0)
        assert (east[0], north[0]) == (0, 0)
        assert (east[-1], north[-1]) == pytest.approx((dive.dr_east, dive.dr_north), abs=1e-6)


def test_the_shipped_table_is_that_of_the_files(dives):
    same_table(sample_dives()[:6], dives, 1e-11)  # the sums of the drawn files, to rounding


@pytest.mark.slow
def test_the_shipped_table_is_that_of_the_whole_files(shared):
    same_table(sample_dives(), read_dives(shared / "glider" / "basestation")[0], 0)


@pytest.mark.slow
def test_the_facts_are_those_of_the_whole_files(facts, shared):
    for vehicle, count in (("basestation", 14), ("sg171", 10)):
        drawn, whole = (read_dives(root / "glider" / vehicle)[0] for root in (facts, shared))
        assert len(whole) == count
        same_table(drawn, whole[: len(drawn)], 1e-11)
        for few, many in zip(drawn, whole, strict=False):
            for axis in (1, 2):
                at = np.interp(few.track[0], many.track[0], many.track[axis])
                np.testing.assert_allclose(few.track[axis], at, rtol=0, atol=1e-9)


number = st.floats(-1e12, 1e12)
optional = st.one_of(st.none(), number)


@SETTINGS
@given(
    st.lists(
        st.builds(
            make_dive,
            st.integers(-10, 10**9),
            st.tuples(number, st.floats(-90, 90), st.floats(-360, 360)),
            st.tuples(number, st.floats(-90, 90), st.floats(-360, 360)),
            st.tuples(st.one_of(number, st.just(nan)), number),
            **dict.fromkeys(OPTIONAL, optional),
        ),
        max_size=4,
    )
)
def test_csv_round_trip(tmp_path, dives):
    write_dive_table(dives, tmp_path / "dives.csv", "a comment\nof two lines")
    back, skipped = read_dive_file(tmp_path / "dives.csv")
    assert not skipped
    assert repr([*map(vars, back)]) == repr([*map(vars, dives)])  # bit for bit, NaN too


def test_required_columns_suffice(tmp_path):
    text = "dr_north_m,dive,t_gps2,lat_gps2,lon_gps2,t_gpse,lat_gpse,lon_gpse,dr_east_m,extra\n"
    (tmp_path / "mine.csv").write_text(text + "5,1,0,-43,8,9000,-43,8.1,8000,word\n")
    (dive,), _ = read_dives([tmp_path])
    assert (dive.dr_east, dive.dr_north, dive.magvar, dive.track) == (8000, 5, None, None)
    assert (dive.gps_east, dive.duration) == (pytest.approx(8154, abs=1), 9000)
