"""The limits of a vehicle: of its speed, and of what it knows of its position."""

import math

import numpy as np
import pytest
from hypothesis import given, seed, settings
from hypothesis import strategies as st

import clpt_control as clpt
from clpt_control.blocks import vehicle

PAPER = clpt.paper_scenario()
LIMITED = PAPER.with_values({"vehicle.max_speed": 1.5})
velocity = st.floats(-1e6, 1e6).filter(lambda v: v == 0 or abs(v) > 1e-100)


@seed(1)
@settings(max_examples=200, deadline=None)
@given(v=st.tuples(velocity, velocity), limit=st.floats(1e-3, 1e3))
def test_at_most_the_limit_in_the_same_direction_and_as_commanded_below(v, limit):
    found, speed = np.array(vehicle.speed_limit(limit).output(0.0, [], v)), math.hypot(*v)
    assert math.hypot(*found) <= limit * (1 + 1e-14)
    if speed < limit * (1 - 1e-15):
        assert found.tolist() == list(v)
    if speed > limit * (1 + 1e-15):
        assert math.hypot(*found) == pytest.approx(limit, rel=1e-14)
        assert math.atan2(found[1], found[0]) == pytest.approx(math.atan2(v[1], v[0]), abs=1e-14)
    missing = vehicle.hedging().output(0.0, [], [*v, *found])
    np.testing.assert_allclose(found + missing, v, rtol=1e-15)


CALM = {"flow.parameters": [[0.0] * 3] * 2}
AGAINST = [  # speed of the flow, distance at first, and at t
    # 2.5 against 1.5: the distance grows by 1.0 a second
    (2.5, 3.0, lambda t: 3.0 + t),
    # r' = 1 - 1.5 down to r = 1.5 at t = 17, then r' = 1 - r
    (1.0, 10.0, lambda t: np.where(t <= 17, 10.0 - 0.5 * t, 1.0 + 0.5 * np.exp(17 - t))),
]


@pytest.mark.parametrize(("speed", "start", "r"), AGAINST, ids=["drifts", "comes home"])
def test_a_vehicle_drifts_or_comes_home_at_what_one_is_faster(speed, start, r):
    """KD = 1: it steers to the origin in a constant flow, along (0.6, 0.8), it does not know."""
    along = np.array([0.6, 0.8])
    values = {
        "flow.disturbance": {"kind": "constant", "amplitude": (speed * along).tolist()},
        "vehicle.position": (start * along).tolist(),
        "reference": {"kind": "waypoints", "points": [[0.0, 0.0]], "dwell": 100.0},
        "run.duration": 40.0,
    }
    run = clpt.simulate(LIMITED.with_values({**CALM, **values}))
    tolerance = 1e-12 if speed > 1.5 else 1e-7
    np.testing.assert_allclose(run.position, np.outer(r(run.time), along), rtol=tolerance)


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("vehicle.max_speed", 0.0, " = 0.0: must be greater than 0"),
        ("vehicle.max_speed", math.inf, ".*finite"),
        ("learning.hedging", True, " = true: .* only with vehicle.max_speed"),
    ],
)
def test_what_is_not_allowed_is_said(key, value, said):
    with pytest.raises(clpt.ScenarioError, match=key + said):
        PAPER.with_values({key: value})


def test_the_limit_has_a_name_at_call_time_and_may_vary():
    short = LIMITED.with_values({"run.duration": 10, "run.rtol": 1e-12, "run.atol": 1e-13})
    run = clpt.simulate(short, params={"speed_limit.max_speed": 1.1})
    many = clpt.run_ensemble(short, "vehicle.max_speed=[1.1, 1.5]", 2, trajectories=True)
    speeds = many["vehicle.max_speed"].values
    assert sorted(speeds) == [1.1, 1.5]
    for m, speed in enumerate(speeds):
        alone = clpt.simulate(short.with_values({"vehicle.max_speed": float(speed)}))
        np.testing.assert_allclose(many.position[m], alone.position, rtol=1e-9, atol=1e-9)
        if speed == 1.1:
            np.testing.assert_allclose(run.position, alone.position, atol=1e-7)


# --- the measured position x_m = x + s n, n standard normal, held ------------------------------

NOISE = {"noise": 0.05, "noise_period": 0.5, "seed": 3}
NOISY = PAPER.with_values({"localization": NOISE, "run.duration": 20})


def test_the_vehicle_steers_on_what_it_reads():
    """In calm water x' = -k (x + n) + k zc: exact from one period of the noise to the next."""
    run = clpt.simulate(NOISY.with_values({**CALM, "run.output_step": 0.5}))
    x, n = run.position.values, (run.measured_position - run.position).values
    left = np.exp(-0.5)
    wanted = left * x[:-1] + (1 - left) * (run.reference.values[:-1] - n[:-1])
    np.testing.assert_allclose(x[1:], wanted, rtol=0, atol=1e-8)
    assert np.std(n) == pytest.approx(0.05, rel=0.3)


def test_the_truth_is_without_noise():
    run = clpt.simulate(NOISY)
    phi = clpt.equations.evaluate(NOISY.basis_block(), run.time.values, run.position.values)
    flow = np.einsum("ik,tk->ti", run.flow_parameters.values, phi)
    np.testing.assert_allclose(run.true_flow, flow, rtol=0, atol=1e-12)
    seen = run.measured_position - run.predicted_position
    np.testing.assert_allclose(run.clpe, seen, rtol=0, atol=1e-12)
    off = ((run.feedback_gain - 1) ** 2 + (run.feedforward_gain - 1) ** 2).sum("axis")
    theta = run.flow_parameters_estimate - run.flow_parameters
    off = off + (theta**2).sum(("axis", "basis"))
    V = ((run.position - run.predicted_position) ** 2).sum("axis") + off / NOISY.learning.gain
    np.testing.assert_allclose(run.lyapunov, V / 2, rtol=1e-12)


def test_no_noise_is_no_localization():
    quiet = clpt.simulate(NOISY.with_values({"localization.noise": 0.0}))
    plain = clpt.simulate(NOISY.with_values({"localization": None}))
    for name in plain.data_vars:
        np.testing.assert_allclose(quiet[name], plain[name], rtol=0, atol=1e-7, err_msg=name)
    assert set(quiet.data_vars) - set(plain.data_vars) == {"measured_position"}


def test_a_measured_track_feeds_the_learner_alone():
    loop = clpt.closed_loop(NOISY, external="x")
    assert loop.input_labels == ["x[0]", "x[1]"]
    assert {"measurement", "basis_x_true"} <= {one.name for one in clpt.paper_blocks(NOISY)}
    assert clpt.closed_loop(NOISY, external="x_true").nstates == loop.nstates


def test_a_seed_varies_by_a_list_and_every_member_has_its_own_noise():
    seeds, how = "localization.seed=[0, 1, 2, 3]", {"design": "grid", "trajectories": True}
    for k, position in enumerate(clpt.run_ensemble(NOISY, seeds, 4, **how).position.values):
        own = clpt.simulate(NOISY.with_values({"localization.seed": k}))
        np.testing.assert_allclose(position, own.position, rtol=0, atol=1e-10)
    for vary, said in (("=0:3", "list the values"), ("=[1, 2.5]", "must be a whole number")):
        with pytest.raises(clpt.ClptError, match=said):
            clpt.run_ensemble(NOISY, f"localization.seed{vary}", 2)
