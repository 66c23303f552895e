"""Every way to make a scenario or a team: a wrong value is a ScenarioError of one sentence."""

import copy
import pickle
import tomllib
from typing import get_args

import numpy as np
import pytest
from law_blocks import EACH
from strait import DIFFERENT, FILE, ROW, team, vehicle
from strait import PAPER as STRAIT

import clpt_control as clpt
from clpt_control.blocks import disturbance, flow
from clpt_control.blocks.laws.table import LAWS
from clpt_control.errors import BlockError, ScenarioError
from clpt_control.scenario.file import scenario_to_text
from clpt_control.scenario.learning import KINDS, Learning
from clpt_control.scenario.quantities import CALL_TIME_NAMES
from clpt_control.scenario.tables import Disturbance, Kernel
from clpt_control.scenario.team import system_from_text, team_to_text
from clpt_control.theory.proving.theorem_loop import AT_FIXES

PAPER = clpt.paper_scenario()
WRONG = {
    "learning.gain = -1: must be": {"learning": {"gain": -1}},
    "unknown key flow.disturbance.perod; did you mean period?": {
        "flow": {"disturbance": {"kind": "sine", "amplitude": [1.0, 0.0], "period": 1, "perod": 2}}
    },
    "adaptation.gain is the name at call time.* key is learning.gain": {"adaptation": {"gain": 2}},
}


def document(changes=()):
    tables = PAPER.model_dump(exclude_none=True, exclude_unset=True)
    for key, value in dict(changes).items():
        whole = not isinstance(value, dict) or key not in tables
        tables[key] = value if whole else {**tables[key], **value}
    return tables


def wait_for_error(make, words):
    with pytest.raises((ScenarioError, clpt.ArgumentError), match=words) as caught:
        make()
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("words", WRONG)
def test_a_wrong_value_is_one_sentence(words):
    tables = document(WRONG[words])
    wait_for_error(lambda: clpt.Scenario(**tables), words)
    wait_for_error(lambda: clpt.Scenario.model_validate(tables), words)
    wait_for_error(lambda: PAPER.with_values(tables), words)


def test_a_table_of_its_own_is_checked_too():
    wait_for_error(lambda: Learning(law="none", gain=1.0), "learning: law = 'none': must be")
    wait_for_error(lambda: clpt.Scenario(basis={}), "missing key basis.kernel .and")
    wait_for_error(lambda: clpt.Scenario.model_validate(3), "3: must be a table of keys")
    wait_for_error(lambda: PAPER.with_values([2]), "must be Mapping")
    other = {"reference.kind": "waypoints"}
    wait_for_error(lambda: PAPER.with_values(other), "missing key reference.points")
    given = PAPER.with_values({**other, "reference.points": [[0, 1]]}).reference
    assert (given.points, given.dwell) == (((0, 1),), PAPER.reference.dwell)
    wait_for_error(lambda: PAPER.with_values({"learning.gain.x": 2}), "gain is no table")


def test_a_right_scenario_is_the_same_by_every_way(tmp_path):
    assert clpt.Scenario(**document()) == PAPER == clpt.Scenario.model_validate(document())
    assert pickle.loads(pickle.dumps(PAPER)) == PAPER == copy.deepcopy(PAPER)
    clpt.save_scenario(PAPER, file := tmp_path / "mine.toml")
    file.write_bytes(b"\xef\xbb\xbf" + file.read_bytes())  # a byte order mark
    assert clpt.load_scenario(file) == PAPER


NOISE = {"kind": "noise", "amplitude": [0.1, 0.0], "period": 2.0}
KNOWN = {"learning.law": "known-flow", "learning.parameters": None}
KNOWN |= {"learning.theta_estimate": [[1, 1, 1]] * 2}


def where_it_is(key):
    """Return what else a scenario has that has a key."""
    if "disturbance" in key:
        return {"flow.disturbance": NOISE}
    if key in ("localization.interval", "localization.latency", "localization.dropouts"):
        return {"learning.law": "fix-regression", **AT_FIXES}
    if "localization" in key:
        return {"localization": {"noise": 0.1, "noise_period": 2.0}}
    if key.startswith("learning.gains."):
        return {"learning.gain": None, "learning.gains": EACH}
    of_key = {"vehicle.max_speed": {"vehicle.max_speed": 1.5}, "learning.theta_estimate": KNOWN}
    return of_key.get(key, {})


@pytest.mark.parametrize("key", CALL_TIME_NAMES)
def test_an_error_about_one_name_says_the_other(key):
    scenario = PAPER.with_values(where_it_is(key))
    loop = clpt.closed_loop(scenario)
    parameters = {
        f"{block.name}.{field}": value
        for block in clpt.paper_blocks(scenario)
        for field, value in block.parameters._asdict().items()
    }
    known = [name for name in CALL_TIME_NAMES[key] if name in parameters]
    assert known
    value = parameters[known[0]]
    held = scenario
    for name in key.split("."):
        held = getattr(held, name)
    if held is not None:  # what the scenario leaves out is zero
        np.testing.assert_allclose(np.reshape(value, np.shape(held)), held)
    if key in known:
        return
    for system, times in ((scenario, None), (loop, [0.0, 1.0])):
        with pytest.raises(BlockError, match=f"{key} is a key of the scenario.*{known[0]}"):
            clpt.simulate(system, times, params={key: value})
    with pytest.raises(ScenarioError, match=f"the scenario's key is (.* or )?{key}"):
        scenario.with_values({known[0]: value})


NONE = {"learning.gain": None}
UNUSED = r"parameters: .* adapts feedback, feedforward here"


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"learning.law": "known"}, r"learning.law = 'known': must be '.*`clpt laws`"),
        (NONE, r"learning.gain: is required by law = \"learned-flow\""),
        ({"learning.gains": EACH}, "learning.gains: give either gain or gains"),
        (
            {**NONE, "learning.gains": {"parameters": 1}},
            "learning.gains.feedback: .* adapts parameters, feedback, feedforward",
        ),
        ({**NONE, "learning.gains.feedback": -1}, "learning.gains.feedback = -1: must be greater"),
        ({**NONE, "learning.gains": {**EACH, "K": 1}}, r"unknown key learning.gains.K.*feedback"),
        ({"learning.adapt_gains": 0}, "learning.adapt_gains = 0: must be a valid boolean"),
        (
            {**NONE, "learning.gains": EACH, "learning.adapt_gains": False},
            "learning.gains.feedback: .* adapts parameters here; .* no other",
        ),
        (
            {"learning.adapt_gains": False, "learning.feedback": None},
            "learning.feedback: is required by .* with adapt_gains = false",
        ),
        ({**KNOWN, **NONE, "learning.gains": EACH}, UNUSED),
        ({"learning.law": "composite-least-squares", **NONE, "learning.gains": EACH}, UNUSED),
    ],
)
def test_a_mistake_is_a_sentence(values, said):
    with pytest.raises(ScenarioError, match=said):
        PAPER.with_values(values)


@pytest.mark.parametrize(
    ("values", "gains"),
    [
        ({}, (0.8, 0.8, 0.8, True)),
        ({**NONE, "learning.gains": EACH}, (0.8, 0.3, 0.5, False)),
        ({"learning.adapt_gains": False}, (0.8, 0.0, 0.0, False)),
        (
            {**NONE, "learning.gains": {"parameters": 2.0}, "learning.adapt_gains": False},
            (2.0, 0.0, 0.0, False),
        ),
        ({**KNOWN, **NONE, "learning.gains": {**EACH, "parameters": None}}, (0, 0.3, 0.5, False)),
    ],
)
def test_gains_are_those_that_adapt(values, gains):
    scenario = PAPER.with_values(values)
    assert scenario.learning.used_gains == gains
    assert clpt.Scenario.model_validate(tomllib.loads(scenario_to_text(scenario))) == scenario


@pytest.mark.parametrize("name", LAWS)
def test_every_row_fits_the_scenario(name):
    law = LAWS[name]
    assert law.name == name
    assert law.promises
    assert law.needs
    assert "\n" not in law.needs
    assert not law.settings or law.table in Learning.model_fields
    for key, one in law.settings.items():
        assert key.isidentifier()
        assert one.allowed in KINDS
        assert one.meaning


@pytest.mark.parametrize("name", [name for name, law in LAWS.items() if law.settings])
def test_a_laws_own_table_is_checked_like_all_else(name):
    law = LAWS[name]
    key, table = next(iter(law.settings)), f"learning.{law.table}"
    with pytest.raises(ScenarioError, match=f"{table}: law = .* has no use for it"):
        PAPER.with_values({table: {}})
    mine = {"learning.law": name, "learning.parameters": None}
    mine |= AT_FIXES if law.at_fixes else {}
    with pytest.raises(ScenarioError, match=f"unknown key {table}.none.*{key}"):
        PAPER.with_values({**mine, f"{table}.none": 1.0})
    with pytest.raises(ScenarioError, match=f"{table}.{key} = 'x': must be"):
        PAPER.with_values({**mine, f"{table}.{key}": "x"})
    assert list(PAPER.with_values(mine).learning.settings) == list(law.settings)


@pytest.mark.parametrize(("key", "value"), [("prior", 1e300), ("noise", 1e-300)])
def test_a_setting_whose_square_is_no_number_is_refused(key, value):
    """Laws square their settings: 1e300 overflows, 1e-300 is a standard deviation of nothing."""
    mine = {"learning.law": "kalman-flow", "learning.parameters": None}
    with pytest.raises(ScenarioError, match=rf"learning.kalman_flow.{key} = .*: must be .* 1e100"):
        PAPER.with_values({**mine, f"learning.kalman_flow.{key}": value})


def test_every_choice_is_made():
    assert set(get_args(Kernel)) == set(flow.KERNELS)
    assert set(get_args(Disturbance.model_fields["kind"].annotation)) == set(disturbance.KINDS)


# --- a team --------------------------------------------------------------------------------------

TEXT = FILE.read_text()
EDGES, OWN = '[["west", "east"]]', "vehicle.position = [11, 0]"


def test_the_example_says_what_it_says():
    of = clpt.load_team(FILE)
    assert (list(of.members), of.edges) == (["west", "east"], (("west", "east"),))
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
    back = system_from_text(team_to_text(of), "mine", tmp_path)
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
    of = team(a=noisy[0], b=noisy[1], c=STRAIT)
    assert system_from_text(team_to_text(of), "mine", FILE.parent) == of
    run = clpt.simulate(of, [0.0, 1.0])
    noise = (run.measured_position - run.position).values
    assert abs(noise[0] - noise[1]).max() > 1e-3
    assert abs(noise[2]).max() == 0
    with pytest.raises(clpt.ScenarioError, match=r"members.b: localization.seed = 1 is that of a"):
        team(a=noisy[0], b=noisy[0])


def test_left_out_edges_join_all():
    assert team(a=STRAIT, b=STRAIT, c=STRAIT).edges == (("a", "b"), ("a", "c"), ("b", "c"))


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
        system_from_text(text, "mine", tmp_path)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("other", "said"),
    [
        ({}, "members: has 1 vehicles; must have 2 to 100"),
        ({"b": vehicle(basis_widths=[5, 5, 4])}, "members.b: its basis is not that of a"),
        ({"b": vehicle(flow_parameters=[[1, 2, 3]] * 2)}, "its flow is not that of a"),
        ({"b": vehicle(units_length="km")}, "its units is not that of a"),
        ({"b": 3}, "members.b = 3"),
        ({"b": {"run": {"durat": 3.0}}}, r"key members\.b\.run\.durat; did you mean dur"),
    ],
    ids=str,
)
def test_vehicles_share_one_flow(other, said):
    with pytest.raises(clpt.ScenarioError, match=said):
        clpt.Team(members={"a": STRAIT, **other}, coupling=0.5)


def test_a_scenario_is_no_team_and_a_team_none(tmp_path):
    clpt.save_scenario(STRAIT, tmp_path / "one.toml")
    with pytest.raises(clpt.ScenarioError, match="is a scenario of one vehicle"):
        clpt.load_team(tmp_path / "one.toml")
    with pytest.raises(clpt.ScenarioError, match=r"has a table \[team\].*clpt.load_team"):
        clpt.load_scenario(FILE)
