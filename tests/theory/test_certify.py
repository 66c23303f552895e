"""Bounds for every start: each step of the proof, 200 starts within R, and closed forms."""

import json
import re

import numpy as np
import pytest

import clpt_control as clpt
from analysis.worst_disturbance import error_matrices
from clpt_control.theory.excitation.certificates import certificate
from clpt_control.theory.excitation.certify import (
    after_window,
    certify,
    least_error,
    settled,
)

PAPER = clpt.paper_scenario().with_values({"run.duration": 400})


def test_steps_2_and_3_are_true_of_the_error_matrices():
    rng, gain = np.random.default_rng(1), 0.7
    phi, x, zc, KD = (
        rng.normal(size=3),
        rng.normal(size=2),
        rng.normal(size=2),
        [1.3, 0.6],
    )
    S, back = (np.diag([1.0, *[gain**power] * 5]) for power in (-0.5, 0.5))
    for axis in range(2):
        y = rng.normal(size=6)
        place = x - y[0] * np.eye(2)[axis]
        A, B = (
            S @ error_matrices(phi, z, zc, KD, gain)[axis] @ back for z in (place, x)
        )
        d = np.sqrt(gain) * y[0] * np.array([-y[4], 0, 0, 0, y[0], 0])
        np.testing.assert_allclose((A - B) @ y, d, atol=1e-12)
        assert y @ B @ y == pytest.approx(-KD[axis] * y[0] ** 2)  # step 3


@pytest.mark.parametrize("D", [0.0, 0.03])
def test_the_least_error_is_the_root_and_the_bound_rises(D):
    """Steps 5 to 7, at 300 values of V."""
    c, k, gain = 0.3, 0.8, 0.6
    V = np.geomspace(1e-6, 1e3, 300)
    a = np.array([least_error(one, c, k, gain, D) for one in V])
    B = 1 + np.sqrt(gain * (2 * V + D**2 / (2 * k))) / k
    left = np.sqrt(V * c) - D / k - B * a - np.sqrt(gain / (2 * k)) * a**2
    np.testing.assert_allclose(
        np.where(a > 0, left, np.minimum(left, 0) * 0), 0, atol=1e-12
    )
    after = np.array([after_window(one, c, k, gain, D) for one in V])
    assert np.all(np.diff(a) >= 0)
    assert np.all(np.diff(after) > 0)
    end = settled(c, k, gain, D)
    assert after_window(end, c, k, gain, D) == pytest.approx(end)
    later = 10.0
    for _ in range(3000):
        later = after_window(later, c, k, gain, D)
    assert later == pytest.approx(end, abs=1e-9)
    assert settled(0.0, k, gain, D) == np.inf
    assert settled(c, k, gain, 10.0) == np.inf


def test_of_small_errors_the_bound_is_the_linear_contraction():
    """And that is the certificate of a learner that was started true."""
    found = certify(PAPER, 1e-16)
    exact = certificate(clpt.theory.started_true(PAPER), 200.0, 200.0)
    assert (found.V[2] / found.V[1], found.drops[1]) == pytest.approx(
        (exact.contraction, exact.drop), rel=1e-6
    )


def start_within(scenario, R, rng):
    """A learner that begins with V(0) = R times a uniform number, in any direction."""
    car = scenario.vehicle
    y = rng.normal(size=12)
    y *= np.sqrt(2 * R * rng.uniform()) / np.linalg.norm(y)
    eta = np.sqrt(scenario.learning.gain) * y[2:]
    start = {
        "position": np.array(car.position) - y[:2],
        "parameters": eta[:6].reshape(2, 3) - np.array(scenario.flow.parameters),
        "feedback": np.array(car.feedback) + eta[6:8],
        "feedforward": np.array(car.feedforward) - eta[8:],
    }
    return scenario.with_values(
        {f"learning.{key}": value for key, value in start.items()}
    )


def pushed(kind, amplitude, **more):
    """A disturbance."""
    return {"flow.disturbance": {"kind": kind, "amplitude": amplitude, **more}}


def test_what_a_disturbance_may_undo_is_said_of_the_run_alone():
    """A learner that begins true is pushed for good: V ends at most far above the run's."""
    found = certify(
        PAPER.with_values(pushed("constant", [0.02, 0.02])), 1e-6, error=5.0
    )
    assert found.within_run
    assert found.ultimate > 5.0
    assert found.said == "CLPE is at most 5 m after 0 s, within the run"
    assert certify(PAPER, 1e-6, error=5.0).said == "CLPE is at most 5 m after 0 s"


DISTURBED = pushed("square", [0.004, 0.003], period=1.8)


STARTS = [
    ({}, 0.05, 6),
    (DISTURBED, 0.05, 6),
    pytest.param({}, 4.63125, 200, marks=pytest.mark.slow),
    pytest.param({}, 0.05, 200, marks=pytest.mark.slow),
    pytest.param(DISTURBED, 0.5, 200, marks=pytest.mark.slow),
]


@pytest.mark.parametrize(("values", "R", "starts"), STARTS)
def test_no_start_within_r_leaves_the_bounds(values, R, starts):
    """V, CLPE and errors at every sample of three cycles; the closest comes near."""
    scenario = PAPER.with_values(
        {"run.duration": 600, "run.output_step": 0.5, **values}
    )
    found, rng, closest = certify(scenario, R), np.random.default_rng(3), 0.0
    D = found.disturbance * np.sqrt(found.window)
    for _ in range(starts):
        run = clpt.simulate(start_within(scenario, R, rng))
        V, t = run.lyapunov.values, run.time.values
        window = np.minimum((t / found.window + 1e-9).astype(int), len(found.V) - 1)
        assert V[0] <= R * (1 + 1e-9)
        assert np.all((found.V[window] + D**2 / 4) * (1 + 1e-7) >= V)
        assert np.all(np.hypot(*run.clpe.values.T) <= found.clpe[window])
        wrong = np.abs(
            run.flow_parameters_estimate.values - np.array(PAPER.flow.parameters)
        )
        assert np.all(wrong.max(axis=(1, 2)) <= found.flow_error[window])
        for j, drop in enumerate(found.drops[:3]):  # a window begun at its own V
            share = V[400 * (j + 1)] / after_window(V[400 * j], drop, 1.0, 0.8, D)
            assert share <= 1 + 1e-6
            closest = max(closest, share)
    assert closest > 0.15


def test_under_a_disturbance_it_ends_at_a_bound_and_says_so():
    found = certify(PAPER.with_values(DISTURBED), 0.05)
    assert found.disturbance == pytest.approx(0.005)
    assert 0 < found.ultimate < np.inf
    lost = certify(PAPER.with_values(pushed("constant", [0.5, 0.0])), 0.05)
    assert lost.ultimate is lost.time_to_error is None
    assert "not shown" in lost.said


def test_the_time_is_the_first_from_which_the_bound_holds():
    found = certify(PAPER.with_values({"run.duration": 1000}), 0.05, error=0.2)
    j = round(found.time_to_error / 200)
    assert found.within_run
    assert found.clpe[j] <= 0.2 < found.clpe[j - 1]
    later = certify(PAPER, 0.05, error=0.01)
    assert not later.within_run
    assert "if later windows" in later.said
    V = later.V[-1]
    for _ in range(round(later.time_to_error / 200) - 2):
        V = after_window(V, later.drops.min(), 1.0, 0.8, 0.0)
    assert V <= 0.01**2 / 2


NOT_CERTIFIED = [
    ({"learning.law": "sigma"}, "for the learned-flow law in a flow with parameters"),
    ({"localization": {"noise": 0.1, "noise_period": 1.0}}, "localization.noise"),
    ({"learning.sample": 0.5}, "learning.sample"),
    ({"vehicle.max_speed": 1.0, "learning.hedging": False}, "hedging"),
    ({"learning.adapt_gains": False}, "learning.feedback is fixed and differs"),
    (pushed("noise", [1, 1], period=1), "has no bound"),
    ({"reference.radius": 1e20}, "too many to compute"),
]


@pytest.mark.parametrize(("values", "said"), NOT_CERTIFIED, ids=str)
def test_what_is_not_certified_is_said(values, said):
    with pytest.raises(clpt.ScenarioError, match=said):
        certify(PAPER.with_values(values))


ROUNDED = [(0.0123456, 0.050004951), (5.00049, 0.0499996496)]


@pytest.mark.parametrize(("error", "radius"), ROUNDED)
def test_printed_bounds_are_rounded_outward(request, tmp_path, printed, error, radius):
    """A reader of the table takes no bound for smaller than it is, and no start for allowed."""
    clpt.save_scenario(PAPER, tmp_path / "paper.toml")
    words = "excitation", tmp_path / "paper.toml", "--bounds"
    words += "--radius", radius, "--error", error
    found, shown = printed(*words), request.getfixturevalue("clpt")(*words).out
    (said,) = re.findall(r"V\(0\) <= (\S+), windows", shown)
    assert radius * (1 - 1e-4) < float(said) <= radius
    lines = [
        re.findall(r"\d[\d.e-]*", row) for row in shown.splitlines() if row[:1] == "│"
    ]
    rows = [list(map(float, line)) for line in lines]
    exact = [found[name] for name in ("time", "V", "clpe", "flow_error")]
    assert len(rows) == len(found["time"])
    for column, values in zip(np.transpose(rows), exact, strict=True):
        assert np.all((column >= values) & (column <= np.multiply(values, 1 + 2e-5)))
    (never,) = re.findall(r"CLPE is never above (\S+)", shown)
    assert found["clpe"][0] <= float(never) <= found["clpe"][0] * 1.001
    (leaves,) = re.findall(r"leaves (\S+) of V at worst", shown)
    assert 1 - min(found["drops"]) <= float(leaves) <= (1 - min(found["drops"])) * 1.001


def test_the_radius_is_that_of_the_scenarios_own_start():
    found = certify(PAPER)
    assert found.radius == pytest.approx(4.63125)
    assert (
        json.loads(json.dumps(found.report(), allow_nan=False))["V"] == found.V.tolist()
    )


def test_numbers_that_are_none_are_refused():
    for radius, error in ((-1.0, None), (0.0, None), (1.0, 0.0), (np.inf, None)):
        with pytest.raises(
            clpt.ArgumentError, match="must be a number, positive and finite"
        ):
            certify(PAPER, radius, error=error)
    for radius, error in ((1.0, 1e308), (1e308, None)):
        with pytest.raises(clpt.ScenarioError, match=r"must be at most 1e\+12"):
            certify(PAPER, radius, error=error)
