"""Hidden state is seen in every place where a function can keep it.

Each function counts its calls in another place, and its rate is 0 from the 60th call on.  Traced,
it would be exp(-t) for good.  So Python runs it, and one sentence says so.
"""

# ruff: noqa: PTH123

import builtins
import ctypes
import decimal
import enum
import functools
import itertools
import math
import multiprocessing
import os
import queue
import sys
import threading
import types
from collections import Counter, OrderedDict, defaultdict, deque
from pathlib import Path

import control
import numpy as np
import pandas as pd
import pytest

import clpt_control as clpt

MOST = 60


class Slots:
    __slots__ = ("__hidden", "n")

    def __init__(self):
        self.n = self.__hidden = 0

    def count(self):
        self.__hidden += 1
        return self.__hidden


class Both(Slots):
    """Has slots and a dict."""


class Gear(enum.Enum):
    FIRST = 1


class Meter:
    total = 0

    def __init__(self):
        self.n, self.calls = 0, []

    @property
    def read(self):
        self.calls.append(1)
        return len(self.calls)

    @functools.cached_property
    def cache(self):
        return [0]

    @classmethod
    def counted(cls):
        cls.total += 1
        return cls.total

    def __getattr__(self, name):
        if name != "made_up":
            raise AttributeError(name)
        self.n += 1
        return self.n

    def __call__(self):
        self.n += 1
        return self.n


def in_a_file():
    Path("count").write_text(str(int(Path("count").read_text()) + 1))
    return int(Path("count").read_text())


def in_an_opened_file():
    with open("count") as file:
        n = int(file.read()) + 1
    with open("count", "w") as file:
        file.write(str(n))
    return n


def in_the_environment():
    os.environ["CLPT_COUNT"] = str(int(os.environ.get("CLPT_COUNT", "0")) + 1)
    return int(os.environ["CLPT_COUNT"])


def of_attribute(held, name):
    """Return a function that counts in an attribute."""

    def count():
        setattr(held, name, getattr(held, name) + 1)
        return getattr(held, name)

    return count


def of_item(held, key):
    """Return a function that counts in an item."""

    def count():
        held[key] += 1
        return held[key]

    return count


def of_length(held, grow):
    """Return a function that counts in the length of a value."""

    def count():
        getattr(held, grow)(0)
        return held.qsize() if isinstance(held, queue.Queue) else len(held)

    return count


def in_math():
    math.count += 1
    return math.count


def in_builtins():
    builtins.count += 1
    return builtins.count


def in_defaults():
    def own(n=[0]):  # noqa: B006
        n[0] += 1
        return n[0]

    return own


def in_new_defaults():
    def held(n=0):
        return n

    def count():
        held.__defaults__ = (held() + 1,)
        return held()

    return count


def in_a_cache():
    @functools.cache
    def held():
        return [0]

    def count():
        held()[0] += 1
        return held()[0]

    return count


def in_a_missing_item():
    calls = []
    missing = defaultdict(lambda: calls.append(1) or len(calls))
    return lambda: (missing.pop("n", None), missing["n"])[1]


def by_a_decorator():
    calls = Counter()

    def counted(function):
        @functools.wraps(function)
        def inner():
            calls[function.__name__] += 1
            return function()

        return inner

    @counted
    def count():
        return calls["count"]

    return count


def in_a_generator():
    def numbers():
        n = 0
        while True:
            n += 1
            yield n

    held = numbers()
    return lambda: next(held)


def in_an_imported_module():
    sys.modules["counting"] = types.ModuleType("counting")
    sys.modules["counting"].n = 0

    def count():
        import counting

        counting.n += 1
        return counting.n

    return count


def in_a_cell():
    n = 0

    def count():
        nonlocal n
        n += 1
        return n

    return count


def in_the_context():
    decimal.getcontext().prec += 1
    return decimal.getcontext().prec - 28


def in_the_limit():
    sys.setrecursionlimit(sys.getrecursionlimit() + 1)
    return sys.getrecursionlimit() - LIMIT


LIMIT = sys.getrecursionlimit()
ALIASED = math


def in_an_alias():
    setattr(ALIASED, "count", ALIASED.count + 1)  # noqa: B010
    return ALIASED.count


PLACES = {
    **{one.__name__: lambda one=one: one for one in (in_a_file, in_an_opened_file)},
    **{
        one.__name__: lambda one=one: one
        for one in (in_the_environment, in_the_context)
    },
    **{
        one.__name__: lambda one=one: one for one in (in_math, in_builtins, in_an_alias)
    },
    "in the limit of recursion": lambda: in_the_limit,
    "a ctypes number": lambda: of_attribute(ctypes.c_double(0.0), "value"),
    "a ctypes array": lambda: of_item((ctypes.c_double * 1)(), 0),
    "shared memory": lambda: of_attribute(multiprocessing.Value("d", 0.0), "value"),
    "a namespace": lambda: of_attribute(types.SimpleNamespace(n=0), "n"),
    "a thread local": lambda: of_attribute(LOCAL, "n"),
    "a queue": lambda: of_length(queue.Queue(), "put"),
    "a list": lambda: of_length([], "append"),
    "a deque": lambda: of_length(deque(), "append"),
    "an item of a list": lambda: of_item([0], 0),
    "a dict": lambda: of_item({"n": 0}, "n"),
    "a defaultdict": lambda: of_item(defaultdict(int), "n"),
    "an ordered dict": lambda: of_item(OrderedDict(n=0), "n"),
    "a counter": lambda: of_item(Counter(), "n"),
    "a bytearray": lambda: of_length(bytearray(), "append"),
    "an array": lambda: of_item(np.zeros(1), 0),
    "an array of objects": lambda: of_item(np.array([0, None], dtype=object), 0),
    "a matrix of records": lambda: of_item(np.zeros(1, dtype=[("n", int)])["n"], 0),
    "a series": lambda: of_item(pd.Series({"n": 0}), "n"),
    "attributes of a series": lambda: in_attrs(),
    "a slot": lambda: of_attribute(Slots(), "n"),
    "a private slot": lambda: Slots().count,
    "a slot of an object with a dict": lambda: of_attribute(Both(), "n"),
    "a missing item": in_a_missing_item,
    "a member of an enum": lambda: of_attribute(Gear.FIRST, "n"),
    "an attribute": lambda: of_attribute(Meter(), "n"),
    "an attribute of a class": lambda: Meter.counted,
    "an attribute of a function": lambda: of_attribute(in_a_file, "n"),
    "an object that is called": lambda: Meter(),
    "a property": lambda: (lambda meter: lambda: meter.read)(Meter()),
    "a cached property": lambda: (lambda meter: of_item(meter.cache, 0))(Meter()),
    "a cached property, later": lambda: (lambda meter: lambda: of_cache(meter))(
        Meter()
    ),
    "an attribute that is made up": lambda: (lambda meter: lambda: meter.made_up)(
        Meter()
    ),
    "an iterator": lambda: (lambda held: lambda: next(held) + 1)(itertools.count()),
    **{one.__name__: one for one in (in_a_generator, in_an_imported_module, in_a_cell)},
    **{
        one.__name__: one
        for one in (in_defaults, in_new_defaults, in_a_cache, by_a_decorator)
    },
}
LOCAL = threading.local()


def in_attrs():
    series = pd.Series({"n": 0})
    series.attrs["n"] = 0

    def count():
        series.attrs["n"] += 1
        return series.attrs["n"]

    return count


def of_cache(meter):
    meter.cache[0] += 1
    return meter.cache[0]


@pytest.mark.filterwarnings("ignore:.*hidden state")
@pytest.mark.parametrize("place", PLACES)
def test_a_function_that_counts_its_calls_runs_in_python(place, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("count").write_text("0")
    monkeypatch.setenv("CLPT_COUNT", "0")
    monkeypatch.setattr(math, "count", 0, raising=False)
    monkeypatch.setattr(builtins, "count", 0, raising=False)
    monkeypatch.setattr(LOCAL, "n", 0, raising=False)
    monkeypatch.setattr(in_a_file, "n", 0, raising=False)
    monkeypatch.setattr(Gear.FIRST, "n", 0, raising=False)
    monkeypatch.setattr(Meter, "total", 0)
    with decimal.localcontext():
        try:
            count = PLACES[place]()
            rate = lambda t, x, u, p: [-x[0] if count() < MOST else 0.0]  # noqa: E731
            tank = control.nlsys(rate, None, inputs=0, outputs=1, states=1, name="tank")
            with pytest.warns(UserWarning, match=r"^tank runs in Python") as caught:
                run = clpt.simulate(
                    tank, np.linspace(0.0, 3.0, 301), initial_state=[1.0]
                )
        finally:
            sys.setrecursionlimit(LIMIT)
    assert sum("runs in Python" in str(one.message) for one in caught) == 1
    assert run.attrs["engine"] == "python"
    assert run.states[-1].item() > 1.5 * math.exp(-3.0)  # its count counts
