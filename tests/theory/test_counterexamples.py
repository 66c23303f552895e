"""Where Eqs. (16) and (33) and Theorem 3.3's argument fail, and what does hold."""

import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.errors import ScenarioError
from clpt_control.theory.counterexamples import (
    burst_counterexample,
    disturbance_counterexample,
    drive_along,
    known_flow_counterexample,
    square_wave_counterexample,
    unlearned_counterexample,
)


@pytest.fixture(scope="module")
def square_wave():
    return disturbance_counterexample()


def test_33_is_violated_on_the_papers_system(square_wave):
    """Against an independent simulation's figures."""
    assert square_wave.claimed == pytest.approx(0.05)
    assert square_wave.ratio == pytest.approx(1.435, rel=0.01)
    assert square_wave.rms == pytest.approx(0.586, rel=0.01)
    assert square_wave.k / square_wave.ratio < 0.75 < square_wave.k == 1
    assert square_wave.peak > 0.05 / 0.75


def test_16_is_violated_on_the_papers_system():
    """At a slow gain, with one of the six flow parameters off by 0.1 m/s."""
    found = known_flow_counterexample()
    assert found.equation == "(16)"
    assert found.ratio == pytest.approx(1.367, rel=0.01)
    assert found.rms < 1
    cycles = [found.size[(found.times >= t) & (found.times < t + 200)].max() for t in (600, 800)]
    assert min(cycles) > 1.2 * found.claimed


@pytest.mark.parametrize("gain", [25.0, 100.0, 400.0])
def test_the_square_wave_at_resonance_gives_four_over_pi(gain):
    found = square_wave_counterexample(gain=gain, periods=80)
    assert found.ratio == pytest.approx(4 / np.pi, rel=0.01)
    assert found.rms < 1


@pytest.mark.parametrize(
    ("faint", "quiet", "peak"), [(0.2, 250, 2.19), (0.1, 1000, 4.92), (0.05, 4000, 10.38)]
)
def test_drift_then_burst(faint, quiet, peak):
    found = burst_counterexample(faint, quiet)
    assert found.peak == pytest.approx(peak, rel=0.02)
    assert found.peak == pytest.approx(0.52 / faint, rel=0.2)
    assert found.rms < 1


def test_no_faint_stretch_no_burst():
    """The measure can say no: with a steady regressor a steady Delta is learned away."""
    assert burst_counterexample(faint=1.0).ratio < 1e-3


def test_zc_exciting_is_not_enough():
    found = unlearned_counterexample()
    n, dwell, radius = 10, 20, 3
    assert found.kappa == pytest.approx(n * dwell * radius**2 / 2)
    assert found.moved < 1e-9
    assert found.error == pytest.approx(0.4, abs=1e-9)


def test_a_field_has_no_bound_to_compare_with():
    paper = clpt.paper_scenario()
    flow = paper.flow.model_copy(update={"parameters": None, "field": "current.nc"})
    with pytest.raises(ScenarioError, match="gridded field"):
        drive_along(paper.model_copy(update={"flow": flow}), None)
