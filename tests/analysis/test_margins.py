"""Margins against closed forms where the regressor stands still, and Rohrs' example."""

import control
import numpy as np
import pytest

import clpt_control as clpt
from analysis.margins import KINDS, closed_form, margin
from clpt_control.theory.excitation.regressor import joint_regressor


@pytest.mark.parametrize(
    "kind",
    [next(iter(KINDS)), *(pytest.param(kind, marks=pytest.mark.slow) for kind in [*KINDS][1:])],
)
def test_where_w_is_held_the_margin_is_the_closed_form(kind):
    """A steady flow and one waypoint, where the vehicle stands; 3 % are the bisection's."""
    still = {
        "basis.periods": [float("inf")] * 3,
        "basis.kernel": "gaussian",
        "reference": {"kind": "waypoints", "points": [[3, 2]], "dwell": 20},
        "run.duration": 200,
        "run.output_step": 0.25,
    }
    scenario = clpt.paper_scenario().with_values(still)
    end = clpt.simulate(scenario).position.values[-1]
    scenario = scenario.with_values({"vehicle.position": end})
    along = joint_regressor(clpt.theory.started_true(scenario), 20.0, 20.0)
    g = 0.8 * np.max(np.sum(along.w**2, axis=-1))
    assert margin(scenario, kind) == pytest.approx(closed_form(kind, 1.0, g), rel=0.055)


@pytest.mark.parametrize(("k", "g"), [(1.0, 5.0), (0.4, 2.0), (2.0, 30.0)])
def test_the_closed_forms_are_where_a_pole_crosses(k, g):
    """The poles of the linear loops, a hair below and above."""
    plant = control.tf([g], [1, k, 0])
    h = closed_form("sampler", k, g)
    for share, stable in ((0.98, True), (1.02, False)):
        tau = share * closed_form("lag", k, g)
        poles = control.feedback(plant * control.tf([1], [tau, 1])).poles()
        assert (poles.real.max() < 0) == stable
        late = control.tf(*control.pade(share * closed_form("delay", k, g), 6))
        assert (control.feedback(plant * late).poles().real.max() < 0) == stable
        a, step = np.exp(-k * share * h), share * h
        held = np.array([[a, (1 - a) / k], [-g * step, 1.0]])
        assert (np.abs(np.linalg.eigvals(held)).max() < 1) == stable
    assert closed_form("lag", 2.0, 3.0) == np.inf


def rohrs(w, unmodelled):
    """Rohrs' loop: y_p = 2/(s+1) 229/(s^2+30s+229) u, model 3/(s+3), both gains adapted by 1."""

    def law(t, x, u, p):
        r, y, ym = u[0], u[1], u[2]
        e = y - ym
        return [-e * r, -e * y]

    reference = control.nlsys(
        None, lambda t, x, u, p: [0.3 + 1.85 * np.sin(w * t)], inputs=0, outputs=["r"], name="ref"
    )
    plant = control.tf([2], [1, 1])
    if unmodelled:
        plant = plant * control.tf([229], [1, 30, 229])
    plant = control.ss(plant, inputs=["u"], outputs=["y"], name="plant")
    model = control.ss(control.tf([3], [1, 3]), inputs=["r"], outputs=["ym"], name="model")
    adaptation = control.nlsys(
        law,
        lambda t, x, u, p: [x[0] * u[0] + x[1] * u[1], x[0], x[1]],
        inputs=["r", "y", "ym"],
        outputs=["u", "kr", "ky"],
        states=2,
        name="law",
    )
    loop = control.interconnect(
        [reference, plant, model, adaptation], outputs=["y", "ym", "kr", "ky"], inputs=[]
    )
    start = np.zeros(loop.nstates)
    names = list(loop.state_labels)
    start[[k for k, name in enumerate(names) if "law" in name]] = [1.14, -0.65]
    return clpt.simulate(loop, np.linspace(0, 40, 801), initial_state=start)


def test_rohrs_example_loses_stability_by_the_lag_alone():
    """At the frequency where the unmodelled phase is 180 degrees ky drifts until all is lost."""
    kept = rohrs(16.1, False)
    assert np.all(np.abs(kept.y.values) < 3)
    with pytest.raises(clpt.SimulationError, match=r"the integration stopped at t = 2\d\."):
        rohrs(16.1, True)
