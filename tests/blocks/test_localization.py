"""The measured position x_m = x + s n, n standard normal, held: what reads it, and its law."""

import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.equations import evaluate

NOISE = {"noise": 0.05, "noise_period": 0.5, "seed": 3}
NOISY = clpt.paper_scenario().with_values({"localization": NOISE, "run.duration": 20})


def test_the_vehicle_steers_on_what_it_reads():
    """In calm water x' = -k (x + n) + k zc: exact from one period of the noise to the next."""
    calm = {"flow.parameters": [[0.0] * 3] * 2, "run.output_step": 0.5}
    run = clpt.simulate(NOISY.with_values(calm))
    x, n = run.position.values, (run.measured_position - run.position).values
    left = np.exp(-0.5)
    wanted = left * x[:-1] + (1 - left) * (run.reference.values[:-1] - n[:-1])
    np.testing.assert_allclose(x[1:], wanted, rtol=0, atol=1e-8)
    assert np.std(n) == pytest.approx(0.05, rel=0.3)


def test_the_truth_is_without_noise():
    run = clpt.simulate(NOISY)
    phi = evaluate(NOISY.basis_block(), run.time.values, run.position.values)
    flow = np.einsum("ik,tk->ti", run.flow_parameters.values, phi)
    np.testing.assert_allclose(run.true_flow, flow, rtol=0, atol=1e-12)
    seen = run.measured_position - run.predicted_position
    np.testing.assert_allclose(run.clpe, seen, rtol=0, atol=1e-12)
    e = (run.position - run.predicted_position).values
    learning = NOISY.learning
    V = np.sum(e**2, axis=1) / 2
    for name, true in (("flow_parameters_estimate", NOISY.flow.parameters),):
        V += np.sum((run[name].values - np.array(true)) ** 2, axis=(1, 2)) / (2 * learning.gain)
    for name in ("feedback_gain", "feedforward_gain"):
        V += np.sum((run[name].values - 1.0) ** 2, axis=1) / (2 * learning.gain)
    np.testing.assert_allclose(run.lyapunov, V, rtol=1e-12)


def test_no_noise_is_no_localization():
    quiet = clpt.simulate(NOISY.with_values({"localization.noise": 0.0}))
    plain = clpt.simulate(NOISY.with_values({"localization": None}))
    for name in plain.data_vars:
        np.testing.assert_allclose(quiet[name], plain[name], rtol=0, atol=1e-7, err_msg=name)
    assert set(quiet.data_vars) - set(plain.data_vars) == {"measured_position"}


def test_a_measured_track_feeds_the_learner_alone():
    loop = clpt.closed_loop(NOISY, external="x")
    assert loop.input_labels == ["x[0]", "x[1]"]
    names = [block.name for block in clpt.paper_blocks(NOISY)]
    assert {"measurement", "basis_x_true"} <= set(names)
    assert clpt.closed_loop(NOISY, external="x_true").nstates == loop.nstates


def test_a_seed_varies_by_a_list_and_every_member_has_its_own_noise():
    many = clpt.run_ensemble(
        NOISY, "localization.seed=[0, 1, 2, 3]", 4, design="grid", trajectories=True
    )
    for seed, position in enumerate(many.position.values):
        own = clpt.simulate(NOISY.with_values({"localization.seed": seed}))
        np.testing.assert_allclose(position, own.position, rtol=0, atol=1e-10)
    for vary, said in (("=0:3", "list the values"), ("=[1, 2.5]", "must be a whole number")):
        with pytest.raises(clpt.ClptError, match=said):
            clpt.run_ensemble(NOISY, f"localization.seed{vary}", 2)
