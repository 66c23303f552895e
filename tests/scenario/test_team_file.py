"""A team's file: read, written in a run, and each mistake a sentence."""

import numpy as np
import pytest
from strait import DIFFERENT, FILE, PAPER, ROW, team, vehicle

import clpt_control as clpt
from clpt_control.scenario.team import team_from_text, team_to_text

TEXT = FILE.read_text()
EDGES, OWN = '[["west", "east"]]', "vehicle.position = [11, 0]"


def test_the_example_says_what_it_says():
    of = clpt.load_team(FILE)
    assert list(of.members) == ["west", "east"]
    assert of.edges == (("west", "east"),)
    assert of.members["west"].vehicle.position == (-11.0, 0.0)
    assert of.members["west"].vehicle.feedback == of.members["east"].vehicle.feedback
    assert of.members["east"].reference.points[0] == (15.0, -2.0)
    assert of.connectivity == pytest.approx(2.0)


def titled():
    """Vehicles with titles of their own."""
    named = {"title": "one"}
    return team(a=vehicle(**named), b=vehicle(title="two"), c=vehicle(title=""), d=vehicle(**named))


@pytest.mark.parametrize("of", [team(0.25, ROW, **DIFFERENT), clpt.load_team(FILE), titled()])
def test_a_team_comes_back_from_its_text(of, tmp_path):
    back = team_from_text(team_to_text(of), "mine", tmp_path)
    assert back == of
    assert [one.title for one in back.members.values()] == [m.title for m in of.members.values()]


def test_a_team_comes_back_from_its_run(tmp_path):
    of = team(0.25, ROW, **DIFFERENT)
    run = clpt.simulate(of, [0.0, 1.0])
    clpt.save_run(run, tmp_path / "run.nc")
    assert clpt.load_team(tmp_path / "run.nc") == of
    again = clpt.load_run(tmp_path / "run.nc")
    np.testing.assert_array_equal(again.alpha, run.alpha)
    assert list(again.vehicle.values) == ["a", "b", "c"]
    with pytest.raises(clpt.ClptError, match="it is a team's"):
        clpt.load_scenario(tmp_path / "run.nc")


def test_each_vehicle_has_its_own_noise():
    noisy = [
        vehicle(localization={"noise": 0.02, "noise_period": 0.5, "seed": seed}) for seed in (1, 2)
    ]
    of = team(a=noisy[0], b=noisy[1], c=PAPER)
    assert team_from_text(team_to_text(of), "mine", FILE.parent) == of
    run = clpt.simulate(of, [0.0, 1.0])
    noise = (run.measured_position - run.position).values
    assert abs(noise[0] - noise[1]).max() > 1e-3
    assert abs(noise[2]).max() == 0
    with pytest.raises(clpt.ScenarioError, match=r"members.b: localization.seed = 1 is that of a"):
        team(a=noisy[0], b=noisy[0])


def test_left_out_edges_join_all():
    assert team(a=PAPER, b=PAPER, c=PAPER).edges == (("a", "b"), ("a", "c"), ("b", "c"))


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("coupling = 0.5", "", "mine, team: missing key coupling"),
        ("coupling = 0.5", "coupling = -1", "team: coupling = -1: must be greater than or equal"),
        ("coupling = 0.5", "coupling = nan", "team: coupling = nan: must be a finite number"),
        ("coupling = 0.5", "couplng = 0.5", "unknown key couplng; did you mean coupling"),
        ('"east"]]', '"est"]]', r"edges\[0\]: there is no vehicle 'est'; must be among west, east"),
        ('"east"]]', '"west"]]', r"edges\[0\] = \['west', 'west'\]: must join two vehicles"),
        ('"east"]]', '"east"], ["east", "west"]]', r"edges\[1\] = .*: must join two .* each pair"),
        (EDGES, "[]", "edges: no path joins all vehicles"),
        (EDGES, '["west"]', r"edges\[0\] = 'west': must be a list"),
        (EDGES, '[["west"]]', r"missing key edges\[0\]\[1\]"),
        ("[team.members.west]", '[team.members."we st"]', "the name 'we st' of a vehicle must be"),
        (OWN, "run.duration = 7.0", "members.east: its run is not that of west"),
        (OWN, "learning.gain = 1", "members.east: its learning is not that of west"),
        (OWN, "vehicle.pos = 1", "east: unknown key vehicle.pos"),
        (OWN, "vehicle = 1", "east: vehicle = 1: must be a table of keys"),
        ("gain = 4.0", "", "west: learning.gain: is required"),
        ('"learned-flow"', '"sigma"', 'learning.law = "sigma": must be "learned-flow"'),
        ("[team]", "[team]\nmembers = 1\n[other]", "team.members = 1: must be a table of keys"),
    ],
    ids=str,
)
def test_each_mistake_is_a_sentence(tmp_path, old, new, said):
    assert old in TEXT
    text = TEXT.replace(old, new)
    if "members = 1" in new:
        text = text.partition("[other]")[0]
    with pytest.raises(clpt.ScenarioError, match=said) as caught:
        team_from_text(text, "mine", tmp_path)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("members", "said"),
    [
        ({"a": PAPER}, "members: has 1 vehicles; must have 2 to 100"),
        (
            {"a": PAPER, "b": vehicle(basis_widths=[5, 5, 4])},
            "members.b: its basis is not that of a",
        ),
        ({"a": PAPER, "b": vehicle(flow_parameters=[[1, 2, 3]] * 2)}, "its flow is not that of a"),
        ({"a": PAPER, "b": vehicle(learning_gain=0.3)}, "its learning is not that of a"),
        ({"a": PAPER, "b": vehicle(run_duration=3)}, "its run is not that of a"),
        ({"a": PAPER, "b": vehicle(units_length="km")}, "its units is not that of a"),
        ({"a": PAPER, "b/c": PAPER}, "the name 'b/c' of a vehicle"),
        ({"a": PAPER, "b": 3}, "members.b = 3"),
        (
            {"a": PAPER, "b": {"run": {"durat": 3.0}}},
            r"key members\.b\.run\.durat; did you mean dur",
        ),
    ],
    ids=str,
)
def test_vehicles_share_one_flow(members, said):
    with pytest.raises(clpt.ScenarioError, match=said) as caught:
        clpt.Team(members=members, coupling=0.5)
    assert "\n" not in str(caught.value)


def test_a_scenario_is_no_team_and_a_team_none(tmp_path):
    clpt.save_scenario(PAPER, tmp_path / "one.toml")
    with pytest.raises(clpt.ScenarioError, match="is a scenario of one vehicle"):
        clpt.load_team(tmp_path / "one.toml")
    with pytest.raises(clpt.ScenarioError, match=r"has a table \[team\].*clpt.load_team"):
        clpt.load_scenario(FILE)
