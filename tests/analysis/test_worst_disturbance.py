"""The worst disturbance of Eq. (32): closed forms, random trials, and the wired diagram."""

import numpy as np
import pytest
from responses import response

import clpt_control as clpt
from analysis.worst_disturbance import (
    influences,
    peak_gains,
    regressor_matrices,
    worst_disturbance,
)
from clpt_control.theory.counterexamples.paper_system import with_square_wave
from clpt_control.theory.counterexamples.printed_bounds import scalar_matrix


def test_peak_gain_in_closed_form():
    """One lag: (1 - e^{-kt})/k; adaptation at 10 rad/s: near 4/pi."""
    lag = np.full((1000, 1, 1), -2.0)
    assert peak_gains(lag, 0.001, [1000]) == pytest.approx((1 - np.exp(-2)) / 2, rel=1e-5)
    ringing = np.broadcast_to(scalar_matrix(1.0, gain=100.0), (2000, 2, 2))
    assert peak_gains(ringing, 0.01, [2000]) == pytest.approx(4 / np.pi, rel=3e-3)


def test_no_random_disturbance_beats_the_worst_one():
    rng = np.random.default_rng(2)
    step, count = 0.05, 400
    A = regressor_matrices(clpt.paper_scenario(), count * step, step)[0]
    gain = peak_gains(A, step, [count])[0]
    signs = rng.choice([-1.0, 1.0], (500, count)) * rng.choice([0, 1.0], (500, 1))
    tones = np.sign(np.sin(rng.uniform(0.2, 6, (500, 1)) * step * np.arange(count)))
    for deltas in (signs, tones):
        reached = deltas @ influences(A, step, [count])[:-1, 0] * step
        assert np.abs(reached).max() < gain * 1.01


def test_the_worst_disturbance_is_attained_by_the_closed_loop():
    """Bang-bang Delta = Dmax sign(c Phi b) in the wired diagram; (33) claims 1."""
    paper, step, end, size = clpt.paper_scenario(), 0.04, 161.0, 0.001
    A = regressor_matrices(paper, end, step)[0]
    influence = influences(A, step, [len(A)])[:, 0]
    predicted = peak_gains(A, step, [len(A)])[0]
    scenario = with_square_wave(paper, size, 3.5).with_values({"run.duration": end})
    loop = clpt.closed_loop(scenario, external=("delta",))

    def delta(t):
        return np.array([size * np.sign(influence[min(int(t / step + 0.5), len(A))]), 0.0])

    run = response(
        loop,
        [0.0, end],
        inputs=delta,
        rtol=1e-6,
        atol=1e-9,
        initial_state=clpt.initial_state(scenario),
    )
    reached = abs(run.states[0, -1] - run.states[2, -1]) / size
    assert reached == pytest.approx(predicted, rel=0.01)
    assert reached > 2.5


@pytest.mark.slow
def test_the_worst_disturbance_of_the_second_and_later_cycles():
    found = worst_disturbance(clpt.paper_scenario(), 400.0, 800.0)
    assert found.peaks == pytest.approx((5.234, 4.744), rel=1e-3)
