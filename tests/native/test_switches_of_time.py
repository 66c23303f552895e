"""Switches that time decides, or a phase that turns often: each is met."""

import control
import numpy as np
import pytest
from scipy.optimize import brentq
from test_kinks import T, system

import clpt_control as clpt


@pytest.mark.parametrize("end", [0.1, 0.5])
@pytest.mark.parametrize("duty", [0.02, 0.3])
def test_a_converter_that_switches_thousands_of_times_meets_each_switch(duty, end):
    """x' = 1 for `duty` of each period of 50 us, samples at multiples of it: x = duty t."""
    pulses, times = system(f"x' = 1 if t*20e3 % 1.0 < {duty} else 0"), np.linspace(0.0, end, 6)
    found = clpt.simulate(pulses, times, None, 0.0)
    np.testing.assert_allclose(found.states[:, 0], duty * times, atol=5e-9)
    assert found.attrs["solver_restarts"] >= 2 * 20e3 * end - 2


CARRIERS = {  # of period 1, and the share of the time that they are above a level
    "sine": (lambda s: np.sin(2.0 * np.pi * s), lambda level: 0.5 - np.arcsin(level) / np.pi),
    "triangle": (lambda s: 2.0 * np.abs(2.0 * (s % 1.0) - 1.0) - 1.0, lambda b: 0.5 - 0.5 * b),
}


def compared(carrier, level, frequency=10.0):
    """A carrier in one block, compared in a second one, whose yes and no a third integrates."""
    own = {"inputs": 0, "outputs": "c", "params": {"frequency": frequency}}
    yes = {"inputs": "c", "outputs": "v", "name": "above"}
    return clpt.connect([
        control.nlsys(None, lambda t, x, u, p: carrier(p["frequency"] * t), name="carrier", **own),
        control.nlsys(None, lambda t, x, u, p: np.where(u > level, 1.0, 0.0), **yes),
        control.tf([1], [1, 0], inputs="v", outputs="y", name="y"),
    ])  # fmt: skip


@pytest.mark.parametrize("level", [0.0, 0.3, 0.9])
@pytest.mark.parametrize("carrier", CARRIERS)
def test_a_carrier_of_one_block_that_another_compares_meets_each_switch(carrier, level):
    wave, share = CARRIERS[carrier]
    found = clpt.simulate(compared(wave, level, 137.0), [0.0, 10.0])
    np.testing.assert_allclose(found.y[-1], 10.0 * share(level), rtol=1e-9)


def test_members_whose_carriers_differ_switch_at_times_of_their_own():
    wave, share = CARRIERS["sine"]
    vary = {"carrier.frequency": [3.0, 10.0, 137.0]}
    found = clpt.run_ensemble(compared(wave, 0.3), vary, timepts=[0.0, 10.0], trajectories=True)
    np.testing.assert_allclose(found.y[:, -1], 10.0 * share(0.3), rtol=1e-9)


@pytest.mark.parametrize("level", [0.0, 0.3, 0.9, 0.999])
@pytest.mark.parametrize("frequency", [1.0, 10.0, 137.0])
def test_a_phase_that_turns_many_times_in_a_step_meets_each_switch(level, frequency):
    """No state has an error that would shorten a step: rates are constant between switches."""
    turning = system(f"a' = 2*pi*{frequency}; x' = 1 if sin(a) > {level} else 0")
    found = clpt.simulate(turning, [0.0, 10.0], None, 0.0)
    np.testing.assert_allclose(found.states[-1, 1], 10.0 * CARRIERS["sine"][1](level), rtol=1e-8)


SWINGS = [
    *((frequency, engine) for frequency in (1.0, 10.0) for engine in ("native", "python")),
    (137.0, "native"),
    pytest.param(137.0, "python", marks=pytest.mark.slow),
]


@pytest.mark.parametrize("level", [0.5, 0.9, 0.95])
@pytest.mark.parametrize(("frequency", "engine"), SWINGS)
def test_a_run_stops_where_a_swinging_output_first_reaches_a_level(frequency, level, engine):
    """y = t/10 sin(2 pi f t), whose rates are constant: no error shortens a step."""

    def y(t):
        return 0.1 * t * np.sin(2.0 * np.pi * frequency * t)

    sizes = {"inputs": 0, "outputs": 1, "states": 2}
    rates = lambda t, x, u, p: [2.0 * np.pi * frequency, 0.1]  # noqa: E731
    spiral = control.nlsys(rates, lambda t, x, u, p: x[1] * np.sin(x[0]), **sizes)
    stop = {"stop": lambda t, y, u: level - y[0], "engine": engine}
    found = clpt.simulate(spiral, T, None, 0.0, rtol=1e-8, **stop)
    peaks = (np.arange(10 * frequency) + 0.25) / frequency  # y is largest within 1e-4 of them
    reached = np.flatnonzero(y(peaks) > level)
    if not len(reached):
        assert found.attrs["status"] == "finished"
        return
    end = peaks[reached[0]]
    wanted = brentq(lambda t: y(t) - level, end - 0.25 / frequency, end)
    told = float(found.attrs["message"].split("t = ")[1])
    np.testing.assert_allclose(told, wanted, atol=1e-6)


ROWS = np.random.default_rng(3).normal(size=150)
HELD = (  # samples of 0.1 s, held
    lambda t: ROWS[min(int(t / 0.1), 149)],
    lambda t: ROWS[int(t // 0.1)],
    lambda t: ROWS[np.searchsorted(0.1 * np.arange(150), t, side="right") - 1],
    lambda t: ROWS[(int(t / 0.1) + 1) - 1],
)


@pytest.mark.parametrize("held", HELD)
def test_a_held_table_in_time_is_read_at_a_place_that_is_reckoned(held):
    table = system(lambda t, x, u, p: [held(t)], 1)
    found = clpt.simulate(table, np.linspace(0.0, 10.0, 11), None, 0.0)
    wanted = 0.1 * np.concatenate([[0.0], np.cumsum(ROWS)])[::10][:11]
    np.testing.assert_allclose(found.states[:, 0], wanted, atol=1e-9)
    assert found.attrs["engine"] == "native"
