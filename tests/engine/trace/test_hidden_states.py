"""What a function keeps from one call to the next, and reads there, is seen and refused."""

import datetime
import functools
import io
import itertools
import random
import time
from array import array
from collections import deque
from contextvars import ContextVar
from types import ModuleType

import control
import numpy as np
import pandas as pd
import pytest
from engine_runs import Unread
from recorded_blocks import run, static
from scipy.interpolate import interp1d

import clpt_control as clpt

U = [0.3, -0.7, 2.0]
ROW, HISTORY, LATE, SEEN = [0.0], [], deque([0.0] * 3, maxlen=3), set()
TABLE, PLACE, OFTEN = {"last": np.zeros(3)}, np.array([0]), array("d", [0.0])
COUNT, MODULE, NOISE = itertools.count(), ModuleType("kept"), np.random.default_rng(1)
MODULE.calls = 0
BYTES, TEXT, VIEW = bytearray(1), io.StringIO(), memoryview(bytearray(8)).cast("d")
MIXED, NAMED = np.array([0, None], dtype=object), np.zeros(1, dtype=[("calls", float)])
SWITCH, CALLS = False, ContextVar("calls", default=0.0)


class Bolt:
    """Keeps in slots."""

    __slots__ = ("last",)


BOLT = Bolt()
BOLT.last = 0.0


def in_a_list(t, x, u, p):
    ROW[0] += 1.0
    return u[0] + ROW[0]


def a_signal_in_a_list(t, x, u, p):
    last, ROW[0] = ROW[0], u[0]
    return last + u[0]


def on_itself(t, x, u, p):
    on_itself.n = getattr(on_itself, "n", 0) + 1
    return u[0] * on_itself.n


def in_a_set(t, x, u, p):
    before = "there" in SEEN
    if u[0] > 1.0:
        SEEN.add("here")
    elif u[0] < -1.0:
        SEEN.add("there")
    return 1.0 if before else 0.0


def in_a_dict(t, x, u, p):
    rate, TABLE["last"] = u - TABLE["last"], u.copy()
    return rate[0]


def in_an_array(t, x, u, p):
    if u[0] > 0.1:
        PLACE[0] += 1
    return u[0] - (1.0 if PLACE[0] > 9 else 2.0)


def in_pythons_array(t, x, u, p):
    OFTEN[0] += 1.0
    return 0.0 if OFTEN[0] > 99 else 1.0


def in_an_array_of_objects(t, x, u, p):
    last, MIXED[0] = MIXED[0], u[0]
    return u[0] - last


def in_an_array_of_names(t, x, u, p):
    NAMED["calls"] += 1.0
    return 0.0 if NAMED["calls"][0] > 999 else 1.0


def in_a_view(t, x, u, p):
    VIEW[0] += 1.0
    return 0.0 if VIEW[0] > 999 else 1.0


def in_a_variable_of_the_context(t, x, u, p):
    CALLS.set(CALLS.get() + 1.0)
    return 0.0 if CALLS.get() > 999 else 1.0


def in_a_module(t, x, u, p):
    MODULE.calls += 1
    return 1.0 if MODULE.calls > 999 else 0.0


def in_a_global(t, x, u, p):
    global SWITCH
    SWITCH = u[0] > 0.5 or (SWITCH and u[0] > -0.5)
    return 1.0 if SWITCH else 0.0


def in_slots(t, x, u, p):
    last, BOLT.last = BOLT.last, u[0]
    return u[0] - last


class Machine:
    """Keeps in its attributes, in those of its class, and in what they hold."""

    calls, phase, since, armed, fired = 0, "rest", None, False, False

    def __init__(self):
        self.angles, self.inertia = [0.1, -0.2, 0.3], np.diag([2.0, 3.0, 1.0])
        self.drag = interp1d([-3.0, 0.0, 3.0], [2.0, 0.5, 1.0])

    def a_draw(self, t, x, u, p):
        return 0.0 if NOISE.random() < 1e-9 else u[0]

    def in_its_class(self, t, x, u, p):
        Machine.calls += 1
        return 0.0 if Machine.calls > 999 else u[0]

    def a_word(self, t, x, u, p):
        if u[0] > 1.0:
            self.phase = "work"
        if u[0] < -1.0:
            self.phase = "rest"
        return 1.0 if self.phase == "work" else 0.0

    def two_flags(self, t, x, u, p):
        before = self.armed and not self.fired
        if u[0] > 1.0:
            self.armed = True
        if u[0] < -1.0:
            self.fired = True
        return 1.0 if before else 0.0

    def the_time(self, t, x, u, p):
        since, self.since = self.since, t
        return 0.0 if since is None else t - since

    def an_attribute_that_is_new(self, t, x, u, p):
        self.gone = getattr(self, "gone", 0.0) + self.drag(u[0])
        return self.gone

    def a_list_that_it_reads(self, t, x, u, p):
        self.angles.append(self.angles[int(abs(u[0]))])
        return self.angles[-4]

    def another_matrix(self, t, x, u, p):
        self.inertia = 2.0 * self.inertia
        return self.inertia.dot(u)[0]


MACHINE = Machine()


HIDING = (  # of most the first two readings are alike
    *(in_a_list, a_signal_in_a_list, in_a_set, in_a_dict),
    *(in_an_array, in_pythons_array, in_a_module, in_a_global, in_slots, on_itself),
    *(
        in_an_array_of_objects,
        in_an_array_of_names,
        in_a_view,
        in_a_variable_of_the_context,
    ),
    *(
        getattr(MACHINE, name)
        for name, own in vars(Machine).items()
        if name[0] != "_" and callable(own)
    ),
    lambda t, x, u, p: (
        HISTORY.append(u[0]),
        u[0] if len(HISTORY) < 50 else HISTORY[-50],
    )[1],
    lambda t, x, u, p: (HISTORY.append(u[0]), u[0] if len(HISTORY) < 5000 else 0.0)[1],
    lambda t, x, u, p: (LATE.append(u[0]), LATE[0])[1],
    lambda t, x, u, p: (OFTEN.append(0.0), u[0] if len(OFTEN) < 5000 else 0.0)[1],
    lambda t, x, u, p: (BYTES.append(0), u[0] if len(BYTES) < 5000 else 0.0)[1],
    lambda t, x, u, p: (TEXT.write("a"), u[0] if TEXT.tell() < 5000 else 0.0)[1],
    lambda t, x, u, p: 0.0 if np.random.rand() < 1e-9 else u[0],  # noqa: NPY002
    lambda t, x, u, p: 0.0 if random.random() < 1e-9 else u[0],
    lambda t, x, u, p: 0.0 if np.random.default_rng().random() < 1e-9 else u[0],
    lambda t, x, u, p: 0.0 if time.time() > 1e11 else u[0],
    lambda t, x, u, p: 0.0 if datetime.datetime.now().year > 9000 else u[0],
    lambda t, x, u, p: u[0] if next(COUNT) < 999 else 0.0,
)


def kept():
    shared = (
        [*ROW],
        [*HISTORY],
        [*LATE],
        {*SEEN},
        PLACE[0],
        OFTEN[0],
        MODULE.calls,
        SWITCH,
    )
    own = [*MACHINE.angles], [*OFTEN], {k: id(v) for k, v in vars(MACHINE).items()}
    texts = TEXT.getvalue(), TEXT.tell(), bytes(BYTES), VIEW[0]
    others = *texts, [*MIXED], NAMED["calls"][0], CALLS.get()
    return (
        shared,
        own,
        others,
        Machine.calls,
        vars(on_itself).copy(),
        NOISE.bit_generator.state,
    )


@pytest.mark.parametrize("function", HIDING)
def test_a_state_or_chance_that_hides_is_seen_and_all_is_left_as_it_was(function):
    block, before = static(function), kept()
    with pytest.raises(Unread):
        block.array_record("output")
    assert kept() == before
    for one in (BOLT.last, TABLE["last"]):
        assert np.asarray(one).dtype == float  # no tracer
    assert type(MACHINE.drag) is interp1d


@pytest.mark.long
@pytest.mark.filterwarnings("ignore:.*runs in Python")
@pytest.mark.filterwarnings("ignore:.*hidden state")
def test_what_hides_in_params_runs_as_python_control_runs_it():
    def rate(t, x, u, params):
        last, params["last"] = params.get("last", 0.0), x[0]
        return -x + x[0] - last

    system = control.nlsys(rate, None, inputs=0, outputs=1, states=1, name="kept")
    assert clpt.simulate(system, [0.0, 0.5], 0.0, [0.3]).attrs["engine"] == "python"


def counts():
    n = 0

    def count(x):
        nonlocal n
        n += 1
        return n * x

    return count


def delays():
    past = [0.0]

    def delay(x):
        past.append(x[0])
        return np.array([past[-2] + np.sin(past[-1])])

    return delay


class Sum:
    total = 0.0

    def __call__(self, x):
        self.total += x[0]
        return np.array([self.total])


def numbered():
    own = Plant()
    own.numbers = (0.1 * k for k in range(99))
    return lambda x: x + next(own.numbers)


def far():
    own = Plant()
    own.parts = [{"loops": (Plant(), [0.0])}]

    def integral(x):
        own.parts[0]["loops"][1][0] += 1.0
        return x + own.parts[0]["loops"][1][0]

    return integral


@pytest.mark.filterwarnings("ignore:.*runs in Python")
@pytest.mark.parametrize("holder", ["object", "system"])
@pytest.mark.parametrize(
    "make",
    [
        *(counts, delays, Sum, numbered, far),
        *(
            lambda: Sum().__call__,
            lambda: functools.partial(lambda f, x: f(x), delays()),
        ),
    ],
)
def test_what_a_function_of_an_object_keeps_is_left_as_it_was(make, holder):
    def system():
        inner, own = (
            control.nlsys(lambda t, x, u, p: f(x), states=1, inputs=0, dt=1),
            Plant(),
        )
        own.f = f = make()
        held = {
            "object": lambda t, x: own.f(x),
            "system": lambda t, x: inner.dynamics(t, x, []),
        }
        return control.nlsys(
            lambda t, x, u, p: 0.5 * x + held[holder](t, x), states=1, dt=1
        )

    times = np.arange(6)
    found = clpt.simulate(system(), times, initial_state=[1.0])
    assert found.attrs["engine"] == "python"
    expected = control.input_output_response(system(), times, 0, [1.0]).states[0]
    np.testing.assert_array_equal(found.states[:, 0], expected)


def test_a_function_that_a_system_has_from_around_its_own_is_machine_code():
    def turned(x):
        return np.array([x[1], -np.sin(x[0])])

    swing = control.nlsys(lambda t, x, u, p: turned(x), states=2, inputs=0)
    back = control.nlsys(
        lambda t, x, u, p: -swing.dynamics(t, x, []), states=2, inputs=0
    )
    run = clpt.simulate(back, [0.0, 1.0], initial_state=[1.0, 0.3])
    assert run.attrs["engine"] == "native"


class Plant:
    """Computes once what does not change."""

    @functools.cached_property
    def mass(self):
        return np.diag([1.0, 2.0, 4.0])

    def response(self, t, x, u, p):
        return (self.mass @ u)[2]


DAY = datetime.datetime(2020, 1, 3)


def dates(t, x, u, p):
    return (DAY - datetime.datetime(2020, 1, 1)).days * u[0]


SERIES = pd.Series({"a": 0.5, "b": 2.0})  # which finds its places once


@pytest.mark.parametrize(
    "function",
    [dates, Plant().response, lambda t, x, u, p: SERIES["b"] * u[0] - SERIES.a],
)
def test_what_is_kept_and_not_read_or_computed_once_may_be(function):
    block = static(function)
    before = kept()
    assert block.array_record("output").operations
    assert kept() == before
    assert run(block, "output", 0.0, [], U) == pytest.approx(function(0.0, [], U, None))


@pytest.mark.filterwarnings("ignore:.*hidden state")
def test_a_log_of_numbers_runs_in_python_and_stays_a_log():
    """Also where what it began with are numbers, of runs before."""
    log = [0.0]

    def logged(t, x, u, p):
        log.append(float(x[0]))
        return [-x[0]]

    system = control.nlsys(logged, inputs=0, outputs=1, states=1, name="logged")
    for _ in range(2):
        with pytest.warns(
            UserWarning, match="logged writes to a list, which outlives the call"
        ):
            found = clpt.simulate(system, [0.0, 1.0], initial_state=[1.0])
        assert found.attrs["engine"] == "python"
    assert all(type(one) is float for one in log)
