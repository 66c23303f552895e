"""What is written is what runs: legal blocks and wirings that once ran as something else.

Each is asked in every reading and compared with a number worked out by hand, or is
refused in one sentence by every reading alike.
"""

import math

import control
import numpy as np
import pytest
from recorded import static

import clpt_control as clpt
from clpt_control.conformance import readings
from clpt_control.diagrams.interconnection import connect
from clpt_control.equations import Block, lookup
from clpt_control.errors import BlockError, ClptError, DiagramError


def alike(diagram, x=(), u=(), t=0.0, rate=None, outputs=None):
    """Every reading gives these numbers."""
    for name, ask in readings(diagram).items():
        found = ask(t, np.asarray(x, dtype=float), np.asarray(u, dtype=float))
        for got, wanted in zip(found, (rate, outputs), strict=True):
            if wanted is not None:
                np.testing.assert_allclose(got, wanted, rtol=1e-12, atol=1e-12, err_msg=name)


def looks_from_the_end(t, x, u, p):
    return [
        lookup(p.table, -1.0 + 0.0 * u[0]),
        lookup(p.table, -2.0 + 0.0 * u[0]),
        lookup(p.table, 1.9 + 0.0 * u[0]),
    ]


# --- what nobody writes twice ------------------------------------------------------------------


def without_source(body, name="f", **names):
    """Make equations as a prompt does, of which no text is kept."""
    lines = "".join(f"    {line}\n" for line in body.split("\n"))
    space = {"math": math, "np": np, "lookup": lookup, **names}
    exec(f"def {name}(t, x, u, p):\n{lines}", space)
    return space[name]


WRONG = {
    "return u": "returns 2 numbers; must return 1",
    "return [u[0], 1.0, 2.0]": "returns 3 numbers; must return 1",
    "return p.m": "returns 4 numbers; must return 1",
    'return {"z": u[0]}': r"returns \['z'\]; must return \['y'\]",
    'return {"y": u}': r"returns y of shape \(2,\); must be \(1,\)",
    "return None": r"returns nothing; must return \['y'\]",
    "return 'a'": "could not convert string to float",
    "return lookup(p.m, u[0])": "returns 2 numbers; must return 1",
}


@pytest.mark.parametrize("body", WRONG)
def test_what_is_returned_must_fit_the_ports(body):
    with pytest.raises(BlockError, match=WRONG[body]) as caught:
        static(without_source(body), 2, parameters={"m": np.ones((2, 2))})
    assert str(caught.value).startswith("mine.output")
    assert "\n" not in str(caught.value)


def test_equal_code_that_calls_other_functions_keeps_its_own_record():
    body = "return [s(u[0]), w(u[0], 2.0)]"
    first = static(without_source(body, s=math.sin, w=np.minimum), 1, 2)
    other = static(without_source(body, s=math.cos, w=np.maximum), 1, 2)
    alike(first, u=[1.0], outputs=[math.sin(1.0), 1.0])
    alike(other, u=[1.0], outputs=[math.cos(1.0), 2.0])


def by_a_small_number(t, x, u, p):
    return [math.atan2(0.0 * u[0], -1.0), np.where(1.0 / (0.0 * u[0]) > 0, 1.0, -1.0)]


def of_small_numbers(t, x, u, p):
    return [
        1e12 * math.log1p(1e-12 * u[0]),
        1e12 * math.expm1(1e-12 * u[0]),
        math.hypot(1e200 * u[0], 1e200 * u[0]) / 1e200,
        math.hypot(1e-200 * u[0], 1e-200 * u[0]) * 1e200,
    ]


PLAIN = {"m": [[0.0, 1.0], [2.0, 3.0]], "table": [3.0, 5.0, 7.0]}
LONG = {"table": np.arange(200_000.0)}
ROOT = 2.0 * math.sqrt(2.0)
STATIC = {  # -> function, inputs, outputs, parameters
    "a table from its end": (looks_from_the_end, [0.3], [7.0, 5.0, 5.0], PLAIN),
    "a field called as a function": (
        lambda t, x, u, p: [p.gain * u[0], (p.count + 1 - p.count) * u[0]],
        [2.0],
        [6.0, 2.0],
        {"gain": 3.0, "count": 2**70},
    ),
    "a long table": (
        lambda t, x, u, p: [lookup(p.table, u[0]), lookup(p.table[::-3], u[0])],
        [150.5],
        [150.0, 199_999.0 - 450],
        LONG,
    ),
    "a zero's sign": (by_a_small_number, [2.0], [math.pi, 1.0]),
    "the sign of -0": (by_a_small_number, [-2.0], [-math.pi, -1.0]),
    "digits and range": (of_small_numbers, [2.0], [2.0 - 2e-12, 2.0 + 2e-12, ROOT, ROOT]),
}


@pytest.mark.parametrize("case", STATIC)
def test_every_reading_gives_what_is_worked_out_by_hand(case):
    function, u, outputs, *parameters = STATIC[case]
    block = static(function, len(u), len(outputs), parameters=dict(*parameters))
    alike(block, u=u, outputs=outputs)


def of_endless_angles(t, x, u, p):
    return [math.sin(u[0]), math.cos(2.0 * u[0]), math.tan(u[0] * u[0])]


def test_an_angle_that_means_nothing_is_nan():
    for name, ask in readings(static(of_endless_angles, 1, 3)).items():
        if name not in ("python", "control"):  # which ask the function itself
            np.testing.assert_array_equal(ask(0.0, [], [1e16])[1], [math.nan] * 3, err_msg=name)
    u = 2.0**20
    outputs = [math.sin(u), math.cos(2 * u), math.tan(u * u)]
    alike(static(of_endless_angles, 1, 3), u=[u], outputs=outputs)


def negative(t, x, u, p):
    return -u[0]


def test_a_zero_that_comes_through_a_wire_has_no_sign():
    first = Block("first", output=negative, inputs={"u": 1}, outputs={"v": 1})
    second = Block(
        "second",
        output=lambda t, x, u, p: [np.minimum(1.0 / u[0], 5.0), math.atan2(u[0], -1.0)],
        inputs={"v": 1},
        outputs={"y": 2},
    )
    diagram = connect([first, second], external=["u"])
    alike(diagram, u=[0.0], outputs=[0.0, 5.0, math.pi])


# --- the order of operations is the author's ---------------------------------------------------


ORDERS = {  # -> what Python says, worked out by hand
    "a quantiser": (lambda t, x, u, p: (u[0] + p.large) - p.large, [0.0], [2.7], 3.0),
    "less a quantiser": (
        lambda t, x, u, p: u[0] - ((x[0] + p.large) - p.large),
        [2.7],
        [4.125],
        1.125,
    ),
    "k - k": (
        lambda t, x, u, p: x[0] + ((u[0] - u[1]) + (p.large - p.large)),
        [1.1],
        [3e16, 3e16],
        1.1,
    ),
    "a quantiser in a sum": (
        lambda t, x, u, p: np.sum((u + p.large) - p.large),
        [0.0],
        [2.7, 0.4, -1.2],
        2.0,
    ),
    "an empty product": (
        lambda t, x, u, p: np.arctan2(-0.0 * np.prod(u[:0]), -1.0),
        [0.0],
        [1.0],
        -math.pi,
    ),
}


@pytest.mark.parametrize("case", ORDERS)
def test_the_order_of_operations_is_kept(case):
    update, x, u, wanted = ORDERS[case]
    block = Block(
        "mine",
        update=update,
        inputs={"u": len(u)},
        states={"x": 1},
        parameters={"large": 1.5 * 2.0**52},
    )
    for name, ask in readings(block).items():
        if name != "symbolic":  # SymPy's numbers do not round
            assert ask(0.0, x, u)[0] == [wanted], name


@pytest.mark.parametrize("value", [[[1.0], [2.0, 3.0]], 1j, "a", None])
def test_parameters_that_are_no_numbers_are_refused(value):
    with pytest.raises(BlockError, match=r"mine\.large"):
        static(negative, 1, parameters={"large": value})


@pytest.mark.parametrize("system", [control.tf([1], [1, 1]), 5, None])
def test_what_is_no_system_of_states_is_refused(system):
    with pytest.raises(ClptError, match="must be a diagram"):
        readings(system)


def test_a_diagram_of_no_blocks_is_refused():
    with pytest.raises(DiagramError, match="no blocks"):
        connect([])


# --- what a run is given -----------------------------------------------------------------------


def jumping(breakpoints):
    return Block(
        "mine",
        update=lambda t, x, u, p: np.where(p.interval > 0.5, -1.0, 1.0) + u[0],
        inputs={"u": 1},
        states={"x": 1},
        parameters={"interval": -1.0},
        breakpoints=breakpoints,
    )


@pytest.mark.parametrize("times", [[1.5, 0.5], [0.5, math.nan], None, 0.5, ["a"], [[0.5, 1.5]]])
@pytest.mark.parametrize("engine", ["python", "native"])
def test_breakpoints_that_are_no_increasing_times_are_refused(times, engine):
    with pytest.raises(BlockError, match="must be increasing times"):
        clpt.simulate(jumping(lambda p, t0, t1: times), [0.0, 2.0], engine=engine)
