"""Excitation: the paper's numbers, named parameters, recorded runs, closed forms, teams."""

import json

import numpy as np
import pytest
from made_fields import uniform_field
from pictures import inked
from strait import DIFFERENT, ROW, team, vehicle

import clpt_control as clpt_package
from clpt_control.blocks.reference import circle
from clpt_control.equations import evaluate
from clpt_control.errors import ScenarioError
from clpt_control.pages.results import excitation_result
from clpt_control.theory.excitation import regressor
from clpt_control.theory.excitation.certificates import certificate
from clpt_control.theory.excitation.excitation_report import excitation_plot, excitation_report
from clpt_control.theory.excitation.gramian import (
    gramian,
    parameter_names,
    sliding_excitation,
    started_true,
)
from clpt_control.theory.excitation.regressor import quadrature
from clpt_control.theory.proving.lemmas import circle_step

KERNELS = {"exponential": (4.3331, 4.6692), "gaussian": (0.19002, 0.19353)}


@pytest.mark.parametrize(("kernel", "expected"), KERNELS.items())
def test_the_smallest_eigenvalues_of_the_paper(true_paper, kernel, expected):
    found = gramian(true_paper.with_values({"basis.kernel": kernel}), 200.0, 200.0)
    if kernel == "exponential":
        np.testing.assert_allclose([*found.ceilings.values()], [5.48, 5.19], atol=0.005)
    least = [values[0] for values in found.eigenvalues.values()]
    np.testing.assert_allclose(least, expected, rtol=5e-5)
    assert found.not_learnable == []
    assert found.dimension == {"x1": 5, "x2": 5}


def test_the_second_function_is_not_learnable_in_gaussian_sigma(true_paper):
    scenario = true_paper.with_values({"basis.kernel": "gaussian-sigma"})
    found = gramian(scenario, 200.0, 200.0)
    for i, axis in enumerate(("x1", "x2"), 1):
        assert 0 < found.eigenvalues[axis][0] < 1e-10
        assert found.dimension[axis] == 4
        assert found.least_excited[axis][f"theta_{i}[2]"] == pytest.approx(1, abs=1e-6)
        assert f"theta_{i}[2] is not learnable on this track" in found.not_learnable
        basis = found.identifiable[axis]
        np.testing.assert_allclose(basis.T @ basis, np.eye(4), atol=1e-12)
        assert abs(basis[1]).max() < 1e-6
    assert len(found.not_learnable) == 2


def test_equal_functions_are_learnable_only_together(true_paper):
    scenario = true_paper.with_values(
        {
            "basis.centers": [[0, 0], [10, 10], [0, 0]],
            "basis.widths": [5, 5, 5],
            "basis.periods": [12.42, 10.42, 12.42],
            "run.duration": 200,
        }
    )
    found = gramian(scenario, 200.0, 0.0)
    assert found.not_learnable == [
        f"theta_{i}[1] and theta_{i}[3] are not learnable one by one on this track" for i in (1, 2)
    ]
    assert found.dimension == {"x1": 4, "x2": 4}


def test_a_learner_that_swings_within_a_dwell_has_the_gramian_of_a_fine_sum(paper):
    """Gauss's rule on panels of 0.1 s; with the learner's gain e and z turn 15 times in a dwell."""
    scenario = paper.with_values({"learning.gain": 20.0})
    node, weight = np.polynomial.legendre.leggauss(6)
    times = (np.arange(400)[:, None] + (1 + node) / 2).ravel() / 10
    run = clpt_package.simulate(scenario, np.append(0.0, times), rtol=1e-10, atol=1e-12)
    phi = evaluate(scenario.basis_block(), times, run.position.values[1:])
    team = clpt_package.Team(members={"a": scenario, "b": scenario}, coupling=0.5)
    alone, of_team = gramian(scenario, 40.0, 0.0), gramian(team, 40.0, 0.0).vehicles["a"]
    for i, axis in enumerate(("x1", "x2")):
        z, zc = run.predicted_position.values[1:, i], run.reference.values[1:, i]
        w = np.column_stack([phi, z, zc])
        wanted = w.T @ (w * np.tile(weight / 20, 400)[:, None])
        for found in (alone, of_team):  # of two that are alike
            np.testing.assert_allclose(found.gramians[axis], wanted, rtol=1e-6)


def test_no_node_lies_on_a_switch_and_weights_sum_to_the_window(paper):
    cuts, times, weights = quadrature(paper, 13.0, 71.5, np.array([20.0, 33.3]))
    assert weights.sum() == pytest.approx(58.5, abs=1e-10)
    assert {20.0, 33.3, 40.0, 60.0} <= set(cuts.tolist())
    assert np.all(np.diff(times.ravel()) > 0)
    assert np.all(np.floor(times / 20) == np.floor(times[:, :1] / 20))


@pytest.mark.parametrize(("step", "tolerance"), [(1.0, 2e-3), (0.7, 1e-3), (0.2, 1e-6)])
def test_a_recorded_run_gives_the_same(true_paper, step, tolerance):
    exact = excitation_report(true_paper, 200.0, 200.0)
    report = excitation_report(
        clpt_package.simulate(true_paper.with_values({"run.output_step": step})), 200.0, 200.0
    )
    assert report["trajectory"] == f"recorded run, sampled each {step:g} s"
    assert exact["trajectory"] == "simulated from the initial values"
    found, wanted = ([one["eigenvalues"][a] for a in ("x1", "x2")] for one in (report, exact))
    deviation = np.max(np.abs(np.divide(found, wanted) - 1))
    assert deviation <= min(report["accuracy"] + 1e-12, tolerance)
    assert report["contraction"] == pytest.approx(exact["contraction"], rel=1e-3)
    assert report["rho"] == pytest.approx(exact["rho"], rel=1e-2)


@pytest.mark.parametrize("step", [7.0, 20.0, 500.0])
def test_what_samples_far_apart_do_not_say_is_not_known(paper, step):
    """An eigenvalue is 25 % off or more, and of two samples none can be left out to find it."""
    scenario = paper.with_values({"run.duration": 400, "run.output_step": step})
    report = excitation_report(clpt_package.simulate(scenario), 200.0, 200.0)
    exact = excitation_report(scenario, 200.0, 200.0)["eigenvalues"]["x1"]
    assert np.max(np.abs(np.divide(report["eigenvalues"]["x1"], exact) - 1)) > 0.25
    assert report["accuracy"] is None
    *_, said, _ = excitation_result(report).sentences
    assert said.startswith("accuracy of the eigenvalues: not known: the samples are too far")


def test_a_disturbed_run_is_not_said_to_learn_as_fast_as_another(paper):
    """A learner that begins true has V = 0, which Delta raises: V falls to no share of itself."""
    push = {"flow.disturbance": {"kind": "constant", "amplitude": [0.1, 0.1]}}
    pushed = started_true(paper.with_values(push))
    V = clpt_package.simulate(pushed, [0.0, 200.0]).lyapunov.values
    assert V[1] > V[0]
    assert "at worst, t = 0 to 200, but for what the disturbance adds" in repr(
        certificate(pushed, 200.0, 0.0)
    )
    said = excitation_result(excitation_report(pushed, 200.0, 0.0)).sentences
    assert "V and errors fall so but for what the disturbance adds to them" in said
    assert not excitation_report(paper, 200.0, 0.0)["disturbed"]


def test_a_window_that_cannot_be_followed_is_said_so(paper, monkeypatch):
    from clpt_control.theory.excitation import certificates

    monkeypatch.setattr(certificates, "MOST", 0)
    report = excitation_report(paper, 40.0, 0.0)
    assert report["rho"] is report["contraction"] is report["time_to_tenth"] is None
    assert "too many to follow; give a shorter" in report["not_certified"]
    assert len(report["eigenvalues"]["x1"]) == 5


def test_the_known_flow_law_has_a_certificate_of_its_gains(paper):
    known = {"learning.law": "known-flow", "learning.parameters": None}
    estimate = {"learning.theta_estimate": [[1, 0.4, 0.8], [0.9, 0.4, 0.8]]}
    report = excitation_report(paper.with_values(known | estimate), 200.0, 200.0)
    assert 0 < report["rho"] < report["drop"] < 1


def test_a_gridded_field_needs_no_theta(tmp_path):
    uniform_field(tmp_path / "field.nc", v=0.2, end=400.0)
    flow = {"field": str(tmp_path / "field.nc")}
    scenario = clpt_package.paper_scenario().with_values({"flow": flow})
    report = excitation_report(scenario.with_values({"run.duration": 100}), 50.0, 20.0)
    assert len(report["eigenvalues"]["x1"]) == 5
    with pytest.raises(ScenarioError, match="gridded"):
        started_true(scenario)
    stopped = scenario.with_values(
        {"run.duration": 100, "flow.outside": "stop", "reference.radius": 30}
    )
    with pytest.raises(ScenarioError, match="the run ended before: stopped"):
        gramian(stopped, 50.0, 20.0)
    run = clpt_package.simulate(stopped.with_values({"run.output_step": 0.01}))
    assert len(gramian(run).eigenvalues["x2"]) == 5


OUTSIDE = [(0.0, 0.0), (-1.0, 0.0), (500.0, 0.0), (200.0, 300.0), (10.0, -1.0)]


@pytest.mark.parametrize(("window", "start"), [*OUTSIDE, (np.inf, 0.0), (10.0, np.inf)])
def test_a_window_outside_the_run_is_refused(paper, window, start):
    with pytest.raises(ScenarioError, match="within the run, 0 to 400 s"):
        gramian(paper, window, start)


def test_the_sliding_window_agrees_with_single_windows(paper):
    starts, eigenvalues = sliding_excitation(paper, 50.0, count=8)
    assert starts[[0, -1]].tolist() == [0.0, 350.0]
    for k in (0, 3, 7):
        single = gramian(paper, 50.0, float(starts[k]))
        for axis in ("x1", "x2"):
            np.testing.assert_allclose(
                eigenvalues[axis][k], single.eigenvalues[axis], rtol=1e-5, atol=1e-12
            )


def test_the_figure_shows_what_is_not_learnable(true_paper, tmp_path):
    scenario = true_paper.with_values({"basis.kernel": "gaussian-sigma", "run.duration": 100})
    _, eigenvalues = sliding_excitation(scenario, 60.0)
    (top, _), (bottom, _) = excitation_plot(scenario, 60.0, 10.0)
    top.figure.savefig(tmp_path / "excitation.png")
    np.testing.assert_allclose(top.get_lines()[-2].get_ydata(), eigenvalues["x1"][:, 0], rtol=1e-12)
    least = gramian(scenario, 60.0, 10.0).least_excited["x1"]
    assert [bar.get_height() for bar in bottom.patches] == list(least.values())


def test_the_circles_closed_form_is_the_reference_blocks(paper):
    assert circle_step().holds
    for n in range(3, 25):
        points = circle(3.0, n)
        np.testing.assert_allclose(
            20.0 * points.T @ points, n * 20.0 * 9.0 / 2 * np.eye(2), atol=1e-9
        )
    assert np.linalg.matrix_rank(circle(3.0, 2), tol=1e-9) == 1


def test_the_command_prints_the_report(clpt, tmp_path, true_paper):
    clpt_package.save_scenario(true_paper, tmp_path / "true.toml")
    words = (tmp_path / "true.toml", "--window", "200", "--start", "200", "--json")
    outcome = clpt("excitation", *words, "--figure", tmp_path / "true.png")
    assert outcome.status == 0, outcome.err
    report, printed = excitation_report(true_paper, 200.0, 200.0), json.loads(outcome.out)
    assert report["eigenvalues"]["x1"] == sorted(report["eigenvalues"]["x1"])
    assert 0 < report["rho"] < report["drop"] == pytest.approx(1 - report["contraction"])
    assert report["time_to_tenth"] % 200 == 0
    assert report["not_learnable"] == []
    assert {key: printed[key] for key in report} == json.loads(json.dumps(report))
    smallest = [printed["eigenvalues"][axis][0] for axis in ("x1", "x2")]
    np.testing.assert_allclose(smallest, KERNELS["exponential"], rtol=5e-5)
    assert list(printed["least_excited"]["x1"]) == parameter_names(3)["x1"]
    assert inked(tmp_path / "true.png") > 0.01


def test_the_ceiling_is_an_identity_of_the_blocks():
    """w^T c = x' + KD e, at random states of the running diagram."""
    run = clpt_package.paper_scenario().with_values(
        {"model.parameters": [[0.3, 0.1, 0.2], [0.2, 0.7, 0.4]], "vehicle.feedback": [1.5, 0.7]}
    )
    truth, loop = gramian(started_true(run), 20.0, 100.0).truth, clpt_package.closed_loop(run)
    rng = np.random.default_rng(2)
    for t in rng.uniform(0, 100, 20):
        state = rng.normal(size=loop.nstates)
        rate = dict(zip(loop.state_labels, loop.dynamics(t, state, []), strict=True))
        seen = dict(zip(loop.output_labels, loop.output(t, state, []), strict=True))
        for i, c in enumerate(truth.values()):
            w = [seen[f"phi_x[{k}]"] for k in range(3)] + [seen[f"z[{i}]"], seen[f"zc[{i}]"]]
            moved = next(
                rate[name] for name in rate if name.endswith(f"x[{i}]") and "vehicle" in name
            )
            assert w @ c == pytest.approx(moved + run.vehicle.feedback[i] * seen[f"e[{i}]"])


@pytest.mark.parametrize(
    "values",
    [
        {"vehicle.max_speed": 1.0},
        {"flow.disturbance": {"kind": "constant", "amplitude": [0.1, 0.0]}},
    ],
    ids=str,
)
def test_where_something_else_moves_the_vehicle_there_is_no_ceiling(values):
    scenario = clpt_package.paper_scenario().with_values({"run.duration": 60, **values})
    assert gramian(scenario, 20.0, 20.0).ceilings == {}


@pytest.mark.parametrize("rough", [regressor.ROUGH, 1e6])  # then each has its own pieces
def test_the_pooled_gramian_is_the_sum_with_gains_of_their_own(rough, monkeypatch):
    monkeypatch.setattr(regressor, "ROUGH", rough)
    of = team(0.0, ROW, **DIFFERENT)  # uncoupled, each as its own scenario runs
    N, window, start = 3, 6.0, 2.0
    found = clpt_package.theory.gramian(of, window, start)
    assert found.names["x1"][N:] == [f"{g}_1 of {v}" for v in "abc" for g in ("K", "Gamma")]
    for axis in ("x1", "x2"):
        whole = np.zeros((N + 6, N + 6))
        for k, scenario in enumerate(of.members.values()):
            own = clpt_package.theory.gramian(scenario, window, start).gramians[axis]
            at = [*range(N), N + 2 * k, N + 2 * k + 1]
            whole[np.ix_(at, at)] += own
        np.testing.assert_allclose(found.gramians[axis], whole, rtol=0, atol=1e-6)
    run = clpt_package.simulate(of, np.arange(0.0, 12.01, 0.05))
    read = clpt_package.theory.gramian(run, window, start)
    assert read.smallest == pytest.approx(found.smallest, rel=1e-2)
    for name, one in read.vehicles.items():
        assert one.smallest == pytest.approx(found.vehicles[name].smallest, rel=1e-2)


@pytest.mark.parametrize(
    ("source", "arguments", "said"),
    [
        (3, (), "must be a Scenario, a Team, an xarray.Dataset or a Regressor"),
        (team(a=vehicle(), b=vehicle()), (50.0,), "window 50 from 0: must be positive and lie"),
        (team(a=vehicle(), b=vehicle()), (-1.0, 0.0), "window -1 from 0: must be positive"),
    ],
    ids=["number", "too long", "negative"],
)
def test_what_has_no_pooled_gramian(source, arguments, said):
    with pytest.raises(clpt_package.ClptError, match=said):
        clpt_package.theory.gramian(source, *arguments)


def test_the_certificate_of_one_vehicle_takes_no_team():
    of = team(a=vehicle(), b=vehicle())
    with pytest.raises(clpt_package.ArgumentError, match="a Team: must be a Scenario"):
        clpt_package.theory.certificate(of)
    with pytest.raises(clpt_package.DataError, match="gramian measures a team"):
        clpt_package.theory.certificate(clpt_package.simulate(of, [0.0, 1.0, 2.0]))
