"""Flows that are known in closed form, on every engine and by both methods."""

import math

import numpy as np
import pytest
from engines import ENGINES, side_by_side

from clpt_control.equations import Block
from clpt_control.native import numbering
from clpt_control.native.machine import LANES

N = 6  # copies of a flow, each with its rate
RATES = np.linspace(0.5, 2.0, N)
TIMES = np.array([0.0, 0.3, 1.0, 1.7, 2.0])


def rotation(t, x, u, p):
    return {"x": -p.a * x.y, "y": p.a * x.x}


def saddle(t, x, u, p):
    return {"x": p.a * x.x, "y": -p.a * x.y}


def growth(t, x, u, p):
    return {"x": p.a * x.x * (1.0 - x.x), "y": p.a * x.y}


def oscillator(t, x, u, p):
    return {"x": x.y, "y": -(p.a**2) * x.x + np.cos(t)}


def jump(t, x, u, p):
    return {"x": p.a * p.interval, "y": p.interval * x.x}


def rotated(t, x, y, a):
    return x * np.cos(a * t) - y * np.sin(a * t), x * np.sin(a * t) + y * np.cos(a * t)


def torn(t, x, y, a):
    return x * np.exp(a * t), y * np.exp(-a * t)


def grown(t, x, y, a):
    return x / (x + (1 - x) * np.exp(-a * t)), y * np.exp(a * t)


def driven(t, x, y, a):
    """x'' = -a^2 x + cos t: the forced part and what starts freely."""
    forced = 1 / (a**2 - 1)
    free = x - forced
    place = free * np.cos(a * t) + y / a * np.sin(a * t) + forced * np.cos(t)
    speed = -free * a * np.sin(a * t) + y * np.cos(a * t) - forced * np.sin(t)
    return place, speed


def jumped(t, x, y, a, dwell=0.7):
    """Interval k from k dwell on: x is straight there and y a parabola."""
    k = 0
    while t > 0:
        h = min(t, dwell)
        x, y, t, k = x + a * k * h, y + k * (x * h + a * k * h**2 / 2), t - h, k + 1
    return x, y


def every(p, t0, t1):
    times = 0.7 * np.arange(1, math.floor(t1 / 0.7) + 1)
    return times[(times > t0) & (times <= t1)]


FLOWS = {
    "rotation": (rotation, rotated),
    "saddle": (saddle, torn),
    "growth": (growth, grown),
    "oscillator": (oscillator, driven),
    "jump": (jump, jumped),
}


def states(engine, block, x0, step):
    lanes, count = (LANES, LANES + 3) if engine == "lanes" else (1, 1)
    runner = ENGINES.get(engine, ENGINES["unrolled"])(block)
    runs = side_by_side(runner, lanes, np.tile(x0, (count, 1)), TIMES, step, rtol=1e-11)
    assert set(runs.status) == {numbering.FINISHED}
    np.testing.assert_array_equal(runs.out, runs.out[:1].repeat(count, 0))
    return runs.out[0]


@pytest.mark.parametrize("method", ["DOP853", "RK4"])
@pytest.mark.parametrize("engine", [*ENGINES, "lanes"])
@pytest.mark.parametrize("flow", FLOWS)
def test_flow(flow, engine, method):
    update, exact = FLOWS[flow]
    jumps = flow == "jump"
    block = Block(
        flow,
        update=update,
        states={"x": "N", "y": "N"},
        parameters={"a": RATES, **({"interval": -1.0} if jumps else {})},
        shapes={"a": "N"},
        breakpoints=every if jumps else None,
    )
    x, y = np.linspace(0.2, 1.5, N), np.linspace(-1.0, 1.0, N)
    found = states(engine, block, np.concatenate([x, y]), 0.02 if method == "RK4" else None)
    wanted = [np.concatenate(exact(t, x, y, RATES)) for t in TIMES]
    error = 3e-7 if method == "RK4" else 1e-9
    np.testing.assert_allclose(found, wanted, rtol=error, atol=error)
