"""What cannot be read says which function, line and cause, and runs in Python."""

import array
import functools
import inspect
import itertools
import random
import time
import types
from collections import deque

import control
import numpy as np
import pandas as pd
import pytest
from recorded import run, static
from scipy.optimize import brentq

import clpt_control as clpt
from clpt_control.equations import Block, system
from clpt_control.equations.arrays import Unread
from clpt_control.equations.reading import read
from clpt_control.errors import BlockError

STATE = [0.0]
NOISE = np.random.default_rng(1)


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


def remembers(t, x, u, p):
    STATE[0] += 1.0
    return u[0] + STATE[0]


def keeps_the_last(t, x, u, p):
    last, STATE[0] = STATE[0], u[0]
    return last + u[0]


def solves(t, x, u, p):
    return brentq(lambda a: a**3 + a - u[0], -9.0, 9.0)  # here


def is_text(t, x, u, p):
    return float(f"{u[0]:.3f}")  # here


def takes_eigenvalues(t, x, u, p):
    return np.linalg.eigvals(np.outer(u, u)).max().real  # here


def asks_too_often(t, x, u, p):
    y = 0.0
    for k in range(12):
        y += 1.0 if u[0] * k > u[1] * k**2 - 1 else -1.0
    return y


def helper(a):
    return float(f"{a:.2f}")  # here


def through_a_helper(t, x, u, p):
    return helper(u[0])


LINES = {  # the line is that of the comment
    counts_by_a_signal: "",
    waits_for_a_signal: "",
    solves: "brentq",
    is_text: "",
    takes_eigenvalues: "eigvals",
}
PLACE, HIT, OFTEN = np.array([0]), np.zeros(1, dtype=bool), array.array("d", [0.0])
HISTORY, LATE, SEEN = [], deque([0.0] * 3, maxlen=3), set()
COUNT, MODULE = itertools.count(), types.ModuleType("kept")
MODULE.calls = 0


def aims(t, x, u, p):
    if u[0] > 0.1:
        PLACE[0] += 1
    return u[0] - (1.0 if PLACE[0] > 9 else 2.0)


def latches(t, x, u, p):
    if u[0] > 0.1:
        HIT[0] = True
    return 0.0 if HIT[0] else 1.0


def adds_up(t, x, u, p):
    OFTEN[0] += 1.0
    return 0.0 if OFTEN[0] > 99 else 1.0


def looks_back(t, x, u, p):
    HISTORY.append(u[0])
    return u[0] if len(HISTORY) < 50 else HISTORY[-50]


def delays(t, x, u, p):
    LATE.append(u[0])
    return LATE[0]


def visits(t, x, u, p):
    if u[0] > 0.1:
        SEEN.add("here")
    return 1.0 if SEEN else 0.0


def visits_two(t, x, u, p):
    before = "there" in SEEN
    if u[0] > 1.0:
        SEEN.add("here")
    elif u[0] < -1.0:
        SEEN.add("there")
    return 1.0 if before else 0.0


def counts_calls_in_a_module(t, x, u, p):
    MODULE.calls += 1
    return 1.0 if MODULE.calls > 999 else 0.0


class Sensor:
    calls = 0

    def lost(self):
        return NOISE.random() < 1e-9

    def late(self):
        Sensor.calls += 1
        return Sensor.calls > 999

    def chance(self, t, x, u, p):
        return 0.0 if self.lost() else u[0]

    def memory(self, t, x, u, p):
        return 0.0 if self.late() else u[0]


class Machine:
    phase, since, pair, armed, fired = "rest", None, ("rest", 0), False, False

    def __init__(self):
        self.words = []

    def text(self, t, x, u, p):
        if u[0] > 1.0:
            self.phase = "work"
        if u[0] < -1.0:
            self.phase = "rest"
        return 1.0 if self.phase == "work" else 0.0

    def two_words(self, t, x, u, p):
        before = self.pair
        if u[0] > 1.0:
            self.pair = ("work", 3)
        if u[1] > 1.0:
            self.pair = ("rest", 3)
        return 1.0 if before == ("work", 3) else 0.0

    def row_of_words(self, t, x, u, p):
        before = "work" in self.words
        if u[0] > 1.0:
            self.words.append("work")
        return 1.0 if before else 0.0

    def two_flags(self, t, x, u, p):
        before = self.armed and not self.fired
        if u[0] > 1.0:
            self.armed = True
        if u[0] < -1.0:
            self.fired = True
        return 1.0 if before else 0.0

    def time(self, t, x, u, p):
        late = 0.0 if self.since is None else t - self.since
        self.since = t
        return late

    def lazily(self, t, x, u, p):
        self.calls = getattr(self, "calls", 0) + 1
        return 1.0 if self.calls > 99 else 0.0


class Plant:
    """Computes what does not change once."""

    inverse = None

    @functools.cached_property
    def mass(self):
        return np.diag([1.0, 2.0, 4.0])

    def response(self, t, x, u, p):
        if self.inverse is None:
            self.inverse = np.linalg.inv(self.mass)
        return (self.inverse @ u)[2]


HIDING = (  # of most the first two readings are alike
    lambda t, x, u, p: u[0] * random.random(),
    *(remembers, keeps_the_last),
    lambda t, x, u, p: 0.0 if NOISE.random() < 1e-9 else u[0],
    lambda t, x, u, p: 0.0 if np.random.rand() < 1e-9 else u[0],  # noqa: NPY002
    lambda t, x, u, p: 0.0 if random.random() < 1e-9 else u[0],
    lambda t, x, u, p: 0.0 if np.random.default_rng().random() < 1e-9 else u[0],
    lambda t, x, u, p: 0.0 if time.time() > 1e11 else u[0],
    lambda t, x, u, p: u[0] if next(COUNT) < 999 else 0.0,
    *(aims, latches, adds_up, looks_back, delays, visits, visits_two),
    counts_calls_in_a_module,
    *(Sensor().chance, Sensor().memory),
    *(Machine().text, Machine().two_words, Machine().row_of_words, Machine().two_flags),
    *(Machine().time, Machine().lazily),
)
U = [0.3, -0.7, 2.0]


def marked_line(function):
    lines, first = inspect.getsourcelines(function)
    return first + next(k for k, line in enumerate(lines) if line.rstrip().endswith("# here"))


def said(function):
    with pytest.raises(Unread) as caught:
        static(function).array_record("output")
    sentence = str(caught.value)
    assert sentence.startswith((f"mine.output: {function.__name__}", "mine.output: <lambda>"))
    assert "\n" not in sentence
    return sentence


@pytest.mark.parametrize("function", LINES, ids=lambda f: f.__name__)
def test_unread_by_function_line_and_cause(function):
    sentence = said(function)
    assert f"line {marked_line(function)}:" in sentence
    assert LINES[function] in sentence


def test_a_helper_is_named_with_its_own_line():
    with pytest.raises(Unread, match=rf"helper, line {marked_line(helper)}:"):
        static(through_a_helper).array_record("output")


def kept():
    calls = (PLACE[0], HIT[0], OFTEN[0], MODULE.calls, Sensor.calls)
    return calls, [*HISTORY], [*LATE], {*SEEN}, NOISE.bit_generator.state


@pytest.mark.parametrize("function", HIDING, ids=lambda f: f.__name__)
def test_a_state_or_chance_that_hides_is_seen_by_what_readings_change(function):
    block, before = static(function), kept()
    with pytest.raises(Unread):
        block.array_record("output")
    assert kept() == before


def test_what_is_kept_and_not_read_may_be():
    def logs(t, x, u, p):
        HISTORY.append(float(u[0]))
        MODULE.calls += 1
        return 2.0 * u[0]

    block, before = static(logs), kept()
    assert block.array_record("output").operations
    assert kept() == before


def test_what_is_computed_once_may_be_kept():
    """Whose parts are kept by libraries too: pandas' Series finds its places once."""
    table = pd.Series({"a": 0.5, "b": 2.0})
    for function in (Plant().response, lambda t, x, u, p: table["b"] * u[0] - table.a):
        block = static(function)
        assert block.array_record("output").operations
        assert run(block, "output", 0.0, [], U) == pytest.approx(function(0.0, [], U, None))


def test_too_many_ways_are_not_read():
    assert "ways" in said(asks_too_often)


@pytest.mark.parametrize("function", [solves, is_text, through_a_helper, asks_too_often])
def test_what_is_not_read_runs_in_python(function):
    block = static(function)
    assert block.output(0.0, [], U) == run(block, "output", 0.0, [], U)
    assert block.feedthrough  # for all that is known


def test_the_record_of_another_role_is_there_all_the_same():
    block = Block(
        "mine", update=lambda t, x, u, p: -x, output=is_text, inputs={"u": 1}, states={"x": 1},
        outputs={"y": 1},
    )  # fmt: skip
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
    with pytest.raises(BlockError, match=rf"^mine\.output.*{words}") as caught:
        static(function)
    assert "\n" not in str(caught.value)


def test_why_a_function_cannot_be_read_is_kept_as_its_record_is(monkeypatch):
    asked = []

    def counted(*given):
        asked.append(1)
        return read(*given)

    monkeypatch.setattr(system, "read", counted)
    halve = control.nlsys(waits, None, inputs=0, states=1, outputs=1, params={"k": 1.0}, name="h")
    for params, count in ((None, 1), (None, 1), ({"k": 0.7}, 2), ({"k": 0.7}, 2)):
        with pytest.warns(UserWarning, match="h runs in Python.*no `while` on a signal"):
            run = clpt.simulate(halve, [0.0, 0.1], 0.0, [1.0], params)
        assert len(asked) == count
        assert run.attrs["engine"] == "python"


def waits(t, x, u, params):
    y = abs(x[0]) + 1.0
    while y > 0.001:
        y = y / 2.0
    return -params["k"] * y
