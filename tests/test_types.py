"""What type checkers see of the public names; mypy reads this file (`make lint`)."""

from typing import assert_type

import xarray

import clpt_control as clpt


def test_what_simulate_returns_is_known():
    scenario = clpt.paper_scenario().with_values({"run.duration": 2})
    loop = clpt.closed_loop(scenario)
    assert_type(scenario, clpt.Scenario)
    runs = clpt.simulate(scenario), clpt.simulate(scenario, [0.0, 1.0])
    assert_type(runs, tuple[xarray.Dataset, xarray.Dataset])
    response = clpt.simulate(loop, [0.0, 1.0])
    assert_type(response, xarray.Dataset)
    assert all(isinstance(run, xarray.Dataset) for run in (*runs, response))


def test_an_export_without_a_path_is_a_text():
    loop = clpt.closed_loop(clpt.paper_scenario())
    assert_type(clpt.export(loop), str)
    assert clpt.export(loop).startswith("/*")
