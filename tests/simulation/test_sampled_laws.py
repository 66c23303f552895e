"""`learning.sample`: a scenario's law at samples, against a loop in plain Python."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import clpt_control as clpt
from clpt_control.errors import ClptError, DiagramError, ScenarioError

SLOW = clpt.paper_scenario().with_values(
    {"learning.gain": 0.05, "run.duration": 20, "run.output_step": 5, "run.rtol": 1e-11}
)


def by_hand(scenario, period):
    """Eqs. (1)-(5), (7), (20); between samples alpha, K, Gamma are held: Euler of (21)-(23)."""
    theta, alpha_M = np.array(scenario.flow.parameters), np.array(scenario.model_parameters)
    KD, GammaD = np.array(scenario.vehicle.feedback), np.array(scenario.vehicle.feedforward)
    centers, widths = np.array(scenario.basis.centers), np.array(scenario.basis.widths)
    gain, dwell = scenario.learning.gain, scenario.reference.dwell
    alpha, K, Gamma = np.zeros((2, 3)), np.zeros(2), np.zeros(2)
    state, found = np.zeros(4), []

    def phi(x, t):
        far = np.hypot(*(x - centers).T)
        return np.exp(-far / (2 * widths)) * np.cos(scenario.frequencies * t + scenario.phases)

    def rates(t, state, zc):
        x, z = state[:2], state[2:]
        at_x, at_z = phi(x, t), phi(z, t)
        v = -alpha_M @ at_x - KD * x + GammaD * zc
        psi = -(alpha_M + alpha) @ at_x - (alpha_M - alpha) @ at_z
        v_z = -alpha @ at_z - K * z + Gamma * zc + psi
        return np.concatenate([theta @ at_x + v, alpha_M @ at_z + v_z])

    for k in range(round(scenario.run.duration / period)):
        t = k * period
        if abs(t / 5 - round(t / 5)) < 1e-9:
            found.append(np.concatenate([state, alpha.ravel(), K, Gamma]))
        zc = scenario.waypoints[int(t / dwell + 1e-9)]
        x, z = state[:2], state[2:]
        e = x - z
        step = period * gain * np.outer(e, phi(x, t)), period * gain * z * e, period * gain * zc * e
        held = {"rtol": 1e-11, "atol": 1e-13, "method": "DOP853", "args": (zc,)}
        state = solve_ivp(rates, (t, t + period), state, **held).y[:, -1]
        alpha, K, Gamma = alpha - step[0], K - step[1], Gamma + step[2]
    return np.array(found)


@pytest.mark.parametrize("period", [0.1, 1.0, 5.0])
def test_a_law_that_is_sampled_is_a_plain_loop(period):
    run = clpt.simulate(SLOW.with_values({"learning.sample": period}))
    names = ("position", "predicted_position", "alpha", "feedback_gain", "feedforward_gain")
    found = np.concatenate([run[name].values.reshape(5, -1) for name in names], axis=1)
    np.testing.assert_allclose(found[:-1], by_hand(SLOW, period), rtol=1e-9, atol=1e-8)
    assert run.attrs["engine"] == "native"


@pytest.mark.parametrize("law", ["known-flow", "kalman-flow", "composite-memory", "drem"])
def test_every_engine_samples_a_law(law):
    """A law's own states begin where they do without samples."""
    own = {"learning.law": law, "learning.parameters": None, "run.duration": 2}
    own |= {"learning.theta_estimate": np.ones((2, 3)).tolist()} if law == "known-flow" else {}
    scenario = SLOW.with_values({**own, "learning.sample": 0.05, "run.rtol": 1e-9})
    native, python = (clpt.simulate(scenario, engine=engine) for engine in ("native", "python"))
    np.testing.assert_allclose(native.states, python.states, rtol=1e-6, atol=1e-9)


def test_the_scenarios_method_runs():
    stiff = SLOW.with_values({"run.method": "rodas5p", "run.rtol": 1e-6})
    assert clpt.simulate(stiff).attrs["method"] == "Rodas5P"
    assert clpt.simulate(clpt.closed_loop(stiff)).attrs["method"] == "Rodas5P"
    found = clpt.simulate(SLOW.with_values({"run.rtol": 1e-6}), method="rodas5p")
    assert 'method = "rodas5p"' in found.attrs["scenario"]
    with pytest.raises(ScenarioError, match=r"run\.method = 'euler': must be"):
        SLOW.with_values({"run.method": "euler"})
    explicit = stiff.with_values({"run.method": "dop853"})
    data, other = (
        clpt.run_ensemble(one, {"learning.gain": [0.1, 0.2]}, trajectories=True)
        for one in (stiff, explicit)
    )
    for m, gain in enumerate((0.1, 0.2)):
        alone = clpt.simulate(stiff.with_values({"learning.gain": gain}))
        np.testing.assert_allclose(data.alpha[m], alone.alpha, rtol=0, atol=1e-6)
    assert not np.array_equal(data.alpha, other.alpha)


def test_what_is_not_sampled_says_so():
    sampled = SLOW.with_values({"learning.sample": 1.0})
    (law,) = (block for block in clpt.paper_blocks(SLOW) if block.name == "adaptation")
    with pytest.raises(DiagramError, match="sample yours by"):
        clpt.closed_loop(sampled, law=law)
    with pytest.raises(DiagramError, match="proofs speak of continuous time alone"):
        clpt.theory.prove(clpt.closed_loop(sampled))
    with pytest.raises(ScenarioError, match=r"learning\.sample cannot vary"):
        clpt.ensemble.run_ensemble(sampled, vary="learning.sample=0.5:2.0", members=2)
    with pytest.raises(ScenarioError, match="runs at fixes alone"):
        SLOW.with_values(
            {
                "learning": {"law": "fix-regression", "sample": 1.0},
                "localization.interval": 5.0,
            }
        )
    end = SLOW.run.duration
    SLOW.with_values({"learning.sample": end})
    with pytest.raises(ScenarioError, match="the law runs at no time after t = 0; must be at most"):
        SLOW.with_values({"learning.sample": 1.01 * end})
    both = {"a": sampled, "b": sampled.with_values({"vehicle.position": [1.0, 0.0]})}
    with pytest.raises(ClptError, match="a team learns at all times"):
        clpt.Team(members=both, edges=[("a", "b")], coupling=0.5)
