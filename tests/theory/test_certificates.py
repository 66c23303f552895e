"""Certificates as properties: guaranteed drop <= exact drop, bounds not violated."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from team_scenarios import DIFFERENT, ROW, team

import clpt_control as clpt
from analysis.worst_disturbance import error_matrices
from clpt_control.engine.model.block import evaluate
from clpt_control.theory.excitation import certificates, regressor
from clpt_control.theory.excitation.certificates import (
    collocation,
    propagate,
    time_to_tenth,
    ultimate_bound,
    window_drops,
)
from clpt_control.theory.excitation.certify import after_window, least_error, settled
from clpt_control.theory.excitation.regressor import regressors

NODES = 12
NODE, WEIGHT = np.polynomial.legendre.leggauss(NODES)
GROUPS = [  # KD, gain, window
    ([1.0, 1.0], 0.8, 4.0),
    ([1.0, 2.0], 0.05, 6.0),
    ([0.3, 0.5], 3.0, 3.0),
    ([5.0, 4.0], 0.3, 5.0),
    ([1.0, 1.0], 1e-3, 2.0),
]
EACH = 100  # regressors of each group


def random_regressors(seed, window, size=1.0, pieces=6, N=1):
    """Sums of sines with a jump at each piece, at Gauss-Legendre nodes."""
    rng, lengths = np.random.default_rng(seed), np.full(pieces, window / pieces)
    times = (np.arange(pieces)[:, None] + (1 + NODE) / 2) * lengths[0]
    weights = np.tile(lengths[0] * WEIGHT / 2, (pieces, 1))
    amplitude = rng.normal(size=(EACH, N + 4, 3)) * size
    frequency, phase = (
        rng.uniform(0, most, (EACH, N + 4, 3, 1, 1)) for most in (4, 2 * np.pi)
    )
    waves = np.einsum("bcs,bcspn->bpnc", amplitude, np.sin(frequency * times + phase))
    strength = size * rng.choice([0.0, 1.0, 3.0], (EACH, 1, 1, 1))
    jumps = strength * rng.normal(size=(EACH, pieces, 1, N + 4))
    return *np.split(waves + jumps, [N, N + 2], axis=-1), weights


@pytest.mark.parametrize("group", range(5))
@pytest.mark.parametrize("size", [0.1, 1.0])
def test_rho_never_exceeds_the_exact_drop(group, size):
    KD, gain, window = GROUPS[group]
    *w, weights = random_regressors(group, window, size)
    drop, rho, _ = window_drops(regressors(*w), weights, KD, gain)
    assert rho.shape == (2, EACH)
    assert np.all((rho > 0) & (rho <= drop) & (drop <= 1 + 1e-9))


@pytest.mark.parametrize("gain", [0.0, 0.8, 30.0])
def test_collocation_agrees_with_scipy(gain):
    def w(t):
        whole = np.stack(
            [np.sin(t), 1 + np.cos(2 * t), np.exp(-t), 2.0 + 0 * t, -1.0 + 0 * t], -1
        )
        return np.split(whole, [1, 3], axis=-1)

    times = (np.arange(24)[:, None] + (1 + NODE) / 2) * 0.125
    rows, end = propagate(
        regressors(*w(times)), np.array([1.0, 0.5]), gain, np.full(24, 0.125)
    )

    def rate(t, flat):
        return (error_matrices(*w(t), [1.0, 0.5], gain)[1] @ flat.reshape(4, 4)).ravel()

    at = np.append(times, 3.0)
    truth = solve_ivp(
        rate, (0, 3), np.eye(4).ravel(), "DOP853", at, rtol=1e-11, atol=1e-12
    )
    *along, last = truth.y.T.reshape(-1, 4, 4)
    np.testing.assert_allclose(end[1], last, atol=1e-8)
    np.testing.assert_allclose(rows[1].reshape(-1, 4), np.array(along)[:, 0], atol=1e-8)


def test_w_on_cut_pieces_is_the_polynomial_through_its_nodes():
    def w(cuts):
        t = cuts[:-1, None] + np.diff(cuts)[:, None] * (1 + NODE) / 2
        return np.stack([np.sin(3 * t), 20 * np.cos(5 * t)], axis=-1)

    whole = np.array([0.0, 0.4, 1.0])
    found, finer = certificates.finely(w(whole), np.diff(whole)[:, None] * WEIGHT / 2)
    parts = len(finer) // 2
    assert parts > 1
    cuts = np.concatenate(
        [np.linspace(0.0, 0.4, parts + 1)[:-1], np.linspace(0.4, 1, parts + 1)]
    )
    np.testing.assert_allclose(found, w(cuts), atol=1e-6)
    np.testing.assert_allclose(finer.sum(axis=1), np.diff(cuts))


def collocated(A, length):
    """Phi at the end of one piece by collocation with the whole of A."""
    *batch, nodes, n, _ = A.shape
    a, b = collocation(nodes)
    system = -np.einsum("jl,...lpq->...jplq", length * a, A)
    system = system.reshape(*batch, nodes * n, nodes * n) + np.eye(nodes * n)
    starts = np.broadcast_to(np.tile(np.eye(n), (nodes, 1)), (*batch, nodes * n, n))
    inner = np.linalg.solve(system, starts).reshape(*batch, nodes, n, n)
    return np.eye(n) + np.einsum("l,...lpq,...lqr->...pr", length * b, A, inner)


def test_more_parameters_than_samples_are_guaranteed_nothing():
    rng = np.random.default_rng(8)
    w = regressors(*(rng.normal(size=(1, NODES, n)) for n in (NODES, 2, 2)))
    drop, rho, _ = window_drops(w, WEIGHT[None] / 2, [1.0, 1.0], 0.8)
    assert not rho.any()
    assert not drop.any()


def test_the_axes_do_not_meet_and_the_matrices_are_the_diagram_s():
    scenario, rng = clpt.paper_scenario(), np.random.default_rng(3)
    loop, w = (
        clpt.closed_loop(scenario, errors=True),
        [rng.normal(size=n) for n in (3, 2, 2)],
    )
    columns = [loop.dynamics(0, unit, np.concatenate(w)) for unit in np.eye(12)]
    order = [label.split("[")[0] for label in loop.state_labels]
    assert order == sorted(order)  # e, then eta
    rebuilt = np.zeros((12, 12))
    matrices = error_matrices(*w, scenario.vehicle.feedback, scenario.learning.gain)
    for i, A in enumerate(matrices):
        own = [i, 2 + 3 * i, 3 + 3 * i, 4 + 3 * i, 8 + i, 10 + i]
        rebuilt[np.ix_(own, own)] = A
    np.testing.assert_allclose(rebuilt, np.transpose(columns), atol=1e-15)


@pytest.mark.parametrize("group", range(5))
def test_the_corrected_bound_is_never_violated(group):
    """500 disturbances: square waves, sines and noise, on periodic exciting regressors."""
    KD, gain, window = GROUPS[group]
    *w, weights = random_regressors(20 + group, window)
    drop, rho, _ = window_drops(regressors(*w), weights, KD, gain)
    # the transition of each, beside a push on e
    A = _pushed(error_matrices(*w, KD, gain))
    steps = [
        collocated(A[..., k, :, :, :], length)
        for k, length in enumerate(weights.sum(1))
    ]
    rng, count = np.random.default_rng(40 + group), 300 * len(steps)
    kind = rng.integers(0, 3, (EACH, 1))
    begin, turn = rng.uniform(0, 2 * np.pi, (EACH, 1)), rng.uniform(0.05, 3, (EACH, 1))
    wave = np.sin(begin + turn * np.arange(count))
    signal = np.choose(kind, [np.sign(wave), wave, rng.uniform(-1, 1, (EACH, count))])
    heading = rng.uniform(0, 2 * np.pi, EACH)
    delta = 0.05 * np.stack([np.cos(heading), np.sin(heading)])[..., None] * signal
    state, largest = np.zeros((2, EACH, 5)), np.zeros(EACH)
    for j in range(count):
        state[..., -1] = delta[..., j]
        state = np.einsum("abpq,abq->abp", steps[j % len(steps)], state)
        if j >= count // 2:
            largest = np.maximum(largest, np.hypot(*state[..., 0]))
    for shares in (drop.min(0), rho.min(0)):  # exact, and guaranteed
        assert np.all(
            largest <= [ultimate_bound(window, 0.05, share) for share in shares]
        )
    assert largest.max() > 0.05 / max(KD) / 20


def _pushed(A):
    """Add a state that is constant and drives e: Delta of Eq. (32)."""
    n = A.shape[-1]
    wide = np.zeros((*A.shape[:-2], n + 1, n + 1))
    wide[..., :n, :n] = A
    wide[..., 0, n] = 1.0
    return wide


def test_the_paper_s_contraction(true_paper):
    found = clpt.gramian(true_paper, 200.0, 200.0).certificate()
    assert found.contraction == pytest.approx(0.67988, abs=1e-4)
    assert found.drop == pytest.approx(1 - found.contraction, abs=1e-12)
    assert 0 < found.rho < found.drop
    assert "simulated" in found.trajectory


def test_times_and_bounds_at_their_limits():
    assert ultimate_bound(10.0, 0.1, 0.0) == np.inf
    decay = certificates.Certificate(
        0.0, 10.0, "", {"x1": 1.0}, {"x1": 0.75}, False, {}, None
    )
    assert decay.ultimate_bound(0.1) == ultimate_bound(10.0, 0.1, 1.0)
    assert decay.ultimate_bound(0.1, guaranteed=True) == ultimate_bound(10, 0.1, 0.75)
    assert ultimate_bound(10.0, 0.1, 1.0) == pytest.approx(2.0)
    assert ultimate_bound(1.0, 1.0, 1e-20) == pytest.approx(2e20)
    drops = 0.0, 0.5, 0.99, 1.0  # of V a half each: 2^-7 < 0.01 < 2^-6
    assert [time_to_tenth(10.0, drop) for drop in drops] == [np.inf, 70.0, 10.0, 10.0]
    for drop in (-0.1, 1.1, np.nan):
        with pytest.raises(clpt.ClptError, match="drop"):
            ultimate_bound(10.0, 0.1, drop)


# --- bounds for every start ---


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


PAPER = clpt.paper_scenario().with_values({"run.duration": 400})


def pushed(kind, amplitude, **more):
    """A disturbance."""
    return {"flow.disturbance": {"kind": kind, "amplitude": amplitude, **more}}


DISTURBED = pushed("square", [0.004, 0.003], period=1.8)


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


STARTS = [
    ({}, 0.05, 6),
    (DISTURBED, 0.05, 6),
    pytest.param({}, 4.63125, 200, marks=pytest.mark.slow),
    pytest.param({}, 0.05, 200, marks=pytest.mark.slow),
    pytest.param(DISTURBED, 0.5, 200, marks=pytest.mark.slow),
]


@pytest.mark.long
@pytest.mark.parametrize(("values", "R", "starts"), STARTS)
def test_no_start_within_r_leaves_the_bounds(values, R, starts):
    """V, CLPE and errors at every sample of three cycles; the closest comes near."""
    scenario = PAPER.with_values(
        {"run.duration": 600, "run.output_step": 0.5, **values}
    )
    found, rng, closest = clpt.certify(scenario, R), np.random.default_rng(3), 0.0
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


def test_the_time_is_the_first_from_which_the_bound_holds():
    found = clpt.certify(PAPER.with_values({"run.duration": 1000}), 0.05, error=0.2)
    j = round(found.time_to_error / 200)
    assert found.within_run
    assert found.clpe[j] <= 0.2 < found.clpe[j - 1]
    later = clpt.certify(PAPER, 0.05, error=0.01)
    assert not later.within_run
    assert "if later windows" in later.said
    V = later.V[-1]
    for _ in range(round(later.time_to_error / 200) - 2):
        V = after_window(V, later.drops.min(), 1.0, 0.8, 0.0)
    assert V <= 0.01**2 / 2


# --- pieces of windows ---


def test_a_learner_that_swings_within_a_dwell_has_the_gramian_of_a_fine_sum(paper):
    """Gauss's rule on panels of 0.1 s; with the learner's gain e and z turn 15 times in a dwell."""
    scenario = paper.with_values({"learning.gain": 20.0})
    node, weight = np.polynomial.legendre.leggauss(6)
    times = (np.arange(400)[:, None] + (1 + node) / 2).ravel() / 10
    run = clpt.simulate(scenario, np.append(0.0, times), rtol=1e-10, atol=1e-12)
    phi = evaluate(scenario.basis_block(), times, run.position.values[1:])
    team = clpt.Team(members={"a": scenario, "b": scenario}, coupling=0.5)
    alone, of_team = (
        clpt.gramian(scenario, 40.0, 0.0),
        clpt.gramian(team, 40.0, 0.0).vehicles["a"],
    )
    for i, axis in enumerate(("x1", "x2")):
        z, zc = run.predicted_position.values[1:, i], run.reference.values[1:, i]
        w = np.column_stack([phi, z, zc])
        wanted = w.T @ (w * np.tile(weight / 20, 400)[:, None])
        for found in (alone, of_team):  # of two that are alike
            np.testing.assert_allclose(found.gramians[axis], wanted, rtol=1e-6)


def test_no_node_lies_on_a_switch_and_weights_sum_to_the_window(paper):
    cuts, times, weights = regressor.quadrature(
        paper, 13.0, 71.5, np.array([20.0, 33.3])
    )
    assert weights.sum() == pytest.approx(58.5, abs=1e-10)
    assert {20.0, 33.3, 40.0, 60.0} <= set(cuts.tolist())
    assert np.all(np.diff(times.ravel()) > 0)
    assert np.all(np.floor(times / 20) == np.floor(times[:, :1] / 20))


@pytest.mark.long
def test_a_window_that_cannot_be_followed_is_said_so(paper):
    far = paper.with_values({"run.duration": 20, "reference.radius": 1e4})
    report = clpt.gramian(far, 20.0, 0.0).report
    assert report["rho"] is report["contraction"] is report["time_to_tenth"] is None
    assert "too many to compute. Give a shorter" in report["not_certified"]
    assert len(report["eigenvalues"]["x1"]) == 5


STIFF = {
    name: scenario.with_values({"vehicle.feedback": gains})
    for (name, scenario), gains in zip(
        DIFFERENT.items(), ([10, 10], [15, 12], [11, 13]), strict=True
    )
}


# a stiff vehicle has pieces of its own, short enough at once
@pytest.mark.long
@pytest.mark.parametrize("members", [DIFFERENT, STIFF])
def test_the_pooled_gramian_is_the_sum_with_gains_of_their_own(members):
    of = team(0.0, ROW, **members)  # uncoupled, each as its own scenario runs
    N, window, start = 3, 6.0, 2.0
    found = clpt.gramian(of, window, start)
    assert found.names["x1"][N:] == [
        f"{g}_1 of {v}" for v in "abc" for g in ("K", "Gamma")
    ]
    for axis in ("x1", "x2"):
        whole = np.zeros((N + 6, N + 6))
        for k, scenario in enumerate(of.members.values()):
            at = [*range(N), N + 2 * k, N + 2 * k + 1]
            whole[np.ix_(at, at)] += clpt.gramian(scenario, window, start).gramians[
                axis
            ]
        np.testing.assert_allclose(found.gramians[axis], whole, rtol=0, atol=1e-6)
    read = clpt.gramian(clpt.simulate(of, np.arange(0.0, 12.01, 0.05)), window, start)
    for one, exact in (
        (read, found),
        *((read.vehicles[v], found.vehicles[v]) for v in "abc"),
    ):
        assert one.smallest == pytest.approx(exact.smallest, rel=1e-2)
