"""Every way to make a scenario or a team: a wrong value is a ScenarioError of one sentence."""

import copy
import pickle
import re
from operator import attrgetter

import numpy as np
import pytest
from error_sentences import says
from law_blocks import EACH
from team_scenarios import DIFFERENT, FILE, ROW, team, vehicle, write_team
from team_scenarios import PAPER as STRAIT

import clpt_control as clpt
from clpt_control import ScenarioError

PAPER = clpt.paper_scenario()
LAWS, LEARNING = clpt.laws(), type(PAPER.learning)
HELD_BY_LAW = ("learning.gain", "learning.feedback", "learning.feedforward")
AT_FIXES = {"localization": {"interval": 5.0}, **dict.fromkeys(HELD_BY_LAW)}
SINE = {"kind": "sine", "amplitude": [1.0, 0.0], "period": 1, "perod": 2}
WRONG = {
    "learning.gain = -1: must be": {"learning": {"gain": -1}},
    r"key flow.disturbance.perod; did you mean flow.disturbance.period\?": {
        "flow": {"disturbance": SINE}
    },
    r"key gian; did you mean learning.gain\? Allowed here: title,": {"gian": 1},
    r"learning.gian; did you mean learning.gain\? Allowed here: law, gain,": {
        "learning": {"gian": 1}
    },
    r'reference.points: is a key of reference.kind = "waypoints"': {
        "reference": {"kind": "circle", "radius": 1, "count": 3, "points": [[0, 0]]}
    },
    r'reference.(radius|count): is a key of reference.kind = "circle"': {
        "reference": {"kind": "waypoints", "points": [[0, 0]], "count": 3}
    },
    "adaptation.gain is the name at call time.* key is learning.gain": {
        "adaptation": {"gain": 2}
    },
    "key is learning.gain or learning.gains.parameters": {
        "learning": {"adaptation": {"gain": 2}}
    },
    "KD is the name at call time.* key is vehicle.feedback": {
        "learning": {"vehicle_controller": {"KD": 2}}
    },
}


def document(changes=()):
    tables = PAPER.model_dump(exclude_none=True, exclude_unset=True)
    for key, value in dict(changes).items():
        whole = not isinstance(value, dict) or key not in tables
        tables[key] = value if whole else {**tables[key], **value}
    return tables


@pytest.mark.parametrize("words", WRONG)
def test_a_wrong_value_is_one_sentence(words):
    tables = document(WRONG[words])
    says(ScenarioError, words, clpt.Scenario, **tables)
    says(ScenarioError, words, clpt.Scenario.model_validate, tables)
    says(ScenarioError, words, PAPER.with_values, tables)


def test_all_keys_of_another_number_of_functions_are_named_at_once():
    four = {"basis.centers": [[0, 0], [10, 10], [5, 5], [-4, 2]]}
    keys = ("basis.widths", "basis.periods", "basis.phases", "model.parameters")
    with pytest.raises(ScenarioError) as caught:
        PAPER.with_values(four)
    assert [key for key in keys if key not in str(caught.value)] == []
    assert "must have 4" in str(caught.value)


def test_a_table_of_its_own_is_checked_too():
    says(
        ScenarioError, "learning: law = 'none': must be", LEARNING, law="none", gain=1.0
    )
    says(ScenarioError, "missing key basis.kernel .and", clpt.Scenario, basis={})
    says(ScenarioError, "3: must be a table of keys", clpt.Scenario.model_validate, 3)
    says(clpt.ArgumentError, "must be a dict of values by name", PAPER.with_values, [2])
    unnamed = "Team: name each argument: coupling=, edges=, members="
    says(ScenarioError, unnamed, clpt.Team, [PAPER, PAPER])
    other = {"reference.kind": "waypoints"}
    says(
        ScenarioError, "reference.points: give either points", PAPER.with_values, other
    )
    given = PAPER.with_values({**other, "reference.points": [[0, 1]]}).reference
    assert (given.points, given.dwell) == (((0, 1),), PAPER.reference.dwell)
    says(
        ScenarioError, "gain is not a table", PAPER.with_values, {"learning.gain.x": 2}
    )


def test_a_right_scenario_is_the_same_by_every_way(tmp_path):
    assert (
        clpt.Scenario(**document()) == PAPER == clpt.Scenario.model_validate(document())
    )
    assert pickle.loads(pickle.dumps(PAPER)) == PAPER == copy.deepcopy(PAPER)
    clpt.save_scenario(PAPER, file := tmp_path / "mine.toml")
    file.write_bytes(b"\xef\xbb\xbf" + file.read_bytes())  # a byte order mark
    assert clpt.load_scenario(file) == PAPER


NOISE = {"kind": "noise", "amplitude": [0.1, 0.0], "period": 2.0}
KNOWN = {"learning.law": "known-flow", "learning.parameters": None}
KNOWN |= {"learning.theta_estimate": [[1, 1, 1]] * 2}
FIXES, NONE = {"learning.law": "fix-regression", **AT_FIXES}, {"learning.gain": None}


def where_it_is(key):
    """Return what else a scenario has that has a key."""
    for part, values in {
        "disturbance": {"flow.disturbance": NOISE},
        **dict.fromkeys(["n.interval", "n.latency", "n.dropouts"], FIXES),
        "localization": {"localization": {"noise": 0.1, "noise_period": 2.0}},
        "learning.gains.": OF_EACH,
        "vehicle.max_speed": {"vehicle.max_speed": 1.5},
        "learning.theta_estimate": KNOWN,
    }.items():
        if part in key:
            return values
    return {}


CALL_TIME_NAMES = {  # key of the scenario: parameters of blocks that have its value
    "basis.centers": "basis_x.centers basis_z.centers basis_x_true.centers",
    "basis.widths": "basis_x.widths basis_z.widths basis_x_true.widths",
    "basis.phases": "basis_x.phases basis_z.phases basis_x_true.phases",
    "flow.parameters": "true_flow.theta lyapunov.theta",
    "flow.disturbance.amplitude": "disturbance.amplitude",
    "flow.disturbance.period": "disturbance.period",
    "flow.disturbance.seed": "disturbance.seed",
    "localization.interval": "fixes.between adaptation.between",
    "localization.latency": "adaptation.latency",
    "localization.noise": "measurement.noise fixes.noise",
    "localization.noise_period": "measurement.period",
    "localization.dropouts": "fixes.dropouts",
    "localization.seed": "measurement.seed fixes.seed",
    "model.parameters": "modeled_flow.alpha_M injection.alpha_M",
    "vehicle.feedback": "vehicle_controller.KD lyapunov.KD error_system.KD",
    "vehicle.feedforward": "vehicle_controller.GammaD lyapunov.GammaD",
    "vehicle.max_speed": "speed_limit.max_speed",
    "reference.dwell": "reference.dwell",
    "learning.gain": "adaptation.gain adaptation.gain_K",
    "learning.gains.parameters": "adaptation.gain",
    "learning.gains.feedback": "adaptation.gain_K",
    "learning.gains.feedforward": "adaptation.gain_Gamma",
    "learning.theta_estimate": "injection.theta_hat",
}


@pytest.mark.parametrize("key", CALL_TIME_NAMES)
def test_an_error_about_one_name_says_the_other(key):
    scenario = PAPER.with_values(where_it_is(key))
    parameters = {
        f"{block.name}.{field}": value
        for block in clpt.paper_blocks(scenario)
        for field, value in block.parameters._asdict().items()
    }
    known = [name for name in CALL_TIME_NAMES[key].split() if name in parameters]
    value, held = parameters[known[0]], attrgetter(key)(scenario)
    if held is not None:  # what the scenario leaves out is zero
        np.testing.assert_allclose(np.reshape(value, np.shape(held)), held)
    if key in known:
        return
    said = f"{key} is a key of the scenario.*{known[0]}"
    for system, times in ((scenario, None), (clpt.closed_loop(scenario), [0.0, 1.0])):
        says(clpt.BlockError, said, clpt.simulate, system, times, params={key: value})
    said = f"the scenario's key is (.* or )?{key}"
    says(ScenarioError, said, scenario.with_values, {known[0]: value})


UNUSED = r"parameters: .* adapts feedback, feedforward here"
HELD = {"learning.adapt_gains": False}
OF_EACH = {**NONE, "learning.gains": EACH}
OF_PARAMETERS = {**NONE, "learning.gains": {"parameters": 2.0}}


def test_a_mistake_is_a_sentence():
    for values, said in (
        ({"learning.law": "known"}, r"learning.law = 'known': must be '.*`clpt laws`"),
        (NONE, r"learning.gain: is required by law = \"learned-flow\""),
        ({"learning.gains": EACH}, "learning.gains: give either gain or gains"),
        (OF_PARAMETERS, "gains.feedback: .* adapts parameters, feedback, feedforward"),
        (
            {**NONE, "learning.gains.feedback": -1},
            "learning.gains.feedback = -1: must be greater",
        ),
        (
            {**NONE, "learning.gains": {**EACH, "K": 1}},
            r"unknown key learning.gains.K.*feedback",
        ),
        (
            {"learning.adapt_gains": 0},
            "learning.adapt_gains = 0: must be a valid boolean",
        ),
        (
            {**OF_EACH, **HELD},
            "learning.gains.feedback: .* adapts parameters here..* no other",
        ),
        (
            {**HELD, "learning.feedback": None},
            "feedback: is required by .* with adapt_gains = fal",
        ),
        ({**KNOWN, **OF_EACH}, UNUSED),
        ({"learning.law": "composite-least-squares", **OF_EACH}, UNUSED),
    ):
        says(ScenarioError, said, PAPER.with_values, values)


GAINS = [
    ({}, (0.8, 0.8, 0.8, True)),
    (OF_EACH, (0.8, 0.3, 0.5, False)),
    (HELD, (0.8, 0.0, 0.0, False)),
    ({**OF_PARAMETERS, **HELD}, (2.0, 0.0, 0.0, False)),
    (
        {**KNOWN, **NONE, "learning.gains": {**EACH, "parameters": None}},
        (0, 0.3, 0.5, False),
    ),
]


@pytest.mark.parametrize(("values", "gains"), GAINS)
def test_gains_are_those_that_adapt(values, gains, tmp_path):
    scenario = PAPER.with_values(values)
    assert scenario.learning.used_gains == gains
    clpt.save_scenario(scenario, tmp_path / "s.toml")
    assert clpt.load_scenario(tmp_path / "s.toml") == scenario


@pytest.mark.parametrize("name", LAWS)
def test_every_row_fits_the_scenario(name):
    law = LAWS[name]
    assert law.name == name
    assert law.promises
    assert re.fullmatch(".+", law.needs)
    assert not law.settings or law.table in LEARNING.model_fields
    for key, one in law.settings.items():
        assert (key.isidentifier(), bool(one.meaning)) == (True, True), key


@pytest.mark.parametrize("name", [name for name, law in LAWS.items() if law.settings])
def test_a_laws_own_table_is_checked_like_all_else(name):
    law = LAWS[name]
    key, table = next(iter(law.settings)), f"learning.{law.table}"
    mine = {"learning.law": name, "learning.parameters": None}
    mine |= AT_FIXES if law.at_fixes else {}
    for values, said in (
        ({table: {}}, f"{table}: law = .* has no use for it"),
        ({**mine, f"{table}.none": 1.0}, f"unknown key {table}.none.*{key}"),
        ({**mine, f"{table}.{key}": "x"}, f"{table}.{key} = 'x': must be"),
    ):
        says(ScenarioError, said, PAPER.with_values, values)
    assert list(PAPER.with_values(mine).learning.settings) == list(law.settings)


def test_a_setting_whose_square_is_no_number_is_refused():
    """Laws square their settings: 1e300 overflows, 1e-300 is a standard deviation of nothing."""
    mine = {"learning.law": "kalman-flow", "learning.parameters": None}
    for key, value in (("prior", 1e300), ("noise", 1e-300)):
        key = f"learning.kalman_flow.{key}"
        said = f"{key} = .*: must be .* 1e100"
        says(ScenarioError, said, PAPER.with_values, {**mine, key: value})


# --- a team --------------------------------------------------------------------------------------

TEXT = FILE.read_text()
EDGES, OWN = '[["west", "east"]]', "vehicle.position = [11, 0]"


def test_the_example_says_what_it_says():
    of = clpt.load_scenario(FILE)
    west, east = of.members.values()
    assert (list(of.members), of.edges) == (["west", "east"], (("west", "east"),))
    assert (west.vehicle.position, east.reference.points[0]) == (
        (-11.0, 0.0),
        (15.0, -2.0),
    )
    assert west.vehicle.feedback == east.vehicle.feedback
    assert of.connectivity == pytest.approx(2.0)


TITLES = {"a": "one", "b": "two", "c": "", "d": "one"}
TITLED = team(**{name: vehicle(title=title) for name, title in TITLES.items()})
OTHERS = team(0.25, ROW, **DIFFERENT)


@pytest.mark.parametrize("of", [OTHERS, clpt.load_scenario(FILE), TITLED])
def test_a_team_comes_back_from_its_text(of, tmp_path):
    write_team(tmp_path / "mine.toml", of)
    back = clpt.load_scenario(tmp_path / "mine.toml")
    assert back == of
    assert [one.title for one in back.members.values()] == [
        m.title for m in of.members.values()
    ]


def test_each_vehicle_has_its_own_noise(tmp_path):
    noise = {"noise": 0.02, "noise_period": 0.5}
    first, second = (vehicle(localization={**noise, "seed": seed}) for seed in (1, 2))
    of = team(a=first, b=second, c=STRAIT)
    write_team(tmp_path / "mine.toml", of)
    assert clpt.load_scenario(tmp_path / "mine.toml") == of
    run = clpt.simulate(of, [0.0, 1.0])
    a, b, c = (run.measured_position - run.position).values
    assert abs(a - b).max() > 1e-3
    assert abs(c).max() == 0
    says(
        ScenarioError,
        r"members.b: localization.seed = 1 is that of a",
        team,
        a=first,
        b=first,
    )


def test_left_out_edges_join_all():
    assert team(a=STRAIT, b=STRAIT, c=STRAIT).edges == (
        ("a", "b"),
        ("a", "c"),
        ("b", "c"),
    )


OF_A_TEAM = [
    ("coupling = 0.5", "", "mine, team: missing key coupling"),
    (
        "coupling = 0.5",
        "coupling = -1",
        "team: coupling = -1: must be greater than or equal",
    ),
    (
        "coupling = 0.5",
        "coupling = nan",
        "team: coupling = nan: must be a finite number",
    ),
    ("coupling = 0.5", "couplng = 0.5", "unknown key couplng; did you mean coupling"),
    (
        '"east"]]',
        '"est"]]',
        r"edges\[0\]: there is no vehicle 'est'; must be among west, east",
    ),
    (
        '"east"]]',
        '"west"]]',
        r"edges\[0\] = \['west', 'west'\]: must join two vehicles",
    ),
    (
        '"east"]]',
        '"east"], ["east", "west"]]',
        r"edges\[1\] = .*: must join two .* each pair",
    ),
    (EDGES, "[]", "edges: no path joins all vehicles"),
    (EDGES, '["west"]', r"edges\[0\] = 'west': must be a list"),
    (
        EDGES,
        '[["west"]]',
        r"edges\[0\]\[1\]: is missing. Give all coordinates or names",
    ),
    (
        "[team.members.west]",
        '[team.members."we st"]',
        "the name 'we st' of a vehicle must be",
    ),
    (OWN, "run.duration = 7.0", "members.east: its run is not that of west"),
    (OWN, "learning.gain = 1", "members.east: its learning is not that of west"),
    (OWN, "vehicle.pos = 1", "east: unknown key vehicle.pos"),
    (OWN, "vehicle = 1", "east: vehicle = 1: must be a table of keys"),
    ("gain = 4.0", "", "west: learning.gain: is required"),
    ('"learned-flow"', '"sigma"', 'learning.law = "sigma": must be "learned-flow"'),
    (
        "[team]",
        "[team]\nmembers = 1\n[other]",
        "team.members = 1: must be a table of keys",
    ),
]


@pytest.mark.parametrize(("old", "new", "said"), OF_A_TEAM, ids=str)
def test_each_mistake_is_a_sentence(tmp_path, old, new, said):
    assert old in TEXT
    text = TEXT.replace(old, new).partition("[other]")[0]
    (tmp_path / "mine").write_text(text)
    says(ScenarioError, said, clpt.load_scenario, tmp_path / "mine")


def test_vehicles_share_one_flow():
    for other, said in (
        ({}, "members: has 1 vehicles; must have 2 to 100"),
        (
            {"b": vehicle(basis_widths=[5, 5, 4])},
            "members.b: its basis is not that of a",
        ),
        ({"b": vehicle(flow_parameters=[[1, 2, 3]] * 2)}, "its flow is not that of a"),
        ({"b": vehicle(units_length="km")}, "its units is not that of a"),
        ({"b": 3}, "members.b = 3"),
        (
            {"b": {"run": {"durat": 3.0}}},
            r"key members\.b\.run\.durat; did you mean members\.b\.run\.dur",
        ),
    ):
        says(
            ScenarioError, said, clpt.Team, members={"a": STRAIT, **other}, coupling=0.5
        )


def test_a_file_is_read_as_a_scenario_or_a_team(tmp_path, refused):
    clpt.save_scenario(STRAIT, file := tmp_path / "one.toml")
    assert clpt.load_scenario(file) == STRAIT
    assert isinstance(clpt.load_scenario(FILE), clpt.Team)
    said = r"has a table \[team\].*clpt.load_scenario"
    assert re.search(said, refused("excitation", FILE, "--bounds"))
    clpt.save_run(clpt.simulate(OTHERS, [0.0, 1.0]), run := tmp_path / "run.nc")
    assert clpt.load_scenario(run) == OTHERS
    assert "it is a team's" in refused("excitation", run, "--bounds")


def test_a_text_without_quotes_is_answered(tmp_path):
    path = tmp_path / "mine.toml"
    for text, ends in (
        ("[run]\nlength = m", "(at line 2, column 10). A text has quotes"),
        ("[run]\n[run]", "(at line 2, column 5)"),
    ):
        path.write_text(text)
        with pytest.raises(clpt.ScenarioError) as caught:
            clpt.load_scenario(path)
        assert str(caught.value).endswith(ends)
