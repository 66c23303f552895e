"""DREM: each error shrinks by itself, and theta is read in finite time.

S adj(Q S) against det times inverse; one function seen without CLPE, phi = 1, has
Q = int phi_f^2/(1 + phi_f^2), Delta = Q/max(Q, 1/l) and eta = eta(0) exp(-g int min(1, Delta/c)^2).
"""

import numpy as np
import pytest
from error_sentences import says
from law_blocks import HELD, alone, of_law, still
from scipy.integrate import cumulative_simpson

import clpt_control as clpt
from clpt_control.paper.laws.memory_laws import mixing

LAW = clpt.laws()["drem"]
STARTS = {"learning.parameters": [[0.3, -0.2, 0.1], [0.0, 0.4, -2.0]]}


def of_paper(**more):
    return of_law("drem", {"run.duration": 200.0, **more})


def errors(run):
    """Return |theta_hat - theta| and |readout - theta| by time, axis and basis."""
    theta = run.flow_parameters
    found = (run.flow_parameters_estimate, run.flow_parameters_readout)
    return [np.abs((one - theta).transpose("time", ...).values) for one in found]


@pytest.mark.parametrize("n", range(1, 7))
def test_the_adjugate_is_numpys(n):
    """Also of a singular matrix."""
    random = np.random.default_rng(n)
    for singular in [False] * 9 + [True]:
        half, S = random.uniform(-1, 1, (n, n)), random.uniform(0.25, 1, n)
        half[0] = half[0] * (not singular)
        Q, cofactors = half @ half.T, np.empty((n, n))
        size = max(np.linalg.norm(A := Q * S), 1.0) ** n
        mixed, Delta = mixing(Q, S)
        assert Delta == pytest.approx(np.linalg.det(A), abs=1e-11 * size)
        for j, k in np.ndindex(n, n):
            # of one number has the determinant 1
            minor = np.delete(np.delete(A, j, 0), k, 1)
            cofactors[k, j] = (-1) ** (j + k) * np.linalg.det(minor)
        np.testing.assert_allclose(
            mixed, S[:, None] * cofactors, rtol=0, atol=1e-11 * size
        )


def test_drem_of_one_function_is_the_closed_form():
    g, c, pole = 0.7, 0.6, 1.5
    theta, first = np.array([[0.6], [-0.4]]), np.array([[0.2], [0.5]])
    own = {"rate": g, "excitation": c, "margin": 0.3, "filter": pole, "alpha_0": first}
    t, law = np.linspace(0, 8, 1601), still(LAW, **own, forgetting=0.0)
    states, run = alone(law, t, np.ones((1, 1601)), theta, alpha=first, w=1.0)
    phi_f = 1 - np.exp(-pole * t)
    Q = cumulative_simpson(phi_f**2 / (1 + phi_f**2), x=t, initial=0)
    Delta = Q / np.maximum(Q, 1 / pole)
    w = np.exp(-g * cumulative_simpson(np.minimum(1, (Delta / c) ** 2), x=t, initial=0))
    left, alpha = states["w"][0], states["alpha"]
    np.testing.assert_allclose(left, w, atol=1e-5)  # the kinks are between samples
    np.testing.assert_allclose(alpha, w * (theta + first) - theta, atol=2e-5)
    late = left < 0.7
    assert 0.1 < late.mean() < 0.9
    np.testing.assert_allclose(run.readout.values.T, np.where(late, theta, -alpha))


@pytest.mark.parametrize("held", [{}, HELD], ids=["adapted", "held"])
def test_each_error_only_shrinks_and_together(held):
    run = clpt.simulate(of_paper(**{**STARTS, **held, "run.output_step": 0.1}))
    (off, _), w = errors(run), run.error_left.values
    assert np.all(np.diff(off, axis=0) <= 1e-13)
    np.testing.assert_allclose(off, w[:, None, None] * off[0], atol=1e-12)
    assert w[-1] < 1e-9 < 1 == w[0]


@pytest.mark.parametrize("margin", [0.1, 0.5])
def test_theta_is_read_in_finite_time(margin):
    # slow, so that much of the first error is left
    own = {"margin": margin, "rate": 0.02}
    run = clpt.simulate(of_paper(**{**STARTS, "learning.drem": own}))
    off, read = errors(run)
    right = 1 - run.error_left.values >= margin
    assert read[right].max() < 1e-11
    np.testing.assert_array_equal(read[~right], off[~right])
    assert off[right][0].max() > 0.5  # the estimate itself is not there yet
    assert right[[0, -1]].tolist() == [False, True]


def test_the_readout_of_another_start_is_refused_or_right():
    """The readout of a loop that starts elsewhere was off by 0.375 m/s."""
    scenario = of_paper(**{"learning.drem": {"rate": 0.02}})
    loop, first = clpt.closed_loop(scenario), np.array(STARTS["learning.parameters"])
    begin, t = clpt.initial_state(loop), np.linspace(0.0, 100.0, 101)
    begin[4:10] = first.ravel()
    said = r"alpha is not adaptation\.alpha_0"
    says(clpt.SimulationError, said, clpt.simulate, loop, t, initial_state=begin)
    run = clpt.simulate(
        loop, t, initial_state=begin, params={"adaptation.alpha_0": first}
    )
    off, read = errors(run)
    assert read[-1].max() < 1e-11 < 0.1 < off[-1].max()
    late = clpt.simulate(
        loop, t[50:], initial_state=clpt.simulate(scenario).clpt.state(50.0)
    )
    assert errors(late)[1][-1].max() < 1e-11  # goes on


def test_a_faint_track_teaches_nothing_wrong():
    """One waypoint: the functions are seen in few ways, and nothing moves away from theta."""
    still = {"kind": "waypoints", "points": [[3.0, 0.0]], "dwell": 20.0}
    off, _ = errors(clpt.simulate(of_paper(**{**STARTS, "reference": still})))
    assert np.all(np.diff(off, axis=0) <= 1e-12)


def of_many(N):
    """The paper's scenario with more functions on two rings."""
    turn = 2 * np.pi * np.arange(N) / N
    ring = (5 + 3 * (np.arange(N) % 2)) * np.array([np.cos(turn), np.sin(turn)])
    basis = {"centers": ring.T.tolist(), "widths": [3.0] * N, "phases": [0.0] * N}
    return of_paper(
        **{
            "basis": {
                "kernel": "exponential",
                "periods": [9.0 + 2 * k for k in range(N)],
                **basis,
            },
            "flow.parameters": np.linspace(-1, 1, 2 * N).reshape(2, N).tolist(),
            **dict.fromkeys(
                ["model.parameters", "learning.parameters"], [[0.0] * N] * 2
            ),
        }
    )


@pytest.mark.long
def test_six_functions_are_mixed_and_seven_refused():
    off, read = errors(clpt.simulate(of_many(6)))
    assert np.all(np.diff(off, axis=0) <= 1e-10)
    assert max(off[-1].max(), read[-1].max()) < 1e-9
    said = "drem: takes at most 6 functions, not 7"
    says(clpt.ScenarioError, said, clpt.simulate, of_many(7))


def test_a_margin_or_an_excitation_that_is_never_reached_is_refused():
    for said in (
        "margin = 1.0: must be less than 1",
        "excitation = 2.0: must be less than or eq",
    ):
        key, value = said.split(":")[0].split(" = ")
        wrong = {"learning.drem": {key: float(value)}}
        says(clpt.ScenarioError, f"learning.drem.{said}", of_paper, **wrong)


BESIDE = [
    ({}, None),
    (
        {"flow.disturbance": {"kind": "constant", "amplitude": [0.1, 0]}},
        "flow.disturbance",
    ),
    ({"localization": {"noise": 0.02, "noise_period": 1.0}}, "localization.noise"),
]


@pytest.mark.parametrize(
    ("more", "beside"), BESIDE, ids=["of the basis", "disturbance", "noise"]
)
def test_a_readout_that_is_not_theta_is_marked(more, beside):
    run = clpt.simulate(of_paper(**{"run.duration": 100, **more}))
    off = np.abs(run.flow_parameters_readout - run.flow_parameters).isel(time=-1).max()
    assert (off > 1e-3) == (beside is not None)
    said = run.flow_parameters_readout.attrs.get("comment", "")
    assert said == (
        f"not theta exactly: {beside} is taken for flow of the basis" * bool(beside)
    )
