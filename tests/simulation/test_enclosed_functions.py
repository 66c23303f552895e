"""Boxes of functions with a decision, a limit or a noise: flows of one state keep their order."""

import itertools
import math

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import clpt_control as clpt


def block(function, n=1, **more):
    return clpt.Block("model", update=function, states={"x": n}, **more)


def of_mpmath(rate, start, end):
    """Return the state at a time, to 20 digits."""
    with mpmath.workdps(25):
        return mpmath.odefun(lambda t, x: rate(x, mpmath), 0, mpmath.mpf(start))(end)


def contains(tube, low, high, much):
    """Return whether the last box of the last state has an interval, and is not much wider."""
    lower, upper = float(tube.lower[-1, -1]), float(tube.upper[-1, -1])
    return lower <= low <= high <= upper <= lower + much * float(high - low) + 1e-12


def logistic(a, of):
    return 1 / (1 + of.exp(-a))


def angle(a, b, of):
    return of.arctan2(a, b) if of is np else of.atan2(a, b)


FLOWS = {
    "sqrt": (lambda x, of: of.sqrt(2 + x) - x, (0.5, 0.8)),
    "square": (lambda x, of: x * x - 2 * x + 0.5, (-0.05, 0.05)),
    "tanh": (lambda x, of: of.tanh(3 * x) - 2 * x, (0.3, 0.31)),
    "logistic": (lambda x, of: logistic(5 * x, of) - x, (-0.2, -0.19)),
    "x times logistic": (lambda x, of: x / (1 + of.exp(4 * x)) - x, (0.2, 0.21)),
    "atan2, quadrant 2": (lambda x, of: angle(2 + x, x - 2, of) - 3 * x, (0.1, 0.3)),
    "atan2, upper axis": (lambda x, of: angle(2 + x, x - 1, of) - x, (0.6, 0.9)),
    "atan2, quadrant 3": (lambda x, of: angle(x - 2, x - 3, of) - x, (0.2, 0.5)),
    "atan2, lower axis": (lambda x, of: angle(-2, x, of) - x, (0.1, 0.2)),
}


def ends_of(rate, start):
    """Return the last box of a run of one state."""
    return clpt.enclose(block(lambda t, x, u, p: rate(x.x)), [0, 0.5], None, [start])


@pytest.mark.parametrize("name", FLOWS)
def test_a_flow_of_one_state_lies_between_those_of_the_ends(name):
    rate, ends = FLOWS[name]
    low, high = (of_mpmath(rate, end, 0.5) for end in ends)
    assert contains(ends_of(lambda x: rate(x, np), ends), low, high, 1.3)


@pytest.mark.parametrize(
    "limited",
    [lambda x: np.tanh(500 * (x + 3)), lambda x: 1 / (1 + np.exp(-900 * (x + 4)))],
)
def test_functions_of_large_arguments_are_their_limits(limited):
    tube = ends_of(lambda x: limited(x) - x, (0.1, 0.4))
    low, high = (1 + (end - 1) * mpmath.exp(-0.5) for end in (0.1, 0.4))
    assert contains(tube, low, high, 1.001)


def test_the_jump_of_an_angle_takes_in_both_sides_and_is_said():
    turning = block(lambda t, x, u, p: [1.0, np.arctan2(x.x[0] - 0.5, -1.0)], 2)
    tube = clpt.enclose(turning, [0, 1], None, [(-0.01, 0.01), 0.0])
    # -pi + atan(s) before the jump, pi - atan(s) after it
    for start in (-0.01, 0.0, 0.01):
        to_jump, after = 0.5 - start, 0.5 + start
        area = sum(
            sign * (math.pi * s - s * math.atan(s) + 0.5 * math.log1p(s * s))
            for s, sign in ((to_jump, -1), (after, 1))
        )
        assert tube.lower[-1, 1] <= area <= tube.upper[-1, 1]
    assert "Filippov" in tube.message
    assert tube.upper[-1, 1] - tube.lower[-1, 1] < 0.3


def test_a_parameter_that_never_changes_may_be_an_exponent():
    model = block(lambda t, x, u, p: -(x.x**p.n), parameters={"n": 2.0})
    tube = clpt.enclose(model, [0, 1], None, [(-0.41, -0.4)])
    assert contains(tube, -0.41 / 0.59, -0.4 / 0.6, 1.2)  # x / (1 + x t)


# --- tables ------------------------------------------------------------------------------------

POINTS, VALUES = [0.0, 1.0, 2.0, 4.0], [1.0, 2.0, 0.5, 1.0]


def area(x):
    """Return the integral of the table from 0 on, outside of it too."""
    knots = np.array([*(k for k in POINTS if k < x), x])
    inner = np.interp(knots, POINTS, VALUES)
    return float(np.sum(np.diff(knots) * (inner[1:] + inner[:-1]) / 2))


@pytest.mark.parametrize("radius", [0.0, 1e-6, 0.01])
def test_a_table_of_a_state_is_known_over_its_points(radius):
    model = block(lambda t, x, u, p: [1.0, np.interp(x.x[0], POINTS, VALUES)], 2)
    start = 0.5 - radius, 0.5 + radius
    tube = clpt.enclose(model, [0, 2, 5], None, [start, 0.0])
    ends = [area(end + 5) - area(end) for end in (0.5, *start)]
    lower, upper = float(tube.lower[-1, 1]), float(tube.upper[-1, 1])
    assert lower <= min(ends) <= max(ends) <= upper
    assert upper - lower < 12 * radius + 1e-8
    assert "Filippov" not in tube.message


def test_a_table_is_read_at_a_computed_place():
    table = np.array([1.0, 2.0, 4.0, 8.0])
    model = block(lambda t, x, u, p: [1.0, clpt.lookup(table, np.floor(x.x[0]) + 1)], 2)
    tube = clpt.enclose(model, [0, 1.5], None, [0.25, 0.0])
    assert contains(tube, 2 * 0.75 + 4 * 0.75, 4.5, 0.0) or (
        tube.lower[-1, 1] <= 4.5 <= tube.upper[-1, 1] <= tube.lower[-1, 1] + 1e-6
    )


# --- inputs that change at any time ------------------------------------------------------------

E2 = math.exp(-2.0)
OF_INPUTS = {
    "x / (1 + u)": (
        lambda x, u: -x / (1 + u),
        (1.0, 2.0),
        (-0.5, 0.5),
        (E2, 2 * math.exp(-2 / 3)),
        1,
    ),
    "u^2 - u": (
        lambda x, u: u**2 - u - x,
        0.0,
        (-1.0, 2.0),
        (-(1 - E2) / 4, 2 - 2 * E2),
        2,
    ),
    "exp(u)": (
        lambda x, u: np.exp(u) - x,
        0.0,
        (-1.0, 3.0),
        (math.exp(-1) * (1 - E2), math.exp(3) * (1 - E2)),
        2,
    ),
    "|u|": (lambda x, u: np.abs(u) - x, 0.0, (-1.0, 0.5), (0.0, 1 - E2), 2),
    "table": (
        lambda x, u: np.interp(u, POINTS, VALUES) - x,
        0.0,
        (0.5, 1.5),
        (1.25 * (1 - E2), 2 - 2 * E2),
        2,
    ),
    "x u": (lambda x, u: -x * u, 1.0, (0.5, 1.0), (E2, math.exp(-1.0)), 2),
}


@pytest.mark.parametrize("name", OF_INPUTS)
def test_boxes_of_inputs_that_enter_nonlinearly_are_near_the_exact_set(name):
    rate, start, pair, (low, high), end = OF_INPUTS[name]
    model = block(lambda t, x, u, p: rate(x.x, u.d), inputs={"d": 1})
    tube = clpt.enclose(model, np.linspace(0, end, 6), {"d": pair}, [start])
    assert contains(tube, low, high, 1.2)


def test_a_noise_is_that_of_its_time():
    model = block(lambda t, x, u, p: u.d, inputs={"d": 1})
    low, high = np.array([0.0, 0, 0, 0]), np.array([0.0, 0, 1, 0])
    tube = clpt.enclose(model, [0, 1, 2, 3], {"d": (low, high)}, [0.0])
    assert tube.upper[1, 0] - tube.lower[1, 0] < 1e-12
    assert tube.lower[-1, 0] <= 0.0
    assert tube.upper[-1, 0] >= 1.0  # the area of the upper line


def test_an_output_has_the_noise_of_its_input():
    model = block(
        lambda t, x, u, p: -x.x,
        inputs={"d": 1},
        outputs={"y": 1},
        output=lambda t, x, u, p: x.x * u.d**2,
    )
    tube = clpt.enclose(model, [0, 1], {"d": (-1, 2)}, [1.0])
    found = tube.sel(name="y[0]").isel(time=-1)
    right = 4 * math.exp(-1.0)
    assert found.lower <= 0.0 <= right <= found.upper <= 1.05 * right
    assert found.lower > -0.05


# --- sets of ordinary size ---------------------------------------------------------------------


def turning(t, x, u, p):
    """Return rates of a set that turns the faster the farther it is from 0."""
    rate = p.k * (x.x[0] ** 2 + x.x[1] ** 2)
    return [-rate * x.x[1], rate * x.x[0]]


@pytest.mark.parametrize("k", [1.0, (0.99, 1.01)])
def test_a_set_that_bends_contains_its_corners_and_is_near_their_hull(k):
    params = {"model.k": k} if isinstance(k, tuple) else None
    model = block(turning, 2, parameters={"k": 1.0})
    ends = [(0.97, 1.03), (-0.03, 0.03)]
    tube = clpt.enclose(model, [0, 0.35, 0.7], None, ends, params)
    shares = np.linspace(-1, 1, 9)
    for row, t in ((1, 0.35), (2, 0.7)):
        found = []
        for a, b, c in itertools.product(shares, shares, (0.99, 1.0, 1.01)):
            if c != 1.0 and not params:
                continue
            with mpmath.workdps(30):
                x, y = 1 + a * mpmath.mpf(0.03), b * mpmath.mpf(0.03)
                turn = c * (x * x + y * y) * t
                s, co = mpmath.sin(turn), mpmath.cos(turn)
                found.append([co * x - s * y, s * x + co * y])
        low, high = np.min(found, axis=0), np.max(found, axis=0)
        lower, upper = tube.lower.values[row], tube.upper.values[row]
        inner = 1e-12  # products of doubles in the corners
        assert tube.status == "finished"
        assert np.all(lower <= low + inner)
        assert np.all(high - inner <= upper)
        assert np.all(upper - lower <= 1.5 * (high - low).astype(float))


@pytest.mark.long  # 6 s of CPU: the smallest published set that needs second order
def test_the_laub_loomis_benchmark_is_verified():
    def rates(t, x, u, p):
        a, b, c, d, e, f, g = x.x
        return [
            *(1.4 * c - 0.9 * a, 2.5 * e - 1.5 * b, 0.6 * g - 0.8 * b * c),
            *(
                2 - 1.3 * c * d,
                0.7 * a - d * e,
                0.3 * a - 3.1 * f,
                1.8 * f - 1.5 * b * g,
            ),
        ]

    middle = [1.2, 1.05, 1.5, 2.4, 1.0, 0.1, 0.45]
    for w, most in ((0.05, 4.5), (0.1, 5.0)):
        ends = [(x - w, x + w) for x in middle]
        tube = clpt.enclose(block(rates, 7), np.linspace(0, 20, 81), None, ends)
        assert tube.status == "finished"
        assert float(tube.over_upper.sel(name="x[3]").max()) < most


def test_a_set_that_begins_at_the_root_of_0():
    def rates(t, x, u, p):
        far = np.sqrt(x.x[0] ** 2 + x.x[1] ** 2)
        return [p.k - far, p.k - 0.5 * far]

    model = block(rates, 2, parameters={"k": 1.0})
    tube = clpt.enclose(model, [0, 2], None, [0.0, 0.0], {"model.k": (0.99, 1.01)})
    assert tube.status == "finished"
    for k in (0.99, 1.0, 1.01):
        run = solve_ivp(
            lambda t, x, k=k: [k - np.hypot(*x), k - 0.5 * np.hypot(*x)],
            (0, 2),
            [0.0, 0.0],
            rtol=1e-11,
            atol=1e-13,
        )
        end = run.y[:, -1]
        assert np.all((tube.lower.values[1] <= end) & (end <= tube.upper.values[1]))
    assert np.all((tube.upper - tube.lower).values[1] < 0.05)


@pytest.mark.parametrize(
    ("rate", "start", "widest"),
    [
        (lambda x, of: of.sin(x), (-3.0, 3.0), 6.3),
        (lambda x, of: -(x**3), (-1.0, 1.0), 2.0),
        (lambda x, of: of.tanh(x) - 2 * x, (-0.6, 0.7), 1.4),
    ],
)
def test_a_wide_set_stays_between_its_walls(rate, start, widest):
    tube = clpt.enclose(
        block(lambda t, x, u, p: rate(x.x, np)), [0, 0.5, 1], None, [start]
    )
    low, high = (
        solve_ivp(lambda t, x: rate(x, np), (0, 1), [end], rtol=1e-10, atol=1e-12)
        for end in start
    )
    assert tube.status == "finished"
    assert tube.lower[-1, 0] <= low.y[0, -1] <= high.y[0, -1] <= tube.upper[-1, 0]
    assert tube.upper[-1, 0] - tube.lower[-1, 0] <= widest


def test_a_relay_in_sliding_and_a_drag_stay_bounded():
    relay = block(lambda t, x, u, p: 0.5 - np.sign(x.x))
    tube = clpt.enclose(relay, [0, 1, 3], None, [(-0.1, 0.1)])
    assert tube.lower[-1, 0] <= 0.0 <= tube.upper[-1, 0]
    assert tube.upper[-1, 0] - tube.lower[-1, 0] < 0.1
    drag = block(lambda t, x, u, p: 1 - np.abs(x.x) * x.x)
    tube = clpt.enclose(drag, [0, 1], None, [(-0.5, 0.5)])
    low = math.tan(1.0 - math.atan(0.5))  # from below: x' = 1 + x^2 up to 0
    low = math.tanh(1.0 - math.atan(0.5)) if low > 0.0 else low
    high = math.tanh(1.0 + math.atanh(0.5))
    assert tube.lower[-1, 0] <= low <= high <= tube.upper[-1, 0]
    assert tube.upper[-1, 0] - tube.lower[-1, 0] < 4 * (high - low)


def test_a_map_of_discrete_time_is_no_wider_than_its_values():
    model = clpt.Block(
        "model",
        update=lambda t, x, u, p: 0.5 * x.x + 0.1 * np.tanh(1000 * x.x),
        states={"x": 1},
        dt=1.0,
    )
    tube = clpt.enclose(model, range(10), None, [(-0.3, 0.3)])
    high = 0.3
    for _ in range(9):
        high = 0.5 * high + 0.1 * math.tanh(1000 * high)
    assert -0.21 < tube.lower[-1, 0] <= -high <= high <= tube.upper[-1, 0] < 0.21
