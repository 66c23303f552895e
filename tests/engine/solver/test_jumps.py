"""Jumps of states: closed forms, left limits, ends of runs, and what refuses them."""

import copy
import math
import pickle
from typing import NamedTuple

import control
import numpy as np
import pytest
from engine_runs import (
    ENGINES,
    LANES,
    Form,
    NativeDiagram,
    PythonDiagram,
    Status,
    compare_backends,
    side_by_side,
    wiring_of,
)
from error_sentences import says
from hypothesis import given, settings
from hypothesis import strategies as st
from responses import response
from scipy.linalg import expm
from text_systems import ticking

import clpt_control as clpt
from clpt_control import Block, BlockError, Guard, SimulationError


def ticks(p, t0, t1):
    """Return the multiples of a period."""
    period = float(np.ravel(p.period)[0])
    times = period * np.arange(1, math.floor(t1 / period * (1 + 1e-12)) + 1)
    return times[(times > t0) & (times <= t1)]


def scale(t, x, u, p):
    """s = factor s after a jump, section I."""
    return p.factor * x[0]


def grow(t, x, u, p):
    """s' = 1, section I: state s[1]."""
    return 1.0


def saw(jump=scale, period=1.0, factor=0.0, **more):
    """Return an integrator of 1 that jumps at multiples of a period."""
    own = {"period": period, "factor": factor, "interval": -1.0}
    more |= {"states": {"s": 1}, "parameters": own, "breakpoints": ticks}
    return Block("saw", update=grow, jump=jump, **more)


every_engine = pytest.mark.parametrize("engine", ENGINES)
at_the_end_or_on_the_way = pytest.mark.parametrize("end", [2.0, 2.5])


@every_engine
def test_an_integrator_that_is_reset_is_a_saw(engine):
    times = np.array([0.0, 0.5, 1.0, 1.5, 2.0, 2.25, 3.0])
    found = ENGINES[engine](saw()).run([0.0], times)
    np.testing.assert_allclose(found.x[:, 0], times % 1.0, atol=1e-12)
    assert found.statistics["restarts"] == 3


def read(t, x, u, p):
    """s = s + r after a jump, section I: input r[1]."""
    return x[0] + u[0]


@pytest.mark.parametrize("engine", ["python", "native"])
def test_a_jump_reads_an_input_of_the_diagram(engine):
    reader = saw(read, inputs={"r": 1})
    times, u = np.array([0.0, 0.8, 1.2, 2.0, 2.5]), np.array([0.0, 0.0, 4.0, 5.0, 5.0])
    run = response(clpt.connect([reader], external=["r"]), times, u, engine=engine)
    np.testing.assert_allclose(run.states[0] - times, [0, 0, 2, 7, 7], atol=1e-12)


def test_a_jump_before_time_0_is_refused_and_none_is_missed():
    """Intervals are counted from 0 on: the jump at -1 was passed over."""
    at = np.array([-1.0, 1.0])
    own = {"breakpoints": lambda p, t0, t1: at[(at > t0) & (at <= t1)], "name": "once"}
    block = ticking(grow, lambda t, x, u, p: x.s + 10.0, **own)
    with pytest.raises(
        BlockError, match=r"once: jumps at -1, .* Begin the run at 0 or later,"
    ):
        clpt.simulate(block, [-2.0, 0.0, 2.0])
    assert clpt.simulate(block, [-0.5, 0.0, 2.0]).s.values.tolist() == pytest.approx(
        [0, 0.5, 12.5]
    )


@every_engine
def test_a_given_interval_does_not_end(engine):
    wiring = wiring_of(clpt.connect([saw()]), {"saw.interval": 0.0})
    found = ENGINES[engine](wiring).run([0.0], [0.0, 2.5])
    np.testing.assert_allclose(found.x[-1], [2.5], atol=1e-12)


# --- guards, and numbers that are not finite --------------------------------------------------


@every_engine
@at_the_end_or_on_the_way
def test_a_guard_sees_a_state_after_its_jump(engine, end):
    guard = Guard(
        lambda t, x, u, p: x[0] + 1.0, "stop", lambda t, u, p: f"too low at {t:g}"
    )
    runner = ENGINES[engine](saw(period=2.0, factor=-3.0, guard=guard))
    found = runner.run([0.0], [0.0, 1.0, end])
    assert (found.status, found.message) == ("stopped", "stopped: too low at 2")
    np.testing.assert_allclose(found.t, [0.0, 1.0, 2.0])
    np.testing.assert_allclose(found.x[:, 0], [0.0, 1.0, -6.0], atol=1e-12)


@every_engine
@at_the_end_or_on_the_way
def test_a_jump_to_nowhere_is_named(engine, end):
    block = saw(lambda t, x, u, p: x[0] / p.factor, period=2.0)
    with pytest.raises(
        SimulationError, match=r"t = 2: state s\[0\] of block saw is not finite"
    ):
        ENGINES[engine](block).run([1.0], [0.0, end])


# --- python-control ---------------------------------------------------------------------------


def test_python_control_refuses_to_integrate_over_jumps():
    inner = control.interconnect(
        [saw()], outlist=["saw.s[0]"], outputs=["y"], name="inner"
    )
    for system in (saw(), clpt.connect([saw()]), inner):
        with pytest.raises(
            BlockError, match=r"^saw: its states jump .* clpt\.simulate$"
        ):
            control.input_output_response(system, np.linspace(0.0, 3.0, 4), 0.0, [0.0])


def test_python_control_reads_points_and_the_time_between_jumps():
    diagram = clpt.connect([saw(inputs={"r": 1})], external=["r"])
    for t in (0.3, 1.7, 5.0):
        assert (diagram.dynamics(t, [2.0], [0.0]), diagram.output(t, [2.0], [0.0])) == (
            1.0,
            2.0,
        )
        assert diagram.linearize([2.0], [0.0], t=t).A == [[0.0]]
    for times, params in (([1.0, 1.9], {}), ([0.0, 3.0], {"saw.interval": 0.0})):
        found = control.input_output_response(diagram, times, 0.0, [0.0], params=params)
        np.testing.assert_allclose(found.states[0, -1], times[1] - times[0])


# --- blocks -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "lacking", [{"breakpoints": None}, {"states": None, "update": None}]
)
def test_a_jump_needs_states_and_breakpoints(lacking):
    said = r"^b: a jump sets states at the block's own breakpoints or at the edge of its guard"
    own = {
        "update": scale,
        "states": {"s": 1},
        "breakpoints": ticks,
        "jump": scale,
    } | lacking
    says(
        BlockError,
        said,
        Block,
        "b",
        output=scale,
        outputs={"y": 1},
        inputs={"u": 1},
        **own,
    )


@every_engine
def test_a_jump_may_branch(engine):
    block = saw(lambda t, x, u, p: x[0] if x[0] > 0.0 else 0.0)
    found = ENGINES[engine](block).run([-1.75], [0.0, 1.0, 2.0, 2.5]).x
    np.testing.assert_allclose(found[:, 0], [-1.75, 0.0, 1.0, 1.5], atol=1e-12)


@every_engine
def test_a_wire_carries_no_minus_zero_into_a_state(engine):
    """What a wire feeds is a sum that begins at 0.0, and atan2(-0.0, -1) would be -pi."""
    source = Block(
        "source", output=lambda t, x, u, p: -0.0 * np.cos(t), outputs={"r": 1}
    )
    angle = {
        "output": lambda t, x, u, p: np.arctan2(x.s, -1.0),
        "outputs": {"angle": 1},
    }
    turned = saw(lambda t, x, u, p: u.r, inputs={"r": 1}, **angle)
    run = ENGINES[engine](clpt.connect([source, turned]))
    assert run.signals(run.run([0.0], [0.0, 1.0]))[-1, -1] == np.pi


def test_a_block_that_jumps_conforms_is_copied_and_pickled():
    block = saw(read, inputs={"r": 1})
    compare_backends(block)
    for twin in (
        pickle.loads(pickle.dumps(block)),
        copy.deepcopy(block),
        block.copy(name="twin"),
    ):
        found = response(twin, [0.0, 1.5], 3.0, [0.0])
        np.testing.assert_allclose(found.states[0], [0.0, 4.5], atol=1e-12)


# --- random linear blocks that jump, against matrix exponentials --------------------------------

# some breakpoints coincide, some at the end
END, PERIODS = (2.0, (0.4, 0.5, 0.75, 1.0, 5.0))


class Linear(NamedTuple):
    """x' = A [x, u] + c k, and J [x, u] + d k after a jump, k the interval."""

    A: np.ndarray
    J: np.ndarray
    c: np.ndarray
    d: np.ndarray
    period: np.ndarray
    interval: float = -1.0


def rate(t, x, u, p):
    return p.A @ np.concatenate([x, u]) + p.c * p.interval


def jump(t, x, u, p):
    return p.J @ np.concatenate([x, u]) + p.d * p.interval


def drawn(random, sizes):
    """Draw the parameters of blocks of these sizes, each fed by all others."""
    total, found = sum(sizes), []
    for n in sizes:
        A, J = random.normal(size=(n, total)), random.normal(size=(n, total))
        period = np.array([random.choice(PERIODS), random.random()])
        found.append(Linear(A, J, random.normal(size=n), random.normal(size=n), period))
    return found


def diagram_of(sizes, parameters, jumping):
    def block(k):
        others = {f"s{j}": size for j, size in enumerate(sizes) if j != k}
        own = {"update": rate, "states": {f"s{k}": sizes[k]}, "inputs": others}
        own |= {"parameters": parameters[k], "breakpoints": ticks}
        return Block(f"b{k}", jump=jump if jumping[k] else None, **own)

    return clpt.connect([block(k) for k in range(len(sizes))])


def exact(sizes, parameters, jumping, x, times):
    """States by matrix exponentials from breakpoint to breakpoint."""
    places = np.split(np.arange(sum(sizes)), np.cumsum(sizes)[:-1])
    order = [[*own, *np.setdiff1d(np.arange(sum(sizes)), own)] for own in places]
    ends = [np.round(ticks(p, 0.0, END), 9) for p in parameters]
    found, t, intervals = [], 0.0, [0] * len(sizes)
    for stop in np.union1d(np.concatenate(ends), times):
        M = np.zeros((len(x) + 1, len(x) + 1))
        for own, k, p in zip(places, range(len(sizes)), parameters, strict=True):
            M[np.ix_(own, order[k])] = p.A
            M[own, -1] = p.c * intervals[k]
        x, t = (expm(M * (stop - t)) @ np.append(x, 1.0))[:-1], stop
        before = x.copy()
        for own, k, p in zip(places, range(len(sizes)), parameters, strict=True):
            intervals[k] += int(stop in ends[k])
            if jumping[k] and stop in ends[k]:
                x[own] = p.J @ before[order[k]] + p.d * intervals[k]
        if stop in times:
            found.append(x)
    return np.array(found)


def close(found, wanted, tolerance, said):
    size = np.maximum(1.0, np.abs(wanted).max(axis=0))
    assert np.abs((found - wanted) / size).max() < tolerance, said


@pytest.mark.long
@settings(max_examples=5, deadline=None, derandomize=True, database=None)
@given(st.integers(0, 2**32 - 1))
def test_every_engine_follows_matrix_exponentials(seed):
    random = np.random.default_rng(seed)
    sizes = random.integers(1, 4, size=random.integers(1, 4)).tolist()
    jumping = random.random(len(sizes)) < 0.8
    jumping[0] = True
    members = [drawn(random, sizes) for _ in range(LANES + 3)]
    starts = random.normal(size=(len(members), sum(sizes)))
    times = np.round(np.sort([0.0, *random.uniform(0.0, END, 4), 1.0, END]), 9)
    runs = zip(members, starts, strict=True)
    wanted = np.array([exact(sizes, p, jumping, x, times) for p, x in runs])
    diagrams = [diagram_of(sizes, p, jumping) for p in members]
    tight = {"rtol": 1e-11, "atol": 1e-12}
    for form in ("unrolled", "looped"):
        for diagram, x, states in zip(diagrams[:2], starts, wanted, strict=False):
            found = NativeDiagram(diagram, form=Form(form)).run(x, times, **tight)
            close(found.x, states, 1e-8, (seed, form))
    whole = NativeDiagram(diagrams[0])
    first = whole.run(starts[0], times[:4], **tight)
    close(
        whole.run(first.x[-1], times[3:], **tight).x, wanted[0][3:], 1e-8, (seed, "cut")
    )
    in_python = PythonDiagram(diagrams[0]).run(starts[0], times, rtol=1e-7, atol=1e-9).x
    close(in_python, wanted[0], 1e-4, (seed, "python"))
    runner = NativeDiagram(diagrams[0], form=Form("unrolled"))
    P = np.tile(runner.parameters(), (len(members), 1))
    for row, own in zip(P, members, strict=True):
        packed = runner.layout.packed(own)
        row[: len(packed)] = packed
    schedules = [NativeDiagram(diagram).schedule((0.0, END)) for diagram in diagrams]
    for lanes in (1, LANES):
        batch = side_by_side(runner, lanes, starts, times, P, schedules, 1e-11)
        assert set(batch.status) == {Status.FINISHED}
        for k, states in enumerate(wanted):
            close(batch.out[k], states, 1e-8, (seed, lanes, k))
        one = slice(3, 4)
        alone = side_by_side(
            runner, lanes, starts[one], times, P[one], schedules[one], 1e-11
        )
        np.testing.assert_array_equal(alone.out[0], batch.out[3])
