"""Loops stay loops where turns are the same; what a turn hands on takes them apart."""

import math
from typing import NamedTuple

import control
import numpy as np
import pytest

from clpt_control.blocks import Block, opaque
from clpt_control.blocks.words import lookup, maximum, where
from clpt_control.native import readings
from clpt_control.native.loops import roll
from clpt_control.native.native_diagram import NativeDiagram
from clpt_control.native.program import Loop

N = 12


class Tables(NamedTuple):
    a: np.ndarray
    m: np.ndarray


P = Tables(np.linspace(-1.0, 1.0, N), np.arange(float(N * N)).reshape(N, N) / 50)


def sums(t, x, u, p, y):
    s = 0.0
    for i in range(12):
        s += p.a[i] * u[i]
    y[0] = s


def sums_of_sums(t, x, u, p, y):
    for i in range(12):
        y[i] = 0.5 * u[i]
        for k in range(12):
            y[i] += p.m[i, k] * u[k]


def two_sums(t, x, u, p, y):
    s, c = 1.0, 0.0
    for i in range(12):
        s -= math.sin(u[i])
        c += math.cos(u[i])
    y[0] = s * c


def reads_what_was_kept(t, x, u, p, y):
    for i in range(12):
        y[i] = math.tanh(u[i])
    s = 0.0
    for i in range(12):
        s += y[i]
    y[0] = s


def counts(t, x, u, p, y):
    s = 0.0
    for i in range(12):
        s += i * u[11 - i]
    y[0] = s


@opaque
def gust(a, t):
    return math.sin(a + t)


def gusts(t, x, u, p, y):
    for i in range(12):
        y[i] = gust(u[i], t) + gust(0.0, t)


def runs_a_maximum(t, x, u, p, y):
    m = u[0]
    for i in range(12):
        m = maximum(m, u[i])
    y[0] = m


def recurs(t, x, u, p, y):
    s = 0.0
    for i in range(12):
        s = 0.5 * s + u[i]
    y[0] = s


def reads_the_sum(t, x, u, p, y):
    s, total = 0.0, 0.0
    for i in range(12):
        old = s
        s = s + u[i]
        total += s - old
    y[0] = total


def swaps(t, x, u, p, y):
    a, b = u[0], u[1]
    for i in range(12):
        a, b = b, a + 0.1 * u[i]
    y[0] = a


def reads_squares(t, x, u, p, y):
    s = 0.0
    for i in range(12):
        s += u[i * i % 11]
    y[0] = s


def differs_in_a_turn(t, x, u, p, y):
    s = 0.0
    for i in range(12):
        s += where(i > 6, u[i], 2.0 * u[i]) + lookup(p.a, 1.0 * i)
    y[0] = s


KEPT = {sums: 1, sums_of_sums: 12, two_sums: 1, reads_what_was_kept: 12, counts: 1, gusts: 12}
APART = (runs_a_maximum, recurs, reads_the_sum, swaps, reads_squares, differs_in_a_turn)


def loops(items):
    return [item.count for item in items if isinstance(item, Loop)]


def block_of(function, size=1):
    return Block(
        function.__name__, output=function, inputs={"u": N}, outputs={"y": size}, parameters=P
    )


def alike(diagram):
    random = np.random.default_rng(0)
    asked = readings(diagram)
    for _ in range(3):
        t, u = random.uniform(0, 9), random.normal(size=diagram.ninputs)
        wanted = asked["control"](t, [], u)[1]
        for name, ask in asked.items():
            np.testing.assert_allclose(
                ask(t, [], u)[1], wanted, rtol=1e-12, atol=1e-13, err_msg=name
            )


@pytest.mark.parametrize("function", KEPT)
def test_equal_turns_stay_a_loop(function):
    block = block_of(function, KEPT[function])
    assert N in loops(roll(block.output_record).items)
    assert N in loops(NativeDiagram(block, form="looped").code.program.signals)
    assert loops(NativeDiagram(block, form="unrolled").code.program.signals) == []
    alike(block)


@pytest.mark.parametrize("function", APART)
def test_turns_that_hand_on_more_than_a_sum_are_taken_apart(function):
    block = block_of(function)
    assert loops(roll(block.output_record).items) == []
    alike(block)


def doubled(t, x, u, p, y):
    for i in range(12):
        y[i] = 2.0 * u[i]


@pytest.mark.parametrize("order", ["straight", "backwards", "mixed"])
def test_a_loop_stays_one_behind_any_wiring(order):
    first = Block("first", output=doubled, inputs={"u": N}, outputs={"y": N})
    places = {
        "straight": range(N),
        "backwards": range(N - 1, -1, -1),
        "mixed": [5 * j % N for j in range(N)],
    }[order]
    diagram = control.interconnect(
        [first, block_of(sums)],
        outlist=["sums.y[0]"],
        inplist=[f"first.u[{j}]" for j in range(N)],
        connections=[[f"sums.u[{j}]", f"first.y[{k}]"] for j, k in enumerate(places)],
    )
    items = NativeDiagram(diagram, form="looped").code.program.signals
    assert [item.count for item in items if isinstance(item, Loop) and item.sums] == [N]
    alike(diagram)


def test_few_turns_stay_apart():
    def few(t, x, u, p, y):
        y[0] = 0.0
        for i in range(4):
            y[0] += u[i]

    block = Block("few", output=few, inputs={"u": 4}, outputs={"y": 1})
    assert loops(roll(block.output_record).items) == []


def many_terms(t, x, u, p, dx):
    s = u[0]
    for i in range(3000):
        s = s + 0.001 * i * u[1]
    dx[0] = s
    for _ in range(60):
        s = 0.25 * (s + s)
    dx[1] = s + s


def test_sums_of_very_many_terms_are_left_as_they_are():
    block = Block("many", update=many_terms, inputs={"u": 2}, states={"x": 2})
    total = 1.0 + 0.001 * sum(range(3000))
    for name, ask in readings(block).items():
        if name not in ("symbolic", "lanes"):
            found = ask(0.0, [0.0, 0.0], [1.0, 1.0])[0]
            np.testing.assert_allclose(found, [total, total * 2.0**-59], rtol=1e-12, err_msg=name)


def doubles(t, x, u, p, dx):
    s = u[0]
    for _ in range(60):
        s = s + s
    dx[0] = s


def test_a_sum_that_doubles_sixty_times():
    block = Block("doubles", update=doubles, inputs={"u": 1}, states={"x": 1})
    for name, ask in readings(block).items():
        assert ask(0.0, [0.0], [1.5])[0] == [1.5 * 2.0**60], name
