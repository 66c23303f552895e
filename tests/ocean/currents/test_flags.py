"""Quality flags of gridded currents: flagged values count as gaps, and are noted.

The current is 0.1 + 0.4 cos(w t - 1) m/s to the east, w that of M2, everywhere; nine of seventy
cells are wrong.
"""

import numpy as np
import pytest
from gridded_currents import gridded_current
from refusals import refuses

from clpt_control.currents import fit_current, read_currents

M2 = 2 * np.pi / 12.4206012  # rad/h
HOURS, LAT, LON = np.arange(49.0), np.linspace(41, 41.6, 7), np.linspace(-70, -69.1, 10)
GRID = ("time", "lat", "lon")
WRONG = np.zeros((49, 7, 10), bool)
WRONG[:, 2:5, 3:6] = True
NOTE = "441 of 3430 values of u are flagged bad: left out"


def tide(hours):
    return 0.1 + 0.4 * np.cos(M2 * hours - 1), 0.2 * np.cos(M2 * hours - 2)


def current(fault=1.0):
    """Return the current; in the wrong cells it has a fault, m/s, that changes in time."""
    u, v = (np.tile(w[:, None, None], (1, 7, 10)) for w in tide(HOURS))
    u[WRONG] += np.tile(fault * (1 + np.sin(HOURS))[:, None], (1, 9)).ravel()
    return gridded_current(u, v, LAT, LON, HOURS, since="2019-03-01")


def flag(good, bad, **attributes):
    return GRID, np.where(WRONG, bad, good), attributes


MASKS = np.array([1, 2, 4], "i2")
SPELLED = {
    "by name": ({"u_qc": flag(1, 4)}, {}),
    "in capitals": ({"U_QC": flag(0, 3)}, {}),
    "IMOS": ({"u_quality_control": flag(b"1", b"9")}, {}),
    "qc first": ({"qc_u": flag(1, 4)}, {}),
    "of the cells": ({"u_flag": (GRID[1:], np.where(WRONG[0], 4, 1))}, {}),
    "words": (
        {"q": flag(1, 0, flag_values=np.array([0, 1]), flag_meanings="bad good")},
        {"ancillary_variables": "error q"},
    ),
    "two of them": (
        {
            "first_qc": flag(1, 1),
            "second_qc": flag(1, 7, flag_values="1b, 7b", flag_meanings="pass suspect"),
        },
        {"ancillary_variables": "first_qc second_qc"},
    ),
    "standard name": (
        {"q": flag(1, 4, standard_name="eastward_sea_water_velocity status_flag")},
        {"standard_name": "eastward_sea_water_velocity"},
    ),
    "masks": (
        {"u_qc": flag(1, 5, flag_masks=MASKS, flag_meanings="checked estimated fail")},
        {},
    ),
    "letters": (
        {"u_qc": flag(b"G", b"B", flag_values="G B", flag_meanings="good bad")},
        {},
    ),
}


@pytest.mark.parametrize("spelling", SPELLED)
def test_flagged_values_are_gaps_however_flags_are_spelled(tmp_path, spelling):
    flags, attributes = SPELLED[spelling]
    data = current().assign(error=(GRID, np.full(WRONG.shape, 4.0)))
    data = data.assign(flags)
    data.u.attrs |= attributes
    gaps = current()
    gaps["u"] = gaps.u.where(~WRONG)
    wanted = fit_current(gaps).report
    data.to_netcdf(tmp_path / "flagged.nc")
    for source in (data, tmp_path / "flagged.nc"):
        report = fit_current(source).report
        assert report["notes"] == [NOTE]
        assert report["samples"] == 49 * 61
        np.testing.assert_allclose(report["theta"], wanted["theta"])


GOOD = {
    "no quality control": flag(0, 0),
    "changed, interpolated": flag(5, 8),
    "words that say good": flag(
        1, 4, flag_values=np.array([1, 4]), flag_meanings="passed_spike_test good"
    ),
    "another scale": flag(100, 4 + 96),
    "not suspect": flag(
        1, 3, flag_values=np.array([1, 3]), flag_meanings="ok not_suspect"
    ),
}


@pytest.mark.parametrize("flags", GOOD.values(), ids=GOOD)
def test_values_that_are_not_bad_stay(flags):
    found = read_currents(current(0.01).assign(u_qc=flags))
    assert found.measured.all()
    assert found.notes == ()


def test_a_flagged_time_or_latitude_is_a_gap_of_both_components():
    times, rows = np.where(HOURS % 10 == 3, 4, 1), np.where(LAT > 41.55, 4, 1)
    data = current(0.0).assign(time_qc=("time", times), lat_qc=("lat", rows))
    found = read_currents(data)
    assert not found.measured[times == 4].any()
    assert not found.measured[:, rows == 4].any()
    assert found.measured.sum() == 44 * 60
    assert [note[:13] for note in found.notes] == ["790 of 3430 v", "790 of 3430 v"]


def test_a_current_that_is_flagged_everywhere_is_refused_with_the_count():
    data = current().assign(u_qc=(GRID, np.full(WRONG.shape, 4)))
    refuses(
        "no finite value .*; 3430 of 3430 values of u are flagged", read_currents, data
    )


@pytest.mark.long
def test_flags_of_many_files_are_counted_together(tmp_path):
    data = current().assign(u_qc=flag(1, 4))
    for k in range(49):  # each with a scalar time
        data.isel(time=k).to_netcdf(tmp_path / f"{k:02d}.nc")
    assert fit_current(tmp_path).report["notes"] == [NOTE]


def test_flags_of_a_zarr_folder_are_read(tmp_path):
    pytest.importorskip("zarr")
    current().assign(u_qc=flag(1, 4)).to_zarr(tmp_path / "c.zarr", consolidated=False)
    report = fit_current(tmp_path / "c.zarr").report
    assert (report["notes"], report["samples"]) == ([NOTE], 49 * 61)
