"""Inputs and initial states in forms of python-control's users: jumps, names, responses."""

import control
import numpy as np
import pytest
from error_sentences import says

import clpt_control as clpt

TIMES = np.linspace(0.0, 2.0, 9)


def lag():
    return control.ss(
        -1, 1, 1, 0.5, inputs="torque", outputs="y", states=["angle"], name="lag"
    )


def driven(t, x, u, p):
    return -x + u


@pytest.mark.parametrize("begin", [0.0, -1.0])
@pytest.mark.parametrize("engine", ["native", "python"])
def test_a_repeated_time_is_a_jump_of_the_input(engine, begin):
    """A ramp t up to 1, then 3 - t: x = t - 1 + exp(-t), then 4 - t + c exp(-(t - 1))."""
    times = np.array([0.0, 0.5, 1.0, 1.0, 1.5, 2.0]) + begin
    u = [0.0, 0.5, 1.0, 2.0, 1.5, 1.0]
    run = clpt.simulate(lag(), times, u, engine=engine)
    t = np.array([0.0, 0.5, 1.0, 1.5, 2.0])
    after = 4.0 - t + (np.exp(-1.0) - 3.0) * np.exp(1.0 - t)
    x = np.where(t <= 1.0, t - 1.0 + np.exp(-t), after)
    right_limits = np.array([0.0, 0.5, 2.0, 1.5, 1.0])
    assert run.time.values.tolist() == (t + begin).tolist()
    np.testing.assert_allclose(run.states.values[:, 0], x, atol=2e-8)
    np.testing.assert_array_equal(run.torque.values, right_limits)
    np.testing.assert_allclose(run.y.values, x + 0.5 * right_limits, atol=2e-8)


def test_a_function_with_a_jump_of_its_input():
    plant = control.nlsys(driven, None, states=1, inputs=1, outputs=1, name="plant")
    run = clpt.simulate(plant, [0, 1, 1, 2], [0, 0, 1, 1])
    assert run.states.values[-1, 0] == pytest.approx(1 - np.exp(-1), abs=1e-8)


def test_values_at_the_ends_and_between_three_equal_times_do_not_count():
    times = [0, 0, 1, 1, 1, 2, 2]
    run = clpt.simulate(lag(), times, [9, 0, 0, 9, 1, 1, 7])
    assert run.time.values.tolist() == [0, 1, 2]
    assert run.states.values[-1, 0] == pytest.approx(1 - np.exp(-1), abs=1e-8)
    assert run.torque.values.tolist() == [0, 1, 7]
    double = control.ss(0.5, 1, 1, 0, 1.0)  # x+ = x / 2 + u
    run = clpt.simulate(double, [0, 1, 1, 2], [0, 0, 1, 1])
    assert run.states.values.ravel().tolist() == [0, 0, 1]


def test_constants_of_as_many_inputs_as_times():
    plant = control.ss([[-1]], [[1, 2, 3]], [[1]], 0, name="plant")
    with pytest.raises(clpt.SimulationError, match="at least two increasing times"):
        clpt.simulate(plant, [1, 1, 1], [1, 1, 1])
    jumping = clpt.simulate(plant, [0, 1, 1], [1, 2, 3]).states.values
    assert (jumping == clpt.simulate(plant, [0, 1], [1, 2, 3]).states.values).all()


def test_members_of_an_ensemble_see_the_jump():
    data = clpt.run_ensemble(
        lag(), {"angle": [0.0, 1.0]}, timepts=[0, 1, 1, 2], inputs=[0, 0, 1, 1]
    )
    final = 1 - np.exp(-1) + np.array([0.0, np.exp(-2)]) + 0.5
    np.testing.assert_allclose(data.y_final, final, atol=1e-8)


def test_inputs_and_states_by_name():
    expected = clpt.simulate(lag(), TIMES, 2.0, 1.0)
    named = clpt.simulate(lag(), TIMES, {"torque": 2.0}, {"angle": 1.0})
    assert named.equals(expected)
    both = control.ss(
        -np.eye(2), np.eye(2), np.eye(2), 0, inputs=["u[0]", "u[1]"], name="both"
    )
    rows = np.array([TIMES, 1 - TIMES])
    expected = clpt.simulate(both, TIMES, rows, [1.0, 2.0])
    named = clpt.simulate(both, TIMES, {"u": rows}, {"x": [1.0, 2.0]})
    assert named.equals(expected)
    named = clpt.simulate(
        both, TIMES, {"u[1]": rows[1], "u[0]": rows[0]}, {"x[1]": 2, "x[0]": 1}
    )
    assert named.equals(expected)


def test_a_state_of_a_block_by_its_dotted_name():
    loop = clpt.connect([lag()], external="torque")
    assert loop.state_labels == ["lag_angle"]
    for name in ("lag_angle", "lag.angle"):
        run = clpt.simulate(loop, TIMES, initial_state={name: 3.0})
        assert run.states.values[0, 0] == 3.0


def test_other_states_of_a_scenario_are_its_own():
    scenario = clpt.paper_scenario().with_values({"run.duration": 5})
    loop = clpt.closed_loop(scenario)
    label = loop.state_labels[0]
    start = clpt.initial_state(loop)
    start[0] += 1.0
    expected = clpt.simulate(loop, [0, 5], initial_state=start)
    named = clpt.simulate(loop, [0, 5], initial_state={label: start[0]})
    assert (named.states == expected.states).all()


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({"inputs": {"torqe": 1}}, "lag: has no input 'torqe'. Did you mean 'torque'"),
        ({"initial_state": {"speed": 1}}, "lag: has no state 'speed'. It has angle"),
        ({"initial_state": {"angle": [1, 2]}}, "must have 1 finite number;"),
        ({"inputs": {"torque": "much"}}, "must be an array of numbers"),
        (
            {"initial_state": {"angle": np.nan}},
            "initial_state['angle'] = [nan]: must be finite",
        ),
        ({"initial_state": [np.inf]}, "initial_state = [inf]: must be finite"),
    ],
)
def test_other_names_are_refused(arguments, sentence):
    with pytest.raises(clpt.ClptError) as error:
        clpt.simulate(lag(), TIMES, **arguments)
    assert sentence in str(error.value)


def test_a_block_without_inputs_has_no_names():
    free = control.nlsys(driven, None, states=1, inputs=0, outputs=1, name="free")
    with pytest.raises(clpt.ArgumentError, match=r"no input 'u'\. It has none"):
        clpt.simulate(free, TIMES, {"u": 1.0})


def test_signals_of_a_response_drive_inputs_of_their_names():
    motor = control.ss(-2, 2, 1, 0, inputs="v", outputs="torque", name="motor")
    response = control.step_response(motor, TIMES)
    expected = clpt.simulate(lag(), TIMES, response.outputs)
    assert clpt.simulate(lag(), TIMES, response).equals(expected)
    assert clpt.simulate(lag(), inputs=response).equals(expected)
    with pytest.raises(clpt.SimulationError, match="has no signal 'torque', but"):
        clpt.simulate(lag(), TIMES, control.step_response(control.ss(-1, 1, 1, 0), 1))
    with pytest.raises(clpt.SimulationError, match="Give timepts within these times"):
        clpt.simulate(lag(), [0, 5], response)


def test_samples_of_an_input_that_do_not_fit_the_times_are_named():
    said = r"inputs\['torque'\]: has 8 values; there are 9 times"
    inputs = {"torque": np.zeros(8)}
    says(clpt.ArgumentError, said, clpt.simulate, lag(), TIMES, inputs)
