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


def leaky_with_error(t, x, u, p):
    """A leak to 0 with the share nu |e| of gamma: e-modification."""
    rates = gradient(t, x, u, p)
    leak = p["gamma"] * p["nu"] * np.abs(u[1] - u[2])
    return [d - leak * k for d, k in zip(rates, x, strict=True)]


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


def stopped_smoothly(sign=1.0, side=1.0, part=np.maximum):
    """Return a law in which what drives a gain outward fades from kmax to kmax + 1."""

    def law(t, x, u, p):
        return [
            rate - sign * np.clip(side * (k - p["kmax"]), 0.0, 1.0) * part(rate, 0)
            for k, rate in zip(x, gradient(t, x, u, p), strict=True)
        ]

    return law


def stopped_in_a_ball(share=1.0, side=1.0, center=0.0, fades=False, root=False):
    """Return a law that takes away what drives the gains out of the ball of kmax."""

    def law(t, x, u, p):
        rates = gradient(t, x, u, p)
        off = [k - center for k in x]
        outward = rates[0] * off[0] + rates[1] * off[1]
        size = off[0] ** 2 + off[1] ** 2
        beyond = np.sqrt(size) - p["kmax"] if root else size - p["kmax"] ** 2
        if fades:
            part = np.clip(side * beyond, 0.0, 1.0) * np.maximum(outward, 0)
        else:
            part = np.where((side * beyond >= 0) & (outward > 0), outward, 0.0)
        pull = share * part / np.maximum(size, 1.0)
        return [rate - pull * d for rate, d in zip(rates, off, strict=True)]

    return law


PROJECTIONS = {
    "if": stopped_by_if,
    "where and minimum": stopped_by_where,
    "a box": stopped_in_a_box,
    "smooth": stopped_smoothly(),
    "a ball": stopped_in_a_ball(),
}
