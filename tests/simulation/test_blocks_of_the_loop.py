"""Each block of the paper's loop is tested, on its page, and known by its keys and units.

The scenarios are those of each law, and the example with each line that is commented out.
"""

import re
import tomllib
from pathlib import Path

import pytest
from package_blocks import BLOCKS
from paths import ROOT
from small_scenarios import paper_of

import clpt_control as clpt
from clpt_control.paper.scenario.quantities import keys_of

EXAMPLE = (ROOT / "clpt_control/data/paper.toml").read_text("utf-8")
HEADER = re.compile(r"(# )?\[([\w.]+)\]")
COMMENTED = re.compile(r"# (\w+ = .*)")


def values_of_comments():
    """Yield values of each line or table of the example that is commented out."""
    name, in_comment, table = "", False, {}
    for line in EXAMPLE.splitlines():
        if header := HEADER.match(line):
            in_comment, name, table = bool(header[1]), header[2], {}
        elif commented := COMMENTED.match(line):
            ((key, value),) = tomllib.loads(commented[1]).items()
            table[key] = value
            yield (
                {name: dict(table)}
                if in_comment
                else {f"{name}.{key}".strip("."): value}
            )


def scenarios():
    """Return scenarios that have every block together."""
    found = [paper_of(2, law) for law in clpt.laws()]
    for values in values_of_comments():
        try:
            found.append(clpt.paper_scenario().with_values(values))
        except clpt.ScenarioError:
            continue  # needs another key
    return found


LOOPS = [(one, clpt.paper_blocks(one)) for one in scenarios()]
MADE = {block.name: (one, block) for one, blocks in LOOPS for block in blocks}
LAW = "adaptation"  # tests of the table of laws are for all laws


def functions(block):
    return block.output_function, block.update_function, block.jump_function


def test_each_block_is_tested_and_has_a_row_on_its_page():
    tested = {functions(block) for block in BLOCKS}
    made = [one for _, blocks in LOOPS for one in blocks if one.name != LAW]
    assert [one.name for one in made if functions(one) not in tested] == []
    page = (ROOT / "docs/blocks.md").read_text("utf-8")
    rows = "".join(re.findall(r"(?m)^\| (`.*?) \|", page))
    assert [name for name in MADE if f"`{name}`" not in rows] == []
    assert {"disturbance", "fixes", "measurement", "hedging"} < {*MADE}


def test_another_test_has_numbers_of_each_block():
    """It names the block or one of its keys."""
    files = {*(ROOT / "tests").rglob("test_*.py")} - {Path(__file__)}
    text = "".join(file.read_text("utf-8") for file in files)
    for name, (scenario, block) in MADE.items():
        parameters = [f"{name}.{field}" for field in block.parameters._asdict()]
        keys = {key for one in parameters for key in keys_of(scenario, one)}
        assert any(word in text for word in (name, *keys)), name


@pytest.mark.parametrize("block", sorted(MADE.keys() - {LAW, "reference"}))
def test_a_parameter_in_place_of_a_key_is_answered_with_the_key(block):
    scenario, made = MADE[block]
    for name in made.parameters._asdict().keys() - {"frequencies", "interval"}:
        with pytest.raises(clpt.ScenarioError, match="the scenario's key is "):
            scenario.with_values({f"{block}.{name}": 1.0})


@pytest.mark.long
def test_each_signal_with_a_unit_has_it_in_a_run():
    loops = {tuple(block.name for block in blocks): one for one, blocks in LOOPS}
    for scenario in loops.values():
        run = clpt.simulate(clpt.closed_loop(scenario), [0.0, 0.1])
        law = next(block for block in clpt.paper_blocks(scenario) if block.name == LAW)
        none = {"phi_x", "phi_z", "phi_x_true", "taken", "states", *law.output_ports}
        units = {name: one.attrs.get("units") for name, one in run.data_vars.items()}
        assert {name for name, unit in units.items() if unit is None} <= none
