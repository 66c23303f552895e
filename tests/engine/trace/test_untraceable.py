"""What cannot be read says which function, line and cause, and runs in Python."""

import inspect

import control
import numpy as np
import pytest
from engine_runs import Unread
from recorded_blocks import run, static
from scipy.optimize import brentq
from traced_calls import traced_calls

import clpt_control as clpt
from clpt_control import Block, BlockError


def counts_by_a_signal(t, x, u, p):
    y = 0.0
    for _ in range(int(1e6 * u[0])):  # here
        y += 1.0
    return y


def waits_for_a_signal(t, x, u, p):
    y = np.abs(u[0]) + 1.0
    while y > 0.001:  # here
        y = y / 2.0
    return y


def solves(t, x, u, p):
    return brentq(lambda a: a**3 + a - u[0], -9.0, 9.0)  # here


def is_text(t, x, u, p):
    return float(f"{u[0]:.3f}")  # here


def takes_eigenvalues(t, x, u, p):
    return np.linalg.eigvals(np.outer(u, u)).max().real  # here


def asks_too_often(t, x, u, p):
    y = 0  # whole numbers of Python are not merged
    for k in range(12):
        y += 1 if u[0] * k > u[1] * k**2 - 1 else -1
    return y * u[0]


def helper(a):
    return float(f"{a:.2f}")  # here


def through_a_helper(t, x, u, p):
    return helper(u[0])


LINES = {  # -> who is named with the line of the comment, and why
    counts_by_a_signal: (counts_by_a_signal, "counts with a signal"),
    waits_for_a_signal: (waits_for_a_signal, "no `while` on a signal"),
    solves: (solves, "brentq"),
    is_text: (is_text, "convert string"),
    takes_eigenvalues: (takes_eigenvalues, "eigvals"),
    through_a_helper: (helper, ""),
}
U = [0.3, -0.7, 2.0]


def marked_line(function):
    lines, first = inspect.getsourcelines(function)
    return first + next(
        k for k, line in enumerate(lines) if line.rstrip().endswith("# here")
    )


@pytest.mark.parametrize("function", LINES, ids=lambda f: f.__name__)
def test_unread_by_function_line_and_cause(function):
    named, why = LINES[function]
    said = rf"\Amine\.output: ({named.__name__}|<lambda>), line {marked_line(named)}: .*{why}.*\Z"
    with pytest.raises(Unread, match=said):
        static(function).array_record("output")


def test_too_many_ways_are_not_read():
    with pytest.raises(
        Unread, match="asks_too_often has more than 256 execution paths"
    ):
        static(asks_too_often).array_record("output")


@pytest.mark.parametrize(
    "function", [solves, is_text, through_a_helper, asks_too_often]
)
def test_what_is_not_read_runs_in_python(function):
    block = static(function)
    assert block.output(0.0, [], U) == run(block, "output", 0.0, [], U)
    assert block.feedthrough  # for all that is known


def test_the_record_of_another_role_is_there_all_the_same():
    ports = {"inputs": {"u": 1}, "states": {"x": 1}, "outputs": {"y": 1}}
    block = Block("mine", update=lambda t, x, u, p: -x, output=is_text, **ports)
    assert block.array_record("update").shapes == ((1,),)
    with pytest.raises(Unread):
        block.array_record("output")


# --- mistakes ---------------------------------------------------------------------------------


def beyond(t, x, u, p):
    return u[5]


@pytest.mark.parametrize(
    ("function", "words"),
    [
        (beyond, r"beyond, line \d+: IndexError"),
        (lambda t, x, u, p: u.speed, r"line \d+: .*no port 'speed'; there are u"),
        (lambda t, x, u, p: wibble(u[0]), r"line \d+: NameError.*wibble"),  # noqa: F821
        (lambda t, x, u: u, "<lambda>: TypeError"),
    ],
)
def test_a_mistake_is_told_where_the_block_is_made(function, words):
    with pytest.raises(BlockError, match=rf"\Amine\.output.*{words}.*\Z"):
        static(function)


def test_why_a_function_cannot_be_read_is_kept_as_its_record_is():
    def waits(t, x, u, params):
        return -params["k"] * waits_for_a_signal(t, x, x, params)

    halve = control.nlsys(
        waits, None, inputs=0, states=1, outputs=1, params={"k": 1.0}, name="h"
    )
    new = ((None, True), (None, False), ({"k": 0.7}, True), ({"k": 0.7}, False))
    for params, is_new in new:
        with (
            pytest.warns(UserWarning, match="h runs in Python.*no `while` on a signal"),
            traced_calls("waits") as traced,
        ):
            run = clpt.simulate(halve, [0.0, 0.1], 0.0, [1.0], params)
        assert (bool(traced), run.attrs["engine"]) == (is_new, "python")
