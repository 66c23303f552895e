"""`clpt design`: a scenario and a picture are written, and `clpt excitation` finds the same."""

import json

import pytest
from pictures import inked

import clpt_control

QUICK = ("--generations", "1", "--window", "60", "--start", "60", "--for", "kappa")


@pytest.fixture
def paper(tmp_path, monkeypatch):
    monkeypatch.setattr("clpt_control.theory.designing.search.CLIMBS", 5)
    file = tmp_path / "paper.toml"
    scenario = clpt_control.paper_scenario().with_values({"run.duration": 200})
    clpt_control.save_scenario(scenario, file)
    return file


def test_excitation_finds_the_eigenvalue_of_the_design(clpt, paper, tmp_path):
    new, picture = tmp_path / "new.toml", tmp_path / "new.png"
    outcome = clpt("design", paper, "--out", new, "--figure", picture, "--json", *QUICK)
    assert outcome.status == 0, outcome.err
    report = json.loads(outcome.out)
    assert inked(picture) > 0.01
    made = clpt_control.load_scenario(new)
    assert made.reference.kind == "waypoints"
    assert made.waypoints.tolist() == report["after"]["waypoints"]
    for file, key in ((paper, "before"), (new, "after")):
        found = clpt("excitation", file, "--window", "60", "--start", "60", "--json")
        values = json.loads(found.out)["eigenvalues"].values()
        assert min(v[0] for v in values) == pytest.approx(report[key]["of_the_run"], rel=1e-9)


@pytest.mark.slow
def test_the_table_says_what_was_reached(clpt, paper, tmp_path):
    outcome = clpt("design", paper, "--out", tmp_path / "new.toml", *QUICK)
    assert outcome.status == 0, outcome.err
    for part in ("before", "after", "smallest eigenvalue", "learning time", "closed length"):
        assert part in outcome.out
    assert outcome.err == ""


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--length", "-1"), "length = -1: must be a positive number of m"),
        (("--area", "1", "2", "1", "2"), "the vehicle starts outside of it"),
        (("--figure", "new.gif"), "must end in .png, .pdf or .svg"),
        (("--out", "new.nc"), "must end in .toml"),
    ],
    ids=str,
)
def test_a_mistake_is_one_sentence(clpt, paper, tmp_path, words, said, monkeypatch):
    monkeypatch.chdir(tmp_path)
    out = () if "--out" in words else ("--out", tmp_path / "new.toml")
    outcome = clpt("design", paper, *out, *words)
    assert outcome.status == 2
    assert said in outcome.err
    assert outcome.err.count("\n") == 1
    assert not (tmp_path / "new.toml").exists()
