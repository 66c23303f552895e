"""What changes after a block was made counts at its next reading; what parameters are asked."""

import io
import math
import threading
import time
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType, SimpleNamespace

import control
import numpy as np
import pytest
from engine_runs import Unread, reachable
from recorded_blocks import as_it_runs, recorded, static
from scipy import special
from test_ordinary_python import POINTS

import clpt_control as clpt

# --- what changes after the block was made --------------------------------------------------------

LEVEL = 1.0


def helper(a, k=1.0):
    return k * a


@dataclass
class Pump:
    head: float = 1.0


class Vessel:
    def __init__(self):
        self.loss, self.table, self.parts = 0.5, np.array([1.0, 2.0]), {"valve": [3.0]}

    def rate(self, level, inflow):
        return [-level + inflow]


PLACE = ModuleType("place")
PLACE.width = 1.0


class Tank(Vessel):
    """An object as engineers write them; what it holds and does may change at any time."""

    area = 2.0

    def __init__(self):
        super().__init__()
        self.pump, self.more = Pump(), SimpleNamespace(pump=Pump(1.0))

    @property
    def width(self):
        return 10.0

    @staticmethod
    def scaled(level):
        return 1.0 * level

    def drained(self, level):
        return self.loss * level

    def rate(self, t, x, u, params):
        held = (
            self.table[1]
            * self.parts["valve"][0]
            / (self.area * self.width * PLACE.width)
        )
        held *= self.pump.head * self.more.pump.head * helper(LEVEL)
        return super().rate(self.drained(self.scaled(x[0])), held)


def test_a_change_in_an_object_counts_at_the_next_run(monkeypatch):
    """Of what it holds, of its class, of globals and helpers; what is alike is read once."""
    tank, own = Tank(), monkeypatch.setattr
    changes = [
        lambda: None,
        lambda: monkeypatch.setitem(globals(), "LEVEL", 1.4),
        lambda: own(helper, "__defaults__", (1.5,)),
        lambda: monkeypatch.setitem(globals(), "helper", lambda a: 1.6 * a),
        lambda: own(tank, "loss", 0.7),
        lambda: tank.table.put(1, 5.0),
        lambda: tank.parts["valve"].append(tank.parts["valve"].pop() + 1.0),
        lambda: own(tank.pump, "head", 1.1),
        lambda: own(tank.more.pump, "head", 1.2),
        lambda: own(PLACE, "width", 1.3),
        lambda: own(Vessel, "rate", lambda self, a, b: [1.1 * b - a]),
        lambda: own(Tank, "area", 4.0),
        lambda: own(Tank, "width", property(lambda self: 20.0)),
        lambda: own(Tank, "scaled", staticmethod(lambda level: 3.0 * level)),
        lambda: own(Tank, "drained", lambda self, level: 0.1 * level),
    ]
    system = control.nlsys(tank.rate, None, inputs=0, outputs=1, states=1, name="tank")
    seen = set()
    for change in changes:
        change()
        one, b = (tank.rate(0.0, [level], [], {})[0] for level in (1.0, 0.0))
        found = clpt.simulate(system, [0.0, 1.0], initial_state=[1.0]).states[-1].item()
        end = b / (b - one)
        assert found == pytest.approx(end + (1.0 - end) * np.exp(one - b), rel=1e-6)
        seen.add(round(found, 9))
    assert len(seen) == len(changes)
    assert reachable(tank.rate).key == reachable(tank.rate).key


@pytest.mark.parametrize(
    "value",
    [
        *((k for k in range(3)), iter([1.0]), threading.Lock(), io.StringIO()),
        *(np.random.default_rng(0), Path("a"), open, time.time),
    ],
    ids=lambda value: type(value).__name__,
)
def test_what_may_change_unseen_has_no_key(value):
    tank = Tank()
    tank.pump = value
    with pytest.raises(Unread):
        reachable(tank.rate)


def raising(t, x, u, p):
    if u[0] < 0:
        raise ValueError("an empty tank")
    return u[0]


def test_a_way_that_raises_is_nan():
    found = [recorded(static(raising), "output", 0.0, [], u)[0] for u in POINTS[:2]]
    np.testing.assert_array_equal(found, [POINTS[0][0], math.nan])


# --- parameters --------------------------------------------------------------------------------


def counts(t, x, u, p):
    y = 0.0
    for k in range(int(p.count)):
        y += p["v"][k] * u[k] * p.get("gain", 10.0) * p.get("none", 2.0)
    return y if p.gain > 1.0 else -y


def test_a_parameter_is_fixed_only_where_python_needs_its_value():
    block = static(
        counts, parameters={"count": 2.0, "v": np.array([1.0, 2.0, 3.0]), "gain": 0.5}
    )
    for change in ({}, {"count": 3.0}, {"gain": 2.0}):
        block.parameters = block.parameters._replace(**change)
        as_it_runs(block, "output", 0.0, [], POINTS[0])
        leaves = block.array_record("output").leaves("p")
        assert ("v" in leaves, "count" in leaves) == (True, False)


OF_PARAMETERS = {  # what no record holds of signals
    "eigenvalues": lambda t, x, u, p: np.linalg.eigvalsh(p.A)[0] * u[0],
    "vectors": lambda t, x, u, p: np.linalg.eigh(p.A).eigenvectors[0] @ u[:2],
    "singular values": lambda t, x, u, p: np.linalg.svd(p.A)[1].sum() * u[0],
    "an inverse": lambda t, x, u, p: np.linalg.pinv(p.A)[0] @ u[:2],
    "gamma": lambda t, x, u, p: special.gamma(p.gain + 1.0) * u[0],
    "Bessel": lambda t, x, u, p: special.j0(2.0 * p.gain) * u[1],
    "bits": lambda t, x, u, p: ((int(p.count) & 5) | 8) * u[0],
    "shifts": lambda t, x, u, p: (1 << int(p.count)) * u[0],
}


@pytest.mark.parametrize("name", OF_PARAMETERS)
def test_what_parameters_alone_decide_is_computed_by_numpy(name):
    p = {"A": np.array([[2.0, 0.5], [0.5, 3.0]]), "gain": 0.5, "count": 7.0}
    block = static(OF_PARAMETERS[name], parameters=p)
    for change in (
        {},
        {"A": np.array([[1.0, 0.2], [0.2, 4.0]]), "gain": 1.5, "count": 2.0},
    ):
        block.parameters = block.parameters._replace(**change)
        as_it_runs(block, "output", 0.0, [], POINTS[0])
