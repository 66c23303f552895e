"""Models of many kinds, as users make them: they are differentiated, exported and saved."""

from types import MappingProxyType
from typing import Any, NamedTuple

import control
import numpy as np
from adaptive_loop import mrac

import clpt_control as clpt
from clpt_control.engine.model.declaration import Each


def autonomous(update, **params):
    """A system of one state and no input."""
    ports = {"states": ["x"], "inputs": 0, "outputs": ["x"]}
    return control.nlsys(update, None, name="lag", params=params, **ports)


def decay(k):
    return autonomous(lambda t, x, u, p: [-p["k"] * x[0]], k=k)


def rooted():
    """A power of a magnitude that begins at zero."""
    return autonomous(lambda t, x, u, p: [p["b"] - np.abs(x[0]) ** 0.3 * x[0]], b=0.6)


def stepping(before=1.0, behind=3.0, little=0.0):
    """Its rate jumps where x is the edge, or 1 and a little of it."""

    def update(t, x, u, p):
        edge = 1.0 + little * p["edge"] if little else p["edge"]
        return [before if x[0] < edge else behind]

    return autonomous(update, edge=1.0)


def pendulum():
    def update(t, x, u, p):
        return [
            x[1],
            -p["g"] / p["l"] * np.sin(x[0]) - p["c"] * x[1] * abs(x[1]) + u[0],
        ]

    return control.nlsys(
        update, lambda t, x, u, p: [p["l"] * np.sin(x[0])], name="pendulum",
        states=["theta", "omega"], inputs=["torque"], outputs=["place"],
        params={"g": 9.81, "l": 1.2, "c": 0.3},
    )  # fmt: skip


def discrete():
    pi = {"name": "pi", "inputs": "e", "outputs": "u"}
    controller = control.ss([[1.0]], [[0.1]], [[0.8]], [[2.0]], True, **pi)
    plant = control.nlsys(
        lambda t, x, u, p: [x[0] + p["h"] * (-p["k"] * x[0] ** 3 + u[0])], None, name="plant",
        states=["x"], inputs=["u"], outputs=["y"], params={"h": 0.1, "k": 0.7}, dt=True,
    )  # fmt: skip
    error = control.summing_junction(["r", "-y"], "e", name="error")
    error.dt = True
    return control.interconnect(
        [controller, plant, error],
        inputs=["r"],
        outputs=["y", "u"],
        name="discrete",
        dt=True,
    )


def sampled_tank():
    """A PI controller at samples of 0.5 s, a tank with a valve that saturates."""

    def level(t, x, u, p):
        inflow = min(max(u.q[0], 0.0), 3.0)
        return [(inflow - p.c * np.sqrt(x.h[0] + 0.01)) / p.area]

    tank = clpt.Block("tank", update=level, inputs={"q": 1}, states={"h": 1},
                      parameters={"c": 1.0, "area": 2.0})  # fmt: skip
    pi = clpt.Block(
        "pi", update=lambda t, x, u, p: [p.target - u.h[0]],
        output=lambda t, x, u, p: [p.kp * (p.target - u.h[0]) + p.ki * x.integral[0]],
        inputs={"h": 1}, outputs={"q": 1}, states={"integral": 1},
        parameters={"kp": 2.0, "ki": 0.7, "target": 1.5},
    )  # fmt: skip
    return clpt.connect([tank, clpt.Sampled(pi, 0.5)], name="level")


def tanks():
    """Two tanks whose areas stand in one array."""
    return control.nlsys(
        lambda t, x, u, p: (u[0] - x) / np.array([p["area"], p["wide"]]), None, name="tanks",
        params={"area": 1.0, "wide": 2.0}, states=2, inputs=1, outputs=2,
    )  # fmt: skip


def van_der_pol():
    return control.nlsys(
        lambda t, x, u, p: [x[1], p["mu"] * (1.0 - x[0] ** 2) * x[1] - x[0]], None, name="vdp",
        params={"mu": 500.0}, states=["x", "v"], inputs=0, outputs=["x", "v"],
    )  # fmt: skip


def with_a_table():
    """A plant whose gain is a table, and whose output is in wholes of it."""
    at, gains = (
        np.linspace(-2.0, 2.0, 9),
        np.array([3.0, 2, 1.5, 1, 1, 1.2, 1.7, 2.5, 4]),
    )

    def update(t, x, u, p):
        return [
            u[0]
            - p["k"] * np.interp(x[0], at, gains) * x[0]
            + 0.1 * np.hypot(x[0], 1.0)
        ]

    def output(t, x, u, p):
        row = np.array([1.0, 2.0, 5.0])
        place = np.clip(np.floor(x[0] + 1.0), 0, 2)
        return [clpt.lookup(row, place), x[0] // 0.3, x[0] % -0.3, np.sign(x[0]),
                max(x[0], u[0]), min(x[0], 0.2), abs(x[0]), np.exp(x[0]) ** 0.5]  # fmt: skip

    ports = {"states": ["x"], "inputs": ["u"], "outputs": list("abcdefgh")}
    return control.nlsys(update, output, name="table", params={"k": 0.8}, **ports)


def teeth():
    """A block of four states that jumps at each period."""
    return clpt.Block(
        "teeth", update=lambda t, x, u, p: {"x": -p.slope * x.x + p.interval, "y": x.x[0] * u.v},
        states={"x": 3, "y": 1}, inputs={"v": 1},
        jump=lambda t, x, u, p: {"x": 0.5 * x.x + p.interval, "y": x.y + u.v},
        breakpoints=Each("period"), parameters={"slope": 1.0, "period": 0.5, "interval": -1.0},
    )  # fmt: skip


def wide():
    """A ring of 40 states, which stays a loop."""

    def update(t, x, u, p):
        return {"x": np.tanh(p.W @ x.x) - p.leak * x.x + np.sum(x.x) / 40}

    W = np.random.default_rng(0).standard_normal((40, 40)) / 8
    return clpt.Block(
        "ring", update=update, states={"x": 40}, parameters={"W": W, "leak": 1.0}
    )


def oddly_named():
    """Names that would end a comment of C, or begin one."""
    return control.nlsys(
        lambda t, x, u, p: [x[1], u[0] - p["α"] * x[0]], None, name="a*/b\nc", params={"α": 2.0},
        states=["ω_*/", "b-1"], inputs=["/*τ"], outputs=["y %", "φ^2"],
    )  # fmt: skip


def loop():
    """The paper's loop, which changes waypoint each 20 s."""
    return clpt.closed_loop(clpt.paper_scenario())


class Model(NamedTuple):
    """A model, its start and its constant inputs, a step; and the parameters that are varied."""

    system: Any
    start: Any
    u: list[float]
    h: float
    varied: Any = MappingProxyType({})
    move: float = 1e-5  # of the differences


SPRING = control.ss(
    [[0, 1], [-2, -0.3]], [[0], [1]], np.eye(2), [[0], [0.5]], name="plant"
)
MODELS = {
    "papers-loop": Model(loop(), clpt.initial_state(loop()), [], 0.05,
                         {"adaptation.gain": 0.8}, 1e-4),
    "pendulum": Model(pendulum(), [1.0, 0.0], [0.7], 0.01, {"g": 9.81, "l": 1.2, "c": 0.3}),
    "names": Model(oddly_named(), [1.0, 0.5], [0.7], 0.01),
    "if": Model(stepping(), [0.0], [], 0.01),
    "ss": Model(SPRING, [1.0, 0.0], [0.3], 0.01),
    "mrac": Model(mrac(), [0.0] * 4, [1.0], 0.01, {"a": 1.0, "b": 3.0, "gain": 2.0}),
    "sampled-tank": Model(sampled_tank(), [0.1, 0.0, 0.0], [], 0.125,
                          {"tank.c": 1.0, "pi.kp": 2.0, "pi.target": 1.5}, 1e-6),
    "table": Model(with_a_table(), [0.3], [0.9], 0.01),
    "teeth": Model(clpt.connect([teeth()], "v"), [1.0, 0.5, 0.0, 0.0], [0.4], 0.125),
    "ring": Model(clpt.connect([wide()]), np.linspace(-1.0, 1.0, 40), [], 0.01),
    "discrete": Model(discrete(), [0.2, 1.0], [1.0], 1.0, {"k": 0.7}),
    "tanks": Model(tanks(), [0.3, 0.1], [1.0], 0.01, {"area": 1.0, "wide": 2.0}),
    "root": Model(rooted(), [0.0], [], 0.004, {"b": 0.6}, 1e-4),
    "stiff": Model(van_der_pol(), [2.0, 0.0], [], 0.6, {"mu": 500.0}, 1e-4),
}  # fmt: skip
