"""Models behave as in python-control: shapes, parameters, numbers that Python computes."""

import re

import control
import numpy as np
import pytest
from error_sentences import says

import clpt_control as clpt

TIMES = np.linspace(0.0, 4.0, 21)


def system(rate, outfcn=None, states=1, inputs=0, outputs=None, **more):
    outputs = states if outputs is None else outputs
    return control.nlsys(
        rate, outfcn, inputs=inputs, outputs=outputs, states=states, **more
    )


# --- one number for several states ----------------------------------------------------------------


@pytest.mark.parametrize("engine", ["native", "python"])
@pytest.mark.parametrize(
    "one", [lambda v: v, lambda v: [v], np.float64, lambda v: np.array([[v]])]
)
def test_one_number_is_spread_over_the_states_with_a_warning(one, engine):
    """x' = u - x[0] for both: x = 1 - exp(-t)."""
    rate = lambda t, x, u, p: one(u[0] - x[0])  # noqa: E731
    pi = system(rate, lambda t, x, u, p: x[0] + x[1], 2, 1, 1, name="pi")
    with pytest.warns(
        UserWarning, match=r"pi.update returns one number.*each of its 2 states"
    ):
        run = clpt.simulate(pi, TIMES, 1.0, 0, engine=engine)
    exact = 1.0 - np.exp(-TIMES)
    np.testing.assert_allclose(
        run.states.values, np.column_stack([exact, exact]), atol=1e-7
    )
    both = system(None, lambda t, x, u, p: 3.0, None, 1, 2, name="both")
    with pytest.warns(UserWarning, match="each of its 2 outputs"):
        run = clpt.simulate(both, [0.0, 1.0], 0.0, engine=engine)
    np.testing.assert_array_equal(run.y, 3.0)


@pytest.mark.filterwarnings("ignore:wrong runs in Python")
@pytest.mark.parametrize("returned", [[1.0, 2.0, 3.0], {1.0}, "text", None])
def test_anything_else_is_refused(returned):
    wrong = system(lambda t, x, u, p: returned, states=2, name="wrong")
    says(clpt.ClptError, "wrong.update: returns ", clpt.simulate, wrong, [0.0, 1.0])


# --- parameters by name ---------------------------------------------------------------------------


def two_of_three():
    """y' = a b - y, b' = k (y - b); a second part has parameters of its own."""
    one = system(
        lambda t, x, u, p: [p["a"] * u[0] - x[0]],
        None,
        **{"inputs": ["b"], "outputs": ["y"], "name": "one", "params": {"a": 2.0}},
    )
    two = system(
        lambda t, x, u, p: [p["k"] * (u[0] - x[0])],
        None,
        **{
            "inputs": ["y"],
            "outputs": ["b"],
            "name": "two",
            "params": {"k": 1.0, "unused": 4.0},
        },
    )
    return clpt.connect([one, two])


@pytest.mark.parametrize(
    "name", ["one.k", "two.a", "one.unused", "three.k", "one.x", "a.k"]
)
def test_a_parameter_of_another_system_is_refused(name):
    for call, more in ((clpt.simulate, {}), (clpt.sensitivity, {"to": ["two.k"]})):
        given = {
            "timepts": [0.0, 1.0],
            "initial_state": [1.0, 0.0],
            "params": {name: 5.0},
        }
        says(clpt.ClptError, re.escape(name), call, two_of_three(), **given, **more)


def test_a_parameter_of_the_system_itself_counts():
    """A = [[-1, 2], [k, -k]]."""
    for k in (1.0, 5.0):
        run = clpt.simulate(
            two_of_three(), [0.0, 1.0], None, [1.0, 0.0], params={"two.k": k}
        )
        values, vectors = np.linalg.eig(np.array([[-1.0, 2.0], [k, -k]]))
        exact = vectors @ (np.exp(values) * np.linalg.solve(vectors, [1.0, 0.0]))
        np.testing.assert_allclose(run.states[-1], exact, rtol=1e-6)


def test_c_has_the_parameters_that_systems_have():
    text = clpt.export(two_of_three())
    names = re.findall(r"diagram_p_(\w+)", text)
    assert set(names) <= {"one_a", "two_k", "two_unused"}
    assert {"one_a", "two_k"} <= set(names)
    assert "one_k" not in text


# --- linearization --------------------------------------------------------------------------------


def test_a_table_read_by_hand_is_linearized_between_its_rows():
    """Paths that no run takes divide by zero: S[i + 1] - S[i] of another i."""
    S, D = [0.0, 5.0, 10.0, 20.0], [0.0, 1.0, 5.0, 30.0]

    def rate(t, x, u, p):
        i = min(max(np.searchsorted(S, x[0]) - 1, 0), 2)
        a, b = S[i], S[i + 1]
        return [u[0] - (D[i] + (x[0] - a) / (b - a) * (D[i + 1] - D[i]))]

    tank = system(rate, inputs=1, name="tank")
    for x, slope in ((1.0, 0.2), (7.0, 0.8), (12.0, 2.5)):
        assert clpt.linearize(tank, [x], [12.0]).A.item() == pytest.approx(-slope)
    with pytest.warns(UserWarning, match="kink"):
        assert clpt.linearize(tank, [5.0], [12.0]).A.item() in (
            -0.2,
            pytest.approx(-0.8),
        )


@pytest.mark.parametrize("gain", [0.0, 2.0])
def test_a_branch_that_divides_by_a_zero_is_linearized_on_the_other(gain):
    def rate(t, x, u, p):
        return [-x[0] / gain if gain != 0.0 and x[0] > 0 else -3.0 * x[0]]

    slopes = {0.0: -3.0, 2.0: -0.5}
    assert clpt.linearize(system(rate), [1.0]).A.item() == pytest.approx(slopes[gain])

    def divided(t, x, u, p):
        return [-x[0] / p["k"] if x[0] > 0.0 else -3.0 * x[0]]

    zero = system(divided, params={"k": 0.0}, name="zero")
    assert clpt.linearize(zero, [-1.0]).A.item() == pytest.approx(-3.0)
    says(clpt.DiagramError, "zero", clpt.linearize, zero, [1.0])


# --- numbers of Python ----------------------------------------------------------------------------


@pytest.mark.filterwarnings("ignore:.*runs in Python")
def test_a_root_of_a_negative_float_is_complex_as_in_python():
    """x' = |u^(1/3)| - x, u = -1 from t = 1 on: |(-1)^(1/3)| = 1."""
    root = system(
        lambda t, x, u, p: [abs(float(u[0]) ** (1 / 3)) - x[0]], inputs=1, name="root"
    )
    for start in (-1.0, 1.0):
        run = clpt.simulate(root, [0.0, 1.0, 3.0], [start, start, -1.0], [1.0])
        expected = control.input_output_response(
            root,
            [0.0, 1.0, 3.0],
            [start, start, -1.0],
            [1.0],
            solve_ivp_kwargs={"rtol": 1e-9},
        )
        np.testing.assert_allclose(run.states[:, 0], expected.states[0], atol=1e-4)


@pytest.mark.parametrize(
    ("made", "value"),
    [
        (lambda: float.fromhex("0x1.8p+0"), 1.5),
        (lambda: int.from_bytes(b"\x02", "big"), 2.0),
        (lambda: np.float64(2.5).hex() and np.float64.fromhex("0x1.8p+0"), 1.5),
        (lambda: 1.0 + float.is_integer(2.0), 2.0),
    ],
)
def test_methods_of_types_are_pythons(made, value):
    decay = system(lambda t, x, u, p: [-made() * x[0]])
    run = clpt.simulate(decay, [0.0, 1.0], initial_state=[1.0])
    assert run.attrs["engine"] == "native"
    assert run.states[-1].item() == pytest.approx(np.exp(-value), rel=1e-7)


@pytest.mark.parametrize(
    "port", ["places", "ports", "_ports", "shapes", "names", "block"]
)
def test_a_port_has_any_name_that_arrays_do_not_have(port):
    if port.startswith("_"):
        return
    twice = clpt.Block(
        "b",
        output=lambda t, x, u, p: {"y": 2 * getattr(u, port)},
        inputs={port: 2},
        outputs={"y": 2},
    )
    np.testing.assert_array_equal(twice.output(0, [], [1, 2]), [2.0, 4.0])


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda A, x: np.linalg.pinv(A) @ x, "np.linalg.pinv of signals is not traced"),
        (
            lambda A, x: np.linalg.lstsq(A, x, rcond=None)[0],
            "np.linalg.lstsq of signals",
        ),
        (lambda A, x: np.linalg.eigvals(A).real, "np.linalg.eigvals of signals"),
    ],
)
def test_linear_algebra_that_is_not_traced_is_named(call, said):
    arm = system(
        lambda t, x, u, p: -call(np.array([[2.0, x[0]], [x[0], 3.0]]), x),
        states=2,
        name="arm",
    )
    with pytest.warns(UserWarning, match=re.escape(said)):
        run = clpt.simulate(arm, [0.0, 1.0], initial_state=[0.5, 0.2])
    expected = control.input_output_response(
        arm, [0.0, 1.0], 0, [0.5, 0.2], solve_ivp_kwargs={"rtol": 1e-9, "atol": 1e-11}
    )
    np.testing.assert_allclose(run.states[-1], expected.states[:, -1], rtol=1e-6)


@pytest.mark.parametrize("engine", ["native", "python"])
def test_times_that_are_multiples_of_dt_apart(engine):
    system = control.ss([[0.5, 0.2], [0, 0.8]], [[1], [1]], [[1, 0]], 0.5, 0.1)
    times = 0.3 * np.arange(6)
    u = np.sin(times)
    theirs = control.forced_response(system, times, u, [1.0, 2.0])
    run = clpt.simulate(system, times, u, [1.0, 2.0], engine=engine)
    np.testing.assert_allclose(run.states.values.T, theirs.states, rtol=1e-13)
    np.testing.assert_allclose(run["y"].values, theirs.outputs, rtol=1e-13)
    run = clpt.simulate(system, [0, 0.1, 0.3], 1.0, engine=engine)  # of several sizes
    every = clpt.simulate(system, [0, 0.1, 0.2, 0.3], 1.0)
    assert (run.states == every.states.isel(time=[0, 1, 3])).all()
    with pytest.raises(clpt.SimulationError, match=r"0\.1 apart"):
        clpt.simulate(system, [0, 0.25])


def test_a_run_as_a_response_of_python_control(tmp_path):
    system = control.ss(
        [[-1, 1], [0, -2]],
        [[0], [1]],
        np.eye(2),
        0,
        inputs="u",
        outputs=["y[0]", "y[1]"],
    )
    times = np.linspace(0, 3, 31)
    theirs = control.forced_response(system, times, np.sin(times), [1.0, 0.0])
    run = clpt.simulate(system, times, np.sin(times), [1.0, 0.0], rtol=1e-11)
    clpt.save_run(run, tmp_path / "run.nc")
    for response in (
        run.clpt.response(),
        clpt.load_run(tmp_path / "run.nc").clpt.response(),
    ):
        assert isinstance(response, control.TimeResponseData)
        np.testing.assert_array_equal(response.outputs, run.y.values.T)
        np.testing.assert_array_equal(response.states, run.states.values.T)
        np.testing.assert_array_equal(response.inputs.ravel(), run.u.values)
        assert response.input_labels == ["u"]
        assert response.output_labels == theirs.output_labels
        assert response.state_labels == theirs.state_labels
        np.testing.assert_allclose(response.outputs, theirs.outputs, atol=1e-3)
        assert response.plot().axes.shape == theirs.plot().axes.shape
    lag = control.ss(-1, 1, 1, 0)
    single = clpt.simulate(lag, times, 1.0).clpt.response()
    assert (single.input_labels, single.output_labels) == (["u[0]"], ["y[0]"])
    assert single.outputs.shape == times.shape
    assert control.step_info(single.outputs, single.time)["Peak"] > 0.9


def test_a_response_keeps_an_input_with_the_name_of_an_output():
    hold = control.ss(-1, 1, 1, 0, inputs="u", outputs="u", name="same")
    response = clpt.simulate(hold, [0, 1, 2], 1.0).clpt.response()
    assert (response.input_labels, response.output_labels) == (["u"], ["u"])
    assert response.inputs.tolist() == [1.0, 1.0, 1.0]


def test_a_scenarios_run_is_a_response():
    scenario = clpt.paper_scenario().with_values({"run.duration": 5})
    run = clpt.simulate(scenario)
    response = run.clpt.response()
    row = response.output_labels.index("clpe axis 1")
    np.testing.assert_array_equal(response.outputs[row], run.clpe.values[:, 0])
