"""Values of members, and the members that have them."""

import json
from pathlib import Path

import numpy as np
import pytest
from ensemble_stores import VARY

import clpt_control
from clpt_control.ensemble.drawn_values import draw_members, read_varies
from clpt_control.ensemble.of_scenarios import VariedScenario, variable_values
from clpt_control.ensemble.run import run_ensemble
from clpt_control.ensemble.spread import ensemble_summary
from clpt_control.simulation.summary import run_and_report

HERE = Path(__file__).parents[1]


def draw(scenario, vary, members, design="lhs", seed=0):
    return draw_members(VariedScenario(scenario), read_varies(vary), members, design, seed)


def test_a_latin_hypercube_draws_once_from_each_part(scenario):
    values = draw(scenario, ["learning.gain=0.2:2.0", "learning.position=-1:1"], 64, seed=5)
    for column in (
        (values["learning.gain"] - 0.2) / 1.8,
        *((values["learning.position"].T + 1) / 2),
    ):
        assert sorted(np.floor(column * 64).astype(int)) == list(range(64))
    assert np.abs(np.corrcoef(values["learning.position"].T)[0, 1]) < 0.5


@pytest.mark.parametrize("design", ["lhs", "random"])
def test_normal_has_an_absolute_deviation_about_the_scenario(scenario, design):
    values = draw(scenario, "flow.parameters~normal:0.1", 4000, design)["flow.parameters"]
    assert values.shape == (4000, 2, 3)
    centred = values - np.array(scenario.flow.parameters)
    np.testing.assert_allclose(centred.mean(axis=0), 0, atol=0.01)
    np.testing.assert_allclose(centred.std(axis=0), 0.1, rtol=0.05)
    assert np.abs(np.mean(np.abs(centred) < 0.1) - 0.6827) < 0.01


def test_a_grid_has_every_combination(scenario):
    vary = ["learning.gain=[0.5, 1, 2]", "reference.radius=2:4", "vehicle.feedforward=0.5:1.5"]
    values = draw(scenario, vary, 3 * 27, "grid")
    found = np.column_stack(
        [values["learning.gain"], values["reference.radius"], values["vehicle.feedforward"]]
    )
    assert len(np.unique(found, axis=0)) == 81
    assert set(values["learning.gain"]) == {0.5, 1.0, 2.0}
    assert set(values["reference.radius"]) == {2.0, 3.0, 4.0}
    quantiles = draw(scenario, "learning.gain~normal:0.1", 2, "grid")["learning.gain"]
    np.testing.assert_allclose(quantiles - 0.8, [-0.067449, 0.067449], atol=1e-6)


def test_levels_of_arrays_and_balance(scenario):
    rows = [[0.5, 0.5], [1.0, 2.0]]
    values = draw(scenario, f"vehicle.feedback={json.dumps(rows)}", 10)["vehicle.feedback"]
    assert sorted(map(tuple, values)) == [(0.5, 0.5)] * 5 + [(1.0, 2.0)] * 5


def test_values_depend_on_seed_design_members_and_number_alone(scenario):
    alone = draw(scenario, "learning.gain=0.2:2.0", 50, seed=2)["learning.gain"]
    among = draw(scenario, VARY[::-1], 50, seed=2)["learning.gain"]
    assert alone.tobytes() == among.tobytes()
    others = [draw(scenario, VARY, 50, seed=3), draw(scenario, VARY, 50, "random", seed=2)]
    assert all(alone.tobytes() != other["learning.gain"].tobytes() for other in others)


def test_every_key_that_may_vary_can(quick):
    square = {"kind": "square", "amplitude": [0.05, 0.0], "period": 1.8}
    disturbed = quick.with_values({"flow.disturbance": square})
    for key, base in variable_values(disturbed).items():
        level = (base * 1.01 + 0.001).tolist()
        data = run_ensemble(disturbed, f"{key}={json.dumps([level])}", 1)
        assert data["status"].values.tolist() == [1], key
        one = clpt_control.simulate(disturbed.with_values({key: level}))
        end = float(np.abs(one.flow_parameters_estimate - one.flow_parameters)[-1].max())
        assert abs(float(data["flow_parameter_error"][0, -1]) - end) < 1e-7, key


@pytest.mark.parametrize("number", [0, 17, 39])
def test_a_member_is_a_run_of_its_own(scenario, whole, number):
    own = {vary.split("=")[0].split("~")[0]: None for vary in VARY}
    values = {key: whole[key].values[number] for key in own}
    report = run_and_report(scenario.with_values(values))
    run, summary = report.run, report.summary
    for name in ("position", "predicted_position", "alpha", "feedback_gain", "feedforward_gain"):
        np.testing.assert_allclose(whole[name][number], run[name], rtol=0, atol=1e-6)
    np.testing.assert_array_equal(whole["time"], run["time"])
    last = summary["max_flow_parameter_error"]["100"]
    error = whole["flow_parameter_error"].sel(mark=100)[number]
    assert abs(float(error) - last) < 1e-6
    gain = whole["gain_error"].sel(mark=100)[number]
    assert abs(float(gain) - summary["max_gain_error"]["100"]) < 1e-6


def test_mean_squares_are_those_of_clpt_run(scenario):
    data = run_ensemble(scenario, "learning.gain=[0.8]", 1)
    wanted = run_and_report(scenario).summary
    np.testing.assert_allclose(data["clpe_rms"][0], wanted["clpe_rms_per_cycle"], atol=1e-7)
    assert abs(float(data["clpe_rms_whole"][0]) - wanted["clpe_rms"]) < 1e-7
    assert data.sizes["cycle"] == 2


@pytest.mark.parametrize("name", ["paper", "known_flow_biased"])
def test_reference_numbers(reference, name):
    found = [path for path in (HERE / "reference").glob("*.toml") if path.stem == name]
    if not found:
        pytest.skip(f"no reference scenario {name}")
    scenario = clpt_control.load_scenario(found[0])
    gain = scenario.learning.gain
    data = run_ensemble(scenario, f"learning.gain=[{gain}]", 1)
    numbers = reference[found[0].stem]
    np.testing.assert_allclose(data["clpe_rms"][0], numbers["clpe_rms_per_cycle"], atol=1e-6)
    wanted = numbers.get("max_flow_parameter_error") or {}
    for t in ("100", "200", "2000"):
        if t in wanted:
            got = float(data["flow_parameter_error"].sel(mark=float(t))[0])
            assert abs(got - wanted[t]) < 1e-6


def test_a_member_that_fails_costs_itself_alone(quick):
    vary = "vehicle.position=[[0, 0], [1e200, 0], [0, 0]]"
    data = run_ensemble(quick, vary, 3, "grid")
    status = data["status"].values
    assert status[0] == status[2] == 1
    assert status[1] in (2, 3)
    assert np.isnan(data["clpe_rms_whole"][1])
    assert float(data["end"][1]) < 10 == float(data["end"][0])
    summary = ensemble_summary(data)
    assert summary["ended"]["finished"] == 2
    assert summary["first_failed"] == 1
    assert summary["units"] == {"length": "m", "time": "s"}
    assert data["gain_error"][0].values.tobytes() == data["gain_error"][2].values.tobytes()
