"""Bounds for every start: what they say, and what is not certified."""

import json
import re

import numpy as np
import pytest

import clpt_control as clpt
from clpt_control import certify

PAPER = clpt.paper_scenario().with_values({"run.duration": 400})


def test_of_small_errors_the_bound_is_the_linear_contraction():
    """And that is the certificate of a learner that was started true."""
    found = certify(PAPER, 1e-16)
    exact = clpt.gramian(PAPER.started_true(), 200.0, 200.0).certificate()
    assert (found.V[2] / found.V[1], found.drops[1]) == pytest.approx(
        (exact.contraction, exact.drop), rel=1e-6
    )


def pushed(kind, amplitude, **more):
    """A disturbance."""
    return {"flow.disturbance": {"kind": kind, "amplitude": amplitude, **more}}


def test_what_a_disturbance_may_undo_is_said_of_the_run_alone():
    """A learner that begins true is pushed for good: V ends at most far above the run's."""
    found = certify(
        PAPER.with_values(pushed("constant", [0.02, 0.02])), 1e-6, error=5.0
    )
    assert found.within_run
    assert found.ultimate > 5.0
    assert found.said == "CLPE is at most 5 m after 0 s, within the run"
    assert certify(PAPER, 1e-6, error=5.0).said == "CLPE is at most 5 m after 0 s"


DISTURBED = pushed("square", [0.004, 0.003], period=1.8)


def test_under_a_disturbance_it_ends_at_a_bound_and_says_so():
    found = certify(PAPER.with_values(DISTURBED), 0.05)
    assert found.disturbance == pytest.approx(0.005)
    assert 0 < found.ultimate < np.inf
    lost = certify(PAPER.with_values(pushed("constant", [0.5, 0.0])), 0.05)
    assert lost.ultimate is lost.time_to_error is None
    assert "not shown" in lost.said


NOT_CERTIFIED = [
    ({"learning.law": "sigma"}, "for the learned-flow law in a flow with parameters"),
    ({"localization": {"noise": 0.1, "noise_period": 1.0}}, "localization.noise"),
    ({"learning.sample": 0.5}, "learning.sample"),
    ({"vehicle.max_speed": 1.0, "learning.hedging": False}, "hedging"),
    ({"learning.adapt_gains": False}, "learning.feedback is fixed and differs"),
    (pushed("noise", [1, 1], period=1), "has no bound"),
    ({"reference.radius": 1e20}, "too many to compute"),
]


@pytest.mark.parametrize(("values", "said"), NOT_CERTIFIED, ids=str)
def test_what_is_not_certified_is_said(values, said):
    with pytest.raises(clpt.ScenarioError, match=said):
        certify(PAPER.with_values(values))


ROUNDED = [(0.0123456, 0.050004951), (5.00049, 0.0499996496)]


@pytest.mark.parametrize(("error", "radius"), ROUNDED)
def test_printed_bounds_are_rounded_outward(request, tmp_path, printed, error, radius):
    """A reader of the table takes no bound for smaller than it is, and no start for allowed."""
    clpt.save_scenario(PAPER, tmp_path / "paper.toml")
    words = "excitation", tmp_path / "paper.toml", "--bounds"
    words += "--radius", radius, "--error", error
    found, shown = printed(*words), request.getfixturevalue("clpt")(*words).out
    (said,) = re.findall(r"V\(0\) <= (\S+), windows", shown)
    assert radius * (1 - 1e-4) < float(said) <= radius
    lines = [
        re.findall(r"\d[\d.e-]*", row) for row in shown.splitlines() if row[:1] == "│"
    ]
    rows = [list(map(float, line)) for line in lines]
    exact = [found[name] for name in ("time", "V", "clpe", "flow_error")]
    assert len(rows) == len(found["time"])
    for column, values in zip(np.transpose(rows), exact, strict=True):
        assert np.all((column >= values) & (column <= np.multiply(values, 1 + 2e-5)))
    (never,) = re.findall(r"CLPE is never above (\S+)", shown)
    assert found["clpe"][0] <= float(never) <= found["clpe"][0] * 1.001
    (leaves,) = re.findall(r"leaves (\S+) of V at worst", shown)
    assert 1 - min(found["drops"]) <= float(leaves) <= (1 - min(found["drops"])) * 1.001


def test_the_radius_is_that_of_the_scenarios_own_start():
    found = certify(PAPER)
    assert found.radius == pytest.approx(4.63125)
    assert (
        json.loads(json.dumps(found.report(), allow_nan=False))["V"] == found.V.tolist()
    )


def test_numbers_that_are_none_are_refused():
    for radius, error in ((-1.0, None), (0.0, None), (1.0, 0.0), (np.inf, None)):
        with pytest.raises(
            clpt.ArgumentError, match="must be a number, positive and finite"
        ):
            certify(PAPER, radius, error=error)
    for radius, error in ((1.0, 1e308), (1e308, None)):
        with pytest.raises(clpt.ScenarioError, match=r"must be at most 1e\+12"):
            certify(PAPER, radius, error=error)
