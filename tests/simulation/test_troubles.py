"""What cannot be computed, and what leaves a field, is said in a sentence."""

import math

import numpy as np
import pytest
from calm_water import PAPER

import clpt_control as clpt
from clpt_control.blocks import field, vehicle
from clpt_control.currents.plane import GriddedField
from clpt_control.errors import SimulationError


@pytest.mark.parametrize("engine", ["native", "python"])
def test_what_is_infinite_is_named(engine):
    x0 = clpt.initial_state(PAPER)
    x0[1] = np.nan
    with pytest.raises(SimulationError, match=r"t = 0.*x\[1\].*vehicle"):
        clpt.simulate(PAPER, [0, 1], initial_state=x0, engine=engine)
    burst = clpt.Block("burst", update=lambda t, x, u, p: x[0] ** 2, states={"x": 1})
    with pytest.raises(SimulationError, match=r"stopped at t = (0\.9|1)") as caught:
        clpt.simulate(burst, [0.0, 2.0], initial_state=[1.0], engine=engine)
    assert "\n" not in str(caught.value)


def drift(outside, u=1.0, v=0.0, end=10.0, *more, external=("v_x",)):
    """A vehicle that swims nowhere in a uniform current on x1 = -2 ... 2, x2 = -1 ... 1."""
    axes = [np.linspace(0, end, 5), np.linspace(-1, 1, 5), np.linspace(-2, 2, 9)]
    shape = tuple(len(axis) for axis in axes)
    grid = GriddedField(*axes, np.full(shape, u), np.full(shape, v))
    units = PAPER.units.model_copy(update={"length": "km", "time": "h"})
    flow = field.gridded_flow(grid, outside, units=units)
    return clpt.connect([flow, vehicle.vehicle(), *more], external=external)


def test_leaving_raises_with_position_time_and_bounds():
    with pytest.raises(SimulationError) as caught:
        clpt.simulate(drift("raise"), np.linspace(0, 5, 11), initial_state=[0.0, 0.5])
    sentence = str(caught.value)
    for part in ("(2, 0.5) km", "time 2 h", "x1 -2 to 2", "x2 -1 to 1", "time 0 to 10"):
        assert part in sentence, (part, sentence)
    assert "clip" in sentence
    assert "stop" in sentence


def test_leaving_stops_where_it_leaves_between_samples():
    run = clpt.simulate(drift("stop"), [0.0, 1.0, 3.0], initial_state=[0.75, 0.5])
    np.testing.assert_allclose(run.time, [0.0, 1.0, 1.25], atol=1e-9)
    np.testing.assert_allclose(run.states, [[0.75, 0.5], [1.75, 0.5], [2.0, 0.5]], atol=1e-8)
    assert run.message.startswith("stopped")
    assert "time 1.25 h" in run.message
    run = clpt.simulate(drift("stop"), [0.0, 1.0], initial_state=[3.0, 0.0])
    assert run.time.values.tolist() == [0.0]


def test_clip_goes_on_with_the_flow_at_the_edge_and_an_end_there_is_inside():
    run = clpt.simulate(drift("clip", v=-0.5), [0.0, 4.0, 20.0], initial_state=[0.0, 0.0])
    np.testing.assert_allclose(run.states[1:], [[4.0, -2.0], [20.0, -10.0]], atol=1e-8)
    run = clpt.simulate(drift("raise"), [0.0, 2.0], initial_state=[0.0, 1.0])
    np.testing.assert_allclose(run.states[-1], [2.0, 1.0], atol=1e-9)


def test_leaving_in_time_or_before_the_start():
    with pytest.raises(SimulationError, match=r"time 3 h; .*time 0 to 3 h"):
        clpt.simulate(drift("raise", u=0.1, end=3.0), [0.0, 5.0], initial_state=[0.0, 0.0])
    run = clpt.simulate(drift("stop", u=0.1, end=3.0), [0.0, 5.0], initial_state=[0.0, 0.0])
    np.testing.assert_allclose(run.time, [0.0, 3.0], atol=1e-9)
    with pytest.raises(SimulationError, match=r"\(3, 0\) km, time 0 h"):
        clpt.simulate(drift("raise"), [0.0, 1.0], initial_state=[3.0, 0.0])


@pytest.mark.parametrize("farthest", [4.04, 2.02])
def test_out_and_back_within_a_step_is_found(farthest):
    # x1 = a sin(pi t/10) against a current of 1: out at the first time where it is 2
    def velocity(t, x, u, p):
        return [-1.0 + farthest * math.pi / 10 * np.cos(math.pi * t / 10), 0.0]

    pushed = clpt.Block("pushed", output=velocity, outputs={"v_x": 2})
    run = clpt.simulate(drift("stop", 1.0, 0.0, 10.0, pushed, external=()), [0.0, 9.9])
    leaves = 10 / math.pi * math.asin(2 / farthest)
    assert run.time[-1] == pytest.approx(leaves, abs=1e-6)
    assert run.x[-1, 0] == pytest.approx(2.0, abs=1e-8)


@pytest.mark.parametrize("of", [lambda s: s, clpt.closed_loop], ids=["scenario", "diagram"])
def test_more_samples_than_memory_holds_are_refused_before_work(of):
    many = 1e-4 * np.arange(8_000_000)
    with pytest.raises(
        SimulationError, match=r"timepts: 8000000 samples of \d+ states and signals"
    ):
        clpt.simulate(of(PAPER), many)
