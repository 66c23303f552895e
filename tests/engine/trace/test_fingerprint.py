"""A function is traced once: its fingerprint is that of all that it references."""

import abc
import bisect
import datetime
import enum
import functools
import logging
import math
import sys
from collections import OrderedDict, defaultdict, namedtuple
from dataclasses import dataclass, field
from fractions import Fraction
from types import MappingProxyType, SimpleNamespace

import control
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from engine_runs import Unread, reachable
from scipy import special
from scipy.interpolate import interp1d
from traced_calls import traced_calls

import clpt_control as clpt

LOGGER = logging.getLogger("boat")
Point = namedtuple("Point", "east north")


class Mode(enum.Enum):
    SLOW = 0.5
    FAST = 2.0


class Model(abc.ABC):
    @abc.abstractmethod
    def drag(self, v):
        """Return the drag."""


@dataclass(frozen=True)
class Hull:
    length: float = 3.0
    points: tuple = ((0.0, 1.0), (2.0, 3.0))


@dataclass
class Rudder:
    angles: list = field(default_factory=lambda: [0.1 * k for k in range(100)])


class Slotted:
    __slots__ = ("gain",)


class Boat(Model):
    """What a public boat model mentions and holds."""

    names = ("u", "v", "r")

    def __init__(self):
        self.mode, self.place, self.hull, self.rudder = (
            Mode.FAST,
            Point(1.0, 2.0),
            Hull(),
            Rudder(),
        )
        self.slotted, self.kinds = Slotted(), frozenset(("a", "b"))
        self.slotted.gain, self.share, self.count = 0.5, Fraction(1, 3), range(3)
        self.series = pd.Series({"mass": 2.0})
        self.single, self.table = np.float32(0.25), np.linspace(0.0, 1.0, 1000)
        self.space, self.since = SimpleNamespace(depth=2.0), datetime.timedelta(days=1)
        self.ordered, self.sums = OrderedDict(a=1.0), defaultdict(float, b=1.0)
        self.many = [0.5 * k for k in range(20_000)]

    def drag(self, v):
        return 0.5 * v

    @property
    def size(self):
        return self.hull.length * self.place.east

    @functools.cached_property
    def inverse(self):
        return np.linalg.inv(np.diag([2.0, 4.0]))

    @functools.lru_cache  # noqa: B019
    def squared(self, k):
        return k * k

    def plot(self, run):
        plt.plot(run.time, run.x)
        sys.stdout.write("drawn")

    def rate(self, t, x, u, p):
        if x[0] > 100.0:
            LOGGER.warning("fast")
            print("fast", file=sys.stderr)
        k = bisect.bisect(self.rudder.angles, 0.55)
        gain = self.slotted.gain * float(self.share) * self.mode.value * self.single * k
        gain += (
            self.series["mass"] + self.table[500] + self.space.depth + self.since.days
        )
        gain += len(self.kinds) + sum(self.count) + self.ordered["a"] + self.sums["b"]
        gain += self.squared(2.0) + self.many[1] + special.erf(0.5) + self.inverse[0, 0]
        return [-self.drag(x[0]) * gain / self.size]


@pytest.mark.long
def test_a_class_of_all_that_public_models_hold_is_traced_once():
    boat = Boat()
    system = control.nlsys(boat.rate, None, inputs=0, outputs=1, states=1, name="boat")
    slope = boat.rate(0.0, [1.0], [], {})[0]
    counts = []
    with traced_calls("rate") as traced:
        for _ in range(4):
            run = clpt.simulate(system, [0.0, 1.0], initial_state=[1.0])
            assert run.attrs["engine"] == "native"
            assert run.states[-1].item() == pytest.approx(np.exp(slope), rel=1e-6)
            clpt.linearize(system)
            counts.append(len(traced))
        boat.rudder.angles[0] = -0.5  # is not felt, but could be
        clpt.simulate(system, [0.0, 1.0], initial_state=[1.0])
        counts.append(len(traced))
        boat.unused = 3.0  # no code names it
        clpt.simulate(system, [0.0, 1.0], initial_state=[1.0])
    once = counts[0]
    assert once > 0
    assert [*counts, len(traced)] == [once] * 4 + [2 * once] * 2


@pytest.mark.filterwarnings("ignore:.*hidden state")
def test_a_function_that_is_refused_is_not_traced_again():
    log = []

    def logging_rate(t, x, u, p):
        return [-x[0] + 0.0 * (log.append(1) is None)]

    system = control.nlsys(
        logging_rate, None, inputs=0, outputs=1, states=1, name="logs"
    )
    counts = []
    for _ in range(3):
        with (
            pytest.warns(
                UserWarning, match="writes to a list, which outlives the call"
            ),
            traced_calls("logging_rate") as traced,
        ):
            clpt.simulate(system, [0.0, 1.0], initial_state=[1.0])
        log.clear()
        counts.append(len(traced))
    assert counts[0] > 0
    assert counts[1:] == [0, 0]


ALIKE = [
    0,
    0.0,
    -0.0,
    False,
    np.float64(0.0),
    np.float32(0.0),
    "0",
    b"0",
    None,
    (),
    (0,),
    (0.0,),
]
ALIKE += [
    math.nan,
    1,
    1.0,
    True,
    Fraction(1),
    Mode.SLOW,
    Mode.FAST,
    Point(0, 1),
    (0, 1),
    range(2),
    slice(2),
    slice(0, 2),
]
ALIKE += [
    frozenset([0]),
    [0],
    [0.0],
    [-0.0],
    [0, 1],
    [(0, 1)],
    [[0, 1]],
    {"a": 0},
    {"a": 0.0},
]
ALIKE += [
    np.zeros(1),
    np.zeros(1, int),
    np.zeros((1, 1)),
    -np.zeros(1),
    Hull(),
    Hull(1.0),
    1j,
]
ALIKE += [
    SimpleNamespace(a=0),
    OrderedDict(a=0),
    datetime.date(2020, 1, 1),
    interp1d([0, 1], [0, 1]),
]


def test_no_two_values_have_one_key():
    keys = [reachable(one).key for one in ALIKE]
    for k, key in enumerate(keys):
        assert key not in keys[:k], ALIKE[k]


def test_a_value_has_the_same_key_again():
    for one in ALIKE:
        function = lambda: one  # noqa: B023, E731
        assert reachable(function).key == reachable(function).key
        assert hash(reachable(function).key) == hash(reachable(function).key)


@pytest.mark.parametrize(
    "value", [MappingProxyType({}), iter([1]), open, memoryview(b"a"), sys.stdin]
)
def test_a_value_that_may_change_unseen_has_none(value):
    with pytest.raises(
        Unread, match=r"Call it before or after|Pass its numbers|Make it a list"
    ):
        reachable(lambda: value)


def test_contents_are_put_back():
    """A list, a dict, arrays, an object with slots, a class and a series, after any change."""
    row, table, numbers = [1, 2], {"a": 1}, np.arange(3.0)
    texts = np.array([1, None], object)
    boat, series = Boat(), pd.Series({"mass": 2.0})
    before = dict(vars(boat))

    def write(index, value):
        texts[index] = value

    def replace():
        boat.mode = boat.new = None

    def fasten():
        boat.slotted.gain = 7.0

    def invent():
        Slotted.made_up = 1

    def load():
        series["mass"] = 3.0

    for change in (
        lambda: row.append(3),
        lambda: table.update(b=2),
        lambda: numbers.fill(0.0),
        lambda: write(1, "text"),
        *(replace, fasten, invent, load),
    ):
        system = control.nlsys(
            lambda t, x, u, p, change=change: [-x[0], change()][:1], states=1, inputs=0
        )
        with pytest.raises(clpt.DiagramError, match="outlives the call"):
            clpt.equations(system)
    assert (row, table) == ([1, 2], {"a": 1})
    assert numbers.tolist() == [0.0, 1.0, 2.0]
    assert texts.tolist() == [1, None]
    assert vars(boat) == before
    assert list(vars(boat)) == list(before)
    assert boat.slotted.gain == 0.5
    assert not hasattr(Slotted, "made_up")
    assert series["mass"] == 2.0


class Wide(Slotted):
    """Has slots and a dict."""


def test_attributes_in_slots_and_in_a_dict_count():
    wide = Wide()
    wide.gain, wide.share = 0.5, 2.0
    system = control.nlsys(
        lambda t, x, u, p: [-wide.gain * wide.share * x[0]], states=1, inputs=0
    )
    for name in ("gain", "share"):
        for value in (1.0, 3.0):
            setattr(wide, name, value)
            run = clpt.simulate(system, [0.0, 1.0], initial_state=[1.0])
            assert run.states[-1].item() == pytest.approx(
                np.exp(-wide.gain * wide.share), rel=1e-6
            )
