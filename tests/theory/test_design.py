"""Designs: a case whose best track is known, limits kept, and never worse than the start."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from law_blocks import EACH, HELD
from made_fields import uniform_field
from pictures import inked
from responses import response
from scipy.linalg import expm

import clpt_control as clpt_package
from clpt_control.errors import ClptError, ScenarioError
from clpt_control.figures import figure_of
from clpt_control.files import write_file
from clpt_control.theory import design_track as design_for
from clpt_control.theory.designing import search
from clpt_control.theory.designing.design import design_plot, learned, linear_gains, time_below
from clpt_control.theory.designing.waypoint_tracks import (
    Tracks,
    closed_length,
    shortened,
    vehicle_alone,
)
from clpt_control.theory.excitation.gramian import gramian, started_true
from clpt_control.theory.excitation.regressor import joint_regressor, w_along

K, DWELL = 0.5, 20.0  # of the case whose best track is known


def design_track(scenario, **limits):
    """Design for the smallest eigenvalue."""
    return design_for(scenario, goal="kappa", **limits)


@pytest.fixture(scope="module")
def quickly():
    """Steps uphill are few: enough for all but the best track."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(search, "CLIMBS", 4)
        patch.setattr(search, "DRAWN", 32)
        yield design_track


@pytest.fixture(scope="module")
def short(paper, quickly):
    """A design over a short window."""
    return quickly(paper, window=60.0)


@pytest.fixture(scope="module")
def two_places():
    """Still water, one function that is 1 everywhere, two waypoints: w = [1, x_i, zc_i]."""
    one = {"centers": [[0, 0]], "widths": [1e9], "periods": [np.inf], "phases": [0]}
    nothing = {key: [[0], [0]] for key in ("flow", "model", "learning")}
    return clpt_package.paper_scenario().with_values(
        {
            "basis": {"kernel": "gaussian", **one},
            **{f"{table}.parameters": zeros for table, zeros in nothing.items()},
            "vehicle.feedback": [K, K],
            "vehicle.feedforward": [K, K],
            "reference": {"kind": "waypoints", "points": [[0.1, 0], [0, 0.1]], "dwell": DWELL},
            "run.duration": 160,
        }
    )


def per_amplitude(dwells):
    """Smallest eigenvalue of int [xi, s] [xi, s]^T, where the waypoint is s = 1, -1, 1, ...

    Between switches xi = s (1 - c exp(-k t)), c = 2/(1 + exp(-k tau)), once it is periodic.
    A track with the waypoints m + h, m - h on an axis has kappa_1 <= h^2 times this: take the
    direction (-m (u_1 + u_2), u_1, u_2).  With m = 0 the bound is reached.
    """
    q = np.exp(-K * DWELL)
    c = 2 / (1 + q)
    both = DWELL - c * (1 - q) / K
    own = DWELL - 2 * c * (1 - q) / K + c**2 * (1 - q**2) / (2 * K)
    return dwells * np.linalg.eigvalsh([[own, both], [both, DWELL]])[0], c


@pytest.mark.parametrize(
    "limit", ["area", "length", pytest.param("max_speed", marks=pytest.mark.slow)]
)
def test_the_best_track_between_two_places(two_places, limit):
    mu, c = per_amplitude(4)
    wide = {"length": 1e3, "area": (-9.0, 9.0, -9.0, 9.0)}
    best, own = {
        "area": (1.2**2, {"area": (-1.2, 1.2, -1.2, 1.2)}),
        "length": (3.0**2 / 32, {"length": 3.0}),
        "max_speed": (0.8**2 / (2 * (c * K) ** 2), {"max_speed": 0.8}),
    }[limit]
    best, given = best * mu, wide | own
    found = design_track(two_places, window=80, start=80, **given)
    reached = found.report["after"]["smallest_eigenvalue"]
    assert 0.99 * best < reached <= best * (1 + 1e-6)
    first, second = found.scenario.waypoints
    np.testing.assert_allclose(np.abs(first - second), abs(first - second)[0], rtol=0.02)


def speeds(scenario, times):
    """Speed through the water along a run, by the diagram itself."""
    calm = scenario.with_values({"flow.disturbance": None})
    loop = clpt_package.closed_loop(calm)
    ran = response(loop, times, initial_state=clpt_package.initial_state(calm))
    v = [ran.outputs[loop.output_labels.index(f"v_x[{i}]")] for i in range(2)]
    return np.hypot(*v)


def test_limits_are_kept_over_the_whole_run(paper, quickly):
    area = (-4.0, 4.5, -3.5, 4.5)
    six = paper.with_values({"reference.count": 6, "reference.dwell": 15.0})
    limits = {"length": 12.0, "max_speed": 2.6, "area": area}
    found = quickly(six, window=90, start=60, seed=3, **limits)
    made, after = found.scenario, found.report["after"]
    assert made.waypoints.shape == (6, 2)
    assert made.reference.dwell == 15.0
    assert closed_length(made.waypoints) <= 12.0 * (1 + 1e-9)
    low, high = np.array(area[::2]), np.array(area[1::2])
    run = clpt_package.simulate(made, np.linspace(0, 400, 7001))
    for places in (made.waypoints, run.position.values):
        assert np.all(places >= low - 1e-9)
        assert np.all(places <= high + 1e-9)
    assert speeds(made, np.linspace(0, 400, 7001)).max() <= 2.6 * (1 + 1e-9)
    assert after["largest_speed"] <= 2.6
    assert after["closed_length"] == pytest.approx(closed_length(made.waypoints), rel=1e-12)


def test_the_eigenvalue_is_that_of_the_learner_started_true(paper, short):
    """Where the learner is true from the start, e = 0 and z = x."""
    window, start = short.report["window"], short.report["start"]
    for scenario, key in ((paper, "before"), (short.scenario, "after")):
        report = short.report[key]
        for source, name in (
            (started_true(scenario), "smallest_eigenvalue"),
            (scenario, "of_the_run"),
        ):
            values = gramian(source, window, start).eigenvalues.values()
            assert report[name] == pytest.approx(min(v[0] for v in values), rel=1e-5)


def test_no_design_is_worse_than_the_start_and_a_seed_repeats_it(paper, short, quickly):
    found = [short, *(quickly(paper, seed=s, window=60.0) for s in (0, 1))]
    assert all(one.report["ratio"] >= 1 for one in found)
    assert found[0].scenario == found[1].scenario
    assert found[0].report == found[1].report
    assert found[0].scenario != found[2].scenario


@pytest.mark.slow
def test_the_papers_track_can_be_2_3_times_better(paper):
    found = design_track(paper, window=200, start=200)
    after = found.report["after"]
    assert after["closed_length"] <= closed_length(paper.waypoints) * (1 + 1e-9)
    assert (len(found.scenario.waypoints), found.scenario.reference.dwell) == (10, 20.0)
    assert found.report["before"]["smallest_eigenvalue"] == pytest.approx(4.333, abs=1e-3)
    assert found.report["ratio"] > 2.3


@pytest.mark.slow
@pytest.mark.parametrize(
    ("law", "level", "times"),
    [
        ("learned-flow", None, (1045.6, 110.0)),
        ("least-squares", 1e-3, (197.4, 190.0)),
        ("composite-memory", 1e-3, (31.2, 31.2)),
    ],
)
def test_a_track_for_a_law_is_one_on_which_it_learns_sooner(law, level, times):
    """The paper's law learned in 1046 s, and never on the track of the largest eigenvalue."""
    paper = clpt_package.paper_scenario().with_values({"learning.law": law})
    found = design_for(paper, window=200, start=200, level=level).report
    before, after = (found[k]["learning_time"] for k in ("before", "after"))
    assert before == pytest.approx(times[0], abs=0.5)
    assert after <= times[1]
    assert found["after"]["closed_length"] <= found["limits"]["length"] * (1 + 1e-9)


@pytest.mark.parametrize("law", ["learned-flow", pytest.param("sigma", marks=pytest.mark.slow)])
def test_no_design_for_a_law_learns_later(paper, law, monkeypatch):
    """A short search finds little: then the scenario's own track stays, and that is said."""
    monkeypatch.setattr(search, "DRAWN", 32)
    scenario = paper.with_values({"learning.law": law, "run.duration": 200})
    found = design_for(scenario, window=60.0, level=0.02)
    first, last = found.tracks
    assert last.cost <= first.cost
    same = found.scenario.waypoints.tolist() == paper.waypoints.tolist()
    assert found.report["own_track_kept"] == same


KNOWN = {
    "learning.law": "known-flow",
    "learning.parameters": None,
    "learning.theta_estimate": [[1, 0.4, 0.8], [0.9, 0.4, 0.8]],
}
ONE_EACH = {"learning.gain": None, "learning.gains": EACH}


@pytest.mark.parametrize("change", [{}, HELD, ONE_EACH, KNOWN], ids=str)
def test_what_is_searched_for_is_what_v_falls_by(paper, change):
    """Against the transition of the error system, piece by piece, with a gain each."""
    scenario = paper.with_values({"vehicle.feedback": [1.0, 2.0], **change})
    gains = linear_gains(scenario)
    found, _ = Tracks(scenario, (40.0, 60.0), 100.0, 3, 1e-10, gains=gains)(paper.waypoints[None])
    along = joint_regressor(started_true(vehicle_alone(scenario)), 40.0, 60.0)
    fine = np.linspace(60.0, 100.0, 40 * 100 + 1)
    times = (fine[1:] + fine[:-1]) / 2
    run = clpt_package.simulate(along.scenario, times)
    w = w_along(along.scenario, times, *[run.position.values] * 2, run.reference.values)
    for i in range(2):
        S = np.concatenate([[1.0], np.where(gains > 0, np.maximum(gains, 1e-9), 1.0) ** -0.5])
        Phi = np.eye(len(gains) + 1)
        for row in w[i]:
            A = np.zeros_like(Phi)
            A[0] = [-scenario.vehicle.feedback[i], *row]
            A[1:, 0] = -gains * row
            Phi = expm(A * (fine[1] - fine[0])) @ Phi
        kept = [0, *(1 + np.flatnonzero(gains > 0))]
        V = (S[:, None] * Phi / S)[np.ix_(kept, kept)]
        assert found[i, 0] == pytest.approx(1 - np.linalg.norm(V, 2) ** 2, rel=2e-3)


@pytest.mark.parametrize(
    ("limits", "said"),
    [
        ({"goal": "speed"}, "goal 'speed': must be one of law, kappa"),
        ({"length": float("nan")}, "length = nan: must be"),
        ({"area": (1.0, 1.0, 0.0, 2.0)}, "each pair increasing"),
        ({"area": (1.0, 2.0, 1.0, 2.0)}, "with vehicle.position in it"),
        ({"window": 500.0}, "must be positive and lie within the run"),
        pytest.param(
            {"max_speed": 0.05, "window": 60.0},
            "no track was found that keeps",
            marks=pytest.mark.slow,
        ),
    ],
    ids=str,
)
def test_impossible_limits_are_refused_in_a_sentence(paper, limits, said):
    with pytest.raises(ClptError, match=said) as caught:
        design_for(paper, **limits)
    assert "\n" not in str(caught.value)


def test_a_track_of_more_waypoints_than_lanes_hold_apart_is_watched(paper):
    circle = [[3 * np.cos(a), 3 * np.sin(a)] for a in np.linspace(0, 2 * np.pi, 601)[:-1]]
    scenario = paper.with_values(
        {"reference": {"kind": "waypoints", "dwell": 0.5, "points": circle}, "run.duration": 30}
    )
    tracks = Tracks(scenario, (10.0, 10.0), 30.0, 3, 1e-8)
    least, _ = tracks(scenario.waypoints[None])
    assert np.all(least > 0)


@settings(max_examples=30, deadline=None, derandomize=True)
@given(
    arrays(float, (5, 2), elements=st.floats(-1e3, 1e3, allow_subnormal=False)),
    st.floats(1e-3, 1e3),
)
def test_a_polygon_shrinks_within_its_own_box(points, length):
    found = shortened(points, length)
    assert closed_length(found) <= length * (1 + 1e-9)
    slack = 1e-9 * np.ptp(points, axis=0).max() + 1e-9
    assert np.all(found >= points.min(axis=0) - slack)
    assert np.all(found <= points.max(axis=0) + slack)
    if closed_length(points) > length:
        assert closed_length(found) == pytest.approx(length, rel=1e-6)


@pytest.mark.parametrize(
    ("values", "level", "time"),
    [
        ([3.0, 0.5, 2.0, 0.5, 0.4], 1.0, 3.0),
        ([3.0, 0.5, 2.0, 0.5, 0.4], 5.0, 0.0),
        ([3.0, 0.5, 2.0, 0.5, 0.4], 0.1, None),
        ([3.0, 0.5, np.nan, 0.5, 0.4], 1.0, 3.0),
    ],
)
def test_the_learning_time_is_the_last_crossing(values, level, time):
    assert time_below(np.arange(5.0), np.array(values), level) == time


def test_a_picture_shows_both_tracks(short, tmp_path):
    write_file(tmp_path / "both.png", figure_of(design_plot, short))
    assert inked(tmp_path / "both.png") > 0.01


def test_in_a_measured_current_no_track_is_designed(tmp_path):
    uniform_field(tmp_path / "field.nc", v=0.2, end=400.0)
    flow = {"field": str(tmp_path / "field.nc")}
    with pytest.raises(ScenarioError, match=r"give flow\.parameters in its place"):
        design_track(clpt_package.paper_scenario().with_values({"flow": flow}))


def test_CLPE_of_a_design_is_that_of_clpt_run():
    """Of a strong feedback too, whose CLPE peaks for an eighth of a second at each waypoint."""
    gains = {"vehicle.feedback": [8, 8], "vehicle.feedforward": [8, 8], "run.duration": 400}
    scenario = clpt_package.paper_scenario().with_values(gains)
    summary = clpt_package.simulation.run_and_report(scenario).summary
    late = learned(scenario, None).summary["clpe_rms_last_quarter"]
    assert late == pytest.approx(summary["clpe_rms_last_quarter"], rel=0.01)
