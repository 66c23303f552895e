"""Values of members: how they are drawn, what is refused; members that have them; the command."""

import json
import re
from operator import attrgetter

import numpy as np
import pytest
from image_checks import inked
from paths import REFERENCE
from sampled_runs import VARY

import clpt_control
from clpt_control import ClptError, run_ensemble


def draw(scenario, vary, members, design="lhs", seed=0):
    """Return the values of an ensemble of runs that end at once, by key."""
    at_once = scenario.with_values({"run.duration": 0.01, "run.output_step": 0.01})
    data = run_ensemble(at_once, vary, members, design=design, seed=seed)
    keys = [one.partition("=")[0].partition("~")[0] for one in data.attrs["vary"]]
    return {key: data[key].values for key in keys}


def test_a_latin_hypercube_draws_once_from_each_part(scenario):
    values = draw(
        scenario, ["learning.gain=0.2:2.0", "learning.position=-1:1"], 64, seed=5
    )
    position = values["learning.position"].T
    for column in ((values["learning.gain"] - 0.2) / 1.8, *((position + 1) / 2)):
        assert sorted(np.floor(column * 64).astype(int)) == list(range(64))
    assert np.abs(np.corrcoef(position)[0, 1]) < 0.5


@pytest.mark.long
@pytest.mark.parametrize("design", ["lhs", "random"])
def test_normal_has_an_absolute_deviation_about_the_scenario(scenario, design):
    values = draw(scenario, "flow.parameters~normal:0.1", 4000, design)[
        "flow.parameters"
    ]
    assert values.shape == (4000, 2, 3)
    centred = values - np.array(scenario.flow.parameters)
    np.testing.assert_allclose(centred.mean(axis=0), 0, atol=0.01)
    np.testing.assert_allclose(centred.std(axis=0), 0.1, rtol=0.05)
    assert np.abs(np.mean(np.abs(centred) < 0.1) - 0.6827) < 0.01


@pytest.mark.long
def test_a_grid_has_every_combination(scenario):
    vary = [
        "learning.gain=[0.5, 1, 2]",
        "reference.radius=2:4",
        "vehicle.feedforward=0.5:1.5",
    ]
    values = draw(scenario, vary, 3 * 27, "grid")
    found = np.column_stack([*values.values()])
    assert len(np.unique(found, axis=0)) == 81
    assert set(values["learning.gain"]) == {0.5, 1.0, 2.0}
    assert set(values["reference.radius"]) == {2.0, 3.0, 4.0}
    quantiles = draw(scenario, "learning.gain~normal:0.1", 2, "grid")["learning.gain"]
    np.testing.assert_allclose(quantiles - 0.8, [-0.067449, 0.067449], atol=1e-6)


def test_levels_of_arrays_and_balance(scenario):
    rows = [[0.5, 0.5], [1.0, 2.0]]
    values = draw(scenario, f"vehicle.feedback={json.dumps(rows)}", 10)[
        "vehicle.feedback"
    ]
    assert sorted(map(tuple, values)) == [(0.5, 0.5)] * 5 + [(1.0, 2.0)] * 5


def test_values_depend_on_seed_design_members_and_number_alone(scenario):
    alone = draw(scenario, "learning.gain=0.2:2.0", 50, seed=2)["learning.gain"]
    among = draw(scenario, VARY[::-1], 50, seed=2)["learning.gain"]
    assert alone.tobytes() == among.tobytes()
    others = [
        draw(scenario, VARY, 50, seed=3),
        draw(scenario, VARY, 50, "random", seed=2),
    ]
    assert all(alone.tobytes() != other["learning.gain"].tobytes() for other in others)


GAIN, GRID = VARY[0], {"design": "grid"}
MISTAKES = [
    ("learning.gain", {}, "must be KEY=LOW:HIGH"),
    ("learning.gain=2:1", {}, "the first is the smaller"),
    ("learning.gain=0:inf", {}, "two finite numbers"),
    ("learning.gain~gamma:1", {}, "KEY~normal:DEVIATION"),
    ("learning.gain=" + "[" * 5000, {}, "KEY=[VALUE, ...]"),
    (f"learning.gain=[{'1' * 5000}]", {}, "KEY=[VALUE, ...]"),
    (f"learning.gain=[{'1' * 400}]", {}, "each value must be a number"),
    ("learning.gain=[true]", {}, "each value must be a number"),
    ("learning.position=[[1, 2, 3]]", {}, "must be an array of shape (2,)"),
    ([], {}, "name at least one key"),
    (["learning.gain=1:2", "learning.gain=1:2"], {}, "named 2 times"),
    ("learning.gian=1:2", {}, "did you mean learning.gain? May vary: basis.kernel"),
    ("nothing=1:2", {}, "nothing cannot vary; may vary: basis.kernel"),
    ("adaptation.gain=1:2", {}, "the scenario's key is learning.gain"),
    ("reference.count=5:10", {}, "cannot vary; "),
    ("run.duration=1:2", {}, "cannot vary; "),
    ('learning.law=["filtered"]', {}, "learning.law cannot vary. Call clpt.simulate"),
    ("basis.kernel=0:1", {}, "basis.kernel has no range. List the values"),
    ('basis.kernel=["gauss"]', GRID | {"members": 1}, "'exponential', 'gaussian' or"),
    ('basis.kernel=[["gaussian"]]', {}, "each value must be a text"),
    ("learning.gain=-1:2", {}, "to 0; narrow learning.gain=-1:2"),
    (
        "learning.gain=[1, 2, -3, 4]",
        {"members": 4, **GRID},
        "member 2: learning.gain = -3.0: mu",
    ),
    (GAIN, {"members": 0}, "members = 0: must be a whole number, 1 or more"),
    (GAIN, {"members": 2.5}, "members = 2.5: must be a whole number"),
    (GAIN, {"members": 10**20}, "would draw 1e+20 numbers; at most 2e+08"),
    (GAIN, {"members": 10**20, **GRID}, "would draw 1e+20 numbers"),
    (GAIN, {"seed": -1}, "seed = -1: must be a whole number"),
    (GAIN, {"design": "sobol"}, "must be one of lhs, grid, random"),
    (GAIN, {"chunk": 0}, "chunk = 0: must be a whole number"),
    (GAIN, {"threads": 0}, "threads = 0: must be a whole number"),
    (GAIN, {"times": [11.0]}, "11.0 must lie between 0 and run.duration = 10"),
    (
        "learning.gain=[1, 2]",
        {**GRID, "members": 5},
        "must have 2 members, every value with all val",
    ),
    (["learning.gain=[1, 2]", "learning.position=0:1"], GRID, "have 2 n^2 members"),
]


@pytest.mark.parametrize(("vary", "more", "sentence"), MISTAKES)
def test_mistakes_are_one_sentence(quick, tmp_path, vary, more, sentence):
    with pytest.raises(ClptError, match=rf"\A.*{re.escape(sentence)}.*\Z"):
        run_ensemble(quick, vary, out=tmp_path / "e.zarr", **{"members": 10, **more})
    assert list(tmp_path.iterdir()) == []


# --- what members are, and show ------------------------------------------------------------------


@pytest.mark.long
def test_every_key_that_may_vary_can(quick):
    square = {"kind": "square", "amplitude": [0.05, 0.0], "period": 1.8}
    disturbed = quick.with_values({"flow.disturbance": square})
    with pytest.raises(ClptError) as refused:
        run_ensemble(disturbed, "nothing=1:2", 1)
    keys = str(refused.value).partition("may vary: ")[2].split(", ")
    assert len(keys) > 15
    for key in keys:
        base = attrgetter(key)(disturbed)
        if key == "basis.kernel":
            level = "gaussian"
        else:
            level = (np.array(base, dtype=float) * 1.01 + 0.001).tolist()
        data = run_ensemble(disturbed, f"{key}={json.dumps([level])}", 1)
        assert data["status"].values.tolist() == [1], key
        one = clpt_control.simulate(disturbed.with_values({key: level}))
        end = float(
            np.abs(one.flow_parameters_estimate - one.flow_parameters)[-1].max()
        )
        assert abs(float(data["flow_parameter_error"][0, -1]) - end) < 1e-7, key


@pytest.mark.parametrize("number", [0, 17, 39])
def test_a_member_is_a_run_of_its_own(scenario, whole, number, reported):
    member, keys = (
        whole.isel(member=number),
        [re.split("[=~]", vary)[0] for vary in VARY],
    )
    summary, run = reported(scenario.with_values({k: member[k].values for k in keys}))
    for name in (
        "position",
        "predicted_position",
        "alpha",
        "feedback_gain",
        "feedforward_gain",
    ):
        np.testing.assert_allclose(member[name], run[name], rtol=0, atol=1e-6)
    np.testing.assert_array_equal(whole["time"], run["time"])
    for name in ("flow_parameter_error", "gain_error"):
        error = float(member[name].sel(mark=100))
        assert error == pytest.approx(summary[f"max_{name}"]["100"], abs=1e-6)
    np.testing.assert_allclose(
        member.clpe_rms, summary["clpe_rms_per_cycle"], atol=1e-7
    )
    assert float(member.clpe_rms_whole) == pytest.approx(summary["clpe_rms"], abs=1e-7)
    assert member.sizes["cycle"] == 2


@pytest.mark.parametrize("name", ["paper", "known_flow_biased"])
def test_reference_numbers(reference, name):
    scenario, numbers = (
        clpt_control.load_scenario(REFERENCE / f"{name}.toml"),
        reference[name],
    )
    data = run_ensemble(scenario, f"learning.gain=[{scenario.learning.gain}]", 1)
    np.testing.assert_allclose(
        data["clpe_rms"][0], numbers["clpe_rms_per_cycle"], atol=1e-6
    )
    wanted = numbers.get("max_flow_parameter_error") or {}
    for t in {"100", "200", "2000"} & wanted.keys():
        got = float(data["flow_parameter_error"].sel(mark=float(t))[0])
        assert abs(got - wanted[t]) < 1e-6


@pytest.mark.long
def test_the_command(clpt, printed, refused, quick, tmp_path):
    file, out, figure = tmp_path / "s.toml", tmp_path / "e.zarr", tmp_path / "e.png"
    clpt_control.save_scenario(quick, file)
    many = (
        "--members",
        12,
        "--vary",
        VARY[0],
        "--vary",
        VARY[1],
        "--seed",
        4,
        "--out",
        out,
    )
    assert printed("ensemble", file, *many, "--figure", figure)["ended"] == {
        "finished": 12
    }
    assert inked(figure) > 0.01
    assert f"{quick.title or file}: 12 finished" in clpt("ensemble", file, *many).out
    wrong = ("--members", 3, "--vary", "x=1:2", "--out", tmp_path / "f.zarr")
    assert "x cannot vary; may vary" in refused("ensemble", file, *wrong)
    assert not (tmp_path / "f.zarr").exists()
    named = refused("ensemble", file, *many, "--figure", tmp_path / "e.gif")
    assert ".png, .pdf or .svg" in named
