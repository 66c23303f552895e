"""Estimates of theta from fix to fix, against closed forms of the flow and of the filter.

Uniform flow: theta = miss / duration.  Rotation x' = w (-x2, x1) + v: a circle about a centre
that moves.  One function, h and r constant: P_n = 1/(1/P0 + n h^2/r^2), and with a walk Q before
each fix P goes to P^- - (P^-)^2 h^2/(r^2 + P^- h^2), P^- = (Q + (Q^2 + 4 Q r^2/h^2)^(1/2))/2.
"""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, seed, settings
from hypothesis import strategies as st

import clpt_control as clpt
from clpt_control.estimation import fix_to_fix
from clpt_control.estimation import segments as between_fixes
from clpt_control.estimation.fix_to_fix import (
    METHODS,
    batch_least_squares,
    kalman,
    regularised,
    tomography,
)
from clpt_control.estimation.segments import Segments

estimate = clpt.estimation.flow_estimate
PAPER = clpt.paper_scenario()
THETA = np.array(PAPER.flow.parameters)
SAMPLES = 33  # of a track between two fixes; enough for the tolerances here


@pytest.fixture(autouse=True)
def few_samples(monkeypatch):
    monkeypatch.setattr(between_fixes, "SHARES", np.linspace(0.0, 1.0, 2 * SAMPLES - 1))


def place(t, x, u, p):
    """phi = (1, x1, x2), a linear flow: u = x[2], y = phi_x[3]."""
    return [1.0, u[0], u[1]]


LINEAR = clpt.Block(
    "linear", output=place, inputs={"x": 2}, outputs={"phi_x": 3}, parameters={"N": 3}
)


def rotation(w, starts, velocity, duration):
    """Segments of vehicles at constant velocity through a water that turns about 0."""
    n = len(starts)
    fine = np.linspace(0.0, duration, 2 * SAMPLES - 1)
    t = np.tile(fine[::2], (n, 1)) + duration * np.arange(n)[:, None]
    z0, v = starts @ [1, 1j], velocity @ [1, 1j]
    ends = (z0 - 1j * v / w) * np.exp(1j * w * duration) + 1j * v / w
    water = velocity[:, None] * fine[:, None]
    end = np.stack([ends.real, ends.imag], axis=1)
    return Segments(t, water, starts, end)


def turning(random, n=6, w=0.3):
    return rotation(w, random.normal(size=(n, 2)), random.normal(size=(n, 2)), 4.0)


def dive(number, miss, hours=4.0, **more):
    """A dive to the north at 0.25 m/s that misses its end by so much, m east and north."""
    T, north = 3600 * hours, 900.0 * hours
    made = clpt.gliders.make_dive(
        number, (T * number, 0.0, 8.0), (T * (number + 1), 0.0, 8.0), (0.0, north)
    )
    return replace(made, gps_east=miss[0], gps_north=north + miss[1], **more)


@pytest.mark.parametrize("method", METHODS)
def test_a_uniform_flow_is_the_miss_over_the_duration(method):
    dives = [dive(k, (0.2 * 3600 * h, -0.1 * 3600 * h), h) for k, h in enumerate((3, 5, 4), 1)]
    basis, _ = clpt.estimation.dive_basis(dives, width=None)
    found = estimate(dives, method, basis=basis, prior=1e6)
    np.testing.assert_allclose(found.theta, [[0.2], [-0.1]], atol=1e-9)
    np.testing.assert_allclose(found.misses, 0, atol=1e-4)
    np.testing.assert_allclose(found.miss(dives[1]), [0.2 * 18000, -0.1 * 18000], atol=1e-3)
    np.testing.assert_allclose(found.steps[-1], found.theta)


def test_tomography_finds_the_flow_that_bends_the_track():
    segments = turning(np.random.default_rng(2))
    theta = np.array([[0, 0, -0.3], [0, 0.3, 0]])
    start, sd, r = np.zeros((2, 3)), np.ones(3), np.full(6, 1e-5)
    steps, _, _ = tomography(segments, LINEAR, start, sd, r, 0)
    np.testing.assert_allclose(steps[-1], theta, atol=1e-6)
    assert np.abs(steps[0] - theta).max() > 0.1
    bent = batch_least_squares(segments, LINEAR, start, sd, r, 0)[0]
    assert np.abs(bent[-1] - theta).max() > 0.01


def of_one(y, time, noise):
    """Segments of given misses and a uniform flow."""
    n = len(y)
    t = np.linspace(0, 1, SAMPLES) * time + time * np.arange(n)[:, None]
    water = np.zeros((n, 2 * SAMPLES - 1, 2))
    return Segments(t, water, np.zeros((n, 2)), np.asarray(y, float)), np.full(n, noise)


def steady():
    return clpt.estimation.dive_basis([dive(1, (0, 0))], width=None)[0]


def test_the_filter_of_one_function_is_its_closed_form():
    segments, r = of_one(np.random.default_rng(3).normal(size=(50, 2)), 2.0, 0.5)
    steps, P, _ = kalman(segments, steady(), np.zeros((2, 1)), np.array([3.0]), r, np.array([0.0]))
    np.testing.assert_allclose(P, 1 / (1 / 9 + 50 * 4 / 0.25), rtol=1e-9)
    mean = 2 * segments.miss.sum(axis=0) / 0.25 * P[0, 0]
    np.testing.assert_allclose(steps[-1][:, 0], mean, rtol=1e-9)
    walk = np.array([0.2])
    _, P, _ = kalman(segments, steady(), np.zeros((2, 1)), np.array([3.0]), r, walk)
    Q, h = 0.04 * 2.0, 2.0
    ahead = (Q + np.sqrt(Q**2 + 4 * Q * 0.25 / h**2)) / 2
    np.testing.assert_allclose(P, ahead - (ahead * h) ** 2 / (0.25 + ahead * h**2), rtol=1e-9)


@seed(4)
@settings(max_examples=30, deadline=None, database=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 12))
def test_without_a_walk_the_filter_ends_at_least_squares(number, n):
    random = np.random.default_rng(number)
    segments = turning(random, n)._replace(end=random.normal(size=(n, 2)))
    start, sd = random.normal(size=(2, 3)), random.uniform(0.1, 2, 3)
    r = random.uniform(0.05, 1, n)
    batch = batch_least_squares(segments, LINEAR, start, sd, r, 0)
    one = kalman(segments, LINEAR, start, sd, r, np.zeros(3))
    np.testing.assert_allclose(one[0][-1], batch[0][-1], atol=1e-7)
    np.testing.assert_allclose(one[1], batch[1], atol=1e-7)
    h, y = batch[2], segments.miss  # the normal equations, solved another way
    P = np.linalg.inv(np.diag(1 / sd**2) + h.T @ (h / r[:, None] ** 2))
    np.testing.assert_allclose(
        regularised(h / r[:, None], y / r[:, None], start, sd)[1], P, atol=1e-9
    )
    wanted = (start / sd**2 + y.T @ (h / r[:, None] ** 2)) @ P
    np.testing.assert_allclose(batch[0][-1], wanted, atol=1e-7)


@pytest.fixture(scope="module")
def lap():
    """One cycle of the paper's scenario, recorded each 0.2."""
    return clpt.simulate(PAPER.with_values({"run.duration": 200, "run.output_step": 0.2}))


@pytest.mark.parametrize("method", METHODS)
def test_the_papers_flow_is_found_in_one_cycle(lap, method):
    """5 % are asked for; every second waypoint's worth of fixes is enough."""
    fine = estimate(lap, method)
    np.testing.assert_allclose(fine.theta, THETA, rtol=1e-5)
    assert fine.condition_number < 10
    seldom = estimate(lap, method, every=20.0)
    np.testing.assert_allclose(seldom.theta, THETA, rtol=5e-3)
    assert np.all(seldom.standard_deviation > fine.standard_deviation)


def test_tomography_of_a_bent_track_comes_to_the_batch_answer(lap):
    found, batch = estimate(lap, "tomography", every=5.0), estimate(lap, every=5.0)
    np.testing.assert_allclose(found.theta, batch.theta, atol=1e-5)
    assert np.abs(found.steps[0] - THETA).max() > 0.01
    np.testing.assert_allclose(found.misses, batch.misses, atol=1e-5)


def test_the_filter_is_causal(lap):
    early = estimate(lap.isel(time=slice(0, 501)), "kalman")  # to t = 100
    whole = estimate(lap, "kalman")
    np.testing.assert_allclose(whole.steps[: len(early.steps)], early.steps, atol=1e-9)


def test_the_true_parameters_are_not_read(lap):
    other = lap.copy()
    text = other.attrs["scenario"]
    assert "[[1.0, 0.4, 0.8], [0.9, 0.4, 0.8]]" in text
    other.attrs["scenario"] = text.replace(
        "[[1.0, 0.4, 0.8], [0.9, 0.4, 0.8]]", "[[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]"
    )
    np.testing.assert_array_equal(estimate(other).theta, estimate(lap).theta)


def test_a_limited_speed_and_a_modelled_flow_are_known():
    values = {
        "vehicle.max_speed": 1.5,
        "model.parameters": 0.5 * THETA,
        "run.duration": 200,
        "run.output_step": 0.1,
    }
    run = clpt.simulate(PAPER.with_values(values))
    np.testing.assert_allclose(estimate(run, every=5.0).theta, THETA, rtol=1e-3)


def test_an_estimate_feeds_the_known_flow_law(lap):
    found = estimate(lap, "tomography")
    for law in ("learned-flow", "composite-memory", "kalman-flow"):
        base = PAPER.with_values({"learning.law": law, "learning.parameters": None})
        fed = clpt.estimation.known_flow_scenario(base, found.theta)
        assert fed.learning.law == "known-flow"
        assert fed.learning.gain == 0.8
    each = {"parameters": 1.0, "feedback": 0.3, "feedforward": 0.5}
    base = PAPER.with_values({"learning.gain": None, "learning.gains": each})
    assert clpt.estimation.known_flow_scenario(base, THETA).learning.gains.feedback == 0.3
    constant = {"learning.adapt_gains": False, "learning.feedback": [1, 1]}
    base = PAPER.with_values({**constant, "learning.feedforward": [1, 1]})
    assert clpt.estimation.known_flow_scenario(base, THETA).learning.gain is None
    run = clpt.simulate(fed.with_values({"run.duration": 1000}))
    last = run.clpe.sel(time=slice(800, 1000)).values
    assert np.sqrt(np.mean(np.sum(last**2, axis=1))) < 1e-4


def test_a_forecast_does_not_read_the_end_of_its_dive():
    dives = clpt.gliders.sample_dives()[:5]
    basis, prior = clpt.estimation.dive_basis(dives)
    found = estimate(dives[:4], "tomography", basis=basis, prior=prior)
    last = dives[4]
    other = replace(last, gps_east=0.0, gps_north=0.0, lat_gpse=0.0, lon_gpse=0.0)
    np.testing.assert_array_equal(found.miss(other), found.miss(last))
    assert np.linalg.norm(found.miss(last)) > 100
    left = [[d.miss_east, d.miss_north] - found.miss(d) for d in dives[:4]]
    np.testing.assert_allclose(found.misses, left, atol=0.1)  # settled: what the track misses by


def test_a_tide_takes_two_functions():
    basis, prior = clpt.estimation.dive_basis([dive(1, (0, 0))], None, ("steady", "M2"))
    np.testing.assert_array_equal(prior, [0.3, 0.1, 0.1])
    quarter = 12.4206012 * 3600 / 4
    phi = clpt.equations.evaluate(basis, [0.0, quarter], [[0, 0], [1e5, 1e5]])
    np.testing.assert_allclose(phi, [[1, 1, 0], [1, 0, 1]], atol=1e-6)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"method": "guess"}, "method 'guess': must be one of least-squares, kalman, tomography"),
        ({"every": -1.0}, r"every = -1: must be positive, at most the run's length, 200 s"),
        ({"every": 300.0}, "every = 300: must be positive, at most"),
        ({"prior": 0.0}, "prior: must be a positive number, or 3 of them"),
        ({"noise": [1.0, 2.0]}, "noise: must be a positive number, or 100 of them"),
        ({"basis": clpt.paper_blocks(PAPER)[0]}, "reference: is no basis"),
    ],
)
def test_what_is_not_allowed_is_said(lap, change, said):
    with pytest.raises(clpt.ScenarioError, match=said):
        estimate(lap, **change)


def test_runs_that_tell_too_little_are_refused(lap):
    def run(values, **more):
        return clpt.simulate(PAPER.with_values({"run.duration": 200} | values), **more)

    fixes = {"learning": {"law": "fix-regression"}, "localization": {"interval": 5.0}}
    parameters = {"vehicle_controller.alpha_M": THETA}
    for source, said in (
        (lap.drop_attrs(), "carries no scenario"),
        (run({"run.duration": 20}, params=parameters), "parameters given at call time"),
        (lap.sel(time=slice(19.7, 60)), "into 5 samples at least"),
        (run({"run.output_step": 4}), r"to 0\.\d+ m only; run it with a smaller"),
        (run({"run.output_step": 0.7}), "a step that divides that"),
        (run({**fixes, "run.duration": 40}), "steers on its prediction between fixes"),
    ):
        with pytest.raises((clpt.DataError, clpt.ScenarioError), match=said):
            estimate(source)


def test_dives_that_tell_too_little_are_refused():
    basis, one = steady(), [dive(1, (0, 0))]
    for dives, more, said in (
        ([], {"basis": basis}, "no dives are given"),
        (5, {}, r"5: must be an xarray\.Dataset"),
        ("dives", {"basis": basis}, r"an xarray\.Dataset or Sequence.Dive"),
        ([1, 2], {"basis": basis}, r"an xarray\.Dataset or Sequence.Dive"),
        ([dive(1, (0, 0), hours=0.0)], {"basis": basis}, "or has no time"),
        (one, {}, "dives need a basis"),
        ([dive(1, (np.nan, 0))], {"basis": basis}, "is not finite"),
    ):
        with pytest.raises(clpt.ClptError, match=said):
            estimate(dives, **more)
    for more, said in (((-1.0,), "width = -1 m: must be positive"), ((None, ()), "no function")):
        with pytest.raises(clpt.ScenarioError, match=said):
            clpt.estimation.dive_basis(one, *more)


def test_a_tomography_that_does_not_settle_says_so(monkeypatch):
    monkeypatch.setattr(fix_to_fix, "MOST", 10)
    segments = turning(np.random.default_rng(5), 2, w=3.0)  # it turns twice between two fixes
    with pytest.raises(clpt.DataError, match=r"does not settle in 10 iterations|not finite"):
        tomography(segments, LINEAR, np.zeros((2, 3)), np.full(3, 10.0), np.full(2, 1e-3), 0)
