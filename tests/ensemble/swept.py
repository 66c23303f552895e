"""Diagrams that ensembles sweep, and their closed forms."""

import control
import numpy as np

import clpt_control as clpt

TIMES = np.linspace(0.0, 5.0, 51)


def system(update, **more):
    """A nonlinear system of python-control, of one state that is its output."""
    given = {"inputs": 0, "outputs": "y", "states": "x", "name": "one"}
    return control.nlsys(update, None, **given | more)


def lag():
    rate = lambda t, x, u, p: (u - x) / p["tau"]  # noqa: E731
    return system(rate, inputs=1, outputs=1, states=1, params={"tau": 1.0}, name="lag")


def pulled(t, x, u, p):
    """x' = -K x + u: two numbers."""
    return -p.K * x.x + u.f


def springs():
    """Two blocks of one kind, with equal numbers, and a nonlinear system beside them."""
    made = [
        clpt.Block(
            name,
            update=pulled,
            output=lambda t, x, u, p: x.x,
            inputs={"f": 2},
            outputs={port: 2},
            states={"x": 2},
            parameters={"K": np.array([1.0, 2.0]), "turns": 3},
        )
        for name, port in (("one", "a"), ("two", "b"))
    ]
    return clpt.connect(made, external="f", name="springs")


def unread(t, x, u, p):
    """A number is asked of a signal, which is not read."""
    return [-p["a"] * float(str(x[0]))]
