"""What is written is what runs: legal blocks and wirings that once ran as something else.

Each is asked in every reading and compared with a number worked out by hand, or is
refused in one sentence by every reading alike.
"""

import math

import control
import numpy as np
import pytest
from engine_runs import readings
from error_sentences import says
from recorded_blocks import static
from text_systems import ticking

import clpt_control as clpt
from clpt_control import Block, lookup


def without_source(body, name="f", **names):
    """Make equations as a prompt does, of which no text is kept."""
    space = {"math": math, "np": np, "lookup": lookup, **names}
    exec(f"def {name}(t, x, u, p):\n    {body}\n", space)
    return space[name]


WRONG = {
    "return u": "returns 2 numbers; must return 1",
    'return {"z": u[0]}': r"returns \['z'\]; must return \['y'\]",
    'return {"y": u}': r"returns y of shape \(2,\); must be \(1,\)",
    "return None": r"returns nothing; must return \['y'\]",
    "return 'a'": "returns 'a'; must return numbers",
    "return lookup(p.m, u[0])": "returns 2 numbers; must return 1",
}


@pytest.mark.parametrize("body", WRONG)
def test_what_is_returned_must_fit_the_ports(body):
    with pytest.raises(clpt.BlockError, match=WRONG[body]) as caught:
        static(without_source(body), 2, parameters={"m": np.ones((2, 2))})
    assert str(caught.value).startswith("mine.output")
    assert "\n" not in str(caught.value)


def by_a_small_number(t, x, u, p):
    return [math.atan2(0.0 * u[0], -1.0), np.where(1.0 / (0.0 * u[0]) > 0, 1.0, -1.0)]


def of_small_numbers(t, x, u, p):
    return [
        1e12 * math.log1p(1e-12 * u[0]),
        1e12 * math.expm1(1e-12 * u[0]),
        math.hypot(1e200 * u[0], 1e200 * u[0]) / 1e200,
        math.hypot(1e-200 * u[0], 1e-200 * u[0]) * 1e200,
    ]


LARGE = {"large": 1.5 * 2.0**52}  # added and taken off it rounds to whole numbers
ROOT, BODY = 2.0 * math.sqrt(2.0), "return [s(u[0]), w(u[0], 2.0)]"
ROUNDING = np.round, np.ceil, np.trunc, np.fix, round, math.ceil, math.trunc, int
CASES = {  # -> function, inputs, outputs, parameters
    "a table from its end": (
        lambda t, x, u, p: [lookup(p.table, k + 0.0 * u[0]) for k in (-1.0, -2.0, 1.9)],
        [0.3], [7.0, 5.0, 5.0], {"table": [3.0, 5.0, 7.0]},
    ),
    "a field called as a function": (
        lambda t, x, u, p: [p.gain * u[0], (p.count + 1 - p.count) * u[0]],
        [2.0], [6.0, 2.0], {"gain": 3.0, "count": 2**70},
    ),
    "a long table": (
        lambda t, x, u, p: [lookup(p.table, u[0]), lookup(p.table[::-3], u[0])],
        [150.5], [150.0, 5_999.0 - 450], {"table": np.arange(6_000.0)},
    ),
    "a zero's sign": (by_a_small_number, [2.0], [math.pi, 1.0]),
    "the sign of -0": (by_a_small_number, [-2.0], [-math.pi, -1.0]),
    "zeros that were rounded, Python's without a sign": (
        lambda t, x, u, p: [np.arctan2(f(u[0]), -1.0) for f in ROUNDING],
        [-0.3], [-math.pi] * 4 + [math.pi] * 4,
    ),
    "digits and range": (of_small_numbers, [2.0], [2.0 - 2e-12, 2.0 + 2e-12, ROOT, ROOT]),
    "code": (without_source(BODY, s=math.sin, w=np.minimum), [1.0], [math.sin(1.0), 1.0]),
    "equal code": (without_source(BODY, s=math.cos, w=np.maximum), [1.0], [math.cos(1.0), 2.0]),
    "a quantiser": (
        lambda t, x, u, p: [(u[0] + p.large) - p.large, u[1] - ((u[0] + p.large) - p.large)],
        [2.7, 4.125], [3.0, 1.125], LARGE,
    ),
    "k - k": (
        lambda t, x, u, p: u[2] + ((u[0] - u[1]) + (p.large - p.large)),
        [3e16, 3e16, 1.1], [1.1], LARGE,
    ),
    "a quantiser in a sum": (
        lambda t, x, u, p: np.sum((u + p.large) - p.large), [2.7, 0.4, -1.2], [2.0], LARGE
    ),
    "an empty product": (
        lambda t, x, u, p: np.arctan2(-0.0 * np.prod(u[:0]), -1.0), [1.0], [-math.pi]
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_every_reading_gives_what_is_worked_out_by_hand(case):
    function, u, wanted, *parameters = CASES[case]
    block = static(function, len(u), len(wanted), parameters=dict(*parameters))
    for name, ask in readings(block).items():
        if name != "symbolic" or parameters != [LARGE]:  # SymPy's numbers do not round
            found = ask(0.0, [], np.array(u))[1]
            np.testing.assert_allclose(
                found, wanted, rtol=1e-12, atol=1e-12, err_msg=name
            )


def test_an_angle_that_means_nothing_is_nan():
    def of_angles(t, x, u, p):
        return [math.sin(u[0]), math.cos(2.0 * u[0]), math.tan(u[0] ** 2)]

    asks = readings(static(of_angles, 1, 3))
    for name in asks.keys() - {
        "python",
        "control",
        "c",
    }:  # which ask the function itself
        np.testing.assert_array_equal(
            asks[name](0.0, [], [1e16])[1], [math.nan] * 3, err_msg=name
        )


def test_a_zero_that_comes_through_a_wire_has_no_sign():
    first = Block(
        "first", output=lambda t, x, u, p: -u[0], inputs={"u": 1}, outputs={"v": 1}
    )
    asked = lambda t, x, u, p: [np.minimum(1.0 / u[0], 5.0), math.atan2(u[0], -1.0)]  # noqa: E731
    second = Block("second", output=asked, inputs={"v": 1}, outputs={"y": 2})
    for ask in readings(clpt.connect([first, second], external=["u"])).values():
        np.testing.assert_allclose(ask(0.0, [], [0.0])[1], [0.0, 5.0, math.pi])


# --- what is none -----------------------------------------------------------------------------


@pytest.mark.parametrize("value", [[[1.0], [2.0, 3.0]], 1j, "a", None])
def test_parameters_that_are_no_numbers_are_refused(value):
    with pytest.raises(clpt.BlockError, match=r"mine\.large"):
        static(lambda t, x, u, p: -u[0], 1, parameters={"large": value})


def test_what_is_no_diagram_is_refused():
    for system in (control.tf([1], [1, 1]), 5, None):
        says(clpt.ClptError, "must be a diagram", readings, system)
    says(clpt.DiagramError, "no blocks", clpt.connect, [])


@pytest.mark.parametrize(
    "times", [[1.5, 0.5], [0.5, math.nan], None, 0.5, ["a"], [[0.5, 1.5]]]
)
def test_breakpoints_that_are_no_increasing_times_are_refused(times):
    with pytest.raises(clpt.BlockError, match="must be increasing times"):
        ticking(
            lambda t, x, u, p: p.interval, None, breakpoints=lambda p, t0, t1: times
        )
