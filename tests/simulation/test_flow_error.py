"""Error of the learned flow, along the track and over the box, against closed forms."""

from pathlib import Path

import numpy as np
import pytest

import clpt_control as clpt

OVERLAP = {  # two functions that are one: their sum is the flow, each is any number
    "basis.centers": [[0, 0], [0, 0]],
    "basis.widths": [1e9, 1e9],
    "basis.periods": [float("inf")] * 2,
    "basis.kernel": "gaussian",
    "basis.phases": None,
    "model.parameters": None,
    "learning.parameters": None,
    "flow.parameters": [[0.3, 0.0], [0.4, 0.0]],
    "run.duration": 1500.0,
}


def test_without_learning_the_error_is_the_flow(tmp_path, printed, monkeypatch):
    """A uniform flow of 0.5 m/s, nothing learned."""
    monkeypatch.chdir(tmp_path)
    scenario = clpt.paper_scenario().with_values({**OVERLAP, "learning.gain": 0.0})
    clpt.save_scenario(scenario, "s.toml")
    report = printed("run", "s.toml", "--out", "run.nc")
    assert report["flow_error"]["track"] == pytest.approx(0.5, rel=1e-12)
    assert report["flow_error"]["box"] == pytest.approx(0.5, rel=1e-12)


@pytest.mark.parametrize("phase", [0.0, -1.5707963267948966])
def test_a_tide_in_step_with_evenly_spaced_times_has_its_rms(
    tmp_path, printed, monkeypatch, phase
):
    """S2 of 1 km/h over 20 days, nothing learned: rms 1 / sqrt(2) on the track and in the box."""
    monkeypatch.chdir(tmp_path)
    values = {
        "units.length": "km",
        "units.time": "h",
        "basis.centers": [[0, 0]],
        "basis.widths": [1e6],
        "basis.periods": None,
        "basis.constituents": ["S2"],
        "basis.phases": [phase],
        "model.parameters": None,
        "learning.parameters": None,
        "flow.parameters": [[1.0], [0.0]],
        "learning.gain": 0.0,
        "run.duration": 480.0,
    }
    values["basis.kernel"] = "gaussian"
    scenario = clpt.paper_scenario().with_values(values)
    clpt.save_scenario(scenario, "s.toml")
    report = printed("run", "s.toml", "--out", "run.nc")
    for error in report["flow_error"].values():
        assert error == pytest.approx(0.5**0.5, rel=5e-3)


def test_overlapping_functions_mislead_the_parameters_not_the_flow(
    tmp_path, printed, clpt_lines, monkeypatch
):
    """The sum is learned; each parameter is off by 0.15 or more. The flow is printed first."""
    monkeypatch.chdir(tmp_path)
    scenario = clpt.paper_scenario().with_values({**OVERLAP, "learning.gain": 2.0})
    clpt.save_scenario(scenario, "s.toml")
    report = printed("run", "s.toml", "--out", "run.nc")
    *_, parameter_error = report["max_flow_parameter_error"].values()
    assert parameter_error > 0.14
    assert report["flow_error"]["track"] < 0.02
    lines = [
        line
        for line in clpt_lines("run", "s.toml", "--out", "run.nc")
        if "error" in line
    ]
    assert "learned flow, track" in lines[0]
    assert "flow parameter" in lines[2]


def test_an_ensemble_in_a_measured_current_has_the_error(tmp_path):
    """The summary of a member is the error of its run, at its own samples."""
    data = Path(clpt.__file__).parent / "data" / "maracoos_hfr_2019-01-01.nc"
    fit = clpt.currents.fit_current(data, (40.9, 41.55, -69.9, -69.0))
    scenario = fit.save(tmp_path / "mine.toml")
    run = clpt.simulate(scenario)
    t = run.time.values
    late = t >= t[-1] - 0.25 * (t[-1] - t[0])
    basis = scenario.basis_block()
    phi = np.array(
        [
            basis.output_function(s, None, x, basis.parameters)
            for s, x in zip(t[late], run.position.values[late], strict=True)
        ]
    )
    learned = np.einsum("taN,tN->ta", run.flow_parameters_estimate.values[late], phi)
    off = np.sum((run.true_flow.values[late] - learned) ** 2, axis=1)
    members = clpt.run_ensemble(scenario, {"learning.gain": [scenario.learning.gain]})
    assert members.flow_error.item() == pytest.approx(np.sqrt(np.mean(off)), rel=0.05)


@pytest.fixture
def clpt_lines(request):
    """Run a command, and give its lines."""
    command = request.getfixturevalue("clpt")
    return lambda *words: command(*words).out.splitlines()
