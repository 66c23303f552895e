"""Seas whose scatter lasts longer than a leg: standard errors and forecasts."""

import numpy as np
import pytest
from geodesics import place_from
from small_scenarios import uniform_flow

import clpt_control as clpt

SPAN, SCATTER, FIX = 600.0, 0.02, 5.0  # s, m/s, m


def fixes_of(draw, drifts):
    """Yield fixes in degrees, and the ways to the next fix, of a vehicle of 1 m/s."""
    place = (0.0, 0.0)
    for number, drift in enumerate(drifts):
        course = 2.4 * (number // 18)
        way = SPAN * np.array([np.sin(course), np.cos(course)])
        yield place_from(*place, *draw.normal(0, FIX, 2)), way
        place = place_from(*place, *(way + SPAN * drift))


def learned(drifts, draw, **settings):
    """Return the estimator, and errors and radii of its forecasts."""
    estimator, time, forecasts = (
        clpt.currents.FlowEstimator(uniform_flow(**settings)),
        1.7e9,
        [],
    )
    for fix, way in fixes_of(draw, drifts):
        result = estimator.fix(time, *fix)
        if result.forecast is not None:
            forecasts.append((result.error, result.forecast.radius))
        time += SPAN
        estimator.move(time, *way)
    return estimator, np.array(forecasts)


def test_standard_errors_hold_a_scatter_that_lasts_three_hours():
    """As good as the mean of the drift, which knows it to the scatter's own mean."""
    theta, inside, off, means = np.array([0.15, -0.1]), [], [], []
    for seed in range(2):
        draw, x, drifts = np.random.default_rng(seed), np.zeros(2), []
        q = np.exp(-SPAN / 10800)
        x = SCATTER * draw.normal(size=2)
        for _ in range(49):
            drifts.append(theta + x)
            x = q * x + SCATTER * np.sqrt(1 - q**2) * draw.normal(size=2)
        estimator, forecasts = learned(drifts, draw)
        error = estimator.flow_parameters[:, 0] - theta
        inside += (np.abs(error) <= 1.645 * estimator.standard_error).tolist()
        off.append(error)
        means.append(np.mean(drifts[:-1], axis=0) - theta)
        assert np.mean(forecasts[:, 0] <= forecasts[:, 1]) >= 0.85
    assert sum(inside) >= 3
    assert np.linalg.norm(off) < 1.1 * np.linalg.norm(means)


def test_a_drift_that_the_functions_cannot_take_is_forecast():
    """A steady drift of 60 m a leg, and a prior that keeps theta at 0."""
    drifts = np.tile([0.1, 0.0], (61, 1))
    estimator, forecasts = learned(drifts, np.random.default_rng(3), prior=1e-6)
    assert np.abs(estimator.flow_parameters).max() < 1e-4
    errors, radii = forecasts[20:].T
    # the fixes of both ends have 5 m on an axis
    assert np.sqrt(np.mean(errors**2)) < 12
    assert np.mean(errors <= radii) >= 0.85


def test_the_state_of_a_scatter_that_lasts_is_saved_to_the_last_bit(tmp_path):
    draw = np.random.default_rng(5)
    drifts = 0.1 + np.cumsum(draw.normal(0, 0.005, (20, 2)), axis=0)
    estimator, _ = learned(drifts, draw)
    estimator.save(tmp_path / "state")
    loaded = clpt.currents.FlowEstimator.load(tmp_path / "state")
    time, plan = estimator.time, [(estimator.time + SPAN, 600.0, 0.0)]
    assert loaded.forecast(plan) == estimator.forecast(plan)
    after = [one.fix(time, 0.03, 0.02) for one in (loaded, estimator)]
    np.testing.assert_array_equal(after[0].standard_error, after[1].standard_error)


def test_a_forecast_at_a_fix_is_the_fix():
    """Its region holds two errors of a fix (25 m): at most 90 % of a heavy-tailed pair."""
    draw = np.random.default_rng(5)
    estimator, _ = learned(np.tile([0.1, 0.0], (12, 1)), draw)
    before = estimator.forecast([])
    estimator.fix(1.7e9 + 12 * SPAN, before.latitude, before.longitude)
    ahead = estimator.forecast([])
    assert ahead[1:3] == pytest.approx((before.latitude, before.longitude), abs=1e-4)
    assert 5.0 < ahead.radius < 200.0
