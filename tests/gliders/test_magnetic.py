"""Magnetic variation against the values of IGRF's own Fortran program."""

import calendar
import sys

import numpy as np
import pytest

from clpt_control.errors import DataError
from clpt_control.gliders.magnetic import variation

# D, degrees, of `igrf13syn` (British Geological Survey) at geodetic places: latitude,
# longitude, year, D; the places are within 1.1 km of sea level, which is 0.01 degrees
PUBLISHED = [
    (59.9, -109.9, 1957.5, 27.33),
    (59.9, -109.9, 1987.5, 22.68),
    (59.9, -109.9, 2004.5, 17.29),
    (59.9, -109.9, 2010.5, 15.20),
    (59.9, 39.9, 1900.5, 5.55),
    (59.9, 39.9, 1902.5, 5.68),
    (-59.9, -39.9, 1987.5, -1.45),
    (-59.9, -39.9, 2004.5, -1.16),
]


def seconds(year):
    """Seconds since 1970 of a year with a fraction."""
    whole = int(year)
    days = 366 if calendar.isleap(whole) else 365
    return calendar.timegm((whole, 1, 1, 0, 0, 0)) + (year - whole) * days * 86400.0


@pytest.mark.parametrize(("lat", "lon", "year", "expected"), PUBLISHED)
def test_variation_is_that_of_the_makers_of_the_field(lat, lon, year, expected):
    assert variation(seconds(year), lat, lon)[0] == pytest.approx(expected, abs=0.02)


def test_many_at_once_are_each_by_itself_and_continuous_over_an_epoch():
    times = np.array([seconds(2009.9), seconds(2010.1), seconds(2024.5), seconds(2029.9)])
    lats, lons = np.array([60.0, 60.0, -43.0, 10.0]), np.array([5.0, 5.0, 8.0, 359.0])
    together = variation(times, lats, lons)
    alone = [float(variation(*one)[0]) for one in zip(times, lats, lons, strict=True)]
    assert together == pytest.approx(alone, abs=1e-9)
    assert abs(together[1] - together[0]) < 0.1
    edge = seconds(2010.0)
    before, after = variation(np.array([edge - 60.0, edge + 60.0]), 60.0, 5.0)
    assert before == pytest.approx(after, abs=1e-4)
    assert variation(edge, 10.0, -1.0) == pytest.approx(variation(edge, 10.0, 359.0))


def test_where_the_field_does_not_reach_there_is_no_number(capsys):
    assert np.isnan(variation(np.array([seconds(2031.0), np.nan]), 60.0, 5.0)).all()
    assert np.isnan(variation(seconds(2020.0), np.nan, 5.0)).all()
    assert np.isfinite(variation(seconds(2020.0), 90.0, 5.0)).all()
    assert capsys.readouterr().out == ""


def test_without_ppigrf_it_says_what_to_install(clpt, monkeypatch):
    monkeypatch.setitem(sys.modules, "ppigrf", None)
    with pytest.raises(DataError, match=r"pip install 'clpt-control\[sea\]'"):
        variation(1.0e9, 60.0, 5.0)
    assert clpt("replay", "--sample").status == 0
