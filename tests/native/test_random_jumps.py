"""Random linear blocks that jump, against matrix exponentials, in every engine."""

import math
from typing import NamedTuple

import numpy as np
from engines import side_by_side
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

import clpt_control as clpt
from clpt_control.equations import Block
from clpt_control.native import numbering
from clpt_control.native.machine import LANES
from clpt_control.native.native_diagram import NativeDiagram
from clpt_control.native.python_diagram import PythonDiagram

END, PERIODS = 2.0, (0.4, 0.5, 0.75, 1.0, 5.0)  # some breakpoints coincide, some at the end


class Linear(NamedTuple):
    """x' = A [x, u] + c k, and J [x, u] + d k after a jump, k the interval."""

    A: np.ndarray
    J: np.ndarray
    c: np.ndarray
    d: np.ndarray
    period: np.ndarray
    interval: float = -1.0


def ticks(p, t0, t1):
    times = p.period[0] * np.arange(1, math.floor(t1 / p.period[0] * (1 + 1e-12)) + 1)
    return times[(times > t0) & (times <= t1)]


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
    blocks = [
        Block(
            f"b{k}",
            update=rate,
            states={f"s{k}": n},
            inputs={f"s{j}": sizes[j] for j in range(len(sizes)) if j != k},
            parameters=p,
            breakpoints=ticks,
            jump=jump if jumping[k] else None,
        )
        for k, (n, p) in enumerate(zip(sizes, parameters, strict=True))
    ]
    return clpt.connect(blocks)


def exact(sizes, parameters, jumping, x, times):
    """States by matrix exponentials from breakpoint to breakpoint."""
    firsts = np.cumsum([0, *sizes])
    order = [
        [*range(firsts[k], firsts[k + 1]), *range(firsts[k]), *range(firsts[k + 1], firsts[-1])]
        for k in range(len(sizes))
    ]
    ends = [np.round(ticks(p, 0.0, END), 9) for p in parameters]
    found, t, intervals = [], 0.0, [0] * len(sizes)
    for stop in np.union1d(np.concatenate(ends), times):
        M = np.zeros((len(x) + 1, len(x) + 1))
        for k, p in enumerate(parameters):
            own = slice(firsts[k], firsts[k + 1])
            M[own, order[k]] = p.A
            M[own, -1] = p.c * intervals[k]
        x, t = (expm(M * (stop - t)) @ np.append(x, 1.0))[:-1], stop
        before = x.copy()
        for k, p in enumerate(parameters):
            intervals[k] += int(stop in ends[k])
            if jumping[k] and stop in ends[k]:
                x[firsts[k] : firsts[k + 1]] = p.J @ before[order[k]] + p.d * intervals[k]
        if stop in times:
            found.append(x)
    return np.array(found)


def close(found, wanted, tolerance, said):
    size = np.maximum(1.0, np.abs(wanted).max(axis=0))
    assert np.abs((found - wanted) / size).max() < tolerance, said


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
    wanted = np.array(
        [exact(sizes, p, jumping, x, times) for p, x in zip(members, starts, strict=True)]
    )
    diagrams = [diagram_of(sizes, p, jumping) for p in members[:2]]
    for form in ("unrolled", "looped"):
        for diagram, x, states in zip(diagrams, starts, wanted, strict=False):
            found = NativeDiagram(diagram, form=form).run(x, times, rtol=1e-11, atol=1e-12)
            close(found.x, states, 1e-8, (seed, form))
        first = NativeDiagram(diagrams[0]).run(starts[0], times[:4], rtol=1e-11, atol=1e-12)
        again = NativeDiagram(diagrams[0]).run(first.x[-1], times[3:], rtol=1e-11, atol=1e-12)
        close(again.x, wanted[0][3:], 1e-8, (seed, "cut"))
    in_python = PythonDiagram(diagrams[0]).run(starts[0], times, rtol=1e-7, atol=1e-9).x
    close(in_python, wanted[0], 1e-4, (seed, "python"))
    runner = NativeDiagram(diagrams[0], form="unrolled")
    P = np.tile(runner.parameters(), (len(members), 1))
    for row, own in zip(P, members, strict=True):
        packed = runner.layout.packed(own)
        row[: len(packed)] = packed
    schedules = [NativeDiagram(diagram_of(sizes, p, jumping)).schedule((0.0, END)) for p in members]
    for lanes in (1, LANES):
        batch = side_by_side(runner, lanes, starts, times, None, P, schedules, 1e-11)
        assert set(batch.status) == {numbering.FINISHED}
        for k, states in enumerate(wanted):
            close(batch.out[k], states, 1e-8, (seed, lanes, k))
        one = slice(3, 4)
        alone = side_by_side(runner, lanes, starts[one], times, None, P[one], schedules[one], 1e-11)
        np.testing.assert_array_equal(alone.out[0], batch.out[3])
