"""Studies: the worst disturbance, the bound in the mean square, the vehicle's own ADCP."""

import numpy as np
import pytest
from responses import response

import clpt_control as clpt
from analysis.against_adcp import compared, read_adcp
from analysis.mean_square import mean_square_bound, mean_square_sides
from analysis.worst_disturbance import influences, peak_gains, regressor_matrices, worst_disturbance
from clpt_control.gliders import read_dives, usable
from clpt_control.theory.counterexamples import exact_run, scalar_matrix, with_square_wave
from clpt_control.theory.excitation.regressor import error_matrices


def test_peak_gain_in_closed_form():
    """One lag: (1 - e^{-kt})/k; adaptation at 10 rad/s: near 4/pi."""
    lag = np.full((1000, 1, 1), -2.0)
    assert peak_gains(lag, 0.001, [1000]) == pytest.approx((1 - np.exp(-2)) / 2, rel=1e-5)
    ringing = np.broadcast_to(scalar_matrix(1.0, gain=100.0), (2000, 2, 2))
    assert peak_gains(ringing, 0.01, [2000]) == pytest.approx(4 / np.pi, rel=3e-3)


def test_the_worst_disturbance_is_attained_by_the_closed_loop():
    """Bang-bang Delta = Dmax sign(c Phi b) in the wired diagram; (33) claims 1."""
    paper, step, end, size = clpt.paper_scenario(), 0.04, 161.0, 0.001
    A = regressor_matrices(paper, end, step)[0]
    influence = influences(A, step, [len(A)])[:, 0]
    predicted = peak_gains(A, step, [len(A)])[0]
    scenario = with_square_wave(paper, size, 3.5).with_values({"run.duration": end})
    loop = clpt.closed_loop(scenario, external=("delta",))
    run = response(
        loop,
        np.linspace(0.0, end, len(influence)),
        inputs=[size * np.sign(influence), 0.0],
        rtol=1e-6,
        atol=1e-9,
        initial_state=clpt.initial_state(scenario),
    )
    reached = abs(run.states[0, -1] - run.states[2, -1]) / size
    assert reached == pytest.approx(predicted, rel=0.01)
    assert reached > 2.5


@pytest.mark.slow
def test_the_worst_disturbance_of_the_second_and_later_cycles():
    found = worst_disturbance(clpt.paper_scenario(), 400.0, 800.0)
    assert found.peaks == pytest.approx((5.234, 4.744), rel=1e-3)


def test_mean_square_bound_along_the_papers_runs():
    paper = clpt.paper_scenario().with_values({"run.duration": 200, "run.output_step": 0.02})
    disturbed = {"kind": "noise", "amplitude": [0.1, 0.2], "period": 0.5, "seed": 3}
    for scenario in (
        paper,
        paper.with_values({"flow.disturbance": disturbed}),
        with_square_wave(paper, 0.05, 3.5),
    ):
        found = mean_square_bound(clpt.simulate(scenario), scenario)
        assert found.holds
        assert 0.01 < found.tightness < 1


def random_runs(rng, count):
    """Random regressors and disturbances; half of these push where e already is."""
    k, gain = 10 ** rng.uniform(-1, 1, 2)
    scale = rng.choice([0.1, 1.0, 5.0], count)[:, None]
    start = state = rng.normal(size=(count, 4)) * rng.choice([0.0, 1.0], count)[:, None]
    pushing = rng.random(count) < 0.5
    end, times, states, drives = 0.0, [], [], []
    for _ in range(12):
        phi, z, zc = (rng.normal(size=(count, n)) * scale for n in (1, 2, 2))
        drive = np.zeros((count, 4))
        push = np.where(state[:, 0] < 0, -1.0, 1.0) * 2 * k
        drive[:, 0] = np.where(pushing, push, rng.normal(size=count))
        A = error_matrices(phi, z, zc, [k, k], gain)[0]
        duration = rng.uniform(0.1, 2)
        each = zip(A, drive, state, strict=True)
        runs = [exact_run([(duration, *one, 100)], own) for *one, own in each]
        piece_times, reached = runs[0][0], np.stack([run for _, run in runs], axis=1)
        times.append(end + piece_times)
        states.append(reached)
        drives.append(np.broadcast_to(drive, reached.shape))
        end, state = times[-1][-1], reached[-1]
    V0 = (start[:, 0] ** 2 + np.sum(start[:, 1:] ** 2, axis=1) / gain) / 2
    e, delta = (np.concatenate(values)[..., :1] for values in (states, drives))
    return np.concatenate(times), e, delta, V0, k


def test_the_mean_square_bound_holds_for_random_disturbances():
    rng = np.random.default_rng(11)
    runs = violated = 0
    tightest = 0.0
    for _ in range(3):
        times, e, delta, V0, k = random_runs(rng, 50)
        found = mean_square_sides(times, e, delta, V0, k)
        assert found.holds
        runs += found.left.shape[1]
        tightest = max(tightest, found.tightness)
        largest = np.abs(delta[..., 0]).max(0) / k
        second_half = np.abs(e[len(times) // 2 :, :, 0]).max(0)
        violated += np.sum(second_half > largest)
    assert runs == 150
    assert 0.3 < tightest < 1
    assert violated > 15, "the same runs violate Eq. (33)"


def test_the_mean_square_bound_is_tight():
    """Slow adaptation, Delta held: int e^2 comes as near as one likes; twice is too much."""
    A = scalar_matrix(1.0, gain=1e-9)
    times, states = exact_run([(200.0, A, np.array([1.0, 0.0]), 4000)], np.zeros(2))
    delta = np.ones((len(times), 1))
    assert 0.98 < mean_square_sides(times, states[:, :1], delta, 0.0, 1.0).tightness < 1
    assert not mean_square_sides(times, 1.1 * states[:, :1], delta, 0.0, 1.0).holds


def test_learned_speed_and_current_are_those_of_the_adcp(facts):
    dives, skipped = usable(read_dives(facts / "glider" / "sg171_dives.csv")[0])
    found = compared(dives, read_adcp(facts / "glider" / "sg171_adcp.csv"))
    assert (len(dives), skipped) == (10, [])
    assert 1.3 < found.measured < 1.6
    assert abs(found.learned - found.measured) < found.standard_error < 0.15
    assert found.learned == pytest.approx(1.48, abs=0.11)
    assert found.current < 0.012 < 0.03 < found.in_file
