"""Tides that a current is too short, or too sparse, to separate are refused."""

import re

import numpy as np
import pytest
from gridded_currents import gridded_current
from refusals import refuses

from clpt_control import ScenarioError
from clpt_control.currents import fit_current, sample_currents

PLACE = np.linspace(41.0, 41.3, 4)


def fitted(hours, *constituents, period=12.4206012):
    """Fit tides to a wave, the same everywhere, of a period in hours."""
    wave = 0.3 * np.cos(2 * np.pi * hours / period)[:, None, None] * np.ones((4, 4))
    current = gridded_current(wave, wave, PLACE, PLACE, hours)
    one = {"rows": 1, "columns": 1, "radius_km": 1.0}
    return fit_current(current, constituents=constituents, **one)


def test_rayleigh_says_which_and_how_long():
    fitted(np.arange(0.0, 361.0), "M2", "S2")
    fitted(np.arange(0.0, 13.0), "steady", "S2")
    said = (
        "in 11 h, these cannot be distinguished: S2 and K2 (4383 h are needed), M2 and S2 "
        "(354.4 h are needed), M2 and K2 (327.9 h are needed), M2 and steady (12.43 h are needed), "
        "S2 and steady (12 h are needed), K2 and steady (11.97 h are needed)"
    )
    hours = np.arange(0.0, 12.0)
    refuses(f"{re.escape(said)}$", fitted, hours, "M2", "S2", "K2", "steady")
    refuses("M9", fitted, hours, "M2", "M9", error=ScenarioError)


def test_rayleigh_on_a_measured_day(refused, tmp_path):
    sentence = "in 23 h, these cannot be distinguished: M2 and S2 (354.4 h are needed)"  # 24 steps
    fit = ("fit", sample_currents(), "--constituents", "steady,M2,S2")
    assert sentence in refused(*fit, "--out", tmp_path / "s.toml")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("step", [1.0, 3.0, 8.0])
def test_no_tide_above_the_nyquist_frequency(step):
    """A tide of two steps or less is refused, also where steps are left out."""
    rng = np.random.default_rng(1)
    hours = np.arange(0.0, 720.0, step)
    some = np.sort(rng.choice(hours.size, hours.size * 3 // 4, replace=False))
    for name, period in (("M2", 12.42), ("M4", 6.21)):
        for times in (hours, hours[some]):
            if 2 * step > period:
                said = f"see no tide of {2 * step:g} h or faster.*{name}"
                refuses(said, fitted, times, "K1", name)
            else:
                fitted(times, "K1", name)


def test_uneven_steps_see_faster_tides():
    hours = np.sort(np.random.default_rng(1).uniform(0.0, 720.0, 90))
    found = fitted(hours, "steady", "M4", period=6.2103006).report
    assert found["explained_variance"] > 0.9
