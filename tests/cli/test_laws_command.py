"""`clpt laws`, and `clpt run` of laws."""

import json

import pytest

import clpt_control
from clpt_control.blocks.laws.table import LAWS
from clpt_control.theory.proving.theorem_loop import AT_FIXES


def test_laws_are_listed(clpt):
    outcome = clpt("laws")
    assert outcome.status == 0
    assert all(name in outcome.out for name in LAWS)
    listed = json.loads(clpt("laws", "--json").out)["laws"]
    assert list(listed) == list(LAWS)
    for name, law in LAWS.items():
        assert listed[name]["promise"] == law.promise
        assert list(listed[name]["settings"]) == list(law.settings)


@pytest.mark.parametrize("name", ["known-flow", "least-squares", "fix-regression"])
def test_a_law_runs_and_runs_again(clpt, tmp_path, name):
    given = LAWS[name].given_estimate
    values = {
        "run.duration": 40,
        "learning.law": name,
        "learning.parameters": None,
        "learning.theta_estimate": [[1.0, 0.4, 0.8]] * 2 if given else None,
        **(AT_FIXES if LAWS[name].at_fixes else {}),
    }
    scenario = clpt_control.paper_scenario().with_values(values)
    clpt_control.save_scenario(scenario, tmp_path / "mine.toml")
    outcome = clpt("run", tmp_path / "mine.toml", "--out", tmp_path / "run.nc", "--json")
    assert outcome.status == 0, outcome.err
    again = clpt("run", tmp_path / "run.nc", "--out", tmp_path / "again.nc", "--json")
    assert json.loads(again.out) == json.loads(outcome.out)


def test_a_law_given_in_python_is_not_run_again(clpt, tmp_path):
    from law_blocks import papers_law

    scenario = clpt_control.paper_scenario().with_values({"run.duration": 20})
    clpt_control.save_run(
        clpt_control.simulate(clpt_control.closed_loop(scenario, law=papers_law())),
        tmp_path / "run.nc",
    )
    outcome = clpt("run", tmp_path / "run.nc", "--out", tmp_path / "again.nc")
    assert outcome.status == 2
    assert "was run with a law given in Python, mine" in outcome.err
    assert outcome.err.count("\n") == 1
