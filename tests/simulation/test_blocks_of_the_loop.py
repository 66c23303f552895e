"""Each block of the paper's loop is on its page, and known by its keys and units."""

import re
from pathlib import Path

import numpy as np
import pytest
from loop_scenarios import LOOPS
from paths import ROOT

import clpt_control as clpt
from clpt_control.paper.scenario.quantities import keys_of

MADE = {block.name: (one, block) for one, blocks in LOOPS for block in blocks}
LAW = "adaptation"  # tests of the table of laws are for all laws


def test_each_block_has_a_row_on_its_page():
    page = (ROOT / "docs/blocks.md").read_text("utf-8")
    rows = "".join(re.findall(r"(?m)^(`.*?) \|", page))
    assert [name for name in MADE if f"`{name}`" not in rows] == []
    assert {"disturbance", "fixes", "measurement", "hedging"} < {*MADE}


def test_another_test_has_numbers_of_each_block():
    """It names the block or one of its keys."""
    files = {*(ROOT / "tests").rglob("test_*.py")} - {Path(__file__)}
    text = "".join(file.read_text("utf-8") for file in files)
    for name, (scenario, block) in MADE.items():
        parameters = [f"{name}.{field}" for field in block.parameters._asdict()]
        keys = {key for one in parameters for key in keys_of(scenario, one)}
        assert any(word in text for word in (name, *keys)), f"no test names {name}"


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


def in_still_water(N):
    """Return the paper's experiment with N functions, without any flow, for an hour."""
    zero = np.zeros((2, N)).tolist()
    of_functions = {
        "centers": np.full((N, 2), 5.0).tolist(),
        "widths": [5.0] * N,
        "periods": [12.42] * N,
        "phases": [0.0] * N,
    }
    values = {f"basis.{name}": value for name, value in of_functions.items()}
    for table in ("flow", "model", "learning"):
        values[f"{table}.parameters"] = zero
    return clpt.paper_scenario().with_values({**values, "run.duration": 1.0})


@pytest.mark.long
def test_a_loop_runs_that_is_too_large_for_the_matrices_of_python_control():
    many, few = in_still_water(1400), in_still_water(2)
    with pytest.raises(clpt.DiagramError, match="for which python-control needs"):
        clpt.closed_loop(many)
    tracks = [clpt.simulate(one).position.values for one in (many, few)]
    np.testing.assert_allclose(*tracks, atol=1e-7)
