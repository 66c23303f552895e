"""Truth values, whole numbers, what is changed in place or kept: as Python has it, or refused.

Each of these once gave another number than Python does, or an exception of the reader's own.
"""

import math
from collections.abc import Iterable, Sized

import control
import numpy as np
import pytest
from careless_functions import (
    CHART,
    COAST,
    COLUMN,
    FILLED,
    FLAT,
    FUNCTIONS,
    LAP,
    LEVER,
    RATIOS,
    RESCALED,
    SCATTERED,
    SPLINE,
    SQUARE,
    STEPPED,
    TRACK,
    is_printed,
    shortens,
)

import clpt_control as clpt
from clpt_control.diagrams.wiring import wiring_of
from clpt_control.equations.arrays import Unread
from clpt_control.equations.at_many import leaf_values

POINTS = [
    (t, x, u)
    for t, x in zip(
        [0.0, 2.5, 3.0, 7.0, 1.0],
        [[0.3, -0.7, 2.0], [-1.2, 0.4, -0.1], [1.0, 1.0, 1.0], [0.0, 0.0, 0.0], [2.5, 1.5, -3.0]],
        strict=True,
    )
    for u in ([0.5, -0.25], [0.0, 2.0], [-1.0, 0.15])
]


def block_of(function, params):
    """Return a block of the function's outputs, as python-control would have them."""
    size = np.size(function(*map(np.array, POINTS[0]), dict(params)))
    system = control.nlsys(
        lambda t, x, u, p: 0.0 * x, function, inputs=2, outputs=size, states=3, params=params
    )
    return wiring_of(system).nodes[0].system


def reads_as_python_runs(function, params):
    block = block_of(function, params)
    record = block.array_record("output")
    for t, x, u in POINTS:
        x, u = np.array(x), np.array(u)
        found = record.values(leaf_values(block, t, x, u, block.parameters), block.sizes)
        with np.errstate(all="ignore"):
            wanted = np.ravel(np.asarray(function(t, x.copy(), u.copy(), dict(params)), float))
        np.testing.assert_allclose(np.ravel(found), wanted, rtol=1e-13, atol=1e-13)


def beside(number, cut):
    """An array of 0 and a number, into which another is written: cut, if both were whole."""
    y = np.array([0, number])
    y[0] = cut
    return y


COUNTED = {  # whole numbers, and what is none though it is made of them
    "int": lambda a, b: int(a),
    "round": lambda a, b: 1 - round(a),
    "math.floor": lambda a, b: math.floor(a) % 3,
    "np.int64": lambda a, b: abs(np.int64(a)),
    "divmod": lambda a, b: divmod(int(a), 2)[0],
    "prod": lambda a, b: math.prod([int(a), int(b)]),
    "sum": lambda a, b: sum(int(one) for one in (a, b)),
    "np.sum": lambda a, b: np.sum([int(a), int(b)]),
    "np.max": lambda a, b: np.max([int(a), 1]),
    "an element": lambda a, b: np.array([int(a), 3])[1] + np.array([int(a), 3])[0],
    "truths": lambda a, b: np.sum(np.array([a, b]) > 0.0),
    "float": lambda a, b: float(int(a)),
    "np.float64": lambda a, b: np.float64(int(a)),
    "np.fabs": lambda a, b: np.fabs(int(a)),
    "math.pow": lambda a, b: math.pow(int(a), 2),
    "pow": lambda a, b: (3 + int(a)) ** -1,
    "digits": lambda a, b: round(a, 0),
}
ONE_LINE = {  # as Python has them
    **{
        f"cuts by {name}": lambda t, x, u, p, f=f: beside(f(x[0], x[1]), u[1])
        for name, f in COUNTED.items()
    },
    "takes bits of a parameter": lambda t, x, u, p: [x[0] * (p["n"] & 1)],
    "inverts the bits of a small one": lambda t, x, u, p: x[0] * ~p["short"],
    # truth values
    "truth times truth": lambda t, x, u, p: [
        (x[0] > 0) * (x[1] > 0) * u[0],
        1.0 * np.maximum(x[0] > 0, x[1] > 0),
    ],
    "bits of truths": lambda t, x, u, p: np.where(
        (x > 0) ^ (x < 1) | ~(x > -1) & (u[0] > 0), 1.0, 0.0
    ),
    "counted": lambda t, x, u, p: [
        *np.cumsum(x > 0),
        np.sum(x > 0),
        sum([x[0] > 0, x[1] > 0]),
        np.prod(x > 0),
    ],
    "an array of truths": lambda t, x, u, p: np.array([x[0] > 0, x[1] > 0]),
    # whole numbers and short floats
    "whole numbers": lambda t, x, u, p: [*(p["A"] // 2 * x[1]), p["n"] // 2 * x[0], p["n"] ** -1],
    "sorted places": lambda t, x, u, p: np.argsort(x),
    "a constant of whole numbers": lambda t, x, u, p: np.array([1, 2]),
    "short": lambda t, x, u, p: [*(p["short"] + p["short"]), p["f"] * 3, p["f"] * x[0]],
    "filled and cut": lambda t, x, u, p: np.full(3, x[0], int),
    # what Python asks
    "asked what it is": lambda t, x, u, p: [
        hasattr(x, "__len__"),
        hasattr(x[0], "__len__"),
        type(x) is np.ndarray,
        isinstance(x, Iterable | Sized),
        isinstance(x[0], Sized),
        isinstance(x[0], float),
        isinstance(x[0], int | list),
    ],
    "side by side": lambda t, x, u, p: [*np.r_[x, 1.0, u[:1]], *np.c_[x, x[::-1]].ravel()],
    "by methods of ufuncs": lambda t, x, u, p: [
        np.maximum.reduce([x[0], u[0], x[2]]),
        *np.add.accumulate(x),
        *np.sum(np.outer(x, x), axis=1, keepdims=True).ravel(),
    ],
    "exact": lambda t, x, u, p: [math.hypot(1e200 * x[0], 1.0, 2.0) / 1e200],
    "minus zero": lambda t, x, u, p: [
        np.copysign(1.0, np.round(0.3 * x[0])),
        math.copysign(1.0, round(0.3 * x[0])),
    ],
    "beside another table": lambda t, x, u, p: [LEVER.arm(x[0])],
    # tables
    "slopes of splines": lambda t, x, u, p: [*SPLINE(x), *SPLINE(x, 1), SPLINE(x[0], nu=2)],
    "a track": lambda t, x, u, p: [
        *TRACK(t),
        *TRACK(x[0], 1),
        *TRACK(x).ravel(),
        *LAP(t),
        *LAP(x[1], 2),
    ],
    "a chart": lambda t, x, u, p: [
        *CHART(x[:2]),
        CHART((x[1], u[0])),
        *CHART([[x[0], x[1]], [x[2], u[1]]]),
        *CHART([[[x[0], x[1]], [x[2], u[1]]], [[u[0], x[1]], [x[1], x[2]]]])[1],
        *COAST((x, x[::-1])),
        COLUMN([x[0], u[1], x[1]])[0],
    ],
    "a chart of scattered points": lambda t, x, u, p: [
        SCATTERED(x[0], u[0]),
        SCATTERED(x[:2])[0],
        FLAT(5.0 + x[0], 0.1 * abs(u[0])),
    ],
}
ONE_LINE_REFUSED = {  # what would be another number
    "takes the nearest of a chart": lambda t, x, u, p: STEPPED(x[:2]),
    "fills columns": lambda t, x, u, p: FILLED(x[0]),
    "reads a rescaled chart": lambda t, x, u, p: RESCALED(x[0], u[0]),
    "searches what decreases": lambda t, x, u, p: np.searchsorted([2.0, 1.0, 0.0], x),
    "gives a part": lambda t, x, u, p: np.einsum("ii->i", np.outer(x, x)),
    "limits some": lambda t, x, u, p: np.clip(x, -0.5, 0.5, where=x > 0.0, out=x.copy()),
    "means some": lambda t, x, u, p: [np.mean(x, where=[True, True, False])],
    "rounds a parameter": lambda t, x, u, p: [round(p["k"], 1) * x[0]],
    "writes by place": lambda t, x, u, p: np.max(np.outer(x, u), 0, np.zeros(2)),
    # truth values
    "adds stacked truths": lambda t, x, u, p: (
        np.array([x[0] > 0, x[1] > 0]) + np.array([True, False])
    ),
    "adds chosen truths": lambda t, x, u, p: [
        np.where(x[0] > 0, x[1] > 0, True) + np.where(x[1] > 0, True, False)
    ],
    "multiplies matrices of truths": lambda t, x, u, p: [np.dot(x > 0, x > -1)],
    "takes the root of a truth": lambda t, x, u, p: [np.exp(x[0] > 0)],
    # whole numbers and short floats
    "sums short": lambda t, x, u, p: [x.sum(dtype=np.float32), np.mean(x, dtype=np.float16)],
    "wraps around": lambda t, x, u, p: (100 * x).astype(np.int8),
    "takes bits": lambda t, x, u, p: [int(x[0]) & 1],
    "makes all like the first": lambda t, x, u, p: np.vectorize(lambda v: 1 if v > 0 else 0.5 * v)(
        x
    ),
    "cuts the larger": lambda t, x, u, p: beside(max(int(x[0]), u[0]), u[1]),
    "asks for the type of one of two": lambda t, x, u, p: [type(max(0, x[0])) is int],
    "rounds as python": lambda t, x, u, p: [round(float(u[1]), 1)],
    "inverts a truth of Python": lambda t, x, u, p: [1.0 if ~(float(x[0]) > 0) else 2.0],
    # what Python asks
    "seeks in a set": lambda t, x, u, p: [1.0 if int(x[0]) in {0, 1} else 0.0],
    "sums where": lambda t, x, u, p: [np.sum(x[x > 0])],
    "counts others": lambda t, x, u, p: [len(set(x))],
    "reads in the order of memory": lambda t, x, u, p: np.outer(x, u).T.ravel(order="K"),
    "interpolates backwards": lambda t, x, u, p: [
        np.interp(x[0], [2.0, 1.0, 0.0], [5.0, 0.0, 1.0])
    ],
    "multiplies as a matrix": lambda t, x, u, p: np.asarray(SQUARE * np.diag(u)).ravel(),
}
PARAMS = {"n": 3, "A": np.array([3, -3]), "f": np.float32(0.1), "short": np.uint8([200, 3])}
PARAMS |= {"zero": 0.0, "k": 1.15}
READ = ONE_LINE | {name: f for name, f in FUNCTIONS.items() if name.startswith("is ")}
REFUSED = ONE_LINE_REFUSED | {name: f for name, f in FUNCTIONS.items() if name not in READ}


@pytest.mark.parametrize("name", READ)
def test_numbers_of_every_kind_are_as_python_has_them(name):
    reads_as_python_runs(READ[name], PARAMS)


def test_nothing_is_printed_while_a_function_is_read(capsys):
    block = block_of(is_printed, PARAMS)
    capsys.readouterr()
    block.array_record("output")
    assert capsys.readouterr().out == ""


@pytest.mark.filterwarnings("ignore:the matrix subclass")
@pytest.mark.parametrize("name", REFUSED)
def test_what_would_be_another_number_is_refused(name):
    with pytest.raises(Unread, match=r"output: "):
        block_of(REFUSED[name], PARAMS).array_record("output")


@pytest.mark.filterwarnings("ignore:.*runs in Python")
@pytest.mark.parametrize(
    "function",
    [
        lambda t, x, u, p: [(x[0] > 0) + (x[1] > 0)],
        shortens,
        lambda t, x, u, p: [RATIOS.get(int(x[0]), 9.0)],
    ],
)
def test_what_is_refused_runs_as_python_control_runs_it(function):
    def rate(t, x, u, p):
        return -x + np.sum(function(t, x, u, p))

    system = control.nlsys(rate, None, inputs=2, outputs=3, states=3, name="kept")
    found = clpt.simulate(system, [0.0, 0.5], 0.0, [0.3, 0.2, 0.1])
    assert found.attrs["engine"] == "python"
