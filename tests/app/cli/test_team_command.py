"""Teams, laws, designs and estimates on the command line."""

import re
from pathlib import Path

import numpy as np
import pytest
from image_checks import inked
from law_blocks import off
from team_scenarios import FILE, team, vehicle, write_team

import clpt_control
from examples import team as example


@pytest.mark.long
def test_a_team_runs_and_runs_again(clpt, printed):
    file = Path("team.toml")
    write_team(file, team(a=vehicle(), b=vehicle(reference_radius=2.0)))
    words = ("run", "team.toml", "--out", "run.nc")
    out = clpt(*words, "--figures", "figures").out
    assert re.search(
        r"b: largest flow parameter error \(m/s\) +│ [-.\de]+ at t = 12", out
    )
    assert inked("figures/team.png") > 0.01
    found = printed("run", "run.nc", "--out", "again.nc")
    assert (found, found["vehicles"]) == (printed(*words), ["a", "b"])
    last = off(clpt_control.load_run("run.nc"))[:, -1].values
    assert [
        found["max_flow_parameter_error"][name]["12"] for name in "ab"
    ] == last.tolist()
    assert list(found["max_disagreement"]) == ["10", "12"]


@pytest.mark.long
def test_the_excitation_of_a_team(clpt, printed):
    found = printed("excitation", FILE, "--window", 300, "--start", 0)
    west, east, both = (found["smallest"][name] for name in ("west", "east", "team"))
    assert max(west, east) < 1e-6 < 1 < both
    assert found["team"]["dimension"] == {"x1": 6, "x2": 6}
    assert "which all share" in found["measured"]
    shown = clpt("excitation", FILE, "--window", 300, "--start", 0).out
    assert "west alone: theta_1[5] is not learnable on this track" in shown
    assert "the team:" not in shown


def test_what_takes_no_team_says_so(refused_for):
    refused_for(["team"], "export", FILE, "--drawing")
    refused_for(["team"], "excitation", FILE, "--figure", "x.png")


@pytest.mark.long
def test_the_example_draws_what_it_says(capsys):
    example.main(Path("team.png"))
    said = capsys.readouterr().out
    assert all(
        f"{who}: smallest eigenvalue" in said for who in ("west alone", "the team")
    )
    assert Path("team.png").stat().st_size > 10_000


QUICK = ("--window", "60", "--start", "60", "--for", "kappa")


@pytest.fixture
def paper():
    scenario = clpt_control.paper_scenario().with_values({"run.duration": 200})
    clpt_control.save_scenario(scenario, "paper.toml")


@pytest.mark.long
@pytest.mark.usefixtures("paper")
def test_excitation_finds_the_eigenvalue_of_the_design(printed):
    report = printed(
        "tune",
        "paper.toml",
        "--waypoints",
        "--out",
        "new.toml",
        "--figure",
        "new.png",
        *QUICK,
    )
    assert inked("new.png") > 0.01
    made = clpt_control.load_scenario("new.toml")
    assert made.reference.kind == "waypoints"
    assert made.waypoints.tolist() == report["after"]["waypoints"]
    for file, key in (("paper.toml", "before"), ("new.toml", "after")):
        found = printed("excitation", file, "--window", "60", "--start", "60")[
            "eigenvalues"
        ]
        assert min(found.values())[0] == pytest.approx(
            report[key]["of_the_run"], rel=1e-9
        )


@pytest.mark.usefixtures("paper")
def test_a_mistake_is_one_sentence(refused_for):
    for said, *words in (
        ("length = -1.0: must be a number, positive and finite", "--length", "-1"),
        ("with vehicle.position in it", *("--area", "1", "2", "1", "2")),
        ("must end in .png, .pdf or .svg", "--figure", "new.gif"),
        ("must end in .toml", "--out", "new.nc"),
    ):
        refused_for(
            [said], "tune", "paper.toml", "--waypoints", "--out", "new.toml", *words
        )
    refused_for(["--area: is of --waypoints"], "tune", "paper.toml", "--area", *"0101")


PAPER = clpt_control.paper_scenario()
THETA = np.array(PAPER.flow.parameters)


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    file = tmp_path_factory.mktemp("run") / "run.nc"
    short = PAPER.with_values({"run.duration": 240, "run.output_step": 0.5})
    clpt_control.save_run(clpt_control.simulate(short), file)
    return file


@pytest.mark.long
@pytest.mark.parametrize("method", ["kalman", "tomography"])
def test_a_run_gives_a_scenario_with_the_flow_known(clpt, printed, run, method):
    found = printed(
        "estimate", run, "--method", method, "--until", 200, "--out", "known.toml"
    )
    theta = np.array(found["theta_m_s"])
    assert (len(found["legs"]), found["method"]) == (100, method)
    np.testing.assert_allclose(theta, THETA, rtol=0.01)
    assert found["largest_error_m_s"] == pytest.approx(np.abs(theta - THETA).max())
    fed = clpt_control.load_scenario("known.toml").learning
    assert fed.law == "known-flow"
    np.testing.assert_allclose(fed.theta_estimate, theta, rtol=1e-12)
    assert clpt("run", "known.toml", "--out", "again.nc").status == 0


@pytest.mark.long
def test_the_table_is_printed(clpt, run):
    words = "--every", 20, "--results", "learned.nc"
    out = " ".join(clpt("estimate", run, *words).out.split())
    end = r"largest error: \S+ m/s \d+ of 12 fixes inside"
    assert re.search(rf"law fix-regression, kalman.*standard error \(m/s\).*{end}", out)
    assert clpt("report", "learned.nc", "-o", "learned.html").status == 0


def test_mistakes_are_one_sentence(refused_for, run):
    clpt_control.save_scenario(PAPER, "paper.toml")
    before = run.read_bytes()
    for said, *words in (
        ("method 'guess': must be one of kalman, tomography", run, "--method", "guess"),
        ("every = 0: must be positive", run, "--every", 0),
        (
            "every = 1e-300: must be positive, at most the run's length",
            run,
            "--every",
            "1e-300",
        ),
        ("--until 900: must lie within the run", run, "--until", 900),
        ("prior = -1: must be a positive number", run, "--prior", -1),
        ("noise = 9.99989e-321: must be", run, "--noise", "1e-320"),
        *(
            ("is a scenario, not fixes or a run. Give: clpt estimate", "paper.toml"),
            ("none.nc", "none.nc"),
            ("--shear -1: must be above 0", "--sample", "--shear", "-1"),
        ),
        ("a scenario's name must end in .toml", run, "--out", run),
    ):
        refused_for([said], "estimate", *words)
    assert run.read_bytes() == before


@pytest.mark.long
def test_a_prior_that_says_nothing_leaves_what_the_fixes_say(printed, run):
    for words in (("--prior", "30"), ("--noise", "1e-6")):
        found = printed("estimate", run, *words)
        np.testing.assert_allclose(found["theta_m_s"], THETA, rtol=0.05)
        assert all(0 <= sd < 1 for sd in found["standard_error_m_s"])


# --- certificates ------------------------------------------------------------------------------


SHORT = PAPER.with_values({"run.duration": 400})


def test_the_command_says_what_the_function_finds(clpt, printed):
    clpt_control.save_scenario(SHORT, "paper.toml")
    words = (
        "excitation",
        "paper.toml",
        "--bounds",
        "--radius",
        "0.05",
        "--error",
        "0.3",
    )
    found, report = clpt_control.certify(SHORT, 0.05, error=0.3), printed(*words)
    assert report["V"] == pytest.approx(found.V.tolist())
    assert report["time_to_error"] == 200.0
    table = " ".join(clpt(*words).out.split())
    for said in (
        "CLPE is at most 0.3 m after 200 s",
        "start with V(0) <= 0.05, windows of 200 s",
    ):
        assert said in table


LINE = """
basis = {kernel = "gaussian", centers = [[0, 3], [0, -3]], widths = [4, 4], periods = [inf, inf]}
flow.parameters = [[0.5, 0.1], [0.2, -0.2]]
reference = {kind = "waypoints", points = [[-4, 0], [4, 0]], dwell = 20}
vehicle = {feedback = [1, 1], feedforward = [1, 1], position = [0, 0]}
run.duration = 400
[learning]
law = "learned-flow"
gain = 0.8
adapt_gains = false
feedback = [1, 1]
feedforward = [1, 1]
"""


@pytest.mark.long
def test_a_straight_track_prints_no_zero_parts_and_no_equal_rows(clpt):
    """On the line x2 = 0 the gain Gamma of x2 shows nothing, and no bound falls."""
    Path("line.toml").write_text(LINE)
    table = clpt("excitation", "line.toml").out
    assert "+0.00" not in table
    assert "-0.00" not in table
    rows = clpt("excitation", "line.toml", "--bounds").out.splitlines()
    bounds = [row.split("│")[2:5] for row in rows if row.startswith("│")]
    assert len(bounds) == 1


def test_a_disturbance_has_its_end_and_a_mistake_one_sentence(clpt, refused_for):
    push = {"flow.disturbance": {"kind": "constant", "amplitude": [0.001, 0.002]}}
    clpt_control.save_scenario(SHORT.with_values(push), "paper.toml")
    said = " ".join(
        clpt("excitation", "paper.toml", "--bounds", "--radius", "0.05").out.split()
    )
    # sqrt(5e-6) = 0.00223607, rounded up
    assert "with |Delta| <= 0.002237 m/s it ends at most at" in said
    assert re.search("CLPE is never above .* m, within the run", said)
    said = "radius = -1.0: must be a number, positive and finite"
    refused_for([said], "excitation", "paper.toml", "--bounds", "--radius", "-1")
