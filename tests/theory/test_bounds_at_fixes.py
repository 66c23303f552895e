"""Bounds on the flow that is learned at fixes, before the vehicle sails."""

import numpy as np
import pytest

import clpt_control as clpt

MPS = 3.6  # km/h
# corners of a track of 85 km, flown at 1 m/s
CORNERS = [[0, 0], [12, 12], [12, 0], [0, 12], [6, 0], [6, 12], [0, 0]]


def points_along(corners, step):
    """Return points each `step` along a line, without its first one, and their distance."""
    corners = np.array(corners, float)
    lengths = np.append(0, np.cumsum(np.hypot(*np.diff(corners, axis=0).T)))
    count = round(lengths[-1] / step)
    at = np.linspace(0, lengths[-1], count + 1)[1:]
    points = np.column_stack([np.interp(at, lengths, x) for x in corners.T])
    return points.tolist(), lengths[-1] / count


def survey(**changes):
    """Four Gaussians and a uniform tide of M2, a fix each hour, 160 h at 1 m/s."""
    points, step = points_along(CORNERS, 0.5)
    tables = {
        "units": {"length": "km", "time": "h"},
        "basis": {
            "kernel": "gaussian",
            "centers": [[0, 0], [12, 0], [0, 12], [12, 12], [6, 6], [6, 6]],
            "widths": [10.0] * 4 + [1e5] * 2,
            "constituents": ["steady"] * 4 + ["M2", "M2"],
            "phases": [0, 0, 0, 0, 0, -np.pi / 2],
        },
        "flow": {"parameters": [[0.1] * 6] * 2},
        "vehicle": {"feedback": [20, 20], "feedforward": [20, 20], "max_speed": MPS},
        "reference": {"kind": "waypoints", "points": points, "dwell": step / MPS},
        "learning": {
            "law": "fix-regression",
            "fix_regression": {"prior": 0.5 * MPS, "noise": 0.1},
        },
        "localization": {"interval": 1.0, "noise": 0.02 / 3},
        "run": {"duration": 160, "output_step": 1},
    }
    return clpt.Scenario(**tables).with_values(changes)


@pytest.fixture(scope="module")
def surveyed():
    return clpt.certify(survey(), shear=0.08 / 3600, unmodelled=0.01)


@pytest.mark.long
def test_the_survey_has_the_bounds_of_an_independent_computation(surveyed):
    """0.043, 0.047, 0.069, 0.130 and 0.255 m/s, of a track whose corners are cut."""
    assert surveyed.interval.tolist() == [0.5, 1, 2, 3, 4]
    expected = [0.043, 0.047, 0.069, 0.130, 0.255]
    assert surveyed.flow == pytest.approx(expected, rel=0.1)


@pytest.mark.long
def test_made_missions_stay_below(surveyed):
    known = np.isfinite(surveyed.flow)
    assert np.all(surveyed.missions[known] < surveyed.flow[known])
    assert np.all(surveyed.missions[known] > 0)


@pytest.mark.long
def test_the_sentence_names_each_assumption(surveyed):
    for words in (
        "with a fix each 1 h the flow on the last 40 h of the planned track is known to",
        "m/s after 160 h, if shear is at most 2.22e-05/s",
        "the unmodelled flow at most 0.01 m/s",
        "each fix within 0.02 km (3 standard deviations)",
        "|theta - theta_hat(0)| at most 0.5 m/s",
        "prediction follows the plan",
    ):
        assert words in surveyed.said
    assert "6 functions lasts beyond shear x interval = 0.649" in surveyed.limit
    excess = [6**0.5 * (np.exp(x) - 1 - x) - x for x in (0.649, 0.65)]
    assert excess[0] < 0 < excess[1]


@pytest.mark.long
def test_a_uniform_current_has_a_closed_form():
    """P = 1/(1/p^2 + k T^2/r^2); |eta| <= P (1/p + (2 n T + k d T^2)/r^2), to L T."""
    T, k, p, r, n, d = 3600.0, 12, 0.4, 300.0, 30.0, 0.02
    tables = {
        "flow.parameters": [[0.1], [0.2]],
        "units": {"length": "m", "time": "s"},
        "basis.centers": [[0, 0]],
        "basis.widths": [1e12],
        "basis.constituents": ["steady"],
        "basis.phases": None,
        "learning.fix_regression": {"prior": p, "noise": r},
        "localization": {"interval": T, "noise": n / 3},
        "run": {"duration": k * T, "output_step": T},
        "vehicle.feedback": [1e-3, 1e-3],
        "vehicle.feedforward": [1e-3, 1e-3],
        "reference.dwell": 600.0,
    }
    found = clpt.certify(survey(**tables), unmodelled=d)
    P = 1 / (1 / p**2 + k * T**2 / r**2)
    expected = P * (1 / p + (2 * n * T + k * d * T**2) / r**2)
    assert found.flow[1] == pytest.approx(expected, rel=1e-5)
    assert found.parameter[1] == pytest.approx(expected, rel=1e-5)
    # the steepest place of a Gaussian is one width from its centre
    assert found.shear == pytest.approx(p * np.exp(-0.5) / 1e12)


REFUSED = [
    ({}, {"shear": 1.0}, "shear x interval is 3.6e.03, .* nothing is guaranteed"),
    ({"localization.latency": 0.1}, {}, "in the plan each fix arrives, and at once"),
    ({"localization.dropouts": 0.1}, {}, "in the plan each fix arrives, and at once"),
    ({"run.duration": 1e4}, {}, "more than 5000 intervals of 0.5"),
    ({}, {"radius": 1.0}, "radius: is not of a scenario of fixes"),
    ({}, {"unmodelled": -1.0}, "must be 0 or more"),
    ({}, {"unmodelled": np.inf}, "must be 0 or more"),
    (
        {"flow.disturbance": {"kind": "noise", "amplitude": [1, 1], "period": 1}},
        {},
        "the flow that the functions do not express has no known bound",
    ),
]


@pytest.mark.parametrize(("values", "limits", "said"), REFUSED, ids=str)
def test_what_is_not_certified_is_said(values, limits, said):
    with pytest.raises(clpt.ScenarioError, match=said):
        clpt.certify(survey(**values), **limits)


@pytest.mark.long
def test_intervals_beyond_the_run_are_left_out():
    found = clpt.certify(survey(**{"run.duration": 2.5}), shear=1e-6)
    assert found.interval.tolist() == [0.5, 1, 2]


@pytest.mark.parametrize("shear", [0.0, -1e-5, np.nan, np.inf])
def test_a_shear_that_is_none_is_refused(shear):
    with pytest.raises(clpt.ArgumentError, match="positive and finite"):
        clpt.certify(survey(), shear=shear)


def test_limits_of_the_flow_are_of_fixes_alone():
    with pytest.raises(clpt.ScenarioError, match="shear: is of a scenario of fixes"):
        clpt.certify(clpt.paper_scenario(), shear=0.1)


@pytest.mark.long
@pytest.mark.long
def test_the_command_rounds_outward_and_draws(surveyed, printed, clpt, tmp_path):
    import clpt_control

    path = tmp_path / "survey.toml"
    clpt_control.save_scenario(survey(), path)
    words = "excitation", path, "--bounds", "--shear", 0.08 / 3600
    words += "--figure", tmp_path / "bound.png"
    found = printed(*words)
    assert found["flow"] == pytest.approx(surveyed.flow.tolist())
    assert found["said"] == surveyed.said
    rows = [line for line in clpt(*words).out.splitlines() if line[:1] == "│"]
    shown = [float(row.split("│")[2]) for row in rows]
    exact = np.array(found["flow"])
    assert np.all((shown >= exact) & (shown < exact * 1.011))
    assert (tmp_path / "bound.png").stat().st_size > 5000


@pytest.mark.long
@pytest.mark.parametrize("duration", [16.0, 24.0])
@pytest.mark.sampled
def test_a_whole_cycle_of_the_track_is_judged(duration):
    """A constant current beside the functions, no noise; the cycle is longer than a quarter."""
    center, width, unmodelled = np.array([-1.4, -8.2]), 13.0, 0.03
    beside = {"kind": "constant", "amplitude": [0.9999 * 3.6 * unmodelled, 0.0]}
    corners = [[-10, -10], [10, -10], [10, 10]]
    scenario = clpt.Scenario(
        units={"length": "km", "time": "h"},
        basis={
            "kernel": "gaussian",
            "centers": [center.tolist()],
            "widths": [width],
            "constituents": ["steady"],
        },
        flow={"parameters": [[0.5], [0.5]], "disturbance": beside},
        vehicle={"feedback": [1, 1], "feedforward": [1, 1], "position": [-10, -10]},
        reference={"kind": "waypoints", "points": corners, "dwell": 4.0},
        learning={
            "law": "fix-regression",
            "position": [-10, -10],
            "fix_regression": {"prior": 1.27, "noise": 0.03},
        },
        localization={"interval": 0.25, "noise": 0.0},
        run={"duration": duration, "output_step": 0.05},
    )
    found = clpt.certify(scenario, shear=2e-5, unmodelled=unmodelled)
    run = clpt.simulate(scenario)
    eta = run.flow_parameters_estimate.values[-1] - 0.5
    last = run.sel(time=slice(duration - 12.0, None)).position.values
    size = np.exp(-np.sum((last - center) ** 2, axis=1) / (2 * width**2))
    error = np.linalg.norm(eta) * size.max() / 3.6
    assert error < found.flow[found.interval == 0.25][0] < 1.1 * error
    assert "the last 12 h of the planned track" in found.said
