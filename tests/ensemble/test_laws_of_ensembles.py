"""Ensembles of any law, and with parts of one's own: each member is the run of its scenario."""

import importlib.util
import threading
from types import SimpleNamespace

import control
import numpy as np
import pytest
from law_blocks import EACH, HELD, papers_law, remembering_law
from sampled_runs import assert_identical
from small_scenarios import FIXES

import clpt_control as clpt
from clpt_control import Block, DataError, DiagramError, ScenarioError, run_ensemble

LAWS = clpt.laws()

THETA = "flow.parameters~normal:0.1"
GAIN = "learning.gain=0.2:2.0"


def assert_members_are_runs(data, scenario, *keys, **changes):
    """Each member's last errors are those of its own run."""
    for member in data.member.values:
        own = scenario.with_values({k: data[k].values[member] for k in keys})
        run = clpt.simulate(clpt.closed_loop(own, **changes) if changes else own)
        error = np.abs(
            run.flow_parameters_estimate.values[-1] - run.flow_parameters.values
        ).max()
        assert float(data.flow_parameter_error[member, -1]) == pytest.approx(
            error, rel=1e-6
        )
        if "gain_error" not in data:
            continue
        true = own.vehicle.feedback, own.vehicle.feedforward
        wrong = np.abs(
            np.array([run.feedback_gain[-1], run.feedforward_gain[-1]]) - true
        ).max()
        assert float(data.gain_error[member, -1]) == pytest.approx(
            wrong, rel=1e-6, abs=1e-12
        )


ONE_EACH = {"learning.gain": None, "learning.gains": EACH}
NOISY = {  # noise of the flow and of the position begin with one seed, and change together
    "flow.disturbance": {"kind": "noise", "amplitude": [0.05, 0.02], "period": 1.8},
    "localization": {"noise": 0.02, "noise_period": 1.8},
}
SEEDS = ["flow.disturbance.seed", "localization.seed"]


@pytest.mark.parametrize(
    ("values", "keys", "range_"),
    [
        (ONE_EACH, ["learning.gains.parameters"], "0.2:2.0"),
        (ONE_EACH, ["learning.gains.feedforward"], "0.2:2.0"),
        (HELD, ["learning.gain"], "0.2:2.0"),
        (HELD, ["learning.feedback"], "0.2:2.0"),
        (NOISY, SEEDS, "[0, 1]"),
        (NOISY, SEEDS[:1], "[0, 1]"),
        (NOISY, ["flow.disturbance.period"], "[1.8, 2.5]"),
    ],
)
def test_keys_vary_one_by_one(quick, values, keys, range_):
    scenario = quick.with_values(values)
    data = run_ensemble(scenario, [f"{key}={range_}" for key in keys], 4)
    assert_members_are_runs(data, scenario, *keys)
    assert len(set(data.flow_parameter_error.values[:, -1])) >= 2


BESIDE = {"switching-sigma", "e-modification", "dead-zone", "normalised-gradient"}
# like another law: by `make test-slow`
BESIDE |= {"least-squares", "composite-least-squares"}


@pytest.mark.parametrize(
    "name",
    [pytest.param(n, marks=pytest.mark.slow) if n in BESIDE else n for n in LAWS],
)
def test_every_law_makes_ensembles_and_its_settings_vary(quick, name):
    law = LAWS[name]
    values = {
        "learning.law": name,
        "learning.theta_estimate": [[0.9, 0.5, 0.7]] * 2
        if law.given_estimate
        else None,
        "learning.parameters": None,
        **(FIXES if law.at_fixes else {"learning.gain": 0.8}),
    }
    varied = {"localization.interval" if law.at_fixes else "learning.gain": "0.2:2.0"}
    for setting in [
        key for key, one in law.settings.items() if one.allowed == "positive"
    ][:1]:
        key, usual = f"learning.{law.table}.{setting}", law.settings[setting].default
        if usual is None:
            # made of the scenario's other keys; a plain default need not be named
            usual = values[key] = 0.5
        varied[key] = f"[{usual}, {2 * usual}]"
    scenario = quick.with_values(values)
    data = run_ensemble(scenario, [f"{k}={v}" for k, v in varied.items()], 3)
    assert_members_are_runs(data, scenario, *varied)


# --- parts of one's own --------------------------------------------------------------------------


def frozen_law(kept=None):
    """Return a law made in place, which no module holds, with something of its own beside."""

    def local(t, x, u, p):
        """All held, section III."""
        return np.zeros(10) * (kept is None)

    own = papers_law()
    return Block("local", update=local, inputs=own.input_ports, states=own.state_ports)


def halving():
    """A part with a number that is equal to that of a key, and stays."""
    ports = {
        "inputs": {"v_x": 2},
        "outputs": {"y": 2},
        "parameters": {"KD": np.ones(2)},
    }
    return Block("part", output=lambda t, x, u, p: 0.5 * p.KD * u.v_x, **ports)


def slow(tau):
    return {"insert": {("v_x", "vehicle"): control.tf(1, [tau, 1], name="lag")}}


@pytest.mark.parametrize(
    ("changes", "values", "vary"),
    [
        (slow(0.5), {}, GAIN),
        (slow(0.5), {"vehicle.max_speed": 3.0}, GAIN),
        ({"law": frozen_law()}, {}, THETA),
        ({"law": remembering_law()}, {}, THETA),
        (
            {"insert": {("v_x", "vehicle"): halving()}},
            {},
            "vehicle.feedback=[[1, 1], [2, 0.5]]",
        ),
    ],
)
def test_members_with_parts_of_ones_own_are_runs_with_them(
    quick, changes, values, vary
):
    scenario = quick.with_values(values)
    data = run_ensemble(clpt.closed_loop(scenario, **changes), vary, 2)
    assert_members_are_runs(data, scenario, vary.split("=")[0].split("~")[0], **changes)


@pytest.mark.long
@pytest.mark.parametrize(
    ("own", "others"),
    [
        (
            {"law": remembering_law()},
            [{"law": remembering_law(gain=0.9)}, {"law": papers_law()}],
        ),
        (slow(0.5), [slow(0.6)]),
    ],
)
def test_a_folder_tells_parts_apart(quick, tmp_path, own, others):
    given = {"vary": THETA, "members": 12, "chunk": 4}
    data = run_ensemble(clpt.closed_loop(quick, **own), threads=2, **given)
    given["out"] = tmp_path / "e.zarr"
    for _ in range(2):
        assert_identical(run_ensemble(clpt.closed_loop(quick, **own), **given), data)
    for other in (*others, {}):
        with pytest.raises(DataError, match="an ensemble of"):
            run_ensemble(clpt.closed_loop(quick, **other), **given)


def without_states(t, x, u, p):
    """alpha = 0, K = Gamma = 1, section III."""
    return {"alpha": 0.0, "K": 1.0, "Gamma": 1.0}


FIXED = Block("fixed", output=without_states, outputs={"alpha": 6, "K": 2, "Gamma": 2})
LIMIT = control.nlsys(
    None, lambda t, x, u, p: np.clip(u, -1, 1), inputs=2, outputs=2, name="limit"
)
BOAT = control.ss(-np.eye(2), np.eye(2), 2 * np.eye(2), 0, name="boat")
BOAT.set_inputs(["v_x[0]", "v_x[1]"])
BOAT.set_outputs(["x[0]", "x[1]"])
PAPERS = papers_law(name="adaptation")


@pytest.mark.parametrize(
    ("changes", "vary", "said"),
    [
        ({"law": FIXED}, THETA, "fixed: alpha is not a state of it"),
        (
            {"insert": {"v_x": LIMIT}},
            GAIN,
            "limit: is a NonlinearIOSystem; an ensemble takes",
        ),
        ({"replace": {"vehicle": BOAT}}, GAIN, "boat: x is not a state of it"),
        (
            {"law": PAPERS},
            GAIN,
            "^vary: learning.gain cannot vary; .* given in Python vary",
        ),
        (
            {"law": PAPERS},
            "adaptation.gain=1:2",
            r"^vary: adaptation.gain cannot vary; .* timepts",
        ),
    ],
)
def test_what_members_cannot_be_made_of_is_refused(quick, changes, vary, said):
    with pytest.raises((DiagramError, ScenarioError), match=said):
        run_ensemble(clpt.closed_loop(quick, **changes), vary, 3)


def test_what_a_law_given_in_python_does_not_read_cannot_vary(quick):
    scenario = quick.with_values({"learning.law": "sigma", "learning.sigma.leak": 0.5})
    loop = clpt.closed_loop(scenario, law=remembering_law())
    with pytest.raises(
        ScenarioError, match=r"^vary: learning\.sigma\.leak cannot vary"
    ):
        run_ensemble(loop, "learning.sigma.leak=0.2:2.0", 3)


def test_a_part_of_ones_own_varies_where_the_loop_is_a_diagram(quick):
    # it runs from t = 0
    loop, times = (clpt.closed_loop(quick, law=PAPERS), np.arange(1.0, 4.0))
    data = run_ensemble(
        loop, {"adaptation.gain": [0.5, 2.0]}, timepts=times, trajectories=True
    )
    alone = clpt.simulate(loop, times, params={"adaptation.gain": 2.0})
    np.testing.assert_allclose(data.e[1], alone.clpe, atol=1e-12)
    np.testing.assert_allclose(
        data.e_max[1], np.abs(alone.clpe).max("time"), atol=1e-12
    )
    np.testing.assert_allclose(
        data.e_rms[1] ** 2, (alone.clpe**2).integrate("time") / 2
    )


@pytest.mark.skipif(
    not importlib.util.find_spec("distributed"), reason="Dask is not installed"
)
def test_a_law_that_cannot_be_sent_is_refused(quick, tmp_path):
    loop = clpt.closed_loop(
        quick, law=frozen_law(SimpleNamespace(lock=threading.Lock()))
    )
    with pytest.raises(DiagramError, match=r"local: cannot be sent to workers. Define"):
        run_ensemble(loop, THETA, 3, out=tmp_path / "e.zarr", dask="local")
    assert not (tmp_path / "e.zarr").exists()
