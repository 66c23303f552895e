"""Estimates of theta from fixes of a run, against closed forms of the flow and of the filter.

Uniform flow: theta = error / duration.  Vehicles on straight tracks through a linear flow: h is a
polynomial.  One function, h and r constant: P_n = 1/(1/P0 + n h^2/r^2).
"""

import numpy as np
import pytest
from hypothesis import given, seed, settings
from hypothesis import strategies as st
from refusals import refuses

import clpt_control as clpt
from clpt_control.ocean.estimation.between_fixes import (
    METHODS,
    Segments,
    batch_least_squares,
    kalman,
    run_segments,
)

estimate = clpt.currents.flow_estimate
PAPER = clpt.paper_scenario()
THETA = np.array(PAPER.flow.parameters)
FINE = {"run.duration": 200, "run.output_step": 0.1}
SAMPLES = 33  # of a track between two fixes; enough for the tolerances here


LINEAR = clpt.Block(  # phi = (1, x1, x2), a linear flow: u = x[2], y = phi_x[3]
    "linear",
    output=lambda t, x, u, p: [1.0, u[0], u[1]],
    inputs={"x": 2},
    outputs={"phi_x": 3},
    parameters={"N": 3},
)


STEADY = clpt.Block(  # phi = 1, a uniform flow
    "steady",
    output=lambda t, x, u, p: [1.0],
    inputs={"x": 2},
    outputs={"phi_x": 1},
    parameters={"N": 1},
)


def straight(random, n=6, duration=4.0):
    """Segments of vehicles at constant velocity, with random position errors."""
    time = np.linspace(0.0, duration, SAMPLES)
    start, velocity = random.normal(size=(2, n, 1, 2))
    track = start + velocity * time[:, None]
    times = time + duration * np.arange(n)[:, None]
    return Segments(times, track, random.normal(size=(n, 2)))


def test_integrals_of_a_linear_flow_are_those_of_the_middle():
    """Of phi = (1, x1, x2) on a straight track: duration times phi at its middle."""
    segments = straight(np.random.default_rng(2))
    middle = segments.track[:, [0, -1]].mean(axis=1)
    expected = 4.0 * np.column_stack([np.ones(6), middle])
    np.testing.assert_allclose(segments.integrals(LINEAR), expected, atol=1e-12)


@pytest.mark.parametrize("method", METHODS.values())
def test_a_uniform_flow_is_the_error_over_the_duration(method):
    segments = straight(np.random.default_rng(2))
    segments = segments._replace(error=4.0 * np.tile([0.2, -0.1], (6, 1)))
    steps, _, _ = method(
        segments, STEADY, np.zeros((2, 1)), np.array([1e6]), np.full(6, 0.1)
    )
    np.testing.assert_allclose(steps[-1], [[0.2], [-0.1]], atol=1e-9)


@pytest.mark.parametrize("method", METHODS.values())
def test_a_linear_flow_is_found(method):
    theta = np.array([[0.1, 0.0, -0.3], [0.2, 0.3, 0.0]])
    segments = straight(np.random.default_rng(2))
    segments = segments._replace(error=segments.integrals(LINEAR) @ theta.T)
    steps, _, _ = method(
        segments, LINEAR, np.zeros((2, 3)), np.ones(3), np.full(6, 1e-6)
    )
    np.testing.assert_allclose(steps[-1], theta, atol=1e-6)


def test_the_filter_of_one_function_is_its_closed_form():
    segments = straight(np.random.default_rng(3), 50, 2.0)
    steps, P, _ = kalman(
        segments, STEADY, np.zeros((2, 1)), np.array([3.0]), np.full(50, 0.5)
    )
    np.testing.assert_allclose(P, 1 / (1 / 9 + 50 * 4 / 0.25), rtol=1e-9)
    mean = 2 * segments.error.sum(axis=0) / 0.25 * P[0, 0]
    np.testing.assert_allclose(steps[-1][:, 0], mean, rtol=1e-9)


@seed(4)
@settings(max_examples=30, deadline=None, database=None)
@given(st.integers(0, 2**32 - 1), st.integers(1, 12))
def test_the_filter_ends_at_least_squares(number, n):
    random = np.random.default_rng(number)
    segments = straight(random, n)
    start, sd = random.normal(size=(2, 3)), random.uniform(0.1, 2, 3)
    r = random.uniform(0.05, 1, n)
    batch = batch_least_squares(segments, LINEAR, start, sd, r)
    one = kalman(segments, LINEAR, start, sd, r)
    np.testing.assert_allclose(one[0][-1], batch[0][-1], atol=1e-7)
    np.testing.assert_allclose(one[1], batch[1], atol=1e-7)
    # another way: normal equations
    h, y = (batch[2] / r[:, None], segments.error / r[:, None])
    P = np.linalg.inv(np.diag(1 / sd**2) + h.T @ h)
    np.testing.assert_allclose(batch[1], P, atol=1e-9)
    np.testing.assert_allclose(batch[0][-1], (start / sd**2 + y.T @ h) @ P, atol=1e-7)


@pytest.fixture(scope="module")
def lap():
    """One cycle of the paper's scenario, recorded each 0.2."""
    return clpt.simulate(
        PAPER.with_values({"run.duration": 200, "run.output_step": 0.2})
    )


def test_the_filter_is_causal(lap):
    early = estimate(lap.isel(time=slice(0, 501)), method="kalman")  # to t = 100
    whole = estimate(lap, method="kalman")
    np.testing.assert_allclose(whole.steps[: len(early.steps)], early.steps, atol=1e-9)


def test_a_prior_that_says_nothing_costs_no_accuracy(lap):
    """Standard deviations are those of least squares without a prior."""
    plain, wide = estimate(lap, prior=100.0), estimate(lap, prior=1e8)
    np.testing.assert_allclose(
        wide.standard_deviation, plain.standard_deviation, rtol=1e-6
    )
    refuses("is not finite. Give a smaller prior", estimate, lap, prior=1e300)


def test_the_true_parameters_are_not_read(lap):
    text, other = lap.attrs["scenario"], lap.copy()
    true = "[[1.0, 0.4, 0.8], [0.9, 0.4, 0.8]]"
    assert true in text
    other.attrs["scenario"] = text.replace(true, "[[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]")
    np.testing.assert_array_equal(estimate(other).theta, estimate(lap).theta)


def test_a_limited_speed_and_a_modelled_flow_are_known():
    values = {"vehicle.max_speed": 1.5, "model.parameters": 0.5 * THETA}
    run = clpt.simulate(PAPER.with_values(FINE | values))
    np.testing.assert_allclose(estimate(run, every=5.0).theta, THETA, rtol=1e-3)


def test_an_estimate_feeds_the_known_flow_law(lap):
    found = estimate(lap, method="kalman")
    known = clpt.currents.known_flow_scenario
    for law in ("learned-flow", "composite-memory", "kalman-flow"):
        base = PAPER.with_values({"learning.law": law, "learning.parameters": None})
        fed = known(base, found.theta)
        assert (fed.learning.law, fed.learning.gain) == ("known-flow", 0.8)
    each = {"parameters": 1.0, "feedback": 0.3, "feedforward": 0.5}
    base = PAPER.with_values({"learning.gain": None, "learning.gains": each})
    assert known(base, THETA).learning.gains.feedback == 0.3
    constant = {"adapt_gains": False, "feedback": [1, 1], "feedforward": [1, 1]}
    base = PAPER.with_values(
        {f"learning.{key}": value for key, value in constant.items()}
    )
    assert known(base, THETA).learning.gain is None
    run = clpt.simulate(fed.with_values({"run.duration": 1000}))
    last = run.clpe.sel(time=slice(800, 1000)).values
    assert np.sqrt(np.mean(np.sum(last**2, axis=1))) < 1e-4


def test_what_is_not_allowed_is_said(lap):
    for change, said in (
        ({"method": "guess"}, "'guess': must be one of least-squares, kalman"),
        (
            {"every": -1.0},
            r"every = -1: must be positive, at most the run's length, 200 s",
        ),
        ({"every": 300.0}, "every = 300: must be positive, at most"),
        ({"prior": 0.0}, "prior: must be a positive number, or 3 of them"),
        ({"noise": [1.0, 2.0]}, "noise: must be a positive number, or 100 of them"),
        ({"basis": clpt.paper_blocks(PAPER)[0]}, "reference: is not a basis"),
    ):
        refuses(said, estimate, lap, error=clpt.ScenarioError, **change)


def test_runs_that_tell_too_little_are_refused(lap):
    def run(values, **more):
        return clpt.simulate(PAPER.with_values({"run.duration": 200} | values), **more)

    fixes = {"learning": {"law": "fix-regression"}, "localization": {"interval": 5.0}}
    parameters = {"vehicle_controller.alpha_M": THETA}
    for source, said in (
        (lap.drop_attrs(), "contains no scenario"),
        (run({"run.duration": 20}, params=parameters), "parameters given at call time"),
        (lap.sel(time=slice(19.7, 60)), "into 5 samples at least"),
        (run({"run.output_step": 4}), r"to 0\.\d+ m only. Run it with a smaller"),
        (run({"run.output_step": 0.7}), "a step that divides that"),
        (run({**fixes, "run.duration": 40}), "steers on its prediction between fixes"),
    ):
        refuses(said, estimate, source, error=(clpt.DataError, clpt.ScenarioError))


# --- fixes with noise, one each or one for several of them


def shared(random, n, **more):
    """Segments whose misses share fixes, and the covariance of the misses for r = 1."""
    segments = straight(random, n)._replace(alone=0.3, **more)
    noise_period = more.get("noise_period", 4.0)  # the segments are 4 long
    noises = np.floor(
        np.minimum(4.0 * np.arange(n + 1), 4.0 * n - 1e-6) / noise_period
    ).astype(int)
    read = np.eye(noises[-1] + 1)[noises] if "noise_period" in more else np.eye(n + 1)
    difference = np.diff(read, axis=0)
    return segments, 0.09 * np.eye(n) + (1 - 0.09) / 2 * difference @ difference.T


@pytest.mark.parametrize("period", [2.0, 4.0, 8.0, 10.0, 40.0])
def test_what_one_noise_does_to_several_misses_is_bounded(period):
    """phi = (1, x1, x2): a noise that lasts for t_s in segment s is off by t_s there, C = t^T t."""
    segments = straight(np.random.default_rng(9), 9)._replace(noise_period=period)
    ends, noises = (
        4.0 * np.arange(10),
        period * np.arange(int(40 / period) + 1)[:, None],
    )
    t = np.diff(np.clip(ends, noises, noises + period))
    bound = np.trace(segments.blur(LINEAR), axis1=1, axis2=2) / 2  # of either axis
    assert np.linalg.eigvalsh(1.1 * np.diag(bound) - t.T @ t).min() > 0
    if period <= 4:  # each noise in one segment
        np.testing.assert_allclose(bound, np.sum(t**2, axis=0), rtol=0.15)


class ExactTracks(Segments):
    """Segments of which only the ends are read with noise."""

    def blur(self, basis):
        return np.zeros((len(self.error), 3, 3))


@pytest.mark.parametrize(
    "more", [{}, {"noise_period": 8.0}, {"noise_period": 10.0}], ids=str
)
def test_misses_that_share_a_fix_are_weighed_as_gauss_and_markov_say(more):
    segments, C = shared(np.random.default_rng(8), 9, **more)
    segments = ExactTracks(*segments._replace(alone=0.3 * 0.4))
    start, sd, r = np.ones((2, 3)), np.array([1.0, 2.0, 0.5]), np.full(9, 0.4)
    h, y = segments.integrals(LINEAR), segments.error
    W = np.linalg.inv(C) / 0.16
    P = np.linalg.inv(np.diag(1 / sd**2) + h.T @ W @ h)
    wanted = (start / sd**2 + y.T @ W @ h) @ P
    for method in (batch_least_squares, kalman):
        steps, covariance, _ = method(segments, LINEAR, start, sd, r)
        np.testing.assert_allclose(steps[-1], wanted, atol=1e-9)
        np.testing.assert_allclose(covariance, P, atol=1e-9)


def covered(theta, P):
    """Share of parameters within 1.96 standard deviations of the paper's."""
    return np.mean(np.abs(theta - THETA) <= 1.96 * np.sqrt(np.diag(P)))


@pytest.mark.parametrize(("every", "alone"), [(2.0, 0.9933), (5.0, 0.8775)])
def test_95_percent_are_95_percent_where_fixes_have_noise(every, alone):
    """`alone` is what comes of misses that are taken to share nothing."""
    segments = run_segments(clpt.simulate(PAPER.with_values(FINE)), PAPER, every)
    n, s = len(segments.error), 0.02
    basis, shares, sd = PAPER.basis_block(), [], np.full(3, 0.9)
    for number in range(200):
        noise = s * np.random.default_rng(number).standard_normal((n + 1, 2))
        seen = segments._replace(error=segments.error + np.diff(noise, axis=0))
        r = np.full(n, np.sqrt(2) * s)
        apart = seen._replace(alone=np.inf)
        found = [
            batch_least_squares(one, basis, np.zeros((2, 3)), sd, r)
            for one in (seen, apart)
        ]
        shares.append([covered(steps[-1], P) for steps, P, _ in found])
    right, wrong = np.mean(shares, axis=0)
    assert 0.93 < right < 0.97
    assert wrong == pytest.approx(alone, abs=1e-3)


def read_with_noise(number, noise=0.02, period=1.0):
    seen = {"noise": noise, "noise_period": period, "seed": number}
    return clpt.simulate(PAPER.with_values({**FINE, "localization": seen}))


@pytest.mark.slow
@pytest.mark.parametrize("method", ["least-squares", "kalman"])
def test_95_percent_are_95_percent_where_the_position_is_read_with_noise(method):
    shares = {2.0: [], 5.0: []}
    for number in range(200):
        run = read_with_noise(number)
        for every, found in shares.items():
            one = estimate(run, method=method, every=every)
            found.append(covered(one.theta, one.covariance))
    assert all(0.93 < np.mean(found) < 0.97 for found in shares.values())


def test_a_run_that_is_read_with_noise_says_how_well_it_tells():
    exact = read_with_noise(1, noise=0.0)
    noisy = {s: read_with_noise(1, noise=s) for s in (0.01, 0.04)}
    np.testing.assert_allclose(estimate(exact).theta, THETA, rtol=1e-4)
    sd = {s: estimate(run, every=5.0).standard_deviation for s, run in noisy.items()}
    np.testing.assert_allclose(sd[0.04], 4 * sd[0.01], rtol=0.05)
    # one noise in
    found = [estimate(read_with_noise(k, period=10.0), every=2.0) for k in range(4)]
    # five segments
    assert np.mean([covered(one.theta, one.covariance) for one in found]) >= 0.95
    beside = read_with_noise(0, period=0.25)
    said = r"the noise each 0\.25 s. Run it with a step"
    refuses(said, estimate, beside, error=clpt.ScenarioError)
    bare = noisy[0.01].drop_vars("measured_position")
    refuses("the run has no measured_position over time, axis", estimate, bare)
