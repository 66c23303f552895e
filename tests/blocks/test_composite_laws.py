"""The composite laws against closed forms and numbers made another way.

P(t) = 1/(1/P(0) + int phi_f^2/r^2) and theta_hat = theta (1 - P/P(0)) of one function seen
without CLPE, Q = int phi_f^2/(1 + phi_f^2), F_f = theta phi_f, V with P inverted by NumPy.
"""

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import quad, simpson

import clpt_control as clpt
from clpt_control.blocks.laws import composite_least_squares, composite_memory
from clpt_control.currents.fit import fit_scenario
from clpt_control.currents.fit_file import save_fit
from clpt_control.errors import ScenarioError
from clpt_control.simulation.flows import explained_variance

LAWS = ("composite-least-squares", "composite-memory")
LEAST_SQUARES = composite_least_squares.CompositeLeastSquaresParameters(
    1, 100.0, 0.3, 1.5, np.array([1 / 0.8**2]), 0.0, 0.0
)
MARACOOS = Path(__file__).parents[1] / "data/field/maracoos_hfr_2019-01-01.nc"
MEMORY = composite_memory.CompositeMemoryParameters(1, 0.8, 0.0, 0.0, 0.7, 0.0, 1.5)


def changed(law, **more):
    """The paper's scenario with this law, K and Gamma held true."""
    paper = clpt.paper_scenario()
    car = paper.vehicle
    held = {"learning.feedback": car.feedback, "learning.feedforward": car.feedforward}
    own = {key.replace("__", "."): value for key, value in more.items()}
    return paper.with_values({"learning.law": law, "learning.adapt_gains": False, **held, **own})


def drifting(law, state, theta, t):
    """Run a law of one function alone: phi = 1, e = 0, v = 0, a vehicle that drifts from 0."""
    inputs = {"e": 2, "phi_x": 1, "z": 2, "zc": 2, "x": 2, "v_x": 2}
    u = np.zeros((sum(inputs.values()), len(t)))
    u[2] = 1.0
    u[7:9] = theta[:, None] * t
    loop = clpt.connect([law], external=list(inputs))
    return clpt.simulate(loop, t, u, state, rtol=1e-11, atol=1e-13).states


def test_least_squares_of_one_function_is_the_closed_form():
    p, theta, t = LEAST_SQUARES, np.array([0.6, -0.4]), np.linspace(0, 8, 9)
    start = np.zeros(12)
    start[8] = 0.8**2  # P, after alpha, K, Gamma, impulse
    states = drifting(composite_least_squares.composite_least_squares_law(p), start, theta, t)
    seen = t - 2 * (1 - np.exp(-1.5 * t)) / 1.5 + (1 - np.exp(-3 * t)) / 3  # of phi_f^2
    P = 1 / (1 / 0.8**2 + seen / 0.3**2)
    np.testing.assert_allclose(states[8], P, rtol=1e-9)
    np.testing.assert_allclose(-states[:2], theta[:, None] * (1 - P / 0.8**2), atol=1e-9)


def test_memory_of_one_function_is_its_integral():
    theta, t = np.array([0.6, -0.4]), np.linspace(0, 8, 9)
    states = drifting(composite_memory.composite_memory_law(MEMORY), np.zeros(12), theta, t)

    def seen(s):
        return (1 - np.exp(-1.5 * s)) ** 2 / (1 + (1 - np.exp(-1.5 * s)) ** 2)

    Q = [quad(seen, 0, end, epsabs=1e-13)[0] for end in t]
    np.testing.assert_allclose(states[6], Q, atol=1e-9)
    np.testing.assert_allclose(states[7:9], theta[:, None] * np.array(Q), atol=1e-9)


def along(law, duration, step, **more):
    """A run of the paper's flow, and its states: x, z, alpha, K, Gamma and the law's own."""
    scenario = changed(law, run__duration=duration, run__output_step=step, **more)
    scenario = scenario.with_values({"run.rtol": 1e-11, "run.atol": 1e-13})
    loop, run = clpt.closed_loop(scenario), clpt.simulate(scenario)
    found = clpt.simulate(
        loop, run.time.values, None, clpt.initial_state(scenario), rtol=1e-11, atol=1e-13
    )
    return run, found.states


@pytest.mark.parametrize("law", LAWS)
def test_the_filtered_flow_is_that_of_the_true_parameters(law):
    run, x = along(law, 15.0, 0.5, vehicle__position=[1.3, -0.7])
    theta = run.flow_parameters.values
    phi_f, q = x[-5:-2], x[-2:]
    F_f = 2.0 * run.position.values.T - q  # the filter's pole is twice KD = 1
    np.testing.assert_allclose(F_f, theta @ phi_f, atol=1e-9)
    assert np.abs(F_f).max() > 0.1


def test_V_is_that_of_P_inverted_and_falls_as_the_theorem_says():
    run, x = along(
        "composite-least-squares", 20.0, 0.002, learning__parameters=[[0.3, -0.2, 0.1], [0.2, 0, 0]]
    )
    alpha, P, phi_f = x[4:10].T.reshape(-1, 2, 3), x[20:29].T.reshape(-1, 3, 3), x[29:32].T
    eta = alpha + run.flow_parameters.values
    gamma = 100 / 0.3**2  # r = 0.1 R with R = 3, KD = 1
    e = run.clpe.values
    apart = np.einsum("tik,tkj,tij->t", eta, np.linalg.inv(P), eta) / gamma
    V = (np.sum(e**2, -1) + apart) / 2
    np.testing.assert_allclose(run.lyapunov, V, rtol=1e-7)
    rate = -np.sum(e**2, -1) - np.sum(np.einsum("tik,tk->ti", eta, phi_f) ** 2, -1) / 200
    assert simpson(rate, x=run.time.values) == pytest.approx(V[-1] - V[0], rel=1e-6)


def test_V_of_the_memory_falls_as_the_theorem_says():
    run, x = along("composite-memory", 20.0, 0.01)
    eta = run.alpha.values + run.flow_parameters.values
    Q = x[14:23].T.reshape(-1, 3, 3)
    rate = -np.sum(run.clpe.values**2, -1) - np.einsum("tik,tkj,tij->t", eta, Q, eta)
    V = run.lyapunov.values  # gamma = gamma_c = 0.8
    assert simpson(rate, x=run.time.values) == pytest.approx(V[-1] - V[0], rel=1e-6)


@pytest.mark.parametrize("law", LAWS)
def test_python_runs_the_same(law):
    scenario = changed(law, run__duration=3.0, run__output_step=1.0)
    native, python = (clpt.simulate(scenario, engine=engine) for engine in ("native", "python"))
    np.testing.assert_allclose(native.alpha, python.alpha, atol=1e-9)


@pytest.mark.parametrize(
    ("law", "at_200", "at_2000"), [(LAWS[0], 2e-3, 1e-9), (LAWS[1], 1e-5, 1e-9)]
)
def test_the_flow_is_learned_in_a_lap_or_two(law, at_200, at_2000):
    """At t = 200 the largest error of the paper's law, its gains adapted, is 0.257."""
    run = clpt.simulate(changed(law, run__duration=2000.0))
    off = np.abs(run.flow_parameters_estimate - run.flow_parameters).max(("axis", "basis"))
    assert off.sel(time=200) < at_200
    assert off.sel(time=2000) < at_2000


def test_a_prior_of_0_holds_its_parameter():
    table = {"priors": [1.0, 0.0, 1.0]}
    run = clpt.simulate(
        changed(LAWS[0], run__duration=20.0, learning__composite_least_squares=table)
    )
    assert np.ptp(run.alpha.values[:, :, 1]) == 0
    assert np.ptp(run.alpha.values[:, :, 0]) > 0.1


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ({"priors": [1.0, 2.0]}, "priors: has 2 numbers; must be one for each of the 3 functions"),
        ({"prior": 1.0, "priors": [1.0] * 3}, "give either prior or priors"),
        ({"priors": [-1.0] * 3}, "priors"),
    ],
)
def test_priors_must_fit(table, said):
    with pytest.raises(ScenarioError, match=said):
        clpt.simulate(changed(LAWS[0], learning__composite_least_squares=table))


def test_a_track_without_length_needs_the_scales():
    still = {"kind": "waypoints", "points": [[0.0, 0.0]], "dwell": 10.0}
    with pytest.raises(ScenarioError, match=r"lie at one place.*give prior and noise"):
        clpt.simulate(changed(LAWS[0], reference=still, run__duration=1.0))
    given = {"prior": 1.0, "noise": 0.3}
    more = {"learning__composite_least_squares": given, "run__duration": 1.0}
    assert clpt.simulate(changed(LAWS[0], reference=still, **more)).sizes["time"] == 2


@pytest.mark.parametrize("law", LAWS)
def test_members_start_their_filters_where_they_start(law):
    scenario = changed(law, run__duration=200.0)
    starts = [[0.0, 0.0], [2.0, -1.0], [-1.0, 3.0]]
    vary = f"vehicle.position={starts}"
    found = clpt.ensemble.run_ensemble(scenario, vary, 6, trajectories=True)
    for k, start in enumerate(found["vehicle.position"].values):
        one = clpt.simulate(scenario.with_values({"vehicle.position": start.tolist()}))
        there = found.alpha.isel(member=k, time=-1)
        np.testing.assert_allclose(there, one.alpha.isel(time=-1), atol=1e-9)
    assert len(np.unique(found["vehicle.position"], axis=0)) > 1


def test_a_measured_current_is_learned_in_one_lap(tmp_path):
    """MARACOOS: 27 functions, no prior knowledge of theta, defaults, as a fit writes it."""
    box, tides = (40.9, 41.55, -69.9, -69.0), ("steady", "M2")
    fitted = fit_scenario(MARACOOS, box, rows=3, columns=3, width_km=15.0, constituents=tides)
    scenario = save_fit(fitted, tmp_path / "shoals.toml")
    scenario = scenario.with_values({"learning.law": LAWS[0], "learning.adapt_gains": False})
    run = clpt.simulate(scenario)
    late = run.clpe.sel(time=slice(18 - 1e-6, None))
    share = explained_variance(scenario, run)
    assert float(np.sqrt((late**2).sum("axis").mean())) <= 0.021
    assert share["track"] >= 0.98
    assert share["box"] >= 0.35
