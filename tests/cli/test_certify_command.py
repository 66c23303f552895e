"""`clpt certify`: the numbers of `clpt.certify`, as a table and as JSON."""

import json

import pytest

import clpt_control


@pytest.fixture
def paper(tmp_path):
    file = tmp_path / "paper.toml"
    scenario = clpt_control.paper_scenario().with_values({"run.duration": 400})
    clpt_control.save_scenario(scenario, file)
    return file


def test_the_command_says_what_the_function_finds(clpt, paper):
    words = ("certify", paper, "--radius", "0.05", "--error", "0.3")
    found = clpt_control.certify(clpt_control.load_scenario(paper), 0.05, error=0.3)
    outcome = clpt(*words, "--json")
    assert outcome.status == 0, outcome.err
    report = json.loads(outcome.out)
    assert report["V"] == pytest.approx(found.V.tolist())
    assert report["time_to_error"] == 200.0
    table = " ".join(clpt(*words).out.split())
    assert "CLPE is at most 0.3 m after 200 s" in table
    assert "For every start with V(0) <= 0.05, windows of 200 s" in table


def test_a_disturbance_has_its_end_and_a_mistake_one_sentence(clpt, paper):
    pushed = clpt_control.load_scenario(paper).with_values(
        {"flow.disturbance": {"kind": "constant", "amplitude": [0.003, 0.004]}}
    )
    clpt_control.save_scenario(pushed, paper)
    said = " ".join(clpt("certify", paper, "--radius", "0.05").out.split())
    assert "with |Delta| <= 0.005 m/s it ends at most at" in said
    outcome = clpt("certify", paper, "--radius", "-1")
    assert outcome.status == 2
    assert outcome.err == "clpt: radius = -1: must be a positive number\n"
