"""`clpt estimate`: theta from a run, and the scenario that it feeds."""

import json

import numpy as np
import pytest

import clpt_control

PAPER = clpt_control.paper_scenario()
THETA = np.array(PAPER.flow.parameters)


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    file = tmp_path_factory.mktemp("run") / "run.nc"
    values = {"run.duration": 240, "run.output_step": 0.5}
    clpt_control.save_run(clpt_control.simulate(PAPER.with_values(values)), file)
    return file


@pytest.mark.parametrize("method", ["least-squares", "kalman", "tomography"])
def test_a_run_gives_a_scenario_with_the_flow_known(clpt, run, tmp_path, method):
    options = ("--method", method, "--until", 200, "--out", tmp_path / "known.toml", "--json")
    outcome = clpt("estimate", run, *options)
    assert outcome.status == 0, outcome.err
    found = json.loads(outcome.out)
    assert found["fixes"] == 101
    np.testing.assert_allclose(found["theta"], THETA, rtol=0.05)
    error = np.abs(np.array(found["theta"]) - THETA).max()
    assert found["largest_error"] == pytest.approx(error)
    fed = clpt_control.load_scenario(tmp_path / "known.toml")
    assert fed.learning.law == "known-flow"
    np.testing.assert_array_equal(fed.learning.theta_estimate, found["theta"])
    again = clpt("run", tmp_path / "known.toml", "--out", tmp_path / "again.nc")
    assert again.status == 0, again.err


def test_the_table_is_printed(clpt, run):
    outcome = clpt("estimate", run, "--every", 20)
    assert outcome.status == 0
    assert "13 fixes" in " ".join(outcome.out.split())
    assert "condition number: " in outcome.out


def test_mistakes_are_one_sentence(clpt, run, tmp_path):
    clpt_control.save_scenario(PAPER, tmp_path / "paper.toml")
    for arguments, said in (
        ((run, "--method", "guess"), "--method guess: must be one of least-squares"),
        ((run, "--every", 0), "every = 0: must be positive"),
        ((run, "--until", 900), "--until 900: must lie within the run"),
        ((run, "--prior", -1), "prior: must be a positive number"),
        ((tmp_path / "paper.toml",), "is no run; `clpt run"),
        ((tmp_path / "none.nc",), "none.nc"),
    ):
        outcome = clpt("estimate", *arguments, "--out", tmp_path / "out.toml")
        assert outcome.status == 2, outcome
        assert said in outcome.err
        assert outcome.err.count("\n") == 1
        assert not (tmp_path / "out.toml").exists()


@pytest.mark.parametrize("method", ["least-squares", "kalman", "tomography"])
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--every", "1e-300"), "every = 1e-300: more than 100,000 fixes in the run"),
        (("--noise", "1e-320"), "give a smaller prior or more noise"),
    ],
    ids=str,
)
def test_numbers_that_no_estimate_can_have_are_one_sentence(clpt, run, method, words, said):
    outcome = clpt("estimate", run, "--method", method, "--json", *words)
    assert outcome.status == 2, outcome
    assert said in outcome.err
    assert outcome.err.count("\n") == 1


@pytest.mark.parametrize("words", [("--prior", "1e150"), ("--noise", "1e-150")], ids=str)
def test_a_prior_that_says_nothing_leaves_what_the_fixes_say(clpt, run, words):
    found = json.loads(clpt("estimate", run, "--json", *words).out)
    np.testing.assert_allclose(found["theta"], THETA, rtol=0.05)
    assert all(0 <= sd < 1 for sd in found["standard_deviation"])


def reversed_in_time(run):
    return run.isel(time=slice(None, None, -1))


def without_waypoints(run):
    return run.drop_vars("reference")


def with_a_gap_in_the_waypoints(run):
    return run.assign(reference=run.reference.where(run.time > 3))


def twice_at_one_time(run):
    return run.isel(time=[0, 0, 1, 2])


def of_one_sample(run):
    return run.isel(time=[0])


def of_another_scenario(run):
    return run.assign_attrs(scenario=3.0)


@pytest.mark.parametrize(
    ("damage", "said"),
    [
        (of_one_sample, "the run has fewer than two samples"),
        (of_another_scenario, "the run carries no scenario"),
        (reversed_in_time, "its times do not increase"),
        (twice_at_one_time, "its times do not increase"),
        (without_waypoints, "the run has no whole reference"),
        (with_a_gap_in_the_waypoints, "the run has no whole reference"),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_a_damaged_run_is_one_sentence(clpt, run, tmp_path, damage, said):
    import xarray

    with xarray.open_dataset(run) as data:
        damage(data.load()).to_netcdf(tmp_path / "bad.nc")
    outcome = clpt("estimate", tmp_path / "bad.nc", "--json")
    assert outcome.status == 2, outcome
    assert said in outcome.err
    assert outcome.err.count("\n") == 1
