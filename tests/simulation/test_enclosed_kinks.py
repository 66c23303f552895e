"""Boxes of kinks and jumps that a set straddles: lines in their place keep slopes."""

import itertools
import math

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

import clpt_control as clpt


def block(function, n=1, **more):
    return clpt.Block("model", update=function, states={"x": n}, **more)


# a function with its kinks or jumps, and by how much boxes of its integral may be wider
SIDES = {
    "clip": (lambda s, of: of.clip(2 * s, -0.4, 0.5), [-0.2, 0.25], 2.0),
    "abs": (lambda s, of: of.abs(s - 0.1), [0.1], 2.0),
    "minimum of two": (lambda s, of: of.minimum(1 - s, 2 * s), [1 / 3], 2.0),
    "where": (lambda s, of: of.where(s > 0.2, s - 0.2, 0.0), [0.2], 3.0),
    "jump": (lambda s, of: of.where(s > 0.2, 1.0, -1.0), [0.2], 1.5),
    "floor": (lambda s, of: of.floor(2 * s), [-0.5, 0.0, 0.5, 1.0], 2.5),
    "remainder": (
        lambda s, of: of.mod(s, 0.3),
        [-0.3, 0.0, 0.3, 0.6, 0.9],
        2.5,
    ),  # areas of whole turns are equal
    "remainder below 0": (
        lambda s, of: of.mod(s, -0.3),
        [-0.3, 0.0, 0.3, 0.6, 0.9],
        2.5,
    ),
    "table": (
        lambda s, of: of.interp(s, [-1.0, -0.1, 0.3, 2.0], [1.0, -1.0, 2.0, 0.5]),
        [-0.1, 0.3],
        2.0,
    ),
    "drag": (lambda s, of: of.abs(s) * s, [0.0], 2.0),
    "square of a jump": (lambda s, of: of.sign(s - 0.1) ** 2 * s, [0.1], 3.0),
    "root": (lambda s, of: of.sqrt(of.abs(s)), [0.0], 8.0),
}


@pytest.mark.parametrize("name", SIDES)
def test_integrals_over_kinks_and_jumps_lie_within_boxes(name):
    function, switches, widest = SIDES[name]
    model = block(lambda t, x, u, p: [1.0, function(x.x[0], np)], 2)
    tube = clpt.enclose(model, [0, 0.6, 1.2], None, [(-0.5, -0.2), 0.0])
    for k, t in enumerate((0.6, 1.2), 1):
        areas = []
        for start in np.linspace(-0.5, -0.2, 13):
            inner = [s for s in switches if start < s < start + t]
            areas.append(
                sum(
                    quad(lambda s: float(function(s, np)), a, b, epsabs=1e-12)[0]
                    for a, b in itertools.pairwise([start, *inner, start + t])
                )
            )
        low, high = tube.lower[k, 1].item(), tube.upper[k, 1].item()
        assert low <= min(areas) + 1e-12
        assert max(areas) - 1e-12 <= high
        assert high - low <= widest * (max(areas) - min(areas)) + 0.4 * t


def test_a_limited_law_keeps_its_contraction():
    def law(x):
        return np.clip(-3 * x[0] - 2 * x[1], -1, 1)

    loop = block(lambda t, x, u, p: [x.x[1], law(x.x)], 2)
    tube = clpt.enclose(loop, [0, 2.5, 5], None, [(0.9, 1.0), (-0.1, 0.1)])
    ends = np.array(
        [
            solve_ivp(
                lambda t, x: [x[1], law(x)], (0, 5), start, rtol=1e-9, atol=1e-12
            ).y[:, -1]
            for start in itertools.product((0.9, 0.95, 1.0), (-0.1, 0.0, 0.1))
        ]
    )
    assert np.all(tube.lower[-1] <= ends.min(axis=0))
    assert np.all(ends.max(axis=0) <= tube.upper[-1])
    assert np.all((tube.upper - tube.lower)[-1] <= 6 * np.ptp(ends, axis=0))


def test_a_counter_of_the_time_in_a_disc_leaves_the_other_states_alone():
    """Benchmark LOVO of ARCH-COMP: x, y of Lotka and Volterra are those without the counter."""

    def rates(x, y):
        return [3 * x - 3 * x * y, x * y - y]

    def counted(t, x, u, p):
        is_inside = (x.x[0] - 1) ** 2 + (x.x[1] - 1) ** 2 <= 0.161**2
        return [*rates(x.x[0], x.x[1]), np.where(is_inside, 1.0, 0.0)]

    times, start = [0, 1.8, 3.64], [(1.292, 1.308), 1.0, 0.0]
    tube = clpt.enclose(block(counted, 3), times, None, start)
    plain = block(lambda t, x, u, p: rates(x.x[0], x.x[1]), 2)
    alone = clpt.enclose(plain, times, None, start[:2])
    widths = [(one.upper - one.lower)[-1, :2].values for one in (tube, alone)]
    assert np.all(widths[0] <= 2 * widths[1])
    assert 0.0 <= tube.lower[-1, 2] <= tube.upper[-1, 2] <= 1.0


def test_a_map_with_a_kink_and_an_output_keep_their_slopes():
    """The map of Lozi: x+ = 1 - a |x| + y, y+ = b x; max(x, 0.2) - x of x in (0, 0.4)."""
    lozi = clpt.Block(
        "lozi",
        update=lambda t, x, u, p: [1 - 1.4 * np.abs(x.x[0]) + x.x[1], 0.3 * x.x[0]],
        states={"x": 2},
        dt=1.0,
    )
    tube = clpt.enclose(lozi, range(6), None, [(-0.02, 0.03), (0.1, 0.11)])
    runs = np.array([*itertools.product((-0.02, 0.0, 0.01, 0.03), (0.1, 0.11))]).T
    for _ in range(5):
        runs = np.array([1 - 1.4 * np.abs(runs[0]) + runs[1], 0.3 * runs[0]])
    low, high = runs.min(axis=1), runs.max(axis=1)
    assert np.all((tube.lower[-1] <= low + 1e-12) & (high - 1e-12 <= tube.upper[-1]))
    assert np.all((tube.upper - tube.lower)[-1] <= 2 * (high - low))
    limited = clpt.Block(
        "limited",
        update=lambda t, x, u, p: 0.0 * x.x,
        output=lambda t, x, u, p: np.maximum(x.x, 0.2) - x.x,
        states={"x": 1},
        outputs={"y": 1},
    )
    tube = clpt.enclose(limited, [0, 1], None, [(0.0, 0.4)])
    # x / 2 + 0.1 + (0, 0.1) stands for the maximum
    assert -0.1 - 1e-9 <= tube.lower[-1, -1] <= 0.0
    assert 0.2 <= tube.upper[-1, -1] <= 0.2 + 1e-9


def test_states_of_very_different_sizes_straddle_a_kink():
    """The integral of |s| s with s = 1e-6 sin t beside a state of 1."""
    model = block(
        lambda t, x, u, p: [1e-6 * np.cos(t), 1e12 * np.abs(x.x[0]) * x.x[0]], 2
    )
    tube = clpt.enclose(model, [0, 1], None, [(-1e-7, 1e-7), 0.0])
    assert tube.status == "finished"
    assert tube.steps < 1000
    # s = a + sin t in units of 1e-6: its square is negative up to the crossing
    for a in (-0.1, 0.0, 0.1):
        # the integral of (a + sin t)^2 from 0
        crossing = max(math.asin(-a), 0.0)
        ends = [
            (a * a + 0.5) * t - 2 * a * math.cos(t) - math.sin(2 * t) / 4
            for t in (0.0, crossing, 1.0)
        ]
        area = ends[2] - 2 * ends[1] + ends[0]
        assert tube.lower[-1, 1] <= area + 1e-12
        assert area - 1e-12 <= tube.upper[-1, 1]


def test_a_loop_that_begins_at_the_root_of_0_has_boxes_over_a_short_time():
    loop = clpt.closed_loop(clpt.paper_scenario())
    tube = clpt.enclose(loop, [0, 0.01], None, [0.0] * 14)
    assert tube.status == "finished"


def test_a_map_whose_line_would_leave_its_domain_has_the_values_of_both_sides():
    model = clpt.Block(
        "model",
        update=lambda t, x, u, p: 0.1 / np.maximum(x.x, 0.05),
        states={"x": 1},
        dt=1.0,
    )
    tube = clpt.enclose(model, range(3), None, [(-1.0, 1.0)])
    assert tube.lower[1, 0] <= 0.1
    assert 2.0 <= tube.upper[1, 0] <= 2.1
    assert tube.status == "finished"


def test_short_steps_beside_a_root_have_powers_that_do_not_underflow():
    """s = t passes 1/2: the integral of the root of |s - 1/2| is 4/3 of (1/2)^1.5 at 1."""
    model = block(lambda t, x, u, p: [1.0, np.sqrt(np.abs(x.x[0] - 0.5))], 2)
    tube = clpt.enclose(model, [0, 0.5, 1], None, [0.0, (0.0, 0.1)])
    area = 4 / 3 * 0.5**1.5
    assert tube.lower[-1, 1] <= 1e-12 + area
    assert 0.1 + area - 1e-12 <= tube.upper[-1, 1] <= 0.11 + area
