"""A tank with a gauge, and a track that no waypoint makes, for plots and repeated runs."""

import numpy as np

import clpt_control as clpt


def tank(units=None):
    ports = {"inputs": {"q": 1}, "states": {"h": 2}, "parameters": {"a": 0.5}}
    ports["units"] = {"h": "m", "q": "m3/s"} if units is None else units
    return clpt.Block(
        "tank",
        update=lambda t, x, u, p: [u.q[0] - p.a * x.h[0], x.h[0] - x.h[1]],
        **ports,
    )


def gauge():
    ports = {"inputs": {"h": 2}, "outputs": {"v": 2, "mean": 1}, "units": {"v": "V"}}
    ports["parameters"] = {"k": np.array([2.0, 3.0])}
    mean = lambda t, x, u, p: {"v": p.k * u.h, "mean": (u.h[0] + u.h[1]) / 2}  # noqa: E731
    return clpt.Block("gauge", output=mean, **ports)


def loop():
    return clpt.connect([tank(), gauge()], external="q", name="loop")


def lemniscate():
    return clpt.Block(
        "eight",
        output=lambda t, x, u, p: [2 * np.cos(t / 20), np.sin(t / 10)],
        outputs={"zc": 2},
    )
