"""Examples print their table and save their figure; what they say is so."""

from pathlib import Path

import numpy as np
import pytest
from pictures import inked

import clpt_control as clpt
from analysis import against_adcp, laws, mean_square, shelf, worst_disturbance
from examples import auv, mrac, pendulum, tank


def rows(said):
    """The rows of the table that was printed, by their first cell."""
    lines = [line for line in said.splitlines() if line.startswith("| ")]
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return {row[0]: row[1:] for row in cells[1:]}


def run(example, tmp_path, capsys):
    path = tmp_path / "figure.png"
    example.main(path)
    assert inked(path) > 0.005
    return capsys.readouterr().out


def test_mrac_is_proved_and_learns(tmp_path, capsys):
    said = run(mrac, tmp_path, capsys)
    assert "V' = -2*e**2: proved" in said
    table = rows(said)
    assert float(table["5"][1]) < 0.2 * float(table["0.2"][1])
    assert float(table["5"][2]) == pytest.approx(4, abs=0.4)


def test_the_pendulum_is_caught_from_near_angles_alone(tmp_path, capsys):
    table = rows(run(pendulum, tmp_path, capsys))
    assert [row[0] for row in table.values()] == ["yes", "yes", "yes", "no"]
    assert all(float(row[1]) <= 20 for row in table.values())


def test_the_tank_does_not_overflow_with_anti_windup(tmp_path, capsys):
    table = rows(run(tank, tmp_path, capsys))
    assert float(table["with anti-windup"][0]) < 0.01 < 0.1 < float(table["without"][0])
    assert float(table["with anti-windup"][2]) < float(table["without"][2])
    assert float(table["gains of a shorter pipe"][2]) > float(table["with anti-windup"][2])


def test_a_late_thruster_overshoots(tmp_path, capsys):
    table = rows(run(auv, tmp_path, capsys))
    over = [float(row[0]) for row in table.values()]
    assert over == sorted(over)
    assert float(table["0.1"][2]) == pytest.approx(0.8, abs=1e-3)


@pytest.mark.slow
def test_the_shelf_has_a_panel_for_each_part(tmp_path):
    shelf.main(tmp_path)
    lines = (tmp_path / "parts.md").read_text("utf-8").splitlines()[2:]
    cells = [[cell.strip(" `") for cell in line.strip("|").split("|")] for line in lines]
    assert sorted(row[0] for row in cells) == sorted(clpt.parts.__all__)
    assert all(float(row[2]) < 1e-8 for row in cells if row[2])
    assert sum(bool(row[2]) for row in cells) >= 12
    assert inked(tmp_path / "parts.png") > 0.01


def test_each_study_leaves_a_table_and_a_figure(tmp_path):
    mean_square.main(tmp_path)
    worst_disturbance.main(tmp_path, end=30.0)
    glider = Path(__file__).parents[1] / "data" / "glider"
    against_adcp.main([glider / "sg171_dives.csv"], glider / "sg171_adcp.csv", tmp_path)
    for name in ("mean_square", "worst_disturbance", "against_adcp"):
        lines = (tmp_path / f"{name}.md").read_text("utf-8").splitlines()
        assert len(lines) >= 4
        assert all(line.startswith("| ") for line in (lines[0], *lines[2:]))
        assert inked(tmp_path / f"{name}.png") > 0.005
    assert "False" not in (tmp_path / "mean_square.md").read_text("utf-8")


def test_which_law_when_compares_fast_laws_with_the_papers():
    paper, clear = clpt.paper_scenario(), laws.PAPER["as assumed"]
    keys = laws.candidates(paper)
    printed, memory = (
        laws.on_papers_scenario(paper, {**keys[name], **clear}, 4)
        for name in (laws.PRINTED, "composite-memory")
    )
    assert np.all(printed.error[1:] > 0.05)
    assert memory.error[2] < 0.01 * printed.error[1]
    assert memory.clpe[2] < 0.01 * printed.clpe[1]
