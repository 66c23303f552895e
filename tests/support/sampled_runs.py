"""What ensembles sweep, with closed forms, and how their stores and datasets are compared."""

import control
import numpy as np

import clpt_control as clpt

VARY = ["learning.gain=0.2:2.0", "flow.parameters~normal:0.1", "learning.position=-1:1"]
TIMES = np.linspace(0.0, 5.0, 51)


def files(folder):
    """Every file of a store with its bytes."""
    paths = sorted(path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


def assert_identical(one, other):
    assert set(one.variables) == set(other.variables)
    for name in one.variables:
        assert one[name].dims == other[name].dims
        assert one[name].values.tobytes() == other[name].values.tobytes(), name


def system(update, **more):
    """A nonlinear system of python-control, of one state that is its output."""
    given = {"inputs": 0, "outputs": "y", "states": "x", "name": "one"}
    return control.nlsys(update, None, **given | more)


def lag():
    ports = {
        "inputs": 1,
        "outputs": 1,
        "states": 1,
        "params": {"tau": 1.0},
        "name": "lag",
    }
    return system(lambda t, x, u, p: (u - x) / p["tau"], **ports)


def spring(name, K, port, **more):
    """x' = -K x + u: two numbers."""
    ports = {"inputs": {"f": 2}, "outputs": {port: 2}, "states": {"x": 2}}
    rate, ports["parameters"] = (
        lambda t, x, u, p: -p.K * x.x + u.f,
        {"K": np.array(K), **more},
    )
    return clpt.Block(name, update=rate, output=lambda t, x, u, p: x.x, **ports)


def springs():
    """Two blocks of one kind, with equal numbers."""
    made = [
        spring(name, [1.0, 2.0], port, turns=3)
        for name, port in (("one", "a"), ("two", "b"))
    ]
    return clpt.connect(made, external="f", name="springs")


def two_shapes(two):
    """One name has the shape that python-control hands down."""
    made = [
        system(lambda t, x, u, p: -x, params={"K": 1.0}, name="a"),
        system(lambda t, x, u, p: -p["K"][1] * x, params={"K": two}, name="b"),
    ]
    return control.interconnect(made, connections=False, outlist=["b.y"], outputs=["y"])


def unread(t, x, u, p):
    """A number is asked of a signal, which is not read."""
    return [-p["a"] * float(str(x[0]))]
