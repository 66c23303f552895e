"""Guaranteed errors of the learned flow: made missions within the limits never break them."""

import numpy as np
import pytest

import clpt_control as clpt

WIDTH, NOISE, UNMODELLED, SHEAR = 12e3, 15.0, 0.01, 2e-5
CENTERS = np.array([[0, 0], [10e3, 0], [0, 10e3]], float)
CORNERS = np.array([[10e3, 0], [0, 10e3], [10e3, 10e3], [0, 0]])
A, E2 = 6378137.0, 0.00669437999  # of WGS84


def position(x, y):
    """Latitude and longitude of a point near the origin, to 1e-3."""
    origin = np.radians(36.7)
    flat = 1 - E2 * np.sin(origin) ** 2
    latitude = origin + y * flat**1.5 / (A * (1 - E2))
    longitude = x * flat**0.5 / (A * np.cos((origin + latitude) / 2))
    return float(np.degrees(latitude)), float(np.degrees(longitude) - 122.1)


def learner(law="fix-regression", widths=WIDTH, constituent="steady", **limits):
    scenario = clpt.Scenario(
        origin=(36.7, -122.1),
        units={"length": "km", "time": "h"},
        basis={
            "kernel": "gaussian",
            "centers": (CENTERS / 1e3).tolist(),
            "widths": [widths / 1e3] * 3,
            "constituents": [constituent] * 3,
        },
        learning={"law": law},
        localization={"interval": 1.0, "noise": NOISE / 3e3},
    )
    return clpt.currents.FlowEstimator(scenario, **limits)


def phi(x):
    return np.exp(-np.sum((x - CENTERS) ** 2, axis=1) / (2 * WIDTH**2))


def flown(theta, x, v, unmodelled, T, steps=40):
    """The place after a leg, by Runge and Kutta."""

    def rate(x):
        return theta @ phi(x) + v + unmodelled

    h = T / steps
    for _ in range(steps):
        k1 = rate(x)
        k2 = rate(x + h / 2 * k1)
        k3 = rate(x + h / 2 * k2)
        x = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + rate(x + h * k3))
    return x


def mission(seed, T, legs, estimator, noise=NOISE):
    """Errors and guaranteed errors of the flow at the vehicle; noise and flow at their limits."""
    rng = np.random.default_rng(seed)
    theta = rng.standard_normal((2, 3))
    theta *= 0.5 / np.linalg.norm(theta)
    # the steepest place of a Gaussian is one width from its centre
    theta *= min(1, SHEAR * WIDTH * np.exp(0.5) / np.linalg.norm(theta, axis=0).sum())
    signs, angle = rng.choice([-1, 1], legs + 1), rng.uniform(0, 2 * np.pi)
    along = np.array([np.cos(angle), np.sin(angle)])
    x, goal, rows = np.zeros(2), 0, []

    def fix(t, k):
        return estimator.fix(t, *position(*(x + noise * signs[k] * along)))

    fix(0.0, 0)
    for k in range(legs):
        if np.linalg.norm(CORNERS[goal % 4] - x) < 0.6 * T:
            goal += 1
        way = CORNERS[goal % 4] - x
        v = way / np.linalg.norm(way)
        x = flown(theta, x, v, UNMODELLED * signs[k // 4] * along, T)
        t = (k + 1) * T
        estimator.move(t, *(v * T))
        fix(t, k + 1)
        at = t, *position(*x)
        off = np.array(estimator.flow(*at)) - theta @ phi(x)
        rows.append((np.hypot(*off), estimator.guaranteed(*at)))
    return np.array(rows).T


@pytest.mark.parametrize(("T", "seed"), [(1800.0, 0), (3600.0, 1), (9000.0, 2)])
def test_no_made_mission_breaks_the_bound(T, seed):
    # the plane is the Earth's to 1e-3
    limits = {"shear": SHEAR, "unmodelled": UNMODELLED + 2e-3}
    error, bound = mission(seed, T, 40, learner(**limits))
    assert np.all(error <= bound)
    assert np.all(bound[5:] < 0.2)
    assert bound[-1] < 40 * error.max()


def test_fixes_beyond_the_limits_are_noticed():
    estimator = learner(shear=SHEAR, unmodelled=1e-3)
    _, bound = mission(1, 3600.0, 20, estimator, noise=300.0)
    assert bound[-1] == np.inf
    assert "show that a limit does not hold" in estimator.guarantee
    # far away phi is 0
    assert estimator.guaranteed(0.0, 39.0, -122.1) == np.inf


def test_a_uniform_current_has_a_closed_form():
    """One leg: V <= 1 + (2 n + d T)^2/r^2 - |y|^2/(r^2 + T^2 p^2 S), S the sum of phi^2, 3."""
    T, p, r2 = 3600.0, 0.5, 2 * (NOISE / 3) ** 2 + (0.02 * 3600.0) ** 2
    estimator = learner(widths=1e12, unmodelled=UNMODELLED)
    for k, x in enumerate((0.0, 360.0)):
        estimator.move(k * T, 0.0, 0.0) if k else None
        estimator.fix(k * T, *position(x, 0.0))
    at = T, *position(0.0, 0.0)
    scale = r2 + 3 * p**2 * T**2
    V = 1 + (2 * NOISE + UNMODELLED * T) ** 2 / r2 - 360.0**2 / scale
    variance = 3 * p**2 * r2 / scale  # phi^T P phi after the leg
    # the mean of the guesses is a little off the likeliest
    assert 0.999 < estimator.guaranteed(*at) / np.sqrt(V * variance) < 1.03


def test_a_flow_that_changes_has_no_bound():
    estimator = learner("kalman-flow", shear=SHEAR)
    _, bound = mission(0, 3600.0, 5, estimator)
    assert np.all(bound == np.inf)
    assert "kalman-flow is for a flow that changes" in estimator.guarantee


def test_forgetting_keeps_the_bound():
    limits = {"shear": SHEAR, "unmodelled": UNMODELLED + 2e-3}
    error, bound = mission(3, 3600.0, 30, learner("least-squares", **limits))
    assert np.all(error <= bound)
    assert bound[-1] < 0.2


def test_a_state_that_is_taken_up_again_has_the_same_bound():
    first, second = (learner(shear=SHEAR) for _ in range(2))
    mission(0, 3600.0, 5, first)
    second.state = first.state
    at = 18000.0, 36.71, -122.09
    assert second.guaranteed(*at) == first.guaranteed(*at) < np.inf


@pytest.mark.parametrize("shear", [0.0, -1.0, np.nan, np.inf])
def test_a_shear_that_is_none_is_refused(shear):
    with pytest.raises(clpt.ArgumentError, match="positive and finite"):
        learner(shear=shear)


def test_the_command_prints_it(printed, clpt):
    found = printed("estimate", "--sample", "--shear", "2e-5")
    bounds = [leg["guaranteed_m_s"] for leg in found["legs"]]
    assert 0 < bounds[-1] < 0.1
    assert "shear at most 2e-05/s" in found["guarantee"]
    outcome = clpt("estimate", "--sample", "--shear", "2e-5")
    assert "flow at the last fix: to 0.0" in " ".join(outcome.out.split())
    assert clpt("estimate", "--sample", "--shear", "0").status == 2


def test_a_bound_that_is_none_says_why(printed):
    """Shear x interval too large; a flow of tides is not constant, but its theta is."""
    report = printed("estimate", "--sample", "--shear", "1e-4")
    assert report["legs"][-1]["guaranteed_m_s"] is None
    assert "Shear x interval is 1.1: give a smaller shear" in report["guarantee"]  # 3 h
    assert "if theta is constant" in learner(constituent="M2").guarantee
    assert "if it is constant" in learner().guarantee


@pytest.mark.parametrize("name", ["shear", "unmodelled"])
def test_larger_limits_take_up_no_guarantee(name):
    """A bound under narrow limits says nothing of a sea that only keeps wider ones."""
    narrow, wide = (learner(**{"shear": SHEAR, name: x}) for x in (1e-5, 1e-2))
    at = 18000.0, 36.71, -122.09
    mission(0, 3600.0, 5, narrow)
    wide.state = narrow.state
    assert wide.guaranteed(*at) == np.inf > narrow.guaranteed(*at)
    again = learner(**{"shear": SHEAR, name: 1e-6})
    again.state = narrow.state
    assert again.guaranteed(*at) == narrow.guaranteed(*at)


def test_a_kernel_in_two_forms_is_one():
    """exp(-d^2/s) with s = 2 sigma^2 is the Gaussian: theta, guarantee and forecast."""
    results = []
    for kernel, width in (("gaussian", WIDTH), ("gaussian-sigma", 2 * WIDTH**2)):
        scenario = clpt.Scenario(
            origin=(36.7, -122.1),
            units={"length": "m", "time": "s"},
            basis={
                "kernel": kernel,
                "centers": CENTERS.tolist(),
                "widths": [width] * 3,
                "constituents": ["steady"] * 3,
            },
            learning={"law": "fix-regression"},
            localization={"interval": 3600.0, "noise": NOISE / 3},
        )
        estimator = clpt.currents.FlowEstimator(scenario, shear=SHEAR)
        mission(1, 3600.0, 20, estimator)
        flow = estimator.flow(72000.0, 36.75, -122.05)
        bound = estimator.guaranteed(72000.0, 36.75, -122.05)
        ahead = estimator.forecast([(75600.0, 3600.0, 0.0)]).radius
        results.append([*estimator.flow_parameters.ravel(), *flow, bound, ahead])
    np.testing.assert_allclose(*results, rtol=1e-6)
