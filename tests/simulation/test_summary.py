"""Figures of a run: mean squares over every sample, or over fewer that are spread evenly."""

import numpy as np
import pytest
from gridded_currents import uniform_field
from scipy.integrate import simpson

import clpt_control as clpt
from clpt_control.simulation.summary import claims

PAPER = clpt.paper_scenario()
CASES = {
    "whole cycles": {"run.duration": 1000.0},
    "a cycle and a bit": {"run.duration": 730.1, "run.output_step": 0.7},
    "odd spans": {"reference.dwell": 0.7, "run.duration": 23.1, "run.output_step": 1.1},
    "no whole cycle": {"run.duration": 37.3},
}


def rms(scenario):
    """Return the rms of |e| per cycle and over the run by Simpson's rule, 2000 samples a cycle."""
    end = scenario.run.duration
    step = min(scenario.cycle, end) / 2000
    times = np.append(np.arange(np.ceil(end / step - 1e-6)) * step, end)
    run = clpt.simulate(scenario, times)
    squares = np.sum((run.predicted_position - run.position).values ** 2, axis=1)
    starts = range(0, 2000 * int(end / scenario.cycle + 1e-9), 2000)
    means = [
        simpson(squares[part], x=times[part]) / np.ptp(times[part])
        for part in (*(slice(k, k + 2001) for k in starts), slice(None))
    ]
    return np.sqrt(means[:-1]), np.sqrt(means[-1])


@pytest.mark.parametrize("case", CASES)
def test_mean_squares_are_over_every_sample(case, reported):
    scenario = PAPER.with_values(CASES[case])
    (summary, run), own = reported(scenario), clpt.simulate(scenario)
    each, whole = rms(scenario)
    assert summary["clpe_rms_per_cycle"] == pytest.approx(each, rel=1e-3)
    assert summary["clpe_rms"] == pytest.approx(whole, rel=1e-4)
    np.testing.assert_allclose(run.time, own.time, rtol=1e-14)
    for name in ("position", "alpha", "reference", "lyapunov"):
        np.testing.assert_allclose(
            run[name], own[name], rtol=0, atol=1e-7, err_msg=name
        )
    last = abs(own.flow_parameters_estimate[-1] - own.flow_parameters).max()
    end, error = [*summary["max_flow_parameter_error"].items()][-1]
    assert end == f"{scenario.run.duration:g}"
    assert error == pytest.approx(float(last), abs=1e-7)
    assert run.attrs["solver_steps"] == pytest.approx(
        own.attrs["solver_steps"], rel=0.1
    )


POINTS = np.random.default_rng(3).uniform(-3, 3, (1000, 2)).tolist()
SELDOM = {
    "a waypoint held for much longer than the run": (1.0, [[3.0, 0.0]], 1e6, 100.0),
    "a thousand waypoints": (1.0, POINTS, 20.0, 20_000.0),
    "long at each waypoint": (1.0, POINTS[:5], 500.0, 5000.0),
    "a strong feedback": (20.0, POINTS[:10], 20.0, 200.0),
}


@pytest.mark.long
@pytest.mark.parametrize("case", SELDOM)
def test_a_peak_of_CLPE_is_seen_however_rarely_a_waypoint_comes(case, reported):
    """Of a learner that is true but for z(0), in calm water: e = e(0) exp(-KD t)."""
    k, points, dwell, end = SELDOM[case]
    gains = {"feedback": [k, k], "feedforward": [k, k]}
    values = {
        f"{who}.{gain}": own
        for who in ("vehicle", "learning")
        for gain, own in gains.items()
    }
    values |= {"flow.parameters": [[0.0] * 3] * 2, "learning.gain": 0.0}
    values |= {"reference": {"kind": "waypoints", "points": points, "dwell": dwell}}
    values |= {
        "learning.position": [0.6, 0.8],
        "run.duration": end,
        "run.output_step": end / 10,
    }
    found, _ = reported(scenario := PAPER.with_values(values))
    assert found["clpe_rms"] == pytest.approx(1 / np.sqrt(2 * k * end), rel=0.06)
    several = clpt.run_ensemble(scenario, {"vehicle.position": [[0.0, 0.0]]})
    assert float(several.clpe_rms_whole[0]) == pytest.approx(found["clpe_rms"], rel=0.5)


@pytest.mark.parametrize("end", [730.05, 600.0])
def test_a_run_that_stops_is_kept_to_where_it_stops(end, tmp_path, reported):
    """The field ends in the fourth cycle, or with the third: the run's last sample is there."""
    uniform_field(tmp_path / "field.nc", end=end)
    flow = {"field": str(tmp_path / "field.nc"), "outside": "stop"}
    scenario = PAPER.with_values({"flow": flow, "run.duration": 1000.0})
    said, run = reported(scenario)
    own = clpt.simulate(scenario, np.append(np.arange(int(end) + 1.0), 1000.0))
    assert (said["status"], len(said["clpe_rms_per_cycle"])) == ("stopped", 3)
    assert [said["end"], run.time[-1], own.time[-1]] == pytest.approx([end] * 3)
    np.testing.assert_allclose(run.position, own.position, rtol=0, atol=1e-7)


def test_a_run_of_many_cycles_has_fewer_samples_and_the_same_means(reported):
    """Their step is no part of the time at a waypoint, so that no phase of it is left out."""
    scenario = PAPER.with_values({"run.duration": 30_000.0, "run.output_step": 100.0})
    found, run = reported(scenario)
    each = found["clpe_rms_per_cycle"]
    alone, _ = reported(PAPER.with_values({"run.duration": 600.0}))
    assert len(each) == 150
    assert each[:3] == pytest.approx(alone["clpe_rms_per_cycle"], rel=0.04)
    assert run.sizes["time"] == 301


def test_errors_are_those_at_round_times_and_at_the_end(reported):
    times = (10.0, 20.0, 100.0, 200.0, 250.0)
    summary, run = reported(PAPER.with_values({"run.duration": 250.0}))
    errors = abs(run.flow_parameters_estimate - run.flow_parameters)
    at = {f"{t:g}": float(errors.sel(time=t).max()) for t in times}
    assert summary["max_flow_parameter_error"] == pytest.approx(at, rel=1e-12)


def test_what_misses_a_claim_is_not_rounded_to_what_meets_it(reported):
    """0.1004 of the first cycle is more than 10 %, and 0.0504 more than 0.05."""
    errors = {"200": 0.0504, "2000": 0.0002}
    found = {"max_flow_parameter_error": errors, "max_gain_error": errors}
    clpe, flow, _ = claims({"clpe_rms_per_cycle": [2e-4, 2.008e-5], **found})
    measured = "0.0002, then 2.01e-05 (10.04 %); last cycle 2.01e-05"
    assert (clpe["verdict"], clpe["measured"]) == ("fails", measured)
    assert flow["measured"] == "0.0504 at t = 200, 0.0002 at t = 2000"
    short, _ = reported(PAPER.with_values({"run.duration": 20.0}))
    with pytest.raises(clpt.DataError, match="from t = 0 to 2000"):
        claims(short)
