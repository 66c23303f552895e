"""Tides that a record is too short, or too sparse, to separate are refused."""

import numpy as np
import pytest
from gridded_currents import gridded_current
from refusals import refuses

from clpt_control import ScenarioError
from clpt_control.currents import fit_current, sample_currents
from clpt_control.paper.currents.identifiability import check_separable, nyquist


def test_rayleigh_says_which_and_how_long():
    check_separable(["M2", "S2"], 15 * 24.0, "x")
    check_separable(["steady", "S2"], 12.0, "x")
    check_separable(["M2"], 1.0, "x")
    assert refuses(
        "x.nc: ", check_separable, ["M2", "S2", "K2", "steady"], 11.0, "x.nc"
    ) == (
        "x.nc: in 11 h, these cannot be distinguished: S2 and K2 (4383 h are needed), M2 and S2 "
        "(354.4 h are needed), M2 and K2 (327.9 h are needed), M2 and steady (12.43 h are needed), "
        "S2 and steady (12 h are needed), K2 and steady (11.97 h are needed)"
    )
    refuses("M9", check_separable, ["M2", "M9"], 24.0, "x", error=ScenarioError)


def test_rayleigh_on_a_measured_day(refused, tmp_path):
    sentence = "in 23 h, these cannot be distinguished: M2 and S2 (354.4 h are needed)"  # 24 steps
    fit = ("fit", sample_currents(), "--constituents", "steady,M2,S2")
    assert sentence in refused(*fit, "--out", tmp_path / "s.toml")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("step", [1.0, 3.0, 8.0])
def test_the_nyquist_frequency_of_even_steps_with_gaps(step):
    rng = np.random.default_rng(1)
    hours = np.arange(0.0, 720.0, step)
    kept = np.sort(rng.choice(hours.size, hours.size * 3 // 4, replace=False))
    assert nyquist(hours) == nyquist(hours[kept]) == pytest.approx(0.5 / step)
    assert nyquist(np.sort(rng.uniform(0, 100, 50))) == np.inf


def test_a_fit_of_a_grid_refuses_a_tide_that_its_steps_miss(tmp_path):
    hours, place = np.arange(0.0, 240.0, 8.0), np.linspace(41.0, 41.3, 4)
    wave = 0.3 * np.cos(2 * np.pi * hours / 12.42)[:, None, None] * np.ones((4, 4))
    gridded_current(wave, wave, place, place, hours).to_netcdf(tmp_path / "slow.nc")
    said, slow = "steps of 8 h see no tide of 16 h or faster", tmp_path / "slow.nc"
    refuses(said, fit_current, slow, rows=1, columns=1, radius_km=1.0)
