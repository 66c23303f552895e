"""Ensembles of any law: each member is the run of its scenario, to the last bit."""

import importlib.util
import threading

import control
import law_blocks
import numpy as np
import pytest
from ensemble_stores import assert_identical
from law_blocks import EACH, HELD

import clpt_control as clpt
from clpt_control.blocks.laws.table import LAWS
from clpt_control.ensemble.run import run_ensemble
from clpt_control.equations import Block
from clpt_control.errors import DataError, DiagramError, ScenarioError
from clpt_control.theory.proving.theorem_loop import AT_FIXES


def assert_members_are_runs(data, scenario, *keys):
    """Each member's last errors are those of its own run."""
    theta = np.array(scenario.flow.parameters)
    for member in data.member.values:
        run = clpt.simulate(scenario.with_values({k: data[k].values[member] for k in keys}))
        error = np.abs(run.flow_parameters_estimate.values[-1] - theta).max()
        assert float(data.flow_parameter_error[member, -1]) == pytest.approx(error, rel=1e-6)
        if "gain_error" not in data:
            continue
        gains = np.concatenate([run.feedback_gain[-1], run.feedforward_gain[-1]])
        wrong = np.abs(gains - 1.0).max()
        assert float(data.gain_error[member, -1]) == pytest.approx(wrong, rel=1e-6, abs=1e-12)


@pytest.mark.parametrize(
    ("values", "key"),
    [
        ({"learning.gain": None, "learning.gains": EACH}, "learning.gains.parameters"),
        ({"learning.gain": None, "learning.gains": EACH}, "learning.gains.feedforward"),
        (HELD, "learning.gain"),
        (HELD, "learning.feedback"),
    ],
)
def test_gains_vary_one_by_one(quick, values, key):
    scenario = quick.with_values(values)
    data = run_ensemble(scenario, f"{key}=0.2:2.0", 3)
    assert_members_are_runs(data, scenario, key)
    assert len(set(data.flow_parameter_error.values[:, -1])) == 3


BESIDE = {"switching-sigma", "e-modification", "dead-zone", "normalised-gradient"}
BESIDE |= {"least-squares", "composite-least-squares"}  # like another law: by `make test-slow`


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.slow) if n in BESIDE else n for n in LAWS]
)
def test_every_law_makes_ensembles_and_its_settings_vary(quick, name):
    law = LAWS[name]
    values = {
        "learning.law": name,
        "learning.theta_estimate": [[0.9, 0.5, 0.7]] * 2 if law.given_estimate else None,
        "learning.parameters": None,
        **(AT_FIXES if law.at_fixes else {"learning.gain": 0.8}),
    }
    varied = {"localization.interval" if law.at_fixes else "learning.gain": "0.2:2.0"}
    for setting in [key for key, one in law.settings.items() if one.allowed == "positive"][:1]:
        key, usual = f"learning.{law.table}.{setting}", law.settings[setting].default
        if usual is None:  # made of the scenario's other keys; a plain default need not be named
            usual = values[key] = 0.5
        varied[key] = f"[{usual}, {2 * usual}]"
    scenario = quick.with_values(values)
    data = run_ensemble(scenario, [f"{k}={v}" for k, v in varied.items()], 3)
    assert_members_are_runs(data, scenario, *varied)


@pytest.mark.parametrize(
    ("law", "key"), [("learned-flow", "learning.gain"), ("sigma", "learning.sigma.leak")]
)
def test_what_a_law_given_in_python_does_not_read_cannot_vary(quick, law, key):
    scenario = quick.with_values({"learning.law": law, key: 0.5})
    loop = clpt.closed_loop(scenario, law=law_blocks.remembering_law())
    with pytest.raises(ScenarioError, match=f"^vary: {key} cannot vary; .* given in Python vary"):
        run_ensemble(loop, f"{key}=0.2:2.0", 3)


def test_a_part_of_ones_own_varies_where_the_loop_is_a_diagram(quick):
    loop = clpt.closed_loop(quick, law=law_blocks.papers_law(name="adaptation"))
    with pytest.raises(ScenarioError, match=r"^vary: adaptation.gain cannot vary; .* timepts"):
        run_ensemble(loop, {"adaptation.gain": [0.5, 2.0]})
    times = np.arange(1.0, 4.0)  # it runs from t = 0
    data = run_ensemble(loop, {"adaptation.gain": [0.5, 2.0]}, timepts=times, trajectories=True)
    alone = clpt.simulate(loop, times, params={"adaptation.gain": 2.0})
    np.testing.assert_allclose(data.e[1], alone.clpe, atol=1e-12)
    np.testing.assert_allclose(data.e_max[1], np.abs(alone.clpe).max("time"), atol=1e-12)
    np.testing.assert_allclose(data.e_rms[1] ** 2, (alone.clpe**2).integrate("time") / 2)


def test_a_block_takes_the_laws_place(quick, tmp_path):
    law, given = law_blocks.remembering_law(), {"members": 12, "chunk": 4}
    given["vary"] = "flow.parameters~normal:0.1"
    data = run_ensemble(clpt.closed_loop(quick, law=law), threads=2, **given)
    given["out"] = tmp_path / "e.zarr"
    stored = run_ensemble(clpt.closed_loop(quick, law=law), **given)
    assert_identical(stored, data)
    for other in (None, law_blocks.remembering_law(gain=0.9), law_blocks.papers_law()):
        with pytest.raises(DataError, match="holds an ensemble of"):
            run_ensemble(clpt.closed_loop(quick, law=other), **given)


@pytest.mark.processes
@pytest.mark.skipif(not importlib.util.find_spec("distributed"), reason="Dask is not installed")
def test_a_cluster_gets_the_block(quick, tmp_path):
    loop = clpt.closed_loop(quick, law=law_blocks.papers_law(gain=1.1))
    given = {"vary": "flow.parameters~normal:0.1", "members": 8, "chunk": 4}
    here = run_ensemble(loop, **given)
    data = run_ensemble(loop, out=tmp_path / "e.zarr", threads=1, dask="local", **given)
    assert_identical(data, here)


def without_states(t, x, u, p):
    """alpha = 0, K = Gamma = 1, section III."""
    return {"alpha": 0.0, "K": 1.0, "Gamma": 1.0}


def test_what_members_cannot_be_summarised_from_is_refused(quick):
    ports = {"alpha": 6, "K": 2, "Gamma": 2}
    fixed = Block("fixed", output=without_states, outputs=ports)
    with pytest.raises(DiagramError, match="fixed: alpha is no state of it"):
        run_ensemble(clpt.closed_loop(quick, law=fixed), "flow.parameters~normal:0.1", 3)


def test_an_ensemble_with_a_lag_is_runs_with_a_lag(quick, tmp_path):
    lag = {("v_x", "vehicle"): control.tf(1, [0.5, 1], name="lag")}
    key, values = "learning.gain", [0.4, 1.2]
    for scenario in (quick, quick.with_values({"vehicle.max_speed": 3.0})):
        data = run_ensemble(
            clpt.closed_loop(scenario, insert=lag), f"{key}={values}", 2, design="grid"
        )
        for m, value in enumerate(values):
            run = clpt.simulate(clpt.closed_loop(scenario.with_values({key: value}), insert=lag))
            error = abs(run.flow_parameters_estimate[-1] - run.flow_parameters).max()
            assert float(data.flow_parameter_error[m, -1]) == pytest.approx(float(error), abs=1e-6)
    stored = {"vary": f"{key}=0.2:2.0", "members": 3, "out": tmp_path / "e.zarr"}
    first, again = (run_ensemble(clpt.closed_loop(quick, insert=lag), **stored) for _ in range(2))
    assert_identical(first, again)
    slower = {("v_x", "vehicle"): control.tf(1, [0.6, 1], name="lag")}
    for other in (None, slower):
        with pytest.raises(DataError, match="holds an ensemble of"):
            run_ensemble(clpt.closed_loop(quick, insert=other), **stored)


def test_an_ensemble_refuses_what_is_not_compiled(quick):
    saturation = control.nlsys(
        None, lambda t, x, u, params: np.clip(u, -1, 1), inputs=2, outputs=2, name="saturation"
    )
    with pytest.raises(DiagramError, match="saturation: is a NonlinearIOSystem; an ensemble takes"):
        run_ensemble(
            clpt.closed_loop(quick, insert={"v_x": saturation}), "learning.gain=0.2:2.0", 3
        )
    ports = {"inputs": ["v_x[0]", "v_x[1]"], "outputs": ["x[0]", "x[1]"]}
    boat = control.ss(-np.eye(2), np.eye(2), 2 * np.eye(2), 0, **ports, name="boat")
    with pytest.raises(DiagramError, match="boat: x is no state of it"):
        run_ensemble(clpt.closed_loop(quick, replace={"vehicle": boat}), "learning.gain=0.2:2.0", 3)


def frozen_law(kept=None):
    """Return a law made in place, which no module holds, with something of its own beside."""

    def local(t, x, u, p):
        """All held, section III."""
        return np.zeros(10) * (kept is None)

    own = law_blocks.papers_law()
    return Block("local", update=local, inputs=own.input_ports, states=own.state_ports)


def test_a_law_made_in_place_runs_on_threads(quick):
    vary = "flow.parameters~normal:0.1"
    data = run_ensemble(clpt.closed_loop(quick, law=frozen_law()), vary, 3, trajectories=True)
    for m, theta in enumerate(data["flow.parameters"].values):
        own = quick.with_values({"flow.parameters": theta})
        run = clpt.simulate(clpt.closed_loop(own, law=frozen_law()))
        np.testing.assert_allclose(data.position[m], run.position, rtol=0, atol=1e-7)


@pytest.mark.skipif(not importlib.util.find_spec("distributed"), reason="Dask is not installed")
def test_a_law_that_cannot_be_sent_is_refused(quick, tmp_path):
    loop = clpt.closed_loop(quick, law=frozen_law(threading.Lock()))
    given = {"vary": "flow.parameters~normal:0.1", "members": 3, "out": tmp_path / "e.zarr"}
    with pytest.raises(DiagramError, match="local: cannot be sent to workers; define"):
        run_ensemble(loop, dask="local", **given)
    assert not (tmp_path / "e.zarr").exists()


def test_equal_numbers_of_two_keys_vary_apart(quick):
    """Noise of the flow and of the position begin with one seed, and change together."""
    noise = {"kind": "noise", "amplitude": [0.05, 0.02], "period": 1.8}
    seen = {"noise": 0.02, "noise_period": 1.8}
    noisy = quick.with_values({"flow.disturbance": noise, "localization": seen})
    seeds = ["flow.disturbance.seed", "localization.seed"]
    for keys, levels in ((seeds, [0, 1]), (["flow.disturbance.period"], [1.8, 2.5])):
        data = run_ensemble(noisy, [f"{key}={levels}" for key in keys], 4)
        assert_members_are_runs(data, noisy, *keys)


def test_a_part_of_ones_own_keeps_numbers_that_are_equal_to_a_keys(quick):
    def halved(t, x, u, p):
        return 0.5 * p.KD * u.v_x

    part = Block(
        "part", output=halved, inputs={"v_x": 2}, outputs={"y": 2}, parameters={"KD": np.ones(2)}
    )

    def loop(scenario):
        return clpt.closed_loop(scenario, insert={("v_x", "vehicle"): part})

    key, values = "vehicle.feedback", [[1.0, 1.0], [2.0, 0.5]]
    data = run_ensemble(loop(quick), {key: values}, trajectories=True)
    for m, value in enumerate(values):
        run = clpt.simulate(loop(quick.with_values({key: value})))
        np.testing.assert_allclose(data.position[m], run.position, rtol=0, atol=1e-7)
