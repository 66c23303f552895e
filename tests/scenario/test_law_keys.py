"""Keys of the adaptive law: its name, its gains, its own table; each mistake is a sentence."""

import tomllib

import pytest

import clpt_control as clpt
from clpt_control.blocks.laws.table import LAWS
from clpt_control.errors import ScenarioError
from clpt_control.scenario.file import scenario_to_text
from clpt_control.scenario.learning import KINDS, Learning
from clpt_control.theory.proving.theorem_loop import AT_FIXES

PAPER = clpt.paper_scenario()
EACH = {"parameters": 0.8, "feedback": 0.3, "feedforward": 0.5}
NONE = {"learning.gain": None}


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"learning.law": "known"}, r"learning.law = 'known': must be '.*`clpt laws`"),
        (NONE, r"learning.gain: is required by law = \"learned-flow\""),
        ({"learning.gains": EACH}, "learning.gains: give either gain or gains"),
        ({**NONE, "learning.gains": {"parameters": 1}}, "learning.gains.feedback: is required"),
        ({**NONE, "learning.gains.feedback": -1}, "learning.gains.feedback = -1: must be greater"),
        ({**NONE, "learning.gains": {**EACH, "K": 1}}, r"unknown key learning.gains.K.*feedback"),
        ({"learning.adapt_gains": 0}, "learning.adapt_gains = 0: must be a valid boolean"),
        (
            {**NONE, "learning.gains": EACH, "learning.adapt_gains": False},
            "learning.gains.feedback: it is held here; remove the key",
        ),
        (
            {"learning.adapt_gains": False, "learning.feedback": None},
            "learning.feedback: is required with adapt_gains = false, which holds it",
        ),
    ],
)
def test_a_mistake_is_a_sentence(values, said):
    with pytest.raises(ScenarioError, match=said):
        PAPER.with_values(values)


def test_gains_that_the_law_does_not_use_are_refused():
    known = {
        "learning.law": "known-flow",
        "learning.parameters": None,
        "learning.theta_estimate": [[1, 1, 1]] * 2,
    }
    weighted = {"learning.law": "composite-least-squares"}
    for law in (known, weighted):
        with pytest.raises(ScenarioError, match="parameters: alpha does not adapt by it here"):
            PAPER.with_values({**law, **NONE, "learning.gains": EACH})
    used = {"feedback": 0.3, "feedforward": 0.5}
    gains = PAPER.with_values({**known, **NONE, "learning.gains": used}).learning.used_gains
    assert gains == (0.0, 0.3, 0.5, False)


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
    ],
)
def test_gains_are_those_that_adapt(values, gains):
    scenario = PAPER.with_values(values)
    assert scenario.learning.used_gains == gains
    text = scenario_to_text(scenario)
    assert clpt.Scenario.model_validate(tomllib.loads(text)) == scenario


@pytest.mark.parametrize("name", LAWS)
def test_every_row_fits_the_scenario(name):
    law = LAWS[name]
    assert law.name == name
    assert law.promise
    assert law.needs
    assert "\n" not in law.promise + law.needs
    assert not law.settings or law.table in Learning.model_fields
    for key, one in law.settings.items():
        assert key.isidentifier()
        assert one.allowed in KINDS
        assert one.meaning


@pytest.mark.parametrize("name", [name for name, law in LAWS.items() if law.settings])
def test_a_laws_own_table_is_checked_like_all_else(name):
    law = LAWS[name]
    key, table = next(iter(law.settings)), f"learning.{law.table}"
    with pytest.raises(ScenarioError, match=f"{table}: belongs to law = .{name}"):
        PAPER.with_values({table: {}})
    mine = {"learning.law": name, "learning.parameters": None}
    mine |= AT_FIXES if law.at_fixes else {}
    with pytest.raises(ScenarioError, match=f"unknown key {table}.none.*{key}"):
        PAPER.with_values({**mine, f"{table}.none": 1.0})
    with pytest.raises(ScenarioError, match=f"{table}.{key} = 'x': must be"):
        PAPER.with_values({**mine, f"{table}.{key}": "x"})
    assert list(PAPER.with_values(mine).learning.settings) == list(law.settings)


@pytest.mark.parametrize("value", [1e300, 1e-300])
@pytest.mark.parametrize("key", ["prior", "noise"])
def test_a_setting_whose_square_is_no_number_is_refused(key, value):
    """Laws square their settings: 1e300 overflows, 1e-300 is a standard deviation of nothing."""
    mine = {"learning.law": "kalman-flow", "learning.parameters": None}
    with pytest.raises(ScenarioError, match=rf"learning.kalman_flow.{key} = .*: must be .* 1e100"):
        PAPER.with_values({**mine, f"learning.kalman_flow.{key}": value})
