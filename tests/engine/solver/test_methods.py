"""Integration methods are rows of facts: one more is one file and one entry."""

import control
import numpy as np
import pytest
from engine_runs import METHODS, ROWS, Method
from tsit5 import ERROR, LAST, TIMES, A

import clpt_control as clpt

TSIT5 = Method("Tsit5", stages=7, order=5, module="tsit5")
TURNS = np.linspace(0.0, 20.0, 401)
EACH = pytest.mark.parametrize(
    "row", [row for row in ROWS if not row.discrete], ids=lambda row: row.name
)


def oscillator():
    """x'' = -x with a rate that depends on time: x = cos t, and y = t^2 / 2."""
    return control.nlsys(
        lambda t, x, u, p: [x[1], -x[0], t], inputs=0, outputs=3, states=3, name="turn"
    )


@pytest.fixture
def tsit5(monkeypatch):
    monkeypatch.setitem(METHODS, "tsit5", TSIT5)


def test_the_tableau_of_the_added_method_has_its_order():
    for row, c in zip(A, TIMES, strict=True):
        assert sum(row) == pytest.approx(c, abs=1e-14)
    b, c = np.append(A[6], 0.0), np.array(TIMES)
    for power in range(5):  # sum b c^k = 1/(k + 1)
        assert b @ c**power == pytest.approx(1 / (power + 1), abs=1e-14)
    assert sum(ERROR) == pytest.approx(0.0, abs=1e-14)
    assert sum(LAST) == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize("rtol", [1e-5, 1e-8])
def test_an_added_method_runs_by_its_name(tsit5, rtol):
    run = clpt.simulate(
        oscillator(), TURNS, None, [1.0, 0.0, 0.0], method="tsit5", rtol=rtol, atol=rtol
    )
    assert run.attrs["method"] == "Tsit5"
    x = run.states.values
    assert np.abs(x[:, 0] - np.cos(TURNS)).max() < 100 * rtol
    assert np.abs(x[:, 2] - TURNS**2 / 2).max() < 100 * rtol


def test_a_method_that_is_no_row_is_refused():
    with pytest.raises(
        clpt.SimulationError, match="must be one of auto, dop853, rodas5p"
    ):
        clpt.simulate(oscillator(), TURNS, None, [1.0, 0.0, 0.0], method="tsit5")


def order_of(method, steps):
    """Return the order of convergence of the end of a run with steps of one length at most."""
    errors = []
    for step in steps:
        run = clpt.simulate(
            oscillator(), [0.0, 4.0], None, [1.0, 0.0, 0.0],
            method=method, rtol=1.0, atol=1e3, max_step=step, first_step=step,
        )  # fmt: skip
        errors.append(np.abs(run.states.values[-1, 0] - np.cos(4.0)))
    return np.log(errors[0] / errors[1]) / np.log(steps[0] / steps[1])


@EACH
def test_errors_fall_at_least_with_the_order_of_the_row(row):
    steps = (0.5, 0.25) if row.order == 8 else (0.1, 0.05)
    assert order_of(row.name.lower(), steps) > row.order - 0.6


def test_errors_of_the_added_method_fall_with_its_order(tsit5):
    assert order_of("tsit5", (0.1, 0.05)) == pytest.approx(5, abs=0.6)


@EACH
def test_a_row_runs_in_python_too(row):
    scenario = clpt.paper_scenario().with_values(
        {"run.duration": 20.0, "run.method": row.name.lower()}
    )
    compiled, run = (clpt.simulate(scenario, engine=e) for e in ("native", "python"))
    assert compiled.attrs["method"] == run.attrs["method"] == row.name
    assert np.abs(run.states - compiled.states).max() < 1e-5
