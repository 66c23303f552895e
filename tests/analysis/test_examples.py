"""Examples print their table and save their figure; what they say is so."""

import re
from pathlib import Path

import numpy as np
import pytest
from pictures import inked

import clpt_control as clpt
from analysis import against_adcp, laws, mean_square, shelf, worst_disturbance
from examples import auv, mrac, pendulum, tank

NUMBER = re.compile(r"-?\d[\d.]*(e[-+]\d+)?")


def rows(said):
    """The rows of a table, by their first cell, without its head."""
    lines = [line for line in said.splitlines() if line.startswith("| ")]
    cells = [[cell.strip(" `") for cell in line.strip("|").split("|")] for line in lines]
    return {row[0]: [float(c) if NUMBER.fullmatch(c) else c for c in row[1:]] for row in cells[1:]}


@pytest.fixture
def run(tmp_path, capsys):
    """Run an example, which draws a figure; give what it prints and the table in it."""

    def made(example):
        example.main(tmp_path / "figure.png")
        assert inked(tmp_path / "figure.png") > 0.005
        said = capsys.readouterr().out
        return said, rows(said)

    return made


def test_mrac_is_proved_and_learns(run):
    said, table = run(mrac)
    assert "V' = -2*e**2: proved" in said
    assert table["5"][1] < 0.2 * table["0.2"][1]
    assert table["5"][2] == pytest.approx(4, abs=0.4)


def test_the_pendulum_is_caught_from_near_angles_alone(run):
    caught, after, *_ = zip(*run(pendulum)[1].values(), strict=True)
    assert caught == ("yes", "yes", "yes", "no")
    assert max(after) <= 20


def test_the_tank_does_not_overflow_with_anti_windup(run):
    table = run(tank)[1]
    with_it, without = table["with anti-windup"], table["without"]
    assert with_it[0] < 0.01 < 0.1 < without[0]
    assert with_it[2] < min(without[2], table["gains of a shorter pipe"][2])


def test_a_late_thruster_overshoots(run):
    table = run(auv)[1]
    over = [row[0] for row in table.values()]
    assert over == sorted(over)
    assert table["0.1"][2] == pytest.approx(0.8, abs=1e-3)


@pytest.mark.slow
def test_the_shelf_has_a_panel_for_each_part(tmp_path):
    shelf.main(tmp_path)
    table = rows((tmp_path / "parts.md").read_text("utf-8"))
    assert sorted(table) == sorted(clpt.parts.__all__)
    off = [row[1] for row in table.values() if row[1] != ""]
    assert len(off) >= 12
    assert max(off) < 1e-8
    assert inked(tmp_path / "parts.png") > 0.01


def test_each_study_leaves_a_table_and_a_figure(tmp_path):
    mean_square.main(tmp_path)
    worst_disturbance.main(tmp_path, end=30.0)
    glider = Path(__file__).parents[1] / "data" / "glider"
    against_adcp.main([glider / "sg171_dives.csv"], glider / "sg171_adcp.csv", tmp_path)
    for name in ("mean_square", "worst_disturbance", "against_adcp"):
        first, _, *lines = (tmp_path / f"{name}.md").read_text("utf-8").splitlines()
        assert len(lines) >= 2
        assert all(line.startswith("| ") for line in (first, *lines))
        assert inked(tmp_path / f"{name}.png") > 0.005
    assert "False" not in (tmp_path / "mean_square.md").read_text("utf-8")


def test_which_law_when_compares_fast_laws_with_the_papers():
    paper, clear = clpt.paper_scenario(), laws.PAPER["as assumed"]
    both = [
        {**laws.candidates(paper)[name], **clear} for name in (laws.PRINTED, "composite-memory")
    ]
    printed, memory = (laws.on_papers_scenario(paper, values, 4) for values in both)
    assert np.all(printed.error[1:] > 0.05)
    assert memory.error[2] < 0.01 * printed.error[1]
    assert memory.clpe[2] < 0.01 * printed.clpe[1]
