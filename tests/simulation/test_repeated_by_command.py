"""`clpt run run.nc` repeats the run of a scenario, and refuses one that it cannot repeat."""

import inspect

import numpy as np
import pytest
import xarray

import clpt_control as package

SCENARIO = package.paper_scenario().with_values({"run.duration": 20.0})
LOOP = package.closed_loop(SCENARIO)
STEERED = package.closed_loop(SCENARIO, external="zc")
START = package.initial_state(LOOP) + 0.1
KEYWORDS = {  # of `simulate`: a system and values
    "timepts": [
        (SCENARIO, {"timepts": [0.0, 1.5, 7.0, 20.0]}),
        (SCENARIO, {"timepts": [3.0, 5.0, 31.0]}),
        (SCENARIO, {"timepts": range(0, 20, 5), "max_step": np.float32(0.5)}),
        (LOOP, {"timepts": [0.0, 1.5, 7.0]}),
        (LOOP, {"timepts": [1.5, 7.0]}),
    ],
    "rtol": [(SCENARIO, {"rtol": 1e-4})],
    "atol": [(SCENARIO, {"atol": 1e-3})],
    "progress": [(SCENARIO, {"progress": lambda t: None})],
    "engine": [(SCENARIO, {"engine": "python"}), (SCENARIO, {"engine": "native"})],
    "method": [(SCENARIO, {"method": "rodas5p"})],
    "max_step": [(SCENARIO, {"max_step": 0.05}), (LOOP, {"max_step": 0.05})],
    "first_step": [(SCENARIO, {"first_step": 1e-5}), (LOOP, {"first_step": 1e-5})],
}
BEYOND_SCENARIO = {  # keyword: a run that its scenario alone does not repeat
    "timepts": (SCENARIO, {"timepts": [3.0, 5.0], "params": {"adaptation.gain": 2.0}}),
    "inputs": (STEERED, {"timepts": [0.0, 5.0, 5.0, 20.0], "inputs": np.eye(2, 4)}),
    "initial_state": (LOOP, {"initial_state": {"vehicle_x": [1.0, 2.0]}}),
    "start": (SCENARIO, {"initial_state": START}),
    "params": (SCENARIO, {"params": {"adaptation.gain": 2.0}}),
    "rtol": (LOOP, {"rtol": 1e-4}),
    "atol": (LOOP, {"atol": 1e-3}),
    "stop": (LOOP, {"stop": lambda t, y, u: 7.5 - t}),
    "method": (LOOP, {"method": "rodas5p"}),
}
RUNS = [
    pytest.param(system, given, id=f"{name} {k}")
    for name, cases in KEYWORDS.items()
    for k, (system, given) in enumerate(cases)
]


def test_every_keyword_is_tried():
    names = {*inspect.signature(package.simulate).parameters} - {"system"}
    assert names == {*KEYWORDS, *BEYOND_SCENARIO} - {"start"}


@pytest.mark.parametrize(("system", "given"), RUNS)
def test_a_run_is_repeated_from_its_file(clpt, tmp_path, system, given):
    run = package.simulate(system, **given)
    package.save_run(run, tmp_path / "a.nc")
    for before, after in (("a", "b"), ("b", "c")):  # a repeated run repeats itself
        words = ("run", tmp_path / f"{before}.nc", "--out", tmp_path / f"{after}.nc")
        assert clpt(*words).status == 0
    for name in "bc":
        again = package.load_run(tmp_path / f"{name}.nc")
        assert np.array_equal(again.time, run.time)
        assert np.array_equal(again.states, run.states)
        assert again.attrs["method"] == run.attrs["method"]


@pytest.mark.parametrize("name", BEYOND_SCENARIO)
def test_a_run_beyond_its_scenario_is_refused(clpt, tmp_path, name):
    system, given = BEYOND_SCENARIO[name]
    package.save_run(package.simulate(system, **given), tmp_path / "a.nc")
    outcome = clpt("run", tmp_path / "a.nc", "--out", tmp_path / "b.nc")
    assert outcome.status == 2
    assert "its scenario alone does not repeat it. Give the scenario" in outcome.err
    assert not (tmp_path / "b.nc").exists()


@pytest.mark.parametrize("text", ["[1]", "{", '{"system": 1}', '{"timepts": "late"}'])
def test_damaged_arguments_are_refused(clpt, tmp_path, text):
    run = package.simulate(SCENARIO, max_step=0.05)
    package.save_run(run, tmp_path / "a.nc")
    with xarray.open_dataset(tmp_path / "a.nc") as data:
        damaged = data.load().assign_attrs(arguments=text)
    damaged.to_netcdf(tmp_path / "damaged.nc", engine="scipy")
    outcome = clpt("run", tmp_path / "damaged.nc", "--out", tmp_path / "b.nc")
    assert outcome.status == 2
    assert "fault" not in outcome.err
    assert not (tmp_path / "b.nc").exists()
