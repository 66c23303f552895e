"""What an ensemble keeps of a limited speed is what each member's own run says."""

import json

import numpy as np
import pytest

import clpt_control as clpt
from clpt_control.ensemble.spread import ensemble_summary
from clpt_control.simulation.report import run_and_report

PAPER = clpt.paper_scenario()


def test_members_have_the_figures_of_their_own_runs():
    scenario = PAPER.with_values({"vehicle.max_speed": 1.5, "run.duration": 200})
    data = clpt.run_ensemble(scenario, "vehicle.max_speed=[0.9, 1.5, 9.0]", 3)
    for m, speed in enumerate(data["vehicle.max_speed"].values):
        alone = scenario.with_values({"vehicle.max_speed": float(speed)})
        wanted = run_and_report(alone).summary["speed"]
        faster = wanted["faster_flow"] or {"share": 0.0, "longest": 0.0}
        assert float(data.share_at_speed_limit[m]) == pytest.approx(wanted["share_at_limit"])
        assert float(data.share_in_faster_flow[m]) == pytest.approx(faster["share"], abs=2e-4)
        assert float(data.longest_in_faster_flow[m]) == pytest.approx(faster["longest"], abs=0.11)
    found = ensemble_summary(data)["faster_flow"]
    assert found["members"] == 2
    assert found["largest_share"] == float(data.share_in_faster_flow.max())


def test_waypoints_may_be_left_at_a_pace_of_each_members_own():
    scenario = PAPER.with_values({"vehicle.max_speed": 1.5, "run.duration": 100})
    data = clpt.run_ensemble(scenario, "reference.dwell=[10.0, 20.0]", 2)
    for m, dwell in enumerate(data["reference.dwell"].values):
        alone = scenario.with_values({"reference.dwell": float(dwell)})
        wanted = run_and_report(alone).summary["speed"]["share_at_limit"]
        assert float(data.share_at_speed_limit[m]) == pytest.approx(wanted, abs=2e-3)


def test_without_a_limit_nothing_of_it_is_kept():
    data = clpt.run_ensemble(PAPER.with_values({"run.duration": 20}), "learning.gain=1:2", 2)
    assert "share_at_speed_limit" not in data
    assert "faster_flow" not in ensemble_summary(data)


def test_the_command_says_it(clpt, tmp_path):
    file = tmp_path / "slow.toml"
    assert clpt("init", file).status == 0
    text = file.read_text().replace("duration = 2000", "duration = 100")
    file.write_text(text.replace("\n[vehicle]", "\n[vehicle]\nmax_speed = 1.5", 1))
    given = ("ensemble", file, "--members", 2, "--vary", "vehicle.max_speed=[1.0, 9.0]")
    outcome = clpt(*given, "--out", tmp_path / "e.zarr")
    assert "in 1 members the flow was faster than the vehicle" in outcome.out
    outcome = clpt(*given, "--out", tmp_path / "e.zarr", "--json")
    printed = json.loads(outcome.out)["faster_flow"]
    assert printed["members"] == 1
    assert np.isfinite(printed["longest"])
