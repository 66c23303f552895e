"""Studies and examples: each leaves its table and figure, with figures that can be wrong."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from pictures import inked

import clpt_control as clpt
from analysis import laws

ROOT = Path(__file__).parents[2]


def run(*arguments):
    return subprocess.run(
        [sys.executable, *map(str, arguments)], cwd=ROOT, capture_output=True, text=True, check=True
    )


@pytest.mark.slow
def test_step_response_agrees_with_theory(tmp_path):
    run("-m", "analysis.step_response", "--out", tmp_path)
    text = (tmp_path / "step_response.md").read_text()
    rows = dict(line.strip("| ").rsplit(" | ", 1) for line in text.splitlines()[2:])
    values = {name: float(value) for name, value in rows.items()}
    assert values["largest difference of the two responses"] < 1e-6
    assert values["largest |zc -> e|, learner true"] < 1e-5
    slope = values["initial slope of it (theory: GammaD - Gamma)"]
    assert slope == pytest.approx(0.1, rel=0.02)
    assert inked(tmp_path / "step_response.png") > 0.01


@pytest.mark.slow
def test_forecasts_of_flow_estimators(tmp_path):
    few = ROOT / "clpt_control/data/sg542_dives.csv"
    lines = few.read_text().splitlines(keepends=True)
    (tmp_path / "few.csv").write_text("".join(lines[:14]))
    run("-m", "analysis.flow_estimators", tmp_path / "few.csv", "--out", tmp_path)
    text = (tmp_path / "flow_estimators.md").read_text()
    rows = {cells[1].strip(): cells for cells in (r.split("|") for r in text.splitlines()[2:])}
    assert len(rows) == 9
    first = {name: float(cells[2]) for name, cells in rows.items()}
    assert first["tomography, steady"] == first["least-squares, steady"]
    assert max(first.values()) == first["no flow"]
    assert inked(tmp_path / "flow_estimators.png") > 0.01


@pytest.mark.slow
def test_aiming_off_more_than_halves_the_distance_to_the_waypoint(tmp_path):
    run("-m", "analysis.aiming", ROOT / "tests/data/glider/sea035m10_dives.csv", "--out", tmp_path)
    text = (tmp_path / "aiming.md").read_text()
    rows = {cells[1].strip(): cells for cells in (r.split("|") for r in text.splitlines()[2:])}
    assert set(rows) == {"SG542", "sea035m10_dives", "all"}
    for cells in rows.values():
        steered, before, aimed, ratio, to_before = map(float, cells[3:8])
        assert aimed < 0.5 * steered
        assert aimed < 0.8 * before < 0.8 * steered
        assert ratio == pytest.approx(aimed / steered, abs=0.01)
        assert to_before == pytest.approx(aimed / before, abs=0.01)
        assert float(cells[10]) < 0.5 * float(cells[8])  # off a long line
    assert inked(tmp_path / "aiming.png") > 0.01


@pytest.mark.slow
def test_readings_find_the_one_that_reproduces_the_paper(tmp_path):
    done = run("-m", "analysis.readings", "--out", tmp_path)
    assert done.stdout.strip().endswith("end: exponential with periods in s")
    text = (tmp_path / "readings.md").read_text()
    assert "| 4.33 |" in text
    assert "| 0.19 |" in text
    assert text.count("below 1e-12") == 2


@pytest.mark.slow
def test_measured_current_example(tmp_path):
    currents = ROOT / "clpt_control/data/maracoos_hfr_2019-01-01.nc"
    done = run("examples/measured_current.py", currents, tmp_path)
    ratio = float(done.stdout.split("ratio ")[1].split()[0])
    assert ratio <= 0.1
    assert inked(tmp_path / "measured_current.png") > 0.01


@pytest.mark.slow
def test_forecasts_of_gliders_in_made_seas(tmp_path):
    run("-m", "analysis.glider_forecasts", "--vehicles", "3", "--out", tmp_path)
    text = (tmp_path / "glider_forecasts.md").read_text()
    rows = {cells[1].strip(): cells for cells in (r.split("|") for r in text.splitlines()[2:18])}
    assert len(rows) == 16
    ratios = {name: float(cells[2]) for name, cells in rows.items()}
    assert max(ratios.values()) < 1.15
    assert ratios["shelf, M2"] < 0.4
    assert sorted(ratios.values())[8] < 0.99
    assert inked(tmp_path / "glider_forecasts.png") > 0.01


@pytest.mark.slow
def test_priors_matter_little(tmp_path):
    run("-m", "analysis.prior_sensitivity", "--out", tmp_path)
    text = (tmp_path / "prior_sensitivity.md").read_text()
    rows = [row.strip("| ").split(" | ") for row in text.splitlines()[2:35]]
    assert len({name for name, _, _ in rows}) == 17
    assert all(0.8 < float(found) < 0.9 for _, _, found in rows)
    assert inked(tmp_path / "prior_sensitivity.png") > 0.01


@pytest.mark.slow
def test_limited_speed_costs_nothing_with_hedging(tmp_path):
    run("-m", "analysis.limited_speed", "--out", tmp_path)
    lines = (tmp_path / "limited_speed.md").read_text().splitlines()[2:]
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    rises = {(row[0], row[1]): float(row[4]) for row in rows}
    errors = {(row[0], row[1]): float(row[2].split(", ")[1]) for row in rows}
    for speed in ("1", "1.25", "1.5", "2"):
        assert rises[speed, "yes"] < 1e-9 < 0.1 < rises[speed, "no"]
        assert errors[speed, "yes"] < 2e-3 < 1e-2 < errors[speed, "no"]
    assert inked(tmp_path / "limited_speed.png") > 0.01


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


@pytest.mark.slow
def test_which_law_when(tmp_path):
    run("-m", "analysis.laws", "--members", "4", "--out", tmp_path)
    text = (tmp_path / "laws.md").read_text()
    rows = [line.strip("| ").split(" | ") for line in text.splitlines() if line.startswith("| ")]
    told = {row[0]: row[1:] for row in rows[2:]}
    assert len(told) == len(laws.candidates(clpt.paper_scenario()))
    assert [cell == "-" for cell in told["fix-regression"]] == [True] * 5 + [False]
    assert all(cell != "-" for cell in told["composite-least-squares"][:5])
    assert inked(tmp_path / "laws.png") > 0.01
