"""Tides against records that are known, and which of them a record can tell apart."""

import re

import numpy as np
import pytest
from tidal_records import KNOWN, LATITUDE, MARACOOS, classical_m2, local, moon, times, waves

from clpt_control.currents.constituents import OTHER_NAMES, nodal_corrections
from clpt_control.currents.fit import fit_scenario
from clpt_control.currents.telling_apart import check_separable
from clpt_control.currents.tidal_constants import tidal_basis
from clpt_control.currents.tidal_fit import fit_tides, predict
from clpt_control.errors import DataError, ScenarioError
from clpt_control.scenario.tidal_periods import SPEEDS, period, speed


def test_speeds_are_those_of_utide():
    utide = pytest.importorskip("utide")
    own = {name: 360 * utide.cycles_per_hour[OTHER_NAMES.get(name, name)] for name in SPEEDS}
    # UTide's SA and S1 follow the sun's perigee, Schureman's the mean year
    for name in SPEEDS:
        assert own[name] == pytest.approx(
            SPEEDS[name], abs=2.1e-6 if name in ("SA", "S1") else 4e-7
        )
    assert speed("steady") == 0
    assert period("steady") == np.inf
    with pytest.raises(ScenarioError, match="unknown constituent 'M9'"):
        speed("M9")


def test_a_fit_of_one_month_holds_in_another_year():
    """Both months made from the classical f, u and Meeus's V, ten years apart."""

    def m2(time):
        s, h, _ = moon(time)
        f, u = classical_m2(time)
        day = (time - time.astype("datetime64[D]")) / np.timedelta64(1, "h")
        angle = np.radians(30 * day + 2 * (h - s) + u)
        return np.array([0.5 * f * np.cos(angle - 1), 0.3 * f * np.cos(angle - 2)])

    here, there = times(30, "2016-03-01"), times(30, "2026-03-01")
    fit = fit_tides(here, *m2(here), LATITUDE, ["M2"])
    tide = fit.constituents[0]
    assert tide.east == pytest.approx(0.5, rel=2e-3)
    assert tide.north_phase == pytest.approx(np.degrees(2), abs=0.2)
    assert np.abs(predict(fit, there) - m2(there)).max() < 0.006
    f = nodal_corrections(["M2"], [here[0], there[0]], LATITUDE)[0]
    assert abs(f[1, 0] / f[0, 0] - 1) > 0.03  # what would be lost without them


@pytest.mark.parametrize("gaps", [False, True])
def test_known_amplitudes_and_phases_are_recovered(gaps):
    time = times(60)
    flow = waves(time)
    if gaps:
        rng = np.random.default_rng(5)
        flow[0, rng.random(len(time)) < 0.2] = np.nan
        flow[1, 200:500] = np.nan
    fit = fit_tides(time, *flow, LATITUDE, list(KNOWN))
    found = local(fit, time[0])
    for name, row in KNOWN.items():  # nodal corrections turn a little in 60 days
        np.testing.assert_allclose(found[name][::2], row[::2], atol=2e-3)
        off = (np.array(found[name])[1::2] - row[1::2] + 180) % 360 - 180
        assert np.abs(off).max() < 1.5
    assert fit.mean == pytest.approx((0.1, -0.05), abs=1e-3)
    assert fit.explained_variance == pytest.approx(1, abs=1e-4)
    kept = np.isfinite(flow).all(axis=0)
    assert fit.samples == kept.sum()
    np.testing.assert_allclose(predict(fit, time)[:, kept], flow[:, kept], atol=5e-3)


def test_the_ellipse_is_that_of_the_components():
    time = times(30)
    fit = fit_tides(time, *waves(time), LATITUDE, ["M2"])
    tide = fit.constituents[0]
    turn = np.linspace(0, 2 * np.pi, 200001)
    u = tide.east * np.cos(turn - np.radians(tide.east_phase))
    v = tide.north * np.cos(turn - np.radians(tide.north_phase))
    size = np.hypot(u, v)
    assert size.max() == pytest.approx(tide.major, rel=1e-8)
    assert size.min() == pytest.approx(abs(tide.minor), rel=1e-4)
    assert tide.minor > 0  # north lags east by 70 degrees: counter-clockwise
    k = size.argmax()
    assert np.degrees(np.arctan2(v[k], u[k])) % 180 == pytest.approx(tide.inclination, abs=0.01)
    assert (np.degrees(turn[k]) - tide.phase + 90) % 180 == pytest.approx(90, abs=0.01)


@pytest.mark.parametrize("red", [0.8, pytest.param(0.0, marks=pytest.mark.slow)])
def test_estimates_lie_within_their_standard_errors(red):
    """Of 60 records with noise, white and red, at least 95 % within three."""
    time = times(15, step=120)
    clean = waves(time, {"M2": KNOWN["M2"]})
    keys = ("east", "north", "major", "minor", "inclination", "phase")
    truth = fit_tides(time, *clean, LATITUDE, ["M2", "K1"]).constituents[0]
    misses = []
    for seed in range(60):
        noise = np.random.default_rng(seed).normal(scale=0.1, size=clean.shape)
        for k in range(1, len(time)):
            noise[:, k] += red * noise[:, k - 1]
        found = fit_tides(time, *(clean + noise), LATITUDE, ["M2", "K1"]).constituents[0]
        misses.append([(getattr(found, k) - getattr(truth, k)) / found.errors[k] for k in keys])
    size = np.abs(misses)
    assert (size < 3).mean(axis=0).min() >= 0.95
    spread = np.sqrt(np.mean(size**2))
    assert (0.5 if red else 0.85) < spread < 1.15  # red noise is not thought quieter than white


def test_theta_of_a_scenario_is_the_fit():
    time = times(30)
    flow = waves(time)
    fit = fit_tides(time, *flow, LATITUDE, list(KNOWN))
    epoch = time[len(time) // 2]
    basis = tidal_basis(fit, epoch, "km h-1")
    assert basis.constituents == ("steady", *(n for n in KNOWN for _ in range(2)))
    hours = (time - epoch) / np.timedelta64(1, "h")
    phi = [
        np.cos(2 * np.pi * hours / period(n) + p) if n != "steady" else np.ones(len(hours))
        for n, p in zip(basis.constituents, basis.phases, strict=True)
    ]
    np.testing.assert_allclose(basis.theta @ phi, 3.6 * flow, atol=3.6 * 4e-3)


def test_utide_chooses_by_itself():
    time = times(30)
    fit = fit_tides(time, *waves(time), LATITUDE, "auto")
    names = [each.name for each in fit.constituents]
    assert set(KNOWN) < set(names)
    assert "K2" not in names
    with pytest.raises(DataError, match="no tide can be told from the mean in 2 h"):
        fit_tides(time[:3], *waves(time)[:, :3], LATITUDE, "auto")


def test_rayleigh_says_which_and_how_long():
    check_separable(["M2", "S2"], 15 * 24.0, "x")
    with pytest.raises(DataError, match=r"in 24 h, these .* M2 and S2 \(354.4 h"):
        fit_tides(times(1), *waves(times(1)), LATITUDE, ["M2", "S2"])
    check_separable(["steady", "S2"], 12.0, "x")
    check_separable(["M2"], 1.0, "x")
    with pytest.raises(DataError) as caught:
        check_separable(["M2", "S2", "K2", "steady"], 11.0, "x.nc")
    assert str(caught.value) == (
        "x.nc: in 11 h, these cannot be told apart: S2 and K2 (4383 h are needed), M2 and S2 "
        "(354.4 h are needed), M2 and K2 (327.9 h are needed), M2 and steady (12.43 h are needed), "
        "S2 and steady (12 h are needed), K2 and steady (11.97 h are needed)"
    )
    with pytest.raises(ScenarioError):
        check_separable(["M2", "M9"], 24.0, "x")


def test_rayleigh_on_a_measured_day(printed, refused, tmp_path):
    sentence = "in 23 h, these cannot be told apart: M2 and S2 (354.4 h are needed)"  # 24 steps
    with pytest.raises(DataError, match=re.escape(sentence)):
        fit_scenario(MARACOOS, (40.9, 41.55, -69.9, -69.0), constituents=("steady", "M2", "S2"))
    arguments = ("--constituents", "steady,M2,S2", "--out", tmp_path / "s.toml")
    assert sentence in refused("fit", MARACOOS, *arguments)
    assert list(tmp_path.iterdir()) == []
    at = ("--at", 41.2, -69.5, "--constituents")
    assert sentence in refused("tides", MARACOOS, *at, "M2,S2")
    tide = printed("tides", MARACOOS, *at, "M2")["constituents"]["M2"]
    assert 0.5 < tide["major"] < 1.1  # strong and clockwise on the shoals
    assert tide["minor"] < 0
    for mistake, what in (((50, -69.5), "latitude 50 lies outside"), ((41.2, 10), "longitude 10")):
        assert what in refused("tides", MARACOOS, "--at", *mistake, "--constituents", "M2")
