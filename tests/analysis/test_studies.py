"""Studies: each leaves its table and figure, with figures that can be wrong."""

import sys

import pytest
from image_checks import inked
from paths import ROOT
from subprocesses import ran
from synthetic_vehicle import vehicle

import clpt_control as clpt
from analysis import laws, simple_forecasts

DATA = ROOT / "clpt_control/data"
pytestmark = pytest.mark.slow


@pytest.fixture
def study(tmp_path):
    """Run a study, which leaves a figure; give the rows of its table."""

    def made(name, *arguments):
        words = "-m", f"analysis.{name}", *arguments, "--out", tmp_path
        made.said = ran(sys.executable, *words, cwd=ROOT).stdout
        assert inked(tmp_path / f"{name}.png") > 0.01
        lines = (tmp_path / f"{name}.md").read_text().splitlines()
        rows = [
            line.strip("| ").split(" | ") for line in lines if line.startswith("| ")
        ]
        return [[cell.strip() for cell in row] for row in rows[1:]]

    return made


def test_step_response_agrees_with_theory(study):
    values = {name: float(value) for name, value in study("step_response")}
    assert values["largest difference of the two responses"] < 1e-6
    assert values["largest |zc -> e|, learner true"] < 1e-5
    assert values["initial slope of it (theory: GammaD - Gamma)"] == pytest.approx(
        0.1, rel=0.02
    )


def test_aiming_off_more_than_halves_the_distance_to_the_waypoint(study):
    rows = study("aiming", ROOT / "tests/data/glider/sea035m10_dives.csv")
    assert {row[0] for row in rows} == {"SG542", "sea035m10_dives", "all"}
    for row in rows:
        steered, before, aimed, ratio, to_before = map(float, row[2:7])
        assert aimed < 0.5 * steered
        assert aimed < 0.8 * before < 0.8 * steered
        assert (ratio, to_before) == pytest.approx(
            (aimed / steered, aimed / before), abs=0.01
        )
        assert float(row[9]) < 0.5 * float(row[7])  # off a long line


def test_readings_find_the_one_that_reproduces_the_paper(study, tmp_path):
    study("readings")
    assert study.said.strip().endswith("end: exponential with periods in s")
    text = (tmp_path / "readings.md").read_text()
    assert "| 4.33 |" in text
    assert "| 0.19 |" in text
    assert text.count("below 1e-12") == 2


def test_measured_current_example(tmp_path):
    words = (
        "examples/measured_current.py",
        DATA / "maracoos_hfr_2019-01-01.nc",
        tmp_path,
    )
    done = ran(sys.executable, *words, cwd=ROOT)
    assert float(done.stdout.split("ratio ")[1].split()[0]) <= 0.1
    assert inked(tmp_path / "measured_current.png") > 0.01


def test_forecasts_of_gliders_in_made_seas(study):
    ratios = {
        row[0]: float(row[1])
        for row in study("glider_forecasts", "--vehicles", "3")[:16]
    }
    assert len(ratios) == 16
    assert max(ratios.values()) < 1.15
    assert ratios["shelf, M2"] < 0.4
    assert sorted(ratios.values())[8] < 0.99


def test_priors_matter_little(study):
    rows = study("prior_sensitivity")[:33]
    assert len({name for name, _, _ in rows}) == 17
    assert all(0.79 < float(found) < 0.9 for _, _, found in rows)


def test_limited_speed_costs_nothing_with_hedging(study):
    rows = study("limited_speed")
    rises = {(row[0], row[1]): float(row[4]) for row in rows}
    errors = {(row[0], row[1]): float(row[2].split(", ")[1]) for row in rows}
    for speed in ("1", "1.25", "1.5", "2"):
        assert rises[speed, "yes"] < 1e-9 < 0.1 < rises[speed, "no"]
        assert errors[speed, "yes"] < 2e-3 < 1e-2 < errors[speed, "no"]


def test_which_law_when(study):
    told = {row[0]: row[1:] for row in study("laws", "--members", "4")[1:]}
    assert len(told) == len(laws.candidates(clpt.paper_scenario()))
    assert [cell == "-" for cell in told["fix-regression"]] == [True] * 5 + [False]
    assert all(cell != "-" for cell in told["composite-least-squares"][:5])


def test_bounds_of_the_disturbance(study, tmp_path):
    assert len(study("disturbance_bounds")) == 17
    assert "Eq. (33) is violated in 14 of 17 runs" in study.said
    assert "the mean-square bound in 0, the corrected bound in 0." in study.said
    assert "The worst disturbance on axis 1 makes |e| = 5.23 Dmax" in study.said
    text = (tmp_path / "disturbance_bounds.md").read_text()
    assert "\n| 0.05 | 3.5 | 0.050 | 0.0720 | 1.440 |" in text


def test_simple_forecasts_of_a_steady_current(tmp_path):
    """In a current that never changes each rule is exact but for the first dives' priors."""
    dives = vehicle(1, 12, walk=0.0, noise=0.0, fix=0.0)
    found = simple_forecasts.errors(dives)
    for name in ("previous dive", "running mean", "exponential smoothing"):
        assert found[name] < 5.0
    assert found["small Gaussian process"] < 100.0
