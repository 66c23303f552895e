"""Teams, laws, designs and estimates on the command line."""

import json
import re

import numpy as np
import pytest
from pictures import inked
from strait import FILE, team, vehicle

import clpt_control
from clpt_control.blocks.laws.table import LAWS
from clpt_control.files import write_file
from clpt_control.scenario.team import team_to_text
from clpt_control.theory.proving.theorem_loop import AT_FIXES


@pytest.fixture
def file(tmp_path):
    of = team(a=vehicle(), b=vehicle(reference_radius=2.0))
    write_file(tmp_path / "team.toml", team_to_text(of))
    return tmp_path / "team.toml"


def test_a_team_runs_and_runs_again(clpt, printed, tmp_path, file):
    out, figures = tmp_path / "run.nc", tmp_path / "figures"
    outcome = clpt("run", file, "--out", out, "--figures", figures)
    assert outcome.status == 0, outcome.err
    assert re.search(
        r"b: largest flow parameter error \(m/s\) +│ [-.\de]+ at t = 12 s", outcome.out
    )
    assert (figures / "team.png").stat().st_size > 10_000
    found = printed("run", out, "--out", tmp_path / "again.nc")
    assert found == printed("run", file, "--out", out)
    assert found["vehicles"] == ["a", "b"]
    run = clpt_control.load_run(out)
    last = abs(run.flow_parameters_estimate - run.flow_parameters)[:, -1].max(("axis", "basis"))
    for name in "ab":
        assert found["max_flow_parameter_error"][name]["12"] == float(last.sel(vehicle=name))
    assert list(found["max_disagreement"]) == ["10", "12"]


def test_the_excitation_of_a_team(clpt, printed):
    found = printed("excitation", FILE, "--window", 300, "--start", 0)
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
def test_what_takes_no_team_says_so(refused, tmp_path, monkeypatch, arguments):
    monkeypatch.chdir(tmp_path)
    assert "team" in refused(arguments[0], FILE, *arguments[1:])


def test_the_example_draws_what_it_says(tmp_path, capsys):
    from examples.team import main

    main(tmp_path / "team.png")
    said = capsys.readouterr().out
    assert "west alone: smallest eigenvalue" in said
    assert "the team: smallest eigenvalue" in said
    assert (tmp_path / "team.png").stat().st_size > 10_000


def test_laws_are_listed(clpt, printed):
    outcome = clpt("laws")
    assert outcome.status == 0
    assert all(name in outcome.out for name in LAWS)
    listed = printed("laws")["laws"]
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


def test_a_law_given_in_python_is_run_again_from_its_record(clpt, tmp_path):
    from law_blocks import papers_law

    scenario = clpt_control.paper_scenario().with_values({"run.duration": 20})
    run = clpt_control.simulate(clpt_control.closed_loop(scenario, law=papers_law()))
    clpt_control.save_run(run, tmp_path / "run.nc")
    words = ("--out", tmp_path / "again.nc", "--figures", tmp_path / "f", "--json")
    outcome = clpt("run", tmp_path / "run.nc", *words)
    assert outcome.status == 0, outcome.err
    assert "position axis 1 (m)" in json.loads(outcome.out)["signals"]
    assert len(list((tmp_path / "f").glob("figure?.png"))) == 4  # as its scenario's run
    assert clpt_control.load_run(tmp_path / "again.nc").equals(run)


QUICK = ("--generations", "1", "--window", "60", "--start", "60", "--for", "kappa")


@pytest.fixture
def paper(tmp_path, monkeypatch):
    monkeypatch.setattr("clpt_control.theory.designing.search.CLIMBS", 5)
    file = tmp_path / "paper.toml"
    scenario = clpt_control.paper_scenario().with_values({"run.duration": 200})
    clpt_control.save_scenario(scenario, file)
    return file


def test_excitation_finds_the_eigenvalue_of_the_design(printed, paper, tmp_path):
    new, picture = tmp_path / "new.toml", tmp_path / "new.png"
    report = printed("design", paper, "--out", new, "--figure", picture, *QUICK)
    assert inked(picture) > 0.01
    made = clpt_control.load_scenario(new)
    assert made.reference.kind == "waypoints"
    assert made.waypoints.tolist() == report["after"]["waypoints"]
    for file, key in ((paper, "before"), (new, "after")):
        found = printed("excitation", file, "--window", "60", "--start", "60")
        values = found["eigenvalues"].values()
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
def test_a_mistake_is_one_sentence(refused, paper, tmp_path, words, said, monkeypatch):
    monkeypatch.chdir(tmp_path)
    out = () if "--out" in words else ("--out", tmp_path / "new.toml")
    assert said in refused("design", paper, *out, *words)
    assert not (tmp_path / "new.toml").exists()


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


def test_mistakes_are_one_sentence(clpt, refused, run, tmp_path):
    clpt_control.save_scenario(PAPER, tmp_path / "paper.toml")
    for arguments, said in (
        ((run, "--method", "guess"), "--method guess: must be one of least-squares"),
        ((run, "--every", 0), "every = 0: must be positive"),
        ((run, "--until", 900), "--until 900: must lie within the run"),
        ((run, "--prior", -1), "prior: must be a positive number"),
        ((tmp_path / "paper.toml",), "is no run; `clpt run"),
        ((tmp_path / "none.nc",), "none.nc"),
    ):
        assert said in refused("estimate", *arguments, "--out", tmp_path / "out.toml")
        assert not (tmp_path / "out.toml").exists()
    before = run.read_bytes()
    outcome = clpt("estimate", run, "--out", run)
    assert (outcome.status, run.read_bytes() == before) == (2, True)
    assert "a scenario's name must end in .toml" in outcome.err


@pytest.mark.parametrize("method", ["least-squares", "kalman", "tomography"])
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--every", "1e-300"), "every = 1e-300: more than 100,000 fixes in the run"),
        (("--noise", "1e-320"), "give a smaller prior or more noise"),
    ],
    ids=str,
)
def test_numbers_that_no_estimate_can_have_are_one_sentence(refused, run, method, words, said):
    assert said in refused("estimate", run, "--method", method, "--json", *words)


@pytest.mark.parametrize("words", [("--prior", "1e150"), ("--noise", "1e-150")], ids=str)
def test_a_prior_that_says_nothing_leaves_what_the_fixes_say(printed, run, words):
    found = printed("estimate", run, *words)
    np.testing.assert_allclose(found["theta"], THETA, rtol=0.05)
    assert all(0 <= sd < 1 for sd in found["standard_deviation"])


# --- certificates ------------------------------------------------------------------------------


@pytest.fixture
def short(tmp_path):
    file = tmp_path / "paper.toml"
    scenario = clpt_control.paper_scenario().with_values({"run.duration": 400})
    clpt_control.save_scenario(scenario, file)
    return file


def test_the_command_says_what_the_function_finds(clpt, printed, short):
    words = ("certify", short, "--radius", "0.05", "--error", "0.3")
    found = clpt_control.certify(clpt_control.load_scenario(short), 0.05, error=0.3)
    report = printed(*words)
    assert report["V"] == pytest.approx(found.V.tolist())
    assert report["time_to_error"] == 200.0
    table = " ".join(clpt(*words).out.split())
    assert "CLPE is at most 0.3 m after 200 s" in table
    assert "For every start with V(0) <= 0.05, windows of 200 s" in table


def test_a_disturbance_has_its_end_and_a_mistake_one_sentence(clpt, short):
    pushed = clpt_control.load_scenario(short).with_values(
        {"flow.disturbance": {"kind": "constant", "amplitude": [0.003, 0.004]}}
    )
    clpt_control.save_scenario(pushed, short)
    said = " ".join(clpt("certify", short, "--radius", "0.05").out.split())
    assert "with |Delta| <= 0.005 m/s it ends at most at" in said
    assert re.search("CLPE is never above .* m, within the run", said)
    outcome = clpt("certify", short, "--radius", "-1")
    assert outcome.status == 2
    assert outcome.err == "clpt: radius = -1: must be a positive number\n"
