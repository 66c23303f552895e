"""Prepared runs: arrays of many runs of one diagram."""

from functools import partial

import control
import numpy as np
import pytest
from refusals import refuses
from scipy.integrate import solve_ivp

import clpt_control as clpt

TIMES = np.linspace(0.0, 2.0, 9)
RATE = 1.0


def rates(t, x, u, p):
    return [-p["k"] * x[0] + u[0]]


def system(function=rates, output=None, **params):
    return control.nlsys(
        function, output, inputs=1, states=1, outputs=1, params=params, name="lag"
    )


def test_states_and_outputs_of_each_call_are_those_of_simulate():
    lag = system(output=lambda t, x, u, p: [3.0 * x[0] + u[0]], k=1.0)
    run = clpt.prepare(lag, TIMES, 0.5, [2.0], {"k": 1.0})
    for k, start, u in [(1.0, 2.0, 0.5), (3.0, -1.0, 0.0), (0.5, 4.0, 1.0)] * 5:
        states, outputs = run([start], u, {"k": k})
        expected = u / k + (start - u / k) * np.exp(-k * TIMES)
        np.testing.assert_allclose(states[:, 0], expected, rtol=1e-7, atol=1e-9)
        np.testing.assert_allclose(outputs[:, 0], 3 * states[:, 0] + u, rtol=1e-12)
        whole = clpt.simulate(lag, TIMES, u, [start], {"k": k})
        assert whole.states.values.tobytes() == states.tobytes()
    again = run()
    assert again.states[-1, 0] == pytest.approx(0.5 + 1.5 * np.exp(-2.0), rel=1e-7)


def test_inputs_of_a_call_are_samples_joined_by_lines():
    run = clpt.prepare(system(k=1.0), TIMES)
    states = run(inputs=TIMES[None]).states[:, 0]
    np.testing.assert_allclose(states, TIMES - 1 + np.exp(-TIMES), atol=1e-9)


@pytest.mark.parametrize("times", [[0.0, 0.5, 5.0], [0.0, 1.0], [0.0, 0.2, 0.5]])
def test_a_run_that_a_guard_stops_is_refused(times):
    half = clpt.Guard(lambda t, x, u, p: x[0] - 0.5, "stop")
    falls = clpt.Block(
        "falls", update=lambda t, x, u, p: [-2.0 * x[0]], states={"x": 1}, guard=half
    )
    run = clpt.prepare(falls, times, initial_state=[1.0])
    refuses("ended at t = 0.34657", run, error=clpt.SimulationError)


def test_parameters_of_a_call_are_a_dict():
    run = clpt.prepare(system(k=1.0), TIMES, params={"k": 1.0})
    refuses(
        "params = 3: must be a dict of values by name",
        run,
        params=3,
        error=clpt.ArgumentError,
    )


def test_inputs_jump_at_repeated_times():
    run = clpt.prepare(system(k=1.0), [0.0, 1.0, 1.0, 2.0])
    states = run([1.0], np.array([[1.0, 1.0, 3.0, 3.0]])).states[:, 0]
    np.testing.assert_allclose(states, [1.0, 1.0, 3.0 - 2.0 * np.exp(-1)], atol=1e-8)


def test_a_parameter_that_code_was_made_for_is_read_again():
    def repeated(t, x, u, p):
        rate = 0.0
        for _ in range(int(p["n"])):
            rate = rate - x[0]
        return [rate]

    run = clpt.prepare(system(repeated, n=1.0), TIMES, None, [1.0], {"n": 1.0})
    for n in (2.0, 1.0, 3.0):
        last = run(params={"n": n}).states[-1, 0]
        assert last == pytest.approx(np.exp(-2.0 * n), rel=1e-6)
    assert run().states[-1, 0] == pytest.approx(np.exp(-2.0), rel=1e-6)


def test_whole_and_equal_parameters_vary_apart():
    def two(t, x, u, p):
        return [-p["a"] * x[0] + p["b"] * u[0]]

    params = {"a": 1, "b": 1.0}
    run = clpt.prepare(system(two, **params), TIMES, 1.0, [0.0], params)
    for a, b in [(1, 2.0), (2, 1.0), (2, 3.0)]:
        last = run(params={"a": a, "b": b}).states[-1, 0]
        assert last == pytest.approx(b / a * (1 - np.exp(-2.0 * a)), rel=1e-6)


def test_what_changed_counts_at_the_next_call(monkeypatch):
    run = clpt.prepare(system(lambda t, x, u, p: [-RATE * x[0]]), TIMES, 0.0, [1.0])
    for rate in [1.0] * 20 + [2.0, 3.0]:
        monkeypatch.setitem(globals(), "RATE", rate)
        assert run().states[-1, 0] == pytest.approx(np.exp(-2.0 * rate), rel=1e-6)


@pytest.mark.filterwarnings("ignore")
def test_a_diagram_in_python_has_the_same_numbers():
    def opaque(t, x, u, p):
        return [-p["k"] * float(str(float(x[0])))]

    run = clpt.prepare(system(opaque, k=1.0), TIMES, None, [1.0], {"k": 1.0})
    for k in (1.0, 2.0):
        last = run(params={"k": k}).states[-1, 0]
        assert last == pytest.approx(np.exp(-2.0 * k), rel=1e-6)


def test_a_vector_of_parameters_and_two_systems():
    plant = system(lambda t, x, u, p: [-p["w"][0] * x[0] + p["w"][1] * u[0]])
    plant.params["w"] = np.array([1.0, 1.0])
    run = clpt.prepare(plant, TIMES, 1.0, [0.0], {"w": np.array([1.0, 1.0])})
    last = run(params={"w": np.array([2.0, 4.0])}).states[-1, 0]
    assert last == pytest.approx(2.0 * (1 - np.exp(-4.0)), rel=1e-6)
    both = control.interconnect(
        [system(k=1.0).copy("a"), system(k=1.0).copy("b")],
        [["b.u[0]", "a.y[0]"]],
        ["a.u[0]"],
        ["b.y[0]"],
    )
    run = clpt.prepare(both, TIMES, 1.0, params={"a.k": 1.0, "b.k": 1.0})
    outputs = run(params={"a.k": 2.0, "b.k": 0.5}).outputs

    def exact(t, x):
        return [1.0 - 2.0 * x[0], x[0] - 0.5 * x[1]]

    found = solve_ivp(exact, (0, 2), [0, 0], "DOP853", TIMES, rtol=1e-10, atol=1e-12)
    np.testing.assert_allclose(outputs[:, 0], found.y[1], atol=1e-8)


def test_refusals():
    refused = partial(refuses, error=clpt.SimulationError)
    run = clpt.prepare(system(k=1.0), TIMES, 0.0, [1.0], {"k": 1.0})
    refused("kk was not given to prepare", run, params={"kk": 2.0})
    refuses(
        "k = nan: must be a number", run, params={"k": np.nan}, error=clpt.BlockError
    )
    refused("must have the shape", run, params={"k": [1.0, 2.0]})
    refuses(r"initial_state = \[inf\]", run, [np.inf], error=clpt.ArgumentError)
    refuses("must have 1 finite", run, [1.0, 2.0], error=clpt.ArgumentError)
    refused("inputs: must be finite", run, [1.0], np.nan)
    refused("inputs: shape", run, [1.0], np.zeros(3))
    discrete = control.ss([[0.5]], [[1.0]], [[1.0]], 0, dt=1.0)
    refused("discrete time", clpt.prepare, discrete, [0.0, 1.0])
    pole = clpt.prepare(system(lambda t, x, u, p: [x[0] ** 2]), TIMES)
    refused("stopped at t = ", pole, [1.0])
