"""A first-order plant with model-reference adaptive control, four systems of python-control."""

import control
import numpy as np

import clpt_control as clpt

PARTS = (
    control.nlsys(
        lambda t, x, u, p: p["a"] * x[0] + p["b"] * u[0],
        inputs="u", states="y", outputs="y", params={"a": 1.0, "b": 3.0}, name="plant",
    ),
    control.nlsys(
        lambda t, x, u, p: -p["am"] * x[0] + p["bm"] * u[0],
        inputs="r", states="ym", outputs="ym", params={"am": 4.0, "bm": 4.0}, name="model",
    ),
    control.nlsys(
        None, lambda t, x, u, p: u[2] * u[0] - u[3] * u[1],
        inputs=["r", "y", "kr", "ky"], outputs="u", name="controller",
    ),
)  # fmt: skip
GAINS = ["kr", "ky"]


def loop(adapt, **params):
    """Connect the plant with an adaptive law of rates (t, x, u, p)."""
    law = control.nlsys(
        adapt,
        inputs=["r", "y", "ym"],
        states=GAINS,
        outputs=GAINS,
        params={"gamma": 2.0, **params},
        name="law",
    )
    return clpt.connect([*PARTS, law], external="r")


def gradient(t, x, u, p):
    """V' = -am e^2."""
    r, y, ym = u
    return [-p["gamma"] * r * (y - ym), p["gamma"] * y * (y - ym)]


def V(s):
    """|e|^2/2 and the distance to the ideal gains, 4/3 and 5/3."""
    apart = (s.kr - s.bm / s.b) ** 2 + (s.ky - (s.am + s.a) / s.b) ** 2
    return (s.y - s.ym) ** 2 / 2 + s.b / (2 * s.gamma) * apart


def leaky(t, x, u, p):
    """A leak to 0, with the share sigma of gamma."""
    rates = gradient(t, x, u, p)
    return [d - p["gamma"] * p["sigma"] * k for d, k in zip(rates, x, strict=True)]


def stopped_by_if(t, x, u, p):
    """The gains stop at kmax, by branches."""
    a, b = gradient(t, x, u, p)
    if x[0] >= p["kmax"] and a > 0:
        a = 0.0
    if x[1] >= p["kmax"] and b > 0:
        b = 0.0
    return [a, b]


def stopped_by_where(t, x, u, p):
    """The gains stop at kmax, by np.where."""
    rates = gradient(t, x, u, p)
    return [
        np.where(k >= p["kmax"], np.minimum(rate, 0), rate)
        for k, rate in zip(x, rates, strict=True)
    ]


def stopped_in_a_box(t, x, u, p):
    """The gains stop at -kmax and kmax."""
    rates = []
    for k, rate in zip(x, gradient(t, x, u, p), strict=True):
        below = np.where(k <= -p["kmax"], np.maximum(rate, 0), rate)
        rates.append(np.where(k >= p["kmax"], np.minimum(rate, 0), below))
    return rates


def stopped_smoothly(t, x, u, p):
    """What drives a gain outward fades from kmax to kmax + 1."""
    rates = gradient(t, x, u, p)
    return [
        rate - np.clip(k - p["kmax"], 0.0, 1.0) * np.maximum(rate, 0)
        for k, rate in zip(x, rates, strict=True)
    ]


def stopped_in_a_ball(t, x, u, p):
    """What drives the gains out of the ball of kmax is taken away."""
    rates = gradient(t, x, u, p)
    outward = rates[0] * x[0] + rates[1] * x[1]
    size = x[0] ** 2 + x[1] ** 2
    share = np.where(
        (size >= p["kmax"] ** 2) & (outward > 0), outward / np.maximum(size, 1.0), 0.0
    )
    return [rate - share * k for k, rate in zip(x, rates, strict=True)]


PROJECTIONS = {
    "if": stopped_by_if,
    "where and minimum": stopped_by_where,
    "a box": stopped_in_a_box,
    "smooth": stopped_smoothly,
    "a ball": stopped_in_a_ball,
}
