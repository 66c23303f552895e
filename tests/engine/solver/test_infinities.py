"""Conditions that read infinities and NaN: a run ends, with the values of NumPy or an error."""

import control
import numpy as np
import pytest
from refusals import refuses

import clpt_control as clpt


def of_cosine(rate, python=False):
    """Return a system whose first state has a rate of c = cos(2 pi t)."""

    def rates(t, x, u, p):
        c = np.float64(float(str(float(x[1])))) if python else x[1]
        return [rate(c), -2 * np.pi * x[2], 2 * np.pi * x[1]]

    return control.nlsys(rates, None, inputs=0, states=3, outputs=3, name="model")


def run(system, **given):
    return clpt.simulate(system, [0.0, 1.0], None, [0.0, 1.0, 0.0], **given)


def share(c):
    """Return the share of a period in which the cosine is above c."""
    return np.arccos(c) / np.pi


LOGARITHM = share(np.exp(-0.5))  # of a period in which log(c) is above -1/2
FINISHED = {
    "sign": (lambda c: np.sign(1.0 - np.exp(1e6 * c)), 0.0),
    "minus": (lambda c: np.sign(np.exp(1e6 * c) - 2.0), 0.0),
    "where": (
        lambda c: np.where(np.exp(1e4 * c) < 3.0, 1.0, -0.5),
        1.0 - 1.5 * share(np.log(3.0) / 1e4),
    ),
    "maximum": (
        lambda c: np.tanh(np.maximum(np.exp(1e6 * c), 0.3)),
        0.5 + 0.5 * np.tanh(0.3),
    ),
    "two infinities": (
        lambda c: np.where(np.exp(1e4 * c) >= np.exp(2e4 * c), 1.0, -0.5),
        1.0 - 1.5 * (share(0.0) - share(np.log(np.finfo(float).max) / 1e4)),
    ),
    "masked where": (
        lambda c: np.where(c > 0.0, np.where(np.log(c) > -0.5, 1.0, 2.0), 0.0),
        2.0 * share(0.0) - LOGARITHM,
    ),
    "masked sign": (
        lambda c: np.where(c > 0.0, np.sign(np.log(c) + 0.5), 0.0),
        2.0 * LOGARITHM - share(0.0),
    ),
    "masked floor": (
        lambda c: np.where(c > 0.5, np.floor(np.log(c)), 0.0),
        -share(0.5),
    ),
    "masked by and": (
        lambda c: 1.0 if c > 0.0 and np.log(c) > -0.5 else 2.0,
        2.0 - LOGARITHM,
    ),
    "masked by isfinite": (
        lambda c: np.where(np.isfinite(np.log(c)), np.where(c > 0.5, 1.0, 2.0), 0.0),
        2.0 * share(0.0) - share(0.5),
    ),
}


@pytest.mark.parametrize("name", FINISHED)
def test_a_run_beside_infinities_has_the_values_of_numpy(name):
    rate, value = FINISHED[name]
    found = run(of_cosine(rate))
    assert found.attrs["status"] == "finished"
    assert found.states.values[-1, 0] == pytest.approx(value, abs=1e-5)


@pytest.mark.xfail(
    strict=True, reason="a distance of 0 over an interval is no crossing"
)
def test_a_run_beside_underflow_has_the_values_of_numpy():
    found = run(
        of_cosine(lambda c: np.where(np.exp(1e3 * c) > np.exp(2e3 * c), 1.0, 0.0))
    )
    ends = share(-0.745133) - share(0.0)  # exp(-745.133) is half of the least number
    assert found.states.values[-1, 0] == pytest.approx(ends, abs=1e-5)


def unknown(c):
    """NaN where both exponentials overflow, for c below -0.887; 0 - 0 for c above 0.93."""
    return np.exp(-800.0 * c) - 2.0 * np.exp(-801.0 * c)


USES = {
    "sign": lambda c: np.sign(unknown(c)),
    "abs": lambda c: np.tanh(np.abs(unknown(c))),
    "maximum": lambda c: np.tanh(np.maximum(unknown(c), 0.5)),
}


@pytest.mark.filterwarnings("ignore:.* runs in Python")
@pytest.mark.parametrize("python", [False, True])
@pytest.mark.parametrize("use", USES)
def test_nan_behind_a_condition_is_an_error(use, python):
    said = r"stopped at t = 0\.42.*derivative of x\[0\] of block model is not finite"
    refuses(said, run, of_cosine(USES[use], python), error=clpt.SimulationError)


def test_a_comparison_of_nan_is_an_error_where_rates_depend_on_it():
    """In Python it is what NumPy says: no."""
    for compared in (lambda c: np.log(c) > -9.0, lambda c: np.log(c) < 9.0):
        system = of_cosine(lambda c, yes=compared: np.where(yes(c), 1.0, -1.0))
        said = r"`[<>]` in model.update compares a value that is not a number"
        refuses(said, run, system, error=clpt.SimulationError)
        given = {"timepts": [0.0, 1.0], "initial_state": [0.0, 1.0, 0.0]}
        with pytest.warns(UserWarning, match="not a number"):
            data = clpt.run_ensemble(system, {"x[0]": [0.0, 0.5]}, **given)
        assert not (data.status.values == 1).any()


def distance(c):
    return 0.001 + 2 * np.exp(-801.0 * c) - np.exp(-800.0 * c)


@pytest.mark.filterwarnings("ignore:.* runs in Python")
@pytest.mark.parametrize("python", [False, True])
def test_a_guard_of_nan_is_an_error(python):
    system = of_cosine(lambda c: c, python)
    said = r"distance of the guard of stop is not a number at t = 0\.42"
    given = {"stop": lambda t, y, u: distance(y[1]), "error": clpt.SimulationError}
    refuses(said, run, system, **given)
    falling = (
        (lambda x: -1.0 + 0.0 * float(str(float(x)))) if python else (lambda x: -1.0)
    )
    block = clpt.Block(
        "falling",
        update=lambda t, x, u, p: [falling(x[0])],
        states={"h": 1},
        guard=clpt.Guard(lambda t, x, u, p: 2.0 + 0.0 * np.sqrt(x[0]), "stop"),
    )
    said = r"distance of the guard of falling is not a number at t = 1"
    given = {"initial_state": [1.0], "error": clpt.SimulationError}
    refuses(said, clpt.simulate, block, [0.0, 2.0], **given)
