"""Jumps of states: closed forms, left limits, ends of runs, and what refuses them."""

import copy
import math
import pickle
from typing import NamedTuple

import control
import numpy as np
import pytest
from engines import ENGINES
from responses import response

import clpt_control as clpt
from clpt_control.equations import Block, Guard
from clpt_control.errors import BlockError, SimulationError
from clpt_control.native.native_diagram import NativeDiagram


class Clock(NamedTuple):
    """Jumps at each multiple of a period, by a factor."""

    period: float = 1.0
    factor: float = 0.0
    interval: float = -1.0


def ticks(p, t0, t1):
    times = p.period * np.arange(1, math.floor(t1 / p.period * (1 + 1e-12)) + 1)
    return times[(times > t0) & (times <= t1)]


def grow(t, x, u, p):
    """s' = 1, section I: state s[1]."""
    return 1.0


def scale(t, x, u, p):
    """s = factor s after a jump, section I."""
    return p.factor * x[0]


def saw(name="saw", jump=scale, parameters=None, **more):
    return Block(
        name,
        update=grow,
        states={"s": 1},
        parameters=parameters or Clock(),
        breakpoints=ticks,
        jump=jump,
        **more,
    )


every_engine = pytest.mark.parametrize("engine", ENGINES)
every_step = pytest.mark.parametrize("step", [None, 0.1], ids=["DOP853", "RK4"])


@every_engine
@every_step
def test_an_integrator_that_is_reset_is_a_saw(engine, step):
    times = np.array([0.0, 0.5, 1.0, 1.5, 2.0, 2.25, 3.0])
    found = ENGINES[engine](saw()).run([0.0], times, step=step)
    np.testing.assert_allclose(found.x[:, 0], times % 1.0, atol=1e-12)
    assert found.statistics["restarts"] == 3


def still(t, x, u, p):
    return 0.0


def twice(t, x, u, p):
    return 2.0 * u[0]


def number(t, x, u, p):
    return 10.0 * p.interval


def read(t, x, u, p):
    """s = s + r after a jump, section I: input r[1]."""
    return x[0] + u[0]


@pytest.mark.parametrize("engine", ["python", "native"])
def test_a_jump_reads_an_input_of_the_diagram(engine):
    reader = Block("reader", update=still, states={"s": 1}, inputs={"r": 1}, parameters=Clock(),
                   breakpoints=ticks, jump=read)  # fmt: skip
    times, u = np.array([0.0, 0.8, 1.2, 2.0, 2.5]), np.array([0.0, 0.0, 4.0, 5.0, 5.0])
    run = response(clpt.connect([reader], external=["r"]), times, u, engine=engine)
    np.testing.assert_allclose(run.states[0], [0, 0, 2, 7, 7], atol=1e-12)


def test_a_jump_before_time_0_is_refused_and_none_is_missed():
    """Intervals are counted from 0 on: the jump at -1 was passed over."""
    at = np.array([-1.0, 1.0])
    block = Block(
        "once",
        update=grow,
        states={"s": 1},
        parameters={"interval": -1.0},
        breakpoints=lambda p, t0, t1: at[(at > t0) & (at <= t1)],
        jump=lambda t, x, u, p: x.s + 10.0,
    )
    with pytest.raises(BlockError, match=r"once: jumps at -1, .* begin the run at 0 or later"):
        clpt.simulate(block, [-2.0, 0.0, 2.0])
    assert clpt.simulate(block, [-0.5, 0.0, 2.0]).s.values.tolist() == pytest.approx([0, 0.5, 12.5])


@every_engine
def test_a_given_interval_does_not_end(engine):
    made = ENGINES[engine](clpt.connect([saw()]), {"saw.interval": 0.0})
    found = made.run([0.0], [0.0, 2.5])
    np.testing.assert_allclose(found.x[-1], [2.5], atol=1e-12)


def decay(t, x, u, p):
    return -x[0] * math.sin(3.0 * t)


def test_a_fixed_step_keeps_its_order():
    block = Block("d", update=decay, states={"s": 1}, parameters=Clock(0.7, -1.5),
                  breakpoints=ticks, jump=scale)  # fmt: skip
    exact = (-1.5) ** 4 * math.exp((math.cos(9.0) - 1.0) / 3.0)
    runner = NativeDiagram(block)
    errors = [abs(runner.run([1.0], [0.0, 3.0], step=0.7 / n).x[-1, 0] - exact) for n in (4, 8, 16)]
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert np.all((orders > 3.7) & (orders < 4.6)), orders


# --- guards, and numbers that are not finite --------------------------------------------------


def height(t, x, u, p):
    return x[0] + 1.0


def low(t, u, p):
    return f"too low at {t:g}"


@every_engine
@every_step
@pytest.mark.parametrize("end", [2.0, 2.5], ids=["at the end", "on the way"])
def test_a_guard_sees_a_state_after_its_jump(engine, step, end):
    guarded = saw(parameters=Clock(2.0, -3.0), guard=Guard(height, "stop", low))
    found = ENGINES[engine](guarded).run([0.0], [0.0, 1.0, end], step=step)
    assert (found.status, found.message) == ("stopped", "stopped: too low at 2")
    np.testing.assert_allclose(found.t, [0.0, 1.0, 2.0])
    np.testing.assert_allclose(found.x[:, 0], [0.0, 1.0, -6.0], atol=1e-12)


def over_nothing(t, x, u, p):
    return x[0] / p.factor


@every_engine
@every_step
@pytest.mark.parametrize("end", [2.0, 2.5], ids=["at the end", "on the way"])
def test_a_jump_to_nowhere_is_named(engine, step, end):
    block = saw(jump=over_nothing, parameters=Clock(2.0, 0.0))
    with pytest.raises(SimulationError, match=r"t = 2: state s\[0\] of block saw is not finite"):
        ENGINES[engine](block).run([1.0], [0.0, end], step=step)


# --- python-control ---------------------------------------------------------------------------


def test_python_control_refuses_to_integrate_over_jumps():
    inner = control.interconnect([saw()], outlist=["saw.s[0]"], outputs=["y"], name="inner")
    for system in (saw(), clpt.connect([saw()]), inner):
        with pytest.raises(BlockError, match=r"^saw: its states jump .* clpt\.simulate$"):
            control.input_output_response(system, np.linspace(0.0, 3.0, 4), 0.0, [0.0])


def test_python_control_reads_points_and_the_time_between_jumps():
    diagram = clpt.connect([saw(inputs={"r": 1})], external=["r"])
    for t in (0.3, 1.7, 5.0):
        assert diagram.dynamics(t, [2.0], [0.0]) == [1.0]
        assert diagram.output(t, [2.0], [0.0]) == [2.0]
        assert diagram.linearize([2.0], [0.0], t=t).A == [[0.0]]
    within = control.input_output_response(diagram, [1.0, 1.9], 0.0, [0.0])
    np.testing.assert_allclose(within.states[0, -1], 0.9)
    pinned = {"saw.interval": 0.0}
    held = control.input_output_response(diagram, [0.0, 3.0], 0.0, [0.0], params=pinned)
    np.testing.assert_allclose(held.states[0, -1], 3.0)


# --- blocks -----------------------------------------------------------------------------------


def test_a_jump_needs_states_and_breakpoints():
    said = r"^b: a jump sets states at the block's own breakpoints; give `breakpoints` and `states`"
    with pytest.raises(BlockError, match=said):
        Block("b", update=grow, states={"s": 1}, parameters=Clock(), jump=scale)
    with pytest.raises(BlockError, match=said):
        Block("b", output=number, outputs={"s": 1}, parameters=Clock(), breakpoints=ticks,
              jump=scale)  # fmt: skip


def branching(t, x, u, p):
    return x[0] if x[0] > 0.0 else 0.0


@every_engine
def test_a_jump_may_branch(engine):
    found = ENGINES[engine](saw(jump=branching)).run([-1.75], [0.0, 1.0, 2.0, 2.5]).x
    np.testing.assert_allclose(found[:, 0], [-1.75, 0.0, 1.0, 1.5], atol=1e-12)


@every_engine
def test_a_wire_carries_no_minus_zero_into_a_state(engine):
    """What a wire feeds is a sum that begins at 0.0, and atan2(-0.0, -1) would be -pi."""
    source = Block("source", output=lambda t, x, u, p: -0.0 * np.cos(t), outputs={"r": 1})
    turned = saw(
        jump=lambda t, x, u, p: u.r,
        inputs={"r": 1},
        output=lambda t, x, u, p: np.arctan2(x.s, -1.0),
        outputs={"angle": 1},
    )
    run = ENGINES[engine](clpt.connect([source, turned]))
    found = run.signals(run.run([0.0], [0.0, 1.0]), None)
    assert found[-1, -1] == np.pi


def test_a_block_that_jumps_conforms_is_copied_and_pickled():
    block = saw(jump=read, inputs={"r": 1})
    clpt.conformance.conformance(block)
    for twin in (pickle.loads(pickle.dumps(block)), copy.deepcopy(block), block.copy(name="twin")):
        found = response(twin, [0.0, 1.5], 3.0, [0.0])
        np.testing.assert_allclose(found.states[0], [0.0, 4.5], atol=1e-12)
