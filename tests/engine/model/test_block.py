"""Blocks: ports with shapes, parameters of any kind, values returned in any form, names."""

import copy
import pickle
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import control
import numpy as np
import pytest
from engine_runs import linear
from recorded_blocks import as_it_runs, recorded, static

import clpt_control as clpt
from clpt_control import ArgumentError, Block, BlockError, Sampled
from clpt_control.engine.model.block import evaluate
from clpt_control.engine.model.declaration import Each


class Tuple(NamedTuple):
    gain: float
    theta: np.ndarray


@dataclass
class Record:
    gain: float
    theta: np.ndarray


THETA = np.arange(6.0).reshape(2, 3)
KINDS = [  # a dict, lists, a NamedTuple, a dataclass
    {"gain": 0.5, "theta": THETA},
    {"gain": 0.5, "theta": THETA.tolist()},
    Tuple(0.5, THETA),
    Record(0.5, THETA),
]


def flow(t, x, u, p):
    return p.gain * p.theta @ u.phi


def made(parameters, **more):
    more |= {"parameters": parameters, "shapes": {"theta": (2, "N")}}
    return static(flow, {"phi": "N"}, {"flow": 2}, **more)


@pytest.mark.parametrize("kind", [lambda rate: rate, partial])
def test_a_block_says_its_own_equations(kind):
    """Also a sampled one, and one of a partial function, whose class has a docstring too."""

    def rate(t, x, u, p):
        """x' = -x, Eq. (30)."""
        return -x.x

    block = Block("decay", update=kind(rate), states={"x": 1})
    for one in (block, Sampled(block, 0.5)):
        assert "Eq. (30)" in clpt.draw(one)._repr_html_()


@pytest.mark.parametrize("parameters", KINDS)
def test_parameters_are_a_dict_a_named_tuple_or_a_dataclass(parameters):
    block, phi = made(parameters), [1, 0, 2]
    p = block.parameters
    assert p._fields == p.keys() == ("gain", "theta")
    assert p.gain == p["gain"] == p.get("gain", 3.0) == 0.5
    assert (p.get("none", 3.0), block.sizes) == (3.0, {"N": 3})
    np.testing.assert_array_equal(block.output(0, [], phi), 0.5 * THETA @ phi)
    np.testing.assert_array_equal(
        block.output(0, [], phi, {"mine.gain": 2.0}), 2 * THETA @ phi
    )
    assert pickle.loads(pickle.dumps(p)) is not p
    with pytest.raises(TypeError, match="assignment"):
        block.params["mine.gain"] = 2.0
    with pytest.raises(BlockError, match=r"Set mine.parameters"):
        block.params = {"mine.gain": 2.0}
    block.parameters = block.parameters._replace(gain=2.0)
    np.testing.assert_array_equal(block.output(0, [], phi), 2 * THETA @ phi)
    for theta, sizes in ((np.ones(3), None), (THETA, {"N": 4})):
        with pytest.raises(
            BlockError, match=r"mine\.theta: has shape .* must be \(2, "
        ):
            made({"gain": 0.5, "theta": theta}, sizes=sizes)


def test_parameters_and_ports_have_any_names():
    """As methods of tuples and arrays of the record have them."""
    ports = ("ref", "node", "store", "parent", "elements", "ports", "tape")

    def function(t, x, u, p):
        found = p.count * p["index"] if "count" in p and "none" not in p else 0.0
        return [found, *(2.0 * getattr(u, port)[0] for port in ports)]

    parameters = {"count": 3.0, "index": 2}
    block = static(function, dict.fromkeys(ports, 1), 8, parameters=parameters)
    assert as_it_runs(block, "output", 0.0, [], range(7)).tolist() == [
        6,
        *range(0, 14, 2),
    ]


WAYS = [  # of one value for ports a[2] and b[2, 2]
    lambda t, x, u, p: {"a": u.v[:2], "b": np.outer(u.v[:2], u.v[1:])},
    lambda t, x, u, p: {"b": np.outer(u.v[:2], u.v[1:]), "a": u.v[:2]},
    lambda t, x, u, p: np.concatenate([u.v[:2], np.outer(u.v[:2], u.v[1:]).ravel()]),
    lambda t, x, u, p: [u.v[:2], np.outer(u.v[:2], u.v[1:])],
    lambda t, x, u, p: (u[0], u[1], u[0] * u[1], u[0] * u[2], u[1] * u[1], u[1] * u[2]),
]


@pytest.mark.parametrize("way", WAYS)
def test_values_may_be_returned_in_any_form(way):
    block = static(way, {"v": 3}, {"a": 2, "b": (2, 2)})
    found = as_it_runs(block, "output", 0.0, [], [2.0, 3.0, 5.0])
    np.testing.assert_array_equal(found, [2, 3, 6, 10, 9, 15])
    assert block.output_labels == ["a[0]", "a[1]", "b[0]", "b[1]", "b[2]", "b[3]"]
    assert block.output_shapes == {"a": (2,), "b": (2, 2)}
    assert block.output_ports == {"a": 2, "b": 4}


def riccati(t, x, u, p):
    """P' = u P - P P, K' = P row 1, with all of x asked by its places too."""
    return {"P": u.rate * x.P - x.P @ x.P, "K": x.P[1] + x[0] * x[-1]}


def test_states_are_views_of_one_vector():
    ports = {
        "inputs": {"rate": 1},
        "states": {"P": ("n", "n"), "K": "n"},
        "sizes": {"n": 2},
    }
    block = Block("mine", update=riccati, **ports)
    P = np.array([[1.0, 2], [3, 4]])
    x = np.arange(1.0, 7)
    wanted = [*(0.5 * P - P @ P).ravel(), *(P[1] + 1.0 * 6.0)]
    np.testing.assert_allclose(as_it_runs(block, "update", 0.0, x, [0.5]), wanted)
    np.testing.assert_array_equal(block.output(0, x, [0.5]), x)
    assert (block.states_are_outputs, block.output_function) == (True, None)
    np.testing.assert_array_equal(recorded(block, "output", 0.0, x, [0.5]), x)
    assert not block.feedthrough


OUT = {"output": flow, "outputs": {"y": 1}}
CANNOT = [
    ({"inputs": {"u": 1}}, "without states needs `output`"),
    ({"update": flow, **OUT}, "`update` has the rates of `states`"),
    (
        {"update": flow, "states": {"x": 1}, "outputs": {"y": 1}},
        "outputs are the states",
    ),
    (OUT | {"parameters": 3}, "a dict, a NamedTuple or a dataclass"),
    (OUT | {"inputs": {"phi": "N"}}, "the size 'N' is not known"),
    (OUT | {"inputs": ["e"]}, r"must be a dict.* \{'e': 2\}$"),
    (OUT | {"outputs": {"y": 1.5}}, r"must be a dict of whole numbers or texts"),
    (OUT | {"outputs": {"y": -1}}, "must be a whole number, 0 or more, or a name"),
    (OUT | {"outputs": {"a.b": 1}}, "must not be empty, begin with a sign"),
    (OUT | {"parameters": {"a": "b"}}, r"mine\.a = 'b'"),
    (OUT | {"parameters": {"a b": 1.0}}, "'a b' must be a Python name"),
    (OUT | {"breakpoints": lambda p, a, b: []}, "`interval = -1"),
    (OUT | {"shapes": {"a": "N"}}, "'a', which is not a parameter"),
    (OUT | {"dt": -1}, "dt = -1"),
    (OUT | {"dt": 1.0, "breakpoints": min}, "no breakpoints"),
]


@pytest.mark.parametrize(("declared", "words"), CANNOT)
def test_declarations_that_cannot_work(declared, words):
    with pytest.raises((ArgumentError, BlockError), match=rf"\A.*{words}.*\Z"):
        Block("mine", **declared)


# --- other names --------------------------------------------------------------------------------


def test_a_block_in_a_namespace_is_the_same_under_other_names():
    block, phi = made(KINDS[0]), [1.0, -2.0, 0.5]

    def asked(one):
        found = one.output(0, [], phi)
        np.testing.assert_array_equal(recorded(one, "output", 0, [], phi), found)
        return found.tolist()

    wanted = (0.5 * THETA @ phi).tolist()
    assert asked(block) == wanted
    for twin in (copy.deepcopy(block), block.copy(name="twin")):
        # are independent
        twin.parameters = twin.parameters._replace(gain=3.0, theta=np.ones((2, 3)))
        assert asked(twin) == [3 * sum(phi)] * 2
    assert asked(block) == wanted


# --- linear systems -------------------------------------------------------------------------------

SYSTEMS = [
    control.ss(
        [[-1.0, 2.0], [0.0, -3.0]], [[0.0], [1.0]], [[1.0, 1.0]], [[0.5]], name="a"
    ),
    control.ss([[-1.0]], [[1.0]], [[2.0]], 0, name="lag"),
    control.tf([1.0, 2.0], [1.0, 3.0, 2.0], name="t"),
    control.zpk([-1.0], [-2.0, -3.0], 4.0, name="z"),
    control.ss([], [], [], [[1.0, 2.0], [3.0, 4.0]], name="gain"),
]


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda s: s.name)
def test_a_linear_system_is_a_block(system):
    numbers, block = np.random.default_rng(0), linear(system)
    plain = system if isinstance(system, control.StateSpace) else control.ss(system)
    x, u = (numbers.normal(size=n or 0) for n in (block.nstates, block.ninputs))
    as_it_runs(block, "output", 0.0, x, u)
    assert block.feedthrough == bool(np.any(plain.D))
    if block.nstates:
        as_it_runs(block, "update", 0.0, x, u)
        near = block.linearize(0 * x, 0 * u)
        for s in (0.3j, 2.0j):
            np.testing.assert_allclose(near(s), plain(s), rtol=1e-6)


def test_records_at_many_times_have_the_interval_of_each_time():
    """Breakpoints at 0.5, 1.0, ...: time 0.6 is in interval 1."""
    parameters = {"step": 0.5, "interval": -1.0}
    block = Block(
        "clock",
        output=lambda t, x, u, p: p.interval,
        outputs={"y": 1},
        parameters=parameters,
        breakpoints=Each("step"),
    )
    values = evaluate(block, [0.0, 0.6, 1.0, 1.2], np.zeros((4, 0)))
    np.testing.assert_array_equal(values.ravel(), [0, 1, 2, 2])
