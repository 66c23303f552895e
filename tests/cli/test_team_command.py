"""A team on the command line: run, run again, excitation; what takes no team says so."""

import json
import re

import pytest
from strait import FILE, team, vehicle

import clpt_control
from clpt_control.files import write_text
from clpt_control.scenario.team import team_to_text


@pytest.fixture
def file(tmp_path):
    of = team(a=vehicle(), b=vehicle(reference_radius=2.0))
    write_text(tmp_path / "team.toml", team_to_text(of))
    return tmp_path / "team.toml"


def test_a_team_runs_and_runs_again(clpt, tmp_path, file):
    out, figures = tmp_path / "run.nc", tmp_path / "figures"
    outcome = clpt("run", file, "--out", out, "--figures", figures)
    assert outcome.status == 0, outcome.err
    assert re.search(r"b: largest flow parameter error +│ [-.\de]+ at t = 12 s", outcome.out)
    assert (figures / "team.png").stat().st_size > 10_000
    found = json.loads(clpt("run", out, "--out", tmp_path / "again.nc", "--json").out)
    assert found == json.loads(clpt("run", file, "--out", out, "--json").out)
    assert found["vehicles"] == ["a", "b"]
    run = clpt_control.load_run(out)
    last = abs(run.flow_parameters_estimate - run.flow_parameters)[:, -1].max(("axis", "basis"))
    for name in "ab":
        assert found["max_flow_parameter_error"][name]["12"] == float(last.sel(vehicle=name))
    assert list(found["max_disagreement"]) == ["10", "12"]


def test_the_excitation_of_a_team(clpt):
    outcome = clpt("excitation", FILE, "--window", 300, "--start", 0, "--json")
    found = json.loads(outcome.out)
    assert found["smallest"]["west"] < 1e-6 > found["smallest"]["east"]
    assert found["smallest"]["team"] > 1
    assert found["team"]["dimension"] == {"x1": 6, "x2": 6}
    assert "held" in found["measured"]
    shown = clpt("excitation", FILE, "--window", 300, "--start", 0)
    assert "west alone: theta_1[5] is not learnable on this track" in shown.out
    assert "the team:" not in shown.out


@pytest.mark.parametrize(
    "arguments",
    [
        ("diagram",),
        ("ensemble", "--members", "3", "--vary", "learning.gain=1:2", "--out", "e.zarr"),
        ("excitation", "--figure", "x.png"),
    ],
    ids=lambda arguments: arguments[0],
)
def test_what_takes_no_team_says_so(clpt, tmp_path, monkeypatch, arguments):
    monkeypatch.chdir(tmp_path)
    outcome = clpt(arguments[0], FILE, *arguments[1:])
    assert outcome.status == 2
    assert "team" in outcome.err
    assert outcome.err.count("\n") == 1


def test_the_example_draws_what_it_says(tmp_path, capsys):
    from examples.team import main

    main(tmp_path / "team.png")
    said = capsys.readouterr().out
    assert "west alone: smallest eigenvalue" in said
    assert "the team: smallest eigenvalue" in said
    assert (tmp_path / "team.png").stat().st_size > 10_000
