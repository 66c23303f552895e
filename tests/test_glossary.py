"""The glossary's joined table is true: its ports, keys and variables are those of what runs."""

import re
from pathlib import Path

import pytest

import clpt_control as clpt

PAGE = Path(__file__).parent.parent / "docs" / "glossary.md"
SHORT = {"run.duration": 2.0, "run.output_step": 1.0}
KINDS = {
    "noise": {"localization.noise": 0.02, "localization.noise_period": 1.0},
    "limited": {"vehicle.max_speed": 1.5},
    "drem": {"learning.law": "drem"},
    "disturbed": {
        "flow.disturbance": {"kind": "constant", "amplitude": [0.05, 0.0], "period": 1.0}
    },
}


def rows():
    """The rows of the joined table: column -> what stands in backticks there."""
    table = PAGE.read_text("utf-8").split("| symbol |")[1].split("\n\n")[0]
    names = ["word", "port", "key", "variable"]
    for line in table.splitlines()[2:]:
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[2:]]
        yield {n: re.findall(r"`([^`]+)`", cell) for n, cell in zip(names, cells, strict=False)}


@pytest.fixture(scope="module")
def scenarios():
    paper = clpt.paper_scenario().with_values(SHORT)
    return [paper, *(paper.with_values(values) for values in KINDS.values())]


@pytest.fixture(scope="module")
def team(scenarios):
    return clpt.Team(members={"west": scenarios[0], "east": scenarios[0]}, coupling=0.5)


def test_every_port_is_one_of_a_diagram(scenarios, team):
    loops = [clpt.closed_loop(one) for one in scenarios]
    loops += [clpt.error_loop(scenarios[0]), clpt.team_loop(team)]
    ports = {re.sub(r".*/|\[.*", "", label) for loop in loops for label in loop.output_labels}
    named = {port.split("[")[0] for row in rows() for port in row["port"] if "[" in port}
    assert len(named) > 15
    assert named - ports == {"V"}  # of a proof's diagram


def test_every_key_is_one_of_a_scenario(scenarios, team):
    known = {"team.coupling"} if team.coupling else set()
    for one in scenarios:
        for table, values in one.model_dump().items():
            known |= {table} | {f"{table}.{key}" for key in values or () if table != "title"}
    named = set()
    for row in rows():
        table = row["key"][0].split(".")[0] if row["key"] else ""
        named |= {key if key.startswith(table) else f"{table}.{key}" for key in row["key"]}
    assert len(named) > 15
    assert named <= known


def test_every_variable_is_one_of_a_run(scenarios):
    runs = [clpt.simulate(one) for one in scenarios]
    named = {name for row in rows() for name in row["variable"]}
    assert len(named) > 10
    assert named <= {str(name) for run in runs for name in run.variables}
