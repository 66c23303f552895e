"""Estimates of theta where fixes have noise, one each or one for several of them."""

import numpy as np
import pytest
from test_flow_estimate import LINEAR, PAPER, THETA, estimate, turning

import clpt_control as clpt
from clpt_control.estimation.fix_to_fix import batch_least_squares, generalised, kalman
from clpt_control.estimation.segments import Segments, run_segments


def shared(random, n, **more):
    """Segments whose misses share fixes, and the covariance of the misses for r = 1."""
    segments = turning(random, n)._replace(end=random.normal(size=(n, 2)), alone=0.3, **more)
    noise_period = more.get("noise_period", 4.0)  # the segments are 4 long
    noises = np.floor(np.minimum(4.0 * np.arange(n + 1), 4.0 * n - 1e-6) / noise_period).astype(int)
    read = np.eye(noises[-1] + 1)[noises] if "noise_period" in more else np.eye(n + 1)
    difference = np.diff(read, axis=0)
    return segments, 0.09 * np.eye(n) + (1 - 0.09) / 2 * difference @ difference.T


@pytest.mark.parametrize("period", [2.0, 4.0, 8.0, 10.0, 40.0])
def test_what_one_noise_does_to_several_misses_is_bounded(period):
    """phi = (1, x1, x2): a noise that lasts for t_s in segment s is off by t_s there, C = t^T t."""
    segments = turning(np.random.default_rng(9), 9)._replace(noise_period=period)
    ends, noises = 4.0 * np.arange(10), period * np.arange(int(40 / period) + 1)[:, None]
    t = np.diff(np.clip(ends, noises, noises + period))
    bound = np.trace(segments.blur(LINEAR), axis1=1, axis2=2) / 2  # of either axis
    assert np.linalg.eigvalsh(1.1 * np.diag(bound) - t.T @ t).min() > 0
    if period <= 4:  # each noise in one segment
        np.testing.assert_allclose(bound, np.sum(t**2, axis=0), rtol=0.15)


@pytest.mark.parametrize("more", [{}, {"noise_period": 8.0}, {"noise_period": 10.0}], ids=str)
def test_misses_that_share_a_fix_are_weighed_as_gauss_and_markov_say(more, monkeypatch):
    monkeypatch.setattr(Segments, "blur", lambda self, basis: np.zeros((9, 3, 3)))
    segments, C = shared(np.random.default_rng(8), 9, **more)
    segments = segments._replace(alone=0.3 * 0.4)
    start, sd, r = np.ones((2, 3)), np.array([1.0, 2.0, 0.5]), np.full(9, 0.4)
    h, y, W = (
        segments.integrals(LINEAR, segments.known_track),
        segments.miss,
        np.linalg.inv(C) / 0.16,
    )
    P = np.linalg.inv(np.diag(1 / sd**2) + h.T @ W @ h)
    wanted = (start / sd**2 + y.T @ W @ h) @ P
    for method in (batch_least_squares, kalman):
        steps, covariance, _ = method(segments, LINEAR, start, sd, r, np.zeros(3))
        np.testing.assert_allclose(steps[-1], wanted, atol=1e-9)
        np.testing.assert_allclose(covariance, P, atol=1e-9)


def covered(theta, P):
    """Share of parameters within 1.96 standard deviations of the paper's."""
    return np.mean(np.abs(theta - THETA) <= 1.96 * np.sqrt(np.diag(P)))


@pytest.mark.parametrize(("every", "alone"), [(2.0, 0.9933), (5.0, 0.8775)])
def test_95_percent_are_95_percent_where_fixes_have_noise(every, alone):
    """`alone` is what comes of misses that are taken to share nothing."""
    run = clpt.simulate(PAPER.with_values({"run.duration": 200, "run.output_step": 0.1}))
    segments = run_segments(run, PAPER, every)
    n, s = len(segments.start), 0.02
    h = segments.integrals(PAPER.basis_block(), segments.track)
    shares, sd = [], np.full(3, 0.9)
    for number in range(200):
        noise = s * np.random.default_rng(number).standard_normal((n + 1, 2))
        seen = segments._replace(
            start=segments.start + noise[:-1], end=segments.end + noise[1:], track=segments.track
        )
        r = np.full(n, np.sqrt(2) * s)
        apart = seen._replace(alone=np.inf)
        found = [generalised(one, h, np.zeros((2, 3)), sd, r) for one in (seen, apart)]
        shares.append([covered(*one) for one in found])
    right, wrong = np.mean(shares, axis=0)
    assert 0.93 < right < 0.97
    assert wrong == pytest.approx(alone, abs=1e-3)


NOISY = {"run.duration": 200, "run.output_step": 0.1}


def read_with_noise(number, noise=0.02, period=1.0):
    seen = {"noise": noise, "noise_period": period, "seed": number}
    return clpt.simulate(PAPER.with_values({**NOISY, "localization": seen}))


@pytest.mark.slow
@pytest.mark.parametrize("method", ["least-squares", "kalman"])
def test_95_percent_are_95_percent_where_the_position_is_read_with_noise(method):
    shares = {2.0: [], 5.0: []}
    for number in range(200):
        run = read_with_noise(number)
        for every, found in shares.items():
            one = estimate(run, method, every=every)
            found.append(covered(one.theta, one.covariance))
    assert all(0.93 < np.mean(found) < 0.97 for found in shares.values())


def test_a_run_that_is_read_with_noise_says_how_well_it_tells():
    exact = read_with_noise(1, noise=0.0)
    noisy = {s: read_with_noise(1, noise=s) for s in (0.01, 0.04)}
    np.testing.assert_allclose(estimate(exact).theta, THETA, rtol=1e-4)
    sd = {s: estimate(run, every=5.0).standard_deviation for s, run in noisy.items()}
    np.testing.assert_allclose(sd[0.04], 4 * sd[0.01], rtol=0.05)
    short = noisy[0.01].isel(time=slice(0, 401))
    np.testing.assert_allclose(estimate(short, "tomography", every=5.0).theta, THETA, atol=0.2)
    found = [estimate(read_with_noise(k, period=10.0), every=2.0) for k in range(4)]  # one noise in
    assert np.mean([covered(one.theta, one.covariance) for one in found]) >= 0.95  # five segments
    beside = clpt.simulate(
        PAPER.with_values({**NOISY, "localization": {"noise": 0.02, "noise_period": 0.25}})
    )
    with pytest.raises(clpt.ScenarioError, match=r"the noise each 0\.25 s; run it with a step"):
        estimate(beside)
    with pytest.raises(clpt.DataError, match="the run has no measured_position over time, axis"):
        estimate(noisy[0.01].drop_vars("measured_position"))
