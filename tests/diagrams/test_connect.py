"""Diagrams of blocks joined by the names of their ports, and the wiring that is read of any."""

from contextlib import nullcontext

import control
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

import clpt_control as clpt
from clpt_control.diagrams.interconnection import connect, wiring_of_blocks
from clpt_control.diagrams.wiring import wiring_of
from clpt_control.equations import Block
from clpt_control.equations.ports import ports_of, whole_labels
from clpt_control.errors import BlockError, DiagramError

TIMES = np.linspace(0.0, 3.0, 7)
ENGINES = ("native", "python")


def system(numbers, n, m, r, direct, name, inputs, outputs):
    """A random linear system, its ports called `inputs` and `outputs`."""
    A = numbers.normal(size=(n, n)) - 2 * np.eye(n)
    B, C = numbers.normal(size=(n, m)), numbers.normal(size=(r, n))
    D = direct * numbers.normal(size=(r, m))
    named = {
        "inputs": [f"{inputs}[{k}]" for k in range(m)],
        "outputs": [f"{outputs}[{k}]" for k in range(r)],
    }
    return control.ss(A, B, C, D, name=name, **named)


def test_labels_form_ports():
    assert ports_of(["v_c[0]", "a", "v_c[1]", "b[1]"]) == {"v_c": [0, 2], "a": [1], "b[1]": [3]}
    assert whole_labels(["v[0]", "a", "v[1]"]) == ["v[0]", "a[0]", "v[1]"]
    picked = ["v[2]", "v[0]", "v"]  # as of system[[2, 0], :]
    assert ports_of(whole_labels(picked[:2])) == {"v[2]": [0], "v": [1]}
    assert ports_of(whole_labels(picked[::-2])) == {"v": [0], "v[2]": [1]}


@settings(max_examples=12, deadline=None, derandomize=True)
@given(seed=st.integers(0, 10**6), n=st.integers(0, 3), m=st.integers(1, 3), r=st.integers(1, 3))
def test_two_random_systems_in_a_loop_are_their_matrix_exponential(seed, n, m, r):
    """Forward with feedthrough, back without: states go as expm of the whole matrix."""
    numbers = np.random.default_rng(seed)
    one = system(numbers, n, m, r, 1.0, "one", "u", "y")
    two = system(numbers, 2, r, m, 0.0, "two", "y", "u")
    loop = clpt.connect([one, two])
    whole = np.block([[one.A, one.B @ two.C], [two.B @ one.C, two.A + two.B @ one.D @ two.C]])
    start = numbers.normal(size=n + 2)
    exact = np.array([expm(whole * t) @ start for t in TIMES])
    scale = 1e-8 * (1 + np.abs(exact).max())
    for engine in ENGINES:
        run = clpt.simulate(loop, TIMES, 0, start, engine=engine, rtol=1e-11, atol=1e-13)
        np.testing.assert_allclose(run.states, exact, rtol=0, atol=scale)
        signals = run.u.values.reshape(len(TIMES), m)
        np.testing.assert_allclose(signals, exact[:, n:] @ two.C.T, rtol=0, atol=10 * scale)
    np.testing.assert_allclose(loop.dynamics(0, start, []), whole @ start, rtol=1e-12, atol=1e-12)


def servo():
    error = control.summing_junction(["r", "-y"], "e", name="error")
    law = control.tf([1, 2], [1, 0], inputs="e", outputs="u", name="law")
    plant = control.tf([1], [1, 1, 1], inputs="u", outputs="y", name="plant")
    return clpt.connect([error, law, plant], external="r", name="servo"), law, plant


def test_a_servo_of_transfer_functions_is_python_controls():
    loop, law, plant = servo()
    whole = control.feedback(control.tf(plant) * control.tf(law))
    theirs = control.forced_response(control.ss(whole), TIMES, np.ones_like(TIMES))
    for engine in ENGINES:
        run = clpt.simulate(loop, TIMES, 1, engine=engine, rtol=1e-11, atol=1e-13)
        np.testing.assert_allclose(run.y, theirs.outputs, atol=1e-9)
        assert run.attrs["engine"] == engine
        assert set(run.data_vars) == {"e", "u", "y", "r", "states"}
    poles = np.sort_complex(control.linearize(loop, [0, 0, 0], [0]).poles())
    np.testing.assert_allclose(poles, np.sort_complex(whole.poles()), atol=1e-5)


def test_matrices_are_parameters_in_every_reading():
    loop, *_ = servo()
    changes = {"law.C": [[3.0]], "law.D": [[0.5]], "plant.A": [[-2.0, -1.0], [1.0, 0.0]]}
    runs = [clpt.simulate(loop, TIMES, 1, params=changes, engine=engine) for engine in ENGINES]
    np.testing.assert_allclose(runs[0].y, runs[1].y, rtol=0, atol=1e-9)
    x = np.array([0.3, -0.4, 0.7])
    u = 3.0 * x[0] + 0.5 * (1.0 - x[2])
    rate = loop.dynamics(0, x, [1.0], params=changes)
    np.testing.assert_allclose(rate, [1.0 - x[2], -2.0 * x[1] - x[2] + u, x[1]], rtol=1e-13)
    with pytest.raises(BlockError, match=r"unknown parameter 'plant\.D'"):  # it has none to change
        clpt.simulate(loop, TIMES, 1, params={"plant.D": [[1.0]]})


def test_a_matrix_of_transfer_functions():
    part = control.tf([[[1], [2]], [[0], [1, 3]]], [[[1, 1], [1, 2]], [[1], [1, 4]]], name="M")
    run = clpt.simulate(clpt.connect([part], external="u"), TIMES, [1, -1], rtol=1e-11, atol=1e-13)
    slow, fast, late = (1 - np.exp(-k * TIMES) for k in (1, 2, 4))
    np.testing.assert_allclose(run.y[:, 0], slow - fast, atol=1e-9)
    np.testing.assert_allclose(run.y[:, 1], -1 + 0.25 * late, atol=1e-9)


def leaks(t, x, u, params):
    return -params["k"] * x + u


def leaks_unread(t, x, u, params):
    return -params["k"] * float(f"{x[0]}") + u


@pytest.mark.parametrize("update", [leaks, leaks_unread])
def test_a_system_by_functions_runs_or_says_why_in_python(update):
    part = control.nlsys(update, inputs="u", outputs="y", states=1, name="leak", params={"k": 2.0})
    loop = clpt.connect([part, control.ss([], [], [], -1.0, inputs="y", outputs="u", name="back")])
    said = (
        pytest.warns(UserWarning, match=r"runs in Python, .*leaks_unread, line \d+")
        if update is leaks_unread
        else nullcontext()
    )
    with said:
        run = clpt.simulate(loop, TIMES, 0, [1.0], params={"k": 1.0})
    assert run.attrs["engine"] == ("native" if update is leaks else "python")
    np.testing.assert_allclose(run.y, np.exp(-2 * TIMES), atol=1e-6)


def test_what_does_not_fit_is_said_with_a_cure():
    tank = clpt.parts.lag(1.0, y="h")
    for own, external, said in (
        ({}, (), r"'r'.*there are h, u; external='r' takes it from outside"),
        ({}, "rr", r"did you mean rr\?; there are h, rr, u"),
        ({"signals": 2}, "r", "'u' has 2 signals, but lag takes 1; both must have one size"),
    ):
        with pytest.raises(DiagramError, match=said):
            clpt.connect([tank, clpt.parts.pid(1, 0.1, y="h", **own)], external)


def handing_on(name, port, to, unit):
    return Block(
        name,
        output=lambda t, x, u, p: [u[0]],
        inputs={port: 1},
        outputs={to: 1},
        units={"e": unit} if unit else None,
    )


def test_a_port_has_one_unit():
    maker, outside = handing_on("sonar", "r", "e", "km"), handing_on("log", "e", "v", "m s-1")
    for ends, external, fits in (
        ((maker, handing_on("law", "e", "y", "m")), "r", False),
        ((maker, handing_on("law", "e", "y", "km")), "r", True),
        ((maker, handing_on("law", "e", "y", None)), "r", True),
        ((outside, handing_on("law", "e", "y", "m/s")), "e", True),
        ((outside, handing_on("law", "e", "y", "knots")), "e", False),
    ):
        with (
            nullcontext()
            if fits
            else pytest.raises(
                DiagramError, match=r"'e' is in '.*' at (sonar|log) and in '.*' at law"
            )
        ):
            clpt.connect(ends, external)


@pytest.mark.parametrize(
    ("part", "said"),
    [
        (control.tf(1, [1, 1]), r"a TransferFunction without a name: .* name='lag'"),
        (control.ss(-1, 1, 1, 0, True, name="held"), "held: dt = True does not say how often"),
        (
            control.tf([1, 0, 1], [1, 1], name="pd"),
            r"pd: a numerator of higher degree .* fast pole",
        ),
        (2.0, r"2\.0 is no block: give"),
        (control.nlsys(lambda t, x, u, params: -x, states=1, name="q"), "q: how many inputs"),
        (control.ss(-1, 1, 1, 0, inputs="zc", outputs="q", name="p"), r"'zc' has 2 .*signals="),
    ],
)
def test_what_cannot_be_a_part_is_refused_in_a_sentence(part, said):
    with pytest.raises(clpt.ClptError, match=said) as caught:
        clpt.connect([*clpt.paper_blocks(clpt.paper_scenario()), part])
    assert "\n" not in str(caught.value)


def test_two_values_of_one_parameter_are_refused():
    """python-control gives both systems that of the last."""

    def leak(k, name, u, y):
        return control.nlsys(leaks, None, inputs=u, outputs=y, states=1, params={"k": k}, name=name)

    with pytest.raises(DiagramError, match=r"k = 3\.0 of two is 1\.0 of one: .*{'one\.k': \.\.\.}"):
        clpt.connect([leak(1.0, "one", "u", "v"), leak(3.0, "two", "v", "y")], external="u")
    loop = clpt.connect([leak(3.0, "one", "u", "v"), leak(3.0, "two", "v", "y")], external="u")
    run = clpt.simulate(loop, TIMES, 1.0, params={"one.k": 1.0})
    np.testing.assert_allclose(run.v, 1 - np.exp(-TIMES), atol=1e-7)


def test_one_vehicle_of_two_diagrams_is_reached_by_its_name():
    own = clpt.closed_loop(clpt.paper_scenario())
    a, b = own.copy(name="a"), own.copy(name="b")
    both = control.interconnect(
        [a, b], outlist=["a.e[0]", "b.e[0]"], outputs=2, name="both", check_unused=False
    )
    x = np.random.default_rng(1).normal(size=28)
    start = [*clpt.initial_state(clpt.paper_scenario())]
    one, two = (own.dynamics(1.0, x[k], [])[4:] for k in (slice(14), slice(14, 28)))
    for changes, factors in (
        ({"a.adaptation.gain": 1.6}, (2, 1)),
        ({"b.adaptation.gain": 1.6}, (1, 2)),
        ({"adaptation.gain": 1.6}, (2, 2)),
        ({"adaptation.gain": 1.6, "a.adaptation.gain": 2.4}, (3, 2)),
    ):
        rate = both.dynamics(1.0, x, [], params=changes)
        np.testing.assert_allclose(rate[4:14], factors[0] * one, rtol=1e-13)
        np.testing.assert_allclose(rate[18:], factors[1] * two, rtol=1e-13)
        runs = [
            clpt.simulate(both, [0, 3], 0, start * 2, params=changes, engine=e) for e in ENGINES
        ]
        np.testing.assert_allclose(runs[0].states, runs[1].states, rtol=0, atol=1e-8)
        end = clpt.state_at(runs[0], 3)
        assert np.array_equal(end[4:14], end[18:]) == (factors[0] == factors[1])
    with pytest.raises(BlockError, match=r"unknown parameter 'c\.adaptation\.gain'"):
        clpt.simulate(both, [0, 3], 0, start * 2, params={"c.adaptation.gain": 2.0})
    with pytest.raises(DiagramError, match=r"made by both a and b.*control\.interconnect"):
        clpt.connect([a, b])


# --- states and inputs as python-control takes them --------------------------------------------


def test_states_and_inputs_are_stacked_as_python_control_stacks_them():
    parts = [
        system(np.random.default_rng(3), 2, 2, 1, 1.0, "one", "u", "y"),
        system(np.random.default_rng(4), 2, 1, 1, 0.0, "two", "y", "w"),
    ]
    loop, ramp = clpt.connect(parts, external="u"), TIMES - 1.0
    for inputs, start in (
        ([ramp, 0], [[0.5, -1.0], 0]),
        ([2.0, ramp], [0.5, [1.0, 0.0], 0]),
        (np.vstack([ramp, ramp]), 1.0),
        (0, [0]),
    ):
        theirs = control.input_output_response(
            loop,
            TIMES,
            inputs,
            start,
            solve_ivp_method="DOP853",
            solve_ivp_kwargs={"rtol": 1e-10, "atol": 1e-12},
        )
        run = clpt.simulate(loop, TIMES, inputs, start, rtol=1e-11, atol=1e-13)
        np.testing.assert_allclose(run.states.T, theirs.states, atol=1e-7)
        np.testing.assert_allclose(run.u.T, theirs.inputs, atol=1e-12)
    for start in ([1, 2, 3, 4, 5], [[1, 2], [3, 4], 0]):
        with pytest.raises(clpt.SimulationError, match="initial_state: must have 4 numbers"):
            clpt.simulate(loop, TIMES, 0, start)
    for inputs in ([ramp], [ramp[1:], 0], [[ramp, ramp], ramp], ["fast", 0], [ramp, "fast"]):
        with pytest.raises(clpt.ClptError, match="inputs"):
            clpt.simulate(loop, TIMES, inputs)


def same(one, other):
    assert one.ninputs == other.ninputs
    assert one.order == other.order
    assert one.output_map.shape == other.output_map.shape
    maps = [wiring.output_map @ np.eye(wiring.output_map.shape[1]) for wiring in (one, other)]
    np.testing.assert_array_equal(*maps)
    for mine, theirs in zip(one.nodes, other.nodes, strict=True):
        assert mine.name == theirs.name
        for part in ("states", "inputs", "outputs"):
            assert getattr(mine, part) == getattr(theirs, part)
        assert sorted(mine.wires) == sorted(theirs.wires)


def passed_on(t, x, u, p):
    return u


def test_ports_in_another_order_than_their_makers():
    def block(name, inputs, outputs):
        return Block(name, output=passed_on, inputs=inputs, outputs=outputs)

    blocks = [
        block("last", {"d": 1, "c": 2, "w": 1}, {"e": 4}),
        block("middle", {"b": 2, "a": 2}, {"c": 2, "d": 1, "f": 1}),
        block("first", {"w": 1, "v": 3}, {"a": 2, "b": 2}),
    ]
    for external in (["v", "w"], ["w", "v"]):
        same(wiring_of_blocks(blocks, external), wiring_of(connect(blocks, external)))
